/* Draws dishes and radars: a reflector on a fork, a pole, a tripod or a tower. It looks to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct dish_style {
    float radius, depth;
    int skin;          /* one sheet, two with a rim, a rim beside it */
    int feed;          /* a tripod of struts, one arm from below, a horn, none */
    bool ribs, offset; /* offset: cut from beside the axis, taller than wide */
} dish_style;

static dish_style pick_dish(dmg_builder* b, float radius) {
    dish_style d = {.radius = radius, .depth = radius * dmg_range(b, 0.12f, 0.5f)};
    d.skin = dmg_int(b, 0, 2);
    d.feed = dmg_int(b, 0, 3);
    d.ribs = dmg_chance(b, 0.3f);
    d.offset = dmg_chance(b, 0.25f);
    return d;
}

/* Vertex at the origin, opening to +Z. */
static void draw_bowl(dmg_builder* b, const dish_style* d) {
    float r = d->radius, h = d->depth, t = 0.03f * r;
    const dmg_xy sheet[] = {{0, 0}, {0.4f * r, 0.16f * h}, {0.75f * r, 0.56f * h}, {r, h}};
    const dmg_xy solid[] = {{0, 0},     {0.4f * r, 0.16f * h},      {0.75f * r, 0.56f * h},    {r, h},
                            {r, h + t}, {0.75f * r, 0.56f * h + t}, {0.4f * r, 0.16f * h + t}, {0, t}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), d->skin == 0 ? sheet : solid, d->skin == 0 ? 4 : 8);
    if (d->skin == 2) dmg_torus(b, v3(0, 0, h), v3(0, 0, 1), r, 0.04f * r);
    for (int i = 0; i < 6 && d->ribs; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), DMG_PI / 3.0f * (float)i);
        dmg_beam(b, v3(0.1f * r, 0, -0.08f * r), v3(0.95f * r, 0, 0.85f * h), 0.02f * r, 0.12f * r);
        dmg_restore(b);
    }
}

static void draw_feed(dmg_builder* b, const dish_style* d) {
    float r = d->radius, focus = r * r / (4.0f * d->depth);
    focus = fminf(focus, 1.6f * r);
    if (d->feed == 0)
        for (int i = 0; i < 3; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / 3.0f + 0.5f;
            dmg_rod(b, v3(0.8f * r * cosf(angle), 0.8f * r * sinf(angle), 0.64f * d->depth), v3(0, 0, focus),
                    0.015f * r);
        }
    if (d->feed == 1) dmg_beam(b, v3(0, -0.95f * r, 0.8f * d->depth), v3(0, -0.35f * r, focus), 0.06f * r, 0.06f * r);
    if (d->feed == 2) dmg_cone(b, v3(0, 0, 0), v3(0, 0, 0.6f * focus), 0.12f * r, 0.05f * r);
    if (d->feed < 2)
        dmg_rod(b, v3(0, d->feed == 1 ? -0.35f * r : 0.0f, focus - 0.06f * r),
                v3(0, d->feed == 1 ? -0.35f * r : 0.0f, focus + 0.08f * r), 0.08f * r);
}

/* ---- what stands below, up to y = high ---- */

static void draw_legs(dmg_builder* b, float high, float spread, float thick, int legs) {
    for (int i = 0; i < legs; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)legs + 0.3f;
        dmg_rod(b, v3(spread * cosf(angle), 0, spread * sinf(angle)), v3(0, high, 0), thick);
    }
}

