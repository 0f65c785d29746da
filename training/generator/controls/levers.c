/* Draws levers, switches, cranks, valves and sticks: controls that turn about a line or slide in a slot. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a plate or block for a control, front centred at the origin of z = 0. */
static void draw_mount(dmg_builder* b, float width, float height, float depth) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_rounded_plate(b, width, height, depth, 0.15f * fminf(width, height));
    if (kind == 1)
        dmg_rounded_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth),
                        0.2f * fminf(depth, 0.5f * fminf(width, height)));
    if (kind >= 2) dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
    if (kind == 3) dmg_box(b, v3(0, 0, -1.2f * depth), v3(1.3f * width, 1.2f * height, 0.6f * depth));
}

/* Stands the frame's +Z up, forward, or somewhere between. */
static void face_somewhere(dmg_builder* b, float size) {
    int how = dmg_int(b, 0, 2);
    if (how == 0) dmg_face_up(b);
    if (how == 1) dmg_move(b, 0, size, 0);
    if (how == 2) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.3f, 1.2f));
}

/* Draws what the hand holds at a lever's end. */
static void draw_grip(dmg_builder* b, int kind, dmg_vec at, dmg_vec along, float size) {
    if (kind == 0) dmg_ellipsoid(b, at, v3(size, size, size));
    if (kind == 1) dmg_rod(b, v3_mad(at, along, -1.5f * size), v3_mad(at, along, 1.5f * size), 0.7f * size);
    if (kind == 2) dmg_box(b, at, v3(1.6f * size, 1.6f * size, 1.6f * size));
    if (kind == 3) { /* across, as a throttle */
        dmg_vec u, w;
        v3_basis(along, &u, &w);
        dmg_rod(b, v3_mad(at, v3(1, 0, 0), -2 * size), v3_mad(at, v3(1, 0, 0), 2 * size), 0.6f * size);
    }
}

/* ---- lever ---- */

/* Draws a stick on z = 0 that rocks about X in its slot. */
static void draw_stick(dmg_builder* b, float length, float radius, float swing) {
    float below = length * dmg_range(b, 0.0f, 0.25f);
    bool slot = dmg_chance(b, 0.6f);
    if (slot) dmg_frame_draw(b, 5 * radius, 2.2f * (below + 2 * radius) + length * 0.3f, 0.4f * radius, radius);
    uint32_t lever = dmg_hinge(b, 0, "lever", v3(0, 0, -below), v3(-1, 0, 0), -swing, swing);
    int shape = dmg_int(b, 0, 2);
    dmg_vec foot = {0, 0, -below}, top = {0, 0, length};
    if (shape == 0) dmg_rod(b, foot, top, radius);
    if (shape == 1) dmg_beam(b, foot, top, 0.7f * radius, 2.2f * radius);
    if (shape == 2) dmg_cone(b, foot, top, 0.6f * radius, 1.2f * radius);
    int grip = dmg_int(b, 0, 3);
    draw_grip(b, grip, top, v3(0, 0, 1), radius * dmg_range(b, 1.4f, 3.0f));
    int rest = dmg_int(b, 0, 3);
    if (rest == 0) dmg_rest(b, lever, -swing);
    if (rest == 1) dmg_rest(b, lever, dmg_range(b, -swing, swing));
    if (rest == 2) dmg_rest(b, lever, swing);
    dmg_use(b, 0);
}

/* Draws a lever on the side of a box, turning about the axle that sticks out of it: slot machines, signals. */
static void draw_side_lever(dmg_builder* b, float length, float radius) {
    float side = dmg_sign(b), x = side * 2.2f * radius, rested = dmg_range(b, -0.3f, 0.9f);
    dmg_save(b);
    dmg_move(b, side * 2.0f * radius, 0, -1.5f * radius);
    dmg_rod(b, v3(-3 * side * radius, 0, 0), v3(side * radius, 0, 0), 0.9f * radius);
    uint32_t lever = dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(side, 0, 0), -0.4f, 2.2f);
    dmg_rod(b, v3(0, 0, 0), v3(x, 0, 0), 0.7f * radius);
    dmg_beam(b, v3(x, 0, 0), v3(x, length, 0), radius, 1.6f * radius);
    draw_grip(b, dmg_int(b, 0, 2), v3(x, length, 0), v3(0, 1, 0), 1.8f * radius);
    dmg_rest(b, lever, rested);
    dmg_use(b, 0);
    dmg_restore(b);
}

