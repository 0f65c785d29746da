/* Draws the inside of a car: the dash with its glove box, vents and column, the console between the seats, seats on
 * rails, visors and handles under the roof, the doors from within. Occupants look to -Z; the driver is at -X (or all
 * is mirrored). */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"
#include "vehicles/vehicle_seats.h"

typedef struct cabin {
    float half, top, face, deep; /* of the dash: half width, height, lower edge, depth */
    float console;               /* height of the tunnel between the seats */
    float seat, back;            /* height of the cushion; z of the seats' hinge */
    float t;
} cabin;

static cabin pick_cabin(dmg_builder* b) {
    cabin c = {.half = dmg_range(b, 0.6f, 0.8f), .top = dmg_range(b, 0.6f, 0.8f)};
    c.face = c.top - dmg_range(b, 0.3f, 0.42f);
    c.deep = dmg_range(b, 0.3f, 0.5f);
    c.console = dmg_range(b, 0.14f, 0.34f);
    c.seat = dmg_range(b, 0.22f, 0.34f);
    c.back = dmg_range(b, 0.85f, 1.05f);
    c.t = dmg_range(b, 0.012f, 0.025f);
    return c;
}

/* ---- the dash: face at z = 0 ---- */

/* Draws a lid before the opening from x0 to x1, y0 to y1; its bin comes with it, or is a hole, or it is a drawer. */
static void draw_glove_box(dmg_builder* b, const cabin* c, float x0, float x1, float y0, float y1) {
    float wide = x1 - x0, high = y1 - y0, deep = fminf(0.7f * c->deep, 0.8f * high), mid = 0.5f * (x0 + x1), t = c->t;
    int kind = dmg_weighted(b, (const float[]){4, 2, 1.5f, 1.5f}, 4);
    bool proud = dmg_chance(b, 0.5f);
    float back = proud ? 0.0f : -t, front = back + t;
    if (kind < 2)
        dmg_hinge(b, 0, "glove_box", v3(0, y0, proud ? 0.5f * t : back), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.4f));
    if (kind == 2) dmg_slide(b, 0, "glove_box", v3(0, 0, 1), 0.0f, 0.8f * deep);
    if (kind == 3) dmg_hinge(b, 0, "glove_box", v3(0, y1, front), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.6f));
    float over = proud ? 0.4f * t : -0.3f * t, low = y0 + (kind < 2 ? 0.1f * t : -over);
    dmg_box_span(b, v3(x0 - over, low, back), v3(x1 + over, y1 + over, front));
    if (kind == 0) { /* a quarter drum, so that it clears the edge above */
        dmg_xy cheek[6] = {{back, y0 + 0.1f * t}, {back, y0 + 0.93f * high}};
        for (int i = 1; i < 5; ++i) {
            float z = deep * 0.25f * (float)i;
            cheek[1 + i] = (dmg_xy){back - z, y0 + 0.93f * sqrtf(high * high - z * z)};
        }
        dmg_xy outline[7];
        for (int i = 0; i < 6; ++i) outline[i] = cheek[i];
        outline[6] = (dmg_xy){back - deep, y0 + 0.1f * t};
        for (int s = -1; s <= 1; s += 2)
            dmg_side_prism(b, outline, 7, mid + (float)s * 0.46f * wide, mid + (float)s * (0.46f * wide - 0.5f * t));
        dmg_box_span(b, v3(mid - 0.46f * wide, y0 + 0.1f * t, back - deep),
                     v3(mid + 0.46f * wide, y0 + 0.6f * t, back));
        dmg_box_span(b, v3(mid - 0.46f * wide, y0 + 0.1f * t, back - deep),
                     v3(mid + 0.46f * wide, outline[5].y, back - deep + 0.5f * t));
    }
    if (kind == 2) {
        dmg_save(b);
        dmg_move(b, mid, y0 + 0.1f * high, back);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.94f * wide, 0.7f * high, deep, 0.4f * t);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.7f)) { /* a catch, or a lip to pull */
        float y = kind == 3 ? y0 + 0.12f * high : y1 - 0.12f * high;
        dmg_rounded_box(b, v3(mid, y, front + 0.2f * t), v3(0.18f * wide, 0.08f * high, 0.6f * t), 0.15f * t);
    }
    dmg_use(b, 0);
}

