/* Draws 3D printers and plotters: frames whose beds and heads slide on rods or profiles, boxes with doors and hoods,
 * towers with three carriages, vats under a cover that tips or lifts off, spools that turn. */
#include "core/build.h"
#include "parts/cranks.h"
#include "parts/hardware.h"

typedef struct solid_printer {
    float w, d, h; /* the room to print in: half of its width, half of its depth, its height */
    float t;       /* of profiles */
    int bar;       /* square, round, double rods, channel */
    int head;      /* block, block with a fan, cone, two nozzles */
    int bed;       /* plate, plate on a frame, glass with clips, round */
} solid_printer;

static solid_printer pick_printer(dmg_builder* b) {
    solid_printer p = {.w = dmg_scale_range(b, 0.05f, 0.3f)};
    p.d = p.w * dmg_range(b, 0.8f, 1.2f);
    p.h = p.w * dmg_range(b, 1.6f, 3.2f);
    p.t = p.w * dmg_range(b, 0.1f, 0.25f);
    p.bar = dmg_int(b, 0, 3);
    p.head = dmg_int(b, 0, 3);
    p.bed = dmg_int(b, 0, 2);
    return p;
}

/* A profile between two points that lie along one of the axes. */
static void draw_bar(dmg_builder* b, const solid_printer* p, dmg_vec from, dmg_vec to) {
    dmg_vec along = v3_normalize(v3_sub(to, from)), side, up;
    v3_basis(along, &side, &up);
    float t = p->t;
    if (p->bar == 0) dmg_beam(b, from, to, t, t);
    if (p->bar == 1) dmg_rod(b, from, to, 0.4f * t);
    for (int s = -1; s <= 1 && p->bar == 2; s += 2)
        dmg_rod(b, v3_mad(from, up, (float)s * 0.35f * t), v3_mad(to, up, (float)s * 0.35f * t), 0.15f * t);
    if (p->bar == 3) {
        dmg_beam(b, from, to, 0.5f * t, t);
        dmg_beam(b, v3_mad(from, side, 0.4f * t), v3_mad(to, side, 0.4f * t), 0.3f * t, 0.4f * t);
    }
}

/* Draws what deposits: its nozzle's tip at the origin. */
static void draw_head(dmg_builder* b, const solid_printer* p) {
    float s = 2.2f * p->t;
    dmg_cone(b, v3(0, 0.25f * s, 0), v3(0, 0, 0), 0.16f * s, 0.03f * s);
    dmg_box(b, v3(0, 0.32f * s, 0), v3(0.4f * s, 0.15f * s, 0.4f * s));
    if (p->head <= 1) dmg_box(b, v3(0, 0.9f * s, 0), v3(0.8f * s, s, 0.7f * s));
    if (p->head == 1) {
        dmg_box(b, v3(0, 0.7f * s, 0.45f * s), v3(0.6f * s, 0.6f * s, 0.2f * s));
        dmg_rod(b, v3(0, 0.7f * s, 0.5f * s), v3(0, 0.7f * s, 0.58f * s), 0.25f * s);
    }
    if (p->head == 2) dmg_cone(b, v3(0, 0.4f * s, 0), v3(0, 1.5f * s, 0), 0.25f * s, 0.5f * s);
    if (p->head == 3) {
        dmg_rounded_box(b, v3(0, 0.9f * s, 0), v3(1.1f * s, s, 0.8f * s), 0.15f * s);
        dmg_cone(b, v3(0.35f * s, 0.4f * s, 0), v3(0.35f * s, 0.05f * s, 0), 0.12f * s, 0.03f * s);
    }
}

