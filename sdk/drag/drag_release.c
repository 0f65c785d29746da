/* A part that is let go: what the plan of its release does, update by update, and what its rules add. */
#include "drag/drag_internal.h"
#include "math/elementary.h"

static dmi_released_part released_part(const dmi_drag* drag) {
    return (dmi_released_part){.joint = &drag->joint,
                               .feel = &drag->feel,
                               .rules = &drag->rules,
                               .value = drag->value,
                               .velocity = drag->velocity,
                               .side = drag->open_side};
}

bool dmi_drag_is_open(const dmi_drag* drag) {
    const dmi_released_part part = released_part(drag);
    return dmi_release_is_open(&part);
}

/* duration: s; 0: as long as it takes. */
static void plan(dmi_drag* drag, int32_t intent, float duration) {
    const dmi_released_part part = released_part(drag);
    dmi_release_begin(&drag->release, &part, intent, duration);
    if (intent != DM_INTENT_REPLAY) return;
    drag->value = drag->release.start;
    drag->velocity = drag->release.velocity;
}

/* Brings back a released part once its closer's delay is over, and one that has come near to rest. */
static void close_by_rules(dmi_drag* drag, float dt) {
    const dmi_rules* rules = &drag->rules;
    dmi_release* release = &drag->release;
    const bool waits = release->return_time > 0 && rules->close_delay > 0;
    drag->waited = dmi_fminf(drag->waited + dt, DMI_LARGEST_TIME);
    if (release->intent != DM_INTENT_STAY || drag->stays) return;
    if (waits && drag->waited < rules->close_delay) {
        release->phase = DM_DRAG_RELEASED;
        return;
    }
    const bool near = dmi_rules_share(rules, &drag->joint, drag->value) < rules->auto_close_share;
    if (waits || near) plan(drag, DM_INTENT_CLOSE, waits ? 0 : rules->auto_close_time);
}

/* Plans the rest of a motion that something has held up, in the time that it had left. */
static void plan_again(dmi_drag* drag) {
    dmi_release* release = &drag->release;
    const float left = release->duration - release->elapsed;
    plan(drag, release->intent, 0);
    if (release->phase == DM_DRAG_RELEASED && !release->flies && left > release->duration)
        plan(drag, release->intent, left);
}

void dmi_drag_update_released(dmi_drag* drag, float dt) {
    dmi_release* release = &drag->release;
    if (drag->stalled && !release->flies) plan_again(drag);
    drag->stalled = false;
    if (release->phase != DM_DRAG_RELEASED) return;
    const dmi_released_part part = released_part(drag);
    if (release->flies)
        drag->landing = dmi_release_fly(release, &part, dt, &drag->value, &drag->velocity);
    else
        dmi_release_advance(release, &drag->feel, &drag->joint, dt, &drag->value, &drag->velocity);
    if (drag->rules.on) close_by_rules(drag, dt);
    drag->asked = drag->target = release->end;
}

void dmi_drag_release(dmi_drag* drag, int32_t intent, float duration) {
    drag->stalled = drag->pending.open = false;
    drag->waited = 0;
    drag->stays = intent == DM_INTENT_STAY;
    plan(drag, intent, duration);
    if (drag->rules.on) close_by_rules(drag, 0);
    if (drag->release.phase == DM_DRAG_AT_REST) drag->velocity = 0;
}
