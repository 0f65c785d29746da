/* Joints with one degree of freedom: converts a joint value to a pose, and a pose to the nearest joint value. */
#include "math/joint.h"

#include <math.h>
#include <stdbool.h>

#include "math/elementary.h"
#include "math/linear3.h"

float dmi_joint_open_end(const dm_joint* joint) {
    const float rest = dmi_joint_clamp(joint, 0);
    return joint->upper - rest >= rest - joint->lower ? joint->upper : joint->lower;
}

float dmi_joint_opened(const dm_joint* joint) {
    const float closed = dmi_joint_closed(joint);
    return joint->upper - closed >= closed - joint->lower ? joint->upper : joint->lower;
}

/* Returns the length that a screw advances a radian; 0 for other joints. */
static float advance(const dm_joint* joint) {
    return joint->type == DM_JOINT_SCREW ? joint->pitch : 0;
}

dm_pose dmi_joint_pose(const dm_joint* joint, float value) {
    if (dmi_joint_turns(joint->type)) {
        return dmi_pose_from_screw(dmi_xyz(joint->axis).v, dmi_xyz(joint->origin).v, value, advance(joint) * value);
    }
    if (joint->type == DM_JOINT_PRISMATIC) {
        dm_pose pose = dmi_pose_identity();
        dmi_scale3(dmi_xyz(joint->axis).v, 0.5f * value, pose.dual);
        return pose;
    }
    return dmi_pose_identity();
}

float dmi_joint_project(const dm_joint* joint, const dm_pose* pose, float near) {
    float value = near;
    if (dmi_joint_turns(joint->type)) {
        /* Swing-twist decomposition: the twist's quaternion is (axis sin, cos) of half the angle, up to scale and
         * sign. */
        const float s = dmi_dot3(pose->real, dmi_xyz(joint->axis).v), c = pose->real[3];
        /* The pose is half a turn about a perpendicular axis, so all twists are equally near. */
        if (s == 0 && c == 0) return near;
        value = 2 * dmi_atan2f(s, c);
        value += DMI_TWO_PI_F * roundf((near - value) / DMI_TWO_PI_F);
    } else if (joint->type == DM_JOINT_PRISMATIC) {
        float translation[3];
        dmi_pose_translation(pose, translation);
        value = dmi_dot3(translation, dmi_xyz(joint->axis).v);
    }
    return isfinite(value) ? value : near;
}

void dmi_joint_reverse(dm_joint* joint) {
    const float lower = joint->lower;
    joint->axis = (dm_vec3){-joint->axis.x, -joint->axis.y, -joint->axis.z};
    joint->lower = -joint->upper, joint->upper = -lower;
    joint->closed = 0 - joint->closed; /* a 0 stays +0 */
}

void dmi_joint_move(const dm_joint* joint, float value, const float rest_point[3], float out[3]) {
    const dmi_float3 axis = dmi_xyz(joint->axis), origin = dmi_xyz(joint->origin);
    const float distance = (joint->type == DM_JOINT_PRISMATIC ? 1 : advance(joint)) * value;
    if (dmi_joint_turns(joint->type)) {
        const dmi_circlef at = dmi_circle_atf(value);
        dmi_turn3(axis.v, origin.v, at.cosine, at.sine, rest_point, out);
    } else {
        dmi_copy3(rest_point, out);
    }
    dmi_madd3(out, distance, axis.v, out);
}

void dmi_joint_velocity(const dm_joint* joint, float value, const float rest_point[3], float out[3]) {
    const dmi_float3 axis = dmi_xyz(joint->axis);
    if (dmi_joint_turns(joint->type)) {
        float p[3];
        dmi_copy3(rest_point, p);
        if (value != 0) { /* a part at rest leaves every point where it is */
            const dm_pose pose = dmi_joint_pose(joint, value);
            dmi_pose_apply(&pose, rest_point, p);
        }
        dmi_sub3(p, dmi_xyz(joint->origin).v, p);
        dmi_cross3(axis.v, p, out);
        dmi_madd3(out, advance(joint), axis.v, out);
    } else {
        dmi_scale3(axis.v, joint->type == DM_JOINT_PRISMATIC ? 1 : 0, out);
    }
}

void dmi_joint_set_origin_near(dm_joint* joint, const float centre[3]) {
    const dmi_float3 axis = dmi_xyz(joint->axis);
    dmi_float3 origin = dmi_xyz(joint->origin);
    float gap[3];
    dmi_sub3(centre, origin.v, gap);
    dmi_madd3(origin.v, dmi_dot3(gap, axis.v), axis.v, origin.v);
    joint->origin = dmi_vec3(origin.v);
}
