/* Collects sets of nodes, and moves them along and about the axes of the grid. */
#include "assets/set_motions.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

/* ---- sets of nodes as one rigid body each ---- */

static bool is_outside(const dmi_node_set* set, uint32_t against, uint32_t node) {
    return against == UINT32_MAX ? !set->member[node] : node == against;
}

/* Returns whether a cell belongs to a node outside. */
static bool is_taken(const dmi_node_set* set, uint32_t against, uint32_t cell) {
    const dmi_node_cells* g = set->grid;
    for (uint32_t i = g->start[cell]; i < g->start[cell + 1]; i++)
        if (is_outside(set, against, g->owners[i])) return true;
    return false;
}

/* Returns the index of the cell at or beside `cell` for which `test` holds; only cells inside the empty layer are
 * asked. */
static bool is_near(const dmi_node_set* set, uint32_t against, uint32_t cell, bool own) {
    const dmi_node_cells* g = set->grid;
    const int32_t across = g->size[0], slab = g->size[0] * g->size[1], most = slab * g->size[2];
    for (int32_t z = -1; z <= 1; z++)
        for (int32_t y = -1; y <= 1; y++) {
            const int32_t middle = (int32_t)cell + z * slab + y * across;
            if (middle < 1 || middle + 2 > most) continue;
            for (uint32_t i = g->start[middle - 1]; i < g->start[middle + 2]; i++)
                if (own ? set->member[g->owners[i]] : is_outside(set, against, g->owners[i])) return true;
        }
    return false;
}

static void pick_points(dmi_node_set* set, const uint32_t* nodes, uint32_t count) {
    const dmi_node_cells* g = set->grid;
    const uint32_t wanted = set->cell_count < DMI_SET_POINTS ? set->cell_count : DMI_SET_POINTS;
    uint32_t passed = 0;
    for (uint32_t n = 0; n < count; n++)
        for (uint32_t i = g->first[nodes[n]]; i < g->first[nodes[n] + 1]; i++, passed++)
            if ((uint64_t)set->point_count * set->cell_count <= (uint64_t)passed * wanted && set->point_count < wanted)
                dmi_cell_centre(g, g->cells[i], set->points[set->point_count++]);
}

