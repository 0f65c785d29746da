/* What tells how far a joint goes: the way a sweep finds free, which way a lid shuts, how proud a button stands. */
#include "test_analysis.h"

#include <math.h>

#include "kinematics/limits/limits.h"
#include "kinematics/limits/sweep.h"
#include "test_world.h"

enum { DOWN = 4, AROUND = 28 };

static test_shape shape;
static test_analysis a;

/* In the object's coordinates. */
static dm_joint joint_at(int32_t type, const float axis[3], const double origin[3]) {
    float point[3];
    dmi_frame_point_in(&a.mesh->frame, origin, point);
    return (dm_joint){.type = type, .axis = {axis[0], axis[1], axis[2]}, .origin = {point[0], point[1], point[2]}};
}

/* A tray, and a lid that stands up at its back edge, leaning back a little. */
static void make_open_lid(void) {
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.05f, 0.7f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.06f, -0.04f}, (const float[]){1, 0.76f, 0}, 1);
}

static void an_open_lid_knows_which_way_it_shuts(void** state) {
    (void)state;
    float features[DMI_LIMIT_FEATURES];
    make_open_lid();
    test_analysis_open(&a, &shape, 5);
    /* Positive leads on backwards. */
    const dm_joint joint = joint_at(DM_JOINT_REVOLUTE, (const float[]){-1, 0, 0}, (const double[]){0.5, 0.06, -0.02});
    assert_float_equal(dmi_limits_features(&a.of_part, NULL, 1, &joint, features), 1, 0);
    for (int k = 0; k < DMI_LIMIT_FEATURES; k++) assert_true(isfinite(features[k]));
    assert_true(features[DOWN + 1] < -1.2f && features[DOWN + 1] > -1.8f); /* jammed when shut */
    assert_float_equal(features[AROUND], 0, 0.25f);                        /* a right angle from the tray … */
    assert_true(features[AROUND + 1] < -0.9f);                             /* … that lies on the shutting side */
    test_analysis_close(&a);
}

/* A button of 0.04 with a quarter of it proud of its panel. */
static void a_button_knows_how_proud_it_stands(void** state) {
    (void)state;
    float features[DMI_LIMIT_FEATURES];
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){-0.5f, -0.1f, -0.1f}, (const float[]){0.5f, 0, 0.1f}, 0);
    test_shape_box(&shape, (const float[]){-0.03f, -0.03f, -0.03f}, (const float[]){0.03f, 0.01f, 0.03f}, 1);
    test_analysis_open(&a, &shape, 5);
    const dm_joint joint = joint_at(DM_JOINT_PRISMATIC, (const float[]){0, -1, 0}, (const double[]){0, 0, 0});
    assert_float_equal(dmi_limits_features(&a.of_part, NULL, 1, &joint, features), 0.04f, 0.004f);
    assert_true(features[AROUND] > 0);
    assert_float_equal(features[AROUND + 2], 0.25f, 0.12f); /* the panel begins a quarter below the button's top */
    test_analysis_close(&a);
}

static void a_sweep_stops_at_the_body(void** state) {
    (void)state;
    float reach[2];
    make_open_lid();
    test_analysis_open(&a, &shape, 5);
    const dm_joint joint = joint_at(DM_JOINT_REVOLUTE, (const float[]){-1, 0, 0}, (const double[]){0.5, 0.06, -0.02});
    dmi_sweep sweep;
    dmi_sweep_make(&a.of_part, &joint, &sweep);
    dmi_sweep_reach(&sweep, DMI_SWEEP_TURN, 20, reach);
    assert_float_equal(reach[1], 1, 0.01f); /* nothing behind it */
    dmi_sweep_reach(&sweep, -DMI_SWEEP_TURN, DMI_SWEEP_TURNS, reach);
    assert_true(reach[0] <= 0 && reach[1] <= reach[0] && reach[1] > -1.8f);
    assert_true(dmi_sweep_clearance(&sweep, -1.5f).mean < dmi_sweep_clearance(&sweep, 0).mean);
    test_analysis_close(&a);
}

/* Whichever way the axis pointed. */
static void without_a_drag_the_longer_way_is_positive(void** state) {
    (void)state;
    make_open_lid();
    test_analysis_open(&a, &shape, 5);
    for (int way = -1; way <= 1; way += 2) {
        dm_joint joint =
            joint_at(DM_JOINT_REVOLUTE, (const float[]){(float)way, 0, 0}, (const double[]){0.5, 0.06, -0.02});
        dmi_limits_set(&a.of_part, NULL, 0, NULL, DMI_ISA_SCALAR, NULL, &joint, 1);
        assert_true(joint.upper > 1 && -joint.lower <= joint.upper);
        assert_float_equal(joint.axis.x, -1, 0); /* nothing stops it on the way back */
    }
    test_analysis_close(&a);
}

/* By rules, without networks: a lid that nothing stops opens a quarter turn; a drawer stays on its runners. */
static void rules_open_a_quarter_turn(void** state) {
    (void)state;
    shape.vertex_count = shape.face_count = 0;
    test_shape_box(&shape, (const float[]){0, 0, 0}, (const float[]){1, 0.3f, 0.7f}, 0);
    test_shape_box(&shape, (const float[]){0, 0.31f, 0}, (const float[]){1, 0.33f, 0.7f}, 1);
    test_analysis_open(&a, &shape, 5);
    dm_joint turn = joint_at(DM_JOINT_REVOLUTE, (const float[]){-1, 0, 0}, (const double[]){0.5, 0.32, -0.02});
    dmi_limits_set(&a.of_part, NULL, 1, NULL, DMI_ISA_SCALAR, NULL, &turn, 1);
    assert_float_equal(turn.lower, 0, 0);
    assert_float_equal(turn.upper, 1.5707963f, 1e-5f);
    dm_joint slide = joint_at(DM_JOINT_PRISMATIC, (const float[]){0, 0, 1}, (const double[]){0.5, 0.32, 0});
    dmi_limits_set(&a.of_part, NULL, 1, NULL, DMI_ISA_SCALAR, NULL, &slide, 1);
    assert_float_equal(slide.lower, 0, 0);
    assert_float_equal(slide.upper, 0.8f * 0.7f, 0.01f); /* of its depth; the object's largest side is 1 */
    test_analysis_close(&a);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_open_lid_knows_which_way_it_shuts),
        cmocka_unit_test(a_button_knows_how_proud_it_stands),
        cmocka_unit_test(a_sweep_stops_at_the_body),
        cmocka_unit_test(without_a_drag_the_longer_way_is_positive),
        cmocka_unit_test(rules_open_a_quarter_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
