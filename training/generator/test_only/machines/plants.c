/* Draws factory equipment: conveyors of rollers, wheels and belts with gates, arms and stops; boilers, autoclaves,
 * furnaces and kilns with their doors, bolts, dampers and gauges. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* ---- a conveyor along X ---- */

typedef struct conveyor {
    float length, half, high; /* high: of the rollers' axes; half: of the width */
    float r, pitch, rail;     /* rail: height of the side frames */
} conveyor;

/* Side frames from x0 to x1. */
static void draw_frames(dmg_builder* b, const conveyor* c, float x0, float x1) {
    float t = 0.04f * c->half + 0.01f, up = 0.35f * c->rail;
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * (c->half + 0.5f * t);
        dmg_box(b, v3(0.5f * (x0 + x1), c->high + up - 0.5f * c->rail, z), v3(x1 - x0, c->rail, t));
    }
}

static void draw_rollers(dmg_builder* b, const conveyor* c, uint32_t parent, float x0, float x1) {
    int count = (int)((x1 - x0) / c->pitch);
    float step = (x1 - x0) / (float)count, sign = dmg_sign(b);
    for (int i = 0; i < count; ++i) {
        float x = x0 + step * ((float)i + 0.5f);
        dmg_spin(b, parent, "roller", v3(x, c->high, 0), v3(0, 0, sign));
        dmg_rod(b, v3(x, c->high, -c->half), v3(x, c->high, c->half), c->r);
    }
    dmg_use(b, parent);
}

/* Narrow wheels on fixed axles, in rows that are set off against each other. */
static void draw_skates(dmg_builder* b, const conveyor* c, float x0, float x1) {
    int rows = dmg_int(b, 4, 8), each = dmg_int(b, 2, 4);
    float step = (x1 - x0) / (float)rows, r = fminf(0.45f * step, 1.6f * c->r), w = 0.25f * c->half / (float)each;
    for (int i = 0; i < rows; ++i) {
        float x = x0 + step * ((float)i + 0.5f), shift = i % 2 ? 0.15f : -0.15f;
        dmg_rod(b, v3(x, c->high, -c->half), v3(x, c->high, c->half), 0.2f * r);
        for (int k = 0; k < each; ++k) {
            float z = c->half * (2.0f * ((float)k + 0.5f + shift) / (float)each - 1.0f);
            dmg_spin(b, 0, "skate_wheel", v3(x, c->high, z), v3(0, 0, 1));
            dmg_rod(b, v3(x, c->high, z - w), v3(x, c->high, z + w), r);
            dmg_use(b, 0);
        }
    }
}

/* Draws a belt about a drum at either end: the whole loop, or the upper run alone on its bed. */
static void draw_belt(dmg_builder* b, const conveyor* c, float x0, float x1) {
    enum { BEND = 7 };
    dmg_xy loop[2 * BEND + 2];
    float r = fminf(c->r * dmg_range(b, 1.3f, 2.2f), 0.48f * c->rail), t = 0.004f, half = 0.94f * c->half;
    bool whole = dmg_chance(b, 0.5f);
    int count = 0;
    loop[count++] = (dmg_xy){0.5f * (x0 + x1) + 0.001f, -r - t};
    for (int e = 0; e < 2; ++e)
        for (int i = 0; i < BEND; ++i) {
            float angle = (e ? 0.5f : -0.5f) * DMG_PI + DMG_PI * (float)i / (float)(BEND - 1);
            loop[count++] = (dmg_xy){(e ? x0 + r : x1 - r) + (r + t) * cosf(angle), (r + t) * sinf(angle)};
        }
    loop[count++] = (dmg_xy){0.5f * (x0 + x1) - 0.001f, -r - t};
    dmg_save(b);
    dmg_move(b, 0, c->high, 0);
    if (whole)
        dmg_bent_plate(b, loop, count, t, 2 * half);
    else
        dmg_box_span(b, v3(x0 + r, r + 0.001f, -half), v3(x1 - r, r + t, half));
    dmg_box_span(b, v3(x0 + 2.2f * r, 0.5f * r, -c->half), v3(x1 - 2.2f * r, 0.96f * r, c->half));
    dmg_restore(b);
    for (int e = 0; e < 2; ++e) {
        float x = e ? x1 - r : x0 + r, end = 1.12f * c->half + 0.02f;
        dmg_spin(b, 0, "drum", v3(x, c->high, 0), v3(0, 0, 1));
        dmg_rod(b, v3(x, c->high, -0.96f * c->half), v3(x, c->high, 0.96f * c->half), 0.98f * r);
        dmg_rod(b, v3(x, c->high, 0.96f * c->half), v3(x, c->high, end), 0.3f * r);
        dmg_use(b, 0);
    }
}

