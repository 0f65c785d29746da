/* Draws furniture whose front tilts or falls: shoe cabinets, mirror cabinets, beds and desks that fold into a wall. */
#include "core/build.h"
#include "parts/hardware.h"

/* Boards round an opening centred at z = 0: sides, top, floor and back as one likes. */
static void draw_boards(dmg_builder* b, float w, float h, float d, float t, bool back) {
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (w - t), y = 0.5f * (float)s * (h - t);
        dmg_box(b, v3(x, 0, -0.5f * d), v3(t, h, d));
        dmg_box(b, v3(0, y, -0.5f * d), v3(w - 2 * t, t, d));
    }
    if (back) dmg_box(b, v3(0, 0, 0.2f * t - d), v3(w - 2 * t, h - 2 * t, 0.4f * t));
}

static void draw_front_grip(dmg_builder* b, float y, float hand, float room) {
    dmg_handle grip = dmg_handle_pick(b, hand);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, room);
    dmg_restore(b);
}

/* ---- fronts that tilt out ---- */

/* Draws what hangs behind a tilting front: a floor and a rear leaf between cheeks, or a shelf on its back. */
static void draw_tilted_bucket(dmg_builder* b, float w, float deep, float high, float t) {
    int kind = dmg_int(b, 0, 2);
    const dmg_xy cheek[] = {{0, 0}, {0, high}, {-0.85f * deep, high}, {-deep, 0.75f * high}, {-deep, 0}};
    if (kind == 0) return;
    dmg_box_span(b, v3(-0.5f * w, 0, -deep), v3(0.5f * w, t, 0));
    dmg_box_span(b, v3(-0.5f * w, t, -deep), v3(0.5f * w, 0.75f * high, t - deep));
    if (kind == 2 && high > 4 * t)
        dmg_box_span(b, v3(-0.5f * w, 0.45f * high, -0.9f * deep), v3(0.5f * w, 0.45f * high + t, 0));
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (w - t);
        dmg_extrude(b, cheek, 5, x - 0.5f * t, x + 0.5f * t);
    }
    dmg_restore(b);
}

typedef struct tilt {
    float width, height, depth, t; /* of one place; t of its front */
    bool inside;                   /* the front is between the boards */
    float up, back;                /* the line above the front's lower edge, behind its face */
    float swing;
    dmg_panel panel;
    dmg_handle grip;
} tilt;

