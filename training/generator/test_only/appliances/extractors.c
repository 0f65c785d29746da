/* Draws cooker hoods with visors, flaps, filters and controls, on the wall, under a cabinet, over an island or out
 * of the worktop; and fans in walls behind slats or covers. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- hoods: the back at z = 0, the lower edge at y = 0 ---- */

typedef struct hood {
    float w, d, lip; /* lip: height of the straight band in front */
} hood;

/* Grids below, each let down on its rear or front edge. */
static void draw_filters(dmg_builder* b, float w, float z0, float z1, float y) {
    int count = dmg_int(b, 1, 3);
    bool rear = dmg_chance(b, 0.5f);
    float each = w / (float)count, t = 0.012f, swing = dmg_range(b, 0.8f, 1.5f);
    for (int i = 0; i < count; ++i) {
        float x = each * ((float)i + 0.5f) - 0.5f * w, half = 0.47f * each;
        dmg_hinge(b, 0, "filter", v3(x, y, rear ? z0 : z1), v3(rear ? 1.0f : -1.0f, 0, 0), 0.0f, swing);
        dmg_box_span(b, v3(x - half, y - t, z0), v3(x + half, y - 0.001f, z1));
        for (int k = 0; k < 4; ++k) {
            float at = z0 + (z1 - z0) * ((float)k + 0.5f) / 4.0f;
            dmg_box_span(b, v3(x - 0.9f * half, y - 1.5f * t, at - 0.006f), v3(x + 0.9f * half, y - t, at + 0.006f));
        }
        dmg_use(b, 0);
    }
}

