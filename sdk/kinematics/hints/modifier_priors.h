/* What modifiers of a name say of candidate joints. */
#ifndef DMI_HINTS_MODIFIER_PRIORS_H
#define DMI_HINTS_MODIFIER_PRIORS_H

#include <stdbool.h>

#include "kinematics/hints/label_words.h"
#include "kinematics/hints/part_kind.h"

/* Returns the modifiers that mean something for a part of a kind: a roller door is no roller, and a left wheel turns as
 * the right one does. */
dmi_label_modifiers dmi_modifiers_that_count(dmi_part_kind kind, dmi_label_modifiers modifiers);
/* Returns what the modifiers add to the log probability of a candidate with these kind features (dmi_kind_feature).
 * modifiers: as dmi_modifiers_that_count returns them. above: factor of the modifiers in the names above. */
float dmi_modifier_likelihood(dmi_label_modifiers modifiers, uint32_t features, float above);

/* Returns what the meaning of a kind's noun adds to the log probability of sliding: a lever turns about its fulcrum. */
float dmi_slide_by_definition(dmi_part_kind kind);

#endif
