/* What a dm_gltf holds: the document, its tree of nodes and the merged mesh. */
#ifndef DMI_MESH_GLTF_GLTF_H
#define DMI_MESH_GLTF_GLTF_H

#include "base/env.h"
#include "dragmesh/ext/gltf.h"
#include "mesh/gltf/gltf_tiny.h"

/* Longest description of a place in a file ("node 3 'door', primitive 0"). */
#define DMI_GLTF_PLACE 192

/* One primitive of one node, as it lies in the merged mesh. */
typedef struct dmi_gltf_piece {
    uint32_t node;      /* position in dm_gltf.nodes */
    uint32_t primitive; /* position in the node's mesh */
    uint32_t mirrored;  /* the node's transform mirrors, so the triangles were turned over */
    uint64_t first_vertex, vertex_count;
    uint64_t first_face, face_count;
} dmi_gltf_piece;

struct dm_gltf {
    dmi_env env;
    dmi_tiny* tiny;
    int32_t* parents; /* of every node of the file; -1: none */
    double* worlds;   /* 16 a node of the file, column-major: node to scene */
    uint32_t* order;  /* nodes of the scene, parents before children */
    uint32_t tree_count, order_count;
    dm_gltf_node* nodes; /* nodes of the scene with triangles */
    uint32_t node_count;
    dmi_gltf_piece* pieces;
    uint32_t piece_count;
    uint64_t node_capacity, piece_capacity;
    float* positions;
    uint32_t* indices;
    uint64_t vertex_count, face_count;
};

/* A warning in the log, for what is left out of a file. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void dmi_gltf_warn(dmi_env* env, const char* format, ...);

/* Looks over the container before tinygltf sees it: header, chunk sizes, nesting. *out_binary: .glb. */
dm_result dmi_gltf_check_container(dmi_env* env, const uint8_t* data, size_t size, int* out_binary);

/* The tree: parents, the scene's nodes in order, world matrices. Refuses cycles and nodes with two parents. */
dm_result dmi_gltf_read_tree(dm_gltf* gltf);

/* Writes the document into memory of the host. */
dm_result dmi_gltf_finish(dmi_env* env, dmi_tiny* tiny, void** out_data, size_t* out_size);

/* The merged mesh. */
dm_result dmi_gltf_merge(dm_gltf* gltf);

/* Elements of an accessor, every byte of which was checked to lie in its buffer. */
typedef struct dmi_gltf_elements {
    const uint8_t* data; /* NULL: all zeros */
    uint64_t stride, count;
    int32_t component_type, components, normalized;
    const uint8_t *changed, *changes; /* sparse: which elements, and what they are instead */
    uint64_t change_count, changed_size, change_stride;
    int32_t changed_type;
} dmi_gltf_elements;

dm_result dmi_gltf_find_elements(dmi_env* env, const dmi_tiny* tiny, int32_t accessor, const char* place,
                                 dmi_gltf_elements* out);
/* Component `component` of element `i`, sparse changes apart. */
double dmi_gltf_element(const dmi_gltf_elements* elements, uint64_t i, int component);
/* The element that sparse change `i` is about, and its component. */
uint64_t dmi_gltf_changed(const dmi_gltf_elements* elements, uint64_t i);
double dmi_gltf_change(const dmi_gltf_elements* elements, uint64_t i, int component);

#endif
