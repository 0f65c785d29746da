/* Draws levers in gates, and the controls on a ship's bridge: telegraphs, thruster heads, binnacles, steering
 * stands. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- gates: the plate is z = 0, the slot runs along Y ---- */

/* Draws what a hand holds, on z = 0 towards +Z; its line across is X. */
static void draw_grip(dmg_builder* b, int kind, float r) {
    const dmg_xy wing[] = {{-1.3f * r, -0.3f * r}, {1.3f * r, 0}, {-1.3f * r, 0.3f * r}};
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, 0.8f * r), v3(r, r, r));
    if (kind == 1) dmg_rod(b, v3(-0.35f * r, 0, r), v3(0.35f * r, 0, r), 1.1f * r); /* a wheel, as undercarriage has */
    if (kind == 2) dmg_rod(b, v3(-1.6f * r, 0, 0.4f * r), v3(1.6f * r, 0, 0.4f * r), 0.5f * r);
    if (kind == 3) dmg_rounded_box(b, v3(0, 0, 1.2f * r), v3(1.4f * r, 1.1f * r, 2.6f * r), 0.4f * r);
    if (kind == 4) { /* a flap's section */
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * r);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_extrude(b, wing, 3, -1.2f * r, 1.2f * r);
        dmg_restore(b);
    }
}

typedef struct gate {
    float slot, wide, long_, t; /* of the slot, across the plate, along it, its thickness */
    float deep, out, swing;     /* of the pivot; how far the lever reaches; either way */
    int shape;
} gate;

/* Draws a flat plate with a slot through it, notched sometimes, on a box or on two cheeks. */
static void draw_flat_gate(dmg_builder* b, const gate* g, float high) {
    float side = 0.5f * (g->wide - g->slot), end = 0.5f * g->long_ * 0.16f, inner = g->long_ - 2 * end;
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i;
        dmg_box(b, v3(s * 0.5f * (g->slot + side), 0, -0.5f * g->t), v3(side, g->long_, g->t));
        dmg_box(b, v3(0, s * 0.5f * (inner + end), -0.5f * g->t), v3(g->slot, end, g->t));
        if (g->shape == 0) dmg_box(b, v3(s * 0.5f * (g->wide - g->t), 0, -0.5f * high), v3(g->t, g->long_, high));
        if (g->shape == 0) dmg_box(b, v3(0, s * 0.5f * (g->long_ - g->t), -0.5f * high), v3(g->wide, g->t, high));
        if (g->shape == 1)
            dmg_box(b, v3(s * 0.5f * (g->slot + g->t), 0, -0.5f * high), v3(g->t, 0.5f * g->long_, high));
    }
    if (g->shape == 1) dmg_rod(b, v3(-0.6f * g->wide, 0, -g->deep), v3(0.6f * g->wide, 0, -g->deep), 0.4f * g->slot);
    int notches = dmg_chance(b, 0.4f) ? dmg_int(b, 2, 6) : 0;
    float from = dmg_sign(b) * 0.5f * g->slot;
    for (int i = 0; i < notches; ++i) {
        float y = inner * (((float)i + 0.5f) / (float)notches - 0.5f);
        dmg_box(b, v3(from * 1.6f, y, 0.25f * g->t), v3(0.5f * g->slot, 0.2f * inner / (float)notches, 0.5f * g->t));
    }
}

/* Draws two sectors beside the lever, their rims round about its own line. */
static void draw_sector_gate(dmg_builder* b, const gate* g, float high) {
    enum { STEPS = 9 };
    dmg_xy side[STEPS + 2];
    float half = fminf(g->swing * 1.25f, 1.3f), r = g->deep;
    for (int i = 0; i < STEPS; ++i) { /* in the frame turned below, x is along the slot's -y, y is out */
        float angle = half * (1.0f - 2.0f * (float)i / (STEPS - 1));
        side[i] = (dmg_xy){r * sinf(angle), r * cosf(angle) - g->deep};
    }
    side[STEPS] = (dmg_xy){-0.6f * r, -g->deep - high};
    side[STEPS + 1] = (dmg_xy){0.6f * r, -g->deep - high};
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    float plate = dmg_chance(b, 0.5f) ? g->t : 0.5f * (g->wide - g->slot);
    dmg_extrude(b, side, STEPS + 2, 0.5f * g->slot, 0.5f * g->slot + plate);
    dmg_extrude(b, side, STEPS + 2, -0.5f * g->slot - plate, -0.5f * g->slot);
    dmg_restore(b);
    dmg_rod(b, v3(-0.6f * g->wide, 0, -g->deep), v3(0.6f * g->wide, 0, -g->deep), 0.5f * g->slot);
    dmg_box(b, v3(0, 0, -g->deep - high), v3(g->wide, 1.5f * r, g->t));
}

