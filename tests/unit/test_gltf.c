/* glTF in: what is read, in which order and frame, and what hostile bytes get. Out is tested in test_gltf_export.c. */
#include <math.h>
#include <stdio.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

/* Six vertices: a unit square at z = 0 and two more; then indices of two triangles as uint16, and a strip as uint8. */
typedef struct bin {
    float positions[6][3];
    uint16_t indices[6];
    uint8_t strip[4];
} bin;

static const bin square = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                           .indices = {0, 1, 2, 2, 1, 3},
                           .strip = {0, 1, 2, 3}};

#define VIEWS                                                                                                          \
    "\"buffers\":[{\"byteLength\":88}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":72},"                             \
    "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":84,\"byteLength\":4}],"
#define ACCESSORS                                                                                                      \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"},"                          \
    "{\"bufferView\":1,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"},"                                       \
    "{\"bufferView\":2,\"componentType\":5121,\"count\":4,\"type\":\"SCALAR\"}],"
#define MESHES                                                                                                         \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]},"                                  \
    "{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":2,\"mode\":5},"                                     \
    "{\"attributes\":{\"POSITION\":0},\"mode\":1},{\"attributes\":{\"POSITION\":0},\"mode\":6}]}],"
#define ASSET "{\"asset\":{\"version\":\"2.0\"},"
#define NODES(list) "\"nodes\":[" list "]}"

typedef struct opened {
    test_env t;
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    dm_result result;
} opened;

static dm_gltf_desc describe(test_env* t, const void* data, size_t size) {
    return (dm_gltf_desc){.struct_size = sizeof(dm_gltf_desc),
                          .data = data,
                          .size = size,
                          .allocator = test_allocator(&t->memory),
                          .log = test_log(&t->messages)};
}

static void open_bytes(opened* o, const void* data, size_t size, int64_t fail_at) {
    memset(o, 0, sizeof *o);
    test_env_open(&o->t, fail_at);
    const dm_gltf_desc desc = describe(&o->t, data, size);
    o->result = dm_gltf_open(&desc, &o->gltf);
    if (o->result == DM_OK) assert_int_equal(dm_gltf_get_mesh(o->gltf, &o->mesh), DM_OK);
}

static void open_json(opened* o, const char* json, const void* binary, size_t size) {
    const test_glb glb = test_glb_pack(json, binary, size);
    open_bytes(o, glb.data, glb.size, TEST_NEVER);
    free(glb.data);
}

static void close_it(opened* o) {
    dm_gltf_close(o->gltf);
    test_env_close(&o->t);
}

static const float* position(const opened* o, size_t vertex) {
    return (const float*)o->mesh.positions + 3 * vertex;
}

static void assert_near(const float* got, float x, float y, float z) {
    const float want[3] = {x, y, z};
    for (int i = 0; i < 3; i++) {
        if (!(fabsf(got[i] - want[i]) < 1e-6f)) fail_msg("(%g %g %g), not (%g %g %g)", got[0], got[1], got[2], x, y, z);
    }
}

static void assert_triangle(const opened* o, size_t face, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t* indices = (const uint32_t*)o->mesh.indices + 3 * face;
    assert_int_equal(indices[0], a);
    assert_int_equal(indices[1], b);
    assert_int_equal(indices[2], c);
}

/* ---- what is read ---- */

static void test_written_file_reads_back(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const uint32_t indices[6] = {0, 1, 2, 2, 1, 3};
    const dm_gltf_part parts[2] = {{"body", square.positions[0], indices, 4, 6, {1, 0.5f, 0.25f, 1}},
                                   {"door", square.positions[2], indices, 4, 3, {-3, 7, 0, 1}}}; /* clamped */
    const dm_allocator allocator = test_allocator(&t.memory);
    const dm_log log = test_log(&t.messages);
    void* data;
    size_t size;
    assert_int_equal(dm_gltf_write(parts, 2, &allocator, &log, &data, &size), DM_OK);
    opened o;
    open_bytes(&o, data, size, TEST_NEVER);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.vertex_count, 8);
    assert_int_equal(o.mesh.index_count, 9);
    assert_memory_equal(position(&o, 0), square.positions[0], 4 * 12);
    assert_memory_equal(position(&o, 4), square.positions[2], 4 * 12);
    assert_triangle(&o, 1, 2, 1, 3);
    assert_triangle(&o, 2, 4, 5, 6);
    dm_gltf_node node;
    assert_int_equal(dm_gltf_node_count(o.gltf), 2);
    assert_int_equal(dm_gltf_get_node(o.gltf, 0, &node), DM_OK);
    assert_string_equal(node.name, "body");
    assert_true(fabsf(node.colour[1] - 0.5f) < 1e-6f && fabsf(node.colour[2] - 0.25f) < 1e-6f);
    assert_int_equal(dm_gltf_get_node(o.gltf, 1, &node), DM_OK);
    assert_int_equal(node.first_face, 2);
    assert_int_equal(node.first_vertex, 4);
    assert_true(node.colour[0] == 0 && node.colour[1] == 1);
    assert_int_equal(dm_gltf_get_node(o.gltf, 2, &node), DM_ERROR_NOT_FOUND);
    close_it(&o);
    allocator.release(allocator.user, data, size);
    test_env_close(&t);
}

