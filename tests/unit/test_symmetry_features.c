/* Likeness of a part and its body to their mirror images. */
#include "kinematics/features/feature_groups.h"
#include "test_analysis.h"

/* Two doors of a cupboard, the left of which moves; it has a handle near the middle, high up. */
static void make_cupboard(test_shape* shape) {
    test_shape_box(shape, (const float[]){0, 0, -0.4f}, (const float[]){0.8f, 0.6f, 0}, 0);
    test_shape_box(shape, (const float[]){0.402f, 0, 0.002f}, (const float[]){0.8f, 0.6f, 0.022f}, 0);
    test_shape_box(shape, (const float[]){0, 0, 0.002f}, (const float[]){0.398f, 0.6f, 0.022f}, 1);
    test_shape_box(shape, (const float[]){0.33f, 0.3f, 0.022f}, (const float[]){0.37f, 0.55f, 0.08f}, 1);
}

/* Hinged on the outside, the door has its twin beyond its free side; in the middle, beyond the hinge. */
static void check_twins(const dmi_mesh* mesh, const dmi_part_analysis* analysis) {
    dmi_symmetry symmetry;
    dmi_symmetry_begin(analysis, &symmetry);
    const float up[3] = {0, 1, 0};
    const dmi_candidate outside = test_candidate(mesh, DM_JOINT_REVOLUTE, up, (const double[]){0, 0.3, 0.002});
    const dmi_candidate inside = test_candidate(mesh, DM_JOINT_REVOLUTE, up, (const double[]){0.4, 0.3, 0.002});
    float of_outside[DMI_FEATURE_COUNT], of_inside[DMI_FEATURE_COUNT];
    dmi_symmetry_features(&symmetry, &outside, of_outside);
    dmi_symmetry_features(&symmetry, &inside, of_inside);
    assert_true(of_outside[DMI_FEATURE_TWIN_AWAY] < 0.06f && of_outside[DMI_FEATURE_TWIN_TOWARDS] > 0.1f);
    assert_true(of_inside[DMI_FEATURE_TWIN_AWAY] > 0.1f && of_inside[DMI_FEATURE_TWIN_TOWARDS] < 0.06f);
}

static void a_doors_twin_is_seen(void** state) {
    (void)state;
    test_with_analysis(make_cupboard, check_twins);
}

/* Across a flap's hinge door and cupboard are more their own images than in a mirror that stands askew. */
static void check_middles(const dmi_mesh* mesh, const dmi_part_analysis* analysis) {
    dmi_symmetry symmetry;
    dmi_symmetry_begin(analysis, &symmetry);
    const float right[3] = {1, 0, 0}, leaning[3] = {0.8f, 0.6f, 0};
    const dmi_candidate flap = test_candidate(mesh, DM_JOINT_REVOLUTE, right, (const double[]){0.2, 0, 0.002});
    const dmi_candidate askew = test_candidate(mesh, DM_JOINT_REVOLUTE, leaning, (const double[]){0.2, 0, 0.002});
    float straight[DMI_FEATURE_COUNT], tilted[DMI_FEATURE_COUNT];
    dmi_symmetry_features(&symmetry, &flap, straight);
    dmi_symmetry_features(&symmetry, &askew, tilted);
    for (int k = 0; k < 2; k++) {
        assert_true(straight[DMI_FEATURE_MIRROR_AXIS_PART + k] < tilted[DMI_FEATURE_MIRROR_AXIS_PART + k]);
        assert_true(straight[DMI_FEATURE_MIRROR_AXIS_PART + k] >= 0 &&
                    tilted[DMI_FEATURE_MIRROR_AXIS_PART + k] <= 0.25f);
    }
    /* The left door's middle is a quarter of the cupboard's width from the cupboard's. */
    assert_float_equal(straight[DMI_FEATURE_MIRROR_AXIS_OFFSET], 0.25f, 0.02f);
}

static void a_door_is_its_own_image_across_its_sides(void** state) {
    (void)state;
    test_with_analysis(make_cupboard, check_middles);
}

/* Of the mirrors along a slide, the one in which the part is more its own image comes first. */
static void check_slide(const dmi_mesh* mesh, const dmi_part_analysis* analysis) {
    dmi_symmetry symmetry;
    dmi_symmetry_begin(analysis, &symmetry);
    const float front[3] = {0, 0, 1};
    const dmi_candidate slide = test_candidate(mesh, DM_JOINT_PRISMATIC, front, (const double[]){0.2, 0.3, 0});
    float out[DMI_FEATURE_COUNT];
    dmi_symmetry_features(&symmetry, &slide, out);
    assert_true(out[DMI_FEATURE_MIRROR_TOWARDS_PART] <= out[DMI_FEATURE_MIRROR_SIDE_PART]);
}

static void a_slide_has_its_best_mirror_first(void** state) {
    (void)state;
    test_with_analysis(make_cupboard, check_slide);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_doors_twin_is_seen),
        cmocka_unit_test(a_door_is_its_own_image_across_its_sides),
        cmocka_unit_test(a_slide_has_its_best_mirror_first),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