/* From x0 to x1, the whole height: straight, sloping, or rounded over. */
static void draw_dash_section(dmg_builder* b, const cabin* c, int shape, float x0, float x1) {
    float d = c->deep, r = 0.3f * (c->top - c->face);
    const dmg_xy straight[] = {{-d, c->face}, {0, c->face}, {0, c->top}, {-d, c->top}};
    const dmg_xy sloped[] = {{-d, c->face},   {-0.5f * r, c->face}, {0, c->face + 0.4f * r},
                             {0, c->top - r}, {-r, c->top},         {-d, c->top}};
    if (shape == 0) dmg_side_prism(b, straight, 4, x0, x1);
    if (shape == 1) dmg_side_prism(b, sloped, 6, x0, x1);
}

/* Vents: a round one that swivels, or a frame with slats that tip together, or each its own. */
static void draw_vent(dmg_builder* b, float x, float y, float size, int kind) {
    dmg_save(b);
    dmg_move(b, x, y, 0);
    if (kind == 0) {
        const dmg_xy ring[] = {
            {0.85f * size, 0}, {size, 0}, {size, 0.25f * size}, {0.85f * size, 0.25f * size}, {0.85f * size, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
        if (dmg_chance(b, 0.5f))
            dmg_spin(b, 0, "vent", v3(0, 0, 0), v3(0, 0, 1));
        else
            dmg_hinge(b, 0, "vent", v3(0, 0, 0.1f * size), v3(1, 0, 0), -0.3f, 0.3f);
        dmg_ellipsoid(b, v3(0, 0, 0.1f * size), v3(0.75f * size, 0.75f * size, 0.2f * size));
        dmg_box(b, v3(0, 0, 0.3f * size), v3(1.2f * size, 0.08f * size, 0.2f * size));
    } else {
        int slats = kind == 1 ? 1 : 3;
        dmg_frame_draw(b, 2.4f * size, 1.6f * size, 0.4f * size, 0.15f * size);
        for (int i = 0; i < slats; ++i) {
            float at = kind == 1 ? 0.0f : 0.4f * size * (float)(i - 1);
            dmg_hinge(b, 0, "vent_slat", v3(0, at, 0.1f * size), v3(1, 0, 0), -0.5f, 0.5f);
            dmg_box(b, v3(0, at, 0.15f * size), v3(2.0f * size, 0.06f * size, 0.3f * size));
            if (i == slats / 2)
                dmg_box(b, v3(0.2f * size, at, 0.35f * size), v3(0.2f * size, 0.12f * size, 0.15f * size));
            dmg_use(b, 0);
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* In the middle: knobs or buttons, an ash tray that tips, a holder that slides out, a screen that stands up. */
static void draw_centre(dmg_builder* b, const cabin* c, float x0, float x1) {
    float wide = x1 - x0, mid = 0.5f * (x0 + x1), high = c->top - c->face, y = c->top - 0.32f * high;
    int vent = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1 && vent; s += 2)
        draw_vent(b, mid + (float)s * 0.25f * wide, y, 0.09f * wide, dmg_int(b, 1, 2));
    if (!vent) dmg_box(b, v3(mid, y, 0), v3(0.8f * wide, 0.25f * high, 0.03f));
    y -= 0.28f * high;
    dmg_save(b);
    dmg_move(b, mid, y, 0);
    dmg_controls_draw(b, 0, 0.8f * wide, 0.2f * high);
    dmg_restore(b);
    y -= 0.2f * high;
    int kind = dmg_int(b, 0, 3);
    dmg_vec low = {mid - 0.3f * wide, y - 0.06f * high, 0.001f}, tip = {mid + 0.3f * wide, y + 0.06f * high, 0.012f};
    if (kind == 0) dmg_hinge(b, 0, "ash_tray", v3(0, low.y, 0.006f), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.1f));
    if (kind == 1) dmg_slide(b, 0, "cup_holder", v3(0, 0, 1), 0.0f, dmg_range(b, 0.06f, 0.12f));
    if (kind < 2) dmg_box_span(b, low, tip);
    if (kind == 1) dmg_box_span(b, v3(low.x, low.y, -0.13f), v3(tip.x, low.y + 0.03f * high, 0.006f));
    dmg_use(b, 0);
    if (kind == 3) {
        float tall = dmg_range(b, 0.1f, 0.16f);
        dmg_hinge(b, 0, "screen", v3(0, c->top + 0.01f, -0.12f), v3(-1, 0, 0), -0.2f, 1.4f);
        dmg_box_span(b, v3(mid - 0.4f * wide, c->top + 0.008f, -0.13f), v3(mid + 0.4f * wide, c->top + tall, -0.11f));
        dmg_use(b, 0);
    }
}

/* ---- the driver's: column, wheel, stalks, key, pedals ---- */

static void draw_column(dmg_builder* b, const cabin* c, float x) {
    float radius = dmg_range(b, 0.15f, 0.21f), reach = dmg_range(b, 0.18f, 0.3f), lean = dmg_range(b, 0.2f, 0.6f);
    uint32_t column = 0;
    dmg_save(b);
    dmg_move(b, x, c->face + 0.35f * (c->top - c->face), 0);
    dmg_turn(b, v3(1, 0, 0), -lean);
    int tilts = dmg_int(b, 0, 3);
    if (tilts == 0) column = dmg_hinge(b, 0, "column", v3(0, 0, -0.05f), v3(-1, 0, 0), -0.12f, 0.12f);
    if (tilts == 1) column = dmg_slide(b, 0, "column", v3(0, 0, 1), -0.03f, 0.05f);
    dmg_rod(b, v3(0, 0, -0.15f), v3(0, 0, reach), 0.022f);
    dmg_rounded_box(b, v3(0, 0, 0.45f * reach), v3(0.1f, 0.1f, 0.6f * reach), 0.02f);
    int stalks = dmg_int(b, 0, 2);
    for (int i = 0; i < stalks; ++i) {
        float s = i ? 1.0f : -1.0f;
        dmg_vec root = {s * 0.045f, 0.01f, 0.65f * reach};
        if (dmg_chance(b, 0.6f))
            dmg_hinge(b, column, "stalk", root, v3(0, 0, s), -0.2f, 0.2f);
        else
            dmg_hinge(b, column, "stalk", root, v3(0, s, 0), -0.2f, 0.15f);
        dmg_cone(b, root, v3_add(root, v3(s * 0.12f, 0.01f, 0.01f)), 0.006f, 0.01f);
        dmg_use(b, column);
    }
    if (dmg_chance(b, 0.5f)) {
        dmg_vec lock = {0.05f, -0.02f, 0.3f * reach};
        dmg_hinge(b, column, "key", lock, v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.1f));
        dmg_rod(b, lock, v3_add(lock, v3(0.02f, 0, 0)), 0.012f);
        dmg_box(b, v3_add(lock, v3(0.035f, 0, 0)), v3(0.03f, 0.03f, 0.005f));
        dmg_use(b, column);
    }
    const float lower = -dmg_range(b, 2.0f, 8.0f);
    const dmg_vec axis = v3(0, 0, dmg_sign(b));
    dmg_hinge(b, column, "steering_wheel", v3(0, 0, 0), axis, lower, 4.0f);
    dmg_move(b, 0, 0, reach + 0.015f);
    dmg_wheel_draw(b, 3, radius, 0.035f, dmg_int(b, 2, 4));
    if (dmg_chance(b, 0.6f)) dmg_rounded_box(b, v3(0, 0, 0.01f), v3(0.5f * radius, 0.4f * radius, 0.04f), 0.015f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Hung under the dash or standing on the floor. */
static void draw_foot_pedals(dmg_builder* b, const cabin* c, float x) {
    int count = dmg_int(b, 2, 3), arm = dmg_int(b, 0, 1);
    bool hung = dmg_chance(b, 0.65f);
    for (int i = 0; i < count; ++i) {
        float px = x + 0.11f * ((float)i - 0.5f * (float)(count - 1)), y = hung ? c->face - 0.02f : 0.02f;
        dmg_vec pin = {px, y, -0.12f}, pad = {px, hung ? 0.12f : 0.2f, hung ? -0.06f : -0.1f};
        dmg_box(b, v3(px - 0.022f, y, -0.12f), v3(0.01f, 0.06f, 0.05f));
        dmg_hinge(b, 0, "pedal", pin, v3(hung ? 1.0f : -1.0f, 0, 0), 0.0f, dmg_range(b, 0.2f, 0.4f));
        dmg_rod(b, v3_add(pin, v3(-0.02f, 0, 0)), v3_add(pin, v3(0.02f, 0, 0)), 0.012f);
        bool long_pad = i == count - 1 && dmg_chance(b, 0.6f);
        if (arm || hung) dmg_beam(b, pin, pad, 0.012f, 0.02f);
        dmg_beam(b, v3_add(pad, v3(0, long_pad ? -0.09f : -0.03f, 0.03f)),
                 v3_add(pad, v3(0, long_pad ? 0.09f : 0.03f, 0)), long_pad ? 0.05f : 0.07f, 0.015f);
        if (!arm && !hung) dmg_beam(b, pin, v3_add(pad, v3(0, -0.09f, 0.03f)), 0.05f, 0.012f);
        dmg_use(b, 0);
    }
}

static void draw_dash(dmg_builder* b, const cabin* c) {
    int shape = dmg_int(b, 0, 1), vent = dmg_int(b, 0, 2);
    float in = dmg_range(b, 0.08f, 0.14f), y0 = c->face + 0.04f, y1 = y0 + 0.6f * (c->top - c->face),
          edge = c->half - 0.06f;
    float driver = -0.5f * (c->half + in);
    draw_dash_section(b, c, shape, -c->half, in);
    dmg_box_span(b, v3(-in, 0, -c->deep), v3(in, c->face, -0.02f));
    draw_dash_section(b, c, 0, in, in + 0.03f); /* round the opening */
    draw_dash_section(b, c, 0, edge, c->half);
    dmg_box_span(b, v3(in + 0.03f, y1, -c->deep), v3(edge, c->top, shape ? -0.02f : 0.0f));
    dmg_box_span(b, v3(in + 0.03f, c->face, -c->deep), v3(edge, y0, 0));
    dmg_box_span(b, v3(in + 0.03f, y0, -c->deep), v3(edge, y1, -0.9f * c->deep));
    draw_glove_box(b, c, in + 0.035f, edge - 0.005f, y0 + 0.004f, y1 - 0.004f);
    draw_centre(b, c, -in, in);
    draw_column(b, c, driver);
    if (dmg_chance(b, 0.7f)) draw_foot_pedals(b, c, driver);
    for (int s = -1; s <= 1 && vent < 2; s += 2)
        draw_vent(b, (float)s * (c->half - 0.09f), c->top - 0.25f * (c->top - c->face), 0.035f, s > 0 ? 0 : vent);
    dmg_box(b, v3(driver, c->top + 0.02f, -0.12f), v3(0.32f, 0.1f, 0.2f)); /* the binnacle */
}

/* ---- between the seats ---- */

/* Draws a stick that tips over its foot, or a selector that slides in a slot: the boot of one is round, the other's
 * gate long. */
static void draw_gear_lever(dmg_builder* b, const cabin* c, float z) {
    float y = c->console, tall = dmg_range(b, 0.08f, 0.25f), knob = dmg_range(b, 0.015f, 0.028f),
          lean = dmg_range(b, -0.2f, 0.3f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 3) { /* a selector that is turned */
        dmg_rod(b, v3(0, y - 0.01f, z), v3(0, y + 0.004f, z), 0.045f);
        dmg_hinge(b, 0, "selector", v3(0, 0, z), v3(0, 1, 0), 0.0f, dmg_range(b, 1.0f, 2.5f));
        dmg_rod(b, v3(0, y + 0.005f, z), v3(0, y + 0.03f, z), 0.032f);
        dmg_box(b, v3(0, y + 0.035f, z), v3(0.012f, 0.012f, 0.055f));
        dmg_use(b, 0);
        return;
    }
    if (kind == 2) {
        float way = dmg_range(b, 0.06f, 0.12f);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.02f, y + 0.003f, z), v3(0.022f, 0.008f, 1.3f * way));
        dmg_slide(b, 0, "selector", v3(0, 0, 1), -0.5f * way, 0.5f * way);
        dmg_box(b, v3(0, y + 0.3f * tall, z), v3(0.012f, 0.6f * tall, 0.018f));
        dmg_rounded_box(b, v3(0, y + 0.65f * tall, z), v3(0.05f, 0.03f, 0.05f), 0.01f);
        dmg_use(b, 0);
        return;
    }
    bool boot = dmg_chance(b, 0.5f);
    if (!boot) dmg_rod(b, v3(0, y - 0.01f, z), v3(0, y + 0.006f, z), 0.04f);
    dmg_hinge(b, 0, "gear_lever", v3(0, y, z), kind ? v3(0, 0, 1) : v3(1, 0, 0), -0.3f, 0.3f);
    dmg_vec tip = {0, y + tall, z + lean * tall};
    dmg_cone(b, v3(0, y, z), tip, 0.009f, 0.006f);
    if (boot) dmg_cone(b, v3(0, y + 0.002f, z), v3_lerp(v3(0, y, z), tip, 0.6f), 0.045f, 0.012f);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, tip, v3(knob, 1.1f * knob, knob));
    else
        dmg_rounded_box(b, tip, v3(1.6f * knob, 3 * knob, 2 * knob), 0.4f * knob);
    dmg_use(b, 0);
}

/* Draws a lever between the seats, its button in its end; or a pull handle under the dash that comes straight out. */
static void draw_hand_brake(dmg_builder* b, const cabin* c, float z) {
    if (dmg_chance(b, 0.25f)) {
        dmg_vec at = {-0.1f - 0.05f, c->face - 0.03f, -0.1f};
        dmg_box(b, v3_add(at, v3(0, 0.02f, 0)), v3(0.05f, 0.05f, 0.1f));
        dmg_slide(b, 0, "hand_brake", v3(0, -0.25f, 1), 0.0f, dmg_range(b, 0.06f, 0.15f));
        dmg_rod(b, at, v3_add(at, v3(0, -0.03f, 0.12f)), 0.01f);
        dmg_rod(b, v3_add(at, v3(-0.05f, -0.03f, 0.12f)), v3_add(at, v3(0.05f, -0.03f, 0.12f)), 0.012f);
        dmg_use(b, 0);
        return;
    }
    float x = dmg_chance(b, 0.5f) ? 0.0f : 0.03f, y = c->console + 0.012f, length = dmg_range(b, 0.2f, 0.32f);
    dmg_vec pin = {x, y, z + length}, tip = {x, y + 0.04f, z};
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(x + (float)s * 0.018f, y, pin.z), v3(0.008f, 0.04f, 0.05f));
    uint32_t brake = dmg_hinge(b, 0, "hand_brake", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.8f));
    dmg_beam(b, pin, v3_lerp(pin, tip, 0.5f), 0.014f, 0.018f);
    dmg_rod(b, v3_lerp(pin, tip, 0.4f), tip, 0.014f);
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, brake, "release", v3_sub(pin, tip), 0.0f, 0.012f);
        dmg_rod(b, v3_lerp(pin, tip, 0.95f), v3_lerp(pin, tip, 1.07f), 0.008f);
    }
    dmg_use(b, 0);
}

