/* Draws doors and ramps of aircraft's holds, and rotor heads. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- rotor head ---- */

/* Draws one blade along +X from the hub: feathers, flaps, lags, or is part of the hub. */
static void draw_blade(dmg_builder* b, uint32_t hub, float reach, float length, float chord, int freedom, int kind) {
    float swing = dmg_range(b, 0.15f, 0.6f), t = 0.12f * chord;
    dmg_use(b, hub);
    dmg_box(b, v3(0.5f * reach, 0, 0), v3(reach, 1.5f * t, 0.5f * chord));
    if (freedom == 1) dmg_hinge(b, hub, "blade", v3(reach, 0, 0), v3(1, 0, 0), -swing, swing);
    if (freedom == 2) dmg_hinge(b, hub, "blade", v3(reach, 0, 0), v3(0, 0, 1), -0.3f * swing, swing);
    if (freedom == 3) dmg_hinge(b, hub, "blade", v3(0.9f * reach, 0, 0), v3(0, 1, 0), -0.5f * swing, 2.0f * swing);
    dmg_rod(b, v3(0.9f * reach, 0, 0), v3(1.5f * reach, 0, 0), 0.7f * t);
    float from = 1.3f * reach, droop = kind == 2 ? -0.03f * length : 0.0f;
    if (kind == 0) dmg_box(b, v3(from + 0.5f * length, 0, 0), v3(length, t, chord));
    if (kind > 0) dmg_beam(b, v3(from, 0, 0), v3(from + length, droop, 0), chord, t);
    if (kind == 1) dmg_box(b, v3(from + 0.93f * length, 0, -0.6f * chord), v3(0.1f * length, 0.5f * t, 0.3f * chord));
    dmg_use(b, hub);
}

void dmg_build_rotor_head(dmg_builder* b) {
    float mast = dmg_scale_range(b, 0.05f, 1.5f), radius = mast * dmg_range(b, 0.06f, 0.2f),
          reach = radius * dmg_range(b, 1.5f, 4.0f), length = mast * dmg_range(b, 0.5f, 5.0f),
          chord = radius * dmg_range(b, 0.8f, 2.5f);
    int blades = dmg_int(b, 2, 6), freedom = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 2);
    int facing = dmg_int(b, 0, 3); /* upright, upright, a tail rotor, an airscrew */
    dmg_move(b, 0, facing < 2 ? 0 : 1.3f * (length + reach), 0);
    if (facing == 2) dmg_turn(b, v3(0, 0, 1), -0.5f * DMG_PI);
    if (facing == 3) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    float base = 0.3f * mast, wide = radius * dmg_range(b, 3.0f, 6.0f);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0.5f * base, 0), v3(wide, base, 1.5f * wide), 0.1f * base);
    else
        dmg_cone(b, v3(0, 0, 0), v3(0, base, 0), 0.6f * wide, 0.3f * wide);
    bool turning_mast = dmg_chance(b, 0.5f);
    if (!turning_mast) dmg_rod(b, v3(0, base, 0), v3(0, 0.97f * mast, 0), radius);
    if (dmg_chance(b, 0.6f)) { /* the swash plate: tilts about a line across, or slides up and down */
        float at = base + 0.4f * (mast - base), disc = radius * dmg_range(b, 2.0f, 3.5f), way = 0.15f * (mast - base);
        int moves = dmg_int(b, 0, 2);
        if (moves == 0) dmg_slide(b, 0, "swash_plate", v3(0, 1, 0), -way, way);
        if (moves == 1) dmg_hinge(b, 0, "swash_plate", v3(0, at, 0), v3(1, 0, 0), -0.3f, 0.3f);
        if (moves == 2) dmg_hinge(b, 0, "swash_plate", v3(0, at, 0), v3(0, 0, 1), -0.3f, 0.3f);
        float t = 0.25f * radius;
        const dmg_xy ring[] = {{1.15f * radius, at - t},
                               {disc, at - t},
                               {disc, at + t},
                               {1.15f * radius, at + t},
                               {1.15f * radius, at - t}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), ring, 5);
        int horns = dmg_int(b, 0, 4);
        for (int i = 0; i < horns; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, horns);
            dmg_box(b, v3(1.1f * disc, at, 0), v3(0.5f * disc, t, t));
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
    dmg_move(b, 0, mast, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, 0, 3));
    uint32_t hub = dmg_spin(b, 0, "rotor", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, turning_mast ? base - mast : -radius, 0), v3(0, radius, 0), turning_mast ? radius : 1.6f * radius);
    if (dmg_chance(b, 0.4f)) dmg_dome(b, v3(0, radius, 0), v3(1.5f * radius, radius, 1.5f * radius));
    for (int i = 0; i < blades; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, blades);
        draw_blade(b, hub, reach, length, chord, freedom, kind);
        dmg_restore(b);
    }
}