/* Half of it 0.9 w by 0.9 d, its top at y = 0. */
static void draw_bed(dmg_builder* b, const solid_printer* p, uint32_t bed) {
    float x = 0.9f * p->w, z = 0.9f * p->d, t = 0.35f * p->t;
    dmg_box_span(b, v3(-x, -t, -z), v3(x, 0, z));
    if (p->bed == 1) {
        dmg_box_span(b, v3(-0.8f * x, -2.5f * t, -0.15f * z), v3(0.8f * x, -1.5f * t, 0.15f * z));
        dmg_box_span(b, v3(-0.15f * x, -2.5f * t, -0.8f * z), v3(0.15f * x, -1.5f * t, 0.8f * z));
    }
    bool knobs = p->bed == 1 && dmg_chance(b, 0.5f);
    for (int i = 0; i < 4 && p->bed >= 1; ++i) { /* clips, or knobs that level it */
        float sx = i % 2 ? 1.0f : -1.0f, sz = i / 2 ? 1.0f : -1.0f;
        dmg_vec at = {0.85f * sx * x, -1.2f * t, 0.85f * sz * z};
        if (p->bed == 2) dmg_box(b, v3(0.8f * sx * x, 0, sz * z), v3(0.2f * x, 1.6f * t, 0.12f * z));
        if (p->bed == 2) continue;
        if (knobs) dmg_spin(b, bed, "levelling", at, v3(0, 1, 0));
        dmg_rod(b, v3_add(at, v3(0, -1.8f * t, 0)), v3_add(at, v3(0, -1.0f * t, 0)), 0.09f * x);
        dmg_rod(b, v3_add(at, v3(0, -1.0f * t, 0)), at, 0.02f * x);
        dmg_use(b, bed);
    }
    if (dmg_chance(b, 0.4f)) { /* what is being printed */
        float s = x * dmg_range(b, 0.15f, 0.4f), y = p->h * dmg_range(b, 0.02f, 0.08f);
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(0, 0, 0), v3(0, y, 0), s);
        else
            dmg_box_span(b, v3(-s, 0, -s), v3(s, y, s));
    }
}

/* Draws a spool on a pin along Z from the origin. */
static void draw_spool(dmg_builder* b, uint32_t parent, float r) {
    float wide = r * dmg_range(b, 0.4f, 0.9f), hub = r * dmg_range(b, 0.3f, 0.5f), full = dmg_range(b, 0.55f, 0.95f);
    dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 1.2f * wide), 0.8f * hub);
    dmg_spin(b, parent, "spool", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    for (int s = 0; s <= 1; ++s)
        dmg_tube_draw(b, v3(0, 0, 0.05f * wide + (float)s * 0.9f * wide), v3(0, 0, 1), 0.08f * wide, hub, r - hub);
    dmg_tube_draw(b, v3(0, 0, 0.1f * wide), v3(0, 0, 1), 0.87f * wide, hub, full * r - hub);
    dmg_use(b, parent);
}

/* Where a part of way `length` rests, from a margin to its end: the middle is 0. */
static uint32_t slide_about(dmg_builder* b, uint32_t parent, const char* name, dmg_vec way, float half) {
    uint32_t part = dmg_slide(b, parent, name, v3_scale(way, dmg_sign(b)), -half, half);
    if (dmg_chance(b, 0.6f)) dmg_rest(b, part, half * dmg_range(b, -0.9f, 0.9f));
    return part;
}

/* ---- a gantry over a bed that slides; a shelf on one post ---- */

static void draw_gantry_printer(dmg_builder* b, const solid_printer* p) {
    float x = p->w + 2 * p->t, base = 1.5f * p->t, t = p->t, z = -0.2f * p->d;
    bool arm = dmg_chance(b, 0.3f), dual = !arm && dmg_chance(b, 0.8f);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-x - t, 0, -1.2f * p->d), v3(x + t, base, 1.1f * p->d));
    else
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3(-x - t, 0, (float)s * p->d - t), v3(x + t, base, (float)s * p->d + t));
            dmg_box_span(b, v3((float)s * 0.5f * p->w - 0.5f * t, 0.4f * base, -1.6f * p->d),
                         v3((float)s * 0.5f * p->w + 0.5f * t, base, 1.6f * p->d));
        }
    uint32_t bed = slide_about(b, 0, "bed", v3(0, 0, 1), 0.7f * p->d);
    dmg_save(b);
    dmg_move(b, 0, base + 1.2f * t, 0);
    draw_bed(b, p, bed);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.4f * p->w, base + 0.02f * t, -0.4f * p->d), v3(0.4f * p->w, base + 0.9f * t, 0.4f * p->d));
    dmg_use(b, 0);
    float top = base + 1.2f * t + p->h + 2 * t;
    for (int s = -1; s <= 1; s += 2)
        if (s < 0 || !arm) draw_bar(b, p, v3((float)s * x, 0.5f * base, z), v3((float)s * x, top, z));
    if (dual) draw_bar(b, p, v3(-x - 0.5f * t, top, z), v3(x + 0.5f * t, top, z));
    float low = base + 1.2f * t + 1.4f * t, way = p->h - 2.0f * t;
    uint32_t beam = dmg_slide(b, 0, "beam", v3(0, 1, 0), -0.05f * way, way);
    if (dmg_chance(b, 0.7f)) dmg_rest(b, beam, way * dmg_unit(b));
    dmg_move(b, 0, low, z);
    draw_bar(b, p, v3(-x, 0, t), v3(arm ? 0.9f * p->w : x, 0, t));
    for (int s = -1; s <= 1; s += 2)
        if (s < 0 || !arm) dmg_box(b, v3((float)s * x, 0, 0.6f * t), v3(1.6f * t, 1.8f * t, 2.2f * t));
    slide_about(b, beam, "head", v3(1, 0, 0), 0.75f * p->w);
    dmg_box(b, v3(0, 0, 1.7f * t), v3(2 * t, 1.8f * t, 0.5f * t));
    dmg_move(b, 0, -1.3f * t, 2.8f * t);
    draw_head(b, p);
    dmg_use(b, 0);
    dmg_move(b, arm ? -x : 0, top - low + 1.3f * t + (arm ? 1.5f * t : 2.0f * t), -2.8f * t);
    if (dmg_chance(b, 0.6f)) {
        dmg_box_span(b, v3(-0.3f * t, -2.6f * t, -0.5f * t), v3(0.3f * t, 0.5f * t, 0));
        draw_spool(b, 0, p->w * dmg_range(b, 0.3f, 0.6f));
    }
}

