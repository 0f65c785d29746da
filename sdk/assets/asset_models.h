/* The models that group an asset's nodes: ensembles of trees in one file (sdk/models/asset_parts.safetensors). */
#ifndef DMI_ASSETS_ASSET_MODELS_H
#define DMI_ASSETS_ASSET_MODELS_H

#include <stddef.h>

#include "math/elementary.h"
#include "nn/layers.h"

/* ---- gradient-boosted regression trees over rows of measured numbers ---- */

#define DMI_ENSEMBLE_NODES 63 /* nodes of a tree: at most 32 leaves */

/* A split goes to the node `left` where the column is at most `value`, else to the node after it. A leaf is its own
 * left child and has an infinite value. */
typedef struct dmi_ensemble_node {
    float value, score; /* score: the score of a leaf; no split has one */
    uint8_t column, left;
} dmi_ensemble_node;

/* The scores of the leaves that a row reaches add up to log odds. */
typedef struct dmi_tree_ensemble {
    const dmi_ensemble_node* nodes; /* tree_count x DMI_ENSEMBLE_NODES */
    uint32_t tree_count, columns;
} dmi_tree_ensemble;

/* Returns the sum of the scores of the leaves that the row reaches. */
float dmi_tree_ensemble_score(const dmi_tree_ensemble* ensemble, const float* row);

/* ---- the models ---- */

#define DMI_ASSET_ARCHITECTURE "dragmesh-asset-parts" /* name in the weights file */
#define DMI_CONTEXT_ROUNDS 2                          /* times that sets are rated in view of each other; by hand */

typedef struct dmi_asset_models {
    dmi_arena arena;
    dmi_tree_ensemble pairs; /* DMI_PAIR_FEATURES -> both nodes are of one body */
    dmi_tree_ensemble sets;  /* DMI_SET_FEATURES -> the set is a body that moves */
    /* those and DMI_CONTEXT_FEATURES -> the same, in view of how the asset's other sets were rated in the round before
     */
    dmi_tree_ensemble context[DMI_CONTEXT_ROUNDS];
    dmi_tree_ensemble carriers; /* DMI_CARRIER_FEATURES -> a body hangs on another; shares of all that may carry it */
} dmi_asset_models;

/* Loads the models from a file. Release with dmi_asset_models_release. */
dm_result dmi_asset_models_load(dmi_env* env, const void* data, size_t size, dmi_asset_models* out);
void dmi_asset_models_release(dmi_asset_models* models);

/* Returns the probability of a row by an ensemble whose scores are log odds. */
static inline float dmi_probability(const dmi_tree_ensemble* ensemble, const float* row) {
    return 1 / (1 + dmi_expf(-dmi_tree_ensemble_score(ensemble, row)));
}

extern const unsigned char dmi_asset_weights[]; /* 64-byte aligned */
extern const size_t dmi_asset_weights_size;     /* bytes */

#endif
