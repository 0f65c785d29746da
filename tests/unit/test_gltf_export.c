/* glTF out: the animated file is read back, its keys are put into the nodes one by one, and every vertex must be where
 * the pose of that key takes it. */
#include <math.h>
#include <stdio.h>

#include <cjson/cJSON.h>

#include "math/dual_quat.h"
#include "test_glb.h"
#include "test_gltf.h"

enum { KEYS = 9 };

/* Two boxes' worth of a square door and its frame, 4 vertices and 2 triangles each, in one primitive of one mesh. */
typedef struct bin {
    float positions[8][3];
    uint16_t indices[12];
} bin;

static const bin both = {
    .positions = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}},
    .indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}};

#define DATA                                                                                                           \
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":120}],\"bufferViews\":["                            \
    "{\"buffer\":0,\"byteLength\":96,\"target\":34962},{\"buffer\":0,\"byteOffset\":96,\"byteLength\":24,"             \
    "\"target\":34963}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\","        \
    "\"min\":[0,0,0],\"max\":[4,4,0]},{\"bufferView\":1,\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"},"     \
    "{\"bufferView\":1,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}],"                                      \
    "\"materials\":[{\"name\":\"oak\",\"extras\":{\"age\":7}}],\"meshes\":[{\"name\":\"both\",\"primitives\":["        \
    "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0},{\"attributes\":{\"POSITION\":0},\"mode\":0}]}],"

typedef struct setup {
    test_env t;
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    dm_pose poses[KEYS];
    float times[KEYS];
    uint8_t ids[64];
} setup;

/* The line about which poses turn: a direction of length 1, and a point of it. */
static const float axis[3] = {0.36f, 0.48f, 0.8f}, axis_point[3] = {3, 1, 0};

/* A file with the given nodes; the poses turn by 1.2 rad about the line and advance along it. */
static void set_up(setup* s, const char* nodes, float turn, float advance) {
    memset(s, 0, sizeof *s);
    test_env_open(&s->t, TEST_NEVER);
    char* json = malloc(strlen(nodes) + sizeof DATA);
    sprintf(json, "%s%s", DATA, nodes);
    const test_glb glb = test_glb_pack(json, &both, sizeof both);
    s->gltf = test_gltf_open(&s->t, glb.data, glb.size);
    dm_gltf_get_mesh(s->gltf, &s->mesh);
    for (int k = 0; k < KEYS; k++) {
        const float part = (float)k / (KEYS - 1);
        s->poses[k] = dmi_pose_from_screw(axis, axis_point, turn * part, advance * part);
        s->times[k] = 0.25f * (float)k + (k > 4 ? 0.125f : 0);
    }
    free(glb.data);
    free(json);
}

static dm_gltf_track track_of(const setup* s) {
    return (dm_gltf_track){.face_ids = s->ids, .value = 1, .poses = s->poses, .times = s->times, .key_count = KEYS};
}

static void tear_down(setup* s, void* data, size_t size) {
    dm_gltf_release_bytes(s->gltf, data, size);
    dm_gltf_close(s->gltf);
    test_env_close(&s->t);
}

/* ---- the written file, opened up ---- */

typedef struct animated {
    cJSON* json;
    const uint8_t* bin;
    uint32_t bin_size;
} animated;

static animated open_up(const void* data) {
    animated a;
    char* text = test_glb_json(data);
    a.json = cJSON_Parse(text);
    free(text);
    assert_non_null(a.json);
    a.bin = test_glb_bin(data, &a.bin_size);
    return a;
}

static cJSON* item(const cJSON* array, const char* name, int index) {
    return cJSON_GetArrayItem(cJSON_GetObjectItem(array, name), index);
}

static int number(const cJSON* object, const char* name) {
    return cJSON_GetObjectItem(object, name)->valueint;
}

/* The floats of an accessor. */
static const float* floats_of(const animated* a, int accessor, int* out_count) {
    const cJSON* from = item(a->json, "accessors", accessor);
    const cJSON* view = item(a->json, "bufferViews", number(from, "bufferView"));
    const cJSON* offset = cJSON_GetObjectItem(view, "byteOffset");
    *out_count = number(from, "count");
    return (const float*)(const void*)(a->bin + (offset ? offset->valueint : 0));
}

/* Puts key `k` into the animated nodes and opens the file as it then is. */
static dm_gltf* open_at_key(test_env* t, const animated* a, int k) {
    cJSON* still = cJSON_Duplicate(a->json, 1);
    const cJSON* animation = item(a->json, "animations", 0);
    const cJSON* channel;
    cJSON_ArrayForEach(channel, cJSON_GetObjectItem(animation, "channels")) {
        const cJSON* target = cJSON_GetObjectItem(channel, "target");
        const char* path = cJSON_GetObjectItem(target, "path")->valuestring;
        const int width = strcmp(path, "rotation") == 0 ? 4 : 3;
        int count;
        const float* values =
            floats_of(a, number(item(animation, "samplers", number(channel, "sampler")), "output"), &count);
        assert_true(k < count);
        cJSON* node = item(still, "nodes", number(target, "node"));
        cJSON_DeleteItemFromObject(node, path);
        cJSON_AddItemToObject(node, path, cJSON_CreateFloatArray(values + width * k, width));
    }
    char* text = cJSON_PrintUnformatted(still);
    const test_glb glb = test_glb_pack(text, a->bin, a->bin_size);
    dm_gltf* gltf = test_gltf_open(t, glb.data, glb.size);
    free(glb.data);
    free(text);
    cJSON_Delete(still);
    return gltf;
}

/* Where corner c of the merged mesh is. */
static const float* corner(const dm_mesh_desc* mesh, size_t c) {
    return (const float*)mesh->positions + 3 * (size_t)((const uint32_t*)mesh->indices)[c];
}

static int same_point(const float a[3], const float b[3]) {
    return fabsf(a[0] - b[0]) < 4e-6f && fabsf(a[1] - b[1]) < 4e-6f && fabsf(a[2] - b[2]) < 4e-6f;
}

/* Every triangle of the original, moved by `pose` when its id is 1, is in the file, and no other. */
static void assert_scene(const setup* s, const dm_gltf* now, const dm_pose* pose) {
    dm_mesh_desc mesh;
    dm_gltf_get_mesh(now, &mesh);
    assert_int_equal(mesh.index_count, s->mesh.index_count);
    uint8_t used[64] = {0};
    for (size_t face = 0; face < s->mesh.index_count / 3; face++) {
        float want[3][3];
        for (size_t c = 0; c < 3; c++) {
            memcpy(want[c], corner(&s->mesh, 3 * face + c), sizeof want[c]);
            if (s->ids[face]) dmi_pose_apply(pose, corner(&s->mesh, 3 * face + c), want[c]);
        }
        size_t found = SIZE_MAX;
        for (size_t f = 0; f < mesh.index_count / 3 && found == SIZE_MAX; f++) {
            if (!used[f] && same_point(corner(&mesh, 3 * f), want[0]) &&
                same_point(corner(&mesh, 3 * f + 1), want[1]) && same_point(corner(&mesh, 3 * f + 2), want[2]))
                found = f;
        }
        if (found == SIZE_MAX) fail_msg("triangle %zu is not where its pose takes it", face);
        used[found] = 1;
    }
}

/* Every accessor of floats that says what its values lie between says so truly. */
static void assert_limits(const animated* a) {
    const cJSON* accessors = cJSON_GetObjectItem(a->json, "accessors");
    for (int i = 0; i < cJSON_GetArraySize(accessors); i++) {
        const cJSON *accessor = cJSON_GetArrayItem(accessors, i), *min = cJSON_GetObjectItem(accessor, "min"),
                    *max = cJSON_GetObjectItem(accessor, "max");
        if (!min || number(accessor, "componentType") != 5126 || cJSON_GetObjectItem(accessor, "byteOffset")) continue;
        int count;
        const float* values = floats_of(a, i, &count);
        const int width = cJSON_GetArraySize(min);
        for (int k = 0; k < width; k++) {
            float low = INFINITY, high = -INFINITY;
            for (int v = 0; v < count; v++)
                low = fminf(low, values[v * width + k]), high = fmaxf(high, values[v * width + k]);
            assert_true((float)cJSON_GetArrayItem(min, k)->valuedouble == low);
            assert_true((float)cJSON_GetArrayItem(max, k)->valuedouble == high);
        }
    }
}

/* Exports, and checks every key there and back. */
static void assert_moves(setup* s, int expected_keys, void** out_data, size_t* out_size) {
    const dm_gltf_track track = track_of(s);
    if (dm_gltf_export(s->gltf, &track, 1, out_data, out_size) != DM_OK) fail_msg("%s", s->t.messages.text);
    animated a = open_up(*out_data);
    assert_limits(&a);
    int count;
    const float* times = floats_of(&a, number(item(item(a.json, "animations", 0), "samplers", 0), "input"), &count);
    assert_int_equal(count, expected_keys);
    for (int k = 0; k < count; k++) {
        assert_true(k == 0 || times[k] > times[k - 1]);
        if (k >= KEYS) /* the way back takes as long as the way there */
            assert_float_equal(times[k] - times[k - 1], s->times[count - k] - s->times[count - 1 - k], 1e-6f);
        dm_gltf* now = open_at_key(&s->t, &a, k);
        assert_scene(s, now, &s->poses[k < KEYS ? k : count - 1 - k]);
        dm_gltf_close(now);
    }
    cJSON_Delete(a.json);
}

/* ---- tests ---- */

static void test_whole_node(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"name\":\"frame\",\"mesh\":0},{\"name\":\"door\",\"mesh\":0}]}", 1.2f, 0.3f);
    memset(s.ids + 4, 1, 4);
    void* data;
    size_t size;
    assert_moves(&s, 2 * KEYS - 1, &data, &size);
    animated a = open_up(data);
    assert_string_equal(cJSON_GetObjectItem(item(a.json, "nodes", 1), "name")->valuestring, "door");
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(a.json, "meshes")), 1); /* nothing had to be split */
    const cJSON* extras = cJSON_GetObjectItem(item(a.json, "materials", 0), "extras");
    assert_int_equal(number(extras, "age"), 7); /* what is not understood is kept */
    cJSON_Delete(a.json);
    tear_down(&s, data, size);
}

