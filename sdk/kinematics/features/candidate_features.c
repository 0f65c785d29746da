/* What a glance does not see of candidate joints: slippage, contacts, sweep, symmetry, spread, mirrors, bearings. */
#include "kinematics/features/candidate_features.h"

#include "kinematics/analysis/batched_transform.h"
#include "kinematics/features/axis_hardware.h"
#include "kinematics/features/cheap_features.h"
#include "kinematics/features/symmetry_features.h"
#include "math/linear3.h"

#define SURFACE_POINTS 96 /* of the part, for slippage and place */
#define SWEEP_POINTS 64
#define SYMMETRY_POINTS 40
#define CONTACT_POINTS 40
#define SWEEP_STEPS 5
#define RELATIVE 12
#define FOLLOWS (RELATIVE - 1) /* the drag */

/* Turns by 0.06, 0.15, 0.35, 0.8 and 1.4 rad. */
static const float SWEEP_COSINE[SWEEP_STEPS] = {0.99820054f, 0.98877108f, 0.93937271f, 0.69670671f, 0.16996714f};
static const float SWEEP_SINE[SWEEP_STEPS] = {0.05996401f, 0.14943813f, 0.34289781f, 0.71735609f, 0.98544973f};
static const float SWEEP_SHARE[SWEEP_STEPS] = {0.04f, 0.12f, 0.25f, 0.5f, 0.85f}; /* of the extent along a slide */

typedef struct judge {
    const dmi_part_analysis* study;
    const dmi_drag_hint* hint;
    dmi_cheap_features glance;
    int32_t free[SWEEP_POINTS]; /* 1: not touching at rest */
} judge;

static int slides(const dmi_candidate* c) {
    return c->type == DM_JOINT_PRISMATIC;
}

/* Mean speed of the part's surface; answers the slippage too. */
static float surface_speed(const judge* j, const dmi_candidate* c, float* out_slip) {
    float speed = 0, normal = 0;
    for (int i = 0; i < SURFACE_POINTS; i++) {
        float v[3];
        dmi_candidate_velocity(c, j->study->points[i], v);
        speed += dmi_length3(v);
        normal += fabsf(dmi_dot3(v, j->study->normals[i]));
    }
    *out_slip = normal / (speed + 1e-9f);
    return speed / SURFACE_POINTS + 1e-9f;
}

/* Normal speed at the part's and at the body's side over the part's speed, the first over the contact's own speed,
 * that speed, how much of the contact lies on the axis, distance of its mean from the axis, its share of the part. */
static void contact_evidence(const judge* j, const dmi_candidate* c, const dmi_contact* contact, float mean_speed,
                             float out[7]) {
    const dmi_part_analysis* s = j->study;
    memset(out, 0, 7 * sizeof *out);
    if (contact->count < 5) return;
    float part = 0, rest = 0, speed = 0, on_axis = 0;
    uint32_t step = contact->count / CONTACT_POINTS + 1, n = 0;
    for (uint32_t i = 0; i < contact->count; i += step, n++) {
        uint32_t p = contact->points[i], q = s->nearest_near[p];
        float v[3], length;
        dmi_candidate_velocity(c, s->points[p], v);
        length = dmi_length3(v);
        speed += length;
        part += fabsf(dmi_dot3(v, s->normals[p]));
        if (q != UINT32_MAX) rest += fabsf(dmi_dot3(v, s->near_normals[q]));
        float ratio = length / (0.05f * s->diagonal);
        if (!slides(c)) on_axis += 1 / (1 + ratio * ratio);
    }
    float each = 1 / (float)n;
    out[0] = part * each / mean_speed;
    out[1] = rest * each / mean_speed;
    out[2] = part / (speed + 1e-9f);
    out[3] = speed * each / mean_speed;
    out[4] = on_axis * each;
    out[5] = slides(c) ? 0 : dmi_line_distance3(contact->mean, c->axis, c->origin) / s->diagonal;
    out[6] = (float)contact->count / DMI_ANALYSIS_POINTS;
}

static void carry(const dmi_candidate* c, const float (*points)[3], uint32_t count, dmi_batched_transform* out) {
    if (slides(c))
        dmi_batched_transform_prismatic(c->axis, points, count, out);
    else
        dmi_batched_transform_revolute(c->axis, c->origin, points, count, out);
}

