/* Draws cable cars with doors, grips and hangers, chairs with bars and bubbles, and the bull wheel they turn round. */
#include "core/build.h"
#include "parts/walls.h"
#include "parts/works.h"

/* ---- what hangs on the rope ---- */

/* Draws a clamp on the rope at y: a jaw that opens, wheels beside it, a hanger swinging below. Returns the hanger. */
static uint32_t draw_grip(dmg_builder* b, float y, float drop, float arm) {
    float s = dmg_range(b, 0.15f, 0.3f), r = 0.35f * s, side = dmg_sign(b);
    bool along = dmg_chance(b, 0.3f), wheels = dmg_chance(b, 0.6f);
    dmg_rod(b, v3(0, y, -5 * s), v3(0, y, 5 * s), 0.12f * s);
    dmg_box(b, v3(0.25f * s, y - 0.25f * s, 0), v3(0.3f * s, 0.6f * s, 1.2f * s));
    dmg_box(b, v3(0, y - 0.45f * s, 0), v3(0.8f * s, 0.3f * s, 2 * s));
    dmg_hinge(b, 0, "grip_jaw", v3(-0.3f * s, y - 0.28f * s, 0), v3(0, 0, 1), 0.0f, 0.7f);
    dmg_box(b, v3(-0.28f * s, y - 0.02f * s, 0), v3(0.25f * s, 0.5f * s, 0.9f * s));
    dmg_use(b, 0);
    for (int k = -1; k <= 1 && wheels; k += 2) {
        dmg_vec at = {0.6f * s, y + 0.1f * s, (float)k * 0.7f * s};
        dmg_beam(b, v3(0.35f * s, y - 0.4f * s, at.z), v3(at.x - 0.1f * s, at.y, at.z), 0.12f * s, 0.2f * s);
        dmg_spin(b, 0, "grip_wheel", at, v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3_add(at, v3(-0.08f * s, 0, 0)), v3_add(at, v3(0.12f * s, 0, 0)), r);
        dmg_use(b, 0);
    }
    float pin = y - 0.7f * s;
    uint32_t hanger =
        dmg_hinge(b, 0, "hanger", v3(0, pin, 0), along ? v3(0, 0, dmg_sign(b)) : v3(dmg_sign(b), 0, 0), -0.3f, 0.3f);
    dmg_rod(b, along ? v3(0, pin, -0.5f * s) : v3(-0.5f * s, pin, 0),
            along ? v3(0, pin, 0.5f * s) : v3(0.5f * s, pin, 0), 0.12f * s);
    const dmg_vec bow[] = {
        {0, pin, 0}, {side * arm, pin - 0.25f * drop, 0}, {side * arm, pin - 0.75f * drop, 0}, {0, pin - drop, 0}};
    dmg_sweep(b, bow, 4, 0.18f * s, 0.18f * s, false);
    return hanger;
}

