/* Draws household shells: cases of two halves, grills that close on each other, boxes with sunk or overlaid doors,
 * bins with flaps, pots whose handles drop. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- a case of two half shells that meet in a plane ---- */

/* Half of a case, its open side at z = 0, its back at z = -depth. */
static void draw_half_shell(dmg_builder* b, int kind, float width, float height, float depth, float wall) {
    float small = fminf(fminf(width, height), depth);
    if (kind == 0) dmg_rounded_plate(b, width, height, depth, dmg_range(b, 0.05f, 0.3f) * fminf(width, height));
    if (kind == 1) dmg_rounded_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth), 0.3f * small);
    if (kind >= 2) dmg_case_draw(b, (dmg_case_kind)(kind - 2), width, height, depth, wall);
    int ribs = dmg_chance(b, 0.3f) ? dmg_int(b, 2, 7) : 0;
    for (int i = 0; i < ribs; ++i) {
        float x = width * 0.8f * (((float)i + 0.5f) / (float)ribs - 0.5f);
        dmg_box(b, v3(x, 0, -depth), v3(0.25f * width / (float)ribs, 0.85f * height, 0.06f * depth));
    }
}

/* Draws a clasp over the seam on the side x = edge, hung on the half behind it. */
static void draw_clasp(dmg_builder* b, float edge, float y, float size, uint32_t carrier) {
    float t = 0.25f * size;
    dmg_hinge(b, carrier, "clasp", v3(edge + 0.5f * t, y, -size), v3(0, 1, 0), 0.0f, dmg_range(b, 1.0f, 2.6f));
    dmg_box_span(b, v3(edge, y - 0.4f * size, -size), v3(edge + t, y + 0.4f * size, 0.8f * size));
    dmg_use(b, 0);
}

/* Draws a bail on the side facing +X at x = edge: folded against it, it stands out when lifted. */
static void draw_side_bail(dmg_builder* b, float edge, float span, float z) {
    float wire = span * dmg_range(b, 0.04f, 0.1f), reach = span * dmg_range(b, 0.25f, 0.5f), x = edge + wire;
    if (dmg_chance(b, 0.7f)) dmg_hinge(b, 0, "handle", v3(x, 0, z), v3(0, -1, 0), -1.4f, 1.4f);
    dmg_box(b, v3(x + reach, 0, z), v3(wire, span, wire));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(x + 0.5f * reach - 0.25f * wire, (float)s * 0.47f * span, z), v3(reach, 0.06f * span, wire));
    dmg_use(b, 0);
}

static void draw_pull_rods(dmg_builder* b, float width, float height, float z) {
    float apart = width * dmg_range(b, 0.15f, 0.35f), rod = 0.02f * width, out = height * dmg_range(b, 0.02f, 0.06f);
    dmg_slide(b, 0, "pull_handle", v3(0, 1, 0), 0.0f, height * dmg_range(b, 0.3f, 0.8f));
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * apart, -0.42f * height, z), v3((float)s * apart, 0.5f * height + out, z), rod);
    dmg_box(b, v3(0, 0.5f * height + out, z), v3(2.2f * apart, 3 * rod, 3 * rod));
    dmg_use(b, 0);
}

