/* Reads a straight pull, along a chord of a turn or along an axis of the room, as the first movement of that turn. */
#ifndef DMI_INFERENCE_STRAIGHT_PULL_H
#define DMI_INFERENCE_STRAIGHT_PULL_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* Returns whether the drag is a straight pull of a candidate. It is one when the candidate explains it, as `features`
 * say, although the dragged point starts to move another way, and when the hand holds the part far from the axis.
 * out_hint becomes a drag along that other way, as long as the pull. */
bool dmi_straight_pull_read(const dmi_candidate* candidate, const float features[DMI_FEATURE_COUNT],
                            const dmi_drag_hint* hint, dmi_drag_hint* out_hint);

#endif
