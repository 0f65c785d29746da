/* Draws drills that a hand drives. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what turns in the quill ---- */

/* Draws a keyed or keyless chuck with its bit, its upper end at `at`. */
static void draw_chuck(dmg_builder* b, uint32_t parent, dmg_vec at, float r, bool endless) {
    int kind = dmg_int(b, 0, 2);
    float high = r * dmg_range(b, 1.8f, 3.0f), bit = r * dmg_range(b, 1.0f, 4.0f);
    bool empty = dmg_chance(b, 0.3f);
    const dmg_xy keyed[] = {{0, -high},
                            {0.35f * r, -high},
                            {0.8f * r, -0.6f * high},
                            {0.8f * r, -0.4f * high},
                            {r, -0.4f * high},
                            {r, -0.15f * high},
                            {0.8f * r, 0},
                            {0, 0}};
    const dmg_xy keyless[] = {{0, -high}, {0.5f * r, -high}, {r, -0.6f * high}, {r, 0}, {0, 0}};
    if (endless) dmg_spin(b, parent, "chuck", at, v3(0, 1, 0));
    if (kind == 0) dmg_lathe(b, at, v3(0, 1, 0), keyed, 8);
    if (kind == 1) dmg_lathe(b, at, v3(0, 1, 0), keyless, 5);
    if (kind == 2) dmg_cone(b, at, v3(at.x, at.y - high, at.z), r, 0.6f * r);
    if (!empty) dmg_rod(b, v3(at.x, at.y - 0.95f * high, at.z), v3(at.x, at.y - high - bit, at.z), 0.14f * r);
    dmg_use(b, parent);
}

/* ---- driven by hand ---- */

/* A turned grip between two points. */
static void draw_grip(dmg_builder* b, dmg_vec from, dmg_vec to, float r) {
    float span = v3_length(v3_sub(to, from));
    const dmg_xy pear[] = {{0, 0},           {0.6f * r, 0}, {0.7f * r, 0.3f * span}, {r, 0.75f * span},
                           {0.7f * r, span}, {0, span}};
    if (dmg_chance(b, 0.4f))
        dmg_rod(b, from, to, 0.8f * r);
    else
        dmg_lathe(b, from, v3_sub(to, from), pear, 6);
}

/* A bevel wheel with a crank at the side drives a pinion over the chuck; a side grip unscrews. */
static void draw_eggbeater(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.04f, 0.06f), gear = tall * dmg_range(b, 0.13f, 0.2f),
          y = tall * dmg_range(b, 0.42f, 0.5f), t = 0.25f * r, side = dmg_sign(b),
          arm = gear * dmg_range(b, 0.8f, 1.3f), out = r * dmg_range(b, 1.6f, 2.2f);
    int pinions = dmg_int(b, 1, 2), kind = dmg_chance(b, 0.5f) ? 3 : 6;
    bool plate = dmg_chance(b, 0.3f);
    float low = y - gear - 0.6f * r;
    dmg_box_span(b, v3(-0.35f * r, low, -0.5f * r), v3(0.35f * r, 0.75f * tall, 0.5f * r));
    dmg_rod(b, v3(0, low - 0.5f * r, 0), v3(0, low, 0), 0.6f * r);
    draw_grip(b, v3(0, 0.75f * tall, 0), v3(0, tall, 0), r);
    if (plate) dmg_rounded_box(b, v3(0, tall, 0), v3(5 * r, 0.8f * r, 2.5f * r), 0.3f * r);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * side);
    uint32_t wheel = dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0.2f * r), v3(0, 0, out + t), 0.3f * r);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.8f * r);
    dmg_wheel_draw(b, kind, gear, 0.4f * r, 5);
    dmg_restore(b);
    dmg_beam(b, v3(0, 0, out), v3(0, arm, out), 0.7f * r, t);
    dmg_spin(b, wheel, "knob", v3(0, arm, 0), v3(0, 0, 1));
    draw_grip(b, v3(0, arm, out + t), v3(0, arm, out + 3.5f * r), 0.7f * r);
    dmg_restore(b);
    for (int i = 0; i < pinions; ++i) {
        float at = i ? y + gear : y - gear;
        dmg_spin(b, 0, "pinion", v3(0, at, 0), v3(0, 1, 0));
        dmg_cone(b, v3(0, at - 0.3f * r, 0), v3(0, at + 0.3f * r, 0), 0.75f * r, 0.6f * r);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) {
        dmg_rod(b, v3(0, 0.62f * tall, 0), v3(-side * 1.2f * r, 0.62f * tall, 0), 0.3f * r);
        draw_grip(b, v3(-side * 1.2f * r, 0.62f * tall, 0), v3(-side * 4.5f * r, 0.62f * tall, 0), 0.7f * r);
    }
    draw_chuck(b, 0, v3(0, low - 0.5f * r, 0), 0.75f * r, true);
}

