/* Scratch memory of one call: bump allocation, released all at once. */
#ifndef DMI_BASE_ARENA_H
#define DMI_BASE_ARENA_H

#include "base/env.h"

typedef struct dmi_arena_block dmi_arena_block;
typedef struct dmi_arena {
    dmi_env* env;
    dmi_arena_block* blocks; /* newest first */
    size_t block_size;
} dmi_arena;

void dmi_arena_init(dmi_arena* arena, dmi_env* env, size_t block_size);
/* 64-byte aligned, not zeroed; NULL when the host has no memory. */
void* dmi_arena_push(dmi_arena* arena, size_t size);
void dmi_arena_release(dmi_arena* arena);

#endif
