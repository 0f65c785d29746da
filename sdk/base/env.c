/* Allocator, log and jobs of a context: the host's hooks, or malloc, no log and a plain loop. Scratch memory comes out
 * of its list of kept blocks or of the host. */
#include "base/env.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/utf8.h"

#define MESSAGE_SIZE 512 /* bytes of a log message, longer ones are cut; by hand */

/* ---- the list of kept blocks: the one given last first ---- */

#define MOST_BLOCKS 256          /* that are kept: taking one looks at all of them; by hand */
#define SLACK(size) ((size) / 4) /* bytes that a kept block may have more than is asked for; by hand */

static void lock(dmi_kept* kept) {
    while (atomic_flag_test_and_set_explicit(&kept->lock, memory_order_acquire)) {
    }
}

static void unlock(dmi_kept* kept) {
    atomic_flag_clear_explicit(&kept->lock, memory_order_release);
}

static dmi_kept_block* unlink_block(dmi_kept* kept, dmi_kept_block** at) {
    dmi_kept_block* block = *at;
    *at = block->next;
    kept->bytes -= block->size;
    kept->count--;
    return block;
}

/* Takes the smallest block that has `size` bytes and few more; NULL when there is none. */
static dmi_kept_block* take_block(dmi_kept* kept, size_t size) {
    dmi_kept_block** best = NULL;
    lock(kept);
    for (dmi_kept_block** at = &kept->blocks; *at != NULL; at = &(*at)->next) {
        const size_t has = (*at)->size;
        if (has >= size && has - size <= SLACK(size) && (best == NULL || has < (*best)->size)) best = at;
    }
    dmi_kept_block* block = best != NULL ? unlink_block(kept, best) : NULL;
    unlock(kept);
    return block;
}

/* Takes the blocks that were given first until what is left is within the bounds; returns them. */
static dmi_kept_block* take_surplus(dmi_kept* kept) {
    dmi_kept_block** at = &kept->blocks;
    size_t bytes = 0, count = 0;
    while (*at != NULL && count < MOST_BLOCKS && (*at)->size <= kept->most - bytes) {
        bytes += (*at)->size;
        count++;
        at = &(*at)->next;
    }
    dmi_kept_block* surplus = *at;
    *at = NULL;
    kept->bytes = bytes;
    kept->count = count;
    return surplus;
}

/* Adds memory of `size` bytes. Returns the blocks that no longer fit into the list, those given first; NULL: none. */
static dmi_kept_block* give_block(dmi_kept* kept, void* memory, size_t size) {
    dmi_kept_block* block = memory;
    block->size = size;
    lock(kept);
    block->next = kept->blocks;
    kept->blocks = block;
    kept->bytes += size;
    kept->count++;
    const bool full = kept->bytes > kept->most || kept->count > MOST_BLOCKS;
    dmi_kept_block* surplus = full ? take_surplus(kept) : NULL;
    unlock(kept);
    return surplus;
}

/* Takes all blocks; out_bytes gets how many bytes these have. */
static dmi_kept_block* take_all_blocks(dmi_kept* kept, size_t* out_bytes) {
    lock(kept);
    dmi_kept_block* all = kept->blocks;
    *out_bytes = kept->bytes;
    kept->blocks = NULL;
    kept->bytes = kept->count = 0;
    unlock(kept);
    return all;
}

size_t dmi_kept_bytes(dmi_kept* kept) {
    lock(kept);
    const size_t bytes = kept->bytes;
    unlock(kept);
    return bytes;
}

/* ---- allocator, log and jobs ---- */

static void* default_allocate(void* user, size_t size, size_t alignment) {
    (void)user;
    if (alignment < sizeof(void*)) alignment = sizeof(void*);
#if defined(_WIN32)
    return _aligned_malloc(size, alignment);
#else
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
#endif
}

