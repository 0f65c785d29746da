/* Finds where a part that rests open is closed, by what it meets on its way to the body and what its front comes flush
 * with. */
#ifndef DMI_LIMITS_CLOSED_POSE_H
#define DMI_LIMITS_CLOSED_POSE_H

#include "dragmesh/dragmesh.h"
#include "kinematics/analysis/part_analysis.h"

/* Finds the value at which a sliding part is closed, where that is not rest. Returns false where it rests closed, and
 * where the shape does not tell: it turns, it is small, nothing stops it or both sides do, or its front comes flush
 * with nothing where it is stopped. joint: object-normalised frame; its limits are not used. */
bool dmi_closed_pose_find(const dmi_part_analysis* analysis, const dm_joint* joint, float* out_value);

#endif
