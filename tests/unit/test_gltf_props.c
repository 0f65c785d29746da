/* Twelve ways to ship a prop: each is read as the same triangles, its door and handle move, and what is written back
 * holds all that was read. */
#include <math.h>

#include "dragmesh/ext/gltf.h"
#include "math/dual_quat.h"
#include "test_env.h"
#include "test_prop.h"

enum { FACES = TEST_PROP_PIECES * 12, KEYS = 5 };

/* The host's folder: one file, that of the prop. */
typedef struct folder {
    const test_prop* prop;
    char asked[64];
    int open;
} folder;

static int32_t DM_CALL open_beside(void* user, const char* path, const void** out_data, size_t* out_size) {
    folder* f = user;
    snprintf(f->asked, sizeof f->asked, "%s", path);
    if (strcmp(path, "parts/the cabinet.bin") != 0) return DM_ERROR_NOT_FOUND;
    *out_data = f->prop->beside;
    *out_size = f->prop->beside_size;
    f->open++;
    return DM_OK;
}

static void DM_CALL close_beside(void* user, const void* data, size_t size) {
    folder* f = user;
    assert_ptr_equal(data, f->prop->beside);
    assert_int_equal(size, f->prop->beside_size);
    f->open--;
}

typedef struct opened {
    test_env t;
    folder folder;
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    dm_result result;
} opened;

static void open_at(opened* o, const test_prop* prop, const void* data, size_t size, int64_t fail_at) {
    memset(o, 0, sizeof *o);
    test_env_open(&o->t, fail_at);
    o->folder.prop = prop;
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = data,
                               .size = size,
                               .allocator = test_allocator(&o->t.memory),
                               .log = test_log(&o->t.messages),
                               .files = {&o->folder, open_beside, close_beside}};
    o->result = dm_gltf_open(&desc, &o->gltf);
    if (o->result == DM_OK) dm_gltf_get_mesh(o->gltf, &o->mesh);
}

static void open_prop(opened* o, const test_prop* prop) {
    open_at(o, prop, prop->data, prop->size, TEST_NEVER);
    if (o->result != DM_OK) fail_msg("%d '%s'", o->result, o->t.messages.text);
}

static void close_it(opened* o) {
    dm_gltf_close(o->gltf);
    assert_int_equal(o->folder.open, 0);
    test_env_close(&o->t);
}

/* ---- triangles ---- */

/* Corner `corner` of a face of the scene, in metres and near the origin. */
static void corner_of(const opened* o, const test_prop* prop, size_t face, int corner, double out[3]) {
    const float* from =
        (const float*)o->mesh.positions + 3 * (size_t)((const uint32_t*)o->mesh.indices)[3 * face + (size_t)corner];
    double origin[3];
    dm_gltf_get_origin(o->gltf, origin);
    for (int k = 0; k < 3; k++)
        out[k] = ((double)from[k] + origin[k] - (prop->unit < 1 ? test_prop_far[k] : 0)) * prop->unit;
}

/* The piece whose triangle this is, or -1: the corners in order, whichever is first. */
static int piece_of(const opened* o, const test_prop* prop, size_t face, uint8_t used[FACES]) {
    double got[3][3];
    for (int c = 0; c < 3; c++) corner_of(o, prop, face, c, got[c]);
    for (int f = 0; f < FACES; f++) {
        float v[8][3];
        test_prop_vertices(f / 12, v);
        for (int turn = 0; turn < 3 && !used[f]; turn++) {
            double worst = 0;
            for (int c = 0; c < 3; c++) {
                for (int k = 0; k < 3; k++)
                    worst = fmax(worst, fabs(got[(c + turn) % 3][k] - (double)v[test_prop_box[3 * (f % 12) + c]][k]));
            }
            if (worst > 5e-5) continue;
            used[f] = 1;
            return f / 12;
        }
    }
    return -1;
}

static void assert_whole(const opened* o, const test_prop* prop, int way, int pieces[FACES]) {
    uint8_t used[FACES] = {0};
    if (o->mesh.index_count != 3 * FACES) fail_msg("way %d: %d corners", way, (int)o->mesh.index_count);
    for (size_t face = 0; face < FACES; face++) {
        pieces[face] = piece_of(o, prop, face, used);
        if (pieces[face] < 0) fail_msg("way %d: triangle %zu is none of the prop", way, face);
    }
}

