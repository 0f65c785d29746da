/* All that can be asked of and done with the bytes of a glTF file. Whatever they are: an error, or a mesh of finite
 * positions whose indices, nodes and surfaces lie inside it, with names in valid UTF-8; what is exported of it can be
 * opened again. Memory stays below what docs/memory.md says. An error leaves the host's ids as they were.
 */
#ifndef DM_FUZZ_USE_GLTF_H
#define DM_FUZZ_USE_GLTF_H

#include <stdlib.h>
#include <string.h>

#include "dragmesh/ext/gltf.h"
#include "host.h"

enum { LABEL = 512, CORNERS = 3 << 12, UNTOUCHED = 0xa5 };

#define MEMORY_BASE ((size_t)64 << 20) /* docs/memory.md, of dm_gltf_open */
#define MEMORY_FACTOR 256

static fuzz_host host;

static inline void expect_text(const char* text) {
    char* copy = strdup(text);
    fuzz_expect(copy != NULL);
    dm_gltf_mend_text(copy);
    fuzz_expect(strcmp(copy, text) == 0);
    free(copy);
}

static inline void expect_message(void* user, int32_t level, dm_result code, const char* text) {
    fuzz_message(user, level, code, text);
    expect_text(text);
}

/* ---- what is read ---- */

static inline void check_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh) {
    double origin[3];
    fuzz_expect(dm_gltf_get_mesh(gltf, out_mesh) == DM_OK);
    fuzz_expect_finite(out_mesh->positions, out_mesh->vertex_count * 3);
    const uint32_t* indices = out_mesh->indices;
    for (uint64_t i = 0; i < out_mesh->index_count; i++) fuzz_expect(indices[i] < out_mesh->vertex_count);
    dm_gltf_get_origin(gltf, origin);
    for (int i = 0; i < 3; i++) fuzz_expect(isfinite(origin[i]));
}

static inline void check_hints(const dm_gltf* gltf, const char* name) {
    static char label[LABEL];
    dm_pivot pivot;
    if (dm_gltf_get_hints(gltf, name, label, sizeof label, &pivot) != DM_OK) return;
    expect_text(label);
    fuzz_expect_vector(&pivot.origin);
    fuzz_expect_finite(pivot.axes, 9);
}

static inline void check_nodes(const dm_gltf* gltf, const dm_mesh_desc* mesh) {
    const uint32_t count = dm_gltf_node_count(gltf);
    const uint64_t faces = mesh->index_count / 3;
    fuzz_expect(count > 0);
    for (uint32_t i = 0; i < count; i++) {
        dm_gltf_node node;
        fuzz_expect(dm_gltf_get_node(gltf, i, &node) == DM_OK);
        expect_text(node.name);
        fuzz_expect_finite(node.colour, 4);
        fuzz_expect(node.carrier == DM_GLTF_NO_CARRIER || node.carrier < count);
        fuzz_expect(node.first_vertex <= mesh->vertex_count &&
                    node.vertex_count <= mesh->vertex_count - node.first_vertex);
        fuzz_expect(node.first_face <= faces && node.face_count <= faces - node.first_face);
        check_hints(gltf, node.name);
    }
}

static inline void check_clip(const dm_asset_clip* clip) {
    fuzz_expect(clip->key_count > 0);
    fuzz_expect_finite(clip->times, clip->key_count);
    for (uint32_t k = 0; k < clip->key_count; k++) {
        fuzz_expect_finite(clip->poses[k].real, 4);
        fuzz_expect_finite(clip->poses[k].dual, 4);
    }
}

static inline void check_asset_node(const dm_asset_node* node, uint32_t count) {
    fuzz_expect(node->parent == DM_ASSET_NO_NODE || node->parent < count);
    fuzz_expect(node->follows == DM_ASSET_NO_NODE || node->follows < count);
    if (node->name) expect_text(node->name);
    if (node->mesh_name) expect_text(node->mesh_name);
    if (node->pivot) fuzz_expect_vector(&node->pivot->origin);
    for (uint32_t c = 0; c < node->clip_count; c++) check_clip(&node->clips[c]);
    if (node->joint) {
        fuzz_expect_vector(&node->joint->axis);
        fuzz_expect_vector(&node->joint->origin);
        fuzz_expect(node->joint->lower <= node->joint->upper);
    }
    const uint32_t* indices = node->mesh ? node->mesh->indices : NULL;
    for (uint64_t i = 0; indices && i < node->mesh->index_count; i++)
        fuzz_expect(indices[i] < node->mesh->vertex_count);
    if (node->mesh) fuzz_expect_finite(node->mesh->positions, 3 * node->mesh->vertex_count);
}

