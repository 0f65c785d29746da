/* KPP-Net's view of a cloud: the frame of shape and drag, farthest-point groups, ten channels and more a point
 * (paper §3.5; docs/networks.md is the specification). */
#include "kinematics/kpp/kpp_input.h"

#include "base/cpu.h"
#include "kinematics/kpp/manhattan_frame.h"
#include "math/linear3.h"

#define PART_POINTS 512
#define NEAR_POINTS 256
#define BODY_POINTS 256
#define LANES 64
#define HALF_NEAR 0.05f /* of the part's radius: a gap that counts as half near */
#define TOUCHING 0.5f   /* nearness from which a point of the part counts as touching */
#define POINTS (PART_POINTS + NEAR_POINTS + BODY_POINTS)

/* The chosen points in the frame, coordinates apart so that distance loops vectorise. */
typedef struct points {
    float y[3][POINTS];
    float normal[POINTS][3];
    float nearness[POINTS]; /* of the other side: of the body for points of the part, of the part for others */
} points;

/* The quarter of a cloud's points that is looked at, block by block. */
typedef struct quarter {
    const float (*part)[3], (*near)[3], (*body)[3];
    const float (*part_normals)[3], (*near_normals)[3], (*body_normals)[3];
} quarter;

static quarter take_quarter(const dmi_cloud* cloud, uint32_t index) {
    const float(*xyz)[3] = (const float(*)[3])cloud->xyz, (*normal)[3] = (const float(*)[3])cloud->normal;
    const uint32_t part = index * PART_POINTS, near = DMI_CLOUD_PART + index * NEAR_POINTS;
    const uint32_t body = DMI_CLOUD_PART + DMI_CLOUD_NEAR + index * BODY_POINTS;
    return (quarter){xyz + part, xyz + near, xyz + body, normal + part, normal + near, normal + body};
}

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
    return dmi_max(sqrtf(most), 1e-4f);
}

static void flip(float v[3]) {
    for (int k = 0; k < 3; k++) v[k] = -v[k];
}

/* What the frame and the shape numbers are made from, object-normalised. */
typedef struct view {
    float centre[3], near[3]; /* mean of the part's points; from there to the mean of the near points */
    float principal[3][3];
    float of_part[3][3], of_body[3][3], of_all[3][3];
    float fit_part, fit_body, fit_all;
    float radius;
} view;

/* The better fit of two starts. */
static float best_directions(const dmi_normals* normals, const float a[3][3], const float b[3][3], float out[3][3]) {
    float other[3][3];
    memcpy(out, a, sizeof other);
    memcpy(other, b, sizeof other);
    const float fit = dmi_manhattan_frame_fit(normals, out), other_fit = dmi_manhattan_frame_fit(normals, other);
    if (other_fit <= fit) return fit;
    memcpy(out, other, sizeof other);
    return other_fit;
}

static void find_directions(const quarter* q, view* v) {
    const dmi_normals of_part = {q->part_normals, PART_POINTS, NULL, 0};
    const dmi_normals of_body = {q->near_normals, NEAR_POINTS, q->body_normals, BODY_POINTS};
    const dmi_normals of_all = {q->part_normals, PART_POINTS, q->near_normals, NEAR_POINTS};
    float start[3][3];
    dmi_manhattan_frame_guess(&of_part, start);
    v->fit_part = best_directions(&of_part, (const float(*)[3])start, (const float(*)[3])v->principal, v->of_part);
    dmi_manhattan_frame_guess(&of_body, start);
    v->fit_body = best_directions(&of_body, (const float(*)[3])start, (const float(*)[3])v->of_part, v->of_body);
    v->fit_all = best_directions(&of_all, (const float(*)[3])v->of_part, (const float(*)[3])v->of_body, v->of_all);
}

static void look_at(const quarter* q, view* out) {
    double variances[3];
    dmi_principal3(q->part, PART_POINTS, out->centre, variances, out->principal);
    mean_of(q->near, NEAR_POINTS, out->near);
    dmi_sub3(out->near, out->centre, out->near);
    out->radius = radius_of(q->part, PART_POINTS, out->centre);
    find_directions(q, out);
}

/* Half the part's extent along a direction. */
static float extent_along(const dmi_cloud* cloud, const float direction[3]) {
    float low = INFINITY, high = -INFINITY;
    for (uint32_t i = 0; i < DMI_CLOUD_PART; i++) {
        const float t = dmi_dot3(cloud->xyz[i], direction);
        low = dmi_min(low, t), high = dmi_max(high, t);
    }
    return 0.5f * (high - low);
}

