/* Scratch memory of tasks: each takes an arena and puts it back, emptied but with its memory, for the next. */
#ifndef DMI_BASE_ARENA_POOL_H
#define DMI_BASE_ARENA_POOL_H

#include "base/arena.h"

/* Tasks beyond so many at once have memory of their own. */
#define DMI_ARENA_POOL_SIZE 16

typedef struct dmi_arena_pool {
    dmi_arena arenas[DMI_ARENA_POOL_SIZE];
    _Atomic uint32_t taken[DMI_ARENA_POOL_SIZE];
} dmi_arena_pool;

void dmi_arena_pool_init(dmi_arena_pool* shelf, dmi_env* env, size_t block_size);
/* On any thread; no call waits. own: for when no arena is left, must live until dmi_arena_pool_put. */
dmi_arena* dmi_arena_pool_take(dmi_arena_pool* shelf, dmi_arena* own);
void dmi_arena_pool_put(dmi_arena_pool* shelf, dmi_arena* arena);
void dmi_arena_pool_release(dmi_arena_pool* shelf);

#endif
