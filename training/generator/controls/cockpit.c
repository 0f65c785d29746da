/* Draws what a pilot or an operator faces: crowded panels, radios, switchboards, yokes and throttle quadrants. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

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
    static const float weights[DMG_CONTROL_KINDS] = {3, 2, 4, 2, 1, 0.5f, 0.4f, 0.4f, 0.4f, 0.4f, 0.5f, 2.5f};
    for (int row = 0; row < rows; ++row) {
        bool alike = dmg_chance(b, 0.4f);
        int same = dmg_weighted(b, weights, DMG_CONTROL_ORNAMENT);
        for (int column = 0; column < columns; ++column) {
            dmg_save(b);
            dmg_move(b, pitch_x * ((float)column - 0.5f * (float)(columns - 1)),
                     pitch_y * ((float)row - 0.5f * (float)(rows - 1)), 0);
            bool last = row + 1 == rows && column + 1 == columns && b->part_count == 0;
            int kind = alike || last ? same : dmg_weighted(b, weights, DMG_CONTROL_KINDS);
            dmg_control_row_draw(b, (dmg_control_kind)kind, 1, 0.0f, room * dmg_range(b, 0.4f, 0.95f));
            dmg_restore(b);
        }
    }
}

/* ---- radios and displays ---- */

/* Draws the housing behind the face; its back is often missing. */
static void draw_face(dmg_builder* b, float width, float height, float depth) {
    int shape = dmg_int(b, 0, 5);
    float thin = 0.03f * width;
    dmg_vec centre = {0, 0, -0.5f * depth}, size = {width, height, depth};
    if (shape == 0) dmg_rounded_plate(b, width, height, depth, 0.1f * height);
    if (shape <= 2 && shape > 0) dmg_box(b, centre, size);
    if (shape == 3) dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_BACK);
    if (shape == 4) {
        dmg_box(b, v3(0, 0, -0.5f * thin), v3(width, height, thin));
        dmg_box(b, v3(0, 0, -thin - 0.5f * depth), v3(0.9f * width, 0.85f * height, depth));
    }
    if (shape == 5) {
        dmg_box(b, centre, size);
        float edge = 0.04f * fminf(width, height);
        dmg_move(b, 0, 0, 0.5f * edge);
        dmg_frame_draw(b, width, height, 0.5f * edge, edge);
        dmg_move(b, 0, 0, -0.5f * edge);
    }
}

static void draw_screen(dmg_builder* b, float width, float height) {
    int kind = dmg_int(b, 0, 3);
    float thin = 0.03f * fminf(width, height);
    if (kind == 0) dmg_box(b, v3(0, 0, 0), v3(width, height, thin));
    if (kind == 1) dmg_box_faces(b, v3(0, 0, 0.1f * thin), v3(width, height, 0), DMG_FACE_FRONT);
    if (kind == 2) {
        dmg_move(b, 0, 0, 2 * thin);
        dmg_frame_draw(b, width, height, 2 * thin, 2 * thin);
        dmg_move(b, 0, 0, -2 * thin);
    }
    int digits = dmg_chance(b, 0.4f) ? dmg_int(b, 2, 8) : 0;
    float pitch = 0.9f * width / (float)(digits + 1);
    for (int i = 0; i < digits; ++i)
        dmg_box_faces(b, v3(pitch * ((float)i - 0.5f * (float)(digits - 1)), 0, thin),
                      v3(0.6f * pitch, 0.5f * height, 0), DMG_FACE_FRONT);
}

/* Draws a row or two of controls in a field of the given size; `upright` runs it along Y, and what flips, flips across
 * it. */
