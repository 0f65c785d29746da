/* Draws machines of halls, workshops and fairgrounds, and hand-held power tools. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- curved covers: they turn about a line far from themselves ---- */

/* Bread bins, visors, roll tops, sector gates: a part of a cylinder's wall about X. */
void dmg_build_roll_top(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.05f, 1.0f), width = radius * dmg_range(b, 0.8f, 4.0f),
          wall = radius * dmg_range(b, 0.01f, 0.08f), arc = dmg_range(b, 0.8f, 1.7f),
          slack = wall * dmg_range(b, 0.2f, 1.5f);
    int shape = dmg_int(b, 0, 2); /* a bin, a box with a curved front, a helmet */
    if (shape == 2) width = fminf(width, 1.9f * radius);
    float outer = radius + wall, inner = radius - slack - wall, half = 0.5f * width;
    dmg_move(b, 0, shape == 2 ? 1.2f * radius : 0.02f * radius, 0);
    for (int s = -1; s <= 1 && shape < 2; s += 2) { /* cheeks */
        float x = (float)s * (half + wall);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_xy quarter[9] = {{0}};
        for (int i = 0; i < 9; ++i)
            quarter[i] = (dmg_xy){outer * cosf(DMG_PI * (float)i / 8.0f), outer * sinf(DMG_PI * (float)i / 8.0f)};
        dmg_extrude(b, quarter, 9, -0.5f * wall, 0.5f * wall);
        dmg_restore(b);
    }
    const dmg_xy shell[] = {{inner, -half}, {inner, half}, {inner - wall, half}, {inner - wall, -half}, {inner, -half}};
    if (shape < 2) {
        dmg_box(b, v3(0, -0.5f * wall, 0), v3(width + 3 * wall, wall, 2.2f * outer));
        /* The back of the wall stays: angles are from +Z over the top. */
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI - 0.2f);
        dmg_lathe_arc(b, v3(0, 0, 0), v3(1, 0, 0), shell, 5, 0.0f, 1.5f);
        dmg_restore(b);
    } else {
        dmg_ellipsoid(b, v3(0, 0, -0.1f * radius), v3(half, 0.95f * inner, 0.95f * inner));
        dmg_box(b, v3(0, -0.8f * radius, -0.2f * radius), v3(width, 0.8f * radius, radius));
    }
    dmg_hinge(b, 0, "cover", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, fminf(arc, 1.5f) * dmg_range(b, 0.7f, 1.0f));
    const dmg_xy cover[] = {{radius, -half}, {radius, half}, {outer, half}, {outer, -half}, {radius, -half}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -arc); /* from low in front up to the top */
    dmg_lathe_arc(b, v3(0, 0, 0), v3(1, 0, 0), cover, 5, 0.5f * DMG_PI, arc);
    dmg_restore(b);
    if (shape == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * half, 0, 0), v3((float)s * (half + wall), 0, 0), 0.2f * radius);
    if (shape == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * half, 0, 0), v3((float)s * half, 0, outer), wall, 0.3f * radius);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.1f * radius, outer), v3(0.4f * width, 0.05f * radius, 0.1f * radius));
    dmg_use(b, 0);
}

/* ---- panels on pins ---- */

/* Swing lids, cat flaps, revolving doors, vanes: the line runs through the panel or along its top, both ways free. */
void dmg_build_pivot_panel(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.1f, 2.5f), height = width * dmg_scale_range(b, 0.4f, 2.2f),
          t = fminf(width, height) * dmg_range(b, 0.01f, 0.08f),
          border = fminf(width, height) * dmg_range(b, 0.05f, 0.4f), swing = dmg_range(b, 0.5f, 1.5f);
    int kind = dmg_int(b, 0, 3);
    dmg_panel panel = dmg_panel_pick(b);
    dmg_move(b, 0, 0.5f * height + border, 0);
    if (kind == 3) { /* several wings about a post, in a drum or free */
        int wings = dmg_int(b, 2, 4);
        if (dmg_chance(b, 0.7f))
            for (int s = -1; s <= 1; s += 2)
                dmg_rod(b, v3(0, (float)s * 0.52f * height - 0.02f * height, 0),
                        v3(0, (float)s * 0.52f * height + 0.02f * height, 0), 1.05f * width);
        const dmg_xy wall[] = {{1.02f * width, -0.5f * height},
                               {1.02f * width, 0.5f * height},
                               {1.05f * width, 0.5f * height},
                               {1.05f * width, -0.5f * height},
                               {1.02f * width, -0.5f * height}};
        for (int i = 0; i < 2; ++i) dmg_lathe_arc(b, v3(0, 0, 0), v3(0, 1, 0), wall, 5, DMG_PI * (float)i, 1.6f);
        dmg_spin(b, 0, "door", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, -0.49f * height, 0), v3(0, 0.49f * height, 0), 2 * t);
        for (int i = 0; i < wings; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, wings);
            dmg_move(b, 0.5f * width, 0, 0.5f * t);
            dmg_panel_draw(b, &panel, 0.98f * width, 0.96f * height, t);
            dmg_restore(b);
        }
        dmg_use(b, 0);
        return;
    }
    dmg_frame_draw(b, width + 2 * border, height + 2 * border, t * dmg_range(b, 1.0f, 4.0f), border);
    dmg_move(b, 0, 0, -0.5f * t);
    float at = kind == 0 ? 0.0f : (kind == 1 ? 0.48f : dmg_range(b, -0.4f, 0.4f));
    bool upright = dmg_chance(b, 0.5f), pins = dmg_chance(b, 0.6f);
    dmg_vec axis = upright ? v3(0, 1, 0) : v3(1, 0, 0),
            pivot = upright ? v3(at * width, 0, -0.5f * t) : v3(0, at * height, -0.5f * t);
    dmg_hinge(b, 0, "panel", pivot, axis, -swing, swing);
    dmg_panel_draw(b, &panel, 0.98f * width, 0.98f * height, t);
    dmg_vec half = v3_scale(axis, 0.5f * (upright ? height : width) + 0.5f * border);
    if (pins) dmg_rod(b, v3_sub(pivot, half), v3_add(pivot, half), 0.6f * t);
    dmg_use(b, 0);
}

