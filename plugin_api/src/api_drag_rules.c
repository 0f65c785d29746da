/* Checks of what a host asks of a dragged part besides following the hand: rules and inputs. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_drag.h"
#include "math/vec3.h"

typedef struct number {
    const char* name;
    float value, most;
} number;

/* Checks that numbers are finite and 0 to their most. */
static dm_result check_numbers(dmi_env* env, const number* numbers, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const number* n = &numbers[i];
        if (n->value >= 0 && n->value <= n->most) continue;
        return dmi_fail(env, isfinite(n->value) ? DM_ERROR_INVALID_ARGUMENT : DM_ERROR_NOT_FINITE,
                        "dm_drag_begin: desc.rules.%s is %g: it must be 0 to %g", n->name, (double)n->value,
                        (double)n->most);
    }
    return DM_OK;
}

static dm_result check_snaps(dmi_env* env, const dm_drag_rules* rules) {
    if (rules->snap_count > DM_MAX_SNAPS || (rules->snap_count > 0 && rules->snaps == NULL)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_drag_begin: desc.rules.snap_count is %u: it must be 0 to %d, and the size of snaps",
                        rules->snap_count, DM_MAX_SNAPS);
    }
    for (uint32_t i = 0; i < rules->snap_count; i++) {
        dm_result result = dmi_check_number(env, "dm_drag_begin: desc.rules", ".snaps[]", rules->snaps[i]);
        if (result != DM_OK) return result;
        if (i == 0 || rules->snaps[i - 1] < rules->snaps[i]) continue;
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_begin: desc.rules.snaps[%u] is %g: they must rise", i,
                        (double)rules->snaps[i]);
    }
    return DM_OK;
}

static dm_result check_rules(dmi_env* env, const dm_drag_rules* rules, const dm_drag_feel* feel) {
    const number numbers[] = {{"snap_reach", rules->snap_reach, DMI_LARGEST},
                              {"open_share", rules->open_share, 1},
                              {"closed_share", rules->closed_share, 1},
                              {"event_time", rules->event_time, DMI_LARGEST_TIME},
                              {"max_speed", rules->max_speed, DMI_LARGEST_RATE},
                              {"max_acceleration", rules->max_acceleration, DMI_LARGEST_RATE},
                              {"latch_turn", rules->latch_turn, DMI_LARGEST},
                              {"auto_close_share", rules->auto_close_share, 1},
                              {"auto_close_time", rules->auto_close_time, DMI_LARGEST_TIME},
                              {"close_delay", rules->close_delay, DMI_LARGEST_TIME},
                              {"tip_share", rules->tip_share, 1},
                              {"fall_time", rules->fall_time, DMI_LARGEST_TIME},
                              {"restitution", rules->restitution, 1},
                              {"break_distance", rules->break_distance, DMI_LARGEST},
                              {"drive_speed", rules->drive_speed, DMI_LARGEST_RATE}};
    dm_result result = check_numbers(env, numbers, sizeof numbers / sizeof *numbers);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_begin: desc.rules.lock_give", &rules->lock_give, 1);
    if (result == DM_OK && rules->lock_give > 1)
        result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                          "dm_drag_begin: desc.rules.lock_give is %g: it must be 1 or less", (double)rules->lock_give);
    if (result == DM_OK) result = check_snaps(env, rules);
    if (result == DM_OK && (rules->flags & ~(uint32_t)(DM_RULE_LOCKED | DM_RULE_LATCH) || rules->reserved != 0)) {
        result = dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                          "dm_drag_begin: desc.rules.flags is 0x%x, reserved %u: unknown flag, or not 0", rules->flags,
                          rules->reserved);
    }
    if (result != DM_OK || rules->snap_count == 0 || !(feel->detent > 0)) return result;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_drag_begin: desc.rules.snap_count and desc.feel.detent are "
                    "both set: a part has one or the other");
}

dm_result dmi_rules_read(dmi_env* env, const dm_drag_desc* desc, const dmi_rules_start* start, dmi_rules* out) {
    dm_drag_rules given;
    *out = (dmi_rules){.one_sided = start->one_sided, .object_size = start->object_size};
    if (desc->rules == NULL) return DM_OK;
    dm_result result = dmi_read_desc(env, "dm_drag_begin: desc.rules", desc->rules,
                                     DMI_FIRST_SIZE(dm_drag_rules, reserved), sizeof given, &given);
    if (result == DM_OK) result = check_rules(env, &given, &desc->feel);
    if (result != DM_OK) return result;
    *out = dmi_rules_from(&given, &desc->feel, start->joint, start->one_sided, start->object_size);
    if (out->closed_share < out->open_share) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_drag_begin: desc.rules.closed_share is %g: it must be less than open_share, %g",
                    (double)out->closed_share, (double)out->open_share);
}

static bool is_within(float value, float least, float most) {
    return value >= least && value <= most;
}

