/* Sorting floats: what qsort says, for any count, with infinities, repeats and both zeros. */
#include "test_env.h"

#include <math.h>
#include <stdlib.h>

#include "base/random.h"
#include "base/sort.h"

#define MOST 2048

static int by_value(const void* a, const void* b) {
    const float x = *(const float*)a, y = *(const float*)b;
    return x < y ? -1 : x > y;
}

static void floats_come_in_order(void** state) {
    (void)state;
    float values[MOST], expected[MOST], spare[MOST];
    dmi_random random = dmi_random_make(1, 2);
    for (uint32_t count = 0; count <= MOST; count = count < 20 ? count + 1 : count * 2 - 7) {
        for (uint32_t i = 0; i < count; i++) {
            const float size = powf(10, 20 * dmi_random_unit(&random) - 10);
            values[i] = i % 5 == 0 && i > 0 ? values[i - 1] : size * (dmi_random_unit(&random) - 0.5f);
            if (i % 31 == 30) values[i] = i % 2 == 0 ? INFINITY : -INFINITY;
            if (i % 17 == 16) values[i] = i % 2 == 0 ? 0.0f : -0.0f;
        }
        memcpy(expected, values, sizeof values);
        qsort(expected, count, sizeof *expected, by_value);
        dmi_sort_floats(values, count, spare);
        for (uint32_t i = 0; i < count; i++) assert_true(values[i] == expected[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(floats_come_in_order)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
