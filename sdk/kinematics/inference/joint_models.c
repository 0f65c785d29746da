/* Loads the models fitted on candidate joints. */
#include "kinematics/inference/joint_models.h"

#define ARCHITECTURE "dragmesh-ranker"
#define VERSION 8 /* of the file; earlier limit networks do not take candidate features */

static dm_result read_models(const dmi_weights* weights, dmi_joint_models* models) {
    dmi_env* env = models->env;
    dm_result result = dmi_ranker_read(env, weights, &models->ranker);
    if (result != DM_OK) return result;
    if (dmi_limit_network_read(weights, &models->limits) && dmi_prefilter_read(weights, &models->prefilter))
        return DM_OK;
    return dmi_fail(env, DM_ERROR_WRONG_MODEL,
                    "ranker: a tensor is missing or of another shape (as in files before version %d)", VERSION);
}

dm_result dmi_joint_models_load(dmi_env* env, const void* data, size_t size, dmi_joint_models** out_models) {
    dmi_weights* weights;
    dm_result result = dmi_weights_open(env, data, size, ARCHITECTURE, VERSION, &weights);
    if (result != DM_OK) return result;
    dmi_joint_models* models = dmi_alloc(env, sizeof *models, _Alignof(dmi_joint_models));
    if (models == NULL) {
        result = dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "ranker: no memory for its %zu bytes", sizeof *models);
    } else {
        models->env = env;
        result = read_models(weights, models);
    }
    dmi_weights_close(weights);
    if (result != DM_OK)
        dmi_joint_models_destroy(models);
    else
        *out_models = models;
    return result;
}

void dmi_joint_models_destroy(dmi_joint_models* models) {
    if (models != NULL) dmi_free(models->env, models, sizeof *models);
}
