/* Draws flight instruments without a central needle: horizon balls in rings, floating cards, drums of figures,
 * tapes, bars hung at the rim, flags, a ball in a curved tube. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

/* The face is z = 0, towards +Z, its window this large; a round case or a square one behind. */
typedef struct face {
    float r, depth;
    bool square, round_bezel;
} face;

static void draw_case(dmg_builder* b, face* f) {
    float half = 1.22f * f->r, lip = 0.12f * f->r;
    f->round_bezel = dmg_chance(b, 0.4f);
    if (!f->round_bezel) {
        dmg_holed_plate_draw(b, 2 * half, 2 * half, lip, f->r);
    } else {
        const dmg_xy ring[] = {{f->r, -lip}, {half, -lip}, {half, 0}, {f->r, 0}, {f->r, -lip}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    }
    if (f->square) {
        dmg_save(b);
        dmg_move(b, 0, 0, -lip);
        dmg_case_draw(b, DMG_CASE_BOARDS, 2.3f * f->r, 2.3f * f->r, f->depth, 0.08f * f->r);
        dmg_restore(b);
    } else {
        const dmg_xy can[] = {{0, -f->depth},
                              {1.12f * f->r, -f->depth},
                              {1.12f * f->r, -lip},
                              {1.04f * f->r, -lip},
                              {1.04f * f->r, 0.08f * f->r - f->depth},
                              {0, 0.08f * f->r - f->depth}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), can, 6);
    }
}

static void draw_ring(dmg_builder* b, float inner, float outer, float z, float thick) {
    const dmg_xy ring[] = {{inner, 0}, {outer, 0}, {outer, thick}, {inner, thick}, {inner, 0}};
    dmg_lathe(b, v3(0, 0, z), v3(0, 0, 1), ring, 5);
}

/* Draws the aeroplane that does not move, before what does. */
static void draw_symbol(dmg_builder* b, float r) {
    float t = 0.05f * r, z = -0.02f * r;
    for (int i = -1; i <= 1; i += 2) {
        dmg_box(b, v3((float)i * 0.62f * r, 0, z), v3(0.78f * r, t, t));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3((float)i * 0.26f * r, -0.06f * r, z), v3(t, 0.14f * r, t));
    }
    dmg_box(b, v3(0, 0, z), v3(t, t, t));
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, -0.5f * r, z), v3(t, r, t));
}

/* ---- horizons: what rolls carries what pitches; a ball and a drum turn, a card slides ---- */

static void draw_horizon(dmg_builder* b, const face* f) {
    float r = f->r, middle = -0.95f * r, swing = dmg_range(b, 0.5f, 1.4f);
    int kind = dmg_int(b, 0, 2);
    bool ring = dmg_chance(b, 0.8f);
    uint32_t roll = 0;
    if (ring) {
        roll = dmg_spin(b, 0, "roll_ring", v3(0, 0, middle), v3(0, 0, 1));
        draw_ring(b, 0.88f * r, 0.98f * r, -0.22f * r, 0.08f * r);
        dmg_box(b, v3(0, 0.84f * r, -0.16f * r), v3(0.1f * r, 0.12f * r, 0.06f * r));
        if (kind != 2)
            for (int i = -1; i <= 1; i += 2) /* the yoke back to the ball's pins */
                dmg_beam(b, v3((float)i * 0.93f * r, 0, -0.2f * r), v3((float)i * 0.93f * r, 0, middle), 0.06f * r,
                         0.12f * r);
    }
    if (kind == 2) { /* a card behind the ring */
        float way = 0.35f * r;
        uint32_t card = dmg_slide(b, roll, "pitch_card", v3(0, 1, 0), -way, way);
        dmg_box(b, v3(0, 0, -0.4f * r), v3(0.9f * r, 0.9f * r, 0.04f * r));
        dmg_box(b, v3(0, 0, -0.36f * r), v3(0.85f * r, 0.03f * r, 0.05f * r));
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3(0, (float)i * 0.22f * r, -0.37f * r), v3(0.3f * r, 0.02f * r, 0.04f * r));
        dmg_rest(b, card, way * dmg_range(b, -0.8f, 0.8f));
    } else {
        dmg_vec pin = {0, 0, middle};
        uint32_t pitch =
            dmg_hinge(b, roll, kind == 0 ? "horizon_ball" : "horizon_drum", pin, v3(1, 0, 0), -swing, swing);
        float ball = 0.8f * r;
        if (kind == 0) dmg_ellipsoid(b, pin, v3(ball, ball, ball));
        if (kind == 1) dmg_rod(b, v3(-0.8f * r, 0, middle), v3(0.8f * r, 0, middle), 0.75f * r);
        dmg_torus(b, pin, v3(0, 1, 0), kind == 0 ? ball : 0.76f * r, 0.015f * r); /* the line itself */
        dmg_rod(b, v3(-0.95f * r, 0, middle), v3(0.95f * r, 0, middle), 0.06f * r);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, pitch, swing * dmg_range(b, -0.6f, 0.6f));
    }
    dmg_use(b, 0);
    draw_symbol(b, r);
}

