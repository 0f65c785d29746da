/* Which faces of the file belong to which part: from names, from nodes, from a file. By hand: parts_paint.c. */
#include "parts.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

uint32_t parts_add(world* world, const char* name) {
    if (world->part_count == WORLD_MAX_PARTS) return 0;
    world_part* part = &world->parts[++world->part_count];
    memset(part, 0, sizeof *part);
    part->id = world->part_count;
    part->state = dm_part_state_default();
    part->state.pose = part->carried = pose_identity;
    snprintf(part->name, sizeof part->name, "%s", name);
    dm_gltf_mend_text(part->name); /* a name that was cut */
    return part->id;
}

uint32_t parts_node_of_face(const world* world, uint32_t face) {
    dm_gltf_node node;
    for (uint32_t i = 0; i < dm_gltf_node_count(world->gltf); i++)
        if (dm_gltf_get_node(world->gltf, i, &node) == DM_OK && face - node.first_face < node.face_count) return i;
    return 0;
}

/* ---- from lists of names ---- */

/* Marks the nodes of a comma-separated list. */
static int mark_list(world* world, const char* list, uint8_t id, uint8_t* faces) {
    char* copy = take(strlen(list) + 1, 1);
    memcpy(copy, list, strlen(list) + 1);
    dm_result result = DM_OK;
    for (char *rest = copy, *name; result == DM_OK && (name = strtok_r(rest, ",", &rest)) != NULL;) {
        const char* names[1] = {name};
        result = dm_gltf_mark_faces(world->gltf, names, 1, id, faces, world->face_count);
    }
    free(copy);
    return result == DM_OK ? 0 : -1;
}

static uint32_t count_marked(const uint8_t* faces, uint32_t count) {
    uint32_t marked = 0;
    for (uint32_t i = 0; i < count; i++) marked += faces[i] != 0;
    return marked;
}

/* Gives a part its faces; what held the first of them before carries it. */
static void claim(world* world, uint32_t id, const uint8_t* marked) {
    for (uint32_t i = 0; i < world->face_count; i++) {
        if (!marked[i]) continue;
        if (world->parts[id].parent == 0) world->parts[id].parent = world->face_part[i];
        world->face_part[i] = (uint8_t)id;
    }
}

/* Larger lists first, so that a list inside another takes its faces from it. */
int parts_from_names(world* world, const char* const* lists, uint32_t count) {
    uint8_t* marked = take((size_t)world->face_count * count, 1);
    uint32_t* sizes = take(count, sizeof *sizes);
    int status = 0;
    for (uint32_t i = 0; i < count && status == 0; i++) {
        status = mark_list(world, lists[i], 1, marked + (size_t)i * world->face_count);
        sizes[i] = count_marked(marked + (size_t)i * world->face_count, world->face_count);
    }
    for (uint32_t n = 0; n < count && status == 0; n++) {
        uint32_t largest = 0;
        for (uint32_t i = 1; i < count; i++)
            if (sizes[i] > sizes[largest]) largest = i;
        sizes[largest] = 0;
        const uint32_t id = parts_add(world, lists[largest]);
        if (id) claim(world, id, marked + (size_t)largest * world->face_count);
    }
    free(marked);
    free(sizes);
    return status;
}

/* ---- from nodes ---- */

static float node_diagonal(const world* world, const dm_gltf_node* node) {
    dm_vec3 low = vec(INFINITY, INFINITY, INFINITY), high = scale(low, -1);
    for (uint64_t v = node->first_vertex; v < node->first_vertex + node->vertex_count; v++) {
        const dm_vec3 p = vec_from((const float*)world->mesh.positions + 3 * v);
        low = vec_min(low, p), high = vec_max(high, p);
    }
    return node->vertex_count ? length(sub(high, low)) : 0;
}

static void node_becomes(world* world, const dm_gltf_node* node, uint32_t id) {
    memset(world->face_part + node->first_face, (int)id, node->face_count);
}

static uint32_t part_of_node(world* world, const dm_gltf_node* node) {
    char name[WORLD_NAME];
    snprintf(name, sizeof name, "%.40s", node->name);
    if (!name[0]) snprintf(name, sizeof name, "node %u", (unsigned)node->node);
    const uint32_t id = parts_add(world, name);
    node_becomes(world, node, id);
    return id;
}

