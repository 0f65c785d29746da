/* Measures shape, place in the part's box, drag, suggested directions and lines, and what KPP-Net says. */
#include "kinematics/features/cheap_features.h"

#include "math/elementary.h"
#include "math/linear3.h"

/* Distances at which a likeness falls to 1 / e, all by hand: in diagonals of the part, half sides of its box, or rad.
 */
#define AT_CENTROID 0.01f
#define AT_BOX_CENTRE 0.005f
#define ON_SIDE 0.03f
#define AT_CORNER 0.01f
#define FOLLOWED_CLOSELY 0.01f
#define FOLLOWED 0.1f
#define NETWORK_ANGLE_CLOSE 0.05f
#define NETWORK_ANGLE_NEAR 0.2f
#define NETWORK_LINE_CLOSE 0.03f
#define NETWORK_LINE_NEAR 0.12f

/* Bounds that keep a feature in a range where a network is fitted; by hand. */
#define MOST_HALF_SIDES 4      /* bound across the thinner side */
#define MOST_WIDE_HALF_SIDES 2 /* bound across the wider side */
#define MOST_DIAGONALS 0.5f    /* bound beyond a side */
#define MOST_NETWORK_OFFSET 3  /* diagonals */
#define MOST_LOG_RATIO 12      /* bound of the log ratio of KPP-Net's likelihoods */
#define MOST_TYPE_LEAD 8       /* bound of one type's lead over the other */
#define LOG_UNIT 4             /* what such logarithms are divided by */
#define AREA_RATIO_UNIT 5      /* likewise */

#define ALIGNED_COSINE 0.9995f    /* 32 mrad; by hand */
#define FLAT 0.2f                 /* shortest over longest side of a flat part; by hand */
#define ALONG_ROOM 0.99996f       /* cosine of half a degree, between a drag and an axis of the room; by hand */
#define CHORD_TOLERANCE 0.0087f   /* rad: half a degree, between a drag and a chord of a turn; by hand */
#define MOST_HALF_CHORD 0.85f     /* radii: half of a chord of two radians, the longest that is read so; by hand */
#define PULLED_ACROSS 0.5f        /* cosine of the drag with the thinner side from which it tells the way; by hand */
#define LEAST_HALF_SIDE 0.01f     /* diagonals: a thinner box is taken as so thin; by hand */
#define LEAST_HALF_SECTION 0.005f /* likewise, in the cross-section */
#define LEAST_SIDE 1e-6f          /* objects; avoids a division by 0 */
#define LEAST_LENGTH 1e-9f        /* likewise */
#define LEAST_SPEED 1e-12f        /* likewise */

static bool slides(const dmi_candidate* c) {
    return c->type == DM_JOINT_PRISMATIC;
}

static float clamp(float x, float most) {
    return dmi_min(dmi_max(x, -most), most);
}

static void shape_features(const dmi_cheap_features* cheap, float row[DMI_FEATURE_COUNT]) {
    const float* side = cheap->side;
    const float longest = dmi_max(side[0], LEAST_SIDE);
    row[DMI_FEATURE_SHAPE_THIN_BY_LONG] = side[2] / longest;
    row[DMI_FEATURE_SHAPE_THIN_BY_MIDDLE] = side[2] / dmi_max(side[1], LEAST_SIDE);
    row[DMI_FEATURE_SHAPE_MIDDLE_BY_LONG] = side[1] / longest;
    row[DMI_FEATURE_SHAPE_LOG_DIAGONAL] = cheap->log_diagonal;
    row[DMI_FEATURE_SHAPE_LOG_AREA_RATIO] = cheap->log_area_ratio;
}

