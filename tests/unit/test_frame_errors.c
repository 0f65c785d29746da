/* What is tagged [frame] answers wrong input as fast as right: by its result alone, without a message, memory or a
 * lock. The list is that of the header. What a drag refused is said once, when it ends. */
#include "test_calls.h"
#include "test_malloc.h"

enum { FRAMES = 60 };

typedef struct wrong_call {
    const char* function;
    const char* way;
    dm_result expected;
    dm_result (*run)(test_stage* s);
} wrong_call;

/* ---- joints and poses as values ---- */

static dm_result joint_pose_at_nan(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_pose(&hinge, NAN, &s->out.pose);
}

static dm_result joint_value_of_no_pose(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_value(&hinge, NULL, &s->out.value, NULL, NULL);
}

static dm_result joint_value_at_nan(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_value_at(&hinge, NAN, &s->out.value);
}

static dm_result joint_frame_without_axis(test_stage* s) {
    dm_joint hinge = test_hinge();
    hinge.axis = (dm_vec3){0, 0, 0};
    return dm_joint_get_frame(&hinge, &s->out.frame);
}

static dm_result joint_scaled_by_nan(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_scale(&hinge, (dm_vec3){NAN, 1, 1}, &s->out.joint);
}

static dm_result pose_of_no_rotation(test_stage* s) {
    return dm_pose_from_rotation((const float[4]){0, 0, 0, 0}, (dm_vec3){0, 0, 0}, &s->out.pose);
}

/* ---- links and motions ---- */

static dm_result links_of_unknown_part(test_stage* s) {
    s->out.values[0] = s->out.values[1] = 0;
    return dm_object_follow_links(s->w->context, s->own, 77, s->out.values, s->out.held, TEST_STAGE_PARTS);
}

static dm_result links_of_too_few_values(test_stage* s) {
    return dm_object_follow_links(s->w->context, s->own, TEST_DOOR, s->out.values, s->out.held, 1);
}

static dm_result links_of_nan(test_stage* s) {
    s->out.values[0] = s->out.values[1] = NAN;
    return dm_object_follow_links(s->w->context, s->own, TEST_DOOR, s->out.values, s->out.held, TEST_STAGE_PARTS);
}

static dm_result links_of_no_object(test_stage* s) {
    return dm_object_follow_links(s->w->context, 0, TEST_DOOR, s->out.values, s->out.held, TEST_STAGE_PARTS);
}

static dm_result motion_at_nan(test_stage* s) {
    return dm_motion_sample(s->w->context, s->motion, NAN, &s->out.pose, NULL);
}

static dm_result motion_into_nothing(test_stage* s) {
    return dm_motion_sample(s->w->context, s->motion, 0, NULL, NULL);
}

static dm_result motion_of_stale_handle(test_stage* s) {
    return dm_motion_sample(s->w->context, s->drag, 0, &s->out.pose, NULL);
}

static dm_result frames_into_nothing(test_stage* s) {
    return dm_motion_get_frames(s->w->context, s->motion, NULL, NULL);
}

static dm_result frames_of_stale_handle(test_stage* s) {
    return dm_motion_get_frames(s->w->context, 0, s->out.poses, NULL);
}

/* ---- drags ---- */

static dm_result update(test_stage* s, dm_ray ray, float dt) {
    return dm_drag_update(s->w->context, s->drag, &ray, dt, &s->out.state);
}

static dm_result update_by_zero_ray(test_stage* s) {
    return update(s, (dm_ray){{0, 1, 2}, {0, 0, 0}}, 0.016f);
}

static dm_result update_by_nan_ray(test_stage* s) {
    return update(s, (dm_ray){{NAN, 1, 2}, {0, 0, -1}}, 0.016f);
}

static dm_result update_by_far_ray(test_stage* s) {
    return update(s, (dm_ray){{0, 2e9f, 2}, {0, 0, -1}}, 0.016f);
}

static dm_result update_by_no_ray(test_stage* s) {
    return dm_drag_update(s->w->context, s->drag, NULL, 0.016f, &s->out.state);
}