/* Whether the handle goes where the door goes. */
static int is_carried(int way) {
    return way == TEST_PROP_SKIN || way == TEST_PROP_CHILD || way == TEST_PROP_DRACO || way == TEST_PROP_PRIMITIVES;
}

/* ---- read ---- */

static void test_every_way_is_the_same_prop(void** state) {
    (void)state;
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        opened o;
        int pieces[FACES];
        uint8_t ids[FACES] = {0};
        if (!test_prop_make(&prop, (test_prop_way)way)) continue;
        open_prop(&o, &prop);
        assert_whole(&o, &prop, way, pieces);
        const char* door = "door";
        assert_int_equal(dm_gltf_mark_faces(o.gltf, &door, 1, 1, ids, FACES), DM_OK);
        for (int face = 0; face < FACES; face++) {
            const int moves = pieces[face] == TEST_PROP_DOOR || (pieces[face] == TEST_PROP_HANDLE && is_carried(way));
            if (ids[face] != moves) fail_msg("way %d: triangle %d of piece %d: %d", way, face, pieces[face], ids[face]);
        }
        close_it(&o);
        test_prop_free(&prop);
    }
}

static void test_nodes_and_carriers(void** state) {
    (void)state;
    test_prop prop;
    opened o;
    dm_gltf_node body, door, handle;
    const test_prop_way ways[] = {TEST_PROP_SKIN, TEST_PROP_CHILD, TEST_PROP_PLAIN};
    for (int w = 0; w < 3; w++) {
        test_prop_make(&prop, ways[w]);
        open_prop(&o, &prop);
        assert_int_equal(dm_gltf_node_count(o.gltf), 3);
        dm_gltf_get_node(o.gltf, 0, &body);
        dm_gltf_get_node(o.gltf, 1, &door);
        dm_gltf_get_node(o.gltf, 2, &handle);
        assert_string_equal(body.name, "body");
        assert_string_equal(door.name, "door");
        assert_string_equal(handle.name, "handle");
        assert_int_equal(handle.carrier, ways[w] == TEST_PROP_PLAIN ? DM_GLTF_NO_CARRIER : 1);
        assert_int_equal(door.carrier, ways[w] == TEST_PROP_SKIN ? 0 : DM_GLTF_NO_CARRIER);
        assert_int_equal(handle.first_face, 24);
        assert_int_equal(handle.vertex_count, 8);
        close_it(&o);
        test_prop_free(&prop);
    }
}

static void test_shared_buffers_are_read_once(void** state) {
    (void)state;
    test_prop prop;
    opened o;
    test_prop_make(&prop, TEST_PROP_PRIMITIVES);
    open_prop(&o, &prop);
    dm_gltf_node door;
    dm_gltf_get_node(o.gltf, 1, &door);
    assert_int_equal(o.mesh.vertex_count, 24);
    assert_int_equal(door.vertex_count, 16);
    assert_true(fabsf(door.colour[0] - 0.5f) < 1e-6f && door.colour[2] == 0);
    close_it(&o);
    test_prop_free(&prop);
}

static void test_far_props_keep_their_shape(void** state) {
    (void)state;
    test_prop prop;
    opened o;
    double origin[3];
    test_prop_make(&prop, TEST_PROP_FAR);
    open_prop(&o, &prop);
    dm_gltf_get_origin(o.gltf, origin);
    for (int k = 0; k < 3; k++) assert_true(fabs(origin[k] - test_prop_far[k]) < 100);
    close_it(&o);
    test_prop_free(&prop);
}

