/* Which pieces stay behind together when a part moves, and which hang on the rest through the part alone. */
#include <string.h>

#include "segmentation/part_choice.h"

#define MOST_CARRIED 0.25f /* of the part's area: what is larger has a joint of its own, or holds the part */

static uint32_t find_root(uint32_t* parents, uint32_t p) {
    while (parents[p] != p) p = parents[p] = parents[parents[p]];
    return p;
}

dm_result dmi_part_groups_make(dmi_arena* arena, const dmi_pieces* pieces, dmi_part_groups* out) {
    *out = (dmi_part_groups){.largest = DMI_PART_NONE};
    out->roots = dmi_arena_push(arena, pieces->count * sizeof *out->roots);
    out->area = dmi_arena_push(arena, pieces->count * sizeof *out->area);
    out->touches = dmi_arena_push(arena, pieces->count);
    if (out->roots != NULL && out->area != NULL && out->touches != NULL) return DM_OK;
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to group %u pieces", pieces->count);
}

void dmi_part_groups_find(const dmi_pieces* pieces, const uint8_t* inside, dmi_part_groups* groups) {
    const uint32_t count = pieces->count;
    uint32_t* roots = groups->roots;
    memset(groups->area, 0, count * sizeof *groups->area);
    memset(groups->touches, 0, count);
    for (uint32_t p = 0; p < count; p++) roots[p] = p;
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t *pair = pieces->pairs[i], a = pair[0], b = pair[1];
        if (!inside[a] && !inside[b]) roots[find_root(roots, a)] = find_root(roots, b);
    }
    for (uint32_t p = 0; p < count; p++) roots[p] = find_root(roots, p);
    for (uint32_t i = 0; i < pieces->pair_count; i++) {
        const uint32_t a = pieces->pairs[i][0], b = pieces->pairs[i][1];
        if (!inside[a] != !inside[b]) groups->touches[roots[inside[a] ? b : a]] = 1;
    }
    groups->part_area = 0;
    groups->largest = DMI_PART_NONE;
    for (uint32_t p = 0; p < count; p++) *(inside[p] ? &groups->part_area : &groups->area[roots[p]]) += pieces->area[p];
    for (uint32_t p = 0; p < count; p++)
        if (!inside[p] && roots[p] == p &&
            (groups->largest == DMI_PART_NONE || groups->area[p] > groups->area[groups->largest]))
            groups->largest = p;
}

uint32_t dmi_part_carry(const dmi_pieces* pieces, const dmi_part_groups* groups, uint8_t* inside) {
    uint32_t carried = 0;
    for (uint32_t p = 0; p < pieces->count; p++) {
        const uint32_t root = groups->roots[p];
        if (inside[p] || root == groups->largest || !groups->touches[root]) continue;
        if (groups->area[root] > MOST_CARRIED * groups->part_area) continue;
        inside[p] = 2;
        carried++;
    }
    return carried;
}
