/* Released parts: what was meant, no jump of place or speed on the way there, the same at any frame rate. */
#include "test_math.h"

#include "drag/drag.h"

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

/* A drawer that is modelled 0.2 out of its cabinet, with 0.3 to go. */
static const dm_joint ajar = {
    .type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -0.2f, .upper = 0.3f, .closed = -0.2f};

static void a_part_that_rests_open_closes_to_where_it_is_closed(void** state) {
    (void)state;
    const meant_case cases[] = {
        {0.1f, 0, DM_INTENT_CLOSE, -0.2f},
        {0, 0, DM_INTENT_CLOSE, -0.2f}, /* also from rest */
        {-0.1f, 0, DM_INTENT_TOGGLE, 0.3f},
        {0.2f, 0, DM_INTENT_TOGGLE, -0.2f},
        {-0.19f, -0.01f, DM_INTENT_AUTO, -0.2f} /* nearly shut */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_feel feel = {0};
        dmi_drag drag = held_at(&ajar, cases[i].value, cases[i].velocity, &feel);
        int32_t intent = cases[i].intent;
        if (intent == DM_INTENT_TOGGLE) intent = dmi_drag_is_open(&drag) ? DM_INTENT_CLOSE : DM_INTENT_OPEN;
        dmi_drag_release(&drag, intent, 0);
        assert_near(run_out(&drag, FRAME), cases[i].end, 1e-3);
    }
}

static void the_open_share_counts_from_closed(void** state) {
    (void)state;
    static const dm_joint both_sides = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = -1, .upper = 2};
    static const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 1, 0}};
    const struct {
        const dm_joint* joint;
        float value, share;
    } cases[] = {{&ajar, -0.2f, 0},   {&ajar, 0, 0.4f},     {&ajar, 0.3f, 1},       {&door, 0, 0},
                 {&door, 0.8f, 0.5f}, {&both_sides, -1, 0}, {&both_sides, 1, 0.5f}, {&wheel, 1, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const dm_drag_feel feel = {0};
        dm_drag_state now;
        const dmi_drag drag = held_at(cases[i].joint, cases[i].value, 0, &feel);
        dmi_drag_get_state(&drag, &now);
        assert_near(now.open_share, cases[i].share, 1e-6);
    }
}

/* Detents are spaced from where the part is closed. */
static void detents_begin_where_the_part_is_closed(void** state) {
    (void)state;
    const dm_drag_feel feel = {.detent = 0.15f};
    dmi_drag drag = held_at(&ajar, -0.06f, 0, &feel);
    dmi_drag_release(&drag, DM_INTENT_STAY, 0);
    assert_near(run_out(&drag, FRAME), -0.05, 1e-3);
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

/* ---- plans against their formulas ---- */

static const dm_joint hinges[] = {
    {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = 0, .upper = 1.6f},
    {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = -1.6f, .upper = 0},
    {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = -0.7f, .upper = 1.2f},
    {.type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = 0, .upper = 0.4f},
    {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}},
};
enum { HINGES = sizeof hinges / sizeof *hinges, SHARES = 20 };

static double minimum_jerk(double s) {
    return s * s * s * (10 - 15 * s + 6 * s * s);
}

static double clamped(const dm_joint* joint, double value) {
    return dmi_joint_has_limits(joint) ? fmin(fmax(value, (double)joint->lower), (double)joint->upper) : value;
}

/* The speed that a part keeps: one that goes away from its end gets no farther than the stop behind it. */
static double kept_speed(const dm_joint* joint, const dmi_release* plan, double speed) {
    const double way = (double)(plan->end - plan->start);
    if (speed * way >= 0 || !dmi_joint_has_limits(joint)) return speed;
    const double room = speed > 0 ? (double)(joint->upper - plan->start) : (double)(plan->start - joint->lower);
    return copysign(fmin(fabs(speed), room / (0.105 * (double)plan->duration)), speed);
}