/* ---- tubes in tubes ---- */

/* Antennas, tripods' legs, poles, spyglasses: each slides out of the one before; the first may tip or turn. */
void dmg_build_telescope(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.005f, 0.2f), length = radius * dmg_range(b, 5, 30),
          shrink = dmg_range(b, 0.65f, 0.9f);
    int tubes = dmg_int(b, 2, 5), base = dmg_int(b, 0, 2), section = dmg_int(b, 0, 1);
    float lean = dmg_range(b, -0.6f, 1.2f), out = dmg_chance(b, 0.5f) ? dmg_range(b, 0.1f, 0.9f) : 0.0f;
    uint32_t carrier = 0;
    if (base > 0) {
        dmg_box(b, v3(0, 2 * radius, 0), v3(10 * radius, 4 * radius, 8 * radius));
        dmg_move(b, 0, 4 * radius, 0);
        if (base == 2) {
            carrier = dmg_spin(b, 0, "mount", v3(0, 0, 0), v3(0, 1, 0));
            dmg_rod(b, v3(0, 0, 0), v3(0, 1.5f * radius, 0), 1.6f * radius);
        }
        dmg_move(b, 0, 1.5f * radius, 0);
        carrier =
            dmg_hinge(b, carrier, "antenna", v3(0, 0, 0), v3(1, 0, 0), -1.5f - fminf(lean, 0), 1.5f - fmaxf(lean, 0));
        dmg_rod(b, v3(-1.3f * radius, 0, 0), v3(1.3f * radius, 0, 0), radius);
    }
    dmg_turn(b, v3(1, 0, 0), lean);
    for (int i = 0; i < tubes; ++i) {
        if (i > 0) {
            carrier = dmg_slide(b, carrier, "tube", v3(0, 1, 0), 0.0f, 0.85f * length);
            dmg_rest(b, carrier, 0.85f * length * out);
        }
        float top = length * (1.0f + 0.03f * (float)i);
        if (section == 0)
            dmg_rod(b, v3(0, 0, 0), v3(0, top, 0), radius);
        else
            dmg_box(b, v3(0, 0.5f * top, 0), v3(2 * radius, top, 1.4f * radius));
        if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, top - 0.5f * radius, 0), v3(0, top, 0), 1.15f * radius);
        radius *= shrink;
    }
    dmg_use(b, 0);
}

/* ---- rings within rings ---- */

