/* Joints as values: the value of a pose, the frame of a physics constraint, the joint of a scaled instance. */
#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "test_world.h"

static float random_float(uint32_t* state, float low, float high) {
    *state = *state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(*state >> 8) / 16777216.0f;
}

static dm_vec3 random_axis(uint32_t* state) {
    const dm_vec3 a = {random_float(state, -1, 1), random_float(state, -1, 1), random_float(state, -1, 1)};
    const float length = sqrtf(a.x * a.x + a.y * a.y + a.z * a.z);
    return (dm_vec3){a.x / length, a.y / length, a.z / length};
}

static dm_joint random_joint(uint32_t* state, int32_t type) {
    dm_joint joint = {.struct_size = sizeof joint, .type = type, .axis = random_axis(state)};
    joint.origin = (dm_vec3){random_float(state, -2, 2), random_float(state, -2, 2), random_float(state, -2, 2)};
    if (type == DM_JOINT_SCREW) joint.pitch = random_float(state, 0.02f, 0.2f);
    return joint;
}

static void value_is_the_inverse_of_pose(void** state) {
    (void)state;
    uint32_t seed = 1;
    for (int i = 0; i < 2000; i++) {
        const int32_t type = DM_JOINT_REVOLUTE + i % 4;
        dm_joint joint = random_joint(&seed, type);
        float most = type == DM_JOINT_SCREW ? 40 : 3.1f; /* a screw tells its turns by its advance */
        if (type == DM_JOINT_REVOLUTE && i % 8 == 0) joint.lower = -0.5f, joint.upper = 5.7f;
        const float value = joint.upper > 0 ? random_float(&seed, -0.5f, 5.7f) : random_float(&seed, -most, most);
        dm_pose pose;
        float found, angle, distance;
        assert_int_equal(dm_joint_pose(&joint, value, &pose), DM_OK);
        assert_int_equal(dm_joint_value(&joint, &pose, &found, &angle, &distance), DM_OK);
        if (!(fabsf(found - value) < 1e-3f)) fail_msg("type %d: %g, not %g", type, (double)found, (double)value);
        assert_true(angle < 1e-3f && distance < 1e-3f);
        for (int k = 0; k < 4; k++) pose.real[k] = -pose.real[k], pose.dual[k] = -pose.dual[k]; /* the same pose */
        assert_int_equal(dm_joint_value(&joint, &pose, &found, NULL, NULL), DM_OK);
        assert_true(fabsf(found - value) < 1e-3f);
    }
}

static void axes_have_any_length_but_none(void** state) {
    (void)state;
    uint32_t seed = 5;
    for (int i = 0; i < 200; i++) {
        const dm_joint joint = random_joint(&seed, DM_JOINT_REVOLUTE + i % 4);
        dm_joint longer = joint;
        dm_pose pose, same;
        longer.axis = (dm_vec3){7 * joint.axis.x, 7 * joint.axis.y, 7 * joint.axis.z};
        assert_int_equal(dm_joint_pose(&joint, 0.4f, &pose), DM_OK);
        assert_int_equal(dm_joint_pose(&longer, 0.4f, &same), DM_OK);
        for (int k = 0; k < 4; k++) {
            assert_true(fabsf(same.real[k] - pose.real[k]) < 1e-5f);
            assert_true(fabsf(same.dual[k] - pose.dual[k]) < 1e-5f);
        }
        longer.axis = (dm_vec3){0, 0, 0};
        assert_int_equal(dm_joint_pose(&longer, 0.4f, &same), DM_ERROR_INVALID_ARGUMENT);
        longer.type = DM_JOINT_FIXED;
        assert_int_equal(dm_joint_pose(&longer, 0.4f, &same), DM_OK);
        assert_float_equal(same.real[3], 1, 0);
    }
}

