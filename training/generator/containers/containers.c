/* Draws bins, boxes, pots and cases with lids that turn, lift off or slide. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws an upright case, open above: y = 0 … height. */
static void draw_open_box(dmg_builder* b, float width, float height, float depth, float wall) {
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    dmg_face_up(b);
    dmg_case_draw(b, dmg_case_pick(b), width, depth, height, wall);
    dmg_restore(b);
}

/* Draws an upright round vessel with a wall. */
static void draw_round_vessel(dmg_builder* b, float foot, float rim, float height, float wall) {
    const dmg_xy thick[] = {{0, 0}, {foot, 0}, {rim, height}, {rim - wall, height}, {foot - wall, wall}, {0, wall}};
    const dmg_xy thin[] = {{0, 0}, {foot, 0}, {rim, height}};
    if (dmg_chance(b, 0.7f))
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thick, 6);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thin, 3);
}

/* Draws a round lid on y = 0. */
static void draw_round_lid(dmg_builder* b, int kind, float radius, float rise) {
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, rise, 0), radius);
    if (kind == 1) dmg_dome(b, v3(0, 0, 0), v3(radius, rise, radius));
    if (kind == 2) {
        const dmg_xy profile[] = {{0.94f * radius, -0.3f * rise}, {0.94f * radius, 0},          {radius, 0},
                                  {radius, 0.2f * rise},          {0.5f * radius, 0.8f * rise}, {0, rise}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 6);
    }
    if (kind == 3) dmg_cone(b, v3(0, 0, 0), v3(0, rise, 0), radius, 0.4f * radius);
}

/* ---- trash can ---- */

/* Draws a lid that turns about a line at the back of the rim or, swinging, about its own middle. */
static void draw_bin_lid(dmg_builder* b, bool round, float width, float depth, float height, bool swings) {
    float rise = height * dmg_range(b, 0.03f, 0.2f), over = dmg_range(b, 0.98f, 1.05f),
          in = dmg_range(b, -0.06f, 0.06f) * depth;
    float pivot = swings ? 0.5f * rise : dmg_range(b, 0.0f, 0.5f) * rise, z = swings ? 0.0f : -0.5f * depth + in;
    dmg_move(b, 0, height, 0);
    if (swings)
        dmg_hinge(b, 0, "lid", v3(0, pivot, z), v3(1, 0, 0), -1.2f, 1.2f);
    else
        dmg_hinge(b, 0, "lid", v3(0, pivot, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.0f));
    if (round)
        draw_round_lid(b, dmg_int(b, 0, 3), 0.5f * width * over, rise);
    else if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0.5f * rise, 0), v3(width * over, rise, depth * over), 0.35f * rise);
    else
        dmg_box(b, v3(0, 0.5f * rise, 0), v3(width * over, rise, depth * over));
    if (!swings && dmg_chance(b, 0.3f))
        dmg_box(b, v3(0, 0.4f * rise, 0.52f * depth), v3(0.4f * width, 0.5f * rise, 0.08f * depth));
    dmg_use(b, 0);
}

static void draw_pedal(dmg_builder* b, float width, float depth, float height) {
    float y = 0.05f * height, back = 0.5f * depth - depth * dmg_range(b, 0.05f, 0.6f),
          tip = 0.5f * depth + 0.1f * depth, w = width * dmg_range(b, 0.15f, 0.35f);
    dmg_hinge(b, 0, "pedal", v3(0, y, back), v3(1, 0, 0), 0.0f, 0.9f * y / (tip - back));
    dmg_box_span(b, v3(-0.5f * w, y, back), v3(0.5f * w, y + 0.015f * height, tip));
    dmg_use(b, 0);
}

