/* Draws projectors for screens, slides and films, drafting tables and easels, and telephones. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- projectors: the lens looks to +Z ---- */

/* Rings on a barrel out of z = 0; one turns for focus, one for zoom, or a lever on it does. */
static void draw_lens(dmg_builder* b, float r, float length) {
    bool zoom = dmg_chance(b, 0.5f), lever = dmg_chance(b, 0.5f), screwed = dmg_chance(b, 0.3f),
         cap = dmg_chance(b, 0.3f);
    dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.6f * length), 0.85f * r);
    if (screwed)
        dmg_screw(b, 0, "focus", v3(0, 0, 0), v3(0, 0, 1), 0.004f * length, 0.0f, 35.0f);
    else
        dmg_hinge(b, 0, "focus", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -1.2f, 1.2f);
    const dmg_xy ring[] = {{0.86f * r, 0.65f * length}, {r, 0.65f * length},       {r, length},
                           {0.75f * r, length},         {0.7f * r, 0.8f * length}, {0, 0.8f * length}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 6);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, 1.08f * r, 0.75f * length), v3(0.2f * r, 0.25f * r, 0.1f * length));
    dmg_use(b, 0);
    if (zoom) {
        dmg_hinge(b, 0, "zoom", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -0.6f, 0.6f);
        dmg_rod(b, v3(0, 0, 0.2f * length), v3(0, 0, 0.5f * length), 0.98f * r);
        if (lever) dmg_box(b, v3(0, 1.2f * r, 0.35f * length), v3(0.15f * r, 0.5f * r, 0.12f * length));
        dmg_use(b, 0);
    }
    if (!cap) return;
    dmg_hinge(b, 0, "lens_cap", v3(0, 1.15f * r, 1.03f * length), v3(-1, 0, 0), 0.0f, 2.0f);
    dmg_rod(b, v3(0, 0, 1.01f * length), v3(0, 0, 1.06f * length), 1.05f * r);
    dmg_box(b, v3(0, 1.1f * r, 1.035f * length), v3(0.5f * r, 0.2f * r, 0.05f * length));
    dmg_use(b, 0);
    dmg_box_span(b, v3(-0.2f * r, 1.15f * r, 0.0f), v3(0.2f * r, 1.2f * r, 1.02f * length));
}

/* Feet that screw out or drop, below the rectangle at y = 0. */
static void draw_levelling_feet(dmg_builder* b, float x, float z, float r) {
    bool single = dmg_chance(b, 0.4f), drops = dmg_chance(b, 0.3f);
    for (int s = single ? 0 : -1; s <= 1; s += 2) {
        float at = single ? 0.0f : (float)s * x;
        if (drops)
            dmg_slide(b, 0, "foot", v3(0, -1, 0), 0.0f, 2 * r);
        else
            dmg_screw(b, 0, "foot", v3(at, 0, z), v3(0, -1, 0), 0.05f * r, 0.0f, 35.0f);
        dmg_rod(b, v3(at, -0.8f * r, z), v3(at, 2 * r, z), 0.4f * r);
        dmg_rod(b, v3(at, -1.2f * r, z), v3(at, -0.6f * r, z), r);
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3((float)s * x, -1.2f * r, -z), v3((float)s * x, 0, -z), 0.8f * r);
}

