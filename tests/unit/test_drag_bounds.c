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

/* ---- one step against its formulas ---- */

/* The farthest way of a part in small steps: faster by the acceleration up to the highest speed. */
static double farthest(double speed, double gain, double most, double dt, double* end) {
    enum { STEPS = 20000 };
    double way = 0;
    speed = fmin(speed, most);
    for (int i = 0; i < STEPS; i++) {
        const double next = gain > 0 ? fmin(speed + gain * dt / STEPS, most) : most;
        way += 0.5 * (gain > 0 ? speed + next : 2 * most) * dt / STEPS;
        speed = next;
    }
    *end = speed;
    return way;
}

static void a_step_goes_as_far_as_speed_and_force_allow(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 3);
    for (int i = 0; i < 200; i++) {
        const dmi_rules rules = {.on = true,
                                 .max_speed = i % 3 ? test_range(&random, 0.3f, 2) : 0,
                                 .max_acceleration = i % 3 != 1 ? test_range(&random, 1, 9) : 0};
        const dmi_bounds none = {-INFINITY, INFINITY};
        const float dt = test_range(&random, 0.01f, 0.5f), before = test_range(&random, -1, 1);
        const float speed = test_range(&random, -2, 2), side = i % 2 ? -1.0f : 1.0f;
        double end;
        const double most = rules.max_speed > 0 ? (double)rules.max_speed : INFINITY;
        const double way =
            farthest(fmax((double)(side * speed), 0), (double)rules.max_acceleration, most, (double)dt, &end);
        for (int far = 0; far < 2; far++) {
            const float asked = before + side * (float)way * (far ? 1.01f : 0.99f);
            float value = asked, velocity = 77;
            assert_int_equal(dmi_limit_step(&rules, none, before, speed, dt, &value, &velocity), far);
            assert_near(value, far ? (double)before + (double)side * way : (double)asked, 1e-5);
            assert_near(velocity, far ? (double)side * end : 77, 1e-4);
        }
    }
}

/* Within bounds, all but what halves each 20 ms of the way to them; from outside, at least so much of the way back. */
static void bounds_are_come_to_by_halves(void** state) {
    (void)state;
    const dmi_rules rules = {.on = true};
    const dmi_bounds bounds = {-0.5f, 1};
    for (int k = 1; k <= 8; k++) {
        const float dt = 0.01f * (float)k;
        const double share = 1 - exp2(-(double)dt / 0.02);
        const struct {
            float before, asked;
            double value;
        } cases[] = {{0.2f, 3, 0.2 + 0.8 * share},
                     {0.2f, -3, 0.2 - 0.7 * share},
                     {0.2f, 0.2001f, 0.2001},
                     {0.2f, 0.2f, 0.2},
                     {2, 2, 2 - share},
                     {2, 3, 2 - share},
                     {2, -0.4f, -0.4},
                     {-1, -1, -1 + 0.5 * share},
                     {1, 2, 1},
                     {-0.5f, -2, -0.5},
                     {1, 0.9f, 0.9}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            if (i == 6 && -0.4 < 2 - 2.5 * share) continue; /* no farther than the share of the way to the other one */
            float value = cases[i].asked, velocity = 5;
            const bool changed = dmi_limit_step(&rules, bounds, cases[i].before, 0, dt, &value, &velocity);
            assert_near(value, cases[i].value, 1e-6);
            assert_int_equal(changed, fabs((double)cases[i].asked - cases[i].value) > 1e-6);
            assert_near(velocity, changed ? (cases[i].value - (double)cases[i].before) / (double)dt : 5, 1e-3);
        }
        float value = 0.7f, velocity = 5;
        assert_false(dmi_limit_step(&rules, (dmi_bounds){-INFINITY, INFINITY}, 0, 0, dt, &value, &velocity));
        assert_true(dmi_limit_step(&rules, (dmi_bounds){-INFINITY, 0.1f}, 0, 0, dt, &value, &velocity));
        value = -0.7f;
        assert_true(dmi_limit_step(&rules, (dmi_bounds){-0.1f, INFINITY}, 0, 0, dt, &value, &velocity));
    }
    float value = 0.7f, velocity = 5; /* no time: nowhere, and no speed of it */
    assert_true(dmi_limit_step(&rules, bounds, 0.2f, 0, 0, &value, &velocity));
    assert_true(value == 0.2f && velocity == 5);
    assert_near(dmi_bounds_clamp(bounds, 2), 1, 0);
    assert_near(dmi_bounds_clamp(bounds, -2), -0.5, 0);
    assert_near(dmi_bounds_clamp(bounds, 0.3f), 0.3f, 0);
}

