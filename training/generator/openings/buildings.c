/* Draws doors of large buildings: hangars, garages, drawbridges. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a hall, open in front at z = 0: flat, gabled or round roof. */
static void draw_hall(dmg_builder* b, int roof, float width, float height, float depth, float wall) {
    float x = 0.5f * width;
    dmg_box_span(b, v3(-x, 0, -depth), v3(-x + wall, height, 0));
    dmg_box_span(b, v3(x - wall, 0, -depth), v3(x, height, 0));
    if (dmg_chance(b, 0.8f)) dmg_box_span(b, v3(-x, 0, -depth), v3(x, height, -depth + wall));
    if (roof == 0) dmg_box_span(b, v3(-1.02f * x, height, -1.01f * depth), v3(1.02f * x, height + wall, 0.01f * depth));
    if (roof == 1) {
        float ridge = height + width * dmg_range(b, 0.1f, 0.35f);
        const dmg_xy gable[] = {{-x, height}, {x, height}, {0, ridge}},
                     line[] = {{-1.04f * x, height}, {0, ridge + wall}, {1.04f * x, height}};
        dmg_extrude(b, gable, 3, -wall, 0);
        dmg_extrude(b, gable, 3, -depth, -depth + wall);
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * depth);
        dmg_bent_plate(b, line, 3, 0.5f * wall, 1.03f * depth);
        dmg_restore(b);
    }
    if (roof == 2) {
        enum { POINTS = 11 };
        dmg_xy line[POINTS];
        float rise = width * dmg_range(b, 0.12f, 0.4f);
        for (int i = 0; i < POINTS; ++i) {
            float angle = DMG_PI * (1.0f - (float)i / (POINTS - 1));
            line[i] = (dmg_xy){x * cosf(angle), height + rise * sinf(angle)};
        }
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * depth);
        dmg_bent_plate(b, line, POINTS, 0.5f * wall, depth);
        dmg_restore(b);
        if (dmg_chance(b, 0.5f)) {
            dmg_xy flipped[POINTS];
            for (int i = 0; i < POINTS; ++i) flipped[i] = line[POINTS - 1 - i];
            dmg_extrude(b, flipped, POINTS, -wall, 0);
        }
    }
}

/* Leaves on several tracks, half of them to each side. */
static void draw_hangar_leaves(dmg_builder* b, float width, float height, float t) {
    int leaves = dmg_int(b, 1, 4) * 2, half = leaves / 2;
    float w = width / (float)leaves;
    dmg_panel panel = dmg_panel_pick(b);
    if (panel.kind == DMG_PANEL_BOWED) panel.kind = DMG_PANEL_FLAT;
    for (int i = 0; i < leaves; ++i) {
        bool right = i >= half;
        int from_side = right ? leaves - 1 - i : i; /* 0 is outermost and stays on the last track */
        float x = w * ((float)i + 0.5f) - 0.5f * width, z = t * (1.2f * (float)(half - from_side));
        float travel = (float)(from_side + 1) * 0.95f * w;
        dmg_slide(b, 0, "door", v3(right ? 1.0f : -1.0f, 0, 0), 0.0f, travel);
        dmg_save(b);
        dmg_move(b, x, 0, z);
        dmg_panel_draw(b, &panel, 1.02f * w, height, t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0.5f * height, 0.6f * t * (float)half), v3(2 * width, 0.04f * height, 1.3f * t * (float)half));
}