typedef struct sweep {
    float hit[2][SWEEP_STEPS], detached[2][SWEEP_STEPS], touch[2][SWEEP_STEPS];
} sweep;

/* The third smallest of the distances: a couple of points may lag behind a part that has left the body. */
static float third_smallest(const float* distance) {
    float near[3] = {INFINITY, INFINITY, INFINITY};
    for (uint32_t i = 0; i < SWEEP_POINTS; i++) {
        /* The least three, kept in order without a branch. */
        const float d = distance[i], first = dmi_max(near[0], d), second = dmi_max(near[1], first);
        near[0] = dmi_min(near[0], d);
        near[1] = dmi_min(near[1], first);
        near[2] = dmi_min(near[2], second);
    }
    return near[2];
}

/* Moves the part both ways through the body's distance grid. */
static void sweep_part(const judge* j, const dmi_candidate* c, sweep* out) {
    const dmi_part_analysis* s = j->study;
    float extent = 0, touch_limit = 2.1f * s->body_grid.cell, hit_limit = 0.9f * s->body_grid.cell;
    for (int k = 0; k < 3; k++) extent += fabsf(dmi_dot3(c->axis, s->box.axes[k])) * j->glance.side[k];
    dmi_batched_transform m;
    carry(c, s->points, SWEEP_POINTS, &m);
    for (int side = 0; side < 2; side++) {
        const float sign = side == 0 ? 1.0f : -1.0f;
        int32_t hit[SWEEP_POINTS] = {0}; /* once hit, for good */
        for (int step = 0; step < SWEEP_STEPS; step++) {
            float distance[DMI_POINT_BATCH];
            const float shift = slides(c) ? SWEEP_SHARE[step] * extent : 0;
            dmi_batched_transform_distances(&m, SWEEP_COSINE[step], sign * SWEEP_SINE[step], sign * shift,
                                            &s->body_grid, distance);
            int32_t hits = 0, touches = 0;
            for (int i = 0; i < SWEEP_POINTS; i++) {
                hit[i] |= j->free[i] & (distance[i] < hit_limit);
                hits += hit[i];
                touches += distance[i] < touch_limit;
            }
            out->hit[side][step] = (float)hits / SWEEP_POINTS;
            out->touch[side][step] = (float)touches / SWEEP_POINTS;
            if (step == 2 || step == 4) out->detached[side][step] = third_smallest(distance) / s->diagonal;
        }
    }
}

/* With a drag the first of a pair is along it; without, the smaller. */
static float* pair(const judge* j, float along, float against, float* out) {
    out[0] = j->hint != NULL ? along : dmi_min(along, against);
    out[1] = j->hint != NULL ? against : dmi_max(along, against);
    return out + 2;
}

static void sweep_evidence(const judge* j, const dmi_candidate* c, float out[14]) {
    sweep s;
    sweep_part(j, c, &s);
    static const int steps[3] = {0, 2, 4};
    for (int i = 0; i < 3; i++) out = pair(j, s.hit[0][steps[i]], s.hit[1][steps[i]], out);
    for (int i = 1; i < 3; i++) out = pair(j, s.detached[0][steps[i]], s.detached[1][steps[i]], out);
    for (int i = 1; i < 3; i++) out = pair(j, s.touch[0][steps[i]], s.touch[1][steps[i]], out);
}

/* Spread of the distances from the axis, and how much of the part lies behind the axis as seen from its centroid:
 * nothing behind an edge hinge, half behind a pivot. Answers the largest distance. */
