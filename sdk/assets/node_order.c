/* Climbs from each node to one that has its place already, and places the way in reverse. */
#include "assets/node_order.h"

#include <string.h>

enum { UNSEEN, ON_THE_WAY, PLACED };

uint32_t dmi_asset_order_nodes(const uint32_t* above, uint32_t count, uint32_t* out_order, uint8_t* done) {
    memset(done, UNSEEN, count);
    for (uint32_t i = 0, placed = 0; i < count; i++) {
        uint32_t end = count, node = i;
        for (; node != DM_ASSET_NO_NODE && done[node] == UNSEEN; node = above[node]) {
            done[node] = ON_THE_WAY;
            out_order[--end] = node; /* the way lies at the end of the list, which is free so far */
        }
        if (node != DM_ASSET_NO_NODE && done[node] == ON_THE_WAY) return node;
        for (; end < count; end++) {
            done[out_order[end]] = PLACED;
            out_order[placed++] = out_order[end];
        }
    }
    return DM_ASSET_NO_NODE;
}
