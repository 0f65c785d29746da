/* Linear algebra in three dimensions: float vectors, symmetric eigenproblems, perpendicular frames. */
#ifndef DMI_MATH_LINEAR3_H
#define DMI_MATH_LINEAR3_H

#include <math.h>
#include <stdint.h>
#include <string.h>

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
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void dmi_cross3(const float a[3], const float b[3], float out[3]) {
    float x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    out[0] = x, out[1] = y, out[2] = z;
}

static inline void dmi_sub3(const float a[3], const float b[3], float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[i] - b[i];
}

static inline void dmi_add3(const float a[3], const float b[3], float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[i] + b[i];
}

static inline void dmi_scale3(const float a[3], float s, float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[i] * s;
}

/* out = a + s b */
static inline void dmi_madd3(const float a[3], float s, const float b[3], float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[i] + s * b[i];
}

static inline void dmi_copy3(const float a[3], float out[3]) {
    memcpy(out, a, 3 * sizeof(float));
}

/* As hypotf, but with the same bits from every C library. */
static inline float dmi_length2(float x, float y) {
    return (float)sqrt((double)x * x + (double)y * y);
}

static inline float dmi_length3(const float a[3]) {
    return sqrtf(dmi_dot3(a, a));
}

static inline float dmi_distance3(const float a[3], const float b[3]) {
    float d[3];
    dmi_sub3(a, b, d);
    return dmi_length3(d);
}

/* Scales to unit length and returns the former length; leaves vectors shorter than 1e-20 (rounding) as they are. */
static inline float dmi_normalize3(float a[3]) {
    float length = dmi_length3(a);
    if (length > 1e-20f)
        for (int i = 0; i < 3; i++) a[i] /= length;
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
    float d[3], c[3];
    dmi_sub3(point, origin, d);
    dmi_cross3(axis, d, c);
    float along = dmi_dot3(axis, d) * (1 - cosine);
    for (int i = 0; i < 3; i++) out[i] = origin[i] + d[i] * cosine + c[i] * sine + axis[i] * along;
}

#endif
