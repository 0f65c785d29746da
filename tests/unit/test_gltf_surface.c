/* Materials of glTF files: which faces have which base colour texture, and where their corners lie in it. */
#include <math.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

/* A square of two triangles, its corners in two textures, and an image. */
typedef struct bin {
    float positions[4][3];
    float uv[4][2], other[4][2];
    uint16_t indices[6], pad[2];
    char image[8];
} bin;

static const bin square = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                           .uv = {{0, 1}, {1, 1}, {0, 0}, {1, 0}},
                           .other = {{0.5f, 0.25f}, {1, 2}, {(float)NAN, 3}, {4, 5}},
                           .indices = {0, 1, 2, 2, 1, 3},
                           .image = "\x89PNG..."};

/* Three primitives of one mesh, in a node that mirrors. */
#define DOCUMENT                                                                                                       \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":136}],\"bufferViews\":["                            \
    "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":32},"                             \
    "{\"buffer\":0,\"byteOffset\":80,\"byteLength\":32},{\"buffer\":0,\"byteOffset\":112,\"byteLength\":12},"          \
    "{\"buffer\":0,\"byteOffset\":128,\"byteLength\":8}],\"accessors\":["                                              \
    "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"                                         \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"                                         \
    "{\"bufferView\":2,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"                                         \
    "{\"bufferView\":3,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"},"                                       \
    "{\"bufferView\":3,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],"                                      \
    "\"images\":[{\"bufferView\":4,\"mimeType\":\"image/png\"},{\"uri\":\"data:image/png;base64,AQID\"},"              \
    "{\"uri\":\"missing.png\"}],\"samplers\":[{\"wrapS\":33071,\"wrapT\":33648}],"                                     \
    "\"textures\":[{\"source\":0,\"sampler\":0},{\"extensions\":{\"EXT_texture_webp\":{\"source\":1}}},"               \
    "{\"source\":2}],\"materials\":["                                                                                  \
    "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,1,1,1],\"baseColorTexture\":{\"index\":0}}},"                 \
    "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":1,\"texCoord\":7,\"extensions\":{"                     \
    "\"KHR_texture_transform\":{\"texCoord\":1,\"offset\":[10,20],\"rotation\":1.5707963267948966,"                    \
    "\"scale\":[2,3]}}}}},{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":2}}},{}],"                        \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":3,\"material\":0},"    \
    "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":2},\"indices\":4,\"material\":1},"                \
    "{\"attributes\":{\"POSITION\":0},\"indices\":4,\"material\":2},"                                                  \
    "{\"attributes\":{\"POSITION\":0},\"indices\":4,\"material\":3}]}],\"nodes\":[{\"mesh\":0,\"scale\":[-1,1,1]}]}"

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
} opened;

static void open_document(opened* o, const char* document) {
    test_env_open(&o->t, TEST_NEVER);
    const test_glb glb = test_glb_pack(document, &square, sizeof square);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&o->t.memory),
                               .log = test_log(&o->t.messages)};
    if (dm_gltf_open(&desc, &o->gltf) != DM_OK) fail_msg("%s", o->t.messages.text);
    free(glb.data);
}

static void open_square(opened* o) {
    open_document(o, DOCUMENT);
}

