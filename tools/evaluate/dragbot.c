/* dragmesh dragbot: a scripted player on a folder of objects whose joints are known. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot_rig.h"
#include "dragbot_score.h"
#include "eval_hints.h"
#include "output_file.h"
#include "runs.h"
#include "session_open.h"

static int by_time(const void* a, const void* b) {
    const float x = *(const float*)a, y = *(const float*)b;
    return x < y ? -1 : x > y;
}

/* ---- hands ---- */

enum { NAIVE_DEGREES = 35 }; /* by which a naive hand's direction is off at most; by hand */

/* The hands of --all. */
static const struct {
    const char* name;
    bot_hand hand;
    enum bot_sight sight;
} hands[] = {
    {"arc", {0}, BOT_AROUND},
    {"straight", {.straight = 1}, BOT_AROUND},
    {"unsteady", {.wander = 0.03, .tremor = 1.5}, BOT_AROUND},
    {"jostle 8", {.jostle = 8}, BOT_AROUND},
    {"jostle 16", {.jostle = 16}, BOT_AROUND},
    {"regrab 3", {.regrab = 3}, BOT_AROUND},
    {"offset 15", {.offset = 15}, BOT_AROUND},
    {"pause", {.pause = 1}, BOT_AROUND},
    {"axis", {.axis = 1}, BOT_AROUND},
    {"above", {0}, BOT_ABOVE},
    {"behind", {0}, BOT_BEHIND},
    {"end-on", {0}, BOT_END_ON},
    {"30 Hz", {.hz = 30}, BOT_AROUND},
    {"144 Hz", {.hz = 144}, BOT_AROUND},
    {"hitch", {.hitch = 1}, BOT_AROUND},
    {"moving camera", {.moving_camera = 1}, BOT_AROUND},
    {"moving instance", {.moving_instance = 1}, BOT_AROUND},
    {"point", {.point = 1}, BOT_AROUND},
    {"scalar", {.scalar = 1}, BOT_AROUND},
    {"naive", {.naive = 1, .degrees = NAIVE_DEGREES}, BOT_AROUND},
    {"naive snapped", {.naive = 1, .snap = 1}, BOT_AROUND},
    {"naive up", {.naive = 1, .degrees = NAIVE_DEGREES, .up = 1}, BOT_AROUND},
    {"naive regrab 3", {.naive = 1, .degrees = NAIVE_DEGREES, .regrab = 3}, BOT_AROUND},
    {"naive point", {.naive = 1, .degrees = NAIVE_DEGREES, .point = 1}, BOT_AROUND},
};
enum { HANDS = sizeof hands / sizeof *hands };

/* ---- running ---- */

static int report(bot_run* runs, int count, bool as_table, bool as_json) {
    int failed = 0;
    for (int i = 0; i < count; i++) {
        bot_times* times = &runs[i].score.times;
        if (times->count) qsort(times->ns, times->count, sizeof *times->ns, by_time);
        failed += runs[i].score.failed;
    }
    if (as_table)
        bot_report_table(runs, count, as_json);
    else if (as_json)
        bot_report_json(runs);
    else
        bot_report_text(runs);
    for (int i = 0; i < count; i++) {
        FILE* out = as_json ? stderr : stdout;
        if (as_table && runs[i].options.worst) fprintf(out, "%s:\n", runs[i].name);
        bot_report_failures(&runs[i], out);
    }
    return failed ? CLI_FAILED : CLI_OK;
}

/* Plays with one hand, or with all. */
static int play(session* session, const char* folder, const bot_options* options, bool all, bool as_json) {
    bot_run runs[HANDS];
    const int count = all ? HANDS : 1;
    name_list names = dataset_list(folder, "joints.json");
    if (names.count == 0) {
        fprintf(stderr, "dragmesh dragbot: '%s' has no folders with a joints.json\n", folder);
        return CLI_USAGE;
    }
    for (int i = 0; i < count; i++) {
        runs[i] = (bot_run){.name = hands[i].name, .options = *options};
        if (all) runs[i].options.hand = hands[i].hand, runs[i].options.sight = hands[i].sight;
    }
    for (unsigned i = 0; i < names.count; i++) bot_play_object(session, folder, names.names[i], runs, count);
    const int status = report(runs, count, all, as_json);
    for (int i = 0; i < count; i++) {
        free(runs[i].score.rows);
        free(runs[i].score.pulls);
        free(runs[i].score.times.ns);
    }
    name_list_free(&names);
    return status;
}

