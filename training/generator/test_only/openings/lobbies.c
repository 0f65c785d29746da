/* Draws doors of lobbies: drums with wings about a post and night doors round them, automatic doors that slide or
 * swing; lift landings with telescopic, centre-opening, folding and rising doors, the car behind them. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"

/* ---- a revolving door ---- */

typedef struct drum {
    float r, high, t, gate; /* gate: half the angle of an entrance */
    int wings;
} drum;

/* Draws the curved walls at both sides, floor and canopy; angles of skins, whose Y looks backwards here. */
static void draw_drum(dmg_builder* b, const drum* d) {
    float canopy = dmg_range(b, 0.08f, 0.5f), over = d->r + dmg_range(b, 3.0f, 5.0f) * d->t,
          open = 0.5f * DMG_PI - d->gate;
    bool square = dmg_chance(b, 0.25f);
    for (int s = 0; s < 2; ++s) {
        float middle = s ? DMG_PI : 0.0f;
        dmg_skin_cone(b, (dmg_xy){d->r, 0}, (dmg_xy){d->r, d->high}, middle - open, middle + open, d->t);
        for (int e = -1; e <= 1; e += 2) {
            dmg_vec foot = dmg_skin_point(d->r - 0.5f * d->t, middle + (float)e * open, 0);
            dmg_rod(b, foot, v3(foot.x, foot.y, d->high), 0.55f * d->t);
        }
    }
    if (square)
        dmg_box(b, v3(0, 0, d->high + 0.5f * canopy), v3(2 * over, 2 * over, canopy));
    else
        dmg_rod(b, v3(0, 0, d->high), v3(0, 0, d->high + canopy), over);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.01f), over);
}

/* Curved leaves that run round the drum, outside it: closed they bar the entrance. */
static void draw_night_doors(dmg_builder* b, const drum* d) {
    float r = d->r + 1.3f * d->t, way = 0.96f * d->gate;
    bool two = dmg_chance(b, 0.7f), back = dmg_chance(b, 0.4f), open = dmg_chance(b, 0.5f);
    if (!two) way = fminf(2.0f * way, DMG_PI - 2.4f * d->gate);
    for (int end = 0; end < (back ? 2 : 1); ++end) {
        for (int s = two ? -1 : 1; s <= 1; s += 2) {
            float middle = end ? 0.5f * DMG_PI : -0.5f * DMG_PI, low = s < 0 || !two ? middle - d->gate : middle,
                  high = s > 0 ? middle + d->gate : middle;
            uint32_t leaf = dmg_hinge(b, 0, "night_door", v3(0, 0, 0), v3(0, 0, (float)s), 0.0f, way);
            if (open) dmg_rest(b, leaf, way);
            dmg_skin_cone(b, (dmg_xy){r, 0.02f}, (dmg_xy){r, d->high - 0.01f}, low + 0.004f, high - 0.004f,
                          0.7f * d->t);
            dmg_use(b, 0);
        }
    }
}

