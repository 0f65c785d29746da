/* The surfaces of an asset's nodes as cells of one grid, and what the cells tell: contacts and exposure. The order of
 * faces and corners does not count. */
#ifndef DMI_ASSETS_NODE_CELLS_H
#define DMI_ASSETS_NODE_CELLS_H

#include <stdbool.h>

#include "base/arena.h"
#include "base/progress.h"
#include "mesh/mesh.h"

#define DMI_GRID_CELLS 128 /* cells along the object's longest side; by hand: 8 mm of a metre */
#define DMI_GRID_SIDES 6   /* -x, +x, -y, +y, -z, +z */

typedef struct dmi_node_cells {
    const dmi_mesh* mesh;
    const uint32_t* node_of_part; /* index in mesh->parts -> node, which may have several; UINT32_MAX: none */
    uint32_t node_count;
    int32_t size[3]; /* cells along each axis, with an empty layer around; x varies fastest */
    float low[3];    /* corner of the grid, object-normalised */
    float cell;      /* side of a cell, object-normalised */
    uint32_t* first; /* node i has cells[first[i]] .. cells[first[i + 1] - 1], rising */
    uint32_t* cells;
    uint32_t* start; /* cell c is of the nodes owners[start[c]] .. owners[start[c + 1] - 1], rising */
    uint16_t* owners;
    uint32_t* contacts; /* node_count x node_count: cells of the row's node that the column's node is at or beside */
    float (*exposed)[DMI_GRID_SIDES];  /* share of the node's columns in which nothing hides it from that side */
    float (*low_of)[3], (*high_of)[3]; /* box of the node's vertices */
    float* area;
} dmi_node_cells;

/* All memory comes from the arena. `node_of_part` must outlive `out`. */
dm_result dmi_node_cells_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* node_of_part, uint32_t node_count,
                              const dmi_progress* progress, dmi_node_cells* out);

/* Returns how many cells a node has. */
static inline uint32_t dmi_cell_count(const dmi_node_cells* g, uint32_t node) {
    return g->first[node + 1] - g->first[node];
}

/* Returns the index of the cell that holds the point; the point is clamped to the grid. */
static inline uint32_t dmi_cell_at(const dmi_node_cells* g, const float point[3]) {
    int32_t index = 0;
    for (int k = 2; k >= 0; k--) {
        const float at = (point[k] - g->low[k]) / g->cell, last = (float)(g->size[k] - 1);
        index = index * g->size[k] + (int32_t)(at < 0 ? 0 : at > last ? last : at);
    }
    return (uint32_t)index;
}

/* Computes the cell's centre. */
static inline void dmi_cell_centre(const dmi_node_cells* g, uint32_t cell, float out[3]) {
    for (int k = 0; k < 3; k++) {
        out[k] = g->low[k] + g->cell * ((float)(cell % (uint32_t)g->size[k]) + 0.5f);
        cell /= (uint32_t)g->size[k];
    }
}

#endif
