/* The boundary's promises that hold for every function: struct_size, null arguments, handles, results, messages. */
#include <math.h>

#include "test_world.h"

/* Fails unless the call answered `code` with a message that holds `field`. */
#define assert_error(world, call, expected, field)                                                                     \
    do {                                                                                                               \
        (world)->messages.count = 0;                                                                                   \
        assert_int_equal(call, expected);                                                                              \
        assert_int_equal((world)->messages.count, 1);                                                                  \
        assert_int_equal((world)->messages.code, expected);                                                            \
        if (!strstr((world)->messages.text, field)) fail_msg("no '%s' in: %s", field, (world)->messages.text);         \
    } while (0)

/* Fails unless a [frame] call answered `code` without a message. */
#define assert_silent_error(world, call, expected)                                                                     \
    do {                                                                                                               \
        (world)->messages.count = 0;                                                                                   \
        assert_int_equal(call, expected);                                                                              \
        assert_int_equal((world)->messages.count, 0);                                                                  \
    } while (0)

static void test_every_result_has_its_own_name(void** state) {
    (void)state;
    for (dm_result a = DM_OK; a >= DM_ERROR_INTERNAL; a--) {
        assert_true(strncmp(dm_result_string(a), "DM_", 3) == 0);
        assert_string_not_equal(dm_result_string(a), "DM_ERROR_UNKNOWN");
        for (dm_result b = DM_OK; b > a; b--) assert_string_not_equal(dm_result_string(a), dm_result_string(b));
    }
    assert_string_equal(dm_result_string(1), "DM_ERROR_UNKNOWN");
    assert_string_equal(dm_result_string(DM_ERROR_INTERNAL - 1), "DM_ERROR_UNKNOWN");
    assert_int_equal(dm_version(), DM_VERSION);
}

/* ---- context ---- */

static void test_context_with_all_defaults(void** state) {
    (void)state;
    dm_context* context = NULL;
    assert_int_equal(dm_context_create(NULL, &context), DM_OK);
    dm_memory_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_context_get_memory(context, &info), DM_OK);
    assert_true(info.bytes > 0 && info.peak_bytes >= info.bytes && info.allocations > 0);
    dm_context_destroy(context);
    dm_context_destroy(NULL);
}

static void test_context_names_the_wrong_field(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    dm_context* context = (dm_context*)&w;
    dm_context_desc desc = w.desc;
    desc.axes = 5;
    assert_error(&w, dm_context_create(&desc, &context), DM_ERROR_INVALID_ARGUMENT, "desc.axes is 5");
    desc = w.desc;
    desc.unit_in_metres = -2.0f;
    assert_error(&w, dm_context_create(&desc, &context), DM_ERROR_INVALID_ARGUMENT, "desc.unit_in_metres is -2");
    desc = w.desc;
    desc.axes = DM_AXES_CUSTOM;
    assert_error(&w, dm_context_create(&desc, &context), DM_ERROR_INVALID_ARGUMENT, "desc.custom_axes");
    desc = w.desc;
    desc.allocator.release = NULL;
    assert_error(&w, dm_context_create(&desc, &context), DM_ERROR_INVALID_ARGUMENT, "desc.allocator");
    assert_int_equal(dm_context_create(&w.desc, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_ptr_equal(context, &w); /* outputs are untouched */
    assert_int_equal(w.memory.live_blocks, 0);
}

static void test_picking_can_be_chosen(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    w.desc.picking = DM_PICK_NONE + 1;
    assert_int_equal(dm_context_create(&w.desc, &w.context), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "desc.picking"));
    w.desc.picking = DM_PICK_PORTABLE;
    w.desc.reserved = 1;
    assert_int_equal(dm_context_create(&w.desc, &w.context), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(w.messages.text, "desc.reserved"));
    w.desc.reserved = 0;
    test_world_open(&w);
    dm_memory_info info = {.struct_size = sizeof info};
    dm_object_info object = {.struct_size = sizeof object};
    assert_int_equal(dm_object_get_info(w.context, test_world_cabinet(&w), &object), DM_OK);
    assert_int_equal(object.pickable, 1);
    assert_int_equal(dm_context_get_memory(w.context, &info), DM_OK);
    assert_int_equal(info.pick_bytes, 0); /* all of it comes from the host */
    test_world_close(&w);
}

/* Hosts that cast their own rays: everything but picking, and the triangles are in the file all the same. */
static void test_a_context_that_picks_nothing(void** state) {
    (void)state;
    test_world w, other;
    test_world_init(&w);
    test_world_init(&other);
    w.desc.picking = DM_PICK_NONE;
    test_world_open(&w);
    test_world_open(&other);
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene = 0;
    assert_int_equal(dm_scene_create(w.context, &desc, &scene), DM_ERROR_UNSUPPORTED);
    assert_non_null(strstr(w.messages.text, "no ray picking: the host wants none (DM_PICK_NONE)"));
    dm_object object = test_world_cabinet(&w), loaded = 0;
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_object_get_info(w.context, object, &info), DM_OK);
    assert_int_equal(info.pickable, 0);
    size_t size = 0;
    assert_int_equal(dm_object_save(w.context, object, NULL, 0, &size), DM_OK);
    void* file = malloc(size);
    assert_int_equal(dm_object_save(w.context, object, file, size, &size), DM_OK);
    assert_int_equal(dm_object_load(w.context, file, size, 0, &loaded), DM_OK);
    assert_int_equal(dm_object_load(other.context, file, size, 0, &loaded), DM_OK);
    assert_int_equal(dm_object_get_info(other.context, loaded, &info), DM_OK);
    assert_int_equal(info.pickable, 1);
    free(file);
    test_world_close(&w);
    test_world_close(&other);
}

