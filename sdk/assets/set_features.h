/* What all nodes and sets of an asset are compared with, and the numbers by which a set of nodes is told to be a moving
 * body. */
#ifndef DMI_ASSETS_SET_FEATURES_H
#define DMI_ASSETS_SET_FEATURES_H

#include <stdint.h>

#include "assets/node_cells.h"
#include "assets/node_labels.h"
#include "assets/set_motions.h"

/* ---- facts ---- */

typedef struct dmi_asset_facts {
    uint32_t node_count;
    float largest_share; /* share of all cells that the node with the most cells has */
    uint32_t largest;
    float low[3], high[3], area;
    uint32_t cell_count;
    uint32_t* alike; /* node -> other nodes of the same extents and area */
    const dmi_node_labels* labels;
    /* Outer sides (set_standing.c): each node's cells in the outer layer of each side of the object's box, the cells
     * that a side's outline has, and how full of the nodes' cells it is; the fullest side. */
    uint32_t (*layers)[DMI_GRID_SIDES];
    float cells_of_side[DMI_GRID_SIDES], fullness[DMI_GRID_SIDES];
    int ground;
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

/* ---- what a set would open (set_openings.c), in object sizes unless a comment says otherwise ---- */

#define DMI_OPENING_FEATURES 36

/* Where each group of numbers begins. */
enum {
    DMI_OPENING_HANG = 0, /* how line-like its contacts are (0: a line), their length by its longest side; collisions of
                             turns about that line by 0.25 and 0.9 rad, the freer way and the other; distance of its
                             middle from the line by its longest side */
    DMI_OPENING_WAYS = 7, /* its freest way and the next, 8 each: share of points that leave the object and distance
                             of what the others meet, ahead and behind; cover of the outline, distance to the outside;
                             contacts across and along the way, in half extents */
    DMI_OPENING_GRIP = 23,       /* share of its largest node, what stands out of that, how far off the others are */
    DMI_OPENING_DEPENDANTS = 28, /* nodes that touch it alone, and their cells by its own */
    DMI_OPENING_CLEARANCE = 30,  /* mean and least gap, share of the contact that has one */
    DMI_OPENING_PLACE = 33       /* thickness along the way; middle along both ways, in the object's extents */
};

/* Puts DMI_OPENING_FEATURES numbers. ways: of dmi_measure_ways; nodes: those of the set. */
void dmi_put_openings(dmi_row* row, const dmi_node_set* set, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES], const uint32_t* nodes);

/* ---- how a set stands in the object (set_standing.c) ---- */

#define DMI_STANDING_FEATURES 25

/* Where each group of numbers begins. */
enum {
    DMI_STANDING_COVER = 0,  /* the most of an outer side's outline that the set covers, and that the rest does */
    DMI_STANDING_GROUND = 2, /* how full the ground and the side across from it are; the set's shares of both */
    DMI_STANDING_PLACE = 6,  /* where it begins and ends above the ground, by the object's height; its height by its
                                longer and by its shorter other extent */
    DMI_STANDING_WAYS = 10,  /* collisions of its ways: two away from the ground and that way's rank, one towards it,
                                three of the freest along it; exposure towards the ground and away from it */
    DMI_STANDING_SHARES = 19 /* its shares of the six outer layers, largest first */
};

/* Adds the outer sides to facts that have the object's box. */
dm_result dmi_asset_facts_add_layers(dmi_arena* arena, const dmi_node_cells* grid, dmi_asset_facts* facts);
/* Puts DMI_STANDING_FEATURES numbers. ways: of dmi_measure_ways. */
void dmi_put_standing(dmi_row* row, const dmi_node_set* set, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES]);

/* ---- all of them ---- */

#define DMI_SET_FEATURES (80 + DMI_OPENING_FEATURES + DMI_STANDING_FEATURES)

/* What a set's features take from the grouping and not from its shape. */
typedef struct dmi_set_links {
    float weakest;       /* probability at which the least sure of its merges was made; 1: one node */
    float strongest_out; /* highest probability that a node of it and one outside are one body */
    float mean_in, mean_out;
    uint32_t alike; /* other sets of the same extents and area */
    uint32_t twin;  /* the first of those and itself */
} dmi_set_links;

/* Takes scratch from the arena, and rewinds it. */
dm_result dmi_set_features_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_asset_facts* facts,
                                const uint32_t* nodes, uint32_t count, const dmi_set_links* links,
                                float out[DMI_SET_FEATURES]);

#endif
