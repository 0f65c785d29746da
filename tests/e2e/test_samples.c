/* Every sample runs and says what its README promises. The language model of sample 08 is a stub that listens on this
 * machine. Runs from the repository's root. */
#include <arpa/inet.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>

#include "test_tool.h"

static tool_output out;

/* Runs a sample; skips the test when it is not built. */
static void run_sample(const char* name, const char* arguments) {
    char program[128], path[TOOL_PATH];
    snprintf(program, sizeof program, "samples/sample_%s", name);
    tool_find(program, path);
    if (access(path, X_OK) != 0) {
        print_message("skipped: %s is not built, a library is missing (scripts/install viewer)\n", name);
        skip();
    }
    tool_run(&out, program, NULL, "%s", arguments);
}

static void assert_says(const char* words) {
    if (!strstr(out.text, words)) fail_msg("\"%s\" is not in:\n%s%s", words, out.text, out.errors);
}

static void test_hello_drag(void** state) {
    (void)state;
    run_sample("hello_drag", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_says("t 1.00");
}

static void test_dynamic_load(void** state) {
    (void)state;
    char library[TOOL_PATH];
    tool_find("libdragmesh.so", library);
    run_sample("dynamic_load", library);
    assert_int_equal(out.status, 0);
}

static void test_host_memory_and_jobs(void** state) {
    (void)state;
    run_sample("host_memory_and_jobs", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_says("with 1000 bytes left: DM_ERROR_OUT_OF_MEMORY");
    assert_says("tasks on the host's threads");
    assert_says(", 0 allocations");
    assert_says("after dm_context_destroy: 0 bytes");
}

static void test_host_pick(void** state) {
    (void)state;
    run_sample("host_pick", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_says("hits part 2");
}

static void test_prepare_offline(void** state) {
    (void)state;
    char folder[TOOL_PATH], path[TOOL_PATH + 16], arguments[2 * TOOL_PATH];
    tool_folder_make(folder);
    snprintf(path, sizeof path, "%s/cabinet.dmo", folder);
    snprintf(arguments, sizeof arguments, "tests/replay/cabinet_door/object.glb|body|%s", path);
    run_sample("prepare_offline", arguments);
    assert_int_equal(out.status, 0);
    char* parts = strstr(out.text, "  part 1");
    assert_non_null(parts);
    char expected[1024];
    snprintf(expected, sizeof expected, "%.*s", (int)(strstr(parts, path) - parts), parts);
    run_sample("prepare_offline", path);
    assert_int_equal(out.status, 0);
    assert_says(expected); /* the game sees the joints that the build machine found */
    tool_folder_remove(folder);
}

static void test_gpu_skinning(void** state) {
    (void)state;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    skip(); /* the software OpenGL driver leaks, and races on purpose */
#endif
    run_sample("gpu_skinning", "sdk/models");
    if (out.status == 3) {
        print_message("skipped: no OpenGL 3.3 can be made here: %s\n", out.errors);
        skip();
    }
    assert_int_equal(out.status, 0);
    assert_says("vertices in 11 poses");
}

/* Draws an object and prepares it offline, as a level's props are. */
static void make_prop(const char* folder, const char* category) {
    char glb[2 * TOOL_PATH];
    snprintf(glb, sizeof glb, "%s/%s", folder, category);
    tool_run(&out, "dragmesh_generate", NULL, "--category|%s|--seed|1|-o|%s", category, glb);
    assert_int_equal(out.status, 0);
    tool_run(&out, "dragmesh", NULL, "prepare|%s/object.glb|-o|%s.dmo", glb, glb);
    assert_int_equal(out.status, 0);
}

/* The number after some words of the report. */
static unsigned long said_after(const char* words) {
    const char* at = strstr(out.text, words);
    if (at == NULL) fail_msg("\"%s\" is not in:\n%s%s", words, out.text, out.errors);
    return strtoul(at + strlen(words), NULL, 10);
}

/* The lines of the report that hold no time and no memory. */
static void copy_counts(char* to) {
    char* line = strtok(out.text, "\n");
    for (*to = 0; line != NULL; line = strtok(NULL, "\n"))
        if (strncmp(line, "frame: ", 7) != 0 && strncmp(line, "memory: ", 8) != 0) strcat(strcat(to, line), "\n");
}

static void assert_is_png(const char* folder, const char* name) {
    char path[2 * TOOL_PATH];
    size_t size;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    char* png = tool_read(path, &size);
    assert_true(size > 5000 && memcmp(png, "\x89PNG", 4) == 0);
    free(png);
}

/* A short walk, in which each frame waits for the jobs: all counts are the same on every run. */
static void test_many_objects(void** state) {
    (void)state;
    static char first[TOOL_TEXT], second[TOOL_TEXT];
    char folder[TOOL_PATH], arguments[8 * TOOL_PATH];
    tool_folder_make(folder);
    make_prop(folder, "chest");
    make_prop(folder, "nightstand");
    int size = snprintf(arguments, sizeof arguments, "--props|400|--frames|120|--reach|6|--fps|0|--width|240");
    for (int i = 0; i < 5; i++) /* ten kinds of two files */
        size += snprintf(arguments + size, sizeof arguments - (size_t)size, "|%s/chest.dmo|%s/nightstand.dmo", folder,
                         folder);
    snprintf(arguments + size, sizeof arguments - (size_t)size, "|-o|%s", folder);
    run_sample("many_objects", arguments);
    if (out.status != 0) fail_msg("%s%s", out.text, out.errors);
    assert_says("level: 400 props of 11 kinds");
    assert_says("1 prepared,");
    assert_says("more until all was there, 0 props missing");
    const unsigned long came = said_after("props: "), went = said_after("came, "), most = said_after("went, ");
    assert_true(went > 0 && came > went && came - went <= most && most < 100); /* of 400, few are there at once */
    assert_true(said_after("prepared, ") > 0);                                 /* kinds that were given back */
    assert_true(said_after("picks, ") > 0 && said_after("hits, ") > 0 && said_after("drags, ") > 0);
    assert_true(said_after("parts kept, ") > 0); /* put back: what was opened is open when it comes again */
    assert_is_png(folder, "level.png");
    assert_is_png(folder, "frames.png");
    copy_counts(first);
    arguments[size] = 0;
    run_sample("many_objects", arguments);
    assert_int_equal(out.status, 0);
    copy_counts(second);
    assert_true(strlen(second) > 100);
    tool_folder_remove(folder);
    run_sample("many_objects", "--frames|2|--props|24|no_such.dmo");
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "no_such.dmo: "));
    run_sample("many_objects", "--props|0");
    assert_int_equal(out.status, 2);
}

static void test_whole_host(void** state) {
    (void)state;
    run_sample("whole_host", "");
    assert_int_equal(out.status, 0);
    /* The camera of the renderer and that of the library are one: the point that was hit is drawn at the mouse. */
    assert_says("pixel (600, 400) is on door_left; its point is drawn at (600.0, 400.0)");
    int frames = 0;
    float value = 0;
    for (const char* at = out.text; (at = strstr(at, "value ")) != NULL; at++, frames++) value = strtof(at + 6, NULL);
    assert_int_equal(frames, 31);
    assert_true(value > 0.3f && value < 1); /* rad: the door follows the mouse */
    run_sample("whole_host", "samples/cabinet.glb|body|10|10");
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "pixel (10, 10) is on no part"));
    run_sample("whole_host", "README.md");
    assert_int_equal(out.status, 1);
    assert_non_null(strstr(out.errors, "README.md: "));
}

