/* Draws old furniture: cabinets under cornices on turned legs, arched and bowed doors, bombe chests, writing flaps
 * on lopers, chests of many drawers. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* The carcass: x centred, front at z = 0, from the height of its legs up. */
typedef struct carcass {
    float w, h, d, t; /* t: of boards */
    float leg, top;   /* heights of its lower and upper edge */
    dmg_leaf leaf;    /* what its doors have in common */
    dmg_handle pull;  /* of its drawers */
    dmg_panel panel;
} carcass;

/* ---- ornament ---- */

static void draw_turned_leg(dmg_builder* b, float r, float h) {
    float waist = dmg_range(b, 0.3f, 0.7f), bulb = dmg_range(b, 0.35f, 0.75f), foot = dmg_range(b, 0.3f, 0.9f);
    const dmg_xy profile[] = {{0, 0},
                              {foot * r, 0},
                              {foot * r, 0.08f * h},
                              {waist * r, 0.14f * h},
                              {0.8f * r, bulb * h},
                              {waist * r, (bulb + 0.15f) * h},
                              {r, 0.95f * h},
                              {r, h},
                              {0, h}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 9);
}

static void draw_cabriole(dmg_builder* b, float out_x, float r, float h) {
    const dmg_vec path[] = {{0, h, 0},
                            {0.5f * out_x, 0.75f * h, 0.5f * r},
                            {0.3f * out_x, 0.35f * h, 0.3f * r},
                            {0, 0.1f * h, 0},
                            {0.7f * out_x, 0.3f * r, 0.7f * r}};
    dmg_sweep(b, path, 5, 0.55f * r, 0.55f * r, false);
}

/* Turned legs, cabrioles, buns, brackets or a plinth under the carcass. */
static void draw_legs(dmg_builder* b, const carcass* c, int kind) {
    float r = dmg_range(b, 0.02f, 0.035f), x = 0.5f * c->w - r, front = -r, back = r - c->d;
    if (kind == 4) {
        dmg_box_span(b, v3(-0.5f * c->w - 0.3f * r, 0, -c->d), v3(0.5f * c->w + 0.3f * r, c->leg, 0.3f * r));
        return;
    }
    uint64_t same = b->random_state; /* all four alike */
    for (int i = 0; i < 4; ++i) {
        float s = i & 1 ? 1.0f : -1.0f;
        b->random_state = same;
        dmg_save(b);
        dmg_move(b, s * x, 0, i & 2 ? front : back);
        if (kind == 0) draw_turned_leg(b, r, c->leg);
        if (kind == 1) draw_cabriole(b, s * r, 1.4f * r, c->leg);
        if (kind == 2) dmg_ellipsoid(b, v3(0, 0.5f * c->leg, 0), v3(1.2f * r, 0.5f * c->leg, 1.2f * r));
        const dmg_xy bracket[] = {{-s * r, 0}, {0.6f * s * r, 0}, {s * r, c->leg}, {-4 * s * r, c->leg}};
        const dmg_xy turned[] = {bracket[3], bracket[2], bracket[1], bracket[0]};
        if (kind == 3) dmg_extrude(b, s > 0 ? turned : bracket, 4, -r, r);
        dmg_restore(b);
    }
}

/* Steps that jut out further upwards, perhaps with a pediment on the front. */
static void draw_cornice(dmg_builder* b, const carcass* c) {
    int steps = dmg_int(b, 1, 4);
    float each = dmg_range(b, 0.008f, 0.03f), jut = dmg_range(b, 0.005f, 0.02f), y = c->top;
    for (int i = 0; i < steps; ++i, y += each) {
        float out = jut * (float)(i + 1);
        dmg_box_span(b, v3(-0.5f * c->w - out, y, -c->d), v3(0.5f * c->w + out, y + each, out + c->t));
    }
    int kind = dmg_int(b, 0, 5);
    float half = 0.5f * c->w, rise = c->w * dmg_range(b, 0.08f, 0.25f);
    const dmg_xy gable[] = {{-half, y}, {half, y}, {0, y + rise}};
    const dmg_xy broken[] = {{-half, y},
                             {half, y},
                             {0.15f * half, y + rise},
                             {0.1f * half, y + 0.2f * rise},
                             {-0.1f * half, y + 0.2f * rise},
                             {-0.15f * half, y + rise}};
    if (kind == 1) dmg_extrude(b, gable, 3, -c->t, c->t);
    if (kind == 2) dmg_extrude(b, broken, 6, -c->t, c->t);
    enum { POINTS = 9 };
    dmg_xy arch[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float a = DMG_PI * (float)i / (POINTS - 1);
        arch[i] = (dmg_xy){0.8f * half * cosf(a), y + rise * sinf(a)};
    }
    if (kind == 3) dmg_extrude(b, arch, POINTS, -c->t, 0.5f * c->t);
}

