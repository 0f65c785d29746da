/* Dual quaternions against matrices in double precision, and the laws of a group. */
#include "test_math.h"

#include <string.h>

#include "math/dual_quat.h"

enum { CASES = 2000 };

/* x' = R x + t of a screw by Rodrigues' formula: the definition, in doubles. */
static void move_by_screw(const float axis[3], const float point[3], double angle, double distance, const float x[3],
                          float out[3]) {
    double a[3], r[3], c[3], along = 0;
    for (int i = 0; i < 3; i++) {
        a[i] = (double)axis[i];
        r[i] = (double)x[i] - (double)point[i];
        along += a[i] * r[i];
    }
    for (int i = 0; i < 3; i++) c[i] = a[(i + 1) % 3] * r[(i + 2) % 3] - a[(i + 2) % 3] * r[(i + 1) % 3];
    for (int i = 0; i < 3; i++) {
        double turned = r[i] * cos(angle) + c[i] * sin(angle) + a[i] * along * (1 - cos(angle));
        out[i] = (float)((double)point[i] + turned + a[i] * distance);
    }
}

static void screws_move_points_as_defined(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 1);
    for (int i = 0; i < CASES; i++) {
        float axis[3], point[3], x[3], expected[3], actual[3];
        test_direction(&random, axis);
        test_point(&random, 2, point);
        test_point(&random, 2, x);
        const float angle = test_range(&random, -7, 7), distance = test_range(&random, -2, 2);
        dm_pose pose = dmi_pose_from_screw(axis, point, angle, distance);
        move_by_screw(axis, point, (double)angle, (double)distance, x, expected);
        dmi_pose_apply(&pose, x, actual);
        assert_near3(actual, expected, 5e-6);
        assert_is_unit(&pose, 2e-6);
    }
}

/* The convention of dm_pose: dual = 1/2 t (*) real, and a turn about a point has t = o - R o. */
static void translation_is_what_moves_the_origin(void** state) {
    (void)state;
    const float axis[3] = {0, 0, 1}, point[3] = {1, 0, 0}, expected[3] = {1, -1, 0};
    dm_pose pose = dmi_pose_from_screw(axis, point, 1.57079632679f, 0);
    float t[3];
    dmi_pose_translation(&pose, t);
    assert_near3(t, expected, 1e-6);
    const float turn[4] = {0, 0, 0.70710678f, 0.70710678f};
    dm_pose same = dmi_pose_from_rotation_translation(turn, expected);
    for (int i = 0; i < 4; i++) {
        assert_near(pose.real[i], same.real[i], 1e-6);
        assert_near(pose.dual[i], same.dual[i], 1e-6);
    }
}

static void products_apply_right_first(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 1);
    for (int i = 0; i < CASES; i++) {
        dm_pose a = test_pose(&random, 2), b = test_pose(&random, 2), c = test_pose(&random, 2);
        dm_pose ab = dmi_pose_multiply(&a, &b), bc = dmi_pose_multiply(&b, &c);
        dm_pose left = dmi_pose_multiply(&ab, &c), right = dmi_pose_multiply(&a, &bc);
        assert_same_motion(&left, &right, 1, 2e-5);
        float x[3], via[3], direct[3];
        test_point(&random, 2, x);
        dmi_pose_apply(&b, x, via);
        dmi_pose_apply(&a, via, via);
        dmi_pose_apply(&ab, x, direct);
        assert_near3(direct, via, 1e-5);
        dm_pose back = dmi_pose_inverse(&a), none = dmi_pose_multiply(&a, &back), still = dmi_pose_identity();
        assert_same_motion(&none, &still, 1, 5e-6);
    }
}

static void rotation_ignores_translation(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(3, 1);
    for (int i = 0; i < CASES; i++) {
        dm_pose pose = test_pose(&random, 2);
        float x[3], y[3], moved_x[3], moved_y[3], difference[3], turned[3];
        test_point(&random, 2, x);
        test_point(&random, 2, y);
        dmi_pose_apply(&pose, x, moved_x);
        dmi_pose_apply(&pose, y, moved_y);
        for (int k = 0; k < 3; k++) difference[k] = x[k] - y[k];
        dmi_pose_rotate(&pose, difference, turned);
        for (int k = 0; k < 3; k++) moved_x[k] -= moved_y[k];
        assert_near3(turned, moved_x, 5e-6);
    }
}

static void matrices_move_points_the_same_way(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(4, 1);
    for (int i = 0; i < CASES; i++) {
        dm_pose pose = test_pose(&random, 2);
        float m[16], x[3], moved[3], actual[3];
        dmi_pose_to_matrix(&pose, m);
        test_point(&random, 2, x);
        dmi_pose_apply(&pose, x, moved);
        for (int k = 0; k < 3; k++) actual[k] = m[k] * x[0] + m[4 + k] * x[1] + m[8 + k] * x[2] + m[12 + k];
        assert_near3(actual, moved, 5e-6);
        assert_true(m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1);
    }
}

