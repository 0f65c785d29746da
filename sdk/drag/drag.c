/* One drag, update by update. The pointer's ray asks for a joint value (follow.h), which moves at a limited rate where
 * that is ill-posed. The feel (drag_feel.h) makes a joint value of it, and the host's rules (drag_rules.h) hold that
 * back. The hypothesis tracker chooses the joint meanwhile. After the release the plan moves the part
 * (release.h). */
#include "drag/drag_pointer.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* Shortest update, s; by hand. A shorter one counts as none, so that a step divided by its time stays in a float's
 * range.
 */
#define SHORTEST_TIME 1e-9f
#define LIMIT_TOLERANCE 1e-4f /* share of the range that counts as at a limit; by hand */

static const dmi_constraints unconstrained = {.bounds = {-INFINITY, INFINITY}};

void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel) {
    *drag = (dmi_drag){.joint = *joint, .feel = *feel, .first_confidence = joint->joint_confidence};
    dm_pose pose = dmi_joint_pose(joint, start_value), back = dmi_pose_inverse(&pose);
    dmi_pose_apply(&back, grab_point, drag->rest_point);
    drag->value = drag->target = dmi_joint_clamp(joint, start_value);
    dmi_drag_measure_span(drag);
    drag->pointer_value = dmi_drag_pointer_value(drag, drag->target);
    drag->blend = dmi_pose_blend_none();
    drag->release.return_time = dmi_fmaxf(feel->return_time, 0);
    dmi_drag_measure_speed(drag);
    drag->constraints = unconstrained;
    drag->asked = drag->target;
    memcpy(drag->point, grab_point, sizeof drag->point);
    if (drag->value == start_value) return;
    const dm_pose inside = dmi_joint_pose(joint, drag->value); /* the same value inside the joint's limits */
    drag->blend = dmi_pose_blend_same_joint(&pose, &inside);
}

/* Follows the plain pointer. Returns true when the joint has changed. */
static bool follow_pointer(dmi_drag* drag, const dm_ray* ray, float dt) {
    const float nearest = dmi_drag_nearest(drag, ray);
    dmi_drag_move_pointer(drag, nearest, dmi_drag_ray_motion(drag, ray), dt);
    dmi_drag_ask(drag);
    drag->last_ray = *ray;
    return drag->tracker.count > 0 && dmi_drag_track(drag, nearest, ray);
}

static void update_held(dmi_drag* drag, const dm_ray* ray, float dt) {
    float before = drag->target;
    dm_ray unit;
    if (ray != NULL && dmi_drag_read_ray(drag, ray, &unit) && follow_pointer(drag, &unit, dt)) before = drag->target;
    drag->target = drag->asked;
    if (drag->rules.on) dmi_drag_hold_back(drag, before, dt);
    dmi_feel_follow(&drag->feel, &drag->joint, before, drag->target, dt, &drag->value, &drag->velocity);
}

static int32_t limit_at(const dm_joint* joint, float value) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float tolerance = LIMIT_TOLERANCE * (joint->upper - joint->lower);
    return value >= joint->upper - tolerance ? 1 : value <= joint->lower + tolerance ? -1 : 0;
}

void dmi_drag_get_state(const dmi_drag* drag, dm_drag_state* out_state) {
    const dm_pose pose = dmi_drag_shown_pose(drag);
    float grab[3];
    dmi_pose_apply(&pose, drag->rest_point, grab);
    out_state->pose = pose;
    out_state->grab_point = dmi_vec3(grab);
    out_state->value = drag->value;
    out_state->target = drag->target;
    out_state->velocity = drag->velocity;
    out_state->at_limit = limit_at(&drag->joint, drag->value);
    out_state->phase = drag->release.phase;
    out_state->changes = drag->changes;
    out_state->events = out_state->detents = 0;
    out_state->impact = 0;
    out_state->status = dmi_drag_status(drag);
    out_state->joint_confidence = drag->tracker.round > 0 ? drag->tracker.confidence : drag->first_confidence;
    out_state->open_share = dmi_clamp((drag->value - drag->closed) / drag->open_way, 0, 1);
    out_state->joint_basis = drag->changes > 0 ? DM_BASIS_PULL : drag->basis;
}

/* Tells where the part is after an update, and remembers where it is shown. */
static void write_state(dmi_drag* drag, dm_drag_state* out_state) {
    dmi_drag_get_state(drag, out_state);
    if (drag->rules.on) dmi_drag_write_events(drag, out_state);
    const dm_vec3 grab = out_state->grab_point;
    drag->point[0] = grab.x, drag->point[1] = grab.y, drag->point[2] = grab.z;
}

/* Returns the time that an update advances, s. */
static float time_of(float dt) {
    return dt >= SHORTEST_TIME && isfinite(dt) ? dmi_fminf(dt, DMI_LARGEST_TIME) : 0;
}

