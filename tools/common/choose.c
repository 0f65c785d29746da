/* Picks a hypothesis by index or rule, and tells where each of them takes the part. */
#include "choose.h"

#include <math.h>
#include <string.h>

#include "job.h"
#include "joint_type.h"
#include "json.h"
#include "vec.h"

static const double axis_cosine = 0.94;  /* of 20 degrees between an axis and the one asked for; by hand */
static const double toward_cosine = 0.5; /* of 60 degrees between a centre's way and the one asked for; by hand */

static vec vec_from(const double v[3]) {
    return (vec){v[0], v[1], v[2]};
}

/* Returns the way of the part's centre to the end that lies farther from rest. */
static vec opening(const dm_choice* choice, const dm_hypothesis* hypothesis) {
    const dm_joint_end* ends = hypothesis->ends;
    const bool up = fabsf(ends[1].value) >= fabsf(ends[0].value);
    return sub(vec_of(ends[up].centre), vec_of(choice->part->centre));
}

static bool fits(const job_choice* rule, const dm_choice* choice, const dm_hypothesis* hypothesis) {
    const dm_joint* joint = hypothesis->joint;
    if (rule->type != DM_JOINT_UNKNOWN && joint->type != rule->type) return false;
    if (rule->has_axis && fabs(dot(vec_of(joint->axis), unit(vec_from(rule->axis)))) < axis_cosine) return false;
    return !rule->opens || dot(unit(opening(choice, hypothesis)), unit(vec_from(rule->toward))) >= toward_cosine;
}

static int pick(const job_choice* wanted, const dm_choice* choice) {
    if (wanted->kind == CHOICE_INDEX) return wanted->index;
    for (uint32_t i = 0; wanted->kind == CHOICE_RULE && i < choice->count; i++)
        if (fits(wanted, choice, choice->hypotheses[i])) return (int)i;
    return DM_CHOICE_KEEP;
}

int32_t DM_CALL choose_hypothesis(void* user, const dm_choice* choice) {
    const chooser* c = user;
    c->answer->count = choice->count;
    for (uint32_t i = 0; i < choice->count; i++)
        memcpy(c->answer->ends[i], choice->hypotheses[i]->ends, sizeof c->answer->ends[i]);
    return c->answer->chosen = pick(c->choice, choice);
}

/* ---- JSON ---- */

static dm_result read_direction(session* session, const cJSON* json, const char* name, double out[3], int* out_given) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, name);
    bool right = cJSON_IsArray(found) && cJSON_GetArraySize(found) == 3;
    for (int i = 0; found != NULL && right && i < 3; i++) {
        const cJSON* item = cJSON_GetArrayItem(found, i);
        right = cJSON_IsNumber(item) && isfinite(item->valuedouble);
        out[i] = right ? item->valuedouble : 0;
    }
    *out_given = found != NULL;
    if (found == NULL || (right && length(vec_from(out)) > 0)) return DM_OK;
    return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"choose\": \"%s\" is no direction", name);
}

static dm_result read_rule(session* session, const cJSON* json, job_choice* out) {
    const cJSON* type = cJSON_GetObjectItemCaseSensitive(json, "type");
    const char* name = cJSON_GetStringValue(type);
    out->kind = CHOICE_RULE;
    if (type != NULL && (name == NULL || (out->type = joint_type_from_name(name)) == DM_JOINT_UNKNOWN))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"choose\": \"type\" is no joint type");
    dm_result result = read_direction(session, json, "axis", out->axis, &out->has_axis);
    if (result == DM_OK) result = read_direction(session, json, "opens", out->toward, &out->opens);
    if (result == DM_OK && type == NULL && !out->has_axis && !out->opens)
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT,
                            "job: \"choose\" has neither \"type\" nor \"axis\" nor \"opens\"");
    return result;
}

dm_result choice_from_json(session* session, const cJSON* json, job_choice* out) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, "choose");
    if (found == NULL || cJSON_IsNull(found)) return DM_OK;
    if (cJSON_IsObject(found)) return read_rule(session, found, out);
    const double number = cJSON_IsNumber(found) ? found->valuedouble : -1;
    if (number >= 0 && number <= INT32_MAX && number == floor(number)) {
        out->kind = CHOICE_INDEX;
        out->index = (int)number;
        return DM_OK;
    }
    out->kind = CHOICE_KEEP;
    if (cJSON_IsString(found) && strcmp(found->valuestring, "keep") == 0) return DM_OK;
    return session_fail(session, DM_ERROR_INVALID_ARGUMENT,
                        "job: \"choose\" is no index of a hypothesis, no \"keep\" and no rule");
}

void choice_ends_to_json(const choice_answer* answer, uint32_t hypothesis, const double frame[3], cJSON* out) {
    if (hypothesis >= answer->count) return;
    cJSON* ends = cJSON_AddArrayToObject(out, "ends");
    for (int i = 0; i < 2; i++) {
        const dm_joint_end* end = &answer->ends[hypothesis][i];
        cJSON* item = cJSON_CreateObject();
        json_add_number(item, "value", (double)end->value, 9);
        json_add_point(item, "centre", end->centre, frame);
        json_add_point(item, "box_min", end->box_min, frame);
        json_add_point(item, "box_max", end->box_max, frame);
        cJSON_AddItemToArray(ends, item);
    }
}
