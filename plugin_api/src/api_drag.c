/* Drag handles. A drag copies the joints it may follow, so that an update reads nothing but the drag. */
#include "api_drag.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "api_check.h"
#include "api_joint_check.h"
#include "base/fp_environment.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* The constants below are set by hand; docs/feel.md. */
/* Size of dm_part_state in the first version: its last field was the joint of that version. */
#define FIRST_PART_STATE (offsetof(dm_part_state, joint) + DMI_FIRST_SIZE(dm_joint, source))
#define BUTTON_TRAVEL 0.04f      /* most travel of a push button, share of the object's size */
#define BUTTON_SIZE 0.25f        /* largest side of a push button, share of the object's size */
#define BUTTON_RETURN_TIME 0.12f /* s */
#define AT_REST_SHARE 0.02f      /* share of the range; a limit this near to rest is at rest */

/* What can't be meant, by hand: other units are off by a hundred or more, and frame times by a thousand. */
#define FAR_POINT 50.0f      /* object sizes between object and grabbed point */
#define FAR_SLIDE 50.0f      /* object sizes of a slide's value */
#define FAR_TURN 12.6f       /* rad beyond the limits of a turn: two turns, twice what a pull exceeds them by */
#define LONG_FRAME 3.0f      /* s of one update: 3 ms in milliseconds */
#define STOP_TOLERANCE 1e-4f /* object sizes, or rad: a value this near to the only limit is at it */
/* A negative time step this small is a rounded 0, s. The last bit of a clock that counts seconds in a float is as large
 * after a quarter of an hour; by hand. */
#define ROUNDED_TIME 1e-4f

static dm_result check_desc(dmi_env* env, const dm_drag_desc* desc) {
    static const char* const places[3] = {".grab_point.x", ".grab_point.y", ".grab_point.z"};
    dm_result result = DM_OK;
    if (!(desc->flags & DM_DRAG_WITHOUT_POINT))
        result = dmi_check_vector(env, "dm_drag_begin: desc", places, dmi_xyz(desc->grab_point).v);
    if (result == DM_OK) result = dmi_check_number(env, "dm_drag_begin: desc", ".start_value", desc->start_value);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.limit_give", &desc->limit_give, 1);
    if (result == DM_OK) result = dmi_check_feel(env, &desc->feel);
    if (result != DM_OK) return result;
    if (desc->flags & ~(uint32_t)(DM_DRAG_KEEP_JOINT | DM_DRAG_WITHOUT_POINT)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: desc.flags is 0x%x: unknown flag", desc->flags);
    }
    if (desc->reserved == 0) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: desc.reserved is %u: it must be 0", desc->reserved);
}

/* ---- the start of a drag ---- */

#define SCALED_JOINT "dm_drag_begin: desc.scale: the scaled joint"

/* What a drag begins with, in the frame of the scaled instance. */
typedef struct start {
    const dm_drag_desc* desc;
    const dmi_object* object;
    uint32_t part;
    dm_vec3 scale;
    dm_vec3 centre, part_centre; /* centres of the boxes */
    float object_size, part_size;
    dm_joint joint; /* the joint in force */
    float value;
    bool has_pose; /* pose: the pose in which the part is shown */
    dm_pose pose;
    dmi_rules rules;
} start;

static bool is_unscaled(dm_vec3 scale) {
    return scale.x == 1 && scale.y == 1 && scale.z == 1;
}

/* Returns the largest side of a box of the inner frame, host units of the scaled instance. out_centre: the centre of
 * that box. */
static float scaled_size(const start* s, const float min[3], const float max[3], dm_vec3* out_centre) {
    dm_vec3 low, high;
    dmi_object_box_out(&s->object->frame, min, max, &low, &high);
    *out_centre = (dm_vec3){0.5f * s->scale.x * (low.x + high.x), 0.5f * s->scale.y * (low.y + high.y),
                            0.5f * s->scale.z * (low.z + high.z)};
    if (is_unscaled(s->scale)) {
        const float side = dmi_fmaxf(max[0] - min[0], dmi_fmaxf(max[1] - min[1], max[2] - min[2]));
        return side * dmi_frame_length_out(&s->object->frame);
    }
    const float x = fabsf(s->scale.x) * (high.x - low.x), y = fabsf(s->scale.y) * (high.y - low.y);
    return dmi_fmaxf(x, dmi_fmaxf(y, fabsf(s->scale.z) * (high.z - low.z)));
}

