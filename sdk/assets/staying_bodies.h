/* Bodies that might move, but probably do not. */
#ifndef DMI_ASSETS_STAYING_BODIES_H
#define DMI_ASSETS_STAYING_BODIES_H

#include "assets/asset_grouping.h"
#include "assets/merge_tree.h"

/* Adds the best sets of units that are of no body to the bodies, behind those that move. moves: probability of each set
 * of the tree. body_of_unit: DMI_ASSET_BODY: of no body yet. */
dm_result dmi_list_staying_bodies(dmi_arena* arena, const dmi_merge_tree* tree, const float* moves,
                                  dmi_asset_bodies* bodies, uint32_t* inout_body_of_unit);

#endif
