/* Draws aeroplanes as flight simulators have them: hulls in one skin with doors cut out of it, tails of all layouts,
 * air brakes, legs that fold behind doors. Nose to +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/wings.h"

enum { ALONG = 10, AROUND = 16 };

/* A skin of ALONG bands of AROUND cells; cell (i, j) may belong to a door and is then left out. */
typedef struct hull {
    float z[ALONG + 1], radius[ALONG + 1], lift[ALONG + 1];
    float wide, high, square; /* square: 1 is an ellipse, less is boxy */
    float size;
    bool cut[ALONG][AROUND];
} hull;

static hull pick_hull(dmg_builder* b, float radius, float nose, float tail) {
    hull h = {.wide = dmg_range(b, 0.7f, 1.2f), .high = dmg_range(b, 0.8f, 1.2f), .size = radius};
    h.square = dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.45f, 0.9f);
    float blunt = dmg_range(b, 0.35f, 0.9f), slim = dmg_range(b, 0.7f, 1.8f), end = dmg_range(b, 0.02f, 0.4f),
          up = radius * dmg_range(b, 0.0f, 0.5f);
    for (int i = 0; i <= ALONG; ++i) {
        float s = (float)i / ALONG * (nose + tail) - tail, share = s > 0 ? s / nose : -s / tail;
        h.z[i] = s;
        h.radius[i] = radius * (s > 0 ? powf(fmaxf(1.0f - share * share, 0.0f), blunt)
                                      : end + (1.0f - end) * powf(fmaxf(1.0f - share, 0.0f), 1.0f / slim));
        h.lift[i] = s > 0 ? -0.3f * up * share * share : up * share;
    }
    return h;
}

static float bend(float x, float power) {
    return x < 0 ? -powf(-x, power) : powf(x, power);
}

/* out: 1 on the skin, less within it. */
static dmg_vec hull_point(const hull* h, int i, int j, float out) {
    float angle = 2.0f * DMG_PI * (float)j / AROUND, r = out * h->radius[i];
    return v3(r * h->wide * bend(cosf(angle), h->square), h->lift[i] + r * h->high * bend(sinf(angle), h->square),
              h->z[i]);
}

static void draw_skin_cell(dmg_builder* b, const hull* h, int i, int j, float out, bool inward) {
    uint32_t v[4] = {dmg_vertex(b, hull_point(h, i, j, out)), dmg_vertex(b, hull_point(h, i + 1, j, out)),
                     dmg_vertex(b, hull_point(h, i + 1, j + 1, out)), dmg_vertex(b, hull_point(h, i, j + 1, out))};
    if (inward)
        dmg_quad(b, v[0], v[1], v[2], v[3]);
    else
        dmg_quad(b, v[3], v[2], v[1], v[0]);
}

static void draw_hull(dmg_builder* b, const hull* h) {
    dmg_use(b, 0);
    for (int i = 0; i < ALONG; ++i) {
        for (int j = 0; j < AROUND; ++j) {
            if (h->cut[i][j]) continue;
            dmg_piece_begin(b);
            draw_skin_cell(b, h, i, j, 1.0f, false);
        }
    }
}

/* ---- doors cut out of the skin ---- */

typedef enum hang { HANG_FORE, HANG_AFT, HANG_UPPER, HANG_LOWER, HANG_SLIDE } hang;

typedef struct hatch {
    const char* name;
    int i, j, rows, columns;
    hang side;
    float swing;
    bool plain; /* the line along an axis of the aeroplane, whatever the skin does */
} hatch;

static dmg_vec nearest_axis(dmg_vec a) {
    float x = fabsf(a.x), y = fabsf(a.y), z = fabsf(a.z);
    if (x >= y && x >= z) return v3(a.x < 0 ? -1.0f : 1.0f, 0, 0);
    return y >= z ? v3(0, a.y < 0 ? -1.0f : 1.0f, 0) : v3(0, 0, a.z < 0 ? -1.0f : 1.0f);
}

