/* Groups the points by farthest-point sampling and writes their channels. */
#include "kinematics/kpp/kpp_input.h"

#include "kinematics/kpp/kpp_points.h"
#include "kinematics/kpp/kpp_shape.h"

static void write_group(const dmi_kpp_points* p, const dmi_kpp_drag* drag, uint32_t centre, const uint32_t* members,
                        float out[DMI_KPP_GROUP][DMI_KPP_CHANNELS]) {
    for (uint32_t m = 0; m < DMI_KPP_GROUP; m++) {
        uint32_t i = members[m];
        float* c = out[m];
        for (int k = 0; k < 3; k++) {
            c[DMI_KPP_POINT + k] = p->y[k][i];
            c[DMI_KPP_DRAG_POINT + k] = drag->point[k];
            c[DMI_KPP_DRAG_VECTOR + k] = drag->vector[k];
            c[DMI_KPP_OFFSET + k] = 2 * (p->y[k][i] - p->y[k][centre]);
            c[DMI_KPP_NORMAL + k] = p->normal[i][k];
        }
        c[DMI_KPP_NEARNESS] = p->nearness[i];
        c[DMI_KPP_MASK] = i < DMI_KPP_PART_POINTS ? 1 : 0;
    }
}

/* Samples centres among the first `count` points, from point 0 on, and groups the nearest points around each. */
static void make_groups(const dmi_kpp_points* p, const dmi_kpp_drag* drag, uint32_t count, uint32_t groups,
                        float (*out_points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], float (*out_centres)[3]) {
    dmi_fps sampling;
    dmi_fps_begin(p->y[0], p->y[1], p->y[2], count, &sampling);
    for (uint32_t g = 0, centre = 0; g < groups; g++) {
        uint32_t members[DMI_KPP_GROUP];
        const uint32_t next = dmi_fps_next(&sampling, centre, members);
        write_group(p, drag, centre, members, out_points[g]);
        for (int k = 0; k < 3; k++) out_centres[g][k] = p->y[k][centre];
        centre = next;
    }
}

void dmi_kpp_input_make(const dmi_cloud* cloud, uint32_t subset_index, const dmi_drag_hint* hint,
                        dmi_kpp_input* out_input) {
    const dmi_kpp_subset subset = dmi_kpp_subset_of(cloud, subset_index);
    const dmi_kpp_frame* frame = &out_input->frame;
    dmi_kpp_geometry geometry;
    dmi_kpp_geometry_make(&subset, &geometry);
    dmi_kpp_frame_make(cloud, &subset, hint, &geometry, &out_input->frame);
    dmi_kpp_drag drag = {{0, 0, 0}, {0, 0, 0}};
    if (hint != NULL) {
        dmi_kpp_frame_point_in(frame, hint->point, drag.point);
        dmi_kpp_frame_rotate(frame, hint->vector, drag.vector);
        dmi_normalize3(drag.vector);
    }
    dmi_kpp_points points;
    dmi_kpp_points_make(cloud, &subset, frame, &points);
    dmi_kpp_shape_make(cloud, frame, &geometry, &drag, &points, out_input->shape);
    make_groups(&points, &drag, DMI_KPP_POINTS, DMI_KPP_GLOBAL_GROUPS, out_input->global_points,
                out_input->global_centres);
    make_groups(&points, &drag, DMI_KPP_PART_POINTS, DMI_KPP_LOCAL_GROUPS, out_input->local_points,
                out_input->local_centres);
}

/* ---- the rotated frame ---- */

static void flip_vector(float v[3]) {
    v[1] = -v[1], v[2] = -v[2];
}

static void flip_groups(uint32_t groups, float (*points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], float (*centres)[3]) {
    static const int vectors[] = {DMI_KPP_POINT, DMI_KPP_DRAG_POINT, DMI_KPP_DRAG_VECTOR, DMI_KPP_OFFSET,
                                  DMI_KPP_NORMAL};
    for (uint32_t g = 0; g < groups; g++) {
        flip_vector(centres[g]);
        for (uint32_t m = 0; m < DMI_KPP_GROUP; m++)
            for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) flip_vector(points[g][m] + vectors[i]);
    }
}

void dmi_kpp_input_flip(const dmi_kpp_input* input, dmi_kpp_input* out_input) {
    *out_input = *input;
    for (int k = 0; k < 3; k++) {
        out_input->frame.rotation[3 + k] = -input->frame.rotation[3 + k];
        out_input->frame.rotation[2 * 3 + k] = -input->frame.rotation[2 * 3 + k];
    }
    flip_groups(DMI_KPP_GLOBAL_GROUPS, out_input->global_points, out_input->global_centres);
    flip_groups(DMI_KPP_LOCAL_GROUPS, out_input->local_points, out_input->local_centres);
    float* shape = out_input->shape;
    for (int d = 0; d < DMI_KPP_DIRECTIONS; d++) {
        float* direction = shape + DMI_KPP_SHAPE_DIRECTIONS + 3 * (size_t)d;
        flip_vector(direction);
        dmi_kpp_sign_line(direction);
    }
    flip_vector(shape + DMI_KPP_SHAPE_PART_BOX);
    flip_vector(shape + DMI_KPP_SHAPE_OBJECT_BOX);
    flip_vector(shape + DMI_KPP_SHAPE_DRAG_POINT);
    flip_vector(shape + DMI_KPP_SHAPE_DRAG_VECTOR);
    flip_vector(shape + DMI_KPP_SHAPE_CONTACT_MEAN);
}
