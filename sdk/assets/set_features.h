/* Numbers by which a set of nodes is told to be a moving body. */
#ifndef DMI_ASSETS_SET_FEATURES_H
#define DMI_ASSETS_SET_FEATURES_H

#include "assets/set_openings.h"

#define DMI_SET_FEATURES (80 + DMI_OPENING_FEATURES)

/* What a set's features take from the grouping and not from its shape. */
typedef struct dmi_set_links {
    float weakest;       /* probability at which the least sure of its merges was made; 1: one node */
    float strongest_out; /* highest probability that a node of it and one outside are one body */
    float mean_in, mean_out;
    uint32_t alike; /* other sets of the same extents and area */
    uint32_t twin;  /* the first of those and itself */
} dmi_set_links;

/* Takes scratch from the arena, and rewinds it. */
dm_result dmi_set_features_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_asset_facts* facts,
                                const uint32_t* nodes, uint32_t count, const dmi_set_links* links,
                                float out[DMI_SET_FEATURES]);

#endif
