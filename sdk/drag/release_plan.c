/* Plans one smooth motion of a released part to its end. */
#include "drag/release.h"

#include <math.h>

#include "math/elementary.h"

/* The values are set by hand, with the releases of tests/unit/test_drag_release.c; docs/feel.md. */
/* Share of dmi_released_unit; a part that is this near to its end counts as there. */
#define ARRIVED_SHARE 1e-4f
#define MIN_DURATION 0.18f    /* s, the shortest of any motion */
#define FULL_RANGE_TIME 0.7f  /* s of a motion over the whole range */
#define GLIDE_HALF_LIVES 7.0f /* half-lives after which a gliding part stops: 1/128 of the speed is left */
#define PEAK_SPEED 1.875f     /* highest speed of a minimum-jerk motion, reached in the middle, over its mean speed */
/* Highest acceleration of a minimum-jerk motion, times time^2 over distance: 10 / sqrt(3), rounded up. */
#define PEAK_ACCELERATION 5.7736f
#define MIN_FALL_TIME 1e-3f  /* s; any shorter fall is over within a frame too */
#define MAX_BACKWARDS 0.105f /* maximum of s (1 - s)^3 on [0, 1], 27/256 rounded down */

static bool is_limit(const dm_joint* joint, float value) {
    return value == joint->lower || value == joint->upper;
}

/* Returns the least duration of a motion over `distance` that the rules allow. */
static float shortest_duration(const dmi_released_part* part, float distance) {
    float time = 0;
    const float speed = dmi_released_rules(part)->max_speed, acceleration = dmi_released_rules(part)->max_acceleration;
    if (speed > 0) time = PEAK_SPEED * fabsf(distance) / speed;
    if (acceleration > 0) time = dmi_fmaxf(time, sqrtf(PEAK_ACCELERATION * fabsf(distance) / acceleration));
    return dmi_fminf(time, DMI_LARGEST_TIME);
}

/* Returns the duration of a motion over `distance`. The duration grows with the share of the range, and is shorter
 * where the part already goes faster. */
static float natural_duration(const dmi_released_part* part, float distance) {
    const float speed = fabsf(part->velocity);
    const float share = dmi_joint_has_limits(part->joint) ? dmi_fminf(fabsf(distance) / dmi_released_unit(part), 1) : 1;
    float time = FULL_RANGE_TIME * sqrtf(share);
    if (part->velocity * distance > 0) time = dmi_fminf(time, 2 * fabsf(distance) / speed);
    return dmi_fmaxf(dmi_fmaxf(time, MIN_DURATION), shortest_duration(part, distance));
}

/* Plans a glide to a stop or to a limit; with detents or snap values, a motion to the nearest one instead. */
static void plan_stay(const dmi_released_part* part, dmi_release* r) {
    const float end = dmi_joint_clamp(part->joint, part->value + dmi_released_glide(part));
    r->end = dmi_feel_nearest_detent(part->feel, part->joint, end);
    dmi_released_is_caught(part, &r->end);
    r->duration = dmi_fminf(GLIDE_HALF_LIVES * dmi_feel_coast_time(part->feel), DMI_LARGEST_TIME);
    r->glides = r->end == end;
    if (!r->glides) r->duration = natural_duration(part, r->end - r->start);
    if (fabsf(r->end - r->start) <= ARRIVED_SHARE * dmi_released_unit(part)) r->duration = 0;
}

/* Returns the initial velocity, reduced so that a part which first moves away from its end does not hit the stop behind
 * it: it gets no farther than MAX_BACKWARDS times velocity times duration. */
static float velocity_with_room(const dmi_released_part* part, const dmi_release* r) {
    const float distance = r->end - r->start, u = r->velocity;
    if (u * distance >= 0) return u;
    const float room = u > 0 ? part->joint->upper - r->start : r->start - part->joint->lower;
    return copysignf(dmi_fminf(fabsf(u), dmi_fmaxf(room, 0) / (MAX_BACKWARDS * r->duration)), u);
}

static void plan_move(const dmi_released_part* part, dmi_release* r, float end) {
    const float distance = end - r->start;
    r->end = end;
    r->duration =
        r->return_time > 0 && r->intent == DM_INTENT_CLOSE ? r->return_time : natural_duration(part, distance);
    if (fabsf(distance) <= ARRIVED_SHARE * dmi_released_unit(part)) r->duration = 0;
}

