/* Where a part truly goes, and how far a joint's answer leaves it from there: the error that a player sees. */
#ifndef DM_LAB_POSE_ERROR_H
#define DM_LAB_POSE_ERROR_H

#include "math/joint.h"
#include "mesh/cloud.h"

#define LAB_POSE_POINTS 96

typedef struct lab_pose_target {
    const float (*from)[3];
    float to[LAB_POSE_POINTS][3];
    float drag_from[3], drag_to[3];
} lab_pose_target;

/* The part's first points after the joint has moved to its farther limit (at most 1.2 rad; 0.3 of the object when it
 * slides freely). Borrows the cloud. */
void lab_pose_target_make(const dmi_cloud* cloud, const dm_joint* joint, const float drag_point[3],
                          lab_pose_target* out_target);
/* Mean distance from the target, over the object's size, when another joint has brought the drag's point as near to its
 * goal as it can. */
float lab_pose_error(const lab_pose_target* target, int32_t type, const float axis[3], const float origin[3]);

#endif
