/* Declares the pose error: how far a candidate joint leaves a part from where the true joint takes it. */
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

/* Moves the part's first points by the true joint to its farther limit (at most 1.2 rad; 0.3 of the object's size when
 * it slides without limits). Borrows the cloud. */
void lab_pose_target_make(const dmi_cloud* cloud, const dm_joint* joint, const float drag_point[3],
                          lab_pose_target* out_target);
/* Returns the mean distance from the target, in object sizes, after another joint has brought the dragged point as near
 * to its true position as it can. */
float lab_pose_error(const lab_pose_target* target, int32_t type, const float axis[3], const float origin[3]);

#endif
