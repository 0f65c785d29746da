/* glTF out: what an export copies is what the file had: attributes of every type, the bytes of every buffer, all digits
 * of numbers, and the lists that name nodes. */
#include <math.h>
#include <stdio.h>

#include <cjson/cJSON.h>

#include "dragmesh/ext/gltf.h"
#include "test_env.h"
#include "test_glb.h"

enum { TEXT = 1 << 17, VERTICES = 6, MOST_BYTES = 1 << 16 };

static const dm_pose still = {{0, 0, 0, 1}, {0}};
static const float start = 0;

typedef struct exported {
    test_env t;
    dm_gltf* gltf;
    void* data;
    size_t size;
    cJSON* json;
    const uint8_t* bin;
    uint32_t bin_size;
} exported;

/* Opens the file and exports it with the triangles of `ids` moving. */
static void export_file(exported* e, const char* json, const void* bytes, size_t size, const uint8_t* ids) {
    const test_glb glb = test_glb_pack(json, bytes, size);
    memset(e, 0, sizeof *e);
    test_env_open(&e->t, TEST_NEVER);
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = glb.data,
                               .size = glb.size,
                               .allocator = test_allocator(&e->t.memory),
                               .log = test_log(&e->t.messages)};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = &still, .times = &start, .key_count = 1};
    if (dm_gltf_open(&desc, &e->gltf) != DM_OK) fail_msg("%s", e->t.messages.text);
    if (dm_gltf_export(e->gltf, &track, 1, &e->data, &e->size) != DM_OK) fail_msg("%s", e->t.messages.text);
    char* text = test_glb_json(e->data);
    e->json = cJSON_Parse(text);
    assert_non_null(e->json);
    free(text);
    e->bin = test_glb_bin(e->data, &e->bin_size);
    free(glb.data);
}

static void close_it(exported* e) {
    cJSON_Delete(e->json);
    dm_gltf_release_bytes(e->gltf, e->data, e->size);
    dm_gltf_close(e->gltf);
    test_env_close(&e->t);
}

static const cJSON* member(const cJSON* object, const char* name) {
    return cJSON_GetObjectItemCaseSensitive(object, name);
}

static const cJSON* item(const exported* e, const char* list, int index) {
    return cJSON_GetArrayItem(member(e->json, list), index);
}

static int number(const cJSON* object, const char* name, int otherwise) {
    const cJSON* found = member(object, name);
    return found ? found->valueint : otherwise;
}

/* The first node that has a mesh, with a skin or without. */
static const cJSON* node_with_mesh(const exported* e, bool skinned) {
    const cJSON* node;
    cJSON_ArrayForEach(node, member(e->json, "nodes")) {
        if (member(node, "mesh") && (member(node, "skin") != NULL) == skinned) return node;
    }
    fail_msg("no node has a mesh");
    return NULL;
}

/* ---- attributes ---- */

