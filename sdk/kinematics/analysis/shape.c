/* Boxes, normal clusters and slippage. */
#include "kinematics/analysis/shape.h"

#include <stdlib.h>

#include "math/linear3.h"

#define FAN 96 /* directions of a half sphere */

typedef struct point2 {
    float x, y;
} point2;

static int by_x(const void* a, const void* b) {
    const point2 *p = a, *q = b;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    return p->y < q->y ? -1 : p->y > q->y;
}

static float turn2(point2 o, point2 a, point2 b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/* Andrew's monotone chain; sorts `points`, writes at most count + 1 corners. */
static uint32_t hull2(point2* points, uint32_t count, point2* out) {
    qsort(points, count, sizeof *points, by_x);
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; i++) {
        while (n >= 2 && turn2(out[n - 2], out[n - 1], points[i]) <= 0) n--;
        out[n++] = points[i];
    }
    uint32_t lower = n + 1;
    for (uint32_t i = count - 1; i-- > 0;) {
        while (n >= lower && turn2(out[n - 2], out[n - 1], points[i]) <= 0) n--;
        out[n++] = points[i];
    }
    return n > 1 ? n - 1 : n;
}

typedef struct limits2 {
    float low[2], high[2];
} limits2;

static limits2 limits_along(const point2* hull, uint32_t count, float c, float s) {
    limits2 l = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t i = 0; i < count; i++) {
        float x = c * hull[i].x + s * hull[i].y, y = c * hull[i].y - s * hull[i].x;
        l.low[0] = dmi_min(l.low[0], x), l.high[0] = dmi_max(l.high[0], x);
        l.low[1] = dmi_min(l.low[1], y), l.high[1] = dmi_max(l.high[1], y);
    }
    return l;
}

void dmi_shape_rectangle(const float (*points)[3], uint32_t count, const float direction[3], dmi_rectangle* out) {
    point2 flat[DMI_SHAPE_MAX_HULL], hull[DMI_SHAPE_MAX_HULL + 1];
    float u[3], w[3];
    dmi_perpendicular3(direction, u, w);
    for (uint32_t i = 0; i < count; i++) flat[i] = (point2){dmi_dot3(points[i], u), dmi_dot3(points[i], w)};
    uint32_t n = hull2(flat, count, hull);

    float best_area = INFINITY, best_c = 1, best_s = 0;
    limits2 best = limits_along(hull, n, 1, 0);
    for (uint32_t i = 0; i < n; i++) {
        point2 a = hull[i], b = hull[(i + 1) % n];
        float length = hypotf(b.x - a.x, b.y - a.y);
        if (length < 1e-6f) continue;
        float c = (b.x - a.x) / length, s = (b.y - a.y) / length;
        limits2 l = limits_along(hull, n, c, s);
        float area = (l.high[0] - l.low[0]) * (l.high[1] - l.low[1]);
        if (area < best_area * 0.999f) best_area = area, best = l, best_c = c, best_s = s;
    }
    for (int k = 0; k < 3; k++) {
        out->axes[0][k] = best_c * u[k] + best_s * w[k];
        out->axes[1][k] = best_c * w[k] - best_s * u[k];
    }
    memcpy(out->low, best.low, sizeof out->low);
    memcpy(out->high, best.high, sizeof out->high);
}

void dmi_shape_limits(const float (*points)[3], uint32_t count, const float axes[][3], uint32_t axis_count,
                      float* out_low, float* out_high) {
    for (uint32_t a = 0; a < axis_count; a++) {
        float low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i < count; i++) {
            float t = dmi_dot3(points[i], axes[a]);
            low = t < low ? t : low;
            high = t > high ? t : high;
        }
        out_low[a] = low, out_high[a] = high;
    }
}

/* Sorts a box's axes by the length of its sides, longest first, and makes them right-handed. */
static void order_box(dmi_box* box) {
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < 2; i++) {
            if (box->high[i] - box->low[i] >= box->high[i + 1] - box->low[i + 1]) continue;
            dmi_box old = *box;
            dmi_copy3(old.axes[i + 1], box->axes[i]), dmi_copy3(old.axes[i], box->axes[i + 1]);
            box->low[i] = old.low[i + 1], box->high[i] = old.high[i + 1];
            box->low[i + 1] = old.low[i], box->high[i + 1] = old.high[i];
        }
    float third[3];
    dmi_cross3(box->axes[0], box->axes[1], third);
    if (dmi_dot3(third, box->axes[2]) > 0) return;
    float low = box->low[2];
    for (int k = 0; k < 3; k++) box->axes[2][k] = -box->axes[2][k];
    box->low[2] = -box->high[2], box->high[2] = -low;
}

