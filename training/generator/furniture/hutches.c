/* Draws furniture of plain thick slabs, as in kitchens of robot simulators: doors, sliders and drawers with bar
 * handles. */
#include "core/build.h"
#include "parts/hardware.h"

/* What all fronts of a piece have in common. */
typedef struct slabs {
    float depth, wall, thickness;
    float gap;    /* between case and slab */
    float margin; /* of a slab from its module's edge */
    dmg_case_kind shell;
    dmg_leaf leaf;
} slabs;

static dmg_handle pick_pull(dmg_builder* b, float hand) {
    static const float weights[] = {1, 4, 4, 2, 1};
    static const dmg_handle_kind kinds[] = {DMG_HANDLE_NONE, DMG_HANDLE_BAR, DMG_HANDLE_FLAT, DMG_HANDLE_ARCH,
                                            DMG_HANDLE_KNOB};
    dmg_handle pull = {.kind = kinds[dmg_weighted(b, weights, 5)]};
    pull.length = hand * dmg_range(b, 0.3f, 0.9f);
    pull.thickness = hand * dmg_scale_range(b, 0.025f, 0.14f);
    pull.standoff = fmaxf(hand * dmg_range(b, 0.08f, 0.28f), pull.thickness);
    pull.post = dmg_range(b, 0.5f, 0.95f);
    return pull;
}

static slabs pick_slabs(dmg_builder* b, float small, float depth) {
    slabs s = {.depth = depth};
    s.wall = small * dmg_range(b, 0.03f, 0.12f);
    s.thickness = small * dmg_scale_range(b, 0.025f, 0.18f);
    s.gap = dmg_chance(b, 0.5f) ? 0.0f : s.thickness * dmg_range(b, 0.02f, 0.3f);
    s.margin = dmg_chance(b, 0.4f) ? 0.0f : s.thickness * dmg_range(b, 0.05f, 0.4f);
    static const dmg_case_kind shells[] = {DMG_CASE_BOARDS, DMG_CASE_BOARDS, DMG_CASE_SHEET, DMG_CASE_SOLID};
    s.shell = shells[dmg_int(b, 0, 3)];
    s.leaf = dmg_leaf_pick(b, 0.25f * small);
    s.leaf.thickness = s.thickness;
    s.leaf.inset = fminf(s.leaf.inset, 0.8f); /* of a slab this thick */
    s.leaf.handle = pick_pull(b, small);
    s.leaf.handle_edge = dmg_range(b, 0.08f, 0.3f);
    if (dmg_chance(b, 0.8f)) s.leaf.handle_at = 0.0f;
    if (dmg_chance(b, 0.7f)) s.leaf.panel = (dmg_panel){.kind = DMG_PANEL_FLAT};
    if (dmg_chance(b, 0.7f)) s.leaf.hinge.kind = DMG_HINGE_NONE;
    return s;
}

/* Draws a case of width x height with its front at z = 0, centred; fronts lie before it. */
static void draw_module(dmg_builder* b, const slabs* s, float width, float height) {
    dmg_use(b, 0);
    dmg_case_draw(b, s->shell, width, height, s->depth, s->wall);
    if (s->shell == DMG_CASE_BOARDS && dmg_chance(b, 0.3f))
        dmg_box(b, v3(0, 0, -0.5f * s->depth), v3(width - 2 * s->wall, s->wall, 0.9f * s->depth));
}