static void draw_bin_wheels(dmg_builder* b, float width, float depth, float radius) {
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * (0.5f * width + 0.2f * radius), radius, -0.42f * depth);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, dmg_int(b, 0, 2), radius, 0.4f * radius, 5);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_trash_can(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.25f, 1.1f), width = height * dmg_range(b, 0.4f, 0.8f),
          taper = dmg_range(b, 0.75f, 1.0f);
    bool round = dmg_chance(b, 0.5f), wheeled = !round && dmg_chance(b, 0.3f);
    float depth = round ? width : width * dmg_range(b, 0.6f, 1.3f), lift = wheeled ? 0.03f * height : 0.0f;
    dmg_save(b);
    dmg_move(b, 0, lift, 0);
    if (round)
        draw_round_vessel(b, 0.5f * width * taper, 0.5f * width, height, 0.02f * width);
    else
        draw_open_box(b, width, height, depth, 0.02f * width);
    int kind = dmg_int(b, 0, 3);
    dmg_save(b);
    if (kind <= 1) draw_bin_lid(b, round, width, depth, height, false);
    if (kind == 2) draw_bin_lid(b, round, width, depth, height, true);
    if (kind == 3) { /* lifts off, with something to hold */
        float rise = height * dmg_range(b, 0.05f, 0.15f);
        dmg_move(b, 0, height, 0);
        dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, 0.8f * height);
        if (round)
            draw_round_lid(b, dmg_int(b, 0, 3), 0.52f * width, rise);
        else
            dmg_box(b, v3(0, 0.5f * rise, 0), v3(1.03f * width, rise, 1.03f * depth));
        dmg_torus(b, v3(0, rise, 0), v3(1, 0, 0), 0.1f * width, 0.02f * width);
        dmg_use(b, 0);
    }
    dmg_restore(b);
    if (kind == 0 && dmg_chance(b, 0.8f)) draw_pedal(b, width, depth, height);
    dmg_restore(b);
    if (wheeled) draw_bin_wheels(b, width, depth, 0.1f * height);
    if (wheeled)
        dmg_rod(b, v3(-0.4f * width, 0.95f * height, -0.56f * depth), v3(0.4f * width, 0.95f * height, -0.56f * depth),
                0.03f * width);
}

/* ---- box ---- */

/* Flaps round the rim, as cardboard has them. */
static void draw_flaps(dmg_builder* b, float width, float height, float depth, float t) {
    bool meet = dmg_chance(b, 0.7f);
    float rested = dmg_chance(b, 0.7f) ? dmg_range(b, 0.3f, 4.0f) : 0.0f;
    for (int i = 0; i < 4; ++i) {
        bool along = i % 2 == 0; /* hinged on the long sides: on top */
        float edge = along ? width : depth, across = along ? depth : width,
              reach = meet ? 0.5f * across : 0.5f * across * dmg_range(b, 0.5f, 0.98f);
        if (!along) reach = fminf(reach, 0.5f * depth);
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)i);
        dmg_move(b, 0, height + (along ? t : 0.0f), -0.5f * across);
        uint32_t flap = dmg_hinge(b, 0, "flap", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 3.6f, 4.4f));
        dmg_box(b, v3(0, 0.4f * t, 0.5f * reach), v3(0.995f * edge, 0.8f * t, 0.99f * reach));
        if (rested > 0.0f) dmg_rest(b, flap, fminf(rested * dmg_range(b, 0.85f, 1.15f), 3.5f));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a lid that goes straight up, or forwards in grooves. */
static void draw_sliding_lid(dmg_builder* b, float width, float height, float depth, float wall, bool lifts) {
    if (lifts) {
        float skirt = height * dmg_range(b, 0.1f, 0.9f), w = width + 2.2f * wall, d = depth + 2.2f * wall;
        dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, skirt + 0.4f * height);
        dmg_save(b);
        dmg_move(b, 0, height - skirt + wall, 0);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_case_draw(b, DMG_CASE_BOARDS, w, d, skirt, wall);
        dmg_restore(b);
    } else {
        dmg_slide(b, 0, "lid", v3(0, 0, 1), 0.0f, 0.95f * depth);
        dmg_box(b, v3(0, height - 0.5f * wall, 0.02f * depth), v3(width - 1.2f * wall, 0.8f * wall, depth));
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, height, 0.4f * depth), v3(0.2f * width, wall, 0.05f * depth));
    }
    dmg_use(b, 0);
}

