/* Jobs from the command line and from lines of JSON. */
#include "job_input.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "joint_type.h"
#include "part_at_point.h"

#define MASK_VALUE_MOST 9007199254740991.0 /* beyond, JSON's numbers are not exact: 2^53 - 1 */

/* ---- the command line ---- */

void job_options_table(job_options* options, option_spec out_table[JOB_OPTIONS]) {
    memset(options, 0, sizeof *options);
    const option_spec table[JOB_OPTIONS] = {
        {.name = "--moving", .kind = OPTION_NAMES, .value = &options->job.moving},
        {.name = "--models", .kind = OPTION_TEXT, .value = &options->models},
        {.name = "--type", .kind = OPTION_TEXT, .value = &options->type},
        {.name = "--mask", .kind = OPTION_TEXT, .value = &options->job.mask},
        {.name = "--choose",
         .kind = OPTION_INTEGER,
         .value = &options->job.choice.index,
         .given = &options->has_choice},
        {.name = "--no-hints", .kind = OPTION_FLAG, .value = &options->job.no_hints},
        {.name = "--drag-point",
         .kind = OPTION_DOUBLES,
         .value = options->job.drag_point,
         .count = 3,
         .given = &options->has_point},
        {.name = "--drag-vector",
         .kind = OPTION_NUMBERS,
         .value = options->vector,
         .count = 3,
         .given = &options->has_vector},
    };
    memcpy(out_table, table, sizeof table);
}

int job_options_finish(const cli_command* command, job_options* options, const char* file) {
    job* job = &options->job;
    if (file == NULL) return options_refuse(command, "which file?");
    if (job->moving.count == 0 && job->mask == NULL)
        return options_refuse(command, "what moves? --moving NODE[,NODE…] or --mask FILE");
    if (options->has_point != options->has_vector)
        return options_refuse(command, "a drag is --drag-point and --drag-vector");
    if (job->mask != NULL && strcmp(file, "-") == 0 && strcmp(job->mask, "-") == 0)
        return options_refuse(command, "the file and the mask can't both be standard input");
    job->find_part = part_at_point_requested(&job->moving);
    if (job->find_part && job->mask == NULL && !options->has_point)
        return options_refuse(command, "--moving auto needs to know where it is grabbed: --drag-point, --drag-vector");
    if (options->type != NULL && (job->type = joint_type_from_name(options->type)) == DM_JOINT_UNKNOWN)
        return options_refuse(command, "--type: '%.200s' is no joint type; --help lists them", options->type);
    if (options->has_choice && job->choice.index < 0)
        return options_refuse(command, "--choose: %d is no index of a hypothesis", job->choice.index);
    if (options->has_choice) job->choice.kind = CHOICE_INDEX;
    job->file = file;
    job->has_drag = options->has_point;
    job->drag.vector = (dm_vec3){options->vector[0], options->vector[1], options->vector[2]};
    return CLI_OK;
}

/* ---- lines of JSON ---- */

static const cJSON* member(const cJSON* json, const char* name) {
    const cJSON* found = cJSON_GetObjectItemCaseSensitive(json, name);
    return cJSON_IsNull(found) ? NULL : found;
}

static dm_result read_text(session* session, const cJSON* json, const char* name, const char** out) {
    const cJSON* found = member(json, name);
    if (found == NULL) return DM_OK;
    if (!cJSON_IsString(found))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"%s\" is not a string", name);
    *out = found->valuestring;
    return DM_OK;
}

/* A path in data names a file. What names an input of the tool counts on the command line alone: here it would take the
 * lines that follow. */
static dm_result read_path(session* session, const cJSON* json, const char* name, const char** out) {
    static const char* const inputs[] = {"/dev/stdin", "/dev/fd/", "/proc/self/fd/"};
    const dm_result result = read_text(session, json, name, out);
    if (result != DM_OK || *out == NULL) return result;
    bool is_input = strcmp(*out, "-") == 0;
    for (int i = 0; i < 3; i++) is_input = is_input || strncmp(*out, inputs[i], strlen(inputs[i])) == 0;
    if (!is_input) return DM_OK;
    return session_fail(session, DM_ERROR_INVALID_ARGUMENT,
                        "job: \"%s\" is '%s', no file; only the command line can name standard input", name, *out);
}

static dm_result read_number(session* session, const cJSON* json, const char* name, double* out, int* out_given) {
    const cJSON* found = member(json, name);
    if (found == NULL) return DM_OK;
    if (!cJSON_IsNumber(found))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"%s\" is not a number", name);
    *out = found->valuedouble;
    *out_given = 1;
    return DM_OK;
}

/* Reads an array of `count` numbers. */
static dm_result read_numbers(session* session, const cJSON* json, const char* name, int count, double* out,
                              int* out_given) {
    const cJSON* found = member(json, name);
    if (found == NULL) return DM_OK;
    bool right = cJSON_IsArray(found) && cJSON_GetArraySize(found) == count;
    const cJSON* item;
    cJSON_ArrayForEach(item, found) right = right && cJSON_IsNumber(item);
    if (!right)
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"%s\" is not %s numbers", name,
                            count == 3 ? "three" : "nine");
    int at = 0;
    cJSON_ArrayForEach(item, found) out[at++] = item->valuedouble;
    *out_given = 1;
    return DM_OK;
}

