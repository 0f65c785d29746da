/* Draws engines as models and cut-open ones show them: upright, V and star engines with their valves, mill engines
 * on a bed, beam engines. A piston slides, its rod swings on it, crank and flywheel turn as one. */
#include "core/build.h"
#include "parts/cranks.h"
#include "parts/hardware.h"

/* ---- one cylinder: along +X from the crank at the origin ---- */

typedef struct cylinder {
    float bore, wall, head; /* radii; head: length of the piston */
    int shell;              /* tube, cut in half, finned tube, block with a hole, four columns */
    int piston;             /* plain, rings, crown and skirt, block */
    int top;                /* open, lid, lid with valves, lid with valves and rockers, plug */
} cylinder;

static cylinder pick_cylinder(dmg_builder* b, const dmg_crank* c) {
    cylinder y = {.bore = c->throw *dmg_range(b, 0.75f, 1.25f)};
    y.wall = y.bore * dmg_range(b, 0.08f, 0.3f);
    y.head = c->throw *dmg_range(b, 0.5f, 1.2f);
    y.shell = dmg_weighted(b, (const float[]){0.15f, 0.35f, 0.12f, 0.13f, 0.25f}, 5);
    y.piston = dmg_int(b, 0, 3);
    y.top = dmg_int(b, 0, 4);
    bool whole = y.shell != 1 && y.shell != 4;
    if (whole && dmg_chance(b, 0.65f)) y.top = 0; /* so that the piston shows */
    return y;
}

static void draw_piston(dmg_builder* b, const cylinder* y, float at) {
    float r = 0.97f * y->bore, low = at - 0.4f * y->head, high = low + y->head;
    if (y->piston == 0) dmg_rod(b, v3(low, 0, 0), v3(high, 0, 0), r);
    for (int i = 0; i < 3 && y->piston == 1; ++i)
        dmg_rod(b, v3(low + 0.34f * (float)i * y->head, 0, 0), v3(low + (0.34f * (float)i + 0.28f) * y->head, 0, 0), r);
    if (y->piston == 1) dmg_rod(b, v3(low, 0, 0), v3(high - 0.1f * y->head, 0, 0), 0.9f * r);
    if (y->piston == 2) {
        dmg_rod(b, v3(at + 0.1f * y->head, 0, 0), v3(high, 0, 0), r);
        dmg_tube_draw(b, v3(low, 0, 0), v3(1, 0, 0), 0.55f * y->head, 0.8f * r, 0.2f * r);
    }
    if (y->piston == 3) dmg_box(b, v3(0.5f * (low + high), 0, 0), v3(y->head, 1.4f * r, 1.4f * r));
}

