/* Doors and windows of buildings, with their frames. */
#include "categories.h"
#include "hardware.h"

/* A wall round an opening of width x height whose sill is at y = 0, front at z = 0. */
static void draw_wall(dmg_builder* b, float width, float height, float sill, float thickness) {
    float side = width * dmg_range(b, 0.2f, 1.2f), above = height * dmg_range(b, 0.1f, 0.4f);
    float x = 0.5f * width, z = -thickness;
    dmg_box_span(b, v3(-x - side, -sill, z), v3(-x, height + above, 0));
    dmg_box_span(b, v3(x, -sill, z), v3(x + side, height + above, 0));
    dmg_box_span(b, v3(-x, height, z), v3(x, height + above, 0));
    if (sill > 0.0f) dmg_box_span(b, v3(-x, -sill, z), v3(x, 0, 0));
}

/* A lever or knob pair that turns, on both faces of a leaf in use; part of the leaf or a part of its own. */
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
    leaf.inset = dmg_chance(b, 0.8f) ? dmg_range(b, -0.5f, 0.3f) : dmg_range(b, 0.0f, 4.0f);
    leaf.depth = dmg_range(b, 0.0f, 1.0f);
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

/* Rails and a case for leaves that slide side by side; leaves lie on tracks behind each other. */
typedef struct sliding {
    int leaves;
    float width, height, leaf, thickness, border;
    bool vertical;
    const char* name;
} sliding;

static void draw_sliding_leaves(dmg_builder* b, const sliding* s, const dmg_panel* panel, const dmg_handle* handle) {
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
        dmg_panel_draw(b, panel, s->leaf, s->height, s->thickness);
        dmg_move(b, -way * 0.42f * s->leaf, 0, 0);
        if (!fixed) dmg_handle_draw(b, handle, 0.6f * s->height);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_sliding_window(dmg_builder* b) {
    sliding s = {.leaves = dmg_int(b, 1, 3), .name = "sash"};
    s.width = dmg_scale_range(b, 0.5f, 2.0f);
    s.height = s.width * dmg_scale_range(b, 0.5f, 1.4f);
    s.vertical = dmg_chance(b, 0.3f);
    s.border = s.width * dmg_range(b, 0.02f, 0.06f);
    s.thickness = s.border * dmg_range(b, 0.4f, 0.9f);
    s.leaf = s.width / (float)s.leaves * dmg_range(b, 1.0f, 1.1f);
    dmg_panel panel = dmg_panel_pick_window(b);
    dmg_handle handle = dmg_handle_pick(b, 0.12f * s.height);
    float sill = dmg_chance(b, 0.5f) ? 0.9f : 0.0f, outer = s.height + 2 * s.border;
    dmg_move(b, 0, sill + 0.5f * outer, 0);
    if (s.vertical) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_frame_draw(b, s.width + 2 * s.border, outer, 2.4f * s.thickness, s.border);
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
        draw_sliding_leaves(b, &s, &panel, &handle);
    }
    if (dmg_chance(b, 0.4f)) {
        dmg_move(b, 0, -0.5f * outer, -0.4f * s.thickness);
        draw_wall(b, s.width + 2 * s.border, outer, 0.9f, 3 * s.thickness);
    }
}
