/* The ranker's score: the mean of network and trees, and the network's with KPP-Net's features and, to a fifth,
 * without. And what the rules say in its place. */
#include "test_env.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/random.h"
#include "kinematics/inference/joint_models.h"
#include "kinematics/ranking/ranker.h"
#include "test_perceptron.h"
#include "test_world.h"

enum { COUNT = 2, HIDDEN = 64 };

/* A network whose score is `gain` times a column, beside trees that say nothing. */
static dmi_ranker* open_ranker(test_layers* layers, int column, float gain) {
    static dmi_ranker ranker;
    static float first[HIDDEN][DMI_FEATURE_COUNT], second[HIDDEN][HIDDEN], third[HIDDEN];
    const float zeros[HIDDEN] = {0};
    memset(first, 0, sizeof first);
    first[0][column] = gain, second[0][0] = 1, third[0] = 1;
    ranker.network.layer_count = 3;
    ranker.network.layers[0] = test_layer(layers, first[0], zeros, DMI_FEATURE_COUNT, HIDDEN);
    ranker.network.layers[1] = test_layer(layers, second[0], zeros, HIDDEN, HIDDEN);
    ranker.network.layers[2] = test_layer(layers, third, zeros, HIDDEN, 1);
    return &ranker;
}

/* How much likelier the first candidate is than the second, as a logarithm: only the first has 1 in the column. */
static float log_odds(int column, float gain, float has_network) {
    test_env t;
    test_layers layers;
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    test_env_open(&t, TEST_NEVER);
    test_layers_open(&layers, &t.env);
    const dmi_ranker* ranker = open_ranker(&layers, column, gain);
    for (int i = 0; i < COUNT; i++) rows[i][DMI_FEATURE_HAS_NETWORK] = has_network;
    rows[0][column] = 1;
    dmi_ranker_probabilities(ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_float_equal(probability[0] + probability[1], 1, 1e-6f);
    test_layers_close(&layers);
    test_env_close(&t);
    return logf(probability[0] / probability[1]);
}

static void geometry_counts_in_both_members(void** state) {
    (void)state;
    assert_float_equal(log_odds(DMI_FEATURE_ON_SIDE, 3, 1), 3.0f / 2, 1e-4f);
    assert_float_equal(log_odds(DMI_FEATURE_ON_SIDE, 3, 0), 3.0f / 2, 1e-4f);
}

static void a_fifth_of_the_network_does_without_kpp_net(void** state) {
    (void)state;
    for (int k = 0; k < DMI_NETWORK_COLUMNS; k++) {
        const int column = dmi_network_columns[k];
        if (column != DMI_FEATURE_HAS_NETWORK) assert_float_equal(log_odds(column, 3, 1), 0.8f * 3 / 2, 1e-4f);
    }
}

static void confidence_rises_with_the_probability(void** state) {
    (void)state;
    const dmi_ranker ranker = {.calibration = {{0.8f, -0.2f}, {1.1f, 0.3f}}};
    for (int dragged = 0; dragged < 2; dragged++) {
        float last = 0;
        for (int i = 0; i <= 20; i++) {
            const float now = dmi_ranker_confidence(&ranker, dragged, (float)i / 20);
            assert_true(now > last && now < 1);
            last = now;
        }
    }
    /* log odds of 0.5 are 0: the offset alone */
    assert_float_equal(dmi_ranker_confidence(&ranker, 1, 0.5f), 1 / (1 + expf(-0.3f)), 1e-5f);
    assert_float_equal(dmi_ranker_confidence(NULL, 1, 0.7f), 0.7f, 0);
}

/* Where the numbers of a tensor begin in a weights file. */
static unsigned char* tensor_in(unsigned char* file, const char* name) {
    uint64_t header = 0, first = 0;
    memcpy(&header, file, sizeof header);
    char* text = calloc(1, header + 1);
    memcpy(text, file + 8, header);
    const char* at = strstr(strstr(text, name), "\"data_offsets\"");
    assert_int_equal(sscanf(at, "\"data_offsets\":[%" SCNu64, &first), 1);
    free(text);
    return file + 8 + header + first;
}

/* More probability has to mean more confidence, with a drag and without: weights that say otherwise are refused. */
static void a_calibration_that_does_not_rise_is_refused(void** state) {
    (void)state;
    static const struct {
        float slope;
        dm_result result;
    } slopes[] = {{1, DM_OK},
                  {0.01f, DM_OK},
                  {0, DM_ERROR_WRONG_MODEL},
                  {-1, DM_ERROR_WRONG_MODEL},
                  {1e3f, DM_ERROR_WRONG_MODEL},
                  {1e30f, DM_ERROR_WRONG_MODEL}};
    size_t size;
    unsigned char* file = test_read_file("sdk/models/ranker.safetensors", &size);
    unsigned char* numbers = tensor_in(file, "ranker.calibration");
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
        for (int dragged = 0; dragged < 2; dragged++) {
            const float both[2] = {dragged ? 1 : slopes[i].slope, dragged ? slopes[i].slope : 1};
            test_env t;
            dmi_joint_models* joints = NULL;
            test_env_open(&t, TEST_NEVER);
            for (int k = 0; k < 2; k++) memcpy(numbers + 8 * k, &both[k], sizeof both[k]);
            assert_int_equal(dmi_joint_models_load(&t.env, file, size, &joints), slopes[i].result);
            if (slopes[i].result == DM_OK)
                dmi_joint_models_destroy(joints);
            else
                assert_non_null(strstr(t.messages.text, "calibration"));
            test_env_close(&t);
        }
    }
    free(file);
}

