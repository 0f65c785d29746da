/* Draws stools on gas lifts or screws, rocking and gaming chairs; lamps on jointed arms, poles and tripods. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- lamps ---- */

/* Draws a shade about the origin, its mouth towards -Y: a cone, a bowl, a tube or a flat panel. */
static void draw_shade(dmg_builder* b, int kind, float r) {
    const dmg_xy cone[] = {{r, -0.9f * r},       {0.45f * r, 0.35f * r}, {0, 0.4f * r},
                           {0.4f * r, 0.3f * r}, {0.95f * r, -0.9f * r}, {r, -0.9f * r}};
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cone, 6);
    if (kind == 1) dmg_dome(b, v3(0, -0.5f * r, 0), v3(r, 0.9f * r, r));
    if (kind == 2) dmg_rod(b, v3(0, -0.9f * r, 0), v3(0, 0.5f * r, 0), 0.5f * r);
    if (kind == 3) dmg_box(b, v3(0, -0.05f * r, 0.8f * r), v3(0.8f * r, 0.15f * r, 2.4f * r));
    if (kind < 2) dmg_ellipsoid(b, v3(0, -0.3f * r, 0), v3(0.3f * r, 0.4f * r, 0.3f * r));
}

/* Arms one on the other, each bent against the one before, the shade at the end. */
static void draw_jointed_lamp(dmg_builder* b, float size) {
    int arms = dmg_int(b, 1, 3), shade = dmg_int(b, 0, 3);
    float base = size * dmg_range(b, 0.12f, 0.2f), t = size * dmg_range(b, 0.01f, 0.025f),
          length = size * dmg_range(b, 0.35f, 0.55f), lean = dmg_range(b, -0.5f, 0.3f), y = 0.12f * base + 2 * t, z = 0;
    bool turns = dmg_chance(b, 0.6f), twin = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.12f * base, 0), base);
    uint32_t last = turns ? dmg_spin(b, 0, "foot", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rod(b, v3(0, 0.121f * base, 0), v3(0, y + t, 0), 1.6f * t);
    for (int i = 0; i < arms; ++i) {
        float part = length * (i ? 0.8f : 1.0f), y1 = y + part * cosf(lean), z1 = z + part * sinf(lean);
        last = dmg_hinge(b, last, "arm", v3(0, y, z), v3(i & 1 ? -1.0f : 1.0f, 0, 0), -0.5f, 0.6f);
        dmg_rod(b, v3(-2.2f * t, y, z), v3(2.2f * t, y, z), 1.1f * t);
        for (int s = -1; s <= 1; s += 2)
            if (twin || s > 0)
                dmg_rod(b, v3(twin ? 1.4f * (float)s * t : 0, y, z), v3(twin ? 1.4f * (float)s * t : 0, y1, z1),
                        0.6f * t);
        y = y1;
        z = z1;
        lean += i ? 0.5f : dmg_range(b, 0.9f, 1.5f);
    }
    float r = size * dmg_range(b, 0.1f, 0.18f);
    last = dmg_hinge(b, last, "shade", v3(0, y, z), v3(1, 0, 0), -0.9f, 0.9f);
    dmg_rod(b, v3(-2.4f * t, y, z), v3(2.4f * t, y, z), 1.2f * t);
    dmg_save(b);
    dmg_move(b, 0, y - 0.1f * r, z + 0.3f * r);
    draw_shade(b, shade, r);
    if (dmg_chance(b, 0.4f) && shade < 3) {
        dmg_spin(b, last, "switch_knob", v3(0, 0.3f * r, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.3f * r, 0), v3(0, 0.65f * r, 0), 0.12f * r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a pole on a foot or three legs: the shade tilts, the pole grows, a chain, a pedal or a dimmer switches. */
static void draw_standing_lamp(dmg_builder* b, float size) {
    float h = size * dmg_range(b, 0.75f, 1.1f), t = size * dmg_range(b, 0.006f, 0.012f),
          r = size * dmg_range(b, 0.1f, 0.17f), spread = size * dmg_range(b, 0.15f, 0.25f),
          knee = h * dmg_range(b, 0.25f, 0.7f), z = 0;
    bool legs = dmg_chance(b, 0.5f), folds = dmg_chance(b, 0.6f), grows = dmg_chance(b, 0.4f);
    int shade = dmg_int(b, 0, 2), extra = dmg_int(b, 0, 2);
    for (int i = 0; i < 3 && legs; ++i) {
        float a = 2 * DMG_PI * (float)i / 3.0f + 0.5f;
        dmg_vec out = v3(sinf(a), 0, cosf(a)), top = v3(2.2f * t * out.x, knee, 2.2f * t * out.z);
        if (folds) dmg_hinge(b, 0, "leg", top, v3(out.z, 0, -out.x), -0.25f, fminf(0.9f, 0.8f * atan2f(spread, knee)));
        dmg_rod(b, top, v3(spread * out.x, 0, spread * out.z), t);
        dmg_use(b, 0);
    }
    if (!legs) dmg_cone(b, v3(0, 0, 0), v3(0, 0.02f * size, 0), 0.8f * spread, 0.7f * spread);
    dmg_rod(b, v3(0, legs ? 0.9f * knee : 0, 0), v3(0, grows ? 0.7f * h : h, 0), 1.3f * t);
    uint32_t pole = 0;
    if (grows) {
        pole = dmg_slide(b, 0, "pole", v3(0, 1, 0), 0.0f, 0.25f * h);
        dmg_rod(b, v3(0, 0.4f * h, 0), v3(0, h, 0), 0.9f * t);
    }
    uint32_t head = dmg_hinge(b, pole, "shade", v3(0, h, z), v3(1, 0, 0), -0.6f, 0.6f);
    dmg_rod(b, v3(-2.5f * t, h, 0), v3(2.5f * t, h, 0), 1.8f * t);
    dmg_save(b);
    dmg_move(b, 0, h + r, 0);
    draw_shade(b, shade == 2 ? 0 : shade, r);
    dmg_rod(b, v3(0, -r, 0), v3(0, -0.2f * r, 0), 1.5f * t);
    if (extra == 0) {
        dmg_slide(b, head, "pull_switch", v3(0, -1, 0), 0.0f, 0.03f);
        dmg_rod(b, v3(0.35f * r, -1.5f * r, 0), v3(0.35f * r, -0.2f * r, 0), 0.25f * t);
        dmg_ellipsoid(b, v3(0.35f * r, -1.5f * r, 0), v3(t, 1.5f * t, t));
    }
    dmg_restore(b);
    if (extra == 1) { /* on the floor, at the end of the lead */
        float x = spread + 0.06f;
        dmg_use(b, 0);
        dmg_box_span(b, v3(0, 0, -0.003f), v3(x, 0.006f, 0.003f));
        dmg_box_span(b, v3(x - 0.03f, 0, -0.04f), v3(x + 0.03f, 0.02f, 0.04f));
        dmg_hinge(b, 0, "foot_pedal", v3(x, 0.024f, -0.035f), v3(1, 0, 0), 0.0f, 0.12f);
        dmg_box_span(b, v3(x - 0.025f, 0.026f, -0.035f), v3(x + 0.025f, 0.034f, 0.035f));
    }
    if (extra == 2) {
        dmg_use(b, 0);
        dmg_hinge(b, 0, "dimmer", v3(0, 0.65f * h, 1.3f * t), v3(0, 0, -1), 0.0f, 4.7f);
        dmg_rod(b, v3(0, 0.65f * h, 1.31f * t), v3(0, 0.65f * h, 4 * t), 1.8f * t);
        dmg_box(b, v3(0, 0.65f * h + t, 4 * t), v3(0.4f * t, 1.4f * t, 0.5f * t));
    }
    dmg_use(b, 0);
}

void dmg_build_lamp_stand(dmg_builder* b) {
    bool standing = dmg_chance(b, 0.5f);
    float size = standing ? dmg_range(b, 1.1f, 1.7f) : dmg_scale_range(b, 0.4f, 1.5f);
    if (standing)
        draw_standing_lamp(b, size);
    else
        draw_jointed_lamp(b, size);
}

/* ---- seats ---- */

/* Draws a bar stool: the seat turns on a column that rises; a ring for the feet, a low back, a lever below. */
static void draw_bar_stool(dmg_builder* b) {
    float h = dmg_range(b, 0.55f, 0.85f), r = dmg_range(b, 0.16f, 0.24f), base = dmg_range(b, 0.18f, 0.26f), t = 0.025f,
          thick = dmg_range(b, 0.03f, 0.09f), rise = dmg_range(b, 0.1f, 0.25f);
    bool screw = dmg_chance(b, 0.25f), back = dmg_chance(b, 0.5f), soft = dmg_chance(b, 0.5f),
         cast = dmg_chance(b, 0.3f);
    if (cast)
        for (int i = 0; i < 4; ++i) {
            float a = 0.5f * DMG_PI * ((float)i + 0.5f);
            dmg_beam(b, v3(0, 0.4f * h, 0), v3(1.1f * base * sinf(a), 0, 1.1f * base * cosf(a)), 0.03f, 0.03f);
        }
    else
        dmg_cone(b, v3(0, 0, 0), v3(0, 0.03f, 0), base, 0.9f * base);
    dmg_rod(b, v3(0, cast ? 0.35f * h : 0.03f, 0), v3(0, 0.6f * h, 0), 1.3f * t);
    if (dmg_chance(b, 0.6f)) { /* a ring held in front */
        dmg_torus(b, v3(0, 0.35f * h, 0.05f), v3(0, 1, 0), 0.16f, 0.01f);
        dmg_box_span(b, v3(-0.01f, 0.35f * h - 0.01f, 0), v3(0.01f, 0.35f * h + 0.01f, 0.21f));
    }
    uint32_t column = screw ? 0 : dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, fminf(rise, 0.3f * h));
    if (!screw) dmg_rod(b, v3(0, 0.25f * h, 0), v3(0, h - 0.03f, 0), 0.8f * t);
    uint32_t seat = screw ? dmg_screw(b, 0, "seat", v3(0, 0, 0), v3(0, 1, 0), 0.004f, 0.0f, 30.0f)
                          : dmg_spin(b, column, "seat", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, screw ? 0.3f * h : h - 0.029f, 0), v3(0, h, 0), screw ? 0.7f * t : 0.3f * r);
    if (soft)
        dmg_rounded_box(b, v3(0, h + 0.5f * thick, 0), v3(1.9f * r, thick, 1.8f * r), 0.4f * thick);
    else
        dmg_rod(b, v3(0, h, 0), v3(0, h + thick, 0), r);
    if (back) {
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0.5f * (float)s * r, h + 0.3f * thick, -0.7f * r), v3(0.5f * (float)s * r, h + 0.25f, -r),
                    0.012f);
        dmg_rounded_box(b, v3(0, h + 0.26f, -r - 0.01f), v3(1.6f * r, 0.12f, 0.03f), 0.012f);
    }
    if (!screw) {
        dmg_hinge(b, seat, "lever", v3(0.3f * r, h - 0.015f, 0.03f), v3(0, 0, 1), 0.0f, 0.25f);
        dmg_capsule(b, v3(0.25f * r, h - 0.015f, 0.03f), v3(0.95f * r, h - 0.025f, 0.03f), 0.006f);
    }
    dmg_use(b, 0);
}

