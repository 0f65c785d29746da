/* Draws doors and windows of buildings, with their frames. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a wall round an opening of width x height whose sill is at y = 0, front at z = 0. */
static void draw_wall(dmg_builder* b, float width, float height, float sill, float thickness) {
    float side = width * dmg_range(b, 0.2f, 1.2f), above = height * dmg_range(b, 0.1f, 0.4f);
    float x = 0.5f * width, z = -thickness;
    dmg_box_span(b, v3(-x - side, -sill, z), v3(-x, height + above, 0));
    dmg_box_span(b, v3(x, -sill, z), v3(x + side, height + above, 0));
    dmg_box_span(b, v3(-x, height, z), v3(x, height + above, 0));
    if (sill > 0.0f) dmg_box_span(b, v3(-x, -sill, z), v3(x, 0, 0));
}

/* Draws a lever or knob pair that turns, on both faces of a leaf in use; part of the leaf or a part of its own. */
static void draw_door_furniture(dmg_builder* b, uint32_t leaf, float thickness, float towards_hinge) {
    int kind = dmg_int(b, 0, 3);
    float length = dmg_range(b, 0.09f, 0.14f), radius = dmg_range(b, 0.007f, 0.012f), out = dmg_range(b, 0.04f, 0.06f);
    if (dmg_chance(b, 0.5f)) { /* the plate stays with the leaf */
        float high = dmg_range(b, 0.05f, 0.22f);
        dmg_box(b, v3(0, 0, -0.5f * thickness), v3(0.04f, high, thickness + 0.008f));
    }
    if (kind == 3) return;
    bool turns = dmg_chance(b, 0.6f);
    /* Pressed down, the free end of the lever, which points to the hinge, goes down. */
    if (turns)
        dmg_hinge(b, leaf, kind == 1 ? "knob" : "handle", v3(0, 0, 0), v3(0, 0, towards_hinge < 0 ? 1 : -1), 0.0f,
                  dmg_range(b, 0.6f, 1.2f));
    dmg_rod(b, v3(0, 0, -thickness - out), v3(0, 0, out), radius);
    for (int s = 0; s < 2; ++s) {
        float z = s == 0 ? out : -thickness - out;
        if (kind == 1)
            dmg_ellipsoid(b, v3(0, 0, z), v3(0.028f, 0.028f, 0.02f));
        else if (kind == 0)
            dmg_box(b, v3(towards_hinge * 0.45f * length, 0, z), v3(length, 2 * radius, 1.4f * radius));
        else
            dmg_rod(b, v3(0, 0, z), v3(towards_hinge * length, dmg_range(b, -0.01f, 0.01f), z), radius);
    }
    dmg_use(b, leaf);
}

static uint32_t draw_swing_leaf(dmg_builder* b, float width, float height, float thickness, bool right) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.3f);
    leaf.width = width;
    leaf.height = height;
    leaf.thickness = thickness;
    leaf.side = right ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT;
    leaf.swing = dmg_range(b, 1.4f, 2.6f);
    if (dmg_chance(b, 0.5f)) {
        leaf.inset = dmg_chance(b, 0.8f) ? dmg_range(b, -0.5f, 0.3f) : dmg_range(b, 0.0f, 4.0f);
        leaf.depth = dmg_range(b, 0.0f, 1.0f);
    }
    leaf.hinge.radius = fminf(leaf.hinge.radius, 0.4f * thickness);
    bool furniture = dmg_chance(b, 0.7f);
    if (furniture) leaf.handle.kind = DMG_HANDLE_NONE;
    uint32_t part = dmg_leaf_draw(b, 0, "door", &leaf);
    if (furniture) {
        float side = right ? -1.0f : 1.0f;
        dmg_save(b);
        dmg_move(b, side * (0.5f * width - 0.07f), dmg_range(b, -0.1f, 0.05f) * height, 0);
        draw_door_furniture(b, part, thickness, -side);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    return part;
}

