/* `dragmesh infer` as tools outside the repository use it: one job, files of jobs, masks, the order and form of
 * answers. */
#include <math.h>
#include <stdbool.h>

#include "test_door.h"

/* The job of the object's first joint; `extra` are more members, with a comma before them. */
static void write_job(char* job, size_t size, const char* id, const char* extra) {
    snprintf(job, size,
             "{\"id\":\"%s\",\"file\":\"%s\",\"moving\":[\"%s\"],\"drag_point\":[%.9g,%.9g,%.9g],"
             "\"drag_vector\":[%.9g,%.9g,%.9g]%s}\n",
             id, door.glb, door.moving, door.point[0], door.point[1], door.point[2], door.vector[0], door.vector[1],
             door.vector[2], extra);
}

static cJSON* parse_line(const char** text) {
    const char* end;
    cJSON* json = cJSON_ParseWithOpts(*text, &end, 0);
    assert_non_null(json);
    assert_true(*end == '\n');
    *text = end + 1;
    return json;
}

static double number(const cJSON* json, const char* name) {
    const cJSON* item = cJSON_GetObjectItem(json, name);
    assert_true(cJSON_IsNumber(item));
    return item->valuedouble;
}

/* The form of every answer, and that a positive step follows the drag. */
static void assert_answer(const cJSON* json) {
    double axis[3], origin[3], arm[3], step[3];
    const cJSON* error = cJSON_GetObjectItem(json, "error");
    if (error) fail_msg("%s", error->valuestring);
    tool_numbers(json, "axis", axis);
    tool_numbers(json, "origin", origin);
    assert_true(fabs(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] - 1) < 1e-5);
    assert_true(number(json, "type_confidence") >= 0 && number(json, "type_confidence") <= 1);
    assert_true(number(json, "lower") <= number(json, "upper"));
    assert_true(cJSON_GetArraySize(cJSON_GetObjectItem(json, "hypotheses")) >= 1);
    assert_true(number(cJSON_GetObjectItem(json, "ms"), "prepare") > 0);
    for (int i = 0; i < 3; i++) arm[i] = door.point[i] - origin[i];
    for (int i = 0; i < 3; i++) step[i] = axis[(i + 1) % 3] * arm[(i + 2) % 3] - axis[(i + 2) % 3] * arm[(i + 1) % 3];
    const int slides = strcmp(cJSON_GetObjectItem(json, "type")->valuestring, "prismatic") == 0;
    double along = 0;
    for (int i = 0; i < 3; i++) along += (slides ? axis[i] : step[i]) * door.vector[i];
    assert_true(along > 0);
}

static void test_one_job_as_text_and_json(void** state) {
    (void)state;
    const char* arguments = "infer|%s|--models|none|--moving|%s|--drag-point|%.9g,%.9g,%.9g|--drag-vector|"
                            "%.9g,%.9g,%.9g%s";
    for (int json = 0; json < 2; json++) {
        tool_run(&out, "dragmesh", NULL, arguments, door.glb, door.moving, door.point[0], door.point[1], door.point[2],
                 door.vector[0], door.vector[1], door.vector[2], json ? "|--json" : "");
        if (out.status != 0) fail_msg("%s", out.errors);
        const char* text = out.text;
        if (!json) assert_non_null(strstr(text, "axis ("));
        if (!json) continue;
        cJSON* answer = parse_line(&text);
        assert_answer(answer);
        cJSON_Delete(answer);
    }
}

