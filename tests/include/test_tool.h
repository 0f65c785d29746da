/* Runs the built programs as a user does: arguments in, output and exit status back. Programs are looked for in the
 * folder above the test's own (build/<config>). */
#ifndef DM_TEST_TOOL_H
#define DM_TEST_TOOL_H

#include <fcntl.h>
#include <setjmp.h>
#include <spawn.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include <cjson/cJSON.h>

extern char** environ;

enum { TOOL_ARGUMENTS = 32, TOOL_TEXT = 1 << 18, TOOL_LINE = 8192, TOOL_PATH = 512 };

typedef struct tool_output {
    char line[TOOL_LINE]; /* the arguments, as tool_run was given them */
    int status;           /* exit status; -1 when a signal ended it */
    char text[TOOL_TEXT];
    char errors[TOOL_TEXT];
} tool_output;

/* A folder of the test's own, removed by tool_folder_remove. */
static inline void tool_folder_make(char out_path[TOOL_PATH]) {
    snprintf(out_path, TOOL_PATH, "/tmp/dragmesh_test_XXXXXX");
    assert_non_null(mkdtemp(out_path));
}

static inline void tool_folder_remove(const char* path) {
    char command[TOOL_PATH + 16];
    snprintf(command, sizeof command, "rm -rf '%s'", path);
    assert_int_equal(system(command), 0);
}

static inline char* tool_read(const char* path, size_t* out_size) {
    FILE* file = fopen(path, "rb");
    if (!file) fail_msg("there is no %s", path);
    fseek(file, 0, SEEK_END);
    *out_size = (size_t)ftell(file);
    rewind(file);
    char* bytes = calloc(1, *out_size + 1);
    assert_int_equal(fread(bytes, 1, *out_size, file), *out_size);
    fclose(file);
    return bytes;
}

static inline void tool_write(const char* path, const void* data, size_t size) {
    FILE* file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    fclose(file);
}

/* The command that runs the tool of another machine (tests/cross/run.sh); NULL: this one's is tested. */
static inline const char* tool_elsewhere(const char* name) {
    return strcmp(name, "dragmesh") == 0 ? getenv("DM_TEST_TOOL") : NULL;
}

/* build/<config>/name, or that command. */
static inline void tool_find(const char* name, char out_path[TOOL_PATH]) {
    char own[TOOL_PATH];
    if (tool_elsewhere(name)) {
        assert_true(snprintf(out_path, TOOL_PATH, "%s", tool_elsewhere(name)) < TOOL_PATH);
        return;
    }
    const ssize_t length = readlink("/proc/self/exe", own, sizeof own - 1);
    assert_true(length > 0);
    own[length] = 0;
    *strrchr(own, '/') = 0;
    assert_true(snprintf(out_path, TOOL_PATH, "%s/../%s", own, name) < TOOL_PATH);
}

static inline void tool_slurp(const char* path, char out_text[TOOL_TEXT]) {
    size_t size;
    char* bytes = tool_read(path, &size);
    assert_true(size < TOOL_TEXT);
    memcpy(out_text, bytes, size + 1);
    free(bytes);
}

/* Runs build/<config>/`name`; `input` (may be NULL) is its standard input. Arguments are split at '|'. The test fails
 * when the program is not there or takes more than ten minutes. */
