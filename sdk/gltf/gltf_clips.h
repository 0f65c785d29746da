/* Animations as clips of nodes. */
#ifndef DMI_GLTF_CLIPS_H
#define DMI_GLTF_CLIPS_H

#include "gltf/gltf_asset.h"

/* Fills the clips of the asset's nodes: how each animation moves the node against the one above it. Animations that
 * cannot be read are left out with a warning. Those that leave a node where it is are left out in silence. */
dm_result dmi_gltf_read_clips(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem);

#endif