static void measure(start* s) {
    const dmi_part* shape = &s->object->parts[s->part].shape;
    s->part_size = scaled_size(s, shape->box_min, shape->box_max, &s->part_centre);
    s->object_size = scaled_size(s, s->object->box_min, s->object->box_max, &s->centre);
    if (is_unscaled(s->scale)) s->object_size = dmi_frame_length_out(&s->object->frame);
}

static dm_result check_confidence(dmi_env* env, const char* field, float number) {
    if (number >= 0 && number <= 1) return DM_OK;
    return dmi_fail(env, isfinite(number) ? DM_ERROR_INVALID_ARGUMENT : DM_ERROR_NOT_FINITE,
                    "dm_drag_begin: desc.state.joint%s is %g: it must be 0 to 1", field, (double)number);
}

/* Reads the joint in a state of any version. Its size is no larger than what the caller's state holds of it. */
static dm_result read_joint(dmi_env* env, uint32_t state_size, dm_part_state* state, dm_joint* out) {
    const uint32_t room = state_size - (uint32_t)offsetof(dm_part_state, joint);
    if (state->joint.struct_size > room) {
        return dmi_fail(env, DM_ERROR_STRUCT_SIZE,
                        "dm_drag_begin: desc.state.joint.struct_size is %u: desc.state has room for %u",
                        state->joint.struct_size, room);
    }
    /* What this version does not know was found to be zeros. */
    if (state->joint.struct_size > sizeof state->joint) state->joint.struct_size = sizeof state->joint;
    return dmi_joint_read(env, "dm_drag_begin: desc.state.joint", &state->joint, out);
}

/* Reads the instance's own joint and value. */
static dm_result read_state(dmi_env* env, start* s) {
    dm_part_state state;
    dm_result result =
        dmi_read_desc(env, "dm_drag_begin: desc.state", s->desc->state, FIRST_PART_STATE, sizeof state, &state);
    if (result == DM_OK) result = read_joint(env, s->desc->state->struct_size, &state, &s->joint);
    if (result == DM_OK) result = dmi_check_number(env, "dm_drag_begin: desc.state", ".value", state.value);
    if (result == DM_OK) result = dmi_joint_accept(env, "dm_drag_begin: desc.state.joint", s->object_size, &s->joint);
    if (result == DM_OK)
        result = dmi_check_range(env, "dm_drag_begin: desc.state.joint.source", s->joint.source, DM_JOINT_FROM_NETWORK,
                                 DM_JOINT_CHOSEN);
    if (result == DM_OK) result = check_confidence(env, ".type_confidence", s->joint.type_confidence);
    if (result == DM_OK) result = check_confidence(env, ".joint_confidence", s->joint.joint_confidence);
    if (result != DM_OK) return result;
    s->value = state.value;
    const float* r = state.pose.real;
    s->has_pose = r[0] != 0 || r[1] != 0 || r[2] != 0 || r[3] != 0;
    return s->has_pose ? dmi_check_pose(env, "dm_drag_begin: desc.state.pose", &state.pose, &s->pose) : DM_OK;
}

/* Brings limits inside the values that are computed with. Returns false when no range is left. */
static bool bound_limits(dm_joint* joint) {
    const float far = dmi_joint_farthest(joint);
    const bool limited = dmi_joint_has_limits(joint);
    joint->lower = dmi_clamp_within(joint->lower, far);
    joint->upper = dmi_clamp_within(joint->upper, far);
    return !limited || dmi_joint_has_limits(joint);
}

