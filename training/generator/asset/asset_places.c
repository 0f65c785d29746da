/* Finds places on the surfaces of a drawn object where something can stand or be screwed on. */
#include "asset/asset_layer.h"

#define FAR 1e30f
#define LEVEL 0.1f /* of the radius: how much higher or lower the surface may be beside the place; by hand */

static dmg_vec corner(const dmg_builder* b, uint32_t face, uint32_t k) {
    return b->vertices[b->indices[3 * face + k]];
}

/* Returns the cross product of two sides: twice the area, along the normal. */
static dmg_vec face_normal(const dmg_builder* b, uint32_t face) {
    const dmg_vec a = corner(b, face, 0);
    return v3_cross(v3_sub(corner(b, face, 1), a), v3_sub(corner(b, face, 2), a));
}

/* Returns the distance along the ray to the face, or FAR (Möller and Trumbore 1997). */
static float hit_distance(const dmg_builder* b, uint32_t face, dmg_vec origin, dmg_vec direction) {
    const dmg_vec a = corner(b, face, 0), u = v3_sub(corner(b, face, 1), a), w = v3_sub(corner(b, face, 2), a);
    const dmg_vec across = v3_cross(direction, w);
    const float determinant = v3_dot(u, across);
    if (fabsf(determinant) < 1e-20f) return FAR;
    const dmg_vec from = v3_sub(origin, a);
    const float s = v3_dot(from, across) / determinant;
    const dmg_vec turned = v3_cross(from, u);
    const float t = v3_dot(direction, turned) / determinant;
    const float distance = v3_dot(w, turned) / determinant;
    return s >= 0.0f && t >= 0.0f && s + t <= 1.0f && distance > 0.0f ? distance : FAR;
}

float dmg_cast(const dmg_builder* b, dmg_vec origin, dmg_vec direction, uint32_t* out_face) {
    float nearest = FAR;
    for (uint32_t f = 0; f < b->face_count; ++f) {
        const float distance = hit_distance(b, f, origin, direction);
        if (distance >= nearest) continue;
        nearest = distance;
        *out_face = f;
    }
    return nearest;
}

static bool suits(const dmg_builder* b, uint32_t face, bool on_body, float least_up, float most_up,
                  dmg_vec* out_normal) {
    if ((b->face_part[face] == 0) != on_body) return false;
    *out_normal = face_normal(b, face);
    const float twice = v3_length(*out_normal);
    return twice > 0.0f && out_normal->y >= least_up * twice && out_normal->y <= most_up * twice;
}

/* Draws a face by area among those that suit; face_count when none does. */
static uint32_t draw_face(dmg_builder* b, bool on_body, float least_up, float most_up) {
    dmg_vec normal;
    float area = 0.0f;
    uint32_t last = b->face_count;
    for (uint32_t f = 0; f < b->face_count; ++f)
        if (suits(b, f, on_body, least_up, most_up, &normal)) area += v3_length(normal);
    float left = area * dmg_unit(b);
    for (uint32_t f = 0; f < b->face_count && left >= 0.0f; ++f) {
        if (!suits(b, f, on_body, least_up, most_up, &normal)) continue;
        left -= v3_length(normal);
        last = f;
    }
    return last;
}

/* Sets the frame of a place at a random point of the face. */
static void stand_on(dmg_builder* b, uint32_t face, dmg_place* out) {
    float u = dmg_unit(b), w = dmg_unit(b);
    if (u + w > 1.0f) u = 1.0f - u, w = 1.0f - w;
    const dmg_vec a = corner(b, face, 0), normal = v3_normalize(face_normal(b, face));
    out->part = b->face_part[face];
    out->frame.origin = v3_mad(v3_mad(a, v3_sub(corner(b, face, 1), a), u), v3_sub(corner(b, face, 2), a), w);
    const dmg_vec helper = fabsf(normal.y) < 0.9f ? v3(0, 1, 0) : v3(0, 0, -1);
    out->frame.column[2] = normal;
    out->frame.column[0] = v3_normalize(v3_cross(helper, normal));
    out->frame.column[1] = v3_cross(normal, out->frame.column[0]);
}

/* Whether the surface goes on `radius` to all four sides, and nothing stands in the way for the same height. Sets how
 * far it is free. */
static bool is_open(const dmg_builder* b, float radius, dmg_place* place) {
    const dmg_vec normal = place->frame.column[2];
    uint32_t face = 0;
    place->radius = radius;
    place->clearance = FAR;
    for (int i = 0; i < 5; ++i) {
        const float along = i == 1 ? radius : i == 2 ? -radius : 0.0f, up = i == 3 ? radius : i == 4 ? -radius : 0.0f;
        dmg_vec at = v3_mad(v3_mad(place->frame.origin, place->frame.column[0], along), place->frame.column[1], up);
        at = v3_mad(at, normal, radius);
        const float down = dmg_cast(b, at, v3_scale(normal, -1.0f), &face);
        if (fabsf(down - radius) > LEVEL * radius || b->face_part[face] != place->part) return false;
        place->clearance = fminf(place->clearance, radius + dmg_cast(b, at, normal, &face));
    }
    return true;
}

bool dmg_find_place(dmg_builder* b, bool on_body, float least_up, float most_up, float radius, dmg_place* out) {
    enum { TRIES = 6 };
    for (int i = 0; i < TRIES; ++i) {
        const uint32_t face = draw_face(b, on_body, least_up, most_up);
        if (face == b->face_count) return false;
        stand_on(b, face, out);
        if (is_open(b, radius, out)) return true;
    }
    return false;
}

bool dmg_is_swept(const dmg_builder* b, uint32_t part, const dmg_bounds* box) {
    dmg_bounds swept[DMG_SWEPT_LIMIT];
    const uint32_t count = dmg_swept_boxes(b, swept);
    for (uint32_t i = 0; i < count; ++i) {
        uint32_t own = part;
        while (own != 0 && own != i / DMG_SWEPT_STOPS + 1) own = b->parts[own - 1].joint.parent;
        if (own == 0 && dmg_boxes_meet(box, &swept[i])) return true;
    }
    return false;
}

void dmg_enter_place(dmg_builder* b, const dmg_place* place) {
    dmg_save(b);
    b->frames[b->frame_depth] = place->frame;
    b->mirrored[b->frame_depth] = false;
    dmg_use(b, place->part);
}
