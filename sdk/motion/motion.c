/* Drag paths for the network, projection of its poses onto the joint, and interpolation of the key values. */
#include "motion/motion.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

#define HALF_OBJECT 0.5f /* inner units, the object's largest side is 1: default travel of a slide without limits */
#define LAST (DM_MOTION_FRAMES - 1)

/* Returns the value at the end of the joint in the direction of `sign`. */
static float far_end(const dm_joint* joint, float sign) {
    if (dmi_joint_has_limits(joint)) return sign < 0 ? joint->lower : joint->upper;
    return sign * (dmi_joint_turns(joint->type) ? DMI_TWO_PI_F : HALF_OBJECT);
}

void dmi_motion_default_path(const dm_joint* joint, const float drag_point[3], const float drag_vector[3],
                             float out_path[DMI_VAE_PATH][3]) {
    float velocity[3];
    dmi_joint_velocity(joint, 0, drag_point, velocity);
    const float along = velocity[0] * drag_vector[0] + velocity[1] * drag_vector[1] + velocity[2] * drag_vector[2];
    const float end = far_end(joint, along < 0 ? -1.0f : 1.0f);
    for (int i = 0; i < DMI_VAE_PATH; i++) {
        const float s = (float)i / (DMI_VAE_PATH - 1);
        const float progress = s * s * s * (10 - 15 * s + 6 * s * s); /* minimum jerk: Flash and Hogan 1985 */
        dm_pose pose = dmi_joint_pose(joint, end * progress);
        dmi_pose_apply(&pose, drag_point, out_path[i]);
    }
}

void dmi_motion_resample_path(const float (*path)[3], uint32_t count, float out_path[DMI_VAE_PATH][3]) {
    memset(out_path, 0, sizeof(float[DMI_VAE_PATH][3]));
    if (count == 0) return;
    for (uint32_t i = 0; i < DMI_VAE_PATH; i++) {
        /* Integer arithmetic, so that the ends are exactly the path's own points however long it is. */
        const uint64_t place = (uint64_t)i * (count - 1), before = place / (DMI_VAE_PATH - 1);
        const uint64_t after = before + 1 < count ? before + 1 : before;
        const float share = (float)(place % (DMI_VAE_PATH - 1)) / (DMI_VAE_PATH - 1);
        for (int k = 0; k < 3; k++) out_path[i][k] = path[before][k] + share * (path[after][k] - path[before][k]);
    }
}

void dmi_motion_project(const dm_joint* joint, const float raw[DM_MOTION_FRAMES][8],
                        float out_values[DM_MOTION_FRAMES]) {
    dm_joint about_origin = *joint; /* the network's poses are about the joint's origin */
    about_origin.origin = (dm_vec3){0, 0, 0};
    float value = 0;
    for (int i = 0; i < DM_MOTION_FRAMES; i++) {
        dm_pose pose;
        memcpy(pose.real, raw[i], sizeof pose.real);
        memcpy(pose.dual, raw[i] + 4, sizeof pose.dual);
        pose = dmi_pose_normalize(&pose);
        value = dmi_joint_project(&about_origin, &pose,
                                  value); /* the value is not clamped, so that turns unwrap along the frames */
        out_values[i] = dmi_joint_clamp(joint, value);
    }
    out_values[0] = 0;
}

/* Returns the slope at a key between two secants: their harmonic mean, 0 at an extremum (Fritsch and Butland 1984). */
static float inner_slope(float before, float after) {
    return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

/* Returns the slope at the first or last key: that of the parabola through three keys, limited to three times the
 * nearest secant (Fritsch and Carlson 1980). */
static float end_slope(float nearest, float next) {
    const float slope = 0.5f * (3 * nearest - next);
    if (slope * nearest <= 0) return 0;
    return fabsf(slope) > 3 * fabsf(nearest) ? 3 * nearest : slope;
}

float dmi_motion_value(const dmi_motion* motion, float t) {
    const float* values = motion->values;
    if (!(t > 0)) return values[0]; /* a NaN gives the first value too */
    if (t >= 1) return values[LAST];
    const float place = t * LAST;
    const int k = (int)place < LAST ? (int)place : LAST - 1;
    const float s = place - (float)k, rise = values[k + 1] - values[k];
    const float before = k > 0 ? values[k] - values[k - 1] : 0,
                after = k + 1 < LAST ? values[k + 2] - values[k + 1] : 0;
    const float slope_a = k > 0 ? inner_slope(before, rise) : end_slope(rise, after);
    const float slope_b = k + 1 < LAST ? inner_slope(rise, after) : end_slope(rise, before);
    /* Cubic Hermite polynomial on [0, 1] */
    const float c = 3 * rise - 2 * slope_a - slope_b, d = slope_a + slope_b - 2 * rise;
    return values[k] + s * (slope_a + s * (c + s * d));
}
