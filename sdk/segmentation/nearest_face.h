/* The face of a mesh that is closest to a point. */
#ifndef DMI_SEGMENTATION_NEAREST_FACE_H
#define DMI_SEGMENTATION_NEAREST_FACE_H

#include "base/progress.h"
#include "mesh/mesh.h"

/* Finds the face closest to the point (object-normalised); of equals, the lowest. progress: may be NULL; with one,
 * CANCELLED. */
dm_result dmi_mesh_nearest_face(const dmi_mesh* mesh, const float point[3], const dmi_progress* progress,
                                uint32_t* out_face);

#endif