/* Draws a collar to lift, a button on the end, a trigger under the grip: what must be moved before the lever may. */
static void draw_catch(dmg_builder* b, uint32_t lever, float out, float r) {
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) {
        dmg_slide(b, lever, "collar", v3(0, 0, 1), 0.0f, 0.15f * out);
        dmg_rod(b, v3(0, 0, 0.45f * out), v3(0, 0, 0.6f * out), 0.7f * r);
    }
    if (kind == 1) {
        dmg_slide(b, lever, "button", v3(0, 0, -1), 0.0f, 0.25f * r);
        dmg_rod(b, v3(0, 0, out + r), v3(0, 0, out + 2.9f * r), 0.3f * r);
    }
    if (kind == 2) { /* a second arm before the first, squeezed to it */
        dmg_hinge(b, lever, "trigger", v3(0, -0.5f * r, 0.4f * out), v3(-1, 0, 0), 0.0f, 0.25f);
        dmg_beam(b, v3(0, -0.5f * r, 0.4f * out), v3(0, -1.4f * r, 0.95f * out), 0.5f * r, 0.2f * r);
    }
}

static void draw_gate_lever(dmg_builder* b, const gate* g, int grip, bool slides) {
    float r = fminf(1.4f * g->slot, 0.35f * g->wide) * dmg_range(b, 0.8f, 1.3f), thin = 0.4f * g->slot;
    float way = 0.5f * g->long_ * 0.84f - 0.9f * g->slot;
    uint32_t lever;
    if (slides) { /* on a carriage that lies over the slot */
        lever = dmg_slide(b, 0, "slide_lever", v3(0, 1, 0), -0.85f * way, 0.85f * way);
        dmg_box(b, v3(0, 0, 0.4f * g->t), v3(2.2f * g->slot, 1.8f * g->slot, 0.8f * g->t));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, -0.6f * g->t), v3(0.7f * g->slot, g->slot, 1.2f * g->t));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, g->out), thin);
    } else {
        lever = dmg_hinge(b, 0, "gate_lever", v3(0, 0, -g->deep), v3(-1, 0, 0), -g->swing, g->swing);
        float from = g->shape != 2 && dmg_chance(b, 0.3f) ? -2 * g->t : -g->deep; /* only what shows, or all of it */
        dmg_box(b, v3(0, 0, 0.5f * (g->out + from)), v3(1.6f * thin, 0.7f * g->slot, g->out - from));
        if (from <= -g->deep) dmg_rod(b, v3(-0.9f * thin, 0, -g->deep), v3(0.9f * thin, 0, -g->deep), 0.9f * g->slot);
    }
    dmg_save(b);
    dmg_move(b, 0, 0, g->out);
    draw_grip(b, grip, r);
    dmg_restore(b);
    float rest = (slides ? 0.85f * way : g->swing) * dmg_range(b, -1.0f, 1.0f);
    if (dmg_chance(b, 0.6f)) dmg_rest(b, lever, rest);
    if (!slides && dmg_chance(b, 0.35f)) draw_catch(b, lever, g->out, r);
    dmg_use(b, 0);
}

/* Draws a shift lever on a ball: one turn carries the other; a boot or a plate with an H. */
static void draw_shifter(dmg_builder* b, const gate* g, int grip) {
    float r = 0.3f * g->wide, wide = 1.3f * g->wide;
    dmg_box(b, v3(0, 0, -0.5f * g->deep), v3(1.5f * wide, g->long_, g->deep));
    int boot = dmg_int(b, 0, 2);
    for (int i = -1; i <= 1 && boot == 0; ++i) { /* an H in relief */
        dmg_box(b, v3((float)i * 0.4f * wide, 0, 0), v3(0.1f * wide, 0.6f * g->long_, 0.1f * g->t));
        if (i == 0) dmg_box(b, v3(0, 0, 0), v3(0.8f * wide, 0.1f * wide, 0.1f * g->t));
    }
    float low = -0.04f * g->deep;
    uint32_t cross = dmg_hinge(b, 0, "select", v3(0, 0, low), v3(0, 1, 0), -0.25f, 0.25f);
    dmg_ellipsoid(b, v3(0, 0, low), v3(0.5f * r, 0.5f * r, 0.5f * r));
    dmg_hinge(b, cross, "shift", v3(0, 0, low), v3(-1, 0, 0), -0.4f, 0.4f);
    dmg_cone(b, v3(0, 0, low), v3(0, 0, g->out), 0.25f * r, 0.15f * r);
    for (int i = 0; i < 4 && boot == 1; ++i) /* rings of a gaiter */
        dmg_torus(b, v3(0, 0, 0.45f * r + 0.1f * g->out * (float)i), v3(0, 0, 1), r * (1.1f - 0.22f * (float)i),
                  0.15f * r);
    if (boot == 2) dmg_cone(b, v3(0, 0, 0.4f * r), v3(0, 0, 0.4f * r + 0.3f * g->out), r, 0.3f * r);
    dmg_move(b, 0, 0, g->out);
    draw_grip(b, grip == 1 ? 0 : grip, r);
    dmg_use(b, 0);
}