/* ---- a stub of a language model ---- */

static pid_t stub_process; /* 0: none runs */

/* The whole request has come when its body is as long as its head says. */
static void read_request(int connection, char* text, size_t room) {
    size_t size = 0;
    ssize_t got;
    while ((got = read(connection, text + size, room - 1 - size)) > 0) {
        size += (size_t)got;
        text[size] = 0;
        const char *length = strcasestr(text, "Content-Length: "), *body = strstr(text, "\r\n\r\n");
        if (length && body && strlen(body + 4) >= strtoul(length + 16, NULL, 10)) return;
    }
}

static int count_of(const char* text, const char* words) {
    int count = 0;
    for (const char* at = text; (at = strstr(at, words)) != NULL; at++) count++;
    return count;
}

/* Returns the number of the first picture that the question calls by `word`; 0 when there is none. */
static int picture_called(const char* request, const char* word) {
    for (int number = 1; number <= 8; number++) {
        char start[64];
        snprintf(start, sizeof start, "Picture %d: %s,", number, word);
        if (strstr(request, start)) return number;
    }
    return 0;
}

/* Whether the question has a key, a model, and one PNG for each of two to eight descriptions. */
static int is_good(const char* request) {
    const int pictures = count_of(request, "\"url\":\"data:image/png;base64,iVBORw0KGgo");
    return strncmp(request, "POST /v1/chat/completions ", 26) == 0 && strstr(request, "Bearer secret") &&
           strstr(request, "\"model\":\"stub\"") && pictures >= 2 && pictures <= 8 &&
           count_of(request, "\"Picture ") == pictures;
}

