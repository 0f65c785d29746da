/* Drags through the public functions: release, veto, replay, the joint a pull has chosen, bad input, no memory. */
#include "test_world.h"

#include <math.h>

/* Grabs the door's handle and swings it open along the true hinge to `value`. */
static dm_drag swing(test_world* w, dm_object object, uint32_t flags, float value, dm_drag_state* out_state) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .part_id = TEST_DOOR,
                               .object = object,
                               .grab_point = test_pull().point,
                               .flags = flags};
    const dm_joint hinge = test_hinge();
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(w->context, &desc, &drag), DM_OK);
    for (int k = 0; k <= 120; k++) { /* holds on for what a change of the joint takes */
        const dm_ray ray = test_ray_to(test_point_on(&hinge, value * fminf((float)k / 60, 1)));
        assert_int_equal(dm_drag_update(w->context, drag, &ray, 0.016f, out_state), DM_OK);
    }
    return drag;
}

static void run_out(test_world* w, dm_drag drag, dm_drag_state* out_state) {
    int k = 0;
    do {
        assert_int_equal(dm_drag_update(w->context, drag, NULL, 0.016f, out_state), DM_OK);
    } while (out_state->phase != DM_DRAG_AT_REST && ++k < 500);
    assert_int_equal(out_state->phase, DM_DRAG_AT_REST);
}

static void a_released_door_does_what_was_meant(void** state) {
    (void)state;
    for (int with_model = 0; with_model < 2; with_model++) {
        test_world w;
        test_world_init(&w);
        test_world_open(&w);
        if (with_model) test_world_load_model(&w);
        const dm_object object = test_world_cabinet(&w);
        const dm_joint hinge = test_hinge();
        assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
        dm_drag_state now = {.struct_size = sizeof now};
        dm_release_plan plan = {.struct_size = sizeof plan};
        dm_release_desc wish = {.struct_size = sizeof wish};
        const dm_drag drag = swing(&w, object, 0, 1.42f, &now);
        assert_true(fabsf(now.value - 1.42f) < 0.01f && now.phase == DM_DRAG_HELD && now.changes == 0);
        assert_int_equal(dm_drag_release(w.context, drag, NULL, &plan), DM_OK);
        assert_int_equal(plan.intent, DM_INTENT_OPEN); /* so near to open */
        assert_true(plan.end_value == 1.5f && plan.duration > 0 && fabsf(plan.start_value - 1.42f) < 0.01f);
        assert_int_equal(plan.from_network, (uint32_t)with_model);
        run_out(&w, drag, &now);
        assert_true(now.value == 1.5f && now.at_limit == 1);
        wish.intent = DM_INTENT_CLOSE;
        wish.duration = 1;
        assert_int_equal(dm_drag_release(w.context, drag, &wish, &plan), DM_OK);
        assert_true(plan.intent == DM_INTENT_CLOSE && plan.duration == 1);
        assert_int_equal(dm_drag_update(w.context, drag, NULL, 0.5f, &now), DM_OK);
        const float half_way = now.value;
        assert_true(half_way > 0.1f && half_way < 1.4f);
        wish.intent = DM_INTENT_REPLAY;
        assert_int_equal(dm_drag_release(w.context, drag, &wish, NULL), DM_OK);
        assert_int_equal(dm_drag_update(w.context, drag, NULL, 0.5f, &now), DM_OK);
        assert_true(now.value == half_way);
        wish.intent = DM_INTENT_FREEZE;
        assert_int_equal(dm_drag_release(w.context, drag, &wish, NULL), DM_OK);
        run_out(&w, drag, &now);
        assert_true(now.value == half_way);
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
        test_world_close(&w);
    }
}

/* The library's own joint is open to what the pull says; KEEP_JOINT and the host's joint are not. */
static void the_pull_changes_no_joint_that_is_kept(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    dm_joint before = dm_joint_default();
    dm_part_state after = dm_part_state_default();
    dm_drag_state now = {.struct_size = sizeof now};
    assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &before), DM_OK);
    const dm_drag kept = swing(&w, object, DM_DRAG_KEEP_JOINT, 1.2f, &now);
    assert_int_equal(now.changes, 0);
    assert_int_equal(dm_drag_get_part_state(w.context, kept, &after), DM_OK);
    assert_memory_equal(&before, &after.joint, sizeof before);
    const dm_drag open = swing(&w, object, 0, 1.2f, &now);
    assert_int_equal(dm_drag_get_part_state(w.context, open, &after), DM_OK);
    assert_true(now.value >= after.joint.lower && now.value <= after.joint.upper);
    assert_true(after.joint.joint_confidence > 0 && after.joint.joint_confidence <= 1);
    dm_pose pose;
    assert_int_equal(dm_joint_pose(&after.joint, now.value, &pose), DM_OK);
    for (int i = 0; i < 4; i++) assert_true(fabsf(pose.real[i] - now.pose.real[i]) < 1e-6f);
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &after.joint), DM_OK);
    test_world_close(&w);
}

