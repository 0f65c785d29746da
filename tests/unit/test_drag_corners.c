/* Words of a drag that meet: rules with releases, limits with bounds, one hand after another. */
#include "test_rules.h"

#include "drag/part_links.h"

#define FRAME (1.0f / 60)

static const dm_drag_feel plain = {0};
static const dm_joint both_sides = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .lower = -1, .upper = 1.5f};

static dm_drag_rules no_rules(void) {
    return (dm_drag_rules){.struct_size = sizeof(dm_drag_rules)};
}

static dm_drag_state run(dmi_drag* drag, float seconds) {
    dm_drag_state now = {0};
    for (float time = 0; time < seconds; time += FRAME) dmi_drag_update(drag, NULL, FRAME, &now);
    return now;
}

static dm_drag_state hold_at(dmi_drag* drag, float x, float seconds, float lower, float upper) {
    dm_drag_state now = {0};
    const dm_drag_input input = {
        .struct_size = sizeof input, .hand = test_pointer(test_ray_at(x)), .lower = lower, .upper = upper};
    for (float time = 0; time < seconds; time += FRAME) dmi_drag_step(drag, &input, FRAME, &now);
    return now;
}

static void a_fall_ends_where_its_plan_does(void** state) {
    (void)state;
    dm_drag_rules rules = no_rules();
    rules.tip_share = 0.5f, rules.restitution = 0.5f;
    dmi_drag drag;
    test_begin(&drag, &both_sides, 0.3f, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_int_equal(drag.release.intent, DM_INTENT_CLOSE);
    dm_drag_state now = {0};
    for (int i = 0; i < 240; i++) {
        dmi_drag_update(&drag, NULL, FRAME, &now);
        assert_true(now.value >= 0 && !(now.events & DM_EVENT_LIMIT_LOWER)); /* rest is no limit here */
    }
    assert_near(now.value, 0, 1e-6);
    assert_int_equal(now.phase, DM_DRAG_AT_REST);
}

static void a_part_with_one_limit_closes_from_near_by(void** state) {
    (void)state;
    const dm_joint open_ended = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}, .lower = 0, .upper = 1024};
    const dm_drag_rules rules = no_rules();
    const float grab[3] = {1, 0, 0};
    dmi_drag drag;
    dmi_drag_begin(&drag, &open_ended, grab, 0.05f, &plain);
    const dmi_rules kept = dmi_rules_from(&rules, &plain, &open_ended, true, 1);
    dmi_drag_set_rules(&drag, &kept);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
    assert_true(drag.release.duration > 0);
    assert_near(run(&drag, 2).value, 0, 1e-6);
}

static void a_hand_that_is_torn_off_releases_as_one_that_lets_go(void** state) {
    (void)state;
    const dm_drag_feel springs = {.return_time = 0.4f};
    dm_drag_rules rules = no_rules();
    rules.break_distance = 0.3f, rules.close_delay = 0.5f;
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &springs, &rules);
    for (int i = 0; i <= 40; i++) hold_at(&drag, 0.025f * (float)i, FRAME, 0, 0);
    assert_near(hold_at(&drag, 1, 0.5f, 0, 0).value, 1, 1e-3);
    assert_true(hold_at(&drag, 1.5f, FRAME, 0, 0).phase != DM_DRAG_HELD);
    assert_near(run(&drag, 0.3f).value, 1, 1e-3); /* the closer waits … */
    assert_near(run(&drag, 1.5f).value, 0, 1e-6); /* … and closes */
}

static void a_scalar_reaches_limits_through_soft_ends_and_detents(void** state) {
    (void)state;
    static const dm_drag_feel feels[3] = {
        {.soft_limit = 0.2f}, {.detent = 0.3f}, {.soft_limit = 0.05f, .detent = 0.3f}};
    for (int i = 0; i < 3; i++) {
        for (int kind = DM_HAND_RATE; kind <= DM_HAND_VALUE; kind++) {
            const dm_drag_rules rules = no_rules();
            dm_drag_input input = {.struct_size = sizeof input, .hand = {.kind = kind, .amount = 1}};
            dm_drag_state now = {0};
            uint32_t events = 0;
            dmi_drag drag;
            test_begin(&drag, &test_slide, 0, &feels[i], &rules);
            for (int k = 0; k < 180; k++) dmi_drag_step(&drag, &input, FRAME, &now), events |= now.events;
            assert_near(now.value, 1, 1e-4);
            assert_true(now.at_limit == 1 && events & DM_EVENT_LIMIT_UPPER);
        }
    }
}

