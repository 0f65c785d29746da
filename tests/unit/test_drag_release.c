/* Released parts: what was meant, no jump of place or speed on the way there, the same at any frame rate. */
#include "test_math.h"

#include "motion/drag.h"

#define FRAME (1.0f / 60)

static const dm_joint door = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = 0, .upper = 1.6f};

/* A part at `value` that moves on at `velocity`, held a moment ago. */
static dmi_drag held_at(const dm_joint* joint, float value, float velocity, const dm_drag_feel* feel) {
    const float rest[3] = {1, 0, 0};
    float grab[3];
    dmi_drag drag;
    const dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, rest, grab);
    dmi_drag_begin(&drag, joint, grab, value, feel);
    drag.velocity = velocity;
    return drag;
}

/* Runs to the end; fails on a jump of the value or, after the first steps, of its speed. */
static float run_out(dmi_drag* drag, float dt) {
    dm_drag_state now;
    float last = drag->value, speed = drag->velocity;
    dmi_drag_get_state(drag, &now);
    for (int k = 0; k < 100000 && now.phase != DM_DRAG_AT_REST; k++) {
        dmi_drag_update(drag, NULL, dt, &now);
        assert_near(now.value, last, 0.25 + 12 * (double)dt);
        assert_true(now.value >= drag->joint.lower || !dmi_joint_has_limits(&drag->joint));
        assert_true(now.value <= drag->joint.upper || !dmi_joint_has_limits(&drag->joint));
        const dm_pose pose = dmi_joint_pose(&drag->joint, now.value);
        assert_same_motion(&pose, &now.pose, 1, 1e-6);
        const int stopped = now.phase == DM_DRAG_AT_REST || now.at_limit != 0; /* what meets a stop, stops */
        if (dt < 2e-3f && !stopped && k > 0) assert_near(now.velocity, speed, 0.35);
        last = now.value, speed = now.velocity;
    }
    assert_int_equal(now.phase, DM_DRAG_AT_REST);
    assert_near(now.velocity, 0, 0);
    return now.value;
}

typedef struct meant_case {
    float value, velocity;
    int32_t intent;
    float end;
} meant_case;

static void the_hand_says_what_is_meant(void** state) {
    (void)state;
    const meant_case cases[] = {
        {0.8f, 0, DM_INTENT_STAY, 0.8f},     /* left half open */
        {0.05f, 0, DM_INTENT_CLOSE, 0},      /* nearly shut: falls shut */
        {0.5f, -4, DM_INTENT_CLOSE, 0},      /* thrown shut */
        {0.4f, 4, DM_INTENT_OPEN, 1.6f},     /* thrown open */
        {1.5f, 0.1f, DM_INTENT_OPEN, 1.6f},  /* nearly open */
        {0.05f, 5, DM_INTENT_OPEN, 1.6f},    /* just off the stop, and fast */
        {0.8f, 0.5f, DM_INTENT_STAY, 0.872f} /* glides on: 0.5 x 0.1 s / ln 2 */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_feel feel = {0};
        dmi_drag drag = held_at(&door, cases[i].value, cases[i].velocity, &feel);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        assert_int_equal(drag.release.intent, cases[i].intent);
        assert_near(run_out(&drag, FRAME), cases[i].end, 1e-3);
    }
}

/* A part that is thrown does not slow down on its way: it takes as long as at half the speed that it has. */
static void fast_parts_arrive_sooner(void** state) {
    (void)state;
    const float start = 0.4f, speed = 8;
    for (int thrown = 0; thrown < 2; thrown++) {
        const dm_drag_feel feel = {0};
        dmi_drag drag = held_at(&door, start, thrown ? speed : 0, &feel);
        dmi_drag_release(&drag, DM_INTENT_OPEN, 0);
        const float way = door.upper - start;
        assert_near(drag.release.duration, thrown ? 2 * way / speed : 0.7f * sqrtf(way / door.upper), 1e-4);
    }
}

static void no_release_jumps(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 6);
    for (int i = 0; i < 300; i++) {
        const dm_drag_feel feel = {0};
        const int32_t intents[] = {DM_INTENT_AUTO, DM_INTENT_STAY, DM_INTENT_OPEN, DM_INTENT_CLOSE};
        dmi_drag drag = held_at(&door, test_range(&random, 0, 1.6f), test_range(&random, -5, 5), &feel);
        dmi_drag_release(&drag, intents[i % 4], 0);
        const float end = run_out(&drag, 1e-3f);
        assert_near(end, drag.release.end, 0);
    }
}