/* Tapered rollers round a corner that bends to -Z, its start at the origin. */
static void draw_bend(dmg_builder* b, const conveyor* c) {
    int count = dmg_int(b, 8, 16);
    float inner = c->half * dmg_range(b, 0.8f, 2.5f), outer = inner + 2 * c->half, arc = dmg_range(b, 0.8f, 1.6f),
          end = 0.75f * c->r;
    dmg_save(b);
    dmg_move(b, 0, 0, -inner - c->half);
    for (int i = 0; i < count; ++i) {
        float step = arc / (float)count;
        for (int s = 0; s < 2; ++s) {
            float r = s ? outer + 0.02f : inner - 0.02f, y = c->high - 0.15f * c->rail, from = step * (float)i,
                  to = from + step;
            dmg_beam(b, v3(r * sinf(from), y, r * cosf(from)), v3(r * sinf(to), y, r * cosf(to)), 0.025f, c->rail);
            if (i == count / 2) {
                float a = 0.5f * (from + to);
                dmg_beam(b, v3(r * sinf(a), 0, r * cosf(a)), v3(r * sinf(a), y, r * cosf(a)), 0.05f, 0.05f);
            }
        }
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), step * ((float)i + 0.5f));
        dmg_spin(b, 0, "roller", v3(0, c->high, 0), v3(0, 0, 1));
        dmg_cone(b, v3(0, c->high, inner), v3(0, c->high, outer), end, 1.1f * c->r);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_restore(b);
}

/* Legs in pairs with braces; their feet are screws, or casters. */
static void draw_legs(dmg_builder* b, const conveyor* c, float x0, float x1) {
    int pairs = x1 - x0 > 1.8f ? dmg_int(b, 2, 4) : 2, feet = dmg_weighted(b, (const float[]){2, 1, 1}, 3);
    float t = dmg_range(b, 0.03f, 0.06f), top = c->high - 0.5f * c->rail, foot = feet ? 0.12f * c->high : 0.0f;
    for (int i = 0; i < pairs; ++i) {
        float x = x0 + (x1 - x0) * (0.08f + 0.84f * (float)i / (float)(pairs - 1));
        for (int s = -1; s <= 1; s += 2) {
            float z = (float)s * (c->half + 0.02f);
            dmg_box_span(b, v3(x - t, foot, z - 0.5f * t), v3(x + t, top, z + 0.5f * t));
            if (feet == 1) {
                dmg_screw(b, 0, "foot", v3(x, foot, z), v3(0, -1, 0), 0.002f, 0.0f, 12.0f);
                dmg_rod(b, v3(x, 0.2f * foot, z), v3(x, foot + 0.3f * t, z), 0.25f * t);
                dmg_cone(b, v3(x, 0, z), v3(x, 0.3f * foot, z), t, 0.4f * t);
            } else if (feet == 2) {
                dmg_save(b);
                dmg_move(b, x + 0.1f * foot, 0.42f * foot, z);
                uint32_t fork = dmg_spin(b, 0, "caster", v3(-0.1f * foot, 0, 0), v3(0, 1, 0));
                dmg_box(b, v3(-0.05f * foot, 0.5f * foot, 0), v3(0.3f * foot, 0.16f * foot, 0.5f * foot));
                dmg_box(b, v3(0, 0.1f * foot, 0.22f * foot), v3(0.2f * foot, 0.9f * foot, 0.06f * foot));
                dmg_spin(b, fork, "wheel", v3(0, 0, 0), v3(0, 0, 1));
                dmg_wheel_draw(b, dmg_int(b, 0, 2), 0.42f * foot, 0.32f * foot, 5);
                dmg_restore(b);
            }
            dmg_use(b, 0);
        }
        dmg_box(b, v3(x, 0.35f * top + foot, 0), v3(0.8f * t, t, 2 * c->half));
    }
}

