/* Fuzzes glTF in and out: whatever opens is marked by name, exported with half of its triangles moving, and closed.
 * The allocator gives 64 MB at most, so that a small file which promises a large mesh is an error, not a swap storm. */
#include <stdlib.h>
#include <string.h>

#include "dragmesh/ext/gltf.h"

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

static void* allocate(void* user, size_t size, size_t alignment) {
    size_t* left = user;
    if (size > *left) return NULL;
    *left -= size;
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

static void release(void* user, void* memory, size_t size) {
    *(size_t*)user += size;
    free(memory);
}

static void export_half(const dm_gltf* gltf, uint8_t* ids, uint64_t faces) {
    const dm_pose poses[2] = {{{0, 0, 0, 1}, {0, 0, 0, 0}}, {{0.6f, 0, 0, 0.8f}, {0, 0.25f, 0, 0}}};
    const float times[2] = {0, 1};
    const dm_gltf_track track = {.face_ids = ids, .value = 1, .poses = poses, .times = times, .key_count = 2};
    memset(ids, 1, (faces + 1) / 2);
    void* out;
    size_t out_size;
    if (dm_gltf_export(gltf, &track, 1, &out, &out_size) == DM_OK) dm_gltf_release_bytes(gltf, out, out_size);
}

/* Of all surfaces: their images, and the first corners of the small ones. */
static void read_surfaces(dm_gltf* gltf) {
    static float uv[3 << 12][2];
    for (uint32_t i = 0; i < dm_gltf_surface_count(gltf); i++) {
        dm_gltf_surface surface;
        if (dm_gltf_get_surface(gltf, i, &surface) == DM_OK)
            dm_gltf_get_texture_coordinates(gltf, i, uv[0], sizeof uv / sizeof *uv);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    size_t left = (size_t)64 << 20;
    const dm_gltf_desc desc = {
        .struct_size = sizeof desc, .data = data, .size = size, .allocator = {&left, allocate, release}};
    dm_gltf* gltf;
    if (dm_gltf_open(&desc, &gltf) != DM_OK) return 0;
    dm_mesh_desc mesh;
    dm_gltf_node node;
    dm_gltf_get_mesh(gltf, &mesh);
    dm_gltf_get_node(gltf, dm_gltf_node_count(gltf) - 1, &node);
    const uint64_t faces = mesh.index_count / 3;
    uint8_t* ids = calloc(1, faces + mesh.vertex_count);
    if (ids) {
        int32_t scope;
        dm_gltf_mark_faces(gltf, &node.name, 1, 2, ids, faces);
        export_half(gltf, ids, faces);
        dm_gltf_read_mask(gltf, data, size, NULL, ids, &scope, NULL);
    }
    free(ids);
    read_surfaces(gltf);
    dm_gltf_close(gltf);
    return 0;
}
