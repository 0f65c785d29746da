/* dragmesh extension in libdragmesh_gltf: reads and writes glTF 2.0, and reads part masks from files. It needs no
 * context. It is a draft: unlike dm.core/1 it may change with a minor version, so use the library of the header's own
 * version (dm_gltf_version). All functions [any-thread]; one dm_gltf is for one thread at a time. */
#ifndef DRAGMESH_EXT_GLTF_H
#define DRAGMESH_EXT_GLTF_H

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the version of the libdragmesh_gltf in use, as a number like DM_VERSION. */
DM_API uint32_t DM_CALL dm_gltf_version(void);

typedef struct dm_gltf dm_gltf;

/* Gives access to files beside a .gltf: to buffers when it is opened, to images when it is exported or a surface is
 * asked for. */
typedef struct dm_gltf_files {
    void* user;
    /* Hands over the bytes of the file at `path`, which is relative to the document, UTF-8, with '/' between folders.
     * The path is never absolute, and has no "..", backslash or colon. Returns DM_OK, DM_ERROR_OUT_OF_MEMORY, or any
     * other number when there is no such file. */
    int32_t(DM_CALL* open)(void* user, const char* path, const void** out_data, size_t* out_size);
    /* Takes the bytes back, before dm_gltf_close returns. */
    void(DM_CALL* close)(void* user, const void* data, size_t size);
} dm_gltf_files;

typedef struct dm_gltf_desc {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    const void* data;  /* the bytes of a .glb or .gltf; borrowed for the call */
    size_t size;
    dm_allocator allocator; /* zeros = malloc/free */
    dm_log log;             /* zeros = silent */
    /* Zeros = none: everything is embedded. `user` must live as long as the dm_gltf. */
    dm_gltf_files files;
    /* Callback of dm_gltf_open, dm_gltf_open_file and dm_gltf_export; NULL = none. A call that it stops answers
     * CANCELLED. */
    dm_progress_callback progress;
    void* progress_user; /* must live as long as the dm_gltf */
} dm_gltf_desc;

#define DM_GLTF_NO_CARRIER UINT32_MAX

/* What moves as one: a node that has a mesh, or a bone of a skin with the triangles that go with it. Vertices and faces
 * are those of the merged mesh. The merged mesh holds the nodes with meshes in file order (the order of the nodes
 * array), and the primitives of a node in order. Its vertices are in the scene's frame less dm_gltf_get_origin, with
 * node transforms applied. Primitives of a node that share an accessor share its vertices. A node with a skin is stored
 * bone by bone, as its bones stand in the file; a vertex goes with its heaviest bone. */
typedef struct dm_gltf_node {
    /* Valid UTF-8, with '?' for each piece that is none; "" when it has none. It lives as long as the dm_gltf. */
    const char* name;
    uint32_t node; /* index of the node or bone in the file's nodes array; instances come behind them */
    /* Index of the nearest dm_gltf_node above it, with which it moves, or DM_GLTF_NO_CARRIER. */
    uint32_t carrier;
    uint64_t first_vertex, vertex_count;
    uint64_t first_face, face_count;
    float colour[4]; /* base colour factor of its first material, linear; white without one */
} dm_gltf_node;

/* Opens the bytes of a .glb or .gltf. Reads triangles, strips and fans, also quantised ones (KHR_mesh_quantization)
 * and, where the build has their libraries, compressed ones (EXT_meshopt_compression, KHR_meshopt_compression,
 * KHR_draco_mesh_compression). Another required extension that may change geometry is refused as UNSUPPORTED, by name.
 * Morph targets are applied as the file's weights say. An instance of EXT_mesh_gpu_instancing becomes a node of its
 * own, behind those of the file, below the node that has the extension.
 *
 * These are left out with a warning: triangles whose vertices do not exist or are not finite, broken primitives,
 * points, lines, and nodes whose scale is zero. These are left out in silence, because they are no body: nodes and
 * meshes named UCX_*, UBX_*, UCP_*, USP_*, *_collider, *-colonly, *-convcolonly; coarser levels of detail (MSFT_lod, or
 * siblings named *_LOD0, *_LOD1); invisible nodes (KHR_node_visibility); and materials of alpha 0. A call logs one
 * warning, which counts what is left out and quotes the first three.
 *
 * Errors: when nothing is left, the first reason: BAD_DATA, NOT_FINITE, INDEX_OUT_OF_RANGE or DEGENERATE_MESH;
 * NOT_FOUND for a file beside it; VERSION; TOO_LARGE when it would take more memory than 64 MB and 64 bytes a byte of
 * the file, or 256 a byte of a Draco stream. */
DM_API dm_result DM_CALL dm_gltf_open(const dm_gltf_desc* desc, dm_gltf** out_gltf);
/* Opens a file and those beside it, which are read from its folder and from nowhere else. `desc` leaves data, size and
 * files at 0. Errors: those of dm_gltf_open; NOT_FOUND when there is no such regular file. */
