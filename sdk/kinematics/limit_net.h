/* A small network that names a joint's limits from what a sweep and the part's shape tell. Trained on generated
 * objects; its weights lie in the ranker's file. */
#ifndef DMI_KINEMATICS_LIMIT_NET_H
#define DMI_KINEMATICS_LIMIT_NET_H

#include "nn/weights.h"

#define DMI_LIMIT_FEATURES 37
#define DMI_LIMIT_HIDDEN 96

typedef struct dmi_limit_net {
    float mean[DMI_LIMIT_FEATURES], scale[DMI_LIMIT_FEATURES];
    float first[DMI_LIMIT_HIDDEN * DMI_LIMIT_FEATURES], first_bias[DMI_LIMIT_HIDDEN]; /* rows of outputs */
    float second[DMI_LIMIT_HIDDEN * DMI_LIMIT_HIDDEN], second_bias[DMI_LIMIT_HIDDEN];
    float last[3 * DMI_LIMIT_HIDDEN], last_bias[3];
} dmi_limit_net;

/* 0 when a tensor is missing or of another shape. */
int dmi_limit_net_read(const dmi_weights* weights, dmi_limit_net* out_net);

/* lower <= 0 <= upper in the features' unit, at least a hundredth apart; free > 0: nothing stops it. */
void dmi_limit_net_forward(const dmi_limit_net* net, const float features[DMI_LIMIT_FEATURES], float* out_lower,
                           float* out_upper, float* out_free);

#endif
