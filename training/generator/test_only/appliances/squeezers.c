/* Draws small tools of two levers about one pin: garlic and lemon presses, nutcrackers, tongs, punches, ice-cream
 * scoops. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- two levers on a pin: they run along +X from the pin, which lies along Z; the upper one moves ---- */

typedef struct squeeze {
    float length, wide, t; /* wide: along the pin */
    float gap, spread;     /* between the levers at the pin and at their ends */
    float bow;
    int arm;
} squeeze;

static squeeze pick_squeeze(dmg_builder* b, float length) {
    squeeze s = {.length = length * dmg_scale_range(b, 0.8f, 1.25f)};
    s.wide = s.length * dmg_range(b, 0.06f, 0.12f);
    s.t = s.length * dmg_range(b, 0.018f, 0.035f);
    s.gap = s.length * dmg_range(b, 0.02f, 0.04f);
    s.spread = s.length * dmg_range(b, 0.05f, 0.16f);
    s.bow = s.length * dmg_range(b, -0.01f, 0.05f);
    s.arm = dmg_int(b, 0, 4);
    return s;
}

/* Draws one arm from x0 to the end, on the side y > 0 or y < 0: flat, round, bowed, a channel or a loop of wire. */
static void draw_squeeze_arm(dmg_builder* b, const squeeze* s, float side, float x0) {
    dmg_vec from = v3(x0, side * 0.5f * (s->gap + s->t), 0), to = v3(s->length, side * 0.5f * (s->spread + s->t), 0);
    dmg_vec out = v3(0, side * s->bow, 0), half = v3(0, 0, 0.5f * s->wide);
    if (s->arm == 0) dmg_beam(b, from, to, s->wide, s->t);
    if (s->arm == 1) {
        dmg_rod(b, from, v3_lerp(from, to, 0.5f), 0.8f * s->t);
        dmg_capsule(b, v3_lerp(from, to, 0.4f), to, 1.1f * s->t);
    }
    if (s->arm == 2) {
        dmg_vec path[7];
        for (int i = 0; i < 7; ++i)
            path[i] = v3_mad(v3_lerp(from, to, (float)i / 6.0f), out, sinf(DMG_PI * (float)i / 6.0f));
        dmg_sweep(b, path, 7, 0.6f * s->t, 0.5f * s->wide, false);
    }
    if (s->arm == 3) {
        dmg_vec rim = v3(0, side * 0.7f * s->t, 0);
        dmg_beam(b, from, to, s->wide, 0.4f * s->t);
        for (int k = -1; k <= 1; k += 2) {
            dmg_vec edge = v3_mad(rim, half, 0.9f * (float)k);
            dmg_beam(b, v3_add(from, edge), v3_add(to, edge), 0.1f * s->wide, 1.4f * s->t);
        }
    }
    if (s->arm == 4) {
        dmg_vec round = v3_mad(to, v3_normalize(v3_sub(to, from)), 0.3f * s->wide);
        const dmg_vec path[] = {v3_sub(from, half), v3_sub(to, half), round, v3_add(to, half), v3_add(from, half)};
        dmg_sweep(b, path, 5, 0.5f * s->t, 0.5f * s->t, false);
        dmg_box(b, v3_lerp(from, to, 0.03f), v3(1.5f * s->t, s->t, 1.2f * s->wide));
    }
}

/* Ears of the lower lever, the pin through the upper one. */
static uint32_t begin_upper(dmg_builder* b, const squeeze* s, float swing) {
    float r = 0.5f * (s->gap + 2 * s->t), half = 0.5f * s->wide;
    for (int k = -1; k <= 1; k += 2) {
        float z = (float)k * (half + 0.6f * s->t);
        dmg_box_span(b, v3(-r, -0.5f * s->gap - s->t, z - 0.4f * s->t), v3(1.3f * r, 0.5f * r, z + 0.4f * s->t));
    }
    dmg_rod(b, v3(0, 0, -half - 1.3f * s->t), v3(0, 0, half + 1.3f * s->t), 0.4f * r);
    dmg_box_span(b, v3(-r, -0.5f * s->gap - s->t, -half - s->t), v3(1.3f * r, -0.5f * s->gap, half + s->t));
    uint32_t upper = dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(0, 0, 1), 0.0f, swing);
    dmg_rod(b, v3(0, 0, -0.95f * half), v3(0, 0, 0.95f * half), 0.8f * r);
    dmg_box_span(b, v3(-0.5f * r, 0, -0.9f * half), v3(1.3f * r, 0.5f * s->gap + s->t, 0.9f * half));
    return upper;
}