static void test_a_colour_is_finite(void** state) {
    (void)state;
    const uint32_t indices[3] = {0, 1, 2};
    for (int i = 0; i < 4; i++) {
        test_env t;
        void* data = NULL;
        size_t size = 0;
        char says[32];
        test_env_open(&t, TEST_NEVER);
        const dm_log log = test_log(&t.messages);
        dm_gltf_part part = {"door", square.positions[0], indices, 4, 3, {0, 1, 0, 1}};
        part.colour[i] = i % 2 ? NAN : INFINITY;
        snprintf(says, sizeof says, "part 0: colour[%d]", i);
        assert_int_equal(dm_gltf_write(&part, 1, NULL, &log, &data, &size), DM_ERROR_NOT_FINITE);
        assert_non_null(strstr(t.messages.text, says));
        assert_null(data);
        test_env_close(&t);
    }
}

static void test_nodes_are_placed_in_the_scene(void** state) {
    (void)state;
    opened o;
    open_json(&o,
              ASSET VIEWS ACCESSORS MESHES "\"scene\":0,\"scenes\":[{\"nodes\":[1]}]," NODES(
                  "{\"name\":\"leaf\",\"mesh\":0,\"scale\":[1,1,-2]},"
                  "{\"name\":\"root\",\"translation\":[10,0,0],\"children\":[0,2]},"
                  "{\"mesh\":0,\"rotation\":[0,0,0.70710678118654752,0.70710678118654752]},"
                  "{\"name\":\"unseen\",\"mesh\":0}"),
              &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(dm_gltf_node_count(o.gltf), 2);
    assert_int_equal(o.mesh.vertex_count, 12);
    assert_near(position(&o, 1), 11, 0, 0);
    assert_near(position(&o, 6 + 1), 10, 1, 0); /* x turned to y */
    assert_triangle(&o, 0, 2, 1, 0);            /* a mirrored node keeps its outside outside */
    assert_triangle(&o, 2, 6, 7, 8);
    dm_gltf_node node;
    dm_gltf_get_node(o.gltf, 1, &node);
    assert_string_equal(node.name, "");
    assert_int_equal(node.node, 2);
    close_it(&o);
}

static void test_strips_fans_and_what_is_left_out(void** state) {
    (void)state;
    opened o;
    open_json(&o, ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":1}"), &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.vertex_count, 6); /* strip and fan share theirs; the lines are left out */
    assert_int_equal(o.mesh.index_count, 3 * (2 + 4));
    assert_triangle(&o, 0, 0, 1, 2);
    assert_triangle(&o, 1, 1, 3, 2);
    assert_triangle(&o, 2, 1, 2, 0);
    assert_triangle(&o, 5, 4, 5, 0);
    assert_non_null(strstr(o.t.messages.text, "lines"));
    close_it(&o);
}

static void test_sparse_quantised_and_strided(void** state) {
    (void)state;
    struct {
        int16_t positions[3][4]; /* normalised shorts, 8 bytes apart */
        uint8_t changed[4];
        int16_t changes[4];
    } data = {{{0, 0, 0, 99}, {32767, 0, 0, 99}, {0, 0, 0, 99}}, {2, 0, 0, 0}, {0, -32767, 0, 0}};
    const char* json = ASSET
        "\"buffers\":[{\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":24,\"byteStride\":8},"
        "{\"buffer\":0,\"byteOffset\":24,\"byteLength\":4},{\"buffer\":0,\"byteOffset\":28,\"byteLength\":8}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5122,\"normalized\":true,\"count\":3,\"type\":"
        "\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,\"componentType\":5121},\"values\":{"
        "\"bufferView\":2}}}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," NODES("{\"mesh\":0}");
    opened o;
    open_json(&o, json, &data, sizeof data);
    assert_int_equal(o.result, DM_OK);
    assert_near(position(&o, 1), 1, 0, 0);
    assert_near(position(&o, 2), 0, -1, 0);
    close_it(&o);
    data.changed[0] = 3;
    open_json(&o, json, &data, sizeof data);
    assert_int_equal(o.result, DM_ERROR_INDEX_OUT_OF_RANGE);
    close_it(&o);
}

