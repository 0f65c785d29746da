/* Measures pairs of nodes. */
#include "assets/pair_features.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "assets/feature_row.h"
#include "assets/set_motions.h"
#include "math/elementary.h"

#define TINY 1e-6f       /* lengths and counts that are divided by are at least this */
#define TINY_AREA 1e-12f /* and areas */
#define UNTOUCHED 0.03f  /* collisions below which one node leaves the other that way; by hand */

/* Returns the share of box a's volume inside box b, both grown by a cell. */
static float box_inside(const dmi_node_cells* g, uint32_t a, uint32_t b) {
    float share = 1;
    for (int k = 0; k < 3; k++) {
        const float low = dmi_fmaxf(g->low_of[a][k], g->low_of[b][k]) - g->cell;
        const float high = dmi_fminf(g->high_of[a][k], g->high_of[b][k]) + g->cell;
        share *= dmi_fmaxf(0, high - low) / (g->high_of[a][k] - g->low_of[a][k] + 2 * g->cell);
    }
    return share;
}

/* Counts the vertices of node a at the place of a vertex of node b. */
static void put_boxes(dmi_row* r, const dmi_node_cells* g, uint32_t a, uint32_t b) {
    float extent_a[3], extent_b[3], both[3], low[3], high[3], gap = 0;
    dmi_sorted_extents(g->low_of[a], g->high_of[a], extent_a);
    dmi_sorted_extents(g->low_of[b], g->high_of[b], extent_b);
    int thin_a = 0, thin_b = 0;
    for (int k = 0; k < 3; k++) {
        low[k] = dmi_fminf(g->low_of[a][k], g->low_of[b][k]);
        high[k] = dmi_fmaxf(g->high_of[a][k], g->high_of[b][k]);
        const float d = dmi_fmaxf(g->low_of[a][k], g->low_of[b][k]) - dmi_fminf(g->high_of[a][k], g->high_of[b][k]);
        gap += d > 0 ? d * d : 0;
        if (g->high_of[a][k] - g->low_of[a][k] < g->high_of[a][thin_a] - g->low_of[a][thin_a]) thin_a = k;
        if (g->high_of[b][k] - g->low_of[b][k] < g->high_of[b][thin_b] - g->low_of[b][thin_b]) thin_b = k;
    }
    dmi_sorted_extents(low, high, both);
    for (int k = 0; k < 3; k++) dmi_put(r, extent_a[k]);
    for (int k = 0; k < 3; k++) dmi_put(r, extent_b[k]);
    for (int k = 0; k < 3; k++) dmi_put(r, both[k] - extent_b[k]);
    dmi_put(r, sqrtf(gap));
    dmi_put(r, box_inside(g, a, b)), dmi_put(r, box_inside(g, b, a));
    dmi_put(r, (float)(thin_a == thin_b));
    const float middle_a = 0.5f * (g->low_of[a][thin_b] + g->high_of[a][thin_b]);
    const float middle_b = 0.5f * (g->low_of[b][thin_b] + g->high_of[b][thin_b]);
    dmi_put(r, fabsf(middle_a - middle_b));
    float across = 0;
    for (int k = 0; k < 3; k++) {
        const float d = 0.5f * (g->low_of[a][k] + g->high_of[a][k] - g->low_of[b][k] - g->high_of[b][k]);
        if (k != thin_b) across += d * d;
    }
    dmi_put(r, sqrtf(across));
}

static void put_pair_contacts(dmi_row* r, const dmi_node_cells* g, uint32_t a, uint32_t b) {
    const uint32_t n = g->node_count, nodes[2] = {a, b};
    for (int i = 0; i < 2; i++) {
        const uint32_t one = nodes[i], other = nodes[1 - i];
        const uint32_t* contacts = g->contacts + (size_t)one * n;
        float sum = 0;
        uint32_t neighbours = 0, stronger = 0;
        for (uint32_t k = 0; k < n; k++) {
            if (k == one || contacts[k] == 0) continue;
            sum += (float)contacts[k];
            neighbours++;
            stronger += k != other && contacts[k] > contacts[other];
        }
        dmi_put(r, (float)contacts[other] / dmi_fmaxf(1, dmi_cells_of(g, one)));
        dmi_put(r, (float)contacts[other] / (sum + TINY));
        dmi_put(r, (float)neighbours), dmi_put(r, (float)stronger);
    }
}

