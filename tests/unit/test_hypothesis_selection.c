/* Which of the ranked candidates becomes the first hypothesis, with a drag and without one. */
#include <math.h>

#include "test_analysis.h"

#include "kinematics/candidates/twist.h"
#include "kinematics/inference/hypothesis_selection.h"

#define TURNS 6

static test_shape shape;
static test_analysis a;

static int open_box(void** state) {
    (void)state;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.8f, 0.1f}, 1);
    test_shape_box(&shape, (const float[]){0, 0, -0.5f}, (const float[]){1, 0.8f, -0.01f}, 0);
    test_analysis_open(&a, &shape, 3);
    return 0;
}

static int close_box(void** state) {
    (void)state;
    test_analysis_close(&a);
    return 0;
}

static dmi_candidate turn_at(double x, float sign) {
    return test_candidate(a.mesh, DM_JOINT_REVOLUTE, (const float[]){0, sign, 0}, (const double[]){x, 0, 0});
}

static dmi_candidate slide_along_z(void) {
    return test_candidate(a.mesh, DM_JOINT_PRISMATIC, (const float[]){0, 0, 1}, (const double[]){0, 0, 0});
}

static float difference(dmi_candidate one, dmi_candidate other) {
    dmi_opened_part opened[2];
    dmi_opened_part_make(&a.of_part, &one, &opened[0]);
    dmi_opened_part_make(&a.of_part, &other, &opened[1]);
    return dmi_opened_part_difference(&opened[0], &opened[1]);
}

static void opened_parts_differ_by_where_they_end(void** state) {
    (void)state;
    assert_float_equal(difference(turn_at(0, 1), turn_at(0, 1)), 0, 1e-6f);
    assert_float_equal(difference(turn_at(0, 1), turn_at(0, -1)), 0, 1e-6f); /* the other way round, the same joint */
    const float beside = 2 * sinf(0.5f) * 0.02f; /* a line 0.02 aside, after 1 rad: the object's size is 1 */
    assert_float_equal(difference(turn_at(0, 1), turn_at(0.02, -1)), beside, 1e-4f);
    assert_true(difference(turn_at(0, 1), turn_at(1, 1)) > 0.5f);
    assert_true(difference(turn_at(0, 1), slide_along_z()) > 0.05f);
}

/* Turns about lines far apart, that have more probability than one slide in sum and less each. */
static void the_likelier_type_counts_with_a_drag_and_the_likelier_pose_without(void** state) {
    (void)state;
    dmi_candidate candidates[TURNS + 1];
    float probability[TURNS + 1];
    for (int i = 0; i < TURNS; i++) candidates[i] = turn_at(0.2 * i, 1), probability[i] = 0.6f / TURNS;
    candidates[TURNS] = slide_along_z(), probability[TURNS] = 0.4f;
    const dmi_ranked_candidates ranked = {&a.of_part, candidates, probability, TURNS + 1};
    static dmi_selected selected[DM_MAX_HYPOTHESES];
    assert_true(dmi_select_hypotheses(&ranked, DMI_SELECT_LIKELIER_TYPE_FIRST, selected) > 1);
    assert_int_equal(selected[0].candidate->type, DM_JOINT_REVOLUTE);
    assert_float_equal(selected[0].type_mass, 0.6f, 1e-5f);
    assert_true(dmi_select_hypotheses(&ranked, DMI_SELECT_BY_POSE, selected) > 1);
    assert_int_equal(selected[0].candidate->type, DM_JOINT_PRISMATIC);
    assert_float_equal(selected[0].type_mass, 0.4f, 1e-5f);
}

/* Two lines that open the part alike are together likelier than a third one far away. */
static void near_lines_support_each_other(void** state) {
    (void)state;
    const dmi_candidate candidates[] = {turn_at(0, 1), turn_at(0.004, -1), turn_at(1, 1)};
    const float probability[] = {0.31f, 0.3f, 0.39f};
    const dmi_ranked_candidates ranked = {&a.of_part, candidates, probability, 3};
    static dmi_selected selected[DM_MAX_HYPOTHESES];
    assert_int_equal(dmi_select_hypotheses(&ranked, DMI_SELECT_BY_POSE, selected), 2);
    assert_ptr_equal(selected[0].candidate, &candidates[0]);
    assert_ptr_equal(selected[1].candidate, &candidates[2]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opened_parts_differ_by_where_they_end),
        cmocka_unit_test(the_likelier_type_counts_with_a_drag_and_the_likelier_pose_without),
        cmocka_unit_test(near_lines_support_each_other),
    };
    return cmocka_run_group_tests(tests, open_box, close_box);
}