static float spread_evidence(const judge* j, const dmi_candidate* c, float* place) {
    const dmi_part_analysis* s = j->study;
    memset(place + 4, 0, 6 * sizeof *place);
    if (slides(c)) return 0;
    float least = INFINITY, most = 0, sum = 0, square = 0, behind = 0, outward[3];
    dmi_sub3(s->centre, c->origin, outward);
    dmi_reject3(outward, c->axis);
    dmi_normalize3(outward);
    for (int i = 0; i < SURFACE_POINTS; i++) {
        float d[3], along, r;
        dmi_sub3(s->points[i], c->origin, d);
        along = dmi_dot3(d, c->axis);
        r = sqrtf(dmi_max(dmi_dot3(d, d) - along * along, 0));
        behind += dmi_dot3(d, outward) < -0.01f * s->diagonal ? 1.0f : 0.0f;
        least = dmi_min(least, r), most = dmi_max(most, r);
        sum += r, square += r * r;
    }
    const float mean = sum / SURFACE_POINTS;
    place[4] = least / s->diagonal, place[5] = most / s->diagonal, place[6] = least / (most + 1e-9f);
    place[7] = sqrtf(dmi_max(square / SURFACE_POINTS - mean * mean, 0)) / (mean + 1e-9f);
    place[8] = behind / SURFACE_POINTS, place[9] = behind / SURFACE_POINTS < 0.01f ? 1.0f : 0.0f;
    return place[5] * s->diagonal;
}

static void along_evidence(const judge* j, const dmi_candidate* c, float out[4]) {
    const dmi_part_analysis* s = j->study;
    memset(out, 0, 4 * sizeof *out);
    if (slides(c)) return;
    float low, high;
    dmi_extents_along((const float(*)[3])s->extreme_points, s->extreme_point_count, (const float(*)[3]) & c->axis, 1, &low, &high);
    float at = dmi_dot3(c->origin, c->axis);
    for (int i = 0; i < 9; i++) {
        float x[3];
        dmi_madd3(c->origin, low + (high - low) * (float)i / 8 - at, c->axis, x);
        float body = dmi_distance_grid_distance(&s->body_grid, x) / s->diagonal;
        float part = dmi_distance_grid_distance(&s->part_grid, x) / s->diagonal;
        out[0] += body / 9, out[1] = dmi_max(out[1], body);
        out[2] += part / 9, out[3] = dmi_max(out[3], part);
    }
}

/* Mean distance from itself of the part turned by half a turn, and least over thirds to sixths. */
static void symmetry_evidence(const judge* j, const dmi_candidate* c, float out[3]) {
    const dmi_part_analysis* s = j->study;
    memset(out, 0, 3 * sizeof *out);
    if (slides(c)) return;
    static const float cosine[5] = {-1, -0.5f, 0, 0.30901699f, 0.5f};
    static const float sine[5] = {0, 0.8660254f, 1, 0.95105652f, 0.8660254f};
    dmi_batched_transform m;
    carry(c, s->points, SYMMETRY_POINTS, &m);
    float mean[5] = {0};
    for (int k = 0; k < 5; k++) {
        float distance[DMI_POINT_BATCH];
        dmi_batched_transform_distances(&m, cosine[k], sine[k], 0, &s->part_grid, distance);
        for (int i = 0; i < SYMMETRY_POINTS; i++) mean[k] += dmi_min(distance[i] / s->diagonal, 0.5f) / SYMMETRY_POINTS;
    }
    float least = dmi_min(dmi_min(mean[1], mean[2]), dmi_min(mean[3], mean[4]));
    out[0] = mean[0], out[1] = least, out[2] = expf(-dmi_min(least, mean[0]) / 0.02f);
}

/* Seen from the part's centre towards the axis: how far from the object's far side the axis runs, where the part's
 * centre lies, how wide the object is; and how much of the object's length along the axis the part takes. */
static void outline_evidence(const judge* j, const dmi_candidate* c, float out[4]) {
    const dmi_part_analysis* s = j->study;
    memset(out, 0, 4 * sizeof *out);
    float way[2][3], low[2], high[2], part_low, part_high;
    dmi_copy3(c->axis, way[0]);
    dmi_sub3(c->origin, s->centre, way[1]);
    dmi_reject3(way[1], c->axis);
    int off_centre = dmi_normalize3(way[1]) > 0.02f * s->diagonal;
    dmi_extents_along((const float(*)[3])s->object_extreme_points, s->object_extreme_point_count, (const float(*)[3])way, off_centre ? 2 : 1, low,
                     high);
    dmi_extents_along((const float(*)[3])s->extreme_points, s->extreme_point_count, (const float(*)[3])way, 1, &part_low,
                     &part_high);
    out[0] = (part_high - part_low) / (high[0] - low[0] + 1e-9f);
    if (slides(c) || !off_centre) return;
    float width = high[1] - low[1] + 1e-9f;
    out[1] = dmi_max((high[1] - dmi_dot3(c->origin, way[1])) / width, -1);
    out[2] = (dmi_dot3(s->centre, way[1]) - low[1]) / width;
    out[3] = dmi_min(logf(width / s->diagonal), 3);
}

