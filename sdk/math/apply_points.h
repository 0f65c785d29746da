/* The bulk transform with a given instruction set, for tests and benchmarks; hosts get the best of the machine. */
#ifndef DMI_MATH_APPLY_POINTS_H
#define DMI_MATH_APPLY_POINTS_H

#include "base/cpu.h"
#include "math/dual_quat.h"

/* Does what dmi_pose_apply_points does, by the kernels of `isa`, which the machine must have. */
void dmi_pose_apply_points_isa(dmi_isa isa, const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                               size_t dst_stride, size_t count);

#endif
