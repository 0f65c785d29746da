/* Checks of what a host asks of a dragged part besides following the hand: rules and inputs. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_drag.h"
#include "math/linear3.h"

typedef struct number {
    const char* name;
    float value, most;
} number;

/* Checks that numbers are finite and between 0 and their maximum. */
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

static dm_result check_bounds(const dm_drag_input* input) {
    if (input->lower < input->upper || (input->lower == input->upper && isfinite(input->lower))) return DM_OK;
    return isnan(input->lower) || isnan(input->upper) ? DM_ERROR_NOT_FINITE : DM_ERROR_INVALID_ARGUMENT;
}

/* Returns whether an input has something that only rules read. */
static bool needs_rules(const dm_drag_input* input) {
    return input->lower != input->upper || input->flags & (DM_INPUT_LOCKED | DM_INPUT_BOUNDS) ||
           input->handles[0] != 0 || input->handles[1] != 0;
}

static dm_result check_point(dm_vec3 point) {
    static const char* const fields[3] = {".x", ".y", ".z"};
    return dmi_check_vector(DMI_SILENT, "point", fields, dmi_xyz(point).v);
}

static dm_result check_first(const dm_hand* hand) {
    switch (hand->kind) {
    case DM_HAND_NONE:
        return DM_OK;
    case DM_HAND_RAY:
        return dmi_check_ray(DMI_SILENT, "ray", &hand->ray);
    case DM_HAND_POINT:
        return check_point(hand->point);
    case DM_HAND_RATE:
    case DM_HAND_STEP:
    case DM_HAND_VALUE:
        return dmi_check_number(DMI_SILENT, "", "amount", hand->amount);
    default:
        return DM_ERROR_INVALID_ARGUMENT;
    }
}

/* Checks the second hand. Two hands hold by ray or point. */
static dm_result check_second(const dm_drag_input* input) {
    const dm_hand* hand = &input->second;
    if (hand->kind == DM_HAND_NONE) return DM_OK;
    if (hand->kind < DM_HAND_NONE || hand->kind > DM_HAND_POINT) return DM_ERROR_INVALID_ARGUMENT;
    if (input->hand.kind > DM_HAND_POINT) return DM_ERROR_INVALID_ARGUMENT;
    const dm_result result = check_point(hand->grab_point);
    return result != DM_OK ? result : check_first(hand);
}

dm_result dmi_input_read(const dmi_drag* drag, const dm_drag_input* input, dm_drag_input* out) {
    dm_result result =
        dmi_read_desc(DMI_SILENT, "input", input, DMI_FIRST_SIZE(dm_drag_input, upper), sizeof *out, out);
    if (result == DM_OK && out->flags & ~(uint32_t)(DM_INPUT_LOCKED | DM_INPUT_ASK | DM_INPUT_BOUNDS))
        result = DM_ERROR_INVALID_ARGUMENT;
    if (result == DM_OK) result = check_first(&out->hand);
    if (result == DM_OK) result = check_second(out);
    if (result == DM_OK) result = dmi_check_finite(DMI_SILENT, "handles", out->handles, 2);
    if (result == DM_OK) result = check_bounds(out);
    if (result == DM_OK && !drag->rules.on && needs_rules(out)) result = DM_ERROR_INVALID_ARGUMENT;
    return result;
}
