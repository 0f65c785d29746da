/* The merged mesh: every triangle that the scene shows, node by node, primitive by primitive, in the scene's frame. */
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "mesh/gltf/gltf_accessor.h"
#include "mesh/gltf/gltf_merge.h"

/* Longest description of a place in a file ("node 3 'door', primitive 0"). */
#define PLACE_SIZE 192

/* Logs a warning, for what is left out of a file. */
static void warn(dmi_env* env, const char* format, ...) DMI_PRINTF(2, 3);

static void warn(dmi_env* env, const char* format, ...) {
    if (!env->log.message) return;
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    env->log.message(env->log.user, DM_LOG_WARNING, DM_OK, text);
}

static void describe(const dm_gltf* gltf, uint32_t node, uint32_t primitive, const char* what, char* out) {
    dmi_tiny_node from;
    dmi_tiny_get_node(gltf->tiny, node, &from);
    snprintf(out, PLACE_SIZE, "glTF node %u '%.80s', primitive %u, %s", node, from.name, primitive, what);
}

/* Triangles of `count` corners; -1 when they don't make whole ones. */
static int64_t triangle_count(int32_t mode, uint64_t count) {
    if (mode == DMI_TINY_TRIANGLES) return count % 3 == 0 ? (int64_t)(count / 3) : -1;
    return count < 3 ? 0 : (int64_t)count - 2;
}

/* 1 when the primitive has triangles that this library reads. */
static int is_readable(dm_gltf* gltf, uint32_t node, uint32_t index, const dmi_tiny_primitive* primitive) {
    if (primitive->mode < DMI_TINY_TRIANGLES || primitive->mode > DMI_TINY_FAN) {
        warn(&gltf->env, "glTF node %u, primitive %u: points and lines are left out", node, index);
        return 0;
    }
    if (primitive->positions < 0) {
        warn(&gltf->env, "glTF node %u, primitive %u: left out, it has no POSITION", node, index);
        return 0;
    }
    if (primitive->morphs) warn(&gltf->env, "glTF node %u, primitive %u: its morph targets are left out", node, index);
    return 1;
}

static dm_result count_piece(dm_gltf* gltf, uint32_t node, const dmi_tiny_primitive* primitive, dmi_gltf_piece* piece) {
    char place[PLACE_SIZE];
    dmi_gltf_elements positions, indices;
    describe(gltf, node, piece->primitive, "POSITION", place);
    dm_result result = dmi_gltf_find_elements(&gltf->env, gltf->tiny, primitive->positions, place, &positions);
    if (result != DM_OK) return result;
    if (positions.components != 3)
        return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "%s: %d components a vertex", place, positions.components);
    uint64_t corners = positions.count;
    if (primitive->indices >= 0) {
        describe(gltf, node, piece->primitive, "indices", place);
        result = dmi_gltf_find_elements(&gltf->env, gltf->tiny, primitive->indices, place, &indices);
        if (result != DM_OK) return result;
        if (indices.components != 1 ||
            (indices.component_type != DMI_TINY_UBYTE && indices.component_type != DMI_TINY_USHORT &&
             indices.component_type != DMI_TINY_UINT))
            return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "%s: component type %d, %d components", place,
                            indices.component_type, indices.components);
        corners = indices.count;
    }
    const int64_t faces = triangle_count(primitive->mode, corners);
    if (faces < 0)
        return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "%s: %" PRIu64 " corners are not a multiple of 3", place,
                        corners);
    piece->first_vertex = gltf->vertex_count;
    piece->vertex_count = positions.count;
    piece->first_face = gltf->face_count;
    piece->face_count = (uint64_t)faces;
    gltf->vertex_count += piece->vertex_count;
    gltf->face_count += piece->face_count;
    if (gltf->vertex_count > DM_MAX_ELEMENTS || gltf->face_count > DM_MAX_ELEMENTS)
        return dmi_fail(&gltf->env, DM_ERROR_TOO_LARGE, "%s: the scene has more than %d vertices or triangles so far",
                        place, DM_MAX_ELEMENTS);
    return DM_OK;
}

static int turns_over(const double m[16]) {
    return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) +
               m[8] * (m[1] * m[6] - m[5] * m[2]) <
           0;
}

