/* The tree of nodes of a parsed file. */
#ifndef DMI_MESH_GLTF_TREE_H
#define DMI_MESH_GLTF_TREE_H

#include "mesh/gltf/gltf_file.h"

/* Fills parents, order (the scene's nodes) and worlds. Refuses cycles and nodes with two parents. */
dm_result dmi_gltf_read_tree(dm_gltf* gltf);

#endif
