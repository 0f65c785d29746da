/* Draws desk machines: printers, cameras, remotes, keyboards, telephones with keys. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- printer ---- */

/* Draws a scanner lid over the housing's top at y = 0, hinged at the back; a feeder on it sometimes. */
static void draw_scanner(dmg_builder* b, float width, float depth, float height) {
    float t = height * dmg_range(b, 0.1f, 0.25f), back = -0.5f * depth;
    float up = dmg_range(b, 0, 1) * t, in = dmg_range(b, -0.3f, 0.8f) * t, far = dmg_range(b, 1.0f, 1.7f);
    dmg_hinge(b, 0, "scanner_lid", v3(0, up, back + in), v3(-1, 0, 0), 0.0f, far);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.5f * t, 0), v3(width, t, depth));
    else
        dmg_rounded_box(b, v3(0, 0.5f * t, 0), v3(width, t, depth), 0.3f * t);
    if (dmg_chance(b, 0.4f))
        dmg_rounded_box(b, v3(-0.2f * width, 1.4f * t, 0), v3(0.5f * width, t, 0.8f * depth), 0.3f * t);
    dmg_use(b, 0);
}

/* Draws a flap on the front z = 0 or back, its hinge along its lower edge. */
static void draw_feed_flap(dmg_builder* b, const char* name, float width, float height, float t) {
    dmg_leaf flap = dmg_leaf_pick(b, 0.1f);
    flap.width = width;
    flap.height = height;
    flap.thickness = t;
    flap.side = DMG_SIDE_BOTTOM;
    flap.swing = dmg_range(b, 0.7f, 1.7f);
    flap.handle.kind = dmg_chance(b, 0.5f) ? DMG_HANDLE_NONE : DMG_HANDLE_LIP;
    flap.hinge.kind = DMG_HINGE_NONE;
    uint32_t part = dmg_leaf_draw(b, 0, name, &flap);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, part, dmg_range(b, 0, flap.swing));
    dmg_use(b, 0);
}

void dmg_build_printer(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.3f, 0.7f), height = width * dmg_range(b, 0.3f, 0.8f),
          depth = width * dmg_range(b, 0.6f, 1.0f), t = 0.012f;
    int trays = dmg_int(b, 0, 2);
    float tray = height * dmg_range(b, 0.18f, 0.28f), foot = 0.03f * height;
    dmg_feet_draw(b, 3, width, depth, foot);
    float body = height + tray * (float)trays;
    dmg_save(b);
    dmg_move(b, 0, foot + 0.5f * body, 0.5f * depth);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, body, depth));
    else
        dmg_case_draw(b, dmg_case_pick(b), width, body, depth, 0.03f * width);
    dmg_restore(b);
    for (int i = 0; i < trays; ++i) {
        dmg_drawer drawer = dmg_drawer_pick(b, 0.1f);
        drawer.width = 0.95f * width;
        drawer.height = 0.93f * tray;
        drawer.thickness = t;
        drawer.depth = 0.8f * depth;
        drawer.travel = 0.6f * depth;
        dmg_save(b);
        dmg_move(b, 0, foot + tray * ((float)i + 0.5f), 0.5f * depth + t);
        dmg_drawer_draw(b, 0, "paper_tray", &drawer);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    float slot = height * dmg_range(b, 0.3f, 0.5f);
    float above = foot + tray * (float)trays + 1.1f * slot;
    dmg_box_span(b, v3(-0.5f * width, above, 0.45f * depth), v3(0.5f * width, foot + body, 0.5f * depth));
    dmg_save(b);
    dmg_move(b, 0, foot + tray * (float)trays + 0.55f * slot, 0.5f * depth + t);
    draw_feed_flap(b, "output_flap", 0.75f * width, slot, t);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, foot + body, 0);
    if (dmg_chance(b, 0.7f)) draw_scanner(b, width, depth, height);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0.2f * width, foot + body - 0.17f * height, 0.5f * depth);
    dmg_controls_draw(b, 0, 0.5f * width, 0.2f * height);
    dmg_restore(b);
    dmg_move(b, 0, foot + 0.7f * body, -0.5f * depth);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_move(b, 0, 0, t);
    if (dmg_chance(b, 0.4f)) draw_feed_flap(b, "feed_flap", 0.7f * width, 0.4f * height, t);
}

