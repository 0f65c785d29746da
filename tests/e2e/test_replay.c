/* Recorded sessions in the viewer (tests/replay): the same poses bit for bit on every run, the joint values and the
 * pictures that were recorded. Made by tests/replay/record. Runs from the repository's root. */
#include <math.h>

#include <png.h>

#include "test_tool.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { CAN_DRAW = 0 }; /* the software OpenGL driver leaks, and races on purpose: pictures are the other builds' job */
#else
enum { CAN_DRAW = 1 };
#endif

enum { NO_OPENGL = 3, PICTURES = 2 }; /* the viewer's exit status; frame_000.png and so on */

static tool_output out;

static int has_viewer(void) {
    char path[TOOL_PATH];
    tool_find("dragmesh_viewer", path);
    return access(path, X_OK) == 0;
}

/* ---- pictures ---- */

static uint8_t* read_picture(const char* path, int* out_width, int* out_height) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&image, path)) fail_msg("%s: %s", path, image.message);
    image.format = PNG_FORMAT_RGB;
    uint8_t* pixels = malloc(PNG_IMAGE_SIZE(image));
    assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
    *out_width = (int)image.width;
    *out_height = (int)image.height;
    return pixels;
}

/* Drivers differ in a shade here and an edge there: a mean of 2 of 255 and one pixel in 50 that is plainly another. */
static void assert_same_picture(const char* expected, const char* actual) {
    int width, height, other_width, other_height, plain = 0;
    uint8_t *a = read_picture(expected, &width, &height), *b = read_picture(actual, &other_width, &other_height);
    assert_int_equal(width, other_width);
    assert_int_equal(height, other_height);
    double sum = 0;
    for (int i = 0; i < width * height; i++) {
        int most = 0;
        for (int k = 0; k < 3; k++) {
            const int difference = abs(a[3 * i + k] - b[3 * i + k]);
            sum += difference;
            most = difference > most ? difference : most;
        }
        plain += most > 40;
    }
    free(a);
    free(b);
    const double mean = sum / (3.0 * width * height);
    if (mean > 2 || plain > width * height / 50)
        fail_msg("%s: a mean difference of %.2f, %d of %d pixels plainly differ", expected, mean, plain,
                 width * height);
}

/* ---- a session ---- */

/* The line "poses HASH over N frames". */
static void read_hash(char hash[64]) {
    hash[0] = 0;
    const char* line = strstr(out.text, "poses ");
    if (line) snprintf(hash, 64, "%.*s", (int)strcspn(line, "\n"), line);
    assert_true(strlen(hash) > 20);
}

/* Lines "part N 'name': value" against the recorded ones. */
static void assert_recorded_values(const char* folder) {
    char path[TOOL_PATH], text[4096] = "";
    snprintf(path, sizeof path, "%s/expected.txt", folder);
    size_t size;
    char* recorded = tool_read(path, &size);
    assert_true(size > 0 && size < sizeof text);
    memcpy(text, recorded, size);
    free(recorded);
    for (char *rest = text, *line; (line = strtok_r(rest, "\n", &rest));) {
        const char* colon = strrchr(line, ':');
        assert_non_null(colon);
        const int name_length = (int)(colon + 1 - line);
        char name[256];
        snprintf(name, sizeof name, "%.*s", name_length, line);
        const char* now = strstr(out.text, name);
        if (!now) {
            fail_msg("%s: there is no \"%s\" now", folder, name);
            return; /* never reached; tells the analyser so */
        }
        const double expected = strtod(colon + 1, NULL), value = strtod(now + name_length, NULL);
        if (fabs(value - expected) > 1e-3 * (1 + fabs(expected)))
            fail_msg("%s: %s %g now, recorded %g", folder, name, value, expected);
    }
}

static void run_session(const char* folder, const char* pictures) {
    char drawing[TOOL_PATH + 32] = "";
    if (pictures) snprintf(drawing, sizeof drawing, "|--png|%s|--frames|%d", pictures, PICTURES);
    tool_run(&out, "dragmesh_viewer", NULL,
             "%s/object.glb|--replay|%s/hand.session|--dmo|%s/object.dmo|--models|none%s", folder, folder, folder,
             drawing);
}

static void check_pictures(const char* folder, const char* pictures) {
    for (int i = 0; i < PICTURES; i++) {
        char expected[TOOL_PATH], actual[TOOL_PATH + 32];
        snprintf(expected, sizeof expected, "%s/frame_%03d.png", folder, i);
        snprintf(actual, sizeof actual, "%s/frame_%03d.png", pictures, i);
        assert_same_picture(expected, actual);
    }
}

