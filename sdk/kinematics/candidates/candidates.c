/* Gathers directions and points and crosses them; a drag leaves out what moves its point elsewhere. */
#include "kinematics/candidates/candidates.h"

#include "math/linear3.h"

#define MAX_DIRECTIONS 64
#define MAX_POINTS 128
#define SAME_DIRECTION (1 - 0.5f * 0.003f * 0.003f)
#define SAME_LINE 0.0015f
#define DRAG_CONE 0.8f   /* least cosine between a candidate's motion at the drag point and the drag: 37 degrees */
#define ACROSS_DRAG 0.6f /* most cosine between a turning axis and the drag */
#define NEARLY_ACROSS 0.3f
#define LAID_ALREADY 0.005f
#define LINE_RESIDUAL 0.12f
#define SLIP_RESIDUAL 0.3f

typedef struct direction {
    float d[3];
    uint32_t families;
} direction;

typedef struct anchor {
    float x[3];
    uint32_t families;
} anchor;

/* A line of its own: direction and point belong together. */
typedef struct axis_line {
    float d[3], x[3];
    uint32_t direction_families, origin_families;
} axis_line;

typedef struct suggestions {
    direction directions[MAX_DIRECTIONS];
    anchor points[MAX_POINTS];
    axis_line lines[MAX_POINTS];
    uint32_t direction_count, point_count, line_count;
} suggestions;

typedef struct collector {
    const dmi_part_analysis* study;
    const dmi_drag_hint* hint;
    float drag[3]; /* unit */
    dmi_candidate* out;
    uint32_t count;
} collector;

static void add_direction(suggestions* s, const float d[3], uint32_t family) {
    float unit[3];
    dmi_copy3(d, unit);
    if (!(dmi_normalize3(unit) > 1e-6f)) return;
    for (uint32_t i = 0; i < s->direction_count; i++)
        if (fabsf(dmi_dot3(unit, s->directions[i].d)) > SAME_DIRECTION) {
            s->directions[i].families |= family;
            return;
        }
    if (s->direction_count == MAX_DIRECTIONS) return;
    dmi_copy3(unit, s->directions[s->direction_count].d);
    s->directions[s->direction_count++].families = family;
}

static void add_point(suggestions* s, const float x[3], uint32_t family) {
    if (s->point_count == MAX_POINTS) return;
    dmi_copy3(x, s->points[s->point_count].x);
    s->points[s->point_count++].families = family;
}

static void add_line(suggestions* s, const float d[3], const float x[3], uint32_t direction_family,
                     uint32_t origin_family) {
    if (s->line_count == MAX_POINTS) return;
    axis_line* line = &s->lines[s->line_count++];
    dmi_copy3(d, line->d);
    dmi_copy3(x, line->x);
    line->direction_families = direction_family, line->origin_families = origin_family;
    add_direction(s, d, direction_family);
    add_point(s, x, origin_family);
}

static void suggest_contact(const dmi_part_analysis* study, suggestions* s) {
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++) {
        const dmi_contact* contact = &study->contacts[c];
        if (contact->count < 5) continue;
        for (int i = 0; i < 3; i++) add_direction(s, contact->directions[i], DMI_DIRECTION_CONTACT);
        add_point(s, contact->mean, DMI_ORIGIN_CONTACT);
        add_point(s, contact->box_centre, DMI_ORIGIN_CONTACT);
    }
    for (int i = 0; i < 1 + 2 * DMI_CONTACT_REGIONS; i++) {
        const dmi_slippage* slip = &study->slippage[i];
        if (!study->has_slippage[i]) continue;
        for (int k = 0; k < 2; k++) {
            if (slip->turn_residual[k] < SLIP_RESIDUAL)
                add_line(s, slip->turn_axis[k], slip->turn_point[k], DMI_DIRECTION_SLIP, DMI_ORIGIN_SLIP);
            add_direction(s, slip->slide[k], DMI_DIRECTION_SLIP);
        }
    }
}

