/* Opens a few points of the part by a candidate joint and compares where they end. */
#include "kinematics/candidates/opened_part.h"

#include "math/elementary.h"
#include "math/joint.h"
#include "math/linear3.h"

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