/* Confidence is the logistic function of a line over the log odds; these end at a ten-thousandth from 0 and 1. */
static void confidence_follows_its_line(void** state) {
    (void)state;
    const dmi_ranker ranker = {.calibration = {{0.8f, -0.2f}, {1.3f, 0.4f}}};
    static const float masses[] = {-1, 0, 5e-5f, 1e-4f, 2e-4f, 0.1f, 0.5f, 0.77f, 0.9997f, 0.9999f, 0.99995f, 1, 1.5f};
    for (int dragged = 0; dragged < 2; dragged++) {
        const double slope = dragged ? 1.3 : 0.8, offset = dragged ? 0.4 : -0.2;
        for (size_t i = 0; i < sizeof masses / sizeof *masses; i++) {
            const double p = fmin(fmax((double)masses[i], 1e-4), 1 - 1e-4);
            const double want = 1 / (1 + exp(-slope * log(p / (1 - p)) - offset));
            assert_float_equal(dmi_ranker_confidence(&ranker, dragged, masses[i]), (float)want, 2e-5f);
        }
    }
    assert_float_equal(dmi_ranker_confidence(NULL, 0, 1.5f), 1, 0);
    assert_float_equal(dmi_ranker_confidence(NULL, 0, 0), 0, 0);
}

/* ---- many candidates ---- */

enum { MANY = 100 }; /* more than a batch of the ranker, and of the trees */

static dmi_joint_models* open_shipped(test_env* t) {
    size_t size;
    dmi_joint_models* joints = NULL;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    assert_int_equal(dmi_joint_models_load(&t->env, bytes, size, &joints), DM_OK);
    free(bytes);
    return joints;
}

static void fill_rows(float (*rows)[DMI_FEATURE_COUNT], uint32_t count, int has_network, int has_drag) {
    dmi_random random = dmi_random_make(3, 4);
    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < DMI_FEATURE_COUNT; k++) rows[i][k] = dmi_random_unit(&random);
        rows[i][DMI_FEATURE_HAS_NETWORK] = (float)has_network, rows[i][DMI_FEATURE_HAS_DRAG] = (float)has_drag;
    }
}

/* However many there are, the odds of two candidates are those that they have alone; and all share 1. */
static void odds_do_not_depend_on_the_others(void** state) {
    (void)state;
    static float rows[MANY][DMI_FEATURE_COUNT];
    static const uint32_t counts[] = {1, 2, 15, 16, 17, 23, 24, 25, 31, 32, 33, 47, 48, 49, MANY};
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_joint_models* joints = open_shipped(&t);
    for (int way = 0; way < 8; way++) {
        const dmi_ranker* ranker = way & 1 ? &joints->ranker : NULL;
        fill_rows(rows, MANY, way >> 1 & 1, way >> 2);
        for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
            float all[MANY], sum = 0;
            dmi_ranker_probabilities(ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, counts[c], all);
            for (uint32_t i = 0; i < counts[c]; i++) sum += all[i];
            assert_float_equal(sum, 1, 1e-4f);
            const uint32_t last = counts[c] - 1;
            float pair[2][DMI_FEATURE_COUNT], two[2];
            memcpy(pair[0], rows[0], sizeof *pair);
            memcpy(pair[1], rows[last], sizeof *pair);
            dmi_ranker_probabilities(ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])pair, 2, two);
            assert_float_equal(logf(two[1] / two[0]), logf(all[last] / all[0]), 2e-3f);
        }
    }
    dmi_joint_models_destroy(joints);
    test_env_close(&t);
}