static void value_says_how_far_off_the_joint_a_pose_is(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    dm_joint tilt = hinge;
    dm_pose pose, off;
    float value, angle, distance;
    tilt.axis = (dm_vec3){1, 0, 0};
    assert_int_equal(dm_joint_pose(&hinge, 0.8f, &pose), DM_OK);
    assert_int_equal(dm_joint_pose(&tilt, 0.1f, &off), DM_OK); /* turned out of its way at the hinge */
    dm_pose_multiply(&off, &pose, &off);
    assert_int_equal(dm_joint_value(&hinge, &off, &value, &angle, &distance), DM_OK);
    assert_true(fabsf(value - 0.8f) < 0.01f && fabsf(angle - 0.1f) < 0.01f && distance < 1e-5f);
    const dm_pose lift = {.real = {0, 0, 0, 1}, .dual = {0, 0.015f, 0, 0}}; /* lifted by 0.03 */
    dm_pose_multiply(&lift, &pose, &off);
    assert_int_equal(dm_joint_value(&hinge, &off, &value, &angle, &distance), DM_OK);
    assert_true(fabsf(value - 0.8f) < 1e-4f && angle < 1e-3f && fabsf(distance - 0.03f) < 1e-5f);
    dm_joint slide = {.struct_size = sizeof slide, .type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}, .upper = 1};
    assert_int_equal(dm_joint_value(&slide, &lift, &value, &angle, &distance), DM_OK);
    assert_true(fabsf(value - 0.03f) < 1e-6f && distance < 1e-6f);
    slide.type = DM_JOINT_FIXED;
    assert_int_equal(dm_joint_value(&slide, &lift, &value, &angle, &distance), DM_OK);
    assert_true(value == 0 && fabsf(distance - 0.03f) < 1e-6f);
}

