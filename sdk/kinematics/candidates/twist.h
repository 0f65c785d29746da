/* The twist of a joint as a part feels it: which way some of its points go. Tells by how much two joints differ. */
#ifndef DMI_CANDIDATES_TWIST_H
#define DMI_CANDIDATES_TWIST_H

#include "kinematics/candidates/candidates.h"
#include "math/joint.h"

#define DMI_TWIST_POINTS 12

/* Velocities of points of the part, together of unit length. */
typedef struct dmi_twist {
    float velocity[DMI_TWIST_POINTS][3];
    int slides;
} dmi_twist;

void dmi_twist_of_candidate(const dmi_part_analysis* study, const dmi_candidate* candidate, dmi_twist* out);
void dmi_twist_of_joint(const dmi_part_analysis* study, const dm_joint* joint, dmi_twist* out);

/* By how much two twists move the part differently, up to speed and sign: the sine of the angle between them, taken
 * over the part; 1 between a slide and a turn. */
float dmi_twist_difference(const dmi_twist* a, const dmi_twist* b);

#endif
