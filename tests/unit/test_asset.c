/* Whole assets: nodes with meshes, names and a hierarchy go in, parts with joints come out. */
#include <math.h>

#include "test_world.h"

enum { NODES = 4, BODY = 0, DOOR, HANDLE, GROUP };

/* The cabinet of test_shapes.h as a host's asset: each node's mesh lies at its own origin. */
typedef struct test_asset {
    test_world w;
    test_shape shapes[NODES];
    dm_mesh_desc meshes[NODES];
    float transforms[NODES][16];
    dm_asset_node nodes[NODES];
    dm_asset_desc desc;
} test_asset;

/* Puts a box from `low` to `high`, in the asset frame, below a node. Its origin is `low`. */
static void put_box(test_asset* t, uint32_t node, const char* name, const float low[3], const float high[3]) {
    test_shape* shape = &t->shapes[node];
    float size[3];
    for (int k = 0; k < 3; k++) size[k] = high[k] - low[k];
    shape->vertex_count = shape->face_count = 0;
    test_shape_box(shape, (const float[]){0, 0, 0}, size, 0);
    t->meshes[node] = test_shape_desc(shape);
    t->meshes[node].part_ids = NULL;
    t->meshes[node].part_id_bytes = 0;
    t->meshes[node].part_id_scope = 0;
    float* m = t->transforms[node];
    memset(m, 0, sizeof t->transforms[node]);
    m[0] = m[5] = m[10] = m[15] = 1;
    memcpy(m + 12, low, 3 * sizeof *m);
    t->nodes[node] = (dm_asset_node){.struct_size = sizeof t->nodes[node],
                                     .parent = DM_ASSET_NO_NODE,
                                     .name = name,
                                     .mesh = &t->meshes[node],
                                     .transform = m};
}

/* Opens the world of which `t->w.desc` says how. */
static void fill_cabinet(test_asset* t) {
    test_world_open(&t->w);
    test_world_load_model(&t->w);
    put_box(t, BODY, "carcase", (const float[]){0, 0, 0}, (const float[]){2, 1, 1});
    put_box(t, DOOR, "door", (const float[]){0, 0, 1.01f}, (const float[]){1, 1, 1.05f});
    put_box(t, HANDLE, "handle", (const float[]){0.9f, 0.4f, 1.05f}, (const float[]){0.92f, 0.6f, 1.07f});
    t->nodes[HANDLE].parent = DOOR;
    t->desc = (dm_asset_desc){.struct_size = sizeof t->desc,
                              .nodes = t->nodes,
                              .node_count = 3,
                              .min_moves = 0.01f, /* of what moves others decide */
                              .model = t->w.model,
                              .seed = 7};
}

static test_asset* new_asset(void) {
    test_asset* t = calloc(1, sizeof *t);
    assert_non_null(t);
    test_world_init(&t->w);
    return t;
}

static test_asset* open_cabinet(void) {
    test_asset* t = new_asset();
    fill_cabinet(t);
    return t;
}

/* Everything goes with the context, also assets that are still there. */
static void close_cabinet(test_asset* t) {
    test_world_close(&t->w);
    free(t);
}

static dm_asset create(test_asset* t) {
    dm_asset asset = 0;
    const dm_result result = dm_asset_create(t->w.context, &t->desc, &asset);
    if (result != DM_OK) fail_msg("%s", t->w.messages.text);
    return asset;
}

static dm_asset_info info_of(test_asset* t, dm_asset asset) {
    dm_asset_info info = dm_asset_info_default();
    assert_int_equal(dm_asset_get_info(t->w.context, asset, &info), DM_OK);
    return info;
}

static dm_asset_part part_of(test_asset* t, dm_asset asset, uint32_t index) {
    dm_asset_part part = dm_asset_part_default();
    assert_int_equal(dm_asset_get_part(t->w.context, asset, index, &part), DM_OK);
    return part;
}

