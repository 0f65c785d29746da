/* Draws spaceships as games and films have them: fighters whose wings fold or part, shuttles with a ramp, bay doors
 * and wings that fold up to land, round freighters with mandibles; landing legs, canopies, turrets, dishes, engines
 * that tilt. Ahead is +Z; the belly is at y = 0, the wings spread along X. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- plates in the x, z plane ---- */

/* Draws an outline of (x, z), counter-clockwise seen from below. */
static void draw_flat(dmg_builder* b, const dmg_xy* outline, int count, float y0, float y1) {
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* its y is z, its z goes down */
    dmg_extrude(b, outline, count, -y1, -y0);
    dmg_restore(b);
}

typedef struct plan {
    float span, root, tip, sweep, thick;
} plan;

static plan pick_plan(dmg_builder* b, float span, float root) {
    plan w = {.span = span, .root = root};
    w.tip = root * dmg_range(b, 0.2f, 1.0f);
    w.sweep = root * dmg_range(b, -0.3f, 0.8f);
    w.thick = span * dmg_range(b, 0.03f, 0.1f);
    return w;
}

/* From s0 to s1 of the span, the root's leading edge at the origin, +X outwards. */
static void draw_plan(dmg_builder* b, const plan* w, float s0, float s1) {
    float c0 = w->root + s0 * (w->tip - w->root), c1 = w->root + s1 * (w->tip - w->root);
    float x0 = s0 * w->span, x1 = s1 * w->span, z0 = -s0 * w->sweep, z1 = -s1 * w->sweep;
    const dmg_xy outline[] = {{x0, z0 - c0}, {x1, z1 - c1}, {x1, z1}, {x0, z0}};
    draw_flat(b, outline, 4, -0.5f * w->thick, 0.5f * w->thick);
}

/* ---- wings, both sides alike ---- */

typedef enum wing_kind { WING_FOLDS, WING_PARTS, WING_SWINGS, WING_TIP_FOLDS, WING_FIXED } wing_kind;

/* Draws what is at the tip: a gun, a pod, a fence. */
static void draw_tip(dmg_builder* b, const plan* w, int kind) {
    float x = w->span, z = -w->sweep - 0.5f * w->tip, r = fmaxf(0.8f * w->thick, 0.02f * w->span);
    if (kind == 1) dmg_rod(b, v3(x, 0, z - 0.3f * w->root), v3(x, 0, z + 0.8f * w->root), 0.6f * r);
    if (kind == 2) dmg_capsule(b, v3(x, 0, z - 0.4f * w->root), v3(x, 0, z + 0.4f * w->root), 1.8f * r);
    if (kind == 3) dmg_box(b, v3(x, 0, z), v3(r, 0.3f * w->span, w->tip));
}

static void draw_wing(dmg_builder* b, const plan* w, wing_kind kind, float swing, int tip) {
    float r = 0.7f * w->thick, at = 0.55f, t = w->thick;
    if (kind == WING_FOLDS) {
        dmg_rod(b, v3(0, 0, -0.9f * w->root), v3(0, 0, -0.1f * w->root), r);
        dmg_hinge(b, 0, "wing", v3(0, 0, 0), v3(0, 0, 1), -0.1f, swing);
        draw_plan(b, w, 0, 1);
        draw_tip(b, w, tip);
    }
    for (int k = -1; k <= 1 && kind == WING_PARTS; k += 2) { /* two, one on the other when closed */
        dmg_save(b);
        dmg_move(b, 0, (float)k * 0.55f * t, 0);
        dmg_use(b, 0);
        dmg_hinge(b, 0, "s_foil", v3(0, 0, 0), v3(0, 0, (float)k), 0.0f, 0.35f * swing);
        draw_plan(b, w, 0, 1);
        draw_tip(b, w, tip);
        dmg_restore(b);
    }
    if (kind == WING_SWINGS) {
        dmg_vec pin = {0.1f * w->span, 0, -0.5f * w->root};
        dmg_rod(b, v3_add(pin, v3(0, -1.2f * t, 0)), v3_add(pin, v3(0, 1.2f * t, 0)), 1.2f * t);
        dmg_hinge(b, 0, "wing", pin, v3(0, 1, 0), -0.1f, 0.6f * swing);
        draw_plan(b, w, 0, 1);
        draw_tip(b, w, tip);
    }
    if (kind == WING_TIP_FOLDS || kind == WING_FIXED) draw_plan(b, w, 0, kind == WING_FIXED ? 1 : at);
    if (kind == WING_FIXED) draw_tip(b, w, tip);
    if (kind == WING_TIP_FOLDS) {
        float x = at * w->span, z = -at * w->sweep, chord = w->root + at * (w->tip - w->root);
        dmg_rod(b, v3(x, 0, z - 0.9f * chord), v3(x, 0, z - 0.1f * chord), r);
        dmg_hinge(b, 0, "wing_tip", v3(x, 0, 0), v3(0, 0, 1), -0.3f * swing, swing);
        draw_plan(b, w, at + 0.01f, 1);
        draw_tip(b, w, tip);
    }
    dmg_use(b, 0);
}

