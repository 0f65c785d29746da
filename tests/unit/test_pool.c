/* Handle pool: generations, foreign handles, many slots, failing memory, readers beside writers. */
#include "test_env.h"

#include <pthread.h>

/* The slots themselves: ageing one to its last generation takes four billion rounds otherwise. */
#include "base/pool.c" /* NOLINT(bugprone-suspicious-include) */

enum { KIND = 5 };

static dmi_pool* make_pool(test_env* t) {
    dmi_pool* pool = NULL;
    assert_int_equal(dmi_pool_create(&t->env, KIND, &pool), DM_OK);
    if (pool == NULL) abort();
    return pool;
}

static void handles_have_the_documented_layout(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    int items[3];
    uint64_t a = 0, b = 0, c = 0;
    assert_int_equal(dmi_pool_insert(pool, &items[0], &a), DM_OK);
    assert_int_equal(dmi_pool_insert(pool, &items[1], &b), DM_OK);
    assert_int_equal(a, (uint64_t)KIND << 56 | (uint64_t)pool->first_generation << 24 | 0);
    assert_int_equal(b, a + 1);
    assert_ptr_equal(dmi_pool_get(pool, a), &items[0]);
    assert_ptr_equal(dmi_pool_remove(pool, a), &items[0]);
    assert_int_equal(dmi_pool_insert(pool, &items[2], &c), DM_OK);
    assert_int_equal(c, a + ((uint64_t)1 << 24)); /* same slot, next generation */
    assert_null(dmi_pool_get(pool, a));
    assert_null(dmi_pool_remove(pool, a));
    assert_ptr_equal(dmi_pool_get(pool, c), &items[2]);
    assert_ptr_equal(dmi_pool_get(pool, b), &items[1]);
    dmi_pool_remove(pool, b);
    dmi_pool_remove(pool, c);
    dmi_pool_destroy(pool);
    dmi_pool_destroy(NULL);
    test_env_close(&t);
}