static void a_pointer_reaches_a_limit_beside_a_catch(void** state) {
    (void)state;
    const float snap = 0.9f;
    dm_drag_rules rules = no_rules();
    rules.snaps = &snap, rules.snap_count = 1, rules.snap_reach = 0.2f;
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &plain, &rules);
    hold_at(&drag, 0, 0.1f, 0, 0);
    assert_near(hold_at(&drag, 2, 2, 0, 0).value, 1, 1e-4);
}

static void a_resting_hand_moves_no_part_with_soft_estimated_ends(void** state) {
    (void)state;
    const dm_drag_feel soft = {.soft_limit = 0.1f};
    const float grab[3] = {1, 0, 0};
    dmi_drag drag;
    dmi_drag_begin(&drag, &test_slide, grab, 1, &soft);
    dmi_drag_track_hypotheses(&drag, &test_slide, NULL, 1, 1, (dmi_limit_give){0, 1});
    const dm_ray ray = test_ray_at(1);
    dm_drag_state now = {0};
    for (int i = 0; i < 60; i++) dmi_drag_update(&drag, &ray, FRAME, &now);
    assert_near(now.value, 1, 1e-5);
    assert_near(drag.joint.upper, 1, 1e-5);
}

static void bounds_move_no_estimated_limit(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const float grab[3] = {0.3f, 0, 0};
    dmi_drag drag;
    dmi_drag_begin(&drag, &test_slide, grab, 0.3f, &plain);
    dmi_drag_track_hypotheses(&drag, &test_slide, NULL, 1, 1, (dmi_limit_give){0, 1});
    const dmi_rules kept = dmi_rules_from(&rules, &plain, &test_slide, false, 1);
    dmi_drag_set_rules(&drag, &kept);
    hold_at(&drag, 0.3f, 1, -INFINITY, -0.4f);
    assert_true(drag.joint.lower == 0 && drag.value >= 0); /* a stop at rest holds against them */
    hold_at(&drag, 0.3f, 1, 2.5f, INFINITY);
    assert_true(drag.joint.upper == 1);
}

static void bounds_without_room_hold(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_drag_input still = {.struct_size = sizeof still,
                                 .flags = DM_INPUT_BOUNDS,
                                 .hand = test_pointer(test_ray_at(0.8f)),
                                 .lower = 0.3f,
                                 .upper = 0.3f};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.3f, &plain, &rules);
    hold_at(&drag, 0.3f, 0.1f, 0, 0);
    for (int i = 0; i < 60; i++) dmi_drag_step(&drag, &still, FRAME, &now);
    assert_near(now.value, 0.3, 1e-6);
    assert_near(hold_at(&drag, 0.8f, 1, 0.3f, 0.3f).value, 0.8, 1e-3); /* without the flag there are none */
}

static void a_part_that_opened_the_short_way_is_open(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    dmi_drag drag;
    test_begin(&drag, &both_sides, -0.9f, &plain, &rules);
    assert_true(dmi_drag_is_open(&drag));
    test_begin(&drag, &both_sides, 0.6f, &plain, &rules);
    assert_false(dmi_drag_is_open(&drag));
    test_begin(&drag, &test_slide, 0.6f, &plain, &rules);
    assert_true(dmi_drag_is_open(&drag));
}

static void only_the_last_update_asks(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_drag_input asks = {
        .struct_size = sizeof asks, .flags = DM_INPUT_ASK, .hand = test_pointer(test_ray_at(0.2f))};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &plain, &rules);
    dmi_drag_step(&drag, &asks, FRAME, &now);
    assert_true(drag.pending.open);
    dmi_drag_update(&drag, &asks.hand.ray, FRAME, &now);
    assert_false(drag.pending.open);
    dmi_drag_step(&drag, &asks, FRAME, &now);
    dmi_drag_release(&drag, DM_INTENT_STAY, 0);
    assert_false(drag.pending.open);
}

static void a_part_held_up_as_it_arrives_goes_on(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_drag_input asks = {.struct_size = sizeof asks, .flags = DM_INPUT_ASK};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.6f, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
    dmi_drag_step(&drag, &asks, 5, &now);
    assert_int_equal(now.phase, DM_DRAG_AT_REST);
    dmi_drag_take(&drag, 0.3f, &now);
    assert_int_equal(now.phase, DM_DRAG_RELEASED);
    assert_false(now.events & (DM_EVENT_LIMIT_LOWER | DM_EVENT_REACHED_REST | DM_EVENT_CLOSED));
    now = run(&drag, 2);
    assert_near(now.value, 0, 1e-6);
    assert_true(now.phase == DM_DRAG_AT_REST && now.velocity == 0);
}