/* A skin of two bones, the door bone moved up by 1 from where it was bound, of one triangle. */
static void open_skin(opened* o, const float weights[3][4], const int8_t joints[3][4], int joint_type) {
    struct {
        float positions[3][3], weights[3][4];
        int8_t joints[3][4];
    } bin = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    char json[1536];
    memcpy(bin.weights, weights, sizeof bin.weights);
    memcpy(bin.joints, joints, sizeof bin.joints);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":[{\"buffer\":0,"
             "\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":84,"
             "\"byteLength\":12}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":"
             "\"VEC3\"},{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},{\"bufferView\":2,"
             "\"componentType\":%d,\"count\":3,\"type\":\"VEC4\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{"
             "\"POSITION\":0,\"WEIGHTS_0\":1,\"JOINTS_0\":2}}]}],\"skins\":[{\"joints\":[1,2]}],\"nodes\":[{\"name\":"
             "\"skinned\",\"mesh\":0,\"skin\":0},{\"name\":\"body\"},{\"name\":\"door\",\"translation\":[0,1,0]}]}",
             sizeof bin, joint_type);
    const test_glb glb = test_glb_pack(json, &bin, sizeof bin);
    test_prop none = {.data = NULL};
    open_at(o, &none, glb.data, glb.size, TEST_NEVER);
    free(glb.data);
    if (o->result != DM_OK) fail_msg("%d '%s'", o->result, o->t.messages.text);
}

static void assert_height(const opened* o, uint32_t vertex, float y) {
    const float got = ((const float*)o->mesh.positions)[3 * vertex + 1];
    if (!(fabsf(got - y) < 1e-6f)) fail_msg("vertex %u is at %g, not %g", vertex, (double)got, (double)y);
}

/* Vertices of several bones stand where the blend has them (glTF 2.0 3.7.3.3), and move with the heaviest one. */
static void test_mixed_weights_blend_and_go_with_the_heaviest(void** state) {
    (void)state;
    const int8_t joints[3][4] = {{0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}};
    const float weights[3][4] = {{0.3f, 0.7f, 0, 0}, {1, 0, 0, 0}, {0.4f, 0.6f, 0, 0}};
    opened o;
    dm_gltf_node node;
    open_skin(&o, weights, joints, 5121);
    assert_non_null(strstr(o.t.messages.text, "2 of 3 vertices have several bones"));
    assert_int_equal(dm_gltf_node_count(o.gltf), 1); /* the triangle goes with two of its corners */
    dm_gltf_get_node(o.gltf, 0, &node);
    assert_string_equal(node.name, "door");
    assert_int_equal(node.face_count, 1);
    /* Sorted by bone: the body's vertex comes first. */
    const uint32_t* corners = o.mesh.indices;
    assert_height(&o, corners[0], 0.7f);
    assert_height(&o, corners[1], 0);
    assert_height(&o, corners[2], 1.6f);
    close_it(&o);
}

/* Weights that do not sum to 1 are taken in their proportion; what compression leaves of 0 is no second bone. */
static void test_weights_count_by_their_proportion(void** state) {
    (void)state;
    const int8_t joints[3][4] = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 1, 1}};
    const float weights[3][4] = {{0.25f, 0.25f, 0, 0}, {1, 0.004f, 0, 0}, {0.5f, 0.5f, 0.5f, 0.5f}};
    opened o;
    open_skin(&o, weights, joints, 5121);
    const uint32_t* corners = o.mesh.indices;
    assert_height(&o, corners[0], 0.5f);
    assert_height(&o, corners[1], 1 / 1.004f);
    assert_height(&o, corners[2], 2);
    close_it(&o);
}

/* Weights below 0 or of bones that there are none of do not count; nothing is read beside the bones. */
static void test_bones_that_are_none_do_not_count(void** state) {
    (void)state;
    const float weights[3][4] = {{1, 1, 0, 0}, {1, 1, -3, 0}, {0.5f, 1, (float)NAN, 1}};
    static const int8_t joints[][4] = {{1, -1, 0, 0}, {1, 2, 0, 0}, {1, 127, 0, -128}};
    opened o;
    open_skin(&o, weights, joints, 5120);
    const uint32_t* corners = o.mesh.indices;
    assert_height(&o, corners[0], 1);
    assert_height(&o, corners[1], 1);
    assert_height(&o, corners[2], 2);
    close_it(&o);
}

