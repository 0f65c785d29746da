/* Motions: default and host paths, projection of any poses onto the joint, sampling without overshoot. */
#include "test_math.h"

#include <string.h>

#include "motion/motion.h"

enum { CASES = 500, T = DM_MOTION_FRAMES };
#define PI 3.14159265358979f

static const int32_t types[] = {DM_JOINT_REVOLUTE, DM_JOINT_PRISMATIC, DM_JOINT_SCREW, DM_JOINT_CONTINUOUS};

static void default_paths_end_at_the_limit(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 4);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 3], 0.5f);
        float point[3], drag[3], path[DMI_VAE_PATH][3], expected[3];
        test_point(&random, 0.5f, point);
        dmi_joint_velocity(&joint, 0, point, drag);
        const int down = i % 2;
        for (int k = 0; k < 3; k++) drag[k] = down ? -drag[k] : drag[k];
        dmi_motion_default_path(&joint, point, drag, path);
        assert_near3(path[0], point, 1e-6);
        dm_pose end = dmi_joint_pose(&joint, down ? joint.lower : joint.upper);
        dmi_pose_apply(&end, point, expected);
        assert_near3(path[DMI_VAE_PATH - 1], expected, 2e-6);
        /* Minimum jerk: slow at both ends, fastest in the middle. */
        const double first = test_distance(path[0], path[1]), middle = test_distance(path[7], path[8]);
        const double last = test_distance(path[14], path[15]);
        assert_true(first < 0.1 * middle + 1e-6 && last < 0.1 * middle + 1e-6);
    }
}

static void default_paths_without_limits(void** state) {
    (void)state;
    const float point[3] = {0.3f, 0, 0.1f}, up[3] = {0, 1, 0}, half[3] = {0.3f, 0.5f, 0.1f}, down[3] = {0, -2, 0};
    const float minus_half[3] = {0.3f, -0.5f, 0.1f};
    float path[DMI_VAE_PATH][3];
    dm_joint wheel = {.type = DM_JOINT_CONTINUOUS, .axis = {0, 0, 1}};
    dmi_motion_default_path(&wheel, point, up, path);
    assert_near3(path[DMI_VAE_PATH - 1], point, 1e-6); /* one whole turn */
    assert_true(path[3][1] > 0.01f);
    dmi_motion_default_path(&wheel, point, down, path);
    assert_true(path[3][1] < -0.01f);
    dm_joint slide = {.type = DM_JOINT_PRISMATIC, .axis = {0, 1, 0}};
    dmi_motion_default_path(&slide, point, up, path);
    assert_near3(path[DMI_VAE_PATH - 1], half, 1e-6);
    dmi_motion_default_path(&slide, point, down, path);
    assert_near3(path[DMI_VAE_PATH - 1], minus_half, 1e-6);
}

static void resampling_keeps_the_ends(void** state) {
    (void)state;
    enum { MOST = 300 };
    float path[MOST][3], out[DMI_VAE_PATH][3];
    dmi_random random = dmi_random_make(2, 4);
    for (uint32_t count = 1; count < MOST; count++) {
        for (uint32_t i = 0; i < count; i++) test_point(&random, 1, path[i]);
        dmi_motion_resample_path((const float(*)[3])path, count, out);
        assert_memory_equal(out[0], path[0], sizeof out[0]);
        assert_memory_equal(out[DMI_VAE_PATH - 1], path[count - 1], sizeof out[0]);
        if (count == DMI_VAE_PATH) assert_memory_equal(out, path, sizeof out);
        /* A straight, even path stays so, whatever its count. */
        for (uint32_t i = 0; i < count; i++) {
            const float s = count > 1 ? (float)i / (float)(count - 1) : 0;
            path[i][0] = s, path[i][1] = 2 - s, path[i][2] = 1;
        }
        dmi_motion_resample_path((const float(*)[3])path, count, out);
        for (int i = 0; i < DMI_VAE_PATH && count > 1; i++) {
            const float s = (float)i / (DMI_VAE_PATH - 1), expected[3] = {s, 2 - s, 1};
            assert_near3(out[i], expected, 1e-6);
        }
    }
    dmi_motion_resample_path(NULL, 0, out);
    for (int i = 0; i < DMI_VAE_PATH; i++) assert_near(out[i][0], 0, 0);
}

/* Poses of the joint about its own origin, as a perfect network would say them. */
static void ideal_poses(const dm_joint* joint, const float values[T], float raw[T][8]) {
    dm_joint about = *joint;
    about.origin = (dm_vec3){0, 0, 0};
    for (int i = 0; i < T; i++) {
        dm_pose pose = dmi_joint_pose(&about, values[i]);
        memcpy(raw[i], pose.real, sizeof pose.real);
        memcpy(raw[i] + 4, pose.dual, sizeof pose.dual);
    }
}

static void projection_recovers_ideal_motions(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 4);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 4], 0.5f);
        float values[T], raw[T][8], out[T];
        const float end = i % 4 == 3 ? test_range(&random, -20, 20) : i % 8 < 4 ? joint.upper : joint.lower;
        for (int k = 0; k < T; k++) values[k] = end * (float)k / (T - 1);
        ideal_poses(&joint, values, raw);
        for (int k = 0; k < T; k++) { /* a network's length and sign mean nothing */
            const float factor = test_range(&random, 0.5f, 2) * (dmi_random_u32(&random) % 2 ? 1.0f : -1.0f);
            for (int n = 0; n < 8; n++) raw[k][n] *= factor;
        }
        dmi_motion_project(&joint, (const float(*)[8])raw, out);
        for (int k = 0; k < T; k++) assert_near(out[k], values[k], 3e-6 * (1 + fabs((double)values[k])));
    }
}

