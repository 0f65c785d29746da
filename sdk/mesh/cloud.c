/* Stratified surface sampling: each sample lies in its own equal share of the area. */
#include "mesh/cloud.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/env.h"
#include "base/random.h"
#include "math/linear3.h"

/* The values are set by hand; networks are trained with them. */
#define NEAR_GROWTH 0.2f                /* growth of the part's box on each side, share of its diagonal … */
#define NEAR_MIN_GROWTH 0.02f           /* … and at least this, share of the object's size */
#define NEAR_MIN_AREA 1e-9              /* share of the object's size squared; less near area counts as none */
#define CANDIDATES (4 * DMI_CLOUD_NEAR) /* samples of which the nearest are taken when none of the rest is near */
/* A cut adds a corner for every second one at most (one to a convex polygon, but rounding may make it concave): 3
 * corners and six planes make 4, 6, 9, 13, 19, 28. */
#define MAX_CORNERS 28

/* The R2 sequence (Roberts 2018): 1 / p and 1 / p^2 with p^3 = p + 1. */
#define R2_X 0.75487767f
#define R2_Y 0.56984029f

typedef struct box {
    float low[3], high[3];
} box;

typedef struct sampler {
    const dmi_mesh* mesh;
    dmi_random random;
    uint8_t* moves;    /* a byte a part: moves with the part sampled */
    float* weights;    /* a face: its area in the block being sampled */
    double total;      /* sum of the weights */
    uint8_t* outcodes; /* a byte a vertex, for the near block */
    const box* clip;   /* samples lie in it; NULL: anywhere on the face */
} sampler;

typedef struct polygon {
    float corner[MAX_CORNERS][3];
    int count;
} polygon;

/* ---- polygons inside a box ---- */

static void load_face(const dmi_mesh* mesh, uint32_t face, polygon* out) {
    const uint32_t* index = mesh->indices + (size_t)face * 3;
    for (int i = 0; i < 3; i++) memcpy(out->corner[i], mesh->positions + (size_t)index[i] * 3, sizeof out->corner[i]);
    out->count = 3;
}

/* Clips to the side sign * x[axis] <= sign * limit (Sutherland and Hodgman). */
static void cut(polygon* p, int axis, float sign, float limit) {
    polygon in;
    in.count = p->count;
    memcpy(in.corner, p->corner, (size_t)p->count * sizeof p->corner[0]);
    p->count = 0;
    for (int i = 0; i < in.count; i++) {
        const float* a = in.corner[i];
        const float* b = in.corner[(i + 1) % in.count];
        float a_out = sign * (a[axis] - limit), b_out = sign * (b[axis] - limit);
        if (a_out <= 0) memcpy(p->corner[p->count++], a, 3 * sizeof(float));
        if ((a_out <= 0) == (b_out <= 0)) continue;
        float t = a_out / (a_out - b_out);
        float* crossing = p->corner[p->count++];
        for (int k = 0; k < 3; k++) crossing[k] = a[k] + t * (b[k] - a[k]);
        crossing[axis] = limit;
    }
}

static void cut_to_box(polygon* p, const box* box) {
    for (int k = 0; k < 3; k++) {
        cut(p, k, 1, box->high[k]);
        cut(p, k, -1, box->low[k]);
    }
}

/* Area of the fan triangle (0, i, i + 1). */
static float fan_area(const polygon* p, int i) {
    float a[3], b[3];
    for (int k = 0; k < 3; k++) {
        a[k] = p->corner[i][k] - p->corner[0][k];
        b[k] = p->corner[i + 1][k] - p->corner[0][k];
    }
    float x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return 0.5f * sqrtf(x * x + y * y + z * z);
}

static float polygon_area(const polygon* p) {
    float area = 0;
    for (int i = 1; i + 1 < p->count; i++) area += fan_area(p, i);
    return area;
}

/* ---- weights of the faces ---- */

static void weigh_moving(sampler* s, bool moving) {
    const dmi_mesh* mesh = s->mesh;
    s->total = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        s->weights[f] = s->moves[mesh->face_part[f]] == moving ? mesh->face_area[f] : 0;
        s->total += (double)s->weights[f];
    }
}

/* Computes the outcode of each vertex, a bit for each side of the box (Cohen and Sutherland). */
static void find_outcodes(sampler* s, const box* box) {
    for (uint32_t v = 0; v < s->mesh->vertex_count; v++) {
        const float* p = s->mesh->positions + (size_t)v * 3;
        unsigned code = 0;
        for (int k = 0; k < 3; k++)
            code |= (unsigned)(p[k] < box->low[k]) << k | (unsigned)(p[k] > box->high[k]) << (3 + k);
        s->outcodes[v] = (uint8_t)code;
    }
}