/* Which corner cells of the hung edge the line runs through: from (i0, j0) to (i1, j1). */
static void add_hatch_joint(dmg_builder* b, const hull* h, const hatch* d) {
    int i0 = d->i, i1 = d->i + d->rows, j0 = d->j, j1 = d->j + d->columns;
    bool right = j0 + d->columns / 2 < AROUND / 4 || j0 + d->columns / 2 >= 3 * AROUND / 4;
    int upper = right ? j1 : j0, lower = right ? j0 : j1;
    if (d->side == HANG_SLIDE) {
        dmg_slide(b, 0, d->name, v3(0, 0, -1), 0.0f, 0.9f * (h->z[i1] - h->z[i0]));
        return;
    }
    if (d->side == HANG_FORE) i0 = i1;
    if (d->side == HANG_AFT) i1 = i0;
    if (d->side == HANG_UPPER) j0 = j1 = upper;
    if (d->side == HANG_LOWER) j0 = j1 = lower;
    dmg_vec from = hull_point(h, i0, j0, 1), to = hull_point(h, i1, j1, 1), middle = v3_lerp(from, to, 0.5f);
    dmg_vec axis = v3_normalize(v3_sub(to, from));
    if (d->plain) axis = nearest_axis(axis);
    dmg_vec centre = v3_lerp(hull_point(h, d->i, d->j, 1), hull_point(h, d->i + d->rows, d->j + d->columns, 1), 0.5f);
    /* It opens outwards. */
    dmg_vec out = v3(centre.x, centre.y - h->lift[d->i], 0), way = v3_cross(axis, v3_sub(centre, middle));
    if (v3_dot(out, way) < 0) axis = v3_scale(axis, -1.0f);
    dmg_hinge(b, 0, d->name, d->plain ? middle : from, axis, 0.0f, d->swing);
}

static void draw_hatch(dmg_builder* b, hull* h, const hatch* d, bool whole, float lining) {
    for (int i = d->i; i < d->i + d->rows; ++i)
        for (int j = d->j; j < d->j + d->columns; ++j) h->cut[i][(j + AROUND) % AROUND] = !whole;
    add_hatch_joint(b, h, d);
    for (int layer = 0; layer < (lining > 0 ? 2 : 1); ++layer) {
        for (int i = d->i; i < d->i + d->rows; ++i) {
            for (int j = d->j; j < d->j + d->columns; ++j) {
                dmg_piece_begin(b);
                draw_skin_cell(b, h, i, j, (whole ? 1.02f : 1.0f) - (layer ? lining : 0.0f), layer == 1);
            }
        }
    }
    dmg_use(b, 0);
}

static void draw_hatches(dmg_builder* b, hull* h) {
    bool whole = dmg_chance(b, 0.3f), plain = dmg_chance(b, 0.4f);
    float lining = dmg_chance(b, 0.5f) ? dmg_range(b, 0.02f, 0.08f) : 0.0f, swing = dmg_range(b, 0.9f, 2.2f);
    if (dmg_chance(b, 0.5f)) { /* over the pilots */
        hatch d = {"canopy", 6, 2, dmg_int(b, 1, 2), 4, HANG_AFT, dmg_range(b, 0.5f, 1.0f), true};
        static const hang sides[] = {HANG_AFT, HANG_AFT, HANG_UPPER, HANG_LOWER, HANG_SLIDE};
        d.side = sides[dmg_int(b, 0, 4)];
        draw_hatch(b, h, &d, whole || d.side == HANG_SLIDE, lining);
    }
    int doors = dmg_int(b, 0, 3);
    for (int k = 0; k < doors; ++k) { /* along the sides: j = 0 is the right, AROUND / 2 the left */
        int from = dmg_chance(b, 0.5f) ? -1 : AROUND / 2 - 1;
        static const hang sides[] = {HANG_FORE, HANG_FORE, HANG_AFT, HANG_UPPER, HANG_LOWER, HANG_SLIDE};
        hatch d = {"door", 2 + 2 * k, from, dmg_int(b, 1, 2), dmg_int(b, 2, 3), sides[dmg_int(b, 0, 5)], swing, plain};
        if (d.i == 6) d.columns = 2;
        draw_hatch(b, h, &d, whole || d.side == HANG_SLIDE, lining);
    }
    if (dmg_chance(b, 0.3f)) { /* a ramp under the tail */
        hatch d = {"ramp", 1, 10, dmg_int(b, 1, 2), 4, HANG_FORE, dmg_range(b, 0.3f, 0.8f), true};
        draw_hatch(b, h, &d, whole, lining);
    }
    for (int k = 0; k < 2 && dmg_chance(b, 0.5f); ++k) { /* doors of the nose leg, split along the keel */
        hatch d = {"gear_door", 7, k ? 12 : 11, 1, 1, k ? HANG_UPPER : HANG_LOWER, dmg_range(b, 1.0f, 1.7f), plain};
        d.side = HANG_UPPER;
        draw_hatch(b, h, &d, whole, lining);
    }
}

