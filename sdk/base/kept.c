/* Scratch memory of a context, out of its list of kept blocks or of the host. */
#include "base/kept.h"

#define LEAST_KEPT 4096 /* bytes of a block worth keeping: a page */

void* dmi_kept_take(dmi_env* env, size_t size, size_t* out_size) {
    dmi_kept_block* block = env->kept.most > 0 ? dmi_kept_list_take(&env->kept, size) : NULL;
    *out_size = block != NULL ? block->size : size;
    return block != NULL ? block : dmi_alloc(env, size, DMI_ALIGNMENT);
}

void dmi_kept_give(dmi_env* env, void* memory, size_t size) {
    if (memory == NULL) return;
    if (size < LEAST_KEPT || size > env->kept.most)
        dmi_free(env, memory, size);
    else
        dmi_free_blocks(env, dmi_kept_list_give(&env->kept, memory, size));
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
