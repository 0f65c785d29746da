/* Draws objects with one or a few buttons or levers: push buttons in boxes and bezels, snap-in rockers, toasters
 * with levers of any shape. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

/* ---- push buttons: on z = 0, +Z out ---- */

/* Draws a plunger on a stem: flanges, a mushroom, a plain pin. What shows above the collar may all go in, or a tenth of
 * it. */
static void draw_plunger(dmg_builder* b, float radius) {
    float out = radius * dmg_range(b, 0.4f, 3.0f), head = out * dmg_range(b, 0.15f, 0.6f),
          stem = radius * dmg_range(b, 0.35f, 0.95f), room = out - head;
    float way =
        dmg_chance(b, 0.4f) ? out * dmg_range(b, 0.05f, 0.2f) : fmaxf(0.1f * out, room * dmg_range(b, 0.3f, 0.95f));
    if (dmg_chance(b, 0.6f)) {
        float high = fmaxf(0.02f * radius, 0.3f * (out - head - way));
        const dmg_xy collar[] = {{1.4f * stem, 0}, {1.4f * stem, high}, {1.05f * stem, high}, {1.05f * stem, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), collar, 4);
    }
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, way);
    dmg_rod(b, v3(0, 0, -dmg_range(b, 0.0f, 1.0f) * radius), v3(0, 0, out - 0.5f * head), stem);
    int shape = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, 0, 0, out - head);
    if (shape == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0, head), radius);
    if (shape == 1) { /* two flanges */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.35f * head), radius);
        dmg_rod(b, v3(0, 0, 0.5f * head), v3(0, 0, head), 0.85f * radius);
    }
    if (shape == 2) dmg_knob_draw(b, 3, radius, head);
    if (shape == 3) dmg_ellipsoid(b, v3(0, 0, 0.5f * head), v3(radius, radius, 0.5f * head));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a disc in a ring of its own: proud, flush or let in; domed, flat or dished. */
static void draw_bezel_button(dmg_builder* b, float radius) {
    float wall = radius * dmg_range(b, 0.08f, 0.5f), high = radius * dmg_range(b, 0.1f, 0.8f),
          slope = dmg_range(b, 0.6f, 1.0f), deep = radius * dmg_range(b, 0.1f, 1.0f),
          top = high * dmg_range(b, 0.5f, 1.6f), bow = fmaxf(-0.4f * top, radius * dmg_range(b, -0.15f, 0.35f));
    const dmg_xy ring[] = {
        {radius + wall, 0}, {radius + slope * wall, high}, {1.02f * radius, high}, {1.02f * radius, 0}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 4);
    float own = top + deep, way = own * dmg_scale_range(b, 0.04f, 0.4f);
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, fminf(way, 0.45f * top));
    const dmg_xy disc[] = {
        {0, -deep}, {0.98f * radius, -deep}, {0.98f * radius, top}, {0.6f * radius, top + 0.7f * bow}, {0, top + bow}};
    bool shell = dmg_chance(b, 0.4f);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), disc + (shell ? 1 : 0), shell ? 4 : 5);
    dmg_use(b, 0);
}

/* Draws a block that fills a frame: a lift's, a bell's, a keypad's key. */
static void draw_framed_button(dmg_builder* b, float radius) {
    float w = 2 * radius, h = w * dmg_range(b, 0.5f, 1.6f), high = radius * dmg_range(b, 0.05f, 0.5f),
          border = radius * dmg_range(b, 0.1f, 0.4f), deep = radius * dmg_range(b, 0.0f, 0.8f),
          top = high * dmg_range(b, 0.5f, 2.0f), way = (top + deep) * dmg_scale_range(b, 0.04f, 0.4f);
    dmg_save(b);
    dmg_move(b, 0, 0, high);
    dmg_frame_draw(b, w + 2 * border, h + 2 * border, high, border);
    dmg_restore(b);
    dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, fminf(way, 0.45f * top));
    dmg_rounded_box(b, v3(0, 0, 0.5f * (top - deep)), v3(0.97f * w, 0.97f * h, top + deep),
                    0.2f * fminf(w, fminf(h, top + deep)));
    dmg_use(b, 0);
}

