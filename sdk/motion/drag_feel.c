/* How a drag feels: soft ends and catches as maps of the value, stiffness, damping and inertia in closed form. */
#include "motion/drag_feel.h"

#include <math.h>

#define DEFAULT_SMOOTHING_TIME 0.02f /* s, half-life */
#define DEFAULT_COAST_TIME 0.1f      /* s, half-life */
#define DEFAULT_DETENT_PULL 0.7f
#define NOTCH_SHARE 0.01f /* of the range: felt, but seen by nobody */
#define TWO_PI 6.28318530717958647692f
#define BISECTIONS 40

float dmi_feel_soft_width(const dm_drag_feel* feel, const dm_joint* joint) {
    const float share = fminf(fmaxf(feel->soft_limit, 0), 0.5f);
    return dmi_joint_has_limits(joint) ? share * (joint->upper - joint->lower) : 0;
}

/* An end that gives: x from w before the limit to w behind it comes down on [-w, 0] by a parabola, so that the slope
 * falls from 1 to 0 and the limit itself is reached. */
static float soften_end(float x, float w) {
    return x <= -w ? x : x - (x + w) * (x + w) / (4 * w);
}

static float harden_end(float y, float w) {
    return y <= -w ? y : 2 * w * (1 - sqrtf(fmaxf(1 - (y + w) / w, 0))) - w;
}

/* Both ends of the range by one of the two maps. */
static float map_ends(const dm_drag_feel* feel, const dm_joint* joint, float value, float (*map)(float, float)) {
    const float w = dmi_feel_soft_width(feel, joint), lower = joint->lower, upper = joint->upper;
    if (!(w > 0)) return value;
    return value > 0.5f * (lower + upper) ? upper + map(value - upper, w) : lower - map(lower - value, w);
}

static float detent_pull(const dm_drag_feel* feel) {
    return feel->detent_pull == 0 ? DEFAULT_DETENT_PULL : fminf(fmaxf(feel->detent_pull, 0), 1);
}

/* Towards the nearest catch: slow near a catch, quick between two, never back. */
static float pull_to_catch(const dm_drag_feel* feel, float value) {
    if (!(feel->detent > 0)) return value;
    const float place = value / feel->detent, turns = place - roundf(place);
    return value - detent_pull(feel) * feel->detent / TWO_PI * sinf(TWO_PI * turns);
}

static float leave_catch(const dm_drag_feel* feel, float target) {
    if (!(feel->detent > 0)) return target;
    float low = target - feel->detent, high = target + feel->detent;
    for (int i = 0; i < BISECTIONS; i++) {
        const float middle = 0.5f * (low + high);
        if (pull_to_catch(feel, middle) < target)
            low = middle;
        else
            high = middle;
    }
    return 0.5f * (low + high);
}

float dmi_feel_target(const dm_drag_feel* feel, const dm_joint* joint, float reach) {
    return dmi_joint_clamp(joint, map_ends(feel, joint, pull_to_catch(feel, reach), soften_end));
}

/* Holds for a width, and makes up for it over two more. */
static float notch(float beyond, float width) {
    return beyond >= 3 * width ? beyond : 1.5f * fmaxf(beyond - width, 0);
}

float dmi_feel_yield(const dm_drag_feel* feel, float lower, float upper, float reach) {
    const float width = NOTCH_SHARE * (upper - lower), asked = pull_to_catch(feel, reach);
    if (asked > upper) return upper + notch(asked - upper, width);
    if (asked < lower) return lower - notch(lower - asked, width);
    return asked;
}

float dmi_feel_reach(const dm_drag_feel* feel, const dm_joint* joint, float target) {
    return leave_catch(feel, map_ends(feel, joint, target, harden_end));
}

float dmi_feel_catch(const dm_drag_feel* feel, const dm_joint* joint, float value) {
    if (!(feel->detent > 0)) return value;
    const float nearest = dmi_joint_clamp(joint, feel->detent * roundf(value / feel->detent));
    return isfinite(nearest) ? nearest : value;
}

float dmi_feel_coast_time(const dm_drag_feel* feel) {
    return feel->coast_time == 0 ? DEFAULT_COAST_TIME : fmaxf(feel->coast_time, 0);
}

/* dx/dt = rate (T - x) with T even from `before` to `target`. A convex mix of x and both targets, so it keeps limits.
 */
static float follow_weightless(float rate, float before, float target, float dt, float value) {
    const float k = rate * dt, kept = expf(-k);
    const float lag = k > 0.01f ? (1 - kept) / k : 1 - k / 2 + k * k / 6; /* (1 - exp(-k)) / k */
    return (1 - lag) * target + (lag - kept) * before + kept * value;
}

/* tau x'' + x' = rate (T - x): with y = x - T + T'/rate, tau y'' + y' + rate y = 0, a damped oscillator. In doubles:
 * the slow and the fast root may be far apart. */
static void follow_heavy(double tau, double rate, double before, double target, double dt, double* value,
                         double* velocity) {
    const double slope = (target - before) / dt, lag = slope / rate;
    const double damping = 0.5 / tau, square = damping * damping - rate / tau, w = sqrt(fabs(square));
    const double y = *value - before + lag, v = *velocity - slope;
    double cosine, sine; /* of the oscillator, decayed; sine over w */
    if (square >= 0) {
        const double slow = exp((w - damping) * dt), fast = exp((-w - damping) * dt);
        cosine = 0.5 * (slow + fast);
        sine = w * dt > 1e-4 ? 0.5 * (slow - fast) / w : dt * fast;
    } else {
        const double decay = exp(-damping * dt);
        cosine = decay * cos(w * dt);
        sine = w * dt > 1e-4 ? decay * sin(w * dt) / w : dt * decay;
    }
    *value = target - lag + y * (cosine + damping * sine) + v * sine;
    *velocity = slope + v * (cosine - damping * sine) - y * (rate / tau) * sine;
}

void dmi_feel_follow(const dm_drag_feel* feel, const dm_joint* joint, float before, float target, float dt,
                     float* inout_value, float* inout_velocity) {
    const float half = feel->smoothing_time == 0 ? DEFAULT_SMOOTHING_TIME : feel->smoothing_time;
    const float old = *inout_value, rate = DMI_LN_2 / half;
    double value = (double)target, velocity = (double)*inout_velocity;
    if (half > 0 && feel->coast_time > 0 && dt > 0) {
        value = (double)old;
        follow_heavy((double)(feel->coast_time / DMI_LN_2), (double)rate, (double)before, (double)target, (double)dt,
                     &value, &velocity);
        if (!isfinite(value) || !isfinite(velocity)) value = (double)target, velocity = 0;
    } else if (half > 0) {
        value = (double)follow_weightless(rate, before, target, dt, old);
    }
    *inout_value = dmi_joint_clamp(joint, (float)value);
    if ((double)*inout_value != (double)(float)value) velocity = 0; /* the stop takes it */
    if (!(feel->coast_time > 0) || !(half > 0)) velocity = (double)((*inout_value - old) / dt);
    if (dt > 0 && isfinite((float)velocity)) *inout_velocity = (float)velocity;
}
