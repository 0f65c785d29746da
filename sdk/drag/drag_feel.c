/* Soft ends and detents as maps of the joint value; stiffness, damping and inertia as a linear second-order system
 * solved in closed form. */
#include "drag/drag_feel.h"

#include <math.h>

#include "math/elementary.h"

#define DEFAULT_SMOOTHING_TIME 0.02f /* s, half-life; by hand: hides a mouse's pixels */
#define DEFAULT_COAST_TIME 0.1f      /* s, half-life; by hand */
#define DEFAULT_DETENT_PULL 0.7f     /* share of full strength; by hand */
#define MAX_SOFT_SHARE 0.5f          /* share of the range; both soft zones meet in the middle then */
#define DEAD_ZONE 0.01f              /* share of the range by which an estimated limit holds; by hand */
#define BISECTIONS 40                /* halvings of an interval of two detents, which end below a float's rounding */
#define SERIES_BELOW 0.01f           /* (1 - exp(-k)) / k as a series below this k: error under 5e-8 */
#define LIMIT_BELOW 1e-4             /* rad: sin(x) / x counts as 1 below, sinh(x) / x as cosh(x): off by 3e-9 */

float dmi_feel_soft_width(const dm_drag_feel* feel, const dm_joint* joint) {
    const float share = dmi_fminf(dmi_fmaxf(feel->soft_limit, 0), MAX_SOFT_SHARE);
    return dmi_joint_has_limits(joint) ? share * (joint->upper - joint->lower) : 0;
}

/* Maps x in [-w, w] about a limit to [-w, 0] by a parabola: the slope falls from 1 to 0 and the limit itself is
 * reached. */
static float soften_end(float x, float w) {
    return x <= -w ? x : x - (x + w) * (x + w) / (4 * w);
}

/* Inverse of soften_end. */
static float harden_end(float y, float w) {
    return y <= -w ? y : 2 * w * (1 - sqrtf(dmi_fmaxf(1 - (y + w) / w, 0))) - w;
}

/* Applies one of the two maps at both ends of the range. */
static float map_ends(const dm_drag_feel* feel, const dm_joint* joint, float value, float (*map)(float, float)) {
    const float w = dmi_feel_soft_width(feel, joint), lower = joint->lower, upper = joint->upper;
    if (!(w > 0)) return value;
    return value > 0.5f * (lower + upper) ? upper + map(value - upper, w) : lower - map(lower - value, w);
}

float dmi_feel_detent_pull(const dm_drag_feel* feel) {
    return feel->detent_pull == 0 ? DEFAULT_DETENT_PULL : dmi_fminf(dmi_fmaxf(feel->detent_pull, 0), 1);
}

/* Moves a value towards the nearest of detents that there are; monotone, with the least slope at the detents. */
static float pull_to_detent(const dm_drag_feel* feel, float closed, float value) {
    const float place = (value - closed) / feel->detent, turns = place - roundf(place);
    return value - dmi_feel_detent_pull(feel) * feel->detent / DMI_TWO_PI_F * dmi_sinf(DMI_TWO_PI_F * turns);
}

/* Inverse of pull_to_detent, by bisection. */
static float invert_detents(const dm_drag_feel* feel, float closed, float target) {
    if (!(feel->detent > 0)) return target;
    float low = target - feel->detent, high = target + feel->detent;
    for (int i = 0; i < BISECTIONS; i++) {
        const float middle = 0.5f * (low + high);
        if (pull_to_detent(feel, closed, middle) < target)
            low = middle;
        else
            high = middle;
    }
    return 0.5f * (low + high);
}

float dmi_feel_target(const dm_drag_feel* feel, const dm_joint* joint, float pointer_value) {
    float asked = pointer_value;
    if (feel->detent > 0) asked = pull_to_detent(feel, dmi_joint_closed(joint), pointer_value);
    return dmi_joint_clamp(joint, map_ends(feel, joint, asked, soften_end));
}