static void screws_there_and_back(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(5, 1);
    for (int i = 0; i < CASES; i++) {
        float axis[3], point[3];
        test_direction(&random, axis);
        test_point(&random, 2, point);
        const float angle = test_range(&random, 0.05f, 6.2f), distance = test_range(&random, -2, 2);
        dm_pose pose = dmi_pose_from_screw(axis, point, angle, distance);
        dmi_screw screw = dmi_pose_to_screw(&pose);
        assert_near(screw.angle, angle, 1e-5);
        assert_near3(screw.axis, axis, 2e-5);
        assert_near(screw.distance, distance, 1e-4);
        float along = 0;
        for (int k = 0; k < 3; k++) along += point[k] * axis[k];
        for (int k = 0; k < 3; k++) point[k] -= along * axis[k];
        assert_near3(screw.point, point, 2e-4);
        dm_pose back = dmi_pose_from_screw(screw.axis, screw.point, screw.angle, screw.distance);
        for (int k = 0; k < 4; k++) assert_near(back.dual[k], pose.dual[k], 1e-5);
    }
}

static void small_and_absent_turns_are_screws_too(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(6, 1);
    for (int i = 0; i < CASES; i++) {
        float axis[3], point[3];
        test_direction(&random, axis);
        test_point(&random, 2, point);
        const float angle = powf(10, test_range(&random, -12, -2)), distance = test_range(&random, -1, 1);
        dm_pose pose = dmi_pose_from_screw(axis, point, i % 3 ? angle : 0, distance);
        dmi_screw screw = dmi_pose_to_screw(&pose);
        dm_pose back = dmi_pose_from_screw(screw.axis, screw.point, screw.angle, screw.distance);
        assert_same_motion(&pose, &back, 1, 2e-6);
    }
    dm_pose still = dmi_pose_identity();
    dmi_screw screw = dmi_pose_to_screw(&still);
    assert_near(screw.angle, 0, 0);
    assert_near(screw.distance, 0, 0);
    const float nowhere[3] = {0, 0, 0};
    assert_near3(screw.point, nowhere, 0);
}

static void normalising_repairs(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(7, 1);
    for (int i = 0; i < CASES; i++) {
        dm_pose pose = test_pose(&random, 2), scaled = pose;
        const float factor = powf(10, test_range(&random, -6, 6)), skew = test_range(&random, -1, 1);
        for (int k = 0; k < 4; k++) {
            scaled.real[k] *= factor;
            scaled.dual[k] = factor * (scaled.dual[k] + skew * pose.real[k]);
        }
        scaled = dmi_pose_normalize(&scaled);
        assert_is_unit(&scaled, 2e-6);
        assert_same_motion(&pose, &scaled, 1, 5e-6);
    }
    dm_pose still = dmi_pose_identity(),
            bad[4] = {{{0}, {0}}, {{0}, {1, 2, 3, 4}}, {{NAN, 0, 0, 1}, {0}}, {{INFINITY}, {0}}};
    for (int i = 0; i < 4; i++) {
        dm_pose out = dmi_pose_normalize(&bad[i]);
        assert_memory_equal(&out, &still, sizeof out);
    }
}

static void interpolation_follows_one_screw(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(8, 1);
    for (int i = 0; i < CASES; i++) {
        dm_pose a = test_pose(&random, 1);
        float axis[3], point[3];
        test_direction(&random, axis);
        test_point(&random, 1, point);
        const float angle = test_range(&random, -3, 3), distance = test_range(&random, -1, 1);
        dm_pose way = dmi_pose_from_screw(axis, point, angle, distance), b = dmi_pose_multiply(&a, &way);
        for (int k = 0; k < 4; k++) { /* the other double of the same pose must not matter */
            if (i % 2) b.real[k] = -b.real[k], b.dual[k] = -b.dual[k];
        }
        const float t = test_range(&random, -0.2f, 1.2f);
        dm_pose part = dmi_pose_from_screw(axis, point, t * angle, t * distance),
                expected = dmi_pose_multiply(&a, &part);
        dm_pose actual = dmi_pose_sclerp(&a, &b, t);
        assert_same_motion(&actual, &expected, 1, 3e-5);
        dm_pose start = dmi_pose_sclerp(&a, &b, 0), end = dmi_pose_sclerp(&a, &b, 1);
        assert_same_motion(&start, &a, 1, 1e-5);
        assert_same_motion(&end, &b, 1, 2e-5);
    }
}

/* A kernel of the machine, a different one each round. */
static dmi_isa kernel(int round) {
    const dmi_isa best = dmi_cpu_best_isa(), turn = (dmi_isa)(round % 4);
    return best == DMI_ISA_NEON || turn > best ? best : turn;
}

