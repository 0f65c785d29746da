/* Draws hydrants with caps, operating nuts and hose reels; boxes of meters, fuses and breakers with doors in doors,
 * knife switches and isolators. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* ---- a hydrant ---- */

/* Draws a nut of five sides or a wheel's square on z = 0, as caps and spindles have them. */
static void draw_nut(dmg_builder* b, float r, float high) {
    dmg_xy outline[5];
    for (int i = 0; i < 5; ++i) {
        float angle = 2 * DMG_PI * (float)i / 5.0f;
        outline[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, outline, 5, 0, high);
}

/* Draws an outlet from z = 0 along +Z, its cap screwed on; a chain hangs from the body. */
static void draw_outlet(dmg_builder* b, float r, float out) {
    int grip = dmg_int(b, 0, 2);
    bool flap = dmg_chance(b, 0.15f), chain = dmg_chance(b, 0.4f);
    float cap = r * dmg_range(b, 0.5f, 0.9f), t = 0.12f * r;
    dmg_rod(b, v3(0, 0, -0.3f * r), v3(0, 0, out), 0.85f * r);
    for (int i = 0; i < 5 && chain; ++i) {
        float angle = 0.25f * DMG_PI * (float)i - DMG_PI;
        dmg_torus(b, v3(1.3f * r, -0.6f * r + 0.6f * r * sinf(angle), 0.1f * out + 0.2f * out * (1.0f - cosf(angle))),
                  i % 2 ? v3(1, 0, 0) : v3(0, 0, 1), 0.16f * r, 0.05f * r);
    }
    if (flap) { /* hung over the mouth */
        dmg_box_span(b, v3(-0.3f * r, 0.95f * r, out - 0.3f * r), v3(0.3f * r, 1.25f * r, out));
        dmg_hinge(b, 0, "cap", v3(0, 1.15f * r, out + 0.5f * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.4f, 2.4f));
        dmg_box_span(b, v3(-0.25f * r, 0.5f * r, out + 0.1f * t), v3(0.25f * r, 1.25f * r, out + t));
    } else {
        dmg_screw(b, 0, "cap", v3(0, 0, out), v3(0, 0, 1), 0.03f * r, 0.0f, 25.0f);
        for (int i = 0; i < 2 && grip == 2; ++i)
            dmg_box(b, v3(i ? 1.05f * r : -1.05f * r, 0, out + 0.5f * cap), v3(0.4f * r, 0.25f * r, 0.3f * cap));
    }
    const dmg_xy profile[] = {
        {0, out + 0.02f * r}, {r, out + 0.02f * r}, {r, out + 0.8f * cap}, {0.7f * r, out + cap}, {0, out + cap}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 5);
    dmg_move(b, 0, 0, out + cap);
    if (grip == 0) draw_nut(b, 0.35f * r, 0.45f * r);
    if (grip == 1) dmg_box(b, v3(0, 0, 0.2f * r), v3(1.5f * r, 0.22f * r, 0.4f * r));
    dmg_use(b, 0);
}

static void draw_outlet_at(dmg_builder* b, float y, float turn, float from, float r, float out) {
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 1, 0), turn);
    dmg_move(b, 0, 0, from);
    draw_outlet(b, r, out);
    dmg_restore(b);
}

/* Draws a barrel with a bonnet, the spindle's nut on top, two hose outlets and a pumper's. */
static void draw_barrel(dmg_builder* b) {
    float high = dmg_range(b, 0.5f, 0.95f), r = high * dmg_range(b, 0.12f, 0.19f),
          y = high * dmg_range(b, 0.62f, 0.75f), out = r * dmg_range(b, 0.3f, 0.7f),
          hose = r * dmg_range(b, 0.38f, 0.5f), dome = r * dmg_range(b, 0.4f, 1.1f);
    int top = dmg_int(b, 0, 2), kind = dmg_int(b, 0, 2);
    const dmg_xy body[] = {{0, 0},
                           {1.5f * r, 0},
                           {1.5f * r, 0.12f * r},
                           {r, 0.14f * r},
                           {0.95f * r, high - 0.25f * r},
                           {1.25f * r, high - 0.25f * r},
                           {1.25f * r, high - 0.02f * r},
                           {r, high},
                           {0.8f * r, high + 0.6f * dome},
                           {0.35f * r, high + dome},
                           {0, high + dome}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 11);
    draw_outlet_at(b, y, 0.5f * DMG_PI, 0.85f * r, hose, out);
    if (kind < 2) draw_outlet_at(b, y, -0.5f * DMG_PI, 0.85f * r, hose, out);
    if (kind > 0) draw_outlet_at(b, y - 0.2f * r, 0, 0.8f * r, 1.4f * hose, out);
    int bolts = dmg_int(b, 0, 8);
    for (int i = 0; i < bolts; ++i) {
        float a = 2 * DMG_PI * (float)i / (float)bolts;
        dmg_rod(b, v3(1.12f * r * cosf(a), high - 0.35f * r, 1.12f * r * sinf(a)),
                v3(1.12f * r * cosf(a), high + 0.05f * r, 1.12f * r * sinf(a)), 0.08f * r);
    }
    dmg_move(b, 0, high + dome + 0.002f, 0);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (top == 2) {
        dmg_handwheel_place(b, 0, "valve_wheel", v3(0, 0, 0), 0, 0.9f * r);
        return;
    }
    dmg_spin(b, 0, "operating_nut", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    if (top == 1) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * r), 0.4f * r);
    draw_nut(b, 0.24f * r, 0.5f * r);
}