static void test_split_node_in_a_tree(void** state) {
    (void)state;
    setup s;
    set_up(&s,
           "\"nodes\":[{\"scale\":[1,-1,1],\"rotation\":[0.6,0,0,0.8],\"children\":[1]},"
           "{\"name\":\"cabinet\",\"mesh\":0,\"translation\":[0,2,0.5],\"children\":[2]},"
           "{\"name\":\"foot\",\"mesh\":0,\"scale\":[0.5,0.5,0.5]}]}",
           -1.2f, 0);
    s.ids[1] = s.ids[2] = 1; /* one triangle of the frame and one of the door, of the node that carries another */
    void* data;
    size_t size;
    assert_moves(&s, 2 * KEYS - 1, &data, &size);
    tear_down(&s, data, size);
}

static void test_whole_node_that_carries_others(void** state) {
    (void)state;
    setup s;
    set_up(&s,
           "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"matrix\":[0,1,0,0, -2,0,0,0, 0,0,1,0, 5,6,7,1],"
           "\"children\":[1]},{\"name\":\"door\",\"mesh\":0,\"translation\":[1,0,0],\"children\":[2]},"
           "{\"name\":\"stays\",\"mesh\":0}]}",
           0, 2.0f);
    memset(s.ids, 1, 4);
    void* data;
    size_t size;
    assert_moves(&s, 2 * KEYS - 1, &data, &size);
    tear_down(&s, data, size);
}

