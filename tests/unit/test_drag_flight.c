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

/* ---- against small steps ---- */

/* The same motion in steps of 2e-5 s: thrown back wherever it is past a limit. */
static void simulate(const dmi_flight* flight, double time, double* value, double* velocity, double* hardest) {
    const double h = 2e-5;
    for (double t = 0; t < time - 0.5 * h; t += h) {
        const double before = *velocity;
        *velocity += flight->acceleration != 0 ? (double)flight->acceleration * h
                                               : -before * (1 - exp(-h / (double)flight->time_constant));
        *value += 0.5 * (before + *velocity) * h;
        const bool above = *value > (double)flight->upper, below = *value < (double)flight->lower;
        if (!(above && *velocity > 0) && !(below && *velocity < 0)) continue;
        *hardest = fmax(*hardest, fabs(*velocity));
        *velocity *= -(double)flight->restitution;
        *value = above ? (double)flight->upper : (double)flight->lower;
    }
}

static void steps_are_exact(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 9);
    int struck = 0;
    for (int i = 0; i < 300; i++) {
        const bool falls = i % 3 != 0;
        const float lower = test_range(&random, -1, 0.2f), pull = test_range(&random, 3, 15);
        const dmi_flight flight = {.lower = lower,
                                   .upper = lower + test_range(&random, 0.3f, 1.5f),
                                   .acceleration = falls ? (i % 2 ? pull : -pull) : 0,
                                   .time_constant = test_range(&random, 0.05f, 0.6f),
                                   .restitution = test_range(&random, 0.3f, 0.8f)};
        float value = test_range(&random, flight.lower, flight.upper), velocity = test_range(&random, -4, 4);
        const float time = 2e-5f * roundf(test_range(&random, 0.02f, 0.3f) / 2e-5f);
        double wanted = (double)value, speed = (double)velocity, hardest = 0;
        simulate(&flight, (double)time, &wanted, &speed, &hardest);
        const dmi_landing landing = dmi_flight_advance(&flight, time, &value, &velocity);
        assert_near(value, wanted, 2e-3);
        assert_near(landing.impact, hardest, 5e-3);
        assert_int_equal(landing.struck != 0, hardest > 0);
        struck += landing.struck != 0;
        assert_false(landing.settled);
        if (fabs((double)velocity - speed) > 2e-3 * (1 + fabs(speed))) /* struck just now: either */
            assert_true(fminf(value - flight.lower, flight.upper - value) < 1e-3f);
    }
    assert_true(struck > 60);
}

/* A glide that a limit throws back goes back by that share of what it had left, again and again. */
static void a_glide_ends_where_its_way_is_used_up(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 9);
    for (int i = 0; i < 300; i++) {
        const dmi_flight glide = {.lower = -0.3f,
                                  .upper = test_range(&random, 0.2f, 1.5f),
                                  .time_constant = test_range(&random, 0.1f, 1),
                                  .restitution = i % 10 == 0 ? 0 : test_range(&random, 0.1f, 0.7f)};
        const float value = test_range(&random, glide.lower, glide.upper), velocity = test_range(&random, -12, 12);
        double at = (double)value, left = (double)(velocity * glide.time_constant);
        for (int k = 0; k < 16 && (at + left > (double)glide.upper || at + left < (double)glide.lower); k++) {
            const double limit = left > 0 ? (double)glide.upper : (double)glide.lower;
            left = -(double)glide.restitution * (at + left - limit), at = limit;
        }
        assert_near(dmi_flight_end(&glide, value, velocity), at + left, 1e-4);
    }
    const dmi_flight glide = {.upper = 1, .time_constant = 0.5f, .restitution = 0.5f};
    assert_near(dmi_flight_end(&glide, 0.5f, 1), 1, 0); /* just to a limit */
    assert_near(dmi_flight_end(&glide, 0.5f, -1), 0, 0);
}

/* A bounce that rises by less than 1/500 of the range, and a glide with less than that to go, are none; with just that
 * they are. */