/* Where the part is at a share of the duration, from where it was released. */
static float value_at(const dmi_drag* released, double share) {
    dmi_drag drag = *released;
    dm_drag_state now;
    dmi_drag_update(&drag, NULL, (float)(share * (double)drag.release.duration), &now);
    return now.value;
}

static dmi_drag random_release(dmi_random* random, const dm_joint* joint, int32_t intent, const dm_drag_feel* feel) {
    const float low = joint->lower < joint->upper ? joint->lower : -3, high = low < joint->lower ? 3 : joint->upper;
    const float share = dmi_random_unit(random), near = dmi_random_u32(random) % 3 == 0 ? share * share * share : share;
    const float value = dmi_random_u32(random) % 2 ? low + near * (high - low) : high - near * (high - low);
    dmi_drag drag = held_at(joint, value, test_range(random, -3, 3), feel);
    dmi_drag_release(&drag, intent, 0);
    return drag;
}

static void a_plan_is_minimum_jerk_from_the_speed_that_the_part_has(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    dmi_random random = dmi_random_make(4, 6);
    int compared = 0;
    for (int i = 0; i < 400; i++) {
        const dm_joint* joint = &hinges[i % HINGES];
        const dmi_drag drag = random_release(&random, joint, i % 2 ? DM_INTENT_OPEN : DM_INTENT_CLOSE, &feel);
        const dmi_release* plan = &drag.release;
        if (plan->phase != DM_DRAG_RELEASED || plan->glides) continue;
        const double way = (double)(plan->end - plan->start), time = (double)plan->duration;
        const double speed = kept_speed(joint, plan, (double)drag.velocity);
        assert_near(plan->velocity, speed, 1e-5 * (1 + fabs(speed)));
        for (int k = 1; k < SHARES; k++) {
            const double s = (double)k / SHARES, left = 1 - s;
            const double wanted = (double)plan->start + way * minimum_jerk(s) + s * left * left * left * speed * time;
            assert_near(value_at(&drag, s), clamped(joint, wanted), 2e-5);
        }
        assert_near(value_at(&drag, 1.001), plan->end, 0);
        compared++;
    }
    assert_true(compared > 200);
}

/* By the root of the share of the range, not slower than half the speed that it has, 0.18 s at least. */
static void a_plan_takes_the_time_of_its_way(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    dmi_random random = dmi_random_make(5, 6);
    for (int i = 0; i < 600; i++) {
        const dm_joint* joint = &hinges[i % HINGES];
        const dm_drag_rules given = {.struct_size = sizeof given,
                                     .max_speed = i % 3 == 1 ? test_range(&random, 0.3f, 4) : 0,
                                     .max_acceleration = i % 4 == 1 ? test_range(&random, 1, 20) : 0};
        const dmi_rules rules = dmi_rules_from(&given, &feel, joint, false, 1);
        const bool limited = dmi_joint_has_limits(joint);
        const dmi_released_part part = {.joint = joint,
                                        .feel = &feel,
                                        .rules = &rules,
                                        .value = limited ? test_range(&random, joint->lower, joint->upper)
                                                         : test_range(&random, -3, 3),
                                        .velocity = i % 5 ? test_range(&random, -6, 6) : 0};
        dmi_release plan = {0};
        dmi_release_begin(&plan, &part, limited && i % 2 ? DM_INTENT_OPEN : DM_INTENT_CLOSE, 0);
        const double way = (double)plan.end - (double)part.value, range = (double)(joint->upper - joint->lower);
        if (fabs(way) <= 1e-4 * (limited ? range : 1)) continue;
        double time = 0.7 * sqrt(limited ? fabs(way) / range : 1);
        if ((double)part.velocity * way > 0) time = fmin(time, 2 * way / (double)part.velocity);
        time = fmax(time, 0.18);
        if (given.max_speed > 0) time = fmax(time, 1.875 * fabs(way) / (double)given.max_speed);
        if (given.max_acceleration > 0)
            time = fmax(time, sqrt(10 / sqrt(3) * fabs(way) / (double)given.max_acceleration));
        assert_near(plan.duration, time, 1e-4 * time);
        assert_near(plan.end, limited && i % 2 ? (double)dmi_release_open_end(&part) : 0, 0);
    }
}