/* Draws one front, its place centred at the origin; z = 0 is where the boards end. */
static void draw_tilt(dmg_builder* b, const tilt* f, float wall) {
    float h = 0.98f * f->height, w = f->inside ? f->width - 2.2f * wall : 0.99f * f->width,
          face = f->inside ? 0.0f : 1.02f * f->t, low = -0.5f * h;
    float deep = (f->depth - wall) * 0.8f, reach = h - f->up;
    uint32_t front = dmg_hinge(b, 0, "front", v3(0, low + f->up, face - f->back), v3(1, 0, 0), 0.0f, f->swing);
    dmg_save(b);
    dmg_move(b, 0, 0, face);
    dmg_panel_draw(b, &f->panel, w, h, f->t);
    dmg_save(b);
    dmg_move(b, 0, 0.34f * h, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &f->grip, 0.5f * w);
    dmg_restore(b);
    /* So high that it passes under the front above when it comes out. */
    deep = fminf(deep, 0.7f * reach);
    float high = fminf(0.9f * h, sqrtf(0.85f * reach * reach - deep * deep));
    dmg_move(b, 0, low + 0.01f * h, -f->t);
    draw_tilted_bucket(b, f->width - 3 * wall, deep, high, 0.5f * wall);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f) && f->inside)
        for (int s = -1; s <= 1; s += 2) {
            float x = 0.5f * (float)s * w;
            dmg_rod(b, v3(x - 0.2f * wall, low + f->up, face - f->back),
                    v3(x + 0.8f * wall, low + f->up, face - f->back), 0.4f * f->t);
        }
    if (dmg_chance(b, 0.3f)) dmg_rest(b, front, f->swing * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

static void draw_shoe_cabinet(dmg_builder* b) {
    int rows = dmg_int(b, 1, 4), columns = dmg_chance(b, 0.3f) ? 2 : 1;
    tilt f = {.panel = dmg_panel_pick(b)};
    f.width = dmg_range(b, 0.3f, 0.9f);
    f.height = f.width * dmg_range(b, 0.4f, 1.2f);
    f.depth = f.height * dmg_range(b, 0.3f, 0.8f);
    float wall = f.width * dmg_range(b, 0.015f, 0.04f), foot = dmg_chance(b, 0.5f) ? 0.1f * f.height : 0.0f;
    f.t = wall * dmg_range(b, 0.7f, 1.5f);
    f.inside = dmg_chance(b, 0.6f);
    f.grip = dmg_handle_pick(b, 0.2f * f.width);
    f.swing = dmg_range(b, 0.4f, 1.1f);
    int line = dmg_int(b, 0, 3); /* the outer lower edge, the inner one, in it, in from both edges */
    if (line == 1) f.back = f.t;
    if (line == 2) f.back = 0.5f * f.t;
    if (line == 2) f.up = 0.5f * f.t;
    if (line == 3) {
        f.up = f.inside ? f.height * dmg_range(b, 0.02f, 0.16f) : f.t * dmg_range(b, 0.1f, 1.0f);
        f.back = f.inside ? f.t + f.depth * dmg_range(b, 0.0f, 0.2f) : f.t;
    }
    float total = (float)rows * f.height + 2 * wall;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, 3), (float)columns * f.width, f.depth, foot);
    dmg_move(b, 0, foot + 0.5f * total, 0.5f * f.depth);
    for (int c = 0; c < columns; ++c) {
        dmg_save(b);
        dmg_move(b, f.width * ((float)c - 0.5f * (float)(columns - 1)), 0, 0);
        draw_boards(b, f.width, total, f.depth, wall, dmg_chance(b, 0.7f));
        for (int r = 0; r < rows; ++r) {
            dmg_save(b);
            dmg_move(b, 0, f.height * ((float)r - 0.5f * (float)(rows - 1)), 0);
            draw_tilt(b, &f, wall);
            dmg_restore(b);
        }
        dmg_restore(b);
    }
}

/* Draws a mirror on a thin door before a shallow case; its line is beside, on or behind the slab, as its hinges are
 * made. */
