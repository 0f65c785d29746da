/* Reads a straight pull, along a chord of a turn or along an axis of the room, as the first movement of that turn. */
#ifndef DMI_INFERENCE_STRAIGHT_PULL_H
#define DMI_INFERENCE_STRAIGHT_PULL_H

#include "kinematics/candidates/candidates.h"
#include "kinematics/features/feature_table.h"

/* Returns whether the drag is a straight pull of a candidate: whether the candidate explains it, as `features` say,
 * though the dragged point starts to move another way, and the hand holds the part far from the axis. Then `out_hint`
 * is a drag along that way, as long as the pull. */
bool dmi_straight_pull_read(const dmi_candidate* candidate, const float features[DMI_FEATURE_COUNT],
                            const dmi_drag_hint* hint, dmi_drag_hint* out_hint);

#endif
