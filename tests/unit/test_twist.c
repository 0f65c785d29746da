/* Twists: what is the same joint, what is another, and by how much. */
#include "test_env.h"

#include <math.h>

#include "kinematics/candidates/twist.h"
#include "math/linear3.h"

/* A part of points round (1, 0, 0). */
static dmi_part_analysis* make_study(void) {
    static float points[DMI_TWIST_POINTS][3];
    dmi_part_analysis* study = calloc(1, sizeof *study);
    assert_non_null(study);
    study->points = (const float(*)[3])points;
    for (int i = 0; i < DMI_TWIST_POINTS; i++) {
        const float a = 0.5f * (float)i;
        points[i][0] = 1 + 0.3f * cosf(a), points[i][1] = 0.2f * sinf(a);
        points[i][2] = 0.1f * (float)(i % 3);
    }
    return study;
}

static dmi_candidate joint_of(int32_t type, float x, float y, float z, float at) {
    return (dmi_candidate){.type = type, .axis = {x, y, z}, .origin = {at, 0, 0}};
}

static float differ(const dmi_part_analysis* study, dmi_candidate a, dmi_candidate b) {
    dmi_twist first, second;
    dmi_twist_of_candidate(study, &a, &first);
    dmi_twist_of_candidate(study, &b, &second);
    const float there = dmi_twist_difference(&first, &second);
    assert_true(there == dmi_twist_difference(&second, &first));
    return there;
}

static void signs_and_places_along_the_axis_are_alike(void** state) {
    (void)state;
    dmi_part_analysis* study = make_study();
    dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0), same = joint_of(DM_JOINT_REVOLUTE, 0, 0, -1, 0);
    same.origin[2] = 5;
    assert_true(differ(study, hinge, same) < 2e-3f);
    assert_true(differ(study, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0), joint_of(DM_JOINT_PRISMATIC, 0, -1, 0, 3)) <
                2e-3f);
    free(study);
}

static void others_differ_by_as_much_as_they_are_off(void** state) {
    (void)state;
    dmi_part_analysis* study = make_study();
    const dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0);
    const float near = differ(study, hinge, joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.05f));
    const float far = differ(study, hinge, joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.5f));
    assert_true(near > 1e-3f && near < 0.05f && far > 3 * near && far < 1);
    const float slides =
        differ(study, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0), joint_of(DM_JOINT_PRISMATIC, 1, 0, 0, 0));
    assert_true(slides > 0.999f);
    assert_true(differ(study, hinge, joint_of(DM_JOINT_PRISMATIC, 0, 1, 0, 0)) == 1);
    free(study);
}

static void joints_move_as_their_candidates(void** state) {
    (void)state;
    dmi_part_analysis* study = make_study();
    const dmi_candidate hinge = joint_of(DM_JOINT_REVOLUTE, 0, 0, 1, 0.2f);
    const dm_joint joint = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}, .origin = {0.2f, 0, 0}};
    dmi_twist a, b;
    dmi_twist_of_candidate(study, &hinge, &a);
    dmi_twist_of_joint(study, &joint, &b);
    assert_true(dmi_twist_difference(&a, &b) < 2e-3f);
    free(study);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(signs_and_places_along_the_axis_are_alike),
        cmocka_unit_test(others_differ_by_as_much_as_they_are_off),
        cmocka_unit_test(joints_move_as_their_candidates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