static void small_bounces_and_slow_glides_end(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float s = (float)side, least = 0.002f;
        const dmi_flight fall = {.lower = 0, .upper = 2, .acceleration = 8 * s, .restitution = 0.5f},
                         glide = {.lower = 0, .upper = 1, .time_constant = 0.5f, .restitution = 0.5f};
        for (int high = 0; high < 2; high++) {
            const float rise = (high ? 1.02f : 0.98f) * least * 2, end = s > 0 ? 2 : 0;
            float value = end, velocity = 2 * s * sqrtf(2 * 8 * rise);
            const dmi_landing landing = dmi_flight_advance(&fall, 0, &value, &velocity);
            assert_int_equal(landing.struck, side);
            assert_int_equal(landing.settled, !high);
            assert_near(velocity, high ? -s * sqrtf(2 * 8 * rise) : 0, 1e-5);
            assert_near(value, end, 0);
        }
        for (int far = -1; far < 2; far++) { /* 0.004 a second goes 0.002 far */
            float value = 0.5f, velocity = s * (0.004f + 1e-5f * (float)far);
            assert_int_equal(dmi_flight_advance(&glide, 0, &value, &velocity).settled, far < 0);
        }
        const dmi_flight away = {.lower = 0, .upper = 2, .acceleration = -8 * s, .restitution = 0.01f};
        float value = s > 0 ? 2 : 0, velocity = 0.1f * s; /* what strikes the limit that it falls from goes on */
        const dmi_landing landing = dmi_flight_advance(&away, 0.01f, &value, &velocity);
        assert_true(landing.struck == side && !landing.settled && velocity * s < 0);
    }
}

/* Neither begins at the limit with a strike nor ends before it. */
static void a_part_leaves_the_limit_that_it_stands_at(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float s = (float)side, end = s > 0 ? 1 : 0;
        const dmi_flight fall = {.lower = 0, .upper = 1, .acceleration = -2 * s, .restitution = 0.5f};
        float value = end, velocity = 0;
        dmi_landing landing = dmi_flight_advance(&fall, 0.5f, &value, &velocity);
        assert_true(landing.struck == 0 && landing.impact == 0 && !landing.settled);
        assert_near(value, end - s * 0.25f, 1e-6);
        assert_near(velocity, -s, 1e-6);
        value = 0.5f, velocity = s; /* up against the pull: just not to the limit, 1 / (2 2) = 1/4 far */
        landing = dmi_flight_advance(&fall, 0.5f, &value, &velocity);
        assert_true(landing.struck == 0);
        assert_near(value, 0.5f + s * 0.25f, 1e-6);
        assert_near(velocity, 0, 1e-6);
        landing = dmi_flight_advance(&fall, sqrtf(0.75f) + 1e-4f, &value, &velocity);
        assert_int_equal(landing.struck, -side);
        assert_near(landing.impact, 2 * sqrtf(0.75f), 1e-5);
    }
}

/* A release that a limit throws back goes evenly: at the limit when the formula says so, and no jump to its end. */
static void a_thrown_part_comes_back_as_it_went(void** state) {
    (void)state;
    const dm_drag_feel feel = {.coast_time = 0.5f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .restitution = 0.5f};
    const double constant = 0.5 / log(2), reach = 2 * constant; /* 1.44 */
    const double there = -constant * log(1 - 0.5 / reach), back = 0.5 * (reach - 0.5);
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0.5f, &feel, &rules);
    drag.velocity = 2;
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_true(drag.release.intent == DM_INTENT_STAY && drag.release.phase == DM_DRAG_RELEASED);
    for (int k = 1; k < 200; k++) {
        dmi_drag_update(&drag, NULL, 0.01f, &now);
        const double time = 0.01 * k, left = exp(-(time - there) / constant);
        const double wanted = time < there ? 0.5 + reach * (1 - exp(-time / constant)) : 1 - back * (1 - left);
        assert_near(now.value, wanted, 3e-3);
    }
}

