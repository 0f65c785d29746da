/* Drag: pointer ray -> value it asks for (follow.h) -> calmed where that is ill-posed -> feel (drag_feel.h);
 * beside it, which joint it is (drag_rivals.h), and after it, what was meant (drag_release.h). */
#include "motion/drag.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "math/vec3.h"

/* How much farther than the pointer the grabbed point may go at once. Where the way runs almost along the ray (within
 * 1/16 rad), less than that decides where on it the pointer is; the rest is made up for over a time. */
#define MOST_GAIN 16.0f
#define CATCH_UP_TIME 0.1f    /* s, half-life */
#define LEAST_TURN 1e-5f      /* rad between rays: rounding makes less, a pixel makes more */
#define LIMIT_TOLERANCE 1e-4f /* of the range: what counts as being at a limit */

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
    drag->reach = dmi_feel_reach(feel, joint, drag->target);
    drag->handover = dmi_handover_none();
    drag->release.return_time = fmaxf(feel->return_time, 0);
    drag->speed = speed_of(joint, drag->rest_point);
    memcpy(drag->point, grab_point, sizeof drag->point);
    if (drag->value == start_value) return;
    const dm_pose inside = dmi_joint_pose(joint, drag->value); /* it stands outside its limits */
    drag->handover = dmi_handover_along(&pose, &inside);
}

/* Takes the joint's limits for estimates. */
static void estimate_limits(dmi_drag* drag) {
    const dmi_give give = drag->rivals.hold.give;
    drag->yields = dmi_joint_has_limits(&drag->joint) && give.share >= 0;
    drag->guess_lower = drag->joint.lower, drag->guess_upper = drag->joint.upper;
    dmi_hypothesis_tracker_limits(&drag->joint, give, &drag->most_lower, &drag->most_upper);
}

void dmi_drag_doubt(dmi_drag* drag, const dm_joint* joints, uint32_t count, float size, dmi_give give) {
    dmi_hypothesis_tracker_init(&drag->rivals, joints, count, drag->rest_point, size, give);
    estimate_limits(drag);
}

/* What the part may be asked for, given where the pointer is; limits that yield come along. */
static float target_at(dmi_drag* drag, float reach) {
    if (!drag->yields) return dmi_feel_target(&drag->feel, &drag->joint, reach);
    const float target = dmi_feel_yield(&drag->feel, drag->guess_lower, drag->guess_upper, reach);
    const float kept = fminf(fmaxf(target, drag->most_lower), drag->most_upper);
    drag->joint.lower = fminf(drag->joint.lower, kept), drag->joint.upper = fmaxf(drag->joint.upper, kept);
    return kept;
}

/* Copies the ray with a unit direction; 0 when it is none. */
static bool usable_ray(const dm_ray* ray, dm_ray* out) {
    const dm_vec3 o = ray->origin, d = ray->direction;
    if (!isfinite(o.x) || !isfinite(o.y) || !isfinite(o.z)) return false;
    const float most = fmaxf(fabsf(d.x), fmaxf(fabsf(d.y), fabsf(d.z)));
    if (!(most > 0) || !isfinite(d.x) || !isfinite(d.y) || !isfinite(d.z)) return false;
    const float x = d.x / most, y = d.y / most, z = d.z / most, length = sqrtf(x * x + y * y + z * z);
    *out = (dm_ray){o, {x / length, y / length, z / length}};
    return true;
}

static bool turned(dm_vec3 a, dm_vec3 b) {
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z > LEAST_TURN * LEAST_TURN;
}

static bool has_last_ray(const dmi_drag* drag) {
    const dm_vec3 d = drag->last_ray.direction;
    return d.x != 0 || d.y != 0 || d.z != 0;
}