/* Their roots at (±x, y), the leading edge at z. */
static void draw_wings(dmg_builder* b, float x, float y, float z, float span, float root, int kinds) {
    plan w = pick_plan(b, span, root);
    wing_kind kind = (wing_kind)dmg_int(b, 0, kinds);
    float swing = dmg_range(b, 0.7f, 1.5f), lean = dmg_range(b, -0.2f, 0.3f);
    int tip = dmg_int(b, 0, 3);
    if (kind == WING_PARTS) lean = 0;
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        if (s < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, x, y, z);
        dmg_turn(b, v3(0, 0, 1), lean);
        draw_wing(b, &w, kind, swing, tip);
        dmg_restore(b);
    }
}

/* ---- landing gear: the foot of a leg at y = -drop, its top at the origin ---- */

static void draw_leg(dmg_builder* b, float drop, float ahead, int kind) {
    float r = 0.07f * drop, foot = drop * dmg_range(b, 0.15f, 0.3f);
    dmg_box_span(b, v3(-3 * r, -2 * r, -3 * r), v3(3 * r, 2 * r, 3 * r));
    uint32_t leg = 0;
    if (kind == 0) {
        leg = dmg_hinge(b, 0, "landing_leg", v3(0, -2 * r, 0), v3(ahead, 0, 0), -1.35f, 0.0f);
        dmg_rod(b, v3(-3.5f * r, -2 * r, 0), v3(3.5f * r, -2 * r, 0), r);
        dmg_beam(b, v3(0, -2 * r, 0), v3(0, -0.95f * drop, 0), 2 * r, 2 * r);
    }
    if (kind == 1) { /* goes up into its sleeve */
        dmg_rod(b, v3(0, -0.5f * drop, 0), v3(0, 0, 0), 1.8f * r);
        leg = dmg_slide(b, 0, "landing_leg", v3(0, 1, 0), 0.0f, 0.35f * drop);
        dmg_rod(b, v3(0, -0.95f * drop, 0), v3(0, -0.4f * drop, 0), r);
    }
    if (kind == 2) dmg_beam(b, v3(0, 0, 0), v3(0, -0.95f * drop, ahead * 0.3f * drop), 2 * r, 2 * r);
    float z = kind == 2 ? ahead * 0.3f * drop : 0.0f;
    if (dmg_chance(b, 0.4f)) dmg_hinge(b, leg, "foot", v3(0, -0.93f * drop, z), v3(1, 0, 0), -0.4f, 0.4f);
    dmg_box(b, v3(0, -0.96f * drop, z), v3(foot, 0.08f * drop, 1.5f * foot));
    dmg_use(b, 0);
}

/* Draws three or four under a belly of half sizes x, z. */
static void draw_gear(dmg_builder* b, float x, float z, float drop) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 1}, 3);
    bool nose = dmg_chance(b, 0.5f);
    for (int i = 0; i < 4; ++i) {
        if (nose && i == 3) break;
        float ahead = i < 2 ? -1.0f : 1.0f, at = i % 2 ? x : -x;
        if (nose && i == 2) at = 0;
        dmg_save(b);
        dmg_move(b, at, 0, ahead * z);
        draw_leg(b, drop, ahead, kind);
        dmg_restore(b);
    }
}

