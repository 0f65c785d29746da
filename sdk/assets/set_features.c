/* Measures an asset as a whole, and sets of its nodes. */
#include "assets/set_features.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "assets/set_motions.h"
#include "math/elementary.h"

#define TINY 1e-6f              /* lengths and counts that are divided by are at least this */
#define TINY_AREA 1e-9f         /* and areas */
#define MOST_AREA 4             /* largest area of a set, in areas of its box; more counts as this; by hand */
#define ALIKE 0.02f             /* relative difference of extents and areas of twins; by hand */
#define LEAST_DIFFERENCE 0.001f /* least difference of extents that counts, in object sizes; by hand */

/* ---- facts ---- */

/* Sorts three numbers, largest first. */
static void sort3(float v[3]) {
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < 2; k++)
            if (v[k] < v[k + 1]) {
                const float t = v[k];
                v[k] = v[k + 1], v[k + 1] = t;
            }
}

void dmi_sorted_extents(const float low[3], const float high[3], float out[3]) {
    for (int k = 0; k < 3; k++) out[k] = high[k] - low[k];
    sort3(out);
}

static bool is_close(float a, float b) {
    return fabsf(a - b) <= ALIKE * dmi_fmaxf(fabsf(a), fabsf(b)) + LEAST_DIFFERENCE;
}

bool dmi_shapes_are_alike(const float low_a[3], const float high_a[3], float area_a, const float low_b[3],
                          const float high_b[3], float area_b) {
    float a[3], b[3];
    dmi_sorted_extents(low_a, high_a, a);
    dmi_sorted_extents(low_b, high_b, b);
    if (fabsf(area_a - area_b) > ALIKE * dmi_fmaxf(area_a, area_b)) return false;
    return is_close(a[0], b[0]) && is_close(a[1], b[1]) && is_close(a[2], b[2]);
}

dm_result dmi_asset_facts_make(dmi_arena* arena, const dmi_node_cells* g, const dmi_node_labels* labels,
                               dmi_asset_facts* out) {
    *out = (dmi_asset_facts){.node_count = g->node_count, .cell_count = g->first[g->node_count], .labels = labels};
    out->alike = dmi_arena_push(arena, (g->node_count + 1) * sizeof *out->alike);
    if (out->alike == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (int k = 0; k < 3; k++) out->low[k] = INFINITY, out->high[k] = -INFINITY;
    for (uint32_t n = 0; n < g->node_count; n++) {
        for (int k = 0; k < 3; k++) {
            out->low[k] = dmi_fminf(out->low[k], g->low_of[n][k]);
            out->high[k] = dmi_fmaxf(out->high[k], g->high_of[n][k]);
        }
        out->area += g->area[n];
        if (dmi_cells_of(g, n) > dmi_cells_of(g, out->largest)) out->largest = n;
        out->alike[n] = 0;
        for (uint32_t m = 0; m < g->node_count; m++)
            out->alike[n] += m != n && dmi_shapes_are_alike(g->low_of[n], g->high_of[n], g->area[n], g->low_of[m],
                                                            g->high_of[m], g->area[m]);
    }
    out->largest_share = out->cell_count > 0 ? dmi_cells_of(g, out->largest) / (float)out->cell_count : 0;
    return dmi_asset_facts_add_layers(arena, g, out);
}

/* ---- features ---- */

static void put_turn(dmi_row* r, const dmi_set_turn* t) {
    dmi_put(r, t->little), dmi_put(r, t->much), dmi_put(r, t->back), dmi_put(r, t->apart), dmi_put(r, t->along);
}

static void put_shape(dmi_row* r, const dmi_node_set* s, const dmi_asset_facts* facts) {
    float extent[3];
    dmi_sorted_extents(s->low, s->high, extent);
    for (int k = 0; k < 3; k++) dmi_put(r, extent[k]);
    dmi_put(r, extent[2] / (extent[0] + TINY));
    dmi_put(r, extent[1] / (extent[0] + TINY));
    dmi_put(r, (float)s->cell_count / (float)facts->cell_count);
    dmi_put(r, s->area / (facts->area + TINY_AREA));
    const float box = 2 * (extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]);
    dmi_put(r, dmi_fminf(MOST_AREA, s->area / (box + TINY_AREA)));
    uint32_t sides = 0;
    float thin_gap = 1, least = 2;
    for (int k = 0; k < 3; k++) {
        const float below = s->low[k] - facts->low[k], above = facts->high[k] - s->high[k];
        sides += (uint32_t)(below < 2 * s->grid->cell) + (uint32_t)(above < 2 * s->grid->cell);
        if (s->high[k] - s->low[k] < least) least = s->high[k] - s->low[k], thin_gap = dmi_fminf(below, above);
    }
    dmi_put(r, (float)sides);
    dmi_put(r, thin_gap);
}

