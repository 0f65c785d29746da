/* What all nodes and sets of an asset are compared with. */
#ifndef DMI_ASSETS_ASSET_FACTS_H
#define DMI_ASSETS_ASSET_FACTS_H

#include <stdint.h>

#include "assets/node_cells.h"
#include "assets/node_labels.h"

typedef struct dmi_asset_facts {
    uint32_t node_count;
    float largest_share; /* share of all cells that the node with the most cells has */
    uint32_t largest;
    float low[3], high[3], area;
    uint32_t cell_count;
    uint32_t* alike; /* node -> other nodes of the same extents and area */
    const dmi_node_labels* labels;
} dmi_asset_facts;

/* `labels` must outlive `out`; its units are the grid's nodes. */
dm_result dmi_asset_facts_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_node_labels* labels,
                               dmi_asset_facts* out);

/* Returns whether two boxes have the same sorted extents to within 2 %, and the areas too. */
bool dmi_shapes_are_alike(const float low_a[3], const float high_a[3], float area_a, const float low_b[3],
                          const float high_b[3], float area_b);
/* Computes a box's sides, longest first. */
void dmi_sorted_extents(const float low[3], const float high[3], float out[3]);

/* Returns the same as dmi_cell_count, for features. */
static inline float dmi_cells_of(const dmi_node_cells* grid, uint32_t node) {
    return (float)dmi_cell_count(grid, node);
}

typedef struct dmi_row {
    float* out;
    uint32_t count;
} dmi_row;

static inline void dmi_put(dmi_row* row, float value) {
    row->out[row->count++] = value;
}

#endif
