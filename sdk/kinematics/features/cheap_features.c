/* Shape, place in the box, drag, families and the network's word: a few operations a candidate. */
#include "kinematics/features/cheap_features.h"

#include "math/linear3.h"

/* Slide, shape, alignment, offsets, place in the box, drag, network, families, handle, cross-section, grip, choice. */
const uint8_t dmi_cheap_columns[DMI_CHEAP_COLUMNS] = {
    0,   37,  38,  39,  40,  41,  42,  43,  44,  45,  46,  47,  48,  49,  50,  51,  52,  53,  54,  55,
    56,  57,  64,  65,  66,  67,  75,  77,  78,  79,  80,  81,  82,  83,  84,  86,  87,  88,  89,  90,
    91,  92,  93,  94,  95,  96,  97,  98,  99,  100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110,
    111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121, 122, 123, 124, 149, 150, 152, 157, 158, 159,
    160, 161, 162, 163, 164, 165, 166, 167, 168, 170, 171, 172, 173, 174, 175, 176};

static int slides(const dmi_candidate* c) {
    return c->type == DM_JOINT_PRISMATIC;
}

static void shape_evidence(const dmi_cheap_features* j, float out[5]) {
    float longest = dmi_max(j->side[0], 1e-6f);
    out[0] = j->side[2] / longest;
    out[1] = j->side[2] / dmi_max(j->side[1], 1e-6f);
    out[2] = j->side[1] / longest;
    out[3] = logf(j->study->diagonal);
    out[4] = logf(1 + j->study->area_ratio) / 5;
}

static void alignment_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float out[12]) {
    float longest = dmi_max(j->side[0], 1e-6f), thin = j->side[2] / longest, middle = j->side[1] / longest;
    for (int k = 0; k < 3; k++) {
        float cosine = fabsf(dmi_dot3(c->axis, j->study->box.axes[k])), aligned = cosine > 0.9995f ? 1.0f : 0.0f;
        out[k] = aligned;
        out[3 + k] = cosine;
        out[6 + k] = thin < 0.2f ? aligned : 0;
        out[9 + k] = aligned * middle;
    }
}

/* Distances from the centroid and the box's centre; how far the body is from the axis. */
static void offset_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float* place) {
    const dmi_part_analysis* s = j->study;
    for (int k = 0; k < 4; k++) place[k] = 0;
    place[10] = 0;
    if (slides(c)) return;
    const float off = dmi_line_distance3(s->centre, c->axis, c->origin) / s->diagonal;
    const float off_box = dmi_line_distance3(j->box_centre, c->axis, c->origin) / s->diagonal;
    place[0] = off, place[1] = expf(-off / 0.01f);
    place[2] = off_box, place[3] = expf(-off_box / 0.005f);
    place[10] = dmi_distance_grid_distance(&s->body_grid, c->origin) / s->diagonal;
}

/* The axis of the part's box that the candidate's is nearest to. */
static int box_axis_along(const dmi_cheap_features* j, const dmi_candidate* c) {
    int along = 0;
    float best = 0;
    for (int k = 0; k < 3; k++) {
        const float cosine = fabsf(dmi_dot3(c->axis, j->study->box.axes[k]));
        if (cosine > best) best = cosine, along = k;
    }
    return along;
}

static void side_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float out[3]) {
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
static void spot_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float out[8]) {
    memset(out, 0, 8 * sizeof *out);
    if (slides(c)) return;
    const dmi_part_analysis* s = j->study;
    const int along = box_axis_along(j, c);
    const int wide = along == 0 ? 1 : 0, thin = along == 2 ? 1 : 2; /* sides are sorted, longest first */
    const float w = dmi_dot3(c->origin, s->box.axes[wide]) - j->middle[wide];
    const float t = dmi_dot3(c->origin, s->box.axes[thin]) - j->middle[thin];
    const float away = s->body_side[thin] < 0 ? -t : t, pulled = dmi_dot3(j->drag, s->box.axes[thin]);
    const float least = 0.005f * s->diagonal;
    out[0] = dmi_min(fabsf(w) / dmi_max(0.5f * j->side[wide], least), 2);
    out[1] = dmi_min(dmi_max((fabsf(w) - 0.5f * j->side[wide]) / s->diagonal, -0.5f), 0.5f);
    out[2] = dmi_min(dmi_max(away / dmi_max(0.5f * j->side[thin], least), -4), 4);
    out[3] = dmi_min(dmi_max(away / s->diagonal, -0.5f), 0.5f);
    out[4] = fabsf(s->body_side[thin]);
    out[5] = corner(w, away, j->side[wide], j->side[thin], s->diagonal);
    out[6] = corner(w, -away, j->side[wide], j->side[thin], s->diagonal);
    out[7] = fabsf(pulled) < 0.5f ? 0 : dmi_min(dmi_max((pulled < 0 ? -t : t) / s->diagonal, -0.5f), 0.5f);
}

/* How well the drag is followed, and how it lies to the part. */
static void follow_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float* drag) {
    drag[0] = 0;
    for (int k = 2; k < 10; k++) drag[k] = 0;
    if (j->hint == NULL) return;
    float v[3];
    dmi_candidate_velocity(c, j->hint->point, v);
    const float speed = dmi_length3(v), cosine = dmi_dot3(v, j->drag) / (speed + 1e-12f);
    const float angle = acosf(dmi_min(dmi_max(cosine, -1), 1));
    drag[0] = 1;
    drag[2] = angle;
    drag[3] = expf(-angle / 0.01f);
    drag[4] = expf(-angle / 0.1f);
    drag[5] = fabsf(dmi_dot3(j->drag, j->drag_normal));
    for (int k = 0; k < 3; k++) drag[6 + k] = fabsf(dmi_dot3(j->drag, j->study->box.axes[k]));
    drag[9] = dmi_max(drag[6], dmi_max(drag[7], drag[8]));
}

