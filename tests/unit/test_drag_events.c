/* Events of a drag: their order, hysteresis, that no frame rate changes them, a restored drag, and instances apart. */
#include "test_rules.h"

#define TWO_PI 6.2831853f

/* Out to the end in 0.6 s, still for 0.3 s, back to rest, then still: 2 s. */
static float out_and_back(float time) {
    if (time < 0.9f) return fminf(time / 0.6f, 1);
    return fmaxf(1 - (time - 0.9f) / 0.6f, 0);
}

static void a_way_out_and_back_is_told_in_order(void** state) {
    (void)state;
    static const uint32_t wanted[] = {DM_EVENT_LEFT_REST,   DM_EVENT_OPENED,      DM_EVENT_DETENT, DM_EVENT_DETENT,
                                      DM_EVENT_LIMIT_UPPER, DM_EVENT_DETENT,      DM_EVENT_DETENT, DM_EVENT_CLOSED,
                                      DM_EVENT_LIMIT_LOWER, DM_EVENT_REACHED_REST};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const dm_drag_feel feel = {.detent = 0.5f, .detent_pull = 0.3f};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        const test_story story = test_play(&drag, out_and_back, NULL, 2, rate);
        assert_int_equal(story.detents, 4);
        assert_near(story.value, 0, 1e-4);
        if (rate < TEST_RATES - 1) { /* the hitch puts several into one update, in the order of their bits */
            test_assert_events(&story, wanted, sizeof wanted / sizeof *wanted);
            assert_near(story.time[1], 0.1f * 0.6f + 0.03f, 0.05);
        } else {
            assert_true(story.count >= 8);
        }
    }
}

/* 0.3 mm of tremor about each threshold of a metre's way, an hour long in a minute of frames. */
static float tremor(float time) {
    return time < 0.4f ? 0.25f * time : 0.1f + 0.0003f * sinf(TWO_PI * 12 * time);
}

static void a_tremor_makes_no_noise(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES - 1; rate++) {
        const dm_drag_feel feel = {.smoothing_time = -1, .detent = 0.2f, .detent_pull = 0.1f};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        const test_story story = test_play(&drag, tremor, NULL, 10, rate);
        static const uint32_t wanted[] = {DM_EVENT_LEFT_REST, DM_EVENT_OPENED};
        test_assert_events(&story, wanted, 2); /* a tenth is the ridge and the threshold */
    }
}

/* Goes over three detents in a fifth of a second. */
static float dash(float time) {
    return time < 0.45f ? 0 : fminf(5 * (time - 0.45f), 0.75f);
}

static void detents_of_a_long_update_are_counted(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const dm_drag_feel feel = {.detent = 0.25f};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        assert_int_equal(test_play(&drag, dash, NULL, 1.2f, rate).detents, 3);
    }
}

/* Swings about both thresholds ten times a second. */
static float swing(float time) {
    return 0.06f - 0.06f * cosf(TWO_PI * 10 * time);
}

static uint32_t count_of(const test_story* story, uint32_t event) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < story->count; i++) count += story->order[i] == event;
    return count;
}

static void a_rest_between_opened_and_closed_is_kept(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    dmi_drag drag;
    dm_drag_rules rules = {.struct_size = sizeof rules};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    test_story story = test_play(&drag, swing, NULL, 0.55f, 2);
    assert_true(count_of(&story, DM_EVENT_OPENED) >= 5 && count_of(&story, DM_EVENT_CLOSED) >= 4);
    rules.event_time = 0.4f;
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    story = test_play(&drag, swing, NULL, 0.55f, 2);
    float last = -1;
    for (uint32_t i = 0; i < story.count; i++) {
        if (story.order[i] != DM_EVENT_OPENED && story.order[i] != DM_EVENT_CLOSED) continue;
        if (last >= 0) assert_true(story.time[i] - last >= 0.39f);
        last = story.time[i];
    }
    assert_int_equal(count_of(&story, DM_EVENT_OPENED), 1);
}

static float slam(float time) {
    return 3 * time;
}
static float nudge(float time) {
    return 0.5f * time;
}

static void an_impact_says_how_fast(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES - 1; rate++) {
        const dm_drag_feel feel = {0};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        const float hard = test_play(&drag, slam, NULL, 1, rate).impact;
        test_begin(&drag, &test_slide, 0, &feel, &rules);
        const float soft = test_play(&drag, nudge, NULL, 3, rate).impact;
        assert_true(hard > 0.8f && hard < 3.1f && soft > 0.2f && soft < 0.51f);
    }
}

