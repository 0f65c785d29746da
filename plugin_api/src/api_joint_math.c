/* Joints as plain values: no context, no state, any thread. */
#include <math.h>

#include "api_check.h"
#include "api_joint_check.h"
#include "base/fp_environment.h"
#include "math/elementary.h"
#include "math/joint.h"
#include "math/linear3.h"

#define LIMIT_TOLERANCE 1e-4f /* rad by which rounding may put a value beyond its limit; by hand */

/* Reads a joint, and checks the numbers that a pose is made of. */
static dm_result read_joint(const dm_joint* joint, dm_joint* out) {
    dm_result result = dmi_joint_read(NULL, "", joint, out);
    if (result == DM_OK) result = dmi_joint_check(NULL, "", out, DM_JOINT_UNKNOWN);
    return result == DM_OK ? dmi_joint_accept_axis(NULL, "", out) : result;
}

dm_result DM_CALL dm_joint_pose(const dm_joint* joint, float value, dm_pose* out_pose) {
    DMI_OWN_FP;
    dm_joint known;
    if (joint == NULL || out_pose == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = read_joint(joint, &known);
    if (result == DM_OK) result = dmi_check_number(NULL, "", "", value);
    if (result == DM_OK) *out_pose = dmi_joint_pose(&known, value);
    return result;
}

/* ---- value of a pose ---- */

/* Returns how far a pose moves the joint's origin along the axis. */
static float advance_of(const dm_joint* joint, const dm_pose* pose) {
    const dmi_float3 origin = dmi_xyz(joint->origin);
    float moved[3];
    dmi_pose_apply(pose, origin.v, moved);
    dmi_sub3(moved, origin.v, moved);
    return dmi_dot3(moved, dmi_xyz(joint->axis).v);
}

/* Returns the value inside the limits among those that are whole turns apart, or the value itself where none is. */
static float turn_into_limits(const dm_joint* joint, float value) {
    if (!dmi_joint_has_limits(joint)) return value;
    const float lower = joint->lower - LIMIT_TOLERANCE, upper = joint->upper + LIMIT_TOLERANCE;
    float other = value;
    if (value < lower) other = value + DMI_TWO_PI_F * ceilf((lower - value) / DMI_TWO_PI_F);
    if (value > upper) other = value - DMI_TWO_PI_F * ceilf((value - upper) / DMI_TWO_PI_F);
    return other >= lower && other <= upper ? other : value;
}

static float value_of(const dm_joint* joint, const dm_pose* pose) {
    if (joint->type == DM_JOINT_SCREW && joint->pitch != 0)
        return dmi_joint_project(joint, pose, advance_of(joint, pose) / joint->pitch);
    if (joint->type == DM_JOINT_PRISMATIC) return advance_of(joint, pose);
    const float value = dmi_joint_project(joint, pose, 0);
    return dmi_joint_turns(joint->type) ? turn_into_limits(joint, value) : value;
}

static float angle_between(const dm_pose* a, const dm_pose* b) {
    const dm_pose back = dmi_pose_inverse(a), off = dmi_pose_multiply(&back, b);
    return 2 * dmi_atan2f(dmi_length3(off.real), fabsf(off.real[3]));
}

static float distance_between(const dm_pose* a, const dm_pose* b, const float point[3]) {
    float here[3], there[3];
    dmi_pose_apply(a, point, here);
    dmi_pose_apply(b, point, there);
    dmi_sub3(here, there, here);
    return dmi_length3(here);
}

dm_result DM_CALL dm_joint_value(const dm_joint* joint, const dm_pose* pose, float* out_value, float* out_angle_error,
                                 float* out_distance_error) {
    DMI_OWN_FP;
    dm_joint known;
    dm_pose unit;
    if (joint == NULL || pose == NULL || out_value == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = read_joint(joint, &known);
    if (result == DM_OK) result = dmi_check_pose(NULL, "", pose, &unit);
    if (result != DM_OK) return result;
    const float value = value_of(&known, &unit);
    const dm_pose nearest = dmi_joint_pose(&known, value);
    const float angle = angle_between(&nearest, &unit);
    const float distance = distance_between(&nearest, &unit, dmi_xyz(known.origin).v);
    if (!isfinite(value) || !isfinite(angle) || !isfinite(distance)) return DM_ERROR_NOT_FINITE;
    *out_value = value;
    if (out_angle_error != NULL) *out_angle_error = angle;
    if (out_distance_error != NULL) *out_distance_error = distance;
    return DM_OK;
}

dm_result DM_CALL dm_joint_value_at(const dm_joint* joint, float share, float* out_value) {
    DMI_OWN_FP;
    dm_joint known;
    if (joint == NULL || out_value == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = read_joint(joint, &known);
    if (result == DM_OK) result = dmi_check_number(NULL, "", "", share);
    if (result == DM_OK && !dmi_joint_has_limits(&known)) result = DM_ERROR_INVALID_ARGUMENT;
    if (result != DM_OK) return result;
    const float rest = dmi_joint_clamp(&known, 0);
    const float value = rest + share * (dmi_joint_open_end(&known) - rest);
    if (!isfinite(value)) return DM_ERROR_NOT_FINITE;
    *out_value = value;
    return DM_OK;
}

/* ---- constraint frame ---- */

/* Computes the shortest rotation that takes the x axis, or for the far half its mirror image, to `x`. */
static void rotation_to(const float x[3], float out[4]) {
    if (x[0] >= 0) {
        out[0] = 0, out[1] = -x[2], out[2] = x[1], out[3] = 1 + x[0];
    } else { /* starts with half a turn about z */
        out[0] = x[2], out[1] = 0, out[2] = 1 - x[0], out[3] = x[1];
    }
    const float length = sqrtf(out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3]);
    for (int i = 0; i < 4; i++) out[i] /= length;
}

static void set_limits(const dm_joint* joint, dm_joint_frame* frame) {
    const float far = joint->type == DM_JOINT_PRISMATIC ? DMI_LARGEST : DMI_UNLIMITED_TURN;
    if (!dmi_joint_has_limits(joint) || joint->type == DM_JOINT_FIXED || joint->type == DM_JOINT_UNKNOWN) return;
    if (joint->lower > -far) frame->limits |= DM_LIMIT_LOWER, frame->lower = joint->lower;
    if (joint->upper < far) frame->limits |= DM_LIMIT_UPPER, frame->upper = joint->upper;
}

dm_result DM_CALL dm_joint_get_frame(const dm_joint* joint, dm_joint_frame* out_frame) {
    DMI_OWN_FP;
    dm_joint known;
    if (joint == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = read_joint(joint, &known);
    if (result == DM_OK) result = dmi_check_out(NULL, "", out_frame, DMI_FIRST_SIZE(dm_joint_frame, pitch));
    if (result != DM_OK) return result;
    dmi_float3 x = dmi_xyz(known.axis);
    if (!(dmi_normalize3(x.v) > 0)) return DM_ERROR_INVALID_ARGUMENT;
    dm_joint_frame frame = {.type = known.type, .origin = known.origin, .x = dmi_vec3(x.v)};
    rotation_to(x.v, frame.rotation);
    const dm_pose turn = {.real = {frame.rotation[0], frame.rotation[1], frame.rotation[2], frame.rotation[3]}};
    float y[3], z[3];
    dmi_pose_rotate(&turn, (const float[3]){0, 1, 0}, y);
    dmi_pose_rotate(&turn, (const float[3]){0, 0, 1}, z);
    frame.y = dmi_vec3(y), frame.z = dmi_vec3(z);
    if (known.type == DM_JOINT_SCREW) frame.pitch = known.pitch;
    set_limits(&known, &frame);
    dmi_write_out(out_frame, &frame, sizeof frame);
    return DM_OK;
}

/* ---- scale ---- */

dm_result DM_CALL dm_joint_scale(const dm_joint* joint, dm_vec3 scale, dm_joint* out_joint) {
    DMI_OWN_FP;
    dm_joint known;
    dm_vec3 factors;
    if (joint == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dm_result result = read_joint(joint, &known);
    if (result == DM_OK) result = dmi_joint_check_out(NULL, "", out_joint);
    if (result == DM_OK) result = dmi_scale_read(NULL, "", scale, &factors);
    if (result != DM_OK) return result;
    dmi_joint_scale(&known, factors);
    result = dmi_joint_check(NULL, "", &known, DM_JOINT_UNKNOWN);
    if (result != DM_OK) return result;
    dmi_write_out(out_joint, &known, sizeof known);
    return DM_OK;
}
