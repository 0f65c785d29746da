/* dragmesh rig: one file, and a folder of them with one that can't be read; what is left behind and what is said. */
#include <math.h>
#include <stdbool.h>

#include "test_tool.h"

static tool_output out;
static char folder[TOOL_PATH];

enum { PATH = TOOL_PATH + 64 };

static void in_folder(char path[PATH], const char* name) {
    snprintf(path, PATH, "%s/%s", folder, name);
}

static bool exists(const char* name) {
    char path[PATH];
    in_folder(path, name);
    return access(path, F_OK) == 0;
}

static cJSON* read_answer(const char* name) {
    char path[PATH];
    size_t size;
    in_folder(path, name);
    char* text = tool_read(path, &size);
    cJSON* json = cJSON_ParseWithLength(text, size);
    assert_non_null(json);
    free(text);
    return json;
}

static void assert_same_bytes(const char* a, const char* b) {
    char paths[2][PATH];
    size_t sizes[2];
    in_folder(paths[0], a);
    in_folder(paths[1], b);
    char *first = tool_read(paths[0], &sizes[0]), *second = tool_read(paths[1], &sizes[1]);
    assert_int_equal(sizes[0], sizes[1]);
    assert_memory_equal(first, second, sizes[0]);
    free(first);
    free(second);
}

/* The part that has a node of this name; NULL: none has. */
static const cJSON* part_with(const cJSON* rig, const char* name) {
    const cJSON *part, *node;
    cJSON_ArrayForEach(part, cJSON_GetObjectItem(rig, "parts")) {
        cJSON_ArrayForEach(node, cJSON_GetObjectItem(part, "nodes")) {
            if (strcmp(cJSON_GetStringValue(node), name) == 0) return part;
        }
    }
    return NULL;
}

static void test_one_file(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "rig|samples/cabinet.glb|--models|sdk/models|--min-moves|0.01|-o|%s/one", folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    assert_non_null(strstr(out.text, "parts move"));
    assert_true(exists("one/rigged.glb") && exists("one/film.png"));
    cJSON* rig = read_answer("one/rig.json");
    const cJSON* door = part_with(rig, "door_left");
    assert_non_null(door);
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(door, "type")), "revolute");
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(door, "basis")), "inferred");
    assert_int_equal(cJSON_GetObjectItem(door, "parent")->valueint, -1);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(door, "axis")), 3);
    assert_true(cJSON_GetObjectItem(door, "moves")->valuedouble > 0);
    cJSON_Delete(rig);
}

/* What was written says itself how it moves. */
static void test_the_scene_states_its_joints(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "rig|%s/one/rigged.glb|--models|none|-o|%s/again.json", folder, folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    cJSON *before = read_answer("one/rig.json"), *after = read_answer("again.json");
    const cJSON *old = part_with(before, "door_left"), *part, *new = NULL;
    cJSON_ArrayForEach(part, cJSON_GetObjectItem(after, "parts")) {
        const char* name = cJSON_GetStringValue(cJSON_GetArrayItem(cJSON_GetObjectItem(part, "nodes"), 0));
        if (strstr(name, "door_left") != NULL) new = part;
    }
    assert_non_null(new);
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(new, "type")), "revolute");
    assert_string_not_equal(cJSON_GetStringValue(cJSON_GetObjectItem(new, "basis")), "inferred");
    const double upper = cJSON_GetObjectItem(old, "upper")->valuedouble;
    assert_true(fabs(cJSON_GetObjectItem(new, "upper")->valuedouble - upper) < 1e-4 * upper);
    cJSON_Delete(before);
    cJSON_Delete(after);
}

/* Returns the document of a .glb in the folder. To be deleted. */
static cJSON* read_document(const char* name) {
    enum { HEADER = 20 }; /* bytes before the document's text; four before its kind stands its length */
    char path[PATH];
    size_t size;
    uint32_t length;
    in_folder(path, name);
    char* bytes = tool_read(path, &size);
    assert_true(size > HEADER);
    memcpy(&length, bytes + HEADER - 8, sizeof length);
    cJSON* document = cJSON_ParseWithLength(bytes + HEADER, length);
    assert_non_null(document);
    free(bytes);
    return document;
}

static const cJSON* node_named(const cJSON* document, const char* name, int* out_index) {
    const cJSON* node;
    *out_index = 0;
    cJSON_ArrayForEach(node, cJSON_GetObjectItem(document, "nodes")) {
        const char* own = cJSON_GetStringValue(cJSON_GetObjectItem(node, "name"));
        if (own != NULL && strcmp(own, name) == 0) return node;
        ++*out_index;
    }
    return NULL;
}