static void draw_beamer(dmg_builder* b) {
    float x = dmg_range(b, 0.1f, 0.22f), z = x * dmg_range(b, 0.7f, 0.9f), y = x * dmg_range(b, 0.45f, 0.75f),
          r = y * dmg_range(b, 0.3f, 0.42f), at = x * dmg_range(b, -0.5f, 0.5f), foot = 0.012f,
          lens = r * dmg_range(b, 0.7f, 1.6f);
    bool hatch = dmg_chance(b, 0.5f), shutter = dmg_chance(b, 0.3f);
    dmg_move(b, 0, 1.2f * foot, 0);
    draw_levelling_feet(b, 0.8f * x, 0.75f * z, foot);
    dmg_rounded_box(b, v3(0, 0.5f * y, 0), v3(2 * x, y, 2 * z), 0.12f * y);
    dmg_save(b);
    dmg_move(b, at, 0.52f * y, z);
    draw_lens(b, r, lens);
    dmg_restore(b);
    if (shutter) { /* a plate slides before the lens's window */
        dmg_slide(b, 0, "lens_shutter", v3(1, 0, 0), 0.0f, 0.8f * r);
        dmg_box(b, v3(at > 0.0f ? at - 2.2f * r : at + 1.9f * r, 0.5f * y, z + 0.003f), v3(0.5f * r, 1.2f * r, 0.006f));
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, -0.3f * at, y, -0.55f * z);
    dmg_face_up(b);
    dmg_buttons keys = {.name = "key",
                        .columns = 4,
                        .rows = 2,
                        .pitch_x = 0.2f * x,
                        .pitch_y = 0.2f * x,
                        .width = 0.13f * x,
                        .height = 0.1f * x,
                        .rise = 0.02f * x,
                        .travel = 0.015f * x};
    keys.columns = dmg_int(b, 2, 5);
    keys.kind = dmg_int(b, 0, 3);
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
    if (hatch) { /* over the lamp */
        dmg_hinge(b, 0, "lamp_cover", v3(0.9f * x, y, 0), v3(0, 0, -1), 0.0f, 1.4f);
        dmg_box_span(b, v3(0.2f * x, y + 0.001f, 0.0f), v3(0.9f * x, y + 0.03f * x, 0.7f * z));
        dmg_use(b, 0);
    }
    dmg_hinge(b, 0, "filter_door", v3(-x, 0.2f * y, 0), v3(0, 0, 1), 0.0f, 1.5f);
    dmg_box_span(b, v3(-x - 0.006f, 0.2f * y, -0.5f * z), v3(-x - 0.0005f, 0.75f * y, 0.5f * z));
    dmg_use(b, 0);
}

/* Slides in a wheel that turns on top, or in a straight box that is pushed through at the side. */
static void draw_slide_projector(dmg_builder* b) {
    float x = dmg_range(b, 0.12f, 0.16f), z = x * dmg_range(b, 0.9f, 1.2f), y = x * dmg_range(b, 0.6f, 0.9f),
          r = 0.28f * y, foot = 0.012f;
    bool wheel = dmg_chance(b, 0.6f);
    int slots = dmg_int(b, 10, 20);
    dmg_move(b, 0, 1.2f * foot, 0);
    draw_levelling_feet(b, 0.8f * x, 0.75f * z, foot);
    dmg_box_span(b, v3(-x, 0, -z), v3(wheel ? x : 0.5f * x, y, z));
    if (!wheel) dmg_box_span(b, v3(0.5f * x, 0, -z), v3(x, 0.35f * y, z));
    dmg_save(b);
    dmg_move(b, 0, 0.5f * y, z);
    draw_lens(b, r, 2.2f * r);
    dmg_restore(b);
    if (wheel) {
        dmg_spin(b, 0, "tray", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, y + 0.002f, 0), v3(0, y + 0.01f, 0), 0.95f * z);
        dmg_rod(b, v3(0, y + 0.01f, 0), v3(0, y + 0.05f, 0), 0.5f * z);
    } else
        dmg_slide(b, 0, "tray", v3(0, 0, 1), -1.2f * z, 0.4f * z);
    for (int i = 0; i < slots; ++i) {
        dmg_save(b);
        if (wheel) dmg_turn_to(b, v3(0, 1, 0), i, slots);
        if (wheel) dmg_box_span(b, v3(0.49f * z, y + 0.009f, -0.006f), v3(0.93f * z, y + 0.05f, 0.006f));
        if (!wheel)
            dmg_box(b, v3(0.75f * x, 0.56f * y, 1.8f * z * (((float)i + 0.5f) / (float)slots - 0.5f)),
                    v3(0.42f * x, 0.35f * y, 0.006f));
        dmg_restore(b);
    }
    if (!wheel) dmg_box_span(b, v3(0.53f * x, 0.36f * y, -0.95f * z), v3(0.97f * x, 0.4f * y, 0.95f * z));
    dmg_use(b, 0);
    dmg_slide(b, 0, "advance", v3(0, 0, -1), 0.0f, 0.004f);
    dmg_box(b, v3(-0.7f * x, 0.8f * y, z + 0.003f), v3(0.25f * x, 0.12f * y, 0.01f));
    dmg_use(b, 0);
}

