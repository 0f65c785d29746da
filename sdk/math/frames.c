/* Conversions of host axes, handedness, unit and an object's normalisation: N(x) = (unit S x - centre) / size, S
 * orthogonal.
 *
 * The presets map a host's axes as its own glTF importer does, so that an object prepared from a GLB and the same
 * object imported by the engine agree: Unity as glTFast and UnityGLTF (x turns over), Unreal as Epic's importer and
 * exporter (y and z change places), Blender as its own importer.
 *
 * Under S an axial vector (a turning axis, a quaternion's imaginary part) becomes det(S) S a, a polar one S a. */
#include "math/frames.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "cglm/scalar_quat.h"
#include "math/joint.h"
#include "math/linear3.h"

#define ORTHOGONALITY_TOLERANCE 1e-4f /* largest product of two columns that counts as 0; by hand */
#define MIN_SIZE 1e-18    /* size of an object, metres or host units; by hand: its inverse square is a float */
#define MAX_SIZE 1e18     /* the same; by hand: its square is a float */
#define MAX_DISTANCE 1e37 /* distance of an object from its origin; by hand: sums of three of them are floats */

static const float preset_axes[][9] = {
    [DM_AXES_GLTF] = {1, 0, 0, 0, 1, 0, 0, 0, 1},
    [DM_AXES_UNITY] = {-1, 0, 0, 0, 1, 0, 0, 0, 1},
    [DM_AXES_UNREAL] = {1, 0, 0, 0, 0, 1, 0, 1, 0},
    [DM_AXES_BLENDER] = {1, 0, 0, 0, 0, 1, 0, -1, 0},
};

static bool is_orthogonal(const float m[9]) {
    for (size_t i = 0; i < 3; i++) {
        for (size_t k = 0; k < 3; k++) {
            const float product = dmi_dot3(m + 3 * i, m + 3 * k);
            if (!(fabsf(product - (i == k ? 1.0f : 0.0f)) <= ORTHOGONALITY_TOLERANCE)) return false; /* NaN too */
        }
    }
    return true;
}

bool dmi_axes_init(dmi_axes* out, int32_t preset, const float custom[9], float unit_in_metres) {
    if (preset < DM_AXES_GLTF || preset > DM_AXES_CUSTOM) return false;
    const float* axes = preset == DM_AXES_CUSTOM ? custom : preset_axes[preset];
    if (axes == NULL || !is_orthogonal(axes)) return false;
    if (!(unit_in_metres >= 0) || !isfinite(unit_in_metres)) return false;
    memcpy(out->to_canonical, axes, sizeof out->to_canonical);
    out->handedness = glm_mat3_det((vec3*)axes) < 0 ? -1.0f : 1.0f;
    out->unit = unit_in_metres > 0 ? unit_in_metres : 1;
    return true;
}

static void turn_in(const dmi_frame* frame, const double v[3], double out[3]) {
    const float* m = frame->axes.to_canonical;
    for (size_t i = 0; i < 3; i++) {
        out[i] = (double)m[3 * i] * v[0] + (double)m[3 * i + 1] * v[1] + (double)m[3 * i + 2] * v[2];
    }
}

static void turn_out(const dmi_frame* frame, const double v[3], double out[3]) {
    const float* m = frame->axes.to_canonical;
    for (size_t i = 0; i < 3; i++) {
        out[i] = (double)m[i] * v[0] + (double)m[3 + i] * v[1] + (double)m[6 + i] * v[2];
    }
}

void dmi_axes_point_in(const dmi_axes* axes, const double host[3], double out[3]) {
    const dmi_frame frame = {.axes = *axes};
    turn_in(&frame, host, out);
    for (int i = 0; i < 3; i++) out[i] *= (double)axes->unit;
}

static void narrow(const double v[3], double scale, float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = (float)(v[i] * scale);
}

