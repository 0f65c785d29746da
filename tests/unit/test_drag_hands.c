/* Hands other than one pointer: in space, scalars, two of them, and a value that the host takes instead. */
#include "test_rules.h"

#define TURN 1.2f

static const dm_joint hinge = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .lower = 0, .upper = 1.5f};
static const dm_drag_rules plain = {.struct_size = sizeof plain};

static void point_at(const dm_joint* joint, float value, const float rest[3], float out[3]) {
    const dm_pose pose = dmi_joint_pose(joint, value);
    dmi_pose_apply(&pose, rest, out);
}

/* Any joint, any value: the point itself asks for the value that it is at; beside it, the nearest one. */
static void a_hand_in_space_is_followed(void** state) {
    (void)state;
    static const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};
    dmi_random random = dmi_random_make(11, 0);
    for (int i = 0; i < 400; i++) {
        const dm_joint joint = test_joint(&random, types[i % 4], 1);
        float rest[3], hand[3];
        test_point(&random, 2, rest);
        const float value = test_range(&random, joint.lower, joint.upper);
        point_at(&joint, value, rest, hand);
        const float start = value + test_range(&random, -0.3f, 0.3f);
        assert_near(dmi_follow_point(&joint, rest, hand, start, -INFINITY, INFINITY), value, 2e-3);
        assert_true(dmi_follow_point(&joint, rest, hand, start, value + 0.1f, value + 0.2f) == value + 0.1f);
        float near[3], there[3], other[3];
        test_point(&random, 0.1f, near);
        for (int k = 0; k < 3; k++) near[k] += hand[k];
        const float best = dmi_follow_point(&joint, rest, near, value, -INFINITY, INFINITY);
        point_at(&joint, best, rest, there);
        for (int side = -1; side <= 1; side += 2) {
            point_at(&joint, best + 0.02f * (float)side, rest, other);
            assert_true(test_distance(there, near) <= test_distance(other, near) + 1e-5);
        }
    }
}

static dm_drag_input hand_at(const dm_joint* joint, float value, const float rest[3]) {
    dm_drag_input input = {.struct_size = sizeof input, .hand.kind = DM_HAND_POINT};
    float point[3];
    point_at(joint, value, rest, point);
    input.hand.point = dmi_vec3(point);
    return input;
}

static void begin(dmi_drag* drag, const dm_joint* joint, const float grab[3], const dm_drag_rules* rules) {
    const dm_drag_feel feel = {0};
    const dmi_rules kept = dmi_rules_from(rules, &feel, joint, false, 1);
    dmi_drag_begin(drag, joint, grab, 0, &feel);
    dmi_drag_set_rules(drag, &kept);
}

/* Grabbed a hand's breadth beside the point: nothing jumps, and the part goes as far as the hand does. */
static void a_hand_keeps_its_distance(void** state) {
    (void)state;
    const float rest[3] = {1, 0, 0};
    for (int rate = 0; rate < TEST_RATES; rate++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        begin(&drag, &hinge, rest, &plain);
        for (float time = 0; time < 2;) {
            dm_drag_input input = hand_at(&hinge, fminf(time, TURN), rest);
            input.hand.point.z += 0.1f;
            dmi_drag_step(&drag, &input, time > 0 ? test_frame(rate, time) : 0, &now);
            if (time == 0) assert_true(now.value == 0);
            time += test_frame(rate, time);
        }
        assert_near(now.value, TURN, 1e-3);
    }
}

static void a_hand_too_far_lets_go(void** state) {
    (void)state;
    const float rest[3] = {1, 0, 0};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .break_distance = 0.3f};
    for (int by_ray = 0; by_ray < 2; by_ray++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        uint32_t events = 0;
        float miss = 0;
        begin(&drag, &hinge, rest, &rules);
        for (int k = 0; k < 120 && now.phase == DM_DRAG_HELD; k++) {
            miss = 0.005f * (float)k;
            dm_drag_input input = hand_at(&hinge, 0, rest);
            input.hand.point.x += miss;
            if (by_ray) input.hand = test_pointer((dm_ray){{1 + miss, 0, 5}, {0, 0, -1}});
            dmi_drag_step(&drag, &input, 1.0f / 60, &now);
            events |= now.events;
        }
        assert_true(events == DM_EVENT_LET_GO && miss > 0.29f && miss < 0.33f);
    }
}