static void a_part_pushed_at_rest_stands_again(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_drag_input pushed = {.struct_size = sizeof pushed, .lower = -1, .upper = 0.5f}, free = {.struct_size = 0};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 1, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_FREEZE, 0);
    for (int i = 0; i < 3; i++) dmi_drag_step(&drag, &pushed, FRAME, &now);
    assert_true(now.value < 1 && now.velocity < 0);
    for (int i = 0; i < 2; i++) dmi_drag_step(&drag, &free, FRAME, &now);
    assert_true(now.velocity == 0);
}

static void a_plan_that_was_held_up_keeps_its_time(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    dm_drag_input held = {.struct_size = sizeof held}, free = held;
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 1, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 5);
    float time = 0;
    for (; time < 10 && (time == 0 || now.phase == DM_DRAG_RELEASED); time += FRAME) {
        held.lower = now.value, held.upper = 2;
        const bool stopped = time > 1 && time < 1.03f;
        dmi_drag_step(&drag, stopped ? &held : &free, FRAME, &now);
    }
    assert_near(time, 5, 0.1);
    assert_near(now.value, 0, 1e-6);
}

static void a_replay_begins_where_the_motion_did(void** state) {
    (void)state;
    dm_drag_rules rules = no_rules();
    rules.max_speed = 1;
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.2f, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_OPEN, 0);
    assert_near(run(&drag, 4).value, 1, 1e-6);
    dmi_drag_release(&drag, DM_INTENT_REPLAY, 0);
    dmi_drag_update(&drag, NULL, FRAME, &now);
    assert_near(now.value, 0.2, 0.02);
    assert_near(run(&drag, 4).value, 1, 1e-6);
}

static void a_stated_duration_is_that_of_the_motion(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.4f, &plain, &rules);
    drag.velocity = 1;
    dmi_drag_release(&drag, DM_INTENT_STAY, 0.5f);
    const float end = drag.release.end;
    float before = 0.4f;
    for (int i = 0; i < 31; i++) {
        dmi_drag_update(&drag, NULL, FRAME, &now);
        assert_true(fabsf(now.value - before) < 0.05f); /* no jump to the end */
        before = now.value;
    }
    assert_near(now.value, end, 1e-6);
    dm_drag_rules falling = no_rules();
    falling.tip_share = 0.5f;
    test_begin(&drag, &test_slide, 0.4f, &plain, &falling);
    dmi_drag_release(&drag, DM_INTENT_AUTO, 3);
    assert_int_equal(run(&drag, 2.8f).phase, DM_DRAG_RELEASED);
    assert_int_equal(run(&drag, 0.3f).phase, DM_DRAG_AT_REST);
}

static void a_snap_value_at_a_limit_catches(void** state) {
    (void)state;
    const float snaps[2] = {0, 1};
    dm_drag_rules rules = no_rules();
    rules.snaps = snaps, rules.snap_count = 2, rules.restitution = 0.5f;
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.9f, &plain, &rules);
    drag.velocity = 2;
    dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
    assert_near(run(&drag, 3).value, 1, 1e-4);
}

static void an_unmoved_driven_part_leaves_its_driver(void** state) {
    (void)state;
    const dmi_link link = {
        .kind = DM_LINK_MOVES, .driver = 0, .driven = 1, .ratio = 1, .from = 0.5f, .both_ways = true};
    const dm_joint joints[2] = {both_sides, both_sides};
    const dmi_linked_joints all = {.first = joints, .stride = sizeof joints[0]};
    float values[2] = {0.2f, 0};
    uint8_t changed[2] = {0};
    dmi_links_follow(&link, 1, all, 1, values, changed);
    assert_true(values[0] == 0.2f && values[1] == 0);
}

static void a_lock_holds_in_the_update_that_tells_it(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_vec3 far = {2, 0, 0}, near = {0.5f, 0, 0};
    const dm_drag_input at = {.struct_size = sizeof at, .hand = {.kind = DM_HAND_POINT, .point = near}},
                        locked = {.struct_size = sizeof locked,
                                  .flags = DM_INPUT_LOCKED,
                                  .hand = {.kind = DM_HAND_POINT, .point = far}};
    const float grab[3] = {0.5f, 0, 0};
    dm_drag_state now = {0};
    dmi_drag drag;
    dmi_drag_begin(&drag, &test_slide, grab, 0.5f, &plain);
    dmi_drag_track_hypotheses(&drag, &test_slide, NULL, 1, 1, (dmi_limit_give){0, 1});
    const dmi_rules kept = dmi_rules_from(&rules, &plain, &test_slide, false, 1);
    dmi_drag_set_rules(&drag, &kept);
    dmi_drag_step(&drag, &at, FRAME, &now);
    dmi_drag_step(&drag, &locked, FRAME, &now);
    assert_true(drag.joint.upper == 1);
}