/* How far the pointer went since the last update, where the grabbed point is. Before the first it lay on the point. */
static float pointer_motion(const dmi_drag* drag, const dm_ray* ray) {
    float before[3], now[3], sum = 0;
    dmi_ray_passing(ray, drag->point, now);
    if (has_last_ray(drag)) {
        dmi_ray_passing(&drag->last_ray, drag->point, before);
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
    const float step = at_once + (fabsf(gap) - at_once) * (1 - expf(-DMI_LN_2 * dt / CATCH_UP_TIME));
    return isfinite(step) ? drag->reach + copysignf(step, gap) : drag->reach;
}

/* Answers what the pointer asks of the joint. */
static float follow(dmi_drag* drag, const dm_ray* ray, float dt) {
    /* Rays that never turn come from an orthographic camera; the first one passes the point and suits either. */
    if (has_last_ray(drag) && turned(drag->last_ray.direction, ray->direction)) drag->projection = DMI_PERSPECTIVE;
    float lower = -INFINITY, upper = INFINITY;
    if (drag->yields) {
        lower = drag->most_lower, upper = drag->most_upper;
    } else if (dmi_joint_has_limits(&drag->joint)) {
        const float w = dmi_feel_soft_width(&drag->feel, &drag->joint);
        lower = drag->joint.lower - w, upper = drag->joint.upper + w;
    }
    const float wish = dmi_follow_ray(&drag->joint, drag->rest_point, ray, drag->projection, drag->reach, lower, upper);
    drag->reach = calm(drag, ray, wish, dt);
    drag->target = target_at(drag, drag->reach);
    drag->last_ray = *ray;
    return wish;
}

static dm_pose shown_pose(const dmi_drag* drag) {
    const dm_pose pose = dmi_joint_pose(&drag->joint, drag->value);
    return dmi_handover_pose(&drag->handover, &pose, drag->rest_point);
}

/* Goes over to the best rival where the pointer asks for it, without a jump of the pose shown. */
static void change_joint(dmi_drag* drag) {
    const dmi_joint_hypothesis* best = &drag->rivals.list[drag->rivals.best];
    const dm_pose before = shown_pose(drag);
    drag->joint = best->joint;
    drag->reach = best->reach;
    estimate_limits(drag);
    drag->target = drag->value = target_at(drag, drag->reach);
    drag->velocity = 0;
    drag->speed = speed_of(&drag->joint, drag->rest_point);
    const dm_pose now = dmi_joint_pose(&drag->joint, drag->value);
    drag->handover = dmi_handover_begin(&before, &now, drag->rest_point, drag->rivals.hold.size);
    drag->changes++;
}

static void hold(dmi_drag* drag, const dm_ray* ray, float dt) {
    float before = drag->target;
    dm_ray unit;
    if (ray != NULL && usable_ray(ray, &unit)) {
        const float wish = follow(drag, &unit, dt);
        if (dmi_hypothesis_tracker_weigh(&drag->rivals, wish, &unit, drag->projection)) {
            change_joint(drag);
            before = drag->target;
        }
    }
    dmi_feel_follow(&drag->feel, &drag->joint, before, drag->target, dt, &drag->value, &drag->velocity);
}

void dmi_drag_update(dmi_drag* drag, const dm_ray* ray, float dt, dm_drag_state* out_state) {
    const float time = dt > 0 && isfinite(dt) ? dt : 0;
    drag->handover.age += time;
    if (drag->release.phase == DM_DRAG_HELD) {
        hold(drag, ray, time);
    } else if (drag->release.phase == DM_DRAG_RELEASED) {
        dmi_release_advance(&drag->release, &drag->feel, &drag->joint, time, &drag->value, &drag->velocity);
        drag->target = drag->release.end;
    }
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
    const dm_pose pose = shown_pose(drag);
    float grab[3];
    dmi_pose_apply(&pose, drag->rest_point, grab);
    *out_state = (dm_drag_state){.pose = pose,
                                 .grab_point = dmi_vec3(grab),
                                 .value = drag->value,
                                 .target = drag->target,
                                 .velocity = drag->velocity,
                                 .at_limit = limit_at(&drag->joint, drag->value),
                                 .phase = drag->release.phase,
                                 .changes = drag->changes};
}
