/* KPP-Net's view of a cloud: the frame of drag and part, farthest-point groups, ten channels and more a point
 * (paper §3.5; docs/networks.md is the specification). */
#include "kinematics/kpp_input.h"

#include "kinematics/linear3.h"

#define PART_POINTS 512
#define NEAR_POINTS 256
#define BODY_POINTS 256
#define POINTS (PART_POINTS + NEAR_POINTS + BODY_POINTS)

/* The chosen points in the frame, coordinates apart so that distance loops vectorise. */
typedef struct points {
    float y[3][POINTS];
    float normal[POINTS][3];
} points;

static void mean_of(const float (*xyz)[3], uint32_t count, float out[3]) {
    double sum[3] = {0, 0, 0};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) sum[k] += xyz[i][k];
    for (int k = 0; k < 3; k++) out[k] = (float)(sum[k] / count);
}

static float radius_of(const float (*xyz)[3], uint32_t count, const float centre[3]) {
    float most = 0;
    for (uint32_t i = 0; i < count; i++) {
        float d[3];
        dmi_sub3(xyz[i], centre, d);
        most = fmaxf(most, dmi_dot3(d, d));
    }
    return fmaxf(sqrtf(most), 1e-4f);
}

static void flip(float v[3]) {
    for (int k = 0; k < 3; k++) v[k] = -v[k];
}

/* e1 along the drag; e2 from the drag point's side of the part, or from its shape when the drag line meets its centre.
 */
static void drag_axes(const dmi_drag_hint* hint, const float centre[3], float radius, const float near[3],
                      const float principal[3][3], float e1[3], float e2[3]) {
    dmi_copy3(hint->vector, e1);
    dmi_normalize3(e1);
    dmi_sub3(centre, hint->point, e2);
    dmi_reject3(e2, e1);
    if (dmi_length3(e2) <= 0.05f * radius) {
        for (int k = 0; k < 3; k++) {
            dmi_copy3(principal[k], e2);
            dmi_reject3(e2, e1);
            if (dmi_length3(e2) > 0.1f) break;
        }
        if (dmi_dot3(e2, near) < 0) flip(e2);
    }
    dmi_reject3(e2, e1);
    dmi_normalize3(e2);
}

/* Signs a principal direction towards the body, else by the part's own skewness. */
static void sign_direction(const float (*xyz)[3], const float centre[3], float radius, const float near[3],
                           float e[3]) {
    float along = dmi_dot3(near, e);
    if (fabsf(along) <= 0.02f * radius) {
        double third = 0;
        for (uint32_t i = 0; i < PART_POINTS; i++) {
            float d[3];
            dmi_sub3(xyz[i], centre, d);
            double t = dmi_dot3(d, e);
            third += t * t * t;
        }
        along = (float)third;
    }
    if (along < 0) flip(e);
}

static void make_frame(const dmi_cloud* cloud, const dmi_drag_hint* hint, dmi_kpp_frame* out) {
    const float(*part)[3] = (const float(*)[3])cloud->xyz;
    float centre[3], near[3], principal[3][3];
    double variances[3];
    dmi_principal3(part, PART_POINTS, centre, variances, principal);
    mean_of(part + DMI_CLOUD_PART, NEAR_POINTS, near);
    dmi_sub3(near, centre, near);
    float radius = radius_of(part, PART_POINTS, centre);

    float *e1 = out->rotation, *e2 = out->rotation + 3, *e3 = out->rotation + 6;
    if (hint != NULL) {
        drag_axes(hint, centre, radius, near, (const float(*)[3])principal, e1, e2);
    } else {
        dmi_copy3(principal[2], e1);
        dmi_copy3(principal[0], e2);
        sign_direction(part, centre, radius, near, e1);
        sign_direction(part, centre, radius, near, e2);
    }
    dmi_cross3(e1, e2, e3);
    dmi_copy3(centre, out->origin);
    out->scale = 1 / radius;
}

static void turn_in(const dmi_kpp_frame* frame, const float v[3], float out[3]) {
    for (int r = 0; r < 3; r++) out[r] = dmi_dot3(frame->rotation + 3 * r, v);
}

/* Far points are drawn in, so that a small part of a large object keeps its scale. */
static void point_in(const dmi_kpp_frame* frame, const float x[3], float out[3]) {
    float d[3];
    dmi_sub3(x, frame->origin, d);
    turn_in(frame, d, out);
    float length = dmi_length3(out) * frame->scale, factor = frame->scale;
    if (length > 2) factor *= (2 + logf(length / 2)) / length;
    for (int k = 0; k < 3; k++) out[k] *= factor;
}