/* Draws a tray in a sleeve: matches, sliding drawers of cardboard. */
static void draw_sleeve(dmg_builder* b, float width, float height, float depth, float wall) {
    float x = 0.5f * width, y = 0.5f * height, xi = x - wall, yi = y - wall;
    const dmg_xy outer[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}}, inner[] = {{-xi, -yi}, {xi, -yi}, {xi, yi}, {-xi, yi}};
    dmg_move(b, 0, y, 0);
    dmg_ring_plate(b, outer, inner, 4, -0.5f * depth, 0.5f * depth);
    uint32_t tray = dmg_slide(b, 0, "tray", v3(0, 0, 1), -0.9f * depth, 0.9f * depth);
    dmg_move(b, 0, -yi, 0.5f * depth);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 1.96f * xi, 1.9f * yi, depth, wall);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, tray, dmg_range(b, 0, 0.6f) * depth);
    dmg_use(b, 0);
}

/* Draws two lids that open like wings, with trays under them sometimes: tool boxes. */
static void draw_wings(dmg_builder* b, float width, float height, float depth, float wall) {
    float rise = 0.12f * height;
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * 0.5f * depth;
        dmg_hinge(b, 0, s < 0 ? "lid_back" : "lid_front", v3(0, height, z), v3((float)s, 0, 0), 0.0f,
                  dmg_range(b, 1.5f, 2.6f));
        dmg_box(b, v3(0, height + 0.5f * rise, 0.5f * z), v3(width, rise, 0.49f * depth));
    }
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.5f * (width - wall), height + 1.2f * rise, 0), v3(wall, 2.4f * rise, 0.06f * depth));
    dmg_rod(b, v3(-0.5f * width, height + 2.4f * rise, 0), v3(0.5f * width, height + 2.4f * rise, 0), 0.02f * depth);
}

void dmg_build_box(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.05f, 0.7f), height = width * dmg_scale_range(b, 0.2f, 1.2f),
          depth = width * dmg_range(b, 0.4f, 1.0f), wall = width * dmg_range(b, 0.008f, 0.03f);
    static const float weights[] = {4, 1.5f, 1.5f, 1, 1};
    int kind = dmg_weighted(b, weights, 5);
    if (kind == 3) {
        draw_sleeve(b, width, fminf(height, 0.5f * width), depth * 1.4f, wall);
        return;
    }
    draw_open_box(b, width, height, depth, wall);
    if (kind == 0) draw_flaps(b, width, height, depth, wall);
    if (kind == 1) draw_sliding_lid(b, width, height, depth, wall, true);
    if (kind == 2) draw_sliding_lid(b, width, height, depth, wall, false);
    if (kind == 4) draw_wings(b, width, height, depth, wall);
}

/* ---- pot ---- */

static void draw_pot_handles(dmg_builder* b, float radius, float height, bool pan) {
    float t = radius * dmg_range(b, 0.05f, 0.12f);
    if (pan) {
        float length = radius * dmg_range(b, 1.2f, 2.5f);
        dmg_beam(b, v3(0.95f * radius, 0.85f * height, 0), v3(radius + length, height * dmg_range(b, 0.85f, 1.2f), 0),
                 2 * t, t);
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_handle loop = {DMG_HANDLE_ARCH, 0.7f * radius, 1.2f * t, 0.4f * radius, 0.6f};
        dmg_save(b);
        dmg_move(b, (float)s * radius, 0.75f * height, 0);
        dmg_turn(b, v3(0, 1, 0), (float)s * 0.5f * DMG_PI);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &loop, radius);
        dmg_restore(b);
    }
}

/* Draws a spout towards +X and a bail or a grip: kettles and teapots. */
static void draw_kettle(dmg_builder* b, float radius, float height) {
    const dmg_vec spout[] = {
        {0.85f * radius, 0.35f * height, 0}, {1.3f * radius, 0.55f * height, 0}, {1.5f * radius, 0.95f * height, 0}};
    dmg_sweep(b, spout, 3, 0.14f * radius, 0.14f * radius, false);
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, 0, "handle", v3(0, 0.95f * height, 0), v3(0, 0, 1), -1.2f, 1.2f);
        dmg_vec path[9];
        for (int i = 0; i < 9; ++i) {
            float angle = DMG_PI * (float)i / 8.0f;
            path[i] = v3(0, 0.95f * height + 0.9f * height * sinf(angle), radius * cosf(angle));
        }
        dmg_sweep(b, path, 9, 0.05f * radius, 0.08f * radius, false);
        dmg_use(b, 0);
        return;
    }
    const dmg_vec grip[] = {{-0.9f * radius, 0.85f * height, 0},
                            {-1.5f * radius, 0.8f * height, 0},
                            {-1.45f * radius, 0.3f * height, 0},
                            {-0.95f * radius, 0.25f * height, 0}};
    dmg_sweep(b, grip, 4, 0.07f * radius, 0.12f * radius, false);
}