static void test_memory_is_accounted_to_the_byte(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_memory_info info = {.struct_size = sizeof info};
    dm_object object = test_world_cabinet(&w);
    assert_int_equal(dm_context_get_memory(w.context, &info), DM_OK);
    assert_int_equal(info.bytes, w.memory.live_bytes);
    assert_int_equal(info.allocations, w.memory.calls);
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    assert_int_equal(dm_context_get_memory(w.context, &info), DM_OK);
    assert_int_equal(info.bytes, w.memory.live_bytes);
    assert_int_equal(dm_context_get_memory(w.context, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_context_get_memory(NULL, &info), DM_ERROR_INVALID_ARGUMENT);
    test_world_close(&w);
}

/* ---- sizes of buffers ---- */

/* A forgotten format, scope or size is refused before anything is read. */
static void test_buffers_that_do_not_fit_are_refused(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    uint8_t* bytes = malloc(w.shape.face_count); /* not a byte longer, for the address sanitizer */
    assert_non_null(bytes);
    for (uint32_t i = 0; i < w.shape.face_count; i++) bytes[i] = (uint8_t)w.shape.part[i];
    dm_mesh_desc mesh = test_shape_desc(&w.shape);
    mesh.part_ids = bytes, mesh.part_id_bytes = w.shape.face_count;
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh};
    dm_object object = 0;
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_INVALID_ARGUMENT, "part_id_format");
    mesh.part_id_format = DM_UINT8, mesh.part_id_scope = DM_PER_VERTEX;
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_INVALID_ARGUMENT, "24 vertices");
    mesh.part_id_scope = DM_PER_FACE, mesh.part_id_bytes = 0;
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_INVALID_ARGUMENT, "part_id_bytes is 0");
    mesh.part_id_bytes = w.shape.face_count, mesh.index_bytes = mesh.index_count * sizeof(uint16_t);
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_INVALID_ARGUMENT, "index_format");
    mesh.index_bytes = mesh.index_count * sizeof(uint32_t), mesh.position_bytes = mesh.vertex_count * 12 - 1;
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_INVALID_ARGUMENT, "position_bytes is 287");
    mesh.position_bytes++;
    const uint64_t counts[] = {0, 1, 5, mesh.index_count - 1};
    for (int i = 0; i < 4; i++) { /* what is wrong is named, not what it is compared with */
        dm_mesh_desc torn = mesh;
        torn.index_count = counts[i];
        const dm_object_desc whole = {.struct_size = sizeof whole, .mesh = &torn};
        assert_error(&w, dm_object_prepare(w.context, &whole, &object), DM_ERROR_INVALID_ARGUMENT,
                     "dm_mesh_desc.index_count: ");
    }
    uint8_t faces[64];
    const dm_drag_hint hint = test_pull();
    mesh.part_id_format = DM_UINT32;
    assert_error(&w, dm_mesh_find_part(w.context, &mesh, &hint, faces, sizeof faces), DM_ERROR_INVALID_ARGUMENT,
                 "dm_mesh_find_part: mesh.part_id_bytes");
    mesh.part_id_format = DM_UINT8;
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    free(bytes);
    test_world_close(&w);
}

