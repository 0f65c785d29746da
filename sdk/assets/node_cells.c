/* Rasterises the nodes of an asset into cells, and measures contacts and exposure. */
#include "assets/node_cells.h"

#include <math.h>
#include <string.h>

#include "math/elementary.h"

#define CELL_BITS 24 /* bits of the index of a cell */
#define DIGIT_BITS 8 /* bits of a pass of the radix sort */
#define DIGITS (1u << DIGIT_BITS)
#define STEP 0.5f /* cells between samples of a triangle: no cell inside is missed by much */

/* ---- cells of each node ---- */

typedef struct rasteriser {
    dmi_node_cells* grid;
    uint32_t* stamp; /* cell -> 1 + the node that was last seen there */
    uint32_t node, count;
    uint32_t* out; /* NULL: counts alone */
} rasteriser;

static void mark_point(rasteriser* r, const float point[3]) {
    const uint32_t cell = dmi_cell_at(r->grid, point);
    if (r->stamp[cell] == r->node + 1) return;
    r->stamp[cell] = r->node + 1;
    if (r->out != NULL) r->out[r->count] = cell;
    r->count++;
}

static void mark_face(rasteriser* r, const dmi_mesh* mesh, uint32_t face) {
    const uint32_t* corner = mesh->indices + (size_t)face * 3;
    const float* a = mesh->positions + (size_t)corner[0] * 3;
    const float* b = mesh->positions + (size_t)corner[1] * 3;
    const float* c = mesh->positions + (size_t)corner[2] * 3;
    float u[3], v[3], u_length = 0, v_length = 0;
    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k], v[k] = c[k] - a[k];
        u_length += u[k] * u[k], v_length += v[k] * v[k];
    }
    const float step = STEP * r->grid->cell;
    const int rows = (int)ceilf(sqrtf(u_length) / step) + 1;
    for (int i = 0; i <= rows; i++) {
        const float s = (float)i / (float)rows;
        const int columns = (int)ceilf(sqrtf(v_length) * (1 - s) / step) + 1;
        for (int j = 0; j <= columns; j++) {
            const float t = (1 - s) * (float)j / (float)columns;
            const float p[3] = {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1], a[2] + s * u[2] + t * v[2]};
            mark_point(r, p);
        }
    }
}

/* Sorts rising; cells of a node are up to some ten thousand numbers. */
static void sort_cells(uint32_t* values, uint32_t count, uint32_t* spare) {
    for (uint32_t shift = 0; shift < CELL_BITS; shift += DIGIT_BITS) {
        uint32_t start[DIGITS + 1] = {0};
        for (uint32_t i = 0; i < count; i++) start[((values[i] >> shift) & (DIGITS - 1)) + 1]++;
        for (uint32_t d = 0; d < DIGITS; d++) start[d + 1] += start[d];
        for (uint32_t i = 0; i < count; i++) spare[start[(values[i] >> shift) & (DIGITS - 1)]++] = values[i];
        memcpy(values, spare, count * sizeof *values);
    }
}

/* Lists the faces of each node: order[first[n]] .. order[first[n + 1] - 1]. */
static void sort_faces(const dmi_node_cells* g, uint32_t* first, uint32_t* order) {
    const dmi_mesh* mesh = g->mesh;
    memset(first, 0, (g->node_count + 2) * sizeof *first);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t node = g->node_of_part[mesh->face_part[f]];
        if (node != UINT32_MAX) first[node + 2]++;
    }
    for (uint32_t n = 0; n < g->node_count; n++) first[n + 2] += first[n + 1];
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const uint32_t node = g->node_of_part[mesh->face_part[f]];
        if (node != UINT32_MAX) order[first[node + 1]++] = f;
    }
}

