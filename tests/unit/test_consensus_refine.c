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

/* The least cost of all places, by descent on ever finer grids. */
static float least_cost(const dmi_candidate* hinges, const float* weights, uint32_t count) {
    float at[2] = {0, 0}, least = cost(hinges, weights, count, 0, 0);
    for (float step = 0.1f; step > 1e-6f; step *= 0.7f) {
        const float middle[2] = {at[0], at[1]};
        for (int i = -2; i <= 2; i++)
            for (int k = -2; k <= 2; k++) {
                const float x = middle[0] + step * (float)i, y = middle[1] + step * (float)k;
                const float there = cost(hinges, weights, count, x, y);
                if (there < least) least = there, at[0] = x, at[1] = y;
            }
    }
    return least;
}

/* The place found costs hardly more than the best of all places, for few lines and many: 3 of 200 cost a thousandth
 * more, none a hundredth. */
static void no_place_is_nearer_to_all(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 9);
    int rough = 0;
    for (int round = 0; round < 200; round++) {
        dmi_candidate hinges[DMI_CONSENSUS_MAX];
        float weights[DMI_CONSENSUS_MAX];
        const uint32_t count = round < 100 ? 3 + (uint32_t)round % 3 : DMI_CONSENSUS_MAX;
        for (uint32_t i = 0; i < count; i++) {
            hinges[i] = hinge_at(test_range(&random, -0.1f, 0.1f), test_range(&random, -0.1f, 0.1f), 0);
            weights[i] = test_range(&random, 0.1f, 1);
        }
        const dm_joint joint = apply(hinges, weights, count);
        const float there = cost(hinges, weights, count, joint.origin.x, joint.origin.y);
        const float least = least_cost(hinges, weights, count);
        assert_true(there <= least * 1.01f);
        rough += there > least * 1.001f;
    }
    assert_true(rough < 5); /* where a line is all but the median, the rounds end before */
}

/* The middle line of three is nearest to the others, but not the median: that is where all are 120 degrees apart, 0.538
 * of the way to them. The pull away from it is along one direction; every direction is tried. */
static void the_median_leaves_the_middle_line(void** state) {
    (void)state;
    for (int i = 0; i < 16; i++) {
        const float angle = 0.3926991f * (float)i, x = 0.1f * cosf(angle), y = 0.1f * sinf(angle);
        const dmi_candidate hinges[] = {hinge_at(0, 0, 0), hinge_at(x - 0.8f * y, y + 0.8f * x, 0),
                                        hinge_at(x + 0.8f * y, y - 0.8f * x, 0)};
        const float weights[] = {0.3f, 0.3f, 0.3f};
        const dm_joint joint = apply(hinges, weights, 3);
        assert_float_equal(joint.origin.x, 0.53812f * x, 2e-4f);
        assert_float_equal(joint.origin.y, 0.53812f * y, 2e-4f);
    }
}

/* A line on which half of the weight lies is the median, to the bit, whichever it is and though several candidates have
 * it; with less than that it is not, where all others lie on one side. */
static void half_of_the_weight_is_the_median(void** state) {
    (void)state;
    for (int heavy = 0; heavy < 2; heavy++) {
        const dmi_candidate hinges[] = {hinge_at(0, 0, 0), hinge_at(0.1f, 0.02f, 0), hinge_at(0.1f, 0.02f, 0),
                                        hinge_at(0.12f, -0.1f, 0)};
        const float weights[] = {0.2f, heavy ? 0.3f : 0.01f, heavy ? 0.25f : 0.01f, 0.25f};
        const dm_joint joint = apply(hinges, weights, 4);
        const float away = hypotf(joint.origin.x - 0.1f, joint.origin.y - 0.02f);
        assert_true(heavy ? away < 1e-6f : away > 0.01f);
    }
}

/* The mean of all axes, each by its weight and turned to the chosen one's side, unless half of the weight agrees with
 * the chosen one: is within 0.02 of its direction. */
static void the_axis_is_the_weighted_mean(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(8, 2);
    int kept = 0;
    for (int round = 0; round < 400; round++) {
        dmi_candidate hinges[DMI_CONSENSUS_MAX];
        float weights[DMI_CONSENSUS_MAX];
        double mean[3] = {0, 0, 0}, agreeing = 0, all = 0, length = 0;
        const uint32_t count = 1 + (uint32_t)round % 7;
        const float spread = round % 2 ? 0.04f : 0.5f;
        for (uint32_t i = 0; i < count; i++) {
            hinges[i] = hinge_at(0, 0, i ? test_range(&random, -spread, spread) : 0);
            weights[i] = test_range(&random, 0, 1);
            const double x = (double)hinges[i].axis[0], z = (double)hinges[i].axis[2];
            mean[0] += (double)weights[i] * x, mean[2] += (double)weights[i] * z, all += (double)weights[i];
            if (fabs(x) < 0.02) agreeing += (double)weights[i];
            for (int k = 0; i > 0 && round % 3 == 0 && k < 3; k++) hinges[i].axis[k] *= -1;
        }
        length = sqrt(mean[0] * mean[0] + mean[2] * mean[2]);
        if (fabs(agreeing - 0.5 * all) < 1e-6) continue;
        const int stays = agreeing > 0.5 * all;
        const dm_joint joint = apply(hinges, weights, count);
        kept += stays;
        assert_float_equal(joint.axis.x, (stays ? 0 : (float)(mean[0] / length)), 2e-6f);
        assert_float_equal(joint.axis.z, (stays ? 1 : (float)(mean[2] / length)), 2e-6f);
        assert_float_equal(joint.axis.y, 0, 0);
    }
    assert_true(kept > 50 && kept < 300);
}

/* Axes agree within a sine of 0.02; half of the weight is enough. */
static void agreement_ends_at_a_fiftieth(void** state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        const dmi_candidate hinges[] = {hinge_at(0, 0, 0), hinge_at(0, 0, i ? 0.0202f : 0.0198f), hinge_at(0, 0, 0.3f)};
        const float weights[] = {0.25f, 0.25f, 0.5f};
        const dm_joint joint = apply(hinges, weights, 3);
        assert_true((joint.axis.x > 0.01f) == i);
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
    const dmi_candidate within = hinge_at(0, 0, acosf(0.827f)), beyond = hinge_at(0, 0, acosf(0.823f));
    assert_true(dmi_consensus_counts(&hinge, &within));
    assert_false(dmi_consensus_counts(&hinge, &beyond));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_half_of_them_stays_to_the_bit),
        cmocka_unit_test(axes_of_either_sign_are_averaged),
        cmocka_unit_test(lines_meet_in_their_median),
        cmocka_unit_test(support_without_weight_moves_nothing),
        cmocka_unit_test(a_slide_keeps_its_place),
        cmocka_unit_test(no_line_is_nearer_to_all),
        cmocka_unit_test(no_place_is_nearer_to_all),
        cmocka_unit_test(the_median_leaves_the_middle_line),
        cmocka_unit_test(half_of_the_weight_is_the_median),
        cmocka_unit_test(the_axis_is_the_weighted_mean),
        cmocka_unit_test(agreement_ends_at_a_fiftieth),
        cmocka_unit_test(other_directions_and_types_do_not_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
