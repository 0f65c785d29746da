/* Lock and latch: what is held gives a little and says so; a handle opens the latch; released parts close into it. */
#include "test_rules.h"

static const uint32_t opening[] = {DM_EVENT_LOCKED, DM_EVENT_UNLATCHED, DM_EVENT_LEFT_REST, DM_EVENT_OPENED};

/* Pulls half-way out in half a second, and holds on. */
static float pull(float time) {
    return fminf(time, 0.5f);
}
static float handle_angle;

/* The handle turns after a second. */
static void turn_handle(float time, dm_drag_input* input) {
    handle_angle = time < 1 ? 0.4f : 0.9f;
    input->handles[1] = -handle_angle;
}
static void lock(float time, dm_drag_input* input) {
    if (time < 1) input->flags = DM_INPUT_LOCKED;
}

static test_story play(uint32_t flags, test_room room, float seconds, int rate) {
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .flags = flags};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    return test_play(&drag, pull, room, seconds, rate);
}

static void a_locked_part_gives_a_little_and_says_so(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const test_story locked = play(DM_RULE_LOCKED, NULL, 1, rate);
        static const uint32_t wanted[] = {DM_EVENT_LOCKED};
        test_assert_events(&locked, wanted, 1);
        assert_true(locked.value > 0.005f && locked.value < 0.01f);
        const test_story freed = play(0, lock, 3, rate);
        assert_near(freed.value, 0.5, 0.001);
        assert_int_equal(freed.order[0], DM_EVENT_LOCKED);
        assert_int_equal(freed.count, 3);
    }
}

static void a_handle_opens_the_latch(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        const test_story held = play(DM_RULE_LATCH, turn_handle, 0.95f, rate);
        assert_true(held.value < 0.01f);
        const test_story opened = play(DM_RULE_LATCH, turn_handle, 3, rate);
        assert_near(opened.value, 0.5, 0.001);
        if (rate == 2) test_assert_events(&opened, opening, 4); /* a longer update holds the last three */
        assert_int_equal(opened.count, 4);
        assert_near(opened.time[1], 1, 0.05);
    }
}

/* No jump when the latch opens under a hand that pulls: half of the way in a tenth of a second. */
static void a_part_that_comes_free_glides_to_the_hand(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .flags = DM_RULE_LATCH};
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    for (int k = 0; k < 180; k++) {
        const float time = (float)k / 60, last = now.value;
        dm_drag_input input = {.struct_size = sizeof input, .hand = test_pointer(test_ray_at(pull(time)))};
        turn_handle(time, &input);
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        assert_true(now.value - last < 0.06f);
        if (k == 66) assert_true(now.value > 0.15f && now.value < 0.35f);
    }
}

/* A handle that is let go before the part has moved catches it again; hysteresis of the handle itself. */
static void a_latch_catches_again(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .flags = DM_RULE_LATCH, .latch_turn = 0.5f};
    const struct {
        float handle, ask;
        uint32_t events;
    } steps[] = {{0.49f, 0, 0}, {0.51f, 0, DM_EVENT_UNLATCHED}, {0.45f, 0, 0}, {0.39f, 0, DM_EVENT_LATCHED},
                 {0.45f, 0, 0}, {0.6f, 0, DM_EVENT_UNLATCHED}};
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        dm_drag_input input = {.struct_size = sizeof input, .hand = test_pointer(test_ray_at(steps[i].ask))};
        input.handles[0] = steps[i].handle;
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        assert_int_equal(now.events, steps[i].events);
    }
}

static test_story run_out(dmi_drag* drag, float seconds, int rate) {
    test_story story = {0};
    dm_drag_state now = {0};
    for (float time = 0; time < seconds;) {
        const float dt = test_frame(rate, time);
        time += dt;
        dmi_drag_update(drag, NULL, dt, &now);
        test_note(&story, &now, time);
    }
    return story;
}

