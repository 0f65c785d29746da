/* The files of a rigged asset, and the lines about it. */
#include "rig_output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "json.h"
#include "output_file.h"

bool rig_output_is_answer(const char* path) {
    const size_t length = strlen(path);
    return length > 5 && strcmp(path + length - 5, ".json") == 0;
}

static dm_result write_answer(file_set* set, const rig* rig, const rig_options* options, const char* path) {
    cJSON* json = rig_to_json(set->session, rig, options);
    char* text = cJSON_Print(json);
    cJSON_Delete(json);
    if (text == NULL) return session_fail(set->session, DM_ERROR_OUT_OF_MEMORY, "no memory for the answer");
    dm_gltf_mend_text(text);
    const dm_result result = file_set_add(set, path, text, strlen(text));
    cJSON_free(text);
    return result;
}

/* The answer comes last: where it is, all is. */
static dm_result write_folder(file_set* set, const rig* rig, const rig_options* options, const rig_output* output) {
    char *film = path_join(output->path, "film.png"), *answer = path_join(output->path, RIG_ANSWER);
    dm_result result = platform_make_folder(output->path) == 0 || errno == EEXIST
                           ? DM_OK
                           : session_fail_to_write(set->session, output->path);
    if (result == DM_OK) result = rig_write_formats(set, rig, options->formats, output->path);
    if (result == DM_OK && rig->info.moving_count > 0) result = rig_write_film(set, rig, options->up, film);
    if (result == DM_OK) result = write_answer(set, rig, options, answer);
    free(film);
    free(answer);
    return result;
}

dm_result rig_output_write(session* session, const rig* rig, const rig_options* options, const rig_output* output) {
    file_set set = {.session = session};
    dm_result result = rig_output_is_answer(output->path) ? write_answer(&set, rig, options, output->path)
                                                          : write_folder(&set, rig, options, output);
    if (result == DM_OK) result = file_set_publish(&set);
    file_set_free(&set);
    return result;
}

/* Writes `%s` with what the parts are: "3 of 12 parts move". */
static void describe(const rig* rig, char* out, size_t size) {
    snprintf(out, size, "%u of %u parts move%s, %.1f s", rig->info.moving_count, rig->info.part_count,
             rig->info.moving_count == 1 ? "s" : "", rig->seconds);
}

void rig_output_report(const session* session, const rig_output* output, const char* file, bool is_done, const rig* rig,
                       const rig_options* options) {
    char line[128];
    if (!is_done) {
        fprintf(stderr, "dragmesh: %s\n", session->error);
    } else if (output->as_json) {
        json_print_line(rig_to_json(session, rig, options));
    } else {
        describe(rig, line, sizeof line);
        printf("%s: %s\n", file, line);
    }
}

void rig_output_leave_word(const rig_output* output, bool is_done, const rig* rig, const char* error) {
    char line[128];
    char* path = path_join(output->path, RIG_WORD);
    if (is_done) describe(rig, line, sizeof line);
    const char* word = is_done ? line : error;
    output_write(path, word, strlen(word));
    free(path);
}
