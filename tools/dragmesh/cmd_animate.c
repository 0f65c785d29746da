/* dragmesh animate: the file again, with the part moving in a loop. */
#include <stdio.h>
#include <stdlib.h>

#include "answer.h"
#include "job_input.h"
#include "play.h"
#include "runs.h"
#include "session_open.h"

enum { DEFAULT_FRAMES = 60, MAX_FRAMES = 100000 }; /* key frames of the opening; by hand */
static const float seconds_open = 2;               /* duration of the opening, s; by hand */

static dm_result write_motion(session* session, const dm_pose* poses, int frames, const char* out_path) {
    void* data = NULL;
    size_t size = 0;
    dm_result result = play_export(session, poses, (uint32_t)frames, seconds_open, &data, &size);
    if (result == DM_OK) result = session_write(session, out_path, data, size);
    dm_gltf_release_bytes(session->gltf, data, size);
    return result;
}

static dm_result animate(session* session, job* job, int frames, const char* out_path) {
    joint_answer answer;
    dm_result result = job_answer(session, job, &answer);
    if (result != DM_OK) return result;
    dm_pose* poses = cli_alloc((size_t)frames * sizeof *poses);
    result = play_motion(session, job, &answer, (uint32_t)frames, poses, NULL);
    if (result == DM_OK) result = write_motion(session, poses, frames, out_path);
    free(poses);
    if (result == DM_OK) answer_print(&answer);
    return result;
}

int animate_run(const cli_command* command, int argc, char** argv) {
    const char *file = NULL, *out_path = NULL;
    int frames = DEFAULT_FRAMES;
    job_options options;
    option_spec table[JOB_OPTIONS + 2];
    job_options_table(&options, table);
    table[JOB_OPTIONS] = (option_spec){.name = "-o", .kind = OPTION_TEXT, .value = &out_path};
    table[JOB_OPTIONS + 1] = (option_spec){.name = "--frames", .kind = OPTION_INTEGER, .value = &frames};
    session session;
    int status = options_read(command, argc, argv, table, JOB_OPTIONS + 2, &file);
    if (status == CLI_OK) status = job_options_finish(command, &options, file);
    if (status == CLI_OK && out_path == NULL) status = options_refuse(command, "where to? -o OUT.glb");
    if (status == CLI_OK) status = options_check_output(command, "-o", out_path, ".glb");
    if (status == CLI_OK && (frames < 2 || frames > MAX_FRAMES))
        status = options_refuse(command, "--frames: 2 to %d", MAX_FRAMES);
    if (status == CLI_OK) status = session_open(&session, options.models, NULL);
    if (status == CLI_OK) {
        if (animate(&session, &options.job, frames, out_path) != DM_OK) {
            fprintf(stderr, "dragmesh: %s\n", session.error);
            status = CLI_FAILED;
        }
        session_close(&session);
    }
    job_free(&options.job);
    return status;
}
