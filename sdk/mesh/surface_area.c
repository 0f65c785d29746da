/* Clips faces to a box and sums their areas. */
#include "mesh/surface_samples.h"

#include <math.h>
#include <string.h>

/* A cut adds a corner for every second one at most (one to a convex polygon, but rounding may make it concave): 3
 * corners and six planes make 4, 6, 9, 13, 19, 28. */
#define MAX_CORNERS 28

typedef struct polygon {
    float corner[MAX_CORNERS][3];
    int count;
} polygon;

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

static void cut_to_box(polygon* p, const dmi_bounds* box) {
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

/* Returns a bit for each side of the box that a vertex is beyond (Cohen and Sutherland). */
static unsigned outcode_of(const float* p, const dmi_bounds* box) {
    unsigned code = 0;
    for (int k = 0; k < 3; k++)
        code |= (unsigned)(p[k] < box->low[k]) << k | (unsigned)(p[k] > box->high[k]) << (3 + k);
    return code;
}

static float area_of_face(const dmi_mesh* mesh, uint32_t face, const dmi_bounds* box) {
    unsigned all = ~0u, any = 0;
    for (int i = 0; i < 3; i++) {
        const unsigned code =
            outcode_of(mesh->positions + (size_t)mesh->indices[(size_t)face * 3 + (size_t)i] * 3, box);
        all &= code, any |= code;
    }
    if (any == 0) return mesh->face_area[face];
    if (all != 0) return 0;
    polygon p;
    load_face(mesh, face, &p);
    cut_to_box(&p, box);
    return polygon_area(&p);
}

double dmi_area_inside(const dmi_mesh* mesh, const uint8_t* wanted, const dmi_bounds* box) {
    double sum = 0;
    for (uint32_t f = 0; f < mesh->face_count; f++)
        if (wanted[mesh->face_part[f]] && mesh->face_area[f] > 0) sum += (double)area_of_face(mesh, f, box);
    return sum;
}
