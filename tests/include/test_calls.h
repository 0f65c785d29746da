/* Every public function as a call on a stage: one row a function and way of calling it. Tests that hold for all
 * functions walk this table; test_calls_check fails where bindings/dragmesh_api.json names a function without a row. */
#ifndef DM_TEST_CALLS_H
#define DM_TEST_CALLS_H

#include <math.h>

#include <cjson/cJSON.h>

#include "dragmesh/ext/gltf_rig.h"
#include "test_stage.h"

typedef struct test_call {
    const char* function;
    const char* way;               /* where a function has several rows; NULL: the only one */
    void (*before)(test_stage* s); /* makes what the call takes away; NULL: nothing */
    dm_result (*run)(test_stage* s);
    void (*undo)(test_stage* s);  /* takes away what the call has made; NULL: nothing */
    void (*after)(test_stage* s); /* takes away what is left of what `before` has made; NULL: nothing */
} test_call;

/* ---- the library, contexts, weights ---- */

static inline dm_result test_call_result_string(test_stage* s) {
    (void)s;
    return strcmp(dm_result_string(DM_OK), "DM_OK") == 0 ? DM_OK : DM_ERROR_INTERNAL;
}

static inline dm_result test_call_version(test_stage* s) {
    (void)s;
    return dm_version() == DM_VERSION ? DM_OK : DM_ERROR_INTERNAL;
}

static inline dm_result test_call_get_interface(test_stage* s) {
    (void)s;
    return dm_get_interface("dm.core/1") != NULL ? DM_OK : DM_ERROR_INTERNAL;
}

static inline dm_result test_call_context_create(test_stage* s) {
    return dm_context_create(&s->w->desc, &s->out.context);
}

static inline void test_after_context_create(test_stage* s) {
    dm_context_destroy(s->out.context);
}

static inline void test_before_context_destroy(test_stage* s) {
    assert_int_equal(dm_context_create(&s->w->desc, &s->spare_context), DM_OK);
}

static inline dm_result test_call_context_destroy(test_stage* s) {
    dm_context_destroy(s->spare_context);
    return DM_OK;
}

static inline dm_result test_call_context_get_memory(test_stage* s) {
    return dm_context_get_memory(s->w->context, &s->out.memory);
}

static inline void test_before_context_trim(test_stage* s) {
    dm_object object;
    assert_int_equal(test_world_prepare(s->w, 0, &object), DM_OK); /* leaves scratch memory */
    assert_int_equal(dm_object_destroy(s->w->context, object), DM_OK);
}

static inline dm_result test_call_context_trim(test_stage* s) {
    return dm_context_trim(s->w->context);
}

static inline dm_result test_call_model_load(test_stage* s) {
    return dm_model_load(s->w->context, &s->weights, &s->out.handle);
}

static inline void test_after_model_load(test_stage* s) {
    assert_int_equal(dm_model_unload(s->w->context, s->out.handle), DM_OK);
}

static inline void test_before_model_unload(test_stage* s) {
    assert_int_equal(dm_model_load(s->w->context, &s->weights, &s->spare_one), DM_OK);
}

static inline dm_result test_call_model_unload(test_stage* s) {
    return dm_model_unload(s->w->context, s->spare_one);
}

/* ---- objects ---- */

static inline dm_result test_call_find_part(test_stage* s) {
    const dm_drag_hint pull = test_pull();
    dm_mesh_desc mesh = s->mesh;
    mesh.part_ids = NULL, mesh.part_id_bytes = 0;
    return dm_mesh_find_part(s->w->context, &mesh, &pull, s->out.faces, TEST_STAGE_FACES);
}

static inline dm_result test_call_find_part_of_pieces(test_stage* s) {
    const dm_drag_hint pull = test_pull();
    return dm_mesh_find_part(s->w->context, &s->mesh, &pull, s->out.faces, TEST_STAGE_FACES);
}

static inline int32_t DM_CALL test_keep_choice(void* user, const dm_choice* choice) {
    (void)user;
    (void)choice;
    return DM_CHOICE_KEEP;
}

static inline int32_t DM_CALL test_no_intent(void* user, uint32_t part, dm_vec3 low, dm_vec3 high) {
    (void)user;
    (void)part;
    (void)low;
    (void)high;
    return DM_JOINT_UNKNOWN;
}

static inline int32_t DM_CALL test_go_on(void* user, float done) {
    (void)user;
    (void)done;
    return 0;
}

static inline dm_result test_prepare_ways(test_stage* s, dm_object_desc desc) {
    desc.struct_size = sizeof desc;
    desc.mesh = &s->mesh;
    desc.seed = 7;
    return dm_object_prepare(s->w->context, &desc, &s->out.handle);
}

static inline dm_result test_call_prepare(test_stage* s) {
    return test_prepare_ways(s, (dm_object_desc){.model = s->w->model});
}

static inline dm_result test_call_prepare_by_rules(test_stage* s) {
    return test_prepare_ways(s, (dm_object_desc){.flags = DM_PREPARE_WITHOUT_PICKING});
}

static inline dm_result test_call_prepare_by_network(test_stage* s) {
    return test_prepare_ways(s, (dm_object_desc){.model = s->w->model, .flags = DM_PREPARE_NETWORK_ALONE});
}

