/* Draws openers: corkscrews with wings, with one long lever, of waiters; tin openers held in the hand or on the
 * wall. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws the worm of a corkscrew along -Y from the origin. */
static void draw_worm(dmg_builder* b, float length, float radius, float t) {
    enum { POINTS = 41 };
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float share = (float)i / (POINTS - 1), angle = 10 * DMG_PI * share,
              out = radius * fminf(1.0f, 8.0f * fminf(share, 1.02f - share));
        path[i] = v3(out * cosf(angle), -length * share, out * sinf(angle));
    }
    dmg_sweep(b, path, POINTS, t, t, false);
}

/* ---- corkscrew ---- */

/* Draws one arm, hanging from its gear at the origin to the side +X of the frame. */
static void draw_wing(dmg_builder* b, float length, float t, int kind) {
    float lean = 0.25f * length;
    dmg_rod(b, v3(0, 0, -t), v3(0, 0, t), 2 * t);
    for (int i = 0; i < 5; ++i) { /* teeth towards the rack */
        float angle = DMG_PI * (0.7f + 0.15f * (float)i);
        dmg_box(b, v3(2 * t * cosf(angle), 2 * t * sinf(angle), 0), v3(0.8f * t, 0.8f * t, 1.8f * t));
    }
    if (kind == 0) dmg_beam(b, v3(0, 0, 0), v3(lean, -length, 0), 2 * t, 2.4f * t);
    if (kind == 1) {
        dmg_rod(b, v3(0, 0, 0), v3(lean, -0.7f * length, 0), t);
        dmg_ellipsoid(b, v3(1.1f * lean, -0.85f * length, 0), v3(3 * t, 0.2f * length, 1.5f * t));
    }
    if (kind == 2) {
        const dmg_vec path[] = {v3(0, 0, 0), v3(0.8f * lean, -0.3f * length, 0), v3(0.9f * lean, -0.7f * length, 0),
                                v3(1.8f * lean, -length, 0)};
        dmg_sweep(b, path, 4, 1.2f * t, t, false);
    }
}

/* Draws what the hand turns: a loop, a bar, a butterfly. */
static void draw_cork_handle(dmg_builder* b, float y, float size) {
    int kind = dmg_int(b, 0, 2);
    dmg_rod(b, v3(0, y, 0), v3(0, y + 0.6f * size, 0), 0.25f * size);
    if (kind == 0) dmg_torus(b, v3(0, y + 1.3f * size, 0), v3(0, 0, 1), 0.8f * size, 0.22f * size);
    if (kind == 1)
        dmg_capsule(b, v3(-1.6f * size, y + 0.8f * size, 0), v3(1.6f * size, y + 0.8f * size, 0), 0.35f * size);
    for (int s = -1; s <= 1 && kind == 2; s += 2)
        dmg_ellipsoid(b, v3((float)s * size, y + 0.9f * size, 0), v3(0.9f * size, 0.6f * size, 0.25f * size));
}

/* Draws a bell on the bottle's neck, a rack that both wings drive, the worm turning in it. */
static void draw_winged(dmg_builder* b) {
    float high = dmg_range(b, 0.08f, 0.12f), t = high * dmg_range(b, 0.035f, 0.055f),
          bell = high * dmg_range(b, 0.16f, 0.22f), length = high * dmg_range(b, 0.7f, 0.95f),
          far = dmg_range(b, 1.5f, 2.3f), way = high * dmg_range(b, 0.3f, 0.55f), rest = dmg_unit(b),
          size = high * dmg_range(b, 0.14f, 0.2f);
    int kind = dmg_int(b, 0, 2);
    const dmg_xy shell[] = {{bell, 0},
                            {bell, 0.2f * high},
                            {0.6f * bell, 0.35f * high},
                            {0.5f * bell, 0.35f * high},
                            {0.85f * bell, 0.18f * high},
                            {0.85f * bell, 0},
                            {bell, 0}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), shell, 7);
    for (int s = -1; s <= 1; s += 2) {
        float z = 1.6f * (float)s * t;
        dmg_box_span(b, v3(-1.5f * t, 0.3f * high, z - 0.4f * t), v3(1.5f * t, 0.9f * high, z + 0.4f * t));
        dmg_box_span(b, v3(-4.4f * t, 0.82f * high, z - 0.5f * t), v3(4.4f * t, high, z + 0.5f * t));
        dmg_rod(b, v3((float)s * 3.6f * t, 0.92f * high, -2.3f * t), v3((float)s * 3.6f * t, 0.92f * high, 2.3f * t),
                0.6f * t);
    }
    uint32_t rack = dmg_slide(b, 0, "rack", v3(0, 1, 0), 0.0f, way);
    for (int i = 0; i < 6; ++i) /* rings for teeth */
        dmg_rod(b, v3(0, high * (0.86f + 0.03f * (float)i), 0), v3(0, high * (0.875f + 0.03f * (float)i), 0),
                1.15f * t);
    dmg_rod(b, v3(0, 0.6f * high, 0), v3(0, 1.08f * high, 0), 0.8f * t);
    dmg_spin(b, rack, "handle", v3(0, 0, 0), v3(0, 1, 0));
    draw_cork_handle(b, 1.081f * high, size);
    dmg_move(b, 0, 0.59f * high, 0);
    draw_worm(b, 0.55f * high, 0.6f * t + 0.02f * high, 0.3f * t);
    dmg_move(b, 0, -0.59f * high, 0);
    dmg_rest(b, rack, rest * way);
    for (int s = 0; s < 2; ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 3.6f * t, 0.92f * high, 0);
        uint32_t wing = dmg_hinge(b, 0, "wing", v3(0, 0, 0), v3(0, 0, 1), 0.0f, far);
        dmg_rest(b, wing, rest * far);
        draw_wing(b, length, t, kind);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Jaws that grip the neck and a long lever over them that drives the worm. */
