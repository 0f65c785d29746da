/* Checks of joints that a host hands in, and the joint of a scaled instance. */
#include "api_joint_check.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "math/elementary.h"
#include "math/joint.h"

#define MIN_AXIS_LENGTH 1e-6 /* shortest axis of a host; a shorter one has no direction; by hand */
/* Largest scale, and inverse of the smallest one; by hand, so that sizes stay comparable. */
#define LARGEST_SCALE 1e6f
#define UNIT_TOLERANCE 1e-6 /* an axis whose length is this near to 1 keeps its bits: rounding of three floats */

/* A limit farther from rest than UNLIMITED counts as none; set by hand. STAND_IN replaces it where the other limit is
 * meant, and is beyond UNLIMITED again when it is read back. */
#define UNLIMITED_SLIDE 100.0f /* object sizes */
#define STAND_IN_TURN 1024.0f  /* rad */
#define STAND_IN_SLIDE 128.0f  /* object sizes */

/* A joint's numbers without its limits, which may be infinite in a host's joint. */
static const struct {
    const char* name;
    size_t offset;
} numbers[] = {{".axis.x", offsetof(dm_joint, axis.x)},     {".axis.y", offsetof(dm_joint, axis.y)},
               {".axis.z", offsetof(dm_joint, axis.z)},     {".origin.x", offsetof(dm_joint, origin.x)},
               {".origin.y", offsetof(dm_joint, origin.y)}, {".origin.z", offsetof(dm_joint, origin.z)},
               {".pitch", offsetof(dm_joint, pitch)},       {".closed", offsetof(dm_joint, closed)}};
enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

dm_result dmi_joint_read(dmi_env* env, const char* what, const dm_joint* joint, dm_joint* out) {
    dm_result result = dmi_read_desc(env, what, joint, DMI_FIRST_SIZE(dm_joint, source), sizeof *out, out);
    out->struct_size = 0;
    return result;
}

dm_result dmi_joint_check_out(dmi_env* env, const char* what, const dm_joint* out) {
    return dmi_check_out(env, what, out, DMI_FIRST_SIZE(dm_joint, source));
}

/* ---- limits ---- */

static bool has_value_limits(int32_t type) {
    return type == DM_JOINT_REVOLUTE || type == DM_JOINT_PRISMATIC || type == DM_JOINT_SCREW;
}

float dmi_joint_value_unit(const dm_joint* joint, float size) {
    return joint->type == DM_JOINT_PRISMATIC ? size : 1;
}

static float far_limit(const dm_joint* joint, float size) {
    const float far = joint->type == DM_JOINT_PRISMATIC ? UNLIMITED_SLIDE * size : DMI_UNLIMITED_TURN;
    return dmi_fminf(far, dmi_joint_farthest(joint));
}

static float stand_in(const dm_joint* joint, float size) {
    return joint->type == DM_JOINT_PRISMATIC ? STAND_IN_SLIDE * size : STAND_IN_TURN;
}

int32_t dmi_joint_open_side(const dm_joint* joint, float size) {
    const float far = far_limit(joint, size);
    if (!dmi_joint_has_limits(joint)) return 0;
    return joint->upper >= far ? 1 : joint->lower <= -far ? -1 : 0;
}

static dm_result accept_limits(dmi_env* env, const char* what, float size, dm_joint* joint) {
    const float far = far_limit(joint, size), lower = joint->lower, upper = joint->upper;
    if (isnan(lower) || isnan(upper)) {
        return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s.%s is %g", what, isnan(lower) ? "lower" : "upper", (double)NAN);
    }
    if (lower > upper) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.lower %g is above upper %g", what, (double)lower,
                        (double)upper);
    }
    if (lower >= far || upper <= -far) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "%s.lower %g and upper %g: a limit beyond %g stands for none, so this one is on the wrong side",
                        what, (double)lower, (double)upper, (double)far);
    }
    if (lower <= -far) joint->lower = upper >= far ? 0 : -stand_in(joint, size);
    if (upper >= far) joint->upper = lower <= -far ? 0 : stand_in(joint, size);
    return DM_OK;
}

/* ---- the joint ---- */

dm_result dmi_joint_check(dmi_env* env, const char* what, const dm_joint* joint, int32_t first_type) {
    for (int i = 0; i < NUMBERS; i++) {
        float number;
        memcpy(&number, (const uint8_t*)joint + numbers[i].offset, sizeof number);
        dm_result result = dmi_check_number(env, what, numbers[i].name, number);
        if (result != DM_OK) return result;
    }
    if (joint->type >= first_type && joint->type <= DM_JOINT_FIXED) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.type is %d: it must be %d to %d", what, joint->type, first_type,
                    DM_JOINT_FIXED);
}