void dmg_build_gyroscope(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.03f, 2.0f), tube = radius * dmg_range(b, 0.03f, 0.08f),
          shrink = dmg_range(b, 0.75f, 0.88f);
    int rings = dmg_int(b, 0, 3), core = dmg_int(b, 0, 3), cage = dmg_int(b, 0, 2);
    dmg_move(b, 0, 1.4f * radius, 0);
    if (cage == 0) {
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 1.1f * radius, -1.4f * radius, 0), v3((float)s * 1.1f * radius, 0.1f * radius, 0),
                     2 * tube, 3 * tube);
        dmg_box(b, v3(0, -1.37f * radius, 0), v3(2.6f * radius, 0.06f * radius, 1.4f * radius));
    }
    if (cage == 1)
        for (int i = 0; i < 3; ++i)
            dmg_torus(b, v3(0, 0, 0), i == 0 ? v3(1, 0, 0) : (i == 1 ? v3(0, 1, 0) : v3(0, 0, 1)), 1.2f * radius, tube);
    if (cage == 2) { /* bars round a box */
        for (int i = 0; i < 12; ++i) {
            float u = i & 1 ? 1.2f : -1.2f, w = i & 2 ? 1.2f : -1.2f;
            int along = i / 4;
            dmg_vec size = {along == 0 ? 2.4f : 0.05f, along == 1 ? 2.4f : 0.05f, along == 2 ? 2.4f : 0.05f},
                    at = {along == 0 ? 0 : u, along == 1 ? 0 : (along == 0 ? u : w), along == 2 ? 0 : w};
            dmg_box(b, v3_scale(at, radius), v3_scale(size, radius));
        }
    }
    uint32_t carrier = 0;
    for (int i = 0; i < rings; ++i) {
        dmg_vec axis = i % 2 ? v3(0, 1, 0) : v3(1, 0, 0),
                end = v3_scale(axis, radius / shrink + (i == 0 ? 0.15f * radius : 0));
        carrier = dmg_spin(b, carrier, "ring", v3(0, 0, 0), axis);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius, tube);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3_scale(axis, (float)s * 0.95f * radius), v3_scale(end, (float)s), 0.6f * tube);
        radius *= shrink;
    }
    dmg_vec axis = rings % 2 ? v3(0, 1, 0) : (dmg_chance(b, 0.5f) ? v3(0, 1, 0) : v3(1, 0, 0));
    dmg_spin(b, carrier, "rotor", v3(0, 0, 0), axis);
    if (dmg_chance(b, 0.8f)) dmg_rod(b, v3_scale(axis, -1.1f * radius), v3_scale(axis, 1.1f * radius), 0.6f * tube);
    if (core == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.6f * radius, 0.6f * radius, 0.6f * radius));
    if (core == 1) dmg_rod(b, v3_scale(axis, -0.15f * radius), v3_scale(axis, 0.15f * radius), 0.8f * radius);
    if (core == 2)
        dmg_ellipsoid(b, v3(0, 0, 0),
                      axis.y > 0.5f ? v3(0.85f * radius, 0.25f * radius, 0.85f * radius)
                                    : v3(0.25f * radius, 0.85f * radius, 0.85f * radius));
    if (core == 3) dmg_box(b, v3(0, 0, 0), v3(radius, 0.7f * radius, 0.8f * radius));
    dmg_use(b, 0);
}

/* ---- turnstile ---- */

void dmg_build_turnstile(dmg_builder* b) {
    float high = dmg_range(b, 0.8f, 1.1f), width = dmg_range(b, 0.2f, 0.4f), depth = dmg_range(b, 0.3f, 1.2f),
          arm = dmg_range(b, 0.35f, 0.6f), side = dmg_sign(b);
    int kind = dmg_int(b, 0, 2), arms = dmg_int(b, 3, 4);
    if (kind < 2) dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(width, high, depth), 0.1f * width);
    if (kind == 0) { /* three arms about a slanted line */
        dmg_vec hub = {side * 0.5f * width, 0.85f * high, 0}, axis = v3_normalize(v3(side, 1, 0)), u, w;
        v3_basis(axis, &u, &w);
        dmg_spin(b, 0, "arms", hub, axis);
        dmg_rod(b, hub, v3_mad(hub, axis, 0.06f), 0.07f);
        for (int i = 0; i < 3; ++i) {
            float turn = 2.0f * DMG_PI * (float)i / 3.0f;
            dmg_vec out = v3_add(v3_scale(u, cosf(turn)), v3_scale(w, sinf(turn)));
            dmg_vec way = v3_normalize(v3_add(out, v3_scale(axis, 0.9f)));
            dmg_rod(b, v3_mad(hub, axis, 0.03f), v3_mad(hub, way, arm), 0.018f);
        }
    }
    if (kind == 1) { /* a glass wing that swings aside */
        float t = 0.012f, swing = dmg_range(b, 1.2f, 1.6f);
        dmg_hinge(b, 0, "wing", v3(side * 0.5f * width, 0, 0), v3(0, dmg_sign(b), 0), 0.0f, swing);
        dmg_box(b, v3(side * (0.5f * width + 0.5f * arm), 0.6f * high, 0), v3(arm, 0.6f * high, t));
    }
    if (kind == 2) { /* rows of arms about a post */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.05f, 0), arm);
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 1.3f * arm, high, 0), v3(0.1f, 2 * high, 0.6f * arm));
        dmg_spin(b, 0, "post", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.05f, 0), v3(0, 2 * high, 0), 0.05f);
        for (int row = 0; row < 5; ++row) {
            for (int i = 0; i < arms; ++i) {
                float turn = 2.0f * DMG_PI * (float)i / (float)arms, y = high * (0.3f + 0.35f * (float)row);
                dmg_rod(b, v3(0, y, 0), v3(arm * cosf(turn), y, arm * sinf(turn)), 0.02f);
            }
        }
    }
    dmg_use(b, 0);
}

/* ---- vending and slot machines ---- */

