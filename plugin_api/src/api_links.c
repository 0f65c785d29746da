/* Links between the parts of an object. */
#include <math.h>
#include <string.h>

#include "api_check.h"
#include "api_handles.h"
#include "base/fp_environment.h"

static dm_result check_link(dmi_env* env, const dm_link* link, uint32_t index) {
    const float numbers[3] = {link->ratio, link->offset, link->from};
    const uint32_t known = link->kind == DM_LINK_MOVES ? DM_LINK_BOTH_WAYS : 0;
    dm_result result = dmi_check_range(env, "dm_object_set_links: kind", link->kind, DM_LINK_MOVES, DM_LINK_HOLDS);
    for (int i = 0; result == DM_OK && i < 3; i++)
        result = dmi_check_number(env, "dm_object_set_links: ratio, offset or from", "", numbers[i]);
    if (result != DM_OK || !(link->flags & ~known)) return result;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_object_set_links: links[%u].flags is 0x%x: unknown flag", index,
                    link->flags);
}

static dm_result read_link(dm_context* context, const dmi_object* object, const dm_link* given, uint32_t index,
                           dmi_link* out) {
    uint32_t driver, driven;
    dm_result result = check_link(&context->env, given, index);
    if (result == DM_OK) result = dmi_find_part(context, "dm_object_set_links: driver", object, given->driver, &driver);
    if (result == DM_OK) result = dmi_find_part(context, "dm_object_set_links: driven", object, given->driven, &driven);
    if (result != DM_OK) return result;
    *out = (dmi_link){.driver = driver - 1,
                      .driven = driven - 1,
                      .kind = given->kind,
                      .both_ways = (given->flags & DM_LINK_BOTH_WAYS) != 0,
                      .ratio = given->ratio != 0 ? given->ratio : 1,
                      .offset = given->offset,
                      .from = given->from};
    return DM_OK;
}

/* Reads links into `out`, which has room for twice as many. */
static dm_result read_links(dm_context* context, const dmi_object* object, const dm_link* links, uint32_t count,
                            dmi_link* out) {
    for (uint32_t i = 0; i < count; i++) {
        dm_result result = read_link(context, object, &links[i], i, &out[i]);
        if (result != DM_OK) return result;
    }
    if (dmi_links_order(out, count, out + count)) return DM_OK;
    return dmi_fail(&context->env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_object_set_links: a part is moved by two drivers, or by itself over others");
}

dm_result DM_CALL dm_object_set_links(dm_context* context, dm_object object, const dm_link* links, uint32_t count) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env* env = &context->env;
    dmi_object_slot* slot = dmi_find(context, context->objects, "dm_object_set_links", object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    if (count > DM_MAX_LINKS || (count > 0 && links == NULL)) {
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_object_set_links: count is %u: it must be 0 to %d, and the size of links", count,
                        DM_MAX_LINKS);
    }
    dmi_link read[2 * DM_MAX_LINKS], *kept = NULL;
    dm_result result = read_links(context, slot->object, links, count, read);
    if (result != DM_OK) return result;
    if (count > 0) kept = dmi_alloc(env, count * sizeof *kept, _Alignof(dmi_link));
    if (count > 0 && kept == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_object_set_links: no memory");
    if (count > 0) memcpy(kept, read, count * sizeof *kept);
    dmi_free(env, slot->links, slot->link_count * sizeof *slot->links);
    slot->links = kept, slot->link_count = count;
    return DM_OK;
}

static dm_result check_values(const dmi_object* object, const float* values, uint32_t count) {
    if (count != object->part_count - 1 || (count > 0 && values == NULL)) return DM_ERROR_INVALID_ARGUMENT;
    for (uint32_t i = 0; i < count; i++) {
        dm_result result = dmi_check_number(DMI_SILENT, "inout_values", "[]", values[i]);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

dm_result DM_CALL dm_object_follow_links(dm_context* context, dm_object object, uint32_t part_id, float* inout_values,
                                         uint8_t* out_held, uint32_t count) {
    DMI_OWN_FP;
    if (context == NULL) return DM_ERROR_INVALID_ARGUMENT;
    const dmi_object_slot* slot = dmi_pool_get(context->objects, object);
    if (slot == NULL) return DM_ERROR_STALE_HANDLE;
    dm_result result = check_values(slot->object, inout_values, count);
    if (result != DM_OK) return result;
    const int32_t part = dmi_object_find_part(slot->object, part_id);
    if (part <= 0) return DM_ERROR_NOT_FOUND;
    uint8_t changed[DM_MAX_PARTS];
    memset(changed, 0, count);
    const dmi_linked_joints joints = {&slot->object->parts[1].joint, sizeof *slot->object->parts};
    dmi_links_follow(slot->links, slot->link_count, joints, (uint32_t)part - 1, inout_values, changed);
    if (out_held != NULL) dmi_links_hold(slot->links, slot->link_count, inout_values, out_held, count);
    return DM_OK;
}
