/* Blends the shown pose of a dragged part from one pose to another without a jump. When the joint changes, the grabbed
 * point returns to the pointer quickly and the part turns about it; on one joint the part follows that joint. */
#ifndef DMI_DRAG_POSE_BLEND_H
#define DMI_DRAG_POSE_BLEND_H

#include "math/dual_quat.h"

typedef struct dmi_pose_blend {
    dm_pose offset;  /* shown pose = offset after the joint's pose, when the blend began */
    float lag[3];    /* vector from the grabbed point at the joint's pose to where it was shown then, host units */
    float age;       /* s since then */
    float turn_time; /* s after which the offset's rotation has faded */
    float lag_time;  /* s after which the lag has faded; 0: the offset fades as one screw */
} dmi_pose_blend;

/* Returns a blend that changes nothing. */
dmi_pose_blend dmi_pose_blend_none(void);
/* Blends from `before` to `now`, both poses of one joint, along the screw between them. A longer way takes longer. */
dmi_pose_blend dmi_pose_blend_same_joint(const dm_pose* before, const dm_pose* now);
/* Blends to a pose of another joint. point: the grabbed point with the part at rest. size: the part's, host units. */
dmi_pose_blend dmi_pose_blend_new_joint(const dm_pose* before, const dm_pose* now, const float point[3], float size);
/* Returns the pose to show for a pose of the joint. */
dm_pose dmi_pose_blend_apply(const dmi_pose_blend* blend, const dm_pose* joint, const float point[3]);

#endif
