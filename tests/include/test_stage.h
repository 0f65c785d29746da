/* What one caller needs to call every public function: an object, a scene, drags, a motion and a glTF file of its own,
 * in a context that callers may share. test_calls.h has the calls. Run from the repository's root. */
#ifndef DM_TEST_STAGE_H
#define DM_TEST_STAGE_H

#include <stdbool.h>
#include <unistd.h>

#include "dragmesh/ext/gltf.h"
#include "test_glb.h"
#include "test_world.h"

enum {
    TEST_STAGE_FACES = 36,
    TEST_STAGE_PARTS = 2,
    TEST_STAGE_NODES = 3,
    TEST_STAGE_BLOB = 1 << 18,
    TEST_STAGE_UNTOUCHED = 0xA5
};

/* All that calls write. */
typedef struct test_answers {
    /* The same for each caller. */
    size_t size;
    uint32_t instance, count;
    int32_t scope, ambiguous;
    float value, angle, distance, matrix[16], points[2][3], values[DM_MOTION_FRAMES], uv[2][3][2];
    double origin[3];
    dm_object_info object;
    dm_part_info part;
    dm_joint joint, joints[DM_MAX_HYPOTHESES];
    dm_joint_frame frame;
    dm_pose pose, poses[DM_MOTION_FRAMES];
    dm_ray ray;
    dm_hit hit;
    dm_drag_state state;
    dm_part_state part_state;
    dm_release_plan plan;
    dm_pivot pivot;
    dm_asset_info asset;
    dm_asset_part asset_part;
    uint32_t asset_nodes[TEST_STAGE_NODES];
    char label[64];
    uint8_t held[TEST_STAGE_PARTS], faces[TEST_STAGE_FACES], blob[TEST_STAGE_BLOB];
    /* Handles, addresses and amounts of memory, which differ. */
    dm_context* context;
    dm_gltf* gltf;
    void* data;
    uint64_t handle;
    dm_memory_info memory;
    dm_mesh_desc mesh;
    dm_gltf_node node;
    dm_gltf_surface surface;
} test_answers;

#define TEST_ANSWERS_COMPARED offsetof(test_answers, context)

typedef struct test_stage {
    test_world* w;      /* shared */
    dm_object object;   /* shared; read alone */
    dm_object own;      /* the caller's */
    dm_asset asset;     /* shared; read alone */
    dm_object spare;    /* what `before` has made for a call to take away; 0: nothing */
    uint64_t spare_one; /* the same, of the other handles */
    dm_context* spare_context;
    dm_scene scene; /* holds `object` */
    uint32_t instance, spare_instance;
    dm_motion motion;
    dm_drag drag, released, without_point;
    dm_gltf* gltf;
    void* spare_bytes;
    size_t spare_size;
    test_glb glb;
    char path[32];     /* of a file that holds the glb */
    const void* saved; /* a .dmo of `object` */
    size_t saved_size;
    uint8_t snapshot[DM_DRAG_SNAPSHOT_MAX];
    dm_model_desc weights;
    dm_mesh_desc mesh;
    int frame; /* rises by one an update of a drag */
    test_answers out;
} test_stage;