/* Which direction comes first: the one nearest to the drag; without a drag the part's thinnest. Of the others the
 * longer one comes second. */
static void order_directions(const dmi_cloud* cloud, const dmi_drag_hint* hint, const view* v, int order[2]) {
    float extent[3], rank[3];
    for (int k = 0; k < 3; k++) {
        extent[k] = extent_along(cloud, v->of_all[k]);
        rank[k] = hint != NULL ? fabsf(dmi_dot3(v->of_all[k], hint->vector)) : -extent[k];
    }
    order[0] = rank[1] > rank[0] ? 1 : 0;
    if (rank[2] > rank[order[0]]) order[0] = 2;
    const int a = (order[0] + 1) % 3, b = (order[0] + 2) % 3;
    order[1] = extent[a] >= extent[b] ? a : b;
}

/* Signs a direction towards the body, else away from the drag point, else by the part's own skewness. */
static void sign_direction(const quarter* q, const view* v, const dmi_drag_hint* hint, float e[3]) {
    float along = dmi_dot3(v->near, e);
    if (fabsf(along) <= 0.05f * v->radius && hint != NULL) {
        float arm[3];
        dmi_sub3(v->centre, hint->point, arm);
        along = dmi_dot3(arm, e);
    }
    if (fabsf(along) <= 0.02f * v->radius) {
        double third = 0;
        for (uint32_t i = 0; i < PART_POINTS; i++) {
            float d[3];
            dmi_sub3(q->part[i], v->centre, d);
            const double t = dmi_dot3(d, e);
            third += t * t * t;
        }
        along = (float)third;
    }
    if (along < 0) flip(e);
}

static void make_frame(const dmi_cloud* cloud, const quarter* q, const dmi_drag_hint* hint, const view* v,
                       dmi_kpp_frame* out) {
    float *e1 = out->rotation, *e2 = out->rotation + 3, *e3 = out->rotation + 6;
    int order[2];
    order_directions(cloud, hint, v, order);
    dmi_copy3(v->of_all[order[0]], e1);
    dmi_copy3(v->of_all[order[1]], e2);
    if (hint == NULL)
        sign_direction(q, v, hint, e1);
    else if (dmi_dot3(e1, hint->vector) < 0)
        flip(e1);
    sign_direction(q, v, hint, e2);
    dmi_cross3(e1, e2, e3);
    dmi_copy3(v->centre, out->origin);
    out->scale = 1 / v->radius;
}

/* Far points are drawn in, so that a small part of a large object keeps its scale. */
static void point_in(const dmi_kpp_frame* frame, const float x[3], float out[3]) {
    float d[3];
    dmi_sub3(x, frame->origin, d);
    dmi_kpp_turn_in(frame, d, out);
    float length = dmi_length3(out) * frame->scale, factor = frame->scale;
    if (length > 2) factor *= (2 + logf(length / 2)) / length;
    for (int k = 0; k < 3; k++) out[k] *= factor;
}

/* A cloud's coordinates apart. */
typedef struct columns {
    float x[DMI_CLOUD_POINTS], y[DMI_CLOUD_POINTS], z[DMI_CLOUD_POINTS];
} columns;

static void split_columns(const dmi_cloud* cloud, columns* out) {
    for (uint32_t i = 0; i < DMI_CLOUD_POINTS; i++)
        out->x[i] = cloud->xyz[i][0], out->y[i] = cloud->xyz[i][1], out->z[i] = cloud->xyz[i][2];
}

/* best[k] becomes the least of itself and the square of the distance from the k-th point; a loop that vectorises. */
static inline void least_squares(const float* restrict x, const float* restrict y, const float* restrict z,
                                 const float from[3], float* restrict best) {
    const float a = from[0], b = from[1], c = from[2];
    for (int k = 0; k < LANES; k++) {
        const float dx = x[k] - a, dy = y[k] - b, dz = z[k] - c;
        const float d = dx * dx + dy * dy + dz * dz;
        best[k] = d < best[k] ? d : best[k];
    }
}

