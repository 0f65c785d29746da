/* A glTF scene as the nodes of an asset. */
#include <math.h>
#include <stdio.h>

#include "test_gltf_nodes.h"

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,"               \
    "\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"     \
    "\"meshes\":[{\"name\":\"board\",\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"

static const dm_asset_node* node_of(const test_gltf_nodes* o, const char* name) {
    return &o->nodes[test_gltf_nodes_find(o, name)];
}

static void groups_stand_above_what_they_hold(void** state) {
    (void)state;
    test_gltf_nodes o;
    uint32_t file_node;
    test_gltf_nodes_open(
        &o,
        HEAD "\"nodes\":[{\"name\":\"root\",\"children\":[1,4],\"translation\":[0,0,2]},"
             "{\"name\":\"door\",\"children\":[2,3]},{\"name\":\"wood\",\"mesh\":0,\"translation\":[5,0,0]},"
             "{\"mesh\":0},{\"name\":\"lamp\"},{\"name\":\"alone\",\"mesh\":0}]}",
        triangle, sizeof triangle);
    assert_int_equal(o.count, 5); /* not the lamp, which carries nothing */
    assert_string_equal(o.nodes[0].name, "wood");
    assert_null(o.nodes[1].name);
    assert_string_equal(o.nodes[2].name, "alone");
    assert_string_equal(o.nodes[1].mesh_name, "board");
    const uint32_t door = test_gltf_nodes_find(&o, "door"), root = test_gltf_nodes_find(&o, "root");
    assert_int_equal(o.nodes[0].parent, door);
    assert_int_equal(o.nodes[1].parent, door);
    assert_int_equal(o.nodes[2].parent, DM_ASSET_NO_NODE);
    assert_int_equal(o.nodes[door].parent, root);
    assert_int_equal(o.nodes[root].parent, DM_ASSET_NO_NODE);
    assert_null(o.nodes[door].mesh);
    assert_null(o.nodes[0].transform);
    assert_true(o.nodes[0].pivot->origin.x == 5 && o.nodes[0].pivot->origin.z == 2);
    assert_int_equal(o.nodes[0].flags, 0);
    assert_int_equal(dm_gltf_get_asset_node(o.gltf, door, &file_node), DM_OK);
    assert_int_equal(file_node, 1);
    assert_int_equal(dm_gltf_get_asset_node(o.gltf, 5, &file_node), DM_ERROR_NOT_FOUND);
    test_gltf_nodes_close(&o);
}

static void meshes_are_those_of_the_merged_mesh(void** state) {
    (void)state;
    test_gltf_nodes o;
    test_gltf_nodes_open(&o, HEAD "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"translation\":[5,0,0],\"scale\":[-1,1,1]}]}",
                         triangle, sizeof triangle);
    for (uint32_t i = 0; i < 2; i++) {
        const dm_mesh_desc* mesh = o.nodes[i].mesh;
        assert_int_equal(mesh->struct_size, sizeof *mesh);
        assert_int_equal(mesh->vertex_count, 3);
        assert_int_equal(mesh->index_count, 3);
        const uint32_t* indices = mesh->indices;
        assert_int_equal(indices[0], i == 0 ? 0 : 2); /* the mirrored one is turned over */
        assert_int_equal(indices[1], 1);
    }
    assert_true(((const float*)o.nodes[1].mesh->positions)[3] == 4);
    test_gltf_nodes_close(&o);
}

static void lost_pivots_are_said(void** state) {
    (void)state;
    test_gltf_nodes o;
    test_gltf_nodes_open(&o, HEAD "\"nodes\":[{\"mesh\":0},{\"mesh\":0}]}", triangle, sizeof triangle);
    for (uint32_t i = 0; i < 2; i++) assert_int_equal(o.nodes[i].flags, DM_ASSET_NODE_NO_PIVOT);
    test_gltf_nodes_close(&o);
}

