/* What a part does once it is let go: it swings on, falls shut, springs back or stays. */
#ifndef DMI_MOTION_DRAG_RELEASE_H
#define DMI_MOTION_DRAG_RELEASE_H

#include <stdbool.h>

#include "motion/drag_feel.h"
#include "motion/motion.h"

typedef struct dmi_release {
    int32_t phase, intent;      /* DM_DRAG_*; DM_INTENT_STAY, OPEN, CLOSE or FREEZE */
    float start, end, velocity; /* of the joint value, at the release */
    float duration, elapsed;
    float return_time;            /* s; 0: nothing springs back */
    int glides;                   /* without an aim, else it moves to the end */
    int paced;                    /* by keys */
    float keys[DM_MOTION_FRAMES]; /* values from rest outwards */
    float first, last;            /* where on the keys, 0 to 1, the part starts and ends */
} dmi_release;

struct dmi_drag;

/* DM_INTENT_* as the host asked for it -> what will happen. duration 0: its own. */
void dmi_drag_release(struct dmi_drag* drag, int32_t intent, float duration);
/* A generated motion from rest to the outer one of start and end sets the pace; unfit ones leave it as it is. 1 when it
 * did. */
bool dmi_drag_set_pace(struct dmi_drag* drag, const float values[DM_MOTION_FRAMES]);
/* Value and velocity `dt` later. */
void dmi_release_advance(dmi_release* release, const dm_drag_feel* feel, const dm_joint* joint, float dt,
                         float* out_value, float* out_velocity);

#endif
