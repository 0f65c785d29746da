/* Draws freight containers with doors, locking bars and cooling machines, waste containers with rams and flaps,
 * stillages with drop sides. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

typedef struct freight {
    float wide, high, deep, wall; /* the opening is at z = 0, its middle at x = 0, the floor at y = 0 */
} freight;

/* ---- doors with locking bars ---- */

/* Draws an upright bar on z = 0 that turns in brackets, its handle one with it or lifted on a pin of its own. */
static void draw_lock_bar(dmg_builder* b, uint32_t door, float high, float reach, float handle, float side, int habit) {
    float r = 0.008f * high, z = 2.6f * r, turn = 1.57f;
    for (int i = 0; i < 3; ++i) {
        float y = high * (0.38f * (float)i - 0.38f);
        dmg_use(b, door);
        dmg_box_span(b, v3(-2.2f * r, y - 1.5f * r, -0.5f * r), v3(-1.05f * r, y + 1.5f * r, z + r));
        dmg_box_span(b, v3(1.05f * r, y - 1.5f * r, -0.5f * r), v3(2.2f * r, y + 1.5f * r, z + r));
    }
    uint32_t bar = dmg_hinge(b, door, "lock_bar", v3(0, 0, z), v3(0, -side, 0), 0.0f, turn);
    dmg_rod(b, v3(0, -0.5f * high, z), v3(0, 0.5f * high, z), r);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0, (float)s * 0.505f * high, z), v3(3.2f * r, 0.025f * high, 2.6f * r));
    float y = handle * high;
    if (habit == 1) { /* lifted out of its catch before it turns the bar */
        dmg_box(b, v3(0, y, z + 1.4f * r), v3(2.4f * r, 3 * r, 1.6f * r));
        dmg_hinge(b, bar, "bar_handle", v3(0, y, z + 2.4f * r), v3(0, 0, side), 0.0f, 0.6f);
    }
    float out = z + (habit == 1 ? 2.9f : 0.3f) * r;
    dmg_box_span(b, v3(fminf(0, side * reach), y - 1.2f * r, out - 0.6f * r),
                 v3(fmaxf(0, side * reach), y + 1.2f * r, out + 0.6f * r));
    dmg_use(b, door);
    if (habit < 2) { /* a flap over the handle's end */
        float x = side * 0.85f * reach, top = y + 3 * r;
        dmg_box_span(b, v3(x - 3 * r, top, 0), v3(x + 3 * r, top + 3 * r, out + r));
        dmg_hinge(b, door, "catch", v3(x, top, out + 2 * r), v3(-1, 0, 0), 0.0f, 1.8f);
        dmg_box_span(b, v3(x - 2 * r, top - 4.5f * r, out + 1.2f * r), v3(x + 2 * r, top + 1.5f * r, out + 2 * r));
        dmg_use(b, door);
    }
}

/* Draws one leaf of the pair, hung at its -X edge on the corner post. */
static void draw_freight_door(dmg_builder* b, const freight* f, const dmg_panel* panel, int bars, int habit,
                              float swing) {
    float w = 0.5f * f->wide, t = 0.06f, handle = -0.12f, reach = 0.55f * w / (float)bars;
    uint32_t door = dmg_hinge(b, 0, "door", v3(-w, 0, 0.01f), v3(0, -1, 0), 0.0f, swing);
    dmg_save(b);
    dmg_move(b, -0.5f * w, 0.5f * f->high, 0);
    dmg_panel_draw(b, panel, w - 0.012f, f->high - 0.03f, t);
    for (int i = 0; i < 4; ++i) {
        float y = f->high * (0.28f * (float)i - 0.42f);
        dmg_box(b, v3(-0.42f * w, y, 0.006f), v3(0.14f * w, 0.05f, 0.012f));
    }
    for (int i = 0; i < bars; ++i) {
        dmg_save(b);
        dmg_move(b, bars == 1 ? 0.1f * w : (i ? 0.32f : -0.2f) * w, 0, 0);
        draw_lock_bar(b, door, f->high * 0.97f, reach, handle, -1.0f, habit);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Walls with ribs, corner castings, the frame about the doors. */
static void draw_shell(dmg_builder* b, const freight* f) {
    int ribs = dmg_int(b, 0, 14);
    float x = 0.5f * f->wide + f->wall, cast = dmg_range(b, 0.12f, 0.2f);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * f->high, -0.065f);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * x, f->high + 2 * f->wall, f->deep, f->wall);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) {
        for (int i = 0; i < ribs; ++i) {
            float z = -0.1f - (f->deep - 0.3f) * ((float)i + 0.5f) / (float)ribs;
            dmg_box(b, v3((float)s * (x + 0.012f), 0.5f * f->high, z),
                    v3(0.03f, 0.9f * f->high, 0.35f * f->deep / (float)ribs));
        }
        for (int i = 0; i < 4; ++i) {
            float y = i & 1 ? f->high : 0.0f, z = i & 2 ? -f->deep : -0.065f - 0.5f * cast;
            dmg_box(b, v3((float)s * (x - 0.4f * cast), y + (i & 1 ? 0.5f : -0.5f) * (f->wall + 0.01f), z),
                    v3(cast, f->wall + 0.03f, cast));
        }
    }
}

