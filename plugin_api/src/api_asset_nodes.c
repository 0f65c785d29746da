/* Checks what a host says of its nodes, one after the other, and then how they hang together. */
#include "api_asset_nodes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "api_check.h"
#include "api_joint_check.h"
#include "api_mesh.h"
#include "assets/asset_mesh.h"
#include "assets/node_labels.h"
#include "base/utf8.h"

/* Bytes of "dm_asset_create: desc.nodes[…]", of a field of it, and of a field of that, with ten digits an index. */
enum { NODE_TEXT = 64, FIELD_TEXT = 96, KEY_TEXT = 128 };
#define LAST_ROW 1e-4f /* how far the last row of an affine transform is off 0 0 0 1: rounding; by hand */
enum { TRANSFORM = 16, COLUMN = 4 };

static dm_result out_of_memory(dmi_env* env, uint32_t count) {
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for %u nodes", count);
}

/* ---- one node ---- */

static dm_result check_name(dmi_env* env, const char* what, const char* field, const char* name) {
    if (name == NULL) return DM_OK;
    const size_t length = strnlen(name, DM_MAX_LABEL + 1);
    if (length > DM_MAX_LABEL)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "%s.%s is longer than %d bytes", what, field, DM_MAX_LABEL);
    if (dmi_utf8_is_valid(name, length)) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.%s is no UTF-8", what, field);
}

static dm_result check_index(dmi_env* env, const char* what, const char* field, uint32_t index, uint32_t count) {
    if (index == DM_ASSET_NO_NODE || index < count) return DM_OK;
    return dmi_fail(env, DM_ERROR_INDEX_OUT_OF_RANGE, "%s.%s is %u, but there are %u nodes", what, field, index, count);
}

static dm_result check_transform(dmi_env* env, const char* what, const float* transform) {
    if (transform == NULL) return DM_OK;
    char field[FIELD_TEXT];
    snprintf(field, sizeof field, "%s.transform", what);
    const dm_result result = dmi_check_finite(env, field, transform, TRANSFORM);
    for (int column = 0; column < COLUMN && result == DM_OK; column++) {
        const float number = transform[COLUMN * column + 3], right = column == 3 ? 1.0f : 0.0f;
        if (!(fabsf(number - right) <= LAST_ROW))
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                            "%s.transform[%d] is %g: it must be %g, columns come one after the other", what,
                            COLUMN * column + 3, (double)number, (double)right);
    }
    return result;
}

static dm_result check_pivot(dmi_env* env, const char* what, const dm_pivot* pivot) {
    if (pivot == NULL) return DM_OK;
    char field[FIELD_TEXT];
    snprintf(field, sizeof field, "%s.pivot", what);
    const float origin[3] = {pivot->origin.x, pivot->origin.y, pivot->origin.z};
    const dm_result result = dmi_check_finite(env, field, origin, 3);
    return result == DM_OK ? dmi_check_finite(env, field, pivot->axes, sizeof pivot->axes / sizeof *pivot->axes)
                           : result;
}

