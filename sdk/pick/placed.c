/* Places parts in the world, and finds the exact point where a ray meets one.
 *
 * A backend only tells which triangle a ray hits first. Where it does is computed here, in doubles from the triangle's
 * corners: the same bits from every backend, and exact on the surface at any distance. */
#include "pick/placed.h"

#include <math.h>
#include <string.h>

#include "math/vec3.h"

/* How far before a part's box its own ray begins: by the rounding of `entry`, relative, and by that of an origin in the
 * part's frame, in object sizes. Both many times as much as needed. */
#define ENTRY_ROUNDING 1e-6
#define ENTRY_MARGIN 1e-4
/* By how much a part's ray may pass the nearest hit so far: what lies there is compared in doubles. */
#define FAR_ROUNDING 1e-6

/* ---- matrices ---- */

void dmi_pose_matrix_f64(const dm_pose* pose, double out[DMI_MATRIX]) {
    double x = (double)pose->real[0], y = (double)pose->real[1], z = (double)pose->real[2], w = (double)pose->real[3];
    double a = (double)pose->dual[0], b = (double)pose->dual[1], c = (double)pose->dual[2], d = (double)pose->dual[3];
    const double columns[DMI_MATRIX] = {
        1 - 2 * (y * y + z * z),
        2 * (x * y + w * z),
        2 * (x * z - w * y),
        2 * (x * y - w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z + w * x),
        2 * (x * z + w * y),
        2 * (y * z - w * x),
        1 - 2 * (x * x + y * y),
        2 * (w * a - d * x + y * c - z * b),
        2 * (w * b - d * y + z * a - x * c),
        2 * (w * c - d * z + x * b - y * a),
    };
    memcpy(out, columns, sizeof columns);
}

static void apply(const double m[DMI_MATRIX], const double p[4], double out[4]) {
    for (int i = 0; i < 4; i++) out[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2] + m[9 + i];
}

/* Applies the matrix without its translation. */
static void apply_linear(const double m[DMI_MATRIX], const double direction[4], double out[4]) {
    for (int i = 0; i < 4; i++) out[i] = m[i] * direction[0] + m[3 + i] * direction[1] + m[6 + i] * direction[2];
}

static void multiply(const double a[DMI_MATRIX], const double b[DMI_MATRIX], double out[DMI_MATRIX]) {
    double column[4];
    for (int i = 0; i < 3; i++) {
        apply_linear(a, b + 3 * i, column);
        memcpy(out + 3 * i, column, 3 * sizeof *column);
    }
    apply(a, b + 9, column);
    memcpy(out + 9, column, sizeof column);
}

/* Inverts a turn, mirrored or not, times `scale`. */
static void invert(const double m[DMI_MATRIX], double inverse_scale, double out[DMI_MATRIX]) {
    const double squared = inverse_scale * inverse_scale;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) out[3 * i + k] = m[3 * k + i] * squared;
    for (int k = 0; k < 4; k++) out[9 + k] = 0;
    double shift[4];
    apply_linear(out, m + 9, shift);
    for (int k = 0; k < 3; k++) out[9 + k] = -shift[k];
}

static double determinant(const double m[DMI_MATRIX]) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[3] * (m[1] * m[8] - m[2] * m[7]) + m[6] * (m[1] * m[5] - m[2] * m[4]);
}

/* ---- places ---- */

static float round_down(double x) {
    const float f = (float)x;
    return (double)f > x ? nextafterf(f, -INFINITY) : f;
}

static float round_up(double x) {
    const float f = (float)x;
    return (double)f < x ? nextafterf(f, INFINITY) : f;
}

/* Box of the moved box of a part. */
static void measure_box(const dmi_placed_part* part, dmi_box* out) {
    const dmi_bvh_part* shape = part->shape;
    double centre[4], half[3], middle[4] = {0};
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * ((double)shape->low[k] + (double)shape->high[k]);
        half[k] = 0.5 * ((double)shape->high[k] - (double)shape->low[k]);
    }
    const double* m = part->to_world;
    apply(m, middle, centre);
    *out = (dmi_box){{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const double reach = fabs(m[k]) * half[0] + fabs(m[3 + k]) * half[1] + fabs(m[6 + k]) * half[2];
        out->low[k] = round_down(centre[k] - reach);
        out->high[k] = round_up(centre[k] + reach);
    }
}

void dmi_placed_part_update(dmi_placed_part* part, const double placement[DMI_MATRIX],
                            const double from_inner[DMI_MATRIX], dmi_box* out_box) {
    double pose[DMI_MATRIX];
    dmi_pose_matrix_f64(&part->pose, pose);
    multiply(pose, from_inner, part->to_object);
    multiply(placement, part->to_object, part->to_world);
    const double* m = part->to_world;
    part->scale = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    part->inverse_scale = 1 / part->scale;
    part->winding = determinant(m) < 0 ? -1 : 1;
    invert(m, part->inverse_scale, part->from_world);
    part->moved = false;
    measure_box(part, out_box);
}

/* ---- hits ---- */

/* A ray in the object-normalised frame of a part, in doubles: from a place shortly before the part. */
typedef struct inner_ray {
    double origin[4], direction[4]; /* the direction is as long as in the world */
    double start;                   /* distance of that place, in the world */
} inner_ray;

/* The triangle of a hit: its first corner, and the way to the other two. */
typedef struct triangle {
    double corner[4], edge[2][4];
} triangle;

