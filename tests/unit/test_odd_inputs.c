/* Odd numbers in what is not a drag: cameras, poses, joints as values, a host's joint in force, links, scenes, meshes.
 * Whatever is taken gives finite numbers and unit directions, and what one function gives the next one takes. */
#include <math.h>
#include <stdbool.h>

#include "math/linear3.h"
#include "test_odd.h"
#include "test_snapshot.h"
#include "test_world.h"

enum {
    CAMERAS = 20000,
    POSES = 20000,
    JOINTS = 20000,
    JOINTS_IN_FORCE = 500,
    LINKED = 5000,
    SCENES = 400,
    MESHES = 150
};

/* Of `tried` inputs at least one in ten must have been taken: refusals alone would show nothing. */
static void expect_taken(int taken, int tried) {
    if (taken < tried / 10) fail_msg("only %d of %d were taken", taken, tried);
}

/* A number that is odd once in three times. */
static float mild(dmi_random* random) {
    return test_once_in(random, 3) ? test_odd(random) : 0.1f * (float)(dmi_random_u32(random) % 20) - 1;
}

static dm_vec3 mild_vector(dmi_random* random) {
    const float x = mild(random), y = mild(random), z = mild(random);
    return (dm_vec3){x, y, z};
}

static dm_joint odd_joint(dmi_random* random) {
    dm_joint joint = test_hinge();
    joint.type = (int32_t)(dmi_random_u32(random) % 6);
    if (test_once_in(random, 3)) joint.axis = test_odd_vector(random);
    if (test_once_in(random, 3)) joint.origin = test_odd_vector(random);
    if (test_once_in(random, 2)) joint.pitch = test_odd(random);
    const float a = mild(random), b = mild(random);
    if (test_once_in(random, 2)) joint.lower = fminf(a, b), joint.upper = fmaxf(a, b);
    return joint;
}

static void describe(char out[256], const dm_joint* j) {
    snprintf(out, 256, "type %d, axis %g %g %g, origin %g %g %g, pitch %g, limits %g %g", j->type, j->axis.x, j->axis.y,
             j->axis.z, j->origin.x, j->origin.y, j->origin.z, j->pitch, j->lower, j->upper);
}

static void odd_cameras_give_finite_rays(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    int taken = 0;
    for (int i = 0; i < CAMERAS; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 2);
        dm_camera camera = dm_camera_default();
        dm_ray ray;
        camera.eye = test_odd_vector(&random);
        camera.forward = test_once_in(&random, 2) ? (dm_vec3){0, 0, -1} : test_odd_vector(&random);
        camera.up = test_once_in(&random, 2) ? (dm_vec3){0, 1, 0} : test_odd_vector(&random);
        camera.fov_y = test_odd(&random), camera.ortho_height = test_odd(&random);
        camera.viewport_width = test_odd(&random), camera.viewport_height = test_odd(&random);
        const float x = test_odd(&random), y = test_odd(&random);
        if (dm_camera_ray(w.context, &camera, x, y, &ray) != DM_OK) continue;
        taken++;
        if (!test_is_finite_vector(ray.origin) || !test_is_unit(ray.direction))
            fail_msg("camera %d: from %g %g %g to %g %g %g", i, ray.origin.x, ray.origin.y, ray.origin.z,
                     ray.direction.x, ray.direction.y, ray.direction.z);
    }
    expect_taken(taken, CAMERAS);
    test_world_close(&w);
}

static void expect_sound_frame(const dm_joint* joint, const char* text) {
    dm_joint_frame frame = dm_joint_frame_default();
    if (dm_joint_get_frame(joint, &frame) != DM_OK) return;
    const float numbers[] = {frame.lower, frame.upper, frame.pitch};
    if (!test_is_finite_vector(frame.origin) || !test_are_finite(numbers, 3) || !test_are_finite(frame.rotation, 4) ||
        !test_is_unit(frame.x) || !test_is_unit(frame.y) || !test_is_unit(frame.z))
        fail_msg("%s: its frame", text);
}

static dm_pose pose_within_bounds(dmi_random* random) {
    dm_pose pose;
    for (int i = 0; i < 4; i++) {
        pose.real[i] = fmaxf(fminf(test_odd(random), 1e9f), -1e9f);
        pose.dual[i] = fmaxf(fminf(test_odd(random), 4e9f), -4e9f);
    }
    return pose;
}