/* ---- fronts ---- */

/* Draws an opening of w x h, centred at (x, y), with a rail round it left by the caller. */
static void draw_old_drawer(dmg_builder* b, const carcass* c, float x, float y, float w, float h) {
    dmg_drawer drawer = dmg_drawer_pick(b, 0.6f * fminf(w, h));
    drawer.width = 0.985f * w;
    drawer.height = h - 0.015f * w;
    drawer.thickness = c->t;
    drawer.depth = c->d * dmg_range(b, 0.7f, 0.9f);
    drawer.travel = drawer.depth * dmg_range(b, 0.5f, 0.9f);
    drawer.panel = c->panel;
    drawer.handle = c->pull;
    drawer.handles = w > 3.0f * h ? 2 : 1;
    drawer.handle_at = 0.0f;
    dmg_save(b);
    dmg_move(b, x, y, c->t);
    uint32_t part = dmg_drawer_draw(b, 0, "drawer", &drawer);
    if (part && dmg_chance(b, 0.3f)) /* the keyhole's plate */
        dmg_box(b, v3(0, 0.3f * h, 0.05f * c->t), v3(0.12f * h, 0.18f * h, 0.2f * c->t));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a leaf from its hung side x = 0 to x = w with its top arched over itself alone or over a pair. */
static void draw_arched_leaf(dmg_builder* b, const carcass* c, float w, float h, float rise, bool pair) {
    enum { POINTS = 9 };
    dmg_xy outline[POINTS + 2] = {{0, 0}, {w, 0}}, field[POINTS + 2];
    for (int i = 0; i < POINTS; ++i) {
        float x = w * (1.0f - (float)i / (POINTS - 1)), off = pair ? 1.0f - x / w : 2.0f * x / w - 1.0f;
        outline[i + 2] = (dmg_xy){x, h - rise * off * off};
    }
    for (int i = 0; i < POINTS + 2; ++i)
        field[i] = (dmg_xy){0.5f * w + 0.7f * (outline[i].x - 0.5f * w), 0.5f * h + 0.8f * (outline[i].y - 0.5f * h)};
    dmg_hinge(b, 0, "door", v3(c->leaf.inset * c->t, 0, c->t * (1.0f - c->leaf.depth)), v3(0, -1, 0), 0.0f,
              c->leaf.swing);
    dmg_extrude(b, outline, POINTS + 2, 0.05f * c->t, c->t);
    if (c->panel.kind != DMG_PANEL_FLAT) dmg_extrude(b, field, POINTS + 2, c->t, 1.3f * c->t);
    dmg_move(b, 0.9f * w, h * (0.5f + 0.3f * c->leaf.handle_at), 1.0f * c->t);
    dmg_handle_draw(b, &c->leaf.handle, 0.3f * h);
    dmg_use(b, 0);
}

static void draw_arched_doors(dmg_builder* b, const carcass* c, float low, float high, int leaves, float side) {
    float half = 0.5f * c->w, h = high - low, each = c->w * 0.96f / (float)leaves,
          rise = fminf(0.3f * h, each * dmg_range(b, 0.15f, 0.6f));
    bool pair = leaves == 2 && dmg_chance(b, 0.6f);
    for (int i = 0; i < leaves; ++i) {
        float s = leaves == 1 ? side : (i ? 1.0f : -1.0f);
        dmg_save(b);
        if (s > 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -0.96f * half, low, 0);
        draw_arched_leaf(b, c, 0.99f * each, 0.99f * h, rise, pair);
        dmg_restore(b);
    }
}

static void draw_flat_doors(dmg_builder* b, const carcass* c, float low, float high, int leaves, float side) {
    float each = 0.96f * c->w / (float)leaves;
    for (int i = 0; i < leaves; ++i) {
        dmg_leaf leaf = c->leaf;
        leaf.width = 0.99f * each;
        leaf.height = 0.985f * (high - low);
        leaf.thickness = c->t;
        leaf.panel = c->panel;
        bool left = leaves == 1 ? side < 0 : i < (leaves + 1) / 2;
        leaf.side = left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, each * ((float)i + 0.5f) - 0.48f * c->w, 0.5f * (low + high), c->t);
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* ---- the pieces ---- */

static void draw_carcass(dmg_builder* b, const carcass* c, float shelf) {
    float y = 0.5f * (c->leg + c->top), inner = c->w - 2 * c->t;
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_case_draw(b, dmg_case_pick(b), c->w, c->top - c->leg, c->d, c->t);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.5f * inner, shelf - 0.4f * c->t, 0.1f * c->t - c->d), v3(0.5f * inner, shelf, -0.05f * c->t));
}

