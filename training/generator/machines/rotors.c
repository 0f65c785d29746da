/* Draws things that turn: fans, propellers, turbines, clocks, globes, radars, turntables. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a rotor about Z at the origin, facing +Z: hub and blades. */
static uint32_t draw_rotor(dmg_builder* b, uint32_t parent, const char* name, float radius, float chord) {
    int kind = dmg_int(b, 0, DMG_BLADE_KINDS - 1), count = dmg_int(b, 2, 6);
    float hub = radius * dmg_range(b, 0.05f, 0.18f), twist = dmg_range(b, 0.0f, 0.7f);
    if (dmg_chance(b, 0.05f)) count = 1;
    uint32_t rotor = dmg_spin(b, parent, name, v3(0, 0, 0), v3(0, 0, 1));
    int nose = dmg_int(b, 0, 2);
    if (nose == 0) dmg_rod(b, v3(0, 0, -hub), v3(0, 0, 0.6f * hub), hub);
    if (nose == 1) dmg_cone(b, v3(0, 0, -0.5f * hub), v3(0, 0, 2 * hub), hub, 0);
    if (nose == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(hub, hub, 1.3f * hub));
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 2.0f * DMG_PI));
    dmg_blades_draw(b, kind, radius, hub, chord, count, twist);
    return rotor;
}

/* Draws a cage of rings and wires about Z. */
static void draw_cage(dmg_builder* b, float radius, float depth) {
    float wire = 0.012f * radius;
    int rings = dmg_int(b, 1, 4), spokes = dmg_int(b, 4, 12);
    for (int face = -1; face <= 1; face += 2) {
        for (int i = 0; i < rings; ++i) {
            float share = (float)(i + 1) / (float)rings;
            dmg_torus(b, v3(0, 0, (float)face * 0.5f * depth), v3(0, 0, 1), radius * share, wire);
        }
        for (int i = 0; i < spokes; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / (float)spokes;
            dmg_beam(b, v3(0, 0, (float)face * 0.5f * depth),
                     v3(radius * cosf(angle), radius * sinf(angle), (float)face * 0.5f * depth), wire, wire);
        }
    }
    dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius, 2 * wire);
}

void dmg_build_fan(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.03f, 0.6f), chord = radius * dmg_range(b, 0.3f, 0.8f),
          depth = radius * dmg_range(b, 0.3f, 0.6f);
    int kind = dmg_int(b, 0, 3); /* on a stand, in a square housing, on the ceiling, on a desk foot */
    uint32_t head = 0;
    if (kind == 1) {
        dmg_move(b, 0, 1.1f * radius, 0);
        float side = 2.2f * radius;
        dmg_holed_plate_draw(b, side, side, 0.5f * depth, 1.04f * radius);
        if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0, -0.5f * depth), v3(side, 0.1f * radius, 0.05f * depth));
        dmg_move(b, 0, 0, -0.25f * depth);
    } else if (kind == 2) {
        float drop = radius * dmg_range(b, 0.2f, 0.6f);
        dmg_move(b, 0, 2.5f, 0);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* +Z down */
        dmg_rod(b, v3(0, 0, -drop), v3(0, 0, 0), 0.04f * radius);
        dmg_rod(b, v3(0, 0, -drop), v3(0, 0, -0.9f * drop), 0.15f * radius);
        if (dmg_chance(b, 0.5f))
            dmg_box(b, v3(0, 0, -drop - 0.02f * radius), v3(2.5f * radius, 2.5f * radius, 0.04f * radius));
        chord *= 0.4f;
    } else {
        float high = radius * (kind == 0 ? dmg_range(b, 2.5f, 5.0f) : dmg_range(b, 1.2f, 1.8f));
        dmg_rod(b, v3(0, 0, -0.5f * depth), v3(0, 0.05f * radius, -0.5f * depth), 0.7f * radius);
        dmg_rod(b, v3(0, 0, -0.5f * depth), v3(0, high - 0.2f * radius, -0.5f * depth), 0.06f * radius);
        if (dmg_chance(b, 0.6f)) { /* the head nods or looks about */
            bool nods = dmg_chance(b, 0.5f);
            head = dmg_hinge(b, 0, "head", v3(0, high - 0.2f * radius, -0.5f * depth), nods ? v3(1, 0, 0) : v3(0, 1, 0),
                             -0.6f, 0.6f);
        }
        dmg_move(b, 0, high, 0);
        dmg_rod(b, v3(0, 0, -0.9f * depth), v3(0, 0, -0.25f * depth), 0.25f * radius);
        dmg_box(b, v3(0, -0.1f * radius, -0.5f * depth), v3(0.12f * radius, 0.3f * radius, 0.2f * depth));
        if (dmg_chance(b, 0.7f)) draw_cage(b, 1.08f * radius, 0.5f * depth);
    }
    draw_rotor(b, head, "blades", radius, chord);
    dmg_use(b, 0);
}

