/* dmi_mesh_create for large meshes: tells how far it is. */
#ifndef DMI_MESH_MESH_WATCHED_H
#define DMI_MESH_MESH_WATCHED_H

#include "base/progress.h"
#include "mesh/mesh.h"

/* As dmi_mesh_create; CANCELLED as well. watch: NULL = nobody asks. */
dm_result dmi_mesh_create_watched(dmi_env* env, const dmi_axes* axes, const dm_mesh_desc* desc,
                                  const dm_part_desc* parts, uint32_t part_count, const dmi_progress* progress,
                                  dmi_mesh** out_mesh);

#endif
