/* Drag handles. A drag copies the joints it may follow, so that an update reads nothing but the drag. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "api_check.h"
#include "api_handles.h"
#include "api_motion.h"
#include "math/vec3.h"

/* Bytes of the first version of the struct, which ended with desc.feel.soft_limit. */
#define FIRST_DRAG_DESC (offsetof(dm_drag_desc, feel) + 2 * sizeof(float))

/* By hand; docs/feel.md. */
#define BUTTON_TRAVEL 0.04f      /* most travel of a push button, share of the object's size */
#define BUTTON_SIZE 0.25f        /* largest side of a push button, share of the object's size */
#define BUTTON_RETURN_TIME 0.12f /* s */
#define AT_REST_SHARE 0.02f /* of the range (of 1 rad or unit without limits): a part this near to rest is at rest */

static dm_result check_feel(dmi_env* env, const dm_drag_feel* feel) {
    const float numbers[6] = {feel->smoothing_time, feel->soft_limit,  feel->coast_time,
                              feel->detent,         feel->detent_pull, feel->return_time};
    static const char* const names[6] = {
        "dm_drag_begin: desc.feel.smoothing_time", "dm_drag_begin: desc.feel.soft_limit",
        "dm_drag_begin: desc.feel.coast_time",     "dm_drag_begin: desc.feel.detent",
        "dm_drag_begin: desc.feel.detent_pull",    "dm_drag_begin: desc.feel.return_time"};
    for (int i = 0; i < 6; i++) {
        dm_result result = dmi_check_finite(env, names[i], &numbers[i], 1);
        if (result != DM_OK) return result;
    }
    for (int i = 1; i <= 4; i++) { /* soft_limit, detent and detent_pull; coast_time may be negative */
        const bool share = i == 1 || i == 4;
        if (i == 2 || (numbers[i] >= 0.0f && !(share && numbers[i] > 1.0f))) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is %g: it must be %s", names[i], (double)numbers[i],
                        share ? "0 to 1" : "0 or more");
    }
    return DM_OK;
}

static dm_result check_desc(dmi_env* env, const dm_drag_desc* desc) {
    dm_result result = dmi_check_finite(env, "dm_drag_begin: desc.grab_point", dmi_xyz(desc->grab_point).v, 3);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.start_value", &desc->start_value, 1);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.limit_give", &desc->limit_give, 1);
    if (result == DM_OK) result = check_feel(env, &desc->feel);
    if (result != DM_OK) return result;
    if (desc->flags & ~(uint32_t)DM_DRAG_KEEP_JOINT) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: desc.flags is 0x%x: unknown flag", desc->flags);
    }
    return DM_OK;
}

/* Returns the largest side of a part's box, host units. */
static float part_size(const dmi_object* object, uint32_t part) {
    const dmi_part* shape = &object->parts[part].shape;
    float size = 0;
    for (int i = 0; i < 3; i++) size = fmaxf(size, shape->box_max[i] - shape->box_min[i]);
    return size * dmi_frame_length_out(&object->frame);
}

/* Whether a part is a push button: small, and sliding a short way to one side of rest only. */
static bool is_button(const dmi_object* object, uint32_t part) {
    const dm_joint* joint = &object->parts[part].joint;
    const float whole = dmi_frame_length_out(&object->frame), range = joint->upper - joint->lower;
    if (joint->type != DM_JOINT_PRISMATIC || !(range > 0) || range > BUTTON_TRAVEL * whole) return false;
    const bool one_way = joint->lower >= -AT_REST_SHARE * range || joint->upper <= AT_REST_SHARE * range;
    return one_way && part_size(object, part) <= BUTTON_SIZE * whole;
}

/* Whether the part is at rest, where all hypotheses agree on its pose. */
static bool is_at_rest(const dm_joint* joint, float value) {
    const float range = dmi_joint_has_limits(joint) ? joint->upper - joint->lower : 1.0f;
    return fabsf(value) <= AT_REST_SHARE * range;
}

/* Takes a free range of the object-normalised frame to host units. */
static dmi_free_range free_range_out(const dmi_object* object, int32_t type, dmi_free_range inner) {
    const float length = type == DM_JOINT_PRISMATIC ? dmi_frame_length_out(&object->frame) : 1;
    return (dmi_free_range){fmaxf(inner.lower * length, -FLT_MAX), fminf(inner.upper * length, FLT_MAX)};
}