/* A body and a door, square quads; the door has a texture. */
#define TEST_STAGE_GLTF                                                                                                \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":176}],\"bufferViews\":["                            \
    "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48},"                             \
    "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":32},{\"buffer\":0,\"byteOffset\":128,\"byteLength\":32},"          \
    "{\"buffer\":0,\"byteOffset\":160,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":172,\"byteLength\":4}],"         \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"                          \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"                                         \
    "{\"bufferView\":4,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}],"                                      \
    "\"images\":[{\"bufferView\":5,\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}],"                        \
    "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"                                 \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":3}]},"                                  \
    "{\"primitives\":[{\"attributes\":{\"POSITION\":1,\"TEXCOORD_0\":2},\"indices\":3,\"material\":0}]}],"             \
    "\"nodes\":[{\"name\":\"body\",\"mesh\":0,\"children\":[1]},{\"name\":\"door\",\"mesh\":1}]}"

static inline test_glb test_stage_glb(void) {
    const struct {
        float body[4][3], door[4][3], uv[4][2], unused[4][2];
        uint16_t corners[6];
        char image[4];
    } bin = {.body = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
             .door = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
             .uv = {{0, 1}, {1, 1}, {0, 0}, {1, 0}},
             .corners = {0, 1, 2, 2, 1, 3},
             .image = "PNG"};
    return test_glb_pack(TEST_STAGE_GLTF, &bin, sizeof bin);
}

/* Marks the outputs, so that one that was touched shows. */
static inline void test_answers_clear(test_answers* out) {
    memset(out, TEST_STAGE_UNTOUCHED, sizeof *out);
    out->memory.struct_size = sizeof out->memory;
    out->object.struct_size = sizeof out->object;
    out->part.struct_size = sizeof out->part;
    out->joint.struct_size = out->joints[0].struct_size = sizeof out->joint;
    out->frame.struct_size = sizeof out->frame;
    out->hit.struct_size = sizeof out->hit;
    out->state.struct_size = sizeof out->state;
    out->part_state.struct_size = sizeof out->part_state;
    out->plan.struct_size = sizeof out->plan;
    out->asset.struct_size = sizeof out->asset;
    out->asset_part.struct_size = sizeof out->asset_part;
}

static inline dm_gltf_desc test_stage_gltf_desc(const test_stage* s) {
    return (dm_gltf_desc){.struct_size = sizeof(dm_gltf_desc),
                          .data = s->glb.data,
                          .size = s->glb.size,
                          .allocator = s->w->desc.allocator,
                          .log = s->w->desc.log};
}

static inline dm_drag test_stage_drag(const test_stage* s, uint32_t flags, const dm_drag_rules* rules) {
    const dm_drag_desc desc = {.struct_size = sizeof desc,
                               .object = s->object,
                               .part_id = TEST_DOOR,
                               .grab_point = test_pull().point,
                               .flags = flags,
                               .rules = rules};
    dm_drag drag = 0;
    assert_int_equal(dm_drag_begin(s->w->context, &desc, &drag), DM_OK);
    return drag;
}

/* The cabinet as an asset: body, door and handle, which hangs below the door. */
static inline dm_result test_stage_asset(const test_stage* s, dm_asset* out_asset) {
    static const char* const names[TEST_STAGE_NODES] = {"body", "door", "handle"};
    dm_mesh_desc meshes[TEST_STAGE_NODES];
    dm_asset_node nodes[TEST_STAGE_NODES];
    for (uint32_t i = 0; i < TEST_STAGE_NODES; i++) {
        meshes[i] = s->mesh;
        meshes[i].indices = s->w->shape.corners[i * TEST_BOX_FACES];
        meshes[i].index_count = (uint64_t)3 * TEST_BOX_FACES;
        meshes[i].part_ids = NULL;
        meshes[i].part_id_bytes = 0;
        nodes[i] = dm_asset_node_default();
        nodes[i].parent = i == TEST_HANDLE ? TEST_DOOR : DM_ASSET_NO_NODE;
        nodes[i].name = names[i];
        nodes[i].mesh = &meshes[i];
    }
    const dm_asset_desc desc = {.struct_size = sizeof desc,
                                .nodes = nodes,
                                .node_count = TEST_STAGE_NODES,
                                .min_moves = 0.01f,
                                .model = s->w->model,
                                .seed = 7};
    return dm_asset_create(s->w->context, &desc, out_asset);
}

/* Pulls the door some way open. */
static inline void test_stage_pull(const test_stage* s, dm_drag drag) {
    for (int i = 0; i < 20; i++) {
        const dm_joint hinge = test_hinge();
        const dm_ray ray = test_ray_to(test_point_on(&hinge, 0.03f * (float)i));
        dm_drag_state state = dm_drag_state_default();
        assert_int_equal(dm_drag_update(s->w->context, drag, &ray, 1.0f / 60, &state), DM_OK);
    }
}

/* What callers share. w: opened, with its model. */
static inline void test_stage_open_shared(test_stage* s, test_world* w) {
    memset(s, 0, sizeof *s);
    s->w = w;
    s->mesh = test_shape_desc(&w->shape);
    s->object = test_world_cabinet(w);
    assert_int_equal(test_stage_asset(s, &s->asset), DM_OK);
    assert_int_equal(dm_object_save(w->context, s->object, NULL, 0, &s->saved_size), DM_OK);
    void* saved = malloc(s->saved_size);
    assert_int_equal(dm_object_save(w->context, s->object, saved, s->saved_size, &s->saved_size), DM_OK);
    s->saved = saved;
    s->weights.struct_size = sizeof s->weights;
    s->weights.kinematics = test_read_file("sdk/models/kpp_net.safetensors", &s->weights.kinematics_size);
    s->weights.motion = test_read_file("sdk/models/dq_vae.safetensors", &s->weights.motion_size);
    s->weights.ranker = test_read_file("sdk/models/ranker.safetensors", &s->weights.ranker_size);
    s->glb = test_stage_glb();
    strcpy(s->path, "/tmp/dragmesh_stage_XXXXXX");
    const int file = mkstemp(s->path);
    assert_true(file >= 0 && write(file, s->glb.data, s->glb.size) == (ssize_t)s->glb.size);
    close(file);
}

static inline void test_stage_close_shared(test_stage* s) {
    unlink(s->path);
    free((void*)s->saved);
    free((void*)s->weights.kinematics);
    free((void*)s->weights.motion);
    free((void*)s->weights.ranker);
    free(s->glb.data);
}

/* What is the caller's alone. `s` is a copy of the shared stage. */
static inline void test_stage_open_own(test_stage* s) {
    dm_context* context = s->w->context;
    const dm_scene_desc scene = dm_scene_desc_default();
    const dm_motion_desc motion = {.struct_size = sizeof motion, .part_id = TEST_DOOR, .drag = test_pull()};
    const dm_drag_rules rules = dm_drag_rules_default();
    const dm_gltf_desc gltf = test_stage_gltf_desc(s);
    assert_int_equal(test_world_prepare(s->w, 0, &s->own), DM_OK);
    assert_int_equal(dm_scene_create(context, &scene, &s->scene), DM_OK);
    assert_int_equal(dm_scene_add(context, s->scene, s->object, NULL, &s->instance), DM_OK);
    assert_int_equal(dm_scene_commit(context, s->scene), DM_OK);
    assert_int_equal(dm_motion_generate(context, s->object, &motion, &s->motion), DM_OK);
    s->drag = test_stage_drag(s, 0, &rules);
    s->released = test_stage_drag(s, 0, NULL);
    s->without_point = test_stage_drag(s, DM_DRAG_WITHOUT_POINT, &rules);
    test_stage_pull(s, s->drag);
    test_stage_pull(s, s->released);
    assert_int_equal(dm_drag_release(context, s->released, NULL, NULL), DM_OK);
    assert_int_equal(dm_drag_save(context, s->drag, s->snapshot, sizeof s->snapshot), DM_OK);
    assert_int_equal(dm_gltf_open(&gltf, &s->gltf), DM_OK);
}

static inline void test_stage_close_own(test_stage* s) {
    dm_context* context = s->w->context;
    dm_gltf_close(s->gltf);
    assert_int_equal(dm_drag_end(context, s->drag, NULL), DM_OK);
    assert_int_equal(dm_drag_end(context, s->released, NULL), DM_OK);
    assert_int_equal(dm_drag_end(context, s->without_point, NULL), DM_OK);
    assert_int_equal(dm_motion_destroy(context, s->motion), DM_OK);
    assert_int_equal(dm_scene_destroy(context, s->scene), DM_OK);
    assert_int_equal(dm_object_destroy(context, s->own), DM_OK);
}

/* World, weights and stage of one caller. The world's descriptor is set. */
static inline void test_stage_open(test_stage* s, test_world* w) {
    test_world_open(w);
    test_world_load_model(w);
    test_stage_open_shared(s, w);
    test_stage_open_own(s);
}

static inline void test_stage_close(test_stage* s) {
    test_stage_close_own(s);
    test_stage_close_shared(s);
    test_world_close(s->w);
}

/* Whether everything still answers right: a joint, a drag from grab to end, a pick. */
static inline bool test_stage_is_usable(const test_stage* s) {
    dm_context* context = s->w->context;
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = s->object, .part_id = TEST_DOOR, .grab_point = test_pull().point};
    const dm_ray ray = test_ray_to(test_pull().point);
    dm_joint joint = dm_joint_default();
    dm_drag_state state = dm_drag_state_default();
    dm_hit hit = dm_hit_default();
    dm_drag drag;
    return dm_object_get_joint(context, s->object, TEST_DOOR, &joint) == DM_OK &&
           dm_drag_begin(context, &desc, &drag) == DM_OK &&
           dm_drag_update(context, drag, &ray, 1.0f / 60, &state) == DM_OK &&
           dm_drag_end(context, drag, NULL) == DM_OK && dm_scene_pick(context, s->scene, &ray, &hit) == DM_OK &&
           hit.object == s->object;
}

#endif
