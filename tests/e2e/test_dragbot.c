/* The scripted player's hands and views (dragmesh dragbot) on a generated cabinet: every option runs, has its figures,
 * and with the true joint handed in the part does what was meant. */
#include <math.h>

#include "test_glb.h"
#include "test_tool.h"

static tool_output out;
static char folder[TOOL_PATH];

static int make_cabinet(void** state) {
    (void)state;
    tool_folder_make(folder);
    tool_run(&out, "dragmesh_generate", NULL, "--category|kitchen_cabinet|--seed|7|-o|%s/cabinet", folder);
    return out.status;
}

static int remove_cabinet(void** state) {
    (void)state;
    tool_folder_remove(folder);
    return 0;
}

/* ---- figures ---- */

static cJSON* play(const char* more) {
    tool_run(&out, "dragmesh", NULL, "dragbot|%s|--models|none|--cameras|2|--json%s", folder, more);
    cJSON* json = tool_json(&out);
    assert_non_null(json);
    return json;
}

/* A figure in [low, high]. */
static void assert_figure(const cJSON* json, const char* name, double low, double high) {
    const cJSON* figure = cJSON_GetObjectItem(json, name);
    if (figure == NULL) fail_msg("there is no %s", name);
    if (!cJSON_IsNumber(figure)) fail_msg("%s is no number", name);
    if (figure->valuedouble < low || figure->valuedouble > high)
        fail_msg("%s is %g, not in [%g, %g]", name, figure->valuedouble, low, high);
}

static void assert_shares(const cJSON* json) {
    static const char* const shares[] = {
        "success", "success_or_beyond", "success_given_joint", "success_or_beyond_given_joint",
        "stuck",   "stuck_given_joint", "through_body",        "through_body_given_joint"};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++) assert_figure(json, shares[i], 0, 1);
}

/* Plays with options; with the true joint the share of successes must be `least` or more, and no drag may be stuck or
 * go through the body. */
static cJSON* play_well(const char* more, double least) {
    cJSON* json = play(more);
    assert_figure(json, "cases", 4, 100);
    assert_shares(json);
    assert_shares(cJSON_GetObjectItem(json, "turning"));
    assert_figure(json, "success_given_joint", least, 1);
    assert_figure(json, "stuck_given_joint", 0, 0);
    assert_figure(json, "through_body_given_joint", 0, 0);
    return json;
}

static int number_of(const cJSON* json, const char* name) {
    return cJSON_GetObjectItem(json, name)->valueint;
}

/* ---- far objects ---- */

static const double away[3] = {4e6, 0, -3e6}; /* m */

static void move_list(cJSON* list) {
    for (int i = 0; i < 3; i++) {
        cJSON* number = cJSON_GetArrayItem(list, i);
        cJSON_SetNumberValue(number, number->valuedouble + away[i]);
    }
}

static char* read_text(const char* name) {
    char path[TOOL_PATH + 32];
    size_t size;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return tool_read(path, &size);
}

static void write_file(const char* name, const void* data, size_t size) {
    char path[TOOL_PATH + 32];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    tool_write(path, data, size);
}

/* Writes the cabinet's joints with all places moved. */
static void write_far_joints(void) {
    char* text = read_text("cabinet/joints.json");
    cJSON *json = cJSON_Parse(text), *joint, *drag;
    cJSON_ArrayForEach(joint, cJSON_GetObjectItem(json, "joints")) {
        move_list(cJSON_GetObjectItem(joint, "origin"));
        cJSON_ArrayForEach(drag, cJSON_GetObjectItem(joint, "drags")) move_list(cJSON_GetObjectItem(drag, "point"));
    }
    char* far = cJSON_PrintUnformatted(json);
    write_file("cabinet/joints.json", far, strlen(far));
    free(far);
    free(text);
    cJSON_Delete(json);
}