void dmg_build_door(dmg_builder* b) {
    bool twin = dmg_chance(b, 0.2f), right = dmg_chance(b, 0.5f);
    float width = dmg_range(b, 0.65f, 1.1f), height = width * dmg_range(b, 1.8f, 2.8f), t = dmg_range(b, 0.03f, 0.07f);
    float opening = twin ? 2 * width : width, frame = dmg_range(b, 0.03f, 0.12f),
          frame_depth = t * dmg_range(b, 1.0f, 4.0f), gap = dmg_range(b, 0.0f, 0.008f);
    bool framed = dmg_chance(b, 0.85f), wall = dmg_chance(b, 0.4f);
    if (framed) {
        float x = 0.5f * opening + gap, z = -frame_depth;
        dmg_box_span(b, v3(-x - frame, 0, z), v3(-x, height + gap + frame, 0));
        dmg_box_span(b, v3(x, 0, z), v3(x + frame, height + gap + frame, 0));
        dmg_box_span(b, v3(-x, height + gap, z), v3(x, height + gap + frame, 0));
        if (dmg_chance(b, 0.3f)) dmg_box_span(b, v3(-x, -0.02f, z), v3(x, 0, 0));
    }
    if (wall)
        draw_wall(b, opening + 2 * (gap + frame) * (framed ? 1.0f : 0.0f), height + (framed ? gap + frame : gap), 0,
                  fmaxf(frame_depth, 0.1f));
    if (!framed && !wall)
        dmg_box(b, v3((right ? 1.0f : -1.0f) * (0.5f * opening + 0.04f), 0.5f * height, -0.5f * t),
                v3(0.08f, height, 0.1f));
    dmg_move(b, 0, 0.5f * height, 0);
    if (!twin) {
        draw_swing_leaf(b, width, height, t, right);
        return;
    }
    dmg_move(b, -0.5f * width, 0, 0);
    draw_swing_leaf(b, width - gap, height, t, false);
    dmg_move(b, width, 0, 0);
    draw_swing_leaf(b, width - gap, height, t, true);
}

void dmg_build_sliding_window(dmg_builder* b) {
    dmg_sliding s = {.leaves = dmg_int(b, 1, 3), .name = "sash"};
    s.width = dmg_scale_range(b, 0.5f, 2.0f);
    s.height = s.width * dmg_scale_range(b, 0.5f, 1.4f);
    bool vertical = dmg_chance(b, 0.3f);
    float border = s.width * dmg_range(b, 0.02f, 0.06f);
    s.thickness = border * dmg_range(b, 0.4f, 0.9f);
    s.leaf = s.width / (float)s.leaves * dmg_range(b, 1.0f, 1.1f);
    dmg_panel panel = dmg_panel_pick_window(b);
    dmg_handle handle = dmg_handle_pick(b, 0.12f * s.height);
    float sill = dmg_chance(b, 0.5f) ? 0.9f : 0.0f, outer = s.height + 2 * border;
    dmg_move(b, 0, sill + 0.5f * outer, 0);
    if (vertical) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_frame_draw(b, s.width + 2 * border, outer, 2.4f * s.thickness, border);
    if (s.leaves == 1) { /* half the opening has a pane of its own, before which the sash runs */
        s.leaf *= 0.55f;
        dmg_save(b);
        dmg_move(b, 0.24f * s.width, 0, -1.3f * s.thickness);
        dmg_panel_draw(b, &panel, 0.52f * s.width, s.height, s.thickness);
        dmg_restore(b);
        dmg_slide(b, 0, s.name, v3(1, 0, 0), 0.0f, 0.45f * s.width);
        dmg_save(b);
        dmg_move(b, -0.24f * s.width, 0, -0.1f * s.thickness);
        dmg_panel_draw(b, &panel, s.leaf, s.height, s.thickness);
        dmg_move(b, 0.4f * s.leaf * dmg_sign(b), 0, 0);
        dmg_handle_draw(b, &handle, 0.6f * s.height);
        dmg_restore(b);
        dmg_use(b, 0);
    } else {
        s.panel = panel;
        s.handle = handle;
        dmg_sliding_draw(b, &s);
    }
    if (dmg_chance(b, 0.4f)) {
        dmg_move(b, 0, -0.5f * outer, -0.4f * s.thickness);
        draw_wall(b, s.width + 2 * border, outer, 0.9f, 3 * s.thickness);
    }
}