/* Draws two reels on arms that fold, a lens, a lamp house with a door, a crank or a knob to thread the film. */
static void draw_film_projector(dmg_builder* b) {
    float y = dmg_range(b, 0.2f, 0.4f), x = 0.25f * y, z = 0.4f * y, reel = y * dmg_range(b, 0.35f, 0.55f),
          arm = reel * dmg_range(b, 0.9f, 1.2f), t = 0.03f * y, up = 0.7f;
    bool folds = dmg_chance(b, 0.7f), crank = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-1.3f * x, 0, -1.3f * z), v3(1.3f * x, 0.08f * y, 1.3f * z));
    dmg_box_span(b, v3(-x, 0.08f * y, -z), v3(x, y, z));
    dmg_save(b);
    dmg_move(b, 0.3f * x, 0.6f * y, z);
    draw_lens(b, 0.11f * y, 0.3f * y);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_vec pin = v3(x + t, 0.92f * y, 0.8f * z * side),
                end = v3(x + t, 0.92f * y + arm * sinf(up), 0.8f * z * side + side * arm * cosf(up));
        uint32_t carrier = folds ? dmg_hinge(b, 0, "reel_arm", pin, v3(side, 0, 0), 0.0f, 0.7f) : 0;
        dmg_beam(b, pin, end, t, 2 * t);
        dmg_rod(b, v3(x + 0.002f, pin.y, pin.z), v3(x + 2 * t, pin.y, pin.z), 1.5f * t);
        dmg_rod(b, end, v3(end.x + 4 * t, end.y, end.z), 0.5f * t);
        dmg_spin(b, carrier, "reel", end, v3(1, 0, 0));
        dmg_save(b);
        dmg_move(b, end.x + 1.2f * t, end.y, end.z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, 3, reel, t, 4);
        dmg_move(b, 0, 0, 1.5f * t);
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, -1.4f * t), v3(0, 0, -0.1f * t), reel * dmg_range(b, 0.3f, 0.85f));
        dmg_wheel_draw(b, 3, reel, t, 4);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_vec at = v3(x, 0.35f * y, -0.5f * z);
    dmg_spin(b, 0, crank ? "crank" : "knob", at, v3(1, 0, 0));
    dmg_rod(b, at, v3(at.x + 3 * t, at.y, at.z), crank ? 0.6f * t : 2.5f * t);
    if (crank) {
        dmg_beam(b, v3(at.x + 3 * t, at.y + t, at.z), v3(at.x + 3 * t, at.y - 0.25f * y, at.z), t, t);
        dmg_rod(b, v3(at.x + 2.6f * t, at.y - 0.23f * y, at.z), v3(at.x + 7 * t, at.y - 0.23f * y, at.z), 0.8f * t);
    } else
        dmg_box(b, v3(at.x + 3.1f * t, at.y, at.z), v3(0.5f * t, 4 * t, 0.6f * t));
    dmg_use(b, 0);
    dmg_hinge(b, 0, "lamp_door", v3(-x - 0.002f, 0, -0.9f * z), v3(0, -1, 0), 0.0f, 1.8f);
    dmg_box_span(b, v3(-x - t, 0.2f * y, -0.9f * z), v3(-x - 0.001f, 0.9f * y, 0.6f * z));
    dmg_use(b, 0);
}

void dmg_build_projector(dmg_builder* b) {
    switch (dmg_weighted(b, (const float[]){3, 2, 2}, 3)) {
    case 0:
        draw_beamer(b);
        break;
    case 1:
        draw_slide_projector(b);
        break;
    default:
        draw_film_projector(b);
        break;
    }
}

/* ---- drafting tables ---- */

/* Draws what lies on the board: a bar that runs down it, or a head on two arms with rules that turn; a pencil ledge, a
 * lamp. */