static void choose_points(const dmi_cloud* cloud, const dmi_kpp_frame* frame, points* out) {
    static const uint32_t first[3] = {0, DMI_CLOUD_PART, DMI_CLOUD_PART + DMI_CLOUD_NEAR};
    static const uint32_t count[3] = {PART_POINTS, NEAR_POINTS, BODY_POINTS};
    uint32_t n = 0;
    for (int block = 0; block < 3; block++)
        for (uint32_t i = first[block]; i < first[block] + count[block]; i++, n++) {
            float y[3];
            point_in(frame, cloud->xyz[i], y);
            for (int k = 0; k < 3; k++) out->y[k][n] = y[k];
            turn_in(frame, cloud->normal[i], out->normal[n]);
        }
}

static void squared_distances(const points* p, uint32_t count, uint32_t from, float* restrict out) {
    const float* restrict x = p->y[0], * restrict y = p->y[1], * restrict z = p->y[2];
    float cx = x[from], cy = y[from], cz = z[from];
    for (uint32_t i = 0; i < count; i++) {
        float dx = x[i] - cx, dy = y[i] - cy, dz = z[i] - cz;
        out[i] = dx * dx + dy * dy + dz * dz;
    }
}

/* The DMI_KPP_GROUP nearest points: `self` first, then by distance, ties by index. */
static void nearest(const float* distance, uint32_t count, uint32_t self, uint32_t out[DMI_KPP_GROUP]) {
    float best[DMI_KPP_GROUP];
    uint32_t filled = 1;
    out[0] = self, best[0] = -1;
    for (uint32_t i = 0; i < count; i++) {
        float d = distance[i];
        if (filled == DMI_KPP_GROUP && d >= best[DMI_KPP_GROUP - 1]) continue;
        if (i == self) continue;
        uint32_t at = filled < DMI_KPP_GROUP ? filled++ : DMI_KPP_GROUP - 1;
        for (; best[at - 1] > d; at--) best[at] = best[at - 1], out[at] = out[at - 1];
        best[at] = d, out[at] = i;
    }
}

typedef struct drag_channels {
    float point[3], vector[3];
} drag_channels;

static void write_group(const points* p, const drag_channels* drag, uint32_t centre, const uint32_t* members,
                        float out[DMI_KPP_GROUP][DMI_KPP_CHANNELS]) {
    for (uint32_t m = 0; m < DMI_KPP_GROUP; m++) {
        uint32_t i = members[m];
        float* c = out[m];
        for (int k = 0; k < 3; k++) {
            c[k] = p->y[k][i];
            c[4 + k] = drag->point[k];
            c[7 + k] = drag->vector[k];
            c[10 + k] = 2 * (p->y[k][i] - p->y[k][centre]);
            c[13 + k] = p->normal[i][k];
        }
        c[3] = i < PART_POINTS ? 1 : 0;
    }
}

/* Farthest-point sampling from point 0 on over the first `count` points, a group round every centre. */
static void make_groups(const points* p, const drag_channels* drag, uint32_t count, uint32_t groups,
                        float (*out_points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], float (*out_centres)[3]) {
    float distance[POINTS], cover[POINTS];
    for (uint32_t i = 0; i < count; i++) cover[i] = INFINITY;
    uint32_t centre = 0;
    for (uint32_t g = 0; g < groups; g++) {
        squared_distances(p, count, centre, distance);
        uint32_t members[DMI_KPP_GROUP];
        nearest(distance, count, centre, members);
        write_group(p, drag, centre, members, out_points[g]);
        for (int k = 0; k < 3; k++) out_centres[g][k] = p->y[k][centre];
        uint32_t farthest = 0;
        for (uint32_t i = 0; i < count; i++) {
            cover[i] = cover[i] < distance[i] ? cover[i] : distance[i];
            if (cover[i] > cover[farthest]) farthest = i;
        }
        centre = farthest;
    }
}

void dmi_kpp_input_make(const dmi_cloud* cloud, const dmi_drag_hint* hint, dmi_kpp_input* out_input) {
    make_frame(cloud, hint, &out_input->frame);
    drag_channels drag = {{0, 0, 0}, {0, 0, 0}};
    if (hint != NULL) {
        point_in(&out_input->frame, hint->point, drag.point);
        drag.vector[0] = 1;
    }
    points p;
    choose_points(cloud, &out_input->frame, &p);
    make_groups(&p, &drag, POINTS, DMI_KPP_GLOBAL_GROUPS, out_input->global_points, out_input->global_centres);
    make_groups(&p, &drag, PART_POINTS, DMI_KPP_LOCAL_GROUPS, out_input->local_points, out_input->local_centres);
}
