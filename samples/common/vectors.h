/* Vectors of three floats by cglm, as values: a dm_vec3 goes in and comes out. Angles are radians. */
#ifndef SAMPLES_VECTORS_H
#define SAMPLES_VECTORS_H

#include "cglm/scalar_vec3.h"
#include "dragmesh/dragmesh.h"

/* A vector as cglm takes it. An array by value, because &a.x is the address of one float. */
typedef struct raw_vec3 {
    vec3 v;
} raw_vec3;

static inline raw_vec3 raw(dm_vec3 a) {
    return (raw_vec3){{a.x, a.y, a.z}};
}

static inline dm_vec3 vec(float x, float y, float z) {
    return (dm_vec3){x, y, z};
}

static inline dm_vec3 vec_from(const float p[3]) {
    return (dm_vec3){p[0], p[1], p[2]};
}

static inline dm_vec3 add(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_add(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

static inline dm_vec3 sub(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_sub(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

static inline dm_vec3 scale(dm_vec3 a, float s) {
    vec3 out;
    glm_vec3_scale(raw(a).v, s, out);
    return vec_from(out);
}

/* Returns the products of the components. */
static inline dm_vec3 times(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_mul(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

/* Returns a + s b. */
static inline dm_vec3 along(dm_vec3 a, dm_vec3 b, float s) {
    raw_vec3 out = raw(a);
    glm_vec3_muladds(raw(b).v, s, out.v);
    return vec_from(out.v);
}

static inline float dot(dm_vec3 a, dm_vec3 b) {
    return glm_vec3_dot(raw(a).v, raw(b).v);
}

static inline dm_vec3 cross(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_cross(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

static inline float length(dm_vec3 a) {
    return glm_vec3_norm(raw(a).v);
}

static inline float distance(dm_vec3 a, dm_vec3 b) {
    return glm_vec3_distance(raw(a).v, raw(b).v);
}

/* Returns a at length 1; zero stays zero. */
static inline dm_vec3 unit(dm_vec3 a) {
    vec3 out;
    glm_vec3_normalize_to(raw(a).v, out);
    return vec_from(out);
}

/* Returns a at t 0, b at t 1. */
static inline dm_vec3 mix(dm_vec3 a, dm_vec3 b, float t) {
    vec3 out;
    glm_vec3_lerp(raw(a).v, raw(b).v, t, out);
    return vec_from(out);
}

static inline dm_vec3 vec_min(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_minv(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

static inline dm_vec3 vec_max(dm_vec3 a, dm_vec3 b) {
    vec3 out;
    glm_vec3_maxv(raw(a).v, raw(b).v, out);
    return vec_from(out);
}

/* Returns a moved by a pose. */
static inline dm_vec3 pose_point(const dm_pose* pose, dm_vec3 a) {
    raw_vec3 at = raw(a);
    dm_pose_apply_points(pose, at.v, 0, at.v, 0, 1);
    return vec_from(at.v);
}

#endif
