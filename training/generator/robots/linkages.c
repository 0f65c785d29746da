/* Draws bare linkages: claws, legs of plain bars driven by discs, brackets. Links are plain shapes that run into
 * each other at their ends: no hub shows where they turn. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a straight link: box, rod, tapered, rounded box, open channel. It reaches beyond both pivots by `over`. */
static void draw_bar(dmg_builder* b, int kind, dmg_vec from, dmg_vec to, float wide, float deep, float over) {
    dmg_vec along = v3_normalize(v3_sub(to, from));
    dmg_vec start = v3_mad(from, along, -over), end = v3_mad(to, along, over);
    if (kind == 0 || kind == 3) dmg_beam(b, start, end, wide, deep);
    if (kind == 1) dmg_rod(b, start, end, 0.5f * fminf(wide, deep));
    if (kind == 2) dmg_cone(b, start, end, 0.6f * wide, 0.35f * wide);
    if (kind == 3) dmg_ellipsoid(b, end, v3(0.6f * wide, 0.6f * wide, 0.6f * wide));
    if (kind == 4)
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec u, w;
            v3_basis(along, &u, &w);
            dmg_beam(b, v3_mad(start, u, (float)s * 0.4f * wide), v3_mad(end, u, (float)s * 0.4f * wide), 0.2f * wide,
                     deep);
        }
}

/* ---- claws: the palm's face is z = 0, fingers reach to +Z and turn about Y ---- */

typedef struct claw {
    int fingers, links, bar;
    float palm, length, wide, deep;
    float spread; /* how far open it is drawn: the first link leans out by this */
    float over;
    bool parallel, slides;
} claw;

static claw pick_claw(dmg_builder* b, float palm) {
    claw c = {.palm = palm, .fingers = dmg_chance(b, 0.7f) ? 2 : dmg_int(b, 3, 4), .bar = dmg_int(b, 0, 4)};
    c.links = dmg_int(b, 1, 3);
    c.length = palm * dmg_range(b, 0.4f, 2.0f);
    c.wide = palm * dmg_range(b, 0.1f, 0.35f);
    c.deep = palm * dmg_range(b, 0.1f, 0.5f);
    c.spread = dmg_chance(b, 0.5f) ? dmg_range(b, 0.0f, 0.5f) : dmg_range(b, 0.5f, 1.4f);
    c.over = dmg_chance(b, 0.5f) ? 0.0f : 0.5f * c.wide;
    c.parallel = c.links > 1 && dmg_chance(b, 0.25f);
    c.slides = dmg_chance(b, 0.25f);
    return c;
}

/* Links one after another at +X, each bent inwards from the one before. */
static void draw_claw_finger(dmg_builder* b, uint32_t palm, const claw* c, float swing) {
    float lean = c->spread, x = 0.4f * c->palm, each = c->length / (float)c->links;
    dmg_vec at = {x, 0, -0.3f * c->over};
    uint32_t carrier = palm;
    if (c->slides) {
        dmg_slide(b, palm, "finger", v3(-1, 0, 0), -0.1f * x, 0.7f * (x - 0.5f * c->wide));
        dmg_box(b, v3(x, 0, 0.5f * c->length), v3(c->wide, c->deep, c->length));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(x, 0, 0.05f * c->length), v3(2 * c->wide, c->deep, 0.1f * c->length));
        dmg_use(b, palm);
        return;
    }
    for (int i = 0; i < c->links; ++i) {
        dmg_vec along = {sinf(lean), 0, cosf(lean)}, to = v3_mad(at, along, each);
        uint32_t link = dmg_hinge(b, carrier, i ? "finger_tip" : "finger", at, v3(0, -1, 0), -swing, swing);
        if (dmg_chance(b, 0.5f)) {
            b->parts[link - 1].joint.lower = 0.0f; /* drawn fully open */
            b->parts[link - 1].joint.upper = fmaxf(swing, 0.3f);
        }
        draw_bar(b, c->bar, at, to, c->wide * (i ? 0.85f : 1.0f), c->deep * (i ? 0.9f : 1.0f), c->over);
        carrier = link;
        at = to;
        lean = c->parallel ? 0.0f : lean - dmg_range(b, 0.2f, 0.9f);
    }
    if (c->parallel && dmg_chance(b, 0.6f)) { /* the second bar of the parallelogram */
        float side = c->wide * 1.3f;
        dmg_vec root = {x + side, 0, 0.1f * c->length}, along = {sinf(c->spread), 0, cosf(c->spread)};
        dmg_hinge(b, palm, "link", root, v3(0, -1, 0), -swing, swing);
        draw_bar(b, c->bar, root, v3_mad(root, along, each), 0.5f * c->wide, 0.5f * c->deep, c->over);
    }
    dmg_use(b, palm);
}