/* Area of the face inside the box. */
static float area_inside(const sampler* s, uint32_t face, const box* box) {
    const uint32_t* index = s->mesh->indices + (size_t)face * 3;
    unsigned a = s->outcodes[index[0]], b = s->outcodes[index[1]], c = s->outcodes[index[2]];
    if ((a | b | c) == 0) return s->mesh->face_area[face];
    if ((a & b & c) != 0) return 0;
    polygon p;
    load_face(s->mesh, face, &p);
    cut_to_box(&p, box);
    return polygon_area(&p);
}

static void weigh_near(sampler* s, const box* near) {
    const dmi_mesh* mesh = s->mesh;
    find_outcodes(s, near);
    s->total = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        const bool counts = !s->moves[mesh->face_part[f]] && mesh->face_area[f] > 0;
        s->weights[f] = counts ? area_inside(s, f, near) : 0;
        s->total += (double)s->weights[f];
    }
}

/* ---- points ---- */

/* Samples one point of a face. at: two numbers in [0, 1). */
static void sample_face(sampler* s, uint32_t face, const float at[2], float xyz[3], float normal[3]) {
    polygon p;
    load_face(s->mesh, face, &p);
    if (s->clip != NULL) cut_to_box(&p, s->clip);
    int corner = 1;
    if (p.count > 3) { /* which triangle of the fan */
        float pick = dmi_random_unit(&s->random) * polygon_area(&p);
        while (corner + 2 < p.count && pick >= fan_area(&p, corner)) pick -= fan_area(&p, corner++);
    }
    const float *a = p.corner[0], *b = p.corner[corner], *c = p.corner[corner + 1];
    float u = at[0], v = at[1];
    if (u + v > 1) { /* the other half of the parallelogram, folded back */
        u = 1 - u;
        v = 1 - v;
    }
    for (int k = 0; k < 3; k++) xyz[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
    memcpy(normal, s->mesh->face_normal + (size_t)face * 3, 3 * sizeof(float));
}

/* Returns the place in the block of the i-th of `count` (a power of two) shares of the area: its bits reversed (van der
 * Corput) and shifted at random, so that the first few samples of a block are spread as evenly as all. */
static uint32_t place_in_block(uint32_t i, uint32_t count, uint32_t shift) {
    uint32_t reversed = 0;
    for (uint32_t bit = 1, value = i; bit < count; bit <<= 1, value >>= 1) reversed = reversed << 1 | (value & 1);
    return reversed ^ (shift & (count - 1));
}

static float fraction(float x) {
    return x - floorf(x);
}

/* The next face from `face` on that has a weight; face_count when there is none. */
static uint32_t next_weighted(const sampler* s, uint32_t face) {
    while (face < s->mesh->face_count && s->weights[face] <= 0) face++;
    return face;
}

/* Draws `count` (a power of two) samples by weight, one from each of `count` equal shares of the total. The position on
 * a face follows the R2 sequence by the place in the block, so that even a few samples cover a face. */
static void sample_block(sampler* s, uint32_t count, float (*xyz)[3], float (*normal)[3]) {
    const uint32_t shift = dmi_random_u32(&s->random);
    const float start[2] = {dmi_random_unit(&s->random), dmi_random_unit(&s->random)};
    uint32_t face = next_weighted(s, 0);
    double up_to = (double)s->weights[face], share = s->total / count;
    for (uint32_t i = 0; i < count; i++) {
        double target = share * ((double)i + (double)dmi_random_unit(&s->random));
        while (target >= up_to) {
            uint32_t next = next_weighted(s, face + 1);
            if (next == s->mesh->face_count) break; /* rounding went past the last face */
            face = next;
            up_to += (double)s->weights[face];
        }
        const uint32_t place = place_in_block(i, count, shift);
        const float at[2] = {fraction(start[0] + R2_X * (float)place), fraction(start[1] + R2_Y * (float)place)};
        sample_face(s, face, at, xyz[place], normal[place]);
    }
}

/* ---- the near block ---- */

/* Returns the grown box of the moving parts. */
static box near_box(const sampler* s) {
    box out = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (uint32_t p = 0; p < s->mesh->part_count; p++) {
        const dmi_part* part = &s->mesh->parts[p];
        for (int k = 0; k < 3 && s->moves[p]; k++) {
            out.low[k] = dmi_min(out.low[k], part->box_min[k]);
            out.high[k] = dmi_max(out.high[k], part->box_max[k]);
        }
    }
    float square = 0;
    for (int k = 0; k < 3; k++) square += (out.high[k] - out.low[k]) * (out.high[k] - out.low[k]);
    float growth = dmi_max(NEAR_GROWTH * sqrtf(square), NEAR_MIN_GROWTH);
    for (int k = 0; k < 3; k++) {
        out.low[k] -= growth;
        out.high[k] += growth;
    }
    return out;
}

static float box_distance_squared(const box* box, const float p[3]) {
    float sum = 0;
    for (int k = 0; k < 3; k++) {
        float d = dmi_max(0, dmi_max(box->low[k] - p[k], p[k] - box->high[k]));
        sum += d * d;
    }
    return sum;
}

typedef struct candidates {
    float xyz[CANDIDATES][3], normal[CANDIDATES][3];
    float distance[CANDIDATES];
} candidates;

/* Returns the distance of the DMI_CLOUD_NEAR-th nearest candidate, by bisection on the bits, whose order is that of the
 * values for non-negative floats. */
static float near_limit(const candidates* c) {
    uint32_t low = 0, high = 0x7f800000; /* +infinity */
    while (low < high) {
        uint32_t middle = low + (high - low) / 2, within = 0;
        float limit;
        memcpy(&limit, &middle, sizeof limit);
        for (uint32_t i = 0; i < CANDIDATES; i++) within += c->distance[i] <= limit;
        if (within >= DMI_CLOUD_NEAR)
            high = middle;
        else
            low = middle + 1;
    }
    float limit;
    memcpy(&limit, &high, sizeof limit);
    return limit;
}

/* Fills the near block when none of the rest is near: with its samples nearest to the box. */
static dm_result sample_nearest(dmi_env* env, sampler* s, const box* near, float (*xyz)[3], float (*normal)[3]) {
    candidates* c = dmi_scratch_alloc(env, sizeof *c);
    if (c == NULL) return dmi_fail(env, DM_ERROR_OUT_OF_MEMORY, "no memory for %d surface samples", CANDIDATES);
    weigh_moving(s, false);
    sample_block(s, CANDIDATES, c->xyz, c->normal);
    for (uint32_t i = 0; i < CANDIDATES; i++) c->distance[i] = box_distance_squared(near, c->xyz[i]);
    float limit = near_limit(c);
    uint32_t taken = 0, ties = DMI_CLOUD_NEAR;
    for (uint32_t i = 0; i < CANDIDATES; i++) ties -= c->distance[i] < limit;
    for (uint32_t i = 0; i < CANDIDATES; i++) {
        if (c->distance[i] > limit || (c->distance[i] == limit && ties == 0)) continue;
        ties -= c->distance[i] == limit;
        memcpy(xyz[taken], c->xyz[i], sizeof c->xyz[i]);
        memcpy(normal[taken++], c->normal[i], sizeof c->normal[i]);
    }
    dmi_scratch_free(env, c);
    return DM_OK;
}

static dm_result sample_near(dmi_env* env, sampler* s, float (*xyz)[3], float (*normal)[3]) {
    box near = near_box(s);
    weigh_near(s, &near);
    if (s->total <= NEAR_MIN_AREA) return sample_nearest(env, s, &near, xyz, normal);
    s->clip = &near;
    sample_block(s, DMI_CLOUD_NEAR, xyz, normal);
    s->clip = NULL;
    return DM_OK;
}

/* ---- all blocks ---- */

/* Fills the other blocks with the part's samples: nothing stays when it moves. */
static void repeat_part(dmi_cloud* cloud) {
    const size_t size = sizeof(float[3]) * (DMI_CLOUD_POINTS - DMI_CLOUD_PART);
    memcpy(cloud->xyz + DMI_CLOUD_PART, cloud->xyz, size);
    memcpy(cloud->normal + DMI_CLOUD_PART, cloud->normal, size);
}

static dm_result sample_all(dmi_env* env, sampler* s, dmi_cloud* cloud) {
    enum { NEAR = DMI_CLOUD_PART, BODY = DMI_CLOUD_PART + DMI_CLOUD_NEAR };
    weigh_moving(s, true);
    sample_block(s, DMI_CLOUD_PART, cloud->xyz, cloud->normal);
    weigh_moving(s, false);
    if (s->total <= 0) {
        repeat_part(cloud);
        return DM_OK;
    }
    dm_result result = sample_near(env, s, cloud->xyz + NEAR, cloud->normal + NEAR);
    if (result != DM_OK) return result;
    weigh_moving(s, false);
    sample_block(s, DMI_CLOUD_BODY, cloud->xyz + BODY, cloud->normal + BODY);
    return DM_OK;
}

dm_result dmi_cloud_sample(dmi_env* env, const dmi_mesh* mesh, uint32_t part, uint64_t seed, dmi_cloud* out_cloud) {
    sampler s = {.mesh = mesh, .random = dmi_random_make(seed, part)};
    s.moves = dmi_scratch_alloc(env, mesh->part_count);
    s.weights = dmi_scratch_alloc(env, mesh->face_count * sizeof(float));
    s.outcodes = dmi_scratch_alloc(env, mesh->vertex_count);
    dm_result result = DM_ERROR_OUT_OF_MEMORY;
    if (s.moves != NULL && s.weights != NULL && s.outcodes != NULL) {
        for (uint32_t p = 0; p < mesh->part_count; p++) s.moves[p] = (uint8_t)dmi_mesh_moves_with(mesh, p, part);
        result = sample_all(env, &s, out_cloud);
    } else {
        dmi_fail(env, result, "no memory to sample %u triangles", mesh->face_count);
    }
    dmi_scratch_free(env, s.moves);
    dmi_scratch_free(env, s.weights);
    dmi_scratch_free(env, s.outcodes);
    return result;
}
