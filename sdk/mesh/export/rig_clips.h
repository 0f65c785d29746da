/* The animation that opens and closes all parts of a rigged asset. */
#ifndef DMI_MESH_EXPORT_RIG_CLIPS_H
#define DMI_MESH_EXPORT_RIG_CLIPS_H

#include "dragmesh/ext/gltf.h"
#include "mesh/export/rig_model.h"

/* Makes a track for each body but the root, in their order, in memory of the model. The nodes are those of the model's
 * file. */
dm_result dmi_rig_make_tracks(dmi_rig_model* model, dm_gltf_track** out_tracks);

#endif