/* The highest speed and acceleration of a planned motion from rest are those that the rules allow. */
static void a_limited_plan_uses_what_it_is_allowed(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    for (int by_force = 0; by_force < 2; by_force++) {
        const dm_drag_rules given = {
            .struct_size = sizeof given, .max_speed = by_force ? 0 : 0.5f, .max_acceleration = by_force ? 2.0f : 0};
        const dmi_rules rules = dmi_rules_from(&given, &feel, &door, false, 1);
        const dmi_released_part part = {.joint = &door, .feel = &feel, .rules = &rules, .value = 1.5f};
        dmi_release plan = {0};
        dmi_release_begin(&plan, &part, DM_INTENT_CLOSE, 0);
        double fastest = 0, hardest = 0;
        const double h = 1e-3, time = (double)plan.duration, way = 1.5;
        for (double s = h; s < 1 - h; s += h) {
            fastest = fmax(fastest, way * (minimum_jerk(s + h) - minimum_jerk(s - h)) / (2 * h) / time);
            hardest = fmax(hardest, fabs(way * (minimum_jerk(s + h) - 2 * minimum_jerk(s) + minimum_jerk(s - h)) /
                                         (h * h) / (time * time)));
        }
        assert_near(by_force ? hardest / 2 : fastest / 0.5, 1, 1e-3);
    }
}

static void what_is_there_already_does_not_move(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    for (int side = -1; side <= 1; side += 2) {
        const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}}, slide = {.type = DM_JOINT_PRISMATIC,
                                                                                          .axis = {0, 0, 1},
                                                                                          .lower = side < 0 ? -4.0f : 0,
                                                                                          .upper = side < 0 ? 0 : 4.0f};
        const dm_joint* joints[2] = {&wheel, &slide};
        for (int i = 0; i < 2; i++) {
            const float unit = (i ? 4 : 1) * (float)side;
            dmi_drag drag = held_at(joints[i], 0.9e-4f * unit, 0, &feel);
            dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
            assert_int_equal(drag.release.phase, DM_DRAG_AT_REST);
            drag = held_at(joints[i], 1.1e-4f * unit, 0, &feel);
            dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
            assert_int_equal(drag.release.phase, DM_DRAG_RELEASED);
            drag = held_at(joints[i], 0.5f * unit, 0.0005f * unit, &feel); /* glides 7e-5 far */
            dmi_drag_release(&drag, DM_INTENT_STAY, 0);
            assert_int_equal(drag.release.phase, DM_DRAG_AT_REST);
            drag = held_at(joints[i], 0.5f * unit, 0.001f * unit, &feel);
            dmi_drag_release(&drag, DM_INTENT_STAY, 0);
            assert_int_equal(drag.release.phase, DM_DRAG_RELEASED);
        }
    }
}

/* Speed halves with each half-life; the plan ends after seven. */
static void a_glide_decays(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 6);
    for (int i = 0; i < 200; i++) {
        const dm_joint* joint = &hinges[i % HINGES];
        const dm_drag_feel feel = {.coast_time = i % 2 ? test_range(&random, 0.02f, 0.5f) : 0};
        const double half_life = feel.coast_time > 0 ? (double)feel.coast_time : 0.1;
        const dmi_drag drag = random_release(&random, joint, DM_INTENT_STAY, &feel);
        if (drag.release.phase != DM_DRAG_RELEASED) continue;
        const double start = (double)drag.release.start, far = (double)drag.velocity * half_life / log(2);
        assert_true(drag.release.glides);
        assert_near(drag.release.duration, 7 * half_life, 1e-6);
        assert_near(drag.release.end, clamped(joint, start + far), 1e-5);
        for (int k = 1; k < SHARES; k++) {
            const double s = (double)k / SHARES;
            assert_near(value_at(&drag, s), clamped(joint, start + far * (1 - exp2(-7 * s))), 2e-5);
        }
    }
}