void dmg_build_gate_lever(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 0.3f);
    int count = dmg_chance(b, 0.55f) ? 1 : dmg_int(b, 2, 3), grip = dmg_int(b, 0, 4);
    bool upright = dmg_chance(b, 0.35f), slides = dmg_chance(b, 0.3f), alike = dmg_chance(b, 0.6f);
    gate g = {
        .long_ = size * dmg_range(b, 1.0f, 2.0f), .wide = size * dmg_range(b, 0.3f, 0.7f), .shape = dmg_int(b, 0, 2)};
    g.slot = g.wide * dmg_range(b, 0.12f, 0.3f);
    g.t = size * dmg_range(b, 0.02f, 0.06f);
    g.deep = size * dmg_range(b, 0.3f, 0.9f);
    g.out = size * dmg_range(b, 0.4f, 1.2f);
    g.swing = fminf(0.7f, 0.8f * atanf((0.42f * g.long_ - 0.5f * g.slot) / g.deep));
    float high = g.deep * dmg_range(b, 1.15f, 1.6f);
    dmg_move(b, 0, upright ? 0.6f * g.long_ : 1.2f * high + g.deep, 0);
    if (!upright) dmg_face_up(b);
    if (!upright && dmg_chance(b, 0.3f)) dmg_turn(b, v3(1, 0, 0), dmg_range(b, 0.0f, 0.6f));
    if (dmg_chance(b, 0.15f)) {
        draw_shifter(b, &g, grip);
        return;
    }
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, g.wide * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        if (!alike) {
            grip = dmg_int(b, 0, 4);
            slides = dmg_chance(b, 0.4f);
        }
        gate own = g;
        if (slides && own.shape == 2) own.shape = 0;
        if (own.shape == 2)
            draw_sector_gate(b, &own, 0.3f * g.deep);
        else
            draw_flat_gate(b, &own, high);
        draw_gate_lever(b, &own, grip, slides);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- a ship's bridge ---- */

static void draw_column(dmg_builder* b, float high, float r) {
    const dmg_xy turned[] = {
        {0, 0},           {1.5f * r, 0}, {1.5f * r, 0.05f * high}, {0.7f * r, 0.15f * high}, {0.5f * r, 0.8f * high},
        {0.8f * r, high}, {0, high}};
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), turned, 7);
    if (kind == 1) dmg_box(b, v3(0, 0.5f * high, 0), v3(1.6f * r, high, 1.4f * r));
    if (kind == 2) dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 1.2f * r, 0.7f * r);
}