/* ---- window ---- */

static void draw_casement(dmg_builder* b, float width, float height, float t, dmg_side side) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
    leaf.width = width;
    leaf.height = height;
    leaf.thickness = t;
    leaf.side = side;
    leaf.swing = side == DMG_SIDE_LEFT || side == DMG_SIDE_RIGHT ? dmg_range(b, 1.3f, 2.2f) : dmg_range(b, 0.3f, 1.3f);
    leaf.panel = dmg_panel_pick_window(b);
    if (dmg_chance(b, 0.5f)) {
        leaf.inset = dmg_range(b, -0.4f, 0.4f);
        leaf.depth = dmg_range(b, 0, 1);
    }
    bool lever = dmg_chance(b, 0.5f);
    if (lever) leaf.handle.kind = DMG_HANDLE_NONE;
    uint32_t part = dmg_leaf_draw(b, 0, "window", &leaf);
    if (lever) { /* a handle of its own on the free stile */
        float x = side == DMG_SIDE_LEFT ? 0.46f * width : (side == DMG_SIDE_RIGHT ? -0.46f * width : 0.0f), r = 0.012f;
        float y = side == DMG_SIDE_TOP ? -0.46f * height : (side == DMG_SIDE_BOTTOM ? 0.46f * height : 0.0f);
        dmg_save(b);
        dmg_move(b, x, y, 0);
        dmg_hinge(b, part, "handle", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, 1.57f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 3 * r), 0.7f * r);
        dmg_beam(b, v3(0, 0.3f * r, 3 * r), v3(0, -9 * r, 3 * r), 1.4f * r, r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a pane turning about its own middle. */
static void draw_pivot_window(dmg_builder* b, float width, float height, float t) {
    bool upright = dmg_chance(b, 0.4f);
    float off = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, -0.2f, 0.2f), far = dmg_range(b, 0.5f, 1.6f);
    dmg_panel panel = dmg_panel_pick_window(b);
    dmg_vec pivot = upright ? v3(off * width, 0, -0.5f * t) : v3(0, off * height, -0.5f * t);
    dmg_hinge(b, 0, "window", pivot, upright ? v3(0, 1, 0) : v3(1, 0, 0), -far, far);
    dmg_panel_draw(b, &panel, width, height, t);
    dmg_use(b, 0);
}