/* Begins an update, before the hand is read. */
static void begin_update(dmi_drag* drag, float time) {
    drag->pending.open = false;
    drag->blend.age += time;
    if (drag->rules.on) dmi_drag_note_start(drag);
}

/* Ends an update. ray: the ray of a plain pointer; NULL when there is none, or when dmi_drag_aim has read the hands. */
static void finish_update(dmi_drag* drag, const dm_ray* ray, float time, dm_drag_state* out_state) {
    if (drag->release.phase == DM_DRAG_HELD) {
        update_held(drag, ray, time);
    } else if (drag->release.phase == DM_DRAG_RELEASED) {
        dmi_drag_update_released(drag, time);
    }
    drag->velocity = dmi_clamp_within(drag->velocity, DMI_LARGEST_RATE);
    if (drag->rules.on) dmi_drag_keep_rules(drag, time);
    write_state(drag, out_state);
}

/* Changes how a hand holds the part. Its offset is measured anew. */
static void change_hand(dmi_drag* drag, int32_t kind) {
    const dm_vec3 none = {0, 0, 0};
    if (drag->hands.kind != DM_HAND_NONE) drag->last_ray.direction = drag->grab_offset = none;
    drag->hands.has_offset = false;
    drag->hands.kind = kind;
}

void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state) {
    const float time = time_of(dt);
    begin_update(drag, time);
    if (ray != NULL && drag->hands.kind > DM_HAND_RAY) change_hand(drag, DM_HAND_RAY);
    finish_update(drag, ray, time, out_state);
}

/* Returns whether an input has more than the one pointer that dmi_drag_update follows. */
static bool needs_aim(const dmi_drag* drag, const dm_drag_input* input) {
    return drag->release.phase == DM_DRAG_HELD &&
           (input->hand.kind > DM_HAND_RAY || input->second.kind != DM_HAND_NONE || drag->hands.second.on ||
            drag->hands.bias != 0);
}

static void read_constraints(dmi_drag* drag, const dm_drag_input* input) {
    if (input->lower < input->upper || input->flags & DM_INPUT_BOUNDS)
        drag->constraints.bounds = (dmi_bounds){input->lower, input->upper};
    drag->constraints.locked = (input->flags & DM_INPUT_LOCKED) != 0;
    memcpy(drag->constraints.handles, input->handles, sizeof drag->constraints.handles);
    if (input->hand.kind == DM_HAND_NONE && drag->hands.kind == DM_HAND_RATE)
        drag->hands.pressed = 0; /* the key has been let go of */
    if (input->hand.kind != DM_HAND_NONE && input->hand.kind != drag->hands.kind) change_hand(drag, input->hand.kind);
}

void dmi_drag_step(dmi_drag* drag, const dm_drag_input* input, float dt, dm_drag_state* out_state) {
    const float time = time_of(dt), start = drag->value;
    const dmi_event_state event_state = drag->event_state;
    const int32_t phase = drag->release.phase;
    const bool aims = needs_aim(drag, input);
    read_constraints(drag, input);
    begin_update(drag, time);
    if (aims) dmi_drag_aim(drag, input, time);
    finish_update(drag, !aims && input->hand.kind == DM_HAND_RAY ? &input->hand.ray : NULL, time, out_state);
    drag->pending = (dmi_pending_value){.open = (input->flags & DM_INPUT_ASK) != 0,
                                        .start = start,
                                        .dt = time,
                                        .lower = dmi_fminf(drag->constraints.bounds.lower, drag->value),
                                        .upper = dmi_fmaxf(drag->constraints.bounds.upper, drag->value),
                                        .phase = phase,
                                        .event_state = event_state};
    drag->constraints = unconstrained;
}

/* Puts the part at another value than the plan's. That holds a released part up, also one that has just arrived. */
static void take_instead(dmi_drag* drag, float value) {
    const dmi_pending_value* pending = &drag->pending;
    const bool same_joint = drag->changes == pending->event_state.changes;
    if (pending->dt > 0)
        drag->velocity = same_joint ? dmi_clamp_within((value - pending->start) / pending->dt, DMI_LARGEST_RATE) : 0;
    drag->value = value;
    drag->landing = (dmi_landing){0};
    if (pending->phase == DM_DRAG_RELEASED) drag->release.phase = DM_DRAG_RELEASED;
    drag->stalled = drag->release.phase == DM_DRAG_RELEASED;
    if (drag->release.phase == DM_DRAG_AT_REST) drag->velocity = 0;
}

void dmi_drag_take(dmi_drag* drag, float value, dm_drag_state* out_state) {
    const dmi_pending_value* pending = &drag->pending;
    const float kept = dmi_joint_clamp(&drag->joint, dmi_fminf(dmi_fmaxf(value, pending->lower), pending->upper));
    if (kept != drag->value) take_instead(drag, kept);
    drag->pending.open = false;
    if (drag->rules.on) dmi_drag_find_events_again(drag);
    write_state(drag, out_state);
}