/* Checks the sizes, which stand for lengths where a joint has no limits. */
static dm_result check_sizes(dmi_env* env, const start* s) {
    const float size = dmi_fmaxf(s->object_size, s->part_size);
    if (size <= DMI_LARGEST) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_drag_begin: the object is %g host units large: sizes beyond %g are too large to compute with",
                    (double)size, (double)DMI_LARGEST);
}

static dm_result check_value(dmi_env* env, const start* s) {
    const float far = dmi_joint_farthest(&s->joint);
    if (fabsf(s->value) <= far) return DM_OK;
    return dmi_fail(
        env, DM_ERROR_INVALID_ARGUMENT,
        "dm_drag_begin: the value is %g: with the screw's pitch %g, values beyond %g are too large to compute with",
        (double)s->value, (double)s->joint.pitch, (double)far);
}

static dm_result read_start(dmi_env* env, start* s) {
    dm_result result = dmi_scale_read(env, "dm_drag_begin: desc.scale", s->desc->scale, &s->scale);
    if (result != DM_OK) return result;
    measure(s);
    result = check_sizes(env, s);
    if (result != DM_OK) return result;
    s->joint = s->object->parts[s->part].joint;
    s->value = s->desc->start_value;
    dmi_joint_scale(&s->joint, s->scale);
    if (s->desc->state != NULL && s->desc->start_value != 0) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_drag_begin: desc.start_value is %g, but desc.state has a value",
                        (double)s->desc->start_value);
    }
    result =
        s->desc->state != NULL ? read_state(env, s) : dmi_joint_check(env, SCALED_JOINT, &s->joint, DM_JOINT_UNKNOWN);
    if (result != DM_OK) return result;
    const float lower = s->joint.lower, upper = s->joint.upper;
    if (!bound_limits(&s->joint)) {
        return dmi_fail(
            env, DM_ERROR_INVALID_ARGUMENT,
            "dm_drag_begin: the joint's limits are %g and %g: values beyond %g are too large to compute with",
            (double)lower, (double)upper, (double)dmi_joint_farthest(&s->joint));
    }
    const dmi_rules_start rules = {.joint = &s->joint,
                                   .one_sided = dmi_joint_open_side(&s->joint, s->object_size) != 0,
                                   .object_size = s->object_size};
    result = dmi_rules_read(env, s->desc, &rules, &s->rules);
    if (result != DM_OK) return result;
    return check_value(env, s);
}

/* Returns the pose in which the part is shown. */
static dm_pose shown_pose(const start* s) {
    return s->has_pose ? s->pose : dmi_joint_pose(&s->joint, s->value);
}

/* Takes the middle of the part as the grabbed point. */
static void grab_middle(const start* s, dm_drag_desc* desc) {
    const dm_pose pose = shown_pose(s);
    float middle[3];
    dmi_pose_apply(&pose, dmi_xyz(s->part_centre).v, middle);
    desc->grab_point = dmi_vec3(middle);
}

/* Checks the grabbed point at rest, about which the hypotheses of a drag may turn. */
static dm_result check_rest_point(dmi_env* env, const start* s) {
    static const char* const fields[3] = {": x", ": y", ": z"};
    const dm_pose pose = shown_pose(s), back = dmi_pose_inverse(&pose);
    float rest[3];
    dmi_pose_apply(&back, dmi_xyz(s->desc->grab_point).v, rest);
    return dmi_check_vector(env, "dm_drag_begin: the grabbed point, with the part at rest", fields, rest);
}

static void warn_of_point(dmi_env* env, const start* s) {
    const dm_vec3 p = s->desc->grab_point;
    const float x = p.x - s->centre.x, y = p.y - s->centre.y, z = p.z - s->centre.z;
    const float far = dmi_fmaxf(fabsf(x), dmi_fmaxf(fabsf(y), fabsf(z))) / s->object_size;
    if (!(far > FAR_POINT)) return;
    dmi_warn(env,
             "dm_drag_begin: desc.grab_point (%g, %g, %g) is %.0f object sizes away from the object, which is %g host "
             "units large. Is it in another unit, or in the world's frame?",
             (double)p.x, (double)p.y, (double)p.z, (double)far, (double)s->object_size);
}

