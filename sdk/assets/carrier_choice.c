/* Rates who carries each body, and takes the likeliest answers that form no circle. */
#include "assets/carrier_choice.h"

#include <string.h>

#include "math/elementary.h"

/* Bodies, what may carry each, and how likely that is among all that may. carrier: DMI_ASSET_BODY: what stays. */
typedef struct carrier_pairs {
    uint32_t *body, *carrier;
    float* probability;
    uint32_t count;
} carrier_pairs;

static uint32_t count_pairs(const dmi_carrier_facts* facts) {
    uint32_t count = 0;
    for (uint32_t b = 0; b < facts->count; b++)
        for (uint32_t c = 0; c <= facts->count; c++) count += dmi_carrier_is_candidate(facts, b, c);
    return count;
}

static dm_result make_room(dmi_arena* arena, const dmi_carrier_facts* facts, carrier_pairs* out) {
    const size_t most = (size_t)count_pairs(facts) + 1;
    *out = (carrier_pairs){dmi_arena_push(arena, most * sizeof *out->body),
                           dmi_arena_push(arena, most * sizeof *out->carrier),
                           dmi_arena_push(arena, most * sizeof *out->probability), 0};
    return out->body != NULL && out->carrier != NULL && out->probability != NULL ? DM_OK : DM_ERROR_OUT_OF_MEMORY;
}

static void rate_pairs(const dmi_tree_ensemble* trees, const dmi_carrier_facts* facts, carrier_pairs* out) {
    for (uint32_t b = 0; b < facts->count; b++) {
        const uint32_t first = out->count;
        for (uint32_t c = 0; c <= facts->count; c++) {
            if (!dmi_carrier_is_candidate(facts, b, c)) continue;
            float row[DMI_CARRIER_FEATURES];
            dmi_carrier_features_make(facts, b, c, row);
            out->body[out->count] = b;
            out->carrier[out->count] = c < facts->count ? c : DMI_ASSET_BODY;
            out->probability[out->count++] = dmi_tree_ensemble_score(trees, row);
        }
        dmi_softmax(out->probability + first, out->count - first);
    }
}

/* Returns the likeliest pair of a body that has no carrier yet which forms no circle. What stays forms none, so there
 * is one for each. */
static uint32_t find_best(const carrier_pairs* all, const uint8_t* placed, const dmi_asset_bodies* bodies) {
    uint32_t best = UINT32_MAX;
    for (uint32_t i = 0; i < all->count; i++) {
        if (placed[all->body[i]] || (best != UINT32_MAX && all->probability[i] <= all->probability[best])) continue;
        if (all->carrier[i] == DMI_ASSET_BODY || !dmi_asset_is_carried_by(bodies, all->carrier[i], all->body[i]))
            best = i;
    }
    return best;
}

static dm_result choose(dmi_arena* arena, const carrier_pairs* all, dmi_asset_bodies* bodies) {
    uint8_t* placed = dmi_arena_push(arena, bodies->count + 1);
    if (placed == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(placed, 0, bodies->count);
    for (uint32_t b = 0; b < bodies->count; b++) bodies->bodies[b].carrier = DMI_ASSET_BODY;
    for (uint32_t b = 0; b < bodies->count; b++) {
        const uint32_t best = find_best(all, placed, bodies);
        bodies->bodies[all->body[best]].carrier = all->carrier[best];
        placed[all->body[best]] = 1;
    }
    return DM_OK;
}

dm_result dmi_asset_choose_carriers(dmi_arena* arena, const dmi_asset_models* models, const dmi_node_cells* grid,
                                    const dmi_node_labels* labels, const uint32_t* body_of_unit,
                                    dmi_asset_bodies* bodies) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dmi_carrier_facts facts;
    carrier_pairs pairs;
    float* moves = dmi_arena_push(arena, (bodies->count + 1) * sizeof *moves);
    if (moves == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t b = 0; b < bodies->count; b++) moves[b] = bodies->bodies[b].moves;
    dm_result result = dmi_carrier_facts_make(arena, grid, labels, body_of_unit, moves, bodies->count, &facts);
    if (result == DM_OK) result = make_room(arena, &facts, &pairs);
    if (result == DM_OK) rate_pairs(&models->carriers, &facts, &pairs);
    if (result == DM_OK) result = choose(arena, &pairs, bodies);
    dmi_arena_rewind(arena, mark);
    return result;
}
