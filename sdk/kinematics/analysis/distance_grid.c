/* Exact Euclidean distance transform of a grid, one direction after the other, and samples by cell. */
#include "kinematics/analysis/distance_grid.h"

#include "base/cpu.h"
#include "math/linear3.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define FAR 1e12f
#define EMPTY 0x4000 /* more than any square in the grid; with a step's added it is still an int16_t */
#define LANES 16

static int32_t smaller(int32_t a, int32_t b) {
    return b < a ? b : a;
}

static int32_t cell_of(const dmi_distance_grid* field, const float point[3]) {
    int32_t index = 0;
    for (int k = 2; k >= 0; k--) {
        int32_t at = (int32_t)floorf((point[k] - field->low[k]) / field->cell);
        if (at < 0 || at >= field->size[k]) return -1;
        index = index * field->size[k] + at;
    }
    return index;
}

/* Counting sort of the samples by cell. */
static dm_result sort_samples(dmi_arena* arena, uint32_t count, size_t cells, dmi_distance_grid* field) {
    int32_t* cell = dmi_arena_push(arena, sizeof *cell * (count + 1));
    field->start = dmi_arena_push(arena, sizeof *field->start * (cells + 2));
    field->order = dmi_arena_push(arena, sizeof *field->order * (count + 1));
    if (cell == NULL || field->start == NULL || field->order == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(field->start, 0, sizeof *field->start * (cells + 2));
    for (uint32_t i = 0; i < count; i++) {
        cell[i] = cell_of(field, field->samples[i]);
        if (cell[i] >= 0) field->start[cell[i] + 2]++, field->count++;
    }
    for (size_t c = 2; c < cells + 2; c++) field->start[c] += field->start[c - 1];
    for (uint32_t i = 0; i < count; i++)
        if (cell[i] >= 0) field->order[field->start[cell[i] + 1]++] = i;
    return DM_OK;
}

/* Lines of the grid that lie beside each other. */
typedef struct lines {
    const int16_t* squares; /* of distances in cells, EMPTY in a line without samples */
    size_t stride;
    int32_t n; /* cells of a line */
} lines;

/* Where it is nearer by way of cells that are a squared step away. */
static inline void go_by(const int16_t* restrict from, int32_t step, int16_t* restrict near) {
    for (int k = 0; k < LANES; k++) {
        const int16_t square = (int16_t)(from[k] + step);
        near[k] = square < near[k] ? square : near[k];
    }
}

static inline int any_beyond(const int16_t near[LANES], const int16_t used[LANES], int32_t step) {
    int16_t any = 0;
    for (int k = 0; k < LANES; k++) any |= (int16_t)((near[k] > (int16_t)step) & used[k]);
    return any;
}

/* The distances of each cell by way of the other cells of its line, outwards until none farther off can be nearer. */
static void spread_plain(const lines* in, size_t out_stride, int16_t* out) {
    int16_t used[LANES];
    for (int k = 0; k < LANES; k++) used[k] = EMPTY;
    for (int32_t q = 0; q < in->n; q++) go_by(in->squares + (size_t)q * in->stride, 0, used);
    for (int k = 0; k < LANES; k++) used[k] = used[k] < EMPTY;
    for (int32_t q = 0; q < in->n; q++) {
        int16_t near[LANES];
        memcpy(near, in->squares + (size_t)q * in->stride, sizeof near);
        for (int32_t r = 1; r < in->n && any_beyond(near, used, r * r); r++) {
            if (q >= r) go_by(in->squares + (size_t)(q - r) * in->stride, r * r, near);
            if (q + r < in->n) go_by(in->squares + (size_t)(q + r) * in->stride, r * r, near);
        }
        memcpy(out + (size_t)q * out_stride, near, sizeof near);
    }
}

#if defined(__x86_64__)

#define AVX2 __attribute__((target("avx2")))

AVX2 static inline __m256i load_lanes(const lines* in, int32_t q) {
    return _mm256_loadu_si256((const __m256i*)(in->squares + (size_t)q * in->stride));
}

/* All lines at once, the same numbers. */
AVX2 static void spread_avx2(const lines* in, size_t out_stride, int16_t* out) {
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

static void spread(const lines* in, size_t out_stride, int16_t* out) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) {
        spread_avx2(in, out_stride, out);
        return;
    }
#endif
    spread_plain(in, out_stride, out);
}

