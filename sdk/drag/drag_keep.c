/* Applies the rules in an update, and reports its events and what holds the part. The rules act between what the hand
 * asks for and the feel, and after the step that the feel or the plan of a release has made. They are kept out of
 * drag.c, so that drags without rules do not pay for them. */
#include <math.h>

#include "drag/drag_internal.h"

#define ARRIVED_SHARE 1e-4f /* share of the range; a released part this near is where its plan ends */
#define SWING_BACK 0.02f /* range a second: a part in the hand that would come back slower than this stays; by hand */

/* ---- reports ---- */

static dmi_event_input event_input(const dmi_drag* drag, bool blocked) {
    return (dmi_event_input){.joint = &drag->joint,
                             .feel = &drag->feel,
                             .rules = &drag->rules,
                             .value = drag->value,
                             .velocity = drag->velocity,
                             .blocked = blocked,
                             .beyond_lower = drag->limits_are_estimates && drag->joint.lower < drag->estimated_lower,
                             .beyond_upper = drag->limits_are_estimates && drag->joint.upper > drag->estimated_upper,
                             .changes = drag->changes,
                             .struck = drag->landing.struck,
                             .impact = drag->landing.impact,
                             .others = drag->events};
}

/* Starts without an event, where the part is. */
static void begin_events(dmi_drag* drag) {
    const dmi_event_input now = event_input(drag, false);
    drag->event_state = dmi_event_state_begin(&now);
}

/* Finds what has happened in an update of dt seconds. */
static void find_events(dmi_drag* drag, float dt) {
    const float range = dmi_rules_range(&drag->rules, &drag->joint);
    const bool blocked =
        dmi_bounds_hold(drag->constraints.bounds, drag->value, drag->asked, range, drag->event_state.blocked);
    const dmi_event_input now = event_input(drag, blocked);
    dmi_event_state_update(&drag->event_state, &now, dt);
}

void dmi_drag_find_events_again(dmi_drag* drag) {
    const bool blocked = drag->event_state.blocked;
    drag->event_state = drag->pending.event_state;
    const dmi_event_input now = event_input(drag, blocked);
    dmi_event_state_update(&drag->event_state, &now, drag->pending.dt);
}

void dmi_drag_write_events(const dmi_drag* drag, dm_drag_state* out_state) {
    const dmi_event_state* state = &drag->event_state;
    out_state->events = state->events;
    out_state->detents = state->detents;
    out_state->impact = state->impact;
}

uint32_t dmi_drag_status(const dmi_drag* drag) {
    if (!drag->rules.on) return 0;
    const bool locked = drag->latch.locked || drag->rules.flags & DM_RULE_LOCKED;
    return (drag->latch.closed ? DM_STATUS_LATCHED : 0u) | (locked ? DM_STATUS_LOCKED : 0u) |
           (drag->event_state.blocked ? DM_STATUS_BLOCKED : 0u) | (drag->event_state.open ? DM_STATUS_OPEN : 0u);
}

/* ---- rules ---- */

void dmi_drag_set_rules(dmi_drag* drag, const dmi_rules* rules) {
    drag->rules = *rules;
    dmi_drag_measure_span(drag);
    drag->pointer_value = dmi_drag_pointer_value(drag, drag->target);
    drag->latch = dmi_latch_begin(rules, &drag->joint, drag->value);
    begin_events(drag);
}

void dmi_drag_note_start(dmi_drag* drag) {
    drag->start = (dmi_drag_step_start){drag->value, drag->velocity, drag->release.phase};
    drag->landing = (dmi_landing){0};
    drag->events = dmi_latch_update(&drag->latch, &drag->rules, &drag->joint, drag->value, drag->constraints.locked,
                                    drag->constraints.handles);
}

void dmi_drag_hold_back(dmi_drag* drag, float before, float dt) {
    float target = dmi_catch_up(drag->asked, before, drag->lag, dt);
    if (dmi_latch_holds(&drag->latch)) target = dmi_latch_give(&drag->latch, &drag->rules, &drag->joint, target);
    drag->target = dmi_joint_clamp(&drag->joint, dmi_bounds_clamp(drag->constraints.bounds, target));
    drag->lag = drag->target - drag->asked;
}

/* A heavy part in the hand comes back from a limit. */
static void swing_back(dmi_drag* drag) {
    const float range = dmi_rules_range(&drag->rules, &drag->joint), before = drag->start.velocity;
    const bool stopped = drag->feel.coast_time > 0 && drag->velocity == 0 && drag->start.phase == DM_DRAG_HELD &&
                         dmi_joint_has_limits(&drag->joint) &&
                         (drag->value == drag->joint.lower || drag->value == drag->joint.upper);
    const float back = -drag->rules.restitution * before;
    if (stopped && fabsf(back) > SWING_BACK * range) drag->velocity = back;
}

/* Bounds of this step: a part that is held and not in the hand goes back to where it is held, as far as there is room.
 */
static dmi_bounds step_bounds(const dmi_drag* drag) {
    if (!dmi_latch_holds(&drag->latch) || drag->start.phase == DM_DRAG_HELD) return drag->constraints.bounds;
    const float at = dmi_bounds_clamp(drag->constraints.bounds, drag->latch.at);
    return (dmi_bounds){at, at};
}

static void limit_step(dmi_drag* drag, float dt) {
    const bool limited = dmi_limit_step(&drag->rules, step_bounds(drag), drag->start.value, drag->start.velocity, dt,
                                        &drag->value, &drag->velocity);
    if (!limited) return;
    drag->value = dmi_joint_clamp(&drag->joint, drag->value);
    const float left = fabsf(drag->value - drag->release.end);
    if (drag->start.phase != DM_DRAG_RELEASED || left <= ARRIVED_SHARE * dmi_rules_range(&drag->rules, &drag->joint))
        return;
    drag->stalled = true;
    drag->release.phase = DM_DRAG_RELEASED;
}

/* Releases a part whose hand is too far off. */
static void break_off(dmi_drag* drag) {
    const float most = drag->rules.break_distance;
    if (!(most > 0) || drag->release.phase != DM_DRAG_HELD || dmi_drag_hand_miss(drag) <= most) return;
    dmi_drag_release(drag, DM_INTENT_AUTO, 0);
    drag->events |= DM_EVENT_LET_GO;
}

void dmi_drag_keep_rules(dmi_drag* drag, float dt) {
    if (drag->rules.restitution > 0) swing_back(drag);
    limit_step(drag, dt);
    drag->events |= dmi_latch_try(&drag->latch, &drag->rules, &drag->joint, drag->asked);
    break_off(drag);
    const bool stands = drag->value == drag->start.value && drag->changes == drag->event_state.changes;
    if (drag->release.phase == DM_DRAG_AT_REST && stands) drag->velocity = 0;
    find_events(drag, dt);
}
