/* What a released part does: the plan from where it is and how fast it goes to where it ends, and the motion along it.
 */
#ifndef DMI_MOTION_DRAG_RELEASE_H
#define DMI_MOTION_DRAG_RELEASE_H

#include "motion/drag_flight.h"
#include "motion/drag_intent.h"
#include "motion/motion.h"

typedef struct dmi_release {
    int32_t phase, intent;        /* DM_DRAG_*; DM_INTENT_STAY, OPEN, CLOSE or FREEZE */
    float start, end, velocity;   /* joint values, and velocity at the release in values a second */
    float duration, elapsed;      /* s */
    float return_time;            /* s; 0: nothing springs back */
    bool glides;                  /* the value decays exponentially without an aim; else it moves to `end` */
    bool flies;                   /* it falls, or glides with bounces, from value and velocity to value and velocity */
    float acceleration;           /* acceleration of a fall, joint value a second squared; 0: it glides */
    bool paced;                   /* it follows the keys; else minimum jerk */
    float keys[DM_MOTION_FRAMES]; /* joint values from rest outwards, evenly spaced in time */
    float first, last;            /* times on the keys, 0 to 1, where the part starts and ends */
} dmi_release;

/* Plans the release. intent: DM_INTENT_* as the host asked. duration: s; 0 lets the plan choose it. The phase becomes
 * DM_DRAG_RELEASED, or DM_DRAG_AT_REST when there is nothing to do. */
void dmi_release_begin(dmi_release* release, const dmi_released_part* part, int32_t intent, float duration);
/* Paces the plan by a generated motion from rest to the outer one of start and end. Values that do not suit the plan
 * leave it as it is. Returns whether the plan is paced. */
bool dmi_release_set_pace(dmi_release* release, const float values[DM_MOTION_FRAMES]);
/* Advances value and velocity by dt seconds. */
void dmi_release_advance(dmi_release* release, const dm_drag_feel* feel, const dm_joint* joint, float dt,
                         float* out_value, float* out_velocity);
/* Does the same for a plan that flies. Returns the limits that it has struck. */
dmi_landing dmi_release_fly(dmi_release* release, const dmi_released_part* part, float dt, float* out_value,
                            float* out_velocity);

#endif