/* Counts the node's triangles and enters it when it has some. */
static dm_result enter_node(dm_gltf* gltf, uint32_t index) {
    dmi_tiny_node from;
    dmi_tiny_get_node(gltf->tiny, index, &from);
    if (from.mesh < 0) return DM_OK;
    if (!dmi_tiny_has_mesh(gltf->tiny, from.mesh))
        return dmi_fail(&gltf->env, DM_ERROR_BAD_DATA, "glTF node %u '%s': mesh %d does not exist", index, from.name,
                        from.mesh);
    if (from.skin >= 0) warn(&gltf->env, "glTF node %u '%s': its skin is left out", index, from.name);
    if (from.instanced) warn(&gltf->env, "glTF node %u '%s': only one of its instances is read", index, from.name);
    dm_gltf_node* node = &gltf->nodes[gltf->node_count];
    *node = (dm_gltf_node){.name = from.name,
                           .node = index,
                           .first_vertex = gltf->vertex_count,
                           .first_face = gltf->face_count,
                           .colour = {1, 1, 1, 1}};
    const uint32_t primitives = dmi_tiny_primitive_count(gltf->tiny, from.mesh), first = gltf->piece_count;
    for (uint32_t p = 0; p < primitives; p++) {
        dmi_tiny_primitive primitive;
        dmi_tiny_get_primitive(gltf->tiny, from.mesh, p, &primitive);
        if (primitive.compressed)
            return dmi_fail(&gltf->env, DM_ERROR_UNSUPPORTED, "glTF node %u '%s', primitive %u: Draco compression",
                            index, from.name, p);
        if (!is_readable(gltf, index, p, &primitive)) continue;
        dmi_gltf_piece* piece = &gltf->pieces[gltf->piece_count];
        *piece = (dmi_gltf_piece){
            .node = gltf->node_count, .primitive = p, .mirrored = turns_over(gltf->worlds + 16 * (size_t)index)};
        const dm_result result = count_piece(gltf, index, &primitive, piece);
        if (result != DM_OK) return result;
        if (gltf->piece_count++ == first) dmi_tiny_get_colour(gltf->tiny, primitive.material, node->colour);
    }
    node->vertex_count = gltf->vertex_count - node->first_vertex;
    node->face_count = gltf->face_count - node->first_face;
    if (gltf->piece_count > first) gltf->node_count++;
    return DM_OK;
}

/* In the order of the file, not of the walk. */
static dm_result enter_nodes(dm_gltf* gltf) {
    uint64_t nodes = 0, pieces = 0;
    uint8_t* shown = dmi_alloc_zeroed(&gltf->env, gltf->tree_count, 1);
    if (!shown) return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %u nodes", gltf->tree_count);
    for (uint32_t i = 0; i < gltf->order_count; i++) {
        dmi_tiny_node node;
        dmi_tiny_get_node(gltf->tiny, gltf->order[i], &node);
        shown[gltf->order[i]] = 1;
        nodes += node.mesh >= 0;
        pieces += dmi_tiny_primitive_count(gltf->tiny, node.mesh);
    }
    dm_result result = DM_OK;
    gltf->nodes = dmi_alloc(&gltf->env, nodes * sizeof *gltf->nodes, 16);
    gltf->pieces = dmi_alloc(&gltf->env, pieces * sizeof *gltf->pieces, 16);
    gltf->node_capacity = nodes;
    gltf->piece_capacity = pieces;
    if (!gltf->nodes || !gltf->pieces)
        result = dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "glTF: no memory for %" PRIu64 " primitives", pieces);
    for (uint32_t i = 0; i < gltf->tree_count && result == DM_OK; i++) {
        if (shown[i]) result = enter_node(gltf, i);
    }
    dmi_free(&gltf->env, shown, gltf->tree_count);
    return result;
}

/* Vertex `v` of the merged mesh := the node's transform of `local`; 0 when that is not finite. */
static int place_vertex(dm_gltf* gltf, const double world[16], uint64_t v, const double local[3]) {
    float* out = gltf->positions + 3 * v;
    for (int row = 0; row < 3; row++)
        out[row] =
            (float)(world[row] * local[0] + world[4 + row] * local[1] + world[8 + row] * local[2] + world[12 + row]);
    return isfinite(out[0]) && isfinite(out[1]) && isfinite(out[2]);
}

static dm_result fill_vertices(dm_gltf* gltf, const dmi_gltf_piece* piece, const dmi_gltf_elements* from,
                               const char* place) {
    const double* world = gltf->worlds + 16 * (size_t)gltf->nodes[piece->node].node;
    for (uint64_t i = 0; i < from->count + from->change_count; i++) {
        const int changed = i >= from->count;
        const uint64_t v = changed ? dmi_gltf_changed(from, i - from->count) : i;
        double local[3];
        for (int k = 0; k < 3; k++)
            local[k] = changed ? dmi_gltf_change(from, i - from->count, k) : dmi_gltf_element(from, i, k);
        if (!place_vertex(gltf, world, piece->first_vertex + v, local))
            return dmi_fail(&gltf->env, DM_ERROR_NOT_FINITE, "%s: vertex %" PRIu64 " is (%g, %g, %g)", place, v,
                            local[0], local[1], local[2]);
    }
    return DM_OK;
}