/* A stick held for a second at half opens half of the range, whatever the rate; the other way closes; limits hold. */
static void a_stick_opens(void** state) {
    (void)state;
    const float rest[3] = {1, 0, 0};
    dm_joint other_way = hinge;
    other_way.lower = -1.5f, other_way.upper = 0;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        for (int side = 0; side < 2; side++) {
            const dm_joint* joint = side ? &other_way : &hinge;
            dmi_drag drag;
            dm_drag_state now = {0};
            begin(&drag, joint, rest, &plain);
            dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_RATE, .amount = 0.5f}};
            float time = 0;
            while (time < 1) {
                const float dt = fminf(test_frame(rate, time), 1 - time);
                time += dt;
                dmi_drag_step(&drag, &input, dt, &now);
            }
            input.hand.amount = 0;
            dmi_drag_step(&drag, &input, 1, &now);
            assert_near(now.value, side ? -0.75 : 0.75, 1e-3);
            input.hand.amount = -1;
            for (int k = 0; k < 120; k++) dmi_drag_step(&drag, &input, 1.0f / 60, &now);
            assert_near(now.value, 0, 1e-5);
        }
    }
}

/* Drags the hinge with a limit that was estimated; 0.3 s after it was met it has given to a stick, at any rate. */
static float held_for(float seconds, int rate, float amount) {
    const float rest[3] = {1, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_RATE, .amount = amount}};
    begin(&drag, &hinge, rest, &plain);
    dmi_drag_track_hypotheses(&drag, &hinge, NULL, 1, 1, (dmi_limit_give){0, 1});
    for (float time = 0; time < seconds;) {
        const float dt = fminf(test_frame(rate, time), seconds - time);
        time += dt;
        dmi_drag_step(&drag, &input, dt, &now);
    }
    input.hand.amount = 0;
    dmi_drag_step(&drag, &input, 1, &now);
    return now.value;
}

static void estimated_limits_give_to_a_stick_that_presses_on(void** state) {
    (void)state;
    for (int rate = 0; rate < TEST_RATES; rate++) {
        assert_near(held_for(1.2f, rate, 1), 1.5, 1e-5); /* there after 1 s, and stopped for 0.25 s */
        assert_near(held_for(1.75f, rate, 1), 2.25, 1e-2);
        assert_near(held_for(2, rate, -1), 0, 1e-5); /* rest is no estimate */
    }
}