/* To the end in a second, where it stays for half a second, and as far again beyond it; back, and out once more. */
static float beyond_the_end(float time) {
    if (time < 1.5f) return fminf(time, 1);
    if (time < 3) return fminf(1 + (time - 1.5f), 2);
    return time < 4.5f ? fmaxf(2 - (time - 3), 0.5f) : fminf(0.5f + (time - 4.5f), 2);
}
static float beyond_the_lower_end(float time) {
    return -beyond_the_end(time);
}

/* An estimated limit is met where the estimate is. Once the pull has moved it, it is none, as far out as it may be. */
static void a_limit_that_the_pull_moves_is_met_once(void** state) {
    (void)state;
    const dm_joint both_ways = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 1};
    for (int side = -1; side <= 1; side += 2) {
        const uint32_t wanted[] = {DM_EVENT_LEFT_REST, DM_EVENT_OPENED,
                                   side > 0 ? DM_EVENT_LIMIT_UPPER : DM_EVENT_LIMIT_LOWER};
        const dm_drag_feel feel = {.smoothing_time = -1};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        const dmi_rules kept = dmi_rules_from(&rules, &feel, &both_ways, false, 1);
        const float grab[3] = {0, 0, 0};
        dmi_drag drag;
        dmi_drag_begin(&drag, &both_ways, grab, 0, &feel);
        dmi_drag_track_hypotheses(&drag, &both_ways, NULL, 0, 1, (dmi_limit_give){.share = 1, .length = 1});
        dmi_drag_set_rules(&drag, &kept);
        const test_story story = test_play(&drag, side > 0 ? beyond_the_end : beyond_the_lower_end, NULL, 6.5f, 1);
        assert_near(story.value, 2 * side, 1e-4);
        test_assert_events(&story, wanted, 3);
    }
}

/* A part that the release moves tells the same. */
static void a_released_part_tells_where_it_goes(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const dm_drag_feel feel = {0};
        const dm_drag_rules rules = {.struct_size = sizeof rules};
        dmi_drag drag;
        dm_drag_state now = {0};
        test_story story = {0};
        test_begin(&drag, &test_slide, 0.5f, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
        for (float time = 0; time < 2;) {
            const float dt = test_frame(rate, time);
            time += dt;
            dmi_drag_update(&drag, NULL, dt, &now);
            test_note(&story, &now, time);
        }
        static const uint32_t wanted[] = {DM_EVENT_CLOSED, DM_EVENT_LIMIT_LOWER, DM_EVENT_REACHED_REST};
        assert_int_equal(now.phase, DM_DRAG_AT_REST);
        assert_int_equal(story.count, 3);
        if (rate < TEST_RATES - 1) test_assert_events(&story, wanted, 3);
    }
}

/* The same bits after a copy is put back in the middle, while another instance goes its own way. */
static void a_copy_goes_on_as_the_first_did(void** state) {
    (void)state;
    enum { FRAMES = 120, SAVED_AT = 40 };
    const dm_drag_feel feel = {.detent = 0.125f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .event_time = 0.2f, .max_speed = 2};
    dmi_drag drag, saved, other;
    dm_drag_state first[FRAMES] = {{0}}, again = {0}, elsewhere = {0};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    test_begin(&other, &test_slide, 0.5f, &feel, &rules);
    for (int k = 0; k < FRAMES; k++) {
        if (k == SAVED_AT) saved = drag;
        const dm_ray ray = test_ray_at(out_and_back((float)k / 60));
        dmi_drag_update(&drag, &ray, 1.0f / 60, &first[k]);
    }
    uint32_t events = 0;
    for (int k = SAVED_AT; k < FRAMES; k++) {
        const dm_ray ray = test_ray_at(out_and_back((float)k / 60)), far = test_ray_at(swing((float)k / 60));
        dmi_drag_update(&other, &far, 1.0f / 60, &elsewhere);
        dmi_drag_update(&saved, &ray, 1.0f / 60, &again);
        assert_memory_equal(&again, &first[k], sizeof again);
        events |= again.events;
    }
    assert_true(events & DM_EVENT_LIMIT_UPPER && events & DM_EVENT_CLOSED);
}

/* ---- one update, at both sides of each threshold ---- */

static const dm_joint shifted = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 3};

static dmi_rules rules_with(float event_time) {
    const dm_drag_feel feel = {0};
    const dm_drag_rules given = {.struct_size = sizeof given, .event_time = event_time};
    return dmi_rules_from(&given, &feel, &shifted, false, 1);
}

/* Events of an update that takes a part from one value to another. */
static uint32_t events_of(float from, float to) {
    const dm_drag_feel feel = {0};
    const dmi_rules rules = rules_with(0);
    dmi_event_input now = {.joint = &shifted, .feel = &feel, .rules = &rules, .value = from};
    dmi_event_state told = dmi_event_state_begin(&now);
    now.value = to;
    dmi_event_state_update(&told, &now, 0.01f);
    return told.events;
}

