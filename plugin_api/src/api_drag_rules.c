/* Checks of what a host asks of a dragged part besides following the hand: rules and inputs. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_drag.h"

#define LARGEST_RATE 1e12f /* joint value a second, or a second squared; by hand: no limit is felt any more */
#define LARGEST_TIME 1e12f /* s; by hand */

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
    const number numbers[] = {
        {"snap_reach", rules->snap_reach, DMI_LARGEST}, {"open_share", rules->open_share, 1},
        {"closed_share", rules->closed_share, 1},       {"event_time", rules->event_time, LARGEST_TIME},
        {"max_speed", rules->max_speed, LARGEST_RATE},  {"max_acceleration", rules->max_acceleration, LARGEST_RATE}};
    dm_result result = check_numbers(env, numbers, sizeof numbers / sizeof *numbers);
    if (result == DM_OK) result = check_snaps(env, rules);
    if (result != DM_OK || rules->snap_count == 0 || !(feel->detent > 0)) return result;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_drag_begin: desc.rules.snap_count and desc.feel.detent are "
                    "both set: a part has one or the other");
}

dm_result dmi_rules_read(dmi_env* env, const dm_drag_desc* desc, const dmi_rules_start* start, dmi_rules* out) {
    dm_drag_rules given;
    *out = (dmi_rules){0};
    if (desc->rules == NULL) return DM_OK;
    dm_result result = dmi_read_desc(env, "dm_drag_begin: desc.rules", desc->rules,
                                     DMI_FIRST_SIZE(dm_drag_rules, max_acceleration), sizeof given, &given);
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
    if (!r->on) return s->count == 0;
    if (s->count > DM_MAX_SNAPS || !is_within(s->pull, 0, 1) || !is_within(s->reach, 0, DMI_LARGEST)) return false;
    for (uint32_t i = 0; i < s->count; i++) {
        if (!is_within(s->values[i], -DMI_LARGEST, DMI_LARGEST)) return false;
        if (i > 0 && !(s->values[i - 1] < s->values[i])) return false;
    }
    return is_within(s->outer_reach, 0, FLT_MAX) && is_within(r->object_size, 0, FLT_MAX) &&
           is_within(r->open_share, 0, 1) && is_within(r->closed_share, 0, r->open_share) &&
           is_within(r->event_time, 0, LARGEST_TIME) && is_within(r->max_speed, 0, LARGEST_RATE) &&
           is_within(r->max_acceleration, 0, LARGEST_RATE);
}

static dm_result check_bounds(dmi_env* env, const dmi_drag* drag, const dm_drag_input* input) {
    if (input->lower == input->upper) return DM_OK;
    if (!(input->lower < input->upper)) {
        const bool numbers = !isnan(input->lower) && !isnan(input->upper);
        return dmi_fail(env, numbers ? DM_ERROR_INVALID_ARGUMENT : DM_ERROR_NOT_FINITE,
                        "dm_drag_step: input.lower is %g, input.upper %g: they must rise", (double)input->lower,
                        (double)input->upper);
    }
    if (drag->rules.on) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_drag_step: input.lower and upper are set, but the drag began "
                    "without desc.rules");
}

dm_result dmi_input_read(dmi_env* env, const dmi_drag* drag, const dm_drag_input* input, dm_drag_input* out) {
    dm_result result =
        dmi_read_desc(env, "dm_drag_step: input", input, DMI_FIRST_SIZE(dm_drag_input, upper), sizeof *out, out);
    if (result == DM_OK)
        result = dmi_check_range(env, "dm_drag_step: input.hand.kind", out->hand.kind, DM_HAND_NONE, DM_HAND_RAY);
    if (result == DM_OK && out->hand.kind == DM_HAND_RAY)
        result = dmi_check_ray(env, "dm_drag_step: input.hand.ray", &out->hand.ray);
    return result == DM_OK ? check_bounds(env, drag, out) : result;
}
