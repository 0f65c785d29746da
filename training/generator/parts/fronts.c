/* Implements doors, flaps, drawers and buttons on a front: the parts that furniture, appliances and panels share. */
#include "parts/hardware.h"

/* Draws where modellers put a leaf's hinge line: often no hardware tells, and each has one of a few habits, all of them
 * drawn alike often. */
static void pick_line(dmg_builder* b, float* inset, float* depth) {
    float across = dmg_range(b, 0.0f, 1.0f), through = dmg_range(b, 0.0f, 1.0f);
    *inset = 0.0f;
    *depth = 0.0f;
    switch (dmg_int(b, 0, 7)) {
    case 0: /* the front edge */
        break;
    case 1: /* the body's corner, which the back edge lies on */
        *depth = 1.0f;
        break;
    case 2: /* the middle of the hung side */
        *depth = 0.5f;
        break;
    case 3: /* a pivot that the edge is rounded about */
        *inset = *depth = 0.5f;
        break;
    case 4: /* a pivot inside the slab, nearer to its back */
        *inset = 0.1f + 0.9f * across;
        *depth = 0.4f + 0.6f * through;
        break;
    case 5: /* well inside, as pins of heavy doors are */
        *inset = 1.0f + 1.5f * across;
        *depth = 0.3f + 0.5f * through;
        break;
    case 6: /* knuckles outside the edge, before or behind the slab */
        *inset = -0.35f * across;
        *depth = 1.5f * through - 0.25f;
        break;
    default:
        *inset = 1.5f * across - 0.2f;
        *depth = through;
        break;
    }
}

void dmg_leaf_pick_line(dmg_builder* b, dmg_leaf* leaf) {
    pick_line(b, &leaf->inset, &leaf->depth);
}

/* On the free edge, or as a drawer's in the middle of the leaf: the same for all fronts of a piece. */
static void pick_handle_place(dmg_builder* b, dmg_leaf* leaf) {
    leaf->handle_at = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, -0.4f, 0.4f);
    leaf->handle_edge = dmg_range(b, 0.05f, 0.15f);
    leaf->handle_across = dmg_chance(b, 0.12f);
    if (!dmg_chance(b, 0.1f)) return;
    leaf->handle_edge = 0.5f;
    leaf->handle_across = dmg_chance(b, 0.8f);
    if (leaf->handle_across && dmg_chance(b, 0.7f)) leaf->handle_at = dmg_sign(b) * 0.45f;
}

dmg_leaf dmg_leaf_pick(dmg_builder* b, float hand) {
    dmg_leaf leaf = {.thickness = 0.13f * hand};
    leaf.swing = dmg_range(b, 1.4f, 2.1f);
    dmg_leaf_pick_line(b, &leaf);
    pick_handle_place(b, &leaf);
    leaf.panel = dmg_panel_pick(b);
    leaf.handle = dmg_handle_pick(b, hand);
    leaf.hinge = dmg_hinge_pick(b, 0.06f * hand);
    return leaf;
}

/* Turns the frame so that the hung side lies towards -X; width and height follow. */
static void turn_to_side(dmg_builder* b, dmg_side side, float* width, float* height) {
    float quarter = 0.5f * DMG_PI, w = *width;
    if (side == DMG_SIDE_RIGHT) dmg_mirror(b, v3(1, 0, 0));
    if (side == DMG_SIDE_TOP) dmg_turn(b, v3(0, 0, 1), -quarter);
    if (side == DMG_SIDE_BOTTOM) dmg_turn(b, v3(0, 0, 1), quarter);
    if (side == DMG_SIDE_TOP || side == DMG_SIDE_BOTTOM) {
        *width = *height;
        *height = w;
    }
}