/* ---- things on hulls ---- */

/* On a roof at the origin: a ball or drum that turns, its guns rise. */
static void draw_turret(dmg_builder* b, float r) {
    uint32_t turret = dmg_spin(b, 0, "turret", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    bool drum = dmg_chance(b, 0.5f);
    int guns = dmg_int(b, 1, 2);
    if (drum)
        dmg_rod(b, v3(0, -0.1f * r, 0), v3(0, 0.6f * r, 0), r);
    else
        dmg_dome(b, v3(0, -0.05f * r, 0), v3(r, 0.8f * r, r));
    if (dmg_chance(b, 0.8f))
        dmg_hinge_across(b, turret, "guns", v3(0, 0.4f * r, 0.5f * r), -0.05f, dmg_range(b, 0.6f, 1.4f));
    dmg_box(b, v3(0, 0.4f * r, 0.8f * r), v3(0.8f * r, 0.3f * r, 0.5f * r));
    for (int i = 0; i < guns; ++i) {
        float x = guns > 1 ? (i ? 0.3f : -0.3f) * r : 0.0f;
        dmg_rod(b, v3(x, 0.4f * r, r), v3(x, 0.4f * r, r * 2.4f), 0.1f * r);
    }
    dmg_use(b, 0);
}

/* Draws a dish on a post, turning and nodding. */
static void draw_dish(dmg_builder* b, float r) {
    float y = 0.7f * r;
    uint32_t post = dmg_spin(b, 0, "dish_post", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, -0.2f * r, 0), v3(0, y, 0), 0.12f * r);
    if (dmg_chance(b, 0.7f)) dmg_hinge_across(b, post, "dish", v3(0, y, 0), -0.3f, 0.9f);
    const dmg_xy bowl[] = {{0, 0.05f * r},        {0.6f * r, 0.15f * r},  {r, 0.45f * r},
                           {0.95f * r, 0.5f * r}, {0.55f * r, 0.25f * r}, {0, 0.15f * r}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 0, 1), bowl, 6);
    dmg_rod(b, v3(0, y, 0.1f * r), v3(0, y, 0.7f * r), 0.05f * r);
    dmg_use(b, 0);
}

/* Draws a glass over a seat, its sill at the origin, `length` along z: hung behind, at a side or in front, or sliding.
 */
static void draw_canopy(dmg_builder* b, float half, float length, float high) {
    int kind = dmg_int(b, 0, 3), shape = dmg_int(b, 0, 1);
    float side = dmg_sign(b), swing = dmg_range(b, 0.5f, 1.3f), z = 0.5f * length, t = 0.06f * high;
    dmg_box_span(b, v3(-1.05f * half, -0.3f * high, -1.05f * z), v3(1.05f * half, 0, 1.05f * z));
    if (kind == 0) dmg_hinge(b, 0, "canopy", v3(0, t, -z), v3(-1, 0, 0), 0.0f, swing);
    if (kind == 1) dmg_hinge(b, 0, "canopy", v3(side * half, t, 0), v3(0, 0, -side), 0.0f, swing);
    if (kind == 2) dmg_hinge(b, 0, "canopy", v3(0, t, z), v3(1, 0, 0), 0.0f, swing);
    if (kind == 3) dmg_slide(b, 0, "canopy", v3(0, 0, -1), 0.0f, 0.5f * length);
    const dmg_xy line[] = {{-z, t}, {z, t}, {0.4f * z, 0.8f * high}, {-0.3f * z, high}, {-0.9f * z, 0.6f * high}};
    if (shape == 0)
        dmg_side_prism(b, line, 5, -half, half);
    else
        dmg_ellipsoid(b, v3(0, 0.1f * high, 0), v3(half, 0.8f * high, z));
    if (shape == 1) dmg_box_span(b, v3(-half, 0.01f * high, -z), v3(half, 1.5f * t, z));
    dmg_use(b, 0);
}

