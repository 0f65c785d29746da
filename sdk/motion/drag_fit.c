/* Misses of a joint that follows a remembered pull, and their slopes by where the joint's line lies. */
#include "motion/drag_fit.h"

#include <stdbool.h>

#include "math/linear3.h"
#include "math/vec3.h"

#define LEAST_SINE2 1e-2f /* of the angle between a circle's two ways, as they are seen, squared */
#define MOST_SLANT 1.73f  /* tangent of half of the farthest turn */
#define BEYOND 1.1f       /* of the straight way: at its end */

/* ---- the pull ---- */

void dmi_pull_begin(dmi_pull* pull, const float grab_point[3], float spacing) {
    *pull = (dmi_pull){.spacing = spacing};
    dmi_copy3(grab_point, pull->grab);
}

void dmi_ray_passing(const dm_ray* ray, const float point[3], float out[3]) {
    const dmi_float3 eye = dmi_xyz(ray->origin), d = dmi_xyz(ray->direction);
    float gap[3];
    dmi_sub3(point, eye.v, gap);
    dmi_madd3(eye.v, dmi_dot3(gap, d.v), d.v, out);
}

/* Drops every second ray, not the last. */
static void thin(dmi_pull* pull) {
    uint32_t kept = 0;
    for (uint32_t i = 1; i < pull->count; i += 2, kept++) {
        pull->rays[kept] = pull->rays[i];
        dmi_copy3(pull->places[i], pull->places[kept]);
    }
    pull->count = kept;
    pull->spacing *= 2;
    pull->thinned++;
}

static float bend_of(const dmi_pull* pull) {
    float chord[3], most = 0;
    dmi_sub3(pull->places[pull->count - 1], pull->grab, chord);
    if (!(dmi_normalize3(chord) > 1e-20f)) return INFINITY;
    for (uint32_t i = 0; i + 1 < pull->count; i++) {
        float off[3];
        dmi_sub3(pull->places[i], pull->grab, off);
        dmi_reject3(off, chord);
        most = fmaxf(most, dmi_length3(off));
    }
    return most;
}

void dmi_pull_add(dmi_pull* pull, const dm_ray* ray) {
    float place[3];
    dmi_ray_passing(ray, pull->grab, place);
    const float way = dmi_distance3(place, pull->grab);
    if (!isfinite(way)) return;
    dmi_copy3(place, pull->now);
    pull->sight = ray->direction;
    pull->length = fmaxf(pull->length, way);
    if (way < pull->spacing) return;
    for (uint32_t i = 0; i < pull->count; i++)
        if (dmi_distance3(place, pull->places[i]) < pull->spacing) return;
    if (pull->count == DMI_PULL_RAYS) thin(pull);
    pull->rays[pull->count] = *ray;
    dmi_copy3(place, pull->places[pull->count++]);
    pull->bend = bend_of(pull);
}

/* How far apart a ray and a point look, as a length where the grabbed point was at the start; the way from the one to
 * the other, and what a length there is worth. */
typedef struct look {
    float apart, along, scale, off[3];
} look;

static look look_at(const dmi_pull* pull, const dm_ray* ray, const float point[3]) {
    const dmi_float3 eye = dmi_xyz(ray->origin), d = dmi_xyz(ray->direction);
    float gap[3], rest[3];
    look l;
    dmi_sub3(point, eye.v, gap);
    dmi_sub3(pull->grab, eye.v, rest);
    const float depth = fabsf(dmi_dot3(rest, d.v));
    l.along = dmi_dot3(gap, d.v);
    l.scale = pull->projection == DMI_PARALLEL ? 1 : l.along > 0 ? depth / l.along : 0;
    dmi_madd3(gap, -l.along, d.v, l.off);
    l.apart = l.scale > 0 ? l.scale * dmi_length3(l.off) : depth; /* behind the eye it is nowhere near */
    return l;
}

float dmi_pull_miss(const dmi_pull* pull, const dm_ray* ray, const float point[3]) {
    return look_at(pull, ray, point).apart;
}

/* ---- a joint ---- */

bool dmi_fit_ways(const dm_joint* joint, const float grab_point[3], float out_outward[3], float out_forward[3]) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    dmi_sub3(grab_point, origin.v, out_outward);
    dmi_reject3(out_outward, axis.v);
    const bool has = dmi_joint_turns(joint->type) && dmi_normalize3(out_outward) > 1e-20f;
    dmi_cross3(axis.v, out_outward, out_forward);
    return has;
}

/* A place on the circle is the grabbed point + sin v forward + (1 - cos v) inward, both as long as the arm. The
 * pointer, a share s of the straight way there, is at s times both parts: their ratio is tan (v / 2), and the sum of
 * their squares is 2 s times that of inward. */
