/* Boosted trees learn whom a case's probability belongs to, repeat to the bit, and stay within their rule. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "../../training/lab/boost.h"
#include "base/random.h"
#include "test_lab.h"

enum { CASES = 300, EACH = 6, COLUMNS = 4, ROWS = CASES * EACH, TREES = 60, LEAVES = 8, NODES = 2 * LEAVES - 1 };

static dm_result (*boost)(const dm_lab_rows*, const dm_lab_boost_rule*, void (*)(uint32_t, double),
                          const dm_lab_trees*);

static uint32_t first[CASES + 1];
static uint8_t bins[ROWS][COLUMNS];
static float weights[ROWS], target[ROWS];

typedef struct grown {
    int32_t column[TREES][NODES], bin[TREES][NODES], left[TREES][NODES];
    float score[TREES][NODES];
} grown;
static grown once, again;

static const dm_lab_rows data = {COLUMNS, CASES, first, &bins[0][0], weights, target, NULL};
static const dm_lab_boost_rule rule = {TREES, LEAVES, 4, 0.2f, 1, 0.5f, 0.7f, 1, 3, 0};

static int load_lab(void** state) {
    (void)state;
    void* lab = test_open_lab();
    if (lab == NULL) return -1;
    *(void**)&boost = dlsym(lab, "dm_lab_boost");
    return boost == NULL;
}

/* What a row is worth needs two columns at once; two more mean nothing. */
static int is_high(const uint8_t row[COLUMNS]) {
    return (row[0] > 31) != (row[1] > 15);
}

static void draw_cases(void) {
    dmi_random random = dmi_random_make(11, 1);
    for (uint32_t c = 0; c < CASES; c++) {
        uint32_t high = 0;
        for (uint32_t r = c * EACH; r < (c + 1) * EACH; r++) {
            for (int k = 0; k < COLUMNS; k++) bins[r][k] = (uint8_t)(dmi_random_unit(&random) * DM_LAB_BINS);
            high += is_high(bins[r]) != 0;
        }
        for (uint32_t r = c * EACH; r < (c + 1) * EACH; r++)
            target[r] = high == 0 ? 1.0f / EACH : is_high(bins[r]) ? 1 / (float)high : 0;
        first[c + 1] = (c + 1) * EACH;
    }
}

static dm_lab_trees arrays_of(grown* g) {
    return (dm_lab_trees){&g->column[0][0], &g->bin[0][0], &g->left[0][0], &g->score[0][0]};
}

static float score_of(const grown* g, const uint8_t row[COLUMNS]) {
    float sum = 0;
    for (int t = 0; t < TREES; t++) {
        int n = 0;
        while (g->column[t][n] >= 0) n = g->left[t][n] + (row[g->column[t][n]] > g->bin[t][n]);
        sum += g->score[t][n];
    }
    return sum;
}

static void a_case_goes_to_whom_it_belongs(void** state) {
    (void)state;
    draw_cases();
    const dm_lab_trees out = arrays_of(&once);
    assert_int_equal(boost(&data, &rule, NULL, &out), DM_OK);
    int right = 0;
    for (uint32_t c = 0; c < CASES; c++) {
        uint32_t best = c * EACH;
        for (uint32_t r = best; r < (c + 1) * EACH; r++)
            if (score_of(&once, bins[r]) > score_of(&once, bins[best])) best = r;
        right += target[best] > 0;
    }
    assert_true(right >= CASES * 98 / 100);
}

/* With a probability for each row, the log odds are right on their own: three in four high rows and one in four of the
 * others are targets. */
static void each_row_has_its_own_probability(void** state) {
    (void)state;
    draw_cases();
    for (int r = 0; r < ROWS; r++) target[r] = (r % 4 == 0) != (is_high(bins[r]) != 0);
    dm_lab_boost_rule each = rule;
    each.each_row = 1;
    const dm_lab_trees out = arrays_of(&once);
    assert_int_equal(boost(&data, &each, NULL, &out), DM_OK);
    double sum[2] = {0, 0}, count[2] = {0, 0};
    for (int r = 0; r < ROWS; r++) {
        const int high = is_high(bins[r]) != 0;
        sum[high] += 1 / (1 + exp(-(double)score_of(&once, bins[r])));
        count[high]++;
    }
    assert_true(fabs(sum[1] / count[1] - 0.75) < 0.05);
    assert_true(fabs(sum[0] / count[0] - 0.25) < 0.05);
}

/* Trees that start from scores that are right already have nothing to say, from scores that are wrong much. */
static void trees_correct_the_scores_they_are_given(void** state) {
    (void)state;
    draw_cases();
    float scores[ROWS], said[2] = {0, 0};
    for (int wrong = 0; wrong < 2; wrong++) {
        for (int r = 0; r < ROWS; r++) scores[r] = (is_high(bins[r]) != 0) != wrong ? 9.0f : 0.0f;
        dm_lab_rows given = data;
        given.scores = scores;
        const dm_lab_trees out = arrays_of(&once);
        assert_int_equal(boost(&given, &rule, NULL, &out), DM_OK);
        for (int r = 0; r < ROWS; r++) said[wrong] += fabsf(score_of(&once, bins[r])) / ROWS;
    }
    assert_true(said[0] < 0.2f && said[1] > 2);
}

static void the_same_seed_gives_the_same_trees(void** state) {
    (void)state;
    draw_cases();
    const dm_lab_trees outs[2] = {arrays_of(&once), arrays_of(&again)};
    for (int i = 0; i < 2; i++) assert_int_equal(boost(&data, &rule, NULL, &outs[i]), DM_OK);
    assert_memory_equal(&once, &again, sizeof once);
    dm_lab_boost_rule other = rule;
    other.seed++;
    assert_int_equal(boost(&data, &other, NULL, &outs[1]), DM_OK);
    assert_memory_not_equal(&once, &again, sizeof once);
}

static void trees_keep_to_their_rule(void** state) {
    (void)state;
    draw_cases();
    const dm_lab_trees out = arrays_of(&once);
    assert_int_equal(boost(&data, &rule, NULL, &out), DM_OK);
    for (int t = 0; t < TREES; t++) {
        uint32_t depth[NODES] = {0}, leaves = 0;
        for (int n = 0; n < NODES; n++) {
            leaves += once.column[t][n] < 0 && (once.score[t][n] != 0 || n == 0);
            if (once.column[t][n] < 0) continue;
            assert_true(once.column[t][n] < COLUMNS && once.left[t][n] > n && once.left[t][n] + 1 < NODES);
            depth[once.left[t][n]] = depth[once.left[t][n] + 1] = depth[n] + 1;
            assert_true(depth[n] < rule.depth && once.score[t][n] == 0);
        }
        assert_true(leaves <= LEAVES);
    }
}

static void no_cases_are_an_error(void** state) {
    (void)state;
    const dm_lab_rows none = {COLUMNS, 0, first, &bins[0][0], weights, target, NULL};
    const dm_lab_trees out = arrays_of(&once);
    assert_int_equal(boost(&none, &rule, NULL, &out), DM_ERROR_INVALID_ARGUMENT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_case_goes_to_whom_it_belongs),
        cmocka_unit_test(each_row_has_its_own_probability),
        cmocka_unit_test(trees_correct_the_scores_they_are_given),
        cmocka_unit_test(the_same_seed_gives_the_same_trees),
        cmocka_unit_test(trees_keep_to_their_rule),
        cmocka_unit_test(no_cases_are_an_error),
    };
    return cmocka_run_group_tests(tests, load_lab, NULL);
}
