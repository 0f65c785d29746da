/* Numbers by which a pair of nodes is told to be one body. */
#ifndef DMI_ASSETS_PAIR_FEATURES_H
#define DMI_ASSETS_PAIR_FEATURES_H

#include "assets/asset_facts.h"

#define DMI_PAIR_FEATURES 50

/* Takes scratch from the arena, and rewinds it. The order of a and b does not count. */
dm_result dmi_pair_features_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_asset_facts* facts, uint32_t a,
                                 uint32_t b, float out[DMI_PAIR_FEATURES]);

#endif
