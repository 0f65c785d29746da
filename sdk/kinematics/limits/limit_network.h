/* Small networks that predict a joint's limits from its sweep, the part's shape and the candidate features that the
 * joint was ranked by. Fitted on generated objects. */
#ifndef DMI_LIMITS_LIMIT_NETWORK_H
#define DMI_LIMITS_LIMIT_NETWORK_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"
#include "kinematics/features/feature_table.h"
#include "nn/layers.h"

#define DMI_LIMIT_FEATURES 37                                     /* features of a sweep, see limits.h */
#define DMI_LIMIT_INPUTS (DMI_LIMIT_FEATURES + DMI_FEATURE_COUNT) /* the joint's candidate features come after them */
#define DMI_LIMIT_SIZES 25                                        /* sizes that either side of a range can have */
#define DMI_LIMIT_KINDS 8                                         /* components of the mixture of ranges */
/* Members of the ensemble; networks that differ by chance alone err less together (measured). */
#define DMI_LIMIT_MEMBERS 3

typedef struct dmi_limit_network {
    float mean[DMI_LIMIT_INPUTS], scale[DMI_LIMIT_INPUTS];
    float sizes[DMI_LIMIT_SIZES]; /* rising from 0 */
    dmi_perceptron members[DMI_LIMIT_MEMBERS];
} dmi_limit_network;

/* Reads the networks. Answers DM_ERROR_WRONG_MODEL when the sizes do not rise from 0. */
void dmi_limit_network_read(dmi_loader* loader, dmi_limit_network* out_network);

#define DMI_LIMIT_ROWS DM_MAX_HYPOTHESES /* joints at a time, which share the weights in the caches */

typedef struct dmi_limit_query {
    const float* candidate; /* its candidate features, DMI_FEATURE_COUNT; NULL: unknown */
    float features[DMI_LIMIT_FEATURES];
    bool dragged; /* a drag has told to which side it opens */
} dmi_limit_query;

/* Predicted limits, in the features' unit. */
typedef struct dmi_limit_prediction {
    float lower, upper; /* lower <= 0 <= upper, at least a hundredth apart */
    float free;         /* the joint is free when above 0: nothing stops it */
} dmi_limit_prediction;

/* Predicts the limits of `count` joints, at most DMI_LIMIT_ROWS. */
void dmi_limit_network_predict(const dmi_limit_network* network, dmi_isa isa, const dmi_limit_query* queries,
                               uint32_t count, dmi_limit_prediction* out);

#endif
