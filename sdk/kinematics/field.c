/* Exact Euclidean distance transform of a grid, one direction after the other, and samples by cell. */
#include "kinematics/field.h"

#include "base/cpu.h"
#include "kinematics/linear3.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define FAR 1e12f
#define LANES 8

static int32_t cell_of(const dmi_field* field, const float point[3]) {
    int32_t index = 0;
    for (int k = 2; k >= 0; k--) {
        int32_t at = (int32_t)floorf((point[k] - field->low[k]) / field->cell);
        if (at < 0 || at >= field->size[k]) return -1;
        index = index * field->size[k] + at;
    }
    return index;
}

/* Counting sort of the samples by cell. */
static dm_result sort_samples(dmi_arena* arena, uint32_t count, size_t cells, dmi_field* field) {
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

/* Lines of the grid that lie beside each other: squared distances in cells, which are small integers and so exact, and
 * the cells they are from. */
typedef struct lanes {
    float square[DMI_FIELD_CELLS + 2][LANES];
    uint32_t source[DMI_FIELD_CELLS + 2][LANES];
    float least[LANES]; /* of each line */
} lanes;

static void copy_lanes(void* to, const void* from, size_t count) {
    if (count == LANES)
        memcpy(to, from, 4 * LANES);
    else
        memcpy(to, from, 4 * count);
}

/* Lines beyond `count` are empty. Answers whether any is not. */
static int load_lanes(const float* line, const uint32_t* source, size_t stride, int32_t n, size_t count, lanes* out) {
    for (int l = 0; l < LANES; l++) out->least[l] = FAR;
    for (int32_t q = 0; q < n; q++) {
        for (size_t l = count; l < LANES; l++) out->square[q][l] = FAR, out->source[q][l] = 0;
        copy_lanes(out->square[q], line + (size_t)q * stride, count);
        copy_lanes(out->source[q], source + (size_t)q * stride, count);
        for (int l = 0; l < LANES; l++) out->least[l] = dmi_min(out->least[l], out->square[q][l]);
    }
    int any = 0;
    for (int l = 0; l < LANES; l++) any |= out->least[l] < FAR;
    return any;
}

/* The distances of each cell by way of the other cells of its line, outwards until none farther off can be nearer.
 * Empty lines stay so: the squares of steps are lost beside FAR. */
static void spread_plain(const lanes* in, int32_t n, lanes* out) {
    for (int32_t q = 0; q < n; q++) {
        float* best = out->square[q];
        memcpy(best, in->square[q], sizeof in->square[q]);
        memcpy(out->source[q], in->source[q], sizeof in->source[q]);
        for (int32_t r = 1; r < n; r++) {
            const float step = (float)(r * r);
            int farther = 0;
            for (int l = 0; l < LANES; l++) farther |= best[l] > step && in->least[l] < FAR;
            if (!farther) break;
            for (int32_t from = q - r; from <= q + r; from += 2 * r)
                for (int l = 0; l < LANES && from >= 0 && from < n; l++) {
                    const float square = in->square[from][l] + step;
                    if (square < best[l]) best[l] = square, out->source[q][l] = in->source[from][l];
                }
        }
    }
}

#if defined(__x86_64__)

#define AVX2 __attribute__((target("avx2")))

/* What is nearer by way of a cell that is a squared step away. */
AVX2 static inline void go_by(const lanes* in, int32_t from, __m256 step, __m256* near, __m256* source) {
    const __m256 square = _mm256_add_ps(_mm256_loadu_ps(in->square[from]), step);
    const __m256 nearer = _mm256_cmp_ps(square, *near, _CMP_LT_OQ);
    *source = _mm256_blendv_ps(*source, _mm256_loadu_ps((const float*)in->source[from]), nearer);
    *near = _mm256_min_ps(square, *near);
}

/* The same for eight lines at once: the same bits. */
AVX2 static void spread_avx2(const lanes* in, int32_t n, lanes* out) {
    const __m256 used = _mm256_cmp_ps(_mm256_loadu_ps(in->least), _mm256_set1_ps(FAR), _CMP_LT_OQ);
    for (int32_t q = 0; q < n; q++) {
        __m256 near = _mm256_loadu_ps(in->square[q]), source = _mm256_loadu_ps((const float*)in->source[q]);
        for (int32_t r = 1; r < n; r++) {
            const __m256 step = _mm256_set1_ps((float)(r * r));
            if (_mm256_movemask_ps(_mm256_and_ps(used, _mm256_cmp_ps(near, step, _CMP_GT_OQ))) == 0) break;
            if (q >= r) go_by(in, q - r, step, &near, &source);
            if (q + r < n) go_by(in, q + r, step, &near, &source);
        }
        _mm256_storeu_ps(out->square[q], near);
        _mm256_storeu_ps((float*)out->source[q], source);
    }
}

#endif

/* One direction of the grid: `count` lines of n cells, side by side. */
static void transform_lines(float* line, uint32_t* source, size_t stride, int32_t n, size_t count) {
    void (*spread)(const lanes*, int32_t, lanes*) = spread_plain;
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) spread = spread_avx2;
#endif
    lanes before, after;
    for (size_t first = 0; first < count; first += LANES) {
        const size_t some = count - first < LANES ? count - first : LANES;
        if (!load_lanes(line + first, source + first, stride, n, some, &before)) continue;
        spread(&before, n, &after);
        for (int32_t q = 0; q < n; q++) {
            copy_lanes(line + first + (size_t)q * stride, after.square[q], some);
            copy_lanes(source + first + (size_t)q * stride, after.source[q], some);
        }
    }
}