void dmg_build_vending_machine(dmg_builder* b) {
    float high = dmg_range(b, 1.2f, 2.0f), width = dmg_range(b, 0.5f, 1.1f), depth = dmg_range(b, 0.4f, 0.9f),
          t = dmg_range(b, 0.02f, 0.06f);
    bool slot = dmg_chance(b, 0.35f);
    dmg_move(b, 0, 0.5f * high, 0.5f * depth);
    dmg_case_draw(b, slot ? DMG_CASE_SOLID : dmg_case_pick(b), width, high, depth, t);
    uint32_t door = 0;
    if (!slot || dmg_chance(b, 0.3f)) { /* the whole front is a door that carries the rest */
        dmg_leaf leaf = dmg_leaf_pick(b, 0.3f);
        leaf.width = width;
        leaf.height = high;
        leaf.thickness = t;
        leaf.panel.kind = DMG_PANEL_FLAT;
        leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_move(b, 0, 0, t);
        door = dmg_leaf_draw(b, 0, "door", &leaf);
    }
    dmg_use(b, door);
    if (dmg_chance(b, 0.7f)) dmg_box(b, v3(-0.12f * width, 0.12f * high, 0), v3(0.6f * width, 0.55f * high, 0.02f));
    float flap = high * dmg_range(b, 0.06f, 0.14f), y = -0.36f * high;
    bool top_hung = dmg_chance(b, 0.8f);
    dmg_hinge(b, door, "flap", v3(0, y + (top_hung ? 0.5f : -0.5f) * flap, 0.01f), v3(top_hung ? -1.0f : 1.0f, 0, 0),
              0.0f, 1.2f);
    dmg_box(b, v3(0, y, 0.01f), v3(0.6f * width, flap, 0.015f));
    dmg_use(b, door);
    dmg_save(b);
    dmg_move(b, 0.34f * width, 0.1f * high, 0);
    dmg_controls_draw(b, door, 0.2f * width, 0.25f * high);
    dmg_restore(b);
    if (slot) { /* an arm at the side, reels behind a window */
        float x = 0.5f * width, arm = high * dmg_range(b, 0.2f, 0.35f);
        dmg_use(b, 0);
        dmg_rod(b, v3(x, 0, -0.4f * depth), v3(x + 0.05f, 0, -0.4f * depth), 0.06f);
        dmg_hinge(b, 0, "arm", v3(x, 0, -0.4f * depth), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.4f));
        dmg_rod(b, v3(x + 0.06f, 0, -0.4f * depth), v3(x + 0.06f, arm, -0.35f * depth), 0.015f);
        dmg_ellipsoid(b, v3(x + 0.06f, arm, -0.35f * depth), v3(0.04f, 0.04f, 0.04f));
        for (int i = 0; i < 3; ++i) {
            float r = 0.16f * width, rx = 0.24f * width * (float)(i - 1) - 0.08f * width;
            dmg_use(b, 0);
            dmg_spin(b, 0, "reel", v3(rx, 0.35f * high, -0.7f * r), v3(1, 0, 0));
            dmg_rod(b, v3(rx - 0.08f * width, 0.35f * high, -0.7f * r), v3(rx + 0.08f * width, 0.35f * high, -0.7f * r),
                    r);
        }
    }
    dmg_use(b, 0);
}

/* ---- figure ---- */

/* Draws a limb of links downwards (or along `way`) from a joint, each bending about X or Z. */
static void draw_limb(dmg_builder* b, uint32_t carrier, dmg_vec at, dmg_vec way, int links, float length, float thick,
                      int style) {
    for (int i = 0; i < links; ++i) {
        bool side = i == 0 && dmg_chance(b, 0.4f);
        float lower = dmg_range(b, 0.1f, 1.2f), upper = dmg_range(b, 0.5f, 1.6f);
        dmg_vec to = v3_mad(at, way, length);
        dmg_vec axis = side ? v3(0, 0, at.x > 0 ? 1.0f : -1.0f) : v3(1, 0, 0); /* to the side: away from the trunk */
        carrier = dmg_hinge(b, carrier, i == 0 ? "limb" : "forelimb", at, axis, side ? -0.1f * lower : -lower, upper);
        if (style == 0) dmg_rod(b, at, to, thick);
        if (style == 1) dmg_beam(b, at, to, 1.8f * thick, 2.0f * thick);
        if (style == 2) dmg_cone(b, at, to, 1.1f * thick, 0.7f * thick);
        dmg_ellipsoid(b, at, v3(1.2f * thick, 1.2f * thick, 1.2f * thick));
        at = to;
        length *= 0.95f;
        thick *= 0.85f;
        if (i + 1 == links && dmg_chance(b, 0.6f))
            dmg_box(b, v3_mad(v3_add(at, v3(0, 0, 0.6f * thick)), way, 0.5f * thick),
                    v3(2 * thick, 1.6f * thick, 3 * thick));
    }
    dmg_use(b, 0);
}

