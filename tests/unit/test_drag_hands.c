/* Hands other than one pointer: in space, scalars, two of them, and a value that the host takes instead. */
#include "test_rules.h"

#include "drag/drag_internal.h"

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

/* ---- what hands ask for, to the number ---- */

static const dm_joint ways[] = {{.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .lower = 0, .upper = 1.5f},
                                {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .lower = -1.5f, .upper = 0},
                                {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -0.2f, .upper = 1},
                                {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 0.2f},
                                {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}},
                                {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}}};
/* The joint value of a whole way towards the open end; without limits 1 rad, or the object's size. */
static const float whole[] = {1.5f, -1.5f, 1.2f, -1.2f, 1, 3};

static void scalars_ask_for_shares_of_the_way(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    const float rest[3] = {1, 0, 0};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        for (int driven = 0; driven < 2; driven++) {
            const dm_drag_rules given = {.struct_size = sizeof given, .drive_speed = driven ? 0.4f : 0};
            const dmi_rules rules = dmi_rules_from(&given, &feel, &ways[i], false, 3);
            dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_RATE, .amount = 0.5f}};
            dmi_drag drag;
            dm_drag_state now = {0};
            dmi_drag_begin(&drag, &ways[i], rest, 0, &feel);
            dmi_drag_set_rules(&drag, &rules);
            double wanted = 0.5 * (driven ? 0.4 : 1) * 0.25 * (double)whole[i];
            dmi_drag_step(&drag, &input, 0.25f, &now);
            assert_near(now.value, wanted, 1e-6);
            input.hand = (dm_hand){.kind = DM_HAND_STEP, .amount = 0.1f};
            wanted += 0.1 * (double)whole[i];
            dmi_drag_step(&drag, &input, 0.25f, &now);
            assert_near(now.value, wanted, 1e-6);
            input.hand = (dm_hand){.kind = DM_HAND_VALUE, .amount = 0.3f * whole[i]};
            dmi_drag_step(&drag, &input, 0.25f, &now);
            assert_near(now.value, 0.3f * whole[i], 1e-6);
            if (!dmi_joint_has_limits(&ways[i])) continue;
            for (int side = -1; side <= 1; side += 2) {
                const float end = (float)side * whole[i] > 0 ? ways[i].upper : ways[i].lower;
                for (int kind = DM_HAND_RATE; kind <= DM_HAND_VALUE; kind++) {
                    const float amount = kind == DM_HAND_VALUE ? (float)side * 9 * whole[i] : (float)side;
                    input.hand = (dm_hand){.kind = kind, .amount = amount};
                    for (int k = 0; k < 20; k++) dmi_drag_step(&drag, &input, 0.25f, &now);
                    assert_near(now.value, end, 0);
                }
            }
        }
    }
}

/* A rate reaches an estimated limit, is stopped for a quarter of a second, and goes on: at any rate of frames as far.
 */
static void an_estimate_gives_to_a_rate_after_its_time(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(12, 0);
    const dm_drag_feel feel = {.smoothing_time = -1};
    const float rest[3] = {1, 0, 0};
    for (int i = 0; i < 200; i++) {
        const dm_joint* joint = &ways[i % 2 ? 0 : 3];
        const double way = (double)whole[i % 2 ? 0 : 3], end = i % 2 ? 1.5 : -1;
        const float seconds = test_range(&random, 0.2f, 2), amount = test_range(&random, 0.7f, 2);
        dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_RATE, .amount = amount}};
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, joint, rest, 0, &feel);
        dmi_drag_track_hypotheses(&drag, joint, NULL, 1, 1, (dmi_limit_give){.share = 2, .length = 9});
        double time = 0;
        while (time < (double)seconds) {
            const double dt = fmin((double)test_range(&random, 0.005f, 0.2f), (double)seconds - time);
            time += dt;
            dmi_drag_step(&drag, &input, (float)dt, &now);
        }
        const double speed = (double)amount * way, met = end / speed, range = fabs(way);
        const double beyond = fmin(fabs(speed) * fmax(time - met - 0.25, 0), 2 * range), width = 0.01 * range;
        const double kept = beyond > 3 * width ? beyond : 1.5 * fmax(beyond - width, 0);
        const double wanted = time < met ? speed * time : end + copysign(kept, way);
        assert_near(now.value, wanted, 1e-4);
    }
}

