/* Saving and loading of prepared objects (.dmo). */
#include "api_check.h"
#include "api_handles.h"
#include "api_object.h"
#include "base/fp_environment.h"
#include "kinematics/object/dmo_format.h"
#include "kinematics/object/object.h"

static dm_result save(dmi_env* env, const dmi_object* object, const dmi_bvh* trees, void* buffer, size_t capacity,
                      size_t* out_size) {
    const size_t size = dmi_dmo_size(object, trees);
    *out_size = size;
    if (buffer == NULL) return DM_OK;
    if (capacity < size) {
        return dmi_fail(env, DM_ERROR_BUFFER_TOO_SMALL, "dm_object_save: capacity is %zu, the object takes %zu bytes",
                        capacity, size);
    }
    dmi_dmo_write(object, trees, buffer);
    return DM_OK;
}

dm_result DM_CALL dm_object_save(dm_context* context, dm_object object, void* buffer, size_t capacity,
                                 size_t* out_size) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (out_size == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_save: out_size is NULL");
    const dmi_object_slot* slot = dmi_find(context, context->objects, "dm_object_save", object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    const dmi_bvh* trees;
    dmi_bvh* made;
    dm_result result = dmi_object_stored_trees(env, slot->object, &trees, &made);
    if (result == DM_OK) result = save(env, slot->object, trees, buffer, capacity, out_size);
    dmi_bvh_destroy(made);
    return result;
}

dm_result DM_CALL dm_object_load(dm_context* context, const void* data, size_t size, dm_model model,
                                 dm_object* out_object) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (data == NULL || out_object == NULL) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_load: %s is NULL",
                        data != NULL ? "out_object" : "data");
    }
    if (model && dmi_find(context, context->models, "dm_object_load: model", model) == NULL)
        return DM_ERROR_STALE_HANDLE;
    float told;
    const dmi_progress progress = dmi_progress_of(env, "dm_object_load", &told);
    dmi_object* object = NULL;
    dm_result result = dmi_dmo_read(env, context->picker, &context->axes, data, size, &progress, &object);
    if (result != DM_OK) return result;
    const uint32_t unmissed = model == 0 ? DM_DEGRADED_NO_MOTION : 0; /* such a host generates no motions */
    return dmi_object_publish(context, "dm_object_load", object, model, unmissed, out_object);
}
