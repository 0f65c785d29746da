/* Draws task boards of manipulation benchmarks and busy boards: small mechanisms on a frame, a box or a board. */
#include "core/build.h"
#include "parts/hardware.h"

/* Every task is drawn on z = 0 facing +Z, round the origin, within half a width `w` and half a height `h`. */

/* ---- handles of doors ---- */

/* Draws a lever or a knob that turns in the leaf, on the leaf's front z = 0; it points along -X for `side` 1. */
static void draw_lever_handle(dmg_builder* b, uint32_t leaf, float reach, float side) {
    float t = reach * dmg_range(b, 0.08f, 0.16f), out = reach * dmg_range(b, 0.2f, 0.5f);
    int kind = dmg_int(b, 0, 4), rose = dmg_int(b, 0, 2);
    dmg_use(b, leaf);
    if (rose == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * t), 1.6f * t);
    if (rose == 1) dmg_box(b, v3(0, -0.3f * reach, 0.15f * t), v3(2.4f * t, 1.4f * reach, 0.3f * t));
    float swing = dmg_range(b, 0.5f, 1.5f);
    dmg_vec axis = {0, 0, side};
    if (dmg_chance(b, 0.8f))
        dmg_hinge(b, leaf, "handle", v3(0, 0, 0), axis, dmg_chance(b, 0.3f) ? -swing : 0.0f, swing);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 0.6f * t);
    dmg_vec root = {0, 0, out - 0.5f * t}, end = {-side * reach, 0, out - 0.5f * t};
    if (kind == 0) dmg_beam(b, v3_mad(root, v3(side, 0, 0), 0.6f * t), end, t, 1.2f * t);
    if (kind == 1) dmg_rod(b, root, end, 0.6f * t);
    if (kind == 2) { /* turned back at its end */
        dmg_beam(b, root, end, t, t);
        dmg_beam(b, end, v3(end.x, 0, 0.3f * out), t, t);
    }
    if (kind == 3) dmg_cone(b, root, v3(end.x, -0.15f * reach, root.z), 0.7f * t, 0.4f * t);
    if (kind == 4) dmg_box(b, v3(0, 0, root.z), v3(1.4f * reach, 1.3f * t, t)); /* a bar across the middle */
    dmg_use(b, leaf);
}

/* Draws a leaf in a frame, on its edge or in a hole, with a lever, a pull or a knob. */
static void draw_door_task(dmg_builder* b, float w, float h) {
    float t = fminf(w, h) * dmg_range(b, 0.04f, 0.15f), post = fminf(w, h) * dmg_range(b, 0.06f, 0.2f),
          side = dmg_sign(b), deep = t * dmg_range(b, 1.0f, 2.5f), x = w - post, y = h - post,
          open = dmg_range(b, 1.0f, 1.9f);
    bool framed = dmg_chance(b, 0.7f);
    dmg_move(b, 0, 0, deep);
    if (framed) dmg_frame_draw(b, 2 * w, 2 * h, deep, 1.02f * post);
    if (!framed) dmg_box(b, v3(side * (w - 0.5f * post), 0, 0), v3(post, 2 * h, deep));
    dmg_save(b);
    if (!framed) dmg_move(b, 0, 0, 0.5f * deep);
    float line = side * (x - (dmg_chance(b, 0.5f) ? 0.0f : 0.5f * t));
    uint32_t leaf = dmg_hinge(b, 0, "door", v3(line, 0, 0), v3(0, side, 0), 0.0f, open);
    dmg_box(b, v3(0, 0, -0.5f * t), v3(1.97f * x, 1.97f * y, t));
    int knuckles = dmg_int(b, 0, 3);
    for (int i = 0; i < knuckles && knuckles > 1; ++i) {
        float at = 0.75f * y * (2.0f * (float)i / (float)(knuckles - 1) - 1.0f);
        dmg_rod(b, v3(line, at - 0.1f * y, 0), v3(line, at + 0.1f * y, 0), 0.35f * t);
    }
    float edge = dmg_range(b, 0.6f, 0.85f);
    dmg_move(b, -side * x * edge, y * dmg_range(b, -0.3f, 0.3f), 0);
    if (dmg_chance(b, 0.65f))
        draw_lever_handle(b, leaf, x * dmg_range(b, 0.25f, 0.6f), -side);
    else {
        dmg_handle handle = dmg_handle_pick(b, 0.6f * y);
        dmg_handle_draw(b, &handle, 0.8f * y);
    }
    dmg_restore(b);
}