/* Where keys, scaled to the plan, first come to a value: in steps of a hundred-thousandth. */
static double first_time_at(const dmi_motion* keys, double scale, double value, double outer) {
    for (int k = 0; k <= 100000; k++)
        if (scale * (double)dmi_motion_value(keys, (float)k * 1e-5f) / outer >= value / outer) return 1e-5 * k;
    return 1;
}

static void a_paced_plan_is_the_part_of_the_keys(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    dmi_random random = dmi_random_make(7, 6);
    int compared = 0;
    for (int i = 0; i < 60; i++) {
        const dm_joint* joint = &hinges[i % 4];
        dmi_drag drag = random_release(&random, joint, i % 3 ? DM_INTENT_OPEN : DM_INTENT_CLOSE, &feel);
        dmi_release* plan = &drag.release;
        const bool outwards = fabsf(plan->end) > fabsf(plan->start);
        const float outer = outwards ? plan->end : plan->start, inner = outwards ? plan->start : plan->end;
        dmi_motion keys = {0};
        const float wave = test_range(&random, 0, 0.15f), size = test_range(&random, 0.6f, 1.8f);
        for (int k = 0; k < DM_MOTION_FRAMES; k++) {
            const float s = (float)k / (DM_MOTION_FRAMES - 1);
            keys.values[k] = outer * size * (s * s * (3 - 2 * s) + wave * sinf(6.2831853f * s));
        }
        if (plan->phase != DM_DRAG_RELEASED) continue;
        if (inner / outer < 0) {
            assert_false(dmi_release_set_pace(plan, keys.values));
            continue;
        }
        if (!dmi_release_set_pace(plan, keys.values)) continue;
        const double scale = (double)outer / (double)keys.values[DM_MOTION_FRAMES - 1], h = 1e-3;
        const double there = first_time_at(&keys, scale, (double)inner, (double)outer);
        const double first = outwards ? there : 1, last = outwards ? 1 : there;
#define ON_KEYS(s) (scale * (double)dmi_motion_value(&keys, (float)(first + (last - first) * (s))))
        const double time = (double)plan->duration, speed = kept_speed(joint, plan, (double)drag.velocity) * time;
        const double off = (double)plan->start - ON_KEYS(0), slope = (ON_KEYS(h) - ON_KEYS(0)) / h;
        for (int k = 1; k < SHARES; k++) {
            const double s = (double)k / SHARES, fade = pow(1 - s, 3);
            const double wanted = ON_KEYS(s) + fade * ((1 + 3 * s) * off + s * (speed - slope));
            assert_near(value_at(&drag, s), clamped(joint, wanted), 5e-4 * fabs((double)outer));
        }
#undef ON_KEYS
        compared++;
    }
    assert_true(compared > 25);
}

