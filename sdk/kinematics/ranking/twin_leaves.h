/* Two leaves that touch only each other, such as double doors without a frame. Their contact is the seam, but they are
 * hung at the outer sides. */
#ifndef DMI_RANKING_TWIN_LEAVES_H
#define DMI_RANKING_TWIN_LEAVES_H

#include "kinematics/candidates/candidates.h"

/* Adds turns about the side of the part's box away from its twin, about its two edges and its middle line, and the
 * slide along them, where a drag allows them and no candidate is the same. Adds nothing without a twin (has_twin).
 * count: the number of candidates before. Returns their number with those added. */
uint32_t dmi_twin_add_candidates(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                                 dmi_candidate* candidates, uint32_t count);

/* Multiplies the probabilities by the likelihood of the candidates' places, seen from the seam; they sum to 1 again.
 * Leaves them as they are without a twin. */
void dmi_twin_weigh(const dmi_part_analysis* analysis, const dmi_candidate* candidates, uint32_t count,
                    float* probability);

#endif
