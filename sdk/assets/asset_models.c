/* Loads the models that group an asset's nodes, and walks a row down each tree of one. */
#include "assets/asset_models.h"

#include <math.h>

#include "assets/carrier_features.h"
#include "assets/merge_tree.h"

#define PAIR_TREES 300
#define SET_TREES 800
#define CONTEXT_TREES 300
#define CARRIER_TREES 100
#define BLOCK_SIZE ((size_t)1 << 20)

/* ---- trees ---- */

/* Reads and checks a tree; returns whether the nodes form one. They lie level by level: the two children of a split
 * come after those of the splits before it, so every path ends in a leaf. */
static bool read_tree(const float* column, const float* value, uint32_t columns, dmi_ensemble_node* nodes) {
    uint32_t left = 1;
    for (uint32_t n = 0; n < DMI_ENSEMBLE_NODES; n++) {
        if (!isfinite(value[n])) return false;
        if (column[n] == -1) {
            nodes[n] = (dmi_ensemble_node){.value = INFINITY, .score = value[n], .left = (uint8_t)n};
            continue;
        }
        if (!(column[n] >= 0 && column[n] < (float)columns && column[n] == floorf(column[n]))) return false;
        if (left <= n || left >= DMI_ENSEMBLE_NODES - 1) return false;
        nodes[n] = (dmi_ensemble_node){.value = value[n], .column = (uint8_t)column[n], .left = (uint8_t)left};
        left += 2;
    }
    return true;
}

/* Reads the tensors `name`.column and `name`.value of `tree_count` trees over rows of `columns` numbers (255 at most).
 * The loader fails with DM_ERROR_WRONG_MODEL when they are no trees. */
static void load_tree_ensemble(dmi_loader* loader, const char* name, uint32_t tree_count, uint32_t columns,
                               dmi_tree_ensemble* out) {
    const float* column = dmi_load_part(loader, name, ".column", tree_count, DMI_ENSEMBLE_NODES);
    const float* value = dmi_load_part(loader, name, ".value", tree_count, DMI_ENSEMBLE_NODES);
    const size_t count = (size_t)tree_count * DMI_ENSEMBLE_NODES;
    dmi_ensemble_node* nodes = (void*)dmi_load_alloc(loader, count * sizeof *nodes / sizeof(float));
    for (uint32_t t = 0; loader->result == DM_OK && t < tree_count; t++) {
        const size_t first = (size_t)t * DMI_ENSEMBLE_NODES;
        if (!read_tree(column + first, value + first, columns, nodes + first))
            loader->result = dmi_fail(loader->env, DM_ERROR_WRONG_MODEL, "%s: tree %u is none", name, t);
    }
    *out = (dmi_tree_ensemble){nodes, tree_count, columns};
}

float dmi_tree_ensemble_score(const dmi_tree_ensemble* ensemble, const float* row) {
    float sum = 0;
    for (uint32_t t = 0; t < ensemble->tree_count; t++) {
        const dmi_ensemble_node* nodes = ensemble->nodes + (size_t)t * DMI_ENSEMBLE_NODES;
        uint32_t at = 0;
        while (nodes[at].left != at) at = nodes[at].left + (uint32_t)(row[nodes[at].column] > nodes[at].value);
        sum += nodes[at].score;
    }
    return sum;
}

/* ---- the models ---- */

static const char* const round_names[DMI_CONTEXT_ROUNDS] = {"context", "context_again"};

static void read_models(dmi_loader* loader, void* network) {
    dmi_asset_models* models = network;
    load_tree_ensemble(loader, "pairs", PAIR_TREES, DMI_PAIR_FEATURES, &models->pairs);
    load_tree_ensemble(loader, "sets", SET_TREES, DMI_SET_FEATURES, &models->sets);
    for (int round = 0; round < DMI_CONTEXT_ROUNDS; round++)
        load_tree_ensemble(loader, round_names[round], CONTEXT_TREES, DMI_SET_FEATURES + DMI_CONTEXT_FEATURES,
                           &models->context[round]);
    load_tree_ensemble(loader, "carriers", CARRIER_TREES, DMI_CARRIER_FEATURES, &models->carriers);
}

dm_result dmi_asset_models_load(dmi_env* env, const void* data, size_t size, dmi_asset_models* out) {
    dmi_arena_init(&out->arena, env, BLOCK_SIZE);
    return dmi_load_network(env, data, size, DMI_ASSET_ARCHITECTURE, read_models, out, &out->arena);
}

void dmi_asset_models_release(dmi_asset_models* models) {
    dmi_arena_release(&models->arena);
}
