/* Regression trees that score a candidate by its evidence. They were grown one after the other, each on what those
 * before it left wrong (gradient boosting), and their leaves add up. */
#ifndef DMI_RANKING_BOOSTED_TREES_H
#define DMI_RANKING_BOOSTED_TREES_H

#include "kinematics/features/candidate_features.h"
#include "nn/weights.h"

#define DMI_TREES 400
#define DMI_TREE_NODES 255 /* of a tree: at most 128 leaves */

/* A fork goes to the node `left` where the column is at most `value`, else to the one after; a leaf is its own left, by
 * a value that nothing exceeds. */
typedef struct dmi_tree_node {
    float value;
    uint8_t column, left;
} dmi_tree_node;

typedef struct dmi_boosted_trees {
    dmi_tree_node nodes[DMI_TREES][DMI_TREE_NODES];
    float scores[DMI_TREES][DMI_TREE_NODES]; /* of leaves */
    uint32_t depth[DMI_TREES];               /* forks on the longest way down */
} dmi_boosted_trees;

/* DM_ERROR_WRONG_MODEL when a tensor is missing, of another shape, or holds what is no tree. */
dm_result dmi_boosted_trees_read(dmi_env* env, const dmi_weights* weights, dmi_boosted_trees* out_forest);

void dmi_boosted_trees_score(const dmi_boosted_trees* forest, const float (*evidence)[DMI_FEATURE_COUNT],
                             uint32_t count, float* out_scores);

#endif
