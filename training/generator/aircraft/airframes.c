/* Draws airframes as low-polygon models have them: a hull of few corners, tails of every layout, control surfaces
 * cut out of one skin, with tabs; and wings with slats, flaps and spoilers. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/wings.h"

/* ---- surfaces ---- */

/* Where a modeller puts a surface's line: along its leading edge inside the wing, on its skin, or straight across. */
typedef enum line_habit { LINE_INSIDE, LINE_SKIN, LINE_ACROSS } line_habit;

static line_habit pick_habit(dmg_builder* b) {
    return (line_habit)dmg_int(b, LINE_INSIDE, LINE_ACROSS);
}

/* Lowers the trailing edge; the part is in use afterwards. */
static uint32_t add_surface(dmg_builder* b, uint32_t parent, const dmg_wing* w, const dmg_surface* f,
                            line_habit habit) {
    float side = habit == LINE_SKIN ? (f->drops ? -1.0f : 1.0f) : 0.0f;
    dmg_vec from = dmg_wing_point(w, f->s0, f->c, side), to = dmg_wing_point(w, f->s1, f->c, side);
    bool across = habit == LINE_ACROSS;
    return dmg_hinge(b, parent, f->name, across ? v3_lerp(from, to, 0.5f) : from,
                     across ? v3(-1, 0, 0) : v3_normalize(v3_sub(from, to)), f->drops ? 0.0f : -f->swing, f->swing);
}

/* Draws a surface, perhaps with a tab cut out of it that turns on it. */
static void draw_tabbed(dmg_builder* b, uint32_t surface, const dmg_wing* w, const dmg_surface* f, line_habit habit) {
    if (dmg_chance(b, 0.65f)) {
        dmg_wing_piece_draw(b, w, f->s0, f->s1, f->c, 1);
        return;
    }
    float width = f->s1 - f->s0, t0 = f->s0 + width * dmg_range(b, 0.05f, 0.4f),
          t1 = fminf(t0 + width * dmg_range(b, 0.2f, 0.6f), f->s1 - 0.02f * width),
          c = f->c + (1 - f->c) * dmg_range(b, 0.45f, 0.8f), turn = dmg_range(b, 0.2f, 0.6f);
    dmg_wing_piece_draw(b, w, f->s0, t0, f->c, 1);
    dmg_wing_piece_draw(b, w, t0, t1, f->c, c);
    dmg_wing_piece_draw(b, w, t1, f->s1, f->c, 1);
    dmg_surface tab = {.name = "tab", .s0 = t0, .s1 = t1, .c = c, .swing = turn};
    add_surface(b, surface, w, &tab, habit);
    dmg_wing_piece_draw(b, w, t0, t1, c, 1);
}

/* Draws the fixed skin round the surfaces, which are in order along the span. */
static void draw_fixed(dmg_builder* b, const dmg_wing* w, const dmg_surface* surfaces, int count) {
    float done = 0.0f;
    for (int i = 0; i < count; ++i) {
        if (surfaces[i].s0 > done) dmg_wing_piece_draw(b, w, done, surfaces[i].s0, 0, 1);
        dmg_wing_piece_draw(b, w, surfaces[i].s0, surfaces[i].s1, 0, surfaces[i].c);
        done = surfaces[i].s1;
    }
    if (done < 1.0f) dmg_wing_piece_draw(b, w, done, 1, 0, 1);
}

static void draw_side(dmg_builder* b, const dmg_wing* w, const dmg_surface* surfaces, int count, line_habit habit) {
    dmg_use(b, 0);
    draw_fixed(b, w, surfaces, count);
    for (int i = 0; i < count; ++i) draw_tabbed(b, add_surface(b, 0, w, &surfaces[i], habit), w, &surfaces[i], habit);
    dmg_use(b, 0);
}

