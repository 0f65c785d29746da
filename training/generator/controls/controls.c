/* Draws single panel controls: knobs, buttons, faucets. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a housing whose front is centred at the origin of z = 0; returns with the frame unchanged. */
static void draw_housing(dmg_builder* b, float width, float height, float depth) {
    switch (dmg_int(b, 0, 4)) {
    case 0:
        dmg_rounded_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth),
                        0.15f * fminf(depth, fminf(width, height)));
        break;
    case 1:
        dmg_rounded_plate(b, width, height, depth, 0.1f * fminf(width, height));
        break;
    case 2: /* a sheet over an open case */
        dmg_box(b, v3(0, 0, -0.01f * width), v3(width, height, 0.02f * width));
        dmg_move(b, 0, 0, -0.02f * width);
        dmg_case_draw(b, dmg_case_pick(b), 0.95f * width, 0.95f * height, depth, 0.03f * width);
        dmg_move(b, 0, 0, 0.02f * width);
        break;
    default:
        dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
        break;
    }
}

/* Screws and a display on the front; moves to the middle of the room left below and returns its height. */
static float draw_front_details(dmg_builder* b, float width, float height) {
    float small = fminf(width, height);
    if (dmg_chance(b, 0.3f)) {
        for (int i = 0; i < 4; ++i) {
            float x = width * (i & 1 ? 0.46f : -0.46f), y = height * (i & 2 ? 0.46f : -0.46f);
            dmg_rod(b, v3(x, y, -0.01f * small), v3(x, y, 0.01f * small), 0.02f * small);
        }
    }
    if (dmg_chance(b, 0.7f)) return height;
    dmg_box(b, v3(dmg_range(b, -0.3f, 0.3f) * width, 0.4f * height, 0),
            v3(0.3f * width, 0.12f * height, 0.02f * small));
    dmg_move(b, 0, -0.1f * height, 0);
    return 0.8f * height;
}

typedef struct control_grid {
    int columns, rows;
    float pitch_x, pitch_y, radius;
} control_grid;

static control_grid pick_grid(dmg_builder* b, float width, float height, int most) {
    control_grid grid = {.columns = dmg_int(b, 1, most), .rows = 1};
    if (dmg_chance(b, 0.35f)) grid.rows = dmg_int(b, 1, 3);
    grid.pitch_x = 0.9f * width / (float)grid.columns;
    grid.pitch_y = 0.9f * height / (float)grid.rows;
    grid.radius = 0.5f * fminf(grid.pitch_x, grid.pitch_y) * dmg_range(b, 0.25f, 0.9f);
    return grid;
}

/* Moves the frame to a place of the grid. */
static void to_place(dmg_builder* b, const control_grid* grid, int i) {
    dmg_move(b, grid->pitch_x * ((float)(i % grid->columns) - 0.5f * (float)(grid->columns - 1)),
             grid->pitch_y * (0.5f * (float)(grid->rows - 1) - (float)(i / grid->columns)), 0);
}

/* Stands the panel up, lays it down or tilts it; the frame's z = 0 becomes its front. */
static void place_panel(dmg_builder* b, float height, float depth) {
    int how = dmg_int(b, 0, 2);
    if (how == 0) dmg_move(b, 0, 0.5f * height, 0);
    if (how == 1) {
        dmg_move(b, 0, depth, 0);
        dmg_face_up(b);
    }
    if (how == 2) {
        dmg_move(b, 0, 0.5f * height + depth, 0);
        dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.2f, 1.2f));
    }
}

