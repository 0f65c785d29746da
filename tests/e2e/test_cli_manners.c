/* How the tool speaks: help on every command, "--", suffixes, errors that name a file once, what a file and a prepared
 * object hold, numbers without a minus before zero. */
#include <stdbool.h>

#include "test_door.h"

static const char* const commands[] = {"infer", "animate", "film", "nodes", "pick",   "prepare",
                                       "show",  "eval",    "demo", "bench", "dragbot"};
enum { COMMANDS = sizeof commands / sizeof *commands };

static int count_of(const char* text, const char* word) {
    int count = 0;
    for (const char* at = text; (at = strstr(at, word)) != NULL; at += strlen(word)) count++;
    return count;
}

static void expect(int status, const char* says) {
    if (out.status != status || (!strstr(out.text, says) && !strstr(out.errors, says)))
        fail_msg("%s: status %d, '%.500s', errors '%.500s'", out.line, out.status, out.text, out.errors);
}

static void test_help_on_every_command(void** state) {
    (void)state;
    for (int i = 0; i < COMMANDS; i++) {
        static const char* const forms[] = {"%s|--help", "%s|-h", "help|%s", "%s|x.glb|--json|--help"};
        char usage[64];
        snprintf(usage, sizeof usage, "usage: dragmesh %s ", commands[i]);
        const bool has_json =
            strcmp(commands[i], "animate") != 0 && strcmp(commands[i], "film") != 0 && strcmp(commands[i], "demo") != 0;
        for (int form = 0; form < (has_json ? 4 : 3); form++) {
            tool_run(&out, "dragmesh", NULL, forms[form], commands[i]);
            expect(0, usage);
            assert_string_equal(out.errors, "");
            if (strstr(out.text, "[--type TYPE]"))
                assert_non_null(strstr(out.text, "TYPE: revolute, prismatic, screw, continuous."));
        }
        tool_run(&out, "dragmesh", NULL, "--help");
        assert_non_null(strstr(out.text, usage + strlen("usage: ")));
    }
    tool_run(&out, "dragmesh", NULL, "-h");
    expect(0, "dragmesh infer ");
    tool_run(&out, "dragmesh", NULL, "help|nosuch");
    expect(2, "no command 'nosuch'");
}

static void test_two_dashes_end_the_options(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "infer|--models|none|--moving|%s|--|%s", door.moving, door.glb);
    expect(0, "% ");
    tool_run(&out, "dragmesh", NULL, "nodes|--|--help");
    expect(1, "'--help'");
    tool_run(&out, "dragmesh", NULL, "nodes|--|-x.glb");
    expect(1, "'-x.glb'");
    tool_run(&out, "dragmesh", NULL, "nodes|%s|--|%s", door.glb, door.glb);
    expect(2, "one argument too many");
}

static void test_an_output_has_the_suffix_of_what_is_written(void** state) {
    (void)state;
    static const struct {
        const char *command, *suffix, *wrong;
    } cases[] = {
        {"animate|%s|--models|none|--moving|%s|-o|%s/x%zu%s", ".glb", ".gltf .png .glb.txt .glbx ."},
        {"film|%s|--models|none|--moving|%s|--frames|2|--size|16,16|-o|%s/x%zu%s", ".png", ".jpg .glb .apng ."},
        {"prepare|%s|--models|none|--moving|%s|-o|%s/x%zu%s", ".dmo", ".glb .dmo.bytes .json ."},
        {"infer|%s|--models|none|--moving|%s|--mask-out|%s/x%zu%s", ".json", ".npy .txt ."}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char wrong[64];
        snprintf(wrong, sizeof wrong, "%s", cases[i].wrong);
        for (char *rest = wrong, *suffix; (suffix = strtok_r(rest, " ", &rest)) != NULL;) {
            char path[TOOL_PATH + 32];
            tool_run(&out, "dragmesh", NULL, cases[i].command, door.glb, door.moving, door.folder, i, suffix);
            expect(2, "has another suffix");
            expect(2, cases[i].suffix);
            snprintf(path, sizeof path, "%s/x%zu%s", door.folder, i, suffix);
            assert_int_equal(access(path, F_OK), -1);
        }
        for (int upper = 0; upper < 2; upper++) {
            char suffix[16];
            snprintf(suffix, sizeof suffix, "%s", cases[i].suffix);
            for (char* c = suffix; upper && *c; c++) *c = (char)(*c >= 'a' && *c <= 'z' ? *c - 32 : *c);
            tool_run(&out, "dragmesh", NULL, cases[i].command, door.glb, door.moving, door.folder, i, suffix);
            expect(0, "");
        }
    }
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|none|-o|/dev/null", door.glb);
    expect(0, "");
}