/* k: 0 the longest side of the part's box, 1 the middle one, 2 the shortest. */
static void alignment_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    const float longest = dmi_max(cheap->side[0], LEAST_SIDE);
    const float thin = cheap->side[2] / longest, middle = cheap->side[1] / longest;
    for (int k = 0; k < 3; k++) {
        const float cosine = fabsf(dmi_dot3(c->axis, cheap->analysis->box.axes[k]));
        const float aligned = cosine > ALIGNED_COSINE ? 1.0f : 0.0f;
        row[DMI_FEATURE_ALIGNED_LONG + k] = aligned;
        row[DMI_FEATURE_COSINE_LONG + k] = cosine;
        row[DMI_FEATURE_FLAT_ALIGNED_LONG + k] = thin < FLAT ? aligned : 0;
        row[DMI_FEATURE_WIDE_ALIGNED_LONG + k] = aligned * middle;
    }
}

static void offset_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    const dmi_part_analysis* a = cheap->analysis;
    row[DMI_FEATURE_CENTROID_OFFSET] = row[DMI_FEATURE_AT_CENTROID] = 0;
    row[DMI_FEATURE_BOX_OFFSET] = row[DMI_FEATURE_AT_BOX_CENTRE] = 0;
    row[DMI_FEATURE_BODY_DISTANCE] = 0;
    if (slides(c)) return;
    const float centroid = dmi_line_distance3(a->centre, c->axis, c->origin) / a->diagonal;
    const float box = dmi_line_distance3(cheap->box_centre, c->axis, c->origin) / a->diagonal;
    row[DMI_FEATURE_CENTROID_OFFSET] = centroid;
    row[DMI_FEATURE_AT_CENTROID] = dmi_expf(-centroid / AT_CENTROID);
    row[DMI_FEATURE_BOX_OFFSET] = box;
    row[DMI_FEATURE_AT_BOX_CENTRE] = dmi_expf(-box / AT_BOX_CENTRE);
    row[DMI_FEATURE_BODY_DISTANCE] = dmi_distance_grid_distance(&a->body_grid, c->origin) / a->diagonal;
}

/* Returns the axis of the part's box that the candidate's axis is nearest to. */
static int box_axis_along(const dmi_cheap_features* cheap, const dmi_candidate* c) {
    int along = 0;
    float best = 0;
    for (int k = 0; k < 3; k++) {
        const float cosine = fabsf(dmi_dot3(c->axis, cheap->analysis->box.axes[k]));
        if (cosine > best) best = cosine, along = k;
    }
    return along;
}

static void side_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_SIDE_FAR] = row[DMI_FEATURE_SIDE_NEAR] = row[DMI_FEATURE_ON_SIDE] = 0;
    if (slides(c)) return;
    const dmi_part_analysis* a = cheap->analysis;
    const int along = box_axis_along(cheap, c);
    float place[2];
    for (int k = 0, n = 0; k < 3; k++) {
        if (k == along) continue;
        const float off = fabsf(dmi_dot3(c->origin, a->box.axes[k]) - cheap->middle[k]);
        place[n++] = dmi_min(off / dmi_max(0.5f * cheap->side[k], LEAST_HALF_SIDE * a->diagonal), MOST_HALF_SIDES);
    }
    const float far = dmi_max(place[0], place[1]);
    row[DMI_FEATURE_SIDE_FAR] = far;
    row[DMI_FEATURE_SIDE_NEAR] = dmi_min(place[0], place[1]);
    row[DMI_FEATURE_ON_SIDE] = dmi_expf(-fabsf(far - 1) / ON_SIDE);
}

/* Returns how near a place in the cross-section is to the nearest corner of one of its thinner edges. */
static float corner(float wide, float thin, float side_wide, float side_thin, float diagonal) {
    const float a = fabsf(wide) - 0.5f * side_wide, b = thin - 0.5f * side_thin;
    return dmi_expf(-sqrtf(a * a + b * b) / (AT_CORNER * diagonal));
}

/* Computes the place of the axis in the cross-section of the part's box: along its wider side, and along its thinner
 * side, which runs from the face towards the body to the face away from it. A panel may be hinged at an edge of either
 * face, at its middle plane, or beside it. */
