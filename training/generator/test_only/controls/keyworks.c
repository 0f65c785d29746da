/* Draws keys in numbers: levers on rods along a wind instrument's tube, typewriters, telegraph keys, accordions. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"

/* ---- levers on rods along a tube: the tube along X, its holes on top ---- */

/* About the rod at `rod`: a cup over the hole at x, and for some a touch that the barrel carries further along. */
static void draw_cup_key(dmg_builder* b, float r, dmg_vec rod, float x, float along, bool shut) {
    float cup = r * dmg_range(b, 0.55f, 0.8f), lift = dmg_range(b, 0.12f, 0.3f), top = r * 1.22f, t = 0.09f * r,
          side = rod.z > 0 ? 1.0f : -1.0f;
    uint32_t key = dmg_hinge(b, 0, "key", v3(x, rod.y, rod.z), v3(side, 0, 0), 0.0f, lift);
    if (!shut) dmg_rest(b, key, lift);
    dmg_rod(b, v3(x - 0.35f * r, rod.y, rod.z), v3(x + along, rod.y, rod.z), 1.4f * t);
    dmg_beam(b, v3(x, rod.y, rod.z), v3(x, top + 1.5f * t, 0.15f * rod.z), 2 * t, 1.2f * t);
    dmg_rod(b, v3(x, top, 0), v3(x, top + 1.8f * t, 0), cup);
    if (along > 0.5f * r) { /* a spatula for the finger, outside */
        dmg_bent n = dmg_bent_between(v3(x + along, rod.y, rod.z),
                                      v3(x + along + 0.3f * r, rod.y - 0.3f * r, rod.z + side * 1.2f * r),
                                      v3(0, 0.15f * r, 0), v3(1, 0, 0), 0.3f * r, 0.8f * t);
        n.wide[0] = 0.12f * r;
        n.rows = n.columns = 12;
        dmg_bent_draw(b, &n);
    } else if (dmg_chance(b, 0.5f))
        dmg_dome(b, v3(x, top + 1.7f * t, 0), v3(0.6f * cup, 0.3f * cup, 0.6f * cup));
    dmg_use(b, 0);
}

/* Draws a long lever on a saddle: its line runs across the tube. At an angle round it. */
static void draw_side_key(dmg_builder* b, float r, float x, float turn, float long_way) {
    float t = 0.1f * r, tip = dmg_range(b, 0.08f, 0.2f), share = dmg_range(b, 0.35f, 0.65f), lift = 0.35f * r;
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), turn);
    dmg_move(b, x, 0, 0);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, 1.12f * r, (float)s * 3.2f * t), v3(2 * t, 0.5f * r, 1.2f * t));
    dmg_hinge(b, 0, "side_key", v3(0, r + 0.25f * r, 0), v3(0, 0, -1), 0.0f, fminf(tip, lift / long_way));
    dmg_rod(b, v3(0, 1.25f * r, -2.5f * t), v3(0, 1.25f * r, 2.5f * t), t);
    dmg_vec pad = v3(-share * long_way, 1.12f * r, 0), touch = v3((1 - share) * long_way, 1.5f * r, 0);
    dmg_beam(b, v3(0, 1.25f * r, 0), v3(pad.x, 1.28f * r, 0), 2 * t, t);
    dmg_rod(b, v3(pad.x, 1.08f * r, 0), v3(pad.x, 1.3f * r, 0), 0.35f * r);
    dmg_bent n = dmg_bent_between(v3(0, 1.25f * r, 0), touch, v3(0, 0, 0.2f * r), v3(0, 0, 1), 0.25f * r, t);
    n.wide[0] = t;
    n.rows = n.columns = 12;
    dmg_bent_draw(b, &n);
    dmg_use(b, 0);
    dmg_restore(b);
}

