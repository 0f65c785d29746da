/* Finds nodes by the names that a caller gives. */
#ifndef DMI_MESH_GLTF_NAMES_H
#define DMI_MESH_GLTF_NAMES_H

#include "mesh/gltf/gltf_file.h"

/* Returns the first node of this name; "#12", unless a node is really called so, is node 12 of the file. -1: none. */
int64_t dmi_gltf_find_node(const dm_gltf* gltf, const char* name);

#endif
