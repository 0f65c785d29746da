/* Builds the grid of samples and answers distance queries. */
#include "kinematics/analysis/distance_grid.h"

#include "math/linear3.h"

#define MIN_SIDE 1e-6f       /* object sizes, of the grid's longest side: avoids cells without size */
#define EXACT_RADIUS 1.5f    /* cells, up to which the nearest sample is searched exactly; by hand */
#define CELL_DIAGONAL 1.733f /* cells, sqrt 3 rounded up */

static int32_t cell_of(const dmi_distance_grid* grid, const float point[3]) {
    int32_t index = 0;
    for (int k = 2; k >= 0; k--) {
        int32_t at = (int32_t)floorf((point[k] - grid->low[k]) / grid->cell);
        if (at < 0 || at >= grid->size[k]) return -1;
        index = index * grid->size[k] + at;
    }
    return index;
}

/* Sorts the samples by cell (counting sort), and marks the cells that hold one. */
static dm_result sort_samples(dmi_arena* arena, uint32_t count, size_t cells, dmi_distance_grid* grid) {
    const size_t holding_bytes = sizeof *grid->holding * ((cells >> DMI_HOLDING_SHIFT) + 1);
    grid->holding = dmi_arena_push(arena, holding_bytes);
    int32_t* cell = dmi_arena_push(arena, sizeof *cell * (count + 1));
    grid->start = dmi_arena_push(arena, sizeof *grid->start * (cells + 2));
    grid->order = dmi_arena_push(arena, sizeof *grid->order * (count + 1));
    if (cell == NULL || grid->holding == NULL || grid->start == NULL || grid->order == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(grid->start, 0, sizeof *grid->start * (cells + 2));
    memset(grid->holding, 0, holding_bytes);
    for (uint32_t i = 0; i < count; i++) {
        cell[i] = cell_of(grid, grid->samples[i]);
        if (cell[i] < 0) continue;
        grid->start[cell[i] + 2]++, grid->count++;
        grid->holding[cell[i] >> DMI_HOLDING_SHIFT] |= UINT32_C(1) << (cell[i] & DMI_HOLDING_MASK);
    }
    for (size_t c = 2; c < cells + 2; c++) grid->start[c] += grid->start[c - 1];
    for (uint32_t i = 0; i < count; i++)
        if (cell[i] >= 0) grid->order[grid->start[cell[i] + 1]++] = i;
    return DM_OK;
}

dm_result dmi_distance_grid_make(dmi_arena* arena, const float (*samples)[3], uint32_t count, const float low[3],
                                 const float high[3], uint32_t side_cells, dmi_distance_grid* out) {
    *out = (dmi_distance_grid){.samples = samples};
    float longest = MIN_SIDE;
    for (int k = 0; k < 3; k++) longest = dmi_max(longest, high[k] - low[k]);
    out->cell = longest / (float)(side_cells - 1);
    out->per_cell = 1 / out->cell;
    size_t cells = 1;
    for (int k = 0; k < 3; k++) {
        out->low[k] = low[k];
        out->size[k] = (int32_t)ceilf(dmi_max(high[k] - low[k], 0) / out->cell) + 1;
        cells *= (size_t)out->size[k];
    }
    out->square = dmi_arena_push(arena, sizeof *out->square * (cells + DMI_TRANSFORM_LANES));
    out->in_row = dmi_arena_push(arena, sizeof *out->in_row * (cells + DMI_TRANSFORM_LANES));
    out->in_slab = dmi_arena_push(arena, sizeof *out->in_slab * (cells + DMI_TRANSFORM_LANES));
    if (out->square == NULL || out->in_row == NULL || out->in_slab == NULL ||
        sort_samples(arena, count, cells, out) != DM_OK)
        return DM_ERROR_OUT_OF_MEMORY;
    dmi_distance_transform(out);
    return DM_OK;
}

void dmi_distance_grid_distances(const dmi_distance_grid* grid, const float (*points)[DMI_POINT_BATCH], uint32_t count,
                                 float* out) {
    float outside[DMI_POINT_BATCH];
    int32_t index[DMI_POINT_BATCH];
    for (uint32_t i = 0; i < count; i++) index[i] = 0, outside[i] = 0;
    for (int k = 2; k >= 0; k--) {
        float low = grid->low[k], per_cell = grid->per_cell, last = (float)(grid->size[k] - 1);
        int32_t size = grid->size[k];
        for (uint32_t i = 0; i < count; i++) {
            float at = (points[k][i] - low) * per_cell;
            float inside = at < 0 ? 0 : at;
            inside = inside > last ? last : inside;
            float off = (at - inside) * (at - inside);
            outside[i] += off > 1 ? off : 0;
            index[i] = index[i] * size + (int32_t)inside;
        }
    }
    for (uint32_t i = 0; i < count; i++) out[i] = (float)grid->square[index[i]];
    for (uint32_t i = 0; i < count; i++) out[i] = sqrtf(out[i]) * grid->cell + sqrtf(outside[i]) * grid->cell;
}

/* ---- nearest sample ---- */

/* Returns the nearest sample in the cells within `reach` of the point along each axis. */
static uint32_t nearest_within(const dmi_distance_grid* grid, const float point[3], float reach, float* out_distance) {
    int32_t from[3], to[3];
    for (int k = 0; k < 3; k++) {
        float at = (point[k] - grid->low[k]) / grid->cell, r = reach / grid->cell, last = (float)(grid->size[k] - 1);
        from[k] = (int32_t)dmi_min(dmi_max(floorf(at - r), 0), last);
        to[k] = (int32_t)dmi_min(dmi_max(floorf(at + r), 0), last);
    }
    uint32_t best = UINT32_MAX;
    float least = INFINITY;
    for (int32_t z = from[2]; z <= to[2]; z++)
        for (int32_t y = from[1]; y <= to[1]; y++) {
            size_t row = ((size_t)z * (size_t)grid->size[1] + (size_t)y) * (size_t)grid->size[0];
            uint32_t end = grid->start[row + (size_t)to[0] + 1];
            for (uint32_t i = grid->start[row + (size_t)from[0]]; i < end; i++) {
                float d[3];
                dmi_sub3(grid->samples[grid->order[i]], point, d);
                float square = dmi_dot3(d, d);
                if (square < least) least = square, best = grid->order[i];
            }
        }
    *out_distance = sqrtf(least);
    return best;
}

/* Returns the cell of a line that gave the q-th its least square in the transform; of equals the closest, then the
 * lower. */
static int32_t source_along(const int16_t* line, size_t stride, int32_t n, int32_t q) {
    int32_t best = line[(size_t)q * stride], at = q;
    for (int32_t r = 1; r < n && best > r * r; r++)
        for (int32_t from = q - r; from <= q + r; from += 2 * r) {
            if (from < 0 || from >= n || line[(size_t)from * stride] + r * r >= best) continue;
            best = line[(size_t)from * stride] + r * r, at = from;
        }
    return at;
}

/* Returns the occupied cell nearest to the cell at the point (or the grid's nearest cell to it), by following the
 * transform backwards. */
static size_t source_of(const dmi_distance_grid* grid, const float point[3]) {
    const int32_t* size = grid->size;
    int32_t at[3];
    for (int k = 0; k < 3; k++) {
        const float x = (point[k] - grid->low[k]) * grid->per_cell, last = (float)(size[k] - 1);
        at[k] = (int32_t)dmi_min(dmi_max(x, 0), last);
    }
    const size_t nx = (size_t)size[0], slab = nx * (size_t)size[1];
    const size_t x = (size_t)at[0];
    const size_t z = (size_t)source_along(grid->in_slab + (size_t)at[1] * nx + x, slab, size[2], at[2]);
    const size_t y = (size_t)source_along(grid->in_row + z * slab + x, nx, size[1], at[1]);
    const size_t row = z * slab + y * nx;
    int32_t steps = 0;
    while (steps * steps < grid->in_row[row + x]) steps++;
    const size_t below = row + x - (size_t)steps;
    return steps <= at[0] && grid->start[below + 1] > grid->start[below] ? below : row + x + (size_t)steps;
}

uint32_t dmi_distance_grid_nearest(const dmi_distance_grid* grid, const float point[3], float* out_distance) {
    *out_distance = INFINITY;
    if (grid->count == 0) return UINT32_MAX;
    /* The nearest occupied cell is `rough` away from this cell's centre: a sample lies within a cell's diagonal more.
     */
    float rough = dmi_distance_grid_distance(grid, point);
    if (rough <= EXACT_RADIUS * grid->cell)
        return nearest_within(grid, point, rough + CELL_DIAGONAL * grid->cell, out_distance);
    const size_t cell = source_of(grid, point);
    uint32_t best = UINT32_MAX;
    for (uint32_t i = grid->start[cell]; i < grid->start[cell + 1]; i++) {
        float d = dmi_distance3(point, grid->samples[grid->order[i]]);
        if (d < *out_distance) *out_distance = d, best = grid->order[i];
    }
    return best;
}
