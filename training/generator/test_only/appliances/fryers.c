/* Draws cooking and washing pots of the worktop: air fryers with a drawer, a lid or an oven door, rice, slow and
 * pressure cookers, salad spinners. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* From now on z goes up, and the angle -90 degrees of a skin faces the front. */
static void stand_up(dmg_builder* b) {
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
}

/* A bow in the plane of `out` from one point to the other. */
static void draw_bow(dmg_builder* b, dmg_vec from, dmg_vec to, dmg_vec out, float thick, bool square) {
    enum { POINTS = 9 };
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float t = (float)i / (POINTS - 1), rise = sinf(DMG_PI * t), way = 0.5f - 0.5f * cosf(DMG_PI * t);
        path[i] = v3_mad(v3_lerp(from, to, square ? way : t), out, square ? fminf(1.0f, 1.6f * rise) : rise);
    }
    dmg_sweep(b, path, POINTS, thick, thick, false);
}

/* Draws a turned pot on y = 0, open on top. */
static void draw_pot_shell(dmg_builder* b, float foot, float rim, float high, float wall) {
    float bend = 0.12f * high;
    const dmg_xy rows[] = {
        {0, 0}, {0.9f * foot, 0}, {foot, bend}, {rim, high}, {rim - wall, high}, {foot - wall, bend}, {0, wall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 7);
}

/* Draws a knob on a lid's top: turned, a ball on a neck, or a bow. */
static void draw_lid_grip(dmg_builder* b, float y, float size) {
    int kind = dmg_int(b, 0, 2), knob = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    if (kind == 0) {
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_knob_draw(b, knob, 0.5f * size, 0.6f * size);
    } else if (kind == 1) {
        dmg_rod(b, v3(0, -0.2f * size, 0), v3(0, 0.6f * size, 0), 0.15f * size);
        dmg_ellipsoid(b, v3(0, 0.7f * size, 0), v3(0.45f * size, 0.3f * size, 0.45f * size));
    } else {
        draw_bow(b, v3(-size, -0.1f * size, 0), v3(size, -0.1f * size, 0), v3(0, 0.8f * size, 0), 0.15f * size, true);
    }
    dmg_restore(b);
}

/* ---- air fryer ---- */

typedef struct fryer {
    float half, high, deep; /* deep: half of the depth, too */
    float seam, wall;       /* the drawer reaches up to the seam */
} fryer;

/* Draws what one pulls on, at z = 0: a stick with a foot, a bow upright or across, a block. A release button on the
 * stick. */
static void draw_drawer_grip(dmg_builder* b, uint32_t drawer, float size) {
    int kind = dmg_int(b, 0, 3);
    float t = size * dmg_range(b, 0.12f, 0.2f), out = size * dmg_range(b, 0.6f, 1.2f);
    bool release = dmg_chance(b, 0.5f), square = dmg_chance(b, 0.5f);
    if (kind == 0) {
        dmg_box_span(b, v3(-t, -size, -t), v3(t, 0.3f * size, 0.5f * t));
        dmg_rounded_box(b, v3(0, 0, 0.5f * out), v3(2 * t, 2.4f * t, out), 0.6f * t);
        if (release) {
            dmg_slide(b, drawer, "release", v3(0, -1, 0), 0.0f, 0.4f * t);
            dmg_rounded_box(b, v3(0, 1.3f * t, 0.4f * out), v3(1.2f * t, 0.9f * t, 2.5f * t), 0.2f * t);
        }
    }
    if (kind == 1) draw_bow(b, v3(0, -0.7f * size, 0), v3(0, 0.7f * size, 0), v3(0, 0, 0.7f * out), t, square);
    if (kind == 2) draw_bow(b, v3(-0.8f * size, 0, 0), v3(0.8f * size, 0, 0), v3(0, 0, 0.6f * out), t, square);
    if (kind == 3) dmg_rounded_box(b, v3(0, 0, 0.2f * out), v3(1.6f * size, 2 * t, 0.6f * out), 0.5f * t);
    dmg_use(b, 0);
}

/* Draws a drum whose front below the seam is the drawer's. */
static void draw_round_fryer(dmg_builder* b, const fryer* f) {
    float r = f->half, a = dmg_range(b, 0.95f, 1.35f), top = r * dmg_range(b, 0.3f, 0.85f),
          way = r * dmg_range(b, 1.0f, 2.0f), belly = r * dmg_range(b, 1.0f, 1.08f),
          pot = 0.92f * (r - f->wall) * sinf(a), size = r * dmg_range(b, 0.3f, 0.55f);
    float mid = 0.5f * (f->seam + f->high);
    const dmg_xy head[] = {{0, f->seam},   {r, f->seam}, {belly, mid}, {0.5f * (top + belly), 0.93f * f->high},
                           {top, f->high}, {0, f->high}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), head, 6);
    dmg_rod(b, v3(0, 0, 0), v3(0, f->wall, 0), 0.97f * r);
    stand_up(b);
    dmg_skin_cone(b, (dmg_xy){r, f->wall}, (dmg_xy){r, f->seam}, a - 0.5f * DMG_PI, 1.5f * DMG_PI - a, f->wall);
    dmg_restore(b);
    uint32_t drawer = dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, way);
    stand_up(b);
    dmg_skin_cone(b, (dmg_xy){r, 1.1f * f->wall}, (dmg_xy){r, f->seam - 0.004f}, 0.01f - a - 0.5f * DMG_PI,
                  a - 0.01f - 0.5f * DMG_PI, f->wall);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 1.2f * f->wall, 0);
    draw_pot_shell(b, 0.9f * pot, pot, 0.85f * f->seam - 1.2f * f->wall, 0.3f * f->wall);
    dmg_box_span(b, v3(-0.4f * pot, 0.4f * f->seam, 0.85f * pot), v3(0.4f * pot, 0.6f * f->seam, r - 0.5f * f->wall));
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 0.62f * f->seam, r);
    draw_drawer_grip(b, drawer, fminf(size, 0.5f * f->seam));
    dmg_restore(b);
}