/* ---- what slides ---- */

/* Draws a pane that slides behind or before its frame, pushed by a post or a bar that stands out of it. */
static void draw_window_task(dmg_builder* b, float w, float h) {
    float t = fminf(w, h) * dmg_range(b, 0.05f, 0.12f), grip = t * dmg_range(b, 0.6f, 1.6f),
          out = t * dmg_range(b, 1.5f, 5.0f), side = dmg_sign(b);
    dmg_move(b, 0, 0, 3 * t);
    dmg_frame_draw(b, 2 * w, 2 * h, 3 * t, 1.5f * t);
    if (dmg_chance(b, 0.6f)) /* the pane that stays */
        dmg_box(b, v3(-side * 0.5f * w, 0, -2.2f * t), v3(w, 2 * h - 2.5f * t, 0.5f * t));
    dmg_slide(b, 0, "pane", v3(-side, 0, 0), 0.0f, 0.95f * (w - 1.5f * t));
    float x = side * (0.5f * w - 0.7f * t);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(x, 0, -t), v3(w - 1.5f * t, 2 * h - 3.1f * t, 0.5f * t));
    else {
        dmg_save(b);
        dmg_move(b, x, 0, -0.6f * t);
        dmg_frame_draw(b, w - 1.5f * t, 2 * h - 3.1f * t, 0.8f * t, t);
        dmg_restore(b);
        dmg_box(b, v3(x, 0, -t), v3(w - 3 * t, 2 * h - 5 * t, 0.2f * t));
    }
    float edge = side * 2.2f * t, z = -0.8f * t;
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(edge, 0, z), v3(edge, 0, z + out), 0.5f * grip);
    else
        dmg_box(b, v3(edge, 0, z + 0.5f * out), v3(grip, 0.8f * h, out));
    dmg_use(b, 0);
}

static void draw_drawer_task(dmg_builder* b, float w, float h) {
    float wall = fminf(w, h) * dmg_range(b, 0.05f, 0.15f), deep = w * dmg_range(b, 0.8f, 2.0f), t = wall;
    dmg_move(b, 0, 0, deep);
    dmg_case_draw(b, dmg_case_pick(b), 2 * w, 2 * h, deep, wall);
    dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, deep * dmg_range(b, 0.4f, 0.8f));
    bool over = dmg_chance(b, 0.4f);
    float x = over ? w : w - 1.1f * wall, y = over ? h : h - 1.1f * wall;
    dmg_box(b, v3(0, 0, 0.5f * t), v3(2 * x, 2 * y, t));
    dmg_save(b);
    dmg_move(b, 0, -y + wall, 0);
    dmg_tray_draw(b, dmg_chance(b, 0.6f) ? DMG_TRAY_BOARDS : DMG_TRAY_SHEET, 2 * (w - 1.2f * wall), h, 0.85f * deep,
                  0.6f * wall);
    dmg_restore(b);
    dmg_move(b, 0, 0, t);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_box(b, v3(0, 0, 0.15f * w), v3(0.15f * w, 0.15f * w, 0.3f * w));
    if (kind == 1) { /* a wide bracket */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.4f * w, 0, 0.15f * w), v3(0.08f * w, 0.1f * w, 0.3f * w));
        dmg_box(b, v3(0, 0, 0.3f * w), v3(0.88f * w, 0.1f * w, 0.08f * w));
    }
    if (kind == 2) dmg_knob_draw(b, 3, 0.15f * w, 0.25f * w);
    dmg_use(b, 0);
}