/* Pillars with valves of their own: a post, arms with wheels, outlets looking down. */
static void draw_pillar(dmg_builder* b) {
    float high = dmg_range(b, 0.7f, 1.3f), r = high * dmg_range(b, 0.05f, 0.1f), reach = r * dmg_range(b, 2.0f, 3.5f);
    int arms = dmg_int(b, 1, 3);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.04f * high, 0), 2.2f * r);
    dmg_rod(b, v3(0, 0.04f * high, 0), v3(0, high, 0), r);
    dmg_dome(b, v3(0, high, 0), v3(r, 0.7f * r, r));
    for (int i = 0; i < arms; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, arms);
        dmg_move(b, 0, high * dmg_range(b, 0.6f, 0.85f), 0);
        dmg_rod(b, v3(0, 0, 0.7f * r), v3(0, 0, reach), 0.6f * r);
        dmg_ellipsoid(b, v3(0, 0, 0.75f * reach), v3(r, r, r));
        dmg_save(b);
        dmg_move(b, 0, 0.9f * r, 0.75f * reach);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_handwheel_place(b, 0, "valve_wheel", v3(0, 0, 0), 0, 1.3f * r);
        dmg_restore(b);
        dmg_turn(b, v3(1, 0, 0), dmg_chance(b, 0.5f) ? 0.6f : 0.0f);
        dmg_move(b, 0, 0, 0.95f * reach);
        draw_outlet(b, 0.8f * r, 0.5f * r);
        dmg_restore(b);
    }
}

/* Draws a cabinet on the wall, its reel on an arm that swings out, a valve beside it. */
static void draw_hose_cabinet(dmg_builder* b) {
    float wide = dmg_range(b, 0.55f, 0.9f), high = wide * dmg_range(b, 0.9f, 1.3f), deep = dmg_range(b, 0.2f, 0.35f),
          t = 0.02f, r = 0.38f * wide, w = 0.5f * deep;
    bool swings = dmg_chance(b, 0.6f);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.15f);
    leaf.width = wide;
    leaf.height = high;
    leaf.side = DMG_SIDE_LEFT;
    dmg_move(b, 0, 0.5f * high + dmg_range(b, 0.0f, 1.0f), 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, wide, high, deep, t);
    dmg_save(b);
    dmg_move(b, 0, 0, leaf.thickness + 0.002f);
    if (dmg_chance(b, 0.8f)) dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
    float z = -0.5f * deep, x = -0.5f * wide + 2 * t;
    uint32_t arm = 0;
    if (swings) {
        arm = dmg_hinge(b, 0, "reel_arm", v3(x, 0, -0.1f * deep), v3(0, -1, 0), 0.0f, dmg_range(b, 1.3f, 1.6f));
        dmg_rod(b, v3(x, -0.46f * high, -0.1f * deep), v3(x, 0.46f * high, -0.1f * deep), 0.5f * t);
        dmg_box_span(b, v3(x, -t, -0.12f * deep), v3(0.02f * wide, t, -0.08f * deep));
    }
    dmg_spin(b, arm, "reel", v3(0.01f * wide, 0, z), v3(0, 0, dmg_sign(b)));
    dmg_rod(b, v3(0.01f * wide, 0, swings ? z - 0.4f * w : -deep + t), v3(0.01f * wide, 0, -0.13f * deep), 0.06f * r);
    const dmg_xy profile[] = {{0, -0.5f * w},        {r, -0.5f * w}, {r, -0.42f * w}, {0.8f * r, -0.42f * w},
                              {0.8f * r, 0.42f * w}, {r, 0.42f * w}, {r, 0.5f * w},   {0, 0.5f * w}};
    dmg_lathe(b, v3(0.01f * wide, 0, z), v3(0, 0, 1), profile, 8);
    dmg_use(b, 0);
    dmg_move(b, 0.36f * wide, -0.36f * high, -deep + t);
    dmg_rod(b, v3(0, -0.1f * high, 0.15f * deep), v3(0, 0.03f * high, 0.15f * deep), 0.02f);
    dmg_handwheel_place(b, 0, "valve_wheel", v3(0, 0, 0.16f * deep), 0, 0.05f);
}

