/* Draws folding things of house and garden: ironing boards on crossed legs, on short legs or in the wall; parasols
 * with ribs, a runner, a tilt joint, a crank, a boom. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- ironing board ---- */

typedef struct ironing {
    float half, wide, high, t; /* half of the length along x; the top's upper face */
    float nose;                /* where the outline begins to narrow, share of the half */
} ironing;

/* The board's outline lies in x, z, its point towards +X. */
static void draw_board(dmg_builder* b, float half, float wide, float nose, float t) {
    const float tip = 0.25f * wide, straight = nose * half;
    const dmg_xy outline[] = {{-half, -0.4f * wide}, {-0.92f * half, -0.5f * wide}, {straight, -0.5f * wide},
                              {0.9f * half, -tip},   {half, -0.5f * tip},           {half, 0.5f * tip},
                              {0.9f * half, tip},    {straight, 0.5f * wide},       {-0.92f * half, 0.5f * wide},
                              {-half, 0.4f * wide}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_extrude(b, outline, 10, -t, 0);
    dmg_restore(b);
}

/* Draws a frame of two tubes and their bars from a line under the board at `from` to the floor at `to`. */
static void draw_iron_legs(dmg_builder* b, const ironing* g, float from, float to, float half, float r) {
    float top = g->high - g->t - 1.2f * r, foot = fmaxf(0.5f * g->wide, half);
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(from, top, (float)s * half), v3(to, r, (float)s * half), r);
    dmg_rod(b, v3(from, top, -half), v3(from, top, half), r);
    dmg_rod(b, v3(to, r, -foot), v3(to, r, foot), 1.1f * r);
}

/* Crossed legs, both folding up under the board; the rest for the iron is drawn out, a sleeve board swings. */
static void draw_crossed(dmg_builder* b, const ironing* g) {
    float r = dmg_range(b, 0.009f, 0.014f), far = g->half * dmg_range(b, 0.5f, 0.75f), under = g->high - g->t,
          fold = atan2f(under, 2 * far) * dmg_range(b, 0.85f, 0.97f), inner = 0.2f * g->wide, outer = inner + 2.6f * r;
    bool one = dmg_chance(b, 0.3f);
    draw_board(b, g->half, g->wide, g->nose, g->t);
    for (int s = -1; s <= 1; s += 2) /* the rails the legs hang in */
        dmg_box_span(b, v3(-1.1f * far, -g->t - 0.01f, (float)s * outer - 0.006f),
                     v3(1.1f * far, -g->t, (float)s * outer + 0.006f));
    dmg_move(b, 0, -g->high, 0);
    float y = under - 1.2f * r;
    if (!one) dmg_hinge(b, 0, "legs", v3(-far, y, 0), v3(0, 0, 1), 0.0f, fold);
    draw_iron_legs(b, g, -far, far, outer, r);
    dmg_use(b, 0);
    dmg_hinge(b, 0, "legs", v3(far, y, 0), v3(0, 0, -1), 0.0f, fold);
    draw_iron_legs(b, g, far, -far, inner, r);
    dmg_use(b, 0);
    dmg_move(b, 0, g->high, 0);
}