static void add_alternatives(dmi_hypothesis_tracker* tracker, const dmi_object* object,
                             const dmi_alternatives* alternatives) {
    for (uint32_t i = 0; i < alternatives->count; i++) {
        const dmi_alternative* one = &alternatives->list[i];
        const dm_joint inner = {.type = one->type,
                                .type_confidence = one->confidence,
                                .confidence = one->confidence,
                                .axis = {one->axis[0], one->axis[1], one->axis[2]},
                                .origin = {one->origin[0], one->origin[1], one->origin[2]},
                                .source = DM_JOINT_FROM_GEOMETRY};
        const dm_joint joint = dmi_frame_joint_out(&object->frame, &inner);
        const dmi_free_range range = free_range_out(object, joint.type, one->free_range);
        dmi_hypothesis_tracker_add_alternative(tracker, &joint, range);
    }
}

/* Adds slides along the axes of the canonical frame. */
static void add_slides(dmi_hypothesis_tracker* tracker, const dmi_object* object, const dmi_free_range ranges[3]) {
    for (int i = 0; i < 3; i++) {
        const dm_joint inner = {.type = DM_JOINT_PRISMATIC, .axis = {i == 0, i == 1, i == 2}};
        const dm_joint joint = dmi_frame_joint_out(&object->frame, &inner);
        dmi_hypothesis_tracker_add_slide(tracker, joint.axis, free_range_out(object, joint.type, ranges[i]));
    }
}

static void begin(dmi_drag_slot* slot, const dm_drag_desc* desc) {
    const dmi_object* object = slot->owner->object;
    const dmi_object_part* part = &object->parts[slot->part];
    dm_joint joint = part->joint, joints[DM_MAX_HYPOTHESES];
    dmi_free_range free_ranges[DM_MAX_HYPOTHESES];
    dm_drag_feel feel = desc->feel;
    const bool certain = desc->flags & DM_DRAG_KEEP_JOINT || joint.source == DM_JOINT_FROM_HOST;
    if (!certain && dmi_joint_has_limits(&joint)) { /* an earlier drag may have exceeded the estimated limits */
        joint.lower = fminf(joint.lower, desc->start_value), joint.upper = fmaxf(joint.upper, desc->start_value);
    }
    if (feel.return_time == 0.0f && is_button(object, slot->part)) feel.return_time = BUTTON_RETURN_TIME;
    dmi_drag_begin(&slot->drag, &joint, dmi_xyz(desc->grab_point).v, desc->start_value, &feel);
    if (certain) return;
    const uint32_t count = is_at_rest(&joint, desc->start_value) ? part->hypotheses.count : 0;
    for (uint32_t i = 0; i < count; i++) {
        joints[i] = dmi_frame_joint_out(&object->frame, &part->hypotheses.joints[i]);
        free_ranges[i] = free_range_out(object, joints[i].type, part->hypotheses.free_range[i]);
    }
    const dmi_limit_give limit_give = {.share = desc->limit_give, .length = dmi_frame_length_out(&object->frame)};
    dmi_drag_track_hypotheses(&slot->drag, joints, free_ranges, count, part_size(object, slot->part), limit_give);
    if (count == 0) return;
    add_slides(&slot->drag.tracker, object, part->alternatives.slides);
    add_alternatives(&slot->drag.tracker, object, &part->alternatives);
}

