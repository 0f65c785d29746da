/* dragmesh eval: scores the library on a folder of objects whose joints are known. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate.h"
#include "json.h"
#include "runs.h"
#include "session_open.h"

/* One reported figure: name, metric, joints, and which statistic is reported. */
typedef struct figure {
    const char* name;
    enum metric metric;
    int of;       /* 0: all joints, 1: turning, 2: sliding */
    double below; /* > 0: the share of joints below it; 0: all statistics; < 0: the mean alone */
    double factor;
} figure;

static const figure figures[] = {
    {"type_acc", METRIC_TYPE, 0, -1, 1},
    {"type_acc_revolute", METRIC_TYPE, 1, -1, 1},
    {"type_acc_prismatic", METRIC_TYPE, 2, -1, 1},
    {"axis_mrad", METRIC_AXIS, 0, 0, 1},
    {"axis_mrad_revolute", METRIC_AXIS, 1, 0, 1},
    {"axis_mrad_prismatic", METRIC_AXIS, 2, 0, 1},
    {"axis_within_45mrad", METRIC_AXIS, 0, 45 /* mrad */, 1},
    {"origin_e3", METRIC_ORIGIN, 1, 0, 1},
    {"origin_l1_e3", METRIC_ORIGIN_L1, 1, 0, 1},
    {"axis_line_e3", METRIC_LINE, 1, 0, 1},
    {"pose_e3", METRIC_POSE, 0, 0, 1e3},
    {"pose_under_2pct", METRIC_POSE, 0, METRICS_RIGHT, 1},
    {"pose_under_2pct_top3", METRIC_POSE_TOP3, 0, METRICS_RIGHT, 1},
    {"sign_acc", METRIC_SIGN, 0, -1, 1},
    {"range_iou", METRIC_RANGE, 0, 0, 1},
    {"mask_iou", METRIC_MASK, 0, 0, 1},
    {"mask_found", METRIC_MASK_FOUND, 0, -1, 1},
    {"confidence", METRIC_CONFIDENCE, 0, -1, 1},
    {"motion_cd", METRIC_CHAMFER, 0, 0, 1},
    {"motion_axis_constraint", METRIC_CONSTRAINT, 0, 0, 1},
    {"motion_qr1", METRIC_SLIDE_TURN, 2, 0, 1},
    {"motion_rev_trans", METRIC_TURN_SLIDE, 1, 0, 1},
};
enum { FIGURES = sizeof figures / sizeof *figures };

typedef struct group {
    const char* name;
    unsigned char* pick; /* one a row */
} group;

/* The rows of the group that the figure is taken of. */
static unsigned char* pick_for(const eval_rows* rows, const unsigned char* pick, int of) {
    unsigned char* out = cli_alloc(rows->count);
    for (size_t i = 0; i < rows->count; i++)
        out[i] = (pick == NULL || pick[i]) && (of == 0 || (of == 2) == (rows->rows[i].slides != 0));
    return out;
}

static double share_of(const eval_rows* rows, const unsigned char* pick, const figure* what) {
    if (what->below > 0) return metrics_share_below(rows->rows, rows->count, pick, what->metric, what->below);
    return metrics_stat(rows->rows, rows->count, pick, what->metric).mean;
}

static void figure_to_json(const eval_rows* rows, const unsigned char* group, const figure* what, cJSON* out) {
    unsigned char* pick = pick_for(rows, group, what->of);
    if (what->below != 0) {
        json_add_number(out, what->name, share_of(rows, pick, what), 6);
    } else {
        const metric_stat stat = metrics_stat(rows->rows, rows->count, pick, what->metric);
        cJSON* item = cJSON_AddObjectToObject(out, what->name);
        cJSON_AddNumberToObject(item, "n", (double)stat.count);
        json_add_number(item, "mean", stat.mean * what->factor, 6);
        json_add_number(item, "median", stat.median * what->factor, 6);
        json_add_number(item, "p90", stat.p90 * what->factor, 6);
    }
    free(pick);
}