/* Rails beside the load, on their brackets; some fold down outwards. */
static void draw_guards(dmg_builder* b, const conveyor* c, float x0, float x1) {
    int posts = dmg_int(b, 2, 4);
    float top = c->high + 0.35f * c->rail, up = c->half * dmg_range(b, 0.25f, 0.6f), t = 0.012f, z = c->half + 0.035f;
    bool both = dmg_chance(b, 0.6f), folds = dmg_chance(b, 0.6f), solid = dmg_chance(b, 0.4f);
    for (int s = both ? -1 : 1; s <= 1; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(0, 0, 1));
        if (folds) dmg_hinge(b, 0, "side_guard", v3(0, top + t, z), v3(1, 0, 0), 0.0f, 2.6f);
        for (int i = 0; i < posts; ++i) {
            float x = x0 + (x1 - x0) * ((float)i + 0.5f) / (float)posts;
            dmg_box_span(b, v3(x - t, top, z), v3(x + t, top + up, z + t));
        }
        if (solid)
            dmg_box_span(b, v3(x0, top + 0.15f * up, z - t), v3(x1, top + up, z + 0.001f));
        else
            dmg_rod(b, v3(x0, top + up, z), v3(x1, top + up, z), t);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Arms on the rail's far side that swing across the rollers. */
static void draw_diverters(dmg_builder* b, const conveyor* c, float x0, float x1) {
    int count = dmg_int(b, 1, 3);
    float each = (x1 - x0) / (float)count, reach = fminf(0.85f * each, 1.7f * c->half),
          swing = dmg_range(b, 0.5f, 0.95f), tall = dmg_range(b, 0.04f, 0.12f),
          y = c->high + fmaxf(c->r, 0.35f * c->rail) + 0.01f, z = -c->half + 0.015f;
    float rest = dmg_chance(b, 0.4f) ? swing : 0.0f;
    for (int i = 0; i < count; ++i) {
        float x = x0 + each * ((float)i + 0.08f);
        dmg_rod(b, v3(x, c->high, z - 0.045f), v3(x, y - 0.004f, z - 0.045f), 0.03f);
        uint32_t arm = dmg_hinge(b, 0, "diverter", v3(x, y, z - 0.045f), v3(0, -1, 0), 0.0f, swing);
        dmg_rest(b, arm, rest);
        dmg_rod(b, v3(x, y, z - 0.045f), v3(x, y + tall, z - 0.045f), 0.025f);
        dmg_box_span(b, v3(x, y, z - 0.055f), v3(x + reach, y + tall, z - 0.035f));
        dmg_use(b, 0);
    }
}

/* Box on the front rail with a mushroom button to stop the line. */
static void draw_stop_button(dmg_builder* b, const conveyor* c, float x) {
    float s = dmg_range(b, 0.06f, 0.1f), z = c->half + 0.07f, y = c->high;
    dmg_box_span(b, v3(x - 0.5f * s, y - 0.7f * s, c->half + 0.01f), v3(x + 0.5f * s, y + 0.7f * s, z + 0.4f * s));
    z += 0.4f * s;
    dmg_rod(b, v3(x, y, z - 0.002f), v3(x, y, z + 0.1f * s), 0.36f * s);
    dmg_slide(b, 0, "emergency_stop", v3(0, 0, -1), 0.0f, 0.12f * s);
    const dmg_xy cap[] = {
        {0.15f * s, 0.08f * s}, {0.15f * s, 0.25f * s}, {0.32f * s, 0.26f * s}, {0.3f * s, 0.4f * s}, {0, 0.48f * s}};
    dmg_lathe(b, v3(x, y, z), v3(0, 0, 1), cap, 5);
    dmg_use(b, 0);
}

void dmg_build_roll_conveyor(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){4, 1.5f, 2, 1.2f}, 4);
    conveyor c = {.length = dmg_scale_range(b, 0.9f, 3.5f)};
    c.half = dmg_range(b, 0.15f, 0.45f);
    c.high = dmg_range(b, 0.45f, 1.0f);
    c.r = dmg_range(b, 0.02f, 0.04f);
    float wide = dmg_range(b, 2.15f, 3.6f),
          gate = design == 0 && dmg_chance(b, 0.45f) ? dmg_range(b, 0.5f, 0.9f) : 0.0f;
    c.pitch = fmaxf(c.r * wide, (c.length + gate) / 24.0f);
    c.rail = c.r * dmg_range(b, 3.0f, 4.5f);
    float x0 = -0.5f * c.length, x1 = -x0, gap = c.pitch - 2 * c.r;
    draw_frames(b, &c, x0, x1);
    draw_legs(b, &c, x0, x1);
    if (design == 0 || design == 3) draw_rollers(b, &c, 0, x0, x1);
    if (design == 1) draw_skates(b, &c, x0, x1);
    if (design == 2) draw_belt(b, &c, x0, x1);
    if (design == 3) {
        dmg_save(b);
        dmg_move(b, x1, 0, 0);
        draw_bend(b, &c);
        dmg_restore(b);
    }
    if (gate > 0.0f) { /* a length of the line that lifts to let people through */
        float up = c.high + 0.35f * c.rail;
        uint32_t leaf = dmg_hinge(b, 0, "gate", v3(x1 + 0.006f, up, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.3f, 1.7f));
        draw_frames(b, &c, x1 + 0.006f, x1 + gate);
        draw_rollers(b, &c, leaf, x1 + 0.02f, x1 + gate);
        dmg_use(b, 0);
    }
    bool arms = dmg_chance(b, 0.35f);
    if (arms)
        draw_diverters(b, &c, x0, x1);
    else if (dmg_chance(b, 0.5f))
        draw_guards(b, &c, x0, x1);
    if (!arms && design == 0 && dmg_chance(b, 0.4f) && gap > 0.012f) { /* comes up between two rollers */
        int count = (int)(c.length / c.pitch);
        float x = x0 + c.length * (float)dmg_int(b, 1, count - 1) / (float)count, t = 0.3f * gap,
              top = c.high + 0.6f * c.r;
        dmg_slide(b, 0, "stop_plate", v3(0, 1, 0), 0.0f, dmg_range(b, 2.0f, 4.0f) * c.r);
        dmg_box_span(b, v3(x - t, c.high - 3.5f * c.r, -0.8f * c.half), v3(x + t, top, 0.8f * c.half));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) draw_stop_button(b, &c, x0 + c.length * dmg_range(b, 0.1f, 0.9f));
    if (dmg_chance(b, 0.35f)) { /* the drive below, behind its cover */
        float w = fminf(0.25f, 0.2f * c.length), h = 0.3f * c.high;
        dmg_box(b, v3(0, c.high - 0.5f * c.rail - 0.4f * h, 0), v3(w, h, 1.2f * c.half));
    }
}

