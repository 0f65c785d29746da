/* Collision-free range of a joint: how far a part goes to either side before it penetrates its body. */
#ifndef DMI_LIMITS_FREE_RANGE_H
#define DMI_LIMITS_FREE_RANGE_H

#include "kinematics/analysis/part_analysis.h"
#include "math/joint.h"

/* Sweeps half a turn, or a bit more than the part's extent along a slide, to either side. A side on which nothing is
 * penetrated so far has no bound. joint: object-normalised frame; its limits are not used. */
dmi_free_range dmi_free_range_of(const dmi_part_analysis* analysis, const dm_joint* joint);

#endif