/* Draws a handle on a rose, as of a door or a valve: turns about Z. */
static void draw_turning_lever(dmg_builder* b, float length, float radius) {
    float out = radius * dmg_range(b, 2, 5), far = dmg_range(b, 0.6f, 1.7f), slant = dmg_range(b, -DMG_PI, DMG_PI);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * out), 2.2f * radius);
    dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, far);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out), radius);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), slant);
    if (dmg_chance(b, 0.5f))
        dmg_beam(b, v3(-radius, 0, out), v3(length, 0, out * dmg_range(b, 0.8f, 1.6f)), radius, 1.6f * radius);
    else
        dmg_rod(b, v3(0, 0, out), v3(length, 0, out), 0.8f * radius);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Goes straight down, as a handle one presses. */
static void draw_press(dmg_builder* b, float length, float radius) {
    float travel = length * dmg_range(b, 0.3f, 0.8f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 2.5f * radius, 0, 0.2f * radius), v3(radius, 1.2f * length + travel, 0.4f * radius));
    dmg_slide(b, 0, "lever", v3(0, -1, 0), 0.0f, travel);
    dmg_rod(b, v3(0, 0.4f * length, -radius), v3(0, 0.4f * length, 0.6f * length), radius);
    dmg_rod(b, v3(-0.4f * length, 0.4f * length, 0.6f * length), v3(0.4f * length, 0.4f * length, 0.6f * length),
            0.8f * radius);
    dmg_use(b, 0);
}

void dmg_build_lever(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.04f, 0.8f), radius = length * dmg_range(b, 0.03f, 0.1f),
          width = length * dmg_range(b, 0.4f, 1.5f), height = length * dmg_range(b, 0.5f, 1.5f),
          depth = length * dmg_range(b, 0.1f, 0.8f);
    static const float weights[] = {4, 1.5f, 2, 1};
    int kind = dmg_weighted(b, weights, 4), count = kind == 0 ? (dmg_chance(b, 0.6f) ? 1 : dmg_int(b, 2, 5)) : 1;
    face_somewhere(b, 0.5f * height);
    width *= (float)count * 0.6f + 0.4f;
    if (kind == 1) width = 4 * radius;
    draw_mount(b, width, height, depth);
    float swing = dmg_range(b, 0.25f, 0.9f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, width * (((float)i + 0.5f) / (float)count - 0.5f), 0, 0);
        if (kind == 0) draw_stick(b, length, radius, swing);
        if (kind == 1) draw_side_lever(b, length, radius);
        if (kind == 2) draw_turning_lever(b, length, radius);
        if (kind == 3) draw_press(b, length, radius);
        dmg_restore(b);
    }
}

/* ---- switch ---- */

typedef struct switch_style {
    int kind;
    float width, height, rise, swing;
    int on; /* -1, 0, 1: which way they lie */
} switch_style;

