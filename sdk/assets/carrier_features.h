/* The numbers by which one body of an asset is told to carry another. */
#ifndef DMI_ASSETS_CARRIER_FEATURES_H
#define DMI_ASSETS_CARRIER_FEATURES_H

#include "assets/node_cells.h"
#include "assets/node_labels.h"

#define DMI_CARRIER_FEATURES 53

/* A set of units that moves as one, or all that stays. */
typedef struct dmi_carried_body {
    float low[3], high[3], area, moves; /* moves: probability that it moves; 0: it stays */
    uint32_t cells, touching;           /* touching: cells at or beside those of others, once for each of these */
    uint32_t largest;                   /* its largest unit */
    uint32_t neighbours;                /* bodies that touch it */
    uint32_t hops;    /* bodies on the way to what stays, itself included; UINT32_MAX: there is none */
    uint32_t twins;   /* other bodies of the same extents and area */
    float part, grip; /* shares of its cells whose names say so */
} dmi_carried_body;

/* Bodies 0 .. count - 1 may move; `count` is the index of all that stays. */
typedef struct dmi_carrier_facts {
    const dmi_node_cells* grid;
    const dmi_node_labels* labels;
    const uint32_t* body_of_unit; /* UINT32_MAX: it stays */
    uint32_t count;
    dmi_carried_body* bodies; /* count + 1 */
    uint32_t* touched;        /* (count + 1) x (count + 1): the row's cells at or beside the column's */
    uint32_t* above;          /* the same size: the row's cells whose nearest body in the tree it is */
    uint8_t* cut;             /* the same size: 1: without the row, the column reaches nothing that stays */
    uint8_t* alike;           /* the same size: 1: they have the same extents and area */
} dmi_carrier_facts;

/* moves: one a body. All memory comes from the arena; the arguments must outlive `out`. */
dm_result dmi_carrier_facts_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_node_labels* labels,
                                 const uint32_t* body_of_unit, const float* moves, uint32_t count,
                                 dmi_carrier_facts* out);
/* Returns whether a body is worth rating as a carrier of another: what stays, a body that is near, and one that the
 * tree names. */
bool dmi_carrier_is_candidate(const dmi_carrier_facts* facts, uint32_t body, uint32_t carrier);
void dmi_carrier_features_make(const dmi_carrier_facts* facts, uint32_t body, uint32_t carrier,
                               float out[DMI_CARRIER_FEATURES]);

#endif
