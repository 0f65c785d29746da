/* Unit dual quaternions as rigid poses (paper §3.2; conventions of dm_pose): products, screws, interpolation. */
#ifndef DMI_MATH_DUAL_QUAT_H
#define DMI_MATH_DUAL_QUAT_H

#include <stdbool.h>

#include "base/cpu.h"
#include "dragmesh/dragmesh.h"

/* A rigid motion as a screw: turn by `angle` about the line (axis, point) and advance by `distance` along it. */
typedef struct dmi_screw {
    float axis[3];  /* unit */
    float point[3]; /* the point of the line nearest the frame's origin; 0 for a pure translation */
    float angle;    /* rad, in [0, 2 pi] for the pose as given (not of its shortest double) */
    float distance;
} dmi_screw;

dm_pose dmi_pose_identity(void);
/* rotation: unit quaternion x, y, z, w. */
dm_pose dmi_pose_from_rotation_translation(const float rotation[4], const float translation[3]);
dm_pose dmi_pose_from_screw(const float axis[3], const float point[3], float angle, float distance);
dm_pose dmi_pose_multiply(const dm_pose* a, const dm_pose* b); /* x -> a(b(x)) */
dm_pose dmi_pose_inverse(const dm_pose* pose);
/* Whether the length of the quaternion of the rotation, 1 but for rounding, still counts as unit. out_length: it. */
bool dmi_pose_is_near_unit(const dm_pose* pose, float* out_length);
dm_pose dmi_pose_normalize(const dm_pose* pose); /* real to unit length, dual orthogonal to it; zeros -> identity */
void dmi_pose_translation(const dm_pose* pose, float out[3]);
void dmi_pose_apply(const dm_pose* pose, const float point[3], float out[3]);
void dmi_pose_rotate(const dm_pose* pose, const float vector[3], float out[3]);
void dmi_pose_to_matrix(const dm_pose* pose, float out[16]); /* column-major */
dmi_screw dmi_pose_to_screw(const dm_pose* pose);
/* Screw linear interpolation from a (t = 0) to b (t = 1) along the shorter way. */
dm_pose dmi_pose_sclerp(const dm_pose* a, const dm_pose* b, float t);
/* DQApply on packed or strided float32 points; strides in bytes. */
void dmi_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride,
                           size_t count);
/* Does the same by the kernels of `isa`, which the machine must have: for tests and benchmarks. */
void dmi_pose_apply_points_isa(dmi_isa isa, const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                               size_t dst_stride, size_t count);

#endif