static void summary_to_json(const eval_rows* rows, const unsigned char* pick, cJSON* out) {
    int joints = 0, answered = 0;
    for (size_t i = 0; i < rows->count; i++) {
        if (pick != NULL && !pick[i]) continue;
        joints++;
        answered += rows->rows[i].answered;
    }
    cJSON_AddNumberToObject(out, "joints", joints);
    cJSON_AddNumberToObject(out, "answered", answered);
    for (int i = 0; i < FIGURES; i++) figure_to_json(rows, pick, &figures[i], out);
    json_add_number(out, "calibration_error", metrics_calibrate(rows->rows, rows->count, pick).error, 6);
}

/* Reliability diagram: for each bin of stated confidence, the share of right answers. */
static void bins_to_json(const eval_rows* rows, cJSON* out) {
    const metric_calibration found = metrics_calibrate(rows->rows, rows->count, NULL);
    for (int bin = 0; bin < METRICS_BINS; bin++) {
        if (!(found.weight[bin] > 0)) continue;
        cJSON* item = cJSON_CreateObject();
        json_add_number(item, "stated", found.stated[bin], 4);
        json_add_number(item, "right", found.right[bin], 4);
        json_add_number(item, "share", found.weight[bin], 4);
        cJSON_AddItemToArray(out, item);
    }
}

static const char* source_of(const metric_row* row) {
    return row->source;
}

static const char* category_of(const metric_row* row) {
    return row->category;
}

static int by_group_name(const void* a, const void* b) {
    return strcmp(((const group*)a)->name, ((const group*)b)->name);
}

/* Groups the rows by `key`, sorted by name. */
static group* make_groups(const eval_rows* rows, const char* (*key)(const metric_row*), size_t* out_count) {
    group* groups = cli_alloc(rows->count * sizeof *groups);
    size_t count = 0;
    for (size_t i = 0; i < rows->count; i++) {
        size_t g = 0;
        while (g < count && strcmp(groups[g].name, key(&rows->rows[i])) != 0) g++;
        if (g == count) groups[count++] = (group){key(&rows->rows[i]), cli_alloc_zeroed(rows->count)};
        groups[g].pick[i] = 1;
    }
    if (count) qsort(groups, count, sizeof *groups, by_group_name);
    *out_count = count;
    return groups;
}

static void free_groups(group* groups, size_t count) {
    for (size_t g = 0; g < count; g++) free(groups[g].pick);
    free(groups);
}

static void groups_to_json(const eval_rows* rows, const char* (*key)(const metric_row*), cJSON* out) {
    size_t count;
    group* groups = make_groups(rows, key, &count);
    for (size_t g = 0; g < count; g++)
        summary_to_json(rows, groups[g].pick, cJSON_AddObjectToObject(out, groups[g].name));
    free_groups(groups, count);
}

static void print_json(const eval_rows* rows, double seconds) {
    cJSON* out = cJSON_CreateObject();
    summary_to_json(rows, NULL, out);
    json_add_number(out, "wall_s", seconds, 5);
    bins_to_json(rows, cJSON_AddArrayToObject(out, "reliability"));
    groups_to_json(rows, source_of, cJSON_AddObjectToObject(out, "by_source"));
    groups_to_json(rows, category_of, cJSON_AddObjectToObject(out, "by_category"));
    json_print(out);
}

/* ---- text output ---- */

static void print_groups(const eval_rows* rows, const char* title, const char* (*key)(const metric_row*)) {
    size_t count;
    group* groups = make_groups(rows, key, &count);
    printf("%-22s %6s %6s %10s %10s %10s %9s\n", title, "joints", "type", "axis med", "axis mean", "origin med",
           "pose<2%");
    for (size_t g = 0; g < count; g++) {
        const unsigned char* pick = groups[g].pick;
        const metric_stat type = metrics_stat(rows->rows, rows->count, pick, METRIC_TYPE);
        const metric_stat axis = metrics_stat(rows->rows, rows->count, pick, METRIC_AXIS);
        const metric_stat origin = metrics_stat(rows->rows, rows->count, pick, METRIC_ORIGIN);
        printf("%-22.22s %6zu %6.3f %10.1f %10.1f %10.1f %9.3f\n", groups[g].name, type.count, type.mean, axis.median,
               axis.mean, origin.median,
               metrics_share_below(rows->rows, rows->count, pick, METRIC_POSE, METRICS_RIGHT));
    }
    free_groups(groups, count);
    printf("\n");
}

