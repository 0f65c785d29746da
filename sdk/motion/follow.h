/* Where on its way along a joint a point looks nearest to the pointer. */
#ifndef DMI_MOTION_FOLLOW_H
#define DMI_MOTION_FOLLOW_H

#include "math/joint.h"

/* How far apart a point and the pointer look: the angle between them seen from the ray's origin, or, when the camera is
 * orthographic (rays side by side), the point's distance from the ray's line. */
typedef enum dmi_projection { DMI_PARALLEL = 0, DMI_PERSPECTIVE = 1 } dmi_projection;

/* The joint value in [lower, upper] (infinite where the joint is free) at which the point, given at rest, looks nearest
 * to the ray: for slides the nearest of all, for turns the one that is reached downhill from `start`, so that a point
 * which follows a pointer stays on its side of the circle. Answers `start` where the ray tells nothing: along a slide's
 * own line, away from everything, not finite. ray->direction must be unit. */
float dmi_follow_ray(const dm_joint* joint, const float rest_point[3], const dm_ray* ray, dmi_projection projection,
                     float start, float lower, float upper);
/* The same to about a ten-thousandth of a radian, and not past folds: enough to tell whether a joint explains a pull.
 */
float dmi_follow_ray_roughly(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                             dmi_projection projection, float start, float lower, float upper);

#endif