static void draw_mirror_door(dmg_builder* b, float w, float h, float t, float depth) {
    int hung = dmg_int(b, 0, 3);
    float in = 0.0f, behind = t, far = dmg_range(b, 1.5f, 1.9f); /* the slab's inner edge */
    if (hung == 1) behind = 0.0f;
    if (hung == 2) { /* on pins above and below, in from the edge */
        in = t * dmg_range(b, 0.3f, 1.0f);
        behind = 0.5f * t;
    }
    if (hung == 3) { /* concealed: cups in the slab, arms on the board; the line it seems to turn about is between */
        in = t * dmg_range(b, 0.1f, 0.9f);
        behind = t * dmg_range(b, 0.5f, 1.3f);
    }
    float x = in - 0.5f * w;
    uint32_t door = dmg_hinge(b, 0, "door", v3(x, 0, t - behind), v3(0, -1, 0), 0.0f, far);
    bool framed = dmg_chance(b, 0.4f);
    if (framed)
        dmg_panel_draw(b, &(dmg_panel){.kind = DMG_PANEL_WINDOW, .border = dmg_range(b, 0.04f, 0.15f), .infill = 0.9f},
                       w, h, t);
    else
        dmg_box(b, v3(0, 0, 0.5f * t), v3(w, h, t));
    if (framed) dmg_box(b, v3(0, 0, 0.5f * t), v3(w, h, 0.8f * t));
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, t), v3(0.92f * w, 0.92f * h, 0.1f * t));
    for (int i = -1; i <= 1 && hung == 3; i += 2) {
        float y = 0.35f * (float)i * h;
        dmg_use(b, door);
        dmg_box(b, v3(3 * t - 0.5f * w, y, -0.1f * t), v3(2.5f * t, 3 * t, 0.4f * t));
        dmg_use(b, 0);
        dmg_box(b, v3(1.6f * t - 0.5f * w, y, -0.12f * depth - t), v3(0.8f * t, 2 * t, 0.2f * depth));
    }
    for (int i = -1; i <= 1 && hung == 2; i += 2) {
        dmg_use(b, door);
        dmg_rod(b, v3(x, 0.49f * (float)i * h, t - behind), v3(x, 0.515f * (float)i * h, t - behind), 0.3f * t);
    }
    dmg_hinge_style style = dmg_hinge_pick(b, 0.3f * t);
    dmg_save(b);
    dmg_move(b, x, 0, t - behind);
    if (hung < 2 && style.kind != DMG_HINGE_STRAP && style.kind != DMG_HINGE_LUGS)
        dmg_hinge_draw(b, &style, h, w, door, 0);
    dmg_restore(b);
    dmg_use(b, door);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0.44f * w, -0.35f * h, t), v3(0.44f * w, -0.35f * h, 2.2f * t), 0.6f * t);
    if (dmg_chance(b, 0.25f)) dmg_rest(b, door, far * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

static void draw_mirror_cabinet(dmg_builder* b) {
    int doors = dmg_int(b, 1, 3);
    float w = dmg_range(b, 0.25f, 0.5f), h = w * dmg_range(b, 0.9f, 2.2f), depth = w * dmg_range(b, 0.2f, 0.5f),
          wall = w * dmg_range(b, 0.02f, 0.05f), t = w * dmg_range(b, 0.015f, 0.06f);
    float total = (float)doors * w, shelf = dmg_chance(b, 0.3f) ? 0.2f * h : 0.0f;
    dmg_move(b, 0, 0.5f * h + shelf, 0.5f * depth);
    draw_boards(b, total, h, depth, wall, true);
    for (int i = 1; i < 3; ++i)
        dmg_box(b, v3(0, h * ((float)i / 3.0f - 0.5f), -0.55f * depth),
                v3(total - 2 * wall, 0.5f * wall, 0.7f * depth));
    if (shelf > 0.0f) dmg_box(b, v3(0, -0.5f * h - shelf, -0.5f * depth), v3(total, wall, depth));
    if (shelf > 0.0f) dmg_box(b, v3(0, -0.5f * (h + shelf), wall - depth), v3(total, shelf, wall));
    if (dmg_chance(b, 0.4f)) { /* a lamp over it, on an arm of its own */
        float up = 0.5f * h + 1.5f * wall;
        if (dmg_chance(b, 0.5f)) dmg_hinge(b, 0, "lamp", v3(0, up, t), v3(1, 0, 0), -0.6f, 0.6f);
        dmg_rod(b, v3(-0.35f * total, up, t), v3(0.35f * total, up, t), 1.2f * wall);
        dmg_use(b, 0);
    }
    bool slides = doors > 1 && dmg_chance(b, 0.2f);
    for (int i = 0; i < doors; ++i) {
        dmg_save(b);
        dmg_move(b, w * ((float)i - 0.5f * (float)(doors - 1)), 0, 0.02f * t);
        bool right = i + 1 == doors && doors > 1;
        if (right) dmg_mirror(b, v3(1, 0, 0));
        if (slides) { /* every second one on the front track */
            float z = i % 2 ? 1.1f * t : 0.0f;
            if (i == 0) dmg_use(b, 0);
            if (i > 0) dmg_slide(b, 0, "door", v3(right ? 1 : -1, 0, 0), 0.0f, dmg_range(b, 0.6f, 0.95f) * w);
            dmg_box(b, v3(0, 0, z + 0.5f * t), v3(0.99f * w, h, t));
        } else {
            draw_mirror_door(b, 0.99f * w, h, t, depth);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_tilt_cabinet(dmg_builder* b) {
    if (dmg_chance(b, 0.6f))
        draw_shoe_cabinet(b);
    else
        draw_mirror_cabinet(b);
}

/* ---- beds and desks that fold up ---- */

/* Legs or a bar on the face of a flap, which is below when the flap is down: flat on it, or folded out. */
static void draw_flap_legs(dmg_builder* b, uint32_t flap, float w, float y, float length, float out) {
    float leg = 0.04f * w;
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) return;
    uint32_t legs = dmg_hinge(b, flap, "legs", v3(0, y, out + 0.5f * leg), v3(-1, 0, 0), 0.0f, 0.5f * DMG_PI);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0.42f * (float)s * w, y - 0.5f * length, out + 0.5f * leg), v3(leg, length, leg));
    if (kind == 2) dmg_box(b, v3(0, y - length + 0.5f * leg, out + 0.5f * leg), v3(0.84f * w, leg, leg));
    dmg_rod(b, v3(-0.45f * w, y, out + 0.5f * leg), v3(0.45f * w, y, out + 0.5f * leg), 0.4f * leg);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, legs, 0.5f * DMG_PI);
    dmg_use(b, flap);
}

