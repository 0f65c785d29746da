/* dragmesh dragbot: a scripted player on a folder of objects whose joints are known. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dragbot.h"
#include "json.h"
#include "session_open.h"

static int by_time(const void* a, const void* b) {
    const float x = *(const float*)a, y = *(const float*)b;
    return x < y ? -1 : x > y;
}

static double time_at(const bot_times* times, double share) {
    if (times->count == 0) return NAN;
    const size_t at = (size_t)(share * (double)(times->count - 1));
    return (double)times->ns[at];
}

/* Shares of the cases; a figure that was not measured is NAN. */
typedef struct totals {
    double picked, success, success_or_beyond, success_given, reached, near, reached_given, near_given;
    int jumps, changes;
} totals;

static totals sum_up(const bot_score* score, const bot_options* options, int slides) {
    totals t = {0};
    double n = 0;
    for (size_t i = 0; i < score->count; i++) {
        const bot_row* row = &score->rows[i];
        if (slides >= 0 && row->slides != slides) continue;
        n++;
        t.picked += row->given.picked;
        t.success += row->found.success, t.success_given += row->given.success;
        t.success_or_beyond += row->found.success_or_beyond;
        t.reached += row->found.arrived, t.reached_given += row->given.arrived;
        t.near += row->found.near, t.near_given += row->given.near;
        t.jumps += row->found.jumps + row->given.jumps;
        t.changes += row->found.changes;
    }
    double* shares[] = {&t.picked,  &t.success, &t.success_or_beyond, &t.success_given,
                        &t.reached, &t.near,    &t.reached_given,     &t.near_given};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) *shares[i] /= n;
    if (options->given_only) t.success = t.success_or_beyond = t.reached = t.near = NAN;
    return t;
}

static void add_totals(cJSON* out, const totals* t) {
    json_add_number(out, "picked", t->picked, 5);
    json_add_number(out, "success", t->success, 5);
    json_add_number(out, "success_or_beyond", t->success_or_beyond, 5);
    json_add_number(out, "success_given_joint", t->success_given, 5);
    json_add_number(out, "reached", t->reached, 5);
    json_add_number(out, "near", t->near, 5);
    json_add_number(out, "reached_given_joint", t->reached_given, 5);
    json_add_number(out, "near_given_joint", t->near_given, 5);
    cJSON_AddNumberToObject(out, "jumps", t->jumps);
    cJSON_AddNumberToObject(out, "joint_changes", t->changes);
}

static void print_json(const bot_score* score, const bot_options* options) {
    cJSON* out = cJSON_CreateObject();
    const totals all = sum_up(score, options, -1), turns = sum_up(score, options, 0),
                 slides = sum_up(score, options, 1);
    cJSON_AddNumberToObject(out, "cases", (double)score->count);
    add_totals(out, &all);
    json_add_number(out, "p99_update_ns", time_at(&score->times, 0.99), 4);
    json_add_number(out, "median_update_ns", time_at(&score->times, 0.5), 4);
    json_add_number(out, "worst_update_ns", time_at(&score->times, 1), 4);
    cJSON_AddNumberToObject(out, "updates", (double)score->times.count);
    cJSON_AddNumberToObject(out, "hidden", score->unseen);
    cJSON_AddNumberToObject(out, "undrawable", score->undrawable);
    cJSON_AddNumberToObject(out, "failed", score->failed);
    add_totals(cJSON_AddObjectToObject(out, "turning"), &turns);
    add_totals(cJSON_AddObjectToObject(out, "sliding"), &slides);
    json_print(out);
}

static void print_line(const char* name, const totals* t) {
    printf(
        "%-8s picked %.4f  success %.4f (or beyond %.4f, reached %.4f, near %.4f)  true joint %.4f (reached %.4f, near "
        "%.4f)  jumps %d\n",
        name, t->picked, t->success, t->success_or_beyond, t->reached, t->near, t->success_given, t->reached_given,
        t->near_given, t->jumps);
}

