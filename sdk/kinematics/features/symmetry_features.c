/* Compares the part and the body near it with their mirror images, by distance grids. */
#include "kinematics/features/feature_groups.h"

#include "math/linear3.h"

#define PART_POINTS 64         /* points of the part that are compared; by hand */
#define BODY_POINTS 128        /* points of the body that are compared; by hand */
#define SAME_COSINE 0.9999998f /* 0.6 mrad between the normals of one mirror; by hand */
#define UNLIKE 0.25f           /* diagonals: farther than this is no likeness at all; by hand */
#define KNOWN_SHARE 4          /* one image in so many must lie in the grid; by hand */
#define OFF_CENTRE 0.02f       /* diagonals from which an axis lies to a side of the box's centre; by hand */
#define LEAST_WIDTH 1e-9f      /* avoids a division by 0 */

typedef struct sample {
    const float (*points)[3];
    uint32_t count;
} sample;

void dmi_symmetry_begin(const dmi_part_analysis* analysis, dmi_symmetry* out) {
    out->analysis = analysis;
    out->count = 0;
    dmi_box_centre(&analysis->box, out->centre);
}

static sample part_sample(const dmi_part_analysis* a) {
    return (sample){a->points, PART_POINTS};
}

static sample near_sample(const dmi_part_analysis* a) {
    return (sample){(const float(*)[3])a->near_points, a->near_count < BODY_POINTS ? a->near_count : BODY_POINTS};
}

/* Returns the mean distance of the points' images from the grid's samples, in the mirror of that normal at a place
 * along it. Counts only images that lie in the grid: beyond it nothing is known. */
static float image_distance(const float normal[3], float at, sample from, const dmi_distance_grid* grid, float size) {
    float image[3][DMI_POINT_BATCH], distance[DMI_POINT_BATCH], inside[DMI_POINT_BATCH], sum = 0, known = 0;
    for (uint32_t i = 0; i < from.count; i++) {
        const float* p = from.points[i];
        const float off = 2 * (at - dmi_dot3(p, normal));
        for (int k = 0; k < 3; k++) image[k][i] = p[k] + off * normal[k];
        inside[i] = 1;
    }
    dmi_distance_grid_distances(grid, (const float(*)[DMI_POINT_BATCH])image, from.count, distance);
    for (int k = 0; k < 3; k++) {
        const float low = grid->low[k], high = low + (float)grid->size[k] * grid->cell;
        for (uint32_t i = 0; i < from.count; i++) inside[i] = image[k][i] >= low && image[k][i] <= high ? inside[i] : 0;
    }
    for (uint32_t i = 0; i < from.count; i++) {
        sum += inside[i] * dmi_min(distance[i] / size, UNLIKE);
        known += inside[i];
    }
    return known == 0 || KNOWN_SHARE * known < (float)from.count ? UNLIKE : sum / known;
}

static void measure_middle(const dmi_symmetry* s, const float normal[3], dmi_mirror_distances* out) {
    const dmi_part_analysis* a = s->analysis;
    const float at = dmi_dot3(s->centre, normal);
    float low, high;
    out->part = image_distance(normal, at, part_sample(a), &a->part_grid, a->diagonal);
    out->body = image_distance(normal, at, near_sample(a), &a->body_grid, a->diagonal);
    dmi_extents_along((const float(*)[3])a->object_extreme_points, a->object_extreme_point_count,
                      (const float(*)[3])normal, 1, &low, &high);
    out->offset = dmi_min(fabsf(at - (low + high) / 2) / (high - low + LEAST_WIDTH), 1);
}

static void measure_twins(const dmi_part_analysis* a, const float normal[3], float out[2]) {
    float low, high;
    dmi_extents_along((const float(*)[3])a->extreme_points, a->extreme_point_count, (const float(*)[3])normal, 1, &low,
                      &high);
    out[0] = image_distance(normal, low, part_sample(a), &a->body_grid, a->diagonal);
    out[1] = image_distance(normal, high, part_sample(a), &a->body_grid, a->diagonal);
}