/* Draws a grip on a carriage in a slot, on two rails or on a strip. */
static void draw_slider_task(dmg_builder* b, float w, float h) {
    bool upright = h > w;
    float longer = fmaxf(w, h), t = longer * dmg_range(b, 0.03f, 0.1f), grip = longer * dmg_range(b, 0.08f, 0.25f),
          out = longer * dmg_range(b, 0.1f, 0.5f), way = 0.9f * longer - grip;
    int track = dmg_int(b, 0, 2), shape = dmg_int(b, 0, 3);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (track == 0) dmg_box(b, v3(0, 0, 0.5f * t), v3(2 * longer, 2 * t, t));
    for (int s = -1; s <= 1 && track == 1; s += 2)
        dmg_rod(b, v3(-longer, (float)s * 1.2f * t, 1.5f * t), v3(longer, (float)s * 1.2f * t, 1.5f * t), 0.5f * t);
    for (int s = -1; s <= 1 && track == 1; s += 2) dmg_box(b, v3((float)s * longer, 0, t), v3(t, 4 * t, 2.2f * t));
    if (track == 2)
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, (float)s * 1.2f * t, 0.7f * t), v3(2 * longer, t, 1.4f * t));
    uint32_t slide = dmg_slide(b, 0, "slider", v3(dmg_sign(b), 0, 0), -way, way);
    int rest = dmg_int(b, 0, 2);
    if (rest < 2) dmg_rest(b, slide, rest ? -way : way);
    float foot = track == 2 ? 0.0f : 2.2f * t;
    if (track != 2) dmg_box(b, v3(0, 0, track ? 1.8f * t : 1.3f * t), v3(2 * grip, 4 * t, 1.4f * t));
    if (shape == 0) dmg_rod(b, v3(0, 0, foot), v3(0, 0, foot + out), 0.5f * t);
    if (shape == 1) dmg_box(b, v3(0, 0, foot + 0.5f * out), v3(0.6f * grip, 1.2f * t, out));
    if (shape == 2) {
        dmg_rod(b, v3(0, 0, foot), v3(0, 0, foot + out), 0.4f * t);
        dmg_ellipsoid(b, v3(0, 0, foot + out), v3(grip, grip, grip));
    }
    if (shape == 3) dmg_rounded_box(b, v3(0, 0, foot + 0.3f * grip), v3(grip, 3 * t, 0.6f * grip), 0.1f * t);
    dmg_use(b, 0);
}

/* Prongs, a cable's plug or a peg pulled out of a socket; a bolt that slides through staples. */
static void draw_plug_task(dmg_builder* b, float w, float h) {
    float r = fminf(w, h) * dmg_range(b, 0.3f, 0.7f), deep = r * dmg_range(b, 0.5f, 1.5f),
          reach = r * dmg_range(b, 0.8f, 2.5f);
    int kind = dmg_int(b, 0, 3), round = dmg_int(b, 0, 1);
    if (round)
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1),
                  (const dmg_xy[]){{1.4f * r, 0}, {1.4f * r, 0.5f * deep}, {1.1f * r, 0.5f * deep}, {1.1f * r, 0}}, 4);
    if (!round) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * deep);
        dmg_frame_draw(b, 2.8f * r, 2.8f * r, 0.5f * deep, 0.3f * r);
        dmg_restore(b);
    }
    dmg_slide(b, 0, kind == 3 ? "peg" : "plug", v3(0, 0, 1), 0.0f, deep + reach * dmg_range(b, 0.3f, 1.0f));
    if (kind == 3)
        dmg_rod(b, v3(0, 0, 0.02f * r), v3(0, 0, deep + reach), dmg_range(b, 0.4f, 1.0f) * r);
    else {
        float body = dmg_range(b, 0.7f, 1.0f);
        if (round)
            dmg_cone(b, v3(0, 0, 0.2f * deep), v3(0, 0, reach), body * r, 0.7f * body * r);
        else
            dmg_box(b, v3(0, 0, 0.1f * deep + 0.5f * reach), v3(1.6f * body * r, 1.8f * body * r, reach));
        if (kind == 1) dmg_rod(b, v3(0, 0, reach), v3(0, -0.2f * r, reach + 1.5f * r), 0.18f * r);
        if (kind == 2) dmg_box(b, v3(0, 0, reach), v3(2 * r, 0.5f * r, 0.4f * r));
    }
    dmg_use(b, 0);
}