/* Draws a box with one drawer or two, side by side or one above the other. */
static void draw_box_fryer(dmg_builder* b, const fryer* f) {
    int kind = dmg_int(b, 0, 2), count = kind == 0 ? 1 : 2;
    float w = 2 * f->half - 2 * f->wall, h = f->seam - f->wall, shoulder = dmg_range(b, 0.1f, 0.45f),
          size = f->half * dmg_range(b, 0.2f, 0.4f);
    dmg_drawer d = dmg_drawer_pick(b, 0.1f);
    d.width = (kind == 1 ? 0.5f * w : w) - 0.006f;
    d.height = (kind == 2 ? 0.5f * h : h) - 0.006f;
    d.depth = 2 * f->deep - 3 * f->wall;
    d.travel = d.depth * dmg_range(b, 0.6f, 1.0f);
    d.handle.kind = DMG_HANDLE_NONE;
    if (d.tray == DMG_TRAY_NONE) d.tray = DMG_TRAY_BOARDS;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * f->seam, f->deep);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * f->half, f->seam, 2 * f->deep, f->wall);
    for (int i = 0; i < count; ++i) {
        float side = (float)i - 0.5f;
        dmg_save(b);
        if (kind == 1) dmg_move(b, side * 0.5f * w, 0, 0);
        if (kind == 2) dmg_move(b, 0, side * 0.5f * h, 0);
        uint32_t drawer = dmg_drawer_draw(b, 0, "drawer", &d);
        draw_drawer_grip(b, drawer, fminf(size, 0.4f * d.height));
        dmg_restore(b);
    }
    dmg_restore(b);
    float high = f->high - f->seam, round = shoulder * fminf(high, f->deep);
    dmg_rounded_box(b, v3(0, 0.5f * (f->seam + f->high), 0), v3(2 * f->half, high, 2 * f->deep), round);
}

