/* The joint value at which a point of the part is nearest to a hand in space. */
#ifndef DMI_MOTION_FOLLOW_POINT_H
#define DMI_MOTION_FOLLOW_POINT_H

#include "math/joint.h"

/* Returns the joint value in [lower, upper] at which the point, given at rest, is nearest to `hand`. For turns this is
 * the place nearest to `start`, so that turns add up. Returns `start` where the hand lies on the axis of a turn,
 * because it says nothing there. */
float dmi_follow_point(const dm_joint* joint, const float rest_point[3], const float hand[3], float start, float lower,
                       float upper);

#endif