void dmg_build_shell_case(dmg_builder* b) {
    float width = dmg_range(b, 0.25f, 0.6f), height = width * dmg_scale_range(b, 0.6f, 1.9f),
          back = width * dmg_scale_range(b, 0.06f, 0.35f), front = back * dmg_scale_range(b, 0.35f, 1.6f);
    float wall = back * dmg_range(b, 0.03f, 0.1f), wheel = dmg_chance(b, 0.4f) ? 0.05f * width : 0.0f;
    int kind = dmg_int(b, 0, 5);
    bool flat = wheel == 0.0f && dmg_chance(b, 0.6f);
    dmg_move(b, 0, flat ? back : 0.5f * height + 2 * wheel, 0);
    if (flat) dmg_face_up(b);
    draw_half_shell(b, kind, width, height, back, wall);
    for (int i = 0; i < 2 && wheel > 0.0f; ++i) {
        float x = width * ((float)i - 0.5f) * 0.75f, y = -0.5f * height - wheel;
        dmg_spin(b, 0, "wheel", v3(x, y, -0.6f * back), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.5f * wheel, y, -0.6f * back), v3(x + 0.5f * wheel, y, -0.6f * back), wheel);
        dmg_use(b, 0);
        dmg_box(b, v3(x + 0.8f * wheel, y + 0.5f * wheel, -0.6f * back), v3(0.4f * wheel, 1.2f * wheel, wheel));
    }
    if (wheel > 0.0f && dmg_chance(b, 0.7f)) draw_pull_rods(b, width, height, -back - 0.03f * width);
    /* The seam's line: on the edge, beside it, or let into the seam by a little. */
    static const float beside[] = {0.0f, 0.0f, 0.5f, 1.0f};
    float off = beside[dmg_int(b, 0, 3)] * 0.12f * back, radius = back * dmg_range(b, 0.04f, 0.12f);
    uint32_t lid = dmg_hinge(b, 0, "shell", v3(-0.5f * width - off, 0, 0), v3(0, -1, 0), 0.0f,
                             dmg_chance(b, 0.4f) ? DMG_PI : dmg_range(b, 1.4f, 3.0f));
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    draw_half_shell(b, kind, width, height, front, wall);
    dmg_restore(b);
    dmg_hinge_style style = dmg_hinge_pick(b, radius);
    if (style.kind == DMG_HINGE_STRAP) style.kind = DMG_HINGE_BARREL;
    dmg_save(b);
    dmg_move(b, -0.5f * width - off, 0, 0);
    if (dmg_chance(b, 0.7f)) dmg_hinge_draw(b, &style, height, width, lid, 0);
    dmg_restore(b);
    int clasps = dmg_int(b, 0, 3);
    float clasp = fminf(0.5f * fminf(front, back), 0.06f * height);
    for (int i = 0; i < clasps; ++i)
        draw_clasp(b, 0.5f * width, 0.8f * height * (((float)i + 0.5f) / (float)clasps - 0.5f), clasp, 0);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) draw_side_bail(b, 0.5f * width, 0.25f * height, -0.5f * back);
}

/* ---- two plates that clap together: waffle irons, grills, presses for sandwiches ---- */

static void draw_plate_body(dmg_builder* b, bool round, float width, float depth, float low, float high, bool arched) {
    if (round) {
        const dmg_xy profile[] = {{0, low},
                                  {0.5f * width, low},
                                  {0.5f * width, 0.5f * (low + high)},
                                  {(arched ? 0.3f : 0.5f) * width, high},
                                  {0, high}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 5);
        return;
    }
    dmg_vec centre = {0, 0.5f * (low + high), 0}, size = {width, high - low, depth};
    if (arched)
        dmg_rounded_box(b, centre, size, 0.35f * (high - low));
    else
        dmg_box(b, centre, size);
}