/* Behind the blunt end: a rack for the iron, drawn out or folded down; a lever below; a sleeve board on a pin. */
static void draw_iron_extras(dmg_builder* b, const ironing* g) {
    float w = 0.4f * g->wide, long_ = dmg_range(b, 0.18f, 0.28f), y = -0.5f * g->t, r = 0.004f;
    int rack = dmg_int(b, 0, 2), bars = dmg_int(b, 3, 6);
    bool sleeve = dmg_chance(b, 0.3f), lever = dmg_chance(b, 0.4f);
    if (rack == 1) {
        uint32_t part = dmg_slide(b, 0, "iron_rest", v3(-1, 0, 0), 0.0f, 0.8f * long_);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, part, 0.8f * long_ * dmg_unit(b));
        y = -g->t - 0.012f;
    }
    if (rack == 2) dmg_hinge(b, 0, "iron_rest", v3(-g->half - r, y, 0), v3(0, 0, 1), 0.0f, 1.5f);
    float x0 = -g->half - r - (rack == 1 ? 0.3f : 1.0f) * long_, x1 = x0 + long_;
    for (int s = -1; s <= 1; s += 2) {
        dmg_rod(b, v3(x0, y, (float)s * w), v3(x1, y, (float)s * w), r);
        dmg_rod(b, v3(s < 0 ? x0 : x1, y, -w), v3(s < 0 ? x0 : x1, y, w), r);
    }
    for (int i = 0; i < bars; ++i) {
        float z = 2 * w * (((float)i + 1) / ((float)bars + 1) - 0.5f);
        dmg_rod(b, v3(x0, y, z), v3(x1, y, z), 0.7f * r);
    }
    dmg_use(b, 0);
    if (sleeve) {
        float at = 0.5f * g->half, side = dmg_sign(b);
        dmg_rod(b, v3(-at, -0.01f, 0), v3(-at, 0.05f, 0), 0.02f);
        dmg_hinge(b, 0, "sleeve_board", v3(-at, 0.05f, 0), v3(0, side, 0), 0.0f, 3.0f);
        dmg_save(b);
        dmg_move(b, -at + 0.24f, 0.07f, 0);
        draw_board(b, 0.28f, 0.1f, 0.7f, 0.02f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (lever) { /* lets the legs go */
        float z = 0.3f * g->wide;
        dmg_hinge(b, 0, "release", v3(-0.7f * g->half, -g->t - 0.006f, z), v3(1, 0, 0), 0.0f, 0.5f);
        dmg_box_span(b, v3(-0.74f * g->half, -g->t - 0.012f, z), v3(-0.66f * g->half, -g->t - 0.002f, 0.52f * g->wide));
        dmg_use(b, 0);
    }
}

/* For a table's top: short legs, each pair folds inwards. */
static void draw_table_board(dmg_builder* b, const ironing* g) {
    float r = 0.006f, far = 0.7f * g->half, high = dmg_range(b, 0.1f, 0.18f), z = 0.35f * g->wide;
    draw_board(b, g->half, g->wide, g->nose, g->t);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * far, y = -g->t - r;
        dmg_hinge(b, 0, "legs", v3(x, y, 0), v3(0, 0, -(float)s), 0.0f, 1.5f);
        float narrow = s > 0 ? 0.5f * z : z;
        for (int k = -1; k <= 1; k += 2) dmg_rod(b, v3(x, y, (float)k * narrow), v3(x, y - high, (float)k * narrow), r);
        dmg_rod(b, v3(x, y, -narrow), v3(x, y, narrow), r);
        dmg_rod(b, v3(x, y - high, -narrow), v3(x, y - high, narrow), r);
        dmg_use(b, 0);
    }
}

/* In a cabinet on the wall: upright behind its door, let down to the front, where it may swivel. */
static void draw_wall_board(dmg_builder* b, const ironing* g) {
    float high = 2 * g->half + 0.16f, w = g->wide + 0.1f, deep = dmg_range(b, 0.1f, 0.16f), y = 0.07f - 0.5f * high,
          swing = dmg_range(b, 1.5f, 2.6f), down = dmg_range(b, 0.7f, 1.0f) * 0.5f * DMG_PI;
    bool mirror = dmg_chance(b, 0.5f);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, high, deep, 0.015f);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = w;
    leaf.height = high;
    leaf.thickness = 0.018f;
    leaf.side = mirror ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    leaf.swing = swing;
    dmg_save(b);
    dmg_move(b, 0, 0, 0.02f);
    uint32_t door = dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    dmg_rest(b, door, swing * dmg_range(b, 0.7f, 1.0f));
    dmg_use(b, 0);
    uint32_t board = dmg_hinge(b, 0, "board", v3(0, y, -0.5f * deep), v3(1, 0, 0), 0.0f, down);
    dmg_rod(b, v3(-0.5f * w + 0.016f, y, -0.5f * deep), v3(0.5f * w - 0.016f, y, -0.5f * deep), 0.008f);
    dmg_rest(b, board, dmg_chance(b, 0.5f) ? down : 0.0f);
    dmg_move(b, 0, y + g->half + 0.002f, -0.5f * deep + 0.5f * g->t);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    draw_board(b, g->half, g->wide, g->nose, g->t);
    dmg_use(b, 0);
}