static void test_gltf_text_with_embedded_buffer(void** state) {
    (void)state;
    /* Three vertices, (0 0 0) (1 0 0) (0 1 0), in base64. */
    const char* json =
        ASSET "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
              "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
              "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
              "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," NODES("{\"mesh\":0}");
    opened o;
    open_bytes(&o, json, strlen(json), TEST_NEVER);
    assert_int_equal(o.result, DM_OK);
    assert_near(position(&o, 1), 1, 0, 0);
    assert_near(position(&o, 2), 0, 1, 0);
    close_it(&o);
}

/* Buffers of 37 and 38 bytes end with one and two signs that stand for nothing. */
static void test_padded_base64(void** state) {
    (void)state;
    static const char* const ends[] = {"AA==", "AAA="};
    for (int i = 0; i < 2; i++) {
        char json[1024];
        snprintf(json, sizeof json,
                 ASSET "\"buffers\":[{\"byteLength\":%d,\"uri\":\"data:application/octet-stream;base64,"
                       "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA%s\"}],\"bufferViews\":[{\"buffer\":0,"
                       "\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
                       "\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
                       "\"nodes\":[{\"mesh\":0}]}",
                 37 + i, ends[i]);
        opened o;
        open_bytes(&o, json, strlen(json), TEST_NEVER);
        assert_int_equal(o.result, DM_OK);
        assert_near(position(&o, 2), 0, 1, 0);
        close_it(&o);
    }
}

/* ---- names and masks ---- */

