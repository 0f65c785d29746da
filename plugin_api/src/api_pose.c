/* Poses as plain values: no context, no state, any thread. */
#include "math/dual_quat.h"

#include "base/fp_environment.h"

void DM_CALL dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose) {
    DMI_OWN_FP;
    if (a != NULL && b != NULL && out_pose != NULL) *out_pose = dmi_pose_multiply(a, b);
}

void DM_CALL dm_pose_to_matrix(const dm_pose* pose, float out_matrix[16]) {
    DMI_OWN_FP;
    if (pose != NULL && out_matrix != NULL) dmi_pose_to_matrix(pose, out_matrix);
}

void DM_CALL dm_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                                  size_t dst_stride, size_t count) {
    DMI_OWN_FP;
    if (pose == NULL || src == NULL || dst == NULL) return;
    const size_t packed = 3 * sizeof(float);
    dmi_pose_apply_points(pose, src, src_stride ? src_stride : packed, dst, dst_stride ? dst_stride : packed, count);
}
