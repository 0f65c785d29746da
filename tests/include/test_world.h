/* A host for tests of the boundary: a context on the test host's memory and log, and a cabinet to prepare. Run from the
 * repository's root, where sdk/models is. */
#ifndef DM_TEST_WORLD_H
#define DM_TEST_WORLD_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "test_host.h"
#include "test_shapes.h"

enum { TEST_DOOR = 1, TEST_HANDLE = 2 };

typedef struct test_world {
    test_memory memory;
    test_messages messages;
    dm_context_desc desc;
    dm_context* context;
    dm_model model; /* 0 until test_world_load_model */
    test_shape shape;
} test_world;

/* The cabinet of test_shapes.h. Change world->desc between the two calls where the defaults don't serve. */
static inline void test_world_init(test_world* world) {
    memset(world, 0, sizeof *world);
    world->memory.fail_at = TEST_NEVER;
    world->desc = (dm_context_desc){.struct_size = sizeof world->desc,
                                    .allocator = test_allocator(&world->memory),
                                    .log = test_log(&world->messages)};
    test_shape_cabinet(&world->shape);
}

static inline void test_world_open(test_world* world) {
    assert_int_equal(dm_context_create(&world->desc, &world->context), DM_OK);
}

/* What is in use: blocks, or bytes, of the host once the context has given back what it keeps for later. */
static inline int64_t test_world_blocks(test_world* world) {
    assert_int_equal(dm_context_trim(world->context), DM_OK);
    return world->memory.live_blocks;
}

static inline int64_t test_world_bytes(test_world* world) {
    assert_int_equal(dm_context_trim(world->context), DM_OK);
    return world->memory.live_bytes;
}

static inline void test_world_close(test_world* world) {
    dm_context_destroy(world->context);
    assert_int_equal(world->memory.live_blocks, 0);
    assert_int_equal(world->memory.live_bytes, 0);
    assert_int_equal(world->memory.size_errors, 0);
}

/* A file's bytes; released with free. */
static inline void* test_read_file(const char* path, size_t* out_size) {
    FILE* file = fopen(path, "rb");
    if (!file) fail_msg("no file %s: run the tests from the repository's root", path);
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    void* data = malloc(size > 0 ? (size_t)size : 1);
    assert_non_null(data);
    *out_size = fread(data, 1, (size_t)size, file);
    fclose(file);
    assert_int_equal(*out_size, size);
    return data;
}

static inline dm_model test_load_model(dm_context* context) {
    dm_model_desc desc = {.struct_size = sizeof desc};
    void* kinematics = test_read_file("sdk/models/kpp_net.safetensors", &desc.kinematics_size);
    void* motion = test_read_file("sdk/models/dq_vae.safetensors", &desc.motion_size);
    void* ranker = test_read_file("sdk/models/ranker.safetensors", &desc.ranker_size);
    desc.kinematics = kinematics;
    desc.motion = motion;
    desc.ranker = ranker;
    dm_model model = 0;
    assert_int_equal(dm_model_load(context, &desc, &model), DM_OK);
    free(kinematics);
    free(motion);
    free(ranker);
    return model;
}

static inline void test_world_load_model(test_world* world) {
    world->model = test_load_model(world->context);
}

/* The door carries the handle. */
static inline dm_result test_world_prepare(test_world* world, uint32_t flags, dm_object* out_object) {
    const dm_part_desc parts[2] = {{.struct_size = sizeof parts[0], .id = TEST_DOOR},
                                   {.struct_size = sizeof parts[0], .id = TEST_HANDLE, .parent = TEST_DOOR}};
    const dm_mesh_desc mesh = test_shape_desc(&world->shape);
    const dm_object_desc desc = {.struct_size = sizeof desc,
                                 .flags = flags,
                                 .mesh = &mesh,
                                 .parts = parts,
                                 .part_count = 2,
                                 .model = world->model,
                                 .seed = 7};
    return dm_object_prepare(world->context, &desc, out_object);
}

static inline dm_object test_world_cabinet(test_world* world) {
    dm_object object = 0;
    assert_int_equal(test_world_prepare(world, 0, &object), DM_OK);
    assert_true(object != 0);
    return object;
}

/* The door's true hinge: the edge x = 0 of its panel; opening swings the handle towards +z. */
static inline dm_joint test_hinge(void) {
    return (dm_joint){.struct_size = sizeof(dm_joint),
                      .type = DM_JOINT_REVOLUTE,
                      .axis = {0, -1, 0},
                      .origin = {0, 0.5f, 1.03f},
                      .upper = 1.5f};
}

/* A hand pulling the handle. */
static inline dm_drag_hint test_pull(void) {
    return (dm_drag_hint){.point = {0.91f, 0.5f, 1.07f}, .vector = {0, 0, 0.2f}};
}

/* Where the player looks from. */
static const dm_vec3 test_camera = {2.5f, 1.8f, 4};

static inline dm_ray test_ray_to(dm_vec3 point) {
    return (dm_ray){test_camera, {point.x - test_camera.x, point.y - test_camera.y, point.z - test_camera.z}};
}

/* Where a joint at `value` takes the point that the hand pulls. */
static inline dm_vec3 test_point_on(const dm_joint* joint, float value) {
    dm_pose pose;
    const dm_vec3 grab = test_pull().point;
    float point[3] = {grab.x, grab.y, grab.z};
    assert_int_equal(dm_joint_pose(joint, value, &pose), DM_OK);
    dm_pose_apply_points(&pose, point, 0, point, 0, 1);
    return (dm_vec3){point[0], point[1], point[2]};
}

#endif