static void put_pair_labels(dmi_row* r, const dmi_node_labels* labels, uint32_t a, uint32_t b) {
    const uint32_t pair[2] = {a, b};
    dmi_put(r, (float)labels->name[a]), dmi_put(r, (float)labels->name[b]);
    dmi_put(r, (float)(labels->stem[a] == labels->stem[b]));
    dmi_put(r, (float)(labels->name[a] != DMI_NAME_SILENT && labels->kind[a] == labels->kind[b]));
    dmi_put(r, labels->told);
    dmi_put(r, (float)labels->has_tree);
    dmi_put(r, (float)dmi_units_of_group(labels, pair, 2) / (float)labels->unit_count);
    dmi_put(r, (float)dmi_units_of_group(labels, pair, 2));
    dmi_put(r, (float)dmi_unit_is_below(labels, a, b) - (float)dmi_unit_is_below(labels, b, a));
}

dm_result dmi_pair_features_make(dmi_arena* arena, const dmi_node_cells* g, const dmi_asset_facts* facts, uint32_t a,
                                 uint32_t b, float out[DMI_PAIR_FEATURES]) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    if (dmi_cells_of(g, a) > dmi_cells_of(g, b) ||
        (dmi_cells_of(g, a) == dmi_cells_of(g, b) && g->area[a] > g->area[b])) {
        const uint32_t t = a;
        a = b, b = t;
    }
    dmi_node_set set;
    const dm_result result = dmi_node_set_make(arena, g, &a, 1, b, &set);
    memset(out, 0, DMI_PAIR_FEATURES * sizeof *out);
    if (result == DM_OK) {
        dmi_row r = {out, 0};
        put_pair_contacts(&r, g, a, b);
        put_boxes(&r, g, a, b);
        dmi_put(&r, dmi_cells_of(g, a) / (float)facts->cell_count),
            dmi_put(&r, dmi_cells_of(g, b) / (float)facts->cell_count);
        dmi_put(&r, g->area[a] / (g->area[b] + TINY_AREA));
        dmi_put(&r, (float)facts->alike[a]), dmi_put(&r, (float)facts->alike[b]);
        dmi_put(&r, (float)dmi_shapes_are_alike(g->low_of[a], g->high_of[a], g->area[a], g->low_of[b], g->high_of[b],
                                                g->area[b]));
        dmi_put(&r, (float)(b == facts->largest)), dmi_put(&r, (float)facts->node_count),
            dmi_put(&r, facts->largest_share);
        dmi_set_way ways[DMI_GRID_SIDES];
        dmi_measure_ways(&set, b, g->exposed[a], ways);
        uint32_t free = 0;
        for (int i = 0; i < DMI_GRID_SIDES; i++) free += ways[i].near < UNTOUCHED;
        dmi_put(&r, (float)free);
        dmi_put(&r, ways[0].near + ways[0].middle), dmi_put(&r, ways[1].near + ways[1].middle),
            dmi_put(&r, ways[0].back);
        dmi_put(&r, ways[2].near + ways[2].middle), dmi_put(&r, ways[DMI_GRID_SIDES - 1].near);
        float difference = 0, least_a = 0, least_b = 0;
        for (int side = 0; side < DMI_GRID_SIDES; side++) {
            difference = dmi_fmaxf(difference, fabsf(g->exposed[a][side] - g->exposed[b][side]));
            least_a = dmi_fmaxf(least_a, g->exposed[a][side]), least_b = dmi_fmaxf(least_b, g->exposed[b][side]);
        }
        dmi_put(&r, difference), dmi_put(&r, least_a), dmi_put(&r, least_b);
        put_pair_labels(&r, facts->labels, a, b);
        assert(r.count == DMI_PAIR_FEATURES);
    }
    dmi_arena_rewind(arena, mark);
    return result;
}
