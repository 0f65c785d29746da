/* Welding by a grid of cells, regions and shells by union-find over faces. */
#include "mesh/connectivity.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/random.h"
#include "math/elementary.h"

#define NONE UINT32_MAX
#define NO_CONCAVE_CUT 2.0f  /* a sine that no edge exceeds */
#define CELL_TOLERANCES 4    /* side of a grid cell in tolerances; by hand: few searches then leave the cell */
#define MIN_BUCKET_BITS 4    /* binary logarithm of the buckets of the grid's hash table; more for more vertices */
#define MIN_CELL 1e-6f       /* side of a grid cell, object sizes: indices fit 32 bits */
#define MAX_FACES_AT_EDGE 32 /* compared at one edge; by hand, real edges have two */

static dm_result out_of_memory(const dmi_arena* arena, const dmi_mesh* mesh) {
    return dmi_fail(arena->env, DM_ERROR_OUT_OF_MEMORY, "no memory to connect %u triangles", mesh->face_count);
}

static void fill_none(uint32_t* values, size_t count) {
    memset(values, 0xff, count * sizeof *values); /* all bits set: NONE */
}

/* ---- welding ---- */

typedef struct grid {
    const dmi_mesh* mesh;
    float tolerance, cells_a_unit;
    uint32_t* heads;     /* newest vertex of each bucket */
    uint32_t* next;      /* a vertex, in its bucket */
    uint64_t factors[3]; /* factors of the hash: random and odd */
    uint32_t shift;      /* 64 minus the binary logarithm of the number of buckets */
} grid;

/* Universal hashing (Dietzfelbinger 1996): two cells share a bucket by chance, whatever mesh it is. */
static uint32_t bucket_of(const grid* grid, const int32_t cell[3]) {
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) hash += (uint64_t)cell[k] * grid->factors[k];
    return (uint32_t)(hash >> grid->shift);
}

/* Draws factors that whoever made the mesh can't know: by where the table lies in memory. They decide how fast vertices
 * are found, not which. */
static void draw_factors(grid* grid) {
    dmi_random random = dmi_random_make((uint64_t)(uintptr_t)grid->heads, 0);
    for (int k = 0; k < 3; k++)
        grid->factors[k] = (uint64_t)dmi_random_u32(&random) << 32 | dmi_random_u32(&random) | 1;
}

/* The smallest kept vertex within the tolerance of p in the bucket of a cell, or `found` where that is smaller. */
static uint32_t search_cell(const grid* grid, const int32_t cell[3], const float p[3], uint32_t found) {
    for (uint32_t v = grid->heads[bucket_of(grid, cell)]; v != NONE; v = grid->next[v]) {
        const float* q = grid->mesh->positions + (size_t)v * 3;
        float x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
        if (v < found && x * x + y * y + z * z <= grid->tolerance * grid->tolerance) found = v;
    }
    return found;
}

/* Cells are counted from a corner below every position (which lie in [-1, 1]), so that truncation rounds down. */
static int32_t cell_of(const grid* grid, float x) {
    return (int32_t)((x + 1 + grid->tolerance) * grid->cells_a_unit);
}

/* The smallest kept vertex within the tolerance of p, and p's own cell. */
static uint32_t search(const grid* grid, const float p[3], int32_t own[3]) {
    int32_t low[3], high[3], cell[3];
    for (int k = 0; k < 3; k++) {
        low[k] = cell_of(grid, p[k] - grid->tolerance);
        own[k] = cell_of(grid, p[k]);
        high[k] = cell_of(grid, p[k] + grid->tolerance);
    }
    uint32_t found = NONE;
    for (cell[0] = low[0]; cell[0] <= high[0]; cell[0]++) {
        for (cell[1] = low[1]; cell[1] <= high[1]; cell[1]++) {
            for (cell[2] = low[2]; cell[2] <= high[2]; cell[2]++) found = search_cell(grid, cell, p, found);
        }
    }
    return found;
}

