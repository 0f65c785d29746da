/* The calls of cmocka that tests here make, for machines for which Debian has no cmocka: the same names, the same
 * meaning, the same closing lines. */
#ifndef TESTS_CROSS_CMOCKA_H
#define TESTS_CROSS_CMOCKA_H

#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

typedef int (*CMFixtureFunction)(void** state);

struct CMUnitTest {
    const char* name;
    void (*test_func)(void** state);
    CMFixtureFunction setup_func, teardown_func;
    void* initial_state; /* what the test's state points to; NULL: what the group's setup made */
};

enum { CMOCKA_PASSED = 1, CMOCKA_FAILED, CMOCKA_SKIPPED };

/* Where a failed or skipped test goes on. */
static jmp_buf cmocka_end_of_test;

static inline void cmocka_end(int how) {
    longjmp(cmocka_end_of_test, how);
}

static inline void cmocka_fail(const char* file, int line) {
    printf("[   LINE   ] --- %s:%d: error: Failure!\n", file, line);
    cmocka_end(CMOCKA_FAILED);
}

static inline void cmocka_check(int right, const char* text, const char* file, int line) {
    if (right) return;
    printf("[  ERROR   ] --- %s\n", text);
    cmocka_fail(file, line);
}

static inline void cmocka_equal(uintmax_t a, uintmax_t b, int wanted, const char* file, int line) {
    if ((a == b) == wanted) return;
    printf("[  ERROR   ] --- 0x%" PRIxMAX " %s 0x%" PRIxMAX "\n", a, wanted ? "!=" : "==", b);
    cmocka_fail(file, line);
}

static inline void cmocka_range(uintmax_t value, uintmax_t least, uintmax_t most, const char* file, int line) {
    if (value >= least && value <= most) return;
    printf("[  ERROR   ] --- %" PRIuMAX " is not in [%" PRIuMAX ", %" PRIuMAX "]\n", value, least, most);
    cmocka_fail(file, line);
}

static inline void cmocka_strings(const char* a, const char* b, int wanted, const char* file, int line) {
    if ((strcmp(a, b) == 0) == wanted) return;
    printf("[  ERROR   ] --- \"%s\" %s \"%s\"\n", a, wanted ? "!=" : "==", b);
    cmocka_fail(file, line);
}

static inline void cmocka_bytes(const void* a, const void* b, size_t size, int wanted, const char* file, int line) {
    if ((memcmp(a, b, size) == 0) == wanted) return;
    printf("[  ERROR   ] --- %zu bytes %s\n", size, wanted ? "differ" : "are the same");
    cmocka_fail(file, line);
}

static inline void cmocka_floats(double a, double b, double tolerance, int wanted, const char* file, int line) {
    const double off = a > b ? a - b : b - a;
    if ((a == b || off <= tolerance) == wanted) return;
    printf("[  ERROR   ] --- %.9g %s %.9g\n", a, wanted ? "!=" : "==", b);
    cmocka_fail(file, line);
}

#define assert_true(c) cmocka_check(!!(c), #c, __FILE__, __LINE__)
#define assert_false(c) cmocka_check(!(c), "not " #c, __FILE__, __LINE__)
#define assert_non_null(p) cmocka_check((p) != NULL, #p " is not NULL", __FILE__, __LINE__)
#define assert_null(p) cmocka_check((p) == NULL, #p " is NULL", __FILE__, __LINE__)
#define assert_ptr_equal(a, b) cmocka_equal((uintptr_t)(a), (uintptr_t)(b), 1, __FILE__, __LINE__)
#define assert_ptr_not_equal(a, b) cmocka_equal((uintptr_t)(a), (uintptr_t)(b), 0, __FILE__, __LINE__)
#define assert_int_equal(a, b) cmocka_equal((uintmax_t)(a), (uintmax_t)(b), 1, __FILE__, __LINE__)
#define assert_int_not_equal(a, b) cmocka_equal((uintmax_t)(a), (uintmax_t)(b), 0, __FILE__, __LINE__)
#define assert_string_equal(a, b) cmocka_strings(a, b, 1, __FILE__, __LINE__)
#define assert_string_not_equal(a, b) cmocka_strings(a, b, 0, __FILE__, __LINE__)
#define assert_memory_equal(a, b, size) cmocka_bytes(a, b, size, 1, __FILE__, __LINE__)
#define assert_memory_not_equal(a, b, size) cmocka_bytes(a, b, size, 0, __FILE__, __LINE__)
#define assert_float_equal(a, b, tolerance) cmocka_floats(a, b, tolerance, 1, __FILE__, __LINE__)
#define assert_float_not_equal(a, b, tolerance) cmocka_floats(a, b, tolerance, 0, __FILE__, __LINE__)
#define assert_in_range(value, least, most) cmocka_range(value, least, most, __FILE__, __LINE__)
#define print_message(...) printf(__VA_ARGS__)
#define print_error(...) printf(__VA_ARGS__)
#define _fail(file, line) cmocka_fail(file, line)
#define fail() cmocka_fail(__FILE__, __LINE__)
#define fail_msg(...) (printf("[  ERROR   ] --- " __VA_ARGS__), printf("\n"), fail())
#define skip() cmocka_end(CMOCKA_SKIPPED)

