/* Gradient-boosted regression trees over rows of measured numbers. The scores of the leaves that a row reaches add up
 * to log odds. */
#ifndef DMI_NN_TREE_ENSEMBLE_H
#define DMI_NN_TREE_ENSEMBLE_H

#include "nn/layers.h"

#define DMI_ENSEMBLE_NODES 63 /* nodes of a tree: at most 32 leaves */

/* A split goes to the node `left` where the column is at most `value`, else to the node after it. A leaf is its own
 * left child and has an infinite value. */
typedef struct dmi_ensemble_node {
    float value, score; /* score: the score of a leaf; no split has one */
    uint8_t column, left;
} dmi_ensemble_node;

typedef struct dmi_tree_ensemble {
    const dmi_ensemble_node* nodes; /* tree_count x DMI_ENSEMBLE_NODES */
    uint32_t tree_count, columns;
} dmi_tree_ensemble;

/* Reads the tensors `name`.column and `name`.value of `tree_count` trees over rows of `columns` numbers (255 at most).
 * The loader fails with DM_ERROR_WRONG_MODEL when they are no trees. */
void dmi_load_tree_ensemble(dmi_loader* loader, const char* name, uint32_t tree_count, uint32_t columns,
                            dmi_tree_ensemble* out);

/* Returns the sum of the scores of the leaves that the row reaches. */
float dmi_tree_ensemble_score(const dmi_tree_ensemble* ensemble, const float* row);

#endif