/* Doors above or below a row of drawers: cupboards, armoires, wardrobes with mirrors. */
static void draw_armoire(dmg_builder* b, carcass* c) {
    float h = c->top - c->leg, row = h * dmg_range(b, 0.1f, 0.35f), side = dmg_sign(b);
    bool drawers = dmg_chance(b, 0.6f), above = dmg_chance(b, 0.4f), arched = dmg_chance(b, 0.4f);
    int count = dmg_int(b, 1, 3), leaves = c->w < 0.6f ? 1 : dmg_int(b, 1, c->w > 1.0f ? 4 : 2);
    if (dmg_chance(b, 0.3f)) c->panel = (dmg_panel){.kind = DMG_PANEL_WINDOW, .border = 0.12f, .infill = 0.7f};
    float low = c->leg + c->t, high = c->top - c->t, split = above ? high - row : low + row;
    draw_carcass(b, c, drawers ? split : 0.5f * (low + high));
    for (int i = 0; i < count && drawers; ++i) {
        float each = 0.96f * c->w / (float)count;
        draw_old_drawer(b, c, each * ((float)i + 0.5f) - 0.48f * c->w, above ? split + 0.5f * row : low + 0.5f * row,
                        each, row - c->t);
    }
    if (drawers && above) high = split - c->t;
    if (drawers && !above) low = split;
    if (arched)
        draw_arched_doors(b, c, low, high, leaves > 2 ? 2 : leaves, side);
    else
        draw_flat_doors(b, c, low, high, leaves, side);
}

/* Many small drawers in rows, some rows of fewer. */
static void draw_apothecary(dmg_builder* b, const carcass* c) {
    int rows = dmg_int(b, 3, 8), columns = dmg_int(b, 2, 8);
    float low = c->leg + c->t, each_h = (c->top - c->t - low) / (float)rows;
    draw_carcass(b, c, low + each_h);
    for (int r = 0; r < rows; ++r) {
        int here = r == 0 ? (columns + 1) / 2 : columns;
        float each = 0.96f * c->w / (float)here;
        for (int i = 0; i < here; ++i)
            draw_old_drawer(b, c, each * ((float)i + 0.5f) - 0.48f * c->w, low + each_h * ((float)r + 0.5f), each,
                            each_h);
    }
}

/* Draws a chest whose sides and drawers swell: each drawer's front is a slice of the same curve. */
static void draw_bombe(dmg_builder* b, const carcass* c) {
    enum { STEPS = 5 };
    int count = dmg_int(b, 2, 4);
    float h = c->top - c->leg, swell = c->d * dmg_range(b, 0.1f, 0.3f), low = dmg_range(b, 0.5f, 1.5f),
          travel = c->d * dmg_range(b, 0.4f, 0.7f);
    dmg_box_span(b, v3(-0.5f * c->w, c->leg, -c->d), v3(0.5f * c->w, c->top, 0));
    for (int i = 0; i < count; ++i) {
        dmg_xy line[2 * STEPS];
        for (int k = 0; k < STEPS; ++k) {
            float share = ((float)i + 0.02f + 0.96f * (float)k / (STEPS - 1)) / (float)count;
            float out = c->t + swell * sinf(DMG_PI * powf(share, low)), y = c->leg + h * share;
            line[k] = (dmg_xy){out, y};
            line[2 * STEPS - 1 - k] = (dmg_xy){0.05f * c->t, y};
        }
        dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, travel);
        dmg_side_prism(b, line, 2 * STEPS, -0.48f * c->w, 0.48f * c->w);
        float y = c->leg + h * ((float)i + 0.2f) / (float)count, high = 0.6f * h / (float)count;
        dmg_box_span(b, v3(-0.44f * c->w, y, -travel), v3(0.44f * c->w, y + high, 0.06f * c->t));
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, 0.28f * (float)s * c->w, y + 0.5f * high, line[STEPS / 2].x);
            dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
            dmg_handle_draw(b, &c->pull, 0.25f * c->w);
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
}

