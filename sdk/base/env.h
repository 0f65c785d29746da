/* The environment of a context: allocator, log and jobs of the host, and scratch memory that stays from call to call,
 * because fresh pages of the host cost as much as filling them. */
#ifndef DMI_BASE_ENV_H
#define DMI_BASE_ENV_H

#include <stdatomic.h>
#include <stddef.h>

#include "base/compiler.h"
#include "dragmesh/dragmesh.h"

#define DMI_ALIGNMENT 64 /* bytes, of scratch memory and large arrays: a cache line, and a vector of AVX-512 */

/* A list of memory blocks. Each lends its own first bytes to the list. */
typedef struct dmi_kept_block {
    struct dmi_kept_block* next;
    size_t size; /* bytes of the block, these included */
} dmi_kept_block;

typedef struct dmi_kept {
    atomic_flag lock; /* a spin lock, held while the list is walked; no [frame] function takes it */
    dmi_kept_block* blocks;
    size_t bytes, count; /* bytes and blocks of the list */
    size_t most;         /* bytes; 0: nothing is kept */
} dmi_kept;

typedef struct dmi_env {
    dm_allocator allocator;
    dm_log log;
    dm_jobs jobs;
    dm_progress_callback progress; /* hears of long calls; NULL: nobody asks */
    void* progress_user;
    dmi_kept kept; /* scratch memory that waits for the next call */
    _Atomic uint64_t bytes, peak_bytes, allocations, pick_bytes;
} dmi_env;

/* NULL hooks (or hooks of zeros) mean malloc and free, no log, no parallel jobs. */
void dmi_env_init(dmi_env* env, const dm_allocator* allocator, const dm_log* log, const dm_jobs* jobs);

/* Allocates from the host, not zeroed; NULL when it has no memory, also after all kept memory has been given back to
 * it. Size 0 gives a valid pointer that must be freed. */
void* dmi_alloc(dmi_env* env, size_t size, size_t alignment);
void* dmi_alloc_zeroed(dmi_env* env, size_t size, size_t alignment);
/* size as given to dmi_alloc; NULL does nothing. */
void dmi_free(dmi_env* env, void* memory, size_t size);
/* Gives all kept memory to the host; returns how many bytes. Any thread. */
uint64_t dmi_env_trim(dmi_env* env);

/* Logs an error message and returns `code`, so that a check reads: return dmi_fail(env, DM_ERROR_..., "...", ...). */
dm_result dmi_fail(dmi_env* env, dm_result code, const char* format, ...) DMI_PRINTF(3, 4);

/* Runs task(data, i) for i in [0, count) on the host's jobs, or inline. count: DM_MAX_PARTS at most. INVALID_ARGUMENT
 * when the host's jobs left a task out or ran one twice, of which the second time does nothing. */
dm_result dmi_parallel_for(dmi_env* env, uint32_t count, dm_task task, void* data);

/* ---- kept memory ---- */

/* Returns 64-byte aligned memory of at least `size` bytes, kept or of the host, not zeroed; NULL when there is none.
 * out_size gets how large it is, to be told at dmi_kept_give. Any thread. */
void* dmi_kept_take(dmi_env* env, size_t size, size_t* out_size);
/* Keeps the memory within env->kept.most bytes, and gives what is left over to the host. Any thread. */
void dmi_kept_give(dmi_env* env, void* memory, size_t size);
/* Returns how many bytes the blocks of the list have. Any thread. */
size_t dmi_kept_bytes(dmi_kept* kept);

/* Scratch of one call, of a size that need not be told again. NULL does nothing. */
void* dmi_scratch_alloc(dmi_env* env, size_t size);
void dmi_scratch_free(dmi_env* env, void* memory);

#endif