dm_result dmi_node_set_make(dmi_arena* arena, const dmi_node_cells* grid, const uint32_t* nodes, uint32_t count,
                            uint32_t against, dmi_node_set* out) {
    *out = (dmi_node_set){.grid = grid, .node_count = count};
    out->member = dmi_arena_push(arena, grid->node_count + 1);
    out->points = dmi_arena_push(arena, DMI_SET_POINTS * sizeof *out->points);
    out->touches = dmi_arena_push(arena, DMI_SET_POINTS);
    if (out->member == NULL || out->points == NULL || out->touches == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(out->member, 0, grid->node_count);
    for (int k = 0; k < 3; k++) out->low[k] = INFINITY, out->high[k] = -INFINITY;
    for (uint32_t n = 0; n < count; n++) {
        out->member[nodes[n]] = 1;
        out->cell_count += dmi_cell_count(grid, nodes[n]);
        out->area += grid->area[nodes[n]];
        for (int k = 0; k < 3; k++) {
            out->low[k] = dmi_fminf(out->low[k], grid->low_of[nodes[n]][k]);
            out->high[k] = dmi_fmaxf(out->high[k], grid->high_of[nodes[n]][k]);
        }
    }
    pick_points(out, nodes, count);
    for (uint32_t p = 0; p < out->point_count; p++) {
        const uint32_t cell = dmi_cell_at(grid, out->points[p]);
        out->touches[p] = is_taken(out, against, cell) ? 2 : is_near(out, against, cell, false) ? 1 : 0;
    }
    return DM_OK;
}

static bool is_inside(const dmi_node_cells* g, const float point[3]) {
    for (int k = 0; k < 3; k++)
        if (point[k] < g->low[k] || point[k] >= g->low[k] + g->cell * (float)g->size[k]) return false;
    return true;
}

bool dmi_node_set_meets(const dmi_node_set* set, const float point[3]) {
    return is_inside(set->grid, point) && is_taken(set, UINT32_MAX, dmi_cell_at(set->grid, point));
}

/* Moves a point; returns whether it is still inside the grid. */
static bool move_point(const dmi_node_cells* g, const dmi_set_motion* m, float sine, float cosine, const float point[3],
                       float out[3]) {
    const int b = (m->axis + 1) % 3, c = (m->axis + 2) % 3;
    const float y = point[b] - m->at[b], z = point[c] - m->at[c];
    out[m->axis] = point[m->axis] + m->shift[m->axis];
    out[b] = m->at[b] + cosine * y - sine * z + m->shift[b];
    out[c] = m->at[c] + sine * y + cosine * z + m->shift[c];
    return is_inside(g, out);
}

float dmi_node_set_collide(const dmi_node_set* set, uint32_t against, const dmi_set_motion* motion) {
    const float sine = dmi_sinf(motion->angle), cosine = dmi_cosf(motion->angle);
    uint32_t hits = 0;
    for (uint32_t p = 0; p < set->point_count; p++) {
        float moved[3];
        if (set->touches[p] == 2 || !move_point(set->grid, motion, sine, cosine, set->points[p], moved)) continue;
        hits += is_taken(set, against, dmi_cell_at(set->grid, moved));
    }
    return set->point_count > 0 ? (float)hits / (float)set->point_count : 0;
}

float dmi_node_set_coincide(const dmi_node_set* set, const dmi_set_motion* motion) {
    const float sine = dmi_sinf(motion->angle), cosine = dmi_cosf(motion->angle);
    uint32_t hits = 0;
    for (uint32_t p = 0; p < set->point_count; p++) {
        float moved[3];
        if (!move_point(set->grid, motion, sine, cosine, set->points[p], moved)) continue;
        hits += is_near(set, UINT32_MAX, dmi_cell_at(set->grid, moved), true);
    }
    return set->point_count > 0 ? (float)hits / (float)set->point_count : 0;
}

/* ---- motions ---- */

/* All set by hand. */
static const float WAY_CELLS[3] = {2, 8, 24}; /* cells that a set is shifted by */
#define LITTLE 0.25f                          /* rad */
#define MUCH 0.9f                             /* rad */
#define SPIN_STEP 0.6f                        /* rad, of turns into itself */
#define EXPOSED_BONUS 0.05f                   /* share of collisions that being seen is worth */
#define APART_COST 0.3f                       /* share of collisions that a diagonal from the contacts is worth */
#define TINY 1e-6f                            /* object sizes; no length is divided by less */
#define CORNERS 4                             /* edges of a box along one axis */

/* ---- ways ---- */

static float slide(const dmi_node_set* set, uint32_t against, int side, float cells) {
    dmi_set_motion m = {.axis = 0};
    m.shift[side / 2] = (side % 2 ? 1.0f : -1.0f) * cells * set->grid->cell;
    return dmi_node_set_collide(set, against, &m);
}

static float way_cost(const dmi_set_way* w) {
    return w->near + w->middle + w->far - EXPOSED_BONUS * w->exposed;
}

void dmi_measure_ways(const dmi_node_set* set, uint32_t against, const float exposed[DMI_GRID_SIDES],
                      dmi_set_way out[DMI_GRID_SIDES]) {
    for (int side = 0; side < DMI_GRID_SIDES; side++)
        out[side] = (dmi_set_way){slide(set, against, side, WAY_CELLS[0]),
                                  slide(set, against, side, WAY_CELLS[1]),
                                  slide(set, against, side, WAY_CELLS[2]),
                                  exposed[side],
                                  0,
                                  side};
    for (int side = 0; side < DMI_GRID_SIDES; side++) out[side].back = out[side ^ 1].near;
    for (int i = 1; i < DMI_GRID_SIDES; i++)
        for (int j = i; j > 0 && way_cost(&out[j]) < way_cost(&out[j - 1]); j--) {
            const dmi_set_way t = out[j];
            out[j] = out[j - 1], out[j - 1] = t;
        }
}

/* ---- turns ---- */

static float diagonal_of(const dmi_node_set* s) {
    float sum = 0;
    for (int k = 0; k < 3; k++) sum += (s->high[k] - s->low[k]) * (s->high[k] - s->low[k]);
    return sqrtf(sum) + TINY;
}

static float touch_distance(const dmi_node_set* s, int axis, const float at[3]) {
    float sum = 0;
    uint32_t count = 0;
    for (uint32_t p = 0; p < s->point_count; p++) {
        if (s->touches[p] == 0) continue;
        float d = 0;
        for (int k = 0; k < 3; k++)
            if (k != axis) d += (s->points[p][k] - at[k]) * (s->points[p][k] - at[k]);
        sum += sqrtf(d);
        count++;
    }
    return count > 0 ? sum / (float)count / diagonal_of(s) : 1;
}

static float turn_by(const dmi_node_set* s, int axis, const float at[3], float angle) {
    const dmi_set_motion m = {.axis = axis, .angle = angle, .at = {at[0], at[1], at[2]}};
    return dmi_node_set_collide(s, UINT32_MAX, &m);
}

static dmi_set_turn measure_turn(const dmi_node_set* s, int axis, const float at[3]) {
    const float little[2] = {turn_by(s, axis, at, LITTLE), turn_by(s, axis, at, -LITTLE)};
    const float much[2] = {turn_by(s, axis, at, MUCH), turn_by(s, axis, at, -MUCH)};
    const int sense = little[1] + much[1] < little[0] + much[0];
    return (dmi_set_turn){little[sense], much[sense], little[!sense], touch_distance(s, axis, at),
                          s->high[axis] - s->low[axis]};
}

static float turn_cost(const dmi_set_turn* t) {
    return t->little + t->much + APART_COST * t->apart;
}

void dmi_measure_edges(const dmi_node_set* s, dmi_set_turn out[2], uint32_t* out_free) {
    dmi_set_turn best_of[3];
    *out_free = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        for (int corner = 0; corner < CORNERS; corner++) {
            float at[3] = {0};
            at[b] = corner & 1 ? s->high[b] : s->low[b];
            at[c] = corner & 2 ? s->high[c] : s->low[c];
            const dmi_set_turn t = measure_turn(s, axis, at);
            *out_free += t.little + t.much < DMI_FREE;
            if (corner == 0 || turn_cost(&t) < turn_cost(&best_of[axis])) best_of[axis] = t;
        }
    }
    int best = 0;
    for (int axis = 1; axis < 3; axis++)
        if (turn_cost(&best_of[axis]) < turn_cost(&best_of[best])) best = axis;
    const int one = (best + 1) % 3, two = (best + 2) % 3;
    out[0] = best_of[best];
    out[1] = turn_cost(&best_of[one]) < turn_cost(&best_of[two]) ? best_of[one] : best_of[two];
}

dmi_set_spin dmi_measure_spin(const dmi_node_set* s) {
    dmi_set_spin best = {.round = -1};
    float at[3];
    for (int k = 0; k < 3; k++) at[k] = 0.5f * (s->low[k] + s->high[k]);
    for (int axis = 0; axis < 3; axis++) {
        float round = 1;
        for (int i = 1; i <= 2; i++) {
            const dmi_set_motion m = {.axis = axis, .angle = SPIN_STEP * (float)i, .at = {at[0], at[1], at[2]}};
            round = dmi_fminf(round, dmi_node_set_coincide(s, &m));
        }
        if (round > best.round) best = (dmi_set_spin){round, measure_turn(s, axis, at)};
    }
    return best;
}
