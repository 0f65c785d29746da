/* Draws saws of the workshop: mitre saws that turn, tilt, slide and chop, table saws with fences and gauges, band
 * saws with doors and horizontal ones with a bow. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

/* Draws a toothed disc about X. */
static void draw_saw_blade(dmg_builder* b, dmg_vec at, float r, float t) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, dmg_chance(b, 0.4f) ? 4 : 0, r, t, 8);
    dmg_rod(b, v3(0, 0, -2.5f * t), v3(0, 0, 2.5f * t), 0.12f * r);
    dmg_restore(b);
}

/* Draws two cheeks and a rim about X through `at`. */
static void draw_blade_guard(dmg_builder* b, dmg_vec at, float r, float from, float to, float half, float t) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_arc_skin(b, r, from, to, t, 2 * half);
    for (int s = -1; s <= 1; s += 2) dmg_arc_cheek(b, r, from, to, (float)s * half, t, true);
    dmg_restore(b);
}

/* ---- mitre saw ---- */

typedef struct mitre {
    float r, top, turn; /* of the blade; height of the bed; radius of the turntable */
    dmg_vec pivot;      /* of the arm that chops */
} mitre;

/* Bed with two wings, a fence in halves that may be drawn apart, clamps, extensions, feet. */
static void draw_mitre_bed(dmg_builder* b, const mitre* m) {
    float wide = m->r * dmg_range(b, 1.6f, 2.4f), t = 0.08f * m->r, tall = m->r * dmg_range(b, 0.4f, 0.8f),
          gap = 0.12f * m->r, back = -0.35f * m->r, reach = wide * dmg_range(b, 0.3f, 0.8f);
    bool slides = dmg_chance(b, 0.5f), extends = dmg_chance(b, 0.35f), clamp = dmg_chance(b, 0.45f);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, x = side * 1.02f * m->turn;
        dmg_box_span(b, v3(fminf(x, side * wide), 0, back - 2 * t), v3(fmaxf(x, side * wide), m->top, 0.5f * m->turn));
        if (slides) {
            dmg_box_span(b, v3(fminf(side * gap, side * wide), m->top, back - 2 * t),
                         v3(fmaxf(side * gap, side * wide), m->top + t, back));
            dmg_slide(b, 0, "fence", v3(side, 0, 0), 0.0f, 0.4f * wide);
        }
        float low = m->top + (slides ? t : 0.0f);
        dmg_box_span(b, v3(fminf(side * gap, side * wide), low, back - t),
                     v3(fmaxf(side * gap, side * wide), m->top + tall, back));
        dmg_use(b, 0);
        if (extends) { /* rods with a stop at their end */
            dmg_slide(b, 0, "extension", v3(side, 0, 0), 0.0f, reach);
            for (int k = -1; k <= 1; k += 2)
                dmg_rod(b, v3(side * (wide - reach), 0.5f * m->top, 0.2f * m->turn * (float)k),
                        v3(side * (wide + t), 0.5f * m->top, 0.2f * m->turn * (float)k), 0.4f * t);
            dmg_box(b, v3(side * (wide + 1.5f * t), 0.5f * m->top + 0.5f * t, 0), v3(t, m->top, 0.7f * m->turn));
            dmg_use(b, 0);
        }
    }
    dmg_box_span(b, v3(-1.05f * m->turn, 0, back - 2 * t), v3(1.05f * m->turn, 0.25f * m->top, 0.3f * m->turn));
    if (!clamp) return;
    float x = 0.75f * wide * dmg_sign(b), high = m->r * dmg_range(b, 0.8f, 1.3f),
          way = 0.36f * high; /* holds the work down */
    dmg_rod(b, v3(x, m->top, 0.35f * m->turn), v3(x, m->top + high, 0.35f * m->turn), 0.5f * t);
    dmg_beam(b, v3(x, m->top + 0.9f * high, 0.4f * m->turn), v3(x, m->top + 0.9f * high, 0.05f * m->turn), t, t);
    dmg_screw(b, 0, "clamp", v3(x, 0, 0.05f * m->turn), v3(0, -1, 0), way / 35.0f, 0.0f, 35.0f);
    dmg_rod(b, v3(x, m->top + 0.45f * high, 0.05f * m->turn), v3(x, m->top + 1.2f * high, 0.05f * m->turn), 0.35f * t);
    dmg_rod(b, v3(x, m->top + 0.4f * high, 0.05f * m->turn), v3(x, m->top + 0.45f * high, 0.05f * m->turn), t);
    dmg_rod(b, v3(x - 1.5f * t, m->top + 1.18f * high, 0.05f * m->turn),
            v3(x + 1.5f * t, m->top + 1.18f * high, 0.05f * m->turn), 0.3f * t);
    dmg_use(b, 0);
}