static dm_joint joint_of(test_asset* t, dm_asset asset, uint32_t index) {
    dm_joint joint = dm_joint_default();
    assert_int_equal(dm_asset_get_joint(t->w.context, asset, index, &joint), DM_OK);
    return joint;
}

/* The part of a node. */
static uint32_t part_with(test_asset* t, dm_asset asset, uint32_t node) {
    uint32_t parts[NODES];
    assert_int_equal(dm_asset_get_node_parts(t->w.context, asset, parts, NODES), DM_OK);
    return parts[node];
}

static void assert_same_joint(const dm_joint* a, const dm_joint* b) {
    assert_memory_equal(a, b, sizeof *a);
}

/* A door that the file states. */
static const dm_joint stated = {.struct_size = sizeof stated,
                                .type = DM_JOINT_REVOLUTE,
                                .axis = {0, -1, 0},
                                .origin = {0, 0.5f, 1.03f},
                                .upper = 1.25f};

/* ---- what comes out ---- */

/* The carcase is the largest node and stays; the door moves. */
static void test_nodes_become_parts(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset asset = create(t);
    const dm_asset_info info = info_of(t, asset);
    assert_int_equal(info.node_count, 3);
    assert_int_equal(info.triangle_count, 3 * TEST_BOX_FACES);
    assert_true(info.part_count >= 1 && info.part_count <= 2);
    const uint32_t door = part_with(t, asset, DOOR);
    assert_int_equal(part_with(t, asset, BODY), DM_ASSET_NO_PART);
    assert_int_not_equal(door, DM_ASSET_NO_PART);
    assert_int_not_equal(part_with(t, asset, HANDLE), DM_ASSET_NO_PART);
    const dm_asset_part part = part_of(t, asset, door);
    assert_int_equal(part.parent, DM_ASSET_NO_PART);
    assert_int_equal(part.basis, DM_ASSET_INFERRED);
    assert_true(part.moves > 0 && part.moves <= 1);
    assert_true(fabsf(part.box_min.z - 1.01f) < 1e-5f);
    const dm_joint joint = joint_of(t, asset, door);
    assert_int_equal(joint.type, DM_JOINT_REVOLUTE);
    assert_true(fabsf(joint.axis.y) > 0.99f);
    close_cabinet(t);
}

static void test_lists_of_nodes_agree(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset asset = create(t);
    const dm_asset_info info = info_of(t, asset);
    uint32_t listed = 0, nodes[NODES];
    for (uint32_t i = 0; i < info.part_count; i++) {
        const dm_asset_part part = part_of(t, asset, i);
        assert_int_equal(dm_asset_get_part_nodes(t->w.context, asset, i, nodes, part.node_count), DM_OK);
        for (uint32_t k = 0; k < part.node_count; k++) assert_int_equal(part_with(t, asset, nodes[k]), i);
        listed += part.node_count;
        assert_int_equal(dm_asset_get_part_nodes(t->w.context, asset, i, nodes, part.node_count - 1),
                         DM_ERROR_BUFFER_TOO_SMALL);
    }
    assert_int_equal(listed, 2);
    assert_int_equal(dm_asset_get_node_parts(t->w.context, asset, nodes, 2), DM_ERROR_BUFFER_TOO_SMALL);
    assert_int_equal(dm_asset_get_part_nodes(t->w.context, asset, info.part_count, nodes, NODES), DM_ERROR_NOT_FOUND);
    close_cabinet(t);
}

/* A part that the file states moves for certain, by that joint, and takes what hangs below it along. */
static void test_a_stated_joint_is_certain(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->nodes[DOOR].joint = &stated;
    const dm_asset asset = create(t);
    const uint32_t door = part_with(t, asset, DOOR);
    const dm_asset_part part = part_of(t, asset, door);
    const dm_joint joint = joint_of(t, asset, door);
    assert_int_equal(part_with(t, asset, HANDLE), door);
    assert_int_equal(part.basis, DM_ASSET_FROM_FILE);
    assert_int_equal(part.state, DM_ASSET_MOVES);
    assert_true(part.moves == 1);
    assert_int_equal(joint.source, DM_JOINT_FROM_HOST);
    assert_true(joint.upper == stated.upper && joint.axis.y == -1 && joint.origin.z == stated.origin.z);
    close_cabinet(t);
}