/* Draws a sieve pot below, a stamp above; a cleaning comb sometimes hangs on the far side. */
static void draw_garlic_press(dmg_builder* b) {
    squeeze s = pick_squeeze(b, 0.17f);
    float r = s.length * dmg_range(b, 0.07f, 0.1f), deep = r * dmg_range(b, 1.2f, 2.0f), x = 1.6f * r + s.gap;
    bool square = dmg_chance(b, 0.5f), insert = dmg_chance(b, 0.3f);
    draw_squeeze_arm(b, &s, -1, x + 0.7f * r);
    dmg_beam(b, v3(0.5f * s.gap, -0.5f * (s.gap + s.t), 0), v3(x - 0.7f * r, -0.5f * (s.gap + s.t), 0), s.wide, s.t);
    float rim = -0.5f * s.gap;
    if (square) {
        dmg_save(b);
        dmg_move(b, x, rim, 0);
        dmg_face_up(b);
        dmg_case_draw(b, DMG_CASE_BOARDS, 2.6f * r, 2 * r, deep, 0.15f * r);
        dmg_restore(b);
    } else {
        const dmg_xy cup[] = {{0, -deep},       {r, -deep}, {r, 0}, {0.87f * r, 0}, {0.87f * r, -0.9f * deep},
                              {0, -0.9f * deep}};
        dmg_lathe(b, v3(x, rim, 0), v3(0, 1, 0), cup, 6);
    }
    uint32_t upper = begin_upper(b, &s, dmg_range(b, 1.2f, 2.6f));
    draw_squeeze_arm(b, &s, 1, 0.6f * s.gap);
    float low = rim - 0.7f * deep;
    if (square)
        dmg_box_span(b, v3(x - r, low, -0.7f * r), v3(x + r, s.gap, 0.7f * r));
    else
        dmg_rod(b, v3(x, low, 0), v3(x, s.gap, 0), 0.75f * r);
    dmg_rest(b, upper, dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.2f, 1.1f));
    dmg_use(b, 0);
    if (insert) { /* the sieve swings out below */
        dmg_hinge(b, 0, "sieve", v3(0, -0.5f * s.gap - s.t, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 0.6f, 2.0f));
        dmg_box_span(b, v3(0, rim - deep - 1.2f * s.t, -0.6f * r), v3(x + r, rim - deep - 0.2f * s.t, 0.6f * r));
        dmg_box_span(b, v3(-0.6f * s.t, rim - deep - s.t, -0.3f * r),
                     v3(0.6f * s.t, -0.5f * s.gap - 0.5f * s.t, 0.3f * r));
        dmg_use(b, 0);
    }
}

