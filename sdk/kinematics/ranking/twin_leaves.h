/* Two leaves that touch only each other, such as double doors without a frame: their contact is the seam, but they are
 * hung at the outer sides. And parts that the body stands around, which cannot slide into it. */
#ifndef DMI_RANKING_TWIN_LEAVES_H
#define DMI_RANKING_TWIN_LEAVES_H

#include "kinematics/candidates/candidates.h"

/* Adds turns about the side of the part's box away from its twin, about its two edges and its middle line, and the
 * slide along them, where a drag allows them and no candidate is the same. Adds nothing without a twin (has_twin).
 * count: the number of candidates before. Returns their number with those added. */
uint32_t dmi_twin_add_candidates(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                                 dmi_candidate* candidates, uint32_t count);

/* Multiplies the probabilities by the likelihoods of turns, seen from the seam with a twin or with a leaf in the same
 * frame, and of slides, seen from what stands in their way. They sum to 1 again. */
void dmi_leaves_weigh(const dmi_part_analysis* analysis, const dmi_candidate* candidates, uint32_t count,
                      float* probability);

#endif
