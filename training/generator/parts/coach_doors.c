/* Implements doors of buses and rail cars: leaves that fold, slide, step out before they slide, turn about posts or
 * swing on arms, and the ramps at their sills. The sill is at the origin, x goes outwards, z along the wall. */
#include "parts/coach_doors.h"

dmg_doorway dmg_doorway_pick(dmg_builder* b, bool hollow) {
    dmg_doorway d = {.twin = dmg_chance(b, 0.6f), .leaf = dmg_panel_pick_window(b)};
    static const float inside[] = {3, 2, 1, 1.5f, 2, 2, 1.5f};
    d.kind = (dmg_doorway_kind)(hollow ? dmg_weighted(b, inside, 7) : dmg_int(b, 1, 2));
    if (dmg_chance(b, 0.3f)) d.leaf = dmg_panel_pick(b);
    if (d.leaf.kind == DMG_PANEL_BOWED) d.leaf.kind = DMG_PANEL_FRAMED;
    d.end = dmg_sign(b);
    if (hollow && dmg_chance(b, 0.25f)) d.ramp = dmg_int(b, 1, 2);
    return d;
}

/* Between two places of the wall, its outer face at x; a grip upright on one of its faces. */
static void draw_leaf(dmg_builder* b, const dmg_doorway* d, float z0, float z1, float x, float grip) {
    float wide = fabsf(z1 - z0);
    dmg_save(b);
    dmg_move(b, x, 0.5f * d->high, 0.5f * (z0 + z1));
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_panel_draw(b, &d->leaf, 0.985f * wide, 0.985f * d->high, d->t);
    if (grip != 0) {
        float out = grip > 0 ? 1.2f * d->t : -2.2f * d->t, low = -0.1f * d->high, tall = 0.15f * d->high;
        dmg_rod(b, v3(0.3f * wide, low, out), v3(0.3f * wide, tall, out), 0.35f * d->t);
        for (int k = 0; k < 2; ++k) {
            float y = k ? 0.9f * tall : 0.9f * low;
            dmg_rod(b, v3(0.3f * wide, y, grip > 0 ? 0.0f : -d->t), v3(0.3f * wide, y, out), 0.3f * d->t);
        }
    }
    dmg_restore(b);
}

/* Draws a pair from the jamb at z = end / 2 of the width inwards: the first leaf on the jamb, the second on the first.
 */
static void draw_fold(dmg_builder* b, const dmg_doorway* d, float end, float way, float grip) {
    float from = 0.5f * end * d->wide, each = d->wide * (d->twin ? 0.25f : 0.5f), most = dmg_range(b, 1.2f, 1.5f);
    float face = -0.3f * d->wall, outer = face, inner = face - d->t, knee = from - end * each;
    uint32_t first = dmg_hinge(b, 0, "door", v3(way > 0 ? outer : inner, 0, from), v3(0, -end * way, 0), 0.0f, most);
    draw_leaf(b, d, from, knee, face, 0);
    float pin = way > 0 ? inner : outer;
    dmg_hinge(b, first, "door_leaf", v3(pin, 0, knee), v3(0, end * way, 0), 0.0f, 2.0f * most);
    draw_leaf(b, d, knee, knee - end * each, face, grip);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(pin, 0.02f * d->high, knee), v3(pin, 0.96f * d->high, knee), 0.5f * d->t);
    dmg_use(b, 0);
}

/* On the outer or the inner skin, a rail over it. */
static void draw_slide(dmg_builder* b, const dmg_doorway* d, float end, bool pocket, bool rail, float grip) {
    float middle = d->twin ? 0.0f : -0.5f * end * d->wide, jamb = 0.5f * end * d->wide, over = 0.02f * d->wide;
    float leaf = fabsf(jamb - middle), face = pocket ? -d->wall - 0.3f * d->t : 1.3f * d->t, way = 0.93f * leaf;
    if (rail) {
        float far = jamb + end * leaf, y = 0.995f * d->high, x0 = pocket ? -d->wall - 1.5f * d->t : 0.0f,
              x1 = pocket ? -d->wall : 1.6f * d->t;
        dmg_box_span(b, v3(x0, y, fminf(middle, far)), v3(x1, y + d->t, fmaxf(middle, far)));
    }
    dmg_slide(b, 0, "door", v3(0, 0, end), 0.0f, way);
    draw_leaf(b, d, middle, jamb + end * over, face, grip);
    dmg_use(b, 0);
}

/* Swings on its jamb, outwards. */
static void draw_hinged(dmg_builder* b, const dmg_doorway* d, float end, float grip) {
    float jamb = 0.5f * end * d->wide, middle = d->twin ? 0.0f : -jamb, r = 0.4f * d->t;
    dmg_hinge(b, 0, "door", v3(1.1f * d->t, 0, jamb), v3(0, -end, 0), 0.0f, dmg_range(b, 1.1f, 1.8f));
    draw_leaf(b, d, middle, jamb, 1.05f * d->t, grip);
    for (int k = 0; k < 2; ++k) {
        float y = d->high * (k ? 0.8f : 0.15f);
        dmg_rod(b, v3(1.1f * d->t, y, jamb), v3(1.1f * d->t, y + 0.06f * d->high, jamb), r);
    }
    dmg_use(b, 0);
}

