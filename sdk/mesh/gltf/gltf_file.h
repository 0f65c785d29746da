/* What a dm_gltf holds: the document, its tree of nodes and the merged mesh. */
#ifndef DMI_MESH_GLTF_FILE_H
#define DMI_MESH_GLTF_FILE_H

#include "base/env.h"
#include "dragmesh/ext/gltf.h"
#include "mesh/gltf/gltf_tiny.h"

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

#endif
