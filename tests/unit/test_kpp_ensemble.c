/* KPP-Net's opinion of a part: what its looks have in common, and shares of candidates that add up. */
#include "test_env.h"

#include <math.h>

#include "kinematics/features/kpp_ensemble.h"
#include "math/linear3.h"
#include "test_shapes.h"
#include "test_world.h"

enum { CANDIDATES = 40 };

typedef struct bench {
    test_env t;
    dmi_mesh* mesh;
    dmi_kpp_net* net;
    void* scratch;
    size_t scratch_size;
    dmi_cloud cloud;
    dmi_kpp_ensemble opinion;
} bench;

/* The cabinet's door, looked at by the network that ships. */
static bench* open_bench(const dmi_drag_hint* hint) {
    bench* b = malloc(sizeof *b);
    assert_non_null(b);
    test_env_open(&b->t, TEST_NEVER);
    static test_shape shape;
    test_shape_cabinet(&shape);
    dm_mesh_desc desc = test_shape_desc(&shape);
    dmi_axes axes;
    assert_true(dmi_axes_init(&axes, DM_AXES_GLTF, NULL, 0));
    assert_int_equal(dmi_mesh_create(&b->t.env, &axes, &desc, NULL, 0, NULL, &b->mesh), DM_OK);
    assert_int_equal(dmi_cloud_sample(&b->t.env, b->mesh, 1, 5, &b->cloud), DM_OK);
    size_t size;
    void* weights = test_read_file("sdk/models/kpp_net.safetensors", &size);
    assert_int_equal(dmi_kpp_net_load(&b->t.env, weights, size, &b->net), DM_OK);
    free(weights);
    b->scratch_size = dmi_kpp_net_scratch_size(b->net);
    b->scratch = dmi_alloc(&b->t.env, b->scratch_size, 64);
    assert_non_null(b->scratch);
    dmi_kpp_ensemble_run(b->net, dmi_cpu_best_isa(), &b->cloud, hint, b->scratch, &b->opinion);
    return b;
}

static void close_bench(bench* b) {
    dmi_free(&b->t.env, b->scratch, b->scratch_size);
    dmi_kpp_net_destroy(b->net);
    dmi_mesh_destroy(&b->t.env, b->mesh);
    test_env_close(&b->t);
    free(b);
}

/* The axes and the line are one look's each, never a mean of two; the type is the mean of all. */
static void an_opinion_is_a_look(void** state) {
    (void)state;
    bench* b = open_bench(NULL);
    const dmi_prediction* p = &b->opinion.prediction;
    float type[DMI_KPP_TYPES] = {0};
    int turns = 0, slides = 0;
    for (int i = 0; i < DMI_KPP_MEMBERS; i++) {
        dmi_prediction look;
        dmi_prediction_read(&b->opinion.input[i].frame, &b->opinion.output[i], &look);
        turns += memcmp(look.turn_axis, p->turn_axis, sizeof look.turn_axis) == 0 &&
                 memcmp(look.origin, p->origin, sizeof look.origin) == 0 &&
                 memcmp(look.turn_limits, p->turn_limits, sizeof look.turn_limits) == 0;
        slides += memcmp(look.slide_axis, p->slide_axis, sizeof look.slide_axis) == 0 &&
                  memcmp(look.slide_limits, p->slide_limits, sizeof look.slide_limits) == 0;
        for (int k = 0; k < DMI_KPP_TYPES; k++) type[k] += look.type[k] / DMI_KPP_MEMBERS;
    }
    assert_true(turns > 0 && slides > 0);
    for (int k = 0; k < DMI_KPP_TYPES; k++) assert_float_equal(type[k], p->type[k], 1e-6);
    close_bench(b);
}

/* The look that is answered lies at least as near to the others as any other does. */
static void an_opinion_is_in_the_middle(void** state) {
    (void)state;
    const dmi_drag_hint hint = {{0.3f, 0.1f, 0.2f}, {0, 0, 1}};
    bench* b = open_bench(&hint);
    float sum[DMI_KPP_MEMBERS] = {0}, answered = 0, least = INFINITY;
    for (int i = 0; i < DMI_KPP_MEMBERS; i++) {
        dmi_prediction one, other;
        dmi_prediction_read(&b->opinion.input[i].frame, &b->opinion.output[i], &one);
        for (int k = 0; k < DMI_KPP_MEMBERS; k++) {
            dmi_prediction_read(&b->opinion.input[k].frame, &b->opinion.output[k], &other);
            sum[i] += acosf(fminf(fabsf(dmi_dot3(one.slide_axis, other.slide_axis)), 1));
        }
        least = fminf(least, sum[i]);
        if (memcmp(one.slide_axis, b->opinion.prediction.slide_axis, sizeof one.slide_axis) == 0) answered = sum[i];
    }
    assert_float_equal(answered, least, 1e-6);
    close_bench(b);
}

/* Means of log-probabilities: together no more than certain, and the same however the candidates are ordered. */
static void scores_are_shares(void** state) {
    (void)state;
    bench* b = open_bench(NULL);
    dmi_candidate candidates[CANDIDATES], reversed[CANDIDATES];
    static float scores[DMI_CANDIDATES_MAX], backwards[DMI_CANDIDATES_MAX];
    for (int i = 0; i < CANDIDATES; i++) {
        const float angle = 0.3f * (float)i;
        candidates[i] = (dmi_candidate){.type = i % 3 == 0 ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE,
                                        .axis = {cosf(angle), sinf(angle), 0},
                                        .origin = {0, 0, 0.02f * (float)i}};
        reversed[CANDIDATES - 1 - i] = candidates[i];
    }
    dmi_kpp_ensemble_score(b->net, dmi_cpu_best_isa(), &b->opinion, candidates, CANDIDATES, scores);
    dmi_kpp_ensemble_score(b->net, dmi_cpu_best_isa(), &b->opinion, reversed, CANDIDATES, backwards);
    float sum = 0;
    for (int i = 0; i < CANDIDATES; i++) {
        sum += expf(scores[i]);
        assert_float_equal(scores[i], backwards[CANDIDATES - 1 - i], 1e-4);
    }
    assert_true(sum > 0 && sum <= 1.0001f);
    close_bench(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_opinion_is_a_look),
        cmocka_unit_test(an_opinion_is_in_the_middle),
        cmocka_unit_test(scores_are_shares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
