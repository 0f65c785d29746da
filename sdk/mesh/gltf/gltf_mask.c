/* Which faces move: by node names, or from a segmenter's mask. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/gltf/gltf_file.h"
#include "mesh/mask.h"

/* "#12" names node 12 of the file, unless a node is really called so. -1: not of this form, or no such node. */
static int32_t numbered_node(const dm_gltf* gltf, const char* name) {
    if (name[0] != '#' || name[1] < '0' || name[1] > '9') return -1;
    char* end;
    const unsigned long index = strtoul(name + 1, &end, 10);
    return *end == 0 && index < gltf->tree_count ? (int32_t)index : -1;
}

static int is_carried_by(const dm_gltf* gltf, int32_t node, int32_t carrier) {
    while (node >= 0 && node != carrier) node = gltf->parents[node];
    return node >= 0;
}

/* A node with a mesh stands for it, one without for all below it. Answers how many faces were set. */
static uint64_t mark_node(const dm_gltf* gltf, uint32_t index, uint8_t value, uint8_t* face_ids) {
    dmi_tiny_node from;
    dmi_tiny_get_node(gltf->tiny, index, &from);
    uint64_t set = 0;
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const dm_gltf_node* node = &gltf->nodes[i];
        if (from.mesh >= 0 ? node->node != index : !is_carried_by(gltf, (int32_t)node->node, (int32_t)index)) continue;
        memset(face_ids + node->first_face, value, node->face_count);
        set += node->face_count;
    }
    return set;
}

static uint64_t mark_name(const dm_gltf* gltf, const char* name, uint8_t value, uint8_t* face_ids) {
    uint64_t set = 0;
    int found = 0;
    for (uint32_t i = 0; i < gltf->tree_count; i++) {
        dmi_tiny_node node;
        dmi_tiny_get_node(gltf->tiny, i, &node);
        if (strcmp(node.name, name) != 0) continue;
        set += mark_node(gltf, i, value, face_ids);
        found = 1;
    }
    const int32_t number = found ? -1 : numbered_node(gltf, name);
    return number < 0 ? set : mark_node(gltf, (uint32_t)number, value, face_ids);
}

/* The first few names, for a message. */
static void list_names(const dm_gltf* gltf, char* out, size_t size) {
    size_t length = 0;
    out[0] = 0;
    for (uint32_t i = 0; i < gltf->node_count && i < 8; i++) {
        const char* name = gltf->nodes[i].name;
        const int wrote = name[0] ? snprintf(out + length, size - length, "%s'%.40s'", i ? ", " : "", name)
                                  : snprintf(out + length, size - length, "%s#%u", i ? ", " : "", gltf->nodes[i].node);
        if (wrote < 0 || (size_t)wrote >= size - length) break;
        length += (size_t)wrote;
    }
    if (gltf->node_count > 8) snprintf(out + length, size - length, " and %u more", gltf->node_count - 8);
}

dm_result dm_gltf_mark_faces(const dm_gltf* gltf, const char* const* names, uint32_t name_count, uint8_t value,
                             uint8_t* inout_face_ids, uint64_t face_count) {
    if (!gltf || !inout_face_ids || (!names && name_count > 0)) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, NULL, &gltf->env.log, NULL);
    if (face_count != gltf->face_count)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "face_count is %" PRIu64 ", the mesh has %" PRIu64, face_count,
                        gltf->face_count);
    for (uint32_t i = 0; i < name_count; i++) {
        if (!names[i]) return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "name %u is NULL", i);
        if (mark_name(gltf, names[i], value, inout_face_ids) > 0) continue;
        char known[512];
        list_names(gltf, known, sizeof known);
        return dmi_fail(&env, DM_ERROR_NOT_FOUND, "no node with triangles is called '%s'; the file has %s", names[i],
                        known);
    }
    return DM_OK;
}

/* A mask of nothing, or of everything, is a mistake that is best named where the mask is read. */
static dm_result check_share(dmi_env* env, const uint8_t* ids, uint64_t count) {
    uint64_t moving = 0;
    for (uint64_t i = 0; i < count; i++) moving += ids[i];
    if (moving == 0) return dmi_fail(env, DM_ERROR_EMPTY_MASK, "mask: none of its %" PRIu64 " values is moving", count);
    if (moving == count) return dmi_fail(env, DM_ERROR_FULL_MASK, "mask: all of its %" PRIu64 " values move", count);
    return DM_OK;
}

dm_result dm_gltf_read_mask(const dm_gltf* gltf, const void* data, size_t size, const int64_t* mask_value,
                            uint8_t* out_part_ids, int32_t* out_scope, int32_t* out_ambiguous) {
    if (!gltf || !data || !out_part_ids || !out_scope) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    int64_t* values;
    size_t count;
    int ambiguous = 0;
    dm_result result = dmi_mask_parse(&env, data, size, &values, &count);
    if (result != DM_OK) return result;
    result = dmi_mask_to_part_ids(&env, values, count, mask_value, gltf->vertex_count, gltf->face_count, out_part_ids,
                                  out_scope, &ambiguous);
    if (result == DM_OK) result = check_share(&env, out_part_ids, count);
    dmi_free(&env, values, count * sizeof *values);
    if (result == DM_OK && out_ambiguous) *out_ambiguous = ambiguous;
    return result;
}