bool dmi_is_sound_rules(const dmi_rules* r) {
    const dmi_snaps* s = &r->snaps;
    if (!is_within(r->object_size, 0, DMI_LARGEST)) return false;
    if (!r->on) return s->count == 0;
    if (s->count > DM_MAX_SNAPS || !is_within(s->pull, 0, 1) || !is_within(s->reach, 0, DMI_LARGEST)) return false;
    for (uint32_t i = 0; i < s->count; i++) {
        if (!is_within(s->values[i], -DMI_LARGEST, DMI_LARGEST)) return false;
        if (i > 0 && !(s->values[i - 1] < s->values[i])) return false;
    }
    return is_within(s->outer_reach, 0, DMI_LARGEST) && is_within(r->open_share, 0, 1) &&
           is_within(r->closed_share, 0, r->open_share) && is_within(r->event_time, 0, DMI_LARGEST_TIME) &&
           is_within(r->max_speed, 0, DMI_LARGEST_RATE) && is_within(r->max_acceleration, 0, DMI_LARGEST_RATE) &&
           is_within(r->lock_give, 0, 1) && is_within(r->latch_turn, 0, DMI_LARGEST) &&
           is_within(r->auto_close_share, 0, 1) && is_within(r->auto_close_time, 0, DMI_LARGEST_TIME) &&
           is_within(r->close_delay, 0, DMI_LARGEST_TIME) && is_within(r->tip_share, 0, 1) &&
           is_within(r->fall_time, 0, DMI_LARGEST_TIME) && is_within(r->restitution, 0, 1) &&
           is_within(r->break_distance, 0, DMI_LARGEST) && is_within(r->drive_speed, 0, DMI_LARGEST_RATE);
}

/* ---- inputs ---- */

static dm_result check_bounds(dmi_env* env, const dm_drag_input* input) {
    if (input->lower < input->upper || (input->lower == input->upper && isfinite(input->lower))) return DM_OK;
    const bool numbers = !isnan(input->lower) && !isnan(input->upper);
    return dmi_fail(env, numbers ? DM_ERROR_INVALID_ARGUMENT : DM_ERROR_NOT_FINITE,
                    "dm_drag_step: input.lower is %g, input.upper %g: they must rise", (double)input->lower,
                    (double)input->upper);
}

/* Whether an input says what only rules read. */
static bool needs_rules(const dm_drag_input* input) {
    return input->lower != input->upper || input->flags & (DM_INPUT_LOCKED | DM_INPUT_BOUNDS) ||
           input->handles[0] != 0 || input->handles[1] != 0;
}

static dm_result check_point(dmi_env* env, const char* what, dm_vec3 point) {
    static const char* const fields[3] = {".x", ".y", ".z"};
    return dmi_check_vector(env, what, fields, dmi_xyz(point).v);
}

static dm_result check_first(dmi_env* env, const dm_hand* hand) {
    dm_result result = dmi_check_range(env, "dm_drag_step: input.hand.kind", hand->kind, DM_HAND_NONE, DM_HAND_VALUE);
    if (result != DM_OK) return result;
    if (hand->kind == DM_HAND_RAY) return dmi_check_ray(env, "dm_drag_step: input.hand.ray", &hand->ray);
    if (hand->kind == DM_HAND_POINT) return check_point(env, "dm_drag_step: input.hand.point", hand->point);
    if (hand->kind > DM_HAND_POINT) return dmi_check_number(env, "dm_drag_step: input.hand", ".amount", hand->amount);
    return DM_OK;
}

static dm_result check_second(dmi_env* env, const dm_drag_input* input) {
    const dm_hand* hand = &input->second;
    if (hand->kind == DM_HAND_NONE) return DM_OK;
    dm_result result = dmi_check_range(env, "dm_drag_step: input.second.kind", hand->kind, DM_HAND_NONE, DM_HAND_POINT);
    if (result == DM_OK && input->hand.kind > DM_HAND_POINT)
        result =
            dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                     "dm_drag_step: input.second is set, but input.hand.kind is %d: two hands hold by ray or point",
                     input->hand.kind);
    if (result == DM_OK) result = check_point(env, "dm_drag_step: input.second.grab_point", hand->grab_point);
    if (result != DM_OK) return result;
    if (hand->kind == DM_HAND_RAY) return dmi_check_ray(env, "dm_drag_step: input.second.ray", &hand->ray);
    return check_point(env, "dm_drag_step: input.second.point", hand->point);
}

dm_result dmi_input_read(dmi_env* env, const dmi_drag* drag, const dm_drag_input* input, dm_drag_input* out) {
    dm_result result =
        dmi_read_desc(env, "dm_drag_step: input", input, DMI_FIRST_SIZE(dm_drag_input, upper), sizeof *out, out);
    if (result == DM_OK && out->flags & ~(uint32_t)(DM_INPUT_LOCKED | DM_INPUT_ASK | DM_INPUT_BOUNDS))
        result =
            dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_step: input.flags is 0x%x: unknown flag", out->flags);
    if (result == DM_OK) result = check_first(env, &out->hand);
    if (result == DM_OK) result = check_second(env, out);
    if (result == DM_OK) result = dmi_check_finite(env, "dm_drag_step: input.handles", out->handles, 2);
    if (result == DM_OK) result = check_bounds(env, out);
    if (result != DM_OK || drag->rules.on || !needs_rules(out)) return result;
    return dmi_fail(
        env, DM_ERROR_INVALID_ARGUMENT,
        "dm_drag_step: input has bounds, handles or DM_INPUT_LOCKED, but the drag began without desc.rules");
}
