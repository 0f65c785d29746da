/* Finds groups of units that touch each other but not the rest of what stays. */
#include "assets/loose_units.h"

#include <string.h>

#define NONE UINT32_MAX
#define MOST_SHARE                                                                                                     \
    0.25f /* largest share of the body's cells that a group has: a gate's second post is no handle; by hand            \
           */

typedef struct groups {
    uint32_t* of_unit; /* group of each unit; NONE: it is of a body */
    uint32_t* cells;   /* number of each group's cells */
    uint32_t* stack;   /* scratch */
    uint32_t count, largest;
} groups;

/* Spreads group `group` from a unit to all that it touches, through units that stay. */
static void spread(const dmi_node_cells* g, const uint32_t* body_of_unit, uint32_t unit, uint32_t group, groups* out) {
    uint32_t depth = 0;
    out->stack[depth++] = unit;
    out->of_unit[unit] = group;
    while (depth > 0) {
        const uint32_t at = out->stack[--depth];
        out->cells[group] += dmi_cell_count(g, at);
        for (uint32_t n = 0; n < g->node_count; n++) {
            if (body_of_unit[n] != NONE || out->of_unit[n] != NONE) continue;
            if (g->contacts[(size_t)at * g->node_count + n] == 0) continue;
            out->of_unit[n] = group;
            out->stack[depth++] = n;
        }
    }
}

static dm_result find_groups(dmi_arena* arena, const dmi_node_cells* g, const uint32_t* body_of_unit, groups* out) {
    const size_t size = (g->node_count + 1) * sizeof(uint32_t);
    *out = (groups){dmi_arena_push(arena, size), dmi_arena_push(arena, size), dmi_arena_push(arena, size), 0, 0};
    if (out->of_unit == NULL || out->cells == NULL || out->stack == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(out->of_unit, 0xff, size); /* literal: every byte of NONE */
    memset(out->cells, 0, size);
    for (uint32_t u = 0; u < g->node_count; u++) {
        if (body_of_unit[u] != NONE || out->of_unit[u] != NONE) continue;
        spread(g, body_of_unit, u, out->count, out);
        if (out->cells[out->count] > out->cells[out->largest]) out->largest = out->count;
        out->count++;
    }
    return DM_OK;
}

/* Returns the body that the group touches most; NONE: it touches none. touched: scratch, one number a body. */
static uint32_t find_body(const dmi_node_cells* g, const groups* all, uint32_t group, uint32_t body_count,
                          const uint32_t* body_of_unit, uint32_t* touched) {
    uint32_t best = NONE;
    memset(touched, 0, body_count * sizeof *touched);
    for (uint32_t u = 0; u < g->node_count; u++) {
        if (all->of_unit[u] != group) continue;
        for (uint32_t n = 0; n < g->node_count; n++)
            if (body_of_unit[n] != NONE) touched[body_of_unit[n]] += g->contacts[(size_t)u * g->node_count + n];
    }
    for (uint32_t b = 0; b < body_count; b++)
        if (touched[b] > (best == NONE ? 0 : touched[best])) best = b;
    return best;
}

dm_result dmi_attach_loose_units(dmi_arena* arena, const dmi_node_cells* grid, uint32_t body_count,
                                 uint32_t* inout_body_of_unit) {
    groups all;
    uint32_t* scratch = dmi_arena_push(arena, (2 * (size_t)body_count + 1) * sizeof *scratch);
    const dm_result result = find_groups(arena, grid, inout_body_of_unit, &all);
    if (result != DM_OK || scratch == NULL) return DM_ERROR_OUT_OF_MEMORY;
    uint32_t *touched = scratch, *cells = scratch + body_count;
    memset(cells, 0, body_count * sizeof *cells);
    for (uint32_t u = 0; u < grid->node_count; u++)
        if (inout_body_of_unit[u] != NONE) cells[inout_body_of_unit[u]] += dmi_cell_count(grid, u);
    for (uint32_t group = 0; group < all.count; group++) {
        if (group == all.largest) continue;
        const uint32_t body = find_body(grid, &all, group, body_count, inout_body_of_unit, touched);
        if (body == NONE || (float)all.cells[group] > MOST_SHARE * (float)cells[body]) continue;
        for (uint32_t u = 0; u < grid->node_count; u++)
            if (all.of_unit[u] == group) inout_body_of_unit[u] = body;
    }
    return DM_OK;
}