void dmi_box_centre(const dmi_box* box, float out[3]) {
    for (int k = 0; k < 3; k++) out[k] = 0;
    for (int k = 0; k < 3; k++) dmi_madd3(out, (box->high[k] + box->low[k]) / 2, box->axes[k], out);
}

void dmi_shape_box(const float (*points)[3], uint32_t count, const float (*directions)[3], uint32_t direction_count,
                   dmi_box* out) {
    float best = INFINITY;
    for (uint32_t d = 0; d < direction_count; d++) {
        dmi_rectangle r;
        dmi_box box;
        dmi_shape_rectangle(points, count, directions[d], &r);
        dmi_copy3(directions[d], box.axes[2]);
        for (int i = 0; i < 2; i++) {
            dmi_copy3(r.axes[i], box.axes[i]);
            box.low[i] = r.low[i], box.high[i] = r.high[i];
        }
        dmi_shape_limits(points, count, (const float(*)[3]) & box.axes[2], 1, &box.low[2], &box.high[2]);
        float side[3], most = 0, volume = 1;
        for (int i = 0; i < 3; i++) side[i] = box.high[i] - box.low[i], most = dmi_max(most, side[i]);
        for (int i = 0; i < 3; i++) volume *= side[i] + 1e-3f * most;
        if (volume >= best * 0.995f) continue;
        best = volume, *out = box;
    }
    order_box(out);
}

static void fan_direction(int i, float out[3]) {
    float z = ((float)i + 0.5f) / FAN, r = sqrtf(1 - z * z), angle = 2.39996323f * (float)i;
    out[0] = r * cosf(angle), out[1] = r * sinf(angle), out[2] = z;
}

#define LANES 4
#define BLOCK 1024 /* points at hand at once, coordinates apart */
#define MAX_DIRECTIONS 128

typedef float lanes __attribute__((vector_size(LANES * sizeof(float))));
typedef int32_t int_lanes __attribute__((vector_size(LANES * sizeof(int32_t))));

/* The first of the points that are farthest one way and the other. */
typedef struct extreme {
    float low, high;
    uint32_t ends[2];
} extreme;

static inline lanes load(const float* p) {
    lanes value;
    memcpy(&value, p, sizeof value);
    return value;
}

static inline int_lanes choose(int_lanes mask, int_lanes yes, int_lanes no) {
    return (mask & yes) | (~mask & no);
}

/* Goes on with a block of points that starts at index `first`. Points past its last one repeat that. */
static void extremes_along(const float (*block)[BLOCK], uint32_t count, uint32_t first, const float d[3],
                           extreme* out) {
    int_lanes place = {0, 1, 2, 3}, low_place = {0}, high_place = {0};
    lanes low = INFINITY - (lanes){0}, high = -low;
    for (uint32_t i = 0; i < count; i += LANES, place += LANES) {
        const lanes t = load(block[0] + i) * d[0] + load(block[1] + i) * d[1] + load(block[2] + i) * d[2];
        const int_lanes less = t<low, more = t> high;
        low = (lanes)choose(less, (int_lanes)t, (int_lanes)low), low_place = choose(less, place, low_place);
        high = (lanes)choose(more, (int_lanes)t, (int_lanes)high), high_place = choose(more, place, high_place);
    }
    for (int lane = 0; lane < LANES; lane++) {
        const uint32_t a = first + (uint32_t)low_place[lane], b = first + (uint32_t)high_place[lane];
        if (low[lane] < out->low || (low[lane] == out->low && a < out->ends[0])) out->low = low[lane], out->ends[0] = a;
        if (high[lane] > out->high || (high[lane] == out->high && b < out->ends[1]))
            out->high = high[lane], out->ends[1] = b;
    }
}

static void find_extremes(const float (*points)[3], uint32_t count, const float (*directions)[3], uint32_t most,
                          extreme* out) {
    float block[3][BLOCK];
    for (uint32_t d = 0; d < most; d++) out[d] = (extreme){INFINITY, -INFINITY, {UINT32_MAX, UINT32_MAX}};
    for (uint32_t first = 0; first < count; first += BLOCK) {
        const uint32_t left = count - first, size = left < BLOCK ? left : BLOCK;
        for (uint32_t i = 0; i < (size + LANES - 1) / LANES * LANES; i++)
            for (int k = 0; k < 3; k++) block[k][i] = points[first + (i < size ? i : size - 1)][k];
        for (uint32_t d = 0; d < most; d++)
            extremes_along((const float(*)[BLOCK])block, size, first, directions[d], &out[d]);
    }
}