static dm_result check_keys(dmi_env* env, const char* what, const dm_asset_clip* clip) {
    for (uint32_t k = 0; k < clip->key_count; k++) {
        if (!isfinite(clip->times[k]))
            return dmi_fail(env, DM_ERROR_NOT_FINITE, "%s.times[%u] is %g", what, k, (double)clip->times[k]);
        if (k > 0 && clip->times[k] < clip->times[k - 1])
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.times[%u] is %g, less than the time before", what, k,
                            (double)clip->times[k]);
        char field[KEY_TEXT];
        snprintf(field, sizeof field, "%s.poses[%u]", what, k);
        dm_pose pose;
        const dm_result result = dmi_check_pose(env, field, &clip->poses[k], &pose);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

static dm_result check_clips(dmi_env* env, const char* node, const dm_asset_node* given) {
    if ((given->clips == NULL) != (given->clip_count == 0))
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.clips is %s but clip_count is %u", node,
                        given->clips != NULL ? "given" : "NULL", given->clip_count);
    for (uint32_t i = 0; i < given->clip_count; i++) {
        const dm_asset_clip* clip = &given->clips[i];
        char what[FIELD_TEXT];
        snprintf(what, sizeof what, "%s.clips[%u]", node, i);
        if (clip->flags & ~(uint32_t)DM_CLIP_NOT_RIGID)
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.flags is 0x%x: unknown flag", what, clip->flags);
        if (clip->times == NULL || clip->poses == NULL || clip->key_count == 0)
            return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s has no keys", what);
        dm_result result = check_name(env, what, "name", clip->name);
        if (result == DM_OK) result = check_keys(env, what, clip);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

static dm_result check_numbers(dmi_env* env, const char* what, const dm_asset_node* node, uint32_t count) {
    const uint32_t known = DM_ASSET_NODE_FOLLOWS | DM_ASSET_NODE_NO_PIVOT;
    if (node->flags & ~known)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.flags is 0x%x: unknown flag", what, node->flags);
    if (node->reserved != 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "%s.reserved is %u: it must be 0", what, node->reserved);
    dm_result result = check_index(env, what, "parent", node->parent, count);
    if (result == DM_OK && (node->flags & DM_ASSET_NODE_FOLLOWS))
        result = check_index(env, what, "follows", node->follows, count);
    if (result == DM_OK) result = check_name(env, what, "name", node->name);
    if (result == DM_OK) result = check_name(env, what, "mesh_name", node->mesh_name);
    if (result == DM_OK) result = check_transform(env, what, node->transform);
    if (result == DM_OK) result = check_pivot(env, what, node->pivot);
    return result == DM_OK ? check_clips(env, what, node) : result;
}

/* ---- what a node points to ---- */

static dm_result read_mesh(dmi_arena* arena, const char* what, dm_asset_node* node) {
    if (node->mesh == NULL) return DM_OK;
    char field[FIELD_TEXT];
    snprintf(field, sizeof field, "%s.mesh", what);
    dm_mesh_desc* mesh = dmi_arena_push(arena, sizeof *mesh);
    if (mesh == NULL) return out_of_memory(arena->env, 1);
    const dm_result result = dmi_mesh_desc_read(arena->env, field, node->mesh, mesh);
    if (result == DM_OK && mesh->part_ids != NULL)
        return dmi_fail(arena->env, DM_ERROR_INVALID_ARGUMENT, "%s.part_ids must be NULL: a node is of one part",
                        field);
    node->mesh = mesh;
    return result;
}

static dm_result read_joint(dmi_arena* arena, const char* what, dm_asset_node* node) {
    if (node->joint == NULL) return DM_OK;
    char field[FIELD_TEXT];
    snprintf(field, sizeof field, "%s.joint", what);
    dm_joint* joint = dmi_arena_push(arena, sizeof *joint);
    if (joint == NULL) return out_of_memory(arena->env, 1);
    dm_result result = dmi_joint_read(arena->env, field, node->joint, joint);
    if (result == DM_OK) result = dmi_joint_check(arena->env, field, joint, DM_JOINT_REVOLUTE);
    node->joint = joint;
    return result;
}

dm_result dmi_asset_joints_accept(dmi_env* env, dm_asset_node* nodes, uint32_t count, float size) {
    for (uint32_t i = 0; i < count; i++) {
        if (nodes[i].joint == NULL) continue;
        char what[FIELD_TEXT];
        snprintf(what, sizeof what, "dm_asset_create: desc.nodes[%u].joint", i);
        /* The copy belongs to the library: dmi_asset_nodes_read has made it. */
        const dm_result result = dmi_joint_accept(env, what, size, (dm_joint*)nodes[i].joint);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

/* ---- all nodes ---- */

static dm_result check_count(dmi_env* env, const dm_asset_desc* desc) {
    if (desc->nodes == NULL || desc->node_count == 0)
        return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT, "dm_asset_create: desc.nodes is %s and desc.node_count is %u",
                        desc->nodes != NULL ? "given" : "NULL", desc->node_count);
    if (desc->node_count <= DM_MAX_ASSET_NODES) return DM_OK;
    return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_asset_create: desc.node_count is %u: the most is %d", desc->node_count,
                    DM_MAX_ASSET_NODES);
}

static dm_result check_meshes(dmi_env* env, const dm_asset_node* nodes, uint32_t count) {
    uint32_t meshes = 0;
    for (uint32_t i = 0; i < count; i++) meshes += dmi_asset_node_counts(&nodes[i]);
    if (meshes > DM_MAX_PARTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE, "dm_asset_create: %u of desc.nodes have meshes: the most is %d",
                        meshes, DM_MAX_PARTS);
    if (meshes > 0) return DM_OK;
    return dmi_fail(env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_asset_create: none of desc.nodes has a mesh without DM_ASSET_NODE_FOLLOWS");
}

/* Checks that neither parents nor followed nodes form a circle. */
static dm_result check_circles(dmi_arena* arena, const dm_asset_node* nodes, uint32_t count) {
    uint32_t *above = dmi_arena_push(arena, count * sizeof *above),
             *order = dmi_arena_push(arena, count * sizeof *order);
    uint8_t* done = dmi_arena_push(arena, count);
    if (above == NULL || order == NULL || done == NULL) return out_of_memory(arena->env, count);
    for (uint32_t i = 0; i < count; i++) above[i] = nodes[i].parent;
    uint32_t node = dmi_asset_order_nodes(above, count, order, done);
    if (node != DM_ASSET_NO_NODE)
        return dmi_fail(arena->env, DM_ERROR_INVALID_ARGUMENT,
                        "dm_asset_create: desc.nodes[%u].parent: the nodes above it form a circle (none: "
                        "DM_ASSET_NO_NODE)",
                        node);
    for (uint32_t i = 0; i < count; i++) above[i] = dmi_asset_followed(&nodes[i]);
    node = dmi_asset_order_nodes(above, count, order, done);
    if (node == DM_ASSET_NO_NODE) return DM_OK;
    return dmi_fail(arena->env, DM_ERROR_INVALID_ARGUMENT,
                    "dm_asset_create: desc.nodes[%u].follows: the nodes that it follows form a circle", node);
}

/* Reads the host's array, whose stride is the host's struct_size. */
static dm_result read_nodes(dmi_arena* arena, const dm_asset_desc* desc, dm_asset_node* out) {
    dmi_env* env = arena->env;
    const uint8_t* next = (const uint8_t*)desc->nodes;
    const uint32_t step = desc->nodes[0].struct_size;
    for (uint32_t i = 0; i < desc->node_count; i++, next += step) {
        char what[NODE_TEXT];
        snprintf(what, sizeof what, "dm_asset_create: desc.nodes[%u]", i);
        /* NOLINTNEXTLINE(bugprone-sizeof-expression): the field is a pointer */
        dm_result result = dmi_read_desc(env, what, next, DMI_FIRST_SIZE(dm_asset_node, joint), sizeof *out, &out[i]);
        if (result == DM_OK && out[i].struct_size != step)
            result = dmi_fail(env, DM_ERROR_STRUCT_SIZE, "%s.struct_size is %u, but that of the first node is %u", what,
                              out[i].struct_size, step);
        if (result == DM_OK) result = check_numbers(env, what, &out[i], desc->node_count);
        if (result == DM_OK) result = read_mesh(arena, what, &out[i]);
        if (result == DM_OK) result = read_joint(arena, what, &out[i]);
        if (result != DM_OK) return result;
    }
    return DM_OK;
}

dm_result dmi_asset_nodes_read(dmi_arena* arena, const dm_asset_desc* desc, dm_asset_node** out_nodes) {
    dm_result result = check_count(arena->env, desc);
    if (result != DM_OK) return result;
    dm_asset_node* nodes = dmi_arena_push(arena, desc->node_count * sizeof *nodes);
    if (nodes == NULL) return out_of_memory(arena->env, desc->node_count);
    result = read_nodes(arena, desc, nodes);
    if (result == DM_OK) result = check_meshes(arena->env, nodes, desc->node_count);
    if (result == DM_OK) result = check_circles(arena, nodes, desc->node_count);
    *out_nodes = nodes;
    return result;
}