static void draw_slab_door(dmg_builder* b, const slabs* s, float width, float height, dmg_side side) {
    dmg_leaf leaf = s->leaf;
    leaf.width = width - 2 * s->margin;
    leaf.height = height - 2 * s->margin;
    leaf.side = side;
    dmg_save(b);
    dmg_move(b, 0, 0, s->gap + s->thickness);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a slab that slides along the front: `way` is 1 to the right, -1 to the left. */
static void draw_slider(dmg_builder* b, const slabs* s, float width, float height, float way, float travel) {
    float w = width - 2 * s->margin, h = height - 2 * s->margin;
    dmg_save(b);
    dmg_move(b, 0, 0, fmaxf(s->gap, 0.02f * s->thickness) + s->thickness);
    dmg_slide(b, 0, "slider", v3(way, 0, 0), 0.0f, travel);
    dmg_panel_draw(b, &s->leaf.panel, w, h, s->thickness);
    /* The pull: in the middle, or on the edge that it is pushed with. */
    float at = dmg_chance(b, 0.4f) ? 0.0f : dmg_sign(b) * dmg_range(b, 0.25f, 0.45f);
    dmg_move(b, at * w, 0, 0);
    dmg_handle_draw(b, &s->leaf.handle, 0.9f * h);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_slab_drawer(dmg_builder* b, const slabs* s, float width, float height) {
    dmg_drawer drawer = dmg_drawer_pick(b, 0.25f * fminf(width, height));
    drawer.width = width - 2 * s->margin;
    drawer.height = height - 2 * s->margin;
    drawer.thickness = s->thickness;
    drawer.depth = s->depth * dmg_range(b, 0.6f, 0.95f);
    drawer.travel = drawer.depth * dmg_range(b, 0.6f, 0.9f);
    drawer.panel = s->leaf.panel;
    drawer.handle = s->leaf.handle;
    dmg_save(b);
    dmg_move(b, 0, 0, s->gap + s->thickness);
    dmg_drawer_draw(b, 0, "drawer", &drawer);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void fill_module(dmg_builder* b, const slabs* s, float width, float height) {
    static const float weights[] = {3, 1, 1.5f, 0.6f, 0.6f};
    draw_module(b, s, width, height);
    switch (dmg_weighted(b, weights, 5)) {
    case 0:
        draw_slab_door(b, s, width, height, dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
        break;
    case 1:
        dmg_save(b);
        dmg_move(b, -0.25f * width, 0, 0);
        draw_slab_door(b, s, 0.5f * width, height, DMG_SIDE_LEFT);
        dmg_move(b, 0.5f * width, 0, 0);
        draw_slab_door(b, s, 0.5f * width, height, DMG_SIDE_RIGHT);
        dmg_restore(b);
        break;
    case 2:
        draw_slab_drawer(b, s, width, height);
        break;
    case 3:
        draw_slab_door(b, s, width, height, DMG_SIDE_BOTTOM);
        break;
    default:
        draw_slab_door(b, s, width, height, DMG_SIDE_TOP);
        break;
    }
}

/* One to six alike modules beside and over each other, perhaps hanging on a wall. */
void dmg_build_slab_cabinet(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 0.9f), height = width * dmg_scale_range(b, 0.4f, 1.8f);
    int columns = dmg_int(b, 1, 3), rows = dmg_chance(b, 0.6f) ? 1 : 2;
    float depth = width * dmg_scale_range(b, 0.4f, 1.8f), apart = dmg_chance(b, 0.7f) ? 1.0f : dmg_range(b, 1.0f, 1.2f);
    slabs s = pick_slabs(b, fminf(width, height), depth);
    dmg_move(b, 0, 0.5f * height, 0.5f * depth);
    for (int i = 0; i < columns * rows; ++i) {
        dmg_save(b);
        dmg_move(b, apart * width * ((float)(i % columns) - 0.5f * (float)(columns - 1)),
                 apart * height * (float)(i / columns), 0);
        fill_module(b, &s, width, height);
        dmg_restore(b);
    }
}

/* Draws a front twice as wide as its slab, which slides from before one half to before the other. */
static void draw_half_closed(dmg_builder* b, const slabs* s, float width, float height) {
    float way = dmg_sign(b), share = dmg_range(b, 0.4f, 0.6f), slab = share * width;
    bool partition = dmg_chance(b, 0.5f), closed_half = s->shell != DMG_CASE_SOLID && dmg_chance(b, 0.4f);
    draw_module(b, s, width, height);
    float seam = -way * (0.5f - share) * width;
    if (partition) dmg_box(b, v3(seam, 0, -0.5f * s->depth), v3(s->wall, height - s->wall, s->depth));
    if (closed_half) /* the other half has a fixed front, let in */
        dmg_box(b, v3(0.5f * (seam + way * 0.5f * width), 0, -0.5f * s->wall),
                v3((1.0f - share) * width - s->wall, height - s->wall, s->wall));
    dmg_save(b);
    dmg_move(b, -way * 0.5f * (width - slab), 0, 0);
    draw_slider(b, s, slab, height, way, (1.0f - share) * width * dmg_range(b, 0.7f, 1.0f));
    dmg_restore(b);
}

void dmg_build_sliding_cabinet(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.25f, 1.0f), width = height * dmg_scale_range(b, 1.2f, 3.0f),
          depth = height * dmg_scale_range(b, 0.4f, 1.8f);
    slabs s = pick_slabs(b, height, depth);
    float foot = dmg_chance(b, 0.3f) ? height * dmg_range(b, 0.05f, 0.4f) : 0.0f;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, 3), width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    draw_half_closed(b, &s, width, height);
}

/* A glazed front in a frame: sashes on two tracks before a shallow or deep case, the ones on the front track move. */
void dmg_build_showcase(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.2f, 1.6f), width = height * dmg_scale_range(b, 0.8f, 3.0f),
          depth = height * dmg_scale_range(b, 0.03f, 0.8f), border = height * dmg_range(b, 0.02f, 0.14f),
          t = height * dmg_scale_range(b, 0.015f, 0.1f);
    slabs s = pick_slabs(b, height, depth);
    s.leaf.panel = dmg_chance(b, 0.7f) ? dmg_panel_pick_window(b) : s.leaf.panel;
    s.thickness = t;
    s.gap = s.margin = 0.0f;
    int count = dmg_int(b, 2, 3);
    float slab = width / (float)count, sash = slab * dmg_range(b, 1.0f, 1.08f), rim = t * dmg_range(b, 1.0f, 2.4f);
    bool sunk = dmg_chance(b, 0.6f);
    dmg_move(b, 0, 0.5f * height + border, 0.5f * depth);
    dmg_save(b);
    dmg_move(b, 0, 0, sunk ? 2.2f * t : rim - t);
    dmg_frame_draw(b, width + 2 * border, height + 2 * border, sunk ? 2.2f * t : rim, border);
    dmg_restore(b);
    if (depth > 3 * t) dmg_case_draw(b, DMG_CASE_SHEET, width + border, height + border, depth, s.wall);
    int first = dmg_int(b, 0, 1);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, slab * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        if (i % 2 == first) {
            float way = i == 0 ? 1.0f : (i + 1 == count ? -1.0f : dmg_sign(b));
            dmg_move(b, 0, 0, 1.1f * t);
            draw_slider(b, &s, sash, height, way,
                        slab * dmg_range(b, 0.6f, 1.0f) * (sash > 1.04f * slab ? 0.9f : 0.95f));
        } else {
            dmg_move(b, 0, 0, t);
            dmg_panel_draw(b, &s.leaf.panel, sash, height, t);
        }
        dmg_restore(b);
    }
}