static dm_result rasterise_nodes(dmi_arena* arena, dmi_node_cells* g, uint32_t cell_count,
                                 const dmi_progress* progress) {
    const dmi_mesh* mesh = g->mesh;
    uint32_t* first = dmi_arena_push(arena, (g->node_count + 2) * sizeof *first);
    uint32_t* order = dmi_arena_push(arena, (mesh->face_count + 1) * sizeof *order);
    rasteriser r = {.grid = g, .stamp = dmi_arena_push(arena, cell_count * sizeof *r.stamp)};
    g->first = dmi_arena_push(arena, (g->node_count + 1) * sizeof *g->first);
    if (first == NULL || order == NULL || r.stamp == NULL || g->first == NULL) return DM_ERROR_OUT_OF_MEMORY;
    sort_faces(g, first, order);
    for (int pass = 0; pass < 2; pass++) {
        memset(r.stamp, 0, cell_count * sizeof *r.stamp);
        r.count = 0;
        for (r.node = 0; r.node < g->node_count; r.node++) {
            g->first[r.node] = r.count;
            for (uint32_t i = first[r.node]; i < first[r.node + 1]; i++) mark_face(&r, mesh, order[i]);
            const dm_result result = dmi_progress_tell(progress, (float)((uint32_t)pass * g->node_count + r.node) /
                                                                     (float)(2 * g->node_count));
            if (result != DM_OK) return result;
        }
        g->first[g->node_count] = r.count;
        if (pass == 0) r.out = g->cells = dmi_arena_push(arena, (r.count + 1) * sizeof *r.out);
        if (g->cells == NULL) return DM_ERROR_OUT_OF_MEMORY;
    }
    uint32_t* spare = dmi_arena_push(arena, (r.count + 1) * sizeof *spare);
    if (spare == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t n = 0; n < g->node_count; n++)
        sort_cells(g->cells + g->first[n], g->first[n + 1] - g->first[n], spare);
    return DM_OK;
}

/* ---- nodes of each cell ---- */

