/* Highest speed and acceleration, and bounds of an update: the same at any frame rate, soft, never through. */
#include "test_rules.h"

static float away(float time) {
    return 10 * time;
}

static test_story play(const dm_drag_rules* rules, test_way way, test_room room, float seconds, int rate) {
    const dm_drag_feel feel = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &feel, rules);
    return test_play(&drag, way, room, seconds, rate);
}

static void no_part_is_faster_than_allowed(void** state) {
    (void)state;
    const dm_drag_rules rules = {.struct_size = sizeof rules, .max_speed = 0.5f};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        assert_near(play(&rules, away, NULL, 1, rate).value, 0.5, 0.02);
        assert_near(play(&rules, away, NULL, 1.5f, rate).value, 0.75, 0.02);
    }
}

/* s = a t^2 / 2 while it gets faster; the highest speed then holds. */
static void force_is_limited(void** state) {
    (void)state;
    const dm_drag_rules rules = {.struct_size = sizeof rules, .max_acceleration = 1},
                        both = {.struct_size = sizeof both, .max_acceleration = 1, .max_speed = 0.5f};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        assert_near(play(&rules, away, NULL, 1, rate).value, 0.5, 0.03);
        assert_near(play(&both, away, NULL, 1, rate).value, 0.125 + 0.25, 0.02);
    }
}

static void a_release_keeps_the_highest_speed(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .max_speed = 0.4f};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        dmi_drag drag;
        dm_drag_state now = {.value = 1};
        test_begin(&drag, &test_slide, 1, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
        for (float time = 0, last = 1; time < 6; last = now.value) {
            const float dt = test_frame(rate, time);
            time += dt;
            dmi_drag_update(&drag, NULL, dt, &now);
            assert_true(last - now.value <= 0.4f * dt + 1e-5f);
        }
        assert_true(now.value == 0 && now.phase == DM_DRAG_AT_REST);
    }
}

/* Something stands at 0.6 for the second second. */
static void stand_in_the_way(float time, dm_drag_input* input) {
    if (time < 2) input->lower = -INFINITY, input->upper = 0.6f;
}
static float reach_out(float time) {
    return fminf(2 * time, 0.9f);
}

static void a_blocked_part_stops_and_goes_on(void** state) {
    (void)state;
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    static const uint32_t wanted[] = {DM_EVENT_LEFT_REST, DM_EVENT_OPENED, DM_EVENT_BLOCKED, DM_EVENT_FREED};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const test_story held = play(&rules, reach_out, stand_in_the_way, 1.9f, rate);
        assert_near(held.value, 0.6, 0.001);
        assert_true(held.value <= 0.6f && held.impact > 0.5f && held.impact < 2.5f);
        const test_story freed = play(&rules, reach_out, stand_in_the_way, 4, rate);
        assert_near(freed.value, 0.9, 0.001);
        if (rate < TEST_RATES - 1) test_assert_events(&freed, wanted, 4);
    }
}

/* Neither the stop nor the way on is a jump: no frame of 1/60 s goes farther than the hand at its fastest, 2 a second.
 */
static void a_block_is_soft(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    for (int k = 1; k < 240; k++) {
        const float last = now.value;
        dm_drag_input input = {.struct_size = sizeof input,
                               .hand = test_pointer(test_ray_at(reach_out((float)k / 60)))};
        stand_in_the_way((float)k / 60, &input);
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        assert_true(now.value - last < 2.05f / 60 && now.value >= last);
    }
}

/* A body that comes at a held part pushes it back, softly, and not a released one's plan through it. */
static void come_closer(float time, dm_drag_input* input) {
    input->lower = -INFINITY, input->upper = fmaxf(0.9f - 0.5f * time, 0.3f);
}
static float stay_out(float time) {
    return time < 0.2f ? 4 * time : 0.8f;
}

static void a_body_pushes_a_part(void** state) {
    (void)state;
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    for (int rate = 0; rate < TEST_RATES; rate++)
        assert_near(play(&rules, stay_out, come_closer, 3, rate).value, 0.3, 0.001);
}

static void a_blocked_release_waits(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        test_story story = {0};
        test_begin(&drag, &test_slide, 1, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
        for (float time = 0; time < 6;) {
            const float dt = test_frame(rate, time);
            dm_drag_input input = {.struct_size = sizeof input};
            if (time < 3) input.lower = 0.4f, input.upper = INFINITY;
            time += dt;
            dmi_drag_step(&drag, &input, dt, &now);
            if (time < 3) assert_true(now.value >= 0.4f && now.phase == DM_DRAG_RELEASED);
            if (time > 2 && time < 3) assert_near(now.value, 0.4, 0.002);
            test_note(&story, &now, time);
        }
        static const uint32_t wanted[] = {DM_EVENT_BLOCKED, DM_EVENT_FREED, DM_EVENT_CLOSED, DM_EVENT_LIMIT_LOWER,
                                          DM_EVENT_REACHED_REST};
        assert_true(now.value == 0 && now.phase == DM_DRAG_AT_REST);
        if (rate < TEST_RATES - 1) test_assert_events(&story, wanted, 5);
    }
}

/* Limits that were estimated do not move out behind something that stands in the way. */
static void a_block_leaves_estimated_limits(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    const float grab[3] = {0, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &test_slide, grab, 0, &feel);
    dmi_drag_track_hypotheses(&drag, &test_slide, NULL, 0, 1, (dmi_limit_give){.length = 1});
    const dmi_rules kept = dmi_rules_from(&rules, &feel, &test_slide, false, 1);
    dmi_drag_set_rules(&drag, &kept);
    for (int k = 1; k < 120; k++) {
        dm_drag_input input = {.struct_size = sizeof input, .lower = -1, .upper = 1.1f};
        input.hand = test_pointer(test_ray_at(0.02f * (float)k));
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        assert_true(now.value <= 1.1f && drag.joint.upper <= 1.1f);
    }
    assert_near(now.value, 1.1, 0.001);
}

/* Any bounds and any hand: inside, or on the way in; never farther in than asked. */
static void bounds_hold_whatever_comes(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(7, 0);
    const dm_drag_feel feel = {.coast_time = 0.1f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .max_speed = 3};
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    for (int k = 0; k < 20000; k++) {
        const float last = now.value, a = test_range(&random, -0.5f, 1.5f), b = test_range(&random, -0.5f, 1.5f);
        dm_drag_input input = {.struct_size = sizeof input, .lower = fminf(a, b), .upper = fmaxf(a, b)};
        input.hand = test_pointer(test_ray_at(test_range(&random, -2, 2)));
        dmi_drag_step(&drag, &input, test_range(&random, 0, 0.1f), &now);
        assert_true(now.value >= 0 && now.value <= 1 && isfinite(now.velocity));
        assert_true(now.value <= fmaxf(last, input.upper) && now.value >= fminf(last, input.lower));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_part_is_faster_than_allowed),
        cmocka_unit_test(force_is_limited),
        cmocka_unit_test(a_release_keeps_the_highest_speed),
        cmocka_unit_test(a_blocked_part_stops_and_goes_on),
        cmocka_unit_test(a_block_is_soft),
        cmocka_unit_test(a_body_pushes_a_part),
        cmocka_unit_test(a_blocked_release_waits),
        cmocka_unit_test(a_block_leaves_estimated_limits),
        cmocka_unit_test(bounds_hold_whatever_comes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