/* A vertex without any bone: the skin is left out, and the node places the mesh. */
static void test_a_vertex_without_bones_leaves_the_skin_out(void** state) {
    (void)state;
    const int8_t joints[3][4] = {{0}, {0}, {1, 0, 0, 0}};
    const float weights[3][4] = {{1, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}};
    opened o;
    dm_gltf_node node;
    open_skin(&o, weights, joints, 5121);
    assert_non_null(strstr(o.t.messages.text, "its skin is left out"));
    dm_gltf_get_node(o.gltf, 0, &node);
    assert_string_equal(node.name, "skinned");
    assert_height(&o, 2, 1);
    close_it(&o);
}

static void test_a_missing_file_is_named(void** state) {
    (void)state;
    test_prop prop;
    opened o;
    test_prop_make(&prop, TEST_PROP_BESIDE);
    open_prop(&o, &prop);
    assert_string_equal(o.folder.asked, "parts/the cabinet.bin");
    close_it(&o);
    static const struct {
        const char* uri;
        dm_result result;
    } uris[] = {{"gone.bin", DM_ERROR_NOT_FOUND},       {"../x.bin", DM_ERROR_BAD_DATA},
                {"/etc/passwd", DM_ERROR_BAD_DATA},     {"a/../../x", DM_ERROR_BAD_DATA},
                {"%2e%2e/x.bin", DM_ERROR_BAD_DATA},    {"http://x/y.bin", DM_ERROR_BAD_DATA},
                {"a%5c..%5cb", DM_ERROR_BAD_DATA},      {"file:x", DM_ERROR_BAD_DATA},
                {"parts//x", DM_ERROR_BAD_DATA},        {"", DM_ERROR_BAD_DATA},
                {"parts/%00x", DM_ERROR_BAD_DATA},      {"./gone.bin", DM_ERROR_NOT_FOUND},
                {"data:;base64,A*", DM_ERROR_BAD_DATA}, {"data:text/plain,hello", DM_ERROR_UNSUPPORTED}};
    for (size_t i = 0; i < sizeof uris / sizeof *uris; i++) {
        cJSON* buffer = cJSON_GetArrayItem(cJSON_GetObjectItem(prop.json, "buffers"), 0);
        cJSON_ReplaceItemInObject(buffer, "uri", cJSON_CreateString(uris[i].uri));
        char* text = cJSON_PrintUnformatted(prop.json);
        open_at(&o, &prop, text, strlen(text), TEST_NEVER);
        if (o.result != uris[i].result) fail_msg("'%s': %d '%s'", uris[i].uri, o.result, o.t.messages.text);
        close_it(&o);
        free(text);
    }
    test_prop_free(&prop);
}

/* ---- written back ---- */

static dm_result export_door(opened* o, dm_pose poses[KEYS], void** out_data, size_t* out_size) {
    const char* names[] = {"door", "handle"};
    const float axis[3] = {0, 1, 0}, hinge[3] = {-0.298f, 0, 0.182f};
    uint8_t ids[FACES] = {0};
    float times[KEYS];
    dm_gltf_mark_faces(o->gltf, names, 1, 1, ids, FACES);
    dm_gltf_mark_faces(o->gltf, names + 1, 1, 1, ids, FACES); /* which some ways don't have as a node */
    for (int k = 0; k < KEYS; k++) {
        times[k] = (float)k;
        poses[k] = dmi_pose_from_screw(axis, hinge, -0.3f * (float)k, 0);
    }
    const dm_gltf_track track = {
        .name = "moves", .face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = KEYS};
    return dm_gltf_export(o->gltf, &track, 1, out_data, out_size);
}

/* Every object and list of `from` is in `to`, with the same numbers and texts; `to` may have more. */
static void assert_kept(const cJSON* from, const cJSON* to, int way) {
    const cJSON* item;
    int index = 0;
    if (!to) fail_msg("way %d: '%s' is lost", way, from->string ? from->string : "an item");
    if (cJSON_IsNumber(from) && from->valuedouble != to->valuedouble)
        fail_msg("way %d: '%s' was %.17g, is %.17g", way, from->string, from->valuedouble, to->valuedouble);
    if (cJSON_IsString(from)) assert_string_equal(from->valuestring, to->valuestring);
    assert_int_equal(from->type, to->type);
    cJSON_ArrayForEach(item, from) {
        const cJSON* other =
            cJSON_IsArray(from) ? cJSON_GetArrayItem(to, index++) : cJSON_GetObjectItemCaseSensitive(to, item->string);
        assert_kept(item, other, way);
    }
}

