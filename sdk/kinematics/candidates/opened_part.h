/* Where a candidate joint takes points of the part, and how far apart two candidates take them. */
#ifndef DMI_CANDIDATES_OPENED_PART_H
#define DMI_CANDIDATES_OPENED_PART_H

#include "kinematics/candidates/candidates.h"

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
