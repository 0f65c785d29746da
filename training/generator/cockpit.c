/* What a pilot or an operator faces: crowded panels, round instruments, yokes and throttle quadrants. */
#include "categories.h"
#include "hardware.h"

/* ---- controls on z = 0 facing +Z, within a circle of the given radius ---- */

/* A knob, perhaps a smaller one on top that turns by itself; some are pulled or pushed instead. */
static void draw_dual_knob(dmg_builder* b, float radius) {
    float rise = radius * dmg_range(b, 0.6f, 2.5f), upper = dmg_range(b, 0.5f, 6.0f);
    int outer = dmg_int(b, 0, DMG_KNOB_KINDS - 1), motion = dmg_int(b, 0, 4);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.1f * radius), 1.15f * radius);
    uint32_t knob;
    if (motion == 0)
        knob = dmg_slide(b, 0, "knob", v3(0, 0, dmg_sign(b)), 0.0f, 0.2f * rise);
    else if (motion <= 2)
        knob = dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, 1));
    else
        knob = dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
    dmg_knob_draw(b, outer, radius, rise);
    if (dmg_chance(b, 0.35f)) {
        float inner = radius * dmg_range(b, 0.4f, 0.75f), more = rise * dmg_range(b, 0.5f, 1.2f);
        bool own = dmg_chance(b, 0.7f); /* beside the first, or carried by it */
        dmg_move(b, 0, 0, rise);
        if (dmg_chance(b, 0.75f))
            dmg_spin(b, own ? 0 : knob, "inner_knob", v3(0, 0, 0), v3(0, 0, 1));
        else
            dmg_slide(b, own ? 0 : knob, "inner_knob", v3(0, 0, -1), 0.0f, 0.3f * more);
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), inner, more);
    }
    dmg_use(b, 0);
}

static void draw_toggle(dmg_builder* b, float radius) {
    float length = radius * dmg_range(b, 1.0f, 2.5f), swing = dmg_range(b, 0.25f, 0.6f),
          pivot = -radius * dmg_range(b, 0.0f, 0.3f), thin = radius * dmg_range(b, 0.12f, 0.3f);
    if (dmg_chance(b, 0.8f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.2f * radius), 0.5f * radius);
    uint32_t toggle = dmg_hinge(b, 0, "toggle", v3(0, 0, pivot), v3(-1, 0, 0), -swing, swing);
    if (dmg_chance(b, 0.6f))
        dmg_cone(b, v3(0, 0, pivot), v3(0, 0, length), 0.7f * thin, 1.2f * thin);
    else
        dmg_box(b, v3(0, 0, 0.5f * length), v3(2.5f * thin, thin, length));
    int rest = dmg_int(b, -1, 1);
    dmg_rest(b, toggle, (float)rest * swing);
    dmg_use(b, 0);
}

static void draw_rocker(dmg_builder* b, float radius) {
    float width = radius * dmg_range(b, 0.6f, 1.6f), length = radius * dmg_range(b, 1.2f, 1.9f),
          tilt = dmg_range(b, 0.1f, 0.3f);
    uint32_t rocker = dmg_hinge(b, 0, "rocker", v3(0, 0, 0), v3(-1, 0, 0), -tilt, tilt);
    const dmg_xy side[] = {{-0.5f * length, 0.25f * radius},
                           {-0.5f * length, -0.4f * radius},
                           {0.5f * length, -0.4f * radius},
                           {0.5f * length, 0.25f * radius},
                           {0, 0.1f * radius}};
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI); /* the outline's x becomes y, */
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* its y becomes z */
    dmg_extrude(b, side, 5, -0.5f * width, 0.5f * width);
    dmg_restore(b);
    dmg_rest(b, rocker, dmg_chance(b, 0.5f) ? tilt : -tilt);
    dmg_use(b, 0);
}

