/* What the other commands leave behind: animated files, pictures, picks, prepared objects, scores, timings, the demo.
 */
#include <math.h>

#include "dragmesh/dragmesh.h"
#include "dragmesh/ext/gltf.h"
#include "test_door.h"
#include "test_shapes.h"

static void path_in_folder(char* path, const char* name) {
    snprintf(path, TOOL_PATH + 32, "%s/%s", door.folder, name);
}

static void run_with_drag(const char* command, const char* more) {
    tool_run(&out, "dragmesh", NULL,
             "%s|%s|--models|none|--moving|%s|--drag-point|%.9g,%.9g,%.9g|--drag-vector|%.9g,%.9g,%.9g%s", command,
             door.glb, door.moving, door.point[0], door.point[1], door.point[2], door.vector[0], door.vector[1],
             door.vector[2], more);
    if (out.status != 0) fail_msg("%s: %s", command, out.errors);
}

static dm_gltf* open_file(const char* path) {
    size_t size;
    char* bytes = tool_read(path, &size);
    const dm_gltf_desc desc = {.struct_size = sizeof desc, .data = bytes, .size = size};
    dm_gltf* gltf = NULL;
    assert_int_equal(dm_gltf_open(&desc, &gltf), DM_OK);
    free(bytes);
    return gltf;
}

static void test_animate(void** state) {
    (void)state;
    char path[TOOL_PATH + 32], more[TOOL_PATH + 64];
    path_in_folder(path, "open.glb");
    snprintf(more, sizeof more, "|-o|%s|--frames|20", path);
    run_with_drag("animate", more);
    dm_gltf *before = open_file(door.glb), *after = open_file(path);
    dm_mesh_desc old_mesh, new_mesh;
    dm_gltf_get_mesh(before, &old_mesh);
    dm_gltf_get_mesh(after, &new_mesh);
    assert_int_equal(old_mesh.index_count, new_mesh.index_count);
    dm_gltf_close(before);
    dm_gltf_close(after);
    size_t size;
    uint32_t json_size;
    char* bytes = tool_read(path, &size);
    memcpy(&json_size, bytes + 12, 4);
    cJSON* json = cJSON_ParseWithLength(bytes + 20, json_size);
    const cJSON* animation = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "animations"), 0);
    const cJSON* sampler = cJSON_GetArrayItem(cJSON_GetObjectItem(animation, "samplers"), 0);
    const cJSON* times =
        cJSON_GetArrayItem(cJSON_GetObjectItem(json, "accessors"), cJSON_GetObjectItem(sampler, "input")->valueint);
    assert_int_equal(cJSON_GetObjectItem(times, "count")->valueint, 39); /* there and back */
    cJSON_Delete(json);
    free(bytes);
}

static void test_film(void** state) {
    (void)state;
    char path[TOOL_PATH + 32], more[TOOL_PATH + 128];
    path_in_folder(path, "open.png");
    snprintf(more, sizeof more, "|-o|%s|--frames|3|--size|40,30|--axis", path);
    run_with_drag("film", more);
    size_t size;
    uint8_t* png = (uint8_t*)tool_read(path, &size);
    assert_memory_equal(png, "\x89PNG", 4);
    assert_int_equal(png[18] << 8 | png[19], 3 * 40 + 2 * 6); /* IHDR: width, height */
    assert_int_equal(png[22] << 8 | png[23], 30);
    free(png);
}

static void test_pick(void** state) {
    (void)state;
    /* From outside straight at the drag point: the door is what it meets. */
    double from[3], square = 0;
    for (int i = 0; i < 3; i++) square += door.vector[i] * door.vector[i];
    for (int i = 0; i < 3; i++) from[i] = door.point[i] + 0.05 * door.vector[i] / sqrt(square);
    tool_run(&out, "dragmesh", NULL, "pick|%s|--ray|%.9g,%.9g,%.9g,%.9g,%.9g,%.9g|--json", door.glb, from[0], from[1],
             from[2], -door.vector[0], -door.vector[1], -door.vector[2]);
    cJSON* hit = tool_json(&out);
    assert_true(cJSON_IsTrue(cJSON_GetObjectItem(hit, "hit")));
    assert_string_equal(cJSON_GetObjectItem(hit, "node")->valuestring, door.moving);
    assert_true(fabs(cJSON_GetObjectItem(hit, "distance")->valuedouble - 0.05) < 0.05);
    cJSON_Delete(hit);
    tool_run(&out, "dragmesh", NULL, "pick|%s|--ray|0,90,0,0,1,0|--json", door.glb);
    assert_int_equal(out.status, 0);
    assert_non_null(strstr(out.text, "\"hit\":false"));
}