uint32_t dmg_leaf_draw(dmg_builder* b, uint32_t parent, const char* name, const dmg_leaf* leaf) {
    float width = leaf->width, height = leaf->height, t = leaf->thickness;
    dmg_save(b);
    turn_to_side(b, leaf->side, &width, &height);
    dmg_vec hinge = v3(-0.5f * width + leaf->inset * t, 0, -leaf->depth * t);
    /* About -Y the free edge (+X) swings out to +Z. */
    uint32_t part = dmg_hinge(b, parent, name, hinge, v3(0, -1, 0), 0.0f, leaf->swing);
    dmg_panel_draw(b, &leaf->panel, width, height, t);
    dmg_save(b);
    float edge = fmaxf(leaf->handle_edge * width, 1.2f * leaf->handle.thickness);
    bool knob = leaf->handle.kind == DMG_HANDLE_LIP;
    dmg_move(b, 0.5f * width - (knob ? 0.5f * leaf->handle.thickness : edge),
             knob ? 0.0f : leaf->handle_at * 0.8f * height, 0);
    if (leaf->handle_across && !knob) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float room = knob ? height : height * (1.0f - 1.6f * fabsf(leaf->handle_at));
    bool central = leaf->handle_edge > 0.4f;
    float beside = central ? 0.7f * width : 0.3f * fminf(width, room);
    dmg_handle_draw(b, &leaf->handle, leaf->handle_across && !knob ? beside : room);
    dmg_restore(b);
    dmg_move(b, hinge.x, 0, hinge.z);
    dmg_hinge_draw(b, &leaf->hinge, height, width, part, parent);
    dmg_restore(b);
    return part;
}

dmg_drawer dmg_drawer_pick(dmg_builder* b, float hand) {
    static const float trays[] = {1, 4, 2, 0.7f};
    dmg_drawer drawer = {.thickness = 0.13f * hand};
    drawer.tray_height = dmg_range(b, 0.4f, 0.92f);
    drawer.wall = hand * dmg_range(b, 0.03f, 0.12f);
    drawer.tray = (dmg_tray_kind)dmg_weighted(b, trays, 4);
    drawer.panel = dmg_panel_pick(b);
    drawer.handle = dmg_handle_pick(b, hand);
    drawer.handles = dmg_chance(b, 0.15f) ? 2 : 1;
    drawer.handle_at = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.1f, 0.4f);
    return drawer;
}

static void draw_wire_tray(dmg_builder* b, float width, float height, float depth, float wire) {
    float x = 0.5f * width;
    const dmg_vec rim[] = {{-x, height, 0}, {x, height, 0}, {x, height, -depth}, {-x, height, -depth}};
    const dmg_vec base[] = {{-x, 0, 0}, {x, 0, 0}, {x, 0, -depth}, {-x, 0, -depth}};
    dmg_sweep(b, rim, 4, wire, wire, true);
    dmg_sweep(b, base, 4, wire, wire, true);
    int count = 7;
    for (int i = 0; i < count; ++i) {
        float px = width * ((float)i + 0.5f) / (float)count - x;
        const dmg_vec line[] = {{px, height, 0}, {px, 0, 0}, {px, 0, -depth}, {px, height, -depth}};
        dmg_sweep(b, line, 4, 0.6f * wire, 0.6f * wire, false);
    }
}

void dmg_tray_draw(dmg_builder* b, dmg_tray_kind kind, float width, float height, float depth, float wall) {
    float x = 0.5f * width;
    dmg_vec centre = {0, 0.5f * height, -0.5f * depth}, size = {width, height, depth};
    switch (kind) {
    case DMG_TRAY_SOLID:
        dmg_box(b, centre, size);
        break;
    case DMG_TRAY_SHEET:
        dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_TOP);
        break;
    case DMG_TRAY_WIRE:
        draw_wire_tray(b, width, height, depth, 0.3f * wall);
        break;
    case DMG_TRAY_BOARDS:
        dmg_box_span(b, v3(-x, 0, -depth), v3(-x + wall, height, 0));
        dmg_box_span(b, v3(x - wall, 0, -depth), v3(x, height, 0));
        dmg_box_span(b, v3(-x + wall, 0, -depth), v3(x - wall, height, wall - depth));
        dmg_box_span(b, v3(-x + wall, 0, wall - depth), v3(x - wall, wall, 0));
        break;
    case DMG_TRAY_NONE:
        break;
    }
}

