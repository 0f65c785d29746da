/* Bad input, one of each kind: a named error that says what and where, the right exit status, and the other jobs of the
 * file still answered. */
#include <math.h>
#include <stdbool.h>

#include "dragmesh/ext/gltf.h"
#include "test_tool.h"

static tool_output out;
static tool_object object;
static char jobs[1 << 16];

static int set_up(void** state) {
    (void)state;
    tool_object_make(&object, "cabinet", 5);
    return 0;
}

static int tear_down(void** state) {
    (void)state;
    tool_object_remove(&object);
    return 0;
}

/* ---- corrupted copies ---- */

typedef struct copy {
    char path[TOOL_PATH + 32];
    char* bytes;
    size_t size;
    uint8_t* bin;   /* the binary chunk */
    size_t indices; /* where the first node's indices begin in it */
} copy;

/* A copy of the object's file to be spoiled. The generator writes each node's positions, then its indices. */
static copy copy_of_object(const char* name) {
    copy c;
    uint32_t json_size;
    snprintf(c.path, sizeof c.path, "%s/%s", object.folder, name);
    c.bytes = tool_read(object.glb, &c.size);
    memcpy(&json_size, c.bytes + 12, 4);
    c.bin = (uint8_t*)c.bytes + 20 + json_size + 8;
    char* text = strndup(c.bytes + 20, json_size);
    cJSON* json = cJSON_Parse(text);
    const cJSON* view = cJSON_GetArrayItem(cJSON_GetObjectItem(json, "bufferViews"), 1);
    c.indices = (size_t)cJSON_GetObjectItem(view, "byteOffset")->valuedouble;
    cJSON_Delete(json);
    free(text);
    return c;
}

static void keep(copy* c) {
    tool_write(c->path, c->bytes, c->size);
    free(c->bytes);
}

static void write_not_a_number(const char* name) {
    copy c = copy_of_object(name);
    const float bad = NAN;
    memcpy(c.bin + 5 * 12 + 4, &bad, sizeof bad);
    keep(&c);
}

static void write_index_out_of_range(const char* name) {
    copy c = copy_of_object(name);
    const uint32_t bad = 123456789;
    memcpy(c.bin + c.indices + 7 * sizeof bad, &bad, sizeof bad);
    keep(&c);
}

static void write_truncated(const char* name) {
    copy c = copy_of_object(name);
    c.size = c.size * 2 / 3;
    keep(&c);
}

/* The accessor claims more elements than its view holds; the JSON keeps its length. */
static void write_greedy_accessor(const char* name) {
    copy c = copy_of_object(name);
    char* count = strstr(c.bytes + 20, "\"count\":");
    assert_non_null(count);
    count[strlen("\"count\":")] = '9';
    keep(&c);
}

static void write_text(const char* name, const char* text) {
    char path[TOOL_PATH + 32];
    snprintf(path, sizeof path, "%s/%s", object.folder, name);
    tool_write(path, text, strlen(text));
}

/* ---- jobs ---- */

typedef struct bad_job {
    const char* file;   /* in the object's folder */
    const char* fields; /* of the job, after the file: $ the moving node, @ the folder */
    const char *error, *says;
} bad_job;

