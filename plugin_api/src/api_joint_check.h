/* Joints that cross the boundary: read from any version of dm_joint, checked, written back, carried into a scaled
 * frame.
 */
#ifndef DMI_API_JOINT_CHECK_H
#define DMI_API_JOINT_CHECK_H

#include "base/env.h"

/* A limit of a turn at least this far from rest counts as none, rad: 159 turns; by hand. Hosts write "no limit" as
 * FLT_MAX, 1e10, infinity and the like. */
#define DMI_UNLIMITED_TURN 1000.0f

/* Copies a host's joint of any version. struct_size of the copy is 0, as of all joints inside. */
dm_result dmi_joint_read(dmi_env* env, const char* what, const dm_joint* joint, dm_joint* out);
/* Checks that a joint's numbers are finite and at most DMI_LARGEST, and that its type is `first_type` to
 * DM_JOINT_FIXED. Errors name the field. It does not read the limits. */
dm_result dmi_joint_check(dmi_env* env, const char* what, const dm_joint* joint, int32_t first_type);
/* Makes the axis, of any length, a unit vector, and keeps its bits when it is one. Errors: INVALID_ARGUMENT for an axis
 * of no length, unless the joint is fixed or of no type. */
dm_result dmi_joint_accept_axis(dmi_env* env, const char* what, dm_joint* joint);
/* Checks numbers and type of a host's joint, makes its axis unit and keeps the limits that its type has. Limits that
 * mean "none" become none. Errors name the field. size: the object's, host units. Confidences and source stay. */
dm_result dmi_joint_accept(dmi_env* env, const char* what, float size, dm_joint* joint);
/* Checks the struct_size of a joint to be written. */
dm_result dmi_joint_check_out(dmi_env* env, const char* what, const dm_joint* out);

/* Returns the limit of an accepted joint that stands for none: +1 upper, -1 lower, 0 neither. */
int32_t dmi_joint_open_side(const dm_joint* joint, float size);
/* Returns the unit of the joint's value to which shares refer where there is no range: `size`, or 1 rad. */
float dmi_joint_value_unit(const dm_joint* joint, float size);

/* Checks an instance's scale. Zeros become ones. */
dm_result dmi_scale_read(dmi_env* env, const char* what, dm_vec3 scale, dm_vec3* out);
/* Carries a joint into the scaled frame. Returns by how much lengths along its axis grow. */
float dmi_joint_scale(dm_joint* joint, dm_vec3 scale);

#endif
