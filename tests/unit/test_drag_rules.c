/* Rules, events and inputs of a drag through the public functions: bad ones, snapshots, callers of other sizes. */
#include "test_world.h"

#include <math.h>

typedef struct hinged {
    test_world w;
    dm_object object;
} hinged;

/* A cabinet whose door has the host's hinge, 0 to 1.5 rad. */
static void open_hinged(hinged* h) {
    test_world_init(&h->w);
    test_world_open(&h->w);
    h->object = test_world_cabinet(&h->w);
    const dm_joint hinge = test_hinge();
    assert_int_equal(dm_object_set_joint(h->w.context, h->object, TEST_DOOR, &hinge), DM_OK);
}

static dm_drag_desc door_of(const hinged* h, const dm_drag_rules* rules) {
    return (dm_drag_desc){.struct_size = sizeof(dm_drag_desc),
                          .part_id = TEST_DOOR,
                          .object = h->object,
                          .grab_point = test_pull().point,
                          .rules = rules};
}

static dm_drag begin(const hinged* h, const dm_drag_rules* rules) {
    const dm_drag_desc desc = door_of(h, rules);
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(h->w.context, &desc, &drag), DM_OK);
    return drag;
}

static dm_drag_input pointer_at(float value) {
    const dm_joint hinge = test_hinge();
    dm_drag_input input = dm_drag_input_default();
    input.hand.kind = DM_HAND_RAY;
    input.hand.ray = test_ray_to(test_point_on(&hinge, value));
    return input;
}

/* The way of a hand: out to 1.5 rad in two thirds of a second, a rest there, and back. */
static float way(int frame) {
    return frame < 60 ? fminf(0.0375f * (float)frame, 1.5f) : fmaxf(1.5f - 0.025f * (float)(frame - 60), 0);
}

static void a_door_tells_what_happens(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    const dm_drag_rules rules = dm_drag_rules_default();
    const dm_drag with = begin(&h, &rules), without = begin(&h, NULL);
    uint32_t all = 0;
    for (int k = 0; k < 150; k++) {
        dm_drag_state now = dm_drag_state_default(), plain = dm_drag_state_default();
        const dm_drag_input input = pointer_at(way(k));
        assert_int_equal(dm_drag_step(h.w.context, with, &input, 1.0f / 60, &now), DM_OK);
        assert_int_equal(dm_drag_update(h.w.context, without, &input.hand.ray, 1.0f / 60, &plain), DM_OK);
        assert_memory_equal(&now.pose, &plain.pose, sizeof now.pose); /* rules of zeros hold nothing back */
        assert_true(plain.events == 0 && plain.detents == 0 && plain.impact == 0);
        all |= now.events;
    }
    assert_int_equal(all, DM_EVENT_LEFT_REST | DM_EVENT_OPENED | DM_EVENT_LIMIT_UPPER | DM_EVENT_CLOSED |
                              DM_EVENT_LIMIT_LOWER | DM_EVENT_REACHED_REST);
    test_world_close(&h.w);
}

static void a_restored_drag_tells_the_same(void** state) {
    (void)state;
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    hinged h;
    open_hinged(&h);
    const float snaps[2] = {0.4f, 1.1f};
    dm_drag_rules rules = dm_drag_rules_default();
    rules.snaps = snaps, rules.snap_count = 2, rules.max_speed = 1, rules.max_acceleration = 8;
    rules.flags = DM_RULE_LATCH, rules.break_distance = 50, rules.restitution = 0.5f;
    const dm_drag drag = begin(&h, &rules), other = begin(&h, NULL);
    dm_drag_state first[150], now = dm_drag_state_default();
    for (int k = 0; k < 150; k++) {
        dm_drag_input input = pointer_at(way(k));
        input.lower = -1, input.upper = 1.3f, input.handles[0] = k > 20 ? 1.0f : 0.0f;
        input.second = (dm_hand){.kind = k > 30 && k < 80 ? DM_HAND_POINT : DM_HAND_NONE};
        first[k] = dm_drag_state_default();
        if (k == 50) assert_int_equal(dm_drag_save(h.w.context, drag, saved, sizeof saved), DM_OK);
        assert_int_equal(dm_drag_step(h.w.context, drag, &input, 1.0f / 60, &first[k]), DM_OK);
    }
    /* The snapshot holds the rules too: a drag of the same part that began without them takes them over. */
    assert_int_equal(dm_drag_restore(h.w.context, other, saved, sizeof saved), DM_OK);
    for (int k = 50; k < 150; k++) {
        dm_drag_input input = pointer_at(way(k));
        input.lower = -1, input.upper = 1.3f, input.handles[0] = k > 20 ? 1.0f : 0.0f;
        input.second = (dm_hand){.kind = k > 30 && k < 80 ? DM_HAND_POINT : DM_HAND_NONE};
        assert_int_equal(dm_drag_step(h.w.context, other, &input, 1.0f / 60, &now), DM_OK);
        assert_memory_equal(&now, &first[k], sizeof now);
    }
    test_world_close(&h.w);
}

