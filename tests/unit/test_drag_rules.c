/* Rules, events and inputs of a drag through the public functions: bad ones, snapshots, callers of other sizes. */
#include "test_world.h"

#include <math.h>

static const dm_vec3 camera = {2.5f, 1.8f, 4};

static dm_ray ray_to(dm_vec3 point) {
    return (dm_ray){camera, {point.x - camera.x, point.y - camera.y, point.z - camera.z}};
}

static dm_vec3 point_on(const dm_joint* joint, float value) {
    dm_pose pose;
    const dm_vec3 grab = test_pull().point;
    float point[3] = {grab.x, grab.y, grab.z};
    assert_int_equal(dm_joint_pose(joint, value, &pose), DM_OK);
    dm_pose_apply_points(&pose, point, 0, point, 0, 1);
    return (dm_vec3){point[0], point[1], point[2]};
}

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
    input.hand.ray = ray_to(point_on(&hinge, value));
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
    const dm_drag drag = begin(&h, &rules), other = begin(&h, NULL);
    dm_drag_state first[150], now = dm_drag_state_default();
    for (int k = 0; k < 150; k++) {
        dm_drag_input input = pointer_at(way(k));
        input.lower = -1, input.upper = 1.3f;
        first[k] = dm_drag_state_default();
        if (k == 50) assert_int_equal(dm_drag_save(h.w.context, drag, saved, sizeof saved), DM_OK);
        assert_int_equal(dm_drag_step(h.w.context, drag, &input, 1.0f / 60, &first[k]), DM_OK);
    }
    /* The snapshot holds the rules too: a drag of the same part that began without them takes them over. */
    assert_int_equal(dm_drag_restore(h.w.context, other, saved, sizeof saved), DM_OK);
    for (int k = 50; k < 150; k++) {
        dm_drag_input input = pointer_at(way(k));
        input.lower = -1, input.upper = 1.3f;
        assert_int_equal(dm_drag_step(h.w.context, other, &input, 1.0f / 60, &now), DM_OK);
        assert_memory_equal(&now, &first[k], sizeof now);
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
    assert_error(&h.w, dm_drag_step(h.w.context, with, NULL, 0, &now), DM_ERROR_INVALID_ARGUMENT, "input is NULL");
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, -1, &now), DM_ERROR_INVALID_ARGUMENT, "dt is -1");
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, NULL), DM_ERROR_INVALID_ARGUMENT, "out_state");
    input.hand.kind = 77;
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT, "kind is 77");
    input = pointer_at(0);
    input.hand.ray.direction = (dm_vec3){0, 0, 0};
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT, "no length");
    input = pointer_at(0);
    input.lower = 1;
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT, "must rise");
    input.upper = NAN;
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_NOT_FINITE, "upper nan");
    input.upper = INFINITY;
    assert_int_equal(dm_drag_step(h.w.context, with, &input, 0, &now), DM_OK);
    assert_error(&h.w, dm_drag_step(h.w.context, without, &input, 0, &now), DM_ERROR_INVALID_ARGUMENT, "desc.rules");
    input = dm_drag_input_default(); /* no hand: it stays */
    assert_int_equal(dm_drag_step(h.w.context, without, &input, 0.1f, &now), DM_OK);
    assert_true(now.value == 0);
    assert_int_equal(dm_drag_end(h.w.context, with, NULL), DM_OK);
    assert_error(&h.w, dm_drag_step(h.w.context, with, &input, 0, &now), DM_ERROR_STALE_HANDLE, "dm_drag_step");
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_door_tells_what_happens),
        cmocka_unit_test(a_restored_drag_tells_the_same),
        cmocka_unit_test(rules_that_make_no_sense_are_refused),
        cmocka_unit_test(inputs_that_make_no_sense_are_refused),
        cmocka_unit_test(older_callers_are_served),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
