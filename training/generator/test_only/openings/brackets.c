/* Draws jointed wall arms with a screen, a mirror or a lamp, and scissor arms. */
#include "core/build.h"

/* ---- wall arm ---- */

/* Draws what the arm holds, at the origin of its tilting head, facing +Z: a screen, a round mirror, a lamp, a tray. */
static void draw_held(dmg_builder* b, int kind, float size) {
    float t = 0.06f * size, high = size * dmg_range(b, 0.5f, 0.7f);
    bool portrait = dmg_chance(b, 0.1f);
    dmg_rod(b, v3(0, 0, -0.05f * size), v3(0, 0, 0.06f * size), 0.1f * size);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.06f * size + t);
    if (portrait) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (kind == 0) {
        dmg_box(b, v3(0, 0, -t), v3(0.5f * size, 0.4f * high, t));
        dmg_rounded_plate(b, 1.6f * size, 1.6f * high, t, 0.03f * size);
    } else if (kind == 1) {
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0), 0.6f * size);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.6f * size, 0.5f * t);
    } else if (kind == 2) {
        const dmg_xy shade[] = {{0.1f * size, -t},    {0.2f * size, 0},  {0.5f * size, high},
                                {0.46f * size, high}, {0.15f * size, 0}, {0.1f * size, -t}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), shade, 6);
        dmg_ellipsoid(b, v3(0, 0, 0.3f * high), v3(0.16f * size, 0.16f * size, 0.3f * high));
    } else {
        dmg_box(b, v3(0, 0, 0), v3(0.4f * size, 0.3f * size, 2 * t));
        dmg_box_span(b, v3(-0.7f * size, -0.15f * size - t, -t), v3(0.7f * size, -0.15f * size, size));
    }
    dmg_restore(b);
}

/* Draws a head at the end: it may swivel, then tilt, then turn in its plane. */
static void draw_arm_head(dmg_builder* b, uint32_t arm, dmg_vec at, int held, float size) {
    float swivel = dmg_range(b, 0.5f, 1.5f), tilt = dmg_range(b, 0.2f, 1.0f), t = 0.05f * size;
    bool swivels = dmg_chance(b, 0.6f), rolls = dmg_chance(b, 0.25f), fork = dmg_chance(b, 0.3f);
    uint32_t part = arm;
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    if (swivels) part = dmg_hinge(b, part, "swivel", v3(0, 0, 0), v3(0, 1, 0), -swivel, swivel);
    dmg_rod(b, v3(0, -2.5f * t, 0), v3(0, 2.5f * t, 0), 1.1f * t);
    dmg_box_span(b, v3(-0.6f * t, -t, 0), v3(0.6f * t, t, 3 * t));
    dmg_move(b, 0, 0, 3.2f * t);
    if (fork)
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(1.8f * (float)s * t, 0, 0), v3(0.5f * t, 2 * t, 2.4f * t));
    if (fork) dmg_box(b, v3(0, 0, -t), v3(4 * t, 2 * t, 0.4f * t));
    part = dmg_hinge(b, part, "tilt", v3(0, 0, 0), v3(1, 0, 0), -tilt, tilt);
    dmg_rod(b, v3(-2.4f * t, 0, 0), v3(2.4f * t, 0, 0), 0.8f * t);
    dmg_box(b, v3(0, 0, 0.8f * t), v3(t, t, 1.6f * t));
    dmg_move(b, 0, 0, 1.2f * t + 0.05f * size);
    if (rolls) dmg_spin(b, part, "roll", v3(0, 0, 0), v3(0, 0, 1));
    draw_held(b, held, size);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws two or three links that swing about upright pins; the last may lift as a parallelogram's arm does. */
