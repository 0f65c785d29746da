/* Gathers directions, points and lines, some of clusters of the contacts. The order of the sources is that of the
 * candidates. */
#include "kinematics/candidates/candidate_sources.h"

#include "kinematics/analysis/part_analysis.h"
#include "math/linear3.h"

#define SAME_ANGLE 0.003f                                /* rad between directions that are merged; by hand */
#define SAME_COSINE (1 - 0.5f * SAME_ANGLE * SAME_ANGLE) /* its cosine, to second order */
#define MIN_LENGTH 1e-6f                                 /* object sizes; a shorter vector has no direction; by hand */
#define MAX_PATCH_RESIDUAL 0.12f /* largest residual of rotational slippage for a patch's axis; by hand */
/* Largest residual of rotational slippage for the axis of the part or a contact; by hand. */
#define MAX_SLIP_RESIDUAL 0.3f
#define MAX_PATCH_SIZE 1.2f      /* part diagonals; a larger body patch gives no centre; by hand */
#define MAX_ACROSS_COSINE 0.3f   /* |cosine| to the drag of directions that are made perpendicular to it; by hand */
#define MIN_ACROSS_COSINE 0.005f /* the same; below it they are perpendicular already; by hand */
#define MIN_CROSS_SINE 0.1f      /* least sine between the drag and a vector that it is crossed with; by hand */

/* ---- clusters of the contacts ---- */

#define DMI_MAX_CONTACT_CLUSTERS 4 /* most clusters of a region; by hand */
#define DMI_CLUSTERED_REGIONS 2    /* contact regions that are clustered: those with a fixed limit of the gap */

#define MAX_POINTS 256       /* most points of a region, evenly chosen, because the clustering is quadratic; by hand */
#define LINK_DISTANCE 0.05f  /* part diagonals between points of one cluster when all are used; by hand */
#define MIN_CLUSTER_POINTS 3 /* least points of a cluster; by hand */

typedef struct clustering {
    uint32_t points[MAX_POINTS], labels[MAX_POINTS]; /* indices of part points, cluster of each */
    uint32_t count;
} clustering;

/* Merges the clusters of all points that are closer than max_distance. */
static void link_points(const dmi_part_analysis* analysis, float max_distance, clustering* c) {
    for (uint32_t i = 0; i < c->count; i++)
        for (uint32_t j = 0; j < i; j++) {
            const float *a = analysis->points[c->points[i]], *b = analysis->points[c->points[j]];
            if (c->labels[i] == c->labels[j] || dmi_distance3(a, b) > max_distance) continue;
            uint32_t from = c->labels[i], to = c->labels[j];
            for (uint32_t k = 0; k < c->count; k++) c->labels[k] = c->labels[k] == from ? to : c->labels[k];
        }
}

/* Computes the centre of the cluster's bounding box. Returns its number of points. */
static uint32_t measure_cluster(const dmi_part_analysis* analysis, const clustering* c, uint32_t label,
                                float centre[3]) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    uint32_t size = 0;
    for (uint32_t i = 0; i < c->count; i++) {
        if (c->labels[i] != label) continue;
        size++;
        for (int k = 0; k < 3; k++) {
            low[k] = dmi_min(low[k], analysis->points[c->points[i]][k]);
            high[k] = dmi_max(high[k], analysis->points[c->points[i]][k]);
        }
    }
    for (int k = 0; k < 3; k++) centre[k] = (low[k] + high[k]) / 2;
    return size;
}

/* Computes the centres of the bounding boxes of the region's clusters (single linkage). Returns how many there are, or
 * 0 when the region is one cluster. */
static uint32_t contact_clusters_find(const dmi_part_analysis* analysis, const dmi_contact* contact,
                                      float out_centres[DMI_MAX_CONTACT_CLUSTERS][3]) {
    clustering c = {.count = 0};
    const uint32_t step = contact->count / MAX_POINTS + 1;
    for (uint32_t i = 0; i < contact->count && c.count < MAX_POINTS; i += step) {
        c.points[c.count] = contact->points[i], c.labels[c.count] = c.count;
        c.count++;
    }
    link_points(analysis, LINK_DISTANCE * analysis->diagonal * sqrtf((float)step), &c);
    uint32_t found = 0;
    for (uint32_t label = 0; label < c.count && found < DMI_MAX_CONTACT_CLUSTERS; label++) {
        const uint32_t size = measure_cluster(analysis, &c, label, out_centres[found]);
        if (size >= MIN_CLUSTER_POINTS && size < c.count) found++;
    }
    return found;
}

