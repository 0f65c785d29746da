/* Steps with a highest speed and acceleration in closed form; an exponential approach to a bound. Both give the same
 * way at any frame rate. */
#include "motion/drag_bounds.h"

#include <math.h>

#include "base/number_bounds.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* The values are set by hand. */
#define STOP_HALF_LIFE 0.02f    /* s in which half of the way to a bound is made at most, and half of the way back */
#define CATCH_UP_HALF_LIFE 0.1f /* s in which a part that is free again makes up for half of what it is behind */
#define HELD_SHARE 0.005f       /* share of the range; a bound this near holds the part … */
#define FREE_SHARE 0.02f        /* … and a part this far from it is free again */

float dmi_bounds_clamp(dmi_bounds bounds, float value) {
    return dmi_fminf(dmi_fmaxf(value, bounds.lower), bounds.upper);
}

bool dmi_bounds_hold(dmi_bounds bounds, float value, float target, float range, bool held_before) {
    const float near = (held_before ? FREE_SHARE : HELD_SHARE) * range;
    return (target > bounds.upper && value >= bounds.upper - near) ||
           (target < bounds.lower && value <= bounds.lower + near);
}

/* Returns the longest step of dt seconds: the speed rises with the highest acceleration up to the highest speed. speed:
 * at the start, not negative; out_speed: at the end. */
static float longest_step(const dmi_rules* rules, float speed, float dt, float* out_speed) {
    const float most = rules->max_speed > 0 ? rules->max_speed : INFINITY, gain = rules->max_acceleration;
    const float start = dmi_fminf(speed, most), end = gain > 0 ? dmi_fminf(start + gain * dt, most) : most;
    *out_speed = end;
    if (!(gain > 0)) return most * dt;
    const float rise = (end - start) / gain; /* s in which it gets faster */
    return 0.5f * (start + end) * rise + end * (dt - rise);
}

static bool limit_speed(const dmi_rules* rules, float before, float speed_before, float dt, float* value,
                        float* velocity) {
    if (!(rules->max_speed > 0) && !(rules->max_acceleration > 0)) return false;
    const float step = *value - before, side = step < 0 ? -1.0f : 1.0f;
    float speed;
    const float longest = longest_step(rules, dmi_fmaxf(side * speed_before, 0), dt, &speed);
    if (!(fabsf(step) > longest)) return false;
    *value = before + side * longest;
    *velocity = side * speed;
    return true;
}

/* Makes no more than a share of the way to the bounds, and at least that share of the way back to them. */
static bool limit_to_bounds(dmi_bounds bounds, float before, float dt, float* value, float* velocity) {
    if (bounds.lower == -INFINITY && bounds.upper == INFINITY) return false;
    const float share = 1 - dmi_exp2f(-dt / STOP_HALF_LIFE);
    const float most = before + (bounds.upper - before) * share, least = before + (bounds.lower - before) * share;
    const float asked = *value, kept = dmi_fmaxf(dmi_fminf(asked, most), least);
    if (kept == asked) return false;
    *value = before >= bounds.lower && before <= bounds.upper ? dmi_bounds_clamp(bounds, kept) : kept;
    if (dt > 0) *velocity = (*value - before) / dt;
    return true;
}

bool dmi_limit_step(const dmi_rules* rules, dmi_bounds bounds, float before, float speed_before, float dt,
                    float* inout_value, float* inout_velocity) {
    const bool slowed = limit_speed(rules, before, speed_before, dt, inout_value, inout_velocity);
    const bool held = limit_to_bounds(bounds, before, dt, inout_value, inout_velocity);
    /* A very short step could give a larger velocity. */
    *inout_velocity = dmi_clamp_within(*inout_velocity, DMI_LARGEST_RATE);
    return slowed || held;
}

float dmi_catch_up(float asked, float last, float lag, float dt) {
    const float gap = last - asked;
    if (!(gap * lag > 0)) return asked; /* the target has arrived, or the hand has come back past it */
    return asked + copysignf(dmi_fminf(fabsf(gap), fabsf(lag)), lag) * dmi_exp2f(-dt / CATCH_UP_HALF_LIFE);
}
