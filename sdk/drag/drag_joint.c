/* The joint that a drag follows: its limits between pointer value and target, the pose that it shows, and the change to
 * another hypothesis. This file alone writes the drag's joint, its limits and its tracker. */
#include <math.h>

#include "drag/drag_internal.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* Share of the part's size; a grabbed point farther from rest has been moved. By hand. */
#define OPEN_SHARE 0.006f

void dmi_drag_measure_speed(dmi_drag* drag) {
    float v[3];
    dmi_joint_velocity(&drag->joint, 0, drag->rest_point, v);
    drag->speed = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
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

dm_pose dmi_drag_shown_pose(const dmi_drag* drag) {
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
    const dm_pose before = dmi_drag_shown_pose(drag);
    drag->joint = best->joint;
    drag->pointer_value = dmi_clamp_within(best->pointer_value, DMI_LARGEST);
    init_estimated_limits(drag);
    dmi_drag_ask(drag);
    drag->target = drag->value = first_value(drag, &before);
    drag->velocity = 0;
    dmi_drag_measure_speed(drag);
    const dm_pose now = dmi_joint_pose(&drag->joint, drag->value);
    drag->blend = dmi_pose_blend_new_joint(&before, &now, drag->rest_point, drag->tracker.grasp.size);
    drag->lag = drag->target - drag->asked;
    drag->start.value = drag->value, drag->start.velocity = 0; /* the update goes on from there */
    drag->changes++;
}

bool dmi_drag_track(dmi_drag* drag, float nearest, const dm_ray* ray) {
    if (drag->rules.on && dmi_latch_holds(&drag->latch)) return false; /* that it is held says nothing of its joint */
    if (!dmi_hypothesis_tracker_update(&drag->tracker, nearest, ray, drag->projection)) return false;
    change_joint(drag);
    return true;
}
