/* What the names, the origins, the joints and the animations (clip_joint.c) of an asset's nodes say of each body. */
#ifndef DMI_ASSETS_BODY_HINTS_H
#define DMI_ASSETS_BODY_HINTS_H

#include "assets/asset_grouping.h"
#include "math/frames.h"

/* Writes label and pivot of each body, from the nodes of the query, into its descriptor; they live in the arena of the
 * query. nodes: the host's, for their origins. */
dm_result dmi_asset_describe_bodies(dmi_env* env, const dmi_asset_query* query, const dm_asset_node* nodes,
                                    const dmi_asset_bodies* bodies, dm_part_desc* out_parts);

/* Returns whether a node has an origin and axes that may say something, and writes them. */
bool dmi_asset_node_pivot(const dm_asset_node* node, dm_pivot* out_pivot);

/* ---- joints that the asset states for its nodes ---- */

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

/* ---- the joint by which the animations of a node move it ---- */

/* Why clips are left out. */
enum {
    DMI_CLIP_NOT_RIGID = 1, /* one scales or bends the node */
    DMI_CLIP_NO_JOINT = 2,  /* one moves the node as no joint of one axis does */
    DMI_CLIP_DISAGREES = 4  /* one moves the node by another joint than the clip that moves it farthest */
};

typedef struct dmi_clip_joint {
    bool is_found;
    uint32_t left_out; /* DMI_CLIP_* */
    float duration;    /* s that the clip which moves it farthest takes from one end of its way to the other */
    dm_joint joint;    /* asset frame, source DM_JOINT_FROM_HOST; where is_found. Value 0 is the pose of the mesh. Its
                          limits hold all clips and rest; the farther one is `upper` */
} dmi_clip_joint;

/* Finds the joint of a node: that of the clip that moves it farthest, with the ranges of all clips that move it by the
 * same joint. A clip that leaves the node where it is says nothing. centre: near which the joint's origin lies on its
 * axis; size: largest side of the asset; both asset frame. */
dmi_clip_joint dmi_clip_find_joint(const dm_asset_clip* clips, uint32_t count, const float centre[3], float size);

#endif