/* ---- camera ---- */

static void draw_lens(dmg_builder* b, float radius) {
    float length = radius * dmg_range(b, 0.4f, 2.4f), step = 0.85f * radius;
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.25f * length), radius);
    int kind = dmg_int(b, 0, 2);
    dmg_vec z = {0, 0, 1};
    if (kind == 0) { /* rings turn for focus and zoom */
        for (int i = 0; i < 2; ++i) {
            dmg_hinge(b, 0, i ? "zoom_ring" : "focus_ring", v3(0, 0, 0), z, -0.8f, 0.8f);
            float from = length * (0.27f + 0.3f * (float)i);
            dmg_rod(b, v3(0, 0, from), v3(0, 0, from + 0.25f * length), radius * (1.04f - 0.06f * (float)i));
        }
        dmg_use(b, 0);
        dmg_rod(b, v3(0, 0, 0.2f * length), v3(0, 0, length), step);
    }
    if (kind == 1) { /* the barrel comes out */
        dmg_slide(b, 0, "lens", z, 0.0f, 0.6f * length);
        dmg_rod(b, v3(0, 0, 0.1f * length), v3(0, 0, 0.6f * length), step);
        dmg_rod(b, v3(0, 0, 0.55f * length), v3(0, 0, 0.62f * length), 0.6f * radius);
    }
    if (kind == 2) { /* it is screwed off its bayonet */
        dmg_hinge(b, 0, "lens", v3(0, 0, 0), z, 0.0f, 1.2f);
        const dmg_xy profile[] = {{step, 0.25f * length},  {radius, 0.5f * length}, {radius, 0.9f * length},
                                  {1.1f * radius, length}, {0.9f * radius, length}, {0.7f * radius, 0.8f * length},
                                  {0, 0.8f * length}};
        dmg_lathe(b, v3(0, 0, 0), z, profile, 7);
    }
    dmg_use(b, 0);
}

/* Release, dials and flash on the top, y = 0. */
static void draw_camera_top(dmg_builder* b, float width, float depth) {
    float button = depth * dmg_range(b, 0.1f, 0.2f);
    dmg_save(b);
    dmg_move(b, -0.38f * width, 0, 0.1f * depth);
    dmg_face_up(b);
    dmg_buttons release = {"shutter", 1, 1, 0, 0, 2 * button, 2 * button, 0.6f * button, 0.4f * button, 1};
    dmg_buttons_draw(b, 0, &release);
    dmg_restore(b);
    int dials = dmg_int(b, 0, 2);
    for (int i = 0; i < dials; ++i) {
        dmg_save(b);
        dmg_move(b, width * (0.28f + 0.15f * (float)i), 0, 0);
        dmg_face_up(b);
        dmg_spin(b, 0, "dial", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_int(b, 0, 5), 1.6f * button, button);
        dmg_use(b, 0);
        dmg_restore(b);
    }
    float hump = 0.3f * width;
    dmg_box(b, v3(0, 0.2f * depth, 0), v3(hump, 0.4f * depth, 0.7f * depth));
    if (dmg_chance(b, 0.5f)) {
        float t = 0.12f * depth;
        dmg_hinge(b, 0, "flash", v3(0, 0.4f * depth + 0.5f * t, -0.3f * depth), v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 0.7f, 1.3f));
        dmg_box(b, v3(0, 0.4f * depth + 0.5f * t, 0), v3(0.9f * hump, t, 0.65f * depth));
        dmg_use(b, 0);
    }
}

