/* A grid of distances to a set of surface samples: how far a moved point is from the body, in a few nanoseconds. */
#ifndef DMI_ANALYSIS_DISTANCE_GRID_H
#define DMI_ANALYSIS_DISTANCE_GRID_H

#include "base/arena.h"

#define DMI_DISTANCE_GRID_CELLS 56 /* along the longest side */

typedef struct dmi_distance_grid {
    float low[3], cell, per_cell; /* per_cell = 1 / cell */
    int32_t size[3];
    float* distance;  /* from a cell's centre to the nearest cell that holds a sample; inner units */
    int16_t* in_row;  /* squared distances in cells to the nearest such cell of the same row (x), */
    int16_t* in_slab; /* and of the same slab (z) */
    uint32_t* start;  /* cell c holds order[start[c]] .. order[start[c + 1] - 1] */
    uint32_t* order;  /* sample indices by cell */
    uint32_t count;   /* samples inside the grid */
    const float (*samples)[3];
} dmi_distance_grid;

/* `samples` must outlive the field. NULL memory: DM_ERROR_OUT_OF_MEMORY. */
dm_result dmi_distance_grid_make(dmi_arena* arena, const float (*samples)[3], uint32_t count, const float low[3],
                                 const float high[3], dmi_distance_grid* out);

/* Distance, to within a cell; outside the grid the way back to it is added. */
static inline float dmi_distance_grid_distance(const dmi_distance_grid* field, const float point[3]) {
    int32_t index = 0;
    float outside = 0;
    for (int k = 2; k >= 0; k--) {
        float at = (point[k] - field->low[k]) * field->per_cell, last = (float)(field->size[k] - 1);
        float inside = at < 0 ? 0 : at > last ? last : at;
        float off = at - inside;
        outside += off * off > 1 ? off * off : 0;
        index = index * field->size[k] + (int32_t)inside;
    }
    float distance = field->distance[index];
    return outside > 0 ? distance + __builtin_sqrtf(outside) * field->cell : distance;
}

/* The same for `count` points at once, coordinates apart; count at most DMI_POINT_BATCH. */
#define DMI_POINT_BATCH 192
void dmi_distance_grid_distances(const dmi_distance_grid* field, const float (*points)[DMI_POINT_BATCH], uint32_t count,
                                 float* out);

/* Nearest sample: exact when nearer than a cell and a half, else to within two cells. UINT32_MAX when there is none. */
uint32_t dmi_distance_grid_nearest(const dmi_distance_grid* field, const float point[3], float* out_distance);

#endif
