/* Computes components with a disjoint-set forest over the pairs of pieces in contact. */
#include "segmentation/remaining_components.h"

#include <string.h>

#define MAX_CARRIED_AREA                                                                                               \
    0.25f /* area of a carried component, in areas of the part: larger ones do not depend on the part;                 \
           * by hand */

/* Returns the root, halving the path to it. */
static uint32_t find_root(uint32_t* parents, uint32_t p) {
    while (parents[p] != p) p = parents[p] = parents[parents[p]];
    return p;
}

dm_result dmi_remaining_components_make(dmi_arena* arena, const dmi_pieces* pieces, dmi_remaining_components* out) {
    *out = (dmi_remaining_components){.largest = DMI_PIECE_NONE};
    out->roots = dmi_arena_push(arena, pieces->count * sizeof *out->roots);
    out->area = dmi_arena_push(arena, pieces->count * sizeof *out->area);
    out->touches_part = dmi_arena_push(arena, pieces->count);
    if (out->roots != NULL && out->area != NULL && out->touches_part != NULL) return DM_OK;
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory for the components of %u pieces", pieces->count);
}

void dmi_remaining_components_find(const dmi_pieces* pieces, const uint8_t* inside, dmi_remaining_components* out) {
    const uint32_t count = pieces->count;
    uint32_t* roots = out->roots;
    memset(out->area, 0, count * sizeof *out->area);
    memset(out->touches_part, 0, count);
    for (uint32_t p = 0; p < count; p++) roots[p] = p;
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t *pair = pieces->pairs[i], a = pair[0], b = pair[1];
        if (!inside[a] && !inside[b]) roots[find_root(roots, a)] = find_root(roots, b);
    }
    for (uint32_t p = 0; p < count; p++) roots[p] = find_root(roots, p);
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t a = pieces->pairs[i][0], b = pieces->pairs[i][1];
        if (!inside[a] != !inside[b]) out->touches_part[roots[inside[a] ? b : a]] = 1;
    }
    out->part_area = 0;
    out->largest = DMI_PIECE_NONE;
    for (uint32_t p = 0; p < count; p++) *(inside[p] ? &out->part_area : &out->area[roots[p]]) += pieces->area[p];
    for (uint32_t p = 0; p < count; p++)
        if (!inside[p] && roots[p] == p && (out->largest == DMI_PIECE_NONE || out->area[p] > out->area[out->largest]))
            out->largest = p;
}

uint32_t dmi_remaining_components_carry(const dmi_pieces* pieces, const dmi_remaining_components* components,
                                        uint8_t* inside) {
    uint32_t carried = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        const uint32_t root = components->roots[p];
        if (inside[p] || root == components->largest || !components->touches_part[root]) continue;
        if (components->area[root] > MAX_CARRIED_AREA * components->part_area) continue;
        inside[p] = DMI_PIECE_CARRIED;
        carried++;
    }
    return carried;
}