/* ---- options ---- */

static bool read_sight(const char* name, enum bot_sight* out_sight) {
    static const char* const names[] = {"around", "end-on", "above", "behind"};
    for (int i = 0; i < 4; i++) {
        if (strcmp(name, names[i]) != 0) continue;
        *out_sight = (enum bot_sight)i;
        return true;
    }
    return false;
}

/* Refuses what a naive hand can't be, and what others can't. */
static int check_naive(const cli_command* command, const bot_options* options) {
    const bot_hand* hand = &options->hand;
    if (!hand->naive && (hand->snap || hand->up)) return options_refuse(command, "--snap and --up with --naive");
    if (!hand->naive) return CLI_OK;
    if (hand->degrees < 0 || hand->degrees > 180) return options_refuse(command, "--naive 0 to 180 degrees");
    if (hand->snap + hand->up + hand->point > 1) return options_refuse(command, "--snap, --up or --point");
    if (hand->straight || hand->axis || hand->wander != 0 || hand->tremor != 0 || hand->jostle != 0 ||
        hand->offset != 0 || hand->pause || hand->scalar || hand->moving_camera || hand->moving_instance ||
        options->sight != BOT_AROUND || options->given_only)
        return options_refuse(command, "--naive, with --snap, --up, --point, --regrab, --hz or --hitch alone");
    return CLI_OK;
}

/* Refuses numbers out of range, and hands that can't be one hand. */
static int check(const cli_command* command, const bot_options* options) {
    const bot_hand* hand = &options->hand;
    const int hz = hand->hz;
    if (check_naive(command, options) != CLI_OK) return CLI_USAGE;
    if (options->cameras < 1) return options_refuse(command, "--cameras from 1");
    if (hand->straight && hand->axis) return options_refuse(command, "--straight or --axis");
    if ((hand->point || hand->scalar) &&
        (hand->point == hand->scalar || hand->straight || hand->axis || hand->wander != 0 || hand->tremor != 0 ||
         hand->jostle != 0 || hand->offset != 0 || hand->moving_camera || hand->moving_instance ||
         options->sight == BOT_END_ON)) {
        return options_refuse(command, "--point or --scalar, with --pause, --regrab, --hz or --hitch alone");
    }
    if (hand->jostle < 0 || hand->offset < 0) return options_refuse(command, "pixels from 0");
    if (hand->regrab < 0 || hand->regrab > BOT_MAX_REGRABS)
        return options_refuse(command, "--regrab 0 to %d", BOT_MAX_REGRABS);
    if (hz != 30 && hz != 60 && hz != 144) return options_refuse(command, "--hz 30, 60 or 144");
    if (hand->moving_camera && hand->moving_instance)
        return options_refuse(command, "--moving-camera or --moving-instance");
    if (options->sight == BOT_END_ON && (hand->straight || hand->axis || hand->moving_camera || hand->moving_instance))
        return options_refuse(command, "--view end-on pulls to four sides: no --straight, --axis, --moving-camera, "
                                       "--moving-instance");
    return CLI_OK;
}

/* Whether any option says how the hand moves or where the camera is; --all has its own. */
static bool is_plain(const bot_options* options) {
    const bot_hand* hand = &options->hand;
    return !hand->straight && !hand->axis && hand->wander == 0 && hand->tremor == 0 && hand->jostle == 0 &&
           hand->offset == 0 && !hand->pause && !hand->regrab && hand->hz == 60 && !hand->hitch &&
           !hand->moving_camera && !hand->moving_instance && !hand->point && !hand->scalar && !hand->naive &&
           options->sight == BOT_AROUND;
}

static int fail_to_write(const char* path) {
    fprintf(stderr, "dragmesh dragbot: can't write '%s': %s\n", path, strerror(errno));
    return CLI_FAILED;
}

/* Opens the file of poses and plays. Poses of drags that failed are kept too. */
static int run_session(const char* folder, const char* models, const char* poses, bot_options* options, bool all,
                       bool as_json) {
    session session;
    output_file file = {.stream = NULL};
    if (poses != NULL && output_open(&file, poses) != 0) return fail_to_write(poses);
    if (poses != NULL) options->poses = &file;
    int status = session_open(&session, models, NULL);
    if (status == CLI_OK) {
        status = options->rig ? bot_rig_play(&session, folder, options, as_json)
                              : play(&session, folder, options, all, as_json);
        session_close(&session);
    }
    if (poses != NULL && status == CLI_USAGE)
        output_discard(&file);
    else if (poses != NULL && output_close(&file) != 0)
        status = fail_to_write(poses);
    return status;
}