static void a_pointer_after_a_hand_in_space_holds_where_it_points(void** state) {
    (void)state;
    dm_drag_rules rules = no_rules();
    rules.break_distance = 0.3f;
    const dm_vec3 at = {0, 0, 0};
    const dm_drag_input hand = {.struct_size = sizeof hand, .hand = {.kind = DM_HAND_POINT, .point = at}};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0, &plain, &rules);
    dmi_drag_step(&drag, &hand, FRAME, &now);
    for (int i = 0; i <= 60; i++) {
        const dm_ray ray = test_ray_at(0.01f * (float)i);
        dmi_drag_update(&drag, &ray, FRAME, &now);
        assert_int_equal(now.phase, DM_DRAG_HELD);
    }
    assert_near(now.value, 0.6, 0.02);
}

static void a_joint_that_is_fixed_stays_under_a_scalar(void** state) {
    (void)state;
    const dm_joint fixed = {.type = DM_JOINT_FIXED};
    const dm_drag_rules rules = no_rules();
    const dm_drag_input drive = {.struct_size = sizeof drive, .hand = {.kind = DM_HAND_RATE, .amount = 1}};
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &fixed, 0, &plain, &rules);
    for (int i = 0; i < 60; i++) dmi_drag_step(&drag, &drive, FRAME, &now);
    assert_true(now.value == 0 && now.events == 0);
}

/* Two slides whose first is wrong: the hand goes along the second. */
static void another_joint_begins_inside_the_bounds(void** state) {
    (void)state;
    const dm_joint joints[2] = {{.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .upper = 1, .joint_confidence = 0.5f},
                                {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}, .upper = 1, .joint_confidence = 0.5f}};
    for (int limited = 0; limited < 2; limited++) {
        dm_drag_rules rules = no_rules();
        rules.max_speed = limited ? 0.2f : 0;
        const float grab[3] = {0, 0, 0};
        dm_drag_state now = {0};
        dmi_drag drag;
        dmi_drag_begin(&drag, &joints[0], grab, 0, &plain);
        dmi_drag_track_hypotheses(&drag, joints, NULL, 2, 1, (dmi_limit_give){0, 1});
        const dmi_rules kept = dmi_rules_from(&rules, &plain, &joints[0], false, 1);
        dmi_drag_set_rules(&drag, &kept);
        uint32_t events = 0;
        for (int i = 0; i <= 60; i++) {
            const float before = now.value;
            const dm_drag_input input = {.struct_size = sizeof input,
                                         .hand = test_pointer((dm_ray){{0, 0.015f * (float)i, 5}, {0, 0, -1}}),
                                         .lower = -1,
                                         .upper = limited ? 5 : 0.1f};
            dmi_drag_step(&drag, &input, FRAME, &now);
            events |= now.events;
            if (!limited) assert_true(now.value <= 0.1f + 1e-6f);
            if (limited) assert_true(fabsf(now.value - before) <= 0.2f * FRAME + 1e-5f);
        }
        assert_true(events & DM_EVENT_JOINT && drag.joint.axis.y == 1);
    }
}

/* What a host leaves out has its default, what it states stays. */
/* Pulls a part along x, then round the axis of a hinge, until its joint changes to that one. Returns the update of the
 * change; before: the one before it. */
