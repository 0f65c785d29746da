/* From one pose to another without a jump. From one joint's to the next one's the grabbed point goes back to the
 * pointer at once, and the rest of the part turns after it; on one joint the part stays on that. */
#ifndef DMI_MOTION_DRAG_HANDOVER_H
#define DMI_MOTION_DRAG_HANDOVER_H

#include "math/dual_quat.h"

typedef struct dmi_handover {
    dm_pose offset;  /* of the pose shown before from the joint's own */
    float lag[3];    /* from where the grabbed point is with the joint's pose to where it was shown */
    float age;       /* since the pose shown began to come over, s */
    float turn_time; /* after which the offset's turn is gone, s … */
    float lag_time;  /* … and the lag; 0: the offset goes as a whole */
} dmi_handover;

/* Nothing to come over from. */
dmi_handover dmi_handover_none(void);
/* The part is shown at `before` and comes over to `now`, of the same joint and along it: the farther, the longer it
 * takes. */
dmi_handover dmi_handover_along(const dm_pose* before, const dm_pose* now);
/* The same to the pose of another joint. point: grabbed, with the part at rest; size: of the part. */
dmi_handover dmi_handover_begin(const dm_pose* before, const dm_pose* now, const float point[3], float size);
/* The pose shown: the joint's own, and what is left of the way over. */
dm_pose dmi_handover_pose(const dmi_handover* handover, const dm_pose* joint, const float point[3]);

#endif
