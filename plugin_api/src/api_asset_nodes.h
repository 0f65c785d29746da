/* The nodes of a host's asset, checked and copied. */
#ifndef DMI_API_ASSET_NODES_H
#define DMI_API_ASSET_NODES_H

#include "base/arena.h"

/* Copies the host's nodes, of any version, into the arena, with the meshes and joints that they point to, which have
 * versions too. Errors name the node and the field. */
dm_result dmi_asset_nodes_read(dmi_arena* arena, const dm_asset_desc* desc, dm_asset_node** out_nodes);

/* Makes the axes of the nodes' joints unit and their limits those of their types. size: the asset's, host units. */
dm_result dmi_asset_joints_accept(dmi_env* env, dm_asset_node* nodes, uint32_t count, float size);

#endif
