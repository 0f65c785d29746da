/* Scratch memory: blocks from the host, cut from front to back, given back together. */
#include "base/arena.h"

#define ALIGNMENT 64

struct dmi_arena_block {
    dmi_arena_block* next;
    size_t capacity, used; /* of the bytes behind the header */
};

#define HEADER_SIZE ((sizeof(dmi_arena_block) + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT)

void dmi_arena_init(dmi_arena* arena, dmi_env* env, size_t block_size) {
    *arena = (dmi_arena){.env = env, .block_size = block_size};
}

static dmi_arena_block* add_block(dmi_arena* arena, size_t capacity) {
    dmi_arena_block* block = dmi_alloc(arena->env, HEADER_SIZE + capacity, ALIGNMENT);
    if (block == NULL) return NULL;
    block->capacity = capacity;
    block->used = 0;
    if (arena->blocks != NULL && capacity > arena->block_size) {
        /* A block for one big request goes behind the current one, whose rest stays in use. */
        block->next = arena->blocks->next;
        arena->blocks->next = block;
    } else {
        block->next = arena->blocks;
        arena->blocks = block;
    }
    return block;
}

void* dmi_arena_push(dmi_arena* arena, size_t size) {
    if (size > SIZE_MAX / 4) return NULL;
    size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    dmi_arena_block* block = arena->blocks;
    if (block == NULL || block->capacity - block->used < size) {
        block = add_block(arena, size > arena->block_size ? size : arena->block_size);
        if (block == NULL) return NULL;
    }
    void* memory = (char*)block + HEADER_SIZE + block->used;
    block->used += size;
    return memory;
}

void dmi_arena_release(dmi_arena* arena) {
    while (arena->blocks != NULL) {
        dmi_arena_block* block = arena->blocks;
        arena->blocks = block->next;
        dmi_free(arena->env, block, HEADER_SIZE + block->capacity);
    }
}