static void section_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_SECTION_WIDE] = row[DMI_FEATURE_SECTION_WIDE_BEYOND] = 0;
    row[DMI_FEATURE_SECTION_THIN] = row[DMI_FEATURE_SECTION_THIN_OFFSET] = row[DMI_FEATURE_SECTION_BODY_SIDE] = 0;
    row[DMI_FEATURE_SECTION_OUTER_CORNER] = row[DMI_FEATURE_SECTION_INNER_CORNER] = 0;
    row[DMI_FEATURE_SECTION_PULLED] = 0;
    if (slides(c)) return;
    const dmi_part_analysis* a = cheap->analysis;
    const float *side = cheap->side, diagonal = a->diagonal, least = LEAST_HALF_SECTION * diagonal;
    const int along = box_axis_along(cheap, c);
    const int wide = along == 0 ? 1 : 0, thin = along == 2 ? 1 : 2; /* sides are sorted, longest first */
    const float w = dmi_dot3(c->origin, a->box.axes[wide]) - cheap->middle[wide];
    const float t = dmi_dot3(c->origin, a->box.axes[thin]) - cheap->middle[thin];
    const float away = a->body_side[thin] < 0 ? -t : t, pulled = dmi_dot3(cheap->drag, a->box.axes[thin]);
    row[DMI_FEATURE_SECTION_WIDE] = dmi_min(fabsf(w) / dmi_max(0.5f * side[wide], least), MOST_WIDE_HALF_SIDES);
    row[DMI_FEATURE_SECTION_WIDE_BEYOND] = clamp((fabsf(w) - 0.5f * side[wide]) / diagonal, MOST_DIAGONALS);
    row[DMI_FEATURE_SECTION_THIN] = clamp(away / dmi_max(0.5f * side[thin], least), MOST_HALF_SIDES);
    row[DMI_FEATURE_SECTION_THIN_OFFSET] = clamp(away / diagonal, MOST_DIAGONALS);
    row[DMI_FEATURE_SECTION_BODY_SIDE] = fabsf(a->body_side[thin]);
    row[DMI_FEATURE_SECTION_OUTER_CORNER] = corner(w, away, side[wide], side[thin], diagonal);
    row[DMI_FEATURE_SECTION_INNER_CORNER] = corner(w, -away, side[wide], side[thin], diagonal);
    row[DMI_FEATURE_SECTION_PULLED] =
        fabsf(pulled) < PULLED_ACROSS ? 0 : clamp((pulled < 0 ? -t : t) / diagonal, MOST_DIAGONALS);
}

/* Returns the axis of the object's frame that a unit vector runs along; -1: none. */
static int room_axis_along(const float way[3]) {
    for (int k = 0; k < 3; k++)
        if (fabsf(way[k]) > ALONG_ROOM) return k;
    return -1;
}

/* Returns whether the drag is the axis of the room nearest to a way in which a turn takes the dragged point. A point of
 * a turn hardly ever starts to move exactly along an axis of the room: who drags along one means the nearest. */
static bool is_nearest_axis(const dmi_cheap_features* cheap, const float way[3]) {
    const int k = cheap->room_axis;
    if (k < 0 || !(way[k] * cheap->drag[k] > 0)) return false;
    for (int i = 0; i < 3; i++)
        if (fabsf(way[i]) > fabsf(way[k])) return false;
    return true;
}

/* Returns whether the drag is a straight pull to where a turn takes the dragged point: in the plane of the turn, from
 * one point of its circle to another. */
static bool is_chord(const dmi_cheap_features* cheap, const dmi_candidate* c, const float way[3]) {
    const float radius = dmi_length3(way), half = cheap->drag_length / (2 * radius + LEAST_SPEED);
    if (half > MOST_HALF_CHORD || fabsf(dmi_dot3(cheap->drag, c->axis)) > CHORD_TOLERANCE) return false;
    float arm[3];
    dmi_cross3(way, c->axis, arm); /* the arm goes from the axis to the dragged point */
    const float inward = dmi_atan2f(-dmi_dot3(cheap->drag, arm), dmi_dot3(cheap->drag, way));
    return fabsf(inward - dmi_asinf(half)) < CHORD_TOLERANCE;
}