/* Dead zone of one width; the map returns to the identity at three widths. */
static float dead_zone(float beyond, float width) {
    return beyond >= 3 * width ? beyond : 1.5f * dmi_fmaxf(beyond - width, 0);
}

float dmi_feel_soft_target(const dm_drag_feel* feel, float closed, float lower, float upper, float pointer_value) {
    const float width = DEAD_ZONE * (upper - lower);
    const float asked = feel->detent > 0 ? pull_to_detent(feel, closed, pointer_value) : pointer_value;
    if (asked > upper) return upper + dead_zone(asked - upper, width);
    if (asked < lower) return lower - dead_zone(lower - asked, width);
    return asked;
}

float dmi_feel_pointer_value(const dm_drag_feel* feel, const dm_joint* joint, float target) {
    return invert_detents(feel, dmi_joint_closed(joint), map_ends(feel, joint, target, harden_end));
}

float dmi_feel_soft_pointer_value(const dm_drag_feel* feel, float closed, float target) {
    return invert_detents(feel, closed, target);
}

float dmi_feel_nearest_detent(const dm_drag_feel* feel, const dm_joint* joint, float value) {
    if (!(feel->detent > 0)) return value;
    const float closed = dmi_joint_closed(joint), way = feel->detent * roundf((value - closed) / feel->detent);
    return dmi_joint_clamp(joint, closed != 0 ? closed + way : way); /* a zero keeps its sign */
}

float dmi_feel_coast_time(const dm_drag_feel* feel) {
    return feel->coast_time == 0 ? DEFAULT_COAST_TIME : dmi_fmaxf(feel->coast_time, 0);
}

/* Solves x' = rate (T - x) with T linear from `before` to `target`. The result is a convex combination of x and both
 * targets, so it stays within limits. */
static float follow_first_order(float rate, float before, float target, float dt, float value) {
    const float k = rate * dt, kept = dmi_expf(-k);
    const float lag = k > SERIES_BELOW ? (1 - kept) / k : 1 - k / 2 + k * k / 6; /* (1 - exp(-k)) / k */
    return (1 - lag) * target + (lag - kept) * before + kept * value;
}

/* Solves tau x'' + x' = rate (T - x): with y = x - T + T'/rate, tau y'' + y' + rate y = 0, a damped oscillator.
 * Doubles, because the slow and the fast root may be far apart. */
static void follow_second_order(double tau, double rate, double before, double target, double dt, double* value,
                                double* velocity) {
    const double slope = (target - before) / dt, lag = slope / rate;
    const double damping = 0.5 / tau, square = damping * damping - rate / tau, w = sqrt(fabs(square));
    const double y = *value - before + lag, v = *velocity - slope;
    double cosine, sine; /* decayed cos (cosh) of w dt, and decayed sin (sinh) of w dt over w */
    if (square >= 0) {
        const double slow = dmi_exp((w - damping) * dt), fast = dmi_exp((-w - damping) * dt);
        cosine = 0.5 * (slow + fast);
        sine = w * dt > LIMIT_BELOW ? 0.5 * (slow - fast) / w : dt * cosine;
    } else {
        const double decay = dmi_exp(-damping * dt);
        const dmi_circle at = dmi_circle_at(w * dt);
        cosine = decay * at.cosine;
        sine = w * dt > LIMIT_BELOW ? decay * at.sine / w : dt * decay;
    }
    *value = target - lag + y * (cosine + damping * sine) + v * sine;
    *velocity = slope + v * (cosine - damping * sine) - y * (rate / tau) * sine;
}