static void test_a_fixed_node_is_one_with_its_parent(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_joint fixed = {.struct_size = sizeof fixed, .type = DM_JOINT_FIXED};
    t->nodes[HANDLE].joint = &fixed;
    const dm_asset asset = create(t);
    assert_int_equal(info_of(t, asset).part_count, 1);
    assert_int_equal(part_with(t, asset, HANDLE), part_with(t, asset, DOOR));
    close_cabinet(t);
}

/* A collider goes where the door goes, and changes nothing else. */
/* Puts each node's origin at a place of its box; shares of its sides. */
static void put_pivots(test_asset* t, dm_pivot pivots[NODES], const float share[3]) {
    static const float size[NODES][3] = {{2, 1, 1}, {1, 1, 0.04f}, {0.02f, 0.2f, 0.02f}};
    for (uint32_t i = 0; i < t->desc.node_count; i++) {
        const float* m = t->transforms[i];
        pivots[i] = (dm_pivot){
            .origin = {m[12] + share[0] * size[i][0], m[13] + share[1] * size[i][1], m[14] + share[2] * size[i][2]},
            .axes = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
        t->nodes[i].pivot = &pivots[i];
    }
}

static dm_joint joint_of_door(test_asset* t) {
    const dm_asset asset = create(t);
    return joint_of(t, asset, part_with(t, asset, DOOR));
}

static void test_pivots_by_one_rule_say_nothing(void** state) {
    (void)state;
    static const float rules[][3] = {{0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0.5f, 0, 0.5f}, {1, 0, 1}};
    test_asset* t = open_cabinet();
    dm_pivot pivots[NODES];
    for (uint32_t i = 0; i < t->desc.node_count; i++) t->nodes[i].flags |= DM_ASSET_NODE_NO_PIVOT;
    const dm_joint none = joint_of_door(t);
    for (uint32_t i = 0; i < t->desc.node_count; i++) t->nodes[i].flags = 0;
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        put_pivots(t, pivots, rules[i]);
        const dm_joint joint = joint_of_door(t);
        assert_same_joint(&joint, &none);
    }
    pivots[DOOR].origin = (dm_vec3){1, 0.2f, 1.01f}; /* on the edge at which no rule would put the hinge */
    const dm_joint joint = joint_of_door(t);
    assert_int_equal(joint.type, DM_JOINT_REVOLUTE);
    assert_true(fabsf(joint.axis.y) > 0.999f && fabsf(joint.origin.x - 1) < 0.01f);
    close_cabinet(t);
}

static void test_followers_are_no_parts(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset plain = create(t);
    put_box(t, GROUP, "door_collider", (const float[]){0, 0, 1}, (const float[]){1, 1, 1.2f});
    t->nodes[GROUP].flags = DM_ASSET_NODE_FOLLOWS;
    t->nodes[GROUP].follows = DOOR;
    t->desc.node_count = 4;
    const dm_asset asset = create(t);
    const uint32_t door = part_with(t, asset, DOOR);
    assert_int_equal(part_with(t, asset, GROUP), door);
    assert_int_equal(part_of(t, asset, door).triangle_count, part_of(t, plain, door).triangle_count);
    assert_int_equal(part_of(t, asset, door).node_count, part_of(t, plain, door).node_count + 1);
    const dm_joint a = joint_of(t, plain, door), b = joint_of(t, asset, door);
    assert_same_joint(&a, &b);
    close_cabinet(t);
}