static void draw_rocker(dmg_builder* b, const switch_style* s) {
    /* Two faces that meet in a blunt edge over the axle. */
    const dmg_xy wedge[] = {{-0.5f * s->height, -0.5f * s->rise},
                            {0.5f * s->height, -0.5f * s->rise},
                            {0.5f * s->height, 0.5f * s->rise},
                            {0, 0.25f * s->rise},
                            {-0.5f * s->height, 0.5f * s->rise}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* x to -z, y stays, z to x */
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_extrude(b, wedge, 5, -0.5f * s->width, 0.5f * s->width);
    dmg_restore(b);
}

static void draw_switch(dmg_builder* b, const switch_style* s) {
    float w = s->width, h = s->height, rise = s->rise;
    uint32_t part = 0;
    if (s->kind == 3) { /* slides */
        dmg_box(b, v3(0, 0, 0), v3(0.5f * w, h, 0.1f * rise));
        part = dmg_slide(b, 0, "switch", v3(0, 1, 0), -0.3f * h, 0.3f * h);
        dmg_box(b, v3(0, 0, 0.4f * rise), v3(0.9f * w, 0.35f * h, 0.8f * rise));
        dmg_rest(b, part, 0.3f * h * (float)s->on);
        dmg_use(b, 0);
        return;
    }
    dmg_frame_draw(b, 1.15f * w, 1.1f * h, 0.15f * rise, 0.06f * h);
    part = dmg_hinge(b, 0, "switch", v3(0, s->kind == 2 ? 0.5f * h : 0.0f, s->kind == 2 ? 0.0f : -0.2f * rise),
                     v3(s->kind == 2 ? -1 : 1, 0, 0), -s->swing, s->swing);
    if (s->kind == 0) dmg_box(b, v3(0, 0, 0), v3(w, h, rise));
    if (s->kind == 4) draw_rocker(b, s);
    if (s->kind == 1) { /* a toggle */
        dmg_cone(b, v3(0, 0, -0.2f * rise), v3(0, 0, 2.5f * rise), 0.2f * w, 0.3f * w);
        dmg_ellipsoid(b, v3(0, 0, 2.5f * rise), v3(0.3f * w, 0.3f * w, 0.3f * w));
    }
    if (s->kind == 2) dmg_box(b, v3(0, 0, 0.2f * rise), v3(w, h, 0.8f * rise)); /* a key hung above */
    dmg_rest(b, part, s->kind == 2 ? 0.0f : s->swing * (float)s->on);
    if (s->kind == 2) b->parts[part - 1].joint.lower = -0.15f;
    if (s->kind == 2) b->parts[part - 1].joint.upper = 0.0f;
    dmg_use(b, 0);
}

void dmg_build_switch(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.02f, 0.12f), height = width * dmg_scale_range(b, 0.6f, 2.0f),
          depth = width * dmg_scale_range(b, 0.08f, 0.8f);
    switch_style s = {.kind = dmg_int(b, 0, 4), .swing = dmg_range(b, 0.12f, 0.4f)};
    int columns = dmg_chance(b, 0.5f) ? 1 : dmg_int(b, 2, 6), rows = dmg_chance(b, 0.8f) ? 1 : 2;
    float room = dmg_range(b, 0.35f, 0.8f);
    width *= 0.5f + 0.5f * (float)columns;
    s.width = room * width / (float)columns;
    s.height = room * height / (float)rows;
    if (dmg_chance(b, 0.4f)) s.height = fminf(s.height, 2 * s.width);
    s.rise = fminf(s.width, s.height) * dmg_range(b, 0.15f, 0.5f);
    face_somewhere(b, 0.5f * height);
    draw_mount(b, width, height, depth);
    for (int i = 0; i < columns * rows; ++i) {
        dmg_save(b);
        dmg_move(b, width * (((float)(i % columns) + 0.5f) / (float)columns - 0.5f),
                 height * (((float)(i / columns) + 0.5f) / (float)rows - 0.5f), 0);
        s.on = (int)dmg_sign(b);
        draw_switch(b, &s);
        dmg_restore(b);
    }
}

/* ---- slider ---- */

