/* Gradient-boosted regression trees that score a candidate by its features. Each tree was fitted to the errors of the
 * trees before it. The score is the sum of their leaves. */
#ifndef DMI_RANKING_BOOSTED_TREES_H
#define DMI_RANKING_BOOSTED_TREES_H

#include "kinematics/features/feature_table.h"
#include "nn/layers.h"

#define DMI_TREES 500
#define DMI_DRAG_TREES 100 /* trees at the end, which correct the scores of parts that are dragged */
#define DMI_TREE_NODES 255 /* most nodes of a tree, which has 128 leaves at most */

/* A split goes to the node `left` where the column is at most `value`, else to the node after `left`. A leaf is its own
 * left child and has an infinite value, so that a walk stays in it. */
typedef struct dmi_tree_node {
    float value;
    uint8_t column, left;
} dmi_tree_node;

typedef struct dmi_boosted_trees {
    dmi_tree_node nodes[DMI_TREES][DMI_TREE_NODES];
    float scores[DMI_TREES][DMI_TREE_NODES]; /* scores of the leaves */
    uint32_t depth[DMI_TREES];               /* splits on the longest way down */
} dmi_boosted_trees;

/* Reads the tensors trees.column and trees.value. Answers DM_ERROR_WRONG_MODEL when they are no trees. */
void dmi_boosted_trees_read(dmi_loader* loader, dmi_boosted_trees* out_trees);

/* Scores rows of features. All rows have a drag (DMI_FEATURE_HAS_DRAG), or none has. */
void dmi_boosted_trees_score(const dmi_boosted_trees* trees, const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                             float* out_scores);

#endif
