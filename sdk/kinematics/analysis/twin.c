/* Finds the part's twin: its mirror image beside it, where the body near the part is nothing else, as of two leaves
 * without a frame. */
#include "kinematics/analysis/analysis_steps.h"

#define PART_POINTS 128  /* compared; by hand */
#define BODY_POINTS 256  /* likewise */
#define MOST_GAP 0.1f    /* part diagonals between the twins, or that they overlap; by hand */
#define ALIKE 0.03f      /* part diagonals: mean distance from the other's image; by hand */
#define UNLIKE 0.25f     /* part diagonals: no point counts for more; by hand */
#define KNOWN_SHARE 0.5f /* share of the part's points whose image must lie where the body is sampled; by hand */

enum { BOX_SIDES = 6 };

static float end_along(const float (*points)[3], uint32_t count, const float way[3], float sign) {
    float end = -INFINITY;
    for (uint32_t i = 0; i < count; i++) end = dmi_max(end, sign * dmi_dot3(points[i], way));
    return sign * end;
}

static bool lies_in(const dmi_distance_grid* grid, const float point[3]) {
    for (int k = 0; k < 3; k++)
        if (point[k] < grid->low[k] || point[k] > grid->low[k] + (float)grid->size[k] * grid->cell) return false;
    return true;
}

/* Returns the mean distance of the points' mirror images from the grid's samples, over the part's diagonal. Images
 * outside the grid do not count where `inside`. The mirror's normal is `way`, its place along it `at`. */
static float image_distance(const dmi_part_analysis* a, const float (*points)[3], uint32_t count,
                            const dmi_distance_grid* grid, const float way[3], float at, bool inside) {
    float sum = 0;
    uint32_t known = 0;
    for (uint32_t i = 0; i < count; i++) {
        float image[3];
        dmi_copy3(points[i], image);
        dmi_madd3(image, 2 * (at - dmi_dot3(image, way)), way, image);
        if (inside && !lies_in(grid, image)) continue;
        sum += dmi_min(dmi_distance_grid_distance(grid, image) / a->diagonal, UNLIKE);
        known++;
    }
    return (float)known < KNOWN_SHARE * (float)count ? UNLIKE : sum / (float)known;
}

/* Returns how unlike the part's image beyond its side towards `way` and the body are; UNLIKE when they lie apart. */
static float compare(const dmi_part_analysis* a, const float way[3]) {
    const float(*near)[3] = (const float(*)[3])a->near_points;
    const float side = end_along((const float(*)[3])a->extreme_points, a->extreme_point_count, way, 1);
    const float body = end_along(near, a->near_count, way, -1);
    if (!(fabsf(body - side) < MOST_GAP * a->diagonal)) return UNLIKE;
    const float at = (side + body) / 2;
    const uint32_t count = a->near_count < BODY_POINTS ? a->near_count : BODY_POINTS;
    const float back = image_distance(a, near, count, &a->part_grid, way, at, false);
    if (back > ALIKE) return UNLIKE;
    return dmi_max(back, image_distance(a, a->points, PART_POINTS, &a->body_grid, way, at, true));
}

void dmi_analysis_find_twin(dmi_part_analysis* analysis) {
    float least = ALIKE;
    analysis->has_twin = false;
    if (analysis->near_count == 0) return;
    for (int i = 0; i < BOX_SIDES; i++) {
        float way[3];
        for (int k = 0; k < 3; k++) way[k] = i % 2 ? -analysis->box.axes[i / 2][k] : analysis->box.axes[i / 2][k];
        const float unlike = compare(analysis, way);
        if (unlike >= least) continue;
        least = unlike;
        analysis->has_twin = true;
        dmi_copy3(way, analysis->twin_way);
    }
}
