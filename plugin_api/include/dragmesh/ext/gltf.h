/* dragmesh extension: glTF 2.0 in and out, and part masks from files. In libdragmesh_gltf; needs no context.
 * A draft: unlike dm.core/1 it may change with a minor version, so use the library of the header's own version
 * (dm_gltf_version). All functions [any-thread]; one dm_gltf is for one thread at a time. */
#ifndef DRAGMESH_EXT_GLTF_H
#define DRAGMESH_EXT_GLTF_H

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Version of the libdragmesh_gltf in use, as DM_VERSION. */
DM_API uint32_t DM_CALL dm_gltf_version(void);

typedef struct dm_gltf dm_gltf;

/* Files beside a .gltf: buffers when it is opened, images when it is exported or a surface is asked for. */
typedef struct dm_gltf_files {
    void* user;
    /* Hands over the bytes of the file at `path`: relative to the document, UTF-8, '/' between folders. It never is
     * absolute, never has "..", a backslash or a colon in it. Returns DM_OK, DM_ERROR_OUT_OF_MEMORY, or another
     * number: there is no such file. */
    int32_t(DM_CALL* open)(void* user, const char* path, const void** out_data, size_t* out_size);
    /* Takes the bytes back, before dm_gltf_close returns. */
    void(DM_CALL* close)(void* user, const void* data, size_t size);
} dm_gltf_files;

typedef struct dm_gltf_desc {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    const void* data;  /* the bytes of a .glb or .gltf; borrowed for the call */
    size_t size;
    dm_allocator allocator;        /* zeros = malloc/free */
    dm_log log;                    /* zeros = silent */
    dm_gltf_files files;           /* zeros = none: everything is embedded. `user` lives as long as the dm_gltf */
    dm_progress_callback progress; /* of dm_gltf_open, dm_gltf_open_file and dm_gltf_export; NULL = none. A call that it
                                      stops answers CANCELLED */
    void* progress_user;           /* lives as long as the dm_gltf */
} dm_gltf_desc;

#define DM_GLTF_NO_CARRIER UINT32_MAX

/* What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces
 * are those of the merged mesh. It holds the nodes with meshes in file order (document order of the nodes array), a
 * node's primitives in order, every vertex in the scene's frame less dm_gltf_get_origin (node transforms applied).
 * Primitives of a node that share an accessor share its vertices. A node with a skin stands bone by bone, as its bones
 * stand in the file; a vertex goes with its heaviest bone. */
typedef struct dm_gltf_node {
    const char* name; /* valid UTF-8, '?' for what is none; "" when it has none. Lives as long as the dm_gltf */
    uint32_t node;    /* index in the file's nodes array, of the node or bone; of an instance: behind them */
    uint32_t carrier; /* the nearest dm_gltf_node above it, by index here: it goes where that one goes. Else
                         DM_GLTF_NO_CARRIER */
    uint64_t first_vertex, vertex_count;
    uint64_t first_face, face_count;
    float colour[4]; /* base colour factor of its first material, linear; white without one */
} dm_gltf_node;

/* Reads triangles, strips and fans, also quantised ones (KHR_mesh_quantization) and, where the build has their
 * libraries, compressed ones (EXT_meshopt_compression, KHR_meshopt_compression, KHR_draco_mesh_compression). Another
 * required extension that may change geometry: UNSUPPORTED, by name. Morph targets are applied as the file's weights
 * say. An instance of EXT_mesh_gpu_instancing is a node of its own, behind those of the file, below the one that has
 * the extension. Left out with a warning: triangles whose vertices do not exist or are not finite, primitives that are
 * broken, points, lines, nodes whose scale is zero. Left out in silence, because they are no body: nodes and meshes
 * named UCX_*, UBX_*, UCP_*, USP_*, *_collider, *-colonly, *-convcolonly; coarser levels of detail (MSFT_lod, or
 * siblings named *_LOD0, *_LOD1); invisible nodes (KHR_node_visibility) and materials of alpha 0. When nothing is left,
 * the error is the first reason: BAD_DATA, NOT_FINITE, INDEX_OUT_OF_RANGE, DEGENERATE_MESH. Others: NOT_FOUND (a file
 * beside it), VERSION, TOO_LARGE (it would take more memory than 64 MB and 64 bytes a byte of the file, 256 a byte of a
 * Draco stream). A call logs one warning, which counts what is left out and quotes the first three. */
