/* Joints that a file states. */
#ifndef DMI_GLTF_JOINTS_H
#define DMI_GLTF_JOINTS_H

#include "gltf/gltf_asset.h"

/* Fills the joints of the asset's nodes, from `extras` and KHR_physics_rigid_bodies. A joint that cannot be read, or
 * that leaves more than one way to move, is left out with a warning. */
dm_result dmi_gltf_read_joints(dm_gltf* gltf, dmi_gltf_asset* asset, dmi_gltf_problem* problem);

/* Returns the name of a DM_JOINT_* in `extras`, or NULL when it has none. */
const char* dmi_gltf_joint_name(int32_t type);

#endif