dm_result dmi_joint_accept_axis(dmi_env* env, const char* what, dm_joint* joint) {
    dm_vec3* a = &joint->axis;
    const double x = (double)a->x, y = (double)a->y, z = (double)a->z, length = sqrt(x * x + y * y + z * z);
    const bool moves = joint->type != DM_JOINT_FIXED && joint->type != DM_JOINT_UNKNOWN;
    if (!(length > MIN_AXIS_LENGTH) && moves)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.axis has length %g", what, length);
    if (!(length > MIN_AXIS_LENGTH))
        *a = (dm_vec3){0, 1, 0}; /* a fixed joint needs some axis */
    else if (fabs(length - 1) > UNIT_TOLERANCE)
        *a = (dm_vec3){(float)(x / length), (float)(y / length), (float)(z / length)};
    return DM_OK;
}

dm_result dmi_joint_accept(dmi_env* env, const char* what, float size, dm_joint* joint) {
    dm_result result = dmi_joint_check(env, what, joint, DM_JOINT_REVOLUTE);
    if (result == DM_OK) result = dmi_joint_accept_axis(env, what, joint);
    if (result != DM_OK) return result;
    if (joint->type != DM_JOINT_SCREW) joint->pitch = 0;
    if (has_value_limits(joint->type)) {
        result = accept_limits(env, what, size, joint);
        joint->closed = dmi_joint_has_limits(joint) ? dmi_joint_closed(joint) : 0;
        return result;
    }
    joint->closed = 0;
    /* Where there are no limits, hosts leave anything, often infinities. What a drag gave stays as it is. */
    const bool harmless =
        joint->lower <= joint->upper && joint->lower > -DMI_UNLIMITED_TURN && joint->upper < DMI_UNLIMITED_TURN;
    if (!harmless) joint->lower = joint->upper = 0;
    return DM_OK;
}

/* ---- scaled instances ---- */

dm_result dmi_scale_read(dmi_env* env, const char* what, dm_vec3 scale, dm_vec3* out) {
    static const char* const fields[3] = {".x", ".y", ".z"};
    const float factors[3] = {scale.x, scale.y, scale.z};
    dm_result result = dmi_check_vector(env, what, fields, factors);
    if (result != DM_OK) return result;
    *out = scale;
    const int zeros = (scale.x == 0) + (scale.y == 0) + (scale.z == 0);
    if (zeros == 3) *out = (dm_vec3){1, 1, 1};
    const float most = dmi_fmaxf(fabsf(out->x), dmi_fmaxf(fabsf(out->y), fabsf(out->z)));
    const float least = dmi_fminf(fabsf(out->x), dmi_fminf(fabsf(out->y), fabsf(out->z)));
    if (least >= 1 / LARGEST_SCALE && most <= LARGEST_SCALE) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s is (%g, %g, %g): each factor must be %g to %g, or all 0", what,
                    (double)scale.x, (double)scale.y, (double)scale.z, 1 / (double)LARGEST_SCALE,
                    (double)LARGEST_SCALE);
}

/* Scales a limit. One that counts as none stays finite. */
static float scaled_limit(float limit, float length) {
    return dmi_fmaxf(dmi_fminf(limit * length, FLT_MAX), -FLT_MAX);
}

/* Scales a joint. The line goes through the scaled points. A mirror reverses the direction of a turn, so its axis is
 * reversed (a slide's is not), and with it the pitch. */
float dmi_joint_scale(dm_joint* joint, dm_vec3 scale) {
    if (scale.x == 1 && scale.y == 1 && scale.z == 1) return 1;
    const double s[3] = {(double)scale.x, (double)scale.y, (double)scale.z};
    const double a[3] = {s[0] * (double)joint->axis.x, s[1] * (double)joint->axis.y, s[2] * (double)joint->axis.z};
    const double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const double sign = dmi_joint_turns(joint->type) && s[0] * s[1] * s[2] < 0 ? -1 : 1;
    joint->origin.x *= scale.x, joint->origin.y *= scale.y, joint->origin.z *= scale.z;
    if (!(length > 0)) return 1;
    joint->axis =
        (dm_vec3){(float)(sign * a[0] / length), (float)(sign * a[1] / length), (float)(sign * a[2] / length)};
    joint->pitch *= (float)(sign * length);
    if (joint->type == DM_JOINT_PRISMATIC) {
        joint->lower = scaled_limit(joint->lower, (float)length);
        joint->upper = scaled_limit(joint->upper, (float)length);
    }
    return (float)length;
}
