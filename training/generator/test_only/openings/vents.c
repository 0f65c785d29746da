/* Draws vents and skylights: smoke vents, greenhouses, louvre windows, dampers of ducts, awnings, turning cowls on
 * roofs. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* Draws four walls round an opening in the plane y = 0, up to `high`. */
static void draw_curb(dmg_builder* b, float wide, float deep, float high, float t) {
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * 0.5f * (wide - t), 0.5f * high, 0), v3(t, high, deep));
        dmg_box(b, v3(0, 0.5f * high, (float)s * 0.5f * (deep - t)), v3(wide - 2 * t, high, t));
    }
}

/* In a sloping roof: the sash hung at its upper edge, its side or about its middle. */
static void draw_skylight(dmg_builder* b) {
    float wide = dmg_range(b, 0.5f, 1.4f), deep = wide * dmg_range(b, 0.7f, 1.7f), high = dmg_range(b, 0.08f, 0.3f),
          t = dmg_range(b, 0.03f, 0.07f), slope = dmg_chance(b, 0.6f) ? dmg_range(b, 0.3f, 0.9f) : 0.0f,
          swing = dmg_range(b, 0.5f, 1.3f), edge = dmg_range(b, 0.1f, 0.5f);
    int hung = dmg_weighted(b, (const float[]){2, 1.3f, 0.7f}, 3);
    bool domed = dmg_chance(b, 0.35f);
    dmg_panel panel = dmg_panel_pick_window(b);
    dmg_move(b, 0, 0.6f * deep * sinf(slope), 0);
    dmg_turn(b, v3(1, 0, 0), slope);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_frame_draw(b, wide + 2 * edge, deep + 2 * edge, 0.02f, edge + t);
    dmg_restore(b);
    draw_curb(b, wide, deep, high, t);
    float lip = hung == 1 ? -2 * t - 0.006f : 0.03f, y = high + 0.004f;
    if (hung == 1) y = high - t;
    uint32_t sash = hung == 0   ? dmg_hinge(b, 0, "sash", v3(0, y, -0.5f * deep), v3(-1, 0, 0), 0.0f, swing)
                    : hung == 1 ? dmg_hinge(b, 0, "sash", v3(0, y + 0.5f * t, 0), v3(-1, 0, 0), 0.0f, 1.2f)
                                : dmg_hinge(b, 0, "sash", v3(-0.5f * wide, y, 0), v3(0, 0, 1), 0.0f, swing);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_move(b, 0, 0, y + t);
    dmg_panel_draw(b, &panel, wide + lip, deep + lip, t);
    if (dmg_chance(b, 0.5f)) { /* a handle or a stay's eye along the lower edge */
        dmg_box(b, v3(0, -0.5f * deep + 1.6f * t, 0.01f), v3(0.3f * wide, 0.3f * t, 0.04f));
    }
    dmg_restore(b);
    if (domed) dmg_dome(b, v3(0, y + t, 0), v3(0.42f * (wide + lip), 0.15f * wide, 0.42f * (deep + lip)));
    if (hung == 0 && dmg_chance(b, 0.4f)) { /* a winder inside the curb */
        dmg_hinge(b, 0, "stay", v3(0.3f * wide, 0.6f * high, 0.5f * deep - 1.5f * t), v3(0, 0, -1), 0.0f, 1.5f);
        dmg_rod(b, v3(0.3f * wide, 0.6f * high, 0.5f * deep - 1.5f * t),
                v3(-0.15f * wide, 0.6f * high, 0.5f * deep - 1.5f * t), 0.008f);
    }
    dmg_use(b, sash);
}

