/* Computes and compares velocities of the part's points. */
#include "kinematics/candidates/twist.h"

#include "math/elementary.h"
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