/* The first direction needs no parabolas: the nearest occupied cell of a row is the last one seen from either side. */
static void transform_row(float* line, uint32_t* source, const uint32_t* start, uint32_t first, int32_t n) {
    int32_t last = -1;
    for (int32_t q = 0; q < n; q++) {
        if (start[q + 1] > start[q]) last = q;
        line[q] = last < 0 ? FAR : (float)((q - last) * (q - last));
        source[q] = first + (uint32_t)(last < 0 ? q : last);
    }
    last = -1;
    for (int32_t q = n - 1; q >= 0; q--) {
        if (start[q + 1] > start[q]) last = q;
        const float square = last < 0 ? FAR : (float)((last - q) * (last - q));
        if (square < line[q]) line[q] = square, source[q] = first + (uint32_t)last;
    }
}

static void transform(dmi_field* field) {
    const size_t nx = (size_t)field->size[0], ny = (size_t)field->size[1], nz = (size_t)field->size[2];
    const size_t slab = nx * ny, cells = slab * nz;
    float* d = field->distance;
    uint32_t* s = field->source;
    for (size_t r = 0; r < cells; r += nx) transform_row(d + r, s + r, field->start + r, (uint32_t)r, (int32_t)nx);
    for (size_t z = 0; z < cells; z += slab) transform_lines(d + z, s + z, nx, (int32_t)ny, nx);
    transform_lines(d, s, slab, (int32_t)nz, slab);
    for (size_t c = 0; c < cells; c++) d[c] = sqrtf(d[c]) * field->cell;
}

dm_result dmi_field_make(dmi_arena* arena, const float (*samples)[3], uint32_t count, const float low[3],
                         const float high[3], dmi_field* out) {
    *out = (dmi_field){.samples = samples};
    float longest = 1e-6f;
    for (int k = 0; k < 3; k++) longest = dmi_max(longest, high[k] - low[k]);
    out->cell = longest / (DMI_FIELD_CELLS - 1);
    out->per_cell = 1 / out->cell;
    size_t cells = 1;
    for (int k = 0; k < 3; k++) {
        out->low[k] = low[k];
        out->size[k] = (int32_t)ceilf(dmi_max(high[k] - low[k], 0) / out->cell) + 1;
        cells *= (size_t)out->size[k];
    }
    out->distance = dmi_arena_push(arena, sizeof *out->distance * cells);
    out->source = dmi_arena_push(arena, sizeof *out->source * cells);
    if (out->distance == NULL || out->source == NULL || sort_samples(arena, count, cells, out) != DM_OK)
        return DM_ERROR_OUT_OF_MEMORY;
    transform(out);
    return DM_OK;
}

void dmi_field_distances(const dmi_field* field, const float (*points)[DMI_FIELD_BATCH], uint32_t count, float* out) {
    float outside[DMI_FIELD_BATCH];
    int32_t index[DMI_FIELD_BATCH];
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
static uint32_t nearest_within(const dmi_field* field, const float point[3], float reach, float* out_distance) {
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

/* The cell a point is in, or the nearest one to it. */
static size_t clamped_cell(const dmi_field* field, const float point[3]) {
    size_t index = 0;
    for (int k = 2; k >= 0; k--) {
        float at = (point[k] - field->low[k]) * field->per_cell, last = (float)(field->size[k] - 1);
        index = index * (size_t)field->size[k] + (size_t)dmi_min(dmi_max(at, 0), last);
    }
    return index;
}

uint32_t dmi_field_nearest(const dmi_field* field, const float point[3], float* out_distance) {
    *out_distance = INFINITY;
    if (field->count == 0) return UINT32_MAX;
    /* The nearest occupied cell is `rough` away from this cell's centre: a sample lies within its diagonal of that. */
    float rough = dmi_field_distance(field, point);
    if (rough <= 1.5f * field->cell) return nearest_within(field, point, rough + 1.733f * field->cell, out_distance);
    uint32_t cell = field->source[clamped_cell(field, point)], best = UINT32_MAX;
    for (uint32_t i = field->start[cell]; i < field->start[cell + 1]; i++) {
        float d = dmi_distance3(point, field->samples[field->order[i]]);
        if (d < *out_distance) *out_distance = d, best = field->order[i];
    }
    return best;
}