static void draw_lattice(dmg_builder* b, float high, float half, float thick) {
    int bays = dmg_int(b, 2, 4);
    float narrow = dmg_range(b, 0.5f, 1.0f);
    for (int i = 0; i < 4; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)i);
        for (int k = 0; k < bays; ++k) {
            float s0 = (float)k / (float)bays, s1 = (float)(k + 1) / (float)bays, w0 = half * (1 + (narrow - 1) * s0),
                  w1 = half * (1 + (narrow - 1) * s1);
            dmg_beam(b, v3(w0, s0 * high, w0), v3(w1, s1 * high, w1), thick, thick);
            dmg_beam(b, v3(w1, s1 * high, w1), v3(-w1, s1 * high, w1), thick, thick);
            dmg_beam(b, v3(w0, s0 * high, w0), v3(-w1, s1 * high, w1), 0.7f * thick, 0.7f * thick);
        }
        dmg_restore(b);
    }
}

/* Draws a floor with a railing round it. */
static void draw_platform(dmg_builder* b, float y, float half, float thick) {
    dmg_box(b, v3(0, y, 0), v3(2 * half, thick, 2 * half));
    if (!dmg_chance(b, 0.6f)) return;
    for (int i = 0; i < 4; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)i);
        dmg_beam(b, v3(-half, y + 0.3f * half, half), v3(half, y + 0.3f * half, half), 0.4f * thick, 0.4f * thick);
        dmg_beam(b, v3(half, y, half), v3(half, y + 0.3f * half, half), 0.4f * thick, 0.4f * thick);
        dmg_restore(b);
    }
}

static void draw_stand(dmg_builder* b, float high, float radius) {
    float t = radius * dmg_range(b, 0.04f, 0.12f);
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) {
        const int legs = dmg_int(b, 3, 4);
        const float spread = radius * dmg_range(b, 0.4f, 1.2f);
        draw_legs(b, high, spread, 0.5f * t, legs);
    }
    if (kind == 1) dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 2.5f * t, t);
    if (kind == 2) dmg_box(b, v3(0, 0.5f * high, 0), v3(radius, high, radius));
    if (kind == 3) { /* a pole from a wall */
        const dmg_vec path[] = {{0, 0.3f * high, -radius}, {0, 0.35f * high, 0}, {0, high, 0}};
        dmg_sweep(b, path, 3, t, t, false);
        dmg_box(b, v3(0, 0.3f * high, -radius), v3(0.5f * radius, 0.5f * radius, t));
    }
    if (kind == 4) draw_lattice(b, high, 0.3f * radius, 0.4f * t);
}

