/* Defines three-dimensional vectors and affine frames for the generator, by value. */
#ifndef DMG_VEC_H
#define DMG_VEC_H

#include <math.h>

#define DMG_PI 3.14159265f

typedef struct dmg_vec {
    float x, y, z;
} dmg_vec;

/* A point of an outline or a profile. */
typedef struct dmg_xy {
    float x, y;
} dmg_xy;

static inline dmg_vec v3(float x, float y, float z) {
    return (dmg_vec){x, y, z};
}
/* From and to three numbers in a row, as joints and meshes have them. */
static inline dmg_vec v3_from(const float v[3]) {
    return v3(v[0], v[1], v[2]);
}
static inline void v3_to(dmg_vec v, float out[3]) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}
static inline dmg_vec v3_add(dmg_vec a, dmg_vec b) {
    return v3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline dmg_vec v3_sub(dmg_vec a, dmg_vec b) {
    return v3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline dmg_vec v3_scale(dmg_vec a, float s) {
    return v3(a.x * s, a.y * s, a.z * s);
}
/* a + b s */
static inline dmg_vec v3_mad(dmg_vec a, dmg_vec b, float s) {
    return v3(a.x + b.x * s, a.y + b.y * s, a.z + b.z * s);
}
static inline dmg_vec v3_lerp(dmg_vec a, dmg_vec b, float t) {
    return v3_mad(a, v3_sub(b, a), t);
}
static inline float v3_dot(dmg_vec a, dmg_vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline dmg_vec v3_cross(dmg_vec a, dmg_vec b) {
    return v3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline float v3_length(dmg_vec a) {
    return sqrtf(v3_dot(a, a));
}
/* The zero vector stays as it is. */
static inline dmg_vec v3_normalize(dmg_vec a) {
    float length = v3_length(a);
    return length > 0.0f ? v3_scale(a, 1.0f / length) : a;
}
/* Turns a by `angle` about the unit vector `axis`, right-handed (Rodrigues). */
static inline dmg_vec v3_turn(dmg_vec a, dmg_vec axis, float angle) {
    float c = cosf(angle), s = sinf(angle);
    dmg_vec turned = v3_add(v3_scale(a, c), v3_scale(v3_cross(axis, a), s));
    return v3_mad(turned, axis, v3_dot(axis, a) * (1.0f - c));
}
/* Two unit vectors u, w with u x w = the unit vector `axis`. */
static inline void v3_basis(dmg_vec axis, dmg_vec* u, dmg_vec* w) {
    dmg_vec helper = fabsf(axis.x) < 0.7f ? v3(1, 0, 0) : v3(0, 0, 1);
    *u = v3_normalize(v3_cross(helper, axis));
    *w = v3_cross(axis, *u);
}

/* x -> columns x + origin. */
typedef struct dmg_frame {
    dmg_vec column[3];
    dmg_vec origin;
} dmg_frame;

static inline dmg_frame dmg_frame_identity(void) {
    return (dmg_frame){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
}
static inline dmg_vec dmg_frame_vector(const dmg_frame* frame, dmg_vec a) {
    dmg_vec sum = v3_scale(frame->column[0], a.x);
    return v3_mad(v3_mad(sum, frame->column[1], a.y), frame->column[2], a.z);
}
static inline dmg_vec dmg_frame_point(const dmg_frame* frame, dmg_vec a) {
    return v3_add(dmg_frame_vector(frame, a), frame->origin);
}
/* x -> a(b(x)) */
static inline dmg_frame dmg_frame_multiply(const dmg_frame* a, const dmg_frame* b) {
    dmg_frame product;
    for (int i = 0; i < 3; ++i) product.column[i] = dmg_frame_vector(a, b->column[i]);
    product.origin = dmg_frame_point(a, b->origin);
    return product;
}
static inline float dmg_frame_determinant(const dmg_frame* frame) {
    return v3_dot(frame->column[0], v3_cross(frame->column[1], frame->column[2]));
}
/* A turn about the line through `origin` along the unit vector `axis`, with an advance along it. */
static inline dmg_frame dmg_frame_screw(dmg_vec origin, dmg_vec axis, float angle, float advance) {
    dmg_frame frame = {
        {v3_turn(v3(1, 0, 0), axis, angle), v3_turn(v3(0, 1, 0), axis, angle), v3_turn(v3(0, 0, 1), axis, angle)},
        {0, 0, 0}};
    frame.origin = v3_mad(v3_sub(origin, dmg_frame_vector(&frame, origin)), axis, advance);
    return frame;
}

#endif