/* Draws what comes down: arm, upper guard, motor, grip; on it the blade and the guard that gives way. */
static void draw_mitre_head(dmg_builder* b, const mitre* m, uint32_t carrier) {
    float drop = dmg_range(b, 0.45f, 0.8f), t = 0.02f * m->r, half = 0.09f * m->r;
    dmg_vec low = v3(0, m->top + 0.96f * m->r, 0.25f * m->r);
    dmg_vec at = v3_add(m->pivot, v3_turn(v3_sub(low, m->pivot), v3(1, 0, 0), -drop));
    uint32_t head = dmg_hinge(b, carrier, "head", m->pivot, v3(1, 0, 0), 0.0f, drop);
    dmg_rest(b, head, dmg_chance(b, 0.7f) ? 0.0f : drop * dmg_unit(b));
    float side = dmg_sign(b), motor = m->r * dmg_range(b, 0.28f, 0.42f), length = m->r * dmg_range(b, 0.7f, 1.3f);
    dmg_vec top = v3(0, at.y + 0.75f * m->r, at.z - 0.3f * m->r), x = v3(side * 2.2f * half, 0, 0);
    dmg_beam(b, v3_add(m->pivot, x), v3_add(top, x), 1.6f * half, 3 * half);
    dmg_beam(b, v3_add(top, x), v3_add(at, x), 1.6f * half, 3 * half);
    dmg_rod(b, v3(side * 2 * half, at.y + 0.25f * m->r, at.z),
            v3(side * length, at.y + 0.25f * m->r, at.z - 0.1f * m->r), motor);
    dmg_rod(b, at, v3_add(at, x), 0.15f * m->r);
    float from = dmg_range(b, -0.3f, 0.1f), to = dmg_range(b, 3.2f, 3.5f);
    draw_blade_guard(b, at, 1.12f * m->r, from, to, half, t);
    dmg_vec grip = v3(side * half, at.y + 1.1f * m->r, at.z + 0.5f * m->r);
    if (dmg_chance(b, 0.5f)) {
        const dmg_vec bow[] = {v3(side * half, at.y + 0.95f * m->r, at.z + 0.1f * m->r),
                               v3(side * half, at.y + 1.35f * m->r, at.z + 0.3f * m->r),
                               v3(side * half, at.y + 1.25f * m->r, at.z + 0.7f * m->r),
                               v3(side * half, at.y + 0.85f * m->r, at.z + 0.62f * m->r)};
        dmg_sweep(b, bow, 4, 0.07f * m->r, 0.07f * m->r, false);
    } else
        dmg_capsule(b, v3_add(grip, v3(0, -0.25f * m->r, 0.1f * m->r)), v3_add(grip, v3(0, 0.1f * m->r, -0.3f * m->r)),
                    0.08f * m->r);
    if (dmg_chance(b, 0.8f)) {
        dmg_spin(b, head, "blade", at, v3(1, 0, 0));
        draw_saw_blade(b, at, m->r, 0.03f * m->r);
    } else
        draw_saw_blade(b, at, m->r, 0.03f * m->r);
    if (dmg_chance(b, 0.8f)) {
        dmg_hinge(b, head, "guard", at, v3(1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.4f));
        draw_blade_guard(b, at, 1.06f * m->r, -2.9f, -0.15f, 0.7f * half, t);
    }
    dmg_use(b, 0);
}