/* Puppets, robots on two legs, dolls: a trunk with limbs and a head. */
void dmg_build_figure(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.1f, 2.0f), leg = high * dmg_range(b, 0.2f, 0.27f),
          trunk = high * dmg_range(b, 0.25f, 0.35f), half = high * dmg_range(b, 0.08f, 0.16f),
          thick = high * dmg_range(b, 0.02f, 0.045f);
    int style = dmg_int(b, 0, 2), body = dmg_int(b, 0, 2);
    float spread = dmg_range(b, 0.0f, 1.4f);
    dmg_move(b, 0, 2 * leg + thick, 0);
    if (body == 0) dmg_rounded_box(b, v3(0, 0.5f * trunk, 0), v3(2 * half, trunk, 1.2f * half), 0.3f * half);
    if (body == 1) dmg_cone(b, v3(0, 0, 0), v3(0, trunk, 0), 0.7f * half, half);
    if (body == 2) dmg_box(b, v3(0, 0.5f * trunk, 0), v3(1.8f * half, trunk, half));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s;
        draw_limb(b, 0, v3(x * 0.6f * half, 0, 0), v3(0, -1, 0), 2, leg, 1.2f * thick, style);
        draw_limb(b, 0, v3(x * (half + thick), 0.92f * trunk, 0), v3(x * sinf(spread), -cosf(spread), 0), 2,
                  0.75f * leg, thick, style);
    }
    float head = high * dmg_range(b, 0.06f, 0.1f);
    bool nods = dmg_chance(b, 0.4f);
    dmg_hinge(b, 0, "head", v3(0, trunk, 0), nods ? v3(1, 0, 0) : v3(0, 1, 0), -0.9f, 0.9f);
    dmg_rod(b, v3(0, trunk, 0), v3(0, trunk + 0.6f * head, 0), 0.4f * head);
    if (dmg_chance(b, 0.6f))
        dmg_ellipsoid(b, v3(0, trunk + 1.3f * head, 0), v3(0.8f * head, head, 0.9f * head));
    else
        dmg_box(b, v3(0, trunk + 1.2f * head, 0), v3(1.6f * head, 1.5f * head, 1.5f * head));
    if (dmg_chance(b, 0.5f))
        dmg_cone(b, v3(0, trunk + 1.2f * head, 0.8f * head), v3(0, trunk + 1.2f * head, 1.3f * head), 0.2f * head, 0);
    dmg_use(b, 0);
}

/* ---- gears and fairground wheels ---- */

void dmg_build_gear_train(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.01f, 0.5f), thick = radius * dmg_range(b, 0.1f, 0.5f), x = 0.0f, y = 0.0f;
    int gears = dmg_int(b, 2, 5);
    bool plate = dmg_chance(b, 0.7f), crank = dmg_chance(b, 0.3f);
    dmg_move(b, 0, 2.5f * radius, 0);
    if (dmg_chance(b, 0.3f)) dmg_face_up(b);
    float before = 0.0f, left = 0.0f, right = 0.0f;
    for (int i = 0; i < gears; ++i) {
        float own = radius * dmg_range(b, 0.5f, 1.3f), way = dmg_range(b, -0.9f, 0.9f);
        if (i > 0) {
            x += 0.95f * (own + before) * cosf(way);
            y += 0.95f * (own + before) * sinf(way);
        }
        before = own;
        left = fminf(left, x - own);
        right = fmaxf(right, x + own);
        dmg_use(b, 0);
        dmg_rod(b, v3(x, y, -thick), v3(x, y, 0.7f * thick), 0.12f * own);
        dmg_save(b);
        dmg_move(b, x, y, 0);
        uint32_t gear = dmg_spin(b, 0, "gear", v3(0, 0, 0), v3(0, 0, 1));
        int look = dmg_chance(b, 0.8f) ? 4 : dmg_int(b, 0, 3);
        dmg_wheel_draw(b, look, own, thick, dmg_int(b, 4, 8));
        if (crank && i == 0) {
            dmg_rod(b, v3(0.6f * own, 0, 0), v3(0.6f * own, 0, thick + 0.6f * own), 0.1f * own);
            dmg_rest(b, gear, 0.0f);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (plate)
        dmg_box(b, v3(0.5f * (left + right), 0.5f * y, -1.2f * thick),
                v3(right - left + radius, 2.5f * radius + fabsf(y), 0.4f * thick));
}

/* Big wheels with cabins that hang, carousels with seats. */
void dmg_build_fairground_wheel(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.2f, 20), tube = radius * dmg_range(b, 0.01f, 0.03f),
          depth = radius * dmg_range(b, 0.15f, 0.4f);
    int cabins = dmg_int(b, 3, 10);
    bool flat = dmg_chance(b, 0.35f);
    float high = flat ? 0.6f * radius : 1.35f * radius;
    if (flat) {
        dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), 0.08f * radius);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.05f * radius, 0), radius);
    } else {
        for (int s = -1; s <= 1; s += 2)
            for (int k = -1; k <= 1; k += 2)
                dmg_beam(b, v3((float)k * 0.6f * radius, 0, (float)s * 0.7f * depth),
                         v3(0, high, (float)s * 0.7f * depth), 2 * tube, 2 * tube);
        dmg_rod(b, v3(0, high, -0.75f * depth), v3(0, high, 0.75f * depth), 2 * tube);
    }
    dmg_vec hub = {0, high, 0}, axis = flat ? v3(0, 1, 0) : v3(0, 0, 1);
    uint32_t wheel = dmg_spin(b, 0, "wheel", hub, axis);
    float turn = dmg_range(b, 0, 1);
    for (int s = -1; s <= 1; s += 2) {
        if (flat && s > 0) continue;
        dmg_vec at = flat ? hub : v3(0, high, (float)s * 0.4f * depth);
        dmg_torus(b, at, axis, radius, tube);
        for (int i = 0; i < cabins; ++i) {
            float angle = turn + 2.0f * DMG_PI * (float)i / (float)cabins, c = radius * cosf(angle),
                  w = radius * sinf(angle);
            dmg_rod(b, at, flat ? v3(c, high, w) : v3(c, high + w, at.z), 0.6f * tube);
        }
    }
    for (int i = 0; i < cabins; ++i) {
        float angle = turn + 2.0f * DMG_PI * (float)i / (float)cabins, c = radius * cosf(angle),
              w = radius * sinf(angle), size = fminf(0.35f * radius, 2.2f * radius / (float)cabins) * 0.6f;
        dmg_vec at = flat ? v3(c, high, w) : v3(c, high + w, 0);
        uint32_t cabin = wheel;
        if (!flat && i < 6) cabin = dmg_spin(b, wheel, "cabin", at, v3(0, 0, 1));
        dmg_use(b, cabin);
        dmg_rod(b, v3_add(at, v3(0, -0.4f * size, 0)), at, 0.5f * tube);
        if (!flat) dmg_rod(b, v3_add(at, v3(0, 0, -0.4f * depth)), v3_add(at, v3(0, 0, 0.4f * depth)), 0.5f * tube);
        dmg_box(b, v3_add(at, v3(0, -0.8f * size, 0)), v3(size, 0.9f * size, flat ? size : 0.6f * depth));
    }
    dmg_use(b, 0);
}