/* Returns the mirror plane with this normal, of either sign. When the table is full, its last entry is overwritten. */
static const dmi_mirror_plane* mirror_of(dmi_symmetry* s, const float normal[3]) {
    for (uint32_t i = 0; i < s->count; i++)
        if (fabsf(dmi_dot3(s->planes[i].normal, normal)) > SAME_COSINE) return &s->planes[i];
    if (s->count < DMI_MIRROR_PLANES) s->count++;
    dmi_mirror_plane* out = &s->planes[s->count - 1];
    dmi_copy3(normal, out->normal);
    measure_middle(s, normal, &out->middle);
    measure_twins(s->analysis, normal, out->twins);
    return out;
}

/* Writes the direction of the part's box, perpendicular to the axis, that leads from the box's centre to the axis.
 * Where the axis runs through the centre, and for slides: the direction that is most perpendicular to the axis. */
static void direction_towards(const dmi_symmetry* s, const dmi_candidate* c, float out[3]) {
    const dmi_part_analysis* a = s->analysis;
    float way[3];
    dmi_sub3(c->origin, s->centre, way);
    dmi_reject3(way, c->axis);
    const bool leads = c->type != DM_JOINT_PRISMATIC && dmi_normalize3(way) > OFF_CENTRE * a->diagonal;
    float most = -INFINITY, sign = 1;
    dmi_copy3(a->box.axes[0], out);
    for (int k = 0; k < 3; k++) {
        const float along = dmi_dot3(a->box.axes[k], way);
        const float fit = leads ? fabsf(along) : -fabsf(dmi_dot3(a->box.axes[k], c->axis));
        if (fit <= most) continue;
        most = fit, sign = leads && along < 0 ? -1.0f : 1.0f;
        dmi_copy3(a->box.axes[k], out);
    }
    for (int k = 0; k < 3; k++) out[k] *= sign;
    dmi_reject3(out, c->axis);
    dmi_normalize3(out);
}

static void write_towards(const dmi_mirror_distances* d, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_MIRROR_TOWARDS_PART] = d->part;
    row[DMI_FEATURE_MIRROR_TOWARDS_BODY] = d->body;
    row[DMI_FEATURE_MIRROR_TOWARDS_OFFSET] = d->offset;
}

static void write_side(const dmi_mirror_distances* d, float row[DMI_FEATURE_COUNT]) {
    row[DMI_FEATURE_MIRROR_SIDE_PART] = d->part;
    row[DMI_FEATURE_MIRROR_SIDE_BODY] = d->body;
    row[DMI_FEATURE_MIRROR_SIDE_OFFSET] = d->offset;
}

static void slide_features(const dmi_mirror_plane* first, const dmi_mirror_plane* second,
                           float row[DMI_FEATURE_COUNT]) {
    if (first->middle.part > second->middle.part) {
        const dmi_mirror_plane* other = first;
        first = second, second = other;
    }
    write_towards(&first->middle, row);
    write_side(&second->middle, row);
    row[DMI_FEATURE_TWIN_AWAY] = dmi_min(first->twins[0], first->twins[1]);
    row[DMI_FEATURE_TWIN_TOWARDS] = dmi_min(second->twins[0], second->twins[1]);
}

void dmi_symmetry_features(dmi_symmetry* symmetry, const dmi_candidate* candidate, float row[DMI_FEATURE_COUNT]) {
    float way[3], across[3];
    direction_towards(symmetry, candidate, way);
    dmi_cross3(candidate->axis, way, across);
    const dmi_mirror_distances axis = mirror_of(symmetry, candidate->axis)->middle;
    row[DMI_FEATURE_MIRROR_AXIS_PART] = axis.part;
    row[DMI_FEATURE_MIRROR_AXIS_BODY] = axis.body;
    row[DMI_FEATURE_MIRROR_AXIS_OFFSET] = axis.offset;
    const dmi_mirror_plane first = *mirror_of(symmetry, way), second = *mirror_of(symmetry, across);
    if (candidate->type == DM_JOINT_PRISMATIC) {
        slide_features(&first, &second, row);
        return;
    }
    const bool turned = dmi_dot3(first.normal, way) < 0;
    write_towards(&first.middle, row);
    write_side(&second.middle, row);
    row[DMI_FEATURE_TWIN_AWAY] = first.twins[turned];
    row[DMI_FEATURE_TWIN_TOWARDS] = first.twins[!turned];
}