/* Both hands average by the squares of their levers: exactly, once both hold. */
static void two_hands_weigh_by_the_squares_of_their_levers(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(13, 0);
    const dm_drag_feel feel = {.smoothing_time = -1};
    for (int i = 0; i < 100; i++) {
        const float rest[3] = {test_range(&random, 0.3f, 2), 0, 0}, other[3] = {0, test_range(&random, 0.3f, 2), 1};
        const float first = test_range(&random, 0.1f, 0.5f), second = test_range(&random, 0.1f, 0.5f);
        dmi_drag drag;
        dm_drag_state now = {0};
        dm_drag_input input = hand_at(&hinge, 0, rest);
        const bool lets_go = i % 2;
        dmi_drag_begin(&drag, &hinge, rest, 0, &feel);
        dmi_drag_step(&drag, &input, 0.1f, &now);
        input.second = hand_at(&hinge, 0, other).hand;
        input.second.grab_point = dmi_vec3(other);
        for (int k = 0; k <= 20; k++) {
            const float share = 0.05f * (float)k;
            input.hand = hand_at(&hinge, first * share, rest).hand;
            const dm_vec3 point = hand_at(&hinge, second * share, other).hand.point;
            input.second.point = point;
            dmi_drag_step(&drag, &input, 0.1f, &now);
        }
        for (int k = 0; k < 40; k++) dmi_drag_step(&drag, &input, 0.1f, &now);
        const double w1 = (double)(rest[0] * rest[0]), w2 = (double)(other[1] * other[1]);
        const double both = (w1 * (double)first + w2 * (double)second) / (w1 + w2);
        assert_near(now.value, both, 1e-4);
        if (!lets_go) continue;
        input.second = (dm_hand){.kind = DM_HAND_NONE};
        for (int k = 0; k < 5; k++) dmi_drag_step(&drag, &input, 0.1f, &now);
        assert_near(now.value, both, 1e-4);
        for (int k = 1; k <= 20; k++) { /* the first goes on from there */
            input.hand = hand_at(&hinge, first + 0.01f * (float)k, rest).hand;
            dmi_drag_step(&drag, &input, 0.1f, &now);
        }
        assert_near(now.value, both + 0.2, 1e-3);
    }
}

/* How far a hand is off: of a point its distance, of a ray the line's, of a scalar none. */
static void a_hand_misses_by_its_distance(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    const float rest[3] = {0, 0, 0};
    dmi_drag drag;
    dm_drag_state now = {0};
    dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = DM_HAND_POINT}};
    dmi_drag_begin(&drag, &test_slide, rest, 0, &feel);
    assert_near(dmi_drag_hand_miss(&drag), 0, 0);
    dmi_drag_step(&drag, &input, 0.1f, &now);
    input.hand.point = (dm_vec3){0.5f, 0.3f, 0.4f};
    dmi_drag_step(&drag, &input, 0.1f, &now);
    assert_near(now.value, 0.5, 1e-6);
    assert_near(dmi_drag_hand_miss(&drag), 0.5, 1e-6);
    input.hand.point = (dm_vec3){1.5f, 0, 0};
    dmi_drag_step(&drag, &input, 0.1f, &now);
    assert_near(dmi_drag_hand_miss(&drag), 0.5, 1e-6);
    dmi_drag_begin(&drag, &test_slide, rest, 0, &feel);
    dm_ray ray = test_ray_at(0);
    dmi_drag_update(&drag, &ray, 0.1f, &now);
    ray = test_ray_at(1.25f), ray.origin.y = 0.5f;
    for (int k = 0; k < 9; k++) dmi_drag_update(&drag, &ray, 0.1f, &now);
    assert_near(dmi_drag_hand_miss(&drag), hypot(0.25, 0.5), 1e-5);
    input.hand = (dm_hand){.kind = DM_HAND_RATE};
    dmi_drag_step(&drag, &input, 0.1f, &now);
    assert_near(dmi_drag_hand_miss(&drag), 0, 0);
}

/* The host's value within bounds and limits; its speed is the way over the time, none without time. */
static void what_is_taken_is_what_was_allowed(void** state) {
    (void)state;
    const dm_drag_feel feel = {.smoothing_time = -1};
    for (int ruled = 0; ruled < 2; ruled++) {
        const struct {
            float lower, upper, taken, value;
        } cases[] = {
            {0, 0, 0.3f, 0.3f},        {0, 0, 2, 1},           {0, 0, -2, 0},           {0.1f, 0.7f, 0.9f, 0.7f},
            {0.1f, 0.7f, 0.05f, 0.1f}, {-5, 0.7f, 0.2f, 0.2f}, {0.1f, 0.7f, 0.5f, 0.5f}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            const float grab[3] = {0.5f, 0, 0};
            dm_drag_input input = {.struct_size = sizeof input,
                                   .flags = DM_INPUT_ASK,
                                   .hand = test_pointer(test_ray_at(0.5f)),
                                   .lower = cases[i].lower,
                                   .upper = cases[i].upper};
            dmi_drag drag;
            dm_drag_state now = {0};
            if (ruled)
                test_begin(&drag, &test_slide, 0.5f, &feel, &plain);
            else
                dmi_drag_begin(&drag, &test_slide, grab, 0.5f, &feel);
            dmi_drag_step(&drag, &input, 0.25f, &now);
            dmi_drag_take(&drag, cases[i].taken, &now);
            assert_near(now.value, cases[i].value, 0);
            assert_near(now.grab_point.x, cases[i].value, 1e-6);
            assert_near(now.velocity, (cases[i].value - 0.5f) / 0.25f, 1e-5);
            const float velocity = now.velocity;
            dmi_drag_step(&drag, &input, 0, &now);
            dmi_drag_take(&drag, 0.6f, &now);
            if (ruled || now.value != 0.6f) continue;
            assert_near(now.velocity, velocity, 1e-5);
        }
    }
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
        cmocka_unit_test(scalars_ask_for_shares_of_the_way),
        cmocka_unit_test(an_estimate_gives_to_a_rate_after_its_time),
        cmocka_unit_test(two_hands_weigh_by_the_squares_of_their_levers),
        cmocka_unit_test(a_hand_misses_by_its_distance),
        cmocka_unit_test(what_is_taken_is_what_was_allowed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
