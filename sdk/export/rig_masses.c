/* What bodies weigh, and the boxes that stand for them in collisions.
 *
 * A piece of a mesh that closes a volume is solid. One that does not is a sheet of the stated thickness. One that
 * closes less than such a sheet would fill is the sheet too: both of its sides are modelled. */
#include <math.h>
#include <string.h>

#include "export/rig_model.h"
#include "math/elementary.h"

enum { MOST_BOXES = 64 }; /* most boxes of a body; smaller pieces have none; by hand */
static const double gravity = 9.81;
/* Least mass and size of a body, which one without triangles or with almost none has; by hand. */
static const double least_mass = 1e-3, least_radius = 1e-3;
/* Share of the largest second moment that every one has at least; by hand: engines refuse needles and sheets whose
 * inertia is rounded below that of a body. */
static const double least_spread = 1e-6;

/* Sums of a piece or a body: mass, first and second moments about an origin. */
typedef struct moments {
    double mass, first[3], second[3][3];
} moments;

typedef struct piece {
    moments solid, sheet; /* sums for density and thickness 1; those of the sheet lack the spread of its thickness */
    double low[3], high[3];
} piece;

/* ---- closed pieces of a mesh ---- */

typedef struct mesh_pieces {
    uint32_t* faces;  /* piece of each face */
    uint8_t* is_open; /* per piece: 1 when it has an edge at which not one face goes each way */
    uint32_t count;
} mesh_pieces;

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
static void number_pieces(finder* f, uint32_t* numbers, mesh_pieces* out) {
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

/* Finds the pieces, in memory of the model. */
static dm_result find_pieces(dmi_rig_model* model, const dmi_rig_mesh* mesh, mesh_pieces* out) {
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

/* ---- masses ---- */

static void cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Adds a simplex of uniform mass with corners p, and with the origin as one more where `corners` is 4: the integrals of
 * 1, x and x y over it. */
static void add_simplex(moments* out, double mass, const double p[3][3], int corners) {
    double sum[3];
    for (int k = 0; k < 3; k++) sum[k] = p[0][k] + p[1][k] + p[2][k];
    const double pairs = corners * (corners + 1);
    out->mass += mass;
    for (int i = 0; i < 3; i++) {
        out->first[i] += mass / corners * sum[i];
        for (int j = 0; j < 3; j++)
            out->second[i][j] +=
                mass / pairs * (sum[i] * sum[j] + p[0][i] * p[0][j] + p[1][i] * p[1][j] + p[2][i] * p[2][j]);
    }
}

/* Adds a triangle to its piece. place: the mesh's in the body's frame. */
static void add_face(const dmi_rig_mesh* mesh, const double place[3], uint32_t face, double thickness, piece* out) {
    enum { TRIANGLE = 3, TETRAHEDRON = 4, SIX = 6 };
    static const double uniform_spread = 1.0 / 12; /* variance of a sheet of thickness 1 across itself */
    double p[3][3], u[3], v[3], normal[3];
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            p[c][k] = (double)mesh->points[mesh->faces[face][c]][k] + place[k];
            out->low[k] = dmi_fmin(out->low[k], p[c][k]);
            out->high[k] = dmi_fmax(out->high[k], p[c][k]);
        }
    for (int k = 0; k < 3; k++) {
        u[k] = p[1][k] - p[0][k];
        v[k] = p[2][k] - p[0][k];
    }
    cross(u, v, normal);
    const double twice = sqrt(dot(normal, normal)), area = twice / 2;
    add_simplex(&out->sheet, area, (const double(*)[3])p, TRIANGLE);
    for (int i = 0; i < 3 && twice > 0; i++)
        for (int j = 0; j < 3; j++)
            out->sheet.second[i][j] +=
                area * uniform_spread * thickness * thickness * normal[i] / twice * normal[j] / twice;
    cross(p[1], p[2], normal);
    add_simplex(&out->solid, dot(p[0], normal) / SIX, (const double(*)[3])p, TETRAHEDRON);
}

static void add_moments(moments* out, const moments* from, double factor) {
    out->mass += factor * from->mass;
    for (int i = 0; i < 3; i++) {
        out->first[i] += factor * from->first[i];
        for (int j = 0; j < 3; j++) out->second[i][j] += factor * from->second[i][j];
    }
}

/* Returns whether the middle of what a closed piece encloses is in its box. For a piece that crosses itself it may be
 * anywhere. */
static bool encloses(const piece* p) {
    bool inside = p->solid.mass != 0;
    for (int k = 0; k < 3 && inside; k++) {
        const double middle = p->solid.first[k] / p->solid.mass;
        inside = middle >= p->low[k] && middle <= p->high[k] && p->solid.second[k][k] / p->solid.mass >= 0;
    }
    return inside;
}

/* Adds a piece to its body, as solid or as sheet. */
static void add_piece(const dmi_rig_values* values, const piece* from, bool is_open, moments* out) {
    const double volume = fabs(from->solid.mass), sheet = from->sheet.mass / (is_open ? 1 : 2) * values->thickness;
    if (!is_open && volume >= sheet && encloses(from))
        add_moments(out, &from->solid, from->solid.mass < 0 ? -values->density : values->density);
    else
        add_moments(out, &from->sheet, values->density * values->thickness / (is_open ? 1 : 2));
}

static dmi_rig_box box_of(const piece* from, double thickness) {
    dmi_rig_box box;
    for (int k = 0; k < 3; k++) {
        box.centre[k] = (from->low[k] + from->high[k]) / 2;
        box.half[k] = dmi_fmax((from->high[k] - from->low[k]) / 2, thickness / 2);
    }
    return box;
}

static double volume_of(const dmi_rig_box* box) {
    return box->half[0] * box->half[1] * box->half[2];
}

/* Keeps a box among the largest of its body. */
static void keep_box(dmi_rig_box* boxes, uint32_t* count, const dmi_rig_box* box) {
    if (*count < MOST_BOXES) {
        boxes[(*count)++] = *box;
        return;
    }
    uint32_t least = 0;
    for (uint32_t i = 1; i < MOST_BOXES; i++)
        if (volume_of(&boxes[i]) < volume_of(&boxes[least])) least = i;
    if (volume_of(&boxes[least]) < volume_of(box)) boxes[least] = *box;
}

static dm_result add_shape(dmi_rig_model* model, const dmi_rig_shape* shape, moments* out, dmi_rig_body* body) {
    const dmi_rig_mesh* mesh = &model->meshes[shape->mesh];
    const dmi_arena_mark mark = dmi_arena_get_mark(&model->arena);
    mesh_pieces pieces;
    dm_result result = find_pieces(model, mesh, &pieces);
    piece* list = result == DM_OK ? dmi_rig_push(model, pieces.count, sizeof *list) : NULL;
    if (list == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t i = 0; i < pieces.count; i++)
        list[i] = (piece){.low = {INFINITY, INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY, -INFINITY}};
    for (uint32_t f = 0; f < mesh->face_count; f++)
        add_face(mesh, shape->place, f, model->values.thickness, &list[pieces.faces[f]]);
    for (uint32_t i = 0; i < pieces.count; i++) {
        const dmi_rig_box box = box_of(&list[i], model->values.thickness);
        add_piece(&model->values, &list[i], pieces.is_open[i], out);
        keep_box(model->boxes + body->first_box, &body->box_count, &box);
    }
    dmi_arena_rewind(&model->arena, mark);
    return DM_OK;
}

/* Returns whether a symmetric matrix has positive eigenvalues alone, by Sylvester's criterion. */
static bool is_positive(const double m[3][3]) {
    double normal[3];
    cross(m[1], m[2], normal);
    return m[0][0] > 0 && m[0][0] * m[1][1] > m[0][1] * m[1][0] && dot(m[0], normal) > 0;
}

/* Writes mass, centre and inertia. Moments that no body can have, such as those of pieces that cross themselves, keep
 * their trace. */
static void weigh_body(const moments* sums, dmi_rig_body* body) {
    double spread[3][3], trace = 0;
    const bool has_mass = sums->mass > 0;
    for (int k = 0; k < 3; k++) body->centre[k] = has_mass ? sums->first[k] / sums->mass : 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            spread[i][j] = has_mass ? sums->second[i][j] / sums->mass - body->centre[i] * body->centre[j] : 0;
    for (int i = 0; i < 3; i++) spread[i][i] += least_radius * least_radius;
    for (int i = 0; i < 3; i++) trace += fabs(spread[i][i]);
    const bool is_body = is_positive((const double(*)[3])spread);
    for (int i = 0; i < 3 && !is_body; i++)
        for (int j = 0; j < 3; j++) spread[i][j] = i == j ? trace / 3 : 0;
    for (int i = 0; i < 3; i++) spread[i][i] += least_spread * trace;
    body->mass = dmi_fmax(sums->mass, least_mass);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            body->inertia[i][j] = body->mass * ((i == j ? trace * (1 + 3 * least_spread) : 0) - spread[i][j]);
}

/* Sets what holds the body back. A hinge is held at the radius of gyration about its line. */
static void set_resistance(const dmi_rig_values* values, dmi_rig_body* body) {
    double turned[3], lever[3];
    cross(body->axis, body->centre, lever);
    for (int i = 0; i < 3; i++) turned[i] = dot(body->inertia[i], body->axis);
    const bool turns = dmi_rig_turns(body);
    const double resisting = turns ? dot(body->axis, turned) + body->mass * dot(lever, lever) : body->mass;
    const double radius = turns ? sqrt(resisting / body->mass) : 1;
    body->damping = values->damping_time > 0 ? resisting / values->damping_time : 0;
    body->friction = values->friction * body->mass * gravity * radius;
}

dm_result dmi_rig_make_masses(dmi_rig_model* model) {
    model->boxes = dmi_rig_push(model, (size_t)model->body_count * MOST_BOXES, sizeof *model->boxes);
    if (model->boxes == NULL) return DM_ERROR_OUT_OF_MEMORY;
    for (uint32_t b = 0; b < model->body_count; b++) {
        dmi_rig_body* body = &model->bodies[b];
        moments sums = {.mass = 0};
        body->first_box = model->box_count;
        for (uint32_t i = 0; i < body->shape_count; i++) {
            const dm_result result = add_shape(model, &model->shapes[body->first_shape + i], &sums, body);
            if (result != DM_OK) return result;
        }
        model->box_count += body->box_count;
        weigh_body(&sums, body);
        set_resistance(&model->values, body);
    }
    return DM_OK;
}
