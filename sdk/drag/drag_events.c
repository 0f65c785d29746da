/* Each state has a threshold to enter it and one to leave it. */
#include "drag/drag_events.h"

#include <math.h>

#include "math/elementary.h"

/* The values are set by hand, and documented at DM_EVENT_*. */
#define NEAR_SHARE 0.005f /* share of the range; within it a part is at a limit or at rest */
#define FAR_SHARE 0.02f   /* share of the range; beyond it a part is away from the limit or from rest */
#define RIDGE 0.55f /* share of the way to the next detent; beyond it the part has passed the ridge between both */
/* Half-life of the peak speed, s: a part that comes softly to a stop was as fast as this long before. */
#define PEAK_HALF_LIFE 0.1f
#define MAX_DETENTS 1000000.0f /* most detents counted in one update, so that a float holds their number */

/* Returns the limit that the value is at, given the one that it was at. */
static int32_t limit_at(const dmi_event_input* now, int32_t was) {
    if (!dmi_joint_has_limits(now->joint)) return 0;
    const float range = dmi_rules_range(now->rules, now->joint);
    const float to_upper = now->joint->upper - now->value, to_lower = now->value - now->joint->lower;
    if (!now->beyond_upper && to_upper <= (was > 0 ? FAR_SHARE : NEAR_SHARE) * range) return 1;
    return !now->beyond_lower && to_lower <= (was < 0 ? FAR_SHARE : NEAR_SHARE) * range ? -1 : 0;
}

static float share_from_rest(const dmi_event_input* now) {
    return dmi_rules_share_from_rest(now->rules, now->joint, now->value);
}

static float share_open(const dmi_event_input* now) {
    return dmi_rules_share(now->rules, now->joint, now->value);
}

/* Returns where the value lies among the detents or snap values, whose places are the integers. */
static float place_of(const dmi_event_input* now) {
    if (now->rules->snaps.count > 0) return dmi_snaps_place(&now->rules->snaps, now->value);
    return now->feel->detent > 0 ? (now->value - dmi_joint_closed(now->joint)) / now->feel->detent : 0;
}

dmi_event_state dmi_event_state_begin(const dmi_event_input* now) {
    dmi_event_state state = {.blocked = now->blocked, .changes = now->changes, .since_opening = INFINITY};
    state.limit = limit_at(now, 0);
    state.away = share_from_rest(now) > NEAR_SHARE;
    state.open = share_open(now) > now->rules->closed_share;
    state.catch_index = roundf(place_of(now));
    return state;
}

static void find_limit_events(dmi_event_state* state, const dmi_event_input* now) {
    const int32_t was = state->limit;
    state->limit = limit_at(now, now->struck != 0 ? now->struck : was);
    /* A part that has met a limit may have left it within the same update. */
    const int32_t met = now->struck != 0 && was != now->struck ? now->struck : state->limit;
    if (met == was || met == 0) return;
    state->events |= met > 0 ? DM_EVENT_LIMIT_UPPER : DM_EVENT_LIMIT_LOWER;
    state->impact = dmi_fmaxf(state->peak_speed, now->impact);
}

static void find_rest_events(dmi_event_state* state, const dmi_event_input* now) {
    const float share = share_from_rest(now);
    const bool was_away = state->away;
    state->away = share > (was_away ? NEAR_SHARE : FAR_SHARE);
    if (state->away != was_away) state->events |= was_away ? DM_EVENT_REACHED_REST : DM_EVENT_LEFT_REST;
    const bool open = share_open(now) > (state->open ? now->rules->closed_share : now->rules->open_share);
    if (open == state->open || state->since_opening < now->rules->event_time) return;
    state->open = open;
    state->since_opening = 0;
    state->events |= open ? DM_EVENT_OPENED : DM_EVENT_CLOSED;
}

/* Finds the limit that a bounce has met within the update, wherever the part is by its end. */
static void find_bounce_events(dmi_event_state* state, const dmi_event_input* now) {
    dmi_event_input there = *now;
    if (now->struck == 0) return;
    there.value = now->struck > 0 ? now->joint->upper : now->joint->lower;
    find_rest_events(state, &there);
}

static void find_detent_events(dmi_event_state* state, const dmi_event_input* now) {
    const float place = place_of(now);
    if (now->changes != state->changes)
        state->catch_index = roundf(place); /* the detents are another joint's, so none was crossed */
    if (!(fabsf(place - state->catch_index) > RIDGE)) return;
    const float was = state->catch_index, is = roundf(place), snaps = (float)now->rules->snaps.count;
    const float first = snaps > 0 ? 0 : -INFINITY,
                last = snaps > 0 ? snaps - 1 : INFINITY; /* there are no places beyond these */
    const float passed =
        is > was ? dmi_fminf(is, last) - dmi_fmaxf(was, first - 1) : dmi_fminf(was, last + 1) - dmi_fmaxf(is, first);
    state->catch_index = is;
    state->detents = (uint32_t)dmi_fminf(dmi_fmaxf(passed, 0), MAX_DETENTS);
    if (state->detents > 0) state->events |= DM_EVENT_DETENT;
}

static void find_bound_events(dmi_event_state* state, const dmi_event_input* now) {
    if (now->blocked == state->blocked) return;
    state->blocked = now->blocked;
    state->events |= now->blocked ? DM_EVENT_BLOCKED : DM_EVENT_FREED;
    if (now->blocked) state->impact = state->peak_speed;
}

void dmi_event_state_update(dmi_event_state* state, const dmi_event_input* now, float dt) {
    state->events = state->detents = 0;
    state->impact = 0;
    state->since_opening += dt;
    state->peak_speed = dmi_fmaxf(fabsf(now->velocity), state->peak_speed * dmi_exp2f(-dt / PEAK_HALF_LIFE));
    find_limit_events(state, now);
    find_bounce_events(state, now);
    find_rest_events(state, now);
    find_detent_events(state, now);
    find_bound_events(state, now);
    state->events |= now->others;
    if (now->changes != state->changes) state->events |= DM_EVENT_JOINT;
    state->changes = now->changes;
}
