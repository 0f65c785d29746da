/* Where a candidate's axis runs through the part and through the whole object, and how the part lies about it. */
#include "kinematics/analysis/batched_transform.h"
#include "kinematics/features/feature_groups.h"
#include "math/elementary.h"
#include "math/linear3.h"

#define SURFACE_POINTS 96    /* points of the part; by hand */
#define ROTATED_POINTS 40    /* points of the part, for rotational symmetry; by hand */
#define ALONG_SAMPLES 9      /* places on the axis, over the part's length; by hand */
#define BEHIND_OFFSET 0.01f  /* diagonals beyond the axis from which a point counts as behind it; by hand */
#define BEHIND_SHARE 0.01f   /* share of the points; fewer behind the axis count as none; by hand */
#define ROUND_DISTANCE 0.02f /* diagonals at which a likeness falls to 1 / e; by hand */
#define UNLIKE_DISTANCE 0.5f /* diagonals: a point farther off counts as much as one at this distance; by hand */
#define OFF_CENTRE 0.02f     /* diagonals from which an axis lies to a side of the part's centroid; by hand */
#define MOST_REACH 2         /* times the part's farthest point; by hand */
#define MOST_LOG_WIDTH 3     /* bound of the feature; by hand */
#define LEAST_LENGTH 1e-9f   /* avoids a division by 0 */
#define LEAST_EXTENT 1e-6f   /* objects, likewise */

static void limits_along(const float (*points)[3], uint32_t count, const float direction[3], float* low, float* high) {
    dmi_extents_along(points, count, (const float(*)[3])direction, 1, low, high);
}

/* Writes the spread of the distances from the axis, and how much of the part lies beyond the axis as seen from the
 * centroid. Returns the largest distance. */
static float radius_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_RADIUS_LEAST] = row[DMI_FEATURE_RADIUS_MOST] = row[DMI_FEATURE_RADIUS_RATIO] = 0;
    row[DMI_FEATURE_RADIUS_SPREAD] = row[DMI_FEATURE_BEHIND_SHARE] = row[DMI_FEATURE_NOTHING_BEHIND] = 0;
    if (dmi_candidate_slides(c)) return 0;
    float least = INFINITY, most = 0, sum = 0, square = 0, behind = 0, outward[3];
    dmi_sub3(a->centre, c->origin, outward);
    dmi_reject3(outward, c->axis);
    dmi_normalize3(outward);
    for (int i = 0; i < SURFACE_POINTS; i++) {
        float d[3];
        dmi_sub3(a->points[i], c->origin, d);
        const float along = dmi_dot3(d, c->axis), r = sqrtf(dmi_max(dmi_dot3(d, d) - along * along, 0));
        behind += dmi_dot3(d, outward) < -BEHIND_OFFSET * a->diagonal ? 1.0f : 0.0f;
        least = dmi_min(least, r), most = dmi_max(most, r);
        sum += r, square += r * r;
    }
    const float mean = sum / SURFACE_POINTS;
    row[DMI_FEATURE_RADIUS_LEAST] = least / a->diagonal;
    row[DMI_FEATURE_RADIUS_MOST] = most / a->diagonal;
    row[DMI_FEATURE_RADIUS_RATIO] = least / (most + LEAST_LENGTH);
    row[DMI_FEATURE_RADIUS_SPREAD] = sqrtf(dmi_max(square / SURFACE_POINTS - mean * mean, 0)) / (mean + LEAST_LENGTH);
    row[DMI_FEATURE_BEHIND_SHARE] = behind / SURFACE_POINTS;
    row[DMI_FEATURE_NOTHING_BEHIND] = behind / SURFACE_POINTS < BEHIND_SHARE ? 1.0f : 0.0f;
    return row[DMI_FEATURE_RADIUS_MOST] * a->diagonal;
}

/* most: the largest distance of the part from the axis. */
static void reach_features(const dmi_feature_context* context, const dmi_candidate* c, float most,
                           float row[DMI_FEATURE_COUNT]) {
    const dmi_part_analysis* a = context->analysis;
    const bool turns = !dmi_candidate_slides(c);
    row[DMI_FEATURE_DRAG_REACH] = row[DMI_FEATURE_DRAG_ALONG_AXIS] = 0;
    row[DMI_FEATURE_WIDEST_GAP_REACH] = row[DMI_FEATURE_PROTRUSION_REACH] = 0;
    if (turns && a->widest_gap_spread > 0)
        row[DMI_FEATURE_WIDEST_GAP_REACH] =
            dmi_line_distance3(a->widest_gap_mean, c->axis, c->origin) / (most + LEAST_LENGTH);
    if (turns && a->protrusion_share > 0)
        row[DMI_FEATURE_PROTRUSION_REACH] =
            dmi_line_distance3(a->protrusion_mean, c->axis, c->origin) / (most + LEAST_LENGTH);
    if (context->hint == NULL) return;
    const float* point = context->hint->point;
    float v[3], low, high;
    dmi_candidate_velocity(c, point, v);
    limits_along((const float(*)[3])a->extreme_points, a->extreme_point_count, c->axis, &low, &high);
    const float along = (dmi_dot3(point, c->axis) - low) / dmi_max(high - low, LEAST_EXTENT);
    if (turns) row[DMI_FEATURE_DRAG_REACH] = dmi_min(dmi_length3(v) / (most + LEAST_LENGTH), MOST_REACH);
    row[DMI_FEATURE_DRAG_ALONG_AXIS] = dmi_min(fabsf(along - 0.5f), MOST_REACH);
}

