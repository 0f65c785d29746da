/* Motion handles: the DQ-VAE's motion for a drag, projected exactly onto the active joint. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_handles.h"
#include "api_motion.h"
#include "base/env.h"
#include "base/fp_environment.h"
#include "math/linear3.h"

#define MAX_PATH 65536 /* points of a host's path; by hand: a pointer at 1000 Hz for over a minute */

/* The inputs of one motion, in the host's frame and in the object-normalised frame. */
typedef struct request {
    dm_context* context;
    const dm_motion_desc* desc;
    const dmi_object_slot* slot;
    const dmi_object_part* part;
    const dm_joint* host_joint; /* host frame */
    dmi_drag_hint hint;
    dm_joint joint; /* inner frame, signed so that positive follows the drag */
    float sign;     /* -1 when the axis was reversed for that, else +1 */
} request;

/* Converts the joint and orients it as in training: a positive step follows the drag. */
static void orient(request* work) {
    const dm_joint given = dmi_frame_joint_in(&work->slot->object->frame, work->host_joint);
    work->joint = given;
    dmi_joint_orient(&work->joint, &work->hint);
    work->sign = dmi_dot3(dmi_xyz(work->joint.axis).v, dmi_xyz(given.axis).v) < 0.0f ? -1.0f : 1.0f;
    dmi_joint_set_origin_near(&work->joint, work->part->shape.centre);
}

/* Converts the host's path to the inner frame and resamples it, starting at the drag point. */
static dm_result resample(const request* work, float (*points)[3], float out_path[DMI_VAE_PATH][3]) {
    const dm_motion_desc* desc = work->desc;
    memcpy(points[0], work->hint.point, sizeof points[0]);
    for (uint32_t i = 0; i < desc->path_count; i++) {
        const dmi_double3 host = dmi_xyz_f64(desc->path[i]);
        if (!isfinite(host.v[0] + host.v[1] + host.v[2])) {
            return dmi_fail(&work->context->env, DM_ERROR_NOT_FINITE,
                            "dm_motion_generate: desc.path[%u] is (%g, %g, %g)", i, host.v[0], host.v[1], host.v[2]);
        }
        dmi_frame_point_in(&work->slot->object->frame, host.v, points[i + 1]);
    }
    /* NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked */
    const bool starts_there = memcmp(points[0], points[1], sizeof points[0]) == 0;
    dmi_motion_resample_path((const float(*)[3])points + starts_there, desc->path_count + !starts_there, out_path);
    return DM_OK;
}

static dm_result make_path(const request* work, float out_path[DMI_VAE_PATH][3]) {
    const dm_motion_desc* desc = work->desc;
    dmi_env* env = &work->context->env;
    if (desc->path_count == 0) {
        dmi_motion_default_path(&work->joint, work->hint.point, work->hint.vector, out_path);
        return DM_OK;
    }
    if (desc->path_count > MAX_PATH) {
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_motion_generate: desc.path_count is %u: the most is %d",
                        desc->path_count, MAX_PATH);
    }
    size_t size = (desc->path_count + 1) * sizeof(float[3]);
    float(*points)[3] = dmi_scratch_alloc(env, size);
    if (points == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_motion_generate: no memory for the path");
    dm_result result = resample(work, points, out_path);
    dmi_scratch_free(env, points);
    return result;
}

/* Runs the DQ-VAE. out_values: joint values in host units. */
static dm_result run_network(const request* work, float out_values[DM_MOTION_FRAMES]) {
    dmi_env* env = &work->context->env;
    const dmi_model_slot* model = dmi_pool_get(work->context->models, work->slot->model);
    if (model == NULL || model->motion == NULL || work->slot->features == NULL) {
        return dmi_fail(env, DM_ERROR_NO_MODEL,
                        "dm_motion_generate: the object has no motion weights, or they were unloaded");
    }
    dmi_vae_query query = {.joint = work->joint, .seed = work->desc->seed};
    memcpy(query.drag_point, work->hint.point, sizeof query.drag_point);
    memcpy(query.drag_vector, work->hint.vector, sizeof query.drag_vector);
    dm_result result = make_path(work, query.path);
    if (result != DM_OK) return result;
    size_t size = dmi_dq_vae_scratch_size(model->motion);
    void* scratch = dmi_scratch_alloc(env, size);
    if (scratch == NULL)
        return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_motion_generate: no memory for %zu bytes", size);
    dmi_vae_output output;
    dmi_dq_vae_forward(model->motion, work->context->isa, &work->slot->features[work->part - work->slot->object->parts],
                       &query, scratch, &output);
    dmi_scratch_free(env, scratch);
    dmi_motion_project(&work->joint, (const float(*)[8])output.raw, out_values);
    float unit = work->joint.type == DM_JOINT_PRISMATIC ? dmi_frame_length_out(&work->slot->object->frame) : 1.0f;
    for (int i = 0; i < DM_MOTION_FRAMES; i++) out_values[i] *= work->sign * unit;
    return DM_OK;
}