static void draw_board(dmg_builder* b, uint32_t board, float wide, float deep, float t) {
    float z = 0.5f * deep, bar = dmg_range(b, 0.03f, 0.06f);
    int tool = dmg_int(b, 0, 2);
    bool lamp = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-0.5f * wide, -t, -z), v3(0.5f * wide, 0, z));
    if (dmg_chance(b, 0.6f)) dmg_box_span(b, v3(-0.4f * wide, 0, z), v3(0.4f * wide, 0.02f, z + 0.02f));
    if (tool == 0) {
        uint32_t rule = dmg_slide(b, board, "parallel_bar", v3(0, 0, 1), -0.8f * z, 0.8f * z);
        dmg_rest(b, rule, 0.7f * z * (2 * dmg_unit(b) - 1));
        dmg_box_span(b, v3(-0.49f * wide, 0.001f, -0.5f * bar), v3(0.49f * wide, 0.01f, 0.5f * bar));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0.46f * wide * (float)s, 0.012f, 0), v3(0.04f, 0.012f, 1.3f * bar));
    }
    if (tool == 1) { /* a rail that runs across, a head that runs down it, rules that turn on the head */
        uint32_t rail = dmg_slide(b, board, "rail", v3(1, 0, 0), -0.4f * wide, 0.4f * wide);
        dmg_box_span(b, v3(-0.02f, 0.001f, -1.02f * z), v3(0.02f, 0.02f, 0.98f * z));
        dmg_box_span(b, v3(-0.06f, 0.001f, -1.05f * z), v3(0.06f, 0.03f, -0.97f * z));
        uint32_t head = dmg_slide(b, rail, "head", v3(0, 0, 1), -0.6f * z, 0.5f * z);
        dmg_box(b, v3(0, 0.03f, 0), v3(0.08f, 0.018f, 0.08f));
        dmg_hinge(b, head, "rules", v3(0, 0, 0), v3(0, 1, 0), -0.8f, 0.8f);
        dmg_rod(b, v3(0, 0.04f, 0), v3(0, 0.06f, 0), 0.05f);
        dmg_box_span(b, v3(0.03f, 0.042f, -0.02f), v3(0.4f * wide, 0.048f, 0.02f));
        dmg_box_span(b, v3(-0.02f, 0.042f, -0.5f * z), v3(0.02f, 0.048f, -0.03f));
        dmg_ellipsoid(b, v3(0, 0.07f, 0), v3(0.025f, 0.02f, 0.025f));
    }
    dmg_use(b, board);
    if (!lamp) return;
    dmg_vec at = v3(-0.45f * wide, 0.02f, -0.9f * z);
    dmg_rod(b, v3(at.x, -0.03f, at.z), at, 0.025f);
    uint32_t arm = dmg_hinge(b, board, "lamp_arm", at, v3(0, 1, 0), -0.4f, 1.2f);
    dmg_rod(b, at, v3(at.x + 0.15f, at.y + 0.3f, at.z), 0.01f);
    arm = dmg_hinge(b, arm, "lamp_fore_arm", v3(at.x + 0.15f, at.y + 0.3f, at.z), v3(0, 0, 1), -0.5f, 0.5f);
    dmg_rod(b, v3(at.x + 0.15f, at.y + 0.3f, at.z), v3(at.x + 0.5f, at.y + 0.38f, at.z), 0.009f);
    dmg_hinge(b, arm, "lamp_head", v3(at.x + 0.5f, at.y + 0.38f, at.z), v3(0, 0, 1), -0.7f, 0.7f);
    dmg_cone(b, v3(at.x + 0.5f, at.y + 0.4f, at.z), v3(at.x + 0.53f, at.y + 0.28f, at.z), 0.025f, 0.08f);
    dmg_use(b, board);
}

