/* Consensus refinement: replaces the chosen candidate's axis by the weighted mean, and its origin by the weighted
 * geometric median, of the candidates near it, where these are together more probable than it is. */
#ifndef DMI_RANKING_CONSENSUS_REFINE_H
#define DMI_RANKING_CONSENSUS_REFINE_H

#include <stdbool.h>

#include "kinematics/candidates/candidates.h"
#include "math/joint.h"

#define DMI_CONSENSUS_MAX 32

/* A candidate that supports the chosen one, and its weight (>= 0). */
typedef struct dmi_weighted_candidate {
    const dmi_candidate* candidate;
    float weight;
} dmi_weighted_candidate;

/* Returns whether a candidate may support the chosen one: it has the same type, and the angle between the axes is at
 * most about 34 degrees. */
bool dmi_consensus_counts(const dmi_candidate* chosen, const dmi_candidate* other);
/* Moves the joint that was made from `chosen`, which is among the support. Its axis becomes the mean, unless half of
 * the weight agrees with the chosen one's. Its line becomes the geometric median, which is a candidate's own line where
 * half of the weight lies on it. count: 1 to DMI_CONSENSUS_MAX. */
void dmi_consensus_refine(const dmi_candidate* chosen, const dmi_weighted_candidate* support, uint32_t count,
                          dm_joint* joint);

#endif
