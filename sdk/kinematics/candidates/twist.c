/* Velocities of a part's points, and the angle between two joints'. */
#include "kinematics/candidates/twist.h"

#include "math/linear3.h"

static void make_unit(dmi_twist* t) {
    float square = 0;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) square += dmi_dot3(t->velocity[i], t->velocity[i]);
    const float scale = 1 / sqrtf(square + 1e-20f);
    for (int i = 0; i < DMI_TWIST_POINTS; i++)
        for (int k = 0; k < 3; k++) t->velocity[i][k] *= scale;
}

void dmi_twist_of_candidate(const dmi_part_analysis* study, const dmi_candidate* candidate, dmi_twist* out) {
    out->slides = candidate->type == DM_JOINT_PRISMATIC;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) dmi_candidate_velocity(candidate, study->points[i], out->velocity[i]);
    make_unit(out);
}

void dmi_twist_of_joint(const dmi_part_analysis* study, const dm_joint* joint, dmi_twist* out) {
    out->slides = joint->type == DM_JOINT_PRISMATIC;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) dmi_joint_velocity(joint, 0, study->points[i], out->velocity[i]);
    make_unit(out);
}

float dmi_twist_difference(const dmi_twist* a, const dmi_twist* b) {
    if (a->slides != b->slides) return 1;
    float cosine = 0;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) cosine += dmi_dot3(a->velocity[i], b->velocity[i]);
    return sqrtf(fmaxf(1 - cosine * cosine, 0));
}
