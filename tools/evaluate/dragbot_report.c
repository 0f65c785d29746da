/* What the scripted player found: figures for machines, lines for people, the worst cases, a table of hands. */
#include <math.h>
#include <stdlib.h>

#include "dragbot_naive_report.h"
#include "timing.h"

static const double through_share = 0.01; /* of the object's size: the part goes through the body; by hand */

static double time_at(const bot_times* times, double share) {
    if (times->count == 0) return NAN;
    const size_t at = (size_t)(share * (double)(times->count - 1));
    return (double)times->ns[at];
}

/* Shares of the cases; a figure that was not measured is NAN. */
typedef struct totals {
    double picked, success, success_or_beyond, reached, near;
    double success_given, success_or_beyond_given, reached_given, near_given;
    int jumps, changes;
    /* Not part of the verdict, for the joint found and for the true one. */
    double stuck[2], through[2], still_moved[2], regrab_jump[2], regrab_jumped[2], own_way[2];
} totals;

static void add_result(totals* t, const bot_result* result, int given, double* regrabs) {
    t->stuck[given] += result->stuck;
    t->through[given] += result->through > through_share;
    t->own_way[given] += result->own_way;
    t->still_moved[given] += result->still_moved;
    t->regrab_jump[given] = fmax(t->regrab_jump[given], result->worst_regrab);
    t->regrab_jumped[given] += result->regrab_jumps;
    *regrabs += result->regrabs;
}

/* Makes shares of the sums; NAN where nothing was measured. */
static void finish(totals* t, const bot_options* options, int given, double cases, double regrabs) {
    const bool measured = given || !options->given_only;
    t->stuck[given] = measured ? t->stuck[given] / cases : NAN;
    t->through[given] = measured ? t->through[given] / cases : NAN;
    t->still_moved[given] = measured && options->hand.offset > 0 ? t->still_moved[given] / cases : NAN;
    t->regrab_jumped[given] = measured ? t->regrab_jumped[given] / regrabs : NAN; /* 0 / 0 without regrabs */
    if (!measured || options->hand.regrab <= 0) t->regrab_jump[given] = NAN;
    t->own_way[given] = measured && options->sight == BOT_END_ON ? t->own_way[given] / cases : NAN;
}

static totals sum_up(const bot_run* run, int slides) {
    const bot_score* score = &run->score;
    const bot_options* options = &run->options;
    totals t = {0};
    double n = 0, regrabs[2] = {0, 0};
    for (size_t i = 0; i < score->count; i++) {
        const bot_row* row = &score->rows[i];
        if (slides >= 0 && row->slides != slides) continue;
        n++;
        t.picked += row->given.picked;
        t.success += row->found.success, t.success_given += row->given.success;
        t.success_or_beyond += row->found.success_or_beyond;
        t.success_or_beyond_given += row->given.success_or_beyond;
        t.reached += row->found.arrived, t.reached_given += row->given.arrived;
        t.near += row->found.near, t.near_given += row->given.near;
        t.jumps += row->found.jumps + row->given.jumps;
        t.changes += row->found.changes;
        add_result(&t, &row->found, 0, &regrabs[0]);
        add_result(&t, &row->given, 1, &regrabs[1]);
    }
    double* shares[] = {&t.picked,  &t.success, &t.success_or_beyond, &t.success_given, &t.success_or_beyond_given,
                        &t.reached, &t.near,    &t.reached_given,     &t.near_given};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) *shares[i] /= n;
    for (int given = 0; given < 2; given++) finish(&t, options, given, n, regrabs[given]);
    if (options->given_only) t.success = t.success_or_beyond = t.reached = t.near = NAN;
    return t;
}

/* Adds a figure for the joint found and for the true one. */
static void add_pair(cJSON* out, const char* name, const double pair[2]) {
    char given[64];
    snprintf(given, sizeof given, "%s_given_joint", name);
    json_add_number(out, name, pair[0], 5);
    json_add_number(out, given, pair[1], 5);
}