/* ---- struct_size ---- */

/* A descriptor as a newer caller has it: ours, then fields that we can't know. */
typedef struct newer_camera {
    dm_camera known;
    uint32_t unknown[4];
} newer_camera;

static void test_inputs_of_other_versions(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    newer_camera camera = {
        .known = {.fov_y = 1, .forward = {0, 0, -1}, .up = {0, 1, 0}, .viewport_width = 8, .viewport_height = 6}};
    dm_ray ray;
    camera.known.struct_size = sizeof camera;
    assert_int_equal(dm_camera_ray(w.context, &camera.known, 1, 1, &ray), DM_OK);
    camera.unknown[3] = 1u << 31;
    assert_silent_error(&w, dm_camera_ray(w.context, &camera.known, 1, 1, &ray), DM_ERROR_STRUCT_SIZE);
    camera.known.struct_size = sizeof camera.known;
    assert_int_equal(dm_camera_ray(w.context, &camera.known, 1, 1, &ray), DM_OK);
    const uint32_t wrong[] = {0, 4, sizeof camera.known - 1, 4097, UINT32_MAX};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        camera.known.struct_size = wrong[i];
        assert_silent_error(&w, dm_camera_ray(w.context, &camera.known, 1, 1, &ray), DM_ERROR_STRUCT_SIZE);
    }
    test_world_close(&w);
}

static void test_every_descriptor_checks_its_size(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    uint64_t handle = 0;
    const dm_model_desc model = {0};
    const dm_scene_desc scene = {0};
    const dm_drag_desc drag = {0};
    const dm_motion_desc motion = {0};
    dm_object object = test_world_cabinet(&w);
    assert_error(&w, dm_model_load(w.context, &model, &handle), DM_ERROR_STRUCT_SIZE,
                 "dm_model_load: desc.struct_size");
    assert_error(&w, dm_scene_create(w.context, &scene, &handle), DM_ERROR_STRUCT_SIZE,
                 "dm_scene_create: desc.struct_size");
    assert_error(&w, dm_drag_begin(w.context, &drag, &handle), DM_ERROR_STRUCT_SIZE, "dm_drag_begin: desc.struct_size");
    assert_error(&w, dm_motion_generate(w.context, object, &motion, &handle), DM_ERROR_STRUCT_SIZE,
                 "dm_motion_generate: desc.struct_size");
    dm_mesh_desc mesh = test_shape_desc(&w.shape);
    dm_part_desc parts[2] = {{.struct_size = sizeof parts[0], .id = 1}, {.struct_size = sizeof parts[0], .id = 2}};
    dm_object_desc prepare = {.mesh = &mesh, .parts = parts, .part_count = 2};
    assert_error(&w, dm_object_prepare(w.context, &prepare, &handle), DM_ERROR_STRUCT_SIZE, "desc.struct_size");
    prepare.struct_size = sizeof prepare;
    mesh.struct_size = 8;
    assert_error(&w, dm_object_prepare(w.context, &prepare, &handle), DM_ERROR_STRUCT_SIZE,
                 "desc.mesh.struct_size is 8");
    mesh.struct_size = sizeof mesh;
    parts[1].struct_size = 4;
    assert_error(&w, dm_object_prepare(w.context, &prepare, &handle), DM_ERROR_STRUCT_SIZE,
                 "desc.parts[1].struct_size is 4");
    assert_int_equal(handle, 0);
    test_world_close(&w);
}

/* The host's array of parts steps by the host's size of a part, not by ours. */
static void test_arrays_of_newer_parts(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    struct {
        dm_part_desc known;
        uint64_t unknown[3];
    } parts[2] = {{.known = {.struct_size = sizeof parts[0], .id = 1, .joint_type = DM_JOINT_PRISMATIC}},
                  {.known = {.struct_size = sizeof parts[0], .id = 2, .parent = 1, .joint_type = DM_JOINT_FIXED}}};
    const dm_mesh_desc mesh = test_shape_desc(&w.shape);
    const dm_object_desc desc = {.struct_size = sizeof desc, .mesh = &mesh, .parts = &parts[0].known, .part_count = 2};
    dm_object object;
    assert_int_equal(dm_object_prepare(w.context, &desc, &object), DM_OK);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_int_equal(dm_object_get_joint(w.context, object, 2, &joint), DM_OK);
    assert_int_equal(joint.type, DM_JOINT_FIXED);
    assert_int_equal(dm_object_get_joint(w.context, object, 1, &joint), DM_OK);
    assert_int_equal(joint.type, DM_JOINT_PRISMATIC);
    parts[1].unknown[2] = 1;
    assert_error(&w, dm_object_prepare(w.context, &desc, &object), DM_ERROR_STRUCT_SIZE, "desc.parts[1]");
    test_world_close(&w);
}