/* ---- mixers, drills, presses ---- */

void dmg_build_mixer(dmg_builder* b) {
    float size = dmg_range(b, 0.15f, 0.4f), wide = size * dmg_range(b, 0.3f, 0.5f),
          high = size * dmg_range(b, 0.7f, 1.1f), head = size * dmg_range(b, 0.25f, 0.4f),
          up = dmg_range(b, 0.4f, 1.0f), bowl = size * dmg_range(b, 0.25f, 0.4f);
    dmg_rounded_box(b, v3(0, 0.05f * size, 0), v3(0.8f * size, 0.1f * size, 1.3f * size), 0.04f * size);
    dmg_rounded_box(b, v3(0, 0.5f * high, -0.45f * size), v3(wide, high, 0.3f * size), 0.1f * wide);
    const dmg_xy cup[] = {{0, 0},
                          {0.5f * bowl, 0},
                          {bowl, 0.6f * high},
                          {0.95f * bowl, 0.6f * high},
                          {0.45f * bowl, 0.05f * high},
                          {0, 0.05f * high}};
    int bowl_moves = dmg_int(b, 0, 2);
    if (bowl_moves == 1) dmg_spin(b, 0, "bowl", v3(0, 0, 0.25f * size), v3(0, 1, 0));
    dmg_lathe(b, v3(0, 0.1f * size, 0.25f * size), v3(0, 1, 0), cup, 6);
    dmg_use(b, 0);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.7f)) carrier = dmg_hinge(b, 0, "head", v3(0, high, -0.45f * size), v3(-1, 0, 0), 0.0f, up);
    dmg_rounded_box(b, v3(0, high + 0.5f * head, 0), v3(wide, head, 1.2f * size), 0.2f * head);
    dmg_rod(b, v3(0, high - 0.05f * size, 0.25f * size), v3(0, high + 0.1f * head, 0.25f * size), 0.12f * size);
    dmg_spin(b, carrier, "whisk", v3(0, high, 0.25f * size), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.35f * high, 0.25f * size), v3(0, high, 0.25f * size), 0.025f * size);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(0, 0.4f * high, 0.25f * size), v3(0.4f * bowl, 0.2f * high, 0.4f * bowl));
    else
        dmg_box(b, v3(0, 0.4f * high, 0.25f * size), v3(0.8f * bowl, 0.25f * high, 0.05f * bowl));
    dmg_use(b, carrier);
    dmg_save(b);
    dmg_move(b, 0.5f * wide, high + 0.5f * head, -0.1f * size);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_knobs_draw(b, carrier, 1, 0, 0, 0.2f * head);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_power_tool(dmg_builder* b) {
    float length = dmg_range(b, 0.12f, 0.35f), radius = length * dmg_range(b, 0.12f, 0.2f),
          grip = length * dmg_range(b, 0.45f, 0.8f), thick = radius * dmg_range(b, 0.5f, 0.8f);
    int kind = dmg_int(b, 0, 2); /* drill, saw, grinder */
    dmg_move(b, 0, grip + radius, 0);
    dmg_rod(b, v3(0, 0, -0.5f * length), v3(0, 0, 0.3f * length), radius);
    dmg_cone(b, v3(0, 0, 0.3f * length), v3(0, 0, 0.4f * length), radius, 0.5f * radius);
    dmg_beam(b, v3(0, 0, -0.25f * length), v3(0, -grip, -0.35f * length), 1.4f * thick, 2 * thick);
    if (dmg_chance(b, 0.6f))
        dmg_rounded_box(b, v3(0, -grip, -0.3f * length), v3(2 * thick, 0.25f * grip, 0.4f * length), 0.3f * thick);
    dmg_vec pin = {0, -0.9f * radius, -0.25f * length + 0.9f * thick};
    if (dmg_chance(b, 0.5f))
        dmg_slide(b, 0, "trigger", v3(0, 0, -1), 0.0f, 0.4f * thick);
    else
        dmg_hinge(b, 0, "trigger", pin, v3(1, 0, 0), 0.0f, 0.3f);
    dmg_rounded_box(b, v3(0, pin.y - 0.15f * grip, pin.z + 0.15f * thick), v3(thick, 0.3f * grip, 0.7f * thick),
                    0.15f * thick);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.4f * length);
    if (kind == 2) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    if (kind == 1) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, 0, kind == 0 ? "chuck" : "blade", v3(0, 0, 0), v3(0, 0, 1));
    if (kind == 0) {
        dmg_cone(b, v3(0, 0, 0), v3(0, 0, 0.15f * length), 0.6f * radius, 0.35f * radius);
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.5f * length), 0.1f * radius);
    } else {
        dmg_rod(b, v3(0, 0, -0.05f * radius), v3(0, 0, 0.05f * radius), radius * dmg_range(b, 1.2f, 2.2f));
        dmg_rod(b, v3(0, 0, -0.5f * radius), v3(0, 0, 0.2f * radius), 0.3f * radius);
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* forward and reverse */
        dmg_slide(b, 0, "direction", v3(dmg_sign(b), 0, 0), 0.0f, 0.3f * radius);
        dmg_rod(b, v3(-1.2f * radius, -0.6f * radius, -0.1f * length),
                v3(1.2f * radius, -0.6f * radius, -0.1f * length), 0.15f * radius);
        dmg_use(b, 0);
    }
}

