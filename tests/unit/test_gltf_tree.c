/* Which nodes of a document are read: those of the scene that a viewer shows, but for what is no body. */
#include <stdbool.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/* Mesh 0 has no name, mesh 1 one of a shape for collisions. */
#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36}],"                                              \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"                                                              \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"                         \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]},"                                                \
    "{\"name\":\"UCX_hull\",\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"

enum { SEEN_SIZE = 256 };

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
    dm_result result;
    char seen[SEEN_SIZE]; /* names of the nodes with geometry, a space after each */
} opened;

/* scenes: with its comma, or "". */
static opened* open_nodes(const char* scenes, const char* nodes) {
    static opened o;
    char json[4096];
    dm_gltf_node node;
    const int length = snprintf(json, sizeof json, HEAD "%s\"nodes\":[%s]}", scenes, nodes);
    assert_true(length > 0 && length < (int)sizeof json);
    const test_glb glb = test_glb_pack(json, triangle, sizeof triangle);
    o = (opened){0};
    test_env_open(&o.t, TEST_NEVER);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&o.t.memory),
                               .log = test_log(&o.t.messages)};
    o.result = dm_gltf_open(&desc, &o.gltf);
    free(glb.data);
    for (uint32_t i = 0; o.result == DM_OK && dm_gltf_get_node(o.gltf, i, &node) == DM_OK; i++)
        strcat(strcat(o.seen, node.name), " ");
    return &o;
}

static void close_nodes(opened* o) {
    if (o->result == DM_OK) dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

static void assert_seen(const char* scenes, const char* nodes, const char* seen) {
    opened* o = open_nodes(scenes, nodes);
    assert_int_equal(o->result, DM_OK);
    assert_string_equal(o->seen, seen);
    close_nodes(o);
}

static void assert_refused(const char* scenes, const char* nodes, const char* said) {
    opened* o = open_nodes(scenes, nodes);
    assert_int_equal(o->result, DM_ERROR_BAD_DATA);
    if (!strstr(o->t.messages.text, said)) fail_msg("'%s' lacks '%s'", o->t.messages.text, said);
    close_nodes(o);
}

/* ---- the scene ---- */

#define TWO "{\"name\":\"a\",\"mesh\":0},{\"name\":\"b\",\"mesh\":0}"

static void the_scene_that_the_file_names_is_read(void** state) {
    (void)state;
    const char* const scenes = "\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}],";
    char named[128];
    assert_seen(scenes, TWO, "a "); /* the first, where none is named */
    for (int scene = 0; scene < 2; scene++) {
        snprintf(named, sizeof named, "\"scene\":%d,%s", scene, scenes);
        assert_seen(named, TWO, scene ? "b " : "a ");
    }
    assert_refused("\"scene\":1,\"scenes\":[{\"nodes\":[1]}],", TWO,
                   "scene must be the index of one of 1 scenes, not 1");
}

static void without_a_list_all_is_read(void** state) {
    (void)state;
    assert_seen("", TWO, "a b ");
    assert_seen("\"scene\":0,\"scenes\":[{}],", TWO, "a b ");
    assert_seen("\"scene\":0,\"scenes\":[{\"nodes\":[]}],", TWO, "a b ");
}

static void a_listed_node_brings_what_it_carries(void** state) {
    (void)state;
    const char* const nodes = "{\"name\":\"a\",\"mesh\":0,\"children\":[2]},{\"name\":\"b\",\"mesh\":0},"
                              "{\"name\":\"c\",\"mesh\":0,\"children\":[3]},{\"name\":\"d\",\"mesh\":0}";
    assert_seen("\"scenes\":[{\"nodes\":[0]}],", nodes, "a c d ");
    assert_seen("\"scenes\":[{\"nodes\":[1,3]}],", nodes, "b "); /* d comes with a, which is not shown */
}

/* ---- trees that are none ---- */

static void a_node_has_one_parent(void** state) {
    (void)state;
    assert_refused("", "{\"children\":[2]},{\"children\":[2]},{\"mesh\":0}",
                   "node 2 is a child of node 1 and of node 0");
    assert_refused("", "{\"children\":[1,1]},{\"mesh\":0}", "node 1 is a child of node 0 and of node 0");
    assert_refused("", "{\"mesh\":0,\"children\":[0]}", "node 0 is a child of node 0");
}

static void what_is_named_exists(void** state) {
    (void)state;
    assert_refused("", "{\"mesh\":0,\"children\":[1]}", "node 0 has child 1, the file has 1 nodes");
    assert_refused("\"scenes\":[{\"nodes\":[2]}],", TWO, "the scene lists node 2, the file has 2 nodes");
}

static void a_node_without_its_mesh_is_left_out_and_named(void** state) {
    (void)state;
    opened* o = open_nodes("", TWO ",{\"name\":\"c\",\"mesh\":2}");
    assert_string_equal(o->seen, "a b ");
    assert_non_null(strstr(o->t.messages.text, "node 2 'c': mesh 2 does not exist"));
    close_nodes(o);
}

static void a_rotation_of_no_length_is_none_and_named(void** state) {
    (void)state;
    opened* o = open_nodes("", "{\"name\":\"a\",\"mesh\":0},{\"name\":\"b\",\"mesh\":0,\"rotation\":[0,0,0,0]}");
    dm_gltf_node a, b;
    assert_string_equal(o->seen, "a b ");
    assert_int_equal(o->t.messages.count, 1);
    assert_non_null(strstr(o->t.messages.text, "node 1 'b': its rotation is 0 0 0 0"));
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    assert_int_equal(dm_gltf_get_node(o->gltf, 0, &a), DM_OK);
    assert_int_equal(dm_gltf_get_node(o->gltf, 1, &b), DM_OK);
    assert_int_equal(dm_gltf_get_mesh(o->gltf, &mesh), DM_OK);
    const float(*corner)[3] = (const float(*)[3])mesh.positions;
    assert_int_equal(b.vertex_count, 3);
    assert_memory_equal(corner + a.first_vertex, corner + b.first_vertex, sizeof triangle);
    close_nodes(o);
}

/* Nodes that carry each other hang from no root: nothing shows them. */
static void a_ring_of_nodes_is_not_shown(void** state) {
    (void)state;
    assert_seen("", TWO ",{\"name\":\"c\",\"mesh\":0,\"children\":[3]},{\"name\":\"d\",\"mesh\":0,\"children\":[2]}",
                "a b ");
}

/* A node that makes its mesh flat shows it, whichever way the plane lies; one that makes a line of it does not. */
static void a_flat_node_is_shown(void** state) {
    (void)state;
    static const struct {
        const char* columns;
        bool flat;
    } cases[] = {{"1,0,0,0,0,1,0,0,0,0,0,0", true},   {"1,0,0,0,0,0,0,0,0,0,1,0", true},
                 {"0,0,0,0,0,1,0,0,0,0,1,0", true},   {"1,-1,0,0,0,2,-1,0,0,0,0,0", true}, /* normal 1 1 2 */
                 {"0,1,-1,0,-1,0,2,0,0,0,0,0", true}, {"-1,0,1,0,2,-1,0,0,0,0,0,0", true},
                 {"1,0,0,0,0,0,0,0,0,0,0,0", false},  {"1,2,3,0,2,4,6,0,-1,-2,-3,0", false}};
    char node[256];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(node, sizeof node, TWO ",{\"name\":\"c\",\"mesh\":0,\"matrix\":[%s,0,0,0,1]}", cases[i].columns);
        assert_seen("", node, cases[i].flat ? "a b c " : "a b ");
    }
}

