/* Finds a bound on the group's distances in a loop that vectorises, then sorts only the points within it. */
#include "kinematics/kpp/kpp_input.h"

#include <math.h>
#include <stdbool.h>

#include "base/compiler.h"
#include "base/cpu.h"

#define LANES DMI_FPS_POINT_STEP

void dmi_fps_begin(const float* x, const float* y, const float* z, uint32_t count, dmi_fps* out) {
    out->x = x, out->y = y, out->z = z, out->count = count;
    for (uint32_t i = 0; i < count; i++) out->min_square[i] = INFINITY;
}

/* Computes squared distances of LANES points from the centre, and lowers `least` of each lane to them. */
static inline void distances_of_lanes(const float* restrict x, const float* restrict y, const float* restrict z,
                                      const float centre[3], float* restrict distance, float* restrict least) {
    const float a = centre[0], b = centre[1], c = centre[2];
    for (int k = 0; k < LANES; k++) {
        const float dx = x[k] - a, dy = y[k] - b, dz = z[k] - c;
        const float d = dx * dx + dy * dy + dz * dz;
        distance[k] = d;
        least[k] = d < least[k] ? d : least[k];
    }
}

static inline void squared_distances(const dmi_fps* g, uint32_t centre, float* distance, float least[LANES]) {
    const float from[3] = {g->x[centre], g->y[centre], g->z[centre]};
    for (int k = 0; k < LANES; k++) least[k] = INFINITY;
    for (uint32_t i = 0; i < g->count; i += LANES)
        distances_of_lanes(g->x + i, g->y + i, g->z + i, from, distance + i, least);
}

/* Returns the DMI_KPP_GROUP-th smallest of the lanes' least distances: a bound within which at least DMI_KPP_GROUP
 * points lie, and few more. */
static inline float bound_of(const float least[LANES]) {
    int32_t smaller[LANES] = {0};
    float limit = 0;
    for (int l = 0; l < LANES; l++)
        for (int k = 0; k < LANES; k++) smaller[k] += least[l] < least[k];
    for (int l = 0; l < LANES; l++) limit = smaller[l] < DMI_KPP_GROUP && least[l] > limit ? least[l] : limit;
    return limit;
}

static inline bool any_within(const float* restrict distance, float limit) {
    int32_t any = 0;
    for (int k = 0; k < LANES; k++) any |= distance[k] <= limit;
    return any;
}

/* Finds the DMI_KPP_GROUP nearest points within the limit by insertion sort; `self` comes first. */
static inline void find_nearest(const float* distance, uint32_t count, float limit, uint32_t self,
                                uint32_t out[DMI_KPP_GROUP]) {
    float best[DMI_KPP_GROUP];
    uint32_t filled = 1;
    for (int m = 0; m < DMI_KPP_GROUP; m++) best[m] = -1, out[m] = self;
    for (uint32_t first = 0; first < count; first += LANES) {
        if (!any_within(distance + first, limit)) continue;
        for (uint32_t i = first; i < first + LANES; i++) {
            const float d = distance[i];
            if (d > limit || i == self || (filled == DMI_KPP_GROUP && d >= best[DMI_KPP_GROUP - 1])) continue;
            uint32_t at = filled < DMI_KPP_GROUP ? filled++ : DMI_KPP_GROUP - 1;
            for (; best[at - 1] > d; at--) best[at] = best[at - 1], out[at] = out[at - 1];
            best[at] = d, out[at] = i;
        }
    }
}

/* Lowers min_square of LANES points to the distances from the new centre, and raises `most` of each lane to it. */
static inline void update_some(const float* restrict distance, float* restrict min_square, float* restrict most) {
    for (int k = 0; k < LANES; k++) {
        const float d = distance[k] < min_square[k] ? distance[k] : min_square[k];
        min_square[k] = d;
        most[k] = d > most[k] ? d : most[k];
    }
}

static inline bool any_from(const float* restrict min_square, float most) {
    int32_t any = 0;
    for (int k = 0; k < LANES; k++) any |= min_square[k] >= most;
    return any;
}

/* Updates min_square for the new centre. Returns the first of the points that are farthest from all centres. */
static inline uint32_t find_farthest(const float* distance, uint32_t count, float* min_square) {
    float most[LANES] = {0};
    for (uint32_t i = 0; i < count; i += LANES) update_some(distance + i, min_square + i, most);
    for (int k = 1; k < LANES; k++) most[0] = most[k] > most[0] ? most[k] : most[0];
    uint32_t at = 0;
    while (at + LANES < count && !any_from(min_square + at, most[0])) at += LANES;
    while (at + 1 < count && min_square[at] < most[0]) at++;
    return at;
}

static inline uint32_t next_of(dmi_fps* g, uint32_t centre, uint32_t out_members[DMI_KPP_GROUP]) {
    float distance[DMI_KPP_POINTS], least[LANES];
    squared_distances(g, centre, distance, least);
    find_nearest(distance, g->count, bound_of(least), centre, out_members);
    return find_farthest(distance, g->count, g->min_square);
}

#if defined(__x86_64__)
/* Does the same operations with AVX2, without FMA, so that the result has the same bits. */
DMI_TARGET("avx2")
DMI_FLATTEN static uint32_t next_avx2(dmi_fps* g, uint32_t centre, uint32_t out_members[DMI_KPP_GROUP]) {
    return next_of(g, centre, out_members);
}
#endif

uint32_t dmi_fps_next(dmi_fps* sampling, uint32_t centre, uint32_t out_members[DMI_KPP_GROUP]) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return next_avx2(sampling, centre, out_members);
#endif
    return next_of(sampling, centre, out_members);
}