static void what_is_no_body_follows(void** state) {
    (void)state;
#define NAMED(name) "{\"name\":\"" name "\",\"mesh\":0}"
    static const struct {
        const char* nodes;
        const char *who, *whom; /* whom NULL: none */
    } cases[] = {
        {NAMED("a") "," NAMED("door_LOD0") "," NAMED("door_LOD1"), "door_LOD1", "door_LOD0"},
        {NAMED("a") "," NAMED("door") "," NAMED("UCX_door_01"), "UCX_door_01", "door"},
        {NAMED("a") "," NAMED("door_01") "," NAMED("UCX_door_01"), "UCX_door_01", "door_01"},
        {NAMED("a") "," NAMED("door") "," NAMED("door-colonly.001"), "door-colonly.001", "door"},
        {NAMED("a") "," NAMED("UCX_lid"), "UCX_lid", NULL},
        {"{\"name\":\"a\",\"mesh\":0,\"children\":[1]}," NAMED("hull_collider"), "hull_collider", "a"},
        {"{\"name\":\"a\",\"mesh\":0,\"children\":[1]},{\"name\":\"ghost\",\"mesh\":0,\"extensions\":{"
         "\"KHR_node_visibility\":{\"visible\":false}}}",
         "ghost", "a"},
        {"{\"name\":\"LOD0\",\"children\":[2]},{\"name\":\"LOD1\",\"children\":[3]}," NAMED("lid") "," NAMED("lid.001"),
         "lid.001", "lid"},
        {NAMED("low") ",{\"name\":\"high\",\"mesh\":0,\"extensions\":{\"MSFT_lod\":{\"ids\":[0]}}}", "low", "high"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char json[2048];
        test_gltf_nodes o;
        snprintf(json, sizeof json, HEAD "\"nodes\":[%s]}", cases[i].nodes);
        test_gltf_nodes_open(&o, json, triangle, sizeof triangle);
        const dm_asset_node* who = node_of(&o, cases[i].who);
        assert_int_equal(who->flags & DM_ASSET_NODE_FOLLOWS, DM_ASSET_NODE_FOLLOWS);
        assert_null(who->mesh);
        assert_int_equal(who->follows, cases[i].whom ? test_gltf_nodes_find(&o, cases[i].whom) : DM_ASSET_NO_NODE);
        test_gltf_nodes_close(&o);
    }
}

/* A level that the scene does not list comes with the finest one; what no scene has does not come. */
static void the_scene_decides(void** state) {
    (void)state;
    test_gltf_nodes o;
    test_gltf_nodes_open(
        &o,
        HEAD "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"high\",\"mesh\":0,\"extensions\":{\"MSFT_lod\":"
             "{\"ids\":[1]}}}," NAMED("low") "," NAMED("elsewhere") "]}",
        triangle, sizeof triangle);
    assert_int_equal(o.count, 2);
    assert_int_equal(node_of(&o, "low")->follows, 0);
    test_gltf_nodes_close(&o);
}

/* Two triangles of two bones, one with a corner of the other bone. */
static void bones_bring_the_vertices_of_their_triangles(void** state) {
    (void)state;
    static const struct {
        float positions[5][3], weights[5][4];
        uint8_t joints[5][4];
        uint16_t indices[6];
    } bin = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
             .weights = {{1}, {1}, {1}, {1}, {1}},
             .joints = {{0}, {0}, {0}, {1}, {1}},
             .indices = {0, 1, 2, 1, 3, 4}};
    test_gltf_nodes o;
    test_gltf_nodes_open(
        &o,
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":172}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":60},{\"buffer\":0,\"byteOffset\":60,\"byteLength\":80},"
        "{\"buffer\":0,\"byteOffset\":140,\"byteLength\":20},{\"buffer\":0,\"byteOffset\":160,\"byteLength\":12}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":5,\"type\":\"VEC3\"},"
        "{\"bufferView\":1,\"componentType\":5126,\"count\":5,\"type\":\"VEC4\"},"
        "{\"bufferView\":2,\"componentType\":5121,\"count\":5,\"type\":\"VEC4\"},"
        "{\"bufferView\":3,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}],"
        "\"meshes\":[{\"name\":\"chest\",\"primitives\":[{\"attributes\":{\"POSITION\":0,\"WEIGHTS_0\":1,"
        "\"JOINTS_0\":2},\"indices\":3}]}],\"skins\":[{\"joints\":[1,2]}],\"nodes\":["
        "{\"name\":\"skinned\",\"mesh\":0,\"skin\":0},{\"name\":\"base\",\"children\":[2]},{\"name\":\"lid\"}]}",
        &bin, sizeof bin);
    assert_int_equal(o.count, 2);
    const dm_asset_node *base = node_of(&o, "base"), *lid = node_of(&o, "lid");
    assert_int_equal(lid->parent, test_gltf_nodes_find(&o, "base"));
    assert_string_equal(lid->mesh_name, "chest");
    assert_int_equal(base->mesh->vertex_count, 3);
    assert_int_equal(lid->mesh->vertex_count, 3);
    const uint32_t* corners = lid->mesh->indices;
    const float* positions = lid->mesh->positions;
    static const float want[3] = {1, 2, 2};
    for (int c = 0; c < 3; c++) assert_true(positions[3 * corners[c]] == want[c]);
    test_gltf_nodes_close(&o);
}

