/* The animation that opens and closes the parts of a rigged asset. */
#ifndef DMI_EXPORT_RIG_CLIPS_H
#define DMI_EXPORT_RIG_CLIPS_H

#include "dragmesh/ext/gltf.h"
#include "export/rig_model.h"

/* Returns whether a clip of the file itself moves a body, or what carries it: another animation would move it twice. */
bool dmi_rig_is_left_to_clip(const dmi_rig_model* model, uint32_t body);
/* Makes a track for each body but the root and those left to clips, in their order, in memory of the model. The nodes
 * are those of the model's file. */
dm_result dmi_rig_make_tracks(dmi_rig_model* model, dm_gltf_track** out_tracks, uint32_t* out_count);

#endif