static void warn_of_value(dmi_env* env, const start* s) {
    const char* field = s->desc->state != NULL ? "desc.state.value" : "desc.start_value";
    const dm_joint* joint = &s->joint;
    const float value = s->value, beyond = dmi_fmaxf(value - joint->upper, joint->lower - value);
    if (joint->type == DM_JOINT_PRISMATIC && fabsf(value) > FAR_SLIDE * s->object_size) {
        dmi_warn(env,
                 "dm_drag_begin: %s is %g host units, the object is %g large. Were millimetres or another unit meant?",
                 field, (double)value, (double)s->object_size);
    } else if (joint->type == DM_JOINT_REVOLUTE && dmi_joint_has_limits(joint) && beyond > FAR_TURN) {
        dmi_warn(env, "dm_drag_begin: %s is %g rad, the joint ends at %g and %g. Were degrees meant?", field,
                 (double)value, (double)joint->lower, (double)joint->upper);
    }
}

/* ---- hypotheses ---- */

/* Returns the number by which evidence identifies its part. It is never 0. */
static uint32_t evidence_key(const dmi_object* object, uint32_t part) {
    const uint64_t key = dmi_part_key(object, part);
    return (uint32_t)(key ^ key >> 32) | 1;
}

/* Returns whether a part is a push button: small, and sliding a short way to one side of rest only. */
static bool is_button(const start* s) {
    const dm_joint* joint = &s->joint;
    const float range = joint->upper - joint->lower;
    if (joint->type != DM_JOINT_PRISMATIC || !(range > 0) || range > BUTTON_TRAVEL * s->object_size) return false;
    const bool one_way = joint->lower >= -AT_REST_SHARE * range || joint->upper <= AT_REST_SHARE * range;
    return one_way && s->part_size <= BUTTON_SIZE * s->object_size;
}

/* Takes a free range of the object-normalised frame to host units. It is unbounded for an instance that is not scaled
 * evenly, because its part and body no longer have the shape that the range was found with. */
static dmi_free_range free_range_out(const start* s, int32_t type, dmi_free_range inner) {
    if (!(s->scale.x > 0 && s->scale.x == s->scale.y && s->scale.x == s->scale.z)) return dmi_unbounded_range();
    const float length = type == DM_JOINT_PRISMATIC ? s->scale.x * dmi_frame_length_out(&s->object->frame) : 1;
    return (dmi_free_range){dmi_fmaxf(inner.lower * length, -FLT_MAX), dmi_fminf(inner.upper * length, FLT_MAX)};
}

/* Takes a joint of the object-normalised frame to the scaled instance. Returns whether a host may hand in such numbers,
 * because a saved drag must be able to hold them. */
static bool joint_out(const start* s, const dm_joint* inner, dm_joint* out) {
    *out = dmi_frame_joint_out(&s->object->frame, inner);
    dmi_joint_scale(out, s->scale);
    return bound_limits(out) && dmi_joint_check(NULL, "", out, DM_JOINT_UNKNOWN) == DM_OK;
}

/* Adds slides along the axes of the canonical frame. */
static void add_slides(dmi_hypothesis_tracker* tracker, const start* s) {
    const dmi_free_range* ranges = s->object->parts[s->part].alternatives.slides;
    for (int i = 0; i < 3; i++) {
        const dm_joint inner = {.type = DM_JOINT_PRISMATIC, .axis = {i == 0, i == 1, i == 2}};
        dm_joint joint;
        if (!joint_out(s, &inner, &joint)) continue;
        dmi_hypothesis_tracker_add_slide(tracker, joint.axis, free_range_out(s, joint.type, ranges[i]));
    }
}

static void add_alternatives(dmi_hypothesis_tracker* tracker, const start* s) {
    const dmi_alternatives* alternatives = &s->object->parts[s->part].alternatives;
    for (uint32_t i = 0; i < alternatives->count; i++) {
        const dmi_alternative* one = &alternatives->list[i];
        const dm_joint inner = dmi_alternative_joint(one);
        dm_joint joint;
        if (!joint_out(s, &inner, &joint)) continue;
        const dmi_free_range range = free_range_out(s, joint.type, one->free_range);
        dmi_hypothesis_tracker_add_alternative(tracker, &joint, range);
    }
}