void dmg_build_ironing_board(dmg_builder* b) {
    ironing g = {.half = dmg_range(b, 0.5f, 0.7f)};
    g.wide = dmg_range(b, 0.28f, 0.45f);
    g.high = dmg_range(b, 0.7f, 0.95f);
    g.t = dmg_range(b, 0.012f, 0.035f);
    g.nose = dmg_range(b, 0.1f, 0.6f);
    int kind = dmg_weighted(b, (const float[]){4, 1, 1.5f}, 3);
    if (kind == 1) g.half *= 0.6f;
    dmg_move(b, 0, kind == 1 ? 0.25f : g.high, 0);
    if (kind == 0) {
        draw_crossed(b, &g);
        draw_iron_extras(b, &g);
    }
    if (kind == 1) draw_table_board(b, &g);
    if (kind == 2) draw_wall_board(b, &g);
}

/* ---- parasol ---- */

typedef struct parasol {
    float radius, drop, pole, top; /* the canopy hangs by `drop` from the top */
    int ribs;
} parasol;

/* Open above its own ribs, the top at the origin; the rim has a valance sometimes. */
static void draw_canopy(dmg_builder* b, const parasol* p, bool valance, bool square) {
    float r = p->radius, t = 0.008f * r, low = -p->drop;
    const dmg_xy rows[] = {{0, 0},
                           {0.5f * r, 0.42f * low},
                           {r, low},
                           {r, valance ? low - 0.1f * r : low - t},
                           {r - t, valance ? low - 0.1f * r : low - t},
                           {0.5f * r, 0.42f * low - t},
                           {0, -t}};
    dmg_xy turned[7];
    for (int i = 0; i < 7; ++i) turned[i] = rows[6 - i];
    int sides = b->sides;
    b->sides = square ? 4 : p->ribs;
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), turned, 7);
    b->sides = sides;
    dmg_ellipsoid(b, v3(0, 0.01f * r, 0), v3(0.04f * r, 0.05f * r, 0.04f * r));
    for (int i = 0; i < p->ribs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, square ? 4 : p->ribs);
        if (!square || i < 4)
            dmg_beam(b, v3(0, -2.5f * t, 0), v3(0, 0.97f * low - 2.5f * t, 0.95f * r), 1.5f * t, 1.5f * t);
        dmg_restore(b);
    }
}

/* Draws the bare frame: each rib turns down about the crown, the runner slides with its stays. */
static void draw_rib_frame(dmg_builder* b, const parasol* p, uint32_t parent, bool cloth) {
    float t = 0.008f * p->radius, slope = atan2f(p->drop, p->radius),
          fold = (1.45f - slope) * dmg_range(b, 0.7f, 0.98f), hub = 1.8f * p->pole, long_ = hypotf(p->radius, p->drop),
          away = 0.35f * long_, down = 0.8f * away;
    dmg_rod(b, v3(0, -2 * t - 0.02f * p->radius, 0), v3(0, 0.04f * p->radius, 0), hub);
    for (int i = 0; i < p->ribs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, p->ribs);
        dmg_hinge(b, parent, "rib", v3(0, 0, hub), v3(1, 0, 0), 0.0f, fold);
        dmg_beam(b, v3(0, 0, hub), v3(0, -p->drop, p->radius), 1.5f * t, 1.5f * t);
        dmg_move(b, 0, 0.5f * t, hub);
        dmg_turn(b, v3(1, 0, 0), slope + 0.5f * DMG_PI); /* y of the outline runs down the rib */
        float wide = p->radius * tanf(DMG_PI / (float)p->ribs);
        const dmg_xy gore[] = {{-0.03f * wide, 0.03f * long_},
                               {0.03f * wide, 0.03f * long_},
                               {0.93f * wide, 0.93f * long_},
                               {-0.93f * wide, 0.93f * long_}};
        if (cloth) dmg_extrude(b, gore, 4, -0.5f * t, 0.0f);
        dmg_restore(b);
        dmg_use(b, parent);
    }
    dmg_slide(b, parent, "runner", v3(0, -1, 0), 0.0f, 0.5f * p->radius);
    dmg_rod(b, v3(0, -down - 0.06f * p->radius, 0), v3(0, -down, 0), hub);
    dmg_use(b, parent);
}

