/* The tool on a prop in all the ways in which props are shipped: finds the door's hinge, and animates it with nothing
 * lost. `test_gltf_shipped_props --keep FOLDER` leaves the files there, as for gltf-validator. */
#include <math.h>

#include "dragmesh/ext/gltf.h"
#include "test_tool.h"

#include "test_prop.h"

#define SLACK 0.016 /* metres: 2 % of the prop's height */

enum { FACES = 3 * TEST_PROP_CORNERS / 3 };

static char folder[TOOL_PATH];

/* Ways in which the handle goes where the door goes. */
static int is_carried(int way) {
    return way == TEST_PROP_SKIN || way == TEST_PROP_CHILD || way == TEST_PROP_DRACO || way == TEST_PROP_PRIMITIVES;
}

/* Writes the file, and the one beside it. */
static void write_prop(const test_prop* prop, int way, char out_path[TOOL_PATH]) {
    char path[TOOL_PATH + 32];
    const int is_text = prop->data[0] == '{';
    snprintf(out_path, TOOL_PATH, "%.400s/way%d.%s", folder, way, is_text ? "gltf" : "glb");
    tool_write(out_path, prop->data, prop->size);
    if (prop->beside == NULL) return;
    snprintf(path, sizeof path, "%s/parts", folder);
    mkdir(path, 0700);
    snprintf(path, sizeof path, "%s/parts/the cabinet.bin", folder);
    tool_write(path, prop->beside, prop->beside_size);
}

/* Where a point of the prop, in metres, is in the scene. */
static void place(const test_prop* prop, int way, const double metres[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = metres[k] / prop->unit + (way == TEST_PROP_FAR ? test_prop_far[k] : 0);
}

static void assert_hinge(const test_prop* prop, int way, const char* line) {
    cJSON* answer = cJSON_Parse(line);
    const cJSON *axis = cJSON_GetObjectItem(answer, "axis"), *origin = cJSON_GetObjectItem(answer, "origin");
    const double hinge[3] = {test_prop_low[TEST_PROP_DOOR][0], 0, test_prop_low[TEST_PROP_DOOR][2]};
    double want[3], at[3];
    if (!axis || !origin) fail_msg("way %d: no joint in %s", way, line);
    place(prop, way, hinge, want);
    for (int k = 0; k < 3; k++) at[k] = cJSON_GetArrayItem(origin, k)->valuedouble - want[k];
    const int is_upright = fabs(cJSON_GetArrayItem(axis, 1)->valuedouble) > 0.999;
    const int is_there = fabs(at[0]) * prop->unit < SLACK && at[2] * prop->unit > -SLACK &&
                         at[2] * prop->unit < 0.018 /* metres, the door's thickness */ + SLACK;
    if (strcmp(cJSON_GetObjectItem(answer, "type")->valuestring, "revolute") != 0 || !is_upright || !is_there)
        fail_msg("way %d: %s", way, line);
    cJSON_Delete(answer);
}

/* Whether the file moves a node, and has as many triangles as the prop. */
static void assert_animated(int way, const char* path) {
    size_t size;
    char* data = tool_read(path, &size);
    char* text = test_glb_json(data);
    cJSON* json = cJSON_Parse(text);
    const cJSON* animation = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "animations"), 0);
    if (cJSON_GetArraySize(cJSON_GetObjectItem(animation, "channels")) == 0) fail_msg("way %d: nothing moves", way);
    cJSON_Delete(json);
    free(text);
    free(data);
    const dm_gltf_desc desc = {.struct_size = sizeof desc};
    dm_gltf* gltf;
    dm_mesh_desc mesh;
    assert_int_equal(dm_gltf_open_file(path, &desc, &gltf), DM_OK);
    assert_int_equal(dm_gltf_get_mesh(gltf, &mesh), DM_OK);
    assert_int_equal(mesh.index_count, 3 * FACES);
    dm_gltf_close(gltf);
}

static void try_way(int way) {
    static tool_output out;
    const double grabbed[3] = {0.29, 0.28, 0.2};
    double point[3];
    test_prop prop;
    char path[TOOL_PATH];
    if (!test_prop_make(&prop, (test_prop_way)way)) return; /* this build can't write it */
    write_prop(&prop, way, path);
    place(&prop, way, grabbed, point);
    const char* moving = is_carried(way) ? "door" : "door,handle";
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--drag-point|%.17g,%.17g,%.17g|--drag-vector|0,0,%g|--json",
             path, moving, point[0], point[1], point[2], 0.1 / prop.unit);
    if (out.status != 0) fail_msg("way %d: %s", way, out.errors);
    assert_hinge(&prop, way, out.text);
    tool_run(&out, "dragmesh", NULL,
             "animate|%s|--moving|%s|--drag-point|%.17g,%.17g,%.17g|--drag-vector|0,0,%g|-o|%s/way%d.moves.glb", path,
             moving, point[0], point[1], point[2], 0.1 / prop.unit, folder, way);
    if (out.status != 0) fail_msg("way %d: %s", way, out.errors);
    snprintf(path, sizeof path, "%.400s/way%d.moves.glb", folder, way);
    assert_animated(way, path);
    test_prop_free(&prop);
}

static void every_way_opens_at_its_hinge(void** state) {
    (void)state;
    for (int way = 0; way < TEST_PROP_WAYS; way++) try_way(way);
}

int main(int argc, char** argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_way_opens_at_its_hinge)};
    const int is_kept = argc == 3 && strcmp(argv[1], "--keep") == 0;
    if (is_kept) {
        snprintf(folder, sizeof folder, "%.400s", argv[2]);
        mkdir(folder, 0700);
    } else {
        tool_folder_make(folder);
    }
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    if (!is_kept) tool_folder_remove(folder);
    return failed;
}