/* Draws a leaf under the belly, let down at its far edge as a gangway; steps on it, or rails. */
static void draw_ramp(dmg_builder* b, float half, float length, float drop, float ahead) {
    float t = 0.05f * length, open = asinf(fminf(0.9f, drop / length));
    dmg_hinge(b, 0, "ramp", v3(0, -t, -ahead * 0.5f * length), v3(ahead, 0, 0), 0.0f, open);
    dmg_box_span(b, v3(-half, -1.5f * t, -0.5f * length), v3(half, -0.5f * t, 0.5f * length));
    int ribs = dmg_int(b, 0, 5);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(0, -1.6f * t, length * (((float)i + 0.5f) / (float)ribs - 0.5f)),
                v3(1.8f * half, 0.3f * t, 0.04f * length));
    dmg_use(b, 0);
}

/* Draws two leaves over a bay on a flat face y = 0, hung at the sides; both open outwards. */
static void draw_bay(dmg_builder* b, float half, float length, const char* name) {
    float t = 0.05f * half, swing = dmg_range(b, 1.2f, 2.7f);
    int pieces = dmg_int(b, 1, 2);
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < pieces; ++i) {
            float side = (float)s, step = length / (float)pieces, z = step * ((float)i - 0.5f * (float)(pieces - 1));
            dmg_hinge(b, 0, name, v3(side * half, t, z), v3(0, 0, -side), 0.0f, swing);
            dmg_box_span(b, v3(s > 0 ? 0.02f * half : -half, 0.2f * t, z - 0.49f * step),
                         v3(s > 0 ? half : -0.02f * half, 1.4f * t, z + 0.49f * step));
            dmg_rod(b, v3(side * half, t, z - 0.4f * step), v3(side * half, t, z + 0.4f * step), t);
            dmg_use(b, 0);
        }
}

/* Nozzles at (±x, y, z), on pods that tilt or fixed. */
static void draw_engines(dmg_builder* b, float x, float y, float z, float r) {
    bool tilt = dmg_chance(b, 0.4f);
    float length = r * dmg_range(b, 2.0f, 4.5f), up = dmg_range(b, 0.6f, 1.6f);
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * x;
        const dmg_xy bell[] = {{0, 0.1f * r},          {0.6f * r, 0},         {0.95f * r, -0.6f * r},
                               {0.85f * r, -0.6f * r}, {0.4f * r, -0.1f * r}, {0, -0.1f * r}};
        dmg_use(b, 0);
        if (tilt) {
            dmg_rod(b, v3(at - (float)s * 1.6f * r, y, z), v3(at, y, z), 0.35f * r);
            dmg_hinge_across(b, 0, "engine", v3(at, y, z), -0.2f, up);
        }
        dmg_cone(b, v3(at, y, z - 0.5f * length), v3(at, y, z + 0.5f * length), 0.85f * r, r * 0.8f);
        dmg_save(b);
        dmg_move(b, at, y, z - 0.5f * length);
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), bell, 6);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- ships ---- */