/* A cover that flips up from over a switch. */
static void draw_guard(dmg_builder* b, float radius) {
    float length = 2 * radius, rise = radius * dmg_range(b, 0.5f, 1.0f);
    dmg_hinge(b, 0, "guard", v3(0, 0.5f * length, 0.1f * radius), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.4f, 1.9f));
    dmg_box_faces(b, v3(0, 0, 0.5f * rise), v3(1.2f * radius, length, rise),
                  DMG_FACE_ALL & ~(DMG_FACE_BACK | DMG_FACE_BOTTOM));
    dmg_use(b, 0);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * rise), 0.15f * radius);
}

static void draw_wheel_edge(dmg_builder* b, float radius) { /* a thumb wheel: its rim stands out of a slot */
    bool flat = dmg_chance(b, 0.5f);
    float sink = radius * dmg_range(b, 0.1f, 0.5f);
    dmg_vec axis = flat ? v3(1, 0, 0) : v3(0, 1, 0), half = v3_scale(axis, 0.2f * radius), middle = {0, 0, -sink};
    dmg_spin(b, 0, "thumb_wheel", middle, axis);
    dmg_rod(b, v3_sub(middle, half), v3_add(middle, half), radius);
    dmg_use(b, 0);
}

static void draw_push(dmg_builder* b, float radius) {
    float rise = radius * dmg_range(b, 0.1f, 0.9f), width = radius * dmg_range(b, 0.8f, 1.9f),
          height = radius * dmg_range(b, 0.5f, 1.4f);
    dmg_buttons one = {"button", 1, 1, 0, 0, width, height, rise, rise * 0.6f, dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, 0, &one);
}

static void draw_fader(dmg_builder* b, float radius) {
    float travel = radius * dmg_range(b, 1.0f, 1.6f);
    dmg_box(b, v3(0, 0, 0), v3(0.15f * radius, 2 * radius, 0.02f * radius));
    uint32_t fader = dmg_slide(b, 0, "fader", v3(0, 1, 0), -0.5f * travel, 0.5f * travel);
    dmg_box(b, v3(0, 0, 0.3f * radius), v3(0.8f * radius, 0.3f * radius, 0.6f * radius));
    dmg_rest(b, fader, travel * dmg_range(b, -0.5f, 0.5f));
    dmg_use(b, 0);
}

/* Screens, labels, lamps, screws: they do nothing. */
static void draw_dead(dmg_builder* b, float radius) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_box(b, v3(0, 0, 0), v3(1.9f * radius, 1.3f * radius, 0.1f * radius));
    if (kind == 1) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.15f * radius), 0.3f * radius);
    if (kind == 2) dmg_dome(b, v3(0, 0, 0), v3(0.3f * radius, 0.3f * radius, 0.3f * radius));
    if (kind == 3) dmg_frame_draw(b, 1.9f * radius, 1.9f * radius, 0.1f * radius, 0.1f * radius);
}

static void draw_control(dmg_builder* b, int kind, float radius) {
    dmg_save(b);
    switch (kind) {
    case 0:
        draw_dual_knob(b, radius * dmg_range(b, 0.4f, 0.9f));
        break;
    case 1:
        draw_push(b, radius);
        break;
    case 2:
        draw_toggle(b, radius);
        break;
    case 3:
        draw_rocker(b, radius);
        break;
    case 4:
        draw_guard(b, radius);
        break;
    case 5:
        draw_wheel_edge(b, radius);
        break;
    case 6:
        draw_fader(b, radius);
        break;
    default:
        draw_dead(b, radius);
        break;
    }
    dmg_restore(b);
}

/* ---- panel ---- */

static void place_front(dmg_builder* b, float height, float depth) {
    int how = dmg_int(b, 0, 2);
    dmg_move(b, 0, 0.5f * height + depth, 0);
    if (how == 1) dmg_face_up(b);
    if (how == 2) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.1f, 1.3f));
}