/* A mirrored node comes out as the same mesh without a mirror. */
static void test_mirrored_nodes_keep_their_fronts(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset plain = create(t);
    test_shape* shape = &t->shapes[DOOR];
    for (uint32_t v = 0; v < shape->vertex_count; v++) shape->xyz[v][0] = -shape->xyz[v][0];
    for (uint32_t f = 0; f < shape->face_count; f++) {
        const uint32_t second = shape->corners[f][1];
        shape->corners[f][1] = shape->corners[f][2];
        shape->corners[f][2] = second;
    }
    t->transforms[DOOR][0] = -1;
    t->nodes[DOOR].flags = DM_ASSET_NODE_NO_PIVOT;
    const dm_asset mirrored = create(t);
    dm_object objects[2];
    for (int i = 0; i < 2; i++) {
        assert_int_equal(dm_asset_make_object(t->w.context, i == 0 ? plain : mirrored, &objects[i]), DM_OK);
        const dm_scene_desc desc = dm_scene_desc_default();
        dm_scene scene;
        dm_hit hit = dm_hit_default();
        const dm_ray ray = {{0.31f, 0.42f, 5}, {0, 0, -1}};
        assert_int_equal(dm_scene_create(t->w.context, &desc, &scene), DM_OK);
        assert_int_equal(dm_scene_add(t->w.context, scene, objects[i], NULL, &(uint32_t){0}), DM_OK);
        assert_int_equal(dm_scene_commit(t->w.context, scene), DM_OK);
        assert_int_equal(dm_scene_pick(t->w.context, scene, &ray, &hit), DM_OK);
        assert_true(hit.object == objects[i] && fabsf(hit.point.z - 1.05f) < 1e-5f);
        assert_true(hit.normal.z > 0.99f);
    }
    close_cabinet(t);
}

/* Nodes may come in any order. */
static void test_parents_may_come_later(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->nodes[DOOR].joint = &stated;
    const dm_asset_node door = t->nodes[DOOR];
    t->nodes[DOOR] = t->nodes[HANDLE];
    t->nodes[HANDLE] = door;
    t->nodes[DOOR].parent = HANDLE;
    const dm_asset asset = create(t);
    assert_int_equal(part_with(t, asset, DOOR), part_with(t, asset, HANDLE));
    close_cabinet(t);
}

/* ---- objects ---- */

static void test_the_object_can_be_dragged(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->nodes[DOOR].joint = &stated;
    const dm_asset asset = create(t);
    const uint32_t id = part_of(t, asset, part_with(t, asset, DOOR)).part_id;
    dm_object object = 0;
    assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_OK);
    assert_int_equal(dm_asset_destroy(t->w.context, asset), DM_OK);
    dm_object_info info = dm_object_info_default();
    assert_int_equal(dm_object_get_info(t->w.context, object, &info), DM_OK);
    assert_int_equal(info.part_count, 1);
    assert_int_equal(info.triangle_count, 3 * TEST_BOX_FACES);
    const dm_drag_desc desc = {
        .struct_size = sizeof desc, .object = object, .part_id = id, .grab_point = test_pull().point};
    dm_drag drag;
    dm_drag_state drag_state = dm_drag_state_default();
    assert_int_equal(dm_drag_begin(t->w.context, &desc, &drag), DM_OK);
    for (int i = 0; i < 60; i++) {
        const dm_ray ray = test_ray_to(test_point_on(&stated, 0.01f * (float)i));
        assert_int_equal(dm_drag_update(t->w.context, drag, &ray, 1.0f / 60, &drag_state), DM_OK);
    }
    assert_true(fabsf(drag_state.value - 0.59f) < 0.05f);
    close_cabinet(t);
}