static void cross(const double a[4], const double b[4], double out[4]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[4], const double b[4]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inner_ray enter_part(const dmi_placed_part* part, const dmi_world_ray* ray, float entry) {
    inner_ray inner;
    double from[4];
    const double start = (double)entry * (1 - ENTRY_ROUNDING) - ENTRY_MARGIN * part->scale;
    inner.start = start > 0 ? start : 0;
    for (int k = 0; k < 4; k++) from[k] = ray->origin[k] + inner.start * ray->direction[k];
    apply(part->from_world, from, inner.origin);
    apply_linear(part->from_world, ray->direction, inner.direction);
    for (int k = 0; k < 4; k++) inner.direction[k] *= part->scale;
    return inner;
}

static triangle load_triangle(const dmi_placed_part* part, uint32_t face) {
    const float* corners[3];
    triangle t;
    dmi_bvh_corners(part->owner->bvh, part->shape, face, corners);
    for (int k = 0; k < 4; k++) { /* the padding is readable */
        t.corner[k] = (double)corners[0][k];
        for (int i = 0; i < 2; i++) t.edge[i][k] = (double)corners[i + 1][k] - t.corner[k];
    }
    return t;
}

/* Brings weights into the triangle: rounding may have put the hit past an edge by a hair. */
static void clamp_weights(double weight[2]) {
    for (int i = 0; i < 2; i++) weight[i] = weight[i] > 0 ? weight[i] : 0;
    const double sum = weight[0] + weight[1];
    for (int i = 0; i < 2 && sum > 1; i++) weight[i] /= sum;
}

/* Where the ray meets the plane of a triangle (Möller and Trumbore 1997), within it; returns the distance. Along the
 * plane, where that is nowhere or everywhere, the backend's floats have to do. */
static double meet_triangle(const triangle* t, const inner_ray* inner, const dmi_part_hit* hit, double out_weight[2]) {
    double to_origin[4], p[4], q[4], point[4];
    for (int k = 0; k < 4; k++) to_origin[k] = inner->origin[k] - t->corner[k];
    cross(inner->direction, t->edge[1], p);
    cross(to_origin, t->edge[0], q);
    const double divisor = dot(t->edge[0], p), inverse = 1 / divisor;
    out_weight[0] = divisor != 0 ? dot(to_origin, p) * inverse : (double)hit->u;
    out_weight[1] = divisor != 0 ? dot(inner->direction, q) * inverse : (double)hit->v;
    clamp_weights(out_weight);
    for (int k = 0; k < 4; k++) point[k] = out_weight[0] * t->edge[0][k] + out_weight[1] * t->edge[1][k] - to_origin[k];
    const double distance = dot(point, inner->direction) / dot(inner->direction, inner->direction);
    return distance > 0 ? distance : 0;
}

/* Whether a part comes before that of a hit, when both are as far away. */
static bool comes_before(const dmi_placed_part* part, const dmi_placed_part* other) {
    if (part->owner->id != other->owner->id) return part->owner->id < other->owner->id;
    return part->shape < other->shape;
}

void dmi_placed_part_hit(const dmi_placed_part* part, const dmi_world_ray* ray, float entry, dmi_world_hit* hit) {
    const inner_ray inner = enter_part(part, ray, entry);
    const double left = (hit->distance - inner.start) * part->inverse_scale;
    dmi_part_ray part_ray = {.far = (float)(left * (1 + FAR_ROUNDING) + FAR_ROUNDING)};
    for (int k = 0; k < 4; k++) {
        part_ray.origin[k] = (float)inner.origin[k];
        part_ray.direction[k] = (float)inner.direction[k];
    }
    dmi_part_hit found;
    if (!part->first_hit(part->shape->tree, &part_ray, &found)) return;
    const triangle t = load_triangle(part, found.face);
    double weight[2];
    const double distance = inner.start + part->scale * meet_triangle(&t, &inner, &found, weight);
    if (!(distance <= hit->distance)) return;
    if (distance == hit->distance && hit->part != NULL && !comes_before(part, hit->part)) return;
    *hit = (dmi_world_hit){.part = part, .distance = distance, .weight = {weight[0], weight[1]}, .face = found.face};
}

/* Returns the triangle's normal in the world, unit; the direction against the ray where it has no area. */
static dm_vec3 world_normal(const dmi_placed_part* part, const triangle* t, const double direction[4]) {
    double inner[4] = {0}, n[4];
    cross(t->edge[0], t->edge[1], inner);
    apply_linear(part->to_world, inner, n);
    const double squared = dot(n, n), inverse = part->winding / sqrt(squared);
    for (int k = 0; k < 3; k++) n[k] = squared > 0 ? n[k] * inverse : -direction[k];
    return dmi_vec3_f64(n);
}

void dmi_placed_part_describe(const dmi_world_ray* ray, const dmi_world_hit* hit, dm_hit* out_hit) {
    const dmi_placed_part* part = hit->part;
    const dmi_bvh_part* shape = part->shape;
    const triangle t = load_triangle(part, hit->face);
    double inner[4], object[4], world[4];
    for (int k = 0; k < 4; k++) inner[k] = t.corner[k] + hit->weight[0] * t.edge[0][k] + hit->weight[1] * t.edge[1][k];
    apply(part->to_object, inner, object);
    apply(part->to_world, inner, world);
    *out_hit = (dm_hit){.object = part->owner->object,
                        .instance = part->owner->id,
                        .part_id = shape->id,
                        .triangle = part->owner->bvh->faces[shape->first_face + hit->face],
                        .distance = (float)(hit->distance * sqrt(dot(ray->direction, ray->direction))),
                        .u = (float)hit->weight[0],
                        .v = (float)hit->weight[1],
                        .point = dmi_vec3_f64(world),
                        .normal = world_normal(part, &t, ray->direction),
                        .object_point = dmi_vec3_f64(object)};
}
