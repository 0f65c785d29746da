/* Small networks that name a joint's limits from what a sweep and the part's shape tell, and from the evidence that
 * the joint was ranked by: it says what kind of thing this is. Trained on generated objects; its weights lie in the
 * ranker's file. */
#ifndef DMI_LIMITS_LIMIT_NETWORK_H
#define DMI_LIMITS_LIMIT_NETWORK_H

#include "kinematics/features/candidate_features.h"
#include "nn/weights.h"

#define DMI_LIMIT_FEATURES 37                                     /* of a sweep: see limits.h */
#define DMI_LIMIT_INPUTS (DMI_LIMIT_FEATURES + DMI_FEATURE_COUNT) /* the joint's evidence after them */
#define DMI_LIMIT_HIDDEN 160
#define DMI_LIMIT_SIZES 25  /* that either side of a range can have */
#define DMI_LIMIT_KINDS 8   /* of ranges, of which a joint's is one: the components of a mixture */
#define DMI_LIMIT_MEMBERS 3 /* networks fitted alike but for chance: their mean errs less */
#define DMI_LIMIT_OUTPUTS (1 + DMI_LIMIT_KINDS * (1 + 2 * DMI_LIMIT_SIZES))

/* A row of outputs for each input. */
typedef struct dmi_limit_member {
    float first[DMI_LIMIT_INPUTS * DMI_LIMIT_HIDDEN], first_bias[DMI_LIMIT_HIDDEN];
    float second[DMI_LIMIT_HIDDEN * DMI_LIMIT_HIDDEN], second_bias[DMI_LIMIT_HIDDEN];
    float last[DMI_LIMIT_HIDDEN * DMI_LIMIT_OUTPUTS], last_bias[DMI_LIMIT_OUTPUTS];
} dmi_limit_member;

typedef struct dmi_limit_network {
    float mean[DMI_LIMIT_INPUTS], scale[DMI_LIMIT_INPUTS];
    float sizes[DMI_LIMIT_SIZES]; /* rising from 0 */
    dmi_limit_member voices[DMI_LIMIT_MEMBERS];
} dmi_limit_network;

/* 0 when a tensor is missing or of another shape, or the sizes don't rise from 0. */
int dmi_limit_network_read(const dmi_weights* weights, dmi_limit_network* out_net);

#define DMI_LIMIT_ROWS DM_MAX_HYPOTHESES /* joints at a time: they share the way of the weights through the caches */

typedef struct dmi_limit_query {
    float features[DMI_LIMIT_FEATURES];
    const float* evidence; /* DMI_FEATURE_COUNT numbers; NULL where it is unknown */
} dmi_limit_query;

/* In the features' unit. */
typedef struct dmi_limit_prediction {
    float lower, upper; /* lower <= 0 <= upper, at least a hundredth apart */
    float free;         /* > 0: nothing stops it */
} dmi_limit_prediction;

/* count: at most DMI_LIMIT_ROWS. */
void dmi_limit_network_predict(const dmi_limit_network* net, const dmi_limit_query* questions, uint32_t count,
                               dmi_limit_prediction* out);

#endif
