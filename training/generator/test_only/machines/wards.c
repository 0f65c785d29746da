/* Draws ward and clean-room equipment: incubators with hoods, port doors, drawers and a tilting bed; isolators with
 * glove ports. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- ports: round doors on z = 0 facing +Z ---- */

static void draw_port(dmg_builder* b, uint32_t parent, float r, bool left, int latch) {
    float t = 0.1f * r, side = left ? 1.0f : -1.0f, pin = side * 1.2f * r;
    dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.06f * r, 0.08f * r);
    dmg_box_span(b, v3(-pin - 0.12f * r, -0.3f * r, -0.05f * r), v3(-pin + 0.12f * r, 0.3f * r, 0.5f * t));
    uint32_t door =
        dmg_hinge(b, parent, "port_door", v3(-pin, 0, 1.6f * t), v3(0, -side, 0), 0.0f, dmg_range(b, 1.5f, 2.8f));
    dmg_rod(b, v3(0, 0, 1.1f * t), v3(0, 0, 2.1f * t), 1.08f * r);
    dmg_rod(b, v3(-pin, -0.25f * r, 1.6f * t), v3(-pin, 0.25f * r, 1.6f * t), 0.07f * r);
    dmg_box_span(b, v3(fminf(-pin, 0), -0.12f * r, 1.5f * t), v3(fmaxf(-pin, 0), 0.12f * r, 2.4f * t));
    if (latch == 1) { /* pressed with the elbow */
        dmg_hinge(b, door, "port_latch", v3(pin * 0.8f, 0, 2.2f * t), v3(0, side, 0), 0.0f, 0.3f);
        dmg_box(b, v3(pin * 0.95f, 0, 2.6f * t), v3(0.5f * r, 0.35f * r, 0.8f * t));
    } else if (latch == 2) {
        dmg_hinge(b, door, "port_latch", v3(pin * 0.75f, 0, 2.2f * t), v3(0, 0, side), 0.0f, 1.57f);
        dmg_rod(b, v3(pin * 0.75f, 0, 2.12f * t), v3(pin * 0.75f, 0, 3.2f * t), 0.1f * r);
        dmg_box(b, v3(pin * 0.85f, 0, 3.2f * t), v3(0.5f * r, 0.14f * r, 0.6f * t));
    }
    dmg_use(b, parent);
}

static void draw_ports(dmg_builder* b, uint32_t parent, int count, float span, float r) {
    int latch = dmg_int(b, 0, 2);
    bool same = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, span * (((float)i + 0.5f) / (float)count - 0.5f), 0, 0);
        draw_port(b, parent, r, same || i % 2 == 0, latch);
        dmg_restore(b);
    }
}

/* ---- what stands below: a cabinet of drawers or a column that rises, on wheels ---- */