void dmg_build_mitre_saw(dmg_builder* b) {
    mitre m = {.r = dmg_scale_range(b, 0.09f, 0.18f)};
    m.top = m.r * dmg_range(b, 0.45f, 0.8f);
    m.turn = m.r * dmg_range(b, 0.9f, 1.2f);
    bool bevels = dmg_chance(b, 0.75f), slides = dmg_chance(b, 0.55f), turns = dmg_chance(b, 0.9f);
    float arm = m.r * dmg_range(b, 0.3f, 0.9f), back = -m.r * dmg_range(b, 1.3f, 1.6f),
          limit = dmg_range(b, 0.7f, 0.95f), way = m.r * dmg_range(b, 1.0f, 1.8f);
    draw_mitre_bed(b, &m);
    uint32_t carrier = 0;
    if (turns) carrier = dmg_hinge(b, 0, "turntable", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -limit, limit);
    dmg_rod(b, v3(0, 0.27f * m.top, 0), v3(0, m.top, 0), m.turn);
    dmg_box_span(b, v3(-0.2f * m.r, 0.4f * m.top, 0.9f * m.turn), v3(0.2f * m.r, m.top, m.turn + arm));
    dmg_box_span(b, v3(-0.25f * m.r, 0.3f * m.top, back), v3(0.25f * m.r, m.top - 0.1f * m.r, -0.9f * m.turn));
    uint32_t table = carrier;
    if (dmg_chance(b, 0.5f)) { /* the grip in front locks it, or a lever under it frees it */
        dmg_save(b);
        dmg_move(b, 0, 0.7f * m.top, m.turn + arm);
        dmg_spin(b, table, "knob", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_chance(b, 0.5f) ? 4 : 2, 0.2f * m.r, 0.35f * m.r);
        dmg_restore(b);
        dmg_use(b, table);
    }
    float least = dmg_chance(b, 0.5f) ? -0.79f : 0.0f;
    if (bevels) carrier = dmg_hinge(b, table, "bevel", v3(0, m.top, 0), v3(0, 0, dmg_sign(b)), least, 0.79f);
    float high = slides ? m.top + 0.25f * m.r : m.top + m.r * dmg_range(b, 0.6f, 1.0f), z = back - 0.02f * m.r;
    dmg_box_span(b, v3(-0.3f * m.r, m.top - 0.35f * m.r, z - 0.2f * m.r), v3(0.3f * m.r, high, z));
    m.pivot = v3(0, high, z + 0.1f * m.r);
    if (slides) { /* two rods run through the block at the rear with the head at their front end */
        bool level = dmg_chance(b, 0.5f);
        float rod = 0.06f * m.r;
        dmg_box_span(b, v3(-0.35f * m.r, high, z - 0.2f * m.r), v3(0.35f * m.r, high + 0.75f * m.r, z));
        carrier = dmg_slide(b, carrier, "carriage", v3(0, 0, 1), 0.0f, way);
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec at = level ? v3(0.2f * m.r * (float)s, high + 0.35f * m.r, 0)
                               : v3(0, high + m.r * (0.35f + 0.2f * (float)s), 0);
            dmg_rod(b, v3(at.x, at.y, z - 1.1f * way), v3(at.x, at.y, z + 0.1f * m.r), rod);
        }
        dmg_box_span(b, v3(-0.32f * m.r, high, z + 0.05f * m.r), v3(0.32f * m.r, high + 0.85f * m.r, z + 0.2f * m.r));
        m.pivot = v3(0, high + 0.75f * m.r, z + 0.2f * m.r);
    }
    dmg_rod(b, v3(-0.3f * m.r, m.pivot.y, m.pivot.z), v3(0.3f * m.r, m.pivot.y, m.pivot.z), 0.1f * m.r);
    draw_mitre_head(b, &m, carrier);
}

/* ---- table saw ---- */

typedef struct bench {
    float wide, deep, top, t; /* the plate: x, z, height of its upper face, thickness */
    float slit, slot, groove; /* half widths of the blade's slit and a groove; where the grooves lie */
} bench;

/* Strips that leave a slit for the blade and two grooves for the gauge. */
static void draw_slotted_top(dmg_builder* b, const bench* e) {
    float x = 0.5f * e->wide, z = 0.5f * e->deep, y = e->top, g = e->groove, s = e->slot, mid = 0.32f * e->deep;
    const float edges[4][2] = {{-x, -g - s}, {-g + s, -e->slit}, {e->slit, g - s}, {g + s, x}};
    for (int i = 0; i < 4; ++i) dmg_box_span(b, v3(edges[i][0], y - e->t, -z), v3(edges[i][1], y, z));
    for (int k = -1; k <= 1; k += 2) {
        dmg_box_span(b, v3((float)k * g - s, y - e->t, -z), v3((float)k * g + s, y - 0.5f * e->t, z));
        dmg_box_span(b, v3(-e->slit, y - e->t, k < 0 ? -z : mid), v3(e->slit, y, k < 0 ? -mid : z));
    }
}

