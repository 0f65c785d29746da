/* What an asset says of a part beside its shape: names, the pivot of its node, which way is up. Evidence, never truth.
 */
#ifndef DMI_HINTS_ASSET_HINTS_H
#define DMI_HINTS_ASSET_HINTS_H

#include <stdbool.h>

#include "kinematics/hints/modifier_priors.h"

/* The hints of one part, in the object-normalised frame. Zeros: the asset says nothing. */
typedef struct dmi_asset_hints {
    dmi_label_kind label;
    float up[3];     /* unit */
    bool has_pivot;  /* pivot is set */
    bool has_axes;   /* pivot_axes is set */
    bool is_set;     /* the asset's other pivots follow a rule, and this one does not */
    bool is_default; /* the pivot lies where an export without pivots leaves it: at the file's origin */
    float pivot[3];
    float pivot_axes[3][3]; /* unit rows */
} dmi_asset_hints;

/* Returns whether the hints say nothing. hints NULL: true. */
static inline bool dmi_asset_hints_are_empty(const dmi_asset_hints* hints) {
    if (hints == NULL) return true;
    const dmi_label_modifiers say = dmi_modifiers_that_count(hints->label.kind, hints->label.modifiers);
    return hints->label.kind == DMI_KIND_NOTHING && !hints->has_pivot && (say.own | say.above) == 0;
}

#endif