static void draw_barrel(dmg_builder* b, const cylinder* y, float from, float to) {
    float length = to - from, r = y->bore + y->wall;
    if (y->shell == 0 || y->shell == 2) dmg_tube_draw(b, v3(from, 0, 0), v3(1, 0, 0), length, y->bore, y->wall);
    int fins = y->shell == 2 ? dmg_int(b, 3, 9) : 0;
    float fin = y->bore * dmg_range(b, 0.2f, 0.6f);
    for (int i = 0; i < fins; ++i)
        dmg_tube_draw(b, v3(from + length * ((float)i + 0.4f) / (float)fins, 0, 0), v3(1, 0, 0),
                      0.3f * length / (float)fins, r, fin);
    if (y->shell == 1) { /* what is behind remains */
        const dmg_xy wall[] = {{r, 0}, {r, length}, {y->bore, length}, {y->bore, 0}, {r, 0}};
        dmg_vec u, w;
        v3_basis(v3(1, 0, 0), &u, &w);
        dmg_lathe_arc(b, v3(from, 0, 0), v3(1, 0, 0), wall, 5, atan2f(-w.z, -u.z) - 0.5f * DMG_PI, DMG_PI);
    }
    if (y->shell == 3) {
        dmg_save(b);
        dmg_move(b, to, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_holed_plate_draw(b, 2.3f * r, 2.3f * r, length, y->bore);
        dmg_restore(b);
    }
    for (int i = 0; i < 4 && y->shell == 4; ++i) { /* nothing but what holds the lid */
        float s = i % 2 ? 1.0f : -1.0f, q = i / 2 ? 1.0f : -1.0f, off = 0.75f * r, thin = 0.5f * y->wall;
        dmg_rod(b, v3(from, s * off, q * off), v3(to, s * off, q * off), thin);
    }
}

/* Two valves hang through the lid, each in its spring or on a bare stem; rockers push them. */
static void draw_valves(dmg_builder* b, const cylinder* y, float top, bool rockers) {
    float r = 0.38f * y->bore, stem = r * dmg_range(b, 0.12f, 0.25f), out = y->bore * dmg_range(b, 0.5f, 1.0f),
          way = y->bore * dmg_range(b, 0.15f, 0.35f), lid = 0.25f * y->bore;
    bool spring = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s * 0.48f * y->bore, end = top + lid + out;
        dmg_slide(b, 0, "valve", v3(-1, 0, 0), 0.0f, way);
        dmg_rod(b, v3(top - 0.2f * r, side, 0), v3(end, side, 0), stem);
        dmg_cone(b, v3(top - 0.3f * r, side, 0), v3(top, side, 0), r, 0.4f * r);
        dmg_rod(b, v3(end - stem, side, 0), v3(end, side, 0), 0.6f * r);
        dmg_use(b, 0);
        for (int i = 0; i < 4 && spring; ++i)
            dmg_torus(b, v3(top + lid + (0.12f + 0.15f * (float)i) * out, side, 0), v3(1, 0, 0), 0.5f * r, 0.5f * stem);
        if (!rockers) continue;
        dmg_vec pin = {end + 1.2f * stem, (float)s * 1.05f * y->bore, 0};
        dmg_beam(b, v3(top + 0.5f * lid, pin.y, -2 * stem), v3(pin.x, pin.y, -2 * stem), 2 * stem, 2 * stem);
        dmg_rod(b, v3_add(pin, v3(0, 0, -2 * stem)), v3_add(pin, v3(0, 0, 2 * stem)), 0.7f * stem);
        dmg_hinge(b, 0, "rocker", pin, v3(0, 0, dmg_sign(b)), -0.25f, 0.25f);
        dmg_beam(b, v3_add(pin, v3(0.8f * stem, (float)s * 0.6f * y->bore, 0)), v3(pin.x + 0.8f * stem, side, 0),
                 1.6f * stem, 2 * stem);
        dmg_use(b, 0);
    }
}

/* Barrel, lid, piston and rod in the plane of the origin. */
static void draw_cylinder(dmg_builder* b, const dmg_crank* c, const cylinder* y) {
    float from = c->rod - c->throw -0.25f * y->head, top = c->rod + c->throw +0.7f * y->head, lid = 0.25f * y->bore,
          r = y->bore + y->wall, at = dmg_crank_at(c, c->angle);
    dmg_use(b, 0);
    draw_barrel(b, y, from, top);
    if (y->top > 0) dmg_rod(b, v3(top, 0, 0), v3(top + lid, 0, 0), (y->shell == 3 ? 1.15f : 1.02f) * r);
    if (y->top == 2 || y->top == 3) draw_valves(b, y, top, y->top == 3);
    if (y->top == 4) dmg_cone(b, v3(top + lid, 0, 0), v3(top + 4 * lid, 0, 0), 0.25f * r, 0.1f * r);
    uint32_t piston = dmg_crank_slider(b, c, "piston");
    draw_piston(b, y, at);
    dmg_crank_rod(b, c, piston, 0.0f);
    dmg_use(b, 0);
}

/* ---- engines with one shaft ---- */

typedef struct engine {
    dmg_crank crank;
    cylinder cylinder;
    float pitch; /* along the shaft */
    float room;  /* radius that the crank and its rods' ends sweep */
    int web, count;
    uint32_t shaft;
} engine;