/* Held from 1/200 of the range before the bound on, and to 1/50; only by what asks for more. */
static void a_bound_holds_what_asks_for_more(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float s = (float)side;
        const dmi_bounds bounds = {side > 0 ? -INFINITY : -1, side > 0 ? 1 : INFINITY};
        assert_true(dmi_bounds_hold(bounds, 0.981f * s, 1.1f * s, 4, false));
        assert_false(dmi_bounds_hold(bounds, 0.979f * s, 1.1f * s, 4, false));
        assert_true(dmi_bounds_hold(bounds, 0.921f * s, 1.1f * s, 4, true));
        assert_false(dmi_bounds_hold(bounds, 0.919f * s, 1.1f * s, 4, true));
        assert_false(dmi_bounds_hold(bounds, s, s, 4, true));
        assert_false(dmi_bounds_hold(bounds, s, 0.9f * s, 4, true));
        assert_true(dmi_bounds_hold(bounds, 1.2f * s, 1.3f * s, 4, false));
    }
}

/* What a part is behind the hand halves each tenth of a second, unless the hand comes to it. */
static void a_lag_halves(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float s = (float)side;
        assert_near(dmi_catch_up(0.8f * s, 0.2f * s, -0.6f * s, 0.1f), 0.5 * (double)s, 1e-6);
        assert_near(dmi_catch_up(0.8f * s, 0.2f * s, -0.6f * s, 0.2f), 0.65 * (double)s, 1e-6);
        assert_near(dmi_catch_up(0.9f * s, 0.2f * s, -0.6f * s, 0.1f), 0.6 * (double)s, 1e-6); /* the hand's own way */
        assert_near(dmi_catch_up(0.6f * s, 0.2f * s, -0.6f * s, 0.1f), 0.4 * (double)s, 1e-6); /* it came nearer */
        assert_near(dmi_catch_up(0.1f * s, 0.2f * s, -0.6f * s, 0.1f), 0.1f * s, 0);           /* past the part */
        assert_near(dmi_catch_up(0.8f * s, 0.2f * s, 0, 0.1f), 0.8f * s, 0);
        assert_near(dmi_catch_up(0.2f * s, 0.2f * s, -0.6f * s, 0.1f), 0.2f * s, 0);
    }
}

/* A hand as far off as is allowed holds on; a hair more, and it lets go. */
static void a_hand_lets_go_beyond_its_distance(void** state) {
    (void)state;
    for (int far = 0; far < 2; far++) {
        const dm_drag_feel feel = {.smoothing_time = -1};
        const dm_drag_rules rules = {.struct_size = sizeof rules, .break_distance = 0.25f};
        const float at = far ? 1.25001f : 1.25f;
        dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_POINT, .point = {1, 0, 0}}};
        dmi_drag drag;
        dm_drag_state now = {0};
        test_begin(&drag, &test_slide, 1, &feel, &rules);
        dmi_drag_step(&drag, &input, 0.01f, &now);
        input.hand.point.x = at;
        dmi_drag_step(&drag, &input, 0.01f, &now);
        assert_int_equal(now.phase != DM_DRAG_HELD, far);
        assert_int_equal((now.events & DM_EVENT_LET_GO) != 0, far);
        assert_near(now.value, 1, 0);
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
        cmocka_unit_test(a_step_goes_as_far_as_speed_and_force_allow),
        cmocka_unit_test(bounds_are_come_to_by_halves),
        cmocka_unit_test(a_bound_holds_what_asks_for_more),
        cmocka_unit_test(a_lag_halves),
        cmocka_unit_test(a_hand_lets_go_beyond_its_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