uint32_t dmi_shape_extremes(const float (*points)[3], uint32_t count, const float (*extra)[3], uint32_t extra_count,
                            float (*out)[3]) {
    float directions[MAX_DIRECTIONS][3];
    extreme extremes[MAX_DIRECTIONS];
    uint32_t found = 0, chosen[DMI_SHAPE_MAX_HULL];
    const uint32_t most = FAN + (extra_count < MAX_DIRECTIONS - FAN ? extra_count : MAX_DIRECTIONS - FAN);
    for (uint32_t d = 0; d < most; d++) {
        if (d < FAN)
            fan_direction((int)d, directions[d]);
        else
            dmi_copy3(extra[d - FAN], directions[d]);
    }
    find_extremes(points, count, (const float(*)[3])directions, most, extremes);
    for (uint32_t d = 0; count > 0 && d < most; d++) {
        for (int e = 0; e < 2; e++) {
            uint32_t k = 0;
            while (k < found && chosen[k] != extremes[d].ends[e]) k++;
            if (k == found) chosen[found++] = extremes[d].ends[e];
        }
    }
    for (uint32_t i = 0; i < found; i++) dmi_copy3(points[chosen[i]], out[i]);
    return found;
}

#define MAX_NORMALS 1024 /* the first ones: samples come in random order */

/* Normals, coordinates apart; those already taken are zero. */
typedef struct normal_set {
    float xyz[3][MAX_NORMALS];
    uint32_t count;
} normal_set;

static float normal_cosine(const normal_set* set, uint32_t i, uint32_t j) {
    return set->xyz[0][i] * set->xyz[0][j] + set->xyz[1][i] * set->xyz[1][j] + set->xyz[2][i] * set->xyz[2][j];
}

static int is_taken(const normal_set* set, uint32_t i) {
    return set->xyz[0][i] == 0 && set->xyz[1][i] == 0 && set->xyz[2][i] == 0;
}

static void take(normal_set* set, uint32_t i) {
    for (int k = 0; k < 3; k++) set->xyz[k][i] = 0;
}

/* The normal that most others are parallel to, among every `step`th of those left. */
static uint32_t most_shared(const normal_set* set, uint32_t* out_votes) {
    uint32_t best = 0, step = set->count / 128 + 1;
    *out_votes = 0;
    for (uint32_t i = 0; i < set->count; i += step) {
        if (is_taken(set, i)) continue;
        uint32_t votes = 0;
        for (uint32_t j = 0; j < set->count; j++) votes += fabsf(normal_cosine(set, i, j)) > 0.9995f;
        if (votes > *out_votes) *out_votes = votes, best = i;
    }
    return best;
}

uint32_t dmi_shape_normal_clusters(const float (*normals)[3], uint32_t count, uint32_t most, dmi_normal_cluster* out) {
    normal_set set = {.count = count < MAX_NORMALS ? count : MAX_NORMALS};
    for (uint32_t i = 0; i < set.count; i++)
        for (int k = 0; k < 3; k++) set.xyz[k][i] = dmi_dot3(normals[i], normals[i]) > 0.5f ? normals[i][k] : 0;
    uint32_t found = 0;
    while (found < most) {
        uint32_t votes, seed = most_shared(&set, &votes);
        if (votes == 0 || (float)votes < 0.01f * (float)set.count) break;
        float mean[3] = {0, 0, 0}, taken = 0;
        for (uint32_t i = 0; i < set.count; i++) {
            float c = normal_cosine(&set, i, seed);
            if (is_taken(&set, i) || fabsf(c) < 0.985f) continue;
            if (fabsf(c) > 0.9995f) dmi_madd3(mean, c < 0 ? -1.0f : 1.0f, normals[i], mean);
            if (i != seed) take(&set, i);
            taken += 1;
        }
        take(&set, seed);
        dmi_normalize3(mean);
        dmi_copy3(mean, out[found].direction);
        out[found++].share = taken / (float)set.count;
    }
    return found;
}

