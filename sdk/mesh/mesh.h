/* A checked, object-normalised copy of the host's mesh with its parts. */
#ifndef DMI_MESH_MESH_H
#define DMI_MESH_MESH_H

#include <stdint.h>

#include "base/progress.h"
#include "math/frames.h"

/* ---- what a mesh holds, and how its parts are looked up ---- */

typedef struct dmi_part {
    uint32_t id;         /* the host's */
    uint32_t parent;     /* index in dmi_mesh.parts; 0 = the body */
    uint32_t face_count; /* alone, without carried parts */
    float box_min[3], box_max[3];
    float centre[3]; /* area-weighted surface centroid */
    float area;
} dmi_part;

typedef struct dmi_mesh {
    dmi_frame frame;
    float* positions;    /* vertex_count x 3, object-normalised; 16 readable bytes follow the last vertex (Embree) */
    uint32_t* indices;   /* face_count x 3 */
    uint32_t* face_part; /* index in parts */
    float* face_area;    /* 0 for slivers, thinner than their coordinates are exact */
    float* face_normal;  /* face_count x 3, unit or 0 for slivers; of the winding, times `winding` */
    float winding;       /* -1 when the object as a whole is wound inside out (as left-handed hosts do), so that closed
                            objects have outward normals whatever the host's habit; else +1 */
    uint32_t vertex_count, face_count;
    dmi_part* parts;     /* [0] is the body; then parts by rising id */
    uint32_t part_count; /* the body included */
} dmi_mesh;

/* Index of a part by the host's id; -1 when there is none (0 is the body). */
int32_t dmi_mesh_find_part(const dmi_mesh* mesh, uint32_t id);
/* 1 when part `index` is `ancestor` or is carried by it: what moves when `ancestor` moves. */
int dmi_mesh_moves_with(const dmi_mesh* mesh, uint32_t index, uint32_t ancestor);

/* ---- how it is made ---- */

/* Checks everything dragmesh.h promises and names what is wrong and where. `parts` may be NULL: then every id that owns
 * a triangle is a part; with a list, ids that are not in it are the body's.
 * progress: may be NULL; with one, CANCELLED as well. */
dm_result dmi_mesh_create(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, const dm_part_desc* parts,
                          uint32_t part_count, const dmi_progress* progress, dmi_mesh** out_mesh);
/* A mesh to look for parts in: desc->part_ids may be NULL (then all is one piece), and parts may be empty, cover
 * everything, or have no area. parts[0] has the faces of id 0. progress: may be NULL. */
dm_result dmi_mesh_create_pieces(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc,
                                 const dmi_progress* progress, dmi_mesh** out_mesh);
/* The same where the ids per face are 0 to piece_count: parts[i] has the faces of id i, and may be empty. */
dm_result dmi_mesh_create_numbered(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc, uint32_t piece_count,
                                   const dmi_progress* progress, dmi_mesh** out_mesh);
void dmi_mesh_destroy(dmi_env* env, dmi_mesh* mesh);

/* A mesh from a file: room, whose positions, indices, face_part and parts (id, parent, face_count) the caller fills, …
 */
dm_result dmi_mesh_restore(dmi_env* env, const dmi_frame* frame, uint32_t vertex_count, uint32_t face_count,
                           uint32_t part_count, dmi_mesh** out_mesh);
/* … and then areas, normals, boxes and centres, to the bits that dmi_mesh_create made of the same numbers. progress:
 * may be NULL. */
dm_result dmi_mesh_measure(dmi_env* env, const dmi_progress* progress, dmi_mesh* mesh);
/* Boxes, areas and centres of the parts alone, from face_part and the faces' areas. */
dm_result dmi_mesh_measure_parts(dmi_env* env, dmi_mesh* mesh);

#endif
