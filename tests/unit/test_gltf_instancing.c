/* EXT_mesh_gpu_instancing: each instance is read, as a node of its own. */
#include <math.h>
#include <stdio.h>

#include "test_glb.h"
#include "test_gltf.h"

enum { INSTANCES = 3 };

/* A triangle, and where its instances are: translations, turns (the second by a half about z), scales. */
typedef struct bin {
    float triangle[3][3], translations[INSTANCES][3], rotations[INSTANCES][4], scales[INSTANCES][3];
} bin;

static const bin usual = {.triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                          .translations = {{0, 0, 0}, {0, 0, 5}, {0, 0, 9}},
                          .rotations = {{0, 0, 0, 1}, {0, 0, 1, 0}, {0, 0, 0, 1}},
                          .scales = {{1, 1, 1}, {1, 1, 1}, {2, 2, 2}}};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"EXT_mesh_gpu_instancing\"],\"extensionsRequired\":"        \
    "[\"EXT_mesh_gpu_instancing\"],\"buffers\":[{\"byteLength\":156}],\"bufferViews\":["                               \
    "{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36},"                             \
    "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":120,\"byteLength\":36}],"         \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                          \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"                                         \
    "{\"bufferView\":3,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":2,\"type\":\"VEC3\"}],"                                        \
    "\"meshes\":[{\"name\":\"leaf\",\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":"
#define NODE(attributes)                                                                                               \
    "[{\"name\":\"rack\",\"translation\":[10,0,0],\"children\":[1]},{\"name\":\"box\",\"mesh\":0,\"extensions\":"      \
    "{\"EXT_mesh_gpu_instancing\":{\"attributes\":" attributes "}}}]}"
#define ALL NODE("{\"TRANSLATION\":1,\"ROTATION\":2,\"SCALE\":3,\"_ID\":77}")

static dm_gltf* open_instances(test_env* t, const char* json, const bin* from) {
    const test_glb glb = test_glb_pack(json, from, sizeof *from);
    test_env_open(t, TEST_NEVER);
    dm_gltf* gltf = test_gltf_open(t, glb.data, glb.size);
    free(glb.data);
    return gltf;
}

static void close_instances(test_env* t, dm_gltf* gltf) {
    dm_gltf_close(gltf);
    test_env_close(t);
}

static dm_mesh_desc mesh_of(const dm_gltf* gltf) {
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    return mesh;
}

static void each_instance_is_a_node(void** state) {
    (void)state;
    static const float corner[INSTANCES][3] = {{11, 0, 0}, {9, 0, 5}, {12, 0, 9}}; /* of the second vertex */
    static const char* const names[INSTANCES] = {"box.0", "box.1", "box.2"};
    test_env t;
    dm_gltf* gltf = open_instances(&t, HEAD ALL, &usual);
    const dm_mesh_desc mesh = mesh_of(gltf);
    char label[64];
    dm_pivot pivot;
    dm_gltf_node node;
    assert_int_equal(dm_gltf_node_count(gltf), INSTANCES);
    assert_int_equal(mesh.index_count, 3 * INSTANCES);
    for (uint32_t i = 0; i < INSTANCES; i++) {
        const float* second = (const float*)mesh.positions + 3 * (3 * (size_t)i + 1);
        assert_int_equal(dm_gltf_get_node(gltf, i, &node), DM_OK);
        assert_string_equal(node.name, names[i]);
        assert_int_equal(node.carrier, DM_GLTF_NO_CARRIER);
        for (int k = 0; k < 3; k++) assert_true(fabsf(second[k] - corner[i][k]) < 1e-6f);
    }
    assert_int_equal(dm_gltf_get_hints(gltf, "box.1", label, sizeof label, &pivot), DM_OK);
    assert_string_equal(label, "rack/box/leaf/box.1");
    assert_true(pivot.origin.x == 10 && pivot.origin.z == 5);
    assert_int_equal(dm_gltf_left_out(gltf), 0);
    assert_int_equal(dm_gltf_pivots_are_lost(gltf), 0);
    assert_int_equal(t.messages.count, 0);
    close_instances(&t, gltf);
}

/* The name of the node that had the instances means all of them. */
static void the_nodes_name_means_all(void** state) {
    (void)state;
    static const char *const all = "box", *const one = "box.2";
    test_env t;
    dm_gltf* gltf = open_instances(&t, HEAD ALL, &usual);
    uint8_t ids[INSTANCES] = {0};
    assert_int_equal(dm_gltf_mark_faces(gltf, &all, 1, 1, ids, INSTANCES), DM_OK);
    assert_memory_equal(ids, ((uint8_t[INSTANCES]){1, 1, 1}), INSTANCES);
    assert_int_equal(dm_gltf_mark_faces(gltf, &one, 1, 2, ids, INSTANCES), DM_OK);
    assert_memory_equal(ids, ((uint8_t[INSTANCES]){1, 1, 2}), INSTANCES);
    close_instances(&t, gltf);
}

static void one_of_them_is_animated(void** state) {
    (void)state;
    const dm_pose poses[2] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}, {{0, 0, 0, 1}, {0, 0.5f, 0, 0}}};
    const float times[2] = {0, 1};
    const uint8_t ids[INSTANCES] = {0, 1, 0};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    void* data;
    size_t size;
    test_env t, again;
    dm_gltf* gltf = open_instances(&t, HEAD ALL, &usual);
    assert_int_equal(dm_gltf_export(gltf, &track, 1, &data, &size), DM_OK);
    char* json = test_glb_json(data);
    assert_null(strstr(json, "EXT_mesh_gpu_instancing"));
    free(json);
    test_env_open(&again, TEST_NEVER);
    dm_gltf* written = test_gltf_open(&again, data, size);
    assert_int_equal(dm_gltf_node_count(written), INSTANCES);
    assert_memory_equal(mesh_of(written).positions, mesh_of(gltf).positions, 9 * INSTANCES * sizeof(float));
    close_instances(&again, written);
    dm_gltf_release_bytes(gltf, data, size);
    close_instances(&t, gltf);
}

