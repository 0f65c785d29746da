/* The scenes of samples/12_latch: their hands are heard to do what the scene is about, at any frame rate, and the
 * viewer plays the same. Runs from the repository's root. */
#include <math.h>
#include <stdbool.h>

#include "test_tool.h"

/* What is heard, in this order, whatever else is; then where the parts are. */
typedef struct story {
    const char* name;
    const char* heard[10];
    const char* parts[3];
    float ends[3];
} story;

static const story stories[] = {
    {"house_door",
     {"door is held", "key opened", "handle opened", "door unlatches", "door opened", "door closed", "door latches"},
     {"door", "handle"},
     {0, 0}},
    {"double_door", {"left opened", "right closed", "right is at rest"}, {"left", "right"}, {0, 0}},
    {"safe",
     {"bolt is held", "dial clicks", "bolt opened", "door leaves rest", "door opened"},
     {"dial", "door"},
     {4.189f, 1.205f}},
    {"drawers",
     {"top opened", "top meets its upper limit", "bottom is held", "top closed", "top is at rest", "bottom leaves rest",
      "bottom meets its upper limit"},
     {"top", "middle", "bottom"},
     {0, 0, 0.32f}},
    {"hatch",
     {"lid opened", "lid meets its lower limit", "lid leaves rest", "lid meets its lower limit", "lid opened",
      "lid meets its upper limit"},
     {"lid"},
     {1.9f}},
    {"gears",
     {"large opened", "rack closed", "rack meets its lower limit"},
     {"rack", "small", "large"},
     {-0.05f, -0.625f, 0.3125f}},
    {"blocked_door",
     {"door opened", "door is blocked", "chair opened", "door is free", "chair meets its upper limit"},
     {"chair", "door"},
     {0.6f, 1.174f}},
    {"two_hands", {"lid leaves rest", "lid opened", "lid meets its upper limit"}, {"lid"}, {1.5f}},
};
enum { STORIES = sizeof stories / sizeof *stories };

static tool_output out;

static bool is_built(const char* program) {
    char path[TOOL_PATH];
    tool_find(program, path);
    return access(path, X_OK) == 0;
}

static void assert_near(const char* what, float actual, float wanted) {
    if (fabsf(actual - wanted) > 0.02f) fail_msg("%s is %g, not %g", what, (double)actual, (double)wanted);
}

/* ---- the sample ---- */

static void assert_heard(const story* story, const char* rate) {
    const char* at = out.text;
    for (int i = 0; i < 10 && story->heard[i] != NULL; i++) {
        at = strstr(at, story->heard[i]);
        if (at == NULL)
            fail_msg("%s at %s Hz: '%s' was not heard then:\n%s", story->name, rate, story->heard[i], out.text);
        at += strlen(story->heard[i]);
    }
}

static void assert_ends(const story* story) {
    const char* ends = strstr(out.text, "ends with");
    assert_non_null(ends);
    for (int i = 0; i < 3 && story->parts[i] != NULL; i++) {
        char key[64];
        snprintf(key, sizeof key, " %s ", story->parts[i]);
        const char* at = strstr(ends, key);
        assert_non_null(at);
        assert_near(story->parts[i], strtof(at + strlen(key), NULL), story->ends[i]);
    }
}

static void each_scene_tells_its_story(void** state) {
    (void)state;
    static const char* const rates[3] = {"30", "60", "144"};
    for (int i = 0; i < STORIES; i++) {
        for (int rate = 0; rate < 3; rate++) {
            tool_run(&out, "samples/sample_latch", NULL, "%s|%s", stories[i].name, rates[rate]);
            assert_int_equal(out.status, 0);
            assert_heard(&stories[i], rates[rate]);
            assert_ends(&stories[i]);
        }
    }
}

/* Eight detents are gone over before the bolt is free, however many fall into one frame. */
static void the_safe_counts_its_detents(void** state) {
    (void)state;
    tool_run(&out, "samples/sample_latch", NULL, "safe|5");
    int clicks = 0;
    const char* bolt = strstr(out.text, "bolt opened");
    assert_non_null(bolt);
    for (const char* at = strstr(out.text, "dial clicks"); at != NULL && at < bolt;
         at = strstr(at + 1, "dial clicks")) {
        int times = 1;
        sscanf(at, "dial clicks%*[ ]%d times", &times);
        clicks += times;
    }
    assert_int_equal(clicks, 8);
}

static void an_unknown_scene_is_refused(void** state) {
    (void)state;
    tool_run(&out, "samples/sample_latch", NULL, "no_such_scene");
    assert_int_equal(out.status, 2);
}

/* ---- the viewer ---- */

static void the_viewer_plays_the_same(void** state) {
    (void)state;
    if (!is_built("dragmesh_viewer")) {
        printf("no viewer here: skipped\n");
        skip();
    }
    for (int i = 0; i < STORIES; i++) {
        char hashes[2][64];
        for (int run = 0; run < 2; run++) {
            tool_run(&out, "dragmesh_viewer", NULL, "--models|none|--replay|tests/replay/scenes/%s.session",
                     stories[i].name);
            assert_int_equal(out.status, 0);
            assert_int_equal(sscanf(out.text, "poses %63s", hashes[run]), 1);
        }
        assert_string_equal(hashes[0], hashes[1]);
        for (int k = 0; k < 3 && stories[i].parts[k] != NULL; k++) {
            char key[64];
            snprintf(key, sizeof key, "'%s': ", stories[i].parts[k]);
            const char* at = strstr(out.text, key);
            assert_non_null(at);
            assert_near(stories[i].parts[k], strtof(at + strlen(key), NULL), stories[i].ends[k]);
        }
    }
}

int main(void) {
    if (!is_built("samples/sample_latch")) {
        printf("sample_latch is not built: skipped\n");
        return 0;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_scene_tells_its_story),
        cmocka_unit_test(the_safe_counts_its_detents),
        cmocka_unit_test(an_unknown_scene_is_refused),
        cmocka_unit_test(the_viewer_plays_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
