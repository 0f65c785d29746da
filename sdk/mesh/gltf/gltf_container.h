/* The checks of a file before it is parsed. */
#ifndef DMI_MESH_GLTF_CONTAINER_H
#define DMI_MESH_GLTF_CONTAINER_H

#include "base/env.h"

/* Checks header, chunk sizes, nesting, and the numbers that address bytes, before tinygltf sees them. *out_binary:
 * .glb. */
dm_result dmi_gltf_check_container(dmi_env* env, const uint8_t* data, size_t size, int* out_binary);

#endif
