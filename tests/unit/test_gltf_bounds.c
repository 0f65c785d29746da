/* Memory that a glTF file takes, at the most, while it is read: files of a few megabytes that say little and mean much.
 */
#include <inttypes.h>
#include <stdarg.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

/* Bytes a byte, and always; docs/reliability.md promises them. */
#define A_BYTE 64
#define ALWAYS ((int64_t)64 << 20)

enum { BIN = 48, FILE_SIZE = 2 << 20 };

/* A triangle and its corners. */
static const struct {
    float positions[3][3];
    uint32_t corners[3];
} bin = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}};

static int64_t peak; /* of one file */

static void* DM_CALL allocate(void* user, size_t size, size_t alignment) {
    const test_memory* memory = user;
    void* out = test_allocate(user, size, alignment);
    if (memory->live_bytes > peak) peak = memory->live_bytes;
    return out;
}

#define HEAD                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":48}],\"bufferViews\":[{\"buffer\":0,"               \
    "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":12}],\"accessors\":["                           \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":1,\"componentType\":5125,\"count\":3,\"type\":\"SCALAR\"},"                                       \
    "{\"componentType\":5126,\"count\":12000000,\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":"                \
    "{\"bufferView\":1,\"componentType\":5125},\"values\":{\"bufferView\":0}}},"                                       \
    "{\"componentType\":5125,\"count\":24000000,\"type\":\"SCALAR\",\"sparse\":{\"count\":1,\"indices\":"              \
    "{\"bufferView\":1,\"componentType\":5125},\"values\":{\"bufferView\":1}}},"                                       \
    "{\"componentType\":5125,\"count\":30000,\"type\":\"SCALAR\",\"sparse\":{\"count\":1,\"indices\":"                 \
    "{\"bufferView\":1,\"componentType\":5125},\"values\":{\"bufferView\":1}}}"
#define TRIANGLE "{\"attributes\":{\"POSITION\":0}}"
#define MESH "],\"meshes\":[{\"primitives\":[" TRIANGLE "]}"
#define NODES "],\"nodes\":[{\"mesh\":0}"

/* What is repeated until the file is large, between what stands before and behind it. */
static const struct {
    const char *name, *before, *item, *behind;
} families[] = {
    {"empty nodes", HEAD MESH NODES, ",{}", "]}"},
    {"nodes of one mesh", HEAD MESH NODES, ",{\"mesh\":0}", "]}"},
    {"meshes", HEAD MESH, ",{}", NODES "]}"},
    {"accessors", HEAD, ",{}", MESH NODES "]}"},
    {"primitives of one accessor", HEAD "],\"meshes\":[{\"primitives\":[" TRIANGLE, "," TRIANGLE, "]}" NODES "]}"},
    {"primitives of one list of corners", HEAD "],\"meshes\":[{\"primitives\":[" TRIANGLE,
     ",{\"attributes\":{\"POSITION\":0},\"indices\":4}", "]}" NODES "]}"},
    {"vertices that are not stored",
     HEAD "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":2}}]}" NODES "],\"extras\":[0", ",0", "]}"},
    {"corners that are not stored",
     HEAD "],\"meshes\":[{\"primitives\":[{\"mode\":5,\"attributes\":{\"POSITION\":0},\"indices\":3}]}" NODES
          "],\"extras\":[0",
     ",0", "]}"},
    {"bones", HEAD MESH "],\"nodes\":[{\"mesh\":0,\"skin\":0}],\"skins\":[{\"joints\":[0", ",0", "]}]}"},
};

static test_glb make_file(size_t family) {
    const size_t item = strlen(families[family].item), count = FILE_SIZE / item;
    const size_t before = strlen(families[family].before);
    char* json = malloc(before + count * item + strlen(families[family].behind) + 1);
    memcpy(json, families[family].before, before + 1);
    for (size_t i = 0; i < count; i++) memcpy(json + before + i * item, families[family].item, item + 1);
    strcpy(json + before + count * item, families[family].behind);
    const test_glb glb = test_glb_pack(json, &bin, BIN);
    free(json);
    return glb;
}

static void what_is_said_shortly_is_bounded(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
        test_env t;
        dm_gltf* gltf = NULL;
        const test_glb glb = make_file(i);
        test_env_open(&t, TEST_NEVER);
        const dm_gltf_desc desc = {.struct_size = sizeof desc,
                                   .data = glb.data,
                                   .size = glb.size,
                                   .allocator = {&t.memory, allocate, test_release},
                                   .log = test_log(&t.messages)};
        peak = 0;
        const dm_result result = dm_gltf_open(&desc, &gltf);
        print_message("%s: %zu bytes of file, %.1f MB, %s\n", families[i].name, glb.size, (double)peak / (1 << 20),
                      dm_result_string(result));
        if (result != DM_OK && result != DM_ERROR_TOO_LARGE) fail_msg("%s: %s", families[i].name, t.messages.text);
        if (peak > ALWAYS + A_BYTE * (int64_t)glb.size) fail_msg("%s: %" PRId64 " bytes", families[i].name, peak);
        dm_gltf_close(gltf);
        free(glb.data);
        t.messages.count = 0;
        test_env_close(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_said_shortly_is_bounded)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