/* Over the whole range in the time that the rules state; from rest, as s = a t^2 / 2 says. */
static void a_fall_takes_the_time_that_is_stated(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_joint both = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 2};
    const struct {
        const dm_joint* joint;
        float value, tip, fall, end;
    } cases[] = {{&test_slide, 0.6f, 0.5f, 0, 1}, {&test_slide, 0.4f, 0.5f, 0.4f, 0}, {&test_slide, 0.5f, 0.5f, 1, 1},
                 {&both, 0.5f, 0.3f, 0.8f, 0},    {&both, -0.5f, 0.3f, 0.8f, 0},      {&both, 1, 0.3f, 0.8f, 2},
                 {&both, -0.91f, 0.3f, 0.8f, -1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_rules rules = {
            .struct_size = sizeof rules, .tip_share = cases[i].tip, .fall_time = cases[i].fall, .restitution = 0.3f};
        dmi_drag drag;
        dm_drag_state now = {0};
        test_begin(&drag, cases[i].joint, cases[i].value, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        const double range = (double)(cases[i].joint->upper - cases[i].joint->lower);
        const double fall = cases[i].fall > 0 ? (double)cases[i].fall : 0.7,
                     way = (double)(cases[i].end - cases[i].value);
        const double pull = copysign(2 * range / (fall * fall), way), time = sqrt(2 * way / pull);
        assert_near(drag.release.end, cases[i].end, 0);
        assert_near(drag.release.duration, time, 1e-5);
        for (int k = 1; k < 10; k++) {
            dmi_drag_update(&drag, NULL, 0.1f * (float)time, &now);
            assert_near(now.value, (double)cases[i].value + 0.5 * pull * 0.01 * k * k * time * time, 1e-5);
            assert_near(now.velocity, pull * 0.1 * k * time, 1e-4 * fabs(pull));
        }
        dmi_drag_update(&drag, NULL, 0.11f * (float)time, &now);
        const bool at_limit = cases[i].end == cases[i].joint->lower || cases[i].end == cases[i].joint->upper;
        assert_near(now.value, cases[i].end, at_limit ? 0.1 : 0);
        assert_int_equal((now.events & (DM_EVENT_LIMIT_LOWER | DM_EVENT_LIMIT_UPPER)) != 0, at_limit);
        if (at_limit) assert_near(now.impact, fabs(pull) * time, 1e-3 * fabs(pull));
    }
}

/* In the hand, a heavy part that meets a limit faster than 1/50 of the range a second comes back by its restitution. */
static void what_comes_back_from_a_hand_is_a_share_of_its_speed(void** state) {
    (void)state;
    const dm_drag_feel feel = {.coast_time = 0.5f, .smoothing_time = 0.1f};
    for (int side = -1; side <= 1; side += 2) {
        for (int fast = 0; fast < 2; fast++) {
            const dm_drag_rules rules = {.struct_size = sizeof rules, .restitution = 0.5f};
            const float end = side > 0 ? 1 : 0, speed = (float)side * (fast ? 0.041f : 0.039f);
            dmi_drag drag;
            dm_drag_state now = {0};
            test_begin(&drag, &test_slide, end, &feel, &rules);
            drag.velocity = speed;
            dmi_drag_update(&drag, NULL, 1e-3f, &now);
            assert_near(now.value, end, 0);
            assert_near(now.velocity, fast ? -0.5f * speed : 0, 1e-6);
        }
    }
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
        cmocka_unit_test(steps_are_exact),
        cmocka_unit_test(a_glide_ends_where_its_way_is_used_up),
        cmocka_unit_test(small_bounces_and_slow_glides_end),
        cmocka_unit_test(a_part_leaves_the_limit_that_it_stands_at),
        cmocka_unit_test(a_thrown_part_comes_back_as_it_went),
        cmocka_unit_test(a_fall_takes_the_time_that_is_stated),
        cmocka_unit_test(what_comes_back_from_a_hand_is_a_share_of_its_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