/* Returns whether a turn explains the drag exactly, though the dragged point does not start to move along it. */
static bool is_read_as_exact(const dmi_cheap_features* cheap, const dmi_candidate* c, const float way[3]) {
    return is_nearest_axis(cheap, way) || is_chord(cheap, c, way);
}

static void drag_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    for (int k = DMI_FEATURE_DRAG_ANGLE; k <= DMI_FEATURE_DRAG_BOX_COSINE; k++) row[k] = 0;
    row[DMI_FEATURE_HAS_DRAG] = cheap->hint != NULL ? 1.0f : 0.0f;
    if (cheap->hint == NULL) return;
    float v[3];
    dmi_candidate_velocity(c, cheap->hint->point, v);
    const float cosine = dmi_dot3(v, cheap->drag) / (dmi_length3(v) + LEAST_SPEED);
    const float angle = !slides(c) && is_read_as_exact(cheap, c, v) ? 0 : dmi_acosf(clamp(cosine, 1));
    row[DMI_FEATURE_DRAG_ANGLE] = angle;
    row[DMI_FEATURE_DRAG_FOLLOWED_10MRAD] = dmi_expf(-angle / FOLLOWED_CLOSELY);
    row[DMI_FEATURE_DRAG_FOLLOWED_100MRAD] = dmi_expf(-angle / FOLLOWED);
    row[DMI_FEATURE_DRAG_NORMAL_COSINE] = fabsf(dmi_dot3(cheap->drag, cheap->drag_normal));
    const float* of_sides = row + DMI_FEATURE_DRAG_LONG_COSINE;
    for (int k = 0; k < 3; k++)
        row[DMI_FEATURE_DRAG_LONG_COSINE + k] = fabsf(dmi_dot3(cheap->drag, cheap->analysis->box.axes[k]));
    row[DMI_FEATURE_DRAG_BOX_COSINE] = dmi_max(of_sides[0], dmi_max(of_sides[1], of_sides[2]));
}

/* Computes how the drag would be a straight pull to where the candidate takes the dragged point. */
static void pull_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_PULL_OUT_OF_PLANE] = row[DMI_FEATURE_PULL_INWARD] = 0;
    if (cheap->hint == NULL) return;
    row[DMI_FEATURE_PULL_OUT_OF_PLANE] = row[DMI_FEATURE_DRAG_ANGLE];
    if (slides(c)) return;
    float way[3], arm[3];
    dmi_candidate_velocity(c, cheap->hint->point, way);
    if (is_read_as_exact(cheap, c, way)) return;
    dmi_cross3(way, c->axis, arm); /* the arm goes from the axis to the dragged point */
    dmi_normalize3(way);
    dmi_normalize3(arm);
    row[DMI_FEATURE_PULL_OUT_OF_PLANE] = dmi_asinf(dmi_min(fabsf(dmi_dot3(cheap->drag, c->axis)), 1));
    row[DMI_FEATURE_PULL_INWARD] = dmi_atan2f(-dmi_dot3(cheap->drag, arm), dmi_dot3(cheap->drag, way));
}

static void widest_gap_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_WIDEST_GAP_SIZE] = row[DMI_FEATURE_WIDEST_GAP_ALONG_AXIS] = row[DMI_FEATURE_WIDEST_GAP_BEYOND] = 0;
    if (a->widest_gap_spread <= 0) return;
    row[DMI_FEATURE_WIDEST_GAP_SIZE] = a->widest_gap_spread / a->diagonal;
    row[DMI_FEATURE_WIDEST_GAP_ALONG_AXIS] = fabsf(dmi_dot3(a->widest_gap_direction, c->axis));
    if (slides(c)) return;
    float off[3], arm[3];
    dmi_sub3(a->widest_gap_mean, a->centre, off);
    dmi_sub3(a->centre, c->origin, arm);
    row[DMI_FEATURE_WIDEST_GAP_BEYOND] = dmi_dot3(off, arm) / (dmi_length3(arm) * a->diagonal + LEAST_LENGTH);
}