/* What returns nothing can't refuse: it promises finite numbers for those within the bounds. */
static void odd_poses_within_bounds_stay_finite(void** state) {
    (void)state;
    for (int i = 0; i < POSES; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 8);
        const dm_pose a = pose_within_bounds(&random), b = pose_within_bounds(&random);
        dm_pose product, back;
        float matrix[16], point[3] = {1e9f, -1e9f, 1e-45f};
        dm_pose_multiply(&a, &b, &product);
        dm_pose_inverse(&a, &back);
        dm_pose_to_matrix(&a, matrix);
        dm_pose_apply_points(&a, point, 0, point, 0, 1);
        if (!test_are_finite(product.real, 4) || !test_are_finite(product.dual, 4) || !test_are_finite(back.real, 4) ||
            !test_are_finite(back.dual, 4) || !test_are_finite(matrix, 16) || !test_are_finite(point, 3))
            fail_msg("pose %d: %g %g %g %g, %g %g %g %g", i, a.real[0], a.real[1], a.real[2], a.real[3], a.dual[0],
                     a.dual[1], a.dual[2], a.dual[3]);
    }
}

/* Of poses that are not too far away, dm_joint_value says how they lie to the joint. */
static void expect_sound_value(const dm_joint* joint, const dm_pose* pose, float value, const char* text) {
    float found, angle, distance;
    if (dm_joint_value(joint, pose, &found, &angle, &distance) != DM_OK) return;
    if (!isfinite(found) || !isfinite(angle) || !isfinite(distance))
        fail_msg("%s at %g: found %g, off by %g rad and %g", text, value, found, angle, distance);
}

static void odd_joints_give_finite_answers(void** state) {
    (void)state;
    int taken = 0, taken_scaled = 0;
    for (int i = 0; i < JOINTS; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 3);
        const dm_joint joint = odd_joint(&random);
        const float value = mild(&random), share = test_odd(&random);
        const dm_vec3 scale = test_odd_vector(&random);
        char text[256];
        dm_pose pose;
        dm_joint scaled = dm_joint_default();
        float at;
        describe(text, &joint);
        const bool poses = dm_joint_pose(&joint, value, &pose) == DM_OK;
        taken += poses;
        if (poses && !test_is_sound_pose(&pose)) fail_msg("%s: its pose at %g", text, value);
        if (poses) expect_sound_value(&joint, &pose, value, text);
        if (dm_joint_value_at(&joint, share, &at) == DM_OK && !isfinite(at)) fail_msg("%s: %g at %g", text, at, share);
        expect_sound_frame(&joint, text);
        if (dm_joint_scale(&joint, scale, &scaled) != DM_OK) continue;
        taken_scaled++;
        if (!test_is_finite_vector(scaled.axis) || !test_is_finite_vector(scaled.origin) || !isfinite(scaled.pitch))
            fail_msg("%s: scaled by %g %g %g", text, scale.x, scale.y, scale.z);
        if (poses && dm_joint_pose(&scaled, 0, &pose) != DM_OK) fail_msg("%s: not taken when scaled", text);
    }
    expect_taken(taken, JOINTS);
    expect_taken(taken_scaled, JOINTS);
}

/* An object is saved, loaded and saved again: the same bytes. */
static void expect_saved_and_loaded(const test_world* w, dm_object object, const char* text) {
    static uint8_t first[1 << 18], second[1 << 18];
    size_t first_size = 0, second_size = 0;
    dm_object loaded = 0;
    assert_int_equal(dm_object_save(w->context, object, first, sizeof first, &first_size), DM_OK);
    if (dm_object_load(w->context, first, first_size, 0, &loaded) != DM_OK)
        fail_msg("%s: not loaded: %s", text, w->messages.text);
    assert_int_equal(dm_object_save(w->context, loaded, second, sizeof second, &second_size), DM_OK);
    assert_int_equal(dm_object_destroy(w->context, loaded), DM_OK);
    assert_int_equal(first_size, second_size);
    assert_memory_equal(first, second, first_size);
}

static void a_joint_in_force_can_be_saved_and_dragged(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    int taken = 0;
    for (int i = 0; i < JOINTS_IN_FORCE; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 4);
        const dm_joint joint = odd_joint(&random);
        dm_joint in_force = dm_joint_default();
        char text[256];
        const dm_drag_desc desc = {
            .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .grab_point = test_pull().point};
        dm_drag drag;
        describe(text, &joint);
        if (dm_object_set_joint(w.context, object, TEST_DOOR, &joint) != DM_OK) continue;
        taken++;
        assert_int_equal(dm_object_get_joint(w.context, object, TEST_DOOR, &in_force), DM_OK);
        if (!test_is_finite_joint(&in_force)) fail_msg("%s: in force with another number", text);
        expect_saved_and_loaded(&w, object, text);
        if (dm_drag_begin(w.context, &desc, &drag) != DM_OK) fail_msg("%s: no drag: %s", text, w.messages.text);
        assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    }
    expect_taken(taken, JOINTS_IN_FORCE);
    test_world_close(&w);
}

