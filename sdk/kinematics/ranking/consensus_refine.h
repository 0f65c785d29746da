/* What the chosen candidate leaves: where others beside it are likelier together than it is, the joint lies in their
 * midst. */
#ifndef DMI_RANKING_CONSENSUS_REFINE_H
#define DMI_RANKING_CONSENSUS_REFINE_H

#include "kinematics/candidates/candidates.h"
#include "math/joint.h"

#define DMI_CONSENSUS_MAX 32

/* A candidate that counts beside the chosen one, and for how much (>= 0). */
typedef struct dmi_weighted_candidate {
    const dmi_candidate* candidate;
    float weight;
} dmi_weighted_candidate;

/* Whether a candidate can be such a voice: of the same type, with an axis that is no other direction altogether. */
int dmi_consensus_counts(const dmi_candidate* chosen, const dmi_candidate* other);
/* Moves the joint that was made from `chosen`, one of the voices: its axis to their mean, unless half of them agree
 * with the chosen one's; its line to their geometric median, which is a candidate's own line where half of them lie on
 * it. count: 1 to DMI_CONSENSUS_MAX. */
void dmi_consensus_refine(const dmi_candidate* chosen, const dmi_weighted_candidate* voices, uint32_t count,
                          dm_joint* joint);

#endif
