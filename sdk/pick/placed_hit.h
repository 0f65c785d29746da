/* Where exactly a ray meets a part, shared by the instruction sets like wide_trace.h, which includes this file: TARGET
 * is theirs.
 *
 * A backend only tells which triangle a ray hits first. Where it does is computed here, in doubles from the triangle's
 * corners: the same bits from every backend, and exact on the surface at any distance. */
#ifndef DMI_PICK_PLACED_HIT_H
#define DMI_PICK_PLACED_HIT_H

#include <math.h>
#include <string.h>

#include "base/compiler.h"
#include "pick/placed.h"

#define TARGET_INLINE TARGET DMI_ALWAYS_INLINE static inline
/* How far before a part's box its own ray begins: by the rounding of `entry`, relative, and by that of an origin in the
 * part's frame, in object sizes. Both many times as much as needed. */
#define ENTRY_ROUNDING 1e-6
#define ENTRY_MARGIN 1e-4
/* Share by which a part's ray may pass the nearest hit so far. What lies there is compared in doubles. */
#define FAR_ROUNDING 1e-6

DMI_RETURNS_VECTORS

/* Points and directions; what the fourth number holds does not count. */
typedef DMI_VECTOR(double, 4) vector;
typedef DMI_VECTOR(float, 4) float_vector;

/* A ray in the object-normalised frame of a part, in doubles: from a place shortly before the part. */
typedef struct inner_ray {
    vector origin, direction; /* the direction is as long as in the world */
    double start;             /* distance of that place, in the world */
    double inverse_squared;   /* 1 over the direction's length squared */
} inner_ray;

/* The triangle of a hit: its first corner, and the way to the other two. */
typedef struct triangle {
    vector corner, edge[2];
} triangle;

TARGET_INLINE vector load(const double* numbers) {
    vector v;
    memcpy(&v, numbers, sizeof v);
    return v;
}

TARGET_INLINE vector load_floats(const float* numbers) {
    return (vector){(double)numbers[0], (double)numbers[1], (double)numbers[2], (double)numbers[3]};
}

/* The fourth becomes 0. */
TARGET_INLINE void store_floats(const vector* v, float out[4]) {
    const float_vector floats = {(float)(*v)[0], (float)(*v)[1], (float)(*v)[2], 0};
    memcpy(out, &floats, sizeof floats);
}

TARGET_INLINE dm_vec3 to_host(const vector* v) {
    return (dm_vec3){(float)(*v)[0], (float)(*v)[1], (float)(*v)[2]};
}

/* Applies a matrix without its translation. */
TARGET_INLINE vector turn(const double m[DMI_MATRIX], const vector* v) {
    return load(m) * (*v)[0] + load(m + 3) * (*v)[1] + load(m + 6) * (*v)[2];
}

TARGET_INLINE vector apply(const double m[DMI_MATRIX], const vector* v) {
    return turn(m, v) + load(m + 9);
}

TARGET_INLINE vector next_axes(const vector* v) {
    return (vector){(*v)[1], (*v)[2], (*v)[0], (*v)[3]};
}

TARGET_INLINE vector last_axes(const vector* v) {
    return (vector){(*v)[2], (*v)[0], (*v)[1], (*v)[3]};
}

TARGET_INLINE vector cross(const vector* a, const vector* b) {
    return next_axes(a) * last_axes(b) - last_axes(a) * next_axes(b);
}

TARGET_INLINE double dot(const vector* a, const vector* b) {
    const vector products = *a * *b;
    return products[0] + products[1] + products[2];
}

TARGET_INLINE inner_ray enter_part(const dmi_top_item* item, const dmi_world_ray* ray, float entry) {
    const vector direction = load(ray->direction);
    const double start = (double)entry * (1 - ENTRY_ROUNDING) - ENTRY_MARGIN * item->scale;
    inner_ray inner = {.start = start > 0 ? start : 0};
    const vector from = load(ray->origin) + inner.start * direction;
    inner.origin = apply(item->from_world, &from);
    inner.direction = turn(item->from_world, &direction) * item->scale;
    inner.inverse_squared = 1 / dot(&inner.direction, &inner.direction);
    return inner;
}

TARGET_INLINE triangle load_triangle(const dmi_bvh_part* shape, uint32_t face) {
    const float* corners[3];
    dmi_bvh_corners(shape, face, corners);
    triangle t = {.corner = load_floats(corners[0])}; /* the padding is readable */
    for (int i = 0; i < 2; i++) t.edge[i] = load_floats(corners[i + 1]) - t.corner;
    return t;
}

/* Brings weights into the triangle: rounding may have put the hit past an edge by a hair. */
TARGET_INLINE void clamp_weights(double weight[2]) {
    for (int i = 0; i < 2; i++) weight[i] = weight[i] > 0 ? weight[i] : 0;
    const double sum = weight[0] + weight[1];
    for (int i = 0; i < 2 && sum > 1; i++) weight[i] /= sum;
}