/* Returns whether the axes of two joints that are alike point the same way. */
static bool same_direction(const dm_joint* a, const dm_joint* b) {
    return a->axis.x * b->axis.x + a->axis.y * b->axis.y + a->axis.z * b->axis.z > 0;
}

/* Returns whether the host has chosen among the hypotheses, so that no other one is tracked. */
static bool is_chosen(const start* s) {
    return s->joint.source == DM_JOINT_CHOSEN;
}

/* Collects the hypotheses. The instance's own joint or the host's choice comes first, where there is one. A choice has
 * no room on the other side of rest, so that no pull puts its range there. */
static uint32_t collect_hypotheses(const start* s, dm_joint out[DM_MAX_HYPOTHESES],
                                   dmi_free_range out_ranges[DM_MAX_HYPOTHESES]) {
    const dmi_hypotheses* all = &s->object->parts[s->part].hypotheses;
    const bool has_own = s->desc->state != NULL || is_chosen(s);
    uint32_t count = 0;
    if (has_own) {
        out_ranges[count] = is_chosen(s) ? (dmi_free_range){0, 0} : dmi_unbounded_range();
        out[count++] = s->joint;
    }
    if (is_chosen(s)) return count;
    for (uint32_t i = 0; i < all->count && count < DM_MAX_HYPOTHESES; i++) {
        dm_joint joint;
        if (!joint_out(s, &all->joints[i], &joint)) continue;
        const bool again = has_own && dmi_joints_alike(&s->joint, &joint, s->part_size);
        const dmi_free_range range = free_range_out(s, joint.type, all->free_range[i]);
        if (!again) {
            out_ranges[count] = range;
            out[count++] = joint;
        } else {
            out_ranges[0] = same_direction(&s->joint, &joint) ? range : dmi_reversed_range(range);
        }
    }
    return count;
}

/* Returns the up direction in the frame of the scaled instance: the asset's, where it was given. */
static dmi_float3 up_out(const start* s) {
    static const float canonical[3] = {0, 1, 0};
    const float* given = s->object->parts[s->part].asset_hints.up;
    dmi_float3 up;
    dmi_frame_direction_out(&s->object->frame, dmi_dot3(given, given) > 0 ? given : canonical, up.v);
    return up;
}

/* Adds what earlier pulls of the instance have said, and which way is up. */
static void recall_pulls(dmi_drag* drag, const start* s) {
    const dmi_object_part* part = &s->object->parts[s->part];
    dm_joint ranked[DM_MAX_HYPOTHESES];
    uint32_t count = 0;
    while (count < part->hypotheses.count && count < DM_MAX_HYPOTHESES &&
           joint_out(s, &part->hypotheses.joints[count], &ranked[count]))
        count++;
    drag->earlier = dmi_pull_evidence_unpack(s->joint.evidence, evidence_key(s->object, s->part));
    dmi_pull_evidence_recall(&drag->tracker, ranked, count, &drag->earlier);
    dmi_hypothesis_tracker_set_up(&drag->tracker, up_out(s).v);
}

static void track(dmi_drag* drag, const start* s) {
    dm_joint joints[DM_MAX_HYPOTHESES];
    dmi_free_range free_ranges[DM_MAX_HYPOTHESES];
    const uint32_t count = collect_hypotheses(s, joints, free_ranges);
    const dmi_limit_give limit_give = {.share = dmi_clamp(s->desc->limit_give, -1, DMI_LARGEST),
                                       .length = s->object_size};
    dmi_drag_track_hypotheses(drag, joints, free_ranges, count, s->part_size, limit_give);
    if (count == 0 || is_chosen(s)) return;
    add_slides(&drag->tracker, s);
    add_alternatives(&drag->tracker, s);
    recall_pulls(drag, s);
}

/* ---- begin ---- */