dm_result dmi_weld_vertices(dmi_arena* arena, const dmi_mesh* mesh, float tolerance, const dmi_progress* progress,
                            uint32_t* out_welded) {
    uint32_t bits = MIN_BUCKET_BITS;
    while (((uint64_t)1 << bits) < mesh->vertex_count) bits++;
    const size_t buckets = (size_t)1 << bits;
    grid grid = {.mesh = mesh, .tolerance = tolerance, .shift = 64 - bits};
    grid.cells_a_unit = 1 / dmi_fmaxf(CELL_TOLERANCES * tolerance, MIN_CELL);
    grid.heads = dmi_arena_push(arena, buckets * sizeof(uint32_t));
    grid.next = dmi_arena_push(arena, mesh->vertex_count * sizeof(uint32_t));
    if (grid.heads == NULL || grid.next == NULL) return out_of_memory(arena, mesh);
    fill_none(grid.heads, buckets);
    draw_factors(&grid);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (dmi_progress_step(progress, v, mesh->vertex_count) != DM_OK) return DM_ERROR_CANCELLED;
        int32_t cell[3];
        uint32_t found = search(&grid, mesh->positions + (size_t)v * 3, cell);
        out_welded[v] = found == NONE ? v : found;
        if (found != NONE) continue;
        uint32_t bucket = bucket_of(&grid, cell);
        grid.next[v] = grid.heads[bucket];
        grid.heads[bucket] = v;
    }
    return DM_OK;
}

/* ---- union-find: the root of a set is its smallest face ---- */

static uint32_t find_root(uint32_t* parents, uint32_t face) {
    while (parents[face] != face) {
        parents[face] = parents[parents[face]];
        face = parents[face];
    }
    return face;
}

static void unite(uint32_t* parents, uint32_t a, uint32_t b) {
    a = find_root(parents, a);
    b = find_root(parents, b);
    if (a < b)
        parents[b] = a;
    else
        parents[a] = b;
}

/* Turns parents into labels in place: a root comes before its other faces, so its label is set when they need it. */
static uint32_t number_sets(uint32_t* parents, const uint8_t* select, uint32_t face_count) {
    uint32_t count = 0;
    for (uint32_t f = 0; f < face_count; f++) {
        if (select[f]) parents[f] = find_root(parents, f);
    }
    for (uint32_t f = 0; f < face_count; f++) {
        if (!select[f])
            parents[f] = NONE;
        else
            parents[f] = parents[f] == f ? count++ : parents[parents[f]];
    }
    return count;
}

/* ---- shells ---- */