static dm_drag_state pull_to_a_hinge(dmi_drag* drag, const dm_drag_feel* feel, const dm_drag_rules* rules,
                                     dm_drag_state* before) {
    const dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .upper = 1, .joint_confidence = 0.5f};
    const dm_joint hinge = {.type = DM_JOINT_REVOLUTE,
                            .axis = {0, 0, 1},
                            .origin = {1.2f, 1.6f, 0},
                            .upper = 0.75f,
                            .joint_confidence = 0.5f};
    const dm_joint joints[2] = {slide, hinge};
    const float grab[3] = {0, 0, 0};
    dm_drag_state now = {0};
    dmi_drag_begin(drag, &slide, grab, 0, feel);
    dmi_drag_track_hypotheses(drag, joints, NULL, 2, 1, (dmi_limit_give){0, 1});
    if (rules != NULL) {
        const dmi_rules kept = dmi_rules_from(rules, feel, &slide, false, 1);
        dmi_drag_set_rules(drag, &kept);
    }
    assert_near(drag->speed, 1, 1e-6);
    for (int i = 0; i <= 10; i++) {
        const float turn = 0.01f * (float)i, c = cosf(turn), s = sinf(turn);
        const dm_ray along = {{turn, 0, 5}, {0, 0, -1}},
                     round = {{1.2f - 1.2f * c + 1.6f * s, 1.6f - 1.6f * c - 1.2f * s, 5}, {0, 0, -1}};
        *before = now;
        dmi_drag_update(drag, i < 10 ? &along : &round, FRAME, &now);
    }
    assert_true(before->changes == 0 && now.changes == 1);
    return now;
}

/* No speed of the old joint goes on along the new one; value, limits and what the grabbed point does for a unit of the
 * value are those of the new one. */
static void another_joint_begins_at_a_standstill(void** state) {
    (void)state;
    const dm_drag_feel heavy = {.smoothing_time = 0.05f, .coast_time = 0.3f};
    dmi_drag drag;
    dm_drag_state before;
    const dm_drag_state now = pull_to_a_hinge(&drag, &heavy, NULL, &before);
    assert_true(before.velocity > 0.1f);
    assert_near(now.velocity, 0, 1e-6);
    assert_near(now.target, 0.1, 1e-3);
    assert_near(now.value, now.target, 1e-6);
    assert_near(drag.speed, 2, 1e-5);
    assert_true(drag.limits_are_estimates && drag.estimated_upper == 0.75f);
}

/* Rules that limit the speed take the part on from where it is shown, at a standstill too. */
static void another_joint_begins_where_the_part_is_shown(void** state) {
    (void)state;
    const dm_drag_feel light = {.smoothing_time = -1};
    dm_drag_rules rules = no_rules();
    rules.max_speed = 0.3f, rules.max_acceleration = 6;
    dmi_drag drag;
    dm_drag_state before;
    const dm_drag_state now = pull_to_a_hinge(&drag, &light, &rules, &before);
    const float shown = dmi_joint_project(&drag.joint, &before.pose, 0);
    assert_true(before.value > shown + 0.03f); /* as another value of another joint */
    assert_near(now.value, shown, 6 * FRAME * FRAME);
    assert_near(drag.asked, 0.1, 1e-3);
    assert_true(now.target < 0.2f * drag.asked); /* comes up with the hand from there */
    assert_true(fabsf(now.velocity) <= 6 * FRAME + 1e-6f);
}

/* A part that its bounds hold at most 1/10000 of the range before its end has arrived; farther off it waits. */
static void a_part_held_short_of_its_end_waits(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const struct {
        float short_of; /* of the range */
        int32_t phase;
    } cases[] = {{0.9e-4f, DM_DRAG_AT_REST}, {1.1e-4f, DM_DRAG_RELEASED}, {0.2f, DM_DRAG_RELEASED}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (float range = 1; range <= 4; range += 3) {
            const dm_joint joint = {.type = DM_JOINT_PRISMATIC, .axis = {1, 0, 0}, .upper = range};
            const float end = range * cases[i].short_of;
            const dm_drag_input held = {.struct_size = sizeof held, .lower = end, .upper = 2 * range};
            dm_drag_state now = {0};
            dmi_drag drag;
            test_begin(&drag, &joint, range, &plain, &rules);
            dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
            for (int k = 0; k < 120; k++) dmi_drag_step(&drag, &held, FRAME, &now);
            assert_near(now.value, end, 1e-7);
            assert_int_equal(now.phase, cases[i].phase);
            if (now.phase != DM_DRAG_RELEASED) continue;
            assert_near(run(&drag, 2).value, 0, 1e-7); /* and goes on once it may */
        }
    }
}

/* A part that was held up for long plans the rest as if it were released there: no faster than it would go then. */
static void a_plan_held_up_for_long_begins_anew(void** state) {
    (void)state;
    const dm_drag_rules rules = no_rules();
    const dm_drag_input held = {.struct_size = sizeof held, .lower = 0.5f, .upper = 2};
    dm_drag_state now = {0}, alone = {0};
    dmi_drag drag, other;
    test_begin(&drag, &test_slide, 1, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 1);
    for (int k = 0; k < 180; k++) dmi_drag_step(&drag, &held, FRAME, &now);
    assert_near(now.value, 0.5, 1e-6);
    test_begin(&other, &test_slide, 0.5f, &plain, &rules);
    dmi_drag_release(&other, DM_INTENT_CLOSE, 0);
    for (int k = 0; k < 60; k++) {
        dmi_drag_update(&drag, NULL, FRAME, &now);
        dmi_drag_update(&other, NULL, FRAME, &alone);
        assert_near(now.value, alone.value, 1e-6);
    }
    assert_near(now.value, 0, 1e-6);
}

