/* Figures of the naive hand. Every joint counts by its weight in the dataset, divided among its pulls. */
#include "dragbot_naive_report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "metrics.h"

static const double moved_share = 0.15; /* of what the true joint would have moved: the part has moved; by hand */
static const double sure = 0.8;         /* a stated confidence that a player trusts; by hand */

/* ---- what is asked of a pull ---- */

typedef double (*question)(const bot_naive_row* row, const bot_naive_end* end);

static double any(const bot_naive_row* row, const bot_naive_end* end) {
    return row != NULL && end != NULL;
}
static double was_right(const bot_naive_row* row, const bot_naive_end* end) {
    (void)end;
    return row->before == BOT_RIGHT;
}
static double was_wrong(const bot_naive_row* row, const bot_naive_end* end) {
    (void)end;
    return row->before != BOT_RIGHT;
}
static double turns(const bot_naive_row* row, const bot_naive_end* end) {
    (void)end;
    return row->turns;
}
static double slides(const bot_naive_row* row, const bot_naive_end* end) {
    (void)end;
    return !row->turns;
}
static double was_right_turn(const bot_naive_row* row, const bot_naive_end* end) {
    (void)end;
    return row->turns && row->before == BOT_RIGHT;
}
static double is_right(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong == BOT_RIGHT;
}
static double is_wrong(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong != BOT_RIGHT;
}
static double has_wrong_type(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong == BOT_WRONG_TYPE;
}
static double has_wrong_axis(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong == BOT_WRONG_AXIS;
}
static double has_wrong_line(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong == BOT_WRONG_LINE;
}
static double is_slide(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->slides;
}
static double has_moved(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->share >= moved_share;
}
static double succeeds(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->wrong == BOT_RIGHT && end->share >= moved_share;
}
static double is_sure(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->confidence >= sure;
}
static double confidence_of(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->confidence;
}
static double changes_of(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->changes;
}
static double jumps_of(const bot_naive_row* row, const bot_naive_end* end) {
    (void)row;
    return end->jumps;
}

/* ---- figures ---- */

/* A mean over the pulls for which `of` holds. */
static const struct {
    const char* name;
    question of, what;
    const char* column; /* in the table; NULL: not there */
} figures[] = {{"before", any, was_right, "before"},
               {"after", any, is_right, "after"},
               {"kept", was_right, is_right, "kept"},
               {"lost", was_right, is_wrong, NULL},
               {"lost_by_type", was_right, has_wrong_type, NULL},
               {"lost_by_axis", was_right, has_wrong_axis, NULL},
               {"lost_by_line", was_right, has_wrong_line, NULL},
               {"lost_turning", was_right_turn, is_wrong, NULL},
               {"turns_to_slides", was_right_turn, is_slide, "t.slide"},
               {"gained", was_wrong, is_right, "gained"},
               {"moved", any, has_moved, "moved"},
               {"success", any, succeeds, "success"},
               {"success_turning", turns, succeeds, "turning"},
               {"success_sliding", slides, succeeds, "sliding"},
               {"joint_changes", any, changes_of, "changes"},
               {"jumps", any, jumps_of, NULL},
               {"confidence_right", is_right, confidence_of, NULL},
               {"confidence_wrong", is_wrong, confidence_of, NULL},
               {"sure_right", is_right, is_sure, "r.sure"},
               {"sure_wrong", is_wrong, is_sure, "w.sure"}};
enum { FIGURES = sizeof figures / sizeof *figures };

/* NAN where there are none. */
static double mean_of(const bot_score* score, int end, question of, question what) {
    double sum = 0, weight = 0;
    for (size_t i = 0; i < score->pull_count; i++) {
        const bot_naive_row* row = &score->pulls[i];
        const double counts = row->weight * of(row, &row->ends[end]);
        sum += counts * what(row, &row->ends[end]), weight += counts;
    }
    return weight > 0 ? sum / weight : NAN;
}

/* Returns how far the stated confidence is from the share of right joints, as `dragmesh eval` computes it. */
static double calibration_error(const bot_score* score, int end) {
    metric_row* rows = cli_alloc_zeroed((score->pull_count + 1) * sizeof *rows);
    for (size_t i = 0; i < score->pull_count; i++) {
        const bot_naive_end* e = &score->pulls[i].ends[end];
        rows[i].weight = score->pulls[i].weight;
        rows[i].value[METRIC_CONFIDENCE] = e->confidence;
        rows[i].value[METRIC_POSE] = e->wrong == BOT_RIGHT ? 0 : 1;
    }
    const double error = metrics_calibrate(rows, score->pull_count, NULL).error;
    free(rows);
    return error;
}

static bool is_series(const bot_run* run) {
    return run->options.hand.regrab > 1;
}

static int count_joints(const bot_score* score) {
    int count = 0;
    for (size_t i = 0; i < score->pull_count; i++)
        count += i == 0 || strcmp(score->pulls[i].id, score->pulls[i - 1].id) != 0;
    return count;
}