static void draw_bolt_task(dmg_builder* b, float w, float h) {
    float t = fminf(w, h) * dmg_range(b, 0.08f, 0.2f), half = 0.8f * w, way = half * dmg_range(b, 0.3f, 0.7f);
    int staples = dmg_int(b, 2, 3);
    for (int i = 0; i < staples; ++i) {
        float x = i == 2 ? half : half * ((float)i * 1.1f - 0.9f);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_bent_plate(b,
                       (const dmg_xy[]){{0, -1.6f * t}, {-2.6f * t, -1.4f * t}, {-2.6f * t, 1.4f * t}, {0, 1.6f * t}},
                       4, 0.3f * t, 1.5f * t);
        dmg_restore(b);
    }
    bool turns = dmg_chance(b, 0.3f);
    float tail = -half * 1.2f;
    dmg_slide(b, 0, "bolt", v3(1, 0, 0), turns ? -0.3f * way : 0.0f, way);
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(tail, 0, 1.2f * t), v3(0.3f * half, 0, 1.2f * t), t);
    else
        dmg_box(b, v3(0.5f * (tail + 0.3f * half), 0, 1.2f * t), v3(0.3f * half - tail, 1.8f * t, 1.8f * t));
    dmg_rod(b, v3(-0.55f * half, 0, 1.2f * t), v3(-0.55f * half, -1.8f * t, 4 * t), 0.5f * t);
    dmg_use(b, 0);
}

/* ---- what turns ---- */

/* Draws a lever beside or on a block that goes up and down, or round in the board's plane. */
static void draw_lever_task(dmg_builder* b, float w, float h) {
    float s = fminf(w, h), t = s * dmg_range(b, 0.06f, 0.18f), reach = s * dmg_range(b, 0.6f, 1.5f),
          swing = dmg_range(b, 0.4f, 1.4f);
    if (dmg_chance(b, 0.5f)) { /* an arm on a hub, in the plane */
        float lean = dmg_range(b, -1.2f, 1.2f), z = 2 * t;
        dmg_vec end = {reach * sinf(lean), reach * cosf(lean), z};
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 1.5f * t), 1.6f * t);
        dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, z - 0.5f * t), v3(0, 0, z + 0.5f * t), 1.4f * t);
        dmg_beam(b, v3(0, 0, z), end, t, t);
        if (dmg_chance(b, 0.7f)) dmg_rod(b, end, v3(end.x, end.y, z + 4 * t), 0.6f * t);
        dmg_use(b, 0);
        return;
    }
    float half = s * dmg_range(b, 0.1f, 0.4f), z = s * dmg_range(b, 0.25f, 0.6f), lean = dmg_range(b, -0.4f, 0.4f);
    for (int side = -1; side <= 1; side += 2) {
        if (side > 0 && dmg_chance(b, 0.4f)) continue;
        dmg_box(b, v3((float)side * (half + 0.7f * t), 0, 0.6f * z), v3(t, 3 * t, 1.2f * z));
    }
    dmg_hinge(b, 0, "lever", v3(0, 0, z), v3(dmg_sign(b), 0, 0), -swing, swing);
    dmg_rod(b, v3(-half - t, 0, z), v3(half + t, 0, z), 0.6f * t);
    dmg_vec end = {0, reach * sinf(lean), z + reach * cosf(lean)};
    dmg_beam(b, v3(0, 0, z), end, t, t);
    int grip = dmg_int(b, 0, 2);
    if (grip == 0) dmg_ellipsoid(b, end, v3(1.3f * t, 1.3f * t, 1.3f * t));
    if (grip == 1) dmg_rod(b, v3(-half, end.y, end.z), v3(half, end.y, end.z), 0.8f * t);
    dmg_use(b, 0);
}