/* At a limit within 1/200 of the range, off it beyond 1/50; the same at rest; open beyond 1/10, shut within 1/50. */
static void events_have_sharp_edges(void** state) {
    (void)state;
    const uint32_t low = DM_EVENT_LIMIT_LOWER, high = DM_EVENT_LIMIT_UPPER, left = DM_EVENT_LEFT_REST,
                   back = DM_EVENT_REACHED_REST, opened = DM_EVENT_OPENED, closed = DM_EVENT_CLOSED;
    const struct {
        float from, to;
        uint32_t events;
    } cases[] = {{2, 2.979f, 0},
                 {2, 2.981f, high},
                 {2.981f, 3, 0},
                 {-0.5f, -0.979f, 0},
                 {-0.5f, -0.981f, low},
                 {0, 0.079f, 0},
                 {0, 0.081f, left},
                 {0, -0.081f, left},
                 {0.3f, 0.021f, closed},
                 {0.3f, 0.019f, closed | back},
                 {0.3f, -0.019f, closed | back},
                 {0, 0.399f, left},
                 {0, 0.401f, left | opened},
                 {0, -0.401f, left | opened},
                 {0.401f, 0.081f, 0},
                 {0.401f, 0.079f, closed},
                 {-0.401f, -0.079f, closed},
                 {0.021f, 0.019f, back},
                 {0.019f, 0.05f, 0},
                 {0.021f, 0.079f, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_int_equal(events_of(cases[i].from, cases[i].to), cases[i].events);
}

/* Once at a limit it is left beyond 1/50, then told again. */
static void a_limit_is_left_farther_off(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dmi_rules rules = rules_with(0);
    for (int side = -1; side <= 1; side += 2) {
        const float end = side > 0 ? 3 : -1, inwards = -(float)side;
        const uint32_t event = side > 0 ? DM_EVENT_LIMIT_UPPER : DM_EVENT_LIMIT_LOWER;
        const struct {
            float off;
            bool at, told;
        } steps[] = {{0, true, false},       {0.079f, true, false}, {0.01f, true, false}, {0.081f, false, false},
                     {0.021f, false, false}, {0.019f, true, true},  {0.079f, true, false}};
        dmi_event_input now = {.joint = &shifted, .feel = &feel, .rules = &rules, .value = end};
        dmi_event_state told = dmi_event_state_begin(&now);
        assert_int_equal(told.limit, side);
        for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
            now.value = end + inwards * steps[i].off;
            dmi_event_state_update(&told, &now, 0.01f);
            assert_int_equal(told.limit, steps[i].at ? side : 0);
            assert_int_equal((told.events & event) != 0, steps[i].told);
        }
        now.beyond_lower = now.beyond_upper = true, now.value = end; /* an estimate that has given is none */
        dmi_event_state_update(&told, &now, 0.01f);
        assert_int_equal(told.limit, 0);
    }
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS};
    const dmi_event_input free = {.joint = &wheel, .feel = &feel, .rules = &rules};
    assert_int_equal(dmi_event_state_begin(&free).limit, 0);
}

/* Opened and closed are told event_time apart at least; the first at once. */
static void opened_and_closed_keep_their_time(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dmi_rules rules = rules_with(0.5f);
    dmi_event_input now = {.joint = &shifted, .feel = &feel, .rules = &rules};
    dmi_event_state told = dmi_event_state_begin(&now);
    now.value = 1;
    dmi_event_state_update(&told, &now, 0.125f);
    assert_true(told.events & DM_EVENT_OPENED && told.open);
    now.value = 0;
    for (int i = 1; i <= 4; i++) {
        dmi_event_state_update(&told, &now, 0.125f);
        assert_int_equal((told.events & DM_EVENT_CLOSED) != 0, i == 4);
        assert_int_equal(told.open, i < 4);
    }
}