/* Wings from the core outwards, one with the rotor or each folding on the core for an escape. */
static void draw_wings(dmg_builder* b, const drum* d) {
    float core = dmg_range(b, 0.025f, 0.1f), foot = 0.03f, t = dmg_range(b, 0.025f, 0.06f),
          fold = dmg_range(b, 0.6f, 1.3f);
    bool folds = dmg_chance(b, 0.5f), bars = dmg_chance(b, 0.6f), leans = dmg_chance(b, 0.5f);
    dmg_panel panel = dmg_panel_pick_window(b);
    float wide = d->r - 1.6f * d->t - core - 0.012f, high = d->high - 2 * foot, bar = dmg_range(b, 0.9f, 1.1f);
    uint32_t rotor = dmg_spin(b, 0, "rotor", v3(0, 0, 0), v3(0, 1, 0));
    if (leans) dmg_rest(b, rotor, dmg_unit(b));
    dmg_rod(b, v3(0, foot, 0), v3(0, d->high - 0.01f, 0), core);
    for (int i = 0; i < d->wings; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, d->wings);
        dmg_turn(b, v3(0, 1, 0), 0.25f * DMG_PI);
        if (folds) dmg_hinge(b, rotor, "wing", v3(core + 0.5f * t, 0, 0), v3(0, -1, 0), 0.0f, fold);
        dmg_save(b);
        dmg_move(b, core + 0.006f + 0.5f * wide, d->high * 0.5f, 0.5f * t);
        dmg_panel_draw(b, &panel, wide, high, t);
        dmg_restore(b);
        if (bars) {
            float x0 = core + 0.25f * wide, x1 = core + 0.9f * wide, z = 0.5f * t + 0.05f;
            dmg_rod(b, v3(x0, bar, z), v3(x1, bar, z), 0.015f);
            dmg_rod(b, v3(x0, bar, 0.4f * t), v3(x0, bar, z), 0.01f);
            dmg_rod(b, v3(x1, bar, 0.4f * t), v3(x1, bar, z), 0.01f);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_revolving(dmg_builder* b) {
    drum d = {.r = dmg_range(b, 0.85f, 2.0f)};
    d.t = dmg_range(b, 0.03f, 0.09f);
    d.high = dmg_range(b, 2.1f, 2.7f);
    d.wings = dmg_weighted(b, (const float[]){0.15f, 1, 1}, 3) + 2;
    d.gate = (d.wings == 4 ? 0.78f : 1.04f) * dmg_range(b, 0.75f, 0.98f);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    draw_drum(b, &d);
    if (dmg_chance(b, 0.55f)) draw_night_doors(b, &d);
    dmg_restore(b);
    draw_wings(b, &d);
}

/* ---- automatic doors ---- */

/* Screens at both sides, the operator's box above; leaves run along it, behind each other where there are several. */
static void draw_sliding_entrance(dmg_builder* b) {
    float leaf = dmg_range(b, 0.45f, 1.1f), high = dmg_range(b, 2.0f, 2.6f), t = dmg_range(b, 0.03f, 0.06f),
          box = dmg_range(b, 0.1f, 0.3f), screen = leaf * dmg_range(b, 1.03f, 1.3f);
    int each = dmg_chance(b, 0.3f) ? 2 : 1, first = dmg_chance(b, 0.15f) ? 1 : -1;
    bool breaks = dmg_chance(b, 0.35f), open = dmg_chance(b, 0.3f);
    float half = (float)each * leaf, out = half + screen;
    dmg_panel pane = dmg_panel_pick_window(b);
    dmg_box_span(b, v3(-out, high, -3.0f * t), v3(out, high + box, 1.2f * t));
    dmg_box_span(b, v3(-out, 0, -3.0f * t), v3(out, 0.012f, t));
    for (int s = first; s <= 1; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, half + 0.5f * screen, 0.5f * high, t);
        dmg_panel_draw(b, &pane, screen, high, t);
        dmg_move(b, -half - 0.5f * screen, 0, -t - 0.015f);
        for (int i = 0; i < each; ++i) {
            float x = leaf * ((float)i + 0.5f), way = 0.97f * leaf * (float)(each - i);
            uint32_t runner = dmg_slide(b, 0, "sliding_leaf", v3(1, 0, 0), 0.0f, way);
            if (open) dmg_rest(b, runner, way);
            dmg_box(b, v3(x, 0.5f * high - 0.01f, -0.5f * t), v3(0.8f * leaf, 0.02f, 0.6f * t));
            if (breaks && i == each - 1)
                dmg_hinge(b, runner, "breakout_leaf", v3(x + 0.5f * leaf - 0.003f, 0, 0), v3(0, 1, 0), 0.0f, 1.5f);
            dmg_save(b);
            dmg_move(b, x, -0.01f, 0);
            dmg_panel_draw(b, &pane, leaf - 0.006f, high - 0.06f, t);
            dmg_restore(b);
            dmg_use(b, 0);
            dmg_move(b, 0, 0, -t - 0.012f);
        }
        dmg_restore(b);
    }
    if (first > 0) dmg_box_span(b, v3(-half - 0.06f, 0, -t), v3(-0.01f, high, t));
}

/* Leaves that an operator over the door pushes with an arm; a plate beside it to call it. */
static void draw_swing_entrance(dmg_builder* b) {
    float wide = dmg_range(b, 0.8f, 1.15f), high = dmg_range(b, 2.0f, 2.3f), jamb = dmg_range(b, 0.06f, 0.15f);
    bool two = dmg_chance(b, 0.5f), plate = dmg_chance(b, 0.7f), arms = dmg_chance(b, 0.7f);
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, wide, high, dmg_range(b, 0.04f, 0.06f));
    leaf.panel = dmg_panel_pick_window(b);
    float span = two ? 2 * wide : wide, out = 0.5f * span + jamb, box = dmg_range(b, 0.08f, 0.14f);
    leaf.width = wide - 0.008f;
    leaf.height = high - 0.012f;
    leaf.swing = 1.6f;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(s < 0 ? -out : out - jamb, 0, -0.08f), v3(s < 0 ? -out + jamb : out, high, 0.0f));
    dmg_box_span(b, v3(-out, high, -0.08f), v3(out, high + 1.4f * box, 0.0f));
    dmg_box_span(b, v3(-0.5f * span, high + 0.2f * box, 0.0f), v3(0.5f * span, high + 1.2f * box, 1.1f * box));
    for (int i = 0; i < (two ? 2 : 1); ++i) {
        dmg_save(b);
        leaf.side = i ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT;
        dmg_move(b, two ? (i ? 0.5f : -0.5f) * wide : 0.0f, 0.5f * high, 0);
        dmg_leaf_draw(b, 0, "swing_leaf", &leaf);
        dmg_use(b, 0);
        dmg_restore(b);
        if (!arms) continue;
        float x = (i ? 1.0f : -1.0f) * (0.5f * span - 0.15f * wide), y = high + 0.18f * box, z = 0.6f * box;
        dmg_hinge(b, 0, "operator_arm", v3(x, y, z), v3(0, i ? 1.0f : -1.0f, 0), 0.0f, 1.4f);
        dmg_rod(b, v3(x, y, z), v3(x, y - 0.025f, z), 0.02f);
        dmg_beam(b, v3(x, y - 0.03f, z), v3(x + (i ? -0.4f : 0.4f) * wide, y - 0.03f, z), 0.03f, 0.008f);
        dmg_use(b, 0);
    }
    if (!plate) return;
    float side = dmg_range(b, 0.1f, 0.2f), y = dmg_range(b, 0.8f, 1.2f);
    dmg_box_span(b, v3(out, 0, -0.08f), v3(out + 2.5f * side, high + 1.4f * box, 0));
    dmg_move(b, out + 1.25f * side, y, 0);
    dmg_buttons call = {"call_plate", 1, 1, 0, 0, side, side, 0.025f, 0.012f, dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, 0, &call);
}

