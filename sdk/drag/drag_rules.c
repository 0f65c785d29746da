/* Defaults of dm_drag_rules; steps with a highest speed and acceleration in closed form, and an exponential approach to
 * a bound, which both give the same way at any frame rate; a lock, and a latch with hysteresis. */
#include "drag/drag_rules.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* The values are set by hand, and documented at dm_drag_rules. */
#define DEFAULT_OPEN_SHARE 0.1f    /* share of the range */
#define DEFAULT_CLOSED_SHARE 0.02f /* share of the range */
#define DEFAULT_LOCK_GIVE 0.01f    /* share of the range */
#define DEFAULT_LATCH_TURN 0.785f  /* rad: 45 degrees */
#define DEFAULT_AUTO_CLOSE 0.25f   /* s */
#define DEFAULT_FALL_TIME 0.7f     /* s, as long as a planned motion over the whole range */
#define OUTER_REACH 0.05f          /* share of the range that an outermost snap value reaches */

float dmi_rules_range(const dmi_rules* rules, const dm_joint* joint) {
    if (dmi_joint_has_limits(joint) && !rules->one_sided) return joint->upper - joint->lower;
    return dmi_joint_turns(joint->type) ? 1 : rules->object_size;
}

float dmi_rules_share(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_closed(joint)) / dmi_rules_range(rules, joint);
}

float dmi_rules_share_from_rest(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_clamp(joint, 0)) / dmi_rules_range(rules, joint);
}

/* Returns `given`, or the default when it is 0. */
static float given_or(float given, float otherwise) {
    return given != 0 ? given : otherwise;
}

static dmi_snaps snaps_from(const dm_drag_rules* given, float pull, float range) {
    dmi_snaps snaps = {.count = given->snap_count, .reach = given->snap_reach, .pull = pull};
    for (uint32_t i = 0; i < snaps.count; i++) snaps.values[i] = given->snaps[i];
    snaps.outer_reach = snaps.reach > 0 ? snaps.reach : OUTER_REACH * range;
    return snaps;
}

dmi_rules dmi_rules_from(const dm_drag_rules* given, const dm_drag_feel* feel, const dm_joint* joint, bool one_sided,
                         float object_size) {
    dmi_rules rules = {.on = true,
                       .flags = given->flags,
                       .one_sided = one_sided,
                       .object_size = object_size,
                       .open_share = given_or(given->open_share, DEFAULT_OPEN_SHARE),
                       .closed_share = given_or(given->closed_share, DEFAULT_CLOSED_SHARE),
                       .event_time = given->event_time,
                       .max_speed = given->max_speed,
                       .max_acceleration = given->max_acceleration,
                       .lock_give = dmi_fmaxf(given_or(given->lock_give, DEFAULT_LOCK_GIVE), 0),
                       .latch_turn = given_or(given->latch_turn, DEFAULT_LATCH_TURN),
                       .auto_close_share = given->auto_close_share,
                       .auto_close_time = given_or(given->auto_close_time, DEFAULT_AUTO_CLOSE),
                       .close_delay = given->close_delay,
                       .tip_share = given->tip_share,
                       .fall_time = given_or(given->fall_time, DEFAULT_FALL_TIME),
                       .restitution = given->restitution,
                       .break_distance = given->break_distance,
                       .drive_speed = given_or(given->drive_speed, 1)};
    rules.snaps = snaps_from(given, dmi_feel_detent_pull(feel), dmi_rules_range(&rules, joint));
    return rules;
}

/* ---- how far a part gets in one update ---- */

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

/* ---- lock and latch ---- */

/* The values are set by hand. */
#define CATCH_SHARE 0.01f /* share of the range from where the part is closed; the latch catches the part within it */
#define LET_GO 0.8f       /* share of the turn that opens the latch; a handle below it has been let go */
#define TRIED 2.0f        /* multiple of what is given; a hand that asks for more tries the part … */
#define LET_UP 1.0f       /* … and a hand that asks for less has let up */

static bool is_shut(const dmi_rules* rules, const dm_joint* joint, float value) {
    return fabsf(value - dmi_joint_closed(joint)) <= CATCH_SHARE * dmi_rules_range(rules, joint);
}

dmi_latch dmi_latch_begin(const dmi_rules* rules, const dm_joint* joint, float value) {
    return (dmi_latch){.closed = rules->flags & DM_RULE_LATCH && is_shut(rules, joint, value)};
}

static void update_lock(dmi_latch* latch, float value, bool locked) {
    if (locked && !latch->locked) latch->at = value;
    latch->locked = locked;
}

uint32_t dmi_latch_update(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float value, bool locked,
                          const float handles[2]) {
    const float turn = dmi_fmaxf(fabsf(handles[0]), fabsf(handles[1])), shut = dmi_joint_closed(joint);
    uint32_t events = 0;
    latch->turned = turn >= (latch->turned ? LET_GO : 1) * rules->latch_turn;
    if (latch->closed && latch->turned) {
        latch->closed = false;
        events = DM_EVENT_UNLATCHED;
    } else if (rules->flags & DM_RULE_LATCH && !latch->closed && !latch->turned && is_shut(rules, joint, value)) {
        latch->closed = true;
        events = DM_EVENT_LATCHED;
    }
    update_lock(latch, latch->closed ? shut : value, locked || rules->flags & DM_RULE_LOCKED);
    if (latch->closed) latch->at = shut;
    return events;
}

/* Returns how far a held part gives at most, joint value. */
static float most_given(const dmi_rules* rules, const dm_joint* joint) {
    return rules->lock_give * dmi_rules_range(rules, joint);
}

float dmi_latch_give(const dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked) {
    const float most = most_given(rules, joint), off = asked - latch->at;
    return most > 0 ? latch->at + most * off / (most + fabsf(off)) : latch->at;
}

uint32_t dmi_latch_try(dmi_latch* latch, const dmi_rules* rules, const dm_joint* joint, float asked) {
    const bool was = latch->tried;
    const float threshold = dmi_fmaxf(most_given(rules, joint), CATCH_SHARE * dmi_rules_range(rules, joint));
    const float off = fabsf(asked - latch->at);
    latch->tried = dmi_latch_holds(latch) && off > (was ? LET_UP : TRIED) * threshold;
    return latch->tried && !was ? DM_EVENT_LOCKED : 0;
}