/* Bulk transform: every count, stride, offset and in-place use against the one-point function. */
static void points_in_bulk_equal_points_one_by_one(void** state) {
    (void)state;
    enum { ROOM = 4096 };
    static float src[ROOM], dst[ROOM];
    dmi_random random = dmi_random_make(9, 1);
    const size_t strides[] = {0, 12, 16, 20, 32, 48};
    for (int i = 0; i < 1200; i++) {
        const size_t src_stride = strides[i % 6], dst_stride = strides[i / 6 % 6], count = (size_t)i % 71;
        const size_t from = dmi_random_u32(&random) % 5, to = dmi_random_u32(&random) % 5;
        const size_t src_step = src_stride ? src_stride / 4 : 3, dst_step = dst_stride ? dst_stride / 4 : 3;
        dm_pose pose = test_pose(&random, 1);
        for (int k = 0; k < ROOM; k++) {
            src[k] = test_range(&random, -1, 1);
            dst[k] = 77;
        }
        dmi_pose_apply_points_isa(kernel(i % 7), &pose, src + from, src_stride, dst + to, dst_stride, count);
        size_t written = 0;
        for (size_t k = 0; k < count; k++) {
            float expected[3];
            dmi_pose_apply(&pose, src + from + k * src_step, expected);
            assert_near3(dst + to + k * dst_step, expected, 2e-6);
        }
        for (size_t k = 0; k < ROOM; k++) written += dst[k] != 77; /* gaps and what lies behind stay as they were */
        assert_true(written <= 3 * count);
    }
}

static void points_move_in_place(void** state) {
    (void)state;
    static float points[3 * 1000], expected[3 * 1000];
    dmi_random random = dmi_random_make(10, 1);
    for (size_t stride = 12; stride <= 20; stride += 4) {
        for (size_t count = 0; count < 600; count += 1 + count / 15) {
            dm_pose pose = test_pose(&random, 1);
            for (int k = 0; k < 3000; k++) expected[k] = points[k] = test_range(&random, -1, 1);
            for (size_t k = 0; k < count; k++) {
                dmi_pose_apply(&pose, points + k * stride / 4, expected + k * stride / 4);
            }
            dmi_pose_apply_points_isa(kernel((int)count), &pose, points, stride, points, stride, count);
            for (int k = 0; k < 3000; k++) assert_near(points[k], expected[k], 2e-6);
        }
    }
}

static void points_may_lie_off_their_alignment(void** state) {
    (void)state;
    unsigned char src[14 * 20 + 12], dst[17 * 20 + 12];
    dmi_random random = dmi_random_make(11, 1);
    for (int round = 0; round < 4; round++) {
        dm_pose pose = test_pose(&random, 1);
        float points[20][3], expected[3], actual[3];
        for (size_t i = 0; i < 20; i++) {
            test_point(&random, 1, points[i]);
            memcpy(src + 14 * i, points[i], 12);
        }
        dmi_pose_apply_points_isa(kernel(round), &pose, (const float*)(void*)src, 14, (float*)(void*)dst, 17, 20);
        for (size_t i = 0; i < 20; i++) {
            dmi_pose_apply(&pose, points[i], expected);
            memcpy(actual, dst + 17 * i, 12);
            assert_near3(actual, expected, 2e-6);
        }
    }
}

/* The kernels agree to rounding: with points of size 1, and relative to the size beyond. */
static void kernels_agree(void** state) {
    (void)state;
    enum { COUNT = 100 };
    float src[3 * COUNT], plain[3 * COUNT], best[3 * COUNT];
    dmi_random random = dmi_random_make(12, 1);
    for (int i = 0; i < 200; i++) {
        const float size = powf(10, test_range(&random, 0, 4));
        dm_pose pose = test_pose(&random, 0.2f * size);
        for (int k = 0; k < 3 * COUNT; k++) src[k] = test_range(&random, -0.5f, 0.5f) * size;
        dmi_pose_apply_points_isa(DMI_ISA_SCALAR, &pose, src, 0, plain, 0, COUNT);
        dmi_pose_apply_points(&pose, src, 0, best, 0, COUNT);
        for (int k = 0; k < 3 * COUNT; k++) assert_near(best[k], plain[k], 1e-6 * (double)size);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(screws_move_points_as_defined),
        cmocka_unit_test(translation_is_what_moves_the_origin),
        cmocka_unit_test(products_apply_right_first),
        cmocka_unit_test(rotation_ignores_translation),
        cmocka_unit_test(matrices_move_points_the_same_way),
        cmocka_unit_test(screws_there_and_back),
        cmocka_unit_test(small_and_absent_turns_are_screws_too),
        cmocka_unit_test(normalising_repairs),
        cmocka_unit_test(interpolation_follows_one_screw),
        cmocka_unit_test(points_in_bulk_equal_points_one_by_one),
        cmocka_unit_test(points_move_in_place),
        cmocka_unit_test(points_may_lie_off_their_alignment),
        cmocka_unit_test(kernels_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
