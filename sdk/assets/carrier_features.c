/* Measures bodies of an asset against each other: contacts, boxes, names and the tree. */
#include "assets/carrier_features.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "assets/asset_grouping.h"
#include "assets/set_features.h"
#include "math/elementary.h"

/* All set by hand. */
#define NEAR_CELLS 4.0f /* cells; boxes that are farther apart are of bodies that are not near */
#define TINY 1e-6f      /* lengths and counts that are divided by are at least this */
#define MOST_HOPS 8.0f  /* bodies on the way to what stays; more count as this */

static size_t at(const dmi_carrier_facts* f, uint32_t row, uint32_t column) {
    return (size_t)row * (f->count + 1) + column;
}

static uint32_t body_of(const dmi_carrier_facts* f, uint32_t unit) {
    return f->body_of_unit[unit] == UINT32_MAX ? f->count : f->body_of_unit[unit];
}

/* ---- bodies by themselves, and their contacts ---- */

static void add_unit(const dmi_carrier_facts* f, uint32_t unit, dmi_carried_body* body) {
    const dmi_node_cells* g = f->grid;
    const uint32_t cells = dmi_cell_count(g, unit);
    if (body->cells == 0 || cells > dmi_cell_count(g, body->largest)) body->largest = unit;
    body->cells += cells;
    body->area += g->area[unit];
    body->part += f->labels->name[unit] == DMI_NAME_PART ? (float)cells : 0;
    body->grip += f->labels->name[unit] == DMI_NAME_GRIP ? (float)cells : 0;
    for (int k = 0; k < 3; k++) {
        body->low[k] = dmi_fminf(body->low[k], g->low_of[unit][k]);
        body->high[k] = dmi_fmaxf(body->high[k], g->high_of[unit][k]);
    }
}

/* Counts a unit's cells that are named to hang on another body by the nearest unit above it in the tree. */
static void add_above(const dmi_carrier_facts* f, uint32_t unit, const uint32_t* unit_of_node) {
    const uint32_t own = body_of(f, unit);
    for (uint32_t node = f->labels->nodes[f->labels->unit_node[unit]].parent; node != DMI_ASSET_BODY;
         node = f->labels->nodes[node].parent) {
        if (unit_of_node[node] == UINT32_MAX || body_of(f, unit_of_node[node]) == own) continue;
        f->above[at(f, own, body_of(f, unit_of_node[node]))] += dmi_cell_count(f->grid, unit);
        return;
    }
}

static void add_contacts(const dmi_carrier_facts* f, uint32_t unit) {
    const uint32_t own = body_of(f, unit), units = f->grid->node_count;
    for (uint32_t other = 0; other < units; other++)
        if (body_of(f, other) != own)
            f->touched[at(f, own, body_of(f, other))] += f->grid->contacts[(size_t)unit * units + other];
}

static void measure_bodies(const dmi_carrier_facts* f, const float* moves) {
    for (uint32_t b = 0; b <= f->count; b++) {
        f->bodies[b] = (dmi_carried_body){.moves = b < f->count ? moves[b] : 0, .hops = UINT32_MAX};
        for (int k = 0; k < 3; k++) f->bodies[b].low[k] = INFINITY, f->bodies[b].high[k] = -INFINITY;
    }
    for (uint32_t unit = 0; unit < f->grid->node_count; unit++) {
        add_unit(f, unit, &f->bodies[body_of(f, unit)]);
        add_contacts(f, unit);
    }
    for (uint32_t b = 0; b <= f->count; b++) {
        dmi_carried_body* body = &f->bodies[b];
        if (body->cells == 0) memset(body->low, 0, sizeof body->low), memset(body->high, 0, sizeof body->high);
        body->part /= (float)body->cells + TINY;
        body->grip /= (float)body->cells + TINY;
    }
}

static bool touch(const dmi_carrier_facts* f, uint32_t a, uint32_t b) {
    return f->touched[at(f, a, b)] > 0 || f->touched[at(f, b, a)] > 0;
}

static bool are_alike(const dmi_carried_body* a, const dmi_carried_body* b) {
    return dmi_shapes_are_alike(a->low, a->high, a->area, b->low, b->high, b->area);
}