/* Writes the cabinet's file with its nodes below one that stands far away. */
static void write_far_nodes(void) {
    char *glb = read_text("cabinet/object.glb"), *text = test_glb_json(glb);
    uint32_t bin_size;
    const uint8_t* bin = test_glb_bin(glb, &bin_size);
    cJSON *json = cJSON_Parse(text), *nodes = cJSON_GetObjectItem(json, "nodes"), *root = cJSON_CreateObject();
    cJSON* scene = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "scenes"), 0);
    const int index = cJSON_GetArraySize(nodes);
    cJSON_AddItemToObject(root, "children", cJSON_DetachItemFromObject(scene, "nodes"));
    cJSON_AddItemToObject(root, "translation", cJSON_CreateDoubleArray(away, 3));
    cJSON_AddItemToArray(nodes, root);
    cJSON_AddItemToObject(scene, "nodes", cJSON_CreateIntArray(&index, 1));
    char* far = cJSON_PrintUnformatted(json);
    const test_glb made = test_glb_pack(far, bin, bin_size);
    write_file("cabinet/object.glb", made.data, made.size);
    free(made.data);
    free(far);
    cJSON_Delete(json);
    free(text);
    free(glb);
}

static double figure(const cJSON* json, const char* name) {
    return cJSON_GetObjectItem(json, name)->valuedouble;
}

/* Thousands of kilometres from the origin, where a float has steps of 0.25 m, an object is played with and scored as
 * near it. */
static void test_far_objects_are_played_as_near_ones(void** state) {
    (void)state;
    cJSON* near = play_well("", 0.98);
    tool_run(&out, "dragmesh", NULL, "eval|%s|--models|none|--json", folder);
    cJSON* near_scores = tool_json(&out);
    write_far_joints();
    write_far_nodes();
    cJSON* far = play_well("", 0.98);
    assert_int_equal(number_of(far, "cases"), number_of(near, "cases"));
    assert_true(fabs(figure(far, "success") - figure(near, "success")) < 1e-9);
    tool_run(&out, "dragmesh", NULL, "eval|%s|--models|none|--json", folder);
    cJSON* far_scores = tool_json(&out);
    static const char* const scores[] = {"type_acc", "pose_under_2pct", "axis_within_45mrad", "sign_acc"};
    for (size_t i = 0; i < sizeof scores / sizeof *scores; i++)
        assert_true(figure(far_scores, scores[i]) == figure(near_scores, scores[i]));
    const double line_off = figure(cJSON_GetObjectItem(near_scores, "axis_line_e3"), "mean");
    assert_true(fabs(figure(cJSON_GetObjectItem(far_scores, "axis_line_e3"), "mean") - line_off) < 0.01 * line_off);
    cJSON* all[] = {near, far, near_scores, far_scores};
    for (int i = 0; i < 4; i++) cJSON_Delete(all[i]);
}

/* ---- hands ---- */

static void test_plain(void** state) {
    (void)state;
    cJSON* json = play_well("", 0.98);
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(json, "regrab_jump")));
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(json, "offset_still_moved")));
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(json, "own_way")));
    cJSON_Delete(json);
}

static void test_jostle(void** state) {
    (void)state;
    static const char* const jostles[] = {"|--jostle|8", "|--jostle|16"};
    for (int i = 0; i < 2; i++) {
        cJSON* json = play_well(jostles[i], 0.98);
        assert_figure(json, "stuck", 0, 0); /* nor with the joint found */
        cJSON_Delete(json);
    }
}

static void test_offset(void** state) {
    (void)state;
    cJSON* json = play("|--offset|15");
    assert_shares(json);
    assert_figure(json, "offset_still_moved", 0, 1);
    assert_figure(json, "offset_still_moved_given_joint", 0, 1);
    cJSON_Delete(json);
}

static void test_pause_and_regrab(void** state) {
    (void)state;
    cJSON_Delete(play_well("|--pause", 0.98));
    cJSON* json = play_well("|--regrab|3", 0.98);
    assert_figure(json, "regrab_jump", 0, INFINITY);
    assert_figure(json, "regrab_jump_given_joint", 0, 0.01);
    assert_figure(json, "regrab_jumped", 0, 1);
    assert_figure(json, "regrab_jumped_given_joint", 0, 0);
    cJSON_Delete(json);
}

/* A hand in space, and a gamepad's axis: with the true joint both come to what they ask for. */
static void test_point_and_scalar(void** state) {
    (void)state;
    static const char* const hands[] = {"|--point", "|--scalar", "|--point|--hz|30", "|--scalar|--hitch"};
    for (int i = 0; i < 4; i++) cJSON_Delete(play_well(hands[i], 0.95));
}