static void default_release(void* user, void* memory, size_t size) {
    (void)user;
    (void)size;
#if defined(_WIN32)
    _aligned_free(memory);
#else
    free(memory);
#endif
}

void dmi_env_init(dmi_env* env, const dm_allocator* allocator, const dm_log* log, const dm_jobs* jobs) {
    *env = (dmi_env){0};
    atomic_flag_clear(&env->kept.lock);
    if (allocator != NULL && allocator->allocate != NULL && allocator->release != NULL) {
        env->allocator = *allocator;
    } else {
        env->allocator = (dm_allocator){.allocate = default_allocate, .release = default_release};
    }
    if (log != NULL) env->log = *log;
    if (jobs != NULL) env->jobs = *jobs;
}

/* Raises the recorded peak to `bytes` where that is more. */
static void raise_peak(dmi_env* env, uint64_t bytes) {
    uint64_t peak = atomic_load_explicit(&env->peak_bytes, memory_order_relaxed);
    while (bytes > peak && !atomic_compare_exchange_weak_explicit(&env->peak_bytes, &peak, bytes, memory_order_relaxed,
                                                                  memory_order_relaxed)) {
    }
}

/* Replaces 0 by 1 byte: the meaning of malloc(0) differs between hosts. */
static size_t host_size(size_t size) {
    return size > 0 ? size : 1;
}

void* dmi_alloc(dmi_env* env, size_t size, size_t alignment) {
    /* Half the address space: no later rounding up can overflow. */
    if (size > SIZE_MAX / 2) return NULL;
    size = host_size(size);
    void* memory = env->allocator.allocate(env->allocator.user, size, alignment);
    if (memory == NULL && dmi_env_trim(env) > 0) memory = env->allocator.allocate(env->allocator.user, size, alignment);
    if (memory == NULL) return NULL;
    atomic_fetch_add_explicit(&env->allocations, 1, memory_order_relaxed);
    raise_peak(env, atomic_fetch_add_explicit(&env->bytes, size, memory_order_relaxed) + size);
    return memory;
}

void* dmi_alloc_zeroed(dmi_env* env, size_t size, size_t alignment) {
    void* memory = dmi_alloc(env, size, alignment);
    if (memory != NULL) memset(memory, 0, size);
    return memory;
}

void dmi_free(dmi_env* env, void* memory, size_t size) {
    if (memory == NULL) return;
    size = host_size(size);
    atomic_fetch_sub_explicit(&env->bytes, size, memory_order_relaxed);
    env->allocator.release(env->allocator.user, memory, size);
}

/* Gives a list of kept blocks to the host. */
static void free_blocks(dmi_env* env, dmi_kept_block* list) {
    while (list != NULL) {
        dmi_kept_block* block = list;
        list = block->next;
        dmi_free(env, block, block->size);
    }
}

uint64_t dmi_env_trim(dmi_env* env) {
    size_t bytes;
    free_blocks(env, take_all_blocks(&env->kept, &bytes));
    return bytes;
}