void dmg_build_slider(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.03f, 0.4f), pitch = length * dmg_range(b, 0.15f, 0.5f),
          depth = length * dmg_scale_range(b, 0.05f, 0.5f);
    int count = dmg_chance(b, 0.3f) ? 1 : dmg_int(b, 2, 10), cap = dmg_int(b, 0, 3);
    float width = pitch * ((float)count + 0.6f), size = pitch * dmg_range(b, 0.3f, 0.8f),
          rise = size * dmg_range(b, 0.4f, 1.2f);
    face_somewhere(b, 0.6f * length);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    draw_mount(b, width, 1.3f * length, depth);
    bool slots = dmg_chance(b, 0.6f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        if (slots) dmg_frame_draw(b, 0.25f * size + 0.1f * pitch, length, 0.05f * rise, 0.05f * pitch);
        float travel = length - size;
        uint32_t slider = dmg_slide(b, 0, "slider", v3(0, 1, 0), -0.5f * travel, 0.5f * travel);
        dmg_box(b, v3(0, 0, 0.2f * rise), v3(0.2f * size, 0.4f * size, 0.5f * rise));
        if (cap == 0) dmg_box(b, v3(0, 0, 0.6f * rise), v3(size, 0.6f * size, 0.7f * rise));
        if (cap == 1)
            dmg_rounded_box(b, v3(0, 0, 0.6f * rise), v3(0.7f * size, size, 0.7f * rise), 0.2f * fminf(size, rise));
        if (cap == 2) dmg_rod(b, v3(0, 0, 0.2f * rise), v3(0, 0, rise), 0.45f * size);
        if (cap == 3) { /* a T */
            dmg_box(b, v3(0, 0, 0.5f * rise), v3(0.2f * size, 0.2f * size, rise));
            dmg_box(b, v3(0, 0, rise), v3(size, 0.3f * size, 0.3f * rise));
        }
        dmg_rest(b, slider, travel * dmg_range(b, -0.5f, 0.5f));
        dmg_use(b, 0);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.3f)) { /* scale marks */
        for (int i = 0; i <= 8; ++i)
            dmg_box(b, v3(-0.47f * width, length * ((float)i / 8.0f - 0.5f), 0),
                    v3(0.04f * width, 0.01f * length, 0.04f * rise));
    }
}

/* ---- crank ---- */

/* Draws a crank about Z in the part in use: arm along +X at z, grip towards +Z. The grip may turn on its own. */
static void draw_crank_arm(dmg_builder* b, uint32_t crank, float arm, float z, float radius) {
    bool bent = dmg_chance(b, 0.3f), both = dmg_chance(b, 0.1f);
    float grip = arm * dmg_range(b, 0.3f, 0.8f);
    if (bent) { /* one bent rod */
        const dmg_vec path[] = {
            {0, 0, z}, {0.2f * arm, 0, z}, {0.85f * arm, 0, z}, {arm, 0, z + 0.15f * arm}, {arm, 0, z + grip}};
        dmg_sweep(b, path, 5, radius, radius, false);
    } else {
        dmg_beam(b, v3(both ? -arm : -radius, 0, z), v3(arm + radius, 0, z), radius, 2.2f * radius);
    }
    if (dmg_chance(b, 0.4f)) dmg_spin(b, crank, "grip", v3(arm, 0, z), v3(0, 0, 1));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(arm, 0, z + 0.1f * grip), v3(arm, 0, z + grip), 1.3f * radius);
    else
        dmg_cone(b, v3(arm, 0, z), v3(arm, 0, z + grip), 0.9f * radius, 1.6f * radius);
    if (both) dmg_rod(b, v3(-arm, 0, z), v3(-arm, 0, z - grip), 1.3f * radius);
}

