/* Model handles: the weights of the networks. */
#include "api_model.h"
#include "api_check.h"
#include "api_handles.h"
#include "base/fp_environment.h"

static dm_result check_bytes(dmi_env* env, const char* what, const void* data, size_t size) {
    if ((data == NULL) == (size == 0)) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_model_load: %s has %s", what,
                    data != NULL ? "a pointer but no size" : "a size but no pointer");
}

static dm_result load_networks(dmi_env* env, const dm_model_desc* desc, dmi_model_slot* slot) {
    if (desc->kinematics != NULL) {
        dm_result result = dmi_kpp_net_load(env, desc->kinematics, desc->kinematics_size, &slot->kinematics);
        if (result != DM_OK) return result;
    }
    if (desc->motion != NULL) {
        dm_result result = dmi_dq_vae_load(env, desc->motion, desc->motion_size, &slot->motion);
        if (result != DM_OK) return result;
    }
    return desc->ranker != NULL ? dmi_joint_models_load(env, desc->ranker, desc->ranker_size, &slot->joints) : DM_OK;
}

dm_result DM_CALL dm_model_load(dm_context* context, const dm_model_desc* desc, dm_model* out_model) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_model_desc known;
    dm_result result = dmi_read_desc(env, "dm_model_load: desc", desc, DMI_FIRST_SIZE(dm_model_desc, ranker_size),
                                     sizeof known, &known);
    if (result == DM_OK) result = check_bytes(env, "desc.kinematics", known.kinematics, known.kinematics_size);
    if (result == DM_OK) result = check_bytes(env, "desc.motion", known.motion, known.motion_size);
    if (result == DM_OK) result = check_bytes(env, "desc.ranker", known.ranker, known.ranker_size);
    if (result != DM_OK) return result;
    if (known.kinematics == NULL && known.motion == NULL && known.ranker == NULL) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_model_load: desc names no weights at all");
    }
    if (out_model == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_model_load: out_model is NULL");
    dmi_model_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_model_slot));
    if (slot == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_model_load: no memory");
    result = load_networks(env, &known, slot);
    if (result == DM_OK) result = dmi_pool_insert(context->models, slot, out_model);
    if (result != DM_OK) dmi_model_release(context, slot);
    return result;
}

dmi_inference_models dmi_inference_models_of(const dm_context* context, const dmi_model_slot* model) {
    return (dmi_inference_models){.kpp = model != NULL ? model->kinematics : NULL,
                                  .joints = model != NULL ? model->joints : NULL,
                                  .isa = context->isa};
}

void dmi_model_release(dm_context* context, dmi_model_slot* slot) {
    if (slot->kinematics != NULL) dmi_kpp_net_destroy(slot->kinematics);
    if (slot->motion != NULL) dmi_dq_vae_destroy(slot->motion);
    if (slot->joints != NULL) dmi_joint_models_destroy(slot->joints);
    dmi_free(&context->env, slot, sizeof *slot);
}

dm_result DM_CALL dm_model_unload(dm_context* context, dm_model model) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_model_slot* slot = dmi_take(context, context->models, "dm_model_unload", model);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_model_release(context, slot);
    return DM_OK;
}
