/* Measures what a set of nodes hangs on, covers and hides. */
#include "assets/set_features.h"

#include <math.h>

#include "math/elementary.h"
#include "math/linear3.h"

/* All set by hand. */
#define LITTLE 0.25f      /* rad */
#define MUCH 0.9f         /* rad */
#define MOST_GAP 0.03f    /* object sizes; what is farther apart counts as this */
#define LEAST_GAP 0.0002f /* object sizes; rounding of coordinates stays below */
#define FEWEST 3          /* points that touch the rest, of which a line is taken */
#define TINY 1e-6f        /* lengths and counts that are divided by are at least this */

/* ---- the line along which the set touches the rest ---- */

/* Returns the share of the points that a turn takes into nodes outside, as dmi_node_set_collide. */
static float turn_about(const dmi_node_set* s, const float axis[3], const float at[3], float angle) {
    const float cosine = dmi_cosf(angle), sine = dmi_sinf(angle);
    uint32_t hits = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        float moved[3];
        if (s->touches[p] == 2) continue;
        dmi_turn3(axis, at, cosine, sine, s->points[p], moved);
        hits += dmi_node_set_meets(s, moved);
    }
    return s->point_count > 0 ? (float)hits / (float)s->point_count : 0;
}

/* Lists the points that touch the rest. Returns how many there are. */
static uint32_t list_touching(const dmi_node_set* s, float out[DMI_SET_POINTS][3]) {
    uint32_t count = 0;
    for (uint32_t p = 0; p < s->point_count; p++)
        if (s->touches[p] > 0) dmi_copy3(s->points[p], out[count++]);
    return count;
}

/* How line-like the contacts are, what a turn about that line runs into, and where the set is from it. */
static void put_hang(dmi_row* r, const dmi_node_set* s) {
    float touching[DMI_SET_POINTS][3], middle[3], directions[3][3], centre[3], across[3];
    double spread[3];
    const uint32_t count = list_touching(s, touching);
    if (count < FEWEST) {
        for (int i = DMI_OPENING_HANG; i < DMI_OPENING_WAYS; i++) dmi_put(r, 1);
        return;
    }
    dmi_principal3((const float(*)[3])touching, count, middle, spread, directions);
    const float* axis = directions[0];
    const float little[2] = {turn_about(s, axis, middle, LITTLE), turn_about(s, axis, middle, -LITTLE)};
    const float much[2] = {turn_about(s, axis, middle, MUCH), turn_about(s, axis, middle, -MUCH)};
    const int sense = little[1] + much[1] < little[0] + much[0];
    float longest = TINY;
    for (int k = 0; k < 3; k++) {
        centre[k] = 0.5f * (s->low[k] + s->high[k]);
        longest = dmi_fmaxf(longest, s->high[k] - s->low[k]);
    }
    dmi_sub3(centre, middle, across);
    dmi_madd3(across, -dmi_dot3(across, axis), axis, across);
    dmi_put(r, (float)sqrt(dmi_fmax(0, spread[1]) / (spread[0] + (double)TINY * (double)TINY)));
    dmi_put(r, (float)sqrt(dmi_fmax(0, spread[0])) / longest);
    dmi_put(r, little[sense]), dmi_put(r, much[sense]), dmi_put(r, little[!sense]), dmi_put(r, much[!sense]);
    dmi_put(r, dmi_length3(across) / longest);
}

/* ---- room ahead of it and behind it ---- */

/* Returns how many cells a point goes until it meets a node outside; -1: it leaves the grid. */
static int march(const dmi_node_set* s, const float point[3], int side) {
    const dmi_node_cells* g = s->grid;
    float at[3] = {point[0], point[1], point[2]};
    const int axis = side / 2;
    const float step = (side % 2 ? 1.0f : -1.0f) * g->cell, high = g->low[axis] + g->cell * (float)g->size[axis];
    for (int cells = 0;; cells++) {
        at[axis] += step;
        if (at[axis] < g->low[axis] || at[axis] >= high) return -1;
        if (dmi_node_set_meets(s, at)) return cells;
    }
}