/* Whether an animation moves a node that carries `target`, or `target` itself. */
static bool moves(const cJSON* document, const cJSON* animation, int target) {
    const cJSON *channel, *child, *nodes = cJSON_GetObjectItem(document, "nodes");
    for (bool found = true; found;) {
        cJSON_ArrayForEach(channel, cJSON_GetObjectItem(animation, "channels")) {
            if (cJSON_GetObjectItem(cJSON_GetObjectItem(channel, "target"), "node")->valueint == target) return true;
        }
        found = false;
        for (int i = 0; i < cJSON_GetArraySize(nodes) && !found; i++)
            cJSON_ArrayForEach(child, cJSON_GetObjectItem(cJSON_GetArrayItem(nodes, i), "children")) {
                if (child->valueint != target) continue;
                target = i, found = true;
                break;
            }
    }
    return false;
}

/* A door that the file's own clip opens is left to that clip; its node says how it moves. */
static void test_a_clip_of_the_file_stays_its_own(void** state) {
    (void)state;
    int door;
    tool_run(&out, "dragmesh", NULL,
             "animate|samples/cabinet.glb|--moving|door_left|--models|sdk/models|-o|%s/clip.glb", folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    tool_run(&out, "dragmesh", NULL, "rig|%s/clip.glb|--models|sdk/models|--min-moves|0.01|-o|%s/clip", folder, folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    cJSON *rig = read_answer("clip/rig.json"), *document = read_document("clip/rigged.glb");
    const cJSON *part = part_with(rig, "door_left"), *animations = cJSON_GetObjectItem(document, "animations"), *clip;
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(part, "basis")), "clip");
    assert_non_null(node_named(document, "door_left", &door));
    assert_int_equal(cJSON_GetArraySize(animations), 2);
    int movers = 0;
    cJSON_ArrayForEach(clip, animations) movers += moves(document, clip, door);
    assert_int_equal(movers, 1);
    const cJSON* node = node_named(document, "dragmesh_part", &door); /* that the clip moves */
    const cJSON* joint = cJSON_GetObjectItem(cJSON_GetObjectItem(node, "extras"), "dragmesh");
    assert_string_equal(cJSON_GetStringValue(cJSON_GetObjectItem(joint, "type")), "revolute");
    cJSON_Delete(rig);
    cJSON_Delete(document);
}

static void copy_cabinet(const char* name) {
    char path[PATH];
    size_t size;
    char* bytes = tool_read("samples/cabinet.glb", &size);
    in_folder(path, name);
    tool_write(path, bytes, size);
    free(bytes);
}

/* Writes the cabinet as a file in which z is up: all of it turned by a quarter about x. */
static void write_turned_cabinet(const char* name) {
    enum { HEADER = 20, LENGTH_AT = 12 };
    char path[PATH];
    size_t size;
    uint32_t length;
    copy_cabinet(name);
    cJSON *document = read_document(name), *nodes = cJSON_GetObjectItem(document, "nodes");
    cJSON* scene = cJSON_GetArrayItem(cJSON_GetObjectItem(document, "scenes"), 0);
    cJSON *top = cJSON_CreateObject(), *over = cJSON_CreateArray();
    cJSON_AddItemToObject(top, "children", cJSON_DetachItemFromObject(scene, "nodes"));
    cJSON_AddItemToObject(top, "rotation", cJSON_CreateDoubleArray((const double[]){M_SQRT1_2, 0, 0, M_SQRT1_2}, 4));
    cJSON_AddItemToArray(over, cJSON_CreateNumber(cJSON_GetArraySize(nodes)));
    cJSON_AddItemToObject(scene, "nodes", over);
    cJSON_AddItemToArray(nodes, top);
    char* text = cJSON_PrintUnformatted(document);
    cJSON_Delete(document);
    in_folder(path, name);
    char* old = tool_read(path, &size);
    memcpy(&length, old + LENGTH_AT, sizeof length);
    const size_t rest = size - HEADER - length, used = strlen(text), padded = (used + 3) / 4 * 4;
    char* bytes = malloc(HEADER + padded + rest);
    memcpy(bytes, old, HEADER);
    memcpy(bytes + HEADER, text, used);
    memset(bytes + HEADER + used, ' ', padded - used);
    memcpy(bytes + HEADER + padded, old + HEADER + length, rest);
    memcpy(bytes + LENGTH_AT, &(uint32_t){(uint32_t)padded}, sizeof length);
    memcpy(bytes + 8, &(uint32_t){(uint32_t)(HEADER + padded + rest)}, sizeof length);
    tool_write(path, bytes, HEADER + padded + rest);
    free(bytes);
    free(old);
    free(text);
}

enum { CABINET_PARTS = 4 };

