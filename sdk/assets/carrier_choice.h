/* Which body of an asset carries which, as the trees rate it. */
#ifndef DMI_ASSETS_CARRIER_CHOICE_H
#define DMI_ASSETS_CARRIER_CHOICE_H

#include "assets/asset_grouping.h"
#include "assets/carrier_features.h"

/* Sets the carriers of all bodies: the likeliest first, and none in a circle. body_of_unit: UINT32_MAX: it stays. */
dm_result dmi_asset_choose_carriers(dmi_arena* arena, const dmi_asset_models* models, const dmi_node_cells* grid,
                                    const dmi_node_labels* labels, const uint32_t* body_of_unit,
                                    dmi_asset_bodies* inout_bodies);

#endif
