/* Four floats at once: SSE2, NEON or plain C. Minimum and maximum give the second operand where the first is NaN. */
#ifndef DMI_PICK_LANES_H
#define DMI_PICK_LANES_H

#include <stdint.h>

#if defined(__SSE2__)
#include <emmintrin.h>

typedef __m128 dmi_lanes;

static inline dmi_lanes dmi_lanes_load(const float* p) {
    return _mm_loadu_ps(p);
}
static inline void dmi_lanes_store(float* p, dmi_lanes a) {
    _mm_storeu_ps(p, a);
}
static inline dmi_lanes dmi_lanes_all(float x) {
    return _mm_set1_ps(x);
}
static inline dmi_lanes dmi_lanes_add(dmi_lanes a, dmi_lanes b) {
    return _mm_add_ps(a, b);
}
static inline dmi_lanes dmi_lanes_sub(dmi_lanes a, dmi_lanes b) {
    return _mm_sub_ps(a, b);
}
static inline dmi_lanes dmi_lanes_mul(dmi_lanes a, dmi_lanes b) {
    return _mm_mul_ps(a, b);
}
static inline dmi_lanes dmi_lanes_min(dmi_lanes a, dmi_lanes b) {
    return _mm_min_ps(a, b);
}
static inline dmi_lanes dmi_lanes_max(dmi_lanes a, dmi_lanes b) {
    return _mm_max_ps(a, b);
}
/* Bit i is set where a <= b in lane i. */
static inline uint32_t dmi_lanes_less_equal(dmi_lanes a, dmi_lanes b) {
    return (uint32_t)_mm_movemask_ps(_mm_cmple_ps(a, b));
}

#elif defined(__aarch64__)
#include <arm_neon.h>

typedef float32x4_t dmi_lanes;

static inline dmi_lanes dmi_lanes_load(const float* p) {
    return vld1q_f32(p);
}
static inline void dmi_lanes_store(float* p, dmi_lanes a) {
    vst1q_f32(p, a);
}
static inline dmi_lanes dmi_lanes_all(float x) {
    return vdupq_n_f32(x);
}
static inline dmi_lanes dmi_lanes_add(dmi_lanes a, dmi_lanes b) {
    return vaddq_f32(a, b);
}
static inline dmi_lanes dmi_lanes_sub(dmi_lanes a, dmi_lanes b) {
    return vsubq_f32(a, b);
}
static inline dmi_lanes dmi_lanes_mul(dmi_lanes a, dmi_lanes b) {
    return vmulq_f32(a, b);
}
static inline dmi_lanes dmi_lanes_min(dmi_lanes a, dmi_lanes b) {
    return vbslq_f32(vcltq_f32(a, b), a, b);
}
static inline dmi_lanes dmi_lanes_max(dmi_lanes a, dmi_lanes b) {
    return vbslq_f32(vcgtq_f32(a, b), a, b);
}
static inline uint32_t dmi_lanes_less_equal(dmi_lanes a, dmi_lanes b) {
    static const uint32_t bits[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(vcleq_f32(a, b), vld1q_u32(bits)));
}

#else

typedef struct dmi_lanes {
    float v[4];
} dmi_lanes;

#define DMI_LANES_EACH(expression)                                                                                     \
    dmi_lanes r;                                                                                                       \
    for (int i = 0; i < 4; i++) r.v[i] = (expression);                                                                 \
    return r

static inline dmi_lanes dmi_lanes_load(const float* p) {
    DMI_LANES_EACH(p[i]);
}
static inline void dmi_lanes_store(float* p, dmi_lanes a) {
    for (int i = 0; i < 4; i++) p[i] = a.v[i];
}
static inline dmi_lanes dmi_lanes_all(float x) {
    DMI_LANES_EACH(x);
}
static inline dmi_lanes dmi_lanes_add(dmi_lanes a, dmi_lanes b) {
    DMI_LANES_EACH(a.v[i] + b.v[i]);
}
static inline dmi_lanes dmi_lanes_sub(dmi_lanes a, dmi_lanes b) {
    DMI_LANES_EACH(a.v[i] - b.v[i]);
}
static inline dmi_lanes dmi_lanes_mul(dmi_lanes a, dmi_lanes b) {
    DMI_LANES_EACH(a.v[i] * b.v[i]);
}
static inline dmi_lanes dmi_lanes_min(dmi_lanes a, dmi_lanes b) {
    DMI_LANES_EACH(a.v[i] < b.v[i] ? a.v[i] : b.v[i]);
}
static inline dmi_lanes dmi_lanes_max(dmi_lanes a, dmi_lanes b) {
    DMI_LANES_EACH(a.v[i] > b.v[i] ? a.v[i] : b.v[i]);
}
static inline uint32_t dmi_lanes_less_equal(dmi_lanes a, dmi_lanes b) {
    uint32_t mask = 0;
    for (uint32_t i = 0; i < 4; i++) mask |= (uint32_t)(a.v[i] <= b.v[i]) << i;
    return mask;
}

#endif

#endif