static void draw_claw(dmg_builder* b, uint32_t palm, const claw* c) {
    float p = c->palm, swing = dmg_range(b, 0.25f, 0.9f);
    dmg_use(b, palm);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_box(b, v3(0, 0, -0.3f * p), v3(p, fmaxf(1.2f * c->deep, 0.3f * p), 0.6f * p));
    if (kind == 1) dmg_rod(b, v3(0, 0, -0.4f * p), v3(0, 0, 0), 0.55f * p);
    if (kind == 2) dmg_cone(b, v3(0, 0, -0.6f * p), v3(0, 0, 0), 0.25f * p, 0.55f * p);
    if (kind == 3) { /* six-sided */
        dmg_xy outline[6];
        for (int i = 0; i < 6; ++i)
            outline[i] =
                (dmg_xy){0.55f * p * cosf(DMG_PI / 3.0f * (float)i), 0.55f * p * sinf(DMG_PI / 3.0f * (float)i)};
        dmg_extrude(b, outline, 6, -0.4f * p, 0.02f * p);
    }
    for (int i = 0; i < c->fingers; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, c->fingers);
        draw_claw_finger(b, palm, c, swing);
        dmg_restore(b);
    }
}

/* On a post it climbs, on a rod that reaches out of a body, on a wrist, or standing on its back. */
void dmg_build_claw(dmg_builder* b) {
    float palm = dmg_scale_range(b, 0.03f, 0.5f);
    claw c = pick_claw(b, palm);
    int mount = dmg_int(b, 0, 3);
    uint32_t carrier = 0;
    if (mount == 0) {
        float high = palm * dmg_range(b, 2.0f, 10.0f), thick = palm * dmg_range(b, 0.2f, 0.6f),
              at = dmg_range(b, 0.5f, 1.0f) * palm;
        dmg_box(b, v3(0, 0.5f * high, -0.6f * palm - 0.5f * thick), v3(thick, high, thick));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.03f * palm, -0.6f * palm), v3(2 * palm, 0.06f * palm, 2 * palm));
        dmg_move(b, 0, at, 0);
        carrier = dmg_slide(b, 0, "riser", v3(0, 1, 0), 0.0f, 0.9f * (high - at));
    }
    if (mount == 1) {
        float size = palm * dmg_range(b, 1.5f, 5.0f), reach = palm * dmg_range(b, 0.5f, 3.0f);
        bool round = dmg_chance(b, 0.5f);
        if (round) dmg_rod(b, v3(0, 0, 0), v3(0, 1.6f * size, 0), 0.5f * size);
        if (!round) dmg_box(b, v3(0, 0.8f * size, 0), v3(size, 1.6f * size, size));
        dmg_move(b, 0, size * dmg_range(b, 0.7f, 1.3f), 0.5f * size + reach + 0.5f * palm);
        carrier = dmg_slide(b, 0, "extension", v3(0, 0, 1), -0.8f * reach, dmg_range(b, 0.0f, 0.3f) * reach);
        dmg_rod(b, v3(0, 0, -0.8f * size - reach), v3(0, 0, -0.3f * palm), palm * dmg_range(b, 0.1f, 0.3f));
    }
    if (mount >= 2) {
        dmg_move(b, 0, 1.5f * palm + c.length, 0);
        if (mount == 2) dmg_turn(b, v3(1, 0, 0), dmg_sign(b) * 0.5f * DMG_PI);
        dmg_rod(b, v3(0, 0, -1.4f * palm), v3(0, 0, -0.3f * palm), palm * dmg_range(b, 0.2f, 0.5f));
        if (dmg_chance(b, 0.4f)) carrier = dmg_spin(b, 0, "wrist", v3(0, 0, 0), v3(0, 0, 1));
    }
    draw_claw(b, carrier, &c);
    dmg_use(b, 0);
}

/* ---- legs of plain bars ---- */

