/* glTF in: containers, JSON, versions, extensions and compressed views at their edges. */
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { TEXT = 4096 };

static const float triangle[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

#define REST                                                                                                           \
    "\"buffers\":[{\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{"            \
    "\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{"           \
    "\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"name\":\"n\",\"mesh\":0}]"

/* Opens bytes of exactly this size; asks for the result and for words of the message. */
static void expect(const void* data, size_t size, dm_result result, const char* says) {
    test_env t;
    dm_gltf* gltf = NULL;
    uint8_t* exact = malloc(size);
    memcpy(exact, data, size);
    test_env_open(&t, TEST_NEVER);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = exact,
                               .size = size,
                               .allocator = test_allocator(&t.memory),
                               .log = test_log(&t.messages)};
    const dm_result got = dm_gltf_open(&desc, &gltf);
    if (got != result || (says && !strstr(t.messages.text, says)))
        fail_msg("%d '%s', not %d '%s'", got, t.messages.text, result, says ? says : "");
    free(exact);
    if (result == DM_OK) { /* the bytes were needed for the call alone */
        dm_mesh_desc mesh;
        dm_gltf_get_mesh(gltf, &mesh);
        assert_int_equal(mesh.vertex_count, 3);
        assert_memory_equal(mesh.positions, triangle, sizeof triangle);
    }
    dm_gltf_close(gltf);
    test_env_close(&t);
}

static void expect_json(const char* json, dm_result result, const char* says) {
    const test_glb glb = test_glb_pack(json, triangle, sizeof triangle);
    expect(glb.data, glb.size, result, says);
    free(glb.data);
}

/* ---- containers ---- */

/* Chunks before the binary one are passed over; what comes behind the file's length is none of it. */
static void chunks_of_other_kinds(void** state) {
    (void)state;
    const test_glb glb = test_glb_pack("{\"asset\":{\"version\":\"2.0\"}," REST "}", triangle, sizeof triangle);
    const size_t head = 20 + test_glb_json_size(glb.data), bin = glb.size - head;
    for (uint32_t size = 0; size <= 8; size += 4) {
        for (int count = 0; count <= 2; count++) {
            uint8_t bytes[TEXT] = {0};
            size_t at = head;
            memcpy(bytes, glb.data, head);
            for (int i = 0; i < count; i++) {
                test_glb_u32(bytes + at, size);
                memcpy(bytes + at + 4, "XTRA", 4);
                at += 8 + size;
            }
            memcpy(bytes + at, glb.data + head, bin);
            test_glb_u32(bytes + 8, (uint32_t)(at + bin));
            expect(bytes, at + bin, DM_OK, NULL);
            expect(bytes, at + bin + 5, DM_OK, NULL);
            test_glb_u32(bytes + 8, (uint32_t)(at + bin) - 1);
            expect(bytes, at + bin, DM_ERROR_BAD_DATA, "does not fit");
            test_glb_u32(bytes + 8, (uint32_t)(at + bin) + 1);
            expect(bytes, at + bin, DM_ERROR_BAD_DATA, "the header promises");
            test_glb_u32(bytes + 8, (uint32_t)at);
            expect(bytes, at + bin, DM_ERROR_BAD_DATA, "buffer 0 has no bytes");
            for (uint32_t rest = 1; rest < 8; rest++) { /* not even the head of a chunk */
                test_glb_u32(bytes + 8, (uint32_t)at + rest);
                expect(bytes, at + bin, DM_ERROR_BAD_DATA, "the second chunk does not fit");
            }
        }
    }
    free(glb.data);
}

static void heads_of_containers(void** state) {
    (void)state;
    test_glb glb = test_glb_pack("{\"asset\":{\"version\":\"2.0\"}," REST "}", triangle, sizeof triangle);
    const uint32_t json = test_glb_json_size(glb.data), whole = (uint32_t)glb.size;
    static const struct {
        uint32_t version;
        dm_result result;
    } versions[] = {
        {0, DM_ERROR_UNSUPPORTED}, {1, DM_ERROR_UNSUPPORTED}, {3, DM_ERROR_VERSION}, {258, DM_ERROR_VERSION}};
    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        test_glb_u32(glb.data + 4, versions[i].version);
        expect(glb.data, glb.size, versions[i].result, "only 2 can be read");
    }
    test_glb_u32(glb.data + 4, 2);
    for (uint32_t length = 0; length < 20 + json; length++) { /* a length that the JSON does not fit */
        test_glb_u32(glb.data + 8, length);
        expect(glb.data, glb.size, DM_ERROR_BAD_DATA, "the JSON chunk claims");
    }
    test_glb_u32(glb.data + 8, 20 + json);
    expect(glb.data, glb.size, DM_ERROR_BAD_DATA, "buffer 0 has no bytes");
    test_glb_u32(glb.data + 8, whole);
    test_glb_u32(glb.data + 12, whole - 20);
    expect(glb.data, glb.size, DM_ERROR_BAD_DATA, "can't be parsed");
    test_glb_u32(glb.data + 12, whole - 19);
    expect(glb.data, glb.size, DM_ERROR_BAD_DATA, "the JSON chunk claims");
    test_glb_u32(glb.data + 12, json);
    glb.data[16] = 'B';
    expect(glb.data, glb.size, DM_ERROR_BAD_DATA, "the first chunk is not JSON");
    glb.data[16] = 'J';
    for (size_t size = 4; size < 20; size++)
        expect(glb.data, size, DM_ERROR_BAD_DATA, "don't hold a header and a chunk");
    expect(glb.data, glb.size, DM_OK, NULL);
    free(glb.data);
}