void dmg_build_knob(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.04f, 0.8f), height = width * dmg_scale_range(b, 0.25f, 1.5f),
          depth = width * dmg_scale_range(b, 0.05f, 1.0f);
    place_panel(b, height, depth);
    draw_housing(b, width, height, depth);
    height = draw_front_details(b, width, height);
    control_grid grid = pick_grid(b, width, height, 5);
    int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    float rise = grid.radius * dmg_scale_range(b, 0.35f, 3.0f), gap = dmg_chance(b, 0.3f) ? 0.1f * rise : 0.0f;
    bool endless = dmg_chance(b, 0.4f), collar = dmg_chance(b, 0.3f), inner = dmg_chance(b, 0.15f);
    float upper = dmg_range(b, 1.5f, 5.2f);
    for (int i = 0; i < grid.columns * grid.rows; ++i) {
        dmg_save(b);
        to_place(b, &grid, i);
        dmg_use(b, 0);
        if (collar) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.08f * rise), 1.2f * grid.radius);
        if (gap > 0.0f) dmg_rod(b, v3(0, 0, 0), v3(0, 0, gap), 0.3f * grid.radius);
        dmg_move(b, 0, 0, gap);
        float turned = dmg_range(b, 0, upper);
        uint32_t knob;
        if (endless)
            knob = dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1));
        else
            knob = dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, knob, turned);
        dmg_knob_draw(b, kind, grid.radius, rise);
        if (inner) { /* a second knob on top of the first */
            dmg_move(b, 0, 0, rise);
            dmg_spin(b, knob, "inner_knob", v3(0, 0, 0), v3(0, 0, -1));
            dmg_knob_draw(b, kind, 0.55f * grid.radius, 0.8f * rise);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

float dmg_button_way(dmg_builder* b, float rise) {
    return rise * dmg_scale_range(b, 0.06f, 0.8f);
}

void dmg_build_button(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.03f, 0.6f), height = width * dmg_scale_range(b, 0.3f, 2.0f),
          depth = width * dmg_scale_range(b, 0.05f, 1.0f);
    place_panel(b, height, depth);
    draw_housing(b, width, height, depth);
    height = draw_front_details(b, width, height);
    int columns = dmg_chance(b, 0.3f) ? 1 : dmg_int(b, 1, 6), rows = dmg_chance(b, 0.3f) ? 1 : dmg_int(b, 1, 6);
    float px = 0.92f * width / (float)columns, py = 0.92f * height / (float)rows, fill = dmg_range(b, 0.3f, 0.92f);
    float w = px * fill, h = py * fill;
    if (dmg_chance(b, 0.5f)) w = h = fminf(w, h);
    float rise = fminf(w, h) * dmg_scale_range(b, 0.1f, 1.2f);
    float way = dmg_button_way(b, rise);
    dmg_buttons set = {"button", columns, rows, px, py, w, h, rise, way, dmg_int(b, 0, 3)};
    if (columns * rows == 1 && dmg_chance(b, 0.5f)) { /* a mushroom head on a collar */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * rise), 0.4f * fminf(w, h));
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * rise);
        dmg_slide(b, 0, "button", v3(0, 0, -1), 0.0f, 0.4f * rise);
        dmg_knob_draw(b, 3, 0.5f * fminf(w, h), rise);
        dmg_restore(b);
        dmg_use(b, 0);
        return;
    }
    dmg_buttons_draw(b, 0, &set);
}

/* ---- faucet ---- */

/* Draws a bent tube from the origin: up, over and down towards +Z. */
static void draw_spout(dmg_builder* b, float radius, float rise, float reach) {
    enum { POINTS = 12 };
    dmg_vec path[POINTS];
    int kind = dmg_int(b, 0, 2);
    for (int i = 0; i < POINTS; ++i) {
        float s = (float)i / (POINTS - 1), angle = DMG_PI * s;
        if (kind == 0)
            path[i] = v3(0, 0.6f * rise + 0.4f * rise * sinf(angle) - (i + 1 == POINTS ? 0.2f * rise : 0.0f),
                         0.5f * reach * (1.0f - cosf(angle)));
        if (kind == 0 && i == 0) path[i] = v3(0, 0, 0);
        if (kind == 1) path[i] = v3(0, s * 0.5f * rise, s * reach);
        if (kind == 2) path[i] = v3(0, rise * sinf(0.5f * angle) - 0.15f * rise * s * s * s, reach * s * s);
    }
    dmg_sweep(b, path, POINTS, radius, radius, false);
}

/* Draws a tap's handle about +Y at the origin, pointing to +Z. */
static void draw_tap_handle(dmg_builder* b, int kind, float radius, float length) {
    float body = radius * dmg_range(b, 0.8f, 1.8f), thick = radius * dmg_range(b, 0.3f, 0.8f),
          lift = dmg_range(b, 0.0f, 0.5f);
    switch (kind) {
    case 0: /* a lever on a cap */
        dmg_rod(b, v3(0, 0, 0), v3(0, body, 0), radius);
        dmg_beam(b, v3(0, 0.7f * body, 0), v3(0, 0.7f * body + lift * length, length), 1.2f * thick, 0.6f * thick);
        break;
    case 1: /* a cross */
        dmg_rod(b, v3(0, 0, 0), v3(0, body, 0), 0.5f * radius);
        for (int i = 0; i < 2; ++i) {
            dmg_vec half = i == 0 ? v3(0.6f * length, 0, 0) : v3(0, 0, 0.6f * length);
            dmg_vec centre = v3(0, 0.8f * body, 0);
            dmg_rod(b, v3_sub(centre, half), v3_add(centre, half), 0.4f * thick);
        }
        break;
    case 2: /* a knob */
        dmg_save(b);
        dmg_face_up(b);
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 1.4f * radius, 1.5f * body);
        dmg_restore(b);
        break;
    default: { /* a paddle that bends up */
        const dmg_vec path[] = {
            {0, 0, 0}, {0, body, 0.1f * length}, {0, body * 1.2f, 0.5f * length}, {0, body * 1.5f, length}};
        dmg_sweep(b, path, 4, 0.5f * thick, thick, false);
        break;
    }
    }
}