static engine pick_engine(dmg_builder* b, int count) {
    engine e = {.crank = dmg_crank_pick(b, dmg_scale_range(b, 0.015f, 0.3f)), .count = count};
    e.cylinder = pick_cylinder(b, &e.crank);
    e.web = dmg_int(b, 0, 3);
    e.pitch = 2.0f * (e.cylinder.bore + e.cylinder.wall) * dmg_range(b, 1.15f, 1.4f);
    e.room = 1.25f * e.crank.throw +2.0f * e.crank.t;
    return e;
}

static void draw_throw(dmg_builder* b, const engine* e, const dmg_crank* c, float z, float half) {
    float thick = c->t * 0.7f;
    dmg_vec pin = dmg_crank_pin(c, z), off = {0, 0, half};
    dmg_rod(b, v3_sub(pin, off), v3_add(pin, off), 0.55f * c->t);
    dmg_web_draw(b, c, e->web, z - half - thick, thick);
    dmg_web_draw(b, c, e->web, z + half, thick);
}

/* On the shaft beyond z: a flywheel, and a pulley, a handle or nothing at the other end. */
static float draw_shaft_ends(dmg_builder* b, const engine* e, float low, float high) {
    float t = e->crank.t, wheel = e->room * dmg_range(b, 0.8f, 2.2f), wide = wheel * dmg_range(b, 0.1f, 0.35f);
    int kind = dmg_weighted(b, (const float[]){0.3f, 0.1f, 0.3f, 0.1f, 0.2f}, 5), end = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, 0, 0, high + t + 0.5f * wide);
    dmg_wheel_draw(b, kind, wheel, wide, dmg_int(b, 4, 8));
    dmg_restore(b);
    dmg_rod(b, v3(0, 0, high), v3(0, 0, high + 1.5f * t + wide), 0.7f * t);
    dmg_rod(b, v3(0, 0, low - 2 * t), v3(0, 0, low), 0.7f * t);
    if (end == 1) dmg_rod(b, v3(0, 0, low - 2.5f * t), v3(0, 0, low - t), 0.5f * e->room);
    if (end == 2) {
        dmg_beam(b, v3(0, 0, low - 2 * t), v3(0, 0.8f * wheel, low - 2 * t), t, t);
        dmg_rod(b, v3(0, 0.8f * wheel, low - 2 * t), v3(0, 0.8f * wheel, low - 5 * t), 0.5f * t);
    }
    return wheel;
}

/* Round the shaft from z = low to high: nothing but plates with bearings, a trough, a box open on a side. */
static void draw_crankcase(dmg_builder* b, const engine* e, int kind, float low, float high) {
    float r = 1.05f * e->room, wall = 0.12f * r, to = fmaxf(r, e->crank.rod - e->crank.throw);
    for (int s = -1; s <= 1; s += 2) {
        float z = s < 0 ? low - wall : high;
        if (kind == 3)
            dmg_box_span(b, v3(-r, -0.5f * r, z), v3(to, 0.5f * r, z + wall));
        else
            dmg_box_span(b, v3(-r, -r, z), v3(to, r, z + wall));
    }
    dmg_box_span(b, v3(-r - wall, -r, low - wall), v3(-r, r, high + wall));
    if (kind >= 1 && kind < 3) dmg_box_span(b, v3(-r, -r - wall, low - wall), v3(to, -r, high + wall));
    if (kind == 2) dmg_box_span(b, v3(-r, r, low - wall), v3(0.2f * to, r + wall, high + wall));
    float hole = e->cylinder.bore + 0.3f * e->cylinder.wall, deck = fmaxf(hole * 1.05f, kind == 3 ? 0.5f * r : r);
    for (int i = 0; i < e->count; ++i) { /* the deck */
        dmg_save(b);
        dmg_move(b, to, 0, ((float)i - 0.5f * (float)(e->count - 1)) * e->pitch);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_holed_plate_draw(b, e->pitch, 2 * deck, 0.5f * wall, hole);
        dmg_restore(b);
    }
}

