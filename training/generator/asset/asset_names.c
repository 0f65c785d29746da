/* Names nodes as exporters leave them. */
#include <stdio.h>
#include <string.h>

#include "asset/asset_layer.h"

void dmg_name_nodes(dmg_builder* b, dmg_asset* asset) {
    const bool telling = dmg_chance(b, 0.4f);
    for (uint32_t i = 0; i < asset->node_count; ++i) {
        dmg_asset_node* node = &asset->nodes[i];
        const char* part = node->part == 0 ? "body" : asset->object.joints[node->part - 1].name;
        snprintf(node->name, sizeof node->name, "%.40s_%u", telling ? part : "mesh", i);
        snprintf(node->mesh_name, sizeof node->mesh_name, "%.60s", node->name);
    }
}
