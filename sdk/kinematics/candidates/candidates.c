/* Combines directions with points to candidate axes. A drag excludes candidates that move its point elsewhere. */
#include "kinematics/candidates/candidates.h"

#include "kinematics/candidates/candidate_sources.h"
#include "math/linear3.h"

#define SAME_ANGLE 0.003f                                /* rad between axes that are merged; by hand */
#define SAME_COSINE (1 - 0.5f * SAME_ANGLE * SAME_ANGLE) /* its cosine, to second order */
#define SAME_ORIGIN 0.0015f                              /* object sizes between lines that are merged; by hand */
/* Least cosine between a candidate's velocity at the grabbed point and the drag, 37 degrees; by hand. */
#define NEAR_DRAG_COSINE 0.8f
/* The same for the candidates that come after those: a straight pull along an axis of the room is up to 55 degrees off;
 * by hand. */
#define FAR_DRAG_COSINE 0.5f
#define MAX_AXIS_COSINE 0.6f /* cosine between a revolute axis and the drag (at least 53 degrees apart); by hand */
#define MIN_ARM 0.02f        /* part diagonals from a revolute axis to the grabbed point, at least; by hand */
#define MAX_OFFSET 3         /* part diagonals from the part's centre to a revolute axis, at most …; by hand */
#define MIN_MAX_OFFSET 1.5f  /* … or object sizes, whichever is more; by hand */

enum { RECTANGLE_POINTS = 9 }; /* corners, centres of the sides, centre: 3 x 3 */

typedef struct collector {
    const dmi_part_analysis* analysis;
    const dmi_drag_hint* hint;
    float drag[3];                   /* unit */
    float least_cosine, most_cosine; /* cosines between a candidate's velocity at the grabbed point and the drag */
    dmi_candidate* out;
    uint32_t count;
} collector;

static bool is_in_range(const collector* c, float cosine) {
    return fabsf(cosine) >= c->least_cosine && fabsf(cosine) < c->most_cosine;
}

/* Signs the axis so that the grabbed point moves along the drag. Returns whether the cosine between both is in
 * range. */
static bool follow_drag(const collector* c, float axis[3], const float origin[3]) {
    if (c->hint == NULL) return true;
    float arm[3], velocity[3];
    dmi_sub3(c->hint->point, origin, arm);
    dmi_cross3(axis, arm, velocity);
    float speed = dmi_length3(velocity), along = dmi_dot3(velocity, c->drag);
    if (speed < MIN_ARM * c->analysis->diagonal || !is_in_range(c, along / speed)) return false;
    if (along < 0)
        for (int k = 0; k < 3; k++) axis[k] = -axis[k];
    return true;
}

/* Adds a revolute joint; its origin becomes the point of the axis nearest to the part's centre. Merges it with an equal
 * line among the candidates from `first` on. */
static void add_revolute(collector* c, uint32_t first, const float d[3], uint32_t direction_families, const float x[3],
                         uint32_t origin_families) {
    float axis[3], origin[3], offset[3];
    dmi_copy3(d, axis);
    dmi_sub3(x, c->analysis->centre, offset);
    dmi_reject3(offset, axis);
    dmi_madd3(c->analysis->centre, 1, offset, origin);
    for (uint32_t i = first; i < c->count; i++)
        if (dmi_distance3(origin, c->out[i].origin) < SAME_ORIGIN &&
            fabsf(dmi_dot3(axis, c->out[i].axis)) > SAME_COSINE) {
            c->out[i].origin_families |= origin_families;
            return;
        }
    if (c->count == DMI_CANDIDATES_MAX ||
        dmi_length3(offset) > dmi_max(MAX_OFFSET * c->analysis->diagonal, MIN_MAX_OFFSET))
        return;
    if (!follow_drag(c, axis, origin)) return;
    dmi_candidate* out = &c->out[c->count++];
    *out = (dmi_candidate){
        .type = DM_JOINT_REVOLUTE, .direction_families = direction_families, .origin_families = origin_families};
    dmi_copy3(axis, out->axis);
    dmi_copy3(origin, out->origin);
}