/* Writes how sure a run is of each of the cabinet's joints. */
static void rig_cabinet(const char* file, const char* up, const char* name, double confidence[CABINET_PARTS]) {
    tool_run(&out, "dragmesh", NULL, "rig|%s|--up|%s|--models|sdk/models|-o|%s/%s", file, up, folder, name);
    if (out.status != 0) fail_msg("%s", out.errors);
    cJSON* rig = read_answer(name);
    const cJSON* parts = cJSON_GetObjectItem(rig, "parts");
    assert_int_equal(cJSON_GetArraySize(parts), CABINET_PARTS);
    for (int i = 0; i < CABINET_PARTS; i++)
        confidence[i] = cJSON_GetObjectItem(cJSON_GetArrayItem(parts, i), "confidence")->valuedouble;
    cJSON_Delete(rig);
}

/* Which way is up is evidence of joints: who says so gets other confidences than who leaves it as glTF has it. */
static void test_up_is_evidence(void** state) {
    (void)state;
    char path[PATH];
    double told[CABINET_PARTS], untold[CABINET_PARTS], most = 0;
    write_turned_cabinet("turned.glb");
    in_folder(path, "turned.glb");
    rig_cabinet(path, "z", "told.json", told);
    rig_cabinet(path, "y", "untold.json", untold);
    for (int i = 0; i < CABINET_PARTS; i++) most = fmax(most, fabs(told[i] - untold[i]));
    assert_true(most > 1e-3);
}

/* A file that can't be read is named, and so is one whose worker leaves nothing; the others are rigged, once. */
static void test_a_folder(void** state) {
    (void)state;
    char path[PATH];
    in_folder(path, "in");
    assert_int_equal(mkdir(path, 0777), 0);
    in_folder(path, "in/deep");
    assert_int_equal(mkdir(path, 0777), 0);
    copy_cabinet("in/a.glb");
    copy_cabinet("in/lost.glb");
    copy_cabinet("in/deep/object.glb");
    in_folder(path, "in/broken.glb");
    tool_write(path, "glTF?", 5);
    in_folder(path, "out");
    assert_int_equal(mkdir(path, 0777), 0);
    in_folder(path, "out/lost"); /* no folder can be made there */
    tool_write(path, "", 0);
    tool_run(&out, "dragmesh", NULL, "rig|%s/in|--models|none|-j|2|-o|%s/out", folder, folder);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.text, "broken: failed: DM_ERROR_BAD_DATA"));
    assert_non_null(strstr(out.text, "lost: failed: its worker broke"));
    assert_non_null(strstr(out.text, "4 assets: 2 rigged, 0 done already, 2 failed"));
    assert_true(exists("out/a/rig.json") && exists("out/deep/rig.json") && !exists("out/broken/rig.json"));
    assert_false(exists("out/a/status.txt"));
    assert_same_bytes("out/a/rig.json", "out/deep/rig.json");
    tool_run(&out, "dragmesh", NULL, "rig|%s/in|--models|none|-o|%s/out", folder, folder);
    assert_non_null(strstr(out.text, "a: done already"));
    assert_non_null(strstr(out.text, "4 assets: 0 rigged, 2 done already, 2 failed"));
    tool_run(&out, "dragmesh", NULL, "rig|%s/in|--models|none|--names|off|-o|%s/out|--json", folder, folder);
    assert_non_null(strstr(out.text, "\"asset\":\"broken\",\"error\":\"DM_ERROR_BAD_DATA"));
    cJSON* rig = read_answer("out/a/rig.json");
    assert_non_null(strstr(cJSON_GetStringValue(cJSON_GetObjectItem(rig, "options")), "names off"));
    cJSON_Delete(rig);
}

/* The same answers by one worker and by several. */
static void test_workers_change_nothing(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "rig|%s/in|--models|none|-o|%s/serial", folder, folder);
    tool_run(&out, "dragmesh", NULL, "rig|%s/in|--models|none|-o|%s/parallel|-j|3", folder, folder);
    assert_same_bytes("serial/a/rig.json", "parallel/a/rig.json");
    assert_same_bytes("serial/a/rigged.glb", "parallel/a/rigged.glb");
    assert_same_bytes("serial/a/film.png", "parallel/a/film.png");
}

/* Formats go into a folder and from a file whose names are no names of formats; a run for others does the asset again.
 */
