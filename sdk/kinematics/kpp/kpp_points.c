/* Transforms the points and computes their nearness by brute force over the whole cloud's other side. */
#include "kinematics/kpp/kpp_points.h"

#include "base/compiler.h"
#include "base/cpu.h"

#define LANES 64       /* points at a time; divides COLUMN */
#define COLUMN 512     /* points whose coordinates are separated at a time; divides the counts of the cloud's blocks */
#define HALF_GAP 0.05f /* radii of the part: the gap at which nearness is 0.5 (docs/networks.md); by hand */

/* Coordinates of points, separated. */
typedef struct columns {
    float x[COLUMN], y[COLUMN], z[COLUMN];
} columns;

static void split_columns(const float (*xyz)[3], columns* out) {
    for (uint32_t i = 0; i < COLUMN; i++) out->x[i] = xyz[i][0], out->y[i] = xyz[i][1], out->z[i] = xyz[i][2];
}

/* Lowers best[k] to the squared distance from the k-th point. */
static inline void lower_squares(const float* restrict x, const float* restrict y, const float* restrict z,
                                 const float from[3], float* restrict best) {
    const float a = from[0], b = from[1], c = from[2];
    for (int k = 0; k < LANES; k++) {
        const float dx = x[k] - a, dy = y[k] - b, dz = z[k] - c;
        const float d = dx * dx + dy * dy + dz * dz;
        best[k] = d < best[k] ? d : best[k];
    }
}

/* Returns the squared distance to the nearest point. */
static inline float nearest_of(const columns* c, const float from[3]) {
    float best[LANES];
    for (int k = 0; k < LANES; k++) best[k] = INFINITY;
    for (uint32_t i = 0; i < COLUMN; i += LANES) lower_squares(c->x + i, c->y + i, c->z + i, from, best);
    for (int k = 1; k < LANES; k++) best[0] = best[k] < best[0] ? best[k] : best[0];
    return best[0];
}

#if defined(__x86_64__)
/* Does the same operations with AVX2, without FMA, so that the result has the same bits. */
DMI_TARGET("avx2") static float nearest_avx2(const columns* c, const float from[3]) {
    return nearest_of(c, from);
}
#endif

static float nearest_square(const columns* c, const float from[3]) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return nearest_avx2(c, from);
#endif
    return nearest_of(c, from);
}

/* Lowers out[i] to the squared distance of point i from the nearest of the others; other_count: a multiple of COLUMN.
 */
static void find_gaps(const float (*points)[3], uint32_t count, const float (*others)[3], uint32_t other_count,
                      float* out) {
    columns c;
    for (uint32_t i = 0; i < count; i++) out[i] = INFINITY;
    for (uint32_t first = 0; first < other_count; first += COLUMN) {
        split_columns(others + first, &c);
        for (uint32_t i = 0; i < count; i++) out[i] = dmi_min(out[i], nearest_square(&c, points[i]));
    }
}

void dmi_kpp_points_make(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_kpp_frame* frame,
                         dmi_kpp_points* out) {
    static const uint32_t count[3] = {DMI_KPP_PART_POINTS, DMI_KPP_NEAR_POINTS, DMI_KPP_BODY_POINTS};
    const float(*const blocks[3])[3] = {subset->part, subset->near, subset->body};
    const float(*const normals[3])[3] = {subset->part_normals, subset->near_normals, subset->body_normals};
    uint32_t n = 0;
    for (int block = 0; block < 3; block++) {
        const float(*others)[3] = (const float(*)[3])cloud->xyz + (block == 0 ? DMI_CLOUD_PART : 0);
        find_gaps(blocks[block], count[block], others, block == 0 ? DMI_CLOUD_NEAR : DMI_CLOUD_PART, out->nearness + n);
        for (uint32_t i = 0; i < count[block]; i++, n++) {
            const float* x = blocks[block][i];
            float y[3];
            dmi_kpp_frame_point_in(frame, x, y);
            for (int k = 0; k < 3; k++) out->y[k][n] = y[k];
            dmi_kpp_frame_rotate(frame, normals[block][i], out->normal[n]);
            out->nearness[n] = 1 / (1 + sqrtf(out->nearness[n]) * frame->scale / HALF_GAP);
        }
    }
}