void dmg_build_window(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.4f, 1.8f), height = width * dmg_range(b, 0.6f, 1.6f),
          t = dmg_range(b, 0.025f, 0.06f), frame = dmg_range(b, 0.03f, 0.09f), sill = dmg_chance(b, 0.5f) ? 0.9f : 0.0f;
    int leaves = width > 0.8f ? dmg_int(b, 1, 3) : 1, rows = height > 1.0f && dmg_chance(b, 0.3f) ? 2 : 1;
    dmg_move(b, 0, sill + 0.5f * height + frame, 0);
    dmg_frame_draw(b, width + 2 * frame, height + 2 * frame, t * dmg_range(b, 1.0f, 2.5f), frame);
    if (dmg_chance(b, 0.4f)) {
        dmg_save(b);
        dmg_move(b, 0, -0.5f * height - frame, -0.01f);
        draw_wall(b, width + 2 * frame, height + 2 * frame, 0.8f, 2.5f * t);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, -0.5f * height - frame, 0.05f), v3(width + 3 * frame, 0.03f, 0.15f));
    if (leaves == 1 && rows == 1 && dmg_chance(b, 0.15f)) {
        draw_pivot_window(b, width, height, t);
        return;
    }
    bool shutters = dmg_chance(b, 0.15f);
    for (int i = 0; i < leaves * rows; ++i) {
        static const float sides[] = {4, 4, 1.5f, 1};
        float w = width / (float)leaves, h = height / (float)rows;
        dmg_side side = (dmg_side)dmg_weighted(b, sides, 4);
        if (leaves == 2 && rows == 1) side = i == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_save(b);
        dmg_move(b, w * ((float)(i % leaves) + 0.5f) - 0.5f * width, h * ((float)(i / leaves) + 0.5f) - 0.5f * height,
                 0);
        draw_casement(b, 0.985f * w, 0.985f * h, t, side);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1 && shutters; s += 2) { /* outside, shown open beside the window */
        dmg_save(b);
        dmg_move(b, (float)s * 0.25f * width, 0, 1.3f * t);
        dmg_leaf leaf = dmg_leaf_pick(b, 0.12f);
        leaf.panel.kind = DMG_PANEL_LOUVRES;
        leaf.panel.border = 0.12f;
        leaf.width = 0.5f * width;
        leaf.height = height;
        leaf.thickness = 0.8f * t;
        leaf.swing = 3.0f;
        leaf.side = s < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_rest(b, dmg_leaf_draw(b, 0, "shutter", &leaf), 2.9f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* ---- gate ---- */

static void draw_fence(dmg_builder* b, float from, float to, float height, float t) {
    int bars = (int)((to - from) / (4 * t));
    for (int i = 0; i <= bars && bars < 40; ++i)
        dmg_box(b, v3(from + (to - from) * (float)i / (float)(bars > 0 ? bars : 1), 0.5f * height, 0),
                v3(t, height, t));
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0.5f * (from + to), height * (0.2f + 0.6f * (float)i), 0), v3(to - from, t, 0.7f * t));
}

/* Bars, planks or a farm gate with a brace, centred at the origin. */
static void draw_gate_leaf(dmg_builder* b, int kind, float width, float height, float t) {
    dmg_panel bars = {.kind = DMG_PANEL_BARS, .border = 0.06f, .bars_x = 6, .bars_y = 1};
    dmg_panel planks = {.kind = DMG_PANEL_PLANKS, .bars_x = 4};
    if (kind == 0) dmg_panel_draw(b, &bars, width, height, t);
    if (kind == 1) dmg_panel_draw(b, &planks, width, height, t);
    if (kind == 2) { /* rails and a brace */
        for (int i = 0; i < 4; ++i)
            dmg_box(b, v3(0, height * ((float)i / 3.0f - 0.5f), -0.5f * t), v3(width, 1.2f * t, t));
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 0.5f * (width - t), 0, -0.5f * t), v3(t, height, t));
        dmg_beam(b, v3(-0.48f * width, -0.5f * height, 0), v3(0.48f * width, 0.5f * height, 0), t, t);
    }
    if (kind == 3) dmg_box(b, v3(0, 0, -0.5f * t), v3(width, height, 0.5f * t));
}