static void draw_links(dmg_builder* b, int held, float size) {
    int count = dmg_int(b, 1, 3), shape = dmg_int(b, 0, 2);
    float reach = size * dmg_range(b, 0.8f, 1.8f), t = size * dmg_range(b, 0.03f, 0.06f),
          plate = size * dmg_range(b, 0.2f, 0.4f), z = 2.2f * t;
    dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(plate, 1.4f * plate, t), 0.4f * t);
    dmg_box_span(b, v3(-t, -3 * t, -0.2f * t), v3(t, -1.5f * t, z + t));
    dmg_box_span(b, v3(-t, 1.5f * t, -0.2f * t), v3(t, 3 * t, z + t));
    uint32_t part = 0;
    dmg_vec at = v3(0, 0, z);
    for (int i = 0; i < count; ++i) { /* folded to and fro before the wall, each stretched out by its rest */
        float swing = i ? dmg_range(b, 2.0f, 2.9f) : dmg_range(b, 1.2f, 1.5f), side = i & 1 ? -1.0f : 1.0f,
              rest = swing * dmg_unit(b);
        dmg_vec end = v3(at.x + side * reach, 0, at.z + (i ? 0.25f * t : 0.0f));
        part = dmg_hinge(b, part, "link", at, v3(0, -side, 0), 0.0f, swing);
        dmg_rest(b, part, rest);
        float y = i & 1 ? 2.6f * t : 0.0f;
        dmg_rod(b, v3(at.x, -1.45f * t, at.z), v3(at.x, y + 1.45f * t, at.z), t);
        for (int k = shape == 1 ? -1 : 1; k <= 1; k += 2) {
            float lift = y + (shape == 1 ? 0.8f * (float)k * t : 0.0f);
            if (shape == 2)
                dmg_rod(b, v3(at.x, lift, at.z), v3(end.x, lift, end.z), 0.7f * t);
            else
                dmg_beam(b, v3(at.x, lift, at.z), v3(end.x, lift, end.z), 1.2f * t, (shape == 1 ? 0.7f : 2.0f) * t);
        }
        dmg_rod(b, v3(end.x, fminf(y, 0.0f) - 1.4f * t, end.z), v3(end.x, y + 1.4f * t, end.z), 1.1f * t);
        at = end;
    }
    float lift = count & 1 ? 0.0f : 2.6f * t;
    draw_arm_head(b, part, v3(at.x, lift, at.z + 1.5f * t), held, size);
}

/* Crossed laths that stretch: each cross turns about the pin of the one before it. */
static void draw_scissors(dmg_builder* b, int held, float size) {
    int crosses = dmg_int(b, 2, 4);
    float half = size * dmg_range(b, 0.2f, 0.35f), open = dmg_range(b, 0.35f, 0.9f), t = 0.1f * half;
    float deep = 2 * half * sinf(open), high = 2 * half * cosf(open);
    dmg_box_span(b, v3(-2.5f * t, -0.7f * high, -2 * t), v3(2.5f * t, 0.7f * high, -t)); /* the plate on the wall */
    dmg_rod(b, v3(0, -0.62f * high, 0), v3(0, 0.62f * high, 0), 0.6f * t);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-t, 0.6f * (float)s * high - t, -1.5f * t), v3(t, 0.6f * (float)s * high + t, t));
    uint32_t whole = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0), -1.3f, 1.3f), part = whole;
    dmg_rod(b, v3(0, 0.5f * high - 1.5f * t, 0), v3(0, 0.5f * high + 1.2f * t, 0), 1.3f * t);
    float z = 0;
    for (int i = 0; i < crosses; ++i) { /* the stretch of each cross carries all those before it */
        part = dmg_slide(b, part, "cross", v3(0, 0, -1), 0.0f, 0.7f * deep);
        for (int s = -1; s <= 1; s += 2) {
            float x = 0.7f * (float)s * t, y = 0.5f * (float)s * high;
            dmg_beam(b, v3(x, -y, z), v3(x, y, z + deep), t, 1.8f * t);
            dmg_rod(b, v3(-1.6f * t, y, z + deep), v3(1.6f * t, y, z + deep), 0.6f * t);
        }
        dmg_rod(b, v3(-1.6f * t, 0, z + 0.5f * deep), v3(1.6f * t, 0, z + 0.5f * deep), 0.6f * t);
        z += deep;
    }
    dmg_rod(b, v3(0, -0.5f * high, z), v3(0, 0.5f * high, z), t);
    draw_arm_head(b, part, v3(0, 0, z + 1.2f * t), held, size);
}

void dmg_build_wall_arm(dmg_builder* b) {
    int held = dmg_int(b, 0, 3);
    float size = held == 0 ? dmg_scale_range(b, 0.2f, 0.6f) : dmg_range(b, 0.12f, 0.22f);
    dmg_move(b, 0, 2 * size, 0);
    if (dmg_chance(b, 0.75f))
        draw_links(b, held, size);
    else
        draw_scissors(b, held, size);
}
