/* Draws spacecraft that land: legs that fold or give way, foot pads, petals, hatches, nozzles in gimbals, dishes and
 * panels. */
#include "core/build.h"
#include "parts/walls.h"
#include "parts/works.h"

typedef struct craft {
    float r, low, high; /* the body: an eight-sided or round drum */
    int legs;
} craft;

/* Draws a leg hung at the body's lower edge; it swings out and down from beside the body, or stands with a pad that
 * tips. */
static void draw_leg(dmg_builder* b, const craft* c, float reach, bool folds, bool slides, bool strut) {
    float t = 0.04f * c->r, top = 0.5f * (c->low + c->high), foot = c->r + reach;
    dmg_box(b, v3(c->r * 0.98f, top, 0), v3(3 * t, 3 * t, 4 * t));
    dmg_vec pin = {c->r + 1.5f * t, top, 0}, end = {foot, 2 * t, 0};
    uint32_t leg = 0;
    if (folds) leg = dmg_hinge(b, 0, "leg", pin, v3(0, 0, 1), 0.0f, 1.9f); /* up and out of the way */
    dmg_vec knee = v3_lerp(pin, end, 0.55f);
    dmg_rod(b, pin, slides ? knee : end, t);
    if (strut && folds)
        dmg_beam(b, v3_add(pin, v3(0, 0, -2 * t)), v3_add(knee, v3(0, 0, -0.5f * t)), 0.6f * t, 0.6f * t);
    if (strut && !folds)
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(0.9f * c->r, c->low + t, (float)k * 0.3f * c->r), slides ? knee : end, 0.5f * t);
    if (slides) {
        leg = dmg_slide(b, leg, "leg_strut", v3_normalize(v3_sub(pin, end)), 0.0f, 0.3f * v3_length(v3_sub(end, pin)));
        dmg_rod(b, v3_lerp(pin, end, 0.45f), end, 0.65f * t);
    }
    if (dmg_chance(b, 0.6f)) dmg_hinge(b, leg, "foot_pad", end, v3(0, 0, dmg_sign(b)), -0.4f, 0.4f);
    const dmg_xy pad[] = {{0, -2 * t}, {3 * t, -2 * t}, {4 * t, -0.8f * t}, {1.2f * t, 0.5f * t}, {0, 0.5f * t}};
    dmg_lathe(b, end, v3(0, 1, 0), pad, 5);
    dmg_use(b, 0);
}

