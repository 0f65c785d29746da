/* Random numbers: PCG32's published sequence, ranges, moments, independence of streams. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

#include "base/random.h"

static void matches_the_published_sequence(void** state) {
    (void)state;
    /* pcg32-demo of the reference implementation, seed 42, stream 54 */
    const uint32_t expected[] = {0xa15c02b7, 0x7b47f409, 0xba1d3330, 0x83d2f293, 0xbfa4784b, 0xcbed606e};
    dmi_random random = dmi_random_make(42, 54);
    for (int i = 0; i < 6; i++) assert_int_equal(dmi_random_u32(&random), expected[i]);
}

static void unit_numbers_fill_the_interval(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(1, 1);
    double sum = 0, squares = 0;
    int buckets[10] = {0};
    enum { COUNT = 100000 };
    for (int i = 0; i < COUNT; i++) {
        float x = dmi_random_unit(&random);
        assert_true(x >= 0 && x < 1);
        sum += x;
        squares += (double)x * x;
        buckets[(int)(x * 10)]++;
    }
    assert_true(fabs(sum / COUNT - 0.5) < 0.004);
    assert_true(fabs(squares / COUNT - 1.0 / 3) < 0.004);
    for (int i = 0; i < 10; i++) assert_true(abs(buckets[i] - COUNT / 10) < 400);
}

static void normal_numbers_have_the_normal_shape(void** state) {
    (void)state;
    dmi_random random = dmi_random_make(2, 9);
    enum { COUNT = 200000 };
    double moments[5] = {0};
    int inside_one = 0, beyond_three = 0;
    for (int i = 0; i < COUNT; i++) {
        double x = dmi_random_normal(&random), power = 1;
        assert_true(isfinite(x) && fabs(x) < 7);
        for (int k = 1; k <= 4; k++) moments[k] += (power *= x) / COUNT;
        inside_one += fabs(x) < 1;
        beyond_three += fabs(x) > 3;
    }
    assert_true(fabs(moments[1]) < 0.01);
    assert_true(fabs(moments[2] - 1) < 0.015);
    assert_true(fabs(moments[3]) < 0.03);
    assert_true(fabs(moments[4] - 3) < 0.08);
    assert_true(fabs(inside_one / (double)COUNT - 0.682689) < 0.005);
    assert_true(fabs(beyond_three / (double)COUNT - 0.0026998) < 0.0006);
}

static void seeds_and_streams_differ(void** state) {
    (void)state;
    dmi_random a = dmi_random_make(7, 0), b = dmi_random_make(7, 0), c = dmi_random_make(7, 1),
               d = dmi_random_make(8, 0);
    int same_c = 0, same_d = 0;
    for (int i = 0; i < 1000; i++) {
        uint32_t x = dmi_random_u32(&a);
        assert_int_equal(x, dmi_random_u32(&b));
        same_c += x == dmi_random_u32(&c);
        same_d += x == dmi_random_u32(&d);
    }
    assert_true(same_c < 3 && same_d < 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(matches_the_published_sequence),
        cmocka_unit_test(unit_numbers_fill_the_interval),
        cmocka_unit_test(normal_numbers_have_the_normal_shape),
        cmocka_unit_test(seeds_and_streams_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