/* Feet down to `low`, beside where the flywheel is. */
static void draw_engine_feet(dmg_builder* b, const engine* e, float low, float z_low, float z_high) {
    float r = 1.05f * e->room, wide = r * dmg_range(b, 1.1f, 1.6f);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_box_span(b, v3(low, -wide, z_low), v3(-r, wide, z_high));
    for (int s = -1; s <= 1 && kind == 1; s += 2)
        dmg_beam(b, v3(low, (float)s * wide, 0.5f * (z_low + z_high)),
                 v3(-r, (float)s * 0.7f * r, 0.5f * (z_low + z_high)), z_high - z_low, 0.25f * r);
    for (int s = -1; s <= 1 && kind == 2; s += 2)
        dmg_box_span(b, v3(low, -wide, s < 0 ? z_low : z_high - 0.2f * r),
                     v3(-r, wide, s < 0 ? z_low + 0.2f * r : z_high));
    if (kind > 0) dmg_box_span(b, v3(low, -1.3f * wide, 1.1f * z_low), v3(low + 0.1f * r, 1.3f * wide, 1.1f * z_high));
}

/* Cylinders in a row over the shaft; a shaft with cams along their heads. */
static void draw_row_engine(dmg_builder* b) {
    engine e = pick_engine(b, dmg_int(b, 1, 4));
    float half = 0.5f * (float)e.count * e.pitch, big = 0.3f * e.pitch;
    int kind = dmg_int(b, 0, 3);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI); /* +X is up */
    e.shaft = dmg_spin(b, 0, "crankshaft", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    float wheel = draw_shaft_ends(b, &e, -half, half), low = -fmaxf(1.1f * wheel, 1.5f * e.room);
    bool apart = e.count > 2;
    for (int i = 0; i < e.count; ++i) {
        dmg_crank c = e.crank;
        c.angle += 2.0f * DMG_PI * (apart ? 0.5f * (float)((i + 1) / 2) : (float)i / (float)e.count);
        float z = ((float)i - 0.5f * (float)(e.count - 1)) * e.pitch;
        dmg_use(b, e.shaft);
        draw_throw(b, &e, &c, z, fminf(big, 0.8f * c.t));
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0, 0, z + (float)s * 0.5f * e.pitch), v3(0, 0, z + (float)s * 0.8f * c.t), 0.7f * c.t);
        dmg_save(b);
        dmg_move(b, 0, 0, z);
        draw_cylinder(b, &c, &e.cylinder);
        dmg_restore(b);
    }
    draw_crankcase(b, &e, kind, -half, half);
    draw_engine_feet(b, &e, low, -half, half);
}

/* Cylinders round one crank: V engines and stars; the case is a ring open in front. */
static void draw_star_engine(dmg_builder* b) {
    int count = dmg_chance(b, 0.4f) ? 2 : dmg_int(b, 3, 7);
    engine e = pick_engine(b, count);
    if (e.cylinder.shell == 3) e.cylinder.shell = 0;
    if (e.cylinder.top == 3) e.cylinder.top = 2;
    float spread = count == 2 ? dmg_range(b, 0.7f, 3.14f) : 2.0f * DMG_PI / (float)count, t = e.crank.t,
          wide = 1.2f * (e.cylinder.bore + e.cylinder.wall);
    /* Neighbours stand clear of each other where their barrels begin. */
    float beside = wide / tanf(fminf(0.5f * spread, 1.2f)),
          begin = e.crank.rod - e.crank.throw -0.25f * e.cylinder.head;
    if (beside > begin) e.crank.rod += beside - begin;
    float r = fmaxf(e.room, e.crank.rod - e.crank.throw -0.3f * e.cylinder.head), ring = 0.08f * r;
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    e.shaft = dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_web_draw(b, &e.crank, e.web, -1.5f * t, t);
    dmg_vec pin = dmg_crank_pin(&e.crank, 0);
    dmg_rod(b, v3_add(pin, v3(0, 0, -t)), v3_add(pin, v3(0, 0, 1.2f * t)), 0.6f * t);
    float wheel = draw_shaft_ends(b, &e, -wide, wide), base = dmg_range(b, 0.2f, 0.6f) * r;
    dmg_rod(b, v3(0, 0, -wide), v3(0, 0, -t), 0.7f * t);
    dmg_use(b, 0);
    dmg_tube_draw(b, v3(0, 0, -wide - 0.1f * r), v3(0, 0, 1), 0.1f * r, t, r - t); /* the back */
    if (dmg_chance(b, 0.6f)) dmg_tube_draw(b, v3(0, 0, -wide), v3(0, 0, 1), 0.4f * wide, r - ring, ring);
    dmg_box_span(b, v3(-fmaxf(wheel, r) - base, -0.8f * r, -wide - 0.1f * r), v3(-0.9f * r, 0.8f * r, -wide));
    dmg_box_span(b, v3(-fmaxf(wheel, r) - base, -1.2f * r, -1.5f * wide),
                 v3(-fmaxf(wheel, r) - 0.8f * base, 1.2f * r, wide));
    for (int i = 0; i < count; ++i) {
        float turn = spread * ((float)i - (count == 2 ? 0.5f : 0.0f));
        dmg_crank c = e.crank;
        c.angle -= turn;
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), turn);
        draw_cylinder(b, &c, &e.cylinder);
        dmg_restore(b);
    }
}

