/* Whole assets: nodes with meshes, names and a hierarchy go in, parts with joints come out. */
#include <math.h>

#include "test_world.h"

enum { NODES = 8, BODY = 0, DOOR, HANDLE, GROUP, DRAWER };

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

static test_asset* open_cabinet(void) {
    test_asset* t = calloc(1, sizeof *t);
    assert_non_null(t);
    test_world_init(&t->w);
    test_world_open(&t->w);
    test_world_load_model(&t->w);
    put_box(t, BODY, "carcase", (const float[]){0, 0, 0}, (const float[]){2, 1, 1});
    put_box(t, DOOR, "door", (const float[]){0, 0, 1.01f}, (const float[]){1, 1, 1.05f});
    put_box(t, HANDLE, "handle", (const float[]){0.9f, 0.4f, 1.05f}, (const float[]){0.92f, 0.6f, 1.07f});
    t->nodes[HANDLE].parent = DOOR;
    t->desc = (dm_asset_desc){
        .struct_size = sizeof t->desc, .nodes = t->nodes, .node_count = 3, .model = t->w.model, .seed = 7};
    return t;
}

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

static dm_asset_part part_of(test_asset* t, dm_asset asset, uint32_t index) {
    dm_asset_part part = dm_asset_part_default();
    assert_int_equal(dm_asset_get_part(t->w.context, asset, index, &part), DM_OK);
    return part;
}

/* ---- what comes out ---- */

/* The carcase is the largest node and stays; the door moves, and carries the handle, which hangs below it. */
static void test_nodes_become_parts(void** state) {
    (void)state;
    test_asset* t = open_cabinet();
    const dm_asset asset = create(t);
    dm_asset_info info = dm_asset_info_default();
    assert_int_equal(dm_asset_get_info(t->w.context, asset, &info), DM_OK);
    assert_int_equal(info.node_count, 3);
    assert_int_equal(info.part_count, 2);
    assert_int_equal(info.triangle_count, 3 * TEST_BOX_FACES);
    const dm_asset_part door = part_of(t, asset, 0), handle = part_of(t, asset, 1);
    assert_int_equal(door.parent, DM_ASSET_NO_PART);
    assert_int_equal(handle.parent, 0);
    uint32_t node, parts[3];
    assert_int_equal(dm_asset_get_part_nodes(t->w.context, asset, 1, &node, 1), DM_OK);
    assert_int_equal(node, HANDLE);
    assert_int_equal(dm_asset_get_node_parts(t->w.context, asset, parts, 3), DM_OK);
    assert_int_equal(parts[BODY], DM_ASSET_NO_PART);
    assert_int_equal(parts[DOOR], 0);
    assert_int_equal(parts[HANDLE], 1);
    close_cabinet(t);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nodes_become_parts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