/* Leaves in one row, some of them walled in: those that move all go the same way, before or behind the others. */
static void draw_leaf_row(dmg_builder* b, float width, float height, float t) {
    int leaves = dmg_int(b, 2, 6);
    float w = width / (float)leaves, way = dmg_sign(b), step = dmg_chance(b, 0.6f) ? 1.0f : dmg_range(b, 0.5f, 1.0f);
    dmg_panel panel = {.kind = DMG_PANEL_FLAT};
    if (dmg_chance(b, 0.4f)) panel = dmg_panel_pick(b);
    if (panel.kind == DMG_PANEL_BOWED) panel.kind = DMG_PANEL_FLAT;
    int first = dmg_int(b, 0, 1), moving = 0;
    for (int i = 0; i < leaves; ++i) {
        bool moves = (i + first) % 2 == 0 || (i + 1 == leaves && moving == 0);
        float travel = step * w * (i + 1 == leaves || i == 0 || dmg_chance(b, 0.7f) ? 1.0f : 2.0f);
        dmg_use(b, 0);
        if (moves) dmg_slide(b, 0, "door", v3(way, 0, 0), 0.0f, travel);
        moving += moves;
        dmg_save(b);
        dmg_move(b, w * ((float)i + 0.5f) - 0.5f * width, 0, moves ? 1.1f * t : 0.0f);
        dmg_panel_draw(b, &panel, 1.01f * w, height, t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a gate that falls outwards about the floor, its outline that of the hall's mouth. */
static void draw_falling_gate(dmg_builder* b, float width, float height, float t) {
    float x = 0.5f * width, y = 0.5f * height, corner = dmg_range(b, 0.1f, 0.9f) * x,
          low = dmg_range(b, -0.2f, 0.6f) * y;
    const dmg_xy cut[] = {{-x, -y}, {x, -y}, {x, low}, {x - corner, y}, {corner - x, y}, {-x, low}};
    const dmg_xy plain[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    bool trapezoid = dmg_chance(b, 0.5f);
    float back = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.0f, 1.0f) * t;
    dmg_hinge(b, 0, "gate", v3(0, -y, t - back), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.6f));
    dmg_extrude(b, trapezoid ? cut : plain, trapezoid ? 6 : 4, 0.05f * t, t);
    dmg_use(b, 0);
}

/* Draws two quarters of a dome before the mouth, which slide apart. */
static void draw_shell_doors(dmg_builder* b, float width, float height) {
    float radius = 0.5f * width, squash = 2.0f * height / width, t = 0.03f * radius;
    for (int s = -1; s <= 1; s += 2) {
        enum { ROWS = 7, COLUMNS = 7 };
        dmg_slide(b, 0, "door", v3((float)s, 0, 0), 0.0f, radius * dmg_range(b, 0.7f, 1.0f));
        for (int i = 0; i + 1 < COLUMNS; ++i) { /* bars from the floor to the crown, boards between them */
            float from = 0.5f * DMG_PI * (float)i / (COLUMNS - 1), to = 0.5f * DMG_PI * (float)(i + 1) / (COLUMNS - 1);
            for (int k = 0; k + 1 < ROWS; ++k) {
                float up = 0.47f * DMG_PI * (float)k / (ROWS - 1), above = 0.47f * DMG_PI * (float)(k + 1) / (ROWS - 1);
                float middle = 0.5f * (from + to);
                dmg_vec low = {(float)s * radius * cosf(middle) * cosf(up), radius * squash * sinf(up),
                               radius * sinf(middle) * cosf(up)};
                dmg_vec high = {(float)s * radius * cosf(middle) * cosf(above), radius * squash * sinf(above),
                                radius * sinf(middle) * cosf(above)};
                dmg_beam(b, low, high, 0.9f * radius * (to - from) * cosf(0.5f * (up + above)), t);
            }
        }
    }
    dmg_use(b, 0);
}

void dmg_build_hangar_door(dmg_builder* b) {
    float width = dmg_scale_range(b, 8, 40), height = width * dmg_range(b, 0.18f, 0.45f),
          depth = width * dmg_range(b, 0.5f, 1.8f), wall = 0.012f * width, t = 0.012f * width;
    draw_hall(b, dmg_int(b, 0, 2), width, height, depth, wall);
    int kind = dmg_int(b, 0, 7);
    if (kind == 7) draw_shell_doors(b, 0.98f * width, height);
    dmg_move(b, 0, 0.5f * height, 0);
    if (kind == 4 || kind == 5) draw_leaf_row(b, width, height, t * dmg_range(b, 0.3f, 1.2f));
    if (kind == 6) draw_falling_gate(b, 0.97f * width, height, t);
    if (kind <= 1) draw_hangar_leaves(b, width, height, t);
    if (kind == 2) { /* one leaf, hung above, tilts out; or goes straight up */
        bool lifts = dmg_chance(b, 0.4f);
        dmg_panel panel = dmg_panel_pick(b);
        float out = t * dmg_range(b, 0, 1), far = dmg_range(b, 1.2f, 1.6f);
        if (lifts)
            dmg_slide(b, 0, "door", v3(0, 1, 0), 0.0f, 0.9f * height);
        else
            dmg_hinge(b, 0, "door", v3(0, 0.5f * height, out), v3(-1, 0, 0), 0.0f, far);
        dmg_move(b, 0, 0, t);
        dmg_panel_draw(b, &panel, width, height, t);
        dmg_use(b, 0);
    }
    if (kind == 3) { /* swinging halves */
        dmg_leaf leaf = dmg_leaf_pick(b, 0.1f * width);
        leaf.width = 0.498f * width;
        leaf.height = height;
        leaf.thickness = t;
        for (int i = 0; i < 2; ++i) {
            leaf.side = i == 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
            dmg_save(b);
            dmg_move(b, ((float)i - 0.5f) * 0.5f * width, 0, t);
            dmg_leaf_draw(b, 0, "door", &leaf);
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
}

/* ---- garage ---- */

/* Slats one over the other, drawn as one curtain. */
static void draw_curtain(dmg_builder* b, float width, float height, float t) {
    int slats = dmg_int(b, 4, 10);
    for (int i = 0; i < slats; ++i) {
        float h = height / (float)slats;
        dmg_box(b, v3(0, h * ((float)i + 0.5f) - 0.5f * height, -0.5f * t), v3(width, 0.93f * h, t));
    }
}

void dmg_build_garage_door(dmg_builder* b) {
    float width = dmg_range(b, 2.2f, 5.0f), height = dmg_range(b, 1.9f, 2.6f), depth = width * dmg_range(b, 0.8f, 2.0f),
          t = dmg_range(b, 0.03f, 0.08f), side = dmg_range(b, 0.1f, 0.6f);
    bool hall = dmg_chance(b, 0.6f);
    if (hall) {
        draw_hall(b, dmg_int(b, 0, 1), width + 2 * side, height * 1.15f, depth, 0.1f);
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.5f * (width + side), 0.575f * height, -0.1f), v3(side, 1.15f * height, 0.2f));
    dmg_box(b, v3(0, 1.075f * height, -0.1f), v3(width, 0.15f * height, 0.2f));
    dmg_move(b, 0, 0.5f * height, -0.06f);
    int kind = dmg_int(b, 0, 2);
    dmg_panel panel = dmg_panel_pick(b);
    if (kind == 0) { /* up and over: about a line below the top */
        float at = height * dmg_range(b, 0.2f, 0.5f);
        dmg_hinge(b, 0, "door", v3(0, at, dmg_range(b, -1, 0) * t), v3(-1, 0, 0), 0.0f, 1.5f);
    } else {
        dmg_slide(b, 0, "door", v3(0, 1, 0), 0.0f, 0.92f * height);
    }
    if (kind == 2)
        draw_curtain(b, 0.99f * width, height, t);
    else
        dmg_panel_draw(b, &panel, 0.99f * width, height, t);
    dmg_save(b);
    dmg_move(b, 0, -0.35f * height, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle handle = dmg_handle_pick(b, 0.2f);
    dmg_handle_draw(b, &handle, 1.0f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- drawbridge ---- */

/* Draws a gatehouse whose bridge is its door: it lies open or stands closed. */
static void draw_castle_bridge(dmg_builder* b) {
    float width = dmg_range(b, 2.5f, 5.0f), height = width * dmg_range(b, 1.0f, 1.6f),
          tower = width * dmg_range(b, 0.4f, 0.8f), t = 0.05f * width;
    bool round = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * (width + tower);
        if (round)
            dmg_rod(b, v3(x, 0, -0.4f * tower), v3(x, 1.6f * height, -0.4f * tower), 0.52f * tower);
        else
            dmg_box(b, v3(x, 0.8f * height, -0.45f * tower), v3(tower, 1.6f * height, 0.9f * tower));
    }
    dmg_box_span(b, v3(-0.5f * width, height, -0.7f * tower), v3(0.5f * width, 1.35f * height, -0.15f * tower));
    float far = 1.57f;
    uint32_t bridge =
        dmg_hinge(b, 0, "bridge", v3(0, t * dmg_range(b, -0.5f, 1.0f), 0.02f * tower), v3(1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * height, t);
    dmg_panel planks = {.kind = dmg_chance(b, 0.6f) ? DMG_PANEL_PLANKS : DMG_PANEL_FLAT, .bars_x = 5};
    dmg_panel_draw(b, &planks, 0.96f * width, height, t);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) dmg_rest(b, bridge, far);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.4f)) { /* a portcullis behind it */
        dmg_panel grid = {.kind = DMG_PANEL_BARS, .border = 0.04f, .bars_x = 5, .bars_y = 4};
        dmg_slide(b, 0, "portcullis", v3(0, 1, 0), 0.0f, 0.8f * height);
        dmg_save(b);
        dmg_move(b, 0, 0.5f * height, -0.4f * tower);
        dmg_panel_draw(b, &grid, 0.98f * width, height, t);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Road decks that rise, one or two. */
static void draw_bascule(dmg_builder* b) {
    float span = dmg_range(b, 10, 30), width = span * dmg_range(b, 0.15f, 0.4f), t = 0.04f * span, clear = 0.25f * span,
          far = dmg_range(b, 0.9f, 1.45f);
    int leaves = dmg_int(b, 1, 2);
    for (int s = -1; s <= 1; s += 2) { /* abutments with the road behind them */
        float x = (float)s * 0.5f * span;
        dmg_box_span(b, v3(fminf(x, x + (float)s * 0.4f * span), clear - t, -0.5f * width),
                     v3(fmaxf(x, x + (float)s * 0.4f * span), clear, 0.5f * width));
        dmg_box_span(b, v3(fminf(x, x + (float)s * 0.15f * span), 0, -0.45f * width),
                     v3(fmaxf(x, x + (float)s * 0.15f * span), clear - t, 0.45f * width));
    }
    for (int i = 0; i < leaves; ++i) {
        float side = i == 0 ? -1.0f : 1.0f, x = side * 0.5f * span, length = 0.99f * span / (float)leaves;
        dmg_hinge(b, 0, "bridge", v3(x, clear - t * dmg_range(b, 0, 1), 0), v3(0, 0, -side), 0.0f, far);
        dmg_box_span(b, v3(fminf(x, x - side * length), clear - 0.8f * t, -0.48f * width),
                     v3(fmaxf(x, x - side * length), clear, 0.48f * width));
        for (int k = -1; k <= 1; k += 2) {
            if (k > 0 || dmg_chance(b, 0.8f))
                dmg_box(b, v3(x - side * 0.5f * length, clear + 0.4f * t, (float)k * 0.46f * width),
                        v3(length, 0.8f * t, 0.02f * width));
        }
    }
    dmg_use(b, 0);
}

void dmg_build_drawbridge(dmg_builder* b) {
    if (dmg_chance(b, 0.55f))
        draw_castle_bridge(b);
    else
        draw_bascule(b);
}