void dmg_build_pot(dmg_builder* b) {
    float radius = dmg_range(b, 0.08f, 0.2f), height = radius * dmg_scale_range(b, 0.5f, 2.0f),
          rise = radius * dmg_range(b, 0.1f, 0.4f), over = dmg_range(b, 0.95f, 1.04f);
    int kind = dmg_int(b, 0, 2), lid = dmg_int(b, 0, 3), knob = dmg_int(b, 0, 4);
    if (kind == 2) { /* bulging */
        const dmg_xy profile[] = {{0, 0},
                                  {0.8f * radius, 0},
                                  {1.15f * radius, 0.4f * height},
                                  {radius, height},
                                  {0.95f * radius, height},
                                  {1.08f * radius, 0.4f * height},
                                  {0.7f * radius, 0.06f * height},
                                  {0, 0.06f * height}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 8);
        draw_kettle(b, radius, height);
    } else {
        draw_round_vessel(b, radius * dmg_range(b, 0.8f, 1.0f), radius, height, 0.04f * radius);
        draw_pot_handles(b, radius, height, kind == 1);
    }
    dmg_move(b, 0, height, 0);
    bool hinged = kind == 2 && dmg_chance(b, 0.4f);
    if (hinged)
        dmg_hinge(b, 0, "lid", v3(-radius, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.0f, 2.0f));
    else
        dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, height * dmg_range(b, 0.5f, 1.5f));
    draw_round_lid(b, lid, radius * over, rise);
    dmg_save(b);
    dmg_move(b, 0, rise * (lid == 1 ? 0.95f : 1.0f), 0);
    if (knob == 4) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.2f * radius, 0.04f * radius);
    dmg_face_up(b);
    if (knob < 4)
        dmg_knob_draw(b, knob == 1 ? 3 : (knob == 2 ? 6 : 0), radius * dmg_range(b, 0.12f, 0.25f), 0.2f * radius);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- toilet ---- */

/* An egg: round behind, longer in front. */
static void egg(dmg_xy* out, int count, float width, float length, float scale) {
    for (int i = 0; i < count; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)count, s = sinf(angle);
        out[i] = (dmg_xy){0.5f * width * scale * cosf(angle), (s < 0.0f ? 0.62f : 0.38f) * length * scale * s};
    }
}

static void draw_bowl(dmg_builder* b, float width, float length, float height) {
    enum { POINTS = 20 };
    dmg_xy outline[POINTS];
    float foot = dmg_range(b, 0.45f, 0.75f), waist = foot * dmg_range(b, 0.75f, 1.0f),
          at = height * dmg_range(b, 0.2f, 0.5f);
    /* Up the outside, over the rim and down into the bowl. */
    const dmg_row rows[] = {{foot, foot, 0, 0},
                            {waist, waist, 0, at},
                            {0.85f, 0.85f, 0, 0.75f * height},
                            {1, 1, 0, 0.9f * height},
                            {1, 1, 0, height},
                            {0.8f, 0.8f, 0, height},
                            {0.7f, 0.7f, 0, 0.8f * height},
                            {0.25f, 0.25f, 0, 0.45f * height}};
    egg(outline, POINTS, width, length, 1.0f);
    dmg_save(b);
    dmg_face_up(b);
    dmg_loft(b, outline, POINTS, rows, 8);
    dmg_restore(b);
}