static void test_faces_by_node_name(void** state) {
    (void)state;
    opened o;
    open_json(&o,
              ASSET VIEWS ACCESSORS MESHES NODES("{\"name\":\"door\",\"mesh\":0},{\"name\":\"door\",\"mesh\":0},"
                                                 "{\"name\":\"group\",\"children\":[3,4]},{\"mesh\":0},"
                                                 "{\"name\":\"knob\",\"mesh\":0},{\"name\":\"empty\"}"),
              &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    uint8_t ids[8] = {0};
    const char* both[] = {"door"};
    assert_int_equal(dm_gltf_mark_faces(o.gltf, both, 1, 1, ids, 8), DM_OK);
    assert_memory_equal(ids, ((uint8_t[]){1, 1, 1, 1, 0, 0, 0, 0}), 8);
    const char* below[] = {"group"};
    assert_int_equal(dm_gltf_mark_faces(o.gltf, below, 1, 2, ids, 8), DM_OK);
    assert_memory_equal(ids, ((uint8_t[]){1, 1, 1, 1, 2, 2, 2, 2}), 8);
    const char* number[] = {"#3"};
    assert_int_equal(dm_gltf_mark_faces(o.gltf, number, 1, 3, ids, 8), DM_OK);
    assert_memory_equal(ids, ((uint8_t[]){1, 1, 1, 1, 3, 3, 2, 2}), 8);
    assert_int_equal(dm_gltf_mark_faces(NULL, both, 1, 1, ids, 8), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_mark_faces(o.gltf, both, 1, 1, NULL, 8), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_mark_faces(o.gltf, NULL, 1, 1, ids, 8), DM_ERROR_INVALID_ARGUMENT);
    const char* missing[] = {"door", "drawer"};
    uint8_t before[sizeof ids];
    memcpy(before, ids, sizeof ids);
    assert_int_equal(dm_gltf_mark_faces(o.gltf, missing, 2, 7, ids, 8), DM_ERROR_NOT_FOUND);
    assert_memory_equal(ids, before, sizeof ids); /* also of the first name, which is there */
    assert_non_null(strstr(o.t.messages.text, "'drawer'"));
    assert_non_null(strstr(o.t.messages.text, "'knob'"));
    const char* bare[] = {"empty"};
    assert_int_equal(dm_gltf_mark_faces(o.gltf, bare, 1, 1, ids, 8), DM_ERROR_NOT_FOUND);
    assert_int_equal(dm_gltf_mark_faces(o.gltf, both, 1, 1, ids, 7), DM_ERROR_INVALID_ARGUMENT);
    close_it(&o);
}

/* A group without triangles of its own, the first node of its file, stands for what it carries. */
static void test_groups_stand_for_what_they_carry(void** state) {
    (void)state;
    opened o;
    open_json(&o,
              ASSET VIEWS ACCESSORS MESHES NODES(
                  "{\"name\":\"group\",\"children\":[1]},{\"name\":\"inner\",\"children\":[2]},"
                  "{\"mesh\":0},{\"mesh\":0}"),
              &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    const char* const groups[] = {"group", "inner"};
    for (int i = 0; i < 2; i++) {
        uint8_t ids[4] = {0};
        assert_int_equal(dm_gltf_mark_faces(o.gltf, &groups[i], 1, 1, ids, 4), DM_OK);
        assert_memory_equal(ids, ((uint8_t[]){1, 1, 0, 0}), 4);
    }
    close_it(&o);
}

static void test_masks(void** state) {
    (void)state;
    opened o;
    open_json(&o, ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0}"), &square, sizeof square);
    uint8_t ids[6] = {9, 9, 9, 9, 9, 9};
    int32_t scope = -1, ambiguous = -1;
    const char* faces = "[0, 7]";
    assert_int_equal(dm_gltf_read_mask(o.gltf, faces, strlen(faces), NULL, ids, &scope, &ambiguous), DM_OK);
    assert_int_equal(scope, DM_PER_FACE);
    assert_int_equal(ambiguous, 0);
    assert_memory_equal(ids, ((uint8_t[]){0, 1}), 2);
    const char* vertices = "[3, 3, 1, 1, 1, 1]";
    const int64_t three = 3;
    assert_int_equal(dm_gltf_read_mask(o.gltf, vertices, strlen(vertices), &three, ids, &scope, NULL), DM_OK);
    assert_int_equal(scope, DM_PER_VERTEX);
    assert_memory_equal(ids, ((uint8_t[]){1, 1, 0, 0, 0, 0}), 6);
    assert_int_equal(dm_gltf_read_mask(o.gltf, "[0, 0]", 6, NULL, ids, &scope, NULL), DM_ERROR_EMPTY_MASK);
    assert_int_equal(dm_gltf_read_mask(o.gltf, "[8, 8]", 6, NULL, ids, &scope, NULL), DM_ERROR_FULL_MASK);
    assert_int_equal(dm_gltf_read_mask(o.gltf, "[1, 0, 1]", 9, NULL, ids, &scope, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_read_mask(o.gltf, "[1, ", 4, NULL, ids, &scope, NULL), DM_ERROR_BAD_DATA);
    assert_int_equal(scope, DM_PER_VERTEX); /* errors leave the answer before */
    assert_memory_equal(ids, ((uint8_t[]){1, 1, 0, 0, 0, 0}), 6);
    close_it(&o);
}

/* ---- hostile files ---- */

typedef struct hostile {
    const char* json;
    dm_result result;
    const char* says;
} hostile;

#define ACCESSOR(fields) "\"accessors\":[{\"bufferView\":0," fields ",\"type\":\"VEC3\"}],"
#define ONE_MESH                                                                                                       \
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," NODES("{\"name\":\"n\",\"mesh\":0}")

static const hostile cases[] = {
    {ASSET VIEWS ACCESSOR("\"componentType\":5126,\"count\":9") ONE_MESH, DM_ERROR_BAD_DATA, "leave buffer view 0"},
    {ASSET VIEWS ACCESSOR("\"byteOffset\":18446744073709551608,\"componentType\":5126,\"count\":3") ONE_MESH,
     DM_ERROR_BAD_DATA, "byteOffset is 1.8"},
    {ASSET VIEWS ACCESSOR("\"componentType\":5126,\"count\":4294967295") ONE_MESH, DM_ERROR_TOO_LARGE, "accessor 0"},
    {ASSET VIEWS ACCESSOR("\"componentType\":5130,\"count\":3") ONE_MESH, DM_ERROR_BAD_DATA, "component type 5130"},
    {ASSET
     "\"buffers\":[{\"byteLength\":88}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":80,\"byteLength\":72}]," ACCESSOR(
         "\"componentType\":5126,\"count\":3") ONE_MESH,
     DM_ERROR_BAD_DATA, "leaves its buffer of 88"},
    {ASSET "\"buffers\":[{\"byteLength\":88}],\"bufferViews\":[{\"buffer\":7,\"byteLength\":72}]," ACCESSOR(
         "\"componentType\":5126,\"count\":3") ONE_MESH,
     DM_ERROR_BAD_DATA, "does not exist"},
    {ASSET "\"buffers\":[{\"byteLength\":4000}]," ACCESSOR("\"componentType\":5126,\"count\":3") ONE_MESH,
     DM_ERROR_BAD_DATA, "binary size"},
    {ASSET "\"buffers\":[{\"byteLength\":88,\"uri\":\"../../etc/passwd\"}]," ONE_MESH, DM_ERROR_BAD_DATA, "passwd"},
    {ASSET VIEWS ONE_MESH, DM_ERROR_BAD_DATA, "accessor 0 does not exist"},
    {ASSET VIEWS ACCESSORS "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1}}]}]," NODES("{\"mesh\":0}"),
     DM_ERROR_BAD_DATA, "1 components a vertex"},
    {ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0,\"children\":[1]},{\"children\":[0]}"), DM_ERROR_DEGENERATE_MESH,
     "no triangle"},
    {ASSET VIEWS ACCESSORS MESHES NODES("{\"children\":[2]},{\"children\":[2]},{\"mesh\":0}"), DM_ERROR_BAD_DATA,
     "node 2 is a child of node 1 and of node 0"},
    {ASSET VIEWS ACCESSORS MESHES NODES("{\"children\":[0]}"), DM_ERROR_BAD_DATA, "child"},
    {ASSET VIEWS ACCESSORS MESHES "\"scenes\":[{\"nodes\":[5]}]," NODES("{\"mesh\":0}"), DM_ERROR_BAD_DATA, "node 5"},
    {ASSET VIEWS ACCESSORS MESHES NODES("{\"name\":\"n\",\"mesh\":9}"), DM_ERROR_BAD_DATA, "mesh 9 does not exist"},
    {ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0,\"scale\":[1e39,1,1]}"), DM_ERROR_NOT_FINITE, "not finite"},
    {ASSET
     "\"extensionsRequired\":[\"KHR_texture_transform\",\"ACME_offset\"]," VIEWS ACCESSORS MESHES NODES("{\"mesh\":0}"),
     DM_ERROR_UNSUPPORTED, "ACME_offset"},
    {ASSET NODES("{\"name\":\"n\"}"), DM_ERROR_DEGENERATE_MESH, "no triangle"},
    {"{\"asset\":{}}", DM_ERROR_BAD_DATA, "asset"},
    {"{\"asset\":{\"version\":\"2.0\"},", DM_ERROR_BAD_DATA, "parse"},
};

static void test_hostile_files_are_named(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        opened o;
        open_json(&o, cases[i].json, &square, sizeof square);
        if (o.result != cases[i].result || !strstr(o.t.messages.text, cases[i].says))
            fail_msg("case %zu: %d '%s', not %d '%s'", i, o.result, o.t.messages.text, cases[i].result, cases[i].says);
        close_it(&o);
    }
}