/* Where the ray meets the plane of a triangle (Möller and Trumbore 1997), within it; returns the distance. Along the
 * plane, where that is nowhere or everywhere, the backend's floats have to do. */
TARGET_INLINE double meet_triangle(const triangle* t, const inner_ray* inner, const dmi_part_hit* hit,
                                   double out_weight[2]) {
    const vector to_origin = inner->origin - t->corner;
    const vector p = cross(&inner->direction, &t->edge[1]), q = cross(&to_origin, &t->edge[0]);
    const double divisor = dot(&t->edge[0], &p), inverse = 1 / divisor;
    out_weight[0] = divisor != 0 ? dot(&to_origin, &p) * inverse : (double)hit->u;
    out_weight[1] = divisor != 0 ? dot(&inner->direction, &q) * inverse : (double)hit->v;
    clamp_weights(out_weight);
    const vector point = out_weight[0] * t->edge[0] + out_weight[1] * t->edge[1] - to_origin;
    const double distance = dot(&point, &inner->direction) * inner->inverse_squared;
    return distance > 0 ? distance : 0;
}

/* Whether a part comes before that of a hit, when both are as far away. */
TARGET_INLINE bool comes_before(const dmi_placed_part* part, const dmi_placed_part* other) {
    if (part->owner->id != other->owner->id) return part->owner->id < other->owner->id;
    return part->shape < other->shape;
}

/* Prefetches what describes a hit, so that it comes while the hit is measured. In a large scene nothing of a part is in
 * the cache. */
TARGET_INLINE void fetch_matrices(const dmi_placed_part* part) {
    const char* at = (const char*)part->to_world;
    for (size_t i = 0; i < 2 * sizeof part->to_world; i += DMI_ALIGNMENT) DMI_PREFETCH(at + i);
}

/* Tests a part whose box the ray enters at `entry`; replaces a hit that is farther away. Of hits at the same distance,
 * that of the lower instance and part wins, so that the order of tests does not count. */
TARGET DMI_NO_INLINE static void hit_part(const dmi_top_item* item, const dmi_world_ray* ray, float entry,
                                          dmi_world_hit* hit) {
    const dmi_bvh_part* shape = item->shape;
    const inner_ray inner = enter_part(item, ray, entry);
    const double left = (hit->distance - inner.start) * (1 / item->scale);
    dmi_part_ray part_ray = {.far = (float)(left * (1 + FAR_ROUNDING) + FAR_ROUNDING)};
    store_floats(&inner.origin, part_ray.origin);
    store_floats(&inner.direction, part_ray.direction);
    dmi_part_hit found;
    if (!shape->first_hit(shape->tree, &part_ray, &found)) return;
    const dmi_placed_part* part = item->part;
    fetch_matrices(part);
    const triangle t = load_triangle(shape, found.face);
    double weight[2];
    const double distance = inner.start + item->scale * meet_triangle(&t, &inner, &found, weight);
    if (!(distance <= hit->distance)) return;
    if (distance == hit->distance && hit->part != NULL && !comes_before(part, hit->part)) return;
    hit->part = part;
    hit->distance = distance;
    hit->weight[0] = weight[0];
    hit->weight[1] = weight[1];
    hit->face = found.face;
    memcpy(hit->triangle, &t, sizeof hit->triangle);
}

/* Returns the triangle's normal in the world, unit; the direction against the ray where it has no area. */
TARGET_INLINE vector world_normal(const dmi_placed_part* part, const triangle* t, const vector* direction) {
    const vector inner = cross(&t->edge[0], &t->edge[1]), n = turn(part->to_world, &inner);
    const double squared = dot(&n, &n);
    return squared > 0 ? n * (part->winding / sqrt(squared)) : -*direction;
}

TARGET DMI_NO_INLINE static void describe_hit(const dmi_world_ray* ray, const dmi_world_hit* hit, dm_hit* out_hit) {
    const dmi_placed_part* part = hit->part;
    const dmi_bvh_part* shape = part->shape;
    const triangle t = {load(hit->triangle[0]), {load(hit->triangle[1]), load(hit->triangle[2])}};
    const vector direction = load(ray->direction);
    const vector inner = t.corner + hit->weight[0] * t.edge[0] + hit->weight[1] * t.edge[1];
    const vector object = apply(part->to_object, &inner), world = apply(part->to_world, &inner);
    const vector normal = world_normal(part, &t, &direction);
    *out_hit = (dm_hit){.object = part->owner->object,
                        .instance = part->owner->id,
                        .part_id = shape->id,
                        .triangle = dmi_packed_of_mesh(shape->mesh, shape->first_face + hit->face),
                        .distance = (float)(hit->distance * sqrt(dot(&direction, &direction))),
                        .u = (float)hit->weight[0],
                        .v = (float)hit->weight[1],
                        .point = to_host(&world),
                        .normal = to_host(&normal),
                        .object_point = to_host(&object)};
}

#endif
