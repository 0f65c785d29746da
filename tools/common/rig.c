/* Hands the file's nodes over, and asks for the parts. */
#include "rig.h"

#include <stdlib.h>
#include <string.h>

static dm_result read_part(session* session, uint32_t index, rig* rig) {
    rig_part* out = &rig->parts[index];
    *out = (rig_part){.part = dm_asset_part_default(), .joint = dm_joint_default()};
    dm_result result = dm_asset_get_part(session->context, rig->asset, index, &out->part);
    if (result == DM_OK) result = dm_asset_get_joint(session->context, rig->asset, index, &out->joint);
    if (result != DM_OK) return result;
    out->nodes = cli_alloc(out->part.node_count * sizeof *out->nodes);
    return dm_asset_get_part_nodes(session->context, rig->asset, index, out->nodes, out->part.node_count);
}

static dm_result read_parts(session* session, rig* rig) {
    rig->info = dm_asset_info_default();
    dm_result result = dm_asset_get_info(session->context, rig->asset, &rig->info);
    if (result != DM_OK) return result;
    rig->parts = cli_alloc_zeroed(rig->info.part_count * sizeof *rig->parts);
    for (uint32_t i = 0; i < rig->info.part_count && result == DM_OK; i++) result = read_part(session, i, rig);
    return result;
}

/* The nodes as the asset gets them: those of the file, or where their origins shall say nothing copies. */
static const dm_asset_node* take_nodes(const rig* rig, const rig_options* options, dm_asset_node** out_copies) {
    *out_copies = NULL;
    if (!options->without_pivots) return rig->nodes;
    *out_copies = cli_alloc(rig->node_count * sizeof **out_copies);
    memcpy(*out_copies, rig->nodes, rig->node_count * sizeof **out_copies);
    for (uint32_t i = 0; i < rig->node_count; i++) (*out_copies)[i].flags |= DM_ASSET_NODE_NO_PIVOT;
    return *out_copies;
}

static dm_vec3 up_of(char letter) {
    return (dm_vec3){.x = letter == 'x', .y = letter == 'y', .z = letter == 'z'};
}

dm_result rig_make(session* session, const char* path, const rig_options* options, rig* out_rig) {
    const double start = cli_now_ms();
    char label[DM_MAX_LABEL + 1];
    *out_rig = (rig){.nodes = NULL};
    dm_result result = session_use_file(session, path);
    if (result == DM_OK) result = dm_gltf_get_asset(session->gltf, 0, &out_rig->nodes, &out_rig->node_count);
    if (result != DM_OK) return result;
    part_hints_file_stem(path, label, sizeof label);
    dm_asset_node* copies;
    const dm_asset_desc desc = {.struct_size = sizeof desc,
                                .flags = session_prepare_flags(session) |
                                         (options->without_clips ? DM_ASSET_WITHOUT_CLIPS : 0u) |
                                         (options->without_names ? DM_ASSET_WITHOUT_NAMES : 0u),
                                .nodes = take_nodes(out_rig, options, &copies),
                                .node_count = out_rig->node_count,
                                .label = label,
                                .min_moves = (float)options->min_moves,
                                .model = session->model,
                                .up = up_of(options->up)};
    result = dm_asset_create(session->context, &desc, &out_rig->asset);
    free(copies);
    if (result == DM_OK) result = read_parts(session, out_rig);
    out_rig->seconds = (cli_now_ms() - start) / 1e3;
    return result;
}

void rig_free(session* session, rig* rig) {
    for (uint32_t i = 0; rig->parts != NULL && i < rig->info.part_count; i++) free(rig->parts[i].nodes);
    free(rig->parts);
    if (rig->asset) dm_asset_destroy(session->context, rig->asset);
}

static bool has_node(const rig_part* part, uint32_t node) {
    for (uint32_t i = 0; i < part->part.node_count; i++)
        if (part->nodes[i] == node) return true;
    return false;
}

static uint64_t index_count(const rig* rig, uint32_t node) {
    return rig->nodes[node].mesh != NULL ? rig->nodes[node].mesh->index_count : 0;
}

/* Returns the highest node of the part above one of it. */
static uint32_t top_of(const rig* rig, const rig_part* part, uint32_t node) {
    while (rig->nodes[node].parent != DM_ASSET_NO_NODE && has_node(part, rig->nodes[node].parent))
        node = rig->nodes[node].parent;
    return node;
}

const char* rig_part_name(const rig* rig, uint32_t index) {
    const rig_part* part = &rig->parts[index];
    const char* name = NULL;
    uint64_t most = 0;
    for (uint32_t i = 0; i < part->part.node_count; i++) {
        const uint32_t node = part->nodes[i];
        if (name != NULL && index_count(rig, node) <= most) continue;
        most = index_count(rig, node);
        name = rig->nodes[top_of(rig, part, node)].name;
    }
    return name != NULL ? name : "";
}

/* Returns the id of the part with which a part goes: its own, or where it stays that of what carries it. */
static uint32_t moving_id(const rig* rig, uint32_t index) {
    while (index != DM_ASSET_NO_PART && rig->parts[index].part.part_id == 0) index = rig->parts[index].part.parent;
    return index != DM_ASSET_NO_PART ? rig->parts[index].part.part_id : 0;
}

uint32_t* rig_face_parts(const session* session, const rig* rig) {
    uint32_t* out = cli_alloc_zeroed(session->mesh.index_count / 3 * sizeof *out);
    for (uint32_t i = 0; i < rig->info.part_count; i++) {
        const rig_part* part = &rig->parts[i];
        const uint32_t id = moving_id(rig, i);
        for (uint32_t k = 0; k < part->part.node_count; k++) {
            dm_gltf_node node; /* the file's list of nodes with triangles is the beginning of the asset's */
            if (dm_gltf_get_node(session->gltf, part->nodes[k], &node) != DM_OK) continue;
            for (uint64_t face = 0; face < node.face_count; face++) out[node.first_face + face] = id;
        }
    }
    return out;
}
