/* A shape placed in the scene: by its node, or by the bones of a skin. */
#ifndef DMI_GLTF_INSTANCE_H
#define DMI_GLTF_INSTANCE_H

#include "gltf/gltf_shape.h"

/* Appends the triangles of a node to the merged mesh, whose arrays have room for them. */
dm_result dmi_gltf_add_rigid(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);
/* Does the same for a node with a skin, bone by bone. A skin that cannot be used is left out with a warning. */
dm_result dmi_gltf_add_skinned(dm_gltf* gltf, const dmi_gltf_shape* shape, uint32_t node, dmi_gltf_problem* problem);

#endif
