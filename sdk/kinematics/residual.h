/* What the chosen candidate leaves: where others beside it are likelier together than it is, the joint lies in their
 * midst. */
#ifndef DMI_KINEMATICS_RESIDUAL_H
#define DMI_KINEMATICS_RESIDUAL_H

#include "kinematics/candidates.h"
#include "math/joint.h"

#define DMI_VOICES_MAX 32

/* A candidate that counts beside the chosen one, and for how much (>= 0). */
typedef struct dmi_voice {
    const dmi_candidate* candidate;
    float weight;
} dmi_voice;

/* Whether a candidate can be such a voice: of the same type, with an axis that is no other direction altogether. */
int dmi_residual_counts(const dmi_candidate* chosen, const dmi_candidate* other);
/* Moves the joint that was made from `chosen`, one of the voices: its axis to their mean, unless half of them agree
 * with the chosen one's; its line to their geometric median, which is a candidate's own line where half of them lie on
 * it. count: 1 to DMI_VOICES_MAX. */
void dmi_residual_apply(const dmi_candidate* chosen, const dmi_voice* voices, uint32_t count, dm_joint* joint);

#endif