/* ---- a boiler ---- */

/* Draws a dial on z = 0 facing +Z. */
static void draw_dial(dmg_builder* b, uint32_t parent, float r) {
    dmg_rod(b, v3(0, 0, -0.3f * r), v3(0, 0, 0.2f * r), r);
    uint32_t hand = dmg_hinge(b, parent, "gauge_hand", v3(0, 0, 0), v3(0, 0, -1), -2.3f, 2.3f);
    dmg_rest(b, hand, dmg_range(b, -2.3f, 2.0f));
    dmg_rod(b, v3(0, 0, 0.2f * r), v3(0, 0, 0.32f * r), 0.12f * r);
    dmg_beam(b, v3(0, -0.2f * r, 0.26f * r), v3(0, 0.85f * r, 0.26f * r), 0.07f * r, 0.05f * r);
    dmg_use(b, parent);
}

/* Draws a disc over a hole, pushed aside about a pin above it. */
static void draw_peep_hole(dmg_builder* b, uint32_t parent, float r) {
    float pin = r * dmg_range(b, 1.0f, 1.6f), swing = dmg_range(b, 1.0f, 2.4f);
    dmg_rod(b, v3(0, 0, -0.2f * r), v3(0, 0, 0.2f * r), 0.8f * r);
    dmg_hinge(b, parent, "peep_cover", v3(0, pin, 0), v3(0, 0, dmg_sign(b)), 0.0f, swing);
    dmg_rod(b, v3(0, 0, 0.25f * r), v3(0, 0, 0.45f * r), r);
    dmg_rod(b, v3(0, pin, -0.1f * r), v3(0, pin, 0.5f * r), 0.22f * r);
    dmg_beam(b, v3(0, 0, 0.35f * r), v3(0, pin, 0.35f * r), 0.3f * r, 0.18f * r);
    dmg_use(b, parent);
}

/* Round the door's rim, on pins of the flange: closed they lie forward in forks of the door. */
static void draw_swing_bolts(dmg_builder* b, uint32_t door, float r, float t) {
    int count = dmg_int(b, 4, 12);
    float rod = 0.035f * r, at = 1.1f * r, rest = dmg_chance(b, 0.3f) ? 1.4f : 0.0f;
    bool nuts = dmg_chance(b, 0.4f) && count <= 8;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI + DMG_PI / (float)count);
        dmg_use(b, 0);
        for (int s = -1; s <= 1; s += 2) {
            float y = (float)s * 2.4f * rod;
            dmg_use(b, 0);
            dmg_box(b, v3(at, y, -0.06f * r), v3(0.16f * r, 1.2f * rod, 0.1f * r));
            dmg_use(b, door);
            dmg_box(b, v3(1.06f * r, y, 0.5f * t), v3(0.16f * r, 1.2f * rod, 0.6f * t));
        }
        uint32_t bolt = dmg_hinge(b, 0, "swing_bolt", v3(at, 0, -0.06f * r), v3(0, 1, 0), 0.0f, 1.6f);
        dmg_rest(b, bolt, rest);
        dmg_rod(b, v3(at, -1.7f * rod, -0.06f * r), v3(at, 1.7f * rod, -0.06f * r), rod);
        dmg_rod(b, v3(at, 0, -0.06f * r), v3(at, 0, t + 0.14f * r), rod);
        if (nuts) dmg_screw(b, bolt, "nut", v3(at, 0, t), v3(0, 0, 1), 0.1f * rod, 0.0f, 12.0f);
        dmg_rod(b, v3(at, 0, t + 0.01f * r), v3(at, 0, t + 0.07f * r), 1.65f * rod);
        dmg_restore(b);
    }
    dmg_use(b, door);
}