void dmg_build_crank(dmg_builder* b) {
    float arm = dmg_scale_range(b, 0.03f, 0.4f), radius = arm * dmg_range(b, 0.05f, 0.12f),
          out = arm * dmg_range(b, 0.2f, 0.8f), size = arm * dmg_range(b, 0.8f, 3.0f),
          depth = arm * dmg_range(b, 0.4f, 2.0f);
    int base = dmg_int(b, 0, 3);
    float high = base == 3 ? 2.0f * arm : 0.5f * size;
    dmg_move(b, 0, high, 0);
    if (base == 0) dmg_box(b, v3(0, 0, -0.5f * depth), v3(size, size, depth));
    if (base == 1) dmg_rod(b, v3(0, 0, -depth), v3(0, 0, 0), 0.5f * size);
    if (base == 2) { /* a winch: a drum between cheeks turns with it */
        for (int s = 0; s < 2; ++s)
            dmg_box(b, v3(0, -0.1f * size, -(float)s * depth), v3(0.8f * size, 0.8f * size, 0.06f * size));
        dmg_box(b, v3(0, -0.5f * size, -0.5f * depth), v3(size, 0.08f * size, 1.1f * depth));
    }
    if (base == 3) { /* on a post */
        dmg_box(b, v3(0, -0.5f * high, -0.15f * size), v3(0.3f * size, high + 0.2f * size, 0.3f * size));
        dmg_box(b, v3(0, -high, -0.15f * size), v3(size, 0.05f * size, size));
    }
    uint32_t crank = dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, 1));
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 2.0f * DMG_PI));
    dmg_rod(b, v3(0, 0, base == 2 ? -depth : -0.1f * out), v3(0, 0, out), 1.2f * radius);
    if (base == 2) dmg_rod(b, v3(0, 0, -0.9f * depth), v3(0, 0, -0.1f * depth), 0.25f * size);
    if (dmg_chance(b, 0.2f)) dmg_wheel_draw(b, 3, arm, 0.3f * arm, dmg_int(b, 3, 6));
    draw_crank_arm(b, crank, arm, out, radius);
    dmg_use(b, 0);
}

/* ---- valve ---- */

/* Draws a pipe along X with flanges, and the bonnet the stem comes out of at y = 0 upwards. */
static void draw_pipe(dmg_builder* b, float radius) {
    float length = radius * dmg_range(b, 4, 10), y = -radius * dmg_range(b, 1.2f, 2.0f);
    int shape = dmg_int(b, 0, 2);
    dmg_rod(b, v3(-0.5f * length, y, 0), v3(0.5f * length, y, 0), radius);
    for (int s = -1; s <= 1 && shape != 2; s += 2) {
        float x = (float)s * 0.5f * length;
        dmg_rod(b, v3(x - 0.2f * radius, y, 0), v3(x + 0.2f * radius, y, 0), 1.5f * radius);
    }
    if (shape == 1) dmg_ellipsoid(b, v3(0, y, 0), v3(1.7f * radius, 1.5f * radius, 1.4f * radius));
    dmg_cone(b, v3(0, y, 0), v3(0, 0, 0), 1.2f * radius, 0.6f * radius);
    if (dmg_chance(b, 0.3f)) { /* more piping */
        dmg_rod(b, v3(0.5f * length, y, 0), v3(0.5f * length, y - 2 * length, 0), radius);
    }
}