/* ---- what is no body ---- */

static void shapes_for_collisions_are_left_out(void** state) {
    (void)state;
    static const char* const colliders[] = {
        "UCX_door",         "UBX_door_01",        "USP_knob",       "UCP_bar",
        "door_collider",    "door_collider2",     "Door_Collider",  "door-colonly",
        "door-convcolonly", "door-colonly.001",   "_collider",      "bridge_collision",
        "door-collider",    "Door_Collision.002", "Gate-Collision", "crate_hitbox"};
    static const char* const bodies[] = {"door",    "collider", "UCX",      "ucx_door",         "door_collider_frame",
                                         "colonly", "007",      "wall-col", "collision_sensor", "hitbox"};
    char nodes[256], seen[64];
    for (size_t i = 0; i < sizeof colliders / sizeof *colliders; i++) {
        snprintf(nodes, sizeof nodes, "{\"name\":\"%s\",\"mesh\":0}," TWO, colliders[i]);
        assert_seen("", nodes, "a b "); /* wherever in the list it stands */
        snprintf(nodes, sizeof nodes, TWO ",{\"name\":\"%s\",\"mesh\":0}", colliders[i]);
        assert_seen("", nodes, "a b ");
    }
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++) {
        snprintf(nodes, sizeof nodes, TWO ",{\"name\":\"%s\",\"mesh\":0}", bodies[i]);
        snprintf(seen, sizeof seen, "a b %s ", bodies[i]);
        assert_seen("", nodes, seen);
    }
}

static void the_meshs_name_counts_too(void** state) {
    (void)state;
    assert_seen("", TWO ",{\"name\":\"c\",\"mesh\":1}", "a b ");
    assert_seen("", "{\"name\":\"c\",\"mesh\":1}," TWO, "a b ");
}

static void a_named_group_of_colliders_hides_all_of_them(void** state) {
    (void)state;
    assert_seen("", TWO ",{\"name\":\"house_collider\",\"children\":[3]},{\"name\":\"c\",\"mesh\":0}", "a b ");
    assert_seen("", TWO ",{\"name\":\"house\",\"children\":[3]},{\"name\":\"c\",\"mesh\":0}", "a b c ");
    /* but a collider with a mesh of its own says nothing of what it carries */
    assert_seen("", TWO ",{\"name\":\"UCX_c\",\"mesh\":0,\"children\":[3]},{\"name\":\"c\",\"mesh\":0}", "a b c ");
}