/* Distances from the axis over the part's farthest, `most`: of the drag's point, the handle and the grip; where along
 * the axis the drag's point lies. */
static void reach_evidence(const judge* j, const dmi_candidate* c, float most, float row[DMI_FEATURE_COUNT]) {
    const dmi_part_analysis* s = j->study;
    const int turns = !slides(c);
    float *drag = row + DMI_FEATURE_DRAG, *handle = row + DMI_FEATURE_HANDLE, *grip = row + DMI_FEATURE_GRIP;
    drag[1] = drag[10] = handle[2] = grip[4] = 0;
    if (turns && s->widest_gap_spread > 0) handle[2] = dmi_line_distance3(s->widest_gap_mean, c->axis, c->origin) / (most + 1e-9f);
    if (turns && s->protrusion_share > 0) grip[4] = dmi_line_distance3(s->protrusion_mean, c->axis, c->origin) / (most + 1e-9f);
    if (j->hint == NULL) return;
    float v[3], low, high;
    dmi_candidate_velocity(c, j->hint->point, v);
    dmi_extents_along((const float(*)[3])s->extreme_points, s->extreme_point_count, (const float(*)[3]) & c->axis, 1, &low, &high);
    const float along = (dmi_dot3(j->hint->point, c->axis) - low) / dmi_max(high - low, 1e-6f);
    if (turns) drag[1] = dmi_min(dmi_length3(v) / (most + 1e-9f), 2);
    drag[10] = dmi_min(fabsf(along - 0.5f), 2);
}

static judge make_judge(const dmi_part_analysis* study, const dmi_drag_hint* hint, const dmi_prediction* prediction) {
    judge j = {.study = study, .hint = hint};
    dmi_cheap_features_begin(study, hint, prediction, &j.glance);
    for (int i = 0; i < SWEEP_POINTS; i++)
        j.free[i] = dmi_distance_grid_distance(&study->body_grid, study->points[i]) > 2.1f * study->body_grid.cell;
    return j;
}

/* How far each candidate's costs are above the least of its own type, and above the least of the other type: whether
 * this part slides better than it turns shows only between candidates. How well the drag is followed is held against
 * what the shape alone suggests: a drag that hits one of its directions to a hair was meant so. */
static void relative_evidence(const dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    static const int of[RELATIVE] = {DMI_FEATURE_SLIP,         DMI_FEATURE_CONTACT,      DMI_FEATURE_CONTACT + 14,
                                     DMI_FEATURE_CONTACT + 15, DMI_FEATURE_CONTACT + 16, DMI_FEATURE_SWEEP,
                                     DMI_FEATURE_SWEEP + 2,    DMI_FEATURE_SWEEP + 4,    DMI_FEATURE_SWEEP + 6,
                                     DMI_FEATURE_SYMMETRY + 1, DMI_FEATURE_ALONG,        DMI_FEATURE_DRAG + 2};
    for (int k = 0; k < RELATIVE; k++) {
        float best[2] = {1, 1}; /* all costs are about 0 to 1 */
        for (uint32_t i = 0; i < count; i++) {
            int type = rows[i][DMI_FEATURE_SLIDES] > 0;
            if (k == FOLLOWS && (candidates[i].direction_families & DMI_DIRECTION_DRAG) != 0) continue;
            best[type] = dmi_min(best[type], rows[i][of[k]]);
        }
        for (uint32_t i = 0; i < count; i++) {
            int type = rows[i][DMI_FEATURE_SLIDES] > 0;
            rows[i][DMI_FEATURE_RELATIVE + k] = rows[i][of[k]] - best[type];
            rows[i][DMI_FEATURE_RELATIVE + RELATIVE + k] = rows[i][of[k]] - best[!type];
        }
    }
}

