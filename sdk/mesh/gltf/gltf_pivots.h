/* Judges whether the pivots of a file's nodes follow a rule. */
#ifndef DMI_MESH_GLTF_PIVOTS_H
#define DMI_MESH_GLTF_PIVOTS_H

#include "mesh/gltf/gltf_file.h"

/* Judges the pivots of all nodes that have triangles. Call it after these are merged. */
dm_result dmi_gltf_judge_pivots(dm_gltf* gltf, dmi_gltf_problem* problem);
/* Returns what is known of the pivot of a node of the file: DM_PIVOT_*. */
int32_t dmi_gltf_pivot_kind(const dm_gltf* gltf, uint32_t file_node);

#endif
