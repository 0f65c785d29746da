/* Arenas beside each other, each with a flag that says who may touch it. */
#include "base/arena_pool.h"

void dmi_arena_pool_init(dmi_arena_pool* shelf, dmi_env* env, size_t block_size) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) {
        dmi_arena_init(&shelf->arenas[i], env, block_size);
        atomic_init(&shelf->taken[i], 0);
    }
}

dmi_arena* dmi_arena_pool_take(dmi_arena_pool* shelf, dmi_arena* own) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++)
        if (atomic_exchange_explicit(&shelf->taken[i], 1, memory_order_acquire) == 0) return &shelf->arenas[i];
    dmi_arena_init(own, shelf->arenas[0].env, shelf->arenas[0].block_size);
    return own;
}

void dmi_arena_pool_put(dmi_arena_pool* shelf, dmi_arena* arena) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) {
        if (arena != &shelf->arenas[i]) continue;
        dmi_arena_rewind(arena, (dmi_arena_mark){0});
        atomic_store_explicit(&shelf->taken[i], 0, memory_order_release);
        return;
    }
    dmi_arena_release(arena);
}

void dmi_arena_pool_release(dmi_arena_pool* shelf) {
    for (int i = 0; i < DMI_ARENA_POOL_SIZE; i++) dmi_arena_release(&shelf->arenas[i]);
}
