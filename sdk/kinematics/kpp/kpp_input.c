/* Makes the input of KPP-Net: transforms the points, measures their nearness and the shape, groups the points by
 * farthest-point sampling and writes their channels. */
#include "kinematics/kpp/kpp_input.h"

#include "base/compiler.h"
#include "base/cpu.h"
#include "math/elementary.h"

#define LANES 64       /* points at a time; divides COLUMN */
#define COLUMN 512     /* points whose coordinates are separated at a time; divides the counts of the cloud's blocks */
#define HALF_GAP 0.05f /* radii of the part: the gap at which nearness is 0.5 (docs/networks.md); by hand */
#define CONTACT_NEARNESS 0.5f /* nearness from which a point of the part is in contact (docs/networks.md); by hand */

/* Part, near and body points, in this order, in the frame. Coordinates are separated, so that distance loops vectorise.
 */
typedef struct input_points {
    float y[3][DMI_KPP_POINTS];
    float normal[DMI_KPP_POINTS][3];
    float nearness[DMI_KPP_POINTS]; /* 1 / (1 + gap to the other side / half-value gap), 0 .. 1 */
} input_points;

/* A drag in the frame; zeros without one. */
typedef struct input_drag {
    float point[3], vector[3]; /* vector: unit */
} input_drag;

/* ---- points ---- */

/* Some points of the cloud, coordinates separated. */
typedef struct columns {
    float x[COLUMN], y[COLUMN], z[COLUMN];
} columns;

static void split_columns(const float (*xyz)[3], columns* out) {
    for (uint32_t i = 0; i < COLUMN; i++) out->x[i] = xyz[i][0], out->y[i] = xyz[i][1], out->z[i] = xyz[i][2];
}

/* Lowers best[k] to the squared distance from the k-th point. */
static inline void lower_squares(const float* restrict x, const float* restrict y, const float* restrict z,
                                 const float from[3], float* restrict best) {
    const float a = from[0], b = from[1], c = from[2];
    for (int k = 0; k < LANES; k++) {
        const float dx = x[k] - a, dy = y[k] - b, dz = z[k] - c;
        const float d = dx * dx + dy * dy + dz * dz;
        best[k] = d < best[k] ? d : best[k];
    }
}

/* Returns the squared distance to the nearest point. */
static inline float nearest_of(const columns* c, const float from[3]) {
    float best[LANES];
    for (int k = 0; k < LANES; k++) best[k] = INFINITY;
    for (uint32_t i = 0; i < COLUMN; i += LANES) lower_squares(c->x + i, c->y + i, c->z + i, from, best);
    for (int k = 1; k < LANES; k++) best[0] = best[k] < best[0] ? best[k] : best[0];
    return best[0];
}

#if defined(__x86_64__)
/* Does the same operations with AVX2, without FMA, so that the result has the same bits. */
DMI_TARGET("avx2") static float nearest_avx2(const columns* c, const float from[3]) {
    return nearest_of(c, from);
}
#endif

static float nearest_square(const columns* c, const float from[3]) {
#if defined(__x86_64__)
    if (dmi_cpu_best_isa() != DMI_ISA_SCALAR) return nearest_avx2(c, from);
#endif
    return nearest_of(c, from);
}

/* Lowers out[i] to the squared distance of point i from the nearest of the others; other_count: a multiple of COLUMN.
 */
static void find_gaps(const float (*points)[3], uint32_t count, const float (*others)[3], uint32_t other_count,
                      float* out) {
    columns c;
    for (uint32_t i = 0; i < count; i++) out[i] = INFINITY;
    for (uint32_t first = 0; first < other_count; first += COLUMN) {
        split_columns(others + first, &c);
        for (uint32_t i = 0; i < count; i++) out[i] = dmi_min(out[i], nearest_square(&c, points[i]));
    }
}

static void make_points(const dmi_cloud* cloud, const dmi_kpp_subset* subset, const dmi_kpp_frame* frame,
                        input_points* out) {
    static const uint32_t count[3] = {DMI_KPP_PART_POINTS, DMI_KPP_NEAR_POINTS, DMI_KPP_BODY_POINTS};
    const float(*const blocks[3])[3] = {subset->part, subset->near, subset->body};
    const float(*const normals[3])[3] = {subset->part_normals, subset->near_normals, subset->body_normals};
    uint32_t n = 0;
    for (int block = 0; block < 3; block++) {
        const float(*others)[3] = (const float(*)[3])cloud->xyz + (block == 0 ? DMI_CLOUD_PART : 0);
        find_gaps(blocks[block], count[block], others, block == 0 ? DMI_CLOUD_NEAR : DMI_CLOUD_PART, out->nearness + n);
        for (uint32_t i = 0; i < count[block]; i++, n++) {
            const float* x = blocks[block][i];
            float y[3];
            dmi_kpp_frame_point_in(frame, x, y);
            for (int k = 0; k < 3; k++) out->y[k][n] = y[k];
            dmi_kpp_frame_rotate(frame, normals[block][i], out->normal[n]);
            out->nearness[n] = 1 / (1 + sqrtf(out->nearness[n]) * frame->scale / HALF_GAP);
        }
    }
}

/* ---- shape ---- */

/* Negates the direction unless its component with the largest magnitude is positive. */
static void sign_line(float line[3]) {
    int largest = fabsf(line[1]) > fabsf(line[0]) ? 1 : 0;
    if (fabsf(line[2]) > fabsf(line[largest])) largest = 2;
    if (line[largest] < 0)
        for (int k = 0; k < 3; k++) line[k] = -line[k];
}

/* Writes the three directions in the frame. Returns the end of what was written. */
static float* write_directions(const dmi_kpp_frame* frame, const float axes[3][3], float* out) {
    for (int k = 0; k < 3; k++, out += 3) {
        dmi_kpp_frame_rotate(frame, axes[k], out);
        sign_line(out);
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
static void write_contact(const input_points* points, float mean[3], float spread[3], float* share) {
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

/* Computes the features, see DMI_KPP_SHAPE_DIRECTIONS and following. */
static void write_shape(const dmi_cloud* cloud, const dmi_kpp_frame* frame, const dmi_kpp_geometry* geometry,
                        const input_drag* drag, const input_points* points, float out[DMI_KPP_SHAPE]) {
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

/* ---- groups ---- */

static void write_group(const input_points* p, const input_drag* drag, uint32_t centre, const uint32_t* members,
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
static void make_groups(const input_points* p, const input_drag* drag, uint32_t count, uint32_t groups,
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
    input_drag drag = {{0, 0, 0}, {0, 0, 0}};
    if (hint != NULL) {
        dmi_kpp_frame_point_in(frame, hint->point, drag.point);
        dmi_kpp_frame_rotate(frame, hint->vector, drag.vector);
        dmi_normalize3(drag.vector);
    }
    input_points points;
    make_points(cloud, &subset, frame, &points);
    write_shape(cloud, frame, &geometry, &drag, &points, out_input->shape);
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
        sign_line(direction);
    }
    flip_vector(shape + DMI_KPP_SHAPE_PART_BOX);
    flip_vector(shape + DMI_KPP_SHAPE_OBJECT_BOX);
    flip_vector(shape + DMI_KPP_SHAPE_DRAG_POINT);
    flip_vector(shape + DMI_KPP_SHAPE_DRAG_VECTOR);
    flip_vector(shape + DMI_KPP_SHAPE_CONTACT_MEAN);
}
