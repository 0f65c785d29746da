/* Unit dual quaternions: q = r + eps d with d = 1/2 t (*) r, so that t = 2 d (*) conj(r). */
#include "math/dual_quat.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "cglm/scalar_quat.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define MIN_HALF_SINE 1e-7f  /* sine of half the angle below which a rotation is rounding noise: a translation */
#define MIN_UNIT_LENGTH 0.5f /* least length of a unit quaternion; by hand, generous to accumulated rounding */
#define MAX_UNIT_LENGTH 2.0f

/* out: neither a nor b. */
static void quat_mul(const float a[4], const float b[4], float out[4]) {
    glm_quat_mul(dmi_glm(a), dmi_glm(b), out);
}

static float dot4(const float a[4], const float b[4]) {
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

dm_pose dmi_pose_identity(void) {
    return (dm_pose){.real = {0, 0, 0, 1}};
}

dm_pose dmi_pose_from_rotation_translation(const float rotation[4], const float translation[3]) {
    dm_pose pose;
    memcpy(pose.real, rotation, sizeof pose.real);
    float half[4] = {0, 0, 0, 0};
    dmi_scale3(translation, 0.5f, half);
    quat_mul(half, rotation, pose.dual);
    return pose;
}

/* Closed form: t = p - R p would cancel digits where the axis is far from the origin. */
dm_pose dmi_pose_from_screw(const float axis[3], const float point[3], float angle, float distance) {
    const dmi_circlef half = dmi_circle_atf(0.5f * angle);
    const float s = half.sine, c = half.cosine, h = 0.5f * distance;
    float moment[3];
    dmi_cross3(point, axis, moment);
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

bool dmi_pose_is_near_unit(const dm_pose* pose, float* out_length) {
    *out_length = glm_quat_norm(dmi_glm(pose->real));
    return *out_length > MIN_UNIT_LENGTH && *out_length < MAX_UNIT_LENGTH;
}

dm_pose dmi_pose_normalize(const dm_pose* pose) {
    dm_pose out;
    const float norm = sqrtf(dot4(pose->real, pose->real));
    if (!(norm > FLT_MIN && norm <= FLT_MAX)) return dmi_pose_identity();
    for (int i = 0; i < 4; i++) {
        out.real[i] = pose->real[i] / norm;
        out.dual[i] = pose->dual[i] / norm;
    }
    glm_vec4_muladds(out.real, -dot4(out.real, out.dual), out.dual);
    return out;
}

void dmi_pose_translation(const dm_pose* pose, float out[3]) {
    const float* r = pose->real;
    const float* d = pose->dual;
    float sum[3], turned[3];
    dmi_scale3(d, r[3], sum);
    dmi_madd3(sum, -d[3], r, sum);
    dmi_cross3(r, d, turned);
    dmi_add3(sum, turned, sum);
    dmi_scale3(sum, 2, out);
}

void dmi_pose_rotate(const dm_pose* pose, const float vector[3], float out[3]) {
    const float* r = pose->real;
    float once[3], twice[3];
    dmi_cross3(r, vector, once);
    dmi_cross3(r, once, twice);
    dmi_madd3(twice, r[3], once, once);
    dmi_madd3(vector, 2, once, out);
}

void dmi_pose_apply(const dm_pose* pose, const float point[3], float out[3]) {
    float translation[3];
    dmi_pose_translation(pose, translation);
    dmi_pose_rotate(pose, point, out);
    dmi_add3(out, translation, out);
}

void dmi_pose_to_matrix(const dm_pose* pose, float out[16]) {
    const float *q = pose->real, norm = sqrtf(dot4(q, q)), s = norm > 0 ? 2 / norm : 0;
    const float xx = s * q[0] * q[0], xy = s * q[0] * q[1], wx = s * q[3] * q[0];
    const float yy = s * q[1] * q[1], yz = s * q[1] * q[2], wy = s * q[3] * q[1];
    const float zz = s * q[2] * q[2], xz = s * q[0] * q[2], wz = s * q[3] * q[2];
    float t[3];
    dmi_pose_translation(pose, t);
    const float columns[16] = {1 - yy - zz, xy + wz, xz - wy,     0, xy - wz, 1 - xx - zz, yz + wx, 0,
                               xz + wy,     yz - wx, 1 - xx - yy, 0, t[0],    t[1],        t[2],    1};
    memcpy(out, columns, sizeof columns);
}

static dmi_screw translation_screw(const dm_pose* pose) {
    dmi_screw screw = {.axis = {1, 0, 0}, .angle = pose->real[3] < 0 ? DMI_TWO_PI_F : 0};
    float translation[3];
    dmi_pose_translation(pose, translation);
    screw.distance = dmi_length3(translation);
    if (screw.distance > FLT_MIN) dmi_scale3(translation, 1 / screw.distance, screw.axis);
    return screw;
}

dmi_screw dmi_pose_to_screw(const dm_pose* pose) {
    const float* r = pose->real;
    const float* d = pose->dual;
    const float s = dmi_length3(r);
    if (!(s > MIN_HALF_SINE)) return translation_screw(pose);
    dmi_screw screw = {.axis = {r[0] / s, r[1] / s, r[2] / s}, .angle = 2 * dmi_atan2f(s, r[3])};
    /* Let h be half the distance, m = p x a the moment, and c, s those of half the angle. The dual part is (s m + h c
     * a, -h s). c (d . a) - s d_w = h loses no digits at either end of the angles, as -d_w / s does near 0. */
    const float h = r[3] * dmi_dot3(d, screw.axis) - s * d[3];
    screw.distance = 2 * h;
    float moment[3];
    for (int i = 0; i < 3; i++) moment[i] = (d[i] - h * r[3] * screw.axis[i]) / s;
    dmi_cross3(screw.axis, moment, screw.point); /* the point of the line nearest the origin */
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