static void along_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    float body_mean = 0, body_most = 0, part_mean = 0, part_most = 0, low, high;
    if (!dmi_candidate_slides(c)) {
        limits_along((const float(*)[3])a->extreme_points, a->extreme_point_count, c->axis, &low, &high);
        const float at = dmi_dot3(c->origin, c->axis);
        for (int i = 0; i < ALONG_SAMPLES; i++) {
            float x[3];
            dmi_madd3(c->origin, low + (high - low) * (float)i / (ALONG_SAMPLES - 1) - at, c->axis, x);
            const float body = dmi_distance_grid_distance(&a->body_grid, x) / a->diagonal;
            const float part = dmi_distance_grid_distance(&a->part_grid, x) / a->diagonal;
            body_mean += body / ALONG_SAMPLES, body_most = dmi_max(body_most, body);
            part_mean += part / ALONG_SAMPLES, part_most = dmi_max(part_most, part);
        }
    }
    row[DMI_FEATURE_ALONG_BODY_MEAN] = body_mean, row[DMI_FEATURE_ALONG_BODY_MOST] = body_most;
    row[DMI_FEATURE_ALONG_PART_MEAN] = part_mean, row[DMI_FEATURE_ALONG_PART_MOST] = part_most;
}

static float least_of(const float* values, int count) {
    float least = values[0];
    for (int i = 1; i < count; i++) least = dmi_min(least, values[i]);
    return least;
}

/* Rotational symmetry: the part turned on itself by a half, a third, a quarter, a fifth and a sixth of a turn. */
static void rotation_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    enum { FRACTIONS = 5 };
    static const float cosine[FRACTIONS] = {-1, -0.5f, 0, 0.30901699f, 0.5f};
    static const float sine[FRACTIONS] = {0, 0.8660254f, 1, 0.95105652f, 0.8660254f};
    row[DMI_FEATURE_HALF_TURN_DISTANCE] = row[DMI_FEATURE_FRACTION_TURN_DISTANCE] = row[DMI_FEATURE_ROUND] = 0;
    if (dmi_candidate_slides(c)) return;
    dmi_batched_transform moved;
    float mean[FRACTIONS] = {0};
    dmi_batched_transform_revolute(c->axis, c->origin, a->points, ROTATED_POINTS, &moved);
    for (int k = 0; k < FRACTIONS; k++) {
        float distance[DMI_POINT_BATCH];
        dmi_batched_transform_distances(&moved, cosine[k], sine[k], 0, &a->part_grid, distance);
        for (int i = 0; i < ROTATED_POINTS; i++)
            mean[k] += dmi_min(distance[i] / a->diagonal, UNLIKE_DISTANCE) / ROTATED_POINTS;
    }
    const float least = least_of(mean + 1, FRACTIONS - 1);
    row[DMI_FEATURE_HALF_TURN_DISTANCE] = mean[0];
    row[DMI_FEATURE_FRACTION_TURN_DISTANCE] = least;
    row[DMI_FEATURE_ROUND] = dmi_expf(-dmi_min(least, mean[0]) / ROUND_DISTANCE);
}

/* The axis in the outline of the whole object, along the way from the part's centroid to the axis. */
static void outline_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_OUTLINE_AXIS_PLACE] = row[DMI_FEATURE_OUTLINE_PART_PLACE] = row[DMI_FEATURE_OUTLINE_LOG_WIDTH] = 0;
    float directions[2][3], low[2], high[2], part_low, part_high;
    dmi_copy3(c->axis, directions[0]);
    dmi_sub3(c->origin, a->centre, directions[1]);
    dmi_reject3(directions[1], c->axis);
    const bool off_centre = dmi_normalize3(directions[1]) > OFF_CENTRE * a->diagonal;
    dmi_extents_along((const float(*)[3])a->object_extreme_points, a->object_extreme_point_count,
                      (const float(*)[3])directions, off_centre ? 2 : 1, low, high);
    limits_along((const float(*)[3])a->extreme_points, a->extreme_point_count, directions[0], &part_low, &part_high);
    row[DMI_FEATURE_OUTLINE_LENGTH_SHARE] = (part_high - part_low) / (high[0] - low[0] + LEAST_LENGTH);
    if (dmi_candidate_slides(c) || !off_centre) return;
    const float width = high[1] - low[1] + LEAST_LENGTH;
    row[DMI_FEATURE_OUTLINE_AXIS_PLACE] = dmi_max((high[1] - dmi_dot3(c->origin, directions[1])) / width, -1);
    row[DMI_FEATURE_OUTLINE_PART_PLACE] = (dmi_dot3(a->centre, directions[1]) - low[1]) / width;
    row[DMI_FEATURE_OUTLINE_LOG_WIDTH] = dmi_min(dmi_logf(width / a->diagonal), MOST_LOG_WIDTH);
}

void dmi_place_features(const dmi_feature_context* context, const dmi_candidate* candidate,
                        float row[DMI_FEATURE_COUNT]) {
    const dmi_part_analysis* a = context->analysis;
    const float most = radius_features(a, candidate, row);
    reach_features(context, candidate, most, row);
    along_features(a, candidate, row);
    rotation_features(a, candidate, row);
    outline_features(a, candidate, row);
}