/* Starts in the pose in which the part is shown, and blends over to the joint from there. */
static void begin_at_pose(dmi_drag* drag, const start* s, const dm_drag_feel* feel) {
    const dm_pose on_joint = dmi_joint_pose(&s->joint, s->value), back = dmi_pose_inverse(&s->pose);
    float rest[3], grab[3];
    dmi_pose_apply(&back, dmi_xyz(s->desc->grab_point).v, rest);
    dmi_pose_apply(&on_joint, rest, grab);
    dmi_drag_begin(drag, &s->joint, grab, s->value, feel);
    const dm_pose now = dmi_joint_pose(&drag->joint, drag->value);
    drag->blend = dmi_pose_blend_new_joint(&s->pose, &now, drag->rest_point, s->part_size);
    const dmi_float3 shown = dmi_xyz(s->desc->grab_point);
    for (int i = 0; i < 3; i++) drag->point[i] = shown.v[i];
}

static bool same_pose(const dm_pose* a, const dm_pose* b) {
    bool same = true;
    for (int i = 0; i < 4; i++) same = same && a->real[i] == b->real[i] && a->dual[i] == b->dual[i];
    return same;
}

/* Returns where the joint comes from that the drag begins with: DM_BASIS_*. */
static int32_t basis_of(const start* s) {
    if (s->joint.source == DM_JOINT_FROM_HOST) return DM_BASIS_HOST;
    if (is_chosen(s)) return DM_BASIS_CHOSEN;
    dm_joint prepared = s->object->parts[s->part].joint;
    dmi_joint_scale(&prepared, s->scale);
    return dmi_joints_alike(&s->joint, &prepared, s->part_size) ? DM_BASIS_PREPARED : DM_BASIS_PULL;
}

static void begin(dmi_drag_slot* slot, start* s) {
    dm_drag_feel feel = dmi_usable_feel(&s->desc->feel);
    const bool certain = s->desc->flags & DM_DRAG_KEEP_JOINT || s->joint.source == DM_JOINT_FROM_HOST;
    const dm_pose on_joint = dmi_joint_pose(&s->joint, s->value);
    if (!certain && dmi_joint_has_limits(&s->joint)) { /* an earlier drag may have exceeded the estimated limits */
        s->joint.lower = dmi_fminf(s->joint.lower, s->value), s->joint.upper = dmi_fmaxf(s->joint.upper, s->value);
    }
    if (feel.return_time == 0.0f && is_button(s)) feel.return_time = BUTTON_RETURN_TIME;
    slot->scale = s->scale;
    slot->open_side = (int8_t)dmi_joint_open_side(&s->joint, s->object_size);
    slot->value_unit = dmi_joint_value_unit(&s->joint, s->object_size);
    const float unit_share = slot->value_unit / (s->joint.upper - s->joint.lower);
    if (slot->open_side != 0 && feel.soft_limit > 0)
        feel.soft_limit = dmi_clamp(feel.soft_limit * unit_share, DMI_SMALLEST_FEEL, 1);
    if (s->has_pose && !same_pose(&s->pose, &on_joint)) {
        begin_at_pose(&slot->drag, s, &feel);
    } else {
        dmi_drag_begin(&slot->drag, &s->joint, dmi_xyz(s->desc->grab_point).v, s->value, &feel);
    }
    if (!certain) track(&slot->drag, s);
    slot->drag.basis = basis_of(s);
    slot->drag.rules = s->rules;
    if (s->rules.on) dmi_drag_set_rules(&slot->drag, &s->rules);
}