static void test_prepare(void** state) {
    (void)state;
    char path[TOOL_PATH + 32];
    path_in_folder(path, "door.dmo");
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|none|-o|%s|--json", door.glb, path);
    cJSON* json = tool_json(&out);
    const int parts = cJSON_GetArraySize(cJSON_GetObjectItem(json, "parts"));
    assert_true(parts >= 1);
    size_t size;
    char* bytes = tool_read(path, &size);
    assert_int_equal(cJSON_GetObjectItem(json, "bytes")->valueint, size);
    dm_context* context;
    dm_object object;
    dm_object_info info = {.struct_size = sizeof info};
    assert_int_equal(dm_context_create(NULL, &context), DM_OK);
    assert_int_equal(dm_object_load(context, bytes, size, 0, &object), DM_OK);
    assert_int_equal(dm_object_get_info(context, object, &info), DM_OK);
    assert_int_equal(info.part_count, parts);
    dm_context_destroy(context);
    cJSON_Delete(json);
    free(bytes);
}

/* A cupboard whose walls, door and knob are nodes of their own: x, y, z of two corners. */
static const struct {
    const char* name;
    float low[3], high[3];
} pieces[] = {
    {"side", {-0.4f, 0, -0.25f}, {-0.38f, 0.8f, 0.23f}},       {"side2", {0.38f, 0, -0.25f}, {0.4f, 0.8f, 0.23f}},
    {"floor", {-0.38f, 0, -0.25f}, {0.38f, 0.02f, 0.23f}},     {"roof", {-0.38f, 0.78f, -0.25f}, {0.38f, 0.8f, 0.23f}},
    {"back", {-0.38f, 0.02f, -0.25f}, {0.38f, 0.78f, -0.23f}}, {"door", {-0.4f, 0, 0.232f}, {0.4f, 0.8f, 0.25f}},
    {"knob", {0.32f, 0.36f, 0.25f}, {0.35f, 0.44f, 0.28f}}};

enum { PIECES = sizeof pieces / sizeof *pieces };

static void write_cupboard(const char* path) {
    static test_shape shapes[PIECES];
    dm_gltf_part parts[PIECES];
    void* data;
    size_t size;
    for (int i = 0; i < PIECES; i++) {
        shapes[i].vertex_count = shapes[i].face_count = 0;
        test_shape_box(&shapes[i], pieces[i].low, pieces[i].high, 0);
        parts[i] = (dm_gltf_part){.name = pieces[i].name,
                                  .positions = shapes[i].xyz[0],
                                  .indices = shapes[i].corners[0],
                                  .vertex_count = shapes[i].vertex_count,
                                  .index_count = 3 * (uint64_t)shapes[i].face_count,
                                  .colour = {1, 1, 1, 1}};
    }
    assert_int_equal(dm_gltf_write(parts, PIECES, NULL, NULL, &data, &size), DM_OK);
    tool_write(path, data, size);
    free(data);
}

/* The door and its knob are one part, the walls are none. */
static void test_prepare_takes_whole_assets(void** state) {
    (void)state;
    char glb[TOOL_PATH + 32], dmo[TOOL_PATH + 32];
    path_in_folder(glb, "cupboard.glb");
    path_in_folder(dmo, "cupboard.dmo");
    write_cupboard(glb);
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|sdk/models|-o|%s|--json", glb, dmo);
    if (out.status != 0) fail_msg("%s", out.errors);
    cJSON* json = tool_json(&out);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(json, "parts")), 1);
    const cJSON* door = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "parts"), 0);
    const cJSON* numbers = cJSON_GetObjectItem(door, "node_indices");
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(door, "name")), "door");
    assert_int_equal(cJSON_GetObjectItem(door, "id")->valueint, 1);
    assert_int_equal(cJSON_GetArraySize(numbers), 2);
    assert_int_equal(cJSON_GetArrayItem(numbers, 0)->valueint, PIECES - 2);
    assert_int_equal(cJSON_GetArrayItem(numbers, 1)->valueint, PIECES - 1);
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(door, "type")), "revolute");
    cJSON_Delete(json);
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|sdk/models|--min-moves|1|-o|%s", glb, dmo);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "DM_ERROR_EMPTY_MASK"));
}