/* Keys from half to twice the plan's size suit it, on its side of rest; a glide and what is at rest have no pace. */
static void keys_suit_a_plan_of_their_size(void** state) {
    (void)state;
    const dm_drag_feel feel = {0};
    const dm_joint both = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = -1, .upper = 1};
    const struct {
        float start, last;
        int32_t intent;
        bool suits;
    } cases[] = {{0.2f, 0.5f, DM_INTENT_OPEN, false},   {0.2f, 0.501f, DM_INTENT_OPEN, true},
                 {0.2f, 2, DM_INTENT_OPEN, false},      {0.2f, 1.99f, DM_INTENT_OPEN, true},
                 {0, 1, DM_INTENT_OPEN, true},          {-0.1f, 1, DM_INTENT_OPEN, false},
                 {0.2f, -1, DM_INTENT_OPEN, false},     {0.8f, 0.8f, DM_INTENT_CLOSE, true},
                 {-0.8f, -0.8f, DM_INTENT_CLOSE, true}, {-0.8f, 0.8f, DM_INTENT_CLOSE, false},
                 {0.5f, 0.5f, DM_INTENT_STAY, false},   {0.5f, 0.5f, DM_INTENT_FREEZE, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        float keys[DM_MOTION_FRAMES];
        for (int k = 0; k < DM_MOTION_FRAMES; k++) keys[k] = cases[i].last * (float)k / (DM_MOTION_FRAMES - 1);
        dmi_drag drag = held_at(&both, cases[i].start, cases[i].intent == DM_INTENT_STAY ? -1 : 0, &feel);
        if (cases[i].intent == DM_INTENT_OPEN) drag.open_side = 1;
        dmi_drag_release(&drag, cases[i].intent, 0);
        assert_int_equal(dmi_release_set_pace(&drag.release, keys), cases[i].suits);
    }
}

/* ---- what is meant, at both sides of each threshold ---- */

typedef struct edge {
    float lower, upper, value, velocity;
    int32_t intent;
} edge;

static int32_t intent_of(float lower, float upper, float value, float velocity) {
    const dm_drag_feel feel = {0};
    const dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = lower, .upper = upper};
    const dmi_released_part part = {.joint = &joint, .feel = &feel, .value = value, .velocity = velocity};
    return dmi_released_intent(&part, 0);
}

static void what_is_meant_has_sharp_edges(void** state) {
    (void)state;
    static const edge edges[] = {
        {0, 1, 0.119f, 0, DM_INTENT_CLOSE},          {0, 1, 0.121f, 0, DM_INTENT_STAY}, /* near an end */
        {0, 1, 0.881f, 0, DM_INTENT_OPEN},           {0, 1, 0.879f, 0, DM_INTENT_STAY},
        {0, 1, 0.779f, 0.5f, DM_INTENT_STAY},        {0, 1, 0.781f, 0.5f, DM_INTENT_OPEN}, /* 0.2 s ahead */
        {0, 1, 0.221f, -0.5f, DM_INTENT_STAY},       {0, 1, 0.219f, -0.5f, DM_INTENT_CLOSE},
        {0, 1, 0.5f, 1.74f, DM_INTENT_STAY},         {0, 1, 0.5f, 1.76f, DM_INTENT_OPEN}, /* thrown */
        {0, 1, 0.5f, -1.74f, DM_INTENT_STAY},        {0, 1, 0.5f, -1.76f, DM_INTENT_CLOSE},
        {0, 1, 0.3f, -1.6f, DM_INTENT_CLOSE},        {0, 1, 0.17f, -1.6f, DM_INTENT_CLOSE}, /* past rest */
        {0, 1, 0.03f, 0.1f, DM_INTENT_STAY},         {0, 1, 0, 0.5f, DM_INTENT_CLOSE}, /* outwards is not homewards */
        {-0.049f, 0.951f, 0.1f, 0, DM_INTENT_CLOSE}, {-0.051f, 0.949f, 0.1f, 0, DM_INTENT_STAY}, /* rests at a stop */
        {-0.4f, 0.6f, 0.3f, -1.8f, DM_INTENT_OPEN},  {-0.4f, 0.6f, 0.3f, -1.7f, DM_INTENT_STAY},
        {-0.4f, 0.6f, -0.29f, 0, DM_INTENT_OPEN},    {-0.4f, 0.6f, -0.27f, 0, DM_INTENT_STAY},
        {-0.4f, 0.6f, 0.49f, 0, DM_INTENT_OPEN},     {-0.4f, 0.6f, 0.47f, 0, DM_INTENT_STAY},
        {0.5f, 1.5f, 0.6f, 0, DM_INTENT_CLOSE},      {0.5f, 1.5f, 0.63f, 0, DM_INTENT_STAY}, /* shut is not at 0 */
    };
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        const edge e = edges[i];
        for (float size = 0.25f; size < 5; size *= 4) {
            assert_int_equal(intent_of(size * e.lower, size * e.upper, size * e.value, size * e.velocity), e.intent);
            assert_int_equal(intent_of(-size * e.upper, -size * e.lower, -size * e.value, -size * e.velocity),
                             e.intent);
        }
    }
}