void dmg_build_revolving_door(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 1.4f, 0.8f}, 3);
    if (design == 0) draw_revolving(b);
    if (design == 1) draw_sliding_entrance(b);
    if (design == 2) draw_swing_entrance(b);
}

/* ---- a lift ---- */

typedef struct landing {
    float wide, high, foot, t; /* of the opening; foot: its sill above the floor */
    float pocket, top;         /* wall beside and above it */
} landing;

static void draw_landing_wall(dmg_builder* b, const landing* l) {
    float half = 0.5f * l->wide, out = half + l->pocket, high = l->foot + l->high, trim = dmg_range(b, 0.03f, 0.12f);
    dmg_box_span(b, v3(-out, 0, -l->t), v3(-half, high + l->top, 0));
    dmg_box_span(b, v3(half, 0, -l->t), v3(out, high + l->top, 0));
    dmg_box_span(b, v3(-half, high, -l->t), v3(half, high + l->top, 0));
    if (l->foot > 0.0f) dmg_box_span(b, v3(-half, 0, -l->t), v3(half, l->foot, 0));
    if (!dmg_chance(b, 0.5f)) return;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * half - (s < 0 ? trim : 0.0f), l->foot, -0.01f),
                     v3((float)s * half + (s < 0 ? 0.0f : trim), high + trim, 0.02f));
    dmg_box_span(b, v3(-half, high, -0.01f), v3(half, high + trim, 0.02f));
}

