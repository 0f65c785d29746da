/* Draws pedestals between two pilots' seats: levers in slots, trim wheels on the flank, pull rods, a parking brake's
 * handle. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

/* A box whose long side runs along Z; the levers turn about lines across it, in its quadrant. */
typedef struct pedestal {
    float width, height, depth, radius; /* radius: of the quadrant on top */
    bool curved;
} pedestal;

static void draw_pedestal(dmg_builder* b, const pedestal* p) {
    float w = p->width, h = p->height, d = p->depth;
    if (dmg_chance(b, 0.4f)) { /* it slopes towards the seat */
        const dmg_xy side[] = {{-0.5f * d, 0}, {0.5f * d, 0}, {0.5f * d, 0.7f * h}, {0.3f * d, h}, {-0.5f * d, h}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes z */
        dmg_extrude(b, side, 5, -0.5f * w, 0.5f * w);
        dmg_restore(b);
    } else {
        dmg_box(b, v3(0, 0.5f * h, 0), v3(w, h, d));
    }
    if (!p->curved) return;
    const dmg_xy rim[] = {{p->radius, -0.48f * w}, {p->radius, 0.48f * w}};
    dmg_lathe_arc(b, v3(0, h - 0.4f * p->radius, -0.1f * d), v3(1, 0, 0), rim, 2, 0, 2.0f * DMG_PI);
}

static void draw_lever_knob(dmg_builder* b, int kind, float grip) {
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(grip, grip, grip));
    if (kind == 1) dmg_rod(b, v3(-grip, 0, 0), v3(grip, 0, 0), 0.9f * grip);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, 0), v3(1.8f * grip, 2.2f * grip, 1.3f * grip), 0.3f * grip);
    if (kind == 3) dmg_cone(b, v3(0, -grip, 0), v3(0, 1.5f * grip, 0), 0.6f * grip, grip);
    if (kind == 4) dmg_box(b, v3(0, 0, 0), v3(2 * grip, 0.5f * grip, 2.2f * grip)); /* a flap's outline */
}

/* Levers side by side on one hidden line across the pedestal, bent to meet a hand or straight. */
static void draw_levers(dmg_builder* b, const pedestal* p) {
    int count = dmg_int(b, 1, 6);
    bool alike = dmg_chance(b, 0.6f), cranked = dmg_chance(b, 0.2f);
    float pitch = 0.85f * p->width / (float)count, swing = dmg_range(b, 0.2f, 0.7f),
          top = p->radius * dmg_range(b, 1.6f, 2.6f), thin = pitch * dmg_range(b, 0.08f, 0.3f),
          grip = fminf(0.42f * pitch, 0.3f * (top - p->radius) + 0.1f * pitch),
          deep = p->radius * dmg_range(b, 0, 0.5f);
    int kind = dmg_int(b, 0, 4);
    dmg_save(b);
    dmg_move(b, 0, p->height - (p->curved ? 0.4f : 0.9f) * p->radius, -0.1f * p->depth);
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), bend = cranked ? 0.4f * top : 0.0f;
        if (!alike) kind = dmg_int(b, 0, 4);
        uint32_t lever = dmg_hinge(b, 0, "lever", v3(x, -deep, 0), v3(1, 0, 0), -swing, swing);
        float from = dmg_chance(b, 0.4f) ? 0.7f * p->radius : -deep; /* drawn as far as it shows, or whole */
        dmg_beam(b, v3(x, from, 0), v3(x, 0.9f * top, bend), thin, 2.5f * thin);
        dmg_save(b);
        dmg_move(b, x, top, bend);
        draw_lever_knob(b, kind, grip);
        dmg_restore(b);
        if (dmg_chance(b, 0.7f)) dmg_rest(b, lever, swing * dmg_range(b, -1.0f, 1.0f));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Draws a trim wheel on the flank, its rim often standing above the top. */
static void draw_trim_wheel(dmg_builder* b, const pedestal* p, float side) {
    float radius = p->depth * dmg_range(b, 0.15f, 0.35f), thick = p->width * dmg_range(b, 0.04f, 0.15f),
          x = side * (0.5f * p->width + 0.6f * thick), y = p->height - radius * dmg_range(b, -0.1f, 0.8f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 3, 6);
    bool crank = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_move(b, x, y, -0.1f * p->depth);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* a wheel's axis is Z */
    dmg_spin(b, 0, "trim_wheel", v3(0, 0, 0), v3(0, 0, 1));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, -0.5f * thick), v3(0, 0, 0.5f * thick), radius);
    else
        dmg_wheel_draw(b, kind, radius, thick, spokes);
    float out = side * thick;
    if (crank) dmg_rod(b, v3(0, 0.8f * radius, 0), v3(0, 0.8f * radius, 1.6f * out), 0.08f * radius);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Rods, switches or keys on the face towards the seat. */
static void draw_lower_face(dmg_builder* b, const pedestal* p) {
    static const dmg_control_kind kinds[] = {DMG_CONTROL_PLUNGER, DMG_CONTROL_PLUNGER, DMG_CONTROL_TOGGLE,
                                             DMG_CONTROL_DIAL, DMG_CONTROL_ROCKER};
    int count = dmg_int(b, 1, 4);
    float pitch = 0.9f * p->width / (float)count,
          radius = fminf(0.5f * pitch, 0.2f * p->height) * dmg_range(b, 0.4f, 0.9f);
    dmg_save(b);
    dmg_move(b, 0, 0.35f * p->height, 0.5f * p->depth);
    dmg_control_row_draw(b, kinds[dmg_int(b, 0, 4)], count, pitch, radius);
    dmg_restore(b);
}

void dmg_build_pedestal(dmg_builder* b) {
    pedestal p = {.width = dmg_scale_range(b, 0.05f, 0.4f), .curved = dmg_chance(b, 0.5f)};
    p.depth = p.width * dmg_scale_range(b, 0.6f, 3.0f);
    p.height = p.width * dmg_scale_range(b, 0.4f, 2.5f);
    p.radius = fminf(p.depth * dmg_range(b, 0.15f, 0.35f), 0.9f * p.height);
    draw_pedestal(b, &p);
    draw_levers(b, &p);
    float side = dmg_sign(b);
    if (dmg_chance(b, 0.4f)) draw_trim_wheel(b, &p, side);
    if (dmg_chance(b, 0.15f)) draw_trim_wheel(b, &p, -side);
    if (dmg_chance(b, 0.4f)) draw_lower_face(b, &p);
    dmg_use(b, 0);
}