/* Meshes that have few vertices of one accessor each take theirs alone, in its order, sparse changes included. */
static void test_few_vertices_of_a_shared_accessor(void** state) {
    (void)state;
    enum { VERTICES = 400, FIRST = 200 }; /* FIRST: half of them, which is in the first mesh */
    struct {
        float xyz[VERTICES][3], changed[3];
        uint16_t corners[2][3], index, pad;
    } file = {.changed = {9, 8, 7}, .corners = {{VERTICES - 1, 0, FIRST}, {5, 300, 7}}, .index = 300};
    for (int v = 0; v < VERTICES; v++) file.xyz[v][0] = (float)v, file.xyz[v][1] = (float)(v % 3), file.xyz[v][2] = 1;
    opened o;
    open_json(&o,
              ASSET
              "\"buffers\":[{\"byteLength\":4828}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":4812},"
              "{\"buffer\":0,\"byteOffset\":4812,\"byteLength\":16}],\"accessors\":[{\"bufferView\":0,"
              "\"componentType\":5126,\"count\":400,\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{"
              "\"bufferView\":1,\"byteOffset\":12,\"componentType\":5123},\"values\":{\"bufferView\":0,"
              "\"byteOffset\":4800}}},{\"bufferView\":1,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"},"
              "{\"bufferView\":1,\"byteOffset\":6,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],"
              "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]},"
              "{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":2}]}]," NODES("{\"mesh\":0},{\"mesh\":1}"),
              &file, sizeof file);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.vertex_count, 6);
    static const float x[6] = {0, FIRST, VERTICES - 1, 5, 7, 9};
    for (size_t v = 0; v < 6; v++) assert_true(position(&o, v)[0] == x[v]);
    assert_true(position(&o, 5)[1] == 8 && position(&o, 5)[2] == 7);
    static const uint32_t corners[6] = {2, 0, 1, 3, 5, 4};
    assert_memory_equal(o.mesh.indices, corners, sizeof corners);
    close_it(&o);
}

/* ---- numbers that an int or 64 bits can't hold ---- */

/* A document of one sparse accessor, with these values in the places of these. */
enum { VIEW_OFFSET, VIEW_LENGTH, VIEW_BUFFER, OFFSET, VIEW, CHANGES, INDEX_OFFSET, VALUE_OFFSET, VALUE_VIEW, FIELDS };

