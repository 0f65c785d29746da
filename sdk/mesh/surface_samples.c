/* Samples surfaces where the lines of a jittered lattice meet them. */
#include "mesh/surface_samples.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/env.h"
#include "math/linear3.h"
#include "math/place_hash.h"

/* The values are set by hand. */
#define WANTED_HITS 1.5f /* hits a sample that a lattice is laid for; by hand: 3 gave no better answers (measured) */
#define MOST_HITS 5      /* hits a sample that there is memory for */
#define TRIES 8          /* lattices that are laid at most; each has twice or half the lines of the one before */
#define FINEST 4096      /* lines across the longest side of the surface's box at most */
#define MOST_ROWS 8e6    /* rows of cells that faces lie in, summed over the faces: about a tenth of a second */
#define FEW_CELLS 4      /* cells that a small face's box covers at most: all are tried, none is computed */
#define STEEPEST 1e-4f   /* component of a normal below which no line along that axis meets the face */

/* Bits of each coordinate in a hit's key, of the chance below them, and of one pass of the sort. */
enum { KEY_BITS = 10, CHANCE_BITS = 18, RADIX_BITS = 8, PASSES = (3 * KEY_BITS + CHANCE_BITS) / RADIX_BITS };

typedef struct hit {
    uint64_t key; /* place along a Morton curve through the box, then chance */
    uint32_t face;
    float at[3];
} hit;

typedef struct lattice {
    const dmi_surface* surface;
    dmi_bounds box; /* the surface's box */
    uint64_t seed;
    float spacing, per_spacing; /* per_spacing = 1 / spacing */
    float per_side;             /* 1 / the box's longest side */
    hit* hits;
    uint32_t count, capacity; /* count > capacity: there are too many to keep, and some are not counted */
} lattice;

/* ---- chance that belongs to a place ---- */

/* Returns the chance of the line in a cell: 21 bits each for its two coordinates there and for whether hits are kept.
 */
static uint64_t chance_of_line(uint64_t side_seed, int32_t row, int32_t column) {
    return dmi_scramble(side_seed ^ ((uint64_t)(uint32_t)row << 32 | (uint32_t)column));
}

static float unit_of(uint64_t bits) {
    return (float)(bits & 0x1fffff) * (1.0f / 2097152); /* literal: 21 bits */
}