static float dot(dm_vec3 a, dm_vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static void frames_are_orthonormal_about_the_axis(void** state) {
    (void)state;
    uint32_t seed = 5;
    for (int i = 0; i < 1000; i++) {
        dm_joint joint = random_joint(&seed, DM_JOINT_REVOLUTE + i % 3);
        if (i < 6) joint.axis = (dm_vec3){0, 0, 0}, (&joint.axis.x)[i / 2] = i % 2 ? 1.0f : -1.0f;
        joint.lower = -0.25f, joint.upper = 1.5f;
        dm_joint_frame f = dm_joint_frame_default();
        assert_int_equal(dm_joint_get_frame(&joint, &f), DM_OK);
        assert_true(fabsf(dot(f.x, joint.axis) - 1) < 1e-5f && fabsf(dot(f.y, f.y) - 1) < 1e-5f);
        assert_true(fabsf(dot(f.x, f.y)) + fabsf(dot(f.y, f.z)) + fabsf(dot(f.z, f.x)) < 3e-6f);
        const dm_vec3 cross = {f.x.y * f.y.z - f.x.z * f.y.y, f.x.z * f.y.x - f.x.x * f.y.z,
                               f.x.x * f.y.y - f.x.y * f.y.x};
        assert_true(fabsf(dot(cross, f.z) - 1) < 1e-5f);
        const dm_pose turn = {.real = {f.rotation[0], f.rotation[1], f.rotation[2], f.rotation[3]}};
        float x[3] = {1, 0, 0}; /* the quaternion says the same */
        dm_pose_apply_points(&turn, x, 0, x, 0, 1);
        assert_true(fabsf(x[0] - f.x.x) + fabsf(x[1] - f.x.y) + fabsf(x[2] - f.x.z) < 1e-5f);
        assert_true(f.limits == (DM_LIMIT_LOWER | DM_LIMIT_UPPER) && f.lower == -0.25f && f.upper == 1.5f);
        assert_true(f.pitch == joint.pitch && f.type == joint.type && f.origin.x == joint.origin.x);
    }
}

static void frames_tell_which_limits_there_are(void** state) {
    (void)state;
    const struct {
        int32_t type;
        float lower, upper;
        uint32_t limits;
    } cases[] = {{DM_JOINT_REVOLUTE, 0, 0, 0},
                 {DM_JOINT_CONTINUOUS, -1, 1, 0},
                 {DM_JOINT_FIXED, -1, 1, 0},
                 {DM_JOINT_REVOLUTE, 0, FLT_MAX, DM_LIMIT_LOWER},
                 {DM_JOINT_PRISMATIC, (float)-INFINITY, 0.4f, DM_LIMIT_UPPER},
                 {DM_JOINT_PRISMATIC, -FLT_MAX, 1e10f, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        dm_joint joint = test_hinge();
        joint.type = cases[i].type, joint.lower = cases[i].lower, joint.upper = cases[i].upper;
        dm_joint_frame frame = dm_joint_frame_default();
        assert_int_equal(dm_joint_get_frame(&joint, &frame), DM_OK);
        assert_int_equal(frame.limits, cases[i].limits);
        assert_true(isfinite(frame.lower) && isfinite(frame.upper));
    }
}

/* The joint of the scaled instance moves scaled points where the scale takes the moved ones: exactly so for slides and
 * for equal scales. */
static void scaled_joints_move_scaled_points(void** state) {
    (void)state;
    uint32_t seed = 9;
    for (int i = 0; i < 400; i++) {
        const bool slides = i % 2 == 0, mirrored = i % 4 == 1;
        const dm_joint joint = random_joint(&seed, slides       ? DM_JOINT_PRISMATIC
                                                   : i % 8 == 3 ? DM_JOINT_SCREW
                                                                : DM_JOINT_REVOLUTE);
        const float s = random_float(&seed, 0.3f, 3);
        const dm_vec3 scale = slides ? (dm_vec3){s, -2 * s, 0.5f} : (dm_vec3){mirrored ? -s : s, s, s};
        const float value = random_float(&seed, -1, 1), at[3] = {0.3f, -0.7f, 1.1f};
        dm_joint there = dm_joint_default();
        dm_pose pose, scaled;
        float p[3], q[3] = {at[0] * scale.x, at[1] * scale.y, at[2] * scale.z};
        assert_int_equal(dm_joint_scale(&joint, scale, &there), DM_OK);
        const dm_vec3 a = {joint.axis.x * scale.x, joint.axis.y * scale.y, joint.axis.z * scale.z};
        const float stretch = slides ? sqrtf(dot(a, a)) : 1;
        assert_int_equal(dm_joint_pose(&joint, value, &pose), DM_OK);
        assert_int_equal(dm_joint_pose(&there, value * stretch, &scaled), DM_OK);
        dm_pose_apply_points(&pose, at, 0, p, 0, 1);
        dm_pose_apply_points(&scaled, q, 0, q, 0, 1);
        const float off = fabsf(p[0] * scale.x - q[0]) + fabsf(p[1] * scale.y - q[1]) + fabsf(p[2] * scale.z - q[2]);
        assert_true(off < 1e-4f);
    }
    dm_joint hinge = test_hinge(), same = dm_joint_default();
    assert_int_equal(dm_joint_scale(&hinge, (dm_vec3){0, 0, 0}, &same), DM_OK); /* zeros are ones */
    assert_memory_equal(&hinge, &same, sizeof same);
    assert_int_equal(dm_joint_scale(&hinge, (dm_vec3){1, 0, 1}, &same), DM_ERROR_INVALID_ARGUMENT);
}

static void nonsense_is_refused(void** state) {
    (void)state;
    dm_joint hinge = test_hinge(), none = {0}, out = dm_joint_default();
    dm_joint_frame frame = dm_joint_frame_default(), small = {0};
    const dm_pose rest = {.real = {0, 0, 0, 1}}, broken = {.real = {(float)NAN, 0, 0, 1}}, empty = {.real = {0}};
    dm_pose pose;
    float value;
    assert_int_equal(dm_joint_value(NULL, &rest, &value, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_value(&hinge, NULL, &value, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_value(&hinge, &rest, NULL, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_value(&hinge, &broken, &value, NULL, NULL), DM_ERROR_NOT_FINITE);
    assert_int_equal(dm_joint_value(&hinge, &empty, &value, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_value(&none, &rest, &value, NULL, NULL), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_joint_pose(&none, 0, &pose), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_joint_get_frame(&hinge, &small), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_joint_get_frame(&hinge, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_scale(&hinge, (dm_vec3){1, 1, 1}, &none), DM_ERROR_STRUCT_SIZE);
    assert_int_equal(dm_joint_scale(&hinge, (dm_vec3){(float)NAN, 1, 1}, &out), DM_ERROR_NOT_FINITE);
    hinge.axis = (dm_vec3){0, 0, 0};
    assert_int_equal(dm_joint_get_frame(&hinge, &frame), DM_ERROR_INVALID_ARGUMENT);
    hinge.axis.x = (float)INFINITY;
    assert_int_equal(dm_joint_get_frame(&hinge, &frame), DM_ERROR_NOT_FINITE);
}

static void limits_that_are_none_stay_none_when_scaled(void** state) {
    (void)state;
    const dm_joint slide = {
        .struct_size = sizeof slide, .type = DM_JOINT_PRISMATIC, .axis = {0, 0, 1}, .lower = -FLT_MAX, .upper = 2e38f};
    dm_joint out = dm_joint_default();
    assert_int_equal(dm_joint_scale(&slide, (dm_vec3){1, 1, 3}, &out), DM_OK);
    assert_true(out.lower == -FLT_MAX && out.upper == FLT_MAX);
}

/* Finite numbers of which infinite ones would come. */
static void what_does_not_fit_a_float_is_refused(void** state) {
    (void)state;
    const dm_joint hinge = test_hinge();
    dm_joint far = hinge, screw = hinge, long_axis = hinge, out = dm_joint_default();
    dm_joint_frame frame = dm_joint_frame_default();
    const dm_pose away = {{0, 0, 0, 1}, {0, 2e38f, 0, 0}};
    dm_pose pose;
    float value;
    far.origin.x = 3e38f;
    screw.type = DM_JOINT_SCREW, screw.pitch = 1e30f;
    long_axis.axis = (dm_vec3){3e38f, 3e38f, 0};
    assert_int_equal(dm_joint_pose(&far, 3, &pose), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_pose(&screw, 3, &pose), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_pose(&hinge, 3e38f, &pose), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_value(&hinge, &away, &value, NULL, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_get_frame(&long_axis, &frame), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_scale(&far, (dm_vec3){10, 10, 10}, &out), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_joint_scale(&hinge, (dm_vec3){1e30f, 1, 1}, &out), DM_ERROR_INVALID_ARGUMENT);
}

static void poses_are_made_of_rotation_and_translation(void** state) {
    (void)state;
    const float turn[4] = {0, 3, 0, 3}; /* a quarter turn about y, not of length 1 */
    const dm_vec3 lift = {1, 2, 3};
    dm_pose pose, back;
    assert_int_equal(dm_pose_from_rotation(turn, lift, &pose), DM_OK);
    float point[3] = {1, 0, 0};
    dm_pose_apply_points(&pose, point, 0, point, 0, 1);
    assert_true(fabsf(point[0] - 1) < 1e-6f && fabsf(point[1] - 2) < 1e-6f && fabsf(point[2] - 2) < 1e-6f);
    dm_pose_inverse(&pose, &back);
    dm_pose_apply_points(&back, point, 0, point, 0, 1);
    assert_true(fabsf(point[0] - 1) < 1e-6f && fabsf(point[1]) < 1e-6f && fabsf(point[2]) < 1e-6f);
    const dm_pose kept = back;
    const float none[4] = {0, 0, 0, 0}, bad[4] = {0, NAN, 0, 1};
    assert_int_equal(dm_pose_from_rotation(none, lift, &back), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_pose_from_rotation(bad, lift, &back), DM_ERROR_NOT_FINITE);
    assert_int_equal(dm_pose_from_rotation(turn, (dm_vec3){0, INFINITY, 0}, &back), DM_ERROR_NOT_FINITE);
    assert_int_equal(dm_pose_from_rotation(turn, (dm_vec3){0, 1e30f, 0}, &back), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_pose_from_rotation(NULL, lift, &back), DM_ERROR_INVALID_ARGUMENT);
    assert_int_equal(dm_pose_from_rotation(turn, lift, NULL), DM_ERROR_INVALID_ARGUMENT);
    assert_memory_equal(&back, &kept, sizeof kept);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(value_is_the_inverse_of_pose),
        cmocka_unit_test(poses_are_made_of_rotation_and_translation),
        cmocka_unit_test(axes_have_any_length_but_none),
        cmocka_unit_test(value_says_how_far_off_the_joint_a_pose_is),
        cmocka_unit_test(frames_are_orthonormal_about_the_axis),
        cmocka_unit_test(frames_tell_which_limits_there_are),
        cmocka_unit_test(scaled_joints_move_scaled_points),
        cmocka_unit_test(nonsense_is_refused),
        cmocka_unit_test(limits_that_are_none_stay_none_when_scaled),
        cmocka_unit_test(what_does_not_fit_a_float_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
