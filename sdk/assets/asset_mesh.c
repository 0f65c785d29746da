/* Moves the vertices of all nodes into the asset frame, in doubles. */
#include "assets/asset_mesh.h"

#include <float.h>

#include "base/env.h"
#include "mesh/mesh_read.h"

enum { COLUMN = 4, ORIGIN = 12 }; /* offsets in a transform of 16 numbers: from column to column; of the translation */

bool dmi_asset_node_counts(const dm_asset_node* node) {
    return node->mesh != NULL && !(node->flags & DM_ASSET_NODE_FOLLOWS);
}

uint32_t dmi_asset_followed(const dm_asset_node* node) {
    if (!(node->flags & DM_ASSET_NODE_FOLLOWS)) return DM_ASSET_NO_NODE;
    return node->follows != DM_ASSET_NO_NODE ? node->follows : node->parent;
}

/* Says which node an error that has been reported is of. */
static dm_result name_node(dmi_env* env, dm_result result, uint32_t node) {
    return dmi_fail(env, result, "dm_asset_create: the mesh of desc.nodes[%u] can't be used", node);
}

static dm_result count_elements(dmi_env* env, const dm_asset_node* nodes, uint32_t node_count, dmi_asset_mesh* out) {
    uint64_t vertices = 0, faces = 0;
    for (uint32_t i = 0; i < node_count; i++) {
        if (!dmi_asset_node_counts(&nodes[i])) continue;
        dmi_mesh_reader reader;
        const dm_result result = dmi_mesh_reader_open(env, nodes[i].mesh, &reader);
        if (result != DM_OK) return name_node(env, result, i);
        vertices += reader.vertex_count;
        faces += reader.face_count;
    }
    if (vertices > DM_MAX_ELEMENTS || faces > DM_MAX_ELEMENTS)
        return dmi_fail(env, DM_ERROR_TOO_LARGE,
                        "dm_asset_create: desc.nodes have %llu vertices and %llu triangles together: the most is %d",
                        (unsigned long long)vertices, (unsigned long long)faces, DM_MAX_ELEMENTS);
    out->vertex_count = (uint32_t)vertices;
    out->face_count = (uint32_t)faces;
    return DM_OK;
}

static dm_result allocate(dmi_env* env, dmi_asset_mesh* mesh) {
    const size_t vertices = mesh->vertex_count, faces = mesh->face_count;
    mesh->positions = dmi_scratch_alloc(env, vertices * 3 * sizeof *mesh->positions);
    mesh->indices = dmi_scratch_alloc(env, faces * 3 * sizeof *mesh->indices);
    mesh->face_id = dmi_scratch_alloc(env, faces * sizeof *mesh->face_id);
    if (mesh->positions != NULL && mesh->indices != NULL && mesh->face_id != NULL) return DM_OK;
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for %u vertices and %u triangles",
                    mesh->vertex_count, mesh->face_count);
}

void dmi_asset_mesh_release(dmi_env* env, dmi_asset_mesh* mesh) {
    dmi_scratch_free(env, mesh->positions);
    dmi_scratch_free(env, mesh->indices);
    dmi_scratch_free(env, mesh->face_id);
    *mesh = (dmi_asset_mesh){0};
}

/* Returns whether a transform mirrors: its three axes have a negative determinant. */
static bool mirrors(const float* m) {
    if (m == NULL) return false;
    const double x[3] = {(double)m[0], (double)m[1], (double)m[2]};
    const double y[3] = {(double)m[COLUMN], (double)m[COLUMN + 1], (double)m[COLUMN + 2]};
    const double z[3] = {(double)m[2 * COLUMN], (double)m[2 * COLUMN + 1], (double)m[2 * COLUMN + 2]};
    return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
               x[2] * (y[0] * z[1] - y[1] * z[0]) <
           0;
}

