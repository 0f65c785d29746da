/* Scratch memory: bump allocation, given back down to a mark to be pushed again, released all at once. */
#ifndef DMI_BASE_ARENA_H
#define DMI_BASE_ARENA_H

#include "base/env.h"

typedef struct dmi_arena_block dmi_arena_block;
typedef struct dmi_arena {
    dmi_env* env;
    dmi_arena_block* blocks; /* newest first, but for those of big requests */
    dmi_arena_block* spare;  /* given back, to be used before the host is asked for more */
    size_t block_size;
    uint64_t added; /* blocks so far, spare ones each time they were used again */
} dmi_arena;

/* How far an arena was filled; one of zeros: empty. */
typedef struct dmi_arena_mark {
    size_t used; /* of the block in use */
    uint64_t added;
} dmi_arena_mark;

void dmi_arena_init(dmi_arena* arena, dmi_env* env, size_t block_size);
/* 64-byte aligned, not zeroed; NULL when the host has no memory. */
void* dmi_arena_push(dmi_arena* arena, size_t size);
dmi_arena_mark dmi_arena_get_mark(const dmi_arena* arena);
/* All that was pushed since the mark is given back to the arena, which keeps the memory: the next user finds its pages
 * in place, where fresh ones cost as much as filling them. */
void dmi_arena_rewind(dmi_arena* arena, dmi_arena_mark mark);
/* Back to the host. */
void dmi_arena_release(dmi_arena* arena);

#endif
