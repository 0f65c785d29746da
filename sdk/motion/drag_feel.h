/* How a drag feels: ends that give, catches, and the part's own weight between the hand and the joint value. */
#ifndef DMI_MOTION_DRAG_FEEL_H
#define DMI_MOTION_DRAG_FEEL_H

#include "math/joint.h"

#define DMI_LN_2 0.69314718f

/* Width of the soft zone inside (and outside) each limit. */
float dmi_feel_soft_width(const dm_drag_feel* feel, const dm_joint* joint);
/* What the pointer asks for, brought into the limits and towards the catches; rises with `reach`. */
float dmi_feel_target(const dm_drag_feel* feel, const dm_joint* joint, float reach);
/* The same where the limits are estimates, which yield to a pull that goes on: a notch instead of an end. */
float dmi_feel_yield(const dm_drag_feel* feel, float lower, float upper, float reach);
/* A reach that has this target. */
float dmi_feel_reach(const dm_drag_feel* feel, const dm_joint* joint, float target);
/* The catch nearest to a value, inside the limits; the value itself where there are none. */
float dmi_feel_catch(const dm_drag_feel* feel, const dm_joint* joint, float value);
/* Half-life of a free part's speed, s; 0 = it stops at once. */
float dmi_feel_coast_time(const dm_drag_feel* feel);

/* The part follows a target that went evenly from `before` to `target` in `dt`: the exact answer of its equation of
 * motion, so that the same path gives the same value however it is cut into updates. */
void dmi_feel_follow(const dm_drag_feel* feel, const dm_joint* joint, float before, float target, float dt,
                     float* inout_value, float* inout_velocity);

#endif
