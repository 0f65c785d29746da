/* DQApply on many points: the pose as a 3x4 matrix, one kernel an instruction set behind one choice. */
#include "math/dual_quat.h"

void dmi_pose_apply_points(const dm_pose* pose, const float* src, size_t src_stride, float* dst, size_t dst_stride,
                           size_t count) {
    float m[16];
    dmi_pose_to_matrix(pose, m);
    if (src_stride == 0) src_stride = 3 * sizeof(float);
    if (dst_stride == 0) dst_stride = 3 * sizeof(float);
    const char* from = (const char*)src;
    char* to = (char*)dst;
    for (size_t i = 0; i < count; i++, from += src_stride, to += dst_stride) {
        const float* p = (const float*)(const void*)from;
        float* q = (float*)(void*)to;
        const float x = p[0], y = p[1], z = p[2];
        q[0] = m[0] * x + m[4] * y + m[8] * z + m[12];
        q[1] = m[1] * x + m[5] * y + m[9] * z + m[13];
        q[2] = m[2] * x + m[6] * y + m[10] * z + m[14];
    }
}