static void draw_lever_corkscrew(dmg_builder* b) {
    float high = dmg_range(b, 0.13f, 0.18f), t = high * dmg_range(b, 0.07f, 0.1f),
          reach = high * dmg_range(b, 0.9f, 1.3f), far = dmg_range(b, 1.5f, 2.6f),
          lean = dmg_range(b, 0.0f, 0.3f) * reach;
    const dmg_xy barrel[] = {{0.85f * t, 0.3f * high}, {1.6f * t, 0.3f * high}, {1.6f * t, 0.42f * high},
                             {1.1f * t, 0.42f * high}, {1.1f * t, 0.8f * high}, {0.85f * t, 0.8f * high},
                             {0.85f * t, 0.3f * high}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), barrel, 7);
    for (int s = -1; s <= 1; s += 2) /* cheeks for the lever's pin */
        dmg_box(b, v3(0.9f * (float)s * t, 0.85f * high, 0), v3(0.4f * t, 0.25f * high, 1.6f * t));
    uint32_t worm = dmg_slide(b, 0, "worm", v3(0, 1, 0), 0.0f, 0.3f * high);
    dmg_rod(b, v3(0, 0.28f * high, 0), v3(0, 0.34f * high, 0), 0.4f * t);
    dmg_save(b);
    dmg_move(b, 0, 0.285f * high, 0);
    draw_worm(b, 0.28f * high, 0.4f * t, 0.12f * t);
    dmg_restore(b);
    dmg_rest(b, worm, dmg_chance(b, 0.5f) ? 0.0f : 0.3f * high);
    dmg_hinge(b, 0, "lever", v3(0, 0.9f * high, 0), v3(1, 0, 0), -0.05f, far);
    dmg_rod(b, v3(-1.4f * t, 0.9f * high, 0), v3(1.4f * t, 0.9f * high, 0), 0.35f * t);
    dmg_beam(b, v3(0, 0.88f * high, 0), v3(0, 0.9f * high + 0.6f * reach, -lean), 1.2f * t, 0.9f * t);
    dmg_capsule(b, v3(0, 0.9f * high + 0.5f * reach, -0.8f * lean), v3(0, 0.9f * high + reach, -1.2f * lean), 0.8f * t);
    for (int s = -1; s <= 1; s += 2) { /* the grips beside the neck, squeezed round it */
        float x = (float)s * 1.7f * t;
        dmg_hinge(b, 0, "grip", v3(x, 0.4f * high, 0), v3(0, 0, (float)s), 0.0f, 0.5f);
        dmg_box_span(b, v3(x - 0.4f * t, 0, -t), v3(x + 0.4f * t, 0.45f * high, t));
        dmg_rounded_box(b, v3(x + 0.5f * (float)s * t, 0.15f * high, 0), v3(t, 0.3f * high, 1.6f * t), 0.3f * t);
    }
    dmg_use(b, 0);
}

