/* Loads the models that group an asset's nodes. */
#include "assets/asset_models.h"

#include "assets/set_ratings.h"

#define PAIR_TREES 300
#define SET_TREES 800
#define CONTEXT_TREES 300
#define BLOCK_SIZE ((size_t)1 << 20)

static const char* const round_names[DMI_CONTEXT_ROUNDS] = {"context", "context_again"};

static void read_models(dmi_loader* loader, void* network) {
    dmi_asset_models* models = network;
    dmi_load_tree_ensemble(loader, "pairs", PAIR_TREES, DMI_PAIR_FEATURES, &models->pairs);
    dmi_load_tree_ensemble(loader, "sets", SET_TREES, DMI_SET_FEATURES, &models->sets);
    for (int round = 0; round < DMI_CONTEXT_ROUNDS; round++)
        dmi_load_tree_ensemble(loader, round_names[round], CONTEXT_TREES, DMI_SET_FEATURES + DMI_CONTEXT_FEATURES,
                               &models->context[round]);
}

dm_result dmi_asset_models_load(dmi_env* env, const void* data, size_t size, dmi_asset_models* out) {
    dmi_arena_init(&out->arena, env, BLOCK_SIZE);
    return dmi_load_network(env, data, size, DMI_ASSET_ARCHITECTURE, read_models, out, &out->arena);
}

void dmi_asset_models_release(dmi_asset_models* models) {
    dmi_arena_release(&models->arena);
}