/* Draws a bowl in a bowl, beyond which the pin lies or before it. */
static void draw_lemon_press(dmg_builder* b) {
    squeeze s = pick_squeeze(b, 0.2f);
    float r = s.length * dmg_range(b, 0.15f, 0.2f), x = r + 1.4f * s.gap, flat = dmg_range(b, 0.6f, 1.0f);
    s.gap = 0.05f * s.length;
    const dmg_xy cup[] = {
        {0, -r * flat}, {0.5f * r, -0.87f * r * flat}, {0.87f * r, -0.5f * r * flat}, {r, 0},
        {0.94f * r, 0}, {0.8f * r, -0.45f * r * flat}, {0.45f * r, -0.8f * r * flat}, {0, -0.92f * r * flat}};
    const dmg_xy stamp[] = {{0, -0.8f * r * flat}, {0.4f * r, -0.68f * r * flat}, {0.7f * r, -0.4f * r * flat},
                            {0.86f * r, 0.0f},     {1.05f * r, 0.05f * r},        {1.05f * r, 0.1f * r},
                            {0, 0.1f * r}};
    draw_squeeze_arm(b, &s, -1, x + 0.9f * r);
    dmg_box_span(b, v3(0, -0.5f * s.gap - s.t, -0.5f * s.wide), v3(x - 0.9f * r, -0.5f * s.gap, 0.5f * s.wide));
    dmg_lathe(b, v3(x, -0.4f * s.gap, 0), v3(0, 1, 0), cup, 8);
    uint32_t upper = begin_upper(b, &s, dmg_range(b, 1.2f, 2.6f));
    draw_squeeze_arm(b, &s, 1, x + 0.9f * r);
    dmg_box_span(b, v3(0, 0.1f * s.gap, -0.4f * s.wide), v3(x - 0.9f * r, 0.5f * s.gap + s.t, 0.4f * s.wide));
    dmg_lathe(b, v3(x, -0.2f * s.gap, 0), v3(0, 1, 0), stamp, 7);
    dmg_rest(b, upper, dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

/* Arms with teeth near the pin, one size of nut behind the other; or tongs with shells at the ends. */
static void draw_cracker(dmg_builder* b, bool tongs) {
    squeeze s = pick_squeeze(b, tongs ? 0.28f : 0.16f);
    int teeth = dmg_int(b, 3, 7), ends = dmg_int(b, 0, 2);
    float swing = tongs ? dmg_range(b, 0.25f, 0.6f) : dmg_range(b, 0.5f, 1.5f),
          r = s.length * dmg_range(b, 0.05f, 0.09f);
    s.spread = fmaxf(s.spread, 2.2f * r);
    uint32_t upper = 0;
    for (int side = -1; side <= 1; side += 2) {
        float y = (float)side, tip = y * 0.5f * (s.spread + s.t);
        if (side > 0) upper = begin_upper(b, &s, swing);
        draw_squeeze_arm(b, &s, y, 0.6f * s.gap);
        for (int i = 0; i < teeth && !tongs; ++i) {
            float x = s.length * (0.1f + 0.04f * (float)i), in = 0.5f * (s.gap + (s.spread - s.gap) * x / s.length);
            dmg_box(b, v3(x, 0.85f * y * in, 0), v3(0.02f * s.length, 0.4f * in, 0.9f * s.wide));
        }
        if (!tongs) continue;
        if (ends == 0) dmg_ellipsoid(b, v3(s.length + r, tip * 0.6f, 0), v3(1.6f * r, 0.4f * r, r));
        if (ends == 1)
            dmg_box_span(b, v3(s.length - r, fminf(tip, 0.3f * tip), -r), v3(s.length, fmaxf(tip, 0.3f * tip), r));
        if (ends == 2) dmg_beam(b, v3(s.length, tip, 0), v3(s.length + 2.5f * r, 0.2f * tip, 0), 2.2f * r, 0.2f * r);
    }
    dmg_rest(b, upper, swing * dmg_range(b, 0.0f, 1.0f));
    dmg_use(b, 0);
    if (tongs && dmg_chance(b, 0.5f)) { /* a ring pulled at the end to lock them */
        dmg_slide(b, 0, "lock", v3(-1, 0, 0), 0.0f, 0.04f * s.length);
        dmg_rod(b, v3(-0.12f * s.length, 0, 0), v3(0, -0.1f * s.gap, 0), 0.25f * s.gap);
        dmg_torus(b, v3(-0.14f * s.length, 0, 0), v3(0, 0, 1), 0.025f * s.length, 0.006f * s.length);
        dmg_use(b, 0);
    }
}

/* Draws a lever that crosses the other at the pin: its jaw on -X above, its handle on +X below. */
static void draw_cross_lever(dmg_builder* b, const squeeze* s, float side, float jaw, int tip, float z) {
    dmg_vec from = v3(-jaw, side * (0.5f * s->gap + 0.5f * s->t), z), to = v3(s->length, -side * s->spread, z);
    dmg_vec neck = v3(0.25f * s->length, -side * 0.45f * s->spread, z), ring = v3(s->length + 1.2f * s->wide, to.y, z);
    dmg_rod(b, v3(0, 0, z - 0.5f * s->t), v3(0, 0, z + 0.5f * s->t), 1.6f * s->t);
    dmg_beam(b, from, v3(0, 0, z), s->t, 1.6f * s->t);
    dmg_beam(b, v3(0, 0, z), neck, s->t, 1.8f * s->t);
    if (s->arm == 4) {
        dmg_beam(b, neck, to, s->t, s->t);
        dmg_torus(b, ring, v3(0, 0, 1), 1.2f * s->wide, 0.5f * s->t);
    } else {
        dmg_capsule(b, neck, to, (s->arm & 1 ? 1.0f : 1.4f) * s->t);
    }
    dmg_vec head = v3(-jaw, from.y, 0);
    if (tip == 0) dmg_box(b, head, v3(0.25f * jaw, 0.9f * s->t, 2.5f * s->t));
    if (tip == 1) dmg_ellipsoid(b, v3(-1.2f * jaw, head.y + side * s->t, 0), v3(0.4f * jaw, 0.8f * s->t, 0.3f * jaw));
    if (tip == 2) { /* a punch and the die below it */
        dmg_box(b, v3(-0.8f * jaw, side * (0.6f * s->gap + 0.6f * s->t), 0), v3(0.6f * jaw, 1.2f * s->t, 3 * s->t));
        dmg_rod(b, v3(-0.9f * jaw, side * 0.1f * s->gap, 0), v3(-0.9f * jaw, side * (s->gap + s->t), 0), 0.8f * s->t);
    }
}

static void draw_cross_levers(dmg_builder* b) {
    squeeze s = pick_squeeze(b, 0.12f);
    float jaw = s.length * dmg_range(b, 0.25f, 0.8f), swing = dmg_range(b, 0.3f, 0.8f);
    int tip = dmg_int(b, 0, 2);
    s.spread = s.length * dmg_range(b, 0.14f, 0.25f);
    draw_cross_lever(b, &s, -1, jaw, tip, -0.55f * s.t);
    dmg_rod(b, v3(0, 0, -1.3f * s.t), v3(0, 0, 1.3f * s.t), 0.6f * s.t);
    uint32_t upper = dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(0, 0, -1), 0.0f, swing);
    draw_cross_lever(b, &s, 1, jaw, tip, 0.55f * s.t);
    dmg_rest(b, upper, swing * dmg_unit(b));
    dmg_use(b, 0);
}

/* Draws a half ball on a handle; the thumb's lever turns a wire round in it. */
static void draw_scoop(dmg_builder* b) {
    float r = dmg_range(b, 0.022f, 0.034f), t = 0.06f * r, long_ = r * dmg_range(b, 4.5f, 7.0f),
          grip = r * dmg_range(b, 0.28f, 0.42f), far = dmg_range(b, 1.5f, 3.0f), press = dmg_range(b, 0.3f, 0.6f);
    dmg_xy shell[10], wire[5];
    for (int i = 0; i < 5; ++i) {
        float angle = 0.5f * DMG_PI * (float)i / 4.0f;
        shell[i] = (dmg_xy){i == 0 ? 0.0f : (r - t) * sinf(angle), (r - t) * cosf(angle)};
        shell[9 - i] = (dmg_xy){i == 0 ? 0.0f : r * sinf(angle), r * cosf(angle)};
        wire[i] = (dmg_xy){(r - 2 * t) * sinf(angle), (r - 2 * t) * cosf(angle)};
    }
    dmg_turn(b, v3(1, 0, 0), dmg_chance(b, 0.5f) ? DMG_PI : 0.0f);
    dmg_lathe(b, v3(0, 0, 0), v3(0, -1, 0),
              (const dmg_xy[]){{0, -r}, {0.2f * r, -r}, {0.2f * r, -0.9f * r}, {0, -0.9f * r}}, 4);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), shell, 10);
    dmg_rod(b, v3(0.9f * r, 0.4f * r, 0), v3(0.5f * long_, 0.4f * r, 0), 0.5f * grip);
    dmg_capsule(b, v3(0.45f * long_, 0.4f * r, 0), v3(long_, 0.4f * r, 0), grip);
    dmg_hinge(b, 0, "scraper", v3(0, 0, 0), v3(0, dmg_sign(b), 0), 0.0f, far);
    dmg_vec path[9];
    for (int i = 0; i < 9; ++i) {
        const dmg_xy* at = &wire[i < 4 ? 4 - i : i - 4];
        path[i] = v3(0, at->y, i < 4 ? -at->x : at->x);
    }
    dmg_sweep(b, path, 9, 0.5f * t, 2 * t, false);
    dmg_use(b, 0);
    float x = r * dmg_range(b, 1.3f, 1.9f), pad = x + r * dmg_range(b, 0.4f, 0.9f), y = 0.4f * r + grip;
    dmg_rod(b, v3(x, 0.4f * r, -0.4f * grip), v3(x, y + 2 * t, -0.4f * grip), 2 * t);
    dmg_hinge(b, 0, "thumb_lever", v3(x, y, -0.4f * grip), v3(0, 1, 0), 0.0f, press);
    dmg_box_span(b, v3(x - 0.6f * r, y, -0.4f * grip - t), v3(pad, y + t, 2 * t - 0.4f * grip));
    dmg_rounded_box(b, v3(pad, y + 1.2f * t, -0.8f * grip), v3(0.5f * r, 3 * t, 0.9f * grip), t);
    dmg_use(b, 0);
}

void dmg_build_hand_squeezer(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){2, 2, 2, 2, 2, 1.5f}, 6);
    dmg_move(b, 0, 0.05f, 0);
    if (dmg_chance(b, 0.4f)) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* lies on its side */
    if (kind == 0) draw_garlic_press(b);
    if (kind == 1) draw_lemon_press(b);
    if (kind == 2 || kind == 3) draw_cracker(b, kind == 3);
    if (kind == 4) draw_cross_levers(b);
    if (kind == 5) draw_scoop(b);
}
