/* Implements panels, frames and cases: the flat parts of doors, drawers and housings. */
#include "parts/hardware.h"

dmg_panel dmg_panel_pick(dmg_builder* b) {
    static const float weights[DMG_PANEL_KINDS] = {7, 0.7f, 1, 0.8f, 2, 1, 0.8f, 0.3f, 0.3f, 0.4f, 0.4f, 0.5f};
    dmg_panel panel = {.kind = (dmg_panel_kind)dmg_weighted(b, weights, DMG_PANEL_KINDS)};
    panel.border = dmg_range(b, 0.06f, 0.2f);
    panel.infill = dmg_range(b, 0.15f, 0.7f);
    panel.bars_x = dmg_int(b, 1, 5);
    panel.bars_y = dmg_int(b, 0, 4);
    return panel;
}

dmg_panel dmg_panel_pick_window(dmg_builder* b) {
    dmg_panel panel = dmg_panel_pick(b);
    panel.kind = dmg_chance(b, 0.15f) ? DMG_PANEL_HOLLOW : DMG_PANEL_WINDOW;
    panel.border = dmg_range(b, 0.04f, 0.15f);
    panel.bars_x = dmg_chance(b, 0.3f) ? dmg_int(b, 1, 2) : 0;
    panel.bars_y = dmg_chance(b, 0.3f) ? dmg_int(b, 1, 3) : 0;
    return panel;
}

void dmg_frame_draw(dmg_builder* b, float width, float height, float thickness, float border) {
    float x = 0.5f * width, y = 0.5f * height;
    dmg_box_span(b, v3(-x, -y, -thickness), v3(-x + border, y, 0));
    dmg_box_span(b, v3(x - border, -y, -thickness), v3(x, y, 0));
    dmg_box_span(b, v3(-x + border, -y, -thickness), v3(x - border, -y + border, 0));
    dmg_box_span(b, v3(-x + border, y - border, -thickness), v3(x - border, y, 0));
}

void dmg_holed_plate_draw(dmg_builder* b, float width, float height, float thickness, float radius) {
    enum { POINTS = 24 };
    dmg_xy outer[POINTS], inner[POINTS];
    for (int i = 0; i < POINTS; ++i) { /* the corners lie at 45 degrees before stretching */
        float angle = 2.0f * DMG_PI * (float)i / POINTS, c = cosf(angle), s = sinf(angle);
        float square = 0.5f / fmaxf(fabsf(c), fabsf(s));
        outer[i] = (dmg_xy){width * c * square, height * s * square};
        inner[i] = (dmg_xy){radius * c, radius * s};
    }
    dmg_ring_plate(b, outer, inner, POINTS, -thickness, 0);
}

/* Frame, and what fills it. */
static void draw_framed(dmg_builder* b, const dmg_panel* panel, float width, float height, float thickness) {
    float border = panel->border * fminf(width, height), inner_w = width - 2 * border, inner_h = height - 2 * border;
    float infill = (panel->kind == DMG_PANEL_WINDOW ? 0.3f : 1.0f) * panel->infill * thickness;
    dmg_frame_draw(b, width, height, thickness, border);
    if (panel->kind == DMG_PANEL_FRAMED || panel->kind == DMG_PANEL_WINDOW) {
        dmg_box(b, v3(0, 0, -0.5f * thickness), v3(inner_w, inner_h, infill));
    }
    if (panel->kind == DMG_PANEL_LOUVRES) {
        int slats = 4 + 3 * panel->bars_x;
        for (int i = 0; i < slats; ++i) {
            float y = inner_h * (((float)i + 0.5f) / (float)slats - 0.5f);
            dmg_save(b);
            dmg_move(b, 0, y, -0.5f * thickness);
            dmg_turn(b, v3(1, 0, 0), 0.6f);
            dmg_box(b, v3(0, 0, 0), v3(inner_w, 0.15f * thickness, 1.1f * thickness));
            dmg_restore(b);
        }
        return;
    }
    for (int i = 1; i <= panel->bars_x; ++i) {
        if (panel->kind == DMG_PANEL_FRAMED) break;
        float x = inner_w * ((float)i / (float)(panel->bars_x + 1) - 0.5f);
        dmg_box(b, v3(x, 0, -0.5f * thickness), v3(0.3f * border, inner_h, 0.6f * thickness));
    }
    for (int i = 1; i <= panel->bars_y; ++i) {
        if (panel->kind == DMG_PANEL_FRAMED) break;
        float y = inner_h * ((float)i / (float)(panel->bars_y + 1) - 0.5f);
        dmg_box(b, v3(0, y, -0.5f * thickness), v3(inner_w, 0.3f * border, 0.5f * thickness));
    }
}

static void draw_planks(dmg_builder* b, const dmg_panel* panel, float width, float height, float thickness) {
    int planks = 3 + panel->bars_x;
    float w = width / (float)planks;
    for (int i = 0; i < planks; ++i) {
        dmg_box(b, v3(w * ((float)i + 0.5f) - 0.5f * width, 0, -0.6f * thickness),
                v3(0.96f * w, height, 0.8f * thickness));
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3(0, (float)s * 0.33f * height, -0.1f * thickness),
                v3(0.94f * width, 0.1f * height, 0.2f * thickness));
    }
}

