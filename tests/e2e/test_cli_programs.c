/* The commands of the laboratory, which dragmesh runs by the program dragmesh-evaluate beside it: arguments, streams
 * and exit status pass through, and an error names the program where it is missing. */
#include "test_tool.h"

static tool_output out, direct;

/* Lines that are answered, and lines that are refused. */
static const struct {
    int status;
    const char* line;
} lines[] = {
    {0, "eval|--help"},
    {0, "dragbot|--help"},
    {0, "bench|--help"},
    {2, "eval"},
    {2, "dragbot|--naive|200|x"},
    {2, "bench|--nosuch"},
    {2, "eval|no such \"set"},
    {2, "eval|back\\slash\\|--json"},
    {2, "bench|x|--models|no such folder"},
};

static void test_the_laboratory_answers_by_way_of_the_tool(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        tool_run(&direct, "dragmesh-evaluate", NULL, "%s", lines[i].line);
        tool_run(&out, "dragmesh", NULL, "%s", lines[i].line);
        if (direct.status != lines[i].status || out.status != lines[i].status)
            fail_msg("%s: status %d, by way of dragmesh %d: %s", lines[i].line, direct.status, out.status, out.errors);
        assert_string_equal(out.text, direct.text);
        assert_string_equal(out.errors, direct.errors);
    }
}

static void test_each_program_calls_the_other(void** state) {
    (void)state;
    tool_run(&out, "dragmesh-evaluate", NULL, "nodes|samples/cabinet.glb");
    assert_int_equal(out.status, 0);
    assert_non_null(strstr(out.text, "door_left"));
    tool_run(&out, "dragmesh-evaluate", NULL, "nosuch");
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "no command 'nosuch'"));
}

/* Runs a shell command, in which $F is the folder, and keeps what it writes. */
static void run_in(const char* folder, const char* command) {
    char line[TOOL_LINE + TOOL_PATH], path[TOOL_PATH + 8];
    snprintf(path, sizeof path, "%s/said", folder);
    snprintf(line, sizeof line, "{ F=%s; %s; } > %s 2>&1", folder, command, path);
    const int status = system(line);
    out.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    tool_slurp(path, out.text);
}

static void test_a_missing_program_is_named(void** state) {
    (void)state;
    char folder[TOOL_PATH], tool[TOOL_PATH], line[TOOL_LINE / 2];
    tool_folder_make(folder);
    tool_find("dragmesh", tool);
    snprintf(line, sizeof line, "cp %s $(dirname %s)/libdragmesh*.so.* $F", tool, tool);
    run_in(folder, line);
    assert_int_equal(out.status, 0);
    run_in(folder, "$F/dragmesh eval x");
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.text, "dragmesh eval: can't run dragmesh-evaluate"));
    run_in(folder, "$F/dragmesh --help");
    assert_int_equal(out.status, 0);
    assert_non_null(strstr(out.text, "dragmesh eval DIR"));
    tool_folder_remove(folder);
}

static void test_a_link_to_the_tool_finds_it_too(void** state) {
    (void)state;
    char folder[TOOL_PATH], tool[TOOL_PATH], line[TOOL_LINE / 2];
    tool_folder_make(folder);
    tool_find("dragmesh", tool);
    snprintf(line, sizeof line, "ln -s $(realpath %s) $F/linked", tool);
    run_in(folder, line);
    run_in(folder, "$F/linked eval --help");
    assert_int_equal(out.status, 0);
    assert_non_null(strstr(out.text, "usage: dragmesh eval "));
    tool_folder_remove(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_laboratory_answers_by_way_of_the_tool),
        cmocka_unit_test(test_each_program_calls_the_other),
        cmocka_unit_test(test_a_missing_program_is_named),
        cmocka_unit_test(test_a_link_to_the_tool_finds_it_too),
    };
    return cmocka_run_group_tests_name("cli_programs", tests, NULL, NULL);
}
