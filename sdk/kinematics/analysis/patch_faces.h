/* The faces of the part, or of the body near it, copied out of the mesh with vertices numbered anew. */
#ifndef DMI_ANALYSIS_PATCH_FACES_H
#define DMI_ANALYSIS_PATCH_FACES_H

#include "base/arena.h"
#include "kinematics/analysis/distance_grid.h"
#include "mesh/mesh.h"

typedef struct dmi_patch_faces {
    dmi_mesh mesh;       /* has no positions; its indices are those of welded vertices */
    float (*corners)[3]; /* positions of the three corners of each face */
    float* gap;          /* least of a face's corners to the other side; object-normalised */
} dmi_patch_faces;

/* Copies the faces, the largest ones when there are very many. Overwrites `faces`. other_grid: distance grid of the
 * other side. The copy costs as much as there are faces, whatever the size of the mesh. */
dm_result dmi_patch_faces_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, uint32_t* faces,
                               uint32_t count, const dmi_distance_grid* other_grid, dmi_patch_faces* out);

#endif
