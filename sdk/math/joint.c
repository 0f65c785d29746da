/* Joints with one degree of freedom: value to pose, pose to nearest value. */
#include "math/joint.h"

#include <math.h>
#include <stdbool.h>

#include "math/constants.h"
#include "math/elementary.h"
#include "math/linear3.h"
#include "math/vec3.h"

float dmi_joint_open_end(const dm_joint* joint) {
    const float rest = dmi_joint_clamp(joint, 0);
    return joint->upper - rest >= rest - joint->lower ? joint->upper : joint->lower;
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
        const float half = 0.5f * value;
        return (dm_pose){{0, 0, 0, 1}, {half * joint->axis.x, half * joint->axis.y, half * joint->axis.z, 0}};
    }
    return dmi_pose_identity();
}

float dmi_joint_project(const dm_joint* joint, const dm_pose* pose, float near) {
    float value = near;
    if (dmi_joint_turns(joint->type)) {
        /* Swing-twist decomposition: the twist's quaternion is (axis sin, cos) of half the angle, up to scale and
         * sign. */
        const float s = dmi_dot3(pose->real, dmi_xyz(joint->axis).v), c = pose->real[3];
        if (s == 0 && c == 0) return near; /* half a turn about a perpendicular axis: all twists are equally near */
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
    const dm_vec3 a = joint->axis;
    if (dmi_joint_turns(joint->type)) {
        float p[3];
        dmi_copy3(rest_point, p);
        if (value != 0) { /* at rest every point is where it is */
            const dm_pose pose = dmi_joint_pose(joint, value);
            dmi_pose_apply(&pose, rest_point, p);
        }
        const float x = p[0] - joint->origin.x, y = p[1] - joint->origin.y, z = p[2] - joint->origin.z;
        const float pitch = advance(joint);
        out[0] = a.y * z - a.z * y + pitch * a.x;
        out[1] = a.z * x - a.x * z + pitch * a.y;
        out[2] = a.x * y - a.y * x + pitch * a.z;
    } else {
        const float speed = joint->type == DM_JOINT_PRISMATIC ? 1 : 0;
        out[0] = speed * a.x;
        out[1] = speed * a.y;
        out[2] = speed * a.z;
    }
}

void dmi_joint_set_origin_near(dm_joint* joint, const float centre[3]) {
    float gap[3];
    dmi_sub3(centre, dmi_xyz(joint->origin).v, gap);
    const float along = dmi_dot3(gap, dmi_xyz(joint->axis).v);
    joint->origin.x += along * joint->axis.x;
    joint->origin.y += along * joint->axis.y;
    joint->origin.z += along * joint->axis.z;
}
