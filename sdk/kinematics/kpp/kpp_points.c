/* Transforms the points and computes their nearness by brute force over the whole cloud's other side. */
#include "kinematics/kpp/kpp_points.h"

#include "base/compiler.h"
#include "base/cpu.h"

#define LANES 64       /* points at a time; divides the counts of the cloud's blocks */
#define HALF_GAP 0.05f /* radii of the part: the gap at which nearness is 0.5 (docs/networks.md); by hand */

/* A cloud's coordinates, separated. */
typedef struct columns {
    float x[DMI_CLOUD_POINTS], y[DMI_CLOUD_POINTS], z[DMI_CLOUD_POINTS];
} columns;

static void split_columns(const dmi_cloud* cloud, columns* out) {
    for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++)
        out->x[i] = cloud->xyz[i][0], out->y[i] = cloud->xyz[i][1], out->z[i] = cloud->xyz[i][2];
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

/* Returns the squared distance to the nearest of `count` (a multiple of LANES) points. */
static inline float nearest_of(const columns* c, uint32_t first, uint32_t count, const float from[3]) {
    float best[LANES];
    for (int k = 0; k < LANES; k++) best[k] = INFINITY;
    for (uint32_t i = first; i < first + count; i += LANES) lower_squares(c->x + i, c->y + i, c->z + i, from, best);
    for (int k = 1; k < LANES; k++) best[0] = best[k] < best[0] ? best[k] : best[0];
    return best[0];
}

#if defined(__x86_64__)
/* Does the same operations with AVX2, without FMA, so that the result has the same bits. */
DMI_TARGET("avx2") static float nearest_avx2(const columns* c, uint32_t first, uint32_t count, const float from[3]) {
    return nearest_of(c, first, count, from);
}
#endif

static float nearest_square(const columns* c, uint32_t first, uint32_t count, const float from[3]) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return nearest_avx2(c, first, count, from);
#endif
    return nearest_of(c, first, count, from);
}

void dmi_kpp_points_make(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_kpp_frame* frame,
                         dmi_kpp_points* out) {
    static const uint32_t count[3] = {DMI_KPP_PART_POINTS, DMI_KPP_NEAR_POINTS, DMI_KPP_BODY_POINTS};
    const float(*const blocks[3])[3] = {subset->part, subset->near, subset->body};
    const float(*const normals[3])[3] = {subset->part_normals, subset->near_normals, subset->body_normals};
    columns all;
    split_columns(cloud, &all);
    uint32_t n = 0;
    for (int block = 0; block < 3; block++)
        for (uint32_t i = 0; i < count[block]; i++, n++) {
            const float* x = blocks[block][i];
            float y[3];
            dmi_kpp_frame_point_in(frame, x, y);
            for (int k = 0; k < 3; k++) out->y[k][n] = y[k];
            dmi_kpp_frame_rotate(frame, normals[block][i], out->normal[n]);
            const uint32_t other = block == 0 ? DMI_CLOUD_PART : 0;
            const float gap = nearest_square(&all, other, block == 0 ? DMI_CLOUD_NEAR : DMI_CLOUD_PART, x);
            out->nearness[n] = 1 / (1 + sqrtf(gap) * frame->scale / HALF_GAP);
        }
}
