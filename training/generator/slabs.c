/* Two halves about a line: laptops, telephones, staplers, tools. */
#include "categories.h"
#include "hardware.h"

/* Keys as parts of the body or joints of their own, on y = 0 facing up, over width x depth centred at the origin. */
static void draw_keys(dmg_builder* b, float width, float depth, float rise, bool moving) {
    int columns = moving ? dmg_int(b, 4, 8) : dmg_int(b, 6, 12), rows = moving ? dmg_int(b, 2, 4) : dmg_int(b, 3, 5);
    float px = width / (float)columns, pz = depth / (float)rows;
    if (moving) {
        dmg_buttons keys = {"key",      columns,    rows, px,          pz,
                            0.84f * px, 0.84f * pz, rise, 0.6f * rise, dmg_chance(b, 0.7f) ? 0 : 2};
        dmg_save(b);
        dmg_face_up(b);
        dmg_buttons_draw(b, 0, &keys);
        dmg_restore(b);
        return;
    }
    for (int i = 0; i < columns * rows; ++i) {
        float x = px * ((float)(i % columns) + 0.5f) - 0.5f * width,
              z = pz * ((float)(i / columns) + 0.5f) - 0.5f * depth;
        dmg_box(b, v3(x, 0.5f * rise, z), v3(0.84f * px, rise, 0.84f * pz));
    }
}

/* The screen half, lying closed on y = 0 … thick, hinge line along X at z = -depth / 2. */
static void draw_screen(dmg_builder* b, int style, float width, float depth, float thick) {
    float bezel = 0.05f * width;
    dmg_save(b);
    dmg_move(b, 0, thick, 0);
    dmg_face_up(b);
    if (style == 0)
        dmg_rounded_plate(b, width, depth, thick, 0.06f * depth);
    else if (style == 1)
        dmg_rounded_box(b, v3(0, 0, -0.5f * thick), v3(width, depth, thick), 0.4f * thick);
    else
        dmg_box(b, v3(0, 0, -0.5f * thick), v3(width, depth, thick));
    dmg_restore(b);
    if (dmg_chance(b, 0.4f))
        dmg_box(b, v3(0, -0.02f * thick, 0), v3(width - 2 * bezel, 0.1f * thick, depth - 2 * bezel));
    if (dmg_chance(b, 0.15f)) dmg_box(b, v3(0, 1.05f * thick, 0), v3(0.15f * depth, 0.1f * thick, 0.15f * depth));
}

void dmg_build_laptop(dmg_builder* b) {
    float width = dmg_range(b, 0.22f, 0.42f), depth = width * dmg_range(b, 0.58f, 0.8f),
          base = width * dmg_range(b, 0.03f, 0.12f);
    float thick = width * dmg_range(b, 0.015f, 0.06f), gap = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0005f, 0.003f);
    int style = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, 0, base, 0);
    dmg_face_up(b);
    if (style == 0)
        dmg_rounded_plate(b, width, depth, base, 0.06f * depth);
    else if (style == 1)
        dmg_rounded_box(b, v3(0, 0, -0.5f * base), v3(width, depth, base), 0.4f * base);
    else
        dmg_box(b, v3(0, 0, -0.5f * base), v3(width, depth, base));
    dmg_restore(b);
    int keyboard = dmg_int(b, 0, 3); /* none, drawn, moving keys, a sunken field */
    dmg_save(b);
    dmg_move(b, 0, base, -0.15f * depth);
    if (keyboard == 1) draw_keys(b, 0.9f * width, 0.5f * depth, 0.4f * gap + 0.001f, false);
    if (keyboard == 2 && dmg_chance(b, 0.3f)) draw_keys(b, 0.9f * width, 0.5f * depth, 0.004f, true);
    if (keyboard == 3) dmg_box(b, v3(0, 0, 0), v3(0.9f * width, 0.0015f, 0.5f * depth));
    dmg_move(b, 0, 0, 0.48f * depth);
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 0, 0), v3(0.25f * width, 0.0012f, 0.22f * depth)); /* touch pad */
    dmg_restore(b);
    float radius = fminf(base, thick) * dmg_range(b, 0.3f, 0.7f),
          back = -0.5f * depth + radius * dmg_range(b, -1.2f, 1.2f);
    float up = base + gap + (dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, -0.5f, 0.5f) * base);
    if (dmg_chance(b, 0.5f)) { /* the barrel under the screen's lower edge */
        float span = width * dmg_range(b, 0.06f, 0.45f);
        int barrels = span > 0.25f * width ? 1 : 2;
        for (int i = 0; i < barrels; ++i) {
            float x = barrels == 1 ? 0.0f : width * ((float)i - 0.5f) * 0.75f;
            dmg_rod(b, v3(x - 0.5f * span, up, back), v3(x + 0.5f * span, up, back), radius);
        }
    }
    float far = dmg_range(b, 2.1f, 3.14f);
    uint32_t screen = dmg_hinge(b, 0, "screen", v3(0, up, back), v3(-1, 0, 0), 0.0f, far);
    dmg_move(b, 0, base + gap, 0);
    float scale = dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.9f, 1.02f);
    draw_screen(b, style, width * scale, depth * scale, thick);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.75f)) dmg_rest(b, screen, dmg_range(b, 1.2f, fminf(2.3f, far)));
}