/* ---- engines with a crosshead ---- */

/* Draws the crosshead's block between its bars, its rod into a cylinder lying beyond. */
static float draw_crosshead(dmg_builder* b, const dmg_crank* c, const cylinder* y, uint32_t slider) {
    float at = dmg_crank_at(c, c->angle), t = c->t, s = 0.8f * t, in = c->rod - c->throw, out = c->rod + c->throw,
          from = out + 2.0f * t + s, end = from + 2.0f * c->throw +y->head + 2 * t, middle = from + (at - in) + t;
    dmg_use(b, slider);
    dmg_box(b, v3(at, 0, 0), v3(2 * s, 2 * s, 1.6f * s));
    dmg_rod(b, v3(at, 0, 0), v3(middle, 0, 0), 0.35f * t);
    dmg_rod(b, v3(middle, 0, 0), v3(middle + y->head, 0, 0), 0.97f * y->bore);
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3(in - 1.5f * s, (float)k * 1.3f * s - 0.28f * s, -0.7f * s),
                     v3(from, (float)k * 1.3f * s + 0.28f * s, 0.7f * s));
    draw_barrel(b, y, from, end);
    dmg_tube_draw(b, v3(from - 0.3f * t, 0, 0), v3(1, 0, 0), 0.3f * t, 0.4f * t, y->bore + y->wall - 0.4f * t);
    if (y->top > 0) dmg_rod(b, v3(end, 0, 0), v3(end + 0.3f * t, 0, 0), 1.1f * (y->bore + y->wall));
    return end;
}

/* Draws a spindle with two balls that swing out on arms. */
static void draw_governor(dmg_builder* b, float high, float t) {
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.4f * high, 0), t);
    uint32_t spindle = dmg_spin(b, 0, "governor", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, 0.4f * high, 0), v3(0, high, 0), 0.5f * t);
    float hang = dmg_range(b, 0.4f, 1.1f), arm = 0.45f * high;
    bool swing = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec pin = {(float)s * 0.5f * t, high, 0},
                ball = {pin.x + (float)s * arm * sinf(hang), high - arm * cosf(hang), 0};
        if (swing) dmg_hinge(b, spindle, "ball", pin, v3(0, 0, (float)s), 0.35f - hang, 1.3f - hang);
        dmg_beam(b, pin, ball, 0.4f * t, 0.4f * t);
        dmg_ellipsoid(b, ball, v3(1.6f * t, 1.6f * t, 1.6f * t));
        dmg_use(b, spindle);
    }
    dmg_use(b, 0);
}

