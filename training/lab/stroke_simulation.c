/* Simulates a player's strokes: amplitude, pace and unsteadiness. Their noise-free joint values are the DQ-VAE's
 * targets.
 */
#include <math.h>
#include <string.h>

#include "case.h"

#define LAST (DM_MOTION_FRAMES - 1)

enum { MIN_JERK, EASE_IN, EASE_OUT, LINEAR, SMOOTH, STOP_EARLY, START_LATE, TURN_BACK, PACES };

/* Minimum-jerk profile (Flash and Hogan 1985). */
static float min_jerk(float t) {
    return t * t * t * (10.0f + t * (6.0f * t - 15.0f));
}

/* Returns the share of the way done at time t in [0, 1]; `turn` is the time at which an uneven pace changes. */
static float progress(int pace, float t, float turn) {
    switch (pace) {
    case EASE_IN:
        return t * t;
    case EASE_OUT:
        return 1.0f - (1.0f - t) * (1.0f - t);
    case LINEAR:
        return t;
    case SMOOTH:
        return t * t * (3.0f - 2.0f * t);
    case STOP_EARLY:
        return fminf(1.0f, t / turn);
    case START_LATE:
        return fmaxf(0.0f, (t - 1.0f + turn) / turn);
    case TURN_BACK:
        return t < turn ? min_jerk(t / turn) : 1.0f - (1.0f - turn) * min_jerk((t - turn) / (1.0f - turn));
    default:
        return min_jerk(t);
    }
}

/* Returns how far the joint goes along the drag; continuous joints one turn, as the library's default path. */
static float reach(const dm_joint* joint) {
    if (joint->type == DM_JOINT_CONTINUOUS) return 6.28318531f;
    return joint->upper;
}

/* Adds a direction error, a lag and tremor to the path. */
static void shake(dmi_random* random, float path[DM_MOTION_FRAMES][3]) {
    float axis[3], rotation[9];
    lab_random_direction(random, axis);
    lab_rotation(axis, 0.07f * dmi_random_normal(random), rotation);
    const float lag = lab_random_bool(random, 0.4f) ? lab_random_uniform(random, 0.0f, 0.3f) : 0.0f;
    const float share = lab_random_uniform(random, 0.0f, 0.02f);
    float length = 0.0f;
    for (int i = 0; i < 3; i++) length = fmaxf(length, fabsf(path[LAST][i] - path[0][i]));
    for (int f = 1; f < DM_MOTION_FRAMES; f++) {
        float offset[3];
        for (int i = 0; i < 3; i++) offset[i] = path[f][i] - path[0][i];
        lab_rotate(rotation, offset, offset);
        for (int i = 0; i < 3; i++) path[f][i] = path[0][i] + offset[i];
    }
    for (int f = 1; f < DM_MOTION_FRAMES; f++)
        for (int i = 0; i < 3; i++) path[f][i] += lag * (path[f - 1][i] - path[f][i]);
    for (int f = 1; f < DM_MOTION_FRAMES; f++)
        for (int i = 0; i < 3; i++) path[f][i] += share * length * dmi_random_normal(random);
}

void lab_stroke_make(dmi_random* random, const dm_joint* joint, const float drag_point[3], int steady, int noisy,
                     lab_stroke* out_stroke) {
    const int pace = steady ? MIN_JERK : (int)(dmi_random_u32(random) % PACES);
    const float turn = lab_random_uniform(random, 0.4f, 0.9f);
    float amplitude = steady ? 1.0f : lab_random_uniform(random, 0.1f, 1.0f);
    /* Some players pull past the end stop. */
    if (noisy && lab_random_bool(random, 0.15f)) amplitude = lab_random_uniform(random, 1.0f, 1.3f);
    const float most = reach(joint);
    for (int f = 0; f < DM_MOTION_FRAMES; f++) {
        const float value = amplitude * most * progress(pace, (float)f / (float)LAST, turn);
        const dm_pose pose = dmi_joint_pose(joint, value);
        dmi_pose_apply(&pose, drag_point, out_stroke->path[f]);
        out_stroke->values[f] = fminf(value, most);
    }
    memcpy(out_stroke->path[0], drag_point, sizeof out_stroke->path[0]);
    if (noisy) shake(random, out_stroke->path);
}
