/* Poses as plain values: no context, no state, any thread. */
#include <math.h>

#include "api_check.h"
#include "math/dual_quat.h"
#include "math/linear3.h"

#include "base/fp_environment.h"

void DM_CALL dm_pose_multiply(const dm_pose* a, const dm_pose* b, dm_pose* out_pose) {
    DMI_OWN_FP;
    if (a != NULL && b != NULL && out_pose != NULL) *out_pose = dmi_pose_multiply(a, b);
}

void DM_CALL dm_pose_inverse(const dm_pose* pose, dm_pose* out_pose) {
    if (pose != NULL && out_pose != NULL) *out_pose = dmi_pose_inverse(pose);
}

/* Scales a finite quaternion to unit length. In double precision no square is too large or too small. */
static dm_result to_unit(const float rotation[4], float out[4]) {
    double square = 0;
    for (int i = 0; i < 4; i++) square += (double)rotation[i] * (double)rotation[i];
    if (!(square > 0)) return DM_ERROR_INVALID_ARGUMENT;
    for (int i = 0; i < 4; i++) out[i] = (float)((double)rotation[i] / sqrt(square));
    return DM_OK;
}

dm_result DM_CALL dm_pose_from_rotation(const float rotation[4], dm_vec3 translation, dm_pose* out_pose) {
    float unit_rotation[4];
    if (rotation == NULL || out_pose == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = dmi_check_finite(NULL, "", rotation, 4);
    if (result == DM_OK) result = to_unit(rotation, unit_rotation);
    if (result != DM_OK) return result;
    const dm_pose given = dmi_pose_from_rotation_translation(unit_rotation, dmi_xyz(translation).v);
    dm_pose unit;
    result = dmi_check_pose(NULL, "", &given, &unit);
    if (result == DM_OK) *out_pose = unit;
    return result;
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