/* Leaves hung round the body's upper or lower edge that lie against it and fold out flat. */
static void draw_petals(dmg_builder* b, const craft* c) {
    int count = dmg_int(b, 3, 6);
    bool below = dmg_chance(b, 0.5f), twice = dmg_chance(b, 0.35f);
    float wide = 2 * c->r * tanf(DMG_PI / (float)count) * 0.85f, t = 0.03f * c->r, high = (c->high - c->low) * 0.94f,
          swing = dmg_range(b, 1.3f, 1.8f), start = dmg_range(b, 0.0f, 1.0f);
    wide = fminf(wide, 1.6f * c->r);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), start);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        float x = c->r * 1.04f, foot = below ? c->low : c->high, dir = below ? 1.0f : -1.0f;
        dmg_rod(b, v3(0.9f * x, foot, 0), v3(x + t, foot, 0), 1.2f * t);
        uint32_t petal = dmg_hinge(b, 0, "petal", v3(x + t, foot, 0), v3(0, 0, -dir), 0.0f, swing);
        dmg_box_span(b, v3(x, fminf(foot, foot + dir * high), -0.5f * wide),
                     v3(x + t, fmaxf(foot, foot + dir * high), 0.5f * wide));
        if (twice) {
            dmg_hinge(b, petal, "panel", v3(x + 1.1f * t, foot + dir * high, 0), v3(0, 0, dir), 0.0f, 3.1f);
            dmg_box_span(b, v3(x + 1.2f * t, fminf(foot + 0.1f * dir * high, foot + dir * high), -0.45f * wide),
                         v3(x + 2 * t, fmaxf(foot + 0.1f * dir * high, foot + dir * high), 0.45f * wide));
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Draws a bell in two rings: each turns about its own line. */
static void draw_gimbal(dmg_builder* b, dmg_vec at, float r) {
    int rings = dmg_int(b, 1, 2);
    float swing = dmg_range(b, 0.1f, 0.3f);
    dmg_rod(b, v3_add(at, v3(0, 0.2f * r, 0)), v3_add(at, v3(0, 0.7f * r, 0)), 0.4f * r);
    uint32_t ring = dmg_hinge(b, 0, "gimbal", at, v3(dmg_sign(b), 0, 0), -swing, swing);
    dmg_ellipsoid(b, at, v3(0.35f * r, 0.35f * r, 0.35f * r));
    if (rings == 2) dmg_torus(b, at, v3(0, 1, 0), 0.5f * r, 0.06f * r);
    if (rings == 2) dmg_hinge(b, ring, "nozzle", at, v3(0, 0, dmg_sign(b)), -swing, swing);
    const dmg_xy bell[] = {{0.9f * r, -1.6f * r},  {r, -1.6f * r},         {0.75f * r, -1.0f * r},
                           {0.25f * r, -0.2f * r}, {0.15f * r, -0.2f * r}, {0.65f * r, -1.0f * r},
                           {0.9f * r, -1.6f * r}};
    dmg_lathe(b, at, v3(0, 1, 0), bell, 7);
    dmg_use(b, 0);
}

/* Draws a dish or a paddle on a mast: pans, tilts. */
static void draw_pointing(dmg_builder* b, dmg_vec at, float r, bool dish) {
    dmg_rod(b, v3_add(at, v3(0, -0.1f * r, 0)), v3_add(at, v3(0, r, 0)), 0.08f * r);
    dmg_vec head = v3_add(at, v3(0, 1.2f * r, 0));
    uint32_t pan = dmg_spin(b, 0, dish ? "dish_pan" : "panel_pan", head, v3(0, dmg_sign(b), 0));
    dmg_box(b, v3_add(head, v3(0, -0.05f * r, 0)), v3(0.3f * r, 0.28f * r, 0.3f * r));
    dmg_hinge_across(b, pan, dish ? "dish" : "panel", head, -0.5f, 1.2f);
    dmg_rod(b, v3_add(head, v3(-0.25f * r, 0, 0)), v3_add(head, v3(0.25f * r, 0, 0)), 0.06f * r);
    dmg_rod(b, head, v3_add(head, v3(0, 0, 0.4f * r)), 0.06f * r);
    const dmg_xy bowl[] = {{0, 0.3f * r},          {0.6f * r, 0.42f * r},  {r, 0.7f * r},
                           {0.97f * r, 0.74f * r}, {0.58f * r, 0.48f * r}, {0, 0.36f * r}};
    if (dish)
        dmg_lathe(b, head, v3(0, 0, 1), bowl, 6);
    else
        dmg_box(b, v3_add(head, v3(0, 0, 0.42f * r)), v3(2.4f * r, 1.2f * r, 0.05f * r));
    dmg_use(b, 0);
}

void dmg_build_lander(dmg_builder* b) {
    craft c = {.r = dmg_scale_range(b, 0.1f, 2.2f)};
    c.legs = dmg_int(b, 3, 4);
    c.low = c.r * dmg_range(b, 0.7f, 1.2f);
    c.high = c.low + c.r * dmg_range(b, 0.5f, 1.4f);
    int shape = dmg_int(b, 0, 2), nozzles = dmg_int(b, 1, 3);
    float reach = c.r * dmg_range(b, 0.3f, 0.9f), bell = c.r * dmg_range(b, 0.18f, 0.28f),
          cap = c.r * dmg_range(b, 0.5f, 1.0f);
    bool folds = dmg_chance(b, 0.6f), slides = dmg_chance(b, 0.5f), strut = dmg_chance(b, 0.7f),
         petals = dmg_chance(b, 0.35f);
    if (petals) dmg_move(b, 0, 2.1f * bell - c.low, 0); /* it stands on its nozzles */
    const dmg_xy drum[] = {
        {0, c.low},           {0.85f * c.r, c.low}, {c.r, c.low + 0.15f * c.r}, {c.r, c.high - 0.1f * c.r},
        {0.9f * c.r, c.high}, {0, c.high}};
    const dmg_xy cone[] = {
        {0, c.low},           {0.95f * c.r, c.low}, {c.r, c.low + 0.1f * c.r}, {c.r, 0.5f * (c.low + c.high)},
        {0.6f * c.r, c.high}, {0, c.high}};
    if (shape == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), drum, 6);
    if (shape == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cone, 6);
    if (shape == 2) dmg_box_span(b, v3(-0.95f * c.r, c.low, -0.95f * c.r), v3(0.95f * c.r, c.high, 0.95f * c.r));
    for (int i = 0; i < c.legs && !petals; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, c.legs);
        draw_leg(b, &c, reach, folds, slides, strut);
        dmg_restore(b);
    }
    if (petals) draw_petals(b, &c);
    for (int i = 0; i < nozzles; ++i) {
        float a = 6.2832f * (float)i / (float)nozzles, out = nozzles > 1 ? 0.5f * c.r : 0.0f;
        draw_gimbal(b, v3(out * cosf(a), c.low - 0.5f * bell, out * sinf(a)), bell);
    }
    if (!petals && shape != 1 && dmg_chance(b, 0.7f)) {
        dmg_wall_enter(b, v3(0, 0.5f * (c.low + c.high), shape == 2 ? 0.95f * c.r : c.r), 0.0f);
        dmg_wall_leaf_draw(b, 0, "hatch", 0.35f * c.r, 0.6f * (c.high - c.low), (dmg_side)dmg_int(b, 0, 3));
        dmg_restore(b);
    }
    float top = shape == 1 ? 0.55f * c.r : 0.85f * c.r;
    if (dmg_chance(b, 0.5f)) { /* a cabin above with a round hatch */
        dmg_cone(b, v3(0, c.high, 0), v3(0, c.high + cap, 0), 0.5f * top, 0.3f * top);
        dmg_roof_enter(b, v3(0, c.high + cap, 0));
        dmg_wall_lid_draw(b, 0, "top_hatch", 0.22f * top);
        dmg_restore(b);
    }
    float wide = c.r * dmg_range(b, 0.15f, 0.3f), x = top - wide;
    if (dmg_chance(b, 0.7f)) draw_pointing(b, v3(x, c.high, -0.2f * c.r), wide, true);
    if (dmg_chance(b, 0.4f)) draw_pointing(b, v3(-x, c.high, 0.1f * c.r), 0.8f * wide, false);
}