/* Inverse of a symmetric positive matrix. */
static void invert3(const double m[3][3], double out[3][3]) {
    double c00 = m[1][1] * m[2][2] - m[1][2] * m[2][1], c01 = m[1][2] * m[2][0] - m[1][0] * m[2][2];
    double c02 = m[1][0] * m[2][1] - m[1][1] * m[2][0];
    double scale = 1 / (m[0][0] * c00 + m[0][1] * c01 + m[0][2] * c02);
    out[0][0] = c00 * scale, out[0][1] = out[1][0] = c01 * scale, out[0][2] = out[2][0] = c02 * scale;
    out[1][1] = (m[0][0] * m[2][2] - m[0][2] * m[2][0]) * scale;
    out[1][2] = out[2][1] = (m[0][2] * m[1][0] - m[0][0] * m[1][2]) * scale;
    out[2][2] = (m[0][0] * m[1][1] - m[0][1] * m[1][0]) * scale;
}

/* Second moments of (arm x normal, normal) over the surface, about its centre and over its radius. */
typedef struct slip_moments {
    double turn[3][3], slide[3][3], cross[3][3]; /* cross: rows slide, columns turn */
    double centre[3], radius;
} slip_moments;

static void slip_centre(const float (*points)[3], const float* weights, uint32_t count, slip_moments* m) {
    double total = 0, spread = 0;
    for (uint32_t i = 0; i < count; i++) {
        double w = weights != NULL ? weights[i] : 1;
        total += w;
        for (int k = 0; k < 3; k++) m->centre[k] += w * points[i][k];
    }
    for (int k = 0; k < 3; k++) m->centre[k] /= total;
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            double d = points[i][k] - m->centre[k];
            spread += (weights != NULL ? weights[i] : 1) * d * d;
        }
    m->radius = sqrt(spread / total) + 1e-9;
}

static void slip_gather(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                        slip_moments* m) {
    double total = 0;
    for (uint32_t i = 0; i < count; i++) total += weights != NULL ? weights[i] : 1;
    for (uint32_t i = 0; i < count; i++) {
        double w = (weights != NULL ? weights[i] : 1) / total, y[3];
        const float* n = normals[i];
        for (int k = 0; k < 3; k++) y[k] = (points[i][k] - m->centre[k]) / m->radius;
        double a[3] = {y[1] * n[2] - y[2] * n[1], y[2] * n[0] - y[0] * n[2], y[0] * n[1] - y[1] * n[0]};
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                m->turn[r][c] += w * a[r] * a[c];
                m->slide[r][c] += w * n[r] * n[c];
                m->cross[r][c] += w * n[r] * a[c];
            }
    }
}

void dmi_shape_slippage(const float (*points)[3], const float (*normals)[3], const float* weights, uint32_t count,
                        dmi_slippage* out) {
    slip_moments m = {0};
    slip_centre(points, weights, count, &m);
    slip_gather(points, normals, weights, count, &m);

    /* Least over the translation t for a given turn w: t = -B^-1 C w, which leaves w' (A - C' B^-1 C) w. */
    double damped[3][3], inverse[3][3], best[3][3], reduced[3][3], values[3];
    float vectors[3][3];
    memcpy(damped, m.slide, sizeof damped);
    for (int k = 0; k < 3; k++) damped[k][k] += 1e-4;
    invert3((const double(*)[3])damped, inverse);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            best[r][c] = 0;
            for (int k = 0; k < 3; k++) best[r][c] -= inverse[r][k] * m.cross[k][c];
        }
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            reduced[r][c] = m.turn[r][c];
            for (int k = 0; k < 3; k++) reduced[r][c] += m.cross[k][r] * best[k][c];
        }
    dmi_eigen3((const double(*)[3])reduced, values, vectors);
    for (int i = 0; i < 2; i++) {
        float t[3] = {0, 0, 0}, arm[3];
        const float* w = vectors[2 - i];
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) t[r] += (float)(best[r][c] * w[c]);
        dmi_cross3(w, t, arm);
        dmi_copy3(w, out->turn_axis[i]);
        for (int k = 0; k < 3; k++) out->turn_point[i][k] = (float)(m.centre[k] + m.radius * arm[k]);
        out->turn_residual[i] = (float)sqrt(fmax(values[2 - i], 0));
    }
    dmi_eigen3((const double(*)[3])m.slide, values, vectors);
    for (int i = 0; i < 2; i++) {
        dmi_copy3(vectors[2 - i], out->slide[i]);
        out->slide_residual[i] = (float)sqrt(fmax(values[2 - i], 0));
    }
}
