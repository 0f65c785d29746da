/* One drag, update by update: pointer ray -> joint value it asks for (follow.h), rate-limited where that is ill-posed
 * -> feel (drag_feel.h) -> joint value, held back by the host's rules (drag_bounds.h). The hypothesis tracker chooses
 * the joint meanwhile; after the release the plan moves the part (drag_release.h). */
#include "motion/drag_keep.h"

#include <math.h>
#include <string.h>

#include "math/constants.h"
#include "math/vec3.h"

/* Largest step of the grabbed point that one update makes whole, as a multiple of the pointer's own. By hand: where the
 * path runs within 1/16 rad of the ray, less than that decides where on it the pointer is. */
#define MAX_GAIN 16.0f
#define GLIDE_GAIN 2.0f         /* the same on the way to a place that is farther off than that; by hand */
#define CATCH_UP_HALF_LIFE 0.1f /* s in which half of what is left is made up for; by hand */
#define MAX_GLIDE 6.0f          /* rad/s of a turn's share of that; by hand, so that no frame shows a jump */
#define MIN_RAY_TURN 1e-5f      /* rad between two rays: rounding makes less, a pixel makes more; by hand */
#define MAX_GRAB_OFFSET 0.025f  /* rad, as seen from the ray's origin: about 20 pixels of a usual screen; by hand */
#define LIMIT_TOLERANCE 1e-4f   /* share of the range that counts as at a limit; by hand */

/* Returns the speed of the grabbed point, host units a unit of the joint value. */
static float speed_of(const dm_joint* joint, const float rest_point[3]) {
    float v[3];
    dmi_joint_velocity(joint, 0, rest_point, v);
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel) {
    *drag = (dmi_drag){.joint = *joint, .feel = *feel};
    dm_pose pose = dmi_joint_pose(joint, start_value), back = dmi_pose_inverse(&pose);
    dmi_pose_apply(&back, grab_point, drag->rest_point);
    drag->value = drag->target = dmi_joint_clamp(joint, start_value);
    drag->pointer_value = dmi_feel_pointer_value(feel, joint, drag->target);
    drag->blend = dmi_pose_blend_none();
    drag->release.return_time = fmaxf(feel->return_time, 0);
    drag->speed = speed_of(joint, drag->rest_point);
    drag->bounds = dmi_no_bounds();
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
}

void dmi_drag_track_hypotheses(dmi_drag* drag, const dm_joint* joints, const dmi_free_range* free_ranges,
                               uint32_t count, float size, dmi_limit_give limit_give) {
    dmi_hypothesis_tracker_init(&drag->tracker, joints, free_ranges, count, drag->rest_point, size, limit_give);
    init_estimated_limits(drag);
}

/* Returns the target for a pointer value; estimated limits move along when it exceeds them and nothing holds the part.
 */
static float target_at(dmi_drag* drag, float pointer_value) {
    const float asked = drag->rules.on ? dmi_snaps_pull(&drag->rules.snaps, pointer_value) : pointer_value;
    if (!drag->limits_are_estimates) return dmi_feel_target(&drag->feel, &drag->joint, asked);
    const float target = dmi_feel_soft_target(&drag->feel, drag->estimated_lower, drag->estimated_upper, asked);
    const float kept = fminf(fmaxf(target, drag->reachable_lower), drag->reachable_upper);
    const float reached = drag->rules.on ? dmi_bounds_clamp(drag->bounds, kept) : kept;
    drag->joint.lower = fminf(drag->joint.lower, reached), drag->joint.upper = fmaxf(drag->joint.upper, reached);
    return kept;
}

/* Copies the ray with a unit direction; false when it is not finite or has no direction. */
static bool normalize_ray(const dm_ray* ray, dm_ray* out) {
    const dm_vec3 o = ray->origin, d = ray->direction;
    if (!isfinite(o.x) || !isfinite(o.y) || !isfinite(o.z)) return false;
    const float most = fmaxf(fabsf(d.x), fmaxf(fabsf(d.y), fabsf(d.z)));
    if (!(most > 0) || !isfinite(d.x) || !isfinite(d.y) || !isfinite(d.z)) return false;
    const float x = d.x / most, y = d.y / most, z = d.z / most, length = sqrtf(x * x + y * y + z * z);
    *out = (dm_ray){o, {x / length, y / length, z / length}};
    return true;
}