/* On the band in front: a slide, knobs, keys, rockers or a lamp's cover. */
static void draw_hood_controls(dmg_builder* b, const hood* h, float z) {
    float y = 0.5f * h->lip, size = 0.3f * h->lip, x = h->w * dmg_range(b, -0.3f, 0.3f);
    int kind = dmg_int(b, 0, 3), count = dmg_int(b, 1, 3);
    dmg_save(b);
    dmg_move(b, x, y, z);
    if (kind == 0)
        for (int i = 0; i < count; ++i) {
            float at = 0.07f * ((float)i - 0.5f * (float)(count - 1));
            dmg_box(b, v3(at, 0, 0.001f), v3(0.055f, 0.6f * size, 0.002f));
            dmg_slide(b, 0, "slide", v3(1, 0, 0), 0.0f, 0.034f);
            dmg_box(b, v3(at - 0.017f, 0, 0.006f), v3(0.012f, size, 0.008f));
            dmg_use(b, 0);
        }
    if (kind == 1) dmg_knobs_draw(b, 0, count, 3.5f * size, 0, size);
    if (kind == 2) {
        dmg_buttons keys = {.name = "key", .rows = 1, .width = size, .height = size, .rise = 0.006f};
        keys.columns = count + 2;
        keys.pitch_x = 1.4f * size;
        keys.kind = dmg_int(b, 0, 3);
        keys.travel = dmg_button_way(b, keys.rise);
        dmg_buttons_draw(b, 0, &keys);
    }
    for (int i = 0; i < count && kind == 3; ++i) {
        float at = 2.2f * size * (float)i;
        dmg_hinge(b, 0, "rocker", v3(at, 0, 0), v3(0, -1, 0), -0.2f, 0.2f);
        dmg_box(b, v3(at, 0, 0.004f), v3(1.6f * size, size, 0.006f));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Spots that turn in their cups below. */
static void draw_spots(dmg_builder* b, float w, float z, float y) {
    int count = dmg_int(b, 1, 2);
    for (int i = 0; i < count; ++i) {
        float x = count > 1 ? 0.38f * w * (i ? 1.0f : -1.0f) : 0.0f;
        dmg_hinge(b, 0, "spot", v3(x, y - 0.012f, z), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_cone(b, v3(x, y - 0.002f, z), v3(x, y - 0.035f, z), 0.02f, 0.032f);
        dmg_use(b, 0);
    }
}

/* The duct's sleeve runs up over the one inside it, or down. */
static void draw_chimney(dmg_builder* b, float y, float z) {
    float w = dmg_range(b, 0.2f, 0.36f), d = dmg_range(b, 0.18f, 0.3f), low = dmg_range(b, 0.25f, 0.5f),
          way = low * dmg_range(b, 0.3f, 0.8f), top = y + low;
    bool round = dmg_chance(b, 0.25f), slides = dmg_chance(b, 0.6f) && !round;
    float x = 0.5f * w, half = 0.5f * d, t = 0.005f;
    if (round) dmg_rod(b, v3(0, y, z), v3(0, top, z), half);
    for (int i = -1; i <= 1 && !round; i += 2) { /* sheets, so that the sleeve has room between them */
        dmg_box_span(b, v3((float)i * (x - t) - t, y, z - half), v3((float)i * (x - t) + t, top, z + half));
        dmg_box_span(b, v3(2 * t - x, y, z + (float)i * (half - t) - t),
                     v3(x - 2 * t, top, z + (float)i * (half - t) + t));
    }
    if (slides) dmg_slide(b, 0, "chimney", v3(0, 1, 0), 0.0f, way);
    if (round)
        dmg_rod(b, v3(0, y + 0.05f, z), v3(0, top + 0.1f, z), 0.46f * d);
    else
        dmg_box_span(b, v3(2.1f * t - x, y + 0.01f, z - half + 2.1f * t),
                     v3(x - 2.1f * t, top + 0.1f, z + half - 2.1f * t));
    dmg_use(b, 0);
}

/* Under a chimney: a pyramid, a flat slab, a bowed glass, a barrel; on the wall or hung over an island. */
static void draw_chimney_hood(dmg_builder* b, hood* h) {
    int shape = dmg_int(b, 0, 2);
    float tall = shape == 0 ? dmg_range(b, 0.15f, 0.35f) : dmg_range(b, 0.02f, 0.08f), z = 0.17f, top = h->lip + tall;
    bool island = dmg_chance(b, 0.35f), visor = dmg_chance(b, 0.35f);
    if (island) z = 0.5f * h->d;
    float x = 0.5f * h->w, near = z - 0.15f, far = z + 0.15f;
    dmg_box_span(b, v3(-x, 0.002f, 0), v3(x, h->lip, h->d));
    if (shape == 0) {
        const dmg_xy side[] = {{0, h->lip}, {h->d, h->lip}, {far, top}, {near, top}};
        dmg_side_prism(b, side, 4, -0.6f * x, 0.6f * x);
        for (int i = -1; i <= 1; i += 2)
            dmg_beam(b, v3(0.95f * (float)i * x, h->lip, 0.5f * h->d), v3(0.17f * (float)i, top - 0.02f, z),
                     0.9f * h->d, 0.02f);
    } else if (shape == 1) {
        const dmg_xy pane[] = {{-1.15f * x, h->lip - 0.01f},
                               {-0.6f * x, h->lip + 0.02f},
                               {0, h->lip + 0.03f},
                               {0.6f * x, h->lip + 0.02f},
                               {1.15f * x, h->lip - 0.01f}};
        dmg_save(b);
        dmg_move(b, 0, 0, 0.55f * h->d);
        dmg_bent_plate(b, pane, 5, 0.008f, 1.15f * h->d);
        dmg_restore(b);
    } else {
        dmg_box_span(b, v3(-0.7f * x, h->lip, 0), v3(0.7f * x, top, 0.8f * h->d));
    }
    draw_chimney(b, fmaxf(top - 0.005f, h->lip), z);
    draw_filters(b, 0.85f * h->w, 0.1f * h->d, 0.75f * h->d, 0.0f);
    draw_spots(b, h->w, 0.87f * h->d, 0.002f);
    if (visor && shape != 1) { /* a pane drawn out from under the band */
        dmg_slide(b, 0, "visor", v3(0, 0, 1), 0.0f, 0.6f * h->d);
        dmg_box_span(b, v3(-0.97f * x, h->lip + 0.001f, shape ? 0.81f * h->d : 0.97f * h->d),
                     v3(0.97f * x, h->lip + 0.007f, h->d + 0.01f));
        dmg_box_span(b, v3(-0.97f * x, h->lip - 0.02f, h->d + 0.001f), v3(0.97f * x, h->lip + 0.012f, h->d + 0.015f));
        dmg_use(b, 0);
    }
    draw_hood_controls(b, h, h->d);
}

/* Below a cabinet: its front is drawn out or tips up, on a body whose motor stands back. */
static void draw_slim_hood(dmg_builder* b, hood* h) {
    float x = 0.5f * h->w, box = dmg_range(b, 0.1f, 0.3f), t = 0.012f, back = 0.6f * h->d, way = back * 0.8f;
    bool flap = dmg_chance(b, 0.45f);
    dmg_box_span(b, v3(-x, h->lip, 0), v3(x, h->lip + box, back));
    dmg_box_span(b, v3(-x, 0.002f, 0), v3(x, h->lip, 0.12f * h->d));
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * (x - 0.5f * t) - 0.5f * t, 0.002f, 0.12f * h->d),
                     v3((float)i * (x - 0.5f * t) + 0.5f * t, h->lip, back));
    if (flap) {
        dmg_hinge(b, 0, "flap", v3(0, h->lip + box, back), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.2f));
        dmg_box_span(b, v3(-x, 0, back + 0.002f), v3(x, h->lip + box, back + 1.5f * t));
        if (dmg_chance(b, 0.6f))
            dmg_box_span(b, v3(-0.3f * x, 0.01f, back + 1.5f * t), v3(0.3f * x, 0.03f, back + 4 * t));
        dmg_use(b, 0);
        draw_filters(b, 1.8f * x, 0.13f * h->d, back - 0.02f, 0.0f);
        return;
    }
    uint32_t visor = dmg_slide(b, 0, "visor", v3(0, 0, 1), 0.0f, way);
    dmg_box_span(b, v3(t - x + 0.002f, 0.2f * h->lip, 0.15f * h->d), v3(x - t - 0.002f, 0.8f * h->lip, back + 0.002f));
    dmg_box_span(b, v3(-x, 0, back + 0.002f), v3(x, h->lip + 0.01f, back + 2 * t));
    if (dmg_chance(b, 0.4f)) { /* its own flap in front of that */
        dmg_hinge(b, visor, "visor_flap", v3(0, h->lip + 0.01f, back + 2 * t), v3(-1, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.95f * x, 0.1f * h->lip, back + 2.1f * t), v3(0.95f * x, h->lip, back + 2.8f * t));
    }
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, h->lip + 0.2f * box, 0);
    draw_hood_controls(b, h, back);
    dmg_restore(b);
}