/* Corner `corner` of triangle `face`, as a position in the primitive's list (glTF 2.0 §3.7.2.1). */
static uint64_t corner_of(int32_t mode, uint64_t face, uint32_t corner) {
    if (mode == DMI_TINY_TRIANGLES) return 3 * face + corner;
    if (mode == DMI_TINY_FAN) return corner == 2 ? 0 : face + 1 + corner;
    return corner == 0 ? face : face + (((face & 1) != 0) == (corner == 1) ? 2 : 1);
}

static void fill_corners(const dmi_gltf_elements* from, uint64_t count, uint32_t* out) {
    for (uint64_t i = 0; i < count; i++) out[i] = from ? (uint32_t)dmi_gltf_element(from, i, 0) : (uint32_t)i;
    for (uint64_t i = 0; from && i < from->change_count; i++)
        out[dmi_gltf_changed(from, i)] = (uint32_t)dmi_gltf_change(from, i, 0);
}

static dm_result fill_faces(dm_gltf* gltf, const dmi_gltf_piece* piece, int32_t mode, const uint32_t* corners,
                            const char* place) {
    for (uint64_t face = 0; face < piece->face_count; face++) {
        uint32_t* out = gltf->indices + 3 * (piece->first_face + face);
        for (uint32_t corner = 0; corner < 3; corner++) {
            const uint32_t index = corners[corner_of(mode, face, corner)];
            if (index >= piece->vertex_count)
                return dmi_fail(&gltf->env, DM_ERROR_INDEX_OUT_OF_RANGE,
                                "%s: triangle %" PRIu64 " names vertex %u of %" PRIu64, place, face, index,
                                piece->vertex_count);
            out[piece->mirrored ? 2 - corner : corner] = (uint32_t)piece->first_vertex + index;
        }
    }
    return DM_OK;
}

static dm_result fill_piece(dm_gltf* gltf, const dmi_gltf_piece* piece) {
    const dm_gltf_node* node = &gltf->nodes[piece->node];
    char place[PLACE_SIZE];
    dmi_tiny_node from;
    dmi_tiny_primitive primitive;
    dmi_gltf_elements positions, indices;
    dmi_tiny_get_node(gltf->tiny, node->node, &from);
    dmi_tiny_get_primitive(gltf->tiny, from.mesh, piece->primitive, &primitive);
    describe(gltf, node->node, piece->primitive, "POSITION", place);
    dm_result result = dmi_gltf_find_elements(&gltf->env, gltf->tiny, primitive.positions, place, &positions);
    if (result == DM_OK) result = fill_vertices(gltf, piece, &positions, place);
    if (result != DM_OK) return result;
    const int indexed = primitive.indices >= 0;
    describe(gltf, node->node, piece->primitive, "indices", place);
    if (indexed) result = dmi_gltf_find_elements(&gltf->env, gltf->tiny, primitive.indices, place, &indices);
    if (result != DM_OK) return result;
    const uint64_t count = indexed ? indices.count : positions.count;
    uint32_t* corners = dmi_alloc(&gltf->env, count * sizeof *corners, 16);
    if (!corners) return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY, "%s: no memory for %" PRIu64, place, count);
    fill_corners(indexed ? &indices : NULL, count, corners);
    result = fill_faces(gltf, piece, primitive.mode, corners, place);
    dmi_free(&gltf->env, corners, count * sizeof *corners);
    return result;
}

dm_result dmi_gltf_merge(dm_gltf* gltf) {
    dm_result result = enter_nodes(gltf);
    if (result != DM_OK) return result;
    if (gltf->face_count == 0) return dmi_fail(&gltf->env, DM_ERROR_DEGENERATE_MESH, "glTF: the scene has no triangle");
    gltf->positions = dmi_alloc(&gltf->env, gltf->vertex_count * 3 * sizeof *gltf->positions, 16);
    gltf->indices = dmi_alloc(&gltf->env, gltf->face_count * 3 * sizeof *gltf->indices, 16);
    if (!gltf->positions || !gltf->indices)
        return dmi_fail(&gltf->env, DM_ERROR_OUT_OF_MEMORY,
                        "glTF: no memory for %" PRIu64 " vertices and %" PRIu64 " triangles", gltf->vertex_count,
                        gltf->face_count);
    for (uint32_t i = 0; i < gltf->piece_count && result == DM_OK; i++) result = fill_piece(gltf, &gltf->pieces[i]);
    return result;
}
