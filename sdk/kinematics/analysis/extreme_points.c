/* Projects blocks of points onto all directions, several points at a time. */
#include "kinematics/analysis/analysis_steps.h"

#include "base/compiler.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define FIXED_DIRECTIONS 96      /* directions over the half sphere; by hand */
#define MAX_DIRECTIONS 128       /* fixed and extra ones; by hand */
#define GOLDEN_ANGLE 2.39996323f /* radians, pi (3 - sqrt 5): step of the Fibonacci lattice on the sphere */
#define TILT 1e-4f               /* part of another way that is added to a direction; by hand */
#define LANES 4                  /* points at a time */
#define BLOCK 1024               /* points copied at a time, coordinates separated: fits a level 1 cache; by hand */

typedef DMI_VECTOR(float, LANES) lanes;
typedef DMI_VECTOR(int32_t, LANES) int_lanes;

/* Extent along a direction, and the first points that reach its two ends. */
typedef struct extreme {
    float low, high;
    uint32_t ends[2];
} extreme;

/* Computes direction i of a Fibonacci lattice on the half sphere. */
static void fixed_direction(int i, float out[3]) {
    float z = ((float)i + 0.5f) / FIXED_DIRECTIONS, r = sqrtf(1 - z * z), angle = GOLDEN_ANGLE * (float)i;
    const dmi_circlef at = dmi_circle_atf(angle);
    out[0] = r * at.cosine, out[1] = r * at.sine, out[2] = z;
}

/* Turns a direction a little: of the corners of a face across it, one is the farthest, whatever their order. */
static void tilt_direction(const float direction[3], float out[3]) {
    static const float way[3] = {0.577f, 0.211f, 0.789f}; /* arbitrary */
    dmi_madd3(direction, TILT, way, out);
}

static inline lanes load(const float* p) {
    lanes value;
    memcpy(&value, p, sizeof value);
    return value;
}

static inline int_lanes select_lanes(int_lanes mask, int_lanes yes, int_lanes no) {
    return (mask & yes) | (~mask & no);
}

/* Extends `out` by a block of points, the first of which has index `first`. The block is padded to a multiple of LANES
 * with copies of its last point. */
static void add_block(const float (*block)[BLOCK], uint32_t count, uint32_t first, const float d[3], extreme* out) {
    int_lanes place = {0, 1, 2, 3}, low_place = {0}, high_place = {0};
    lanes low = INFINITY - (lanes){0}, high = -low;
    for (uint32_t i = 0; i < count; i += LANES, place += LANES) {
        const lanes t = load(block[0] + i) * d[0] + load(block[1] + i) * d[1] + load(block[2] + i) * d[2];
        const int_lanes less = (int_lanes)(t < low), more = (int_lanes)(t > high);
        low = (lanes)select_lanes(less, (int_lanes)t, (int_lanes)low);
        low_place = select_lanes(less, place, low_place);
        high = (lanes)select_lanes(more, (int_lanes)t, (int_lanes)high);
        high_place = select_lanes(more, place, high_place);
    }
    for (int lane = 0; lane < LANES; lane++) {
        const uint32_t a = first + (uint32_t)low_place[lane], b = first + (uint32_t)high_place[lane];
        if (low[lane] < out->low || (low[lane] == out->low && a < out->ends[0])) out->low = low[lane], out->ends[0] = a;
        if (high[lane] > out->high || (high[lane] == out->high && b < out->ends[1]))
            out->high = high[lane], out->ends[1] = b;
    }
}

static void find_extremes(const float (*points)[3], uint32_t count, const float (*directions)[3],
                          uint32_t direction_count, extreme* out) {
    float block[3][BLOCK];
    for (uint32_t d = 0; d < direction_count; d++) out[d] = (extreme){INFINITY, -INFINITY, {UINT32_MAX, UINT32_MAX}};
    for (uint32_t first = 0; first < count; first += BLOCK) {
        const uint32_t left = count - first, size = left < BLOCK ? left : BLOCK;
        for (uint32_t i = 0; i < (size + LANES - 1) / LANES * LANES; i++)
            for (int k = 0; k < 3; k++) block[k][i] = points[first + (i < size ? i : size - 1)][k];
        for (uint32_t d = 0; d < direction_count; d++)
            add_block((const float(*)[BLOCK])block, size, first, directions[d], &out[d]);
    }
}

uint32_t dmi_extreme_points(const float (*points)[3], uint32_t count, const float (*extra)[3], uint32_t extra_count,
                            float (*out)[3]) {
    float directions[MAX_DIRECTIONS][3];
    extreme extremes[MAX_DIRECTIONS];
    uint32_t found = 0, chosen[DMI_MAX_HULL_POINTS];
    const uint32_t room = MAX_DIRECTIONS - FIXED_DIRECTIONS;
    const uint32_t direction_count = FIXED_DIRECTIONS + (extra_count < room ? extra_count : room);
    for (uint32_t d = 0; d < direction_count; d++) {
        if (d < FIXED_DIRECTIONS)
            fixed_direction((int)d, directions[d]);
        else
            tilt_direction(extra[d - FIXED_DIRECTIONS], directions[d]);
    }
    find_extremes(points, count, (const float(*)[3])directions, direction_count, extremes);
    for (uint32_t d = 0; count > 0 && d < direction_count; d++) {
        for (int e = 0; e < 2; e++) {
            uint32_t k = 0;
            while (k < found && chosen[k] != extremes[d].ends[e]) k++;
            if (k == found) chosen[found++] = extremes[d].ends[e];
        }
    }
    for (uint32_t i = 0; i < found; i++) dmi_copy3(points[chosen[i]], out[i]);
    return found;
}
