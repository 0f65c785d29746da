/* Draws cabinets for the corner of a room: doors that fold, carousels, shelves that swing or glide out, diagonal
 * fronts. */
#include "core/build.h"
#include "parts/hardware.h"

/* The plan: walls along x = 0 and z = 0, two wings as deep as `deep` that end at `side`. Across the corner the front
 * runs from (side, deep) to (deep, side), or it follows the wings and has an inner corner at (deep, deep). */
typedef struct corner {
    float side, deep, wall, t;
    bool across;
    float high; /* of one storey */
    dmg_leaf leaf;
    float open;
} corner;

/* Draws the plan's outline on the floor, between two heights. */
static void draw_slab(dmg_builder* b, const corner* k, float low, float high, float over) {
    float s = k->side, d = k->deep + over;
    const dmg_xy bent[] = {{0, 0}, {s, 0}, {s, d}, {d, d}, {d, s}, {0, s}},
                 cut[] = {{0, 0}, {s, 0}, {s, d}, {d, s}, {0, s}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the outline's y is z, its z is down */
    dmg_extrude(b, k->across ? cut : bent, k->across ? 5 : 6, -high, -low);
    dmg_restore(b);
}

/* Both walls and both ends of the wings. */
static void draw_walls(dmg_builder* b, const corner* k, float low, float high, bool back) {
    float s = k->side, d = k->deep, w = k->wall;
    dmg_box_span(b, v3(s - w, low, 0), v3(s, high, d));
    dmg_box_span(b, v3(0, low, s - w), v3(d, high, s));
    if (!back) return;
    dmg_box_span(b, v3(0, low, 0), v3(s - w, high, 0.5f * w));
    dmg_box_span(b, v3(0, low, 0.5f * w), v3(0.5f * w, high, s - w));
}

/* ---- carousels ---- */

/* Draws a round shelf, three quarters of one, or a kidney: about the origin, its notch towards +X +Z. */
static void draw_shelf(dmg_builder* b, int kind, float radius, float thick, float rim) {
    enum { POINTS = 20 };
    dmg_xy outline[POINTS + 2];
    int count = 0;
    float from = kind == 0 ? 0.0f : 0.5f * DMG_PI, arc = (kind == 0 ? 2.0f : 1.5f) * DMG_PI;
    for (int i = 0; i < POINTS; ++i) {
        float a = from + arc * (float)i / (float)(kind == 0 ? POINTS : POINTS - 1);
        outline[count++] = (dmg_xy){radius * cosf(a), radius * sinf(a)};
    }
    if (kind == 1) outline[count++] = (dmg_xy){0, 0};
    if (kind == 2) outline[count++] = (dmg_xy){0.35f * radius, 0.35f * radius};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_extrude(b, outline, count, 0, thick);
    dmg_restore(b);
    if (rim <= 0.0f) return;
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) path[i] = v3(outline[i].x, rim, outline[i].y);
    dmg_sweep(b, path, POINTS, 0.5f * thick, 0.5f * thick, kind == 0);
}