/* Adds axes through the corners, the centres of the sides and the centre of a rectangle perpendicular to them. */
static void add_rectangle(collector* c, uint32_t first, const dmi_source_direction* d, const float axes[2][3],
                          const float low[2], const float high[2], bool of_contact) {
    for (int i = 0; i < RECTANGLE_POINTS; i++) {
        int u = i % 3, w = i / 3;
        float x[3] = {0, 0, 0};
        dmi_madd3(x, low[0] + (high[0] - low[0]) * 0.5f * (float)u, axes[0], x);
        dmi_madd3(x, low[1] + (high[1] - low[1]) * 0.5f * (float)w, axes[1], x);
        uint32_t family = u == 1 && w == 1 ? DMI_ORIGIN_BOX : u == 1 || w == 1 ? DMI_ORIGIN_SIDE : DMI_ORIGIN_CORNER;
        add_revolute(c, first, d->d, d->families, x, of_contact ? DMI_ORIGIN_CONTACT_BOX : family);
    }
}

/* Adds axes half a thickness inside the two short sides of the rectangle, where the hinge of a panel lies. */
static void add_insets(collector* c, uint32_t first, const dmi_source_direction* d, const dmi_rectangle* r) {
    int along = r->high[0] - r->low[0] > r->high[1] - r->low[1] ? 0 : 1;
    float half = (r->high[1 - along] - r->low[1 - along]) / 2;
    for (int end = 0; end < 2; end++) {
        float x[3] = {0, 0, 0};
        dmi_madd3(x, end == 0 ? r->low[along] + half : r->high[along] - half, r->axes[along], x);
        dmi_madd3(x, r->low[1 - along] + half, r->axes[1 - along], x);
        add_revolute(c, first, d->d, d->families, x, DMI_ORIGIN_INSET);
    }
}

static void add_contact_boxes(collector* c, uint32_t first, const dmi_source_direction* d, const dmi_rectangle* r) {
    for (int k = 0; k < DMI_CONTACT_REGIONS; k++) {
        const dmi_contact* contact = &c->analysis->contacts[k];
        if (contact->count < DMI_MIN_CONTACT_POINTS) continue;
        float low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (uint32_t i = 0; i < contact->count; i++)
            for (int a = 0; a < 2; a++) {
                float t = dmi_dot3(c->analysis->points[contact->points[i]], r->axes[a]);
                low[a] = dmi_min(low[a], t), high[a] = dmi_max(high[a], t);
            }
        add_rectangle(c, first, d, r->axes, low, high, true);
    }
}

static void add_revolutes(collector* c, const dmi_candidate_sources* s, const dmi_source_direction* d) {
    uint32_t first = c->count;
    if (c->hint != NULL && fabsf(dmi_dot3(d->d, c->drag)) > MAX_AXIS_COSINE) return;
    dmi_rectangle r;
    dmi_min_area_rectangle((const float(*)[3])c->analysis->extreme_points, c->analysis->extreme_point_count, d->d, &r);
    add_rectangle(c, first, d, (const float(*)[3])r.axes, r.low, r.high, false);
    add_insets(c, first, d, &r);
    for (uint32_t i = 0; i < s->point_count; i++)
        add_revolute(c, first, d->d, d->families, s->points[i].x, s->points[i].families);
    add_contact_boxes(c, first, d, &r);
}

static void add_prismatic(collector* c, const float d[3], uint32_t families) {
    if (c->count == DMI_CANDIDATES_MAX) return;
    float along = 1;
    if (c->hint != NULL) {
        along = dmi_dot3(d, c->drag);
        if (!is_in_range(c, along)) return;
    }
    dmi_candidate* out = &c->out[c->count++];
    *out = (dmi_candidate){.type = DM_JOINT_PRISMATIC, .direction_families = families};
    for (int k = 0; k < 3; k++) out->axis[k] = along < 0 ? -d[k] : d[k];
    dmi_copy3(c->analysis->centre, out->origin);
}

