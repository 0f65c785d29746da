/* Vectors and quaternions by cglm have the bits of the formulas that they stand for, on every machine: cglm is compiled
 * without vector instructions, which would add in another order, and would need aligned addresses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/random.h"
#include "cglm/scalar_quat.h"
#include "math/dual_quat.h"
#include "math/linear3.h"

#if defined(CGLM_SIMD) || defined(CGLM_SIMD_x86) || defined(CGLM_SIMD_ARM) || defined(CGLM_NEON_FP)
#error "cglm is compiled with vector instructions"
#endif
#if defined(__x86_64__) && !(defined(__SSE__) && defined(__SSE2__))
#error "cglm/end_scalar.h does not give back what cglm/begin_scalar.h puts aside"
#endif

enum { ROUNDS = 20000 };

/* Numbers of both signs, of sizes from 1e-6 to 1e6. */
static void draw(dmi_random* random, float* out, int count) {
    for (int i = 0; i < count; i++) {
        const int exponent = (int)(40 * dmi_random_unit(random)) - 20;
        out[i] = ldexpf(2 * dmi_random_unit(random) - 1, exponent);
    }
}

#define ASSERT_BITS(got, wanted) assert_memory_equal(got, wanted, sizeof wanted)

static void vectors_have_the_bits_of_their_formulas(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 1);
    for (int round = 0; round < ROUNDS; round++) {
        float a[3], b[3], s, got[3], wanted[3];
        draw(&random, a, 3), draw(&random, b, 3), draw(&random, &s, 1);
        const float dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const float got_dot = dmi_dot3(a, b);
        assert_memory_equal(&got_dot, &dot, sizeof dot);
        dmi_cross3(a, b, got);
        for (int i = 0; i < 3; i++) wanted[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        ASSERT_BITS(got, wanted);
        dmi_madd3(a, s, b, got);
        for (int i = 0; i < 3; i++) wanted[i] = a[i] + s * b[i];
        ASSERT_BITS(got, wanted);
        memcpy(got, b, sizeof got);
        dmi_madd3(a, s, got, got); /* in place */
        ASSERT_BITS(got, wanted);
        const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
        const float distance = sqrtf(x * x + y * y + z * z), got_distance = dmi_distance3(a, b);
        assert_memory_equal(&got_distance, &distance, sizeof distance);
        memcpy(got, a, sizeof got);
        const float length = dmi_normalize3(got);
        for (int i = 0; i < 3; i++) wanted[i] = a[i] / length;
        ASSERT_BITS(got, wanted);
    }
}

static void turns_have_the_bits_of_their_formula(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 2);
    for (int round = 0; round < ROUNDS; round++) {
        float axis[3], origin[3], circle[2], point[3], d[3], c[3], got[3], wanted[3];
        draw(&random, axis, 3), draw(&random, origin, 3), draw(&random, circle, 2), draw(&random, point, 3);
        for (int i = 0; i < 3; i++) d[i] = point[i] - origin[i];
        dmi_cross3(axis, d, c);
        const float along = dmi_dot3(axis, d) * (1 - circle[0]);
        for (int i = 0; i < 3; i++) wanted[i] = origin[i] + d[i] * circle[0] + c[i] * circle[1] + axis[i] * along;
        dmi_turn3(axis, origin, circle[0], circle[1], point, got);
        ASSERT_BITS(got, wanted);
    }
}

static void multiply(const float a[4], const float b[4], float out[4]) {
    out[0] = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
    out[1] = a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0];
    out[2] = a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3];
    out[3] = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
}

/* The poses lie a float off the alignment that vector instructions ask for. */
static void poses_have_the_bits_of_their_formulas_at_any_address(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 3);
    for (int round = 0; round < ROUNDS; round++) {
        _Alignas(16) float numbers[17];
        const dm_pose *a = (const dm_pose*)(numbers + 1), *b = (const dm_pose*)(numbers + 9);
        draw(&random, numbers, 17);
        dm_pose wanted;
        float left[4], right[4], got[3];
        multiply(a->real, b->real, wanted.real);
        multiply(a->real, b->dual, left);
        multiply(a->dual, b->real, right);
        for (int i = 0; i < 4; i++) wanted.dual[i] = left[i] + right[i];
        const dm_pose product = dmi_pose_multiply(a, b);
        assert_memory_equal(&product, &wanted, sizeof wanted);

        const float *r = a->real, *d = a->dual, *v = b->real;
        float turned[3], once[3], twice[3], moved[3];
        dmi_cross3(r, d, turned);
        for (int i = 0; i < 3; i++) moved[i] = 2 * (r[3] * d[i] - d[3] * r[i] + turned[i]);
        dmi_pose_translation(a, got);
        ASSERT_BITS(got, moved);
        dmi_cross3(r, v, once);
        dmi_cross3(r, once, twice);
        for (int i = 0; i < 3; i++) moved[i] = v[i] + 2 * (r[3] * once[i] + twice[i]);
        dmi_pose_rotate(a, v, got);
        ASSERT_BITS(got, moved);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_have_the_bits_of_their_formulas),
        cmocka_unit_test(turns_have_the_bits_of_their_formula),
        cmocka_unit_test(poses_have_the_bits_of_their_formulas_at_any_address),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
