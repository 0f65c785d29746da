/* The merged mesh of a file whose tree is read. */
#ifndef DMI_MESH_GLTF_MERGE_H
#define DMI_MESH_GLTF_MERGE_H

#include "mesh/gltf/gltf_file.h"

/* Fills nodes, pieces, positions and indices. */
dm_result dmi_gltf_merge(dm_gltf* gltf);

#endif