static const bad_job bad_jobs[] = {
    {"missing.glb", "\"moving\":[\"$\"]", "DM_ERROR_NOT_FOUND: ", "missing.glb"},
    {"text.glb", "\"moving\":[\"$\"]", "DM_ERROR_BAD_DATA: ", "not a GLB"},
    {"empty.glb", "\"moving\":[\"$\"]", "DM_ERROR_BAD_DATA: ", "is empty"},
    {"truncated.glb", "\"moving\":[\"$\"]", "DM_ERROR_BAD_DATA: ", "truncated"},
    {"greedy.glb", "\"moving\":[\"body\"]", "DM_ERROR_NOT_FOUND: ", "leave buffer view"},
    {"object.glb", "\"moving\":[\"nosuch\"]", "DM_ERROR_NOT_FOUND: ", "'nosuch'"},
    {"object.glb", "\"moving\":[]", "DM_ERROR_EMPTY_MASK: ", "says what moves"},
    {"object.glb", "\"mask\":\"@/zeros.json\"", "DM_ERROR_EMPTY_MASK: ", "mask"},
    {"object.glb", "\"mask\":\"@/ones.json\"", "DM_ERROR_FULL_MASK: ", "mask"},
    {"object.glb", "\"mask\":\"@/short.json\"", "DM_ERROR_INVALID_ARGUMENT: ", "3 values"},
    {"object.glb", "\"mask\":\"@/nomask.json\"", "DM_ERROR_NOT_FOUND: ", "nomask.json"},
    {"object.glb", "\"mask\":\"@/text.glb\"", "DM_ERROR_BAD_DATA: ", "mask"},
    {"object.glb", "\"moving\":[\"$\"],\"drag_point\":[0,0,0],\"drag_vector\":[0,0,0]", "DM_ERROR_ZERO_DRAG: ", "drag"},
    {"object.glb", "\"moving\":[\"$\"],\"drag_point\":[0,90,0],\"drag_vector\":[0,0,1]",
     "DM_ERROR_DRAG_OFF_PART: ", "(0, 90, 0)"},
    {"object.glb", "\"moving\":[\"$\"],\"drag_point\":[0,0,0]", "DM_ERROR_INVALID_ARGUMENT: ", "drag_vector"},
    {"object.glb", "\"moving\":[\"$\"],\"drag_point\":[0,0],\"drag_vector\":[0,0,1]",
     "DM_ERROR_INVALID_ARGUMENT: ", "drag_point"},
    {"object.glb", "\"moving\":[\"$\"],\"type\":\"sideways\"", "DM_ERROR_INVALID_ARGUMENT: ", "sideways"},
    {"object.glb", "\"moving\":7", "DM_ERROR_INVALID_ARGUMENT: ", "moving"},
    {"object.glb", "\"moving\":[\"$\"],\"mask_noise\":2", "DM_ERROR_INVALID_ARGUMENT: ", "mask_noise"},
    {"object.glb", "\"mask\":\"@/ones.json\",\"mask_value\":0.5", "DM_ERROR_INVALID_ARGUMENT: ", "mask_value"},
    {"object.glb", "\"mask\":\"@/ones.json\",\"mask_value\":1e300", "DM_ERROR_INVALID_ARGUMENT: ", "mask_value"},
};
enum { BAD_JOBS = sizeof bad_jobs / sizeof *bad_jobs };

/* The JSON of the object's file. */
static cJSON* object_json(void) {
    size_t size;
    uint32_t json_size;
    char* bytes = tool_read(object.glb, &size);
    memcpy(&json_size, bytes + 12, 4);
    cJSON* json = cJSON_ParseWithLength(bytes + 20, json_size);
    assert_non_null(json);
    free(bytes);
    return json;
}

/* As many zeros as the file has triangles. */
static void write_mask_of(char value, const char* name) {
    cJSON* json = object_json();
    const cJSON* accessor;
    int corners = 0, at = 0;
    cJSON_ArrayForEach(accessor, cJSON_GetObjectItem(json, "accessors")) {
        if (at++ % 2 == 1) corners += cJSON_GetObjectItem(accessor, "count")->valueint;
    }
    cJSON_Delete(json);
    char* text = malloc((size_t)corners + 8);
    size_t length = 0;
    for (int face = 0; face < corners / 3; face++)
        length += (size_t)sprintf(text + length, "%c%c", face ? ',' : '[', value);
    strcpy(text + length, "]");
    write_text(name, text);
    free(text);
}

static void append_fields(char* to, const char* fields) {
    for (to += strlen(to); *fields; fields++) {
        const char* piece = *fields == '$' ? object.moving : *fields == '@' ? object.folder : NULL;
        if (piece)
            to += sprintf(to, "%s", piece);
        else
            *to++ = *fields;
    }
    *to = 0;
}

static void append_job(const char* id, int number, const char* file, const char* fields) {
    sprintf(jobs + strlen(jobs), "{\"id\":\"%s%d\",\"file\":\"%s/%s\",", id, number, object.folder, file);
    append_fields(jobs, fields);
    strcat(jobs, "}\n");
}

