/* Draws storage furniture: a front is cut into cells, and each cell gets a door, a drawer, a flap or nothing. */
#include <stdio.h>

#include "core/build.h"
#include "parts/hardware.h"

enum { CELL_LIMIT = 24 };

typedef struct cell {
    float x0, y0, x1, y1;
} cell;

/* What fills the cells of one piece of furniture, and how all its fronts look. */
typedef struct fittings {
    float drawer, door, flap, open, fixed; /* weights */
    float depth;                           /* of the case */
    float wall;
    float gap;     /* between fronts */
    float overlay; /* 1: fronts lie on the case, 0: flush with it, between: half let in */
    dmg_case_kind shell;
    bool twin_doors; /* wide cells get two leaves */
    dmg_leaf leaf;
    dmg_drawer box;
} fittings;

static fittings fittings_pick(dmg_builder* b, float hand) {
    fittings f = {.drawer = 1, .door = 1, .flap = 0.1f, .open = 0.15f, .fixed = 0.05f};
    f.gap = dmg_chance(b, 0.3f) ? 0.0f : hand * dmg_range(b, 0.01f, 0.06f);
    f.wall = hand * dmg_range(b, 0.08f, 0.2f);
    f.overlay = dmg_chance(b, 0.6f) ? 1.0f : (dmg_chance(b, 0.8f) ? 0.0f : dmg_range(b, 0.2f, 0.9f));
    f.shell = dmg_case_pick(b);
    f.twin_doors = dmg_chance(b, 0.7f);
    f.leaf = dmg_leaf_pick(b, hand);
    f.box = dmg_drawer_pick(b, hand);
    if (dmg_chance(b, 0.4f)) f.leaf.thickness *= dmg_scale_range(b, 0.5f, 2.5f);
    if (dmg_chance(b, 0.75f)) { /* one family of hardware for all */
        f.box.handle = f.leaf.handle;
        f.box.panel = f.leaf.panel;
        f.box.thickness = f.leaf.thickness;
    }
    if (f.overlay < 1.0f) f.leaf.depth = fminf(f.leaf.depth, 0.5f); /* a leaf let in turns about its front edge */
    return f;
}

/* ---- cutting the front ---- */

static int cut(dmg_builder* b, cell whole, int depth, float smallest, cell* out, int count) {
    float w = whole.x1 - whole.x0, h = whole.y1 - whole.y0;
    bool can_x = w > 2 * smallest, can_y = h > 2 * smallest;
    if (depth == 0 || (!can_x && !can_y) || count >= CELL_LIMIT - 6) {
        out[count++] = whole;
        return count;
    }
    bool along_x = can_x && (!can_y || dmg_chance(b, w / (w + h)));
    int room = (int)((along_x ? w : h) / smallest), pieces = dmg_int(b, 2, room < 2 ? 2 : (room > 4 ? 4 : room));
    bool even = dmg_chance(b, 0.7f);
    float from = 0.0f;
    for (int i = 0; i < pieces; ++i) {
        float to = (float)(i + 1) / (float)pieces;
        if (!even && i + 1 < pieces) to += dmg_range(b, -0.25f, 0.25f) / (float)pieces;
        cell part = whole;
        if (along_x)
            part.x0 = whole.x0 + from * w, part.x1 = whole.x0 + to * w;
        else
            part.y0 = whole.y0 + from * h, part.y1 = whole.y0 + to * h;
        int deeper = dmg_chance(b, 0.45f) ? depth - 1 : 0;
        count = cut(b, part, deeper, smallest, out, count);
        from = to;
    }
    return count;
}

/* ---- filling a cell ---- */

static void draw_door(dmg_builder* b, const fittings* f, float w, float h, dmg_side side, const char* name) {
    dmg_leaf leaf = f->leaf;
    leaf.width = w - f->gap;
    leaf.height = h - f->gap;
    leaf.side = side;
    dmg_leaf_draw(b, 0, name, &leaf);
    dmg_use(b, 0);
}

static void draw_doors(dmg_builder* b, const fittings* f, float w, float h) {
    if (f->twin_doors && w > 0.8f * h) {
        dmg_save(b);
        dmg_move(b, -0.25f * w, 0, 0);
        draw_door(b, f, 0.5f * w, h, DMG_SIDE_LEFT, "door_left");
        dmg_move(b, 0.5f * w, 0, 0);
        draw_door(b, f, 0.5f * w, h, DMG_SIDE_RIGHT, "door_right");
        dmg_restore(b);
        return;
    }
    bool left = dmg_chance(b, 0.5f);
    draw_door(b, f, w, h, left ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT, "door");
}

static void draw_flap(dmg_builder* b, const fittings* f, float w, float h) {
    bool hung_above = dmg_chance(b, 0.5f);
    draw_door(b, f, w, h, hung_above ? DMG_SIDE_TOP : DMG_SIDE_BOTTOM, "flap");
}

static void draw_box(dmg_builder* b, const fittings* f, float w, float h) {
    dmg_drawer drawer = f->box;
    drawer.width = w - f->gap;
    drawer.height = h - f->gap;
    drawer.depth = f->depth * 0.93f - (1.0f - f->overlay) * drawer.thickness;
    drawer.travel = drawer.depth * 0.85f;
    dmg_drawer_draw(b, 0, "drawer", &drawer);
    dmg_use(b, 0);
}