static void test_full_turn_is_not_driven_back(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 6.28318530718f, 0);
    s.ids[2] = s.ids[3] = 1;
    void* data;
    size_t size;
    assert_moves(&s, KEYS, &data, &size);
    tear_down(&s, data, size);
}

/* A turn is a rotation about its own pivot: between two keys a viewer's slerp follows the joint too. The pivot is the
 * point of the axis that is nearest to the part, which an editor shows there. */
static void test_turns_leave_the_pivot_still(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1.5f, 0);
    s.ids[0] = 1;
    const dm_gltf_track track = track_of(&s);
    void* data;
    size_t size;
    assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_OK);
    animated a = open_up(data);
    int count;
    const float* moves = floats_of(&a, number(item(item(a.json, "animations", 0), "samplers", 0), "output"), &count);
    for (int i = 3; i < 3 * count; i++) assert_true(fabsf(moves[i] - moves[i % 3]) < 4e-6f);
    const float centre[3] = {2, 2, 0}; /* of the triangle that moves */
    float along = 0;
    for (int k = 0; k < 3; k++) along += (centre[k] - axis_point[k]) * axis[k];
    for (int k = 0; k < 3; k++) assert_float_equal(moves[k], axis_point[k] + along * axis[k], 4e-6f);
    cJSON_Delete(a.json);
    tear_down(&s, data, size);
}

