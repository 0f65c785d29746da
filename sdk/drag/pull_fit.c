/* Residuals of a joint that follows a recorded pull, and their derivatives by a shift of its axis line. */
#include "drag/pull_fit.h"

#include <math.h>
#include <stdbool.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* Squared sine between a circle's two seen directions; below it the circle is edge on; by hand. */
#define MIN_SINE2 1e-2f
#define MAX_HALF_TURN_TANGENT 2.75f /* tan of half the farthest turn of a chord, 140 degrees; by hand, test_hands.c */
#define CHORD_OVERSHOOT 1.1f        /* share of the chord up to which the pointer counts as on it; by hand */
#define MIN_LENGTH 1e-20f           /* host units: shorter vectors have no direction; rounding */

/* ---- the pull ---- */

void dmi_pull_begin(dmi_pull* pull, const float grab_point[3], float spacing) {
    *pull = (dmi_pull){.spacing = spacing};
    dmi_copy3(grab_point, pull->grab);
}

void dmi_ray_closest_point(const dm_ray* ray, const float point[3], float out[3]) {
    const dmi_float3 eye = dmi_xyz(ray->origin), d = dmi_xyz(ray->direction);
    float gap[3];
    dmi_sub3(point, eye.v, gap);
    dmi_madd3(eye.v, dmi_dot3(gap, d.v), d.v, out);
}

/* Drops every second ray but keeps the last. */
static void thin_rays(dmi_pull* pull) {
    uint32_t kept = 0;
    for (uint32_t i = 1; i < pull->count; i += 2, kept++) {
        pull->rays[kept] = pull->rays[i];
        dmi_copy3(pull->places[i], pull->places[kept]);
    }
    pull->count = kept;
    pull->spacing *= 2;
    pull->thinned++;
}

/* Returns the largest distance of a place from the plane through the eye in which the grabbed point and the last place
 * lie: the line between them on the screen. Infinite where that line has no length. */
static float bend_of(const dmi_pull* pull) {
    const dmi_float3 sight = dmi_xyz(pull->rays[pull->count - 1].direction);
    float chord[3], normal[3], most = 0;
    dmi_sub3(pull->places[pull->count - 1], pull->grab, chord);
    dmi_cross3(sight.v, chord, normal);
    if (!(dmi_normalize3(normal) > MIN_LENGTH)) return INFINITY;
    for (uint32_t i = 0; i + 1 < pull->count; i++) {
        float offset[3];
        dmi_sub3(pull->places[i], pull->grab, offset);
        most = dmi_fmaxf(most, fabsf(dmi_dot3(offset, normal)));
    }
    return most;
}

static dmi_seen_pointer see_pointer(const dmi_pull* pull, const dm_ray* ray) {
    const dmi_float3 eye = dmi_xyz(ray->origin), direction = dmi_xyz(ray->direction);
    dmi_seen_pointer seen = {.way = {0}};
    dmi_line_of_sight(pull->grab, ray, pull->projection, seen.sight, &seen.eye_distance);
    float to_eye[3];
    dmi_sub3(eye.v, pull->grab, to_eye);
    const float along = dmi_dot3(direction.v, seen.sight);
    if (along > 0) dmi_madd3(to_eye, -dmi_dot3(to_eye, seen.sight) / along, direction.v, seen.way);
    return seen;
}

void dmi_pull_add(dmi_pull* pull, const dm_ray* ray) {
    float place[3];
    dmi_ray_closest_point(ray, pull->grab, place);
    const float distance = dmi_distance3(place, pull->grab);
    if (!isfinite(distance)) return;
    pull->pointer = see_pointer(pull, ray);
    pull->length = dmi_fmaxf(pull->length, distance);
    if (distance < pull->spacing) return;
    for (uint32_t i = 0; i < pull->count; i++)
        if (dmi_distance3(place, pull->places[i]) < pull->spacing) return;
    if (pull->count == DMI_PULL_RAYS) thin_rays(pull);
    pull->rays[pull->count] = *ray;
    dmi_copy3(place, pull->places[pull->count++]);
    pull->bend = bend_of(pull);
}

