/* Coordinates apart, so that the loops run many points at a time. */
#include "kinematics/analysis/batched_transform.h"

#include "base/cpu.h"
#include "math/linear3.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

void dmi_batched_transform_revolute(const float axis[3], const float origin[3], const float (*points)[3],
                                    uint32_t count, dmi_batched_transform* out) {
    dmi_copy3(axis, out->axis);
    out->count = count;
    for (uint32_t i = 0; i < count; i++) {
        float arm[3], along[3], side[3];
        dmi_sub3(points[i], origin, arm);
        dmi_cross3(axis, arm, side);
        dmi_madd3(origin, dmi_dot3(arm, axis), axis, along);
        for (int k = 0; k < 3; k++) {
            out->base[k][i] = along[k];
            out->across[k][i] = points[i][k] - along[k];
            out->beside[k][i] = side[k];
        }
    }
}

void dmi_batched_transform_prismatic(const float axis[3], const float (*points)[3], uint32_t count,
                                     dmi_batched_transform* out) {
    dmi_copy3(axis, out->axis);
    out->count = count;
    memset(out->across, 0, sizeof out->across);
    memset(out->beside, 0, sizeof out->beside);
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) out->base[k][i] = points[i][k];
}

static void distances_plain(const dmi_batched_transform* moved, float cosine, float sine, const float along[3],
                            const dmi_distance_grid* field, float out[DMI_POINT_BATCH]) {
    float at[3][DMI_POINT_BATCH];
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < moved->count; i++)
            at[k][i] = moved->base[k][i] + cosine * moved->across[k][i] + sine * moved->beside[k][i] + along[k];
    dmi_distance_grid_distances(field, (const float(*)[DMI_POINT_BATCH])at, moved->count, out);
}

#if defined(__x86_64__)

#define AVX2 __attribute__((target("avx2")))

/* One coordinate in cells: clamped into the grid, and the square of what that took where it is more than a cell. */
AVX2 static inline __m256 cells(__m256 x, float low, float per_cell, float last, __m256* outside) {
    const __m256 at = _mm256_mul_ps(_mm256_sub_ps(x, _mm256_set1_ps(low)), _mm256_set1_ps(per_cell));
    const __m256 inside = _mm256_min_ps(_mm256_max_ps(at, _mm256_setzero_ps()), _mm256_set1_ps(last));
    const __m256 off = _mm256_sub_ps(at, inside), square = _mm256_mul_ps(off, off);
    const __m256 far = _mm256_cmp_ps(square, _mm256_set1_ps(1), _CMP_GT_OQ);
    *outside = _mm256_add_ps(*outside, _mm256_and_ps(square, far));
    return inside;
}

/* The same operations in the same order, eight points at a time: the same bits. */
AVX2 static void distances_avx2(const dmi_batched_transform* moved, float cosine, float sine, const float along[3],
                                const dmi_distance_grid* field, float out[DMI_POINT_BATCH]) {
    const __m256 c = _mm256_set1_ps(cosine), s = _mm256_set1_ps(sine);
    for (uint32_t i = 0; i < moved->count; i += 8) {
        __m256 outside = _mm256_setzero_ps();
        __m256i index = _mm256_setzero_si256();
        for (int k = 2; k >= 0; k--) {
            const __m256 across = _mm256_mul_ps(c, _mm256_loadu_ps(&moved->across[k][i]));
            const __m256 beside = _mm256_mul_ps(s, _mm256_loadu_ps(&moved->beside[k][i]));
            const __m256 turned = _mm256_add_ps(_mm256_add_ps(_mm256_loadu_ps(&moved->base[k][i]), across), beside);
            const __m256 x = _mm256_add_ps(turned, _mm256_set1_ps(along[k]));
            const __m256 inside = cells(x, field->low[k], field->per_cell, (float)(field->size[k] - 1), &outside);
            index = _mm256_add_epi32(_mm256_mullo_epi32(index, _mm256_set1_epi32(field->size[k])),
                                     _mm256_cvttps_epi32(inside));
        }
        const __m256 way = _mm256_mul_ps(_mm256_sqrt_ps(outside), _mm256_set1_ps(field->cell));
        _mm256_storeu_ps(&out[i], _mm256_add_ps(_mm256_i32gather_ps(field->distance, index, 4), way));
    }
}

#endif

void dmi_batched_transform_distances(const dmi_batched_transform* moved, float cosine, float sine, float shift,
                                     const dmi_distance_grid* field, float out[DMI_POINT_BATCH]) {
    const float along[3] = {shift * moved->axis[0], shift * moved->axis[1], shift * moved->axis[2]};
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR && moved->count % 8 == 0) {
        distances_avx2(moved, cosine, sine, along, field, out);
        return;
    }
#endif
    distances_plain(moved, cosine, sine, along, field, out);
}