static void transform_point(const float* m, const double p[3], double out[3]) {
    for (int row = 0; row < 3; row++) {
        out[row] = p[row];
        if (m == NULL) continue;
        out[row] = (double)m[row] * p[0] + (double)m[COLUMN + row] * p[1] + (double)m[2 * COLUMN + row] * p[2] +
                   (double)m[ORIGIN + row];
    }
}

/* Appends a node's mesh behind the `vertex` vertices and `face` faces of those before it. */
static dm_result append(dmi_env* env, const dmi_mesh_reader* reader, const float* transform, uint32_t id,
                        uint32_t vertex, uint32_t face, dmi_asset_mesh* mesh) {
    uint32_t* indices = mesh->indices + (size_t)face * 3;
    dm_result result = dmi_mesh_read_indices(env, reader, indices);
    if (result == DM_OK) result = dmi_mesh_check_positions(env, reader);
    if (result != DM_OK) return result;
    for (uint32_t v = 0; v < reader->vertex_count; v++) {
        double point[3];
        dmi_mesh_read_position(reader, v, point);
        transform_point(transform, point, mesh->positions + ((size_t)vertex + v) * 3);
    }
    const bool flip = mirrors(transform);
    for (uint32_t f = 0; f < reader->face_count; f++) {
        uint32_t* corner = indices + (size_t)f * 3;
        for (int i = 0; i < 3; i++) corner[i] += vertex;
        if (flip) {
            const uint32_t second = corner[1];
            corner[1] = corner[2];
            corner[2] = second;
        }
        mesh->face_id[face + f] = id;
    }
    return DM_OK;
}

static void measure(dmi_asset_mesh* mesh) {
    double size = 0;
    for (int k = 0; k < 3; k++) {
        double low = DBL_MAX, high = -DBL_MAX;
        for (size_t i = 0; i < (size_t)mesh->face_count * 3; i++) {
            const double p = mesh->positions[(size_t)mesh->indices[i] * 3 + (size_t)k];
            if (p < low) low = p;
            if (p > high) high = p;
        }
        if (high - low > size) size = high - low;
    }
    mesh->size = size < (double)FLT_MAX ? (float)size : FLT_MAX;
}

dm_result dmi_asset_mesh_merge(dmi_env* env, const dm_asset_node* nodes, uint32_t node_count,
                               const dmi_progress* progress, dmi_asset_mesh* out) {
    *out = (dmi_asset_mesh){0};
    dm_result result = count_elements(env, nodes, node_count, out);
    if (result == DM_OK) result = allocate(env, out);
    uint32_t vertex = 0, face = 0;
    for (uint32_t i = 0; i < node_count && result == DM_OK; i++) {
        if (!dmi_asset_node_counts(&nodes[i])) continue;
        dmi_mesh_reader reader;
        result = dmi_mesh_reader_open(env, nodes[i].mesh, &reader);
        if (result == DM_OK) result = append(env, &reader, nodes[i].transform, i + 1, vertex, face, out);
        if (result != DM_OK) return name_node(env, result, i);
        vertex += reader.vertex_count;
        face += reader.face_count;
        result = dmi_progress_tell(progress, (float)face / (float)out->face_count);
    }
    if (result == DM_OK) measure(out);
    return result;
}

dm_mesh_desc dmi_asset_mesh_describe(const dmi_asset_mesh* mesh) {
    const uint64_t faces = mesh->face_count;
    return (dm_mesh_desc){.struct_size = sizeof(dm_mesh_desc),
                          .positions = mesh->positions,
                          .vertex_count = mesh->vertex_count,
                          .indices = mesh->indices,
                          .index_count = faces * 3,
                          .part_ids = mesh->face_id,
                          .part_id_bytes = faces * sizeof *mesh->face_id,
                          .position_format = DM_FLOAT64,
                          .index_format = DM_UINT32,
                          .part_id_format = DM_UINT32,
                          .part_id_scope = DM_PER_FACE};
}