/* Draws a desk with a slanted or upright flap that comes down onto lopers, drawers below it. */
static void draw_secretaire(dmg_builder* b, const carcass* c) {
    float slant = dmg_chance(b, 0.55f) ? dmg_range(b, 0.3f, 0.8f) : 0.0f, h = c->top - c->leg,
          flap = fminf(h * dmg_range(b, 0.3f, 0.45f), 0.85f * c->d / fmaxf(0.2f, tanf(slant))), low = c->top - flap,
          back = flap * tanf(slant), t = 0.7f * c->t, x = 0.46f * c->w;
    int rows = dmg_int(b, 1, 4), stays = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        const dmg_xy cheek[] = {{-c->d, low}, {-t, low}, {-t - back, c->top}, {-c->d, c->top}};
        dmg_side_prism(b, cheek, 4, (float)s * 0.48f * c->w - 0.02f * c->w, (float)s * 0.48f * c->w + 0.02f * c->w);
    }
    dmg_box_span(b, v3(-0.5f * c->w, c->leg, -c->d), v3(0.5f * c->w, low - 0.01f, 0));
    dmg_box_span(b, v3(-x, low, -c->d), v3(x, c->top, t - c->d));
    dmg_box_span(b, v3(-x, c->top - t, -c->d), v3(x, c->top, -back - 1.5f * t));
    for (int i = 0; i < 4; ++i) { /* pigeon holes */
        float px = 0.3f * c->w * ((float)i - 1.5f) / 1.5f;
        dmg_box_span(b, v3(px - 0.2f * t, low, t - c->d), v3(px + 0.2f * t, c->top - t, -back - 0.4f * (c->d - back)));
    }
    dmg_save(b);
    dmg_move(b, 0, low, 0);
    dmg_turn(b, v3(1, 0, 0), -slant);
    dmg_hinge(b, 0, "flap", v3(0, 0, 0), v3(1, 0, 0), 0.0f, 0.5f * DMG_PI + slant);
    float long_way = flap / cosf(slant);
    dmg_box_span(b, v3(-x, 0, -t), v3(x, long_way, 0));
    dmg_move(b, 0, dmg_range(b, 0.8f, 0.93f) * long_way, 0);
    dmg_knob_draw(b, 3, 0.6f * t, t);
    dmg_restore(b);
    dmg_use(b, 0);
    float high = fminf(0.08f * c->w, 0.2f * (low - c->leg));
    for (int s = -1; s <= 1 && stays; s += 2) { /* lopers beside the uppermost drawer */
        dmg_slide(b, 0, "loper", v3(0, 0, 1), 0.0f, 0.6f * c->d);
        dmg_box_span(b, v3((float)s * x - t, low - high, -0.8f * c->d), v3((float)s * x + t, low - 0.012f, 0.4f * t));
        dmg_use(b, 0);
    }
    float each = (low - high - c->leg) / (float)rows;
    for (int i = 0; i < rows && c->leg < 0.4f; ++i)
        draw_old_drawer(b, c, 0, c->leg + each * ((float)i + 0.5f), 0.96f * c->w, each);
}

/* Draws an upright plate about the axis of the room's corner. */
static void draw_bow(dmg_builder* b, float r, float t, float from, float to, float h) {
    enum { STEPS = 8 };
    dmg_xy outline[2 * STEPS];
    for (int i = 0; i < STEPS; ++i) {
        float a = from + (to - from) * (float)i / (STEPS - 1);
        outline[i] = (dmg_xy){r * sinf(a), -r * cosf(a)};
        outline[2 * STEPS - 1 - i] = (dmg_xy){(r - t) * sinf(a), -(r - t) * cosf(a)};
    }
    dmg_save(b);
    dmg_face_up(b);
    dmg_extrude(b, outline, 2 * STEPS, 0, h);
    dmg_restore(b);
}