/* Draws the blade with what rises with it: splitter, guard. It rises, tilts, or both. */
static void draw_arbor(dmg_builder* b, const bench* e, float r) {
    bool rises = dmg_chance(b, 0.75f), guard = dmg_chance(b, 0.5f), spins = dmg_chance(b, 0.75f);
    float centre = rises ? e->top - 0.9f * r : e->top - 0.35f * r, up = 0.6f * r, t = 0.1f * e->slit,
          rest = dmg_unit(b);
    uint32_t unit = rises ? dmg_slide(b, 0, "blade_lift", v3(0, 1, 0), 0.0f, up) : 0;
    if (rises) dmg_rest(b, unit, up * rest);
    const dmg_xy knife[] = {{-1.35f * r, -0.2f * r},
                            {-1.05f * r, -0.2f * r},
                            {-1.06f * r, 0.3f * r},
                            {-0.75f * r, 1.02f * r},
                            {-1.2f * r, 1.02f * r}};
    dmg_vec at = v3(0, centre, 0);
    dmg_save(b);
    dmg_move(b, 0, centre, 0);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_extrude(b, knife, 5, -t, t);
    dmg_restore(b);
    dmg_box_span(b, v3(-t, centre - 0.2f * r, -1.3f * r), v3(t, centre - 0.1f * r, -1.01f * r));
    if (guard) {
        float swing = dmg_range(b, 0.6f, 1.2f);
        dmg_hinge(b, unit, "guard", v3(0, centre + 0.95f * r, -1.1f * r), v3(-1, 0, 0), 0.0f, swing);
        dmg_box_span(b, v3(-e->slit - t, centre + 0.92f * r, -1.2f * r), v3(-e->slit, centre + 1.35f * r, 0.9f * r));
        dmg_box_span(b, v3(e->slit, centre + 0.92f * r, -1.2f * r), v3(e->slit + t, centre + 1.35f * r, 0.9f * r));
        dmg_box_span(b, v3(-e->slit, centre + 1.3f * r, -1.2f * r), v3(e->slit, centre + 1.35f * r, 0.9f * r));
    }
    if (spins)
        dmg_spin(b, unit, "blade", at, v3(1, 0, 0));
    else
        dmg_use(b, unit);
    draw_saw_blade(b, at, r, 0.6f * e->slit);
    dmg_use(b, 0);
}

/* Draws the fence on rails along both edges, or held at the front alone; a lever at its head. */
static void draw_rip_fence(dmg_builder* b, const bench* e) {
    float x = 0.5f * e->wide, z = 0.5f * e->deep, t = 0.6f * e->t, tall = e->deep * dmg_range(b, 0.08f, 0.14f),
          half = 0.03f * e->wide, at = e->groove + 3 * e->slot + 2 * half, w = 2 * half;
    bool lever = dmg_chance(b, 0.7f), rear = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-0.9f * x, e->top - e->t, z), v3(x, e->top - 0.4f * e->t, z + 1.5f * t));
    if (rear) dmg_box_span(b, v3(-0.9f * x, e->top - e->t, -z - t), v3(x, e->top - 0.4f * e->t, -z));
    uint32_t fence = dmg_slide(b, 0, "fence", v3(1, 0, 0), e->groove + 3 * e->slot - at, x - half - at);
    dmg_rest(b, fence, (x - half - at) * dmg_unit(b));
    dmg_box_span(b, v3(at - half, e->top + 0.01f * t, rear ? -z - 1.2f * t : -0.98f * z),
                 v3(at + half, e->top + tall, z + 1.6f * t));
    dmg_box_span(b, v3(at - 2 * w, e->top - e->t, z + 1.55f * t), v3(at + 2 * w, e->top + 0.4f * tall, z + 3 * t));
    if (lever) { /* up frees it */
        dmg_hinge(b, fence, "lever", v3(at, e->top, z + 3 * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.5f));
        dmg_beam(b, v3(at, e->top, z + 3 * t), v3(at, e->top - 1.2f * tall, z + 5 * t), half, t);
        dmg_ellipsoid(b, v3(at, e->top - 1.3f * tall, z + 5 * t), v3(half, half, half));
    }
    dmg_use(b, 0);
}

