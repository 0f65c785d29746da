/* Joins what the asset says with the ranker's probabilities. */
#ifndef DMI_HINTS_HINT_LIKELIHOOD_H
#define DMI_HINTS_HINT_LIKELIHOOD_H

#include "kinematics/hints/hint_features.h"

/* Returns whether the hints say nothing. hints NULL: true. */
bool dmi_asset_hints_are_empty(const dmi_asset_hints* hints);

/* Returns the modifiers that mean something for a part of a kind: a roller door is no roller, and a left wheel turns as
 * the right one does. */
dmi_label_modifiers dmi_modifiers_that_count(dmi_part_kind kind, dmi_label_modifiers modifiers);

/* Adds candidates whose axes run through the pivot, along its axes and those of the part's box. Returns the number of
 * candidates. They are added after the prefilter and do not pass it. */
uint32_t dmi_hints_add_candidates(const dmi_asset_hints* hints, const dmi_part_analysis* analysis,
                                  const dmi_drag_hint* drag, dmi_candidate* candidates, uint32_t count);

/* Multiplies the probabilities of a part's candidates by the likelihood of the hints for each, and scales them to the
 * sum 1. The hints must say something. drag: NULL when there is none. A name tells whether its kind turns or slides
 * only then. With a drag it would overrule the drag, as for a disc that turns and is called a button (measured). */
void dmi_hints_weigh(const dmi_asset_hints* hints, const dmi_part_analysis* analysis, const dmi_drag_hint* drag,
                     const dmi_candidate* candidates, uint32_t count, float* probability);

#endif
