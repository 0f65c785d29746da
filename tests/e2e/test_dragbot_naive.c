/* The scripted player's naive hand (dragmesh dragbot --naive): its pulls on the screen and in space, what it takes for
 * right, and its figures on a generated cabinet. */
#include <math.h>

#include "test_tool.h"

#include "dragbot_naive_pull.c"  /* NOLINT: on its own, without the tool round it */
#include "dragbot_naive_truth.c" /* NOLINT */
#include "dragbot_view.c"        /* NOLINT */

/* ---- what they need of the tool ---- */

void* cli_alloc(size_t size) {
    void* memory = malloc(size);
    assert_non_null(memory);
    return memory;
}

double bot_travel(const known_joint* truth, double size) {
    (void)size;
    return truth->upper;
}

/* ---- the pull ---- */

/* A joint of a box between -1 and 1, whose part is the upper half. */
static bot_truth make_truth(const known_joint* joint) {
    const vec centre = {0, 0.5, 0};
    return (bot_truth){.joint = joint,
                       .side = 1,
                       .low = {-1, -1, -1},
                       .high = {1, 1, 1},
                       .part_low = {-1, 0, -1},
                       .part_high = {1, 1, 1},
                       .centre = centre,
                       .at = foot_on_axis(joint, centre),
                       .size = 2};
}

/* A grab of the middle of the box's front, seen straight from in front. */
static bot_grab make_grab(double turned) {
    bot_grab grab = {.x = 640, .y = 480, .point = {0, 0, 1}, .turn = turned, .across = {0, 0, 1}};
    bot_view_look(&grab.view, (vec){0, 0, 6}, (vec){0, 0, -1}, (vec){0, 1, 0}, 1);
    return grab;
}

static const known_joint to_the_right = {.slides = true, .axis = {0.8, 0.6, 0}, .upper = 1};
static const known_joint to_the_front = {.slides = true, .axis = {0, 0, 1}, .upper = 1};

/* Draws a pull to the right and a little up. Returns its direction on the screen, in degrees anticlockwise. */
static double draw(const bot_hand* hand, double turned, bot_pull* out_pull) {
    const bot_truth truth = make_truth(&to_the_right);
    const bot_grab grab = make_grab(turned);
    assert_true(bot_naive_draw(hand, &grab, &truth, out_pull));
    const double* end = out_pull->path[out_pull->frames - 1];
    assert_true(fabs(hypot(end[0] - 640, end[1] - 480) - 160) < 1e-9);
    return atan2(480 - end[1], end[0] - 640) * 180 / PI;
}

static const double true_angle = 36.8699; /* degrees: of a way of 0.8 to the right and 0.6 up */

static void test_free_pulls_are_turned_by_up_to_the_degrees(void** state) {
    (void)state;
    const bot_hand hand = {.naive = 1, .degrees = 20};
    bot_pull pull;
    assert_true(fabs(draw(&hand, 0, &pull) - true_angle) < 0.1);
    assert_true(fabs(draw(&hand, 1, &pull) - true_angle + 20) < 0.1);
    assert_true(fabs(draw(&hand, -0.5, &pull) - true_angle - 10) < 0.1);
}

static void test_snapped_pulls_go_along_the_nearest_screen_axis(void** state) {
    (void)state;
    const bot_hand hand = {.naive = 1, .degrees = 20, .snap = 1};
    bot_pull pull;
    draw(&hand, 1, &pull);
    for (int i = 0; i < pull.frames; i++) assert_true(pull.path[i][1] == 480 && pull.path[i][0] >= 640);
}

static void test_upward_pulls_go_up_whatever_the_true_way(void** state) {
    (void)state;
    const bot_hand hand = {.naive = 1, .degrees = 20, .up = 1};
    bot_pull pull;
    assert_true(fabs(draw(&hand, 0, &pull) - 90) < 1e-9);
    assert_true(fabs(draw(&hand, -1, &pull) - 110) < 1e-9);
}

/* The pointer rests, moves for half a second and slows down, and rests at the end. */
static void test_pulls_are_eased(void** state) {
    (void)state;
    const bot_hand hand = {.naive = 1, .snap = 1};
    bot_pull pull;
    draw(&hand, 0, &pull);
    assert_int_equal(pull.frames, 34);
    for (int i = 0; i < 4; i++) assert_true(pull.path[i][0] == 640);
    assert_true(fabs(pull.path[18][0] - 640 - 80) < 1e-9); /* 15 frames later: half-way */
    for (int i = 5; i < 34; i++) assert_true(pull.path[i][0] > pull.path[i - 1][0]);
    assert_true(pull.path[33][0] - pull.path[32][0] < 1);
    assert_true(bot_naive_progress(40) == 1);
}

