/* Alternatives: the likeliest candidates that move the part unlike each other and unlike its hypotheses. */
#include "test_analysis.h"

#include <math.h>

#include "base/random.h"
#include "kinematics/candidates/twist.h"
#include "kinematics/ranking/alternatives.h"

#define ALIKE 0.1f /* twist difference up to which candidates are one alternative */

static test_shape shape;
static test_analysis a;
static dmi_candidate candidates[DMI_CANDIDATES_MAX];
static float probability[DMI_CANDIDATES_MAX];

/* Returns how many candidates there are. */
static uint32_t open_pile(void) {
    dmi_random random = dmi_random_make(5, 2);
    test_shape_pile(&shape, &random);
    test_analysis_open(&a, &shape, 3);
    const uint32_t count = dmi_candidates_make(&a.of_part, NULL, NULL, candidates);
    for (uint32_t i = 0; i < count; i++) probability[i] = dmi_random_unit(&random) / (float)count;
    return count;
}

static dm_joint joint_of(const dmi_candidate* c) {
    return (dm_joint){.type = c->type,
                      .axis = {c->axis[0], c->axis[1], c->axis[2]},
                      .origin = {c->origin[0], c->origin[1], c->origin[2]}};
}

static bool alike(const dmi_twist* one, const dmi_twist* other) {
    return !(dmi_twist_difference(one, other) > ALIKE);
}

/* What is left of all candidates is given by a plain search, one alternative after the other: the likeliest that no
 * hypothesis and no earlier one moves alike, with the probability of all that it takes along. */
static void check(uint32_t count, uint32_t hypothesis_count, const dmi_ranker* ranker, int dragged) {
    static dmi_twist motions[DMI_CANDIDATES_MAX];
    static bool gone[DMI_CANDIDATES_MAX];
    dm_joint hypotheses[4] = {{0}};
    dmi_alternatives found;
    for (uint32_t i = 0; i < count; i++) {
        dmi_twist_of_candidate(&a.of_part, &candidates[i], &motions[i]);
        gone[i] = false;
    }
    for (uint32_t h = 0; h < hypothesis_count; h++) {
        hypotheses[h] = joint_of(&candidates[h * 37 % count]);
        dmi_twist known;
        dmi_twist_of_joint(&a.of_part, &hypotheses[h], &known);
        for (uint32_t i = 0; i < count; i++) gone[i] |= alike(&known, &motions[i]);
    }
    assert_int_equal(dmi_alternatives_find(&a.arena, &a.of_part, ranker, dragged, hypotheses, hypothesis_count,
                                           candidates, probability, count, &found),
                     DM_OK);
    uint32_t next = 0;
    for (; next < DMI_ALTERNATIVES; next++) {
        uint32_t best = UINT32_MAX;
        float mass = 0;
        for (uint32_t i = 0; i < count; i++)
            if (!gone[i] && (best == UINT32_MAX || probability[i] > probability[best])) best = i;
        if (best == UINT32_MAX) break;
        for (uint32_t i = 0; i < count; i++) {
            if (gone[i] || !alike(&motions[best], &motions[i])) continue;
            mass += probability[i];
            gone[i] = true;
        }
        assert_true(next < found.count);
        const dmi_alternative* got = &found.list[next];
        assert_int_equal(got->type, candidates[best].type);
        assert_memory_equal(got->axis, candidates[best].axis, sizeof got->axis);
        assert_memory_equal(got->origin, candidates[best].origin, sizeof got->origin);
        assert_float_equal(got->confidence, dmi_ranker_confidence(ranker, dragged, mass), 1e-6f);
    }
    assert_int_equal(found.count, next);
}

static void a_plain_search_finds_the_same(void** state) {
    (void)state;
    static dmi_ranker ranker = {.calibration = {{0.8f, -0.2f}, {1.3f, 0.4f}}};
    const uint32_t count = open_pile();
    assert_true(count > 300);
    for (uint32_t hypotheses = 0; hypotheses <= 4; hypotheses++) check(count, hypotheses, NULL, 0);
    for (int dragged = 0; dragged < 2; dragged++) check(count, 2, &ranker, dragged);
    for (uint32_t few = 1; few < 40; few += 3) check(few, few % 3, &ranker, 1);
    for (uint32_t i = 0; i < count; i++) probability[i] = 1.0f / (float)count; /* of equals the first */
    check(count, 1, NULL, 0);
    for (uint32_t i = 0; i < count; i++) probability[i] = i % 2 ? 0 : 1e-9f; /* what has none at all comes, too */
    check(count, 0, NULL, 0);
    test_analysis_close(&a);
}

static void without_candidates_there_are_none(void** state) {
    (void)state;
    open_pile();
    dmi_alternatives found = {.count = 9};
    assert_int_equal(dmi_alternatives_find(&a.arena, &a.of_part, NULL, 0, NULL, 0, candidates, probability, 0, &found),
                     DM_OK);
    assert_int_equal(found.count, 0);
    test_analysis_close(&a);
}

/* The joint of an alternative is its own, without limits. */
static void an_alternative_is_a_joint(void** state) {
    (void)state;
    const dmi_alternative one = {
        .type = DM_JOINT_PRISMATIC, .confidence = 0.25f, .axis = {0, 0.6f, 0.8f}, .origin = {1, 2, 3}};
    const dm_joint joint = dmi_alternative_joint(&one);
    const dm_joint want = {.type = DM_JOINT_PRISMATIC,
                           .type_confidence = 0.25f,
                           .joint_confidence = 0.25f,
                           .axis = {0, 0.6f, 0.8f},
                           .origin = {1, 2, 3},
                           .source = DM_JOINT_FROM_GEOMETRY};
    assert_memory_equal(&joint, &want, sizeof joint);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plain_search_finds_the_same),
        cmocka_unit_test(without_candidates_there_are_none),
        cmocka_unit_test(an_alternative_is_a_joint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
