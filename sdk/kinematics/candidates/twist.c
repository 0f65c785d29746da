/* Computes and compares velocities of the part's points, and places where the part lies opened. */
#include "kinematics/candidates/twist.h"

#include "math/elementary.h"
#include "math/joint.h"
#include "math/linear3.h"

#define MIN_SQUARE 1e-20f /* sum of squared velocities: avoids a division by zero */

static void normalize_twist(dmi_twist* t) {
    float square = 0;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) square += dmi_dot3(t->velocity[i], t->velocity[i]);
    const float scale = 1 / sqrtf(square + MIN_SQUARE);
    for (int i = 0; i < DMI_TWIST_POINTS; i++)
        for (int k = 0; k < 3; k++) t->velocity[i][k] *= scale;
}

void dmi_twist_of_candidate(const dmi_part_analysis* analysis, const dmi_candidate* candidate, dmi_twist* out) {
    out->is_prismatic = candidate->type == DM_JOINT_PRISMATIC;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) dmi_candidate_velocity(candidate, analysis->points[i], out->velocity[i]);
    normalize_twist(out);
}

void dmi_twist_of_joint(const dmi_part_analysis* analysis, const dm_joint* joint, dmi_twist* out) {
    out->is_prismatic = joint->type == DM_JOINT_PRISMATIC;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) dmi_joint_velocity(joint, 0, analysis->points[i], out->velocity[i]);
    normalize_twist(out);
}

float dmi_twist_difference(const dmi_twist* a, const dmi_twist* b) {
    if (a->is_prismatic != b->is_prismatic) return 1;
    float cosine = 0;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) cosine += dmi_dot3(a->velocity[i], b->velocity[i]);
    return sqrtf(dmi_fmaxf(1 - cosine * cosine, 0));
}

/* ---- opened parts ---- */

/* Typical ways that parts open, by which generated joints without limits are compared (training/lab/pose_error.c). */
#define TYPICAL_TURN 1.0f  /* rad */
#define TYPICAL_SLIDE 0.3f /* object sizes */

void dmi_opened_part_make(const dmi_part_analysis* analysis, const dmi_candidate* candidate, dmi_opened_part* out) {
    const float* axis = candidate->axis;
    const float* origin = candidate->origin;
    const dm_joint joint = {
        .type = candidate->type, .axis = {axis[0], axis[1], axis[2]}, .origin = {origin[0], origin[1], origin[2]}};
    const float way = candidate->type == DM_JOINT_PRISMATIC ? TYPICAL_SLIDE : TYPICAL_TURN;
    for (int side = 0; side < 2; side++) {
        const dm_pose pose = dmi_joint_pose(&joint, side == 0 ? way : -way);
        for (int i = 0; i < DMI_OPENED_POINTS; i++) dmi_pose_apply(&pose, analysis->points[i], out->at[side][i]);
    }
}

float dmi_opened_part_difference(const dmi_opened_part* a, const dmi_opened_part* b) {
    float sum[2] = {0};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < DMI_OPENED_POINTS; i++) sum[side] += dmi_distance3(a->at[0][i], b->at[side][i]);
    return dmi_min(sum[0], sum[1]) / DMI_OPENED_POINTS;
}