static void draw_drafting_desk(dmg_builder* b) {
    float wide = dmg_range(b, 0.8f, 1.6f), deep = wide * dmg_range(b, 0.6f, 0.75f), y = dmg_range(b, 0.7f, 1.0f),
          t = 0.025f, up = dmg_range(b, 0.6f, 1.2f), x = 0.4f * wide;
    int pin = dmg_int(b, 0, 1), drawers = dmg_int(b, 0, 3);
    bool rises = dmg_chance(b, 0.4f), shelf = dmg_chance(b, 0.5f);
    float z = pin == 0 ? 0.45f * deep : 0.0f, limit = pin == 0 ? up : 1.2f, low = pin == 0 ? 0.0f : -0.1f;
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * x;
        dmg_box_span(b, v3(at - t, 0, -0.45f * deep), v3(at + t, 2 * t, 0.45f * deep));
        dmg_box_span(b, v3(at - t, 2 * t, -0.05f * deep),
                     v3(at + t, rises ? 0.75f * y : y - 2 * t - (pin ? 0.5f * t : 2 * t), 0.12f * deep));
        if (pin == 0 && !rises)
            dmg_box_span(b, v3(at - t, y - 6 * t, -0.3f * deep), v3(at + t, y - 2.2f * t, 0.47f * deep));
    }
    dmg_box_span(b, v3(-x, 0.3f * y, -0.03f * deep), v3(x, 0.3f * y + 3 * t, 0.03f * deep));
    for (int i = 0; i < drawers; ++i) {
        dmg_drawer drawer = dmg_drawer_pick(b, 0.08f);
        drawer.width = 0.3f * wide;
        drawer.height = 0.09f;
        drawer.depth = 0.3f * deep;
        drawer.travel = 0.25f * deep;
        float top = 0.62f * y - 0.1f * (float)i;
        dmg_box_span(b, v3(-0.33f * wide - t, top - 0.098f, -0.15f * deep), v3(-0.33f * wide, top, 0.18f * deep));
        dmg_box_span(b, v3(-x, top - 0.002f, -0.15f * deep), v3(-0.01f * wide, top, 0.18f * deep));
        dmg_save(b);
        dmg_move(b, -0.17f * wide, top - 0.05f, 0.18f * deep);
        dmg_drawer_draw(b, 0, "drawer", &drawer);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (shelf) dmg_box_span(b, v3(-x, 2 * t, -0.2f * deep), v3(x, 3 * t, 0.2f * deep));
    uint32_t carrier = 0;
    if (rises) {
        carrier = dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, 0.2f * y);
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * x - 0.6f * t, 0.45f * y, -0.03f * deep),
                         v3((float)s * x + 0.6f * t, y - 2.5f * t, 0.1f * deep));
            dmg_box_span(b, v3((float)s * x - t, y - 4 * t, -0.3f * deep),
                         v3((float)s * x + t, y - 2.2f * t, 0.47f * deep));
        }
    }
    uint32_t board = dmg_hinge(b, carrier, "board", v3(0, y - t, z), v3(1, 0, 0), low, limit);
    dmg_rest(b, board, dmg_chance(b, 0.3f) ? 0.0f : limit * dmg_unit(b));
    if (pin == 0) dmg_rod(b, v3(-x, y - 1.7f * t, z), v3(x, y - 1.7f * t, z), 0.5f * t);
    if (pin) dmg_rod(b, v3(-x, y - 1.6f * t, 0), v3(x, y - 1.6f * t, 0), 0.7f * t);
    dmg_move(b, 0, y, 0);
    draw_board(b, board, wide, deep, t);
    dmg_use(b, 0);
}

/* Draws an easel: two front legs, a mast whose clamp slides, a ledge, a rear leg that swings out. */
static void draw_easel(dmg_builder* b) {
    float tall = dmg_range(b, 1.2f, 1.9f), x = tall * dmg_range(b, 0.16f, 0.25f), t = 0.025f,
          lean = dmg_range(b, 0.08f, 0.2f), y = 0.4f * tall, spread = dmg_range(b, 0.25f, 0.5f);
    bool canvas = dmg_chance(b, 0.6f), tilts = dmg_chance(b, 0.4f);
    dmg_turn(b, v3(1, 0, 0), -lean);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * x, 0, 0), v3((float)s * 0.15f * x, 0.95f * tall, 0), t, t);
    dmg_beam(b, v3(-0.8f * x, 0.25f * tall, 0), v3(0.8f * x, 0.25f * tall, 0), 0.9f * t, t);
    dmg_beam(b, v3(0, 0.2f * tall, 0.5f * t), v3(0, tall, 0.5f * t), t, t);
    dmg_hinge(b, 0, "rear_leg", v3(0, 0.9f * tall, -t), v3(1, 0, 0), 0.0f, spread);
    dmg_beam(b, v3(0, 0.9f * tall, -t), v3(0, 0.01f * tall, -t), t, t);
    dmg_rod(b, v3(-2 * t, 0.9f * tall, -t), v3(2 * t, 0.9f * tall, -t), 0.5f * t);
    dmg_use(b, 0);
    uint32_t ledge = dmg_slide(b, 0, "ledge", v3(0, 1, 0), -0.15f * tall, 0.15f * tall);
    dmg_box_span(b, v3(-1.1f * x, y - t, 1.1f * t), v3(1.1f * x, y, 4 * t));
    if (tilts && canvas) dmg_hinge(b, ledge, "canvas", v3(0, y, 1.5f * t), v3(1, 0, 0), 0.0f, 0.25f);
    if (canvas) dmg_box_span(b, v3(-1.3f * x, y + 0.002f, 1.3f * t), v3(1.3f * x, y + 0.4f * tall, 2 * t));
    dmg_use(b, 0);
    dmg_slide(b, 0, "clamp", v3(0, 1, 0), canvas ? 0.0f : -0.1f * tall, 0.1f * tall);
    dmg_box_span(b, v3(-1.5f * t, y + 0.41f * tall, -0.1f * t), v3(1.5f * t, y + 0.45f * tall, 3 * t));
    dmg_use(b, 0);
}