static void rules_have_their_defaults(void** state) {
    (void)state;
    const dm_joint hinge = {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 3};
    const float snap = 0.5f;
    dm_drag_rules given = no_rules();
    given.snaps = &snap, given.snap_count = 1;
    dmi_rules rules = dmi_rules_from(&given, &plain, &hinge, false, 5);
    assert_true(rules.on && rules.snaps.count == 1 && rules.snaps.values[0] == 0.5f);
    assert_near(rules.open_share, 0.1f, 0);
    assert_near(rules.closed_share, 0.02f, 0);
    assert_near(rules.lock_give, 0.01f, 0);
    assert_near(rules.latch_turn, 0.785f, 0);
    assert_near(rules.auto_close_time, 0.25f, 0);
    assert_near(rules.fall_time, 0.7f, 0);
    assert_near(rules.drive_speed, 1, 0);
    assert_near(rules.snaps.outer_reach, 0.2f, 1e-6);
    assert_near(rules.snaps.pull, 0.7f, 0);
    given.open_share = 0.3f, given.closed_share = 0.03f, given.lock_give = -1, given.latch_turn = 0.2f;
    given.auto_close_time = 0.6f, given.fall_time = 2, given.drive_speed = 0.5f, given.snap_reach = 0.4f;
    rules = dmi_rules_from(&given, &plain, &hinge, false, 5);
    assert_true(rules.open_share == 0.3f && rules.closed_share == 0.03f && rules.lock_give == 0);
    assert_true(rules.latch_turn == 0.2f && rules.auto_close_time == 0.6f && rules.fall_time == 2);
    assert_true(rules.drive_speed == 0.5f && rules.snaps.outer_reach == 0.4f);
}

/* The range of a part; where a limit is missing, a radian or the object's size. Shares are from rest, or the limit next
 * to it. */
static void shares_are_of_the_range(void** state) {
    (void)state;
    const dm_joint hinge = {.type = DM_JOINT_REVOLUTE, .lower = -1, .upper = 3}, wheel = {.type = DM_JOINT_CONTINUOUS},
                   slide = {.type = DM_JOINT_PRISMATIC, .lower = 0.5f, .upper = 1}, free = {.type = DM_JOINT_PRISMATIC};
    const dm_joint* joints[4] = {&hinge, &wheel, &slide, &free};
    const float ranges[2][4] = {{4, 1, 0.5f, 5}, {1, 1, 5, 5}};
    for (int one_sided = 0; one_sided < 2; one_sided++) {
        for (int i = 0; i < 4; i++) {
            const dm_drag_rules given = no_rules();
            const dmi_rules rules = dmi_rules_from(&given, &plain, joints[i], one_sided, 5);
            const float rest = i == 2 ? 0.5f : 0, range = ranges[one_sided][i];
            assert_near(dmi_rules_range(&rules, joints[i]), range, 0);
            assert_near(dmi_rules_share(&rules, joints[i], rest + 0.25f), 0.25f / range, 1e-6);
            assert_near(dmi_rules_share(&rules, joints[i], rest - 0.25f), 0.25f / range, 1e-6);
        }
    }
}

