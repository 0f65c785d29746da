/* Which nodes of the file are which part: the asset's own answer. */
#include <stdlib.h>
#include <string.h>

#include "../common/platform.h"
#include "files.h"
#include "parts.h"

/* The file's name without folders and ending. */
static void write_stem(const char* file, char* out, size_t room) {
    const char* name = file;
    for (const char* at = file; *at; at++)
        if (*at == '/' || *at == '\\') name = at + 1;
    const char* end = strrchr(name, '.');
    snprintf(out, room, "%.*s", (int)(end != NULL && end > name ? end - name : (ptrdiff_t)strlen(name)), name);
    dm_gltf_mend_text(out);
}

static dm_result ask(world* world, const char* file, const dm_asset_node** out_nodes, dm_asset* out_asset) {
    char label[WORLD_NAME];
    uint32_t count;
    write_stem(file, label, sizeof label);
    const dm_result result = dm_gltf_get_asset(world->gltf, 0, out_nodes, &count);
    if (result != DM_OK) return result;
    const dm_asset_desc desc = {.struct_size = sizeof desc,
                                .flags = dm_gltf_left_out(world->gltf) ? DM_PREPARE_MESH_INCOMPLETE : 0u,
                                .nodes = *out_nodes,
                                .node_count = count,
                                .label = label,
                                .model = world->model,
                                .seed = 1};
    return dm_asset_create(world->context, &desc, out_asset);
}

/* The highest node of a part that is above the one with the most triangles names it. */
static const char* name_of(const dm_asset_node* nodes, const uint32_t* part_of_node, uint32_t part, uint32_t count) {
    uint32_t top = DM_ASSET_NO_NODE;
    uint64_t most = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint64_t size = nodes[n].mesh != NULL ? nodes[n].mesh->index_count : 0;
        if (part_of_node[n] == part && (top == DM_ASSET_NO_NODE || size > most)) top = n, most = size;
    }
    while (nodes[top].parent != DM_ASSET_NO_NODE && part_of_node[nodes[top].parent] == part) top = nodes[top].parent;
    return nodes[top].name != NULL && nodes[top].name[0] ? nodes[top].name : "part";
}

/* The nodes with triangles are the first of the asset's. */
static void mark_faces(world* world, const uint32_t* part_of_node, const uint8_t* id_of_part) {
    dm_gltf_node node;
    for (uint32_t n = 0; n < dm_gltf_node_count(world->gltf); n++) {
        if (part_of_node[n] == DM_ASSET_NO_PART || dm_gltf_get_node(world->gltf, n, &node) != DM_OK) continue;
        memset(world->face_part + node.first_face, id_of_part[part_of_node[n]], node.face_count);
    }
}

static dm_result read_parts(world* world, dm_asset asset, const dm_asset_node* nodes) {
    dm_asset_info info = dm_asset_info_default();
    dm_result result = dm_asset_get_info(world->context, asset, &info);
    uint32_t* part_of_node = take(info.node_count + 1, sizeof *part_of_node);
    uint8_t* id_of_part = take(info.part_count + 1, 1);
    if (result == DM_OK) result = dm_asset_get_node_parts(world->context, asset, part_of_node, info.node_count);
    for (uint32_t i = 0; i < info.part_count && result == DM_OK; i++) {
        dm_asset_part part = dm_asset_part_default();
        result = dm_asset_get_part(world->context, asset, i, &part);
        if (part.part_id == 0) continue;
        const uint32_t id = parts_add(world, name_of(nodes, part_of_node, i, info.node_count));
        id_of_part[i] = (uint8_t)id;
        world->parts[id].is_free = part.state == DM_ASSET_FREE;
        if (part.parent != DM_ASSET_NO_PART) world->parts[id].parent = part.parent + 1;
        world->parts[id].is_stated = part.basis != DM_ASSET_INFERRED;
    }
    if (result == DM_OK) mark_faces(world, part_of_node, id_of_part);
    free(part_of_node);
    free(id_of_part);
    return result;
}

int parts_from_asset(world* world, const char* file, int prepare) {
    const dm_asset_node* nodes;
    dm_asset asset;
    dm_result result = ask(world, file, &nodes, &asset);
    if (result != DM_OK) return -1;
    result = read_parts(world, asset, nodes);
    if (result == DM_OK && prepare && world->part_count > 0)
        result = dm_asset_make_object(world->context, asset, &world->object);
    dm_asset_destroy(world->context, asset);
    return result == DM_OK ? 0 : -1;
}
