/* Drags behind handles. A drag copies the joint it follows, so that an update reads nothing but the drag. */
#include <math.h>

#include "api_check.h"
#include "api_context.h"

static dm_result check_desc(dmi_env* env, const dm_drag_desc* desc) {
    const float numbers[6] = {desc->grab_point.x, desc->grab_point.y,        desc->grab_point.z,
                              desc->start_value,  desc->feel.smoothing_time, desc->feel.soft_limit};
    dm_result result = dmi_check_finite(env, "dm_drag_begin: desc.grab_point", numbers, 3);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.start_value", numbers + 3, 1);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.feel.smoothing_time", numbers + 4, 1);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.feel.soft_limit", numbers + 5, 1);
    if (result != DM_OK) return result;
    if (desc->feel.soft_limit < 0.0f || desc->feel.soft_limit > 1.0f) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: desc.feel.soft_limit is %g: it must be 0 to 1",
                        (double)desc->feel.soft_limit);
    }
    return DM_OK;
}

dm_result DM_CALL dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag) {
    if (!context) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_drag_desc known;
    dm_result result =
        dmi_read_desc(env, "dm_drag_begin: desc", desc, DMI_FIRST_SIZE(dm_drag_desc, feel), sizeof known, &known);
    if (result != DM_OK) return result;
    if (!out_drag) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: out_drag is NULL");
    dmi_object_slot* owner = dmi_find(context, context->objects, "dm_drag_begin: desc.object", known.object);
    if (!owner) return DM_ERROR_STALE_HANDLE;
    uint32_t part = 0;
    result = dmi_find_part(context, "dm_drag_begin: desc.part_id", owner->object, known.part_id, &part);
    if (result == DM_OK) result = check_desc(env, &known);
    if (result != DM_OK) return result;
    dmi_drag_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_drag_slot));
    if (!slot) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_drag_begin: no memory");
    slot->owner = owner;
    const float grab[3] = {known.grab_point.x, known.grab_point.y, known.grab_point.z};
    dmi_drag_begin(&slot->drag, &owner->object->parts[part].joint, grab, known.start_value, &known.feel);
    result = dmi_dependent_add(context, context->drags, &owner->drags, &slot->link);
    if (result != DM_OK) {
        dmi_free(env, slot, sizeof *slot);
        return result;
    }
    *out_drag = slot->link.handle;
    return DM_OK;
}

dm_result DM_CALL dm_drag_update(dm_context* context, dm_drag drag, const dm_ray* ray, float dt,
                                 dm_drag_state* out_state) {
    if (!context) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_drag_slot* slot = dmi_find(context, context->drags, "dm_drag_update", drag);
    if (!slot) return DM_ERROR_STALE_HANDLE;
    dm_result result = dmi_check_ray(env, "dm_drag_update: ray", ray);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_update: dt", &dt, 1);
    if (result != DM_OK) return result;
    if (dt < 0.0f) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_update: dt is %g s", (double)dt);
    if (!out_state) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_update: out_state is NULL");
    dmi_drag_update(&slot->drag, ray, dt, out_state);
    return DM_OK;
}

dm_result DM_CALL dm_drag_end(dm_context* context, dm_drag drag, dm_drag_state* out_state) {
    if (!context) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_take(context, context->drags, "dm_drag_end", drag);
    if (!slot) return DM_ERROR_STALE_HANDLE;
    if (out_state) dmi_drag_state_now(&slot->drag, out_state);
    dmi_dependent_unlink(context, &slot->owner->drags, &slot->link);
    dmi_free(&context->env, slot, sizeof *slot);
    return DM_OK;
}