/* ---- sources ---- */

static void add_direction(dmi_candidate_sources* s, const float d[3], uint32_t family) {
    float unit[3];
    dmi_copy3(d, unit);
    if (!(dmi_normalize3(unit) > MIN_LENGTH)) return;
    for (uint32_t i = 0; i < s->direction_count; i++)
        if (fabsf(dmi_dot3(unit, s->directions[i].d)) > SAME_COSINE) {
            s->directions[i].families |= family;
            return;
        }
    if (s->direction_count == DMI_MAX_SOURCE_DIRECTIONS) return;
    dmi_copy3(unit, s->directions[s->direction_count].d);
    s->directions[s->direction_count++].families = family;
}

static void add_point(dmi_candidate_sources* s, const float x[3], uint32_t family) {
    if (s->point_count == DMI_MAX_SOURCE_POINTS) return;
    dmi_copy3(x, s->points[s->point_count].x);
    s->points[s->point_count++].families = family;
}

static void add_line(dmi_candidate_sources* s, const float d[3], const float x[3], uint32_t direction_family,
                     uint32_t origin_family) {
    if (s->line_count == DMI_MAX_SOURCE_POINTS) return;
    dmi_source_line* line = &s->lines[s->line_count++];
    dmi_copy3(d, line->d);
    dmi_copy3(x, line->x);
    line->direction_families = direction_family, line->origin_families = origin_family;
    add_direction(s, d, direction_family);
    add_point(s, x, origin_family);
}

/* ---- shape and contacts ---- */

static void add_contacts(const dmi_part_analysis* analysis, dmi_candidate_sources* s) {
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++) {
        const dmi_contact* contact = &analysis->contacts[c];
        if (contact->count < DMI_MIN_CONTACT_POINTS) continue;
        for (int i = 0; i < 3; i++) add_direction(s, contact->directions[i], DMI_DIRECTION_CONTACT);
        add_point(s, contact->mean, DMI_ORIGIN_CONTACT);
        add_point(s, contact->box_centre, DMI_ORIGIN_CONTACT);
    }
}

static void add_slippage(const dmi_part_analysis* analysis, dmi_candidate_sources* s) {
    for (int i = 0; i < 1 + 2 * DMI_CONTACT_REGIONS; i++) {
        const dmi_slippage* slip = &analysis->slippage[i];
        if (!analysis->has_slippage[i]) continue;
        for (int k = 0; k < 2; k++) {
            if (slip->turn_residual[k] < MAX_SLIP_RESIDUAL)
                add_line(s, slip->turn_axis[k], slip->turn_point[k], DMI_DIRECTION_SLIP, DMI_ORIGIN_SLIP);
            add_direction(s, slip->slide[k], DMI_DIRECTION_SLIP);
        }
    }
}

/* Adds axes and centres of patches. Centres of patches above max_size (diagonal) are left out. */
static void add_patches(const dmi_patch* patches, uint32_t count, float max_size, bool near, dmi_candidate_sources* s) {
    for (uint32_t i = 0; i < count; i++) {
        const dmi_patch* p = &patches[i];
        if (p->residual < MAX_PATCH_RESIDUAL)
            add_line(s, p->axis, p->point, near ? DMI_DIRECTION_NEAR_PATCH : DMI_DIRECTION_PATCH,
                     near ? DMI_ORIGIN_NEAR_LINE : DMI_ORIGIN_LINE);
        if (p->diagonal > max_size) continue;
        uint32_t family = near ? (p->is_shell ? DMI_ORIGIN_NEAR_SHELL : DMI_ORIGIN_NEAR_PATCH)
                               : (p->is_shell ? DMI_ORIGIN_SHELL : DMI_ORIGIN_PATCH);
        add_point(s, p->box_centre, family);
        if (p->is_shell) add_point(s, p->centroid, family);
    }
}

static void add_clusters(const dmi_part_analysis* analysis, dmi_candidate_sources* s) {
    for (int c = 0; c < DMI_CLUSTERED_REGIONS; c++) {
        float centres[DMI_MAX_CONTACT_CLUSTERS][3];
        const uint32_t count = contact_clusters_find(analysis, &analysis->contacts[c], centres);
        for (uint32_t i = 0; i < count; i++) add_point(s, centres[i], DMI_ORIGIN_CONTACT_CLUSTER);
    }
}