/* The offset of a point from a ray as it is seen. */
typedef struct ray_offset {
    float distance; /* distance as seen, scaled to the depth of the grabbed point at the start */
    float depth;    /* depth of the point along the ray */
    float scale; /* factor from lengths at that depth to lengths at the depth of the grabbed point; 0: behind the eye */
    float vector[3]; /* vector from the ray to the point, across the ray */
} ray_offset;

static ray_offset offset_from_ray(const dmi_pull* pull, const dm_ray* ray, const float point[3]) {
    const dmi_float3 eye = dmi_xyz(ray->origin), d = dmi_xyz(ray->direction);
    float gap[3], rest[3];
    ray_offset offset;
    dmi_sub3(point, eye.v, gap);
    dmi_sub3(pull->grab, eye.v, rest);
    const float grab_depth = fabsf(dmi_dot3(rest, d.v));
    offset.depth = dmi_dot3(gap, d.v);
    offset.scale = pull->projection == DMI_PARALLEL ? 1 : offset.depth > 0 ? grab_depth / offset.depth : 0;
    dmi_madd3(gap, -offset.depth, d.v, offset.vector);
    /* A point behind the eye counts as far off as the grabbed point is from the eye. */
    offset.distance = offset.scale > 0 ? offset.scale * dmi_length3(offset.vector) : grab_depth;
    return offset;
}

float dmi_pull_residual(const dmi_pull* pull, const dm_ray* ray, const float point[3]) {
    return offset_from_ray(pull, ray, point).distance;
}

/* ---- a joint ---- */

bool dmi_pull_fit_shift_directions(const dm_joint* joint, const float grab_point[3], float out_outward[3],
                                   float out_forward[3]) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    dmi_sub3(grab_point, origin.v, out_outward);
    dmi_reject3(out_outward, axis.v);
    const bool has = dmi_joint_turns(joint->type) && dmi_normalize3(out_outward) > MIN_LENGTH;
    dmi_cross3(axis.v, out_outward, out_forward);
    return has;
}

/* Solves way = along forward + in inward in the plane across the sight. Returns false for a circle seen edge on. */
static bool solve_in_circle(const dmi_seen_pointer* seen, const float forward[3], const float inward[3],
                            float* out_along, float* out_in) {
    float f[3], i[3];
    dmi_copy3(forward, f), dmi_copy3(inward, i);
    dmi_reject3(f, seen->sight), dmi_reject3(i, seen->sight);
    const float ff = dmi_dot3(f, f), fi = dmi_dot3(f, i), ii = dmi_dot3(i, i), det = ff * ii - fi * fi;
    const float fw = dmi_dot3(f, seen->way), iw = dmi_dot3(i, seen->way);
    *out_along = (fw * ii - iw * fi) / det, *out_in = (iw * ff - fw * fi) / det;
    return det > MIN_SINE2 * ff * ii;
}

/* A point of the circle at angle v is grab + sin v forward + (1 - cos v) inward, with both vectors as long as the lever
 * arm. The chord to it has components of the ratio tan (v / 2), on the screen as well: perspective moves a point along
 * a line through the grabbed point, which is seen in the middle. From the ratio, sin v = end along and 1 - cos v =
 * end in, with end = 2 in / (along^2 + in^2). */
bool dmi_pull_is_on_chord(const dmi_pull* pull, const dm_joint* joint) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    float inward[3], forward[3], chord[3], along, in;
    const dmi_seen_pointer* seen = &pull->pointer;
    dmi_sub3(origin.v, pull->grab, inward);
    dmi_reject3(inward, axis.v);
    dmi_cross3(inward, axis.v, forward);
    if (!solve_in_circle(seen, forward, inward, &along, &in) || !(in > 0)) return false;
    if (in > MAX_HALF_TURN_TANGENT * fabsf(along)) return false;
    const float end = 2 * in / (along * along + in * in);
    for (int k = 0; k < 3; k++) chord[k] = end * (along * forward[k] + in * inward[k]);
    /* Depth of the chord's end, where the grabbed point has 1. */
    const float depth = 1 + dmi_dot3(chord, seen->sight) / seen->eye_distance;
    return depth > 0 && depth <= CHORD_OVERSHOOT * end;
}

