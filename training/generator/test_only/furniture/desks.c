/* Draws telephones of a desk. */
#include "core/build.h"
#include "parts/hardware.h"

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