/* Upright or lying on its side in a case, it comes down about a line low in it, with the mattress behind its face. */
void dmg_build_wall_bed(dmg_builder* b) {
    float w = dmg_range(b, 0.8f, 1.8f), h = dmg_range(b, 1.9f, 2.3f), t = dmg_range(b, 0.02f, 0.06f),
          depth = dmg_range(b, 0.3f, 0.6f);
    if (dmg_chance(b, 0.3f)) { /* on its side */
        float swap = w;
        w = h;
        h = 0.9f * swap;
    }
    float wall = dmg_range(b, 0.015f, 0.04f), up = h * dmg_range(b, 0.02f, 0.2f),
          sole = fminf(up, h * dmg_range(b, 0.0f, 0.1f));
    int line = dmg_int(b, 0, 2); /* in the face's thickness, behind it, in the middle of the mattress */
    float bed = depth * dmg_range(b, 0.25f, 0.6f), inner = w - 2.4f * wall;
    const float lines[] = {-0.5f * t, -t, -t - 0.5f * bed};
    float z = lines[line], face = h - 2.5f * wall - sole;
    up = fmaxf(up, line == 2 ? wall + t + 0.5f * bed + 0.02f : wall);
    bool parts = dmg_chance(b, 0.3f),
         before = dmg_chance(b, 0.3f); /* a grid of doors is drawn on it; it lies before the case */
    dmg_move(b, 0, 0.5f * h, 0.5f * depth);
    draw_boards(b, w, h, depth, wall, dmg_chance(b, 0.7f));
    if (sole > 1.5f * wall)
        dmg_box_span(b, v3(-0.5f * inner, wall - 0.5f * h, -wall), v3(0.5f * inner, sole + wall - 0.5f * h, 0));
    float low = 0.5f * h - 1.2f * wall - face;
    if (before) dmg_move(b, 0, 0, 1.05f * t);
    uint32_t flap =
        dmg_hinge(b, 0, "bed", v3(0, fmaxf(up - 0.5f * h, before ? low : -h), z), v3(1, 0, 0), 0.0f, 0.5f * DMG_PI);
    dmg_panel panel = {.kind = DMG_PANEL_FLAT};
    if (dmg_chance(b, 0.4f)) panel = dmg_panel_pick(b);
    dmg_save(b);
    dmg_move(b, 0, low + 0.5f * face, 0);
    dmg_panel_draw(b, &panel, before ? w : inner, face, t);
    for (int i = -1; i <= 1 && parts; i += 2)
        dmg_box(b, v3(0.25f * (float)i * inner, 0, 0), v3(0.46f * inner, 0.94f * face, 0.3f * t));
    dmg_handle grip = dmg_handle_pick_bar(b, 0.15f);
    dmg_move(b, 0, 0.38f * face, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, 0.4f * w);
    dmg_restore(b);
    float from = low + up * 0.5f;
    if (dmg_chance(b, 0.8f))
        dmg_rounded_box(b, v3(0, 0.5f * (from + 0.47f * h), -t - 0.5f * bed), v3(0.93f * inner, 0.47f * h - from, bed),
                        0.2f * bed);
    for (int s = -1; s <= 1 && dmg_chance(b, 0.4f); s += 2)
        dmg_box(b, v3(0.48f * (float)s * inner, low + 0.55f * face, -t - 0.3f * bed),
                v3(0.03f * inner, 0.8f * face, 0.6f * bed));
    draw_flap_legs(b, flap, inner, 0.32f * h, fmaxf(0.06f * h, up), 0);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, flap, 0.5f * DMG_PI * (dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.2f, 1.0f)));
    dmg_use(b, 0);
}