/* Draws a pot with a deep lid on a rear hinge; the basket in it is lifted by its bail when the lid stands open. */
static void draw_lidded_fryer(dmg_builder* b, const fryer* f) {
    float r = f->half, rim = f->high * dmg_range(b, 0.5f, 0.75f), lid = f->high - rim, t = 0.08f * r,
          swing = dmg_range(b, 1.1f, 1.7f), top = r * dmg_range(b, 0.5f, 0.95f);
    bool glass = dmg_chance(b, 0.3f), square = dmg_chance(b, 0.4f);
    if (square) {
        dmg_save(b);
        dmg_move(b, 0, rim, 0);
        dmg_face_up(b);
        dmg_case_draw(b, DMG_CASE_BOARDS, 2 * r, 2 * r, rim, t);
        dmg_restore(b);
    } else {
        draw_pot_shell(b, 0.92f * r, r, rim, t);
    }
    dmg_box_span(b, v3(-0.4f * r, rim - 0.5f * t, -r - 1.5f * t), v3(0.4f * r, rim, -0.95f * r));
    uint32_t part = dmg_hinge(b, 0, "lid", v3(0, rim, -r - 0.7f * t), v3(-1, 0, 0), 0.0f, swing);
    const dmg_xy rows[] = {{0, rim + 0.002f}, {r, rim + 0.002f}, {r, rim + 0.4f * lid}, {top, f->high}, {0, f->high}};
    if (square)
        dmg_rounded_box(b, v3(0, rim + 0.002f + 0.5f * lid, 0), v3(2 * r, lid - 0.004f, 2 * r), 0.25f * lid);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 5);
    dmg_box_span(b, v3(-0.3f * r, rim + 0.002f, -r - 1.5f * t), v3(0.3f * r, rim + 0.3f * lid, -0.9f * r));
    dmg_box_span(b, v3(-0.3f * r, rim + 0.1f * lid, 0.9f * r), v3(0.3f * r, rim + 0.4f * lid, 1.2f * r));
    if (glass) dmg_ellipsoid(b, v3(0, f->high, 0), v3(0.4f * top, 0.15f * lid, 0.4f * top));
    dmg_save(b);
    dmg_move(b, 0, rim + 0.6f * lid, square ? r : 0.5f * (r + top));
    if (square && dmg_chance(b, 0.6f)) dmg_knobs_draw(b, part, 1, 0, 0, 0.2f * lid);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a small oven: door below or at the side, a spit that turns, a rack. */
static void draw_oven_fryer(dmg_builder* b, const fryer* f) {
    float strip = f->high * dmg_range(b, 0.12f, 0.25f), w = 2 * f->half - 2 * f->wall, h = f->high - strip - f->wall;
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, w, h, 0.6f * f->wall);
    leaf.panel = dmg_panel_pick_window(b);
    int spit = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (f->high - strip), f->deep);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * f->half, f->high - strip, 2 * f->deep, f->wall);
    uint32_t door = dmg_leaf_draw(b, 0, "door", &leaf);
    if (spit == 0) {
        dmg_rest(b, door, leaf.swing * dmg_range(b, 0.5f, 1.0f));
        dmg_spin(b, 0, "spit", v3(0, 0, -f->deep), v3(1, 0, 0));
        dmg_rod(b, v3(-0.5f * w, 0, -f->deep), v3(0.5f * w, 0, -f->deep), 0.03f * h);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0.25f * (float)s * w, 0, -f->deep), v3(0.04f * w, 0.5f * h, 0.1f * h));
        dmg_ellipsoid(b, v3(0, 0, -f->deep), v3(0.2f * w, 0.2f * h, 0.17f * h));
    } else if (spit == 1) {
        dmg_rest(b, door, leaf.swing * dmg_range(b, 0.7f, 1.0f));
        dmg_racks_draw(b, "rack", dmg_int(b, 1, 3), w, h, 2 * f->deep - 2 * f->wall, 0.03f * h);
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * f->high, 0);
    dmg_box_span(b, v3(-f->half, -0.5f * strip, -2 * f->deep), v3(f->half, 0.5f * strip, 0));
    dmg_controls_draw(b, 0, 0.9f * w, 0.8f * strip);
    dmg_restore(b);
}