static void draw_woodwind(dmg_builder* b) {
    float r = dmg_range(b, 0.008f, 0.02f), pitch = r * dmg_range(b, 2.0f, 2.8f), spread = dmg_range(b, 0.9f, 1.3f),
          flare = dmg_range(b, 0.9f, 1.5f), whole = dmg_range(b, -0.7f, 0.7f), roll = dmg_range(b, -0.5f, 0.5f);
    int count = dmg_int(b, 4, 9), sides = dmg_int(b, 1, 4);
    bool open = dmg_chance(b, 0.6f), bell = dmg_chance(b, 0.5f);
    float l = pitch * ((float)count + 2);
    dmg_turn(b, v3(0, 0, 1), whole);
    dmg_turn(b, v3(1, 0, 0), roll);
    dmg_bent n = dmg_bent_between(v3(-0.5f * l, 0, 0), v3(0.5f * l, 0, 0), v3(0, 0, 0), v3(0, 0, 1), r, r);
    n.round[0] = n.round[1] = 0;
    dmg_bent_draw(b, &n);
    if (bell)
        dmg_cone(b, v3(0.5f * l, 0, 0), v3(0.5f * l + 3 * r, 0, 0), r, (1 + flare) * r);
    else
        dmg_rod(b, v3(-0.5f * l - 0.4f * r, 0, 0), v3(-0.45f * l, 0, 0), 1.25f * r);
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), side = i % 3 == 2 ? -1.0f : 1.0f;
        bool far = dmg_chance(b, 0.3f);
        dmg_rod(b, v3(x, 0.8f * r, 0), v3(x, 1.2f * r, 0), 0.5f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_cone(b, v3(x + (float)s * 0.46f * pitch, 0.5f * r, side * 0.6f * r),
                     v3(x + (float)s * 0.46f * pitch, r * 0.95f, side * spread * r), 0.12f * r, 0.16f * r);
        draw_cup_key(b, r, v3(x, 0.95f * r, side * spread * r), x, far ? 0.75f * r : 0.35f * r, !open);
    }
    for (int i = 0; i < sides; ++i) {
        float x = l * (0.6f * ((float)i + 0.5f) / (float)sides - 0.3f),
              turn = (i % 2 ? 1.0f : -1.0f) * dmg_range(b, 2.0f, 2.6f), long_way = r * dmg_range(b, 3.0f, 5.0f);
        draw_side_key(b, r, x, turn, long_way);
    }
}

/* ---- keys of machines ---- */

/* Round keys on long levers whose line is at the rear, under a cover; a carriage runs on top. */
static void draw_typewriter(dmg_builder* b) {
    float wide = dmg_range(b, 0.28f, 0.4f), deep = wide * dmg_range(b, 0.8f, 1.0f),
          high = wide * dmg_range(b, 0.3f, 0.45f), press = dmg_range(b, 0.04f, 0.09f),
          cap = wide * dmg_range(b, 0.018f, 0.024f), low = 0.25f * high;
    int rows = dmg_int(b, 3, 4), columns = dmg_int(b, 6, 10);
    bool square = dmg_chance(b, 0.3f);
    dmg_box_span(b, v3(-0.5f * wide, 0, -0.6f * deep), v3(0.5f * wide, 0.3f * low, 0.5f * deep));
    dmg_bent n =
        dmg_bent_between(v3(-0.5f * wide, 0.5f * high, -0.28f * deep), v3(0.5f * wide, 0.5f * high, -0.28f * deep),
                         v3(0, 0, 0), v3(0, 0, 1), 0.3f * deep, 0.5f * high);
    n.power = dmg_range(b, 2.5f, 5.0f);
    n.round[0] = n.round[1] = 0.1f;
    dmg_bent_draw(b, &n);
    for (int i = 0; i <= rows * columns; ++i) {
        bool bar = i == rows * columns;
        int row = bar ? -1 : i / columns, column = i % columns;
        float x = bar ? 0.0f
                      : 0.9f * wide *
                            (((float)column + 0.5f + 0.2f * (float)(row % 2)) / ((float)columns + 0.2f) - 0.5f),
              z = deep * (0.4f - 0.11f * (float)row) - 0.02f * deep, y = low + 0.12f * high * (float)(row + 1);
        dmg_hinge(b, 0, bar ? "space_bar" : "key", v3(x, low, -0.3f * deep), v3(1, 0, 0), 0.0f, press);
        dmg_beam(b, v3(x, low, -0.1f * deep), v3(x, low, z + 0.5f * cap), 0.4f * cap, 0.5f * cap);
        if (bar) {
            dmg_rounded_box(b, v3(0, low + cap, z), v3(0.5f * wide, cap, 2 * cap), 0.3f * cap);
        } else {
            dmg_rod(b, v3(x, low, z), v3(x, y, z), 0.25f * cap);
            if (square)
                dmg_rounded_box(b, v3(x, y, z), v3(1.7f * cap, 0.6f * cap, 1.7f * cap), 0.2f * cap);
            else
                dmg_rod(b, v3(x, y, z), v3(x, y + 0.4f * cap, z), cap);
        }
        dmg_use(b, 0);
    }
    float way = 0.35f * wide, y = high * 1.18f, r = 0.14f * high;
    uint32_t carriage = dmg_slide(b, 0, "carriage", v3(-1, 0, 0), -way, way);
    dmg_rod(b, v3(-0.5f * wide, y, -0.35f * deep), v3(0.5f * wide, y, -0.35f * deep), r);
    dmg_box_span(b, v3(-0.48f * wide, high * 1.01f, -0.45f * deep), v3(0.48f * wide, y, -0.4f * deep));
    dmg_hinge(b, carriage, "return_lever", v3(-0.49f * wide, y, -0.25f * deep), v3(0, 1, 0), -0.5f, 0.0f);
    dmg_beam(b, v3(-0.49f * wide, y, -0.3f * deep), v3(-0.6f * wide, y + r, -0.05f * deep), 0.4f * r, 0.3f * r);
    dmg_spin(b, carriage, "platen_knob", v3(0.5f * wide, y, -0.35f * deep), v3(1, 0, 0));
    dmg_rod(b, v3(0.51f * wide, y, -0.35f * deep), v3(0.57f * wide, y, -0.35f * deep), 1.2f * r);
    dmg_use(b, 0);
}