dm_result dmi_fail(dmi_env* env, dm_result code, const char* format, ...) {
    if (env == NULL || env->log.message == NULL) return code;
    char text[MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    /* NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): clang-tidy 14 forgets va_start in its second file */
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    dmi_utf8_mend(text);
    env->log.message(env->log.user, DM_LOG_ERROR, code, text);
    return code;
}

/* ---- the host's jobs ---- */

#define WORD_BITS 32
#define WORDS ((DM_MAX_PARTS + WORD_BITS - 1) / WORD_BITS)

/* Tasks handed to the host's job system, and which of them it has run. */
typedef struct host_tasks {
    dm_task task;
    void* data;
    uint32_t count;
    _Atomic uint32_t run[WORDS];   /* a bit a task */
    _Atomic bool wrong;            /* a task was run again, or is none of them */
    _Atomic uint32_t wrong_number; /* that task's number */
} host_tasks;

static bool has_run(const host_tasks* given, uint32_t index) {
    return atomic_load(&given->run[index / WORD_BITS]) >> index % WORD_BITS & 1;
}

/* Marks a task as run. Returns false when it is none of those given or has been run before. */
static bool claim(host_tasks* given, uint32_t index) {
    const uint32_t bit = (uint32_t)1 << index % WORD_BITS;
    if (index < given->count && !(atomic_fetch_or(&given->run[index / WORD_BITS], bit) & bit)) return true;
    atomic_store(&given->wrong_number, index);
    atomic_store(&given->wrong, true);
    return false;
}

/* The host's workers have floating-point environments of their own. */
static void DM_CALL run_on_worker(void* data, uint32_t index) {
    DMI_OWN_FP;
    host_tasks* given = data;
    if (claim(given, index)) given->task(given->data, index);
}

/* Returns the first task that has or has not run; the count of tasks when there is none. */
static uint32_t first_task(const host_tasks* given, bool run) {
    uint32_t i = 0;
    while (i < given->count && has_run(given, i) != run) i++;
    return i;
}

/* Checks what the host's job system did with the tasks. out_inline: none was run, and all are left to the library. */
static dm_result check_tasks(dmi_env* env, const host_tasks* given, bool done, bool* out_inline) {
    if (atomic_load(&given->wrong)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_jobs.parallel_for: task %u was run %s, of %u tasks",
                        atomic_load(&given->wrong_number),
                        atomic_load(&given->wrong_number) < given->count ? "twice" : "but not given", given->count);
    }
    const uint32_t missing = first_task(given, false), run = first_task(given, true);
    *out_inline = !done && run == given->count;
    if (*out_inline || (done && missing == given->count)) return DM_OK;
    if (done)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_jobs.parallel_for: task %u of %u was not run", missing,
                        given->count);
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_jobs.parallel_for answered 0 after it had run task %u of %u",
                    run, given->count);
}

dm_result dmi_parallel_for(dmi_env* env, uint32_t count, dm_task task, void* data) {
    const dm_jobs* jobs = &env->jobs;
    bool run_inline = true;
    if (count > 1 && jobs->parallel_for != NULL) {
        host_tasks given = {.task = task, .data = data, .count = count};
        const bool done = jobs->parallel_for(jobs->user, count, run_on_worker, &given) != 0;
        const dm_result result = check_tasks(env, &given, done, &run_inline);
        if (result != DM_OK) return result;
    }
    for (uint32_t i = 0; run_inline && i < count; i++) task(data, i);
    return DM_OK;
}

/* ---- kept memory ---- */

#define LEAST_KEPT 4096 /* bytes of a block worth keeping: a page */

void* dmi_kept_take(dmi_env* env, size_t size, size_t* out_size) {
    dmi_kept_block* block = env->kept.most > 0 ? take_block(&env->kept, size) : NULL;
    *out_size = block != NULL ? block->size : size;
    return block != NULL ? block : dmi_alloc(env, size, DMI_ALIGNMENT);
}

void dmi_kept_give(dmi_env* env, void* memory, size_t size) {
    if (memory == NULL) return;
    if (size < LEAST_KEPT || size > env->kept.most)
        dmi_free(env, memory, size);
    else
        free_blocks(env, give_block(&env->kept, memory, size));
}

void* dmi_scratch_alloc(dmi_env* env, size_t size) {
    if (size > SIZE_MAX / 4) return NULL; /* no sum below can overflow */
    size_t taken;
    char* block = dmi_kept_take(env, DMI_ALIGNMENT + size, &taken);
    if (block == NULL) return NULL;
    *(size_t*)(void*)block = taken;
    return block + DMI_ALIGNMENT;
}

void dmi_scratch_free(dmi_env* env, void* memory) {
    if (memory == NULL) return;
    char* block = (char*)memory - DMI_ALIGNMENT;
    dmi_kept_give(env, block, *(size_t*)(void*)block);
}