DM_API dm_result DM_CALL dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf);
/* The same for a file and those beside it, which are read from its folder and from nowhere else; `desc` leaves data,
 * size and files at 0. NOT_FOUND: there is no such regular file. */
DM_API dm_result DM_CALL dm_gltf_open_file(const char* path, const dm_gltf_desc* desc, dm_gltf** out_gltf);
DM_API void DM_CALL dm_gltf_close(dm_gltf* gltf);

DM_API uint32_t DM_CALL dm_gltf_node_count(const dm_gltf* gltf);
DM_API dm_result DM_CALL dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node);
/* positions float32, indices uint32; no part ids. Points into the dm_gltf. */
DM_API dm_result DM_CALL dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh);
/* Where the merged mesh's origin is in the scene: 0, 0, 0 but for objects more than 256 times their size away, whose
 * shape floats could not hold there. */
DM_API void DM_CALL dm_gltf_get_origin(const dm_gltf* gltf, double out_origin[3]);

/* How a texture goes on beyond its edges: OpenGL's numbers. */
enum { DM_GLTF_WRAP_REPEAT = 10497, DM_GLTF_WRAP_CLAMP = 33071, DM_GLTF_WRAP_MIRROR = 33648 };

/* Faces of the merged mesh that lie side by side and have one material. Those of a dm_gltf_node are one or more. */
typedef struct dm_gltf_surface {
    uint64_t first_face, face_count;
    float colour[4];        /* base colour factor, linear; white without a material */
    const void* image;      /* the base colour texture as it is stored: PNG, JPEG, or what an extension has, sRGB. NULL:
                               none. Surfaces with the same image have the same pointer; lives as long as the dm_gltf */
    size_t image_size;      /* bytes */
    int32_t wrap_u, wrap_v; /* DM_GLTF_WRAP_* */
} dm_gltf_surface;

DM_API uint32_t DM_CALL dm_gltf_surface_count(const dm_gltf* gltf);
/* An image that can't be had is left out with a warning. Errors: NOT_FOUND, OUT_OF_MEMORY. */
DM_API dm_result DM_CALL dm_gltf_get_surface(dm_gltf* gltf, uint32_t index, dm_gltf_surface* out_surface);
/* Writes where the corners of a surface lie in its base colour texture: u and v of each, three corners a face, in the
 * order of the merged mesh; (0, 0) is the image's top left corner. Scaled, turned and shifted as the material says
 * (KHR_texture_transform). corner_count: three times face_count. Errors: NOT_FOUND (no texture, or no coordinates),
 * BUFFER_TOO_SMALL, BAD_DATA, OUT_OF_MEMORY. */
DM_API dm_result DM_CALL dm_gltf_get_texture_coordinates(dm_gltf* gltf, uint32_t index, float* out_uv,
                                                         uint64_t corner_count);

/* Sets `value` for every face of the named nodes or bones and of all that they carry (a name that several nodes share
 * means all of them; that of a node with a skin means all its bones; "#12" means node 12 of the file, for files without
 * names). Errors: NOT_FOUND, naming the first missing name and some that exist. */
DM_API dm_result DM_CALL dm_gltf_mark_faces(const dm_gltf* gltf, const char* const* names, uint32_t name_count,
                                            uint8_t value, uint8_t* inout_face_ids, uint64_t face_count);

