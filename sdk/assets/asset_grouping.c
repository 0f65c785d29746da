/* Every node but the largest is a body of its own; nodes of a part that the file states are one. */
#include "assets/asset_grouping.h"

#include "math/linear3.h"

#define UNKNOWN 0.5f /* probability that a body moves of which nothing else is known */

static dm_result out_of_memory(dmi_env* env, uint32_t count) {
    return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "dm_asset_create: no memory for %u nodes", count);
}

/* Returns the node whose box has the longest diagonal among those of no given part. */
static uint32_t find_largest(const dmi_asset_query* query) {
    float longest = -1;
    uint32_t largest = DMI_ASSET_BODY;
    for (uint32_t i = 0; i < query->node_count; i++) {
        const dmi_part* part = &query->mesh->parts[i + 1];
        if (part->face_count == 0 || query->nodes[i].given_body != DMI_ASSET_BODY) continue;
        const float diagonal = dmi_distance3(part->box_min, part->box_max);
        if (diagonal <= longest) continue;
        longest = diagonal;
        largest = i;
    }
    return largest;
}

dm_result dmi_asset_find_bodies(dmi_env* env, const dmi_asset_query* query, dmi_asset_bodies* out) {
    const uint32_t count = query->node_count, largest = find_largest(query);
    uint32_t* given = dmi_arena_push(query->arena, count * sizeof *given); /* body of a given number */
    out->bodies = dmi_arena_push(query->arena, count * sizeof *out->bodies);
    out->body_of_node = dmi_arena_push(query->arena, count * sizeof *out->body_of_node);
    if (given == NULL || out->bodies == NULL || out->body_of_node == NULL) return out_of_memory(env, count);
    out->count = 0;
    for (uint32_t i = 0; i < count; i++) given[i] = DMI_ASSET_BODY;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = query->order[k];
        const dmi_asset_node* node = &query->nodes[i];
        const uint32_t above = node->parent == DMI_ASSET_BODY ? DMI_ASSET_BODY : out->body_of_node[node->parent];
        uint32_t* number = node->given_body == DMI_ASSET_BODY ? NULL : &given[node->given_body];
        const bool begun = number != NULL && *number != DMI_ASSET_BODY;
        out->body_of_node[i] = begun ? *number : above;
        const bool is_bare = query->mesh->parts[i + 1].face_count == 0;
        if (begun || node->is_fixed || node->follows || i == largest || (number == NULL && is_bare)) continue;
        if (number != NULL) *number = out->count;
        out->body_of_node[i] = out->count;
        out->bodies[out->count++] = (dmi_asset_body){.carrier = above, .moves = number != NULL ? 1 : UNKNOWN};
    }
    return DM_OK;
}

void dmi_asset_bodies_keep(dmi_asset_bodies* bodies, uint32_t node_count, const uint8_t* keep, uint32_t* scratch) {
    uint32_t kept = 0;
    for (uint32_t i = 0; i < bodies->count; i++) scratch[i] = keep[i] ? kept++ : DMI_ASSET_BODY;
    for (uint32_t i = 0; i < bodies->count; i++) {
        uint32_t* carrier = &bodies->bodies[i].carrier;
        while (*carrier != DMI_ASSET_BODY && !keep[*carrier]) *carrier = bodies->bodies[*carrier].carrier;
    }
    for (uint32_t i = 0; i < node_count; i++) {
        uint32_t* body = &bodies->body_of_node[i];
        while (*body != DMI_ASSET_BODY && !keep[*body]) *body = bodies->bodies[*body].carrier;
        if (*body != DMI_ASSET_BODY) *body = scratch[*body];
    }
    for (uint32_t i = 0; i < bodies->count; i++) {
        if (!keep[i]) continue;
        dmi_asset_body body = bodies->bodies[i];
        if (body.carrier != DMI_ASSET_BODY) body.carrier = scratch[body.carrier];
        bodies->bodies[scratch[i]] = body;
    }
    bodies->count = kept;
}
