/* Draws what everyone would say does not move: shelves, stairs, fences, towers, barrels, monuments, walls, trees. All
 * are about a metre wide; sizes are set by hand. */
#include "asset/asset_layer.h"

/* An upright shelf; things are put on it later. */
static void draw_shelf(dmg_builder* b) {
    const float w = dmg_range(b, 0.5f, 1.4f), h = dmg_range(b, 0.6f, 2.2f), d = dmg_range(b, 0.2f, 0.5f);
    const float t = dmg_range(b, 0.015f, 0.04f);
    const int boards = dmg_int(b, 2, 6);
    for (int i = 0; i <= boards; ++i)
        dmg_box(b, v3(0, 0.5f * t + (h - t) * (float)i / (float)boards, 0), v3(w - 2.0f * t, t, d));
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0.5f * (float)s * (w - t), 0.5f * h, 0), v3(t, h, d));
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0.5f * h, -0.5f * d - 0.25f * t), v3(w, h, 0.5f * t));
}

static void draw_legs(dmg_builder* b, float w, float h, float d, bool round) {
    const float t = dmg_range(b, 0.02f, 0.06f);
    for (int i = 0; i < 4; ++i) {
        const float x = (i & 1 ? 0.5f : -0.5f) * (w - t), z = (i & 2 ? 0.5f : -0.5f) * (d - t);
        if (round)
            dmg_rod(b, v3(x, 0, z), v3(x, h, z), 0.5f * t);
        else
            dmg_box(b, v3(x, 0.5f * h, z), v3(t, h, t));
    }
}

/* A table with stools. */
static void draw_table(dmg_builder* b) {
    const float w = dmg_range(b, 0.6f, 1.6f), d = dmg_range(b, 0.5f, 0.9f), h = dmg_range(b, 0.4f, 0.8f);
    const int stools = dmg_int(b, 0, 4);
    const bool round = dmg_chance(b, 0.4f);
    dmg_box(b, v3(0, h + 0.015f, 0), v3(w, 0.03f, d));
    draw_legs(b, w, h, d, round);
    for (int i = 0; i < stools; ++i) {
        dmg_save(b);
        dmg_move(b, ((float)(i / 2) - 0.5f) * 0.5f * w, 0, i % 2 ? 0.4f + 0.5f * d : -0.4f - 0.5f * d);
        dmg_box(b, v3(0, 0.45f, 0), v3(0.35f, 0.04f, 0.35f));
        draw_legs(b, 0.33f, 0.43f, 0.33f, round);
        if (stools > 2) dmg_box(b, v3(0, 0.7f, i % 2 ? 0.16f : -0.16f), v3(0.35f, 0.45f, 0.03f));
        dmg_restore(b);
    }
}

static void draw_stairs(dmg_builder* b) {
    const int steps = dmg_int(b, 3, 12);
    const float rise = dmg_range(b, 0.14f, 0.2f), run = dmg_range(b, 0.22f, 0.32f), w = dmg_range(b, 0.6f, 1.5f);
    const bool solid = dmg_chance(b, 0.5f), railing = dmg_chance(b, 0.6f);
    for (int i = 0; i < steps; ++i) {
        const float y = rise * (float)(i + 1), z = run * (float)i, deep = solid ? y : 0.04f;
        dmg_box(b, v3(0, y - 0.5f * deep, z), v3(w, deep, run));
        if (railing) dmg_rod(b, v3(0.48f * w, y, z), v3(0.48f * w, y + 0.9f, z), 0.015f);
    }
    if (railing)
        dmg_beam(b, v3(0.48f * w, rise + 0.9f, 0), v3(0.48f * w, rise * (float)steps + 0.9f, run * (float)(steps - 1)),
                 0.05f, 0.04f);
}