static void test_motions_that_are_not_seen_are_left_out(void** state) {
    (void)state;
    const bot_truth truth = make_truth(&to_the_front);
    const bot_grab grab = make_grab(0);
    const bot_hand on_screen = {.naive = 1}, in_space = {.naive = 1, .point = 1};
    bot_pull pull;
    assert_false(bot_naive_draw(&on_screen, &grab, &truth, &pull));
    assert_true(bot_naive_draw(&in_space, &grab, &truth, &pull));
}

/* As long as the pull on the screen is there, and off by no more than the degrees. */
static void test_pulls_in_space_go_roughly_the_true_way(void** state) {
    (void)state;
    const bot_hand hand = {.naive = 1, .degrees = 20, .point = 1};
    const bot_truth truth = make_truth(&to_the_right);
    const bot_grab grab = make_grab(0.5);
    bot_pull pull;
    assert_true(bot_naive_draw(&hand, &grab, &truth, &pull));
    double x = 0, y = 0;
    assert_true(bot_view_project(&grab.view, add(grab.point, pull.way), &x, &y));
    assert_true(fabs(hypot(x - 640, y - 480) - 160) < 1e-6);
    assert_true(fabs(dot(unit(pull.way), to_the_right.axis) - cos(10 * PI / 180)) < 1e-9);
}

/* ---- the true joint ---- */

static dm_joint make_joint(int32_t type, dm_vec3 axis, dm_vec3 origin) {
    return (dm_joint){.struct_size = sizeof(dm_joint), .type = type, .axis = axis, .origin = origin};
}

static void test_what_is_wrong_with_a_joint(void** state) {
    (void)state;
    const known_joint hinge = {.axis = {0, 1, 0}, .origin = {-1, 5, 1}, .upper = 1};
    const bot_truth truth = make_truth(&hinge);
    const dm_vec3 up = {0, 1, 0}, place = {-1, 0, 1}, beside = {-0.85F, 0, 1};
    const float lean = sinf(0.2F);
    dm_joint joint = make_joint(DM_JOINT_CONTINUOUS, (dm_vec3){0, -1, 0}, place);
    assert_int_equal(bot_truth_compare(&truth, &joint), BOT_RIGHT);
    joint = make_joint(DM_JOINT_PRISMATIC, up, place);
    assert_int_equal(bot_truth_compare(&truth, &joint), BOT_WRONG_TYPE);
    joint = make_joint(DM_JOINT_REVOLUTE, (dm_vec3){lean, cosf(0.2F), 0}, place);
    assert_int_equal(bot_truth_compare(&truth, &joint), BOT_WRONG_AXIS);
    joint = make_joint(DM_JOINT_REVOLUTE, up, beside);
    assert_int_equal(bot_truth_compare(&truth, &joint), BOT_WRONG_LINE);
    const bot_truth slide = make_truth(&to_the_front);
    joint = make_joint(DM_JOINT_PRISMATIC, (dm_vec3){0, 0, -1}, beside);
    assert_int_equal(bot_truth_compare(&slide, &joint), BOT_RIGHT);
}

static void assert_front(const known_joint* joint, vec front) {
    const bot_truth truth = make_truth(joint);
    assert_true(length(sub(bot_truth_front(&truth, (vec){0, 1, 0}), front)) == 0);
}

static void test_people_stand_where_a_part_opens(void** state) {
    (void)state;
    const known_joint drawer = {.slides = true, .axis = {-1, 0, 0}, .upper = 1};
    const known_joint lid = {.axis = {0, 0, 1}, .origin = {-1, 0, 0}, .upper = 1};
    assert_front(&to_the_front, (vec){0, 0, 1});
    assert_front(&drawer, (vec){-1, 0, 0});
    assert_front(&lid, (vec){1, 0, 0}); /* opposite to its hinge */
}

/* ---- figures ---- */

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

static cJSON* play(const char* more) {
    tool_run(&out, "dragmesh", NULL, "dragbot|%s|--json|--naive%s", folder, more);
    cJSON* json = tool_json(&out);
    assert_non_null(json);
    return json;
}

static double figure(const cJSON* json, const char* name) {
    const cJSON* found = cJSON_GetObjectItem(json, name);
    if (!cJSON_IsNumber(found)) fail_msg("there is no number %s", name);
    return found->valuedouble;
}

