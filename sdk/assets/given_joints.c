/* Takes the joints that the file states. */
#include "assets/given_joints.h"

#include <string.h>

static void take_joint(const dm_joint* joint, dmi_asset_given* out) {
    out->basis = DM_ASSET_FROM_FILE;
    out->joint = *joint;
    out->joint.type_confidence = out->joint.joint_confidence = 1;
    out->joint.source = DM_JOINT_FROM_HOST;
    memset(out->joint.evidence, 0, sizeof out->joint.evidence);
}

void dmi_asset_read_given(const dm_asset_node* nodes, uint32_t count, bool use_clips, dmi_asset_given* out_given,
                          uint32_t* out_warnings) {
    *out_warnings = 0;
    for (uint32_t i = 0; i < count; i++) {
        out_given[i] = (dmi_asset_given){0};
        if (nodes[i].joint != NULL) take_joint(nodes[i].joint, &out_given[i]);
        if (use_clips && nodes[i].clip_count > 0) *out_warnings |= DM_ASSET_CLIP_LEFT_OUT;
    }
}