/* On a bed, the flywheel beside it. */
static void draw_mill_engine(dmg_builder* b) {
    dmg_crank c = dmg_crank_pick(b, dmg_scale_range(b, 0.02f, 0.5f));
    cylinder y = pick_cylinder(b, &c);
    float t = c.t, wheel = c.throw *dmg_range(b, 1.5f, 3.5f), wide = wheel * dmg_range(b, 0.08f, 0.25f), z = 2.5f * t,
          high = 1.5f * c.throw +3 * t, deep = fmaxf(y.bore + y.wall, 1.5f * t) * dmg_range(b, 1.1f, 1.6f);
    int web = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 4), spokes = dmg_int(b, 4, 8);
    uint32_t shaft = dmg_spin(b, 0, "flywheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_web_draw(b, &c, web, -1.6f * t, t);
    dmg_vec pin = dmg_crank_pin(&c, 0);
    dmg_rod(b, v3_add(pin, v3(0, 0, -t)), v3_add(pin, v3(0, 0, 0.8f * t)), 0.5f * t);
    dmg_rod(b, v3(0, 0, -deep - z - wide), v3(0, 0, -t), 0.7f * t);
    dmg_save(b);
    dmg_move(b, 0, 0, -deep - z - 0.5f * wide);
    dmg_wheel_draw(b, kind == 4 ? 3 : kind, wheel, wide, spokes);
    dmg_restore(b);
    dmg_use(b, shaft);
    uint32_t head = dmg_crank_slider(b, &c, "crosshead");
    float end = draw_crosshead(b, &c, &y, head), low = -high - t;
    dmg_crank_rod(b, &c, head, 0.0f);
    dmg_use(b, 0);
    dmg_box_span(b, v3(-1.5f * c.throw, low, -deep), v3(end, -1.5f * c.throw -2 * t, deep)); /* bed and saddles */
    dmg_box_span(b, v3(c.rod - c.throw -2 * t, low, -0.7f * t), v3(c.rod - c.throw -t, -0.7f * t, 0.7f * t));
    float saddle = 0.25f * (end - c.rod - c.throw);
    for (int s = 1; s <= 3; s += 2)
        dmg_box_span(b, v3(end - ((float)s + 0.4f) * saddle, low, -0.6f * deep),
                     v3(end - ((float)s - 0.4f) * saddle, -y.bore - 0.5f * y.wall, 0.6f * deep));
    for (int s = 0; s <= 1; ++s) { /* pedestals of the shaft */
        float at = s ? -deep - 1.3f * z - wide : -2.9f * t;
        dmg_box(b, v3(0, 0.5f * (low - t), at), v3(3 * t, -low - t, 1.2f * t));
        dmg_tube_draw(b, v3(0, 0, at - 0.6f * t), v3(0, 0, 1), 1.2f * t, 0.75f * t, 0.6f * t);
    }
    if (dmg_chance(b, 0.6f))
        dmg_box_span(b, v3(-2 * c.throw, low - t, -deep - 2 * z - wide), v3(1.1f * end, low, 2 * deep));
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0.4f * c.rod, -1.5f * c.throw -2 * t, 0.8f * deep);
        draw_governor(b, c.throw *dmg_range(b, 1.5f, 2.5f), 0.4f * t);
    }
}

/* ---- beam engines ---- */

/* Draws what hangs from an end of the beam: its own part, its joint on the beam. */
static void draw_hanger(dmg_builder* b, uint32_t beam, const dmg_crank* c, const char* name, dmg_vec from, dmg_vec to) {
    dmg_hinge(b, beam, name, from, v3(0, 0, dmg_sign(b)), -0.35f, 0.35f);
    dmg_link_draw(b, c, from, to);
    dmg_use(b, beam);
}

static void draw_beam_column(dmg_builder* b, float high, float t) {
    int kind = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * 1.4f * t;
        if (kind == 0) dmg_cone(b, v3(0, 0, z), v3(0, high, z), 1.2f * t, 0.6f * t);
        for (int k = -1; k <= 1 && kind == 1; k += 2)
            dmg_beam(b, v3((float)k * 0.25f * high, 0, z), v3(0, high, z), 0.6f * t, 0.6f * t);
        if (kind == 2) dmg_box_span(b, v3(-1.5f * t, 0, z - 0.4f * t), v3(1.5f * t, high, z + 0.4f * t));
        dmg_tube_draw(b, v3(0, high, z - 0.4f * t), v3(0, 0, 1), 0.8f * t, 0.5f * t, 0.4f * t);
    }
}