DM_API dm_result DM_CALL dm_gltf_open_file(const char* path, const dm_gltf_desc* desc, dm_gltf** out_gltf);
/* Closes a file and frees all that points into it. NULL does nothing. */
DM_API void DM_CALL dm_gltf_close(dm_gltf* gltf);

/* Returns how many nodes there are, and 0 for NULL. */
DM_API uint32_t DM_CALL dm_gltf_node_count(const dm_gltf* gltf);
/* Writes the node at an index. Errors: INVALID_ARGUMENT, NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_node(const dm_gltf* gltf, uint32_t index, dm_gltf_node* out_node);
/* Writes the merged mesh, which points into the dm_gltf: positions as float32, indices as uint32, no part ids. */
DM_API dm_result DM_CALL dm_gltf_get_mesh(const dm_gltf* gltf, dm_mesh_desc* out_mesh);
/* Writes where the merged mesh's origin is in the scene. It is 0, 0, 0 unless the object is more than 256 times its
 * size away, where floats could not hold its shape. */
DM_API void DM_CALL dm_gltf_get_origin(const dm_gltf* gltf, double out_origin[3]);

/* How a texture continues beyond its edges, by OpenGL's numbers. */
enum { DM_GLTF_WRAP_REPEAT = 10497, DM_GLTF_WRAP_CLAMP = 33071, DM_GLTF_WRAP_MIRROR = 33648 };

/* Faces of the merged mesh that lie side by side and have one material. A dm_gltf_node has one or more surfaces. */
typedef struct dm_gltf_surface {
    uint64_t first_face, face_count;
    float colour[4]; /* base colour factor, linear; white without a material */
    /* The base colour texture as it is stored, in sRGB: PNG, JPEG, or what an extension has. NULL: none. Surfaces with
     * the same image have the same pointer. It lives as long as the dm_gltf. */
    const void* image;
    size_t image_size;      /* bytes */
    int32_t wrap_u, wrap_v; /* DM_GLTF_WRAP_* */
} dm_gltf_surface;

/* Returns how many surfaces there are, and 0 for NULL. */
DM_API uint32_t DM_CALL dm_gltf_surface_count(const dm_gltf* gltf);
/* Writes the surface at an index. An image that cannot be read is left out with a warning. Errors: NOT_FOUND,
 * OUT_OF_MEMORY. */
DM_API dm_result DM_CALL dm_gltf_get_surface(dm_gltf* gltf, uint32_t index, dm_gltf_surface* out_surface);
/* Writes where the corners of a surface lie in its base colour texture: u and v of each, three corners a face, in the
 * order of the merged mesh. (0, 0) is the image's top left corner. They are scaled, turned and shifted as the material
 * says (KHR_texture_transform). corner_count: three times face_count. Errors: NOT_FOUND when there is no texture, or
 * there are no coordinates; BUFFER_TOO_SMALL, BAD_DATA, OUT_OF_MEMORY. */
DM_API dm_result DM_CALL dm_gltf_get_texture_coordinates(dm_gltf* gltf, uint32_t index, float* out_uv,
                                                         uint64_t corner_count);

/* Sets `value` for every face of the named nodes or bones and of all that they carry. A name that several nodes share
 * means all of them. The name of a node with a skin means all its bones. "#12" means node 12 of the file, for files
 * without names. Errors: NOT_FOUND, whose message has the first missing name and some that exist. */
DM_API dm_result DM_CALL dm_gltf_mark_faces(const dm_gltf* gltf, const char* const* names, uint32_t name_count,
                                            uint8_t value, uint8_t* inout_face_ids, uint64_t face_count);

/* Writes what the file says of a node, as dm_part_desc takes it. The label has the names of the nodes that carry it,
 * outermost first, of its mesh and its own, joined by '/'. The pivot has its origin and axes in the merged mesh's
 * frame. name: as for dm_gltf_mark_faces; of several nodes, the first counts. out_label: label_size bytes, from which
 * the outer names are left out where not all fit; may be NULL. out_pivot may be NULL. Errors: NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_hints(const dm_gltf* gltf, const char* name, char* out_label, size_t label_size,
                                           dm_pivot* out_pivot);

/* Writes the scene as dm_asset_create takes it: all nodes that have triangles or carry some, and nodes that the merged
 * mesh leaves out because they are no body. First come the dm_gltf_nodes in their order, then groups without triangles,
 * then what is hidden, a collider or a coarser level of detail (DM_ASSET_NODE_FOLLOWS). Meshes are in the merged mesh's
 * frame, so that transforms are NULL. Clips are the file's animations, each relative to the node above it. Joints are
 * those of the nodes' `extras` and of KHR_physics_rigid_bodies (docs/gltf.md). flags: 0. The list points into the
 * dm_gltf. Errors: OUT_OF_MEMORY, TOO_LARGE. */
