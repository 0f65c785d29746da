/* Measures pairs of nodes, and merges the nodes by agglomerative clustering: by the mean probability between clusters.
 */
#include "assets/merge_tree.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "assets/set_features.h"
#include "assets/set_motions.h"
#include "math/elementary.h"

/* ---- numbers by which a pair of nodes is told to be one body ---- */

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

/* Puts what two nodes' boxes tell: extents, what a adds to b, their gap, shares inside each other, thin sides. */
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

/* ---- tree ---- */

#define NEAREST 3         /* pairs without contact of each node; by hand */
#define MIDDLE_COST 0.05f /* weight of the distance of two boxes' middles beside that of the boxes; by hand */
#define MOST_BY_RULE 0.9f /* probability of a pair without models; by hand */
#define PAIRS_AT_ONCE 64  /* pairs from one report of progress to the next */

/* ---- pairs ---- */

/* Distance of two boxes; those that overlap are ranked by their middles. */
static float box_distance(const dmi_node_cells* g, uint32_t a, uint32_t b) {
    float gap = 0, middle = 0;
    for (int k = 0; k < 3; k++) {
        const float d = dmi_fmaxf(g->low_of[a][k], g->low_of[b][k]) - dmi_fminf(g->high_of[a][k], g->high_of[b][k]);
        const float m = 0.5f * (g->low_of[a][k] + g->high_of[a][k] - g->low_of[b][k] - g->high_of[b][k]);
        gap += d > 0 ? d * d : 0;
        middle += m * m;
    }
    return sqrtf(gap) + MIDDLE_COST * sqrtf(middle);
}

static bool touch(const dmi_node_cells* g, uint32_t a, uint32_t b) {
    return g->contacts[(size_t)a * g->node_count + b] > 0;
}

/* Finds the nodes that are nearest to `node` without touching it. Returns how many. */
static uint32_t find_nearest(const dmi_node_cells* g, uint32_t node, uint32_t out[NEAREST]) {
    float distance[NEAREST];
    uint32_t count = 0;
    for (uint32_t other = 0; other < g->node_count; other++) {
        if (other == node || touch(g, node, other)) continue;
        const float d = box_distance(g, node, other);
        uint32_t at = count < NEAREST ? count++ : NEAREST;
        while (at > 0 && d < distance[at - 1]) {
            if (at < NEAREST) distance[at] = distance[at - 1], out[at] = out[at - 1];
            at--;
        }
        if (at < NEAREST) distance[at] = d, out[at] = other;
    }
    return count;
}