void dmg_build_valve(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.008f, 0.25f), stem = radius * dmg_range(b, 0.6f, 2.5f),
          wheel = radius * dmg_range(b, 1.0f, 3.0f);
    int kind = dmg_int(b, 0, 3);
    dmg_move(b, 0, 4 * radius, 0);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * dmg_sign(b));
    if (dmg_chance(b, 0.25f))
        dmg_box(b, v3(0, -2 * radius, 0), v3(6 * radius, 4 * radius, 6 * radius));
    else
        draw_pipe(b, radius);
    if (kind == 0) { /* a spindle rises as it is turned */
        float pitch = radius * dmg_range(b, 0.03f, 0.12f), turns = dmg_range(b, 1.0f, 5.0f);
        dmg_screw(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 1, 0), pitch, 0.0f, 2.0f * DMG_PI * turns);
    }
    if (kind == 1 || kind == 2) dmg_spin(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 1, 0));
    if (kind == 3) dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(0, dmg_sign(b), 0), 0.0f, 1.57f);
    dmg_rod(b, v3(0, -0.2f * stem, 0), v3(0, stem, 0), 0.25f * radius);
    dmg_save(b);
    dmg_move(b, 0, stem, 0);
    if (kind == 3) {
        float length = 2 * wheel;
        dmg_beam(b, v3(-0.3f * radius, 0, 0), v3(length, 0.1f * length, 0), 0.5f * radius, 0.2f * radius);
    } else {
        dmg_face_up(b);
        if (kind == 2)
            dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), wheel, 0.6f * wheel);
        else {
            int look = dmg_chance(b, 0.75f) ? 3 : 2;
            dmg_wheel_draw(b, look, wheel, 0.25f * wheel, dmg_int(b, 2, 7));
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- joystick ---- */

void dmg_build_joystick(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.04f, 0.25f), base = length * dmg_range(b, 0.6f, 1.4f),
          high = base * dmg_range(b, 0.15f, 0.5f), radius = length * dmg_range(b, 0.05f, 0.14f);
    float swing = dmg_range(b, 0.25f, 0.6f), pivot = high - dmg_range(b, 0.0f, 0.8f) * high;
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    dmg_face_up(b);
    draw_mount(b, base, base, high);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_dome(b, v3(0, high, 0), v3(2.5f * radius, 1.8f * radius, 2.5f * radius));
    bool along = dmg_chance(b, 0.5f);
    uint32_t stick = dmg_hinge(b, 0, "stick", v3(0, pivot, 0), along ? v3(1, 0, 0) : v3(0, 0, 1), -swing, swing);
    dmg_rod(b, v3(0, pivot, 0), v3(0, high + length, 0), radius);
    int grip = dmg_int(b, 0, 2);
    if (grip == 0) dmg_ellipsoid(b, v3(0, high + length, 0), v3(2.2f * radius, 2.2f * radius, 2.2f * radius));
    if (grip > 0)
        dmg_rounded_box(b, v3(0, high + 0.7f * length, 0), v3(3 * radius, 0.7f * length, 3.5f * radius), radius);
    if (grip == 2) { /* a trigger under the fingers and a thumb button */
        float y = high + 0.85f * length;
        dmg_hinge(b, stick, "trigger", v3(0, y + 0.1f * length, 1.5f * radius), v3(1, 0, 0), 0.0f, 0.35f);
        dmg_rounded_box(b, v3(0, y - 0.05f * length, 2.1f * radius), v3(1.2f * radius, 0.25f * length, 0.9f * radius),
                        0.3f * radius);
        dmg_save(b);
        dmg_move(b, 0, high + 1.05f * length, 0);
        dmg_face_up(b);
        dmg_buttons thumb = {"thumb_button", dmg_int(b, 1, 2), 1, 1.3f * radius, 0, radius, radius,
                             0.3f * radius,  0.2f * radius,    1};
        dmg_buttons_draw(b, stick, &thumb);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) {
        dmg_save(b);
        dmg_move(b, 0, high, 0.38f * base);
        dmg_face_up(b);
        float key = 0.1f * base;
        dmg_buttons keys = {"button", dmg_int(b, 2, 5), 1,          1.6f * key,      0, key,
                            key,      0.3f * key,       0.2f * key, dmg_int(b, 0, 3)};
        dmg_buttons_draw(b, 0, &keys);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.3f)) { /* a throttle beside it */
        float x = 0.42f * base;
        dmg_hinge(b, 0, "throttle", v3(x, high, 0), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_beam(b, v3(x, high, 0), v3(x, high + 0.2f * length, 0), 0.5f * radius, 2 * radius);
        dmg_use(b, 0);
    }
}

/* ---- game controller ---- */

/* Draws a thumb stick on z = 0: turns about a line under its cap; may be pressed too. */
static void draw_thumb_stick(dmg_builder* b, float radius) {
    float rise = radius * dmg_range(b, 0.6f, 1.2f), pivot = -radius * dmg_range(b, 0, 0.6f),
          swing = dmg_range(b, 0.25f, 0.5f);
    dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.3f * radius, 0.15f * radius);
    dmg_hinge(b, 0, "thumb_stick", v3(0, 0, pivot), dmg_chance(b, 0.5f) ? v3(1, 0, 0) : v3(0, 1, 0), -swing, swing);
    dmg_cone(b, v3(0, 0, pivot), v3(0, 0, rise), 0.6f * radius, 0.4f * radius);
    dmg_knob_draw(b, 3, radius, rise);
    dmg_use(b, 0);
}