void dmg_build_gate(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.8f, 4.0f), height = dmg_range(b, 0.8f, 2.0f), t = dmg_range(b, 0.03f, 0.08f),
          post = t * dmg_range(b, 1.5f, 5.0f), gap = dmg_range(b, 0.01f, 0.06f);
    int kind = dmg_int(b, 0, 3), way = dmg_int(b, 0, 3); /* one leaf, two, sliding, a leaf on the far post */
    float x = 0.5f * width + gap + 0.5f * post, top = height * dmg_range(b, 1.0f, 1.3f);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * x, 0.5f * top, -0.5f * t), v3(post, top, post));
    if (dmg_chance(b, 0.5f)) {
        draw_fence(b, x + 0.5f * post, x + 0.5f * post + width, height, 0.6f * t);
        draw_fence(b, -x - 0.5f * post - width, -x - 0.5f * post, height, 0.6f * t);
    }
    dmg_move(b, 0, 0.5f * height + 0.06f, 0);
    if (way == 2) {
        float side = dmg_sign(b);
        dmg_slide(b, 0, "gate", v3(side, 0, 0), 0.0f, 0.95f * width);
        dmg_move(b, 0, 0, t + 0.5f * post);
        draw_gate_leaf(b, kind, width + post, height, t);
        dmg_use(b, 0);
        dmg_box(b, v3(side * 0.5f * width, -0.5f * height - 0.03f, -0.5f * t), v3(2.2f * width, 0.05f, t));
        return;
    }
    int leaves = way == 1 ? 2 : 1;
    for (int i = 0; i < leaves; ++i) {
        float side = way == 3 || i == 1 ? 1.0f : -1.0f, w = width / (float)leaves;
        float hung = 0.5f * width + gap * dmg_range(b, 0, 1), far = dmg_range(b, 1.3f, 2.2f);
        dmg_save(b);
        bool both_ways = dmg_chance(b, 0.2f);
        dmg_hinge(b, 0, "gate", v3(side * hung, 0, -t * dmg_range(b, 0, 1)), v3(0, side, 0), both_ways ? -far : 0.0f,
                  far);
        if (leaves == 2) dmg_move(b, side * 0.25f * width, 0, 0);
        draw_gate_leaf(b, kind, 0.98f * w, height, t);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* ---- sliding door ---- */

void dmg_build_sliding_door(dmg_builder* b) {
    float width = dmg_range(b, 0.8f, 2.4f), height = dmg_range(b, 1.9f, 2.5f), t = dmg_range(b, 0.03f, 0.06f),
          deep = dmg_range(b, 0.1f, 0.25f);
    int kind = dmg_int(b, 0, 2); /* in a frame, before a wall on a rail, two halves into the walls */
    dmg_sliding s = {
        .name = "door", .leaves = dmg_int(b, 2, 4), .width = width * 1.6f, .height = height, .thickness = t};
    s.panel = dmg_chance(b, 0.6f) ? dmg_panel_pick_window(b) : dmg_panel_pick(b);
    s.handle = dmg_handle_pick(b, 0.3f);
    s.leaf = 1.05f * s.width / (float)s.leaves;
    if (kind == 0) {
        dmg_move(b, 0, 0.5f * height + 0.06f, 0);
        dmg_frame_draw(b, s.width + 0.12f, height + 0.12f, 2.5f * t, 0.06f);
        dmg_sliding_draw(b, &s);
        return;
    }
    draw_wall(b, width, height, 0, deep);
    dmg_move(b, 0, 0.5f * height, kind == 1 ? 1.3f * t : -0.5f * deep + 0.5f * t);
    if (kind == 1) { /* the rail over the wall, rollers on it */
        dmg_box(b, v3(0.4f * width, 0.53f * height, -0.5f * t), v3(2.1f * width, 0.03f * height, 0.6f * t));
    }
    int leaves = kind == 1 ? 1 : 2;
    for (int i = 0; i < leaves; ++i) {
        float side = leaves == 1 || i == 1 ? 1.0f : -1.0f, w = (leaves == 1 ? 1.1f : 0.5f) * width;
        dmg_slide(b, 0, "door", v3(side, 0, 0), 0.0f, 0.9f * w);
        dmg_save(b);
        dmg_move(b, leaves == 1 ? 0.0f : side * 0.25f * width, 0, 0);
        dmg_panel_draw(b, &s.panel, w, 0.995f * height, t);
        if (kind == 1) {
            for (int k = -1; k <= 1; k += 2)
                dmg_box(b, v3((float)k * 0.35f * w, 0.52f * height, 0.2f * t), v3(0.05f, 0.07f * height, 0.3f * t));
        }
        dmg_move(b, -side * 0.42f * w, 0, 0);
        dmg_handle_draw(b, &s.handle, 0.4f * height);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- trapdoor ---- */

void dmg_build_trapdoor(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 1.4f), depth = width * dmg_range(b, 0.6f, 1.4f), t = dmg_range(b, 0.02f, 0.08f),
          floor = width * dmg_range(b, 0.2f, 1.5f), thick = dmg_range(b, 0.05f, 0.3f);
    bool tilted = dmg_chance(b, 0.2f), twin = dmg_chance(b, 0.3f);
    dmg_move(b, 0, thick, 0);
    if (tilted) dmg_turn(b, v3(1, 0, 0), dmg_range(b, 0.2f, 0.9f)); /* a cellar hatch */
    dmg_save(b);
    dmg_face_up(b);
    dmg_frame_draw(b, width + 2 * floor, depth + 2 * floor, thick, floor);
    if (dmg_chance(b, 0.4f)) dmg_frame_draw(b, width + 0.1f, depth + 0.1f, 0.03f, 0.05f);
    float proud = dmg_chance(b, 0.5f) ? t : 0.0f;
    dmg_move(b, 0, 0, proud);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.2f);
    leaf.thickness = t;
    leaf.height = depth * 0.99f;
    leaf.width = (twin ? 0.5f : 1.0f) * width * 0.99f;
    leaf.swing = dmg_range(b, 1.3f, 3.0f);
    leaf.panel = dmg_panel_pick(b);
    if (dmg_chance(b, 0.4f)) leaf.handle = (dmg_handle){DMG_HANDLE_RING, 0.15f, 0.02f, 0.02f, 0.8f};
    leaf.depth = dmg_range(b, 0, 0.6f);
    for (int i = 0; i < (twin ? 2 : 1); ++i) {
        dmg_save(b);
        if (twin) dmg_move(b, ((float)i - 0.5f) * 0.5f * width, 0, 0);
        leaf.side = twin ? (i == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT) : (dmg_side)dmg_int(b, 0, 3);
        dmg_leaf_draw(b, 0, "hatch", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* ---- barrier ---- */

void dmg_build_barrier(dmg_builder* b) {
    float length = dmg_range(b, 1.5f, 6.0f), height = dmg_range(b, 0.8f, 1.2f),
          side = height * dmg_range(b, 0.2f, 0.45f), r = dmg_range(b, 0.03f, 0.06f), y = 0.85f * height;
    dmg_box(b, v3(0, 0.5f * height, 0), v3(side, height, side));
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, 0.03f, 0), v3(1.5f * side, 0.06f, 1.5f * side));
    bool front = dmg_chance(b, 0.6f);
    float z = front ? 0.5f * side + r : 0.0f, tail = dmg_chance(b, 0.5f) ? dmg_range(b, 0.3f, 0.8f) : 0.0f,
          far = dmg_range(b, 1.2f, 1.57f);
    if (front) dmg_rod(b, v3(0, y, 0.4f * side), v3(0, y, z + r), 0.06f);
    uint32_t boom = dmg_hinge(b, 0, "boom", v3(0, y, z), v3(0, 0, 1), 0.0f, far);
    if (dmg_chance(b, 0.5f))
        dmg_cone(b, v3(-tail, y, z), v3(length, y, z), 1.2f * r, 0.6f * r);
    else
        dmg_beam(b, v3(-tail, y, z), v3(length, y, z), r, 2 * r);
    if (tail > 0.0f) dmg_box(b, v3(-tail, y, z), v3(0.25f, 0.2f, 2.4f * r));
    if (dmg_chance(b, 0.3f)) { /* a skirt of rods */
        for (int i = 1; i < 8; ++i)
            dmg_rod(b, v3(length * (float)i / 8.0f, y, z), v3(length * (float)i / 8.0f, 0.35f * y, z), 0.2f * r);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* the fork it lies in */
        dmg_box(b, v3(0.96f * length, 0.5f * (y - r), z), v3(0.08f, y - 2 * r, 0.08f));
    }
    if (dmg_chance(b, 0.25f)) dmg_rest(b, boom, far);
}

/* ---- a door between two posts ---- */

/* Draws two posts and what joins them, round an opening of width x height on y = 0; the middle of the thickness is z =
 * 0. */
static void draw_posts(dmg_builder* b, float width, float height, float post, float thick, bool round) {
    bool lintel = dmg_chance(b, 0.6f), sill = dmg_chance(b, 0.3f);
    float x = 0.5f * (width + post), top = height + (lintel ? 0.0f : dmg_range(b, 0.0f, 0.1f) * height);
    for (int s = -1; s <= 1; s += 2) {
        if (round)
            dmg_rod(b, v3((float)s * x, 0, 0), v3((float)s * x, top, 0), 0.5f * post);
        else
            dmg_box(b, v3((float)s * x, 0.5f * top, 0), v3(post, top, thick));
    }
    float over = width + 2 * post;
    if (lintel) dmg_box(b, v3(0, height + 0.51f * post, 0), v3(over, post, thick));
    if (sill) dmg_box(b, v3(0, -0.51f * post, 0), v3(over, post, thick));
}

/* From the leaf's hung edge at x = 0 (the leaf towards +X, middle at z = 0) to its line. */
static dmg_xy pick_post_line(dmg_builder* b, float width, float gap, float post, float t) {
    static const float habits[] = {3, 1.5f, 1.5f, 2, 1.5f};
    float share = dmg_range(b, 0.0f, 1.0f);
    switch (dmg_weighted(b, habits, 5)) {
    case 0: /* the post's own middle */
        return (dmg_xy){-gap - 0.5f * post, 0};
    case 1: /* between leaf and post, before them */
        return (dmg_xy){-share * gap, (0.5f + 0.4f * share) * t};
    case 2: /* the middle of the leaf's edge */
        return (dmg_xy){0, 0};
    case 3: /* a pin in floor and lintel */
        return (dmg_xy){(0.02f + 0.08f * share) * width, 0};
    default: /* the leaf's front edge */
        return (dmg_xy){0, 0.5f * t};
    }
}

/* Draws the leaf: a slab, perhaps with round stiles, its hung edge at x = 0. */
static void draw_post_leaf(dmg_builder* b, float width, float height, float t) {
    bool stiles = dmg_chance(b, 0.25f);
    float bar = stiles ? t * dmg_range(b, 0.8f, 1.6f) : 0.0f;
    dmg_save(b);
    dmg_move(b, 0.5f * width, 0.5f * height, 0.5f * t);
    if (stiles || dmg_chance(b, 0.6f)) {
        dmg_box(b, v3(0, 0, -0.5f * t), v3(width - bar, height, t));
    } else {
        dmg_panel panel = dmg_panel_pick(b);
        dmg_panel_draw(b, &panel, width, height, t);
    }
    for (int s = -1; s <= 1 && stiles; s += 2) {
        float x = (float)s * 0.5f * (width - bar);
        dmg_rod(b, v3(x, -0.5f * height, -0.5f * t), v3(x, 0.5f * height, -0.5f * t), 0.5f * bar);
    }
    dmg_restore(b);
}

void dmg_build_post_door(dmg_builder* b) {
    float height = dmg_range(b, 0.5f, 2.3f), width = height * dmg_scale_range(b, 0.3f, 1.2f),
          t = width * dmg_scale_range(b, 0.02f, 0.2f);
    float post = width * dmg_scale_range(b, 0.04f, 0.16f), thick = fmaxf(post, t) * dmg_range(b, 0.8f, 1.5f),
          gap = dmg_chance(b, 0.4f) ? 0.001f : width * dmg_range(b, 0.0f, 0.06f);
    bool round = dmg_chance(b, 0.3f), both_ways = dmg_chance(b, 0.3f);
    if (round) t = fminf(t, post);
    draw_posts(b, width + 2 * gap, height * 1.01f, post, round ? post : thick, round);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    dmg_move(b, -0.5f * width, 0.005f * height, 0);
    dmg_xy line = pick_post_line(b, width, gap, post, t);
    float far = dmg_range(b, 1.0f, 2.0f);
    uint32_t part = dmg_hinge(b, 0, "door", v3(line.x, 0, line.y), v3(0, -1, 0), both_ways ? -far : 0.0f, far);
    draw_post_leaf(b, width, 0.99f * height, t);
    dmg_move(b, 0.9f * width, dmg_range(b, 0.4f, 0.55f) * height, 0.5f * t);
    float small = fminf(width, 0.6f * height) / 0.9f;
    dmg_grow(b, small);
    if (dmg_chance(b, 0.7f)) draw_door_furniture(b, part, t / small, -1.0f);
    dmg_use(b, 0);
}
