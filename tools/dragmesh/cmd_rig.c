/* dragmesh rig: a whole asset, or a folder of them, rigged by one command. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"
#include "rig_output.h"
#include "runs.h"
#include "session_open.h"

enum { MOST_WORKERS = 256 }; /* by hand */

static const char* const switches[] = {"on", "off", NULL};

static int check(const cli_command* command, const rig_output* output, const rig_options* options, const char* file,
                 const char* names, const char* up) {
    if (file == NULL || output->path == NULL) return options_refuse(command, "a file or a folder, and -o, are needed");
    if (!(options->min_moves >= 0 && options->min_moves <= 1)) return options_refuse(command, "--min-moves: 0 to 1");
    if (strcmp(names, "on") != 0 && strcmp(names, "off") != 0) return options_refuse(command, "--names: on or off");
    if (up[0] < 'x' || up[0] > 'z' || up[1]) return options_refuse(command, "--up: x, y or z");
    return CLI_OK;
}

/* Rigs one file in this process. */
static int rig_file(const char* file, const char* models, const rig_output* output, const rig_options* options) {
    session session;
    int status = session_open(&session, models, NULL);
    if (status != CLI_OK) return status;
    session.is_quiet = output->is_worker;
    rig rig;
    dm_result result = rig_make(&session, file, options, &rig);
    if (result == DM_OK) result = rig_output_write(&session, &rig, options, output);
    if (output->is_worker)
        rig_output_leave_word(output, result == DM_OK, &rig, session.error);
    else
        rig_output_report(&session, output, file, result == DM_OK, &rig, options);
    status = result == DM_OK ? CLI_OK : CLI_FAILED;
    rig_free(&session, &rig);
    session_close(&session);
    return status;
}

int rig_run(const cli_command* command, int argc, char** argv) {
    const char *file = NULL, *models = NULL, *names = "on", *formats = "glb", *up = "y";
    int no_clips = 0, as_json = 0, is_worker = 0, workers = 1;
    char unknown[RIG_FORMATS_TEXT], known[RIG_FORMATS_TEXT];
    rig_output output = {0};
    rig_options options = {
        .min_moves = RIG_USUAL_MOVES,
    };
    const option_spec table[] = {{.name = "-o", .kind = OPTION_TEXT, .value = &output.path},
                                 {.name = "--names", .kind = OPTION_CHOICE, .value = &names, .choices = switches},
                                 {.name = "--no-clips", .kind = OPTION_FLAG, .value = &no_clips},
                                 {.name = "--min-moves", .kind = OPTION_NUMBER, .value = &options.min_moves},
                                 {.name = "--formats", .kind = OPTION_TEXT, .value = &formats},
                                 {.name = "--up", .kind = OPTION_TEXT, .value = &up},
                                 {.name = "-j", .kind = OPTION_INTEGER, .value = &workers},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json},
                                 {.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--worker", .kind = OPTION_FLAG, .value = &is_worker}};
    int status = options_read(command, argc, argv, table, sizeof table / sizeof *table, &file);
    if (status != CLI_OK) return status;
    options.without_names = strcmp(names, "off") == 0;
    options.without_clips = no_clips;
    options.up = up[0];
    options.formats = rig_read_formats(formats, unknown, sizeof unknown);
    output.as_json = as_json;
    output.is_worker = is_worker;
    status = check(command, &output, &options, file, names, up);
    rig_format_names(UINT32_MAX, known, sizeof known);
    if (status == CLI_OK && options.formats == 0)
        status = options_refuse(command, "--formats: '%s' is none of %s", unknown, known);
    if (status == CLI_OK && (workers < 1 || workers > MOST_WORKERS))
        status = options_refuse(command, "-j: 1 to %d", MOST_WORKERS);
    if (status != CLI_OK) return status;
    if (platform_kind_of(file) != PLATFORM_FOLDER) return rig_file(file, models, &output, &options);
    if (rig_output_is_answer(output.path)) return options_refuse(command, "-o: the assets of a folder need a folder");
    return rig_folder(file, models, &output, &options, workers);
}