/* Pigeon-holes behind a flap, a tray among them. */
static void draw_pigeon_holes(dmg_builder* b, float w, float h, float d, float wall) {
    int holes = dmg_int(b, 2, 5);
    for (int i = 1; i < holes; ++i)
        dmg_box(b, v3(w * ((float)i / (float)holes - 0.5f), 0, -0.6f * d), v3(0.5f * wall, h, 0.7f * d));
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, -0.6f * d), v3(w, 0.5f * wall, 0.7f * d));
}

typedef struct secretary {
    float w, h, d, wall, t;
    bool slopes, sunk;
} secretary;

/* Drawers between boards below y = 0. */
static void draw_desk_drawers(dmg_builder* b, const secretary* k, float high) {
    int rows = dmg_int(b, 1, 3);
    dmg_drawer tray = dmg_drawer_pick(b, 0.2f * k->w);
    tray.width = k->w - 2.2f * k->wall;
    tray.height = 0.95f * (high - 2 * k->wall) / (float)rows;
    tray.depth = 0.85f * k->d;
    tray.travel = 0.6f * k->d;
    dmg_save(b);
    dmg_move(b, 0, -0.5f * high, 0);
    draw_boards(b, k->w, high, k->d, k->wall, true);
    for (int i = 0; i < rows; ++i) {
        dmg_save(b);
        dmg_move(b, 0, (high - 2 * k->wall) * (((float)i + 0.5f) / (float)rows - 0.5f), 0);
        dmg_drawer_draw(b, 0, "drawer", &tray);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Draws what the flap closes: a case with its front at z = 0, or half as deep with cheeks that slope to z = d / 2. */
static void draw_desk_top(dmg_builder* b, const secretary* k) {
    float deep = k->slopes ? 0.5f * k->d : k->d;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * k->h, 0);
    draw_boards(b, k->w, k->h, deep, k->wall, true);
    draw_pigeon_holes(b, k->w - 2 * k->wall, k->h - 2 * k->wall, deep, k->wall);
    dmg_restore(b);
    if (!k->slopes) return;
    const dmg_xy cheek[] = {{0, 0}, {0.5f * k->d, 0}, {0, k->h}};
    dmg_box_span(b, v3(-0.5f * k->w, 0, 0), v3(0.5f * k->w, 0.8f * k->wall, 0.5f * k->d));
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    for (int s = -1; s <= 1; s += 2) {
        float x = 0.5f * (float)s * (k->w - k->wall);
        dmg_extrude(b, cheek, 3, x - 0.5f * k->wall, x + 0.5f * k->wall);
    }
    dmg_restore(b);
}

/* Falling by a right angle about its inner lower edge it lies level with the floor inside. */
static void draw_desk_flap(dmg_builder* b, const secretary* k) {
    static const float through[] = {1.0f, 1.0f, 0.5f, 0.0f};
    float lean = k->slopes ? atan2f(0.5f * k->d, k->h) : 0.0f, t = k->t, far = 0.5f * DMG_PI + lean;
    float length = k->slopes ? k->h / cosf(lean) : k->h - (k->sunk ? 2.3f * k->wall : 0.0f),
          width = k->sunk ? k->w - 2.3f * k->wall : k->w;
    dmg_save(b);
    dmg_move(b, 0, k->sunk ? 1.15f * k->wall : 0.0f, k->slopes ? 0.5f * k->d : 0.0f);
    dmg_turn(b, v3(1, 0, 0), -lean);
    if (!k->sunk) dmg_move(b, 0, 0, 1.02f * t);
    float up = k->sunk || dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.0f, 1.0f),
          back = -t * through[k->sunk ? 3 : dmg_int(b, 0, 3)];
    uint32_t flap = dmg_hinge(b, 0, "flap", v3(0, up, back), v3(1, 0, 0), 0.0f, far);
    dmg_panel panel = dmg_panel_pick(b);
    if (panel.kind == DMG_PANEL_BOWED) panel.kind = DMG_PANEL_FLAT;
    dmg_move(b, 0, 0.5f * length, 0);
    dmg_panel_draw(b, &panel, width, 0.99f * length, t);
    draw_front_grip(b, 0.38f * length, 0.15f * k->w, 0.4f * k->w);
    dmg_restore(b);
    float share = dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.2f, 1.0f);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, flap, share * far);
    dmg_use(b, 0);
}