/* ---- a compass that floats behind a window: its line is upright, unlike the dial's ---- */

static void draw_float_compass(dmg_builder* b, const face* f) {
    float r = f->r, card = 0.72f * r, middle = -0.9f * r, high = 0.3f * r;
    int marks = dmg_int(b, 0, 12);
    dmg_spin(b, 0, "card", v3(0, 0, middle), v3(0, 1, 0));
    if (dmg_chance(b, 0.5f)) {
        const dmg_xy skirt[] = {
            {0, -0.1f * high}, {0.96f * card, -0.1f * high}, {card, high}, {0.9f * card, high}, {0, 0.2f * high}};
        dmg_lathe(b, v3(0, 0, middle), v3(0, -1, 0), skirt, 5);
    } else {
        dmg_rod(b, v3(0, -0.5f * high, middle), v3(0, 0.5f * high, middle), card);
    }
    for (int i = 0; i < marks; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)marks;
        dmg_rod(b, v3(card * cosf(angle), -0.3f * high, middle + card * sinf(angle)),
                v3(card * cosf(angle), 0.3f * high, middle + card * sinf(angle)), 0.03f * r);
    }
    dmg_use(b, 0);
    dmg_cone(b, v3(0, -0.9f * r, middle), v3(0, -0.5f * high, middle), 0.1f * r, 0.02f * r); /* the pivot */
    dmg_box(b, v3(0, 0, -0.08f * r), v3(0.04f * r, 1.9f * r, 0.04f * r));                    /* the lubber line */
    for (int i = 0; i < 2 && dmg_chance(b, 0.6f); ++i) { /* the two adjusters under it */
        dmg_save(b);
        dmg_move(b, (i == 0 ? -0.4f : 0.4f) * r, -1.1f * r, 0);
        dmg_spin(b, 0, "adjuster", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.08f * r), 0.08f * r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* ---- a plate with windows: drums of figures, a tape ---- */

static void draw_drums(dmg_builder* b, const face* f) {
    float r = f->r;
    int drums = dmg_int(b, 2, 5);
    float pitch = 1.4f * r / (float)drums, drum = r * dmg_range(b, 0.25f, 0.45f), y = r * dmg_range(b, -0.3f, 0.3f),
          open = drum * dmg_range(b, 0.8f, 1.4f), z = -0.1f * r - 0.9f * drum, rest = 0.97f * r;
    float half = 0.7f * r + 0.02f * r, low = y - 0.5f * open, high = y + 0.5f * open;
    dmg_box_span(b, v3(-0.7f * rest, high, -0.12f * r),
                 v3(0.7f * rest, fminf(0.68f * r + high, 0.7f * rest), -0.06f * r));
    dmg_box_span(b, v3(-0.7f * rest, fmaxf(low - 0.68f * r, -0.7f * rest), -0.12f * r),
                 v3(0.7f * rest, low, -0.06f * r));
    for (int i = -1; i <= 1; i += 2)
        dmg_box(b, v3((float)i * (half + 0.1f * r), y, -0.09f * r), v3(0.2f * r, open, 0.06f * r));
    for (int i = 0; i < drums; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(drums - 1));
        dmg_spin(b, 0, "figure_drum", v3(x, y, z), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.42f * pitch, y, z), v3(x + 0.42f * pitch, y, z), drum);
        for (int k = 0; k < 5; ++k) {
            float angle = 2.0f * DMG_PI * ((float)k + 0.3f) / 5.0f;
            dmg_box(b, v3(x, y + drum * cosf(angle), z + drum * sinf(angle)),
                    v3(0.4f * pitch, 0.08f * drum, 0.08f * drum));
        }
    }
    dmg_use(b, 0);
    dmg_rod(b, v3(-0.8f * r, y, z), v3(0.8f * r, y, z), 0.1f * drum);
}