static void draw_field(dmg_builder* b, float width, float height, const float weights[DMG_CONTROL_KINDS]) {
    bool upright = height > width;
    float length = fmaxf(width, height), across = fminf(width, height);
    int kind = dmg_weighted(b, weights, DMG_CONTROL_KINDS), rows = dmg_chance(b, 0.25f) ? 2 : 1;
    if (kind == DMG_CONTROL_STACK) rows = 1;
    int most = (int)fminf(8.0f, fmaxf(1.0f, (float)rows * length / across)), count = dmg_int(b, 1, most);
    float pitch = length / (float)count, room = 0.5f * fminf(pitch, across / (float)rows);
    dmg_save(b);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float radius = room * dmg_range(b, 0.4f, 0.95f), gap = across / (float)rows;
    if (dmg_chance(b, 0.3f)) pitch = fminf(pitch, 2.6f * radius);
    for (int row = 0; row < rows; ++row) {
        dmg_save(b);
        dmg_move(b, 0, gap * ((float)row - 0.5f * (float)(rows - 1)), 0);
        dmg_control_row_draw(b, (dmg_control_kind)kind, count, pitch, radius);
        dmg_restore(b);
    }
    dmg_restore(b);
}

static const float radio_weights[DMG_CONTROL_KINDS] = {3, 2, 5, 1, 0.7f, 0.1f, 0.1f, 0.1f, 0.1f, 0.2f, 0.1f, 2};

/* Fields side by side: knobs, keys, a display, keys, knobs. */
static void draw_radio_row(dmg_builder* b, float width, float height) {
    int fields = dmg_int(b, 2, 6);
    float at = -0.5f * width, left = width;
    for (int i = 0; i < fields; ++i) {
        float size = i + 1 == fields ? left : left * dmg_range(b, 0.6f, 1.4f) / (float)(fields - i);
        dmg_save(b);
        dmg_move(b, at + 0.5f * size, height * dmg_range(b, -0.1f, 0.1f), 0);
        bool display = i > 0 && i + 1 < fields && dmg_chance(b, 0.4f);
        if (display)
            draw_screen(b, 0.9f * size, height * dmg_range(b, 0.3f, 0.7f));
        else if (dmg_chance(b, 0.35f) && (i == 0 || i + 1 == fields))
            dmg_control_row_draw(b, DMG_CONTROL_STACK, 1, 0, 0.5f * fminf(size, height) * dmg_range(b, 0.4f, 0.85f));
        else
            draw_field(b, 0.9f * size, height * dmg_range(b, 0.35f, 0.75f), radio_weights);
        dmg_restore(b);
        at += size;
        left -= size;
    }
}

/* Draws a display with controls along its edges and knobs in the corners. */
static void draw_radio_edges(dmg_builder* b, float width, float height) {
    float edge = fminf(width, height) * dmg_range(b, 0.1f, 0.25f), x = 0.5f * (width - edge),
          y = 0.5f * (height - edge);
    draw_screen(b, width - 2.2f * edge, height - 2.2f * edge);
    for (int side = 0; side < 4; ++side) {
        if (dmg_chance(b, 0.35f)) continue;
        bool upright = side < 2;
        float sign = side & 1 ? 1.0f : -1.0f, length = (upright ? height : width) - 2.4f * edge;
        dmg_save(b);
        dmg_move(b, upright ? sign * x : 0, upright ? 0 : sign * y, 0);
        draw_field(b, upright ? 0.8f * edge : length, upright ? length : 0.8f * edge, radio_weights);
        dmg_restore(b);
    }
    for (int corner = 0; corner < 4; ++corner) {
        dmg_save(b);
        dmg_move(b, corner & 1 ? x : -x, corner & 2 ? y : -y, 0);
        float radius = 0.5f * edge * dmg_range(b, 0.4f, 1.0f);
        bool stack = dmg_chance(b, 0.5f);
        if (dmg_chance(b, 0.45f))
            dmg_control_row_draw(b, stack ? DMG_CONTROL_STACK : DMG_CONTROL_DIAL, 1, 0, radius);
        else if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.1f * edge), 0.2f * edge); /* a screw */
        dmg_restore(b);
    }
}