/* Draws a case with a front that falls to be written on, perhaps on lopers that pull out below it. */
static void draw_secretary(dmg_builder* b) {
    secretary k = {.w = dmg_range(b, 0.4f, 1.0f)};
    k.h = k.w * dmg_range(b, 0.4f, 1.0f);
    k.d = k.w * dmg_range(b, 0.25f, 0.6f);
    k.wall = 0.025f * k.w;
    k.t = k.w * dmg_range(b, 0.015f, 0.05f);
    k.slopes = dmg_chance(b, 0.3f);
    k.sunk = !k.slopes && dmg_chance(b, 0.5f);
    float leg = dmg_chance(b, 0.7f) ? k.w * dmg_range(b, 0.4f, 0.9f) : 0.3f * k.w;
    bool drawers = dmg_chance(b, 0.5f), lopers = dmg_chance(b, 0.4f);
    if (!drawers) dmg_feet_draw(b, 0, k.w, k.d, leg);
    dmg_move(b, 0, leg, 0.5f * k.d);
    if (drawers) draw_desk_drawers(b, &k, leg);
    dmg_save(b);
    if (k.slopes) dmg_move(b, 0, 0, -0.5f * k.d);
    draw_desk_top(b, &k);
    draw_desk_flap(b, &k);
    dmg_restore(b);
    for (int s = -1; s <= 1 && lopers; s += 2) {
        float x = 0.44f * (float)s * k.w;
        dmg_slide(b, 0, "loper", v3(0, 0, 1), 0.0f, 0.6f * k.d);
        dmg_box_span(b, v3(x - 0.015f * k.w, -0.9f * k.wall, -0.9f * k.d),
                     v3(x + 0.015f * k.w, -0.05f * k.wall, 1.4f * k.t));
        dmg_use(b, 0);
    }
}

/* Draws a leaf that hangs flat below a shelf on the wall and is lifted level; brackets swing out to hold it, or a leg
 * does. */
static void draw_wall_flap(dmg_builder* b) {
    float w = dmg_range(b, 0.4f, 1.2f), reach = w * dmg_range(b, 0.3f, 0.7f), t = w * dmg_range(b, 0.02f, 0.05f),
          shelf = w * dmg_range(b, 0.05f, 0.25f), up = reach * dmg_range(b, 1.1f, 1.8f);
    int line = dmg_int(b, 0, 2); /* knuckles below the seam, on the upper edge, in the middle */
    const float lines[] = {-t, 0.0f, -0.5f * t};
    dmg_move(b, 0, up, 0);
    dmg_box_span(b, v3(-0.5f * w, -t, 0), v3(0.5f * w, 0, shelf));
    dmg_box_span(b, v3(-0.5f * w, -0.35f * reach, -t), v3(0.5f * w, 0, 0));
    float far = 0.5f * DMG_PI, gap = line == 1 ? 0.02f * t : t; /* room for it to hang */
    uint32_t leaf = dmg_hinge(b, 0, "leaf", v3(0, lines[line], shelf + 0.02f * t), v3(1, 0, 0), 0.0f, far);
    if (line != 1) gap = 0.02f * t;
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * w, -t, shelf + gap), v3(0.5f * w, 0, shelf + gap + reach));
    else {
        dmg_save(b);
        dmg_move(b, 0, 0, shelf + gap + 0.5f * reach);
        dmg_face_up(b);
        dmg_rounded_plate(b, w, reach, t, dmg_range(b, 0.05f, 0.4f) * reach);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(-0.48f * w, lines[line], shelf), v3(0.48f * w, lines[line], shelf), 0.3f * t);
    if (dmg_chance(b, 0.35f)) { /* a leg folded under it */
        float y = -t - 0.6f * t, z = shelf + 0.85f * reach;
        dmg_hinge(b, leaf, "leg", v3(0, y, z), v3(1, 0, 0), -0.5f * DMG_PI, 0.0f);
        dmg_box_span(b, v3(-0.03f * w, y - fminf(0.9f * reach, 0.8f * up), z - t), v3(0.03f * w, y, z));
        dmg_use(b, leaf);
    }
    dmg_rest(b, leaf, dmg_chance(b, 0.5f) ? 0.0f : far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
}

void dmg_build_fold_desk(dmg_builder* b) {
    if (dmg_chance(b, 0.7f))
        draw_secretary(b);
    else
        draw_wall_flap(b);
}
