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

void dmi_pose_matrix_f64(const dm_pose* pose, double out[12]) {
    double x = (double)pose->real[0], y = (double)pose->real[1], z = (double)pose->real[2], w = (double)pose->real[3];
    double a = (double)pose->dual[0], b = (double)pose->dual[1], c = (double)pose->dual[2], d = (double)pose->dual[3];
    const double columns[12] = {
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

static void apply(const double m[12], const double p[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = m[i] * p[0] + m[3 + i] * p[1] + m[6 + i] * p[2] + m[9 + i];
}

/* Applies the matrix without its translation. */
static void apply_linear(const double m[12], const double direction[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = m[i] * direction[0] + m[3 + i] * direction[1] + m[6 + i] * direction[2];
}

static void multiply(const double a[12], const double b[12], double out[12]) {
    for (int column = 0; column < 3; column++) apply_linear(a, b + 3 * column, out + 3 * column);
    apply(a, b + 9, out + 9);
}

/* Applies the inverse of the linear part, which is a turn times `scale` (mirrored or not), times `scale` squared. */
static void apply_transposed(const double m[12], const double direction[3], double out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = m[3 * i] * direction[0] + m[3 * i + 1] * direction[1] + m[3 * i + 2] * direction[2];
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
    const dmi_bvh_part* shape = &part->owner->bvh->parts[part->part];
    double centre[3], half[3], middle[3];
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

void dmi_placed_part_update(dmi_placed_part* part, const double placement[12], const double from_inner[12],
                            dmi_box* out_box) {
    double pose[12];
    dmi_pose_matrix_f64(&part->pose, pose);
    multiply(pose, from_inner, part->to_object);
    multiply(placement, part->to_object, part->to_world);
    const double* m = part->to_world;
    part->scale = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    part->inverse_scale = 1 / part->scale;
    part->moved = false;
    measure_box(part, out_box);
}

/* ---- hits ---- */

/* A ray in the object-normalised frame of a part, in doubles: from a place shortly before the part. */
typedef struct inner_ray {
    double origin[3], direction[3]; /* the direction is as long as in the world */
    double start;                   /* distance of that place, in the world */
} inner_ray;

static inner_ray enter_part(const dmi_placed_part* part, const dmi_world_ray* ray, float entry) {
    inner_ray inner;
    const double* m = part->to_world;
    double from[3];
    const double start = (double)entry * (1 - ENTRY_ROUNDING) - ENTRY_MARGIN * part->scale;
    inner.start = start > 0 ? start : 0;
    for (int k = 0; k < 3; k++) from[k] = ray->origin[k] + inner.start * ray->direction[k] - m[9 + k];
    apply_transposed(m, from, inner.origin);
    apply_transposed(m, ray->direction, inner.direction);
    for (int k = 0; k < 3; k++) {
        inner.origin[k] *= part->inverse_scale * part->inverse_scale;
        inner.direction[k] *= part->inverse_scale;
    }
    return inner;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Brings weights into the triangle: rounding may have put the hit past an edge by a hair. */
static void clamp_weights(double weight[2]) {
    for (int i = 0; i < 2; i++) weight[i] = weight[i] > 0 ? weight[i] : 0;
    const double sum = weight[0] + weight[1];
    for (int i = 0; i < 2 && sum > 1; i++) weight[i] /= sum;
}

/* Where the ray meets the plane of a triangle (Möller and Trumbore 1997), within it; returns the distance. Along the
 * plane, where that is nowhere or everywhere, the backend's floats have to do. */
static double meet_triangle(const dmi_bvh* bvh, uint32_t part, const inner_ray* ray, const dmi_part_hit* hit,
                            double out_weight[2]) {
    const float* corners[3];
    dmi_bvh_corners(bvh, part, hit->face, corners);
    double edge[2][3], to_origin[3], p[3], q[3], point[3];
    for (int k = 0; k < 3; k++) {
        const double corner = (double)corners[0][k];
        for (int i = 0; i < 2; i++) edge[i][k] = (double)corners[i + 1][k] - corner;
        to_origin[k] = ray->origin[k] - corner;
    }
    cross(ray->direction, edge[1], p);
    cross(to_origin, edge[0], q);
    const double determinant = dot(edge[0], p), inverse = 1 / determinant;
    out_weight[0] = determinant != 0 ? dot(to_origin, p) * inverse : (double)hit->u;
    out_weight[1] = determinant != 0 ? dot(ray->direction, q) * inverse : (double)hit->v;
    clamp_weights(out_weight);
    for (int k = 0; k < 3; k++) point[k] = out_weight[0] * edge[0][k] + out_weight[1] * edge[1][k] - to_origin[k];
    const double distance = dot(point, ray->direction) / dot(ray->direction, ray->direction);
    return distance > 0 ? distance : 0;
}

/* Whether a part comes before that of a hit, when both are as far away. */
static bool comes_before(const dmi_placed_part* part, const dmi_placed_part* other) {
    if (part->owner->id != other->owner->id) return part->owner->id < other->owner->id;
    return part->part < other->part;
}

void dmi_placed_part_hit(const dmi_placed_part* part, const dmi_world_ray* ray, float entry, dmi_world_hit* hit) {
    const dmi_bvh* bvh = part->owner->bvh;
    const inner_ray inner = enter_part(part, ray, entry);
    const double left = (hit->distance - inner.start) * part->inverse_scale;
    dmi_part_ray part_ray = {.far = (float)(left * (1 + FAR_ROUNDING) + FAR_ROUNDING)};
    for (int k = 0; k < 3; k++) {
        part_ray.origin[k] = (float)inner.origin[k];
        part_ray.direction[k] = (float)inner.direction[k];
    }
    dmi_part_hit found;
    if (!bvh->picker->backend->first_hit(bvh->parts[part->part].tree, &part_ray, &found)) return;
    double weight[2];
    const double distance = inner.start + part->scale * meet_triangle(bvh, part->part, &inner, &found, weight);
    if (!(distance <= hit->distance)) return;
    if (distance == hit->distance && hit->part != NULL && !comes_before(part, hit->part)) return;
    *hit = (dmi_world_hit){.part = part, .distance = distance, .weight = {weight[0], weight[1]}, .face = found.face};
}

/* Returns a x b, unit; the direction against the ray where the triangle has no area. */
static dm_vec3 edge_normal(const double a[3], const double b[3], const double direction[3]) {
    double n[3];
    cross(a, b, n);
    const double squared = dot(n, n), inverse = 1 / sqrt(squared);
    for (int k = 0; k < 3; k++) n[k] = squared > 0 ? n[k] * inverse : -direction[k];
    return dmi_vec3_f64(n);
}

void dmi_placed_part_describe(const dmi_world_ray* ray, const dmi_world_hit* hit, dm_hit* out_hit) {
    const dmi_placed_part* part = hit->part;
    const dmi_bvh* bvh = part->owner->bvh;
    const float* corners[3];
    dmi_bvh_corners(bvh, part->part, hit->face, corners);
    double edges[2][3], inner[3], object[3], world[3], world_edges[2][3];
    for (int k = 0; k < 3; k++) {
        const double corner = (double)corners[0][k];
        for (int i = 0; i < 2; i++) edges[i][k] = (double)corners[i + 1][k] - corner;
        inner[k] = corner + hit->weight[0] * edges[0][k] + hit->weight[1] * edges[1][k];
    }
    apply(part->to_object, inner, object);
    apply(part->to_world, inner, world);
    for (int i = 0; i < 2; i++) apply_linear(part->to_world, edges[i], world_edges[i]);
    *out_hit = (dm_hit){.object = part->owner->object,
                        .instance = part->owner->id,
                        .part_id = bvh->parts[part->part].id,
                        .triangle = bvh->faces[bvh->parts[part->part].first_face + hit->face],
                        .distance = (float)(hit->distance * sqrt(dot(ray->direction, ray->direction))),
                        .u = (float)hit->weight[0],
                        .v = (float)hit->weight[1],
                        .point = dmi_vec3_f64(world),
                        .normal = edge_normal(world_edges[0], world_edges[1], ray->direction),
                        .object_point = dmi_vec3_f64(object)};
}