/* Draws two leaves in the wall facing +X: they slide apart outside the wall, or swing. */
static void draw_cabin_doors(dmg_builder* b, uint32_t cabin, float x, float y, float wide, float high) {
    int kind = dmg_int(b, 0, 2);
    float each = 0.5f * wide, t = 0.04f;
    dmg_wall_enter(b, v3(x, y, 0), 0.5f * DMG_PI);
    for (int k = -1; k <= 1; k += 2) {
        float s = (float)k;
        dmg_save(b);
        dmg_move(b, s * 0.5f * each, 0, 0);
        if (kind == 2) {
            dmg_wall_leaf_draw(b, cabin, "cabin_door", 0.97f * each, high, k < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
        } else {
            dmg_panel p = kind ? dmg_panel_pick_window(b) : dmg_panel_pick(b);
            dmg_slide(b, cabin, "cabin_door", v3(s, 0, 0), 0.0f, 0.95f * each);
            dmg_move(b, 0, 0, 1.3f * t);
            dmg_panel_draw(b, &p, 0.98f * each, high, t);
        }
        dmg_use(b, cabin);
        dmg_restore(b);
    }
    for (int k = -1; k <= 1 && kind < 2; k += 2)
        dmg_box(b, v3(0, (float)k * 0.51f * high, 0.9f * t), v3(2 * wide, 0.02f * high, 1.8f * t));
    dmg_restore(b);
}

static void draw_cabin(dmg_builder* b) {
    float half = dmg_range(b, 0.7f, 1.5f), end = half * dmg_range(b, 0.9f, 1.8f), high = dmg_range(b, 1.9f, 2.5f),
          low = dmg_range(b, 0.3f, 1.0f), drop = dmg_range(b, 0.8f, 2.5f), t = 0.05f, top = low + high;
    uint32_t cabin = draw_grip(b, top + drop + 0.2f, drop, dmg_chance(b, 0.5f) ? 0.6f * half : 0.0f);
    float belt = low + 0.45f * high, door = end * dmg_range(b, 0.7f, 0.95f);
    bool solid = dmg_chance(b, 0.3f);
    if (solid) {
        dmg_rounded_box(b, v3(0, low + 0.5f * high, 0), v3(2 * half, high, 2 * end), 0.1f * half);
    } else {
        dmg_box_span(b, v3(-half, low, -end), v3(half, low + t, end));
        dmg_box_span(b, v3(-half, top - t, -end), v3(half, top, end));
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(-half, low, (float)k * (end - t) - 0.5f * t),
                         v3(half, belt, (float)k * (end - t) + 0.5f * t));
        dmg_box_span(b, v3(-half, low, -end), v3(-half + t, belt, end));
        for (int k = 0; k < 4; ++k)
            dmg_box(b, v3((k & 1 ? 1.0f : -1.0f) * (half - t), low + 0.5f * high, (k & 2 ? 1.0f : -1.0f) * (end - t)),
                    v3(2 * t, high, 2 * t));
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(half - t, low, fminf((float)k * end, (float)k * 0.55f * door)),
                         v3(half, belt, fmaxf((float)k * end, (float)k * 0.55f * door)));
    }
    dmg_box_span(b, v3(-0.1f * half, top - 0.02f, -0.1f * half), v3(0.1f * half, top + 0.2f, 0.1f * half));
    draw_cabin_doors(b, cabin, half, low + 0.5f * high, door, 0.92f * high);
    if (dmg_chance(b, 0.5f)) {
        dmg_roof_enter(b, v3(0, top, 0.6f * end));
        dmg_wall_leaf_draw(b, cabin, "roof_hatch", 0.6f * half, 0.5f * end, (dmg_side)dmg_int(b, 0, 3));
        dmg_restore(b);
    }
    for (int k = -1; k <= 1; k += 2) { /* windows that tilt, racks for skis */
        dmg_wall_enter(b, v3(0, 0.5f * (belt + top), (float)k * end), k > 0 ? 0.0f : DMG_PI);
        if (dmg_chance(b, 0.5f))
            dmg_wall_leaf_draw(b, cabin, "window", 1.2f * half, 0.25f * high,
                               dmg_chance(b, 0.5f) ? DMG_SIDE_TOP : DMG_SIDE_BOTTOM);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a bench for two to six: the bar comes down from behind with its foot rest, the bubble over it. */
static void draw_chair(dmg_builder* b) {
    float half = 0.28f * (float)dmg_int(b, 2, 6), drop = dmg_range(b, 1.6f, 2.4f), seat = dmg_range(b, 0.5f, 0.9f),
          t = 0.04f, deep = 0.5f, back = 0.6f;
    float top = seat + back + 0.25f;
    uint32_t chair = draw_grip(b, top + drop, drop - 0.1f, 0.0f);
    bool bubble = dmg_chance(b, 0.5f), folds = dmg_chance(b, 0.4f), rest = dmg_chance(b, 0.7f);
    float swing = dmg_range(b, 1.4f, 2.0f);
    dmg_rod(b, v3(-half, top, -0.1f), v3(half, top, -0.1f), t);
    dmg_box(b, v3(0, top, -0.05f), v3(0.12f, 0.25f, 0.2f));
    for (int k = -1; k <= 1; k += 2) {
        const dmg_vec side[] = {
            {(float)k * half, top, -0.1f}, {(float)k * half, seat, -0.15f}, {(float)k * half, seat - 0.05f, deep}};
        dmg_sweep(b, side, 3, 0.6f * t, 0.6f * t, false);
    }
    dmg_box_span(b, v3(-half, seat + 0.12f, -0.15f), v3(half, seat + back, -0.09f));
    if (folds) dmg_hinge(b, chair, "seat", v3(0, seat, -0.08f), v3(-1, 0, 0), 0.0f, 1.3f);
    dmg_box_span(b, v3(-half + t, seat, -0.08f), v3(half - t, seat + 0.07f, deep - 0.05f));
    dmg_use(b, chair);
    dmg_vec pin = {0, top - 0.1f, -0.1f};
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3((float)k * half, pin.y, pin.z), v3((float)k * (half + 0.1f), pin.y, pin.z), 0.6f * t);
    dmg_hinge(b, chair, "bar", pin, v3(-1, 0, 0), 0.0f, swing);
    for (int k = -1; k <= 1; k += 2) {
        const dmg_vec arm[] = {{(float)k * (half + 0.06f), pin.y, pin.z},
                               {(float)k * (half + 0.06f), seat + 0.3f, deep - 0.1f},
                               {(float)k * 0.96f * half, seat + 0.28f, deep},
                               {0, seat + 0.28f, deep}};
        dmg_sweep(b, arm, 4, 0.5f * t, 0.5f * t, false);
        if (rest)
            dmg_beam(b, v3((float)k * 0.4f * half, seat + 0.28f, deep),
                     v3((float)k * 0.4f * half, seat - 0.4f, deep + 0.2f), 0.6f * t, 0.6f * t);
        if (rest)
            dmg_beam(b, v3((float)k * 0.1f * half, seat - 0.4f, deep + 0.2f),
                     v3((float)k * 0.9f * half, seat - 0.4f, deep + 0.2f), 0.6f * t, 0.6f * t);
    }
    dmg_use(b, chair);
    if (bubble) { /* down before the riders; up it goes back as far as the hanger */
        float r = deep + 0.45f, wide = half + 0.16f;
        dmg_xy arc[5];
        for (int i = 0; i < 5; ++i) {
            float a = 0.6f - 0.3f * (float)i;
            arc[i].x = pin.z + r * cosf(a);
            arc[i].y = pin.y + r * sinf(a);
        }
        dmg_hinge(b, chair, "bubble", pin, v3(-1, 0, 0), 0.0f, 0.75f);
        dmg_side_sheet(b, arc, 5, 0.02f, 2 * wide);
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3((float)k * (wide - 0.02f), pin.y, pin.z), v3((float)k * (wide - 0.02f), arc[2].y, arc[2].x),
                     0.5f * t, t);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3((float)k * (half + 0.09f), pin.y, pin.z), v3((float)k * wide, pin.y, pin.z), 0.5f * t);
    }
    dmg_use(b, 0);
}