static void print_text(const eval_rows* rows, double seconds) {
    print_groups(rows, "category", category_of);
    print_groups(rows, "source", source_of);
    size_t answered = 0;
    for (size_t i = 0; i < rows->count; i++) answered += (size_t)rows->rows[i].answered;
    printf("%-24s %zu of %zu in %.1f s\n", "answered", answered, rows->count, seconds);
    for (int i = 0; i < FIGURES; i++) {
        unsigned char* pick = pick_for(rows, NULL, figures[i].of);
        const metric_stat stat = metrics_stat(rows->rows, rows->count, pick, figures[i].metric);
        const double k = figures[i].factor;
        if (figures[i].below != 0)
            printf("%-24s %.4f\n", figures[i].name, share_of(rows, pick, &figures[i]));
        else if (stat.count > 0)
            printf("%-24s mean %.6g  median %.6g  p90 %.6g  (%zu)\n", figures[i].name, stat.mean * k, stat.median * k,
                   stat.p90 * k, stat.count);
        free(pick);
    }
    const metric_calibration found = metrics_calibrate(rows->rows, rows->count, NULL);
    printf("%-24s %.4f\n\n%8s %8s %8s\n", "calibration_error", found.error, "stated", "right", "share");
    for (int bin = 0; bin < METRICS_BINS; bin++)
        if (found.weight[bin] > 0)
            printf("%8.3f %8.3f %8.3f\n", found.stated[bin], found.right[bin], found.weight[bin]);
}

static int by_pose(const void* a, const void* b) {
    const metric_row *left = a, *right = b;
    const double x = left->value[METRIC_POSE], y = right->value[METRIC_POSE];
    return x > y ? -1 : x < y;
}

static void print_worst(eval_rows* rows, int count, FILE* out) {
    if (rows->count) qsort(rows->rows, rows->count, sizeof *rows->rows, by_pose);
    for (size_t i = 0; i < rows->count && i < (size_t)count; i++) {
        const metric_row* row = &rows->rows[i];
        const double origin = isnan(row->value[METRIC_ORIGIN]) ? 0 : row->value[METRIC_ORIGIN];
        fprintf(out, "%8.1f  axis %7.1f  %s -> %-10s  origin %7.1f  %-16s %s\n", row->value[METRIC_POSE] * 1e3,
                row->value[METRIC_AXIS], row->slides ? "slides" : "turns ", row->found_type, origin, row->category,
                row->id);
    }
}

/* ---- the command ---- */

static int evaluate(session* session, const char* folder, const eval_options* options, int as_json, int worst) {
    name_list names = dataset_list(folder, "joints.json");
    if (names.count == 0) {
        fprintf(stderr, "dragmesh eval: '%s' has no folders with a joints.json\n", folder);
        return CLI_USAGE;
    }
    eval_rows rows = {NULL, 0, 0};
    random_state random = {options->has_turn ? (uint64_t)options->turn_seed : 1};
    int status = CLI_OK;
    const double start = cli_now_ms();
    for (unsigned i = 0; i < names.count; i++)
        if (evaluate_object(session, folder, names.names[i], options, &random, &rows) != 0) status = CLI_FAILED;
    const double seconds = (cli_now_ms() - start) * 1e-3;
    for (size_t i = 0; i < rows.count; i++)
        if (!rows.rows[i].answered) status = CLI_FAILED;
    if (as_json)
        print_json(&rows, seconds);
    else
        print_text(&rows, seconds);
    print_worst(&rows, worst, as_json ? stderr : stdout);
    free(rows.rows);
    name_list_free(&names);
    return status;
}

/* Returns METHOD_* of a name; -1 for an unknown one. */
static int read_method(const char* name) {
    static const char* const names[] = {"full", "kpp", "geometry", "rules"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++)
        if (strcmp(name, names[i]) == 0) return i;
    return -1;
}

