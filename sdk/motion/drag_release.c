/* Reads the player's intent from value and velocity at the release, and plans one smooth motion to the end. */
#include "motion/drag_release.h"

#include <math.h>
#include <string.h>

#include "math/constants.h"
#include "math/elementary.h"

/* By hand, with the releases of tests/unit/test_drag_release.c; docs/feel.md. */
#define LOOK_AHEAD 0.2f           /* s: the part is taken to be where its velocity carries it in this time */
#define THROWN_SHARE 0.35f        /* of the range travelled in LOOK_AHEAD: thrown, not just let go */
#define NEAR_END_SHARE 0.12f      /* of the range: as good as at the end */
#define HALF_WAY 0.5f             /* of the way to an open end: a part beyond is open */
#define AT_STOP_SHARE 0.05f       /* of the range: rest and a limit are the same */
#define ARRIVED_SHARE 1e-4f       /* of the range, or of the value without limits: there already */
#define MIN_DURATION 0.18f        /* s of any motion */
#define FULL_RANGE_TIME 0.7f      /* s over the whole range */
#define GLIDE_HALF_LIVES 7.0f     /* half-lives after which a gliding part stands: 1/128 of the speed is left */
#define PEAK_SPEED 1.875f         /* of minimum jerk, over its mean: at the middle */
#define PEAK_ACCELERATION 5.7736f /* of minimum jerk over distance / time^2: 10 / sqrt(3), rounded up */
#define MIN_FALL_TIME 1e-3f       /* s: a shorter fall is over within a frame all the same */
#define MAX_BACKWARDS 0.105f      /* maximum of s (1 - s)^3 on [0, 1], 27/256 rounded down */
#define SLOPE_STEP 1e-3f          /* of the duration, for the slope of the plan at its start */
#define SEARCH_STEPS 64           /* even steps over the keys … */
#define SEARCH_BISECTIONS 20      /* … and bisections of the step found */
#define MIN_PACE_SCALE 0.5f       /* keys that end this much farther than the plan do not suit it … */
#define MAX_PACE_SCALE 2.0f       /* … nor those that end this much nearer */

