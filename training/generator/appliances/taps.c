/* Draws mixer taps and lever valves: a cap with a lever that turns both ways on a pillar, or a large lever on a
 * small stem. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- shared shapes ---- */

/* Draws a pillar's or cap's section, round or square, from y = low to y = high. */
static void draw_pillar(dmg_builder* b, bool square, float radius, float low, float high) {
    if (square)
        dmg_box(b, v3(0, 0.5f * (low + high), 0), v3(2 * radius, high - low, 2 * radius));
    else
        dmg_rod(b, v3(0, low, 0), v3(0, high, 0), radius);
}

/* Draws an arm from the origin over (0, rise, reach): a tube, a flat bar, a swan's neck or a beam that droops at its
 * end. */
static void draw_neck(dmg_builder* b, int kind, float radius, float rise, float reach) {
    enum { POINTS = 10 };
    dmg_vec path[POINTS];
    float wide = radius * dmg_range(b, 1.0f, 1.8f);
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, rise, reach), radius);
    if (kind == 1) dmg_beam(b, v3(0, 0, 0), v3(0, rise, reach), 2 * wide, 1.6f * radius);
    for (int i = 0; i < POINTS; ++i) {
        float s = (float)i / (POINTS - 1), angle = DMG_PI * s;
        path[i] = kind == 2 ? v3(0, rise * sinf(angle) + 0.2f * rise * s, 0.5f * reach * (1.0f - cosf(angle)))
                            : v3(0, rise * (1.6f * s - 0.9f * s * s * s), reach * s);
    }
    if (kind >= 2) dmg_sweep(b, path, POINTS, radius, kind == 2 ? radius : wide, false);
    if (kind <= 1 && dmg_chance(b, 0.4f)) /* where the water comes out */
        dmg_rod(b, v3(0, rise - 1.5f * radius, 0.93f * reach), v3(0, rise, 0.93f * reach), 0.7f * radius);
}

/* Draws a lever from the top of a cap towards +Z, lifted at least by the given slope. */
static void draw_lever(dmg_builder* b, int kind, float radius, float length, float slope) {
    float lift = length * dmg_range(b, slope, 0.8f), thin = radius * dmg_range(b, 0.15f, 0.4f);
    dmg_vec tip = {0, lift, length};
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), tip, thin);
    if (kind == 1) dmg_beam(b, v3(0, 0, 0), tip, 2.5f * thin, thin);
    if (kind == 2) { /* a thicker grip at the end */
        dmg_rod(b, v3(0, 0, 0), v3_scale(tip, 0.45f), 0.7f * thin);
        dmg_cone(b, v3_scale(tip, 0.4f), tip, 1.1f * thin, 1.5f * thin);
        dmg_ellipsoid(b, tip, v3(1.5f * thin, 1.5f * thin, 1.5f * thin));
    }
    if (kind == 3) { /* a paddle that grows out of the cap */
        const dmg_vec path[] = {{0, -0.3f * radius, -0.4f * radius},
                                {0, 0.2f * lift, 0.3f * length},
                                {0, 0.6f * lift, 0.7f * length},
                                {0, lift, length}};
        dmg_sweep(b, path, 4, 0.35f * radius, 0.9f * radius, false);
    }
    if (kind == 4) { /* a loop */
        const dmg_vec path[] = {{-0.7f * radius, 0, 0},
                                {-0.7f * radius, lift, length},
                                {0.7f * radius, lift, length},
                                {0.7f * radius, 0, 0}};
        dmg_sweep(b, path, 4, thin, thin, false);
    }
}

/* ---- mixer ---- */

typedef struct mixer {
    bool square;
    float radius, top, reach, rise;
    int neck;
} mixer;

static mixer pick_mixer(dmg_builder* b) {
    mixer m = {.square = dmg_chance(b, 0.25f), .neck = dmg_int(b, 0, 3)};
    m.reach = dmg_range(b, 0.1f, 0.3f);
    m.radius = m.reach * dmg_range(b, 0.08f, 0.24f);
    m.top = m.reach * dmg_range(b, 0.25f, 1.1f);
    m.rise = m.reach * dmg_range(b, 0.0f, 0.9f);
    return m;
}

