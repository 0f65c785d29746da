/* Twists: differences between equal, similar and other joints. */
#include "test_env.h"

#include <math.h>

#include "kinematics/candidates/twist.h"
#include "math/linear3.h"

/* Makes a part whose points lie around (1, 0, 0). */
static dmi_part_analysis* make_analysis(void) {
    static float points[DMI_TWIST_POINTS][3];
    dmi_part_analysis* analysis = calloc(1, sizeof *analysis);
    assert_non_null(analysis);
    analysis->points = (const float(*)[3])points;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) {
        const float a = 0.5f * (float)i;
        points[i][0] = 1 + 0.3f * cosf(a), points[i][1] = 0.2f * sinf(a);
        points[i][2] = 0.1f * (float)(i % 3);
    }
    return analysis;
}

static dmi_candidate joint_of(int32_t type, float x, float y, float z, float at) {
    return (dmi_candidate){.type = type, .axis = {x, y, z}, .origin = {at, 0, 0}};
}

static float difference_of(const dmi_part_analysis* analysis, dmi_candidate a, dmi_candidate b) {
    dmi_twist first, second;
    dmi_twist_of_candidate(analysis, &a, &first);
    dmi_twist_of_candidate(analysis, &b, &second);
    const float difference = dmi_twist_difference(&first, &second);
    assert_true(difference == dmi_twist_difference(&second, &first));
    return difference;
}

static void sign_and_position_along_the_axis_do_not_matter(void** state) {
    (void)state;
    dmi_part_analysis* analysis = make_analysis();
    dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0), same = joint_of(DM_JOINT_REVOLUTE, 0, 0, -1, 0);
    same.origin[2] = 5;
    assert_true(difference_of(analysis, hinge, same) < 2e-3f);
    assert_true(difference_of(analysis, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0),
                              joint_of(DM_JOINT_PRISMATIC, 0, -1, 0, 3)) < 2e-3f);
    free(analysis);
}

static void difference_grows_with_the_offset_of_the_axis(void** state) {
    (void)state;
    dmi_part_analysis* analysis = make_analysis();
    const dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0);
    const float near = difference_of(analysis, hinge, joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.05f));
    const float far = difference_of(analysis, hinge, joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.5f));
    assert_true(near > 1e-3f && near < 0.05f && far > 3 * near && far < 1);
    const float perpendicular =
        difference_of(analysis, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0), joint_of(DM_JOINT_PRISMATIC, 1, 0, 0, 0));
    assert_true(perpendicular > 0.999f);
    assert_true(difference_of(analysis, hinge, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0)) == 1);
    free(analysis);
}

static void joints_and_their_candidates_have_equal_twists(void** state) {
    (void)state;
    dmi_part_analysis* analysis = make_analysis();
    const dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.2f);
    const dm_joint joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}, .origin = {0.2f, 0, 0}};
    dmi_twist a, b;
    dmi_twist_of_candidate(analysis, &hinge, &a);
    dmi_twist_of_joint(analysis, &joint, &b);
    assert_true(dmi_twist_difference(&a, &b) < 2e-3f);
    free(analysis);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sign_and_position_along_the_axis_do_not_matter),
        cmocka_unit_test(difference_grows_with_the_offset_of_the_axis),
        cmocka_unit_test(joints_and_their_candidates_have_equal_twists),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
