/* The one-parameter motion of a joint, in whatever frame its axis and origin are given. */
#ifndef DMI_MATH_JOINT_H
#define DMI_MATH_JOINT_H

#include <stdbool.h>

#include "math/dual_quat.h"

/* Pose of the joint at `value` (rad, or length for prismatic). Fixed and unknown joints give the identity. */
dm_pose dmi_joint_pose(const dm_joint* joint, float value);
/* The value whose joint pose is nearest to `pose` (the twist about the axis; the slide along it): the exact projection
 * of a network's pose onto the joint (design §1). `near` picks the turn (adds multiples of 2 pi) closest to it. */
float dmi_joint_project(const dm_joint* joint, const dm_pose* pose, float near);
/* Where the joint takes one point given at rest: what its pose does, sooner. */
void dmi_joint_move(const dm_joint* joint, float value, const float rest_point[3], float out[3]);
/* d point / d value at `value`, for a point given at rest. */
void dmi_joint_velocity(const dm_joint* joint, float value, const float rest_point[3], float out[3]);
/* The same joint about, or along, the opposite axis; a screw's pitch stays. */
void dmi_joint_reverse(dm_joint* joint);
/* Turns about a line: revolute, continuous, screw. */
bool dmi_joint_turns(int32_t type);
/* Whether lower and upper bound the value: not for continuous joints, nor when lower == upper (no limits stated). */
bool dmi_joint_has_limits(const dm_joint* joint);
/* Into the limits, where the joint has any. */
float dmi_joint_clamp(const dm_joint* joint, float value);
/* Slides the origin along the axis line to the point nearest `centre`. */
void dmi_joint_set_origin_near(dm_joint* joint, const float centre[3]);

#endif
