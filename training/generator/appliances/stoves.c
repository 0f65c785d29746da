/* Draws stoves and hobs: burners with relief on a slab or a range, and knobs of any size beside, above or in front. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

/* Draws a burner on y = 0: rings, a plate in a dish, a grate, a coil. */
static void draw_burner(dmg_builder* b, int kind, float radius) {
    const dmg_vec up = {0, 1, 0};
    float thin = 0.04f * radius;
    for (int i = 1; i <= 4 && kind == 0; ++i) dmg_torus(b, v3(0, 0, 0), up, radius * (0.25f * (float)i - 0.03f), thin);
    if (kind == 1) {
        const dmg_xy dish[] = {{radius, 0},           {0.95f * radius, 2 * thin},    {0.8f * radius, thin},
                               {0.3f * radius, thin}, {0.25f * radius, 0.5f * thin}, {0, 0.5f * thin}};
        dmg_lathe(b, v3(0, 0, 0), up, dish, 6);
    }
    if (kind == 2) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 3 * thin, 0), 0.35f * radius);
        dmg_torus(b, v3(0, 5 * thin, 0), up, 0.9f * radius, thin);
        for (int i = 0; i < 2; ++i) {
            dmg_vec half = i ? v3(radius, 0, 0) : v3(0, 0, radius), centre = v3(0, 5 * thin, 0);
            dmg_rod(b, v3_sub(centre, half), v3_add(centre, half), thin);
        }
    }
    if (kind == 3) dmg_rod(b, v3(0, -thin, 0), v3(0, 0.5f * thin, 0), radius);
}

static void draw_hob(dmg_builder* b, float width, float depth) {
    int columns = dmg_int(b, 1, 3), rows = dmg_int(b, 1, 2), kind = dmg_int(b, 0, 4);
    float px = width / (float)columns, pz = depth / (float)rows;
    for (int i = 0; i < columns * rows; ++i) {
        float radius = 0.5f * fminf(px, pz) * dmg_range(b, 0.5f, 0.9f);
        dmg_save(b);
        dmg_move(b, px * ((float)(i % columns) - 0.5f * (float)(columns - 1)), 0,
                 pz * ((float)(i / columns) - 0.5f * (float)(rows - 1)));
        draw_burner(b, kind, radius);
        dmg_restore(b);
    }
}

/* Knobs alike in a row on z = 0: discs with a wing, skirts, plain ones; a disc is often a little off its axis. */
static void draw_knob_row(dmg_builder* b, float length, float height) {
    int count = dmg_chance(b, 0.3f) ? 1 : dmg_int(b, 1, 6);
    float pitch = length / (float)count, radius = 0.5f * fminf(pitch, height) * dmg_range(b, 0.45f, 0.95f);
    dmg_dial dial = dmg_dial_pick(b);
    static const int kinds[] = {1, 2, 2, 2, 5, 6};
    if (dmg_chance(b, 0.6f)) dial.kind = kinds[dmg_int(b, 0, 5)];
    dial.height = dmg_scale_range(b, 0.2f, 0.9f);
    dial.sink *= 0.5f;
    dial.pulled = false;
    bool mixed = dmg_chance(b, 0.15f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        if (mixed && dmg_chance(b, 0.4f))
            dmg_control_row_draw(b, DMG_CONTROL_KEY, 1, 0, 0.7f * radius);
        else
            dmg_dial_draw(b, &dial, radius);
        dmg_restore(b);
    }
}

/* Where the knobs sit: on the front edge, on a slope before the hob, on a board behind it, beside the burners. */
void dmg_build_stove(dmg_builder* b) {
    float width = dmg_range(b, 0.25f, 0.9f), depth = width * dmg_range(b, 0.5f, 1.1f),
          high = dmg_chance(b, 0.6f) ? width * dmg_scale_range(b, 0.05f, 0.25f) : dmg_range(b, 0.6f, 0.95f),
          board = fminf(0.15f * width, 0.8f * high), x = 0.5f * width, z = 0.5f * depth;
    int place = dmg_int(b, 0, 3);
    bool range = high > 0.5f;
    float strip = place == 3 ? width * dmg_range(b, 0.18f, 0.4f) : 0.0f, row = 0.95f * width;
    dmg_box_span(b, v3(-x, 0, -z), v3(x, high, z));
    bool lid = dmg_chance(b, 0.3f);
    if (lid) dmg_box_span(b, v3(-1.03f * x, high, -1.03f * z), v3(1.03f * x, high + 0.01f * width, z));
    dmg_save(b);
    dmg_move(b, -0.5f * strip, high + 0.012f * width, 0);
    draw_hob(b, 0.92f * (width - strip), 0.92f * depth);
    dmg_restore(b);
    if (range && dmg_chance(b, 0.6f)) { /* the oven below */
        float wide = 0.9f * width, tall = 0.6f * high, thin = 0.04f * width;
        dmg_hinge(b, 0, "door", v3(0, 0.15f * high, z + thin), v3(1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(-0.5f * wide, 0.15f * high, z), v3(0.5f * wide, 0.15f * high + tall, z + thin));
        dmg_rod(b, v3(-0.4f * wide, 0.7f * high, z + 2.5f * thin), v3(0.4f * wide, 0.7f * high, z + 2.5f * thin),
                0.4f * thin);
        dmg_use(b, 0);
    }
    if (place == 0) {
        dmg_move(b, 0, high - 0.5f * fminf(board, high), z);
    } else if (place == 1) {
        const dmg_xy side[] = {{z, high - board}, {z + 0.8f * board, high - board}, {z, high}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes the object's z */
        dmg_extrude(b, side, 3, -x, x);
        dmg_restore(b);
        dmg_move(b, 0, high - 0.5f * board, z + 0.4f * board);
        dmg_turn(b, v3(1, 0, 0), -atan2f(0.8f, 1.0f));
    } else if (place == 2) {
        board = 0.2f * width;
        dmg_box_span(b, v3(-x, high, -z), v3(x, high + 1.2f * board, 0.1f * depth - z));
        dmg_move(b, 0, high + 0.6f * board, 0.1f * depth - z);
    } else {
        row = 0.9f * depth;
        board = 0.9f * strip;
        dmg_move(b, x - 0.5f * strip, high + (lid ? 0.01f * width : 0.0f), 0);
        dmg_face_up(b);
        dmg_turn(b, v3(0, 0, 1), dmg_sign(b) * 0.5f * DMG_PI);
    }
    if (dmg_chance(b, 0.5f)) row *= dmg_range(b, 0.3f, 1.0f);
    draw_knob_row(b, row, board);
    dmg_use(b, 0);
}