/* A radio, an audio panel, an overhead panel: controls of several kinds, crowded, alike in a row or not. */
void dmg_build_control_panel(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.05f, 1.2f), height = width * dmg_scale_range(b, 0.2f, 1.2f),
          depth = width * dmg_scale_range(b, 0.01f, 1.0f);
    int columns = dmg_int(b, 2, 7), rows = dmg_int(b, 1, 3);
    place_front(b, height, depth);
    int shape = dmg_int(b, 0, 3);
    if (shape == 0) dmg_rounded_plate(b, width, height, depth, 0.1f * height);
    if (shape == 1) dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
    if (shape == 2) dmg_box_faces(b, v3(0, 0, -0.5f * depth), v3(width, height, depth), DMG_FACE_FRONT);
    if (shape == 3) {
        float thin = 0.03f * width;
        dmg_box(b, v3(0, 0, -0.5f * thin), v3(width, height, thin));
        dmg_box(b, v3(0, 0, -thin - 0.5f * depth), v3(0.9f * width, 0.85f * height, depth));
    }
    float pitch_x = 0.94f * width / (float)columns, pitch_y = 0.9f * height / (float)rows,
          room = 0.5f * fminf(pitch_x, pitch_y);
    static const float weights[] = {4, 4, 2, 1, 0.6f, 0.7f, 1, 2.5f};
    for (int row = 0; row < rows; ++row) {
        bool alike = dmg_chance(b, 0.4f);
        int same = dmg_weighted(b, weights, 7);
        for (int column = 0; column < columns; ++column) {
            dmg_save(b);
            dmg_move(b, pitch_x * ((float)column - 0.5f * (float)(columns - 1)),
                     pitch_y * ((float)row - 0.5f * (float)(rows - 1)), 0);
            bool last = row + 1 == rows && column + 1 == columns && b->part_count == 0;
            int kind = alike || last ? same : dmg_weighted(b, weights, 8);
            draw_control(b, kind, room * dmg_range(b, 0.5f, 0.95f));
            dmg_restore(b);
        }
    }
}

/* ---- round instrument ---- */

