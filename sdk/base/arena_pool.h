/* Scratch arenas of parallel tasks: each takes one and puts it back, emptied but with its memory, for the next. */
#ifndef DMI_BASE_ARENA_POOL_H
#define DMI_BASE_ARENA_POOL_H

#include "base/arena.h"

#define DMI_ARENA_POOL_SIZE 16 /* arenas; by hand. More tasks at once use memory of their own */

typedef struct dmi_arena_pool {
    dmi_arena arenas[DMI_ARENA_POOL_SIZE];
    _Atomic uint32_t taken[DMI_ARENA_POOL_SIZE];
} dmi_arena_pool;

void dmi_arena_pool_init(dmi_arena_pool* pool, dmi_env* env, size_t block_size);
/* Returns a free arena, or `own` (which must live until dmi_arena_pool_put) when none is left. Any thread; wait-free.
 */
dmi_arena* dmi_arena_pool_take(dmi_arena_pool* pool, dmi_arena* own);
void dmi_arena_pool_put(dmi_arena_pool* pool, dmi_arena* arena);
void dmi_arena_pool_release(dmi_arena_pool* pool);

#endif