/* Draws a leaning front whose large pane opens upwards; a second one below it. */
static void draw_leaning_hood(dmg_builder* b, hood* h) {
    float tall = dmg_range(b, 0.4f, 0.7f), deep = dmg_range(b, 0.25f, 0.45f), x = 0.5f * h->w, t = 0.01f,
          split = dmg_range(b, 0.4f, 0.9f), lean = atan2f(deep - 0.1f, tall), length = tall / cosf(lean);
    bool two = dmg_chance(b, 0.5f);
    const dmg_xy side[] = {{0, 0}, {0.1f, 0}, {deep, tall}, {0, tall}};
    dmg_side_prism(b, side, 4, -0.94f * x, 0.94f * x);
    draw_chimney(b, tall - 0.02f, 0.16f);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.1f);
    dmg_turn(b, v3(1, 0, 0), lean);
    float cut = two ? split * length : 0.03f;
    dmg_hinge(b, 0, "pane", v3(0, 0.97f * length, t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
    dmg_box_span(b, v3(-x, cut, 0.3f * t), v3(x, 0.97f * length, t));
    if (two) {
        dmg_hinge(b, 0, "lower_pane", v3(0, 0.02f, t), v3(1, 0, 0), 0.0f, 1.0f);
        dmg_box_span(b, v3(-x, 0.02f, 0.3f * t), v3(x, cut - 0.004f, t));
    }
    dmg_use(b, 0);
    dmg_restore(b);
}

/* It comes up out of the worktop when wanted, a flap over its mouth. */
static void draw_worktop_hood(dmg_builder* b, hood* h) {
    float rise = dmg_range(b, 0.2f, 0.4f), x = 0.45f * h->w, t = dmg_range(b, 0.02f, 0.05f), y = 0.45f;
    dmg_box_span(b, v3(-x, 0, -t), v3(x, 0.02f, t));
    for (int i = -1; i <= 1; i += 2) {
        dmg_box_span(b, v3(-x, 0, (float)i * 1.2f * t - 0.1f * t), v3(x, y, (float)i * 1.2f * t + 0.1f * t));
        dmg_box_span(b, v3(-0.8f * h->w, y, i < 0 ? -0.25f : 1.3f * t),
                     v3(0.8f * h->w, y + 0.03f, i < 0 ? -1.3f * t : 0.35f));
    }
    uint32_t tower = dmg_slide(b, 0, "tower", v3(0, 1, 0), 0.0f, rise);
    dmg_rest(b, tower, rise);
    dmg_keep_rest(b, tower);
    dmg_box_span(b, v3(-0.97f * x, 0.03f, -t), v3(0.97f * x, y + 0.025f, t));
    dmg_box_span(b, v3(-x, y + 0.031f, -1.4f * t), v3(x, y + 0.04f, 1.4f * t));
    dmg_hinge(b, tower, "flap", v3(0, y + 0.02f, t + 0.001f), v3(-1, 0, 0), 0.0f, 0.9f);
    dmg_box_span(b, v3(-0.9f * x, y - 0.6f * rise, t + 0.001f), v3(0.9f * x, y + 0.02f, 1.09f * t));
    dmg_use(b, 0);
}

/* In the wall: a fan in a square behind slats that the air lifts, a cover that swings off or a cord's pull. */
static void draw_wall_fan(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.06f, 0.4f), half = 1.15f * r, deep = r * dmg_range(b, 0.4f, 1.0f), t = 0.06f * r;
    int slats = dmg_int(b, 0, 6), blades = dmg_int(b, 3, 7);
    dmg_move(b, 0, half, 0);
    dmg_holed_plate_draw(b, 2 * half, 2 * half, 2 * t, r);
    dmg_save(b);
    dmg_move(b, 0, 0, -2 * t);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * half, 2 * half, deep, t);
    dmg_restore(b);
    for (int i = 0; i < 2; ++i) dmg_box(b, v3(0, 0, -deep), i ? v3(2 * half - t, t, t) : v3(t, 2 * half - t, t));
    dmg_spin(b, 0, "fan", v3(0, 0, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_move(b, 0, 0, -0.6f * deep - t);
    dmg_rod(b, v3(0, 0, -0.3f * deep), v3(0, 0, 0.15f * deep), 0.2f * r);
    dmg_blades_draw(b, 0, 0.9f * r, 0.2f * r, 0.35f * r, blades, 0.6f);
    dmg_restore(b);
    dmg_use(b, 0);
    float each = 2 * half / (float)(slats ? slats : 1);
    for (int i = 0; i < slats; ++i) {
        float y = half - each * (float)i;
        dmg_hinge(b, 0, "slat", v3(0, y, 0.6f * t), v3(-1, 0, 0), 0.0f, 1.3f);
        dmg_box_span(b, v3(-half, y - 0.97f * each, 0.1f * t), v3(half, y, 0.6f * t));
        dmg_use(b, 0);
    }
    if (slats) return;
    dmg_hinge(b, 0, "cover", v3(-half, 0, 0), v3(0, -1, 0), 0.0f, 1.7f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_panel_draw(b,
                   &(dmg_panel){.kind = DMG_PANEL_LOUVRES, .border = 0.12f, .infill = 0.5f, .bars_x = 1, .bars_y = 7},
                   2 * half, 2 * half, 0.9f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_range_hood(dmg_builder* b) {
    hood h = {.w = dmg_range(b, 0.5f, 1.1f)};
    h.d = dmg_range(b, 0.42f, 0.6f);
    h.lip = dmg_range(b, 0.04f, 0.09f);
    switch (dmg_weighted(b, (const float[]){4, 3, 2, 1, 2}, 5)) {
    case 0:
        draw_chimney_hood(b, &h);
        break;
    case 1:
        draw_slim_hood(b, &h);
        break;
    case 2:
        draw_leaning_hood(b, &h);
        break;
    case 3:
        draw_worktop_hood(b, &h);
        break;
    default:
        draw_wall_fan(b);
        break;
    }
}
