/* Renumbers bodies as a host finds their nodes. */
#include "assets/body_order.h"

#include <string.h>

dm_result dmi_asset_bodies_order(dmi_arena* arena, dmi_asset_bodies* bodies, uint32_t node_count, float min_moves,
                                 uint32_t** out_number) {
    const uint32_t count = bodies->count;
    uint32_t* number = dmi_arena_push(arena, (count + 1) * sizeof *number);
    dmi_asset_body* old = dmi_arena_push(arena, (count + 1) * sizeof *old);
    if (number == NULL || old == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memcpy(old, bodies->bodies, count * sizeof *old);
    for (uint32_t i = 0; i < count; i++) number[i] = DMI_ASSET_BODY;
    uint32_t next = 0;
    for (int moving = 1; moving >= 0; moving--)
        for (uint32_t n = 0; n < node_count; n++) {
            const uint32_t body = bodies->body_of_node[n];
            if (body == DMI_ASSET_BODY || number[body] != DMI_ASSET_BODY) continue;
            if ((old[body].moves >= min_moves) == (moving == 1)) number[body] = next++;
        }
    for (uint32_t i = 0; i < count; i++) {
        dmi_asset_body* body = &bodies->bodies[number[i]];
        *body = old[i];
        if (body->carrier != DMI_ASSET_BODY) body->carrier = number[body->carrier];
    }
    for (uint32_t n = 0; n < node_count; n++)
        if (bodies->body_of_node[n] != DMI_ASSET_BODY) bodies->body_of_node[n] = number[bodies->body_of_node[n]];
    *out_number = number;
    return DM_OK;
}