static dm_result publish(dm_context* context, dmi_object_slot* owner, start* s, dm_drag* out_drag) {
    dmi_env* env = &context->env;
    dmi_drag_slot* slot = dmi_alloc_zeroed(env, sizeof *slot, _Alignof(dmi_drag_slot));
    if (slot == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_drag_begin: no memory");
    slot->owner = owner;
    slot->part = s->part;
    begin(slot, s);
    dm_result result = dmi_dependent_add(context, context->drags, &owner->drags, &slot->link);
    if (result != DM_OK) {
        dmi_free(env, slot, sizeof *slot);
        return result;
    }
    *out_drag = slot->link.handle;
    return DM_OK;
}

dm_result DM_CALL dm_drag_begin(dm_context* context, const dm_drag_desc* desc, dm_drag* out_drag) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dm_drag_desc known;
    dm_result result =
        dmi_read_desc(env, "dm_drag_begin: desc", desc, DMI_FIRST_SIZE(dm_drag_desc, reserved), sizeof known, &known);
    if (result != DM_OK) return result;
    if (out_drag == NULL) return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: out_drag is NULL");
    dmi_object_slot* owner = dmi_find(context, context->objects, "dm_drag_begin: desc.object", known.object);
    if (owner == NULL) return DM_ERROR_STALE_HANDLE;
    start s = {.desc = &known, .object = owner->object};
    result = dmi_find_part(context, "dm_drag_begin: desc.part_id", s.object, known.part_id, &s.part);
    if (result == DM_OK) result = check_desc(env, &known);
    if (result == DM_OK) result = read_start(env, &s);
    if (result != DM_OK) return result;
    if (known.flags & DM_DRAG_WITHOUT_POINT) grab_middle(&s, &known);
    result = check_rest_point(env, &s);
    if (result != DM_OK) return result;
    warn_of_point(env, &s);
    warn_of_value(env, &s);
    return publish(context, owner, &s, out_drag);
}

/* ---- update and end ---- */

/* Returns which limit the part is at where only one is a limit, so that there are no shares of the range. */
static int32_t only_limit_at(const dmi_drag_slot* slot) {
    const dm_joint* joint = &slot->drag.joint;
    const float value = slot->drag.value, tolerance = STOP_TOLERANCE * slot->value_unit;
    if (slot->open_side > 0) return value <= joint->lower + tolerance ? -1 : 0;
    return value >= joint->upper - tolerance ? 1 : 0;
}

static dm_result check_state(const dm_drag_state* out_state) {
    return dmi_check_out(DMI_SILENT, "out_state", out_state, DMI_FIRST_SIZE(dm_drag_state, changes));
}

/* Checks a time step. One that rounding has made negative becomes 0. */
static dm_result check_step(float* dt, const dm_drag_state* out_state) {
    dm_result result = dmi_check_finite(DMI_SILENT, "dt", dt, 1);
    if (result != DM_OK) return result;
    if (*dt < -ROUNDED_TIME) return DM_ERROR_INVALID_ARGUMENT;
    *dt = dmi_fmaxf(*dt, 0);
    return check_state(out_state);
}

/* Remembers the first error of a call that may not log, for dmi_drag_slot_warn. Returns the result. */
static dm_result remember(dmi_drag_slot* slot, dm_result result) {
    if (result == DM_OK) return result;
    if (slot->refused++ == 0) slot->first_refusal = result;
    return result;
}

/* Advances by a pointer's ray, or by an input where one is given. */
static void step(dmi_drag_slot* slot, const dm_ray* ray, const dm_drag_input* input, float dt,
                 dm_drag_state* out_state) {
    if (dt > LONG_FRAME && slot->longest_frame == 0) slot->longest_frame = dt;
    dm_drag_state state;
    const uint32_t given = out_state->struct_size;
    /* It is mostly the library's own version, which needs no copy. */
    dm_drag_state* now = given == sizeof state ? out_state : &state;
    if (input == NULL)
        dmi_drag_update(&slot->drag, ray, dt, now);
    else
        dmi_drag_step(&slot->drag, input, dt, now);
    if (slot->open_side != 0) now->at_limit = only_limit_at(slot);
    if (now == &state) dmi_write_out(out_state, &state, sizeof state);
    out_state->struct_size = given;
}

dm_result DM_CALL dm_drag_update(dm_context* context, dm_drag drag, const dm_ray* ray, float dt,
                                 dm_drag_state* out_state) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = DM_OK;
    if (ray != NULL || slot->drag.release.phase == DM_DRAG_HELD) result = dmi_check_ray(DMI_SILENT, "ray", ray);
    if (result == DM_OK) result = check_step(&dt, out_state);
    if (result == DM_OK) step(slot, ray, NULL, dt, out_state);
    return remember(slot, result);
}