static bool has_turned(dm_vec3 a, dm_vec3 b) {
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z > MIN_RAY_TURN * MIN_RAY_TURN;
}

static bool has_last_ray(const dmi_drag* drag) {
    const dm_vec3 d = drag->last_ray.direction;
    return d.x != 0 || d.y != 0 || d.z != 0;
}

/* Remembers by how much the first ray misses the grabbed point: the player took hold of it beside the pointer. A ray
 * that passes farther off has moved since the grab. */
static void measure_grab_offset(dmi_drag* drag, const dm_ray* ray) {
    float now[3], offset[3], square = 0, reach = 0;
    dmi_ray_closest_point(ray, drag->point, now);
    const dmi_float3 eye = dmi_xyz(ray->origin);
    for (int i = 0; i < 3; i++) {
        offset[i] = drag->point[i] - now[i];
        square += offset[i] * offset[i];
        reach += (drag->point[i] - eye.v[i]) * (drag->point[i] - eye.v[i]);
    }
    if (square <= MAX_GRAB_OFFSET * MAX_GRAB_OFFSET * reach) drag->grab_offset = dmi_vec3(offset);
}

static void add_grab_offset(const dmi_drag* drag, dm_ray* ray) {
    ray->origin.x += drag->grab_offset.x;
    ray->origin.y += drag->grab_offset.y;
    ray->origin.z += drag->grab_offset.z;
}

/* Returns how far the pointer moved since the last update, host units at the grabbed point. Before the first update it
 * lay on the point. */
static float pointer_motion(const dmi_drag* drag, const dm_ray* ray) {
    float before[3], now[3], sum = 0;
    dmi_ray_closest_point(ray, drag->point, now);
    if (has_last_ray(drag)) {
        dmi_ray_closest_point(&drag->last_ray, drag->point, before);
    } else {
        memcpy(before, drag->point, sizeof before);
    }
    for (int i = 0; i < 3; i++) sum += (now[i] - before[i]) * (now[i] - before[i]);
    return sqrtf(sum);
}

/* Returns the pointer value after dt, on its way to `nearest`: there at once when that is at most MAX_GAIN times the
 * pointer's own motion away, else it glides there, GLIDE_GAIN times that motion and a share of the rest. */
static float limit_gain(const dmi_drag* drag, const dm_ray* ray, float nearest, float dt) {
    const float gap = nearest - drag->pointer_value;
    const float motion = pointer_motion(drag, ray) / drag->speed;
    const float at_once = fabsf(gap) <= MAX_GAIN * motion ? fabsf(gap) : GLIDE_GAIN * motion;
    const float rest = (fabsf(gap) - at_once) * (1 - expf(-DMI_LN_2_F * dt / CATCH_UP_HALF_LIFE));
    const float step = at_once + (dmi_joint_turns(drag->joint.type) ? fminf(rest, MAX_GLIDE * dt) : rest);
    return isfinite(step) ? drag->pointer_value + copysignf(step, gap) : drag->pointer_value;
}

/* Whether the joint is a slide seen end on: the pointer does not show its value, so it is no evidence against its
 * limits. */
static bool is_unseen_slide(const dmi_drag* drag, const dm_ray* ray) {
    float sight[3], eye_distance;
    if (drag->joint.type != DM_JOINT_PRISMATIC) return false;
    dmi_line_of_sight(drag->rest_point, ray, drag->projection, sight, &eye_distance);
    return dmi_is_seen_end_on(&drag->joint, drag->rest_point, sight);
}

/* Follows a ray; returns the joint value nearest to it, before the rate limit. */
static float follow(dmi_drag* drag, const dm_ray* ray, float dt) {
    /* Rays that never turn come from an orthographic camera; the first one passes the point and suits either. */
    if (has_last_ray(drag) && has_turned(drag->last_ray.direction, ray->direction)) drag->projection = DMI_PERSPECTIVE;
    float lower = -INFINITY, upper = INFINITY;
    if (drag->limits_are_estimates) {
        const bool held = is_unseen_slide(drag, ray);
        lower = held ? drag->estimated_lower : drag->reachable_lower;
        upper = held ? drag->estimated_upper : drag->reachable_upper;
    } else if (dmi_joint_has_limits(&drag->joint)) {
        const float w = dmi_feel_soft_width(&drag->feel, &drag->joint);
        lower = drag->joint.lower - w, upper = drag->joint.upper + w;
    }
    const float nearest =
        dmi_follow_ray(&drag->joint, drag->rest_point, ray, drag->projection, drag->pointer_value, lower, upper);
    drag->pointer_value = limit_gain(drag, ray, nearest, dt);
    drag->target = target_at(drag, drag->pointer_value);
    drag->last_ray = *ray;
    return nearest;
}

