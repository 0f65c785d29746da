/* Drag: pointer ray -> value it asks for (follow.h) -> calmed where that is ill-posed -> limits -> smoothing. */
#include "motion/drag.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

#define LN_2 0.69314718f
#define DEFAULT_SMOOTHING_TIME 0.02f /* s, half-life */
/* How much farther than the pointer the grabbed point may go at once. Where the way runs almost along the ray (within
 * 1/16 rad), less than that decides where on it the pointer is; the rest is made up for over a time. */
#define MOST_GAIN 16.0f
#define CATCH_UP_TIME 0.1f    /* s, half-life */
#define LEAST_TURN 1e-5f      /* rad between rays: rounding makes less, a pixel makes more */
#define LIMIT_TOLERANCE 1e-4f /* of the range: what counts as being at a limit */

/* Width of the soft zone inside (and outside) each limit. */
static float soft_width(const dmi_drag* drag) {
    const float share = fminf(fmaxf(drag->feel.soft_limit, 0), 0.5f);
    return dmi_joint_has_limits(&drag->joint) ? share * (drag->joint.upper - drag->joint.lower) : 0;
}

/* An end that gives: x from w before the limit to w behind it comes down on [-w, 0] by a parabola, so that the slope
 * falls from 1 to 0 and the limit itself is reached. */
static float soften_end(float x, float w) {
    return x <= -w ? x : x - (x + w) * (x + w) / (4 * w);
}

static float harden_end(float y, float w) {
    return y <= -w ? y : 2 * w * (1 - sqrtf(fmaxf(1 - (y + w) / w, 0))) - w;
}

/* Both ends of the range by one of the two maps. */
static float map_ends(const dmi_drag* drag, float value, float (*map)(float, float)) {
    const float w = soft_width(drag), lower = drag->joint.lower, upper = drag->joint.upper;
    if (!(w > 0)) return value;
    return value > 0.5f * (lower + upper) ? upper + map(value - upper, w) : lower - map(lower - value, w);
}

void dmi_drag_begin(dmi_drag* drag, const dm_joint* joint, const float grab_point[3], float start_value,
                    const dm_drag_feel* feel) {
    *drag = (dmi_drag){.joint = *joint, .feel = *feel};
    dm_pose pose = dmi_joint_pose(joint, start_value), back = dmi_pose_inverse(&pose);
    dmi_pose_apply(&back, grab_point, drag->rest_point);
    drag->value = drag->target = dmi_joint_clamp(joint, start_value);
    drag->reach = map_ends(drag, drag->target, harden_end);
    float velocity[3];
    dmi_joint_velocity(joint, 0, drag->rest_point, velocity);
    drag->speed = sqrtf(velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2]);
    memcpy(drag->point, grab_point, sizeof drag->point);
}

/* Copies the ray with a unit direction; 0 when it is none. */
static int usable_ray(const dm_ray* ray, dm_ray* out) {
    const dm_vec3 o = ray->origin, d = ray->direction;
    if (!isfinite(o.x) || !isfinite(o.y) || !isfinite(o.z)) return 0;
    const float most = fmaxf(fabsf(d.x), fmaxf(fabsf(d.y), fabsf(d.z)));
    if (!(most > 0) || !isfinite(d.x) || !isfinite(d.y) || !isfinite(d.z)) return 0;
    const float x = d.x / most, y = d.y / most, z = d.z / most, length = sqrtf(x * x + y * y + z * z);
    *out = (dm_ray){o, {x / length, y / length, z / length}};
    return 1;
}

static int turned(dm_vec3 a, dm_vec3 b) {
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z > LEAST_TURN * LEAST_TURN;
}

static int has_last_ray(const dmi_drag* drag) {
    const dm_vec3 d = drag->last_ray.direction;
    return d.x != 0 || d.y != 0 || d.z != 0;
}

/* Where a ray passes a point most closely. */
static void passing_point(const dm_ray* ray, const float point[3], float out[3]) {
    const float d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const float o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    float along = 0;
    for (int i = 0; i < 3; i++) along += d[i] * (point[i] - o[i]);
    for (int i = 0; i < 3; i++) out[i] = o[i] + along * d[i];
}

