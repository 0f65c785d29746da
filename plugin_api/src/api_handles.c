/* Look-up of handles, and the lists that objects keep of what depends on them. */
#include "api_handles.h"

void dmi_lock(dm_context* context) {
    while (atomic_flag_test_and_set_explicit(&context->lock, memory_order_acquire)) {
    }
}

void dmi_unlock(dm_context* context) {
    atomic_flag_clear_explicit(&context->lock, memory_order_release);
}

static const char* kind_name(uint64_t handle) {
    static const char* const names[] = {"no kind", "a model", "an object", "a motion", "a drag", "a scene", "an asset"};
    uint64_t kind = handle >> DMI_HANDLE_KIND_SHIFT;
    return kind < sizeof names / sizeof *names ? names[kind] : names[0];
}

static void report_stale(dm_context* context, const char* function, uint64_t handle) {
    dmi_fail(&context->env, DM_ERROR_STALE_HANDLE, "%s: handle 0x%016llx (%s) is null, destroyed or not of this kind",
             function, (unsigned long long)handle, kind_name(handle));
}

void* dmi_find(dm_context* context, const dmi_pool* pool, const char* function, uint64_t handle) {
    void* item = dmi_pool_get(pool, handle);
    if (item == NULL) report_stale(context, function, handle);
    return item;
}

void* dmi_take(dm_context* context, dmi_pool* pool, const char* function, uint64_t handle) {
    void* item = dmi_pool_remove(pool, handle);
    if (item == NULL) report_stale(context, function, handle);
    return item;
}

dm_result dmi_dependent_add(dm_context* context, dmi_pool* pool, dmi_dependent** list, dmi_dependent* item) {
    dm_result result = dmi_pool_insert(pool, item, &item->handle);
    if (result != DM_OK) return result;
    dmi_lock(context);
    item->previous = NULL;
    item->next = *list;
    if (item->next != NULL) item->next->previous = item;
    *list = item;
    dmi_unlock(context);
    return DM_OK;
}

void dmi_dependent_unlink(dm_context* context, dmi_dependent** list, dmi_dependent* item) {
    dmi_lock(context);
    if (item->next != NULL) item->next->previous = item->previous;
    if (item->previous != NULL) {
        item->previous->next = item->next;
    } else {
        *list = item->next;
    }
    dmi_unlock(context);
}

dm_result dmi_find_part(dm_context* context, const char* function, const dmi_object* object, uint32_t part_id,
                        uint32_t* out_index) {
    int32_t index = dmi_object_find_part(object, part_id);
    if (index > 0) {
        *out_index = (uint32_t)index;
        return DM_OK;
    }
    if (part_id == 0)
        return dmi_fail(&context->env, DM_ERROR_NOT_FOUND, "%s: part 0 is the body, which has no joint", function);
    return dmi_fail(&context->env, DM_ERROR_NOT_FOUND, "%s: the object has no part %u", function, part_id);
}
