/* dragmesh film: a strip of pictures of the part opening. */
#include <stdio.h>
#include <stdlib.h>

#include "answer.h"
#include "job_input.h"
#include "play.h"
#include "render.h"
#include "runs.h"
#include "session_open.h"

enum { DEFAULT_FRAMES = 5, MAX_FRAMES = 64 }; /* pictures of a strip; by hand */
enum { MIN_PIXELS = 16, MAX_PIXELS = 8192 };  /* a side of a picture at least, of the strip at most; by hand */

typedef struct film_options {
    int frames;
    float size[2];
    const char *out_path, *up;
    int axis;
} film_options;

/* Draws the strip and writes it. */
static dm_result draw(session* session, const job* job, const joint_answer* answer, const dm_pose* poses,
                      const film_options* options) {
    renderer renderer;
    size_t size;
    void* png = NULL;
    const uint32_t frames = (uint32_t)options->frames;
    dm_result result = render_open(&renderer, session, options->up[0]);
    if (result == DM_OK) {
        const vec toward = job->has_drag ? vec_of(job->drag.vector) : (vec){0, 0, 0};
        render_aim(&renderer, toward, poses, frames, (int)options->size[0], (int)options->size[1]);
        png = render_film(&renderer, poses, frames, options->axis ? &answer->joint : NULL, &size);
        result = png != NULL ? session_write(session, options->out_path, png, size) : DM_ERROR_INTERNAL;
    }
    render_close(&renderer);
    free(png);
    return result;
}

static dm_result film(session* session, job* job, const film_options* options) {
    joint_answer answer;
    dm_pose poses[MAX_FRAMES];
    dm_result result = job_answer(session, job, &answer);
    if (result == DM_OK) result = play_motion(session, job, &answer, (uint32_t)options->frames, poses, NULL);
    if (result == DM_OK) result = draw(session, job, &answer, poses, options);
    if (result == DM_OK) answer_print(&answer);
    return result;
}

static int check(const cli_command* command, const film_options* options) {
    if (options->out_path == NULL) return options_refuse(command, "where to? -o OUT.png");
    if (options_check_output(command, "-o", options->out_path, ".png") != CLI_OK) return CLI_USAGE;
    if (options->frames < 2 || options->frames > MAX_FRAMES)
        return options_refuse(command, "--frames: 2 to %d", MAX_FRAMES);
    for (int i = 0; i < 2; i++)
        if (!(options->size[i] >= MIN_PIXELS && options->size[i] * (float)options->frames <= MAX_PIXELS))
            return options_refuse(command, "--size: %d or more, %d for all frames together", MIN_PIXELS, MAX_PIXELS);
    if (options->up[0] < 'x' || options->up[0] > 'z' || options->up[1])
        return options_refuse(command, "--up: x, y or z");
    return CLI_OK;
}

int film_run(const cli_command* command, int argc, char** argv) {
    const char* file = NULL;
    film_options film_of = {.frames = DEFAULT_FRAMES, .size = {400, 400}, .up = "y"};
    job_options options;
    option_spec table[JOB_OPTIONS + 5];
    job_options_table(&options, table);
    option_spec* own = table + JOB_OPTIONS;
    own[0] = (option_spec){.name = "-o", .kind = OPTION_TEXT, .value = &film_of.out_path};
    own[1] = (option_spec){.name = "--frames", .kind = OPTION_INTEGER, .value = &film_of.frames};
    own[2] = (option_spec){.name = "--size", .kind = OPTION_NUMBERS, .value = film_of.size, .count = 2};
    own[3] = (option_spec){.name = "--up", .kind = OPTION_TEXT, .value = &film_of.up};
    own[4] = (option_spec){.name = "--axis", .kind = OPTION_FLAG, .value = &film_of.axis};
    session session;
    int status = options_read(command, argc, argv, table, JOB_OPTIONS + 5, &file);
    if (status == CLI_OK) status = job_options_finish(command, &options, file);
    if (status == CLI_OK) status = check(command, &film_of);
    if (status == CLI_OK) status = session_open(&session, options.models, NULL);
    if (status == CLI_OK) {
        if (film(&session, &options.job, &film_of) != DM_OK) {
            fprintf(stderr, "dragmesh: %s\n", session.error);
            status = CLI_FAILED;
        }
        session_close(&session);
    }
    job_free(&options.job);
    return status;
}
