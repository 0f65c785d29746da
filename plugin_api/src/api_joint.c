/* The joints of an object: inferred ones, and those that the host sets. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_degraded.h"
#include "api_handles.h"
#include "api_joint_check.h"
#include "api_model.h"
#include "base/fp_environment.h"
#include "math/elementary.h"

#define DEGREES_BEYOND 25.0f /* rad, four turns; a hinge with a farther limit was meant in degrees; by hand */

/* Finds object and part of a call. Messages are in the name of `function`. */
static dm_result find(dm_context* context, const char* function, dm_object object, uint32_t part_id,
                      dmi_object_slot** out_slot, uint32_t* out_index) {
    *out_slot = dmi_find(context, context->objects, function, object);
    if (*out_slot == NULL) return DM_ERROR_STALE_HANDLE;
    return dmi_find_part(context, function, (*out_slot)->object, part_id, out_index);
}

dm_result DM_CALL dm_object_get_joint(dm_context* context, dm_object object, uint32_t part_id, dm_joint* out_joint) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = dmi_joint_check_out(&context->env, "dm_object_get_joint: out_joint", out_joint);
    if (result == DM_OK) result = find(context, "dm_object_get_joint", object, part_id, &slot, &index);
    if (result == DM_OK) dmi_write_out(out_joint, &slot->object->parts[index].joint, sizeof(dm_joint));
    return result;
}

/* Writes joints into the host's array, whose stride is the host's struct_size. */
static void write_joints(const dmi_frame* frame, const dmi_hypotheses* ranked, uint32_t count, dm_joint* out_joints) {
    const uint32_t step = out_joints[0].struct_size;
    for (uint32_t i = 0; i < count; i++) {
        uint8_t* out = (uint8_t*)out_joints + (size_t)i * step;
        const dm_joint joint = dmi_frame_joint_out(frame, &ranked->joints[i]);
        memcpy(out, &step, sizeof step);
        dmi_write_out(out, &joint, sizeof joint);
    }
}

dm_result DM_CALL dm_object_get_hypotheses(dm_context* context, dm_object object, uint32_t part_id,
                                           const dm_drag_hint* drag, dm_joint* out_joints, uint32_t capacity,
                                           uint32_t* out_count) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (out_count == NULL || (out_joints == NULL && capacity > 0)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_get_hypotheses: %s is NULL",
                        out_count != NULL ? "out_joints" : "out_count");
    }
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_get_hypotheses", object, part_id, &slot, &index);
    if (result == DM_OK && capacity > 0)
        result = dmi_joint_check_out(env, "dm_object_get_hypotheses: out_joints[0]", out_joints);
    if (result != DM_OK) return result;
    dmi_hypotheses ranked = slot->object->parts[index].hypotheses;
    if (drag != NULL) {
        dmi_drag_hint hint;
        result = dmi_object_hint(env, "dm_object_get_hypotheses: drag", slot->object, index, drag, &hint);
        if (result != DM_OK) return result;
        dmi_hypotheses_rerank(&slot->object->parts[index].hypotheses, &hint, &ranked);
    }
    uint32_t count = ranked.count < capacity ? ranked.count : capacity;
    if (count > 0) write_joints(&slot->object->frame, &ranked, count, out_joints);
    *out_count = count;
    return DM_OK;
}

dm_result DM_CALL dm_object_refine(dm_context* context, dm_object object, uint32_t part_id, const dm_drag_hint* drag) {
    DMI_OWN_FP;
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
    result = dmi_object_refine(env, slot->object, index, &models, &hint);
    const bool by_rules = models.joints == NULL && !slot->object->network_alone;
    if (result == DM_OK && by_rules) dmi_degraded_warn(env, "dm_object_refine", DM_DEGRADED_NO_RANKER);
    return result;
}

/* ---- the host's joint ---- */

/* Returns the library's own answer. */
static dm_joint own_joint(const dmi_object* object, uint32_t index) {
    const dmi_object_part* part = &object->parts[index];
    return part->hypotheses.count > 0 ? dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[0]) : part->joint;
}

/* Returns whether two joints are the same motion, bit for bit, whatever their confidences and sources. */
static bool same_motion(const dm_joint* a, const dm_joint* b) {
    const float x[10] = {a->axis.x,   a->axis.y, a->axis.z, a->origin.x, a->origin.y,
                         a->origin.z, a->pitch,  a->lower,  a->upper,    a->closed};
    const float y[10] = {b->axis.x,   b->axis.y, b->axis.z, b->origin.x, b->origin.y,
                         b->origin.z, b->pitch,  b->lower,  b->upper,    b->closed};
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    return a->type == b->type && memcmp(x, y, sizeof x) == 0;
}

static void warn_of_degrees(dmi_env* env, const dm_joint* joint) {
    if (joint->type != DM_JOINT_REVOLUTE || !dmi_joint_has_limits(joint)) return;
    const float most = dmi_fmaxf(fabsf(joint->lower), fabsf(joint->upper));
    if (most <= DEGREES_BEYOND || dmi_joint_open_side(joint, 1) != 0) return;
    dmi_warn(env, "dm_object_set_joint: joint has limits %g to %g: they are taken as radians. Were degrees meant?",
             (double)joint->lower, (double)joint->upper);
}

dm_result DM_CALL dm_object_set_joint(dm_context* context, dm_object object, uint32_t part_id, const dm_joint* joint) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_object_slot* slot;
    uint32_t index;
    dm_joint given;
    dm_result result = dmi_joint_read(env, "dm_object_set_joint: joint", joint, &given);
    if (result == DM_OK) result = find(context, "dm_object_set_joint", object, part_id, &slot, &index);
    if (result != DM_OK) return result;
    dm_joint* in_force = &slot->object->parts[index].joint;
    const dm_joint own = own_joint(slot->object, index);
    if (same_motion(&given, in_force)) return DM_OK;
    if (same_motion(&given, &own)) {
        *in_force = own;
        return DM_OK;
    }
    result = dmi_joint_accept(env, "dm_object_set_joint: joint", dmi_frame_length_out(&slot->object->frame), &given);
    if (result != DM_OK) return result;
    warn_of_degrees(env, &given);
    given.type_confidence = given.joint_confidence = 1;
    given.source = DM_JOINT_FROM_HOST;
    memset(given.evidence, 0, sizeof given.evidence);
    *in_force = given;
    return DM_OK;
}

dm_result DM_CALL dm_object_reset_joint(dm_context* context, dm_object object, uint32_t part_id) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_object_slot* slot;
    uint32_t index;
    dm_result result = find(context, "dm_object_reset_joint", object, part_id, &slot, &index);
    if (result == DM_OK) slot->object->parts[index].joint = own_joint(slot->object, index);
    return result;
}