/* Shelves about one post; each may turn alone. `doors`: long plates on the notch's sides. */
static void draw_carousel(dmg_builder* b, const corner* k, float at, float radius, int kind, bool doors) {
    int shelves = dmg_int(b, 2, 4);
    bool alone = !doors && dmg_chance(b, 0.35f);
    float thick = 0.02f * radius * dmg_range(b, 1.0f, 3.0f), rim = dmg_chance(b, 0.5f) ? 0.12f * radius : 0.0f,
          post = radius * dmg_range(b, 0.03f, 0.07f), inner = k->high - 2 * k->wall;
    dmg_save(b);
    dmg_move(b, at, k->wall, at);
    uint32_t part = 0;
    if (!alone) part = dmg_spin(b, 0, "carousel", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.0f, 0), v3(0, inner, 0), post);
    for (int i = 0; i < shelves; ++i) {
        if (alone) part = dmg_spin(b, 0, "shelf", v3(0, 0, 0), v3(0, 1, 0));
        dmg_save(b);
        dmg_move(b, 0, inner * ((float)i + 0.25f) / (float)shelves, 0);
        draw_shelf(b, kind, radius, thick, rim);
        if (alone) dmg_rod(b, v3(0, -0.04f * inner, 0), v3(0, 0.04f * inner, 0), 1.8f * post);
        dmg_restore(b);
    }
    if (doors) { /* a right angle of plates closes the notch */
        float t = k->t, y = 0.5f * inner, h = 0.97f * inner;
        dmg_box(b, v3(0.5f * radius, y, 0.5f * t), v3(radius, h, t));
        dmg_box(b, v3(0.5f * t, y, 0.5f * (radius + t)), v3(t, h, radius - t));
        if (dmg_chance(b, 0.7f)) {
            float out = dmg_range(b, 0.3f, 0.85f) * radius, up = dmg_range(b, -0.2f, 0.35f) * h;
            dmg_move(b, out, y + up, t);
            dmg_handle_draw(b, &k->leaf.handle, 0.4f * h);
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (doors && dmg_chance(b, k->open)) dmg_rest(b, part, dmg_range(b, -DMG_PI, DMG_PI));
}

/* ---- fronts ---- */

/* Where the two plates of a front with an inner corner lie. */
typedef struct bend {
    float from, face, width; /* plates start at x = from or z = from, face outwards at `face`, are `width` wide */
    float y, high;
} bend;

/* Before the boards, or let in between them. */
static bend pick_bend(dmg_builder* b, const corner* k) {
    bool inside = dmg_chance(b, 0.4f);
    bend f = {.face = k->deep + (inside ? 0.0f : 1.03f * k->t), .y = 0.5f * k->high};
    f.from = inside ? k->deep : f.face;
    f.width = k->side - f.from - (inside ? 1.1f * k->wall : 0.0f);
    f.high = 0.985f * k->high - (inside ? 2 * k->wall : 0.0f);
    return f;
}

/* Draws the plate before the wing along x, or the other one; its handle near the end of the wing or near the corner. */
static void draw_bend_plate(dmg_builder* b, const corner* k, const bend* f, bool other, float grip) {
    float middle = f->from + 0.5f * f->width;
    dmg_save(b);
    dmg_move(b, other ? f->face : middle, f->y, other ? middle : f->face);
    if (other) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_panel_draw(b, &k->leaf.panel, 0.99f * f->width, f->high, k->t);
    dmg_move(b, grip * f->width, k->leaf.handle_at * 0.7f * f->high, 0);
    if (grip != 0.0f) dmg_handle_draw(b, &k->leaf.handle, 0.4f * f->high);
    dmg_restore(b);
}

/* One leaf hangs at the end of a wing; the other hangs on it in the inner corner and stands before the second wing. */
static void draw_fold_doors(dmg_builder* b, const corner* k) {
    float far = dmg_range(b, 1.5f, 2.7f), fold = dmg_range(b, 1.2f, 1.5f), through = dmg_range(b, 0.0f, 1.0f) * k->t;
    bend f = pick_bend(b, k);
    if (f.face == k->deep) through = 0.0f;
    dmg_vec seam = v3(f.from, f.y, f.from), end = v3(f.from + f.width, f.y, f.face - through);
    uint32_t first = dmg_hinge(b, 0, "door", end, v3(0, 1, 0), 0.0f, far);
    draw_bend_plate(b, k, &f, false, 0.0f);
    bool knuckles = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1 && knuckles; s += 2) {
        dmg_vec at = v3_mad(seam, v3(0, 0.35f * f.high, 0), (float)s), half = v3(0, 0.05f * f.high, 0);
        dmg_rod(b, v3_sub(at, half), v3_add(at, half), 0.3f * k->t);
        dmg_vec outer = v3(end.x, at.y, end.z);
        dmg_rod(b, v3_sub(outer, half), v3_add(outer, half), 0.3f * k->t);
    }
    uint32_t second = dmg_hinge(b, first, "folding_door", seam, v3(0, 1, 0), 0.0f, fold);
    draw_bend_plate(b, k, &f, true, dmg_chance(b, 0.3f) ? 0.4f : -0.4f);
    if (dmg_chance(b, k->open)) dmg_rest(b, first, far * dmg_range(b, 0.2f, 1.0f));
    if (dmg_chance(b, k->open)) dmg_rest(b, second, fold * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

/* Drawers over each other whose fronts bend with the corner: they come out across it. */
static void draw_bend_drawers(dmg_builder* b, const corner* k) {
    int rows = dmg_int(b, 1, 4);
    bend f = pick_bend(b, k);
    float step = f.high / (float)rows, half = f.width * dmg_range(b, 0.35f, 0.62f),
          apex = (f.from - k->t) * sqrtf(2.0f), deep = apex - half - 2.5f * k->wall, wall = 0.6f * k->wall,
          share = dmg_range(b, 0.4f, 0.85f);
    float bottom = f.y - 0.5f * f.high;
    for (int i = 0; i < rows; ++i) {
        float way = dmg_range(b, 0.6f, 0.95f) * deep, low = 0.06f * step, top = share * step;
        f.y = bottom + ((float)i + 0.5f) * step;
        f.high = 0.97f * step;
        uint32_t part = dmg_slide(b, 0, "corner_drawer", v3(sqrtf(0.5f), 0, sqrtf(0.5f)), 0.0f, way);
        draw_bend_plate(b, k, &f, false, dmg_chance(b, 0.5f) ? 0.3f : 0.0f);
        draw_bend_plate(b, k, &f, true, -0.3f);
        dmg_save(b);
        dmg_move(b, f.from - k->t, f.y - 0.5f * step, f.from - k->t);
        dmg_turn(b, v3(0, 1, 0), 0.25f * DMG_PI);
        dmg_box_span(b, v3(-half, low, -deep), v3(half, low + wall, 0));
        dmg_box_span(b, v3(-half, low + wall, -deep), v3(half, top, wall - deep));
        for (int s = -1; s <= 1; s += 2) { /* the sides reach as far as the plates */
            float x = (float)s * (half - 0.5f * wall);
            dmg_box_span(b, v3(x - 0.5f * wall, low, wall - deep), v3(x + 0.5f * wall, top, half));
        }
        dmg_restore(b);
        if (dmg_chance(b, k->open)) dmg_rest(b, part, way * dmg_range(b, 0.1f, 1.0f));
        dmg_use(b, 0);
    }
}

/* To the middle of a straight front across the corner, its face where the boards end. */
static void move_across(dmg_builder* b, const corner* k) {
    float middle = 0.5f * (k->side + k->deep);
    dmg_move(b, middle, 0.5f * k->high, middle);
    dmg_turn(b, v3(0, 1, 0), 0.25f * DMG_PI);
}

static void draw_across_doors(dmg_builder* b, const corner* k) {
    dmg_leaf leaf = k->leaf;
    bool twins = dmg_chance(b, 0.3f), inside = dmg_chance(b, 0.35f);
    float width = (k->side - k->deep) * sqrtf(2.0f) - (inside ? 3 * k->wall : 0.0f);
    leaf.width = (twins ? 0.495f : 0.99f) * width;
    leaf.height = 0.985f * k->high - (inside ? 2 * k->wall : 0.0f);
    bool right = dmg_chance(b, 0.5f);
    if (inside) {
        leaf.depth = 0.0f;
        leaf.inset = 0.0f;
    }
    for (int i = 0; i < (twins ? 2 : 1); ++i) {
        leaf.side = (twins ? i == 1 : right) ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT;
        dmg_save(b);
        move_across(b, k);
        dmg_move(b, twins ? width * (0.5f * (float)i - 0.25f) : 0.0f, 0, inside ? 0.0f : 1.02f * k->t);
        uint32_t part = dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
        if (dmg_chance(b, k->open)) dmg_rest(b, part, leaf.swing * dmg_range(b, 0.2f, 1.0f));
        dmg_use(b, 0);
    }
}

static void draw_across_drawers(dmg_builder* b, const corner* k) {
    int rows = dmg_int(b, 1, 5);
    float width = (k->side - k->deep) * sqrtf(2.0f), step = k->high / (float)rows;
    dmg_drawer d = dmg_drawer_pick(b, 0.25f * width);
    d.width = 0.99f * width;
    d.height = 0.96f * step;
    d.thickness = k->t;
    d.handle = k->leaf.handle;
    d.panel = k->leaf.panel;
    d.depth = (k->side + k->deep) * sqrtf(0.5f) - 0.5f * width - 2 * k->wall;
    d.travel = dmg_range(b, 0.6f, 0.95f) * d.depth;
    for (int i = 0; i < rows; ++i) {
        dmg_save(b);
        move_across(b, k);
        dmg_move(b, 0, ((float)i + 0.5f) * step - 0.5f * k->high, 1.02f * k->t);
        uint32_t part = dmg_drawer_draw(b, 0, "drawer", &d);
        dmg_restore(b);
        if (dmg_chance(b, k->open)) dmg_rest(b, part, d.travel * dmg_range(b, 0.1f, 1.0f));
        dmg_use(b, 0);
    }
}

/* ---- one wing opens, the other is closed by a fixed plate ---- */

static void draw_blind_plate(dmg_builder* b, const corner* k) {
    dmg_box_span(b, v3(k->deep - k->t, k->wall, k->deep - k->t), v3(k->deep, k->high - k->wall, k->side - k->wall));
}

/* Quarters of discs about a post at the end of the wing, which swing out of it past its door. */
static void draw_swing_shelves(dmg_builder* b, const corner* k) {
    enum { POINTS = 9 };
    float edge = k->wall + dmg_range(b, 0.02f, 0.05f) * k->side, x = k->side - edge, z = k->deep - edge - k->t,
          radius = (x - k->deep) * dmg_range(b, 0.75f, 0.97f), inner = k->high - 2 * k->wall,
          thick = 0.04f * radius * dmg_range(b, 0.6f, 1.5f);
    int shelves = dmg_int(b, 1, 4);
    bool alone = dmg_chance(b, 0.6f), rail = dmg_chance(b, 0.5f);
    dmg_xy outline[POINTS + 1] = {{0, 0}};
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float a = DMG_PI + 0.5f * DMG_PI * (float)i / (POINTS - 1);
        outline[i + 1] = (dmg_xy){radius * cosf(a), radius * sinf(a)};
        path[i] = v3(outline[i + 1].x, 0.15f * radius, outline[i + 1].y);
    }
    dmg_save(b);
    dmg_move(b, x, k->wall, z);
    uint32_t part = 0;
    if (!alone) part = dmg_hinge(b, 0, "swing_shelves", v3(0, 0, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 1.6f));
    dmg_rod(b, v3(0, 0, 0), v3(0, inner, 0), 0.5f * thick + 0.01f * radius);
    for (int i = 0; i < shelves; ++i) {
        if (alone) part = dmg_hinge(b, 0, "swing_shelf", v3(0, 0, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 1.6f));
        dmg_save(b);
        dmg_move(b, 0, inner * ((float)i + 0.3f) / (float)shelves, 0);
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_extrude(b, outline, POINTS + 1, 0, thick);
        dmg_restore(b);
        if (rail) dmg_sweep(b, path, POINTS, 0.4f * thick, 0.4f * thick, false);
        dmg_restore(b);
        if (alone && dmg_chance(b, k->open)) dmg_rest(b, part, dmg_range(b, 0.3f, 1.2f));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* A front with a rack comes straight out; one in the corner glides into its place. */
static void draw_glide_racks(dmg_builder* b, const corner* k) {
    float width = k->side - k->deep - 2.2f * k->wall, deep = k->deep - 2 * k->wall - k->t,
          way = deep * dmg_range(b, 0.8f, 1.0f), inner = k->high - 2 * k->wall,
          across = width * dmg_range(b, 0.8f, 0.97f);
    int shelves = dmg_int(b, 1, 3);
    dmg_tray_kind tray = dmg_chance(b, 0.5f) ? DMG_TRAY_WIRE : DMG_TRAY_BOARDS;
    bend f = pick_bend(b, k);
    uint32_t front = dmg_slide(b, 0, "pull_out", v3(0, 0, 1), 0.0f, way);
    draw_bend_plate(b, k, &f, false, dmg_chance(b, 0.5f) ? -0.35f : 0.05f);
    for (int part = 0; part < 2; ++part) {
        float w = part == 0 ? width : fminf(k->deep - 2 * k->wall, across + 0.1f * k->deep);
        if (part == 1) dmg_slide(b, 0, "corner_rack", v3(1, 0, 0), 0.0f, across);
        for (int i = 0; i < shelves; ++i) {
            dmg_save(b);
            dmg_move(b, part == 0 ? k->deep + 0.5f * (k->side - k->deep) : k->deep - 0.5f * w - 0.3f * k->wall,
                     1.3f * k->wall + inner * (float)i / (float)shelves, f.face - 1.01f * k->t - 0.02f * deep);
            dmg_tray_draw(b, tray, w, 0.3f * inner / (float)shelves, 0.92f * deep, 0.5f * k->wall);
            dmg_restore(b);
        }
        if (part == 0) /* what carries the trays */
            dmg_box_span(b, v3(k->deep + 1.1f * k->wall, 1.3f * k->wall, k->wall),
                         v3(k->deep + 1.6f * k->wall, 0.9f * inner, 1.5f * k->wall));
    }
    if (dmg_chance(b, k->open)) dmg_rest(b, front, way * dmg_range(b, 0.1f, 1.0f));
    dmg_use(b, 0);
}

/* ---- storeys ---- */

static void draw_wing_door(dmg_builder* b, const corner* k, dmg_side side) {
    dmg_leaf leaf = k->leaf;
    leaf.width = 0.99f * (k->side - k->deep) - 1.2f * k->t;
    leaf.height = 0.985f * k->high;
    leaf.side = side;
    dmg_save(b);
    dmg_move(b, 0.5f * (k->side + k->deep) + 0.6f * k->t, 0.5f * k->high, k->deep + 1.02f * k->t);
    uint32_t part = dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    if (dmg_chance(b, k->open)) dmg_rest(b, part, leaf.swing * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

static void draw_across_storey(dmg_builder* b, const corner* k) {
    float at = 0.47f * k->side, front = (k->side + k->deep - 2 * at) * sqrtf(0.5f) - 2 * k->t;
    if (dmg_chance(b, 0.35f)) {
        draw_across_drawers(b, k);
        return;
    }
    bool carousel = dmg_chance(b, 0.65f);
    if (!carousel || dmg_chance(b, 0.85f)) draw_across_doors(b, k);
    if (carousel) {
        draw_carousel(b, k, at, fminf(at - k->wall, front) * dmg_range(b, 0.8f, 0.97f), 0, false);
        return;
    }
    for (int i = 1; i < 4; ++i) {
        corner shelf = *k;
        shelf.deep -= 2 * k->t;
        shelf.side -= k->wall;
        draw_slab(b, &shelf, 0.25f * (float)i * k->high, 0.25f * (float)i * k->high + 0.7f * k->wall, 0);
    }
}

static void draw_bend_storey(dmg_builder* b, const corner* k) {
    int kind = dmg_int(b, 0, 4), shape = dmg_int(b, 0, 2);
    float at = k->deep - k->t, round = 0.56f * k->deep, radius = fminf(at, k->side - at) - 1.3f * k->wall;
    if (kind == 0) { /* leaves, and behind them shelves with a notch or round ones */
        draw_fold_doors(b, k);
        if (shape == 0) radius = fminf(round, (k->deep - round) * sqrtf(2.0f)) - 1.3f * k->wall - k->t;
        at -= shape == 0 ? 0.0f : 1.2f * k->t;
        if (dmg_chance(b, 0.8f)) draw_carousel(b, k, shape == 0 ? round : at, 0.95f * radius, shape, false);
    }
    if (kind == 1) draw_carousel(b, k, at, radius, 1, true);
    if (kind == 2) draw_bend_drawers(b, k);
    if (kind == 3) {
        draw_blind_plate(b, k);
        if (dmg_chance(b, 0.75f)) draw_wing_door(b, k, dmg_chance(b, 0.7f) ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT);
        draw_swing_shelves(b, k);
    }
    if (kind == 4) {
        draw_blind_plate(b, k);
        draw_glide_racks(b, k);
    }
}

static corner pick_corner(dmg_builder* b) {
    corner k = {.side = dmg_range(b, 0.6f, 1.1f)};
    k.across = dmg_chance(b, 0.4f);
    k.deep = k.side * (k.across ? dmg_range(b, 0.35f, 0.6f) : dmg_range(b, 0.5f, 0.64f));
    k.wall = k.side * dmg_range(b, 0.012f, 0.035f);
    k.t = k.side * dmg_range(b, 0.015f, 0.04f);
    k.leaf = dmg_leaf_pick(b, 0.2f * k.side);
    k.leaf.thickness = k.t;
    k.leaf.inset = fminf(k.leaf.inset, 0.6f);
    if (k.leaf.panel.kind == DMG_PANEL_BOWED) k.leaf.panel.kind = DMG_PANEL_FLAT;
    if (k.leaf.handle.kind == DMG_HANDLE_LIP) k.leaf.handle.kind = DMG_HANDLE_FLAT;
    k.open = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.2f, 0.8f);
    return k;
}

void dmg_build_corner_cabinet(dmg_builder* b) {
    corner k = pick_corner(b);
    int storeys = dmg_chance(b, 0.6f) ? 1 : dmg_int(b, 2, 3);
    float foot = dmg_chance(b, 0.5f) ? k.side * dmg_range(b, 0.05f, 0.15f) : 0.0f;
    bool back = dmg_chance(b, 0.75f), top = dmg_chance(b, 0.5f);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    if (dmg_chance(b, 0.7f)) dmg_turn(b, v3(0, 1, 0), -0.25f * DMG_PI); /* the corner behind, or a wing */
    dmg_move(b, -0.5f * k.side, 0, -0.5f * k.side);
    if (foot > 0.0f) draw_slab(b, &k, 0, foot, -0.06f * k.side); /* a plinth, set back */
    dmg_move(b, 0, foot, 0);
    for (int i = 0; i < storeys; ++i) {
        k.high = k.side * (storeys > 1 ? dmg_range(b, 0.35f, 0.9f) : dmg_range(b, 0.4f, 1.5f));
        draw_walls(b, &k, 0, k.high, back);
        draw_slab(b, &k, 0, k.wall, 0);
        draw_slab(b, &k, k.high - k.wall, k.high, 0);
        if (k.across)
            draw_across_storey(b, &k);
        else
            draw_bend_storey(b, &k);
        dmg_move(b, 0, 1.001f * k.high, 0);
    }
    if (top) draw_slab(b, &k, 0, 1.5f * k.wall, 1.5f * k.t);
}