/* Both sides, each surface a part of its own, or the pair one part about a line across (`joined`). */
static void draw_both(dmg_builder* b, const dmg_wing* w, const dmg_surface* surfaces, int count, bool joined) {
    line_habit habit = pick_habit(b);
    uint32_t pair = 0;
    if (joined) {
        dmg_vec middle = dmg_wing_point(w, 0.5f * (surfaces->s0 + surfaces->s1), surfaces->c, 0);
        pair =
            dmg_hinge(b, 0, surfaces->name, v3(0, middle.y, middle.z), v3(-1, 0, 0), -surfaces->swing, surfaces->swing);
    }
    for (int side = 0; side < 2; ++side) {
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        if (joined) {
            dmg_use(b, 0);
            draw_fixed(b, w, surfaces, 1);
            dmg_use(b, pair);
            dmg_wing_piece_draw(b, w, surfaces->s0, surfaces->s1, surfaces->c, 1);
        } else {
            draw_side(b, w, surfaces, count, habit);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- airframe ---- */

typedef struct airframe {
    float radius, high, nose, tail, lift; /* lift: of the hull's end */
} airframe;

/* Draws a hull of four to eight corners and five sections. */
static void draw_skin(dmg_builder* b, const airframe* a) {
    dmg_xy outline[8];
    int corners = dmg_int(b, 4, 8);
    float turn = dmg_chance(b, 0.7f) ? 0.5f : 0.0f, end = dmg_range(b, 0.08f, 0.4f), point = dmg_range(b, 0.1f, 0.7f),
          drop = a->radius * dmg_range(b, -0.3f, 0.1f), full = dmg_range(b, 0.1f, 0.6f);
    for (int i = 0; i < corners; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + turn) / (float)corners;
        outline[i] = (dmg_xy){a->radius * cosf(angle), a->high * a->radius * sinf(angle)};
    }
    const dmg_row rows[] = {{end, end, a->lift, -a->tail},
                            {0.6f + 0.3f * full, 0.6f + 0.3f * full, 0.4f * a->lift, -0.5f * a->tail},
                            {1, 1, 0, -0.05f * a->tail},
                            {1, 1, 0, full * a->nose},
                            {point, 0.8f * point, drop, a->nose}};
    dmg_loft(b, outline, corners, rows, 5);
}

static dmg_surface pick_surface(dmg_builder* b, const char* name, float s0, float s1) {
    dmg_surface f = {.name = name, .s0 = s0, .s1 = s1};
    f.c = dmg_range(b, 0.5f, 0.85f);
    f.swing = dmg_range(b, 0.25f, 0.8f);
    return f;
}

/* `count` fins standing on the hull, leaning outwards by `cant` (more than a right angle: hanging). */
static void draw_fins(dmg_builder* b, const dmg_wing* fin, int count, float apart, float cant, const char* name) {
    float from = dmg_range(b, 0.0f, 0.25f), to = dmg_range(b, 0.6f, 1.0f);
    dmg_surface rudder = pick_surface(b, name, from, to);
    line_habit habit = pick_habit(b);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        if (i) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, apart, 0, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI - cant);
        draw_side(b, fin, &rudder, 1, habit);
        dmg_restore(b);
    }
}

static void draw_tailplane(dmg_builder* b, const airframe* a, float root) {
    dmg_wing plane = dmg_wing_pick(b, a->radius * dmg_range(b, 1.3f, 4.0f), root);
    plane.dihedral = dmg_range(b, -0.15f, 0.2f);
    float from = dmg_range(b, 0.05f, 0.3f), to = dmg_range(b, 0.8f, 1.0f);
    dmg_surface elevator = pick_surface(b, "elevator", from, to);
    draw_both(b, &plane, &elevator, 1, dmg_chance(b, 0.45f));
}

/* On a pair of booms from the wing: fins at their ends and a plane between them. */
static void draw_booms(dmg_builder* b, const airframe* a, float root) {
    float x = a->radius * dmg_range(b, 1.3f, 3.0f), t = 0.25f * a->radius;
    dmg_wing fin = dmg_wing_pick(b, a->radius * dmg_range(b, 0.8f, 2.0f), root);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * x, 0, -a->tail), v3((float)s * x, 0, 0.1f * a->nose), t, t);
    dmg_move(b, 0, 0, -a->tail + 0.5f * root);
    draw_fins(b, &fin, 2, x, dmg_range(b, -0.3f, 0.3f), "rudder");
    dmg_wing plane = {.span = x, .root = 0.8f * root, .tip = 0.8f * root, .thick = 0.08f};
    dmg_surface elevator = pick_surface(b, "elevator", 0, 0.95f);
    draw_both(b, &plane, &elevator, 1, dmg_chance(b, 0.7f));
}