/* Draws a box with a lid to rest the arm on, hinged behind or aside, or a shutter that slides back. */
static void draw_arm_box(dmg_builder* b, const cabin* c, float z0, float z1) {
    float x = 0.09f, y = c->console, high = dmg_range(b, 0.06f, 0.18f), t = 0.025f;
    int kind = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, 0, y + high, 0.5f * (z0 + z1));
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * x, z1 - z0, high, 0.012f);
    dmg_restore(b);
    float top = y + high;
    if (kind == 0) dmg_hinge(b, 0, "arm_rest", v3(0, top + 0.2f * t, z1), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.9f));
    if (kind == 1) dmg_hinge(b, 0, "arm_rest", v3(x, top + 0.2f * t, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 1.0f, 1.7f));
    if (kind == 2) dmg_slide(b, 0, "shutter", v3(0, 0, 1), 0.0f, 0.8f * (z1 - z0));
    if (kind == 3) dmg_slide(b, 0, "arm_rest", v3(0, 0, -1), 0.0f, 0.3f * (z1 - z0));
    dmg_rounded_box(b, v3(0, top + 0.5f * t, 0.5f * (z0 + z1)), v3(2 * x + 0.004f, kind == 2 ? 0.4f * t : t, z1 - z0),
                    0.2f * t);
    dmg_use(b, 0);
}

