/* Makes meshes of some of a node's triangles. */
#ifndef DMI_GLTF_SPLIT_H
#define DMI_GLTF_SPLIT_H

#include "gltf/gltf_moves.h"

/* Adds a mesh of the triangles of a node that `owner` has (as dmi_moves.owners counts), with owner 0 also of what has
 * no triangles. Returns its index, or -1 when there is nothing. For a node with a skin, a mesh that moves stands in the
 * scene's frame, less the origin, and has no bones. */
int32_t dmi_split_mesh(dmi_edit* e, const dmi_moves* moves, uint32_t node, uint32_t owner);

#endif