static void draw_fence(dmg_builder* b) {
    const int posts = dmg_int(b, 2, 6), pickets = dmg_int(b, 0, 8);
    const float gap = dmg_range(b, 0.8f, 1.6f), h = dmg_range(b, 0.6f, 1.4f);
    for (int i = 0; i < posts; ++i) dmg_box(b, v3(gap * (float)i, 0.5f * h, 0), v3(0.08f, h, 0.08f));
    const float end = gap * (float)(posts - 1);
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0.5f * end, h * (i ? 0.85f : 0.3f), 0.05f), v3(end + 0.08f, 0.07f, 0.03f));
    for (int i = 0; i < pickets * (posts - 1); ++i) {
        const float x = end * ((float)i + 0.5f) / (float)(pickets * (posts - 1));
        dmg_box(b, v3(x, 0.5f * h, 0.08f), v3(0.06f, 0.95f * h, 0.02f));
    }
}

/* Four legs that lean inwards, with rungs between them. */
static void draw_tower(dmg_builder* b) {
    const int floors = dmg_int(b, 2, 6);
    const float h = dmg_range(b, 1.0f, 3.0f), foot = dmg_range(b, 0.3f, 0.8f), head = foot * dmg_range(b, 0.2f, 0.9f);
    for (int i = 0; i < 4; ++i) {
        const float x = i == 0 || i == 3 ? -0.5f : 0.5f, z = i < 2 ? -0.5f : 0.5f, across = i < 2 ? -x : x;
        dmg_beam(b, v3(x * foot, 0, z * foot), v3(x * head, h, z * head), 0.05f, 0.05f);
        for (int f = 1; f <= floors; ++f) {
            const float share = (float)f / (float)(floors + 1), wide = foot + (head - foot) * share;
            const dmg_vec from = v3(x * wide, h * share, z * wide);
            const dmg_vec to =
                v3(i % 2 ? x * wide : across * wide * (i < 2 ? 1.0f : -1.0f), h * share, i % 2 ? -z * wide : z * wide);
            dmg_beam(b, from, to, 0.03f, 0.03f);
        }
    }
    dmg_box(b, v3(0, h, 0), v3(1.4f * head, 0.06f, 1.4f * head));
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, h, 0), v3(0, 1.3f * h, 0), 0.02f);
}

static void draw_barrel(dmg_builder* b) {
    const float r = dmg_range(b, 0.2f, 0.35f), h = r * dmg_range(b, 2.0f, 3.2f), belly = r * dmg_range(b, 1.0f, 1.2f);
    const dmg_xy profile[] = {{0, 0}, {r, 0}, {belly, 0.5f * h}, {r, h}, {0, h}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 5);
    for (int i = 0; i < 3; ++i)
        dmg_torus(b, v3(0, h * (0.1f + 0.4f * (float)i), 0), v3(0, 1, 0), i == 1 ? belly : 1.02f * r, 0.02f);
}

/* Barrels and crates side by side. */
static void draw_freight(dmg_builder* b) {
    for (int left = dmg_int(b, 1, 6); left > 0; --left) {
        dmg_save(b);
        const float z = dmg_range(b, -0.4f, 0.4f);
        dmg_move(b, 0.8f * (float)left, 0, z);
        if (dmg_chance(b, 0.5f)) {
            draw_barrel(b);
        } else {
            const float s = dmg_range(b, 0.3f, 0.7f);
            dmg_box(b, v3(0, 0.5f * s, 0), v3(s, s, s));
            for (int i = 0; i < 4; ++i)
                dmg_box(b, v3((i & 1 ? 0.45f : -0.45f) * s, 0.5f * s, (i & 2 ? 0.5f : -0.5f) * s),
                        v3(0.1f * s, 1.02f * s, 0.05f * s));
        }
        dmg_restore(b);
    }
}

