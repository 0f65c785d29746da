/* Joints: poses on the screw, projection of any pose, velocities. */
#include "test_math.h"

enum { CASES = 2000 };
#define PI 3.14159265358979f

static const int32_t moving_types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};

static void poses_keep_to_the_joint(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 2);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, moving_types[i % 4], 1);
        const float value = test_range(&random, -3, 3), along = test_range(&random, -1, 1);
        dm_pose pose = dmi_joint_pose(&joint, value);
        assert_is_unit(&pose, 2e-6);
        /* A point of the axis line moves along it, by the pitch's or the slide's share. */
        const float advance[] = {0, value, value * joint.pitch, 0};
        float p[3] = {joint.origin.x + along * joint.axis.x, joint.origin.y + along * joint.axis.y,
                      joint.origin.z + along * joint.axis.z};
        float moved[3], expected[3];
        dmi_pose_apply(&pose, p, moved);
        expected[0] = p[0] + advance[i % 4] * joint.axis.x;
        expected[1] = p[1] + advance[i % 4] * joint.axis.y;
        expected[2] = p[2] + advance[i % 4] * joint.axis.z;
        assert_near3(moved, expected, 4e-6);
    }
}

static void one_point_goes_where_the_pose_takes_it(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 2);
    const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS,
                             DM_JOINT_FIXED};
    for (int i = 0; i < CASES; i++) {
        const dm_joint joint = test_joint(&random, types[i % 5], 1);
        const float value = test_range(&random, -7, 7);
        const float point[3] = {test_range(&random, -1, 1), test_range(&random, -1, 1), test_range(&random, -1, 1)};
        const dm_pose pose = dmi_joint_pose(&joint, value);
        float expected[3], moved[3];
        dmi_pose_apply(&pose, point, expected);
        dmi_joint_move(&joint, value, point, moved);
        assert_near3(moved, expected, 4e-6);
    }
}

static void a_reversed_joint_goes_the_same_places(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 2);
    for (int i = 0; i < CASES; i++) {
        const dm_joint joint = test_joint(&random, moving_types[i % 4], 1);
        dm_joint reversed = joint;
        dmi_joint_reverse(&reversed);
        const float value = test_range(&random, -3, 3);
        const float point[3] = {test_range(&random, -1, 1), test_range(&random, -1, 1), test_range(&random, -1, 1)};
        float there[3], again[3];
        dmi_joint_move(&joint, value, point, there);
        dmi_joint_move(&reversed, -value, point, again);
        assert_near3(again, there, 4e-6);
        assert_true(reversed.lower == -joint.upper && reversed.upper == -joint.lower);
    }
}

static void positive_turns_are_right_handed(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}};
    dm_pose pose = dmi_joint_pose(&joint, PI / 2);
    const float x[3] = {1, 0, 0}, y[3] = {0, 1, 0};
    float moved[3];
    dmi_pose_apply(&pose, x, moved);
    assert_near3(moved, y, 1e-6);
}

static void still_joints_stay(void** state) {
    (void)state;
    const int32_t types[] = {DM_JOINT_FIXED, DM_JOINT_UNKNOWN, 99};
    for (int i = 0; i < 3; i++) {
        dm_joint joint = {.type = types[i], .axis = {1, 0, 0}, .origin = {1, 2, 3}, .pitch = 1};
        dm_pose pose = dmi_joint_pose(&joint, 2), still = dmi_pose_identity();
        assert_memory_equal(&pose, &still, sizeof pose);
        float velocity[3], point[3] = {1, 1, 1}, nothing[3] = {0, 0, 0};
        dmi_joint_velocity(&joint, 2, point, velocity);
        assert_near3(velocity, nothing, 0);
        assert_near(dmi_joint_project(&joint, &pose, 0.25f), 0.25f, 0);
    }
}

static void projection_recovers_the_value(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 2);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, moving_types[i % 4], 1);
        const float value = test_range(&random, -20, 20), near = value + test_range(&random, -3, 3);
        dm_pose pose = dmi_joint_pose(&joint, value);
        if (i % 8 >= 4) { /* the double cover must not matter */
            for (int k = 0; k < 4; k++) pose.real[k] = -pose.real[k], pose.dual[k] = -pose.dual[k];
        }
        assert_near(dmi_joint_project(&joint, &pose, near), value, 1e-5);
        /* Far from `near`, the answer is the same pose within half a turn of it. */
        if (dmi_joint_turns(joint.type)) {
            const float other = dmi_joint_project(&joint, &pose, near + 30);
            assert_true(fabsf(other - near - 30) <= PI + 1e-4f);
            const float turns = (other - value) / (2 * PI);
            assert_near(turns, roundf(turns), 1e-5);
        }
    }
}

