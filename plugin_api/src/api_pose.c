/* Poses and joints as plain values: no context, no state, any thread. */
#include <math.h>

#include "dragmesh/dragmesh.h"
#include "math/joint.h"

dm_result DM_CALL dm_joint_pose(const dm_joint* joint, float value, dm_pose* out_pose) {
    if (joint == NULL || out_pose == NULL || joint->type < DM_JOINT_UNKNOWN || joint->type > DM_JOINT_FIXED) {
        return DM_ERROR_INVALID_ARGUMENT;
    }
    const dm_vec3 a = joint->axis, o = joint->origin;
    if (!isfinite(a.x + a.y + a.z) || !isfinite(o.x + o.y + o.z) || !isfinite(joint->pitch) || !isfinite(value)) {
        return DM_ERROR_NOT_FINITE;
    }
    *out_pose = dmi_joint_pose(joint, value);
    return DM_OK;
}

void DM_CALL dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose) {
    if (a != NULL && b != NULL && out_pose != NULL) *out_pose = dmi_pose_multiply(a, b);
}

void DM_CALL dm_pose_to_matrix(const dm_pose* pose, float out_matrix[16]) {
    if (pose != NULL && out_matrix != NULL) dmi_pose_to_matrix(pose, out_matrix);
}

void DM_CALL dm_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst,
                                  size_t dst_stride, size_t count) {
    if (pose == NULL || src == NULL || dst == NULL) return;
    const size_t packed = 3 * sizeof(float);
    dmi_pose_apply_points(pose, src, src_stride ? src_stride : packed, dst, dst_stride ? dst_stride : packed, count);
}
