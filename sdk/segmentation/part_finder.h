/* Which faces move together with a point of the surface that a player grabs: the part, when no mask names it. */
#ifndef DMI_SEGMENTATION_PART_FINDER_H
#define DMI_SEGMENTATION_PART_FINDER_H

#include "mesh/mesh.h"

typedef struct dmi_part_query {
    const dmi_mesh* mesh; /* of dmi_mesh_create_pieces: its parts, when there are several, are rigid pieces */
    float point[3];       /* on or near the surface; object-normalised */
    float drag[3];        /* unit; zeros: none */
} dmi_part_query;

/* out_faces: 1 for the faces that move, 0 for the others. */
dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces);
uint32_t dmi_part_nearest_face(const dmi_mesh* mesh, const float point[3]);

#endif
