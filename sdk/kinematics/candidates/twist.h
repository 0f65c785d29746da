/* Where candidate joints take points of the part, and how unlike two of them are: the velocities that a joint gives to
 * the points, and the places where the part lies opened. */
#ifndef DMI_CANDIDATES_TWIST_H
#define DMI_CANDIDATES_TWIST_H

#include "kinematics/candidates/candidates.h"
#include "math/joint.h"

#define DMI_TWIST_POINTS 12 /* points whose velocities count; by hand */

/* Velocities of the part's first points, together a vector of unit length. */
typedef struct dmi_twist {
    float velocity[DMI_TWIST_POINTS][3];
    bool is_prismatic;
} dmi_twist;

void dmi_twist_of_candidate(const dmi_part_analysis* analysis, const dmi_candidate* candidate, dmi_twist* out);
void dmi_twist_of_joint(const dmi_part_analysis* analysis, const dm_joint* joint, dmi_twist* out);

/* Returns the sine of the angle between the two velocity vectors, regardless of sign. It is 0 for the same motion, and
 * 1 between a prismatic joint and another type. */
float dmi_twist_difference(const dmi_twist* a, const dmi_twist* b);

/* ---- opened parts ---- */

#define DMI_OPENED_POINTS 16 /* points that are opened; by hand */

/* The part's first points, opened by a typical way in either direction, in the object-normalised frame. */
typedef struct dmi_opened_part {
    float at[2][DMI_OPENED_POINTS][3];
} dmi_opened_part;

void dmi_opened_part_make(const dmi_part_analysis* analysis, const dmi_candidate* candidate, dmi_opened_part* out);

/* Returns the mean distance between the points, in object sizes, for the directions that agree better. It is 0 for the
 * same motion. */
float dmi_opened_part_difference(const dmi_opened_part* a, const dmi_opened_part* b);

#endif
