/* Keeps coordinates separated, so that the loops vectorise over points. */
#include "kinematics/analysis/batched_transform.h"

#include <stdbool.h>

#include "base/compiler.h"
#include "base/cpu.h"
#include "math/linear3.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

uint32_t dmi_put_free_points_first(const dmi_distance_grid* grid, const float (*points)[3], uint32_t count,
                                   float (*out)[3]) {
    uint32_t free = 0, held = count;
    for (uint32_t i = 0; i < count; i++) {
        const bool is_free = dmi_distance_grid_distance(grid, points[i]) > DMI_TOUCH_CELLS * grid->cell;
        dmi_copy3(points[i], out[is_free ? free++ : --held]);
    }
    return free;
}

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

/* The place that all points of a transform move to. */
typedef struct place {
    float cosine, sine, along[3];
} place;

static void move_points(const dmi_batched_transform* t, const place* to, float at[3][DMI_POINT_BATCH]) {
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < t->count; i++)
            at[k][i] = t->base[k][i] + to->cosine * t->radial[k][i] + to->sine * t->tangent[k][i] + to->along[k];
}

static void distances_scalar(const dmi_batched_transform* transform, const place* to, const dmi_distance_grid* grid,
                             float* out) {
    float at[3][DMI_POINT_BATCH];
    move_points(transform, to, at);
    dmi_distance_grid_distances(grid, (const float(*)[DMI_POINT_BATCH])at, transform->count, out);
}

static void meetings_scalar(const dmi_batched_transform* transform, const place* to, const dmi_distance_grid* grid,
                            int32_t* out) {
    float at[3][DMI_POINT_BATCH];
    move_points(transform, to, at);
    for (uint32_t i = 0; i < transform->count; i++) {
        const float point[3] = {at[0][i], at[1][i], at[2][i]};
        out[i] = dmi_distance_grid_holds(grid, point);
    }
}

#if defined(__x86_64__)

#define AVX2 DMI_TARGET("avx2")

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

/* Moves DMI_TRANSFORM_BATCH points from the i-th on. Returns their cells, and the squared distances from the grid. Does
 * the same operations in the same order as the scalar code, so that the result has the same bits. */
AVX2 static inline __m256i move_to_cells(const dmi_batched_transform* t, uint32_t i, const place* to,
                                         const dmi_distance_grid* grid, __m256* out_outside) {
    const __m256 c = _mm256_set1_ps(to->cosine), s = _mm256_set1_ps(to->sine);
    __m256i index = _mm256_setzero_si256();
    *out_outside = _mm256_setzero_ps();
    for (int k = 2; k >= 0; k--) {
        const __m256 radial = _mm256_mul_ps(c, _mm256_loadu_ps(&t->radial[k][i]));
        const __m256 tangent = _mm256_mul_ps(s, _mm256_loadu_ps(&t->tangent[k][i]));
        const __m256 turned = _mm256_add_ps(_mm256_add_ps(_mm256_loadu_ps(&t->base[k][i]), radial), tangent);
        const __m256 x = _mm256_add_ps(turned, _mm256_set1_ps(to->along[k]));
        const __m256 at = clamp_to_cells(x, grid->low[k], grid->per_cell, (float)(grid->size[k] - 1), out_outside);
        index = _mm256_add_epi32(_mm256_mullo_epi32(index, _mm256_set1_epi32(grid->size[k])), _mm256_cvttps_epi32(at));
    }
    return index;
}

/* Gathers squares of 16 bits from an array that has elements to spare. */
AVX2 static inline __m256 gather_squares(const int16_t* squares, __m256i index) {
    const __m256i pairs = _mm256_i32gather_epi32((const int32_t*)(const void*)squares, index, sizeof *squares);
    return _mm256_cvtepi32_ps(_mm256_and_si256(pairs, _mm256_set1_epi32(0xffff))); /* literal: the lower half */
}

AVX2 static void distances_avx2(const dmi_batched_transform* transform, const place* to, const dmi_distance_grid* grid,
                                float* out) {
    const __m256 cell = _mm256_set1_ps(grid->cell);
    for (uint32_t i = 0; i < transform->count; i += DMI_TRANSFORM_BATCH) {
        __m256 outside;
        const __m256i index = move_to_cells(transform, i, to, grid, &outside);
        const __m256 inside = _mm256_mul_ps(_mm256_sqrt_ps(gather_squares(grid->square, index)), cell);
        _mm256_storeu_ps(&out[i], _mm256_add_ps(inside, _mm256_mul_ps(_mm256_sqrt_ps(outside), cell)));
    }
}

AVX2 static void meetings_avx2(const dmi_batched_transform* transform, const place* to, const dmi_distance_grid* grid,
                               int32_t* out) {
    for (uint32_t i = 0; i < transform->count; i += DMI_TRANSFORM_BATCH) {
        __m256 outside;
        const __m256i index = move_to_cells(transform, i, to, grid, &outside);
        const __m256i words = _mm256_i32gather_epi32((const int32_t*)(const void*)grid->holding,
                                                     _mm256_srli_epi32(index, DMI_HOLDING_SHIFT), sizeof(uint32_t));
        const __m256i bit = _mm256_and_si256(index, _mm256_set1_epi32(DMI_HOLDING_MASK));
        const __m256 within = _mm256_cmp_ps(outside, _mm256_setzero_ps(), _CMP_EQ_OQ);
        const __m256i one = _mm256_and_si256(_mm256_castps_si256(within), _mm256_set1_epi32(1));
        _mm256_storeu_si256((__m256i*)&out[i], _mm256_and_si256(_mm256_srlv_epi32(words, bit), one));
    }
}

#endif

static place make_place(const dmi_batched_transform* transform, float cosine, float sine, float shift) {
    const float* axis = transform->axis;
    return (place){cosine, sine, {shift * axis[0], shift * axis[1], shift * axis[2]}};
}

void dmi_batched_transform_distances(const dmi_batched_transform* transform, float cosine, float sine, float shift,
                                     const dmi_distance_grid* grid, float out[DMI_POINT_BATCH]) {
    const place to = make_place(transform, cosine, sine, shift);
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR && transform->count % DMI_TRANSFORM_BATCH == 0) {
        distances_avx2(transform, &to, grid, out);
        return;
    }
#endif
    distances_scalar(transform, &to, grid, out);
}

void dmi_batched_transform_meetings(const dmi_batched_transform* transform, float cosine, float sine, float shift,
                                    const dmi_distance_grid* grid, int32_t out[DMI_POINT_BATCH]) {
    const place to = make_place(transform, cosine, sine, shift);
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR && transform->count % DMI_TRANSFORM_BATCH == 0) {
        meetings_avx2(transform, &to, grid, out);
        return;
    }
#endif
    meetings_scalar(transform, &to, grid, out);
}