/* Draws two flaps on a curb, hung at its sides, with the rams that throw them open. */
static void draw_smoke_vent(dmg_builder* b) {
    float wide = dmg_range(b, 0.9f, 2.2f), deep = wide * dmg_range(b, 0.6f, 1.8f), high = dmg_range(b, 0.2f, 0.6f),
          t = dmg_range(b, 0.03f, 0.08f), swing = dmg_range(b, 1.2f, 2.4f), rest = dmg_chance(b, 0.3f) ? swing : 0.0f,
          hump = dmg_chance(b, 0.5f) ? 0.12f * wide : 0.0f;
    bool hood = dmg_chance(b, 0.3f), louvres = dmg_chance(b, 0.35f);
    int slats = dmg_int(b, 3, 8);
    dmg_box_faces(b, v3(0, 0.01f, 0), v3(wide * 1.3f, 0.02f, deep * 1.3f), DMG_FACE_ALL);
    dmg_move(b, 0, 0.02f, 0);
    draw_curb(b, wide, deep, high, t);
    for (int i = 0; i < slats && louvres; ++i) {
        float each = (wide - 2 * t) / (float)slats, x = each * ((float)i - 0.5f * (float)(slats - 1));
        dmg_hinge(b, 0, "slat", v3(x, high - 0.04f, 0), v3(0, 0, 1), 0.0f, 1.5f);
        dmg_box(b, v3(x, high - 0.04f, 0), v3(0.96f * each, 0.012f, deep - 2.2f * t));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1 && !louvres; s += 2) {
        float side = (float)s;
        uint32_t flap = dmg_hinge(b, 0, "flap", v3(side * 0.5f * wide, high, 0), v3(0, 0, -side), 0.0f, swing);
        dmg_rest(b, flap, rest);
        const dmg_xy line[] = {{side * 0.5f * wide, high + 0.6f * t},
                               {side * 0.4f * wide, high + 0.6f * t + hump},
                               {side * 0.02f * wide, high + 0.6f * t + hump}};
        if (s < 0)
            dmg_bent_plate(b, line, 3, t, deep + 0.04f);
        else {
            const dmg_xy back[] = {line[2], line[1], line[0]};
            dmg_bent_plate(b, back, 3, t, deep + 0.04f);
        }
        if (hood)
            dmg_box(b, v3(side * 0.25f * wide, high + hump + 1.4f * t, 0), v3(0.3f * wide, 0.8f * t, 0.7f * deep));
        dmg_use(b, 0);
    }
}

/* Draws a house of glass with vents along the ridge, a door and slats in its wall. */
static void draw_greenhouse(dmg_builder* b) {
    float wide = dmg_range(b, 1.6f, 3.0f), deep = wide * dmg_range(b, 0.8f, 2.0f), eaves = dmg_range(b, 1.2f, 1.9f),
          rise = wide * dmg_range(b, 0.18f, 0.4f), p = 0.04f, x = 0.5f * wide, z = 0.5f * deep, slope = atan2f(rise, x),
          run = sqrtf(x * x + rise * rise);
    int vents = dmg_int(b, 1, 3), bays = dmg_int(b, 3, 6);
    bool slides = dmg_chance(b, 0.5f), both = dmg_chance(b, 0.5f);
    float door = 0.36f * wide, tall = eaves * 0.98f, length = 0.4f * run, span = 0.9f * deep / (float)vents;
    dmg_panel pane = dmg_panel_pick_window(b);
    for (int i = 0; i <= bays; ++i) {
        float at = -z + deep * (float)i / (float)bays;
        for (int s = -1; s <= 1; s += 2) {
            dmg_beam(b, v3((float)s * x, 0, at), v3((float)s * x, eaves, at), p, p);
            dmg_beam(b, v3((float)s * x, eaves, at), v3(0, eaves + rise, at), p, p);
        }
    }
    dmg_box(b, v3(0, eaves + rise, 0), v3(1.5f * p, 1.5f * p, deep));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * x, eaves, 0), v3(p, p, deep));
        dmg_box(b, v3((float)s * x, 0.5f * p, 0), v3(p, p, deep));
        dmg_box(b, v3((float)s * x, 0.5f * eaves, 0), v3(0.006f, eaves, deep));
        dmg_box(b, v3((float)s * 0.5f * (x + 0.5f * door), 0.5f * eaves, z), v3(x - 0.5f * door, eaves, 0.006f));
    }
    dmg_box(b, v3(0, 0.5f * eaves, -z), v3(wide, eaves, 0.006f));
    for (int s = both ? -1 : 1; s <= 1; s += 2)
        for (int i = 0; i < vents; ++i) {
            dmg_save(b);
            if (s < 0) dmg_mirror(b, v3(1, 0, 0));
            dmg_move(b, 0.02f, eaves + rise + 0.8f * p, span * ((float)i - 0.5f * (float)(vents - 1)));
            dmg_turn(b, v3(0, 0, 1), -slope);
            dmg_hinge(b, 0, "roof_vent", v3(p, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.5f, 1.0f));
            dmg_move(b, p + 0.5f * length, 0.015f, 0);
            dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
            dmg_panel_draw(b, &pane, length, 0.94f * span, 0.03f);
            dmg_restore(b);
            dmg_use(b, 0);
        }
    dmg_save(b);
    dmg_move(b, 0, 0.5f * tall + 0.01f, z + 0.06f);
    if (slides)
        dmg_slide(b, 0, "door", v3(dmg_sign(b), 0, 0), 0.0f, 0.9f * door);
    else
        dmg_hinge(b, 0, "door", v3(-0.5f * door, 0, 0), v3(0, -1, 0), 0.0f, 1.8f);
    dmg_panel_draw(b, &pane, door, tall, 0.03f);
    dmg_restore(b);
    dmg_use(b, 0);
    if (slides) dmg_box(b, v3(0, tall + 0.04f, z + 0.04f), v3(fminf(wide, 2.9f * door), 0.05f, 0.05f));
}