/* A beam rocks on columns; a cylinder under one end, a crank or a pump under the other. */
static void draw_beam_engine(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.1f, 3.0f), high = half * dmg_range(b, 1.2f, 2.2f),
          t = half * dmg_range(b, 0.04f, 0.1f), swing = dmg_range(b, 0.15f, 0.35f),
          tilt = swing * dmg_range(b, -0.8f, 0.8f), bore = t * dmg_range(b, 1.5f, 4.0f);
    dmg_crank c = dmg_crank_pick(b, half * sinf(swing) * 0.9f);
    c.t = 1.2f * t;
    c.eye = t;
    dmg_box_span(b, v3(-1.4f * half, -t, -0.4f * half), v3(1.5f * half, 0, 0.4f * half));
    draw_beam_column(b, high, t);
    dmg_vec ends[2] = {{-half * cosf(tilt), high - half * sinf(tilt), 0},
                       {half * cosf(tilt), high + half * sinf(tilt), 0}};
    uint32_t beam = dmg_hinge(b, 0, "beam", v3(0, high, 0), v3(0, 0, 1), -swing - tilt, swing - tilt);
    dmg_rod(b, v3(0, high, -1.9f * t), v3(0, high, 1.9f * t), 0.5f * t);
    bool deep = dmg_chance(b, 0.5f);
    dmg_vec mid = {0, high, 0};
    for (int e = 0; e < 2; ++e) {
        dmg_beam(b, mid, ends[e], t, 1.2f * t);
        if (deep) dmg_beam(b, v3_add(mid, v3(0, 1.5f * t, 0)), ends[e], 0.8f * t, t);
    }
    float reach = half * (sinf(swing) + sinf(tilt)), cylinder_high = fmaxf(0.3f * high, 2.2f * half * sinf(swing));
    float up = fminf(ends[0].y - 0.15f * high, cylinder_high + reach + t);
    draw_hanger(b, beam, &c, "link", ends[0], v3(-half, up, 0));
    dmg_use(b, 0);
    dmg_slide(b, 0, "piston", v3(0, 1, 0), -0.9f * reach, 0.9f * half * (sinf(swing) - sinf(tilt)));
    dmg_rod(b, v3(-half, up - 0.8f * cylinder_high, 0), v3(-half, up, 0), 0.45f * t);
    dmg_use(b, 0);
    dmg_tube_draw(b, v3(-half, 0, 0), v3(0, 1, 0), cylinder_high, bore, 0.3f * t);
    dmg_tube_draw(b, v3(-half, cylinder_high, 0), v3(0, 1, 0), 0.3f * t, 0.5f * t, bore + 0.1f * t);
    float hub = 1.3f * c.throw +2 * t, wheel = hub * dmg_range(b, 0.7f, 0.95f);
    dmg_vec pin = {half + c.throw *cosf(c.angle), hub + c.throw *sinf(c.angle), 0};
    draw_hanger(b, beam, &c, "rod", ends[1], pin);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(half - t, 0, (float)s * 3 * t - 0.4f * t),
                     v3(half + t, hub - 0.8f * t, (float)s * 3 * t + 0.4f * t));
    dmg_spin(b, 0, "flywheel", v3(half, hub, 0), v3(0, 0, dmg_sign(b)));
    int web = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 4), spokes = dmg_int(b, 4, 8);
    dmg_move(b, half, hub, 0);
    dmg_web_draw(b, &c, web, -1.7f * t, t);
    dmg_rod(b, v3(c.throw *cosf(c.angle), c.throw *sinf(c.angle), -t),
            v3(c.throw *cosf(c.angle), c.throw *sinf(c.angle), 0.7f * t), 0.5f * t);
    dmg_rod(b, v3(0, 0, -6 * t), v3(0, 0, -t), 0.6f * t);
    dmg_move(b, 0, 0, -5 * t);
    dmg_wheel_draw(b, kind == 1 ? 3 : kind, wheel * 1.2f, 1.5f * t, spokes);
    dmg_use(b, 0);
}

void dmg_build_piston_engine(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){0.35f, 0.25f, 0.25f, 0.15f}, 4);
    if (kind == 0) draw_row_engine(b);
    if (kind == 1) draw_star_engine(b);
    if (kind == 2) draw_mill_engine(b);
    if (kind == 3) draw_beam_engine(b);
}