/* Part and body in mirrors, and how far both are above the least of all candidates in the mirror across the axis. */
static void mirror_evidence(const dmi_part_analysis* study, const dmi_candidate* candidates, uint32_t count,
                            float (*rows)[DMI_FEATURE_COUNT]) {
    enum { RELATIVE_MIRRORS = 2 };
    _Static_assert(DMI_SYMMETRY_COUNT + RELATIVE_MIRRORS == DMI_FEATURE_BEARING - DMI_FEATURE_MIRROR, "columns");
    dmi_symmetry mirror;
    float least[RELATIVE_MIRRORS] = {1, 1};
    dmi_symmetry_begin(study, &mirror);
    for (uint32_t i = 0; i < count; i++) {
        float* out = rows[i] + DMI_FEATURE_MIRROR;
        dmi_symmetry_features(&mirror, &candidates[i], out);
        for (int k = 0; k < RELATIVE_MIRRORS; k++) least[k] = dmi_min(least[k], out[k]);
    }
    for (uint32_t i = 0; i < count; i++) {
        float* out = rows[i] + DMI_FEATURE_MIRROR;
        for (int k = 0; k < RELATIVE_MIRRORS; k++) out[DMI_SYMMETRY_COUNT + k] = out[k] - least[k];
    }
}

/* What lies on the axis, on the part's side (0) or the body's (1). */
static float borne(const float bearing[DMI_HARDWARE_COUNT], int side) {
    return bearing[DMI_HARDWARE_ROUND + 2 * side] + bearing[DMI_HARDWARE_CENTRED + side];
}

/* What lies on the axes, and how far the counts of part and body are below the most of any turn. */
static void bearing_evidence(const dmi_part_analysis* study, const dmi_candidate* candidates, uint32_t count,
                             float (*rows)[DMI_FEATURE_COUNT]) {
    enum { SIDES = 2 };
    _Static_assert(DMI_HARDWARE_COUNT + SIDES == DMI_FEATURE_COUNT - DMI_FEATURE_BEARING, "columns");
    float most[SIDES] = {0, 0};
    for (uint32_t i = 0; i < count; i++) {
        float* out = rows[i] + DMI_FEATURE_BEARING;
        dmi_axis_hardware_features(study, &candidates[i], out);
        for (int k = 0; k < SIDES && !slides(&candidates[i]); k++) most[k] = dmi_max(most[k], borne(out, k));
    }
    for (uint32_t i = 0; i < count; i++) {
        float* out = rows[i] + DMI_FEATURE_BEARING;
        for (int k = 0; k < SIDES; k++) out[DMI_HARDWARE_COUNT + k] = most[k] - borne(out, k);
    }
}

void dmi_candidate_features_make(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                                 const dmi_prediction* prediction, const float* scores, const dmi_candidate* candidates,
                                 uint32_t count, float (*out)[DMI_FEATURE_COUNT]) {
    judge j = make_judge(study, hint, prediction);
    for (uint32_t i = 0; i < count; i++) {
        const dmi_candidate* c = &candidates[i];
        float* row = out[i];
        dmi_cheap_features_row(&j.glance, c, row);
        const float speed = surface_speed(&j, c, &row[DMI_FEATURE_SLIP]);
        for (int k = 0; k < DMI_CONTACT_REGIONS; k++)
            contact_evidence(&j, c, &study->contacts[k], speed, row + DMI_FEATURE_CONTACT + 7 * k);
        sweep_evidence(&j, c, row + DMI_FEATURE_SWEEP);
        reach_evidence(&j, c, spread_evidence(&j, c, row + DMI_FEATURE_PLACE), row);
        along_evidence(&j, c, row + DMI_FEATURE_ALONG);
        symmetry_evidence(&j, c, row + DMI_FEATURE_SYMMETRY);
        outline_evidence(&j, c, row + DMI_FEATURE_OUTLINE);
    }
    relative_evidence(candidates, count, out);
    mirror_evidence(study, candidates, count, out);
    bearing_evidence(study, candidates, count, out);
    dmi_cheap_features_kpp_scores(scores, count, out);
}