/* A trigger under the far edge (y up is away from the player): pivots near its root. */
static void draw_trigger(dmg_builder* b, uint32_t parent, const char* name, float width, float length) {
    float far = dmg_range(b, 0.2f, 0.5f), in = dmg_range(b, -0.2f, 0.4f) * length;
    dmg_hinge(b, parent, name, v3(0, -0.2f * length, in), v3(1, 0, 0), 0.0f, far);
    const dmg_xy profile[] = {{-0.3f * length, 0.2f * length},
                              {-0.3f * length, -0.2f * length},
                              {0.3f * length, -0.9f * length},
                              {0.6f * length, -0.8f * length},
                              {0.4f * length, 0.2f * length}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the profile's x becomes z, its z -x */
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_extrude(b, profile, 5, -0.5f * width, 0.5f * width);
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws two horns and a bridge: thumbs on top, fingers behind. */
static void draw_gamepad(dmg_builder* b, float width) {
    float body = 0.4f * width, thick = 0.18f * width;
    dmg_rounded_box(b, v3(0, 0, -0.5f * thick), v3(width, body, thick), 0.45f * thick);
    for (int s = -1; s <= 1; s += 2)
        dmg_ellipsoid(b, v3((float)s * 0.42f * width, -0.22f * width, -0.6f * thick),
                      v3(0.13f * width, 0.25f * width, 0.7f * thick));
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * (s < 0 ? 0.33f : 0.16f) * width, s < 0 ? 0.06f * width : -0.09f * width, 0);
        draw_thumb_stick(b, 0.06f * width);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, (float)s * 0.36f * width, 0.5f * body, -0.55f * thick);
        draw_trigger(b, 0, s < 0 ? "trigger_left" : "trigger_right", 0.16f * width, 0.1f * width);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0.33f * width, 0.06f * width, 0);
    for (int i = 0; i < 4; ++i) { /* face buttons in a diamond */
        float angle = 0.5f * DMG_PI * (float)i, r = 0.065f * width;
        dmg_buttons face = {"button",        1, 1, 0, 0, 0.055f * width, 0.055f * width, 0.02f * width, 0.012f * width,
                            dmg_int(b, 1, 1)};
        dmg_save(b);
        dmg_move(b, r * cosf(angle), r * sinf(angle), 0);
        dmg_buttons_draw(b, 0, &face);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_move(b, -0.16f * width, -0.09f * width, 0);
    if (dmg_chance(b, 0.6f)) { /* a rocking cross */
        dmg_hinge(b, 0, "pad", v3(0, 0, 0), dmg_chance(b, 0.5f) ? v3(1, 0, 0) : v3(0, 1, 0), -0.15f, 0.15f);
        dmg_box(b, v3(0, 0, 0.008f * width), v3(0.15f * width, 0.05f * width, 0.03f * width));
        dmg_box(b, v3(0, 0, 0.008f * width), v3(0.05f * width, 0.15f * width, 0.03f * width));
        dmg_use(b, 0);
    }
}