void dmg_build_waffle_iron(dmg_builder* b) {
    bool round = dmg_chance(b, 0.5f), arched = dmg_chance(b, 0.6f), grip = dmg_chance(b, 0.8f),
         bracket = dmg_chance(b, 0.7f);
    float width = dmg_range(b, 0.18f, 0.4f), depth = round ? width : width * dmg_range(b, 0.6f, 1.2f);
    float low = width * dmg_range(b, 0.08f, 0.3f), high = width * dmg_range(b, 0.05f, 0.25f),
          gap = dmg_chance(b, 0.5f) ? 0.002f : width * dmg_range(b, 0.0f, 0.04f), foot = 0.03f * width;
    float rear = -0.5f * depth - (bracket ? width * dmg_range(b, 0.0f, 0.15f) : 0.0f), far = dmg_range(b, 1.2f, 1.9f);
    float up = low + gap + (bracket ? high * dmg_range(b, 0.0f, 0.8f) : 0.0f), wide = width * dmg_range(b, 0.1f, 0.6f);
    dmg_feet_draw(b, 3, 0.7f * width, 0.7f * depth, foot);
    dmg_move(b, 0, foot, 0);
    draw_plate_body(b, round, width, depth, 0, low, false);
    if (bracket) { /* one on each side of the line */
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.55f * wide - 0.03f * width, 0.3f * low, rear - 0.03f * width),
                         v3((float)s * 0.55f * wide + 0.03f * width, up + 0.03f * width, -0.47f * depth));
    }
    if (grip) dmg_box(b, v3(0, 0.8f * low, 0.58f * depth), v3(0.3f * width, 0.3f * low, 0.2f * depth));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, up, rear), v3(-1, 0, 0), 0.0f, far);
    draw_plate_body(b, round, width, depth, low + gap, low + gap + high, arched);
    dmg_rod(b, v3(-0.5f * wide, up, rear), v3(0.5f * wide, up, rear), 0.02f * width);
    dmg_box_span(b, v3(-0.35f * wide, up - 0.01f * width, rear), v3(0.35f * wide, up + 0.01f * width, -0.4f * depth));
    float reach = depth * dmg_range(b, 0.1f, 0.4f);
    if (grip)
        dmg_box(b, v3(0, low + gap + 0.4f * high, 0.47f * depth + 0.5f * reach), v3(0.3f * width, 0.3f * high, reach));
    if (dmg_chance(b, 0.3f)) dmg_cone(b, v3(0, low + gap + high, 0), v3(0, low + gap + 1.2f * high, 0), 0.02f, 0.015f);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, lid, far * dmg_range(b, 0.1f, 0.95f));
    dmg_use(b, 0);
    if (!round && dmg_chance(b, 0.4f)) {
        dmg_move(b, 0.3f * width, 0.5f * low, 0.5f * depth);
        dmg_knobs_draw(b, 0, 1, 0, 0, 0.2f * low);
    }
}

/* ---- a box with a door: sunk in a frame, laid on, or a pair ---- */

/* Draws a door whose outside, window and lining are shapes of their own; front at z = 0. */
static void draw_layered_door(dmg_builder* b, float width, float height, float t) {
    int kind = dmg_int(b, 0, 4);
    float w = width * dmg_range(b, 0.4f, 0.85f), h = height * dmg_range(b, 0.4f, 0.85f), thin = 0.15f * t;
    if (kind == 0) dmg_box(b, v3(0, 0, -0.5f * t), v3(width, height, t));
    if (kind == 1) { /* frame, pane, lining */
        float border = 0.5f * fminf(width - w, height - h);
        dmg_frame_draw(b, width, height, t, border);
        dmg_box_faces(b, v3(0, 0, -0.5f * t), v3(width - 1.9f * border, height - 1.9f * border, thin),
                      DMG_FACE_FRONT | DMG_FACE_BACK);
    }
    if (kind == 2) { /* two skins */
        dmg_box(b, v3(0, 0, -0.5f * thin), v3(width, height, thin));
        dmg_box(b, v3(0, 0, -0.6f * t), v3(w, h, 0.8f * t));
    }
    if (kind == 3) dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(width, height, t), 0.4f * t);
    if (kind == 4) dmg_panel_draw(b, &(dmg_panel){.kind = DMG_PANEL_BOWED}, width, height, t);
    if (kind != 1 && dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, 0), v3(w, h, 0.1f * thin));
}