/* Panels behind z = 0 that run aside: all one way, each further than the last, or from the middle both ways. */
static void draw_lift_panels(dmg_builder* b, const landing* l, uint32_t parent, const char* name, int each, bool centre,
                             float rest) {
    float half = 0.5f * l->wide, span = centre ? half : l->wide, panel = span / (float)each, d = 0.03f;
    for (int s = centre ? -1 : 1; s <= 1; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        for (int i = 0; i < each; ++i) {
            float x0 = (centre ? 0.0f : -half) + panel * (float)i, way = 0.98f * panel * (float)(each - i),
                  z = -0.012f - (float)i * (d + 0.01f);
            uint32_t leaf = dmg_slide(b, parent, name, v3(1, 0, 0), 0.0f, way);
            dmg_rest(b, leaf, rest * way);
            dmg_box_span(b, v3(x0 + 0.002f, l->foot + 0.015f, z - d),
                         v3(x0 + panel + (i + 1 < each ? 0.02f : 0.0f) - 0.002f, l->foot + l->high + 0.03f, z));
        }
        dmg_use(b, parent);
        dmg_restore(b);
    }
}

/* Draws the car: floor, roof and walls, its front at z = 0, guides beside it where it travels. */
static uint32_t draw_lift_car(dmg_builder* b, const landing* l) {
    float deep = l->wide * dmg_range(b, 0.8f, 1.6f), wide = l->wide + 2.0f * fminf(l->pocket, 0.3f) - 0.04f, w = 0.03f;
    uint32_t car = 0;
    if (dmg_chance(b, 0.4f)) {
        float x = 0.5f * wide + 0.05f, top = l->foot + 2.2f * l->high;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * x - 0.03f, 0, -0.5f * deep - 0.05f),
                         v3((float)s * x + 0.03f, top, -0.5f * deep + 0.05f));
        car = dmg_slide(b, 0, "car", v3(0, 1, 0), 0.0f, 1.05f * l->high);
    }
    dmg_save(b);
    dmg_move(b, 0, l->foot + 0.5f * l->high + 0.03f, -0.002f);
    dmg_case_draw(b, DMG_CASE_BOARDS, wide, l->high + 0.1f, deep, w);
    dmg_restore(b);
    return car;
}