static void test_every_bad_job_is_named_and_the_rest_answered(void** state) {
    (void)state;
    write_text("text.glb", "This is no model.\n");
    write_text("empty.glb", "");
    write_text("short.json", "[1, 0, 1]");
    write_mask_of('0', "zeros.json");
    write_mask_of('1', "ones.json");
    write_truncated("truncated.glb");
    write_greedy_accessor("greedy.glb");
    jobs[0] = 0;
    for (int i = 0; i < BAD_JOBS; i++) {
        append_job("bad", i, bad_jobs[i].file, bad_jobs[i].fields);
        if (i % 4 == 0) append_job("good", i, "object.glb", "\"moving\":[\"$\"]");
    }
    tool_run(&out, "dragmesh", jobs, "infer|--models|none|--jobs|-");
    assert_int_equal(out.status, 1);
    char* line = strtok(out.text, "\n");
    for (int i = 0; i < BAD_JOBS; i++, line = strtok(NULL, "\n")) {
        char id[16];
        snprintf(id, sizeof id, "bad%d", i);
        cJSON* answer = cJSON_Parse(line);
        if (answer == NULL) fail_msg("%s is answered by '%s'", id, line != NULL ? line : "nothing");
        assert_string_equal(cJSON_GetObjectItem(answer, "id")->valuestring, id);
        const cJSON* error = cJSON_GetObjectItem(answer, "error");
        if (!error || strncmp(error->valuestring, bad_jobs[i].error, strlen(bad_jobs[i].error)) != 0 ||
            !strstr(error->valuestring, bad_jobs[i].says))
            fail_msg("%s, %s: '%s' does not say '%s … %s'", bad_jobs[i].file, bad_jobs[i].fields,
                     error ? error->valuestring : "no error", bad_jobs[i].error, bad_jobs[i].says);
        cJSON_Delete(answer);
        if (i % 4 != 0) continue;
        line = strtok(NULL, "\n");
        assert_non_null(line);
        assert_null(strstr(line, "\"error\""));
        assert_non_null(strstr(line, "\"good"));
    }
    assert_null(line);
}

/* A vertex that is no number and an index beyond the vertices cost the triangles that have them, and a warning. */
static void test_bad_triangles_cost_themselves_alone(void** state) {
    (void)state;
    write_not_a_number("nan.glb");
    write_index_out_of_range("index.glb");
    jobs[0] = 0;
    append_job("nan", 0, "nan.glb", "\"moving\":[\"$\"]");
    append_job("index", 1, "index.glb", "\"moving\":[\"$\"]");
    tool_run(&out, "dragmesh", jobs, "infer|--models|none|--jobs|-");
    assert_int_equal(out.status, 0);
    char* line = strtok(out.text, "\n");
    for (int i = 0; i < 2; i++, line = strtok(NULL, "\n")) {
        assert_non_null(line);
        assert_null(strstr(line, "\"error\""));
        assert_non_null(strstr(line, "\"warnings\""));
        assert_non_null(strstr(line, i == 0 ? "vertex 5" : "123456789"));
    }
}