static void draw_console(dmg_builder* b, const cabin* c) {
    float z = 0.0f, wide = 0.18f, end = c->back + dmg_range(b, -0.1f, 0.3f);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * wide, 0, -0.02f), v3(0.5f * wide, c->console, end));
    else {
        const dmg_xy side[] = {
            {-0.02f, 0}, {end, 0}, {end, c->console}, {0.2f, c->console}, {-0.02f, 1.3f * c->console}};
        dmg_side_prism(b, side, 5, -0.5f * wide, 0.5f * wide);
    }
    draw_gear_lever(b, c, z + 0.25f);
    if (dmg_chance(b, 0.75f)) draw_hand_brake(b, c, 0.38f);
    if (dmg_chance(b, 0.6f)) draw_arm_box(b, c, 0.75f, end - 0.02f);
}

/* ---- above: visors on a rod, the mirror, handles, a sun roof ---- */

/* At the upper edge of the screen; it turns down about its rod, and with the rod to the side. */
static void draw_visor(dmg_builder* b, float x, float y, float z, float wide) {
    float high = dmg_range(b, 0.13f, 0.18f), t = dmg_range(b, 0.012f, 0.025f), s = x < 0 ? -1.0f : 1.0f;
    uint32_t rod = 0;
    dmg_vec root = {x + s * 0.5f * wide, y, z};
    dmg_box(b, v3_add(root, v3(0, 0.02f, 0)), v3(0.03f, 0.04f, 0.04f));
    if (dmg_chance(b, 0.5f)) rod = dmg_hinge(b, 0, "visor_arm", root, v3(0, s, 0), 0.0f, dmg_range(b, 0.9f, 1.5f));
    dmg_rod(b, root, v3_add(root, v3(-s * wide, 0, 0)), 0.006f);
    const float upper = dmg_range(b, 1.2f, 1.5f), lower = -dmg_range(b, 0.3f, 0.6f);
    uint32_t visor = dmg_hinge(b, rod, "visor", root, v3(1, 0, 0), lower, upper);
    dmg_rounded_box(b, v3(x - s * 0.02f, y - 0.02f, z + 0.5f * high), v3(0.92f * wide, t, high), 0.3f * t);
    if (dmg_chance(b, 0.4f)) { /* the flap over its mirror */
        float low = y - 0.02f - 0.5f * t;
        dmg_hinge(b, visor, "visor_flap", v3(0, low, z + 0.2f * high), v3(1, 0, 0), 0.0f, dmg_range(b, 0.9f, 2.0f));
        dmg_box_span(b, v3(x - 0.2f * wide, low - 0.006f, z + 0.2f * high), v3(x + 0.2f * wide, low, z + 0.8f * high));
    }
    dmg_use(b, 0);
}