/* Draws a long body of few sides or round. */
static void build_fighter(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.02f, 0.8f), length = r * dmg_range(b, 5.0f, 11.0f), nose = 0.55f * length,
          tail = -0.45f * length, flat = dmg_range(b, 0.6f, 1.0f);
    float waist = dmg_range(b, 0.5f, 1.0f), drop = r * dmg_range(b, 1.2f, 2.0f);
    int shape = dmg_int(b, 0, 2);
    dmg_move(b, 0, drop, 0);
    if (dmg_chance(b, 0.75f)) draw_gear(b, 0.4f * r, shape == 2 ? 0.5f * r : 0.25f * length, drop);
    dmg_move(b, 0, 0.75f * flat * r, 0);
    const dmg_xy facets[] = {{1, 0.3f}, {0.5f, 1}, {-0.5f, 1}, {-1, 0.3f}, {-0.8f, -0.8f}, {0.8f, -0.8f}};
    const dmg_row rows[] = {{0.7f * r, 0.7f * flat * r, 0, tail},
                            {r, flat * r, 0, -0.1f * length},
                            {waist * r, flat * waist * r, 0, 0.2f * length},
                            {0.2f * r, 0.15f * r, -0.1f * r, nose}};
    const dmg_xy round[] = {
        {0, tail}, {0.7f * r, tail}, {r, -0.1f * length}, {waist * r, 0.2f * length}, {0.2f * r, 0.95f * nose},
        {0, nose}};
    if (shape == 0) dmg_loft(b, facets, 6, rows, 4);
    if (shape == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), round, 6);
    if (shape == 2) { /* a ball between panels */
        dmg_ellipsoid(b, v3(0, 0, 0), v3(1.3f * r, 1.2f * r, 1.3f * r));
        dmg_rod(b, v3(-2 * r, 0, 0), v3(2 * r, 0, 0), 0.3f * r);
    }
    bool ball = shape == 2;
    float span = r * dmg_range(b, 2.5f, 6.0f),
          root = ball ? r * dmg_range(b, 1.5f, 3.0f) : length * dmg_range(b, 0.2f, 0.45f);
    draw_wings(b, ball ? 2 * r : 0.95f * r, 0, ball ? 0.5f * root : -0.05f * length, span, root, 4);
    dmg_save(b);
    dmg_move(b, 0, ball ? 1.1f * r : flat * r * (0.5f + 0.45f * waist), ball ? 0 : 0.08f * length);
    draw_canopy(b, 0.5f * r, ball ? r : 0.2f * length, 0.6f * r);
    dmg_restore(b);
    if (!ball && dmg_chance(b, 0.6f)) draw_engines(b, 0.5f * r, 0.35f * r, tail - 0.3f * r, 0.4f * r);
    if (!ball && dmg_chance(b, 0.3f)) {
        dmg_move(b, 0, 0.9f * flat * r, -0.3f * length);
        draw_dish(b, 0.35f * r);
    }
}

/* Draws a slab-sided hull; outline (z, y). */
static void build_shuttle(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.04f, 3.0f), high = half * dmg_range(b, 0.9f, 1.8f),
          length = half * dmg_range(b, 3.5f, 7.0f), nose = 0.5f * length, tail = -0.5f * length,
          drop = half * dmg_range(b, 0.6f, 1.4f), chin = dmg_range(b, 0.15f, 0.5f);
    float brow = nose - length * dmg_range(b, 0.12f, 0.3f), t = 0.05f * half;
    dmg_move(b, 0, drop, 0);
    const dmg_xy side[] = {{tail, 0}, {0.9f * nose, 0}, {nose, chin * high}, {brow, high}, {tail, high}};
    dmg_side_prism(b, side, 5, -half, half);
    draw_gear(b, 0.75f * half, 0.38f * length, drop);
    int entry = dmg_int(b, 0, 3);
    if (entry == 0) draw_ramp(b, 0.5f * half, 0.32f * length, drop, 1);
    if (entry == 1) { /* the stern is let down */
        dmg_hinge(b, 0, "ramp", v3(0, t, tail - t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.6f, 2.1f));
        dmg_box_span(b, v3(-0.8f * half, 0.5f * t, tail - 1.5f * t), v3(0.8f * half, 0.85f * high, tail - 0.2f * t));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1 && entry == 2; s += 2) { /* doors in the sides */
        float x = (float)s * (half + 0.6f * t), z = 0.1f * length, wide = 0.08f * length;
        if (dmg_chance(b, 0.5f))
            dmg_slide(b, 0, "side_door", v3(0, 0, -1), 0.0f, 1.8f * wide);
        else
            dmg_hinge(b, 0, "gull_door", v3(x, 0.8f * high, z), v3(0, 0, (float)s), 0.0f, dmg_range(b, 1.0f, 2.2f));
        dmg_box_span(b, v3(x - 0.5f * t, 0.1f * high, z - wide), v3(x + 0.5f * t, 0.8f * high, z + wide));
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, 0, high, -0.08f * length);
    if (entry == 3 || dmg_chance(b, 0.4f))
        draw_bay(b, 0.8f * half, 0.5f * length, "bay_door");
    else if (dmg_chance(b, 0.6f))
        dmg_box_span(b, v3(-t, 0, -0.4f * length), v3(t, high * 1.2f, -0.2f * length)); /* a fin */
    else
        draw_turret(b, 0.4f * half);
    dmg_restore(b);
    float shoulder = high * dmg_range(b, 0.3f, 0.9f), span = half * dmg_range(b, 1.5f, 4.0f);
    draw_wings(b, half, shoulder, -0.05f * length, span, 0.35f * length, 3);
    if (entry != 1 && dmg_chance(b, 0.5f)) draw_engines(b, 0.5f * half, 0.5f * high, tail - 0.3f * half, 0.35f * half);
}