static void close_square(opened* o) {
    dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

static void surfaces_have_their_images(void** state) {
    (void)state;
    opened o;
    dm_gltf_surface s, again;
    open_square(&o);
    assert_int_equal(dm_gltf_surface_count(o.gltf), 4);
    assert_int_equal(dm_gltf_get_surface(o.gltf, 0, &s), DM_OK);
    assert_true(s.first_face == 0 && s.face_count == 2 && s.colour[0] == 0.5f && s.colour[3] == 1);
    assert_int_equal(s.image_size, 8);
    assert_memory_equal(s.image, square.image, 8);
    assert_true(s.wrap_u == DM_GLTF_WRAP_CLAMP && s.wrap_v == DM_GLTF_WRAP_MIRROR);
    assert_int_equal(dm_gltf_get_surface(o.gltf, 0, &again), DM_OK);
    assert_ptr_equal(s.image, again.image);

    assert_int_equal(dm_gltf_get_surface(o.gltf, 1, &s), DM_OK);
    assert_true(s.first_face == 2 && s.face_count == 1 && s.colour[0] == 1);
    assert_int_equal(s.image_size, 3);
    assert_memory_equal(s.image, "\1\2\3", 3);
    assert_true(s.wrap_u == DM_GLTF_WRAP_REPEAT && s.wrap_v == DM_GLTF_WRAP_REPEAT);

    assert_int_equal(dm_gltf_get_surface(o.gltf, 2, &s), DM_OK);
    assert_null(s.image);
    assert_non_null(strstr(o.t.messages.text, "'missing.png'"));
    const int warnings = o.t.messages.count;
    assert_int_equal(dm_gltf_get_surface(o.gltf, 2, &s), DM_OK);
    assert_true(s.image == NULL && o.t.messages.count == warnings); /* once an image */
    assert_int_equal(dm_gltf_get_surface(o.gltf, 3, &s), DM_OK);
    assert_null(s.image);
    assert_int_equal(dm_gltf_get_surface(o.gltf, 4, &s), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_get_surface(NULL, 0, &s), DM_ERROR_INVALID_ARGUMENT);
    close_square(&o);
}

static void assert_uv(const float got[2], float u, float v) {
    if (!(fabsf(got[0] - u) < 1e-5f && fabsf(got[1] - v) < 1e-5f))
        fail_msg("(%g, %g), not (%g, %g)", (double)got[0], (double)got[1], (double)u, (double)v);
}

static void corners_lie_where_the_file_says(void** state) {
    (void)state;
    opened o;
    float uv[6][2];
    open_square(&o);
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 0, uv[0], 6), DM_OK);
    assert_uv(uv[0], 0, 0); /* the node mirrors: corners 2, 1, 0 */
    assert_uv(uv[1], 1, 1);
    assert_uv(uv[2], 0, 1);
    assert_uv(uv[3], 1, 0);
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 0, uv[0], 5), DM_ERROR_BUFFER_TOO_SMALL);
    /* Scaled by (2, 3), turned by a quarter, shifted by (10, 20). */
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 1, uv[0], 3), DM_OK);
    assert_uv(uv[0], 0, 0); /* of u that is no number */
    assert_uv(uv[1], 10 - 3 * 2, 20 + 2 * 1);
    assert_uv(uv[2], 10 - 3 * 0.25f, 20 + 2 * 0.5f);
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 2, uv[0], 3), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 3, uv[0], 3), DM_ERROR_NOT_FOUND);
    close_square(&o);
}

/* The file has coordinates for three of the four vertices. */
static void corners_without_coordinates_are_0(void** state) {
    (void)state;
    static const char four[] = "{\"bufferView\":1,\"componentType\":5126,\"count\":4";
    char document[sizeof DOCUMENT] = DOCUMENT;
    char* at = strstr(document, four);
    assert_non_null(at);
    at[strlen(four) - 1] = '3';
    opened o;
    float uv[6][2];
    open_document(&o, document);
    assert_int_equal(dm_gltf_get_texture_coordinates(o.gltf, 0, uv[0], 6), DM_OK);
    assert_uv(uv[2], 0, 1);
    assert_uv(uv[3], 0, 0); /* vertex 3 */
    close_square(&o);
}

static void failing_memory_is_named(void** state) {
    (void)state;
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    for (int64_t n = 0; result != DM_OK; n++) {
        opened o;
        dm_gltf_surface s;
        open_square(&o);
        o.t.memory.fail_at = o.t.memory.calls + n;
        result = dm_gltf_get_surface(o.gltf, 1, &s);
        if (result != DM_OK) assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        close_square(&o);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surfaces_have_their_images), cmocka_unit_test(corners_lie_where_the_file_says),
        cmocka_unit_test(corners_without_coordinates_are_0), cmocka_unit_test(failing_memory_is_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