/* ---- propeller ---- */

void dmg_build_propeller(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.05f, 1.6f), body = radius * dmg_range(b, 0.15f, 0.5f),
          length = radius * dmg_range(b, 1.0f, 5.0f);
    int kind = dmg_int(b, 0, 3);
    dmg_move(b, 0, 1.1f * radius, 0);
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, -0.45f * length), v3(body, body, 0.5f * length));  /* nose */
    if (kind == 1) dmg_cone(b, v3(0, 0, -length), v3(0, 0, -0.1f * radius), 0.5f * body, body); /* nacelle */
    if (kind == 2) {                                                                            /* in a shroud */
        float wall = 0.04f * radius, h = 0.25f * radius;
        const dmg_xy duct[] = {{1.05f * radius, -h},
                               {1.05f * radius + wall, -h},
                               {1.05f * radius + 2 * wall, h},
                               {1.05f * radius, h},
                               {1.05f * radius, -h}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), duct, 5);
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f;
            dmg_beam(b, v3(0, 0, -0.8f * h), v3(1.07f * radius * cosf(angle), 1.07f * radius * sinf(angle), -0.8f * h),
                     wall, wall);
        }
        dmg_rod(b, v3(0, 0, -1.2f * h), v3(0, 0, -0.3f * h), 0.15f * radius);
    }
    if (kind == 3) { /* an outboard leg */
        dmg_box(b, v3(0, 0.6f * radius, -0.4f * radius), v3(0.15f * radius, 1.6f * radius, 0.4f * radius));
        dmg_rod(b, v3(0, 0, -0.9f * radius), v3(0, 0, -0.1f * radius), 0.18f * radius);
        dmg_rounded_box(b, v3(0, 1.7f * radius, -0.5f * radius), v3(0.6f * radius, 0.8f * radius, 0.9f * radius),
                        0.15f * radius);
    }
    if (kind < 2 && dmg_chance(b, 0.6f))
        dmg_box(b, v3(0, 0, -0.5f * length),
                v3(radius * dmg_range(b, 3, 8), 0.06f * radius, 0.5f * radius)); /* a wing */
    draw_rotor(b, 0, "propeller", radius, radius * dmg_range(b, 0.08f, 0.4f));
    dmg_use(b, 0);
}

/* ---- wind turbine ---- */

/* Draws a lattice or a tube up to y = height. */
static void draw_mast(dmg_builder* b, float height, float radius) {
    if (dmg_chance(b, 0.65f)) {
        dmg_cone(b, v3(0, 0, 0), v3(0, height, 0), radius, 0.6f * radius);
        return;
    }
    for (int i = 0; i < 4; ++i) {
        float x = i & 1 ? 1.0f : -1.0f, z = i & 2 ? 1.0f : -1.0f;
        dmg_beam(b, v3(2 * x * radius, 0, 2 * z * radius), v3(0.5f * x * radius, height, 0.5f * z * radius),
                 0.2f * radius, 0.2f * radius);
    }
    for (int i = 1; i < 5; ++i) {
        float s = (float)i / 5.0f, w = (2.0f - 1.5f * s) * 2 * radius;
        dmg_box(b, v3(0, s * height, 0), v3(w, 0.15f * radius, w));
    }
}