static void add_totals(cJSON* out, const totals* t) {
    json_add_number(out, "picked", t->picked, 5);
    json_add_number(out, "success", t->success, 5);
    json_add_number(out, "success_or_beyond", t->success_or_beyond, 5);
    json_add_number(out, "success_given_joint", t->success_given, 5);
    json_add_number(out, "success_or_beyond_given_joint", t->success_or_beyond_given, 5);
    json_add_number(out, "reached", t->reached, 5);
    json_add_number(out, "near", t->near, 5);
    json_add_number(out, "reached_given_joint", t->reached_given, 5);
    json_add_number(out, "near_given_joint", t->near_given, 5);
    cJSON_AddNumberToObject(out, "jumps", t->jumps);
    cJSON_AddNumberToObject(out, "joint_changes", t->changes);
    add_pair(out, "stuck", t->stuck);
    add_pair(out, "through_body", t->through);
    add_pair(out, "offset_still_moved", t->still_moved);
    add_pair(out, "regrab_jump", t->regrab_jump);
    add_pair(out, "regrab_jumped", t->regrab_jumped);
    add_pair(out, "own_way", t->own_way);
}

static cJSON* figures(const bot_run* run) {
    const bot_score* score = &run->score;
    cJSON* out = cJSON_CreateObject();
    const bool naive = run->options.hand.naive;
    const totals all = sum_up(run, -1), turns = sum_up(run, 0), slides = sum_up(run, 1);
    cJSON_AddNumberToObject(out, "cases", (double)(naive ? score->pull_count : score->count));
    if (naive)
        bot_naive_add_figures(run, out);
    else
        add_totals(out, &all);
    json_add_number(out, "p99_update_ns", time_at(&score->times, 0.99), 4);
    json_add_number(out, "median_update_ns", time_at(&score->times, 0.5), 4);
    json_add_number(out, "worst_update_ns", time_at(&score->times, 1), 4);
    cJSON_AddStringToObject(out, "isa", timing_isa());
    cJSON_AddNumberToObject(out, "updates", (double)score->times.count);
    cJSON_AddNumberToObject(out, "hidden", score->unseen);
    cJSON_AddNumberToObject(out, "undrawable", score->undrawable);
    cJSON_AddNumberToObject(out, "failed", score->failed);
    if (naive) return out;
    add_totals(cJSON_AddObjectToObject(out, "turning"), &turns);
    add_totals(cJSON_AddObjectToObject(out, "sliding"), &slides);
    return out;
}

void bot_report_json(const bot_run* run) {
    json_print(figures(run));
}

static void print_line(const char* name, const totals* t) {
    printf(
        "%-8s picked %.4f  success %.4f (or beyond %.4f, reached %.4f, near %.4f)  true joint %.4f (reached %.4f, near "
        "%.4f)  jumps %d\n",
        name, t->picked, t->success, t->success_or_beyond, t->reached, t->near, t->success_given, t->reached_given,
        t->near_given, t->jumps);
}

/* Prints what an option of the hand measures, for the joint found and the true one. */
static void print_pair(const char* what, const double pair[2]) {
    if (isfinite(pair[0]) || isfinite(pair[1])) printf("%s %.4f  true joint %.4f\n", what, pair[0], pair[1]);
}

static void print_hand(const totals* t) {
    print_pair("stuck", t->stuck);
    print_pair("through the body", t->through);
    print_pair("on its own way at the end", t->own_way);
    print_pair("moved while the pointer rested beside the grabbed point", t->still_moved);
    print_pair("new grabs that jump by over 1 % of the size", t->regrab_jumped);
    print_pair("largest jump at a new grab, sizes", t->regrab_jump);
}

static void print_times(const bot_times* times) {
    printf("drag_update, %s: median %.0f ns, p99 %.0f ns, worst %.0f ns of %zu\n", timing_isa(), time_at(times, 0.5),
           time_at(times, 0.99), time_at(times, 1), times->count);
}

static void print_text(const bot_run* run) {
    const bot_score* score = &run->score;
    const totals all = sum_up(run, -1), turns = sum_up(run, 0), slides = sum_up(run, 1);
    printf("%zu cases; %d views hid the part, in %d its way was too short or left the screen; %d failed\n",
           score->count, score->unseen, score->undrawable, score->failed);
    print_line("all", &all);
    print_line("turning", &turns);
    print_line("sliding", &slides);
    printf("the pull changed the joint %d times\n", all.changes);
    print_hand(&all);
}

void bot_report_text(const bot_run* run) {
    if (run->options.hand.naive)
        bot_naive_print_text(run);
    else
        print_text(run);
    print_times(&run->score.times);
}