static dm_result update_back_in_time(test_stage* s) {
    return update(s, (dm_ray){{0, 1, 2}, {0, 0, -1}}, -0.016f);
}

static dm_result update_by_nan_time(test_stage* s) {
    return update(s, (dm_ray){{0, 1, 2}, {0, 0, -1}}, NAN);
}

static dm_result update_into_nothing(test_stage* s) {
    const dm_ray ray = {{0, 1, 2}, {0, 0, -1}};
    return dm_drag_update(s->w->context, s->drag, &ray, 0.016f, NULL);
}

static dm_result update_into_an_unsized_state(test_stage* s) {
    const dm_ray ray = {{0, 1, 2}, {0, 0, -1}};
    dm_drag_state state = {.struct_size = 0};
    return dm_drag_update(s->w->context, s->drag, &ray, 0.016f, &state);
}

static dm_result update_of_stale_handle(test_stage* s) {
    const dm_ray ray = {{0, 1, 2}, {0, 0, -1}};
    return dm_drag_update(s->w->context, s->object, &ray, 0.016f, &s->out.state);
}

static dm_result step_by_unknown_hand(test_stage* s) {
    dm_drag_input input = dm_drag_input_default();
    input.hand.kind = 77;
    return dm_drag_step(s->w->context, s->drag, &input, 0.016f, &s->out.state);
}

static dm_result step_by_no_input(test_stage* s) {
    return dm_drag_step(s->w->context, s->drag, NULL, 0.016f, &s->out.state);
}

static dm_result step_between_falling_bounds(test_stage* s) {
    dm_drag_input input = dm_drag_input_default();
    input.lower = 1;
    return dm_drag_step(s->w->context, s->drag, &input, 0.016f, &s->out.state);
}

static dm_result step_of_stale_handle(test_stage* s) {
    const dm_drag_input input = dm_drag_input_default();
    return dm_drag_step(s->w->context, s->object, &input, 0.016f, &s->out.state);
}

static dm_result take_unasked(test_stage* s) {
    return dm_drag_take(s->w->context, s->drag, 0.1f, &s->out.state);
}

static dm_result take_nan(test_stage* s) {
    return dm_drag_take(s->w->context, s->drag, NAN, &s->out.state);
}

static dm_result take_of_stale_handle(test_stage* s) {
    return dm_drag_take(s->w->context, UINT64_MAX, 0, &s->out.state);
}

static dm_result part_state_into_nothing(test_stage* s) {
    return dm_drag_get_part_state(s->w->context, s->drag, NULL);
}

static dm_result part_state_of_stale_handle(test_stage* s) {
    return dm_drag_get_part_state(s->w->context, 0, &s->out.part_state);
}

static dm_result save_into_little(test_stage* s) {
    return dm_drag_save(s->w->context, s->drag, s->snapshot, 8);
}

static dm_result save_of_stale_handle(test_stage* s) {
    return dm_drag_save(s->w->context, 0, s->snapshot, sizeof s->snapshot);
}

static dm_result restore_from_nothing(test_stage* s) {
    return dm_drag_restore(s->w->context, s->drag, NULL, 0);
}

static dm_result restore_from_nonsense(test_stage* s) {
    return dm_drag_restore(s->w->context, s->drag, "nonsense", 8);
}

static dm_result restore_of_stale_handle(test_stage* s) {
    return dm_drag_restore(s->w->context, 0, s->snapshot, sizeof s->snapshot);
}

/* ---- camera and scenes ---- */

static dm_result camera_without_view(test_stage* s) {
    const dm_camera camera = {.struct_size = sizeof camera, .forward = {0, 1, 0}, .up = {0, 1, 0}};
    return dm_camera_ray(s->w->context, &camera, 1, 1, &s->out.ray);
}

static dm_result camera_at_nan(test_stage* s) {
    const dm_camera camera = dm_camera_default();
    return dm_camera_ray(s->w->context, &camera, NAN, 1, &s->out.ray);
}

static dm_result move_of_unknown_instance(test_stage* s) {
    const dm_pose pose = test_some_pose();
    return dm_scene_move(s->w->context, s->scene, s->instance + 7, TEST_DOOR, &pose);
}