static void draw_cistern(dmg_builder* b, float width, float height, float depth, float seat, float z) {
    float lid = 0.08f * height;
    dmg_box(b, v3(0, seat + 0.5f * height, z), v3(width, height, depth));
    bool lever = dmg_chance(b, 0.4f), loose = dmg_chance(b, 0.4f);
    float top = seat + height + lid;
    uint32_t carrier = 0;
    if (loose) carrier = dmg_slide(b, 0, "tank_lid", v3(0, 1, 0), 0.0f, height);
    dmg_box(b, v3(0, seat + height + 0.5f * lid, z), v3(1.04f * width, lid, 1.06f * depth));
    dmg_use(b, 0);
    dmg_save(b);
    if (lever) {
        float x = dmg_sign(b) * 0.4f * width;
        dmg_move(b, x, seat + 0.85f * height, z + 0.5f * depth);
        dmg_hinge(b, 0, "flush_lever", v3(0, 0, 0), v3(0, 0, x < 0 ? -1 : 1), 0.0f, 0.7f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.03f), 0.012f);
        dmg_beam(b, v3(0, 0, 0.03f), v3(x < 0 ? 0.08f : -0.08f, 0, 0.03f), 0.01f, 0.015f);
    } else {
        dmg_move(b, 0, top, z);
        dmg_face_up(b);
        dmg_buttons flush = {"flush_button", dmg_int(b, 1, 2), 1,      0.045f,          0, 0.04f,
                             0.04f,          0.008f,           0.006f, dmg_int(b, 0, 1)};
        dmg_buttons_draw(b, carrier, &flush);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_toilet(dmg_builder* b) {
    enum { POINTS = 20 };
    float width = dmg_range(b, 0.33f, 0.42f), length = dmg_range(b, 0.42f, 0.55f), seat = dmg_range(b, 0.35f, 0.45f),
          t = dmg_range(b, 0.012f, 0.025f);
    dmg_xy outline[POINTS], hole[POINTS];
    draw_bowl(b, width, length, seat);
    float back = -0.36f * length;
    if (dmg_chance(b, 0.85f)) {
        float deep = dmg_range(b, 0.14f, 0.22f);
        dmg_box(b, v3(0, 0.5f * seat, back - 0.4f * deep), v3(0.5f * width, seat, 1.1f * deep));
        float wide = width * dmg_range(b, 0.9f, 1.25f), tall = dmg_range(b, 0.28f, 0.42f);
        draw_cistern(b, wide, tall, deep, seat, back - 0.55f * deep);
    }
    egg(outline, POINTS, width, length, 1.02f);
    egg(hole, POINTS, width, length, 0.66f);
    float up = seat + t * dmg_range(b, 0, 1), far = dmg_range(b, 1.4f, 1.75f), z = back + dmg_range(b, 0.0f, 0.03f);
    bool with_seat = dmg_chance(b, 0.85f), open = dmg_chance(b, 0.3f);
    if (with_seat) {
        uint32_t ring = dmg_hinge(b, 0, "seat", v3(0, up, z), v3(-1, 0, 0), 0.0f, far);
        dmg_save(b);
        dmg_face_up(b);
        dmg_ring_plate(b, outline, hole, POINTS, seat, seat + t);
        dmg_restore(b);
        if (open && dmg_chance(b, 0.4f)) dmg_rest(b, ring, 0.98f * far);
    }
    float under = seat + (with_seat ? 1.05f * t : 0.0f);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, up, z), v3(-1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_face_up(b);
    dmg_extrude(b, outline, POINTS, under, under + t);
    dmg_restore(b);
    if (open) dmg_rest(b, lid, far);
    dmg_use(b, 0);
}

/* ---- suitcase ---- */

/* Draws one half shell, its opening at z = 0. */
static void draw_shell(dmg_builder* b, int kind, float width, float height, float depth) {
    if (kind == 0) dmg_case_draw(b, dmg_case_pick(b), width, height, depth, 0.03f * depth + 0.004f);
    if (kind == 1) dmg_rounded_plate(b, width, height, depth, 0.12f * width);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth), 0.3f * depth);
    for (int i = -2; i <= 2 && kind == 1; ++i)
        dmg_box(b, v3((float)i * 0.15f * width, 0, -depth), v3(0.04f * width, 0.9f * height, 0.04f * depth));
}

