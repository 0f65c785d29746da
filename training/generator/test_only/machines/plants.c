/* Draws conveyors of rollers, wheels and belts with gates, arms and stops. */
#include "core/build.h"
#include "parts/hardware.h"

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
