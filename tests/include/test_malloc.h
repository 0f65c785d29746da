/* The program's malloc: counts calls and blocks, and fails once when told to. The libraries that the program uses call
 * it too. Include it in one file of a program. */
#ifndef DM_TEST_MALLOC_H
#define DM_TEST_MALLOC_H

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sanitizers have a malloc of their own; elsewhere than in glibc there is no other name for it. */
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TEST_MALLOC 1
#else
#define TEST_MALLOC 0
#endif

typedef struct test_malloc_state {
    bool watching;   /* calls count, and the blocks that live */
    int64_t calls;   /* while watching */
    int64_t fail_at; /* the call that fails, from 0; -1: none */
    int64_t live;    /* blocks taken and not given back while watching */
    bool has_failed;
} test_malloc_state;

static test_malloc_state test_malloc = {.fail_at = -1};

#if TEST_MALLOC
#pragma GCC visibility push(default)
extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* memory, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void* memory);

static bool test_malloc_fails(void) {
    if (!test_malloc.watching || test_malloc.calls++ != test_malloc.fail_at) return false;
    errno = ENOMEM;
    return test_malloc.has_failed = true;
}

static void* test_malloc_counted(void* memory) {
    if (test_malloc.watching && memory != NULL) test_malloc.live++;
    return memory;
}

void* malloc(size_t size) {
    return test_malloc_fails() ? NULL : test_malloc_counted(__libc_malloc(size));
}

void* calloc(size_t count, size_t size) {
    return test_malloc_fails() ? NULL : test_malloc_counted(__libc_calloc(count, size));
}

void* realloc(void* memory, size_t size) {
    if (test_malloc_fails()) return NULL;
    void* moved = __libc_realloc(memory, size);
    return memory == NULL ? test_malloc_counted(moved) : moved;
}

void* aligned_alloc(size_t alignment, size_t size) {
    return test_malloc_fails() ? NULL : test_malloc_counted(__libc_memalign(alignment, size));
}

void* memalign(size_t alignment, size_t size) {
    return aligned_alloc(alignment, size);
}

int posix_memalign(void** out_memory, size_t alignment, size_t size) {
    void* memory = aligned_alloc(alignment, size);
    if (memory != NULL) *out_memory = memory;
    return memory != NULL ? 0 : ENOMEM;
}

void free(void* memory) {
    if (test_malloc.watching && memory != NULL) test_malloc.live--;
    __libc_free(memory);
}
#pragma GCC visibility pop
#endif

/* Begins to watch; call `which` of malloc from here on fails, none when it is negative. */
static inline void test_malloc_watch(int64_t which) {
    test_malloc = (test_malloc_state){.watching = true, .fail_at = which};
}

/* Returns how many blocks were taken and not given back. */
static inline int64_t test_malloc_unwatch(void) {
    test_malloc.watching = false;
    return test_malloc.live;
}

#endif