/* The size of the handle, whether it runs along the axis, and how far beyond the part's middle it lies, seen from the
 * axis. */
static void handle_evidence(const dmi_part_analysis* s, const dmi_candidate* c, float* handle) {
    handle[0] = handle[1] = handle[3] = 0;
    if (s->widest_gap_spread <= 0) return;
    handle[0] = s->widest_gap_spread / s->diagonal;
    handle[1] = fabsf(dmi_dot3(s->widest_gap_direction, c->axis));
    if (slides(c)) return;
    float off[3], arm[3];
    dmi_sub3(s->widest_gap_mean, s->centre, off);
    dmi_sub3(s->centre, c->origin, arm);
    handle[3] = dmi_dot3(off, arm) / (dmi_length3(arm) * s->diagonal + 1e-9f);
}

/* What a hand would take hold of: its share of the part, its size, whether it runs along the axis, and how far beyond
 * the part's middle it lies, seen from the axis. */
static void grip_evidence(const dmi_part_analysis* s, const dmi_candidate* c, float* grip) {
    for (int k = 0; k < 4; k++) grip[k] = 0;
    grip[5] = 0;
    if (s->protrusion_share <= 0) return;
    grip[0] = 1;
    grip[1] = s->protrusion_share;
    grip[2] = s->protrusion_spread / s->diagonal;
    grip[3] = fabsf(dmi_dot3(s->protrusion_direction, c->axis));
    if (slides(c)) return;
    float off[3], arm[3];
    dmi_sub3(s->protrusion_mean, s->centre, off);
    dmi_sub3(s->centre, c->origin, arm);
    dmi_reject3(arm, c->axis);
    grip[5] = dmi_dot3(off, arm) / (dmi_length3(arm) * s->diagonal + 1e-9f);
}

static void network_evidence(const dmi_cheap_features* j, const dmi_candidate* c, float out[12]) {
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

void dmi_cheap_features_begin(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                              const dmi_prediction* prediction, dmi_cheap_features* out) {
    *out = (dmi_cheap_features){.study = study, .hint = hint, .prediction = prediction};
    for (int k = 0; k < 3; k++) {
        out->side[k] = study->box.high[k] - study->box.low[k];
        out->middle[k] = (study->box.high[k] + study->box.low[k]) / 2;
    }
    dmi_box_centre(&study->box, out->box_centre);
    shape_evidence(out, out->shape);
    if (hint == NULL) return;
    dmi_copy3(hint->vector, out->drag);
    dmi_normalize3(out->drag);
    float least = INFINITY;
    for (uint32_t i = 0; i < DMI_ANALYSIS_POINTS; i++) {
        float d = dmi_distance3(study->points[i], hint->point);
        if (d < least) least = d, dmi_copy3(study->normals[i], out->drag_normal);
    }
}

void dmi_cheap_features_row(const dmi_cheap_features* glance, const dmi_candidate* c, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_SLIDES] = slides(c) ? 1.0f : 0.0f;
    memcpy(row + DMI_FEATURE_SHAPE, glance->shape, sizeof glance->shape);
    alignment_evidence(glance, c, row + DMI_FEATURE_ALIGNMENT);
    offset_evidence(glance, c, row + DMI_FEATURE_PLACE);
    side_evidence(glance, c, row + DMI_FEATURE_SIDE);
    spot_evidence(glance, c, row + DMI_FEATURE_SPOT);
    follow_evidence(glance, c, row + DMI_FEATURE_DRAG);
    handle_evidence(glance->study, c, row + DMI_FEATURE_HANDLE);
    grip_evidence(glance->study, c, row + DMI_FEATURE_GRIP);
    network_evidence(glance, c, row + DMI_FEATURE_NETWORK);
    family_evidence(c, row + DMI_FEATURE_DIRECTION, row + DMI_FEATURE_ORIGIN);
}

/* The network's choice among the candidates: each one's score below the best of all and below the best of its own type,
 * as a distance and as a likeness; how its type's best does against the other type's; its share of all. */
void dmi_cheap_features_kpp_scores(const float* scores, uint32_t count, float (*rows)[DMI_FEATURE_COUNT]) {
    if (scores == NULL) {
        for (uint32_t i = 0; i < count; i++)
            memset(rows[i] + DMI_FEATURE_CHOICE, 0, (DMI_FEATURE_MIRROR - DMI_FEATURE_CHOICE) * sizeof(float));
        return;
    }
    float best[2] = {-INFINITY, -INFINITY}, sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const int type = rows[i][DMI_FEATURE_SLIDES] > 0;
        best[type] = dmi_max(best[type], scores[i]);
    }
    const float most = dmi_max(best[0], best[1]);
    for (uint32_t i = 0; i < count; i++) sum += expf(scores[i] - most);
    for (uint32_t i = 0; i < count; i++) {
        const int type = rows[i][DMI_FEATURE_SLIDES] > 0;
        float* out = rows[i] + DMI_FEATURE_CHOICE;
        out[0] = dmi_max(scores[i] - most, -12) / 4;
        out[1] = expf(scores[i] - most);
        out[2] = dmi_max(scores[i] - best[type], -12) / 4;
        out[3] = expf(scores[i] - best[type]);
        out[4] = dmi_max(dmi_min(best[type] - best[!type], 8), -8) / 4;
        out[5] = dmi_max(scores[i] - most - logf(sum), -12) / 4;
    }
}