static inline dm_result test_call_prepare_with_all(test_stage* s) {
    const dm_drag_hint pull = test_pull();
    const dm_pivot pivot = {.origin = {0, 0.5f, 1.03f}, .axes = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    const dm_part_desc parts[TEST_STAGE_PARTS] = {
        {.struct_size = sizeof *parts, .id = TEST_DOOR, .drag = &pull, .label = "cabinet/door", .pivot = &pivot},
        {.struct_size = sizeof *parts, .id = TEST_HANDLE, .parent = TEST_DOOR, .joint_type = DM_JOINT_FIXED}};
    return test_prepare_ways(s, (dm_object_desc){.model = s->w->model,
                                                 .parts = parts,
                                                 .part_count = TEST_STAGE_PARTS,
                                                 .label = "kitchen/cabinet",
                                                 .intent = test_no_intent,
                                                 .choose = test_keep_choice,
                                                 .progress = test_go_on});
}

static inline void test_after_object(test_stage* s) {
    assert_int_equal(dm_object_destroy(s->w->context, s->out.handle), DM_OK);
}

static inline dm_result test_call_save(test_stage* s) {
    return dm_object_save(s->w->context, s->own, s->out.blob, sizeof s->out.blob, &s->out.size);
}

static inline dm_result test_call_load(test_stage* s) {
    return dm_object_load(s->w->context, s->saved, s->saved_size, s->w->model, &s->out.handle);
}

static inline void test_before_object_destroy(test_stage* s) {
    assert_int_equal(dm_object_load(s->w->context, s->saved, s->saved_size, 0, &s->spare), DM_OK);
}

static inline dm_result test_call_object_destroy(test_stage* s) {
    return dm_object_destroy(s->w->context, s->spare);
}

static inline dm_result test_call_get_info(test_stage* s) {
    return dm_object_get_info(s->w->context, s->object, &s->out.object);
}

static inline dm_result test_call_get_part(test_stage* s) {
    return dm_object_get_part(s->w->context, s->object, 0, &s->out.part);
}

static inline dm_result test_call_get_joint(test_stage* s) {
    return dm_object_get_joint(s->w->context, s->object, TEST_DOOR, &s->out.joint);
}

static inline dm_result test_call_get_hypotheses(test_stage* s) {
    const dm_drag_hint pull = test_pull();
    return dm_object_get_hypotheses(s->w->context, s->object, TEST_DOOR, &pull, s->out.joints, DM_MAX_HYPOTHESES,
                                    &s->out.count);
}

static inline dm_result test_call_refine(test_stage* s) {
    const dm_drag_hint pull = test_pull();
    return dm_object_refine(s->w->context, s->own, TEST_DOOR, &pull);
}

static inline dm_result test_call_set_joint(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_object_set_joint(s->w->context, s->own, TEST_DOOR, &hinge);
}

static inline dm_result test_call_reset_joint(test_stage* s) {
    return dm_object_reset_joint(s->w->context, s->own, TEST_DOOR);
}

static inline dm_result test_call_set_links(test_stage* s) {
    const dm_link link = {.driver = TEST_HANDLE, .driven = TEST_DOOR, .kind = DM_LINK_FREES, .from = 0.5f};
    return dm_object_set_links(s->w->context, s->own, &link, 1);
}

static inline void test_after_set_links(test_stage* s) {
    assert_int_equal(dm_object_set_links(s->w->context, s->own, NULL, 0), DM_OK);
}

static inline dm_result test_call_follow_links(test_stage* s) {
    s->out.values[0] = 0.2f, s->out.values[1] = 0.1f;
    return dm_object_follow_links(s->w->context, s->own, TEST_HANDLE, s->out.values, s->out.held, TEST_STAGE_PARTS);
}

/* ---- joints and poses as values ---- */

static inline dm_pose test_some_pose(void) {
    const dm_joint hinge = test_hinge();
    dm_pose pose;
    assert_int_equal(dm_joint_pose(&hinge, 0.4f, &pose), DM_OK);
    return pose;
}

static inline dm_result test_call_joint_pose(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_pose(&hinge, 0.4f, &s->out.pose);
}

static inline dm_result test_call_joint_value(test_stage* s) {
    const dm_joint hinge = test_hinge();
    const dm_pose pose = test_some_pose();
    return dm_joint_value(&hinge, &pose, &s->out.value, &s->out.angle, &s->out.distance);
}

static inline dm_result test_call_joint_value_at(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_value_at(&hinge, 0.3f, &s->out.value);
}

static inline dm_result test_call_joint_get_frame(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_get_frame(&hinge, &s->out.frame);
}

static inline dm_result test_call_joint_scale(test_stage* s) {
    const dm_joint hinge = test_hinge();
    return dm_joint_scale(&hinge, (dm_vec3){1, 2, -3}, &s->out.joint);
}

static inline dm_result test_call_pose_multiply(test_stage* s) {
    const dm_pose pose = test_some_pose();
    dm_pose_multiply(&pose, &pose, &s->out.pose);
    return DM_OK;
}

static inline dm_result test_call_pose_inverse(test_stage* s) {
    const dm_pose pose = test_some_pose();
    dm_pose_inverse(&pose, &s->out.pose);
    return DM_OK;
}

static inline dm_result test_call_pose_from_rotation(test_stage* s) {
    return dm_pose_from_rotation((const float[4]){0, 3, 0, 4}, (dm_vec3){1, 2, 3}, &s->out.pose);
}

static inline dm_result test_call_pose_to_matrix(test_stage* s) {
    const dm_pose pose = test_some_pose();
    dm_pose_to_matrix(&pose, s->out.matrix);
    return DM_OK;
}

static inline dm_result test_call_pose_apply_points(test_stage* s) {
    const dm_pose pose = test_some_pose();
    const float points[2][3] = {{0, 0, 0}, {1, 2, 3}};
    dm_pose_apply_points(&pose, points[0], 0, s->out.points[0], 0, 2);
    return DM_OK;
}

/* ---- motions ---- */

static inline dm_result test_call_motion_generate(test_stage* s) {
    const dm_vec3 path[3] = {test_pull().point, {0.85f, 0.5f, 1.2f}, {0.7f, 0.5f, 1.5f}};
    const dm_motion_desc desc = {.struct_size = sizeof desc,
                                 .part_id = TEST_DOOR,
                                 .drag = test_pull(),
                                 .path = path,
                                 .path_count = 3,
                                 .seed = 5};
    return dm_motion_generate(s->w->context, s->object, &desc, &s->out.handle);
}

static inline void test_after_motion(test_stage* s) {
    assert_int_equal(dm_motion_destroy(s->w->context, s->out.handle), DM_OK);
}

static inline dm_result test_call_motion_sample(test_stage* s) {
    return dm_motion_sample(s->w->context, s->motion, 0.37f, &s->out.pose, &s->out.value);
}

static inline dm_result test_call_motion_get_frames(test_stage* s) {
    return dm_motion_get_frames(s->w->context, s->motion, s->out.poses, s->out.values);
}

static inline void test_before_motion_destroy(test_stage* s) {
    const dm_motion_desc desc = {.struct_size = sizeof desc, .part_id = TEST_DOOR, .drag = test_pull()};
    assert_int_equal(dm_motion_generate(s->w->context, s->object, &desc, &s->spare_one), DM_OK);
}

static inline dm_result test_call_motion_destroy(test_stage* s) {
    return dm_motion_destroy(s->w->context, s->spare_one);
}

/* ---- drags ---- */

static inline dm_result test_call_drag_begin(test_stage* s) {
    const float snaps[3] = {0.2f, 0.5f, 0.9f};
    const dm_drag_rules rules = {.struct_size = sizeof rules, .snaps = snaps, .snap_count = 3};
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .object = s->object,
                               .part_id = TEST_DOOR,
                               .grab_point = test_pull().point,
                               .rules = &rules};
    return dm_drag_begin(s->w->context, &desc, &s->out.handle);
}

