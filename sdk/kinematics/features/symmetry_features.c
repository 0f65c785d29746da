/* Compares the part and the body near it with their mirror images, by distance grids. */
#include "kinematics/features/symmetry_features.h"

#include "math/linear3.h"

#define PART_POINTS 64
#define BODY_POINTS 128
#define SAME 0.9999998f /* cosine, 0.6 mrad */
#define UNLIKE 0.25f    /* of the part's diagonal: farther than this is no likeness at all */

typedef struct sample {
    const float (*points)[3];
    uint32_t count, step;
} sample;

void dmi_symmetry_begin(const dmi_part_analysis* study, dmi_symmetry* out) {
    out->study = study;
    out->count = 0;
    dmi_box_centre(&study->box, out->centre);
}

static sample part_sample(const dmi_part_analysis* s) {
    return (sample){s->points, PART_POINTS, 1};
}

static sample near_sample(const dmi_part_analysis* s) {
    const uint32_t count = s->near_count < BODY_POINTS ? s->near_count : BODY_POINTS;
    return (sample){(const float(*)[3])s->near_points, count, count > 0 ? s->near_count / count : 1};
}

/* Mean distance from the field's samples of the points' images in the mirror of that normal, at a place along it. Only
 * of images that lie in the field's grid: what is beyond it nobody knows. */
static float difference(const float normal[3], float at, sample from, const dmi_distance_grid* field, float size) {
    float image[3][DMI_POINT_BATCH], distance[DMI_POINT_BATCH], inside[DMI_POINT_BATCH], sum = 0, known = 0;
    for (uint32_t i = 0; i < from.count; i++) {
        const float* p = from.points[(size_t)i * from.step];
        const float off = 2 * (at - dmi_dot3(p, normal));
        for (int k = 0; k < 3; k++) image[k][i] = p[k] + off * normal[k];
        inside[i] = 1;
    }
    dmi_distance_grid_distances(field, (const float(*)[DMI_POINT_BATCH])image, from.count, distance);
    for (int k = 0; k < 3; k++) {
        const float low = field->low[k], high = low + (float)field->size[k] * field->cell;
        for (uint32_t i = 0; i < from.count; i++) inside[i] = image[k][i] >= low && image[k][i] <= high ? inside[i] : 0;
    }
    for (uint32_t i = 0; i < from.count; i++) {
        sum += inside[i] * dmi_min(distance[i] / size, UNLIKE);
        known += inside[i];
    }
    return known == 0 || 4 * known < (float)from.count ? UNLIKE : sum / known;
}

static void look_at_middle(const dmi_symmetry* m, const float normal[3], float out[3]) {
    const dmi_part_analysis* s = m->study;
    const float at = dmi_dot3(m->centre, normal);
    float low, high;
    out[0] = difference(normal, at, part_sample(s), &s->part_grid, s->diagonal);
    out[1] = difference(normal, at, near_sample(s), &s->body_grid, s->diagonal);
    dmi_extents_along((const float(*)[3])s->object_extreme_points, s->object_extreme_point_count, (const float(*)[3])normal, 1, &low, &high);
    out[2] = dmi_min(fabsf(at - (low + high) / 2) / (high - low + 1e-9f), 1);
}

/* Beyond the part's low and its high side. */
static void look_for_twins(const dmi_symmetry* m, const float normal[3], float out[2]) {
    const dmi_part_analysis* s = m->study;
    float low, high;
    dmi_extents_along((const float(*)[3])s->extreme_points, s->extreme_point_count, (const float(*)[3])normal, 1, &low, &high);
    out[0] = difference(normal, low, part_sample(s), &s->body_grid, s->diagonal);
    out[1] = difference(normal, high, part_sample(s), &s->body_grid, s->diagonal);
}

/* Into the mirrors of that normal, of either sign. The last place serves all that come when the others are taken. */
static const dmi_mirror_plane* look(dmi_symmetry* m, const float normal[3]) {
    for (uint32_t i = 0; i < m->count; i++)
        if (fabsf(dmi_dot3(m->looks[i].normal, normal)) > SAME) return &m->looks[i];
    if (m->count < DMI_MIRROR_PLANES) m->count++;
    dmi_mirror_plane* out = &m->looks[m->count - 1];
    dmi_copy3(normal, out->normal);
    look_at_middle(m, normal, out->middle);
    look_for_twins(m, normal, out->twins);
    return out;
}

/* Across the axis, along a side of the part's box: the side that leads to it from the part's middle, or, where it runs
 * through that or is a slide's, the side that lies most across. */
static void towards(const dmi_symmetry* m, const dmi_candidate* c, float out[3]) {
    const dmi_part_analysis* s = m->study;
    float way[3];
    dmi_sub3(c->origin, m->centre, way);
    dmi_reject3(way, c->axis);
    const int leads = c->type != DM_JOINT_PRISMATIC && dmi_normalize3(way) > 0.02f * s->diagonal;
    float most = -INFINITY, sign = 1;
    for (int k = 0; k < 3; k++) {
        const float along = dmi_dot3(s->box.axes[k], way);
        const float fit = leads ? fabsf(along) : -fabsf(dmi_dot3(s->box.axes[k], c->axis));
        if (fit <= most) continue;
        most = fit, sign = leads && along < 0 ? -1.0f : 1.0f;
        dmi_copy3(s->box.axes[k], out);
    }
    for (int k = 0; k < 3; k++) out[k] *= sign;
    dmi_reject3(out, c->axis);
    dmi_normalize3(out);
}

static void slide_evidence(const dmi_mirror_plane* first, const dmi_mirror_plane* second, float* middles,
                           float* twins) {
    if (first->middle[0] > second->middle[0]) {
        const dmi_mirror_plane* other = first;
        first = second, second = other;
    }
    memcpy(middles, first->middle, sizeof first->middle);
    memcpy(middles + 3, second->middle, sizeof second->middle);
    twins[0] = dmi_min(first->twins[0], first->twins[1]);
    twins[1] = dmi_min(second->twins[0], second->twins[1]);
}

void dmi_symmetry_features(dmi_symmetry* mirror, const dmi_candidate* candidate, float out[DMI_SYMMETRY_COUNT]) {
    float way[3], across[3], *middles = out + DMI_SYMMETRY_MIDPLANES, *twins = out + DMI_SYMMETRY_TWINS;
    towards(mirror, candidate, way);
    dmi_cross3(candidate->axis, way, across);
    memcpy(middles, look(mirror, candidate->axis)->middle, sizeof(float[3]));
    const dmi_mirror_plane first = *look(mirror, way), second = *look(mirror, across);
    if (candidate->type == DM_JOINT_PRISMATIC) {
        slide_evidence(&first, &second, middles + 3, twins);
        return;
    }
    const int turned = dmi_dot3(first.normal, way) < 0;
    memcpy(middles + 3, first.middle, sizeof first.middle);
    memcpy(middles + 6, second.middle, sizeof second.middle);
    twins[0] = first.twins[turned], twins[1] = first.twins[!turned];
}