/* An arm or a lid that comes down on a bed: waffle irons, paper cutters, juice presses, sewing heads. */
void dmg_build_press(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 0.8f), depth = size * dmg_range(b, 0.6f, 1.4f),
          bed = size * dmg_range(b, 0.05f, 0.3f), t = size * dmg_range(b, 0.03f, 0.2f),
          opened = dmg_range(b, 0.6f, 1.8f);
    int kind = dmg_int(b, 0, 3);
    bool round = dmg_chance(b, 0.3f) && kind == 0;
    if (round)
        dmg_rod(b, v3(0, 0, 0), v3(0, bed, 0), 0.5f * size);
    else
        dmg_box(b, v3(0, 0.5f * bed, 0), v3(size, bed, depth));
    if (kind == 0) { /* a lid of the same outline */
        float back = round ? -0.5f * size : -0.5f * depth;
        dmg_hinge(b, 0, "lid", v3(0, bed + dmg_range(b, 0.0f, 1.0f) * t, back), v3(-1, 0, 0), 0.0f, opened);
        if (round)
            dmg_rod(b, v3(0, bed, 0), v3(0, bed + t, 0), 0.5f * size);
        else
            dmg_box(b, v3(0, bed + 0.5f * t, 0), v3(size, t, depth));
        if (dmg_chance(b, 0.7f))
            dmg_box(b, v3(0, bed + 0.5f * t, round ? 0.6f * size : 0.57f * depth),
                    v3(0.3f * size, 0.4f * t, 0.2f * size));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, bed + 0.3f * t, back), v3(0.4f * size, 0.8f * t, 0.08f * size));
    }
    if (kind == 1) { /* a blade along one side */
        float x = 0.5f * size + 0.02f * size;
        dmg_hinge(b, 0, "blade", v3(x, bed, -0.48f * depth), v3(-1, 0, 0), 0.0f, opened);
        dmg_box(b, v3(x, bed + 0.5f * t, 0.05f * depth), v3(0.03f * size, t, 1.1f * depth));
        dmg_rod(b, v3(x, bed + 0.6f * t, 0.6f * depth), v3(x, bed + 0.6f * t, 0.8f * depth), 0.4f * t);
    }
    if (kind >= 2) { /* a post with an arm that levers a plunger down */
        float high = size * dmg_range(b, 0.8f, 1.5f), arm = size * dmg_range(b, 0.6f, 1.2f), stroke = 0.3f * high;
        dmg_box(b, v3(0, 0.5f * high, -0.4f * depth), v3(0.2f * size, high, 0.2f * size));
        dmg_box(b, v3(0, 0.9f * high, -0.1f * depth), v3(0.18f * size, 0.15f * high, 0.8f * depth));
        dmg_slide(b, 0, "plunger", v3(0, -1, 0), 0.0f, stroke);
        dmg_rod(b, v3(0, 0.55f * high, 0.1f * depth), v3(0, 1.05f * high, 0.1f * depth), 0.05f * size);
        dmg_rod(b, v3(0, 0.5f * high, 0.1f * depth), v3(0, 0.56f * high, 0.1f * depth),
                size * dmg_range(b, 0.1f, 0.3f));
        dmg_use(b, 0);
        dmg_vec pin = {0.13f * size, 0.95f * high, -0.3f * depth};
        dmg_hinge(b, 0, "arm", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_rod(b, v3_add(pin, v3(-0.05f * size, 0, 0)), v3_add(pin, v3(0.05f * size, 0, 0)), 0.06f * size);
        dmg_beam(b, pin, v3_add(pin, v3(0.02f * size, 0.5f * arm, arm)), 0.05f * size, 0.08f * size);
    }
    dmg_use(b, 0);
}