/* Draws a pocket tool: worm, blade and the lever that rests on the bottle's rim fold out of its handle. */
static void draw_waiter(dmg_builder* b) {
    float l = dmg_range(b, 0.1f, 0.13f), h = l * dmg_range(b, 0.09f, 0.13f), t = 0.02f * l, half = 2.2f * t,
          worm_rest = dmg_range(b, 0.0f, 1.7f), lever_rest = dmg_range(b, 0.0f, 2.6f),
          knife_rest = dmg_range(b, 0.0f, 3.0f);
    float at = l * dmg_range(b, 0.35f, 0.55f), bow = l * dmg_range(b, 0.0f, 0.06f);
    const dmg_xy side[] = {{0, 0}, {0.5f * l, bow}, {l, 0}, {l, h}, {0.5f * l, h + bow}, {0, h}};
    dmg_move(b, 0, 0.02f, 0);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    for (int s = -1; s <= 1; s += 2) dmg_extrude(b, side, 6, (float)s * half - 0.5f * t, (float)s * half + 0.5f * t);
    dmg_box_span(b, v3(0.1f * l, 0.75f * h + bow * 0.3f, -half), v3(0.9f * l, h, half)); /* the back */
    const dmg_vec pins[] = {{0.03f * l, 0.4f * h, 0}, {at, 0.3f * h + bow, 0}, {0.97f * l, 0.4f * h, 0}};
    for (int i = 0; i < 3; ++i)
        dmg_rod(b, v3_add(pins[i], v3(0, 0, -half - t)), v3_add(pins[i], v3(0, 0, half + t)), 0.8f * t);
    uint32_t worm = dmg_hinge(b, 0, "worm", pins[1], v3(0, 0, -1), 0.0f, 1.8f);
    dmg_rod(b, v3_add(pins[1], v3(0, 0, -0.7f * half)), v3_add(pins[1], v3(0, 0, 0.7f * half)), 1.6f * t);
    dmg_save(b);
    dmg_move(b, pins[1].x, pins[1].y, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    draw_worm(b, fminf(0.42f * l, 0.93f * l - at), 0.7f * half, 0.45f * t);
    dmg_restore(b);
    uint32_t lever = dmg_hinge(b, 0, "lever", pins[0], v3(0, 0, -1), 0.0f, 2.8f);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3_add(pins[0], v3(0, 0, (float)s * (half + 1.2f * t))),
                 v3(0.6f * l, -0.1f * h, (float)s * (half + 1.2f * t)), t, 0.4f * h);
    dmg_box_span(b, v3(0.56f * l, -0.4f * h, -half - 1.7f * t), v3(0.62f * l, 0.02f * h - t, half + 1.7f * t));
    uint32_t knife = dmg_hinge(b, 0, "blade", pins[2], v3(0, 0, 1), 0.0f, 3.1f);
    const dmg_xy blade[] = {{at + 0.12f * l, -0.1f * h},
                            {0.95f * l, -0.1f * h},
                            {0.99f * l, 0.4f * h},
                            {0.95f * l, 0.6f * h},
                            {at + 0.15f * l, 0.4f * h}};
    dmg_extrude(b, blade, 5, -0.9f * half, -0.9f * half + 0.3f * t);
    dmg_rest(b, worm, worm_rest);
    dmg_rest(b, lever, dmg_chance(b, 0.4f) ? 0.0f : lever_rest);
    dmg_rest(b, knife, dmg_chance(b, 0.4f) ? 0.0f : knife_rest);
    dmg_use(b, 0);
}

void dmg_build_corkscrew(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 1.5f, 2}, 3);
    if (kind == 0) draw_winged(b);
    if (kind == 1) draw_lever_corkscrew(b);
    if (kind == 2) draw_waiter(b);
}

/* ---- tin opener ---- */

