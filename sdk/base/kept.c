/* The kept blocks are a list, the one given last first. A block lends its own first bytes to the list. */
#include "base/kept.h"

#include <stdbool.h>

#define MOST_BLOCKS 256          /* that are kept: taking one looks at all of them; by hand */
#define LEAST_KEPT 4096          /* bytes of a block worth keeping: a page */
#define SLACK(size) ((size) / 4) /* bytes that a kept block may have more than is asked for; by hand */

struct dmi_kept_block {
    dmi_kept_block* next;
    size_t size;
};

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

/* Returns the smallest kept block that fits; NULL when none does. */
static dmi_kept_block* take_fitting(dmi_kept* kept, size_t size) {
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

void* dmi_kept_take(dmi_env* env, size_t size, size_t* out_size) {
    dmi_kept_block* block = env->kept.most > 0 ? take_fitting(&env->kept, size) : NULL;
    *out_size = block != NULL ? block->size : size;
    return block != NULL ? block : dmi_alloc(env, size, DMI_ALIGNMENT);
}

static void release_list(dmi_env* env, dmi_kept_block* list) {
    while (list != NULL) {
        dmi_kept_block* block = list;
        list = block->next;
        dmi_free(env, block, block->size);
    }
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

void dmi_kept_give(dmi_env* env, void* memory, size_t size) {
    dmi_kept* kept = &env->kept;
    if (memory == NULL) return;
    if (size < LEAST_KEPT || size > kept->most) {
        dmi_free(env, memory, size);
        return;
    }
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
    release_list(env, surplus);
}

uint64_t dmi_kept_trim(dmi_env* env) {
    dmi_kept* kept = &env->kept;
    lock(kept);
    dmi_kept_block* all = kept->blocks;
    const uint64_t bytes = kept->bytes;
    kept->blocks = NULL;
    kept->bytes = kept->count = 0;
    unlock(kept);
    release_list(env, all);
    return bytes;
}

uint64_t dmi_kept_bytes(dmi_env* env) {
    lock(&env->kept);
    const uint64_t bytes = env->kept.bytes;
    unlock(&env->kept);
    return bytes;
}

void* dmi_scratch_alloc(dmi_env* env, size_t size) {
    if (size > SIZE_MAX / 4) return NULL; /* no sum below can overflow */
    size_t taken;
    char* block = dmi_kept_take(env, DMI_ALIGNMENT + size, &taken);
    if (block == NULL) return NULL;
    *(size_t*)(void*)block = taken;
    return block + DMI_ALIGNMENT;
}

void dmi_scratch_free(dmi_env* env, void* memory) {
    if (memory == NULL) return;
    char* block = (char*)memory - DMI_ALIGNMENT;
    dmi_kept_give(env, block, *(size_t*)(void*)block);
}
