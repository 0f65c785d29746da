/* One drag, update by update: pointer ray -> joint value it asks for (follow.h), rate-limited where that is ill-posed
 * -> feel (drag_feel.h) -> joint value, held back by the host's rules (drag_bounds.h). The hypothesis tracker chooses
 * the joint meanwhile; after the release the plan moves the part (drag_release.h). */
#include "motion/drag_pointer.h"

#include <math.h>
#include <string.h>

#include "base/number_bounds.h"
#include "math/constants.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "math/vec3.h"

/* By hand. */
#define LIMIT_TOLERANCE 1e-4f /* share of the range that counts as at a limit */
#define OPEN_SHARE 0.006f     /* of the part's size: a grabbed point farther from rest has been moved */
#define SHORTEST_TIME 1e-9f   /* s: a shorter update is none, so that a step over its time stays in a float's range */

static const dmi_constraints unconstrained = {.bounds = {-INFINITY, INFINITY}};

/* Returns the speed of the grabbed point, host units a unit of the joint value. */
static float speed_of(const dm_joint* joint, const float rest_point[3]) {
    float v[3];
    dmi_joint_velocity(joint, 0, rest_point, v);
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

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
    drag->speed = speed_of(joint, drag->rest_point);
    drag->constraints = unconstrained;
    drag->asked = drag->target;
    memcpy(drag->point, grab_point, sizeof drag->point);
    if (drag->value == start_value) return;
    const dm_pose inside = dmi_joint_pose(joint, drag->value); /* it stands outside its limits */
    drag->blend = dmi_pose_blend_same_joint(&pose, &inside);
}

/* Treats the joint's limits as estimates. */
static void init_estimated_limits(dmi_drag* drag) {
    const dmi_limit_give limit_give = drag->tracker.grasp.limit_give;
    drag->limits_are_estimates = dmi_joint_has_limits(&drag->joint) && limit_give.share >= 0;
    drag->estimated_lower = drag->joint.lower, drag->estimated_upper = drag->joint.upper;
    dmi_joint_reachable_range(&drag->joint, limit_give, &drag->reachable_lower, &drag->reachable_upper);
    dmi_drag_measure_span(drag);
}

void dmi_drag_track_hypotheses(dmi_drag* drag, const dm_joint* joints, const dmi_free_range* free_ranges,
                               uint32_t count, float size, dmi_limit_give limit_give) {
    dmi_hypothesis_tracker_init(&drag->tracker, joints, free_ranges, count, drag->rest_point, size, limit_give);
    drag->tracker.grasp.was_open = dmi_distance3(drag->rest_point, drag->point) > OPEN_SHARE * size;
    init_estimated_limits(drag);
    drag->pointer_value = dmi_drag_pointer_value(drag, drag->target);
}

/* Lets the limits move along to a value that the hand asks for, as far as the host's bounds let the part go there. */
static void move_limits(dmi_drag* drag, float value) {
    const dmi_bounds bounds = drag->constraints.bounds;
    drag->joint.lower = dmi_fminf(drag->joint.lower, dmi_fmaxf(value, bounds.lower));
    drag->joint.upper = dmi_fmaxf(drag->joint.upper, dmi_fminf(value, bounds.upper));
}

/* Returns the target for a pointer value; estimated limits move along when it exceeds them and nothing holds the part.
 */
static float target_at(dmi_drag* drag, float pointer_value) {
    const float asked = drag->rules.on ? dmi_snaps_pull(&drag->rules.snaps, pointer_value) : pointer_value;
    if (!drag->limits_are_estimates) return dmi_feel_target(&drag->feel, &drag->joint, asked);
    const float target = dmi_feel_soft_target(&drag->feel, dmi_joint_closed(&drag->joint), drag->estimated_lower,
                                              drag->estimated_upper, asked);
    const float kept = dmi_fminf(dmi_fmaxf(target, drag->reachable_lower), drag->reachable_upper);
    if (drag->rules.on && dmi_latch_holds(&drag->latch)) return kept;
    move_limits(drag, kept);
    return kept;
}

float dmi_drag_pointer_value(const dmi_drag* drag, float value) {
    const float unsnapped = drag->limits_are_estimates
                                ? dmi_feel_soft_pointer_value(&drag->feel, dmi_joint_closed(&drag->joint), value)
                                : dmi_feel_pointer_value(&drag->feel, &drag->joint, value);
    return dmi_snaps_invert(&drag->rules.snaps, unsnapped);
}

dm_joint dmi_drag_found_joint(const dmi_drag* drag) {
    dm_joint joint = drag->joint;
    if (drag->limits_are_estimates) joint.lower = drag->estimated_lower, joint.upper = drag->estimated_upper;
    return joint;
}