static dm_part_state state_of(const hinged* h, dm_drag drag) {
    dm_part_state state = dm_part_state_default();
    assert_int_equal(dm_drag_get_part_state(h->w.context, drag, &state), DM_OK);
    return state;
}

/* Pulls a door to 1.2 rad within a second. Returns the last state, which is also that of the part. */
static dm_drag_state pull_out(const hinged* h, dm_drag drag, float handle, uint32_t flags, float upper) {
    dm_drag_state now = dm_drag_state_default();
    for (int k = 0; k < 60; k++) {
        dm_drag_input input = pointer_at(0.02f * (float)k);
        input.handles[0] = handle, input.flags = flags, input.lower = -1, input.upper = upper;
        assert_int_equal(dm_drag_step(h->w.context, drag, &input, 1.0f / 60, &now), DM_OK);
    }
    const dm_part_state part = state_of(h, drag);
    assert_true(part.status == now.status && part.velocity == now.velocity && part.value == now.value);
    return now;
}

static void a_door_tells_what_holds_it(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    dm_drag_rules rules = dm_drag_rules_default();
    rules.flags = DM_RULE_LATCH;
    const dm_drag drag = begin(&h, &rules);
    assert_int_equal(state_of(&h, drag).status, DM_STATUS_LATCHED);
    assert_int_equal(pull_out(&h, drag, 0, 0, 9).status, DM_STATUS_LATCHED);
    assert_int_equal(pull_out(&h, drag, 0, DM_INPUT_LOCKED, 9).status, DM_STATUS_LATCHED | DM_STATUS_LOCKED);
    const dm_drag_state open = pull_out(&h, drag, 1, 0, 9);
    assert_int_equal(open.status, DM_STATUS_OPEN);
    assert_true(open.velocity > 0.5f);
    assert_int_equal(pull_out(&h, drag, 1, 0, 0.8f).status, DM_STATUS_OPEN | DM_STATUS_BLOCKED);
    rules.flags = DM_RULE_LOCKED;
    assert_int_equal(state_of(&h, begin(&h, &rules)).status, DM_STATUS_LOCKED);
    const dm_drag plain = begin(&h, NULL);
    dm_drag_state now = dm_drag_state_default();
    const dm_drag_input input = pointer_at(1);
    assert_int_equal(dm_drag_step(h.w.context, plain, &input, 1, &now), DM_OK);
    assert_true(now.value > 0.9f && now.status == 0);
    test_world_close(&h.w);
}

/* Runs a drag without a hand for a second, with a handle at a value. */
static dm_drag_state wait(const hinged* h, dm_drag drag, float handle) {
    dm_drag_input input = dm_drag_input_default();
    dm_drag_state now = dm_drag_state_default();
    input.handles[0] = handle;
    for (int k = 0; k < 60; k++) assert_int_equal(dm_drag_step(h->w.context, drag, &input, 1.0f / 60, &now), DM_OK);
    return now;
}