/* A part opens to the limit that is not rest; of two, to the side where it is, or goes within 0.2 s. */
static void a_part_opens_to_the_side_of_the_pull(void** state) {
    (void)state;
    static const struct {
        float lower, upper, value, velocity;
        int32_t side;
        float end;
        bool open;
    } cases[] = {
        {0, 1, 0.49f, 0, 0, 1, false},         {0, 1, 0.51f, 0, 0, 1, true},
        {0, 1, 0.9f, -9, 0, 1, true},          {-0.4f, 1, 0.1f, -1, 0, -0.4f, false},
        {-0.4f, 1, 0.1f, -0.4f, 0, 1, false},  {-0.4f, 1, -0.1f, 0, 0, -0.4f, false},
        {-0.4f, 1, -0.21f, 0, 0, -0.4f, true}, {-0.4f, 1, -0.19f, 0, 0, -0.4f, false},
        {-0.4f, 1, 0.49f, 0, 0, 1, false},     {-0.4f, 1, 0.51f, 0, 0, 1, true},
        {-0.4f, 1, 0, 0, 0, 1, false},         {-0.4f, 1, 0.3f, 0, -1, -0.4f, false},
        {-0.4f, 1, -0.3f, 0, 1, 1, true},      {0.5f, 1.5f, 0.99f, 0, 0, 1.5f, false},
        {0.5f, 1.5f, 1.01f, 0, 0, 1.5f, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            const dm_drag_feel feel = {0};
            const float s = (float)sign;
            const dm_joint joint = {.type = DM_JOINT_REVOLUTE,
                                    .lower = sign > 0 ? cases[i].lower : -cases[i].upper,
                                    .upper = sign > 0 ? cases[i].upper : -cases[i].lower};
            const dmi_released_part part = {.joint = &joint,
                                            .feel = &feel,
                                            .value = s * cases[i].value,
                                            .velocity = s * cases[i].velocity,
                                            .side = sign * cases[i].side};
            assert_near(dmi_release_open_end(&part), s * cases[i].end, 0);
            assert_int_equal(dmi_release_is_open(&part), cases[i].open);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hand_says_what_is_meant),
        cmocka_unit_test(a_part_that_rests_open_closes_to_where_it_is_closed),
        cmocka_unit_test(the_open_share_counts_from_closed),
        cmocka_unit_test(detents_begin_where_the_part_is_closed),
        cmocka_unit_test(fast_parts_arrive_sooner),
        cmocka_unit_test(no_release_jumps),
        cmocka_unit_test(a_motion_of_keys_sets_the_pace),
        cmocka_unit_test(the_rate_does_not_matter),
        cmocka_unit_test(veto_stop_and_replay),
        cmocka_unit_test(buttons_spring_back_and_catches_draw),
        cmocka_unit_test(wheels_coast),
        cmocka_unit_test(a_plan_is_minimum_jerk_from_the_speed_that_the_part_has),
        cmocka_unit_test(a_plan_takes_the_time_of_its_way),
        cmocka_unit_test(a_limited_plan_uses_what_it_is_allowed),
        cmocka_unit_test(what_is_there_already_does_not_move),
        cmocka_unit_test(a_glide_decays),
        cmocka_unit_test(a_paced_plan_is_the_part_of_the_keys),
        cmocka_unit_test(keys_suit_a_plan_of_their_size),
        cmocka_unit_test(what_is_meant_has_sharp_edges),
        cmocka_unit_test(a_part_opens_to_the_side_of_the_pull),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