/* Draws two discs side by side drive a thigh each; the shins meet at the foot. out: to the body's side is +X. */
static void draw_bar_leg(dmg_builder* b, int bar, float disc, float thigh, float shin, float t, float bend, int pair) {
    bool endless = dmg_chance(b, 0.5f);
    for (int k = 0; k < pair; ++k) {
        float x = ((float)k + 0.6f) * 2.2f * t, sign = k ? -1.0f : 1.0f, own = bend * sign;
        dmg_vec hip = {x, 0, 0}, knee = {x + 0.2f * t, -thigh * cosf(own), -thigh * sinf(own)},
                foot = {x, knee.y - shin * cosf(0.7f * own), knee.z + shin * sinf(0.7f * own)};
        uint32_t upper = endless ? dmg_spin(b, 0, "motor", hip, v3(1, 0, 0))
                                 : dmg_hinge(b, 0, "motor", hip, v3(sign, 0, 0), -dmg_range(b, 0.5f, 1.6f), 1.2f);
        if (disc > 0) dmg_rod(b, v3(x - 0.8f * t, 0, 0), v3(x + 0.8f * t, 0, 0), disc);
        draw_bar(b, bar, hip, knee, 0.8f * t, t, 0.3f * t);
        dmg_hinge_either_way(b, upper, "knee", knee, v3(-sign, 0, 0), 0.4f, 1.2f);
        draw_bar(b, bar, knee, foot, 0.7f * t, 0.8f * t, 0.2f * t);
        if (dmg_chance(b, 0.3f)) dmg_ellipsoid(b, foot, v3(0.6f * t, 0.6f * t, 0.6f * t));
        dmg_use(b, 0);
    }
}

/* A body with legs that hang, stand up straight or squat: bars in line show nothing of their joints. */
void dmg_build_bar_legs(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.1f, 1.5f), width = length * dmg_range(b, 0.3f, 0.7f),
          high = length * dmg_range(b, 0.08f, 0.3f), t = length * dmg_range(b, 0.02f, 0.06f);
    float thigh = length * dmg_range(b, 0.2f, 0.6f), shin = thigh * dmg_range(b, 0.8f, 2.0f),
          disc = dmg_chance(b, 0.6f) ? length * dmg_range(b, 0.05f, 0.12f) : 0.0f;
    int bar = dmg_int(b, 0, 4), pairs = dmg_int(b, 1, 3), both = dmg_int(b, 1, 2), shape = dmg_int(b, 0, 2);
    bool raised = dmg_chance(b, 0.3f);
    float bend = dmg_chance(b, 0.4f) ? 0.02f : dmg_range(b, 0.1f, 1.1f),
          splay = dmg_chance(b, 0.3f) ? dmg_range(b, 0, 0.2f) : 0.0f;
    dmg_move(b, 0, raised ? disc + high : thigh + shin + 0.5f * high, 0);
    if (shape == 0) dmg_box(b, v3(0, 0, 0), v3(width, high, length));
    if (shape == 1)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.3f * width, 0, 0), v3(0.4f * width, high, length * dmg_range(b, 0.9f, 1.0f)));
    if (shape == 1) dmg_box(b, v3(0, 0, 0), v3(0.5f * width, 0.6f * high, 0.7f * length));
    if (shape == 2) dmg_rounded_box(b, v3(0, 0, 0), v3(width, high, length), 0.3f * high);
    for (int i = 0; i < 2 * pairs; ++i) {
        float z = pairs == 1 ? 0.0f : 0.42f * length * (2.0f * (float)(i / 2) / (float)(pairs - 1) - 1.0f);
        dmg_save(b);
        if (i % 2) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.5f * width, 0, z);
        dmg_turn(b, v3(0, 0, 1), splay);
        if (raised) dmg_turn(b, v3(1, 0, 0), DMG_PI);
        draw_bar_leg(b, bar, disc, thigh, shin, t, bend, both);
        dmg_restore(b);
    }
}

/* ---- humanoid figures ---- */

static void draw_limb(dmg_builder* b, int bar, uint32_t carrier, const char* const names[2], dmg_vec root, float upper,
                      float lower, float t, float bend) {
    dmg_vec joint = v3_add(root, v3(0, -upper, 0)), end = v3_add(joint, v3(0, -lower * cosf(bend), lower * sinf(bend)));
    const float forth = dmg_range(b, 0.6f, 2.0f), back = -dmg_range(b, 0.3f, 1.2f);
    uint32_t first = dmg_hinge(b, carrier, names[0], root, v3(-1, 0, 0), back, forth);
    draw_bar(b, bar, root, joint, t, t, 0.4f * t);
    dmg_hinge(b, first, names[1], joint, v3(bend < 0 ? 1.0f : -1.0f, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.2f));
    draw_bar(b, bar, joint, end, 0.85f * t, 0.85f * t, 0.3f * t);
    if (bend < 0) dmg_box(b, v3_add(end, v3(0, -0.3f * t, 0.5f * t)), v3(t, 0.6f * t, 2.2f * t));
    if (bend >= 0 && dmg_chance(b, 0.5f)) dmg_ellipsoid(b, end, v3(0.7f * t, 0.8f * t, 0.5f * t));
    dmg_use(b, carrier);
}