/* What names standard input on the command line is an error within a job, and takes none of the lines that follow. */
static void test_a_job_can_not_name_an_input(void** state) {
    (void)state;
    static const char* const inputs[] = {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"};
    enum { INPUTS = sizeof inputs / sizeof *inputs };
    jobs[0] = 0;
    for (int i = 0; i < INPUTS; i++) {
        char fields[64];
        sprintf(jobs + strlen(jobs), "{\"id\":\"bad\",\"file\":\"%s\",\"moving\":[\"door\"]}\n", inputs[i]);
        append_job("good", i, "object.glb", "\"moving\":[\"$\"]");
        snprintf(fields, sizeof fields, "\"mask\":\"%s\"", inputs[i]);
        append_job("bad", i, "object.glb", fields);
    }
    append_job("good", INPUTS, "object.glb", "\"moving\":[\"$\"]");
    tool_run(&out, "dragmesh", jobs, "infer|--models|none|--jobs|-");
    assert_int_equal(out.status, 1);
    int lines = 0, refused = 0;
    for (char* line = strtok(out.text, "\n"); line != NULL; line = strtok(NULL, "\n"), lines++) {
        const bool is_bad = strstr(line, "\"id\":\"bad") != NULL;
        refused +=
            is_bad && strstr(line, "DM_ERROR_INVALID_ARGUMENT: ") && strstr(line, "no file; only the command line");
        if (!is_bad) assert_null(strstr(line, "\"error\""));
    }
    assert_int_equal(lines, 3 * INPUTS + 1);
    assert_int_equal(refused, 2 * INPUTS);
}

static void test_single_job_fails_with_status_1(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "infer|%s|--models|none|--moving|nosuch", object.glb);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "DM_ERROR_NOT_FOUND: no node with triangles is called 'nosuch'"));
    tool_run(&out, "dragmesh", NULL, "infer|%s|--models|none|--moving|nosuch|--json", object.glb);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.text, "\"error\":\"DM_ERROR_NOT_FOUND"));
}

static void test_wrong_weights(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--models|%s", object.glb, object.moving, object.folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "DM_ERROR_NOT_FOUND: "));
    assert_non_null(strstr(out.errors, "kpp_net.safetensors"));
    write_text("kpp_net.safetensors", "not weights at all");
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--models|%s", object.glb, object.moving, object.folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "DM_ERROR_BAD_DATA: "));
    static const char other[] = "{\"__metadata__\":{\"architecture\":\"some-other-net\",\"version\":\"1\"}}";
    char safetensors[8 + sizeof other] = {sizeof other - 1};
    char path[TOOL_PATH + 32];
    memcpy(safetensors + 8, other, sizeof other - 1);
    snprintf(path, sizeof path, "%s/kpp_net.safetensors", object.folder);
    tool_write(path, safetensors, 8 + sizeof other - 1);
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--models|%s", object.glb, object.moving, object.folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "DM_ERROR_WRONG_MODEL: "));
    assert_non_null(strstr(out.errors, object.folder));
}

/* The one bad file of three is named. */
static void test_a_wrong_ranker(void** state) {
    (void)state;
    char path[TOOL_PATH + 32];
    size_t size;
    char* kinematics = tool_read("sdk/models/kpp_net.safetensors", &size);
    snprintf(path, sizeof path, "%s/kpp_net.safetensors", object.folder);
    tool_write(path, kinematics, size);
    snprintf(path, sizeof path, "%s/ranker.safetensors", object.folder);
    tool_write(path, kinematics, size);
    free(kinematics);
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--models|%s", object.glb, object.moving, object.folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "DM_ERROR_WRONG_MODEL: "));
    assert_non_null(strstr(out.errors, "dragmesh-joint-models"));
    assert_non_null(strstr(out.errors, "/ranker.safetensors'"));
    assert_null(strstr(out.errors, "kpp_net.safetensors"));
}

/* Each file of weights missing in turn: one warning that names it, on standard error and in the answer. */
static void test_missing_weights_are_said(void** state) {
    (void)state;
    static const char* const names[] = {"kpp_net.safetensors", "dq_vae.safetensors", "ranker.safetensors"};
    char folder[TOOL_PATH + 32], path[TOOL_PATH + 64];
    snprintf(folder, sizeof folder, "%s/some_weights", object.folder);
    assert_int_equal(mkdir(folder, 0700), 0);
    for (int missing = 0; missing <= 3; missing++) {
        for (int i = 0; i < 3; i++) {
            char from[64];
            size_t size;
            snprintf(from, sizeof from, "sdk/models/%s", names[i]);
            snprintf(path, sizeof path, "%s/%s", folder, names[i]);
            char* bytes = tool_read(from, &size);
            if (i == missing)
                unlink(path);
            else
                tool_write(path, bytes, size);
            free(bytes);
        }
        tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|%s|--models|%s|--json", object.glb, object.moving, folder);
        assert_int_equal(out.status, 0);
        cJSON* answer = cJSON_Parse(out.text);
        const cJSON* warnings = cJSON_GetObjectItem(answer, "warnings");
        const char* newline = strchr(out.errors, '\n');
        assert_int_equal(cJSON_GetArraySize(warnings), missing < 3);
        for (int i = 0; i < 3; i++) {
            const char* said = cJSON_GetStringValue(cJSON_GetArrayItem(warnings, 0));
            assert_int_equal(said != NULL && strstr(said, names[i]) != NULL, i == missing);
            assert_int_equal(strstr(out.errors, names[i]) != NULL, i == missing);
        }
        if (missing < 3) assert_true(newline != NULL && newline[1] == 0); /* one line */
        cJSON_Delete(answer);
    }
}