/* ---- wings and tails ---- */

/* Draws a plate on the upper skin, its fore edge at c0: opens against the wind. */
static void draw_spoiler(dmg_builder* b, const dmg_wing* w, float s0, float s1, float c0, float c1, float swing) {
    dmg_vec from = dmg_wing_point(w, s0, c0, 1), to = dmg_wing_point(w, s1, c0, 1);
    dmg_hinge(b, 0, "spoiler", from, v3_normalize(v3_sub(to, from)), 0.0f, swing);
    const dmg_vec top[4] = {from, to, dmg_wing_point(w, s1, c1, 1), dmg_wing_point(w, s0, c1, 1)};
    float rise = 0.01f * w->root;
    uint32_t v[8];
    dmg_piece_begin(b);
    for (int k = 0; k < 8; ++k) v[k] = dmg_vertex(b, v3_add(top[k % 4], v3(0, k < 4 ? rise : 0.0f, 0)));
    dmg_quad(b, v[0], v[1], v[2], v[3]);
    dmg_quad(b, v[7], v[6], v[5], v[4]);
    for (int k = 0; k < 4; ++k) dmg_quad(b, v[(k + 1) % 4], v[k], v[k + 4], v[(k + 1) % 4 + 4]);
    dmg_use(b, 0);
}