#define cmocka_unit_test(f) cmocka_unit_test_setup_teardown(f, NULL, NULL)
#define cmocka_unit_test_teardown(f, teardown) cmocka_unit_test_setup_teardown(f, NULL, teardown)
/* clang-format off */
#define cmocka_unit_test_setup_teardown(f, setup, teardown) { #f, f, setup, teardown, NULL }
/* clang-format on */

/* Runs one step; what it says, or FAILED where a fixture returned an error. */
static inline int cmocka_run_test(const struct CMUnitTest* test, void** state) {
    const int how = setjmp(cmocka_end_of_test);
    if (how != 0) return how;
    if (test->setup_func != NULL && test->setup_func(state) != 0) return CMOCKA_FAILED;
    test->test_func(state);
    return CMOCKA_PASSED;
}

static inline int cmocka_run_fixture(CMFixtureFunction fixture, void** state) {
    if (fixture == NULL) return 0;
    return setjmp(cmocka_end_of_test) != 0 ? -1 : fixture(state);
}

/* Returns the number of failed tests. */
static inline int cmocka_run_group(const char* group, const struct CMUnitTest* tests, size_t count,
                                   CMFixtureFunction setup, CMFixtureFunction teardown) {
    static const char* const words[] = {
        [CMOCKA_PASSED] = "      OK", [CMOCKA_FAILED] = " FAILED ", [CMOCKA_SKIPPED] = " SKIPPED"};
    int counts[CMOCKA_SKIPPED + 1] = {0};
    void* state = NULL;
    printf("[==========] %s: Running %zu test(s).\n", group, count);
    if (cmocka_run_fixture(setup, &state) != 0) {
        printf("[  FAILED  ] the group's setup\n");
        return (int)count;
    }
    for (size_t i = 0; i < count; i++) {
        void* own = tests[i].initial_state != NULL ? tests[i].initial_state : state;
        printf("[ RUN      ] %s\n", tests[i].name);
        int how = cmocka_run_test(&tests[i], &own);
        if (cmocka_run_fixture(tests[i].teardown_func, &own) != 0) how = CMOCKA_FAILED;
        counts[how]++;
        printf("[ %s ] %s\n", words[how], tests[i].name);
    }
    if (cmocka_run_fixture(teardown, &state) != 0) counts[CMOCKA_FAILED]++;
    printf("[==========] %zu test(s) run.\n[  PASSED  ] %d test(s).\n", count, counts[CMOCKA_PASSED]);
    if (counts[CMOCKA_SKIPPED] > 0) printf("[  SKIPPED ] %d test(s).\n", counts[CMOCKA_SKIPPED]);
    if (counts[CMOCKA_FAILED] > 0) printf("[  FAILED  ] %d test(s).\n", counts[CMOCKA_FAILED]);
    fflush(stdout);
    return counts[CMOCKA_FAILED];
}

#define cmocka_run_group_tests_name(name, tests, setup, teardown)                                                      \
    cmocka_run_group(name, tests, sizeof(tests) / sizeof *(tests), setup, teardown)
#define cmocka_run_group_tests(tests, setup, teardown) cmocka_run_group_tests_name(#tests, tests, setup, teardown)

#endif