static void draw_tail(dmg_builder* b, const airframe* a) {
    float root = a->radius * dmg_range(b, 0.9f, 2.2f);
    int kind = dmg_int(b, 0, 5); /* upright, T, V, canted pair, booms, V hanging down */
    dmg_save(b);
    if (kind == 4) {
        draw_booms(b, a, root);
    } else {
        dmg_move(b, 0, a->lift, -a->tail + 0.5f * root);
        dmg_wing fin = dmg_wing_pick(b, a->radius * dmg_range(b, 1.2f, 3.0f), root);
        fin.thick = fminf(fin.thick, 0.1f);
        if (kind == 2 || kind == 5)
            draw_fins(b, &fin, 2, 0, kind == 2 ? dmg_range(b, 0.5f, 1.1f) : dmg_range(b, 2.0f, 2.5f), "ruddervator");
        else if (kind == 3)
            draw_fins(b, &fin, 2, 0.2f * a->radius, dmg_range(b, 0.15f, 0.6f), "rudder");
        else
            draw_fins(b, &fin, 1, 0, 0, "rudder");
        if (kind == 1) dmg_move(b, 0, fin.span, -fin.sweep);
        if (kind == 0 || kind == 1 || kind == 3) draw_tailplane(b, a, 0.8f * (kind == 1 ? fin.tip : root));
    }
    dmg_restore(b);
}

static void draw_spinner(dmg_builder* b, float radius, float blade) {
    dmg_spin(b, 0, "propeller", v3(0, 0, 0), v3(0, 0, 1));
    float length = radius * dmg_range(b, 0.8f, 2.5f);
    const dmg_xy cone[] = {{0, 0}, {radius, 0}, {0.75f * radius, 0.5f * length}, {0, length}};
    if (dmg_chance(b, 0.8f)) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cone, 4);
    dmg_move(b, 0, 0, 0.3f * length);
    float turn = dmg_range(b, 0, 3), chord = blade * dmg_range(b, 0.08f, 0.25f), twist = dmg_range(b, 0.1f, 0.9f);
    int count = dmg_int(b, 2, 6);
    if (dmg_chance(b, 0.15f)) { /* a disc stands for the blur */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.01f * blade), blade);
        return;
    }
    dmg_turn(b, v3(0, 0, 1), turn);
    dmg_blades_draw(b, dmg_int(b, 0, 2), blade, radius, chord, count, twist);
}

void dmg_build_airframe(dmg_builder* b) {
    airframe a = {.radius = dmg_scale_range(b, 0.05f, 3.0f)};
    a.high = dmg_range(b, 0.7f, 1.5f);
    a.nose = a.radius * dmg_range(b, 2.0f, 6.0f);
    a.tail = a.radius * dmg_range(b, 3.0f, 8.0f);
    a.lift = a.radius * a.high * dmg_range(b, 0.0f, 0.7f);
    dmg_move(b, 0, 3.0f * a.radius, 0);
    draw_skin(b, &a);
    dmg_save(b);
    const float z = a.radius * dmg_range(b, 0.0f, 1.0f), y = a.high * a.radius * dmg_range(b, -0.8f, 0.9f);
    dmg_move(b, 0, y, z);
    const float root = a.radius * dmg_range(b, 1.5f, 3.0f), span = a.radius * dmg_range(b, 3.5f, 10.0f);
    dmg_wing wing = dmg_wing_pick(b, span, root);
    wing.dihedral = dmg_range(b, -0.08f, 0.2f);
    dmg_surface surfaces[2];
    int layout = dmg_int(b, 0, 2),
        count = dmg_surfaces_pick(b, surfaces, layout == 1 ? NULL : "flap", layout == 2 ? NULL : "aileron");
    if (layout != 1) surfaces[0].drops = true;
    draw_both(b, &wing, surfaces, count, false);
    dmg_restore(b);
    draw_tail(b, &a);
    if (dmg_chance(b, 0.5f)) {
        float spinner = a.radius * dmg_range(b, 0.15f, 0.4f), blade = a.radius * dmg_range(b, 1.0f, 2.5f);
        dmg_move(b, 0, 0, a.nose);
        draw_spinner(b, spinner, blade);
        dmg_use(b, 0);
    }
}

/* ---- a wing with all that moves on it ---- */

typedef struct lift_devices {
    float front, back, slat;    /* chord fractions where spoilers begin, trailing edge devices begin, slats end */
    int trailing, leading, top; /* kinds */
    float inner, middle, outer; /* along the span */
} lift_devices;

enum { TRAILING_FOWLER, TRAILING_PLAIN, TRAILING_SPLIT, TRAILING_BELOW, TRAILING_KINDS };

