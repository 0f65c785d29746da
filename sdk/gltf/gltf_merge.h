/* The merged mesh of a file whose tree is read. */
#ifndef DMI_GLTF_MERGE_H
#define DMI_GLTF_MERGE_H

#include "gltf/gltf_file.h"

#define DMI_GLTF_TREE_READ 0.35f /* share of opening a file, before it is merged; by hand */

/* Fills nodes, pieces, positions, indices and what belongs to them. */
dm_result dmi_gltf_merge(dm_gltf* gltf, dmi_gltf_problem* problem);

#endif