static void test_axis(void** state) {
    (void)state;
    cJSON* json = play("|--axis");
    assert_shares(json);
    assert_figure(json, "through_body_given_joint", 0, 0);
    cJSON_Delete(json);
}

/* Every phase of a hand takes as many updates more. */
static void test_combined(void** state) {
    (void)state;
    cJSON* plain = play("|--given-joint");
    cJSON* json = play("|--given-joint|--straight|--jostle|4|--pause|--regrab|2|--wander|0.01");
    const int cases = number_of(plain, "cases");
    assert_int_equal(number_of(json, "cases"), cases);
    assert_int_equal(number_of(json, "updates") - number_of(plain, "updates"), cases * (6 + 45 + 2 * 12));
    cJSON_Delete(plain);
    cJSON_Delete(json);
}

static void test_rates(void** state) {
    (void)state;
    cJSON* plain = play_well("", 0.98);
    cJSON* slow = play_well("|--hz|30", 0.98);
    cJSON* fast = play_well("|--hz|144", 0.98);
    cJSON* hitch = play_well("|--hitch", 0.98);
    const int updates = number_of(plain, "updates");
    assert_true(abs(2 * number_of(slow, "updates") - updates) < updates / 20);
    assert_true(abs(number_of(fast, "updates") - updates * 12 / 5) < updates / 20);
    assert_int_equal(updates - number_of(hitch, "updates"), 14 * 2 * number_of(plain, "cases"));
    cJSON_Delete(plain);
    cJSON_Delete(slow);
    cJSON_Delete(fast);
    cJSON_Delete(hitch);
}

/* ---- a world that moves ---- */

/* The part stays under the pointer while the camera, or the object in the world, moves: with the true joint every pull
 * succeeds, and with the joint found as many as in a world at rest, but one. */
static void test_moving_world(void** state) {
    (void)state;
    static const char* const moving[] = {"|--moving-camera", "|--moving-instance"};
    cJSON* plain = play("");
    const double found = cJSON_GetObjectItem(plain, "success_or_beyond")->valuedouble;
    for (int i = 0; i < 2; i++) {
        cJSON* json = play_well(moving[i], 0.98);
        assert_int_equal(number_of(json, "cases"), number_of(plain, "cases"));
        assert_figure(json, "success_or_beyond", found - 1.01 / number_of(plain, "cases"), 1);
        cJSON_Delete(json);
    }
    cJSON_Delete(plain);
}

/* ---- views ---- */

static void test_views(void** state) {
    (void)state;
    cJSON_Delete(play_well("|--view|above", 0.9));
    cJSON* json = play("|--view|behind");
    assert_figure(json, "cases", 0, 100);
    cJSON_Delete(json);
}

static void test_end_on(void** state) {
    (void)state;
    cJSON* json = play("|--view|end-on");
    assert_true(number_of(json, "cases") > 0);
    assert_int_equal(number_of(json, "cases") % 4, 0); /* up, down, left and right */
    assert_shares(json);
    assert_figure(json, "own_way", 0, 1);
    assert_figure(json, "own_way_given_joint", 1, 1);
    assert_figure(json, "through_body_given_joint", 0, 0);
    cJSON_Delete(json);
}

/* ---- output ---- */

static void assert_pose_line(const cJSON* line) {
    const cJSON *pose = cJSON_GetObjectItem(line, "pose"), *joint = cJSON_GetObjectItem(line, "joint");
    assert_true(cJSON_IsString(cJSON_GetObjectItem(line, "id")));
    assert_true(cJSON_IsBool(cJSON_GetObjectItem(line, "given")));
    assert_true(cJSON_IsNumber(cJSON_GetObjectItem(line, "frame")));
    assert_true(cJSON_IsNumber(cJSON_GetObjectItem(line, "value")));
    assert_int_equal(cJSON_GetArraySize(pose), 8);
    double norm = 0;
    for (int i = 0; i < 4; i++) norm += pow(cJSON_GetArrayItem(pose, i)->valuedouble, 2);
    assert_true(fabs(norm - 1) < 1e-5);
    assert_true(cJSON_IsNumber(cJSON_GetObjectItem(joint, "type")));
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(joint, "axis")), 3);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(joint, "origin")), 3);
    const cJSON* ray = cJSON_GetObjectItem(line, "ray");
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(ray, "origin")), 3);
    assert_int_equal(cJSON_GetArraySize(cJSON_GetObjectItem(ray, "direction")), 3);
}

