/* Arena and pool: alignment, no overlap, reuse of blocks, no leak whichever allocation fails. */
#include "test_env.h"

#include "base/arena.h"

static void pieces_are_aligned_and_apart(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_arena arena;
    dmi_arena_init(&arena, &t.env, 1024);
    assert_int_equal(t.memory.calls, 0);
    enum { COUNT = 60 };
    unsigned char* pieces[COUNT];
    size_t sizes[COUNT];
    for (int i = 0; i < COUNT; i++) {
        sizes[i] = (size_t)(i * 37 % 300);
        if (i % 13 == 5) sizes[i] = 5000; /* more than a block */
        pieces[i] = dmi_arena_push(&arena, sizes[i]);
        assert_non_null(pieces[i]);
        assert_int_equal((uintptr_t)pieces[i] % 64, 0);
        memset(pieces[i], i, sizes[i]);
    }
    for (int i = 0; i < COUNT; i++) {
        for (size_t k = 0; k < sizes[i]; k++) assert_int_equal(pieces[i][k], i);
    }
    dmi_arena_release(&arena);
    test_env_close(&t);
}

static void small_pieces_share_a_block(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_arena arena;
    dmi_arena_init(&arena, &t.env, 4096);
    for (int i = 0; i < 32; i++) assert_non_null(dmi_arena_push(&arena, 64));
    assert_non_null(dmi_arena_push(&arena, 100000));
    for (int i = 0; i < 32; i++) assert_non_null(dmi_arena_push(&arena, 64)); /* the rest of the first block */
    assert_int_equal(t.memory.calls, 2);
    dmi_arena_release(&arena);
    assert_non_null(dmi_arena_push(&arena, 1)); /* usable again */
    dmi_arena_release(&arena);
    dmi_arena_release(&arena);
    test_env_close(&t);
}

/* Older pieces stay untouched; what is pushed again finds its memory in the arena. */
static void rewinding_gives_back_what_came_later(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_arena arena;
    dmi_arena_init(&arena, &t.env, 4096);
    const dmi_arena_mark empty = dmi_arena_get_mark(&arena);
    unsigned char* kept = dmi_arena_push(&arena, 1000);
    memset(kept, 7, 1000);
    const dmi_arena_mark mark = dmi_arena_get_mark(&arena);
    unsigned char* first = NULL;
    for (int round = 0; round < 5; round++) {
        unsigned char* small = dmi_arena_push(&arena, 1000);
        memset(small, 1, 1000);
        memset(dmi_arena_push(&arena, 20000), 2, 20000);
        memset(dmi_arena_push(&arena, 4000), 3, 4000); /* the next block */
        memset(dmi_arena_push(&arena, 9000), 4, 9000);
        if (round == 0) first = small;
        assert_ptr_equal(small, first);
        assert_int_equal(t.memory.calls, 4);
        dmi_arena_rewind(&arena, mark);
    }
    for (int i = 0; i < 1000; i++) assert_int_equal(kept[i], 7);
    dmi_arena_rewind(&arena, empty);
    assert_non_null(dmi_arena_push(&arena, 20000));
    assert_int_equal(t.memory.calls, 4);
    dmi_arena_release(&arena);
    test_env_close(&t);
}

static void a_shelf_lends_each_arena_once(void** state) {
    (void)state;
    enum { TAKEN = DMI_ARENA_POOL_SIZE + 2 };
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_arena_pool pool;
    dmi_arena_pool_init(&pool, &t.env, 1024);
    dmi_arena own[TAKEN], *taken[TAKEN];
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < TAKEN; i++) {
            taken[i] = dmi_arena_pool_take(&pool, &own[i]);
            for (int k = 0; k < i; k++) assert_ptr_not_equal(taken[i], taken[k]);
            assert_int_equal(taken[i] == &own[i], i >= DMI_ARENA_POOL_SIZE);
            assert_non_null(dmi_arena_push(taken[i], 500));
        }
        for (int i = 0; i < TAKEN; i++) dmi_arena_pool_put(&pool, taken[i]);
    }
    assert_int_equal(t.memory.calls, TAKEN + 2); /* the pool's arenas kept theirs */
    dmi_arena_pool_release(&pool);
    test_env_close(&t);
}

static void any_allocation_may_fail(void** state) {
    (void)state;
    int failures = 0;
    for (int64_t fail_at = 0;; fail_at++) {
        test_env t;
        test_env_open(&t, fail_at);
        dmi_arena arena;
        dmi_arena_init(&arena, &t.env, 256);
        int ok = 1;
        for (int i = 0; i < 10; i++) ok &= dmi_arena_push(&arena, (size_t)i * 100) != NULL;
        dmi_arena_release(&arena);
        test_env_close(&t);
        if (ok) break;
        failures++;
    }
    assert_true(failures > 3);
}

static void absurd_sizes_are_refused(void** state) {
    (void)state;
    test_env t;
    test_env_open(&t, TEST_NEVER);
    dmi_arena arena;
    dmi_arena_init(&arena, &t.env, 256);
    assert_null(dmi_arena_push(&arena, SIZE_MAX));
    assert_null(dmi_arena_push(&arena, SIZE_MAX - 63));
    assert_int_equal(t.memory.calls, 0);
    dmi_arena_release(&arena);
    test_env_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_are_aligned_and_apart),
        cmocka_unit_test(small_pieces_share_a_block),
        cmocka_unit_test(rewinding_gives_back_what_came_later),
        cmocka_unit_test(a_shelf_lends_each_arena_once),
        cmocka_unit_test(any_allocation_may_fail),
        cmocka_unit_test(absurd_sizes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