/* Draws one flap between s0 and s1. */
static void draw_flap(dmg_builder* b, uint32_t parent, const dmg_wing* w, const lift_devices* d, float s0, float s1,
                      float swing, float way) {
    dmg_vec from = dmg_wing_point(w, s0, d->back, -1), to = dmg_wing_point(w, s1, d->back, -1);
    dmg_vec line = v3_normalize(v3_sub(from, to));
    float chord = (1 - d->back) * w->root;
    if (d->trailing == TRAILING_FOWLER) {
        float down = 0.5f * swing;
        dmg_slide(b, parent, "flap", v3(0, -sinf(down), -cosf(down)), 0.0f, way * chord);
    } else if (d->trailing == TRAILING_BELOW) { /* on brackets, about a line under the wing */
        float under = chord * (0.1f + 0.25f * way);
        dmg_hinge(b, parent, "flap", v3_add(from, v3(0, -under, 0)), line, 0.0f, 0.7f * swing);
        dmg_vec middle = v3_lerp(from, to, 0.5f);
        dmg_beam(b, v3_add(middle, v3(0, -under, 0)), v3_add(middle, v3(0, 0, -0.4f * chord)),
                 0.03f * w->span * (s1 - s0), 0.2f * under);
    } else {
        dmg_hinge(b, parent, "flap", from, line, 0.0f, swing);
    }
    if (d->trailing == TRAILING_SPLIT) { /* the lower skin alone */
        dmg_wing thin = *w;
        thin.thick = 0.012f;
        thin.flat = true;
        dmg_save(b);
        dmg_move(b, 0,
                 dmg_wing_point(w, 0.5f * (s0 + s1), 0.7f * d->back + 0.3f, -1).y -
                     0.5f * (s0 + s1) * w->span * w->dihedral,
                 0);
        dmg_wing_piece_draw(b, &thin, s0, s1, d->back, 1);
        dmg_restore(b);
    } else {
        dmg_wing_piece_draw(b, w, s0, s1, d->back, 1);
    }
    dmg_use(b, parent);
}

/* At the leading edge: slats that run forwards and down, or doors that swing out from under the nose. */
static void draw_slat(dmg_builder* b, uint32_t parent, const dmg_wing* w, const lift_devices* d, float s0, float s1,
                      float down, float way) {
    float chord = d->slat * w->root;
    if (d->leading == 1) {
        dmg_slide(b, parent, "slat", v3(0, -sinf(down), cosf(down)), 0.0f, way * chord);
        dmg_wing_piece_draw(b, w, s0, s1, 0, d->slat);
    } else {
        dmg_vec from = dmg_wing_point(w, s0, 0.03f, -1.1f), to = dmg_wing_point(w, s1, 0.03f, -1.1f);
        dmg_hinge(b, parent, "leading_edge_flap", from, v3_normalize(v3_sub(from, to)), 0.0f, 1.2f + down);
        dmg_vec back = v3(0, 0.1f * chord, -chord);
        dmg_beam(b, v3_lerp(from, v3_add(from, back), 0.5f), v3_lerp(to, v3_add(to, back), 0.5f), chord, 0.04f * chord);
    }
    dmg_use(b, parent);
}

/* On top: panels that rise at their front edge, or plates that come straight up. */
static void draw_spoiler(dmg_builder* b, uint32_t parent, const dmg_wing* w, const lift_devices* d, float s0, float s1,
                         float swing) {
    dmg_vec from = dmg_wing_point(w, s0, d->front, 1), to = dmg_wing_point(w, s1, d->front, 1);
    float chord = (d->back - d->front) * w->root, t = 0.01f * w->root;
    if (d->top == 1) {
        dmg_vec back = v3_lerp(dmg_wing_point(w, s0, d->back, 1), dmg_wing_point(w, s1, d->back, 1), 0.5f);
        dmg_hinge(b, parent, "spoiler", from, v3_normalize(v3_sub(to, from)), 0.0f, swing);
        dmg_vec off = v3_scale(v3_sub(back, v3_lerp(from, to, 0.5f)), 0.5f);
        off.y += 0.5f * t;
        dmg_beam(b, v3_add(from, off), v3_add(to, off), 0.9f * chord, t);
    } else {
        float rise = chord * (0.3f + 0.5f * swing);
        dmg_slide(b, parent, "air_brake", v3(0, 1, 0), 0.0f, rise);
        dmg_beam(b, v3_add(from, v3(0, -0.1f * rise, 0)), v3_add(to, v3(0, -0.1f * rise, 0)), t, 0.25f * rise);
    }
    dmg_use(b, parent);
}

