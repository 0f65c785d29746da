/* How likely each set of a merge tree is a body that moves. */
#ifndef DMI_ASSETS_SET_RATINGS_H
#define DMI_ASSETS_SET_RATINGS_H

#include "assets/set_context.h"

#define DMI_RATED_FEATURES (DMI_SET_FEATURES + DMI_CONTEXT_FEATURES)

typedef struct dmi_set_ratings {
    float (*features)[DMI_RATED_FEATURES]; /* of each set; its own, then those of its context */
    float* alone;                          /* probability by the set's own features */
    float* moves;                          /* and in view of the others */
} dmi_set_ratings;

/* All memory comes from the arena. */
dm_result dmi_set_ratings_make(dmi_arena* arena, const dmi_merge_tree* tree, const dmi_asset_models* models,
                               const dmi_progress* progress, dmi_set_ratings* out);

#endif