/* Draws the carriage, a bar inside over the door, goes out; the leaf hangs on it and goes along. Shown stepped out. */
static void draw_plug(dmg_builder* b, const dmg_doorway* d, float end, float grip) {
    float middle = d->twin ? 0.0f : -0.5f * end * d->wide, jamb = 0.5f * end * d->wide, leaf = fabsf(jamb - middle);
    float out = d->wall + d->t * dmg_range(b, 1.2f, 2.0f), back = -d->wall - out - 3 * d->t, y = 0.95f * d->high;
    uint32_t carriage = dmg_slide(b, 0, "door_carriage", v3(1, 0, 0), 0.0f, out);
    dmg_rest(b, carriage, b->parts[carriage - 1].joint.upper);
    dmg_keep_rest(b, carriage);
    dmg_box_span(b, v3(back, y, fminf(middle, jamb)), v3(back + 2 * d->t, y + 2 * d->t, fmaxf(middle, jamb)));
    uint32_t door = dmg_slide(b, carriage, "door", v3(0, 0, end), 0.0f, 0.95f * leaf);
    dmg_keep_rest(b, door);
    draw_leaf(b, d, middle, jamb, -0.1f * d->wall, grip);
    for (int k = 0; k < 2; ++k) {
        float z = middle + (jamb - middle) * (k ? 0.2f : 0.05f);
        dmg_box_span(b, v3(back + 2 * d->t, y, fminf(z, z + end * d->t)),
                     v3(-0.1f * d->wall - d->t, y + 0.8f * d->t, fmaxf(z, z + end * d->t)));
    }
    dmg_use(b, 0);
}

/* Draws a post from floor to lintel that turns, two arms to the leaf; inwards, or outwards with the leaf turning back.
 */
static void draw_post_leaf(dmg_builder* b, const dmg_doorway* d, float end, bool outward, float grip) {
    float jamb = 0.5f * end * d->wide, middle = d->twin ? 0.0f : -jamb, leaf = fabsf(jamb - middle), r = 0.6f * d->t;
    float x = -d->wall - 1.3f * r, face = -0.2f * d->wall, inset = outward ? face - x + 0.5f * d->t : 1.2f * r;
    dmg_vec post = {x, 0, jamb - end * inset};
    float reach = post.z - end * 0.45f * leaf, most = dmg_range(b, 1.1f, 1.5f), back = face - d->t;
    uint32_t arm = dmg_hinge(b, 0, outward ? "door_arm" : "door", post, v3(0, outward ? -end : end, 0), 0.0f, most);
    dmg_rod(b, v3_add(post, v3(0, 0.01f * d->high, 0)), v3_add(post, v3(0, 0.98f * d->high, 0)), r);
    for (int k = 0; k < 2; ++k) {
        float y = d->high * (k ? 0.85f : 0.12f);
        dmg_beam(b, v3(x, y, post.z), v3(outward ? back - 0.5f * d->t : back, y, reach), d->t, 1.2f * d->t);
    }
    if (outward)
        dmg_hinge(b, arm, "door", v3(back - 0.5f * d->t, 0, reach), v3(0, end, 0), 0.0f,
                  most * dmg_range(b, 0.8f, 1.0f));
    draw_leaf(b, d, middle, jamb, face, grip);
    dmg_use(b, 0);
}

static void draw_ramp(dmg_builder* b, const dmg_doorway* d) {
    float t = 0.6f * d->t, deep = d->wide * dmg_range(b, 0.5f, 0.8f), z = 0.42f * d->wide;
    if (d->ramp == 1) { /* lies on the floor, turns over the sill */
        float x = -d->wall - d->t;
        dmg_hinge(b, 0, "ramp", v3(x, 0.5f * t, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 2.6f, 3.1f));
        dmg_box_span(b, v3(x - deep, 0.1f * t, -z), v3(x - 0.1f * t, t, z));
        dmg_rod(b, v3(x, 0.5f * t, -z), v3(x, 0.5f * t, z), 0.5f * t);
    } else {
        dmg_slide(b, 0, "ramp", v3(1, 0, 0), 0.0f, 0.85f * deep);
        dmg_box_span(b, v3(0.2f * t - deep, -2.5f * t, -z), v3(0.6f * t, -1.5f * t, z));
        dmg_box_span(b, v3(0.6f * t, -3 * t, -z), v3(1.2f * t, -t, z));
    }
    dmg_use(b, 0);
}

void dmg_doorway_draw(dmg_builder* b, const dmg_doorway* d) {
    float grip = (float)dmg_int(b, -1, 1), way = dmg_sign(b), from = d->twin ? -1.0f : d->end,
          to = d->twin ? 1.0f : d->end;
    bool rail = dmg_chance(b, 0.6f);
    if (grip < 0 && d->kind == DMG_DOORWAY_HINGED) grip = 1; /* there may be no inside */
    for (float end = from; end <= to; end += 2) {
        switch (d->kind) {
        case DMG_DOORWAY_FOLD:
            draw_fold(b, d, end, way, grip);
            break;
        case DMG_DOORWAY_SLIDE:
            draw_slide(b, d, end, false, rail, fmaxf(grip, 0));
            break;
        case DMG_DOORWAY_HINGED:
            draw_hinged(b, d, end, grip);
            break;
        case DMG_DOORWAY_POCKET:
            draw_slide(b, d, end, true, rail, fminf(grip, 0));
            break;
        case DMG_DOORWAY_PLUG:
            draw_plug(b, d, end, fmaxf(grip, 0));
            break;
        case DMG_DOORWAY_GLIDER:
            draw_post_leaf(b, d, end, false, grip);
            break;
        case DMG_DOORWAY_SWINGING:
            draw_post_leaf(b, d, end, true, fmaxf(grip, 0));
            break;
        }
    }
    if (d->ramp) draw_ramp(b, d);
}