static void suggest_patches(const dmi_patch* patches, uint32_t count, float largest, int near, suggestions* s) {
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        if (p->residual < LINE_RESIDUAL)
            add_line(s, p->axis, p->point, near ? DMI_DIRECTION_NEAR_PATCH : DMI_DIRECTION_PATCH,
                     near ? DMI_ORIGIN_NEAR_LINE : DMI_ORIGIN_LINE);
        if (p->diagonal > largest) continue;
        uint32_t family = near ? (p->is_shell ? DMI_ORIGIN_NEAR_SHELL : DMI_ORIGIN_NEAR_PATCH)
                               : (p->is_shell ? DMI_ORIGIN_SHELL : DMI_ORIGIN_PATCH);
        add_point(s, p->box_centre, family);
        if (p->is_shell) add_point(s, p->centroid, family);
    }
}

/* Groups the points of the first two contact regions that hang together: one hinge or runner each. */
static void suggest_clusters(const dmi_part_analysis* study, suggestions* s) {
    for (int c = 0; c < 2; c++) {
        const dmi_contact* contact = &study->contacts[c];
        uint32_t step = contact->count / 256 + 1, taken[256], group[256], n = 0;
        for (uint32_t i = 0; i < contact->count && n < 256; i += step) taken[n] = contact->points[i], group[n] = n, n++;
        float reach = 0.05f * study->diagonal * sqrtf((float)step);
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t j = 0; j < i; j++) {
                if (group[i] == group[j] || dmi_distance3(study->points[taken[i]], study->points[taken[j]]) > reach)
                    continue;
                uint32_t from = group[i], to = group[j];
                for (uint32_t k = 0; k < n; k++) group[k] = group[k] == from ? to : group[k];
            }
        for (uint32_t g = 0, found = 0; g < n && found < 4; g++) {
            float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, centre[3];
            uint32_t size = 0;
            for (uint32_t i = 0; i < n; i++) {
                if (group[i] != g) continue;
                size++;
                for (int k = 0; k < 3; k++) {
                    low[k] = dmi_min(low[k], study->points[taken[i]][k]);
                    high[k] = dmi_max(high[k], study->points[taken[i]][k]);
                }
            }
            if (size < 3 || size == n) continue;
            for (int k = 0; k < 3; k++) centre[k] = (low[k] + high[k]) / 2;
            add_point(s, centre, DMI_ORIGIN_CONTACT_CLUSTER);
            found++;
        }
    }
}

/* Directions that are nearly across the drag, laid across it: a turn moves its points exactly across its axis, so that
 * a careful drag corrects what the shape only suggests. */
static void straighten_directions(const float drag[3], suggestions* s) {
    for (uint32_t i = 0, count = s->direction_count; i < count; i++) {
        float across[3];
        float along = dmi_dot3(s->directions[i].d, drag);
        if (fabsf(along) < LAID_ALREADY || fabsf(along) > NEARLY_ACROSS) continue;
        dmi_copy3(s->directions[i].d, across);
        dmi_reject3(across, drag);
        add_direction(s, across, DMI_DIRECTION_DRAG);
    }
}

/* Directions across the drag: with a face normal, a side of the box, the way to the centre or to a contact. */
static void suggest_drag(const dmi_part_analysis* study, const dmi_drag_hint* hint, const float drag[3],
                         suggestions* s) {
    float with[DMI_MAX_NORMAL_CLUSTERS + 3 + 1 + DMI_CONTACT_REGIONS][3];
    uint32_t count = 0;
    for (uint32_t i = 0; i < study->part_cluster_count; i++)
        dmi_copy3(study->part_clusters[i].direction, with[count++]);
    for (int i = 0; i < 3; i++) dmi_copy3(study->box.axes[i], with[count++]);
    dmi_sub3(study->centre, hint->point, with[count++]);
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++)
        if (study->contacts[c].count >= 5) dmi_sub3(study->contacts[c].mean, hint->point, with[count++]);
    for (uint32_t i = 0; i < count; i++) {
        float across[3];
        dmi_cross3(drag, with[i], across);
        if (dmi_length3(across) > 0.1f * dmi_length3(with[i])) add_direction(s, across, DMI_DIRECTION_DRAG);
    }
}

