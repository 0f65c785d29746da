/* Vectors, 4x4 matrices (column-major, column vectors) and rigid poses, as far as the viewer needs them. */
#ifndef VIEWER_VEC_H
#define VIEWER_VEC_H

#include <math.h>

#include "dragmesh/dragmesh.h"

#define PI_F 3.14159265358979323846f

typedef dm_vec3 vec3;
typedef struct mat4 {
    float m[16];
} mat4;

static inline vec3 vec(float x, float y, float z) {
    return (vec3){x, y, z};
}

static inline vec3 vec_from(const float* p) {
    return (vec3){p[0], p[1], p[2]};
}

static inline vec3 add(vec3 a, vec3 b) {
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec3 sub(vec3 a, vec3 b) {
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vec3 scale(vec3 a, float s) {
    return (vec3){a.x * s, a.y * s, a.z * s};
}

/* a + s b */
static inline vec3 along(vec3 a, vec3 b, float s) {
    return (vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline float dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 cross(vec3 a, vec3 b) {
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline float length(vec3 a) {
    return sqrtf(dot(a, a));
}

/* Zero stays zero. */
static inline vec3 unit(vec3 a) {
    const float l = length(a);
    return l > 0 ? scale(a, 1 / l) : a;
}

static inline vec3 mix(vec3 a, vec3 b, float t) {
    return along(scale(a, 1 - t), b, t);
}

/* Any unit vector at right angles to a unit vector. */
static inline vec3 perpendicular(vec3 a) {
    return unit(cross(a, fabsf(a.x) < 0.6f ? vec(1, 0, 0) : vec(0, 1, 0)));
}

static inline float clampf(float x, float low, float high) {
    return x < low ? low : x > high ? high : x;
}

static inline vec3 vec_min(vec3 a, vec3 b) {
    return (vec3){fminf(a.x, b.x), fminf(a.y, b.y), fminf(a.z, b.z)};
}

static inline vec3 vec_max(vec3 a, vec3 b) {
    return (vec3){fmaxf(a.x, b.x), fmaxf(a.y, b.y), fmaxf(a.z, b.z)};
}

/* ---- poses ---- */

static const dm_pose pose_identity = {{0, 0, 0, 1}, {0, 0, 0, 0}};

/* The inverse of a unit dual quaternion is its conjugate. */
static inline dm_pose pose_inverse(const dm_pose* p) {
    return (dm_pose){{-p->real[0], -p->real[1], -p->real[2], p->real[3]},
                     {-p->dual[0], -p->dual[1], -p->dual[2], p->dual[3]}};
}

static inline vec3 pose_point(const dm_pose* pose, vec3 p) {
    float at[3] = {p.x, p.y, p.z};
    dm_pose_apply_points(pose, at, 0, at, 0, 1);
    return vec_from(at);
}

static inline vec3 pose_direction(const dm_pose* pose, vec3 d) {
    return sub(pose_point(pose, d), pose_point(pose, vec(0, 0, 0)));
}

/* ---- matrices ---- */

static inline mat4 mat4_multiply(const mat4* a, const mat4* b) {
    mat4 out;
    for (size_t c = 0; c < 4; c++)
        for (size_t r = 0; r < 4; r++)
            out.m[4 * c + r] = a->m[r] * b->m[4 * c] + a->m[4 + r] * b->m[4 * c + 1] + a->m[8 + r] * b->m[4 * c + 2] +
                               a->m[12 + r] * b->m[4 * c + 3];
    return out;
}

/* The camera looks along -z of its own frame. */
static inline mat4 mat4_look(vec3 eye, vec3 forward, vec3 up) {
    const vec3 f = unit(forward), s = unit(cross(f, up)), u = cross(s, f);
    return (mat4){
        {s.x, u.x, -f.x, 0, s.y, u.y, -f.y, 0, s.z, u.z, -f.z, 0, -dot(s, eye), -dot(u, eye), dot(f, eye), 1}};
}

static inline mat4 mat4_perspective(float fov_y, float aspect, float near, float far) {
    const float f = 1 / tanf(fov_y / 2), range = near - far;
    return (mat4){{f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / range, -1, 0, 0, 2 * far * near / range, 0}};
}

static inline mat4 mat4_box(float half_width, float half_height, float near, float far) {
    const float range = near - far;
    return (mat4){
        {1 / half_width, 0, 0, 0, 0, 1 / half_height, 0, 0, 0, 0, 2 / range, 0, 0, 0, (far + near) / range, 1}};
}

static inline void mat4_apply(const mat4* a, vec3 p, float out[4]) {
    for (int r = 0; r < 4; r++) out[r] = a->m[r] * p.x + a->m[4 + r] * p.y + a->m[8 + r] * p.z + a->m[12 + r];
}

#endif