static void test_session(void** state) {
    const char* name = *state;
    char folder[TOOL_PATH / 2], pictures[TOOL_PATH], first[64], second[64];
    if (!has_viewer()) {
        print_message("skipped: the viewer is not built, SDL2 or libepoxy is missing (scripts/install viewer)\n");
        skip();
    }
    snprintf(folder, sizeof folder, "tests/replay/%s", name);
    run_session(folder, NULL);
    if (out.status != 0) fail_msg("%s: %s", folder, out.errors);
    read_hash(first);
    assert_recorded_values(folder);
    tool_folder_make(pictures);
    run_session(folder, CAN_DRAW ? pictures : NULL);
    if (out.status == NO_OPENGL) {
        print_message("skipped the pictures: no OpenGL 3.3 can be made here: %s\n", out.errors);
        run_session(folder, NULL);
    } else if (CAN_DRAW) {
        assert_int_equal(out.status, 0);
        check_pictures(folder, pictures);
    }
    read_hash(second);
    assert_string_equal(first, second);
    tool_folder_remove(pictures);
}

/* The whole way, weights included: nothing is compared with a recording, for better weights find better joints. */
static void test_from_the_file_alone(void** state) {
    (void)state;
    char first[64], second[64];
    if (!has_viewer()) skip();
    for (int run = 0; run < 2; run++) {
        tool_run(&out, "dragmesh_viewer", NULL,
                 "tests/replay/cabinet_door/object.glb|--replay|tests/replay/cabinet_door/hand.session");
        assert_int_equal(out.status, 0);
        read_hash(run ? second : first);
    }
    assert_string_equal(first, second);
}

/* Plays a .glb of this folder by its absolute path, which begins with `root`. */
static void play_from(const char* root, const char* models, char hash[64]) {
    tool_run(&out, "dragmesh_viewer", NULL,
             "%s/tests/replay/cabinet_door/object.glb|--replay|%s/tests/replay/cabinet_door/hand.session%s", root, root,
             models);
    assert_int_equal(out.status, 0);
    read_hash(hash);
}

/* The weights in force show in the poses. */
static void test_weights_are_found_from_any_folder(void** state) {
    (void)state;
    char root[TOOL_PATH], named[64], found[64], none[64], elsewhere[64];
    if (!has_viewer()) skip();
    assert_non_null(getcwd(root, sizeof root));
    play_from(root, "|--models|sdk/models", named);
    play_from(root, "|--models|none", none);
    assert_string_not_equal(named, none);
    assert_int_equal(chdir("/"), 0);
    play_from(root, "", found);
    setenv("DRAGMESH_MODELS", "/dev/null", 1);
    play_from(root, "", elsewhere);
    unsetenv("DRAGMESH_MODELS");
    assert_int_equal(chdir(root), 0);
    assert_string_equal(found, named);
    assert_string_equal(elsewhere, none);
}

/* ---- what belongs to the instance, and what to the object ---- */

/* Writes a recorded session that goes on with `events` in place of its events from the first `cut` on. */
static void write_other_session(const char* name, const char* cut, const char* events, const char* path) {
    char own[TOOL_PATH];
    size_t size;
    snprintf(own, sizeof own, "tests/replay/%s/hand.session", name);
    char* text = tool_read(own, &size);
    char* end = strstr(text, cut);
    if (end == NULL) fail_msg("%s: no '%s'", own, cut);
    while (end > text && end[-1] != '\n') end--;
    char* other = calloc(1, size + strlen(events) + 1);
    memcpy(other, text, (size_t)(end - text));
    strcat(other, events);
    tool_write(path, other, strlen(other));
    free(other);
    free(text);
}

/* Runs such a session, which may save the object as saved.dmo in `folder`, and returns where a part stands then. */
static double value_after(const char* folder, const char* name, const char* cut, const char* events, const char* part) {
    char path[TOOL_PATH + 16], label[64];
    snprintf(path, sizeof path, "%s/other.session", folder);
    write_other_session(name, cut, events, path);
    tool_run(
        &out, "dragmesh_viewer", NULL,
        "tests/replay/%s/object.glb|--replay|%s|--dmo|tests/replay/%s/object.dmo|--models|none|--save|%s/saved.dmo",
        name, path, name, folder);
    if (out.status != 0) fail_msg("%s: %s", name, out.errors);
    snprintf(label, sizeof label, "'%s': ", part);
    const char* line = strstr(out.text, label);
    assert_non_null(line);
    return strtod(line + strlen(label), NULL);
}

static void test_undo_puts_back_the_part(void** state) {
    (void)state;
    char folder[TOOL_PATH], moved[64], undone[64];
    if (!has_viewer()) skip();
    tool_folder_make(folder);
    const double open = value_after(folder, "cabinet_door", " end", "200 end\n", "door_left");
    assert_true(fabs(open) > 1);
    const double at_rest = value_after(folder, "cabinet_door", " end", "200 key R\n201 end\n", "door_left");
    assert_true(at_rest == 0);
    const double again = value_after(folder, "cabinet_door", " end", "200 key R\n201 key B\n202 end\n", "door_left");
    assert_true(again == open);
    const double before =
        value_after(folder, "cabinet_door", " end", "200 key R\n201 key B\n202 key B\n203 end\n", "door_left");
    assert_true(before == 0);
    const double too_far = value_after(folder, "cabinet_door", " end", "200 key B\n201 key B\n202 end\n", "door_left");
    assert_true(too_far == 0);
    assert_non_null(strstr(out.errors, "nothing to undo"));
    /* While the part swings on by itself, and in the hand: it stands still where it was. */
    assert_true(value_after(folder, "cabinet_door", " end", "140 key B\n200 end\n", "door_left") == 0);
    read_hash(undone);
    value_after(folder, "cabinet_door", " end", "200 end\n", "door_left");
    read_hash(moved);
    assert_string_not_equal(moved, undone);
    tool_folder_remove(folder);
}