static void gather(const dmi_part_analysis* study, const collector* c, const dmi_prediction* prediction,
                   suggestions* s) {
    float middle[3] = {0, 0, 0};
    if (prediction != NULL)
        add_line(s, prediction->turn_axis, prediction->origin, DMI_DIRECTION_NETWORK, DMI_ORIGIN_NETWORK);
    for (int i = 0; i < 3; i++) add_direction(s, study->box.axes[i], DMI_DIRECTION_BOX);
    for (uint32_t i = 0; i < study->part_cluster_count; i++)
        add_direction(s, study->part_clusters[i].direction, DMI_DIRECTION_NORMAL);
    for (uint32_t i = 0; i < study->near_cluster_count; i++)
        add_direction(s, study->near_clusters[i].direction, DMI_DIRECTION_NEAR_NORMAL);
    for (int i = 0; i < 3; i++) add_direction(s, study->part_directions[i], DMI_DIRECTION_PART);
    if (prediction != NULL) add_direction(s, prediction->slide_axis, DMI_DIRECTION_NETWORK);

    add_point(s, study->centre, DMI_ORIGIN_CENTROID);
    for (int i = 0; i < 3; i++)
        dmi_madd3(middle, (study->box.low[i] + study->box.high[i]) / 2, study->box.axes[i], middle);
    add_point(s, middle, DMI_ORIGIN_BOX);
    suggest_contact(study, s);
    suggest_patches(study->part_patches, study->part_patch_count, INFINITY, 0, s);
    suggest_patches(study->near_patches, study->near_patch_count, 1.2f * study->diagonal, 1, s);
    suggest_clusters(study, s);
    if (c->hint != NULL) suggest_drag(study, c->hint, c->drag, s);
    for (int i = 0; i < 3; i++) add_direction(s, study->all_directions[i], DMI_DIRECTION_ALL);
    if (c->hint != NULL) straighten_directions(c->drag, s);
}

/* Turns the axis so that the drag's point goes along the drag; 0 when it goes elsewhere or hardly moves. */
static int follow_drag(const collector* c, float axis[3], const float origin[3]) {
    if (c->hint == NULL) return 1;
    float arm[3], velocity[3];
    dmi_sub3(c->hint->point, origin, arm);
    dmi_cross3(axis, arm, velocity);
    float speed = dmi_length3(velocity), along = dmi_dot3(velocity, c->drag);
    if (speed < 0.02f * c->study->diagonal || fabsf(along) < DRAG_CONE * speed) return 0;
    if (along < 0)
        for (int k = 0; k < 3; k++) axis[k] = -axis[k];
    return 1;
}

/* `first`: where the candidates of the same direction begin; equal lines among them are merged. */
static void add_turn(collector* c, uint32_t first, const float d[3], uint32_t direction_families, const float x[3],
                     uint32_t origin_families) {
    float axis[3], origin[3], offset[3];
    dmi_copy3(d, axis);
    dmi_sub3(x, c->study->centre, offset);
    dmi_reject3(offset, axis);
    dmi_madd3(c->study->centre, 1, offset, origin);
    for (uint32_t i = first; i < c->count; i++)
        if (dmi_distance3(origin, c->out[i].origin) < SAME_LINE &&
            fabsf(dmi_dot3(axis, c->out[i].axis)) > SAME_DIRECTION) {
            c->out[i].origin_families |= origin_families;
            return;
        }
    if (c->count == DMI_CANDIDATES_MAX || dmi_length3(offset) > dmi_max(3 * c->study->diagonal, 1.5f)) return;
    if (!follow_drag(c, axis, origin)) return;
    dmi_candidate* out = &c->out[c->count++];
    *out = (dmi_candidate){
        .type = DM_JOINT_REVOLUTE, .direction_families = direction_families, .origin_families = origin_families};
    dmi_copy3(axis, out->axis);
    dmi_copy3(origin, out->origin);
}

/* Corners, sides and middle of a rectangle across the axis. */
static void add_rectangle(collector* c, uint32_t first, const direction* d, const float axes[2][3], const float low[2],
                          const float high[2], int of_contact) {
    for (int i = 0; i < 9; i++) {
        int u = i % 3, w = i / 3;
        float x[3] = {0, 0, 0};
        dmi_madd3(x, low[0] + (high[0] - low[0]) * 0.5f * (float)u, axes[0], x);
        dmi_madd3(x, low[1] + (high[1] - low[1]) * 0.5f * (float)w, axes[1], x);
        uint32_t family = u == 1 && w == 1 ? DMI_ORIGIN_BOX : u == 1 || w == 1 ? DMI_ORIGIN_SIDE : DMI_ORIGIN_CORNER;
        add_turn(c, first, d->d, d->families, x, of_contact ? DMI_ORIGIN_CONTACT_BOX : family);
    }
}

