/* Computes the shape features. */
#include "kinematics/kpp/kpp_shape.h"

#include "math/elementary.h"

#define CONTACT_NEARNESS 0.5f /* nearness from which a point of the part is in contact (docs/networks.md); by hand */

void dmi_kpp_sign_line(float line[3]) {
    int largest = fabsf(line[1]) > fabsf(line[0]) ? 1 : 0;
    if (fabsf(line[2]) > fabsf(line[largest])) largest = 2;
    if (line[largest] < 0)
        for (int k = 0; k < 3; k++) line[k] = -line[k];
}

/* Writes the three directions in the frame. Returns the end of what was written. */
static float* write_directions(const dmi_kpp_frame* frame, const float axes[3][3], float* out) {
    for (int k = 0; k < 3; k++, out += 3) {
        dmi_kpp_frame_rotate(frame, axes[k], out);
        dmi_kpp_sign_line(out);
    }
    return out;
}

/* Writes centre and half sides of the points' box along the frame's axes. logarithmic: ends t become +-ln(1 + |t|). */
static void write_box(const dmi_kpp_frame* frame, const float (*xyz)[3], uint32_t count, bool logarithmic,
                      float out_centre[3], float out_half[3]) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++) {
        float d[3], y[3];
        dmi_sub3(xyz[i], frame->origin, d);
        dmi_kpp_frame_rotate(frame, d, y);
        for (int k = 0; k < 3; k++) low[k] = dmi_min(low[k], y[k]), high[k] = dmi_max(high[k], y[k]);
    }
    for (int k = 0; k < 3; k++) {
        const float a = low[k] * frame->scale, b = high[k] * frame->scale;
        const float from = logarithmic ? copysignf(dmi_logf(1 + fabsf(a)), a) : a;
        const float to = logarithmic ? copysignf(dmi_logf(1 + fabsf(b)), b) : b;
        out_centre[k] = 0.5f * (from + to);
        out_half[k] = 0.5f * (to - from);
    }
}

/* Writes mean, standard deviation and share of the part's points in contact with the body; zeros when there are
 * none. */
static void write_contact(const dmi_kpp_points* points, float mean[3], float spread[3], float* share) {
    uint32_t count = 0;
    for (int k = 0; k < 3; k++) mean[k] = spread[k] = 0;
    *share = 0;
    for (uint32_t i = 0; i < DMI_KPP_PART_POINTS; i++) {
        if (points->nearness[i] < CONTACT_NEARNESS) continue;
        count++;
        for (int k = 0; k < 3; k++) mean[k] += points->y[k][i], spread[k] += points->y[k][i] * points->y[k][i];
    }
    if (count == 0) return;
    for (int k = 0; k < 3; k++) {
        mean[k] /= (float)count;
        spread[k] = sqrtf(dmi_max(spread[k] / (float)count - mean[k] * mean[k], 0));
    }
    *share = (float)count / DMI_KPP_PART_POINTS;
}

void dmi_kpp_shape_make(const dmi_cloud* cloud, const dmi_kpp_frame* frame, const dmi_kpp_geometry* geometry,
                        const dmi_kpp_drag* drag, const dmi_kpp_points* points, float out[DMI_KPP_SHAPE]) {
    const float(*xyz)[3] = (const float(*)[3])cloud->xyz;
    float *directions = out + DMI_KPP_SHAPE_DIRECTIONS, *fits = out + DMI_KPP_SHAPE_FITS;
    float *part_box = out + DMI_KPP_SHAPE_PART_BOX, *object_box = out + DMI_KPP_SHAPE_OBJECT_BOX;
    directions = write_directions(frame, (const float(*)[3])geometry->part_axes, directions);
    directions = write_directions(frame, (const float(*)[3])geometry->body_axes, directions);
    write_directions(frame, (const float(*)[3])geometry->principal, directions);
    write_box(frame, xyz, DMI_CLOUD_PART, false, part_box, part_box + 3);
    write_box(frame, xyz, DMI_CLOUD_POINTS, true, object_box, object_box + 3);
    dmi_copy3(drag->point, out + DMI_KPP_SHAPE_DRAG_POINT);
    dmi_copy3(drag->vector, out + DMI_KPP_SHAPE_DRAG_VECTOR);
    out[DMI_KPP_SHAPE_RADIUS] = 0.5f * dmi_logf(geometry->radius) + 1;
    fits[0] = geometry->part_fit, fits[1] = geometry->body_fit, fits[2] = geometry->all_fit;
    write_contact(points, out + DMI_KPP_SHAPE_CONTACT_MEAN, out + DMI_KPP_SHAPE_CONTACT_SPREAD,
                  out + DMI_KPP_SHAPE_CONTACT_SHARE);
}