static void protrusion_features(const dmi_part_analysis* a, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_HAS_PROTRUSION] = row[DMI_FEATURE_PROTRUSION_SHARE] = row[DMI_FEATURE_PROTRUSION_SIZE] = 0;
    row[DMI_FEATURE_PROTRUSION_ALONG_AXIS] = row[DMI_FEATURE_PROTRUSION_BEYOND] = 0;
    if (a->protrusion_share <= 0) return;
    row[DMI_FEATURE_HAS_PROTRUSION] = 1;
    row[DMI_FEATURE_PROTRUSION_SHARE] = a->protrusion_share;
    row[DMI_FEATURE_PROTRUSION_SIZE] = a->protrusion_spread / a->diagonal;
    row[DMI_FEATURE_PROTRUSION_ALONG_AXIS] = fabsf(dmi_dot3(a->protrusion_direction, c->axis));
    if (slides(c)) return;
    float off[3], arm[3];
    dmi_sub3(a->protrusion_mean, a->centre, off);
    dmi_sub3(a->centre, c->origin, arm);
    dmi_reject3(arm, c->axis);
    row[DMI_FEATURE_PROTRUSION_BEYOND] = dmi_dot3(off, arm) / (dmi_length3(arm) * a->diagonal + LEAST_LENGTH);
}

static void network_features(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    for (int k = DMI_FEATURE_HAS_NETWORK; k <= DMI_FEATURE_NETWORK_CONTINUOUS; k++) row[k] = 0;
    const dmi_prediction* p = cheap->prediction;
    if (p == NULL) return;
    const float turning =
        p->type[DM_JOINT_REVOLUTE - 1] + p->type[DM_JOINT_SCREW - 1] + p->type[DM_JOINT_CONTINUOUS - 1];
    const float cosine = fabsf(dmi_dot3(c->axis, slides(c) ? p->slide_axis : p->turn_axis));
    const float angle = dmi_acosf(dmi_min(cosine, 1));
    row[DMI_FEATURE_HAS_NETWORK] = 1;
    row[DMI_FEATURE_NETWORK_TYPE] = slides(c) ? p->type[DM_JOINT_PRISMATIC - 1] : turning;
    row[DMI_FEATURE_NETWORK_ANGLE] = angle;
    row[DMI_FEATURE_NETWORK_NEAR_50MRAD] = dmi_expf(-angle / NETWORK_ANGLE_CLOSE);
    row[DMI_FEATURE_NETWORK_NEAR_200MRAD] = dmi_expf(-angle / NETWORK_ANGLE_NEAR);
    for (int k = 0; k < DMI_KPP_TYPES; k++) row[DMI_FEATURE_NETWORK_REVOLUTE + k] = p->type[k];
    if (slides(c)) return;
    const float off = dmi_line_distance3(p->origin, c->axis, c->origin) / cheap->analysis->diagonal;
    row[DMI_FEATURE_NETWORK_OFFSET] = dmi_min(off, MOST_NETWORK_OFFSET);
    row[DMI_FEATURE_NETWORK_ON_LINE_3] = dmi_expf(-off / NETWORK_LINE_CLOSE);
    row[DMI_FEATURE_NETWORK_ON_LINE_12] = dmi_expf(-off / NETWORK_LINE_NEAR);
}

static void family_features(const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    _Static_assert(DMI_DIRECTION_NETWORK == 1 << (DMI_FEATURE_DIRECTION_NETWORK - DMI_FEATURE_DIRECTION_BOX),
                   "one column a bit");
    _Static_assert(DMI_ORIGIN_NETWORK == 1 << (DMI_FEATURE_ORIGIN_NETWORK - DMI_FEATURE_ORIGIN_CENTROID),
                   "one column a bit");
    for (int k = 0; k < DMI_DIRECTION_FAMILIES; k++)
        row[DMI_FEATURE_DIRECTION_BOX + k] = (float)(c->direction_families >> k & 1);
    for (int k = 0; k < DMI_ORIGIN_FAMILIES; k++)
        row[DMI_FEATURE_ORIGIN_CENTROID + k] = (float)(c->origin_families >> k & 1);
}