static void text_begins_as_an_object(void** state) {
    (void)state;
    static const struct {
        const char* text;
        const char* says;
    } texts[] = {{"{}", "asset.version"},
                 {" \t\r\n{}", "asset.version"},
                 {"\xEF\xBB\xBF{}", "asset.version"},
                 {"\xEF\xBB\xBF {}", "asset.version"},
                 {"{} \r\n\t", "asset.version"},
                 {"{}x", "can't be parsed, from byte 2 of 3 on"},
                 {"{} {}", "can't be parsed"},
                 {"{", "can't be parsed"},
                 {"[]", "not a GLB or glTF file"},
                 {" ", "not a GLB or glTF file"},
                 {"\xEF\xBB\xBF", "not a GLB or glTF file"},
                 {"\xEF\xBB", "not a GLB or glTF file"},
                 {"glT{", "not a GLB or glTF file"},
                 {"x{}", "not a GLB or glTF file"}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect(texts[i].text, strlen(texts[i].text), DM_ERROR_BAD_DATA, texts[i].says);
}

/* ---- JSON ---- */

/* 128 levels are read, 129 are not; brackets in strings are none. */
static void nesting_has_an_end(void** state) {
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        for (int depth = 126; depth <= 128; depth++) { /* the document is one level, extras another */
            char json[TEXT];
            size_t at = (size_t)sprintf(json, "{\"asset\":{\"version\":\"2.0\"}," REST ",\"extras\":%s",
                                        kind == 2 ? "[\"\\\"" : "");
            for (int i = 0; i < depth; i++) at += (size_t)sprintf(json + at, "%s", kind == 1 ? "{\"a\":" : "[");
            at += (size_t)sprintf(json + at, kind == 2 ? "\"" : "1");
            for (int i = 0; kind < 2 && i < depth; i++) at += (size_t)sprintf(json + at, kind ? "}" : "]");
            sprintf(json + at, kind == 2 ? "]}" : "}");
            const bool deep = kind < 2 && depth + 1 > 128;
            expect_json(json, deep ? DM_ERROR_BAD_DATA : DM_OK, deep ? "nests 129 deep, 128 is the most" : NULL);
        }
    }
}

static void versions_and_extensions(void** state) {
    (void)state;
    static const struct {
        const char* asset;
        dm_result result;
        const char* says;
    } assets[] = {{"{\"version\":\"2.0\"}", DM_OK, NULL},
                  {"{\"version\":\"2.1\"}", DM_OK, NULL},
                  {"{\"version\":\"2.1\",\"minVersion\":\"2.0\"}", DM_OK, NULL},
                  {"{\"version\":\"2.1\",\"minVersion\":\"2.1\"}", DM_ERROR_VERSION, "version 2.1, only 2.0"},
                  {"{\"version\":\"1.0\"}", DM_ERROR_UNSUPPORTED, "version 1.0"},
                  {"{\"version\":\"3.0\"}", DM_ERROR_VERSION, "version 3.0"},
                  {"{\"version\":\"\"}", DM_ERROR_BAD_DATA, "asset.version is missing"},
                  {"{\"version\":2}", DM_ERROR_BAD_DATA, "asset.version is missing"},
                  {"7", DM_ERROR_BAD_DATA, "asset.version is missing"}};
    static const struct {
        const char* name;
        bool known;
    } extensions[] = {{"KHR_mesh_quantization", true},
                      {"KHR_mesh_quantization2", false},
                      {"KHR_materials_unlit", true},
                      {"KHR_material", false},
                      {"KHR_texture_basisu", true},
                      {"EXT_texture_webp", true},
                      {"MSFT_texture_dds", true},
                      {"KHR_lights_punctual", true},
                      {"KHR_animation_pointer", true},
                      {"KHR_node_visibility", true},
                      {"KHR_xmp", true},
                      {"KHR_xmp_json", false},
                      {"EXT_mesh_gpu_instancing", true},
                      {"MSFT_lod", true},
                      {"KHR_physics_rigid_bodies", true},
                      {"KHR_collision_shapes", true},
                      {"KHR_implicit_shapes", true},
                      {"EXT_mesh_features", false},
                      {"", false},
                      {"KHR_", false}};
    char json[TEXT];
    for (size_t i = 0; i < sizeof assets / sizeof *assets; i++) {
        snprintf(json, sizeof json, "{\"asset\":%s," REST "}", assets[i].asset);
        expect_json(json, assets[i].result, assets[i].says);
    }
    for (size_t i = 0; i < sizeof extensions / sizeof *extensions; i++) {
        char says[128];
        snprintf(json, sizeof json,
                 "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"KHR_xmp\",\"%s\"]," REST "}",
                 extensions[i].name);
        snprintf(says, sizeof says, "needs the extension %s", extensions[i].name);
        expect_json(json, extensions[i].known ? DM_OK : DM_ERROR_UNSUPPORTED, extensions[i].known ? NULL : says);
    }
}