static dm_pose shown_pose(const dmi_drag* drag) {
    const dm_pose pose = dmi_joint_pose(&drag->joint, drag->value);
    return dmi_pose_blend_apply(&drag->blend, &pose, drag->rest_point);
}

/* Switches to the most probable hypothesis at the value that the pointer asks for; the shown pose blends over. */
static void change_joint(dmi_drag* drag) {
    const dmi_joint_hypothesis* best = &drag->tracker.list[drag->tracker.best];
    const dm_pose before = shown_pose(drag);
    drag->joint = best->joint;
    drag->pointer_value = best->pointer_value;
    init_estimated_limits(drag);
    drag->target = drag->value = target_at(drag, drag->pointer_value);
    drag->velocity = 0;
    drag->speed = speed_of(&drag->joint, drag->rest_point);
    const dm_pose now = dmi_joint_pose(&drag->joint, drag->value);
    drag->blend = dmi_pose_blend_new_joint(&before, &now, drag->rest_point, drag->tracker.grasp.size);
    drag->lag = 0;
    drag->changes++;
}

static void update_held(dmi_drag* drag, const dm_ray* ray, float dt) {
    float before = drag->target;
    dm_ray unit;
    if (ray != NULL && normalize_ray(ray, &unit)) {
        if (!has_last_ray(drag)) measure_grab_offset(drag, &unit);
        add_grab_offset(drag, &unit);
        const float nearest = follow(drag, &unit, dt);
        if (dmi_hypothesis_tracker_update(&drag->tracker, nearest, &unit, drag->projection)) {
            change_joint(drag);
            before = drag->target;
        }
        drag->asked = drag->target;
    }
    if (drag->rules.on) dmi_drag_hold_back(drag, before, dt);
    dmi_feel_follow(&drag->feel, &drag->joint, before, drag->target, dt, &drag->value, &drag->velocity);
}

static void plan_release(dmi_drag* drag, int32_t intent, float duration) {
    const dmi_released_part part = {.joint = &drag->joint,
                                    .feel = &drag->feel,
                                    .rules = &drag->rules,
                                    .value = drag->value,
                                    .velocity = drag->velocity};
    dmi_release_begin(&drag->release, &part, intent, duration);
}

static void update_released(dmi_drag* drag, float dt) {
    if (drag->stalled) plan_release(drag, drag->release.intent, 0);
    drag->stalled = false;
    if (drag->release.phase != DM_DRAG_RELEASED) return;
    dmi_release_advance(&drag->release, &drag->feel, &drag->joint, dt, &drag->value, &drag->velocity);
    drag->asked = drag->target = drag->release.end;
}

void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state) {
    const float time = dt > 0 && isfinite(dt) ? dt : 0;
    drag->blend.age += time;
    if (drag->rules.on) dmi_drag_note_start(drag);
    if (drag->release.phase == DM_DRAG_HELD) {
        update_held(drag, ray, time);
    } else if (drag->release.phase == DM_DRAG_RELEASED) {
        update_released(drag, time);
    }
    if (drag->rules.on) dmi_drag_keep_rules(drag, time);
    dmi_drag_get_state(drag, out_state);
    if (drag->rules.on) dmi_drag_write_events(drag, out_state);
    const dm_vec3 grab = out_state->grab_point;
    drag->point[0] = grab.x, drag->point[1] = grab.y, drag->point[2] = grab.z;
}

void dmi_drag_step(dmi_drag* drag, const dm_drag_input* input, float dt, dm_drag_state* out_state) {
    const bool bounded = input->lower < input->upper;
    drag->bounds = bounded ? (dmi_bounds){input->lower, input->upper} : dmi_no_bounds();
    dmi_drag_update(drag, input->hand.kind == DM_HAND_RAY ? &input->hand.ray : NULL, dt, out_state);
    drag->bounds = dmi_no_bounds();
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
}

void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration) {
    drag->stalled = false;
    plan_release(drag, intent, duration);
    if (drag->release.phase == DM_DRAG_AT_REST) drag->velocity = 0;
}