/* Leaves hinged on each other that fold away to one side. */
static void draw_fold_gate(dmg_builder* b, const landing* l) {
    int count = 2 * dmg_int(b, 1, 2);
    float w = l->wide / (float)count, t = 0.02f, half = 0.5f * l->wide, way = dmg_range(b, 1.2f, 1.45f);
    dmg_panel panel = dmg_panel_pick(b);
    uint32_t leaf = 0;
    for (int i = 0; i < count; ++i) {
        float x = -half + w * (float)i;
        leaf = dmg_hinge(b, leaf, "fold_leaf", v3(x, 0, i % 2 ? 0.0f : -t), v3(0, i % 2 ? 1.0f : -1.0f, 0), 0.0f,
                         i ? 2 * way : way);
        dmg_save(b);
        dmg_move(b, x + 0.5f * w, l->foot + 0.5f * l->high, 0);
        dmg_panel_draw(b, &panel, w - 0.006f, l->high - 0.03f, t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Bars that hang from a rail and run up to each other, as those of a lattice gate do. */
static void draw_bar_gate(dmg_builder* b, const landing* l, float z) {
    int count = dmg_int(b, 5, 10);
    float half = 0.5f * l->wide, pitch = l->wide / (float)count, top = l->foot + l->high, t = 0.012f;
    dmg_box_span(b, v3(-half - l->pocket * 0.4f, top + 0.02f, z - 0.02f), v3(half, top + 0.05f, z + 0.02f));
    dmg_box_span(b, v3(-half - 0.03f, l->foot + 0.01f, z - t), v3(-half - 0.03f + t, top + 0.02f, z + t));
    for (int i = 0; i < count; ++i) {
        float x = -half + pitch * ((float)i + 0.9f), shut = -half + 1.6f * t * (float)(i + 1);
        dmg_slide(b, 0, "gate_bar", v3(-1, 0, 0), 0.0f, fmaxf(x - shut, 0.01f));
        dmg_box_span(b, v3(x - 0.5f * t, l->foot + 0.02f, z - t), v3(x + 0.5f * t, top + 0.02f, z + t));
        if (i == count - 1) dmg_box(b, v3(x, l->foot + 0.5f * l->high, z + 2 * t), v3(1.2f * t, 0.2f, 2.2f * t));
    }
    dmg_use(b, 0);
}

/* Doors that go up and down: two halves apart, or one, or two behind each other. */
static void draw_rising_doors(dmg_builder* b, const landing* l) {
    int kind = dmg_int(b, 0, 2);
    float half = 0.5f * l->wide + 0.03f, middle = l->foot + 0.5f * l->high, top = l->foot + l->high, d = 0.02f;
    for (int i = 0; i < (kind == 1 ? 1 : 2); ++i) {
        bool upper = i == 0;
        float low = kind == 1 || !upper ? l->foot : middle, high = kind == 1 || upper ? top : middle,
              z = kind == 2 && !upper ? -0.01f - 1.3f * d : -0.005f,
              way = kind == 1 || (kind == 2 && !upper) ? l->high : 0.5f * l->high;
        if (kind == 0 && !upper) way = fminf(way, l->foot - 0.02f);
        dmg_slide(b, 0, "hatch", v3(0, kind == 0 && !upper ? -1.0f : 1.0f, 0), 0.0f, 0.95f * way);
        dmg_box_span(b, v3(-half, low + 0.002f, -l->t + z - d), v3(half, high - 0.002f, -l->t + z));
        float y =
            kind == 0 && upper ? low + 0.05f * l->high : (kind == 0 ? high - 0.05f * l->high : low + 0.06f * l->high);
        if (kind < 2 || upper) dmg_box(b, v3(0, y, -l->t + z + 0.02f), v3(0.3f * l->wide, 0.03f, 0.05f));
        dmg_use(b, 0);
    }
}

/* Call buttons in a plate beside the opening, a key or lamp; over it a dial whose hand shows the floor. */
static void draw_call_panel(dmg_builder* b, const landing* l) {
    float x = 0.5f * l->wide + fminf(0.6f * l->pocket, 0.3f), y = dmg_range(b, 0.95f, 1.25f),
          size = dmg_range(b, 0.02f, 0.04f);
    int rows = dmg_int(b, 1, 2), columns = l->foot > 0.0f ? dmg_int(b, 1, 2) : 1;
    bool dial = l->foot == 0.0f && dmg_chance(b, 0.35f);
    dmg_save(b);
    dmg_move(b, x, y, 0);
    dmg_box_span(b, v3(-1.3f * size * (float)columns, -2.0f * size * (float)rows, -0.01f),
                 v3(1.3f * size * (float)columns, 2.0f * size * (float)rows, 0.008f));
    dmg_move(b, 0, 0, 0.008f);
    dmg_buttons call = {"call_button", columns, rows, 2 * size, 2 * size, size, size, 0.008f, 0.004f, dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, 0, &call);
    dmg_restore(b);
    if (!dial) return;
    float r = fminf(0.4f * l->top, 0.25f);
    const dmg_vec hub = {0, l->foot + l->high + 0.3f * l->top, 0};
    dmg_rod(b, v3(0, hub.y, -0.01f), v3(0, hub.y, 0.03f), r);
    uint32_t hand = dmg_hinge(b, 0, "floor_hand", hub, v3(0, 0, -1), -1.4f, 1.4f);
    dmg_rest(b, hand, dmg_range(b, -1.4f, 1.4f));
    dmg_rod(b, v3(0, hub.y, 0.03f), v3(0, hub.y, 0.045f), 0.12f * r);
    dmg_beam(b, v3(0, hub.y, 0.038f), v3(0, hub.y + 0.85f * r, 0.038f), 0.06f * r, 0.008f);
    dmg_use(b, 0);
}

/* Draws a door to walk up to and pull, behind it a gate. */
static void draw_old_landing(dmg_builder* b, const landing* l) {
    bool gate = dmg_chance(b, 0.6f);
    float shift = dmg_range(b, 0.06f, 0.2f);
    if (dmg_chance(b, 0.75f)) {
        dmg_leaf leaf = dmg_leaf_pick(b, 0.25f);
        leaf.width = l->wide - 0.01f;
        leaf.height = l->high - 0.02f;
        leaf.thickness = fminf(leaf.thickness, 0.8f * l->t);
        leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, 0, l->foot + 0.5f * l->high, 0);
        dmg_leaf_draw(b, 0, "landing_door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (gate) draw_bar_gate(b, l, -l->t - shift);
    if (gate) return;
    dmg_save(b);
    dmg_move(b, 0, 0, -l->t - shift);
    draw_fold_gate(b, l);
    dmg_restore(b);
}

void dmg_build_lift_doors(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 3, 1.5f, 2}, 4), each = dmg_int(b, 1, 3);
    landing l = {.wide = dmg_range(b, 0.8f, 1.5f)};
    l.t = dmg_range(b, 0.05f, 0.2f);
    l.high = dmg_range(b, 2.0f, 2.4f);
    l.top = dmg_range(b, 0.3f, 0.8f);
    float shut = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.2f, 1.0f);
    bool centre = design == 0, car_doors = dmg_chance(b, 0.7f);
    if (centre && each == 3) each = 2;
    if (!centre && each == 1) each = 2;
    l.pocket = design < 2 ? l.wide / (float)each * (centre ? 0.5f : 1.0f) + 0.1f : dmg_range(b, 0.25f, 0.6f);
    if (design == 3) {
        l.wide = dmg_range(b, 0.4f, 1.0f);
        l.high = l.wide * dmg_range(b, 0.8f, 1.4f);
        l.foot = dmg_range(b, 0.55f, 0.95f);
        l.top = 1.05f * l.high;
    }
    if (dmg_chance(b, 0.4f)) dmg_mirror(b, v3(1, 0, 0));
    draw_landing_wall(b, &l);
    if (dmg_chance(b, 0.85f)) draw_call_panel(b, &l);
    if (design == 2) draw_old_landing(b, &l);
    if (design == 3) draw_rising_doors(b, &l);
    dmg_move(b, 0, 0, -l.t);
    if (design < 2) {
        draw_lift_panels(b, &l, 0, "landing_door", each, centre, shut);
        float back = -0.05f - 0.045f * (float)each;
        dmg_box_span(b, v3(-0.5f * l.wide - l.pocket, l.foot, back), v3(0.5f * l.wide + l.pocket, l.foot + 0.012f, 0));
        dmg_move(b, 0, 0, back - 0.02f);
    } else {
        dmg_move(b, 0, 0, design == 2 ? -0.7f : -0.08f);
    }
    if (!dmg_chance(b, 0.75f)) return;
    float sill = 0.05f + 0.045f * (float)each;
    dmg_move(b, 0, 0, design < 2 && car_doors ? -sill : 0.0f);
    uint32_t car = draw_lift_car(b, &l);
    dmg_move(b, 0, 0, sill - 0.01f);
    if (design < 2 && car_doors) draw_lift_panels(b, &l, car, "car_door", each, centre, shut);
}
