/* Computes the frame of KPP-Net's input. */
#include "kinematics/kpp/kpp_frame.h"

#include "math/elementary.h"

#define MIN_RADIUS 1e-4f  /* object sizes: avoids a division by zero (docs/networks.md) */
#define NEAR_OFFSET 0.05f /* radii along an axis, above which the near points sign it (docs/networks.md); by hand */
#define DRAG_OFFSET 0.02f /* radii along an axis, above which the drag point signs it (docs/networks.md); by hand */
#define MAX_LENGTH 2      /* radii, from which points are drawn in logarithmically (docs/networks.md); by hand */

/* ---- geometry ---- */

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
        most = dmi_max(most, dmi_dot3(d, d));
    }
    return dmi_max(sqrtf(most), MIN_RADIUS);
}

/* Fits Manhattan frames from two starts and keeps the better one. Returns its fit. */
static float fit_axes(const dmi_normals* normals, const float a[3][3], const float b[3][3], float out[3][3]) {
    float other[3][3];
    memcpy(out, a, sizeof other);
    memcpy(other, b, sizeof other);
    const float fit = dmi_manhattan_frame_fit(normals, out), other_fit = dmi_manhattan_frame_fit(normals, other);
    if (other_fit <= fit) return fit;
    memcpy(out, other, sizeof other);
    return other_fit;
}

static void fit_all_axes(const dmi_kpp_subset* s, dmi_kpp_geometry* g) {
    const dmi_normals part = {s->part_normals, DMI_KPP_PART_POINTS, NULL, 0};
    const dmi_normals body = {s->near_normals, DMI_KPP_NEAR_POINTS, s->body_normals, DMI_KPP_BODY_POINTS};
    const dmi_normals all = {s->part_normals, DMI_KPP_PART_POINTS, s->near_normals, DMI_KPP_NEAR_POINTS};
    float start[3][3];
    dmi_manhattan_frame_guess(&part, start);
    g->part_fit = fit_axes(&part, (const float(*)[3])start, (const float(*)[3])g->principal, g->part_axes);
    dmi_manhattan_frame_guess(&body, start);
    g->body_fit = fit_axes(&body, (const float(*)[3])start, (const float(*)[3])g->part_axes, g->body_axes);
    g->all_fit = fit_axes(&all, (const float(*)[3])g->part_axes, (const float(*)[3])g->body_axes, g->all_axes);
}

void dmi_kpp_geometry_make(const dmi_kpp_subset* subset, dmi_kpp_geometry* out) {
    double variances[3];
    dmi_principal3(subset->part, DMI_KPP_PART_POINTS, out->centre, variances, out->principal);
    mean_of(subset->near, DMI_KPP_NEAR_POINTS, out->near_offset);
    dmi_sub3(out->near_offset, out->centre, out->near_offset);
    out->radius = radius_of(subset->part, DMI_KPP_PART_POINTS, out->centre);
    fit_all_axes(subset, out);
}

/* ---- frame ---- */

static void negate_vector(float v[3]) {
    for (int k = 0; k < 3; k++) v[k] = -v[k];
}

/* Returns half the part's extent along a direction. */
static float half_extent(const dmi_cloud* cloud, const float direction[3]) {
    float low = INFINITY, high = -INFINITY;
    for (uint32_t i = 0; i < DMI_CLOUD_PART; i++) {
        const float t = dmi_dot3(cloud->xyz[i], direction);
        low = dmi_min(low, t), high = dmi_max(high, t);
    }
    return 0.5f * (high - low);
}

/* Chooses the first axis: the one closest to the drag, or without a drag the one along which the part is shortest; and
 * the second: of the others the one along which the part is longer. */
static void order_axes(const dmi_cloud* cloud, const dmi_drag_hint* hint, const dmi_kpp_geometry* g, int order[2]) {
    float extent[3], rank[3];
    for (int k = 0; k < 3; k++) {
        extent[k] = half_extent(cloud, g->all_axes[k]);
        rank[k] = hint != NULL ? fabsf(dmi_dot3(g->all_axes[k], hint->vector)) : -extent[k];
    }
    order[0] = rank[1] > rank[0] ? 1 : 0;
    if (rank[2] > rank[order[0]]) order[0] = 2;
    const int a = (order[0] + 1) % 3, b = (order[0] + 2) % 3;
    order[1] = extent[a] >= extent[b] ? a : b;
}

/* Signs an axis towards the near points, else away from the drag point, else by the part's third moment. */
static void sign_axis(const dmi_kpp_subset* s, const dmi_kpp_geometry* g, const dmi_drag_hint* hint, float e[3]) {
    float along = dmi_dot3(g->near_offset, e);
    if (fabsf(along) <= NEAR_OFFSET * g->radius && hint != NULL) {
        float arm[3];
        dmi_sub3(g->centre, hint->point, arm);
        along = dmi_dot3(arm, e);
    }
    if (fabsf(along) <= DRAG_OFFSET * g->radius) {
        double third = 0;
        for (uint32_t i = 0; i < DMI_KPP_PART_POINTS; i++) {
            float d[3];
            dmi_sub3(s->part[i], g->centre, d);
            const double t = dmi_dot3(d, e);
            third += t * t * t;
        }
        along = (float)third;
    }
    if (along < 0) negate_vector(e);
}

void dmi_kpp_frame_make(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_drag_hint* hint,
                        const dmi_kpp_geometry* geometry, dmi_kpp_frame* out) {
    float *e1 = out->rotation, *e2 = e1 + 3, *e3 = e2 + 3;
    int order[2];
    order_axes(cloud, hint, geometry, order);
    dmi_copy3(geometry->all_axes[order[0]], e1);
    dmi_copy3(geometry->all_axes[order[1]], e2);
    if (hint == NULL)
        sign_axis(subset, geometry, hint, e1);
    else if (dmi_dot3(e1, hint->vector) < 0)
        negate_vector(e1);
    sign_axis(subset, geometry, hint, e2);
    dmi_cross3(e1, e2, e3);
    dmi_copy3(geometry->centre, out->origin);
    out->scale = 1 / geometry->radius;
}

void dmi_kpp_frame_point_in(const dmi_kpp_frame* frame, const float x[3], float out[3]) {
    float d[3];
    dmi_sub3(x, frame->origin, d);
    dmi_kpp_frame_rotate(frame, d, out);
    float length = dmi_length3(out) * frame->scale, factor = frame->scale;
    if (length > MAX_LENGTH) factor *= (MAX_LENGTH + dmi_logf(length / MAX_LENGTH)) / length;
    for (int k = 0; k < 3; k++) out[k] *= factor;
}