static void assert_error(const test_world* w, dm_result result, dm_result expected, const char* text) {
    assert_int_equal(result, expected);
    if (!strstr(w->messages.text, text)) fail_msg("'%s' does not say '%s'", w->messages.text, text);
}

static void nonsense_is_refused(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_drag_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .object = test_world_cabinet(&w)};
    dm_drag drag = 0;
    dm_drag_state now = {.struct_size = sizeof now};
    dm_part_state part = dm_part_state_default();
    const dm_drag_feel feels[] = {
        {.detent = -1}, {.detent_pull = 1.5f}, {.coast_time = NAN}, {.return_time = INFINITY}};
    const char* const texts[] = {"feel.detent is -1", "feel.detent_pull is 1.5", "feel.coast_time", "feel.return_time"};
    for (int i = 0; i < 4; i++) {
        desc.feel = feels[i];
        assert_error(&w, dm_drag_begin(w.context, &desc, &drag),
                     i < 2 ? DM_ERROR_INVALID_ARGUMENT : DM_ERROR_NOT_FINITE, texts[i]);
    }
    desc.feel = (dm_drag_feel){0};
    desc.flags = 8;
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_INVALID_ARGUMENT, "desc.flags is 0x8");
    desc.flags = 0;
    desc.limit_give = NAN;
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_NOT_FINITE, "desc.limit_give");
    desc.limit_give = 0;
    assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
    assert_int_equal(dm_drag_get_part_state(w.context, drag, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_get_part_state(w.context, drag + 1, &part), DM_ERROR_STALE_HANDLE);
    dm_release_desc wish = {.struct_size = sizeof wish, .intent = DM_INTENT_REPLAY};
    assert_error(&w, dm_drag_release(w.context, drag, &wish, NULL), DM_ERROR_INVALID_ARGUMENT, "never released");
    wish.intent = 9;
    assert_error(&w, dm_drag_release(w.context, drag, &wish, NULL), DM_ERROR_INVALID_ARGUMENT, "desc.intent is 9");
    wish = (dm_release_desc){.struct_size = sizeof wish, .duration = -1};
    assert_error(&w, dm_drag_release(w.context, drag, &wish, NULL), DM_ERROR_INVALID_ARGUMENT, "desc.duration is -1");
    dm_release_plan plan = {0};
    assert_error(&w, dm_drag_release(w.context, drag, NULL, &plan), DM_ERROR_STRUCT_SIZE, "out_plan.struct_size");
    assert_int_equal(dm_drag_update(w.context, drag, NULL, 0, &now), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    assert_error(&w, dm_drag_release(w.context, drag, NULL, NULL), DM_ERROR_STALE_HANDLE, "dm_drag_release");
    test_world_close(&w);
}

/* Without memory for the network's pace, a rule paces the release; updates allocate nothing. */
static void release_needs_no_memory(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    const dm_object object = test_world_cabinet(&w);
    const dm_joint hinge = test_hinge();
    dm_drag_state now = {.struct_size = sizeof now};
    dm_release_plan plan = {.struct_size = sizeof plan};
    assert_int_equal(dm_object_set_joint(w.context, object, TEST_DOOR, &hinge), DM_OK);
    const dm_drag drag = swing(&w, object, 0, 1.4f, &now);
    assert_int_equal(dm_context_trim(w.context), DM_OK);
    w.memory.fail_at = w.memory.calls;
    assert_int_equal(dm_drag_release(w.context, drag, NULL, &plan), DM_OK);
    assert_int_equal(plan.from_network, 0);
    const int64_t calls = w.memory.calls;
    run_out(&w, drag, &now);
    assert_true(now.value == 1.5f);
    assert_int_equal(w.memory.calls, calls);
    w.memory.fail_at = TEST_NEVER;
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_released_door_does_what_was_meant),
        cmocka_unit_test(the_pull_changes_no_joint_that_is_kept),
        cmocka_unit_test(nonsense_is_refused),
        cmocka_unit_test(release_needs_no_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
