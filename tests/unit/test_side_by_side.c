/* Threads at the contract's limits: several callers on one context, each of them calling every public function, the
 * exclusive ones on objects of its own, while a job system shares the work of each out to more threads. Every answer
 * has the bits of a single caller's. */
#include <pthread.h>

#include "test_calls.h"
#include "test_hash.h"

enum { CALLERS = 4, ROUNDS = 1 };

typedef struct answer {
    uint64_t hash; /* of the outputs */
    dm_result result;
} answer;

typedef struct caller {
    test_stage stage;
    int first; /* row with which it begins, so that different functions meet */
    answer answers[ROUNDS][TEST_CALLS];
} caller;

/* ---- the host ---- */

typedef struct half {
    dm_task task;
    void* data;
    uint32_t first, count;
} half;

static void* run_half(void* data) {
    const half* h = data;
    for (uint32_t i = h->first; i < h->count; i += 2) h->task(h->data, i);
    return NULL;
}

static int32_t DM_CALL two_threads(void* user, uint32_t count, dm_task task, void* data) {
    (void)user;
    half halves[2] = {{task, data, 0, count}, {task, data, 1, count}};
    pthread_t helper;
    if (pthread_create(&helper, NULL, run_half, &halves[1]) != 0) return 0;
    run_half(&halves[0]);
    pthread_join(helper, NULL);
    return 1;
}

/* ---- callers ---- */

/* One call after the other: drags and objects go on from each to the next. */
static void* call_all(void* data) {
    caller* c = data;
    test_stage* s = &c->stage;
    for (int i = 0; i < ROUNDS * TEST_CALLS; i++) {
        const int row = (c->first + i) % TEST_CALLS;
        const test_call* call = &test_calls[row];
        answer* out = &c->answers[i / TEST_CALLS][row];
        test_answers_clear(&s->out);
        if (call->before != NULL) call->before(s);
        out->result = call->run(s);
        out->hash = test_hash_bytes(TEST_HASH_START, &s->out, TEST_ANSWERS_COMPARED);
        if (out->result == DM_OK && call->undo != NULL) call->undo(s);
        if (call->after != NULL) call->after(s);
    }
    return NULL;
}

static void open_caller(caller* c, const test_stage* shared, int index) {
    c->stage = *shared;
    c->first = index * TEST_CALLS / CALLERS;
    test_stage_open_own(&c->stage);
}

/* What the callers answer one after the other. */
static void call_alone(const test_stage* shared, answer out[CALLERS][ROUNDS][TEST_CALLS]) {
    static caller alone;
    for (int i = 0; i < CALLERS; i++) {
        open_caller(&alone, shared, i);
        call_all(&alone);
        test_stage_close_own(&alone.stage);
        memcpy(out[i], alone.answers, sizeof alone.answers);
    }
}

static void call_together(const test_stage* shared, answer out[CALLERS][ROUNDS][TEST_CALLS]) {
    static caller callers[CALLERS];
    pthread_t threads[CALLERS];
    for (int i = 0; i < CALLERS; i++) open_caller(&callers[i], shared, i);
    for (int i = 0; i < CALLERS; i++) assert_int_equal(pthread_create(&threads[i], NULL, call_all, &callers[i]), 0);
    for (int i = 0; i < CALLERS; i++) pthread_join(threads[i], NULL);
    for (int i = 0; i < CALLERS; i++) {
        test_stage_close_own(&callers[i].stage);
        memcpy(out[i], callers[i].answers, sizeof callers[i].answers);
    }
}

static void compare(const test_call* call, const answer* one, const answer* other) {
    if (one->result != DM_OK || other->result != DM_OK || one->hash != other->hash)
        fail_msg("%s %s: %s and bits %016llx alone, %s and %016llx beside others", call->function,
                 call->way ? call->way : "", dm_result_string(one->result), (unsigned long long)one->hash,
                 dm_result_string(other->result), (unsigned long long)other->hash);
}

static void answers_are_those_of_one_caller(int32_t picking) {
    static test_world w;
    static test_stage shared;
    static answer alone[CALLERS][ROUNDS][TEST_CALLS], together[CALLERS][ROUNDS][TEST_CALLS];
    test_world_init(&w);
    w.desc.log = (dm_log){0}; /* the test host's log is for one thread */
    w.desc.jobs.parallel_for = two_threads;
    w.desc.picking = picking;
    test_world_open(&w);
    test_world_load_model(&w);
    test_stage_open_shared(&shared, &w);
    call_alone(&shared, alone);
    call_together(&shared, together);
    for (int i = 0; i < CALLERS; i++) {
        for (int round = 0; round < ROUNDS; round++) {
            for (int row = 0; row < TEST_CALLS; row++)
                compare(&test_calls[row], &alone[i][round][row], &together[i][round][row]);
        }
    }
    test_stage_close_shared(&shared);
    test_world_close(&w);
    print_message("%d calls by %d threads\n", CALLERS * ROUNDS * TEST_CALLS, CALLERS);
}

static void with_code_of_our_own(void** state) {
    (void)state;
    answers_are_those_of_one_caller(DM_PICK_PORTABLE);
}

/* The thread sanitizer does not see into Embree. */
static void with_what_picks_by_itself(void** state) {
    (void)state;
#if defined(__SANITIZE_THREAD__)
    skip();
#endif
    answers_are_those_of_one_caller(DM_PICK_AUTO);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_code_of_our_own),
        cmocka_unit_test(with_what_picks_by_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
