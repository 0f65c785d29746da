/* The joint value at which a point of the part is seen nearest to the pointer, or is nearest to a hand in space. */
#ifndef DMI_DRAG_FOLLOW_H
#define DMI_DRAG_FOLLOW_H

#include <stdbool.h>

#include "math/joint.h"

/* What "nearest" means: the angle between point and ray seen from the ray's origin (perspective), or the distance of
 * the point from the ray's line (parallel rays of an orthographic camera). */
typedef enum dmi_projection { DMI_PARALLEL = 0, DMI_PERSPECTIVE = 1 } dmi_projection;

/* Returns the joint value in [lower, upper] (infinite where the joint is free) at which the point, given at rest, is
 * nearest to the ray. For slides this is the global minimum. For turns it is the local one reached from `start`, so
 * that a point which follows a pointer stays on its side of the circle. Returns `start` where the ray carries no
 * information: along a slide's own line, away from the object, not finite. ray->direction must be unit. */
float dmi_follow_ray(const dm_joint* joint, const float rest_point[3], const dm_ray* ray, dmi_projection projection,
                     float start, float lower, float upper);
/* Returns the same value to about 1e-4 rad and without passing folds, which is enough for the residual of a
 * hypothesis. */
float dmi_follow_ray_coarse(const dm_joint* joint, const float rest_point[3], const dm_ray* ray,
                            dmi_projection projection, float start, float lower, float upper);

/* Computes the unit direction of sight to a point, and its distance from the eye, which is infinite for parallel
 * rays. */
void dmi_line_of_sight(const float point[3], const dm_ray* ray, dmi_projection projection, float out_sight[3],
                       float* out_eye_distance);
/* Returns whether a joint moves a point, given at rest, so nearly along a unit line of sight that the screen does not
 * show its value. */
bool dmi_is_seen_end_on(const dm_joint* joint, const float rest_point[3], const float sight[3]);

/* Returns the joint value in [lower, upper] at which the point, given at rest, is nearest to `hand`. For turns this is
 * the place nearest to `start`, so that turns add up. Returns `start` where the hand lies on the axis of a turn,
 * because it says nothing there. */
float dmi_follow_point(const dm_joint* joint, const float rest_point[3], const float hand[3], float start, float lower,
                       float upper);

#endif