/* Returns the bits of a number of KEY_BITS bits with two zeros between each and the next. */
static uint64_t spread_bits(uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

static uint64_t key_of(const lattice* l, const float at[3], uint64_t chance) {
    uint64_t place[3];
    for (int k = 0; k < 3; k++) {
        const float share = dmi_clamp((at[k] - l->box.low[k]) * l->per_side, 0, 1);
        place[k] = spread_bits((uint32_t)(share * ((1 << KEY_BITS) - 1)));
    }
    return (place[0] << 2 | place[1] << 1 | place[2]) << CHANCE_BITS | (chance & ((1 << CHANCE_BITS) - 1));
}

/* ---- lines that meet a face ---- */

typedef struct face_shape {
    uint32_t face;
    const float* corner[3];
    const float* normal;
    float low[3], high[3]; /* the face's box */
    int axis, b, c;        /* the lines' axis, and the two across it */
    float kept;            /* share of the hits that are kept */
    uint64_t side_seed;    /* seed of the lines that come from the face's side */
} face_shape;

static double turn_of(const face_shape* f, const float* p, const float* q, double b, double c) {
    return ((double)q[f->b] - (double)p[f->b]) * (c - (double)p[f->c]) -
           ((double)q[f->c] - (double)p[f->c]) * (b - (double)p[f->b]);
}

static void add_hit(lattice* l, const face_shape* f, float b, float c, uint64_t chance) {
    double weight[3], sum = 0; /* twice the areas between the line and the face's edges, of one sign inside the face */
    for (int i = 0; i < 3; i++) {
        weight[i] = turn_of(f, f->corner[(i + 1) % 3], f->corner[(i + 2) % 3], (double)b, (double)c);
        sum += weight[i];
    }
    for (int i = 0; i < 3; i++)
        if (sum == 0 || (sum > 0 ? weight[i] < 0 : weight[i] > 0)) return;
    float at[3];
    at[f->b] = b, at[f->c] = c, at[f->axis] = 0;
    for (int i = 0; i < 3; i++) at[f->axis] += (float)(weight[i] / sum * (double)f->corner[i][f->axis]);
    const dmi_bounds* clip = l->surface->clip;
    for (int k = 0; clip != NULL && k < 3; k++)
        if (at[k] < clip->low[k] || at[k] > clip->high[k]) return;
    if (l->count < l->capacity) {
        hit* h = &l->hits[l->count];
        *h = (hit){key_of(l, at, chance), f->face, {at[0], at[1], at[2]}};
    }
    l->count++;
}

/* Meets the face with the line of a cell. */
static void meet_cell(lattice* l, const face_shape* f, int32_t row, int32_t column) {
    const uint64_t chance = chance_of_line(f->side_seed, row, column);
    const float b = l->box.low[f->b] + ((float)row + unit_of(chance)) * l->spacing;
    const float c = l->box.low[f->c] + ((float)column + unit_of(chance >> 21)) * l->spacing;
    const int kept = unit_of(chance >> 42) < f->kept; /* literal: the upper 21 of 63 bits */
    /* One branch for all: each alone is hard to predict. */
    if (kept & (b >= f->low[f->b]) & (b <= f->high[f->b]) & (c >= f->low[f->c]) & (c <= f->high[f->c]))
        add_hit(l, f, b, c, dmi_scramble(chance));
}

/* Computes between which c the face is while b is in [low, high]. Returns false when it is nowhere. */
static bool span_of_row(const face_shape* f, float low, float high, float* out_low, float* out_high) {
    *out_low = FLT_MAX, *out_high = -FLT_MAX;
    for (int i = 0; i < 3; i++) {
        const float *p = f->corner[i], *q = f->corner[(i + 1) % 3];
        const float from = dmi_min(p[f->b], q[f->b]), to = dmi_max(p[f->b], q[f->b]);
        if (to < low || from > high) continue;
        const float slope = to > from ? (q[f->c] - p[f->c]) / (q[f->b] - p[f->b]) : 0;
        for (int end = 0; end < 2; end++) {
            const float* corner = end ? q : p;
            const float limit = dmi_clamp(corner[f->b], low, high);
            const float c = limit == corner[f->b] ? corner[f->c] : p[f->c] + slope * (limit - p[f->b]);
            *out_low = dmi_min(*out_low, c), *out_high = dmi_max(*out_high, c);
        }
    }
    return *out_low <= *out_high;
}

/* Returns the cell of a coordinate inside the surface's box, -1 below it, the last one above. */
static int32_t cell_of(const lattice* l, int axis, float at) {
    const float high = dmi_min(at, l->box.high[axis]) - l->box.low[axis];
    return high < 0 ? -1 : (int32_t)(high * l->per_spacing);
}

/* Meets the face with the lines of a row of cells. */
static void meet_row(lattice* l, const face_shape* f, int32_t row) {
    float low, high;
    const float first = l->box.low[f->b], step = l->spacing;
    if (!span_of_row(f, first + (float)row * step, first + (float)(row + 1) * step, &low, &high)) return;
    const int32_t last = cell_of(l, f->c, high);
    for (int32_t column = cell_of(l, f->c, low); column <= last; column++) meet_cell(l, f, row, column);
}

/* Meets the face with the lines along its axis. Of a few cells, all are tried. */
static void meet_lines(lattice* l, const face_shape* f) {
    const int32_t row = cell_of(l, f->b, f->low[f->b]), last_row = cell_of(l, f->b, f->high[f->b]);
    const int32_t column = cell_of(l, f->c, f->low[f->c]), last_column = cell_of(l, f->c, f->high[f->c]);
    const bool is_small = (last_row - row + 1) * ((int64_t)last_column - column + 1) <= FEW_CELLS;
    for (int32_t r = row; r <= last_row; r++) {
        if (is_small)
            for (int32_t c = column; c <= last_column; c++) meet_cell(l, f, r, c);
        else
            meet_row(l, f, r);
    }
}

static bool is_outside(const face_shape* f, const dmi_bounds* clip) {
    for (int k = 0; k < 3; k++)
        if (f->high[k] < clip->low[k] || f->low[k] > clip->high[k]) return true;
    return false;
}

static void meet_face(lattice* l, uint32_t face) {
    const dmi_mesh* mesh = l->surface->mesh;
    face_shape f = {.face = face, .normal = mesh->face_normal + (size_t)face * 3};
    for (int i = 0; i < 3; i++) f.corner[i] = mesh->positions + (size_t)mesh->indices[(size_t)face * 3 + (size_t)i] * 3;
    for (int k = 0; k < 3; k++) {
        f.low[k] = dmi_min(f.corner[0][k], dmi_min(f.corner[1][k], f.corner[2][k]));
        f.high[k] = dmi_max(f.corner[0][k], dmi_max(f.corner[1][k], f.corner[2][k]));
    }
    if (l->surface->clip != NULL && is_outside(&f, l->surface->clip)) return;
    f.kept = 1 / (fabsf(f.normal[0]) + fabsf(f.normal[1]) + fabsf(f.normal[2]));
    for (f.axis = 0; f.axis < 3; f.axis++) {
        if (fabsf(f.normal[f.axis]) < STEEPEST) continue;
        f.b = (f.axis + 1) % 3, f.c = (f.axis + 2) % 3;
        f.side_seed = dmi_scramble(l->seed ^ (uint64_t)(2 * f.axis + (f.normal[f.axis] > 0)));
        meet_lines(l, &f);
    }
}

static bool is_wanted(const dmi_surface* s, uint32_t face) {
    return s->wanted[s->mesh->face_part[face]] && s->mesh->face_area[face] > 0;
}

/* ---- a lattice of the right spacing ---- */

static dmi_bounds box_of(const dmi_surface* s) {
    dmi_bounds out = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (uint32_t p = 0; p < s->mesh->part_count; p++)
        for (int k = 0; k < 3 && s->wanted[p]; k++) {
            out.low[k] = dmi_min(out.low[k], s->mesh->parts[p].box_min[k]);
            out.high[k] = dmi_max(out.high[k], s->mesh->parts[p].box_max[k]);
        }
    for (int k = 0; k < 3 && s->clip != NULL; k++) {
        out.low[k] = dmi_max(out.low[k], s->clip->low[k]);
        out.high[k] = dmi_max(out.low[k], dmi_min(out.high[k], s->clip->high[k]));
    }
    return out;
}

/* Returns a positive number rounded down to five binary digits: sums of areas differ in their last digits with the
 * order of the faces, and the lattice must not. */
static float round_down(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    bits &= 0xfff80000u; /* literal: sign, exponent, and four digits after the leading one */
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void meet_surface(lattice* l) {
    const dmi_surface* s = l->surface;
    l->count = 0;
    l->per_spacing = 1 / l->spacing;
    for (uint32_t f = 0; f < s->mesh->face_count && l->count <= l->capacity; f++)
        if (is_wanted(s, f)) meet_face(l, f);
}

/* Returns the sum of the sides of all faces' boxes, by which the work of a lattice grows. */
static double sum_of_extents(const dmi_surface* s) {
    double sum = 0;
    for (uint32_t f = 0; f < s->mesh->face_count; f++) {
        if (!is_wanted(s, f)) continue;
        const uint32_t* corner = s->mesh->indices + (size_t)f * 3;
        for (int k = 0; k < 3; k++) {
            const float a = s->mesh->positions[(size_t)corner[0] * 3 + (size_t)k];
            const float b = s->mesh->positions[(size_t)corner[1] * 3 + (size_t)k];
            const float c = s->mesh->positions[(size_t)corner[2] * 3 + (size_t)k];
            sum += (double)(dmi_max(a, dmi_max(b, c)) - dmi_min(a, dmi_min(b, c)));
        }
    }
    return sum;
}

/* Lays lattices until one has enough hits, or none finer is allowed. */
static void lay_lattice(lattice* l, uint32_t count) {
    float longest = FLT_MIN;
    for (int k = 0; k < 3; k++) longest = dmi_max(longest, l->box.high[k] - l->box.low[k]);
    l->per_side = 1 / longest;
    const double rows = sum_of_extents(l->surface) / MOST_ROWS;
    const float finest = round_down(dmi_max(longest / FINEST, (float)rows) + FLT_MIN);
    l->spacing = round_down((float)sqrt(l->surface->area / (WANTED_HITS * (double)count)) + FLT_MIN);
    for (int i = 0; i < TRIES; i++) {
        l->spacing = dmi_max(l->spacing, finest);
        meet_surface(l);
        if (l->count > l->capacity)
            l->spacing *= 1.41421356f;
        else if (l->count < count && l->spacing > finest)
            l->spacing *= 0.5f;
        else
            break;
    }
    if (l->count > l->capacity) l->count = l->capacity;
}

/* ---- samples among the hits ---- */

/* Sorts by key, digit by digit, to and fro between the two arrays: an even number of times, so that the hits end where
 * they were. */
static void sort_hits(hit* hits, hit* spare, uint32_t count) {
    _Static_assert(PASSES % 2 == 0, "the hits end in the spare array");
    for (unsigned pass = 0; pass < PASSES; pass++) {
        const unsigned shift = pass * RADIX_BITS, mask = (1 << RADIX_BITS) - 1;
        hit *from = pass % 2 ? spare : hits, *to = pass % 2 ? hits : spare;
        uint32_t start[(1 << RADIX_BITS) + 1] = {0};
        for (uint32_t i = 0; i < count; i++) start[(from[i].key >> shift & mask) + 1]++;
        for (int d = 0; d < 1 << RADIX_BITS; d++) start[d + 1] += start[d];
        for (uint32_t i = 0; i < count; i++) to[start[from[i].key >> shift & mask]++] = from[i];
    }
}

/* Returns the place of the i-th of `count` (a power of two) samples along the curve: its bits reversed (van der Corput)
 * and shifted at random. */
static uint32_t place_of(uint32_t i, uint32_t count, uint32_t shift) {
    uint32_t reversed = 0;
    for (uint32_t bit = 1, value = i; bit < count; bit <<= 1, value >>= 1) reversed = reversed << 1 | (value & 1);
    return reversed ^ (shift & (count - 1));
}

static void take_samples(const lattice* l, uint32_t count, float (*xyz)[3], float (*normal)[3]) {
    const uint32_t shift = (uint32_t)dmi_scramble(l->seed);
    for (uint32_t i = 0; i < count; i++) {
        const uint64_t spread = ((uint64_t)2 * i + 1) * l->count / (2 * (uint64_t)count);
        const hit* h = &l->hits[spread];
        const uint32_t place = place_of(i, count, shift);
        dmi_copy3(h->at, xyz[place]);
        dmi_copy3(l->surface->mesh->face_normal + (size_t)h->face * 3, normal[place]);
    }
}

/* Puts a corner of the largest face as the only hit: no line meets the surface. */
static void hit_largest_face(lattice* l) {
    const dmi_surface* s = l->surface;
    uint32_t best = UINT32_MAX;
    for (uint32_t f = 0; f < s->mesh->face_count; f++)
        if (is_wanted(s, f) && (best == UINT32_MAX || s->mesh->face_area[f] > s->mesh->face_area[best])) best = f;
    const uint32_t face = best == UINT32_MAX ? 0 : best;
    l->hits[0] = (hit){.face = face};
    dmi_copy3(s->mesh->positions + (size_t)s->mesh->indices[(size_t)face * 3] * 3, l->hits[0].at);
    l->count = 1;
}

dm_result dmi_surface_sample(dmi_env* env, const dmi_surface* surface, uint64_t seed, uint32_t count,
                             float (*out_xyz)[3], float (*out_normal)[3]) {
    lattice l = {.surface = surface, .box = box_of(surface), .seed = dmi_scramble(seed), .capacity = MOST_HITS * count};
    const size_t size = 2 * (size_t)l.capacity * sizeof *l.hits;
    l.hits = dmi_scratch_alloc(env, size);
    if (l.hits == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %u surface samples", count);
    lay_lattice(&l, count);
    if (l.count == 0) hit_largest_face(&l);
    sort_hits(l.hits, l.hits + l.capacity, l.count);
    take_samples(&l, count, out_xyz, out_normal);
    dmi_scratch_free(env, l.hits);
    return DM_OK;
}