/* ---- boxes ---- */

/* Draws a door before the opening, hung at a side, or two; a hood that lifts from the top. */
static void draw_box_covers(dmg_builder* b, const solid_printer* p, float x, float z, float high, float t) {
    int doors = dmg_weighted(b, (const float[]){0.25f, 0.5f, 0.25f}, 3);
    for (int i = 0; i < doors; ++i) {
        dmg_leaf leaf = dmg_leaf_pick(b, 0.2f * high);
        leaf.side = doors == 1 && dmg_chance(b, 0.15f) ? DMG_SIDE_TOP : (i == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
        leaf.width = (doors == 2 ? 0.98f * x : 1.98f * x);
        leaf.height = 0.97f * high;
        leaf.thickness = 0.4f * t;
        if (dmg_chance(b, 0.7f)) leaf.panel = dmg_panel_pick_window(b);
        dmg_save(b);
        dmg_move(b, doors == 2 ? ((float)i - 0.5f) * x : 0, 0.5f * high, z + 0.45f * t);
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.5f)) return;
    float rise = p->t * dmg_range(b, 0.3f, 5.0f), pane = 0.3f * t;
    dmg_hinge(b, 0, "hood", v3(0, high + t, -z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.7f));
    dmg_box_span(b, v3(-x, high + t + rise - pane, -z), v3(x, high + t + rise, z));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * (x - 0.5f * pane) - 0.5f * pane, high + t, -z),
                     v3((float)s * (x - 0.5f * pane) + 0.5f * pane, high + t + rise, z));
        dmg_box_span(b, v3(-x, high + t, (float)s * (z - 0.5f * pane) - 0.5f * pane),
                     v3(x, high + t + rise, (float)s * (z - 0.5f * pane) + 0.5f * pane));
    }
    dmg_use(b, 0);
}

