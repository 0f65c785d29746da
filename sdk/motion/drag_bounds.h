/* How far a part gets in one update: a highest speed and acceleration, and bounds that the host's world sets. */
#ifndef DMI_MOTION_DRAG_BOUNDS_H
#define DMI_MOTION_DRAG_BOUNDS_H

#include "motion/drag_rules.h"

/* Bounds of one update; infinite on a free side. */
typedef struct dmi_bounds {
    float lower, upper;
} dmi_bounds;

/* Returns the value inside the bounds that is nearest to `value`. */
float dmi_bounds_clamp(dmi_bounds bounds, float value);
/* Returns whether the bounds hold a part at `value` that is asked to go to `target`. */
bool dmi_bounds_hold(dmi_bounds bounds, float value, float target, float range, bool held_before);

/* Limits a step of dt seconds from `before`, which the feel or the plan of a release has made. The step gets no faster
 * than the rules allow, and stops softly at the bounds without passing them. speed_before: the velocity before the
 * step. Returns whether value or velocity has changed. */
bool dmi_limit_step(const dmi_rules* rules, dmi_bounds bounds, float before, float speed_before, float dt,
                    float* inout_value, float* inout_velocity);

/* Returns the target for `asked`. `last` is the target of the last update, and `inout_lag` is `last` minus what was
 * asked then. A part that was held glides to the hand once it is free. The caller bounds the result and stores the lag
 * that is left. */
float dmi_catch_up(float asked, float last, float lag, float dt);

#endif
