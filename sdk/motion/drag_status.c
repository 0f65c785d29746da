/* Reports of a drag with rules: the events of an update, and what holds the part. */
#include "motion/drag_internal.h"

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

void dmi_drag_begin_events(dmi_drag* drag) {
    const dmi_event_input now = event_input(drag, false);
    drag->event_state = dmi_event_state_begin(&now);
}

void dmi_drag_find_events(dmi_drag* drag, float dt) {
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