static void open_fields(opened* o, const char* const fields[FIELDS]) {
    char json[1024];
    snprintf(json, sizeof json,
             ASSET "\"buffers\":[{\"byteLength\":88}],\"bufferViews\":[{\"byteOffset\":%s,\"byteLength\":%s,"
                   "\"buffer\":%s},{\"buffer\":0,\"byteOffset\":84,\"byteLength\":4}],\"accessors\":[{"
                   "\"byteOffset\":%s,\"bufferView\":%s,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
                   "\"sparse\":{\"count\":%s,\"indices\":{\"bufferView\":1,\"byteOffset\":%s,"
                   "\"componentType\":5121},\"values\":{\"byteOffset\":%s,\"bufferView\":%s}}}]," ONE_MESH,
             fields[VIEW_OFFSET], fields[VIEW_LENGTH], fields[VIEW_BUFFER], fields[OFFSET], fields[VIEW],
             fields[CHANGES], fields[INDEX_OFFSET], fields[VALUE_OFFSET], fields[VALUE_VIEW]);
    open_json(o, json, &square, sizeof square);
}

static void test_large_numbers_never_wrap(void** state) {
    (void)state;
    /* The 32 low bits of some are those of a valid number. */
    const char* const numbers[] = {"2147483647",
                                   "2147483648",
                                   "4294967295",
                                   "4294967296",
                                   "4294967297",
                                   "9223372036854775807",
                                   "9223372036854775808",
                                   "18446744073709551615",
                                   "18446744073709551616",
                                   "18446744073709551617",
                                   "-1",
                                   "-4294967296",
                                   "1e3",
                                   "0.5"};
    const char* const valid[FIELDS] = {"0", "72", "0", "0", "0", "1", "0", "0", "0"};
    opened o;
    open_fields(&o, valid);
    assert_int_equal(o.result, DM_OK);
    close_it(&o);
    for (int field = 0; field < FIELDS; field++) {
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            const char* fields[FIELDS];
            memcpy(fields, valid, sizeof fields);
            fields[field] = numbers[i];
            open_fields(&o, fields);
            const char* text = o.t.messages.text;
            const int named = strstr(text, "must be") || strstr(text, "does not exist") || strstr(text, "leave");
            if (o.result != DM_ERROR_BAD_DATA || !named)
                fail_msg("field %d, %s: %d '%s'", field, numbers[i], o.result, o.t.messages.text);
            close_it(&o);
        }
    }
}

/* Numbers that must be whole and not negative, each with what it is in a good file. */
static void test_what_is_no_count_is_refused_by_name(void** state) {
    (void)state;
    static const char* const good[][2] = {{"byteLength", "88"}, {"byteOffset", "0"},  {"byteStride", "12"},
                                          {"byteOffset", "4"},  {"count", "3"},       {"count", "1"},
                                          {"byteOffset", "8"},  {"byteOffset", "16"}, {"mode", "4"}};
    enum { NUMBERS = sizeof good / sizeof *good };
    static const char* const bad[] = {"-1", "0.5", "-0.5", "1e300", "\"1\"", "null", "true", "[1]"};
    for (int which = -1; which < NUMBERS + 2; which++) {
        for (size_t b = 0; b < sizeof bad / sizeof *bad; b++) {
            const char* n[NUMBERS];
            for (int i = 0; i < NUMBERS; i++) n[i] = i == which ? bad[b] : good[i][1];
            /* Then the component types. */
            const char *type = which == NUMBERS ? bad[b] : "5126", *changed = which == NUMBERS + 1 ? bad[b] : "5121";
            char json[1024];
            snprintf(json, sizeof json,
                     ASSET "\"buffers\":[{\"byteLength\":%s}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":%s,"
                           "\"byteLength\":72,\"byteStride\":%s},{\"buffer\":0,\"byteLength\":88}],\"accessors\":[{"
                           "\"bufferView\":0,\"byteOffset\":%s,\"componentType\":%s,\"count\":%s,\"type\":\"VEC3\","
                           "\"sparse\":{\"count\":%s,\"indices\":{\"bufferView\":1,\"byteOffset\":%s,"
                           "\"componentType\":%s},\"values\":{\"byteOffset\":%s,\"bufferView\":1}}}],\"meshes\":[{"
                           "\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":%s}]}]," NODES("{\"mesh\":0}"),
                     n[0], n[1], n[2], n[3], type, n[4], n[5], n[6], changed, n[7], n[8]);
            opened o;
            open_json(&o, json, &square, sizeof square);
            const char* name = which < 0 ? "" : which < NUMBERS ? good[which][0] : "componentType";
            if (which < 0)
                assert_int_equal(o.result, DM_OK);
            else if (o.result != DM_ERROR_BAD_DATA || !strstr(o.t.messages.text, name))
                fail_msg("%s %d is %s: %d '%s'", name, which, bad[b], o.result, o.t.messages.text);
            close_it(&o);
        }
    }
}

