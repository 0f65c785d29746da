/* Finds which body a loose unit goes with, by what they touch, and what carries each body: by the models, without them
 * by the file's own tree, else by what it touches most. */
#include "assets/asset_grouping.h"
#include "assets/carrier_choice.h"

#include <string.h>

/* ---- units that touch each other, but not the rest of what stays ---- */

#define NONE UINT32_MAX
/* Largest share of the body's cells that a group has: a gate's second post is no handle; by hand. */
#define MOST_SHARE 0.25f

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

dm_result dmi_asset_attach_loose_units(dmi_arena* arena, const dmi_node_cells* grid, uint32_t body_count,
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

/* ---- carriers ---- */

/* The body that carries a unit's node in the file's own tree; DMI_ASSET_BODY: none. */
static uint32_t carrier_in_tree(const dmi_asset_query* q, const dmi_asset_units* u, const uint32_t* body_of_unit,
                                uint32_t unit) {
    if (!q->use_names) return DMI_ASSET_BODY;
    uint32_t node = q->nodes[u->node[unit]].parent;
    for (uint32_t depth = 0; node != DMI_ASSET_BODY && depth < q->node_count; depth++) {
        const uint32_t above = u->of_node[node];
        if (above != UINT32_MAX && body_of_unit[above] != body_of_unit[unit]) return body_of_unit[above];
        node = q->nodes[node].parent;
    }
    return DMI_ASSET_BODY;
}

/* What the bodies touch: row b has the cells at which body b touches each other one, and last what stays. */
typedef struct touching {
    uint32_t count;
    uint32_t* touched; /* count x (count + 1) */
    uint32_t* cells;   /* number of each body's cells */
} touching;

static const uint32_t* row_of(const touching* t, uint32_t body) {
    return t->touched + (size_t)body * (t->count + 1);
}

static dm_result find_touching(dmi_arena* arena, const dmi_node_cells* g, const uint32_t* body_of_unit, uint32_t count,
                               touching* out) {
    const size_t size = (size_t)count * (count + 1) * sizeof *out->touched;
    *out = (touching){count, dmi_arena_push(arena, size + 1), dmi_arena_push(arena, (count + 1) * sizeof *out->cells)};
    if (out->touched == NULL || out->cells == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(out->touched, 0, size);
    memset(out->cells, 0, count * sizeof *out->cells);
    for (uint32_t unit = 0; unit < g->node_count; unit++) {
        const uint32_t b = body_of_unit[unit];
        if (b == DMI_ASSET_BODY) continue;
        out->cells[b] += dmi_cell_count(g, unit);
        for (uint32_t other = 0; other < g->node_count; other++) {
            const uint32_t body = body_of_unit[other];
            if (body == b) continue;
            out->touched[(size_t)b * (count + 1) + (body == DMI_ASSET_BODY ? count : body)] +=
                g->contacts[(size_t)unit * g->node_count + other];
        }
    }
    return DM_OK;
}

/* The larger body that b touches more than all that stays. */
static uint32_t find_larger(const touching* t, uint32_t b) {
    const uint32_t* row = row_of(t, b);
    uint32_t best = DMI_ASSET_BODY;
    for (uint32_t k = 0; k < t->count; k++)
        if (t->cells[k] > t->cells[b] && row[k] > row[t->count] && (best == DMI_ASSET_BODY || row[k] > row[best]))
            best = k;
    return best;
}

/* The body with a place that b touches most. held: body -> round in which it got its place, from 1; 0: not yet. */
static uint32_t find_held(const touching* t, const uint16_t* held, uint16_t round, uint32_t b,
                          const dmi_asset_bodies* bodies) {
    const uint32_t* row = row_of(t, b);
    uint32_t best = DMI_ASSET_BODY;
    for (uint32_t k = 0; k < t->count; k++)
        if (held[k] > 0 && held[k] < round && row[k] > (best == DMI_ASSET_BODY ? 0 : row[best]) &&
            !dmi_asset_is_carried_by(bodies, k, b))
            best = k;
    return best;
}

/* Hangs the bodies that touch nothing that stays on those that do, and so on outwards, round by round, as panels of a
 * folding door hang on each other. */
static void hang_chains(const touching* t, uint16_t* held, dmi_asset_bodies* out) {
    bool found = true;
    for (uint16_t round = 2; found; round++) {
        found = false;
        for (uint32_t b = 0; b < t->count; b++) {
            const uint32_t carrier = held[b] ? DMI_ASSET_BODY : find_held(t, held, round, b, out);
            if (carrier == DMI_ASSET_BODY) continue;
            out->bodies[b].carrier = carrier;
            held[b] = round;
            found = true;
        }
    }
}

/* Sets the carriers by rules. */
static dm_result carry_by_contacts(dmi_arena* arena, const dmi_node_cells* g, const uint32_t* body_of_unit,
                                   dmi_asset_bodies* out) {
    touching t;
    uint16_t* held = dmi_arena_push(arena, (out->count + 1) * sizeof *held);
    const dm_result result = find_touching(arena, g, body_of_unit, out->count, &t);
    if (result != DM_OK || held == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t b = 0; b < out->count; b++) {
        out->bodies[b].carrier = find_larger(&t, b);
        held[b] = out->bodies[b].carrier != DMI_ASSET_BODY || row_of(&t, b)[out->count] > 0;
    }
    hang_chains(&t, held, out);
    return DM_OK;
}

/* Hangs bodies where the file's own tree says: all of them, or those that are given alone. */
static void carry_by_tree(const dmi_asset_query* q, const dmi_asset_units* u, const uint32_t* body_of_unit,
                          bool given_alone, dmi_asset_bodies* out) {
    for (uint32_t unit = 0; unit < u->count; unit++) {
        const uint32_t b = body_of_unit[unit];
        if (b == DMI_ASSET_BODY) continue;
        if (given_alone && q->nodes[u->node[unit]].given_body == DMI_ASSET_BODY) continue;
        const uint32_t above = carrier_in_tree(q, u, body_of_unit, unit);
        if (above != DMI_ASSET_BODY && !dmi_asset_is_carried_by(out, above, b)) out->bodies[b].carrier = above;
    }
}

dm_result dmi_asset_find_carriers(const dmi_asset_query* q, const dmi_asset_units* u, const dmi_node_cells* g,
                                  const dmi_node_labels* labels, const uint32_t* body_of_unit, dmi_asset_bodies* out) {
    const bool rated = q->models != NULL;
    const dm_result result = rated ? dmi_asset_choose_carriers(q->arena, q->models, g, labels, body_of_unit, out)
                                   : carry_by_contacts(q->arena, g, body_of_unit, out);
    if (result == DM_OK) carry_by_tree(q, u, body_of_unit, rated, out);
    return result;
}