static void test_jobs_answer_in_order(void** state) {
    (void)state;
    static char jobs[8192], path[TOOL_PATH + 16];
    char first[2048], last[2048];
    write_job(first, sizeof first, "first", "");
    write_job(last, sizeof last, "last", ",\"type\":\"prismatic\"");
    snprintf(jobs, sizeof jobs, "%s\n{\"id\":7,\"file\":\"/no/such.glb\",\"moving\":[\"x\"]}\nnot json\n%s", first,
             last);
    snprintf(path, sizeof path, "%s/jobs.jsonl", door.folder);
    tool_write(path, jobs, strlen(jobs));
    tool_run(&out, "dragmesh", NULL, "infer|--models|none|--jobs|%s", path);
    assert_int_equal(out.status, 1);
    const char* text = out.text;
    cJSON* answers[4];
    for (int i = 0; i < 4; i++) answers[i] = parse_line(&text);
    assert_int_equal(*text, 0);
    assert_answer(answers[0]);
    assert_string_equal(cJSON_GetObjectItem(answers[0], "id")->valuestring, "first");
    assert_int_equal(cJSON_GetObjectItem(answers[1], "id")->valueint, 7);
    assert_non_null(strstr(cJSON_GetObjectItem(answers[1], "error")->valuestring, "/no/such.glb"));
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(answers[2], "id")));
    assert_non_null(strstr(cJSON_GetObjectItem(answers[2], "error")->valuestring, "line 4"));
    assert_string_equal(cJSON_GetObjectItem(answers[3], "id")->valuestring, "last");
    assert_string_equal(cJSON_GetObjectItem(answers[3], "type")->valuestring, "prismatic");
    for (int i = 0; i < 4; i++) cJSON_Delete(answers[i]);
}

/* The first answers of jobs on standard input, without times. */
static void answer_jobs(const char* jobs, const char* arguments, cJSON** answers, int count) {
    tool_run(&out, "dragmesh", jobs, "%s", arguments);
    const char* text = out.text;
    for (int i = 0; i < count; i++) {
        answers[i] = parse_line(&text);
        cJSON_DeleteItemFromObject(answers[i], "ms");
    }
}

/* Answers one job with `extra` members by jobs on standard input. */
static cJSON* answer_with(const char* extra) {
    char job[4096];
    cJSON* answer;
    write_job(job, sizeof job, "a", extra);
    answer_jobs(job, "infer|--jobs|-", &answer, 1);
    return answer;
}

static const cJSON* hypothesis_of(const cJSON* answer, int index) {
    return cJSON_GetArrayItem(cJSON_GetObjectItem(answer, "hypotheses"), index);
}

static bool same_member(const cJSON* a, const cJSON* b, const char* name) {
    return cJSON_Compare(cJSON_GetObjectItem(a, name), cJSON_GetObjectItem(b, name), 1);
}

/* The index of the first slide among the hypotheses. */
static int first_slide(const cJSON* answer) {
    int at = 0;
    while (strcmp(cJSON_GetObjectItem(hypothesis_of(answer, at), "type")->valuestring, "prismatic") != 0) at++;
    return at;
}

static void test_a_job_chooses_by_index_and_rule(void** state) {
    (void)state;
    cJSON *plain = answer_with(""), *kept = answer_with(",\"choose\":\"keep\"");
    const int slide = first_slide(plain);
    assert_true(slide > 0);
    assert_true(cJSON_IsNull(cJSON_GetObjectItem(kept, "chosen")));
    assert_true(same_member(plain, kept, "axis") && same_member(plain, kept, "confidence"));
    const cJSON* ends = cJSON_GetObjectItem(hypothesis_of(kept, slide), "ends");
    assert_true(number(cJSON_GetArrayItem(ends, 1), "value") == number(hypothesis_of(kept, slide), "upper"));

    char by_index[64];
    snprintf(by_index, sizeof by_index, ",\"choose\":%d", slide);
    cJSON *index = answer_with(by_index), *rule = answer_with(",\"choose\":{\"type\":\"prismatic\"}");
    assert_true(cJSON_Compare(index, rule, 1));
    assert_int_equal(number(index, "chosen"), slide);
    assert_true(number(index, "confidence") == 1);
    assert_true(same_member(index, hypothesis_of(plain, slide), "axis"));
    assert_true(same_member(index, hypothesis_of(plain, slide), "upper"));

    cJSON* none = answer_with(",\"choose\":{\"type\":\"screw\",\"axis\":[0,1,0],\"opens\":[0,0,1]}");
    assert_true(cJSON_Compare(none, kept, 1)); /* no hypothesis fits */
    cJSON* all[] = {plain, kept, index, rule, none};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) cJSON_Delete(all[i]);
}