dm_result dmi_node_pairs_list(dmi_arena* arena, const dmi_node_cells* g, dmi_node_pair** out_pairs,
                              uint32_t* out_count) {
    const uint32_t n = g->node_count;
    uint8_t* wanted = dmi_arena_push(arena, (size_t)n * n + 1);
    if (wanted == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(wanted, 0, (size_t)n * n);
    uint32_t count = 0;
    for (uint32_t a = 0; a < n; a++) {
        uint32_t nearest[NEAREST];
        const uint32_t near_count = find_nearest(g, a, nearest);
        for (uint32_t i = 0; i < near_count; i++)
            wanted[a < nearest[i] ? (size_t)a * n + nearest[i] : (size_t)nearest[i] * n + a] = 1;
        for (uint32_t b = a + 1; b < n; b++) wanted[(size_t)a * n + b] |= touch(g, a, b);
    }
    for (size_t i = 0; i < (size_t)n * n; i++) count += wanted[i];
    dmi_node_pair* pairs = dmi_arena_push(arena, (count + 1) * sizeof *pairs);
    if (pairs == NULL) return DM_ERROR_OUT_OF_MEMORY;
    *out_count = 0;
    for (uint32_t a = 0; a < n; a++)
        for (uint32_t b = a + 1; b < n; b++)
            if (wanted[(size_t)a * n + b]) {
                const float cells = 0.5f * (float)(g->contacts[(size_t)a * n + b] + g->contacts[(size_t)b * n + a]);
                pairs[(*out_count)++] = (dmi_node_pair){a, b, 0, 1 + sqrtf(cells)};
            }
    *out_pairs = pairs;
    return DM_OK;
}

static dm_result rate_pairs(dmi_arena* arena, dmi_merge_tree* tree, const dmi_asset_models* models,
                            const dmi_progress* progress) {
    const dmi_node_cells* g = tree->grid;
    for (uint32_t i = 0; i < tree->pair_count; i++) {
        dmi_node_pair* p = &tree->pairs[i];
        float features[DMI_PAIR_FEATURES];
        dm_result result = dmi_pair_features_make(arena, g, &tree->facts, p->a, p->b, features);
        if (result == DM_OK && i % PAIRS_AT_ONCE == 0)
            result = dmi_progress_tell(progress, (float)i / (float)tree->pair_count);
        if (result != DM_OK) return result;
        p->probability =
            models != NULL ? dmi_probability(&models->pairs, features) : dmi_fminf(MOST_BY_RULE, features[0]);
    }
    return DM_OK;
}

/* ---- merging ---- */

typedef struct merger {
    uint32_t n;          /* nodes */
    float *sum, *weight; /* n x n, by the slot of a cluster */
    uint32_t* set;       /* set of each slot; UINT32_MAX: merged into another */
    uint32_t* best;      /* slot that each slot is likeliest one with */
} merger;

static float link_of(const merger* m, uint32_t a, uint32_t b) {
    const size_t at = (size_t)a * m->n + b;
    return m->weight[at] > 0 ? m->sum[at] / m->weight[at] : -1;
}

static void find_best(merger* m, uint32_t slot) {
    m->best[slot] = UINT32_MAX;
    for (uint32_t b = 0; b < m->n; b++)
        if (b != slot && m->set[b] != UINT32_MAX && link_of(m, slot, b) >= 0 &&
            (m->best[slot] == UINT32_MAX || link_of(m, slot, b) > link_of(m, slot, m->best[slot])))
            m->best[slot] = b;
}

static dm_result open_merger(dmi_arena* arena, const dmi_merge_tree* tree, merger* m) {
    const size_t n = tree->grid->node_count;
    *m = (merger){.n = (uint32_t)n};
    m->sum = dmi_arena_push(arena, (n * n + 1) * sizeof *m->sum);
    m->weight = dmi_arena_push(arena, (n * n + 1) * sizeof *m->weight);
    m->set = dmi_arena_push(arena, (n + 1) * sizeof *m->set);
    m->best = dmi_arena_push(arena, (n + 1) * sizeof *m->best);
    if (m->sum == NULL || m->weight == NULL || m->set == NULL || m->best == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(m->sum, 0, n * n * sizeof *m->sum);
    memset(m->weight, 0, n * n * sizeof *m->weight);
    for (uint32_t i = 0; i < tree->pair_count; i++) {
        const dmi_node_pair* p = &tree->pairs[i];
        const size_t at = (size_t)p->a * n + p->b, mirrored = (size_t)p->b * n + p->a;
        m->sum[at] = m->sum[mirrored] = p->weight * p->probability;
        m->weight[at] = m->weight[mirrored] = p->weight;
    }
    for (uint32_t i = 0; i < n; i++) m->set[i] = i;
    for (uint32_t i = 0; i < n; i++) find_best(m, i);
    return DM_OK;
}

/* Merges slot b into slot a. */
static void merge_slots(merger* m, uint32_t a, uint32_t b) {
    m->set[b] = UINT32_MAX;
    for (uint32_t k = 0; k < m->n; k++) {
        if (k == a || m->set[k] == UINT32_MAX) continue;
        const size_t to = (size_t)a * m->n + k, from = (size_t)b * m->n + k;
        m->sum[to] += m->sum[from], m->weight[to] += m->weight[from];
        m->sum[(size_t)k * m->n + a] = m->sum[to], m->weight[(size_t)k * m->n + a] = m->weight[to];
    }
    find_best(m, a);
    for (uint32_t k = 0; k < m->n; k++) {
        if (k == a || m->set[k] == UINT32_MAX) continue;
        if (m->best[k] == a || m->best[k] == b || m->best[k] == UINT32_MAX)
            find_best(m, k);
        else if (link_of(m, k, a) > link_of(m, k, m->best[k]))
            m->best[k] = a;
    }
}

static uint32_t likeliest_slot(const merger* m) {
    uint32_t out = UINT32_MAX;
    for (uint32_t a = 0; a < m->n; a++) {
        if (m->set[a] == UINT32_MAX || m->best[a] == UINT32_MAX) continue;
        if (out == UINT32_MAX || link_of(m, a, m->best[a]) > link_of(m, out, m->best[out])) out = a;
    }
    return out;
}

static void list_members(dmi_merge_tree* tree, uint32_t set, uint32_t* used) {
    const uint32_t *x = tree->members + tree->first[tree->children[set][0]],
                   *y = tree->members + tree->first[tree->children[set][1]];
    const uint32_t *x_end = x + tree->size[tree->children[set][0]], *y_end = y + tree->size[tree->children[set][1]];
    tree->first[set] = *used;
    while (x < x_end || y < y_end) tree->members[(*used)++] = y == y_end || (x < x_end && *x < *y) ? *x++ : *y++;
    tree->size[set] = *used - tree->first[set];
}

/* Makes room for the sets; the members of a chain of n merges are n^2 / 2 numbers. */
static dm_result open_sets(dmi_arena* arena, dmi_merge_tree* tree) {
    const size_t n = tree->grid->node_count, sets = 2 * n + 1;
    tree->children = dmi_arena_push(arena, sets * sizeof *tree->children);
    tree->link = dmi_arena_push(arena, sets * sizeof *tree->link);
    tree->first = dmi_arena_push(arena, sets * sizeof *tree->first);
    tree->size = dmi_arena_push(arena, sets * sizeof *tree->size);
    tree->members = dmi_arena_push(arena, (n * (n + 3) / 2 + 1) * sizeof *tree->members);
    if (tree->children == NULL || tree->link == NULL || tree->first == NULL || tree->size == NULL ||
        tree->members == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < n; i++) {
        tree->children[i][0] = tree->children[i][1] = UINT32_MAX;
        tree->link[i] = 1;
        tree->first[i] = tree->members[i] = i;
        tree->size[i] = 1;
    }
    tree->set_count = (uint32_t)n;
    return DM_OK;
}

dm_result dmi_merge_tree_make(dmi_arena* arena, const dmi_node_cells* grid, const dmi_node_labels* labels,
                              const dmi_asset_models* models, const dmi_progress* progress, dmi_merge_tree* out) {
    *out = (dmi_merge_tree){.grid = grid};
    merger m;
    dm_result result = dmi_asset_facts_make(arena, grid, labels, &out->facts);
    if (result == DM_OK) result = dmi_node_pairs_list(arena, grid, &out->pairs, &out->pair_count);
    if (result == DM_OK) result = rate_pairs(arena, out, models, progress);
    if (result == DM_OK) result = open_sets(arena, out);
    if (result == DM_OK) result = open_merger(arena, out, &m);
    uint32_t used = grid->node_count;
    for (uint32_t a; result == DM_OK && (a = likeliest_slot(&m)) != UINT32_MAX;) {
        const uint32_t b = m.best[a], set = out->set_count++;
        out->children[set][0] = m.set[a], out->children[set][1] = m.set[b];
        out->link[set] = link_of(&m, a, b);
        list_members(out, set, &used);
        m.set[a] = set;
        merge_slots(&m, a, b);
    }
    return result;
}

/* ---- links ---- */

typedef struct extent {
    float low[3], high[3], area;
} extent;

static extent measure_set(const dmi_merge_tree* tree, uint32_t set) {
    const dmi_node_cells* g = tree->grid;
    extent e = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0};
    for (uint32_t i = 0; i < tree->size[set]; i++) {
        const uint32_t node = tree->members[tree->first[set] + i];
        e.area += g->area[node];
        for (int k = 0; k < 3; k++) {
            e.low[k] = dmi_fminf(e.low[k], g->low_of[node][k]);
            e.high[k] = dmi_fmaxf(e.high[k], g->high_of[node][k]);
        }
    }
    return e;
}

/* member: of the set's nodes, 1. */
static void link_pairs(const dmi_merge_tree* tree, const uint8_t* member, dmi_set_links* out) {
    float in = 0, in_weight = 0, outside = 0, out_weight = 0;
    for (uint32_t i = 0; i < tree->pair_count; i++) {
        const dmi_node_pair* p = &tree->pairs[i];
        if (member[p->a] && member[p->b]) in += p->weight * p->probability, in_weight += p->weight;
        if (member[p->a] == member[p->b]) continue;
        outside += p->weight * p->probability, out_weight += p->weight;
        out->strongest_out = dmi_fmaxf(out->strongest_out, p->probability);
    }
    out->mean_in = in_weight > 0 ? in / in_weight : 1;
    out->mean_out = out_weight > 0 ? outside / out_weight : 0;
}

static void link_twins(const extent* extents, uint32_t count, dmi_set_links* out) {
    for (uint32_t s = 0; s < count; s++) {
        out[s].twin = s;
        for (uint32_t t = count; t-- > 0;) {
            if (t == s || !dmi_shapes_are_alike(extents[s].low, extents[s].high, extents[s].area, extents[t].low,
                                                extents[t].high, extents[t].area))
                continue;
            out[s].alike++;
            if (t < out[s].twin) out[s].twin = t;
        }
    }
}

dm_result dmi_merge_tree_links(dmi_arena* arena, const dmi_merge_tree* tree, dmi_set_links* out) {
    const uint32_t nodes = tree->grid->node_count;
    uint8_t* member = dmi_arena_push(arena, nodes + 1);
    extent* extents = dmi_arena_push(arena, (tree->set_count + 1) * sizeof *extents);
    if (member == NULL || extents == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t s = 0; s < tree->set_count; s++) {
        memset(member, 0, nodes);
        for (uint32_t i = 0; i < tree->size[s]; i++) member[tree->members[tree->first[s] + i]] = 1;
        out[s] = (dmi_set_links){.weakest = tree->link[s]};
        for (int k = 0; k < 2 && tree->children[s][0] != UINT32_MAX; k++)
            out[s].weakest = dmi_fminf(out[s].weakest, out[tree->children[s][k]].weakest);
        link_pairs(tree, member, &out[s]);
        extents[s] = measure_set(tree, s);
    }
    link_twins(extents, tree->set_count, out);
    return DM_OK;
}
