/* What the names and origins of an asset's nodes say of each body. */
#ifndef DMI_ASSETS_BODY_HINTS_H
#define DMI_ASSETS_BODY_HINTS_H

#include "assets/asset_grouping.h"

/* Writes label and pivot of each body, from the nodes of the query, into its descriptor; they live in the arena of the
 * query. nodes: the host's, for their origins. */
dm_result dmi_asset_describe_bodies(dmi_env* env, const dmi_asset_query* query, const dm_asset_node* nodes,
                                    const dmi_asset_bodies* bodies, dm_part_desc* out_parts);

/* Returns whether a node has an origin and axes that may say something, and writes them. */
bool dmi_asset_node_pivot(const dm_asset_node* node, dm_pivot* out_pivot);

#endif