static void draw_case_handle(dmg_builder* b, float width, float depth) {
    float length = 0.3f * width, rise = 0.14f * width, t = 0.02f * width;
    dmg_handle grip = {DMG_HANDLE_ARCH, length, 1.4f * t, rise, dmg_range(b, 0.1f, 0.9f)};
    dmg_save(b);
    bool turns = dmg_chance(b, 0.7f);
    if (turns) dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(1, 0, 0), -1.5f, 1.5f);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle_draw(b, &grip, width);
    if (turns && dmg_chance(b, 0.5f)) dmg_rest(b, b->part_count, dmg_range(b, -1.5f, 1.5f));
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.5f * length, 0.2f * t, 0), v3(2 * t, 2 * t, 0.3f * depth));
    }
}

static void draw_trolley(dmg_builder* b, float width, float height, float depth) {
    dmg_slide(b, 0, "telescope", v3(0, 1, 0), 0.0f, 0.6f * height);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.2f * width, -0.7f * height, -0.8f * depth),
                v3((float)s * 0.2f * width, 0.05f * height, -0.8f * depth), 0.012f * height);
    dmg_box(b, v3(0, 0.06f * height, -0.8f * depth), v3(0.48f * width, 0.04f * height, 0.05f * height));
    dmg_use(b, 0);
    float wheel = 0.04f * height;
    for (int i = 0; i < 4; ++i) {
        float x = i & 1 ? 0.4f * width : -0.4f * width, z = i & 2 ? 0.7f * depth : -0.7f * depth;
        uint32_t caster = 0;
        if (dmg_chance(b, 0.9f)) {
            caster = dmg_spin(b, 0, "caster", v3(x, 0, z), v3(0, 1, 0));
            dmg_box(b, v3(x, -height - 0.4f * wheel, z), v3(wheel, wheel, wheel));
        }
        dmg_save(b);
        dmg_move(b, x, -height - 1.1f * wheel, z + 0.3f * wheel);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_spin(b, caster, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, 0, wheel, 0.5f * wheel, 4);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_suitcase(dmg_builder* b) {
    float width = dmg_range(b, 0.3f, 0.75f), height = width * dmg_range(b, 0.6f, 1.5f),
          depth = width * dmg_range(b, 0.12f, 0.3f), share = dmg_range(b, 0.25f, 0.5f);
    int kind = dmg_int(b, 0, 2);
    bool lying = dmg_chance(b, 0.5f), trolley = !lying && height > width && dmg_chance(b, 0.7f),
         side_hung = trolley && dmg_chance(b, 0.5f);
    float back = depth * (1.0f - share), front = depth * share;
    if (lying) {
        dmg_move(b, 0, back, 0);
        dmg_face_up(b);
    } else {
        dmg_move(b, 0, 0.5f * height, 0);
    }
    draw_shell(b, kind, width, height, back);
    /* The hinge lies in the seam, below or (standing trolleys) at the side. */
    dmg_vec seam = side_hung ? v3(-0.5f * width - 0.02f * depth, 0, 0)
                             : v3(0, -0.5f * height - dmg_range(b, -0.05f, 0.05f) * depth, 0);
    float far = dmg_range(b, 1.5f, 3.1f);
    uint32_t lid = dmg_hinge(b, 0, "lid", seam, side_hung ? v3(0, -1, 0) : v3(1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    draw_shell(b, kind, width, height, front);
    dmg_restore(b);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, lid, dmg_range(b, 0.4f, fminf(far, 2.0f)));
    dmg_use(b, 0);
    int latches = side_hung ? 0 : dmg_int(b, 0, 2);
    for (int i = 0; i < latches; ++i) { /* over the seam on the side that opens */
        float x = latches == 1 ? 0.0f : ((float)i - 0.5f) * 0.5f * width, t = 0.02f * width;
        dmg_hinge(b, 0, "latch", v3(x, 0.5f * height + t, -0.2f * back), v3(-1, 0, 0), 0.0f, 1.8f);
        dmg_box(b, v3(x, 0.5f * height + 0.5f * t, 0), v3(0.1f * width, t, 0.5f * front));
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * height, -0.5f * back);
    if (trolley) draw_trolley(b, width, height, 0.5f * depth);
    draw_case_handle(b, width, back);
}

/* ---- mailbox ---- */

/* An arch: rectangle below, half a circle above, centred on the floor line. */
static int arch(dmg_xy* out, float width, float height) {
    enum { STEPS = 9 };
    float r = 0.5f * width;
    out[0] = (dmg_xy){-r, 0};
    out[1] = (dmg_xy){r, 0};
    for (int i = 0; i < STEPS; ++i) {
        float angle = DMG_PI * (float)i / (STEPS - 1);
        out[2 + i] = (dmg_xy){r * cosf(angle), height - r + r * sinf(angle)};
    }
    return 2 + STEPS;
}

static void draw_mail_flag(dmg_builder* b, float x, float length, float height) {
    float t = 0.04f * height, tall = 0.5f * height;
    uint32_t flag = dmg_hinge(b, 0, "flag", v3(x, 0.35f * height, 0.2f * length), v3(1, 0, 0), 0.0f, 1.57f);
    dmg_box(b, v3(x + t, 0.35f * height + 0.5f * tall, 0.2f * length), v3(t, tall, 1.5f * t));
    dmg_box(b, v3(x + t, 0.35f * height + 0.9f * tall, 0.2f * length + 2 * t), v3(t, 0.3f * tall, 5 * t));
    if (dmg_chance(b, 0.5f)) dmg_rest(b, flag, 1.57f);
    dmg_use(b, 0);
}

void dmg_build_mailbox(dmg_builder* b) {
    float width = dmg_range(b, 0.14f, 0.35f), height = width * dmg_range(b, 0.9f, 1.5f),
          length = width * dmg_range(b, 0.5f, 2.5f), post = dmg_chance(b, 0.6f) ? dmg_range(b, 0.6f, 1.2f) : 0.0f,
          t = 0.04f * width;
    bool arched = dmg_chance(b, 0.5f), drop = dmg_chance(b, 0.3f);
    if (post > 0.0f) dmg_box(b, v3(0, 0.5f * post, 0), v3(0.4f * width, post, 0.4f * width));
    dmg_move(b, 0, post, 0);
    if (arched) {
        dmg_xy outline[16], inner[16];
        int count = arch(outline, width, height);
        for (int i = 0; i < count; ++i)
            inner[i] = (dmg_xy){outline[i].x * 0.92f, 0.04f * height + outline[i].y * 0.92f};
        dmg_ring_plate(b, outline, inner, count, -0.5f * length, 0.5f * length);
        dmg_extrude(b, outline, count, -0.5f * length - t, -0.5f * length);
        dmg_hinge(b, 0, "door", v3(0, 0, 0.5f * length + 0.5f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 1.4f, 2.4f));
        dmg_extrude(b, outline, count, 0.5f * length, 0.5f * length + t);
        dmg_box(b, v3(0, 0.9f * height, 0.5f * length + 1.5f * t), v3(0.15f * width, 0.05f * height, 2 * t));
        dmg_use(b, 0);
    } else {
        dmg_save(b);
        dmg_move(b, 0, 0.5f * height, 0.5f * length);
        dmg_case_draw(b, drop ? DMG_CASE_SOLID : dmg_case_pick(b), width, height, length, t);
        dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * width);
        leaf.width = 0.94f * width;
        leaf.height = drop ? 0.25f * height : 0.94f * height;
        leaf.thickness = t;
        leaf.side = drop ? DMG_SIDE_TOP : (dmg_chance(b, 0.5f) ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT);
        dmg_move(b, 0, drop ? 0.3f * height : 0.0f, t);
        dmg_leaf_draw(b, 0, drop ? "slot_flap" : "door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
        if (dmg_chance(b, 0.5f)) { /* a roof that is a lid */
            float roof = 1.15f * length;
            dmg_hinge(b, 0, "lid", v3(0, height, -0.5f * length), v3(-1, 0, 0), 0.0f, 1.5f);
            dmg_box(b, v3(0, height + 0.5f * t, 0.5f * (roof - length)), v3(1.1f * width, t, roof));
            dmg_use(b, 0);
        }
    }
    if (dmg_chance(b, 0.6f)) draw_mail_flag(b, 0.5f * width, length, height);
}
