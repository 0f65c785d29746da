/* Implements what machine tools share: hand wheels, levers, stands, panels on arms, walls with sliding doors. */
#include "parts/shop.h"

#include "parts/hardware.h"

/* Draws a hand wheel or crank on a shaft that comes out of z = 0 along +Z. */
static void draw_handwheel(dmg_builder* b, uint32_t parent, const char* name, float r) {
    int kind = dmg_int(b, 0, 4);
    float t = 0.18f * r, out = r * dmg_range(b, 0.3f, 0.7f);
    dmg_spin(b, parent, name, v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0.0f, 6.28f));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), 0.5f * t);
    dmg_move(b, 0, 0, out);
    if (kind < 3) dmg_wheel_draw(b, kind == 0 ? 0 : (kind == 1 ? 3 : 6), r, 1.2f * t, 4);
    if (kind == 3) dmg_beam(b, v3(-0.3f * r, 0, 0), v3(r, 0, 0), 1.4f * t, 0.8f * t);
    for (int i = 0; i < 3 && kind == 4; ++i) { /* three arms with balls */
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 3);
        dmg_rod(b, v3(0, 0, 0), v3(r, 0, 0.2f * r), 0.35f * t);
        dmg_ellipsoid(b, v3(r, 0, 0.2f * r), v3(t, t, t));
        dmg_restore(b);
    }
    if (kind < 4 && dmg_chance(b, 0.7f)) dmg_rod(b, v3(0.8f * r, 0, 0), v3(0.8f * r, 0, 0.6f * r), 0.6f * t);
    dmg_use(b, parent);
}

/* Draws a lever on a boss on z = 0 that turns about Z. */
static void draw_lever(dmg_builder* b, uint32_t parent, const char* name, float length) {
    float t = 0.07f * length, swing = dmg_range(b, 0.3f, 1.2f), lean = dmg_range(b, -0.4f, 0.4f);
    dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0.8f * t), 2.2f * t);
    dmg_hinge(b, parent, name, v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), (dmg_chance(b, 0.7f) ? 0.0f : 1.57f) + lean);
    dmg_rod(b, v3(0, 0, 0.8f * t), v3(0, 0, 3 * t), 1.6f * t);
    dmg_rod(b, v3(0, 0, 2.4f * t), v3(0, length, 4 * t), 0.6f * t);
    dmg_ellipsoid(b, v3(0, length, 4 * t), v3(1.6f * t, 1.6f * t, 1.6f * t));
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Hand wheel, lever or knobs at a place: `turn` about Y brings +Z to where it faces. */
void dmg_handwheel_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float r) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), turn);
    draw_handwheel(b, parent, name, r);
    dmg_restore(b);
}

void dmg_machine_lever_place(dmg_builder* b, uint32_t parent, const char* name, dmg_vec at, float turn, float length) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), turn);
    draw_lever(b, parent, name, length);
    dmg_restore(b);
}

/* The operator's panel: on an arm that turns about a post, on a door, or fixed. Its hinge is at the origin. */
void dmg_pendant_draw(dmg_builder* b, float size) {
    float arm = size * dmg_range(b, 0.2f, 1.2f), t = 0.12f * size;
    uint32_t carrier = 0;
    dmg_rod(b, v3(0, -0.4f * size, 0), v3(0, 0.1f * size, 0), 0.6f * t);
    if (dmg_chance(b, 0.8f)) carrier = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.2f, 1.2f);
    dmg_rod(b, v3(0, 0.1f * size, 0), v3(0, 0.1f * size + t, 0), 0.8f * t);
    dmg_beam(b, v3(0, 0.1f * size + 0.5f * t, 0), v3(arm, 0.1f * size + 0.5f * t, 0), t, t);
    dmg_move(b, arm, 0.1f * size, 0);
    if (carrier && dmg_chance(b, 0.5f))
        carrier = dmg_hinge(b, carrier, "panel", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
    dmg_box(b, v3(0, -0.5f * size, 0), v3(0.8f * size, size, 0.15f * size));
    dmg_box(b, v3(0, -0.25f * size, 0.08f * size), v3(0.6f * size, 0.4f * size, 0.02f * size));
    dmg_move(b, 0, -0.75f * size, 0.075f * size);
    dmg_controls_draw(b, carrier, 0.7f * size, 0.35f * size);
    dmg_use(b, 0);
}

