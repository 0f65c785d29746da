/* What the other sets of an asset say of a set: most assets have something that moves, and few have many unlike parts.
 */
#ifndef DMI_ASSETS_SET_CONTEXT_H
#define DMI_ASSETS_SET_CONTEXT_H

#include "assets/merge_tree.h"

#define DMI_CONTEXT_FEATURES 17

/* Computes the numbers of all sets. links: of the tree's sets; moves: probability of each by its own features. All
 * memory comes from the arena. */
dm_result dmi_set_context_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                               const float* moves, float (*out)[DMI_CONTEXT_FEATURES]);

#endif