static void draw_telegraph(dmg_builder* b) {
    float l = dmg_range(b, 0.1f, 0.16f), y = l * dmg_range(b, 0.2f, 0.32f), t = 0.04f * l,
          tip = dmg_range(b, 0.03f, 0.09f), at = l * dmg_range(b, -0.1f, 0.1f), camel = l * dmg_range(b, -0.05f, 0.15f);
    bool sounder = dmg_chance(b, 0.5f), aside = dmg_chance(b, 0.5f);
    dmg_rounded_box(b, v3(sounder ? 0.35f * l : 0.0f, t, 0), v3((sounder ? 1.4f : 0.6f) * l, 2 * t, 1.3f * l),
                    0.5f * t);
    for (int s = -1; s <= 1; s += 2)
        dmg_cone(b, v3((float)s * 0.13f * l, t, at), v3((float)s * 0.13f * l, 1.2f * y, at), 0.06f * l, 0.04f * l);
    dmg_rod(b, v3(0, t, 0.35f * l), v3(0, y - 3 * t, 0.35f * l), t);
    uint32_t key = dmg_hinge(b, 0, "lever", v3(0, y, at), v3(1, 0, 0), 0.0f, tip);
    dmg_rod(b, v3(-0.1f * l, y, at), v3(0.1f * l, y, at), 0.9f * t);
    dmg_bent n =
        dmg_bent_between(v3(0, y, -0.5f * l), v3(0, y, 0.55f * l), v3(0, camel, 0), v3(-1, 0, 0), 1.3f * t, 0.7f * t);
    n.power = 3;
    dmg_bent_draw(b, &n);
    dmg_rod(b, v3(0, y, 0.5f * l), v3(0, y + 2 * t, 0.5f * l), t);
    dmg_lathe(b, v3(0, y + 1.5f * t, 0.5f * l), v3(0, 1, 0),
              (const dmg_xy[]){{0, 0}, {3.2f * t, 0}, {3.4f * t, 0.6f * t}, {2.0f * t, 1.6f * t}, {0, 2 * t}}, 5);
    dmg_screw(b, key, "stop_screw", v3(0, y, -0.4f * l), v3(0, 1, 0), 0.001f, -3.0f, 3.0f);
    dmg_rod(b, v3(0, y - 2 * t, -0.4f * l), v3(0, y + 3 * t, -0.4f * l), 0.5f * t);
    dmg_rod(b, v3(0, y + 2 * t, -0.4f * l), v3(0, y + 3 * t, -0.4f * l), 1.4f * t);
    dmg_use(b, 0);
    if (!sounder) return;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(0.7f * l, t, (float)s * 0.15f * l), v3(0.7f * l, 1.2f * y, (float)s * 0.15f * l), 0.1f * l);
    dmg_box_span(b, v3(0.62f * l, t, -0.5f * l), v3(0.78f * l, 1.2f * y, -0.4f * l));
    dmg_hinge(b, 0, "armature", v3(0.7f * l, 1.3f * y, -0.45f * l), v3(1, 0, 0), 0.0f, 0.04f);
    dmg_box_span(b, v3(0.66f * l, 1.25f * y, -0.5f * l), v3(0.74f * l, 1.25f * y + 2 * t, 0.45f * l));
    dmg_use(b, 0);
    dmg_hinge(b, 0, "circuit_closer", v3(-0.2f * l, 2 * t, 0.3f * l), v3(0, 1, 0), 0.0f, aside ? 0.9f : 0.5f);
    dmg_box_span(b, v3(-0.23f * l, 2 * t, 0.28f * l), v3(-0.17f * l, 3 * t, 0.62f * l));
    dmg_use(b, 0);
}

