/* A fixed number of arenas, each with an atomic flag that its current user holds. */
#include "base/arena_pool.h"

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
