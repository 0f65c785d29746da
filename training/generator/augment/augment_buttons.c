/* Varies push buttons below the surface and in their travel: some become stems that reach deep into the body, and some
 * travel by a length that has nothing to do with how far they stand out. Their visible tops stay as they are. */
#include "core/build.h"

typedef struct interval {
    float low, high;
} interval;

/* Returns the interval of a part along a unit direction. */
static interval extent(const dmg_builder* b, uint32_t part, dmg_vec along) {
    interval out = {INFINITY, -INFINITY};
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v) {
            const float at = v3_dot(b->vertices[v], along);
            out.low = fminf(out.low, at), out.high = fmaxf(out.high, at);
        }
    }
    return out;
}

static bool carries(const dmg_builder* b, uint32_t part) {
    for (uint32_t i = 0; i < b->part_count; ++i)
        if (b->parts[i].joint.parent == part) return true;
    return false;
}

/* A push button. */
typedef struct plunger {
    dmg_vec in;           /* the way it goes, unit */
    bool backwards;       /* which is against the joint's axis */
    float bottom, height; /* along that way */
    float room;           /* of the body below it */
} plunger;

static bool is_small(const dmg_builder* b, uint32_t part, float size) {
    const dmg_bounds box = dmg_part_bounds(b, part);
    const dmg_vec wide = v3_sub(box.high, box.low);
    return fmaxf(wide.x, fmaxf(wide.y, wide.z)) < 0.25f * size;
}

/* Recognises a push button: a small part at one end of a short slide that goes into the body. */
static bool is_pressed(const dmg_builder* b, uint32_t part, float size, plunger* out) {
    const dmg_joint* joint = &b->parts[part - 1].joint;
    const float way = joint->upper + joint->lower, range = joint->upper - joint->lower;
    if (joint->type != DM_JOINT_PRISMATIC || range <= 0.0f || range > 0.06f * size || carries(b, part)) return false;
    if (fabsf(way) < 0.9f * range || !is_small(b, part, size)) return false;
    out->backwards = way < 0;
    out->in = v3_scale(v3_from(joint->axis), out->backwards ? -1.0f : 1.0f);
    const interval own = extent(b, part, out->in), body = extent(b, 0, out->in);
    out->bottom = own.high, out->height = own.high - own.low, out->room = body.high - own.high;
    return out->height > 1e-3f * size && out->room > 0 && out->room > own.low - body.low;
}

/* Moves the lower quarter of the part down by `times` its height, at most four fifths of the body below. */
static void deepen(dmg_builder* b, uint32_t part, const plunger* pressed, float times) {
    const float more = fminf(times * pressed->height, 0.8f * pressed->room);
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v)
            if (v3_dot(b->vertices[v], pressed->in) > pressed->bottom - 0.25f * pressed->height)
                b->vertices[v] = v3_mad(b->vertices[v], pressed->in, more);
    }
}

/* Replaces the travel, at most one and a half times the part's height. */
static void set_travel(dmg_joint* joint, const plunger* pressed, float travel) {
    travel = fminf(travel, 1.5f * pressed->height);
    joint->lower = pressed->backwards ? -travel : 0;
    joint->upper = pressed->backwards ? 0 : travel;
}

void dmg_augment_buttons(dmg_builder* b, float size) {
    const bool anew = dmg_chance(b, 0.4f), deep = dmg_chance(b, 0.4f);
    const float travel = size * dmg_scale_range(b, 0.002f, 0.03f), times = dmg_scale_range(b, 0.5f, 12.0f);
    for (uint32_t part = 1; part <= b->part_count; ++part) {
        plunger pressed;
        if (!is_pressed(b, part, size, &pressed)) continue;
        if (anew) set_travel(&b->parts[part - 1].joint, &pressed, travel * dmg_scale_range(b, 0.8f, 1.25f));
        if (deep) deepen(b, part, &pressed, times);
    }
}