/* Dials with scales, winged nuts, keys in locks, taps with an arm, handwheels, nuts that screw down. */
static void draw_dial_task(dmg_builder* b, float w, float h) {
    float r = fminf(w, h) * dmg_range(b, 0.4f, 0.9f), high = r * dmg_range(b, 0.2f, 1.2f), t = 0.1f * r,
          plate = r * dmg_range(b, 0.02f, 0.3f);
    int kind = dmg_int(b, 0, 5), ticks = dmg_chance(b, 0.5f) ? dmg_int(b, 4, 11) : 0;
    if (dmg_chance(b, 0.7f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, plate), 1.05f * r);
    for (int i = 0; i < ticks; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, ticks + 1);
        dmg_box(b, v3(0, 1.2f * r, 0.2f * t), v3(0.5f * t, 2 * t, 0.5f * t));
        dmg_restore(b);
    }
    dmg_move(b, 0, 0, plate);
    if (kind == 5) {
        float thread = r * dmg_range(b, 0.03f, 0.12f), turns = 0.8f * high / thread;
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 2.5f * high), 0.4f * r);
        dmg_screw(b, 0, "nut", v3(0, 0, 0), v3(0, 0, 1), thread, 0.0f, fminf(turns, 30.0f));
        dmg_xy hexagon[6];
        for (int i = 0; i < 6; ++i)
            hexagon[i] = (dmg_xy){0.9f * r * cosf(DMG_PI * (float)i / 3), 0.9f * r * sinf(DMG_PI * (float)i / 3)};
        dmg_extrude(b, hexagon, 6, 0, high);
        dmg_use(b, 0);
        return;
    }
    float swing = dmg_range(b, 0.6f, 2.8f), back = dmg_chance(b, 0.5f) ? 0.0f : swing;
    if (dmg_chance(b, 0.4f))
        dmg_spin(b, 0, "dial", v3(0, 0, 0), v3(0, 0, 1));
    else
        dmg_hinge(b, 0, "dial", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -back, swing);
    if (kind <= 1) dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.85f * r, high);
    if (kind == 2) { /* a key */
        dmg_box(b, v3(0, 0, 0.3f * high), v3(t, 4 * t, 0.8f * high));
        dmg_box(b, v3(0, 0, 0.9f * high), v3(1.5f * t, 1.2f * r, 0.5f * high));
    }
    if (kind == 3) { /* a column with an arm */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, high), 0.4f * r);
        dmg_beam(b, v3(0, -0.2f * r, 0.9f * high), v3(0, 1.8f * r, 0.9f * high), 2 * t, 2 * t);
    }
    if (kind == 4) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, high), 0.15f * r);
        dmg_move(b, 0, 0, high);
        int wheel = 2 * dmg_int(b, 0, 3);
        dmg_wheel_draw(b, wheel, r, 1.5f * t, dmg_int(b, 3, 6));
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0.8f * r, 0), v3(0, 0.8f * r, 0.6f * r), 1.2f * t);
    }
    dmg_use(b, 0);
}

/* Hook latches, swivel tags, hasps, toggles: small plates on one screw. */
static void draw_tag_task(dmg_builder* b, float w, float h) {
    float s = fminf(w, h), t = s * dmg_range(b, 0.05f, 0.12f), reach = s * dmg_range(b, 0.7f, 1.4f),
          wide = s * dmg_range(b, 0.2f, 0.5f);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) { /* turns on its screw, lying on the board */
        float at = dmg_chance(b, 0.5f) ? 0.0f : 0.4f * reach;
        dmg_box(b, v3(0, -0.8f * s, 0.5f * t), v3(1.2f * wide, 0.4f * s, t));
        dmg_move(b, 0, 0.2f * s, t);
        dmg_spin(b, 0, "tag", v3(0, 0, 0), v3(0, 0, 1));
        dmg_box(b, v3(0, -at, 0.5f * t), v3(0.6f * wide, reach, t));
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, 0.5f * t), v3(0, 0, 1.5f * t), 0.15f * wide);
    }
    if (kind == 1) { /* a strap hinged at the board, over a staple */
        dmg_box(b, v3(-0.7f * reach, 0, 0.5f * t), v3(0.5f * reach, wide, t));
        dmg_torus(b, v3(0.4f * reach, 0, 0), v3(0, 1, 0), 0.2f * wide, 0.5f * t);
        dmg_hinge(b, 0, "hasp", v3(-0.42f * reach, 0, 0.8f * t), v3(0, -1, 0), 0.0f, dmg_range(b, 1.6f, 2.8f));
        dmg_rod(b, v3(-0.42f * reach, -0.5f * wide, 0.8f * t), v3(-0.42f * reach, 0.5f * wide, 0.8f * t), 0.6f * t);
        dmg_box(b, v3(0.1f * reach, 0, 1.0f * t), v3(1.05f * reach, wide, 0.5f * t));
    }
    if (kind == 2) { /* a hook of wire from eye to eye */
        for (int e = -1; e <= 1; e += 2)
            dmg_rod(b, v3((float)e * 0.7f * reach, 0, 0), v3((float)e * 0.7f * reach, 0, 2 * t), 0.5f * t);
        dmg_hinge(b, 0, "hook", v3(-0.7f * reach, 0, t), v3(0, 0, 1), 0.0f, dmg_range(b, 1.2f, 3.0f));
        dmg_torus(b, v3(-0.7f * reach, 0, 1.2f * t), v3(0, 0, 1), 1.1f * t, 0.35f * t);
        dmg_rod(b, v3(-0.7f * reach + t, 0, 1.2f * t), v3(0.6f * reach, 0.3f * t, 1.2f * t), 0.35f * t);
        dmg_rod(b, v3(0.6f * reach, 0.3f * t, 1.2f * t), v3(0.85f * reach, 1.2f * t, 1.2f * t), 0.35f * t);
    }
    dmg_use(b, 0);
}