static void test_extras_may_hold_any_number(void** state) {
    (void)state;
    opened o;
    open_json(&o,
              ASSET "\"extras\":{\"count\":-5,\"of\":[{\"byteOffset\":1e300}]}," VIEWS ACCESSORS MESHES NODES(
                  "{\"mesh\":0,\"extras\":{\"buffer\":99999999999}}"),
              &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    close_it(&o);
    open_json(&o,
              ASSET "\"extras\":{\"count\":-5}," VIEWS ACCESSOR(
                  "\"byteOffset\":4294967296,\"componentType\":5126,\"count\":3") ONE_MESH,
              &square, sizeof square);
    assert_int_equal(o.result, DM_ERROR_BAD_DATA);
    assert_non_null(strstr(o.t.messages.text, "byteOffset is 4294967296"));
    close_it(&o);
}

static void test_bad_triangles_alone_are_left_out(void** state) {
    (void)state;
    const char* json = ASSET VIEWS ACCESSORS MESHES NODES("{\"name\":\"door\",\"mesh\":0}");
    opened o;
    bin bad = square;
    bad.positions[3][1] = NAN;
    open_json(&o, json, &bad, sizeof bad);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.index_count, 3);
    assert_triangle(&o, 0, 0, 1, 2);
    assert_int_equal(dm_gltf_left_out(o.gltf), 1);
    assert_non_null(strstr(o.t.messages.text, "'door', primitive 0: vertex 3 is (1, nan, 0); bad triangles: 1 of 2"));
    for (size_t v = 0; v < 6; v++) assert_true(isfinite(position(&o, v)[1]));
    close_it(&o);
    bad = square;
    bad.positions[4][1] = NAN; /* no triangle has it */
    open_json(&o, json, &bad, sizeof bad);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(dm_gltf_left_out(o.gltf), 0);
    assert_int_equal(o.mesh.vertex_count, 6);
    for (size_t v = 0; v < 6; v++) assert_true(isfinite(position(&o, v)[1]));
    close_it(&o);
    bad = square;
    bad.indices[0] = 6;
    open_json(&o, json, &bad, sizeof bad);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.index_count, 3);
    assert_triangle(&o, 0, 2, 1, 3);
    assert_non_null(strstr(o.t.messages.text, "triangle 0 names vertex 6 of 6; bad triangles: 1 of 2"));
    close_it(&o);
    bad.positions[3][1] = NAN; /* the other one too */
    open_json(&o, json, &bad, sizeof bad);
    assert_int_equal(o.result, DM_ERROR_INDEX_OUT_OF_RANGE);
    assert_non_null(strstr(o.t.messages.text, "triangle 0 names vertex 6 of 6"));
    close_it(&o);
}

static void test_deep_nesting_is_refused(void** state) {
    (void)state;
    enum { DEPTH = 200000 };
    char* json = malloc(2 * DEPTH + 64);
    size_t at = (size_t)sprintf(json, "{\"asset\":{\"version\":\"2.0\",\"extras\":");
    memset(json + at, '[', DEPTH);
    memset(json + at + DEPTH, ']', DEPTH);
    strcpy(json + at + 2 * (size_t)DEPTH, "}}");
    opened o;
    open_json(&o, json, NULL, 0);
    assert_int_equal(o.result, DM_ERROR_BAD_DATA);
    assert_non_null(strstr(o.t.messages.text, "nests"));
    close_it(&o);
    free(json);
}

/* As in JavaScript, of a name that comes twice in an object the last counts. */
static void test_last_of_repeated_names_counts(void** state) {
    (void)state;
    opened o;
    open_json(&o, ASSET VIEWS ACCESSORS MESHES NODES("{\"name\":\"first\",\"mesh\":7,\"name\":\"last\",\"mesh\":0}"),
              &square, sizeof square);
    assert_int_equal(o.result, DM_OK);
    assert_int_equal(o.mesh.index_count, 6);
    dm_gltf_node node;
    assert_int_equal(dm_gltf_get_node(o.gltf, 0, &node), DM_OK);
    assert_string_equal(node.name, "last");
    close_it(&o);
}