void dmg_build_wind_turbine(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.5f, 40), height = radius * dmg_range(b, 1.2f, 3.0f),
          mast = radius * dmg_range(b, 0.04f, 0.1f), nacelle = radius * dmg_range(b, 0.1f, 0.4f),
          thick = nacelle * dmg_range(b, 0.2f, 0.5f);
    draw_mast(b, height, mast);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, 0.15f * radius, 0), v3(0.6f * radius, 0.3f * radius, 0.5f * radius));
    if (dmg_chance(b, 0.12f)) { /* turning about the mast itself */
        dmg_spin(b, 0, "rotor", v3(0, height, 0), v3(0, 1, 0));
        int count = dmg_int(b, 2, 4);
        for (int i = 0; i < count; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / (float)count, x = 0.5f * radius * cosf(angle),
                  z = 0.5f * radius * sinf(angle);
            dmg_box(b, v3(x, height + 0.5f * radius, z), v3(0.06f * radius, radius, 0.06f * radius));
            dmg_beam(b, v3(0, height + 0.1f * radius, 0), v3(x, height + 0.1f * radius, z), 0.04f * radius,
                     0.04f * radius);
            dmg_beam(b, v3(0, height + 0.9f * radius, 0), v3(x, height + 0.9f * radius, z), 0.04f * radius,
                     0.04f * radius);
        }
        dmg_rod(b, v3(0, height, 0), v3(0, height + radius, 0), 0.03f * radius);
        dmg_use(b, 0);
        return;
    }
    uint32_t head = dmg_chance(b, 0.6f) ? dmg_spin(b, 0, "nacelle", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rounded_box(b, v3(0, height + 0.5f * thick, 0), v3(thick, thick, nacelle), 0.3f * thick);
    if (dmg_chance(b, 0.25f))
        dmg_box(b, v3(0, height + 0.5f * thick, -nacelle), v3(0.1f * thick, 2 * thick, nacelle)); /* a vane */
    dmg_move(b, 0, height + 0.5f * thick, 0.5f * nacelle + 0.06f * radius);
    draw_rotor(b, head, "rotor", radius, radius * dmg_range(b, 0.05f, 0.2f));
    dmg_use(b, 0);
}

/* ---- globe ---- */

void dmg_build_globe(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.08f, 0.4f), gap = radius * dmg_range(b, 0.03f, 0.12f),
          tilt = dmg_chance(b, 0.8f) ? dmg_range(b, 0.3f, 0.5f) : 0.0f, foot = radius * dmg_range(b, 0.3f, 1.0f);
    enum { POINTS = 13 };
    dmg_vec path[POINTS];
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.08f * radius, 0), 0.7f * radius, 0.5f * radius);
    dmg_rod(b, v3(0, 0, 0), v3(0, foot, 0), 0.06f * radius);
    dmg_move(b, 0, foot + radius + gap, 0);
    dmg_turn(b, v3(0, 0, 1), -tilt);
    float reach = radius + gap;
    bool full = dmg_chance(b, 0.3f);
    for (int i = 0; i < POINTS; ++i) {
        float angle = (full ? 2.0f : 1.0f) * DMG_PI * (float)i / (full ? POINTS : POINTS - 1.0f) - 0.5f * DMG_PI;
        path[i] = v3(reach * cosf(angle), reach * sinf(angle), 0);
    }
    dmg_sweep(b, path, POINTS, 0.02f * radius, 0.05f * radius, full);
    dmg_rod(b, v3(0, -reach, 0), v3(0, -radius, 0), 0.03f * radius);
    dmg_rod(b, v3(0, radius, 0), v3(0, reach, 0), 0.03f * radius);
    dmg_spin(b, 0, "globe", v3(0, 0, 0), v3(0, 1, 0));
    dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius, radius));
    if (dmg_chance(b, 0.3f)) dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), radius, 0.015f * radius);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.2f)) dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), 1.25f * reach, 0.06f * radius); /* a horizon */
}

/* ---- clock ---- */

