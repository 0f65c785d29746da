/* From one joint's pose to the next one's without a jump: the grabbed point goes back to the pointer at once, the rest
 * of the part turns after it. */
#ifndef DMI_MOTION_DRAG_HANDOVER_H
#define DMI_MOTION_DRAG_HANDOVER_H

#include "math/dual_quat.h"

typedef struct dmi_handover {
    dm_pose turn;    /* of the pose shown before from the joint's own: its rotation alone */
    float lag[3];    /* from where the grabbed point is with the joint's pose to where it was shown */
    float age;       /* since the pose shown began to come over, s */
    float turn_time; /* after which the turn is gone, s … */
    float lag_time;  /* … and the lag */
} dmi_handover;

/* Nothing to come over from. */
dmi_handover dmi_handover_none(void);
/* The part is shown at `before` and comes over to `now`: the farther, the longer it takes. point: grabbed, with the
 * part at rest; size: of the part, 0 when nobody knows it. */
dmi_handover dmi_handover_begin(const dm_pose* before, const dm_pose* now, const float point[3], float size);
/* The pose shown: the joint's own, and what is left of the way over. */
dm_pose dmi_handover_pose(const dmi_handover* handover, const dm_pose* joint, const float point[3]);

#endif