/* ---- cargo hold ---- */

typedef struct hold {
    float half, high, floor, t, length; /* floor: its height in the tube */
    int skin;                           /* square, eight-sided, round above */
} hold;

/* Draws the tube's outline, walls from the floor over the roof, as a sheet z0 … z1. */
static void draw_hold_tube(dmg_builder* b, const hold* h, float z0, float z1) {
    static const dmg_xy outlines[3][9] = {
        {{1, 0}, {1, 0.5f}, {1, 1}, {0.5f, 1}, {0, 1}, {-0.5f, 1}, {-1, 1}, {-1, 0.5f}, {-1, 0}},
        {{0.9f, 0}, {1, 0.2f}, {1, 0.7f}, {0.6f, 1}, {0, 1}, {-0.6f, 1}, {-1, 0.7f}, {-1, 0.2f}, {-0.9f, 0}},
        {{0.85f, 0},
         {1, 0.35f},
         {0.92f, 0.7f},
         {0.6f, 0.92f},
         {0, 1},
         {-0.6f, 0.92f},
         {-0.92f, 0.7f},
         {-1, 0.35f},
         {-0.85f, 0}}};
    dmg_xy line[9];
    for (int i = 0; i < 9; ++i) line[i] = (dmg_xy){outlines[h->skin][i].x * h->half, outlines[h->skin][i].y * h->high};
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * (z0 + z1));
    dmg_bent_plate(b, line, 9, h->t, z1 - z0);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.85f * h->half, -h->t, z0), v3(0.85f * h->half, 0, z1));
}

/* Draws the ramp at the end z = 0, going up to the tail when shut, down to the ground when open; toes hinged at its
 * end. */
static void draw_ramp(dmg_builder* b, const hold* h, float length, float slope) {
    float wide = 0.82f * h->half, open = slope + dmg_range(b, 0.1f, 0.4f);
    dmg_vec end = {0, length * sinf(slope), -length * cosf(slope)};
    uint32_t ramp = dmg_hinge(b, 0, "ramp", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, open);
    dmg_beam(b, v3(0, 0, -0.01f * length), end, 2 * wide, h->t);
    int toes = dmg_chance(b, 0.5f) ? dmg_int(b, 1, 3) : 0;
    for (int i = 0; i < toes; ++i) { /* folded back on it */
        float x = wide * (2.0f * ((float)i + 0.5f) / (float)toes - 1.0f), width = 1.6f * wide / (float)toes;
        dmg_vec line = v3_add(end, v3(x, 1.1f * h->t, 0)), back = v3_mad(line, v3_normalize(end), -0.25f * length);
        dmg_use(b, ramp);
        dmg_hinge(b, ramp, "toe", line, v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
        dmg_beam(b, line, back, width, 0.6f * h->t);
    }
    dmg_use(b, 0);
}

/* Draws what closes the hold above the ramp: a door hung from the roof that goes up inside, or petals to the sides. */
static void draw_upper_doors(dmg_builder* b, const hold* h, float length, float rise) {
    float swing = dmg_range(b, 0.4f, 0.9f), wide = 0.8f * h->half;
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, 0, "upper_door", v3(0, h->high, 0), v3(dmg_chance(b, 0.5f) ? 1.0f : -1.0f, 0, 0), 0.0f,
                  0.5f * swing);
        dmg_beam(b, v3(0, h->high, -0.01f * length), v3(0, fmaxf(0.6f * h->high, rise + 2 * h->t), -0.9f * length),
                 2 * wide, h->t);
        dmg_use(b, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_hinge(b, 0, "petal", v3(side * h->half, 0, -0.01f * length), v3(0, side, 0), 0.0f, 1.8f * swing);
        dmg_beam(b, v3(side * h->half, 0.55f * h->high, -0.01f * length),
                 v3(side * 0.15f * h->half, 0.55f * h->high + 0.5f * rise, -0.9f * length), h->t, 0.7f * h->high);
        dmg_use(b, 0);
    }
}