void dmg_build_humanoid(dmg_builder* b) {
    float high = dmg_scale_range(b, 0.2f, 2.0f), leg = 0.24f * high, t = high * dmg_range(b, 0.04f, 0.08f),
          shoulder = high * dmg_range(b, 0.11f, 0.17f), hip = high * dmg_range(b, 0.05f, 0.1f),
          arm = high * dmg_range(b, 0.15f, 0.2f);
    static const char* const arms[2] = {"shoulder", "elbow"};
    static const char* const legs[2] = {"hip", "knee"};
    int bar = dmg_int(b, 0, 3), chest = dmg_int(b, 0, 2);
    float waist = 2 * leg + 0.03f * high, top = waist + 0.32f * high;
    uint32_t torso = 0;
    dmg_box(b, v3(0, waist, 0), v3(2.2f * hip, 0.1f * high, 1.5f * t));
    for (int s = -1; s <= 1; s += 2)
        draw_limb(b, bar, 0, legs, v3((float)s * hip, waist - 0.03f * high, 0), leg, leg, t, -0.05f);
    if (dmg_chance(b, 0.4f)) torso = dmg_hinge(b, 0, "waist", v3(0, waist, 0), v3(0, 1, 0), -1.0f, 1.0f);
    dmg_use(b, torso);
    dmg_rod(b, v3(0, waist, 0), v3(0, waist + 0.1f * high, 0), 0.8f * t);
    dmg_vec middle = {0, 0.5f * (waist + top) + 0.04f * high, 0},
            size = {2 * shoulder - t, top - waist - 0.06f * high, 2 * t};
    if (chest == 0) dmg_box(b, middle, size);
    if (chest == 1) dmg_rounded_box(b, middle, size, 0.6f * t);
    if (chest == 2) dmg_ellipsoid(b, middle, v3(0.55f * size.x, 0.55f * size.y, 0.6f * size.z));
    for (int s = -1; s <= 1; s += 2)
        draw_limb(b, bar, torso, arms, v3((float)s * (shoulder + 0.2f * t), top - 0.06f * high, 0), arm, arm, 0.8f * t,
                  dmg_range(b, 0.0f, 1.3f));
    bool nods = dmg_chance(b, 0.4f);
    float neck = top + 0.02f * high;
    dmg_hinge(b, torso, "head", v3(0, neck, 0), nods ? v3(1, 0, 0) : v3(0, 1, 0), -0.8f, 0.8f);
    dmg_rod(b, v3(0, top - 0.04f * high, 0), v3(0, neck + 0.04f * high, 0), 0.5f * t);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(0, neck + 0.08f * high, 0), v3(0.055f * high, 0.07f * high, 0.06f * high));
    else
        dmg_box(b, v3(0, neck + 0.08f * high, 0), v3(0.1f * high, 0.11f * high, 0.1f * high));
    dmg_use(b, 0);
}

/* ---- brackets ---- */

/* Draws what sticks to a table, a wall or a screen. */
static void draw_bracket_foot(dmg_builder* b, float size) {
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) dmg_dome(b, v3(0, 0, 0), v3(size, dmg_range(b, 0.2f, 0.5f) * size, size)); /* a sucker */
    if (kind == 1) dmg_box(b, v3(0, 0.08f * size, 0), v3(1.6f * size, 0.16f * size, 1.6f * size));
    if (kind == 2) dmg_rod(b, v3(0, 0, 0), v3(0, 0.2f * size, 0), 0.9f * size);
    if (kind == 3) { /* a clamp round an edge */
        const dmg_xy jaw[] = {{-0.6f * size, 0.3f * size},
                              {0.4f * size, 0.3f * size},
                              {0.4f * size, -0.8f * size},
                              {-0.6f * size, -0.8f * size}};
        dmg_bent_plate(b, jaw, 4, 0.12f * size, 0.8f * size);
    }
    if (kind == 4) dmg_cone(b, v3(0, 0, 0), v3(0, 0.6f * size, 0), 0.8f * size, 0.25f * size);
}