static void a_part_near_rest_closes_into_its_latch(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {
        .struct_size = sizeof rules, .flags = DM_RULE_LATCH, .auto_close_share = 0.2f, .lock_give = -1};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0.18f, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        const test_story closed = run_out(&drag, 1, rate);
        assert_near(closed.value, 0, 1e-6);
        assert_true(drag.latch.closed && drag.release.phase == DM_DRAG_AT_REST);
        test_begin(&drag, &test_slide, 0.4f, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        assert_near(run_out(&drag, 1, rate).value, 0.4, 1e-4);
        test_begin(&drag, &test_slide, 0.3f, &feel, &rules); /* glides into the zone */
        drag.velocity = -0.8f;
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        assert_int_equal(drag.release.intent, DM_INTENT_STAY);
        assert_near(run_out(&drag, 2, rate).value, 0, 1e-6);
        test_begin(&drag, &test_slide, 0.18f, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_STAY, 0); /* the host overrules it */
        assert_near(run_out(&drag, 2, rate).value, 0.18, 1e-4);
    }
}

static void held_parts_do_not_close_by_themselves(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .auto_close_share = 0.2f};
    dmi_drag drag;
    dm_drag_state now = {0};
    test_begin(&drag, &test_slide, 0.15f, &feel, &rules);
    for (int k = 0; k < 120; k++) {
        const dm_ray ray = test_ray_at(0.15f);
        dmi_drag_update(&drag, &ray, 1.0f / 60, &now);
    }
    assert_near(now.value, 0.15, 1e-4);
}

static void a_closer_waits(void** state) {
    (void)state;
    const dm_drag_feel feel = {.return_time = 0.5f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .close_delay = 1};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        dmi_drag drag;
        test_begin(&drag, &test_slide, 0.8f, &feel, &rules);
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        assert_near(run_out(&drag, 0.9f, rate).value, 0.8, 1e-4);
        assert_int_equal(drag.release.phase, DM_DRAG_RELEASED);
        assert_true(run_out(&drag, 1, rate).value == 0);
    }
}

/* A part told to open that is locked waits, and opens once it is not. */
static void a_locked_release_waits(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules};
    dmi_drag drag;
    dm_drag_state now = {0};
    uint32_t events = 0;
    test_begin(&drag, &test_slide, 0, &feel, &rules);
    dmi_drag_release(&drag, DM_INTENT_OPEN, 0);
    for (int k = 0; k < 240; k++) {
        const dm_drag_input input = {.struct_size = sizeof input, .flags = k < 60 ? DM_INPUT_LOCKED : 0};
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        events |= now.events;
        if (k < 60) assert_true(now.value < 1e-3f);
    }
    assert_true(now.value == 1 && events & DM_EVENT_LOCKED);
}

/* A pull against a lock is no evidence against the joint, and moves no estimated limit. */
static void a_lock_is_no_evidence(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .flags = DM_RULE_LOCKED};
    const float grab[3] = {0, 0, 0};
    dm_joint joints[2] = {test_slide, {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}, .upper = 1}};
    joints[0].joint_confidence = joints[1].joint_confidence = 0.5f;
    dmi_drag drag;
    dm_drag_state now = {0};
    dmi_drag_begin(&drag, &joints[0], grab, 0, &feel);
    dmi_drag_track_hypotheses(&drag, joints, NULL, 2, 1, (dmi_limit_give){.length = 1});
    const dmi_rules kept = dmi_rules_from(&rules, &feel, &joints[0], false, 1);
    dmi_drag_set_rules(&drag, &kept);
    for (int k = 0; k < 60; k++) {
        const dm_ray ray = {{0, 0.03f * (float)k, 5}, {0, 0, -1}};
        dmi_drag_update(&drag, &ray, 1.0f / 60, &now);
    }
    assert_int_equal(now.changes, 0);
    for (int k = 0; k < 60; k++) {
        const dm_ray ray = {{0.05f * (float)k, 0, 5}, {0, 0, -1}};
        dmi_drag_update(&drag, &ray, 1.0f / 60, &now);
    }
    assert_true(drag.joint.upper == 1 && now.value < 0.011f);
}

/* ---- thresholds, at both sides ---- */

static dmi_rules latch_rules(uint32_t flags, float give) {
    const dm_drag_feel feel = {0};
    const dm_drag_rules given = {.struct_size = sizeof given, .flags = flags, .lock_give = give, .latch_turn = 0.5f};
    return dmi_rules_from(&given, &feel, &test_slide, false, 1);
}

