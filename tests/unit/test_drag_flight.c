/* Falls and bounces: exact at any frame rate, as the formulas of a bouncing ball say. */
#include "test_rules.h"

static const dmi_flight falling = {.lower = 0, .upper = 1, .acceleration = -8, .restitution = 0.5f};

/* From 1 at rest, with 8 down: lands after 0.5 s at speed 4, comes back with 2, up to 0.25 after 0.25 s more. */
static void a_fall_is_a_parabola(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        float value = 1, velocity = 0, time = 0;
        while (time < 0.25f - 1e-6f) {
            const float dt = fminf(test_frame(rate, 0), 0.25f - time);
            dmi_flight_advance(&falling, dt, &value, &velocity);
            time += dt;
        }
        assert_near(value, 0.75, 1e-5);
        const dmi_landing landing = dmi_flight_advance(&falling, 0.5f, &value, &velocity);
        assert_true(landing.struck == -1 && !landing.settled);
        assert_near(landing.impact, 4, 1e-4);
        assert_near(value, 0.25, 1e-4);
        assert_near(velocity, 0, 1e-3);
    }
}

static void bounces_end(void** state) {
    (void)state;
    float value = 1, velocity = 0;
    dmi_landing landing = {0};
    int steps = 0;
    while (!landing.settled && steps++ < 1000) {
        const float last = fabsf(velocity);
        landing = dmi_flight_advance(&falling, 1.0f / 60, &value, &velocity);
        assert_true(value >= 0 && value <= 1 && fabsf(velocity) < last + 8.0f / 60 + 1e-4f);
    }
    assert_true(steps < 120 && value == 0 && velocity == 0);
    value = 0.5f, velocity = -3;
    landing = dmi_flight_advance(&falling, 100, &value, &velocity); /* all of it in one step */
    assert_true(landing.settled && value == 0);
}

/* Thrown up against the far limit, a fall comes back from there too. */
static void a_fall_strikes_the_far_limit(void** state) {
    (void)state;
    float value = 0.9f, velocity = 5;
    const dmi_landing landing = dmi_flight_advance(&falling, 0.1f, &value, &velocity);
    assert_int_equal(landing.struck, 1);
    assert_true(velocity < 0 && value < 1);
}

static void glides_bounce_to_where_they_end(void** state) {
    (void)state;
    const dmi_flight glide = {.lower = 0, .upper = 1, .time_constant = 0.5f, .restitution = 0.6f};
    const float throws[] = {0.5f, 2, -3, 8, -20};
    for (int i = 0; i < 5; i++) {
        const float end = dmi_flight_end(&glide, 0.5f, throws[i]);
        for (int rate = 0; rate < TEST_RATES; rate++) {
            float value = 0.5f, velocity = throws[i], time = 0;
            while (time < 8) {
                const float dt = test_frame(rate, time);
                dmi_flight_advance(&glide, dt, &value, &velocity);
                assert_true(value >= 0 && value <= 1);
                time += dt;
            }
            assert_near(value, end, 3e-3);
        }
    }
}

static test_story release(float value, float velocity, const dm_drag_rules* rules, const dm_drag_feel* feel, int rate) {
    dmi_drag drag;
    dm_drag_state now = {0};
    test_story story = {0};
    test_begin(&drag, &test_slide, value, feel, rules);
    drag.velocity = velocity;
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    for (float time = 0; time < 6;) {
        const float dt = test_frame(rate, time);
        time += dt;
        dmi_drag_update(&drag, NULL, dt, &now);
        assert_true(now.value >= 0 && now.value <= 1);
        test_note(&story, &now, time);
    }
    assert_int_equal(now.phase, DM_DRAG_AT_REST);
    return story;
}

static uint32_t count_of(const test_story* story, uint32_t event) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < story->count; i++) count += story->order[i] == event;
    return count;
}

static void a_hatch_falls_shut_or_open(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {
        .struct_size = sizeof rules, .tip_share = 0.6f, .fall_time = 0.5f, .restitution = 0.4f};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const test_story shut = release(0.55f, 0, &rules, &feel, rate), open = release(0.65f, 0, &rules, &feel, rate);
        assert_true(shut.value == 0 && open.value == 1);
        assert_near(shut.impact, sqrtf(2 * 8 * 0.55f), 0.02);    /* from 0.55 with 2 / 0.5^2 */
        assert_true(count_of(&shut, DM_EVENT_LIMIT_LOWER) == 2); /* 0.55, then 0.088, then 0.014 of the range high */
        assert_int_equal(count_of(&shut, DM_EVENT_CLOSED), 1);
    }
}

static void a_thrown_part_bounces(void** state) {
    (void)state;
    const dm_drag_feel feel = {.coast_time = 0.5f};
    dm_drag_rules rules = {.struct_size = sizeof rules, .restitution = 0.5f};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const test_story story = release(0.5f, 2, &rules, &feel, rate);
        /* It would glide 1.44 far: 0.94 beyond the limit, of which half comes back. */
        assert_near(story.value, 1 - 0.47, 0.01);
        assert_int_equal(count_of(&story, DM_EVENT_LIMIT_UPPER), 1);
    }
}

/* Once more what it did, from where it began. */
static void a_fall_is_replayed(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .tip_share = 0.6f, .restitution = 0.3f};
    dmi_drag drag;
    dm_drag_state first = {0}, again = {0};
    test_begin(&drag, &test_slide, 0.5f, &feel, &rules);
    for (int round = 0; round < 2; round++) {
        dmi_drag_release(&drag, round ? DM_INTENT_REPLAY : DM_INTENT_AUTO, 0);
        for (int k = 0; k < 20; k++) dmi_drag_update(&drag, NULL, 1.0f / 60, round ? &again : &first);
        for (int k = 0; k < 200 && round == 0; k++) dmi_drag_update(&drag, NULL, 1.0f / 60, &again);
    }
    assert_true(first.value > 0.01f && first.value < 0.49f);
    assert_near(again.value, first.value, 1e-6);
}

/* A heavy part in the hand comes back from a limit that it swings against. */
static void a_heavy_part_in_the_hand_bounces(void** state) {
    (void)state;
    const dm_drag_feel feel = {.coast_time = 0.6f, .smoothing_time = 0.1f};
    float lowest[2] = {1, 1};
    for (int i = 0; i < 2; i++) {
        const dm_drag_rules rules = {.struct_size = sizeof rules, .restitution = 0.6f * (float)i};
        dmi_drag drag;
        dm_drag_state now = {0};
        bool met = false;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        for (int k = 0; k < 240; k++) {
            const dm_ray ray = test_ray_at(fminf(0.05f * (float)k, 1));
            dmi_drag_update(&drag, &ray, 1.0f / 60, &now);
            met = met || now.events & DM_EVENT_LIMIT_UPPER;
            if (met) lowest[i] = fminf(lowest[i], now.value);
        }
        assert_true(met);
    }
    assert_true(lowest[0] > 0.999f && lowest[1] < 0.95f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fall_is_a_parabola),
        cmocka_unit_test(bounces_end),
        cmocka_unit_test(a_fall_strikes_the_far_limit),
        cmocka_unit_test(glides_bounce_to_where_they_end),
        cmocka_unit_test(a_hatch_falls_shut_or_open),
        cmocka_unit_test(a_thrown_part_bounces),
        cmocka_unit_test(a_heavy_part_in_the_hand_bounces),
        cmocka_unit_test(a_fall_is_replayed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
