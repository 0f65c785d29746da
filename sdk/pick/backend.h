/* The bottom level of picking: trees over the triangles of one part, behind one table of functions that every backend
 * fills. The top level, scenes of moved parts, is ours for all of them (scene.c). */
#ifndef DMI_PICK_BACKEND_H
#define DMI_PICK_BACKEND_H

#include <stdbool.h>

#include "base/env.h"
#include "base/progress.h"
#include "mesh/packed_mesh.h"

#define DMI_PICK_WHY_SIZE 400 /* bytes of the reason why a backend does not work here; by hand */

/* Triangles of one part, none without area. The arrays belong to the caller. */
typedef struct dmi_triangles {
    const float* positions; /* vertex_count x 3, of order 1, DMI_POSITION_PADDING bytes behind them */
    const uint16_t* narrow; /* face_count x 3 corners, or NULL */
    const uint32_t* wide;   /* the same where `narrow` is NULL */
    uint32_t vertex_count, face_count;
    const dmi_progress* progress; /* progress of building; NULL: none */
} dmi_triangles;

/* Which boxes and triangles a tree has where; all else of it is computed from the triangles. */
typedef struct dmi_tree_shape {
    const uint32_t* child;        /* DMI_WIDE references a node; 0: none */
    const uint32_t* face;         /* DMI_BLOCK faces a block, the first again where there are fewer */
    size_t child_step, face_step; /* numbers from one node, or block, to the next */
    uint32_t node_count, block_count;
} dmi_tree_shape;

/* origin + t direction for t from 0 to far; the direction's length is of order 1. The fourth floats are 0: a ray is
 * stored and loaded by vector instructions, and a load of what several stores have written waits for all of them. */
typedef struct dmi_part_ray {
    float origin[4], direction[4], far;
} dmi_part_ray;

typedef struct dmi_part_hit {
    uint32_t face;
    float u, v; /* weights of its second and third corner */
} dmi_part_hit;

typedef struct dmi_pick_backend {
    const char* name;
    int32_t choice; /* DM_PICK_* */
    bool wide;      /* reads corners of 32 bits alone */
    /* The device is what the backend keeps for a context. Returns UNSUPPORTED where the backend does not work here, or
     * another error; `why` then tells the reason, and the log nothing. */
    dm_result (*open)(dmi_env* env, void** out_device, char* why, size_t why_size);
    void (*close)(void* device);
    /* Builds a tree, which reads the triangles until it is destroyed. Reports how far it is. Fails with a
     * message, CANCELLED too. Any number of threads at once. */
    dm_result (*build)(void* device, const dmi_triangles* triangles, void** out_tree);
    void (*destroy)(void* device, void* tree);
    /* Makes the tree of a shape that may come from anywhere; BAD_DATA, without a message, where it is none of these
     * triangles, each of which it must have once. NULL: this backend stores none. */
    dm_result (*restore)(void* device, const dmi_triangles* triangles, const dmi_tree_shape* shape, void** out_tree);
    dmi_tree_shape (*shape)(const void* tree);
    /* Finds the first triangle along the ray, from either side, and never slips between two that share an edge. */
    bool (*first_hit)(const void* tree, const dmi_part_ray* ray, dmi_part_hit* out_hit);
} dmi_pick_backend;

/* Those that this build has, each with a comma behind it, for lists: premake's --pick leaves out the others. */
#if defined(DMI_NO_EMBREE)
#define DMI_PICK_EMBREE
#else
#define DMI_PICK_EMBREE &dmi_pick_embree,
extern const dmi_pick_backend dmi_pick_embree;
#endif
#if defined(DMI_NO_PORTABLE)
#define DMI_PICK_PORTABLE
#else
#define DMI_PICK_PORTABLE &dmi_pick_portable,
extern const dmi_pick_backend dmi_pick_portable;
#endif

#endif