/* Draws a sector of a circle standing in a corner, its round front two doors or one. */
static void draw_round_corner(dmg_builder* b, const carcass* c) {
    float r = c->w * dmg_range(b, 0.7f, 1.0f), wide = dmg_range(b, 0.9f, 1.5f), rim = dmg_range(b, 0.03f, 0.15f),
          h = c->top - c->leg, side = dmg_sign(b);
    int leaves = dmg_int(b, 1, 2), shelves = dmg_int(b, 1, 3);
    dmg_move(b, 0, c->leg, -r);
    for (int i = 0; i < shelves + 2; ++i) {
        dmg_save(b);
        dmg_move(b, 0, (h - c->t) * (float)i / (float)(shelves + 1), 0);
        bool outer = i == 0 || i == shelves + 1;
        draw_bow(b, outer ? 1.03f * r : 0.92f * r, outer ? 1.02f * r : 0.9f * r, -0.5f * wide, 0.5f * wide, c->t);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1; s += 2) {
        float a = 0.5f * (float)s * wide, in = 0.5f * (float)s * (wide - rim);
        dmg_beam(b, v3(0.03f * r * sinf(a), 0.5f * h, 0.03f * r * cosf(a)),
                 v3(0.97f * r * sinf(a), 0.5f * h, 0.97f * r * cosf(a)), 0.6f * c->t, h);
        draw_bow(b, r, 1.2f * c->t, fminf(a, in), fmaxf(a, in), h);
    }
    for (int i = 0; i < leaves; ++i) {
        float s = leaves == 1 ? side : (i ? 1.0f : -1.0f), hung = 0.5f * s * (wide - rim) - s * 0.01f,
              free = leaves == 1 ? -hung : 0.004f * s;
        dmg_hinge(b, 0, "door", v3(r * sinf(hung), 0, r * cosf(hung)), v3(0, s, 0), 0.0f, c->leaf.swing);
        dmg_save(b);
        dmg_move(b, 0, 1.1f * c->t, 0);
        draw_bow(b, r, c->t, fminf(hung, free), fmaxf(hung, free), h - 2.2f * c->t);
        float at = free + 0.12f * (hung - free);
        dmg_move(b, r * sinf(at), 0.5f * h, r * cosf(at));
        dmg_turn(b, v3(0, 1, 0), at);
        dmg_handle_draw(b, &c->leaf.handle, 0.3f * h);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_period_cabinet(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 1, 1.5f, 2, 1.5f}, 5), legs = dmg_int(b, 0, 4);
    carcass c = {.w = dmg_scale_range(b, 0.45f, 1.5f)};
    c.d = c.w * dmg_range(b, 0.35f, 0.6f);
    c.t = dmg_range(b, 0.016f, 0.03f);
    c.h = dmg_scale_range(b, 0.6f, 2.0f);
    if (kind >= 2) c.h = dmg_range(b, 0.8f, 1.15f);
    c.leg = legs <= 1 ? c.h * dmg_range(b, 0.1f, 0.35f) : dmg_range(b, 0.05f, 0.12f);
    c.top = c.h;
    c.leaf = dmg_leaf_pick(b, 0.12f);
    c.leaf.inset = fminf(c.leaf.inset, 0.6f);
    c.pull = dmg_handle_pick(b, 0.08f);
    c.panel = dmg_panel_pick(b);
    if (c.panel.kind == DMG_PANEL_BOWED || c.panel.kind == DMG_PANEL_SHEET) c.panel.kind = DMG_PANEL_FRAMED;
    if (kind == 4) {
        draw_round_corner(b, &c);
        return;
    }
    draw_legs(b, &c, legs);
    if (kind == 0) draw_armoire(b, &c);
    if (kind == 1) draw_apothecary(b, &c);
    if (kind == 2) draw_bombe(b, &c);
    if (kind == 3) draw_secretaire(b, &c);
    if (kind != 3 || dmg_chance(b, 0.2f)) draw_cornice(b, &c);
}