/* Draws a bar in the left groove, on it a half disc that turns, with a knob on top. */
static void draw_mitre_gauge(dmg_builder* b, const bench* e) {
    float r = e->wide * dmg_range(b, 0.07f, 0.1f), z = 0.2f * e->deep, way = 0.25f * e->deep, t = 0.4f * e->t,
          s = 0.9f * e->slot;
    uint32_t bar = dmg_slide(b, 0, "gauge", v3(0, 0, -1), -way, 1.5f * way);
    dmg_box_span(b, v3(-e->groove - s, e->top - 0.48f * e->t, z - 0.1f * e->deep),
                 v3(-e->groove + s, e->top + 0.02f * t, z + 0.3f * e->deep));
    dmg_hinge(b, bar, "protractor", v3(-e->groove, 0, z), v3(0, dmg_sign(b), 0), -0.9f, 0.9f);
    const dmg_xy half[] = {{-r, 0}, {-0.85f * r, -0.5f * r}, {-0.5f * r, -0.85f * r},
                           {0, -r}, {0.5f * r, -0.85f * r},  {0.85f * r, -0.5f * r},
                           {r, 0}};
    dmg_save(b);
    dmg_move(b, -e->groove, e->top + 0.03f * t, z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_extrude(b, half, 7, 0, t);
    dmg_restore(b);
    dmg_box_span(b, v3(-e->groove - r, e->top + 0.03f * t, z - t),
                 v3(-e->groove + 0.9f * (e->groove - e->slit < r ? e->groove - e->slit : r), e->top + 0.5f * r, z));
    dmg_rod(b, v3(-e->groove, e->top + t, z + 0.6f * r), v3(-e->groove, e->top + 0.9f * r, z + 0.6f * r), 0.22f * r);
    dmg_use(b, 0);
}

/* Below: a cabinet with a motor door, a box on a folding stand, or a box on splayed legs. */
static void draw_saw_base(dmg_builder* b, const bench* e, int kind, float r) {
    float x = 0.36f * e->wide, z = 0.38f * e->deep, low = kind == 0 ? 0.0f : fmaxf(e->top - 2.4f * r, 0.0f),
          y = e->top - e->t, t = 0.02f * e->wide;
    dmg_box_faces(b, v3(0, 0.5f * (low + y), 0), v3(2 * x, y - low, 2 * z), DMG_FACE_ALL & ~DMG_FACE_TOP);
    float wheel = 0.4f * r;
    dmg_handwheel_place(b, 0, "height_wheel", v3(0.2f * x, y - 1.3f * r, z), 0.0f, wheel);
    if (dmg_chance(b, 0.6f))
        dmg_handwheel_place(b, 0, "tilt_wheel", v3(x, y - 1.3f * r, 0.1f * z), 0.5f * DMG_PI, wheel);
    if (dmg_chance(b, 0.5f)) { /* the paddle that stops it */
        dmg_box_span(b, v3(-0.9f * x, y - 0.9f * r, z), v3(-0.5f * x, y - 0.3f * r, z + t));
        dmg_hinge(b, 0, "paddle", v3(0, y - 0.35f * r, z + t), v3(-1, 0, 0), 0.0f, 0.6f);
        dmg_box_span(b, v3(-0.85f * x, y - 1.0f * r, z + 1.05f * t), v3(-0.55f * x, y - 0.33f * r, z + 1.6f * t));
        dmg_use(b, 0);
    }
    if (kind == 0 && dmg_chance(b, 0.6f)) {
        float high = 0.5f * (y - low);
        dmg_leaf leaf = dmg_leaf_pick(b, 0.1f);
        leaf.width = 1.4f * z;
        leaf.height = high;
        leaf.thickness = t;
        leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, -x - t, low + 0.55f * high + 0.03f * y, 0);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1 && kind > 0 && low > 0.15f;
         s += 2) { /* a pair of legs at each end; folding ones swing in under the box */
        float at = (float)s * (x - t), splay = kind == 1 ? 0.0f : 0.2f * x;
        if (kind == 1)
            dmg_hinge(b, 0, "leg", v3(at, low - 0.5f * t - (s < 0 ? 2 * t : 0.0f), 0), v3(0, 0, -(float)s), 0.0f, 1.5f);
        float head = low - (kind == 1 && s < 0 ? 2 * t : 0.0f);
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3(at, head - 0.01f * t, (float)k * 0.9f * z),
                     v3(at + (float)s * splay, 0, (float)k * (0.9f * z + splay)), t, t);
        dmg_rod(b, v3(at + 0.6f * (float)s * splay, 0.4f * low, -0.9f * z - 0.6f * splay),
                v3(at + 0.6f * (float)s * splay, 0.4f * low, 0.9f * z + 0.6f * splay), 0.5f * t);
        dmg_use(b, 0);
        if (kind == 1 && s < 0) dmg_box_span(b, v3(at - t, head - t, -z), v3(at + t, low, z));
    }
}