/* Draws a drum on its side, a dial on each end; handles ride round its rim about the drum's own line. */
static void draw_telegraph(dmg_builder* b, float r) {
    float half = r * dmg_range(b, 0.3f, 0.7f), high = r * dmg_range(b, 2.5f, 5.0f), swing = dmg_range(b, 0.8f, 1.4f);
    int handles = dmg_int(b, 1, 2);
    bool split = handles == 2, needles = dmg_chance(b, 0.5f);
    draw_column(b, high, 0.6f * r);
    dmg_move(b, 0, high + 0.9f * r, 0);
    dmg_rod(b, v3(-half, 0, 0), v3(half, 0, 0), r);
    for (int i = -1; i <= 1; i += 2) dmg_torus(b, v3((float)i * half, 0, 0), v3(1, 0, 0), 0.95f * r, 0.06f * r);
    for (int i = 0; i < handles; ++i) {
        float side = split ? (i == 0 ? -1.0f : 1.0f) : 0.0f, x = half + 0.12f * r, arm = 0.05f * r, top = 1.25f * r;
        uint32_t handle = dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(1, 0, 0), -swing, swing);
        for (int k = -1; k <= 1; k += 2) {
            if (split && (float)k != side) continue;
            dmg_box(b, v3((float)k * x, 0.5f * top, 0), v3(1.4f * arm, top, 2.4f * arm));
            dmg_rod(b, v3((float)k * (half + 0.02f * r), 0, 0), v3((float)k * (x + 2 * arm), 0, 0), 0.14f * r);
        }
        if (split)
            dmg_rod(b, v3(side * 0.9f * half, top, 0), v3(side * 1.2f * x, top, 0), 1.5f * arm);
        else
            dmg_rod(b, v3(-x, top, 0), v3(x, top, 0), 1.5f * arm);
        dmg_cone(b, v3(side * x, top, 0), v3(side * x, top + 0.6f * r, 0), 0.09f * r, 0.13f * r);
        if (dmg_chance(b, 0.6f)) dmg_rest(b, handle, swing * dmg_range(b, -1.0f, 1.0f));
        dmg_use(b, 0);
    }
    for (int i = -1; i <= 1 && needles; i += 2) { /* the answer's pointer, under the handle's arm */
        float x = (float)i * (half + 0.04f * r);
        dmg_hinge(b, 0, "pointer", v3(0, 0, 0), v3(1, 0, 0), -swing, swing);
        dmg_box(b, v3(x, 0.32f * r, 0), v3(0.03f * r, 0.85f * r, 0.06f * r));
        dmg_use(b, 0);
    }
}

/* Draws a thruster's head: turns about the upright line, its handle tips about a line across, in it. */
static void draw_thruster(dmg_builder* b, float r) {
    float high = r * dmg_range(b, 0.3f, 3.0f), tall = r * dmg_range(b, 0.8f, 1.6f);
    int count = dmg_int(b, 1, 2), shape = dmg_int(b, 0, 1);
    dmg_box(b, v3(1.5f * r * (float)(count - 1), 0.5f * high, 0), v3(3 * r * (float)count, high, 3 * r));
    dmg_move(b, 0, high, 0);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, 3 * r * (float)i, 0, 0);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.1f * r, 0), 1.3f * r);
        uint32_t head = dmg_spin(b, 0, "azimuth", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.35f * r, 0), r);
        dmg_box(b, v3(0, 0.2f * r, r), v3(0.2f * r, 0.2f * r, 0.5f * r));
        dmg_hinge(b, head, "thrust", v3(0, 0.35f * r, 0), v3(1, 0, 0), -0.9f, 0.9f);
        if (shape == 0) {
            dmg_rod(b, v3(-0.2f * r, 0.35f * r, 0), v3(0.2f * r, 0.35f * r, 0), 0.4f * r);
            dmg_cone(b, v3(0, 0.35f * r, 0), v3(0, tall, 0), 0.15f * r, 0.25f * r);
            dmg_ellipsoid(b, v3(0, tall, 0), v3(0.4f * r, 0.25f * r, 0.4f * r));
        } else { /* a wide paddle with cheeks down to the line */
            for (int k = -1; k <= 1; k += 2)
                dmg_box(b, v3((float)k * 0.6f * r, 0.5f * (tall + 0.35f * r), 0),
                        v3(0.15f * r, tall - 0.1f * r, 0.4f * r));
            dmg_rounded_box(b, v3(0, tall, 0), v3(1.5f * r, 0.4f * r, 0.5f * r), 0.12f * r);
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a compass in two rings on a column: each ring tips about its own line, the card floats in the bowl. */
static void draw_binnacle(dmg_builder* b, float r) {
    float high = r * dmg_range(b, 2.0f, 4.5f), t = 0.06f * r;
    bool hood = dmg_chance(b, 0.5f), gimbal = dmg_chance(b, 0.7f), balls = dmg_chance(b, 0.6f);
    draw_column(b, high, 0.8f * r);
    dmg_move(b, 0, high + r, 0);
    const dmg_xy cup[] = {{0.5f * r, -r}, {0.6f * r, -r}, {1.3f * r, 0}, {1.25f * r, 0}, {0.5f * r, -r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cup, 5);
    uint32_t carrier = 0;
    if (gimbal) {
        carrier = dmg_hinge(b, 0, "outer_ring", v3(0, 0, 0), v3(1, 0, 0), -0.3f, 0.3f);
        dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), 1.1f * r, t);
        dmg_rod(b, v3(-1.25f * r, 0, 0), v3(-1.1f * r, 0, 0), 0.8f * t);
        dmg_rod(b, v3(1.1f * r, 0, 0), v3(1.25f * r, 0, 0), 0.8f * t);
        carrier = dmg_hinge(b, carrier, "bowl", v3(0, 0, 0), v3(0, 0, 1), -0.3f, 0.3f);
        dmg_rod(b, v3(0, 0, 0.9f * r), v3(0, 0, 1.1f * r), 0.8f * t);
        dmg_rod(b, v3(0, 0, -1.1f * r), v3(0, 0, -0.9f * r), 0.8f * t);
    }
    const dmg_xy bowl[] = {{0, -0.5f * r}, {0.6f * r, -0.5f * r},  {0.95f * r, 0},
                           {0.9f * r, 0},  {0.55f * r, -0.4f * r}, {0, -0.4f * r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 6);
    dmg_spin(b, carrier, "card", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.12f * r, 0), v3(0, -0.08f * r, 0), 0.78f * r);
    dmg_box(b, v3(0, -0.06f * r, 0), v3(0.06f * r, 0.04f * r, 1.4f * r));
    dmg_use(b, 0);
    if (hood) {
        dmg_hinge(b, 0, "hood", v3(0, 0.1f * r, -1.35f * r), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.2f));
        dmg_dome(b, v3(0, 0.1f * r, 0), v3(1.35f * r, 1.1f * r, 1.35f * r));
        dmg_use(b, 0);
    }
    for (int i = -1; i <= 1 && balls; i += 2) { /* the iron balls on their brackets */
        float x = (float)i * 2.1f * r;
        dmg_box(b, v3(0.8f * x, -0.75f * r, 0), v3(1.3f * r, 0.1f * r, 0.4f * r));
        dmg_slide(b, 0, "sphere", v3(-(float)i, 0, 0), -0.1f * r, 0.25f * r);
        dmg_ellipsoid(b, v3(x, -0.3f * r, 0), v3(0.4f * r, 0.4f * r, 0.4f * r));
        dmg_use(b, 0);
    }
}

