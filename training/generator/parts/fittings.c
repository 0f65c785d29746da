/* Implements what appliances share: doors, racks and panels of knobs and buttons. */
#include "parts/hardware.h"

/* A door that is thicker than furniture's, with a bar or nothing to pull it. */
dmg_leaf dmg_leaf_pick_appliance(dmg_builder* b, float width, float height, float thickness) {
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
void dmg_knobs_draw(dmg_builder* b, uint32_t parent, int count, float pitch_x, float pitch_y, float radius) {
    int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    float height = radius * dmg_scale_range(b, 0.5f, 2.0f);
    bool endless = dmg_chance(b, 0.4f);
    float upper = dmg_range(b, 1.5f, 5.0f);
    for (int i = 0; i < count; ++i) {
        float at = (float)i - 0.5f * (float)(count - 1);
        dmg_save(b);
        dmg_move(b, at * pitch_x, at * pitch_y, 0);
        /* Clockwise is on. */
        if (endless)
            dmg_spin(b, parent, "knob", v3(0, 0, 0), v3(0, 0, -1));
        else
            dmg_hinge(b, parent, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
        dmg_knob_draw(b, kind, radius, height);
        dmg_restore(b);
    }
    dmg_use(b, parent);
}

/* Buttons, knobs or both on a panel of the given size, centred at the origin of z = 0. */
void dmg_controls_draw(dmg_builder* b, uint32_t parent, float width, float height) {
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
        dmg_knobs_draw(b, parent, count, tall ? 0 : pitch, tall ? pitch : 0, fminf(radius, 0.45f * pitch));
        dmg_restore(b);
    }
    if (!knobs || dmg_chance(b, 0.6f)) {
        int columns = dmg_int(b, 1, tall ? 3 : 6), rows = dmg_int(b, 1, tall ? 5 : 2);
        float px = 0.9f * (tall ? width : button_room) / (float)columns,
              py = 0.9f * (tall ? button_room : height) / (float)rows;
        float fill = dmg_range(b, 0.4f, 0.85f), w = px * fill, h = py * fill;
        if (dmg_chance(b, 0.4f)) w = h = fminf(w, h);
        float rise = fminf(w, h) * dmg_range(b, 0.1f, 0.5f);
        float way = dmg_button_way(b, rise);
        dmg_buttons set = {"button", columns, rows, px, py, w, h, rise, way, dmg_int(b, 0, 3)};
        if (set.kind == 1 || set.kind == 3) { /* what is round and stands out is a knob */
            set.rise *= 0.45f;
            set.travel *= 0.45f;
        }
        dmg_save(b);
        dmg_move(b, tall ? 0 : -0.5f * knob_room, tall ? -0.5f * knob_room : 0, 0);
        dmg_buttons_draw(b, parent, &set);
        dmg_restore(b);
    }
}

/* Racks that slide out of a cavity whose opening is centred at z = 0. */
void dmg_racks_draw(dmg_builder* b, const char* name, int count, float width, float height, float depth, float rack) {
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