/* Bolts that run out of the door's rim as its wheel is turned. */
static void draw_rim_bolts(dmg_builder* b, uint32_t door, float r, float t) {
    int count = dmg_int(b, 3, 8);
    float w = 0.05f * r;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, count);
        dmg_use(b, door);
        dmg_box(b, v3(0.75f * r, 0, t + 0.9f * w), v3(0.08f * r, 3.2f * w, 1.8f * w));
        dmg_slide(b, door, "door_bolt", v3(-1, 0, 0), 0.0f, 0.14f * r);
        dmg_box(b, v3(0.72f * r, 0, t + 0.8f * w), v3(0.6f * r, 1.4f * w, w));
        dmg_restore(b);
    }
    dmg_use(b, door);
}

/* Draws a ring about the door that locks it by a short turn; handles on it. */
static void draw_lock_ring(dmg_builder* b, float r, float t) {
    int handles = dmg_int(b, 2, 6);
    float turn = dmg_range(b, 0.2f, 0.6f);
    dmg_hinge(b, 0, "lock_ring", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, turn);
    const dmg_xy band[] = {{1.05f * r, 0.01f * r},
                           {1.2f * r, 0.01f * r},
                           {1.2f * r, 1.05f * t},
                           {1.05f * r, 1.05f * t},
                           {1.05f * r, 0.01f * r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), band, 5);
    for (int i = 0; i < handles; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, handles);
        dmg_rod(b, v3(0, 1.15f * r, 0.5f * t), v3(0, 1.45f * r, 0.6f * t), 0.04f * r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws the round door on z = 0: on a hinge beside it, or on an arm from a post. */
static void draw_round_door(dmg_builder* b, float r) {
    float t = r * dmg_range(b, 0.1f, 0.25f), bulge = r * dmg_range(b, 0.0f, 0.3f), swing = dmg_range(b, 1.4f, 2.2f),
          off = r * dmg_range(b, 1.24f, 1.6f), arm = 0.08f * r;
    int lock = dmg_int(b, 0, 4);
    bool davit = dmg_chance(b, 0.4f);
    if (dmg_chance(b, 0.4f)) dmg_mirror(b, v3(1, 0, 0));
    float out = davit ? t + bulge + arm : 0.5f * t, tall = davit ? 0.35f * r : 0.5f * r;
    uint32_t door = dmg_hinge(b, 0, "door", v3(-off, 0, out), v3(0, -1, 0), 0.0f, swing);
    const dmg_xy head[] = {
        {0, 0.002f * r}, {r, 0.002f * r}, {r, t}, {0.75f * r, t + 0.6f * bulge}, {0.4f * r, t + 0.92f * bulge},
        {0, t + bulge}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), head, 6);
    if (davit) {
        dmg_beam(b, v3(-off, 0, out), v3(0, 0, out), arm, 1.6f * arm);
        dmg_rod(b, v3(0, 0, t + 0.9f * bulge), v3(0, 0, out + arm), 1.3f * arm);
    } else {
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3(-off, (float)s * 0.7f * tall, out), v3(-0.6f * r, (float)s * 0.7f * tall, t), arm, arm);
    }
    dmg_rod(b, v3(-off, -tall, out), v3(-off, tall, out), 0.8f * arm);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) {
        float y = (float)s * (tall + 0.6f * arm);
        dmg_box_span(b, v3(-off - arm, y - 0.5f * arm, out - arm), v3(-off + arm, y + 0.5f * arm, out + arm));
        dmg_beam(b, v3(-off, y, out), v3(-0.8f * r, y, -0.1f * r), arm, arm);
    }
    float face = t + bulge + (davit ? 2 * arm : 0.0f);
    if (lock == 0) draw_swing_bolts(b, door, r, t);
    if (lock == 1 && bulge < 0.1f * r) draw_rim_bolts(b, door, r, t + 0.6f * bulge);
    if (lock == 2) draw_lock_ring(b, fminf(r, 0.83f * off / 1.2f * 1.15f), t);
    if (lock != 2 && lock != 0)
        dmg_handwheel_place(b, door, "lock_wheel", v3(0, 0, face - 0.01f * r), 0, r * dmg_range(b, 0.25f, 0.5f));
    dmg_save(b);
    dmg_move(b, 0.15f * r, davit ? 0.5f * r : 0.62f * r, t + 0.62f * bulge);
    if (lock == 0 && dmg_chance(b, 0.4f)) draw_peep_hole(b, door, 0.1f * r);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* On top of a vessel: a weighted safety valve, valves with wheels, a gauge on a siphon. */