static void test_outputs_write_no_more_than_struct_size(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w);
    struct {
        dm_object_info info;
        uint8_t newer[8], guard[8];
    } out;
    memset(&out, 0xAB, sizeof out);
    out.info.struct_size = sizeof out.info + sizeof out.newer;
    assert_int_equal(dm_object_get_info(w.context, object, &out.info), DM_OK);
    assert_int_equal(out.info.struct_size, sizeof out.info + sizeof out.newer);
    assert_int_equal(out.info.part_count, 2);
    for (int i = 0; i < 8; i++) {
        assert_int_equal(out.newer[i], 0);
        assert_int_equal(out.guard[i], 0xAB);
    }
    dm_part_info part = {.struct_size = 8};
    assert_error(&w, dm_object_get_part(w.context, object, 0, &part), DM_ERROR_STRUCT_SIZE,
                 "out_info.struct_size is 8");
    assert_error(&w, dm_object_get_info(w.context, object, NULL), DM_ERROR_INVALID_ARGUMENT, "out_info is NULL");
    test_world_close(&w);
}

/* ---- handles ---- */

static void test_null_stale_and_foreign_handles(void** state) {
    (void)state;
    test_world w, other;
    test_world_init(&w);
    test_world_open(&w);
    test_world_init(&other);
    test_world_open(&other);
    dm_object object = test_world_cabinet(&w);
    dm_joint joint = {.struct_size = sizeof joint};
    assert_error(&w, dm_object_get_joint(w.context, 0, 1, &joint), DM_ERROR_STALE_HANDLE, "0x0000000000000000");
    assert_error(&w, dm_scene_destroy(w.context, object), DM_ERROR_STALE_HANDLE, "an object");
    assert_error(&w, dm_motion_destroy(w.context, object), DM_ERROR_STALE_HANDLE, "dm_motion_destroy");
    dm_object twin = test_world_cabinet(&other);
    assert_true(object != twin);
    assert_error(&other, dm_object_get_joint(other.context, object, 1, &joint), DM_ERROR_STALE_HANDLE, "get_joint");
    assert_int_equal(dm_object_destroy(w.context, object), DM_OK);
    assert_error(&w, dm_object_destroy(w.context, object), DM_ERROR_STALE_HANDLE, "dm_object_destroy");
    dm_object again = test_world_cabinet(&w);
    assert_true(object != again);
    assert_error(&w, dm_object_get_joint(w.context, object, 1, &joint), DM_ERROR_STALE_HANDLE, "get_joint");
    test_world_close(&w);
    test_world_close(&other);
}

static void test_model_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_model model = 0;
    const char junk[] = "not a safetensors file at all";
    dm_model_desc desc = {.struct_size = sizeof desc};
    assert_error(&w, dm_model_load(w.context, &desc, &model), DM_ERROR_INVALID_ARGUMENT, "no weights at all");
    desc.kinematics = junk;
    assert_error(&w, dm_model_load(w.context, &desc, &model), DM_ERROR_INVALID_ARGUMENT, "desc.kinematics");
    desc.kinematics_size = sizeof junk;
    assert_error(&w, dm_model_load(w.context, &desc, NULL), DM_ERROR_INVALID_ARGUMENT, "out_model");
    assert_int_equal(dm_model_load(w.context, &desc, &model), DM_ERROR_BAD_DATA);
    desc = (dm_model_desc){.struct_size = sizeof desc, .motion = junk, .motion_size = sizeof junk};
    assert_int_equal(dm_model_load(w.context, &desc, &model), DM_ERROR_BAD_DATA);
    assert_int_equal(model, 0);
    assert_int_equal(dm_model_unload(w.context, model), DM_ERROR_STALE_HANDLE);
    test_world_close(&w);
}

static void test_weights_of_the_other_network(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_model_desc desc = {.struct_size = sizeof desc};
    void* motion = test_read_file("sdk/models/dq_vae.safetensors", &desc.kinematics_size);
    desc.kinematics = motion;
    dm_model model = 0;
    assert_int_equal(dm_model_load(w.context, &desc, &model), DM_ERROR_WRONG_MODEL);
    free(motion);
    test_world_close(&w);
}