static void compare_bodies(const dmi_carrier_facts* f) {
    for (uint32_t a = 0; a <= f->count; a++)
        for (uint32_t b = 0; b <= f->count; b++) {
            f->bodies[a].touching += f->touched[at(f, a, b)];
            if (a == b) continue;
            f->alike[at(f, a, b)] = a < f->count && b < f->count && are_alike(&f->bodies[a], &f->bodies[b]);
            f->bodies[a].twins += f->alike[at(f, a, b)];
            f->bodies[a].neighbours += b < f->count && touch(f, a, b);
        }
}

/* ---- ways to what stays ---- */

/* Bodies that touch each body, in lists. */
typedef struct contact_lists {
    uint32_t *first, *neighbours;
    uint32_t *queue, *hops; /* scratch */
} contact_lists;

static dm_result list_contacts(dmi_arena* arena, const dmi_carrier_facts* f, contact_lists* out) {
    uint32_t count = 0;
    for (uint32_t b = 0; b <= f->count; b++) count += f->bodies[b].neighbours;
    count += f->bodies[f->count].neighbours; /* those of what stays are in both bodies' lists */
    const size_t size = (f->count + 2) * sizeof(uint32_t);
    *out = (contact_lists){dmi_arena_push(arena, size), dmi_arena_push(arena, (count + 1) * sizeof(uint32_t)),
                           dmi_arena_push(arena, size), dmi_arena_push(arena, size)};
    if (out->first == NULL || out->neighbours == NULL || out->queue == NULL || out->hops == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    uint32_t used = 0;
    for (uint32_t a = 0; a <= f->count; a++) {
        out->first[a] = used;
        for (uint32_t b = 0; b <= f->count; b++)
            if (a != b && touch(f, a, b)) out->neighbours[used++] = b;
    }
    out->first[f->count + 1] = used;
    return DM_OK;
}

/* Counts the hops of each body to what stays, without going through `without`. */
static void count_hops(const dmi_carrier_facts* f, const contact_lists* lists, uint32_t without) {
    uint32_t head = 0, tail = 0;
    memset(lists->hops, 0xff, (f->count + 1) * sizeof *lists->hops); /* literal: every byte of UINT32_MAX */
    lists->hops[f->count] = 0;
    lists->queue[tail++] = f->count;
    while (head < tail) {
        const uint32_t from = lists->queue[head++];
        for (uint32_t i = lists->first[from]; i < lists->first[from + 1]; i++) {
            const uint32_t to = lists->neighbours[i];
            if (to == without || lists->hops[to] != UINT32_MAX) continue;
            lists->hops[to] = lists->hops[from] + 1;
            lists->queue[tail++] = to;
        }
    }
}

static dm_result find_ways_out(dmi_arena* arena, const dmi_carrier_facts* f) {
    contact_lists lists;
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    const dm_result result = list_contacts(arena, f, &lists);
    if (result == DM_OK) {
        count_hops(f, &lists, UINT32_MAX);
        for (uint32_t b = 0; b <= f->count; b++) f->bodies[b].hops = lists.hops[b];
        for (uint32_t without = 0; without < f->count; without++) {
            count_hops(f, &lists, without);
            for (uint32_t b = 0; b < f->count; b++)
                f->cut[at(f, without, b)] =
                    b != without && lists.hops[b] == UINT32_MAX && f->bodies[b].hops != UINT32_MAX;
        }
    }
    dmi_arena_rewind(arena, mark);
    return result;
}

/* ---- the facts ---- */

static dm_result read_tree(dmi_arena* arena, const dmi_carrier_facts* f) {
    if (!f->labels->has_tree) return DM_OK;
    uint32_t nodes = 0;
    for (uint32_t u = 0; u < f->labels->unit_count; u++)
        for (uint32_t n = f->labels->unit_node[u]; n != DMI_ASSET_BODY; n = f->labels->nodes[n].parent)
            nodes = n >= nodes ? n + 1 : nodes;
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    uint32_t* unit_of_node = dmi_arena_push(arena, (nodes + 1) * sizeof *unit_of_node);
    if (unit_of_node == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(unit_of_node, 0xff, nodes * sizeof *unit_of_node); /* literal: every byte of UINT32_MAX */
    for (uint32_t u = 0; u < f->labels->unit_count; u++) unit_of_node[f->labels->unit_node[u]] = u;
    for (uint32_t u = 0; u < f->labels->unit_count; u++) add_above(f, u, unit_of_node);
    dmi_arena_rewind(arena, mark);
    return DM_OK;
}

dm_result dmi_carrier_facts_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_node_labels* labels,
                                 const uint32_t* body_of_unit, const float* moves, uint32_t count,
                                 dmi_carrier_facts* out) {
    *out = (dmi_carrier_facts){.grid = grid, .labels = labels, .body_of_unit = body_of_unit, .count = count};
    const size_t row = (size_t)count + 1, pairs = row * row;
    out->bodies = dmi_arena_push(arena, row * sizeof *out->bodies);
    out->touched = dmi_arena_push(arena, pairs * sizeof *out->touched);
    out->above = dmi_arena_push(arena, pairs * sizeof *out->above);
    out->cut = dmi_arena_push(arena, pairs);
    out->alike = dmi_arena_push(arena, pairs);
    if (out->bodies == NULL || out->touched == NULL || out->above == NULL || out->cut == NULL || out->alike == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    memset(out->touched, 0, pairs * sizeof *out->touched);
    memset(out->above, 0, pairs * sizeof *out->above);
    memset(out->cut, 0, pairs);
    memset(out->alike, 0, pairs);
    measure_bodies(out, moves);
    compare_bodies(out);
    const dm_result result = read_tree(arena, out);
    return result == DM_OK ? find_ways_out(arena, out) : result;
}

/* ---- a body and a candidate ---- */

/* Distance of two boxes along the axis on which they are farthest apart; 0 and less: they overlap. */
static float gap_between(const dmi_carried_body* a, const dmi_carried_body* b) {
    float gap = -INFINITY;
    for (int k = 0; k < 3; k++) gap = dmi_fmaxf(gap, dmi_fmaxf(a->low[k] - b->high[k], b->low[k] - a->high[k]));
    return gap;
}

bool dmi_carrier_is_candidate(const dmi_carrier_facts* f, uint32_t body, uint32_t carrier) {
    if (body == carrier) return false;
    if (carrier == f->count || touch(f, body, carrier) || f->above[at(f, body, carrier)] > 0) return true;
    return gap_between(&f->bodies[body], &f->bodies[carrier]) < NEAR_CELLS * f->grid->cell;
}

static float share(uint32_t part, uint32_t whole) {
    return (float)part / ((float)whole + TINY);
}

/* The most cells at which the body touches one other than the carrier and what stays. */
static uint32_t most_of_others(const dmi_carrier_facts* f, uint32_t body, uint32_t carrier) {
    uint32_t most = 0;
    for (uint32_t k = 0; k < f->count; k++)
        if (k != carrier && f->touched[at(f, body, k)] > most) most = f->touched[at(f, body, k)];
    return most;
}

static void put_contacts(dmi_row* r, const dmi_carrier_facts* f, uint32_t b, uint32_t c) {
    const uint32_t own = f->touched[at(f, b, c)], back = f->touched[at(f, c, b)];
    const uint32_t stays = f->touched[at(f, b, f->count)], held = c < f->count ? f->touched[at(f, c, f->count)] : 0;
    const uint32_t sum = f->bodies[b].touching, sum_c = f->bodies[c].touching, others = most_of_others(f, b, c);
    dmi_put(r, share(own, f->bodies[b].cells)), dmi_put(r, share(own, sum));
    dmi_put(r, share(stays, f->bodies[b].cells)), dmi_put(r, share(stays, sum));
    dmi_put(r, share(own, own + stays)), dmi_put(r, share(own, own + others));
    dmi_put(r, share(others, f->bodies[b].cells));
    dmi_put(r, share(back, f->bodies[c].cells)), dmi_put(r, share(back, sum_c));
    dmi_put(r, share(held, f->bodies[c].cells)), dmi_put(r, share(held, sum_c));
    dmi_put(r, share(own, own + back));
    dmi_put(r, (float)f->bodies[b].neighbours), dmi_put(r, (float)f->bodies[c].neighbours);
    dmi_put(r, dmi_fminf(MOST_HOPS, (float)f->bodies[b].hops));
    dmi_put(r, dmi_fminf(MOST_HOPS, (float)f->bodies[c].hops));
    dmi_put(r, dmi_fminf(MOST_HOPS, (float)f->bodies[b].hops) - dmi_fminf(MOST_HOPS, (float)f->bodies[c].hops));
    dmi_put(r, share(f->bodies[c].neighbours, f->count));
    dmi_put(r, f->cut[at(f, c, b)]), dmi_put(r, f->cut[at(f, b, c)]);
}

/* The shares of a's sides that lie beside b's, the least first. */
static void put_overlaps(dmi_row* r, const dmi_carried_body* a, const dmi_carried_body* b) {
    float overlap[3];
    for (int k = 0; k < 3; k++) {
        const float both = dmi_fminf(a->high[k], b->high[k]) - dmi_fmaxf(a->low[k], b->low[k]);
        const float value = dmi_fmaxf(-1, both / (a->high[k] - a->low[k] + TINY));
        int i = k;
        for (; i > 0 && overlap[i - 1] > value; i--) overlap[i] = overlap[i - 1];
        overlap[i] = value;
    }
    for (int k = 0; k < 3; k++) dmi_put(r, overlap[k]);
}

static float ratio(float a, float b) {
    return a / (a + b + TINY);
}

static void put_boxes(dmi_row* r, const dmi_carrier_facts* f, uint32_t b, uint32_t c) {
    const dmi_carried_body *body = &f->bodies[b], *other = &f->bodies[c], *stays = &f->bodies[f->count];
    const float all = (float)f->grid->first[f->grid->node_count];
    float sides[3], sides_c[3];
    dmi_put(r, ratio((float)body->cells, (float)other->cells)), dmi_put(r, ratio(body->area, other->area));
    dmi_put(r, (float)body->cells / all), dmi_put(r, (float)other->cells / all), dmi_put(r, (float)stays->cells / all);
    dmi_sorted_extents(body->low, body->high, sides);
    dmi_sorted_extents(other->low, other->high, sides_c);
    for (int k = 0; k < 3; k++) dmi_put(r, ratio(sides[k], sides_c[k]));
    put_overlaps(r, body, other), put_overlaps(r, other, body);
    dmi_put(r, dmi_fmaxf(-1, gap_between(body, other)));
}

static void put_kinship(dmi_row* r, const dmi_carrier_facts* f, uint32_t b, uint32_t c) {
    uint32_t twins = 0;
    for (uint32_t k = 0; k < f->count; k++) twins += k != c && f->alike[at(f, b, k)] && touch(f, k, c);
    dmi_put(r, f->alike[at(f, b, c)]);
    dmi_put(r, (float)f->bodies[b].twins), dmi_put(r, (float)f->bodies[c].twins),
        dmi_put(r, share(twins, f->bodies[b].twins));
    dmi_put(r, f->bodies[b].moves), dmi_put(r, f->bodies[c].moves);
    dmi_put(r, (float)f->count), dmi_put(r, c == f->count);
}

static void put_labels(dmi_row* r, const dmi_carrier_facts* f, uint32_t b, uint32_t c) {
    const dmi_carried_body *body = &f->bodies[b], *other = &f->bodies[c];
    const uint32_t pair[2] = {body->largest, other->largest};
    uint32_t named = 0;
    for (uint32_t k = 0; k <= f->count; k++) named += f->above[at(f, b, k)];
    dmi_put(r, body->grip), dmi_put(r, other->grip);
    dmi_put(r, body->part), dmi_put(r, other->part);
    dmi_put(r, share(f->above[at(f, b, c)], body->cells)), dmi_put(r, share(named, body->cells));
    dmi_put(r, share(f->above[at(f, c, b)], other->cells));
    dmi_put(r, (float)f->labels->has_tree);
    dmi_put(r, (float)dmi_units_of_group(f->labels, pair, other->cells > 0 ? 2 : 1) / (float)f->labels->unit_count);
    dmi_put(r, f->labels->stem[pair[0]] == f->labels->stem[pair[1]]);
}

void dmi_carrier_features_make(const dmi_carrier_facts* f, uint32_t body, uint32_t carrier,
                               float out[DMI_CARRIER_FEATURES]) {
    dmi_row r = {out, 0};
    put_contacts(&r, f, body, carrier);
    put_boxes(&r, f, body, carrier);
    put_kinship(&r, f, body, carrier);
    put_labels(&r, f, body, carrier);
    assert(r.count == DMI_CARRIER_FEATURES);
}
