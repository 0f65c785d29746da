/* What a set of nodes runs into when it slides, turns about an edge of its box, or spins. All lengths are in object
 * sizes, collisions in shares of the set's points. Directions are the grid's, of which none is up. */
#ifndef DMI_ASSETS_SET_MOTIONS_H
#define DMI_ASSETS_SET_MOTIONS_H

#include "assets/node_sets.h"

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