/* Without KPP-Net: what its columns hold does not matter. */
static void geometry_alone_sees_no_column_of_the_network(void** state) {
    (void)state;
    static float rows[MANY][DMI_FEATURE_COUNT], hidden[MANY][DMI_FEATURE_COUNT];
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_joint_models* joints = open_shipped(&t);
    for (int with = 0; with < 2; with++) {
        const dmi_ranker* ranker = with ? &joints->ranker : NULL;
        fill_rows(rows, MANY, 1, 1);
        memcpy(hidden, rows, sizeof hidden);
        for (int i = 0; i < MANY; i++)
            for (int k = 0; k < DMI_NETWORK_COLUMNS; k++) hidden[i][dmi_network_columns[k]] = 0;
        for (uint32_t count = 1; count <= MANY; count += 1 + count / 3) {
            float got[MANY], want[MANY];
            dmi_ranker_geometry_probabilities(ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, count,
                                              got);
            dmi_ranker_probabilities(ranker, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])hidden, count, want);
            for (uint32_t i = 0; i < count; i++) assert_float_equal(got[i], want[i], 1e-5f);
        }
    }
    dmi_joint_models_destroy(joints);
    test_env_close(&t);
}

/* A score far above all others, and far above what an exponential holds, is certainty, wherever it stands. */
static void far_scores_are_certain(void** state) {
    (void)state;
    float rows[3][DMI_FEATURE_COUNT], probability[3];
    for (int best = 0; best < 3; best++)
        for (int sign = -1; sign <= 1; sign += 2) {
            memset(rows, 0, sizeof rows);
            for (int i = 0; i < 3; i++) rows[i][DMI_FEATURE_NEAREST_SLIP] = sign < 0 ? 1e3f : 0;
            rows[best][DMI_FEATURE_NEAREST_SLIP] = sign < 0 ? 0 : -1e3f;
            dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, 3, probability);
            for (int i = 0; i < 3; i++) assert_float_equal(probability[i], (i == best ? 1 : 0), 1e-6f);
        }
}

/* ---- rules, where there is no ranker ---- */

/* How much likelier the rules find a candidate than another that differs in `column` alone: `value` there, not 0. */
static float rule_log_odds(int column, float value, float prismatic, float has_drag, float has_network) {
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    for (int i = 0; i < COUNT; i++) {
        rows[i][DMI_FEATURE_PRISMATIC] = prismatic;
        rows[i][DMI_FEATURE_HAS_DRAG] = has_drag, rows[i][DMI_FEATURE_HAS_NETWORK] = has_network;
    }
    rows[0][column] = value;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_float_equal(probability[0] + probability[1], 1, 1e-6f);
    return logf(probability[0] / probability[1]);
}

/* odds: how much likelier 0.5 makes a candidate, as a logarithm, where the rule holds; elsewhere it says nothing. */
static const struct rule {
    int column;
    float odds;
    bool of_turns, of_drags, of_the_network;
} rules[] = {
    {DMI_FEATURE_NEAREST_SLIP, -2 * 0.5f, false, false, false},
    {DMI_FEATURE_TOUCHING_PART_NORMAL_SPEED, -1.5f * 0.5f, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG, 2 * 0.5f, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG + 1, 2 * 0.5f, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG + 2, 2 * 0.5f, false, false, false},
    {DMI_FEATURE_DRAG_ANGLE, -0.25f / 0.03f, false, true, false},
    {DMI_FEATURE_NEAREST_ON_AXIS, 4 * 0.5f, true, false, false},
    {DMI_FEATURE_ON_SIDE, 0.5f * 0.5f, true, false, false},
    {DMI_FEATURE_ROUND, 0.5f * 0.5f, true, false, false},
    {DMI_FEATURE_AT_CENTROID, 0.5f * 0.5f, true, false, false},
    {DMI_FEATURE_AT_BOX_CENTRE, 0.5f, true, false, false},
    {DMI_FEATURE_ALONG_PART_MEAN, -2 * (0.5f - 0.05f), true, false, false},
    {DMI_FEATURE_NETWORK_TYPE, 3.2581f /* log(0.52 / 0.02) */, false, false, true},
    {DMI_FEATURE_NETWORK_ANGLE, -4 * 0.5f, false, false, true},
    {DMI_FEATURE_NETWORK_NEAR_50MRAD, 2 * 0.5f, false, false, true},
    {DMI_FEATURE_NETWORK_OFFSET, -4 * 0.5f, true, false, true},
    {DMI_FEATURE_NETWORK_ON_LINE_3, 0.5f, true, false, true},
};