/* A line of JSON for every update. */
static void test_poses(void** state) {
    (void)state;
    char path[TOOL_PATH + 32], more[TOOL_PATH + 64];
    size_t size;
    int lines = 0;
    snprintf(path, sizeof path, "%s/poses.jsonl", folder);
    snprintf(more, sizeof more, "|--poses|%s", path);
    cJSON* json = play(more);
    char* text = tool_read(path, &size);
    for (char* line = strtok(text, "\n"); line != NULL; line = strtok(NULL, "\n"), lines++) {
        cJSON* parsed = cJSON_Parse(line);
        assert_non_null(parsed);
        assert_pose_line(parsed);
        cJSON_Delete(parsed);
    }
    assert_int_equal(lines, number_of(json, "updates"));
    free(text);
    cJSON_Delete(json);
}

static void test_table(void** state) {
    (void)state;
    static const char* const hands[] = {"arc",           "straight",        "unsteady",       "jostle 8",   "jostle 16",
                                        "regrab 3",      "offset 15",       "pause",          "axis",       "above",
                                        "behind",        "end-on",          "30 Hz",          "144 Hz",     "hitch",
                                        "moving camera", "moving instance", "point",          "scalar",     "naive",
                                        "naive snapped", "naive up",        "naive regrab 3", "naive point"};
    enum { HANDS = sizeof hands / sizeof *hands };
    cJSON* rows = play("|--all");
    assert_int_equal(cJSON_GetArraySize(rows), HANDS);
    for (int i = 0; i < HANDS; i++)
        assert_string_equal(cJSON_GetObjectItem(cJSON_GetArrayItem(rows, i), "hand")->valuestring, hands[i]);
    cJSON* alone = play("|--jostle|8");
    const cJSON* row = cJSON_GetArrayItem(rows, 3);
    assert_int_equal(number_of(row, "cases"), number_of(alone, "cases"));
    assert_int_equal(number_of(row, "joint_changes"), number_of(alone, "joint_changes"));
    cJSON_Delete(rows);
    cJSON_Delete(alone);
    tool_run(&out, "dragmesh", NULL, "dragbot|%s|--models|none|--cameras|1|--all", folder);
    assert_int_equal(out.status, 0);
    for (int i = 0; i < HANDS; i++) assert_non_null(strstr(out.text, hands[i]));
}

static void test_refusals(void** state) {
    (void)state;
    static const char* const refused[] = {"--straight|--axis",
                                          "--jostle|-1",
                                          "--offset|-1",
                                          "--regrab|-1",
                                          "--regrab|1000",
                                          "--hz|50",
                                          "--view|left",
                                          "--view|end-on|--straight",
                                          "--view|end-on|--moving-camera",
                                          "--view|end-on|--moving-instance",
                                          "--moving-camera|--moving-instance",
                                          "--point|--scalar",
                                          "--point|--tremor|2",
                                          "--scalar|--view|end-on",
                                          "--all|--point",
                                          "--all|--jostle|8",
                                          "--all|--poses|/dev/null",
                                          "--cameras|0"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        tool_run(&out, "dragmesh", NULL, "dragbot|%s|--models|none|%s", folder, refused[i]);
        if (out.status != 2) fail_msg("%s is not refused", refused[i]);
        assert_non_null(strstr(out.errors, "usage: dragmesh dragbot"));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_plain),
        cmocka_unit_test(test_jostle),
        cmocka_unit_test(test_offset),
        cmocka_unit_test(test_pause_and_regrab),
        cmocka_unit_test(test_axis),
        cmocka_unit_test(test_combined),
        cmocka_unit_test(test_rates),
        cmocka_unit_test(test_views),
        cmocka_unit_test(test_moving_world),
        cmocka_unit_test(test_end_on),
        cmocka_unit_test(test_poses),
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_point_and_scalar),
        cmocka_unit_test(test_far_objects_are_played_as_near_ones) /* last: it moves the cabinet */,
    };
    return cmocka_run_group_tests_name("dragbot", tests, make_cabinet, remove_cabinet);
}
