/* A grid of distances to a set of surface samples, looked up in a few nanoseconds. All
 * lengths are object-normalised. */
#ifndef DMI_ANALYSIS_DISTANCE_GRID_H
#define DMI_ANALYSIS_DISTANCE_GRID_H

#include <math.h>

#include "base/arena.h"

#define DMI_DISTANCE_GRID_CELLS 88 /* most cells along the longest side; by hand */
#define DMI_POINT_BATCH 192        /* most points of one call of a batched function */

#define DMI_HOLDING_SHIFT 5 /* cell c's bit is in word c >> this … */
#define DMI_HOLDING_MASK 31 /* … at place c & this */

typedef struct dmi_distance_grid {
    float low[3], cell, per_cell; /* cell: side of a cell; per_cell = 1 / cell */
    int32_t size[3];              /* cells along each axis; x varies fastest */
    int16_t* square;   /* squared distance, in cells, between a cell's centre and that of the nearest cell that
                        * holds a sample; that of 128 cells where it is farther, or where no cell does */
    int16_t* in_row;   /* the same to the nearest such cell of the same row (x) ... */
    int16_t* in_slab;  /* ... and of the same slab (x and y) */
    uint32_t* holding; /* a bit a cell: whether it holds a sample */
    uint32_t* start;   /* samples of cell c: order[start[c]] .. order[start[c + 1] - 1] */
    uint32_t* order;   /* sample indices sorted by cell */
    uint32_t count;    /* samples inside the grid */
    const float (*samples)[3];
} dmi_distance_grid;

/* Makes the grid over the box low .. high, with so many cells along its longest side. `samples` must outlive it. */
dm_result dmi_distance_grid_make(dmi_arena* arena, const float (*samples)[3], uint32_t count, const float low[3],
                                 const float high[3], uint32_t side_cells, dmi_distance_grid* out);

/* Returns the cell of the point, or the nearest cell of the grid. Adds the squares of the coordinates of what lies
 * between, in cells, where one exceeds a cell. */
static inline int32_t dmi_distance_grid_cell(const dmi_distance_grid* grid, const float point[3], float* outside) {
    int32_t index = 0;
    *outside = 0;
    for (int k = 2; k >= 0; k--) {
        float at = (point[k] - grid->low[k]) * grid->per_cell, last = (float)(grid->size[k] - 1);
        float inside = at < 0 ? 0 : at > last ? last : at;
        float off = at - inside;
        *outside += off * off > 1 ? off * off : 0;
        index = index * grid->size[k] + (int32_t)inside;
    }
    return index;
}

/* Returns 1 when the point lies in a cell that holds a sample, or within a cell of such a one on the grid's border;
 * otherwise 0. */
static inline int32_t dmi_distance_grid_holds(const dmi_distance_grid* grid, const float point[3]) {
    float outside;
    const uint32_t cell = (uint32_t)dmi_distance_grid_cell(grid, point, &outside);
    const uint32_t word = grid->holding[cell >> DMI_HOLDING_SHIFT];
    return outside > 0 ? 0 : (int32_t)(word >> (cell & DMI_HOLDING_MASK) & 1);
}

/* Returns the distance of the point from the samples, to within a cell. For a point outside the grid, that is the
 * distance at the nearest cell of the grid plus the distance to that cell. */
static inline float dmi_distance_grid_distance(const dmi_distance_grid* grid, const float point[3]) {
    float outside;
    const int32_t index = dmi_distance_grid_cell(grid, point, &outside);
    const float distance = sqrtf((float)grid->square[index]) * grid->cell;
    return outside > 0 ? distance + sqrtf(outside) * grid->cell : distance;
}

/* Computes the same for `count` points, coordinates separated. count <= DMI_POINT_BATCH. */
void dmi_distance_grid_distances(const dmi_distance_grid* grid, const float (*points)[DMI_POINT_BATCH], uint32_t count,
                                 float* out);

/* Returns the nearest sample: exact when it is closer than a cell and a half, else to within two cells. UINT32_MAX: the
 * grid holds no sample. */
uint32_t dmi_distance_grid_nearest(const dmi_distance_grid* grid, const float point[3], float* out_distance);

/* ---- distance_transform.c: a step of making the grid ---- */

#define DMI_TRANSFORM_LANES 16 /* lines at a time; square, in_row and in_slab have so many elements to spare */

/* Computes in_row, in_slab and square from the grid's size, cell and start: the exact Euclidean distance transform of
 * the occupied cells. */
void dmi_distance_transform(dmi_distance_grid* grid);

#endif
