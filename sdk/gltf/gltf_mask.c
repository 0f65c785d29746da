/* Finds which faces move, by node names or from a segmenter's mask. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/utf8.h"
#include "gltf/gltf_file.h"
#include "gltf/gltf_tree.h"
#include "mesh/mask.h"

/* What is known of a node of the file while names are looked up. */
enum {
    NAMED = 1,
    CARRIED = 2, /* a named one carries it */
    SOLID = 4,   /* it, or what it stands for and carries, has triangles */
    CHECKED = 8  /* it is the first of its name, all of which are NAMED */
};

/* Finds which nodes have triangles. The name of a node with a skin stands for all bones of that mesh. */
static void mark_solid(const dm_gltf* gltf, uint8_t* marks) {
    for (uint32_t i = 0; i < gltf->node_count; i++)
        if (gltf->nodes[i].face_count > 0) marks[gltf->nodes[i].node] |= SOLID;
    for (uint32_t at = gltf->order_count; at-- > 0;) {
        const uint32_t node = gltf->order[at];
        const int32_t parent = gltf->tree[node].parent;
        if (parent >= 0) marks[parent] |= marks[node] & SOLID;
    }
    for (uint32_t p = 0; p < gltf->piece_count; p++)
        if (gltf->pieces[p].joint >= 0) marks[gltf->pieces[p].mesh_node] |= SOLID;
}

/* Marks the nodes of this name. Returns whether they stand for any triangle. */
static bool mark_named(const dm_gltf* gltf, const char* name, uint8_t* marks) {
    const dmi_gltf_namesakes found = dmi_gltf_find_nodes(gltf, name);
    uint8_t all = 0;
    if (found.count == 0) return false;
    if (marks[found.first->node] & CHECKED) return true; /* the name came before, and had triangles */
    for (uint32_t i = 0; i < found.count; i++) all |= marks[found.first[i].node] |= NAMED;
    if (found.count > 1) marks[found.first->node] |= CHECKED;
    return (all & SOLID) != 0;
}

/* Marks what the named nodes carry and stand for. */
static void mark_carried(const dm_gltf* gltf, uint8_t* marks) {
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const dmi_gltf_tree_node* node = &gltf->tree[gltf->order[at]];
        if (node->parent >= 0 && marks[node->parent] & (NAMED | CARRIED)) marks[gltf->order[at]] |= CARRIED;
    }
    for (uint32_t p = 0; p < gltf->piece_count; p++) {
        const dmi_gltf_piece* piece = &gltf->pieces[p];
        if (piece->joint >= 0 && (marks[piece->mesh_node] & NAMED)) marks[gltf->nodes[piece->node].node] |= CARRIED;
    }
}

static void set_faces(const dm_gltf* gltf, const uint8_t* marks, uint8_t value, uint8_t* face_ids) {
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const dm_gltf_node* node = &gltf->nodes[i];
        if (marks[node->node] & (NAMED | CARRIED)) memset(face_ids + node->first_face, value, node->face_count);
    }
}

/* Lists the first few names for a message. */
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

static dm_result fail_to_find(dmi_env* env, const dm_gltf* gltf, const char* name) {
    char known[512];
    const int reason = gltf->left_out.code != DM_OK;
    list_names(gltf, known, sizeof known);
    return dmi_fail(env, DM_ERROR_NOT_FOUND, "no node with triangles is called '%.80s'%s%.160s%s; the file has %s",
                    name, reason ? " (" : "", reason ? gltf->left_out.text : "", reason ? " is left out)" : "", known);
}

dm_result dm_gltf_mark_faces(const dm_gltf* gltf, const char* const* names, uint32_t name_count, uint8_t value,
                             uint8_t* inout_face_ids, uint64_t face_count) {
    DMI_OWN_FP;
    if (!gltf || !inout_face_ids || (!names && name_count > 0)) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    if (face_count != gltf->face_count)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "face_count is %" PRIu64 ", the mesh has %" PRIu64, face_count,
                        gltf->face_count);
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    uint8_t* marks = dmi_alloc_zeroed(&env, count, 1);
    if (!marks) return dmi_fail(&env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u nodes", count);
    dm_result result = DM_OK;
    mark_solid(gltf, marks);
    for (uint32_t i = 0; i < name_count && result == DM_OK; i++) {
        if (!names[i])
            result = dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "name %u is NULL", i);
        else if (!mark_named(gltf, names[i], marks))
            result = fail_to_find(&env, gltf, names[i]);
    }
    if (result == DM_OK) {
        mark_carried(gltf, marks);
        set_faces(gltf, marks, value, inout_face_ids);
    }
    dmi_free(&env, marks, count);
    return result;
}

/* Checks the share of a mask. A mask of nothing, or of everything, is a mistake that is best named where the mask is
 * read. */
static dm_result check_share(dmi_env* env, const uint8_t* ids, uint64_t count) {
    uint64_t moving = 0;
    for (uint64_t i = 0; i < count; i++) moving += ids[i];
    if (moving == 0) return dmi_fail(env, DM_ERROR_EMPTY_MASK, "mask: none of its %" PRIu64 " values is moving", count);
    if (moving == count) return dmi_fail(env, DM_ERROR_FULL_MASK, "mask: all of its %" PRIu64 " values move", count);
    return DM_OK;
}

/* Writes part ids of the mask's values, in the order of the file. */
static dm_result select_values(dmi_env* env, const dm_gltf* gltf, const int64_t* values, size_t count,
                               const int64_t* mask_value, uint8_t* ids, int32_t* out_scope, int* out_ambiguous) {
    if (!ids) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "mask: no memory for %zu values", count);
    dm_result result = dmi_mask_to_part_ids(env, values, count, mask_value, gltf->vertex_count, gltf->face_count, ids,
                                            out_scope, out_ambiguous);
    return result == DM_OK ? check_share(env, ids, count) : result;
}

dm_result dm_gltf_read_mask(const dm_gltf* gltf, const void* data, size_t size, const int64_t* mask_value,
                            uint8_t* out_part_ids, int32_t* out_scope, int32_t* out_ambiguous) {
    DMI_OWN_FP;
    if (!gltf || !data || !out_part_ids || !out_scope) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    int64_t* values;
    size_t count;
    int32_t scope = DM_PER_VERTEX;
    int ambiguous = 0;
    dm_result result = dmi_mask_parse(&env, data, size, &values, &count);
    if (result != DM_OK) return result;
    uint8_t* ids = dmi_alloc(&env, count, 1);
    result = select_values(&env, gltf, values, count, mask_value, ids, &scope, &ambiguous);
    if (result == DM_OK) {
        const uint32_t* places = scope == DM_PER_VERTEX ? gltf->vertex_places : gltf->face_places;
        for (size_t i = 0; i < count; i++) out_part_ids[i] = ids[places ? places[i] : i];
        *out_scope = scope;
        if (out_ambiguous) *out_ambiguous = ambiguous;
    }
    dmi_free(&env, ids, count);
    dmi_free(&env, values, count * sizeof *values);
    return result;
}