/* How far the pointer went since the last update, where the grabbed point is. Before the first it lay on the point. */
static float pointer_motion(const dmi_drag* drag, const dm_ray* ray) {
    float before[3], now[3], sum = 0;
    passing_point(ray, drag->point, now);
    if (has_last_ray(drag)) {
        passing_point(&drag->last_ray, drag->point, before);
    } else {
        memcpy(before, drag->point, sizeof before);
    }
    for (int i = 0; i < 3; i++) sum += (now[i] - before[i]) * (now[i] - before[i]);
    return sqrtf(sum);
}

/* The wish, as far as the pointer's own motion and the time passed allow going there. */
static float calm(const dmi_drag* drag, const dm_ray* ray, float wish, float dt) {
    const float gap = wish - drag->reach;
    const float at_once = fminf(MOST_GAIN * pointer_motion(drag, ray) / drag->speed, fabsf(gap));
    const float step = at_once + (fabsf(gap) - at_once) * (1 - expf(-LN_2 * dt / CATCH_UP_TIME));
    return isfinite(step) ? drag->reach + copysignf(step, gap) : drag->reach;
}

static void follow(dmi_drag* drag, const dm_ray* ray, float dt) {
    /* Rays that never turn come from an orthographic camera; the first one passes the point and suits either. */
    if (has_last_ray(drag) && turned(drag->last_ray.direction, ray->direction)) drag->projection = DMI_PERSPECTIVE;
    const float w = soft_width(drag);
    const int limited = dmi_joint_has_limits(&drag->joint);
    const float lower = limited ? drag->joint.lower - w : -INFINITY;
    const float upper = limited ? drag->joint.upper + w : INFINITY;
    const float wish = dmi_follow_ray(&drag->joint, drag->rest_point, ray, drag->projection, drag->reach, lower, upper);
    drag->reach = calm(drag, ray, wish, dt);
    drag->target = dmi_joint_clamp(&drag->joint, map_ends(drag, drag->reach, soften_end));
    drag->last_ray = *ray;
}

/* The exact answer of dx/dt = (T - x) ln 2 / half-life to a target that goes evenly from `before` to where it is now:
 * the same path gives the same value however it is cut into updates. A convex mix of x and both targets, so it keeps
 * limits. */
static void smooth(dmi_drag* drag, float before, float dt) {
    const float half = drag->feel.smoothing_time == 0 ? DEFAULT_SMOOTHING_TIME : drag->feel.smoothing_time;
    const float old = drag->value;
    if (half > 0) {
        const float k = LN_2 * dt / half, kept = expf(-k);
        const float lag = k > 0.01f ? (1 - kept) / k : 1 - k / 2 + k * k / 6; /* (1 - exp(-k)) / k */
        drag->value = (1 - lag) * drag->target + (lag - kept) * before + kept * old;
        drag->value = dmi_joint_clamp(&drag->joint, drag->value); /* the weights' rounding */
    } else {
        drag->value = drag->target;
    }
    const float velocity = (drag->value - old) / dt;
    if (dt > 0 && isfinite(velocity)) drag->velocity = velocity;
}

void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state) {
    const float before = drag->target, time = dt > 0 && isfinite(dt) ? dt : 0;
    dm_ray unit;
    if (usable_ray(ray, &unit)) follow(drag, &unit, time);
    smooth(drag, before, time);
    dmi_drag_state_now(drag, out_state);
    const dm_vec3 grab = out_state->grab_point;
    drag->point[0] = grab.x, drag->point[1] = grab.y, drag->point[2] = grab.z;
}

static int32_t limit_at(const dm_joint* joint, float value) {
    if (!dmi_joint_has_limits(joint)) return 0;
    const float tolerance = LIMIT_TOLERANCE * (joint->upper - joint->lower);
    return value >= joint->upper - tolerance ? 1 : value <= joint->lower + tolerance ? -1 : 0;
}

void dmi_drag_state_now(const dmi_drag* drag, dm_drag_state* out_state) {
    const dm_pose pose = dmi_joint_pose(&drag->joint, drag->value);
    float grab[3];
    dmi_pose_apply(&pose, drag->rest_point, grab);
    *out_state = (dm_drag_state){.pose = pose,
                                 .grab_point = dmi_vec3(grab),
                                 .value = drag->value,
                                 .target = drag->target,
                                 .velocity = drag->velocity,
                                 .at_limit = limit_at(&drag->joint, drag->value)};
}