/* Draws a door in the side: stairs on its inside when it hangs from the sill, a plug that swings, or one that goes up.
 */
static void draw_side_door(dmg_builder* b, const hold* h, float z, float side) {
    float width = h->high * dmg_range(b, 0.35f, 0.7f), high = 0.6f * h->high, x = side * (h->half + 0.6f * h->t),
          t = 0.5f * h->t;
    int kind = dmg_int(b, 0, 3), steps = dmg_int(b, 3, 6);
    uint32_t door = 0;
    if (kind == 0) door = dmg_hinge(b, 0, "airstair", v3(x, 0, z), v3(0, 0, -side), 0.0f, dmg_range(b, 1.7f, 2.4f));
    if (kind == 1)
        door = dmg_hinge(b, 0, "door", v3(x, 0, z + 0.5f * width), v3(0, -side, 0), 0.0f, dmg_range(b, 1.2f, 2.9f));
    if (kind == 2) door = dmg_hinge(b, 0, "cargo_door", v3(x, high, z), v3(0, 0, side), 0.0f, dmg_range(b, 1.2f, 2.4f));
    if (kind == 3) door = dmg_slide(b, 0, "door", v3(0, 0, -1), 0.0f, 0.9f * width);
    dmg_box_span(b, v3(x - t, 0, z - 0.5f * width), v3(x + t, high, z + 0.5f * width));
    for (int i = 0; i < steps && kind == 0; ++i)
        dmg_box(b, v3(x - side * 0.12f * high, high * ((float)i + 0.6f) / (float)steps, z),
                v3(0.2f * high, 0.5f * t, 0.8f * width));
    if (kind != 0 && dmg_chance(b, 0.5f)) { /* its handle turns */
        dmg_vec pin = {x + side * t, 0.45f * high, z - 0.3f * width};
        dmg_hinge(b, door, "handle", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 0.8f, 3.0f));
        dmg_box(b, v3_add(pin, v3(side * t, 0, 0.08f * width)), v3(t, 0.04f * high, 0.24f * width));
    }
    dmg_use(b, 0);
}

void dmg_build_cargo_hold(dmg_builder* b) {
    hold h = {.half = dmg_scale_range(b, 0.1f, 3.0f), .skin = dmg_int(b, 0, 2)};
    h.high = h.half * dmg_range(b, 1.1f, 2.2f);
    h.t = h.half * dmg_range(b, 0.02f, 0.07f);
    h.length = h.half * dmg_range(b, 1.0f, 5.0f);
    float slope = dmg_range(b, 0.0f, 0.5f), ramp = h.half * dmg_range(b, 1.0f, 2.5f);
    dmg_move(b, 0, 0.6f * ramp, 0);
    draw_hold_tube(b, &h, 0, h.length);
    bool tail = dmg_chance(b, 0.75f);
    if (tail) draw_ramp(b, &h, ramp, slope);
    if (tail && dmg_chance(b, 0.6f)) draw_upper_doors(b, &h, ramp, ramp * sinf(slope));
    if (dmg_chance(b, 0.35f))
        dmg_box_span(b, v3(-0.85f * h.half, 0, h.length), v3(0.85f * h.half, 0.9f * h.high, h.length + h.t));
    for (int s = -1; s <= 1; s += 2)
        if (!tail || dmg_chance(b, 0.5f)) draw_side_door(b, &h, h.length * dmg_range(b, 0.35f, 0.65f), (float)s);
}