/* A rule about the way the part opens: the picked one's end lies there. */
static void test_a_rule_tells_the_way_of_opening(void** state) {
    (void)state;
    char rule[256];
    double rest[3], end[3], along = 0;
    snprintf(rule, sizeof rule, ",\"choose\":{\"opens\":[%.9g,%.9g,%.9g]}", door.vector[0], door.vector[1],
             door.vector[2]);
    cJSON* answer = answer_with(rule);
    const cJSON* ends = cJSON_GetObjectItem(hypothesis_of(answer, (int)number(answer, "chosen")), "ends");
    tool_numbers(cJSON_GetArrayItem(ends, 0), "centre", rest);
    tool_numbers(cJSON_GetArrayItem(ends, 1), "centre", end);
    for (int i = 0; i < 3; i++) along += (end[i] - rest[i]) * door.vector[i];
    assert_true(along > 0);
    cJSON_Delete(answer);
}

static void test_a_choice_that_is_none_is_refused_by_name(void** state) {
    (void)state;
    static const char* const wrong[][2] = {{"99", "desc.choose answered 99 for part 1"},
                                           {"-1", "\"choose\" is no index"},
                                           {"1.5", "\"choose\" is no index"},
                                           {"\"best\"", "\"choose\" is no index"},
                                           {"{}", "neither"},
                                           {"{\"type\":\"hinge\"}", "\"type\" is no joint type"},
                                           {"{\"axis\":[0,0,0]}", "\"axis\" is no direction"},
                                           {"{\"opens\":[0,1]}", "\"opens\" is no direction"}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char extra[128];
        snprintf(extra, sizeof extra, ",\"choose\":%s", wrong[i][0]);
        cJSON* answer = answer_with(extra);
        const char* error = cJSON_GetStringValue(cJSON_GetObjectItem(answer, "error"));
        if (error == NULL || strstr(error, wrong[i][1]) == NULL) fail_msg("%s: %s", wrong[i][0], error ? error : "");
        cJSON_Delete(answer);
    }
    assert_int_equal(out.status, 1);
}

static void test_hints_of_a_job_go_before_those_of_its_file(void** state) {
    (void)state;
    static char jobs[16384];
    char none[2048], told[2048], files[2048];
    cJSON *answers[3], *silent;
    write_job(none, sizeof none, "a", ",\"label\":\"\",\"pivot\":null");
    write_job(told, sizeof told, "a",
              ",\"label\":\"Scene/Drawer\",\"pivot\":[0,0,0],\"pivot_axes\":[1,0,0,0,1,0,0,0,1]");
    write_job(files, sizeof files, "a", "");
    snprintf(jobs, sizeof jobs, "%s%s%s", none, told, files);
    answer_jobs(jobs, "infer|--jobs|-", answers, 3);
    assert_int_equal(out.status, 0);
    assert_false(cJSON_Compare(answers[0], answers[1], 1));
    assert_false(cJSON_Compare(answers[0], answers[2], 1)); /* the node is called a door */
    answer_jobs(told, "infer|--no-hints|--jobs|-", &silent, 1);
    assert_true(cJSON_Compare(answers[0], silent, 1));
    for (int i = 0; i < 3; i++) cJSON_Delete(answers[i]);
    cJSON_Delete(silent);
}

