/* What a set of nodes would open: what it hangs on, what it covers, how much room is behind it, and what stands out of
 * its largest node as a grip does. All lengths are in object sizes unless a comment says otherwise. */
#ifndef DMI_ASSETS_SET_OPENINGS_H
#define DMI_ASSETS_SET_OPENINGS_H

#include "assets/asset_facts.h"
#include "assets/feature_row.h"
#include "assets/set_motions.h"

#define DMI_OPENING_FEATURES 36

/* Puts DMI_OPENING_FEATURES numbers. ways: of dmi_measure_ways; nodes: those of the set. */
void dmi_put_openings(dmi_row* row, const dmi_node_set* set, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES], const uint32_t* nodes);

#endif