static void odd_links_move_parts_to_finite_values(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    int taken = 0;
    for (int i = 0; i < LINKED; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 5);
        dm_link link = {.driver = TEST_DOOR, .driven = TEST_HANDLE};
        float values[2];
        link.kind = (int32_t)(dmi_random_u32(&random) % 3);
        link.flags = dmi_random_u32(&random) % 2;
        link.ratio = test_odd(&random), link.offset = test_odd(&random), link.from = test_odd(&random);
        values[0] = test_odd(&random), values[1] = test_odd(&random);
        if (dm_object_set_links(w.context, object, &link, 1) != DM_OK) continue;
        const uint32_t moved = test_once_in(&random, 2) ? TEST_DOOR : TEST_HANDLE;
        if (dm_object_follow_links(w.context, object, moved, values, NULL, 2) != DM_OK) continue;
        taken++;
        if (!test_are_finite(values, 2))
            fail_msg("ratio %g, offset %g, from %g: %g and %g", link.ratio, link.offset, link.from, values[0],
                     values[1]);
    }
    expect_taken(taken, LINKED);
    test_world_close(&w);
}

/* ---- scenes ---- */

static void add_odd_instance(const test_world* w, dmi_random* random, dm_scene scene, dm_object object) {
    const float rotation[4] = {test_odd(random), test_odd(random), test_odd(random), test_odd(random)};
    const dm_joint joint = odd_joint(random);
    const float value = mild(random);
    uint32_t instance;
    dm_pose pose;
    if (dm_pose_from_rotation(rotation, test_odd_vector(random), &pose) != DM_OK) return;
    assert_true(test_is_sound_pose(&pose));
    if (dm_scene_add(w->context, scene, object, &pose, &instance) != DM_OK) return;
    if (dm_joint_pose(&joint, value, &pose) == DM_OK) dm_scene_move(w->context, scene, instance, TEST_DOOR, &pose);
}

/* Returns whether something was hit. */
static bool expect_sound_hit(const test_world* w, dm_scene scene, const dm_ray* ray) {
    dm_hit hit = dm_hit_default();
    if (dm_scene_pick(w->context, scene, ray, &hit) != DM_OK) return false;
    const float numbers[] = {hit.distance, hit.u, hit.v};
    if (!test_are_finite(numbers, 3) || !test_is_finite_vector(hit.point) || !test_is_finite_vector(hit.object_point) ||
        !test_is_finite_vector(hit.normal) || (hit.object != 0 && (!test_is_unit(hit.normal) || hit.distance < 0)))
        fail_msg("a ray from %g %g %g along %g %g %g: distance %g, normal %g %g %g", ray->origin.x, ray->origin.y,
                 ray->origin.z, ray->direction.x, ray->direction.y, ray->direction.z, hit.distance, hit.normal.x,
                 hit.normal.y, hit.normal.z);
    return hit.object != 0;
}

static void odd_scenes_give_finite_hits(void** state) {
    (void)state;
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    const dm_object object = test_world_cabinet(&w);
    int hits = 0;
    for (int i = 0; i < SCENES; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 6);
        dm_scene scene;
        uint32_t instance;
        assert_int_equal(dm_scene_create(w.context, &desc, &scene), DM_OK);
        for (int k = 0; k < 3; k++) add_odd_instance(&w, &random, scene, object);
        assert_int_equal(dm_scene_add(w.context, scene, object, NULL, &instance), DM_OK);
        assert_int_equal(dm_scene_commit(w.context, scene), DM_OK);
        for (int k = 0; k < 6; k++) {
            const dm_ray odd = {test_odd_vector(&random), test_odd_vector(&random)},
                         plain = {{0.5f, 0.5f, k > 3 ? 1e9f : 3}, {mild(&random), 0, -1}};
            hits += expect_sound_hit(&w, scene, k % 2 ? &plain : &odd);
        }
        assert_int_equal(dm_scene_destroy(w.context, scene), DM_OK);
    }
    expect_taken(hits, SCENES);
    test_world_close(&w);
}

/* ---- meshes ---- */