/* Draws the box, drum or plate they are on; without one each stands in its own bezel. */
static void draw_button_base(dmg_builder* b, float width, float height, float depth) {
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
    if (kind == 1) dmg_rounded_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth), 0.2f * fminf(height, depth));
    if (kind == 2) dmg_rod(b, v3(0, 0, -depth), v3(0, 0, 0), 0.55f * fmaxf(width, height));
    if (kind == 3) dmg_rounded_plate(b, width, height, 0.2f * depth, 0.3f * height);
    if (kind == 4) { /* a box whose lid is a part of its own */
        dmg_box(b, v3(0, 0, -0.1f * depth), v3(width, height, 0.2f * depth));
        dmg_box(b, v3(0, 0, -0.62f * depth), v3(0.98f * width, 0.98f * height, 0.76f * depth));
    }
}

void dmg_build_push_button(dmg_builder* b) {
    int count = dmg_chance(b, 0.55f) ? 1 : dmg_int(b, 2, 5), kind = dmg_int(b, 0, 2);
    float radius = dmg_scale_range(b, 0.006f, 0.06f), pitch = radius * dmg_range(b, 3.2f, 6.0f),
          width = pitch * (float)(count - 1) + radius * dmg_range(b, 3.2f, 9.0f),
          height = radius * dmg_range(b, 3.2f, 9.0f), depth = radius * dmg_scale_range(b, 0.4f, 8.0f);
    bool bare = kind != 0 && dmg_chance(b, 0.2f);
    int up = dmg_int(b, 0, 2);
    dmg_move(b, 0, 0.5f * height + depth, 0);
    if (up == 0) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (up == 1) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.2f, 1.2f));
    if (bare)
        dmg_move(b, 0, 0, -depth);
    else
        draw_button_base(b, width, height, depth);
    bool column = dmg_chance(b, 0.4f);
    if (column && !bare) pitch = height / (float)count;
    float fit = fminf(radius, 0.3f * pitch);
    for (int i = 0; i < count; ++i) {
        float along = pitch * ((float)i - 0.5f * (float)(count - 1));
        dmg_save(b);
        dmg_move(b, column ? 0 : along, column ? along : 0, 0);
        if (kind == 0) draw_plunger(b, fit);
        if (kind == 1) draw_bezel_button(b, fit);
        if (kind == 2) draw_framed_button(b, fit);
        dmg_restore(b);
    }
}

/* ---- rockers ---- */

enum { ROCKER_POINTS = 9 };

/* Seen from the side: a top of two planes or an arc that meet low or high over the pin, a belly that hides in the case.
 */
static void draw_rocker_block(dmg_builder* b, float width, float length, float rise, float deep) {
    dmg_xy side[2 * ROCKER_POINTS];
    float bow = dmg_range(b, -0.5f, 0.3f), shift = dmg_range(b, -0.12f, 0.12f);
    bool arc = dmg_chance(b, 0.5f), flat = dmg_chance(b, 0.4f);
    for (int i = 0; i < ROCKER_POINTS; ++i) {
        float s = 2.0f * (float)i / (ROCKER_POINTS - 1) - 1.0f, off = fabsf(s - shift) / (1 + fabsf(shift));
        float dip = arc ? 1.0f - off * off : 1.0f - off;
        /* The outline's x will be the panel's z, its y the panel's y. */
        side[2 * ROCKER_POINTS - 1 - i] =
            (dmg_xy){-deep * (flat ? 0.5f : 1.0f - 0.9f * s * s), 0.5f * length * s * 0.96f};
        side[i] = (dmg_xy){rise * (1.0f + bow * dip), 0.5f * length * s};
    }
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_extrude(b, side, 2 * ROCKER_POINTS, -0.5f * width, 0.5f * width);
    dmg_restore(b);
}

