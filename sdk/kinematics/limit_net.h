/* A small network that names a joint's limits from what a sweep and the part's shape tell. Trained on generated
 * objects; its weights lie in the ranker's file. */
#ifndef DMI_KINEMATICS_LIMIT_NET_H
#define DMI_KINEMATICS_LIMIT_NET_H

#include "nn/weights.h"

#define DMI_LIMIT_FEATURES 37
#define DMI_LIMIT_HIDDEN 160
#define DMI_LIMIT_SIZES 25 /* that either side of a range can have */
#define DMI_LIMIT_KINDS 8  /* of ranges, of which a joint's is one: the components of a mixture */
#define DMI_LIMIT_OUTPUTS (1 + DMI_LIMIT_KINDS * (1 + 2 * DMI_LIMIT_SIZES))

typedef struct dmi_limit_net {
    float mean[DMI_LIMIT_FEATURES], scale[DMI_LIMIT_FEATURES];
    float sizes[DMI_LIMIT_SIZES]; /* rising from 0 */
    /* A row of outputs for each input. */
    float first[DMI_LIMIT_FEATURES * DMI_LIMIT_HIDDEN], first_bias[DMI_LIMIT_HIDDEN];
    float second[DMI_LIMIT_HIDDEN * DMI_LIMIT_HIDDEN], second_bias[DMI_LIMIT_HIDDEN];
    float last[DMI_LIMIT_HIDDEN * DMI_LIMIT_OUTPUTS], last_bias[DMI_LIMIT_OUTPUTS];
} dmi_limit_net;

/* 0 when a tensor is missing or of another shape, or the sizes don't rise from 0. */
int dmi_limit_net_read(const dmi_weights* weights, dmi_limit_net* out_net);

/* lower <= 0 <= upper in the features' unit, at least a hundredth apart; free > 0: nothing stops it. */
void dmi_limit_net_forward(const dmi_limit_net* net, const float features[DMI_LIMIT_FEATURES], float* out_lower,
                           float* out_upper, float* out_free);

#endif
