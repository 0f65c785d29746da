/* Levels of detail: the same thing again, with fewer triangles. */
#ifndef DMI_GLTF_LOD_H
#define DMI_GLTF_LOD_H

#include "gltf/gltf_file.h"

/* Writes for each node the finest level whose coarser one it is, or lies in; -1: it is no coarser level. `shown` must
 * be known except for levels of detail. `solid`: 1 for a node when it or something below it is shown and has a mesh. */
dm_result dmi_gltf_find_finest(dm_gltf* gltf, const uint8_t* solid, dmi_gltf_problem* problem, int32_t* out_finest);

/* Returns the node at or below `finest` that is called as `node`, which lies in a coarser level of it, or `finest`
 * where none is. */
int32_t dmi_gltf_find_finer(const dm_gltf* gltf, int32_t finest, int32_t node);

#endif