void dmg_build_table_saw(dmg_builder* b) {
    int kind = dmg_int(b, 0, 3);
    bench e = {.wide = dmg_scale_range(b, 0.55f, 1.1f)};
    e.deep = e.wide * dmg_range(b, 0.65f, 0.95f);
    e.top = kind == 3 ? e.wide * dmg_range(b, 0.4f, 0.55f) : dmg_range(b, 0.8f, 0.95f);
    e.t = e.wide * dmg_range(b, 0.03f, 0.06f);
    e.slit = 0.016f * e.wide;
    e.slot = 0.014f * e.wide;
    e.groove = e.wide * dmg_range(b, 0.15f, 0.2f);
    float r = e.deep * dmg_range(b, 0.17f, 0.22f), wing = e.wide * dmg_range(b, 0.2f, 0.5f);
    draw_slotted_top(b, &e);
    draw_saw_base(b, &e, kind, r);
    draw_arbor(b, &e, r);
    if (dmg_chance(b, 0.85f)) draw_rip_fence(b, &e);
    if (dmg_chance(b, 0.6f)) draw_mitre_gauge(b, &e);
    float x = -0.5f * e.wide, z = 0.48f * e.deep, y = e.top;
    int side = dmg_int(b, 0, 3);
    if (side == 0) { /* a wing that is let down */
        dmg_hinge(b, 0, "wing", v3(x, y - e.t, 0), v3(0, 0, 1), 0.0f, 1.5f);
        dmg_box_span(b, v3(x - wing, y - e.t, -z), v3(x - 0.003f, y, z));
    }
    if (side == 1) { /* a table that slides along the blade */
        dmg_box_span(b, v3(x - 0.2f * wing, y - 2 * e.t, -z), v3(x, y - e.t, z));
        dmg_slide(b, 0, "sliding_table", v3(0, 0, -1), -0.5f * z, 1.2f * z);
        dmg_box_span(b, v3(x - wing, y - e.t, -z), v3(x - 0.003f, y, z));
        dmg_box_span(b, v3(x - wing, y, 0.8f * z), v3(x - 0.003f, y + e.t, 0.9f * z));
    }
    if (side == 2) { /* support behind the blade */
        dmg_slide(b, 0, "outfeed", v3(0, 0, -1), 0.0f, 0.8f * e.deep);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0.42f * (float)s * e.wide, y - 1.6f * e.t, -z - 2 * e.t),
                    v3(0.42f * (float)s * e.wide, y - 1.6f * e.t, z), 0.3f * e.t);
        dmg_box_span(b, v3(-0.45f * e.wide, y - 2 * e.t, -z - 3 * e.t), v3(0.45f * e.wide, y, -z - 1.5f * e.t));
    }
    dmg_use(b, 0);
}

/* ---- band saw ---- */

typedef struct frame_saw {
    float wide, deep, wheel; /* of the frame: x, z; radius of the wheels */
    float low, high;         /* heights of the wheels' axes */
    float blade;             /* x */
} frame_saw;