static dm_result move_of_unknown_part(test_stage* s) {
    const dm_pose pose = test_some_pose();
    return dm_scene_move(s->w->context, s->scene, s->instance, 77, &pose);
}

static dm_result move_by_no_rotation(test_stage* s) {
    const dm_pose pose = {.real = {0, 0, 0, 0}};
    return dm_scene_move(s->w->context, s->scene, s->instance, TEST_DOOR, &pose);
}

static dm_result move_of_stale_handle(test_stage* s) {
    const dm_pose pose = test_some_pose();
    return dm_scene_move(s->w->context, s->drag, s->instance, TEST_DOOR, &pose);
}

static dm_result commit_of_stale_handle(test_stage* s) {
    return dm_scene_commit(s->w->context, 0);
}

static dm_result pick_by_zero_ray(test_stage* s) {
    const dm_ray ray = {{0, 0, 0}, {0, 0, 0}};
    return dm_scene_pick(s->w->context, s->scene, &ray, &s->out.hit);
}

static dm_result pick_by_nan_ray(test_stage* s) {
    const dm_ray ray = {{0, 0, 0}, {0, NAN, 1}};
    return dm_scene_pick(s->w->context, s->scene, &ray, &s->out.hit);
}

static dm_result pick_into_nothing(test_stage* s) {
    const dm_ray ray = {{0, 0, 0}, {0, 0, 1}};
    return dm_scene_pick(s->w->context, s->scene, &ray, NULL);
}

static dm_result pick_of_stale_handle(test_stage* s) {
    const dm_ray ray = {{0, 0, 0}, {0, 0, 1}};
    return dm_scene_pick(s->w->context, s->drag, &ray, &s->out.hit);
}