static void test_two_tracks(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1.2f, 0.5f);
    memcpy(s.ids, (uint8_t[]){1, 1, 2, 2}, 4);
    dm_gltf_track tracks[2] = {track_of(&s), track_of(&s)};
    tracks[1].value = 2;
    tracks[1].name = "second";
    void* data;
    size_t size;
    assert_int_equal(dm_gltf_export(s.gltf, tracks, 2, &data, &size), DM_OK);
    animated a = open_up(data);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(item(a.json, "animations", 0), "channels")), 4);
    dm_gltf* now = open_at_key(&s.t, &a, KEYS - 1);
    s.ids[2] = s.ids[3] = 1; /* both moved by the same poses */
    assert_scene(&s, now, &s.poses[KEYS - 1]);
    dm_gltf_close(now);
    cJSON_Delete(a.json);
    tear_down(&s, data, size);
}

/* A door carries its lever, and each moves by a track of its own: what has gone from the tree leaves no reference. */
static void test_tracks_of_a_door_and_its_lever(void** state) {
    (void)state;
    static const char* const trees[] = {
        "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"translation\":[1,0,0],\"children\":[2]},{\"mesh\":0}]}",
        "\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"children\":[2]},"
        "{\"mesh\":0,\"scale\":[2,1,1]}]}",
        "\"nodes\":[{\"mesh\":0,\"rotation\":[0.6,0,0,0.8],\"children\":[1]},{\"mesh\":0,\"children\":[2]},{\"mesh\":0}"
        "]}"};
    for (size_t i = 0; i < sizeof trees / sizeof *trees; i++) {
        setup s;
        void* data;
        size_t size;
        set_up(&s, trees[i], 1.2f, 0.5f);
        memset(s.ids + 4, 1, 4), memset(s.ids + 8, 2, 4);
        dm_gltf_track tracks[2] = {track_of(&s), track_of(&s)};
        tracks[1].value = 2;
        assert_int_equal(dm_gltf_export(s.gltf, tracks, 2, &data, &size), DM_OK);
        animated a = open_up(data);
        for (int k = 0; k < KEYS; k++) {
            dm_gltf* now = open_at_key(&s.t, &a, k);
            assert_scene(&s, now, &s.poses[k]);
            dm_gltf_close(now);
        }
        cJSON_Delete(a.json);
        tear_down(&s, data, size);
    }
}

/* A triangle on a bone that turns, stretches and shifts it, its normal across it and its tangent along its first side.
 */