/* Draws a disc with a rim, two arms ahead, a cockpit at its side. */
static void build_freighter(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.08f, 6.0f), high = r * dmg_range(b, 0.15f, 0.35f),
          drop = r * dmg_range(b, 0.25f, 0.5f), edge = high * dmg_range(b, 0.2f, 0.5f),
          roof = r * dmg_range(b, 0.25f, 0.5f), side = dmg_sign(b);
    const dmg_xy hull[] = {{0, 0},       {roof, 0}, {r, 0.5f * high - 0.5f * edge}, {r, 0.5f * high + 0.5f * edge},
                           {roof, high}, {0, high}};
    dmg_move(b, 0, drop, 0);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), hull, 6);
    if (dmg_chance(b, 0.7f)) {
        const dmg_xy arm[] = {{0.15f * r, 0.8f * r}, {0.6f * r, 0.7f * r}, {0.4f * r, 1.6f * r}, {0.15f * r, 1.6f * r}};
        draw_flat(b, arm, 4, 0.35f * high, 0.65f * high);
        dmg_save(b);
        dmg_mirror(b, v3(1, 0, 0));
        draw_flat(b, arm, 4, 0.35f * high, 0.65f * high);
        dmg_restore(b);
    }
    dmg_beam(b, v3(0, 0.5f * high, 0), v3(side * 1.05f * r, 0.5f * high, 0.5f * r), 0.25f * r, 0.8f * edge);
    dmg_cone(b, v3(side * 1.05f * r, 0.5f * high, 0.4f * r), v3(side * 1.05f * r, 0.5f * high, 0.85f * r), 0.15f * r,
             0.08f * r);
    draw_gear(b, 0.5f * roof, 0.5f * roof, drop);
    dmg_save(b);
    dmg_move(b, 0, 0, -roof - 0.02f * r); /* a gangway in the sloping underside, level all the same */
    dmg_box_span(b, v3(-0.14f * r, 0, -0.3f * r), v3(0.14f * r, 0.5f * high, 0.3f * r));
    draw_ramp(b, 0.12f * r, 0.55f * r, drop, dmg_sign(b));
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    draw_turret(b, 0.6f * roof * dmg_range(b, 0.5f, 1.2f));
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) {
        dmg_save(b);
        dmg_move(b, -side * 0.6f * r, 0.72f * high, 0.3f * r);
        draw_dish(b, r * dmg_range(b, 0.08f, 0.16f));
        dmg_restore(b);
    }
    if (!dmg_chance(b, 0.6f)) return;
    float z = 0.97f * r; /* a ring to dock by, its hatch turns aside */
    dmg_move(b, -side * z, 0.5f * high, 0);
    dmg_turn(b, v3(0, 1, 0), -side * 0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.12f * r), 0.14f * r);
    dmg_hinge(b, 0, "hatch", v3(0.13f * r, 0, 0.135f * r), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    dmg_rod(b, v3(0, 0, 0.122f * r), v3(0, 0, 0.15f * r), 0.12f * r);
}

void dmg_build_starship(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 4, 2}, 3);
    if (kind == 0) build_fighter(b);
    if (kind == 1) build_shuttle(b);
    if (kind == 2) build_freighter(b);
    dmg_use(b, 0);
}