static void draw_parasol_base(dmg_builder* b, const parasol* p) {
    float r = p->radius * dmg_range(b, 0.18f, 0.3f), h = r * dmg_range(b, 0.1f, 0.3f);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_cone(b, v3(0, 0, 0), v3(0, h, 0), r, 0.85f * r);
    if (kind == 1) dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(2 * r, h, 2 * r), 0.3f * h);
    if (kind == 2) {
        dmg_box_span(b, v3(-1.5f * r, 0, -0.1f * r), v3(1.5f * r, 0.15f * r, 0.1f * r));
        dmg_box_span(b, v3(-0.1f * r, 0, -1.5f * r), v3(0.1f * r, 0.15f * r, 1.5f * r));
    }
    dmg_rod(b, v3(0, 0, 0), v3(0, h + 0.8f * r, 0), 1.7f * p->pole);
    if (!dmg_chance(b, 0.5f)) return; /* the screw that holds the pole */
    float y = h + 0.5f * r, x = 1.6f * p->pole;
    dmg_screw(b, 0, "clamp_screw", v3(x, y, 0), v3(1, 0, 0), 0.0006f, 0.0f, 8.0f * DMG_PI);
    dmg_rod(b, v3(0.9f * x, y, 0), v3(2 * x, y, 0), 0.3f * p->pole);
    dmg_box(b, v3(2.2f * x, y, 0), v3(0.5f * x, 2.2f * p->pole, 0.6f * p->pole));
    dmg_use(b, 0);
}

/* Draws a crank in its case at y, on the side +Z of the pole. */
static void draw_parasol_crank(dmg_builder* b, uint32_t parent, float y, float pole) {
    float arm = pole * dmg_range(b, 2.0f, 4.0f), z = 2.2f * pole;
    dmg_rounded_box(b, v3(0, y, 0.3f * pole), v3(3 * pole, 5 * pole, 3.6f * pole), 0.5f * pole);
    dmg_spin(b, parent, "crank", v3(0, y, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, y, 0.9f * z), v3(0, y, 1.2f * z), 0.5f * pole);
    dmg_beam(b, v3(0, y, 1.2f * z), v3(arm, y, 1.3f * z), 0.6f * pole, 0.4f * pole);
    dmg_rod(b, v3(arm, y, 1.25f * z), v3(arm, y, 1.3f * z + 1.8f * pole), 0.35f * pole);
    dmg_use(b, parent);
}

/* Draws the pole in the middle; its upper part tilts at a joint. */
static void draw_centre_parasol(dmg_builder* b, const parasol* p) {
    float joint = p->top - p->drop - 0.12f * p->radius - 4 * p->pole, far = dmg_range(b, 0.4f, 0.9f);
    bool tilts = dmg_chance(b, 0.65f), crank = dmg_chance(b, 0.5f), frame = dmg_chance(b, 0.4f),
         cloth = dmg_chance(b, 0.6f), valance = dmg_chance(b, 0.4f), square = dmg_chance(b, 0.25f);
    tilts = tilts || !(crank || frame); /* something has to move */
    draw_parasol_base(b, p);
    dmg_rod(b, v3(0, 0, 0), v3(0, tilts ? joint : p->top, 0), p->pole);
    if (crank) draw_parasol_crank(b, 0, 0.75f * joint, p->pole);
    uint32_t upper = 0;
    if (tilts) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(1.2f * (float)s * p->pole, joint, 0), v3(0.5f * p->pole, 4 * p->pole, 2 * p->pole));
        upper = dmg_hinge(b, 0, "tilt", v3(0, joint, 0), v3(1, 0, 0), 0.0f, far);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, upper, far * dmg_unit(b));
        dmg_rod(b, v3(0, joint, 0), v3(0, p->top, 0), 0.9f * p->pole);
    }
    dmg_move(b, 0, p->top, 0);
    if (frame)
        draw_rib_frame(b, p, upper, cloth);
    else
        draw_canopy(b, p, valance, square);
    if (!frame && dmg_chance(b, 0.5f)) {
        dmg_slide(b, upper, "runner", v3(0, -1, 0), 0.0f, 0.3f * p->drop);
        dmg_rod(b, v3(0, -0.9f * p->drop, 0), v3(0, -0.9f * p->drop + 2 * p->pole, 0), 1.6f * p->pole);
    }
    dmg_use(b, 0);
}