/* Draws a bow turned about the line through its head and its chuck; the sleeve on it spins, the ratchet's ring turns.
 */
static void draw_brace(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.025f, 0.035f), sweep = tall * dmg_range(b, 0.28f, 0.42f), y0 = 0.28f * tall,
          y1 = 0.85f * tall;
    bool ratchet = dmg_chance(b, 0.5f), sharp = dmg_chance(b, 0.5f);
    float run = sharp ? 0.02f * tall : 0.12f * tall;
    const dmg_xy head[] = {{0, 0},       {1.5f * r, 0}, {1.3f * r, 1.5f * r}, {4 * r, 2.5f * r}, {3.4f * r, 4 * r},
                           {0, 4.6f * r}};
    dmg_lathe(b, v3(0, y1 + 0.05f * tall, 0), v3(0, 1, 0), head, 6);
    uint32_t bow = dmg_spin(b, 0, "bow", v3(0, 0, 0), v3(0, 1, 0));
    dmg_vec low = v3(sweep, y0 + 0.14f * tall + run, 0), high = v3(sweep, y1 - 0.14f * tall - run, 0);
    const dmg_vec path[] = {v3(0, y0 - 0.02f * tall, 0), v3(0, y0 + 0.08f * tall, 0), low, high,
                            v3(0, y1 - 0.08f * tall, 0), v3(0, y1 + 0.045f * tall, 0)};
    dmg_sweep(b, path, 6, 0.6f * r, 0.6f * r, false);
    dmg_spin(b, bow, "sleeve", low, v3(0, 1, 0));
    dmg_vec from = v3_lerp(low, high, 0.12f), to = v3_lerp(low, high, 0.88f);
    draw_grip(b, from, to, 1.8f * r);
    if (ratchet) {
        dmg_hinge(b, bow, "ratchet", v3(0, y0, 0), v3(0, 1, 0), -0.5f, 0.5f);
        dmg_rod(b, v3(0, y0 - 0.02f * tall, 0), v3(0, y0 + 0.03f * tall, 0), 1.6f * r);
    }
    draw_chuck(b, bow, v3(0, y0 - 0.025f * tall, 0), 1.4f * r, dmg_chance(b, 0.5f));
    dmg_use(b, 0);
}

/* Draws a handle with a slider on a spiral shaft, or a plain screwdriver whose cap or shank turns. */
static void draw_pump_driver(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.045f, 0.075f), grip = tall * dmg_range(b, 0.35f, 0.5f), way = 0.3f * tall;
    bool pumps = dmg_chance(b, 0.5f), cap = dmg_chance(b, 0.5f), ring = dmg_chance(b, 0.6f);
    const dmg_xy body[] = {
        {0, tall - grip},        {0.7f * r, tall - grip},  {r, tall - 0.8f * grip}, {0.8f * r, tall - 0.55f * grip},
        {r, tall - 0.2f * grip}, {0.9f * r, 0.99f * tall}, {0, 0.99f * tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 7);
    if (cap) {
        dmg_spin(b, 0, "cap", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.99f * tall, 0), v3(0, 1.04f * tall, 0), 0.85f * r);
    }
    if (ring) { /* turned to reverse the ratchet */
        dmg_hinge(b, 0, "selector", v3(0, 0, 0), v3(0, 1, 0), -0.45f, 0.45f);
        dmg_rod(b, v3(0, tall - grip - 0.8f * r, 0), v3(0, tall - 1.002f * grip, 0), 0.8f * r);
        dmg_box_span(b, v3(-0.15f * r, tall - grip - 0.7f * r, 0.7f * r),
                     v3(0.15f * r, tall - grip - 0.1f * r, 1.1f * r));
    }
    uint32_t shaft = pumps ? dmg_slide(b, 0, "shaft", v3(0, 1, 0), 0.0f, fminf(way, 0.7f * (tall - grip))) : 0;
    if (pumps) dmg_rod(b, v3(0, 0.3f * tall, 0), v3(0, tall - grip, 0), 0.4f * r);
    dmg_spin(b, shaft, "shank", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.08f * tall, 0), v3(0, pumps ? 0.3f * tall : tall - grip, 0), 0.28f * r);
    dmg_cone(b, v3(0, 0.02f * tall, 0), v3(0, 0.08f * tall, 0), 0.12f * r, 0.28f * r);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0.07f * tall, 0), v3(0, 0.2f * tall, 0), 0.55f * r);
    dmg_box_span(b, v3(-0.3f * r, 0, -0.06f * r), v3(0.3f * r, 0.04f * tall, 0.06f * r));
    dmg_use(b, 0);
}