/* What stays is of the body, or of what carries it. */
static void test_the_object_has_no_parts_that_stay(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->desc.min_moves = 1;
    const dm_asset still = create(t);
    dm_object object = 0;
    assert_int_equal(info_of(t, still).moving_count, 0);
    const dm_asset_part stays = part_of(t, still, part_with(t, still, DOOR));
    assert_int_equal(stays.state, DM_ASSET_STAYS);
    assert_int_equal(stays.part_id, 0);
    assert_true(stays.moves > 0 && stays.moves < 1);
    assert_int_equal(joint_of(t, still, part_with(t, still, DOOR)).type, DM_JOINT_REVOLUTE);
    assert_int_equal(dm_asset_make_object(t->w.context, still, &object), DM_ERROR_EMPTY_MASK);
    assert_int_equal(object, 0);
    t->nodes[DOOR].joint = &stated;
    t->nodes[HANDLE].parent = DM_ASSET_NO_NODE;
    const dm_asset asset = create(t);
    const uint32_t door = part_with(t, asset, DOOR);
    assert_int_equal(info_of(t, asset).moving_count, 1);
    assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_OK);
    dm_part_info part = dm_part_info_default();
    dm_joint joint = dm_joint_default();
    const dm_joint expected = joint_of(t, asset, door);
    assert_int_equal(dm_object_get_part(t->w.context, object, 0, &part), DM_OK);
    assert_int_equal(part.id, door + 1);
    assert_int_equal(dm_object_get_joint(t->w.context, object, part.id, &joint), DM_OK);
    assert_same_joint(&joint, &expected);
    close_cabinet(t);
}

/* Parts that move come first, each group in the order of its first nodes; joints and triangles go with their numbers.
 */
static void test_parts_are_in_the_order_of_their_nodes(void** state) {
    (void)state;
    for (uint32_t first = 0; first < 2; first++) { /* the index of the handle: alone it moves, or after the door */
        test_asset* t = open_cabinet();
        t->nodes[HANDLE].joint = &stated;
        t->nodes[HANDLE].parent = DM_ASSET_NO_NODE;
        t->desc.min_moves = first == 0 ? 1 : 0.01f;
        const dm_asset asset = create(t);
        dm_object object = 0;
        dm_part_info part = dm_part_info_default();
        dm_joint joint = dm_joint_default();
        const dm_joint expected = joint_of(t, asset, first);
        assert_int_equal(part_with(t, asset, HANDLE), first);
        assert_int_equal(part_with(t, asset, DOOR), 1 - first);
        assert_true(expected.upper == stated.upper && expected.source == DM_JOINT_FROM_HOST);
        assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_OK);
        assert_int_equal(dm_object_get_part(t->w.context, object, first, &part), DM_OK);
        assert_int_equal(part.id, first + 1);
        assert_true(fabsf(part.box_min.x - 0.9f) < 1e-5f && part.triangle_count == TEST_BOX_FACES);
        assert_int_equal(dm_object_get_joint(t->w.context, object, part.id, &joint), DM_OK);
        assert_same_joint(&joint, &expected);
        close_cabinet(t);
    }
}

static void test_one_node_has_no_parts(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->desc.node_count = 1;
    const dm_asset asset = create(t);
    dm_object object = 0;
    assert_int_equal(info_of(t, asset).part_count, 0);
    assert_int_equal(part_with(t, asset, BODY), DM_ASSET_NO_PART);
    assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_ERROR_EMPTY_MASK);
    close_cabinet(t);
}

/* ---- the same for any workers, memory, progress ---- */

static int32_t DM_CALL run_backwards(void* user, uint32_t count, dm_task task, void* data) {
    (void)user;
    for (uint32_t i = count; i-- > 0;) task(data, i);
    return 1;
}

static void test_workers_change_nothing(void** state) {
    (void)state;
    test_asset *t = open_cabinet(), *other = new_asset();
    other->w.desc.jobs = (dm_jobs){NULL, run_backwards};
    fill_cabinet(other);
    const dm_asset a = create(t), b = create(other);
    const uint32_t count = info_of(t, a).part_count;
    assert_int_equal(count, info_of(other, b).part_count);
    for (uint32_t i = 0; i < count; i++) {
        const dm_joint x = joint_of(t, a, i), y = joint_of(other, b, i);
        const dm_asset_part p = part_of(t, a, i), q = part_of(other, b, i);
        assert_same_joint(&x, &y);
        assert_memory_equal(&p, &q, sizeof p);
    }
    close_cabinet(other);
    close_cabinet(t);
}

