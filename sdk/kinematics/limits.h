/* How far a joint goes from rest: until the part meets the body, or as far as its kind usually goes. */
#ifndef DMI_KINEMATICS_LIMITS_H
#define DMI_KINEMATICS_LIMITS_H

#include "kinematics/candidates.h"

/* Sets lower and upper of a revolute, prismatic or screw joint (inner frame), and turns a revolute one that nothing
 * stops, and that the part's shape does not contradict, into a continuous one. prediction may be NULL. */
void dmi_limits_set(const dmi_study* study, const dmi_prediction* prediction, dm_joint* joint);

#endif