/* Draws a grip with a ring or a head: trackers for one hand. */
static void draw_hand_controller(dmg_builder* b, float length) {
    float radius = 0.15f * length;
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.3f, 1.0f));
    if (dmg_chance(b, 0.5f))
        dmg_cone(b, v3(0, -length, -radius), v3(0, 0, -radius), 0.7f * radius, radius);
    else
        dmg_rounded_box(b, v3(0, -0.5f * length, -radius), v3(1.6f * radius, length, 2 * radius), 0.6f * radius);
    dmg_slide(b, 0, "squeeze", v3(dmg_sign(b), 0, 0), 0.0f, 0.08f * radius);
    dmg_rounded_box(
        b, v3(b->parts[b->part_count - 1].joint.axis[0] > 0 ? -0.8f * radius : 0.8f * radius, -0.4f * length, -radius),
        v3(0.5f * radius, 0.35f * length, 0.8f * radius), 0.15f * radius);
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_rounded_box(b, v3(0, 0.5f * radius, -0.6f * radius), v3(3 * radius, 3 * radius, 1.2f * radius), 0.5f * radius);
    if (dmg_chance(b, 0.6f))
        dmg_torus(b, v3(0, radius, -0.5f * radius), dmg_chance(b, 0.5f) ? v3(0, 0.3f, 1) : v3(0, 1, 0.4f),
                  2.6f * radius, 0.25f * radius);
    dmg_save(b);
    dmg_move(b, -0.5f * radius, radius, 0);
    draw_thumb_stick(b, 0.5f * radius);
    dmg_move(b, 1.3f * radius, -0.3f * radius, 0);
    dmg_buttons keys = {
        "button",      1, dmg_int(b, 1, 2), 0, 0.7f * radius, 0.5f * radius, 0.5f * radius, 0.15f * radius,
        0.1f * radius, 1};
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
    dmg_move(b, 0, 1.9f * radius, -0.7f * radius);
    draw_trigger(b, 0, "trigger", 0.8f * radius, radius);
}

void dmg_build_game_controller(dmg_builder* b) {
    float size = dmg_range(b, 0.1f, 0.18f);
    dmg_move(b, 0, 0.5f * size, 0);
    if (dmg_chance(b, 0.5f)) dmg_face_up(b);
    if (dmg_chance(b, 0.5f))
        draw_gamepad(b, size);
    else
        draw_hand_controller(b, size);
}

/* ---- pedals ---- */

void dmg_build_pedal(dmg_builder* b) {
    float length = dmg_range(b, 0.08f, 0.3f), width = length * dmg_range(b, 0.25f, 0.5f),
          t = length * dmg_range(b, 0.03f, 0.1f);
    int count = dmg_int(b, 1, 3), kind = dmg_int(b, 0, 2);
    float pitch = 1.5f * width, total = pitch * (float)count;
    if (kind == 2)
        dmg_box(b, v3(0, 1.3f * length, -0.8f * length),
                v3(total, 0.3f * length, 0.3f * length)); /* what they hang on */
    else
        dmg_box(b, v3(0, 0.5f * t, 0), v3(total, t, 1.3f * length));
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), tilt = dmg_range(b, 0.2f, 0.5f), far = tilt * 0.8f;
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        if (kind == 0) { /* hinged at the heel, to be pressed at the far end */
            float y = 1.5f * t;
            dmg_rod(b, v3(-0.5f * width, y, 0.5f * length), v3(0.5f * width, y, 0.5f * length), 0.5f * t);
            uint32_t pedal = dmg_hinge(b, 0, "pedal", v3(0, y, 0.5f * length), v3(1, 0, 0), -far, tilt);
            dmg_box_span(b, v3(-0.5f * width, y, -0.5f * length), v3(0.5f * width, y + t, 0.5f * length));
            b->parts[pedal - 1].joint.lower = 0.0f;
            dmg_rest(b, pedal, tilt);
        }
        if (kind == 1) { /* in the middle */
            float y = t + 0.25f * length;
            for (int s = -1; s <= 1; s += 2)
                dmg_box(b, v3((float)s * 0.55f * width, 0.5f * y, 0), v3(0.08f * width, y, 0.2f * length));
            dmg_hinge(b, 0, "pedal", v3(0, y, 0), v3(1, 0, 0), -0.3f, 0.3f);
            dmg_box(b, v3(0, y + 0.5f * t, 0), v3(width, t, length));
        }
        if (kind == 2) { /* hanging */
            dmg_vec pivot = {0, 1.25f * length, -0.7f * length}, foot = {0, 0.3f * length, -0.2f * length};
            dmg_hinge(b, 0, "pedal", pivot, v3(1, 0, 0), 0.0f, dmg_range(b, 0.2f, 0.5f));
            dmg_beam(b, pivot, foot, 0.2f * width, 0.3f * width);
            dmg_rounded_box(b, foot, v3(width, 0.8f * width, t), 0.3f * t);
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
}
