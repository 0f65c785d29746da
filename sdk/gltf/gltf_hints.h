/* What a file says of a node beside its mesh. */
#ifndef DMI_GLTF_HINTS_H
#define DMI_GLTF_HINTS_H

#include <stdbool.h>

#include "gltf/gltf_file.h"

/* Returns the name of a node's mesh, or "" when it has none. */
const char* dmi_gltf_mesh_name(const dm_gltf* gltf, const dmi_gltf_tree_node* node);
/* Copies origin and axes from the node's transform to the scene, as the merged mesh has them. Returns false, and zeros,
 * where no float holds them. */
bool dmi_gltf_write_pivot(const dm_gltf* gltf, const double world[16], dm_pivot* out);
/* Judges the pivots of all nodes that have triangles: after these are merged. */
dm_result dmi_gltf_judge_pivots(dm_gltf* gltf, dmi_gltf_problem* problem);

#endif
