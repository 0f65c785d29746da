/* Unit dual quaternions: q = r + eps d with d = 1/2 t (*) r, so that t = 2 d (*) conj(r). */
#include "math/dual_quat.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define CGLM_ALL_UNALIGNED /* dm_pose is four-byte aligned */
#include <cglm/cglm.h>

#include "math/constants.h"

#define MIN_HALF_SINE 1e-7f /* sine of half the angle below which a rotation is rounding noise: a translation */

static void quat_mul(const float a[4], const float b[4], float out[4]) {
    glm_quat_mul((float*)a, (float*)b, out); /* cglm reads through plain pointers */
}

static void cross(const float a[3], const float b[3], float out[3]) {
    glm_vec3_cross((float*)a, (float*)b, out);
}

dm_pose dmi_pose_identity(void) {
    return (dm_pose){.real = {0, 0, 0, 1}};
}

dm_pose dmi_pose_from_rotation_translation(const float rotation[4], const float translation[3]) {
    dm_pose pose;
    memcpy(pose.real, rotation, sizeof pose.real);
    const float half[4] = {0.5f * translation[0], 0.5f * translation[1], 0.5f * translation[2], 0};
    quat_mul(half, rotation, pose.dual);
    return pose;
}

/* Closed form: t = p - R p would cancel digits where the axis is far from the origin. */
dm_pose dmi_pose_from_screw(const float axis[3], const float point[3], float angle, float distance) {
    const float s = sinf(0.5f * angle), c = cosf(0.5f * angle), h = 0.5f * distance;
    float moment[3];
    cross(point, axis, moment);
    dm_pose pose;
    for (int i = 0; i < 3; i++) {
        pose.real[i] = s * axis[i];
        pose.dual[i] = s * moment[i] + h * c * axis[i];
    }
    pose.real[3] = c;
    pose.dual[3] = -h * s;
    return pose;
}

dm_pose dmi_pose_multiply(const dm_pose* a, const dm_pose* b) {
    dm_pose product;
    float left[4], right[4];
    quat_mul(a->real, b->real, product.real);
    quat_mul(a->real, b->dual, left);
    quat_mul(a->dual, b->real, right);
    glm_vec4_add(left, right, product.dual);
    return product;
}

dm_pose dmi_pose_inverse(const dm_pose* pose) {
    const float* r = pose->real;
    const float* d = pose->dual;
    return (dm_pose){{-r[0], -r[1], -r[2], r[3]}, {-d[0], -d[1], -d[2], d[3]}};
}

dm_pose dmi_pose_normalize(const dm_pose* pose) {
    dm_pose out;
    float norm = glm_vec4_norm((float*)pose->real);
    if (!(norm > FLT_MIN && norm <= FLT_MAX)) return dmi_pose_identity();
    for (int i = 0; i < 4; i++) {
        out.real[i] = pose->real[i] / norm;
        out.dual[i] = pose->dual[i] / norm;
    }
    const float along = glm_vec4_dot(out.real, out.dual);
    for (int i = 0; i < 4; i++) out.dual[i] -= along * out.real[i];
    return out;
}

void dmi_pose_translation(const dm_pose* pose, float out[3]) {
    const float* r = pose->real;
    const float* d = pose->dual;
    float turned[3];
    cross(r, d, turned);
    for (int i = 0; i < 3; i++) out[i] = 2 * (r[3] * d[i] - d[3] * r[i] + turned[i]);
}

void dmi_pose_rotate(const dm_pose* pose, const float vector[3], float out[3]) {
    const float* r = pose->real;
    float once[3], twice[3];
    cross(r, vector, once);
    cross(r, once, twice);
    for (int i = 0; i < 3; i++) out[i] = vector[i] + 2 * (r[3] * once[i] + twice[i]);
}

void dmi_pose_apply(const dm_pose* pose, const float point[3], float out[3]) {
    float translation[3];
    dmi_pose_translation(pose, translation);
    dmi_pose_rotate(pose, point, out);
    glm_vec3_add(out, translation, out);
}

void dmi_pose_to_matrix(const dm_pose* pose, float out[16]) {
    mat4 matrix;
    glm_quat_mat4((float*)pose->real, matrix);
    dmi_pose_translation(pose, matrix[3]);
    memcpy(out, matrix, sizeof matrix);
}

static dmi_screw translation_screw(const dm_pose* pose) {
    dmi_screw screw = {.axis = {1, 0, 0}, .angle = pose->real[3] < 0 ? DMI_TWO_PI_F : 0};
    float translation[3];
    dmi_pose_translation(pose, translation);
    screw.distance = glm_vec3_norm(translation);
    if (screw.distance > FLT_MIN) glm_vec3_scale(translation, 1 / screw.distance, screw.axis);
    return screw;
}

dmi_screw dmi_pose_to_screw(const dm_pose* pose) {
    const float* r = pose->real;
    const float* d = pose->dual;
    const float s = glm_vec3_norm((float*)r);
    if (!(s > MIN_HALF_SINE)) return translation_screw(pose);
    dmi_screw screw = {.axis = {r[0] / s, r[1] / s, r[2] / s}, .angle = 2 * atan2f(s, r[3])};
    /* With h half the distance, m = p x a the moment and c, s of half the angle, the dual part is (s m + h c a, -h s).
     * c (d . a) - s d_w = h loses no digits at either end of the angles, as -d_w / s does near 0. */
    const float h = r[3] * glm_vec3_dot((float*)d, screw.axis) - s * d[3];
    screw.distance = 2 * h;
    float moment[3];
    for (int i = 0; i < 3; i++) moment[i] = (d[i] - h * r[3] * screw.axis[i]) / s;
    cross(screw.axis, moment, screw.point); /* the point of the line nearest the origin */
    return screw;
}

dm_pose dmi_pose_sclerp(const dm_pose* a, const dm_pose* b, float t) {
    dm_pose inverse = dmi_pose_inverse(a);
    dm_pose way = dmi_pose_multiply(&inverse, b);
    if (way.real[3] < 0) { /* the double that turns by less than pi */
        glm_vec4_negate(way.real);
        glm_vec4_negate(way.dual);
    }
    dmi_screw screw = dmi_pose_to_screw(&way);
    dm_pose part = dmi_pose_from_screw(screw.axis, screw.point, t * screw.angle, t * screw.distance);
    return dmi_pose_multiply(a, &part);
}
