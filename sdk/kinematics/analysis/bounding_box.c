/* Computes rectangles of least area with the convex hull of the projected points: one side lies on a hull edge
 * (Freeman and Shapira 1975). */
#include "kinematics/analysis/bounding_box.h"

#include <float.h>
#include <stdlib.h>

#include "math/linear3.h"

#define MIN_EDGE 1e-6f       /* object sizes: shorter hull edges give no direction; by hand */
#define AREA_GAIN 0.999f     /* ratio to the least area so far below which a rectangle replaces it; by hand */
#define VOLUME_GAIN 0.995f   /* the same for the volume of boxes; by hand */
#define MIN_SIDE_SHARE 1e-3f /* share of the longest side, added to all sides so that flat boxes compare; by hand */

typedef struct point2 {
    float x, y;
} point2;

typedef struct extent2 {
    float low[2], high[2];
} extent2;

/* ---- convex hull in the plane ---- */

static int compare_points(const void* a, const void* b) {
    const point2 *p = a, *q = b;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    return p->y < q->y ? -1 : p->y > q->y;
}

/* Returns twice the signed area of the triangle o a b. */
static float orientation(point2 o, point2 a, point2 b) {
    /* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): convex_hull counts what it has written */
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/* Computes the convex hull by Andrew's monotone chain. Sorts `points`; writes at most count + 1 corners. Returns the
 * number of corners. */
static uint32_t convex_hull(point2* points, uint32_t count, point2* out) {
    qsort(points, count, sizeof *points, compare_points);
    uint32_t n = 0;
    for (uint32_t i = 0; i < count; i++) {
        while (n >= 2 && orientation(out[n - 2], out[n - 1], points[i]) <= 0) n--;
        out[n++] = points[i];
    }
    uint32_t lower = n + 1;
    for (uint32_t i = count - 1; i-- > 0;) {
        while (n >= lower && orientation(out[n - 2], out[n - 1], points[i]) <= 0) n--;
        out[n++] = points[i];
    }
    return n > 1 ? n - 1 : n;
}

/* ---- rectangle ---- */

/* Returns the extent of the hull along the axes (c, s) and (-s, c). */
static extent2 extent_along(const point2* hull, uint32_t count, float c, float s) {
    extent2 e = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t i = 0; i < count; i++) {
        float x = c * hull[i].x + s * hull[i].y, y = c * hull[i].y - s * hull[i].x;
        e.low[0] = dmi_min(e.low[0], x), e.high[0] = dmi_max(e.high[0], x);
        e.low[1] = dmi_min(e.low[1], y), e.high[1] = dmi_max(e.high[1], y);
    }
    return e;
}

void dmi_min_area_rectangle(const float (*points)[3], uint32_t count, const float direction[3], dmi_rectangle* out) {
    point2 flat[DMI_MAX_HULL_POINTS], hull[DMI_MAX_HULL_POINTS + 1];
    float u[3], w[3];
    dmi_perpendicular3(direction, u, w);
    for (uint32_t i = 0; i < count; i++) flat[i] = (point2){dmi_dot3(points[i], u), dmi_dot3(points[i], w)};
    uint32_t n = convex_hull(flat, count, hull);

    float best_area = INFINITY, best_c = 1, best_s = 0;
    extent2 best = extent_along(hull, n, 1, 0);
    for (uint32_t i = 0; i < n; i++) {
        point2 a = hull[i], b = hull[(i + 1) % n];
        float length = dmi_length2(b.x - a.x, b.y - a.y);
        if (length < MIN_EDGE) continue;
        float c = (b.x - a.x) / length, s = (b.y - a.y) / length;
        extent2 e = extent_along(hull, n, c, s);
        float area = (e.high[0] - e.low[0]) * (e.high[1] - e.low[1]);
        if (area < best_area * AREA_GAIN) best_area = area, best = e, best_c = c, best_s = s;
    }
    for (int k = 0; k < 3; k++) {
        out->axes[0][k] = best_c * u[k] + best_s * w[k];
        out->axes[1][k] = best_c * w[k] - best_s * u[k];
    }
    memcpy(out->low, best.low, sizeof out->low);
    memcpy(out->high, best.high, sizeof out->high);
}

void dmi_extents_along(const float (*points)[3], uint32_t count, const float axes[][3], uint32_t axis_count,
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

/* ---- box ---- */

/* Sorts the axes by the length of the sides, longest first, and makes them right-handed. */
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

/* Returns the volume with a small share of the longest side added to every side. */
static float padded_volume(const dmi_box* box) {
    float side[3], most = 0, volume = 1;
    for (int i = 0; i < 3; i++) side[i] = box->high[i] - box->low[i], most = dmi_max(most, side[i]);
    for (int i = 0; i < 3; i++) volume *= side[i] + MIN_SIDE_SHARE * most;
    return volume;
}

void dmi_box_centre(const dmi_box* box, float out[3]) {
    for (int k = 0; k < 3; k++) out[k] = 0;
    for (int k = 0; k < 3; k++) dmi_madd3(out, (box->high[k] + box->low[k]) / 2, box->axes[k], out);
}

float dmi_box_place(const dmi_box* box, int axis, const float point[3]) {
    const float middle = (box->low[axis] + box->high[axis]) / 2, half = (box->high[axis] - box->low[axis]) / 2;
    return (dmi_dot3(point, box->axes[axis]) - middle) / dmi_max(half, FLT_MIN);
}

void dmi_min_volume_box(const float (*points)[3], uint32_t count, const float (*directions)[3],
                        uint32_t direction_count, dmi_box* out) {
    float best = INFINITY;
    for (uint32_t d = 0; d < direction_count; d++) {
        dmi_rectangle r;
        dmi_box box;
        dmi_min_area_rectangle(points, count, directions[d], &r);
        dmi_copy3(directions[d], box.axes[2]);
        for (int i = 0; i < 2; i++) {
            dmi_copy3(r.axes[i], box.axes[i]);
            box.low[i] = r.low[i], box.high[i] = r.high[i];
        }
        dmi_extents_along(points, count, (const float(*)[3]) & box.axes[2], 1, &box.low[2], &box.high[2]);
        float volume = padded_volume(&box);
        if (volume >= best * VOLUME_GAIN) continue;
        best = volume, *out = box;
    }
    order_box(out);
}
