/* Jobs from the command line and from lines of JSON. */
#ifndef DRAGMESH_JOB_INPUT_H
#define DRAGMESH_JOB_INPUT_H

#include "job.h"
#include "options.h"

/* The options every command that takes a job has: their values and a table of them. */
typedef struct job_options {
    job job;
    const char *models, *type;
    float vector[3];
    int has_point, has_vector, has_choice;
} job_options;
enum { JOB_OPTIONS = 8 };
void job_options_table(job_options* options, option_spec out_table[JOB_OPTIONS]);
/* After reading: fills options->job; CLI_OK or CLI_USAGE. */
int job_options_finish(const cli_command* command, job_options* options, const char* file);

/* From a line of jobs; session->error says what is wrong. */
dm_result job_from_json(session* session, const cJSON* json, job* out_job);
void job_free(job* job);

#endif