static const wrong_call wrong_calls[] = {
    {"dm_joint_pose", "NaN", DM_ERROR_NOT_FINITE, joint_pose_at_nan},
    {"dm_joint_value", "no pose", DM_ERROR_INVALID_ARGUMENT, joint_value_of_no_pose},
    {"dm_joint_value_at", "NaN", DM_ERROR_NOT_FINITE, joint_value_at_nan},
    {"dm_joint_get_frame", "no axis", DM_ERROR_INVALID_ARGUMENT, joint_frame_without_axis},
    {"dm_joint_scale", "NaN", DM_ERROR_NOT_FINITE, joint_scaled_by_nan},
    {"dm_pose_from_rotation", "no length", DM_ERROR_INVALID_ARGUMENT, pose_of_no_rotation},
    {"dm_object_follow_links", "unknown part", DM_ERROR_NOT_FOUND, links_of_unknown_part},
    {"dm_object_follow_links", "too few values", DM_ERROR_INVALID_ARGUMENT, links_of_too_few_values},
    {"dm_object_follow_links", "NaN", DM_ERROR_NOT_FINITE, links_of_nan},
    {"dm_object_follow_links", "stale", DM_ERROR_STALE_HANDLE, links_of_no_object},
    {"dm_motion_sample", "NaN", DM_ERROR_NOT_FINITE, motion_at_nan},
    {"dm_motion_sample", "no output", DM_ERROR_INVALID_ARGUMENT, motion_into_nothing},
    {"dm_motion_sample", "stale", DM_ERROR_STALE_HANDLE, motion_of_stale_handle},
    {"dm_motion_get_frames", "no output", DM_ERROR_INVALID_ARGUMENT, frames_into_nothing},
    {"dm_motion_get_frames", "stale", DM_ERROR_STALE_HANDLE, frames_of_stale_handle},
    {"dm_drag_update", "zero ray", DM_ERROR_INVALID_ARGUMENT, update_by_zero_ray},
    {"dm_drag_update", "NaN ray", DM_ERROR_NOT_FINITE, update_by_nan_ray},
    {"dm_drag_update", "far ray", DM_ERROR_INVALID_ARGUMENT, update_by_far_ray},
    {"dm_drag_update", "no ray", DM_ERROR_INVALID_ARGUMENT, update_by_no_ray},
    {"dm_drag_update", "back in time", DM_ERROR_INVALID_ARGUMENT, update_back_in_time},
    {"dm_drag_update", "NaN time", DM_ERROR_NOT_FINITE, update_by_nan_time},
    {"dm_drag_update", "no output", DM_ERROR_INVALID_ARGUMENT, update_into_nothing},
    {"dm_drag_update", "unsized output", DM_ERROR_STRUCT_SIZE, update_into_an_unsized_state},
    {"dm_drag_update", "stale", DM_ERROR_STALE_HANDLE, update_of_stale_handle},
    {"dm_drag_step", "unknown hand", DM_ERROR_INVALID_ARGUMENT, step_by_unknown_hand},
    {"dm_drag_step", "no input", DM_ERROR_INVALID_ARGUMENT, step_by_no_input},
    {"dm_drag_step", "falling bounds", DM_ERROR_INVALID_ARGUMENT, step_between_falling_bounds},
    {"dm_drag_step", "stale", DM_ERROR_STALE_HANDLE, step_of_stale_handle},
    {"dm_drag_take", "not asked", DM_ERROR_INVALID_ARGUMENT, take_unasked},
    {"dm_drag_take", "NaN", DM_ERROR_NOT_FINITE, take_nan},
    {"dm_drag_take", "stale", DM_ERROR_STALE_HANDLE, take_of_stale_handle},
    {"dm_drag_get_part_state", "no output", DM_ERROR_INVALID_ARGUMENT, part_state_into_nothing},
    {"dm_drag_get_part_state", "stale", DM_ERROR_STALE_HANDLE, part_state_of_stale_handle},
    {"dm_drag_save", "little room", DM_ERROR_BUFFER_TOO_SMALL, save_into_little},
    {"dm_drag_save", "stale", DM_ERROR_STALE_HANDLE, save_of_stale_handle},
    {"dm_drag_restore", "nothing", DM_ERROR_INVALID_ARGUMENT, restore_from_nothing},
    {"dm_drag_restore", "nonsense", DM_ERROR_BAD_DATA, restore_from_nonsense},
    {"dm_drag_restore", "stale", DM_ERROR_STALE_HANDLE, restore_of_stale_handle},
    {"dm_camera_ray", "no view", DM_ERROR_INVALID_ARGUMENT, camera_without_view},
    {"dm_camera_ray", "NaN", DM_ERROR_NOT_FINITE, camera_at_nan},
    {"dm_scene_move", "unknown instance", DM_ERROR_NOT_FOUND, move_of_unknown_instance},
    {"dm_scene_move", "unknown part", DM_ERROR_NOT_FOUND, move_of_unknown_part},
    {"dm_scene_move", "no rotation", DM_ERROR_INVALID_ARGUMENT, move_by_no_rotation},
    {"dm_scene_move", "stale", DM_ERROR_STALE_HANDLE, move_of_stale_handle},
    {"dm_scene_commit", "stale", DM_ERROR_STALE_HANDLE, commit_of_stale_handle},
    {"dm_scene_pick", "zero ray", DM_ERROR_INVALID_ARGUMENT, pick_by_zero_ray},
    {"dm_scene_pick", "NaN ray", DM_ERROR_NOT_FINITE, pick_by_nan_ray},
    {"dm_scene_pick", "no output", DM_ERROR_INVALID_ARGUMENT, pick_into_nothing},
    {"dm_scene_pick", "stale", DM_ERROR_STALE_HANDLE, pick_of_stale_handle},
};
enum { WRONG_CALLS = sizeof wrong_calls / sizeof *wrong_calls };

static void open_stage(test_stage* s, test_world* w) {
    test_world_init(w);
    test_stage_open(s, w);
    w->messages.count = 0;
}