static void projection_stays_inside_and_starts_at_rest(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 4);
    for (int i = 0; i < CASES; i++) {
        dm_joint joint = test_joint(&random, types[i % 3], 0.5f);
        float raw[T][8], out[T];
        for (int k = 0; k < T * 8; k++) raw[k / 8][k % 8] = 3 * dmi_random_normal(&random);
        if (i % 5 == 0) memset(raw[i % T], 0, sizeof raw[0]);
        if (i % 5 == 1) raw[i % T][i % 8] = NAN;
        if (i % 5 == 2) raw[i % T][i % 8] = INFINITY;
        dmi_motion_project(&joint, (const float(*)[8])raw, out);
        assert_true(out[0] == 0);
        for (int k = 0; k < T; k++) assert_true(out[k] >= joint.lower && out[k] <= joint.upper);
    }
}

static void projection_of_overlong_motions_stops_at_the_limit(void** state) {
    (void)state;
    dm_joint joint = {.type = DM_JOINT_REVOLUTE, .axis = {0, 1, 0}, .lower = 0, .upper = 1.5f};
    float values[T], raw[T][8], out[T];
    for (int k = 0; k < T; k++) values[k] = 0.45f * (float)k; /* beyond a whole turn: must not come back inside */
    ideal_poses(&joint, values, raw);
    dmi_motion_project(&joint, (const float(*)[8])raw, out);
    for (int k = 0; k < T; k++) assert_near(out[k], fminf(values[k], 1.5f), 1e-5);
}

static void sampling_meets_the_keys(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 4);
    for (int i = 0; i < CASES; i++) {
        dmi_motion motion = {.joint = test_joint(&random, types[i % 4], 1)};
        for (int k = 0; k < T; k++) motion.values[k] = test_range(&random, -1, 1);
        for (int k = 0; k < T; k++) {
            assert_near(dmi_motion_value(&motion, (float)k / (T - 1)), motion.values[k], 2e-5);
        }
        assert_true(dmi_motion_value(&motion, 0) == motion.values[0]);
        assert_true(dmi_motion_value(&motion, 1) == motion.values[T - 1]);
        assert_true(dmi_motion_value(&motion, -3) == motion.values[0]);
        assert_true(dmi_motion_value(&motion, 7) == motion.values[T - 1]);
        assert_true(dmi_motion_value(&motion, NAN) == motion.values[0]);
        assert_true(dmi_motion_value(&motion, INFINITY) == motion.values[T - 1]);
    }
}

/* Between two keys the value stays between them, and where keys rise it rises. */
static void sampling_never_overshoots(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 4);
    for (int i = 0; i < CASES; i++) {
        dmi_motion motion = {.joint = {.type = DM_JOINT_PRISMATIC}};
        float value = 0;
        for (int k = 0; k < T; k++) { /* steps of very different sizes, some of them none; even rounds only rise */
            const float step = powf(10, test_range(&random, -3, 0)) * (float)(dmi_random_u32(&random) % 3 > 0);
            value += i % 2 && dmi_random_u32(&random) % 2 ? -step : step;
            motion.values[k] = value;
        }
        float previous = motion.values[0];
        for (int n = 0; n <= 1500; n++) {
            const float t = (float)n / 1500, now = dmi_motion_value(&motion, t);
            const int k = n < 1500 ? n / 100 : T - 2;
            const float low = fminf(motion.values[k], motion.values[k + 1]);
            const float high = fmaxf(motion.values[k], motion.values[k + 1]);
            assert_true(now >= low - 2e-6f && now <= high + 2e-6f);
            if (i % 2 == 0) assert_true(now >= previous - 2e-6f);
            previous = now;
        }
    }
}

/* The derivative has no step at the keys. */
static void sampling_is_smooth(void** state) {
    (void)state;
    dmi_motion motion = {.joint = {.type = DM_JOINT_PRISMATIC}};
    for (int k = 0; k < T; k++) {
        const float s = (float)k / (T - 1);
        motion.values[k] = s * s * s * (10 - 15 * s + 6 * s * s);
    }
    const float step = 1e-3f;
    for (int k = 1; k < T - 1; k++) {
        const float t = (float)k / (T - 1), here = dmi_motion_value(&motion, t);
        const float left = (here - dmi_motion_value(&motion, t - step)) / step;
        const float right = (dmi_motion_value(&motion, t + step) - here) / step;
        assert_near(left, right, 0.05);
    }
    for (int n = 0; n <= 100; n++) { /* and a minimum-jerk motion is met between its keys too */
        const float s = (float)n / 100;
        assert_near(dmi_motion_value(&motion, s), s * s * s * (10 - 15 * s + 6 * s * s), 2e-3);
    }
    for (int k = 0; k < T; k++) motion.values[k] = 0.1f * (float)k;
    for (int n = 0; n <= 100; n++) assert_near(dmi_motion_value(&motion, (float)n / 100), 1.5f * (float)n / 100, 2e-6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(default_paths_end_at_the_limit),
        cmocka_unit_test(default_paths_without_limits),
        cmocka_unit_test(resampling_keeps_the_ends),
        cmocka_unit_test(projection_recovers_ideal_motions),
        cmocka_unit_test(projection_stays_inside_and_starts_at_rest),
        cmocka_unit_test(projection_of_overlong_motions_stops_at_the_limit),
        cmocka_unit_test(sampling_meets_the_keys),
        cmocka_unit_test(sampling_never_overshoots),
        cmocka_unit_test(sampling_is_smooth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