static void draw_hand(dmg_builder* b, uint32_t parent, const char* name, int kind, float length, float width, float z,
                      float angle) {
    dmg_save(b);
    dmg_spin(b, parent, name, v3(0, 0, 0), v3(0, 0, -1));
    dmg_turn(b, v3(0, 0, 1), -angle);
    float t = 0.3f * width;
    if (kind == 0) dmg_box(b, v3(0, 0.42f * length, z), v3(width, 1.16f * length, t));
    if (kind == 1) {
        const dmg_xy needle[] = {{-0.6f * width, -0.15f * length},
                                 {0.6f * width, -0.15f * length},
                                 {0.15f * width, length},
                                 {-0.15f * width, length}};
        dmg_extrude(b, needle, 4, z - 0.5f * t, z + 0.5f * t);
    }
    if (kind == 2) {
        dmg_box(b, v3(0, 0.4f * length, z), v3(0.4f * width, 0.8f * length, t));
        const dmg_xy tip[] = {{-width, 0.75f * length}, {width, 0.75f * length}, {0, length}};
        dmg_extrude(b, tip, 3, z - 0.5f * t, z + 0.5f * t);
    }
    dmg_rod(b, v3(0, 0, z - 0.5f * t), v3(0, 0, z + 0.6f * t), 0.8f * width);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* A gauge's needle has limits; the rest is as a clock. */
static void draw_gauge(dmg_builder* b, float radius) {
    int needles = dmg_chance(b, 0.7f) ? 1 : 2;
    for (int i = 0; i < needles; ++i) {
        float length = radius * dmg_range(b, 0.5f, 0.9f), swing = dmg_range(b, 0.8f, 2.4f),
              width = radius * dmg_range(b, 0.02f, 0.06f);
        bool centre = dmg_chance(b, 0.7f);
        dmg_vec pivot = centre ? v3(0, 0, 0) : v3(0, -0.5f * radius, 0);
        uint32_t needle = dmg_hinge(b, 0, "needle", pivot, v3(0, 0, -1), -swing, swing);
        dmg_box(b, v3(pivot.x, pivot.y + 0.42f * length, 0.04f * radius * (float)(i + 1)),
                v3(width, length, 0.015f * radius));
        dmg_rod(b, pivot, v3(pivot.x, pivot.y, 0.045f * radius * (float)(i + 1)), 1.5f * width);
        dmg_rest(b, needle, dmg_range(b, -swing, swing));
    }
    dmg_use(b, 0);
}

static void draw_pendulum(dmg_builder* b, float radius) {
    float length = radius * dmg_range(b, 1.2f, 4.0f), swing = dmg_range(b, 0.15f, 0.5f);
    dmg_hinge(b, 0, "pendulum", v3(0, 0, -0.1f * radius), v3(0, 0, 1), -swing, swing);
    dmg_rod(b, v3(0, 0, -0.1f * radius), v3(0, -length, -0.1f * radius), 0.02f * radius);
    dmg_rod(b, v3(0, -length, -0.15f * radius), v3(0, -length, -0.05f * radius), 0.25f * radius);
    dmg_use(b, 0);
}

void dmg_build_clock(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.02f, 0.6f), depth = radius * dmg_range(b, 0.1f, 0.6f),
          rim = radius * dmg_range(b, 0.03f, 0.15f);
    int shape = dmg_int(b, 0, 2), kind = dmg_int(b, 0, 2);
    dmg_move(b, 0, 1.5f * radius, 0);
    if (shape == 0) dmg_rod(b, v3(0, 0, -depth), v3(0, 0, 0), 1.1f * radius);
    if (shape == 1) dmg_rounded_plate(b, 2.3f * radius, 2.3f * radius, depth, 0.2f * radius);
    if (shape == 2) dmg_box(b, v3(0, 0, -0.5f * depth), v3(2.3f * radius, 2.3f * radius, depth));
    if (dmg_chance(b, 0.7f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius + rim, rim);
    int marks = dmg_chance(b, 0.6f) ? 12 : 0;
    for (int i = 0; i < marks; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, marks);
        dmg_box(b, v3(0, 0.88f * radius, 0), v3(0.03f * radius, (i % 3 ? 0.08f : 0.16f) * radius, 0.02f * radius));
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.3f)) {
        draw_gauge(b, radius);
    } else {
        float time = dmg_range(b, 0, 12), hour = 2.0f * DMG_PI * time / 12.0f,
              minute = 2.0f * DMG_PI * (time - floorf(time));
        draw_hand(b, 0, "hour_hand", kind, 0.55f * radius, 0.05f * radius, 0.03f * radius, hour);
        draw_hand(b, 0, "minute_hand", kind, 0.85f * radius, 0.035f * radius, 0.055f * radius, minute);
        if (dmg_chance(b, 0.4f))
            draw_hand(b, 0, "second_hand", 0, 0.9f * radius, 0.012f * radius, 0.075f * radius, dmg_range(b, 0, 6));
    }
    if (dmg_chance(b, 0.3f)) { /* a knob to set it */
        dmg_save(b);
        dmg_move(b, 0.9f * radius, -0.9f * radius, 0);
        dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.12f * radius, 0.15f * radius);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.25f)) draw_pendulum(b, radius);
}

