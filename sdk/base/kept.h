/* Scratch memory that stays with a context from call to call. Fresh pages of the host cost as much as filling them. */
#ifndef DMI_BASE_KEPT_H
#define DMI_BASE_KEPT_H

#include "base/env.h"

/* Returns 64-byte aligned memory of at least `size` bytes, kept or of the host, not zeroed; NULL when there is none.
 * out_size gets how large it is, to be told at dmi_kept_give. Any thread. */
void* dmi_kept_take(dmi_env* env, size_t size, size_t* out_size);
/* Keeps the memory within env->kept.most bytes, and gives what is left over to the host. Any thread. */
void dmi_kept_give(dmi_env* env, void* memory, size_t size);

/* Scratch of one call, of a size that need not be told again. NULL does nothing. */
void* dmi_scratch_alloc(dmi_env* env, size_t size);
void dmi_scratch_free(dmi_env* env, void* memory);

#endif
