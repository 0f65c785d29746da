/* The joint by which the animations of a node move it. */
#ifndef DMI_ASSETS_CLIP_JOINT_H
#define DMI_ASSETS_CLIP_JOINT_H

#include <stdbool.h>

#include "dragmesh/dragmesh.h"

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
