/* Which units go with which body, and which body carries which. */
#ifndef DMI_ASSETS_BODY_CARRIERS_H
#define DMI_ASSETS_BODY_CARRIERS_H

#include "assets/asset_grouping.h"
#include "assets/node_cells.h"

/* Nodes with faces, or nodes that are one body for certain. */
typedef struct dmi_asset_units {
    uint32_t* of_node; /* UINT32_MAX: it has no faces */
    uint32_t* of_part; /* index in mesh->parts -> unit; UINT32_MAX: none */
    uint32_t* node;    /* unit -> the first of its nodes */
    uint32_t count;
} dmi_asset_units;

/* Gives units of no body that touch a body, directly or through each other, and nothing else that stays, to the body
 * that they touch most: a handle goes with its door, a book with its drawer. body_of_unit: UINT32_MAX: it stays. */
dm_result dmi_asset_attach_loose_units(dmi_arena* arena, const dmi_node_cells* grid, uint32_t body_count,
                                       uint32_t* inout_body_of_unit);

/* Sets the carriers of all bodies. The units are the grid's nodes. */
dm_result dmi_asset_find_carriers(const dmi_asset_query* query, const dmi_asset_units* units,
                                  const dmi_node_cells* grid, const uint32_t* body_of_unit,
                                  dmi_asset_bodies* inout_bodies);

#endif