static void test_eval(void** state) {
    (void)state;
    char folder[TOOL_PATH];
    tool_folder_make(folder);
    tool_run(&out, "dragmesh_generate", NULL, "--category|door|--seed|1|-o|%s/simulation__a", folder);
    assert_int_equal(out.status, 0);
    tool_run(&out, "dragmesh_generate", NULL, "--category|drawers|--seed|2|-o|%s/flightgear__b", folder);
    assert_int_equal(out.status, 0);
    static const char* const conditions[] = {"", "|--no-drag", "|--drag-noise|7|--turn|5", "|--mask-noise|0.1",
                                             "|--given-type"};
    for (int i = 0; i < 5; i++) {
        tool_run(&out, "dragmesh", NULL, "eval|%s|--models|none|--json%s", folder, conditions[i]);
        cJSON* json = tool_json(&out);
        const int joints = cJSON_GetObjectItem(json, "joints")->valueint;
        assert_true(joints >= 2);
        assert_int_equal(cJSON_GetObjectItem(json, "answered")->valueint, joints);
        assert_int_equal(cJSON_IsNull(cJSON_GetObjectItem(json, "sign_acc")), i == 1);
        if (i == 4) assert_true(cJSON_GetObjectItem(json, "type_acc")->valuedouble == 1);
        const cJSON* by_source = cJSON_GetObjectItem(json, "by_source");
        assert_non_null(cJSON_GetObjectItem(by_source, "flightgear"));
        assert_non_null(cJSON_GetObjectItem(by_source, "simulation"));
        assert_non_null(cJSON_GetObjectItem(cJSON_GetObjectItem(json, "by_category"), "door"));
        cJSON_Delete(json);
    }
    tool_folder_remove(folder);
}

/* Shifted and turned objects are the same objects: the score must not depend on where they stand. */
static void test_eval_does_not_depend_on_the_frame(void** state) {
    (void)state;
    char folder[TOOL_PATH];
    double pose[2];
    tool_folder_make(folder);
    tool_run(&out, "dragmesh_generate", NULL, "--category|drawers|--seed|2|-o|%s/b", folder);
    for (int turned = 0; turned < 2; turned++) {
        tool_run(&out, "dragmesh", NULL, "eval|%s|--json|--given-type%s", folder, turned ? "|--turn|3" : "");
        cJSON* json = tool_json(&out);
        pose[turned] = cJSON_GetObjectItem(cJSON_GetObjectItem(json, "pose_e3"), "mean")->valuedouble;
        cJSON_Delete(json);
    }
    assert_true(fabs(pose[0] - pose[1]) < 5);
    tool_folder_remove(folder);
}

static void test_bench(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "bench|--models|none|--json");
    cJSON* json = tool_json(&out);
    assert_non_null(cJSON_GetObjectItem(json, "isa"));
    const cJSON* row;
    int seen = 0;
    cJSON_ArrayForEach(row, cJSON_GetObjectItem(json, "rows")) {
        const char* name = cJSON_GetObjectItem(row, "name")->valuestring;
        assert_true(cJSON_GetObjectItem(row, "median_ns")->valuedouble >= 0);
        assert_true(cJSON_GetObjectItem(row, "p99_ns")->valuedouble >=
                    cJSON_GetObjectItem(row, "median_ns")->valuedouble);
        if (strcmp(name, "scene_pick") == 0 || strcmp(name, "drag_update") == 0 || strcmp(name, "scene_move") == 0) {
            assert_int_equal(cJSON_GetObjectItem(row, "allocs")->valueint, 0);
            seen++;
        }
    }
    assert_int_equal(seen, 3);
    cJSON_Delete(json);
}

static void test_demo(void** state) {
    (void)state;
    char path[TOOL_PATH + 32];
    size_t size;
    tool_run(&out, "dragmesh", NULL, "demo|%s|--models|none|-o|%s/demo", door.folder, door.folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    assert_non_null(strstr(out.text, "picked pixel"));
    assert_non_null(strstr(out.text, "found "));
    assert_non_null(strstr(out.text, "true "));
    path_in_folder(path, "demo.png");
    free(tool_read(path, &size));
    path_in_folder(path, "demo.glb");
    free(tool_read(path, &size));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_animate),
        cmocka_unit_test(test_film),
        cmocka_unit_test(test_pick),
        cmocka_unit_test(test_prepare),
        cmocka_unit_test(test_prepare_takes_whole_assets),
        cmocka_unit_test(test_eval),
        cmocka_unit_test(test_eval_does_not_depend_on_the_frame),
        cmocka_unit_test(test_bench),
        cmocka_unit_test(test_demo),
    };
    return cmocka_run_group_tests_name("cli_outputs", tests, set_up, tear_down);
}