/* Half a thickness inside the two far sides of the rectangle: where a slab's hinge runs. */
static void add_insets(collector* c, uint32_t first, const direction* d, const dmi_rectangle* r) {
    int along = r->high[0] - r->low[0] > r->high[1] - r->low[1] ? 0 : 1;
    float half = (r->high[1 - along] - r->low[1 - along]) / 2;
    for (int end = 0; end < 2; end++) {
        float x[3] = {0, 0, 0};
        dmi_madd3(x, end == 0 ? r->low[along] + half : r->high[along] - half, r->axes[along], x);
        dmi_madd3(x, r->low[1 - along] + half, r->axes[1 - along], x);
        add_turn(c, first, d->d, d->families, x, DMI_ORIGIN_INSET);
    }
}

static void add_contact_boxes(collector* c, uint32_t first, const direction* d, const dmi_rectangle* r) {
    for (int k = 0; k < DMI_CONTACT_REGIONS; k++) {
        const dmi_contact* contact = &c->study->contacts[k];
        if (contact->count < 5) continue;
        float low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (uint32_t i = 0; i < contact->count; i++)
            for (int a = 0; a < 2; a++) {
                float t = dmi_dot3(c->study->points[contact->points[i]], r->axes[a]);
                low[a] = dmi_min(low[a], t), high[a] = dmi_max(high[a], t);
            }
        add_rectangle(c, first, d, r->axes, low, high, 1);
    }
}

static void add_turns(collector* c, const suggestions* s, const direction* d) {
    uint32_t first = c->count;
    if (c->hint != NULL && fabsf(dmi_dot3(d->d, c->drag)) > ACROSS_DRAG) return;
    dmi_rectangle r;
    dmi_min_area_rectangle((const float(*)[3])c->study->extreme_points, c->study->extreme_point_count, d->d, &r);
    add_rectangle(c, first, d, (const float(*)[3])r.axes, r.low, r.high, 0);
    add_insets(c, first, d, &r);
    for (uint32_t i = 0; i < s->point_count; i++)
        add_turn(c, first, d->d, d->families, s->points[i].x, s->points[i].families);
    add_contact_boxes(c, first, d, &r);
}

static void add_slide(collector* c, const float d[3], uint32_t families) {
    if (c->count == DMI_CANDIDATES_MAX) return;
    float along = 1;
    if (c->hint != NULL) {
        along = dmi_dot3(d, c->drag);
        if (fabsf(along) < DRAG_CONE) return;
    }
    dmi_candidate* out = &c->out[c->count++];
    *out = (dmi_candidate){.type = DM_JOINT_PRISMATIC, .direction_families = families};
    for (int k = 0; k < 3; k++) out->axis[k] = along < 0 ? -d[k] : d[k];
    dmi_copy3(c->study->centre, out->origin);
}

uint32_t dmi_candidates_make(const dmi_part_analysis* study, const dmi_drag_hint* hint,
                             const dmi_prediction* prediction, dmi_candidate* out) {
    collector c = {.study = study, .hint = hint, .out = out};
    if (hint != NULL) {
        dmi_copy3(hint->vector, c.drag);
        dmi_normalize3(c.drag);
    }
    suggestions s = {.direction_count = 0};
    gather(study, &c, prediction, &s);
    for (uint32_t i = 0; i < s.direction_count; i++) add_slide(&c, s.directions[i].d, s.directions[i].families);
    if (hint != NULL) add_slide(&c, c.drag, DMI_DIRECTION_DRAG);
    for (uint32_t i = 0; i < s.line_count; i++)
        add_turn(&c, 0, s.lines[i].d, s.lines[i].direction_families, s.lines[i].x, s.lines[i].origin_families);
    for (uint32_t i = 0; i < s.direction_count; i++) add_turns(&c, &s, &s.directions[i]);
    return c.count;
}
