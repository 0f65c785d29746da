/* Compression that a file does not need: where it does not decode, the plain data beside it is read, with a warning.
 * What a file needs, or has no plain data for, is left out, and the file says so. */
#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { TEXT = 4096, CORNERS = 3 };

/* A triangle, its corners in order, and bytes that are neither Draco's nor meshoptimizer's. */
static const struct {
    float positions[CORNERS][3];
    uint16_t corners[4];
    uint8_t nonsense[36];
} bin = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .corners = {0, 1, 2, 0}, .nonsense = {7, 7, 7}};

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},%s\"buffers\":[{\"byteLength\":80}],\"bufferViews\":["                           \
    "{\"buffer\":0,\"byteLength\":36%s},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":6},"                            \
    "{\"buffer\":0,\"byteOffset\":44,\"byteLength\":36}],\"accessors\":["                                              \
    "{%s\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                                        \
    "{\"bufferView\":1,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],"                                      \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1%s}]}],\"nodes\":[{\"mesh\":0}]}"
#define PLAIN "\"bufferView\":0,"
#define DRACO ",\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":2,\"attributes\":{\"POSITION\":0}}}"
#define MESHOPT                                                                                                        \
    ",\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":0,\"byteOffset\":44,\"byteLength\":36,"                  \
    "\"byteStride\":12,\"count\":3,\"mode\":\"ATTRIBUTES\"}}"

/* Opens the file of these pieces. Returns the result; the file is there where it is DM_OK. */
static dm_result open_pieces(test_env* t, const char* extensions, const char* view, const char* accessor,
                             const char* primitive, dm_gltf** out) {
    char json[TEXT];
    snprintf(json, sizeof json, HEAD, extensions, view, accessor, primitive);
    const test_glb glb = test_glb_pack(json, &bin, sizeof bin);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&t->memory),
                               .log = test_log(&t->messages)};
    const dm_result result = dm_gltf_open(&desc, out);
    free(glb.data);
    return result;
}

static void assert_triangle(const dm_gltf* gltf) {
    dm_mesh_desc mesh;
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    assert_int_equal(mesh.vertex_count, CORNERS);
    assert_int_equal(mesh.index_count, CORNERS);
    const float* xyz = mesh.positions;
    assert_true(xyz[3] - xyz[0] == 1 && xyz[7] - xyz[1] == 1);
}

static void optional_compression_falls_back_on_plain_data(void** state) {
    (void)state;
    static const struct {
        const char *extensions, *view, *primitive;
        int warnings;
    } cases[] = {
        {"", "", "", 0},
        {"\"extensionsUsed\":[\"KHR_draco_mesh_compression\"],", "", DRACO, 1},
        {"", "", DRACO, 1},
        {"\"extensionsUsed\":[\"EXT_meshopt_compression\"],", MESHOPT, "", 1},
        {"\"extensionsUsed\":[\"KHR_mesh_quantization\",\"VENDOR_unknown\"],", "", "", 0},
        {"\"extensionsUsed\":[\"KHR_draco_mesh_compression\",\"EXT_meshopt_compression\"],", MESHOPT, DRACO, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        dm_gltf* gltf = NULL;
        test_env_open(&t, TEST_NEVER);
        const dm_result result = open_pieces(&t, cases[i].extensions, cases[i].view, PLAIN, cases[i].primitive, &gltf);
        if (result != DM_OK) fail_msg("case %zu: %s: %s", i, dm_result_string(result), t.messages.text);
        assert_triangle(gltf);
        assert_int_equal(dm_gltf_left_out(gltf), 0);
        if (t.messages.count > cases[i].warnings) fail_msg("case %zu: %d messages", i, t.messages.count);
        if (t.messages.count > 0) assert_non_null(strstr(t.messages.text, "its plain data is read"));
        dm_gltf_close(gltf);
        t.messages.count = 0;
        test_env_close(&t);
    }
}

static void what_the_file_needs_is_not_replaced(void** state) {
    (void)state;
    static const struct {
        const char *extensions, *view, *accessor, *primitive;
    } cases[] = {
        {"\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],", "", PLAIN, DRACO},
        {"", "", "", DRACO},
        {"\"extensionsRequired\":[\"EXT_meshopt_compression\"],", MESHOPT, PLAIN, ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        test_env t;
        dm_gltf* gltf = NULL;
        test_env_open(&t, TEST_NEVER);
        assert_int_not_equal(
            open_pieces(&t, cases[i].extensions, cases[i].view, cases[i].accessor, cases[i].primitive, &gltf), DM_OK);
        assert_null(gltf);
        t.messages.count = 0;
        test_env_close(&t);
    }
}

/* A second primitive names an accessor that is not there. */
static void a_primitive_that_is_left_out_is_told(void** state) {
    (void)state;
    test_env t;
    dm_gltf* gltf = NULL;
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(open_pieces(&t, "", "", PLAIN, "},{\"attributes\":{\"POSITION\":9}", &gltf), DM_OK);
    assert_triangle(gltf);
    assert_int_equal(dm_gltf_left_out(gltf), 1);
    assert_int_equal(dm_gltf_left_out(NULL), 0);
    assert_int_equal(t.messages.count, 1);
    dm_gltf_close(gltf);
    t.messages.count = 0;
    test_env_close(&t);
}

/* However much is left out, a call says it once: how many things, and the first three. */
static void one_call_warns_once(void** state) {
    (void)state;
    enum { LEFT_OUT = 40 };
    test_env t;
    dm_gltf* gltf = NULL;
    char primitives[TEXT / 2] = "";
    for (int i = 0; i < LEFT_OUT; i++) strcat(primitives, "},{\"attributes\":{\"POSITION\":9}");
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(open_pieces(&t, "", "", PLAIN, primitives, &gltf), DM_OK);
    assert_int_equal(t.messages.count, 1);
    assert_int_equal(t.messages.level, DM_LOG_WARNING);
    assert_non_null(strstr(t.messages.text, "40 warnings"));
    assert_non_null(strstr(t.messages.text, "primitive 1: accessor 9 does not exist"));
    assert_non_null(strstr(t.messages.text, "primitive 3: accessor 9 does not exist"));
    assert_null(strstr(t.messages.text, "primitive 4"));
    assert_non_null(strstr(t.messages.text, "and 37 more"));
    dm_gltf_close(gltf);

    /* Two warnings: both, and no more. The next call does not repeat those of the one before. */
    snprintf(primitives, sizeof primitives, "%s%s", DRACO, "},{\"attributes\":{\"POSITION\":9}");
    assert_int_equal(open_pieces(&t, "", "", PLAIN, primitives, &gltf), DM_OK);
    assert_int_equal(t.messages.count, 2);
    assert_non_null(strstr(t.messages.text, "2 warnings"));
    assert_null(strstr(t.messages.text, "more"));
    dm_gltf_surface surface;
    assert_int_equal(dm_gltf_get_surface(gltf, 0, &surface), DM_OK);
    assert_int_equal(t.messages.count, 2);
    dm_gltf_close(gltf);
    t.messages.count = 0;
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(optional_compression_falls_back_on_plain_data),
        cmocka_unit_test(what_the_file_needs_is_not_replaced),
        cmocka_unit_test(a_primitive_that_is_left_out_is_told),
        cmocka_unit_test(one_call_warns_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
