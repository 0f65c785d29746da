/* dragmesh extension: glTF 2.0 in and out, and part masks from files. In libdragmesh_gltf; needs no context.
 * Interface id "dm.gltf.draft/0": may still change. All functions [any-thread]; one dm_gltf is for one thread at a
 * time. */
#ifndef DRAGMESH_EXT_GLTF_H
#define DRAGMESH_EXT_GLTF_H

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct dm_gltf dm_gltf;

typedef struct dm_gltf_desc {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    const void* data;  /* the bytes of a .glb, or of a .gltf whose buffers are embedded; borrowed for the call */
    size_t size;
    dm_allocator allocator; /* zeros = malloc/free */
    dm_log log;             /* zeros = silent */
} dm_gltf_desc;

/* A node that has a mesh. Vertices and faces are those of the merged mesh, which holds the nodes in file order
 * (document order of the nodes array), a node's primitives in order, every vertex in the scene's frame (node transforms
 * applied). */
typedef struct dm_gltf_node {
    const char* name; /* UTF-8; "" when it has none. Lives as long as the dm_gltf */
    uint32_t node;    /* index in the file's nodes array */
    uint32_t reserved;
    uint64_t first_vertex, vertex_count;
    uint64_t first_face, face_count;
    float colour[4]; /* base colour factor of its first material, linear; white without one */
} dm_gltf_node;

/* Reads triangles, strips and fans; other primitives, skins and morphs are left out with a warning. Draco and other
 * compressed geometry: DM_ERROR_UNSUPPORTED. Errors: BAD_DATA, NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH. */
DM_API dm_result DM_CALL dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf);
DM_API void DM_CALL dm_gltf_close(dm_gltf* gltf);

DM_API uint32_t DM_CALL dm_gltf_node_count(const dm_gltf* gltf);
DM_API dm_result DM_CALL dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node);
/* positions float32, indices uint32; no part ids. Points into the dm_gltf. */
DM_API dm_result DM_CALL dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh);

/* Sets `value` for every face of the named nodes (a name that several nodes share means all of them; a name of a node
 * without a mesh means the meshes below it; "#12" means node 12 of the file, for files without names). Errors:
 * NOT_FOUND, naming the first missing name and some that exist. */
DM_API dm_result DM_CALL dm_gltf_mark_faces(const dm_gltf* gltf, const char* const* names, uint32_t name_count,
                                            uint8_t value, uint8_t* inout_face_ids, uint64_t face_count);

/* Reads a part mask (.npy or JSON array, one integer a vertex or one a face of the merged mesh). mask_value NULL:
 * non-zero is moving. out_part_ids: as many bytes as max(vertex_count, face_count). out_ambiguous (may be NULL): both
 * lengths fit, and per vertex was taken. Errors: BAD_DATA, INVALID_ARGUMENT (neither length fits), EMPTY_MASK,
 * FULL_MASK. */
DM_API dm_result DM_CALL dm_gltf_read_mask(const dm_gltf* gltf, const void* data, size_t size,
                                           const int64_t* mask_value, uint8_t* out_part_ids, int32_t* out_scope,
                                           int32_t* out_ambiguous);

/* One animated part: which faces it takes and its key poses (host frame = the file's scene frame, from rest). */
typedef struct dm_gltf_track {
    const char* name;        /* of the new node and animation target; NULL = "moving_part" */
    const uint8_t* face_ids; /* face_count of the merged mesh */
    uint8_t value;           /* faces with this id move */
    uint8_t reserved[7];
    const dm_pose* poses; /* key_count */
    const float* times;   /* seconds, rising */
    uint32_t key_count;
    uint32_t reserved2;
} dm_gltf_track;

/* Writes a .glb: the file's meshes and materials, with the tracks' faces split off into nodes of their own that a
 * looping animation moves. out_data is released with dm_gltf_release_bytes. */
DM_API dm_result DM_CALL dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count,
                                        void** out_data, size_t* out_size);
DM_API void DM_CALL dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size);

/* A mesh to write as one node of a new .glb. */
typedef struct dm_gltf_part {
    const char* name;
    const float* positions;  /* vertex_count x 3, glTF frame */
    const uint32_t* indices; /* index_count */
    uint64_t vertex_count, index_count;
    float colour[4]; /* base colour, linear */
} dm_gltf_part;

/* Writes a static .glb with one identity node a part. allocator zeros = malloc/free; release out_data with the same. */
DM_API dm_result DM_CALL dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                                       const dm_log* log, void** out_data, size_t* out_size);

#ifdef __cplusplus
}
#endif

#endif
