/* Measures how a set stands in the object: what it has of the object's outer sides, and how it goes away from the
 * ground. No direction is known to be up, so that the fullest side counts as the ground. */
#include "assets/set_features.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

#define LAYER 2.0f        /* cells from a side of the object's box that are its outer layer; by hand */
#define LEAST_LAYER 0.02f /* share of a side's outline below which a layer counts as thin; by hand */
#define TINY 1e-6f        /* lengths and shares that are divided by are at least this */

/* ---- facts ---- */

static void count_layers(const dmi_node_cells* g, dmi_asset_facts* facts) {
    const uint32_t across = (uint32_t)g->size[0], stride[3] = {1, across, across * (uint32_t)g->size[1]};
    for (uint32_t n = 0; n < g->node_count; n++) {
        memset(facts->layers[n], 0, sizeof facts->layers[n]);
        for (uint32_t i = g->first[n]; i < g->first[n + 1]; i++)
            for (int axis = 0; axis < 3; axis++) {
                const uint32_t index = g->cells[i] / stride[axis] % (uint32_t)g->size[axis];
                const float middle = g->low[axis] + g->cell * ((float)index + 0.5f);
                facts->layers[n][2 * axis] += middle - facts->low[axis] <= LAYER * g->cell;
                facts->layers[n][2 * axis + 1] += facts->high[axis] - middle <= LAYER * g->cell;
            }
    }
}

dm_result dmi_asset_facts_add_layers(dmi_arena* arena, const dmi_node_cells* g, dmi_asset_facts* facts) {
    facts->layers = dmi_arena_push(arena, (g->node_count + 1) * sizeof *facts->layers);
    if (facts->layers == NULL) return DM_ERROR_OUT_OF_MEMORY;
    count_layers(g, facts);
    for (int side = 0; side < DMI_GRID_SIDES; side++) {
        const int b = (side / 2 + 1) % 3, c = (side / 2 + 2) % 3;
        const float outline = (facts->high[b] - facts->low[b]) * (facts->high[c] - facts->low[c]);
        uint32_t cells = 0;
        for (uint32_t n = 0; n < g->node_count; n++) cells += facts->layers[n][side];
        facts->cells_of_side[side] = outline / (g->cell * g->cell) + 1;
        facts->fullness[side] = (float)cells / facts->cells_of_side[side];
        if (facts->fullness[side] > facts->fullness[facts->ground]) facts->ground = side;
    }
    return DM_OK;
}

/* ---- features ---- */

/* Computes which share of each side's outline the set's outer layer covers. */
static void cover_sides(const dmi_node_set* s, const dmi_asset_facts* facts, float out[DMI_GRID_SIDES]) {
    for (int side = 0; side < DMI_GRID_SIDES; side++) {
        uint32_t cells = 0;
        for (uint32_t n = 0; n < s->grid->node_count; n++) cells += s->member[n] ? facts->layers[n][side] : 0;
        out[side] = (float)cells / facts->cells_of_side[side];
    }
}

/* Puts the set's shares of the six outer layers, largest first. */
static void put_shares(dmi_row* r, const dmi_asset_facts* facts, const float covered[DMI_GRID_SIDES]) {
    float share[DMI_GRID_SIDES];
    for (int side = 0; side < DMI_GRID_SIDES; side++) {
        share[side] = covered[side] / (facts->fullness[side] + LEAST_LAYER);
        for (int i = side; i > 0 && share[i] > share[i - 1]; i--) {
            const float t = share[i];
            share[i] = share[i - 1], share[i - 1] = t;
        }
    }
    for (int side = 0; side < DMI_GRID_SIDES; side++) dmi_put(r, share[side]);
}

static void put_place(dmi_row* r, const dmi_node_set* s, const dmi_asset_facts* facts) {
    const int ground = facts->ground, up = ground / 2, a = (up + 1) % 3, b = (up + 2) % 3;
    const float all = facts->high[up] - facts->low[up] + s->grid->cell, own = s->high[up] - s->low[up];
    const float low = ground % 2 ? facts->high[up] - s->high[up] : s->low[up] - facts->low[up];
    const float sides[2] = {s->high[a] - s->low[a], s->high[b] - s->low[b]};
    dmi_put(r, low / all), dmi_put(r, (low + own) / all);
    dmi_put(r, own / (dmi_fmaxf(sides[0], sides[1]) + s->grid->cell));
    dmi_put(r, own / (dmi_fminf(sides[0], sides[1]) + s->grid->cell));
}

/* Puts the ways away from the ground, towards it, and the freest one along it. */
static void put_ways_from_ground(dmi_row* r, const dmi_set_way ways[DMI_GRID_SIDES], int ground) {
    int away = 0, towards = 0, along = DMI_GRID_SIDES;
    for (int i = 0; i < DMI_GRID_SIDES; i++) {
        if (ways[i].side == (ground ^ 1)) away = i;
        if (ways[i].side == ground) towards = i;
        if (ways[i].side / 2 != ground / 2 && along == DMI_GRID_SIDES) along = i;
    }
    dmi_put(r, ways[away].near), dmi_put(r, ways[away].middle), dmi_put(r, (float)away);
    dmi_put(r, ways[towards].near);
    dmi_put(r, ways[along].near), dmi_put(r, ways[along].middle), dmi_put(r, ways[along].far);
    dmi_put(r, ways[towards].exposed), dmi_put(r, ways[away].exposed);
}

void dmi_put_standing(dmi_row* r, const dmi_node_set* s, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES]) {
    float covered[DMI_GRID_SIDES], most = 0, most_of_rest = 0;
    const int ground = facts->ground, top = ground ^ 1;
    cover_sides(s, facts, covered);
    for (int side = 0; side < DMI_GRID_SIDES; side++) {
        most = dmi_fmaxf(most, covered[side]);
        most_of_rest = dmi_fmaxf(most_of_rest, facts->fullness[side] - covered[side]);
    }
    dmi_put(r, most), dmi_put(r, most_of_rest);
    dmi_put(r, facts->fullness[ground]), dmi_put(r, facts->fullness[top]);
    dmi_put(r, covered[ground] / (facts->fullness[ground] + TINY));
    dmi_put(r, covered[top] / (facts->fullness[top] + TINY));
    put_place(r, s, facts);
    put_ways_from_ground(r, ways, ground);
    put_shares(r, facts, covered);
}