/* The share of points that leave the object, and how far the others go. */
static void put_room(dmi_row* r, const dmi_node_set* s, int side) {
    float sum = 0;
    uint32_t hits = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        const int cells = march(s, s->points[p], side);
        if (cells >= 0) sum += (float)cells, hits++;
    }
    dmi_put(r, 1 - (float)hits / dmi_fmaxf(1, (float)s->point_count));
    dmi_put(r, hits > 0 ? sum / (float)hits * s->grid->cell : 1);
}

/* The share of the object's outline that the set covers from a side, and how far its face is behind the object's. */
static void put_cover(dmi_row* r, const dmi_node_set* s, const dmi_asset_facts* facts, int side) {
    const int axis = side / 2, b = (axis + 1) % 3, c = (axis + 2) % 3;
    const float own = (s->high[b] - s->low[b]) * (s->high[c] - s->low[c]);
    const float all = (facts->high[b] - facts->low[b]) * (facts->high[c] - facts->low[c]);
    dmi_put(r, own / (all + TINY));
    dmi_put(r, side % 2 ? facts->high[axis] - s->high[axis] : s->low[axis] - facts->low[axis]);
}

/* ---- where the contacts are on the set ---- */

/* Contacts along the way and across it, in half extents of the set: 1 is its rim, and its front. */
static void put_rim(dmi_row* r, const dmi_node_set* s, int side) {
    const int axis = side / 2;
    float across = 0, along = 0;
    uint32_t count = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        if (s->touches[p] == 0) continue;
        float outermost = 0;
        for (int k = 0; k < 3; k++) {
            const float half = 0.5f * (s->high[k] - s->low[k]) + s->grid->cell;
            const float at = (s->points[p][k] - 0.5f * (s->low[k] + s->high[k])) / half;
            if (k == axis) along += side % 2 ? at : -at;
            if (k != axis) outermost = dmi_fmaxf(outermost, fabsf(at));
        }
        across += outermost;
        count++;
    }
    dmi_put(r, count > 0 ? across / (float)count : 0), dmi_put(r, count > 0 ? along / (float)count : 0);
}

/* ---- the largest node of the set and what is fixed to it ---- */

static uint32_t largest_of(const dmi_node_cells* g, const uint32_t* nodes, uint32_t count) {
    uint32_t best = nodes[0];
    for (uint32_t i = 1; i < count; i++)
        if (dmi_cells_of(g, nodes[i]) > dmi_cells_of(g, best)) best = nodes[i];
    return best;
}

/* The share of the largest node; what stands out of its thin side; how far from its middle the others are, in half
 * extents. */
static void put_grip(dmi_row* r, const dmi_node_set* s, const uint32_t* nodes) {
    const dmi_node_cells* g = s->grid;
    const uint32_t base = largest_of(g, nodes, s->node_count);
    const float *low = g->low_of[base], *high = g->high_of[base];
    int thin = 0;
    for (int k = 1; k < 3; k++)
        if (high[k] - low[k] < high[thin] - low[thin]) thin = k;
    float off = 0, most = 0;
    for (uint32_t i = 0; i < s->node_count; i++) {
        float outermost = 0;
        for (int k = 0; k < 3; k++) {
            const float d = 0.5f * (g->low_of[nodes[i]][k] + g->high_of[nodes[i]][k] - low[k] - high[k]);
            if (k != thin) outermost = dmi_fmaxf(outermost, fabsf(d) / (0.5f * (high[k] - low[k]) + g->cell));
        }
        off += outermost;
        most = dmi_fmaxf(most, outermost);
    }
    const float above = s->high[thin] - high[thin], below = low[thin] - s->low[thin];
    dmi_put(r, dmi_cells_of(g, base) / ((float)s->cell_count + TINY));
    dmi_put(r, dmi_fmaxf(above, below)), dmi_put(r, dmi_fminf(above, below));
    dmi_put(r, s->node_count > 1 ? off / (float)(s->node_count - 1) : 0), dmi_put(r, most);
}