/* Draws the door over a wheel: hung at the column's side or at the blade's, or in one piece for both. */
static void draw_wheel_door(dmg_builder* b, const frame_saw* f, const char* name, float y, float high, bool left) {
    float t = 0.12f * f->deep, gap = 0.01f * f->wide;
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = f->wide - gap;
    leaf.height = high - gap;
    leaf.thickness = t;
    leaf.side = left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    if (dmg_chance(b, 0.6f)) leaf.panel.kind = dmg_chance(b, 0.5f) ? DMG_PANEL_ROUNDED : DMG_PANEL_FLAT;
    dmg_save(b);
    dmg_move(b, 0, y, 0.5f * f->deep + t);
    dmg_leaf_draw(b, 0, name, &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_saw_frame(dmg_builder* b, const frame_saw* f) {
    float half = 0.5f * f->wide, box = 1.15f * f->wheel, wall = 0.04f * f->wide, tyre = 0.5f * f->deep;
    bool open = dmg_chance(b, 0.7f), left = dmg_chance(b, 0.7f);
    int spokes = dmg_int(b, 3, 6), kind = dmg_chance(b, 0.6f) ? 3 : 0;
    for (int s = -1; s <= 1; s += 2) {
        float y = s < 0 ? f->low : f->high;
        dmg_save(b);
        dmg_move(b, 0, y, 0.5f * f->deep);
        dmg_case_draw(b, DMG_CASE_BOARDS, f->wide, 2 * box, f->deep, wall);
        dmg_restore(b);
        if (!open) {
            dmg_box_span(b, v3(-half, y - box, 0.5f * f->deep), v3(half, y + box, 0.62f * f->deep));
            continue;
        }
        dmg_spin(b, 0, "wheel", v3(0, y, 0), v3(0, 0, 1));
        dmg_save(b);
        dmg_move(b, 0, y, 0.1f * f->deep);
        dmg_wheel_draw(b, kind, f->wheel, tyre, spokes);
        dmg_restore(b);
        dmg_use(b, 0);
        draw_wheel_door(b, f, s < 0 ? "lower_door" : "upper_door", y, 2 * box, left);
    }
    dmg_box_span(b, v3(-half, f->low + box, -0.5f * f->deep),
                 v3(-half + 0.22f * f->wide, f->high - box, 0.5f * f->deep));
    dmg_box(b, v3(f->blade, 0.5f * (f->low + f->high), 0),
            v3(0.004f * f->wide, f->high - f->low - 1.9f * box, 0.06f * f->deep));
}

/* Draws the table with the rail of its fence; it tilts about a line along the feed. */
static void draw_band_table(dmg_builder* b, const frame_saw* f, float y) {
    float half = 0.32f * f->wide, t = 0.03f * f->wide, z = half * dmg_range(b, 0.9f, 1.2f), tall = 0.12f * f->wide,
          c = f->blade;
    bool tilts = dmg_chance(b, 0.85f), fence = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(c - 0.4f * half, f->low + 1.14f * f->wheel, -0.3f * z),
                 v3(c + 0.4f * half, y - 3.2f * t, 0.3f * z));
    uint32_t table =
        tilts ? dmg_hinge(b, 0, "table", v3(c, y, 0), v3(0, 0, -1), dmg_chance(b, 0.5f) ? -0.15f : 0.0f, 0.79f) : 0;
    dmg_rod(b, v3(c, y - t, -0.25f * z), v3(c, y - t, 0.25f * z), 2 * t);
    dmg_box_span(b, v3(c - half, y - t, -z), v3(c - 0.01f * f->wide, y, z));
    dmg_box_span(b, v3(c + 0.01f * f->wide, y - t, -z), v3(c + 1.2f * half, y, z));
    if (fence) {
        float at = c + 0.4f * half;
        dmg_box_span(b, v3(c - 0.9f * half, y - t, z), v3(c + 1.2f * half, y - 0.3f * t, z + 0.5f * t));
        dmg_slide(b, table, "fence", v3(1, 0, 0), -0.25f * half, 0.6f * half);
        dmg_box_span(b, v3(at - t, y + 0.05f * t, -0.95f * z), v3(at, y + tall, z + 0.6f * t));
        dmg_box_span(b, v3(at - 2 * t, y - t, z + 0.55f * t), v3(at + t, y + t, z + 2 * t));
    }
    dmg_use(b, 0);
}

/* Draws the post that brings the guides down to the work, with its crank; the wheel that tightens the band. */
static void draw_band_guides(dmg_builder* b, const frame_saw* f, float table) {
    float low = f->high - 1.15f * f->wheel, space = low - table, r = 0.02f * f->wide, stub = 0.12f * space,
          z = -0.12f * f->deep, half = 0.5f * f->wide, y = f->high + 1.15f * f->wheel,
          knob = f->wide * dmg_range(b, 0.06f, 0.12f);
    uint32_t post = dmg_slide(b, 0, "guide", v3(0, -1, 0), 0.0f, 0.75f * space);
    dmg_rest(b, post, 0.75f * space * dmg_unit(b));
    dmg_rod(b, v3(f->blade + 2 * r, low - stub, z), v3(f->blade + 2 * r, low + 0.78f * space, z), r);
    dmg_box_span(b, v3(f->blade + 0.5f * r, low - 1.1f * stub, z - 2 * r),
                 v3(f->blade + 4 * r, low - 0.4f * stub, z + 2 * r));
    if (dmg_chance(b, 0.6f))
        dmg_box_span(b, v3(f->blade - r, low - stub, 0.1f * f->deep),
                     v3(f->blade + 4 * r, low - 0.02f * space, 0.13f * f->deep + r));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.7f)) {
        dmg_save(b);
        dmg_move(b, 0, y, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_handwheel_place(b, 0, "tension", v3(0, 0, 0), 0.0f, knob);
        dmg_restore(b);
    } else
        dmg_machine_lever_place(b, 0, "tension", v3(0, f->high, -0.5f * f->deep), DMG_PI, 3 * knob);
    if (dmg_chance(b, 0.5f))
        dmg_handwheel_place(b, 0, "guide_wheel", v3(half, low + 0.2f * f->wheel, 0), 0.5f * DMG_PI, 0.8f * knob);
    dmg_use(b, 0);
}

static void draw_upright_band_saw(dmg_builder* b) {
    frame_saw f = {.wide = dmg_scale_range(b, 0.4f, 0.9f)};
    f.deep = f.wide * dmg_range(b, 0.28f, 0.4f);
    f.wheel = 0.43f * f.wide;
    bool bench = dmg_chance(b, 0.4f);
    float foot = bench ? 0.05f : dmg_range(b, 0.3f, 0.6f), half = 0.5f * f.wide, t = 0.05f * f.wide;
    f.low = foot + 1.15f * f.wheel;
    f.high = f.low + 2.3f * f.wheel + f.wide * dmg_range(b, 0.4f, 0.75f);
    f.blade = f.wheel;
    if (bench)
        dmg_box_span(b, v3(-half - t, 0, -0.7f * f.deep), v3(half + t, foot, 0.7f * f.deep));
    else if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-half, 0, -0.6f * f.deep), v3(half, foot, 0.55f * f.deep));
    else
        for (int i = 0; i < 4; ++i) {
            float x = (i & 1 ? 0.9f : -0.9f) * half, z = (i & 2 ? 0.4f : -0.4f) * f.deep;
            dmg_beam(b, v3(x, foot, z), v3(1.2f * x, 0, 1.6f * z), t, t);
        }
    draw_saw_frame(b, &f);
    float y = f.low + 1.15f * f.wheel + 0.18f * f.wide;
    draw_band_table(b, &f, y);
    draw_band_guides(b, &f, y);
}