/* Draws the mast beside it on a turning foot, a boom, the canopy hung from its end. */
static void draw_boom_parasol(dmg_builder* b, const parasol* p) {
    float side = 1.05f * p->radius, mast = p->top - 0.1f * p->radius, far = dmg_range(b, 0.3f, 0.9f),
          tilt = dmg_range(b, 0.3f, 0.7f);
    bool turns = dmg_chance(b, 0.6f), grip = dmg_chance(b, 0.5f), valance = dmg_chance(b, 0.3f),
         square = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-0.5f * side, 0, -0.5f * side), v3(0.5f * side, 0.05f, 0.5f * side));
    dmg_rod(b, v3(0, 0.04f, 0), v3(0, 0.12f, 0), 2 * p->pole);
    uint32_t foot = turns ? dmg_spin(b, 0, "mast", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rod(b, v3(0, 0.121f, 0), v3(0, mast, 0), 1.3f * p->pole);
    draw_parasol_crank(b, foot, 0.45f * mast, p->pole);
    if (grip) { /* along the mast, it raises the boom */
        dmg_slide(b, foot, "grip", v3(0, 1, 0), 0.0f, 0.2f * mast);
        dmg_rod(b, v3(0, 0.6f * mast, 0), v3(0, 0.68f * mast, 0), 2.2f * p->pole);
        dmg_box_span(b, v3(-2.6f * p->pole - 0.08f, 0.62f * mast, -p->pole),
                     v3(-1.8f * p->pole, 0.66f * mast, p->pole));
        dmg_use(b, foot);
    }
    dmg_vec end = v3(side, p->top + 0.12f * p->radius, 0);
    uint32_t boom = dmg_hinge(b, foot, "boom", v3(0, mast, 0), v3(0, 0, -1), 0.0f, far);
    dmg_rod(b, v3(0, mast, -2 * p->pole), v3(0, mast, 2 * p->pole), 1.8f * p->pole);
    dmg_rod(b, v3(0, mast, 0), end, p->pole);
    dmg_hinge(b, boom, "canopy", end, v3(1, 0, 0), -tilt, tilt);
    dmg_rod(b, v3(end.x - 1.5f * p->pole, end.y, 0), v3(end.x + 1.5f * p->pole, end.y, 0), 1.4f * p->pole);
    dmg_rod(b, v3(end.x, p->top - p->drop, 0), end, 0.8f * p->pole);
    dmg_move(b, end.x, p->top, 0);
    draw_canopy(b, p, valance, square);
    dmg_use(b, 0);
}

void dmg_build_parasol(dmg_builder* b) {
    parasol p = {.radius = dmg_scale_range(b, 0.8f, 1.8f)};
    p.drop = p.radius * dmg_range(b, 0.2f, 0.45f);
    p.pole = dmg_range(b, 0.016f, 0.03f);
    p.top = dmg_range(b, 2.1f, 2.7f);
    p.ribs = dmg_int(b, 6, 10);
    if (dmg_chance(b, 0.7f))
        draw_centre_parasol(b, &p);
    else
        draw_boom_parasol(b, &p);
}