static void draw_roof(dmg_builder* b, const cabin* c) {
    float y = c->top + dmg_range(b, 0.4f, 0.5f), z = dmg_range(b, -0.05f, 0.2f), x = 0.9f * c->half,
          deep = dmg_range(b, 0.25f, 1.0f);
    int sun = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * x, c->top, -0.8f * c->deep), v3((float)s * x, y + 0.05f, z), 0.04f, 0.06f);
    dmg_box_span(b, v3(-x - 0.02f, y + 0.035f, z - 0.03f), v3(x + 0.02f, y + 0.07f, z + 0.12f));
    if (deep > 0.5f) {
        float in = sun ? 0.55f * x : 0.0f;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(fminf((float)s * in, (float)s * x), y + 0.035f, z + 0.12f),
                         v3(fmaxf((float)s * in, (float)s * x), y + 0.07f, z + deep));
        if (sun == 1) dmg_slide(b, 0, "sun_roof", v3(0, 0, 1), 0.0f, 0.7f * (deep - 0.12f));
        if (sun == 2)
            dmg_hinge(b, 0, "sun_roof", v3(0, y + 0.08f, z + 0.13f), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.1f, 0.4f));
        if (sun) dmg_box_span(b, v3(-in - 0.02f, y + 0.072f, z + 0.1f), v3(in + 0.02f, y + 0.085f, z + deep));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1; s += 2) draw_visor(b, (float)s * 0.45f * c->half, y, z + 0.03f, 0.55f * c->half);
    if (dmg_chance(b, 0.7f)) {
        dmg_vec ball = {0, y - 0.06f, z + 0.03f};
        dmg_rod(b, v3(0, y + 0.04f, z - 0.01f), ball, 0.007f);
        if (dmg_chance(b, 0.5f))
            dmg_hinge(b, 0, "mirror", ball, v3(0, 1, 0), -0.6f, 0.6f);
        else
            dmg_hinge(b, 0, "mirror", ball, v3(1, 0, 0), -0.4f, 0.4f);
        dmg_rounded_box(b, v3_add(ball, v3(0, 0, 0.015f)), v3(0.24f, 0.065f, 0.02f), 0.008f);
        dmg_use(b, 0);
    }
    if (deep < 0.6f || dmg_chance(b, 0.3f)) return;
    for (int s = -1; s <= 1; s += 2) { /* handles that swing down */
        float px = (float)s * (x - 0.03f), pz = z + 0.35f;
        dmg_hinge(b, 0, "grab_handle", v3(px, y + 0.02f, 0), v3(0, 0, (float)s), 0.0f, dmg_range(b, 0.8f, 1.4f));
        const dmg_vec bow[] = {{px, y + 0.03f, pz},
                               {px - (float)s * 0.05f, y + 0.012f, pz + 0.02f},
                               {px - (float)s * 0.05f, y + 0.012f, pz + 0.16f},
                               {px, y + 0.03f, pz + 0.18f}};
        dmg_sweep(b, bow, 4, 0.008f, 0.008f, false);
        dmg_use(b, 0);
    }
}