static void draw_needles(dmg_builder* b, float radius) {
    int count = dmg_int(b, 1, 3);
    for (int i = 0; i < count; ++i) {
        float length = radius * dmg_range(b, 0.4f, 0.85f), width = radius * dmg_range(b, 0.02f, 0.08f),
              z = 0.02f * radius * (float)(i + 1), swing = dmg_range(b, 0.6f, 2.6f);
        bool endless = dmg_chance(b, 0.5f);
        dmg_save(b);
        uint32_t needle = endless ? dmg_spin(b, 0, "needle", v3(0, 0, 0), v3(0, 0, 1))
                                  : dmg_hinge(b, 0, "needle", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
        if (endless)
            dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 6));
        else
            dmg_rest(b, needle, dmg_range(b, -swing, swing));
        /* Some begin in the middle or out at the rim: the line they turn about does not touch them. */
        float from = dmg_chance(b, 0.6f) ? -0.2f * length : length * dmg_range(b, 0.0f, 0.7f),
              middle = 0.5f * (from + length);
        int kind = dmg_int(b, 0, 2);
        if (kind == 0) dmg_box(b, v3(0, middle, z), v3(width, length - from, 0.3f * width));
        if (kind == 1) { /* one face */
            const dmg_xy tip[] = {{-width, from}, {width, from}, {0, length}};
            dmg_extrude(b, tip, 3, z, z + 0.1f * width);
        }
        if (kind == 2)
            dmg_box_faces(b, v3(0, middle, z), v3(2 * width, length - from, 0.001f * radius), DMG_FACE_FRONT);
        if (from < 0.0f && dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, z + 0.3f * width), 1.5f * width);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_instrument(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.02f, 0.12f), depth = radius * dmg_range(b, 0.2f, 2.0f);
    int frame = dmg_int(b, 0, 2), knobs = dmg_int(b, 0, 3);
    dmg_move(b, 0, 1.3f * radius, 0);
    if (dmg_chance(b, 0.2f)) dmg_face_up(b);
    if (frame == 0) dmg_rounded_plate(b, 2.3f * radius, 2.3f * radius, 0.1f * radius, 0.3f * radius);
    if (frame == 1) dmg_box(b, v3(0, 0, -0.05f * radius), v3(2.2f * radius, 2.2f * radius, 0.1f * radius));
    if (dmg_chance(b, 0.7f) || frame == 2) dmg_rod(b, v3(0, 0, -depth), v3(0, 0, 0), 1.05f * radius);
    if (dmg_chance(b, 0.6f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius, 0.06f * radius);
    if (dmg_chance(b, 0.2f))
        dmg_dome(b, v3(0, 0, -1.3f * radius), v3(1.2f * radius, 1.2f * radius, 1.2f * radius)); /* a bowl behind */
    if (dmg_chance(b, 0.25f)) {                                                                 /* a card that turns */
        dmg_spin(b, 0, "card", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.015f * radius), 0.8f * radius);
        dmg_use(b, 0);
    }
    if (knobs == 0 || dmg_chance(b, 0.6f)) draw_needles(b, radius);
    for (int i = 0; i < knobs; ++i) {
        float angle = 0.25f * DMG_PI + 0.5f * DMG_PI * (float)(i + 2), size = radius * dmg_range(b, 0.12f, 0.25f),
              sink = depth * dmg_range(b, 0.0f, 0.3f);
        dmg_save(b);
        dmg_move(b, 1.3f * radius * cosf(angle), 1.3f * radius * sinf(angle), 0);
        dmg_rod(b, v3(0, 0, -sink - 0.1f * radius), v3(0, 0, 0), 0.8f * size);
        draw_dual_knob(b, size);
        dmg_restore(b);
    }
}

/* ---- yoke and throttles ---- */

static void draw_horns(dmg_builder* b, float size) {
    int kind = dmg_int(b, 0, 2);
    float tube = 0.08f * size;
    if (kind == 0) {
        const dmg_vec path[] = {{-0.9f * size, 0.9f * size, 0}, {-size, 0.4f * size, 0},
                                {-0.8f * size, 0, 0},           {0.8f * size, 0, 0},
                                {size, 0.4f * size, 0},         {0.9f * size, 0.9f * size, 0}};
        dmg_sweep(b, path, 6, tube, 1.3f * tube, false);
    }
    if (kind == 1) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.9f * size, tube);
    if (kind == 1) dmg_box(b, v3(0, 0, 0), v3(1.7f * size, 1.5f * tube, tube));
    if (kind == 2)
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * 0.7f * size, -0.5f * size, 0), v3((float)s * 0.8f * size, 0.7f * size, 0),
                    1.3f * tube);
    if (kind == 2) dmg_box(b, v3(0, 0, 0), v3(1.6f * size, 0.3f * size, tube));
    dmg_rod(b, v3(0, 0, -tube), v3(0, 0, tube), 0.25f * size);
}

