/* Extreme points: those points of a set that are farthest in some direction. */
#ifndef DMI_ANALYSIS_EXTREME_POINTS_H
#define DMI_ANALYSIS_EXTREME_POINTS_H

#include "kinematics/analysis/bounding_box.h"

/* Computes the points that are farthest along, or against, fixed directions over the half sphere and the unit `extra`
 * ones: an approximate convex hull. Returns their number, at most DMI_MAX_HULL_POINTS. */
uint32_t dmi_extreme_points(const float (*points)[3], uint32_t count, const float (*extra)[3], uint32_t extra_count,
                            float (*out)[3]);

#endif
