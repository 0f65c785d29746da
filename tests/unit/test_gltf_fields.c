/* Fields of glTF files that hold what they can't mean: each is refused, and the message names it. */
#include <stdbool.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { TEXT = 8192 };

/* A triangle with coordinates, a bone, and an image. */
typedef struct bin {
    float positions[3][3], coordinates[3][2];
    uint8_t joints[3][4], weights[3][4];
    uint16_t indices[4];
    float inverse_bind[16];
    uint8_t image[4], changed[4];
} bin;

static const bin bytes = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                          .weights = {{255}, {255}, {255}},
                          .indices = {0, 1, 2},
                          .inverse_bind = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};

/* Every field of glTF 2.0 that is an index, a number, a list or a truth, and that is read. */
static const char sound[] =
    "{\"asset\":{\"version\":\"2.0\",\"minVersion\":\"2.0\"},\"extensionsUsed\":[\"KHR_node_visibility\"],"
    "\"extensionsRequired\":[\"KHR_node_visibility\"],\"scene\":0,\"scenes\":[{\"nodes\":[0,2]}],"
    "\"nodes\":[{\"name\":\"door\",\"mesh\":0,\"skin\":0,\"children\":[1],"
    "\"extensions\":{\"KHR_node_visibility\":{\"visible\":true}}},"
    "{\"translation\":[1,2,3],\"rotation\":[0,0,0,1],\"scale\":[1,2,4]},"
    "{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}],"
    "\"meshes\":[{\"name\":\"leaf\",\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"JOINTS_0\":2,"
    "\"WEIGHTS_0\":3},"
    "\"indices\":4,\"material\":0,\"targets\":[{\"POSITION\":5}]}]}],"
    "\"materials\":[{\"alphaMode\":\"MASK\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.5,0.25,1],"
    "\"baseColorTexture\":{\"index\":0,"
    "\"texCoord\":0,\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0],\"rotation\":0.5,\"scale\":[1,3],"
    "\"texCoord\":1}}}}}],"
    "\"textures\":[{\"source\":0,\"sampler\":0,\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}}],"
    "\"samplers\":[{\"wrapS\":33071,\"wrapT\":33648}],\"images\":[{\"bufferView\":6}],"
    "\"skins\":[{\"joints\":[1],\"inverseBindMatrices\":6}],"
    "\"buffers\":[{\"byteLength\":164}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36,\"byteStride\":12},"
    "{\"buffer\":0,\"byteOffset\":36,\"byteLength\":24},{\"buffer\":0,\"byteOffset\":60,\"byteLength\":12},"
    "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":84,\"byteLength\":8},"
    "{\"buffer\":0,\"byteOffset\":92,\"byteLength\":64},{\"buffer\":0,\"byteOffset\":156,\"extensions\":{},"
    "\"byteLength\":4},"
    "{\"buffer\":0,\"byteOffset\":160,\"byteLength\":4}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC2\"},"
    "{\"bufferView\":2,\"componentType\":5121,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":3,\"componentType\":5121,\"normalized\":true,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":4,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},"
    "{\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":{\"count\":1,"
    "\"indices\":{\"bufferView\":7,\"componentType\":5121},\"values\":{\"bufferView\":0}}},"
    "{\"bufferView\":5,\"componentType\":5126,\"count\":1,\"type\":\"MAT4\"}]}";

#define NO_INDEX "-1", "0.5", "1e300", "1e999", "\"0\"", "null", "true", "[0]", "{}"
#define NO_NUMBER "1e999", "\"1\"", "null", "false", "[1]", "{}"
#define NO_LIST "0", "\"\"", "null", "true", "{}", "{\"a\":{}}"
#define NO_OBJECT "0", "\"\"", "null", "true", "[]", "[{}]"
#define NO_TEXT "0", "null", "true", "[]", "[\"a\"]", "{}"
#define NO_WRAP "0", "-1", "10496.5", "33069", "1e999", "\"10497\"", "null", "true", "[10497]", "{}"
#define NO_TRUTH "0", "1", "\"true\"", "null", "[]", "{}"

/* A field with its value in the sound file, values that it can't have, and its name in the message. */
static const struct row {
    const char *field, *value;
    const char* bad[12];
    const char* says;
} rows[] = {
    /* the document */
    {"\"minVersion\":", "\"2.0\"", {NO_TEXT}, "asset.minVersion"},
    {"\"extensionsUsed\":", "[\"KHR_node_visibility\"]", {NO_LIST}, "extensionsUsed"},
    {"\"extensionsRequired\":", "[\"KHR_node_visibility\"]", {NO_LIST}, "extensionsRequired"},
    {"\"extensionsRequired\":[", "\"KHR_node_visibility\"", {"0", "null", "{}"}, "extensionsRequired[0]"},
    {"\"scene\":", "0", {NO_INDEX, "1"}, "scene must"},
    {"\"scenes\":", "[{\"nodes\":[0,2]}]", {NO_LIST, "[]"}, "scene"},
    {"\"scenes\":[", "{\"nodes\":[0,2]}", {NO_OBJECT}, "scenes[0]"},
    {"\"scenes\":[{\"nodes\":", "[0,2]", {NO_LIST}, "scenes[0].nodes"},
    {"\"scenes\":[{\"nodes\":[", "0", {NO_INDEX}, "scenes[0].nodes[0]"},
    {"\"scenes\":[{\"nodes\":[0,", "2", {NO_INDEX}, "scenes[0].nodes[1]"},
    {"\"scenes\":[{\"nodes\":[0,", "2", {"3"}, "the scene lists node 3"},
    {"\"samplers\":", "[{\"wrapS\":33071,\"wrapT\":33648}]", {NO_LIST}, "samplers"},
    {"\"samplers\":[", "{\"wrapS\":33071,\"wrapT\":33648}", {NO_OBJECT}, "samplers[0]"},
    {"\"buffers\":", "[{\"byteLength\":164}]", {NO_LIST}, "buffers"},
    {"\"buffers\":[", "{\"byteLength\":164}", {NO_OBJECT}, "buffers[0]"},
    {"\"images\":", "[{\"bufferView\":6}]", {NO_LIST}, "images"},
    {"\"images\":[", "{\"bufferView\":6}", {NO_OBJECT}, "images[0]"},
    /* nodes */
    {"\"nodes\":[{\"name\":", "\"door\"", {NO_TEXT}, "nodes[0].name"},
    {"\"mesh\":", "0", {NO_INDEX}, "nodes[0].mesh"},
    {"\"skin\":", "0", {NO_INDEX}, "nodes[0].skin"},
    {"\"children\":", "[1]", {NO_LIST}, "nodes[0].children"},
    {"\"children\":[", "1", {NO_INDEX}, "nodes[0].children[0]"},
    {"\"children\":[", "1", {"3"}, "node 0 has child 3"},
    {"\"extensions\":", "{\"KHR_node_visibility\":{\"visible\":true}}", {NO_OBJECT}, "nodes[0].extensions"},
    {"\"KHR_node_visibility\":", "{\"visible\":true}", {NO_OBJECT}, "nodes[0].extensions.KHR_node_visibility"},
    {"\"visible\":", "true", {NO_TRUTH}, "nodes[0].extensions.KHR_node_visibility.visible"},
    {"\"translation\":", "[1,2,3]", {NO_LIST, "[]", "[1,2]", "[1,2,3,4]", "[1,2,\"3\"]"}, "nodes[1].translation"},
    {"\"translation\":[1,", "2", {NO_NUMBER}, "nodes[1].translation"},
    {"\"rotation\":", "[0,0,0,1]", {NO_LIST, "[]", "[0,0,1]", "[0,0,0,1,0]", "[0,0,0,null]"}, "nodes[1].rotation"},
    {"\"scale\":", "[1,2,4]", {NO_LIST, "[]", "[1,2]", "[1,2,4,1]", "[1,[2],4]"}, "nodes[1].scale"},
    {"\"matrix\":", "[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]", {NO_LIST, "[]"}, "nodes[2].matrix"},
    {"\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7", ",1", {"", ",1,1", ",\"1\"", ",0", ",-1"}, "nodes[2].matrix"},
    {"\"matrix\":[1,0,0,", "0,0,1,0,0,0,0,1,0,5,6,7,1", {"5,0,1,0,6,0,0,1,7,0,0,0,1"}, "nodes[2].matrix"}, /* rows */
    {"\"matrix\":", "[1", {"[1e999"}, "nodes[2].matrix"},
    {"7,1]", "", {",\"translation\":[0,0,0]"}, "nodes[2].translation must not stand beside matrix"},
    {"7,1]", "", {",\"rotation\":[0,0,0,1]"}, "nodes[2].rotation must not stand beside matrix"},
    {"7,1]", "", {",\"scale\":[1,1,1]"}, "nodes[2].scale must not stand beside matrix"},
    /* meshes */
    {"\"meshes\":[{\"name\":", "\"leaf\"", {NO_TEXT}, "meshes[0].name"},
    {"\"primitives\":[", "", {"0,", "\"\",", "null,", "[],"}, "meshes[0].primitives[0]"},
    {"\"attributes\":",
     "{\"POSITION\":0,\"TEXCOORD_0\":1,\"JOINTS_0\":2,\"WEIGHTS_0\":3}",
     {NO_OBJECT},
     "meshes[0].primitives[0].attributes"},
    {"\"POSITION\":", "0", {NO_INDEX}, "meshes[0].primitives[0].attributes.POSITION"},
    {"\"TEXCOORD_0\":", "1", {NO_INDEX}, "meshes[0].primitives[0].attributes.TEXCOORD_0"},
    {"\"JOINTS_0\":", "2", {NO_INDEX}, "meshes[0].primitives[0].attributes.JOINTS_0"},
    {"\"WEIGHTS_0\":", "3", {NO_INDEX}, "meshes[0].primitives[0].attributes.WEIGHTS_0"},
    {"\"indices\":", "4", {NO_INDEX}, "meshes[0].primitives[0].indices"},
    {"\"material\":", "0", {NO_INDEX, "1"}, "meshes[0].primitives[0].material"},
    {"\"targets\":", "[{\"POSITION\":5}]", {NO_LIST}, "meshes[0].primitives[0].targets"},
    {"\"targets\":[", "{\"POSITION\":5}", {NO_OBJECT}, "meshes[0].primitives[0].targets[0]"},
    {"\"targets\":[{\"POSITION\":", "5", {NO_INDEX}, "meshes[0].primitives[0].targets[0].POSITION"},
    /* looks */
    {"\"alphaMode\":", "\"MASK\"", {NO_TEXT}, "materials[0].alphaMode"},
    {"\"baseColorFactor\":",
     "[1,0.5,0.25,1]",
     {NO_LIST, "[]", "[1,1,1]", "[1,1,1,1,1]", "[1,1,1,1e39]", "[1,1,1,null]"},
     "materials[0].pbrMetallicRoughness.baseColorFactor"},
    {"\"index\":", "0", {NO_INDEX, "1"}, "materials[0].pbrMetallicRoughness.baseColorTexture.index"},
    {"\"texCoord\":", "0", {NO_INDEX}, "materials[0].pbrMetallicRoughness.baseColorTexture.texCoord"},
    {"\"offset\":", "[0.5,0]", {NO_LIST, "[]", "[0.5]", "[0.5,0,0]", "[0.5,null]"}, "KHR_texture_transform.offset"},
    {"\"rotation\":", "0.5", {NO_NUMBER}, "KHR_texture_transform.rotation"},
    {"\"scale\":", "[1,3]", {NO_LIST, "[]", "[1]", "[1,3,1]", "[1,null]"}, "KHR_texture_transform.scale"},
    {"\"texCoord\":", "1", {NO_INDEX}, "KHR_texture_transform.texCoord"},
    {"\"textures\":[{\"source\":", "0", {NO_INDEX, "1"}, "textures[0].source"},
    {"\"sampler\":", "0", {NO_INDEX, "1"}, "textures[0].sampler"},
    {"\"EXT_texture_webp\":{\"source\":", "0", {NO_INDEX, "1"}, "textures[0].extensions.EXT_texture_webp.source"},
    {"\"wrapS\":", "33071", {NO_WRAP}, "samplers[0].wrapS must be 10497, 33071 or 33648"},
    {"\"wrapT\":", "33648", {NO_WRAP}, "samplers[0].wrapT"},
    {"\"images\":[{", "", {"\"uri\":0,", "\"uri\":null,", "\"uri\":{},"}, "images[0].uri"},
    {"\"images\":[{\"bufferView\":", "6", {NO_INDEX}, "images[0].bufferView"},
    /* skins */
    {"\"joints\":", "[1]", {NO_LIST}, "skins[0].joints"},
    {"\"joints\":[", "1", {NO_INDEX}, "skins[0].joints[0]"},
    {"\"inverseBindMatrices\":", "6", {NO_INDEX}, "skins[0].inverseBindMatrices"},
    /* bytes */
    {"\"buffers\":[{", "", {"\"uri\":0,", "\"uri\":null,", "\"uri\":[],"}, "buffers[0].uri"},
    {"\"byteOffset\":156,\"extensions\":", "{}", {NO_OBJECT}, "bufferViews[6].extensions"},
    {"\"byteOffset\":156,\"extensions\":{",
     "",
     {"\"EXT_meshopt_compression\":0", "\"KHR_meshopt_compression\":[]", "\"EXT_meshopt_compression\":{\"mode\":1}",
      "\"KHR_meshopt_compression\":{\"filter\":1}", "\"EXT_meshopt_compression\":{\"buffer\":0.5}"},
     "bufferViews[6].extensions"},
    {"\"bufferViews\":[{\"buffer\":", "0", {NO_INDEX}, "bufferViews[0].buffer"},
    {"\"byteStride\":", "12", {"1", "4", "11"}, "byteStride"},
    {"\"accessors\":[{\"bufferView\":", "0", {NO_INDEX}, "accessors[0].bufferView"},
    {"\"normalized\":", "true", {NO_TRUTH}, "accessors[3].normalized"},
    {"\"sparse\":",
     "{\"count\":1,\"indices\":{\"bufferView\":7,\"componentType\":5121},\"values\":{\"bufferView\":0}}",
     {NO_OBJECT},
     "accessors[5].sparse"},
    {"\"indices\":", "{\"bufferView\":7,\"componentType\":5121}", {NO_OBJECT}, "accessors[5].sparse.indices"},
    {"\"indices\":{\"bufferView\":", "7", {NO_INDEX}, "accessors[5].sparse.indices.bufferView"},
    {"\"values\":", "{\"bufferView\":0}", {NO_OBJECT}, "accessors[5].sparse.values"},
    {"\"values\":{\"bufferView\":", "0", {NO_INDEX}, "accessors[5].sparse.values.bufferView"},
};

static dm_result open_json(test_env* t, const char* json, dm_gltf** out) {
    const test_glb glb = test_glb_pack(json, &bytes, sizeof bytes);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&t->memory),
                               .log = test_log(&t->messages)};
    *out = NULL;
    test_env_open(t, TEST_NEVER);
    const dm_result result = dm_gltf_open(&desc, out);
    free(glb.data);
    return result;
}