void dmg_build_hydrant(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 1.2f, 1.6f}, 3);
    if (design == 0) draw_barrel(b);
    if (design == 1) draw_pillar(b);
    if (design == 2) draw_hose_cabinet(b);
}

/* ---- boxes of meters, fuses and breakers: the opening is centred, its front at z = 0 ---- */

typedef struct meter_case {
    float wide, high, deep;
} meter_case;

/* Breakers in rows, each a toggle that tips or slides in its block. */
static void draw_breakers(dmg_builder* b, const meter_case* c) {
    int rows = dmg_int(b, 1, 4), columns = dmg_int(b, 3, 10);
    float w = 0.78f * c->wide / (float)columns, h = fminf(0.6f * c->high / (float)rows, 4.5f * w), z = -0.45f * c->deep,
          pitch = 0.84f * c->high / (float)rows, lever = fminf(0.3f * c->deep, 0.3f * h);
    bool across = dmg_chance(b, 0.3f);
    for (int i = 0; i < rows * columns; ++i) {
        float x = w * ((float)(i % columns) - 0.5f * (float)(columns - 1)),
              y = pitch * ((float)(i / columns) - 0.5f * (float)(rows - 1)), tilt = dmg_chance(b, 0.85f) ? -0.4f : 0.4f;
        dmg_box_span(b, v3(x - 0.47f * w, y - 0.5f * h, -0.9f * c->deep), v3(x + 0.47f * w, y + 0.5f * h, z));
        uint32_t toggle = dmg_hinge(b, 0, "breaker", v3(x, y, z), across ? v3(0, 1, 0) : v3(1, 0, 0), -0.45f, 0.45f);
        dmg_rest(b, toggle, tilt);
        dmg_box(b, v3(x, y, z + 0.5f * lever),
                across ? v3(0.25f * w, 0.16f * h, lever) : v3(0.5f * w, 0.12f * h, lever));
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.5f)) return; /* the cover between them */
    dmg_box_span(b, v3(-0.46f * c->wide, 0.44f * c->high, z - 0.05f * c->deep),
                 v3(0.46f * c->wide, 0.48f * c->high, z + 0.02f * c->deep));
    dmg_box_span(b, v3(-0.46f * c->wide, -0.48f * c->high, z - 0.05f * c->deep),
                 v3(0.46f * c->wide, -0.44f * c->high, z + 0.02f * c->deep));
}

/* Blades on a common bar that drop out of their clips. */
static void draw_knife_switch(dmg_builder* b, const meter_case* c) {
    int poles = dmg_int(b, 1, 4), each = dmg_int(b, 1, 2);
    float z = -0.85f * c->deep, reach = 0.34f * c->high / (float)each, t = 0.02f * c->wide,
          pitch = 0.6f * c->wide / (float)poles, rise = 0.16f * c->deep, swing = dmg_range(b, 0.8f, 1.3f),
          rest = dmg_chance(b, 0.5f) ? swing : 0.0f;
    dmg_box_span(b, v3(-0.42f * c->wide, -0.46f * c->high, -0.97f * c->deep), v3(0.42f * c->wide, 0.46f * c->high, z));
    for (int k = 0; k < each; ++k) {
        float y0 = each == 1 ? -0.25f * c->high : (k ? 0.05f : -0.42f) * c->high, out = z + rise;
        for (int i = 0; i < poles; ++i)
            for (int s = -1; s <= 1; s += 2) {
                float x = pitch * ((float)i - 0.5f * (float)(poles - 1)) + 1.2f * t * (float)s;
                dmg_box_span(b, v3(x - 0.4f * t, y0 - t, z), v3(x + 0.4f * t, y0 + t, out + 0.8f * t));
                dmg_box_span(b, v3(x - 0.4f * t, y0 + reach - t, z), v3(x + 0.4f * t, y0 + reach + t, out + t));
            }
        uint32_t knife = dmg_hinge(b, 0, "knife", v3(0, y0, out), v3(1, 0, 0), 0.0f, swing);
        dmg_rest(b, knife, rest);
        for (int i = 0; i < poles; ++i) {
            float x = pitch * ((float)i - 0.5f * (float)(poles - 1));
            dmg_box_span(b, v3(x - 0.5f * t, y0 - 0.8f * t, out - 0.8f * t),
                         v3(x + 0.5f * t, y0 + 1.12f * reach, out + 0.8f * t));
        }
        float bar = 0.5f * pitch * (float)(poles - 1) + 2 * t, y = y0 + 1.12f * reach + t;
        dmg_box_span(b, v3(-bar, y - t, out - t), v3(bar, y + t, out + t));
        dmg_rod(b, v3(0, y, out + 0.5f * t), v3(0, y + 0.5f * t, out + 0.25f * c->deep + t), 1.1f * t);
        dmg_use(b, 0);
    }
}

