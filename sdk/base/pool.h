/* Handles: 64-bit ids with a generation that refer to items without owning them. Look-up never locks. */
#ifndef DMI_BASE_POOL_H
#define DMI_BASE_POOL_H

#include "base/env.h"

/* Layout of a handle: kind (8 bits, non-zero) | generation (32, non-zero) | index (24). */
#define DMI_HANDLE_KIND_SHIFT 56
#define DMI_HANDLE_GENERATION_SHIFT 24

typedef struct dmi_pool dmi_pool;

dm_result dmi_pool_create(dmi_env* env, uint8_t kind, dmi_pool** out_pool);
/* The items must have been removed. NULL does nothing. */
void dmi_pool_destroy(dmi_pool* pool);

/* Thread-safe. The first dmi_pool_insert after a remove reuses its slot with a new generation, and no handle is given
 * twice. TOO_LARGE when no index is left. */
dm_result dmi_pool_insert(dmi_pool* pool, void* item, uint64_t* out_handle);
/* Returns the item; NULL for null, stale or foreign handles. Wait-free. */
void* dmi_pool_get(const dmi_pool* pool, uint64_t handle);
/* Removes and returns the item, which the caller then owns, or NULL. Thread-safe. */
void* dmi_pool_remove(dmi_pool* pool, uint64_t handle);
/* Returns any live item and its handle, for emptying a pool; NULL when empty. */
void* dmi_pool_any(const dmi_pool* pool, uint64_t* out_handle);

#endif