/* ---- turntable ---- */

/* A disc about a vertical axis with something on it: records, cake stands, lazy Susans, roundabouts, seats. */
void dmg_build_turntable(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.08f, 2.0f), thick = radius * dmg_range(b, 0.03f, 0.15f),
          foot = radius * dmg_range(b, 0.05f, 0.8f);
    int base = dmg_int(b, 0, 2), load = dmg_int(b, 0, 5);
    if (base == 0) dmg_box(b, v3(0.15f * radius, 0.5f * foot, 0), v3(2.5f * radius, foot, 2.2f * radius));
    if (base == 1) dmg_cone(b, v3(0, 0, 0), v3(0, foot, 0), radius * dmg_range(b, 0.4f, 0.9f), 0.2f * radius);
    if (base == 2) dmg_rod(b, v3(0, 0, 0), v3(0, foot, 0), radius * dmg_range(b, 0.8f, 1.2f));
    dmg_spin(b, 0, "turntable", v3(0, 0, 0), v3(0, 1, 0));
    dmg_save(b);
    dmg_move(b, 0, foot, 0);
    if (dmg_chance(b, 0.85f))
        dmg_rod(b, v3(0, 0, 0), v3(0, thick, 0), radius);
    else
        dmg_box(b, v3(0, 0.5f * thick, 0), v3(1.8f * radius, thick, 1.4f * radius));
    float y = thick;
    if (load == 0) dmg_rod(b, v3(0, y, 0), v3(0, y + 0.1f * radius, 0), 0.04f * radius);
    if (load == 1)
        dmg_box(b, v3(0.3f * radius, y + 0.25f * radius, 0.1f * radius),
                v3(0.5f * radius, 0.5f * radius, 0.4f * radius));
    if (load == 2) dmg_torus(b, v3(0, y + 0.4f * radius, 0), v3(0, 1, 0), 0.9f * radius, 0.04f * radius);
    for (int i = 0; i < 5 && load == 3; ++i)
        dmg_rod(
            b, v3(0.7f * radius * cosf(1.2566f * (float)i), y, 0.7f * radius * sinf(1.2566f * (float)i)),
            v3(0.7f * radius * cosf(1.2566f * (float)i), y + 0.5f * radius, 0.7f * radius * sinf(1.2566f * (float)i)),
            0.06f * radius);
    if (load == 4)
        dmg_cone(b, v3(0.2f * radius, y, 0), v3(0.2f * radius, y + 0.6f * radius, 0), 0.4f * radius, 0.1f * radius);
    dmg_restore(b);
    dmg_use(b, 0);
    if (base == 0 && dmg_chance(b, 0.6f)) { /* a tone arm */
        float x = 1.2f * radius, h = foot + 0.2f * radius;
        dmg_rod(b, v3(x, foot, -0.8f * radius), v3(x, h, -0.8f * radius), 0.08f * radius);
        dmg_hinge(b, 0, "arm", v3(x, 0, -0.8f * radius), v3(0, -1, 0), 0.0f, 0.8f);
        dmg_rod(b, v3(x, h, -1.0f * radius), v3(x, h, 0.5f * radius), 0.025f * radius);
        dmg_box(b, v3(x, h - 0.04f * radius, 0.5f * radius), v3(0.08f * radius, 0.08f * radius, 0.15f * radius));
        dmg_use(b, 0);
    }
}

