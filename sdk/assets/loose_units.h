/* Things that stay with a body because nothing else holds them. */
#ifndef DMI_ASSETS_LOOSE_UNITS_H
#define DMI_ASSETS_LOOSE_UNITS_H

#include "assets/node_cells.h"

/* Gives units of no body that touch a body, directly or through each other, and nothing else that stays, to the body
 * that they touch most: a handle goes with its door, a book with its drawer. body_of_unit: UINT32_MAX: it stays. */
dm_result dmi_attach_loose_units(dmi_arena* arena, const dmi_node_cells* grid, uint32_t body_count,
                                 uint32_t* inout_body_of_unit);

#endif
