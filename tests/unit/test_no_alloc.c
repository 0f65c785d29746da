/* Memory: frame calls take none and say nothing, failing allocations leak nothing, and every byte comes back. */
#include <math.h>

#include "test_world.h"

typedef struct playground {
    test_world w;
    dm_object object;
    dm_motion motion;
    dm_drag drag;
    dm_scene scene;
    uint32_t instance;
} playground;

static void open_playground(playground* p) {
    test_world_init(&p->w);
    test_world_open(&p->w);
    test_world_load_model(&p->w);
    p->object = test_world_cabinet(&p->w);
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = TEST_DOOR, .drag = test_pull()};
    const dm_drag_rules rules = dm_drag_rules_default();
    const dm_drag_desc drag = {.rules = &rules,
                               .struct_size = sizeof drag,
                               .part_id = TEST_DOOR,
                               .object = p->object,
                               .grab_point = test_pull().point};
    const dm_scene_desc scene = {.struct_size = sizeof scene};
    assert_int_equal(dm_motion_generate(p->w.context, p->object, &motion, &p->motion), DM_OK);
    assert_int_equal(dm_drag_begin(p->w.context, &drag, &p->drag), DM_OK);
    assert_int_equal(dm_scene_create(p->w.context, &scene, &p->scene), DM_OK);
    assert_int_equal(dm_scene_add(p->w.context, p->scene, p->object, NULL, &p->instance), DM_OK);
    assert_int_equal(dm_scene_commit(p->w.context, p->scene), DM_OK);
}

/* One frame of a game: the pointer moves, the part follows, the scene is picked. */
static void play_frame(playground* p, int frame) {
    dm_context* context = p->w.context;
    dm_pose poses[DM_MOTION_FRAMES], pose;
    float values[DM_MOTION_FRAMES], value, matrix[16], points[6] = {0, 0, 0, 1, 1, 1};
    dm_camera camera = {.struct_size = sizeof camera, .fov_y = 1, .eye = {0.5f, 0.5f, 5}, .forward = {0, 0, -1}};
    camera.up.y = 1;
    camera.viewport_width = 800;
    camera.viewport_height = 600;
    dm_ray ray;
    dm_drag_state drag = {.struct_size = sizeof drag};
    dm_hit hit = {.struct_size = sizeof hit};
    assert_int_equal(dm_camera_ray(context, &camera, 400 + (float)frame, 300, &ray), DM_OK);
    assert_int_equal(dm_drag_update(context, p->drag, &ray, 0.016f, &drag), DM_OK);
    assert_int_equal(dm_motion_sample(context, p->motion, (float)frame / 100, &pose, &value), DM_OK);
    assert_int_equal(dm_motion_get_frames(context, p->motion, poses, values), DM_OK);
    assert_int_equal(dm_scene_move(context, p->scene, p->instance, TEST_DOOR, &drag.pose), DM_OK);
    assert_int_equal(dm_scene_move(context, p->scene, p->instance, TEST_HANDLE, &drag.pose), DM_OK);
    assert_int_equal(dm_scene_move(context, p->scene, p->instance, 0, &poses[0]), DM_OK);
    assert_int_equal(dm_scene_commit(context, p->scene), DM_OK);
    assert_int_equal(dm_scene_pick(context, p->scene, &ray, &hit), DM_OK);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(context, p->object, TEST_DOOR, &joint), DM_OK);
    assert_int_equal(dm_joint_pose(&joint, value, &pose), DM_OK);
    float angle_error, distance_error;
    dm_part_state part = dm_part_state_default();
    dm_joint_frame constraint = dm_joint_frame_default();
    static uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    assert_int_equal(dm_joint_value(&joint, &pose, &value, &angle_error, &distance_error), DM_OK);
    assert_int_equal(dm_joint_get_frame(&joint, &constraint), DM_OK);
    assert_int_equal(dm_joint_scale(&joint, (dm_vec3){1, 2, 3}, &joint), DM_OK);
    assert_int_equal(dm_drag_get_part_state(context, p->drag, &part), DM_OK);
    assert_int_equal(dm_drag_save(context, p->drag, saved, sizeof saved), DM_OK);
    assert_int_equal(dm_drag_restore(context, p->drag, saved, sizeof saved), DM_OK);
    dm_drag_input input = dm_drag_input_default();
    float parts[2] = {value, 0};
    uint8_t held[2];
    input.hand.kind = DM_HAND_POINT, input.second.kind = DM_HAND_RAY, input.second.ray = ray;
    input.flags = DM_INPUT_ASK;
    assert_int_equal(dm_drag_step(context, p->drag, &input, 0.016f, &drag), DM_OK);
    assert_int_equal(dm_drag_take(context, p->drag, 0, &drag), DM_OK);
    assert_int_equal(dm_object_follow_links(context, p->object, TEST_DOOR, parts, held, 2), DM_OK);
    assert_int_equal(dm_joint_value_at(&joint, 0.1f, &value), DM_OK);
    dm_pose_multiply(&pose, &drag.pose, &pose);
    dm_pose_inverse(&pose, &pose);
    assert_int_equal(dm_pose_from_rotation(pose.real, (dm_vec3){1, 2, 3}, &pose), DM_OK);
    dm_pose_to_matrix(&pose, matrix);
    dm_pose_apply_points(&pose, points, 0, points, 0, 2);
}

static void test_frame_calls_take_no_memory_and_log_nothing(void** state) {
    (void)state;
    playground p;
    open_playground(&p);
    const int64_t calls = p.w.memory.calls;
    p.w.messages.count = 0;
    for (int frame = 0; frame < 100; frame++) play_frame(&p, frame);
    assert_int_equal(p.w.memory.calls, calls);
    assert_int_equal(p.w.messages.count, 0);
    test_world_close(&p.w);
}