dm_result DM_CALL dm_drag_step(dm_context* context, dm_drag drag, const dm_drag_input* input, float dt,
                               dm_drag_state* out_state) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_drag_input known;
    dm_result result = dmi_input_read(&slot->drag, input, &known);
    if (result == DM_OK) result = check_step(&dt, out_state);
    if (result == DM_OK) step(slot, NULL, &known, dt, out_state);
    return remember(slot, result);
}

dm_result DM_CALL dm_drag_take(dm_context* context, dm_drag drag, float value, dm_drag_state* out_state) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = dmi_check_number(DMI_SILENT, "", "value", value);
    if (result == DM_OK) result = check_state(out_state);
    if (result == DM_OK && !slot->drag.pending.open) result = DM_ERROR_INVALID_ARGUMENT;
    if (result != DM_OK) return remember(slot, result);
    dm_drag_state now = {.struct_size = sizeof now};
    dmi_drag_take(&slot->drag, value, &now);
    if (slot->open_side != 0) now.at_limit = only_limit_at(slot);
    dmi_write_out(out_state, &now, sizeof now);
    return DM_OK;
}

void dmi_drag_slot_warn(dmi_env* env, const char* function, dmi_drag_slot* slot) {
    if (slot->refused > 0) {
        dmi_warn(env, "%s: %u updates of this drag were refused, the first with %s", function, slot->refused,
                 dm_result_string(slot->first_refusal));
        slot->refused = 0;
    }
    if (!(slot->longest_frame > 0)) return;
    dmi_warn(env, "%s: an update of this drag had dt %g s. Were milliseconds meant?", function,
             (double)slot->longest_frame);
    slot->longest_frame = -1;
}

static void write_part_state(const dmi_drag_slot* slot, dm_part_state* out_state) {
    const dmi_drag* drag = &slot->drag;
    dm_drag_state now;
    dmi_drag_get_state(drag, &now);
    dm_part_state state = {
        .value = now.value, .velocity = now.velocity, .status = now.status, .pose = now.pose, .joint = drag->joint};
    const uint32_t room = out_state->struct_size - (uint32_t)offsetof(dm_part_state, joint);
    state.joint.struct_size = room < sizeof state.joint ? room : (uint32_t)sizeof state.joint;
    state.joint.joint_confidence = now.joint_confidence;
    if (drag->tracker.round > 0) {
        state.joint.type_confidence = dmi_hypothesis_tracker_type_confidence(&drag->tracker);
        const dmi_pull_evidence evidence = dmi_pull_evidence_collect(&drag->tracker, &drag->earlier);
        dmi_pull_evidence_pack(&evidence, evidence_key(slot->owner->object, slot->part), state.joint.evidence);
    }
    dmi_write_out(out_state, &state, sizeof state);
}

static dm_result check_part_state(dmi_env* env, const char* what, const dm_part_state* out_state) {
    return dmi_check_out(env, what, out_state, FIRST_PART_STATE);
}

dm_result DM_CALL dm_drag_end(dm_context* context, dm_drag drag, dm_part_state* out_state) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    if (out_state != NULL) {
        dm_result result = check_part_state(env, "dm_drag_end: out_state", out_state);
        if (result != DM_OK) return result;
    }
    dmi_drag_slot* slot = dmi_take(context, context->drags, "dm_drag_end", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (out_state != NULL) write_part_state(slot, out_state);
    dmi_drag_slot_warn(env, "dm_drag_end", slot);
    dmi_dependent_unlink(context, &slot->owner->drags, &slot->link);
    dmi_free(env, slot, sizeof *slot);
    return DM_OK;
}

dm_result DM_CALL dm_drag_get_part_state(dm_context* context, dm_drag drag, dm_part_state* out_state) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_drag_slot* slot = dmi_pool_get(context->drags, drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = check_part_state(DMI_SILENT, "out_state", out_state);
    if (result == DM_OK) write_part_state(slot, out_state);
    return result;
}
