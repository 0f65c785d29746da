/* The order in which bodies are listed. */
#ifndef DMI_ASSETS_BODY_ORDER_H
#define DMI_ASSETS_BODY_ORDER_H

#include "assets/asset_grouping.h"

/* Orders the bodies by their first nodes, those of a probability of min_moves and more before the others. out_number:
 * the place that each of them had before -> its place now. All memory comes from the arena. */
dm_result dmi_asset_bodies_order(dmi_arena* arena, dmi_asset_bodies* bodies, uint32_t node_count, float min_moves,
                                 uint32_t** out_number);

#endif