/* ---- a door from within: pane, crank, latch, pocket, arm rest ---- */

static void draw_trim(dmg_builder* b, uint32_t door, float x, float belt, float z0, float z1) {
    float long_ = z1 - z0, y = 0.6f * belt;
    dmg_box_span(b, v3(x - 0.05f, y - 0.03f, z0 + 0.35f * long_), v3(x, y, z0 + 0.85f * long_));
    dmg_vec latch = {x - 0.004f, 0.78f * belt, z0 + 0.25f * long_};
    dmg_box(b, latch, v3(0.008f, 0.05f, 0.13f));
    if (dmg_chance(b, 0.6f))
        dmg_hinge(b, door, "latch", v3_add(latch, v3(-0.008f, 0, -0.05f)), v3(0, 1, 0), -dmg_range(b, 0.4f, 0.8f),
                  0.0f);
    else
        dmg_hinge(b, door, "latch", v3_add(latch, v3(-0.008f, 0, -0.05f)), v3(1, 0, 0), -0.5f, 0.5f);
    dmg_box_span(b, v3_add(latch, v3(-0.014f, -0.01f, -0.06f)), v3_add(latch, v3(-0.006f, 0.01f, 0.05f)));
    dmg_use(b, door);
    if (dmg_chance(b, 0.55f)) { /* a crank for the pane */
        float angle = dmg_range(b, 0, 6.2f), arm = dmg_range(b, 0.07f, 0.11f);
        dmg_vec hub = {x, 0.42f * belt, z0 + 0.45f * long_},
                end = v3_add(hub, v3(-0.03f, arm * sinf(angle), arm * cosf(angle)));
        dmg_spin(b, door, "window_crank", hub, v3(1, 0, 0));
        dmg_rod(b, hub, v3_add(hub, v3(-0.02f, 0, 0)), 0.02f);
        dmg_beam(b, v3_add(hub, v3(-0.015f, 0, 0)), v3_add(end, v3(0.015f, 0, 0)), 0.01f, 0.02f);
        dmg_rod(b, v3_add(end, v3(0.015f, 0, 0)), v3_add(end, v3(-0.03f, 0, 0)), 0.011f);
        dmg_use(b, door);
    } else {
        int keys = dmg_int(b, 1, 3);
        for (int i = 0; i < keys; ++i) {
            dmg_vec key = {x - 0.03f, y, z0 + 0.5f * long_ + 0.04f * (float)i};
            dmg_hinge(b, door, "window_key", key, v3(1, 0, 0), -0.2f, 0.2f);
            dmg_box(b, v3_add(key, v3(0, 0.004f, 0)), v3(0.02f, 0.012f, 0.028f));
            dmg_use(b, door);
        }
    }
    if (dmg_chance(b, 0.4f)) { /* the pocket's flap */
        float top = 0.32f * belt, low = 0.08f * belt;
        dmg_hinge(b, door, "pocket", v3(x - 0.01f, low, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.3f, 0.7f));
        dmg_box_span(b, v3(x - 0.02f, low, z0 + 0.3f * long_), v3(x - 0.005f, top, z0 + 0.9f * long_));
        dmg_use(b, door);
    }
    if (dmg_chance(b, 0.4f)) { /* the pin that locks it */
        dmg_slide(b, door, "lock_pin", v3(0, 1, 0), -0.015f, 0.005f);
        dmg_rod(b, v3(x + 0.01f, belt - 0.05f, z1 - 0.08f), v3(x + 0.01f, belt + 0.025f, z1 - 0.08f), 0.006f);
        dmg_use(b, door);
    }
}