static inline void check_asset(dm_gltf* gltf) {
    const dm_asset_node* nodes;
    uint32_t count;
    const dm_result result = dm_gltf_get_asset(gltf, 0, &nodes, &count);
    fuzz_expect(result == DM_OK || result == DM_ERROR_OUT_OF_MEMORY || result == DM_ERROR_TOO_LARGE);
    for (uint32_t i = 0; result == DM_OK && i < count; i++) check_asset_node(&nodes[i], count);
}

static inline void check_surfaces(dm_gltf* gltf, uint64_t faces) {
    static float uv[CORNERS][2];
    for (uint32_t i = 0; i < dm_gltf_surface_count(gltf); i++) {
        dm_gltf_surface surface;
        if (dm_gltf_get_surface(gltf, i, &surface) != DM_OK) continue;
        fuzz_expect(surface.first_face <= faces && surface.face_count <= faces - surface.first_face);
        fuzz_expect_finite(surface.colour, 4);
        const uint64_t corners = surface.face_count * 3 < CORNERS ? surface.face_count * 3 : CORNERS;
        if (dm_gltf_get_texture_coordinates(gltf, i, uv[0], corners) == DM_OK && corners == surface.face_count * 3)
            fuzz_expect_finite(uv[0], corners * 2);
        uint8_t sum = 0;
        const uint8_t* image = surface.image;
        for (size_t b = 0; image != NULL && b < surface.image_size; b++) sum ^= image[b];
        (void)sum; /* an image's bytes can be read: that is all */
    }
}

/* ---- what is written ---- */

/* ids: 1 for the faces that move. */
static inline void export_half(const dm_gltf* gltf, uint8_t* ids, uint64_t faces) {
    const dm_pose poses[2] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}, {{0.6f, 0, 0, 0.8f}, {0, 0.25f, 0, 0}}};
    const float times[2] = {0, 1};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    void* out;
    size_t out_size;
    memset(ids, 0, faces);
    memset(ids, 1, (faces + 1) / 2);
    if (dm_gltf_export(gltf, &track, 1, &out, &out_size) != DM_OK) return;
    const dm_gltf_desc desc = {
        .struct_size = sizeof desc, .data = out, .size = out_size, .allocator = {&host, fuzz_allocate, fuzz_release}};
    dm_gltf* again;
    const dm_result result = dm_gltf_open(&desc, &again);
    fuzz_expect(result == DM_OK || result == DM_ERROR_OUT_OF_MEMORY || result == DM_ERROR_TOO_LARGE);
    if (result == DM_OK) dm_gltf_close(again);
    dm_gltf_release_bytes(gltf, out, out_size);
}

static inline void mark(const dm_gltf* gltf, uint8_t* ids, uint64_t faces, const uint8_t* data, size_t size) {
    dm_gltf_node node;
    int32_t scope = -1, ambiguous = -1;
    fuzz_expect(dm_gltf_get_node(gltf, dm_gltf_node_count(gltf) - 1, &node) == DM_OK);
    const char* names[2] = {node.name, "\x01 no such node"};
    memset(ids, UNTOUCHED, faces);
    if (dm_gltf_mark_faces(gltf, names, 2, 2, ids, faces) != DM_OK)
        for (uint64_t f = 0; f < faces; f++) fuzz_expect(ids[f] == UNTOUCHED);
    dm_gltf_mark_faces(gltf, names, 1, 2, ids, faces);
    fuzz_expect(dm_gltf_read_mask(gltf, data, size, NULL, ids, &scope, &ambiguous) == DM_OK || scope == -1);
}

/* Opens the file, uses all of it and closes it. */
static inline void use_gltf(const uint8_t* data, size_t size) {
    const dm_gltf_desc desc = {.struct_size = sizeof desc,
                               .data = data,
                               .size = size,
                               .allocator = {&host, fuzz_allocate, fuzz_release},
                               .log = {&host, expect_message}};
    dm_gltf* gltf;
    host = (fuzz_host){.live = 0};
    const dm_result result = dm_gltf_open(&desc, &gltf);
    fuzz_expect(host.peak <= MEMORY_BASE + MEMORY_FACTOR * size);
    fuzz_expect_result(result);
    if (result == DM_OK) {
        dm_mesh_desc mesh;
        check_mesh(gltf, &mesh);
        const uint64_t faces = mesh.index_count / 3;
        check_nodes(gltf, &mesh);
        check_surfaces(gltf, faces);
        check_asset(gltf);
        uint8_t* ids = calloc(1, faces + mesh.vertex_count);
        if (ids != NULL) {
            mark(gltf, ids, faces, data, size);
            export_half(gltf, ids, faces);
        }
        free(ids);
        dm_gltf_close(gltf);
    }
    fuzz_expect(host.live == 0);
}

#endif