/* Draws the big wheel at the end of the rope, on a carriage that a weight pulls back; the brake on its rim. */
static void draw_bull_wheel(dmg_builder* b) {
    float r = dmg_range(b, 1.5f, 3.0f), y = dmg_range(b, 3.0f, 4.5f), t = 0.08f * r, way = dmg_range(b, 0.5f, 1.5f);
    int spokes = dmg_int(b, 5, 10);
    bool pulled = dmg_chance(b, 0.6f);
    for (int k = -1; k <= 1; k += 2) {
        dmg_box_span(b, v3((float)k * 0.4f * r - t, 0, -0.3f * r), v3((float)k * 0.4f * r + t, y + 3 * t, 0.3f * r));
        dmg_box_span(b, v3((float)k * 0.4f * r - t, y + 3 * t, -r), v3((float)k * 0.4f * r + t, y + 5 * t, r));
    }
    dmg_box_span(b, v3(-0.7f * r, 0, -0.6f * r), v3(0.7f * r, 0.2f, 0.6f * r));
    uint32_t carriage = pulled ? dmg_slide(b, 0, "carriage", v3(0, 0, -1), -0.5f * way, 0.5f * way) : 0;
    dmg_box_span(b, v3(-0.6f * r, y + 5.1f * t, -0.4f * r), v3(0.6f * r, y + 8 * t, 0.4f * r));
    dmg_rod(b, v3(0, y, 0), v3(0, y + 5.2f * t, 0), t);
    dmg_wall_enter(b, v3(0, y + 6.5f * t, 0.4f * r), 0.0f);
    dmg_wall_leaf_draw(b, carriage, "drive_door", 0.8f * r, 2.4f * t, DMG_SIDE_TOP);
    dmg_restore(b);
    dmg_spin(b, carriage, "bull_wheel", v3(0, y, 0), v3(0, dmg_sign(b), 0));
    dmg_torus(b, v3(0, y, 0), v3(0, 1, 0), r, 0.8f * t);
    dmg_rod(b, v3(0, y - 1.5f * t, 0), v3(0, y + 1.2f * t, 0), 1.8f * t);
    for (int i = 0; i < spokes; ++i) {
        float a = 6.2832f * (float)i / (float)spokes;
        dmg_beam(b, v3(0, y, 0), v3(r * cosf(a), y, r * sinf(a)), 0.8f * t, 0.8f * t);
    }
    dmg_use(b, carriage);
    dmg_box_span(b, v3(-2 * t, y + 1.5f * t, -1.1f * r), v3(2 * t, y + 5 * t, -0.9f * r));
    dmg_hinge(b, carriage, "brake_shoe", v3(0, y + 1.4f * t, -r - 1.6f * t), v3(1, 0, 0), 0.0f, 0.4f);
    dmg_box(b, v3(0, y, -r - 1.6f * t), v3(3 * t, 2.6f * t, t));
    dmg_use(b, 0);
}

void dmg_build_cable_car(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.05f, 0.4f) : 1.0f);
    int kind = dmg_weighted(b, (const float[]){4, 3, 1}, 3);
    if (kind == 0) draw_cabin(b);
    if (kind == 1) draw_chair(b);
    if (kind == 2) draw_bull_wheel(b);
}