static void estimated_limits_give_to_one_more_step(void** state) {
    (void)state;
    const float rest[3] = {1, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    const dm_drag_input step = {.struct_size = sizeof step, .hand = {.kind = DM_HAND_STEP, .amount = 0.4f}},
                        slider = {.struct_size = sizeof slider, .hand = {.kind = DM_HAND_VALUE, .amount = 3}},
                        nothing = {.struct_size = sizeof nothing};
    static const float wanted[5] = {0.6f, 1.2f, 1.5f, 2.1f, 1.5f}; /* three steps, one beyond, the slider */
    begin(&drag, &hinge, rest, &plain);
    dmi_drag_track_hypotheses(&drag, &hinge, NULL, 1, 1, (dmi_limit_give){0, 1});
    for (int i = 0; i < 5; i++) {
        dmi_drag_step(&drag, i < 4 ? &step : &slider, 1.0f / 60, &now);
        for (int k = 0; k < 60; k++) dmi_drag_step(&drag, &nothing, 1.0f / 60, &now);
        assert_near(now.value, wanted[i], 1e-3);
    }
}

static void a_wheel_and_a_slider_go_where_they_say(void** state) {
    (void)state;
    const float rest[3] = {1, 0, 0};
    const float snaps[2] = {0.4f, 1.1f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .snaps = snaps, .snap_count = 2};
    dmi_drag drag;
    dm_drag_state now = {0};
    begin(&drag, &hinge, rest, &plain);
    const dm_drag_input wheel = {.struct_size = sizeof wheel, .hand = {.kind = DM_HAND_STEP, .amount = 0.1f}},
                        rest_of = {.struct_size = sizeof rest_of};
    for (int k = 0; k < 3; k++) dmi_drag_step(&drag, &wheel, 1.0f / 60, &now);
    for (int k = 0; k < 60; k++) dmi_drag_step(&drag, &rest_of, 1.0f / 60, &now);
    assert_near(now.value, 0.45, 1e-4);
    for (int i = 0; i < 2; i++) {
        begin(&drag, &hinge, rest, i ? &rules : &plain);
        const dm_drag_input slider = {.struct_size = sizeof slider, .hand = {.kind = DM_HAND_VALUE, .amount = 0.9f}};
        for (int k = 0; k < 60; k++) dmi_drag_step(&drag, &slider, 1.0f / 60, &now);
        assert_near(now.value, 0.9, 1e-3);
    }
}

/* A slide of a wide lid: hands at both ends. Each alone counts whole; together they average; neither jumps. */
static void two_hands_agree(void** state) {
    (void)state;
    for (int by_ray = 0; by_ray < 2; by_ray++) {
        dmi_drag drag;
        dm_drag_state now = {0};
        float last = 0;
        const float rest[3] = {0, 0, 0};
        begin(&drag, &test_slide, rest, &plain);
        for (int k = 0; k < 240; k++) {
            const float first = fminf(0.005f * (float)k, 0.4f),
                        second = k < 120 ? 0.4f : fminf(0.4f + 0.005f * (float)(k - 120), 0.6f);
            dm_drag_input input = {.struct_size = sizeof input};
            input.hand =
                by_ray ? test_pointer(test_ray_at(first)) : (dm_hand){.kind = DM_HAND_POINT, .point = {first, 0, 0}};
            if (k >= 100 && k < 200) {
                const dm_hand ray = test_pointer((dm_ray){{second, 1, 5}, {0, 0, -1}});
                input.second = by_ray ? ray : (dm_hand){.kind = DM_HAND_POINT, .point = {second, 1.05f, 0}};
                input.second.grab_point = (dm_vec3){now.value, 1, 0};
            }
            dmi_drag_step(&drag, &input, 1.0f / 60, &now);
            assert_true(fabsf(now.value - last) < 0.006f);
            last = now.value;
            if (k == 119) assert_near(now.value, 0.4, 1e-3); /* it has come without a jump */
            if (k == 199) assert_near(now.value, 0.5, 1e-3); /* 0.4 and 0.6 */
        }
        assert_near(now.value, 0.5, 1e-3); /* it has gone without a jump: the first holds on where the part is */
    }
}

/* The hand at the longer lever says more: by the squares of both arms. */
static void the_longer_lever_counts_more(void** state) {
    (void)state;
    const float rest[3] = {2, 0, 0}, other[3] = {1, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    begin(&drag, &hinge, rest, &plain);
    for (int k = 0; k <= 60; k++) {
        dm_drag_input input = hand_at(&hinge, 0.01f * (float)k, rest);
        input.second = hand_at(&hinge, 0, other).hand;
        input.second.grab_point = dmi_vec3(other);
        dmi_drag_step(&drag, &input, k > 0 ? 1.0f / 60 : 0, &now);
    }
    for (int k = 0; k < 60; k++) {
        dm_drag_input input = hand_at(&hinge, 0.6f, rest);
        input.second = hand_at(&hinge, 0, other).hand;
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
    }
    assert_near(now.value, 0.6 * 4 / 5, 2e-3);
}

/* The host takes steps of a tenth: events and velocity are those of what it took. */
static void a_filter_decides(void** state) {
    (void)state;
    const dm_drag_rules rules = {.struct_size = sizeof rules, .open_share = 0.35f};
    const float rest[3] = {0, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    uint32_t opened = 0;
    begin(&drag, &test_slide, rest, &rules);
    for (int k = 0; k < 60; k++) {
        dm_drag_input input = {.struct_size = sizeof input, .flags = DM_INPUT_ASK};
        input.hand = test_pointer(test_ray_at(0.01f * (float)k));
        const float last = now.value;
        dmi_drag_step(&drag, &input, 1.0f / 60, &now);
        const float asked = now.value;
        dmi_drag_take(&drag, 0.1f * floorf(10 * asked + 1e-3f), &now);
        assert_true(now.value <= asked + 1e-3f);
        assert_near(10 * now.value, roundf(10 * now.value), 1e-4);
        if (now.value != last) assert_near(now.velocity, (now.value - last) * 60, 1e-3);
        if (now.events & DM_EVENT_OPENED) opened++, assert_near(now.value, 0.4, 1e-5);
    }
    assert_int_equal(opened, 1);
    dmi_drag_begin(&drag, &test_slide, rest, 0, &drag.feel); /* the same without rules */
    dm_drag_input ask = {.struct_size = sizeof ask, .flags = DM_INPUT_ASK, .hand = test_pointer(test_ray_at(0))};
    for (int k = 0; k < 30; k++) {
        const float last = now.value;
        ask.hand.ray = test_ray_at(0.01f * (float)k);
        dmi_drag_step(&drag, &ask, 1.0f / 60, &now);
        dmi_drag_take(&drag, 0.5f * now.value, &now);
        if (k > 0) assert_near(now.velocity, (now.value - last) * 60, 1e-3);
    }
    begin(&drag, &test_slide, rest, &rules);
    dm_drag_input bounded = {.struct_size = sizeof bounded, .flags = DM_INPUT_ASK, .lower = -1, .upper = 0.7f};
    bounded.hand = test_pointer(test_ray_at(0.6f));
    dmi_drag_step(&drag, &bounded, 1.0f / 60, &now);
    dmi_drag_take(&drag, 5, &now);
    assert_near(now.value, 0.7, 1e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hand_in_space_is_followed),
        cmocka_unit_test(a_hand_keeps_its_distance),
        cmocka_unit_test(a_hand_too_far_lets_go),
        cmocka_unit_test(a_stick_opens),
        cmocka_unit_test(estimated_limits_give_to_a_stick_that_presses_on),
        cmocka_unit_test(estimated_limits_give_to_one_more_step),
        cmocka_unit_test(a_wheel_and_a_slider_go_where_they_say),
        cmocka_unit_test(two_hands_agree),
        cmocka_unit_test(the_longer_lever_counts_more),
        cmocka_unit_test(a_filter_decides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
