/* The cheap features of candidates agree with their full ones, and the prefilter keeps the best in their order. */
#include "test_analysis.h"

#include <math.h>

#include "base/random.h"
#include "kinematics/features/candidate_features.h"
#include "kinematics/ranking/candidate_prefilter.h"
#include "math/linear3.h"
#include "test_perceptron.h"

static test_shape shape;
static dmi_candidate candidates[DMI_CANDIDATES_MAX], kept[DMI_CANDIDATES_MAX];
static float features[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT], rows[DMI_CANDIDATES_MAX][DMI_FEATURE_COUNT];
static dmi_prefilter prefilter;

static test_analysis a;

typedef struct bench {
    dmi_drag_hint hint;
    test_layers layers;
} bench;

static void open_bench(bench* b) {
    dmi_random random = dmi_random_make(5, 2);
    test_shape_pile(&shape, &random);
    test_analysis_open(&a, &shape, 3);
    test_layers_open(&b->layers, &a.t.env);
    dmi_copy3(a.of_part.points[0], b->hint.point);
    dmi_copy3((const float[]){0.1f, 1, 0.2f}, b->hint.vector);
}

static void close_bench(bench* b) {
    test_layers_close(&b->layers);
    test_analysis_close(&a);
}

/* Makes a prefilter that scores by one cheap column alone: times `sign` with `last` after it. */
static void prefilter_by(bench* b, int column, float sign, float last) {
    enum { HIDDEN = 16 };
    float first[HIDDEN][DMI_CHEAP_COLUMNS] = {{0}}, bias[HIDDEN] = {100}, second[HIDDEN] = {last}, zero = 0;
    for (int i = 0; i < DMI_CHEAP_COLUMNS; i++)
        if (dmi_cheap_columns[i] == column) first[0][i] = sign;
    prefilter.network.layer_count = 2;
    prefilter.network.layers[0] = test_layer(&b->layers, first[0], bias, DMI_CHEAP_COLUMNS, HIDDEN);
    prefilter.network.layers[1] = test_layer(&b->layers, second, &zero, HIDDEN, 1);
}

static uint32_t keep(const dmi_drag_hint* hint, uint32_t count) {
    memcpy(kept, candidates, sizeof kept);
    for (int i = 0; i < DMI_CANDIDATES_MAX; i++)
        for (int k = 0; k < DMI_FEATURE_COUNT; k++) rows[i][k] = NAN; /* scratch holds anything */
    return dmi_prefilter_keep(&prefilter, &a.of_part, hint, NULL, DMI_ISA_SCALAR, NULL, kept, count, rows);
}

/* The cheap columns hold what the full rows have there; the others stay as they were. */
static void cheap_features_fill_their_columns(void** state) {
    (void)state;
    bench b;
    open_bench(&b);
    const dmi_prediction prediction = {.type = {0.5f, 0.3f, 0.1f, 0.1f},
                                       .turn_axis = {1, 0, 0},
                                       .slide_axis = {0, 0.6f, 0.8f},
                                       .origin = {0.1f, 0, 0}};
    float scores[DMI_CANDIDATES_MAX];
    for (int with = 0; with < 2; with++) {
        const dmi_drag_hint* hint = with ? &b.hint : NULL;
        const dmi_prediction* said = with ? &prediction : NULL;
        const uint32_t count = dmi_candidates_make(&a.of_part, hint, said, candidates);
        for (uint32_t i = 0; i < count; i++) scores[i] = -0.01f * (float)i;
        dmi_candidate_features_make(&a.of_part, hint, said, with ? scores : NULL, candidates, count, features);
        dmi_cheap_features cheap;
        dmi_cheap_features_begin(&a.of_part, hint, said, &cheap);
        for (uint32_t i = 0; i < count; i++) {
            for (int k = 0; k < DMI_FEATURE_COUNT; k++) rows[i][k] = -7;
            dmi_cheap_features_row(&cheap, &candidates[i], rows[i]);
        }
        dmi_cheap_features_kpp_scores(with ? scores : NULL, count, rows);
        for (uint32_t i = 0; i < count; i++)
            for (int k = 0, next = 0; k < DMI_FEATURE_COUNT; k++) {
                const int seen = next < DMI_CHEAP_COLUMNS && dmi_cheap_columns[next] == k;
                assert_true(rows[i][k] == (seen ? features[i][k] : -7));
                next += seen;
            }
    }
    close_bench(&b);
}

static int same(const dmi_candidate* a, const dmi_candidate* b) {
    return memcmp(a, b, sizeof *a) == 0;
}