/* Draws a sheet bent into a profile and as wide as what it holds. */
static void draw_cradle(dmg_builder* b, float size, float wide) {
    int kind = dmg_int(b, 0, 3);
    float t = size * dmg_range(b, 0.05f, 0.15f), h = size * dmg_range(b, 0.6f, 1.4f),
          d = size * dmg_range(b, 0.3f, 0.9f), lean = size * dmg_range(b, -0.4f, 0.4f);
    const dmg_xy ell[] = {{d, 0}, {0, 0}, {-lean, h}}, channel[] = {{d, 0.4f * h}, {d, 0}, {0, 0}, {-lean, h}},
                 zed[] = {{0, 0}, {0.3f * d, 0.3f * h}, {d, 0.3f * h}, {d, h}},
                 hook[] = {{d, 0.5f * h}, {0.8f * d, 0}, {0.1f * d, 0.1f * h}, {0, 0.9f * h}, {0.5f * d, h}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the profile's x becomes z */
    if (kind == 0) dmg_bent_plate(b, ell, 3, t, wide);
    if (kind == 1) dmg_bent_plate(b, channel, 4, t, wide);
    if (kind == 2) dmg_bent_plate(b, zed, 4, t, wide);
    if (kind == 3) dmg_bent_plate(b, hook, 5, t, wide);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) /* what lies in it */
        dmg_box(b, v3(0, 0.6f * h, 0.3f * d + t), v3(0.9f * wide, 0.8f * h, 0.3f * d));
}

/* A foot, a neck that turns, arms that bend, a cradle that nods: each may be missing, most joints hidden. */
void dmg_build_bracket(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.02f, 0.5f), foot = size * dmg_range(b, 0.3f, 0.9f),
          t = size * dmg_range(b, 0.06f, 0.2f), wide = size * dmg_range(b, 0.5f, 1.8f);
    int arms = dmg_int(b, 0, 2), bar = dmg_int(b, 0, 4);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(1, 0, 0), dmg_range(b, 0.3f, 1.57f)); /* on a wall or a screen */
    draw_bracket_foot(b, foot);
    float neck = foot * dmg_range(b, 0.2f, 0.6f);
    uint32_t carrier = 0;
    if (arms == 0 || dmg_chance(b, 0.6f))
        carrier = dmg_chance(b, 0.3f) ? dmg_spin(b, 0, "swivel", v3(0, 0, 0), v3(0, 1, 0))
                                      : dmg_hinge_either_way(b, 0, "swivel", v3(0, 0, 0), v3(0, 1, 0), 0.3f, 3.1f);
    if (carrier) { /* the neck: it turns, or a cradle turns on it */
        if (arms == 0 && !dmg_chance(b, 0.4f)) dmg_use(b, 0);
        dmg_rod(b, v3(0, 0.1f * neck, 0), v3(0, neck + 0.5f * t, 0), 0.8f * t);
        dmg_use(b, carrier);
    }
    dmg_vec at = {0, neck, 0};
    float lean = dmg_range(b, -0.6f, 0.6f);
    for (int i = 0; i < arms; ++i) {
        dmg_vec along = {0, cosf(lean), sinf(lean)}, to = v3_mad(at, along, size * dmg_range(b, 0.6f, 1.5f));
        const float upper = dmg_range(b, 0.2f, 0.9f), lower = -dmg_range(b, 0.2f, 0.9f);
        const dmg_vec axis = v3(dmg_sign(b), 0, 0);
        carrier = dmg_hinge(b, carrier, "arm", at, axis, lower, upper);
        draw_bar(b, bar, at, to, t, 1.4f * t, 0.4f * t);
        at = to;
        lean += dmg_range(b, -1.5f, 1.5f);
    }
    dmg_move(b, 0, at.y, at.z);
    if (arms > 0 && dmg_chance(b, 0.8f)) {
        bool turns = dmg_chance(b, 0.3f);
        carrier =
            dmg_hinge_either_way(b, carrier, "cradle", v3(0, 0, 0), turns ? v3(0, 1, 0) : v3(1, 0, 0), 0.2f, 0.8f);
    }
    dmg_use(b, carrier);
    dmg_move(b, 0, 0.2f * t, dmg_chance(b, 0.5f) ? -size * dmg_range(b, 0.1f, 0.5f) : 0.0f);
    draw_cradle(b, size, wide);
    dmg_use(b, 0);
}