/* Writes the sound file with another value in a field. */
static void change(const struct row* row, const char* value, char json[TEXT]) {
    char text[TEXT];
    snprintf(text, sizeof text, "%s%s", row->field, row->value);
    const char* at = strstr(sound, text);
    if (!at) fail_msg("the sound file lacks %s", text);
    snprintf(json, TEXT, "%.*s%s%s%s", (int)(at - sound), sound, row->field, value, at + strlen(text));
}

static void the_file_is_sound(void** state) {
    (void)state;
    test_env t;
    dm_gltf* gltf;
    assert_int_equal(open_json(&t, sound, &gltf), DM_OK);
    assert_int_equal(dm_gltf_node_count(gltf), 2);
    assert_null(strstr(t.messages.text, "skin"));
    dm_gltf_close(gltf);
    test_env_close(&t);
}

static void what_a_field_can_not_mean_is_refused_by_name(void** state) {
    (void)state;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        for (size_t b = 0; b < sizeof rows->bad / sizeof *rows->bad && rows[r].bad[b]; b++) {
            char json[TEXT];
            test_env t;
            dm_gltf* gltf;
            change(&rows[r], rows[r].bad[b], json);
            const dm_result result = open_json(&t, json, &gltf);
            if (result != DM_ERROR_BAD_DATA || !strstr(t.messages.text, rows[r].says))
                fail_msg("%s%s: %d '%s', not '%s'", rows[r].field, rows[r].bad[b], result, t.messages.text,
                         rows[r].says);
            assert_null(gltf);
            test_env_close(&t);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_file_is_sound),
        cmocka_unit_test(what_a_field_can_not_mean_is_refused_by_name),
    };
    return cmocka_run_group_tests_name("gltf_fields", tests, NULL, NULL);
}
