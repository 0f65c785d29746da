/* Real time: what is tagged [frame] takes no memory from anywhere, takes no lock, makes no system call and logs
 * nothing, in any state of drags, with either backend that picks. The list is that of the header. */
#if defined(__linux__)
#include <dlfcn.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#endif

#include "test_calls.h"
#include "test_malloc.h"

enum { FRAMES = 200 };

/* ---- locks ---- */

static int64_t locks; /* taken while test_malloc watches */

#if TEST_MALLOC
#pragma GCC visibility push(default)
/* What C and C++ libraries lock with. The functions of that name in the C library do the work. */
#define COUNTED_LOCK(function, type)                                                                                   \
    int function(type* lock) {                                                                                         \
        static int (*own)(type*);                                                                                      \
        if (own == NULL) *(void**)&own = dlsym(RTLD_NEXT, #function);                                                  \
        locks += test_malloc.watching;                                                                                 \
        return own(lock);                                                                                              \
    }
COUNTED_LOCK(pthread_mutex_lock, pthread_mutex_t)
COUNTED_LOCK(pthread_mutex_trylock, pthread_mutex_t)
COUNTED_LOCK(pthread_rwlock_rdlock, pthread_rwlock_t)
COUNTED_LOCK(pthread_rwlock_wrlock, pthread_rwlock_t)
COUNTED_LOCK(pthread_spin_lock, pthread_spinlock_t)
#pragma GCC visibility pop
#endif

/* ---- the calls ---- */

static bool call_frames(test_stage* s, const test_call* call) {
    for (int i = 0; i < FRAMES; i++) {
        if (call->run(s) != DM_OK) return false;
    }
    return true;
}

static void count_memory_and_locks(test_stage* s, const test_call* call) {
    const int64_t before = s->w->memory.calls;
    s->w->messages.count = 0;
    locks = 0;
    test_malloc_watch(TEST_NEVER);
    const bool well = call_frames(s, call);
    test_malloc_unwatch();
    if (!well || test_malloc.calls != 0 || s->w->memory.calls != before || locks != 0 || s->w->messages.count != 0)
        fail_msg("%s %s: %s, %d calls of malloc, %d of the host's allocator, %d locks, %d messages", call->function,
                 call->way ? call->way : "", well ? "DM_OK" : "an error", (int)test_malloc.calls,
                 (int)(s->w->memory.calls - before), (int)locks, s->w->messages.count);
}

/* In a process that the kernel ends at any system call but read, write and exit. */
static void forbid_system_calls(test_stage* s, const test_call* call) {
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(0);
        syscall(SYS_exit, call_frames(s, call) ? 0 : 1);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    if (WIFSIGNALED(status)) fail_msg("%s: a system call (signal %d)", call->function, WTERMSIG(status));
    assert_int_equal(WEXITSTATUS(status), 0);
#else
    (void)s;
    (void)call;
#endif
}

static void check_frame_calls(int32_t picking) {
    static test_world w;
    static test_stage s;
    int checked = 0;
    test_world_init(&w);
    w.desc.picking = picking;
    test_stage_open(&s, &w);
    cJSON* interface = test_interface();
    for (const test_call* call = test_calls; call < test_calls + TEST_CALLS; call++) {
        if (!test_call_is_tagged(interface, call, "frame")) continue;
        test_answers_clear(&s.out);
        if (call->before != NULL) call->before(&s);
        count_memory_and_locks(&s, call);
        forbid_system_calls(&s, call);
        if (call->after != NULL) call->after(&s);
        checked++;
    }
    print_message("%d ways of [frame] calls, %d frames each\n", checked, FRAMES);
    assert_true(checked > 20);
    cJSON_Delete(interface);
    test_stage_close(&s);
}

static void every_function_has_a_row(void** state) {
    (void)state;
    test_calls_check();
}

static void with_code_of_our_own(void** state) {
    (void)state;
    check_frame_calls(DM_PICK_PORTABLE);
}

static void with_what_picks_by_itself(void** state) {
    (void)state;
    check_frame_calls(DM_PICK_AUTO);
}

/* A checker that sees nothing would let all pass. */
static void the_checker_sees(void** state) {
    (void)state;
#if TEST_MALLOC
    pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    locks = 0;
    test_malloc_watch(TEST_NEVER);
    void* volatile block = malloc(1);
    free(block);
    pthread_mutex_lock(&mutex);
    test_malloc_unwatch();
    pthread_mutex_unlock(&mutex);
    assert_int_equal(test_malloc.calls, 1);
    assert_int_equal(locks, 1);
    const pid_t child = fork();
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(0);
        getppid();
        syscall(SYS_exit, 0);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    if (!WIFSIGNALED(status)) print_message("this kernel does not forbid system calls: none were looked for\n");
#else
    skip();
#endif
}

int main(void) {
#if TEST_MALLOC
    /* Embree would call the C library's malloc, bound deeply as the library loads it. Loaded before, it calls this one.
     */
    if (!dlopen("libembree4.so.4", RTLD_NOW)) dlopen("libembree3.so.3", RTLD_NOW);
#endif
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_has_a_row),
        cmocka_unit_test(the_checker_sees),
        cmocka_unit_test(with_code_of_our_own),
        cmocka_unit_test(with_what_picks_by_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
