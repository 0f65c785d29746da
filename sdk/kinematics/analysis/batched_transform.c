/* Keeps coordinates separated, so that the loops vectorise over points. */
#include "kinematics/analysis/batched_transform.h"

#include "base/compiler.h"
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
        float arm[3], foot[3], side[3]; /* foot: the axis point nearest to the point */
        dmi_sub3(points[i], origin, arm);
        dmi_cross3(axis, arm, side);
        dmi_madd3(origin, dmi_dot3(arm, axis), axis, foot);
        for (int k = 0; k < 3; k++) {
            out->base[k][i] = foot[k];
            out->radial[k][i] = points[i][k] - foot[k];
            out->tangent[k][i] = side[k];
        }
    }
}

void dmi_batched_transform_prismatic(const float axis[3], const float (*points)[3], uint32_t count,
                                     dmi_batched_transform* out) {
    dmi_copy3(axis, out->axis);
    out->count = count;
    memset(out->radial, 0, sizeof out->radial);
    memset(out->tangent, 0, sizeof out->tangent);
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) out->base[k][i] = points[i][k];
}

static void distances_scalar(const dmi_batched_transform* transform, float cosine, float sine, const float along[3],
                             const dmi_distance_grid* grid, float out[DMI_POINT_BATCH]) {
    float at[3][DMI_POINT_BATCH];
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < transform->count; i++)
            at[k][i] =
                transform->base[k][i] + cosine * transform->radial[k][i] + sine * transform->tangent[k][i] + along[k];
    dmi_distance_grid_distances(grid, (const float(*)[DMI_POINT_BATCH])at, transform->count, out);
}

#if defined(__x86_64__)

#define AVX2 DMI_TARGET("avx2")
#define AVX2_LANES 8 /* floats of a register */

/* Returns a coordinate in cells, clamped into the grid. Adds the square of the clamped distance where it exceeds a
 * cell. */
AVX2 static inline __m256 clamp_to_cells(__m256 x, float low, float per_cell, float last, __m256* outside) {
    const __m256 at = _mm256_mul_ps(_mm256_sub_ps(x, _mm256_set1_ps(low)), _mm256_set1_ps(per_cell));
    const __m256 inside = _mm256_min_ps(_mm256_max_ps(at, _mm256_setzero_ps()), _mm256_set1_ps(last));
    const __m256 off = _mm256_sub_ps(at, inside), square = _mm256_mul_ps(off, off);
    const __m256 far = _mm256_cmp_ps(square, _mm256_set1_ps(1), _CMP_GT_OQ);
    *outside = _mm256_add_ps(*outside, _mm256_and_ps(square, far));
    return inside;
}

/* Does the same operations in the same order on AVX2_LANES points at a time, so that the result has the same bits. */
AVX2 static void distances_avx2(const dmi_batched_transform* transform, float cosine, float sine, const float along[3],
                                const dmi_distance_grid* grid, float out[DMI_POINT_BATCH]) {
    const __m256 c = _mm256_set1_ps(cosine), s = _mm256_set1_ps(sine);
    for (uint32_t i = 0; i < transform->count; i += AVX2_LANES) {
        __m256 outside = _mm256_setzero_ps();
        __m256i index = _mm256_setzero_si256();
        for (int k = 2; k >= 0; k--) {
            const __m256 radial = _mm256_mul_ps(c, _mm256_loadu_ps(&transform->radial[k][i]));
            const __m256 tangent = _mm256_mul_ps(s, _mm256_loadu_ps(&transform->tangent[k][i]));
            const __m256 turned =
                _mm256_add_ps(_mm256_add_ps(_mm256_loadu_ps(&transform->base[k][i]), radial), tangent);
            const __m256 x = _mm256_add_ps(turned, _mm256_set1_ps(along[k]));
            const __m256 inside = clamp_to_cells(x, grid->low[k], grid->per_cell, (float)(grid->size[k] - 1), &outside);
            index = _mm256_add_epi32(_mm256_mullo_epi32(index, _mm256_set1_epi32(grid->size[k])),
                                     _mm256_cvttps_epi32(inside));
        }
        const __m256 gap = _mm256_mul_ps(_mm256_sqrt_ps(outside), _mm256_set1_ps(grid->cell));
        _mm256_storeu_ps(&out[i], _mm256_add_ps(_mm256_i32gather_ps(grid->distance, index, sizeof(float)), gap));
    }
}

#endif

void dmi_batched_transform_distances(const dmi_batched_transform* transform, float cosine, float sine, float shift,
                                     const dmi_distance_grid* grid, float out[DMI_POINT_BATCH]) {
    const float along[3] = {shift * transform->axis[0], shift * transform->axis[1], shift * transform->axis[2]};
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR && transform->count % AVX2_LANES == 0) {
        distances_avx2(transform, cosine, sine, along, grid, out);
        return;
    }
#endif
    distances_scalar(transform, cosine, sine, along, grid, out);
}
