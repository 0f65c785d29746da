/* The limits' network of the shipped weights: whatever the features, a range that holds the rest. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/inference/joint_models.h"
#include "test_perceptron.h"
#include "test_world.h"

static const dmi_isa isa = DMI_ISA_SCALAR;
enum { N = DMI_LIMIT_SIZES, SIDES = 1 + DMI_LIMIT_KINDS, QUARTER = 10, HALF = 20 };

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
        float candidate[DMI_FEATURE_COUNT];
        dmi_limit_query query = {.candidate = i % 3 == 0 ? NULL : candidate};
        dmi_limit_prediction prediction;
        draw(&random, i % 2 == 0 ? 1.0f : 50.0f, query.features, DMI_LIMIT_FEATURES);
        draw(&random, i % 2 == 0 ? 1.0f : 50.0f, candidate, DMI_FEATURE_COUNT);
        dmi_limit_network_predict(&models->limits, isa, &query, 1, &prediction);
        assert_true(isfinite(prediction.lower) && isfinite(prediction.upper) && isfinite(prediction.free));
        assert_true(prediction.lower <= 0 && prediction.upper >= 0 && prediction.upper - prediction.lower > 0.009f);
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
    float candidate[DMI_FEATURE_COUNT];
    dmi_limit_query queries[DMI_LIMIT_ROWS] = {0};
    dmi_limit_prediction together[DMI_LIMIT_ROWS], alone;
    draw(&random, 1, candidate, DMI_FEATURE_COUNT);
    for (int i = 0; i < DMI_LIMIT_ROWS; i++) {
        draw(&random, 1, queries[i].features, DMI_LIMIT_FEATURES);
        queries[i].candidate = i % 2 == 0 ? candidate : NULL;
        queries[i].dragged = i % 3 == 0;
    }
    dmi_limit_network_predict(&models->limits, isa, queries, DMI_LIMIT_ROWS, together);
    for (int i = 0; i < DMI_LIMIT_ROWS; i++) {
        dmi_limit_network_predict(&models->limits, isa, &queries[i], 1, &alone);
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
    dmi_limit_query query = {.candidate = NULL};
    dmi_limit_prediction prediction;
    float* features = query.features;
    memcpy(features, net->mean, sizeof query.features);
    features[0] = 0, features[1] = 1;
    features[2] = features[3] = 2.5f; /* rad of room the way of the drag */
    features[4] = features[5] = 0;    /* and none back */
    dmi_limit_network_predict(net, isa, &query, 1, &prediction);
    assert_true(prediction.upper > 0.3f && prediction.upper > -2 * prediction.lower);
    dmi_joint_models_destroy(models);
    test_env_close(&t);
}

/* Sets a member's answer, whatever its input: `likelier` is the log odds of a range of 1.5 against one of 3 rad, both
 * of which begin at rest. */
static void set_member(test_layers* layers, float likelier, dmi_perceptron* out) {
    enum { HIDDEN = 160, OUTPUTS = SIDES + 2 * DMI_LIMIT_KINDS * N };
    float bias[OUTPUTS] = {0};
    for (int k = 0; k < DMI_LIMIT_KINDS; k++) {
        bias[1 + k] = k > 1 ? -20.0f : k == 0 ? likelier : 0;
        bias[SIDES + k * N] = 20; /* no way down */
        bias[SIDES + (DMI_LIMIT_KINDS + k) * N + (k == 0 ? QUARTER : HALF)] = 20;
    }
    out->layer_count = 3;
    out->layers[0] = test_layer(layers, NULL, NULL, DMI_LIMIT_INPUTS, HIDDEN);
    out->layers[1] = test_layer(layers, NULL, NULL, HIDDEN, HIDDEN);
    out->layers[2] = test_layer(layers, NULL, bias, HIDDEN, OUTPUTS);
}

/* The likelier of two ranges is answered, never what lies between; and of members that disagree, the surer one's. */
static void one_of_two_ranges_is_predicted(void** state) {
    (void)state;
    static dmi_limit_network net;
    test_env t;
    test_layers layers;
    test_env_open(&t, TEST_NEVER);
    test_layers_open(&layers, &t.env);
    for (int i = 0; i < N; i++) net.sizes[i] = 0.15f * (float)i;
    for (int m = 0; m < DMI_LIMIT_MEMBERS; m++) set_member(&layers, 0.4f, &net.members[m]);
    const dmi_limit_query query = {.candidate = NULL};
    dmi_limit_prediction prediction;
    dmi_limit_network_predict(&net, isa, &query, 1, &prediction);
    assert_true(prediction.lower == 0 && prediction.upper == net.sizes[QUARTER]);
    set_member(&layers, -10, &net.members[0]);
    dmi_limit_network_predict(&net, isa, &query, 1, &prediction);
    assert_true(prediction.lower == 0 && prediction.upper == net.sizes[HALF]);
    test_layers_close(&layers);
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_features_give_a_range_around_rest),
        cmocka_unit_test(joints_do_not_change_each_others_answers),
        cmocka_unit_test(room_on_one_side_opens_that_side),
        cmocka_unit_test(one_of_two_ranges_is_predicted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
