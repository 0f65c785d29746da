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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_way_out_and_back_is_told_in_order),
        cmocka_unit_test(a_tremor_makes_no_noise),
        cmocka_unit_test(detents_of_a_long_update_are_counted),
        cmocka_unit_test(a_rest_between_opened_and_closed_is_kept),
        cmocka_unit_test(an_impact_says_how_fast),
        cmocka_unit_test(a_released_part_tells_where_it_goes),
        cmocka_unit_test(a_copy_goes_on_as_the_first_did),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
