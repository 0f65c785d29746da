/* Bump allocator for scratch memory: rewound to a mark and filled again, released all at once. */
#ifndef DMI_BASE_ARENA_H
#define DMI_BASE_ARENA_H

#include "base/env.h"

typedef struct dmi_arena_block dmi_arena_block;
typedef struct dmi_arena {
    dmi_env* env;
    dmi_arena_block* blocks; /* newest first, but for those of large requests */
    dmi_arena_block* spare;  /* rewound, used before the host is asked for more */
    size_t block_size;
    uint64_t added; /* blocks so far, reused ones counted again */
} dmi_arena;

/* Fill state of an arena; zeros: empty. */
typedef struct dmi_arena_mark {
    size_t used; /* bytes of the block in use */
    uint64_t added;
} dmi_arena_mark;

void dmi_arena_init(dmi_arena* arena, dmi_env* env, size_t block_size);
/* Allocates 64-byte aligned memory, not zeroed; NULL when the host has none. */
void* dmi_arena_push(dmi_arena* arena, size_t size);
dmi_arena_mark dmi_arena_get_mark(const dmi_arena* arena);
/* Frees what was pushed since the mark. The arena keeps the memory for later pushes: fresh pages of the host would cost
 * as much as filling them. */
void dmi_arena_rewind(dmi_arena* arena, dmi_arena_mark mark);
/* Gives all memory back: what the environment keeps serves other arenas, the host gets the rest. */
void dmi_arena_release(dmi_arena* arena);

/* ---- pool ---- */

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
