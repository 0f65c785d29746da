/* Triangles in a grid of cubes: which of them a short way crosses. */
#include "dragbot_grid.h"

#include <math.h>
#include <stdlib.h>

#include "cli.h"

/* By hand: cells along the longest side; cells a root of the triangles' count. */
enum { MIN_CELLS = 8, MAX_CELLS = 64 };
static const double cells_a_root = 3;

static double part_of(vec v, int k) {
    return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

static vec corner_of(const bot_triangle* triangle, int k) {
    return k == 0 ? triangle->corner : add(triangle->corner, triangle->side[k - 1]);
}

/* ---- building ---- */

static void bound(bot_grid* grid) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, side = 0;
    for (uint32_t i = 0; i < 3 * grid->count; i++) {
        const vec corner = corner_of(&grid->triangles[i / 3], (int)(i % 3));
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], part_of(corner, k));
            high[k] = fmax(high[k], part_of(corner, k));
        }
    }
    for (int k = 0; k < 3; k++) side = fmax(side, high[k] - low[k]);
    const double cells = fmin(fmax(cells_a_root * cbrt(grid->count), MIN_CELLS), MAX_CELLS);
    grid->low = (vec){low[0], low[1], low[2]};
    grid->cell = side > 0 ? side / cells : 1;
    for (int k = 0; k < 3; k++) grid->size[k] = (int)fmax(1, floor((high[k] - low[k]) / grid->cell) + 1);
}

/* The cells that a box touches, with a little margin; false when they lie outside the grid. */
static bool cells_of(const bot_grid* grid, vec a, vec b, int low[3], int high[3]) {
    static const double margin = 1e-6; /* of a cell, for rounding */
    for (int k = 0; k < 3; k++) {
        const double at = (part_of(a, k) - part_of(grid->low, k)) / grid->cell,
                     to = (part_of(b, k) - part_of(grid->low, k)) / grid->cell;
        const double first = floor(fmin(at, to) - margin), last = floor(fmax(at, to) + margin);
        if (!(last >= 0) || !(first < grid->size[k])) return false;
        low[k] = (int)fmax(first, 0);
        high[k] = (int)fmin(last, grid->size[k] - 1);
    }
    return true;
}

/* Whether the plane of a triangle comes near the cell. */
static bool meets(const bot_grid* grid, const bot_triangle* triangle, const int at[3]) {
    const vec middle = add(grid->low, scale((vec){at[0] + 0.5, at[1] + 0.5, at[2] + 0.5}, grid->cell));
    const double half_diagonal = 0.8660254037844386; /* of a cube with side 1, rounded up below */
    return fabs(dot(sub(middle, triangle->corner), triangle->normal)) <= 1.001 * half_diagonal * grid->cell;
}

static size_t cell_at(const bot_grid* grid, const int at[3]) {
    return ((size_t)at[2] * (size_t)grid->size[1] + (size_t)at[1]) * (size_t)grid->size[0] + (size_t)at[0];
}

/* Counts a triangle in its cells, or writes it down there. */
static void enter(bot_grid* grid, uint32_t triangle, bool writes) {
    const bot_triangle* t = &grid->triangles[triangle];
    const vec a = corner_of(t, 0), b = corner_of(t, 1), c = corner_of(t, 2);
    const vec least = {fmin(a.x, fmin(b.x, c.x)), fmin(a.y, fmin(b.y, c.y)), fmin(a.z, fmin(b.z, c.z))};
    const vec most = {fmax(a.x, fmax(b.x, c.x)), fmax(a.y, fmax(b.y, c.y)), fmax(a.z, fmax(b.z, c.z))};
    int low[3], high[3], at[3];
    if (!cells_of(grid, least, most, low, high)) return;
    for (at[2] = low[2]; at[2] <= high[2]; at[2]++) {
        for (at[1] = low[1]; at[1] <= high[1]; at[1]++) {
            for (at[0] = low[0]; at[0] <= high[0]; at[0]++) {
                if (!meets(grid, t, at)) continue;
                uint32_t* first = &grid->first[cell_at(grid, at)];
                if (writes)
                    grid->members[--*first] = triangle;
                else
                    ++*first;
            }
        }
    }
}

bot_grid bot_grid_new(bot_triangle* triangles, uint32_t count) {
    bot_grid grid = {.triangles = triangles, .count = count, .size = {1, 1, 1}, .cell = 1};
    if (count > 0) bound(&grid);
    const size_t cells = (size_t)grid.size[0] * (size_t)grid.size[1] * (size_t)grid.size[2];
    grid.first = cli_alloc_zeroed((cells + 1) * sizeof *grid.first);
    grid.seen = cli_alloc_zeroed((count + 1) * sizeof *grid.seen);
    for (uint32_t i = 0; i < count; i++) enter(&grid, i, false);
    for (size_t i = 1; i <= cells; i++) grid.first[i] += grid.first[i - 1];
    grid.members = cli_alloc((grid.first[cells] + 1) * sizeof *grid.members);
    for (uint32_t i = 0; i < count; i++) enter(&grid, i, true);
    return grid;
}

void bot_grid_free(bot_grid* grid) {
    free(grid->triangles);
    free(grid->first);
    free(grid->members);
    free(grid->seen);
}

/* ---- asking ---- */

/* Moeller and Trumbore's test, both sides; share of the way in (0, 1]. */
static bool crosses(const bot_triangle* t, vec from, vec way, double* out_share) {
    const vec p = cross(way, t->side[1]);
    const double volume = dot(t->side[0], p);
    if (volume == 0) return false;
    const vec s = sub(from, t->corner);
    const double u = dot(s, p) / volume;
    if (!(u >= 0 && u <= 1)) return false;
    const vec q = cross(s, t->side[0]);
    const double v = dot(way, q) / volume;
    if (!(v >= 0 && u + v <= 1)) return false;
    *out_share = dot(t->side[1], q) / volume;
    return *out_share > 0 && *out_share <= 1;
}

static void ask_cell(bot_grid* grid, size_t cell, vec from, vec way, bot_crossing report, void* user) {
    double share;
    for (uint32_t i = grid->first[cell]; i < grid->first[cell + 1]; i++) {
        const uint32_t triangle = grid->members[i];
        if (grid->seen[triangle] == grid->round) continue;
        grid->seen[triangle] = grid->round;
        if (crosses(&grid->triangles[triangle], from, way, &share)) report(user, triangle, share);
    }
}

void bot_grid_cross(bot_grid* grid, vec from, vec to, bot_crossing report, void* user) {
    const vec way = sub(to, from);
    const int pieces = (int)fmin(ceil(length(way) / grid->cell), 4 * MAX_CELLS); /* so that each meets few cells */
    grid->round++;
    if (grid->count == 0) return;
    for (int i = 0; i < pieces; i++) {
        int low[3], high[3], at[3];
        const vec a = add(from, scale(way, (double)i / pieces)), b = add(from, scale(way, (i + 1.0) / pieces));
        if (!cells_of(grid, a, b, low, high)) continue;
        for (at[2] = low[2]; at[2] <= high[2]; at[2]++)
            for (at[1] = low[1]; at[1] <= high[1]; at[1]++)
                for (at[0] = low[0]; at[0] <= high[0]; at[0]++)
                    ask_cell(grid, cell_at(grid, at), from, way, report, user);
    }
}