/* Slats on pins in a frame, a lever that turns them; in a wall the frame is flat, in a duct deep. */
static void draw_slats(dmg_builder* b, bool duct) {
    float wide = dmg_range(b, 0.3f, 1.1f), high = wide * dmg_range(b, 0.7f, 2.0f), t = duct ? 0.004f : 0.006f,
          frame = dmg_range(b, 0.02f, 0.05f);
    int count = dmg_int(b, 3, 10);
    float each = high / (float)count, deep = duct ? each * dmg_range(b, 1.05f, 2.0f) : dmg_range(b, 0.4f, 0.8f) * each,
          swing = duct ? 1.57f : dmg_range(b, 1.0f, 1.5f), rest = dmg_chance(b, 0.5f) ? 0.0f : swing * dmg_unit(b),
          at = dmg_chance(b, 0.7f) ? 0.0f : dmg_range(b, -0.4f, 0.4f);
    bool opposed = duct && dmg_chance(b, 0.5f), foils = duct && dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0.5f * high + frame, 0);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * 0.5f * (wide + frame), 0, 0), v3(frame, high + 2 * frame, deep));
        dmg_box(b, v3(0, (float)s * 0.5f * (high + frame), 0), v3(wide, frame, deep));
    }
    for (int i = 0; i < count; ++i) {
        float y = each * ((float)i - 0.5f * (float)(count - 1));
        uint32_t slat = dmg_hinge(b, 0, duct ? "damper_blade" : "louvre", v3(0, y + at * each, 0),
                                  v3(opposed && i % 2 ? -1.0f : 1.0f, 0, 0), 0.0f, swing);
        dmg_rest(b, slat, rest);
        dmg_box(b, v3(0, y, 0), v3(wide - 0.01f, 0.97f * each, t));
        if (foils) dmg_rod(b, v3(-0.48f * wide, y + at * each, 0), v3(0.48f * wide, y + at * each, 0), 3 * t);
        if (duct)
            dmg_rod(b, v3(0.48f * wide, y + at * each, 0), v3(0.5f * wide + 0.8f * frame, y + at * each, 0), 1.5f * t);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.65f)) {
        float x = 0.5f * wide + frame, y = dmg_range(b, -0.3f, 0.3f) * high;
        if (duct)
            dmg_machine_lever_place(b, 0, "damper_lever", v3(x, y, 0), 0.5f * DMG_PI, 0.25f * wide);
        else
            dmg_handwheel_place(b, 0, "crank", v3(x - 0.5f * frame, y, 0.5f * deep), 0, fminf(0.06f, 0.12f * high));
    }
}

