/* dm_gltf_get_asset: the nodes of the scene as dm_asset_create takes them, with meshes that point into the merged mesh.
 */
#include "gltf/gltf_asset.h"

#include <string.h>

#include "base/fp_environment.h"
#include "gltf/gltf_tree.h"

/* Bytes that the arena takes from the host at a time; by hand. */
#define BLOCK_SIZE ((size_t)1 << 16)

/* The joint of a second dm_gltf_node of one bone, which has triangles of another mesh: it is one with the first. */
static const dm_joint one_with_the_first = {.struct_size = sizeof(dm_joint),
                                            .type = DM_JOINT_FIXED,
                                            .type_confidence = 1,
                                            .joint_confidence = 1,
                                            .axis = {1, 0, 0},
                                            .source = DM_JOINT_FROM_HOST};

/* ---- which nodes ---- */

static bool follows(const dmi_gltf_tree_node* node) {
    return node->placed && node->in_scene && !node->shown && node->mesh >= 0;
}

/* Marks the nodes of the file that have a dm_gltf_node or carry one. */
static void mark_listed(const dm_gltf* gltf, uint32_t* places) {
    for (uint32_t i = gltf->node_count; i-- > 0;) places[gltf->nodes[i].node] = i;
    for (uint32_t at = gltf->order_count; at-- > 0;) {
        const int32_t parent = gltf->tree[gltf->order[at]].parent;
        if (parent < 0 || places[gltf->order[at]] == DM_ASSET_NO_NODE || places[parent] != DM_ASSET_NO_NODE) continue;
        places[parent] = gltf->node_count; /* a group, whose place is not known yet */
    }
}

/* Numbers the nodes of the file that are in the list, and writes which they are. Returns how many there are. */
static uint32_t list_nodes(const dm_gltf* gltf, uint32_t* places, uint32_t* file_nodes) {
    const uint32_t nodes = gltf->document.counts[DMI_GLTF_NODES];
    uint32_t count = gltf->node_count;
    for (uint32_t i = 0; i < count; i++) file_nodes[i] = gltf->nodes[i].node;
    for (uint32_t i = 0; i < nodes; i++) {
        if (places[i] != gltf->node_count) continue;
        file_nodes[count] = i;
        places[i] = count++;
    }
    for (uint32_t i = 0; i < nodes; i++) {
        if (!follows(&gltf->tree[i]) || places[i] != DM_ASSET_NO_NODE) continue;
        file_nodes[count] = i;
        places[i] = count++;
    }
    return count;
}

/* ---- what is said of them ---- */

/* Returns the nearest node above that is in the list and follows none. */
static uint32_t find_parent(const dm_gltf* gltf, const dmi_gltf_asset* asset, uint32_t node) {
    int32_t above = gltf->tree[node].parent;
    while (above >= 0 && (asset->places[above] == DM_ASSET_NO_NODE || follows(&gltf->tree[above])))
        above = gltf->tree[above].parent;
    return above < 0 ? DM_ASSET_NO_NODE : asset->places[above];
}

static const char* name_or_null(const char* name) {
    return name[0] && strlen(name) <= DM_MAX_LABEL ? name : NULL;
}

static void describe_node(const dm_gltf* gltf, const dmi_gltf_asset* asset, uint32_t index, dm_pivot* pivot) {
    const uint32_t file_node = asset->file_nodes[index];
    const dmi_gltf_tree_node* node = &gltf->tree[file_node];
    dm_asset_node* out = &asset->nodes[index];
    *out = (dm_asset_node){.struct_size = sizeof *out,
                           .parent = find_parent(gltf, asset, file_node),
                           .follows = DM_ASSET_NO_NODE,
                           .name = name_or_null(node->name),
                           .mesh_name = name_or_null(dmi_gltf_mesh_name(gltf, node))};
    if (dmi_gltf_write_pivot(gltf, node->world, pivot)) out->pivot = pivot;
    if (!out->pivot || node->pivot_kind == DMI_PIVOT_UNSET) out->flags |= DM_ASSET_NODE_NO_PIVOT;
    if (asset->places[file_node] < index && index < gltf->node_count) {
        out->parent = asset->places[file_node];
        out->joint = &one_with_the_first;
    }
    if (index >= gltf->node_count && follows(node)) {
        out->flags |= DM_ASSET_NODE_FOLLOWS;
        if (node->follows >= 0) out->follows = asset->places[node->follows];
    }
}