void dmi_drag_measure_span(dmi_drag* drag) {
    const dm_joint found = dmi_drag_found_joint(drag);
    drag->pointer_span = (dmi_span){-INFINITY, INFINITY};
    drag->closed = dmi_joint_closed(&found);
    drag->open_way = INFINITY;
    if (!dmi_joint_has_limits(&found)) return;
    drag->open_way = dmi_joint_opened(&found) - drag->closed;
    drag->pointer_span =
        (dmi_span){dmi_drag_pointer_value(drag, found.lower), dmi_drag_pointer_value(drag, found.upper)};
}

void dmi_drag_ask(dmi_drag* drag) {
    drag->asked = target_at(drag, drag->pointer_value);
}

static dm_pose shown_pose(const dmi_drag* drag) {
    const dm_pose pose = dmi_joint_pose(&drag->joint, drag->value);
    return dmi_pose_blend_apply(&drag->blend, &pose, drag->rest_point);
}

/* Returns the value at which the part begins on another joint: what the hand asks for, inside the host's bounds. Where
 * the rules limit its speed, the value that is nearest to where the part is shown instead, from which it goes on. */
static float first_value(const dmi_drag* drag, const dm_pose* shown) {
    const bool limited = drag->rules.on && (drag->rules.max_speed > 0 || drag->rules.max_acceleration > 0);
    const float value = limited ? dmi_joint_project(&drag->joint, shown, drag->asked) : drag->asked;
    return dmi_joint_clamp(&drag->joint, dmi_bounds_clamp(drag->constraints.bounds, value));
}

/* Switches to the most probable hypothesis at the value that the pointer asks for; the shown pose blends over. */
static void change_joint(dmi_drag* drag) {
    const dmi_joint_hypothesis* best = &drag->tracker.list[drag->tracker.best];
    const dm_pose before = shown_pose(drag);
    drag->joint = best->joint;
    drag->pointer_value = dmi_clamp_within(best->pointer_value, DMI_LARGEST);
    init_estimated_limits(drag);
    dmi_drag_ask(drag);
    drag->target = drag->value = first_value(drag, &before);
    drag->velocity = 0;
    drag->speed = speed_of(&drag->joint, drag->rest_point);
    const dm_pose now = dmi_joint_pose(&drag->joint, drag->value);
    drag->blend = dmi_pose_blend_new_joint(&before, &now, drag->rest_point, drag->tracker.grasp.size);
    drag->lag = drag->target - drag->asked;
    drag->start.value = drag->value, drag->start.velocity = 0; /* the update goes on from there */
    drag->changes++;
}

/* Returns true when the joint has changed. */
bool dmi_drag_track(dmi_drag* drag, float nearest, const dm_ray* ray) {
    if (drag->rules.on && dmi_latch_holds(&drag->latch)) return false; /* that it is held says nothing of its joint */
    if (!dmi_hypothesis_tracker_update(&drag->tracker, nearest, ray, drag->projection)) return false;
    change_joint(drag);
    return true;
}

/* Follows the plain pointer. Returns true when the joint has changed. */
static bool follow(dmi_drag* drag, const dm_ray* ray, float dt) {
    const float nearest = dmi_drag_nearest(drag, ray);
    dmi_drag_move_pointer(drag, nearest, dmi_drag_ray_motion(drag, ray), dt);
    dmi_drag_ask(drag);
    drag->last_ray = *ray;
    return drag->tracker.count > 0 && dmi_drag_track(drag, nearest, ray);
}

static void update_held(dmi_drag* drag, const dm_ray* ray, float dt) {
    float before = drag->target;
    dm_ray unit;
    if (ray != NULL && dmi_drag_read_ray(drag, ray, &unit) && follow(drag, &unit, dt)) before = drag->target;
    drag->target = drag->asked;
    if (drag->rules.on) dmi_drag_hold_back(drag, before, dt);
    dmi_feel_follow(&drag->feel, &drag->joint, before, drag->target, dt, &drag->value, &drag->velocity);
}

static dmi_released_part released_part(const dmi_drag* drag) {
    return (dmi_released_part){.joint = &drag->joint,
                               .feel = &drag->feel,
                               .rules = &drag->rules,
                               .value = drag->value,
                               .velocity = drag->velocity,
                               .side = drag->open_side};
}

bool dmi_drag_is_open(const dmi_drag* drag) {
    const dmi_released_part part = released_part(drag);
    return dmi_release_is_open(&part);
}