static void print_result(const char* name, const bot_result* r, FILE* out) {
    fprintf(out, "  %s: %s reached %6.3f off %.3f jumps %d (%.0f px) changes %d joint %d p %.2f [%.2f, %.2f]\n", name,
            r->success ? "ok  " : "FAIL", r->reached, r->off, r->jumps, r->worst_jump, r->changes, r->end.joint.type,
            (double)r->end.joint.joint_confidence, (double)r->end.joint.lower, (double)r->end.joint.upper);
}

static void print_failures(const bot_run* run, FILE* out) {
    const bot_score* score = &run->score;
    const bot_options* options = &run->options;
    int left = options->worst;
    for (size_t i = 0; i < score->count && left > 0; i++) {
        const bot_row* row = &score->rows[i];
        if (row->given.success && (options->given_only || row->found.success)) continue;
        fprintf(out, "%s %s, grab %d %d, asked %.3f, path %.0f px%s\n", row->id, row->slides ? "slides" : "turns",
                row->x, row->y, row->asked, row->length, row->given.picked ? "" : ", NOT PICKED");
        if (!options->given_only) print_result("found", &row->found, out);
        print_result("given", &row->given, out);
        left--;
    }
}

/* ---- through the body ---- */

static int by_depth(const void* a, const void* b) {
    const bot_row *x = *(bot_row*const*)a, *y = *(bot_row*const*)b;
    const double p = fmax(x->found.through, x->given.through), q = fmax(y->found.through, y->given.through);
    return p < q ? 1 : -(p > q);
}

static void print_deepest(const bot_run* run, FILE* out) {
    const bot_score* score = &run->score;
    const bot_row** rows = cli_alloc((score->count + 1) * sizeof(void*));
    size_t count = 0;
    for (size_t i = 0; i < score->count; i++) {
        const bot_row* row = &score->rows[i];
        if (fmax(row->found.through, row->given.through) > through_share) rows[count++] = row;
    }
    qsort(rows, count, sizeof(void*), by_depth);
    for (size_t i = 0; i < count && i < (size_t)run->options.worst; i++)
        fprintf(out, "%s %s through the body by %.3f sizes, with the true joint %.3f\n", rows[i]->id,
                rows[i]->slides ? "slides" : "turns", rows[i]->found.through, rows[i]->given.through);
    free(rows);
}

void bot_report_failures(const bot_run* run, FILE* out) {
    if (run->options.hand.naive) {
        bot_naive_print_worst(run, out);
        return;
    }
    print_failures(run, out);
    print_deepest(run, out);
}

/* ---- table ---- */

static void print_cell(double figure, int width) {
    if (isfinite(figure))
        printf(" %*.4f", width, figure);
    else
        printf(" %*s", width, "");
}

static void print_row(const bot_run* run) {
    const totals all = sum_up(run, -1), turns = sum_up(run, 0), slides = sum_up(run, 1);
    printf("%-16s %6zu", run->name, run->score.count);
    const double cells[] = {
        all.success,    all.success_or_beyond, turns.success_or_beyond,     slides.success_or_beyond,
        all.stuck[0],   all.through[0],        all.still_moved[0],          all.regrab_jumped[0],
        all.own_way[0], all.success_given,     all.success_or_beyond_given, all.stuck[1],
        all.through[1]};
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) print_cell(cells[i], 8);
    printf("\n");
}

void bot_report_table(const bot_run* runs, int count, bool as_json) {
    static const char* const heads[] = {"success", "beyond",  "turning", "sliding",  "stuck",   "through", "rested",
                                        "regrab",  "own way", "true",    "t.beyond", "t.stuck", "t.thro."};
    cJSON* rows = cJSON_CreateArray();
    if (!as_json) {
        printf("%-16s %6s", "hand", "cases");
        for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) printf(" %8s", heads[i]);
        printf("\n");
    }
    for (int i = 0; i < count; i++) {
        if (!as_json && !runs[i].options.hand.naive) print_row(&runs[i]);
        if (!as_json) continue;
        cJSON* row = figures(&runs[i]);
        cJSON_AddStringToObject(row, "hand", runs[i].name);
        cJSON_AddItemToArray(rows, row);
    }
    if (!as_json) bot_naive_print_table(runs, count);
    if (as_json)
        json_print(rows);
    else
        cJSON_Delete(rows);
}
