/* The joints that an asset states for its nodes. */
#ifndef DMI_ASSETS_GIVEN_JOINTS_H
#define DMI_ASSETS_GIVEN_JOINTS_H

#include "assets/asset_grouping.h"
#include "math/frames.h"

/* What the asset states for a node. Zeros: nothing. */
typedef struct dmi_asset_given {
    int32_t basis;  /* DM_ASSET_FROM_*; DM_ASSET_INFERRED: nothing is stated */
    float duration; /* s, of a clip's way; 0: none */
    dm_joint joint; /* asset frame, source DM_JOINT_FROM_HOST; its type may be DM_JOINT_FIXED */
} dmi_asset_given;

/* Reads what the file states for each node. nodes: of this version, checked, with accepted joints. frame: of the mesh
 * of all nodes. out_warnings: DM_ASSET_CLIP_LEFT_OUT. */
void dmi_asset_read_given(const dm_asset_node* nodes, uint32_t count, bool use_clips, const dmi_frame* frame,
                          dmi_asset_given* out_given, uint32_t* out_warnings);

#endif