void dmi_drag_plan(dmi_drag* drag, int32_t intent, float duration) {
    const dmi_released_part part = released_part(drag);
    dmi_release_begin(&drag->release, &part, intent, duration);
    if (intent != DM_INTENT_REPLAY) return;
    drag->value = drag->release.start;
    drag->velocity = drag->release.velocity;
}

/* Plans the rest of a motion that something has held up, in the time that it had left. */
static void plan_again(dmi_drag* drag) {
    dmi_release* release = &drag->release;
    const float left = release->duration - release->elapsed;
    dmi_drag_plan(drag, release->intent, 0);
    if (release->phase == DM_DRAG_RELEASED && !release->flies && left > release->duration)
        dmi_drag_plan(drag, release->intent, left);
}

static void update_released(dmi_drag* drag, float dt) {
    dmi_release* release = &drag->release;
    if (drag->stalled && !release->flies) plan_again(drag);
    drag->stalled = false;
    if (release->phase != DM_DRAG_RELEASED) return;
    const dmi_released_part part = released_part(drag);
    if (release->flies)
        drag->landing = dmi_release_fly(release, &part, dt, &drag->value, &drag->velocity);
    else
        dmi_release_advance(release, &drag->feel, &drag->joint, dt, &drag->value, &drag->velocity);
    if (drag->rules.on) dmi_drag_close(drag, dt);
    drag->asked = drag->target = release->end;
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

/* Before the hand is read. */
static void begin_update(dmi_drag* drag, float time) {
    drag->pending.open = false;
    drag->blend.age += time;
    if (drag->rules.on) dmi_drag_note_start(drag);
}

/* ray: of a plain pointer; NULL when there is none, or when dmi_drag_aim has read the hands. */
static void finish_update(dmi_drag* drag, const dm_ray* ray, float time, dm_drag_state* out_state) {
    if (drag->release.phase == DM_DRAG_HELD) {
        update_held(drag, ray, time);
    } else if (drag->release.phase == DM_DRAG_RELEASED) {
        update_released(drag, time);
    }
    drag->velocity = dmi_clamp_within(drag->velocity, DMI_LARGEST_RATE);
    if (drag->rules.on) dmi_drag_keep_rules(drag, time);
    write_state(drag, out_state);
}

/* A hand takes hold in another way: its offset is measured anew. */
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

/* Whether an input has more than the one pointer that dmi_drag_update follows. */
static bool needs_aim(const dmi_drag* drag, const dm_drag_input* input) {
    return drag->release.phase == DM_DRAG_HELD &&
           (input->hand.kind > DM_HAND_RAY || input->second.kind != DM_HAND_NONE || drag->hands.second.on ||
            drag->hands.bias != 0);
}

static void tell(dmi_drag* drag, const dm_drag_input* input) {
    if (input->lower < input->upper || input->flags & DM_INPUT_BOUNDS)
        drag->constraints.bounds = (dmi_bounds){input->lower, input->upper};
    drag->constraints.locked = (input->flags & DM_INPUT_LOCKED) != 0;
    memcpy(drag->constraints.handles, input->handles, sizeof drag->constraints.handles);
    if (input->hand.kind == DM_HAND_NONE && drag->hands.kind == DM_HAND_RATE) drag->hands.pressed = 0; /* let go of */
    if (input->hand.kind != DM_HAND_NONE && input->hand.kind != drag->hands.kind) change_hand(drag, input->hand.kind);
}

void dmi_drag_step(dmi_drag* drag, const dm_drag_input* input, float dt, dm_drag_state* out_state) {
    const float time = time_of(dt), start = drag->value;
    const dmi_event_state event_state = drag->event_state;
    const int32_t phase = drag->release.phase;
    const bool aims = needs_aim(drag, input);
    tell(drag, input);
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

/* Another value than that of the plan holds a released part up, also one that has just arrived. */
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

static int32_t limit_at(const dm_joint* joint, float value) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float tolerance = LIMIT_TOLERANCE * (joint->upper - joint->lower);
    return value >= joint->upper - tolerance ? 1 : value <= joint->lower + tolerance ? -1 : 0;
}

void dmi_drag_get_state(const dmi_drag* drag, dm_drag_state* out_state) {
    const dm_pose pose = shown_pose(drag);
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

void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration) {
    drag->stalled = drag->pending.open = false;
    drag->waited = 0;
    drag->stays = intent == DM_INTENT_STAY;
    dmi_drag_plan(drag, intent, duration);
    if (drag->rules.on) dmi_drag_close(drag, 0);
    if (drag->release.phase == DM_DRAG_AT_REST) drag->velocity = 0;
}