static void wrong_handles_find_nothing(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    int item;
    uint64_t handle = 0;
    assert_null(dmi_pool_get(pool, (uint64_t)KIND << 56 | (uint64_t)1 << 24)); /* nothing inserted yet */
    assert_int_equal(dmi_pool_insert(pool, &item, &handle), DM_OK);
    for (int bit = 0; bit < 64; bit++) {
        assert_null(dmi_pool_get(pool, handle ^ (uint64_t)1 << bit));
        assert_null(dmi_pool_remove(pool, handle ^ (uint64_t)1 << bit));
    }
    assert_null(dmi_pool_get(pool, 0));
    assert_null(dmi_pool_get(pool, UINT64_MAX));
    assert_null(dmi_pool_get(pool, handle | INDEX_MASK));
    assert_ptr_equal(dmi_pool_remove(pool, handle), &item);
    assert_null(dmi_pool_remove(pool, handle));
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

static void thousands_live_side_by_side(void** state) {
    (void)state;
    enum { COUNT = 5000 };
    static int items[COUNT];
    static uint64_t handles[COUNT];
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    for (int i = 0; i < COUNT; i++) assert_int_equal(dmi_pool_insert(pool, &items[i], &handles[i]), DM_OK);
    for (int i = 0; i < COUNT; i += 3) assert_ptr_equal(dmi_pool_remove(pool, handles[i]), &items[i]);
    for (int i = 0; i < COUNT; i++) {
        assert_ptr_equal(dmi_pool_get(pool, handles[i]), i % 3 == 0 ? NULL : &items[i]);
    }
    int left = 0;
    uint64_t handle = 0;
    for (void* item; (item = dmi_pool_any(pool, &handle)) != NULL; left++) {
        assert_ptr_equal(dmi_pool_get(pool, handle), item);
        assert_ptr_equal(dmi_pool_remove(pool, handle), item);
    }
    assert_int_equal(left, COUNT - (COUNT + 2) / 3);
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

/* A handle of one context must not name something in another. */
static void pools_start_at_different_generations(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool *pool = make_pool(&t), *other = make_pool(&t);
    int item;
    uint64_t handle = 0, twin = 0;
    dmi_pool_insert(pool, &item, &handle);
    dmi_pool_insert(other, &item, &twin);
    assert_null(dmi_pool_get(other, handle));
    assert_null(dmi_pool_get(pool, twin));
    dmi_pool_remove(pool, handle);
    dmi_pool_remove(other, twin);
    dmi_pool_destroy(pool);
    dmi_pool_destroy(other);
    test_env_close(&t);
}

/* Near the last generation: handles differ before and after the wrap, and none is 0 or of another kind. */
static void generations_wrap_without_a_handle_twice(void** state) {
    (void)state;
    enum { ROUNDS_HERE = 6 };
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    int item;
    uint64_t handles[ROUNDS_HERE];
    const uint32_t generations[ROUNDS_HERE] = {UINT32_MAX - 2, UINT32_MAX - 1, UINT32_MAX, 1, 2, 3};
    dmi_pool_insert(pool, &item, &handles[0]);
    dmi_pool_remove(pool, handles[0]);
    atomic_store(&slot_at(pool, 0)->generation, UINT32_MAX - 2);
    for (int i = 0; i < ROUNDS_HERE; i++) {
        assert_int_equal(dmi_pool_insert(pool, &item, &handles[i]), DM_OK);
        assert_int_equal(handles[i], (uint64_t)KIND << 56 | (uint64_t)generations[i] << 24);
        for (int k = 0; k < i; k++) assert_null(dmi_pool_get(pool, handles[k]));
        assert_ptr_equal(dmi_pool_remove(pool, handles[i]), &item);
    }
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

static void a_slot_that_is_used_up_rests(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    int item;
    uint64_t first = 0, last = 0, other = 0;
    dmi_pool_insert(pool, &item, &first);
    dmi_pool_remove(pool, first);
    const uint32_t start = pool->first_generation;
    atomic_store(&slot_at(pool, 0)->generation, start > 1 ? start - 1 : UINT32_MAX); /* as after all rounds but one */
    dmi_pool_insert(pool, &item, &last);
    assert_int_equal(last & INDEX_MASK, 0);
    dmi_pool_remove(pool, last);
    dmi_pool_insert(pool, &item, &other);
    assert_int_equal(other & INDEX_MASK, 1);
    assert_null(dmi_pool_get(pool, first));
    dmi_pool_remove(pool, other);
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

static void the_last_index_is_refused_by_name(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    int item;
    uint64_t handle = 77;
    pool->slot_count = (1 << 24) - 64; /* as if all chunks were full; none is there to be freed */
    pool->chunk_count = CHUNK_COUNT;
    assert_int_equal(dmi_pool_insert(pool, &item, &handle), DM_ERROR_TOO_LARGE);
    assert_non_null(strstr(t.messages.text, "2^24"));
    assert_int_equal(handle, 77);
    t.messages.count = 0;
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

/* Fills a pool as far as memory allows and empties it again. */
static dm_result fill_and_empty(dmi_pool* pool) {
    int items[200];
    uint64_t handles[200];
    dm_result result = DM_OK;
    int count = 0;
    while (result == DM_OK && count < 200) {
        result = dmi_pool_insert(pool, &items[count], &handles[count]);
        count += result == DM_OK;
    }
    for (int i = 0; i < count; i++) assert_ptr_equal(dmi_pool_remove(pool, handles[i]), &items[i]);
    return result;
}

static void any_allocation_may_fail(void** state) {
    (void)state;
    int failures = 0;
    for (int64_t fail_at = 0;; fail_at++) {
        test_env t;
        test_env_open(&t, fail_at);
        dmi_pool* pool = NULL;
        dm_result result = dmi_pool_create(&t.env, KIND, &pool);
        if (pool != NULL) result = fill_and_empty(pool);
        dmi_pool_destroy(pool);
        test_env_close(&t);
        if (result == DM_OK) break;
        assert_int_equal(result, DM_ERROR_OUT_OF_MEMORY);
        assert_int_equal(t.messages.code, DM_ERROR_OUT_OF_MEMORY);
        failures++;
    }
    assert_int_equal(failures, 4); /* the pool, 64, 128 and 256 slots */
}

/* Threads insert, look up and remove their own items while they look at one another's handles. */
enum { THREADS = 4, ROUNDS = 4000, HELD = 16 };

typedef struct thread_item {
    uint64_t owner;
} thread_item;

typedef struct thread_work {
    dmi_pool* pool;
    _Atomic uint64_t* shared; /* a handle of each thread, for the others to look up */
    int index;
    int errors;
    thread_item items[HELD];
} thread_work;

static void* insert_and_remove(void* argument) {
    thread_work* work = argument;
    uint64_t handles[HELD] = {0};
    for (int round = 0; round < ROUNDS; round++) {
        int k = round % HELD;
        if (handles[k] != 0 && dmi_pool_remove(work->pool, handles[k]) != &work->items[k]) work->errors++;
        if (dmi_pool_get(work->pool, handles[k]) != NULL) work->errors++;
        if (dmi_pool_insert(work->pool, &work->items[k], &handles[k]) != DM_OK) work->errors++;
        if (dmi_pool_get(work->pool, handles[k]) != &work->items[k]) work->errors++;
        atomic_store(&work->shared[work->index], handles[k]);
        for (int other = 0; other < THREADS; other++) {
            /* May have been removed since, but must never name another thread's item. */
            const thread_item* item = dmi_pool_get(work->pool, atomic_load(&work->shared[other]));
            if (item != NULL && item->owner != (uint64_t)other) work->errors++;
        }
    }
    for (int k = 0; k < HELD; k++) {
        if (dmi_pool_remove(work->pool, handles[k]) != &work->items[k]) work->errors++;
    }
    return NULL;
}

static void threads_do_not_disturb_each_other(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_pool* pool = make_pool(&t);
    static thread_work work[THREADS];
    static _Atomic uint64_t shared[THREADS];
    pthread_t threads[THREADS];
    for (int i = 0; i < THREADS; i++) {
        work[i] = (thread_work){.pool = pool, .shared = shared, .index = i};
        for (int k = 0; k < HELD; k++) work[i].items[k].owner = (uint64_t)i;
        assert_int_equal(pthread_create(&threads[i], NULL, insert_and_remove, &work[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
    for (int i = 0; i < THREADS; i++) assert_int_equal(work[i].errors, 0);
    uint64_t handle;
    assert_null(dmi_pool_any(pool, &handle));
    dmi_pool_destroy(pool);
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(handles_have_the_documented_layout),
        cmocka_unit_test(wrong_handles_find_nothing),
        cmocka_unit_test(thousands_live_side_by_side),
        cmocka_unit_test(pools_start_at_different_generations),
        cmocka_unit_test(generations_wrap_without_a_handle_twice),
        cmocka_unit_test(a_slot_that_is_used_up_rests),
        cmocka_unit_test(the_last_index_is_refused_by_name),
        cmocka_unit_test(any_allocation_may_fail),
        cmocka_unit_test(threads_do_not_disturb_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