/* An export moves what follows a part along with it. */
static void followers_go_along(void** state) {
    (void)state;
    const dm_pose poses[2] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}, {{0, 0, 0, 1}, {0, 0.5f, 0, 0}}};
    const float times[2] = {0, 1};
    const uint8_t ids[2] = {0, 1};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    static const char* const followers[] = {"door_LOD1", "UCX_door_LOD0"};
    test_gltf_nodes o, again;
    void* data;
    size_t size;
    test_gltf_nodes_open(&o,
                         HEAD "\"nodes\":[" NAMED("body") "," NAMED("door_LOD0") "," NAMED("door_LOD1") "," NAMED(
                             "UCX_door_LOD0") "," NAMED("UCX_body") "]}",
                         triangle, sizeof triangle);
    assert_int_equal(dm_gltf_export(o.gltf, &track, 1, &data, &size), DM_OK);
    again = (test_gltf_nodes){.count = 0};
    test_env_open(&again.t, TEST_NEVER);
    again.gltf = test_gltf_open(&again.t, data, size);
    assert_int_equal(dm_gltf_get_asset(again.gltf, 0, &again.nodes, &again.count), DM_OK);
    const dm_asset_node* door = node_of(&again, "door_LOD0");
    assert_int_not_equal(door->parent, DM_ASSET_NO_NODE);
    for (size_t i = 0; i < 2; i++) {
        const dm_asset_node* follower = node_of(&again, followers[i]);
        assert_int_equal(follower->parent, door->parent);
        assert_int_equal(follower->follows, test_gltf_nodes_find(&again, "door_LOD0"));
    }
    assert_int_equal(node_of(&again, "UCX_body")->parent, DM_ASSET_NO_NODE);
    assert_int_equal(node_of(&again, "moving_part")->clip_count, 1);
    test_gltf_nodes_close(&again);
    dm_gltf_release_bytes(o.gltf, data, size);
    test_gltf_nodes_close(&o);
}

static void arguments_are_checked(void** state) {
    (void)state;
    test_gltf_nodes o;
    const dm_asset_node* again;
    uint32_t count;
    test_gltf_nodes_open(&o, HEAD "\"nodes\":[{\"mesh\":0}]}", triangle, sizeof triangle);
    assert_int_equal(dm_gltf_get_asset(o.gltf, 0, &again, &count), DM_OK);
    assert_ptr_equal(again, o.nodes); /* the same list, however often it is asked for */
    assert_int_equal(dm_gltf_get_asset(o.gltf, 1, &again, &count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_asset(NULL, 0, &again, &count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_asset(o.gltf, 0, NULL, &count), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_asset(o.gltf, 0, &again, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_asset_node(o.gltf, 0, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_get_asset_node(NULL, 0, &count), DM_ERROR_INVALID_ARGUMENT);
    test_gltf_nodes_close(&o);
}

/* Each allocation may fail: the file stays usable. */
static void no_failed_allocation_is_passed_over(void** state) {
    (void)state;
    const test_glb glb =
        test_glb_pack(HEAD "\"nodes\":[{\"mesh\":0,\"extras\":{\"dragmesh_joint\":{\"type\":\"revolute\","
                           "\"axis\":[0,1,0]}}},{\"mesh\":0}]}",
                      triangle, sizeof triangle);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (int64_t more = 0; result != DM_OK; more++) {
        test_env t;
        const dm_asset_node* nodes;
        uint32_t count;
        test_env_open(&t, TEST_NEVER);
        dm_gltf* gltf = test_gltf_open(&t, glb.data, glb.size);
        t.memory.fail_at = t.memory.calls + more;
        result = dm_gltf_get_asset(gltf, 0, &nodes, &count);
        if (result != DM_OK) {
            assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
            t.memory.fail_at = TEST_NEVER;
            assert_int_equal(dm_gltf_get_asset(gltf, 0, &nodes, &count), DM_OK);
        }
        assert_int_equal(count, 2);
        dm_gltf_close(gltf);
        test_env_close(&t);
    }
    free(glb.data);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_stand_above_what_they_hold),
        cmocka_unit_test(meshes_are_those_of_the_merged_mesh),
        cmocka_unit_test(lost_pivots_are_said),
        cmocka_unit_test(what_is_no_body_follows),
        cmocka_unit_test(the_scene_decides),
        cmocka_unit_test(bones_bring_the_vertices_of_their_triangles),
        cmocka_unit_test(followers_go_along),
        cmocka_unit_test(arguments_are_checked),
        cmocka_unit_test(no_failed_allocation_is_passed_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
