/* What pulls have said goes from drag to drag in sixteen bytes, adds up, and stays open to revision. */
#include "test_math.h"

#include <string.h>

#include "base/random.h"
#include "drag/hypothesis_tracker.h"
#include "drag/joint_hypothesis.h"

enum { PART = 77, RANKED = 3 };

static const float handle[3] = {0.3f, 0.3f, 0};
static const dm_joint ranked[RANKED] = {
    {.type = DM_JOINT_PRISMATIC, .joint_confidence = 0.5f, .axis = {1, 0, 0}, .upper = 0.6f},
    {.type = DM_JOINT_PRISMATIC, .joint_confidence = 0.4f, .axis = {0, 1, 0}, .upper = 0.6f},
    {.type = DM_JOINT_REVOLUTE, .joint_confidence = 0.3f, .axis = {1, 0, 0}, .origin = {0, -0.7f, 0}, .upper = 2}};

static dmi_hypothesis_tracker begun(const dmi_pull_evidence* earlier) {
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, ranked, NULL, RANKED, handle, 1, (dmi_limit_give){.length = 4});
    dmi_pull_evidence_recall(&tracker, ranked, RANKED, earlier);
    return tracker;
}

/* Pulls straight and roughly up, 30 degrees to the right, seen along -z without perspective. */
static void pull_up(dmi_hypothesis_tracker* tracker) {
    for (int k = 1; k <= 30; k++) {
        const float way = 0.01f * (float)k;
        const dm_ray ray = {{handle[0] + 0.5f * way, handle[1] + 0.866f * way, 5}, {0, 0, -1}};
        dmi_hypothesis_tracker_update(tracker, 0, &ray, DMI_PARALLEL);
    }
}

/* Any evidence comes back within half a step of an eighth, clamped; of another part, or of no pull, nothing does. */
static void evidence_fits_sixteen_bytes(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 5);
    for (int i = 0; i < 1000; i++) {
        dmi_pull_evidence given = {.pulls = 1 + dmi_random_u32(&random) % 400,
                                   .others = test_range(&random, -12, 0),
                                   .own = test_range(&random, -20, 20)};
        for (int k = 0; k < DM_MAX_HYPOTHESES; k++) given.ranked[k] = test_range(&random, -12, 0);
        uint32_t words[DMI_EVIDENCE_WORDS];
        dmi_pull_evidence_pack(&given, PART, words);
        const dmi_pull_evidence back = dmi_pull_evidence_unpack(words, PART);
        assert_int_equal(back.pulls, given.pulls < 255 ? given.pulls : 255);
        assert_near(back.others, fmaxf(given.others, -8), 0.0626);
        assert_near(back.own, fminf(fmaxf(given.own, -15), 15), 0.0626);
        for (int k = 0; k < DM_MAX_HYPOTHESES; k++) assert_near(back.ranked[k], fmaxf(given.ranked[k], -8), 0.0626);
        assert_int_equal(dmi_pull_evidence_unpack(words, PART + 1).pulls, 0);
    }
    const dmi_pull_evidence none = {.pulls = 0};
    uint32_t words[DMI_EVIDENCE_WORDS] = {1, 2, 3, 4};
    dmi_pull_evidence_pack(&none, PART, words);
    for (int k = 0; k < DMI_EVIDENCE_WORDS; k++) assert_int_equal(words[k], 0);
    assert_int_equal(dmi_pull_evidence_unpack(words, 0).pulls, 0);
}

/* Without a pull, what came is what goes; without evidence, priors are those of the joints. */
static void no_pull_says_nothing(void** state) {
    (void)state;
    const dmi_pull_evidence none = {.pulls = 0}, some = {.pulls = 2, .ranked = {-1, -2, 0}, .others = -3};
    const dmi_hypothesis_tracker plain = begun(&none), told = begun(&some);
    for (int k = 0; k < RANKED; k++) {
        assert_int_equal(plain.list[k].rank, k);
        assert_near(told.list[k].log_prior, plain.list[k].log_prior + some.ranked[k], 1e-6);
    }
    const dmi_pull_evidence after = dmi_pull_evidence_collect(&told, &some);
    assert_memory_equal(&after, &some, sizeof some);
}

/* A pull up speaks against the slide to the side, and three speak louder, but never by more than 8 nats. */
static void pulls_add_up_and_stay_open_to_revision(void** state) {
    (void)state;
    dmi_pull_evidence evidence = {.pulls = 0};
    float gap = 0;
    for (uint32_t pull = 1; pull <= 12; pull++) {
        dmi_hypothesis_tracker tracker = begun(&evidence);
        pull_up(&tracker);
        evidence = dmi_pull_evidence_collect(&tracker, &evidence);
        uint32_t words[DMI_EVIDENCE_WORDS];
        dmi_pull_evidence_pack(&evidence, PART, words);
        evidence = dmi_pull_evidence_unpack(words, PART);
        assert_int_equal(evidence.pulls, pull);
        const float now = evidence.ranked[1] - evidence.ranked[0];
        if (pull <= 2) assert_true(now > gap + 1);
        if (pull > 3) assert_true(now > 6);
        gap = now;
        assert_true(evidence.ranked[0] >= -8);
    }
}

/* A joint that is none of the ranked keeps the posterior that it had. */
static void a_joint_of_the_instance_keeps_its_odds(void** state) {
    (void)state;
    dm_joint joints[1 + RANKED];
    joints[0] = ranked[2];
    joints[0].origin.y = -0.5f;
    memcpy(joints + 1, ranked, sizeof ranked);
    const dmi_pull_evidence earlier = {.pulls = 1, .own = 2.5f, .ranked = {-1, 0, -4}};
    dmi_hypothesis_tracker tracker;
    dmi_hypothesis_tracker_init(&tracker, joints, NULL, 1 + RANKED, handle, 1, (dmi_limit_give){.length = 4});
    dmi_pull_evidence_recall(&tracker, ranked, RANKED, &earlier);
    assert_int_equal(tracker.list[0].rank, DMI_UNRANKED);
    assert_near(tracker.list[0].log_prior, 2.5 + (double)dmi_lever_arm_log_prior(&tracker.grasp, &joints[0]), 1e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(evidence_fits_sixteen_bytes),
        cmocka_unit_test(no_pull_says_nothing),
        cmocka_unit_test(pulls_add_up_and_stay_open_to_revision),
        cmocka_unit_test(a_joint_of_the_instance_keeps_its_odds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