/* Within 1/100 of the range from rest, wherever that is. */
static void a_latch_catches_near_rest(void** state) {
    (void)state;
    const dmi_rules rules = latch_rules(DM_RULE_LATCH, 0), none = latch_rules(0, 0);
    const dm_joint joints[3] = {{.type = DM_JOINT_PRISMATIC, .lower = 0, .upper = 4},
                                {.type = DM_JOINT_PRISMATIC, .lower = -3, .upper = 1},
                                {.type = DM_JOINT_PRISMATIC, .lower = 2, .upper = 6}};
    const float rests[3] = {0, 0, 2}, no_handles[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        for (int side = i == 1 ? -1 : 1; side <= 1; side += 2) {
            for (int far = 0; far < 2; far++) {
                const float value = rests[i] + (float)side * (far ? 0.0401f : 0.0399f);
                dmi_latch latch = dmi_latch_begin(&rules, &joints[i], value),
                          without = dmi_latch_begin(&none, &joints[i], value);
                assert_int_equal(latch.closed, !far);
                assert_false(without.closed);
                latch = (dmi_latch){0};
                const uint32_t events = dmi_latch_update(&latch, &rules, &joints[i], value, false, no_handles);
                assert_int_equal(events, far ? 0 : DM_EVENT_LATCHED);
                if (!far) assert_near(latch.at, rests[i], 0);
                assert_int_equal(dmi_latch_holds(&latch), !far);
                assert_int_equal(dmi_latch_update(&without, &none, &joints[i], value, false, no_handles), 0);
            }
        }
    }
}

static void either_handle_turns_either_way(void** state) {
    (void)state;
    const dmi_rules rules = latch_rules(DM_RULE_LATCH, 0);
    for (int which = 0; which < 2; which++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            const struct {
                float turn;
                uint32_t events;
            } steps[] = {{0.499f, 0}, {0.5f, DM_EVENT_UNLATCHED}, {0.401f, 0}, {0.399f, DM_EVENT_LATCHED}, {0.499f, 0}};
            dmi_latch latch = dmi_latch_begin(&rules, &test_slide, 0);
            for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
                float handles[2] = {0.1f, 0.1f};
                handles[which] = (float)sign * steps[i].turn;
                assert_int_equal(dmi_latch_update(&latch, &rules, &test_slide, 0, false, handles), steps[i].events);
            }
        }
    }
}

/* A lock holds the part where it is as it is locked, until it is not. */
static void a_lock_holds_where_the_part_was(void** state) {
    (void)state;
    const dmi_rules rules = latch_rules(0, 0), locked = latch_rules(DM_RULE_LOCKED, 0);
    const float no_handles[2] = {0, 0};
    dmi_latch latch = dmi_latch_begin(&rules, &test_slide, 0.3f);
    dmi_latch_update(&latch, &rules, &test_slide, 0.3f, true, no_handles);
    dmi_latch_update(&latch, &rules, &test_slide, 0.305f, true, no_handles);
    assert_true(dmi_latch_holds(&latch) && latch.at == 0.3f);
    dmi_latch_update(&latch, &rules, &test_slide, 0.305f, false, no_handles);
    assert_false(dmi_latch_holds(&latch));
    dmi_latch_update(&latch, &rules, &test_slide, 0.6f, true, no_handles);
    assert_true(latch.at == 0.6f);
    latch = dmi_latch_begin(&locked, &test_slide, 0.4f);
    dmi_latch_update(&latch, &locked, &test_slide, 0.4f, false, no_handles);
    assert_true(dmi_latch_holds(&latch) && latch.at == 0.4f);
}

/* Less and less is given, most never: at as much asked as that, half. A try is twice of it, or of 1/100 of the range;
 * less than once ends it. */