/* Cloth over a shop's front: on arms that fold at the elbow, or on arms that drop; its roller turns in a box. */
static void draw_awning(dmg_builder* b) {
    float wide = dmg_range(b, 1.4f, 4.0f), out = dmg_range(b, 0.6f, 1.5f), high = dmg_range(b, 1.8f, 2.6f),
          fall = out * dmg_range(b, 0.15f, 0.5f), r = 0.05f, x = 0.46f * wide;
    int kind = dmg_int(b, 0, 2);
    dmg_box_span(b, v3(-0.55f * wide, 0, -0.12f), v3(0.55f * wide, high + 0.3f, -0.1f));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.505f * wide, high + 0.1f, -0.02f), v3(0.02f, 0.16f, 0.16f));
    dmg_spin(b, 0, "roller", v3(0, high + 0.1f, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-0.49f * wide, high + 0.1f, 0), v3(0.49f * wide, high + 0.1f, 0), r);
    dmg_use(b, 0);
    if (kind == 0) { /* arms in two links, level, the elbow inwards */
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s, link = 0.52f * out, bend = 0.4f;
            dmg_vec root = {side * x, high - 0.12f, 0},
                    elbow = {side * (x - link * sinf(bend)), high - 0.12f, link * cosf(bend)},
                    end = {side * x, high - 0.12f, 2 * link * cosf(bend)};
            dmg_box_span(b, v3(root.x - 0.04f, root.y - 0.06f, -0.1f), v3(root.x + 0.04f, root.y - 0.022f, 0.04f));
            uint32_t arm = dmg_hinge(b, 0, "awning_arm", root, v3(0, -side, 0), -0.9f, 0.2f);
            dmg_beam(b, root, elbow, 0.05f, 0.04f);
            dmg_hinge(b, arm, "forearm", elbow, v3(0, side, 0), -1.6f, 0.4f);
            dmg_beam(b, v3(elbow.x, elbow.y + 0.044f, elbow.z), v3(end.x, end.y + 0.044f, end.z), 0.045f, 0.04f);
            dmg_use(b, 0);
        }
        return;
    }
    float low = high - (kind == 1 ? fall : out);
    uint32_t frame = dmg_hinge(b, 0, "awning", v3(0, kind == 1 ? high : low, 0), v3(kind == 1 ? -1.0f : 1.0f, 0, 0),
                               kind == 1 ? -0.3f : -0.6f, 1.0f);
    dmg_vec root = {0, kind == 1 ? high : low, 0}, end = {0, kind == 1 ? low : low + 0.4f * out, out};
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3((float)s * x, root.y, 0), v3((float)s * x, end.y, end.z), 0.018f);
    dmg_rod(b, v3(-x, end.y, end.z), v3(x, end.y, end.z), 0.022f);
    dmg_rod(b, v3(-x, root.y, 0), v3(x, root.y, 0), 0.018f);
    if (kind == 1) dmg_beam(b, v3(0, root.y + 0.03f, 0.01f), v3(0, end.y + 0.03f, end.z), 2 * x, 0.006f);
    if (kind == 1 && dmg_chance(b, 0.5f)) { /* the valance hangs freely */
        dmg_hinge(b, frame, "valance", end, v3(1, 0, 0), -0.6f, 0.6f);
        dmg_box_span(b, v3(-x, end.y - 0.2f, end.z - 0.004f), v3(x, end.y - 0.024f, end.z + 0.004f));
    }
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * (x + 0.04f), root.y, -0.03f), v3(0.04f, 0.08f, 0.14f));
}

/* On a flue: a head that the wind turns, of vanes or with a mouth and a tail. */
static void draw_cowl(dmg_builder* b) {
    float r = dmg_range(b, 0.1f, 0.35f), foot = r * dmg_range(b, 0.8f, 2.5f);
    int vanes = dmg_int(b, 10, 20);
    bool tail = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-1.7f * r, 0, -1.7f * r), v3(1.7f * r, 0.05f * r, 1.7f * r));
    dmg_rod(b, v3(0, 0.05f * r, 0), v3(0, foot, 0), 0.8f * r);
    dmg_spin(b, 0, "cowl", v3(0, foot, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, foot + 0.01f * r, 0), v3(0, foot + 0.1f * r, 0), r);
    if (tail) {
        const dmg_vec neck[] = {{0, foot + 0.1f * r, 0},
                                {0, foot + 0.7f * r, 0.1f * r},
                                {0, foot + 1.3f * r, 0.5f * r},
                                {0, foot + 1.5f * r, 1.2f * r}};
        dmg_sweep(b, neck, 4, 0.75f * r, 0.75f * r, false);
        dmg_box_span(b, v3(-0.02f * r, foot + 1.0f * r, -1.7f * r), v3(0.02f * r, foot + 2.2f * r, -0.2f * r));
        return;
    }
    dmg_dome(b, v3(0, foot + 1.5f * r, 0), v3(r, 0.4f * r, r));
    for (int i = 0; i < vanes; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, vanes);
        const dmg_vec rib[] = {{0.9f * r, foot + 0.08f * r, 0},
                               {1.25f * r, foot + 0.6f * r, 0.15f * r},
                               {1.25f * r, foot + 1.0f * r, 0.3f * r},
                               {0.85f * r, foot + 1.54f * r, 0.45f * r}};
        dmg_sweep(b, rib, 4, 0.02f * r, 0.14f * r, false);
        dmg_restore(b);
    }
}

void dmg_build_roof_vent(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){2, 1.4f, 1.2f, 1.3f, 1.3f, 1.3f, 0.8f}, 7);
    if (design == 0) draw_skylight(b);
    if (design == 1) draw_smoke_vent(b);
    if (design == 2) draw_greenhouse(b);
    if (design == 3 || design == 4) draw_slats(b, design == 4);
    if (design == 5) draw_awning(b);
    if (design == 6) draw_cowl(b);
}