static void put_contacts(dmi_row* r, const dmi_node_set* s) {
    const dmi_node_cells* g = s->grid;
    float sum = 0, most = 0;
    uint32_t neighbours = 0, touching = 0, shared = 0;
    for (uint32_t other = 0; other < g->node_count; other++) {
        if (s->member[other]) continue;
        float cells = 0;
        for (uint32_t n = 0; n < g->node_count; n++)
            if (s->member[n]) cells += (float)g->contacts[(size_t)n * g->node_count + other];
        neighbours += cells > 0;
        sum += cells;
        most = dmi_fmaxf(most, cells);
    }
    for (uint32_t p = 0; p < s->point_count; p++) touching += s->touches[p] > 0, shared += s->touches[p] == 2;
    dmi_put(r, (float)touching / dmi_fmaxf(1, (float)s->point_count));
    dmi_put(r, (float)shared / dmi_fmaxf(1, (float)s->point_count));
    dmi_put(r, (float)neighbours);
    dmi_put(r, (float)neighbours / dmi_fmaxf(1, (float)(g->node_count - s->node_count)));
    dmi_put(r, most / (sum + TINY));
}

/* Where the set touches the rest: extents of that region by those of the set, and how far its middle is from the
 * set's, in half extents; longest side of the set first. 1 and 0: it touches everywhere, or nowhere. */
static void put_touched_region(dmi_row* r, const dmi_node_set* s) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    uint32_t count = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        if (s->touches[p] == 0) continue;
        count++;
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_fminf(low[k], s->points[p][k]);
            high[k] = dmi_fmaxf(high[k], s->points[p][k]);
        }
    }
    int order[3] = {0, 1, 2};
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < 2; i++)
            if (s->high[order[i]] - s->low[order[i]] < s->high[order[i + 1]] - s->low[order[i + 1]]) {
                const int t = order[i];
                order[i] = order[i + 1], order[i + 1] = t;
            }
    for (int i = 0; i < 3; i++) {
        const int k = order[i];
        const float extent = s->high[k] - s->low[k] + s->grid->cell, middle = s->low[k] + s->high[k];
        dmi_put(r, count > 0 ? (high[k] - low[k]) / extent : 1);
        dmi_put(r, count > 0 ? fabsf(low[k] + high[k] - middle) / extent : 0);
    }
}

/* What the set holds together: the pieces into which the rest falls without it, and the largest one's share of the
 * rest's cells. stack: scratch of a number a node. */
static void put_rest(dmi_row* r, const dmi_node_set* s, uint32_t* stack, uint8_t* seen) {
    const dmi_node_cells* g = s->grid;
    float largest = 0, all = 0;
    uint32_t pieces = 0;
    memcpy(seen, s->member, g->node_count);
    for (uint32_t seed = 0; seed < g->node_count; seed++) {
        if (seen[seed]) continue;
        float cells = 0;
        uint32_t depth = 0;
        stack[depth++] = seed;
        seen[seed] = 1;
        while (depth > 0) {
            const uint32_t at = stack[--depth];
            const uint32_t* contacts = g->contacts + (size_t)at * g->node_count;
            cells += dmi_cells_of(g, at);
            for (uint32_t n = 0; n < g->node_count; n++)
                if (!seen[n] && contacts[n] > 0) seen[n] = 1, stack[depth++] = n;
        }
        pieces++;
        all += cells;
        largest = dmi_fmaxf(largest, cells);
    }
    dmi_put(r, (float)pieces), dmi_put(r, all > 0 ? largest / all : 0);
}

static void put_exposure(dmi_row* r, const dmi_node_set* s, float exposed[DMI_GRID_SIDES]) {
    const dmi_node_cells* g = s->grid;
    float sorted[DMI_GRID_SIDES];
    for (int side = 0; side < DMI_GRID_SIDES; side++) {
        float sum = 0;
        for (uint32_t n = 0; n < g->node_count; n++)
            if (s->member[n]) sum += g->exposed[n][side] * dmi_cells_of(g, n);
        sorted[side] = exposed[side] = sum / ((float)s->cell_count + TINY);
    }
    for (int i = 1; i < DMI_GRID_SIDES; i++)
        for (int j = i; j > 0 && sorted[j] > sorted[j - 1]; j--) {
            const float t = sorted[j];
            sorted[j] = sorted[j - 1], sorted[j - 1] = t;
        }
    for (int side = 0; side < DMI_GRID_SIDES; side++) dmi_put(r, sorted[side]);
}