/* Draws what opens it: a bar, a knob, a lever, a hand wheel's hub, or nothing. At the free edge, which is at +X. */
static void draw_door_grip(dmg_builder* b, uint32_t door, float width, float height) {
    int kind = dmg_int(b, 0, 4);
    dmg_save(b);
    const float y = height * dmg_range(b, -0.25f, 0.25f), x = 0.5f * width * dmg_range(b, 0.6f, 0.92f);
    dmg_move(b, x, y, 0);
    if (kind < 2) {
        dmg_handle bar = dmg_handle_pick_bar(b, 0.5f * height);
        bar.thickness = fminf(bar.thickness, 0.05f * width);
        bar.standoff = fminf(bar.standoff, 0.1f * width);
        dmg_handle_draw(b, &bar, 0.45f * height);
    }
    if (kind == 2) dmg_knobs_draw(b, door, 1, 0, 0, 0.035f * width + 0.02f * height);
    if (kind == 3) {
        float r = 0.015f * width, length = width * dmg_range(b, 0.12f, 0.3f);
        dmg_hinge(b, door, "lever", v3(0, 0, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.6f, 1.6f));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 3 * r), 1.4f * r);
        dmg_beam(b, v3(0, 0, 3 * r), v3(-length, 0, 3 * r), 1.5f * r, r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* The place is centred at the origin, the hung edge towards -X; z = 0 is where the case's front is. */
static void hang_layered_door(dmg_builder* b, float width, float height, float t, bool sunk) {
    float gap = sunk ? t * t / width + 0.004f * width : 0.0f, w = width - 2 * gap;
    float front = sunk ? 0.0f : t, out = dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.0f, 1.0f);
    float aside = sunk || dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.0f, 1.5f);
    float z = sunk ? front + 0.5f * out : front - out, x = -0.5f * w - aside;
    if (sunk) height -= 2 * gap;
    uint32_t door = dmg_hinge(b, 0, "door", v3(x, 0, z), v3(0, -1, 0), 0.0f, dmg_range(b, 1.3f, 2.4f));
    dmg_save(b);
    dmg_move(b, 0, 0, front);
    draw_layered_door(b, w, height, t);
    draw_door_grip(b, door, w, height);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, x, 0, z);
    dmg_hinge_style style = dmg_hinge_pick(b, 0.3f * t);
    if (style.kind != DMG_HINGE_LUGS && style.kind != DMG_HINGE_STRAP) dmg_hinge_draw(b, &style, height, w, door, 0);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_door_box(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.25f, 1.0f), height = width * dmg_scale_range(b, 0.5f, 2.2f),
          depth = width * dmg_range(b, 0.5f, 1.2f), wall = width * dmg_range(b, 0.02f, 0.08f),
          t = width * dmg_scale_range(b, 0.015f, 0.12f);
    bool sunk = dmg_chance(b, 0.4f), pair = width > 0.5f && dmg_chance(b, 0.3f);
    float panel = !pair && dmg_chance(b, 0.4f) ? width * dmg_range(b, 0.12f, 0.3f) : 0.0f,
          drawer = dmg_chance(b, 0.25f) ? height * dmg_range(b, 0.15f, 0.4f) : 0.0f;
    float foot = dmg_chance(b, 0.5f) ? 0.03f * width : 0.0f, door = height - drawer;
    if (foot > 0.0f) dmg_feet_draw(b, dmg_int(b, 0, 3), width, depth, foot);
    dmg_move(b, 0, foot + 0.5f * height, 0.5f * depth);
    if (dmg_chance(b, 0.4f)) dmg_mirror(b, v3(1, 0, 0));
    dmg_case_draw(b, (dmg_case_kind)dmg_int(b, 0, sunk ? 2 : 3), width, height, depth, wall);
    if (drawer > 0.0f) {
        dmg_drawer tray = dmg_drawer_pick(b, 0.3f * width);
        tray.width = width - 2.2f * wall;
        tray.height = drawer - 2.2f * wall;
        tray.thickness = t;
        tray.depth = 0.85f * depth;
        tray.travel = depth * dmg_range(b, 0.4f, 0.75f);
        dmg_save(b);
        dmg_move(b, 0, 0.5f * (drawer - height), sunk ? 0.0f : t);
        dmg_drawer_draw(b, 0, "drawer", &tray);
        dmg_restore(b);
        dmg_use(b, 0);
        dmg_box(b, v3(0, drawer - 0.5f * height, -0.5f * depth), v3(width - 2 * wall, wall, depth - 2 * wall));
    }
    dmg_move(b, 0, 0.5f * drawer, 0);
    if (panel > 0.0f) {
        dmg_save(b);
        dmg_move(b, 0.5f * (width - panel), 0, sunk ? 0.0f : t);
        dmg_box(b, v3(0, 0, -0.5f * t), v3(panel, door, t));
        if (dmg_chance(b, 0.8f)) dmg_controls_draw(b, 0, 0.8f * panel, 0.8f * door);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    float edge = sunk ? wall : 0.0f, place = width - panel - edge * (panel > 0.0f ? 1.0f : 2.0f);
    dmg_move(b, panel > 0.0f ? 0.5f * (edge - panel) : 0.0f, 0, 0);
    for (int i = 0; i < (pair ? 2 : 1); ++i) {
        float w = pair ? 0.497f * place : 0.995f * place;
        dmg_save(b);
        if (i == 1) dmg_mirror(b, v3(1, 0, 0));
        if (pair) dmg_move(b, -0.25f * place, 0, 0);
        hang_layered_door(b, w, door - 2.1f * edge, t, sunk);
        dmg_restore(b);
    }
}