static void an_invisible_node_hides_what_it_carries(void** state) {
    (void)state;
    const char* const nodes = TWO ",{\"name\":\"c\",\"mesh\":0,\"children\":[3],\"extensions\":"
                                  "{\"KHR_node_visibility\":{\"visible\":%s}}},{\"name\":\"d\",\"mesh\":0}";
    char text[256];
    snprintf(text, sizeof text, nodes, "false");
    assert_seen("", text, "a b ");
    snprintf(text, sizeof text, nodes, "true");
    assert_seen("", text, "a b c d ");
}

/* ---- levels of detail ---- */

#define NAMED(name) "{\"name\":\"" name "\",\"mesh\":0}"

static void the_finest_of_siblings_is_shown(void** state) {
    (void)state;
    static const char* const cases[][2] = {
        {NAMED("door_LOD0") "," NAMED("door_LOD1") "," NAMED("door_LOD2"), "door_LOD0 "},
        {NAMED("door_LOD2") "," NAMED("door_LOD1"), "door_LOD1 "},
        {NAMED("door.lod_0") "," NAMED("door.lod_1"), "door.lod_0 "},
        {NAMED("LOD0_door") "," NAMED("LOD1_door"), "LOD0_door "},
        {NAMED("door_LOD0_wood_0") "," NAMED("door_LOD1_wood_0"), "door_LOD0_wood_0 "},
        {NAMED("door_LOD0") "," NAMED("door_LOD0.001") "," NAMED("door_LOD1") "," NAMED("door_LOD1.001"),
         "door_LOD0 door_LOD0.001 "},
        {NAMED("door") "," NAMED("door_LOD1"), "door "},
        {NAMED("door_LOD1") "," NAMED("lid_LOD0"), "door_LOD1 lid_LOD0 "},
        {NAMED("door_LOD1"), "door_LOD1 "},
        {NAMED("explod1") "," NAMED("explod2"), "explod1 explod2 "},
        {NAMED("lod") "," NAMED("lode1") "," NAMED("a_lod1b"), "lod lode1 a_lod1b "},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) assert_seen("", cases[i][0], cases[i][1]);
}

static void a_coarser_group_hides_what_it_holds(void** state) {
    (void)state;
    assert_seen("", "{\"name\":\"LOD0\",\"children\":[2]},{\"name\":\"LOD1\",\"children\":[3]}," TWO, "a ");
    /* a level that is nowhere shown is no reason to hide a coarser one */
    assert_seen("", "{\"name\":\"a_LOD0\"},{\"name\":\"a_LOD1\",\"mesh\":0}", "a_LOD1 ");
    /* levels of two parents, which are groups */
    assert_seen("", "{\"children\":[2]},{\"children\":[3]}," NAMED("a_LOD1") "," NAMED("a_LOD0"), "a_LOD0 ");
    /* never the finest one, however levels hold each other */
    assert_seen("", "{\"name\":\"a_LOD1\",\"mesh\":0,\"children\":[1]}," NAMED("a_LOD0"), "a_LOD1 a_LOD0 ");
}

static void msft_lod_names_coarser_nodes(void** state) {
    (void)state;
#define FINE "{\"name\":\"fine\",\"mesh\":0,\"extensions\":{\"MSFT_lod\":{\"ids\":[%s]}}},"
    static const struct {
        const char *ids, *seen;
    } cases[] = {
        {"1", "fine b "}, {"1,2", "fine "}, {"0", "fine a b "}, {"2,2,9,-1,0.5", "fine a "}, {"", "fine a b "}};
    char nodes[256];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(nodes, sizeof nodes, FINE TWO, cases[i].ids);
        assert_seen("", nodes, cases[i].seen);
    }
    snprintf(nodes, sizeof nodes, FINE "{\"name\":\"a\",\"mesh\":0,\"extensions\":{\"MSFT_lod\":{\"ids\":[0]}}}", "1");
    assert_seen("", nodes, "fine "); /* each other's level: the first stays */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_scene_that_the_file_names_is_read),
        cmocka_unit_test(without_a_list_all_is_read),
        cmocka_unit_test(a_listed_node_brings_what_it_carries),
        cmocka_unit_test(a_node_has_one_parent),
        cmocka_unit_test(what_is_named_exists),
        cmocka_unit_test(a_node_without_its_mesh_is_left_out_and_named),
        cmocka_unit_test(a_rotation_of_no_length_is_none_and_named),
        cmocka_unit_test(a_ring_of_nodes_is_not_shown),
        cmocka_unit_test(a_flat_node_is_shown),
        cmocka_unit_test(shapes_for_collisions_are_left_out),
        cmocka_unit_test(the_meshs_name_counts_too),
        cmocka_unit_test(a_named_group_of_colliders_hides_all_of_them),
        cmocka_unit_test(an_invisible_node_hides_what_it_carries),
        cmocka_unit_test(the_finest_of_siblings_is_shown),
        cmocka_unit_test(a_coarser_group_hides_what_it_holds),
        cmocka_unit_test(msft_lod_names_coarser_nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
