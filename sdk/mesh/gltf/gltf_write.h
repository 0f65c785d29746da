/* A document as bytes for the host. */
#ifndef DMI_MESH_GLTF_WRITE_H
#define DMI_MESH_GLTF_WRITE_H

#include "base/env.h"
#include "mesh/gltf/gltf_tiny.h"

/* Writes the document into memory of the host. */
dm_result dmi_gltf_finish(dmi_env* env, dmi_tiny* tiny, void** out_data, size_t* out_size);

#endif
