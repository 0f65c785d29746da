/* Loads the models fitted on candidate joints. */
#include "kinematics/inference/joint_models.h"

#define ARENA_BLOCK ((size_t)256 * 1024)

static void read_models(dmi_loader* loader, void* network) {
    dmi_joint_models* models = network;
    dmi_prefilter_read(loader, &models->prefilter);
    dmi_ranker_read(loader, &models->ranker);
    dmi_limit_network_read(loader, &models->limits);
}

dm_result dmi_joint_models_load(dmi_env* env, const void* data, size_t size, dmi_joint_models** out_models) {
    dmi_joint_models* models = dmi_alloc_zeroed(env, sizeof *models, _Alignof(dmi_joint_models));
    if (models == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "joint models: no memory for %zu bytes", sizeof *models);
    models->env = env;
    dmi_arena_init(&models->arena, env, ARENA_BLOCK);
    const dm_result result =
        dmi_load_network(env, data, size, "dragmesh-joint-models", read_models, models, &models->arena);
    if (result != DM_OK)
        dmi_free(env, models, sizeof *models);
    else
        *out_models = models;
    return result;
}

void dmi_joint_models_destroy(dmi_joint_models* models) {
    if (models == NULL) return;
    dmi_env* env = models->env;
    dmi_arena_release(&models->arena);
    dmi_free(env, models, sizeof *models);
}
