/* A small multilayer perceptron: one hidden layer of rectified linear units, one output. */
#ifndef DMI_SEGMENTATION_PART_NET_H
#define DMI_SEGMENTATION_PART_NET_H

#include <stdint.h>

typedef struct dmi_part_net {
    uint32_t inputs, hidden;
    const float *weights, *biases, *outputs; /* [hidden][inputs], [hidden], [hidden] */
    float bias;
} dmi_part_net;

/* Returns the output (log odds or an unnormalised score) for net->inputs features. */
float dmi_part_net_run(const dmi_part_net* net, const float* features);

#endif
