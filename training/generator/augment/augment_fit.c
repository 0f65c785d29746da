/* Changes how tightly parts fit their surroundings, as in meshes that people make: enlarges parts beyond their opening,
 * sinks them into the body, closes the body behind them, frames them without a gap. Lengths are shares of the part's
 * box diagonal; their ranges were set by hand. */
#include "core/build.h"

enum { STOPS = 6 };

static dmg_vec middle(const dmg_bounds* box) {
    return v3_lerp(box->low, box->high, 0.5f);
}

static float diagonal(const dmg_bounds* box) {
    return v3_length(v3_sub(box->high, box->low));
}

static float grown(float x, float centre, float half, float by) {
    return x + (x - centre) * fminf(by / fmaxf(half, 1e-6f), 0.5f);
}

/* Enlarges the part's box by the same length on every side. */
static void swell(dmg_builder* b, uint32_t part, float by) {
    dmg_bounds box = dmg_part_bounds(b, part);
    dmg_vec c = middle(&box), half = v3_scale(v3_sub(box.high, box.low), 0.5f);
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (b->pieces[p].part != part) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v) {
            dmg_vec at = b->vertices[v];
            b->vertices[v] =
                v3(grown(at.x, c.x, half.x, by), grown(at.y, c.y, half.y, by), grown(at.z, c.z, half.z, by));
        }
    }
}

static bool carried_by(const dmg_builder* b, uint32_t part, uint32_t carrier) {
    while (part != 0 && part != carrier) part = b->parts[part - 1].joint.parent;
    return part == carrier;
}

/* Shifts a part with its joint and what it carries. */
static void shift_part(dmg_builder* b, uint32_t part, dmg_vec by) {
    for (uint32_t p = 0; p < b->piece_count; ++p) {
        if (!carried_by(b, b->pieces[p].part, part)) continue;
        for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v)
            b->vertices[v] = v3_add(b->vertices[v], by);
    }
    for (uint32_t i = 1; i <= b->part_count; ++i) {
        if (!carried_by(b, i, part)) continue;
        float* origin = b->parts[i - 1].joint.origin;
        origin[0] += by.x;
        origin[1] += by.y;
        origin[2] += by.z;
    }
}