/* Walls or bare profiles; beam and head slide below the top, the bed sinks. */
static void draw_box_printer(dmg_builder* b, const solid_printer* p) {
    float t = p->t, x = p->w + 3 * t, z = p->d + 3 * t, high = p->h + 6 * t, rail = high - 1.2f * t, base = 0;
    bool walls = dmg_chance(b, 0.65f);
    if (dmg_chance(b, 0.5f)) base = p->w * dmg_range(b, 0.2f, 0.6f);
    if (base > 0) dmg_box_span(b, v3(-x - t, 0, -z - t), v3(x + t, base, z + t));
    if (base > 0 && dmg_chance(b, 0.7f)) {
        dmg_save(b);
        dmg_move(b, x * dmg_range(b, -0.4f, 0.4f), 0.5f * base, z + t);
        dmg_controls_draw(b, 0, 0.6f * x, 0.7f * base);
        dmg_restore(b);
    }
    dmg_move(b, 0, base, 0);
    for (int i = 0; i < 4; ++i) {
        float sx = i % 2 ? 1.0f : -1.0f, sz = i / 2 ? 1.0f : -1.0f;
        dmg_box(b, v3(sx * (x + 0.5f * t), 0.5f * high, sz * (z + 0.5f * t)), v3(t, high, t));
        if (sz < 0) dmg_box(b, v3(sx * (x + 0.5f * t), high + 0.5f * t, 0), v3(t, t, 2 * z + 2 * t));
        if (sx < 0) dmg_box(b, v3(0, high + 0.5f * t, sz * (z + 0.5f * t)), v3(2 * x, t, t));
        if (sx < 0) dmg_box(b, v3(0, 0.5f * t, sz * (z + 0.5f * t)), v3(2 * x, t, t));
    }
    for (int s = -1; s <= 1 && walls; s += 2)
        dmg_box(b, v3((float)s * (x + 0.5f * t), 0.5f * high, 0), v3(0.3f * t, high, 2 * z));
    if (walls) dmg_box(b, v3(0, 0.5f * high, -z - 0.5f * t), v3(2 * x, high, 0.3f * t));
    if (walls) dmg_box_span(b, v3(-x, 0, -z), v3(x, 0.2f * t, z));
    if (walls) draw_box_covers(b, p, x + 0.5f * t, z + t, high, t);
    for (int s = -1; s <= 1; s += 2)
        draw_bar(b, p, v3((float)s * (x - 0.6f * t), rail, -z), v3((float)s * (x - 0.6f * t), rail, z));
    float way = p->h - t;
    uint32_t bed = dmg_slide(b, 0, "bed", v3(0, -1, 0), 0.0f, 0.9f * way);
    if (dmg_chance(b, 0.7f)) dmg_rest(b, bed, 0.8f * way * dmg_unit(b));
    dmg_save(b);
    dmg_move(b, 0, rail - 4.2f * t, 0);
    draw_bed(b, p, bed);
    dmg_box_span(b, v3(-0.8f * p->w, -1.2f * t, -z + 0.3f * t), v3(-0.6f * p->w, -0.5f * t, 0.5f * z));
    dmg_box_span(b, v3(0.6f * p->w, -1.2f * t, -z + 0.3f * t), v3(0.8f * p->w, -0.5f * t, 0.5f * z));
    dmg_restore(b);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.45f * p->w, 0, -z + 0.15f * t), v3((float)s * 0.45f * p->w, rail, -z + 0.15f * t),
                0.12f * t);
    uint32_t beam = slide_about(b, 0, "beam", v3(0, 0, 1), 0.8f * p->d);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * (x - 0.8f * t), rail, 0), v3(1.3f * t, 1.5f * t, 2 * t));
    draw_bar(b, p, v3(-x + 1.2f * t, rail, 0), v3(x - 1.2f * t, rail, 0));
    slide_about(b, beam, "head", v3(1, 0, 0), 0.85f * p->w);
    dmg_move(b, 0, rail - 2.8f * t, 0);
    draw_head(b, p);
    dmg_use(b, 0);
}

/* ---- three towers ---- */

/* Draws a carriage up each, two arms from it down to the effector; the arms may be parts of their own. */
static void draw_tower_printer(dmg_builder* b, const solid_printer* p) {
    float r = 1.35f * p->w, t = p->t, high = 2.2f * p->h + 3 * t, base = 1.2f * t, arm = 1.25f * p->w,
          plate = 0.3f * p->w, low = base + 0.7f * p->h, up = low + 0.1f * p->w + sqrtf(arm * arm - 0.36f * r * r);
    bool jointed = dmg_chance(b, 0.6f);
    for (int k = 0; k <= 1; ++k) { /* floor and top */
        float y = k ? high : 0;
        dmg_rod(b, v3(0, y, 0), v3(0, y + base, 0), (k ? 1.0f : 1.2f) * r);
    }
    dmg_rod(b, v3(0, base, 0), v3(0, base + 0.3f * t, 0), 0.8f * p->w);
    for (int i = 0; i < 3; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 3);
        draw_bar(b, p, v3(0, base, 0.85f * r), v3(0, high, 0.85f * r));
        uint32_t car = dmg_slide(b, 0, "carriage", v3(0, dmg_sign(b), 0), -0.3f * p->h, 0.3f * p->h);
        dmg_box(b, v3(0, up, 0.8f * r - 0.3f * t), v3(2 * t, 1.6f * t, 1.2f * t));
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec from = {(float)s * 1.3f * t, up, 0.8f * r - 0.9f * t}, to = {(float)s * 1.3f * t, low, plate};
            if (jointed) dmg_hinge(b, car, "arm", from, v3((float)s, 0, 0), -0.3f, 0.3f);
            dmg_rod(b, from, to, 0.14f * t);
            dmg_ellipsoid(b, from, v3(0.25f * t, 0.25f * t, 0.25f * t));
            dmg_use(b, car);
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_slide(b, 0, "head", v3(0, dmg_sign(b), 0), -0.3f * p->h, 0.3f * p->h);
    dmg_rod(b, v3(0, low - 0.2f * t, 0), v3(0, low + 0.2f * t, 0), plate + 0.4f * t);
    dmg_move(b, 0, low - 1.2f * t, 0);
    draw_head(b, p);
    dmg_use(b, 0);
    dmg_move(b, 0, high + base - low + 1.2f * t + 1.1f * p->w, 0);
    if (dmg_chance(b, 0.5f)) {
        dmg_box_span(b, v3(-0.1f * p->w, -1.15f * p->w, -0.1f * p->w), v3(0.1f * p->w, 0.1f * p->w, 0));
        draw_spool(b, 0, 0.7f * p->w);
    }
}