static dm_result unite_over_vertices(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded,
                                     const uint8_t* select, const dmi_progress* progress, uint32_t* parents) {
    uint32_t* first_face = dmi_arena_push(arena, mesh->vertex_count * sizeof(uint32_t));
    if (first_face == NULL) return out_of_memory(arena, mesh);
    fill_none(first_face, mesh->vertex_count);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        for (int i = 0; i < 3 && select[f]; i++) {
            uint32_t v = welded[mesh->indices[(size_t)f * 3 + (size_t)i]];
            if (first_face[v] == NONE)
                first_face[v] = f;
            else
                unite(parents, first_face[v], f);
        }
        if (dmi_progress_step(progress, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    return DM_OK;
}

/* ---- regions ---- */

/* The edges of the selected faces, in order of their smaller vertex. */
typedef struct edges {
    uint32_t* first;  /* a vertex, and two: where its edges begin */
    uint32_t* other;  /* an edge: its larger vertex */
    uint32_t* face;   /* an edge */
    uint32_t* before; /* an edge: the one before it between the same vertices, or NONE */
    uint32_t* latest; /* a vertex: the latest edge that has it as the larger one */
} edges;

static dm_result allocate_edges(dmi_arena* arena, const dmi_mesh* mesh, edges* out) {
    size_t count = (size_t)mesh->face_count * 3 * sizeof(uint32_t);
    out->first = dmi_arena_push(arena, ((size_t)mesh->vertex_count + 2) * sizeof(uint32_t));
    out->other = dmi_arena_push(arena, count);
    out->face = dmi_arena_push(arena, count);
    out->before = dmi_arena_push(arena, count);
    out->latest = dmi_arena_push(arena, mesh->vertex_count * sizeof(uint32_t));
    return out->first != NULL && out->other != NULL && out->face != NULL && out->before != NULL && out->latest != NULL
               ? DM_OK
               : out_of_memory(arena, mesh);
}

/* Computes smaller and larger vertex of side i of a face; false when both are the same. */
static bool edge_of(const dmi_mesh* mesh, const uint32_t* welded, uint32_t face, size_t i, uint32_t* low,
                    uint32_t* high) {
    const uint32_t* corners = mesh->indices + (size_t)face * 3;
    uint32_t a = welded[corners[i]], b = welded[corners[i < 2 ? i + 1 : 0]];
    *low = a < b ? a : b;
    *high = a < b ? b : a;
    return a != b;
}

/* Counting sort; counts are stored two places further, so that filling leaves first[v] at the beginning of v's edges.
 */
static dm_result sort_edges(const dmi_mesh* mesh, const uint32_t* welded, const uint8_t* select,
                            const dmi_progress* progress, edges* edges) {
    const dmi_progress counting = dmi_progress_piece(progress, 0, DMI_STAGE_REGIONS_EDGES_COUNTED),
                       filling = dmi_progress_piece(progress, DMI_STAGE_REGIONS_EDGES_COUNTED,
                                                    DMI_STAGE_REGIONS_EDGES_SORTED);
    uint32_t low, high;
    memset(edges->first, 0, ((size_t)mesh->vertex_count + 2) * sizeof(uint32_t));
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        for (size_t i = 0; i < 3 && select[f]; i++) {
            if (edge_of(mesh, welded, f, i, &low, &high)) edges->first[low + 2]++;
        }
        if (dmi_progress_step(&counting, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    for (uint32_t v = 0; v < mesh->vertex_count; v++) edges->first[v + 2] += edges->first[v + 1];
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        for (size_t i = 0; i < 3 && select[f]; i++) {
            if (!edge_of(mesh, welded, f, i, &low, &high)) continue;
            uint32_t place = edges->first[low + 1]++;
            edges->other[place] = high;
            edges->face[place] = f;
        }
        if (dmi_progress_step(&filling, f, mesh->face_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    return DM_OK;
}

/* Links edge e to the earlier one between the same vertices and returns that, or NONE; begin: first edge of its vertex.
 */
static uint32_t chain_edge(edges* edges, uint32_t begin, uint32_t e) {
    uint32_t* latest = &edges->latest[edges->other[e]];
    /* An edge before `begin` belongs to another vertex. */
    edges->before[e] = *latest != NONE && *latest >= begin ? *latest : NONE;
    *latest = e;
    return edges->before[e];
}

/* Whether two faces meet at less than the angle. Slivers have zero normals, so a cosine of 0. */
static bool is_smooth(const dmi_mesh* mesh, uint32_t a, uint32_t b, float min_cosine) {
    const float *n = mesh->face_normal + (size_t)a * 3, *m = mesh->face_normal + (size_t)b * 3;
    return fabsf(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) > min_cosine;
}

static dm_result unite_over_edges(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const uint8_t* select,
                                  float min_cosine, const dmi_progress* progress, uint32_t* parents) {
    const dmi_progress uniting = dmi_progress_piece(progress, DMI_STAGE_REGIONS_EDGES_SORTED, 1);
    edges edges;
    dm_result result = allocate_edges(arena, mesh, &edges);
    if (result == DM_OK) result = sort_edges(mesh, welded, select, progress, &edges);
    if (result != DM_OK) return result;
    fill_none(edges.latest, mesh->vertex_count);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        uint32_t begin = edges.first[v], end = edges.first[v + 1];
        for (uint32_t e = begin; e < end; e++) {
            uint32_t b = chain_edge(&edges, begin, e);
            for (int n = 0; b != NONE && n < MAX_FACES_AT_EDGE; n++, b = edges.before[b]) {
                if (is_smooth(mesh, edges.face[e], edges.face[b], min_cosine))
                    unite(parents, edges.face[e], edges.face[b]);
            }
        }
        if (dmi_progress_step(&uniting, v, mesh->vertex_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    return DM_OK;
}

dm_result dmi_face_regions(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const uint8_t* select,
                           float min_cosine, const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count) {
    for (uint32_t f = 0; f < mesh->face_count; f++) out_labels[f] = f;
    dm_result result = min_cosine < -1
                           ? unite_over_vertices(arena, mesh, welded, select, progress, out_labels)
                           : unite_over_edges(arena, mesh, welded, select, min_cosine, progress, out_labels);
    if (result == DM_OK) *out_count = number_sets(out_labels, select, mesh->face_count);
    return result;
}

/* ---- sheets ---- */

/* The corner of a face that is not on the edge between a and b. */
static uint32_t third_corner(const dmi_mesh* mesh, const uint32_t* welded, uint32_t face, uint32_t a, uint32_t b) {
    const uint32_t* corners = mesh->indices + (size_t)face * 3;
    for (int i = 0; i < 2; i++)
        if (welded[corners[i]] != a && welded[corners[i]] != b) return welded[corners[i]];
    return welded[corners[2]];
}

/* Whether the far corner of the neighbour is above a face's plane by more than the sine: the edge is concave. */
static bool sees_corner(const dmi_mesh* mesh, uint32_t face, uint32_t edge_corner, uint32_t far_corner, float sine) {
    const float *n = mesh->face_normal + (size_t)face * 3, *a = mesh->positions + (size_t)edge_corner * 3;
    const float* b = mesh->positions + (size_t)far_corner * 3;
    const float to[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const float height = n[0] * to[0] + n[1] * to[1] + n[2] * to[2];
    return height > sine * sqrtf(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
}

/* Which faces at an edge belong to one sheet, besides coincident ones and two at an edge of their own. */
typedef struct sheet_rule {
    float concave_sine; /* two do not where the edge is concave by more */
    bool fans;          /* all do where as many meet as are compared at one edge, or more */
} sheet_rule;

static void unite_fan(const edges* edges, uint32_t e, uint32_t* parents) {
    const uint32_t first = edges->face[e];
    for (; e != NONE; e = edges->before[e]) unite(parents, first, edges->face[e]);
}

/* Unites the faces at one edge, from its newest entry on: coincident faces first; if just two places are left, these
 * belong to one sheet unless the edge is concave. */
static void unite_at_edge(const dmi_mesh* mesh, const uint32_t* welded, const edges* edges, uint32_t low, uint32_t e,
                          const sheet_rule* rule, uint32_t* parents) {
    uint32_t faces[MAX_FACES_AT_EDGE], corners[MAX_FACES_AT_EDGE], count = 0;
    const uint32_t high = edges->other[e], newest = e;
    for (; e != NONE && count < MAX_FACES_AT_EDGE; e = edges->before[e]) {
        const uint32_t face = edges->face[e], corner = third_corner(mesh, welded, face, low, high);
        uint32_t same = 0;
        while (same < count && corners[same] != corner) same++;
        if (same < count) {
            unite(parents, faces[same], face);
        } else {
            faces[count] = face;
            corners[count++] = corner;
        }
    }
    if (count == MAX_FACES_AT_EDGE && rule->fans) unite_fan(edges, newest, parents);
    if (count != 2) return;
    if (sees_corner(mesh, faces[0], low, corners[1], rule->concave_sine) &&
        sees_corner(mesh, faces[1], low, corners[0], rule->concave_sine))
        return;
    unite(parents, faces[0], faces[1]);
}

static dm_result label_sheets(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const sheet_rule* rule,
                              const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count) {
    const dmi_progress uniting = dmi_progress_piece(progress, DMI_STAGE_REGIONS_EDGES_SORTED, 1);
    edges edges;
    uint8_t* all = dmi_arena_push(arena, mesh->face_count);
    if (all == NULL) return out_of_memory(arena, mesh);
    dm_result result = allocate_edges(arena, mesh, &edges);
    if (result != DM_OK) return result;
    memset(all, 1, mesh->face_count);
    result = sort_edges(mesh, welded, all, progress, &edges);
    if (result != DM_OK) return result;
    for (uint32_t f = 0; f < mesh->face_count; f++) out_labels[f] = f;
    fill_none(edges.latest, mesh->vertex_count);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        uint32_t begin = edges.first[v], end = edges.first[v + 1];
        for (uint32_t e = begin; e < end; e++) chain_edge(&edges, begin, e);
        for (uint32_t e = begin; e < end; e++)
            if (edges.latest[edges.other[e]] == e) unite_at_edge(mesh, welded, &edges, v, e, rule, out_labels);
        if (dmi_progress_step(&uniting, v, mesh->vertex_count) != DM_OK) return DM_ERROR_CANCELLED;
    }
    *out_count = number_sets(out_labels, all, mesh->face_count);
    return DM_OK;
}

dm_result dmi_face_sheets(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, const dmi_progress* progress,
                          uint32_t* out_labels, uint32_t* out_count) {
    const sheet_rule rule = {.concave_sine = NO_CONCAVE_CUT};
    return label_sheets(arena, mesh, welded, &rule, progress, out_labels, out_count);
}

dm_result dmi_face_sheets_and_fans(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded,
                                   const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count) {
    const sheet_rule rule = {.concave_sine = NO_CONCAVE_CUT, .fans = true};
    return label_sheets(arena, mesh, welded, &rule, progress, out_labels, out_count);
}

dm_result dmi_face_bulges(dmi_arena* arena, const dmi_mesh* mesh, const uint32_t* welded, float concave_sine,
                          const dmi_progress* progress, uint32_t* out_labels, uint32_t* out_count) {
    const sheet_rule rule = {.concave_sine = concave_sine};
    return label_sheets(arena, mesh, welded, &rule, progress, out_labels, out_count);
}
