/* Computes the pose error: the mean distance between the part moved by a candidate joint and moved by the true joint.
 */
#include "pose_error.h"

#include <math.h>

#include "math/linear3.h"

#define MOST_TURN 1.2f   /* rad: largest true turn compared */
#define FREE_SLIDE 0.3f  /* object sizes: true slide of a joint without limits */
#define MOST_ANSWER 2.2f /* rad: largest turn of the candidate */

/* Returns the true joint's value at which the poses are compared. */
static float travel(const dm_joint* joint) {
    const float farther = fmaxf(fabsf(joint->lower), fabsf(joint->upper));
    if (joint->type == DM_JOINT_PRISMATIC) return farther > 0 ? farther : FREE_SLIDE;
    return joint->type == DM_JOINT_CONTINUOUS || farther == 0 ? 1.0f : fminf(farther, MOST_TURN);
}

void lab_pose_target_make(const dmi_cloud* cloud, const dm_joint* joint, const float drag_point[3],
                          lab_pose_target* out_target) {
    const dm_pose pose = dmi_joint_pose(joint, travel(joint));
    out_target->from = (const float(*)[3])cloud->xyz;
    for (int i = 0; i < LAB_POSE_POINTS; i++) dmi_pose_apply(&pose, out_target->from[i], out_target->to[i]);
    dmi_copy3(drag_point, out_target->drag_from);
    dmi_pose_apply(&pose, drag_point, out_target->drag_to);
}

/* Returns the joint value that brings the dragged point nearest to its true position. */
static float best_value(const lab_pose_target* target, const dm_joint* joint) {
    const float axis[3] = {joint->axis.x, joint->axis.y, joint->axis.z};
    const float origin[3] = {joint->origin.x, joint->origin.y, joint->origin.z};
    float a[3], b[3], side[3];
    if (joint->type == DM_JOINT_PRISMATIC) {
        dmi_sub3(target->drag_to, target->drag_from, a);
        return dmi_dot3(a, axis);
    }
    dmi_sub3(target->drag_from, origin, a), dmi_reject3(a, axis);
    dmi_sub3(target->drag_to, origin, b), dmi_reject3(b, axis);
    dmi_cross3(a, b, side);
    return fminf(fmaxf(atan2f(dmi_dot3(side, axis), dmi_dot3(a, b)), -MOST_ANSWER), MOST_ANSWER);
}

float lab_pose_error(const lab_pose_target* target, int32_t type, const float axis[3], const float origin[3]) {
    const dm_joint joint = {
        .type = type, .axis = {axis[0], axis[1], axis[2]}, .origin = {origin[0], origin[1], origin[2]}};
    const dm_pose pose = dmi_joint_pose(&joint, best_value(target, &joint));
    float sum = 0;
    for (int i = 0; i < LAB_POSE_POINTS; i++) {
        float x[3];
        dmi_pose_apply(&pose, target->from[i], x);
        sum += dmi_distance3(x, target->to[i]);
    }
    return sum / LAB_POSE_POINTS;
}
