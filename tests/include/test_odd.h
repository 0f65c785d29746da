/* Odd numbers: from the smallest float to nearly the largest, and what stands at the bounds of what is taken. */
#ifndef DM_TEST_ODD_H
#define DM_TEST_ODD_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "base/random.h"
#include "dragmesh/dragmesh.h"

static const float test_odd_numbers[] = {0,     1e-45f, FLT_MIN, 1e-30f, 1e-20f, 1e-13f,  1e-9f, 1e-6f, 1e-3f,
                                         0.05f, 0.1f,   0.5f,    1,      2,      3,       10,    100,   1e3f,
                                         1e6f,  1e9f,   1e12f,   3e38f,  -1,     -1e-45f, -0.5f, -1e9f, -3e38f};

static inline float test_odd(dmi_random* random) {
    return test_odd_numbers[dmi_random_u32(random) % (sizeof test_odd_numbers / sizeof *test_odd_numbers)];
}

static inline dm_vec3 test_odd_vector(dmi_random* random) {
    const float x = test_odd(random), y = test_odd(random), z = test_odd(random);
    return (dm_vec3){x, y, z};
}

static inline bool test_once_in(dmi_random* random, uint32_t count) {
    return dmi_random_u32(random) % count == 0;
}

static inline bool test_are_finite(const float* values, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(values[i])) return false;
    }
    return true;
}

static inline bool test_is_unit(dm_vec3 v) {
    return fabsf(sqrtf(v.x * v.x + v.y * v.y + v.z * v.z) - 1) < 1e-4f;
}

static inline bool test_is_sound_pose(const dm_pose* pose) {
    const float* q = pose->real;
    return test_are_finite(pose->dual, 4) &&
           fabsf(sqrtf(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) - 1) < 1e-4f;
}

static inline bool test_is_finite_vector(dm_vec3 v) {
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static inline bool test_is_finite_joint(const dm_joint* joint) {
    const float numbers[] = {joint->pitch, joint->lower, joint->upper, joint->type_confidence, joint->joint_confidence};
    return test_is_finite_vector(joint->axis) && test_is_finite_vector(joint->origin) && test_are_finite(numbers, 5);
}

#endif
