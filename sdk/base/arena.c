/* Bump allocator: blocks from the host, filled from front to back, released together or down to a mark. */
#include "base/arena.h"

#include "base/env.h"

struct dmi_arena_block {
    dmi_arena_block* next;
    size_t capacity, used; /* bytes after the header */
    uint64_t number;       /* number of the block in its arena; the oldest is 1 */
};

#define HEADER_SIZE ((sizeof(dmi_arena_block) + DMI_ALIGNMENT - 1) / DMI_ALIGNMENT * DMI_ALIGNMENT)

void dmi_arena_init(dmi_arena* arena, dmi_env* env, size_t block_size) {
    *arena = (dmi_arena){.env = env, .block_size = block_size};
}

/* Removes and returns the smallest spare block that is large enough; NULL when none is. */
static dmi_arena_block* take_spare(dmi_arena* arena, size_t capacity) {
    dmi_arena_block** best = NULL;
    for (dmi_arena_block** at = &arena->spare; *at != NULL; at = &(*at)->next)
        if ((*at)->capacity >= capacity && (best == NULL || (*at)->capacity < (*best)->capacity)) best = at;
    if (best == NULL) return NULL;
    dmi_arena_block* block = *best;
    *best = block->next;
    return block;
}

static dmi_arena_block* new_block(dmi_arena* arena, size_t capacity) {
    size_t size;
    dmi_arena_block* block = dmi_kept_take(arena->env, HEADER_SIZE + capacity, &size);
    if (block != NULL) block->capacity = size - HEADER_SIZE;
    return block;
}

static dmi_arena_block* add_block(dmi_arena* arena, size_t capacity) {
    dmi_arena_block* block = take_spare(arena, capacity);
    if (block == NULL) block = new_block(arena, capacity);
    if (block == NULL) return NULL;
    block->used = 0;
    block->number = ++arena->added;
    if (arena->blocks != NULL && capacity > arena->block_size) {
        /* A block for one large request goes after the current one, whose rest stays in use. */
        block->next = arena->blocks->next;
        arena->blocks->next = block;
    } else {
        block->next = arena->blocks;
        arena->blocks = block;
    }
    return block;
}

void* dmi_arena_push(dmi_arena* arena, size_t size) {
    if (size > SIZE_MAX / 4) return NULL; /* no sum below can overflow */
    size = (size + DMI_ALIGNMENT - 1) / DMI_ALIGNMENT * DMI_ALIGNMENT;
    dmi_arena_block* block = arena->blocks;
    if (block == NULL || block->capacity - block->used < size) {
        block = add_block(arena, size > arena->block_size ? size : arena->block_size);
        if (block == NULL) return NULL;
    }
    void* memory = (char*)block + HEADER_SIZE + block->used;
    block->used += size;
    return memory;
}

dmi_arena_mark dmi_arena_get_mark(const dmi_arena* arena) {
    return (dmi_arena_mark){.used = arena->blocks != NULL ? arena->blocks->used : 0, .added = arena->added};
}

void dmi_arena_rewind(dmi_arena* arena, dmi_arena_mark mark) {
    for (dmi_arena_block** at = &arena->blocks; *at != NULL;) {
        dmi_arena_block* block = *at;
        if (block->number <= mark.added) {
            at = &block->next;
            continue;
        }
        *at = block->next;
        block->next = arena->spare;
        arena->spare = block;
    }
    if (arena->blocks != NULL) arena->blocks->used = mark.used;
}

static void release_list(dmi_env* env, dmi_arena_block* list) {
    while (list != NULL) {
        dmi_arena_block* block = list;
        list = block->next;
        dmi_kept_give(env, block, HEADER_SIZE + block->capacity);
    }
}

void dmi_arena_release(dmi_arena* arena) {
    release_list(arena->env, arena->blocks);
    release_list(arena->env, arena->spare);
    arena->blocks = arena->spare = NULL;
}

/* ---- pool ---- */

void dmi_arena_pool_init(dmi_arena_pool* pool, dmi_env* env, size_t block_size) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) {
        dmi_arena_init(&pool->arenas[i], env, block_size);
        atomic_init(&pool->taken[i], 0);
    }
}

dmi_arena* dmi_arena_pool_take(dmi_arena_pool* pool, dmi_arena* own) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++)
        if (atomic_exchange_explicit(&pool->taken[i], 1, memory_order_acquire) == 0) return &pool->arenas[i];
    dmi_arena_init(own, pool->arenas[0].env, pool->arenas[0].block_size);
    return own;
}

void dmi_arena_pool_put(dmi_arena_pool* pool, dmi_arena* arena) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) {
        if (arena != &pool->arenas[i]) continue;
        dmi_arena_rewind(arena, (dmi_arena_mark){0});
        atomic_store_explicit(&pool->taken[i], 0, memory_order_release);
        return;
    }
    dmi_arena_release(arena);
}

void dmi_arena_pool_release(dmi_arena_pool* pool) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) dmi_arena_release(&pool->arenas[i]);
}
