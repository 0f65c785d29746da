/* Failing memory: each allocation of each public function fails once, of the host's allocator and of malloc. The answer
 * is OUT_OF_MEMORY, outputs stay untouched, nothing is lost, and the context goes on.
 *
 *     test_failing_memory [all]    all: every allocation; else MOST of each call, the first ones and others evenly */
#include <dlfcn.h>

#include "test_calls.h"
#include "test_malloc.h"

enum { FIRST = 16, MOST = 32 };

static bool every_one;

/* Who fails. Embree loses blocks of its own when malloc fails, so those below dragmesh's allocator alone count there.
 */
typedef enum way { HOST_ONCE, HOST_FROM_THEN_ON, MALLOC_ONCE, MALLOC_ONCE_IN_EMBREE } way;

static const char* const way_names[] = {"the host's allocator", "the host's allocator for good", "malloc",
                                        "malloc with Embree"};

static bool is_malloc(way who) {
    return who >= MALLOC_ONCE;
}

typedef struct tally {
    int64_t cases;
    int64_t coped; /* of them: the call did its work all the same, by something else */
} tally;

static int64_t calls_of(const test_stage* s, way who) {
    return is_malloc(who) ? test_malloc.calls : s->w->memory.calls;
}

/* From here on the n-th allocation fails; none, when n is negative. Nothing is kept at either end of the call, so
 * that it has to ask for all it needs, and what it leaves is what it lost. */
static void begin(test_stage* s, way who, int64_t n) {
    if (s->w->context != NULL) dm_context_trim(s->w->context);
    test_memory* memory = &s->w->memory;
    if (is_malloc(who)) {
        test_malloc_watch(n);
        return;
    }
    memory->calls = 0;
    memory->fail_at = n;
    memory->fail_once = who == HOST_ONCE;
}

static void end(test_stage* s, way who) {
    if (s->w->context != NULL) dm_context_trim(s->w->context);
    if (is_malloc(who))
        test_malloc_unwatch();
    else
        s->w->memory.fail_at = TEST_NEVER;
}

static int64_t live(const test_stage* s, way who) {
    return who == MALLOC_ONCE ? test_malloc.live : s->w->memory.live_blocks;
}

static void finish(test_stage* s, const test_call* call, bool has_made) {
    if (has_made && call->undo != NULL) call->undo(s);
    if (call->after != NULL) call->after(s);
}

/* Returns how many allocations a call makes. */
static int64_t count(test_stage* s, const test_call* call, way who) {
    test_answers_clear(&s->out);
    if (call->before != NULL) call->before(s);
    begin(s, who, TEST_NEVER);
    const dm_result result = call->run(s);
    end(s, who);
    if (result != DM_OK) fail_msg("%s %s: %s", call->function, call->way ? call->way : "", dm_result_string(result));
    finish(s, call, true);
    return calls_of(s, who);
}

/* The n-th allocation fails. Returns whether the call coped. */
static bool fail_one(test_stage* s, const test_call* call, way who, int64_t n) {
    static test_answers marked;
    test_answers_clear(&s->out);
    if (call->before != NULL) call->before(s);
    marked = s->out;
    s->w->messages.code = DM_OK;
    begin(s, who, n);
    const int64_t held = live(s, who);
    const dm_result result = call->run(s);
    end(s, who);
    const char* wrong = NULL;
    if (result == DM_OK) {
        /* A host that refuses once has got kept memory back before it is asked again. */
        if (who == HOST_FROM_THEN_ON && calls_of(s, who) > n) wrong = "no error";
    } else {
        if (result != DM_ERROR_OUT_OF_MEMORY) wrong = "not OUT_OF_MEMORY";
        if (memcmp(&s->out, &marked, sizeof marked) != 0) wrong = "outputs are touched";
        if (live(s, who) != held) wrong = "blocks are left";
    }
    finish(s, call, result == DM_OK);
    if (s->w->memory.size_errors != 0) wrong = "a block is given back with another size";
    if (wrong == NULL && !test_stage_is_usable(s)) wrong = "the context is not usable";
    if (wrong != NULL)
        fail_msg("%s %s, allocation %d of %s: %s, but %s (%d blocks are left)", call->function,
                 call->way ? call->way : "", (int)n, way_names[who], dm_result_string(result), wrong,
                 (int)(live(s, who) - held));
    return result == DM_OK;
}

/* Which of `count` allocations comes after `n`. */
static int64_t next(int64_t n, int64_t all) {
    const int64_t step = (all - FIRST) / (MOST - FIRST);
    return every_one || n < FIRST || step < 1 ? n + 1 : n + step;
}

static void fail_all(test_stage* s, way who) {
    tally all = {0};
    for (const test_call* call = test_calls; call < test_calls + TEST_CALLS; call++) {
        const int64_t allocations = (count(s, call, who), count(s, call, who)); /* the first time, pools grow */
        tally own = {0};
        for (int64_t n = 0; n < allocations; n = next(n, allocations), own.cases++)
            own.coped += fail_one(s, call, who, n);
        if (allocations > 0)
            print_message("%-32s %-18s %6d allocations, %d failed, %d coped\n", call->function,
                          call->way ? call->way : "", (int)allocations, (int)own.cases, (int)own.coped);
        all.cases += own.cases, all.coped += own.coped;
    }
    print_message("%s: %d cases, %d coped\n", way_names[who], (int)all.cases, (int)all.coped);
    assert_true(all.cases > TEST_CALLS);
}

static void fail_in_a_world(way who, int32_t picking) {
    static test_world w;
    static test_stage s;
    test_world_init(&w);
    if (who == MALLOC_ONCE) w.desc.allocator = (dm_allocator){0};
    w.desc.picking = picking;
    test_stage_open(&s, &w);
    fail_all(&s, who);
    test_stage_close(&s);
}

static void every_function_has_a_row(void** state) {
    (void)state;
    test_calls_check();
}

static void the_hosts_allocator_fails(void** state) {
    (void)state;
    fail_in_a_world(HOST_ONCE, DM_PICK_AUTO);
    fail_in_a_world(HOST_FROM_THEN_ON, DM_PICK_PORTABLE);
    fail_in_a_world(HOST_FROM_THEN_ON, DM_PICK_AUTO);
}

static void malloc_fails(void** state) {
    (void)state;
    if (!TEST_MALLOC) skip();
    fail_in_a_world(MALLOC_ONCE, DM_PICK_PORTABLE);
    fail_in_a_world(MALLOC_ONCE_IN_EMBREE, DM_PICK_AUTO);
}

/* Embree would call the C library's malloc, bound deeply as the library loads it. Loaded before, it calls this one. */
static void load_embree(void) {
    if (!dlopen("libembree4.so.4", RTLD_NOW)) dlopen("libembree3.so.3", RTLD_NOW);
}

int main(int argc, char** argv) {
    every_one = argc > 1 && strcmp(argv[1], "all") == 0;
    load_embree();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_has_a_row),
        cmocka_unit_test(the_hosts_allocator_fails),
        cmocka_unit_test(malloc_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
