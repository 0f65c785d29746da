/* Scores candidate joints by their features: a small network and boosted trees fitted on generated objects, or rules
 * set by hand without them. */
#ifndef DMI_RANKING_RANKER_H
#define DMI_RANKING_RANKER_H

#include "kinematics/features/feature_table.h"
#include "nn/layers.h"
#include "nn/perceptron.h"

/* ---- boosted_trees.c ---- */

#define DMI_TREES 500
#define DMI_DRAG_TREES 100 /* trees at the end, which correct the scores of parts that are dragged */
#define DMI_TREE_NODES 255 /* most nodes of a tree, which has 128 leaves at most */

/* A split goes to the node `left` where the column is at most `value`, else to the node after `left`. A leaf is its own
 * left child and has an infinite value, so that a walk stays in it. */
typedef struct dmi_tree_node {
    float value;
    uint8_t column, left;
} dmi_tree_node;

/* Gradient-boosted regression trees that score a candidate by its features. Each tree was fitted to the errors of the
 * trees before it. The score is the sum of their leaves. */
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

/* ---- ranker.c ---- */

/* The score is the mean of two: that of the network and that of the trees. The softmax over a part's candidates is a
 * probability. */
typedef struct dmi_ranker {
    dmi_perceptron network;  /* features -> 64 -> 64 -> 1 */
    float calibration[2][2]; /* slope and offset between log odds, first without a drag and then with one */
    dmi_boosted_trees trees;
} dmi_ranker;

/* Reads the ranker. Answers DM_ERROR_WRONG_MODEL when what the file holds are no trees, or the calibration does not
 * rise. */
void dmi_ranker_read(dmi_loader* loader, dmi_ranker* out_ranker);

/* Computes the probabilities of the candidates, which sum to 1. ranker: NULL scores by rules. count: at most
 * DMI_CANDIDATES_MAX. */
void dmi_ranker_probabilities(const dmi_ranker* ranker, dmi_isa isa, const float (*features)[DMI_FEATURE_COUNT],
                              uint32_t count, float* out_probability);
/* Computes the same as if there were no KPP-Net. */
void dmi_ranker_geometry_probabilities(const dmi_ranker* ranker, dmi_isa isa,
                                       const float (*features)[DMI_FEATURE_COUNT], uint32_t count,
                                       float* out_probability);
/* Returns the probability that an answer is right whose candidates gather the probability `mass`. Without a ranker
 * (NULL) it is `mass`. */
float dmi_ranker_confidence(const dmi_ranker* ranker, int dragged, float mass);

#endif