/* Long finger plates down the front of a case, bass buttons at the other end, a bellows drawn out. */
static void draw_accordion(dmg_builder* b) {
    float high = dmg_range(b, 0.3f, 0.45f), deep = 0.45f * high, case_x = high * dmg_range(b, 0.2f, 0.3f),
          press = dmg_range(b, 0.05f, 0.1f), way = high * dmg_range(b, 0.2f, 0.6f);
    int keys = dmg_int(b, 8, 20), tabs = dmg_int(b, 2, 6), folds = dmg_int(b, 4, 8);
    float each = 0.9f * high / (float)keys, reach = high * dmg_range(b, 0.2f, 0.3f), bellows = 0.35f * high;
    dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(2 * case_x, high, deep), 0.12f * deep);
    dmg_box_span(b, v3(case_x, 0.04f * high, -0.3f * deep), v3(case_x + 0.9f * reach, 0.96f * high, 0.1f * deep));
    for (int i = 0; i < keys; ++i) {
        float y = 0.05f * high + each * ((float)i + 0.5f);
        dmg_hinge(b, 0, "key", v3(0.95f * case_x, y, 0.24f * deep), v3(0, 1, 0), 0.0f, press);
        dmg_rounded_box(b, v3(case_x + 0.5f * reach, y, 0.28f * deep), v3(reach, 0.9f * each, 0.12f * deep),
                        0.15f * each);
        dmg_use(b, 0);
    }
    for (int i = 0; i < tabs; ++i) {
        dmg_save(b);
        dmg_move(b, 0.3f * case_x, high * (0.2f + 0.6f * ((float)i + 0.5f) / (float)tabs), 0.5f * deep);
        dmg_rock_key_draw(b, 0, "register", 0.4f * case_x, 0.3f * high / (float)tabs);
        dmg_restore(b);
    }
    for (int i = 0; i < folds; ++i)
        dmg_box_span(b, v3(-case_x - bellows * ((float)i + 0.8f) / (float)folds, 0.03f * high, -0.47f * deep),
                     v3(-case_x - bellows * ((float)i + 0.2f) / (float)folds, 0.97f * high, 0.47f * deep));
    dmg_box_span(b, v3(-case_x - bellows, 0.05f * high, -0.44f * deep), v3(-case_x, 0.95f * high, 0.44f * deep));
    uint32_t bass = dmg_slide(b, 0, "bass_side", v3(-1, 0, 0), 0.0f, way);
    dmg_rounded_box(b, v3(-case_x * 1.6f - bellows, 0.5f * high, 0), v3(1.2f * case_x, high, deep), 0.12f * deep);
    dmg_box_span(b, v3(-case_x - bellows - 0.1f * case_x, 0.1f * high, -0.38f * deep),
                 v3(-case_x - bellows + way, 0.9f * high, 0.38f * deep));
    dmg_aim(b, v3(-2.2f * case_x - bellows, 0.5f * high, 0), v3(-1, 0, 0), v3(0, 1, 0));
    dmg_buttons set = {.name = "bass_button", .columns = 3, .rows = 6};
    set.pitch_x = 0.2f * deep;
    set.pitch_y = 0.12f * high;
    set.width = set.height = 0.1f * deep;
    set.rise = 0.05f * deep;
    set.travel = 0.7f * set.rise;
    set.kind = 1;
    dmg_buttons_draw(b, bass, &set);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_key_stack(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 1.5f, 1.5f, 1}, 4);
    if (kind == 0) draw_woodwind(b);
    if (kind == 1) draw_typewriter(b);
    if (kind == 2) draw_telegraph(b);
    if (kind == 3) draw_accordion(b);
}