static void test_unusable_arguments(void** state) {
    (void)state;
    static const char* const arguments[] = {"",
                                            "fly",
                                            "infer",
                                            "infer|a.glb",
                                            "infer|a.glb|--moving",
                                            "infer|a.glb|b.glb|--moving|x",
                                            "infer|a.glb|--moving|x|--drag-point|1,2",
                                            "infer|a.glb|--moving|x|--drag-point|1,2,nan|--drag-vector|1,0,0",
                                            "infer|a.glb|--moving|x|--drag-point|1,2,3",
                                            "infer|a.glb|--moving|x|--type|sideways",
                                            "infer|a.glb|--moving|x|--speed|3",
                                            "infer|--jobs|/no/such/jobs.jsonl",
                                            "infer|a.glb|--moving|x|--jobs|-",
                                            "animate|a.glb|--moving|x",
                                            "animate|a.glb|--moving|x|-o|b.glb|--frames|1",
                                            "film|a.glb|--moving|x|-o|b.png|--size|1,1",
                                            "film|a.glb|--moving|x|-o|b.png|--up|w",
                                            "pick|a.glb",
                                            "pick|a.glb|--ray|1,2,3",
                                            "prepare|a.glb",
                                            "eval",
                                            "eval|/no/such/folder",
                                            "eval|/tmp|--mask-noise|1",
                                            "bench|a.glb",
                                            "demo|/no/such/folder|-o|x"};
    for (size_t i = 0; i < sizeof arguments / sizeof *arguments; i++) {
        tool_run(&out, "dragmesh", NULL, "%s", arguments[i]);
        if (out.status != 2 || out.errors[0] == 0)
            fail_msg("'%s': status %d, '%s'", arguments[i], out.status, out.errors);
    }
}

static void test_results_that_cannot_be_written(void** state) {
    (void)state;
    static const char* const commands[] = {"animate|%s|--models|none|--moving|%s|-o|/no/such/folder/x.glb",
                                           "film|%s|--models|none|--moving|%s|-o|/no/such/folder/x.png|--size|16,16",
                                           "prepare|%s|--models|none|--moving|%s|-o|/no/such/folder/x.dmo"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        tool_run(&out, "dragmesh", NULL, commands[i], object.glb, object.moving);
        assert_int_equal(out.status, 1);
        assert_non_null(strstr(out.errors, "/no/such/folder/x"));
    }
}

/* Runs the tool in a shell with another standard output; its messages come back. */
static int run_with_output(const char* arguments, const char* redirection, char messages[TOOL_TEXT]) {
    char program[TOOL_PATH], errors[TOOL_PATH + 32];
    static char command[4 * TOOL_PATH];
    tool_find("dragmesh", program);
    snprintf(errors, sizeof errors, "%s/errors", object.folder);
    snprintf(command, sizeof command, "%s %s 2> '%s' %s", program, arguments, errors, redirection);
    const int status = system(command);
    tool_slurp(errors, messages);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* An answer that does not arrive is none. */
static void test_standard_output_that_takes_nothing(void** state) {
    (void)state;
    if (tool_elsewhere("dragmesh")) skip(); /* the runner has a standard output of its own */
    char infer[2 * TOOL_PATH];
    snprintf(infer, sizeof infer, "infer '%s' --models none --moving '%s' --json", object.glb, object.moving);
    const char* const commands[] = {infer, "--help", "--version"};
    const char* const outputs[] = {"> /dev/full", ">&-"};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            assert_int_equal(run_with_output(commands[i], outputs[k], out.errors), 1);
            assert_non_null(strstr(out.errors, "the standard output takes no more"));
        }
    }
}

