/* A set of nodes as one rigid body: its extent, and what it runs into when it moves. */
#ifndef DMI_ASSETS_NODE_SETS_H
#define DMI_ASSETS_NODE_SETS_H

#include "assets/node_cells.h"

#define DMI_SET_POINTS 256 /* most points of a set's cells; by hand */

typedef struct dmi_node_set {
    const dmi_node_cells* grid;
    uint8_t* member; /* node -> 1 when it is in the set */
    uint32_t node_count, cell_count;
    float (*points)[3]; /* centres of cells that are spread evenly over the set */
    uint8_t* touches;   /* point -> 2: a node outside is at its cell; 1: at a cell beside it; 0: none is near */
    uint32_t point_count;
    float low[3], high[3], area;
} dmi_node_set;

/* `nodes` has no node twice. against: the only node that counts as outside; UINT32_MAX: all that are no members. */
dm_result dmi_node_set_make(dmi_arena* arena, const dmi_node_cells* grid, const uint32_t* nodes, uint32_t count,
                            uint32_t against, dmi_node_set* out);

/* How a set goes: turned by `angle` about the line through `at` along a coordinate axis, then shifted. */
typedef struct dmi_set_motion {
    int axis;
    float angle, at[3], shift[3];
} dmi_set_motion;

/* Returns whether a point is in a cell of a node outside, that is of any node that is no member. */
bool dmi_node_set_meets(const dmi_node_set* set, const float point[3]);
/* Returns the share of the set's points that the motion takes into cells of nodes outside. Points that touch such a
 * cell at rest do not count. */
float dmi_node_set_collide(const dmi_node_set* set, uint32_t against, const dmi_set_motion* motion);
/* Returns the share of the set's points that the motion takes to cells at or beside cells of the set itself. */
float dmi_node_set_coincide(const dmi_node_set* set, const dmi_set_motion* motion);

#endif
