/* Fuzz target: lines of jobs for `dragmesh infer --jobs -`, the whole tool in this process. A job can name the files in
 * tests/fuzz/jobs, where it runs, and no others: '/' becomes '_'.
 *
 * Whatever the lines: each answer is one line of JSON in valid UTF-8, there are no more answers than lines, and the
 * exit status says whether one of them is an error. */
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cjson/cJSON.h>

#include "cli.h"
#include "dragmesh/ext/gltf.h"
#include "expect.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
int dragmesh_main(int argc, char** argv); /* the tool's: premake5.lua renames it */

typedef struct text {
    char* bytes;
    size_t size;
} text;

static text make_lines(const uint8_t* data, size_t size) {
    text lines = {malloc(size + 1), size};
    fuzz_expect(lines.bytes != NULL);
    memcpy(lines.bytes, data, size);
    lines.bytes[size] = 0;
    for (size_t i = 0; i < size; i++)
        if (lines.bytes[i] == '/') lines.bytes[i] = '_';
    return lines;
}

/* What the tool writes for these lines on standard input. */
static text run_tool(const text* lines, int* out_status) {
    char* arguments[] = {"dragmesh", "infer", "--jobs", "-", "--models", "none", NULL};
    FILE *const real_input = stdin, *const real_output = stdout;
    text answers = {NULL, 0};
    stdin = fmemopen(lines->bytes, lines->size, "rb");
    stdout = open_memstream(&answers.bytes, &answers.size);
    fuzz_expect(stdin != NULL && stdout != NULL);
    *out_status = dragmesh_main((int)(sizeof arguments / sizeof *arguments) - 1, arguments);
    fclose(stdin);
    fclose(stdout);
    stdin = real_input, stdout = real_output;
    return answers;
}

/* Returns whether it is an error. */
static bool check_answer(const char* line) {
    char* copy = strdup(line);
    fuzz_expect(copy != NULL);
    dm_gltf_mend_text(copy);
    fuzz_expect(strcmp(copy, line) == 0);
    free(copy);
    cJSON* json = cJSON_ParseWithOpts(line, NULL, 1);
    fuzz_expect(cJSON_IsObject(json) && cJSON_HasObjectItem(json, "id"));
    const bool failed = cJSON_HasObjectItem(json, "error");
    fuzz_expect(failed != cJSON_HasObjectItem(json, "type"));
    cJSON_Delete(json);
    return failed;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static int home = -1;
    if (home < 0) home = open(".", O_RDONLY | O_DIRECTORY);
    if (size == 0) return 0;
    text lines = make_lines(data, size);
    size_t questions = 1, answered = 0;
    for (size_t i = 0; i < size; i++) questions += data[i] == '\n';
    int status;
    bool failed = false;
    fuzz_expect(chdir("tests/fuzz/jobs") == 0);
    text answers = run_tool(&lines, &status);
    fuzz_expect(fchdir(home) == 0); /* the fuzzer's own paths count from there */
    for (char *line = answers.bytes, *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
        *end = 0;
        failed = check_answer(line) || failed;
        answered++;
    }
    fuzz_expect(answered <= questions);
    fuzz_expect(status == (failed ? CLI_FAILED : CLI_OK));
    free(answers.bytes);
    free(lines.bytes);
    return 0;
}