/* Each allocation fails, and those after it. */
static void test_failing_memory(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    t->desc.model = 0; /* the networks are no part of this */
    t->w.memory.calls = 0;
    const dm_asset whole = create(t);
    const int64_t calls = t->w.memory.calls;
    assert_int_equal(dm_asset_destroy(t->w.context, whole), DM_OK);
    const int64_t live = test_world_blocks(&t->w);
    int64_t coped = 0;
    for (int64_t n = 0; n < calls; n++) {
        dm_asset asset = 0;
        t->w.memory.calls = 0;
        t->w.memory.fail_at = n;
        t->w.memory.fail_once = false; /* else the kept memory is given back, and the second try succeeds */
        const dm_result result = dm_asset_create(t->w.context, &t->desc, &asset);
        if (result == DM_OK) { /* it did without */
            coped++;
            assert_int_equal(dm_asset_destroy(t->w.context, asset), DM_OK);
        } else {
            assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            assert_int_equal(asset, 0);
        }
        assert_int_equal(test_world_blocks(&t->w), live);
    }
    t->w.memory.fail_at = TEST_NEVER;
    assert_true(calls > 20 && coped < calls / 10);
    close_cabinet(t);
}

typedef struct reports {
    float last;
    int count, cancel_at; /* cancel_at: the report that asks to stop; 0: none */
} reports;

static int32_t DM_CALL on_progress(void* user, float done) {
    reports* r = user;
    assert_true(done >= r->last && done <= 1);
    r->last = done;
    return ++r->count == r->cancel_at;
}

static void test_progress_and_cancelling(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    reports all = {0};
    t->desc.progress = on_progress;
    t->desc.progress_user = &all;
    assert_int_equal(dm_asset_destroy(t->w.context, create(t)), DM_OK);
    assert_true(all.last == 1 && all.count > 10);
    const int64_t live = test_world_blocks(&t->w);
    for (int i = 1; i <= all.count; i++) {
        dm_asset asset = 0;
        reports some = {.cancel_at = i};
        t->desc.progress_user = &some;
        assert_int_equal(dm_asset_create(t->w.context, &t->desc, &asset), DM_ERROR_CANCELLED);
        assert_non_null(strstr(t->w.messages.text, "dm_asset_create"));
        assert_int_equal(test_world_blocks(&t->w), live);
    }
    close_cabinet(t);
}

/* ---- what is refused ---- */