/* As narrow as a drum in its window, but flat and longer than it: it slides. */
static void draw_tape(dmg_builder* b, const face* f) {
    float r = f->r, wide = r * dmg_range(b, 0.15f, 0.35f), way = 0.4f * r, x = r * dmg_range(b, -0.3f, 0.3f);
    int tapes = dmg_int(b, 1, 2), ticks = dmg_int(b, 2, 9);
    for (int i = 0; i < tapes; ++i) {
        float at = tapes == 1 ? x : (i == 0 ? -0.4f : 0.4f) * r, span = 0.55f * r;
        for (int k = -1; k <= 1; k += 2) /* what it runs between */
            dmg_box(b, v3(at + (float)k * 0.75f * wide, 0, -0.2f * r), v3(0.3f * wide, 1.5f * r, 0.12f * r));
        uint32_t tape = dmg_slide(b, 0, "tape", v3(0, 1, 0), -way, way);
        dmg_box(b, v3(at, 0, -0.25f * r), v3(wide, 2 * span, 0.03f * r));
        for (int k = 0; k < ticks; ++k)
            dmg_box(b, v3(at - 0.2f * wide, span * (2.0f * ((float)k + 0.5f) / (float)ticks - 1.0f), -0.23f * r),
                    v3(0.5f * wide, 0.03f * r, 0.03f * r));
        dmg_rest(b, tape, way * dmg_range(b, -0.9f, 0.9f));
        dmg_use(b, 0);
        dmg_box(b, v3(at, 0, -0.12f * r), v3(1.6f * wide, 0.04f * r, 0.04f * r));
    }
    dmg_box(b, v3(0, 0, -0.4f * r), v3(1.3f * r, 1.3f * r, 0.04f * r));
}

/* ---- bars that hang at the rim and bars that run on rails; flags; the slip ball ---- */

static void draw_bars(dmg_builder* b, const face* f) {
    float r = f->r, t = 0.04f * r, swing = dmg_range(b, 0.25f, 0.5f), way = 0.35f * r;
    bool rails = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, 0, -0.4f * r), v3(0, 0, -0.3f * r), 0.95f * r);
    for (int i = 0; i < 2; ++i) {
        float z = -0.25f * r + 0.07f * r * (float)i;
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), i == 0 ? 0.0f : 0.5f * DMG_PI);
        uint32_t bar;
        if (rails) {
            dmg_box(b, v3(0, 0.85f * r, z), v3(1.1f * r, t, t));
            bar = dmg_slide(b, 0, "bar", v3(1, 0, 0), -way, way);
            dmg_box(b, v3(0, 0.85f * r, z), v3(4 * t, 2 * t, 1.5f * t));
        } else {
            bar = dmg_hinge(b, 0, "bar", v3(0, 0.85f * r, z), v3(0, 0, 1), -swing, swing);
            dmg_rod(b, v3(0, 0.85f * r, z - 0.8f * t), v3(0, 0.85f * r, z + t), 2 * t);
        }
        dmg_box(b, v3(0, 0.1f * r, z), v3(t, 1.5f * r, 0.6f * t));
        dmg_rest(b, bar, (rails ? way : swing) * dmg_range(b, -0.9f, 0.9f));
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a little plate with its word, on an arm whose pin is off at the rim. */
static void draw_flag(dmg_builder* b, const face* f) {
    float r = f->r, angle = dmg_range(b, 0, 2.0f * DMG_PI), side = dmg_sign(b), z = -0.05f * r;
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), angle);
    dmg_move(b, 0.9f * r, 0, z);
    dmg_hinge(b, 0, "flag", v3(0, 0, 0), v3(0, 0, side), 0.0f, dmg_range(b, 0.5f, 1.2f));
    dmg_rod(b, v3(0, 0, -0.03f * r), v3(0, 0, 0.02f * r), 0.05f * r);
    dmg_box(b, v3(-0.2f * r, 0, 0), v3(0.4f * r, 0.03f * r, 0.02f * r));
    dmg_box(b, v3(-0.42f * r, 0, 0), v3(0.22f * r, 0.16f * r, 0.03f * r));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* The ball runs along a curved tube: it turns about the curve's middle, far above the tube. */