static const struct {
    float positions[3][3], normals[3][3], tangents[3][4], weights[3][4];
    uint8_t joints[3][4];
} skinned = {
    .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}},
    .normals = {{0, -0.70710678f, 0.70710678f}, {0, -0.70710678f, 0.70710678f}, {0, -0.70710678f, 0.70710678f}},
    .tangents = {{1, 0, 0, -1}, {1, 0, 0, -1}, {1, 0, 0, -1}},
    .weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}}};
static const char skinned_json[] =
    "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":180}],\"bufferViews\":["
    "{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36},"
    "{\"buffer\":0,\"byteOffset\":72,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":120,\"byteLength\":48},"
    "{\"buffer\":0,\"byteOffset\":168,\"byteLength\":12}],\"accessors\":["
    "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
    "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
    "{\"bufferView\":2,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":3,\"componentType\":5126,\"count\":3,\"type\":\"VEC4\"},"
    "{\"bufferView\":4,\"componentType\":5121,\"count\":3,\"type\":\"VEC4\"}],\"meshes\":[{\"primitives\":[{"
    "\"attributes\":"
    "{\"POSITION\":0,\"NORMAL\":1,\"TANGENT\":2,\"WEIGHTS_0\":3,\"JOINTS_0\":4}}]}],\"skins\":[{\"joints\":[1]}],"
    "\"nodes\":[{\"mesh\":0,\"skin\":0},{\"name\":\"door\",\"translation\":[0,1,0],\"rotation\":[0.36,0.48,0,0.8],"
    "\"scale\":[2,1,0.5]}]}";

static float dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A moved part of a skin is written where its bone has it; its shading goes with it. */
static void test_a_skinned_part_keeps_its_shading(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    const test_glb glb = test_glb_pack(skinned_json, &skinned, sizeof skinned);
    dm_gltf* gltf = test_gltf_open(&t, glb.data, glb.size);
    const uint8_t ids[1] = {1};
    const float x[3] = {1, 0, 0}, zero[3] = {0}, time = 0;
    const dm_pose still = dmi_pose_from_screw(x, zero, 0, 0);
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = &still, .times = &time, .key_count = 1};
    void* data;
    size_t size;
    assert_int_equal(dm_gltf_export(gltf, &track, 1, &data, &size), DM_OK);
    animated a = open_up(data);
    const cJSON *node, *found = NULL;
    cJSON_ArrayForEach(node, cJSON_GetObjectItem(a.json, "nodes")) if (cJSON_GetObjectItem(node, "mesh") &&
                                                                       !cJSON_GetObjectItem(node, "skin")) found = node;
    assert_non_null(found);
    const cJSON* attributes =
        cJSON_GetObjectItem(item(item(a.json, "meshes", number(found, "mesh")), "primitives", 0), "attributes");
    int counts[3];
    const float* at = floats_of(&a, number(attributes, "POSITION"), &counts[0]);
    const float* normals = floats_of(&a, number(attributes, "NORMAL"), &counts[1]);
    const float* tangents = floats_of(&a, number(attributes, "TANGENT"), &counts[2]);
    for (int i = 0; i < 3; i++) assert_int_equal(counts[i], 3);
    float sides[2][3];
    for (int k = 0; k < 3; k++) sides[0][k] = at[3 + k] - at[k], sides[1][k] = at[6 + k] - at[k];
    const float across[3] = {sides[0][1] * sides[1][2] - sides[0][2] * sides[1][1],
                             sides[0][2] * sides[1][0] - sides[0][0] * sides[1][2],
                             sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0]};
    assert_float_equal(dot(sides[0], sides[0]), 4, 1e-5f); /* the bone stretches it */
    for (int v = 0; v < 3; v++) {
        assert_float_equal(dot(normals + 3 * v, across), sqrtf(dot(across, across)), 1e-5f);
        assert_float_equal(dot(normals + 3 * v, normals + 3 * v), 1, 1e-5f);
        assert_float_equal(dot(tangents + 4 * v, sides[0]), 2, 1e-5f);
        assert_float_equal(dot(tangents + 4 * v, tangents + 4 * v), 1, 1e-5f);
        assert_float_equal(tangents[4 * v + 3], -1, 0);
    }
    cJSON_Delete(a.json);
    dm_gltf_release_bytes(gltf, data, size);
    dm_gltf_close(gltf);
    free(glb.data);
    test_env_close(&t);
}