/* Returns the flight of a plan. A fall that does not end at a limit ends without a bounce, because nothing there throws
 * the part back. */
static dmi_flight flight_of(const dmi_release* r, const dmi_released_part* part) {
    dmi_flight flight = {.lower = part->joint->lower,
                         .upper = part->joint->upper,
                         .acceleration = r->acceleration,
                         .time_constant = dmi_feel_coast_time(part->feel) / DMI_LN_2_F,
                         .restitution = dmi_released_rules(part)->restitution};
    if (r->acceleration == 0 || is_limit(part->joint, r->end)) return flight;
    if (r->acceleration < 0) flight.lower = r->end;
    if (r->acceleration > 0) flight.upper = r->end;
    flight.restitution = 0;
    return flight;
}

/* Turns the plan into a glide that a limit throws back, or into a fall. */
static void plan_flight(const dmi_released_part* part, dmi_release* r, bool by_itself) {
    const float side = r->end < r->start ? -1.0f : 1.0f,
                time = dmi_fmaxf(dmi_released_rules(part)->fall_time, MIN_FALL_TIME);
    r->acceleration = 0;
    if (r->intent == DM_INTENT_STAY && r->glides && dmi_released_is_thrown_back(part)) {
        const dmi_flight flight = flight_of(r, part);
        r->flies = flight.time_constant > 0;
        r->end = dmi_flight_end(&flight, r->start, part->velocity);
    } else if (by_itself && r->duration > 0 && dmi_released_falls(part)) {
        r->flies = true;
        const float pull = 2 * (part->joint->upper - part->joint->lower) / (time * time);
        r->acceleration = side * dmi_fminf(pull, DMI_LARGEST_RATE);
        r->duration = dmi_fminf(sqrtf(2 * (r->end - r->start) / r->acceleration), time);
    }
}

dmi_landing dmi_release_fly(dmi_release* r, const dmi_released_part* part, float dt, float* out_value,
                            float* out_velocity) {
    const dmi_flight flight = flight_of(r, part);
    dmi_landing landing = dmi_flight_advance(&flight, dt, out_value, out_velocity);
    if (flight.lower != part->joint->lower || flight.upper != part->joint->upper)
        landing.struck = 0; /* rest, where this fall ends, is no limit to strike */
    r->elapsed = dmi_fminf(r->elapsed + dt, DMI_LARGEST_TIME);
    if (landing.settled) {
        r->phase = DM_DRAG_AT_REST;
        r->end = *out_value;
        *out_velocity = 0;
    }
    return landing;
}

void dmi_release_begin(dmi_release* r, const dmi_released_part* part, int32_t intent, float duration) {
    r->elapsed = 0;
    r->phase = DM_DRAG_RELEASED;
    if (intent == DM_INTENT_REPLAY) return;
    const int32_t asked = intent == DM_INTENT_AUTO ? dmi_released_intent(part, r->return_time) : intent;
    r->intent = asked;
    r->start = r->end = part->value;
    r->velocity = part->velocity;
    r->paced = r->glides = r->flies = false;
    r->duration = 0;
    const bool unlimited = !dmi_joint_has_limits(part->joint);
    if (asked == DM_INTENT_CLOSE)
        plan_move(part, r, dmi_joint_closed(part->joint));
    else if (asked == DM_INTENT_OPEN && !unlimited)
        plan_move(part, r, dmi_release_open_end(part));
    else if (asked != DM_INTENT_FREEZE)
        r->intent = DM_INTENT_STAY, plan_stay(part, r);
    if (intent == DM_INTENT_AUTO && asked == DM_INTENT_CLOSE && r->duration > 0 && dmi_released_closes_itself(part))
        r->duration = dmi_fmaxf(dmi_released_rules(part)->auto_close_time, shortest_duration(part, r->end - r->start));
    else if (dmi_released_rules(part)->on)
        plan_flight(part, r, intent == DM_INTENT_AUTO && r->return_time <= 0 && asked != DM_INTENT_STAY);
    if (duration > 0 && r->duration > 0) {
        r->duration = duration; /* a glide and a fall take their own time, whatever duration was asked for */
        r->glides = r->flies = false;
    }
    if (!r->glides && r->duration > 0 && !unlimited) r->velocity = velocity_with_room(part, r);
    if (r->duration > 0) return;
    r->velocity = 0;
    r->phase = DM_DRAG_AT_REST;
}
