/* Takes the joints that the file states, and those of clips where it states none. */
#include "assets/given_joints.h"

#include <string.h>

#include "assets/body_hints.h"
#include "assets/clip_joint.h"
#include "math/vec3.h"

static void take_joint(const dm_joint* joint, dmi_asset_given* out) {
    out->basis = DM_ASSET_FROM_FILE;
    out->joint = *joint;
    out->joint.type_confidence = out->joint.joint_confidence = 1;
    out->joint.source = DM_JOINT_FROM_HOST;
    memset(out->joint.evidence, 0, sizeof out->joint.evidence);
}

/* The point near which the origin of a clip's joint lies: the node's own, or the middle of the asset. */
static void find_centre(const dm_asset_node* node, const dmi_frame* frame, float out[3]) {
    static const float middle[3] = {0, 0, 0};
    dm_pivot pivot;
    if (dmi_asset_node_pivot(node, &pivot))
        memcpy(out, dmi_xyz(pivot.origin).v, 3 * sizeof *out);
    else
        dmi_frame_point_out(frame, middle, out);
}

/* Takes the joint of the node's clips. Returns warnings. */
static uint32_t take_clips(const dm_asset_node* node, const dmi_frame* frame, dmi_asset_given* out) {
    float centre[3];
    find_centre(node, frame, centre);
    const dmi_clip_joint found =
        dmi_clip_find_joint(node->clips, node->clip_count, centre, dmi_frame_length_out(frame));
    if (found.is_found)
        *out = (dmi_asset_given){.basis = DM_ASSET_FROM_CLIP, .duration = found.duration, .joint = found.joint};
    return found.left_out ? DM_ASSET_CLIP_LEFT_OUT : 0;
}

void dmi_asset_read_given(const dm_asset_node* nodes, uint32_t count, bool use_clips, const dmi_frame* frame,
                          dmi_asset_given* out_given, uint32_t* out_warnings) {
    *out_warnings = 0;
    for (uint32_t i = 0; i < count; i++) {
        out_given[i] = (dmi_asset_given){0};
        if (nodes[i].joint != NULL)
            take_joint(nodes[i].joint, &out_given[i]);
        else if (use_clips && nodes[i].clip_count > 0 && !(nodes[i].flags & DM_ASSET_NODE_FOLLOWS))
            *out_warnings |= take_clips(&nodes[i], frame, &out_given[i]);
    }
}