/* What is printed does not land in the file that is written. */
static void test_a_closed_standard_output_is_no_file(void** state) {
    (void)state;
    if (tool_elsewhere("dragmesh")) skip();
    char animate[4 * TOOL_PATH], path[TOOL_PATH + 32];
    snprintf(path, sizeof path, "%s/whole.dmo", object.folder);
    snprintf(animate, sizeof animate, "prepare '%s' --models none --moving '%s' -o '%s'", object.glb, object.moving,
             path);
    assert_int_equal(run_with_output(animate, "> /dev/null", out.errors), 0);
    size_t size, other_size;
    char* whole = tool_read(path, &size);
    assert_int_equal(run_with_output(animate, "<&- >&-", out.errors), 1);
    char* other = tool_read(path, &other_size);
    assert_int_equal(other_size, size);
    assert_memory_equal(other, whole, size);
    free(whole);
    free(other);
}

/* ---- input that never ends ---- */

static void test_pipes_and_devices_are_no_files(void** state) {
    (void)state;
    char fifo[TOOL_PATH + 32];
    snprintf(fifo, sizeof fifo, "%s/fifo", object.folder);
    assert_int_equal(mkfifo(fifo, 0600), 0);
    const char* const endless[] = {"/dev/zero", fifo};
    for (int i = 0; i < 2; i++) {
        const char* path = endless[i];
        tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|x|--models|none", path);
        assert_int_equal(out.status, 1);
        assert_non_null(strstr(out.errors, "it is a pipe or a device, not a file"));
        tool_run(&out, "dragmesh", NULL, "infer|%s|--mask|%s|--models|none", object.glb, path);
        assert_int_equal(out.status, 1);
        assert_non_null(strstr(out.errors, "it is a pipe or a device, not a file"));
        tool_run(&out, "dragmesh", NULL, "infer|--jobs|%s|--models|none", path);
        assert_int_equal(out.status, 2);
        assert_non_null(strstr(out.errors, "it is a pipe or a device, not a file"));
    }
    char folder[TOOL_PATH + 32], weights[TOOL_PATH + 64];
    snprintf(folder, sizeof folder, "%s/endless", object.folder);
    snprintf(weights, sizeof weights, "%s/kpp_net.safetensors", folder);
    assert_int_equal(mkdir(folder, 0700), 0);
    assert_int_equal(symlink("/dev/zero", weights), 0);
    tool_run(&out, "dragmesh", NULL, "infer|%s|--moving|x|--models|%s", object.glb, folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "it is a pipe or a device, not a file"));
}

/* A line longer than any job, and a good job before it. */
static void test_a_line_that_does_not_end(void** state) {
    (void)state;
    enum { LINE = (1 << 24) + 100 };
    jobs[0] = 0;
    append_job("good", 0, "object.glb", "\"moving\":[\"$\"]");
    const size_t length = strlen(jobs);
    char* text = malloc(length + LINE + 1);
    memcpy(text, jobs, length);
    memset(text + length, 'a', LINE);
    text[length + LINE] = 0;
    tool_run(&out, "dragmesh", text, "infer|--models|none|--jobs|-");
    free(text);
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.text, "\"good0\",\"type\""));
    assert_non_null(strstr(out.text, "\"error\":\"DM_ERROR_TOO_LARGE: job line 2 is longer than 16777216 bytes\""));
}

/* ---- text that is none ---- */