/* Walls round a workroom, x and z centred, floor at y = 0, the front open or behind doors that slide along it. */
void dmg_enclosure_draw(dmg_builder* b, dmg_vec room, float t) {
    float x = 0.5f * room.x, z = 0.5f * room.z, side = room.x * dmg_range(b, 0.05f, 0.3f), sill = room.y * 0.2f;
    bool top = dmg_chance(b, 0.5f), two = dmg_chance(b, 0.5f);
    float way = x - 0.5f * side;
    dmg_box_span(b, v3(-x - t, 0, -z - t), v3(x + t, room.y, -z));
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * (x + 0.5f * t), 0.5f * room.y, 0), v3(t, room.y, 2 * z));
    if (top) dmg_box_span(b, v3(-x - t, room.y, -z - t), v3(x + t, room.y + t, z + 1.5f * t));
    dmg_box_span(b, v3(-x - t, 0, z), v3(x + t, sill, z + t));
    dmg_box_span(b, v3(-x - t, sill, z), v3(-x + side, room.y, z + t));
    dmg_box_span(b, v3(x - side, sill, z), v3(x + t, room.y, z + t));
    if (two) way = 0.5f * way;
    dmg_panel panel = dmg_chance(b, 0.7f) ? dmg_panel_pick_window(b) : dmg_panel_pick(b);
    float wide = x - side, hand = 0.2f * room.y, high = room.y - 0.9f * sill;
    dmg_handle handle = dmg_handle_pick_bar(b, hand);
    if (dmg_chance(b, 0.15f)) return; /* open */
    for (int s = two ? -1 : 1; s <= 1; s += 2) {
        float own = two ? wide : 2 * wide, at = two ? 0.5f * (float)s * wide : 0.0f;
        dmg_save(b);
        dmg_move(b, at, 0.9f * sill + 0.5f * high, z + 2.1f * t);
        uint32_t door = dmg_slide(b, 0, "door", v3((float)s, 0, 0), 0.0f, fminf(0.95f * own, 2 * way));
        if (dmg_chance(b, 0.5f)) dmg_rest(b, door, 0.9f * fminf(own, 2 * way) * dmg_unit(b));
        dmg_panel_draw(b, &panel, 1.02f * own, high, 0.9f * t);
        dmg_move(b, -0.43f * own * (float)s, 0, 0);
        dmg_handle_draw(b, &handle, 0.5f * high);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Below a machine: a cabinet, two pedestals with doors or drawers, legs, nothing. Top at y = 0; returns its height. */
float dmg_machine_stand_draw(dmg_builder* b, float low_x, float high_x, float deep, float unit) {
    int kind = dmg_int(b, 0, 3);
    float high = unit * dmg_range(b, 1.5f, 3.5f),
          wide = fminf(0.4f * (high_x - low_x), unit * dmg_range(b, 1.0f, 2.0f)), tray = 0.1f * unit;
    if (kind == 3) return 0.0f;
    if (dmg_chance(b, 0.6f)) dmg_box_span(b, v3(low_x, -tray, -0.8f * deep), v3(high_x, 0, 0.8f * deep));
    if (kind == 0) dmg_box_span(b, v3(low_x, -high, -0.5f * deep), v3(high_x, -tray, 0.5f * deep));
    for (int s = -1; s <= 1 && kind > 0; s += 2) {
        float x = s < 0 ? low_x + 0.5f * wide : high_x - 0.5f * wide;
        for (int k = -1; k <= 1 && kind == 2; k += 2)
            dmg_beam(b, v3(x, 0, (float)k * 0.3f * deep), v3(x, -high, (float)k * 0.6f * deep), 0.3f * unit,
                     0.2f * unit);
        if (kind == 2) continue;
        dmg_box_span(b, v3(x - 0.5f * wide, -high, -0.5f * deep), v3(x + 0.5f * wide, 0, 0.5f * deep));
        if (!dmg_chance(b, 0.6f)) continue;
        dmg_save(b);
        dmg_move(b, x, -0.5f * high, 0.5f * deep + 0.06f * unit);
        dmg_leaf leaf = dmg_leaf_pick(b, 0.15f * high);
        leaf.width = 0.8f * wide;
        leaf.height = 0.8f * high;
        leaf.thickness = 0.05f * unit;
        leaf.side = s < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    return high;
}