/* Names the meshes of bones, which are those of the nodes with the skin. */
static void name_meshes(const dm_gltf* gltf, const dmi_gltf_asset* asset) {
    for (uint32_t p = gltf->piece_count; p-- > 0;) {
        const dmi_gltf_piece* piece = &gltf->pieces[p];
        asset->nodes[piece->node].mesh_name = name_or_null(dmi_gltf_mesh_name(gltf, &gltf->tree[piece->mesh_node]));
    }
}

/* ---- meshes ---- */

/* What copying the mesh of a node needs. */
typedef struct mesh_copier {
    dm_gltf* gltf;
    dmi_arena* arena;
    /* Per merged vertex: 1 + its number in the mesh that is being copied; NULL until a mesh needs them. */
    uint32_t* numbers;
} mesh_copier;

/* Returns whether all corners of the node are vertices of its own. Faces between bones have vertices of both. */
static bool is_closed(const dm_gltf* gltf, const dm_gltf_node* node) {
    const uint32_t* corners = gltf->indices + 3 * node->first_face;
    for (uint64_t i = 0; i < 3 * node->face_count; i++)
        if (corners[i] < node->first_vertex || corners[i] - node->first_vertex >= node->vertex_count) return false;
    return true;
}

/* Copies the vertices that the corners have, in the order in which they come first, and numbers the corners. Returns
 * how many vertices there are. */
static uint64_t copy_vertices(const mesh_copier* c, const uint32_t* corners, uint64_t count, float* positions,
                              uint32_t* indices) {
    uint64_t used = 0;
    for (uint64_t i = 0; i < count; i++) {
        uint32_t* number = &c->numbers[corners[i]];
        if (*number == 0) {
            memcpy(positions + 3 * used, c->gltf->positions + 3 * (size_t)corners[i], 3 * sizeof *positions);
            *number = (uint32_t)++used;
        }
        indices[i] = *number - 1;
    }
    for (uint64_t i = 0; i < count; i++) c->numbers[corners[i]] = 0;
    return used;
}

static dm_result open_numbers(mesh_copier* c, dmi_gltf_problem* problem) {
    if (c->numbers) return DM_OK;
    c->numbers = dmi_gltf_push(c->gltf, c->arena, c->gltf->vertex_count, sizeof *c->numbers, problem);
    if (!c->numbers) return problem->code;
    memset(c->numbers, 0, c->gltf->vertex_count * sizeof *c->numbers);
    return DM_OK;
}

static dm_result copy_mesh(mesh_copier* c, const dm_gltf_node* node, dm_mesh_desc* out, dmi_gltf_problem* problem) {
    dm_gltf* gltf = c->gltf;
    const uint64_t count = 3 * node->face_count;
    const uint32_t* corners = gltf->indices + 3 * node->first_face;
    uint32_t* indices = dmi_gltf_push(gltf, c->arena, count, sizeof *indices, problem);
    if (!indices) return problem->code;
    *out = (dm_mesh_desc){.struct_size = sizeof *out,
                          .positions = gltf->positions + 3 * node->first_vertex,
                          .vertex_count = node->vertex_count,
                          .indices = indices,
                          .index_count = count};
    if (is_closed(gltf, node)) {
        for (uint64_t i = 0; i < count; i++) indices[i] = (uint32_t)(corners[i] - node->first_vertex);
        return DM_OK;
    }
    const dm_result result = open_numbers(c, problem);
    float* positions = result == DM_OK ? dmi_gltf_push(gltf, c->arena, count, 3 * sizeof *positions, problem) : NULL;
    if (!positions) return problem->code;
    out->positions = positions;
    out->vertex_count = copy_vertices(c, corners, count, positions, indices);
    return DM_OK;
}

