/* What lies on the axis of a candidate joint. */
#include "kinematics/features/feature_groups.h"
#include "test_analysis.h"

#define AROUND 16

/* A tube along y, open at its ends. */
static void add_tube(test_shape* shape, float x, float z, float radius, float low, float high, uint32_t part) {
    uint32_t ring[AROUND][2];
    for (int i = 0; i < AROUND; i++) {
        const float angle = 6.2831853f * (float)i / AROUND;
        for (int end = 0; end < 2; end++)
            ring[i][end] =
                test_shape_vertex(shape, x + radius * cosf(angle), end ? high : low, z + radius * sinf(angle));
    }
    for (int i = 0; i < AROUND; i++) {
        const int next = (i + 1) % AROUND;
        test_shape_face(shape, ring[i][0], ring[i][1], ring[next][1], part);
        test_shape_face(shape, ring[i][0], ring[next][1], ring[next][0], part);
    }
}

/* A gate leaf on a post: two knuckles on the leaf, a third between them on the post. */
static void make_gate(test_shape* shape) {
    test_shape_box(shape, (const float[]){-0.2f, 0, -0.1f}, (const float[]){-0.03f, 1, 0.1f}, 0);
    add_tube(shape, 0, 0, 0.02f, 0.45f, 0.55f, 0);
    test_shape_box(shape, (const float[]){0.03f, 0, -0.01f}, (const float[]){0.8f, 1, 0.01f}, 1);
    add_tube(shape, 0, 0, 0.02f, 0.1f, 0.2f, 1);
    add_tube(shape, 0, 0, 0.02f, 0.8f, 0.9f, 1);
}

static void check_gate(const dmi_mesh* mesh, const dmi_part_analysis* analysis) {
    const float up[3] = {0, 1, 0}, front[3] = {0, 0, 1};
    const dmi_candidate hinge = test_candidate(mesh, DM_JOINT_REVOLUTE, up, (const double[]){0, 0.5, 0});
    const dmi_candidate edge = test_candidate(mesh, DM_JOINT_REVOLUTE, up, (const double[]){0.8, 0.5, 0});
    const dmi_candidate slide = test_candidate(mesh, DM_JOINT_PRISMATIC, front, (const double[]){0.4, 0.5, 0});
    float of_hinge[DMI_FEATURE_COUNT], of_edge[DMI_FEATURE_COUNT], of_slide[DMI_FEATURE_COUNT];
    dmi_axis_hardware_features(analysis, &hinge, of_hinge);
    dmi_axis_hardware_features(analysis, &edge, of_edge);
    dmi_axis_hardware_features(analysis, &slide, of_slide);
    assert_true(of_hinge[DMI_FEATURE_ROUND_PART_COUNT] > 1.9f && of_hinge[DMI_FEATURE_ROUND_BODY_COUNT] > 0.9f);
    assert_true(of_hinge[DMI_FEATURE_ROUND_PAIR] > 0.9f);
    assert_true(of_hinge[DMI_FEATURE_CENTRED_PART_COUNT] > 1.9f && of_hinge[DMI_FEATURE_CENTRED_BODY_COUNT] > 0.9f);
    /* From the one knuckle's middle to the other's, over the leaf's diagonal. */
    assert_float_equal(of_hinge[DMI_FEATURE_HARDWARE_SPAN], 0.7f / sqrtf(0.82f * 0.82f + 1), 0.02f);
    for (int k = DMI_FEATURE_ROUND_PAIR; k < DMI_FEATURE_HARDWARE_SPAN; k++) assert_true(of_edge[k] < 0.01f);
    assert_true(of_slide[DMI_FEATURE_ROUND_PAIR] < 0.01f);
    for (int k = DMI_FEATURE_CENTRED_PART_COUNT; k <= DMI_FEATURE_CONTACT_CLOSE; k++)
        assert_float_equal(of_slide[k], 0, 0);
}

static void knuckles_lie_on_the_hinge(void** state) {
    (void)state;
    test_with_analysis(make_gate, check_gate);
}

/* A plunger in its barrel goes along their common line, and turns about it as well. */
static void make_plunger(test_shape* shape) {
    add_tube(shape, 0, 0, 0.1f, 0, 0.5f, 0);
    add_tube(shape, 0, 0, 0.095f, 0.2f, 0.7f, 1);
}

static void check_plunger(const dmi_mesh* mesh, const dmi_part_analysis* analysis) {
    const float up[3] = {0, 1, 0}, right[3] = {1, 0, 0};
    const dmi_candidate along = test_candidate(mesh, DM_JOINT_PRISMATIC, up, (const double[]){0, 0.45, 0});
    const dmi_candidate across = test_candidate(mesh, DM_JOINT_PRISMATIC, right, (const double[]){0, 0.45, 0});
    const dmi_candidate turn = test_candidate(mesh, DM_JOINT_CONTINUOUS, up, (const double[]){0, 0.45, 0});
    float of_along[DMI_FEATURE_COUNT], of_across[DMI_FEATURE_COUNT], of_turn[DMI_FEATURE_COUNT];
    dmi_axis_hardware_features(analysis, &along, of_along);
    dmi_axis_hardware_features(analysis, &across, of_across);
    dmi_axis_hardware_features(analysis, &turn, of_turn);
    assert_true(of_along[DMI_FEATURE_ROUND_PAIR] > 0.9f && of_turn[DMI_FEATURE_ROUND_PAIR] > 0.9f);
    assert_true(of_across[DMI_FEATURE_ROUND_PAIR] < 0.01f);
}

static void a_plunger_shares_its_line_with_the_barrel(void** state) {
    (void)state;
    test_with_analysis(make_plunger, check_plunger);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(knuckles_lie_on_the_hinge),
        cmocka_unit_test(a_plunger_shares_its_line_with_the_barrel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