/* ---- a bin with flaps that swing both ways ---- */

/* Draws a flap about X through the origin, reaching `down` below and `over` above its line. */
static void draw_swing_flap(dmg_builder* b, float width, float down, float over, float t, float way) {
    dmg_hinge(b, 0, "flap", v3(0, 0, 0), v3(1, 0, 0), -way, way);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.5f * width, -down, -0.5f * t), v3(0.5f * width, over, 0.5f * t));
    else
        dmg_rounded_box(b, v3(0, 0.5f * (over - down), 0), v3(width, over + down, t), 0.4f * t);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(-0.53f * width, 0, 0), v3(0.53f * width, 0, 0), 0.5f * t);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, -0.7f * down, 0.6f * t), v3(0.4f * width, 0.12f * down, 0.6f * t));
    dmg_use(b, 0);
}

void dmg_build_swing_bin(dmg_builder* b) {
    float width = dmg_range(b, 0.2f, 0.5f), depth = width * dmg_range(b, 0.5f, 1.1f),
          height = width * dmg_range(b, 0.8f, 2.2f), wall = width * dmg_range(b, 0.01f, 0.03f);
    float hood = width * dmg_range(b, 0.3f, 0.7f), t = wall * dmg_range(b, 0.5f, 1.2f), way = dmg_range(b, 0.5f, 1.2f);
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    dmg_face_up(b);
    dmg_case_draw(b, dmg_chance(b, 0.5f) ? DMG_CASE_BOARDS : DMG_CASE_DOUBLE, width, depth, height, wall);
    dmg_restore(b);
    int kind = dmg_int(b, 0, 2);
    dmg_move(b, 0, height, 0);
    float inner = width - 2.6f * wall;
    if (kind == 0) { /* a plate in a collar on top, about its middle or near it */
        float share = dmg_chance(b, 0.5f) ? 0.5f : dmg_range(b, 0.3f, 0.7f), room = depth - 3.2f * wall;
        dmg_face_up(b);
        dmg_move(b, 0, 0, 2 * wall);
        dmg_frame_draw(b, width, depth, 2 * wall, wall);
        dmg_move(b, 0, room * (share - 0.5f), -wall);
        draw_swing_flap(b, inner, share * room, (1.0f - share) * room, t, way);
        return;
    }
    for (int s = -1; s <= 1; s += 2) { /* gable walls */
        float x = (float)s * 0.5f * (width - wall), z = 0.5f * depth, lean = kind == 1 ? 0.15f : 1.0f;
        const dmg_xy side[] = {{-z, 0}, {z, 0}, {lean * z, hood}, {-lean * z, hood}};
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_extrude(b, side, 4, -0.5f * wall, 0.5f * wall);
        dmg_restore(b);
    }
    float top = kind == 1 ? 0.15f * depth : depth;
    dmg_box(b, v3(0, hood + 0.5f * wall, 0), v3(width, wall, top));
    bool both = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * 0.5f * (top - 1.2f * wall), drop = hood - wall, slope = 0.0f;
        if (kind == 1) slope = atan2f(0.5f * depth - fabsf(z) - wall, drop);
        dmg_save(b);
        if (s < 0) dmg_turn(b, v3(0, 1, 0), DMG_PI);
        dmg_move(b, 0, hood - 0.5f * wall, fabsf(z));
        dmg_turn(b, v3(1, 0, 0), -slope);
        if (s > 0 || both)
            draw_swing_flap(b, inner, 0.97f * drop / cosf(slope), 0, t, way);
        else
            dmg_box(b, v3(0, -0.5f * drop / cosf(slope), 0), v3(inner, drop / cosf(slope), t));
        dmg_restore(b);
    }
}

