/* The scene as a list of nodes of an asset, with the clips (gltf_clips.c) and the joints (gltf_joints.c) of its nodes.
 */
#ifndef DMI_GLTF_ASSET_H
#define DMI_GLTF_ASSET_H

#include "gltf/gltf_file.h"

/* The answer of dm_gltf_get_asset. Its memory is the arena's. */
struct dmi_gltf_asset {
    dmi_arena arena;
    dm_asset_node* nodes; /* first the dm_gltf_nodes, then groups, then what follows others */
    uint32_t* file_nodes; /* index of each in the file */
    uint32_t count;
    uint32_t* places; /* per node of the file: its first place in `nodes`; DM_ASSET_NO_NODE: it is not there */
};

/* Frees the asset of a file, where one was asked for. */
void dmi_gltf_release_asset(dm_gltf* gltf);

/* Fills the clips of the asset's nodes: how each animation moves the node against the one above it. Animations that
 * cannot be read are left out with a warning. Those that leave a node where it is are left out in silence. */
dm_result dmi_gltf_read_clips(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem);

/* Fills the joints of the asset's nodes, from `extras` and KHR_physics_rigid_bodies. A joint that cannot be read, or
 * that leaves more than one way to move, is left out with a warning. */
dm_result dmi_gltf_read_joints(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem);

/* Returns the name of a DM_JOINT_* in `extras`, or NULL when it has none. */
const char* dmi_gltf_joint_name(int32_t type);

#endif