void dmg_build_drafting_table(dmg_builder* b) {
    if (dmg_chance(b, 0.75f))
        draw_drafting_desk(b);
    else
        draw_easel(b);
}

/* ---- telephones ---- */

/* Ear and mouth at the ends of a grip along X, its underside at y = 0. */
static void draw_handset(dmg_builder* b, float length) {
    float r = 0.15f * length, h = 0.5f * length, y = 1.1f * r;
    int kind = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (h - r);
        if (kind == 0) dmg_cone(b, v3(x, 0, 0), v3(x, 0.9f * r, 0), r, 0.7f * r);
        if (kind == 1) dmg_rounded_box(b, v3(x, 0.5f * r, 0), v3(2 * r, r, 1.7f * r), 0.2f * r);
        if (kind == 2) dmg_ellipsoid(b, v3(x, 0.5f * r, 0), v3(r, 0.5f * r, 0.9f * r));
    }
    const dmg_vec grip[] = {v3(-h + 0.8f * r, 0.5f * r, 0), v3(-0.5f * h, y, 0), v3(0, 1.15f * y, 0),
                            v3(0.5f * h, y, 0), v3(h - 0.8f * r, 0.5f * r, 0)};
    dmg_sweep(b, grip, 5, 0.35f * r, 0.5f * r, false);
}

/* Draws a dial with finger holes, or keys, on z = 0 facing +Z. */
static void draw_calling(dmg_builder* b, float r, bool dial) {
    if (!dial) {
        dmg_buttons keys = {.name = "key",
                            .columns = 3,
                            .rows = 4,
                            .pitch_x = 0.55f * r,
                            .pitch_y = 0.45f * r,
                            .width = 0.4f * r,
                            .height = 0.32f * r,
                            .rise = 0.12f * r};
        keys.travel = dmg_button_way(b, keys.rise);
        keys.kind = dmg_int(b, 0, 3);
        dmg_buttons_draw(b, 0, &keys);
        return;
    }
    dmg_rod(b, v3(0, 0, -0.05f * r), v3(0, 0, 0.08f * r), 1.05f * r);
    dmg_hinge(b, 0, "dial", v3(0, 0, 0), v3(0, 0, -1), 0.0f, 5.2f);
    dmg_rod(b, v3(0, 0, 0.09f * r), v3(0, 0, 0.2f * r), 0.45f * r);
    for (int i = 0; i < 10; ++i) {
        float angle = 0.6f + 0.52f * (float)i;
        dmg_torus(b, v3(0.72f * r * cosf(angle), 0.72f * r * sinf(angle), 0.14f * r), v3(0, 0, 1), 0.2f * r, 0.06f * r);
    }
    dmg_use(b, 0);
    dmg_box(b, v3(0.8f * r, -0.6f * r, 0.23f * r), v3(0.3f * r, 0.08f * r, 0.06f * r)); /* the finger stop */
    dmg_box(b, v3(0.97f * r, -0.7f * r, 0.12f * r), v3(0.08f * r, 0.1f * r, 0.25f * r));
}

