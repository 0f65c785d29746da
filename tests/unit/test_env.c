/* Memory accounting, failure messages and jobs of an environment. */
#include "test_env.h"

static void counts_bytes_and_peak(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    void* a = dmi_alloc(&t.env, 100, 8);
    void* b = dmi_alloc(&t.env, 1000, 64);
    assert_int_equal(t.env.bytes, 1100);
    assert_int_equal((uintptr_t)b % 64, 0);
    dmi_free(&t.env, b, 1000);
    void* c = dmi_alloc_zeroed(&t.env, 500, 16);
    for (int i = 0; i < 500; i++) assert_int_equal(((char*)c)[i], 0);
    assert_int_equal(t.env.bytes, 600);
    assert_int_equal(t.env.peak_bytes, 1100);
    assert_int_equal(t.env.allocations, 3);
    dmi_free(&t.env, a, 100);
    dmi_free(&t.env, c, 500);
    dmi_free(&t.env, NULL, 500);
    test_env_close(&t);
}

static void size_zero_is_a_real_block(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    void* a = dmi_alloc(&t.env, 0, 1);
    void* b = dmi_alloc_zeroed(&t.env, 0, TEST_MAX_ALIGNMENT);
    assert_non_null(a);
    assert_non_null(b);
    assert_ptr_not_equal(a, b);
    dmi_free(&t.env, a, 0);
    dmi_free(&t.env, b, 0);
    test_env_close(&t);
}

static void refusals_change_no_counter(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, 0);
    assert_null(dmi_alloc(&t.env, 8, 8));
    assert_null(dmi_alloc_zeroed(&t.env, 8, 8));
    assert_int_equal(t.env.bytes, 0);
    assert_int_equal(t.env.peak_bytes, 0);
    assert_int_equal(t.env.allocations, 0);
    t.memory.fail_at = TEST_NEVER;
    int64_t calls = t.memory.calls;
    assert_null(dmi_alloc(&t.env, SIZE_MAX, 8));
    assert_null(dmi_alloc(&t.env, SIZE_MAX - 63, 64));
    assert_int_equal(t.memory.calls, calls);
    test_env_close(&t);
}

static void works_without_hooks(void** state) {
    (void)state;
    const dm_allocator zeros = {0};
    const dm_allocator* hooks[] = {NULL, &zeros};
    for (int i = 0; i < 2; i++) {
        dmi_env env;
        dmi_env_init(&env, hooks[i], NULL, NULL);
        for (size_t alignment = 1; alignment <= 4096; alignment *= 2) {
            char* memory = dmi_alloc(&env, 77, alignment);
            assert_non_null(memory);
            assert_int_equal((uintptr_t)memory % alignment, 0);
            memset(memory, 1, 77);
            dmi_free(&env, memory, 77);
        }
        assert_int_equal(dmi_fail(&env, DM_ERROR_BAD_DATA, "nobody listens"), DM_ERROR_BAD_DATA);
        assert_int_equal(env.bytes, 0);
    }
}

static void failures_are_told(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    assert_int_equal(dmi_fail(&t.env, DM_ERROR_NOT_FINITE, "vertex %d: %s", 7, "NaN"), DM_ERROR_NOT_FINITE);
    assert_string_equal(t.messages.text, "vertex 7: NaN");
    assert_int_equal(t.messages.code, DM_ERROR_NOT_FINITE);
    assert_int_equal(t.messages.level, DM_LOG_ERROR);
    char longer[2000];
    memset(longer, 'x', sizeof longer);
    longer[sizeof longer - 1] = 0;
    assert_int_equal(dmi_fail(&t.env, DM_ERROR_BAD_DATA, "%s", longer), DM_ERROR_BAD_DATA);
    assert_int_equal(t.messages.count, 2);
    assert_true(strlen(t.messages.text) >= 500);
    assert_int_equal(dmi_fail(NULL, DM_ERROR_BAD_DATA, "before there is a context"), DM_ERROR_BAD_DATA);
    assert_int_equal(t.memory.calls, 0);
    test_env_close(&t);
}

static void DM_CALL mark(void* data, uint32_t index) {
    ((int*)data)[index]++;
}

typedef struct job_host {
    int calls;
    int accepts;
} job_host;

static int32_t DM_CALL backwards(void* user, uint32_t count, dm_task task, void* data) {
    job_host* host = user;
    host->calls++;
    if (!host->accepts) return 0;
    for (uint32_t i = count; i-- > 0;) task(data, i);
    return 1;
}

static void every_index_runs_once(void** state) {
    (void)state;
    for (int accepts = 0; accepts < 3; accepts++) {
        job_host host = {0, accepts == 1};
        dm_jobs jobs = {&host, accepts == 2 ? NULL : backwards};
        dmi_env env;
        dmi_env_init(&env, NULL, NULL, &jobs);
        int done[40] = {0};
        assert_int_equal(dmi_parallel_for(&env, 40, mark, done), DM_OK);
        for (int i = 0; i < 40; i++) assert_int_equal(done[i], 1);
        assert_int_equal(host.calls, accepts != 2);
        assert_int_equal(dmi_parallel_for(&env, 0, mark, done), DM_OK);
        assert_int_equal(done[0], 1);
        assert_int_equal(dmi_parallel_for(&env, 1, mark, done), DM_OK);
        assert_int_equal(done[0], 2);
    }
}

static int32_t DM_CALL repeats_one(void* user, uint32_t count, dm_task task, void* data) {
    const uint32_t* one = user;
    for (uint32_t i = 0; i < count; i++) task(data, i);
    task(data, *one);
    return 1;
}

/* With as many tasks as there may be. The second time does nothing. */
static void a_repeated_task_is_noticed_and_not_run(void** state) {
    (void)state;
    static int done[DM_MAX_PARTS];
    for (uint32_t one = 0; one < DM_MAX_PARTS; one += 1365) {
        const dm_jobs jobs = {&one, repeats_one};
        dmi_env env;
        dmi_env_init(&env, NULL, NULL, &jobs);
        memset(done, 0, sizeof done);
        assert_int_equal(dmi_parallel_for(&env, DM_MAX_PARTS, mark, done), DM_ERROR_INVALID_ARGUMENT);
        for (int i = 0; i < DM_MAX_PARTS; i++) assert_int_equal(done[i], 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts_bytes_and_peak),
        cmocka_unit_test(size_zero_is_a_real_block),
        cmocka_unit_test(refusals_change_no_counter),
        cmocka_unit_test(works_without_hooks),
        cmocka_unit_test(failures_are_told),
        cmocka_unit_test(every_index_runs_once),
        cmocka_unit_test(a_repeated_task_is_noticed_and_not_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