/* Draws a meter: dials with hands, or a disc that turns behind a window. */
static void draw_meter(dmg_builder* b, const meter_case* c) {
    float r = 0.3f * fminf(c->wide, c->high), z = -0.9f * c->deep, front = -0.35f * c->deep;
    int dials = dmg_int(b, 2, 5);
    dmg_save(b);
    dmg_move(b, 0, 0.12f * c->high, 0);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, z), v3(0, 0, front), r);
    else
        dmg_rounded_box(b, v3(0, 0, 0.5f * (z + front)), v3(2 * r, 2.2f * r, front - z), 0.15f * r);
    for (int i = 0; i < dials; ++i) {
        float each = 1.3f * r / (float)dials, x = each * ((float)i - 0.5f * (float)(dials - 1));
        dmg_rod(b, v3(x, 0.25f * r, front - 0.01f * r), v3(x, 0.25f * r, front + 0.04f * r), 0.44f * each);
        dmg_spin(b, 0, "dial_hand", v3(x, 0.25f * r, front), v3(0, 0, i % 2 ? 1.0f : -1.0f));
        dmg_box_span(b, v3(x - 0.04f * each, 0.25f * r - 0.1f * each, front + 0.045f * r),
                     v3(x + 0.04f * each, 0.25f * r + 0.38f * each, front + 0.07f * r));
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-0.6f * r, -0.55f * r, front - 0.01f * r), v3(0.6f * r, -0.3f * r, front + 0.05f * r));
    dmg_spin(b, 0, "meter_disc", v3(0, -0.45f * r, front), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.46f * r, front + 0.02f * r), v3(0, -0.42f * r, front + 0.02f * r), 0.4f * r);
    dmg_use(b, 0);
    dmg_restore(b);
    for (int i = 0; i < 3; ++i) { /* fuses pulled from their holders */
        float w = 0.2f * c->wide, x = 1.3f * w * ((float)i - 1.0f), y = -0.35f * c->high;
        dmg_box_span(b, v3(x - 0.5f * w, y - 0.08f * c->high, z),
                     v3(x + 0.5f * w, y + 0.08f * c->high, -0.6f * c->deep));
        dmg_slide(b, 0, "fuse", v3(0, 0, 1), 0.0f, 0.4f * c->deep);
        dmg_box_span(b, v3(x - 0.35f * w, y - 0.05f * c->high, -0.598f * c->deep),
                     v3(x + 0.35f * w, y + 0.05f * c->high, -0.35f * c->deep));
        dmg_use(b, 0);
    }
}

/* Draws what is on the door: an isolator's handle, a window flap, a lock's lever, or a hasp that folds over a staple.
 */