/* A limit counts as met within 1/10000 of the range. */
static void a_limit_is_met_within_its_tolerance(void** state) {
    (void)state;
    const dm_joint wheel = {.type = DM_JOINT_CONTINUOUS};
    const float grab[3] = {0, 0, 0};
    const struct {
        float value;
        int32_t limit;
    } cases[] = {{-1, -1}, {-0.99976f, -1}, {-0.99974f, 0}, {0, 0}, {1.49974f, 0}, {1.49976f, 1}, {1.5f, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dmi_drag drag;
        dm_drag_state now;
        dmi_drag_begin(&drag, &both_sides, grab, cases[i].value, &plain);
        dmi_drag_get_state(&drag, &now);
        assert_int_equal(now.at_limit, cases[i].limit);
        dmi_drag_begin(&drag, &wheel, grab, cases[i].value, &plain);
        dmi_drag_get_state(&drag, &now);
        assert_int_equal(now.at_limit, 0);
    }
}

static int32_t intent_of(const dm_drag_rules* given, const dm_drag_feel* feel, bool one_sided, float value,
                         float velocity) {
    const dmi_rules rules = dmi_rules_from(given, feel, &test_slide, one_sided, 1);
    const dmi_released_part part = {
        .joint = &test_slide, .feel = feel, .rules = &rules, .value = value, .velocity = velocity};
    return dmi_released_intent(&part, feel->return_time);
}

/* In this order: a closer, a zone that closes by itself, a snap value in reach, a fall, a limit that throws back. */
static void rules_say_what_a_release_means(void** state) {
    (void)state;
    const dm_drag_feel spring = {.return_time = 1}, catches = {.detent = 0.25f};
    dm_drag_rules rules = no_rules();
    assert_int_equal(intent_of(&rules, &spring, false, 0.5f, 0), DM_INTENT_CLOSE);
    assert_int_equal(intent_of(&rules, &catches, false, 0.9f, 0), DM_INTENT_STAY);
    assert_int_equal(intent_of(&rules, &plain, false, 0.9f, 0), DM_INTENT_OPEN);
    assert_int_equal(intent_of(&rules, &plain, true, 0.9f, 0), DM_INTENT_STAY);
    rules.close_delay = 1;
    assert_int_equal(intent_of(&rules, &spring, false, 0.5f, 0), DM_INTENT_STAY);
    assert_int_equal(intent_of(&rules, &plain, false, 0.9f, 0), DM_INTENT_OPEN);
    rules = no_rules();
    rules.auto_close_share = 0.3f;
    assert_int_equal(intent_of(&rules, &plain, false, 0.29f, 0), DM_INTENT_CLOSE);
    assert_int_equal(intent_of(&rules, &plain, false, 0.31f, 0), DM_INTENT_STAY);
    const float snaps[2] = {0.2f, 0.6f};
    rules.snaps = snaps, rules.snap_count = 2, rules.snap_reach = 0.1f;
    assert_int_equal(intent_of(&rules, &plain, false, 0.2f, 0), DM_INTENT_CLOSE); /* the zone comes first */
    rules.auto_close_share = 0, rules.tip_share = 0.5f;
    assert_int_equal(intent_of(&rules, &plain, false, 0.69f, 0), DM_INTENT_STAY);
    assert_int_equal(intent_of(&rules, &plain, false, 0.71f, 0), DM_INTENT_OPEN);
    assert_int_equal(intent_of(&rules, &plain, false, 0.72f, -1), DM_INTENT_STAY); /* glides by 0.14 into its reach */
    assert_int_equal(intent_of(&rules, &plain, false, 0.45f, 0), DM_INTENT_CLOSE);
    rules.snap_count = 0;
    assert_int_equal(intent_of(&rules, &plain, false, 0.499f, 0), DM_INTENT_CLOSE);
    assert_int_equal(intent_of(&rules, &plain, false, 0.5f, 0), DM_INTENT_OPEN);
    assert_int_equal(intent_of(&rules, &plain, true, 0.6f, 0), DM_INTENT_STAY); /* nothing to fall to */
    rules.tip_share = 0, rules.restitution = 0.5f;
    assert_int_equal(intent_of(&rules, &plain, false, 0.8f, 1.38f), DM_INTENT_OPEN); /* 0.199 to go */
    assert_int_equal(intent_of(&rules, &plain, false, 0.8f, 1.4f), DM_INTENT_STAY);  /* 0.202: thrown back */
    assert_int_equal(intent_of(&rules, &plain, false, 0.2f, -1.4f), DM_INTENT_STAY);
    rules.restitution = 0;
    assert_int_equal(intent_of(&rules, &plain, false, 0.2f, -1.4f), DM_INTENT_CLOSE);
}

/* A part that begins outside its limits is shown there, and comes in. */
static void what_begins_outside_its_limits_comes_in(void** state) {
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        const float start = side > 0 ? 1.2f : -0.2f, end = side > 0 ? 1 : 0, grab[3] = {start, 0, 0};
        dmi_drag drag;
        dm_drag_state now = {0};
        dmi_drag_begin(&drag, &test_slide, grab, start, &plain);
        dmi_drag_get_state(&drag, &now);
        assert_near(now.value, end, 0);
        assert_near(now.target, end, 0);
        assert_near(now.grab_point.x, start, 1e-6);
        dmi_drag_update(&drag, NULL, 0.05f, &now);
        assert_near(now.grab_point.x, 0.5 * (double)(start + end), 1e-5); /* half-way after half the least time */
        dmi_drag_update(&drag, NULL, 0.05f, &now);
        assert_near(now.grab_point.x, end, 1e-6);
    }
}