dm_result DM_CALL dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_drag_desc known;
    dm_result result = dmi_read_desc(env, "dm_drag_begin: desc", desc, FIRST_DRAG_DESC, sizeof known, &known);
    if (result != DM_OK) return result;
    if (out_drag == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: out_drag is NULL");
    dmi_object_slot* owner = dmi_find(context, context->objects, "dm_drag_begin: desc.object", known.object);
    if (owner == NULL) return DM_ERROR_STALE_HANDLE;
    uint32_t part = 0;
    result = dmi_find_part(context, "dm_drag_begin: desc.part_id", owner->object, known.part_id, &part);
    if (result == DM_OK) result = check_desc(env, &known);
    if (result != DM_OK) return result;
    dmi_drag_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_drag_slot));
    if (slot == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_drag_begin: no memory");
    slot->owner = owner;
    slot->part = part;
    begin(slot, &known);
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
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_drag_slot* slot = dmi_find(context, context->drags, "dm_drag_update", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = DM_OK;
    if (ray != NULL || slot->drag.release.phase == DM_DRAG_HELD)
        result = dmi_check_ray(env, "dm_drag_update: ray", ray);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_update: dt", &dt, 1);
    if (result != DM_OK) return result;
    if (dt < 0.0f) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_update: dt is %g s", (double)dt);
    if (out_state == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_update: out_state is NULL");
    dmi_drag_update(&slot->drag, ray, dt, out_state);
    return DM_OK;
}

dm_result DM_CALL dm_drag_end(dm_context* context, dm_drag drag, dm_drag_state* out_state) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_take(context, context->drags, "dm_drag_end", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (out_state != NULL) dmi_drag_get_state(&slot->drag, out_state);
    dmi_dependent_unlink(context, &slot->owner->drags, &slot->link);
    dmi_free(&context->env, slot, sizeof *slot);
    return DM_OK;
}

dm_result DM_CALL dm_drag_get_joint(dm_context* context, dm_drag drag, dm_joint* out_joint) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_drag_slot* slot = dmi_find(context, context->drags, "dm_drag_get_joint", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (out_joint == NULL) {
        return dmi_fail(&context->env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_get_joint: out_joint is NULL");
    }
    *out_joint = slot->drag.joint;
    if (slot->drag.tracker.count > 0) out_joint->confidence = dmi_hypothesis_tracker_confidence(&slot->drag.tracker);
    return DM_OK;
}

/* ---- release ---- */

/* Paces the release by the motion that the network generates for pulling the grabbed point to the plan's outer end. */
static void pace_by_network(dm_context* context, dmi_drag_slot* slot, uint32_t seed) {
    const dmi_release* plan = &slot->drag.release;
    const dmi_model_slot* model = dmi_pool_get(context->models, slot->owner->model);
    if (plan->phase != DM_DRAG_RELEASED || plan->glides || slot->drag.feel.return_time > 0) return;
    if (model == NULL || model->motion == NULL || slot->owner->features == NULL)
        return; /* keeps the minimum-jerk pace */
    const float outer = fabsf(plan->end) > fabsf(plan->start) ? plan->end : plan->start;
    float pull[3], values[DM_MOTION_FRAMES];
    dmi_joint_velocity(&slot->drag.joint, 0, slot->drag.rest_point, pull);
    const float* grab = slot->drag.rest_point;
    const dm_drag_hint host = {{grab[0], grab[1], grab[2]}, {outer * pull[0], outer * pull[1], outer * pull[2]}};
    dmi_drag_hint hint;
    dm_result result = dmi_object_hint(&context->env, "dm_drag_release: the grabbed point", slot->owner->object,
                                       slot->part, &host, &hint);
    if (result == DM_OK) {
        result = dmi_motion_opening(context, slot->owner, slot->part, &slot->drag.joint, &hint, seed, values);
    }
    if (result == DM_OK) dmi_release_set_pace(&slot->drag.release, values);
}

static void write_plan(const dmi_release* release, dm_release_plan* out_plan) {
    const dm_release_plan plan = {.intent = release->intent,
                                  .start_value = release->start,
                                  .end_value = release->end,
                                  .duration = release->duration,
                                  .from_network = (uint32_t)release->paced};
    dmi_write_out(out_plan, &plan, sizeof plan);
}

static dm_result check_release(dmi_env* env, const dm_release_desc* desc, const dmi_release* last) {
    dm_result result =
        dmi_check_range(env, "dm_drag_release: desc.intent", desc->intent, DM_INTENT_AUTO, DM_INTENT_FREEZE);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_release: desc.duration", &desc->duration, 1);
    if (result != DM_OK) return result;
    if (desc->duration < 0.0f) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_release: desc.duration is %g s",
                        (double)desc->duration);
    }
    if (desc->intent == DM_INTENT_REPLAY && last->phase == DM_DRAG_HELD) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_drag_release: desc.intent is DM_INTENT_REPLAY, but the drag "
                        "was never released");
    }
    return DM_OK;
}

dm_result DM_CALL dm_drag_release(dm_context* context, dm_drag drag, const dm_release_desc* desc,
                                  dm_release_plan* out_plan) {
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_drag_slot* slot = dmi_find(context, context->drags, "dm_drag_release", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_release_desc known = {0};
    dm_result result = DM_OK;
    if (desc != NULL) {
        result = dmi_read_desc(env, "dm_drag_release: desc", desc, DMI_FIRST_SIZE(dm_release_desc, seed), sizeof known,
                               &known);
    }
    if (result == DM_OK && out_plan != NULL) {
        result =
            dmi_check_out(env, "dm_drag_release: out_plan", out_plan, DMI_FIRST_SIZE(dm_release_plan, from_network));
    }
    if (result == DM_OK) result = check_release(env, &known, &slot->drag.release);
    if (result != DM_OK) return result;
    dmi_drag_release(&slot->drag, known.intent, known.duration);
    if (known.intent != DM_INTENT_REPLAY) pace_by_network(context, slot, known.seed);
    if (out_plan != NULL) write_plan(&slot->drag.release, out_plan);
    return DM_OK;
}