/* Minimum jerk from 0 to 1 (Flash and Hogan 1985). */
static float minimum_jerk(float s) {
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

/* ---- intent ---- */

static float range_of(const dm_joint* joint) {
    return joint->upper - joint->lower;
}

static const dmi_rules* rules_of(const dmi_released_part* part) {
    static const dmi_rules none = {0};
    return part->rules != NULL ? part->rules : &none;
}

/* Whether limits bound the part to both sides. */
static bool has_range(const dmi_released_part* part) {
    return dmi_joint_has_limits(part->joint) && !rules_of(part)->one_sided;
}

/* Returns the joint value that shares of a way are of: the range, where the part has one. */
static float unit_of(const dmi_released_part* part) {
    return dmi_joint_has_limits(part->joint) ? dmi_rules_range(rules_of(part), part->joint) : 1;
}

static bool is_limit(const dm_joint* joint, float value) {
    return value == joint->lower || value == joint->upper;
}

static bool rests_at_stop(const dm_joint* joint) {
    const float near = AT_STOP_SHARE * range_of(joint), rest = dmi_joint_clamp(joint, 0);
    return rest - joint->lower <= near || joint->upper - rest <= near;
}

float dmi_release_open_end(const dmi_released_part* part) {
    const dm_joint* joint = part->joint;
    const float rest = dmi_joint_clamp(joint, 0), pulled = part->value + LOOK_AHEAD * part->velocity - rest;
    const float side = part->side != 0 ? (float)part->side : pulled;
    if (side == 0 || rests_at_stop(joint)) return dmi_joint_open_end(joint);
    return side > 0 ? joint->upper : joint->lower;
}

bool dmi_release_is_open(const dmi_released_part* part) {
    const dm_joint* joint = part->joint;
    const float rest = dmi_joint_clamp(joint, 0), below = rest - joint->lower, above = joint->upper - rest;
    const bool both_sides = !rests_at_stop(joint);
    if (!has_range(part)) return fabsf(part->value - rest) > HALF_WAY * unit_of(part);
    const float way = both_sides ? (part->value < rest ? below : above) : dmi_fmaxf(below, above);
    return fabsf(part->value - rest) > HALF_WAY * way;
}

/* Returns the distance that exponentially decaying velocity covers. */
static float glide_length(const dmi_released_part* part) {
    return part->velocity * dmi_feel_coast_time(part->feel) / DMI_LN_2_F;
}

/* Whether a snap value catches the part as it glides to a stop. */
static bool is_caught(const dmi_released_part* part, float* out_snap) {
    const float end = dmi_joint_clamp(part->joint, part->value + glide_length(part));
    return dmi_snaps_catch(&rules_of(part)->snaps, part->joint, end, out_snap);
}

/* Whether the part glides against a limit that throws it back. */
static bool is_thrown_back(const dmi_released_part* part) {
    const float end = part->value + glide_length(part);
    float snap;
    return rules_of(part)->restitution > 0 && has_range(part) && dmi_joint_clamp(part->joint, end) != end &&
           !is_caught(part, &snap);
}

/* Whether the part falls, to rest or to its open end. */
static bool falls(const dmi_released_part* part) {
    return rules_of(part)->tip_share > 0 && has_range(part);
}

/* Whether the part closes by itself from where it is. */
static bool closes_itself(const dmi_released_part* part) {
    return dmi_rules_share(rules_of(part), part->joint, part->value) < rules_of(part)->auto_close_share;
}

/* Returns the intent by the part's rules; DM_INTENT_AUTO: they say nothing. */
static int32_t intent_by_rules(const dmi_released_part* part, float return_time) {
    const dmi_rules* rules = rules_of(part);
    float snap;
    if (!rules->on) return DM_INTENT_AUTO;
    if (return_time > 0 && rules->close_delay > 0) return DM_INTENT_STAY;
    if (return_time > 0) return DM_INTENT_CLOSE;
    if (closes_itself(part)) return DM_INTENT_CLOSE;
    if (is_caught(part, &snap)) return DM_INTENT_STAY;
    if (falls(part))
        return dmi_rules_share(rules, part->joint, part->value) < rules->tip_share ? DM_INTENT_CLOSE : DM_INTENT_OPEN;
    return is_thrown_back(part) ? DM_INTENT_STAY : DM_INTENT_AUTO;
}

/* Returns the intent that DM_INTENT_AUTO stands for. */
static int32_t infer_intent(const dmi_released_part* part, float return_time) {
    const dm_joint* joint = part->joint;
    const int32_t ruled = intent_by_rules(part, return_time);
    if (ruled != DM_INTENT_AUTO) return ruled;
    if (return_time > 0) return DM_INTENT_CLOSE;
    if (!has_range(part) || part->feel->detent > 0) return DM_INTENT_STAY;
    const float range = range_of(joint), thrown = LOOK_AHEAD * part->velocity, ahead = part->value + thrown;
    const float from_rest = fabsf(ahead - dmi_joint_clamp(joint, 0));
    const bool homeward = part->velocity * (dmi_joint_clamp(joint, 0) - part->value) >= 0;
    if (rests_at_stop(joint) && (from_rest < NEAR_END_SHARE * range || dmi_joint_clamp(joint, ahead) != ahead) &&
        homeward) {
        return DM_INTENT_CLOSE;
    }
    if (rests_at_stop(joint) && homeward && fabsf(thrown) > THROWN_SHARE * range) return DM_INTENT_CLOSE;
    if (fabsf(thrown) > THROWN_SHARE * range) return DM_INTENT_OPEN;
    if (fabsf(ahead - dmi_release_open_end(part)) < NEAR_END_SHARE * range) return DM_INTENT_OPEN;
    return DM_INTENT_STAY;
}

/* ---- plan ---- */

/* Returns the least duration of a motion over `distance` that the rules allow. */
static float shortest_duration(const dmi_released_part* part, float distance) {
    float time = 0;
    const float speed = rules_of(part)->max_speed, acceleration = rules_of(part)->max_acceleration;
    if (speed > 0) time = PEAK_SPEED * fabsf(distance) / speed;
    return acceleration > 0 ? dmi_fmaxf(time, sqrtf(PEAK_ACCELERATION * fabsf(distance) / acceleration)) : time;
}

/* Returns the duration of a motion over `distance`: by the share of the range, and not slower than the part already
 * goes. */
static float natural_duration(const dmi_released_part* part, float distance) {
    const float speed = fabsf(part->velocity);
    const float share = dmi_joint_has_limits(part->joint) ? dmi_fminf(fabsf(distance) / unit_of(part), 1) : 1;
    float time = FULL_RANGE_TIME * sqrtf(share);
    if (part->velocity * distance > 0) time = dmi_fminf(time, 2 * fabsf(distance) / speed);
    return dmi_fmaxf(dmi_fmaxf(time, MIN_DURATION), shortest_duration(part, distance));
}

/* Glides to a stop or to a limit; with detents or snap values, moves on to the nearest one instead. */
static void plan_stay(const dmi_released_part* part, dmi_release* r) {
    const float end = dmi_joint_clamp(part->joint, part->value + glide_length(part));
    r->end = dmi_feel_nearest_detent(part->feel, part->joint, end);
    is_caught(part, &r->end);
    r->duration = GLIDE_HALF_LIVES * dmi_feel_coast_time(part->feel);
    r->glides = r->end == end;
    if (!r->glides) r->duration = natural_duration(part, r->end - r->start);
    if (fabsf(r->end - r->start) <= ARRIVED_SHARE * unit_of(part)) r->duration = 0;
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
    if (fabsf(distance) <= ARRIVED_SHARE * unit_of(part)) r->duration = 0;
}

/* A fall that does not end at a limit ends without a bounce: nothing is there that throws the part back. */
static dmi_flight flight_of(const dmi_release* r, const dmi_released_part* part) {
    dmi_flight flight = {.lower = part->joint->lower,
                         .upper = part->joint->upper,
                         .acceleration = r->acceleration,
                         .time_constant = dmi_feel_coast_time(part->feel) / DMI_LN_2_F,
                         .restitution = rules_of(part)->restitution};
    if (r->acceleration == 0 || is_limit(part->joint, r->end)) return flight;
    if (r->acceleration < 0) flight.lower = r->end;
    if (r->acceleration > 0) flight.upper = r->end;
    flight.restitution = 0;
    return flight;
}

/* Makes a glide that a limit throws back, or a fall, of the plan. */
static void plan_flight(const dmi_released_part* part, dmi_release* r, bool by_itself) {
    const float side = r->end < r->start ? -1.0f : 1.0f, time = dmi_fmaxf(rules_of(part)->fall_time, MIN_FALL_TIME);
    r->acceleration = 0;
    if (r->intent == DM_INTENT_STAY && r->glides && is_thrown_back(part)) {
        const dmi_flight flight = flight_of(r, part);
        r->flies = flight.time_constant > 0;
        r->end = dmi_flight_end(&flight, r->start, part->velocity);
    } else if (by_itself && r->duration > 0 && falls(part)) {
        r->flies = true;
        r->acceleration = side * 2 * range_of(part->joint) / (time * time);
        r->duration = sqrtf(2 * (r->end - r->start) / r->acceleration);
    }
}

dmi_landing dmi_release_fly(dmi_release* r, const dmi_released_part* part, float dt, float* out_value,
                            float* out_velocity) {
    const dmi_flight flight = flight_of(r, part);
    dmi_landing landing = dmi_flight_advance(&flight, dt, out_value, out_velocity);
    if (flight.lower != part->joint->lower || flight.upper != part->joint->upper) landing.struck = 0; /* rest is none */
    r->elapsed += dt;
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
    const int32_t asked = intent == DM_INTENT_AUTO ? infer_intent(part, r->return_time) : intent;
    r->intent = asked;
    r->start = r->end = part->value;
    r->velocity = part->velocity;
    r->paced = r->glides = r->flies = false;
    r->duration = 0;
    const bool unlimited = !dmi_joint_has_limits(part->joint);
    if (asked == DM_INTENT_CLOSE)
        plan_move(part, r, dmi_joint_clamp(part->joint, 0));
    else if (asked == DM_INTENT_OPEN && !unlimited)
        plan_move(part, r, dmi_release_open_end(part));
    else if (asked != DM_INTENT_FREEZE)
        r->intent = DM_INTENT_STAY, plan_stay(part, r);
    if (intent == DM_INTENT_AUTO && asked == DM_INTENT_CLOSE && r->duration > 0 && closes_itself(part))
        r->duration = dmi_fmaxf(rules_of(part)->auto_close_time, shortest_duration(part, r->end - r->start));
    else if (rules_of(part)->on)
        plan_flight(part, r, intent == DM_INTENT_AUTO && r->return_time <= 0 && asked != DM_INTENT_STAY);
    if (duration > 0 && r->duration > 0) {
        r->duration = duration; /* a glide and a fall take the time that they take */
        r->glides = r->flies = false;
    }
    if (!r->glides && r->duration > 0 && !unlimited) r->velocity = velocity_with_room(part, r);
    if (r->duration > 0) return;
    r->velocity = 0;
    r->phase = DM_DRAG_AT_REST;
}

/* ---- pace of a generated motion ---- */

static float value_on_keys(const dmi_release* r, float t) {
    dmi_motion motion = {0};
    memcpy(motion.values, r->keys, sizeof motion.values);
    return dmi_motion_value(&motion, t);
}

/* Returns the time, 0 to 1, at which the keys first reach a value on their way outwards. */
static float time_on_keys(const dmi_release* r, float value) {
    const float outer = r->keys[DM_MOTION_FRAMES - 1];
    float low = 0, high = 1;
    for (int i = 1; i <= SEARCH_STEPS; i++) {
        high = (float)i / SEARCH_STEPS;
        if (value_on_keys(r, high) / outer >= value / outer) break;
        low = high;
    }
    for (int i = 0; i < SEARCH_BISECTIONS; i++) {
        const float middle = 0.5f * (low + high);
        if (value_on_keys(r, middle) / outer >= value / outer)
            high = middle;
        else
            low = middle;
    }
    return 0.5f * (low + high);
}

bool dmi_release_set_pace(dmi_release* r, const float values[DM_MOTION_FRAMES]) {
    const bool outwards = fabsf(r->end) > fabsf(r->start);
    const float outer = outwards ? r->end : r->start, inner = outwards ? r->start : r->end;
    const float last = values[DM_MOTION_FRAMES - 1], scale = outer / last;
    if (r->phase != DM_DRAG_RELEASED || r->glides || r->flies || !(scale > MIN_PACE_SCALE && scale < MAX_PACE_SCALE))
        return false;
    if (inner / outer < 0) return false; /* the plan crosses rest; generated motions begin there */
    for (int i = 0; i < DM_MOTION_FRAMES; i++) r->keys[i] = values[i] * scale;
    r->first = outwards ? time_on_keys(r, inner) : 1;
    r->last = outwards ? 1 : time_on_keys(r, inner);
    r->paced = r->first != r->last;
    return r->paced;
}

/* ---- motion ---- */

/* Returns the planned value at a share of the duration, without regard to the initial velocity. */
static float planned(const dmi_release* r, float s) {
    if (!r->paced) return r->start + (r->end - r->start) * minimum_jerk(s);
    const float t = r->first + (r->last - r->first) * s;
    return value_on_keys(r, t);
}

/* Adds to the plan what value and velocity differ from it at the start, fading: s (1 - s)^3 has slope 1 at 0, and (1 +
 * 3 s) (1 - s)^3 has value 1 and slope 0 there. */
static float move_at(const dmi_release* r, float s) {
    const float h = SLOPE_STEP, left = 1 - s, fade = left * left * left;
    const float off = r->start - planned(r, 0), slope = (planned(r, h) - planned(r, 0)) / h;
    const float speed = r->velocity * r->duration - slope;
    return planned(r, s) + fade * ((1 + 3 * s) * off + s * speed);
}

static float glide_at(const dmi_release* r, const dm_drag_feel* feel) {
    const float time_constant = dmi_feel_coast_time(feel) / DMI_LN_2_F;
    return r->start + r->velocity * time_constant * (1 - dmi_expf(-r->elapsed / time_constant));
}

void dmi_release_advance(dmi_release* r, const dm_drag_feel* feel, const dm_joint* joint, float dt, float* out_value,
                         float* out_velocity) {
    const float old = *out_value;
    r->elapsed += dt;
    if (r->elapsed >= r->duration) {
        *out_value = r->end, *out_velocity = 0;
        r->phase = DM_DRAG_AT_REST;
        return;
    }
    const float value = r->glides ? glide_at(r, feel) : move_at(r, r->elapsed / r->duration);
    *out_value = dmi_joint_clamp(joint, value);
    const float velocity = (*out_value - old) / dt;
    if (dt > 0 && isfinite(velocity)) *out_velocity = velocity;
}