void dmi_cheap_features_begin(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                              const dmi_prediction* prediction, dmi_cheap_features* out) {
    *out = (dmi_cheap_features){.analysis = analysis, .hint = hint, .prediction = prediction, .room_axis = -1};
    for (int k = 0; k < 3; k++) {
        out->side[k] = analysis->box.high[k] - analysis->box.low[k];
        out->middle[k] = (analysis->box.high[k] + analysis->box.low[k]) / 2;
    }
    dmi_box_centre(&analysis->box, out->box_centre);
    out->log_diagonal = dmi_logf(analysis->diagonal);
    out->log_area_ratio = dmi_logf(1 + analysis->area_ratio) / AREA_RATIO_UNIT;
    if (hint == NULL) return;
    dmi_copy3(hint->vector, out->drag);
    out->drag_length = dmi_normalize3(out->drag);
    out->room_axis = room_axis_along(out->drag);
    float least = INFINITY;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) {
        const float d = dmi_distance3(analysis->points[i], hint->point);
        if (d < least) least = d, dmi_copy3(analysis->normals[i], out->drag_normal);
    }
}

void dmi_cheap_features_row(const dmi_cheap_features* cheap, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_PRISMATIC] = slides(c) ? 1.0f : 0.0f;
    shape_features(cheap, row);
    alignment_features(cheap, c, row);
    offset_features(cheap, c, row);
    side_features(cheap, c, row);
    section_features(cheap, c, row);
    drag_features(cheap, c, row);
    pull_features(cheap, c, row);
    widest_gap_features(cheap->analysis, c, row);
    protrusion_features(cheap->analysis, c, row);
    network_features(cheap, c, row);
    family_features(c, row);
}

/* best: of turns, of slides; most: of all; log_sum: of all likelihoods over the most. */
static void score_features(float score, const float best[2], float most, float log_sum, float row[DMI_FEATURE_COUNT]) {
    const int type = row[DMI_FEATURE_PRISMATIC] > 0;
    row[DMI_FEATURE_SCORE_BELOW_BEST] = dmi_max(score - most, -MOST_LOG_RATIO) / LOG_UNIT;
    row[DMI_FEATURE_SCORE_LIKENESS] = dmi_expf(score - most);
    row[DMI_FEATURE_SCORE_BELOW_TYPE_BEST] = dmi_max(score - best[type], -MOST_LOG_RATIO) / LOG_UNIT;
    row[DMI_FEATURE_SCORE_TYPE_LIKENESS] = dmi_expf(score - best[type]);
    row[DMI_FEATURE_SCORE_TYPE_LEAD] = clamp(best[type] - best[!type], MOST_TYPE_LEAD) / LOG_UNIT;
    row[DMI_FEATURE_SCORE_LOG_SHARE] = dmi_max(score - most - log_sum, -MOST_LOG_RATIO) / LOG_UNIT;
}

void dmi_cheap_features_kpp_scores(const float* scores, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    if (scores == NULL) {
        for (uint32_t i = 0; i < count; i++)
            for (int k = DMI_FEATURE_SCORE_BELOW_BEST; k <= DMI_FEATURE_SCORE_LOG_SHARE; k++) rows[i][k] = 0;
        return;
    }
    float best[2] = {-INFINITY, -INFINITY}, sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const int type = rows[i][DMI_FEATURE_PRISMATIC] > 0;
        best[type] = dmi_max(best[type], scores[i]);
    }
    const float most = dmi_max(best[0], best[1]);
    for (uint32_t i = 0; i < count; i++) sum += dmi_expf(scores[i] - most);
    const float log_sum = dmi_logf(sum);
    for (uint32_t i = 0; i < count; i++) score_features(scores[i], best, most, log_sum, rows[i]);
}
