#include "base/kept_list.h"

#include <stdbool.h>

#define MOST_BLOCKS 256          /* that are kept: taking one looks at all of them; by hand */
#define SLACK(size) ((size) / 4) /* bytes that a kept block may have more than is asked for; by hand */

static void lock(dmi_kept* kept) {
    while (atomic_flag_test_and_set_explicit(&kept->lock, memory_order_acquire)) {
    }
}

static void unlock(dmi_kept* kept) {
    atomic_flag_clear_explicit(&kept->lock, memory_order_release);
}

static dmi_kept_block* unlink_block(dmi_kept* kept, dmi_kept_block** at) {
    dmi_kept_block* block = *at;
    *at = block->next;
    kept->bytes -= block->size;
    kept->count--;
    return block;
}

dmi_kept_block* dmi_kept_list_take(dmi_kept* kept, size_t size) {
    dmi_kept_block** best = NULL;
    lock(kept);
    for (dmi_kept_block** at = &kept->blocks; *at != NULL; at = &(*at)->next) {
        const size_t has = (*at)->size;
        if (has >= size && has - size <= SLACK(size) && (best == NULL || has < (*best)->size)) best = at;
    }
    dmi_kept_block* block = best != NULL ? unlink_block(kept, best) : NULL;
    unlock(kept);
    return block;
}

/* Takes the blocks that were given first until what is left is within the bounds; returns them. */
static dmi_kept_block* take_surplus(dmi_kept* kept) {
    dmi_kept_block** at = &kept->blocks;
    size_t bytes = 0, count = 0;
    while (*at != NULL && count < MOST_BLOCKS && (*at)->size <= kept->most - bytes) {
        bytes += (*at)->size;
        count++;
        at = &(*at)->next;
    }
    dmi_kept_block* surplus = *at;
    *at = NULL;
    kept->bytes = bytes;
    kept->count = count;
    return surplus;
}

dmi_kept_block* dmi_kept_list_give(dmi_kept* kept, void* memory, size_t size) {
    dmi_kept_block* block = memory;
    block->size = size;
    lock(kept);
    block->next = kept->blocks;
    kept->blocks = block;
    kept->bytes += size;
    kept->count++;
    const bool full = kept->bytes > kept->most || kept->count > MOST_BLOCKS;
    dmi_kept_block* surplus = full ? take_surplus(kept) : NULL;
    unlock(kept);
    return surplus;
}

dmi_kept_block* dmi_kept_list_empty(dmi_kept* kept, size_t* out_bytes) {
    lock(kept);
    dmi_kept_block* all = kept->blocks;
    *out_bytes = kept->bytes;
    kept->blocks = NULL;
    kept->bytes = kept->count = 0;
    unlock(kept);
    return all;
}

size_t dmi_kept_list_bytes(dmi_kept* kept) {
    lock(kept);
    const size_t bytes = kept->bytes;
    unlock(kept);
    return bytes;
}