/* On the side of +X: two skins, the pane between them. */
static void draw_side_door(dmg_builder* b, const cabin* c, bool hung) {
    float x = c->half + 0.02f, belt = c->top, z0 = -0.06f, z1 = z0 + dmg_range(b, 0.85f, 1.15f), t = 0.03f, gap = 0.02f,
          base = 0.08f;
    uint32_t door = 0;
    dmg_box_span(b, v3(x, 0, z0 - 0.14f), v3(x + 2 * t + gap, belt, z0 - 0.01f)); /* the pillar it hangs on */
    if (hung) door = dmg_hinge(b, 0, "door", v3(x + 2 * t + gap, 0, z0), v3(0, 1, 0), 0.0f, dmg_range(b, 0.9f, 1.25f));
    dmg_box_span(b, v3(x, base, z0), v3(x + t, belt, z1));
    dmg_box_span(b, v3(x + t + gap, base, z0), v3(x + 2 * t + gap, belt, z1));
    dmg_box_span(b, v3(x + t, base, z0), v3(x + t + gap, base + t, z1));
    float high = dmg_range(b, 0.34f, 0.42f), in = x + t + 0.5f * gap;
    bool frame = dmg_chance(b, 0.5f);
    if (frame)
        for (int k = 0; k < 2; ++k)
            dmg_beam(b, v3(in, belt - 0.05f, k ? z1 - 0.02f : z0 + 0.05f),
                     v3(in, belt + high, k ? z1 - 0.02f : z0 + 0.3f), 0.02f, 0.03f);
    if (frame) dmg_beam(b, v3(in, belt + high, z0 + 0.29f), v3(in, belt + high, z1 - 0.005f), 0.02f, 0.03f);
    if (dmg_chance(b, 0.8f)) dmg_slide(b, door, "window", v3(0, -1, 0), 0.0f, high * dmg_range(b, 0.7f, 0.95f));
    const dmg_xy pane[] = {{z0 + 0.07f, belt - 0.04f},
                           {z1 - 0.035f, belt - 0.04f},
                           {z1 - 0.035f, belt + high - 0.015f},
                           {z0 + 0.3f, belt + high - 0.015f}};
    dmg_side_prism(b, pane, 4, in - 0.003f, in + 0.003f);
    dmg_use(b, door);
    draw_trim(b, door, x, belt, z0, z1);
    dmg_use(b, 0);
}