static void what_can_not_be_read_is_said(void** state) {
    (void)state;
    static const struct {
        const char *json, *says;
        uint32_t count;
    } cases[] = {{HEAD NODE("{\"TRANSLATION\":4,\"ROTATION\":2}"), "3 instances have a ROTATION, not 2", 1},
                 {HEAD NODE("{\"TRANSLATION\":2}"), "TRANSLATION of its instances has 4 components", 1},
                 {HEAD NODE("{\"TRANSLATION\":9}"), "accessor 9 does not exist", 1},
                 {HEAD NODE("{\"TRANSLATION\":4}"), NULL, 2},
                 {HEAD NODE("{\"TRANSLATION\":\"1\"}"), NULL, 1},
                 {HEAD NODE("{}"), NULL, 1},
                 {HEAD NODE("7"), NULL, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        dm_gltf* gltf = open_instances(&t, cases[i].json, &usual);
        assert_int_equal(dm_gltf_node_count(gltf), cases[i].count);
        assert_int_equal(dm_gltf_left_out(gltf), cases[i].says != NULL);
        if (cases[i].says && !strstr(t.messages.text, cases[i].says)) fail_msg("'%s'", t.messages.text);
        close_instances(&t, gltf);
    }
    bin bad = usual;
    bad.translations[1][2] = INFINITY;
    test_env t;
    dm_gltf* gltf = open_instances(&t, HEAD ALL, &bad);
    assert_int_equal(dm_gltf_node_count(gltf), 2);
    assert_int_equal(dm_gltf_left_out(gltf), 1);
    assert_non_null(strstr(t.messages.text, "1 of its 3 instances are nowhere"));
    close_instances(&t, gltf);
}

/* Instances without bytes, more than the file may cost. */
static void too_many_are_refused(void** state) {
    (void)state;
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":40}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
        "\"type\":\"VEC3\"},{\"componentType\":5126,\"count\":100000000,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"
        "\"indices\":{\"bufferView\":0,\"componentType\":5121},\"values\":{\"bufferView\":0}}}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":" NODE("{\"TRANSLATION\":1}");
    const test_glb glb = test_glb_pack(json, &usual, 40);
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&t.memory),
                               .log = test_log(&t.messages)};
    dm_gltf* gltf;
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_ERROR_TOO_LARGE);
    free(glb.data);
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_instance_is_a_node), cmocka_unit_test(the_nodes_name_means_all),
        cmocka_unit_test(one_of_them_is_animated), cmocka_unit_test(what_can_not_be_read_is_said),
        cmocka_unit_test(too_many_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