/* Draws one lever on top, on the side, or two handles beside the spout. */
static void draw_tap_handles(dmg_builder* b, float radius, float top, float reach) {
    int layout = dmg_int(b, 0, 2), kind = dmg_int(b, 0, 3);
    float length = reach * dmg_range(b, 0.3f, 0.8f), sides = reach * dmg_range(b, 0.4f, 0.7f);
    if (layout == 0) {
        dmg_move(b, 0, top, 0);
        if (dmg_chance(b, 0.12f)) { /* it lifts */
            uint32_t lever =
                dmg_hinge(b, 0, "lever", v3(0, 0.5f * radius, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.8f));
            draw_tap_handle(b, 0, radius, length);
            dmg_rest(b, lever, 0.0f);
        } else {
            float swing = dmg_range(b, 0.5f, 1.6f);
            uint32_t lever = dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 1, 0), -swing, swing);
            draw_tap_handle(b, kind, radius, length);
            if (dmg_chance(b, 0.3f)) dmg_rest(b, lever, dmg_range(b, -swing, swing));
        }
    }
    if (layout == 1) {
        float side = dmg_sign(b);
        dmg_move(b, side * radius, 0.5f * top, 0);
        dmg_turn(b, v3(0, 0, 1), -side * 0.5f * DMG_PI);
        dmg_turn(b, v3(0, 1, 0), dmg_range(b, -DMG_PI, DMG_PI));
        dmg_use(b, 0);
        dmg_rod(b, v3(0, -0.5f * radius, 0), v3(0, radius, 0), 0.8f * radius);
        dmg_move(b, 0, radius, 0);
        float swing = dmg_range(b, 0.7f, 1.7f);
        dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, side, 0), dmg_chance(b, 0.4f) ? -swing : 0.0f, swing);
        draw_tap_handle(b, kind, 0.8f * radius, length);
    }
    bool both = layout == 2 && dmg_chance(b, 0.5f) && length < sides - 1.5f * radius; /* past the spout */
    if (layout == 2) {                                                                /* what joins the three */
        dmg_use(b, 0);
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3(-sides, 0.25f * top, 0), v3(sides, 0.25f * top, 0), 0.6f * radius);
        else
            dmg_box(b, v3(0, 0, 0), v3(2.0f * sides + 3.0f * radius, 0.4f * radius, 3.0f * radius));
    }
    for (int s = -1; s <= 1 && layout == 2; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * sides, 0, 0);
        dmg_use(b, 0);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.4f * top, 0), radius);
        dmg_move(b, 0, 0.4f * top, 0);
        bool endless = kind == 1 || kind == 2;
        if (endless)
            dmg_spin(b, 0, "handle", v3(0, 0, 0), v3(0, (float)s, 0));
        else
            dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, (float)s, 0), both ? -1.6f : 0.0f, 1.6f);
        draw_tap_handle(b, kind, radius, length);
        dmg_restore(b);
    }
}

void dmg_build_faucet(dmg_builder* b) {
    float reach = dmg_range(b, 0.1f, 0.25f), top = reach * dmg_range(b, 0.3f, 1.0f),
          radius = reach * dmg_range(b, 0.08f, 0.16f);
    float rise = reach * dmg_range(b, 0.4f, 1.6f);
    if (dmg_chance(b, 0.5f))
        dmg_cone(b, v3(0, -0.1f * radius, 0), v3(0, 0.6f * radius, 0), 1.8f * radius, 1.4f * radius);
    dmg_rod(b, v3(0, 0, 0), v3(0, top, 0), radius);
    if (dmg_chance(b, 0.3f))
        dmg_box(b, v3(0, -0.1f * reach, 0.3f * reach), v3(3 * reach, 0.2f * reach, 2 * reach)); /* counter */
    bool turning_spout = dmg_chance(b, 0.3f);
    dmg_save(b);
    dmg_move(b, 0, top * dmg_range(b, 0.4f, 0.9f), 0);
    if (turning_spout) {
        dmg_hinge(b, 0, "spout", v3(0, 0, 0), v3(0, 1, 0), -1.7f, 1.7f);
        dmg_rod(b, v3(0, -0.3f * radius, 0), v3(0, 0.3f * radius, 0), 1.05f * radius);
    }
    draw_spout(b, 0.6f * radius, rise, reach);
    dmg_restore(b);
    dmg_save(b);
    draw_tap_handles(b, radius, top, reach);
    dmg_restore(b);
    dmg_use(b, 0);
}