/* Weights of an architecture that was given up. */
static void test_weights_of_an_older_version_are_refused_by_name(void** state) {
    (void)state;
    static const char now[] = "\"dragmesh-joint-models\"", before[] = "\"dragmesh-ranker\"       ";
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_model_desc desc = {.struct_size = sizeof desc};
    char* ranker = test_read_file("sdk/models/ranker.safetensors", &desc.ranker_size);
    char* name = ranker;
    while (name + strlen(now) < ranker + desc.ranker_size && memcmp(name, now, strlen(now)) != 0) name++;
    memcpy(name, before, strlen(now));
    desc.ranker = ranker;
    dm_model model = 0;
    assert_error(&w, dm_model_load(w.context, &desc, &model), DM_ERROR_WRONG_MODEL, "'dragmesh-ranker'");
    free(ranker);
    test_world_close(&w);
}

/* ---- drags, scenes, cameras, poses ---- */

static void test_drag_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_drag drag = 0;
    dm_drag_state out = {.struct_size = sizeof out};
    dm_drag_desc desc = {.struct_size = sizeof desc, .part_id = 9, .object = test_world_cabinet(&w)};
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_NOT_FOUND, "no part 9");
    desc.part_id = 0;
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_NOT_FOUND, "part 0 is the body");
    desc.part_id = TEST_DOOR;
    desc.grab_point.y = (float)NAN;
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_NOT_FINITE, "desc.grab_point");
    desc.grab_point.y = 0;
    desc.feel.soft_limit = 2;
    assert_error(&w, dm_drag_begin(w.context, &desc, &drag), DM_ERROR_INVALID_ARGUMENT, "desc.feel.soft_limit is 2");
    desc.feel.soft_limit = 0;
    assert_error(&w, dm_drag_begin(w.context, &desc, NULL), DM_ERROR_INVALID_ARGUMENT, "out_drag");
    assert_int_equal(dm_drag_begin(w.context, &desc, &drag), DM_OK);
    dm_ray ray = {{0, 0, 5}, {0, 0, 0}};
    assert_silent_error(&w, dm_drag_update(w.context, drag, &ray, 0, &out), DM_ERROR_INVALID_ARGUMENT);
    ray.direction.z = -1;
    assert_silent_error(&w, dm_drag_update(w.context, drag, NULL, 0, &out), DM_ERROR_INVALID_ARGUMENT);
    assert_silent_error(&w, dm_drag_update(w.context, drag, &ray, -1, &out), DM_ERROR_INVALID_ARGUMENT);
    assert_silent_error(&w, dm_drag_update(w.context, drag, &ray, (float)INFINITY, &out), DM_ERROR_NOT_FINITE);
    assert_silent_error(&w, dm_drag_update(w.context, drag, &ray, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_drag_update(w.context, drag, &ray, 0, &out), DM_OK);
    assert_int_equal(dm_drag_end(w.context, drag, NULL), DM_OK);
    assert_silent_error(&w, dm_drag_update(w.context, drag, &ray, 0, &out), DM_ERROR_STALE_HANDLE);
    assert_error(&w, dm_drag_end(w.context, drag, NULL), DM_ERROR_STALE_HANDLE, "dm_drag_end");
    test_world_close(&w);
}