/* "part number 1" -> the first answer, "part number 2" -> the second; "@word" stands for the picture called so. */
static void answer(int connection, const char* const answers[2]) {
    static char request[1 << 20], content[1024], body[2048], text[4096];
    read_request(connection, request, sizeof request);
    const char* says = answers[strstr(request, "Part number 2") != NULL];
    if (says[0] == '@')
        snprintf(content, sizeof content, "Picture %d, I would say: 100 %% sure.", picture_called(request, says + 1));
    else
        snprintf(content, sizeof content, "%s", says);
    snprintf(body, sizeof body, "{\"choices\":[{\"message\":{\"role\":\"assistant\",\"content\":\"%s\"}}]}", content);
    snprintf(text, sizeof text,
             "HTTP/1.1 %s\r\nContent-Type: application/json\r\nContent-Length: %zu\r\n"
             "Connection: close\r\n\r\n%s",
             is_good(request) ? "200 OK" : "400 Bad Request", strlen(body), body);
    if (write(connection, text, strlen(text)) < 0) _exit(1);
    close(connection);
}

/* Serves until it is stopped, or the test ends in any way; the port it listens on. */
static int stub_start(const char* first, const char* second) {
    const char* const answers[2] = {first, second};
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    socklen_t size = sizeof address;
    const int listening = socket(AF_INET, SOCK_STREAM, 0);
    assert_true(listening >= 0);
    assert_int_equal(bind(listening, (struct sockaddr*)&address, size), 0);
    assert_int_equal(listen(listening, 8), 0);
    assert_int_equal(getsockname(listening, (struct sockaddr*)&address, &size), 0);
    stub_process = fork();
    assert_true(stub_process >= 0);
    if (stub_process == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (int connection; (connection = accept(listening, NULL, NULL)) >= 0;) answer(connection, answers);
        _exit(0);
    }
    close(listening);
    return ntohs(address.sin_port);
}

/* The teardown: runs also when an assertion failed. */
static int stub_stop(void** state) {
    (void)state;
    if (stub_process > 0) {
        kill(stub_process, SIGKILL);
        waitpid(stub_process, NULL, 0);
    }
    stub_process = 0;
    return 0;
}

static void point_at(int port) {
    char url[64];
    snprintf(url, sizeof url, "http://127.0.0.1:%d/v1", port);
    setenv("DRAGMESH_VLM_URL", url, 1);
    setenv("DRAGMESH_VLM_KEY", "secret", 1);
    setenv("DRAGMESH_VLM_MODEL", "stub", 1);
    setenv("no_proxy", "127.0.0.1", 1);
}