/* A wheel of spokes or a small rim on a stand, a rudder's pointer above, levers beside it. */
static void draw_steering(dmg_builder* b, float r) {
    float high = r * dmg_range(b, 1.2f, 2.2f), t = r * dmg_range(b, 0.06f, 0.12f), box = r * dmg_range(b, 0.5f, 1.3f);
    int spokes = dmg_int(b, 3, 8), kind = dmg_int(b, 0, 2);
    dmg_rounded_box(b, v3(0, 0.5f * high + 0.2f * r, -0.5f * box), v3(1.2f * box, high + 0.4f * r, box), 0.1f * box);
    dmg_move(b, 0, high, 0);
    dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 2 * t), 1.6f * t);
    dmg_save(b);
    dmg_move(b, 0, 0, 3 * t);
    if (kind == 0)
        dmg_hinge(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, -1), -1.6f, 1.6f);
    else
        dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    if (kind == 1) { /* handles beyond the rim */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.75f * r, t);
        for (int i = 0; i < spokes; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, spokes);
            dmg_rod(b, v3(0, 0, 0), v3(0.8f * r, 0, 0), 0.5f * t);
            dmg_cone(b, v3(0.8f * r, 0, 0), v3(1.1f * r, 0, 0), 0.5f * t, 0.8f * t);
            dmg_restore(b);
        }
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, t), 2.5f * t);
    } else {
        dmg_wheel_draw(b, 3, 0.8f * r, 2 * t, spokes);
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* rudder angle: a needle whose pin is at the window's foot */
        dmg_save(b);
        dmg_move(b, 0, 1.0f * r, -0.5f * box);
        dmg_box(b, v3(0, 0, 0), v3(r, 0.7f * r, 0.3f * r));
        uint32_t needle = dmg_hinge(b, 0, "needle", v3(0, -0.25f * r, 0.17f * r), v3(0, 0, -1), -0.7f, 0.7f);
        dmg_box(b, v3(0, 0, 0.17f * r), v3(0.04f * r, 0.5f * r, 0.02f * r));
        dmg_rest(b, needle, dmg_range(b, -0.6f, 0.6f));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_ship_control(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.04f, 0.4f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) draw_telegraph(b, r);
    if (kind == 1) draw_thruster(b, r);
    if (kind == 2) draw_binnacle(b, r);
    if (kind == 3) draw_steering(b, r);
    dmg_use(b, 0);
}
