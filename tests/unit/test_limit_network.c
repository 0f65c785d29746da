/* The limits' network of the shipped weights: whatever the features, a range that holds the rest. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/inference/joint_models.h"
#include "test_world.h"

static dmi_joint_models* open_models(test_env* t) {
    size_t size;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    dmi_joint_models* models = NULL;
    assert_int_equal(dmi_joint_models_load(&t->env, bytes, size, &models), DM_OK);
    free(bytes);
    return models;
}

static void draw(dmi_random* random, float scale, float* out, int count) {
    for (int k = 0; k < count; k++) out[k] = scale * dmi_random_normal(random);
}

static void any_features_give_a_range_around_rest(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_joint_models* models = open_models(&t);
    dmi_random random = dmi_random_make(3, 1);
    for (int i = 0; i < 500; i++) {
        float evidence[DMI_FEATURE_COUNT];
        dmi_limit_query question = {.evidence = i % 3 == 0 ? NULL : evidence};
        dmi_limit_prediction answer;
        draw(&random, i % 2 == 0 ? 1.0f : 50.0f, question.features, DMI_LIMIT_FEATURES);
        draw(&random, i % 2 == 0 ? 1.0f : 50.0f, evidence, DMI_FEATURE_COUNT);
        dmi_limit_network_predict(&models->limits, &question, 1, &answer);
        assert_true(isfinite(answer.lower) && isfinite(answer.upper) && isfinite(answer.free));
        assert_true(answer.lower <= 0 && answer.upper >= 0 && answer.upper - answer.lower > 0.009f);
    }
    dmi_joint_models_destroy(models);
    test_env_close(&t);
}

static void joints_do_not_change_each_others_answers(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_joint_models* models = open_models(&t);
    dmi_random random = dmi_random_make(4, 1);
    float evidence[DMI_FEATURE_COUNT];
    dmi_limit_query questions[DMI_LIMIT_ROWS];
    dmi_limit_prediction together[DMI_LIMIT_ROWS], alone;
    draw(&random, 1, evidence, DMI_FEATURE_COUNT);
    for (int i = 0; i < DMI_LIMIT_ROWS; i++) {
        draw(&random, 1, questions[i].features, DMI_LIMIT_FEATURES);
        questions[i].evidence = i % 2 == 0 ? evidence : NULL;
    }
    dmi_limit_network_predict(&models->limits, questions, DMI_LIMIT_ROWS, together);
    for (int i = 0; i < DMI_LIMIT_ROWS; i++) {
        dmi_limit_network_predict(&models->limits, &questions[i], 1, &alone);
        assert_memory_equal(&alone, &together[i], sizeof alone);
    }
    dmi_joint_models_destroy(models);
    test_env_close(&t);
}

/* A door that meets the body at once one way and not at all the other opens the other way. */
static void room_on_one_side_opens_that_side(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_joint_models* models = open_models(&t);
    const dmi_limit_network* net = &models->limits;
    dmi_limit_query question = {.evidence = NULL};
    dmi_limit_prediction answer;
    float* features = question.features;
    memcpy(features, net->mean, sizeof question.features);
    features[0] = 0, features[1] = 1;
    features[2] = features[3] = 2.5f; /* rad of room the way of the drag */
    features[4] = features[5] = 0;    /* and none back */
    dmi_limit_network_predict(net, &question, 1, &answer);
    assert_true(answer.upper > 0.3f && answer.upper > -2 * answer.lower);
    dmi_joint_models_destroy(models);
    test_env_close(&t);
}

/* Rests at an end and goes 1.5 or 3 rad: the likelier is answered, never what lies between; and of voices that
 * disagree the one that is surer. */
static void one_of_two_ranges_is_answered(void** state) {
    (void)state;
    static dmi_limit_network net;
    enum { N = DMI_LIMIT_SIZES, SIDES = 1 + DMI_LIMIT_KINDS, QUARTER = 10, HALF = 20 };
    for (int i = 0; i < N; i++) net.sizes[i] = 0.15f * (float)i;
    for (int v = 0; v < DMI_LIMIT_MEMBERS; v++) {
        float* bias = net.voices[v].last_bias;
        for (int k = 0; k < DMI_LIMIT_KINDS; k++) {
            bias[1 + k] = k > 1 ? -20.0f : k == 0 ? 0.4f : 0;
            bias[SIDES + k * N] = 20; /* no way down */
            bias[SIDES + (DMI_LIMIT_KINDS + k) * N + (k == 0 ? QUARTER : HALF)] = 20;
        }
    }
    const dmi_limit_query question = {.evidence = NULL};
    dmi_limit_prediction answer;
    dmi_limit_network_predict(&net, &question, 1, &answer);
    assert_true(answer.lower == 0 && answer.upper == net.sizes[QUARTER]);
    net.voices[0].last_bias[1] = -10;
    dmi_limit_network_predict(&net, &question, 1, &answer);
    assert_true(answer.lower == 0 && answer.upper == net.sizes[HALF]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_features_give_a_range_around_rest),
        cmocka_unit_test(joints_do_not_change_each_others_answers),
        cmocka_unit_test(room_on_one_side_opens_that_side),
        cmocka_unit_test(one_of_two_ranges_is_answered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