static void draw_mountings(dmg_builder* b, float r, float deep, float y) {
    int count = dmg_int(b, 1, 3);
    for (int i = 0; i < count; ++i) {
        float z = -deep * ((float)i + 0.6f) / ((float)count + 0.2f), h = r * dmg_range(b, 0.25f, 0.5f), w = 0.08f * r;
        int kind = dmg_int(b, 0, 2);
        dmg_rod(b, v3(0, y - 0.1f * r, z), v3(0, y + h, z), w);
        dmg_save(b);
        dmg_move(b, 0, y + h, z);
        if (kind == 0) {
            dmg_box_span(b, v3(-1.8f * w, -0.3f * w, -0.4f * w), v3(-w, 1.4f * w, 0.4f * w));
            dmg_hinge(b, 0, "safety_lever", v3(-1.4f * w, 1.2f * w, 0), v3(0, 0, 1), 0.0f, 0.4f);
            dmg_beam(b, v3(-1.4f * w, 0.9f * w, 0), v3(7 * w, 0.9f * w, 0), 0.4f * w, 0.7f * w);
            dmg_rod(b, v3(6 * w, -1.2f * w, 0), v3(6 * w, 0.9f * w, 0), 1.2f * w);
            dmg_use(b, 0);
        } else if (kind == 1) {
            dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
            dmg_rod(b, v3(-2 * w, 0, -0.6f * h), v3(2 * w, 0, -0.6f * h), w);
            dmg_handwheel_place(b, 0, "valve_wheel", v3(0, 0, 0), 0, 2.5f * w);
        } else {
            dmg_move(b, 0, 1.5f * w, 1.2f * w);
            draw_dial(b, 0, 2.2f * w);
        }
        dmg_restore(b);
    }
}

/* Draws a lying cylinder on saddles, or one that stands in a square case; the door at its front. */
static void draw_pressure_vessel(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.2f, 1.1f), deep = r * dmg_range(b, 1.5f, 5.0f), y = r * dmg_range(b, 1.35f, 2.2f);
    bool cased = dmg_chance(b, 0.25f);
    const dmg_xy shell[] = {{0, -deep - 0.2f * r}, {0.7f * r, -deep - 0.12f * r}, {r, -deep},
                            {r, -0.12f * r},       {1.16f * r, -0.12f * r},       {1.16f * r, 0},
                            {0.92f * r, 0},        {0.92f * r, -0.9f * deep},     {0, -0.9f * deep}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 0, 1), shell, 9);
    for (int i = 0; i < 2 && !cased; ++i)
        dmg_box(b, v3(0, 0.5f * (y - 0.7f * r), -deep * (i ? 0.8f : 0.22f)), v3(1.5f * r, y - 0.7f * r, 0.12f * deep));
    if (cased) dmg_box_span(b, v3(-1.25f * r, 0, -deep), v3(1.25f * r, y + 1.15f * r, -0.2f * r));
    draw_mountings(b, r, deep, y + (cased ? 1.15f : 1.0f) * r);
    dmg_move(b, 0, y, 0);
    draw_round_door(b, r);
}

/* Draws a pipe up from the top with a damper's lever on its side. */
static void draw_flue(dmg_builder* b, float r, float high) {
    float y = high * dmg_range(b, 0.3f, 0.7f), reach = fminf(2.2f * r, 1.3f * y);
    bool weight = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, -0.02f * r, 0), v3(0, high, 0), r);
    dmg_rod(b, v3(0.9f * r, y, 0), v3(1.15f * r, y, 0), 0.22f * r);
    uint32_t lever = dmg_hinge(b, 0, "damper", v3(0, y, 0), v3(dmg_sign(b), 0, 0), 0.0f, 1.57f);
    dmg_rest(b, lever, 1.57f * dmg_unit(b));
    dmg_rod(b, v3(1.15f * r, y, 0), v3(1.35f * r, y, 0), 0.18f * r);
    dmg_beam(b, v3(1.3f * r, y - (weight ? 0.6f * reach : 0.0f), 0), v3(1.3f * r, y + 0.5f * reach, 0), 0.12f * r,
             0.2f * r);
    if (weight) dmg_rod(b, v3(1.25f * r, y - 0.6f * reach, 0), v3(1.5f * r, y - 0.6f * reach, 0), 0.35f * r);
    dmg_use(b, 0);
}

/* Fire door over ash door or ash drawer, each with what it has on it. */
static void draw_fronts(dmg_builder* b, float wide, float y0, float y1, float fire) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.25f * wide);
    float split = y0 + (y1 - y0) * dmg_range(b, 0.25f, 0.4f);
    bool drawer = dmg_chance(b, 0.5f), peep = dmg_chance(b, 0.5f), rose = dmg_chance(b, 0.4f);
    leaf.width = fire;
    leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    leaf.thickness = 0.05f * wide;
    leaf.panel.kind = dmg_chance(b, 0.5f) ? DMG_PANEL_FLAT : DMG_PANEL_RAISED;
    leaf.height = 0.94f * (y1 - split);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (y1 + split), leaf.thickness);
    uint32_t door = dmg_leaf_draw(b, 0, "fire_door", &leaf);
    if (peep) draw_peep_hole(b, door, 0.08f * fire);
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (split + y0), leaf.thickness);
    if (drawer) {
        dmg_drawer ash = dmg_drawer_pick(b, 0.25f * wide);
        ash.width = fire;
        ash.height = 0.94f * (split - y0);
        ash.thickness = leaf.thickness;
        ash.depth = 0.7f * wide;
        ash.travel = 0.6f * wide;
        ash.handles = 1;
        dmg_drawer_draw(b, 0, "ash_drawer", &ash);
    } else {
        leaf.height = 0.94f * (split - y0);
        door = dmg_leaf_draw(b, 0, "ash_door", &leaf);
        if (rose) { /* a draught wheel on a thread */
            float r = 0.3f * fminf(leaf.height, fire);
            dmg_screw(b, door, "draught_wheel", v3(0, 0, 0), v3(0, 0, 1), 0.004f, 0.0f, 6.0f);
            dmg_rod(b, v3(0, 0, 0.004f), v3(0, 0, 0.1f * r), r);
            dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.25f * r, 0.5f * r);
        }
    }
    dmg_use(b, 0);
    dmg_restore(b);
}

