/* A set of nodes as one rigid body: its extent, and what it runs into when it slides, turns about an edge of its box,
 * or spins. All lengths are in object sizes, collisions in shares of the set's points. Directions are the grid's, of
 * which none is up. */
#ifndef DMI_ASSETS_SET_MOTIONS_H
#define DMI_ASSETS_SET_MOTIONS_H

#include "assets/node_cells.h"

/* ---- sets of nodes as one rigid body each ---- */

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

/* ---- motions ---- */

#define DMI_FREE 0.05f /* share of collisions below which a motion is free; by hand */

typedef struct dmi_set_way {
    float near, middle, far; /* collisions after 2, 8 and 24 cells */
    float exposed, back;     /* share of it that is seen from that side; collisions after 2 cells the other way */
    int side;
} dmi_set_way;

typedef struct dmi_set_turn {
    float little, much; /* collisions after 0.25 and 0.9 rad in the freer sense */
    float back;         /* collisions after 0.25 rad in the other sense */
    float apart;        /* mean distance of what touches the rest from the line, in diagonals of the set's box */
    float along;        /* the set's extent along the line */
} dmi_set_turn;

typedef struct dmi_set_spin {
    float round;          /* share of the set that turns into itself */
    dmi_set_turn turning; /* a turn about the box's middle */
} dmi_set_spin;

/* Measures the six ways, freest first. against: as of dmi_node_set_make. */
void dmi_measure_ways(const dmi_node_set* set, uint32_t against, const float exposed[DMI_GRID_SIDES],
                      dmi_set_way out[DMI_GRID_SIDES]);
/* Measures the turns about the edges of the set's box: the freest, and the freest about another axis. out_free: how
 * many edges it turns about freely. */
void dmi_measure_edges(const dmi_node_set* set, dmi_set_turn out[2], uint32_t* out_free);
/* Measures the turn about the axis through the box's middle about which the set is roundest. */
dmi_set_spin dmi_measure_spin(const dmi_node_set* set);

#endif