/* Position of the grabbed point, its derivative by the joint value, and by the two shifts of the axis line. */
typedef struct place {
    float point[3], velocity[3], shifted[2][3];
} place;

static void turn_to(const dmi_pull_fit* fit, const float grab[3], place* out) {
    const dmi_float3 axis = dmi_xyz(fit->joint.axis), origin = dmi_xyz(fit->joint.origin);
    const dmi_circlef at = dmi_circle_atf(fit->pointer_value);
    const float c = at.cosine, s = at.sine;
    const float pitch = fit->joint.type == DM_JOINT_SCREW ? fit->joint.pitch : 0;
    float arm[3], across[3], quarter[3];
    dmi_sub3(grab, origin.v, arm);
    dmi_copy3(arm, across);
    dmi_reject3(across, axis.v);
    dmi_cross3(axis.v, across, quarter);
    for (int i = 0; i < 3; i++) {
        out->point[i] = grab[i] + (c - 1) * across[i] + s * quarter[i] + pitch * fit->pointer_value * axis.v[i];
        out->velocity[i] = c * quarter[i] - s * across[i] + pitch * axis.v[i];
        out->shifted[0][i] = (1 - c) * fit->outward[i] - s * fit->forward[i];
        out->shifted[1][i] = (1 - c) * fit->forward[i] + s * fit->outward[i];
    }
}

static void slide_to(const dmi_pull_fit* fit, const float grab[3], place* out) {
    const dmi_float3 axis = dmi_xyz(fit->joint.axis);
    *out = (place){.velocity = {axis.v[0], axis.v[1], axis.v[2]}};
    dmi_madd3(grab, fit->pointer_value, axis.v, out->point);
}

/* Adds one residual to the normal equations. At the closest place the offset is perpendicular to the seen path, so the
 * residual's derivative by a shift is the shift's component across the path (the envelope theorem: the change of the
 * joint value along the path adds nothing). */
static void add_residual(dmi_pull_fit* fit, const dmi_pull* pull, const dm_ray* ray, const ray_offset* offset,
                         const place* at) {
    const dmi_float3 d = dmi_xyz(ray->direction);
    float seen[3], across[3], slope[2];
    dmi_copy3(at->velocity, seen);
    if (pull->projection == DMI_PERSPECTIVE)
        dmi_madd3(seen, -dmi_dot3(seen, d.v) / offset->depth, offset->vector, seen);
    dmi_cross3(d.v, seen, across);
    if (!(dmi_normalize3(across) > MIN_LENGTH)) return;
    for (int i = 0; i < 2; i++) slope[i] = offset->scale * fit->size * dmi_dot3(across, at->shifted[i]);
    const float residual = copysignf(offset->distance, dmi_dot3(across, offset->vector));
    fit->gradient[0] += residual * slope[0], fit->gradient[1] += residual * slope[1];
    fit->hessian[0] += slope[0] * slope[0];
    fit->hessian[1] += slope[0] * slope[1];
    fit->hessian[2] += slope[1] * slope[1];
}

void dmi_pull_fit_step(dmi_pull_fit* fit, const dmi_pull* pull) {
    const dm_ray* ray = &pull->rays[fit->count++];
    const bool turns = dmi_joint_turns(fit->joint.type);
    place at;
    fit->pointer_value = dmi_follow_ray_coarse(&fit->joint, pull->grab, ray, pull->projection, fit->pointer_value,
                                               fit->lower, fit->upper);
    if (turns)
        turn_to(fit, pull->grab, &at);
    else
        slide_to(fit, pull->grab, &at);
    const ray_offset offset = offset_from_ray(pull, ray, at.point);
    fit->max_residual = dmi_fmaxf(fit->max_residual, offset.distance);
    if (turns && offset.scale > 0) add_residual(fit, pull, ray, &offset, &at);
}