static void print_text(const bot_score* score, const bot_options* options) {
    const totals all = sum_up(score, options, -1), turns = sum_up(score, options, 0),
                 slides = sum_up(score, options, 1);
    printf("%zu cases; %d views hid the part, in %d its way was too short or left the screen; %d failed\n",
           score->count, score->unseen, score->undrawable, score->failed);
    print_line("all", &all);
    print_line("turning", &turns);
    print_line("sliding", &slides);
    printf("the pull changed the joint %d times\n", all.changes);
    printf("drag_update: median %.0f ns, p99 %.0f ns, worst %.0f ns of %zu\n", time_at(&score->times, 0.5),
           time_at(&score->times, 0.99), time_at(&score->times, 1), score->times.count);
}

static void print_result(const char* name, const bot_result* r, FILE* out) {
    fprintf(out, "  %s: %s reached %6.3f off %.3f jumps %d (%.0f px) changes %d joint %d p %.2f [%.2f, %.2f]\n", name,
            r->success ? "ok  " : "FAIL", r->reached, r->off, r->jumps, r->worst_jump, r->changes, r->joint.type,
            (double)r->joint.joint_confidence, (double)r->joint.lower, (double)r->joint.upper);
}

static void print_failures(const bot_score* score, const bot_options* options, FILE* out) {
    int left = options->worst;
    for (size_t i = 0; i < score->count && left > 0; i++) {
        const bot_row* row = &score->rows[i];
        if (row->given.success && (options->given_only || row->found.success)) continue;
        fprintf(out, "%s %s, grab %d %d, asked %.3f, path %.0f px%s\n", row->id, row->slides ? "slides" : "turns",
                row->pull.x, row->pull.y, row->pull.asked, row->pull.length, row->given.picked ? "" : ", NOT PICKED");
        if (!options->given_only) print_result("found", &row->found, out);
        print_result("given", &row->given, out);
        left--;
    }
}

static int play(session* session, const char* folder, const bot_options* options, int as_json) {
    name_list names = dataset_list(folder);
    if (names.count == 0) {
        fprintf(stderr, "dragmesh dragbot: '%s' has no folders with a joints.json\n", folder);
        return CLI_USAGE;
    }
    bot_score score = {0};
    for (unsigned i = 0; i < names.count; i++) bot_play_object(session, folder, names.names[i], options, &score);
    if (score.times.count) qsort(score.times.ns, score.times.count, sizeof *score.times.ns, by_time);
    if (as_json)
        print_json(&score, options);
    else
        print_text(&score, options);
    print_failures(&score, options, as_json ? stderr : stdout);
    const int status = score.failed ? CLI_FAILED : CLI_OK;
    free(score.rows);
    free(score.times.ns);
    name_list_free(&names);
    return status;
}

static int run(int argc, char** argv) {
    const char *folder = NULL, *models = NULL;
    int as_json = 0;
    bot_options options = {.cameras = 4};
    const option_spec table[] = {{.name = "--models", .kind = OPTION_TEXT, .value = &models},
                                 {.name = "--json", .kind = OPTION_FLAG, .value = &as_json},
                                 {.name = "--worst", .kind = OPTION_INTEGER, .value = &options.worst},
                                 {.name = "--straight", .kind = OPTION_FLAG, .value = &options.hand.straight},
                                 {.name = "--wander", .kind = OPTION_NUMBER, .value = &options.hand.wander},
                                 {.name = "--tremor", .kind = OPTION_NUMBER, .value = &options.hand.tremor},
                                 {.name = "--cameras", .kind = OPTION_INTEGER, .value = &options.cameras},
                                 {.name = "--given-joint", .kind = OPTION_FLAG, .value = &options.given_only}};
    session session;
    int status = options_read(&cli_dragbot, argc, argv, table, sizeof table / sizeof *table, &folder);
    if (status == CLI_OK && folder == NULL) status = options_refuse(&cli_dragbot, "which folder?");
    if (status == CLI_OK && options.cameras < 1) status = options_refuse(&cli_dragbot, "--cameras from 1");
    if (status == CLI_OK) status = session_open(&session, models, NULL);
    if (status != CLI_OK) return status;
    status = play(&session, folder, &options, as_json);
    session_close(&session);
    return status;
}

const cli_command cli_dragbot = {
    "dragbot", run,
    "DIR [--cameras N] [--straight] [--wander SHARE] [--tremor PIXELS] [--given-joint] [--worst N] [--json]",
    "A scripted player on a folder of object.glb + joints.json: picks and drags every part, and scores the feel."};