static inline void test_after_drag(test_stage* s) {
    assert_int_equal(dm_drag_end(s->w->context, s->out.handle, NULL), DM_OK);
}

/* To and fro along the door's way, and off it to all sides, so that a drag looks for other joints too. */
static inline dm_ray test_next_ray(test_stage* s) {
    const dm_joint hinge = test_hinge();
    const float angle = 0.1f * (float)s->frame++;
    dm_vec3 point = test_point_on(&hinge, 0.6f + 0.5f * sinf(angle));
    point.y += 0.3f * sinf(0.31f * angle), point.x += 0.3f * sinf(0.23f * angle);
    return test_ray_to(point);
}

static inline dm_result test_call_drag_update(test_stage* s) {
    const dm_ray ray = test_next_ray(s);
    return dm_drag_update(s->w->context, s->drag, &ray, 1.0f / 60, &s->out.state);
}

static inline dm_result test_call_drag_update_released(test_stage* s) {
    return dm_drag_update(s->w->context, s->released, NULL, 1.0f / 60, &s->out.state);
}

static inline dm_result test_call_drag_step(test_stage* s) {
    dm_drag_input input = dm_drag_input_default();
    input.hand.kind = DM_HAND_RAY, input.hand.ray = test_next_ray(s);
    input.second.kind = DM_HAND_POINT, input.second.point = input.second.grab_point = test_pull().point;
    input.lower = -0.1f, input.upper = 1.2f;
    return dm_drag_step(s->w->context, s->drag, &input, 1.0f / 60, &s->out.state);
}

static inline dm_result test_call_drag_step_rate(test_stage* s) {
    dm_drag_input input = dm_drag_input_default();
    input.hand.kind = DM_HAND_RATE, input.hand.amount = 0.3f;
    input.flags = DM_INPUT_ASK;
    return dm_drag_step(s->w->context, s->without_point, &input, 1.0f / 60, &s->out.state);
}

static inline dm_result test_call_drag_take(test_stage* s) {
    const dm_result asked = test_call_drag_step_rate(s);
    return asked == DM_OK ? dm_drag_take(s->w->context, s->without_point, 0.01f, &s->out.state) : asked;
}

static inline void test_before_drag_end(test_stage* s) {
    s->spare_one = test_stage_drag(s, 0, NULL);
    test_stage_pull(s, s->spare_one);
}