static void draw_main_wings(dmg_builder* b, float radius) {
    float span = radius * dmg_range(b, 2.5f, 8.0f), root = radius * dmg_range(b, 1.2f, 4.5f);
    dmg_wing w = dmg_wing_pick(b, span, root);
    w.dihedral = dmg_range(b, -0.1f, 0.12f);
    dmg_surface flaps[2];
    bool flapped = dmg_chance(b, 0.6f), spoilers = dmg_chance(b, 0.4f), folds = dmg_chance(b, 0.1f);
    int count = dmg_surfaces_pick(b, flaps, flapped ? "flap" : NULL, flapped && dmg_chance(b, 0.2f) ? NULL : "aileron");
    float swing = dmg_range(b, 0.15f, 0.6f), open = dmg_range(b, 0.4f, 1.1f), fold = dmg_range(b, 0.5f, 0.75f);
    for (int i = 0; i < count; ++i) flaps[i].swing = swing;
    flaps[0].drops = flapped;
    if (folds) count = 0; /* the tips fold up, and carry nothing */
    for (int side = 0; side < 2; ++side) {
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        if (folds) {
            dmg_wing_piece_draw(b, &w, 0, fold, 0, 1);
            dmg_hinge(b, 0, "wing_tip", dmg_wing_point(&w, fold, 0.5f, 1), v3(0, 0, 1), 0.0f, 1.6f);
            dmg_wing_piece_draw(b, &w, fold, 1, 0, 1);
            dmg_use(b, 0);
        } else {
            dmg_wing_draw(b, &w, 0, flaps, count);
            if (spoilers) draw_spoiler(b, &w, 0.3f, 0.55f, 0.45f, flaps[0].c - 0.02f, open);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Both halves as one part, or one each; all of the plane or its trailing edge alone. */
static void draw_elevators(dmg_builder* b, const dmg_wing* w, float swing) {
    bool joined = dmg_chance(b, 0.5f), whole = dmg_chance(b, 0.4f), swept = dmg_chance(b, 0.3f);
    float c = whole ? 0.0f : dmg_range(b, 0.5f, 0.8f), pivot = whole ? dmg_range(b, 0.3f, 0.6f) : c, s = 0.04f;
    for (int side = 0; side < 2; ++side) {
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        dmg_use(b, 0);
        if (!whole) dmg_wing_piece_draw(b, w, 0, 1, 0, c);
        dmg_vec at = dmg_wing_point(w, s, pivot, 0), far = dmg_wing_point(w, 1, pivot, 0);
        bool along = !joined && (swept || !whole) && dmg_chance(b, 0.6f);
        if (side && joined)
            dmg_use(b, b->part_count);
        else
            dmg_hinge(b, 0, "elevator", joined ? v3(0, at.y, at.z) : at,
                      along ? v3_normalize(v3_sub(at, far)) : v3(-1, 0, 0), -swing, swing);
        dmg_wing_piece_draw(b, w, s, 0.98f, c, 1);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_fins(dmg_builder* b, float radius, int count, float cant, float root, float swing) {
    dmg_wing fin = dmg_wing_pick(b, radius * dmg_range(b, 1.0f, 2.5f), root);
    float apart = count == 1 ? 0.0f : radius * dmg_range(b, 0.2f, 0.9f), c = dmg_range(b, 0.55f, 0.8f);
    bool whole = dmg_chance(b, 0.15f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        if (i) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, apart, 0, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI - cant);
        dmg_use(b, 0);
        if (whole) { /* the whole fin turns */
            dmg_hinge(b, 0, "rudder", dmg_wing_point(&fin, 0, 0.5f, 0), v3(1, 0, 0), -swing, swing);
            dmg_wing_piece_draw(b, &fin, 0.04f, 1, 0, 1);
        } else {
            dmg_surface rudder = {.name = "rudder", .s0 = 0.05f, .s1 = dmg_range(b, 0.6f, 1), .c = c, .swing = swing};
            dmg_wing_draw(b, &fin, 0, &rudder, 1);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Behind the hull: fin and tailplane, a V, or fins alone (a delta has no tailplane). */
static void draw_jet_tail(dmg_builder* b, float radius, float tail, float lift) {
    float root = radius * dmg_range(b, 0.8f, 2.0f), swing = dmg_range(b, 0.2f, 0.6f);
    int kind = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, 0, lift, -tail + 0.5f * root);
    if (kind == 0) draw_fins(b, radius, 2, dmg_range(b, 0.5f, 0.95f), root, swing); /* V */
    if (kind == 1) draw_fins(b, radius, 2, dmg_range(b, -0.1f, 0.45f), root, swing);
    if (kind >= 2) draw_fins(b, radius, 1, 0, root, swing);
    if (kind > 0 && dmg_chance(b, 0.85f)) {
        const float chord = root * dmg_range(b, 0.6f, 1.2f), span = radius * dmg_range(b, 1.2f, 3.0f);
        dmg_wing plane = dmg_wing_pick(b, span, chord);
        plane.dihedral = dmg_range(b, -0.2f, 0.15f);
        dmg_move(b, 0, radius * dmg_range(b, -0.1f, 0.2f), 0);
        draw_elevators(b, &plane, swing);
    }
    dmg_restore(b);
}

/* ---- legs ---- */

/* Folds forwards, backwards or sideways about its root; a door beside it hangs from the belly. */
static void draw_leg(dmg_builder* b, float x, float y, float z, float length, float wheel) {
    float side = x < 0 ? -1.0f : 1.0f, fold = dmg_range(b, 1.2f, 1.75f);
    int way = dmg_int(b, 0, 2), wheels = dmg_int(b, 1, 2);
    bool turns = dmg_chance(b, 0.6f);
    dmg_save(b);
    dmg_move(b, x, y, z);
    dmg_vec axis = way == 0 ? v3(-1, 0, 0) : (way == 1 ? v3(1, 0, 0) : v3(0, 0, -side));
    uint32_t leg = dmg_hinge(b, 0, "leg", v3(0, 0, 0), axis, 0.0f, fold);
    dmg_rod(b, v3(0, 0, 0), v3(0, -length, 0), 0.16f * wheel);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, -0.6f * length, 0), v3(0, -0.1f * length, 0.4f * length), 0.08f * wheel);
    float half = wheels == 1 ? 0.0f : 0.35f * wheel;
    if (turns) dmg_spin(b, leg, "wheel", v3(0, -length, 0), v3(1, 0, 0));
    for (int k = 0; k < wheels; ++k) {
        dmg_save(b);
        dmg_move(b, wheels == 1 ? 0.0f : (float)(2 * k - 1) * half, -length, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, k % 2 ? 0 : 1, wheel, 0.4f * wheel, 5);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) {
        float wide = 0.9f * wheel, out = side * 0.8f * wheel;
        uint32_t door = dmg_hinge(b, 0, "gear_door", v3(out, 0, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 1.0f, 1.7f));
        if (dmg_chance(b, 0.5f)) dmg_rest(b, door, b->parts[door - 1].joint.upper);
        dmg_box(b, v3(out - side * 0.5f * wide, 0, 0), v3(wide, 0.04f * wheel, dmg_range(b, 1.0f, 2.5f) * wheel));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

static void draw_jet_engines(dmg_builder* b, float radius, float tail) {
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) return;
    float r = radius * dmg_range(b, 0.3f, 0.55f), length = r * dmg_range(b, 2.5f, 5.0f),
          x = radius * (kind == 1 ? 1.3f : 2.5f), y = kind == 1 ? 0.3f * radius : -0.4f * radius,
          z = kind == 1 ? -0.55f * tail : 0.3f * radius;
    bool spins = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * x, y, z);
        const dmg_xy shell[] = {{0.85f * r, -0.5f * length}, {r, 0.1f * length}, {0.9f * r, 0.5f * length}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), shell, 3);
        dmg_beam(b, v3(0, 0, 0), v3((float)-s * 0.5f * radius, 0.1f * radius, 0), 0.4f * length, 0.1f * r);
        if (spins) {
            dmg_spin(b, 0, "fan", v3(0, 0, 0), v3(0, 0, 1));
            dmg_move(b, 0, 0, 0.42f * length);
            dmg_cone(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.3f * r), 0.3f * r, 0.05f * r);
            dmg_blades_draw(b, 0, 0.85f * r, 0.3f * r, 0.3f * r, dmg_int(b, 5, 9), 0.5f);
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
}

void dmg_build_jet(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.1f, 3.0f), nose = radius * dmg_range(b, 2.5f, 7.0f),
          tail = radius * dmg_range(b, 3.0f, 8.0f), leg = radius * dmg_range(b, 0.6f, 1.3f);
    dmg_move(b, 0, 1.2f * radius + leg, 0);
    hull h = pick_hull(b, radius, nose, tail);
    draw_hatches(b, &h);
    draw_hull(b, &h);
    dmg_save(b);
    const float ahead = radius * dmg_range(b, -0.5f, 0.8f), up = radius * dmg_range(b, -0.6f, 0.6f);
    dmg_move(b, 0, up, ahead);
    draw_main_wings(b, radius);
    dmg_restore(b);
    draw_jet_tail(b, radius, tail, h.lift[0]);
    draw_jet_engines(b, radius, tail);
    if (dmg_chance(b, 0.3f)) { /* air brakes on the sides of the tail, or on its back */
        float length = radius * dmg_range(b, 0.6f, 1.2f), z = -0.4f * tail;
        dmg_vec front = {0, h.lift[4] + h.high * radius, z};
        dmg_hinge(b, 0, "air_brake", front, v3(1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.0f));
        dmg_box(b, v3_add(front, v3(0, 0.02f * radius, -0.5f * length)), v3(0.7f * radius, 0.05f * radius, length));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.6f)) {
        float wheel = radius * dmg_range(b, 0.18f, 0.35f), track = radius * dmg_range(b, 0.4f, 1.8f),
              y = -0.7f * radius * h.high;
        for (int s = -1; s <= 1; s += 2) draw_leg(b, (float)s * track, y, -0.2f * radius, leg, wheel);
        draw_leg(b, 0, y, 0.6f * nose, leg, 0.8f * wheel);
    }
}