/* All but the lists that splitting and re-hanging change. */
static void assert_document_kept(const cJSON* from, const cJSON* to, int way) {
    static const char* const kept[] = {"asset", "extras", "accessors", "materials", "images", "skins", "meshes"};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        const cJSON* list = cJSON_GetObjectItem(from, kept[i]);
        if (list) assert_kept(list, cJSON_GetObjectItem(to, kept[i]), way);
    }
    const cJSON *node, *old = cJSON_GetObjectItem(from, "nodes");
    int index = 0;
    cJSON_ArrayForEach(node, old) {
        const cJSON* now = cJSON_GetArrayItem(cJSON_GetObjectItem(to, "nodes"), index++);
        assert_string_equal(cJSON_GetObjectItem(node, "name")->valuestring,
                            cJSON_GetObjectItem(now, "name")->valuestring);
    }
}

static void test_every_way_is_written_back_whole(void** state) {
    (void)state;
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        opened o, again;
        int pieces[FACES];
        dm_pose poses[KEYS];
        void* data;
        size_t size;
        if (!test_prop_make(&prop, (test_prop_way)way)) continue;
        open_prop(&o, &prop);
        if (export_door(&o, poses, &data, &size) != DM_OK) fail_msg("way %d: %s", way, o.t.messages.text);
        open_at(&again, &prop, data, size, TEST_NEVER);
        if (again.result != DM_OK) fail_msg("way %d: %s", way, again.t.messages.text);
        assert_whole(&again, &prop, way, pieces);
        char* text = test_glb_json(data);
        cJSON* json = cJSON_Parse(text);
        assert_non_null(strstr(text, "9007199254740991"));
        assert_document_kept(prop.json, json, way);
        cJSON_Delete(json);
        free(text);
        dm_gltf_release_bytes(o.gltf, data, size);
        close_it(&again);
        close_it(&o);
        test_prop_free(&prop);
    }
}

/* ---- failures ---- */

static void test_every_allocation_may_fail(void** state) {
    (void)state;
    for (int way = 0; way < TEST_PROP_WAYS; way++) {
        test_prop prop;
        dm_pose poses[KEYS];
        if (!test_prop_make(&prop, (test_prop_way)way)) continue;
        dm_result result = DM_ERROR_OUT_OF_MEMORY;
        for (int64_t n = 0; result != DM_OK; n++) {
            opened o;
            open_at(&o, &prop, prop.data, prop.size, n);
            result = o.result;
            if (result != DM_OK && result != DM_ERROR_OUT_OF_MEMORY) fail_msg("way %d, %d: %d", way, (int)n, result);
            close_it(&o);
        }
        result = DM_ERROR_OUT_OF_MEMORY;
        for (int64_t n = 0; result != DM_OK; n++) {
            opened o;
            void* data = NULL;
            size_t size = 0;
            open_prop(&o, &prop);
            o.t.memory.fail_at = o.t.memory.calls + 3 + n; /* after both marks */
            result = export_door(&o, poses, &data, &size);
            if (result != DM_OK && result != DM_ERROR_OUT_OF_MEMORY) fail_msg("way %d, %d: %d", way, (int)n, result);
            dm_gltf_release_bytes(o.gltf, data, size);
            close_it(&o);
        }
        test_prop_free(&prop);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_way_is_the_same_prop),
        cmocka_unit_test(test_nodes_and_carriers),
        cmocka_unit_test(test_shared_buffers_are_read_once),
        cmocka_unit_test(test_far_props_keep_their_shape),
        cmocka_unit_test(test_a_missing_file_is_named),
        cmocka_unit_test(test_every_way_is_written_back_whole),
        cmocka_unit_test(test_every_allocation_may_fail),
        cmocka_unit_test(test_mixed_weights_blend_and_go_with_the_heaviest),
        cmocka_unit_test(test_weights_count_by_their_proportion),
        cmocka_unit_test(test_bones_that_are_none_do_not_count),
        cmocka_unit_test(test_a_vertex_without_bones_leaves_the_skin_out),
    };
    return cmocka_run_group_tests_name("gltf_props", tests, NULL, NULL);
}
