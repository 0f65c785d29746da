/* Features of candidate joints: slippage, sweep, place, symmetry, drag, network. */
#include "kinematics/evidence.h"

#include "kinematics/linear3.h"
#include "kinematics/moved.h"

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
    const dmi_study* study;
    const dmi_drag_hint* hint;
    const dmi_prediction* prediction;
    float drag[3], drag_normal[3]; /* unit */
    float side[3], middle[3];      /* lengths of the box and its centre, along its axes */
    float box_centre[3];
    int32_t free[SWEEP_POINTS]; /* 1: not touching at rest */
    float shape[5];
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
    const dmi_study* s = j->study;
    memset(out, 0, 7 * sizeof *out);
    if (contact->count < 5) return;
    float part = 0, rest = 0, speed = 0, on_axis = 0;
    uint32_t step = contact->count / CONTACT_POINTS + 1, n = 0;
    for (uint32_t i = 0; i < contact->count; i += step, n++) {
        uint32_t p = contact->points[i], q = s->facing[p];
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
    out[6] = (float)contact->count / DMI_STUDY_PART;
}

static void carry(const dmi_candidate* c, const float (*points)[3], uint32_t count, dmi_moved* out) {
    if (slides(c))
        dmi_moved_slide(c->axis, points, count, out);
    else
        dmi_moved_turn(c->axis, c->origin, points, count, out);
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
    const dmi_study* s = j->study;
    float extent = 0, touch_limit = 2.1f * s->body_field.cell, hit_limit = 0.9f * s->body_field.cell;
    for (int k = 0; k < 3; k++) extent += fabsf(dmi_dot3(c->axis, s->box.axes[k])) * j->side[k];
    dmi_moved m;
    carry(c, s->points, SWEEP_POINTS, &m);
    for (int side = 0; side < 2; side++) {
        const float sign = side == 0 ? 1.0f : -1.0f;
        int32_t hit[SWEEP_POINTS] = {0}; /* once hit, for good */
        for (int step = 0; step < SWEEP_STEPS; step++) {
            float distance[DMI_FIELD_BATCH];
            const float shift = slides(c) ? SWEEP_SHARE[step] * extent : 0;
            dmi_moved_distances(&m, SWEEP_COSINE[step], sign * SWEEP_SINE[step], sign * shift, &s->body_field,
                                distance);
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

static void shape_evidence(const judge* j, float out[5]) {
    float longest = dmi_max(j->side[0], 1e-6f);
    out[0] = j->side[2] / longest;
    out[1] = j->side[2] / dmi_max(j->side[1], 1e-6f);
    out[2] = j->side[1] / longest;
    out[3] = logf(j->study->diagonal);
    out[4] = logf(1 + j->study->area_ratio) / 5;
}

static void alignment_evidence(const judge* j, const dmi_candidate* c, float out[12]) {
    float longest = dmi_max(j->side[0], 1e-6f), thin = j->side[2] / longest, middle = j->side[1] / longest;
    for (int k = 0; k < 3; k++) {
        float cosine = fabsf(dmi_dot3(c->axis, j->study->box.axes[k])), aligned = cosine > 0.9995f ? 1.0f : 0.0f;
        out[k] = aligned;
        out[3 + k] = cosine;
        out[6 + k] = thin < 0.2f ? aligned : 0;
        out[9 + k] = aligned * middle;
    }
}

/* Offsets from the centroid and the box's centre, spread of the distances from the axis, and how much of the part lies
 * behind the axis as seen from its centroid: nothing behind an edge hinge, half behind a pivot. */
static void place_evidence(const judge* j, const dmi_candidate* c, float out[11]) {
    const dmi_study* s = j->study;
    memset(out, 0, 11 * sizeof *out);
    if (slides(c)) return;
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
    float mean = sum / SURFACE_POINTS, off = dmi_line_distance3(s->centre, c->axis, c->origin) / s->diagonal;
    float off_box = dmi_line_distance3(j->box_centre, c->axis, c->origin) / s->diagonal;
    out[0] = off, out[1] = expf(-off / 0.01f);
    out[2] = off_box, out[3] = expf(-off_box / 0.005f);
    out[4] = least / s->diagonal, out[5] = most / s->diagonal, out[6] = least / (most + 1e-9f);
    out[7] = sqrtf(dmi_max(square / SURFACE_POINTS - mean * mean, 0)) / (mean + 1e-9f);
    out[8] = behind / SURFACE_POINTS, out[9] = behind / SURFACE_POINTS < 0.01f ? 1.0f : 0.0f;
    out[10] = dmi_field_distance(&s->body_field, c->origin) / s->diagonal;
}

/* The axis of the part's box that the candidate's is nearest to. */
static int box_axis_along(const judge* j, const dmi_candidate* c) {
    int along = 0;
    float best = 0;
    for (int k = 0; k < 3; k++) {
        const float cosine = fabsf(dmi_dot3(c->axis, j->study->box.axes[k]));
        if (cosine > best) best = cosine, along = k;
    }
    return along;
}

static void side_evidence(const judge* j, const dmi_candidate* c, float out[3]) {
    memset(out, 0, 3 * sizeof *out);
    if (slides(c)) return;
    const int along = box_axis_along(j, c);
    float place[2];
    for (int k = 0, n = 0; k < 3; k++) {
        if (k == along) continue;
        float off = fabsf(dmi_dot3(c->origin, j->study->box.axes[k]) - j->middle[k]);
        place[n++] = dmi_min(off / dmi_max(0.5f * j->side[k], 0.01f * j->study->diagonal), 4);
    }
    out[0] = dmi_max(place[0], place[1]);
    out[1] = dmi_min(place[0], place[1]);
    out[2] = expf(-fabsf(out[0] - 1) / 0.03f);
}

/* How far a place is from a corner of the cross-section. */
static float corner(float wide, float thin, float side_wide, float side_thin, float diagonal) {
    const float a = fabsf(wide) - 0.5f * side_wide, b = thin - 0.5f * side_thin;
    return expf(-sqrtf(a * a + b * b) / (0.01f * diagonal));
}

/* The axis in the box's cross-section: across its wider and its thinner side. A slab has a face towards the body and
 * one away from it, and may hang on the edge of either, or on its middle, or beside it. */
static void spot_evidence(const judge* j, const dmi_candidate* c, float out[8]) {
    memset(out, 0, 8 * sizeof *out);
    if (slides(c)) return;
    const dmi_study* s = j->study;
    const int along = box_axis_along(j, c);
    const int wide = along == 0 ? 1 : 0, thin = along == 2 ? 1 : 2; /* sides are sorted, longest first */
    const float w = dmi_dot3(c->origin, s->box.axes[wide]) - j->middle[wide];
    const float t = dmi_dot3(c->origin, s->box.axes[thin]) - j->middle[thin];
    const float away = s->lean[thin] < 0 ? -t : t, pulled = dmi_dot3(j->drag, s->box.axes[thin]);
    const float least = 0.005f * s->diagonal;
    out[0] = dmi_min(fabsf(w) / dmi_max(0.5f * j->side[wide], least), 2);
    out[1] = dmi_min(dmi_max((fabsf(w) - 0.5f * j->side[wide]) / s->diagonal, -0.5f), 0.5f);
    out[2] = dmi_min(dmi_max(away / dmi_max(0.5f * j->side[thin], least), -4), 4);
    out[3] = dmi_min(dmi_max(away / s->diagonal, -0.5f), 0.5f);
    out[4] = fabsf(s->lean[thin]);
    out[5] = corner(w, away, j->side[wide], j->side[thin], s->diagonal);
    out[6] = corner(w, -away, j->side[wide], j->side[thin], s->diagonal);
    out[7] = fabsf(pulled) < 0.5f ? 0 : dmi_min(dmi_max((pulled < 0 ? -t : t) / s->diagonal, -0.5f), 0.5f);
}

static void along_evidence(const judge* j, const dmi_candidate* c, float out[4]) {
    const dmi_study* s = j->study;
    memset(out, 0, 4 * sizeof *out);
    if (slides(c)) return;
    float low, high;
    dmi_shape_limits((const float(*)[3])s->extremes, s->extreme_count, (const float(*)[3]) & c->axis, 1, &low, &high);
    float at = dmi_dot3(c->origin, c->axis);
    for (int i = 0; i < 9; i++) {
        float x[3];
        dmi_madd3(c->origin, low + (high - low) * (float)i / 8 - at, c->axis, x);
        float body = dmi_field_distance(&s->body_field, x) / s->diagonal;
        float part = dmi_field_distance(&s->part_field, x) / s->diagonal;
        out[0] += body / 9, out[1] = dmi_max(out[1], body);
        out[2] += part / 9, out[3] = dmi_max(out[3], part);
    }
}

/* Mean distance from itself of the part turned by half a turn, and least over thirds to sixths. */
static void symmetry_evidence(const judge* j, const dmi_candidate* c, float out[3]) {
    const dmi_study* s = j->study;
    memset(out, 0, 3 * sizeof *out);
    if (slides(c)) return;
    static const float cosine[5] = {-1, -0.5f, 0, 0.30901699f, 0.5f};
    static const float sine[5] = {0, 0.8660254f, 1, 0.95105652f, 0.8660254f};
    dmi_moved m;
    carry(c, s->points, SYMMETRY_POINTS, &m);
    float mean[5] = {0};
    for (int k = 0; k < 5; k++) {
        float distance[DMI_FIELD_BATCH];
        dmi_moved_distances(&m, cosine[k], sine[k], 0, &s->part_field, distance);
        for (int i = 0; i < SYMMETRY_POINTS; i++) mean[k] += dmi_min(distance[i] / s->diagonal, 0.5f) / SYMMETRY_POINTS;
    }
    float least = dmi_min(dmi_min(mean[1], mean[2]), dmi_min(mean[3], mean[4]));
    out[0] = mean[0], out[1] = least, out[2] = expf(-dmi_min(least, mean[0]) / 0.02f);
}

/* Distance of the handle from the axis over the part's own farthest, whether the handle runs along the axis, and its
 * size. most: largest distance of the part from the axis. */
static void handle_evidence(const judge* j, const dmi_candidate* c, float most, float out[4]) {
    const dmi_study* s = j->study;
    memset(out, 0, 4 * sizeof *out);
    if (s->handle_spread <= 0) return;
    out[0] = s->handle_spread / s->diagonal;
    out[1] = fabsf(dmi_dot3(s->handle_direction, c->axis));
    if (slides(c)) return;
    out[2] = dmi_line_distance3(s->handle, c->axis, c->origin) / (most + 1e-9f);
    float off[3], arm[3];
    dmi_sub3(s->handle, s->centre, off);
    dmi_sub3(s->centre, c->origin, arm);
    out[3] = dmi_dot3(off, arm) / (dmi_length3(arm) * s->diagonal + 1e-9f);
}

/* What a hand would take hold of: its share of the part, its size, whether it runs along the axis, its distance from
 * the axis over the part's farthest, and how far beyond the part's middle it lies, seen from the axis. */
static void grip_evidence(const judge* j, const dmi_candidate* c, float most, float out[6]) {
    const dmi_study* s = j->study;
    memset(out, 0, 6 * sizeof *out);
    if (s->grip_share <= 0) return;
    out[0] = 1;
    out[1] = s->grip_share;
    out[2] = s->grip_spread / s->diagonal;
    out[3] = fabsf(dmi_dot3(s->grip_direction, c->axis));
    if (slides(c)) return;
    float off[3], arm[3];
    dmi_sub3(s->grip, s->centre, off);
    dmi_sub3(s->centre, c->origin, arm);
    dmi_reject3(arm, c->axis);
    out[4] = dmi_line_distance3(s->grip, c->axis, c->origin) / (most + 1e-9f);
    out[5] = dmi_dot3(off, arm) / (dmi_length3(arm) * s->diagonal + 1e-9f);
}

/* Seen from the part's centre towards the axis: how far from the object's far side the axis runs, where the part's
 * centre lies, how wide the object is; and how much of the object's length along the axis the part takes. */
static void outline_evidence(const judge* j, const dmi_candidate* c, float out[4]) {
    const dmi_study* s = j->study;
    memset(out, 0, 4 * sizeof *out);
    float way[2][3], low[2], high[2], part_low, part_high;
    dmi_copy3(c->axis, way[0]);
    dmi_sub3(c->origin, s->centre, way[1]);
    dmi_reject3(way[1], c->axis);
    int off_centre = dmi_normalize3(way[1]) > 0.02f * s->diagonal;
    dmi_shape_limits((const float(*)[3])s->outline, s->outline_count, (const float(*)[3])way, off_centre ? 2 : 1, low,
                     high);
    dmi_shape_limits((const float(*)[3])s->extremes, s->extreme_count, (const float(*)[3])way, 1, &part_low,
                     &part_high);
    out[0] = (part_high - part_low) / (high[0] - low[0] + 1e-9f);
    if (slides(c) || !off_centre) return;
    float width = high[1] - low[1] + 1e-9f;
    out[1] = dmi_max((high[1] - dmi_dot3(c->origin, way[1])) / width, -1);
    out[2] = (dmi_dot3(s->centre, way[1]) - low[1]) / width;
    out[3] = dmi_min(logf(width / s->diagonal), 3);
}

/* most: largest distance of the part from the axis. */
static void drag_evidence(const judge* j, const dmi_candidate* c, float most, float out[11]) {
    memset(out, 0, 11 * sizeof *out);
    if (j->hint == NULL) return;
    const dmi_study* s = j->study;
    float v[3], low, high;
    dmi_candidate_velocity(c, j->hint->point, v);
    float speed = dmi_length3(v), cosine = dmi_dot3(v, j->drag) / (speed + 1e-12f);
    float angle = acosf(dmi_min(dmi_max(cosine, -1), 1));
    dmi_shape_limits((const float(*)[3])s->extremes, s->extreme_count, (const float(*)[3]) & c->axis, 1, &low, &high);
    float along = (dmi_dot3(j->hint->point, c->axis) - low) / dmi_max(high - low, 1e-6f);
    out[0] = 1;
    out[1] = slides(c) ? 0 : dmi_min(speed / (most + 1e-9f), 2);
    out[2] = angle;
    out[3] = expf(-angle / 0.01f);
    out[4] = expf(-angle / 0.1f);
    out[5] = fabsf(dmi_dot3(j->drag, j->drag_normal));
    for (int k = 0; k < 3; k++) out[6 + k] = fabsf(dmi_dot3(j->drag, s->box.axes[k]));
    out[9] = dmi_max(out[6], dmi_max(out[7], out[8]));
    out[10] = dmi_min(fabsf(along - 0.5f), 2);
}

static void network_evidence(const judge* j, const dmi_candidate* c, float out[12]) {
    memset(out, 0, 12 * sizeof *out);
    const dmi_prediction* p = j->prediction;
    if (p == NULL) return;
    float turning = p->type[0] + p->type[2] + p->type[3];
    float cosine = fabsf(dmi_dot3(c->axis, slides(c) ? p->slide_axis : p->turn_axis));
    float angle = acosf(dmi_min(cosine, 1));
    out[0] = 1;
    out[1] = slides(c) ? p->type[1] : turning;
    out[2] = angle, out[3] = expf(-angle / 0.05f), out[4] = expf(-angle / 0.2f);
    for (int k = 0; k < DMI_KPP_TYPES; k++) out[8 + k] = p->type[k];
    if (slides(c)) return;
    float off = dmi_line_distance3(p->origin, c->axis, c->origin) / j->study->diagonal;
    out[5] = dmi_min(off, 3), out[6] = expf(-off / 0.03f), out[7] = expf(-off / 0.12f);
}

static void family_evidence(const dmi_candidate* c, float* direction, float* origin) {
    for (int k = 0; k < DMI_DIRECTION_FAMILIES; k++) direction[k] = (float)(c->direction_families >> k & 1);
    for (int k = 0; k < DMI_ORIGIN_FAMILIES; k++) origin[k] = (float)(c->origin_families >> k & 1);
}

static judge make_judge(const dmi_study* study, const dmi_drag_hint* hint, const dmi_prediction* prediction) {
    judge j = {.study = study, .hint = hint, .prediction = prediction};
    for (int k = 0; k < 3; k++) {
        j.side[k] = study->box.high[k] - study->box.low[k];
        j.middle[k] = (study->box.high[k] + study->box.low[k]) / 2;
        dmi_madd3(j.box_centre, j.middle[k], study->box.axes[k], j.box_centre);
    }
    for (int i = 0; i < SWEEP_POINTS; i++)
        j.free[i] = dmi_field_distance(&study->body_field, study->points[i]) > 2.1f * study->body_field.cell;
    shape_evidence(&j, j.shape);
    if (hint == NULL) return j;
    dmi_copy3(hint->vector, j.drag);
    dmi_normalize3(j.drag);
    float least = INFINITY;
    for (uint32_t i = 0; i < DMI_STUDY_PART; i++) {
        float d = dmi_distance3(study->points[i], hint->point);
        if (d < least) least = d, dmi_copy3(study->normals[i], j.drag_normal);
    }
    return j;
}

/* How far each candidate's costs are above the least of its own type, and above the least of the other type: whether
 * this part slides better than it turns shows only between candidates. How well the drag is followed is held against
 * what the shape alone suggests: a drag that hits one of its directions to a hair was meant so. */
static void relative_evidence(const dmi_candidate* candidates, uint32_t count, float (*rows)[DMI_EVIDENCE_COUNT]) {
    static const int of[RELATIVE] = {DMI_EVIDENCE_SLIP,         DMI_EVIDENCE_CONTACT,      DMI_EVIDENCE_CONTACT + 14,
                                     DMI_EVIDENCE_CONTACT + 15, DMI_EVIDENCE_CONTACT + 16, DMI_EVIDENCE_SWEEP,
                                     DMI_EVIDENCE_SWEEP + 2,    DMI_EVIDENCE_SWEEP + 4,    DMI_EVIDENCE_SWEEP + 6,
                                     DMI_EVIDENCE_SYMMETRY + 1, DMI_EVIDENCE_ALONG,        DMI_EVIDENCE_DRAG + 2};
    for (int k = 0; k < RELATIVE; k++) {
        float best[2] = {1, 1}; /* all costs are about 0 to 1 */
        for (uint32_t i = 0; i < count; i++) {
            int type = rows[i][DMI_EVIDENCE_SLIDES] > 0;
            if (k == FOLLOWS && (candidates[i].direction_families & DMI_DIRECTION_DRAG) != 0) continue;
            best[type] = dmi_min(best[type], rows[i][of[k]]);
        }
        for (uint32_t i = 0; i < count; i++) {
            int type = rows[i][DMI_EVIDENCE_SLIDES] > 0;
            rows[i][DMI_EVIDENCE_RELATIVE + k] = rows[i][of[k]] - best[type];
            rows[i][DMI_EVIDENCE_RELATIVE + RELATIVE + k] = rows[i][of[k]] - best[!type];
        }
    }
}

/* The network's choice among the candidates: each one's score below the best of all and below the best of its own type,
 * as a distance and as a likeness; how its type's best does against the other type's; its share of all. */
static void choice_evidence(const float* scores, uint32_t count, float (*rows)[DMI_EVIDENCE_COUNT]) {
    float best[2] = {-INFINITY, -INFINITY}, sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const int type = rows[i][DMI_EVIDENCE_SLIDES] > 0;
        best[type] = dmi_max(best[type], scores[i]);
    }
    const float most = dmi_max(best[0], best[1]);
    for (uint32_t i = 0; i < count; i++) sum += expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) {
        const int type = rows[i][DMI_EVIDENCE_SLIDES] > 0;
        float* out = rows[i] + DMI_EVIDENCE_CHOICE;
        out[0] = dmi_max(scores[i] - most, -12) / 4;
        out[1] = expf(scores[i] - most);
        out[2] = dmi_max(scores[i] - best[type], -12) / 4;
        out[3] = expf(scores[i] - best[type]);
        out[4] = dmi_max(dmi_min(best[type] - best[!type], 8), -8) / 4;
        out[5] = dmi_max(scores[i] - most - logf(sum), -12) / 4;
    }
}

void dmi_evidence_make(const dmi_study* study, const dmi_drag_hint* hint, const dmi_prediction* prediction,
                       const float* scores, const dmi_candidate* candidates, uint32_t count,
                       float (*out)[DMI_EVIDENCE_COUNT]) {
    judge j = make_judge(study, hint, prediction);
    for (uint32_t i = 0; i < count; i++) {
        const dmi_candidate* c = &candidates[i];
        float* row = out[i];
        row[DMI_EVIDENCE_SLIDES] = slides(c) ? 1.0f : 0.0f;
        float speed = surface_speed(&j, c, &row[DMI_EVIDENCE_SLIP]);
        for (int k = 0; k < DMI_STUDY_CONTACTS; k++)
            contact_evidence(&j, c, &study->contacts[k], speed, row + DMI_EVIDENCE_CONTACT + 7 * k);
        sweep_evidence(&j, c, row + DMI_EVIDENCE_SWEEP);
        memcpy(row + DMI_EVIDENCE_SHAPE, j.shape, sizeof j.shape);
        alignment_evidence(&j, c, row + DMI_EVIDENCE_ALIGNMENT);
        place_evidence(&j, c, row + DMI_EVIDENCE_PLACE);
        side_evidence(&j, c, row + DMI_EVIDENCE_SIDE);
        spot_evidence(&j, c, row + DMI_EVIDENCE_SPOT);
        along_evidence(&j, c, row + DMI_EVIDENCE_ALONG);
        symmetry_evidence(&j, c, row + DMI_EVIDENCE_SYMMETRY);
        float most = row[DMI_EVIDENCE_PLACE + 5] * study->diagonal;
        drag_evidence(&j, c, most, row + DMI_EVIDENCE_DRAG);
        handle_evidence(&j, c, most, row + DMI_EVIDENCE_HANDLE);
        grip_evidence(&j, c, most, row + DMI_EVIDENCE_GRIP);
        outline_evidence(&j, c, row + DMI_EVIDENCE_OUTLINE);
        network_evidence(&j, c, row + DMI_EVIDENCE_NETWORK);
        family_evidence(c, row + DMI_EVIDENCE_DIRECTION, row + DMI_EVIDENCE_ORIGIN);
    }
    relative_evidence(candidates, count, out);
    if (scores != NULL)
        choice_evidence(scores, count, out);
    else
        for (uint32_t i = 0; i < count; i++)
            memset(out[i] + DMI_EVIDENCE_CHOICE, 0, (DMI_EVIDENCE_COUNT - DMI_EVIDENCE_CHOICE) * sizeof(float));
}