/* ---- desks with something on top ---- */

static void draw_desk_legs(dmg_builder* b, float width, float depth, float height, float leg, float top) {
    dmg_box(b, v3(0, height - 0.5f * top, 0), v3(width, top, depth));
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * (width - 2 * leg), z = (i & 2 ? 0.5f : -0.5f) * (depth - 2 * leg);
        dmg_box(b, v3(x, 0.5f * (height - top), z), v3(leg, height - top, leg));
    }
}

/* Drawers hanging below the top at y = 0, in a case or between runners, fronts at z = 0. */
static void draw_hung_drawers(dmg_builder* b, const slabs* s, float width, float height) {
    int count = dmg_int(b, 1, 3);
    bool cased = dmg_chance(b, 0.6f);
    float w = width / (float)count;
    dmg_move(b, 0, -0.5f * height, 0);
    if (cased && s->shell != DMG_CASE_SOLID) dmg_case_draw(b, s->shell, width, height, s->depth, 0.3f * s->wall);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, w * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        draw_slab_drawer(b, s, 0.96f * w, 0.94f * height);
        dmg_restore(b);
    }
}

void dmg_build_desk_hutch(dmg_builder* b) {
    float width = dmg_range(b, 0.8f, 1.6f), depth = width * dmg_range(b, 0.35f, 0.6f),
          height = dmg_range(b, 0.6f, 0.8f), top = dmg_range(b, 0.02f, 0.06f), leg = dmg_range(b, 0.03f, 0.07f);
    float above = height * dmg_range(b, 0.3f, 0.8f), back = depth * dmg_range(b, 0.35f, 0.8f);
    draw_desk_legs(b, width, depth, height, leg, top);
    dmg_save(b);
    dmg_move(b, 0, height - top, 0.5f * depth - 1.5f * leg);
    slabs below = pick_slabs(b, height * dmg_range(b, 0.12f, 0.25f), depth - 3 * leg);
    if (dmg_chance(b, 0.75f)) {
        const float tall = height * dmg_range(b, 0.1f, 0.22f), wide = (width - 4 * leg) * dmg_range(b, 0.4f, 1.0f);
        draw_hung_drawers(b, &below, wide, tall);
    }
    dmg_restore(b);
    slabs s = pick_slabs(b, above, back);
    s.wall = fminf(s.wall, 0.06f * above);
    dmg_move(b, 0, height + 0.5f * above, back - 0.5f * depth);
    if (dmg_chance(b, 0.65f)) {
        draw_half_closed(b, &s, width, above);
        return;
    }
    int columns = dmg_int(b, 1, 3);
    for (int i = 0; i < columns; ++i) {
        dmg_save(b);
        dmg_move(b, width / (float)columns * ((float)i - 0.5f * (float)(columns - 1)), 0, 0);
        fill_module(b, &s, width / (float)columns, above);
        dmg_restore(b);
    }
}

/* ---- small tables around their drawers ---- */