static void put_ways(dmi_row* r, const dmi_set_way ways[DMI_GRID_SIDES], const dmi_node_set* s) {
    uint32_t free = 0;
    for (int i = 0; i < DMI_GRID_SIDES; i++) free += ways[i].near + ways[i].middle < DMI_FREE;
    dmi_put(r, (float)free);
    for (int i = 0; i < 3; i++)
        dmi_put(r, ways[i].near), dmi_put(r, ways[i].middle), dmi_put(r, ways[i].far), dmi_put(r, ways[i].exposed),
            dmi_put(r, ways[i].back);
    const int axis = ways[0].side / 2;
    dmi_put(r, s->high[axis] - s->low[axis]);
}

/* Names and tree: shares of the set's cells by what their names say, the strongest word, and whether a node of the file
 * is above just this set. */
static void put_set_labels(dmi_row* r, const dmi_node_set* s, const dmi_node_labels* labels, const uint32_t* nodes,
                           uint32_t count) {
    float share[DMI_NAME_CLASSES] = {0};
    uint32_t stems = 0, below = 0;
    for (uint32_t i = 0; i < count; i++) {
        share[labels->name[nodes[i]]] += dmi_cells_of(s->grid, nodes[i]) / ((float)s->cell_count + TINY);
        for (uint32_t k = 0; k < i; k++) stems += labels->stem[nodes[i]] == labels->stem[nodes[k]];
    }
    for (uint32_t n = 0; n < s->grid->node_count; n++)
        below += s->member[n] == 0 && dmi_unit_is_below(labels, n, nodes[0]);
    dmi_put(r, share[DMI_NAME_OBJECT]), dmi_put(r, share[DMI_NAME_PART]), dmi_put(r, share[DMI_NAME_GRIP]);
    dmi_put(r, labels->told);
    dmi_put(r, count > 1 ? 2 * (float)stems / ((float)count * (float)(count - 1)) : 1);
    dmi_put(r, (float)labels->has_tree);
    dmi_put(r, (float)dmi_units_of_group(labels, nodes, count) / (float)count);
    dmi_put(r, (float)below);
}

dm_result dmi_set_features_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_asset_facts* facts,
                                const uint32_t* nodes, uint32_t count, const dmi_set_links* links,
                                float out[DMI_SET_FEATURES]) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    dmi_node_set set;
    uint32_t* stack = dmi_arena_push(arena, (grid->node_count + 1) * sizeof *stack);
    uint8_t* seen = dmi_arena_push(arena, grid->node_count + 1);
    const dm_result result = stack == NULL || seen == NULL
                                 ? DM_ERROR_OUT_OF_MEMORY
                                 : dmi_node_set_make(arena, grid, nodes, count, UINT32_MAX, &set);
    memset(out, 0, DMI_SET_FEATURES * sizeof *out);
    if (result == DM_OK) {
        dmi_row r = {out, 0};
        float exposed[DMI_GRID_SIDES];
        dmi_set_way ways[DMI_GRID_SIDES];
        dmi_set_turn edges[2];
        uint32_t free_edges;
        put_shape(&r, &set, facts);
        put_contacts(&r, &set);
        put_exposure(&r, &set, exposed);
        dmi_measure_ways(&set, UINT32_MAX, exposed, ways);
        put_ways(&r, ways, &set);
        dmi_measure_edges(&set, edges, &free_edges);
        put_turn(&r, &edges[0]), put_turn(&r, &edges[1]), dmi_put(&r, (float)free_edges);
        const dmi_set_spin s = dmi_measure_spin(&set);
        dmi_put(&r, s.round), put_turn(&r, &s.turning);
        dmi_put(&r, links->weakest), dmi_put(&r, links->strongest_out), dmi_put(&r, links->mean_in),
            dmi_put(&r, links->mean_out);
        dmi_put(&r, (float)links->alike), dmi_put(&r, (float)count), dmi_put(&r, (float)facts->node_count);
        dmi_put(&r, facts->largest_share), dmi_put(&r, (float)set.member[facts->largest]);
        put_set_labels(&r, &set, facts->labels, nodes, count);
        put_touched_region(&r, &set);
        put_rest(&r, &set, stack, seen);
        dmi_put_openings(&r, &set, facts, ways, nodes);
        dmi_put_standing(&r, &set, facts, ways);
        assert(r.count == DMI_SET_FEATURES);
    }
    dmi_arena_rewind(arena, mark);
    return result;
}
