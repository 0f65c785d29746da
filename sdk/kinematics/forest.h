/* Regression trees that score a candidate by its evidence. They were grown one after the other, each on what those
 * before it left wrong (gradient boosting), and their leaves add up. */
#ifndef DMI_KINEMATICS_FOREST_H
#define DMI_KINEMATICS_FOREST_H

#include "kinematics/evidence.h"
#include "nn/weights.h"

#define DMI_FOREST_TREES 400
#define DMI_FOREST_NODES 255 /* of a tree: at most 128 leaves */

/* A fork goes to the node `left` where the column is at most `value`, else to the one after; a leaf is its own left, by
 * a value that nothing exceeds. */
typedef struct dmi_forest_node {
    float value;
    uint8_t column, left;
} dmi_forest_node;

typedef struct dmi_forest {
    dmi_forest_node nodes[DMI_FOREST_TREES][DMI_FOREST_NODES];
    float scores[DMI_FOREST_TREES][DMI_FOREST_NODES]; /* of leaves */
    uint32_t depth[DMI_FOREST_TREES];                 /* forks on the longest way down */
} dmi_forest;

/* DM_ERROR_WRONG_MODEL when a tensor is missing, of another shape, or holds what is no tree. */
dm_result dmi_forest_read(dmi_env* env, const dmi_weights* weights, dmi_forest* out_forest);

void dmi_forest_score(const dmi_forest* forest, const float (*evidence)[DMI_EVIDENCE_COUNT], uint32_t count,
                      float* out_scores);

#endif
