/* The pointer of a drag: its ray, how far it has moved, which joint value it asks for. In a header, because every frame
 * runs it in drag.c, where calls would cost 4 % of an update; other hands share it (drag_hands.c). */
#ifndef DMI_DRAG_DRAG_POINTER_H
#define DMI_DRAG_DRAG_POINTER_H

#include <math.h>
#include <string.h>

#include "drag/drag_internal.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* Largest step of the grabbed point that one update makes whole, as a multiple of the pointer's own. By hand: where the
 * path runs within 1/16 rad of the ray, less than that decides where on it the pointer is. */
#define MAX_GAIN 16.0f
#define GLIDE_GAIN 2.0f         /* the same on the way to a place that is farther off than that; by hand */
#define CATCH_UP_HALF_LIFE 0.1f /* s in which half of what is left is made up for; by hand */
#define MAX_GLIDE 6.0f     /* rad/s, the fastest that a turn makes up for it; by hand, so that no frame shows a jump */
#define MIN_RAY_TURN 1e-5f /* rad between two rays: rounding makes less, a pixel makes more; by hand */
#define MAX_GRAB_OFFSET 0.032f /* rad, as seen from the eye: 15 pixels of 960 in a view 90 degrees high; by hand */

/* Copies a ray with a unit direction. Returns false when it is not finite or has no direction. */
static inline bool dmi_drag_unit_ray(const dm_ray* ray, dm_ray* out) {
    const dm_vec3 o = ray->origin, d = ray->direction;
    if (!isfinite(o.x) || !isfinite(o.y) || !isfinite(o.z)) return false;
    const float most = dmi_fmaxf(fabsf(d.x), dmi_fmaxf(fabsf(d.y), fabsf(d.z)));
    if (!(most > 0) || !isfinite(d.x) || !isfinite(d.y) || !isfinite(d.z)) return false;
    const float x = d.x / most, y = d.y / most, z = d.z / most, length = sqrtf(x * x + y * y + z * z);
    *out = (dm_ray){o, {x / length, y / length, z / length}};
    return true;
}

static inline bool dmi_drag_has_turned(dm_vec3 a, dm_vec3 b) {
    const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z > MIN_RAY_TURN * MIN_RAY_TURN;
}

static inline bool dmi_drag_has_last_ray(const dmi_drag* drag) {
    const dm_vec3 d = drag->last_ray.direction;
    return d.x != 0 || d.y != 0 || d.z != 0;
}

/* Remembers by how much the first ray misses the grabbed point: the player took hold of it beside the pointer. A ray
 * that passes farther off has moved since the grab. */
static inline void dmi_drag_measure_grab_offset(dmi_drag* drag, const dm_ray* ray) {
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

static inline void dmi_drag_add_grab_offset(const dmi_drag* drag, dm_ray* ray) {
    ray->origin.x += drag->grab_offset.x;
    ray->origin.y += drag->grab_offset.y;
    ray->origin.z += drag->grab_offset.z;
}

/* Returns how far a ray has moved since the last update, host units at the grabbed point. The first update compares it
 * with the grabbed point. */
static inline float dmi_drag_ray_motion(const dmi_drag* drag, const dm_ray* ray) {
    float before[3], now[3], sum = 0;
    dmi_ray_closest_point(ray, drag->point, now);
    if (dmi_drag_has_last_ray(drag)) {
        dmi_ray_closest_point(&drag->last_ray, drag->point, before);
    } else {
        memcpy(before, drag->point, sizeof before);
    }
    for (int i = 0; i < 3; i++) sum += (now[i] - before[i]) * (now[i] - before[i]);
    return sqrtf(sum);
}

/* Moves the pointer value to `nearest`. hand_motion: way of the hand since the last update, host units. The value
 * arrives at once when that is at most MAX_GAIN times the hand's own motion away. Otherwise it glides there, by
 * GLIDE_GAIN times that motion and a share of the rest, because `nearest` is ill-posed then. */
static inline void dmi_drag_move_pointer(dmi_drag* drag, float nearest, float hand_motion, float dt) {
    const float gap = nearest - drag->pointer_value, motion = hand_motion / drag->speed;
    const float at_once = fabsf(gap) <= MAX_GAIN * motion ? fabsf(gap) : GLIDE_GAIN * motion;
    const float rest = (fabsf(gap) - at_once) * (1 - dmi_expf(-DMI_LN_2_F * dt / CATCH_UP_HALF_LIFE));
    const float step = at_once + (dmi_joint_turns(drag->joint.type) ? dmi_fminf(rest, MAX_GLIDE * dt) : rest);
    const float value = drag->pointer_value + copysignf(step, gap);
    if (isfinite(value)) drag->pointer_value = dmi_clamp_within(value, DMI_LARGEST);
}

/* Returns whether the joint is a slide seen end on. The pointer does not show its value then, so it is no evidence
 * against its limits. */
static inline bool dmi_drag_is_unseen_slide(const dmi_drag* drag, const dm_ray* ray) {
    float sight[3], eye_distance;
    if (drag->joint.type != DM_JOINT_PRISMATIC) return false;
    dmi_line_of_sight(drag->rest_point, ray, drag->projection, sight, &eye_distance);
    return dmi_is_seen_end_on(&drag->joint, drag->rest_point, sight);
}

/* Returns the pointer values that a pull may have: those of the limits, or how far estimated limits may be exceeded.
 * stated: excludes what lies beyond estimated limits. */
static inline dmi_span dmi_drag_span(const dmi_drag* drag, bool stated) {
    dmi_span span = {-INFINITY, INFINITY};
    if (drag->limits_are_estimates) {
        span.lower = stated ? drag->estimated_lower : drag->reachable_lower;
        span.upper = stated ? drag->estimated_upper : drag->reachable_upper;
    } else if (dmi_joint_has_limits(&drag->joint)) {
        span = drag->pointer_span;
    }
    return span;
}

/* Makes the ray of the first hand unit and adds its offset, which the first ray of the drag sets. Returns false when
 * the ray is not usable. */
static inline bool dmi_drag_read_ray(dmi_drag* drag, const dm_ray* ray, dm_ray* out_unit) {
    if (!dmi_drag_unit_ray(ray, out_unit)) return false;
    if (!dmi_drag_has_last_ray(drag)) dmi_drag_measure_grab_offset(drag, out_unit);
    dmi_drag_add_grab_offset(drag, out_unit);
    return true;
}

/* Returns the joint value nearest to the ray that dmi_drag_read_ray gave. */
static inline float dmi_drag_nearest(dmi_drag* drag, const dm_ray* ray) {
    /* Rays that never turn come from an orthographic camera; the first one passes the point and suits either. */
    if (dmi_drag_has_last_ray(drag) && dmi_drag_has_turned(drag->last_ray.direction, ray->direction))
        drag->projection = DMI_PERSPECTIVE;
    const bool stated = drag->limits_are_estimates && dmi_drag_is_unseen_slide(drag, ray);
    const dmi_span span = dmi_drag_span(drag, stated);
    const float value = dmi_follow_ray(&drag->joint, drag->rest_point, ray, drag->projection, drag->pointer_value,
                                       span.lower, span.upper);
    return dmi_clamp_within(value, DMI_LARGEST);
}

#endif