DM_API dm_result DM_CALL dm_gltf_get_asset(dm_gltf* gltf, uint32_t flags, const dm_asset_node** out_nodes,
                                           uint32_t* out_count);
/* Writes the index in the file's nodes array of a node of that list. Errors: those of dm_gltf_get_asset; NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_asset_node(dm_gltf* gltf, uint32_t index, uint32_t* out_node);

/* Returns 1 when pivots say nothing: the file has several dm_gltf_nodes, and the origins of all follow one rule, as
 * exporters leave them. They are one point, or lie at the same place of each node's box (middle, lowest corner, middle
 * of a face …). Returns 0 when some may say something, or gltf is NULL. */
DM_API int32_t DM_CALL dm_gltf_pivots_are_lost(const dm_gltf* gltf);

/* Writes how a node's pivot came to lie where it is (DM_PIVOT_*), for dm_part_desc.pivot_kind. A rule holds where the
 * node with the largest surface and more than half of all nodes follow it. The answer is then DM_PIVOT_DEFAULT for a
 * node that follows it and DM_PIVOT_SET for the others. It is DM_PIVOT_UNKNOWN when no rule holds, or the node has no
 * triangles. name: as for dm_gltf_get_hints. Errors: NOT_FOUND. */
DM_API dm_result DM_CALL dm_gltf_get_pivot_kind(const dm_gltf* gltf, const char* name, int32_t* out_kind);

/* Returns 1 when triangles of the file are missing in the merged mesh, because a triangle, a primitive or a node could
 * not be read, or only one of its instances was. Warnings of dm_gltf_open name them. Pass DM_PREPARE_MESH_INCOMPLETE
 * then. Returns 0 when all are there, or gltf is NULL. */
DM_API int32_t DM_CALL dm_gltf_left_out(const dm_gltf* gltf);

/* Reads a part mask: a .npy or JSON array with one integer a vertex or a face, in the order of the file where bones
 * sort the merged mesh otherwise. mask_value: the value of the part that moves; NULL = every value but 0. out_part_ids:
 * as many bytes as max(vertex_count, face_count). out_ambiguous: gets 1 when both lengths fit, and the integers were
 * taken per vertex; may be NULL. Errors: BAD_DATA; INVALID_ARGUMENT when neither length fits; EMPTY_MASK; FULL_MASK. */
DM_API dm_result DM_CALL dm_gltf_read_mask(const dm_gltf* gltf, const void* data, size_t size,
                                           const int64_t* mask_value, uint8_t* out_part_ids, int32_t* out_scope,
                                           int32_t* out_ambiguous);

/* One animated part: the faces it takes and its key poses (host frame = the file's scene frame, from rest). */
typedef struct dm_gltf_track {
    const char* name;        /* name of the new node and animation target; NULL = "moving_part" */
    const uint8_t* face_ids; /* face_count ids of the merged mesh */
    uint8_t value;           /* faces with this id move */
    uint8_t reserved[7];
    const dm_pose* poses; /* key_count poses */
    const float* times;   /* seconds, rising */
    uint32_t key_count;
    uint32_t reserved2;
} dm_gltf_track;

/* Writes a .glb with the file's meshes and materials. The tracks' faces are split off into nodes of their own, which a
 * looping animation moves. Without tracks it adds no animation. The file's own animations stay as they are, and still
 * move the nodes that they name. Release out_data with dm_gltf_release_bytes. */
DM_API dm_result DM_CALL dm_gltf_export(const dm_gltf* gltf, const dm_gltf_track* tracks, uint32_t track_count,
                                        void** out_data, size_t* out_size);
/* Releases bytes of dm_gltf_export, with the allocator of the dm_gltf. */
DM_API void DM_CALL dm_gltf_release_bytes(const dm_gltf* gltf, void* data, size_t size);

/* A mesh to write as one node of a new .glb. */
typedef struct dm_gltf_part {
    const char* name;
    const float* positions;  /* vertex_count x 3 numbers, glTF frame */
    const uint32_t* indices; /* index_count indices */
    uint64_t vertex_count, index_count;
    float colour[4]; /* base colour, linear; clamped to 0 to 1 */
} dm_gltf_part;

/* Writes a static .glb with one identity node a part. allocator: zeros = malloc/free; release out_data with the
 * same. */
DM_API dm_result DM_CALL dm_gltf_write(const dm_gltf_part* parts, uint32_t part_count, const dm_allocator* allocator,
                                       const dm_log* log, void** out_data, size_t* out_size);

/* Makes any text valid UTF-8, in place: it puts a '?' for each piece that is no character, also for one that was cut
 * off. Names and messages of this library are valid already; hosts need it for what they write beside them. Returns the
 * new length, which is never longer, and 0 for NULL. */
DM_API size_t DM_CALL dm_gltf_mend_text(char* text);

#ifdef __cplusplus
}
#endif

#endif
