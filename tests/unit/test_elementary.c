/* Elementary functions: as near to the true value as a float can be, the same bits on every machine. */
#include "test_env.h"

#include <inttypes.h>

#include <float.h>
#include <math.h>
#include <string.h>

#include "math/elementary.h"
#include "test_hash.h"

#define STEP 9973                   /* between the bit patterns that are tried: a prime, 430,000 floats */
#define MOST_UNITS 0.5001           /* in the last place, of a result: 0.5 is the nearest float */
#define MOST_ANGLE 1048576.0f       /* rad: as far as elementary.h promises the true angle */
#define RESULTS 0x8bbaa9b650a76182u /* hash of all results, the same on all machines; measured */

typedef struct function {
    const char* name;
    float (*ours)(float x);
    double (*exact)(double x);
} function;

static float atan_of(float x) {
    return dmi_atan2f(x, 1.5f);
}

static double exact_atan_of(double x) {
    return atan2(x, 1.5);
}

static float atan_over(float x) {
    return dmi_atan2f(-0.75f, x);
}

static double exact_atan_over(double x) {
    return atan2(-0.75, x);
}

static const function functions[] = {
    {"exp", dmi_expf, exp},    {"exp2", dmi_exp2f, exp2},        {"log", dmi_logf, log},
    {"sin", dmi_sinf, sin},    {"cos", dmi_cosf, cos},           {"acos", dmi_acosf, acos},
    {"asin", dmi_asinf, asin}, {"atan", atan_of, exact_atan_of}, {"atan over", atan_over, exact_atan_over},
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

static float float_of(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Distance of a result from the true value, in units in its last place. */
static double units_off(float got, double exact) {
    int exponent;
    if (isnan(exact)) return isnan(got) ? 0 : INFINITY;
    if (isinf((float)exact) || isinf(got)) return got == (float)exact ? 0 : INFINITY;
    frexp(exact, &exponent);
    const double unit = fmax(ldexp(1, exponent - FLT_MANT_DIG), ldexp(1, FLT_MIN_EXP - FLT_MANT_DIG));
    return fabs((double)got - exact) / unit;
}

static void results_are_the_nearest_floats(void** state) {
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        const bool angle = strcmp(functions[f].name, "sin") == 0 || strcmp(functions[f].name, "cos") == 0;
        for (uint64_t bits = 0; bits <= UINT32_MAX; bits += STEP) {
            const float x = float_of((uint32_t)bits);
            if (angle && !(fabsf(x) <= MOST_ANGLE)) continue;
            const double off = units_off(functions[f].ours(x), functions[f].exact((double)x));
            if (off > MOST_UNITS) fail_msg("%s(%.9g) is %.4f units off", functions[f].name, (double)x, off);
        }
    }
}

static void edges_are_those_of_the_c_library(void** state) {
    static const float edges[] = {0,       -0.0f,   1,        -1,       INFINITY,   -INFINITY, NAN, FLT_TRUE_MIN,
                                  FLT_MIN, FLT_MAX, -FLT_MAX, 88.7228f, -103.9721f, -150};
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
            const float x = edges[i];
            const double exact = functions[f].exact((double)x);
            if (fabsf(x) > MOST_ANGLE && (functions[f].ours == dmi_sinf || functions[f].ours == dmi_cosf)) {
                assert_true(isinf(x) ? isnan(functions[f].ours(x)) : fabsf(functions[f].ours(x)) <= 1);
                continue;
            }
            const double off = units_off(functions[f].ours(x), exact);
            if (off > MOST_UNITS) fail_msg("%s(%.9g) is %.4f units off", functions[f].name, (double)x, off);
            if (exact == 0) assert_int_equal(!!signbit(functions[f].ours(x)), !!signbit(exact));
        }
    }
    static const float sides[] = {0, -0.0f, 1, -1, INFINITY, -INFINITY};
    for (int y = 0; y < 6; y++) {
        for (int x = 0; x < 6; x++) {
            const float ours = dmi_atan2f(sides[y], sides[x]), exact = (float)atan2((double)sides[y], (double)sides[x]);
            assert_memory_equal(&ours, &exact, sizeof ours);
        }
    }
}

static void minima_and_maxima_pass_by_nan(void** state) {
    (void)state;
    assert_true(dmi_fmaxf(NAN, 2) == 2 && dmi_fmaxf(2, NAN) == 2 && isnan(dmi_fmaxf(NAN, NAN)));
    assert_true(dmi_fminf(NAN, 2) == 2 && dmi_fminf(2, NAN) == 2 && isnan(dmi_fminf(NAN, NAN)));
    assert_true(dmi_fmaxf(-1, 3) == 3 && dmi_fminf(-1, 3) == -1 && dmi_fmax(-1, 3) == 3);
    assert_false(signbit(dmi_fmaxf(-0.0f, 0)));
    assert_true(signbit(dmi_fmaxf(0, -0.0f)));
}

/* Sums up a million results: one bit of one of them changes it. */
static void bits_are_the_same_on_every_machine(void** state) {
    (void)state;
    uint64_t hash = TEST_HASH_START;
    for (int f = 0; f < FUNCTIONS; f++) {
        for (uint64_t bits = 0; bits <= UINT32_MAX; bits += STEP) {
            const float result = functions[f].ours(float_of((uint32_t)bits));
            if (!isnan(result)) hash = test_hash_bytes(hash, &result, sizeof result);
        }
    }
    if (hash != RESULTS) fail_msg("the results' hash is 0x%" PRIx64, hash);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_are_the_nearest_floats),
        cmocka_unit_test(edges_are_those_of_the_c_library),
        cmocka_unit_test(minima_and_maxima_pass_by_nan),
        cmocka_unit_test(bits_are_the_same_on_every_machine),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