/* What leaves its buffer is left out, and stays so in the written file, whose buffer is longer. */
static void test_a_broken_view_stays_broken(void** state) {
    (void)state;
    static const char* const views[] = {"\"byteOffset\":60,\"byteLength\":96", "\"byteOffset\":25,\"byteLength\":96",
                                        "\"byteOffset\":124,\"byteLength\":96", "\"byteOffset\":-4,\"byteLength\":96"};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        char json[2048];
        snprintf(json, sizeof json,
                 "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":120}],\"bufferViews\":["
                 "{\"buffer\":0,\"byteLength\":96},{\"buffer\":0,\"byteOffset\":96,\"byteLength\":24},"
                 "{\"buffer\":0,%s}],\"accessors\":["
                 "{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"},"
                 "{\"bufferView\":1,\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"},"
                 "{\"bufferView\":2,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"}],\"meshes\":["
                 "{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]},"
                 "{\"primitives\":[{\"attributes\":{\"POSITION\":2},\"indices\":1}]}],"
                 "\"nodes\":[{\"name\":\"a\",\"mesh\":0},{\"name\":\"b\",\"mesh\":1}]}",
                 views[i]);
        const test_glb glb = test_glb_pack(json, &both, sizeof both);
        setup s = {0};
        test_env_open(&s.t, TEST_NEVER);
        s.gltf = test_gltf_open(&s.t, glb.data, glb.size);
        assert_int_equal(dm_gltf_node_count(s.gltf), 1);
        for (int k = 0; k < KEYS; k++) s.poses[k] = dmi_pose_identity(), s.times[k] = (float)k;
        const dm_gltf_track track = track_of(&s);
        void* data;
        size_t size;
        memset(s.ids, 1, 2);
        assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_OK);
        dm_gltf* again = test_gltf_open(&s.t, data, size);
        assert_int_equal(dm_gltf_node_count(again), 2); /* the two halves of a */
        dm_gltf_close(again);
        free(glb.data);
        tear_down(&s, data, size);
    }
}

/* Without tracks it is the file again, as a .glb without animations. */
static void test_no_track(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1, 0);
    void* data;
    size_t size;
    assert_int_equal(dm_gltf_export(s.gltf, NULL, 0, &data, &size), DM_OK);
    dm_gltf* again = test_gltf_open(&s.t, data, size);
    dm_mesh_desc mesh;
    assert_int_equal(dm_gltf_get_mesh(again, &mesh), DM_OK);
    assert_int_equal(dm_gltf_node_count(again), dm_gltf_node_count(s.gltf));
    const dm_asset_node* nodes;
    uint32_t count;
    assert_int_equal(dm_gltf_get_asset(again, 0, &nodes, &count), DM_OK);
    for (uint32_t i = 0; i < count; i++) assert_int_equal(nodes[i].clip_count, 0);
    dm_gltf_close(again);
    tear_down(&s, data, size);
}

static void test_bad_tracks(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1, 0);
    void* data;
    size_t size;
    dm_gltf_track track = track_of(&s);
    assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_ERROR_EMPTY_MASK);
    s.ids[0] = 1;
    assert_int_equal(dm_gltf_export(s.gltf, NULL, 1, &data, &size), DM_ERROR_INVALID_ARGUMENT);
    track.key_count = 0;
    assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_ERROR_INVALID_ARGUMENT);
    track = track_of(&s);
    s.times[3] = s.times[2];
    assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(s.t.messages.text, "time 3"));
    s.times[3] = 0.75f;
    s.poses[5].dual[1] = NAN;
    assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), DM_ERROR_NOT_FINITE);
    tear_down(&s, NULL, 0);
}

