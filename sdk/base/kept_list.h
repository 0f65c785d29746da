/* A list of memory blocks, the one given last first. A block lends its own first bytes to the list. Any thread may call
 * the functions. */
#ifndef DMI_BASE_KEPT_LIST_H
#define DMI_BASE_KEPT_LIST_H

#include <stdatomic.h>
#include <stddef.h>

typedef struct dmi_kept_block {
    struct dmi_kept_block* next;
    size_t size; /* bytes of the block, these included */
} dmi_kept_block;

typedef struct dmi_kept {
    atomic_flag lock; /* a spin lock, held while the list is walked; no [frame] function takes it */
    dmi_kept_block* blocks;
    size_t bytes, count; /* bytes and blocks of the list */
    size_t most;         /* bytes; 0: nothing is kept */
} dmi_kept;

/* Takes the smallest block that has `size` bytes and few more; NULL when there is none. */
dmi_kept_block* dmi_kept_list_take(dmi_kept* kept, size_t size);
/* Adds memory of `size` bytes. Returns the blocks that no longer fit into the list, those given first; NULL: none. */
dmi_kept_block* dmi_kept_list_give(dmi_kept* kept, void* memory, size_t size);
/* Takes all blocks; out_bytes gets how many bytes these have. */
dmi_kept_block* dmi_kept_list_empty(dmi_kept* kept, size_t* out_bytes);
/* Returns how many bytes the blocks of the list have. */
size_t dmi_kept_list_bytes(dmi_kept* kept);

#endif