/* How many nodes outside touch this set and nothing else, and their cells by the set's. */
static void put_dependants(dmi_row* r, const dmi_node_set* s) {
    const dmi_node_cells* g = s->grid;
    uint32_t count = 0;
    float cells = 0;
    for (uint32_t n = 0; n < g->node_count; n++) {
        if (s->member[n]) continue;
        bool touches_set = false, touches_rest = false;
        for (uint32_t other = 0; other < g->node_count; other++) {
            if (other == n || g->contacts[(size_t)n * g->node_count + other] == 0) continue;
            touches_set |= s->member[other] != 0;
            touches_rest |= s->member[other] == 0;
        }
        if (!touches_set || touches_rest) continue;
        count++;
        cells += dmi_cells_of(g, n);
    }
    dmi_put(r, (float)count), dmi_put(r, cells / ((float)s->cell_count + TINY));
}

/* Returns how far apart two boxes are along the axis on which they are farthest; negative: how deep they overlap. */
static float box_gap(const dmi_node_cells* g, uint32_t a, uint32_t b) {
    float gap = -INFINITY;
    for (int k = 0; k < 3; k++)
        gap = dmi_fmaxf(gap, dmi_fmaxf(g->low_of[b][k] - g->high_of[a][k], g->low_of[a][k] - g->high_of[b][k]));
    return dmi_fminf(MOST_GAP, dmi_fmaxf(-MOST_GAP, gap));
}

/* Clearances to the nodes that it touches: mean by contact, least, and the share of the contact that has any. Boards
 * that are joined meet or overlap; what moves has room. */
static void put_clearance(dmi_row* r, const dmi_node_set* s) {
    const dmi_node_cells* g = s->grid;
    float sum = 0, weight = 0, least = MOST_GAP, apart = 0;
    for (uint32_t n = 0; n < g->node_count; n++) {
        if (!s->member[n]) continue;
        for (uint32_t other = 0; other < g->node_count; other++) {
            const float contact = (float)g->contacts[(size_t)n * g->node_count + other];
            if (s->member[other] || contact == 0) continue;
            const float gap = box_gap(g, n, other);
            sum += contact * gap, weight += contact;
            apart += gap > LEAST_GAP ? contact : 0;
            least = dmi_fminf(least, gap);
        }
    }
    dmi_put(r, sum / (weight + TINY)), dmi_put(r, least), dmi_put(r, apart / (weight + TINY));
}

void dmi_put_openings(dmi_row* row, const dmi_node_set* set, const dmi_asset_facts* facts,
                      const dmi_set_way ways[DMI_GRID_SIDES], const uint32_t* nodes) {
    put_hang(row, set);
    for (int i = 0; i < 2; i++) {
        put_room(row, set, ways[i].side), put_room(row, set, ways[i].side ^ 1);
        put_cover(row, set, facts, ways[i].side);
        put_rim(row, set, ways[i].side);
    }
    put_grip(row, set, nodes);
    put_dependants(row, set);
    put_clearance(row, set);
    float thin = 1, wide = 0;
    for (int k = 0; k < 3; k++) {
        thin = dmi_fminf(thin, set->high[k] - set->low[k]), wide = dmi_fmaxf(wide, set->high[k] - set->low[k]);
    }
    const int axis = ways[0].side / 2;
    dmi_put(row, (set->high[axis] - set->low[axis] - thin) / (wide + TINY));
    for (int i = 0; i < 2; i++) {
        const int way = ways[i].side / 2;
        const float middle = 0.5f * (set->low[way] + set->high[way] - facts->low[way] - facts->high[way]);
        dmi_put(row, (ways[i].side % 2 ? middle : -middle) / (facts->high[way] - facts->low[way] + TINY));
    }
}