static void test_errors_name_a_file_once(void** state) {
    (void)state;
    static const char* const reading[] = {"infer|%s|--models|none|--moving|x",
                                          "animate|%s|--models|none|--moving|x|-o|x.glb",
                                          "film|%s|--models|none|--moving|x|-o|x.png",
                                          "prepare|%s|--models|none|-o|x.dmo",
                                          "pick|%s|--ray|0,0,0,0,0,1",
                                          "nodes|%s",
                                          "show|%s",
                                          "infer|--jobs|%s|--models|none"};
    char missing[TOOL_PATH + 16], text[TOOL_PATH + 16];
    snprintf(missing, sizeof missing, "%s/nosuch.glb", door.folder);
    snprintf(text, sizeof text, "%s/text.glb", door.folder);
    tool_write(text, "This is none.", 13);
    const struct {
        const char *path, *says;
    } files[] = {{missing, "No such file or directory"}, {door.folder, "Is a directory"}, {text, ""}};
    for (size_t i = 0; i < sizeof reading / sizeof *reading; i++) {
        for (int k = 0; k < 3; k++) {
            const bool jobs = strstr(reading[i], "--jobs") != NULL;
            if (jobs && k == 2) continue; /* lines that are no jobs are answered */
            tool_run(&out, "dragmesh", NULL, reading[i], files[k].path);
            expect(jobs ? 2 : 1, files[k].says);
            if (count_of(out.errors, files[k].path) != 1)
                fail_msg("%s: the file stands %d times in '%s'", out.line, count_of(out.errors, files[k].path),
                         out.errors);
        }
    }
    tool_run(&out, "dragmesh", NULL, "infer|%s|--models|none|--mask|%s", door.glb, door.folder);
    expect(1, "Is a directory");
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|none|-o|%s", door.glb, door.folder);
    expect(1, "Is a directory");
}

static const cJSON* item_of(const cJSON* list, const char* name, const char* value) {
    const cJSON* item;
    cJSON_ArrayForEach(item, list) {
        const cJSON* found = cJSON_GetObjectItem(item, name);
        if (cJSON_IsString(found) && strcmp(found->valuestring, value) == 0) return item;
    }
    return NULL;
}

static void test_nodes(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "nodes|%s|--json", door.glb);
    cJSON* json = tool_json(&out);
    const cJSON* list = cJSON_GetObjectItem(json, "nodes");
    const cJSON* part = item_of(list, "name", door.moving);
    assert_non_null(part);
    assert_non_null(strstr(cJSON_GetObjectItem(part, "label")->valuestring, door.moving));
    double triangles = 0;
    int largest = 0;
    const cJSON* item;
    cJSON_ArrayForEach(item, list) {
        triangles += cJSON_GetObjectItem(item, "triangles")->valuedouble;
        largest += cJSON_IsTrue(cJSON_GetObjectItem(item, "largest"));
        for (int i = 0; i < 3; i++)
            assert_true(cJSON_GetArrayItem(cJSON_GetObjectItem(item, "size"), i)->valuedouble > 0);
    }
    assert_true(triangles == cJSON_GetObjectItem(json, "triangles")->valuedouble);
    assert_int_equal(largest, 1);
    /* The number that stands there is a name that --moving takes. */
    tool_run(&out, "dragmesh", NULL, "infer|%s|--models|none|--moving|#%d", door.glb,
             cJSON_GetObjectItem(part, "node")->valueint);
    expect(0, "% ");
    tool_run(&out, "dragmesh", NULL, "nodes|%s", door.glb);
    cJSON_ArrayForEach(item, list) expect(0, cJSON_GetObjectItem(item, "name")->valuestring);
    cJSON_Delete(json);
}