static void draw_button_task(dmg_builder* b, float w, float h) {
    float s = fminf(w, h) * dmg_range(b, 0.5f, 1.0f), collar = s * dmg_range(b, 0.1f, 1.0f),
          rise = s * dmg_range(b, 0.15f, 0.7f);
    int kind = dmg_int(b, 0, 3);
    if (dmg_chance(b, 0.5f))
        dmg_holed_plate_draw(b, 2 * s, 2 * s, collar, 0.75f * s);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1),
                  (const dmg_xy[]){{s, 0}, {s, collar}, {0.75f * s, collar}, {0.75f * s, 0}}, 4);
    dmg_move(b, 0, 0, 0.1f * collar);
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, rise * dmg_range(b, 0.3f, 0.9f));
    if (kind < 2) dmg_rod(b, v3(0, 0, 0), v3(0, 0, collar + rise), 0.68f * s);
    if (kind == 2) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, collar + 0.5f * rise), 0.3f * s);
        dmg_cone(b, v3(0, 0, collar + 0.6f * rise), v3(0, 0, collar + 1.2f * rise), 0.9f * s, 0.7f * s);
    }
    if (kind == 3) dmg_box(b, v3(0, 0, 0.5f * (collar + rise)), v3(0.95f * s, 0.95f * s, collar + rise));
    dmg_use(b, 0);
}

/* ---- where the tasks are ---- */

static void draw_task(dmg_builder* b, float w, float h) {
    static void (*const tasks[])(dmg_builder*, float, float) = {
        draw_door_task, draw_window_task, draw_drawer_task, draw_slider_task, draw_plug_task,
        draw_bolt_task, draw_lever_task,  draw_dial_task,   draw_tag_task,    draw_button_task};
    static const float weights[] = {2.5f, 1, 1, 1.5f, 1.2f, 1, 1.5f, 1.5f, 1.5f, 1};
    dmg_save(b);
    dmg_use(b, 0);
    tasks[dmg_weighted(b, weights, 10)](b, w, h);
    dmg_use(b, 0);
    dmg_restore(b);
}

/* Draws a grid of tasks on a board whose front is z = 0, centred. */
static void draw_task_grid(dmg_builder* b, int columns, int rows, float w, float h, float t) {
    dmg_box(b, v3(0, 0, -0.5f * t), v3(2 * w, 2 * h, t));
    float cell_w = w / (float)columns, cell_h = h / (float)rows, fill = dmg_range(b, 0.65f, 0.97f);
    for (int i = 0; i < columns * rows; ++i) {
        if (i > 0 && dmg_chance(b, 0.15f)) continue;
        dmg_save(b);
        dmg_move(b, cell_w * (float)(2 * (i % columns) + 1) - w, cell_h * (float)(2 * (i / columns) + 1) - h, 0);
        draw_task(b, fill * cell_w, fill * cell_h);
        dmg_restore(b);
    }
}