/* Nodes go with what carries them. */
static void find_carriers(world* world) {
    dm_gltf_node node, carrier;
    for (uint32_t i = 0; i < dm_gltf_node_count(world->gltf); i++) {
        if (dm_gltf_get_node(world->gltf, i, &node) != DM_OK || node.face_count == 0) continue;
        if (dm_gltf_get_node(world->gltf, node.carrier, &carrier) != DM_OK || carrier.face_count == 0) continue;
        const uint32_t id = world->face_part[node.first_face];
        if (id) world->parts[id].parent = world->face_part[carrier.first_face];
    }
}

void parts_from_nodes(world* world) {
    dm_gltf_node node;
    uint32_t body = 0;
    float size = -1;
    for (uint32_t i = 0; i < dm_gltf_node_count(world->gltf); i++) {
        if (dm_gltf_get_node(world->gltf, i, &node) != DM_OK || node_diagonal(world, &node) <= size) continue;
        size = node_diagonal(world, &node);
        body = i;
    }
    for (uint32_t i = 0; i < dm_gltf_node_count(world->gltf); i++)
        if (i != body && dm_gltf_get_node(world->gltf, i, &node) == DM_OK && node.face_count > 0)
            part_of_node(world, &node);
    find_carriers(world);
}

void parts_clear(world* world) {
    memset(world->face_part, 0, world->face_count);
    world->part_count = 0;
}

void parts_toggle_node(world* world, uint32_t face) {
    dm_gltf_node node;
    if (dm_gltf_get_node(world->gltf, parts_node_of_face(world, face), &node) != DM_OK) return;
    if (world->face_part[face])
        node_becomes(world, &node, 0);
    else
        part_of_node(world, &node);
    parts_tidy(world);
}

/* ---- after changes ---- */

void parts_tidy(world* world) {
    uint32_t faces[256] = {0}, renamed[256] = {0}, count = 0;
    for (uint32_t i = 0; i < world->face_count; i++) faces[world->face_part[i]]++;
    for (uint32_t id = 1; id <= world->part_count; id++) {
        if (!faces[id]) continue;
        renamed[id] = ++count;
        world->parts[count] = world->parts[id];
        world->parts[count].id = count;
    }
    for (uint32_t id = 1; id <= count; id++) world->parts[id].parent = renamed[world->parts[id].parent];
    for (uint32_t i = 0; i < world->face_count; i++) world->face_part[i] = (uint8_t)renamed[world->face_part[i]];
    world->part_count = count;
}

/* ---- from a file ---- */

/* NumPy's format 1.0: a header padded to 64 bytes, then one byte a face. Segmenters and dragmesh's own tools read it.
 */
uint8_t* parts_encode(const world* world, size_t* out_size) {
    char header[128];
    uint8_t* bytes = take(sizeof header + world->face_count, 1);
    memset(bytes, ' ', sizeof header);
    memcpy(bytes, "\x93NUMPY\x01\x00\x76\x00", 10);
    const int length = snprintf(header, sizeof header, "{'descr': '|u1', 'fortran_order': False, 'shape': (%u,), }",
                                (unsigned)world->face_count);
    memcpy(bytes + 10, header, (size_t)length);
    bytes[sizeof header - 1] = '\n';
    memcpy(bytes + sizeof header, world->face_part, world->face_count);
    *out_size = sizeof header + world->face_count;
    return bytes;
}

int parts_load(world* world, const char* path) {
    size_t size = 0;
    char* bytes = file_read(path, &size);
    const bool fits =
        bytes != NULL && size == 128 + (size_t)world->face_count && memcmp(bytes, "\x93NUMPY\x01", 7) == 0;
    uint32_t most = 0;
    for (uint32_t i = 0; fits && i < world->face_count; i++) {
        const uint8_t id = (uint8_t)bytes[128 + i];
        world->face_part[i] = id <= WORLD_MAX_PARTS ? id : 0;
        if (world->face_part[i] > most) most = world->face_part[i];
    }
    for (uint32_t id = 1; id <= most; id++) {
        char name[32];
        snprintf(name, sizeof name, "part %u", (unsigned)id);
        parts_add(world, name);
    }
    free(bytes);
    return fits ? 0 : -1;
}