static inline dm_result test_call_drag_release(test_stage* s) {
    return dm_drag_release(s->w->context, s->spare_one, NULL, &s->out.plan);
}

static inline void test_after_drag_release(test_stage* s) {
    assert_int_equal(dm_drag_end(s->w->context, s->spare_one, NULL), DM_OK);
}

static inline dm_result test_call_drag_end(test_stage* s) {
    return dm_drag_end(s->w->context, s->spare_one, &s->out.part_state);
}

static inline dm_result test_call_drag_get_part_state(test_stage* s) {
    return dm_drag_get_part_state(s->w->context, s->drag, &s->out.part_state);
}

static inline dm_result test_call_drag_snapshot_size(test_stage* s) {
    s->out.size = dm_drag_snapshot_size();
    return DM_OK;
}

static inline dm_result test_call_drag_save(test_stage* s) {
    return dm_drag_save(s->w->context, s->drag, s->snapshot, sizeof s->snapshot);
}

static inline dm_result test_call_drag_restore(test_stage* s) {
    return dm_drag_restore(s->w->context, s->drag, s->snapshot, sizeof s->snapshot);
}

/* ---- camera and scenes ---- */

static inline dm_result test_call_camera_ray(test_stage* s) {
    const dm_camera camera = {.struct_size = sizeof camera,
                              .fov_y = 1,
                              .eye = test_camera,
                              .forward = {-1, -0.5f, -2},
                              .up = {0, 1, 0},
                              .viewport_width = 800,
                              .viewport_height = 600};
    return dm_camera_ray(s->w->context, &camera, 410, 290, &s->out.ray);
}

static inline dm_result test_call_scene_create(test_stage* s) {
    const dm_scene_desc desc = dm_scene_desc_default();
    return dm_scene_create(s->w->context, &desc, &s->out.handle);
}

static inline void test_after_scene_create(test_stage* s) {
    assert_int_equal(dm_scene_destroy(s->w->context, s->out.handle), DM_OK);
}

static inline void test_before_scene(test_stage* s) {
    const dm_scene_desc desc = dm_scene_desc_default();
    assert_int_equal(dm_scene_create(s->w->context, &desc, &s->spare_one), DM_OK);
    assert_int_equal(dm_scene_add(s->w->context, s->spare_one, s->object, NULL, &s->spare_instance), DM_OK);
}

static inline void test_after_scene(test_stage* s) {
    assert_int_equal(dm_scene_destroy(s->w->context, s->spare_one), DM_OK);
}

static inline dm_result test_call_scene_destroy(test_stage* s) {
    return dm_scene_destroy(s->w->context, s->spare_one);
}

static inline dm_result test_call_scene_add(test_stage* s) {
    return dm_scene_add(s->w->context, s->spare_one, s->object, NULL, &s->out.instance);
}

static inline dm_result test_call_scene_remove(test_stage* s) {
    return dm_scene_remove(s->w->context, s->spare_one, s->spare_instance);
}

static inline dm_result test_call_scene_move(test_stage* s) {
    const dm_pose pose = test_some_pose();
    return dm_scene_move(s->w->context, s->scene, s->instance, TEST_HANDLE, &pose);
}

static inline dm_result test_call_scene_commit(test_stage* s) {
    const dm_result moved = test_call_scene_move(s);
    return moved == DM_OK ? dm_scene_commit(s->w->context, s->scene) : moved;
}

static inline dm_result test_call_scene_commit_first(test_stage* s) {
    return dm_scene_commit(s->w->context, s->spare_one);
}

static inline dm_result test_call_scene_pick(test_stage* s) {
    const dm_ray ray = {{0.31f, 0.42f, 5}, {0.001f, 0, -1}};
    return dm_scene_pick(s->w->context, s->scene, &ray, &s->out.hit);
}

/* ---- assets ---- */

static inline dm_result test_call_asset_create(test_stage* s) {
    return test_stage_asset(s, &s->out.handle);
}

static inline void test_after_asset(test_stage* s) {
    assert_int_equal(dm_asset_destroy(s->w->context, s->out.handle), DM_OK);
}

static inline void test_before_asset_destroy(test_stage* s) {
    assert_int_equal(test_stage_asset(s, &s->spare_one), DM_OK);
}

static inline dm_result test_call_asset_destroy(test_stage* s) {
    return dm_asset_destroy(s->w->context, s->spare_one);
}

static inline dm_result test_call_asset_get_info(test_stage* s) {
    return dm_asset_get_info(s->w->context, s->asset, &s->out.asset);
}

static inline dm_result test_call_asset_get_part(test_stage* s) {
    return dm_asset_get_part(s->w->context, s->asset, 0, &s->out.asset_part);
}

static inline dm_result test_call_asset_get_joint(test_stage* s) {
    return dm_asset_get_joint(s->w->context, s->asset, 0, &s->out.joint);
}

static inline dm_result test_call_asset_get_part_nodes(test_stage* s) {
    return dm_asset_get_part_nodes(s->w->context, s->asset, 0, s->out.asset_nodes, TEST_STAGE_NODES);
}

static inline dm_result test_call_asset_get_node_parts(test_stage* s) {
    return dm_asset_get_node_parts(s->w->context, s->asset, s->out.asset_nodes, TEST_STAGE_NODES);
}