static int check(const cli_command* command, const char* folder, const char* baseline, const eval_options* options) {
    if (folder == NULL) return options_refuse(command, "which folder?");
    if (options->pull == PULL_KINDS) return options_refuse(command, "--pull: exact, chord or axis");
    if (read_method(baseline) < 0) return options_refuse(command, "--baseline: full, kpp, geometry or rules");
    if (options->lies < 0 || options->lies > 1) return options_refuse(command, "--lies: 0 to 1");
    if (options->drags < 1 || options->drag_noise < 0 || options->mask_noise < 0 || options->mask_noise >= 1)
        return options_refuse(command, "--drags from 1, --drag-noise from 0, --mask-noise in [0, 1)");
    if (options->alone && options->mask_noise > 0)
        return options_refuse(command, "--alone: the mask is the whole mesh, and takes no --mask-noise");
    return CLI_OK;
}

int eval_run(const cli_command* command, int argc, char** argv) {
    const char *folder = NULL, *models = NULL, *baseline = "full", *pictures = NULL, *moving = NULL, *pull = "exact",
               *hints = "";
    static const char* const hint_choices[] = {"names", "pivots", "both", NULL};
    int as_json = 0, worst = 0, no_hints = 0;
    eval_options options = {.drags = 1};
    error_report report;
    const option_spec table[] = {
        {.name = "--models", .kind = OPTION_TEXT, .value = &models},
        {.name = "--json", .kind = OPTION_FLAG, .value = &as_json},
        {.name = "--worst", .kind = OPTION_INTEGER, .value = &worst},
        {.name = "--drags", .kind = OPTION_INTEGER, .value = &options.drags},
        {.name = "--no-drag", .kind = OPTION_FLAG, .value = &options.no_drag},
        {.name = "--given-type", .kind = OPTION_FLAG, .value = &options.given_type},
        {.name = "--pull", .kind = OPTION_TEXT, .value = &pull},
        {.name = "--hints", .kind = OPTION_CHOICE, .value = &hints, .choices = hint_choices},
        {.name = "--no-hints", .kind = OPTION_FLAG, .value = &no_hints},
        {.name = "--lies", .kind = OPTION_NUMBER, .value = &options.lies},
        {.name = "--drag-noise", .kind = OPTION_NUMBER, .value = &options.drag_noise},
        {.name = "--mask-noise", .kind = OPTION_NUMBER, .value = &options.mask_noise},
        {.name = "--turn", .kind = OPTION_SEED, .value = &options.turn_seed, .given = &options.has_turn},
        {.name = "--alone", .kind = OPTION_FLAG, .value = &options.alone},
        {.name = "--moving", .kind = OPTION_TEXT, .value = &moving},
        {.name = "--merge", .kind = OPTION_FLAG, .value = &options.merged},
        {.name = "--baseline", .kind = OPTION_TEXT, .value = &baseline},
        {.name = "--mistakes", .kind = OPTION_TEXT, .value = &pictures}};
    session session;
    int status = options_read(command, argc, argv, table, sizeof table / sizeof *table, &folder);
    options.pull = pull_kind_of(pull);
    options.hints = no_hints ? 0 : eval_hints_of(hints);
    options.find_part = moving != NULL && strcmp(moving, "auto") == 0;
    if (status == CLI_OK && moving != NULL && !options.find_part) status = options_refuse(command, "--moving: auto");
    if (status == CLI_OK) status = check(command, folder, baseline, &options);
    if (status == CLI_OK) status = session_open_method(&session, models, (enum session_method)read_method(baseline));
    if (status != CLI_OK) return status;
    if (pictures != NULL && error_report_open(&report, pictures) == 0) options.error_report = &report;
    status = pictures != NULL && options.error_report == NULL ? CLI_FAILED
                                                              : evaluate(&session, folder, &options, as_json, worst);
    if (options.error_report != NULL && error_report_close(&report) != 0) status = CLI_FAILED;
    session_close(&session);
    return status;
}