/* ---- all of it, or some ---- */

void dmg_build_car_interior(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.75f) ? 1.0f : dmg_scale_range(b, 0.1f, 0.7f));
    cabin c = pick_cabin(b);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    int kind = dmg_weighted(b, (const float[]){3, 3, 2, 1.5f}, 4); /* all, the front alone, with doors, a door alone */
    if (kind == 3) {
        draw_side_door(b, &c, dmg_chance(b, 0.5f));
        return;
    }
    float rear = kind == 1 ? 0.4f : c.back + 0.35f;
    dmg_box_span(b, v3(-c.half, -0.03f, -c.deep), v3(c.half, 0, rear));
    draw_dash(b, &c);
    if (dmg_chance(b, 0.85f)) draw_console(b, &c);
    if (dmg_chance(b, 0.65f)) draw_roof(b, &c);
    for (int k = 0; k < 2 && kind == 2; ++k) {
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        draw_side_door(b, &c, dmg_chance(b, 0.7f));
        dmg_restore(b);
    }
    if (kind == 1) return;
    dmg_seat s = dmg_seat_pick(b);
    s.wide = fminf(s.wide, c.half - 0.2f);
    s.seat = c.seat;
    s.arms = s.arms == 2 ? 2 : 0;
    s.base = s.base == 2 ? 0 : s.base;
    for (int k = -1; k <= 1; k += 2) dmg_seat_draw(b, &s, (float)k * (0.5f * c.half + 0.06f), c.back);
}