/* What the file says of a node, as dm_part_desc takes it: the names of those that carry it, outermost first, of its
 * mesh and its own, joined by '/', and its origin and axes in the merged mesh's frame. name: as for
 * dm_gltf_mark_faces; of several nodes, the first. out_label: label_size bytes, where not all names fit the outer ones
 * are left out; may be NULL. out_pivot may be NULL. Errors: NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_hints(const dm_gltf* gltf, const char* name, char* out_label, size_t label_size,
                                           dm_pivot* out_pivot);

/* The scene as dm_asset_create takes it: all nodes that have triangles or carry some, and those of which the merged
 * mesh has none because they are no body. First come the dm_gltf_nodes in their order, then groups without triangles,
 * then what is hidden, a collider or a coarser level of detail (DM_ASSET_NODE_FOLLOWS). Meshes are in the merged mesh's
 * frame, so that transforms are NULL. Clips are the file's animations, each against the node above it. Joints are those
 * of the nodes' `extras` and of KHR_physics_rigid_bodies (docs/gltf.md). flags: 0. Points into the dm_gltf. Errors:
 * OUT_OF_MEMORY, TOO_LARGE. */
DM_API dm_result DM_CALL dm_gltf_get_asset(dm_gltf* gltf, uint32_t flags, const dm_asset_node** out_nodes,
                                           uint32_t* out_count);
/* The index in the file's nodes array of a node of that list. Errors: those, NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_asset_node(dm_gltf* gltf, uint32_t index, uint32_t* out_node);

/* 1 when pivots tell nothing: the file has several dm_gltf_nodes, and the origins of all follow one rule, as exporters
 * leave them: they are one point, or lie at the same place of each node's box (middle, lowest corner, middle of a face
 * …). 0: some may tell, or gltf is NULL. */
DM_API int32_t DM_CALL dm_gltf_pivots_are_lost(const dm_gltf* gltf);

/* Writes what is known of where a node's pivot lies (DM_PIVOT_*), for dm_part_desc.pivot_kind. A rule holds where the
 * node with the largest surface and more than half of all follow it: DM_PIVOT_DEFAULT is the answer for what follows
 * it, DM_PIVOT_SET for the others. DM_PIVOT_UNKNOWN: no rule holds, or the node has no triangles. name: as for
 * dm_gltf_get_hints. Errors: NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_pivot_kind(const dm_gltf* gltf, const char* name, int32_t* out_kind);

/* 1 when triangles of the file are not in the merged mesh: a triangle, a primitive or a node could not be read, or only
 * one of its instances was. Warnings of dm_gltf_open name them. Pass DM_PREPARE_MESH_INCOMPLETE then. 0: all are there,
 * or gltf is NULL. */
DM_API int32_t DM_CALL dm_gltf_left_out(const dm_gltf* gltf);

/* Reads a part mask (.npy or JSON array, one integer a vertex or one a face, in the order of the file where bones sort
 * the merged mesh otherwise). mask_value NULL:
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
 * looping animation moves. Without tracks it adds no animation. The file's own animations stay as they are, and go on
 * moving the nodes that they name. out_data is released with dm_gltf_release_bytes. */
DM_API dm_result DM_CALL dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count,
                                        void** out_data, size_t* out_size);
DM_API void DM_CALL dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size);

/* A mesh to write as one node of a new .glb. */
typedef struct dm_gltf_part {
    const char* name;
    const float* positions;  /* vertex_count x 3, glTF frame */
    const uint32_t* indices; /* index_count */
    uint64_t vertex_count, index_count;
    float colour[4]; /* base colour, linear; clamped to 0 to 1 */
} dm_gltf_part;

/* Writes a static .glb with one identity node a part. allocator zeros = malloc/free; release out_data with the same. */
DM_API dm_result DM_CALL dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                                       const dm_log* log, void** out_data, size_t* out_size);

/* Makes any text valid UTF-8, in place: a '?' for each piece that is no character, also for one that was cut off. Names
 * and messages of this library are so already; hosts need it for what they write beside them. Returns the new length,
 * never a longer one. NULL: 0. */
DM_API size_t DM_CALL dm_gltf_mend_text(char* text);

#ifdef __cplusplus
}
#endif

#endif