/* What no file can hold, or what is no pose. */
static void test_numbers_of_tracks(void** state) {
    (void)state;
    const struct {
        dm_pose pose;
        float time; /* of the last key */
        dm_result result;
        const char* says;
    } cases[] = {{{{0, 0, 0, 1}, {0}}, 4, DM_OK, ""},
                 {{{0, 0, 0, 1.9f}, {1e8f}}, 9e8f, DM_OK, ""},
                 {{{0}, {0}}, 4, DM_ERROR_INVALID_ARGUMENT, "pose 8 has a rotation of length 0"},
                 {{{0, 0, 0, 0.4f}, {0}}, 4, DM_ERROR_INVALID_ARGUMENT, "length 0.4"},
                 {{{0, 2.1f, 0, 0}, {0}}, 4, DM_ERROR_INVALID_ARGUMENT, "length 2.1"},
                 {{{0, 0, 0, 1}, {0, 3e38f}}, 4, DM_ERROR_INVALID_ARGUMENT, "pose 8 moves by 6e+38"},
                 {{{0, 0, 0, 1}, {0, 0, -INFINITY}}, 4, DM_ERROR_NOT_FINITE, "pose 8"},
                 {{{0, 0, 0, 1}, {0}}, 2e38f, DM_ERROR_INVALID_ARGUMENT, "time 8 is 2e+38"},
                 {{{0, 0, 0, 1}, {0}}, INFINITY, DM_ERROR_INVALID_ARGUMENT, "time 8 is inf"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        setup s;
        void* data = NULL;
        size_t size = 0;
        set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1, 0);
        s.ids[0] = 1;
        s.poses[KEYS - 1] = cases[i].pose;
        s.times[KEYS - 1] = cases[i].time;
        const dm_gltf_track track = track_of(&s);
        assert_int_equal(dm_gltf_export(s.gltf, &track, 1, &data, &size), cases[i].result);
        assert_non_null(strstr(s.t.messages.text, cases[i].says));
        assert_int_equal(data != NULL, cases[i].result == DM_OK);
        tear_down(&s, data, size);
    }
}

static void test_failing_allocator(void** state) {
    (void)state;
    setup s;
    set_up(&s, "\"nodes\":[{\"mesh\":0}]}", 1, 0);
    s.ids[0] = 1;
    const dm_gltf_track track = track_of(&s);
    for (int once = 0; once < 2; once++) { /* also where the next allocation succeeds */
        void* data = NULL;
        size_t size = 0;
        dm_result result = DM_ERROR_OUT_OF_MEMORY;
        int rounds = 0;
        s.t.memory.fail_once = once;
        for (; result != DM_OK; rounds++) {
            s.t.memory.fail_at = s.t.memory.calls + rounds;
            result = dm_gltf_export(s.gltf, &track, 1, &data, &size);
            assert_int_equal(result, s.t.memory.calls > s.t.memory.fail_at ? DM_ERROR_OUT_OF_MEMORY : DM_OK);
            assert_int_equal(data != NULL, result == DM_OK);
        }
        assert_true(rounds > 20);
        dm_gltf_release_bytes(s.gltf, data, size);
    }
    tear_down(&s, NULL, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole_node),
        cmocka_unit_test(test_split_node_in_a_tree),
        cmocka_unit_test(test_whole_node_that_carries_others),
        cmocka_unit_test(test_full_turn_is_not_driven_back),
        cmocka_unit_test(test_turns_leave_the_pivot_still),
        cmocka_unit_test(test_two_tracks),
        cmocka_unit_test(test_tracks_of_a_door_and_its_lever),
        cmocka_unit_test(test_a_skinned_part_keeps_its_shading),
        cmocka_unit_test(test_a_broken_view_stays_broken),
        cmocka_unit_test(test_no_track),
        cmocka_unit_test(test_bad_tracks),
        cmocka_unit_test(test_numbers_of_tracks),
        cmocka_unit_test(test_failing_allocator),
    };
    return cmocka_run_group_tests_name("gltf_export", tests, NULL, NULL);
}