/* Open, close and toggle without a pointer or a point, through a latch. */
static void a_door_is_moved_without_a_pointer(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    dm_drag_rules rules = dm_drag_rules_default();
    rules.flags = DM_RULE_LATCH;
    dm_drag_desc desc = door_of(&h, &rules);
    desc.grab_point = (dm_vec3){0, 0, 0};
    desc.flags = DM_DRAG_WITHOUT_POINT;
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(h.w.context, &desc, &drag), DM_OK);
    assert_true(h.w.messages.text[0] == 0 || !strstr(h.w.messages.text, "grab_point"));
    dm_release_desc wish = dm_release_desc_default();
    dm_release_plan plan = dm_release_plan_default();
    wish.intent = DM_INTENT_TOGGLE, wish.flags = DM_RELEASE_BY_RULE;
    assert_int_equal(dm_drag_release(h.w.context, drag, &wish, &plan), DM_OK);
    assert_true(plan.intent == DM_INTENT_OPEN && plan.end_value == 1.5f);
    assert_true(wait(&h, drag, 0).value < 0.01f); /* the latch holds it */
    assert_true(wait(&h, drag, 1).value > 1.4f);
    assert_true(wait(&h, drag, 0).value == 1.5f);
    assert_int_equal(dm_drag_release(h.w.context, drag, &wish, &plan), DM_OK);
    assert_int_equal(plan.intent, DM_INTENT_CLOSE);
    assert_true(fabsf(wait(&h, drag, 0).value) < 1e-4f);
    test_world_close(&h.w);
}

/* A door that opens to both sides goes to the side where the player is not. */
static void a_door_opens_away_from_the_player(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    dm_joint both = test_hinge();
    both.lower = -1.5f;
    assert_int_equal(dm_object_set_joint(h.w.context, h.object, TEST_DOOR, &both), DM_OK);
    const dm_vec3 open = test_point_on(&both, 1.5f), other = test_point_on(&both, -1.5f);
    for (int side = 0; side < 2; side++) {
        const dm_drag drag = begin(&h, NULL);
        dm_release_desc wish = dm_release_desc_default();
        dm_release_plan plan = dm_release_plan_default();
        wish.intent = DM_INTENT_OPEN, wish.flags = DM_RELEASE_BY_RULE | DM_RELEASE_AWAY_FROM;
        wish.away_from = side ? open : other;
        assert_int_equal(dm_drag_release(h.w.context, drag, &wish, &plan), DM_OK);
        assert_true(plan.end_value == (side ? -1.5f : 1.5f));
    }
    test_world_close(&h.w);
}

static void assert_error(const test_world* w, dm_result result, dm_result expected, const char* text) {
    assert_int_equal(result, expected);
    if (!strstr(w->messages.text, text)) fail_msg("'%s' does not say '%s'", w->messages.text, text);
}