/* Nearest: no other value's pose is closer to the one projected (rotation by angle, slides by distance). */
static void projection_is_the_nearest_pose(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 2);
    for (int i = 0; i < 400; i++) {
        dm_joint joint = test_joint(&random, i % 2 ? DM_JOINT_PRISMATIC : DM_JOINT_REVOLUTE, 1);
        dm_pose pose = test_pose(&random, 1);
        const float best = dmi_joint_project(&joint, &pose, 0);
        float closest = 0, closest_value = 0;
        for (int k = -400; k <= 400; k++) {
            const float value = (float)k / 400 * (i % 2 ? 6 : PI);
            dm_pose candidate = dmi_joint_pose(&joint, value);
            float closeness = 0;
            if (i % 2) {
                float t[3], u[3];
                dmi_pose_translation(&pose, t);
                dmi_pose_translation(&candidate, u);
                closeness = -(float)test_distance(t, u);
            } else {
                for (int n = 0; n < 4; n++) closeness += pose.real[n] * candidate.real[n];
                closeness = fabsf(closeness);
            }
            if (k == -400 || closeness > closest) closest = closeness, closest_value = value;
        }
        float gap = best - closest_value;
        if (i % 2 == 0) gap -= 2 * PI * roundf(gap / (2 * PI));
        assert_near(gap, 0, 0.02);
    }
}

static void projection_of_nonsense_stays_near(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 2);
    for (int i = 0; i < 4; i++) {
        dm_joint joint = test_joint(&random, moving_types[i], 1);
        dm_pose nan = {{NAN, NAN, NAN, NAN}, {NAN, NAN, NAN, NAN}};
        assert_near(dmi_joint_project(&joint, &nan, 1.5f), 1.5f, 0);
    }
    dm_joint joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 0, 1}};
    dm_pose across = {{1, 0, 0, 0}, {0}}; /* half a turn about x: no twist about z is nearer than another */
    assert_near(dmi_joint_project(&joint, &across, 1.5f), 1.5f, 0);
}

static void velocity_is_the_derivative(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 2);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, moving_types[i % 4], 1);
        float point[3], velocity[3], before[3], after[3];
        test_point(&random, 1, point);
        const float value = test_range(&random, -3, 3), step = 5e-3f;
        dmi_joint_velocity(&joint, value, point, velocity);
        dm_pose a = dmi_joint_pose(&joint, value - step), b = dmi_joint_pose(&joint, value + step);
        dmi_pose_apply(&a, point, before);
        dmi_pose_apply(&b, point, after);
        for (int k = 0; k < 3; k++) after[k] = (after[k] - before[k]) / (2 * step);
        assert_near3(velocity, after, 5e-4);
    }
}

static void origin_slides_along_the_axis_alone(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 2);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, moving_types[i % 4], 1), moved = joint;
        float centre[3];
        test_point(&random, 2, centre);
        dmi_joint_set_origin_near(&moved, centre);
        float gap[3] = {centre[0] - moved.origin.x, centre[1] - moved.origin.y, centre[2] - moved.origin.z};
        assert_near(gap[0] * joint.axis.x + gap[1] * joint.axis.y + gap[2] * joint.axis.z, 0, 2e-6);
        dm_pose before = dmi_joint_pose(&joint, 0.7f), after = dmi_joint_pose(&moved, 0.7f);
        assert_same_motion(&before, &after, 1, 5e-6);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(poses_keep_to_the_joint),
        cmocka_unit_test(one_point_goes_where_the_pose_takes_it),
        cmocka_unit_test(a_reversed_joint_goes_the_same_places),
        cmocka_unit_test(positive_turns_are_right_handed),
        cmocka_unit_test(still_joints_stay),
        cmocka_unit_test(projection_recovers_the_value),
        cmocka_unit_test(projection_is_the_nearest_pose),
        cmocka_unit_test(projection_of_nonsense_stays_near),
        cmocka_unit_test(velocity_is_the_derivative),
        cmocka_unit_test(origin_slides_along_the_axis_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