static float no_number[16] = {NAN, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
static float row_major[16] = {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
static const dm_pivot bad_pivot = {.origin = {NAN, 0, 0}};
static const float two_times[2] = {1, 0};
static const dm_pose two_poses[2] = {{.real = {0, 0, 0, 1}}, {.real = {0, 0, 0, 2}}};
static dm_asset_clip clip = {.times = two_times, .poses = two_poses, .key_count = 2};
static dm_joint bad_joint = {.struct_size = sizeof bad_joint, .type = DM_JOINT_REVOLUTE, .upper = 1};

static void no_nodes(test_asset* t) {
    t->desc.node_count = 0;
}
static void no_list(test_asset* t) {
    t->desc.nodes = NULL;
}
static void many_nodes(test_asset* t) {
    t->desc.node_count = DM_MAX_ASSET_NODES + 1;
}
static void no_mesh(test_asset* t) {
    for (int i = 0; i < NODES; i++) t->nodes[i].mesh = NULL;
}
static void only_followers(test_asset* t) {
    for (int i = 0; i < NODES; i++) t->nodes[i].flags = DM_ASSET_NODE_FOLLOWS, t->nodes[i].follows = DM_ASSET_NO_NODE;
}
static void short_node(test_asset* t) {
    t->nodes[0].struct_size = 8;
}
static void other_node(test_asset* t) {
    t->nodes[1].struct_size = sizeof t->nodes[1] - 8;
}
static void far_parent(test_asset* t) {
    t->nodes[1].parent = 3;
}
static void own_parent(test_asset* t) {
    t->nodes[0].parent = 0;
}
static void circle(test_asset* t) {
    t->nodes[DOOR].parent = HANDLE;
}
static void circle_of_followers(test_asset* t) {
    t->nodes[1].flags = t->nodes[2].flags = DM_ASSET_NODE_FOLLOWS;
    t->nodes[1].follows = 2;
    t->nodes[2].follows = 1;
}
static void far_follower(test_asset* t) {
    t->nodes[1].flags = DM_ASSET_NODE_FOLLOWS, t->nodes[1].follows = 99;
}
static void strange_flag(test_asset* t) {
    t->nodes[1].flags = 64;
}
static void strange_flags(test_asset* t) {
    t->desc.flags = DM_PREPARE_NETWORK_ALONE;
}
static void reserved_node(test_asset* t) {
    t->nodes[1].reserved = 1;
}
static void reserved_desc(test_asset* t) {
    t->desc.reserved = 1;
}
static void nan_transform(test_asset* t) {
    t->nodes[1].transform = no_number;
}
static void rows_first(test_asset* t) {
    t->nodes[1].transform = row_major;
}
static void nan_pivot(test_asset* t) {
    t->nodes[1].pivot = &bad_pivot;
}
static void latin_name(test_asset* t) {
    t->nodes[1].name = "T\xfcr";
}
static void latin_mesh(test_asset* t) {
    t->nodes[1].mesh_name = "T\xfcr";
}
static void part_ids(test_asset* t) {
    t->meshes[1].part_ids = t->shapes[1].part;
    t->meshes[1].part_id_bytes = sizeof *t->shapes[1].part * TEST_BOX_FACES;
    t->meshes[1].part_id_scope = DM_PER_FACE;
}
static void far_index(test_asset* t) {
    t->shapes[1].corners[3][0] = 999;
}
static void nan_vertex(test_asset* t) {
    t->shapes[1].xyz[3][0] = NAN;
}
static void missing_clips(test_asset* t) {
    t->nodes[1].clip_count = 1;
}
static void falling_times(test_asset* t) {
    t->nodes[1].clips = &clip, t->nodes[1].clip_count = 1;
}
static void no_axis(test_asset* t) {
    t->nodes[1].joint = &bad_joint;
}
static void strange_moves(test_asset* t) {
    t->desc.min_moves = 2;
}
static void nan_up(test_asset* t) {
    t->desc.up.x = NAN;
}
static void stale_model(test_asset* t) {
    t->desc.model = 12345;
}

static const struct {
    void (*spoil)(test_asset* t);
    dm_result result;
    const char* text; /* of the message */
} refusals[] = {{no_nodes, DM_ERROR_INVALID_ARGUMENT, "node_count is 0"},
                {no_list, DM_ERROR_INVALID_ARGUMENT, "desc.nodes is NULL"},
                {many_nodes, DM_ERROR_TOO_LARGE, "desc.node_count is 65537"},
                {no_mesh, DM_ERROR_INVALID_ARGUMENT, "none of desc.nodes has a mesh"},
                {only_followers, DM_ERROR_INVALID_ARGUMENT, "none of desc.nodes has a mesh"},
                {short_node, DM_ERROR_STRUCT_SIZE, "desc.nodes[0].struct_size is 8"},
                {other_node, DM_ERROR_STRUCT_SIZE, "desc.nodes[1]"},
                {far_parent, DM_ERROR_INDEX_OUT_OF_RANGE, "desc.nodes[1].parent is 3"},
                {own_parent, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[0].parent"},
                {circle, DM_ERROR_INVALID_ARGUMENT, "form a circle"},
                {circle_of_followers, DM_ERROR_INVALID_ARGUMENT, "follows"},
                {far_follower, DM_ERROR_INDEX_OUT_OF_RANGE, "desc.nodes[1].follows is 99"},
                {strange_flag, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].flags is 0x40"},
                {strange_flags, DM_ERROR_INVALID_ARGUMENT, "desc.flags is 0x2"},
                {reserved_node, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].reserved"},
                {reserved_desc, DM_ERROR_INVALID_ARGUMENT, "desc.reserved"},
                {nan_transform, DM_ERROR_NOT_FINITE, "desc.nodes[1].transform"},
                {rows_first, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].transform[3]"},
                {nan_pivot, DM_ERROR_NOT_FINITE, "desc.nodes[1].pivot"},
                {latin_name, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].name"},
                {latin_mesh, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].mesh_name"},
                {part_ids, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].mesh.part_ids"},
                {far_index, DM_ERROR_INDEX_OUT_OF_RANGE, "desc.nodes[1]"},
                {nan_vertex, DM_ERROR_NOT_FINITE, "desc.nodes[1]"},
                {missing_clips, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].clips is NULL"},
                {falling_times, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].clips[0].times[1]"},
                {no_axis, DM_ERROR_INVALID_ARGUMENT, "desc.nodes[1].joint.axis"},
                {strange_moves, DM_ERROR_INVALID_ARGUMENT, "desc.min_moves is 2"},
                {nan_up, DM_ERROR_NOT_FINITE, "desc.up"},
                {stale_model, DM_ERROR_STALE_HANDLE, "desc.model"}};

static void test_bad_input_is_named(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        test_asset* t = open_cabinet();
        const int64_t live = test_world_blocks(&t->w);
        dm_asset asset = 0;
        refusals[i].spoil(t);
        const dm_result result = dm_asset_create(t->w.context, &t->desc, &asset);
        if (result != refusals[i].result || strstr(t->w.messages.text, refusals[i].text) == NULL)
            fail_msg("refusal %zu: %s, \"%s\"", i, dm_result_string(result), t->w.messages.text);
        assert_int_equal(asset, 0);
        assert_int_equal(test_world_blocks(&t->w), live);
        close_cabinet(t);
    }
}

static void test_stale_handles(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset asset = create(t);
    dm_asset_info info = dm_asset_info_default();
    dm_object object = 0;
    assert_int_equal(dm_asset_destroy(t->w.context, asset), DM_OK);
    assert_int_equal(dm_asset_destroy(t->w.context, asset), DM_ERROR_STALE_HANDLE);
    assert_non_null(strstr(t->w.messages.text, "an asset"));
    assert_int_equal(dm_asset_get_info(t->w.context, asset, &info), DM_ERROR_STALE_HANDLE);
    assert_int_equal(dm_asset_make_object(t->w.context, asset, &object), DM_ERROR_STALE_HANDLE);
    close_cabinet(t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nodes_become_parts),
        cmocka_unit_test(test_lists_of_nodes_agree),
        cmocka_unit_test(test_a_stated_joint_is_certain),
        cmocka_unit_test(test_a_fixed_node_is_one_with_its_parent),
        cmocka_unit_test(test_pivots_by_one_rule_say_nothing),
        cmocka_unit_test(test_followers_are_no_parts),
        cmocka_unit_test(test_mirrored_nodes_keep_their_fronts),
        cmocka_unit_test(test_parents_may_come_later),
        cmocka_unit_test(test_the_object_can_be_dragged),
        cmocka_unit_test(test_the_object_has_no_parts_that_stay),
        cmocka_unit_test(test_parts_are_in_the_order_of_their_nodes),
        cmocka_unit_test(test_one_node_has_no_parts),
        cmocka_unit_test(test_workers_change_nothing),
        cmocka_unit_test(test_failing_memory),
        cmocka_unit_test(test_progress_and_cancelling),
        cmocka_unit_test(test_bad_input_is_named),
        cmocka_unit_test(test_stale_handles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