/* Draws what is behind the flange of a switch that snaps into a hole: a case, springs at its sides, blades. */
static void draw_snap_case(dmg_builder* b, float width, float length, float depth) {
    dmg_case_draw(b, dmg_chance(b, 0.5f) ? DMG_CASE_BOARDS : DMG_CASE_SHEET, width, length, depth, 0.05f * width);
    for (int s = -1; s <= 1 && dmg_chance(b, 0.6f); s += 2) {
        float y = (float)s * 0.5f * length;
        dmg_beam(b, v3(0, y, -0.7f * depth), v3(0, y + (float)s * 0.12f * length, -0.15f * depth), 0.5f * width,
                 0.05f * width);
    }
    int blades = dmg_int(b, 0, 4);
    for (int i = 0; i < blades; ++i) {
        float y = length * (((float)i + 0.5f) / (float)blades - 0.5f);
        dmg_box(b, v3(0, y, -1.2f * depth), v3(0.4f * width, 0.05f * width, 0.4f * depth));
    }
}

void dmg_build_rocker_switch(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.012f, 0.1f), width = length * dmg_range(b, 0.3f, 1.1f),
          rise = length * dmg_range(b, 0.04f, 0.25f), deep = length * dmg_range(b, 0.08f, 0.25f),
          border = length * dmg_range(b, 0.04f, 0.6f), flange = length * dmg_range(b, 0.03f, 0.12f),
          swing = dmg_range(b, 0.08f, 0.3f);
    int count = dmg_chance(b, 0.7f) ? 1 : dmg_int(b, 2, 4);
    bool snap = count == 1 && dmg_chance(b, 0.6f);
    float pitch = 1.08f * width, total = pitch * (float)count;
    dmg_move(b, 0, length, 0);
    if (dmg_chance(b, 0.4f)) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_frame_draw(b, total + 2 * border, 1.05f * length + 2 * border, flange, border);
    dmg_save(b);
    dmg_move(b, 0, 0, -flange);
    if (snap)
        draw_snap_case(b, 1.15f * total, 1.15f * length, length * dmg_range(b, 0.5f, 1.5f));
    else
        dmg_case_draw(b, DMG_CASE_SHEET, total + border, length + border, fmaxf(1.5f * deep, 0.3f * length),
                      0.02f * length);
    dmg_restore(b);
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), pin = -deep * dmg_range(b, 0.0f, 0.9f),
              on = dmg_sign(b);
        uint32_t rocker = dmg_hinge(b, 0, "switch", v3(x, 0, pin), v3(1, 0, 0), -swing, swing);
        dmg_rest(b, rocker, on * swing);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        draw_rocker_block(b, 0.97f * width, length, rise, deep);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* ---- toaster ---- */

/* Draws what one pushes down: a block, a lying or a standing roller, a paddle, a spoon; from z = 0 outwards, `wide`
 * along X. */
static void draw_pusher(dmg_builder* b, float wide, float out) {
    float high = wide * dmg_range(b, 0.15f, 1.2f), gap = out * dmg_range(b, 0.0f, 0.5f);
    int shape = dmg_int(b, 0, 4);
    dmg_vec middle = {0, 0, 0.5f * (out + gap)}, size = {wide, high, out - gap};
    if (shape == 0) dmg_box(b, middle, size);
    if (shape == 1) dmg_rounded_box(b, middle, size, 0.3f * fminf(high, out - gap));
    if (shape == 2)
        dmg_rod(b, v3(-0.5f * wide, 0, 0.5f * (out + gap)), v3(0.5f * wide, 0, 0.5f * (out + gap)), 0.5f * (out - gap));
    if (shape == 3) dmg_rod(b, v3(0, 0, gap), v3(0, 0, out), 0.35f * wide);
    if (shape == 4) dmg_beam(b, v3(0, 0, gap), v3(0, -0.4f * out, out), wide, 0.2f * out);
    if (gap > 0.1f * out || dmg_chance(b, 0.3f)) { /* the arm that goes through the slot to the carriage */
        float reach = dmg_chance(b, 0.4f) ? out * dmg_range(b, 0.5f, 2.0f) : 0.05f * out;
        dmg_box(b, v3(0, 0, 0.5f * (gap - reach) + 0.05f * out),
                v3(dmg_range(b, 0.05f, 0.25f) * wide, fminf(high, 0.3f * wide), gap + reach + 0.1f * out));
    }
}

