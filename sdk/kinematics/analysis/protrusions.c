/* Finds points of the part that are far from the body or protrude from the part's outer face, such as handles. */
#include "base/sort.h"
#include "kinematics/analysis/analysis_steps.h"

#define WIDEST_SHARE 32          /* the points with the widest gaps: 1 / 32 of all; by hand */
#define PROBE_DISTANCE 0.02f     /* part diagonals from the box's side to the probes; by hand */
#define PROBE_SPACING 0.35f      /* spacing of the probes, in sides of the box; by hand */
#define MIN_DISTANCE_SUM 1e-9f   /* object sizes: avoids a division by zero */
#define FACE_THICKNESS 0.01f     /* part diagonals: points within it lie on one face; by hand */
#define PROTRUSION_HEIGHT 0.015f /* part diagonals above the face, from which points protrude; by hand */
#define MIN_PROTRUSION_POINTS 8  /* least of the DMI_ANALYSIS_POINTS that protrude; by hand */
#define MAX_PROTRUSION_SHARE 3   /* more than 1 / 3 of the points are no protrusion; by hand */

enum { PROBES = 9 }; /* 3 x 3 on a side of the box */

/* Numbers and places of the part's points. */
typedef struct scratch {
    float sorted[DMI_ANALYSIS_POINTS], spare[DMI_ANALYSIS_POINTS], xyz[DMI_ANALYSIS_POINTS][3];
} scratch;

/* Computes mean and longest principal direction. Returns the root mean square distance from the mean. */
static float spread_of(const float (*points)[3], uint32_t count, float mean[3], float direction[3]) {
    double variances[3];
    float directions[3][3];
    dmi_principal3(points, count, mean, variances, directions);
    dmi_copy3(directions[0], direction);
    return (float)sqrt(variances[0] + variances[1] + variances[2]);
}

static void find_widest_gaps(scratch* s, dmi_part_analysis* analysis) {
    float *sorted = s->sorted, (*xyz)[3] = s->xyz;
    memcpy(sorted, analysis->gap, sizeof s->sorted);
    dmi_sort_floats(sorted, DMI_ANALYSIS_POINTS, s->spare);
    float least = sorted[DMI_ANALYSIS_POINTS - DMI_ANALYSIS_POINTS / WIDEST_SHARE];
    if (!isfinite(sorted[DMI_ANALYSIS_POINTS - 1])) return;
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        if (analysis->gap[i] >= least) dmi_copy3(analysis->points[i], xyz[count++]);
    analysis->widest_gap_spread =
        spread_of((const float(*)[3])xyz, count, analysis->widest_gap_mean, analysis->widest_gap_direction);
}

/* Compares the body's distances from probes on both sides of the box across one of its axes. Returns body_side. */
static float body_side_along(const dmi_part_analysis* analysis, const float centre[3], int axis) {
    const dmi_box* box = &analysis->box;
    const float out = 0.5f * (box->high[axis] - box->low[axis]) + PROBE_DISTANCE * analysis->diagonal;
    float distance[2] = {0, 0};
    for (int i = 0; i < PROBES; i++) {
        float at[3], x[3];
        dmi_copy3(centre, at);
        for (int k = 0, n = 0; k < 3; k++) {
            if (k == axis) continue;
            const int step = (n++ == 0 ? i % 3 : i / 3) - 1;
            dmi_madd3(at, PROBE_SPACING * (float)step * (box->high[k] - box->low[k]), box->axes[k], at);
        }
        for (int side = 0; side < 2; side++) {
            dmi_madd3(at, side ? out : -out, box->axes[axis], x);
            distance[side] += dmi_distance_grid_distance(&analysis->body_grid, x);
        }
    }
    return (distance[1] - distance[0]) / (distance[0] + distance[1] + MIN_DISTANCE_SUM);
}

/* Returns the height, above the median, of the face on which most points lie. */
static float face_height(const float sorted[DMI_ANALYSIS_POINTS], float thickness) {
    uint32_t best = 0;
    float height = sorted[DMI_ANALYSIS_POINTS - 1];
    for (uint32_t i = DMI_ANALYSIS_POINTS / 2, end = i; i < DMI_ANALYSIS_POINTS; i++) {
        while (end < DMI_ANALYSIS_POINTS && sorted[end] - sorted[i] < thickness) end++;
        if (end - i > best) best = end - i, height = sorted[(i + end - 1) / 2];
    }
    return height;
}

/* Finds the points that protrude from the outer face: the one across the box's shortest side, away from the body. */
static void find_protrusion(scratch* s, dmi_part_analysis* analysis) {
    float out[3], *sorted = s->sorted, (*xyz)[3] = s->xyz;
    const dmi_box* box = &analysis->box;
    for (int k = 0; k < 3; k++) out[k] = analysis->body_side[2] < 0 ? -box->axes[2][k] : box->axes[2][k];
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) sorted[i] = dmi_dot3(analysis->points[i], out);
    dmi_sort_floats(sorted, DMI_ANALYSIS_POINTS, s->spare);
    const float face = face_height(sorted, FACE_THICKNESS * analysis->diagonal);
    const float least = face + PROTRUSION_HEIGHT * analysis->diagonal;
    uint32_t count = 0;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++)
        if (dmi_dot3(analysis->points[i], out) > least) dmi_copy3(analysis->points[i], xyz[count++]);
    if (count < MIN_PROTRUSION_POINTS || count > DMI_ANALYSIS_POINTS / MAX_PROTRUSION_SHARE) return;
    analysis->protrusion_spread =
        spread_of((const float(*)[3])xyz, count, analysis->protrusion_mean, analysis->protrusion_direction);
    analysis->protrusion_share = (float)count / DMI_ANALYSIS_POINTS;
}

dm_result dmi_analysis_find_protrusions(dmi_arena* arena, dmi_part_analysis* analysis) {
    const dmi_arena_mark mark = dmi_arena_get_mark(arena);
    scratch* s = dmi_arena_push(arena, sizeof *s);
    float centre[3];
    if (s == NULL) return DM_ERROR_OUT_OF_MEMORY;
    find_widest_gaps(s, analysis);
    dmi_box_centre(&analysis->box, centre);
    for (int k = 0; k < 3; k++) analysis->body_side[k] = body_side_along(analysis, centre, k);
    find_protrusion(s, analysis);
    dmi_arena_rewind(arena, mark);
    return DM_OK;
}