static void each_rule_speaks_where_it_holds(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        for (int which = 0; which < 8; which++) {
            const bool slides = which & 1, dragged = which & 2, network = which & 4;
            const float odds = rule_log_odds(rules[i].column, 0.5f, slides, dragged, network);
            const bool holds = (!rules[i].of_turns || !slides) && (!rules[i].of_drags || dragged) &&
                               (!rules[i].of_the_network || network);
            if (!(fabsf(odds - (holds ? rules[i].odds : 0)) < 2e-3f))
                fail_msg("column %d says %g (way %d)", rules[i].column, (double)odds, which);
        }
    }
}

/* Checks that half of the points that meet the body count on the freer way alone. */
static void check_free_way(int along, int against) {
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    assert_float_equal(rule_log_odds(along, 0.5f, 0, 0, 0), 0, 1e-6f);
    assert_float_equal(rule_log_odds(against, 0.5f, 0, 0, 0), 0, 1e-6f);
    rows[0][along] = rows[0][against] = 0.5f;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_float_equal(logf(probability[0] / probability[1]), -4 * 0.5f, 1e-3f);
    rows[0][against] = 0.25f;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_float_equal(logf(probability[0] / probability[1]), -4 * 0.25f, 1e-3f);
}

/* A motion runs into the body only where neither of its ways is free. */
static void a_free_way_is_enough(void** state) {
    (void)state;
    check_free_way(DMI_FEATURE_HIT_MIDDLE_ALONG, DMI_FEATURE_HIT_MIDDLE_AGAINST);
    check_free_way(DMI_FEATURE_HIT_LONG_ALONG, DMI_FEATURE_HIT_LONG_AGAINST);
}

/* KPP-Net's error counts up to 1; an axis may run a twentieth of the part's diagonal away for nothing. */
static void rules_have_ends(void** state) {
    (void)state;
    const float angle = rule_log_odds(DMI_FEATURE_NETWORK_ANGLE, 1, 0, 0, 1);
    const float offset = rule_log_odds(DMI_FEATURE_NETWORK_OFFSET, 1, 0, 0, 1);
    assert_float_equal(angle, -4, 1e-3f);
    assert_float_equal(offset, -4, 1e-3f);
    assert_float_equal(rule_log_odds(DMI_FEATURE_NETWORK_ANGLE, 1.5f, 0, 0, 1), angle, 1e-3f);
    assert_float_equal(rule_log_odds(DMI_FEATURE_NETWORK_OFFSET, 9, 0, 0, 1), offset, 1e-3f);
    assert_float_equal(rule_log_odds(DMI_FEATURE_ALONG_PART_MEAN, 0.04f, 0, 0, 0), 0, 1e-5f);
    assert_float_equal(rule_log_odds(DMI_FEATURE_ALONG_PART_MEAN, 1.05f, 0, 0, 0), -2, 1e-3f);
}

/* Of a slide and a turn that nothing speaks for, the slide is taken, and with a drag all the more. */
static void a_turn_needs_a_reason(void** state) {
    (void)state;
    for (int dragged = 0; dragged < 2; dragged++) {
        float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
        rows[0][DMI_FEATURE_PRISMATIC] = 1;
        rows[0][DMI_FEATURE_HAS_DRAG] = rows[1][DMI_FEATURE_HAS_DRAG] = (float)dragged;
        dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
        const float cost = dragged ? 3 : 1.5f;
        assert_float_equal(logf(probability[0] / probability[1]), cost, 1e-4f);
        rows[1][DMI_FEATURE_NEAREST_ON_AXIS] = 1;
        dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
        assert_true(probability[0] < 0.4f);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(geometry_counts_in_both_members),
        cmocka_unit_test(a_fifth_of_the_network_does_without_kpp_net),
        cmocka_unit_test(confidence_rises_with_the_probability),
        cmocka_unit_test(a_calibration_that_does_not_rise_is_refused),
        cmocka_unit_test(confidence_follows_its_line),
        cmocka_unit_test(odds_do_not_depend_on_the_others),
        cmocka_unit_test(geometry_alone_sees_no_column_of_the_network),
        cmocka_unit_test(far_scores_are_certain),
        cmocka_unit_test(each_rule_speaks_where_it_holds),
        cmocka_unit_test(rules_have_ends),
        cmocka_unit_test(a_free_way_is_enough),
        cmocka_unit_test(a_turn_needs_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
