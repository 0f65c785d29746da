/* Implements wheels and blades: round parts about the axis Z, centred at the origin. */
#include "parts/hardware.h"

static void draw_tyre(dmg_builder* b, float radius, float width) {
    float h = 0.5f * width, inner = 0.62f * radius;
    const dmg_xy profile[] = {{inner, -h},         {0.93f * radius, -h}, {radius, -0.6f * h}, {radius, 0.6f * h},
                              {0.93f * radius, h}, {inner, h},           {inner, -h}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 7);
}

static void draw_spokes(dmg_builder* b, int count, float from, float to, float width, float thickness) {
    for (int i = 0; i < count; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)count;
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), angle);
        dmg_box(b, v3(0.5f * (from + to), 0, 0), v3(to - from, width, thickness));
        dmg_restore(b);
    }
}

/* Teeth round a disc. */
static void draw_gear(dmg_builder* b, float radius, float width, int teeth) {
    enum { TEETH = 16 };
    dmg_xy polygon[4 * TEETH];
    teeth = teeth < 6 ? 6 : (teeth > TEETH ? TEETH : teeth);
    for (int i = 0; i < 4 * teeth; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)(4 * teeth), r = i % 4 < 2 ? radius : 0.82f * radius;
        polygon[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, polygon, 4 * teeth, -0.5f * width, 0.5f * width);
}

void dmg_wheel_draw(dmg_builder* b, int kind, float radius, float width, int spokes) {
    float h = 0.5f * width, hub = 0.18f * radius;
    switch (kind) {
    case 0: /* disc */
        dmg_rod(b, v3(0, 0, -h), v3(0, 0, h), radius);
        break;
    case 1: /* tyre and rim */
        draw_tyre(b, radius, width);
        dmg_rod(b, v3(0, 0, -0.6f * h), v3(0, 0, 0.6f * h), 0.63f * radius);
        dmg_rod(b, v3(0, 0, -0.8f * h), v3(0, 0, 0.8f * h), hub);
        break;
    case 2: /* tyre and spokes */
        draw_tyre(b, radius, width);
        draw_spokes(b, spokes, hub, 0.64f * radius, 0.14f * radius, 0.5f * width);
        dmg_rod(b, v3(0, 0, -0.8f * h), v3(0, 0, 0.8f * h), 1.1f * hub);
        break;
    case 3: /* thin ring and spokes: hand wheels, bicycles */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.93f * radius, fminf(0.07f * radius, h));
        draw_spokes(b, spokes, 0.5f * hub, 0.93f * radius, 0.06f * radius, 0.3f * width);
        dmg_rod(b, v3(0, 0, -h), v3(0, 0, h), hub);
        break;
    case 4:
        draw_gear(b, radius, width, 2 * spokes);
        break;
    case 5: { /* barrel-shaped roller */
        const dmg_xy profile[] = {{0, -h},     {0.85f * radius, -h},       {0.97f * radius, -0.4f * h},
                                  {radius, 0}, {0.97f * radius, 0.4f * h}, {0.85f * radius, h},
                                  {0, h}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 7);
        break;
    }
    default: /* torus on a disc */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius - fminf(h, 0.3f * radius), fminf(h, 0.3f * radius));
        dmg_rod(b, v3(0, 0, -0.5f * h), v3(0, 0, 0.5f * h), 0.7f * radius);
        break;
    }
}

static void draw_blade(dmg_builder* b, int kind, float radius, float hub, float chord, float twist) {
    float from = 0.7f * hub, t = 0.12f * chord;
    dmg_turn(b, v3(1, 0, 0), twist);
    if (kind == 0) dmg_box(b, v3(0.5f * (from + radius), 0, 0), v3(radius - from, chord, t));
    if (kind == 1) { /* tapered, round tip */
        const dmg_xy outline[] = {{from, -0.2f * chord},
                                  {0.3f * radius, -0.5f * chord},
                                  {0.85f * radius, -0.35f * chord},
                                  {radius, -0.05f * chord},
                                  {radius, 0.1f * chord},
                                  {0.8f * radius, 0.4f * chord},
                                  {0.3f * radius, 0.5f * chord},
                                  {from, 0.2f * chord}};
        dmg_extrude(b, outline, 8, -0.5f * t, 0.5f * t);
    }
    if (kind == 2)
        dmg_ellipsoid(b, v3(0.5f * (from + radius), 0, 0), v3(0.5f * (radius - from), 0.5f * chord, 0.7f * t));
    if (kind == 3) { /* paddle on an arm */
        dmg_rod(b, v3(from, 0, 0), v3(0.7f * radius, 0, 0), 0.12f * chord);
        dmg_box(b, v3(0.8f * radius, 0, 0), v3(0.4f * radius, chord, t));
    }
}

void dmg_blades_draw(dmg_builder* b, int kind, float radius, float hub, float chord, int count, float twist) {
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        draw_blade(b, kind, radius, hub, chord, twist);
        dmg_restore(b);
    }
}