static void every_frame_function_that_can_fail_has_a_row(void** state) {
    (void)state;
    cJSON* interface = test_interface();
    const cJSON* function;
    cJSON_ArrayForEach(function, cJSON_GetObjectItem(interface, "functions")) {
        const char* name = cJSON_GetStringValue(cJSON_GetObjectItem(function, "name"));
        const char* tag = cJSON_GetStringValue(cJSON_GetObjectItem(function, "threads"));
        const cJSON* answer = cJSON_GetObjectItem(cJSON_GetObjectItem(function, "returns"), "name");
        if (strcmp(tag, "frame") != 0 || strcmp(cJSON_GetStringValue(answer), "dm_result") != 0) continue;
        bool found = false;
        for (int i = 0; i < WRONG_CALLS; i++) found = found || strcmp(wrong_calls[i].function, name) == 0;
        if (!found) fail_msg("%s has no row here", name);
    }
    cJSON_Delete(interface);
}

static void wrong_input_is_answered_by_the_result_alone(void** state) {
    (void)state;
    static test_world w;
    static test_stage s;
    open_stage(&s, &w);
    for (const wrong_call* call = wrong_calls; call < wrong_calls + WRONG_CALLS; call++) {
        test_answers_clear(&s.out);
        const int64_t before = w.memory.calls;
        dm_result result = call->expected;
        test_malloc_watch(TEST_NEVER);
        for (int i = 0; i < FRAMES && result == call->expected; i++) result = call->run(&s);
        test_malloc_unwatch();
        if (result != call->expected)
            fail_msg("%s, %s: %s, not %s", call->function, call->way, dm_result_string(result),
                     dm_result_string(call->expected));
        if (w.messages.count != 0 || test_malloc.calls != 0 || w.memory.calls != before)
            fail_msg("%s, %s: %d messages, %d calls of malloc, %d of the host's allocator", call->function, call->way,
                     w.messages.count, (int)test_malloc.calls, (int)(w.memory.calls - before));
    }
    assert_true(test_stage_is_usable(&s));
    test_stage_close(&s);
}

static void what_a_drag_refused_is_said_once_at_its_end(void** state) {
    (void)state;
    static test_world w;
    static test_stage s;
    open_stage(&s, &w);
    const dm_drag kept = s.drag;
    s.drag = test_stage_drag(&s, 0, NULL);
    for (int i = 0; i < FRAMES; i++) assert_int_equal(update_by_nan_ray(&s), DM_ERROR_NOT_FINITE);
    assert_int_equal(update_by_zero_ray(&s), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(w.messages.count, 0);
    assert_int_equal(dm_drag_end(w.context, s.drag, NULL), DM_OK);
    assert_int_equal(w.messages.count, 1);
    assert_non_null(
        strstr(w.messages.text, "61 updates of this drag were refused, the first with DM_ERROR_NOT_FINITE"));
    s.drag = kept;
    test_stage_close(&s);
}

static void a_time_step_that_rounding_made_negative_is_none(void** state) {
    (void)state;
    static test_world w;
    static test_stage s;
    open_stage(&s, &w);
    const dm_ray ray = test_ray_to(test_pull().point);
    const float rounded[] = {-1e-9f, -1e-6f, -1e-4f, -0.0f, -1e-40f};
    dm_drag_state none = dm_drag_state_default(), now = dm_drag_state_default();
    assert_int_equal(dm_drag_update(w.context, s.drag, &ray, 0.1f, &none), DM_OK);
    assert_int_equal(dm_drag_save(w.context, s.drag, s.snapshot, sizeof s.snapshot), DM_OK);
    assert_int_equal(dm_drag_update(w.context, s.drag, &ray, 0, &none), DM_OK);
    for (size_t i = 0; i < sizeof rounded / sizeof *rounded; i++) {
        assert_int_equal(dm_drag_restore(w.context, s.drag, s.snapshot, sizeof s.snapshot), DM_OK);
        assert_int_equal(dm_drag_update(w.context, s.drag, &ray, rounded[i], &now), DM_OK);
        assert_memory_equal(&now, &none, sizeof now);
    }
    assert_int_equal(dm_drag_update(w.context, s.drag, &ray, -2e-4f, &now), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(w.messages.count, 0);
    test_stage_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_frame_function_that_can_fail_has_a_row),
        cmocka_unit_test(wrong_input_is_answered_by_the_result_alone),
        cmocka_unit_test(what_a_drag_refused_is_said_once_at_its_end),
        cmocka_unit_test(a_time_step_that_rounding_made_negative_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
