/* The face of a mesh that is closest to a point. */
#ifndef DMI_SEGMENTATION_NEAREST_FACE_H
#define DMI_SEGMENTATION_NEAREST_FACE_H

#include "mesh/mesh.h"

/* Returns the index of the face closest to the point (object-normalised); of equals, the lowest. */
uint32_t dmi_mesh_nearest_face(const dmi_mesh* mesh, const float point[3]);

#endif