/* Runners on the floor; what stands on them turns about the middle of their circle. Returns its part. */
static uint32_t draw_rockers(dmg_builder* b, float w, float y, float d) {
    float radius = 1.3f * y + 0.3f, x = 0.5f * w;
    dmg_move(b, 0, 0.02f, 0);
    uint32_t chair = dmg_hinge(b, 0, "chair", v3(0, radius, 0), v3(1, 0, 0), -0.25f, 0.25f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec runner[9];
        for (int i = 0; i < 9; ++i) {
            float a = 0.45f * ((float)i - 4.0f) / 4.0f;
            runner[i] = v3(0.9f * (float)s * x, radius - (radius - 0.02f) * cosf(a), radius * sinf(a));
        }
        dmg_sweep(b, runner, 9, 0.018f, 0.018f, false);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(0.9f * (float)s * x, 0.03f, 0.35f * (float)k * d),
                    v3(0.85f * (float)s * x, y, 0.35f * (float)k * d), 0.016f);
    }
    dmg_use(b, 0); /* the floor it rocks on */
    dmg_box_span(b, v3(-0.8f * w, -0.02f, -d), v3(0.8f * w, 0, d));
    return chair;
}

/* Draws a star foot, a column that rises and a seat that turns on it. Returns the seat. */
static uint32_t draw_star_foot(dmg_builder* b, float y) {
    for (int i = 0; i < 5; ++i) {
        float a = 2 * DMG_PI * (float)i / 5.0f;
        dmg_vec end = v3(0.3f * sinf(a), 0.075f, 0.3f * cosf(a));
        dmg_beam(b, v3(0, 0.1f, 0), end, 0.035f, 0.025f);
        dmg_rod(b, v3(end.x, 0, end.z), v3(end.x, 0.07f, end.z), 0.022f);
    }
    uint32_t column = dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, 0.1f);
    dmg_rod(b, v3(0, 0.12f, 0), v3(0, y - 0.03f, 0), 0.025f);
    uint32_t seat = dmg_spin(b, column, "seat", v3(0, 0, 0), v3(0, 1, 0));
    dmg_box_span(b, v3(-0.1f, y - 0.029f, -0.12f), v3(0.1f, y, 0.12f));
    return seat;
}

