/* The ranker's score: the mean of network and trees, and the network's with KPP-Net's features and, to a fifth,
 * without. And what the rules say in its place. */
#include "test_env.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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

/* ---- rules, where there is no ranker ---- */

/* How much likelier the rules find a candidate than another that differs in `column` alone: 0.5 there, not 0. */
static float rule_log_odds(int column, float prismatic, float has_drag, float has_network) {
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    for (int i = 0; i < COUNT; i++) {
        rows[i][DMI_FEATURE_PRISMATIC] = prismatic;
        rows[i][DMI_FEATURE_HAS_DRAG] = has_drag, rows[i][DMI_FEATURE_HAS_NETWORK] = has_network;
    }
    rows[0][column] = 0.5f;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_float_equal(probability[0] + probability[1], 1, 1e-6f);
    return logf(probability[0] / probability[1]);
}

/* sign: of what a larger number says for a candidate, where the rule holds; elsewhere it says nothing. */
static const struct rule {
    int column;
    float sign;
    bool of_turns, of_drags, of_the_network;
} rules[] = {
    {DMI_FEATURE_SURFACE_SLIP, -1, false, false, false},
    {DMI_FEATURE_NEAREST_PART_NORMAL_SPEED, -1, false, false, false},
    {DMI_FEATURE_NEAREST_BODY_NORMAL_SPEED, -1, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG, 1, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG + 1, 1, false, false, false},
    {DMI_FEATURE_ALIGNED_LONG + 2, 1, false, false, false},
    {DMI_FEATURE_HIT_MIDDLE_ALONG, -1, false, true, false},
    {DMI_FEATURE_DRAG_ANGLE, -1, false, true, false},
    {DMI_FEATURE_NEAREST_ON_AXIS, 1, true, false, false},
    {DMI_FEATURE_ON_SIDE, 1, true, false, false},
    {DMI_FEATURE_ROUND, 1, true, false, false},
    {DMI_FEATURE_AT_CENTROID, 1, true, false, false},
    {DMI_FEATURE_AT_BOX_CENTRE, 1, true, false, false},
    {DMI_FEATURE_ALONG_PART_MEAN, -1, true, false, false},
    {DMI_FEATURE_NETWORK_TYPE, 1, false, false, true},
    {DMI_FEATURE_NETWORK_ANGLE, -1, false, false, true},
    {DMI_FEATURE_NETWORK_NEAR_50MRAD, 1, false, false, true},
    {DMI_FEATURE_NETWORK_OFFSET, -1, true, false, true},
    {DMI_FEATURE_NETWORK_ON_LINE_3, 1, true, false, true},
};

static void each_rule_speaks_where_it_holds(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        for (int which = 0; which < 8; which++) {
            const bool slides = which & 1, dragged = which & 2, network = which & 4;
            const float odds = rule_log_odds(rules[i].column, slides, dragged, network) * rules[i].sign;
            const bool holds = (!rules[i].of_turns || !slides) && (!rules[i].of_drags || dragged) &&
                               (!rules[i].of_the_network || network);
            if (holds ? !(odds > 0.3f) : fabsf(odds) > 1e-5f)
                fail_msg("column %d says %g (way %d)", rules[i].column, (double)odds, which);
        }
    }
}

/* A motion runs into the body only where neither of its ways is free. */
static void a_free_way_is_enough(void** state) {
    (void)state;
    const float away = rule_log_odds(DMI_FEATURE_HIT_SHORT_ALONG, 0, 0, 0);
    const float back = rule_log_odds(DMI_FEATURE_HIT_SHORT_AGAINST, 0, 0, 0);
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    assert_float_equal(away, 0, 1e-6f);
    assert_float_equal(back, 0, 1e-6f);
    rows[0][DMI_FEATURE_HIT_SHORT_ALONG] = rows[0][DMI_FEATURE_HIT_SHORT_AGAINST] = 0.5f;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_true(probability[0] < 0.2f);
}

/* Of a slide and a turn that nothing speaks for, the slide is taken. */
static void a_turn_needs_a_reason(void** state) {
    (void)state;
    float rows[COUNT][DMI_FEATURE_COUNT] = {{0}}, probability[COUNT];
    rows[0][DMI_FEATURE_PRISMATIC] = 1;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_true(probability[0] > 0.6f && probability[0] < 0.9f);
    rows[1][DMI_FEATURE_ON_SIDE] = rows[1][DMI_FEATURE_ROUND] = 1;
    dmi_ranker_probabilities(NULL, DMI_ISA_SCALAR, (const float(*)[DMI_FEATURE_COUNT])rows, COUNT, probability);
    assert_true(probability[0] < 0.4f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(geometry_counts_in_both_members),
        cmocka_unit_test(a_fifth_of_the_network_does_without_kpp_net),
        cmocka_unit_test(confidence_rises_with_the_probability),
        cmocka_unit_test(a_calibration_that_does_not_rise_is_refused),
        cmocka_unit_test(each_rule_speaks_where_it_holds),
        cmocka_unit_test(a_free_way_is_enough),
        cmocka_unit_test(a_turn_needs_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