static void test_bad_hints_are_named(void** state) {
    (void)state;
    static const char* const fields[][2] = {{",\"label\":5", "\"label\""},
                                            {",\"pivot\":[1,2]", "\"pivot\""},
                                            {",\"pivot\":[1,2,\"x\"]", "\"pivot\""},
                                            {",\"pivot\":[1,2,3],\"pivot_axes\":[1,0,0]", "\"pivot_axes\""}};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        char job[2048];
        cJSON* answer;
        write_job(job, sizeof job, "a", fields[i][0]);
        answer_jobs(job, "infer|--jobs|-", &answer, 1);
        assert_int_equal(out.status, 1);
        assert_non_null(strstr(cJSON_GetObjectItem(answer, "error")->valuestring, fields[i][1]));
        cJSON_Delete(answer);
    }
}

/* The same part asked about twice, by other words, gets the same answer: what is kept between jobs changes nothing. */
static void test_answers_do_not_depend_on_what_came_before(void** state) {
    (void)state;
    static char jobs[16384];
    char one[2048], two[2048];
    write_job(one, sizeof one, "a", "");
    write_job(two, sizeof two, "b", ",\"type\":\"revolute\"");
    snprintf(jobs, sizeof jobs, "%s%s%s%s", one, one, two, one);
    tool_run(&out, "dragmesh", jobs, "infer|--jobs|-");
    if (out.status != 0) fail_msg("%s%s", out.text, out.errors);
    const char* text = out.text;
    cJSON* answers[4];
    for (int i = 0; i < 4; i++) {
        answers[i] = parse_line(&text);
        assert_answer(answers[i]);
        cJSON_DeleteItemFromObject(answers[i], "ms");
    }
    assert_true(cJSON_Compare(answers[0], answers[1], 1));
    assert_true(cJSON_Compare(answers[0], answers[3], 1));
    for (int i = 0; i < 4; i++) cJSON_Delete(answers[i]);
}

/* Each answer is there before the next job is asked. */
static void test_answers_are_flushed(void** state) {
    (void)state;
    char program[TOOL_PATH], job[2048], line[16384];
    int to[2], from[2];
    tool_find("dragmesh", program);
    write_job(job, sizeof job, "x", "");
    assert_int_equal(pipe(to) | pipe(from), 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(to[0], 0);
        dup2(from[1], 1);
        close(to[1]);
        close(from[0]);
        if (tool_elsewhere("dragmesh"))
            execl("/bin/sh", "sh", "-c", "exec $DM_TEST_TOOL infer --models none --jobs -", (char*)NULL);
        execl(program, program, "infer", "--models", "none", "--jobs", "-", (char*)NULL);
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    FILE* answers = fdopen(from[0], "r");
    for (int i = 0; i < 2; i++) {
        assert_int_equal(write(to[1], job, strlen(job)), strlen(job));
        assert_non_null(fgets(line, sizeof line, answers)); /* would wait for ever */
        assert_non_null(strstr(line, "\"x\""));
    }
    close(to[1]);
    int status;
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
    fclose(answers);
}

/* ---- masks ---- */

/* How many vertices and triangles each node has, from the file itself. */
static void write_masks(const char* by_face, const char* by_vertex, const char* by_value) {
    size_t size;
    char* bytes = tool_read(door.glb, &size);
    uint32_t json_size;
    memcpy(&json_size, bytes + 12, 4);
    char* text = strndup(bytes + 20, json_size);
    cJSON* json = cJSON_Parse(text);
    FILE* files[3] = {fopen(by_face, "w"), fopen(by_vertex, "w"), fopen(by_value, "w")};
    const cJSON* node;
    int first = 1;
    for (int i = 0; i < 3; i++) fputc('[', files[i]);
    cJSON_ArrayForEach(node, cJSON_GetObjectItem(json, "nodes")) {
        const cJSON* meshes = cJSON_GetObjectItem(json, "meshes");
        const cJSON* mesh = cJSON_GetArrayItem(meshes, cJSON_GetObjectItem(node, "mesh")->valueint);
        const cJSON* primitive = cJSON_GetArrayItem(cJSON_GetObjectItem(mesh, "primitives"), 0);
        const cJSON* accessors = cJSON_GetObjectItem(json, "accessors");
        const int positions = cJSON_GetObjectItem(cJSON_GetObjectItem(primitive, "attributes"), "POSITION")->valueint;
        const int indices = cJSON_GetObjectItem(primitive, "indices")->valueint;
        const int counts[2] = {cJSON_GetObjectItem(cJSON_GetArrayItem(accessors, indices), "count")->valueint / 3,
                               cJSON_GetObjectItem(cJSON_GetArrayItem(accessors, positions), "count")->valueint};
        const int moves = strcmp(cJSON_GetObjectItem(node, "name")->valuestring, door.moving) == 0;
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < counts[i > 0]; k++)
                fprintf(files[i], "%s%d", first && k == 0 ? "" : ",", i < 2 ? moves : moves ? 41 : 3);
        first = 0;
    }
    for (int i = 0; i < 3; i++) {
        fputc(']', files[i]);
        fclose(files[i]);
    }
    cJSON_Delete(json);
    free(text);
    free(bytes);
}