static void add_all_revolutes(collector* c, const dmi_candidate_sources* s) {
    for (uint32_t i = 0; i < s->line_count; i++)
        add_revolute(c, 0, s->lines[i].d, s->lines[i].direction_families, s->lines[i].x, s->lines[i].origin_families);
    for (uint32_t i = 0; i < s->direction_count; i++) add_revolutes(c, s, &s->directions[i]);
}

static collector begin_candidates(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, dmi_candidate* out,
                                  uint32_t count) {
    collector c = {.analysis = analysis, .hint = hint, .out = out, .count = count};
    if (hint == NULL) return c;
    dmi_copy3(hint->vector, c.drag);
    dmi_normalize3(c.drag);
    return c;
}

/* Returns whether there is a slide along a unit direction, or a turn about it through a point. */
static bool has_candidate(const collector* c, int32_t type, const float d[3], const float x[3]) {
    for (uint32_t i = 0; i < c->count; i++) {
        const dmi_candidate* one = &c->out[i];
        if (one->type != type || fabsf(dmi_dot3(one->axis, d)) <= SAME_COSINE) continue;
        if (type == DM_JOINT_PRISMATIC || dmi_line_distance3(x, one->axis, one->origin) < SAME_ORIGIN) return true;
    }
    return false;
}

uint32_t dmi_candidates_add_through(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, const float point[3],
                                    const float (*directions)[3], uint32_t direction_count, dmi_candidate* candidates,
                                    uint32_t count) {
    collector c = begin_candidates(analysis, hint, candidates, count);
    c.least_cosine = FAR_DRAG_COSINE, c.most_cosine = INFINITY;
    for (uint32_t i = 0; i < direction_count; i++) {
        if (!has_candidate(&c, DM_JOINT_REVOLUTE, directions[i], point))
            add_revolute(&c, c.count, directions[i], 0, point, 0);
        if (!has_candidate(&c, DM_JOINT_PRISMATIC, directions[i], point)) add_prismatic(&c, directions[i], 0);
    }
    return c.count;
}

uint32_t dmi_candidates_make(const dmi_part_analysis* analysis, const dmi_drag_hint* hint,
                             const dmi_prediction* prediction, dmi_candidate* out) {
    collector c = begin_candidates(analysis, hint, out, 0);
    dmi_candidate_sources s;
    dmi_candidate_sources_find(analysis, hint, c.drag, prediction, &s);
    c.least_cosine = NEAR_DRAG_COSINE, c.most_cosine = INFINITY;
    for (uint32_t i = 0; i < s.direction_count; i++) add_prismatic(&c, s.directions[i].d, s.directions[i].families);
    if (hint != NULL) add_prismatic(&c, c.drag, DMI_DIRECTION_DRAG);
    add_all_revolutes(&c, &s);
    if (hint == NULL) return c.count;
    c.least_cosine = FAR_DRAG_COSINE, c.most_cosine = NEAR_DRAG_COSINE;
    for (uint32_t i = 0; i < s.direction_count; i++) add_prismatic(&c, s.directions[i].d, s.directions[i].families);
    add_all_revolutes(&c, &s);
    return c.count;
}

void dmi_prediction_candidates(const dmi_prediction* prediction, const float centre[3], dmi_candidate out[2],
                               float out_probability[2]) {
    const float* axes[2] = {prediction->turn_axis, prediction->slide_axis};
    const float* points[2] = {prediction->origin, centre};
    for (int i = 0; i < 2; i++) {
        float arm[3];
        out[i] = (dmi_candidate){.type = i == 0 ? DM_JOINT_REVOLUTE : DM_JOINT_PRISMATIC,
                                 .direction_families = DMI_DIRECTION_NETWORK,
                                 .origin_families = DMI_ORIGIN_NETWORK};
        dmi_copy3(axes[i], out[i].axis);
        dmi_sub3(centre, points[i], arm);
        const float along = dmi_dot3(arm, axes[i]);
        for (int k = 0; k < 3; k++) out[i].origin[k] = points[i][k] + along * axes[i][k];
    }
    out_probability[1] = prediction->type[DM_JOINT_PRISMATIC - 1];
    out_probability[0] = 1 - out_probability[1];
}