/* Squared distance to the nearest of `count` (a multiple of LANES) points. */
static inline float nearest_of(const columns* c, uint32_t first, uint32_t count, const float from[3]) {
    float best[LANES];
    for (int k = 0; k < LANES; k++) best[k] = INFINITY;
    for (uint32_t i = first; i < first + count; i += LANES) least_squares(c->x + i, c->y + i, c->z + i, from, best);
    for (int k = 1; k < LANES; k++) best[0] = best[k] < best[0] ? best[k] : best[0];
    return best[0];
}

#if defined(__x86_64__)
/* The same operations, eight at a time; without FMA, so the same bits. */
__attribute__((target("avx2"))) static float nearest_avx2(const columns* c, uint32_t first, uint32_t count,
                                                          const float from[3]) {
    return nearest_of(c, first, count, from);
}
#endif

static float nearest_square(const columns* c, uint32_t first, uint32_t count, const float from[3]) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return nearest_avx2(c, first, count, from);
#endif
    return nearest_of(c, first, count, from);
}

static void choose_points(const dmi_cloud* cloud, const quarter* q, const dmi_kpp_frame* frame, points* out) {
    static const uint32_t count[3] = {PART_POINTS, NEAR_POINTS, BODY_POINTS};
    const float(*const blocks[3])[3] = {q->part, q->near, q->body};
    const float(*const normals[3])[3] = {q->part_normals, q->near_normals, q->body_normals};
    columns all;
    split_columns(cloud, &all);
    uint32_t n = 0;
    for (int block = 0; block < 3; block++)
        for (uint32_t i = 0; i < count[block]; i++, n++) {
            const float* x = blocks[block][i];
            float y[3];
            point_in(frame, x, y);
            for (int k = 0; k < 3; k++) out->y[k][n] = y[k];
            dmi_kpp_turn_in(frame, normals[block][i], out->normal[n]);
            const uint32_t other = block == 0 ? DMI_CLOUD_PART : 0;
            const float gap = nearest_square(&all, other, block == 0 ? DMI_CLOUD_NEAR : DMI_CLOUD_PART, x);
            out->nearness[n] = 1 / (1 + sqrtf(gap) * frame->scale / HALF_NEAR);
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
        c[16] = p->nearness[i];
        c[3] = i < PART_POINTS ? 1 : 0;
    }
}

/* Farthest-point sampling from point 0 on over the first `count` points, a group round every centre. */
static void make_groups(const points* p, const drag_channels* drag, uint32_t count, uint32_t groups,
                        float (*out_points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], float (*out_centres)[3]) {
    dmi_fps grouping;
    dmi_fps_begin(p->y[0], p->y[1], p->y[2], count, &grouping);
    for (uint32_t g = 0, centre = 0; g < groups; g++) {
        uint32_t members[DMI_KPP_GROUP];
        const uint32_t next = dmi_fps_next(&grouping, centre, members);
        write_group(p, drag, centre, members, out_points[g]);
        for (int k = 0; k < 3; k++) out_centres[g][k] = p->y[k][centre];
        centre = next;
    }
}

/* Directions are lines: the largest component is positive. */
static void sign_line(float line[3]) {
    int largest = fabsf(line[1]) > fabsf(line[0]) ? 1 : 0;
    if (fabsf(line[2]) > fabsf(line[largest])) largest = 2;
    if (line[largest] < 0) flip(line);
}

static float* write_directions(const dmi_kpp_frame* frame, const float axes[3][3], float* out) {
    for (int k = 0; k < 3; k++, out += 3) {
        dmi_kpp_turn_in(frame, axes[k], out);
        sign_line(out);
    }
    return out;
}

/* Centre and half sides along the frame's axes; `drawn_in`: far ends shortened to logarithms. */
static float* write_box(const dmi_kpp_frame* frame, const float (*xyz)[3], uint32_t count, int drawn_in, float* out) {
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (uint32_t i = 0; i < count; i++) {
        float d[3], y[3];
        dmi_sub3(xyz[i], frame->origin, d);
        dmi_kpp_turn_in(frame, d, y);
        for (int k = 0; k < 3; k++) low[k] = dmi_min(low[k], y[k]), high[k] = dmi_max(high[k], y[k]);
    }
    for (int k = 0; k < 3; k++) {
        const float a = low[k] * frame->scale, b = high[k] * frame->scale;
        const float from = drawn_in ? copysignf(logf(1 + fabsf(a)), a) : a;
        const float to = drawn_in ? copysignf(logf(1 + fabsf(b)), b) : b;
        out[k] = 0.5f * (from + to);
        out[3 + k] = 0.5f * (to - from);
    }
    return out + 6;
}

