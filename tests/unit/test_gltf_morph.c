/* Morph targets: a mesh stands as the weights at rest say. */
#include <math.h>
#include <stdio.h>

#include "test_glb.h"
#include "test_gltf.h"

/* A triangle, and two targets of it: up by 1, and the second vertex away by 2. */
static const float vertices[9][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1},
                                     {0, 0, 1}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":108}],\"bufferViews\":[{\"buffer\":0,"              \
    "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":72,"           \
    "\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"      \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":2,\"type\":\"VEC3\"}],"
#define MESH(second, weights)                                                                                          \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1},{"                    \
    "\"POSITION\":" second "}]}]" weights "}],"

static dm_gltf* open_morphs(test_env* t, const char* json) {
    const test_glb glb = test_glb_pack(json, vertices, sizeof vertices);
    test_env_open(t, TEST_NEVER);
    dm_gltf* gltf = test_gltf_open(t, glb.data, glb.size);
    free(glb.data);
    return gltf;
}

static void close_morphs(test_env* t, dm_gltf* gltf) {
    dm_gltf_close(gltf);
    test_env_close(t);
}

/* Expects where the second vertex of a node is: at x, 0, z. */
static void expect_second(const dm_gltf* gltf, uint32_t node, float x, float z) {
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    dm_gltf_node found;
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    assert_int_equal(dm_gltf_get_node(gltf, node, &found), DM_OK);
    const float* second = (const float*)mesh.positions + 3 * (found.first_vertex + 1);
    if (!(fabsf(second[0] - x) < 1e-6f && fabsf(second[2] - z) < 1e-6f))
        fail_msg("node %u: (%g %g %g), not x %g, z %g", node, second[0], second[1], second[2], x, z);
}

static void weights_of_the_mesh_move_vertices(void** state) {
    (void)state;
    static const struct {
        const char* json;
        float x, z;
    } cases[] = {
        {HEAD MESH("2", ",\"weights\":[0,0]") "\"nodes\":[{\"mesh\":0}]}", 1, 0},
        {HEAD MESH("2", "") "\"nodes\":[{\"mesh\":0}]}", 1, 0},
        {HEAD MESH("2", ",\"weights\":[1,0.5]") "\"nodes\":[{\"mesh\":0}]}", 2, 1},
        {HEAD MESH("2", ",\"weights\":[-2]") "\"nodes\":[{\"mesh\":0}]}", 1, -2},
        {HEAD MESH("2", ",\"weights\":[0,1,9]") "\"nodes\":[{\"mesh\":0}]}", 3, 0},
        {HEAD MESH("2", ",\"weights\":[1,1]") "\"nodes\":[{\"mesh\":0,\"weights\":[0,1]}]}", 3, 0},
        {HEAD MESH("2", ",\"weights\":[1,1]") "\"nodes\":[{\"mesh\":0,\"weights\":[0,0]}]}", 1, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        dm_gltf* gltf = open_morphs(&t, cases[i].json);
        expect_second(gltf, 0, cases[i].x, cases[i].z);
        assert_int_equal(t.messages.count, 0);
        assert_int_equal(dm_gltf_left_out(gltf), 0);
        close_morphs(&t, gltf);
    }
}

static void nodes_of_one_mesh_have_their_own_weights(void** state) {
    (void)state;
    test_env t;
    dm_gltf* gltf = open_morphs(
        &t,
        HEAD MESH(
            "2",
            ",\"weights\":[1,0]") "\"nodes\":[{\"mesh\":0},{\"mesh\":0,"
                                  "\"weights\":[0,1]},{\"mesh\":0,\"weights\":[1,0]},{\"mesh\":0,\"weights\":[0]}]}");
    expect_second(gltf, 0, 1, 1);
    expect_second(gltf, 1, 3, 0);
    expect_second(gltf, 2, 1, 1);
    expect_second(gltf, 3, 1, 0);
    close_morphs(&t, gltf);
}

static void a_target_that_does_not_fit_is_left_out(void** state) {
    (void)state;
    static const char* const seconds[] = {"3", "9"};
    for (size_t i = 0; i < 2; i++) {
        char json[2048];
        test_env t;
        snprintf(json, sizeof json, HEAD MESH("%s", ",\"weights\":[1,1]") "\"nodes\":[{\"mesh\":0}]}", seconds[i]);
        dm_gltf* gltf = open_morphs(&t, json);
        expect_second(gltf, 0, 1, 1);
        assert_non_null(strstr(t.messages.text, i == 0 ? "a morph target does not fit its vertices; left out"
                                                       : "accessor 9 does not exist; left out"));
        close_morphs(&t, gltf);
    }
}

/* What is written moves the triangles that it has as the file did. */
static void a_moving_half_keeps_its_targets(void** state) {
    (void)state;
    const dm_pose poses[2] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}, {{0, 0, 0, 1}, {0, 0.5f, 0, 0}}};
    const float times[2] = {0, 1};
    const uint8_t ids[2] = {0, 1};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    static const char* const json = HEAD
        "\"meshes\":[{\"weights\":[1,0],\"primitives\":[{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1},"
        "{\"POSITION\":2}]},{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":2}]}]}],"
        "\"nodes\":[{\"mesh\":0,\"weights\":[0.5]}]}";
    void* data;
    size_t size;
    test_env t, again;
    dm_gltf* gltf = open_morphs(&t, json);
    assert_int_equal(dm_gltf_export(gltf, &track, 1, &data, &size), DM_OK);
    test_env_open(&again, TEST_NEVER);
    dm_gltf* written = test_gltf_open(&again, data, size);
    assert_int_equal(dm_gltf_node_count(written), 2);
    expect_second(gltf, 0, 1, 0.5f);
    dm_mesh_desc mesh = {.struct_size = sizeof mesh};
    assert_int_equal(dm_gltf_get_mesh(written, &mesh), DM_OK);
    assert_int_equal(mesh.index_count, 6);
    close_morphs(&again, written);
    dm_gltf_release_bytes(gltf, data, size);
    close_morphs(&t, gltf);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_of_the_mesh_move_vertices),
        cmocka_unit_test(nodes_of_one_mesh_have_their_own_weights),
        cmocka_unit_test(a_target_that_does_not_fit_is_left_out),
        cmocka_unit_test(a_moving_half_keeps_its_targets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