/* Draws a furnace in a house or a workshop: a case whose front has an opening, a flue, a lid for fuel. */
static void draw_furnace(dmg_builder* b) {
    float wide = dmg_range(b, 0.4f, 0.9f), high = wide * dmg_range(b, 1.3f, 2.4f),
          deep = wide * dmg_range(b, 0.8f, 1.5f), w = 0.06f * wide, fire = wide * dmg_range(b, 0.5f, 0.75f),
          foot = dmg_chance(b, 0.5f) ? 0.08f * wide : 0.0f, y0 = foot + 0.1f * wide,
          y1 = foot + high * dmg_range(b, 0.5f, 0.85f);
    bool lid = dmg_chance(b, 0.35f);
    if (foot > 0.0f) dmg_feet_draw(b, 2, wide, deep, foot);
    float side = 0.5f * (wide - 0.96f * fire), x = 0.5f * wide, top = foot + high;
    dmg_box_span(b, v3(-x, foot, -deep), v3(x, top, -deep + w));
    dmg_box_span(b, v3(-x, foot, -deep + w), v3(-x + side, top, 0));
    dmg_box_span(b, v3(x - side, foot, -deep + w), v3(x, top, 0));
    dmg_box_span(b, v3(-x + side, foot, -deep + w), v3(x - side, y0, 0));
    dmg_box_span(b, v3(-x + side, y1, -deep + w), v3(x - side, top, 0));
    draw_fronts(b, wide, y0, y1, fire);
    dmg_save(b);
    dmg_move(b, dmg_range(b, -0.1f, 0.1f) * wide, top, -0.75f * deep);
    draw_flue(b, 0.14f * wide, wide * dmg_range(b, 0.5f, 1.2f));
    dmg_restore(b);
    if (lid) {
        float t = 0.06f * wide;
        dmg_hinge(b, 0, "fuel_lid", v3(0, top + 0.5f * t, -0.55f * deep), v3(-1, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.35f * wide, top + 0.001f, -0.54f * deep), v3(0.35f * wide, top + t, -0.08f * deep));
        dmg_box(b, v3(0, top + 1.3f * t, -0.13f * deep), v3(0.2f * wide, 0.6f * t, 0.05f * deep));
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, 0.25f * wide, 0.5f * (y1 + top), 0.012f * wide);
    if (top - y1 > 0.25f * wide) draw_dial(b, 0, 0.07f * wide);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f))
        dmg_machine_lever_place(b, 0, "grate_lever", v3(x, foot + 0.3f * wide, -0.4f * deep), 0.5f * DMG_PI,
                                0.35f * wide);
}