uint32_t dmg_drawer_draw(dmg_builder* b, uint32_t parent, const char* name, const dmg_drawer* drawer) {
    float width = drawer->width, height = drawer->height;
    uint32_t part = dmg_slide(b, parent, name, v3(0, 0, 1), 0.0f, drawer->travel);
    dmg_panel_draw(b, &drawer->panel, width, height, drawer->thickness);
    int handles = width > 1.2f * drawer->handle.length * (float)drawer->handles ? drawer->handles : 1;
    for (int i = 0; i < handles; ++i) {
        dmg_save(b);
        bool lip = drawer->handle.kind == DMG_HANDLE_LIP;
        float x = width * (((float)i + 0.5f) / (float)handles - 0.5f);
        dmg_move(b, x, lip ? 0.5f * height - 0.5f * drawer->handle.thickness : drawer->handle_at * height, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &drawer->handle, width / (float)handles);
        dmg_restore(b);
    }
    float tray = drawer->tray_height * height;
    dmg_save(b);
    dmg_move(b, 0, -0.48f * height, -drawer->thickness);
    dmg_tray_draw(b, drawer->tray, 0.92f * width, tray, drawer->depth - drawer->thickness, drawer->wall);
    dmg_restore(b);
    return part;
}

static void draw_button(dmg_builder* b, const dmg_buttons* s) {
    float w = s->width, h = s->height, t = s->rise, radius = 0.5f * fminf(w, h);
    if (s->kind == 0) dmg_box(b, v3(0, 0, 0.25f * t), v3(w, h, 1.5f * t));
    if (s->kind == 1) dmg_rod(b, v3(0, 0, -0.5f * t), v3(0, 0, t), radius);
    if (s->kind == 2) dmg_rounded_box(b, v3(0, 0, 0.25f * t), v3(w, h, 1.5f * t), 0.3f * fminf(radius, t));
    if (s->kind == 3) {
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_dome(b, v3(0, 0, 0), v3(0.5f * w, t, 0.5f * h));
        dmg_restore(b);
    }
}

void dmg_buttons_draw(dmg_builder* b, uint32_t parent, const dmg_buttons* buttons) {
    for (int i = 0; i < buttons->columns * buttons->rows; ++i) {
        int column = i % buttons->columns, row = i / buttons->columns;
        dmg_save(b);
        dmg_move(b, buttons->pitch_x * ((float)column - 0.5f * (float)(buttons->columns - 1)),
                 buttons->pitch_y * (0.5f * (float)(buttons->rows - 1) - (float)row), 0);
        dmg_slide(b, parent, buttons->name, v3(0, 0, -1), 0.0f, buttons->travel);
        draw_button(b, buttons);
        dmg_restore(b);
    }
    dmg_use(b, parent);
}

void dmg_sliding_draw(dmg_builder* b, const dmg_sliding* s) {
    float step = s->width / (float)s->leaves;
    for (int i = 0; i < s->leaves; ++i) {
        float x = step * ((float)i + 0.5f) - 0.5f * s->width, z = -s->thickness * (0.1f + 1.15f * (float)(i % 2));
        /* A leaf runs behind or before its neighbour, away from the case it closes against. */
        float way = i + 1 < s->leaves ? 1.0f : -1.0f;
        float travel = step * (s->leaves > 2 ? 0.95f : 0.9f);
        if (s->leaves == 1) way = dmg_sign(b);
        bool fixed = s->leaves > 1 && i > 0 && dmg_chance(b, 0.3f);
        if (fixed)
            dmg_use(b, 0);
        else
            dmg_slide(b, 0, s->name, v3(way, 0, 0), 0.0f, travel);
        dmg_save(b);
        dmg_move(b, x, 0, z);
        dmg_panel_draw(b, &s->panel, s->leaf, s->height, s->thickness);
        dmg_move(b, -way * 0.42f * s->leaf, 0, 0);
        if (!fixed) dmg_handle_draw(b, &s->handle, 0.6f * s->height);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