static void a_motion_of_keys_sets_the_pace(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 6);
    for (int i = 0; i < 200; i++) {
        const dm_drag_feel feel = {0};
        float keys[DM_MOTION_FRAMES];
        dmi_drag drag = held_at(&door, test_range(&random, 0.2f, 1.4f), test_range(&random, -2, 2), &feel);
        dmi_drag_release(&drag, i % 2 ? DM_INTENT_OPEN : DM_INTENT_CLOSE, 0);
        const float outer = i % 2 ? 1.6f : drag.value;
        for (int k = 0; k < DM_MOTION_FRAMES; k++) {
            const float s = (float)k / (DM_MOTION_FRAMES - 1);
            keys[k] = 0.9f * outer * s * s * (3 - 2 * s); /* stops a little short, as networks do */
        }
        assert_true(dmi_release_set_pace(&drag.release, keys));
        assert_near(run_out(&drag, 1e-3f), i % 2 ? 1.6f : 0.0f, 0);
    }
    const dm_drag_feel feel = {0};
    const float nowhere[DM_MOTION_FRAMES] = {0}, wrong[DM_MOTION_FRAMES] = {[15] = -1};
    dmi_drag drag = held_at(&door, 0.5f, 0, &feel);
    dmi_drag_release(&drag, DM_INTENT_OPEN, 0);
    assert_false(dmi_release_set_pace(&drag.release, nowhere));
    assert_false(dmi_release_set_pace(&drag.release, wrong));
}

static void the_rate_does_not_matter(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 6);
    for (int i = 0; i < 100; i++) {
        const dm_drag_feel feel = {0};
        const float value = test_range(&random, 0, 1.6f), velocity = test_range(&random, -4, 4);
        dmi_drag slow = held_at(&door, value, velocity, &feel), fast = slow;
        dm_drag_state a, b;
        dmi_drag_release(&slow, DM_INTENT_AUTO, 0);
        dmi_drag_release(&fast, DM_INTENT_AUTO, 0);
        for (int k = 0; k < 12; k++) {
            dmi_drag_update(&slow, NULL, FRAME, &a);
            for (int n = 0; n < 2; n++) dmi_drag_update(&fast, NULL, FRAME / 2, &b);
            assert_near(a.value, b.value, 1e-4);
        }
    }
}

static void veto_stop_and_replay(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    dm_drag_state now;
    dmi_drag drag = held_at(&door, 0.5f, 4, &feel);
    dmi_drag_release(&drag, DM_INTENT_FREEZE, 0);
    assert_int_equal(drag.release.phase, DM_DRAG_AT_REST);
    assert_near(drag.value, 0.5f, 0);
    drag = held_at(&door, 0.5f, 4, &feel);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 2);
    assert_near(drag.release.duration, 2, 0);
    float way[30];
    for (int k = 0; k < 30; k++) dmi_drag_update(&drag, NULL, FRAME, &now), way[k] = now.value;
    dmi_drag_release(&drag, DM_INTENT_REPLAY, 0);
    for (int k = 0; k < 30; k++) {
        dmi_drag_update(&drag, NULL, FRAME, &now);
        assert_near(now.value, way[k], 0);
    }
    dmi_drag_release(&drag, DM_INTENT_FREEZE, 0); /* stopped on the way */
    const float there = now.value;
    dmi_drag_update(&drag, NULL, FRAME, &now);
    assert_near(now.value, there, 0);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
    assert_near(run_out(&drag, FRAME), 0, 0);
}

static void buttons_spring_back_and_catches_draw(void** state) {
    (void)state;
    const dm_joint button = {.type = DM_JOINT_PRISMATIC, .axis = {0, -1, 0}, .lower = 0, .upper = 0.01f};
    const dm_drag_feel spring = {.return_time = 0.12f}, catches = {.detent = 0.4f};
    dmi_drag drag = held_at(&button, 0.01f, 0, &spring);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_int_equal(drag.release.intent, DM_INTENT_CLOSE);
    assert_near(drag.release.duration, 0.12f, 0);
    assert_near(run_out(&drag, FRAME), 0, 0);
    drag = held_at(&door, 0.55f, 0, &catches);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_near(run_out(&drag, FRAME), 0.4f, 1e-6);
}

/* A wheel glides to a stop, wherever that is; one that is let go still stands. */
static void wheels_coast(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}};
    const dm_drag_feel plain = {0}, dry = {.coast_time = -1};
    dmi_drag drag = held_at(&wheel, 7, 10, &plain);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_near(run_out(&drag, FRAME), 7 + 10 * 0.1f / 0.6931f, 0.02);
    drag = held_at(&wheel, 7, 10, &dry);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_near(run_out(&drag, FRAME), 7, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hand_says_what_is_meant),
        cmocka_unit_test(fast_parts_arrive_sooner),
        cmocka_unit_test(no_release_jumps),
        cmocka_unit_test(a_motion_of_keys_sets_the_pace),
        cmocka_unit_test(the_rate_does_not_matter),
        cmocka_unit_test(veto_stop_and_replay),
        cmocka_unit_test(buttons_spring_back_and_catches_draw),
        cmocka_unit_test(wheels_coast),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