static inline dm_result test_call_asset_make_object(test_stage* s) {
    return dm_asset_make_object(s->w->context, s->asset, &s->out.handle);
}

/* ---- glTF ---- */

static inline dm_result test_call_gltf_open(test_stage* s) {
    const dm_gltf_desc desc = test_stage_gltf_desc(s);
    return dm_gltf_open(&desc, &s->out.gltf);
}

static inline dm_result test_call_gltf_open_file(test_stage* s) {
    dm_gltf_desc desc = test_stage_gltf_desc(s);
    desc.data = NULL, desc.size = 0;
    return dm_gltf_open_file(s->path, &desc, &s->out.gltf);
}

static inline void test_after_gltf_open(test_stage* s) {
    dm_gltf_close(s->out.gltf);
}

/* What a file keeps once it has been asked (images, the text of an export) is kept by this one, and not the stage's. */
static inline void test_before_gltf(test_stage* s) {
    const dm_gltf_desc desc = test_stage_gltf_desc(s);
    assert_int_equal(dm_gltf_open(&desc, (dm_gltf**)&s->spare_bytes), DM_OK);
}

static inline void test_after_gltf(test_stage* s) {
    dm_gltf_close(s->spare_bytes);
}

static inline dm_result test_call_gltf_close(test_stage* s) {
    dm_gltf_close(s->spare_bytes);
    return DM_OK;
}

static inline dm_result test_call_gltf_node_count(test_stage* s) {
    s->out.count = dm_gltf_node_count(s->gltf);
    return DM_OK;
}

static inline dm_result test_call_gltf_get_node(test_stage* s) {
    return dm_gltf_get_node(s->gltf, 1, &s->out.node);
}

static inline dm_result test_call_gltf_get_mesh(test_stage* s) {
    return dm_gltf_get_mesh(s->gltf, &s->out.mesh);
}

static inline dm_result test_call_gltf_get_origin(test_stage* s) {
    dm_gltf_get_origin(s->gltf, s->out.origin);
    return DM_OK;
}

static inline dm_result test_call_gltf_surface_count(test_stage* s) {
    s->out.count = dm_gltf_surface_count(s->gltf);
    return DM_OK;
}

static inline dm_result test_call_gltf_get_surface(test_stage* s) {
    return dm_gltf_get_surface(s->spare_bytes, 1, &s->out.surface);
}

static inline dm_result test_call_gltf_get_texture_coordinates(test_stage* s) {
    return dm_gltf_get_texture_coordinates(s->spare_bytes, 1, s->out.uv[0][0], 6);
}

static inline dm_result test_call_gltf_mark_faces(test_stage* s) {
    static const char* const door = "door";
    return dm_gltf_mark_faces(s->gltf, &door, 1, 1, s->out.faces, 4);
}

static inline dm_result test_call_gltf_get_pivot_kind(test_stage* s) {
    int32_t kind;
    return dm_gltf_get_pivot_kind(s->gltf, "door", &kind);
}

static inline dm_result test_call_gltf_get_hints(test_stage* s) {
    return dm_gltf_get_hints(s->gltf, "door", s->out.label, sizeof s->out.label, &s->out.pivot);
}

static inline dm_result test_call_gltf_get_asset(test_stage* s) {
    const dm_asset_node* nodes;
    return dm_gltf_get_asset(s->spare_bytes, 0, &nodes, &s->out.count);
}

static inline dm_result test_call_gltf_get_asset_node(test_stage* s) {
    return dm_gltf_get_asset_node(s->spare_bytes, 0, &s->out.count);
}

/* ---- rigged assets as files ---- */

/* A body of which nothing moves. */
static inline dm_result test_make_rig(test_stage* s, dm_gltf_rig** out_rig) {
    dm_mesh_desc mesh = s->mesh;
    mesh.part_ids = NULL, mesh.part_id_bytes = 0;
    dm_asset_node node = dm_asset_node_default();
    node.parent = DM_ASSET_NO_NODE, node.name = "body", node.mesh = &mesh;
    const uint32_t part = DM_ASSET_NO_PART;
    const dm_gltf_rig_desc desc = {.struct_size = sizeof desc,
                                   .formats = DM_GLTF_RIG_URDF,
                                   .nodes = &node,
                                   .node_count = 1,
                                   .node_parts = &part,
                                   .allocator = test_stage_gltf_desc(s).allocator};
    return dm_gltf_rig_make(&desc, out_rig);
}

static inline void test_before_rig(test_stage* s) {
    assert_int_equal(test_make_rig(s, (dm_gltf_rig**)&s->spare_bytes), DM_OK);
}

static inline void test_after_rig(test_stage* s) {
    dm_gltf_rig_destroy(s->spare_bytes);
}

static inline dm_result test_call_gltf_rig_make(test_stage* s) {
    return test_make_rig(s, (dm_gltf_rig**)&s->spare_bytes);
}

static inline dm_result test_call_gltf_rig_destroy(test_stage* s) {
    dm_gltf_rig_destroy(s->spare_bytes);
    return DM_OK;
}

static inline dm_result test_call_gltf_rig_file_count(test_stage* s) {
    s->out.count = dm_gltf_rig_file_count(s->spare_bytes);
    return DM_OK;
}