/* Draws an armchair on casters or rockers: back and arm rests tilt, a foot rest swings out from under it. */
static void draw_lounging_chair(dmg_builder* b) {
    float w = dmg_range(b, 0.46f, 0.6f), y = dmg_range(b, 0.38f, 0.48f), d = dmg_range(b, 0.44f, 0.55f),
          t = dmg_range(b, 0.05f, 0.12f), tall = dmg_range(b, 0.5f, 0.85f), x = 0.5f * w,
          lean = dmg_range(b, 0.05f, 0.35f);
    bool rocks = dmg_chance(b, 0.35f), foot = dmg_chance(b, 0.5f), head = dmg_chance(b, 0.5f),
         lift = dmg_chance(b, 0.7f);
    uint32_t seat = rocks ? draw_rockers(b, w, y, d) : draw_star_foot(b, y);
    dmg_use(b, seat);
    dmg_rounded_box(b, v3(0, y + 0.5f * t, 0), v3(w, t, d), 0.4f * t);
    float z = -0.5f * d - 0.02f, by = y + 0.6f * t;
    uint32_t back = dmg_hinge(b, seat, "backrest", v3(0, by, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.1f));
    dmg_save(b);
    dmg_move(b, 0, by, z);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_rounded_box(b, v3(0, 0.5f * tall, -0.3f * t), v3(0.92f * w, tall, 0.8f * t), 0.3f * t);
    if (head) {
        dmg_slide(b, back, "headrest", v3(0, 1, 0), 0.0f, 0.1f);
        dmg_rounded_box(b, v3(0, 0.9f * tall, 0.13f * t + 0.022f), v3(0.5f * w, 0.12f, 0.04f), 0.015f);
    }
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) {
        float ax = (float)s * (x + 0.04f), ay = y + t + 0.2f;
        dmg_use(b, seat);
        dmg_box_span(b, v3(fminf(ax, 0.7f * (float)s * x), y - 0.02f, -0.03f),
                     v3(fmaxf(ax, 0.7f * (float)s * x), y, 0.03f));
        dmg_box_span(b, v3(ax - 0.015f, y - 0.02f, -0.03f), v3(ax + 0.015f, ay - 0.05f, 0.03f));
        bool slides = lift && !rocks;
        if (slides)
            dmg_slide(b, seat, "arm_rest", v3(0, 1, 0), 0.0f, 0.08f);
        else
            dmg_hinge(b, seat, "arm_rest", v3(ax, ay - 0.04f, -0.02f), v3(-1, 0, 0), 0.0f, 1.4f);
        dmg_box_span(b, v3(ax - 0.01f, slides ? ay - 0.15f : ay - 0.049f, -0.02f), v3(ax + 0.01f, ay, 0.02f));
        dmg_rounded_box(b, v3(ax, ay + 0.01f, 0), v3(0.07f, 0.03f, 0.26f), 0.01f);
    }
    if (foot) {
        dmg_hinge(b, seat, "foot_rest", v3(0, y - 0.002f, 0.5f * d), v3(-1, 0, 0), 0.0f, 1.4f);
        dmg_box_span(b, v3(-0.8f * x, y - 0.28f, 0.5f * d), v3(0.8f * x, y - 0.004f, 0.5f * d + 0.03f));
    }
    dmg_use(b, 0);
}

void dmg_build_stool_chair(dmg_builder* b) {
    if (dmg_chance(b, 0.45f))
        draw_bar_stool(b);
    else
        draw_lounging_chair(b);
}
