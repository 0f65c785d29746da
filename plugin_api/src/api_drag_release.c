/* Release of a drag: the part moves on by itself. */
#include <math.h>

#include "api_check.h"
#include "api_drag.h"
#include "api_joint_check.h"
#include "api_motion.h"
#include "base/fp_environment.h"
#include "math/elementary.h"
#include "math/linear3.h"

/* Paces the release by the motion that the network generates for pulling the grabbed point to the plan's outer end. */
static void pace_by_network(dm_context* context, dmi_drag_slot* slot, uint32_t seed) {
    const dmi_release* plan = &slot->drag.release;
    const dmi_model_slot* model = dmi_pool_get(context->models, slot->owner->model);
    if (plan->phase != DM_DRAG_RELEASED || plan->glides || plan->flies || slot->drag.feel.return_time > 0) return;
    if (model == NULL || model->motion == NULL || slot->owner->features == NULL)
        return; /* the minimum-jerk pace stays */
    const float outer = fabsf(plan->end) > fabsf(plan->start) ? plan->end : plan->start;
    float pull[3], values[DM_MOTION_FRAMES] = {0};
    dmi_joint_velocity(&slot->drag.joint, 0, slot->drag.rest_point, pull);
    const float* grab = slot->drag.rest_point;
    const dm_vec3 s = slot->scale, back = {1 / s.x, 1 / s.y, 1 / s.z}; /* the network knows the object unscaled */
    dm_joint joint = slot->drag.joint;
    const float shrunk = dmi_joint_scale(&joint, back);
    const dm_drag_hint host = {{grab[0] * back.x, grab[1] * back.y, grab[2] * back.z},
                               {outer * pull[0] * back.x, outer * pull[1] * back.y, outer * pull[2] * back.z}};
    dmi_drag_hint hint;
    dm_result result = dmi_object_hint(&context->env, "dm_drag_release: the grabbed point", slot->owner->object,
                                       slot->part, &host, &hint);
    if (result == DM_OK) {
        result = dmi_motion_opening(context, slot->owner, slot->part, &joint, &hint, seed, values);
    }
    for (int i = 0; joint.type == DM_JOINT_PRISMATIC && i < DM_MOTION_FRAMES; i++) values[i] /= shrunk;
    if (result == DM_OK) dmi_release_set_pace(&slot->drag.release, values);
}

static void write_plan(const dmi_release* release, dm_release_plan* out_plan) {
    const dm_release_plan plan = {.intent = release->intent,
                                  .start_value = release->start,
                                  .end_value = release->end,
                                  .duration = release->duration,
                                  .from_network = (uint32_t)release->paced};
    dmi_write_out(out_plan, &plan, sizeof plan);
}

static dm_result check_release(dmi_env* env, const dm_release_desc* desc, const dmi_release* last) {
    dm_result result =
        dmi_check_range(env, "dm_drag_release: desc.intent", desc->intent, DM_INTENT_AUTO, DM_INTENT_TOGGLE);
    if (result == DM_OK) result = dmi_check_number(env, "dm_drag_release: desc", ".duration", desc->duration);
    if (result != DM_OK) return result;
    static const char* const places[3] = {".away_from.x", ".away_from.y", ".away_from.z"};
    if (desc->flags & DM_RELEASE_AWAY_FROM)
        result = dmi_check_vector(env, "dm_drag_release: desc", places, dmi_xyz(desc->away_from).v);
    if (result != DM_OK) return result;
    if (desc->flags & ~(uint32_t)(DM_RELEASE_BY_RULE | DM_RELEASE_AWAY_FROM)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_release: desc.flags is 0x%x: unknown flag",
                        desc->flags);
    }
    if (desc->duration < 0.0f) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_drag_release: desc.duration is %g s",
                        (double)desc->duration);
    }
    if (desc->intent == DM_INTENT_REPLAY && last->phase == DM_DRAG_HELD) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_drag_release: desc.intent is DM_INTENT_REPLAY, but the drag "
                        "was never released");
    }
    return DM_OK;
}

/* Returns the side of rest on which the grabbed point gets farther from a point, or 0 for neither. */
static int32_t side_away_from(const dmi_drag* drag, dm_vec3 from) {
    const dmi_float3 point = dmi_xyz(from);
    float lower[3], upper[3];
    if (!dmi_joint_has_limits(&drag->joint)) return 0;
    dmi_joint_move(&drag->joint, drag->joint.lower, drag->rest_point, lower);
    dmi_joint_move(&drag->joint, drag->joint.upper, drag->rest_point, upper);
    return dmi_distance3(upper, point.v) >= dmi_distance3(lower, point.v) ? 1 : -1;
}

/* Returns what DM_INTENT_TOGGLE stands for. */
static int32_t toggled(const dmi_drag* drag) {
    return dmi_drag_is_open(drag) ? DM_INTENT_CLOSE : DM_INTENT_OPEN;
}

/* Returns an intent that is possible. A part whose way out has no end cannot go there, so it stays. */
static int32_t possible_intent(const dmi_drag_slot* slot, int32_t intent) {
    return slot->open_side != 0 && intent == DM_INTENT_OPEN ? DM_INTENT_STAY : intent;
}

dm_result DM_CALL dm_drag_release(dm_context* context, dm_drag drag, const dm_release_desc* desc,
                                  dm_release_plan* out_plan) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_drag_slot* slot = dmi_find(context, context->drags, "dm_drag_release", drag);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_release_desc known = {0};
    dm_result result = DM_OK;
    if (desc != NULL) {
        result = dmi_read_desc(env, "dm_drag_release: desc", desc, DMI_FIRST_SIZE(dm_release_desc, flags), sizeof known,
                               &known);
    }
    if (result == DM_OK && out_plan != NULL) {
        result =
            dmi_check_out(env, "dm_drag_release: out_plan", out_plan, DMI_FIRST_SIZE(dm_release_plan, from_network));
    }
    if (result == DM_OK) result = check_release(env, &known, &slot->drag.release);
    if (result != DM_OK) return result;
    dmi_drag_slot_warn(env, "dm_drag_release", slot);
    if (known.intent == DM_INTENT_TOGGLE) known.intent = toggled(&slot->drag);
    slot->drag.open_side = known.flags & DM_RELEASE_AWAY_FROM ? side_away_from(&slot->drag, known.away_from) : 0;
    dmi_drag_release(&slot->drag, possible_intent(slot, known.intent), known.duration);
    const bool by_rule = (known.flags & DM_RELEASE_BY_RULE) != 0;
    if (known.intent != DM_INTENT_REPLAY && !by_rule) pace_by_network(context, slot, known.seed);
    if (out_plan != NULL) write_plan(&slot->drag.release, out_plan);
    return DM_OK;
}