/* Draws a dial or keys on the slope or the top of the head. */
static void draw_fryer_controls(dmg_builder* b, const fryer* f, bool round) {
    float r = f->half * dmg_range(b, 0.15f, 0.3f), gap = 0.5f * (f->high - f->seam);
    int kind = dmg_int(b, 0, 2);
    r = fminf(r, 0.6f * gap);
    dmg_save(b);
    if (kind == 0 && round) {
        dmg_move(b, 0, f->high, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        r = fminf(r, 0.28f * f->half);
    } else {
        dmg_move(b, 0, 0.5f * (f->seam + f->high), (round ? 1.03f : 1.0f) * f->deep);
    }
    if (kind == 1) {
        dmg_buttons keys = {"button", dmg_int(b, 1, 3), 1, 0.9f * r, r, 0.6f * r, 0.5f * r, 0.25f * r, 0.1f * r, 0};
        dmg_buttons_draw(b, 0, &keys);
    } else {
        dmg_knobs_draw(b, 0, round || kind == 2 ? 1 : 2, 2.6f * r, 0, r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_air_fryer(dmg_builder* b) {
    fryer f = {.half = dmg_range(b, 0.11f, 0.17f)};
    int kind = dmg_weighted(b, (const float[]){3, 3, 2, 2}, 4);
    bool round = kind == 0;
    f.high = f.half * dmg_range(b, 1.8f, 2.6f);
    f.deep = round ? f.half : f.half * dmg_range(b, 0.8f, 1.3f);
    f.seam = f.high * dmg_range(b, 0.45f, 0.65f);
    f.wall = f.half * dmg_range(b, 0.06f, 0.12f);
    if (kind == 0) draw_round_fryer(b, &f);
    if (kind == 1) {
        f.half *= dmg_range(b, 1.0f, 1.6f);
        draw_box_fryer(b, &f);
    }
    if (kind == 2) draw_lidded_fryer(b, &f);
    if (kind == 3) {
        f.half *= dmg_range(b, 1.0f, 1.5f);
        draw_oven_fryer(b, &f);
    }
    if (kind < 2) draw_fryer_controls(b, &f, round);
}

/* ---- cookers ---- */

/* Draws a lever that goes down to cook, a dial, or keys, on the belly at z = 0. */
static void draw_cooker_switch(dmg_builder* b, float size) {
    int kind = dmg_int(b, 0, 2);
    dmg_box(b, v3(0, 0, 0), v3(2.2f * size, 1.5f * size, 0.5f * size));
    dmg_save(b);
    dmg_move(b, 0, 0, 0.25f * size);
    if (kind == 0) {
        dmg_hinge(b, 0, "switch", v3(0, 0.3f * size, -0.1f * size), v3(1, 0, 0), 0.0f, dmg_range(b, 0.2f, 0.5f));
        dmg_beam(b, v3(0, 0.3f * size, -0.1f * size), v3(0, 0.5f * size, 0.7f * size), 0.5f * size, 0.2f * size);
    } else if (kind == 1) {
        dmg_knobs_draw(b, 0, 1, 0, 0, 0.55f * size);
    } else {
        dmg_buttons keys = {"button", 2, 1, size, size, 0.6f * size, 0.6f * size, 0.2f * size, 0.1f * size, 1};
        keys.columns = dmg_int(b, 1, 2);
        dmg_buttons_draw(b, 0, &keys);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a bail from flank to flank; shown upright, laid back or anywhere between. */
static void draw_bail(dmg_builder* b, float r, float y, float over, float t) {
    float rest = dmg_range(b, -1.2f, 1.2f);
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3((float)s * 0.95f * r, y, 0), v3((float)s * (r + t), y, 0), 1.6f * t);
    uint32_t bail = dmg_hinge(b, 0, "bail", v3(0, y, 0), v3(1, 0, 0), -1.2f, 1.2f);
    draw_bow(b, v3(-r - 2.2f * t, y, 0), v3(r + 2.2f * t, y, 0), v3(0, over, 0), t, true);
    dmg_rest(b, bail, dmg_chance(b, 0.4f) ? 0.0f : rest);
    dmg_use(b, 0);
}

/* Lifted out once the lid stands open. */
static void draw_inner_pot(dmg_builder* b, float r, float rim, float t) {
    dmg_slide(b, 0, "pot", v3(0, 1, 0), 0.0f, 0.5f * rim);
    dmg_save(b);
    dmg_move(b, 0, 0.12f * rim, 0);
    draw_pot_shell(b, 0.65f * r, 0.84f * r, 0.86f * rim, 0.5f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Lid hung at the rear, a latch under the thumb in front, a steam cap that is pulled off. */
static void draw_hinged_cooker(dmg_builder* b, float r, float high) {
    float rim = high * dmg_range(b, 0.65f, 0.8f), lid = high - rim, swing = dmg_range(b, 1.2f, 1.7f), t = 0.05f * r,
          bulge = r * dmg_range(b, 1.0f, 1.08f);
    bool square = dmg_chance(b, 0.4f), bail = dmg_chance(b, 0.5f), top = dmg_chance(b, 0.5f);
    const dmg_xy body[] = {{0, 0}, {0.88f * r, 0}, {bulge, 0.4f * rim}, {r, rim}, {0, rim}};
    const dmg_xy cover[] = {
        {0, rim + 0.002f}, {r, rim + 0.002f}, {0.97f * r, rim + 0.4f * lid}, {0.75f * r, rim + 0.85f * lid},
        {0.4f * r, high},  {0, high}};
    bool hollow = !square && dmg_chance(b, 0.5f);
    if (square)
        dmg_rounded_box(b, v3(0, 0.5f * rim, 0), v3(2 * r, rim, 2 * r), 0.2f * r);
    else if (hollow)
        draw_pot_shell(b, 0.88f * r, r, rim, 2 * t);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 5);
    dmg_box_span(b, v3(-0.4f * r, rim - 0.3f * lid, -1.12f * r), v3(0.4f * r, rim, -0.85f * r));
    uint32_t part = dmg_hinge(b, 0, "lid", v3(0, rim, -1.08f * r), v3(-1, 0, 0), 0.0f, swing);
    if (square)
        dmg_rounded_box(b, v3(0, rim + 0.5f * lid + 0.002f, 0), v3(2 * r, lid, 2 * r), 0.3f * lid);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cover, 6);
    dmg_box_span(b, v3(-0.35f * r, rim + 0.002f, -1.12f * r), v3(0.35f * r, rim + 0.4f * lid, -0.8f * r));
    if (dmg_chance(b, 0.6f)) {
        dmg_slide(b, part, "steam_cap", v3(0, 1, 0), 0.0f, 0.3f * lid);
        dmg_rod(b, v3(0, high - 0.1f * lid, -0.35f * r), v3(0, high + 0.12f * lid, -0.35f * r), 0.16f * r);
    }
    if (top) { /* on the lid, pressed down */
        dmg_slide(b, part, "latch_button", v3(0, -1, 0), 0.0f, 0.15f * lid);
        dmg_rounded_box(b, v3(0, rim + 0.75f * lid, 0.76f * r), v3(0.35f * r, 0.35f * lid, 0.2f * r), t);
    } else { /* below the lid, pressed in */
        dmg_slide(b, 0, "latch_button", v3(0, 0, -1), 0.0f, t);
        dmg_box(b, v3(0, rim - 0.3f * lid, 1.01f * r), v3(0.35f * r, 0.4f * lid, 3 * t));
    }
    dmg_use(b, 0);
    if (hollow) {
        dmg_rest(b, part, swing);
        draw_inner_pot(b, r, rim, t);
    }
    if (bail && !square) draw_bail(b, bulge, rim - 0.4f * lid, 0.4f * lid + 1.3f * lid + 0.1f * r, 0.6f * t);
    dmg_save(b);
    dmg_move(b, 0, 0.4f * rim, bulge);
    draw_cooker_switch(b, 0.2f * r);
    dmg_restore(b);
}

/* Draws a pot with a lid that is lifted, round or oval, two ears; wire clips hold the lid of some. */
static void draw_open_cooker(dmg_builder* b, float r, float high) {
    float oval = dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.65f, 0.9f), lid = r * dmg_range(b, 0.12f, 0.4f),
          t = 0.06f * r, way = r * dmg_range(b, 0.5f, 2.0f), ear = dmg_range(b, 0.5f, 0.85f) * high;
    bool clips = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_frame* frame = &b->frames[b->frame_depth];
    frame->column[2] = v3_scale(frame->column[2], oval);
    draw_pot_shell(b, 0.85f * r, r, high, t);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2)
        dmg_rounded_box(b, v3((float)s * 1.08f * r, ear, 0), v3(0.3f * r, 0.12f * r, 0.5f * oval * r), 0.05f * r);
    dmg_save(b);
    dmg_move(b, 0, 0.35f * high, 0.9f * oval * r);
    draw_cooker_switch(b, 0.18f * r);
    dmg_restore(b);
    dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, way);
    dmg_save(b);
    frame = &b->frames[b->frame_depth];
    frame->column[2] = v3_scale(frame->column[2], oval);
    const dmg_xy rows[] = {{0, high + 0.001f},
                           {1.02f * r, high + 0.001f},
                           {1.02f * r, high + 0.4f * t},
                           {0.7f * r, high + 0.6f * lid},
                           {0, high + lid}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 5);
    dmg_restore(b);
    draw_lid_grip(b, high + lid, r * dmg_range(b, 0.15f, 0.25f));
    dmg_use(b, 0);
    for (int s = -1; s <= 1 && clips; s += 2) {
        float x = (float)s * 1.1f * r, top = high + 1.6f * t;
        float far = dmg_range(b, 0.8f, 2.0f); /* shown off the lid, which is free to be lifted */
        uint32_t clip = dmg_hinge(b, 0, "clip", v3(x, 0.8f * high, 0), v3(0, 0, -(float)s), 0.0f, far);
        dmg_rest(b, clip, far);
        dmg_box_span(b, v3(x - 0.02f * r, 0.8f * high - 0.04f * r, -0.1f * oval * r),
                     v3(x + 0.02f * r, top, 0.1f * oval * r));
        dmg_box_span(b, v3(fminf(x, 0.93f * x), top, -0.1f * oval * r),
                     v3(fmaxf(x, 0.93f * x), top + 0.04f * r, 0.1f * oval * r));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1 && clips; s += 2)
        dmg_rod(b, v3((float)s * 0.9f * r, 0.8f * high, 0), v3((float)s * 1.12f * r, 0.8f * high, 0), 0.03f * r);
}

/* Draws a lid that is turned off its lugs or is lifted once it is; long handles one above the other, a weight on a
 * vent. */
static void draw_pressure_cooker(dmg_builder* b, float r, float high) {
    float lid = r * dmg_range(b, 0.15f, 0.35f), t = 0.05f * r, reach = r * dmg_range(b, 1.0f, 1.8f),
          turn = dmg_range(b, 0.3f, 0.9f), way = r * dmg_range(b, 0.3f, 1.2f);
    bool turns = dmg_chance(b, 0.6f), knob = dmg_chance(b, 0.3f), helper = dmg_chance(b, 0.6f);
    draw_pot_shell(b, r, r, high, t);
    dmg_box_span(b, v3(-0.12f * r, high - 0.3f * r, 0.95f * r), v3(0.12f * r, high - 0.12f * r, r + reach));
    if (helper)
        draw_bow(b, v3(-0.4f * r, high - 0.25f * r, -0.9f * r), v3(0.4f * r, high - 0.25f * r, -0.9f * r),
                 v3(0, 0, -0.5f * r), t, true);
    uint32_t part = turns ? dmg_hinge(b, 0, "lid", v3(0, high, 0), v3(0, dmg_sign(b), 0), 0.0f, turn)
                          : dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, way);
    const dmg_xy rows[] = {{0, high + 0.001f},
                           {1.06f * r, high + 0.001f},
                           {1.06f * r, high + 0.1f * r},
                           {0.9f * r, high + 0.5f * lid + 0.05f * r},
                           {0.4f * r, high + lid + 0.04f * r},
                           {0, high + lid + 0.05f * r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 6);
    dmg_box_span(b, v3(-0.12f * r, high + 0.002f, 0.95f * r), v3(0.12f * r, high + 0.16f * r, r + 0.98f * reach));
    float top = high + lid + 0.05f * r;
    if (knob) { /* screws the lid's bar tight */
        dmg_spin(b, part, "knob", v3(0, top, 0), v3(0, 1, 0));
        draw_lid_grip(b, top, 0.3f * r);
    } else if (dmg_chance(b, 0.7f)) {
        dmg_slide(b, part, "weight", v3(0, 1, 0), 0.0f, 0.2f * r);
        dmg_rod(b, v3(0, top - 0.01f * r, 0), v3(0, top + 0.2f * r, 0), 0.12f * r);
        dmg_rod(b, v3(0, top + 0.2f * r, 0), v3(0, top + 0.26f * r, 0), 0.16f * r);
    }
    if (dmg_chance(b, 0.5f)) { /* the lock on the upper handle */
        dmg_slide(b, part, "lock", v3(0, 0, 1), 0.0f, 0.15f * r);
        dmg_box(b, v3(0, high + 0.18f * r, 1.25f * r), v3(0.12f * r, 0.06f * r, 0.2f * r));
    }
    dmg_use(b, 0);
}

void dmg_build_rice_cooker(dmg_builder* b) {
    float r = dmg_range(b, 0.1f, 0.17f), high = r * dmg_range(b, 1.1f, 1.9f);
    int kind = dmg_weighted(b, (const float[]){3, 2, 2}, 3);
    if (kind == 0) draw_hinged_cooker(b, r, 1.1f * high);
    if (kind == 1) draw_open_cooker(b, r, 0.85f * high);
    if (kind == 2) draw_pressure_cooker(b, r, 0.8f * high);
}

/* ---- salad spinner ---- */

/* Draws a crank on the lid: an arm or a disc sunk in it, with a knob that turns on its pin. */
static void draw_spinner_crank(dmg_builder* b, uint32_t lid, float r, float y) {
    float arm = r * dmg_range(b, 0.35f, 0.75f), t = 0.05f * r;
    bool disc = dmg_chance(b, 0.35f), turns = dmg_chance(b, 0.5f);
    uint32_t crank = dmg_spin(b, lid, "crank", v3(0, y, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, y, 0), v3(0, y + 3 * t, 0), 0.12f * r);
    if (disc)
        dmg_rod(b, v3(0, y + 1.5f * t, 0), v3(0, y + 3 * t, 0), arm + 0.1f * r);
    else
        dmg_beam(b, v3(-0.1f * r, y + 2.3f * t, 0), v3(arm + 0.08f * r, y + 2.3f * t, 0), 0.15f * r, 1.4f * t);
    if (turns) dmg_spin(b, crank, "crank_knob", v3(arm, y, 0), v3(0, 1, 0));
    dmg_cone(b, v3(arm, y + 3.02f * t, 0), v3(arm, y + 3 * t + 0.3f * r, 0), 0.08f * r, 0.11f * r);
}

/* Draws what makes it go round: a crank, a knob pumped down, a cord pulled out at the side, a lever. */
static void draw_spinner_drive(dmg_builder* b, uint32_t lid, float r, float y) {
    int kind = dmg_weighted(b, (const float[]){3, 3, 2, 1}, 4);
    float way = r * dmg_range(b, 0.2f, 0.5f), wide = r * dmg_range(b, 0.15f, 0.3f);
    if (kind == 0) draw_spinner_crank(b, lid, r, y);
    if (kind == 1) {
        dmg_lathe(b, v3(0, y, 0), v3(0, 1, 0),
                  (const dmg_xy[]){
                      {0.6f * wide, 0}, {wide, 0}, {wide, 0.06f * r}, {0.6f * wide, 0.06f * r}, {0.6f * wide, 0}},
                  5);
        dmg_slide(b, lid, "plunger", v3(0, -1, 0), 0.0f, way);
        dmg_rod(b, v3(0, y + 0.001f, 0), v3(0, y + 0.08f * r + way, 0), 0.5f * wide);
        dmg_ellipsoid(b, v3(0, y + 0.1f * r + way, 0), v3(wide, 0.5f * wide, wide));
    }
    if (kind == 2) {
        dmg_rod(b, v3(0, y, 0), v3(0, y + 0.12f * r, 0), 0.45f * r);
        float x = 0.45f * r, far = r * dmg_range(b, 0.3f, 0.75f), lift = y + 0.06f * r;
        dmg_slide(b, lid, "cord", v3(1, 0, 0), 0.0f, far);
        dmg_rod(b, v3(-0.35f * r, lift, 0), v3(x + 0.05f * r, lift, 0), 0.012f * r);
        dmg_capsule(b, v3(x + 0.08f * r, lift, -0.15f * r), v3(x + 0.08f * r, lift, 0.15f * r), 0.05f * r);
    }
    if (kind == 3) {
        float reach = r * dmg_range(b, 0.7f, 1.1f), rise = dmg_range(b, 0.3f, 0.7f) * reach;
        dmg_box(b, v3(-0.5f * r, y + 0.06f * r, 0), v3(0.2f * r, 0.14f * r, 0.3f * r));
        dmg_hinge(b, lid, "lever", v3(-0.5f * r, y + 0.16f * r, 0), v3(0, 0, -1), 0.0f, 0.8f * atan2f(rise, reach));
        dmg_beam(b, v3(-0.55f * r, y + 0.16f * r, 0), v3(-0.5f * r + reach, y + 0.16f * r + rise, 0), 0.2f * r,
                 0.06f * r);
    }
}

void dmg_build_salad_spinner(dmg_builder* b) {
    float r = dmg_range(b, 0.1f, 0.14f), high = r * dmg_range(b, 0.9f, 1.5f), foot = r * dmg_range(b, 0.6f, 0.95f),
          t = 0.03f * r, dome = r * dmg_range(b, 0.02f, 0.25f), way = r * dmg_range(b, 0.6f, 2.0f);
    bool apart = dmg_chance(b, 0.4f), brake = dmg_chance(b, 0.35f), hung = dmg_chance(b, 0.15f);
    draw_pot_shell(b, foot, r, high, t);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0.04f * r, 0), 0.8f * foot); /* rubber foot */
    if (hung) dmg_box_span(b, v3(-0.2f * r, high - 0.1f * r, -1.1f * r), v3(0.2f * r, high, -0.97f * r));
    uint32_t lid = hung ? dmg_hinge(b, 0, "lid", v3(0, high, -1.06f * r), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.0f))
                        : dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, way);
    const dmg_xy rows[] = {{0, high + 0.001f},
                           {1.04f * r, high + 0.001f},
                           {1.04f * r, high + 0.08f * r},
                           {0.7f * r, high + 0.08f * r + 0.7f * dome},
                           {0.5f * r, high + 0.08f * r + dome},
                           {0, high + 0.08f * r + dome}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rows, 6);
    if (hung) dmg_box_span(b, v3(-0.18f * r, high + 0.001f, -1.1f * r), v3(0.18f * r, high + 0.06f * r, -0.95f * r));
    draw_spinner_drive(b, lid, r, high + 0.08f * r + dome);
    if (brake) {
        dmg_slide(b, lid, "brake", v3(0, -1, 0), 0.0f, 0.04f * r);
        dmg_rod(b, v3(0, high + 0.08f * r, 0.85f * r), v3(0, high + 0.16f * r + 0.4f * dome, 0.85f * r), 0.09f * r);
    }
    if (apart) { /* the basket shows once the lid is off */
        dmg_rest(b, lid, hung ? 0.9f * b->parts[lid - 1].joint.upper : fmaxf(0.6f * r, 0.7f * way));
        dmg_spin(b, 0, "basket", v3(0, 0, 0), v3(0, 1, 0));
        dmg_save(b);
        dmg_move(b, 0, 2 * t, 0);
        draw_pot_shell(b, 0.9f * foot, 0.93f * r, high - 3 * t, t);
        dmg_restore(b);
        for (int i = 0; i < 4; ++i) {
            float turn = 0.5f * DMG_PI * (float)i;
            dmg_box(b, v3(0.5f * foot * cosf(turn), 4 * t, 0.5f * foot * sinf(turn)), v3(0.4f * foot, t, 0.4f * foot));
        }
    }
    dmg_use(b, 0);
}