/* Draws what lies between two places along the span: fixed middle, then the devices in their strips. */
static void draw_bay(dmg_builder* b, uint32_t parent, const dmg_wing* w, const lift_devices* d, float s0, float s1) {
    int flaps = dmg_int(b, 1, 2), slats = dmg_int(b, 1, 3), panels = dmg_int(b, 1, 3);
    float swing = dmg_range(b, 0.4f, 1.0f), way = dmg_range(b, 0.4f, 1.1f), down = dmg_range(b, 0.1f, 0.8f),
          rise = dmg_range(b, 0.4f, 1.1f);
    bool whole = d->trailing == TRAILING_SPLIT;
    dmg_use(b, parent);
    dmg_wing_piece_draw(b, w, s0, s1, d->leading == 1 ? d->slat : 0.0f, whole ? 1.0f : d->back);
    for (int i = 0; i < flaps; ++i) {
        float each = (s1 - s0) / (float)flaps, at = s0 + each * (float)i;
        draw_flap(b, parent, w, d, at, at + 0.98f * each, swing, way);
    }
    for (int i = 0; i < slats && d->leading; ++i) {
        float each = (s1 - s0) / (float)slats, at = s0 + each * (float)i;
        draw_slat(b, parent, w, d, at, at + 0.98f * each, down, way);
    }
    for (int i = 0; i < panels && d->top; ++i) {
        float each = (s1 - s0) / (float)panels, at = s0 + each * ((float)i + 0.05f);
        draw_spoiler(b, parent, w, d, at, at + 0.85f * each, rise);
    }
}

/* Draws the outer wing with its aileron, perhaps folding up about a line along the chord. */
static void draw_outer(dmg_builder* b, const dmg_wing* w, float s0) {
    uint32_t fold = 0;
    if (dmg_chance(b, 0.3f))
        fold =
            dmg_hinge(b, 0, "outer_wing", dmg_wing_point(w, s0, 0.3f, 1), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 2.2f));
    float from = s0 + (1 - s0) * dmg_range(b, 0.0f, 0.3f), to = 1 - 0.3f * (1 - s0) * dmg_unit(b);
    dmg_surface aileron = pick_surface(b, "aileron", from, to);
    if (from > s0) dmg_wing_piece_draw(b, w, s0, from, 0, 1);
    dmg_wing_piece_draw(b, w, from, to, 0, aileron.c);
    if (to < 1) dmg_wing_piece_draw(b, w, to, 1, 0, 1);
    line_habit habit = pick_habit(b);
    draw_tabbed(b, add_surface(b, fold, w, &aileron, habit), w, &aileron, habit);
    dmg_use(b, 0);
}

void dmg_build_slotted_wing(dmg_builder* b) {
    float root = dmg_scale_range(b, 0.1f, 6.0f);
    dmg_wing w = dmg_wing_pick(b, root * dmg_range(b, 1.5f, 5.0f), root);
    w.flat = false;
    w.thick = dmg_range(b, 0.08f, 0.18f);
    w.dihedral = dmg_range(b, -0.05f, 0.15f);
    lift_devices d = {
        .trailing = dmg_int(b, 0, TRAILING_KINDS - 1), .leading = dmg_int(b, 0, 2), .top = dmg_int(b, 0, 2)};
    d.back = dmg_range(b, 0.65f, 0.82f);
    d.front = d.back - dmg_range(b, 0.12f, 0.3f);
    d.slat = dmg_range(b, 0.1f, 0.2f);
    d.outer = dmg_range(b, 0.5f, 0.8f);
    bool both = dmg_chance(b, 0.5f);
    dmg_move(b, 0, root, 0);
    if (dmg_chance(b, 0.7f)) dmg_rounded_box(b, v3(0, 0, 0), v3(0.5f * root, 0.5f * root, 1.4f * root), 0.1f * root);
    uint64_t same = b->random_state; /* both sides alike */
    for (int side = 0; side < (both ? 2 : 1); ++side) {
        b->random_state = same;
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.25f * root, 0, 0);
        draw_bay(b, 0, &w, &d, 0, d.outer);
        draw_outer(b, &w, d.outer);
        dmg_restore(b);
    }
}