/* Draws a spinning tool held like a pen: collet with a disc or burr, lock button, switch that slides, hanging ring. */
static void draw_rotary(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.09f, 0.13f), neck = tall * 0.3f, disc = r * dmg_range(b, 0.4f, 1.3f);
    bool bail = dmg_chance(b, 0.5f), slides = dmg_chance(b, 0.5f), wheel = dmg_chance(b, 0.5f);
    const dmg_xy body[] = {{0, neck - 0.1f * tall},
                           {0.45f * r, neck - 0.1f * tall},
                           {0.6f * r, neck},
                           {r, neck + 0.15f * tall},
                           {r, 0.9f * tall},
                           {0.75f * r, tall},
                           {0, tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 7);
    dmg_spin(b, 0, "collet", v3(0, 0, 0), v3(0, 1, 0));
    dmg_cone(b, v3(0, neck - 0.18f * tall, 0), v3(0, neck - 0.1f * tall, 0), 0.25f * r, 0.4f * r);
    dmg_rod(b, v3(0, neck - 0.28f * tall, 0), v3(0, neck - 0.15f * tall, 0), 0.08f * r);
    if (wheel) dmg_rod(b, v3(0, neck - 0.29f * tall, 0), v3(0, neck - 0.275f * tall, 0), disc);
    if (!wheel) dmg_ellipsoid(b, v3(0, neck - 0.28f * tall, 0), v3(0.2f * r, 0.4f * r, 0.2f * r));
    dmg_use(b, 0);
    dmg_slide(b, 0, "lock", v3(0, 0, -1), 0.0f, 0.15f * r);
    dmg_rod(b, v3(0, neck + 0.05f * tall, 0.6f * r), v3(0, neck + 0.05f * tall, 1.0f * r), 0.2f * r);
    if (slides) {
        dmg_slide(b, 0, "switch", v3(0, 1, 0), 0.0f, 0.1f * tall);
        dmg_rounded_box(b, v3(0, 0.65f * tall, 1.02f * r), v3(0.5f * r, 0.06f * tall, 0.2f * r), 0.05f * r);
    } else { /* a ring at the end sets the speed */
        dmg_hinge(b, 0, "speed", v3(0, 0, 0), v3(0, 1, 0), 0.0f, 4.5f);
        dmg_rod(b, v3(0, 0.8f * tall, 0), v3(0, 0.87f * tall, 0), 1.05f * r);
        dmg_box(b, v3(0, 0.835f * tall, 1.05f * r), v3(0.1f * r, 0.05f * tall, 0.1f * r));
    }
    if (bail) {
        dmg_hinge(b, 0, "bail", v3(0, 0.95f * tall, 0), v3(1, 0, 0), -1.4f, 1.4f);
        const dmg_vec bow[] = {v3(-r, 0.95f * tall, 0), v3(-r, tall + 0.3f * r, 0), v3(0, tall + 0.9f * r, 0),
                               v3(r, tall + 0.3f * r, 0), v3(r, 0.95f * tall, 0)};
        dmg_sweep(b, bow, 5, 0.07f * r, 0.07f * r, false);
    }
    dmg_use(b, 0);
}

void dmg_build_hand_drill(dmg_builder* b) {
    float tall = dmg_scale_range(b, 0.18f, 0.45f);
    if (dmg_chance(b, 0.5f)) { /* lying down */
        dmg_move(b, 0, 0.1f * tall, -0.5f * tall);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    }
    switch (dmg_int(b, 0, 3)) {
    case 0:
        draw_eggbeater(b, tall);
        break;
    case 1:
        draw_brace(b, tall);
        break;
    case 2:
        draw_pump_driver(b, tall);
        break;
    default:
        draw_rotary(b, tall);
        break;
    }
}
