/* The rules' part of an update: between what the hand asks for and the feel, and after the step that the feel or the
 * plan of a release has made. Apart from drag.c, so that drags without rules do not pay for it. */
#include "motion/drag_keep.h"

static dmi_watched watched(const dmi_drag* drag, bool blocked) {
    return (dmi_watched){.joint = &drag->joint,
                         .feel = &drag->feel,
                         .rules = &drag->rules,
                         .value = drag->value,
                         .velocity = drag->velocity,
                         .blocked = blocked,
                         .changes = drag->changes};
}

void dmi_drag_set_rules(dmi_drag* drag, const dmi_rules* rules) {
    drag->rules = *rules;
    drag->asked = drag->target;
    drag->pointer_value = dmi_snaps_invert(&rules->snaps, drag->pointer_value);
    const dmi_watched now = watched(drag, false);
    drag->watch = dmi_watch_begin(&now);
}

void dmi_drag_hold_back(dmi_drag* drag, float before, float dt) {
    const float free = dmi_catch_up(drag->asked, before, drag->lag, dt);
    drag->target = dmi_joint_clamp(&drag->joint, dmi_bounds_clamp(drag->bounds, free));
    drag->lag = drag->target - drag->asked;
}

void dmi_drag_keep_rules(dmi_drag* drag, float dt) {
    const dmi_drag_step_start* start = &drag->start;
    const bool changed = drag->changes != drag->watch.changes; /* then values are those of another joint */
    const bool limited = dmi_limit_step(&drag->rules, drag->bounds, changed ? drag->value : start->value,
                                        start->velocity, dt, &drag->value, &drag->velocity);
    if (limited) drag->value = dmi_joint_clamp(&drag->joint, drag->value);
    if (limited && start->phase == DM_DRAG_RELEASED) {
        drag->stalled = true;
        drag->release.phase = DM_DRAG_RELEASED;
    }
    const float range = dmi_rules_range(&drag->rules, &drag->joint);
    const bool blocked = dmi_bounds_hold(drag->bounds, drag->value, drag->asked, range, drag->watch.blocked);
    const dmi_watched now = watched(drag, blocked);
    dmi_watch_update(&drag->watch, &now, dt);
}

void dmi_drag_note_start(dmi_drag* drag) {
    drag->start = (dmi_drag_step_start){drag->value, drag->velocity, drag->release.phase};
}

void dmi_drag_write_events(const dmi_drag* drag, dm_drag_state* out_state) {
    const dmi_watch* watch = &drag->watch;
    out_state->events = watch->events;
    out_state->detents = watch->detents;
    out_state->impact = watch->impact;
}
