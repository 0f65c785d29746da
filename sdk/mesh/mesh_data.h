/* What a mesh holds, and how its parts are looked up. */
#ifndef DMI_MESH_MESH_DATA_H
#define DMI_MESH_MESH_DATA_H

#include <stdint.h>

#include "math/frames.h"

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

#endif