/* Mean and spread of the part's points that touch the body, and their share; zeros when none does. */
static void write_contact(const points* p, float out[7]) {
    uint32_t count = 0;
    memset(out, 0, 7 * sizeof *out);
    for (uint32_t i = 0; i < PART_POINTS; i++) {
        if (p->nearness[i] < TOUCHING) continue;
        count++;
        for (int k = 0; k < 3; k++) out[k] += p->y[k][i], out[3 + k] += p->y[k][i] * p->y[k][i];
    }
    if (count == 0) return;
    for (int k = 0; k < 3; k++) {
        out[k] /= (float)count;
        out[3 + k] = sqrtf(dmi_max(out[3 + k] / (float)count - out[k] * out[k], 0));
    }
    out[6] = (float)count / PART_POINTS;
}

static void write_shape(const dmi_cloud* cloud, const dmi_kpp_frame* frame, const view* v, const drag_channels* drag,
                        const points* p, float out[DMI_KPP_SHAPE]) {
    const float(*xyz)[3] = (const float(*)[3])cloud->xyz;
    out = write_directions(frame, (const float(*)[3])v->of_part, out);
    out = write_directions(frame, (const float(*)[3])v->of_body, out);
    out = write_directions(frame, (const float(*)[3])v->principal, out);
    out = write_box(frame, xyz, DMI_CLOUD_PART, 0, out);
    out = write_box(frame, xyz, DMI_CLOUD_POINTS, 1, out);
    for (int k = 0; k < 3; k++) out[k] = drag->point[k], out[3 + k] = drag->vector[k];
    out[6] = 0.5f * logf(v->radius) + 1;
    out[7] = v->fit_part, out[8] = v->fit_body, out[9] = v->fit_all;
    write_contact(p, out + 10);
}

void dmi_kpp_input_make(const dmi_cloud* cloud, uint32_t quarter_index, const dmi_drag_hint* hint,
                        dmi_kpp_input* out_input) {
    const quarter q = take_quarter(cloud, quarter_index);
    view v;
    look_at(&q, &v);
    make_frame(cloud, &q, hint, &v, &out_input->frame);
    drag_channels drag = {{0, 0, 0}, {0, 0, 0}};
    if (hint != NULL) {
        point_in(&out_input->frame, hint->point, drag.point);
        dmi_kpp_turn_in(&out_input->frame, hint->vector, drag.vector);
        dmi_normalize3(drag.vector);
    }
    points p;
    choose_points(cloud, &q, &out_input->frame, &p);
    write_shape(cloud, &out_input->frame, &v, &drag, &p, out_input->shape);
    make_groups(&p, &drag, POINTS, DMI_KPP_GLOBAL_GROUPS, out_input->global_points, out_input->global_centres);
    make_groups(&p, &drag, PART_POINTS, DMI_KPP_LOCAL_GROUPS, out_input->local_points, out_input->local_centres);
}

static void turn_round(float v[3]) {
    v[1] = -v[1], v[2] = -v[2];
}

static void turn_groups(uint32_t groups, float (*points)[DMI_KPP_GROUP][DMI_KPP_CHANNELS], float (*centres)[3]) {
    for (uint32_t g = 0; g < groups; g++) {
        turn_round(centres[g]);
        for (uint32_t m = 0; m < DMI_KPP_GROUP; m++) {
            float* c = points[g][m];
            turn_round(c), turn_round(c + 4), turn_round(c + 7), turn_round(c + 10), turn_round(c + 13);
        }
    }
}

void dmi_kpp_input_turn(const dmi_kpp_input* input, dmi_kpp_input* out_input) {
    *out_input = *input;
    for (int k = 3; k < 9; k++) out_input->frame.rotation[k] = -input->frame.rotation[k];
    turn_groups(DMI_KPP_GLOBAL_GROUPS, out_input->global_points, out_input->global_centres);
    turn_groups(DMI_KPP_LOCAL_GROUPS, out_input->local_points, out_input->local_centres);
    float* shape = out_input->shape;
    for (int d = 0; d < DMI_KPP_DIRECTIONS; d++, shape += 3) {
        turn_round(shape);
        sign_line(shape);
    }
    turn_round(shape), turn_round(shape + 6), turn_round(shape + 12), turn_round(shape + 15), turn_round(shape + 22);
}
