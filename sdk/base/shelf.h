/* Scratch memory of tasks: each takes an arena and puts it back, emptied but with its memory, for the next. */
#ifndef DMI_BASE_SHELF_H
#define DMI_BASE_SHELF_H

#include "base/arena.h"

/* Tasks beyond so many at once have memory of their own. */
#define DMI_SHELF_ARENAS 16

typedef struct dmi_shelf {
    dmi_arena arenas[DMI_SHELF_ARENAS];
    _Atomic uint32_t taken[DMI_SHELF_ARENAS];
} dmi_shelf;

void dmi_shelf_init(dmi_shelf* shelf, dmi_env* env, size_t block_size);
/* On any thread; no call waits. own: for when no arena is left, must live until dmi_shelf_put. */
dmi_arena* dmi_shelf_take(dmi_shelf* shelf, dmi_arena* own);
void dmi_shelf_put(dmi_shelf* shelf, dmi_arena* arena);
void dmi_shelf_release(dmi_shelf* shelf);

#endif
