/* Which faces move: by node names, or from a segmenter's mask. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/fp_environment.h"
#include "base/utf8.h"
#include "mesh/gltf/gltf_file.h"
#include "mesh/gltf/gltf_names.h"
#include "mesh/mask.h"

/* "#12" names node 12 of the file, unless a node is really called so. -1: not of this form, or no such node. */
static int64_t numbered_node(const dm_gltf* gltf, const char* name) {
    if (name[0] != '#' || name[1] < '0' || name[1] > '9') return -1;
    char* end;
    const unsigned long index = strtoul(name + 1, &end, 10);
    return *end == 0 && index < gltf->document.counts[DMI_GLTF_NODES] ? (int64_t)index : -1;
}

int64_t dmi_gltf_find_node(const dm_gltf* gltf, const char* name) {
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++)
        if (dmi_utf8_mends_to(name, gltf->tree[i].name)) return i;
    return numbered_node(gltf, name);
}

/* Marks the named nodes and all that they carry, in `marks`: a byte a node of the file. Returns whether one is named
 * so. */
static int mark_nodes(const dm_gltf* gltf, const char* name, uint8_t* marks) {
    enum { CARRIED = 1, NAMED = 2 };
    int found = 0;
    for (uint32_t i = 0; i < gltf->document.counts[DMI_GLTF_NODES]; i++) {
        marks[i] = dmi_utf8_mends_to(name, gltf->tree[i].name) ? NAMED : 0;
        found |= marks[i];
    }
    const int64_t number = found ? -1 : numbered_node(gltf, name);
    if (number >= 0) marks[number] = NAMED;
    for (uint32_t at = 0; at < gltf->order_count; at++) {
        const dmi_gltf_tree_node* node = &gltf->tree[gltf->order[at]];
        if (node->parent >= 0 && marks[node->parent]) marks[gltf->order[at]] |= CARRIED;
    }
    /* The name of a node with a skin stands for all bones of that mesh. */
    for (uint32_t p = 0; p < gltf->piece_count; p++) {
        const dmi_gltf_piece* piece = &gltf->pieces[p];
        if (piece->joint >= 0 && (marks[piece->mesh_node] & NAMED)) marks[gltf->nodes[piece->node].node] |= CARRIED;
    }
    return found || number >= 0;
}

/* Adds the nodes that a name stands for to `chosen`; returns how many faces they have. marks: scratch, one a node. */
static uint64_t choose_name(const dm_gltf* gltf, const char* name, uint8_t* marks, uint8_t* chosen) {
    uint64_t faces = 0;
    if (!mark_nodes(gltf, name, marks)) return 0;
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const dm_gltf_node* node = &gltf->nodes[i];
        if (!marks[node->node]) continue;
        chosen[i] = 1;
        faces += node->face_count;
    }
    return faces;
}

static void set_faces(const dm_gltf* gltf, const uint8_t* chosen, uint8_t value, uint8_t* face_ids) {
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const dm_gltf_node* node = &gltf->nodes[i];
        if (chosen[i]) memset(face_ids + node->first_face, value, node->face_count);
    }
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
    DMI_OWN_FP;
    if (!gltf || !inout_face_ids || (!names && name_count > 0)) return DM_ERROR_INVALID_ARGUMENT;
    dmi_env env;
    dmi_env_init(&env, &gltf->env.allocator, &gltf->env.log, NULL);
    if (face_count != gltf->face_count)
        return dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "face_count is %" PRIu64 ", the mesh has %" PRIu64, face_count,
                        gltf->face_count);
    const uint32_t count = gltf->document.counts[DMI_GLTF_NODES];
    const size_t size = (size_t)count + gltf->node_count;
    uint8_t* marks = dmi_alloc_zeroed(&env, size, 1); /* of nodes of the file, then of those that have triangles */
    if (!marks) return dmi_fail(&env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u nodes", count);
    uint8_t* chosen = marks + count;
    dm_result result = DM_OK;
    for (uint32_t i = 0; i < name_count && result == DM_OK; i++) {
        char known[512];
        if (!names[i]) {
            result = dmi_fail(&env, DM_ERROR_INVALID_ARGUMENT, "name %u is NULL", i);
        } else if (choose_name(gltf, names[i], marks, chosen) == 0) {
            const int reason = gltf->left_out.code != DM_OK;
            list_names(gltf, known, sizeof known);
            result = dmi_fail(
                &env, DM_ERROR_NOT_FOUND, "no node with triangles is called '%.80s'%s%.160s%s; the file has %s",
                names[i], reason ? " (" : "", reason ? gltf->left_out.text : "", reason ? " is left out)" : "", known);
        }
    }
    if (result == DM_OK) set_faces(gltf, chosen, value, inout_face_ids);
    dmi_free(&env, marks, size);
    return result;
}

/* A mask of nothing, or of everything, is a mistake that is best named where the mask is read. */
static dm_result check_share(dmi_env* env, const uint8_t* ids, uint64_t count) {
    uint64_t moving = 0;
    for (uint64_t i = 0; i < count; i++) moving += ids[i];
    if (moving == 0) return dmi_fail(env, DM_ERROR_EMPTY_MASK, "mask: none of its %" PRIu64 " values is moving", count);
    if (moving == count) return dmi_fail(env, DM_ERROR_FULL_MASK, "mask: all of its %" PRIu64 " values move", count);
    return DM_OK;
}

/* Part ids of the mask's values, in the order of the file. */
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