bool dmi_pull_cuts_corner(const dmi_pull* pull, const dm_joint* joint) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin), sight = dmi_xyz(pull->sight);
    float inward[3], forward[3], way[3];
    dmi_sub3(origin.v, pull->grab, inward);
    dmi_reject3(inward, axis.v);
    dmi_cross3(inward, axis.v, forward);
    dmi_sub3(pull->now, pull->grab, way);
    dmi_reject3(inward, sight.v), dmi_reject3(forward, sight.v);
    const float ff = dmi_dot3(forward, forward), fi = dmi_dot3(forward, inward), ii = dmi_dot3(inward, inward);
    const float fw = dmi_dot3(forward, way), iw = dmi_dot3(inward, way), det = ff * ii - fi * fi;
    if (!(det > LEAST_SINE2 * ff * ii)) return false;
    const float along = fabsf(fw * ii - iw * fi) / det, in = (iw * ff - fw * fi) / det;
    return in >= 0 && in <= MOST_SLANT * along && along * along + in * in <= 2 * BEYOND * in;
}

/* Where the grabbed point is, how fast it goes there, and what it does when the line is shifted. */
typedef struct place {
    float point[3], velocity[3], shifted[2][3];
} place;

static void turn_to(const dmi_fit* fit, const float grab[3], place* out) {
    const dmi_float3 axis = dmi_xyz(fit->joint.axis), origin = dmi_xyz(fit->joint.origin);
    const float c = cosf(fit->reach), s = sinf(fit->reach);
    const float pitch = fit->joint.type == DM_JOINT_SCREW ? fit->joint.pitch : 0;
    float arm[3], across[3], quarter[3];
    dmi_sub3(grab, origin.v, arm);
    dmi_copy3(arm, across);
    dmi_reject3(across, axis.v);
    dmi_cross3(axis.v, across, quarter);
    for (int i = 0; i < 3; i++) {
        out->point[i] = grab[i] + (c - 1) * across[i] + s * quarter[i] + pitch * fit->reach * axis.v[i];
        out->velocity[i] = c * quarter[i] - s * across[i] + pitch * axis.v[i];
        out->shifted[0][i] = (1 - c) * fit->outward[i] - s * fit->forward[i];
        out->shifted[1][i] = (1 - c) * fit->forward[i] + s * fit->outward[i];
    }
}

static void slide_to(const dmi_fit* fit, const float grab[3], place* out) {
    const dmi_float3 axis = dmi_xyz(fit->joint.axis);
    *out = (place){.velocity = {axis.v[0], axis.v[1], axis.v[2]}};
    dmi_madd3(grab, fit->reach, axis.v, out->point);
}

/* The nearest place on the way looks off across the way. So the miss's slope by a shift is that shift's part across the
 * way, however the place itself goes along. */
static void add_slopes(dmi_fit* fit, const dmi_pull* pull, const dm_ray* ray, const look* l, const place* at) {
    const dmi_float3 d = dmi_xyz(ray->direction);
    float seen[3], across[3], slope[2];
    dmi_copy3(at->velocity, seen);
    if (pull->projection == DMI_PERSPECTIVE) dmi_madd3(seen, -dmi_dot3(seen, d.v) / l->along, l->off, seen);
    dmi_cross3(d.v, seen, across);
    if (!(dmi_normalize3(across) > 1e-20f)) return;
    for (int i = 0; i < 2; i++) slope[i] = l->scale * fit->size * dmi_dot3(across, at->shifted[i]);
    const float miss = copysignf(l->apart, dmi_dot3(across, l->off));
    fit->slope[0] += miss * slope[0], fit->slope[1] += miss * slope[1];
    fit->curvature[0] += slope[0] * slope[0];
    fit->curvature[1] += slope[0] * slope[1];
    fit->curvature[2] += slope[1] * slope[1];
}

void dmi_fit_follow(dmi_fit* fit, const dmi_pull* pull) {
    const dm_ray* ray = &pull->rays[fit->count++];
    const bool turns = dmi_joint_turns(fit->joint.type);
    place at;
    fit->reach =
        dmi_follow_ray_roughly(&fit->joint, pull->grab, ray, pull->projection, fit->reach, fit->lower, fit->upper);
    if (turns)
        turn_to(fit, pull->grab, &at);
    else
        slide_to(fit, pull->grab, &at);
    const look free = look_at(pull, ray, at.point);
    fit->worst = fmaxf(fit->worst, free.apart);
    if (turns && free.scale > 0) add_slopes(fit, pull, ray, &free, &at);
}