/* Draws a sloped case; the handset lies across its top on a cradle or along its left side. */
static void draw_sloped_phone(dmg_builder* b) {
    float x = dmg_range(b, 0.09f, 0.14f), z = x * dmg_range(b, 0.8f, 1.1f), front = 0.25f * x,
          high = x * dmg_range(b, 0.6f, 1.1f), back = -0.25f * z, lean = atanf((high - front) / (z - back));
    bool dial = dmg_chance(b, 0.55f), crank = dmg_chance(b, 0.2f), lifts = dmg_chance(b, 0.6f);
    const dmg_xy side[] = {{-z, 0}, {z, 0}, {z, front}, {back, high}, {-z, high}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_extrude(b, side, 5, -x, x);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (front + high), 0.5f * (z + back));
    dmg_turn(b, v3(1, 0, 0), lean - 0.5f * DMG_PI);
    draw_calling(b, 0.42f * fminf(1.5f * x, z - back), dial);
    dmg_restore(b);
    float seat = high + 0.2f * x, mid = 0.5f * (back - z);
    for (int s = -1; s <= 1; s += 2)
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(0.55f * x * (float)s - 0.08f * x, 0.99f * high, mid + 0.28f * x * (float)k - 0.05f * x),
                         v3(0.55f * x * (float)s + 0.08f * x, seat + 0.1f * x, mid + 0.28f * x * (float)k + 0.05f * x));
    for (int s = -1; s <= 1; s += 2) {
        dmg_slide(b, 0, "hook", v3(0, -1, 0), 0.0f, 0.06f * x);
        dmg_rod(b, v3(0.35f * x * (float)s, high - 0.1f * x, mid), v3(0.35f * x * (float)s, seat - 0.03f * x, mid),
                0.08f * x);
        dmg_use(b, 0);
    }
    if (crank) {
        dmg_spin(b, 0, "crank", v3(0, 0.5f * high, -0.3f * z), v3(1, 0, 0));
        dmg_rod(b, v3(x, 0.5f * high, -0.3f * z), v3(1.2f * x, 0.5f * high, -0.3f * z), 0.05f * x);
        dmg_beam(b, v3(1.18f * x, 0.5f * high, -0.3f * z), v3(1.18f * x, 0.5f * high, 0.2f * z), 0.05f * x, 0.1f * x);
        dmg_rod(b, v3(1.16f * x, 0.5f * high, 0.18f * z), v3(1.45f * x, 0.5f * high, 0.18f * z), 0.06f * x);
        dmg_use(b, 0);
    }
    dmg_move(b, 0, seat, mid);
    if (lifts) dmg_slide(b, 0, "handset", v3(0, 1, 0), 0.0f, x * dmg_range(b, 0.6f, 2.0f));
    draw_handset(b, 2.3f * x);
    dmg_use(b, 0);
}

/* Draws a flat set with keys and a screen that tilts, on a stand that folds out; the handset at the left. */
static void draw_desk_set(dmg_builder* b) {
    float x = dmg_range(b, 0.09f, 0.14f), z = x * dmg_range(b, 0.8f, 1.0f), t = 0.25f * x,
          lean = dmg_range(b, 0.1f, 0.4f), screen = 0.35f * z;
    bool flash = dmg_chance(b, 0.5f), tilts = dmg_chance(b, 0.7f);
    dmg_move(b, 0, 0.02f, z);
    dmg_turn(b, v3(1, 0, 0), lean);
    dmg_move(b, 0, 0, -z);
    dmg_rounded_box(b, v3(0, 0.5f * t, 0), v3(2 * x, t, 2 * z), 0.2f * t);
    dmg_hinge(b, 0, "stand", v3(0, -0.002f, -0.2f * z), v3(-1, 0, 0), -0.1f, 0.9f - lean);
    dmg_beam(b, v3(0, -0.006f, -0.2f * z), v3(0, -0.008f - 0.9f * z * sinf(lean), -0.8f * z), 1.4f * x, 0.006f);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0.35f * x, t, 0.35f * z);
    dmg_face_up(b);
    draw_calling(b, 0.5f * x, false);
    dmg_restore(b);
    dmg_vec pin = v3(0.35f * x, t, -0.95f * z);
    uint32_t panel = tilts ? dmg_hinge(b, 0, "screen", pin, v3(-1, 0, 0), 0.0f, 1.2f) : 0;
    dmg_box_span(b, v3(-0.2f * x, t + 0.002f, -0.95f * z), v3(0.95f * x, t + 0.12f * x, -0.95f * z + 2 * screen));
    if (flash) {
        dmg_slide(b, panel, "soft_key", v3(0, -1, 0), 0.0f, 0.004f);
        dmg_box(b, v3(0.35f * x, t + 0.13f * x, -0.95f * z + 1.8f * screen), v3(0.3f * x, 0.03f * x, 0.1f * x));
    }
    dmg_use(b, 0);
    float at = -0.62f * x;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(at - 0.25f * x, 0.98f * t, 0.6f * z * (float)s - 0.12f * z),
                     v3(at + 0.25f * x, t + 0.05f * x, 0.6f * z * (float)s + 0.12f * z));
    bool tips = dmg_chance(b, 0.4f);
    if (tips) /* as games have it: it is tipped up off its rest */
        dmg_hinge(b, 0, "handset", v3(0, t + 0.06f * x, -z), v3(-1, 0, 0), 0.0f, 1.2f);
    else
        dmg_slide(b, 0, "handset", v3(0, 1, 0), 0.0f, x);
    dmg_move(b, at, t + 0.055f * x, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    draw_handset(b, 2 * z);
    dmg_use(b, 0);
}

