/* A C view of a glTF document held by tinygltf: the one place where C and C++ meet. No exception passes it.
 *
 * Reading functions answer 0 for an index that does not exist and check nothing else: offsets, counts and strides are
 * as the file states them. Editing functions keep the first failure in the document, do nothing after it and answer -1;
 * dmi_tiny_write reports it, so that an edit reads without a check a line. */
#ifndef DMI_MESH_GLTF_GLTF_TINY_H
#define DMI_MESH_GLTF_GLTF_TINY_H

#include "dragmesh/dragmesh.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct dmi_tiny dmi_tiny;

/* glTF's own numbers. */
enum {
    DMI_TINY_BYTE = 5120,
    DMI_TINY_UBYTE = 5121,
    DMI_TINY_SHORT = 5122,
    DMI_TINY_USHORT = 5123,
    DMI_TINY_UINT = 5125,
    DMI_TINY_FLOAT = 5126
};
enum { DMI_TINY_TRIANGLES = 4, DMI_TINY_STRIP = 5, DMI_TINY_FAN = 6 };
enum { DMI_TINY_VERTICES = 34962, DMI_TINY_INDICES = 34963 };

/* data: a container whose header was checked. `message` gets what tinygltf says against it. */
dm_result dmi_tiny_parse(const void* data, size_t size, int binary, dmi_tiny** out_tiny, char* message,
                         size_t message_size);
/* An empty document with one scene. NULL: no memory. */
dmi_tiny* dmi_tiny_new(void);
dmi_tiny* dmi_tiny_clone(const dmi_tiny* tiny);
void dmi_tiny_free(dmi_tiny* tiny);

/* ---- reading ---- */

/* Bytes of a view. `stride` 0: packed. `buffer_size` is what the buffer really holds. */
typedef struct dmi_tiny_view {
    const uint8_t* buffer;
    uint64_t buffer_size, offset, size, stride;
} dmi_tiny_view;

typedef struct dmi_tiny_accessor {
    uint64_t offset, count;
    int32_t view; /* -1: zeros */
    int32_t component_type, components, normalized;
    int32_t sparse; /* non-zero: the fields below count */
    uint64_t sparse_count, index_offset, value_offset;
    int32_t index_view, index_type, value_view;
} dmi_tiny_accessor;

typedef struct dmi_tiny_primitive {
    int32_t mode;
    int32_t positions, indices, material; /* -1: none */
    int32_t compressed;                   /* its geometry lies in an extension */
    int32_t morphs;
} dmi_tiny_primitive;

typedef struct dmi_tiny_node {
    const char* name;
    int32_t mesh, skin; /* -1: none */
    const int* children;
    uint32_t child_count;
    uint32_t instanced; /* EXT_mesh_gpu_instancing */
    double matrix[16];  /* column-major, of its translation, rotation and scale where it has no matrix */
} dmi_tiny_node;

uint32_t dmi_tiny_node_count(const dmi_tiny* tiny);
int dmi_tiny_get_view(const dmi_tiny* tiny, int32_t index, dmi_tiny_view* out);
int dmi_tiny_get_accessor(const dmi_tiny* tiny, int32_t index, dmi_tiny_accessor* out);
int dmi_tiny_get_node(const dmi_tiny* tiny, uint32_t index, dmi_tiny_node* out);
int dmi_tiny_has_mesh(const dmi_tiny* tiny, int32_t index);
uint32_t dmi_tiny_primitive_count(const dmi_tiny* tiny, int32_t mesh);
int dmi_tiny_get_primitive(const dmi_tiny* tiny, int32_t mesh, uint32_t index, dmi_tiny_primitive* out);
/* Linear base colour; white for a material that does not exist. */
void dmi_tiny_get_colour(const dmi_tiny* tiny, int32_t material, float out[4]);
/* Root nodes of the scene that a viewer shows; *out_count 0 when it has none. */
const int* dmi_tiny_scene_roots(const dmi_tiny* tiny, uint32_t* out_count);
/* The first extension the file requires and this library can't read; NULL when there is none. */
const char* dmi_tiny_foreign_extension(const dmi_tiny* tiny);

/* ---- editing ---- */

/* All data into one embedded buffer, images included. */
void dmi_tiny_embed(dmi_tiny* tiny);
int32_t dmi_tiny_add_view(dmi_tiny* tiny, const void* data, size_t size, int32_t target);
/* components 1, 3 or 4, packed; minimum and maximum may be NULL. */
int32_t dmi_tiny_add_accessor(dmi_tiny* tiny, int32_t view, int32_t component_type, int32_t components, uint64_t count,
                              const float* minimum, const float* maximum);
int32_t dmi_tiny_add_material(dmi_tiny* tiny, const float colour[4]);
/* `like` -1: a new mesh; else one with the same name and extras, without primitives. */
int32_t dmi_tiny_add_mesh(dmi_tiny* tiny, const char* name, int32_t like);
void dmi_tiny_add_primitive(dmi_tiny* tiny, int32_t mesh, int32_t positions, int32_t indices, int32_t material);
/* Appends a copy of a primitive to `to_mesh`, with other triangles of the same vertices; indices -1: the same
 * triangles. */
void dmi_tiny_copy_primitive(dmi_tiny* tiny, int32_t mesh, uint32_t primitive, int32_t to_mesh, int32_t indices);
int32_t dmi_tiny_add_node(dmi_tiny* tiny, const char* name, int32_t mesh);
void dmi_tiny_set_mesh(dmi_tiny* tiny, int32_t node, int32_t mesh);
void dmi_tiny_set_translation(dmi_tiny* tiny, int32_t node, const double translation[3]);
void dmi_tiny_copy_transform(dmi_tiny* tiny, int32_t from, int32_t to);
void dmi_tiny_add_root(dmi_tiny* tiny, int32_t node);
void dmi_tiny_add_child(dmi_tiny* tiny, int32_t parent, int32_t child);
/* Takes a node out of its parent and of every scene; when it carries others, an unnamed node with its transform stays
 * in its place and carries them. */
void dmi_tiny_unhook(dmi_tiny* tiny, int32_t node);
/* First of the animations, so that it is what a viewer plays. Answers 0, its index. */
int32_t dmi_tiny_add_animation(dmi_tiny* tiny, const char* name);
/* path: "translation" or "rotation"; linear. */
void dmi_tiny_add_channel(dmi_tiny* tiny, int32_t animation, int32_t node, const char* path, int32_t times,
                          int32_t values);

/* The document as .glb. The bytes live in it until the next call. */
dm_result dmi_tiny_write(dmi_tiny* tiny, const void** out_data, size_t* out_size, char* message, size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