/* A zero byte ends a text of C: what stands behind it would go unread, without a word. */
static void test_zero_bytes_in_a_job(void** state) {
    (void)state;
    char path[TOOL_PATH + 32];
    static const char* const ends[] = {"}0garbage", ",\"mask\":\"x\\u0000y\"}", ",\"label\":\"\\\\\\u0000\"}"};
    char text[3 * TOOL_PATH];
    size_t length = 0;
    for (int i = 0; i < 3; i++)
        length += (size_t)sprintf(text + length, "{\"file\":\"%s\",\"moving\":[\"%s\"]%s\n", object.glb, object.moving,
                                  ends[i]);
    *strstr(text, "0garbage") = 0;
    length += (size_t)sprintf(text + length, "{\"file\":\"%s\",\"moving\":[\"%s\"],\"label\":\"\\\\u0000\"}\n",
                              object.glb, object.moving);
    snprintf(path, sizeof path, "%s/zero.jsonl", object.folder);
    tool_write(path, text, length);
    tool_run(&out, "dragmesh", NULL, "infer|--models|none|--jobs|%s", path);
    assert_int_equal(out.status, 1);
    char* line = out.text;
    for (int i = 1; i <= 3; i++, line = strchr(line, '\n') + 1) {
        char error[64];
        snprintf(error, sizeof error, "DM_ERROR_BAD_DATA: job line %d is no JSON", i);
        if (strncmp(line + strlen("{\"id\":null,\"error\":\""), error, strlen(error)) != 0) fail_msg("%s", line);
    }
    assert_null(strstr(line, "error"));
    assert_non_null(strstr(line, "\"type\""));
}

/* Ids, paths and names that are no UTF-8 come back as UTF-8; names that are cut are cut between characters. */
static void test_every_line_is_utf8(void** state) {
    (void)state;
    static const char names[] =
        "\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2"
        "\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2\xE3\x83\x89\xE3\x82\xA2";
    copy c = copy_of_object("names.glb");
    static const char body[] = "\"name\":\"body\"";
    int found = 0;
    for (char* at = c.bytes + 20; (at = memmem(at, (size_t)(c.bytes + c.size - at), body, strlen(body))) != NULL;
         found++)
        memcpy(at + strlen("\"name\":\""), "b\xFF\xE3y", 4);
    assert_true(found > 0);
    keep(&c);
    snprintf(jobs, sizeof jobs,
             "{\"id\":\"\xFF\",\"file\":\"/none\xFF\",\"moving\":[\"door\"]}\n"
             "{\"id\":\"%s\",\"file\":\"%s/names.glb\",\"moving\":[\"\xC3\"]}\n"
             "{\"id\":3,\"file\":\"%s/%s\",\"moving\":[\"%s%s\"]}\n",
             names, object.folder, object.folder, names, names, names);
    append_job("good", 0, "names.glb", "\"moving\":[\"$\"]");
    tool_run(&out, "dragmesh", jobs, "infer|--models|none|--jobs|-");
    assert_int_equal(out.status, 1);
    char* mended = strdup(out.text);
    dm_gltf_mend_text(mended);
    assert_string_equal(mended, out.text);
    free(mended);
    assert_non_null(strstr(out.text, "'b??y'")); /* the list of names that the file has */
    assert_non_null(strstr(out.text, "\"good0\",\"type\""));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_bad_job_is_named_and_the_rest_answered),
        cmocka_unit_test(test_bad_triangles_cost_themselves_alone),
        cmocka_unit_test(test_a_job_can_not_name_an_input),
        cmocka_unit_test(test_single_job_fails_with_status_1),
        cmocka_unit_test(test_wrong_weights),
        cmocka_unit_test(test_a_wrong_ranker),
        cmocka_unit_test(test_missing_weights_are_said),
        cmocka_unit_test(test_unusable_arguments),
        cmocka_unit_test(test_results_that_cannot_be_written),
        cmocka_unit_test(test_standard_output_that_takes_nothing),
        cmocka_unit_test(test_a_closed_standard_output_is_no_file),
        cmocka_unit_test(test_pipes_and_devices_are_no_files),
        cmocka_unit_test(test_a_line_that_does_not_end),
        cmocka_unit_test(test_zero_bytes_in_a_job),
        cmocka_unit_test(test_every_line_is_utf8),
    };
    return cmocka_run_group_tests_name("cli_bad_input", tests, set_up, tear_down);
}