/* Doors along the side: pairs of leaves, the second hinged on the first. */
static void draw_side_doors(dmg_builder* b, const freight* f) {
    int pairs = dmg_int(b, 1, 2), each = dmg_int(b, 1, 2);
    float x = 0.5f * f->wide + f->wall + 0.03f, span = fminf(0.86f * f->deep, 1.3f * (float)(pairs * each)),
          w = span / (float)(pairs * each), t = 0.04f, swing = dmg_range(b, 1.4f, 2.8f);
    dmg_panel panel = dmg_panel_pick(b);
    dmg_save(b);
    dmg_move(b, x + t, 0.5f * f->high, -0.5f * f->deep);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    for (int i = 0; i < pairs; ++i) {
        uint32_t door = 0;
        dmg_save(b);
        if (i) dmg_mirror(b, v3(1, 0, 0));
        for (int k = 0; k < each; ++k) {
            float at = -0.5f * span + w * (float)k;
            door = dmg_hinge(b, door, "side_door", v3(at, 0, 0), v3(0, -1, 0), 0.0f, k ? 2.6f : swing);
            dmg_save(b);
            dmg_move(b, at + 0.5f * w, 0, 0);
            dmg_panel_draw(b, &panel, w - 0.01f, 0.92f * f->high, t);
            dmg_restore(b);
        }
        if (dmg_chance(b, 0.7f)) {
            dmg_move(b, -0.5f * span + w * ((float)each - 0.3f), 0, 0);
            draw_lock_bar(b, door, 0.88f * f->high, 0.35f * w, -0.1f, -1.0f, dmg_int(b, 0, 2));
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Draws the cold end: fans behind grilles, a fresh-air disc, panels on screws or hinges, a drawer of controls. */
static void draw_cold_machine(dmg_builder* b, const freight* f) {
    float w = f->wide, h = f->high, r = 0.16f * w, t = 0.03f;
    int fans = dmg_int(b, 1, 2);
    dmg_box_span(b, v3(-0.5f * w, 0, -0.4f), v3(0.5f * w, h, -0.06f));
    for (int i = 0; i < fans; ++i) {
        float x = fans == 1 ? 0.15f * w : (i ? 0.25f : -0.25f) * w;
        dmg_save(b);
        dmg_move(b, x, 0.32f * h, -0.02f);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.06f * r, 0.05f * r);
        dmg_rod(b, v3(0, 0, -0.05f), v3(0, 0, -0.02f), 0.2f * r);
        dmg_spin(b, 0, "fan", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
        dmg_blades_draw(b, 0, 0.95f * r, 0.25f * r, 0.3f * r, 5, 0.4f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, -0.3f * w, 0.72f * h, -0.06f);
    dmg_rod(b, v3(0, 0, -0.01f), v3(0, 0, 0.02f), 0.5f * r);
    dmg_hinge(b, 0, "air_disc", v3(0, 0, 0), v3(0, 0, 1), 0.0f, 3.1f);
    dmg_rod(b, v3(0, 0, 0.022f), v3(0, 0, 0.035f), 0.48f * r);
    dmg_box(b, v3(0, 0.1f * r, 0.05f), v3(0.12f * r, 0.7f * r, 0.04f));
    dmg_restore(b);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.15f);
    leaf.width = 0.3f * w;
    leaf.height = 0.25f * h;
    leaf.thickness = t;
    for (int i = 0; i < 2; ++i) {
        leaf.side = (dmg_side)dmg_int(b, 0, 3);
        dmg_save(b);
        dmg_move(b, (i ? 0.32f : 0.0f) * w, 0.73f * h, -0.06f + t + 0.002f);
        dmg_leaf_draw(b, 0, "service_panel", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

static void draw_box_container(dmg_builder* b) {
    freight f = {.wide = dmg_range(b, 2.0f, 2.5f)};
    f.wall = dmg_range(b, 0.04f, 0.1f);
    f.high = dmg_range(b, 2.0f, 2.8f);
    f.deep = dmg_scale_range(b, 1.6f, 9.0f);
    int bars = dmg_int(b, 1, 2), habit = dmg_int(b, 0, 2);
    float swing = dmg_chance(b, 0.4f) ? dmg_range(b, 3.0f, 4.5f) : dmg_range(b, 1.5f, 2.4f);
    bool cold = dmg_chance(b, 0.3f), sides = dmg_chance(b, 0.35f), swapped = dmg_chance(b, 0.5f);
    dmg_panel panel = dmg_panel_pick(b);
    if (panel.kind == DMG_PANEL_HOLLOW || panel.kind == DMG_PANEL_WINDOW) panel.kind = DMG_PANEL_FRAMED;
    if (cold && swapped) dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_move(b, 0, f.wall + 0.02f, 0);
    draw_shell(b, &f);
    for (int s = 0; s < 2; ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        draw_freight_door(b, &f, &panel, bars, habit, swing);
        dmg_restore(b);
    }
    if (sides) draw_side_doors(b, &f);
    if (!cold) return;
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_move(b, 0, 0, f.deep + 0.13f);
    draw_cold_machine(b, &f);
}

/* ---- waste ---- */

/* Draws a press: a hopper with a flap, a ram that goes to and fro on its floor, a gate behind clamps at the far end. */
static void draw_compactor(dmg_builder* b) {
    float wide = dmg_range(b, 1.2f, 2.2f), high = wide * dmg_range(b, 0.7f, 1.1f),
          deep = wide * dmg_range(b, 1.5f, 3.0f), t = 0.05f, hop = 0.4f * deep, low = 0.5f * high, foot = 0.12f,
          swing = dmg_range(b, 1.0f, 1.6f);
    bool top = dmg_chance(b, 0.5f), two = dmg_chance(b, 0.5f);
    float x = 0.5f * wide, way = 0.8f * hop;
    dmg_move(b, 0, foot, 0);
    for (int i = 0; i < 4; ++i)
        dmg_box(b, v3((i & 1 ? 0.4f : -0.4f) * wide, -0.5f * foot, (i & 2 ? -0.1f : -0.9f) * deep),
                v3(0.1f, foot, 0.25f));
    dmg_box_span(b, v3(-x, 0, -deep), v3(x, t, 0));
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s * (x - 0.5f * t);
        dmg_box_span(b, v3(side - 0.5f * t, t, -deep), v3(side + 0.5f * t, high, -hop));
        dmg_box_span(b, v3(side - 0.5f * t, t, -hop), v3(side + 0.5f * t, low + 0.4f * high, 0));
    }
    dmg_box_span(b, v3(-x + t, high - t, -deep), v3(x - t, high, -hop));
    dmg_box_span(b, v3(-x + t, t, -t), v3(x - t, low + 0.15f * high, 0));
    dmg_slide(b, 0, "ram", v3(0, 0, -1), 0.0f, way); /* pushes what fell before it into the box */
    dmg_box_span(b, v3(-x + 1.3f * t, 1.2f * t, -0.5f * hop), v3(x - 1.3f * t, 0.8f * low, -0.35f * hop));
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.3f * x, 0.5f * low, -0.36f * hop), v3((float)s * 0.3f * x, 0.5f * low, -1.5f * t),
                0.03f);
    float y = low + 0.4f * high + 0.01f;
    for (int s = two ? -1 : 1; s <= 1; s += 2) { /* over the hopper */
        float w = two ? x : wide;
        dmg_hinge(b, 0, "hopper_flap", two ? v3((float)s * x, y, 0) : v3(0, y, -hop + 0.02f),
                  two ? v3(0, 0, -(float)s) : v3(-1, 0, 0), 0.0f, swing);
        float x0 = two ? (s > 0 ? 0.004f : -w) : -x;
        dmg_box_span(b, v3(x0, y, -hop + 0.03f), v3(x0 + w - 0.004f, y + 0.03f, 0));
        dmg_use(b, 0);
    }
    float back = -deep - 0.005f;
    dmg_hinge(b, 0, "gate", top ? v3(0, high, back) : v3(-x, 0, back), top ? v3(1, 0, 0) : v3(0, 1, 0), 0.0f,
              dmg_range(b, 1.2f, 2.2f));
    dmg_box_span(b, v3(-x, 0, back - t), v3(x, high, back));
    for (int i = 0; i < 3; ++i)
        dmg_box(b, v3((float)(i - 1) * 0.6f * x, 0.5f * high, back - 1.4f * t), v3(0.1f, 0.85f * high, 0.9f * t));
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) { /* clamps beside it */
        if (!top && s < 0) continue;
        float z = -deep + 0.3f, side = (float)s * (x + 0.03f), level = top ? 0.3f * high : 0.5f * high;
        dmg_rod(b, v3((float)s * (x - 0.01f), level, z), v3(side, level, z), 0.05f);
        dmg_hinge(b, 0, "clamp", v3(side, level, z), v3((float)s, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(side, level - 0.03f, z - 0.42f), v3(side + 0.03f * (float)s, level + 0.03f, z + 0.06f));
        dmg_use(b, 0);
    }
}

/* ---- a stillage: posts, a floor, sides of which some drop ---- */

static void draw_stillage(dmg_builder* b) {
    float wide = dmg_range(b, 0.8f, 1.6f), deep = wide * dmg_range(b, 0.7f, 1.1f), high = dmg_range(b, 0.4f, 1.1f),
          p = dmg_range(b, 0.04f, 0.08f), foot = dmg_range(b, 0.08f, 0.16f), swing = dmg_range(b, 1.4f, 2.9f);
    int halves = dmg_int(b, 1, 2), drops = dmg_int(b, 1, 4), latch = dmg_int(b, 0, 2);
    dmg_panel panel = dmg_panel_pick(b);
    if (dmg_chance(b, 0.5f)) panel.kind = DMG_PANEL_BARS;
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * wide, z = (i & 2 ? 0.5f : -0.5f) * deep;
        dmg_box_span(b, v3(x - 0.5f * p, 0, z - 0.5f * p), v3(x + 0.5f * p, foot + high + 0.04f, z + 0.5f * p));
        dmg_box(b, v3(x, 0.01f, z), v3(1.8f * p, 0.02f, 1.8f * p));
    }
    dmg_box_span(b, v3(-0.5f * wide, foot - 0.03f, -0.5f * deep), v3(0.5f * wide, foot, 0.5f * deep));
    for (int i = 0; i < 4; ++i) {
        float span = (i % 2 ? deep : wide) - p - 0.012f, out = 0.5f * (i % 2 ? wide : deep), t = 0.6f * p,
              y = foot + 0.006f;
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 4);
        dmg_move(b, 0, 0, out + 0.5f * t);
        for (int k = 0; k < halves; ++k) {
            float h = (high - 0.01f) / (float)halves, low = y + h * (float)k;
            bool drop = i < drops && (k == halves - 1 || dmg_chance(b, 0.5f));
            uint32_t gate = drop ? dmg_hinge(b, 0, "drop_side", v3(0, low, 0), v3(1, 0, 0), 0.0f, swing) : 0;
            dmg_save(b);
            dmg_move(b, 0, low + 0.5f * h, 0);
            dmg_panel_draw(b, &panel, span, h - 0.01f, t);
            dmg_restore(b);
            for (int s = -1; s <= 1 && drop && latch; s += 2) {
                float x = (float)s * (0.5f * span - 0.1f), top = low + 0.8f * h;
                if (latch == 1) /* bolts that run behind the post */
                    dmg_slide(b, gate, "bolt", v3(-(float)s, 0, 0), 0.0f, 0.08f);
                else
                    dmg_hinge(b, gate, "latch", v3(x, top, 0.012f), v3(0, 0, (float)s), 0.0f, 1.5f);
                dmg_box(b, v3(x + (float)s * 0.07f, top, 0.014f), v3(0.2f, 0.022f, 0.022f));
                if (latch == 1) dmg_rod(b, v3(x, top, 0.02f), v3(x, top, 0.06f), 0.01f);
            }
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
}

void dmg_build_shipping_container(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3.5f, 1, 1.3f}, 3);
    if (design == 0) draw_box_container(b);
    if (design == 1) draw_compactor(b);
    if (design == 2) draw_stillage(b);
}
