/* The environment of a room under test, on the test host's memory and log. Use:
 *
 *     test_env t;
 *     test_env_open(&t, TEST_NEVER);
 *     ... &t.env, t.messages.text, t.memory.calls ...
 *     test_env_close(&t);   fails the test when something is still allocated
 *
 * A failing-allocation test runs the code for fail_at = 0, 1, 2, ... until it succeeds. */
#ifndef DM_TEST_ENV_H
#define DM_TEST_ENV_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/env.h"
#include "test_host.h"

typedef struct test_env {
    dmi_env env;
    test_memory memory;
    test_messages messages;
} test_env;

static inline void test_env_open(test_env* t, int64_t fail_at) {
    memset(t, 0, sizeof *t);
    t->memory.fail_at = fail_at;
    dm_allocator allocator = test_allocator(&t->memory);
    dm_log log = test_log(&t->messages);
    dmi_env_init(&t->env, &allocator, &log, NULL);
}

static inline void test_env_close(test_env* t) {
    assert_int_equal(t->memory.live_blocks, 0);
    assert_int_equal(t->memory.live_bytes, 0);
    assert_int_equal(t->memory.size_errors, 0);
    assert_int_equal(t->env.bytes, 0);
}

#endif