static inline dm_result test_call_gltf_rig_get_file(test_stage* s) {
    dm_gltf_rig_file file;
    return dm_gltf_rig_get_file(s->spare_bytes, 0, &file);
}

static inline dm_result test_call_gltf_left_out(test_stage* s) {
    s->out.scope = dm_gltf_left_out(s->gltf);
    return DM_OK;
}

static inline dm_result test_call_gltf_pivots_are_lost(test_stage* s) {
    s->out.scope = dm_gltf_pivots_are_lost(s->gltf);
    return DM_OK;
}

static inline dm_result test_call_gltf_read_mask(test_stage* s) {
    static const char mask[] = "[0, 0, 1, 1]";
    return dm_gltf_read_mask(s->gltf, mask, strlen(mask), NULL, s->out.faces, &s->out.scope, &s->out.ambiguous);
}

static inline dm_result test_call_gltf_export(test_stage* s) {
    static const uint8_t moving[4] = {0, 0, 1, 1};
    const dm_pose poses[2] = {{.real = {0, 0, 0, 1}}, test_some_pose()};
    const float times[2] = {0, 1};
    const dm_gltf_track track = {
        .name = "door", .face_ids = moving, .value = 1, .poses = poses, .times = times, .key_count = 2};
    return dm_gltf_export(s->spare_bytes, &track, 1, &s->out.data, &s->out.size);
}

static inline void test_after_gltf_export(test_stage* s) {
    dm_gltf_release_bytes(s->spare_bytes, s->out.data, s->out.size);
}

static inline void test_before_gltf_release_bytes(test_stage* s) {
    test_before_gltf(s);
    assert_int_equal(test_call_gltf_export(s), DM_OK);
}

static inline dm_result test_call_gltf_release_bytes(test_stage* s) {
    dm_gltf_release_bytes(s->spare_bytes, s->out.data, s->out.size);
    return DM_OK;
}