/* ---- compressed views ---- */

static void compressed_views_are_checked(void** state) {
    (void)state;
    static const struct {
        const char *mode, *filter;
        int stride, count, length;
        dm_result result;
        const char* says;
    } views[] = {{"ATTRIBUTES", "NONE", 12, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "NONE", 0, 3, 36, DM_ERROR_BAD_DATA, "compression of 0 bytes"},
                 {"ATTRIBUTES", "NONE", 10, 3, 36, DM_ERROR_BAD_DATA, "compression of 10 bytes"},
                 {"ATTRIBUTES", "NONE", 256, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "NONE", 260, 3, 36, DM_ERROR_BAD_DATA, "compression of 260 bytes"},
                 {"ATTRIBUTES", "OCTAHEDRAL", 4, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "OCTAHEDRAL", 8, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "OCTAHEDRAL", 12, 3, 36, DM_ERROR_UNSUPPORTED, "filter 'OCTAHEDRAL' of 12 bytes"},
                 {"ATTRIBUTES", "QUATERNION", 8, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "QUATERNION", 4, 3, 36, DM_ERROR_UNSUPPORTED, "filter 'QUATERNION' of 4 bytes"},
                 {"ATTRIBUTES", "EXPONENTIAL", 12, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "MAGIC", 12, 3, 36, DM_ERROR_UNSUPPORTED, "filter 'MAGIC'"},
                 {"TRIANGLES", "MAGIC", 4, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"TRIANGLES", "NONE", 4, 4, 36, DM_ERROR_BAD_DATA, "can't hold 4 elements"},
                 {"TRIANGLES", "NONE", 2, 3, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"TRIANGLES", "NONE", 1, 3, 36, DM_ERROR_BAD_DATA, "compression of 1 bytes"},
                 {"INDICES", "NONE", 4, 4, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"INDICES", "NONE", 12, 4, 36, DM_ERROR_BAD_DATA, "compression of 12 bytes"},
                 {"NOTHING", "NONE", 12, 3, 36, DM_ERROR_UNSUPPORTED, "mode 'NOTHING'"},
                 {"ATTRIBUTES", "NONE", 12, 319, 36, DM_ERROR_BAD_DATA, "can't be decoded"},
                 {"ATTRIBUTES", "NONE", 12, 320, 36, DM_ERROR_BAD_DATA, "can't hold 320 elements of 12"},
                 {"ATTRIBUTES", "NONE", 12, 3, 37, DM_ERROR_BAD_DATA, "leaves its buffer of 36"}};
    for (int name = 0; name < 2; name++)
        for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
            char json[TEXT];
            snprintf(
                json, sizeof json,
                "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36},{\"byteLength\":36}],"
                "\"bufferViews\":[{\"buffer\":1,\"byteLength\":36,\"extensions\":{\"%s_meshopt_compression\":{"
                "\"buffer\":0,\"byteLength\":%d,\"byteStride\":%d,\"count\":%d,\"mode\":\"%s\",\"filter\":\"%s\"}}}],"
                "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
                "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}]}",
                name ? "KHR" : "EXT", views[i].length, views[i].stride, views[i].count, views[i].mode, views[i].filter);
            expect_json(json, views[i].result, views[i].says);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chunks_of_other_kinds),    cmocka_unit_test(heads_of_containers),
        cmocka_unit_test(text_begins_as_an_object), cmocka_unit_test(nesting_has_an_end),
        cmocka_unit_test(versions_and_extensions),  cmocka_unit_test(compressed_views_are_checked),
    };
    return cmocka_run_group_tests_name("gltf_documents", tests, NULL, NULL);
}