static void add_end(const bot_score* score, int end, cJSON* out) {
    for (int i = 0; i < FIGURES; i++)
        json_add_number(out, figures[i].name, mean_of(score, end, figures[i].of, figures[i].what), 5);
    json_add_number(out, "calibration_error", calibration_error(score, end), 5);
}

void bot_naive_add_figures(const bot_run* run, cJSON* out) {
    const bot_score* score = &run->score;
    cJSON_AddNumberToObject(out, "joints", count_joints(score));
    add_end(score, BOT_NAIVE_LAST, out);
    add_end(score, BOT_NAIVE_KEPT, cJSON_AddObjectToObject(out, "keep"));
    if (is_series(run)) add_end(score, BOT_NAIVE_FIRST, cJSON_AddObjectToObject(out, "first"));
}

/* ---- text ---- */

static void print_cell(double figure) {
    if (isfinite(figure))
        printf(" %8.4f", figure);
    else
        printf(" %8s", "");
}

static void print_figure(const char* name, const double shown[BOT_NAIVE_ENDS], int count) {
    printf("%-18s", name);
    for (int end = 0; end < count; end++) print_cell(shown[end]);
    printf("\n");
}

void bot_naive_print_text(const bot_run* run) {
    const bot_score* score = &run->score;
    const int ends = is_series(run) ? BOT_NAIVE_ENDS : BOT_NAIVE_FIRST;
    double shown[BOT_NAIVE_ENDS];
    printf("%zu pulls of %d joints; from %d places the part was hidden, %d grabs were left out; %d failed\n",
           score->pull_count, count_joints(score), score->unseen, score->undrawable, score->failed);
    printf("%-18s %8s %8s %8s\n", "", "", "keep", ends > BOT_NAIVE_FIRST ? "1st pull" : "");
    for (int i = 0; i < FIGURES; i++) {
        for (int end = 0; end < ends; end++) shown[end] = mean_of(score, end, figures[i].of, figures[i].what);
        print_figure(figures[i].name, shown, ends);
    }
    for (int end = 0; end < ends; end++) shown[end] = calibration_error(score, end);
    print_figure("calibration_error", shown, ends);
}

static void print_heads(void) {
    printf("\n%-16s %6s", "naive hand", "pulls");
    for (int i = 0; i < FIGURES; i++)
        if (figures[i].column != NULL) printf(" %8s", figures[i].column);
    printf(" %8s %8s %8s\n", "calibr.", "keep", "1st pull");
}

static void print_row(const bot_run* run) {
    const bot_score* score = &run->score;
    printf("%-16s %6zu", run->name, score->pull_count);
    for (int i = 0; i < FIGURES; i++)
        if (figures[i].column != NULL) print_cell(mean_of(score, BOT_NAIVE_LAST, figures[i].of, figures[i].what));
    print_cell(calibration_error(score, BOT_NAIVE_LAST));
    print_cell(mean_of(score, BOT_NAIVE_KEPT, any, succeeds));
    print_cell(is_series(run) ? mean_of(score, BOT_NAIVE_FIRST, any, succeeds) : NAN);
    printf("\n");
}

void bot_naive_print_table(const bot_run* runs, int count) {
    bool headed = false;
    for (int i = 0; i < count; i++) {
        if (!runs[i].options.hand.naive) continue;
        if (!headed) print_heads();
        headed = true;
        print_row(&runs[i]);
    }
}

static int by_confidence_before(const void* a, const void* b) {
    const double x = (*(bot_naive_row*const*)a)->confidence_before, y = (*(bot_naive_row*const*)b)->confidence_before;
    return x < y ? 1 : -(x > y);
}

void bot_naive_print_worst(const bot_run* run, FILE* out) {
    static const char* const wrongs[] = {"right", "type", "axis", "line"};
    const bot_score* score = &run->score;
    const bot_naive_row** lost = cli_alloc((score->pull_count + 1) * sizeof(void*));
    size_t count = 0;
    for (size_t i = 0; i < score->pull_count; i++) {
        const bot_naive_row* row = &score->pulls[i];
        if (row->before == BOT_RIGHT && row->ends[BOT_NAIVE_LAST].wrong != BOT_RIGHT) lost[count++] = row;
    }
    qsort(lost, count, sizeof(void*), by_confidence_before);
    for (size_t i = 0; i < count && i < (size_t)run->options.worst; i++) {
        const bot_naive_end* end = &lost[i]->ends[BOT_NAIVE_LAST];
        fprintf(out, "%s %s, camera %d, grab %d: wrong %s, %s, p %.2f -> %.2f, share %.3f, changes %d\n", lost[i]->id,
                lost[i]->turns ? "turns" : "slides", lost[i]->camera, lost[i]->grab, wrongs[end->wrong],
                end->slides ? "slides" : "turns", lost[i]->confidence_before, end->confidence, end->share,
                end->changes);
    }
    free(lost);
}
