/* Collects sets of nodes and tests their motions on the grid. */
#include "assets/node_sets.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

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