/* Hand wheels and boxes near the foot: what one turns the dish with. */
static void draw_cranks(dmg_builder* b, float radius) {
    int count = dmg_int(b, 1, 2);
    for (int i = 0; i < count; ++i) {
        float x = (i ? -1.3f : 1.3f) * radius, y = 0.5f * radius, r = 0.25f * radius;
        dmg_box(b, v3(x, 0.5f * y, 0), v3(0.15f * radius, y, 0.15f * radius));
        dmg_box(b, v3(0.5f * x, 0.03f * radius, 0), v3(fabsf(x), 0.06f * radius, 0.2f * radius));
        dmg_save(b);
        dmg_move(b, x, y, 0.12f * radius);
        bool flat = dmg_chance(b, 0.4f);
        if (flat) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_spin(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 0, 1));
        const int spokes = dmg_int(b, 3, 5);
        const int kind = dmg_int(b, 0, 3);
        dmg_wheel_draw(b, kind, r, 0.3f * r, spokes);
        dmg_rod(b, v3(0, 0, -0.12f * radius), v3(0, 0, 0), 0.15f * r);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* ---- dish ---- */

void dmg_build_dish(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.1f, 8.0f), high = radius * dmg_range(b, 0.8f, 3.0f),
          t = radius * dmg_range(b, 0.05f, 0.14f), arm = radius * dmg_range(b, 0.2f, 1.15f),
          half = radius * dmg_range(b, 0.15f, 0.5f), behind = radius * dmg_range(b, 0.0f, 0.4f);
    if (arm < 0.5f * radius) behind = fmaxf(behind, 0.15f * radius);
    dish_style d = pick_dish(b, radius);
    draw_stand(b, high, radius);
    if (dmg_chance(b, 0.15f)) draw_cranks(b, radius);
    dmg_move(b, 0, high, 0);
    int mount = dmg_int(b, 0, 3), turns = dmg_int(b, 0, 3); /* fork, arm, clamp, bare */
    uint32_t yaw = 0;
    if (turns == 1) yaw = dmg_spin(b, 0, "azimuth", v3(0, 0, 0), v3(0, 1, 0));
    if (turns >= 2) yaw = dmg_hinge_either_way(b, 0, "azimuth", v3(0, 0, 0), v3(0, 1, 0), 0.5f, 3.1f);
    dmg_rod(b, v3(0, -0.5f * t, 0), v3(0, t, 0), 1.6f * t);
    for (int s = -1; s <= 1 && mount < 2; s += 2 - mount) /* two cheeks or one */
        dmg_beam(b, v3((float)s * 0.5f * half, t, 0), v3((float)s * half, arm, 0), t, t);
    if (mount == 2) dmg_box(b, v3(0, 0.5f * arm, 0), v3(2.5f * t, arm, 2 * t));
    if (mount == 3) dmg_rod(b, v3(0, 0, 0), v3(0, arm, 0), 0.6f * t);
    dmg_move(b, 0, arm, 0);
    float tilt = dmg_range(b, 0.0f, 1.3f), up = fmaxf(1.57f - tilt, 0.15f) * dmg_range(b, 0.4f, 1.0f),
          down = dmg_range(b, 0.1f, 0.3f + tilt);
    if (yaw == 0 || dmg_chance(b, 0.8f)) {
        dmg_hinge(b, yaw, "elevation", v3(0, 0, 0), v3(-1, 0, 0), -down, up);
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(-1.1f * half, 0, 0), v3(1.1f * half, 0, 0), 0.5f * t);
    }
    dmg_turn(b, v3(1, 0, 0), -tilt);
    if (behind > 0.1f * radius) dmg_beam(b, v3(0, 0, -0.5f * t), v3(0, 0, behind), fminf(1.6f * half, 3 * t), 2 * t);
    dmg_move(b, 0, d.offset ? 0.3f * radius : 0.0f, behind);
    draw_bowl(b, &d);
    draw_feed(b, &d);
    dmg_use(b, 0);
}

/* ---- radar on a tower ---- */

/* Draws a piece of a paraboloid or a cylinder, sides at ±width / 2, above `low`: one sheet, thick behind. */
static void draw_reflector(dmg_builder* b, float width, float low, float high, float bow, bool round) {
    enum { COLUMNS = 6, ROWS = 4 };
    for (int side = 0; side < 2; ++side) {
        uint32_t v[COLUMNS + 1][ROWS + 1];
        dmg_piece_begin(b);
        for (int i = 0; i <= COLUMNS; ++i) {
            for (int k = 0; k <= ROWS; ++k) {
                float s = 2.0f * (float)i / COLUMNS - 1.0f, y = (float)k / ROWS,
                      shrink = 1.0f - 0.35f * powf(fabsf(2.0f * y - 1.0f), 3),
                      z = bow * (s * s + (round ? y * y : 0.0f));
                v[i][k] = dmg_vertex(
                    b, v3(0.5f * width * s * shrink, low + (high - low) * y, z - 0.02f * width * (float)side));
            }
        }
        for (int i = 0; i < COLUMNS; ++i) {
            for (int k = 0; k < ROWS; ++k) {
                if (side)
                    dmg_quad(b, v[i][k], v[i][k + 1], v[i + 1][k + 1], v[i + 1][k]);
                else
                    dmg_quad(b, v[i][k], v[i + 1][k], v[i + 1][k + 1], v[i][k + 1]);
            }
        }
    }
}

