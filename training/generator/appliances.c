/* Machines of kitchen, bath and office: a housing with doors, knobs, buttons and trays. */
#include "categories.h"
#include "hardware.h"

/* A door that is thicker than furniture's, with a bar or nothing to pull it. */
static dmg_leaf appliance_leaf(dmg_builder* b, float width, float height, float thickness) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.25f * fmaxf(width, height));
    leaf.width = width;
    leaf.height = height;
    leaf.thickness = thickness;
    leaf.handle = dmg_handle_pick_bar(b, 0.5f * fmaxf(width, height));
    leaf.handle.thickness = fminf(leaf.handle.thickness, 0.08f * fminf(width, height));
    leaf.handle.standoff = fminf(leaf.handle.standoff, 0.15f * fminf(width, height));
    leaf.handle_at = 0.0f;
    if (dmg_chance(b, 0.5f)) leaf.panel = dmg_panel_pick_window(b);
    leaf.inset = dmg_chance(b, 0.7f) ? 0.0f : dmg_range(b, 0, 1.0f);
    return leaf;
}

/* Knobs in a row or column, each a part, on z = 0 facing +Z. */
static void draw_knobs(dmg_builder* b, int count, float pitch_x, float pitch_y, float radius) {
    int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    float height = radius * dmg_range(b, 0.5f, 1.4f);
    bool endless = dmg_chance(b, 0.4f);
    float upper = dmg_range(b, 1.5f, 5.0f);
    for (int i = 0; i < count; ++i) {
        float at = (float)i - 0.5f * (float)(count - 1);
        dmg_save(b);
        dmg_move(b, at * pitch_x, at * pitch_y, 0);
        /* Clockwise is on. */
        if (endless)
            dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1));
        else
            dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
        dmg_knob_draw(b, kind, radius, height);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Buttons, knobs or both on a panel of the given size, centred at the origin of z = 0. */
static void draw_controls(dmg_builder* b, float width, float height) {
    bool tall = height > width;
    float small = fminf(width, height), large = fmaxf(width, height);
    bool knobs = dmg_chance(b, 0.6f);
    float knob_room = knobs ? large * dmg_range(b, 0.3f, 0.6f) : 0.0f, button_room = large - knob_room;
    if (knobs) {
        float radius = small * dmg_range(b, 0.2f, 0.38f);
        int count = dmg_int(b, 1, (int)fminf(5.0f, fmaxf(1.0f, knob_room / (2.4f * radius))));
        float pitch = knob_room / (float)count, at = 0.5f * large - 0.5f * knob_room;
        dmg_save(b);
        dmg_move(b, tall ? 0 : at, tall ? at : 0, 0);
        draw_knobs(b, count, tall ? 0 : pitch, tall ? pitch : 0, fminf(radius, 0.45f * pitch));
        dmg_restore(b);
    }
    if (!knobs || dmg_chance(b, 0.6f)) {
        int columns = dmg_int(b, 1, tall ? 3 : 6), rows = dmg_int(b, 1, tall ? 5 : 2);
        float px = 0.9f * (tall ? width : button_room) / (float)columns,
              py = 0.9f * (tall ? button_room : height) / (float)rows;
        float fill = dmg_range(b, 0.4f, 0.85f), w = px * fill, h = py * fill;
        if (dmg_chance(b, 0.4f)) w = h = fminf(w, h);
        float rise = fminf(w, h) * dmg_range(b, 0.1f, 0.5f);
        dmg_buttons set = {"button", columns, rows, px, py, w, h, rise, 0.7f * rise, dmg_int(b, 0, 3)};
        dmg_save(b);
        dmg_move(b, tall ? 0 : -0.5f * knob_room, tall ? -0.5f * knob_room : 0, 0);
        dmg_buttons_draw(b, 0, &set);
        dmg_restore(b);
    }
}

/* A turntable plate on the floor of a cavity, y = 0. */
static void draw_turntable(dmg_builder* b, float radius) {
    uint32_t plate = dmg_spin(b, 0, "turntable", v3(0, 0, 0), v3(0, 1, 0));
    dmg_keep_rest(b, plate);
    const dmg_xy profile[] = {{0, 0.02f * radius},
                              {0.9f * radius, 0.02f * radius},
                              {radius, 0.1f * radius},
                              {radius, 0.13f * radius},
                              {0, 0.06f * radius}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 5);
    dmg_use(b, 0);
}