/* A joint that a pull has changed is taken back, once; undo takes that back. */
static void test_as_it_was_before(void** state) {
    (void)state;
    static const char name[] = "door_decided_by_the_pull", part[] = "door";
    char folder[TOOL_PATH];
    if (!has_viewer()) skip();
    tool_folder_make(folder);
    const double pulled = value_after(folder, name, " end", "200 end\n", part);
    assert_true(fabs(pulled) > 1);
    assert_true(value_after(folder, name, " end", "200 key W\n201 end\n", part) == 0);
    assert_true(value_after(folder, name, " end", "200 key W\n201 key B\n202 end\n", part) == pulled);
    value_after(folder, name, " end", "200 key W\n201 key W\n202 end\n", part);
    assert_non_null(strstr(out.errors, "no pull has changed"));
    tool_folder_remove(folder);
}

/* Other instances of the object, and the file that is saved, know nothing of what a pull found out … */
static void test_pull_leaves_the_object_as_it_is(void** state) {
    (void)state;
    char folder[TOOL_PATH], path[TOOL_PATH + 16];
    if (!has_viewer()) skip();
    tool_folder_make(folder);
    snprintf(path, sizeof path, "%s/saved.dmo", folder);
    static const char* const events[3] = {"0 key S\n1 end\n", "200 key S\n201 end\n",
                                          "200 key J\n201 key S\n202 end\n"};
    char* saved[3];
    size_t size[3];
    for (int i = 0; i < 3; i++) {
        value_after(folder, "door_decided_by_the_pull", i == 0 ? " camera" : " end", events[i], "door");
        saved[i] = tool_read(path, &size[i]);
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(saved[0], saved[1], size[0]);
    /* … until the designer says so. */
    assert_true(size[2] != size[0] || memcmp(saved[2], saved[0], size[0]) != 0);
    for (int i = 0; i < 3; i++) free(saved[i]);
    tool_folder_remove(folder);
}

static void test_recording_is_read_strictly(void** state) {
    (void)state;
    static const char* const bad[] = {"not a session\n",
                                      "dragmesh-session 1\nsize 0 0\n",
                                      "dragmesh-session 1\n0 move 1\n",
                                      "dragmesh-session 1\n0 move 1 nan\n",
                                      "dragmesh-session 1\n5 press left\n4 release left\n",
                                      "dragmesh-session 1\n0 press elbow\n",
                                      "dragmesh-session 1\n0 jump 1 2\n"};
    char folder[TOOL_PATH], path[TOOL_PATH + 16];
    if (!has_viewer()) skip();
    tool_folder_make(folder);
    snprintf(path, sizeof path, "%s/bad.session", folder);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        tool_write(path, bad[i], strlen(bad[i]));
        tool_run(&out, "dragmesh_viewer", NULL, "tests/replay/laptop/object.glb|--replay|%s", path);
        if (out.status != 2) fail_msg("session %zu was read: %s", i, bad[i]);
    }
    tool_folder_remove(folder);
}

#define SESSION(name)                                                                                                  \
    { name, test_session, NULL, NULL, name }

int main(void) {
    setenv("SDL_VIDEODRIVER", "offscreen", 1);
    setenv("XDG_RUNTIME_DIR", "/tmp", 0);
    static char names[][32] = {"cabinet_door",
                               "drawer",
                               "laptop",
                               "faucet",
                               "screw_cap",
                               "sliding_window",
                               "wheel",
                               "chest_lid",
                               "door_decided_by_the_pull",
                               "toilet_lid",
                               "button_overridden",
                               "knob_painted"};
    const struct CMUnitTest tests[] = {SESSION(names[0]),
                                       SESSION(names[1]),
                                       SESSION(names[2]),
                                       SESSION(names[3]),
                                       SESSION(names[4]),
                                       SESSION(names[5]),
                                       SESSION(names[6]),
                                       SESSION(names[7]),
                                       SESSION(names[8]),
                                       SESSION(names[9]),
                                       SESSION(names[10]),
                                       SESSION(names[11]),
                                       cmocka_unit_test(test_from_the_file_alone),
                                       cmocka_unit_test(test_weights_are_found_from_any_folder),
                                       cmocka_unit_test(test_undo_puts_back_the_part),
                                       cmocka_unit_test(test_as_it_was_before),
                                       cmocka_unit_test(test_pull_leaves_the_object_as_it_is),
                                       cmocka_unit_test(test_recording_is_read_strictly)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