/* A pedestal of slabs with a column, an obelisk, a ball or a basin on it. */
static void draw_monument(dmg_builder* b) {
    float y = 0.0f, w = dmg_range(b, 0.8f, 1.6f);
    for (int left = dmg_int(b, 1, 4); left > 0; --left) {
        const float h = dmg_range(b, 0.08f, 0.3f);
        dmg_box(b, v3(0, y + 0.5f * h, 0), v3(w, h, w));
        y += h;
        w *= dmg_range(b, 0.7f, 0.95f);
    }
    const float r = 0.35f * w, tall = dmg_range(b, 0.5f, 2.0f);
    const dmg_xy basin[] = {{0, 0},       {0.5f * r, 0}, {r, 0.4f * r}, {0.9f * r, 0.4f * r}, {0.4f * r, 0.1f * r},
                            {0, 0.1f * r}};
    dmg_cone(b, v3(0, y, 0), v3(0, y + tall, 0), r, r * dmg_range(b, 0.3f, 0.9f));
    if (dmg_chance(b, 0.5f)) dmg_lathe(b, v3(0, y + tall, 0), v3(0, 1, 0), basin, 6);
    if (dmg_chance(b, 0.5f)) dmg_ellipsoid(b, v3(0, y + tall + 0.7f * r, 0), v3(0.6f * r, 0.6f * r, 0.6f * r));
}

static void draw_wall(dmg_builder* b) {
    const int rows = dmg_int(b, 2, 6), columns = dmg_int(b, 2, 7);
    const float w = dmg_range(b, 0.25f, 0.5f), h = dmg_range(b, 0.12f, 0.25f);
    for (int i = 0; i < rows * columns; ++i) {
        const float x = w * ((float)(i % columns) + (i / columns % 2 ? 0.5f : 0.0f)),
                    y = h * ((float)(i / columns) + 0.5f);
        dmg_box(b, v3(x, y, 0), v3(0.97f * w, 0.97f * h, 0.5f * w));
    }
}

/* A post with an arm, a sign or a lamp. */
static void draw_post(dmg_builder* b) {
    const float h = dmg_range(b, 1.5f, 4.0f), r = dmg_range(b, 0.02f, 0.06f), arm = dmg_range(b, 0.3f, 0.9f);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.15f, 0), 4.0f * r, 2.0f * r);
    dmg_rod(b, v3(0, 0, 0), v3(0, h, 0), r);
    if (dmg_chance(b, 0.5f)) {
        dmg_beam(b, v3(0, h, 0), v3(arm, h, 0), 1.2f * r, 1.2f * r);
        dmg_cone(b, v3(arm, h, 0), v3(arm, h - 0.15f, 0), 0.04f, 0.14f);
    } else {
        dmg_box(b, v3(0, 0.9f * h, 1.2f * r), v3(arm, 0.6f * arm, 0.02f));
    }
    if (dmg_chance(b, 0.4f)) dmg_ellipsoid(b, v3(0, h, 0), v3(0.12f, 0.12f, 0.12f));
}

/* Trees and rocks. */
static void draw_nature(dmg_builder* b) {
    for (int left = dmg_int(b, 1, 4); left > 0; --left) {
        dmg_save(b);
        const float z = dmg_range(b, -0.5f, 0.5f), r = dmg_range(b, 0.2f, 0.6f), h = dmg_range(b, 0.6f, 1.8f);
        dmg_move(b, 1.1f * (float)left, 0, z);
        if (dmg_chance(b, 0.5f)) {
            dmg_cone(b, v3(0, 0, 0), v3(0, h, 0), 0.15f * r + 0.03f, 0.1f * r);
            for (int i = 0; i < 3; ++i)
                dmg_cone(b, v3(0, h * (0.5f + 0.3f * (float)i), 0), v3(0, h * (1.0f + 0.3f * (float)i), 0),
                         r * (1.0f - 0.25f * (float)i), 0);
        } else {
            dmg_ellipsoid(b, v3(0, 0.3f * r, 0), v3(r, 0.6f * r, 0.8f * r));
        }
        dmg_restore(b);
    }
}

void dmg_draw_scene(dmg_builder* b) {
    static void (*const kinds[])(dmg_builder*) = {draw_shelf,   draw_table,    draw_stairs, draw_fence, draw_tower,
                                                  draw_freight, draw_monument, draw_wall,   draw_post,  draw_nature};
    b->vertex_count = b->face_count = b->piece_count = b->part_count = 0;
    dmg_use(b, 0);
    kinds[dmg_int(b, 0, (int)(sizeof kinds / sizeof *kinds) - 1)](b);
}
