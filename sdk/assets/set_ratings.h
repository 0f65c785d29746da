/* How likely each set of a merge tree is a body that moves, and what the other sets of the asset say of it: most assets
 * have something that moves, and few have many unlike parts. */
#ifndef DMI_ASSETS_SET_RATINGS_H
#define DMI_ASSETS_SET_RATINGS_H

#include "assets/merge_tree.h"

/* ---- context ---- */

#define DMI_CONTEXT_FEATURES 17

/* Computes the numbers of all sets. links: of the tree's sets; moves: probability of each by its own features. All
 * memory comes from the arena. */
dm_result dmi_set_context_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_set_links* links,
                               const float* moves, float (*out)[DMI_CONTEXT_FEATURES]);

/* ---- ratings ---- */

#define DMI_RATED_FEATURES (DMI_SET_FEATURES + DMI_CONTEXT_FEATURES)

typedef struct dmi_set_ratings {
    float (*features)[DMI_RATED_FEATURES]; /* each set's own features, then those of its context in the last round */
    float* moves;                          /* probability of each set after the last round */
} dmi_set_ratings;

/* rounds: how many times the sets are rated in view of each other, up to DMI_CONTEXT_ROUNDS. All memory comes from the
 * arena. */
dm_result dmi_set_ratings_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_asset_models* models, int rounds,
                               const dmi_progress* progress, dmi_set_ratings* out);

#endif