/* Clamps once more in the host frame, because unit conversion rounds. */
static void clamp_values(const dm_joint* joint, float values[DM_MOTION_FRAMES]) {
    for (int i = 0; i < DM_MOTION_FRAMES; i++) values[i] = dmi_joint_clamp(joint, values[i]);
}

static dm_result generate(request* work, dmi_motion* out_motion) {
    const dm_motion_desc* desc = work->desc;
    dmi_env* env = &work->context->env;
    if ((desc->path == NULL) != (desc->path_count == 0)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_motion_generate: desc.path is %s but desc.path_count is %u",
                        desc->path != NULL ? "given" : "NULL", desc->path_count);
    }
    uint32_t index = 0;
    dm_result result =
        dmi_find_part(work->context, "dm_motion_generate: desc.part_id", work->slot->object, desc->part_id, &index);
    if (result != DM_OK) return result;
    work->part = &work->slot->object->parts[index];
    work->host_joint = &work->part->joint;
    result = dmi_object_hint(env, "dm_motion_generate: desc.drag", work->slot->object, index, &desc->drag, &work->hint);
    if (result != DM_OK) return result;
    *out_motion = (dmi_motion){.joint = work->part->joint};
    if (work->part->joint.type == DM_JOINT_FIXED) return DM_OK;
    orient(work);
    result = run_network(work, out_motion->values);
    if (result == DM_OK) clamp_values(&out_motion->joint, out_motion->values);
    return result;
}

dm_result dmi_motion_opening(dm_context* context, const dmi_object_slot* slot, uint32_t part, const dm_joint* joint,
                             const dmi_drag_hint* hint, uint32_t seed, float out_values[DM_MOTION_FRAMES]) {
    const dm_motion_desc desc = {.seed = seed};
    request work = {.context = context,
                    .desc = &desc,
                    .slot = slot,
                    .part = &slot->object->parts[part],
                    .host_joint = joint,
                    .hint = *hint};
    orient(&work);
    const dm_result result = run_network(&work, out_values);
    if (result == DM_OK) clamp_values(joint, out_values);
    return result;
}

dm_result DM_CALL dm_motion_generate(dm_context* context, dm_object object, const dm_motion_desc* desc,
                                     dm_motion* out_motion) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_motion_desc known;
    dm_result result = dmi_read_desc(env, "dm_motion_generate: desc", desc, DMI_FIRST_SIZE(dm_motion_desc, seed),
                                     sizeof known, &known);
    if (result != DM_OK) return result;
    if (out_motion == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_motion_generate: out_motion is NULL");
    dmi_object_slot* owner = dmi_find(context, context->objects, "dm_motion_generate", object);
    if (owner == NULL) return DM_ERROR_STALE_HANDLE;
    request work = {.context = context, .desc = &known, .slot = owner};
    dmi_motion motion;
    result = generate(&work, &motion);
    if (result != DM_OK) return result;
    dmi_motion_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_motion_slot));
    if (slot == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_motion_generate: no memory");
    slot->owner = owner;
    slot->motion = motion;
    result = dmi_dependent_add(context, context->motions, &owner->motions, &slot->link);
    if (result != DM_OK) {
        dmi_free(env, slot, sizeof *slot);
        return result;
    }
    *out_motion = slot->link.handle;
    return DM_OK;
}

dm_result DM_CALL dm_motion_sample(dm_context* context, dm_motion motion, float t, dm_pose* out_pose,
                                   float* out_value) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_motion_slot* slot = dmi_pool_get(context->motions, motion);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = dmi_check_finite(DMI_SILENT, "t", &t, 1);
    if (result != DM_OK) return result;
    if (out_pose == NULL) return DM_ERROR_INVALID_ARGUMENT;
    float value = dmi_motion_value(&slot->motion, t);
    *out_pose = dmi_joint_pose(&slot->motion.joint, value);
    if (out_value != NULL) *out_value = value;
    return DM_OK;
}

dm_result DM_CALL dm_motion_get_frames(dm_context* context, dm_motion motion, dm_pose* out_poses, float* out_values) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_motion_slot* slot = dmi_pool_get(context->motions, motion);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (out_poses == NULL) return DM_ERROR_INVALID_ARGUMENT;
    for (int i = 0; i < DM_MOTION_FRAMES; i++) {
        out_poses[i] = dmi_joint_pose(&slot->motion.joint, slot->motion.values[i]);
        if (out_values != NULL) out_values[i] = slot->motion.values[i];
    }
    return DM_OK;
}

dm_result DM_CALL dm_motion_destroy(dm_context* context, dm_motion motion) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_motion_slot* slot = dmi_take(context, context->motions, "dm_motion_destroy", motion);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dmi_dependent_unlink(context, &slot->owner->motions, &slot->link);
    dmi_free(&context->env, slot, sizeof *slot);
    return DM_OK;
}
