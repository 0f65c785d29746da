/* What a pull says of a joint: hands that follow it, that go straight to its end, and that do not know its way. */
#include "test_math.h"

#include <string.h>

#include "drag/joint_hypothesis.h"
#include "math/linear3.h"

static const float handle[3] = {0.3f, 0.3f, 0};
static const dm_joint drawer = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .upper = 0.6f};
static const dm_joint lift = {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}, .upper = 0.6f};
static const dm_joint door = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .origin = {0.3f, -0.7f, 0}, .lower = -2};

/* A grasp that is seen along -z by a camera without perspective, after a straight pull at an angle from +x. */
static dmi_grasp pulled(float angle, float length) {
    dmi_grasp grasp = {.size = 1, .limit_give = {.length = 4}};
    dmi_pull_begin(&grasp.pull, handle, 0.006f);
    grasp.pull.projection = DMI_PARALLEL;
    for (int k = 1; k <= 20; k++) {
        const float way = length * (float)k / 20;
        const dm_ray ray = {{handle[0] + way * cosf(angle), handle[1] + way * sinf(angle), 5}, {0, 0, -1}};
        dmi_grasp_add(&grasp, &ray);
    }
    return grasp;
}

static dmi_joint_hypothesis made(const dmi_grasp* grasp, const dm_joint* joint) {
    return dmi_joint_hypothesis_make(grasp, joint, 0, false, dmi_unbounded_range());
}

/* Returns the log likelihood of a joint whose misses count for nothing. */
static double of_direction(const dmi_grasp* grasp, const dm_joint* joint) {
    const dmi_joint_hypothesis hypothesis = made(grasp, joint);
    return (double)dmi_joint_hypothesis_log_likelihood(grasp, &hypothesis, 1e9f);
}

/* A power law of the miss over what a right joint has: 1/100 of the pull and 3/2000 of the part. A straight path lies
 * along a straight pull by chance: 0.8 nats less, 1.2 more where a lifting hand goes. Both fade by the sagitta of the
 * path over that, and by the bend of the pull. */
static void a_miss_counts_by_a_power_law(void** state) {
    (void)state;
    for (int bent = 0; bent < 2; bent++) {
        dmi_grasp grasp = pulled(0, 0.4f);
        const double expected = 0.01 * 0.4 + 0.0015, sagitta = 0.125 * 0.4 * 0.4;
        assert_near(dmi_expected_residual(&grasp), expected, 1e-7);
        assert_near(grasp.straightness, 0, 1e-4); /* nothing bends it */
        if (bent) grasp.straightness = -3;
        const double share = bent ? 0.25 : 1;
        dmi_joint_hypothesis slide = made(&grasp, &drawer), turn = made(&grasp, &door), up = made(&grasp, &lift);
        up.upright = true;
        for (int k = 0; k <= 20; k++) {
            const float miss = 0.02f * (float)(k * k) / 20;
            const double law = -3.5 * log(1 + (double)miss / expected);
            assert_near(dmi_followed_log_likelihood(&grasp, &turn, miss),
                        law - share * 0.8 * expected / (expected + sagitta), 1e-4);
            assert_near(dmi_followed_log_likelihood(&grasp, &slide, miss), law - share * 0.8, 1e-4);
            assert_near(dmi_followed_log_likelihood(&grasp, &up, miss), law - share * 2, 1e-4);
        }
    }
}

/* A hand that holds a part away from rest has seen its way. */
static void an_open_part_is_pulled_along_its_way(void** state) {
    (void)state;
    dmi_grasp grasp = pulled(0.4f, 0.4f);
    grasp.was_open = true;
    const dmi_joint_hypothesis slide = made(&grasp, &drawer);
    assert_near(dmi_followed_log_likelihood(&grasp, &slide, 0), 0, 1e-6);
    assert_true(of_direction(&grasp, &drawer) < -40);
}

/* Slides and turns alike: flat within some 30 degrees of the first motion as seen, much less beyond 50, and no less
 * than for a hand that goes astray. */
static void a_straight_pull_says_roughly_this_way(void** state) {
    (void)state;
    const double most_slide = -3, most_turn = -2.67;
    for (int degrees = 0; degrees <= 80; degrees += 5) {
        const float angle = (float)degrees * 3.14159265f / 180;
        const dmi_grasp grasp = pulled(angle, 0.4f);
        const double square = 2 * (1 - cos((double)angle)) / (0.66 * 0.66);
        const double law = fmax(-0.5 * square * square, -13.2);
        assert_near(of_direction(&grasp, &drawer), most_slide + law, 0.02);
        /* the door turns the other way: its first motion towards +x has a negative value, and so has its range */
        const dmi_joint_hypothesis turn = made(&grasp, &door);
        const double chord = dmi_pull_is_on_chord(&grasp.pull, &turn.joint) ? exp(-2.5) : 0;
        assert_near(of_direction(&grasp, &door), log(exp(most_turn + law) + chord), 0.02);
    }
}

/* Away from the side of its range a joint is pulled less often, into its body hardly. */
static void a_pull_against_the_range_says_more(void** state) {
    (void)state;
    const dmi_grasp grasp = pulled(3.14159265f, 0.4f);
    dmi_joint_hypothesis away = made(&grasp, &drawer), into = away, both = away;
    into.other_side_blocked = true;
    both.side = 0;
    assert_near(dmi_joint_hypothesis_log_likelihood(&grasp, &both, 1e9f), -3, 0.02);
    assert_near(dmi_joint_hypothesis_log_likelihood(&grasp, &away, 1e9f), -3.59, 0.02);
    assert_near(dmi_joint_hypothesis_log_likelihood(&grasp, &into, 1e9f), -7, 0.02);
}

/* People do not pull along what they do not see: a first motion seen at less than 0.18 of its length says nothing. */
static void what_is_not_seen_is_not_pulled_along(void** state) {
    (void)state;
    const dmi_grasp grasp = pulled(0, 0.4f);
    for (int k = 0; k < 2; k++) {
        const float seen = k ? 0.19f : 0.17f;
        dm_joint slide = drawer;
        slide.axis = (dm_vec3){seen, 0, sqrtf(1 - seen * seen)};
        assert_int_equal(of_direction(&grasp, &slide) > -5, k);
    }
}

/* A pull that bends is none of a hand that goes straight. */
static void a_bend_rules_rough_hands_out(void** state) {
    (void)state;
    dmi_grasp grasp = pulled(0, 0.4f);
    assert_true(dmi_grasp_is_straight(&grasp));
    grasp.pull.bend = 0.05f;
    assert_false(dmi_grasp_is_straight(&grasp));
    const dm_ray ray = {{handle[0] + 0.4f, handle[1] + 0.2f, 5}, {0, 0, -1}};
    dmi_grasp_add(&grasp, &ray);
    assert_near(grasp.straightness, -3.5 * log(1 + (double)(grasp.pull.bend / dmi_expected_residual(&grasp))), 1e-3);
    assert_true(grasp.straightness < -6);
    assert_near(of_direction(&grasp, &drawer), -9 - 0.5 * pow(2 * (1 - cos(atan2(0.2, 0.4))) / (0.66 * 0.66), 2),
                0.02); /* it wavered */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_miss_counts_by_a_power_law),          cmocka_unit_test(an_open_part_is_pulled_along_its_way),
        cmocka_unit_test(a_straight_pull_says_roughly_this_way), cmocka_unit_test(a_pull_against_the_range_says_more),
        cmocka_unit_test(what_is_not_seen_is_not_pulled_along),  cmocka_unit_test(a_bend_rules_rough_hands_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