/* ---- scales ---- */

void dmg_build_balance(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.1f, 1.0f), half = high * dmg_range(b, 0.4f, 0.8f),
          pan = half * dmg_range(b, 0.25f, 0.5f), thin = high * dmg_range(b, 0.01f, 0.03f),
          drop = high * dmg_range(b, 0.2f, 0.6f), tilt = dmg_range(b, 0.15f, 0.4f);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.08f * high, 0), 0.4f * half, 0.2f * half);
    dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), 1.5f * thin);
    uint32_t beam = dmg_hinge(b, 0, "beam", v3(0, high, 0), v3(0, 0, 1), -tilt, tilt);
    dmg_beam(b, v3(-half, high, 0), v3(half, high, 0), thin, 2 * thin);
    dmg_rod(b, v3(0, high, -2 * thin), v3(0, high, 2 * thin), 2 * thin);
    if (dmg_chance(b, 0.4f)) dmg_cone(b, v3(0, high, 1.5f * thin), v3(0, 0.6f * high, 1.5f * thin), 0.6f * thin, 0);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec at = {(float)s * half, high, 0};
        if (dmg_chance(b, 0.7f))
            dmg_hinge(b, beam, "pan", at, v3(0, 0, 1), -0.6f, 0.6f);
        else
            dmg_spin(b, beam, "pan", at, v3(0, 1, 0));
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f;
            dmg_rod(b, v3(at.x + pan * cosf(angle), high - drop, pan * sinf(angle)), at, 0.3f * thin);
        }
        const dmg_xy bowl[] = {{0, -0.25f * pan}, {0.6f * pan, -0.2f * pan},   {pan, 0},
                               {0.95f * pan, 0},  {0.55f * pan, -0.15f * pan}, {0, -0.2f * pan}};
        dmg_lathe(b, v3(at.x, high - drop, 0), v3(0, 1, 0), bowl, 6);
        dmg_use(b, beam);
    }
    dmg_use(b, 0);
}

/* ---- slats ---- */

/* Blinds, louvres, radiator shutters: slats that turn about their own long lines. */
void dmg_build_slats(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.2f, 2.0f), slat = width * dmg_range(b, 0.04f, 0.15f),
          t = slat * dmg_range(b, 0.04f, 0.15f), turned = dmg_range(b, -0.7f, 0.7f), swing = dmg_range(b, 0.6f, 1.5f);
    int count = dmg_int(b, 4, 14), profile = dmg_int(b, 0, 2);
    float height = 0.95f * slat * (float)count, at = dmg_chance(b, 0.7f) ? 0.0f : dmg_range(b, -0.45f, 0.45f);
    bool upright = dmg_chance(b, 0.4f);
    dmg_move(b, 0, 0.5f * fmaxf(width, height) + 2 * slat, 0);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (dmg_chance(b, 0.7f))
        dmg_frame_draw(b, width + 3 * t + slat, height + slat, slat * dmg_range(b, 0.3f, 1.2f), 0.4f * slat);
    else
        dmg_box(b, v3(0, 0.5f * height + 0.3f * slat, 0), v3(width, 0.4f * slat, slat));
    for (int i = 0; i < count; ++i) {
        float y = height * (((float)i + 0.5f) / (float)count - 0.5f);
        dmg_save(b);
        dmg_move(b, 0, y, -0.3f * slat);
        uint32_t one = dmg_hinge(b, 0, "slat", v3(0, at * slat, 0), v3(1, 0, 0), -swing, swing);
        if (profile == 0) dmg_box(b, v3(0, 0, 0), v3(width, slat, t));
        if (profile == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(width, slat, 2 * t), t);
        if (profile == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * width, 0.5f * slat, t));
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(-0.5f * width - t, at * slat, 0), v3(0.5f * width + t, at * slat, 0), 0.5f * t);
        dmg_rest(b, one, turned * swing);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
