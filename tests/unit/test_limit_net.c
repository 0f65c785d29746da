/* The limits' network of the shipped weights: whatever the features, a range that holds the rest. */
#include "test_env.h"

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "kinematics/ranker.h"
#include "test_world.h"

static dmi_ranker* open_ranker(test_env* t) {
    size_t size;
    void* bytes = test_read_file("sdk/models/ranker.safetensors", &size);
    dmi_ranker* ranker = NULL;
    assert_int_equal(dmi_ranker_load(&t->env, bytes, size, &ranker), DM_OK);
    free(bytes);
    return ranker;
}

static void any_features_give_a_range_around_rest(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_ranker* ranker = open_ranker(&t);
    const dmi_limit_net* net = dmi_ranker_limits(ranker);
    dmi_random random = dmi_random_make(3, 1);
    for (int i = 0; i < 500; i++) {
        float features[DMI_LIMIT_FEATURES], lower, upper, free_turn;
        for (int k = 0; k < DMI_LIMIT_FEATURES; k++)
            features[k] = dmi_random_normal(&random) * (i % 2 == 0 ? 1.0f : 50.0f);
        dmi_limit_net_forward(net, features, &lower, &upper, &free_turn);
        assert_true(isfinite(lower) && isfinite(upper) && isfinite(free_turn));
        assert_true(lower <= 0 && upper >= 0 && upper - lower > 0.009f);
    }
    dmi_ranker_destroy(ranker);
    test_env_close(&t);
}

/* A door that meets the body at once one way and not at all the other opens the other way. */
static void room_on_one_side_opens_that_side(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_ranker* ranker = open_ranker(&t);
    const dmi_limit_net* net = dmi_ranker_limits(ranker);
    float features[DMI_LIMIT_FEATURES], lower, upper, free_turn;
    memcpy(features, net->mean, sizeof features);
    features[0] = 0, features[1] = 1;
    features[2] = features[3] = 2.5f; /* rad of room the way of the drag */
    features[4] = features[5] = 0;    /* and none back */
    dmi_limit_net_forward(net, features, &lower, &upper, &free_turn);
    assert_true(upper > 0.3f && upper > -2 * lower);
    dmi_ranker_destroy(ranker);
    test_env_close(&t);
}

/* Rests at an end and goes 1.5 or 3 rad: the likelier is answered, never what lies between. */
static void one_of_two_ranges_is_answered(void** state) {
    (void)state;
    static dmi_limit_net net;
    enum { N = DMI_LIMIT_SIZES, SIDES = 1 + DMI_LIMIT_KINDS, QUARTER = 10, HALF = 20 };
    for (int i = 0; i < N; i++) net.sizes[i] = 0.15f * (float)i;
    for (int k = 0; k < DMI_LIMIT_KINDS; k++) {
        net.last_bias[1 + k] = k > 1 ? -20.0f : k == 0 ? 0.4f : 0;
        net.last_bias[SIDES + k * N] = 20; /* no way down */
        net.last_bias[SIDES + (DMI_LIMIT_KINDS + k) * N + (k == 0 ? QUARTER : HALF)] = 20;
    }
    const float features[DMI_LIMIT_FEATURES] = {0};
    float lower, upper, free_turn;
    dmi_limit_net_forward(&net, features, &lower, &upper, &free_turn);
    assert_true(lower == 0 && upper == net.sizes[QUARTER]);
    net.last_bias[1] = -1;
    dmi_limit_net_forward(&net, features, &lower, &upper, &free_turn);
    assert_true(lower == 0 && upper == net.sizes[HALF]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_features_give_a_range_around_rest),
        cmocka_unit_test(room_on_one_side_opens_that_side),
        cmocka_unit_test(one_of_two_ranges_is_answered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