static inline dm_result test_call_gltf_write(test_stage* s) {
    const float positions[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const uint32_t corners[3] = {0, 1, 2};
    const dm_gltf_part part = {.name = "part",
                               .positions = positions[0],
                               .indices = corners,
                               .vertex_count = 3,
                               .index_count = 3,
                               .colour = {1, 1, 1, 1}};
    return dm_gltf_write(&part, 1, &s->w->desc.allocator, &s->w->desc.log, &s->out.data, &s->out.size);
}

static inline void test_after_gltf_write(test_stage* s) {
    const dm_allocator* a = &s->w->desc.allocator;
    if (a->release != NULL)
        a->release(a->user, s->out.data, s->out.size);
    else
        free(s->out.data);
}

static inline dm_result test_call_gltf_version(test_stage* s) {
    s->out.size = dm_gltf_version();
    assert_true(s->out.size == DM_VERSION && dm_version() == DM_VERSION);
    return DM_OK;
}

static inline dm_result test_call_gltf_mend_text(test_stage* s) {
    strcpy(s->out.label, "T\xfcr");
    s->out.size = dm_gltf_mend_text(s->out.label);
    return DM_OK;
}

/* ---- all of them ---- */

static const test_call test_calls[] = {
    {"dm_result_string", NULL, NULL, test_call_result_string, NULL, NULL},
    {"dm_version", NULL, NULL, test_call_version, NULL, NULL},
    {"dm_get_interface", NULL, NULL, test_call_get_interface, NULL, NULL},
    {"dm_context_create", NULL, NULL, test_call_context_create, test_after_context_create, NULL},
    {"dm_context_destroy", NULL, test_before_context_destroy, test_call_context_destroy, NULL, NULL},
    {"dm_context_get_memory", NULL, NULL, test_call_context_get_memory, NULL, NULL},
    {"dm_context_trim", NULL, test_before_context_trim, test_call_context_trim, NULL, NULL},
    {"dm_model_load", NULL, NULL, test_call_model_load, test_after_model_load, NULL},
    {"dm_model_unload", NULL, test_before_model_unload, test_call_model_unload, NULL, NULL},
    {"dm_mesh_find_part", "of sheets", NULL, test_call_find_part, NULL, NULL},
    {"dm_mesh_find_part", "of pieces", NULL, test_call_find_part_of_pieces, NULL, NULL},
    {"dm_object_prepare", "with all weights", NULL, test_call_prepare, test_after_object, NULL},
    {"dm_object_prepare", "by rules", NULL, test_call_prepare_by_rules, test_after_object, NULL},
    {"dm_object_prepare", "network alone", NULL, test_call_prepare_by_network, test_after_object, NULL},
    {"dm_object_prepare", "with all evidence", NULL, test_call_prepare_with_all, test_after_object, NULL},
    {"dm_object_save", NULL, NULL, test_call_save, NULL, NULL},
    {"dm_object_load", NULL, NULL, test_call_load, test_after_object, NULL},
    {"dm_object_destroy", NULL, test_before_object_destroy, test_call_object_destroy, NULL, NULL},
    {"dm_object_get_info", NULL, NULL, test_call_get_info, NULL, NULL},
    {"dm_object_get_part", NULL, NULL, test_call_get_part, NULL, NULL},
    {"dm_object_get_joint", NULL, NULL, test_call_get_joint, NULL, NULL},
    {"dm_object_get_hypotheses", NULL, NULL, test_call_get_hypotheses, NULL, NULL},
    {"dm_object_refine", NULL, NULL, test_call_refine, NULL, NULL},
    {"dm_object_set_joint", NULL, NULL, test_call_set_joint, NULL, NULL},
    {"dm_object_reset_joint", NULL, NULL, test_call_reset_joint, NULL, NULL},
    {"dm_object_set_links", NULL, NULL, test_call_set_links, test_after_set_links, NULL},
    {"dm_object_follow_links", NULL, NULL, test_call_follow_links, NULL, NULL},
    {"dm_joint_pose", NULL, NULL, test_call_joint_pose, NULL, NULL},
    {"dm_joint_value", NULL, NULL, test_call_joint_value, NULL, NULL},
    {"dm_joint_value_at", NULL, NULL, test_call_joint_value_at, NULL, NULL},
    {"dm_joint_get_frame", NULL, NULL, test_call_joint_get_frame, NULL, NULL},
    {"dm_joint_scale", NULL, NULL, test_call_joint_scale, NULL, NULL},
    {"dm_motion_generate", NULL, NULL, test_call_motion_generate, test_after_motion, NULL},
    {"dm_motion_sample", NULL, NULL, test_call_motion_sample, NULL, NULL},
    {"dm_motion_get_frames", NULL, NULL, test_call_motion_get_frames, NULL, NULL},
    {"dm_motion_destroy", NULL, test_before_motion_destroy, test_call_motion_destroy, NULL, NULL},
    {"dm_drag_begin", NULL, NULL, test_call_drag_begin, test_after_drag, NULL},
    {"dm_drag_update", "held", NULL, test_call_drag_update, NULL, NULL},
    {"dm_drag_update", "released", NULL, test_call_drag_update_released, NULL, NULL},
    {"dm_drag_step", "two hands", NULL, test_call_drag_step, NULL, NULL},
    {"dm_drag_step", "by a stick", NULL, test_call_drag_step_rate, NULL, NULL},
    {"dm_drag_take", NULL, NULL, test_call_drag_take, NULL, NULL},
    {"dm_drag_release", NULL, test_before_drag_end, test_call_drag_release, NULL, test_after_drag_release},
    {"dm_drag_end", NULL, test_before_drag_end, test_call_drag_end, NULL, NULL},
    {"dm_drag_get_part_state", NULL, NULL, test_call_drag_get_part_state, NULL, NULL},
    {"dm_drag_snapshot_size", NULL, NULL, test_call_drag_snapshot_size, NULL, NULL},
    {"dm_drag_save", NULL, NULL, test_call_drag_save, NULL, NULL},
    {"dm_drag_restore", NULL, NULL, test_call_drag_restore, NULL, NULL},
    {"dm_pose_multiply", NULL, NULL, test_call_pose_multiply, NULL, NULL},
    {"dm_pose_inverse", NULL, NULL, test_call_pose_inverse, NULL, NULL},
    {"dm_pose_from_rotation", NULL, NULL, test_call_pose_from_rotation, NULL, NULL},
    {"dm_pose_to_matrix", NULL, NULL, test_call_pose_to_matrix, NULL, NULL},
    {"dm_pose_apply_points", NULL, NULL, test_call_pose_apply_points, NULL, NULL},
    {"dm_camera_ray", NULL, NULL, test_call_camera_ray, NULL, NULL},
    {"dm_scene_create", NULL, NULL, test_call_scene_create, test_after_scene_create, NULL},
    {"dm_scene_destroy", NULL, test_before_scene, test_call_scene_destroy, NULL, NULL},
    {"dm_scene_add", NULL, test_before_scene, test_call_scene_add, NULL, test_after_scene},
    {"dm_scene_move", NULL, NULL, test_call_scene_move, NULL, NULL},
    {"dm_scene_remove", NULL, test_before_scene, test_call_scene_remove, NULL, test_after_scene},
    {"dm_scene_commit", "after a move", NULL, test_call_scene_commit, NULL, NULL},
    {"dm_scene_commit", "the first", test_before_scene, test_call_scene_commit_first, NULL, test_after_scene},
    {"dm_scene_pick", NULL, NULL, test_call_scene_pick, NULL, NULL},
    {"dm_asset_create", NULL, NULL, test_call_asset_create, test_after_asset, NULL},
    {"dm_asset_destroy", NULL, test_before_asset_destroy, test_call_asset_destroy, NULL, NULL},
    {"dm_asset_get_info", NULL, NULL, test_call_asset_get_info, NULL, NULL},
    {"dm_asset_get_part", NULL, NULL, test_call_asset_get_part, NULL, NULL},
    {"dm_asset_get_joint", NULL, NULL, test_call_asset_get_joint, NULL, NULL},
    {"dm_asset_get_part_nodes", NULL, NULL, test_call_asset_get_part_nodes, NULL, NULL},
    {"dm_asset_get_node_parts", NULL, NULL, test_call_asset_get_node_parts, NULL, NULL},
    {"dm_asset_make_object", NULL, NULL, test_call_asset_make_object, test_after_object, NULL},
    {"dm_gltf_open", NULL, NULL, test_call_gltf_open, test_after_gltf_open, NULL},
    {"dm_gltf_open_file", NULL, NULL, test_call_gltf_open_file, test_after_gltf_open, NULL},
    {"dm_gltf_close", NULL, test_before_gltf, test_call_gltf_close, NULL, NULL},
    {"dm_gltf_node_count", NULL, NULL, test_call_gltf_node_count, NULL, NULL},
    {"dm_gltf_get_node", NULL, NULL, test_call_gltf_get_node, NULL, NULL},
    {"dm_gltf_get_mesh", NULL, NULL, test_call_gltf_get_mesh, NULL, NULL},
    {"dm_gltf_get_origin", NULL, NULL, test_call_gltf_get_origin, NULL, NULL},
    {"dm_gltf_surface_count", NULL, NULL, test_call_gltf_surface_count, NULL, NULL},
    {"dm_gltf_get_surface", NULL, test_before_gltf, test_call_gltf_get_surface, NULL, test_after_gltf},
    {"dm_gltf_get_texture_coordinates", NULL, test_before_gltf, test_call_gltf_get_texture_coordinates, NULL,
     test_after_gltf},
    {"dm_gltf_mark_faces", NULL, NULL, test_call_gltf_mark_faces, NULL, NULL},
    {"dm_gltf_get_hints", NULL, NULL, test_call_gltf_get_hints, NULL, NULL},
    {"dm_gltf_get_pivot_kind", NULL, NULL, test_call_gltf_get_pivot_kind, NULL, NULL},
    {"dm_gltf_get_asset", NULL, test_before_gltf, test_call_gltf_get_asset, NULL, test_after_gltf},
    {"dm_gltf_get_asset_node", NULL, test_before_gltf, test_call_gltf_get_asset_node, NULL, test_after_gltf},
    {"dm_gltf_left_out", NULL, NULL, test_call_gltf_left_out, NULL, NULL},
    {"dm_gltf_pivots_are_lost", NULL, NULL, test_call_gltf_pivots_are_lost, NULL, NULL},
    {"dm_gltf_read_mask", NULL, NULL, test_call_gltf_read_mask, NULL, NULL},
    {"dm_gltf_export", NULL, test_before_gltf, test_call_gltf_export, test_after_gltf_export, test_after_gltf},
    {"dm_gltf_release_bytes", NULL, test_before_gltf_release_bytes, test_call_gltf_release_bytes, NULL,
     test_after_gltf},
    {"dm_gltf_write", NULL, NULL, test_call_gltf_write, test_after_gltf_write, NULL},
    {"dm_gltf_version", NULL, NULL, test_call_gltf_version, NULL, NULL},
    {"dm_gltf_rig_make", NULL, NULL, test_call_gltf_rig_make, test_after_rig, NULL},
    {"dm_gltf_rig_destroy", NULL, test_before_rig, test_call_gltf_rig_destroy, NULL, NULL},
    {"dm_gltf_rig_file_count", NULL, test_before_rig, test_call_gltf_rig_file_count, NULL, test_after_rig},
    {"dm_gltf_rig_get_file", NULL, test_before_rig, test_call_gltf_rig_get_file, NULL, test_after_rig},
    {"dm_gltf_mend_text", NULL, NULL, test_call_gltf_mend_text, NULL, NULL},
};
enum { TEST_CALLS = sizeof test_calls / sizeof *test_calls };

static inline bool test_call_is_of(const test_call* call, const cJSON* function) {
    return strcmp(call->function, cJSON_GetStringValue(cJSON_GetObjectItem(function, "name"))) == 0;
}

/* The description of the interface; cJSON_Delete. */
static inline cJSON* test_interface(void) {
    size_t size;
    char* text = test_read_file("bindings/dragmesh_api.json", &size);
    cJSON* interface = cJSON_ParseWithLength(text, size);
    assert_non_null(interface);
    free(text);
    return interface;
}

/* Fails where a function has no row, or a row no function. */
static inline void test_calls_check(void) {
    cJSON* interface = test_interface();
    const cJSON *functions = cJSON_GetObjectItem(interface, "functions"), *function;
    bool known[TEST_CALLS] = {false};
    cJSON_ArrayForEach(function, functions) {
        bool found = false;
        for (int i = 0; i < TEST_CALLS; i++) {
            if (!test_call_is_of(&test_calls[i], function)) continue;
            found = known[i] = true;
        }
        if (!found)
            fail_msg("%s has no row in test_calls.h", cJSON_GetStringValue(cJSON_GetObjectItem(function, "name")));
    }
    for (int i = 0; i < TEST_CALLS; i++) {
        if (!known[i]) fail_msg("%s of test_calls.h is no public function", test_calls[i].function);
    }
    cJSON_Delete(interface);
}

/* Whether the header gives a call's function this threading tag. */
static inline bool test_call_is_tagged(const cJSON* interface, const test_call* call, const char* tag) {
    const cJSON* function;
    cJSON_ArrayForEach(function, cJSON_GetObjectItem(interface, "functions")) {
        if (test_call_is_of(call, function))
            return strcmp(cJSON_GetStringValue(cJSON_GetObjectItem(function, "threads")), tag) == 0;
    }
    return false;
}

#endif