static void assert_shares(const cJSON* json) {
    static const char* const shares[] = {
        "before", "after", "kept", "lost", "moved", "success", "turns_to_slides", "sure_right", "calibration_error"};
    for (size_t i = 0; i < sizeof shares / sizeof *shares; i++)
        assert_true(figure(json, shares[i]) >= 0 && figure(json, shares[i]) <= 1);
    assert_true(figure(json, "success") <= fmin(figure(json, "after"), figure(json, "moved")));
    assert_true(fabs(figure(json, "kept") + figure(json, "lost") - 1) < 2e-5); /* five digits */
}

/* A joint that is kept stays as it was prepared: right, and so the part goes with the hand in a share of the pulls. */
static void assert_kept(const cJSON* json, double least) {
    const cJSON* keep = cJSON_GetObjectItem(json, "keep");
    assert_shares(keep);
    assert_true(figure(keep, "kept") == 1 && figure(keep, "joint_changes") == 0);
    assert_true(figure(keep, "after") == figure(json, "before"));
    assert_true(figure(keep, "success") >= least);
}

static void test_figures(void** state) {
    (void)state;
    static const char* const hands[] = {"", "|10", "|--snap", "|--point", "|--up"};
    static const double least[] = {0.95, 0.95, 0.95, 0.95, 0.5}; /* nobody opens a cupboard upwards */
    for (int i = 0; i < 5; i++) {
        cJSON* json = play(hands[i]);
        assert_true(figure(json, "cases") >= 4 && figure(json, "failed") == 0 && figure(json, "before") == 1);
        assert_shares(json);
        assert_kept(json, least[i]);
        cJSON_Delete(json);
    }
}

/* Three pulls, one after the other: after the first, things are as after that pull alone. */
static void test_series(void** state) {
    (void)state;
    cJSON *alone = play(""), *series = play("|--regrab|3");
    const cJSON* first = cJSON_GetObjectItem(series, "first");
    static const char* const same[] = {"after", "success", "joint_changes", "confidence_right"};
    assert_int_equal(figure(series, "cases"), figure(alone, "cases"));
    for (size_t i = 0; i < sizeof same / sizeof *same; i++)
        assert_true(figure(first, same[i]) == figure(alone, same[i]));
    assert_kept(series, 0.95);
    assert_true(figure(series, "updates") > 2 * figure(alone, "updates"));
    cJSON_Delete(alone);
    cJSON_Delete(series);
}

/* Only objects with one of the words are played. */
static void test_only(void** state) {
    (void)state;
    cJSON *some = play("|--only|chest,CABINET"), *none = play("|--only|chest");
    assert_true(figure(some, "cases") > 0);
    assert_true(figure(none, "cases") == 0);
    cJSON_Delete(some);
    cJSON_Delete(none);
}

static void test_text(void** state) {
    (void)state;
    tool_run(&out, "dragmesh", NULL, "dragbot|%s|--models|none|--naive|--regrab|3|--cameras|1|--worst|3", folder);
    assert_int_equal(out.status, 0);
    static const char* const said[] = {"pulls of", "success", "calibration_error", "1st pull"};
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) assert_non_null(strstr(out.text, said[i]));
}

static void test_refusals(void** state) {
    (void)state;
    static const char* const refused[] = {"--snap",
                                          "--up",
                                          "--naive|-1",
                                          "--naive|181",
                                          "--naive|--snap|--up",
                                          "--naive|--straight",
                                          "--naive|--point|--snap",
                                          "--naive|--scalar",
                                          "--naive|--view|behind",
                                          "--naive|--given-joint",
                                          "--naive|--poses|/dev/null",
                                          "--all|--naive"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        tool_run(&out, "dragmesh", NULL, "dragbot|%s|--models|none|%s", folder, refused[i]);
        if (out.status != 2) fail_msg("%s is not refused", refused[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_free_pulls_are_turned_by_up_to_the_degrees),
        cmocka_unit_test(test_snapped_pulls_go_along_the_nearest_screen_axis),
        cmocka_unit_test(test_upward_pulls_go_up_whatever_the_true_way),
        cmocka_unit_test(test_pulls_are_eased),
        cmocka_unit_test(test_motions_that_are_not_seen_are_left_out),
        cmocka_unit_test(test_pulls_in_space_go_roughly_the_true_way),
        cmocka_unit_test(test_what_is_wrong_with_a_joint),
        cmocka_unit_test(test_people_stand_where_a_part_opens),
        cmocka_unit_test(test_figures),
        cmocka_unit_test(test_series),
        cmocka_unit_test(test_only),
        cmocka_unit_test(test_text),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests_name("dragbot_naive", tests, make_cabinet, remove_cabinet);
}
