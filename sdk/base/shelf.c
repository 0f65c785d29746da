/* Arenas beside each other, each with a flag that says who may touch it. */
#include "base/shelf.h"

void dmi_shelf_init(dmi_shelf* shelf, dmi_env* env, size_t block_size) {
    for (int i = 0; i < DMI_SHELF_ARENAS; i++) {
        dmi_arena_init(&shelf->arenas[i], env, block_size);
        atomic_init(&shelf->taken[i], 0);
    }
}

dmi_arena* dmi_shelf_take(dmi_shelf* shelf, dmi_arena* own) {
    for (int i = 0; i < DMI_SHELF_ARENAS; i++)
        if (atomic_exchange_explicit(&shelf->taken[i], 1, memory_order_acquire) == 0) return &shelf->arenas[i];
    dmi_arena_init(own, shelf->arenas[0].env, shelf->arenas[0].block_size);
    return own;
}

void dmi_shelf_put(dmi_shelf* shelf, dmi_arena* arena) {
    for (int i = 0; i < DMI_SHELF_ARENAS; i++) {
        if (arena != &shelf->arenas[i]) continue;
        dmi_arena_rewind(arena, (dmi_arena_mark){0});
        atomic_store_explicit(&shelf->taken[i], 0, memory_order_release);
        return;
    }
    dmi_arena_release(arena);
}

void dmi_shelf_release(dmi_shelf* shelf) {
    for (int i = 0; i < DMI_SHELF_ARENAS; i++) dmi_arena_release(&shelf->arenas[i]);
}