static void draw_slip(dmg_builder* b, const face* f) {
    enum { STEPS = 7 };
    float r = f->r, bend = r * dmg_range(b, 0.8f, 2.2f), half = asinf(fminf(0.5f * r / bend, 0.9f)), ball = 0.09f * r;
    dmg_vec path[STEPS], centre = {0, bend - 0.6f * r, -0.14f * r};
    for (int i = 0; i < STEPS; ++i) {
        float angle = half * (2.0f * (float)i / (STEPS - 1) - 1.0f);
        path[i] = v3_add(centre, v3(bend * sinf(angle), -bend * cosf(angle), -0.08f * r));
    }
    dmg_sweep(b, path, STEPS, ball, 0.3f * ball, false);
    uint32_t slip = dmg_hinge(b, 0, "slip_ball", centre, v3(0, 0, 1), -0.8f * half, 0.8f * half);
    dmg_ellipsoid(b, v3_add(centre, v3(0, -bend, 0)), v3(ball, ball, ball));
    dmg_rest(b, slip, half * dmg_range(b, -0.7f, 0.7f));
    dmg_use(b, 0);
}

/* A turn coordinator: the aeroplane's outline tips about the dial's middle. */
static void draw_turn_indicator(dmg_builder* b, const face* f) {
    float r = f->r, z = -0.2f * r;
    dmg_rod(b, v3(0, 0, -0.4f * r), v3(0, 0, -0.3f * r), 0.95f * r);
    dmg_hinge(b, 0, "aeroplane", v3(0, 0.05f * r, z), v3(0, 0, -1), -0.6f, 0.6f);
    dmg_rod(b, v3(0, 0.05f * r, -0.32f * r), v3(0, 0.05f * r, z + 0.05f * r), 0.12f * r);
    const dmg_xy wing[] = {{-0.8f * r, 0.04f * r}, {0, 0},         {0.8f * r, 0.04f * r},
                           {0.8f * r, 0.08f * r},  {0, 0.12f * r}, {-0.8f * r, 0.08f * r}};
    dmg_extrude(b, wing, 6, z - 0.02f * r, z + 0.03f * r);
    dmg_box(b, v3(0, 0.2f * r, z), v3(0.05f * r, 0.25f * r, 0.04f * r));
    dmg_use(b, 0);
    draw_slip(b, f);
}

void dmg_build_horizon_gauge(dmg_builder* b) {
    face f = {.r = dmg_scale_range(b, 0.02f, 0.12f), .square = dmg_chance(b, 0.5f)};
    int kind = dmg_int(b, 0, 6), corners = dmg_int(b, 0, 2);
    f.depth = f.r * (kind < 3 ? dmg_range(b, 2.0f, 3.5f) : dmg_range(b, 1.3f, 3.0f));
    dmg_move(b, 0, 1.3f * f.r, 0);
    if (dmg_chance(b, 0.15f)) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.2f, 1.2f));
    draw_case(b, &f);
    if (kind <= 1) draw_horizon(b, &f);
    if (kind == 2) draw_float_compass(b, &f);
    if (kind == 3) draw_drums(b, &f);
    if (kind == 4) draw_tape(b, &f);
    if (kind == 5) draw_bars(b, &f);
    if (kind == 6) draw_turn_indicator(b, &f);
    if (dmg_chance(b, kind <= 1 || kind == 5 ? 0.5f : 0.1f)) draw_flag(b, &f);
    if (kind <= 1 && dmg_chance(b, 0.25f)) draw_slip(b, &f);
    for (int i = 0; i < corners; ++i) { /* to set it, to cage it */
        dmg_save(b);
        dmg_move(b, (i == 0 ? 1.05f : -1.05f) * f.r, -1.05f * f.r, 0);
        if (f.round_bezel) dmg_rod(b, v3(0, 0, -0.12f * f.r), v3(0, 0, 0), 0.35f * f.r); /* its ear */
        dmg_control_row_draw(b, dmg_chance(b, 0.4f) ? DMG_CONTROL_PLUNGER : DMG_CONTROL_DIAL, 1, 0, 0.17f * f.r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
