/* The host's mesh descriptor, checked before anything reads its buffers. */
#ifndef DMI_API_MESH_H
#define DMI_API_MESH_H

#include "base/env.h"

/* Copies a descriptor of any version and checks formats and the sizes of the buffers. what: "dm_function: argument". */
dm_result dmi_mesh_desc_read(dmi_env* env, const char* what, const dm_mesh_desc* mesh, dm_mesh_desc* out);

#endif
