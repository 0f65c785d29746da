/* Linear algebra in three dimensions: float vectors, symmetric eigenproblems, perpendicular frames.
 *
 * Vectors, matrices and quaternions of floats are cglm's wherever it has the same operations in the same order, in all
 * of sdk/math. It is compiled without vector instructions (third_party/cglm), so that the bits are the same on every
 * machine. These stay code of our own:
 *  - dmi_min, dmi_max, dmi_clamp: cglm's give another answer for NaN, or of two zeros.
 *  - dmi_normalize3: divides by the length. cglm multiplies by its reciprocal, which rounds twice. The same holds for
 *    the division of four numbers in dual_quat.c.
 *  - dot4 and dmi_pose_to_matrix in dual_quat.c: they add four products in pairs, cglm from left to right.
 *  - dmi_length2, eigenvectors, host frames (frames.c): doubles, which cglm does not have.
 *  - dual quaternions, which cglm does not have.
 *  - elementary functions (elementary.c): cglm calls those of the C library, whose bits differ between machines.
 *  - points in bulk (apply_points.c): one kernel for each instruction set. */
#ifndef DMI_MATH_LINEAR3_H
#define DMI_MATH_LINEAR3_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "cglm/scalar_vec3.h"
#include "dragmesh/dragmesh.h"

/* Returns v as cglm's functions take it: none of their arguments is const, but they write to the last one alone. */
static inline float* dmi_glm(const float* v) {
    return (float*)v;
}

/* Inline, unlike fminf and fmaxf, which are calls because of NaN; arguments are never NaN. */
static inline float dmi_min(float a, float b) {
    return b < a ? b : a;
}

static inline float dmi_max(float a, float b) {
    return b > a ? b : a;
}

/* low for NaN. */
static inline float dmi_clamp(float value, float low, float high) {
    return !(value > low) ? low : value < high ? value : high;
}

/* Clamps to [-most, most]; -most for NaN. */
static inline float dmi_clamp_within(float value, float most) {
    return dmi_clamp(value, -most, most);
}

static inline float dmi_dot3(const float a[3], const float b[3]) {
    return glm_vec3_dot(dmi_glm(a), dmi_glm(b));
}

static inline void dmi_cross3(const float a[3], const float b[3], float out[3]) {
    glm_vec3_cross(dmi_glm(a), dmi_glm(b), out);
}

static inline void dmi_sub3(const float a[3], const float b[3], float out[3]) {
    glm_vec3_sub(dmi_glm(a), dmi_glm(b), out);
}

static inline void dmi_add3(const float a[3], const float b[3], float out[3]) {
    glm_vec3_add(dmi_glm(a), dmi_glm(b), out);
}

static inline void dmi_scale3(const float a[3], float s, float out[3]) {
    glm_vec3_scale(dmi_glm(a), s, out);
}

/* out = a + s b; out may be either. */
static inline void dmi_madd3(const float a[3], float s, const float b[3], float out[3]) {
    float scaled[3];
    glm_vec3_scale(dmi_glm(b), s, scaled);
    glm_vec3_add(dmi_glm(a), scaled, out);
}

static inline void dmi_copy3(const float a[3], float out[3]) {
    glm_vec3_copy(dmi_glm(a), out);
}

/* Returns the length of (x, y), with the same bits whatever the C library. */
static inline float dmi_length2(float x, float y) {
    return (float)sqrt((double)x * x + (double)y * y);
}

static inline float dmi_length3(const float a[3]) {
    return glm_vec3_norm(dmi_glm(a));
}

static inline float dmi_distance3(const float a[3], const float b[3]) {
    return glm_vec3_distance(dmi_glm(a), dmi_glm(b));
}

/* Scales to unit length and returns the former length; leaves vectors shorter than 1e-20 (rounding) as they are. */
static inline float dmi_normalize3(float a[3]) {
    float length = dmi_length3(a);
    if (length > 1e-20f) glm_vec3_divs(a, length, a);
    return length;
}

/* Subtracts from `a` its component along the unit vector `axis`. */
static inline void dmi_reject3(float a[3], const float axis[3]) {
    dmi_madd3(a, -dmi_dot3(a, axis), axis, a);
}

/* Returns the distance of a point from the line (axis, origin), axis unit. */
static inline float dmi_line_distance3(const float point[3], const float axis[3], const float origin[3]) {
    float d[3];
    dmi_sub3(point, origin, d);
    dmi_reject3(d, axis);
    return dmi_length3(d);
}

/* Computes two unit vectors that complete the unit vector `axis` to a right-handed frame (u, w, axis). */
void dmi_perpendicular3(const float axis[3], float out_u[3], float out_w[3]);

/* Computes eigenvalues, largest first, and unit eigenvectors (rows) of a symmetric matrix. */
void dmi_eigen3(const double matrix[3][3], double out_values[3], float out_vectors[3][3]);

/* Computes mean and principal directions (rows, largest variance first) of points. count 0: zeros and the identity. */
void dmi_principal3(const float (*points)[3], uint32_t count, float out_mean[3], double out_variances[3],
                    float out_directions[3][3]);

/* Rotates `point` about the line (axis, origin) by the angle whose cosine and sine are given. */
static inline void dmi_turn3(const float axis[3], const float origin[3], float cosine, float sine, const float point[3],
                             float out[3]) {
    float d[3], c[3], sum[3];
    dmi_sub3(point, origin, d);
    dmi_cross3(axis, d, c);
    const float along = dmi_dot3(axis, d) * (1 - cosine);
    dmi_copy3(origin, sum);
    glm_vec3_muladds(d, cosine, sum);
    glm_vec3_muladds(c, sine, sum);
    glm_vec3_muladds(dmi_glm(axis), along, sum);
    dmi_copy3(sum, out);
}

/* ---- conversions between the host's dm_vec3 and the arrays that the rooms compute with, and the only place for them
 * ---- */

/* An array by value: &p.x is the address of one float, and compilers warn when three are read through it. */
typedef struct dmi_float3 {
    float v[3];
} dmi_float3;

typedef struct dmi_double3 {
    double v[3];
} dmi_double3;

static inline dmi_float3 dmi_xyz(dm_vec3 p) {
    return (dmi_float3){{p.x, p.y, p.z}};
}

static inline dmi_double3 dmi_xyz_f64(dm_vec3 p) {
    return (dmi_double3){{(double)p.x, (double)p.y, (double)p.z}};
}

static inline dm_vec3 dmi_vec3(const float v[3]) {
    return (dm_vec3){v[0], v[1], v[2]};
}

static inline dm_vec3 dmi_vec3_f64(const double v[3]) {
    return (dm_vec3){(float)v[0], (float)v[1], (float)v[2]};
}

#endif