void dmi_feel_follow(const dm_drag_feel* feel, const dm_joint* joint, float before, float target, float dt,
                     float* inout_value, float* inout_velocity) {
    const float half = feel->smoothing_time == 0 ? DEFAULT_SMOOTHING_TIME : feel->smoothing_time;
    const float old = *inout_value, rate = DMI_LN_2_F / half;
    double value = (double)target, velocity = (double)*inout_velocity;
    if (half > 0 && feel->coast_time > 0 && dt > 0) {
        value = (double)old;
        follow_second_order((double)(feel->coast_time / DMI_LN_2_F), (double)rate, (double)before, (double)target,
                            (double)dt, &value, &velocity);
        if (!isfinite(value) || !isfinite(velocity)) value = (double)target, velocity = 0;
    } else if (half > 0) {
        value = (double)follow_first_order(rate, before, target, dt, old);
    }
    *inout_value = dmi_joint_clamp(joint, (float)value);
    if ((double)*inout_value != (double)(float)value) velocity = 0; /* a limit has stopped it */
    if (!(feel->coast_time > 0) || !(half > 0)) velocity = (double)((*inout_value - old) / dt);
    if (dt > 0) *inout_velocity = (float)velocity;
}

/* ---- snap values: one period of a sine is taken off the value about each, as about a detent, but each side of it has
 * its own length; both ends of the period leave the value as it is, so neighbours join ---- */

#define SNAP_BISECTIONS 40 /* halvings of twice the longest reach, which end below a float's rounding */

/* Returns the index of the snap value nearest to a value. */
static uint32_t nearest_snap(const dmi_snaps* snaps, float value) {
    uint32_t best = 0;
    while (best + 1 < snaps->count && value > 0.5f * (snaps->values[best] + snaps->values[best + 1])) best++;
    return best;
}

/* Returns how far a snap value reaches to one side. */
static float reach_of(const dmi_snaps* snaps, uint32_t index, bool upwards) {
    const bool has_next = upwards ? index + 1 < snaps->count : index > 0;
    if (!has_next) return snaps->outer_reach;
    const uint32_t low = upwards ? index : index - 1;
    const float half = 0.5f * (snaps->values[low + 1] - snaps->values[low]);
    return snaps->reach > 0 ? dmi_fminf(snaps->reach, half) : half;
}

float dmi_snaps_pull(const dmi_snaps* snaps, float value) {
    if (snaps->count == 0) return value;
    const uint32_t i = nearest_snap(snaps, value);
    const float off = value - snaps->values[i], reach = reach_of(snaps, i, off > 0);
    if (!(fabsf(off) < reach)) return value;
    return value - snaps->pull * reach / DMI_PI_F * dmi_sinf(DMI_PI_F * off / reach);
}

float dmi_snaps_invert(const dmi_snaps* snaps, float target) {
    if (snaps->count == 0) return target;
    const uint32_t i = nearest_snap(snaps, target);
    const float off = target - snaps->values[i], reach = reach_of(snaps, i, off > 0);
    if (!(fabsf(off) < reach)) return target;
    float low = target - reach, high = target + reach;
    for (int k = 0; k < SNAP_BISECTIONS; k++) {
        const float middle = 0.5f * (low + high);
        if (dmi_snaps_pull(snaps, middle) < target)
            low = middle;
        else
            high = middle;
    }
    return 0.5f * (low + high);
}

bool dmi_snaps_catch(const dmi_snaps* snaps, const dm_joint* joint, float value, float* out_snap) {
    if (snaps->count == 0) return false;
    const uint32_t i = nearest_snap(snaps, value);
    const float snap = snaps->values[i], off = value - snap;
    if (!(fabsf(off) < reach_of(snaps, i, off > 0)) || dmi_joint_clamp(joint, snap) != snap) return false;
    *out_snap = snap;
    return true;
}

float dmi_snaps_place(const dmi_snaps* snaps, float value) {
    const uint32_t i = nearest_snap(snaps, value);
    const float off = value - snaps->values[i];
    const bool outer = off > 0 ? i + 1 == snaps->count : i == 0;
    return (float)i +
           dmi_fminf(dmi_fmaxf(0.5f * off / reach_of(snaps, i, off > 0), outer ? -1 : -0.5f), outer ? 1 : 0.5f);
}
