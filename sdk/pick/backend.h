/* The bottom level of picking: trees over the triangles of one part, behind one table of functions that every backend
 * fills. The top level, scenes of moved parts, is ours for all of them (scene.c). */
#ifndef DMI_PICK_BACKEND_H
#define DMI_PICK_BACKEND_H

#include <stdbool.h>

#include "base/env.h"
#include "base/progress.h"

#define DMI_PICK_WHY_SIZE 400   /* bytes of the reason why a backend does not work here; by hand */
#define DMI_POSITION_PADDING 16 /* readable bytes from any vertex on: Embree and vector code load four floats */

/* Its corners, and which of the mesh it is: together, so that what a hit needs comes with one line of the cache. */
typedef struct dmi_pick_face {
    uint32_t corner[3], of_mesh;
} dmi_pick_face;

/* Triangles of one part, none without area. The arrays belong to the caller. */
typedef struct dmi_triangles {
    const float* positions; /* vertex_count x 3, of order 1, DMI_POSITION_PADDING bytes behind them */
    const dmi_pick_face* faces;
    uint32_t vertex_count, face_count;
    const dmi_progress* progress; /* of building; NULL: none */
} dmi_triangles;

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
    /* The device is what the backend keeps for a context. Returns UNSUPPORTED where the backend does not work here, or
     * another error; `why` then tells the reason, and the log nothing. */
    dm_result (*open)(dmi_env* env, void** out_device, char* why, size_t why_size);
    void (*close)(void* device);
    /* Builds a tree, which reads the triangles until it is destroyed. Reports how far it is. Fails with a
     * message, CANCELLED too. Any number of threads at once. */
    dm_result (*build)(void* device, const dmi_triangles* triangles, void** out_tree);
    void (*destroy)(void* device, void* tree);
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