static void test_model_decides(void** state) {
    (void)state;
    char folder[TOOL_PATH], arguments[2 * TOOL_PATH], picture[TOOL_PATH + 32];
    tool_folder_make(folder);
    snprintf(arguments, sizeof arguments, "sdk/models|%s", folder);
    point_at(stub_start("@prismatic", "@revolute"));
    run_sample("vlm_intent", arguments);
    assert_int_equal(out.status, 0);
    assert_says("part 1 moves: prismatic"); /* against all geometry: the host's word counts */
    assert_says("part 2 moves: revolute");
    assert_int_equal(count_of(out.text, "chosen"), 2);
    snprintf(picture, sizeof picture, "%s/part2_2.png", folder);
    size_t size;
    char* png = tool_read(picture, &size);
    assert_true(size > 1000 && memcmp(png, "\x89PNG", 4) == 0);
    free(png);
    tool_folder_remove(folder);
}

static void test_model_is_no_use(void** state) {
    (void)state;
    point_at(stub_start("Sorry, I can't see it.", "99"));
    run_sample("vlm_intent", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_says("part 1: the model picks none");
    assert_says("part 2: the model picks none");
    assert_int_equal(count_of(out.text, "as the library found it"), 2);
    stub_stop(state);
    point_at(stub_start("0, none of them.", "\\u0000{["));
    run_sample("vlm_intent", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_int_equal(count_of(out.text, "the model picks none"), 2);
}

static void test_model_is_down(void** state) {
    (void)state;
    point_at(1); /* nobody listens there */
    run_sample("vlm_intent", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_non_null(strstr(out.errors, "the library's answer stays"));
    unsetenv("DRAGMESH_VLM_URL");
    run_sample("vlm_intent", "sdk/models");
    assert_int_equal(out.status, 0);
    assert_says("DRAGMESH_VLM_URL is not set: the library's answer stays");
}

/* The recipes of docs/integration.md check what they claim. */
static void test_recipes(void** state) {
    (void)state;
    static const char* const names[] = {"find_part",   "instances", "saving", "undo", "rollback",
                                        "replication", "physics",   "scaled", "vr"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char program[128];
        snprintf(program, sizeof program, "samples/recipe_%s", names[i]);
        tool_run(&out, program, NULL, "%s", "");
        if (out.status != 0) fail_msg("%s: %s%s", names[i], out.text, out.errors);
    }
}

/* A processor without FMA and AVX2 gives the same bits. glibc alone listens to this; elsewhere it changes nothing. */
static void test_rollback_has_the_same_bits_without_fma(void** state) {
    (void)state;
    static tool_output here;
    tool_run(&here, "samples/recipe_rollback", NULL, "%s", "");
    setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable", 1);
    tool_run(&out, "samples/recipe_rollback", NULL, "%s", "");
    unsetenv("GLIBC_TUNABLES");
    assert_int_equal(out.status, 0);
    assert_string_equal(out.text, here.text);
}

int main(void) {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    setenv("XDG_RUNTIME_DIR", "/tmp", 0);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_hello_drag),
                                       cmocka_unit_test(test_dynamic_load),
                                       cmocka_unit_test(test_host_memory_and_jobs),
                                       cmocka_unit_test(test_host_pick),
                                       cmocka_unit_test(test_prepare_offline),
                                       cmocka_unit_test(test_gpu_skinning),
                                       cmocka_unit_test(test_many_objects),
                                       cmocka_unit_test(test_whole_host),
                                       cmocka_unit_test(test_recipes),
                                       cmocka_unit_test(test_rollback_has_the_same_bits_without_fma),
                                       cmocka_unit_test_teardown(test_model_decides, stub_stop),
                                       cmocka_unit_test_teardown(test_model_is_no_use, stub_stop),
                                       cmocka_unit_test(test_model_is_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