/* Scales the cabinet by odd factors, or puts odd numbers among its coordinates. */
static void make_odd(dmi_random* random, test_shape* shape) {
    const int way = (int)(dmi_random_u32(random) % 3);
    const dm_vec3 factor = test_odd_vector(random), offset = mild_vector(random);
    const float factors[3] = {factor.x, way == 0 ? factor.x : factor.y, way == 0 ? factor.x : factor.z};
    for (uint32_t i = 0; i < 3 * shape->vertex_count; i++) {
        float* number = &shape->xyz[i / 3][i % 3];
        if (way < 2) *number *= factors[i % 3];
        if (way == 2 && test_once_in(random, 40)) *number = test_odd(random);
        *number += dmi_xyz(offset).v[i % 3];
    }
}

static void expect_sound_part(const test_world* w, dm_object object, uint32_t index, const char* text) {
    dm_part_info part = dm_part_info_default();
    dm_joint joint = dm_joint_default();
    char joint_text[256];
    assert_int_equal(dm_object_get_part(w->context, object, index, &part), DM_OK);
    assert_int_equal(dm_object_get_joint(w->context, object, part.id, &joint), DM_OK);
    describe(joint_text, &joint);
    if (!test_is_finite_vector(part.centre) || !test_is_finite_vector(part.box_min) ||
        !test_is_finite_vector(part.box_max) || !isfinite(part.area))
        fail_msg("%s: part %u has an area of %g", text, part.id, part.area);
    if (!test_is_finite_joint(&joint)) fail_msg("%s: %s", text, joint_text);
    if (dm_object_set_joint(w->context, object, part.id, &joint) != DM_OK)
        fail_msg("%s: its own joint is refused: %s: %s", text, joint_text, w->messages.text);
}

/* A part that can be dragged is, is put back to where it was saved, and begins again where it ended. */
static int expect_dragged(const test_world* w, dm_object object, const char* text) {
    uint8_t saved[DM_DRAG_SNAPSHOT_MAX];
    dm_part_state end = dm_part_state_default();
    dm_drag_state now = dm_drag_state_default();
    dm_drag_desc desc = {
        .struct_size = sizeof desc, .part_id = TEST_DOOR, .object = object, .flags = DM_DRAG_WITHOUT_POINT};
    dm_drag drag = 0;
    if (dm_drag_begin(w->context, &desc, &drag) != DM_OK) return 0;
    assert_int_equal(dm_drag_release(w->context, drag, NULL, NULL), DM_OK);
    assert_int_equal(dm_drag_update(w->context, drag, NULL, 0.1f, &now), DM_OK);
    if (!test_state_is_finite(&now) || !test_is_sound_pose(&now.pose)) fail_msg("%s: dragged to %g", text, now.value);
    assert_int_equal(dm_drag_save(w->context, drag, saved, sizeof saved), DM_OK);
    if (dm_drag_restore(w->context, drag, saved, dm_drag_snapshot_size()) != DM_OK) fail_msg("%s: not restored", text);
    assert_int_equal(dm_drag_end(w->context, drag, &end), DM_OK);
    desc.state = &end;
    if (dm_drag_begin(w->context, &desc, &drag) != DM_OK) fail_msg("%s: not begun again: %s", text, w->messages.text);
    assert_int_equal(dm_drag_end(w->context, drag, NULL), DM_OK);
    return 1;
}

static void odd_meshes_give_finite_joints(void** state) {
    (void)state;
    int prepared = 0, dragged = 0;
    for (int i = 0; i < MESHES; i++) {
        dmi_random random = dmi_random_make((uint64_t)i, 7);
        test_world w;
        dm_object object;
        char text[32];
        snprintf(text, sizeof text, "mesh %d", i);
        test_world_init(&w);
        if (test_once_in(&random, 3)) w.desc.unit_in_metres = fabsf(test_odd(&random));
        make_odd(&random, &w.shape);
        if (dm_context_create(&w.desc, &w.context) != DM_OK) continue;
        if (test_world_prepare(&w, 0, &object) == DM_OK) {
            prepared++;
            dragged += expect_dragged(&w, object, text);
            for (uint32_t k = 0; k < 2; k++) expect_sound_part(&w, object, k, text);
            expect_saved_and_loaded(&w, object, text);
        }
        test_world_close(&w);
    }
    expect_taken(prepared, MESHES);
    expect_taken(dragged, MESHES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(odd_cameras_give_finite_rays),
        cmocka_unit_test(odd_poses_within_bounds_stay_finite),
        cmocka_unit_test(odd_joints_give_finite_answers),
        cmocka_unit_test(a_joint_in_force_can_be_saved_and_dragged),
        cmocka_unit_test(odd_links_move_parts_to_finite_values),
        cmocka_unit_test(odd_scenes_give_finite_hits),
        cmocka_unit_test(odd_meshes_give_finite_joints),
    };
    return cmocka_run_group_tests_name("odd_inputs", tests, NULL, NULL);
}