void dmg_build_microwave(dmg_builder* b) {
    float width = dmg_range(b, 0.4f, 0.65f), height = dmg_range(b, 0.24f, 0.4f), depth = dmg_range(b, 0.28f, 0.5f);
    float wall = dmg_range(b, 0.012f, 0.03f), foot = dmg_range(b, 0.0f, 0.02f), t = dmg_range(b, 0.015f, 0.04f);
    float panel = width * dmg_range(b, 0.16f, 0.3f), cavity = width - panel;
    bool controls_below = dmg_chance(b, 0.12f), flap = controls_below || dmg_chance(b, 0.1f);
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_chance(b, 0.5f) ? 3 : 4, width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    float x = -0.5f * panel, y = 0.0f, w = cavity, h = height, control_w = panel, control_h = height;
    if (controls_below) {
        x = 0.0f;
        w = control_w = width;
        control_h = panel * 0.5f;
        h = height - control_h;
        y = 0.5f * control_h;
    }
    dmg_save(b);
    dmg_move(b, x, y, 0);
    dmg_case_draw(b, shell, w, h, depth, wall);
    float fill_x = dmg_range(b, 0.92f, 1.0f), fill_y = dmg_range(b, 0.9f, 1.0f);
    dmg_leaf leaf = appliance_leaf(b, w * fill_x, h * fill_y, t);
    leaf.side = flap ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT;
    leaf.swing = dmg_range(b, 1.4f, 1.9f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_move(b, 0, -0.5f * h + wall, -0.5f * depth);
    if (shell != DMG_CASE_SOLID && dmg_chance(b, 0.5f)) draw_turntable(b, 0.4f * fminf(w, depth));
    dmg_restore(b);
    float proud = dmg_chance(b, 0.5f) ? t : 0.0f;
    dmg_move(b, controls_below ? 0 : 0.5f * cavity, controls_below ? -0.5f * h : 0, proud);
    dmg_box(b, v3(0, 0, -0.5f * (depth + proud)), v3(control_w, control_h, depth + proud));
    draw_controls(b, 0.85f * control_w, 0.85f * control_h);
}

/* Racks that slide out of a cavity whose opening is centred at z = 0. */
static void draw_racks(dmg_builder* b, const char* name, int count, float width, float height, float depth,
                       float rack) {
    for (int i = 0; i < count; ++i) {
        float y = height * (((float)i + 0.5f) / (float)count - 0.5f);
        dmg_save(b);
        dmg_move(b, 0, y - 0.5f * rack, -0.02f * depth);
        uint32_t part = dmg_slide(b, 0, name, v3(0, 0, 1), 0.0f, 0.75f * depth);
        dmg_keep_rest(b, part); /* the door is closed in front of it */
        dmg_tray_draw(b, dmg_chance(b, 0.6f) ? DMG_TRAY_WIRE : DMG_TRAY_SHEET, width, rack, 0.93f * depth,
                      0.04f * width);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_burners(dmg_builder* b, float width, float depth) {
    for (int i = 0; i < 4; ++i) {
        float x = width * (i & 1 ? 0.24f : -0.24f), z = depth * (i & 2 ? 0.24f : -0.24f),
              r = 0.16f * fminf(width, depth);
        if (i == 0) b->sides = b->sides < 12 ? 12 : b->sides;
        dmg_torus(b, v3(x, 0.01f, z), v3(0, 1, 0), r, 0.08f * r);
    }
}

void dmg_build_oven(dmg_builder* b) {
    float width = dmg_range(b, 0.5f, 0.9f), height = dmg_range(b, 0.45f, 0.95f), depth = dmg_range(b, 0.45f, 0.65f);
    float wall = dmg_range(b, 0.02f, 0.05f), t = dmg_range(b, 0.025f, 0.06f), foot = dmg_range(b, 0, 0.1f);
    float panel = height * dmg_range(b, 0.1f, 0.2f),
          base = dmg_chance(b, 0.4f) ? height * dmg_range(b, 0.12f, 0.3f) : 0.0f;
    dmg_case_kind shell = dmg_case_pick(b);
    dmg_feet_draw(b, dmg_int(b, 0, DMG_FEET_KINDS - 1), width, depth, foot);
    float cavity = height - panel - base;
    if (dmg_chance(b, 0.4f)) {
        dmg_save(b);
        dmg_move(b, 0, foot + height, 0);
        draw_burners(b, width, depth);
        dmg_restore(b);
    }
    dmg_move(b, 0, foot + base + 0.5f * cavity, 0.5f * depth);
    dmg_case_draw(b, shell, width, cavity, depth, wall);
    if (shell != DMG_CASE_SOLID)
        draw_racks(b, "rack", dmg_int(b, 0, 3), width - 2.5f * wall, cavity - 2 * wall, depth - 2 * wall, 0.02f);
    float fill_x = dmg_range(b, 0.9f, 1.0f), fill_y = dmg_range(b, 0.92f, 1.0f);
    dmg_leaf leaf = appliance_leaf(b, width * fill_x, cavity * fill_y, t);
    leaf.side = dmg_chance(b, 0.85f) ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT;
    leaf.swing = dmg_range(b, 1.3f, 1.65f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_leaf_draw(b, 0, "door", &leaf);
    dmg_restore(b);
    if (base > 0.0f) { /* a drawer or a plinth below */
        dmg_drawer drawer = dmg_drawer_pick(b, 0.2f);
        drawer.width = 0.97f * width;
        drawer.height = 0.95f * base;
        drawer.depth = 0.85f * depth;
        drawer.travel = 0.7f * depth;
        drawer.thickness = t;
        dmg_save(b);
        dmg_move(b, 0, -0.5f * (cavity + base), t);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_move(b, 0, 0, -t);
        dmg_use(b, 0);
        dmg_case_draw(b, shell, width, base, depth, wall);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * (cavity + panel), 0);
    dmg_box(b, v3(0, 0, -0.5f * depth + 0.5f * t), v3(width, panel, depth + t));
    dmg_move(b, 0, 0, t);
    draw_controls(b, 0.9f * width, 0.75f * panel);
}