/* Draws a kiln of many sides filled from the top, plugs in its spy holes. */
static void draw_kiln(dmg_builder* b) {
    enum { MOST = 12 };
    dmg_xy outer[MOST], inner[MOST];
    int sides = dmg_int(b, 6, MOST), plugs = dmg_int(b, 1, 3);
    float r = dmg_range(b, 0.2f, 0.5f), high = r * dmg_range(b, 1.2f, 2.6f), foot = r * dmg_range(b, 0.2f, 0.7f),
          lid = 0.16f * r, swing = dmg_range(b, 0.9f, 1.5f), knob = 0.09f * r;
    for (int i = 0; i < sides; ++i) {
        float angle = 2 * DMG_PI * ((float)i + 0.5f) / (float)sides - 0.5f * DMG_PI;
        outer[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
        inner[i] = (dmg_xy){0.78f * outer[i].x, 0.78f * outer[i].y};
    }
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.55f : -0.55f) * r, z = (i & 2 ? 0.55f : -0.55f) * r;
        dmg_rod(b, v3(x, 0, z), v3(x, foot, z), 0.06f * r);
    }
    float flat = r * cosf(DMG_PI / (float)sides), top = foot + high;
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_extrude(b, outer, sides, foot, foot + 0.15f * r);
    dmg_ring_plate(b, outer, inner, sides, foot + 0.15f * r, top);
    dmg_hinge(b, 0, "lid", v3(0, flat + 0.08f * r, top), v3(-1, 0, 0), 0.0f, swing);
    dmg_extrude(b, outer, sides, top + 0.004f * r, top + lid);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.2f * r, top, -flat - 0.12f * r), v3(0.2f * r, top + 0.9f * lid, -flat + 0.02f * r));
    dmg_rod(b, v3(-0.2f * r, top + 0.5f * lid, flat + 0.12f * r), v3(0.2f * r, top + 0.5f * lid, flat + 0.12f * r),
            0.03f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.2f * r, top + 0.5f * lid, flat - 0.02f * r),
                v3((float)s * 0.2f * r, top + 0.5f * lid, flat + 0.12f * r), 0.03f * r);
    dmg_use(b, 0);
    for (int i = 0; i < plugs; ++i) {
        float y = foot + high * (0.25f + 0.6f * ((float)i + 0.5f) / (float)plugs);
        dmg_slide(b, 0, "spy_plug", v3(0, 0, 1), 0.0f, 0.25f * r);
        dmg_cone(b, v3(0, y, flat - 0.2f * r), v3(0, y, flat + 0.1f * r), 0.7f * knob, 1.2f * knob);
        dmg_use(b, 0);
    }
    dmg_box(b, v3(flat + 0.12f * r, foot + 0.5f * high, 0), v3(0.26f * r, 0.6f * high, 0.6f * r));
    dmg_save(b);
    dmg_move(b, flat + 0.12f * r, foot + 0.5f * high, 0.3f * r);
    dmg_knobs_draw(b, 0, dmg_int(b, 1, 4), 0, 0.14f * high, 0.07f * r);
    dmg_restore(b);
}

/* Draws a row of ovens with tall doors, each on an arm that swings from a post; screws hold it shut. */
static void draw_retorts(dmg_builder* b) {
    int count = dmg_int(b, 1, 3);
    float wide = dmg_range(b, 0.4f, 1.0f), high = wide * dmg_range(b, 0.8f, 2.0f),
          deep = wide * dmg_range(b, 1.0f, 2.0f), sill = wide * dmg_range(b, 0.1f, 0.9f), t = 0.12f * wide,
          arm = 0.07f * wide, pitch = 1.9f * wide;
    bool screw = dmg_chance(b, 0.6f);
    dmg_panel panel = dmg_panel_pick(b);
    panel.kind = dmg_chance(b, 0.5f) ? DMG_PANEL_RAISED : DMG_PANEL_FLAT;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), sill + 0.5f * high, 0);
        float post = -0.72f * wide, out = t + arm, side = 0.5f * (pitch - 0.9f * wide), y = 0.5f * high;
        dmg_box_span(b, v3(-0.5f * pitch, -y - sill, -deep), v3(0.5f * pitch, y + 0.3f * wide, -0.9f * deep));
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * (0.45f * wide + 0.5f * side);
            dmg_box(b, v3(x, 0.15f * wide - 0.5f * sill, -0.45f * deep),
                    v3(side, high + sill + 0.3f * wide, 0.9f * deep));
            dmg_box_span(b, v3(post - arm, (float)s * (y + 0.02f * wide) - arm, -0.02f * wide),
                         v3(post + arm, (float)s * (y + 0.02f * wide) + arm, out + arm));
        }
        dmg_box_span(b, v3(-0.45f * wide, -y - sill, -0.9f * deep), v3(0.45f * wide, -0.93f * y, 0));
        dmg_box_span(b, v3(-0.45f * wide, 0.93f * y, -0.9f * deep), v3(0.45f * wide, y + 0.3f * wide, 0));
        uint32_t door = dmg_hinge(b, 0, "davit", v3(post, 0, out), v3(0, -1, 0), 0.0f, dmg_range(b, 1.5f, 2.4f));
        dmg_rod(b, v3(post, -y + arm, out), v3(post, y - arm, out), 0.6f * arm);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3(post, (float)s * 0.5f * y, out), v3(0.4f * wide, (float)s * 0.5f * y, out), arm, arm);
        if (dmg_chance(b, 0.5f)) door = dmg_hinge(b, door, "door", v3(0, 0, out), v3(0, 1, 0), -0.25f, 0.25f);
        dmg_move(b, 0, 0, t);
        dmg_panel_draw(b, &panel, wide, high, 0.98f * t);
        dmg_box(b, v3(0, 0, 0.4f * arm), v3(0.3f * wide, 0.35f * high, 0.8f * arm));
        if (screw) dmg_handwheel_place(b, door, "door_screw", v3(0, 0, 0.8f * arm), 0, 0.22f * wide);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_boiler(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 2, 1, 1.2f}, 4);
    if (design == 0) draw_pressure_vessel(b);
    if (design == 1) draw_furnace(b);
    if (design == 2) draw_kiln(b);
    if (design == 3) draw_retorts(b);
}