static void add_box_centre(const dmi_part_analysis* analysis, dmi_candidate_sources* s) {
    float centre[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        dmi_madd3(centre, (analysis->box.low[i] + analysis->box.high[i]) / 2, analysis->box.axes[i], centre);
    add_point(s, centre, DMI_ORIGIN_BOX);
}

/* ---- drag ---- */

/* Adds directions perpendicular to the drag: its cross products with face normals, box axes, and the offsets from the
 * grabbed point to the centre and to contacts. */
static void add_cross_products(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, const float drag[3],
                               dmi_candidate_sources* s) {
    float with[DMI_MAX_NORMAL_CLUSTERS + 3 + 1 + DMI_CONTACT_REGIONS][3];
    uint32_t count = 0;
    for (uint32_t i = 0; i < analysis->part_cluster_count; i++)
        dmi_copy3(analysis->part_clusters[i].direction, with[count++]);
    for (int i = 0; i < 3; i++) dmi_copy3(analysis->box.axes[i], with[count++]);
    dmi_sub3(analysis->centre, hint->point, with[count++]);
    for (int c = 0; c < DMI_CONTACT_REGIONS; c++)
        if (analysis->contacts[c].count >= DMI_MIN_CONTACT_POINTS)
            dmi_sub3(analysis->contacts[c].mean, hint->point, with[count++]);
    for (uint32_t i = 0; i < count; i++) {
        float across[3];
        dmi_cross3(drag, with[i], across);
        if (dmi_length3(across) > MIN_CROSS_SINE * dmi_length3(with[i])) add_direction(s, across, DMI_DIRECTION_DRAG);
    }
}

/* Adds the perpendicular components of directions that are nearly perpendicular to the drag. A revolute joint moves its
 * points exactly perpendicular to its axis, so an accurate drag corrects directions that the shape only approximates.
 */
static void add_perpendicular(const float drag[3], dmi_candidate_sources* s) {
    for (uint32_t i = 0, count = s->direction_count; i < count; i++) {
        float across[3];
        float along = dmi_dot3(s->directions[i].d, drag);
        if (fabsf(along) < MIN_ACROSS_COSINE || fabsf(along) > MAX_ACROSS_COSINE) continue;
        dmi_copy3(s->directions[i].d, across);
        dmi_reject3(across, drag);
        add_direction(s, across, DMI_DIRECTION_DRAG);
    }
}

/* ---- all of them ---- */

void dmi_candidate_sources_find(const dmi_part_analysis* analysis, const dmi_drag_hint* hint, const float drag[3],
                                const dmi_prediction* prediction, dmi_candidate_sources* out) {
    out->direction_count = out->point_count = out->line_count = 0;
    if (prediction != NULL)
        add_line(out, prediction->turn_axis, prediction->origin, DMI_DIRECTION_NETWORK, DMI_ORIGIN_NETWORK);
    for (int i = 0; i < 3; i++) add_direction(out, analysis->box.axes[i], DMI_DIRECTION_BOX);
    for (uint32_t i = 0; i < analysis->part_cluster_count; i++)
        add_direction(out, analysis->part_clusters[i].direction, DMI_DIRECTION_NORMAL);
    for (uint32_t i = 0; i < analysis->near_cluster_count; i++)
        add_direction(out, analysis->near_clusters[i].direction, DMI_DIRECTION_NEAR_NORMAL);
    for (int i = 0; i < 3; i++) add_direction(out, analysis->part_directions[i], DMI_DIRECTION_PART);
    if (prediction != NULL) add_direction(out, prediction->slide_axis, DMI_DIRECTION_NETWORK);

    add_point(out, analysis->centre, DMI_ORIGIN_CENTROID);
    add_box_centre(analysis, out);
    add_contacts(analysis, out);
    add_slippage(analysis, out);
    add_patches(analysis->part_patches, analysis->part_patch_count, INFINITY, false, out);
    add_patches(analysis->near_patches, analysis->near_patch_count, MAX_PATCH_SIZE * analysis->diagonal, true, out);
    add_clusters(analysis, out);
    if (hint != NULL) add_cross_products(analysis, hint, drag, out);
    for (int i = 0; i < 3; i++) add_direction(out, analysis->all_directions[i], DMI_DIRECTION_ALL);
    if (hint != NULL) add_perpendicular(drag, out);
}
