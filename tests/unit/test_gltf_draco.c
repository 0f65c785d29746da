/* Draco's streams as strangers may make them: component types that Draco has and glTF has not are refused. */
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { POINTS = 3, TYPE_AT = 20 };
enum { INT8 = 1, UINT8, INT16, UINT16, INT32, UINT32, INT64, UINT64, FLOAT32, FLOAT64, BOOL, TYPES }; /* of Draco */

/* A triangle in Draco's sequential encoding 2.2: a face of three points, whose indices are 0, 1, 2; one attribute,
 * POSITION, its component type at TYPE_AT, 3 components, id 0, of values that stand as they are. */
static const uint8_t stream_start[] = {'D', 'R', 'A', 'C', 'O', 2, 2, 1,       0, 0, 0, 1, POINTS,
                                       1,   0,   1,   2,   1,   1, 0, FLOAT32, 3, 0, 0, 0};

static const char json[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"name\":\"a\"}],"
    "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"meshes\":[{\"primitives\":[{\"attributes\":{"
    "\"POSITION\":0},"
    "\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":{\"bufferView\":0,\"attributes\":{\"POSITION\":0}}}}]"
    "}],"
    "\"accessors\":[{\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},{\"componentType\":5125,\"count\":3,"
    "\"type\":"
    "\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":97}],\"buffers\":[{\"byteLength\":97}]}";

/* Values of 128 each: for a bool that is neither. */
static dm_result open_stream(test_env* t, uint8_t type, dm_gltf** out) {
    uint8_t stream[sizeof stream_start + POINTS * 3 * sizeof(double)];
    memset(stream, type == FLOAT32 || type == FLOAT64 ? 0 : 128, sizeof stream);
    memcpy(stream, stream_start, sizeof stream_start);
    stream[TYPE_AT] = type;
    const test_glb glb = test_glb_pack(json, stream, sizeof stream);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&t->memory),
                               .log = test_log(&t->messages)};
    const dm_result result = dm_gltf_open(&desc, out);
    free(glb.data);
    return result;
}

static void component_types_are_those_of_gltf(void** state) {
    (void)state;
    for (uint8_t type = INT8; type < TYPES; type++) {
        const bool is_gltf = type <= UINT32 || type == FLOAT32;
        test_env t;
        dm_gltf* gltf;
        test_env_open(&t, TEST_NEVER);
        const dm_result result = open_stream(&t, type, &gltf);
        if (result == DM_ERROR_UNSUPPORTED) skip(); /* a build without Draco */
        if (result != (is_gltf ? DM_OK : DM_ERROR_BAD_DATA))
            fail_msg("type %d: %d '%s'", type, result, t.messages.text);
        if (!is_gltf) assert_non_null(strstr(t.messages.text, "POSITION is not what accessor 0 says"));
        if (result == DM_OK) dm_gltf_close(gltf);
        test_env_close(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(component_types_are_those_of_gltf)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
