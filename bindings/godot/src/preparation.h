/* One preparation of an object: its mesh and hints, or the nodes of a whole asset, collected from nodes, and the task
 * that finds out its joints. */
#ifndef DRAGMESH_GODOT_PREPARATION_H
#define DRAGMESH_GODOT_PREPARATION_H

#include <stdatomic.h>
#include <stdbool.h>

#include "affine.h"
#include "dragmesh/dragmesh.h"
#include "engine.h"

typedef struct preparation {
    float* positions; /* three numbers a vertex */
    uint32_t *indices, *face_parts;
    size_t vertex_count, vertex_capacity, index_count, index_capacity, face_capacity;
    bool out_of_memory;

    dm_part_desc* parts;
    dm_pivot* pivots;
    uint32_t part_count;
    dm_model model;

    /* Of a whole asset. */
    struct asset_source* nodes; /* NULL: parts are described */
    uint32_t node_count;
    uint32_t* parts_of_nodes; /* the answer: ids of parts, 0 = the body */
    char* label;
    uint32_t asset_flags; /* dm_asset_desc.flags */

    atomic_bool cancelled, finished;
    _Atomic float progress; /* 0..1 */
    int64_t task;           /* of Godot's worker threads; -1 = none */
    dm_result result;
    dm_object object;
} preparation;

/* NULL without memory. parts, nodes: how many may be described; nodes 0: parts are given. */
preparation* preparation_new(uint32_t parts, uint32_t nodes);
/* Cancels it and waits for its end. */
void preparation_stop(preparation* p);
/* The object is the caller's. */
void preparation_free(preparation* p);

/* Whether a Mesh has a surface of triangles. */
bool preparation_has_triangles(const gd_value* mesh);
/* Adds the triangles of a Mesh at a place in the object frame; part 0 = the body. */
void preparation_add_mesh(preparation* p, const gd_value* mesh, const affine* place, uint32_t part);
/* Describes one part. label: of malloc, is taken over; may be NULL. pivot: may be NULL. */
void preparation_add_part(preparation* p, uint32_t id, uint32_t parent, int32_t joint_type, char* label,
                          const affine* pivot);

/* Describes a node of an asset, with its mesh in its own frame (nil: none). parent: place in the order of these calls +
 * 1, 0 = none. names: of malloc, are taken over; may be NULL. */
void preparation_add_node(preparation* p, const gd_value* mesh, const affine* place, uint32_t parent, char* name,
                          char* mesh_name, uint32_t flags);

/* Finds out the joints on one of Godot's worker threads, or here. */
void preparation_start(preparation* p);
void preparation_run(preparation* p);

#endif
