/* The order of an asset's nodes in which what is above a node comes before it. */
#ifndef DMI_ASSETS_NODE_ORDER_H
#define DMI_ASSETS_NODE_ORDER_H

#include "base/env.h"

/* Writes all nodes, each after the one that above[node] names; DM_ASSET_NO_NODE: none. Returns DM_ASSET_NO_NODE, or a
 * node that is above itself. done: a byte a node, scratch. */
uint32_t dmi_asset_order_nodes(const uint32_t* above, uint32_t count, uint32_t* out_order, uint8_t* done);

#endif
