/* Draws pots of the worktop that cook by themselves: rice, slow and pressure cookers. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

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