static void test_formats(void** state) {
    (void)state;
    copy_cabinet("a \"b\" & <c>'.glb");
    tool_run(&out, "dragmesh", NULL,
             "rig|%s/a \"b\" & <c>'.glb|--models|none|--min-moves|0.001|--formats|urdf,tscn|-o|%s/o ü;$(x)", folder,
             folder);
    if (out.status != 0) fail_msg("%s", out.errors);
    assert_true(exists("o ü;$(x)/rigged.urdf") && exists("o ü;$(x)/rigged.tscn") && exists("o ü;$(x)/film.png"));
    assert_true(exists("o ü;$(x)/meshes/mesh_1_body.obj"));
    assert_false(exists("o ü;$(x)/rigged.glb") || exists("o ü;$(x)/rigged.sdf"));
    char path[PATH];
    size_t size;
    in_folder(path, "o ü;$(x)/rigged.urdf");
    char* urdf = tool_read(path, &size);
    assert_non_null(strstr(urdf, "<robot name=\"asset_a_b_c\">"));
    free(urdf);
    tool_run(&out, "dragmesh", NULL, "rig|%s/in/deep|--models|none|-o|%s/twice", folder, folder);
    assert_non_null(strstr(out.text, "1 assets: 1 rigged"));
    assert_false(exists("twice/object/rigged.xml"));
    tool_run(&out, "dragmesh", NULL, "rig|%s/in/deep|--models|none|--formats|mjcf|-o|%s/twice", folder, folder);
    assert_non_null(strstr(out.text, "1 assets: 1 rigged"));
    assert_true(exists("twice/object/rigged.xml"));
    static const char* const wrong[] = {"stl", "urdf,stl", ","};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        tool_run(&out, "dragmesh", NULL, "rig|samples/cabinet.glb|--formats|%s|-o|%s/wrong", wrong[i], folder);
        assert_int_equal(out.status, 2);
        assert_non_null(strstr(out.errors, "--formats: '"));
        assert_false(exists("wrong"));
    }
}

/* The naive hand on an asset whose left door and body are known. */
static void test_first_touch(void** state) {
    (void)state;
    static const char known[] =
        "{\"id\":\"cabinet\",\"up\":\"y\",\"nodes\":{\"body\":\"static\",\"door_left\":\"mover\"},\"parts\":[{"
        "\"nodes\":"
        "[\"door_left\"],\"parent\":null,\"type\":\"revolute\",\"axis\":[0,-1,0],\"origin\":[-0.407,0.384,0.281],"
        "\"lower\":0,\"upper\":1.8}]}";
    char path[PATH];
    in_folder(path, "bot");
    assert_int_equal(mkdir(path, 0777), 0);
    in_folder(path, "bot/cabinet");
    assert_int_equal(mkdir(path, 0777), 0);
    copy_cabinet("bot/cabinet/object.glb");
    in_folder(path, "bot/cabinet/asset.json");
    tool_write(path, known, sizeof known - 1);
    tool_run(&out, "dragmesh", NULL, "dragbot|%s/bot|--rig|--cameras|1|--models|sdk/models|--json", folder);
    cJSON* score = tool_json(&out);
    assert_int_equal(cJSON_GetObjectItem(score, "parts")->valueint, 1);
    assert_int_equal(cJSON_GetObjectItem(score, "static_nodes")->valueint, 1);
    assert_true(cJSON_GetObjectItem(score, "follow")->valuedouble == 1);
    assert_true(cJSON_GetObjectItem(score, "right")->valuedouble > 0.5);
    assert_true(cJSON_GetObjectItem(score, "stay")->valuedouble == 1);
    cJSON_Delete(score);
}

static void test_bad_arguments(void** state) {
    (void)state;
    static const char* const lines[] = {"rig|samples/cabinet.glb",
                                        "rig|-o|/tmp/x.json",
                                        "rig|samples/cabinet.glb|-o|/tmp/x.json|--min-moves|2",
                                        "rig|samples/cabinet.glb|-o|/tmp/x.json|--up|w",
                                        "rig|samples/cabinet.glb|-o|/tmp/x.json|-j|0",
                                        "rig|samples|-o|/tmp/x.json"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        tool_run(&out, "dragmesh", NULL, "%s", lines[i]);
        if (out.status != 2) fail_msg("%s: exit status %d", lines[i], out.status);
    }
    tool_run(&out, "dragmesh", NULL, "rig|%s|-o|%s/none", "samples/11_web", folder);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "no asset"));
}

static int make_folder(void** state) {
    (void)state;
    tool_folder_make(folder);
    return 0;
}

static int remove_folder(void** state) {
    (void)state;
    tool_folder_remove(folder);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_file),
        cmocka_unit_test(test_the_scene_states_its_joints),
        cmocka_unit_test(test_a_clip_of_the_file_stays_its_own),
        cmocka_unit_test(test_up_is_evidence),
        cmocka_unit_test(test_a_folder),
        cmocka_unit_test(test_workers_change_nothing),
        cmocka_unit_test(test_formats),
        cmocka_unit_test(test_first_touch),
        cmocka_unit_test(test_bad_arguments),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