static dm_result read_vector(session* session, const cJSON* json, const char* name, double out[3], int* out_given) {
    return read_numbers(session, json, name, 3, out, out_given);
}

/* A null pivot says that there is none, an absent one that the file's own counts. */
static dm_result read_hints(session* session, const cJSON* json, job* out) {
    double axes[9] = {0};
    int ignored = 0;
    out->no_pivot = cJSON_IsNull(cJSON_GetObjectItemCaseSensitive(json, "pivot"));
    if (cJSON_IsNull(cJSON_GetObjectItemCaseSensitive(json, "label"))) out->label = "";
    dm_result result = read_text(session, json, "label", &out->label);
    if (result == DM_OK) result = read_vector(session, json, "pivot", out->pivot_origin, &out->has_pivot);
    if (result == DM_OK) result = read_numbers(session, json, "pivot_axes", 9, axes, &ignored);
    for (int i = 0; i < 9; i++) out->pivot.axes[i] = (float)axes[i];
    if (result == DM_OK && out->label != NULL && strlen(out->label) > DM_MAX_LABEL)
        return session_fail(session, DM_ERROR_TOO_LARGE, "job: \"label\" is longer than %d bytes", DM_MAX_LABEL);
    return result;
}

static dm_result read_moving(session* session, const cJSON* json, name_list* out) {
    const cJSON* found = member(json, "moving");
    if (found == NULL) return DM_OK;
    if (cJSON_IsString(found)) {
        name_list_add(out, found->valuestring, strlen(found->valuestring));
        return DM_OK;
    }
    const cJSON* item;
    cJSON_ArrayForEach(item, found) {
        if (!cJSON_IsString(item))
            return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"moving\" holds something else than names");
        name_list_add(out, item->valuestring, strlen(item->valuestring));
    }
    if (!cJSON_IsArray(found))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"moving\" is not a list of node names");
    return DM_OK;
}

static dm_result read_fields(session* session, const cJSON* json, job* out) {
    const char* type = NULL;
    int has_vector = 0, ignored = 0;
    double value = 0, vector[3] = {0, 0, 0};
    dm_result result = read_path(session, json, "file", &out->file);
    if (result == DM_OK) result = read_path(session, json, "mask", &out->mask);
    if (result == DM_OK) result = read_text(session, json, "type", &type);
    if (result == DM_OK) result = read_number(session, json, "mask_value", &value, &out->has_mask_value);
    if (result == DM_OK) result = read_number(session, json, "mask_noise", &out->mask_noise, &ignored);
    if (result == DM_OK) result = read_vector(session, json, "drag_point", out->drag_point, &out->has_drag);
    if (result == DM_OK) result = read_vector(session, json, "drag_vector", vector, &has_vector);
    if (result == DM_OK) result = read_moving(session, json, &out->moving);
    if (result == DM_OK) result = read_hints(session, json, out);
    if (result == DM_OK) result = choice_from_json(session, json, &out->choice);
    if (result != DM_OK) return result;
    out->drag.vector = (dm_vec3){(float)vector[0], (float)vector[1], (float)vector[2]};
    if (!(fabs(value) <= MASK_VALUE_MOST) || value != floor(value))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"mask_value\" is %.17g, no whole number", value);
    out->mask_value = (int64_t)value;
    if (out->has_drag != has_vector)
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"%s\" without \"%s\"",
                            has_vector ? "drag_vector" : "drag_point", has_vector ? "drag_point" : "drag_vector");
    if (type != NULL && (out->type = joint_type_from_name(type)) == DM_JOINT_UNKNOWN)
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"type\" is '%s', no joint type", type);
    if (!(out->mask_noise >= 0 && out->mask_noise < 1))
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"mask_noise\" is %g, not in [0, 1)",
                            out->mask_noise);
    return DM_OK;
}

dm_result job_from_json(session* session, const cJSON* json, job* out_job) {
    memset(out_job, 0, sizeof *out_job);
    if (!cJSON_IsObject(json)) return session_fail(session, DM_ERROR_BAD_DATA, "job: the line is not a JSON object");
    const dm_result result = read_fields(session, json, out_job);
    if (result != DM_OK) return result;
    if (out_job->file == NULL) return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"file\" is missing");
    if (out_job->mask == NULL && out_job->moving.count == 0)
        return session_fail(session, DM_ERROR_EMPTY_MASK, "job: neither \"moving\" nor \"mask\" says what moves");
    out_job->find_part = part_at_point_requested(&out_job->moving);
    if (out_job->mask == NULL && out_job->find_part && !out_job->has_drag)
        return session_fail(session, DM_ERROR_INVALID_ARGUMENT, "job: \"moving\" is auto, but there is no drag");
    return DM_OK;
}

void job_free(job* job) {
    name_list_free(&job->moving);
}
