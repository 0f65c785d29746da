/* How deep push buttons go into what they are on, and how far: a hand sees their tops alone. Some are drawn as caps,
 * some with the stem that reaches the switch; and they sink by millimetres, whether they stand out much or little. */
#include "build.h"

typedef struct interval {
    float low, high;
} interval;

/* From where to where a part lies along a unit direction. */
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

/* A small part at one end of a short slide that goes into the body; answers which way that is. */
static bool is_pressed(const dmg_builder* b, uint32_t part, float size, dmg_vec* out_in) {
    const dmg_joint* joint = &b->parts[part - 1].joint;
    const float way = joint->upper + joint->lower, range = joint->upper - joint->lower;
    if (joint->type != DM_JOINT_PRISMATIC || range <= 0.0f || range > 0.06f * size || carries(b, part)) return false;
    if (fabsf(way) < 0.9f * range) return false;
    static const dmg_vec sides[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; ++i) {
        const interval wide = extent(b, part, sides[i]);
        if (!(wide.high - wide.low < 0.25f * size)) return false;
    }
    *out_in = v3_scale(v3_from(joint->axis), way < 0 ? -1.0f : 1.0f);
    const interval own = extent(b, part, *out_in), body = extent(b, 0, *out_in);
    return own.high - own.low > 1e-3f * size && body.high > own.high && body.high - own.high > own.low - body.low;
}

/* Its lower quarter goes down by a few times its height, as far as there is body. */
static void deepen(dmg_builder* b, uint32_t part, dmg_vec in, float times) {
    const interval own = extent(b, part, in), body = extent(b, 0, in);
    const float height = own.high - own.low, more = fminf(times * height, 0.8f * (body.high - own.high));
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v)
            if (v3_dot(b->vertices[v], in) > own.high - 0.25f * height)
                b->vertices[v] = v3_mad(b->vertices[v], in, more);
    }
}

/* Its way anew, no farther than one and a half times its height. */
static void set_travel(dmg_builder* b, uint32_t part, dmg_vec in, float travel) {
    const interval own = extent(b, part, in);
    dmg_joint* joint = &b->parts[part - 1].joint;
    travel = fminf(travel, 1.5f * (own.high - own.low));
    if (joint->upper + joint->lower < 0)
        joint->lower = -travel, joint->upper = 0;
    else
        joint->lower = 0, joint->upper = travel;
}

void dmg_sink_buttons(dmg_builder* b, float size) {
    const bool anew = dmg_chance(b, 0.4f), deep = dmg_chance(b, 0.4f);
    const float travel = size * dmg_scale_range(b, 0.002f, 0.03f), times = dmg_scale_range(b, 0.5f, 12.0f);
    for (uint32_t part = 1; part <= b->part_count; ++part) {
        dmg_vec in;
        if (!is_pressed(b, part, size, &in)) continue;
        if (anew) set_travel(b, part, in, travel * dmg_scale_range(b, 0.8f, 1.25f));
        if (deep) deepen(b, part, in, times);
    }
}
