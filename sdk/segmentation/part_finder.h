/* Finds the faces that move together with a grabbed point of the surface, for meshes without a part mask. */
#ifndef DMI_SEGMENTATION_PART_FINDER_H
#define DMI_SEGMENTATION_PART_FINDER_H

#include "base/progress.h"
#include "mesh/mesh.h"

/* ---- nearest face ---- */

/* Finds the face closest to the point (object-normalised); of equals, the lowest. progress: may be NULL; with one,
 * CANCELLED. */
dm_result dmi_mesh_nearest_face(const dmi_mesh* mesh, const float point[3], const dmi_progress* progress,
                                uint32_t* out_face);

/* ---- search ---- */

typedef struct dmi_part_query {
    const dmi_mesh* mesh; /* made by dmi_mesh_create_pieces: its parts, when there are several, are rigid pieces */
    float point[3];       /* a point on or near the surface; object-normalised */
    float drag[3];        /* unit; zeros: none */
    const dmi_progress* progress; /* hears of this search; NULL: none */
} dmi_part_query;

/* Sets out_faces[f] to 1 for the faces that move, to 0 for the others. DM_ERROR_FULL_MASK: every face would move. */
dm_result dmi_part_find(dmi_env* env, const dmi_part_query* query, uint8_t* out_faces);

#endif