/* Where the lanes begin that are to follow `first` of `count` lines: the last lanes end with the last line and do some
 * lines again. Of fewer lines than lanes the rest runs over into the cells behind, which are done later or are spare.
 */
static size_t next_lanes(size_t first, size_t count) {
    const size_t next = first + LANES;
    return next < count && next + LANES > count ? count - LANES : next;
}

/* The first direction needs no steps: the nearest occupied cell of a row is the last one seen from either side. */
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

static void measure(const int16_t* squares, float cell, float* out) {
    for (int k = 0; k < LANES; k++) out[k] = sqrtf(squares[k] == EMPTY ? FAR : (float)squares[k]) * cell;
}

static void transform(dmi_distance_grid* field) {
    const size_t nx = (size_t)field->size[0], ny = (size_t)field->size[1], nz = (size_t)field->size[2];
    const size_t slab = nx * ny, cells = slab * nz;
    for (size_t r = 0; r < cells; r += nx) transform_row(field->start + r, field->size[0], field->in_row + r);
    for (size_t c = cells; c < cells + LANES; c++) field->in_row[c] = field->in_slab[c] = EMPTY;
    for (size_t z = 0; z < cells; z += slab)
        for (size_t x = 0; x < nx; x = next_lanes(x, nx)) {
            const lines in = {field->in_row + z + x, nx, field->size[1]};
            spread(&in, nx, field->in_slab + z + x);
        }
    for (size_t c = 0; c < slab; c = next_lanes(c, slab)) {
        const lines in = {field->in_slab + c, slab, field->size[2]};
        int16_t squares[DMI_DISTANCE_GRID_CELLS + 2][LANES];
        spread(&in, LANES, squares[0]);
        for (size_t z = 0; z < nz; z++) measure(squares[z], field->cell, field->distance + z * slab + c);
    }
}

dm_result dmi_distance_grid_make(dmi_arena* arena, const float (*samples)[3], uint32_t count, const float low[3],
                                 const float high[3], dmi_distance_grid* out) {
    *out = (dmi_distance_grid){.samples = samples};
    float longest = 1e-6f;
    for (int k = 0; k < 3; k++) longest = dmi_max(longest, high[k] - low[k]);
    out->cell = longest / (DMI_DISTANCE_GRID_CELLS - 1);
    out->per_cell = 1 / out->cell;
    size_t cells = 1;
    for (int k = 0; k < 3; k++) {
        out->low[k] = low[k];
        out->size[k] = (int32_t)ceilf(dmi_max(high[k] - low[k], 0) / out->cell) + 1;
        cells *= (size_t)out->size[k];
    }
    out->distance = dmi_arena_push(arena, sizeof *out->distance * (cells + LANES));
    out->in_row = dmi_arena_push(arena, sizeof *out->in_row * (cells + LANES));
    out->in_slab = dmi_arena_push(arena, sizeof *out->in_slab * (cells + LANES));
    if (out->distance == NULL || out->in_row == NULL || out->in_slab == NULL ||
        sort_samples(arena, count, cells, out) != DM_OK)
        return DM_ERROR_OUT_OF_MEMORY;
    transform(out);
    return DM_OK;
}

void dmi_distance_grid_distances(const dmi_distance_grid* field, const float (*points)[DMI_POINT_BATCH], uint32_t count,
                                 float* out) {
    float outside[DMI_POINT_BATCH];
    int32_t index[DMI_POINT_BATCH];
    for (uint32_t i = 0; i < count; i++) index[i] = 0, outside[i] = 0;
    for (int k = 2; k >= 0; k--) {
        float low = field->low[k], per_cell = field->per_cell, last = (float)(field->size[k] - 1);
        int32_t size = field->size[k];
        for (uint32_t i = 0; i < count; i++) {
            float at = (points[k][i] - low) * per_cell;
            float inside = at < 0 ? 0 : at;
            inside = inside > last ? last : inside;
            float off = (at - inside) * (at - inside);
            outside[i] += off > 1 ? off : 0;
            index[i] = index[i] * size + (int32_t)inside;
        }
    }
    for (uint32_t i = 0; i < count; i++) out[i] = field->distance[index[i]];
    for (uint32_t i = 0; i < count; i++) out[i] += sqrtf(outside[i]) * field->cell;
}