/* A drawer as a joiner makes it: five boards, the front no larger than the box, or a front wider than it. */
static void draw_joined_drawer(dmg_builder* b, float width, float height, float depth, float travel, float board) {
    float over = dmg_chance(b, 0.5f) ? 0.0f : board * dmg_range(b, 0.5f, 2.0f), low = dmg_range(b, 0.5f, 1.0f);
    bool closed = dmg_chance(b, 0.1f);
    dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, travel);
    dmg_box(b, v3(0, 0, -0.5f * board), v3(width, height, board));
    dmg_save(b);
    dmg_move(b, 0, -0.5f * height, -board);
    dmg_tray_draw(b, closed ? DMG_TRAY_SOLID : DMG_TRAY_BOARDS, width - 2 * over, low * height, depth - board, board);
    dmg_restore(b);
    dmg_handle pull = dmg_handle_pick(b, 0.3f * fminf(width, 2 * height));
    pull.standoff = fminf(pull.standoff, 0.4f * height);
    if (dmg_chance(b, 0.35f)) pull.kind = DMG_HANDLE_NONE;
    int pulls = width > 2.5f * height && dmg_chance(b, 0.3f) ? 2 : 1;
    for (int i = 0; i < pulls; ++i) {
        dmg_save(b);
        dmg_move(b, width * ((float)i - 0.5f * (float)(pulls - 1)) * 0.5f,
                 pull.kind == DMG_HANDLE_LIP ? 0.4f * height : 0, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &pull, width / (float)pulls);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws the frame that the drawers run in: cheeks, a back, rails before and between; any of them may be missing. */
static void draw_drawer_frame(dmg_builder* b, float width, float height, float depth, float leg) {
    float board = leg * dmg_range(b, 0.2f, 0.6f);
    bool cheeks = dmg_chance(b, 0.75f), back = dmg_chance(b, 0.7f), floor = dmg_chance(b, 0.4f);
    for (int s = -1; s <= 1 && cheeks; s += 2)
        dmg_box(b, v3((float)s * (0.5f * width + 0.5f * leg), -0.5f * height, -0.5f * depth), v3(board, height, depth));
    if (back) dmg_box(b, v3(0, -0.5f * height, -depth), v3(width + leg, height, board));
    if (floor) dmg_box(b, v3(0, -height - 0.5f * board, -0.5f * depth), v3(width + leg, board, depth));
}

void dmg_build_nightstand(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.35f, 1.8f), depth = dmg_scale_range(b, 0.35f, 0.8f),
          height = dmg_range(b, 0.4f, 0.85f);
    float leg = dmg_range(b, 0.025f, 0.12f), top = dmg_range(b, 0.012f, 0.06f),
          over = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.1f);
    dmg_box(b, v3(0, height - 0.5f * top, 0), v3(width + 2 * over, top, depth + 2 * over));
    int feet = dmg_int(b, 0, 2); /* posts to the floor, ends of board, a case down to the floor */
    for (int i = 0; i < 4 && feet == 0; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * (width - leg), z = (i & 2 ? 0.5f : -0.5f) * (depth - leg);
        dmg_box(b, v3(x, 0.5f * (height - top), z), v3(leg, height - top, leg));
    }
    for (int s = -1; s <= 1 && feet > 0; s += 2)
        dmg_box(b, v3((float)s * 0.5f * (width - leg), 0.5f * (height - top), 0), v3(leg, height - top, depth));
    float inner = width - 2.04f * leg, block = (height - top) * (feet == 2 ? 1.0f : dmg_range(b, 0.15f, 0.6f));
    if (dmg_chance(b, 0.4f) && feet < 2)
        dmg_box(b, v3(0, 0.3f * (height - block), 0), v3(width - leg, 0.4f * leg, depth - leg)); /* a shelf */
    int columns = inner > 0.7f ? dmg_int(b, 1, 3) : 1, rows = block > 0.25f ? dmg_int(b, 1, 3) : 1;
    float set_back = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.5f) * leg;
    float proud = dmg_chance(b, 0.3f) ? dmg_range(b, 0.0f, 0.5f) * leg : 0.0f;
    float deep = (depth - set_back) * dmg_range(b, 0.6f, 0.97f), board = dmg_range(b, 0.006f, 0.03f);
    float travel = deep * dmg_range(b, 0.5f, 0.95f);
    dmg_move(b, 0, height - top, 0.5f * depth - set_back);
    draw_drawer_frame(b, inner, block, 0.98f * (depth - set_back), leg);
    for (int i = 0; i < rows * columns; ++i) {
        float w = inner / (float)columns, h = block / (float)rows;
        dmg_save(b);
        dmg_move(b, w * ((float)(i % columns) - 0.5f * (float)(columns - 1)), -h * ((float)(i / columns) + 0.5f),
                 proud);
        draw_joined_drawer(b, 0.96f * w, 0.94f * h, deep, travel, fminf(board, 0.2f * h));
        dmg_restore(b);
    }
}