/* Draws the cap and its lever, from y = 0 up: to and fro about the pillar, or tipped up at its back. */
static void draw_cap(dmg_builder* b, const mixer* m) {
    float cap = m->radius * dmg_range(b, 0.85f, 1.25f), high = cap * dmg_scale_range(b, 0.15f, 1.6f),
          length = m->reach * dmg_scale_range(b, 0.25f, 1.1f), swing = dmg_range(b, 0.5f, 1.8f), gap = 0.1f * m->radius,
          lean = dmg_range(b, 0.0f, 0.5f);
    int lever = dmg_int(b, 0, 4);
    bool tipped = dmg_chance(b, 0.1f), leaning = dmg_chance(b, 0.2f);
    if (dmg_chance(b, 0.5f)) draw_pillar(b, m->square, 0.85f * m->radius, -0.2f * m->radius, gap);
    dmg_move(b, 0, gap, 0);
    if (leaning) dmg_turn(b, v3(1, 0, 0), dmg_sign(b) * lean); /* the whole cartridge leans, its axis with it */
    uint32_t part = tipped ? dmg_hinge(b, 0, "lever", v3(0, 0.3f * high, -0.5f * cap), v3(-1, 0, 0), 0.0f, 0.6f * swing)
                           : dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 1, 0), -swing, swing);
    if (lever == 3 && dmg_chance(b, 0.7f))
        dmg_ellipsoid(b, v3(0, 0.5f * high, 0), v3(cap, 0.5f * high + 0.3f * cap, cap));
    else
        draw_pillar(b, m->square, cap, 0, high);
    dmg_move(b, 0, high * dmg_range(b, 0.5f, 1.0f), 0);
    if (dmg_chance(b, 0.15f)) dmg_turn(b, v3(0, 1, 0), dmg_range(b, -DMG_PI, DMG_PI));
    draw_lever(b, lever, cap, length, m->rise / m->reach);
    if (!tipped && dmg_chance(b, 0.35f)) dmg_rest(b, part, swing * dmg_range(b, -1.0f, 1.0f));
}

/* Draws the handle on the pillar's side, about a level line. */
static void draw_side_handle(dmg_builder* b, const mixer* m) {
    float side = dmg_sign(b), cap = m->radius * dmg_range(b, 0.6f, 1.0f), out = cap * dmg_range(b, 0.8f, 2.5f),
          upper = dmg_range(b, 0.7f, 1.8f), length = m->reach * dmg_range(b, 0.25f, 0.8f);
    dmg_move(b, side * 0.8f * m->radius, m->top * dmg_range(b, 0.4f, 0.85f), 0);
    dmg_turn(b, v3(0, 0, 1), -side * 0.5f * DMG_PI);
    dmg_rod(b, v3(0, -0.2f * cap, 0), v3(0, 0.6f * out, 0), 0.9f * cap);
    dmg_move(b, 0, 0.6f * out, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, -DMG_PI, DMG_PI));
    bool both = dmg_chance(b, 0.5f);
    dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, side, 0), both ? -upper : 0.0f, upper);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.4f * out, 0), cap);
    dmg_move(b, 0, 0.3f * out, 0);
    draw_lever(b, dmg_int(b, 0, 4), cap, length, 0.0f);
}