/* Draws a board that stands on feet, leans on a stay, lies on legs or on the ground. */
static void draw_board(dmg_builder* b, float size) {
    int columns = dmg_int(b, 1, 4), rows = dmg_int(b, 1, 3), pose = dmg_int(b, 0, 2);
    float w = size, h = size * (float)rows / (float)columns * dmg_range(b, 0.7f, 1.3f),
          t = size * dmg_range(b, 0.03f, 0.12f), up = dmg_chance(b, 0.5f) ? 0.0f : size * dmg_range(b, 0.2f, 1.0f);
    if (pose == 0) {
        float foot = 0.5f * h + 2 * t;
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.9f * w;
            dmg_box(b, v3(x, 0.5f * t, 0), v3(1.5f * t, t, foot));
            if (up > 0) dmg_box(b, v3(x, 0.5f * up + t, -1.5f * t), v3(t, up + t, t));
        }
        dmg_move(b, 0, h + up + t, 0);
    }
    if (pose == 1) {
        float lean = dmg_range(b, 0.3f, 1.1f);
        dmg_vec back = {0, up + 2.0f * h * cosf(lean), -h * sinf(lean)};
        for (int s = -1; s <= 1; s += 2) {
            back.x = (float)s * 0.8f * w;
            dmg_beam(b, v3(back.x, 0, -2.2f * h * sinf(lean) - t), v3(back.x, back.y, 2 * back.z - t), t, t);
        }
        dmg_box(b, v3(0, 0.5f * (up + t), 0), v3(1.8f * w, up + t, t));
        dmg_move(b, 0, up + t, 0);
        dmg_turn(b, v3(1, 0, 0), -lean);
        dmg_move(b, 0, h, 0);
    }
    if (pose == 2) {
        for (int i = 0; i < 4 && up > 0; ++i)
            dmg_box(b, v3((i % 2 ? 0.9f : -0.9f) * w, 0.5f * up, (i / 2 ? 0.9f : -0.9f) * h), v3(t, up, t));
        dmg_move(b, 0, up + t, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    }
    draw_task_grid(b, columns, rows, w, h, t);
}

/* Draws a cube with a task on some of its faces; at least one. */
static void draw_busy_cube(dmg_builder* b, float size) {
    float stretch = dmg_range(b, 0.7f, 1.4f), share = dmg_range(b, 0.3f, 1.0f);
    int must = dmg_int(b, 0, 4);
    dmg_move(b, 0, size, 0);
    dmg_box(b, v3(0, 0, 0), v3(2 * size * stretch, 2 * size, 2 * size));
    for (int i = 0; i < 5; ++i) {
        if (i != must && !dmg_chance(b, share)) continue;
        dmg_save(b);
        if (i < 4) dmg_turn_to(b, v3(0, 1, 0), i, 4);
        if (i == 4) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_move(b, 0, 0, i < 4 && i % 2 ? size * stretch : size);
        draw_task(b, 0.75f * size * (i % 2 ? 1.0f : stretch), 0.75f * size);
        dmg_restore(b);
    }
}

/* Blocks on a table or on nothing, each with a task on its front or its top. */
static void draw_stations(dmg_builder* b, float size) {
    int count = dmg_chance(b, 0.4f) ? 1 : dmg_int(b, 2, 4);
    float pitch = size * dmg_range(b, 2.0f, 2.8f), t = size * dmg_range(b, 0.05f, 0.2f);
    bool table = dmg_chance(b, 0.7f);
    if (table) dmg_box(b, v3(0, 0.5f * t, 0), v3(pitch * (float)count, t, size * dmg_range(b, 2.2f, 4.0f)));
    for (int i = 0; i < count; ++i) {
        float w = size * dmg_range(b, 0.5f, 1.0f), h = size * dmg_range(b, 0.4f, 1.0f),
              deep = size * dmg_range(b, 0.2f, 0.8f);
        bool top = dmg_chance(b, 0.35f);
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), table ? t : 0, 0);
        if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(0, 1, 0), dmg_range(b, -0.5f, 0.5f));
        if (top) {
            dmg_box(b, v3(0, 0.5f * deep, 0), v3(2 * w, deep, 2 * h));
            dmg_move(b, 0, deep, 0);
            dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        } else {
            dmg_box(b, v3(0, h, -0.5f * deep), v3(2 * w, 2 * h, deep));
            dmg_move(b, 0, h, 0);
        }
        draw_task(b, 0.97f * w, 0.97f * h);
        dmg_restore(b);
    }
}

void dmg_build_task_board(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 0.8f);
    int layout = dmg_int(b, 0, 5);
    if (layout < 3) draw_board(b, size);
    if (layout == 3) draw_busy_cube(b, size);
    if (layout > 3) draw_stations(b, size);
}