static uint32_t draw_ward_base(dmg_builder* b, float wide, float deep, float high) {
    float foot = 0.11f;
    uint32_t deck = 0;
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.42f : -0.42f) * wide, z = (i & 2 ? 0.42f : -0.42f) * deep;
        uint32_t fork = dmg_spin(b, 0, "caster", v3(x, foot, z), v3(0, 1, 0));
        dmg_rod(b, v3(x, 0.8f * foot, z), v3(x, foot + 0.01f, z), 0.02f);
        dmg_box_span(b, v3(x - 0.012f, 0.35f * foot, z + 0.01f), v3(x - 0.004f, 0.8f * foot, z + 0.03f));
        dmg_spin(b, fork, "wheel", v3(x, 0.45f * foot, z + 0.02f), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.004f, 0.45f * foot, z + 0.02f), v3(x + 0.02f, 0.45f * foot, z + 0.02f), 0.45f * foot);
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-0.5f * wide, foot, -0.5f * deep), v3(0.5f * wide, foot + 0.06f, 0.5f * deep));
    if (dmg_chance(b, 0.5f)) {
        float col = 0.12f * wide;
        dmg_box_span(b, v3(-col, foot + 0.06f, -col), v3(col, 0.7f * high, col));
        deck = dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, 0.25f);
        dmg_box_span(b, v3(-0.8f * col, 0.5f * high, -0.8f * col), v3(0.8f * col, high - 0.05f, 0.8f * col));
    } else {
        int drawers = dmg_int(b, 1, 3);
        float h = high - 0.05f - foot - 0.06f, each = h / (float)drawers;
        dmg_save(b);
        dmg_move(b, 0, foot + 0.06f + 0.5f * h, 0.35f * deep);
        dmg_case_draw(b, DMG_CASE_BOARDS, 0.7f * wide, h, 0.7f * deep, 0.02f);
        dmg_drawer drawer = dmg_drawer_pick(b, 0.12f);
        drawer.width = 0.66f * wide;
        drawer.height = 0.92f * each;
        drawer.depth = 0.6f * deep;
        drawer.travel = 0.5f * deep;
        for (int i = 0; i < drawers; ++i) {
            dmg_save(b);
            dmg_move(b, 0, each * ((float)i - 0.5f * (float)(drawers - 1)), drawer.thickness + 0.003f);
            dmg_drawer_draw(b, 0, "drawer", &drawer);
            dmg_restore(b);
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
    dmg_use(b, deck);
    dmg_box_span(b, v3(-0.5f * wide, high - 0.05f, -0.5f * deep), v3(0.5f * wide, high, 0.5f * deep));
    return deck;
}

/* Under the hood: a bed that tips about either of its lines, on a tray that slides out where the front is open. */
static void draw_bed(dmg_builder* b, uint32_t deck, float wide, float deep, float y) {
    bool lengthwise = dmg_chance(b, 0.6f);
    dmg_box(b, v3(0, y + 0.01f, 0), v3(0.2f * wide, 0.02f, 0.5f * deep));
    dmg_hinge(b, deck, "bed", v3(0, y + 0.03f, 0), lengthwise ? v3(0, 0, dmg_sign(b)) : v3(dmg_sign(b), 0, 0), -0.05f,
              0.05f);
    dmg_rounded_box(b, v3(0, y + 0.05f, 0), v3(0.78f * wide, 0.055f, 0.75f * deep), 0.02f);
    dmg_use(b, deck);
}

static void draw_baby_incubator(dmg_builder* b) {
    float wide = dmg_range(b, 0.75f, 1.05f), deep = wide * dmg_range(b, 0.5f, 0.65f), high = dmg_range(b, 0.75f, 1.0f),
          up = dmg_range(b, 0.32f, 0.5f), t = 0.008f, lift = dmg_range(b, 0.7f, 1.3f), port = fminf(0.09f, 0.28f * up);
    int opens = dmg_int(b, 0, 2), ports = dmg_int(b, 1, 3);
    uint32_t deck = draw_ward_base(b, wide, deep, high);
    draw_bed(b, deck, wide, deep, high);
    float x = 0.48f * wide, z = 0.48f * deep, y = high + 0.003f, slant = dmg_range(b, 0.4f, 1.0f) * z;
    uint32_t hood = deck;
    if (opens == 0) hood = dmg_hinge(b, deck, "hood", v3(0, y, -z), v3(-1, 0, 0), 0.0f, lift);
    if (opens == 1) hood = dmg_slide(b, deck, "hood", v3(0, 1, 0), 0.0f, 0.5f);
    dmg_box_span(b, v3(-x, y, -z), v3(x, y + up, -z + t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * x - t, y, -z), v3((float)s * x + t, y + up, z - 0.012f));
    dmg_box_span(b, v3(-x, y + up, -z), v3(x, y + up + t, slant));
    dmg_beam(b, v3(0, y + up, slant), v3(0, y + 0.9f * up, z - 0.012f), 2 * x, t);
    if (opens == 1 && dmg_chance(b, 0.6f)) /* posts guide it up */
        for (int s = -1; s <= 1; s += 2) {
            dmg_use(b, deck);
            dmg_rod(b, v3((float)s * 0.3f * wide, high - 0.04f, -0.495f * deep),
                    v3((float)s * 0.3f * wide, high + up + 0.55f, -0.495f * deep), 0.012f);
        }
    dmg_use(b, hood);
    uint32_t front =
        dmg_hinge(b, hood, "front_panel", v3(0, y + 0.006f, z), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    dmg_box_span(b, v3(-x + t, y + 0.004f, z - t), v3(x - t, y + 0.88f * up, z));
    dmg_save(b);
    dmg_move(b, 0, y + 0.48f * up, z);
    draw_ports(b, front, ports, 1.5f * x, fminf(port, 0.4f * x / (float)ports));
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) { /* one at the end */
        bool left = dmg_chance(b, 0.5f);
        int latch = dmg_int(b, 0, 2);
        dmg_use(b, hood);
        dmg_save(b);
        dmg_move(b, x + t, y + 0.5f * up, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        draw_port(b, hood, 0.8f * port, left, latch);
        dmg_restore(b);
    }
    dmg_use(b, deck);
    dmg_save(b);
    dmg_move(b, 0, high - 0.025f, 0.5f * deep);
    dmg_knobs_draw(b, deck, dmg_int(b, 1, 4), 0.09f, 0, 0.016f);
    dmg_restore(b);
}

/* Draws a chamber with a window that lifts, glove ports in it, a lock with two doors at its end. */
static void draw_isolator(dmg_builder* b) {
    float wide = dmg_range(b, 0.9f, 1.8f), deep = dmg_range(b, 0.5f, 0.75f), up = dmg_range(b, 0.6f, 0.9f),
          high = dmg_range(b, 0.75f, 0.95f), t = 0.02f, r = dmg_range(b, 0.08f, 0.12f),
          lock = deep * dmg_range(b, 0.45f, 0.65f), lean = dmg_range(b, 0.0f, 0.25f);
    int pairs = wide > 1.3f ? 4 : 2;
    bool covers = dmg_chance(b, 0.5f);
    uint32_t deck = draw_ward_base(b, wide, deep, high);
    dmg_use(b, deck);
    dmg_save(b);
    dmg_move(b, 0, high + 0.5f * up, 0.5f * deep - lean * up);
    dmg_case_draw(b, DMG_CASE_BOARDS, wide, up, deep - lean * up, t);
    dmg_restore(b);
    const dmg_xy cheek[] = {{0, 0}, {lean * up, 0}, {0, up}};
    for (int s = -1; s <= 1 && lean > 0.03f; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * 0.5f * (wide - t), high, 0.5f * deep - lean * up);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, cheek, 3, -0.5f * t, 0.5f * t);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, high, 0.5f * deep + 0.004f);
    dmg_turn(b, v3(1, 0, 0), -atanf(lean));
    float pane = up * sqrtf(1.0f + lean * lean);
    uint32_t window = dmg_hinge(b, deck, "window", v3(0, pane, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.5f));
    dmg_box_span(b, v3(-0.5f * wide, 0.01f, 0), v3(0.5f * wide, pane, 0.015f));
    dmg_move(b, 0, 0.38f * pane, 0.016f);
    if (covers) draw_ports(b, window, pairs, 0.8f * wide, r);
    for (int i = 0; i < pairs && !covers; ++i) { /* gloves turned out */
        float x = 0.8f * wide * (((float)i + 0.5f) / (float)pairs - 0.5f);
        dmg_torus(b, v3(x, 0, 0), v3(0, 0, 1), r, 0.12f * r);
        dmg_capsule(b, v3(x, 0, 0.02f), v3(x, -0.5f * r, 0.2f), 0.5f * r);
    }
    dmg_restore(b);
    dmg_use(b, deck);
    dmg_save(b); /* the lock's outer door faces aside */
    dmg_move(b, 0.5f * wide + lock, high + 0.2f + 0.35f * lock, -lean * 0.5f * up);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_case_draw(b, DMG_CASE_BOARDS, 0.9f * lock, 0.9f * lock, lock, t);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = leaf.height = 0.9f * lock;
    leaf.side = (dmg_side)dmg_int(b, 0, 2);
    dmg_move(b, 0, 0, leaf.thickness + 0.002f);
    dmg_leaf_draw(b, deck, "lock_door", &leaf);
    dmg_restore(b);
}

void dmg_build_incubator(dmg_builder* b) {
    if (dmg_chance(b, 0.65f))
        draw_baby_incubator(b);
    else
        draw_isolator(b);
}
