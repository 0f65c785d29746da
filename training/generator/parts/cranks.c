/* Implements crank trains: webs, rods and sliders with their exact ranges. */
#include "parts/cranks.h"

dmg_crank dmg_crank_pick(dmg_builder* b, float throw) {
    dmg_crank c = {.throw = throw, .rod = throw *dmg_range(b, 2.6f, 4.5f)};
    c.angle = dmg_range(b, 0.0f, 2.0f * DMG_PI);
    c.t = throw *dmg_range(b, 0.15f, 0.3f);
    c.bar = dmg_int(b, 0, 4);
    c.eye = dmg_chance(b, 0.8f) ? c.t * dmg_range(b, 0.8f, 1.3f) : 0.0f;
    return c;
}

float dmg_crank_at(const dmg_crank* c, float angle) {
    float side = c->throw *sinf(angle);
    return c->throw *cosf(angle) + sqrtf(c->rod * c->rod - side * side);
}

dmg_vec dmg_crank_pin(const dmg_crank* c, float z) {
    return v3(c->throw *cosf(c->angle), c->throw *sinf(c->angle), z);
}

uint32_t dmg_crank_slider(dmg_builder* b, const dmg_crank* c, const char* name) {
    float at = dmg_crank_at(c, c->angle), in = c->rod - c->throw -at, out = c->rod + c->throw -at;
    return dmg_chance(b, 0.5f) ? dmg_slide(b, 0, name, v3(1, 0, 0), in, out)
                               : dmg_slide(b, 0, name, v3(-1, 0, 0), -out, -in);
}

void dmg_link_draw(dmg_builder* b, const dmg_crank* c, dmg_vec from, dmg_vec to) {
    dmg_vec along = v3_normalize(v3_sub(to, from)), across = v3_cross(v3(0, 0, 1), along);
    float t = c->t;
    if (c->bar == 0) dmg_beam(b, from, to, t, 0.5f * t);
    if (c->bar == 1) dmg_rod(b, from, to, 0.4f * t);
    for (int s = -1; s <= 1 && c->bar == 2; s += 2)
        dmg_beam(b, v3_mad(from, across, (float)s * 0.4f * t), v3_mad(to, across, (float)s * 0.4f * t), 0.6f * t,
                 0.3f * t);
    if (c->bar == 2) dmg_beam(b, from, to, 0.2f * t, 0.7f * t);
    if (c->bar == 3) dmg_cone(b, from, to, 0.35f * t, 0.6f * t);
    for (int s = -1; s <= 1 && c->bar == 4; s += 2) {
        dmg_vec off = {0, 0, (float)s * 0.35f * t};
        dmg_beam(b, v3_add(from, off), v3_add(to, off), 0.2f * t, 0.6f * t);
    }
    dmg_vec half = {0, 0, 0.5f * t};
    if (c->eye > 0.0f) {
        dmg_rod(b, v3_sub(from, half), v3_add(from, half), 0.85f * c->eye);
        dmg_rod(b, v3_sub(to, half), v3_add(to, half), c->eye);
    }
}

uint32_t dmg_crank_rod(dmg_builder* b, const dmg_crank* c, uint32_t slider, float z) {
    dmg_vec wrist = {dmg_crank_at(c, c->angle), 0, z};
    float most = asinf(c->throw / c->rod), now = asinf(c->throw *sinf(c->angle) / c->rod);
    uint32_t rod = dmg_chance(b, 0.5f) ? dmg_hinge(b, slider, "rod", wrist, v3(0, 0, 1), now - most, now + most)
                                       : dmg_hinge(b, slider, "rod", wrist, v3(0, 0, -1), -now - most, most - now);
    dmg_link_draw(b, c, wrist, dmg_crank_pin(c, z));
    return rod;
}

void dmg_tube_draw(dmg_builder* b, dmg_vec at, dmg_vec axis, float length, float bore, float wall) {
    float r = bore + wall;
    const dmg_xy profile[] = {{r, 0}, {r, length}, {bore, length}, {bore, 0}, {r, 0}};
    dmg_lathe(b, at, axis, profile, 5);
}

/* Draws an arm from the shaft to the pin with a counterweight behind. */
static void draw_arm_web(dmg_builder* b, const dmg_crank* c, float thick, bool weight) {
    float w = 1.1f * c->t, r = c->throw, wide = 0.75f * r;
    const dmg_xy arm[] = {{-w, -w}, {r + w, -0.8f * w}, {r + w, 0.8f * w}, {-w, w}};
    const dmg_xy fan[] = {{-w, -w},   {r + w, -0.8f * w}, {r + w, 0.8f * w}, {-w, w},
                          {-r, wide}, {-1.2f * r, 0},     {-r, -wide}};
    if (weight)
        dmg_extrude(b, fan, 7, 0, thick);
    else
        dmg_extrude(b, arm, 4, 0, thick);
}

void dmg_web_draw(dmg_builder* b, const dmg_crank* c, int kind, float z, float thick) {
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_turn(b, v3(0, 0, 1), c->angle);
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0, thick), c->throw +1.3f * c->t);
    if (kind == 1 || kind == 2) draw_arm_web(b, c, thick, kind == 2);
    if (kind == 3) { /* round at both ends */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, thick), 1.3f * c->t);
        dmg_rod(b, v3(c->throw, 0, 0), v3(c->throw, 0, thick), 1.1f * c->t);
        dmg_box(b, v3(0.5f * c->throw, 0, 0.5f * thick), v3(c->throw, 1.8f * c->t, thick));
    }
    dmg_restore(b);
}