static void what_is_held_gives_and_is_tried(void** state) {
    (void)state;
    const float gives[] = {-1, 0, 0.05f};
    for (int i = 0; i < 3; i++) {
        const dmi_rules rules = latch_rules(DM_RULE_LOCKED, gives[i]);
        const double most = i == 0 ? 0 : i == 1 ? 0.01 : 0.05, threshold = fmax(most, 0.01);
        for (int side = -1; side <= 1; side += 2) {
            dmi_latch latch = {.locked = true, .at = 0.5f};
            const float s = (float)side;
            for (int k = 0; k <= 20; k++) {
                const double off = 0.01 * k;
                const double given = most > 0 ? most * off / (most + off) : 0;
                assert_near(dmi_latch_give(&latch, &rules, &test_slide, 0.5f + s * (float)off), 0.5 + (double)s * given,
                            1e-6);
            }
            const struct {
                double off;
                uint32_t events;
                bool tried;
            } steps[] = {
                {1.99, 0, false}, {2.01, DM_EVENT_LOCKED, true}, {3, 0, true}, {1.01, 0, true}, {0.99, 0, false},
                {1.99, 0, false}, {2.01, DM_EVENT_LOCKED, true}};
            for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
                const float asked = 0.5f + s * (float)(steps[k].off * threshold);
                assert_int_equal(dmi_latch_try(&latch, &rules, &test_slide, asked), steps[k].events);
                assert_int_equal(latch.tried, steps[k].tried);
            }
            latch.locked = false;
            assert_int_equal(dmi_latch_try(&latch, &rules, &test_slide, 5), 0);
            assert_false(latch.tried);
        }
    }
}

/* A part that closes by itself takes the stated time, or what its speed allows; one told to close takes its own. */
static void closing_by_itself_takes_its_time(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const struct {
        float time, most;
        int32_t intent;
        float duration;
    } cases[] = {{0, 0, DM_INTENT_AUTO, 0.25f},
                 {0.6f, 0, DM_INTENT_AUTO, 0.6f},
                 {0.6f, 0.5f, DM_INTENT_AUTO, 0.75f},
                 {0.6f, 1, DM_INTENT_AUTO, 0.6f},
                 {0.6f, 0, DM_INTENT_CLOSE, 0.313050f}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_rules given = {.struct_size = sizeof given,
                                     .auto_close_share = 0.3f,
                                     .auto_close_time = cases[i].time,
                                     .max_speed = cases[i].most};
        const dmi_rules rules = dmi_rules_from(&given, &feel, &test_slide, false, 1);
        const dmi_released_part part = {.joint = &test_slide, .feel = &feel, .rules = &rules, .value = 0.2f};
        dmi_release plan = {0};
        dmi_release_begin(&plan, &part, cases[i].intent, 0);
        assert_int_equal(plan.intent, DM_INTENT_CLOSE);
        assert_near(plan.duration, cases[i].duration, 1e-5); /* 1.875 0.2 / 0.5; 0.7 sqrt(0.2) */
    }
}

/* The closer begins when its delay is over, not an update before; the host's STAY stops it. */
static void a_closer_begins_on_time(void** state) {
    (void)state;
    const dm_drag_feel feel = {.return_time = 0.5f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .close_delay = 0.5f};
    for (int stays = 0; stays < 2; stays++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        test_begin(&drag, &test_slide, 0.8f, &feel, &rules);
        dmi_drag_release(&drag, stays ? DM_INTENT_STAY : DM_INTENT_AUTO, 0);
        for (int k = 1; k <= 9; k++) { /* of 1/8 s: all exact */
            dmi_drag_update(&drag, NULL, 0.125f, &now);
            const double share = stays || k <= 4 ? 0 : fmin(0.25 * (k - 4), 1);
            const double way = share * share * share * (10 - 15 * share + 6 * share * share);
            assert_near(now.value, 0.8 * (1 - way), 1e-5);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_locked_part_gives_a_little_and_says_so),
        cmocka_unit_test(a_handle_opens_the_latch),
        cmocka_unit_test(a_part_that_comes_free_glides_to_the_hand),
        cmocka_unit_test(a_latch_catches_again),
        cmocka_unit_test(a_part_near_rest_closes_into_its_latch),
        cmocka_unit_test(held_parts_do_not_close_by_themselves),
        cmocka_unit_test(a_closer_waits),
        cmocka_unit_test(a_locked_release_waits),
        cmocka_unit_test(a_lock_is_no_evidence),
        cmocka_unit_test(a_latch_catches_near_rest),
        cmocka_unit_test(either_handle_turns_either_way),
        cmocka_unit_test(a_lock_holds_where_the_part_was),
        cmocka_unit_test(what_is_held_gives_and_is_tried),
        cmocka_unit_test(closing_by_itself_takes_its_time),
        cmocka_unit_test(a_closer_begins_on_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
