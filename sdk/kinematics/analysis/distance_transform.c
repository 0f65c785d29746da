/* Transforms one axis after the other: rows first, then the lower envelope of parabolas along y and z (Saito and
 * Toriwaki 1994), found by halving: many lines at a time. */
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

/* The first and the last of some cells of a line. Where first > last there is none. */
typedef struct range {
    int32_t first, last;
} range;

static int32_t smaller(int32_t a, int32_t b) {
    return b < a ? b : a;
}

static int32_t larger(int32_t a, int32_t b) {
    return b > a ? b : a;
}

/* Computes the least sum of a square and the squared step to it, from cell q itself and the cells of `from`. Returns
 * the range of the cells that gave it, over the lines that hold a sample; {n, 0} where none does. */
static range find_least_scalar(const lines* in, int32_t q, range from, int16_t* out) {
    int16_t near[LANES], source[LANES];
    memcpy(near, in->squares + (size_t)q * in->stride, sizeof near);
    for (int k = 0; k < LANES; k++) source[k] = (int16_t)q;
    for (int32_t p = from.first; p <= from.last; p++) {
        const int16_t* squares = in->squares + (size_t)p * in->stride;
        for (int k = 0; k < LANES; k++) {
            const int16_t square = (int16_t)(squares[k] + (p - q) * (p - q));
            source[k] = square < near[k] ? (int16_t)p : source[k];
            near[k] = square < near[k] ? square : near[k];
        }
    }
    memcpy(out, near, sizeof near);
    range sources = {in->n, 0};
    for (int k = 0; k < LANES; k++) {
        if (near[k] >= EMPTY) continue;
        sources.first = smaller(sources.first, source[k]);
        sources.last = larger(sources.last, source[k]);
    }
    return sources;
}

#if defined(__x86_64__)

#define AVX2 DMI_TARGET("avx2")

/* Returns the least of the numbers, none of which is negative. */
AVX2 static inline int32_t least_of(__m256i x) {
    const __m128i both = _mm_min_epi16(_mm256_castsi256_si128(x), _mm256_extracti128_si256(x, 1));
    return _mm_extract_epi16(_mm_minpos_epu16(both), 0);
}

/* Computes the same numbers with AVX2. */
AVX2 static range find_least_avx2(const lines* in, int32_t q, range from, int16_t* out) {
    __m256i near = _mm256_loadu_si256((const __m256i*)(in->squares + (size_t)q * in->stride));
    __m256i source = _mm256_set1_epi16((int16_t)q);
    for (int32_t p = from.first; p <= from.last; p++) {
        const __m256i squares = _mm256_loadu_si256((const __m256i*)(in->squares + (size_t)p * in->stride));
        const __m256i square = _mm256_add_epi16(squares, _mm256_set1_epi16((int16_t)((p - q) * (p - q))));
        source = _mm256_blendv_epi8(source, _mm256_set1_epi16((int16_t)p), _mm256_cmpgt_epi16(near, square));
        near = _mm256_min_epi16(near, square);
    }
    _mm256_storeu_si256((__m256i*)out, near);
    const __m256i n = _mm256_set1_epi16((int16_t)in->n), used = _mm256_cmpgt_epi16(_mm256_set1_epi16(EMPTY), near);
    const __m256i behind = _mm256_blendv_epi8(n, _mm256_sub_epi16(n, source), used);
    return (range){least_of(_mm256_blendv_epi8(n, source, used)), in->n - least_of(behind)};
}

#endif

static range find_least(const lines* in, int32_t q, range from, int16_t* out) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return find_least_avx2(in, q, from, out);
#endif
    return find_least_scalar(in, q, from, out);
}

/* Computes the cells in [first, last] of the lines. Their least sums come from cells of `from`. A later cell's comes
 * from no earlier cell, so that the middle cell divides `from` between the two halves. */
static void transform_lines(const lines* in, int32_t first, int32_t last, range from, size_t out_stride, int16_t* out) {
    if (first > last) return;
    const int32_t middle = first + (last - first) / 2;
    const range sources = find_least(in, middle, from, out + (size_t)middle * out_stride);
    const range before = {from.first, smaller(sources.last, from.last)};
    const range after = {larger(sources.first, from.first), from.last};
    transform_lines(in, first, middle - 1, before, out_stride, out);
    transform_lines(in, middle + 1, last, after, out_stride, out);
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

void dmi_distance_transform(dmi_distance_grid* grid) {
    const size_t nx = (size_t)grid->size[0], ny = (size_t)grid->size[1], slab = nx * ny;
    const size_t cells = slab * (size_t)grid->size[2];
    for (size_t r = 0; r < cells; r += nx) transform_row(grid->start + r, grid->size[0], grid->in_row + r);
    for (size_t c = cells; c < cells + LANES; c++) grid->in_row[c] = grid->in_slab[c] = EMPTY;
    for (size_t z = 0; z < cells; z += slab)
        for (size_t x = 0; x < nx; x = next_block(x, nx)) {
            const lines in = {grid->in_row + z + x, nx, grid->size[1]};
            transform_lines(&in, 0, in.n - 1, (range){0, in.n - 1}, nx, grid->in_slab + z + x);
        }
    for (size_t c = 0; c < slab; c = next_block(c, slab)) {
        const lines in = {grid->in_slab + c, slab, grid->size[2]};
        transform_lines(&in, 0, in.n - 1, (range){0, in.n - 1}, slab, grid->square + c);
    }
}