/* Pushed, pulled and turned: a real one does both, here it does one or carries the wheel on the column. */
void dmg_build_yoke(dmg_builder* b) {
    float size = dmg_range(b, 0.1f, 0.25f), shaft = size * dmg_range(b, 0.8f, 2.5f),
          high = size * dmg_range(b, 1.0f, 4.0f), lean = dmg_range(b, -0.3f, 0.3f);
    int kind = dmg_int(b, 0, 2), count = dmg_chance(b, 0.25f) ? 2 : 1;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_use(b, 0);
        dmg_move(b, 3 * size * (float)i, high, 0);
        uint32_t column = 0;
        if (kind == 2) { /* a column that leans from the floor */
            column = dmg_hinge(b, 0, "column", v3(0, -high, -shaft), v3(1, 0, 0), -0.35f, 0.35f);
            dmg_rod(b, v3(0, -high, -shaft), v3(0, 0, -shaft), 0.1f * size);
            dmg_use(b, 0);
            dmg_box(b, v3(0, -high, -shaft), v3(size, 0.1f * size, size));
        } else {
            dmg_box(b, v3(0, 0, -1.2f * shaft), v3(1.5f * size, 1.2f * size, 0.4f * shaft));
        }
        dmg_turn(b, v3(1, 0, 0), lean);
        if (kind == 1) {
            column = dmg_slide(b, 0, "column", v3(0, 0, 1), -0.4f * shaft, 0.4f * shaft);
            dmg_rod(b, v3(0, 0, -1.4f * shaft), v3(0, 0, -0.1f * shaft), 0.13f * size);
        }
        if (dmg_chance(b, 0.75f))
            column = dmg_hinge(b, column, "wheel", v3(0, 0, 0), v3(0, 0, 1), -1.5f, 1.5f);
        else if (column == 0)
            column = dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_use(b, column);
        dmg_rod(b, v3(0, 0, -1.05f * shaft), v3(0, 0, 0), 0.1f * size);
        draw_horns(b, size);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* A row of levers whose pivot lies hidden in a box with a curved top. */
void dmg_build_throttle(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 0.3f), width = size * dmg_range(b, 0.4f, 1.5f),
          radius = size * dmg_range(b, 0.4f, 1.0f), rise = size * dmg_range(b, 0.3f, 1.0f);
    int levers = dmg_int(b, 1, 6), cover = dmg_int(b, 0, 2);
    float swing = dmg_range(b, 0.3f, 0.8f), deep = radius * dmg_range(b, 0.0f, 0.9f),
          thick = width / (float)levers * dmg_range(b, 0.15f, 0.6f);
    dmg_move(b, 0, size, 0);
    if (cover == 0) {
        const dmg_xy half[] = {{radius, -0.5f * width}, {radius, 0.5f * width}};
        dmg_lathe_arc(b, v3(0, -deep, 0), v3(1, 0, 0), half, 2, 0, DMG_PI * 2.0f);
        dmg_box(b, v3(0, -0.5f * size - 0.5f * deep, 0), v3(width, size - deep, 1.9f * radius));
    }
    if (cover == 1) dmg_box(b, v3(0, 0.5f * (radius - deep - size), 0), v3(width, size + radius - deep, 2 * radius));
    if (cover == 2) {
        dmg_box(b, v3(0, -0.5f * size, 0), v3(width, 0.5f * size, 2 * radius));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.52f * width, 0.5f * (radius - deep - size), 0),
                    v3(0.04f * width, size + radius - deep, 2 * radius));
    }
    for (int i = 0; i < levers; ++i) {
        float x = width * (((float)i + 0.5f) / (float)levers - 0.5f), top = radius - deep + rise,
              rest = dmg_range(b, -swing, swing);
        uint32_t lever = dmg_hinge(b, 0, "lever", v3(x, -deep, 0), v3(1, 0, 0), -swing, swing);
        dmg_box(b, v3(x, 0.5f * (top - deep), 0), v3(thick, top + deep, 0.12f * radius));
        int knob = dmg_int(b, 0, 2);
        float grip = fminf(0.45f * width / (float)levers, 0.3f * rise);
        if (knob == 0) dmg_ellipsoid(b, v3(x, top, 0), v3(grip, grip, grip));
        if (knob == 1) dmg_rod(b, v3(x - grip, top, 0), v3(x + grip, top, 0), grip);
        if (knob == 2) dmg_rounded_box(b, v3(x, top, 0), v3(1.6f * grip, 2 * grip, 1.2f * grip), 0.3f * grip);
        if (dmg_chance(b, 0.7f)) dmg_rest(b, lever, rest);
    }
    dmg_use(b, 0);
}
