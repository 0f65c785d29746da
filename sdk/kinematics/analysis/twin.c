/* Finds the part's twin: its mirror image beside it, where the body near the part is nothing else, as of two leaves
 * without a frame. And finds a leaf like it in the same frame. */
#include "kinematics/analysis/analysis_steps.h"

#define PART_POINTS 128  /* compared; by hand */
#define BODY_POINTS 256  /* likewise */
#define MOST_GAP 0.1f    /* part diagonals between the twins, or that they overlap; by hand */
#define ALIKE 0.03f      /* part diagonals: mean distance from the other's image; by hand */
#define UNLIKE 0.25f     /* part diagonals: no point counts for more; by hand */
#define KNOWN_SHARE 0.5f /* share of the part's points whose image must lie where the body is sampled; by hand */

/* A frame: so many samples of the body lie from here to there beyond a side of the box, in half sides, and nearer than
 * this to the leaf's plane, in half thicknesses; by hand. */
#define FRAME_SAMPLES 9
#define FRAME_BEGINS 0.98f
#define FRAME_ENDS 1.3f
#define FRAME_DEPTH 2.0f

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

/* Returns whether a frame bounds the part beyond the end of an axis of its box, the longest (0) or the middle one (1).
 */
static bool has_frame(const dmi_part_analysis* a, int axis, float sign) {
    int samples = 0;
    for (uint32_t i = 0; i < a->near_count; i++) {
        const float* p = a->near_points[i];
        const float place = sign * dmi_box_place(&a->box, axis, p);
        samples += place > FRAME_BEGINS && place < FRAME_ENDS && fabsf(dmi_box_place(&a->box, 1 - axis, p)) < 1 &&
                   fabsf(dmi_box_place(&a->box, 2, p)) < FRAME_DEPTH;
    }
    return samples >= FRAME_SAMPLES;
}

/* Returns whether the body holds the part's mirror image beyond the end of an axis, and a frame beyond the other. */
static bool has_leaf(const dmi_part_analysis* a, int axis, float sign) {
    float way[3] = {0};
    dmi_madd3(way, sign, a->box.axes[axis], way);
    const float side = end_along((const float(*)[3])a->extreme_points, a->extreme_point_count, way, 1);
    return image_distance(a, a->points, PART_POINTS, &a->body_grid, way, side, true) < ALIKE &&
           has_frame(a, axis, -sign);
}

static void find_leaf(dmi_part_analysis* analysis) {
    for (int axis = 0; axis < 2; axis++)
        analysis->leaf_side[axis] = (float)(has_leaf(analysis, axis, 1) - has_leaf(analysis, axis, -1));
}

void dmi_analysis_find_twin(dmi_part_analysis* analysis) {
    float least = ALIKE;
    analysis->has_twin = false;
    analysis->leaf_side[0] = analysis->leaf_side[1] = 0;
    if (analysis->near_count == 0) return;
    find_leaf(analysis);
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