/* Time that is none, or goes backwards, moves no released part. */
static void time_that_is_none_moves_nothing(void** state) {
    (void)state;
    const float times[] = {0, -0.1f, -1e30f, NAN, INFINITY, -INFINITY};
    dm_drag_state now = {0};
    dmi_drag drag;
    const dm_drag_rules rules = no_rules();
    test_begin(&drag, &test_slide, 0.9f, &plain, &rules);
    dmi_drag_release(&drag, DM_INTENT_CLOSE, 0);
    dmi_drag_update(&drag, NULL, 0.2f, &now);
    const float value = now.value, velocity = now.velocity, elapsed = drag.release.elapsed;
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        dmi_drag_update(&drag, NULL, times[i], &now);
        assert_near(now.value, value, 0);
        assert_near(now.velocity, velocity, 0);
        assert_near(drag.release.elapsed, elapsed, 0);
    }
}

/* A closer's delay begins anew with each release. */
static void a_second_release_waits_anew(void** state) {
    (void)state;
    const dm_drag_feel springs = {.return_time = 0.25f};
    dm_drag_rules rules = no_rules();
    rules.close_delay = 0.5f;
    dm_drag_state now = {0};
    dmi_drag drag;
    test_begin(&drag, &test_slide, 0.8f, &springs, &rules);
    for (int round = 0; round < 2; round++) {
        dmi_drag_release(&drag, DM_INTENT_AUTO, 0);
        for (int k = 0; k < 3; k++) dmi_drag_update(&drag, NULL, 0.125f, &now);
        assert_near(now.value, 0.8f, 0);
    }
    dmi_drag_update(&drag, NULL, 0.125f, &now); /* over: the closer begins, and goes half-way in half its time */
    assert_near(now.value, 0.8f, 0);
    dmi_drag_update(&drag, NULL, 0.125f, &now);
    assert_near(now.value, 0.4, 1e-5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fall_ends_where_its_plan_does),
        cmocka_unit_test(a_part_with_one_limit_closes_from_near_by),
        cmocka_unit_test(a_hand_that_is_torn_off_releases_as_one_that_lets_go),
        cmocka_unit_test(a_scalar_reaches_limits_through_soft_ends_and_detents),
        cmocka_unit_test(a_pointer_reaches_a_limit_beside_a_catch),
        cmocka_unit_test(a_resting_hand_moves_no_part_with_soft_estimated_ends),
        cmocka_unit_test(bounds_move_no_estimated_limit),
        cmocka_unit_test(bounds_without_room_hold),
        cmocka_unit_test(a_part_that_opened_the_short_way_is_open),
        cmocka_unit_test(only_the_last_update_asks),
        cmocka_unit_test(a_part_held_up_as_it_arrives_goes_on),
        cmocka_unit_test(a_part_pushed_at_rest_stands_again),
        cmocka_unit_test(a_plan_that_was_held_up_keeps_its_time),
        cmocka_unit_test(a_replay_begins_where_the_motion_did),
        cmocka_unit_test(a_stated_duration_is_that_of_the_motion),
        cmocka_unit_test(a_snap_value_at_a_limit_catches),
        cmocka_unit_test(an_unmoved_driven_part_leaves_its_driver),
        cmocka_unit_test(a_lock_holds_in_the_update_that_tells_it),
        cmocka_unit_test(a_pointer_after_a_hand_in_space_holds_where_it_points),
        cmocka_unit_test(a_joint_that_is_fixed_stays_under_a_scalar),
        cmocka_unit_test(another_joint_begins_inside_the_bounds),
        cmocka_unit_test(another_joint_begins_at_a_standstill),
        cmocka_unit_test(another_joint_begins_where_the_part_is_shown),
        cmocka_unit_test(a_part_held_short_of_its_end_waits),
        cmocka_unit_test(a_plan_held_up_for_long_begins_anew),
        cmocka_unit_test(rules_have_their_defaults),
        cmocka_unit_test(shares_are_of_the_range),
        cmocka_unit_test(a_limit_is_met_within_its_tolerance),
        cmocka_unit_test(rules_say_what_a_release_means),
        cmocka_unit_test(what_begins_outside_its_limits_comes_in),
        cmocka_unit_test(time_that_is_none_moves_nothing),
        cmocka_unit_test(a_second_release_waits_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