/* ---- a pot whose handles drop on pivots ---- */

/* Draws a loop at x = 0 that reaches towards +X; its ears are on the wall. */
static void draw_drop_loop(dmg_builder* b, float span, float reach, float tube) {
    enum { POINTS = 7 };
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1);
        path[i] = v3(reach * powf(fabsf(sinf(angle)), 0.6f), 0, -0.5f * span * cosf(angle));
    }
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(-tube, 0, (float)s * 0.5f * span), v3(2 * tube, 3 * tube, 3 * tube));
    const float upper = dmg_range(b, 0.3f, 1.4f), lower = -dmg_range(b, 0.9f, 1.5f);
    dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 0, 1), lower, upper);
    dmg_sweep(b, path, POINTS, tube, tube, false);
    dmg_use(b, 0);
}

void dmg_build_drop_pot(dmg_builder* b) {
    float r = dmg_range(b, 0.08f, 0.25f), foot = r * dmg_range(b, 0.7f, 1.0f), height = r * dmg_range(b, 0.5f, 2.0f),
          wall = r * dmg_range(b, 0.02f, 0.07f), dome = r * dmg_range(b, 0.05f, 0.5f);
    const dmg_xy profile[] = {{0, 0}, {foot, 0}, {r, height}, {r - wall, height}, {foot - wall, wall}, {0, wall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), profile, 6);
    float span = r * dmg_range(b, 0.4f, 0.9f), tube = r * dmg_range(b, 0.02f, 0.05f),
          at = height * dmg_range(b, 0.6f, 0.92f), reach = fminf(r * dmg_range(b, 0.25f, 0.6f), 0.9f * at);
    bool drops = dmg_chance(b, 0.8f);
    int around = dmg_int(b, 0, 3) == 0 ? 3 : 2;
    for (int i = 0; i < around && drops; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, around);
        dmg_move(b, r + 1.5f * tube, at, 0);
        draw_drop_loop(b, span, reach, tube);
        dmg_restore(b);
    }
    int closed = drops ? dmg_int(b, 0, 2) : 1;
    if (closed == 0) return;
    float rear = -r - wall * dmg_range(b, 0.0f, 2.0f), up = height + wall * dmg_range(b, 0.0f, 1.0f);
    if (closed == 1) {
        dmg_box_span(b, v3(-0.15f * r, height - 0.15f * r, rear - wall), v3(0.15f * r, height, -0.9f * r));
        uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, up, rear), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.3f, 2.0f));
        dmg_box(b, v3(0, height + 0.5f * wall, 0.5f * (rear - 0.9f * r)), v3(0.2f * r, wall, -rear - 0.8f * r));
        if (dmg_chance(b, 0.3f)) dmg_rest(b, lid, dmg_range(b, 0.2f, 1.2f));
    } else {
        dmg_slide(b, 0, "lid", v3(0, 1, 0), 0.0f, 1.5f * height);
    }
    const dmg_xy cover[] = {{0, height},
                            {1.01f * r, height},
                            {1.01f * r, height + wall},
                            {0.5f * r, height + 0.8f * dome + wall},
                            {0, height + dome + wall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cover, 5);
    float top = height + dome + 0.9f * wall;
    dmg_cone(b, v3(0, top, 0), v3(0, top + 0.2f * r, 0), 0.06f * r, 0.14f * r);
    dmg_use(b, 0);
}