/* ---- radar ---- */

/* Dishes and bars that turn and nod on masts, vehicles and buildings. */
void dmg_build_radar(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.3f, 10), mast = size * dmg_range(b, 0.3f, 2.0f),
          width = size * dmg_range(b, 0.3f, 1.5f);
    int base = dmg_int(b, 0, 2), head = dmg_int(b, 0, 3);
    if (base == 0) dmg_cone(b, v3(0, 0, 0), v3(0, mast, 0), 0.15f * size, 0.08f * size);
    if (base == 1) dmg_box(b, v3(0, 0.5f * mast, 0), v3(1.2f * size, mast, 0.9f * size));
    if (base == 2) {
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f;
            dmg_beam(b, v3(0.5f * size * cosf(angle), 0, 0.5f * size * sinf(angle)), v3(0, mast, 0), 0.06f * size,
                     0.06f * size);
        }
    }
    bool limited = dmg_chance(b, 0.3f);
    uint32_t yaw = limited ? dmg_hinge(b, 0, "mount", v3(0, mast, 0), v3(0, 1, 0), -2.0f, 2.0f)
                           : dmg_spin(b, 0, "mount", v3(0, mast, 0), v3(0, 1, 0));
    float y = mast + (base == 1 ? 0.65f : 0.35f) * size;
    dmg_rod(b, v3(0, mast, 0), v3(0, y, 0), 0.06f * size);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, mast + 0.1f * size, 0), v3(0.3f * size, 0.2f * size, 0.3f * size));
    if (head != 1 && dmg_chance(b, 0.6f))
        dmg_rest(b, dmg_hinge(b, yaw, "dish", v3(0, y, 0), v3(-1, 0, 0), -0.2f, 1.3f), dmg_range(b, 0, 1));
    dmg_save(b);
    dmg_move(b, 0, y, 0.06f * size);
    if (head == 0) { /* a dish with its feed */
        const dmg_xy bowl[] = {{0, 0},
                               {0.3f * size, 0.06f * size},
                               {0.5f * size, 0.18f * size},
                               {0.49f * size, 0.2f * size},
                               {0.3f * size, 0.08f * size},
                               {0, 0.02f * size}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), bowl, 6);
        for (int i = 0; i < 3; ++i)
            dmg_beam(b, v3(0.35f * size * cosf(2.1f * (float)i), 0.35f * size * sinf(2.1f * (float)i), 0.1f * size),
                     v3(0, 0, 0.45f * size), 0.015f * size, 0.015f * size);
        dmg_box(b, v3(0, 0, 0.45f * size), v3(0.06f * size, 0.06f * size, 0.1f * size));
    }
    if (head == 1) dmg_box(b, v3(0, 0, 0), v3(width, 0.15f * size, 0.12f * size));
    if (head == 2) { /* a curved grid */
        enum { POINTS = 9 };
        dmg_xy line[POINTS];
        for (int i = 0; i < POINTS; ++i) {
            float s = 2.0f * (float)i / (POINTS - 1) - 1.0f;
            line[i] = (dmg_xy){0.6f * width * s, 0.15f * width * s * s};
        }
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_bent_plate(b, line, POINTS, 0.02f * size, 0.4f * size);
        dmg_restore(b);
        dmg_beam(b, v3(0, -0.2f * size, 0), v3(0, -0.2f * size, 0.4f * width), 0.03f * size, 0.03f * size);
    }
    if (head == 3) dmg_box(b, v3(0, 0, 0), v3(width, 0.8f * width, 0.05f * size)); /* a panel */
    dmg_restore(b);
    dmg_use(b, 0);
}