static void draw_pusher_side(dmg_builder* b, float width, float height, int levers) {
    float wide = width / (float)levers * dmg_range(b, 0.12f, 0.55f), out = width * dmg_range(b, 0.06f, 0.25f),
          top = height * dmg_range(b, 0.05f, 0.38f), travel = (top + 0.4f * height) * dmg_range(b, 0.35f, 0.95f);
    bool slot = dmg_chance(b, 0.4f), up = dmg_chance(b, 0.8f), middle = dmg_chance(b, 0.15f);
    for (int i = 0; i < levers; ++i) {
        dmg_save(b);
        dmg_move(b, width * (((float)i + 0.5f) / (float)levers - 0.5f) * 0.8f, 0, 0);
        if (slot) dmg_frame_draw(b, 0.3f * wide, 1.15f * travel, 0.02f * width, 0.05f * wide);
        uint32_t lever = dmg_slide(b, 0, "lever", v3(0, -1, 0), 0.0f, travel);
        dmg_move(b, 0, top, 0);
        draw_pusher(b, wide, out);
        if (!up) dmg_rest(b, lever, travel);
        if (middle) dmg_rest(b, lever, travel * dmg_range(b, 0.1f, 0.8f));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    int extra = dmg_int(b, 0, 3);
    dmg_move(b, 0, -0.36f * height, 0);
    float small = fminf(0.1f * width, 0.08f * height);
    for (int i = 0; i < extra; ++i) {
        dmg_save(b);
        dmg_move(b, 2.6f * small * ((float)i - 0.5f * (float)(extra - 1)), 0, 0);
        if (i == 0) {
            dmg_hinge(b, 0, "dial", v3(0, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 1.5f, 5.0f));
            dmg_any_knob_draw(b, small, 0.3f, 1.2f);
            dmg_use(b, 0);
        } else {
            dmg_thumb_key_draw(b, 0, "button", 0.8f * small);
        }
        dmg_restore(b);
    }
}

void dmg_build_pop_up_toaster(dmg_builder* b) {
    float length = dmg_range(b, 0.22f, 0.42f), height = length * dmg_range(b, 0.45f, 0.8f),
          depth = length * dmg_range(b, 0.4f, 0.75f), wall = 0.06f * depth;
    int slots = dmg_int(b, 1, 2) * (dmg_chance(b, 0.15f) ? 2 : 1), shape = dmg_int(b, 0, 2);
    dmg_move(b, 0, 0.5f * height, 0);
    dmg_save(b);
    if (shape == 0)
        dmg_rounded_box(b, v3(0, 0, 0), v3(length, height, depth), fminf(height, depth) * dmg_range(b, 0.05f, 0.3f));
    if (shape == 1) { /* a loaf: round shoulders, straight along its length */
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_move(b, 0, 0, 0.5f * length);
        dmg_rounded_plate(b, depth, height, length, fminf(height, depth) * dmg_range(b, 0.1f, 0.45f));
    }
    if (shape == 2) { /* a hollow case, slots open */
        dmg_face_up(b);
        dmg_move(b, 0, 0, 0.5f * height);
        dmg_case_draw(b, dmg_case_pick(b), length, depth, height, wall);
    }
    dmg_restore(b);
    for (int i = 0; i < slots; ++i) {
        float z = depth * (((float)i + 0.5f) / (float)slots - 0.5f);
        dmg_save(b);
        dmg_move(b, 0, 0.5f * height + 0.2f * wall, z);
        dmg_face_up(b);
        dmg_frame_draw(b, 0.75f * length, 0.6f * depth / (float)slots, 0.4f * wall, 0.12f * depth / (float)slots);
        dmg_restore(b);
    }
    bool end = dmg_chance(b, 0.7f), both = end && dmg_chance(b, 0.25f);
    int levers = both ? 1 : dmg_int(b, 1, slots > 1 ? 2 : 1);
    for (int i = 0; i < (both ? 2 : 1); ++i) {
        dmg_save(b);
        if (end) dmg_turn(b, v3(0, 1, 0), i == 0 ? 0.5f * DMG_PI : -0.5f * DMG_PI);
        dmg_move(b, 0, 0, 0.5f * (end ? length : depth));
        draw_pusher_side(b, end ? depth : length, height, levers);
        dmg_restore(b);
    }
}
