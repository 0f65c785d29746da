/* Random geometry and comparisons for tests. */
#ifndef DM_TEST_MATH_H
#define DM_TEST_MATH_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/random.h"
#include "math/joint.h"
#include "math/linear3.h"

static inline float test_range(dmi_random* random, float low, float high) {
    return low + (high - low) * dmi_random_unit(random);
}

static inline void test_point(dmi_random* random, float reach, float out[3]) {
    for (int i = 0; i < 3; i++) out[i] = test_range(random, -reach, reach);
}

static inline void test_direction(dmi_random* random, float out[3]) {
    float length;
    do {
        for (int i = 0; i < 3; i++) out[i] = dmi_random_normal(random);
        length = sqrtf(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    } while (length < 0.1f);
    for (int i = 0; i < 3; i++) out[i] /= length;
}

static inline dm_pose test_pose(dmi_random* random, float reach) {
    float axis[3], point[3];
    test_direction(random, axis);
    test_point(random, reach, point);
    return dmi_pose_from_screw(axis, point, test_range(random, -3, 3), test_range(random, -reach, reach));
}

/* A joint of the given type with limits on both sides of 0. */
static inline dm_joint test_joint(dmi_random* random, int32_t type, float reach) {
    float axis[3], origin[3];
    test_direction(random, axis);
    test_point(random, reach, origin);
    dm_joint joint = {.type = type, .axis = dmi_vec3(axis), .origin = dmi_vec3(origin)};
    const float size = type == DM_JOINT_PRISMATIC ? reach : 1.5f;
    joint.lower = -size * test_range(random, 0.1f, 1);
    joint.upper = size * test_range(random, 0.1f, 1);
    if (type == DM_JOINT_SCREW) joint.pitch = test_range(random, -0.3f, 0.3f) * reach;
    return joint;
}

static inline double test_distance(const float a[3], const float b[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++) sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(sum);
}

/* Fails on NaN too. */
static inline void test_near_at(double a, double b, double tolerance, const char* file, int line) {
    if (!(fabs(a - b) <= tolerance)) {
        print_error("%s:%d: %.9g is not %.9g within %g\n", file, line, a, b, tolerance);
        _fail(file, line);
    }
}
#define assert_near(a, b, tolerance) test_near_at((double)(a), (double)(b), (tolerance), __FILE__, __LINE__)

static inline void test_near3_at(const float a[3], const float b[3], double tolerance, const char* file, int line) {
    if (!(test_distance(a, b) <= tolerance)) {
        print_error("%s:%d: (%.9g %.9g %.9g) is not (%.9g %.9g %.9g) within %g\n", file, line, (double)a[0],
                    (double)a[1], (double)a[2], (double)b[0], (double)b[1], (double)b[2], tolerance);
        _fail(file, line);
    }
}
#define assert_near3(a, b, tolerance) test_near3_at((a), (b), (tolerance), __FILE__, __LINE__)

/* The same rigid motion, whichever of its two dual quaternions: compares where both take four points. */
static inline void test_same_motion_at(const dm_pose* a, const dm_pose* b, float reach, double tolerance,
                                       const char* file, int line) {
    const float points[4][3] = {{0, 0, 0}, {reach, 0, 0}, {0, reach, 0}, {0, 0, reach}};
    for (int i = 0; i < 4; i++) {
        float p[3], q[3];
        dmi_pose_apply(a, points[i], p);
        dmi_pose_apply(b, points[i], q);
        test_near3_at(p, q, tolerance, file, line);
    }
}
#define assert_same_motion(a, b, reach, tolerance)                                                                     \
    test_same_motion_at((a), (b), (reach), (tolerance), __FILE__, __LINE__)

static inline void test_is_unit_at(const dm_pose* pose, double tolerance, const char* file, int line) {
    double norm = 0, along = 0;
    for (int i = 0; i < 4; i++) {
        norm += (double)pose->real[i] * (double)pose->real[i];
        along += (double)pose->real[i] * (double)pose->dual[i];
    }
    test_near_at(norm, 1, tolerance, file, line);
    test_near_at(along, 0, tolerance, file, line);
}
#define assert_is_unit(pose, tolerance) test_is_unit_at((pose), (tolerance), __FILE__, __LINE__)

#endif