/* Drags and motions that come and go leave nothing behind. */
static void test_short_lives_do_not_add_up(void** state) {
    (void)state;
    playground p;
    open_playground(&p);
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = TEST_DOOR, .drag = test_pull()};
    const dm_drag_desc drag = {
        .struct_size = sizeof drag, .part_id = TEST_DOOR, .object = p.object, .grab_point = test_pull().point};
    const int64_t held = test_world_bytes(&p.w);
    for (int i = 0; i < 50; i++) {
        dm_motion a;
        dm_drag b;
        uint32_t instance;
        assert_int_equal(dm_motion_generate(p.w.context, p.object, &motion, &a), DM_OK);
        assert_int_equal(dm_drag_begin(p.w.context, &drag, &b), DM_OK);
        assert_int_equal(dm_scene_add(p.w.context, p.scene, p.object, NULL, &instance), DM_OK);
        assert_int_equal(dm_scene_remove(p.w.context, p.scene, instance), DM_OK);
        assert_int_equal(dm_drag_end(p.w.context, b, NULL), DM_OK);
        assert_int_equal(dm_motion_destroy(p.w.context, a), DM_OK);
        assert_int_equal(test_world_bytes(&p.w), held);
    }
    test_world_close(&p.w);
}

/* An object's whole life, stopping at the first failure. */
static dm_result live(test_world* w) {
    const dm_part_desc part = {.struct_size = sizeof part, .id = TEST_DOOR};
    const dm_mesh_desc mesh = test_shape_desc(&w->shape);
    const dm_object_desc desc = {
        .struct_size = sizeof desc, .mesh = &mesh, .parts = &part, .part_count = 1, .model = w->model};
    const dm_scene_desc scene_desc = {.struct_size = sizeof scene_desc};
    const dm_vec3 path[2] = {test_pull().point, {0.8f, 0.5f, 1.3f}};
    const dm_motion_desc motion_desc = {
        .struct_size = sizeof motion_desc, .part_id = TEST_DOOR, .drag = test_pull(), .path = path, .path_count = 2};
    dm_object object, loaded;
    dm_scene scene;
    dm_motion motion;
    dm_drag drag;
    uint32_t instance;
    size_t size = 0;
    dm_result result = dm_object_prepare(w->context, &desc, &object);
    if (result == DM_OK) result = dm_object_refine(w->context, object, TEST_DOOR, &motion_desc.drag);
    if (result == DM_OK) result = dm_scene_create(w->context, &scene_desc, &scene);
    if (result == DM_OK) result = dm_scene_add(w->context, scene, object, NULL, &instance);
    if (result == DM_OK) result = dm_motion_generate(w->context, object, &motion_desc, &motion);
    if (result != DM_OK) return result;
    const dm_drag_desc drag_desc = {.struct_size = sizeof drag_desc, .part_id = TEST_DOOR, .object = object};
    result = dm_drag_begin(w->context, &drag_desc, &drag);
    if (result != DM_OK) return result;
    result = dm_object_save(w->context, object, NULL, 0, &size);
    if (result != DM_OK) return result;
    void* blob = malloc(size);
    result = dm_object_save(w->context, object, blob, size, &size);
    if (result == DM_OK) result = dm_object_load(w->context, blob, size, w->model, &loaded);
    free(blob);
    return result;
}

/* The allocator fails from call n of the life on, for every n, in a context that goes on all the same. */
static void test_any_allocation_of_a_life_may_fail(void** state) {
    (void)state;
    static test_world w;
    int failures = 0;
    test_world_init(&w);
    test_world_open(&w);
    test_world_load_model(&w);
    for (dm_result result = DM_ERROR_OUT_OF_MEMORY; result != DM_OK; failures++) {
        w.memory.fail_at = w.memory.calls + failures;
        result = live(&w);
        if (result != DM_OK) assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        if (result != DM_OK) assert_int_equal(w.messages.code, DM_ERROR_OUT_OF_MEMORY);
    }
    assert_true(failures > 20);
    test_world_close(&w);
}

static void test_any_allocation_of_a_context_may_fail(void** state) {
    (void)state;
    dm_model_desc weights = {.struct_size = sizeof weights};
    void* kinematics = test_read_file("sdk/models/kpp_net.safetensors", &weights.kinematics_size);
    void* motion = test_read_file("sdk/models/dq_vae.safetensors", &weights.motion_size);
    void* ranker = test_read_file("sdk/models/ranker.safetensors", &weights.ranker_size);
    weights.kinematics = kinematics;
    weights.motion = motion;
    weights.ranker = ranker;
    static test_world w;
    int failures = 0;
    for (dm_result result = DM_ERROR_OUT_OF_MEMORY; result != DM_OK; failures++) {
        test_world_init(&w);
        w.memory.fail_at = failures;
        result = dm_context_create(&w.desc, &w.context);
        if (result == DM_OK) result = dm_model_load(w.context, &weights, &w.model);
        if (result != DM_OK) assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        if (result != DM_OK) assert_int_equal(w.messages.code, DM_ERROR_OUT_OF_MEMORY);
        test_world_close(&w);
    }
    assert_true(failures > 20);
    free(kinematics);
    free(motion);
    free(ranker);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_frame_calls_take_no_memory_and_log_nothing),
        cmocka_unit_test(test_short_lives_do_not_add_up),
        cmocka_unit_test(test_any_allocation_of_a_context_may_fail),
        cmocka_unit_test(test_any_allocation_of_a_life_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