/* Draws an upright stick: the receiver hangs on a hook that turns, the dial in the foot, the mouthpiece tilts. */
static void draw_candlestick(dmg_builder* b) {
    float tall = dmg_range(b, 0.25f, 0.34f), r = tall * dmg_range(b, 0.2f, 0.27f), pole = 0.05f * tall,
          y = 0.78f * tall;
    bool dial = dmg_chance(b, 0.6f);
    const dmg_xy foot[] = {
        {0, 0},          {r, 0}, {r, 0.1f * tall}, {0.5f * r, 0.18f * tall}, {pole, 0.24f * tall}, {pole, 0.9f * tall},
        {0, 0.9f * tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), foot, 7);
    dmg_save(b);
    dmg_move(b, 0, 0.13f * tall, 0.75f * r);
    dmg_turn(b, v3(1, 0, 0), -0.9f);
    if (dial) draw_calling(b, 0.5f * r, true);
    dmg_restore(b);
    dmg_hinge(b, 0, "mouthpiece", v3(0, 0.93f * tall, 0), v3(-1, 0, 0), -0.4f, 0.5f);
    dmg_ellipsoid(b, v3(0, 0.95f * tall, 0), v3(1.5f * pole, 1.5f * pole, 1.5f * pole));
    dmg_cone(b, v3(0, 0.95f * tall, pole), v3(0, 0.97f * tall, 4 * pole), pole, 2 * pole);
    dmg_use(b, 0);
    uint32_t hook = dmg_hinge(b, 0, "hook", v3(-pole, y, 0), v3(0, 0, -1), 0.0f, 0.3f);
    dmg_beam(b, v3(-0.8f * pole, y, 0), v3(-3.5f * pole, y, 0), 0.8f * pole, 0.4f * pole);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3(-3.4f * pole, y, 0.3f * pole * (float)s), v3(-5.5f * pole, y, 0.8f * pole * (float)s),
                 0.3f * pole, 0.4f * pole);
    dmg_slide(b, hook, "receiver", v3(-1, 0, 0), 0.0f, 0.3f * tall);
    dmg_rod(b, v3(-4.8f * pole, y + 0.25f * pole, 0), v3(-4.8f * pole, y + 2 * pole, 0), 1.1f * pole);
    dmg_rod(b, v3(-4.8f * pole, y - 6 * pole, 0), v3(-4.8f * pole, y + 0.25f * pole, 0), 0.6f * pole);
    dmg_cone(b, v3(-4.8f * pole, y - 8 * pole, 0), v3(-4.8f * pole, y - 6 * pole, 0), 1.6f * pole, 0.6f * pole);
    dmg_use(b, 0);
}

void dmg_build_desk_phone(dmg_builder* b) {
    switch (dmg_weighted(b, (const float[]){3, 3, 1}, 3)) {
    case 0:
        draw_sloped_phone(b);
        break;
    case 1:
        draw_desk_set(b);
        break;
    default:
        draw_candlestick(b);
        break;
    }
}
