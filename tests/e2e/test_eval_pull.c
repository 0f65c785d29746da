/* The pulls of `dragmesh eval` (tools/evaluate/pull.c) of a door hung on the z axis, and of a drawer; and the
 * command with each of them. */
#include "test_tool.h"

#include "pull.c" /* NOLINT: on its own, without the tool round it */

/* A door of width 2 along x, one unit high, and a stored drag at its middle that opens it against the axis' sense. */
static const vec leaf[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}};
enum { LEAF = sizeof leaf / sizeof *leaf };
static const double size = 4;

static known_joint hinge(double lower, double upper) {
    return (known_joint){.axis = {0, 0, 1}, .lower = lower, .upper = upper, .drags = {{{1, 0, 0.5}, {0, -0.4, 0}}}};
}

static void assert_vec(vec found, double x, double y, double z) {
    if (length(sub(found, (vec){x, y, z})) > 1e-12) fail_msg("(%g, %g, %g)", found.x, found.y, found.z);
}

static known_drag pulled(pull_kind kind, const known_joint* truth) {
    return pull_make(kind, truth, &truth->drags[0], leaf, LEAF, size);
}

static void test_names(void** state) {
    (void)state;
    assert_int_equal(pull_kind_of("exact"), PULL_EXACT);
    assert_int_equal(pull_kind_of("chord"), PULL_CHORD);
    assert_int_equal(pull_kind_of("axis"), PULL_AXIS);
    assert_int_equal(pull_kind_of("arc"), PULL_KINDS);
}

static void test_exact_is_the_stored_drag(void** state) {
    (void)state;
    const known_joint door_hinge = hinge(-1.5, 0);
    const known_drag drag = pulled(PULL_EXACT, &door_hinge);
    assert_vec(drag.point, 1, 0, 0.5);
    assert_vec(drag.vector, 0, -0.4, 0);
}

/* From the first of the farthest vertices to where it is at half the limit, at most one radian. */
static void test_chord_leads_to_half_open(void** state) {
    (void)state;
    static const struct {
        double lower, upper, turn;
    } rows[] = {{-1.5, 0, -0.75}, {-3, 0.2, -1}, {0, 0.4, -0.2}, {NAN, NAN, -1}, {0, 0, -1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const known_joint joint = hinge(rows[i].lower, rows[i].upper);
        const known_drag drag = pulled(PULL_CHORD, &joint);
        assert_vec(drag.point, 2, 0, 0);
        assert_vec(drag.vector, 2 * cos(rows[i].turn) - 2, 2 * sin(rows[i].turn), 0);
    }
}

static void test_axis_is_the_nearest_of_the_room(void** state) {
    (void)state;
    known_joint joint = hinge(-1.5, 0);
    known_drag drag = pulled(PULL_AXIS, &joint);
    assert_vec(drag.point, 2, 0, 0);
    assert_vec(drag.vector, 0, -0.1 * size, 0);
    joint.axis = unit((vec){0, 0.6, 0.8}); /* the far end then starts along (0, -.8, .6) or against it */
    joint.drags[0].vector = (vec){0, 0.4, -0.3};
    drag = pulled(PULL_AXIS, &joint);
    assert_vec(drag.vector, 0, 0.1 * size, 0);
}

static void test_slides_are_grabbed_where_stored(void** state) {
    (void)state;
    const known_joint drawer = {
        .slides = true, .axis = {0.6, 0, 0.8}, .lower = 0, .upper = 1, .drags = {{{1, 0, 0.5}, {-0.3, 0, -0.4}}}};
    const known_drag chord = pulled(PULL_CHORD, &drawer), axis = pulled(PULL_AXIS, &drawer);
    assert_vec(chord.point, 1, 0, 0.5);
    assert_vec(chord.vector, -0.3, 0, -0.4);
    assert_vec(axis.point, 1, 0, 0.5);
    assert_vec(axis.vector, 0, 0, -0.1 * size);
}

static tool_output out;

static double figure(const char* folder, const char* arguments, const char* name) {
    tool_run(&out, "dragmesh", NULL, "eval|%s|--json%s", folder, arguments);
    cJSON* json = tool_json(&out);
    const cJSON* item = cJSON_GetObjectItem(json, name);
    assert_true(cJSON_IsNumber(item));
    const double value = item->valuedouble;
    cJSON_Delete(json);
    return value;
}

/* The answer opens the way of the pull, and the command says how well stated confidence fits. Another pull is another
 * question, so that the confidence differs. */
static void test_command(void** state) {
    (void)state;
    char folder[TOOL_PATH];
    tool_folder_make(folder);
    tool_run(&out, "dragmesh_generate", NULL, "--category|door|--seed|3|-o|%s/door", folder);
    assert_int_equal(out.status, 0);
    const double exact = figure(folder, "", "confidence"), chord = figure(folder, "|--pull|chord", "confidence");
    assert_true(exact == figure(folder, "|--pull|exact", "confidence"));
    assert_true(exact != chord);
    assert_true(figure(folder, "|--pull|chord", "sign_acc") == 1);
    assert_true(figure(folder, "|--pull|axis", "calibration_error") >= 0);
    tool_run(&out, "dragmesh", NULL, "eval|%s|--pull|sideways", folder);
    assert_int_equal(out.status, 2);
    assert_non_null(strstr(out.errors, "--pull"));
    tool_folder_remove(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_exact_is_the_stored_drag),
        cmocka_unit_test(test_chord_leads_to_half_open),
        cmocka_unit_test(test_axis_is_the_nearest_of_the_room),
        cmocka_unit_test(test_slides_are_grabbed_where_stored),
        cmocka_unit_test(test_command),
    };
    return cmocka_run_group_tests_name("eval_pull", tests, NULL, NULL);
}