/* Nearest sample in the cells that a box of `reach` round the point touches. */
static uint32_t nearest_within(const dmi_distance_grid* field, const float point[3], float reach, float* out_distance) {
    int32_t from[3], to[3];
    for (int k = 0; k < 3; k++) {
        float at = (point[k] - field->low[k]) / field->cell, r = reach / field->cell,
              last = (float)(field->size[k] - 1);
        from[k] = (int32_t)dmi_min(dmi_max(floorf(at - r), 0), last);
        to[k] = (int32_t)dmi_min(dmi_max(floorf(at + r), 0), last);
    }
    uint32_t best = UINT32_MAX;
    float least = INFINITY;
    for (int32_t z = from[2]; z <= to[2]; z++)
        for (int32_t y = from[1]; y <= to[1]; y++) {
            size_t row = ((size_t)z * (size_t)field->size[1] + (size_t)y) * (size_t)field->size[0];
            uint32_t end = field->start[row + (size_t)to[0] + 1];
            for (uint32_t i = field->start[row + (size_t)from[0]]; i < end; i++) {
                float d[3];
                dmi_sub3(field->samples[field->order[i]], point, d);
                float square = dmi_dot3(d, d);
                if (square < least) least = square, best = field->order[i];
            }
        }
    *out_distance = sqrtf(least);
    return best;
}

/* The cell of a line by way of which the q-th is nearest; of equals the one fewest steps away, and then the lower. */
static int32_t way_along(const int16_t* line, size_t stride, int32_t n, int32_t q) {
    int32_t best = line[(size_t)q * stride], at = q;
    for (int32_t r = 1; r < n && best > r * r; r++)
        for (int32_t from = q - r; from <= q + r; from += 2 * r) {
            if (from < 0 || from >= n || line[(size_t)from * stride] + r * r >= best) continue;
            best = line[(size_t)from * stride] + r * r, at = from;
        }
    return at;
}

/* The nearest occupied cell to the one a point is in or nearest to: the way that the transform came, backwards. */
static size_t source_of(const dmi_distance_grid* field, const float point[3]) {
    const int32_t* size = field->size;
    int32_t at[3];
    for (int k = 0; k < 3; k++) {
        const float x = (point[k] - field->low[k]) * field->per_cell, last = (float)(size[k] - 1);
        at[k] = (int32_t)dmi_min(dmi_max(x, 0), last);
    }
    const size_t nx = (size_t)size[0], slab = nx * (size_t)size[1];
    const size_t x = (size_t)at[0];
    const size_t z = (size_t)way_along(field->in_slab + (size_t)at[1] * nx + x, slab, size[2], at[2]);
    const size_t y = (size_t)way_along(field->in_row + z * slab + x, nx, size[1], at[1]);
    const size_t row = z * slab + y * nx;
    int32_t steps = 0;
    while (steps * steps < field->in_row[row + x]) steps++;
    const size_t below = row + x - (size_t)steps;
    return steps <= at[0] && field->start[below + 1] > field->start[below] ? below : row + x + (size_t)steps;
}

uint32_t dmi_distance_grid_nearest(const dmi_distance_grid* field, const float point[3], float* out_distance) {
    *out_distance = INFINITY;
    if (field->count == 0) return UINT32_MAX;
    /* The nearest occupied cell is `rough` away from this cell's centre: a sample lies within its diagonal of that. */
    float rough = dmi_distance_grid_distance(field, point);
    if (rough <= 1.5f * field->cell) return nearest_within(field, point, rough + 1.733f * field->cell, out_distance);
    const size_t cell = source_of(field, point);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = field->start[cell]; i < field->start[cell + 1]; i++) {
        float d = dmi_distance3(point, field->samples[field->order[i]]);
        if (d < *out_distance) *out_distance = d, best = field->order[i];
    }
    return best;
}