static void widen(const float v[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = (double)v[i];
}

/* Returns inner units in one host unit. */
static double scale_in(const dmi_frame* frame) {
    return (double)frame->axes.unit / frame->size;
}

static double scale_out(const dmi_frame* frame) {
    return frame->size / (double)frame->axes.unit;
}

float dmi_frame_length_out(const dmi_frame* frame) {
    return (float)scale_out(frame);
}

static bool is_usable(double size, const double centre[3]) {
    for (int i = 0; i < 3; i++) {
        if (!(fabs(centre[i]) <= MAX_DISTANCE)) return false; /* NaN too */
    }
    return size >= MIN_SIZE && size <= MAX_SIZE;
}

bool dmi_frame_is_usable(const dmi_frame* frame) {
    double host[3];
    for (int i = 0; i < 3; i++) host[i] = frame->centre[i] / (double)frame->axes.unit;
    return is_usable(frame->size, frame->centre) && is_usable(scale_out(frame), host);
}

void dmi_frame_point_in(const dmi_frame* frame, const double host[3], float out[3]) {
    double turned[3];
    turn_in(frame, host, turned);
    for (int i = 0; i < 3; i++) {
        out[i] = (float)(((double)frame->axes.unit * turned[i] - frame->centre[i]) / frame->size);
    }
}

void dmi_frame_point_out(const dmi_frame* frame, const float inner[3], float out_host[3]) {
    double canonical[3], turned[3];
    for (int i = 0; i < 3; i++) canonical[i] = (double)inner[i] * frame->size + frame->centre[i];
    turn_out(frame, canonical, turned);
    narrow(turned, 1 / (double)frame->axes.unit, out_host);
}

void dmi_frame_matrix_out(const dmi_frame* frame, double out_host[12]) {
    for (size_t column = 0; column < 4; column++) {
        const double axis[3] = {column == 0, column == 1, column == 2};
        double* image = out_host + 3 * column;
        turn_out(frame, column < 3 ? axis : frame->centre, image);
        const double scale = column < 3 ? scale_out(frame) : 1 / (double)frame->axes.unit;
        for (int i = 0; i < 3; i++) image[i] *= scale;
    }
}

static void convert(const dmi_frame* frame, void (*turn)(const dmi_frame*, const double[3], double[3]), double scale,
                    const float v[3], float out[3]) {
    double wide[3], turned[3];
    widen(v, wide);
    turn(frame, wide, turned);
    narrow(turned, scale, out);
}

void dmi_frame_vector_in(const dmi_frame* frame, const float host[3], float out[3]) {
    convert(frame, turn_in, scale_in(frame), host, out);
}

void dmi_frame_vector_out(const dmi_frame* frame, const float inner[3], float out_host[3]) {
    convert(frame, turn_out, scale_out(frame), inner, out_host);
}

void dmi_frame_direction_in(const dmi_frame* frame, const float host[3], float out[3]) {
    convert(frame, turn_in, 1, host, out);
}

void dmi_frame_direction_out(const dmi_frame* frame, const float inner[3], float out_host[3]) {
    convert(frame, turn_out, 1, inner, out_host);
}

static dm_vec3 vec3_in(const dmi_frame* frame, dm_vec3 host) {
    float inner[3];
    dmi_frame_point_in(frame, dmi_xyz_f64(host).v, inner);
    return dmi_vec3(inner);
}

dm_ray dmi_frame_ray_in(const dmi_frame* frame, const dm_ray* host) {
    float direction[3];
    dmi_frame_direction_in(frame, dmi_xyz(host->direction).v, direction);
    return (dm_ray){vec3_in(frame, host->origin), dmi_vec3(direction)};
}

/* Computes R v - v of a unit quaternion without forming R v, exact for small rotations. */
static void rotation_shift(const float q[4], const double v[3], double out[3]) {
    const double x = (double)q[0], y = (double)q[1], z = (double)q[2], w = (double)q[3];
    const double once[3] = {y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]};
    out[0] = 2 * (w * once[0] + y * once[2] - z * once[1]);
    out[1] = 2 * (w * once[1] + z * once[0] - x * once[2]);
    out[2] = 2 * (w * once[2] + x * once[1] - y * once[0]);
}

/* T' = N T N^-1 has R' = S R S^T and t' = scale S t + (R' - 1) centre / size. */
dm_pose dmi_frame_pose_in(const dmi_frame* frame, const dm_pose* host) {
    float rotation[4] = {0, 0, 0, host->real[3]}, translation[3];
    convert(frame, turn_in, (double)frame->axes.handedness, host->real, rotation);
    dmi_pose_translation(host, translation);
    dmi_frame_vector_in(frame, translation, translation);
    double shift[3];
    rotation_shift(rotation, frame->centre, shift);
    for (int i = 0; i < 3; i++) translation[i] += (float)(shift[i] / frame->size);
    return dmi_pose_from_rotation_translation(rotation, translation);
}

/* The other way: t = S^T (t' size - (R' - 1) centre) / unit. */
dm_pose dmi_frame_pose_out(const dmi_frame* frame, const dm_pose* inner) {
    float rotation[4] = {0, 0, 0, inner->real[3]}, translation[3];
    convert(frame, turn_out, (double)frame->axes.handedness, inner->real, rotation);
    dmi_pose_translation(inner, translation);
    double shift[3], moved[3], turned[3];
    rotation_shift(inner->real, frame->centre, shift);
    for (int i = 0; i < 3; i++) moved[i] = (double)translation[i] * frame->size - shift[i];
    turn_out(frame, moved, turned);
    narrow(turned, 1 / (double)frame->axes.unit, translation);
    return dmi_pose_from_rotation_translation(rotation, translation);
}

/* Converts pitch and limits; `scale` is that of lengths. */
static void convert_numbers(dm_joint* joint, float handedness, float scale) {
    /* A turning axis carries the handedness along, so the advance along it changes sign with it. */
    joint->pitch *= dmi_joint_turns(joint->type) ? handedness * scale : scale;
    if (joint->type == DM_JOINT_PRISMATIC) {
        joint->lower *= scale;
        joint->upper *= scale;
        joint->closed *= scale;
    }
}

static double axis_sign(const dmi_frame* frame, const dm_joint* joint) {
    return dmi_joint_turns(joint->type) ? (double)frame->axes.handedness : 1;
}

dm_joint dmi_frame_joint_in(const dmi_frame* frame, const dm_joint* host) {
    dm_joint joint = *host;
    float axis[3];
    convert(frame, turn_in, axis_sign(frame, host), dmi_xyz(host->axis).v, axis);
    joint.axis = dmi_vec3(axis);
    joint.origin = vec3_in(frame, host->origin);
    convert_numbers(&joint, frame->axes.handedness, (float)scale_in(frame));
    return joint;
}

dm_joint dmi_frame_joint_out(const dmi_frame* frame, const dm_joint* inner) {
    dm_joint joint = *inner;
    float axis[3], origin[3];
    convert(frame, turn_out, axis_sign(frame, inner), dmi_xyz(inner->axis).v, axis);
    dmi_frame_point_out(frame, dmi_xyz(inner->origin).v, origin);
    joint.axis = dmi_vec3(axis);
    joint.origin = dmi_vec3(origin);
    convert_numbers(&joint, frame->axes.handedness, (float)scale_out(frame));
    return joint;
}
