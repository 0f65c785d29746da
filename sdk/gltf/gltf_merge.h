/* The merged mesh of a file whose tree is read, in which gltf_instance.c places the shapes. */
#ifndef DMI_GLTF_MERGE_H
#define DMI_GLTF_MERGE_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_shape.h"

/* Fills nodes, pieces, positions, indices and what belongs to them. */
dm_result dmi_gltf_merge(dm_gltf* gltf, dmi_gltf_problem* problem);

/* Appends the triangles of a node to the merged mesh, whose arrays have room for them. */
dm_result dmi_gltf_add_rigid(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);
/* Does the same for a node with a skin, bone by bone. A skin that cannot be used is left out with a warning. */
dm_result dmi_gltf_add_skinned(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);

#endif