static const struct { int type, size; } types[] = {{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
static const struct {
    const char* name;
    int components;
} shapes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
enum { TYPES = 6, SHAPES = 7, WAYS = 4, ATTRIBUTES = TYPES * SHAPES * WAYS, OWN = 4 }; /* OWN: accessors before */
enum { STRIDED = 1, SPARSE = 2 };                                                      /* a way's bits */

typedef struct file {
    char* json;
    size_t length;
    uint8_t* bytes;
    size_t size;
    int views;
    char* list; /* of buffer views */
    size_t list_length;
} file;

static void say(char* text, size_t* length, const char* more) {
    const size_t size = strlen(more);
    assert_true(*length + size < TEXT);
    memcpy(text + *length, more, size + 1);
    *length += size;
}

/* Appends bytes and a view of them. Returns its index. */
static int add_view(file* f, const void* bytes, size_t size, int stride) {
    char view[128], says[32] = "";
    f->size = (f->size + 3) & ~(size_t)3;
    assert_true(f->size + size <= MOST_BYTES);
    memcpy(f->bytes + f->size, bytes, size);
    if (stride) snprintf(says, sizeof says, ",\"byteStride\":%d", stride);
    snprintf(view, sizeof view, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu%s}", f->views ? "," : "",
             f->size, size, says);
    say(f->list, &f->list_length, view);
    f->size += size;
    return f->views++;
}

static uint8_t value_of(int attribute, int vertex, int byte) {
    return (uint8_t)(1 + (attribute * 37 + vertex * 11 + byte * 5) % 250);
}

static int element_of(int attribute) {
    return types[attribute % TYPES].size * shapes[attribute / TYPES % SHAPES].components;
}

/* Of each vertex its own bytes; of a sparse one, vertex 4 has those of `vertex` 40. */
static void add_attribute(file* f, int attribute) {
    const int element = element_of(attribute), way = attribute / (TYPES * SHAPES);
    const int stride = way & STRIDED ? (element + 7) & ~3 : element;
    uint8_t bytes[VERTICES * 80] = {0}, change[64], index[4] = {4};
    char accessor[512], sparse[256] = "";
    for (int v = 0; v < VERTICES; v++)
        for (int b = 0; b < element; b++) bytes[v * stride + b] = value_of(attribute, v, b);
    const int view = add_view(f, bytes, (size_t)(VERTICES * stride), way & STRIDED ? stride : 0);
    if (way & SPARSE) {
        for (int b = 0; b < element; b++) change[b] = value_of(attribute, 40, b);
        const int indices = add_view(f, index, sizeof index, 0);
        snprintf(sparse, sizeof sparse,
                 ",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":%d,\"componentType\":5121},"
                 "\"values\":{\"bufferView\":%d}}",
                 indices, add_view(f, change, (size_t)element, 0));
    }
    snprintf(accessor, sizeof accessor,
             ",{\"name\":\"n%d\",\"bufferView\":%d,\"byteOffset\":0,\"componentType\":%d,\"count\":%d,\"type\":\"%s\","
             "\"normalized\":%s,\"min\":[1],\"max\":[2]%s}",
             attribute, view, types[attribute % TYPES].type, VERTICES, shapes[attribute / TYPES % SHAPES].name,
             attribute % 3 ? "true" : "false", sparse);
    say(f->json, &f->length, accessor);
}

/* Two triangles on a bone each, with an attribute of every type, shape and way to store it. */
static file skinned_file(void) {
    static const float xyz[VERTICES][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
    static const int8_t normals[VERTICES][4] = {{0, 0, 127},  {0, 0, 127}, {0, 0, 127},
                                                {0, 0, -127}, {0, 127, 0}, {90, 0, 0}};
    static const uint8_t joints[VERTICES][4] = {{0}, {0}, {0}, {1}, {1}, {1}}, weights[4] = {255};
    file f = {.json = calloc(1, TEXT), .bytes = calloc(1, MOST_BYTES), .list = calloc(1, TEXT)};
    uint8_t all[VERTICES][4];
    char line[1024];
    for (int v = 0; v < VERTICES; v++) memcpy(all[v], weights, 4);
    say(f.json, &f.length, "{\"asset\":{\"version\":\"2.0\"},\"accessors\":[");
    snprintf(line, sizeof line,
             "{\"bufferView\":%d,\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"},"
             "{\"bufferView\":%d,\"componentType\":5121,\"count\":6,\"type\":\"VEC4\"},"
             "{\"bufferView\":%d,\"componentType\":5121,\"count\":6,\"type\":\"VEC4\",\"normalized\":true},"
             "{\"bufferView\":%d,\"componentType\":5120,\"count\":6,\"type\":\"VEC3\",\"normalized\":true}",
             0, 1, 2, 3);
    add_view(&f, xyz, sizeof xyz, 0);
    add_view(&f, joints, sizeof joints, 0);
    add_view(&f, all, sizeof all, 0);
    add_view(&f, normals, sizeof normals, 4);
    say(f.json, &f.length, line);
    for (int a = 0; a < ATTRIBUTES; a++) add_attribute(&f, a);
    say(f.json, &f.length,
        "],\"meshes\":[{\"weights\":[0.5],\"name\":\"m\",\"primitives\":[{\"targets\":[{\"POSITION\":0}],"
        "\"attributes\":{"
        "\"POSITION\":0,\"JOINTS_0\":1,\"WEIGHTS_0\":2,\"NORMAL\":3");
    for (int a = 0; a < ATTRIBUTES; a++) {
        snprintf(line, sizeof line, ",\"_A%d\":%d", a, OWN + a);
        say(f.json, &f.length, line);
    }
    say(f.json, &f.length,
        "}}]}],\"skins\":[{\"joints\":[1,2]}],\"nodes\":[{\"mesh\":0,\"skin\":0},{\"name\":\"frame\"},"
        "{\"name\":\"door\",\"translation\":[0,0,1],\"scale\":[1,2,1]}],\"bufferViews\":[");
    say(f.json, &f.length, f.list);
    snprintf(line, sizeof line, "],\"buffers\":[{\"byteLength\":%zu}]}", f.size);
    say(f.json, &f.length, line);
    return f;
}

/* The bytes of a vertex of an accessor that an export has written. */
static const uint8_t* element_at(const exported* e, const cJSON* accessor, int element, int vertex) {
    const cJSON* view = item(e, "bufferViews", number(accessor, "bufferView", -1));
    const int at = number(view, "byteOffset", 0), stride = number(view, "byteStride", element);
    assert_true(vertex * stride + element <= number(view, "byteLength", 0));
    assert_int_equal(number(view, "target", 0), 34962);
    assert_int_equal(stride % 4 == 0 || stride == element, 1);
    return e->bin + at + vertex * stride;
}

static void attributes_of_every_type_keep_their_bytes(void** state) {
    (void)state;
    const uint8_t ids[2] = {0, 1};
    file f = skinned_file();
    exported e;
    export_file(&e, f.json, f.bytes, f.size, ids);
    const cJSON* mesh = item(&e, "meshes", number(node_with_mesh(&e, false), "mesh", -1));
    const cJSON* primitive = cJSON_GetArrayItem(member(mesh, "primitives"), 0);
    const cJSON* attributes = member(primitive, "attributes");
    assert_int_equal(cJSON_GetArraySize(member(mesh, "primitives")), 1);
    assert_int_equal(cJSON_GetArraySize(attributes), ATTRIBUTES + 2); /* bones have had their say */
    for (int a = 0; a < ATTRIBUTES; a++) {
        char name[16];
        snprintf(name, sizeof name, "_A%d", a);
        const cJSON* accessor = item(&e, "accessors", number(attributes, name, -1));
        snprintf(name, sizeof name, "n%d", a);
        assert_string_equal(member(accessor, "name")->valuestring, name);
        assert_string_equal(member(accessor, "type")->valuestring, shapes[a / TYPES % SHAPES].name);
        assert_int_equal(number(accessor, "componentType", 0), types[a % TYPES].type);
        assert_int_equal(number(accessor, "count", 0), 3);
        assert_int_equal(cJSON_IsTrue(member(accessor, "normalized")), a % 3 != 0);
        assert_null(member(accessor, "sparse"));
        assert_null(member(accessor, "min"));
        assert_int_equal(number(accessor, "byteOffset", 0), 0);
        for (int v = 0; v < 3; v++) {
            const int from = a / (TYPES * SHAPES) & SPARSE && v == 1 ? 40 : 3 + v;
            const uint8_t* got = element_at(&e, accessor, element_of(a), v);
            for (int b = 0; b < element_of(a); b++)
                if (got[b] != value_of(a, from, b)) fail_msg("attribute %d, vertex %d, byte %d", a, v, b);
        }
    }
    close_it(&e);
    free(f.json), free(f.bytes), free(f.list);
}

static void a_placed_copy_has_its_bones_frame(void** state) {
    (void)state;
    /* Grown by half by the morph target, then stretched along y by 2: normals there shrink and are made unit again. */
    static const float xyz[3][3] = {{3, 0, 1}, {4.5f, 0, 1}, {3, 3, 1}},
                       normals[3][3] = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    const uint8_t ids[2] = {0, 1};
    file f = skinned_file();
    exported e;
    export_file(&e, f.json, f.bytes, f.size, ids);
    const cJSON *node = node_with_mesh(&e, false), *stays = node_with_mesh(&e, true);
    const cJSON* mesh = item(&e, "meshes", number(node, "mesh", -1));
    const cJSON* primitive = cJSON_GetArrayItem(member(mesh, "primitives"), 0);
    const cJSON* attributes = member(primitive, "attributes");
    const cJSON* accessor = item(&e, "accessors", number(attributes, "POSITION", -1));
    assert_int_equal(cJSON_GetArraySize(member(accessor, "min")), 3);
    for (int k = 0; k < 3; k++) {
        assert_true(cJSON_GetArrayItem(member(accessor, "min"), k)->valuedouble == (double)fminf(xyz[0][k], xyz[2][k]));
        assert_true(cJSON_GetArrayItem(member(accessor, "max"), k)->valuedouble == (double)fmaxf(xyz[1][k], xyz[2][k]));
    }
    for (int v = 0; v < 3; v++) assert_memory_equal(element_at(&e, accessor, 12, v), xyz[v], 12);
    accessor = item(&e, "accessors", number(attributes, "NORMAL", -1));
    assert_int_equal(number(accessor, "componentType", 0), 5126);
    assert_false(cJSON_IsTrue(member(accessor, "normalized")));
    for (int v = 0; v < 3; v++) {
        float got[3];
        memcpy(got, element_at(&e, accessor, 12, v), sizeof got);
        for (int k = 0; k < 3; k++) assert_float_equal(got[k], normals[v][k], 1e-6f);
    }
    /* Morph targets are of the mesh's frame: what has left it has none, what stays keeps them. */
    assert_null(member(primitive, "targets"));
    assert_null(member(mesh, "weights"));
    assert_string_equal(member(mesh, "name")->valuestring, "m");
    mesh = item(&e, "meshes", number(stays, "mesh", -1));
    primitive = cJSON_GetArrayItem(member(mesh, "primitives"), 0);
    assert_int_equal(cJSON_GetArraySize(member(primitive, "targets")), 1);
    assert_int_equal(cJSON_GetArraySize(member(mesh, "weights")), 1);
    assert_int_equal(number(member(primitive, "attributes"), "_A0", -1), OWN);
    assert_int_equal(number(member(primitive, "attributes"), "JOINTS_0", -1), 1);
    accessor = item(&e, "accessors", number(primitive, "indices", -1));
    assert_int_equal(number(accessor, "count", 0), 3);
    close_it(&e);
    free(f.json), free(f.bytes), free(f.list);
}

/* ---- buffers ---- */

/* Buffers of odd sizes, one of them without bytes: in the one that is written, every view has the bytes it had. */
static void every_view_keeps_its_bytes(void** state) {
    (void)state;
    static const float xyz[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
    static const struct {
        const char* bytes;
        int size, buffer; /* the buffer that is written */
    } views[] = {{NULL, 72, 0}, {"\x01\x02\x03\x04\x05", 5, 0}, {"\x04\x05", 2, 0},
                 {NULL, 4, 1},  {"\xff\xfe\xfd", 3, 0},         {"\xfe", 1, 0},
                 {NULL, 8, 2}};
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":73},"
        "{\"byteLength\":5,\"uri\":\"data:;base64,AQIDBAU=\"},{\"byteLength\":16,\"extras\":1},"
        "{\"byteLength\":3,\"uri\":\"data:;base64,//79\"},{\"byteLength\":99,\"extras\":2}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":72},{\"buffer\":1,\"byteLength\":5},"
        "{\"buffer\":1,\"byteOffset\":3,\"byteLength\":2},"
        "{\"buffer\":2,\"byteOffset\":8,\"byteLength\":4,\"extensions\":{\"EXT_meshopt_compression\":{\"buffer\":3,"
        "\"byteOffset\":1,\"byteLength\":2,\"byteStride\":4,\"count\":1,\"mode\":\"ATTRIBUTES\"}}},"
        "{\"buffer\":3,\"byteLength\":3},{\"buffer\":3,\"byteOffset\":1,\"byteLength\":1},"
        "{\"buffer\":4,\"byteLength\":8}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":6,\"type\":\"VEC3\"}],"
        "\"extras\":{\"a\":0.1,\"b\":0.30000000000000004,\"c\":[1e300,-2.2250738585072014e-308],\"d\":"
        "123456789012345678},"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}]}";
    uint8_t bytes[76] = {0};
    const uint8_t ids[2] = {0, 1};
    memcpy(bytes, xyz, sizeof xyz);
    exported e;
    export_file(&e, json, bytes, sizeof bytes, ids);
    assert_int_equal(cJSON_GetArraySize(member(e.json, "buffers")), 3);
    assert_true(number(item(&e, "buffers", 0), "byteLength", 0) <= (int)e.bin_size);
    assert_true(number(item(&e, "buffers", 0), "byteLength", 0) > (int)e.bin_size - 4);
    for (int i = 0; i < 5; i++) assert_null(member(item(&e, "buffers", i), "uri"));
    assert_int_equal(number(item(&e, "buffers", 1), "extras", 0), 1);
    assert_int_equal(number(item(&e, "buffers", 2), "extras", 0), 2);
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        const cJSON* view = item(&e, "bufferViews", (int)i);
        assert_int_equal(number(view, "buffer", -1), views[i].buffer);
        assert_int_equal(number(view, "byteLength", -1), views[i].size);
        const uint8_t* at = e.bin + number(view, "byteOffset", 0);
        if (views[i].bytes) assert_memory_equal(at, views[i].bytes, (size_t)views[i].size);
        if (i == 0) assert_memory_equal(at, xyz, sizeof xyz);
    }
    const cJSON* view = item(&e, "bufferViews", 3); /* of a buffer without bytes, and compressed in another */
    assert_int_equal(number(view, "byteOffset", 0), 8);
    const cJSON* compressed = member(member(view, "extensions"), "EXT_meshopt_compression");
    assert_int_equal(number(compressed, "buffer", -1), 0);
    assert_memory_equal(e.bin + number(compressed, "byteOffset", 0), "\xfe\xfd", 2);
    const cJSON* extras = member(e.json, "extras");
    assert_true(member(extras, "a")->valuedouble == 0.1);
    assert_true(member(extras, "b")->valuedouble == 0.30000000000000004);
    assert_true(cJSON_GetArrayItem(member(extras, "c"), 0)->valuedouble == 1e300);
    assert_true(cJSON_GetArrayItem(member(extras, "c"), 1)->valuedouble == -2.2250738585072014e-308);
    assert_true(member(extras, "d")->valuedouble == 123456789012345678.0);
    close_it(&e);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(attributes_of_every_type_keep_their_bytes),
        cmocka_unit_test(a_placed_copy_has_its_bones_frame),
        cmocka_unit_test(every_view_keeps_its_bytes),
    };
    return cmocka_run_group_tests_name("gltf_copies", tests, NULL, NULL);
}
