/* Implements what machine tools share: hand wheels and levers. */
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