/* Draws a key on the shaft along +Z: two wings, a bar or a crank with a knob. */
static void draw_opener_key(dmg_builder* b, uint32_t parent, dmg_vec at, float size) {
    int kind = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    uint32_t key = dmg_spin(b, parent, "key", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, size), 0.15f * size);
    if (kind == 0) dmg_rounded_box(b, v3(0, 0, 1.2f * size), v3(2.4f * size, 0.7f * size, 0.4f * size), 0.15f * size);
    for (int s = -1; s <= 1 && kind == 1; s += 2)
        dmg_ellipsoid(b, v3(0.7f * (float)s * size, 0, 1.2f * size), v3(0.7f * size, 0.5f * size, 0.12f * size));
    if (kind == 2) {
        float arm = size * dmg_range(b, 1.5f, 3.0f);
        dmg_beam(b, v3(-0.2f * size, 0, 0.9f * size), v3(arm + 0.2f * size, 0, 0.9f * size), 0.2f * size, 0.5f * size);
        if (dmg_chance(b, 0.5f)) dmg_spin(b, key, "knob", v3(arm, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(arm, 0, 1.01f * size), v3(arm, 0, 1.9f * size), 0.28f * size);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws two handles about a pin; the wheel below one bites into the tin, the key turns the cog on the other. */
static void draw_hand_opener(dmg_builder* b) {
    float l = dmg_range(b, 0.15f, 0.2f), t = l * dmg_range(b, 0.02f, 0.035f), spread = l * dmg_range(b, 0.03f, 0.08f),
          swing = dmg_range(b, 0.3f, 0.9f), size = l * dmg_range(b, 0.08f, 0.14f);
    bool round = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0.1f, 0);
    for (int s = -1; s <= 1; s += 2) {
        float y = (float)s, z = 0.55f * y * t;
        dmg_vec mid = v3(0.3f * l, y * (0.5f * spread + t), z), end = v3(l, y * (spread + t), z);
        if (s > 0) {
            uint32_t upper = dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 0, 1), 0.0f, swing);
            dmg_rest(b, upper, dmg_chance(b, 0.5f) ? 0.0f : swing * dmg_unit(b));
        }
        dmg_rod(b, v3(0, 0, z - 0.5f * t), v3(0, 0, z + 0.5f * t), 3 * t);
        dmg_beam(b, v3(0, 0, z), mid, t, 3 * t);
        if (round)
            dmg_capsule(b, mid, end, 1.5f * t);
        else
            dmg_beam(b, mid, end, 2.5f * t, 2.5f * t);
        dmg_rod(b, v3(-1.6f * t, 3.2f * y * t, z - 0.5f * t), v3(-1.6f * t, 3.2f * y * t, z + 1.1f * t),
                1.8f * t); /* cog, cutter */
    }
    dmg_use(b, 0);
    draw_opener_key(b, 0, v3(-0.02f * l, -0.01f * l, 1.1f * t), size);
}

/* Draws a post on the counter or a plate on the wall: the arm with the wheel goes up, the crank or a motor turns the
 * tin. */
static void draw_stand_opener(dmg_builder* b, bool wall) {
    float high = dmg_range(b, 0.18f, 0.25f), w = high * dmg_range(b, 0.4f, 0.6f),
          d = wall ? 0.12f * high : high * dmg_range(b, 0.4f, 0.6f), t = 0.04f * high, swing = dmg_range(b, 0.4f, 1.3f),
          y = 0.78f * high, side = dmg_sign(b);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * w, 0, -d), v3(0.5f * w, high, 0));
    else
        dmg_rounded_box(b, v3(0, 0.5f * high, -0.5f * d), v3(w, high, d), 0.2f * fminf(w, d));
    dmg_rod(b, v3(0, 0.68f * high, -0.2f * d), v3(0, 0.68f * high, 1.5f * t), 1.2f * t);
    if (wall) dmg_rod(b, v3(0, 0.4f * high, 0), v3(0, 0.4f * high, 2 * t), 1.5f * t);
    if (wall) draw_opener_key(b, 0, v3(0, 0.4f * high, 1.9f * t), 0.18f * high);
    float x = -side * 0.35f * w;
    dmg_rod(b, v3(x, y, -0.2f * d), v3(x, y, 0.5f * t), 0.8f * t);
    uint32_t arm = dmg_hinge(b, 0, "arm", v3(x, y, 0), v3(0, 0, side), 0.0f, swing);
    dmg_beam(b, v3(x - side * t, y, 1.2f * t), v3(-1.8f * x, y, 1.2f * t), t, 2 * t);
    dmg_rounded_box(b, v3(side * 0.55f * w, y, 1.3f * t), v3(0.3f * w, 2.4f * t, 2 * t), 0.4f * t);
    dmg_rod(b, v3(0, y - 0.8f * t, 1.8f * t), v3(0, y - 0.8f * t, 2.4f * t), 1.3f * t);
    if (dmg_chance(b, 0.6f)) { /* the magnet that holds the lid */
        dmg_hinge(b, arm, "magnet", v3(0, y, 2.5f * t), v3(1, 0, 0), -0.3f, 0.9f);
        dmg_box_span(b, v3(-0.4f * t, y - 0.3f * t, 2.5f * t), v3(0.4f * t, y + 0.3f * t, 5 * t));
        dmg_rod(b, v3(0, y - 1.4f * t, 5 * t), v3(0, y + 0.2f * t, 5 * t), t);
    }
    dmg_use(b, 0);
    if (wall || dmg_chance(b, 0.4f)) return;
    dmg_buttons key = {"button", 1, 1, w, w, 0.3f * w, 0.3f * w, t, 0.4f * t, 2};
    dmg_move(b, 0, high, -0.5f * d);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_buttons_draw(b, 0, &key);
}

void dmg_build_can_opener(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 1.5f, 1.5f}, 3);
    if (kind == 0)
        draw_hand_opener(b);
    else
        draw_stand_opener(b, kind == 2);
}