/* Whoever is kept has at least the score of whoever is not, and their order is as it was. */
static void the_best_are_kept_in_order(void** state) {
    (void)state;
    bench b;
    open_bench(&b);
    const uint32_t count = dmi_candidates_make(&a.of_part, NULL, NULL, candidates);
    assert_true(count > DMI_PREFILTER_KEPT + 50);
    for (int sign = -1; sign <= 1; sign += 2) {
        const int column = DMI_FEATURE_BOX_OFFSET;
        prefilter_by(&b, column, (float)sign, 1);
        assert_int_equal(keep(NULL, count), DMI_PREFILTER_KEPT);
        float least = INFINITY, most = -INFINITY;
        uint32_t next = 0;
        for (uint32_t i = 0; i < count; i++) {
            const float score = (float)sign * rows[i][column];
            if (next < DMI_PREFILTER_KEPT && same(&kept[next], &candidates[i]))
                next++, least = fminf(least, score);
            else
                most = fmaxf(most, score);
        }
        assert_int_equal(next, DMI_PREFILTER_KEPT);
        assert_true(least >= most);
    }
    close_bench(&b);
}

/* By each column, either way: kept are those that a plain sort puts first, equals in their order, and in the order in
 * which they were. */
static void what_a_sort_puts_first_is_kept(void** state) {
    (void)state;
    bench b;
    open_bench(&b);
    for (int with = 0; with < 2; with++) {
        const dmi_drag_hint* hint = with ? &b.hint : NULL;
        const uint32_t all = dmi_candidates_make(&a.of_part, hint, NULL, candidates);
        assert_true(all > DMI_PREFILTER_KEPT + 1);
        dmi_candidate_features_make(&a.of_part, hint, NULL, NULL, candidates, all, features);
        for (int way = 0; way < 2 * DMI_CHEAP_COLUMNS; way++) {
            const int column = dmi_cheap_columns[way / 2];
            const float sign = way & 1 ? -1.0f : 1.0f;
            const uint32_t count = way % 3 == 0 ? DMI_PREFILTER_KEPT + 1 : way % 3 == 1 ? all : all - 1;
            float scores[DMI_CANDIDATES_MAX];
            bench own;
            test_layers_open(&own.layers, &a.t.env);
            prefilter_by(&own, column, sign, 1);
            for (uint32_t i = 0; i < count; i++) scores[i] = fmaxf(sign * features[i][column] + 100, 0);
            assert_int_equal(keep(hint, count), DMI_PREFILTER_KEPT);
            for (uint32_t i = 0, next = 0; i < count; i++) {
                uint32_t before = 0;
                for (uint32_t k = 0; k < count; k++)
                    before += scores[k] > scores[i] || (scores[k] == scores[i] && k < i);
                if (before >= DMI_PREFILTER_KEPT) continue;
                if (!same(&kept[next++], &candidates[i])) fail_msg("column %d: candidate %u is not kept", column, i);
            }
            test_layers_close(&own.layers);
        }
    }
    close_bench(&b);
}

/* Among equals the first are kept; a few candidates pass as they are. */
static void equals_and_few_pass(void** state) {
    (void)state;
    bench b;
    open_bench(&b);
    const uint32_t count = dmi_candidates_make(&a.of_part, &b.hint, NULL, candidates);
    assert_true(count > DMI_PREFILTER_KEPT);
    prefilter_by(&b, DMI_FEATURE_HAS_DRAG, 1, 1); /* 1 for every candidate */
    assert_int_equal(keep(&b.hint, count), DMI_PREFILTER_KEPT);
    assert_memory_equal(kept, candidates, DMI_PREFILTER_KEPT * sizeof *kept);
    assert_int_equal(keep(&b.hint, DMI_PREFILTER_KEPT), DMI_PREFILTER_KEPT);
    assert_int_equal(keep(&b.hint, 3), 3);
    assert_memory_equal(kept, candidates, sizeof kept);
    prefilter_by(&b, -1, 0, NAN); /* weights that say nothing keep the first, too */
    assert_int_equal(keep(&b.hint, count), DMI_PREFILTER_KEPT);
    assert_memory_equal(kept, candidates, DMI_PREFILTER_KEPT * sizeof *kept);
    close_bench(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cheap_features_fill_their_columns),
        cmocka_unit_test(the_best_are_kept_in_order),
        cmocka_unit_test(what_a_sort_puts_first_is_kept),
        cmocka_unit_test(equals_and_few_pass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