static void rules_that_make_no_sense_are_refused(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    const float falling[2] = {1, 0.5f}, nan[1] = {NAN}, good[1] = {1};
    const struct {
        dm_drag_rules rules;
        float detent;
        dm_result result;
        const char* text;
    } cases[] = {
        {{.snap_count = 2}, 0, DM_ERROR_INVALID_ARGUMENT, "snap_count is 2"},
        {{.snap_count = 17, .snaps = falling}, 0, DM_ERROR_INVALID_ARGUMENT, "snap_count is 17"},
        {{.snap_count = 2, .snaps = falling}, 0, DM_ERROR_INVALID_ARGUMENT, "snaps[1] is 0.5"},
        {{.snap_count = 1, .snaps = nan}, 0, DM_ERROR_NOT_FINITE, "snaps"},
        {{.snap_count = 1, .snaps = good}, 0.5f, DM_ERROR_INVALID_ARGUMENT, "one or the other"},
        {{.open_share = 2}, 0, DM_ERROR_INVALID_ARGUMENT, "open_share is 2"},
        {{.open_share = 0.3f, .closed_share = 0.4f}, 0, DM_ERROR_INVALID_ARGUMENT, "less than open_share"},
        {{.max_speed = -1}, 0, DM_ERROR_INVALID_ARGUMENT, "max_speed is -1"},
        {{.max_acceleration = INFINITY}, 0, DM_ERROR_NOT_FINITE, "max_acceleration"},
        {{.event_time = NAN}, 0, DM_ERROR_NOT_FINITE, "event_time"},
        {{.flags = 4}, 0, DM_ERROR_INVALID_ARGUMENT, "flags is 0x4"},
        {{.reserved = 1}, 0, DM_ERROR_INVALID_ARGUMENT, "reserved 1"},
        {{.restitution = 1.5f}, 0, DM_ERROR_INVALID_ARGUMENT, "restitution is 1.5"},
        {{.lock_give = 2}, 0, DM_ERROR_INVALID_ARGUMENT, "lock_give is 2"},
        {{.lock_give = NAN}, 0, DM_ERROR_NOT_FINITE, "lock_give"},
        {{.tip_share = -1}, 0, DM_ERROR_INVALID_ARGUMENT, "tip_share is -1"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dm_drag_rules rules = cases[i].rules;
        rules.struct_size = sizeof rules;
        dm_drag_desc desc = door_of(&h, &rules);
        desc.feel.detent = cases[i].detent;
        dm_drag drag = 0;
        assert_error(&h.w, dm_drag_begin(h.w.context, &desc, &drag), cases[i].result, cases[i].text);
    }
    dm_drag_rules rules = {.struct_size = 4};
    dm_drag_desc desc = door_of(&h, &rules);
    dm_drag drag = 0;
    assert_error(&h.w, dm_drag_begin(h.w.context, &desc, &drag), DM_ERROR_STRUCT_SIZE, "desc.rules.struct_size");
    test_world_close(&h.w);
}

static void inputs_that_make_no_sense_are_refused(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    const dm_drag_rules rules = dm_drag_rules_default();
    const dm_drag with = begin(&h, &rules), without = begin(&h, NULL);
    dm_drag_state now = dm_drag_state_default();
    dm_drag_input input = pointer_at(0);
    assert_int_equal(dm_drag_step(h.w.context, with, NULL, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_step(h.w.context, with, &input, -1, &now), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    input.hand.kind = 77;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input = pointer_at(0);
    input.hand.ray.direction = (dm_vec3){0, 0, 0};
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input = pointer_at(0);
    input.lower = 1;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input.upper = NAN;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_NOT_FINITE);
    input.upper = INFINITY;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_OK);
    assert_int_equal(dm_drag_step(h.w.context, without, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input = pointer_at(0);
    input.handles[1] = 1;
    assert_int_equal(dm_drag_step(h.w.context, without, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input.handles[1] = NAN;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_NOT_FINITE);
    input = pointer_at(0);
    input.flags = 8;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input = pointer_at(0);
    input.second.kind = DM_HAND_RATE;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input.second.kind = DM_HAND_POINT, input.hand.kind = DM_HAND_STEP;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input.second.kind = DM_HAND_NONE, input.hand.amount = INFINITY;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_NOT_FINITE);
    input.hand.kind = DM_HAND_POINT, input.hand.point.y = 2e9f;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_take(h.w.context, with, 0.5f, &now), DM_ERROR_INVALID_ARGUMENT);
    input = pointer_at(0);
    input.flags = DM_INPUT_ASK;
    assert_int_equal(dm_drag_step(h.w.context, without, &input, 0.1f, &now), DM_OK);
    assert_int_equal(dm_drag_take(h.w.context, without, NAN, &now), DM_ERROR_NOT_FINITE);
    assert_int_equal(dm_drag_take(h.w.context, without, 0, &now), DM_OK);
    assert_int_equal(dm_drag_take(h.w.context, without, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    input = dm_drag_input_default(); /* no hand: it stays */
    assert_int_equal(dm_drag_step(h.w.context, without, &input, 0.1f, &now), DM_OK);
    assert_true(now.value == 0);
    assert_int_equal(dm_drag_end(h.w.context, with, NULL), DM_OK);
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_STALE_HANDLE);
    test_world_close(&h.w);
}

/* A caller that knows the state without events gets what it knows; one whose desc ends before `rules` has none. */
static void older_callers_are_served(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    const dm_drag_rules rules = dm_drag_rules_default();
    dm_drag_desc desc = door_of(&h, &rules);
    desc.struct_size = offsetof(dm_drag_desc, rules);
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(h.w.context, &desc, &drag), DM_OK);
    dm_drag_state now = dm_drag_state_default();
    now.events = 77;
    now.struct_size = offsetof(dm_drag_state, events);
    for (int k = 0; k < 40; k++) {
        const dm_drag_input input = pointer_at(way(k));
        assert_int_equal(dm_drag_step(h.w.context, drag, &input, 1.0f / 60, &now), DM_OK);
    }
    assert_int_equal(now.events, 77);
    test_world_close(&h.w);
}

static void links_move_parts_of_an_object(void** state) {
    (void)state;
    hinged h;
    open_hinged(&h);
    float values[2] = {1, 0};
    uint8_t held[2] = {7, 7};
    dm_link links[2] = {{.driver = TEST_DOOR, .driven = TEST_HANDLE, .ratio = 0.5f},
                        {.driver = TEST_HANDLE, .driven = TEST_DOOR, .kind = DM_LINK_FREES, .from = 0.6f}};
    const dm_joint turn = test_hinge();
    assert_int_equal(dm_object_set_joint(h.w.context, h.object, TEST_HANDLE, &turn), DM_OK);
    assert_int_equal(dm_object_set_links(h.w.context, h.object, links, 2), DM_OK);
    dm_part_info part = dm_part_info_default();
    assert_int_equal(dm_object_get_part(h.w.context, h.object, 0, &part), DM_OK);
    const uint32_t door = part.id == TEST_DOOR ? 0 : 1;
    values[door] = 1, values[1 - door] = 0;
    assert_int_equal(dm_object_follow_links(h.w.context, h.object, TEST_DOOR, values, held, 2), DM_OK);
    assert_true(values[1 - door] == 0.5f && values[door] == 1 && held[door] == 1 && held[1 - door] == 0);
    assert_int_equal(dm_object_follow_links(h.w.context, h.object, TEST_DOOR, values, NULL, 3),
                     DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_object_follow_links(h.w.context, h.object, 99, values, NULL, 2), DM_ERROR_NOT_FOUND);
    links[1].kind = DM_LINK_MOVES;
    assert_error(&h.w, dm_object_set_links(h.w.context, h.object, links, 2), DM_ERROR_INVALID_ARGUMENT, "itself");
    links[1] = (dm_link){.driver = TEST_DOOR, .driven = 99};
    assert_error(&h.w, dm_object_set_links(h.w.context, h.object, links, 2), DM_ERROR_NOT_FOUND, "99");
    links[1] = (dm_link){.driver = TEST_DOOR, .driven = TEST_HANDLE, .kind = DM_LINK_HOLDS, .flags = DM_LINK_BOTH_WAYS};
    assert_error(&h.w, dm_object_set_links(h.w.context, h.object, links, 2), DM_ERROR_INVALID_ARGUMENT, "flags is 0x1");
    links[1].flags = 0, links[1].from = NAN;
    assert_error(&h.w, dm_object_set_links(h.w.context, h.object, links, 2), DM_ERROR_NOT_FINITE, "from");
    h.w.memory.fail_at = h.w.memory.calls; /* what was refused left the links of before */
    assert_int_equal(dm_object_set_links(h.w.context, h.object, links, 1), DM_ERROR_OUT_OF_MEMORY);
    h.w.memory.fail_at = TEST_NEVER;
    values[door] = 0.4f;
    assert_int_equal(dm_object_follow_links(h.w.context, h.object, TEST_DOOR, values, NULL, 2), DM_OK);
    assert_true(values[1 - door] == 0.2f);
    assert_int_equal(dm_object_set_links(h.w.context, h.object, NULL, 0), DM_OK);
    float ajar;
    assert_int_equal(dm_joint_value_at(&turn, 0.1f, &ajar), DM_OK);
    assert_true(fabsf(ajar - 0.15f) < 1e-6f);
    dm_joint wheel = turn;
    wheel.type = DM_JOINT_CONTINUOUS;
    assert_int_equal(dm_joint_value_at(&wheel, 0.1f, &ajar), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&h.w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_door_tells_what_happens),
        cmocka_unit_test(a_door_tells_what_holds_it),
        cmocka_unit_test(a_restored_drag_tells_the_same),
        cmocka_unit_test(rules_that_make_no_sense_are_refused),
        cmocka_unit_test(inputs_that_make_no_sense_are_refused),
        cmocka_unit_test(older_callers_are_served),
        cmocka_unit_test(a_door_is_moved_without_a_pointer),
        cmocka_unit_test(a_door_opens_away_from_the_player),
        cmocka_unit_test(links_move_parts_of_an_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