static void draw_niche(dmg_builder* b, const fittings* f, float w, float h) {
    int boards = f->shell == DMG_CASE_SOLID ? 0 : dmg_int(b, 0, 2);
    for (int i = 1; i <= boards; ++i) {
        float y = h * ((float)i / (float)(boards + 1) - 0.5f);
        dmg_box(b, v3(0, y, -0.5f * f->depth), v3(w - f->wall, 0.7f * f->wall, 0.92f * f->depth));
    }
}

/* Draws what suits the cell's shape: tall ones get doors, low ones drawers and flaps. */
static int kind_for(dmg_builder* b, const fittings* f, float w, float h) {
    float low = w / h;
    const float weights[] = {f->drawer * (low > 1.2f ? 3.0f : 0.3f), f->door * (low < 1.6f ? 2.0f : 0.3f),
                             f->flap * (low > 1.2f ? 2.0f : 0.2f), f->open, f->fixed};
    return dmg_weighted(b, weights, 5);
}

static void fill_cell(dmg_builder* b, const fittings* f, const cell* c, int kind) {
    float w = c->x1 - c->x0, h = c->y1 - c->y0, thickness = kind == 0 ? f->box.thickness : f->leaf.thickness;
    dmg_save(b);
    dmg_move(b, 0.5f * (c->x0 + c->x1), 0.5f * (c->y0 + c->y1), 0);
    if (kind >= 3 || f->shell != DMG_CASE_SOLID) { /* what is behind the front */
        dmg_use(b, 0);
        if (kind == 3) draw_niche(b, f, w, h);
        if (kind == 4) dmg_box(b, v3(0, 0, 0.5f * f->overlay * thickness), v3(w - f->gap, h - f->gap, thickness));
        if (kind == 1 && dmg_chance(b, 0.5f)) draw_niche(b, f, w, h);
    }
    dmg_move(b, 0, 0, f->overlay * thickness);
    if (kind == 0) draw_box(b, f, w, h);
    if (kind == 1) draw_doors(b, f, w, h);
    if (kind == 2) draw_flap(b, f, w, h);
    dmg_restore(b);
}

/* Boards between cells: the inner edges, from the case's back to its front. */
static void draw_dividers(dmg_builder* b, const fittings* f, const cell* whole, const cell* cells, int count) {
    float t = 0.7f * f->wall, z = -0.5f * f->depth - 0.02f * f->depth, d = 0.94f * f->depth;
    for (int i = 0; i < count; ++i) {
        const cell* c = &cells[i];
        float w = c->x1 - c->x0, h = c->y1 - c->y0, x = 0.5f * (c->x0 + c->x1), y = 0.5f * (c->y0 + c->y1);
        if (c->x1 < whole->x1 - 1e-4f) dmg_box(b, v3(c->x1, y, z), v3(t, h, d));
        if (c->y1 < whole->y1 - 1e-4f) dmg_box(b, v3(x, c->y1, z), v3(w, t, d));
    }
}

/* Case, fronts and dividers of width x height, its front at z = 0, centred at the origin. */
static void draw_storage(dmg_builder* b, const fittings* f, float width, float height, int depth, float smallest) {
    cell cells[CELL_LIMIT], whole = {-0.5f * width, -0.5f * height, 0.5f * width, 0.5f * height};
    dmg_use(b, 0);
    dmg_case_draw(b, f->shell, width, height, f->depth, f->wall);
    float in = f->overlay == 1.0f ? 0.3f * f->wall : f->wall;
    cell front = {whole.x0 + in, whole.y0 + in, whole.x1 - in, whole.y1 - in};
    int count = cut(b, front, depth, smallest, cells, 0);
    if (f->shell != DMG_CASE_SOLID && dmg_chance(b, 0.7f)) draw_dividers(b, f, &front, cells, count);
    for (int i = 0; i < count; ++i) {
        int kind = kind_for(b, f, cells[i].x1 - cells[i].x0, cells[i].y1 - cells[i].y0);
        if (i + 1 == count && b->part_count == 0 && kind > 2) kind = dmg_chance(b, 0.5f) ? 1 : 0;
        fill_cell(b, f, &cells[i], kind);
    }
    dmg_use(b, 0);
}

/* Stands it on the floor with its back to -Z: feet below, perhaps a top. Leaves the frame at the middle of the front.
 */
static void place_storage(dmg_builder* b, const fittings* f, float width, float height) {
    float foot = dmg_chance(b, 0.5f) ? height * dmg_range(b, 0.03f, 0.3f) : 0.0f;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), width, f->depth, foot);
    if (dmg_chance(b, 0.4f)) {
        float over = f->wall * dmg_range(b, 0, 3), thick = f->wall * dmg_range(b, 0.6f, 2.5f);
        dmg_box(b, v3(0, foot + height + 0.5f * thick, 0.5f * over), v3(width + over, thick, f->depth + over));
    }
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * f->depth);
}

