/* Kinematics of a joint with one degree of freedom, in the frame of its axis and origin. */
#ifndef DMI_MATH_JOINT_H
#define DMI_MATH_JOINT_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "math/dual_quat.h"
#include "math/elementary.h"

/* Joint values, rest among them, between which a part does not penetrate its body. A side without bound is -FLT_MAX or
 * FLT_MAX. */
typedef struct dmi_free_range {
    float lower, upper; /* lower <= 0 <= upper */
} dmi_free_range;

static inline dmi_free_range dmi_unbounded_range(void) {
    return (dmi_free_range){-FLT_MAX, FLT_MAX};
}
/* Returns the range of the joint reversed (dmi_joint_reverse). */
static inline dmi_free_range dmi_reversed_range(dmi_free_range range) {
    return (dmi_free_range){-range.upper, -range.lower};
}

/* Whether joints of this type turn about a line: revolute, continuous, screw. */
static inline bool dmi_joint_turns(int32_t type) {
    return type == DM_JOINT_REVOLUTE || type == DM_JOINT_CONTINUOUS || type == DM_JOINT_SCREW;
}
/* Whether lower and upper bound the value: not for continuous joints, nor when lower == upper (no limits stated). */
static inline bool dmi_joint_has_limits(const dm_joint* joint) {
    return joint->type != DM_JOINT_CONTINUOUS && joint->lower < joint->upper;
}
/* Returns the largest value, to either side, that is computed with: a screw moves its part by DMI_LARGEST at most. */
static inline float dmi_joint_farthest(const dm_joint* joint) {
    return joint->type == DM_JOINT_SCREW ? DMI_LARGEST / dmi_fmaxf(1, fabsf(joint->pitch)) : DMI_LARGEST;
}
/* Clamps to the limits; where the joint has none, to the largest values. */
static inline float dmi_joint_clamp(const dm_joint* joint, float value) {
    if (dmi_joint_has_limits(joint)) return dmi_fminf(dmi_fmaxf(value, joint->lower), joint->upper);
    const float far = dmi_joint_farthest(joint);
    return dmi_fminf(dmi_fmaxf(value, -far), far);
}

/* Returns the pose at `value` (rad, or length for prismatic). Fixed and unknown joints give the identity. */
dm_pose dmi_joint_pose(const dm_joint* joint, float value);
/* Returns the value whose joint pose is nearest to `pose`: the twist about the axis, or the translation along it. Of
 * the turns that differ by 2 pi, the one nearest to `near`. */
float dmi_joint_project(const dm_joint* joint, const dm_pose* pose, float near);
/* Moves one point given at rest, as the pose does but faster. */
void dmi_joint_move(const dm_joint* joint, float value, const float rest_point[3], float out[3]);
/* Computes d point / d value at `value`, for a point given at rest. */
void dmi_joint_velocity(const dm_joint* joint, float value, const float rest_point[3], float out[3]);
/* Reverses the axis and the limits; a screw's pitch stays. */
void dmi_joint_reverse(dm_joint* joint);
/* Returns the limit that is farther from rest, the upper one of two alike. The joint has limits. */
float dmi_joint_open_end(const dm_joint* joint);
/* Returns the value at which the part is closed, inside the limits. */
static inline float dmi_joint_closed(const dm_joint* joint) {
    return dmi_joint_clamp(joint, joint->closed);
}
/* Returns the limit that is farther from where the part is closed, the upper one of two alike. The joint has limits. */
float dmi_joint_opened(const dm_joint* joint);
/* Moves the origin along the axis line to the point nearest `centre`. */
void dmi_joint_set_origin_near(dm_joint* joint, const float centre[3]);

/* A drag that is evidence for a joint, in the object-normalised frame. */
typedef struct dmi_drag_hint {
    float point[3];
    float vector[3]; /* non-zero */
} dmi_drag_hint;

#endif