static inline void tool_run(tool_output* output, const char* name, const char* input, const char* format, ...) {
    char folder[TOOL_PATH], program[TOOL_PATH], in[TOOL_PATH + 8], out[TOOL_PATH + 8], err[TOOL_PATH + 8];
    char line[TOOL_LINE];
    char* arguments[TOOL_ARGUMENTS + 5] = {"timeout", "--foreground", "600"};
    int count = 3;
    va_list list;
    va_start(list, format);
    vsnprintf(output->line, sizeof output->line, format, list);
    va_end(list);
    memcpy(line, output->line, sizeof line);
    tool_find(name, program);
    arguments[count++] = program;
    if (tool_elsewhere(name)) { /* a runner, its arguments, the program */
        strtok(program, " ");
        for (char* next = strtok(NULL, " "); next && count < TOOL_ARGUMENTS; next = strtok(NULL, " "))
            arguments[count++] = next;
    }
    for (char* next = strtok(line, "|"); next && count < TOOL_ARGUMENTS + 4; next = strtok(NULL, "|"))
        arguments[count++] = next;
    tool_folder_make(folder);
    snprintf(in, sizeof in, "%s/in", folder);
    snprintf(out, sizeof out, "%s/out", folder);
    snprintf(err, sizeof err, "%s/err", folder);
    tool_write(in, input ? input : "", input ? strlen(input) : 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, in, O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out, O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err, O_WRONLY | O_CREAT, 0600);
    pid_t child;
    int status;
    if (posix_spawnp(&child, arguments[0], &actions, NULL, arguments, environ) != 0) fail_msg("can't run timeout");
    assert_int_equal(waitpid(child, &status, 0), child);
    posix_spawn_file_actions_destroy(&actions);
    output->status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    tool_slurp(out, output->text);
    tool_slurp(err, output->errors);
    tool_folder_remove(folder);
    if (output->status == 124) fail_msg("%s took more than %s seconds", program, arguments[2]);
    if (output->status >= 125 && output->status <= 127) fail_msg("can't run %s: %s", program, output->errors);
}

/* What the program answered; the test fails, and says how the program ended, where that is no JSON. */
static inline cJSON* tool_json(const tool_output* output) {
    cJSON* json = output->status == 0 ? cJSON_Parse(output->text) : NULL;
    if (json == NULL)
        fail_msg("%s: status %d, errors: '%s', answer: %s", output->line, output->status, output->errors, output->text);
    return json;
}

/* ---- an object to work on, with its truth ---- */

typedef struct tool_object {
    char folder[TOOL_PATH], glb[TOOL_PATH + 16];
    cJSON* json;                         /* joints.json */
    const cJSON* joint;                  /* the first joint */
    const char* moving;                  /* its first node */
    double point[3], vector[3], axis[3]; /* its first drag, its axis */
} tool_object;

static inline void tool_numbers(const cJSON* json, const char* name, double out[3]) {
    const cJSON* list = cJSON_GetObjectItem(json, name);
    assert_int_equal(cJSON_GetArraySize(list), 3);
    for (int i = 0; i < 3; i++) out[i] = cJSON_GetArrayItem(list, i)->valuedouble;
}

/* Made by the built generator. */
static inline void tool_object_make(tool_object* object, const char* category, int seed) {
    static tool_output output;
    size_t size;
    char path[TOOL_PATH + 16];
    tool_folder_make(object->folder);
    tool_run(&output, "dragmesh_generate", NULL, "--category|%s|--seed|%d|-o|%s", category, seed, object->folder);
    if (output.status != 0) fail_msg("dragmesh_generate: %s", output.errors);
    snprintf(object->glb, sizeof object->glb, "%s/object.glb", object->folder);
    snprintf(path, sizeof path, "%s/joints.json", object->folder);
    char* text = tool_read(path, &size);
    object->json = cJSON_Parse(text);
    free(text);
    assert_non_null(object->json);
    object->joint = cJSON_GetArrayItem(cJSON_GetObjectItem(object->json, "joints"), 0);
    object->moving = cJSON_GetArrayItem(cJSON_GetObjectItem(object->joint, "moving_nodes"), 0)->valuestring;
    const cJSON* drag = cJSON_GetArrayItem(cJSON_GetObjectItem(object->joint, "drags"), 0);
    tool_numbers(drag, "point", object->point);
    tool_numbers(drag, "vector", object->vector);
    tool_numbers(object->joint, "axis", object->axis);
}

static inline void tool_object_remove(tool_object* object) {
    cJSON_Delete(object->json);
    tool_folder_remove(object->folder);
}

#endif