void dmg_build_cabinet(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.3f, 2.0f), height = dmg_scale_range(b, 0.35f, 2.2f);
    fittings f = fittings_pick(b, 0.15f);
    f.depth = dmg_scale_range(b, 0.2f, 0.7f);
    f.door = dmg_scale_range(b, 0.7f, 6.0f);
    place_storage(b, &f, width, height);
    int depth = dmg_chance(b, 0.3f) ? 0 : dmg_int(b, 1, 3);
    draw_storage(b, &f, width, height, depth, fmaxf(0.16f, 0.16f * fmaxf(width, height)));
}

void dmg_build_drawers(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 1.6f), height = dmg_scale_range(b, 0.15f, 1.5f);
    fittings f = fittings_pick(b, 0.13f);
    f.depth = dmg_scale_range(b, 0.25f, 0.7f);
    f.door = dmg_chance(b, 0.2f) ? 0.3f : 0.0f;
    f.flap = f.fixed = 0.0f;
    f.open = dmg_chance(b, 0.3f) ? 0.3f : 0.0f;
    place_storage(b, &f, width, height);
    float smallest = dmg_range(b, 0.08f, 0.22f);
    draw_storage(b, &f, width, height, dmg_int(b, 1, 3), fmaxf(smallest, 0.12f * height));
}

/* ---- the demo's kitchen base unit ---- */

static void draw_kitchen_doors(dmg_builder* b, const fittings* f, float width, float height) {
    dmg_save(b);
    dmg_move(b, -0.25f * width, 0, 0);
    draw_door(b, f, 0.5f * width, height, DMG_SIDE_LEFT, "door_left");
    dmg_move(b, 0.5f * width, 0, 0);
    draw_door(b, f, 0.5f * width, height, DMG_SIDE_RIGHT, "door_right");
    dmg_restore(b);
}

static void draw_kitchen_drawers(dmg_builder* b, const fittings* f, float width, float height) {
    static const char* const names[] = {"drawer_left", "drawer_right"};
    for (int i = 0; i < 2; ++i) {
        dmg_drawer drawer = f->box;
        drawer.width = 0.5f * width - f->gap;
        drawer.height = height - f->gap;
        drawer.depth = 0.9f * f->depth;
        drawer.travel = 0.75f * f->depth;
        dmg_save(b);
        dmg_move(b, width * ((float)i - 0.5f) * 0.5f, 0, 0);
        dmg_drawer_draw(b, 0, names[i], &drawer);
        dmg_restore(b);
    }
}

static fittings kitchen_fittings(dmg_builder* b) {
    fittings f = {
        .depth = dmg_range(b, 0.54f, 0.6f), .wall = 0.018f, .gap = 0.004f, .overlay = 1.0f, .shell = DMG_CASE_BOARDS};
    dmg_handle bar = {DMG_HANDLE_BAR, dmg_range(b, 0.14f, 0.22f), 0.012f, 0.035f, 0.85f};
    dmg_panel panel = {
        .kind = dmg_chance(b, 0.5f) ? DMG_PANEL_FRAMED : DMG_PANEL_RAISED, .border = 0.14f, .infill = 0.6f};
    f.leaf = (dmg_leaf){
        .thickness = 0.02f, .swing = 1.92f, .depth = 1.0f, .handle_edge = 0.09f, .panel = panel, .handle = bar};
    f.leaf.handle_at = 0.28f;
    f.box = (dmg_drawer){
        .thickness = 0.02f, .tray_height = 0.7f, .wall = 0.012f, .tray = DMG_TRAY_BOARDS, .handle = bar, .handles = 1};
    f.box.panel = panel;
    f.box.panel.border = 0.2f;
    return f;
}

void dmg_build_kitchen_cabinet(dmg_builder* b) {
    fittings f = kitchen_fittings(b);
    float width = dmg_range(b, 0.8f, 1.0f), plinth = 0.1f, height = 0.72f, top = 0.04f,
          drawer = dmg_range(b, 0.15f, 0.19f);
    dmg_box(b, v3(0, 0.5f * plinth, -0.025f), v3(width, plinth, f.depth - 0.05f));
    dmg_box(b, v3(0, plinth + height + 0.5f * top, 0.015f), v3(width + 0.02f, top, f.depth + 0.05f));
    dmg_move(b, 0, plinth, 0.5f * f.depth);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * height, 0);
    dmg_case_draw(b, f.shell, width, height, f.depth, f.wall);
    dmg_restore(b);
    float doors = height - drawer;
    dmg_box(b, v3(0, doors, -0.5f * f.depth), v3(width - 2 * f.wall, f.wall, 0.94f * f.depth));
    dmg_box(b, v3(0, 0.5f * doors, -0.52f * f.depth), v3(width - 2 * f.wall, f.wall, 0.85f * f.depth)); /* shelf */
    dmg_move(b, 0, 0, f.leaf.thickness);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * doors, 0);
    draw_kitchen_doors(b, &f, width, doors);
    dmg_restore(b);
    dmg_move(b, 0, doors + 0.5f * drawer, 0);
    draw_kitchen_drawers(b, &f, width, drawer);
}