static void test_show(void** state) {
    (void)state;
    char path[TOOL_PATH + 16];
    snprintf(path, sizeof path, "%s/shown.dmo", door.folder);
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|none|-o|%s|--json", door.glb, path);
    cJSON* prepared = tool_json(&out);
    tool_run(&out, "dragmesh", NULL, "show|%s|--json", path);
    cJSON* shown = tool_json(&out);
    assert_int_equal(cJSON_GetObjectItem(shown, "bytes")->valueint, cJSON_GetObjectItem(prepared, "bytes")->valueint);
    const cJSON *before = cJSON_GetObjectItem(prepared, "parts"), *after = cJSON_GetObjectItem(shown, "parts");
    assert_int_equal(cJSON_GetArraySize(before), cJSON_GetArraySize(after));
    for (int i = 0; i < cJSON_GetArraySize(before); i++) {
        static const char* const same[] = {"id", "parent", "type", "confidence", "axis", "origin", "lower", "upper"};
        for (size_t k = 0; k < sizeof same / sizeof *same; k++)
            if (!cJSON_Compare(cJSON_GetObjectItem(cJSON_GetArrayItem(before, i), same[k]),
                               cJSON_GetObjectItem(cJSON_GetArrayItem(after, i), same[k]), 1))
                fail_msg("part %d: %s", i, same[k]);
        assert_true(cJSON_GetArraySize(cJSON_GetObjectItem(cJSON_GetArrayItem(after, i), "hypotheses")) > 0);
    }
    cJSON_Delete(prepared);
    cJSON_Delete(shown);
    tool_run(&out, "dragmesh", NULL, "show|%s", path);
    expect(0, "largest side");
    tool_run(&out, "dragmesh", NULL, "show|%s", door.glb);
    expect(1, "not a .dmo file");
}

/* The percentages are explained where they stand, and are the number that JSON calls the confidence. */
static void test_one_confidence(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "infer|%s|--models|none|--moving|%s|--json", door.glb, door.moving);
    cJSON* json = tool_json(&out);
    char percent[16];
    snprintf(percent, sizeof percent, " %3.0f %% ", 100 * cJSON_GetObjectItem(json, "confidence")->valuedouble);
    cJSON_Delete(json);
    static const char* const texts[] = {"infer|%s|--models|none|--moving|%s",
                                        "prepare|%s|--models|none|--moving|%s|-o|/dev/null",
                                        "animate|%s|--models|none|--moving|%s|-o|/dev/null"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        tool_run(&out, "dragmesh", NULL, texts[i], door.glb, door.moving);
        expect(0, percent);
        expect(0, "%: how probable it is that type, axis and origin are all right");
    }
}

static void test_no_minus_before_zero(void** state) {
    (void)state;
    char path[TOOL_PATH + 16];
    snprintf(path, sizeof path, "%s/zero.dmo", door.folder);
    tool_run(&out, "dragmesh", NULL, "prepare|%s|--models|none|-o|%s", door.glb, path);
    assert_int_equal(count_of(out.text, "-0.0000"), 0);
    static const char* const texts[] = {"show|%s", "infer|%s|--models|none|--moving|%s"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        tool_run(&out, "dragmesh", NULL, texts[i], i == 0 ? path : door.glb, door.moving);
        expect(0, "0.0000");
        assert_int_equal(count_of(out.text, "-0.0000"), 0);
    }
    tool_run(&out, "dragmesh", NULL, "pick|%s|--ray|-0,1,5,-0,0,-1", door.glb);
    assert_int_equal(count_of(out.text, "(-0,") + count_of(out.text, " -0,"), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_help_on_every_command),
        cmocka_unit_test(test_two_dashes_end_the_options),
        cmocka_unit_test(test_an_output_has_the_suffix_of_what_is_written),
        cmocka_unit_test(test_errors_name_a_file_once),
        cmocka_unit_test(test_nodes),
        cmocka_unit_test(test_show),
        cmocka_unit_test(test_one_confidence),
        cmocka_unit_test(test_no_minus_before_zero),
    };
    return cmocka_run_group_tests_name("cli_manners", tests, set_up, tear_down);
}
