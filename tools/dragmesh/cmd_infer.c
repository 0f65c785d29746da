/* dragmesh infer: the joint of one part, or of every line of a file of jobs. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "answer.h"
#include "files.h"
#include "job_input.h"
#include "json.h"
#include "part_at_point.h"
#include "platform.h"
#include "runs.h"
#include "session_open.h"

static cJSON* result_for(const cJSON* id) {
    cJSON* result = cJSON_CreateObject();
    cJSON_AddItemToObject(result, "id", id != NULL ? cJSON_Duplicate(id, 1) : cJSON_CreateNull());
    return result;
}

/* Returns the first zero byte of a line, as it is or written as an escape: a text in C would end there. NULL: none. */
static const char* find_zero(const char* line, size_t length) {
    static const char escape[] = "\\u0000";
    for (size_t at = 0; at < length; at++) {
        if (line[at] == 0 || strncmp(line + at, escape, sizeof escape - 1) == 0) return line + at;
        at += line[at] == '\\'; /* what it escapes */
    }
    return NULL;
}

/* One line in, one line out; 0 when it carries an error. */
static bool answer_line(session* session, const char* line, size_t length, unsigned number, int no_hints) {
    const char* end = find_zero(line, length);
    cJSON* json = end == NULL ? cJSON_ParseWithOpts(line, &end, 1) : NULL;
    cJSON* result = result_for(cJSON_GetObjectItemCaseSensitive(json, "id"));
    job job = {0};
    joint_answer answer;
    dm_result code;
    if (json != NULL)
        code = job_from_json(session, json, &job);
    else
        code = session_fail(session, DM_ERROR_BAD_DATA, "job line %u is no JSON, at byte %td", number,
                            end != NULL ? end - line : 0);
    job.no_hints = no_hints;
    if (code == DM_OK) code = job_answer(session, &job, &answer);
    if (code == DM_OK)
        answer_to_json(&answer, result);
    else
        cJSON_AddStringToObject(result, "error", session->error);
    if (code == DM_OK && job.find_part) part_at_point_to_json(session, cJSON_AddArrayToObject(result, "moving"));
    if (code == DM_OK) session_warnings_to_json(session, result);
    json_print_line(result);
    job_free(&job);
    cJSON_Delete(json);
    return code == DM_OK;
}

/* Where a line does not end, there is none after it either. */
static int refuse_line(session* session, unsigned number) {
    cJSON* result = result_for(NULL);
    session_fail(session, DM_ERROR_TOO_LARGE, "job line %u is longer than %d bytes", number, LINE_MOST);
    cJSON_AddStringToObject(result, "error", session->error);
    json_print_line(result);
    return CLI_FAILED;
}

static int answer_jobs(session* session, const char* path, int no_hints) {
    FILE* file = strcmp(path, "-") == 0 ? stdin : platform_open_regular(path);
    if (file == NULL) {
        fprintf(stderr, "dragmesh: can't read the jobs '%s': %s\n", path, file_problem());
        return CLI_USAGE;
    }
    char* line = NULL;
    size_t room = 0, length;
    unsigned number = 0;
    int status = CLI_OK;
    enum file_line read;
    while ((read = file_read_line(file, &line, &room, &length)) == LINE_READ) {
        number++;
        if (strspn(line, " \t\r") == length) continue;
        if (!answer_line(session, line, length, number, no_hints)) status = CLI_FAILED;
    }
    if (read == LINE_TOO_LONG) status = refuse_line(session, number + 1);
    free(line);
    if (file != stdin) fclose(file);
    return status;
}

static int answer_one(session* session, job* job, int as_json) {
    joint_answer answer;
    const dm_result code = job_answer(session, job, &answer);
    if (as_json) {
        cJSON* result = cJSON_CreateObject();
        if (code == DM_OK)
            answer_to_json(&answer, result);
        else
            cJSON_AddStringToObject(result, "error", session->error);
        if (code == DM_OK && job->find_part) part_at_point_to_json(session, cJSON_AddArrayToObject(result, "moving"));
        if (code == DM_OK) session_warnings_to_json(session, result);
        json_print_line(result);
    } else if (code == DM_OK) {
        answer_print(&answer);
    } else {
        fprintf(stderr, "dragmesh: %s\n", session->error);
    }
    return code == DM_OK ? CLI_OK : CLI_FAILED;
}

int infer_run(const cli_command* command, int argc, char** argv) {
    const char *file = NULL, *jobs = NULL, *mask_out = NULL;
    int as_json = 0;
    job_options options;
    option_spec table[JOB_OPTIONS + 3];
    job_options_table(&options, table);
    table[JOB_OPTIONS] = (option_spec){.name = "--jobs", .kind = OPTION_TEXT, .value = &jobs};
    table[JOB_OPTIONS + 1] = (option_spec){.name = "--json", .kind = OPTION_FLAG, .value = &as_json};
    table[JOB_OPTIONS + 2] = (option_spec){.name = "--mask-out", .kind = OPTION_TEXT, .value = &mask_out};
    session session;
    int status = options_read(command, argc, argv, table, JOB_OPTIONS + 3, &file);
    if (status == CLI_OK && jobs == NULL) status = job_options_finish(command, &options, file);
    if (status == CLI_OK && jobs != NULL && (file != NULL || mask_out != NULL || options.job.moving.count > 0))
        status = options_refuse(command, "--jobs stands alone");
    if (status == CLI_OK && mask_out != NULL) status = options_check_output(command, "--mask-out", mask_out, ".json");
    if (status == CLI_OK) status = session_open(&session, options.models, NULL);
    if (status == CLI_OK) {
        status = jobs != NULL ? answer_jobs(&session, jobs, options.job.no_hints)
                              : answer_one(&session, &options.job, as_json);
        if (mask_out != NULL && status == CLI_OK && part_at_point_write(&session, mask_out) != 0) status = CLI_FAILED;
        session_close(&session);
    }
    job_free(&options.job);
    return status;
}