static void draw_door_fittings(dmg_builder* b, const meter_case* c, uint32_t door, float side, float z) {
    int kind = dmg_int(b, 0, 3);
    float unit = 0.1f * fminf(c->wide, c->high), turn = dmg_chance(b, 0.5f) ? 1.57f : 0.8f;
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_use(b, door);
    if (kind == 0) {
        dmg_rounded_box(b, v3(0, 0, 0), v3(2.4f * unit, 2.4f * unit, 0.5f * unit), 0.2f * unit);
        dmg_hinge(b, door, "isolator", v3(0, 0, 0.25f * unit), v3(0, 0, -1), 0.0f, turn);
        dmg_rod(b, v3(0, 0, 0.26f * unit), v3(0, 0, 0.6f * unit), 0.9f * unit);
        dmg_box(b, v3(0, 0.2f * unit, 0.8f * unit), v3(0.5f * unit, 2.2f * unit, 0.8f * unit));
    } else if (kind == 1) { /* a smaller door in the door, over what is read */
        dmg_leaf flap = dmg_leaf_pick(b, unit);
        flap.width = 0.5f * c->wide;
        flap.height = 0.3f * c->high;
        flap.side = (dmg_side)dmg_int(b, 0, 2);
        dmg_move(b, 0, 0.15f * c->high, flap.thickness + 0.001f);
        dmg_leaf_draw(b, door, "inner_door", &flap);
    } else if (kind == 2) {
        dmg_move(b, side * 0.4f * c->wide, 0, 0);
        dmg_hinge(b, door, "lock_lever", v3(0, 0, 0), v3(0, 0, side), 0.0f, 1.57f);
        dmg_rod(b, v3(0, 0, 0.002f), v3(0, 0, 0.4f * unit), 0.4f * unit);
        dmg_box(b, v3(0, -0.6f * unit, 0.45f * unit), v3(0.5f * unit, 1.8f * unit, 0.3f * unit));
    } else { /* the hasp reaches over the edge to the body's staple */
        float x = side * 0.5f * c->wide;
        dmg_hinge(b, door, "hasp", v3(x - side * 1.2f * unit, 0, 0.1f * unit), v3(0, -side, 0), 0.0f, 2.6f);
        dmg_box(b, v3(x - side * 0.3f * unit, 0, 0.1f * unit), v3(1.8f * unit, 0.7f * unit, 0.1f * unit));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Cables come in through glands whose nuts turn. */
static void draw_glands(dmg_builder* b, const meter_case* c) {
    int count = dmg_int(b, 1, 5);
    float r = fminf(0.06f * c->wide, 0.2f * c->deep), pitch = 0.8f * c->wide / (float)count;
    bool nuts = dmg_chance(b, 0.6f);
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), y = -0.5f * c->high, z = -0.5f * c->deep;
        dmg_rod(b, v3(x, y + 0.1f * r, z), v3(x, y - 4 * r, z), 0.5f * r);
        if (nuts) dmg_screw(b, 0, "gland_nut", v3(x, y, z), v3(0, -1, 0), 0.04f * r, 0.0f, 12.0f);
        dmg_save(b);
        dmg_move(b, x, y - 0.02f * r, z);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        draw_nut(b, r, 1.3f * r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_meter_box(dmg_builder* b) {
    meter_case c = {.wide = dmg_scale_range(b, 0.18f, 0.7f)};
    c.high = c.wide * dmg_range(b, 0.9f, 1.9f);
    c.deep = c.wide * dmg_range(b, 0.25f, 0.55f);
    int inside = dmg_weighted(b, (const float[]){2, 1.2f, 1.3f}, 3), doors = dmg_chance(b, 0.25f) ? 2 : 1;
    float wall = 0.03f * c.wide, foot = dmg_chance(b, 0.6f) ? 5.0f * fminf(0.06f * c.wide, 0.2f * c.deep) : c.high;
    bool crank = dmg_chance(b, 0.35f), post = foot >= c.high && dmg_chance(b, 0.7f), bare = dmg_chance(b, 0.12f),
         left = dmg_chance(b, 0.6f);
    dmg_move(b, 0, foot + 0.5f * c.high, 0);
    if (post)
        dmg_box_span(b, v3(-0.2f * c.wide, -0.5f * c.high - foot, -0.8f * c.deep),
                     v3(0.2f * c.wide, -0.5f * c.high, -0.3f * c.deep));
    dmg_case_draw(b, DMG_CASE_BOARDS, c.wide, c.high, c.deep, wall);
    if (inside == 0) draw_breakers(b, &c);
    if (inside == 1) draw_knife_switch(b, &c);
    if (inside == 2) draw_meter(b, &c);
    if (!post && dmg_chance(b, 0.7f)) draw_glands(b, &c);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.25f * c.wide);
    leaf.width = c.wide / (float)doors - 0.004f;
    leaf.height = c.high;
    leaf.thickness = fminf(leaf.thickness, 0.06f * c.wide);
    for (int i = 0; i < doors && !bare; ++i) {
        bool hung_left = doors == 2 ? i == 0 : left;
        leaf.side = hung_left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, doors == 2 ? (i ? 0.25f : -0.25f) * c.wide : 0.0f, 0, leaf.thickness + 0.002f);
        if (doors == 1) leaf.handle.kind = DMG_HANDLE_NONE;
        uint32_t door = dmg_leaf_draw(b, 0, "door", &leaf);
        if (doors == 1) draw_door_fittings(b, &c, door, hung_left ? 1.0f : -1.0f, 0.0f);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    if (crank)
        dmg_machine_lever_place(b, 0, "side_lever", v3(0.5f * c.wide, 0, -0.5f * c.deep), 0.5f * DMG_PI, 0.4f * c.wide);
}