/* ---- a vat of resin ---- */

static void draw_vat_printer(dmg_builder* b, const solid_printer* p) {
    float x = p->w, z = p->d, base = p->h * dmg_range(b, 0.3f, 0.6f), t = 0.5f * p->t, high = p->h + 3 * t,
          way = 0.8f * p->h;
    float back = -z * dmg_range(b, 0.65f, 0.8f);
    dmg_box_span(b, v3(-x, 0, -z), v3(x, base, z));
    dmg_save(b);
    dmg_move(b, 0, 0.5f * base, z);
    dmg_controls_draw(b, 0, x, 0.7f * base);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.25f * x, base, back - 1.2f * t), v3(0.25f * x, base + high, back));
    dmg_move(b, 0, base, 0);
    if (dmg_chance(b, 0.5f)) dmg_slide(b, 0, "vat", dmg_chance(b, 0.6f) ? v3(0, 0, 1) : v3(0, 1, 0), 0.0f, 0.9f * z);
    dmg_box_span(b, v3(-0.7f * x, 0.01f * t, -0.4f * z), v3(0.7f * x, 0.3f * t, 0.7f * z));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * 0.66f * x, 0.9f * t, 0.15f * z), v3(0.08f * x, 1.8f * t, 1.1f * z));
        dmg_box(b, v3(0, 0.9f * t, 0.15f * z + (float)s * 0.51f * z), v3(1.4f * x, 1.8f * t, 0.08f * z));
    }
    dmg_use(b, 0);
    uint32_t plate = dmg_slide(b, 0, "plate", v3(0, 1, 0), 0.0f, way);
    if (dmg_chance(b, 0.6f)) dmg_rest(b, plate, way * dmg_unit(b));
    dmg_box_span(b, v3(-0.5f * x, 0.5f * t, -0.2f * z), v3(0.5f * x, 1.5f * t, 0.5f * z));
    dmg_box_span(b, v3(-0.12f * x, 1.5f * t, 0.05f * z), v3(0.12f * x, 3.5f * t, 0.25f * z));
    dmg_box_span(b, v3(-0.15f * x, 2.5f * t, back + 0.02f * t), v3(0.15f * x, 3.5f * t, 0.25f * z));
    if (dmg_chance(b, 0.6f)) {
        dmg_spin(b, plate, "knob", v3(0, 3.5f * t, 0.15f * z), v3(0, 1, 0));
        dmg_rod(b, v3(0, 3.5f * t, 0.15f * z), v3(0, 5 * t, 0.15f * z), 0.12f * x);
        dmg_box(b, v3(0, 5 * t, 0.15f * z), v3(0.4f * x, 0.4f * t, 0.1f * x));
    }
    dmg_use(b, 0);
    int cover = dmg_int(b, 0, 3);
    float pane = 0.25f * t, top = high + 1.5f * t + way * 0.15f;
    if (cover == 3) return;
    if (cover == 0) dmg_hinge(b, 0, "cover", v3(0, 0, -z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.7f));
    if (cover == 1) dmg_slide(b, 0, "cover", v3(0, 1, 0), 0.0f, 1.1f * top);
    if (cover == 2) dmg_hinge(b, 0, "cover", v3(-x, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 1.7f));
    dmg_box_span(b, v3(-x, top, -z), v3(x, top + pane, z));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * (x - 0.5f * pane), 0.5f * top + 0.01f * t, 0), v3(pane, top, 2 * z));
        dmg_box(b, v3(0, 0.5f * top + 0.01f * t, (float)s * (z - 0.5f * pane)), v3(2 * x, top, pane));
    }
    dmg_use(b, 0);
}

/* ---- plotters ---- */

