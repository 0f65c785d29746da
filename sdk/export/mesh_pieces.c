/* Finds the pieces of a mesh by two tables: of points by place, and of edges by their ends. */
#include "export/mesh_pieces.h"

#include <string.h>

#define EMPTY UINT32_MAX

/* Multipliers of a hash, Knuth's and two primes that are used for grids; by hand. */
static const uint32_t hash_x = 2654435761u, hash_y = 805459861u, hash_z = 3674653429u;
enum { MIX = 15 };

typedef struct edge {
    uint32_t low, high; /* welded points; low EMPTY: no edge */
    uint32_t faces;
    int32_t balance; /* faces that go from low to high, less those that go back */
} edge;

typedef struct finder {
    const dmi_rig_mesh* mesh;
    uint32_t* welded;  /* per point: the first one in its place */
    uint32_t* parents; /* per point: a step towards the point that stands for its piece */
    edge* edges;
    uint32_t edge_mask; /* entries of the table of edges less one: a power of two less one */
} finder;

/* Returns the least power of two of at least twice `count`, less one, so that a table is never more than half full. */
static uint32_t table_mask(uint64_t count) {
    uint64_t size = 1;
    while (size < 2 * count) size *= 2;
    return (uint32_t)(size - 1);
}

static uint32_t hash_of(uint32_t x, uint32_t y, uint32_t z) {
    const uint32_t sum = x * hash_x ^ y * hash_y ^ z * hash_z;
    return sum ^ sum >> MIX;
}

static uint32_t hash_point(const float p[3]) {
    uint32_t bits[3];
    for (int k = 0; k < 3; k++) {
        const float value = p[k] == 0 ? 0 : p[k]; /* minus zero is zero */
        memcpy(&bits[k], &value, sizeof value);
    }
    return hash_of(bits[0], bits[1], bits[2]);
}

static bool is_same_place(const float a[3], const float b[3]) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static bool weld_points(dmi_rig_model* model, finder* f) {
    const uint32_t count = f->mesh->point_count, mask = table_mask(count);
    uint32_t* table = dmi_rig_push(model, (size_t)mask + 1, sizeof *table);
    if (table == NULL) return false;
    memset(table, 0xff, ((size_t)mask + 1) * sizeof *table); /* literal: EMPTY in all bytes */
    for (uint32_t i = 0; i < count; i++) {
        uint32_t at = hash_point(f->mesh->points[i]) & mask;
        while (table[at] != EMPTY && !is_same_place(f->mesh->points[table[at]], f->mesh->points[i]))
            at = (at + 1) & mask;
        if (table[at] == EMPTY) table[at] = i;
        f->welded[i] = table[at];
        f->parents[i] = i;
    }
    return true;
}

/* Returns the point that stands for a piece. The ways there are halved. */
static uint32_t root_of(finder* f, uint32_t point) {
    while (f->parents[point] != point) {
        f->parents[point] = f->parents[f->parents[point]];
        point = f->parents[point];
    }
    return point;
}

static void join_pieces(finder* f, uint32_t a, uint32_t b) {
    const uint32_t first = root_of(f, a), second = root_of(f, b);
    if (first < second)
        f->parents[second] = first;
    else
        f->parents[first] = second;
}

static void add_edge(finder* f, uint32_t from, uint32_t to) {
    const uint32_t low = from < to ? from : to, high = from < to ? to : from;
    uint32_t at = hash_of(low, high, 0) & f->edge_mask;
    while (f->edges[at].low != EMPTY && (f->edges[at].low != low || f->edges[at].high != high))
        at = (at + 1) & f->edge_mask;
    edge* e = &f->edges[at];
    if (e->low == EMPTY) *e = (edge){.low = low, .high = high};
    e->faces++;
    e->balance += from < to ? 1 : -1;
}

static bool add_faces(dmi_rig_model* model, finder* f) {
    f->edge_mask = table_mask((uint64_t)3 * f->mesh->face_count);
    f->edges = dmi_rig_push(model, (size_t)f->edge_mask + 1, sizeof *f->edges);
    if (f->edges == NULL) return false;
    for (size_t i = 0; i <= f->edge_mask; i++) f->edges[i] = (edge){.low = EMPTY};
    for (uint32_t i = 0; i < f->mesh->face_count; i++) {
        uint32_t corners[3];
        for (int k = 0; k < 3; k++) corners[k] = f->welded[f->mesh->faces[i][k]];
        for (int k = 0; k < 3; k++) {
            join_pieces(f, corners[k], corners[(k + 1) % 3]);
            if (corners[k] != corners[(k + 1) % 3]) add_edge(f, corners[k], corners[(k + 1) % 3]);
        }
    }
    return true;
}

/* Numbers the pieces by their first face. numbers: room for all points. */
static void number_pieces(finder* f, uint32_t* numbers, dmi_mesh_pieces* out) {
    memset(numbers, 0xff, f->mesh->point_count * sizeof *numbers); /* literal: EMPTY in all bytes */
    for (uint32_t i = 0; i < f->mesh->face_count; i++) {
        const uint32_t root = root_of(f, f->welded[f->mesh->faces[i][0]]);
        if (numbers[root] == EMPTY) {
            out->is_open[out->count] = 0;
            numbers[root] = out->count++;
        }
        out->faces[i] = numbers[root];
    }
    for (size_t i = 0; i <= f->edge_mask; i++) {
        const edge* e = &f->edges[i];
        if (e->low != EMPTY && (e->faces != 2 || e->balance != 0)) out->is_open[numbers[root_of(f, e->low)]] = 1;
    }
}

dm_result dmi_find_pieces(dmi_rig_model* model, const dmi_rig_mesh* mesh, dmi_mesh_pieces* out) {
    finder f = {.mesh = mesh};
    out->count = 0;
    out->faces = dmi_rig_push(model, mesh->face_count, sizeof *out->faces);
    out->is_open = dmi_rig_push(model, mesh->face_count, sizeof *out->is_open);
    f.welded = dmi_rig_push(model, mesh->point_count, sizeof *f.welded);
    f.parents = dmi_rig_push(model, mesh->point_count, sizeof *f.parents);
    uint32_t* numbers = dmi_rig_push(model, mesh->point_count, sizeof *numbers);
    if (out->faces == NULL || out->is_open == NULL || f.welded == NULL || f.parents == NULL || numbers == NULL)
        return DM_ERROR_OUT_OF_MEMORY;
    if (!weld_points(model, &f) || !add_faces(model, &f)) return DM_ERROR_OUT_OF_MEMORY;
    number_pieces(&f, numbers, out);
    return DM_OK;
}
