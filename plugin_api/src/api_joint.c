/* The joints of an object: inferred ones, and those that the host sets. */
#include <math.h>

#include "api_check.h"
#include "api_handles.h"
#include "api_model.h"

#define MIN_AXIS_LENGTH 1e-6 /* of a host's axis; shorter ones have no direction; by hand */

enum { WITHOUT_LIMITS = 7, WITH_LIMITS = 9 }; /* numbers of a joint that are checked */

/* Finds object and part of a call; messages are in the name of `function`. */
static dm_result find(dm_context* context, const char* function, dm_object object, uint32_t part_id,
                      dmi_object_slot** out_slot, uint32_t* out_index) {
    *out_slot = dmi_find(context, context->objects, function, object);
    if (*out_slot == NULL) return DM_ERROR_STALE_HANDLE;
    return dmi_find_part(context, function, (*out_slot)->object, part_id, out_index);
}

dm_result DM_CALL dm_object_get_joint(dm_context* context, dm_object object, uint32_t part_id, dm_joint* out_joint) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    if (out_joint == NULL) {
        return dmi_fail(&context->env, DM_ERROR_INVALID_ARGUMENT, "dm_object_get_joint: out_joint is NULL");
    }
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_get_joint", object, part_id, &slot, &index);
    if (result == DM_OK) *out_joint = slot->object->parts[index].joint;
    return result;
}

dm_result DM_CALL dm_object_get_hypotheses(dm_context* context, dm_object object, uint32_t part_id,
                                           const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity,
                                           uint32_t* out_count) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (out_count == NULL || (out_joints == NULL && capacity > 0)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_get_hypotheses: %s is NULL",
                        out_count != NULL ? "out_joints" : "out_count");
    }
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_get_hypotheses", object, part_id, &slot, &index);
    if (result != DM_OK) return result;
    dmi_hypotheses ranked = slot->object->parts[index].hypotheses;
    if (drag != NULL) {
        dmi_drag_hint hint;
        result = dmi_object_hint(env, "dm_object_get_hypotheses: drag", slot->object, index, drag, &hint);
        if (result != DM_OK) return result;
        dmi_hypotheses_rerank(&slot->object->parts[index].hypotheses, &hint, &ranked);
    }
    uint32_t count = ranked.count < capacity ? ranked.count : capacity;
    for (uint32_t i = 0; i < count; i++) out_joints[i] = dmi_frame_joint_out(&slot->object->frame, &ranked.joints[i]);
    *out_count = count;
    return DM_OK;
}

dm_result DM_CALL dm_object_refine(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (drag == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_refine: drag is NULL");
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_refine", object, part_id, &slot, &index);
    if (result != DM_OK) return result;
    if (slot->object->mesh == NULL) {
        return dmi_fail(env, DM_ERROR_UNSUPPORTED,
                        "dm_object_refine: the object was prepared or saved without triangles");
    }
    const dmi_model_slot* model = dmi_pool_get(context->models, slot->model);
    if (model == NULL || model->kinematics == NULL) {
        return dmi_fail(env, DM_ERROR_NO_MODEL,
                        "dm_object_refine: the object has no kinematics weights, or they were unloaded");
    }
    dmi_drag_hint hint;
    result = dmi_object_hint(env, "dm_object_refine: drag", slot->object, index, drag, &hint);
    if (result != DM_OK) return result;
    const dmi_inference_models models = dmi_inference_models_of(context, model);
    return dmi_object_refine(env, slot->object, index, &models, &hint);
}

/* Copies a host's joint with a unit axis and only the limits that its type has; errors name the field. */
static dm_result accept_joint(dmi_env* env, const dm_joint* given, dm_joint* out) {
    const float numbers[WITH_LIMITS] = {given->axis.x,   given->axis.y, given->axis.z, given->origin.x, given->origin.y,
                                        given->origin.z, given->pitch,  given->lower,  given->upper};
    static const char* const names[WITH_LIMITS] = {"axis.x",   "axis.y", "axis.z", "origin.x", "origin.y",
                                                   "origin.z", "pitch",  "lower",  "upper"};
    *out = *given;
    dm_result result =
        dmi_check_range(env, "dm_object_set_joint: joint.type", given->type, DM_JOINT_REVOLUTE, DM_JOINT_FIXED);
    if (result != DM_OK) return result;
    /* A continuous joint has no limits, so their fields may hold anything, often infinities. */
    const int count = given->type == DM_JOINT_CONTINUOUS ? WITHOUT_LIMITS : WITH_LIMITS;
    for (int i = 0; i < count; i++) {
        if (isfinite(numbers[i])) continue;
        return dmi_fail(env, DM_ERROR_NOT_FINITE, "dm_object_set_joint: joint.%s is %g", names[i], (double)numbers[i]);
    }
    double length =
        sqrt((double)numbers[0] * numbers[0] + (double)numbers[1] * numbers[1] + (double)numbers[2] * numbers[2]);
    if (!(length > MIN_AXIS_LENGTH) && given->type != DM_JOINT_FIXED) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_set_joint: joint.axis has length %g", length);
    }
    if (count == WITH_LIMITS && given->lower > given->upper) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_set_joint: joint.lower %g is above joint.upper %g",
                        (double)given->lower, (double)given->upper);
    }
    const double inverse = length > MIN_AXIS_LENGTH ? 1.0 / length : 0.0;
    out->axis = (dm_vec3){(float)(numbers[0] * inverse), (float)(numbers[1] * inverse), (float)(numbers[2] * inverse)};
    if (inverse == 0.0) out->axis.y = 1.0f; /* a fixed joint needs an axis, any will do */
    if (given->type == DM_JOINT_CONTINUOUS || given->type == DM_JOINT_FIXED) out->lower = out->upper = 0.0f;
    if (given->type != DM_JOINT_SCREW) out->pitch = 0.0f;
    out->type_confidence = out->confidence = 1.0f;
    out->source = DM_JOINT_FROM_HOST;
    return DM_OK;
}

dm_result DM_CALL dm_object_set_joint(dm_context* context, dm_object object, uint32_t part_id, const dm_joint* joint) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    if (joint == NULL) return dmi_fail(&context->env, DM_ERROR_INVALID_ARGUMENT, "dm_object_set_joint: joint is NULL");
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_set_joint", object, part_id, &slot, &index);
    dm_joint accepted;
    if (result == DM_OK) result = accept_joint(&context->env, joint, &accepted);
    if (result == DM_OK) slot->object->parts[index].joint = accepted;
    return result;
}
