/* Transforms one axis after the other: rows first, then the lower envelope of parabolas along y and z (Saito and
 * Toriwaki 1994), by brute force outwards from each cell, many lines at a time. */
#include "kinematics/analysis/distance_grid.h"

#include <stdbool.h>

#include "base/compiler.h"
#include "base/cpu.h"
#include "math/linear3.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define EMPTY 0x4000 /* greater than any squared distance in the grid; the sum of both still fits an int16_t */
#define LANES DMI_TRANSFORM_LANES

/* LANES lines of the grid, side by side. */
typedef struct lines {
    const int16_t* squares; /* squared distances in cells so far; EMPTY: no sample in reach */
    size_t stride;          /* step between the cells of a line */
    int32_t n;              /* cells of a line */
} lines;

static int32_t smaller(int32_t a, int32_t b) {
    return b < a ? b : a;
}

/* Lowers `near` to the squares of other cells plus the squared step to them. */
static inline void lower_by(const int16_t* restrict from, int32_t step, int16_t* restrict near) {
    for (int k = 0; k < LANES; k++) {
        const int16_t square = (int16_t)(from[k] + step);
        near[k] = square < near[k] ? square : near[k];
    }
}

/* Returns whether any used lane has a square above the squared step. */
static inline bool any_above(const int16_t near[LANES], const int16_t used[LANES], int32_t step) {
    int16_t any = 0;
    for (int k = 0; k < LANES; k++) any |= (int16_t)((near[k] > (int16_t)step) & used[k]);
    return any;
}

/* Computes each cell's least sum of a square in its line and the squared step to it, from step 1 outwards until no
 * farther cell can lower it. */
static void transform_lines_scalar(const lines* in, size_t out_stride, int16_t* out) {
    int16_t used[LANES];
    for (int k = 0; k < LANES; k++) used[k] = EMPTY;
    for (int32_t q = 0; q < in->n; q++) lower_by(in->squares + (size_t)q * in->stride, 0, used);
    for (int k = 0; k < LANES; k++) used[k] = used[k] < EMPTY;
    for (int32_t q = 0; q < in->n; q++) {
        int16_t near[LANES];
        memcpy(near, in->squares + (size_t)q * in->stride, sizeof near);
        for (int32_t r = 1; r < in->n && any_above(near, used, r * r); r++) {
            if (q >= r) lower_by(in->squares + (size_t)(q - r) * in->stride, r * r, near);
            if (q + r < in->n) lower_by(in->squares + (size_t)(q + r) * in->stride, r * r, near);
        }
        memcpy(out + (size_t)q * out_stride, near, sizeof near);
    }
}

#if defined(__x86_64__)

#define AVX2 DMI_TARGET("avx2")

AVX2 static inline __m256i load_lanes(const lines* in, int32_t q) {
    return _mm256_loadu_si256((const __m256i*)(in->squares + (size_t)q * in->stride));
}

/* Computes the same numbers with AVX2. */
AVX2 static void transform_lines_avx2(const lines* in, size_t out_stride, int16_t* out) {
    __m256i least = _mm256_set1_epi16(EMPTY);
    for (int32_t q = 0; q < in->n; q++) least = _mm256_min_epi16(least, load_lanes(in, q));
    const __m256i used = _mm256_cmpgt_epi16(_mm256_set1_epi16(EMPTY), least);
    for (int32_t q = 0; q < in->n; q++) {
        __m256i near = load_lanes(in, q);
        for (int32_t r = 1; r < in->n; r++) {
            const __m256i step = _mm256_set1_epi16((int16_t)(r * r));
            if (_mm256_testz_si256(used, _mm256_cmpgt_epi16(near, step))) break;
            if (q >= r) near = _mm256_min_epi16(near, _mm256_add_epi16(load_lanes(in, q - r), step));
            if (q + r < in->n) near = _mm256_min_epi16(near, _mm256_add_epi16(load_lanes(in, q + r), step));
        }
        _mm256_storeu_si256((__m256i*)(out + (size_t)q * out_stride), near);
    }
}

#endif

static void transform_lines(const lines* in, size_t out_stride, int16_t* out) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) {
        transform_lines_avx2(in, out_stride, out);
        return;
    }
#endif
    transform_lines_scalar(in, out_stride, out);
}

/* Returns the first line of the block after the one at `first`. The last block ends with the last line and repeats some
 * lines. With fewer lines than lanes, the block extends over cells that are computed later or are spare. */
static size_t next_block(size_t first, size_t count) {
    const size_t next = first + LANES;
    return next < count && next + LANES > count ? count - LANES : next;
}

/* Computes a row's squared distances: the nearest occupied cell is the last one met from either side. */
static void transform_row(const uint32_t* start, int32_t n, int16_t* out) {
    if (start[n] == start[0]) {
        for (int32_t q = 0; q < n; q++) out[q] = EMPTY;
        return;
    }
    int32_t last = -1;
    for (int32_t q = 0; q < n; q++) {
        if (start[q + 1] > start[q]) last = q;
        out[q] = last < 0 ? EMPTY : (int16_t)((q - last) * (q - last));
    }
    last = -1;
    for (int32_t q = n - 1; q >= 0; q--) {
        if (start[q + 1] > start[q]) last = q;
        if (last >= 0) out[q] = (int16_t)smaller(out[q], (last - q) * (last - q));
    }
}

static void write_distances(const int16_t* squares, float cell, float* out) {
    for (int k = 0; k < LANES; k++) out[k] = sqrtf((float)squares[k]) * cell;
}

void dmi_distance_transform(dmi_distance_grid* grid) {
    const size_t nx = (size_t)grid->size[0], ny = (size_t)grid->size[1], nz = (size_t)grid->size[2];
    const size_t slab = nx * ny, cells = slab * nz;
    for (size_t r = 0; r < cells; r += nx) transform_row(grid->start + r, grid->size[0], grid->in_row + r);
    for (size_t c = cells; c < cells + LANES; c++) grid->in_row[c] = grid->in_slab[c] = EMPTY;
    for (size_t z = 0; z < cells; z += slab)
        for (size_t x = 0; x < nx; x = next_block(x, nx)) {
            const lines in = {grid->in_row + z + x, nx, grid->size[1]};
            transform_lines(&in, nx, grid->in_slab + z + x);
        }
    for (size_t c = 0; c < slab; c = next_block(c, slab)) {
        const lines in = {grid->in_slab + c, slab, grid->size[2]};
        int16_t squares[DMI_DISTANCE_GRID_CELLS + 2][LANES];
        transform_lines(&in, LANES, squares[0]);
        for (size_t z = 0; z < nz; z++) write_distances(squares[z], grid->cell, grid->distance + z * slab + c);
    }
}
