/* The residual: when a chosen candidate stays as it is, and where the joint goes when it doesn't. */
#include "test_env.h"

#include <math.h>

#include "kinematics/ranking/consensus_refine.h"
#include "test_math.h"

static dmi_candidate hinge_at(float x, float y, float tilt) {
    return (dmi_candidate){.type = DM_JOINT_REVOLUTE, .axis = {sinf(tilt), 0, cosf(tilt)}, .origin = {x, y, 0.3f}};
}

static dm_joint joint_of(const dmi_candidate* c) {
    return (dm_joint){.type = c->type,
                      .axis = {c->axis[0], c->axis[1], c->axis[2]},
                      .origin = {c->origin[0], c->origin[1], c->origin[2]}};
}

static dm_joint apply(const dmi_candidate* candidates, const float* weights, uint32_t count) {
    dmi_weighted_candidate voices[DMI_CONSENSUS_MAX];
    dm_joint joint = joint_of(candidates);
    for (uint32_t i = 0; i < count; i++) voices[i] = (dmi_weighted_candidate){&candidates[i], weights[i]};
    dmi_consensus_refine(candidates, voices, count, &joint);
    return joint;
}

static void what_has_half_of_them_stays_to_the_bit(void** state) {
    (void)state;
    const dmi_candidate hinges[] = {hinge_at(0.1f, 0.2f, 0), hinge_at(0.14f, 0.2f, 0.1f), hinge_at(0.1f, 0.25f, -0.1f)};
    const float weights[] = {0.5f, 0.3f, 0.2f};
    const dm_joint joint = apply(hinges, weights, 3), before = joint_of(hinges);
    assert_memory_equal(&joint, &before, sizeof joint);
    const dm_joint alone = apply(hinges, weights, 1);
    assert_memory_equal(&alone, &before, sizeof alone);
}

static void axes_of_either_sign_are_averaged(void** state) {
    (void)state;
    dmi_candidate hinges[] = {hinge_at(0, 0, 0), hinge_at(0, 0, 0.1f), hinge_at(0, 0, 0.2f)};
    for (int k = 0; k < 3; k++) hinges[2].axis[k] *= -1;
    const float weights[] = {0.4f, 0.2f, 0.4f};
    const dm_joint joint = apply(hinges, weights, 3);
    assert_float_equal(joint.axis.x, sinf(0.1f), 1e-4f);
    assert_float_equal(joint.axis.z, cosf(0.1f), 1e-4f);
    assert_float_equal(joint.origin.x, 0, 0);
}

/* Three equal lines: the point from which they are seen 120 degrees apart, here the triangle's middle. */
static void lines_meet_in_their_median(void** state) {
    (void)state;
    dmi_candidate hinges[3];
    for (int i = 0; i < 3; i++) hinges[i] = hinge_at(cosf(2.0944f * (float)i), sinf(2.0944f * (float)i), 0);
    const float weights[] = {1, 1, 1};
    const dm_joint joint = apply(hinges, weights, 3);
    assert_float_equal(joint.origin.x, 0, 1e-3f);
    assert_float_equal(joint.origin.y, 0, 1e-3f);
    assert_float_equal(joint.origin.z, 0.3f, 1e-6f);
    assert_float_equal(joint.axis.z, 1, 0);
}

static void support_without_weight_moves_nothing(void** state) {
    (void)state;
    const dmi_candidate hinges[] = {hinge_at(0, 0, 0), hinge_at(0, 0, 0.1f), hinge_at(0, 0, 0.2f)};
    const float weights[] = {1e-43f, 3e-42f, 3e-42f}; /* what a ranker without any certainty leaves of them */
    const dm_joint joint = apply(hinges, weights, 3);
    assert_float_equal(joint.axis.z, 1, 1e-6f);
}

static void a_slide_keeps_its_place(void** state) {
    (void)state;
    dmi_candidate slides[] = {hinge_at(0, 0, 0), hinge_at(0.5f, 0, 0.1f), hinge_at(0.5f, 0, 0.2f)};
    for (int i = 0; i < 3; i++) slides[i].type = DM_JOINT_PRISMATIC;
    const float weights[] = {0.2f, 0.2f, 0.2f};
    const dm_joint joint = apply(slides, weights, 3);
    assert_float_equal(joint.axis.x, sinf(0.1f), 1e-3f);
    assert_float_equal(joint.origin.x, 0, 0);
}

static float cost(const dmi_candidate* hinges, const float* weights, uint32_t count, float x, float y) {
    float sum = 0;
    for (uint32_t i = 0; i < count; i++) sum += weights[i] * hypotf(hinges[i].origin[0] - x, hinges[i].origin[1] - y);
    return sum;
}

/* Whatever the lines: no candidate's own is nearer to all of them together. */
static void no_line_is_nearer_to_all(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(11, 11);
    for (int round = 0; round < 300; round++) {
        dmi_candidate hinges[DMI_CONSENSUS_MAX];
        float weights[DMI_CONSENSUS_MAX];
        const uint32_t count = 1 + (uint32_t)round % DMI_CONSENSUS_MAX;
        for (uint32_t i = 0; i < count; i++) {
            hinges[i] = hinge_at(test_range(&random, -0.1f, 0.1f), test_range(&random, -0.1f, 0.1f), 0);
            weights[i] = test_range(&random, 0, 1);
        }
        const dm_joint joint = apply(hinges, weights, count);
        const float there = cost(hinges, weights, count, joint.origin.x, joint.origin.y);
        for (uint32_t i = 0; i < count; i++)
            assert_true(there <= cost(hinges, weights, count, hinges[i].origin[0], hinges[i].origin[1]) * 1.001f);
    }
}

static void other_directions_and_types_do_not_count(void** state) {
    (void)state;
    const dmi_candidate hinge = hinge_at(0, 0, 0), near = hinge_at(0, 0, 0.3f), across = hinge_at(0, 0, 1.2f);
    dmi_candidate slide = hinge, back = near;
    slide.type = DM_JOINT_PRISMATIC;
    for (int k = 0; k < 3; k++) back.axis[k] *= -1;
    assert_true(dmi_consensus_counts(&hinge, &hinge));
    assert_true(dmi_consensus_counts(&hinge, &near));
    assert_true(dmi_consensus_counts(&hinge, &back));
    assert_false(dmi_consensus_counts(&hinge, &across));
    assert_false(dmi_consensus_counts(&hinge, &slide));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_half_of_them_stays_to_the_bit),
        cmocka_unit_test(axes_of_either_sign_are_averaged),
        cmocka_unit_test(lines_meet_in_their_median),
        cmocka_unit_test(support_without_weight_moves_nothing),
        cmocka_unit_test(a_slide_keeps_its_place),
        cmocka_unit_test(no_line_is_nearer_to_all),
        cmocka_unit_test(other_directions_and_types_do_not_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