static void test_scene_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_object object = test_world_cabinet(&w), bare;
    assert_int_equal(test_world_prepare(&w, DM_PREPARE_WITHOUT_PICKING, &bare), DM_OK);
    const dm_scene_desc desc = {.struct_size = sizeof desc};
    dm_scene scene;
    uint32_t instance = 0;
    dm_hit hit = {.struct_size = sizeof hit};
    assert_error(&w, dm_scene_create(w.context, &desc, NULL), DM_ERROR_INVALID_ARGUMENT, "out_scene");
    assert_int_equal(dm_scene_create(w.context, &desc, &scene), DM_OK);
    assert_error(&w, dm_scene_add(w.context, scene, bare, NULL, &instance), DM_ERROR_UNSUPPORTED, "no triangles");
    assert_error(&w, dm_scene_add(w.context, scene, object, NULL, NULL), DM_ERROR_INVALID_ARGUMENT, "out_instance");
    assert_error(&w, dm_scene_add(w.context, object, object, NULL, &instance), DM_ERROR_STALE_HANDLE, "dm_scene_add");
    assert_error(&w, dm_scene_add(w.context, scene, scene, NULL, &instance), DM_ERROR_STALE_HANDLE, "dm_scene_add");
    dm_pose pose = {0};
    assert_error(&w, dm_scene_add(w.context, scene, object, &pose, &instance), DM_ERROR_INVALID_ARGUMENT,
                 "placement.real");
    pose.dual[1] = (float)NAN;
    assert_error(&w, dm_scene_add(w.context, scene, object, &pose, &instance), DM_ERROR_NOT_FINITE, "placement");
    assert_int_equal(dm_scene_add(w.context, scene, object, NULL, &instance), DM_OK);
    assert_silent_error(&w, dm_scene_move(w.context, scene, instance, 1, NULL), DM_ERROR_INVALID_ARGUMENT);
    pose = (dm_pose){.real = {0, 0, 0, 1}};
    assert_int_equal(dm_scene_move(w.context, scene, instance, 7, &pose), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_scene_move(w.context, scene, instance + 1, 1, &pose), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_scene_remove(w.context, scene, instance + 1), DM_ERROR_NOT_FOUND);
    const dm_ray ray = {{0.5f, 0.5f, 5}, {0, 0, -2}};
    assert_silent_error(&w, dm_scene_pick(w.context, scene, &ray, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_scene_destroy(w.context, scene), DM_OK);
    assert_silent_error(&w, dm_scene_pick(w.context, scene, &ray, &hit), DM_ERROR_STALE_HANDLE);
    test_world_close(&w);
}

static void test_camera_and_pose_arguments(void** state) {
    (void)state;
    test_world w;
    test_world_init(&w);
    test_world_open(&w);
    dm_camera camera = {.struct_size = sizeof camera, .fov_y = 1, .forward = {0, 0, -1}, .up = {0, 0, 2}};
    camera.viewport_width = camera.viewport_height = 100;
    dm_ray ray;
    assert_silent_error(&w, dm_camera_ray(w.context, &camera, 1, 1, &ray), DM_ERROR_INVALID_ARGUMENT);
    camera.up.y = 1;
    assert_silent_error(&w, dm_camera_ray(w.context, &camera, (float)NAN, 1, &ray), DM_ERROR_NOT_FINITE);
    assert_silent_error(&w, dm_camera_ray(w.context, &camera, 1, 1, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_camera_ray(w.context, &camera, 1, 1, &ray), DM_OK);
    dm_joint joint = test_hinge();
    dm_pose pose;
    assert_int_equal(dm_joint_pose(NULL, 0, &pose), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_pose(&joint, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_pose(&joint, (float)NAN, &pose), DM_ERROR_NOT_FINITE);
    joint.type = 6;
    assert_int_equal(dm_joint_pose(&joint, 0, &pose), DM_ERROR_INVALID_ARGUMENT);
    dm_pose_multiply(NULL, &pose, &pose); /* the void ones do nothing */
    dm_pose_inverse(NULL, &pose);
    dm_pose_inverse(&pose, NULL);
    dm_pose_to_matrix(&pose, NULL);
    dm_pose_apply_points(&pose, NULL, 0, NULL, 0, 5);
    test_world_close(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_result_has_its_own_name),
        cmocka_unit_test(test_context_with_all_defaults),
        cmocka_unit_test(test_context_names_the_wrong_field),
        cmocka_unit_test(test_picking_can_be_chosen),
        cmocka_unit_test(test_a_context_that_picks_nothing),
        cmocka_unit_test(test_memory_is_accounted_to_the_byte),
        cmocka_unit_test(test_buffers_that_do_not_fit_are_refused),
        cmocka_unit_test(test_inputs_of_other_versions),
        cmocka_unit_test(test_every_descriptor_checks_its_size),
        cmocka_unit_test(test_arrays_of_newer_parts),
        cmocka_unit_test(test_outputs_write_no_more_than_struct_size),
        cmocka_unit_test(test_null_stale_and_foreign_handles),
        cmocka_unit_test(test_model_arguments),
        cmocka_unit_test(test_weights_of_the_other_network),
        cmocka_unit_test(test_weights_of_an_older_version_are_refused_by_name),
        cmocka_unit_test(test_drag_arguments),
        cmocka_unit_test(test_scene_arguments),
        cmocka_unit_test(test_camera_and_pose_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