void dmg_build_camera(dmg_builder* b) {
    float width = dmg_range(b, 0.09f, 0.16f), height = width * dmg_range(b, 0.5f, 0.8f),
          depth = width * dmg_range(b, 0.2f, 0.45f);
    dmg_move(b, 0, 0.5f * height, 0);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0, 0), v3(width, height, depth), 0.2f * depth);
    else
        dmg_box(b, v3(0, 0, 0), v3(width, height, depth));
    if (dmg_chance(b, 0.4f))
        dmg_box(b, v3(-0.42f * width, -0.05f * height, 0.6f * depth), v3(0.14f * width, 0.9f * height, 0.3f * depth));
    dmg_save(b);
    dmg_move(b, dmg_range(b, -0.05f, 0.12f) * width, 0, 0.5f * depth);
    draw_lens(b, height * dmg_range(b, 0.28f, 0.42f));
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * height, 0);
    draw_camera_top(b, width, depth);
    dmg_restore(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* the back: screen and buttons */
    dmg_move(b, 0, 0, 0.5f * depth);
    float t = 0.1f * depth;
    dmg_save(b);
    dmg_move(b, -0.1f * width, -0.05f * height, t);
    if (dmg_chance(b, 0.5f))
        dmg_hinge(b, 0, "screen", v3(-0.3f * width, 0, -0.5f * t), v3(0, -1, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
    dmg_rounded_plate(b, 0.6f * width, 0.7f * height, t, 0.05f * width);
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_move(b, 0.35f * width, -0.05f * height, 0);
    float key = 0.07f * width;
    dmg_buttons keys = {"button", dmg_int(b, 1, 2), dmg_int(b, 1, 4), 1.6f * key,      1.6f * key, key,
                        key,      0.3f * key,       0.2f * key,       dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, 0, &keys);
}

/* ---- remote ---- */

void dmg_build_remote(dmg_builder* b) {
    float width = dmg_range(b, 0.03f, 0.08f), length = width * dmg_range(b, 1.6f, 5.0f),
          thick = width * dmg_range(b, 0.2f, 0.6f);
    int shape = dmg_int(b, 0, 2);
    dmg_move(b, 0, thick, 0);
    dmg_face_up(b);
    if (shape == 0) dmg_rounded_box(b, v3(0, 0, -0.5f * thick), v3(width, length, thick), 0.4f * thick);
    if (shape == 1) dmg_rounded_plate(b, width, length, thick, 0.3f * width);
    if (shape == 2) dmg_box(b, v3(0, 0, -0.5f * thick), v3(width, length, thick));
    int columns = dmg_int(b, 2, 4), rows = (int)(0.6f * length / width * (float)columns * dmg_range(b, 0.5f, 1.0f));
    rows = rows < 2 ? 2 : (rows > 9 ? 9 : rows);
    float px = 0.9f * width / (float)columns, py = 0.65f * length / (float)rows, fill = dmg_range(b, 0.5f, 0.85f);
    float rise = px * dmg_range(b, 0.1f, 0.3f), way = dmg_button_way(b, rise);
    dmg_buttons keys = {"button", columns, rows, px, py, fill * px, fill * fminf(py, px), rise, way, dmg_int(b, 0, 3)};
    dmg_save(b);
    dmg_move(b, 0, -0.14f * length, 0);
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
    dmg_move(b, 0, 0.36f * length, 0);
    if (dmg_chance(b, 0.5f)) { /* a rocking pad */
        dmg_hinge(b, 0, "pad", v3(0, 0, 0), v3(dmg_chance(b, 0.5f) ? 1.0f : 0.0f, 1, 0), -0.2f, 0.2f);
        dmg_rod(b, v3(0, 0, -0.5f * rise), v3(0, 0, rise), 0.35f * width);
    } else {
        dmg_buttons power = {"power", 1, 1, 0, 0, 0.3f * width, 0.3f * width, rise, way, 1};
        dmg_buttons_draw(b, 0, &power);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* the battery cover on the back */
        dmg_slide(b, 0, "battery_cover", v3(0, -1, 0), 0.0f, 0.3f * length);
        dmg_box(b, v3(0, -0.65f * length, -thick), v3(0.8f * width, 0.4f * length, 0.08f * thick));
        dmg_use(b, 0);
    }
}

/* ---- keyboard ---- */

/* Draws one row of keys of different widths; what is left over goes to the longest. */
static void draw_key_row(dmg_builder* b, float width, float pitch, float rise, float way, int kind, bool space) {
    float left = width, x = -0.5f * width;
    while (left > 0.5f * pitch && b->part_count < 70) {
        float units = dmg_chance(b, 0.85f) ? 1.0f : 1.5f;
        if (space && x < -0.1f * width && x + 1.1f * pitch > -0.3f * width) units = 0.55f * width / pitch;
        float w = fminf(units * pitch, left);
        if (left - w < 0.5f * pitch) w = left;
        dmg_save(b);
        dmg_move(b, x + 0.5f * w, 0, 0);
        dmg_buttons key = {"key", 1, 1, 0, 0, w - 0.14f * pitch, 0.86f * pitch, rise, way, kind};
        dmg_buttons_draw(b, 0, &key);
        dmg_restore(b);
        x += w;
        left -= w;
    }
}

/* Draws a piano's keys: pivots far behind. */
static void draw_piano(dmg_builder* b, float width, float depth, float rise) {
    int keys = dmg_int(b, 8, 24);
    float pitch = width / (float)keys;
    dmg_box(b, v3(0, rise, -0.35f * depth), v3(1.06f * width, 2.4f * rise, 0.35f * depth));
    dmg_box(b, v3(0, 0, 0), v3(1.06f * width, 0.3f * rise, depth));
    for (int i = 0; i < keys; ++i) {
        float x = pitch * ((float)i + 0.5f) - 0.5f * width, length = 0.62f * depth, z = 0.45f * depth;
        dmg_hinge(b, 0, "key", v3(x, rise, z - 1.3f * length), v3(1, 0, 0), 0.0f, 0.5f * rise / length);
        dmg_box(b, v3(x, rise, z - 0.5f * length), v3(0.94f * pitch, 0.8f * rise, length));
        if (i % 7 == 2 || i % 7 == 6 || i + 1 == keys) continue;
        dmg_hinge(b, 0, "black_key", v3(x + 0.5f * pitch, rise, z - 1.3f * length), v3(1, 0, 0), 0.0f,
                  0.5f * rise / length);
        dmg_box(b, v3(x + 0.5f * pitch, 1.7f * rise, z - 0.68f * length),
                v3(0.5f * pitch, 0.8f * rise, 0.62f * length));
    }
    dmg_use(b, 0);
}

void dmg_build_keyboard(dmg_builder* b) {
    if (dmg_chance(b, 0.2f)) {
        float width = dmg_range(b, 0.3f, 1.0f);
        draw_piano(b, width, dmg_range(b, 0.15f, 0.3f), 0.02f);
        return;
    }
    float pitch = dmg_range(b, 0.014f, 0.02f), width = pitch * (float)dmg_int(b, 8, 15),
          rise = pitch * dmg_range(b, 0.15f, 0.6f), thick = pitch * dmg_range(b, 0.3f, 1.5f);
    int rows = dmg_int(b, 3, 5), kind = dmg_chance(b, 0.6f) ? 0 : 2;
    float depth = pitch * (float)rows, border = pitch * dmg_range(b, 0.2f, 1.0f), way = dmg_button_way(b, rise);
    dmg_move(b, 0, thick, 0);
    dmg_face_up(b);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, -0.5f * thick), v3(width + border, depth + border, thick));
    else
        dmg_rounded_plate(b, width + border, depth + border, thick, border);
    for (int row = 0; row < rows; ++row) {
        dmg_save(b);
        dmg_move(b, 0, pitch * ((float)row + 0.5f) - 0.5f * depth, 0);
        draw_key_row(b, width, pitch, rise, way, kind, row == 0);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f)) { /* feet that fold out below */
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.42f * width, y = 0.4f * depth;
            dmg_hinge(b, 0, "foot", v3(x, y, -thick), v3(-1, 0, 0), 0.0f, 1.6f);
            dmg_box(b, v3(x, y - 0.5f * pitch, -thick - 0.1f * pitch), v3(1.6f * pitch, pitch, 0.2f * pitch));
        }
        dmg_use(b, 0);
    }
}