static void test_other_containers(void** state) {
    (void)state;
    opened o;
    open_bytes(&o, "solid cube\n", 11, TEST_NEVER);
    assert_int_equal(o.result, DM_ERROR_BAD_DATA);
    assert_non_null(strstr(o.t.messages.text, "not a GLB"));
    close_it(&o);
    test_glb glb = test_glb_pack(ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0}"), &square, sizeof square);
    glb.data[4] = 1;
    open_bytes(&o, glb.data, glb.size, TEST_NEVER);
    assert_int_equal(o.result, DM_ERROR_UNSUPPORTED);
    close_it(&o);
    glb.data[4] = 2;
    uint8_t* binary_size = glb.data + 20 + test_glb_json_size(glb.data);
    binary_size[0] += 4; /* as many bytes behind the file */
    open_bytes(&o, glb.data, glb.size, TEST_NEVER);
    assert_int_equal(o.result, DM_ERROR_BAD_DATA);
    assert_non_null(strstr(o.t.messages.text, "second chunk"));
    close_it(&o);
    binary_size[0] -= 4;
    for (size_t size = 0; size < glb.size; size++) { /* every truncation is an error, none is more than that */
        uint8_t* cut = malloc(size + 1);
        memcpy(cut, glb.data, size);
        open_bytes(&o, cut, size, TEST_NEVER);
        assert_true(o.result == (size ? DM_ERROR_BAD_DATA : DM_ERROR_INVALID_ARGUMENT));
        close_it(&o);
        free(cut);
    }
    free(glb.data);
}

static void test_flipped_bytes_never_crash(void** state) {
    (void)state;
    const test_glb glb =
        test_glb_pack(ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0},{\"mesh\":1}"), &square, sizeof square);
    uint32_t random = 1;
    for (int round = 0; round < 4000; round++) {
        uint8_t* bytes = malloc(glb.size);
        memcpy(bytes, glb.data, glb.size);
        for (int k = 0; k < 3; k++) {
            random = random * 1664525u + 1013904223u;
            bytes[20 + (random >> 8) % (glb.size - 20)] = (uint8_t)(random >> 3);
        }
        opened o;
        open_bytes(&o, bytes, glb.size, TEST_NEVER);
        close_it(&o);
        free(bytes);
    }
    free(glb.data);
}

static void test_failing_allocator(void** state) {
    (void)state;
    const test_glb glb = test_glb_pack(ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":1}"), &square, sizeof square);
    int64_t n = 0;
    for (dm_result result = DM_ERROR_OUT_OF_MEMORY; result != DM_OK; n++) {
        opened o;
        open_bytes(&o, glb.data, glb.size, n);
        result = o.result;
        assert_true(result == DM_OK || result == DM_ERROR_OUT_OF_MEMORY);
        close_it(&o);
    }
    assert_true(n > 6);
    free(glb.data);
}

static void test_descriptors_are_checked(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const test_glb glb = test_glb_pack(ASSET VIEWS ACCESSORS MESHES NODES("{\"mesh\":0}"), &square, sizeof square);
    struct {
        dm_gltf_desc desc;
        uint8_t newer[8];
    } caller = {describe(&t, glb.data, glb.size), {0}};
    dm_gltf* gltf = NULL;
    caller.desc.struct_size = sizeof caller;
    assert_int_equal(dm_gltf_open(&caller.desc, &gltf), DM_OK); /* a newer caller that sends zeros */
    dm_gltf_close(gltf);
    caller.newer[3] = 1;
    assert_int_equal(dm_gltf_open(&caller.desc, &gltf), DM_ERROR_STRUCT_SIZE);
    caller.desc.struct_size = 8;
    assert_int_equal(dm_gltf_open(&caller.desc, &gltf), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_gltf_open(NULL, &gltf), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_gltf_node_count(NULL), 0);
    free(glb.data);
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_written_file_reads_back),
        cmocka_unit_test(test_a_colour_is_finite),
        cmocka_unit_test(test_nodes_are_placed_in_the_scene),
        cmocka_unit_test(test_strips_fans_and_what_is_left_out),
        cmocka_unit_test(test_sparse_quantised_and_strided),
        cmocka_unit_test(test_few_vertices_of_a_shared_accessor),
        cmocka_unit_test(test_gltf_text_with_embedded_buffer),
        cmocka_unit_test(test_padded_base64),
        cmocka_unit_test(test_faces_by_node_name),
        cmocka_unit_test(test_groups_stand_for_what_they_carry),
        cmocka_unit_test(test_masks),
        cmocka_unit_test(test_hostile_files_are_named),
        cmocka_unit_test(test_large_numbers_never_wrap),
        cmocka_unit_test(test_what_is_no_count_is_refused_by_name),
        cmocka_unit_test(test_extras_may_hold_any_number),
        cmocka_unit_test(test_bad_triangles_alone_are_left_out),
        cmocka_unit_test(test_deep_nesting_is_refused),
        cmocka_unit_test(test_last_of_repeated_names_counts),
        cmocka_unit_test(test_other_containers),
        cmocka_unit_test(test_flipped_bytes_never_crash),
        cmocka_unit_test(test_failing_allocator),
        cmocka_unit_test(test_descriptors_are_checked),
    };
    return cmocka_run_group_tests_name("gltf", tests, NULL, NULL);
}