int dragbot_run(const cli_command* command, int argc, char** argv) {
    const char *folder = NULL, *models = NULL, *view = "around", *poses = NULL;
    int as_json = 0, all = 0;
    const char* hints = "none";
    static const char* const known_hints[] = {"names", "pivots", "both", NULL};
    bot_options options = {.cameras = 4, .hand = {.hz = 60, .degrees = NAIVE_DEGREES}};
    bot_hand* hand = &options.hand;
    double* degrees = &hand->degrees;
    const option_spec table[] = {{.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json},
                                 {.name = "--worst", .kind = OPTION_INTEGER, .value = &options.worst},
                                 {.name = "--straight", .kind = OPTION_FLAG, .value = &hand->straight},
                                 {.name = "--axis", .kind = OPTION_FLAG, .value = &hand->axis},
                                 {.name = "--wander", .kind = OPTION_NUMBER, .value = &hand->wander},
                                 {.name = "--tremor", .kind = OPTION_NUMBER, .value = &hand->tremor},
                                 {.name = "--jostle", .kind = OPTION_NUMBER, .value = &hand->jostle},
                                 {.name = "--offset", .kind = OPTION_NUMBER, .value = &hand->offset},
                                 {.name = "--pause", .kind = OPTION_FLAG, .value = &hand->pause},
                                 {.name = "--regrab", .kind = OPTION_INTEGER, .value = &hand->regrab},
                                 {.name = "--hz", .kind = OPTION_INTEGER, .value = &hand->hz},
                                 {.name = "--hitch", .kind = OPTION_FLAG, .value = &hand->hitch},
                                 {.name = "--moving-camera", .kind = OPTION_FLAG, .value = &hand->moving_camera},
                                 {.name = "--moving-instance", .kind = OPTION_FLAG, .value = &hand->moving_instance},
                                 {.name = "--point", .kind = OPTION_FLAG, .value = &hand->point},
                                 {.name = "--scalar", .kind = OPTION_FLAG, .value = &hand->scalar},
                                 {.name = "--naive", .kind = OPTION_OPTIONAL, .value = degrees, .given = &hand->naive},
                                 {.name = "--snap", .kind = OPTION_FLAG, .value = &hand->snap},
                                 {.name = "--up", .kind = OPTION_FLAG, .value = &hand->up},
                                 {.name = "--only", .kind = OPTION_NAMES, .value = &options.only},
                                 {.name = "--hints", .kind = OPTION_CHOICE, .value = &hints, .choices = known_hints},
                                 {.name = "--view", .kind = OPTION_TEXT, .value = &view},
                                 {.name = "--poses", .kind = OPTION_TEXT, .value = &poses},
                                 {.name = "--all", .kind = OPTION_FLAG, .value = &all},
                                 {.name = "--rig", .kind = OPTION_FLAG, .value = &options.rig},
                                 {.name = "--no-clips", .kind = OPTION_FLAG, .value = &options.no_clips},
                                 {.name = "--cameras", .kind = OPTION_INTEGER, .value = &options.cameras},
                                 {.name = "--given-joint", .kind = OPTION_FLAG, .value = &options.given_only}};
    int status = options_read(command, argc, argv, table, sizeof table / sizeof *table, &folder);
    if (status != CLI_OK) return status;
    if (folder == NULL) return options_refuse(command, "which folder?");
    if (!read_sight(view, &options.sight)) return options_refuse(command, "--view end-on, above or behind");
    if (options.rig && (all || hand->regrab)) return options_refuse(command, "--rig, without --all and --regrab");
    if (options.rig) hand->naive = 1;
    if (check(command, &options) != CLI_OK) return CLI_USAGE;
    options.hints = eval_hints_of(hints);
    if (hand->naive && poses != NULL) return options_refuse(command, "--naive writes no poses");
    if (poses != NULL && options_check_output(command, "--poses", poses, ".jsonl") != CLI_OK) return CLI_USAGE;
    if (all && (poses != NULL || !is_plain(&options)))
        return options_refuse(command, "--all has hands and views of its own, and writes no poses");
    status = run_session(folder, models, poses, &options, all, as_json);
    name_list_free(&options.only);
    return status;
}