static dm_result copy_meshes(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem) {
    mesh_copier copier = {.gltf = gltf, .arena = &asset->arena};
    dm_mesh_desc* meshes = dmi_gltf_push(gltf, &asset->arena, gltf->node_count, sizeof *meshes, problem);
    if (!meshes) return problem->code;
    for (uint32_t i = 0; i < gltf->node_count; i++) {
        const dm_result result = copy_mesh(&copier, &gltf->nodes[i], &meshes[i], problem);
        if (result != DM_OK) return result;
        asset->nodes[i].mesh = meshes[i].index_count > 0 ? &meshes[i] : NULL;
    }
    return DM_OK;
}

/* ---- the whole ---- */

static dm_result list_asset(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem) {
    const uint32_t nodes = gltf->document.counts[DMI_GLTF_NODES];
    dmi_arena* arena = &asset->arena;
    asset->places = dmi_gltf_push(gltf, arena, nodes, sizeof *asset->places, problem);
    if (asset->places)
        asset->file_nodes =
            dmi_gltf_push(gltf, arena, (uint64_t)nodes + gltf->node_count, sizeof *asset->file_nodes, problem);
    if (!asset->file_nodes) return problem->code;
    for (uint32_t i = 0; i < nodes; i++) asset->places[i] = DM_ASSET_NO_NODE;
    mark_listed(gltf, asset->places);
    asset->count = list_nodes(gltf, asset->places, asset->file_nodes);
    asset->nodes = dmi_gltf_push(gltf, arena, asset->count, sizeof *asset->nodes, problem);
    dm_pivot* pivots = asset->nodes ? dmi_gltf_push(gltf, arena, asset->count, sizeof *pivots, problem) : NULL;
    if (!pivots) return problem->code;
    for (uint32_t i = 0; i < asset->count; i++) describe_node(gltf, asset, i, &pivots[i]);
    name_meshes(gltf, asset);
    return DM_OK;
}

static dm_result build_asset(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem) {
    gltf->bytes_left = gltf->bytes_most;
    dm_result result = list_asset(gltf, asset, problem);
    if (result == DM_OK) result = copy_meshes(gltf, asset, problem);
    if (result == DM_OK) result = dmi_gltf_read_clips(gltf, asset, problem);
    return result == DM_OK ? dmi_gltf_read_joints(gltf, asset, problem) : result;
}

void dmi_gltf_release_asset(dm_gltf* gltf) {
    if (!gltf->asset) return;
    dmi_arena_release(&gltf->asset->arena);
    dmi_free(&gltf->env, gltf->asset, sizeof *gltf->asset);
    gltf->asset = NULL;
}

static dm_result open_asset(dm_gltf* gltf) {
    dmi_gltf_problem problem = {.code = DM_OK};
    gltf->asset = dmi_alloc_zeroed(&gltf->env, sizeof *gltf->asset, 16);
    if (!gltf->asset) return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for an asset");
    dmi_arena_init(&gltf->asset->arena, &gltf->env, BLOCK_SIZE);
    const dm_result result = build_asset(gltf, gltf->asset, &problem);
    dmi_gltf_log_warnings(&gltf->env, &gltf->warnings);
    if (result == DM_OK) return DM_OK;
    dmi_gltf_release_asset(gltf);
    return dmi_fail(&gltf->env, result, "%s", problem.text);
}

dm_result dm_gltf_get_asset(dm_gltf* gltf, uint32_t flags, const dm_asset_node** out_nodes, uint32_t* out_count) {
    DMI_OWN_FP;
    if (!gltf || !out_nodes || !out_count || flags != 0) return DM_ERROR_INVALID_ARGUMENT;
    const dm_result result = gltf->asset ? DM_OK : open_asset(gltf);
    if (result != DM_OK) return result;
    *out_nodes = gltf->asset->nodes;
    *out_count = gltf->asset->count;
    return DM_OK;
}

dm_result dm_gltf_get_asset_node(dm_gltf* gltf, uint32_t index, uint32_t* out_node) {
    const dm_asset_node* nodes;
    uint32_t count;
    if (!out_node) return DM_ERROR_INVALID_ARGUMENT;
    const dm_result result = dm_gltf_get_asset(gltf, 0, &nodes, &count);
    if (result != DM_OK) return result;
    if (index >= count) return DM_ERROR_NOT_FOUND;
    *out_node = gltf->asset->file_nodes[index];
    return DM_OK;
}