/* Draws a round set: a disc, perhaps on a square plate, with controls round its rim. */
static void draw_radio_disc(dmg_builder* b, float size, float depth) {
    float radius = 0.5f * size, thin = 0.06f * radius;
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, -0.5f * thin), v3(size, size, thin));
    dmg_rod(b, v3(0, 0, -depth), v3(0, 0, thin), 0.97f * radius);
    if (dmg_chance(b, 0.5f)) dmg_torus(b, v3(0, 0, thin), v3(0, 0, 1), 0.95f * radius, 0.04f * radius);
    dmg_move(b, 0, 0, thin);
    draw_screen(b, radius, 0.6f * radius);
    int places = dmg_int(b, 3, 7);
    float start = dmg_range(b, 0, 2.0f * DMG_PI);
    for (int i = 0; i < places; ++i) {
        float angle = start + 2.0f * DMG_PI * (float)i / (float)places;
        dmg_save(b);
        dmg_move(b, 0.72f * radius * cosf(angle), 0.72f * radius * sinf(angle), 0);
        int kind = dmg_weighted(b, radio_weights, DMG_CONTROL_KINDS);
        dmg_control_row_draw(b, (dmg_control_kind)kind, 1, 0, radius * dmg_range(b, 0.1f, 0.24f));
        dmg_restore(b);
    }
}

/* Radios, transponders, displays with soft keys: what fills an avionics rack, or a car's dashboard. */
void dmg_build_avionics(dmg_builder* b) {
    int layout = dmg_int(b, 0, 2);
    float width = dmg_scale_range(b, 0.06f, 0.4f), depth = width * dmg_scale_range(b, 0.02f, 0.9f);
    float height = width * (layout == 0 ? dmg_scale_range(b, 0.12f, 0.5f) : dmg_scale_range(b, 0.5f, 1.2f));
    place_front(b, height, depth);
    if (layout == 2) {
        draw_radio_disc(b, fminf(width, height), depth);
    } else {
        draw_face(b, width, height, depth);
        if (layout == 0)
            draw_radio_row(b, 0.96f * width, 0.96f * height);
        else
            draw_radio_edges(b, 0.97f * width, 0.97f * height);
    }
    if (b->part_count == 0) dmg_dial_stack_draw(b, 0.1f * height);
    dmg_use(b, 0);
}

/* Rows of switches alike: overhead panels, breaker boards, distribution boxes. */
void dmg_build_switchboard(dmg_builder* b) {
    static const float weights[DMG_CONTROL_KINDS] = {1.2f, 0.3f, 1.5f, 3, 3, 0.8f, 0.8f, 0.8f, 0.4f, 0.4f, 0.2f, 0};
    float width = dmg_scale_range(b, 0.05f, 1.0f), height = width * dmg_scale_range(b, 0.15f, 1.5f),
          depth = width * dmg_scale_range(b, 0.02f, 0.6f);
    place_front(b, height, depth);
    draw_face(b, width, height, depth);
    bool upright = dmg_chance(b, 0.25f);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float length = 0.92f * (upright ? height : width), across = 0.9f * (upright ? width : height);
    int rows = dmg_int(b, 1, 3), kind = dmg_weighted(b, weights, DMG_CONTROL_KINDS);
    float gap = across / (float)rows;
    for (int row = 0; row < rows; ++row) {
        if (dmg_chance(b, 0.5f)) kind = dmg_weighted(b, weights, DMG_CONTROL_KINDS);
        int count = dmg_int(b, 1, 9);
        float pitch = length / (float)count, radius = 0.5f * fminf(pitch, gap) * dmg_range(b, 0.4f, 0.9f);
        if (dmg_chance(b, 0.4f)) pitch = fminf(pitch, radius * dmg_range(b, 2.3f, 4.0f));
        dmg_save(b);
        dmg_move(b, 0, gap * ((float)row - 0.5f * (float)(rows - 1)), 0);
        dmg_control_row_draw(b, (dmg_control_kind)kind, count, pitch, radius);
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