static void test_masks_say_what_names_say(void** state) {
    (void)state;
    static char jobs[16384];
    char paths[3][TOOL_PATH + 16], job[2048];
    for (int i = 0; i < 3; i++) snprintf(paths[i], sizeof paths[i], "%s/mask%d.json", door.folder, i);
    write_masks(paths[0], paths[1], paths[2]);
    write_job(jobs, sizeof jobs, "names", ",\"label\":\"\",\"pivot\":null"); /* masks have no names */
    for (int i = 0; i < 3; i++) {
        char extra[TOOL_PATH + 64];
        snprintf(extra, sizeof extra, ",\"mask\":\"%.*s\"%s", TOOL_PATH, paths[i], i == 2 ? ",\"mask_value\":41" : "");
        write_job(job, sizeof job, "mask", extra);
        strcat(jobs, job);
    }
    tool_run(&out, "dragmesh", jobs, "infer|--models|none|--jobs|-");
    if (out.status != 0) fail_msg("%s%s", out.text, out.errors);
    const char* text = out.text;
    cJSON* first = parse_line(&text);
    cJSON_DeleteItemFromObject(first, "ms");
    cJSON_DeleteItemFromObject(first, "id");
    for (int i = 0; i < 3; i++) {
        cJSON* other = parse_line(&text);
        cJSON_DeleteItemFromObject(other, "ms");
        cJSON_DeleteItemFromObject(other, "id");
        assert_true(cJSON_Compare(first, other, 1));
        cJSON_Delete(other);
    }
    cJSON_Delete(first);
}

static void test_noisy_masks_are_still_answered(void** state) {
    (void)state;
    char job[2048];
    write_job(job, sizeof job, "noisy", ",\"mask_noise\":0.1");
    tool_run(&out, "dragmesh", job, "infer|--models|none|--jobs|-");
    if (out.status != 0) fail_msg("%s%s", out.text, out.errors);
    const char* text = out.text;
    cJSON* answer = parse_line(&text);
    assert_answer(answer);
    cJSON_Delete(answer);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_job_as_text_and_json),
        cmocka_unit_test(test_jobs_answer_in_order),
        cmocka_unit_test(test_answers_do_not_depend_on_what_came_before),
        cmocka_unit_test(test_a_job_chooses_by_index_and_rule),
        cmocka_unit_test(test_a_rule_tells_the_way_of_opening),
        cmocka_unit_test(test_a_choice_that_is_none_is_refused_by_name),
        cmocka_unit_test(test_hints_of_a_job_go_before_those_of_its_file),
        cmocka_unit_test(test_bad_hints_are_named),
        cmocka_unit_test(test_answers_are_flushed),
        cmocka_unit_test(test_masks_say_what_names_say),
        cmocka_unit_test(test_noisy_masks_are_still_answered),
    };
    return cmocka_run_group_tests_name("cli_infer", tests, set_up, tear_down);
}