/* Draws a beam along the length of a table or fixed over a roll of paper; the carriage's pen goes down. */
static void draw_plotter(dmg_builder* b, const solid_printer* p) {
    float x = p->w * dmg_range(b, 1.2f, 3.0f), z = p->d, t = p->t, base = t * dmg_range(b, 0.8f, 2.0f);
    bool roll = dmg_chance(b, 0.5f);
    if (roll && dmg_chance(b, 0.6f)) { /* on legs */
        float leg = p->w * dmg_range(b, 1.5f, 3.0f);
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * 0.8f * x - 0.5f * t, 0, -0.3f * t),
                         v3((float)s * 0.8f * x + 0.5f * t, leg, 0.3f * t));
            dmg_box_span(b, v3((float)s * 0.8f * x - 0.5f * t, 0, -z), v3((float)s * 0.8f * x + 0.5f * t, 0.5f * t, z));
        }
        dmg_move(b, 0, leg, 0);
    }
    float deep = roll ? 0.35f * z : z;
    dmg_box_span(b, v3(-x - 2 * t, 0, -deep - t), v3(x + 2 * t, base, deep + t));
    uint32_t beam = 0;
    if (!roll) beam = slide_about(b, 0, "beam", v3(1, 0, 0), 0.9f * x);
    if (roll)
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * (x + 1.2f * t) - 0.8f * t, base, -deep - t),
                         v3((float)s * (x + 1.2f * t) + 0.8f * t, base + 3 * t, deep + t));
    dmg_vec ends[2] = {roll ? v3(-x - t, base + 1.6f * t, -0.5f * t) : v3(0, base + 1.1f * t, -z),
                       roll ? v3(x + t, base + 1.6f * t, -0.5f * t) : v3(0, base + 1.1f * t, z)};
    draw_bar(b, p, ends[0], ends[1]);
    for (int s = 0; s < 2 && !roll; ++s)
        dmg_box(b, v3_add(ends[s], v3(0, -0.3f * t, 0)), v3(2 * t, 1.5f * t, 0.8f * t));
    uint32_t car = slide_about(b, beam, "carriage", roll ? v3(1, 0, 0) : v3(0, 0, 1), 0.85f * (roll ? x : z));
    dmg_vec at = roll ? v3(0, base + 1.6f * t, 0.5f * t) : v3(t, base + 1.1f * t, 0);
    dmg_box(b, at, v3(1.6f * t, 1.6f * t, 1.3f * t));
    at = v3_add(at, roll ? v3(0, 0, t) : v3(t, 0, 0));
    dmg_slide(b, car, "pen", v3(0, -1, 0), 0.0f, 0.35f * t);
    dmg_rod(b, v3_add(at, v3(0, -0.3f * t, 0)), v3_add(at, v3(0, 1.5f * t, 0)), 0.25f * t);
    dmg_cone(b, v3_add(at, v3(0, -0.3f * t, 0)), v3_add(at, v3(0, -0.6f * t, 0)), 0.25f * t, 0.03f * t);
    dmg_use(b, 0);
    if (!roll) return;
    dmg_spin(b, 0, "roll", v3(0, base + t, -deep - 2.5f * t), v3(dmg_sign(b), 0, 0));
    dmg_rod(b, v3(-0.95f * x, base + t, -deep - 2.5f * t), v3(0.95f * x, base + t, -deep - 2.5f * t),
            t * dmg_range(b, 0.7f, 1.3f));
    dmg_rod(b, v3(-x - t, base + t, -deep - 2.5f * t), v3(x + t, base + t, -deep - 2.5f * t), 0.3f * t);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * (x + t) - 0.3f * t, 0.3f * base, -deep - 3 * t),
                     v3((float)s * (x + t) + 0.3f * t, base + 1.5f * t, -deep));
    if (!dmg_chance(b, 0.6f)) return;
    dmg_hinge(b, 0, "cover", v3(0, base + 3 * t, -deep - t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.6f));
    dmg_box_span(b, v3(-x - 2 * t, base + 3 * t, -deep - t), v3(x + 2 * t, base + 3.4f * t, deep + t));
    dmg_use(b, 0);
}

void dmg_build_solid_printer(dmg_builder* b) {
    solid_printer p = pick_printer(b);
    int kind = dmg_weighted(b, (const float[]){0.28f, 0.28f, 0.12f, 0.16f, 0.16f}, 5);
    if (kind == 0) draw_gantry_printer(b, &p);
    if (kind == 1) draw_box_printer(b, &p);
    if (kind == 2) draw_tower_printer(b, &p);
    if (kind == 3) draw_vat_printer(b, &p);
    if (kind == 4) draw_plotter(b, &p);
}