static dm_result list_owners(dmi_arena* arena, dmi_node_cells* g, uint32_t cell_count) {
    const uint32_t entries = g->first[g->node_count];
    g->start = dmi_arena_push(arena, (cell_count + 2) * sizeof *g->start);
    g->owners = dmi_arena_push(arena, (entries + 1) * sizeof *g->owners);
    if (g->start == NULL || g->owners == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(g->start, 0, (cell_count + 2) * sizeof *g->start);
    for (uint32_t i = 0; i < entries; i++) g->start[g->cells[i] + 2]++;
    for (uint32_t c = 0; c < cell_count; c++) g->start[c + 2] += g->start[c + 1];
    for (uint32_t n = 0; n < g->node_count; n++)
        for (uint32_t i = g->first[n]; i < g->first[n + 1]; i++) g->owners[g->start[g->cells[i] + 1]++] = (uint16_t)n;
    return DM_OK;
}

/* ---- contacts ---- */

/* Counts, for one cell of `node`, the other nodes at it or at the 26 cells beside it. seen[other]: the last cell that
 * was counted. */
static void count_contacts(const dmi_node_cells* g, uint32_t node, uint32_t cell, uint32_t* seen) {
    uint32_t* row = g->contacts + (size_t)node * g->node_count;
    const int32_t across = g->size[0], slab = g->size[0] * g->size[1];
    for (int32_t z = -1; z <= 1; z++)
        for (int32_t y = -1; y <= 1; y++) {
            const int32_t middle = (int32_t)cell + z * slab + y * across;
            for (uint32_t i = g->start[middle - 1]; i < g->start[middle + 2]; i++) {
                const uint32_t other = g->owners[i];
                if (seen[other] == cell + 1) continue;
                seen[other] = cell + 1;
                row[other]++;
            }
        }
}

static dm_result find_contacts(dmi_arena* arena, dmi_node_cells* g) {
    const size_t pairs = (size_t)g->node_count * g->node_count;
    g->contacts = dmi_arena_push(arena, (pairs + 1) * sizeof *g->contacts);
    uint32_t* seen = dmi_arena_push(arena, (g->node_count + 1) * sizeof *seen);
    if (g->contacts == NULL || seen == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(g->contacts, 0, pairs * sizeof *g->contacts);
    for (uint32_t n = 0; n < g->node_count; n++) {
        memset(seen, 0, g->node_count * sizeof *seen);
        for (uint32_t i = g->first[n]; i < g->first[n + 1]; i++) count_contacts(g, n, g->cells[i], seen);
    }
    return DM_OK;
}

/* ---- exposure ---- */

/* Adds 1 to each node of the first cell that is not empty in a column, seen from either end. */
static void look_along(const dmi_node_cells* g, uint32_t begin, uint32_t step, int32_t count, int axis,
                       float (*hits)[DMI_GRID_SIDES]) {
    for (int from_high = 0; from_high < 2; from_high++)
        for (int32_t i = 0; i < count; i++) {
            const uint32_t cell = begin + step * (uint32_t)(from_high ? count - 1 - i : i);
            if (g->start[cell] == g->start[cell + 1]) continue;
            for (uint32_t k = g->start[cell]; k < g->start[cell + 1]; k++)
                hits[g->owners[k]][2 * axis + from_high] += 1;
            break;
        }
}

/* Returns the column of the cell along an axis. */
static uint32_t column_of(const dmi_node_cells* g, uint32_t cell, int axis) {
    const uint32_t across = (uint32_t)g->size[0], slab = across * (uint32_t)g->size[1];
    if (axis == 0) return cell / across;
    return axis == 1 ? cell % across + cell / slab * across : cell % slab;
}

static dm_result find_exposure(dmi_arena* arena, dmi_node_cells* g) {
    const uint32_t across = (uint32_t)g->size[0], slab = across * (uint32_t)g->size[1];
    const uint32_t steps[3] = {1, across, slab};
    g->exposed = dmi_arena_push(arena, (g->node_count + 1) * sizeof *g->exposed);
    const uint32_t most = slab + across * (uint32_t)g->size[2] + (uint32_t)g->size[1] * (uint32_t)g->size[2];
    uint32_t* stamp = dmi_arena_push(arena, most * sizeof *stamp); /* one a column of any axis */
    if (g->exposed == NULL || stamp == NULL) return DM_ERROR_OUT_OF_MEMORY;
    memset(g->exposed, 0, g->node_count * sizeof *g->exposed);
    for (int axis = 0; axis < 3; axis++) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        for (int32_t i = 0; i < g->size[b]; i++)
            for (int32_t j = 0; j < g->size[c]; j++)
                look_along(g, (uint32_t)i * steps[b] + (uint32_t)j * steps[c], steps[axis], g->size[axis], axis,
                           g->exposed);
        memset(stamp, 0, most * sizeof *stamp);
        for (uint32_t n = 0; n < g->node_count; n++) {
            uint32_t columns = 0;
            for (uint32_t i = g->first[n]; i < g->first[n + 1]; i++) {
                const uint32_t column = column_of(g, g->cells[i], axis);
                columns += stamp[column] != n + 1;
                stamp[column] = n + 1;
            }
            for (int side = 2 * axis; side < 2 * axis + 2; side++)
                g->exposed[n][side] /= columns > 0 ? (float)columns : 1;
        }
    }
    return DM_OK;
}

/* ---- boxes ---- */

static dm_result measure_nodes(dmi_arena* arena, dmi_node_cells* g) {
    g->low_of = dmi_arena_push(arena, (g->node_count + 1) * sizeof *g->low_of);
    g->high_of = dmi_arena_push(arena, (g->node_count + 1) * sizeof *g->high_of);
    g->area = dmi_arena_push(arena, (g->node_count + 1) * sizeof *g->area);
    if (g->low_of == NULL || g->high_of == NULL || g->area == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t n = 0; n < g->node_count; n++) {
        g->area[n] = 0;
        for (int k = 0; k < 3; k++) g->low_of[n][k] = INFINITY, g->high_of[n][k] = -INFINITY;
    }
    for (uint32_t p = 0; p < g->mesh->part_count; p++) {
        const uint32_t node = g->node_of_part[p];
        if (node == UINT32_MAX) continue;
        const dmi_part* part = &g->mesh->parts[p];
        g->area[node] += part->area;
        for (int k = 0; k < 3; k++) {
            g->low_of[node][k] = dmi_fminf(g->low_of[node][k], part->box_min[k]);
            g->high_of[node][k] = dmi_fmaxf(g->high_of[node][k], part->box_max[k]);
        }
    }
    return DM_OK;
}

static void lay_grid(dmi_node_cells* g) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, longest = 0;
    for (uint32_t n = 0; n < g->node_count; n++)
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_fminf(low[k], g->low_of[n][k]);
            high[k] = dmi_fmaxf(high[k], g->high_of[n][k]);
        }
    for (int k = 0; k < 3; k++) longest = dmi_fmaxf(longest, high[k] - low[k]);
    g->cell = longest > 0 ? longest / DMI_GRID_CELLS : 1;
    for (int k = 0; k < 3; k++) {
        g->size[k] = (int32_t)ceilf((high[k] - low[k]) / g->cell) + 3;
        g->low[k] = 0.5f * (low[k] + high[k]) - 0.5f * (float)g->size[k] * g->cell;
    }
}

dm_result dmi_node_cells_make(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* node_of_part, uint32_t node_count,
                              const dmi_progress* progress, dmi_node_cells* out) {
    *out = (dmi_node_cells){.mesh = mesh, .node_of_part = node_of_part, .node_count = node_count};
    dm_result result = measure_nodes(arena, out);
    if (result != DM_OK) return result;
    lay_grid(out);
    const uint32_t cell_count = (uint32_t)out->size[0] * (uint32_t)out->size[1] * (uint32_t)out->size[2];
    result = rasterise_nodes(arena, out, cell_count, progress);
    if (result == DM_OK) result = list_owners(arena, out, cell_count);
    if (result == DM_OK) result = find_contacts(arena, out);
    return result == DM_OK ? find_exposure(arena, out) : result;
}