/* The speed lately: the highest, halved each tenth of a second. A strike is as hard as it was. */
static void an_impact_is_the_speed_of_late(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dmi_rules rules = rules_with(0);
    for (int side = -1; side <= 1; side += 2) {
        const float end = side > 0 ? 3 : -1, s = (float)side;
        dmi_event_input now = {.joint = &shifted, .feel = &feel, .rules = &rules, .value = 1, .velocity = 4 * s};
        dmi_event_state told = dmi_event_state_begin(&now);
        dmi_event_state_update(&told, &now, 0.1f);
        assert_true(told.impact == 0);
        now.velocity = 0.5f * s;
        dmi_event_state_update(&told, &now, 0.1f);
        now.value = end, now.velocity = s;
        dmi_event_state_update(&told, &now, 0.05f);
        assert_near(told.impact, 4 * exp2(-1.5), 1e-5);
        dmi_event_state_update(&told, &now, 0.1f);
        assert_true(told.impact == 0 && told.events == 0);
        now.value = end - 0.5f * s, now.struck = side,
        now.impact = 5; /* thrown back within the update, told once more */
        dmi_event_state_update(&told, &now, 0.1f);
        assert_near(told.limit, 0, 0);
        told = dmi_event_state_begin(&now);
        dmi_event_state_update(&told, &now, 0.1f);
        assert_int_equal(told.events & (DM_EVENT_LIMIT_LOWER | DM_EVENT_LIMIT_UPPER),
                         side > 0 ? DM_EVENT_LIMIT_UPPER : DM_EVENT_LIMIT_LOWER);
        assert_near(told.impact, 5, 0);
        now = (dmi_event_input){.joint = &shifted, .feel = &feel, .rules = &rules, .value = 1, .velocity = 2 * s};
        told = dmi_event_state_begin(&now);
        now.blocked = true;
        dmi_event_state_update(&told, &now, 0.1f);
        assert_true(told.events & DM_EVENT_BLOCKED);
        assert_near(told.impact, 2, 0);
        dmi_event_state_update(&told, &now, 0.1f);
        assert_true(told.events == 0 && told.impact == 0);
        now.blocked = false;
        dmi_event_state_update(&told, &now, 0.1f);
        assert_true(told.events == DM_EVENT_FREED && told.impact == 0);
    }
}

/* Past 0.55 of the way to the next detent it is that one's; as many are told as are gone over to. */
static void a_detent_is_told_past_its_ridge(void** state) {
    (void)state;
    const dm_drag_feel feel = {.detent = 0.2f};
    const dmi_rules rules = rules_with(0);
    for (int side = -1; side <= 1; side += 2) {
        const struct {
            float place;
            uint32_t detents;
        } steps[] = {{0.54f, 0}, {0.56f, 1}, {0.46f, 0}, {0.44f, 1}, {3.4f, 3}, {3.54f, 0}, {-1.2f, 4}, {-1.2f, 0}};
        const float s = 0.2f * (float)side;
        const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS};
        dmi_event_input now = {.joint = &wheel, .feel = &feel, .rules = &rules};
        dmi_event_state told = dmi_event_state_begin(&now);
        for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
            now.value = s * steps[i].place;
            dmi_event_state_update(&told, &now, 0.01f);
            assert_int_equal(told.detents, steps[i].detents);
            assert_int_equal((told.events & DM_EVENT_DETENT) != 0, steps[i].detents > 0);
        }
        now.value = s * 7, now.changes = 1; /* of another joint: none was crossed */
        dmi_event_state_update(&told, &now, 0.01f);
        assert_true(told.detents == 0 && told.events & DM_EVENT_JOINT);
        dmi_event_state_update(&told, &now, 0.01f);
        assert_false(told.events & DM_EVENT_JOINT);
    }
}

/* Snap values alone are told: what is beyond the outermost is none. */
static void snaps_are_told_one_by_one(void** state) {
    (void)state;
    const float snaps[3] = {0.5f, 1, 2};
    const dm_drag_feel feel = {0};
    const dm_drag_rules given = {.struct_size = sizeof given, .snaps = snaps, .snap_count = 3};
    const dmi_rules rules = dmi_rules_from(&given, &feel, &shifted, false, 1);
    const struct {
        float value;
        uint32_t detents;
    } steps[] = {{0.5f, 1}, {1, 1}, {2, 1}, {2.9f, 0}, {2, 1}, {0.5f, 2}, {-0.9f, 0}, {2.9f, 3}, {-0.9f, 3}, {1, 2}};
    dmi_event_input now = {.joint = &shifted, .feel = &feel, .rules = &rules, .value = -0.9f};
    dmi_event_state told = dmi_event_state_begin(&now);
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        now.value = steps[i].value;
        dmi_event_state_update(&told, &now, 0.01f);
        assert_int_equal(told.detents, steps[i].detents);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_way_out_and_back_is_told_in_order),
        cmocka_unit_test(a_tremor_makes_no_noise),
        cmocka_unit_test(detents_of_a_long_update_are_counted),
        cmocka_unit_test(a_rest_between_opened_and_closed_is_kept),
        cmocka_unit_test(an_impact_says_how_fast),
        cmocka_unit_test(a_limit_that_the_pull_moves_is_met_once),
        cmocka_unit_test(a_released_part_tells_where_it_goes),
        cmocka_unit_test(a_copy_goes_on_as_the_first_did),
        cmocka_unit_test(events_have_sharp_edges),
        cmocka_unit_test(a_limit_is_left_farther_off),
        cmocka_unit_test(opened_and_closed_keep_their_time),
        cmocka_unit_test(an_impact_is_the_speed_of_late),
        cmocka_unit_test(a_detent_is_told_past_its_ridge),
        cmocka_unit_test(snaps_are_told_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