static void draw_bowed(dmg_builder* b, const dmg_panel* panel, float width, float height, float thickness) {
    enum { POINTS = 9 };
    dmg_xy line[POINTS];
    float bow = panel->border * width;
    for (int i = 0; i < POINTS; ++i) {
        float s = (float)i / (POINTS - 1) - 0.5f;
        line[i] = (dmg_xy){s * width, -0.5f * thickness + bow * (1.0f - 4.0f * s * s)};
    }
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the line's y becomes z */
    dmg_bent_plate(b, line, POINTS, thickness, height);
    dmg_restore(b);
}

void dmg_panel_draw(dmg_builder* b, const dmg_panel* panel, float width, float height, float thickness) {
    float small = fminf(width, height), border = panel->border * small;
    dmg_vec centre = {0, 0, -0.5f * thickness}, size = {width, height, thickness};
    switch (panel->kind) {
    case DMG_PANEL_FLAT:
    case DMG_PANEL_KINDS:
        dmg_box(b, centre, size);
        break;
    case DMG_PANEL_ROUNDED:
        dmg_rounded_plate(b, width, height, thickness, border);
        break;
    case DMG_PANEL_SOFT:
        dmg_rounded_box(b, centre, size, 0.4f * fminf(thickness, small));
        break;
    case DMG_PANEL_SHEET:
        dmg_box_faces(b, centre, size, DMG_FACE_FRONT);
        break;
    case DMG_PANEL_RAISED:
        dmg_box(b, v3(0, 0, -0.6f * thickness), v3(width, height, 0.8f * thickness));
        dmg_box(b, v3(0, 0, -0.1f * thickness), v3(width - 2 * border, height - 2 * border, 0.2f * thickness));
        break;
    case DMG_PANEL_FRAMED:
    case DMG_PANEL_WINDOW:
    case DMG_PANEL_HOLLOW:
    case DMG_PANEL_BARS:
    case DMG_PANEL_LOUVRES:
        draw_framed(b, panel, width, height, thickness);
        break;
    case DMG_PANEL_PLANKS:
        draw_planks(b, panel, width, height, thickness);
        break;
    case DMG_PANEL_BOWED:
        draw_bowed(b, panel, width, height, thickness);
        break;
    }
}

dmg_case_kind dmg_case_pick(dmg_builder* b) {
    static const float tidy[DMG_CASE_KINDS] = {7, 0.5f, 2, 0.5f}, messy[DMG_CASE_KINDS] = {4, 2, 2, 2.5f};
    return (dmg_case_kind)dmg_weighted(b, b->messy ? messy : tidy, DMG_CASE_KINDS);
}

static void draw_double_case(dmg_builder* b, float width, float height, float depth, float wall) {
    float x = 0.5f * width, y = 0.5f * height, xi = x - wall, yi = y - wall;
    const dmg_xy outer[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, inner[] = {{-xi, -yi}, {xi, -yi}, {xi, yi}, {-xi, yi}};
    dmg_ring_plate(b, outer, inner, 4, -depth, 0);
    dmg_box_faces(b, v3(0, 0, -depth), v3(width, height, 0), DMG_FACE_BACK);
    dmg_box_faces(b, v3(0, 0, wall - depth), v3(2 * xi, 2 * yi, 0), DMG_FACE_FRONT);
}

void dmg_case_draw(dmg_builder* b, dmg_case_kind kind, float width, float height, float depth, float wall) {
    float x = 0.5f * width, y = 0.5f * height;
    dmg_vec centre = {0, 0, -0.5f * depth}, size = {width, height, depth};
    switch (kind) {
    case DMG_CASE_SOLID:
    case DMG_CASE_KINDS:
        dmg_box(b, centre, size);
        break;
    case DMG_CASE_SHEET:
        dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_FRONT);
        break;
    case DMG_CASE_DOUBLE:
        draw_double_case(b, width, height, depth, wall);
        break;
    case DMG_CASE_BOARDS:
        dmg_box_span(b, v3(-x, -y, -depth), v3(-x + wall, y, 0));
        dmg_box_span(b, v3(x - wall, -y, -depth), v3(x, y, 0));
        dmg_box_span(b, v3(-x + wall, -y, -depth), v3(x - wall, -y + wall, 0));
        dmg_box_span(b, v3(-x + wall, y - wall, -depth), v3(x - wall, y, 0));
        dmg_box_span(b, v3(-x + wall, -y + wall, -depth), v3(x - wall, y - wall, 0.4f * wall - depth));
        break;
    }
}

void dmg_face_up(dmg_builder* b) {
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
}

void dmg_feet_draw(dmg_builder* b, int kind, float width, float depth, float height) {
    float foot = 0.06f * fminf(width, depth), x = 0.5f * width - foot, z = 0.5f * depth - foot;
    if (kind == 1)
        dmg_box(b, v3(0, 0.5f * height, -0.04f * depth), v3(0.98f * width, height, 0.9f * depth)); /* plinth */
    if (kind == 2) {                                                                               /* runners */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * x, 0.5f * height, 0), v3(foot, height, 0.96f * depth));
    }
    for (int i = 0; i < 4 && (kind == 0 || kind == 3); ++i) {
        float px = i & 1 ? x : -x, pz = i & 2 ? z : -z;
        if (kind == 0) dmg_box(b, v3(px, 0.5f * height, pz), v3(foot, height, foot));
        if (kind == 3) dmg_cone(b, v3(px, 0, pz), v3(px, height, pz), 0.35f * foot, 0.6f * foot);
    }
}