/* Draws a thin rod behind the spout that opens the waste: lifted, not turned. */
static void draw_lift_rod(dmg_builder* b, const mixer* m) {
    float thin = m->radius * dmg_range(b, 0.08f, 0.2f), out = m->radius * dmg_range(b, 1.2f, 1.8f),
          high = m->top * dmg_range(b, 0.5f, 1.1f), knob = thin * dmg_range(b, 1.5f, 3.0f);
    bool stem = dmg_chance(b, 0.6f);
    dmg_save(b);
    dmg_move(b, 0, 0, -out);
    dmg_use(b, 0);
    if (stem) dmg_box(b, v3(0, 0.1f * high, 0.5f * out), v3(4 * thin, 0.1f * high, out + 4 * thin));
    dmg_slide(b, 0, "lift_rod", v3(0, 1, 0), 0.0f, 0.4f * high);
    dmg_rod(b, v3(0, -0.3f * high, 0), v3(0, high, 0), thin);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(0, high, 0), v3(knob, knob, knob));
    else
        dmg_rod(b, v3(0, high - knob, 0), v3(0, high, 0), knob);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_mixer(dmg_builder* b) {
    mixer m = pick_mixer(b);
    bool head = dmg_chance(b, 0.15f), side = !head && (m.neck == 2 || dmg_chance(b, 0.15f));
    if (!side && !head) m.rise = fminf(m.rise, 0.35f * m.reach); /* the lever lies above the spout */
    if (dmg_chance(b, 0.6f)) draw_pillar(b, m.square, m.radius * dmg_range(b, 1.1f, 1.6f), 0, 0.2f * m.radius);
    draw_pillar(b, m.square, m.radius, 0, m.top);
    if (dmg_chance(b, 0.25f)) draw_lift_rod(b, &m);
    if (head) { /* cap and spout in one */
        float swing = dmg_range(b, 0.5f, 1.8f);
        dmg_move(b, 0, m.top, 0);
        uint32_t part = dmg_hinge(b, 0, "spout", v3(0, 0, 0), v3(0, 1, 0), -swing, swing);
        draw_pillar(b, m.square, 1.05f * m.radius, 0, m.radius);
        if (dmg_chance(b, 0.5f)) dmg_ellipsoid(b, v3(0, m.radius, 0), v3(1.05f * m.radius, m.radius, 1.05f * m.radius));
        dmg_move(b, 0, 0.5f * m.radius, 0);
        draw_neck(b, m.neck, 0.6f * m.radius, m.rise, m.reach);
        if (dmg_chance(b, 0.3f)) dmg_rest(b, part, swing * dmg_range(b, -0.8f, 0.8f));
        return;
    }
    dmg_save(b);
    dmg_move(b, 0, m.top - m.radius * dmg_range(b, 0.5f, 1.2f), 0);
    draw_neck(b, m.neck, m.radius * dmg_range(b, 0.4f, 0.75f), m.rise, m.reach);
    dmg_restore(b);
    if (side) {
        draw_side_handle(b, &m);
    } else {
        dmg_move(b, 0, m.top, 0);
        draw_cap(b, &m);
    }
}

/* ---- lever valve ---- */

/* Draws a flange, a stem and a lever that may be larger than all the rest; on a floor, a wall or across a pipe. */
static void draw_lever_valve(dmg_builder* b) {
    float stem = dmg_scale_range(b, 0.006f, 0.03f), high = stem * dmg_range(b, 0.8f, 4.0f),
          length = stem * dmg_range(b, 2.5f, 14.0f), hub = stem * dmg_range(b, 1.0f, 2.6f),
          thick = hub * dmg_range(b, 0.3f, 1.2f), swing = dmg_range(b, 0.6f, 1.7f);
    bool both = dmg_chance(b, 0.6f);
    int base = dmg_int(b, 0, 2);
    float flange = stem * dmg_range(b, 1.8f, 5.0f);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* out of a wall */
    if (base == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0.4f * stem, 0), flange);
    if (base == 1) dmg_box(b, v3(0, 0.2f * stem, 0), v3(2 * flange, 0.4f * stem, 2 * flange));
    if (base == 2) dmg_rod(b, v3(-2 * flange, -stem, 0), v3(2 * flange, -stem, 0), 1.5f * stem);
    dmg_rod(b, v3(0, -stem, 0), v3(0, high, 0), stem);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, -DMG_PI, DMG_PI));
    uint32_t part = dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 1, 0), both ? -swing : 0.0f, swing);
    dmg_move(b, 0, high, 0);
    int lever = dmg_int(b, 0, 4);
    if (lever > 2 || dmg_chance(b, 0.7f)) dmg_rod(b, v3(0, 0, 0), v3(0, thick, 0), hub);
    dmg_move(b, 0, 0.5f * thick, 0);
    draw_lever(b, lever, hub, length, -0.05f);
    if (dmg_chance(b, 0.3f)) dmg_rest(b, part, (both ? swing : 0.5f * swing) * dmg_range(b, 0.0f, 1.0f));
}

void dmg_build_tap(dmg_builder* b) {
    if (dmg_chance(b, 0.7f))
        draw_mixer(b);
    else
        draw_lever_valve(b);
    dmg_use(b, 0);
}