static void draw_antenna(dmg_builder* b, int kind, float width, float t) {
    float high = width * dmg_range(b, 0.2f, 0.7f), back = width * dmg_range(b, -0.25f, 0.05f);
    if (kind <= 1) { /* a reflector with its horn before it, neither in the middle */
        float out = width * dmg_range(b, 0.3f, 0.7f), low = t;
        dmg_save(b);
        dmg_move(b, 0, 0, back);
        draw_reflector(b, width, low, low + high, width * dmg_range(b, 0.08f, 0.3f), kind == 0);
        dmg_beam(b, v3(0, low, 0), v3(0, low, out), t, t);
        dmg_box(b, v3(0, low + 0.12f * high, out), v3(dmg_range(b, 0.08f, 0.3f) * width, 0.25f * high, 0.1f * width));
        if (dmg_chance(b, 0.5f)) dmg_beam(b, v3(0, low + 0.6f * high, 0), v3(0, low, -0.3f * width), t, t);
        dmg_restore(b);
        dmg_box(b, v3(0, 0.5f * t, 0.5f * back), v3(2 * t, t, fabsf(back) + 2 * t));
    }
    if (kind > 1) /* what it stands on the neck with */
        dmg_rod(b, v3(0, 0.5f * t, 0), v3(0, t, kind == 2 ? 0.3f * back : back), 0.6f * t);
    if (kind == 2) dmg_box(b, v3(0, 1.5f * t, 0.3f * back), v3(width, 2 * t, 1.5f * t)); /* a bar, as ships have */
    if (kind == 3) {                                                                     /* a flat array, leaning */
        dmg_beam(b, v3(0, 0, back), v3(0, high, back - 0.2f * high), width, 0.06f * width);
        dmg_box(b, v3(0, 0.3f * high, back + 0.06f * width), v3(0.3f * width, 0.3f * high, 0.1f * width));
    }
    if (kind == 4) /* a rake of dipoles */
        for (int i = 0; i < 6; ++i) {
            float x = width * (0.2f * (float)i - 0.5f);
            dmg_rod(b, v3(x, t, back), v3(x, t + high, back), 0.15f * t);
            dmg_rod(b, v3(-0.5f * width, t + high * 0.2f * (float)i, back),
                    v3(0.5f * width, t + high * 0.2f * (float)i, back), 0.2f * t);
        }
}

void dmg_build_radar_tower(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.4f, 10.0f), high = width * dmg_range(b, 0.3f, 2.5f),
          t = width * dmg_range(b, 0.02f, 0.06f), half = width * dmg_range(b, 0.2f, 0.5f);
    int base = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 4);
    if (base == 0) draw_lattice(b, high, half, 0.5f * t);
    if (base == 1) dmg_box(b, v3(0, 0.5f * high, 0), v3(2 * half, high, 1.6f * half));
    if (base == 2) dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 0.5f * half, 0.3f * half);
    if (base == 3) draw_legs(b, high, half, 0.5f * t, dmg_int(b, 3, 5));
    if (base != 1 || dmg_chance(b, 0.4f)) draw_platform(b, high, 1.1f * half, 0.5f * t);
    float neck = width * dmg_range(b, 0.04f, 0.25f);
    dmg_rod(b, v3(0, high, 0), v3(0, high + 0.6f * neck, 0), width * dmg_range(b, 0.04f, 0.12f));
    dmg_move(b, 0, high, 0);
    uint32_t head = dmg_chance(b, 0.75f) ? dmg_spin(b, 0, "antenna", v3(0, 0, 0), v3(0, 1, 0))
                                         : dmg_hinge(b, 0, "antenna", v3(0, 0, 0), v3(0, 1, 0), -1.8f, 1.8f);
    dmg_rod(b, v3(0, 0.4f * neck, 0), v3(0, neck + t, 0), 0.8f * t);
    dmg_move(b, 0, neck, 0);
    if (kind != 2 && dmg_chance(b, 0.2f))
        dmg_hinge_either_way(b, head, "nod", v3(0, 0, 0), v3(1, 0, 0), 0.1f, 0.4f); /* it nods on its neck */
    draw_antenna(b, kind, width, t);
    dmg_use(b, 0);
}