static float along(dmg_vec v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static dmg_vec with(dmg_vec v, int axis, float value) {
    return v3(axis == 0 ? value : v.x, axis == 1 ? value : v.y, axis == 2 ? value : v.z);
}

/* Returns the sign of the side on which the body lies along an axis; the other side in a fifth of the cases. */
static float body_side(dmg_builder* b, const dmg_bounds* part, const dmg_bounds* body, int axis) {
    float side = along(middle(body), axis) < along(middle(part), axis) ? -1.0f : 1.0f;
    return dmg_chance(b, 0.8f) ? side : -side;
}

/* Returns whether at most one in fifty of the part's vertices, over STOPS values of its range, lie inside the box. */
static bool leaves_free(const dmg_builder* b, uint32_t part, const dmg_bounds* room, float slack) {
    const dmg_joint* joint = &b->parts[part - 1].joint;
    dmg_vec low = v3_add(room->low, v3(slack, slack, slack)), high = v3_sub(room->high, v3(slack, slack, slack));
    uint32_t inside = 0, all = 0;
    for (int s = 0; s < STOPS; ++s) {
        dmg_frame pose = dmg_joint_frame(joint, dmg_joint_stop(joint, s, STOPS));
        for (uint32_t p = 0; p < b->piece_count; ++p) {
            if (!carried_by(b, b->pieces[p].part, part)) continue;
            for (uint32_t v = b->pieces[p].first_vertex; v < dmg_piece_end(b, p); ++v, ++all) {
                dmg_vec at = dmg_frame_point(&pose, b->vertices[v]);
                inside +=
                    at.x > low.x && at.x < high.x && at.y > low.y && at.y < high.y && at.z > low.z && at.z < high.z;
            }
        }
    }
    return inside * 50 <= all;
}

static void draw_if_free(dmg_builder* b, uint32_t part, dmg_bounds room, float slack) {
    if (leaves_free(b, part, &room, slack)) dmg_box_span(b, room.low, room.high);
}

/* Adds a box of body behind the part, as if there were no opening. */
static void back(dmg_builder* b, uint32_t part, const dmg_bounds* body, int axis) {
    dmg_bounds box = dmg_part_bounds(b, part), room = box;
    float size = diagonal(&box), side = body_side(b, &box, body, axis);
    float gap = size * dmg_range(b, -0.02f, 0.015f), thick = size * dmg_scale_range(b, 0.01f, 0.3f);
    for (int i = 0; i < 3; ++i) {
        float low = along(box.low, i), high = along(box.high, i), wide = high - low;
        float before = wide * dmg_range(b, -0.2f, 0.4f), after = wide * dmg_range(b, -0.2f, 0.4f);
        low = i != axis ? low - before : side < 0 ? low - gap - thick : high + gap;
        high = i != axis ? high + after : low + thick;
        room.low = with(room.low, i, low);
        room.high = with(room.high, i, high);
    }
    draw_if_free(b, part, room, 0.02f * size);
}

/* Adds bars round the part, across the axis. */
static void frame(dmg_builder* b, uint32_t part, const dmg_bounds* body, int axis) {
    dmg_bounds box = dmg_part_bounds(b, part);
    float size = diagonal(&box), gap = size * dmg_range(b, -0.01f, 0.015f),
          width = size * dmg_scale_range(b, 0.02f, 0.5f);
    float side = body_side(b, &box, body, axis),
          deep = along(v3_sub(box.high, box.low), axis) * dmg_range(b, 0.2f, 1.0f);
    float more = size * dmg_scale_range(b, 0.005f, 0.2f);
    float low = side < 0 ? along(box.low, axis) - more : along(box.high, axis) - deep;
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        for (int end = 0; end < 2; ++end) {
            dmg_bounds room = {v3_sub(box.low, v3(width, width, width)), v3_add(box.high, v3(width, width, width))};
            room.low = with(room.low, axis, low);
            room.high = with(room.high, axis, low + deep + more);
            float at = end ? along(box.high, i) + gap : along(box.low, i) - gap - width;
            room.low = with(room.low, i, at);
            room.high = with(room.high, i, at + width);
            if (dmg_chance(b, 0.85f)) draw_if_free(b, part, room, 0.02f * size);
        }
    }
}

/* Draws an axis of the box, the thinner its side the more often. */
static int across(dmg_builder* b, const dmg_bounds* box) {
    dmg_vec size = v3_sub(box->high, box->low);
    float least = 0.05f * v3_length(size) + 1e-6f;
    float weights[] = {1.0f / fmaxf(size.x, least), 1.0f / fmaxf(size.y, least), 1.0f / fmaxf(size.z, least)};
    return dmg_weighted(b, weights, 3);
}

/* Which changes are made to an object's parts. */
typedef struct habits {
    bool swells, sinks, backs, frames;
} habits;

static void fit_part(dmg_builder* b, uint32_t part, const dmg_bounds* box, const dmg_bounds* body, const habits* how) {
    float size = diagonal(box);
    if (how->swells) swell(b, part, size * dmg_scale_range(b, 0.001f, 0.03f));
    int axis = across(b, box);
    if (how->sinks) {
        float by = size * dmg_scale_range(b, 0.002f, 0.04f);
        by *= body_side(b, box, body, axis);
        shift_part(b, part, with(v3(0, 0, 0), axis, by));
    }
    dmg_use(b, 0);
    if (how->backs && dmg_chance(b, 0.7f)) back(b, part, body, axis);
    if (how->frames && dmg_chance(b, 0.7f)) frame(b, part, body, axis);
}

void dmg_augment_fit(dmg_builder* b) {
    if (!dmg_chance(b, 0.6f)) return;
    habits how;
    how.swells = dmg_chance(b, 0.5f);
    how.sinks = dmg_chance(b, 0.4f);
    how.backs = dmg_chance(b, 0.5f);
    how.frames = dmg_chance(b, 0.4f);
    float share = dmg_chance(b, 0.5f) ? 1.0f : 0.5f;
    dmg_bounds body = dmg_part_bounds(b, 0);
    if (body.low.x > body.high.x) return;
    for (uint32_t part = 1; part <= b->part_count; ++part) {
        dmg_bounds box = dmg_part_bounds(b, part);
        if (box.low.x <= box.high.x && dmg_chance(b, share)) fit_part(b, part, &box, &body, &how);
    }
    dmg_use(b, 0);
}