/* The bow falls through work held in a vice: it turns about a pin at one end of the bed. */
static void draw_bow_saw(dmg_builder* b) {
    float wide = dmg_scale_range(b, 0.6f, 1.6f), deep = wide * dmg_range(b, 0.25f, 0.4f),
          bed = dmg_range(b, 0.3f, 0.65f), t = 0.03f * wide, r = wide * dmg_range(b, 0.12f, 0.16f),
          swing = dmg_range(b, 0.6f, 1.1f), x = 0.5f * wide, gap = wide * dmg_range(b, 0.1f, 0.15f);
    bool spins = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-x, bed - 2 * t, -0.5f * deep), v3(x, bed, 0.5f * deep));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.9f * x - 3 * t, 0, -0.45f * deep),
                     v3((float)s * 0.9f * x + 3 * t, bed - 2 * t, 0.45f * deep));
    float pin = bed + 2 * t, z = -0.3f * deep;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-x, bed, z + 2.2f * t * (float)s - 0.8f * t),
                     v3(-x + 3 * t, pin + t, z + 2.2f * t * (float)s + 0.8f * t));
    uint32_t bow = dmg_hinge(b, 0, "bow", v3(-x + 1.5f * t, pin, z), v3(0, 0, 1), 0.0f, swing);
    dmg_rest(b, bow, dmg_chance(b, 0.4f) ? 0.0f : swing * dmg_unit(b));
    float y = bed + gap + r, near = -x + r + 2 * t, far = x + 0.3f * r;
    dmg_rod(b, v3(-x + 1.5f * t, pin, z - 1.3f * t), v3(-x + 1.5f * t, pin, z + 1.3f * t), 1.2f * t);
    dmg_beam(b, v3(-x + 1.5f * t, pin, z), v3(near, y, z), 2 * t, 3 * t);
    dmg_box_span(b, v3(near, y + 0.4f * r, z - 1.4f * t), v3(far, y + 0.9f * r, z + 1.4f * t));
    dmg_box(b, v3(0.5f * (near + far), y - 0.95f * r, z + 1.8f * t), v3(far - near, 0.12f * r, 0.1f * t));
    for (int s = -1; s <= 1; s += 2) {
        float at = s < 0 ? near : far;
        dmg_rod(b, v3(at, y, z - 1.2f * t), v3(at, y, z + 1.2f * t), r);
        if (spins) dmg_spin(b, bow, "wheel", v3(at, y, 0), v3(0, 0, 1));
        dmg_save(b);
        dmg_move(b, at, y, z + 1.85f * t);
        dmg_wheel_draw(b, 3, 0.95f * r, t, 5);
        dmg_restore(b);
        dmg_use(b, bow);
    }
    dmg_capsule(b, v3(far + 0.7f * r, y + r, z), v3(far + 1.6f * r, y + 1.3f * r, z), 0.5f * t);
    dmg_use(b, 0);
    float jaw = 0.8f * gap, cut = 0.15f * wide, way = 0.35f * deep; /* the vice before the blade */
    dmg_box_span(b, v3(-cut - 3 * t, bed, -0.05f * deep + z), v3(-cut, bed + jaw, 0.05f * deep + z));
    uint32_t vice = dmg_slide(b, 0, "jaw", v3(0, 0, -1), 0.0f, way);
    dmg_rest(b, vice, way * dmg_unit(b));
    dmg_box_span(b, v3(-cut - 3 * t, bed, z + 0.07f * deep + way), v3(-cut, bed + jaw, z + 0.17f * deep + way));
    dmg_use(b, 0);
    dmg_handwheel_place(b, 0, "vice_wheel", v3(-cut - 1.5f * t, bed - t, 0.5f * deep), 0.0f, 2.5f * t);
}

void dmg_build_band_saw(dmg_builder* b) {
    if (dmg_chance(b, 0.25f)) dmg_mirror(b, v3(1, 0, 0));
    if (dmg_chance(b, 0.7f))
        draw_upright_band_saw(b);
    else
        draw_bow_saw(b);
}
