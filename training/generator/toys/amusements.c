/* Draws arcade cabinets, pinball tables, music boxes and jacks-in-the-box, and the carts from which such things are
 * sold. The player stands at +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- things on a face: z = 0, +Z towards the player ---- */

static void draw_round_button(dmg_builder* b, uint32_t parent, float r) {
    float rise = r * dmg_range(b, 0.3f, 0.9f);
    if (dmg_chance(b, 0.4f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.15f * r, 0.15f * r);
    dmg_slide(b, parent, "button", v3(0, 0, -1), 0.0f, rise * dmg_range(b, 0.3f, 0.8f));
    const dmg_xy cap[] = {{r, -0.6f * r}, {r, 0.8f * rise}, {0.85f * r, rise}, {0, rise * dmg_range(b, 0.75f, 1.1f)}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cap, 4);
    dmg_use(b, parent);
}

/* Draws a ball, a bat or a grip on a shaft that leans about its pivot below the panel, to the side or to and fro. */
static void draw_stick(dmg_builder* b, uint32_t parent, float r) {
    float tall = r * dmg_range(b, 2.5f, 4.5f), pivot = r * dmg_range(b, 0.0f, 1.5f), lean = dmg_range(b, 0.2f, 0.45f);
    if (dmg_chance(b, 0.7f)) dmg_cone(b, v3(0, 0, 0), v3(0, 0, 0.15f * r), 1.3f * r, 1.1f * r);
    dmg_hinge(b, parent, "stick", v3(0, 0, -pivot), dmg_chance(b, 0.5f) ? v3(1, 0, 0) : v3(0, 1, 0), -lean, lean);
    dmg_rod(b, v3(0, 0, -pivot), v3(0, 0, tall), 0.22f * r);
    int top = dmg_int(b, 0, 2);
    if (top == 0) dmg_ellipsoid(b, v3(0, 0, tall), v3(0.8f * r, 0.8f * r, 0.8f * r));
    if (top == 1) dmg_cone(b, v3(0, 0, 0.35f * tall), v3(0, 0, 1.1f * tall), 0.3f * r, 0.7f * r);
    if (top == 2) dmg_rounded_box(b, v3(0, 0, 0.8f * tall), v3(0.9f * r, 1.1f * r, 0.9f * tall), 0.3f * r);
    dmg_use(b, parent);
}

/* Draws a door for the coins on its side hinge, in it slots, keys that give coins back, and a flap over the tray. */
static void draw_coin_door(dmg_builder* b, float width, float high) {
    float t = 0.05f * width, side = dmg_sign(b), x = side * 0.5f * width;
    dmg_save(b);
    dmg_move(b, 0, 0, 0.6f * t);
    if (dmg_chance(b, 0.5f)) dmg_frame_draw(b, 1.12f * width, 1.08f * high, 0.6f * t, 0.05f * width);
    dmg_restore(b);
    float line = t * dmg_unit(b), swing = dmg_range(b, 1.3f, 2.2f);
    uint32_t door = dmg_hinge(b, 0, "coin_door", v3(x, 0, line), v3(0, side, 0), 0.0f, swing);
    dmg_box_span(b, v3(-0.5f * width, -0.5f * high, 0.02f * t), v3(0.5f * width, 0.5f * high, t));
    int slots = dmg_int(b, 1, 2);
    for (int i = 0; i < slots; ++i) {
        float at = slots == 1 ? 0.0f : (i ? 0.22f : -0.22f) * width, w = 0.28f * width, y = 0.22f * high;
        dmg_use(b, door);
        dmg_box(b, v3(at, y, 1.1f * t), v3(w, 0.3f * high, 0.4f * t));
        dmg_slide(b, door, "return_key", v3(0, 0, -1), 0.0f, 0.6f * t);
        dmg_box_span(b, v3(at - 0.2f * w, y - 0.08f * high, 0.5f * t), v3(at + 0.2f * w, y + 0.08f * high, 2.2f * t));
        dmg_hinge(b, door, "coin_flap", v3(at, -0.12f * high, 1.15f * t), v3(1, 0, 0), -dmg_range(b, 0.5f, 1.2f), 0.0f);
        dmg_box_span(b, v3(at - 0.45f * w, -0.32f * high, t), v3(at + 0.45f * w, -0.12f * high, 1.3f * t));
    }
    if (dmg_chance(b, 0.5f)) { /* its lock */
        dmg_hinge(b, door, "lock", v3(-0.8f * x, 0, t), v3(0, 0, 1), 0.0f, 1.57f);
        dmg_rod(b, v3(-0.8f * x, 0, 0.8f * t), v3(-0.8f * x, 0, 1.5f * t), 0.05f * width);
        dmg_box(b, v3(-0.8f * x, 0, 1.9f * t), v3(0.02f * width, 0.09f * width, t));
    }
    dmg_use(b, 0);
}

/* ---- arcade cabinet ---- */

/* Draws a player's place about the origin of the panel: stick and keys, a ball to roll, a wheel or a dial to turn. */
static void draw_player(dmg_builder* b, float room) {
    int kind = dmg_weighted(b, (const float[]){3, 0.7f, 0.6f, 0.6f}, 4), keys = dmg_int(b, 1, 6);
    float r = 0.07f * room;
    dmg_save(b);
    dmg_move(b, -0.27f * room, 0, 0);
    if (kind == 0) draw_stick(b, 0, 1.1f * r);
    if (kind == 1) { /* the ball shows a third of itself */
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.75f * r, 0.2f * r);
        dmg_spin(b, 0, "ball", v3(0, 0, -0.6f * r), dmg_chance(b, 0.5f) ? v3(1, 0, 0) : v3(0, 1, 0));
        dmg_ellipsoid(b, v3(0, 0, -0.6f * r), v3(1.8f * r, 1.8f * r, 1.8f * r));
    }
    if (kind == 2) {
        dmg_spin(b, 0, "dial", v3(0, 0, 0), v3(0, 0, 1));
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 1.2f * r, 1.5f * r);
    }
    if (kind == 3) {
        float turn = dmg_range(b, 1.5f, 4.5f);
        dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, 1), -turn, turn);
        dmg_rod(b, v3(0, 0, -r), v3(0, 0, 1.8f * r), 0.5f * r);
        dmg_move(b, 0, 0, 1.8f * r);
        dmg_wheel_draw(b, 3, 2.6f * r, 0.8f * r, 3);
    }
    dmg_restore(b);
    for (int i = 0; i < keys; ++i) {
        dmg_use(b, 0);
        dmg_save(b);
        dmg_move(b, 0.08f * room + 0.17f * room * (float)(i % 3), (i / 3 ? -0.1f : 0.1f) * room, 0);
        draw_round_button(b, 0, 0.06f * room);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_arcade_cabinet(dmg_builder* b) {
    bool upright = dmg_chance(b, 0.75f);
    float high = upright ? dmg_range(b, 1.4f, 2.0f) : dmg_range(b, 0.4f, 0.7f),
          width = upright ? high * dmg_range(b, 0.32f, 0.48f) : high * dmg_range(b, 0.7f, 1.1f);
    float deep = 0.5f * high * (upright ? 0.75f : 1.2f), wall = 0.03f * width,
          panel = high * (upright ? dmg_range(b, 0.48f, 0.56f) : 0.3f);
    float nose = 0.5f * deep, screen = nose - 0.55f * deep, lean = dmg_range(b, 0.05f, 0.3f), rise = 0.05f * high;
    /* The side as seen from its right: (-z, y). */
    const dmg_xy side[] = {{-nose, 0.75f * panel},
                           {-nose, panel},
                           {-screen, panel + 2.2f * rise},
                           {-screen + 0.3f * lean * high, 0.85f * high},
                           {-nose + 0.15f * deep, 0.88f * high},
                           {-nose + 0.18f * deep, high},
                           {0.5f * deep, high},
                           {0.5f * deep, 0},
                           {-nose + 0.1f * deep, 0},
                           {-nose + 0.1f * deep, 0.7f * panel}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* x of the outline runs to -Z */
    bool cheeks = dmg_chance(b, 0.6f);
    if (!cheeks)
        dmg_extrude(
            b, (dmg_xy[]){side[9], side[8], side[7], side[6], side[5], side[4], side[3], side[2], side[1], side[0]}, 10,
            -0.5f * width, 0.5f * width);
    dmg_restore(b);
    if (cheeks) { /* two boards, and between them front, panel, screen and head */
        for (int s = -1; s <= 1; s += 2) {
            float from = (float)s > 0 ? 0.5f * width - wall : -0.5f * width;
            dmg_save(b);
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_extrude(
                b, (dmg_xy[]){side[9], side[8], side[7], side[6], side[5], side[4], side[3], side[2], side[1], side[0]},
                10, from, from + wall);
            dmg_restore(b);
        }
        float x = 0.5f * width - wall;
        dmg_box_span(b, v3(-x, 0, nose - 0.12f * deep - wall), v3(x, 0.8f * panel, nose - 0.12f * deep));
        dmg_box_span(b, v3(-x, 0.84f * high, nose - 0.2f * deep - wall), v3(x, 0.98f * high, nose - 0.2f * deep));
        dmg_box_span(b, v3(-x, 0, -nose), v3(x, 0.98f * high, -nose + wall));
        dmg_box_span(b, v3(-x, 0.95f * high, -nose), v3(x, 0.98f * high, nose - 0.2f * deep));
        dmg_box_span(b, v3(-x, panel + rise, screen - 0.35f * lean * high - wall),
                     v3(x, 0.86f * high, screen - 0.35f * lean * high));
    }
    /* The panel slopes from its nose up to the screen's foot. */
    float slope = atan2f(1.7f * rise, nose - screen), face = hypotf(nose - screen, 1.7f * rise);
    dmg_save(b);
    dmg_move(b, 0, panel + 1.2f * rise, 0.5f * (nose + screen));
    dmg_turn(b, v3(1, 0, 0), slope - 0.5f * DMG_PI);
    dmg_box_span(b, v3(-0.5f * width, -0.5f * face, -0.8f * rise), v3(0.5f * width, 0.5f * face, 0));
    int players = upright && width > 0.5f ? dmg_int(b, 1, 2) : 1;
    for (int i = 0; i < players; ++i) {
        dmg_save(b);
        dmg_move(b, players == 1 ? 0 : (i ? 0.24f : -0.24f) * width, 0, 0);
        draw_player(b, fminf(width / (float)players, 1.6f * face) * 0.9f);
        dmg_restore(b);
    }
    dmg_restore(b);
    if (upright && dmg_chance(b, 0.8f)) {
        dmg_save(b);
        dmg_move(b, 0, 0.35f * panel, nose - (cheeks ? 0.12f : 0.1f) * deep);
        float wide = width * dmg_range(b, 0.4f, 0.65f), tall = panel * dmg_range(b, 0.4f, 0.6f);
        draw_coin_door(b, wide, tall);
        dmg_restore(b);
    }
    if (!dmg_chance(b, 0.4f)) return;
    float door = 0.5f * high, hinge = dmg_sign(b) * 0.42f * width; /* the door behind */
    dmg_hinge(b, 0, "service_door", v3(hinge, 0, -nose), v3(0, hinge > 0 ? -1.0f : 1.0f, 0), 0.0f, 1.8f);
    dmg_box_span(b, v3(-0.42f * width, 0.1f * high, -nose - wall), v3(0.42f * width, 0.1f * high + door, -nose));
    dmg_use(b, 0);
}

/* ---- pinball ---- */

/* On the field: y away from the player, z up. A bat on an upright pin, tapered to its tip. */
static void draw_flipper(dmg_builder* b, float side, float length, float high) {
    float r = 0.14f * length, droop = dmg_range(b, 0.3f, 0.6f), swing = dmg_range(b, 0.7f, 1.1f);
    dmg_hinge(b, 0, "flipper", v3(0, 0, 0), v3(0, 0, -side), 0.0f, swing);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), side > 0 ? DMG_PI + droop : -droop);
    const dmg_xy bat[] = {
        {0, -r}, {length, -0.5f * r},   {1.03f * length, 0}, {length, 0.5f * r}, {0, r}, {-0.7f * r, 0.7f * r},
        {-r, 0}, {-0.7f * r, -0.7f * r}};
    dmg_extrude(b, bat, 8, 0.1f * high, high);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 1.15f * high), 0.5f * r);
    dmg_use(b, 0);
}

static void draw_field(dmg_builder* b, float width, float length, float high) {
    float bat = width * dmg_range(b, 0.15f, 0.22f), y = -0.36f * length, x = bat + 0.05f * width;
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * x, y, 0);
        draw_flipper(b, (float)s, bat, high);
        dmg_restore(b);
        dmg_beam(b, v3((float)s * (x + 0.03f * width), y + 0.03f * length, 0.5f * high),
                 v3((float)s * 0.44f * width, y + 0.12f * length, 0.5f * high), 0.02f * width, high);
    }
    int bumpers = dmg_int(b, 0, 4), targets = dmg_int(b, 0, 4);
    for (int i = 0; i < bumpers; ++i) {
        float bx = width * dmg_range(b, -0.3f, 0.3f), by = length * (0.05f + 0.09f * (float)i), r = 0.06f * width;
        dmg_rod(b, v3(bx, by, 0), v3(bx, by, 0.7f * high), 0.7f * r);
        dmg_rod(b, v3(bx, by, 0.7f * high), v3(bx, by, 1.1f * high), r);
    }
    for (int i = 0; i < targets; ++i) { /* plates that drop when hit */
        float tx = -0.42f * width, ty = -0.1f * length + 0.05f * length * (float)i;
        dmg_slide(b, 0, "target", v3(0, 0, -1), 0.0f, 0.9f * high);
        dmg_box_span(b, v3(tx, ty, 0), v3(tx + 0.02f * width, ty + 0.04f * length, high));
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.5f)) return;
    float sx = 0.3f * width, sy = 0.1f * length, w = 0.1f * width; /* a vane the ball spins */
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(sx + (float)s * 0.6f * w, sy, 0), v3(sx + (float)s * 0.6f * w, sy, 1.1f * high), 0.06f * w);
    dmg_spin(b, 0, "spinner", v3(sx, sy, high), v3(1, 0, 0));
    dmg_rod(b, v3(sx - 0.6f * w, sy, high), v3(sx + 0.6f * w, sy, high), 0.03f * w);
    dmg_box(b, v3(sx, sy, 0.85f * high), v3(w, 0.04f * w, 0.5f * high));
    dmg_use(b, 0);
}

void dmg_build_pinball_table(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.35f, 1.4f), width = length * dmg_range(b, 0.45f, 0.6f),
          box = length * dmg_range(b, 0.18f, 0.3f),
          legs = dmg_chance(b, 0.7f) ? length * dmg_range(b, 0.4f, 0.65f) : 0.0f, wall = 0.03f * width,
          tilt = dmg_range(b, 0.06f, 0.14f);
    float x = 0.5f * width, z = 0.5f * length, rim = 0.35f * box, back = length * dmg_range(b, 0.35f, 0.6f);
    for (int i = 0; i < 4 && legs > 0; ++i) {
        float px = (i & 1 ? 0.92f : -0.92f) * x, pz = (i & 2 ? 0.94f : -0.94f) * z;
        dmg_box_span(b, v3(px - wall, -0.03f * length, pz - wall), v3(px + wall, legs + 0.6f * box, pz + wall));
    }
    dmg_move(b, 0, legs + 0.5f * box + z * sinf(tilt), 0);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), tilt - 0.5f * DMG_PI); /* y away from the player along the field, z up */
    dmg_box_span(b, v3(-x, -z, -0.5f * box), v3(x, z, 0));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * (x - 0.5f * wall) - 0.5f * wall, -z, 0),
                     v3((float)s * (x - 0.5f * wall) + 0.5f * wall, z, rim));
        dmg_box_span(b, v3(-x, (float)s * (z - 0.5f * wall) - 0.5f * wall, 0),
                     v3(x, (float)s * (z - 0.5f * wall) + 0.5f * wall, rim));
    }
    draw_field(b, 0.94f * width, length, 0.6f * rim);
    for (int s = -1; s <= 1; s += 2) { /* the buttons of the bats, at the sides */
        dmg_save(b);
        dmg_move(b, (float)s * x, -0.8f * z, 0.3f * rim);
        dmg_turn(b, v3(0, 1, 0), (float)s * 0.5f * DMG_PI);
        draw_round_button(b, 0, 0.25f * rim);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.8f)) { /* drawn out towards the player */
        float r = 0.12f * rim, px = 0.8f * x;
        dmg_slide(b, 0, "plunger", v3(0, -1, 0), 0.0f, 0.06f * length);
        dmg_rod(b, v3(px, -0.9f * z, 0.3f * rim), v3(px, -z - 5 * r, 0.3f * rim), 0.6f * r);
        dmg_rod(b, v3(px, -z - 7 * r, 0.3f * rim), v3(px, -z - 5 * r, 0.3f * rim), 1.8f * r);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) { /* the glass: slid out to the front or lifted at its rear hinge */
        if (dmg_chance(b, 0.5f))
            dmg_slide(b, 0, "glass", v3(0, -1, 0), 0.0f, 0.8f * length);
        else
            dmg_hinge(b, 0, "glass", v3(0, z - 0.13f * length, rim), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.3f));
        dmg_box_span(b, v3(-x + 0.3f * wall, -z, rim), v3(x - 0.3f * wall, z - 0.13f * length, rim + 0.2f * wall));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.5f)) {
        dmg_save(b);
        dmg_move(b, 0, -z, -0.25f * box);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        draw_coin_door(b, 0.4f * width, 0.4f * box);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.75f)) { /* the head: fixed, or folded down over the field for the road */
        float deep = 0.12f * length;
        if (dmg_chance(b, 0.4f)) dmg_hinge(b, 0, "head", v3(0, z - deep, 1.2f * rim), v3(1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(-1.1f * x, z - deep, 1.2f * rim), v3(1.1f * x, z, 1.2f * rim + back));
        dmg_use(b, 0);
        dmg_box_span(b, v3(-0.8f * x, z - 0.9f * deep, 0.9f * rim), v3(0.8f * x, z, 1.2f * rim));
    }
    dmg_restore(b);
}

/* ---- music boxes ---- */

/* At (x, y, z) on a side facing `out` along X, or behind along -Z: a crank, or a key that winds. */
static void draw_winder(dmg_builder* b, dmg_vec at, dmg_vec out, float size) {
    float r = 0.08f * size, reach = size * dmg_range(b, 0.4f, 0.8f);
    dmg_vec end = v3_mad(at, out, 3 * r), up = v3_add(end, v3(0, reach, 0));
    dmg_spin(b, 0, "crank", at, out);
    dmg_rod(b, v3_mad(at, out, -2 * r), v3_mad(end, out, r), r);
    if (dmg_chance(b, 0.6f)) {
        dmg_beam(b, end, up, 1.6f * r, 1.6f * r);
        dmg_rod(b, up, v3_mad(up, out, 0.5f * reach), 1.2f * r);
    } else {
        dmg_vec wing = v3_mad(end, out, 1.5f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_torus(b, v3_add(wing, v3(0, (float)s * 2.2f * r, 0)), v3_cross(out, v3(0, 1, 0)), 1.8f * r, 0.6f * r);
    }
    dmg_use(b, 0);
}

/* Draws a dancer, a horse's pole or a tree on a disc that turns. */
static void draw_dancer(dmg_builder* b, float x, float y, float z, float r, float tall) {
    dmg_spin(b, 0, "dancer", v3(x, y, z), v3(0, 1, 0));
    dmg_rod(b, v3(x, y, z), v3(x, y + 0.08f * tall, z), r);
    if (dmg_chance(b, 0.5f)) {
        dmg_cone(b, v3(x, y + 0.3f * tall, z), v3(x, y + 0.6f * tall, z), 0.8f * r, 0.2f * r);
        dmg_rod(b, v3(x, y, z), v3(x, y + 0.85f * tall, z), 0.12f * r);
        dmg_ellipsoid(b, v3(x, y + 0.9f * tall, z), v3(0.25f * r, 0.1f * tall, 0.25f * r));
        dmg_beam(b, v3(x, y + 0.7f * tall, z), v3(x + 0.6f * r, y + tall, z), 0.12f * r, 0.12f * r);
    } else {
        int count = dmg_int(b, 2, 5);
        dmg_rod(b, v3(x, y, z), v3(x, y + tall, z), 0.15f * r);
        dmg_cone(b, v3(x, y + 0.8f * tall, z), v3(x, y + tall, z), r, 0);
        for (int i = 0; i < count; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / (float)count;
            dmg_ellipsoid(b, v3(x + 0.75f * r * cosf(angle), y + 0.35f * tall, z + 0.75f * r * sinf(angle)),
                          v3(0.2f * r, 0.15f * tall, 0.2f * r));
        }
    }
    dmg_use(b, 0);
}

/* Out of the box on its spring: it slides up, or leans on it. */
static void draw_jack(dmg_builder* b, float y, float r, float rise, float way) {
    if (dmg_chance(b, 0.7f))
        dmg_slide(b, 0, "jack", v3(0, 1, 0), 0.0f, way);
    else
        dmg_hinge(b, 0, "jack", v3(0, y, 0), dmg_chance(b, 0.5f) ? v3(1, 0, 0) : v3(0, 0, 1), -0.5f, 0.5f);
    for (int i = 0; i < 5; ++i) dmg_torus(b, v3(0, y + 0.12f * rise * (float)i, 0), v3(0, 1, 0), 0.6f * r, 0.08f * r);
    dmg_cone(b, v3(0, y, 0), v3(0, y + 0.6f * rise, 0), 0.5f * r, 0.4f * r);
    dmg_ellipsoid(b, v3(0, y + 0.75f * rise, 0), v3(0.6f * r, 0.22f * rise, 0.6f * r));
    if (dmg_chance(b, 0.6f)) dmg_cone(b, v3(0, y + 0.9f * rise, 0), v3(0, y + 1.3f * rise, 0), 0.45f * r, 0);
    dmg_use(b, 0);
}

/* Over the box, whose corner is `at`: a slab or a hollow lid this tall, hung behind or at a side, or slid off. */
static void draw_music_lid(dmg_builder* b, bool round, dmg_vec at, float tall, float wall) {
    int way = dmg_weighted(b, (const float[]){4, 1, 1}, 3);
    float swing = dmg_range(b, 1.2f, 1.9f), over = dmg_range(b, 0.0f, 0.5f) * wall, side = dmg_sign(b);
    if (way == 0)
        dmg_hinge(b, 0, "lid", v3(0, at.y, -at.z - dmg_range(b, 0.0f, 0.5f) * wall), v3(-1, 0, 0), 0.0f, swing);
    if (way == 1) dmg_hinge(b, 0, "lid", v3(side * (at.x + over), at.y, 0), v3(0, 0, -side), 0.0f, swing);
    if (way == 2) dmg_slide(b, 0, "lid", v3(side, 0, 0), 0.0f, 1.5f * at.x);
    const dmg_xy cap[] = {{at.x, 0}, {at.x, 0.8f * tall}, {0.8f * at.x, tall}, {0, tall}};
    dmg_vec low = {-at.x - over, at.y, -at.z}, high = {at.x + over, at.y + tall, at.z + over};
    if (round)
        dmg_lathe(b, v3(0, at.y, 0), v3(0, 1, 0), cap, 4);
    else if (tall <= wall)
        dmg_box_span(b, low, high);
    else
        dmg_box_faces(b, v3_lerp(low, high, 0.5f), v3_sub(high, low), DMG_FACE_ALL & ~DMG_FACE_BOTTOM);
    if (dmg_chance(b, 0.4f)) dmg_ellipsoid(b, v3(0, at.y + tall, 0), v3(0.3f * at.x, 0.5f * wall, 0.3f * at.z));
    dmg_use(b, 0);
}

void dmg_build_music_box(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.06f, 0.4f), deep = width * dmg_range(b, 0.6f, 1.0f),
          high = width * dmg_range(b, 0.35f, 1.0f), wall = width * dmg_range(b, 0.03f, 0.07f), x = 0.5f * width,
          z = 0.5f * deep, hollow = dmg_chance(b, 0.5f) ? wall : width * dmg_range(b, 0.1f, 0.4f);
    int inside = dmg_int(b, 0, 2); /* a dancer, a jack, the works */
    bool round = dmg_chance(b, 0.2f), lid = dmg_chance(b, 0.8f), drawer = !round && inside != 1 && dmg_chance(b, 0.35f);
    float floor = inside == 1 ? wall : high * dmg_range(b, 0.4f, 0.7f);
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    dmg_face_up(b);
    const dmg_xy drum[] = {{0, -high}, {x, -high}, {x, 0}, {x - wall, 0}, {x - wall, floor - high}, {0, floor - high}};
    if (round)
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), drum, 6);
    else
        dmg_case_draw(b, inside == 1 ? DMG_CASE_BOARDS : DMG_CASE_DOUBLE, width, deep,
                      high - (drawer ? 0.35f * high : 0), wall);
    dmg_restore(b);
    if (drawer) { /* the base under the case has it */
        dmg_drawer d = dmg_drawer_pick(b, 0.2f * width);
        d.width = 0.9f * width;
        d.height = 0.28f * high;
        d.thickness = fminf(d.thickness, wall);
        d.depth = 0.8f * deep;
        d.travel = 0.6f * deep;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * (x - 0.5f * wall) - 0.5f * wall, 0, -z),
                         v3((float)s * (x - 0.5f * wall) + 0.5f * wall, 0.35f * high, z));
        dmg_box_span(b, v3(-x, 0, -z), v3(x, 0.03f * high, z - wall));
        dmg_save(b);
        dmg_move(b, 0, 0.19f * high, z);
        dmg_drawer_draw(b, 0, "drawer", &d);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (inside != 1) {
        floor = fmaxf(floor, 0.5f * high);
        if (!round) dmg_box_span(b, v3(-x + wall, floor - wall, -z + wall), v3(x - wall, floor, z - wall));
    }
    float r = 0.35f * fminf(x, z), at = inside == 0 ? dmg_range(b, -0.4f, 0.4f) * x : 0.0f;
    if (inside == 0)
        draw_dancer(b, at, floor, 0, r, lid ? 0.85f * (high - floor + hollow) : width * dmg_range(b, 0.4f, 1.0f));
    if (inside == 1)
        draw_jack(b, wall, 0.8f * fminf(x, z), lid ? 0.7f * high : 1.4f * high, lid ? 0.9f * high : 0.4f * high);
    if (inside == 2) { /* a drum with pins before a comb */
        float d = 0.12f * width, y = floor + 1.2f * d;
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.3f * width, floor + d, -0.1f * deep), v3(0.04f * width, 2 * d, d));
        dmg_box(b, v3(0, floor + 0.4f * d, 0.2f * deep), v3(0.5f * width, 0.3f * d, 0.25f * deep));
        dmg_spin(b, 0, "drum", v3(0, y, -0.1f * deep), v3(1, 0, 0));
        dmg_rod(b, v3(-0.27f * width, y, -0.1f * deep), v3(0.27f * width, y, -0.1f * deep), 0.8f * d);
        dmg_rod(b, v3(-0.33f * width, y, -0.1f * deep), v3(0.33f * width, y, -0.1f * deep), 0.2f * d);
        for (int i = 0; i < 9; ++i) {
            dmg_save(b);
            dmg_move(b, width * (0.05f * (float)i - 0.2f), y, -0.1f * deep);
            dmg_turn(b, v3(1, 0, 0), 2.4f * (float)i);
            dmg_rod(b, v3(0, 0.7f * d, 0), v3(0, d, 0), 0.06f * d);
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
    float side = dmg_sign(b);
    if (dmg_chance(b, 0.7f))
        draw_winder(b, v3(side * x, 0.5f * high, 0), v3(side, 0, 0), 0.6f * high);
    else
        draw_winder(b, v3(0, 0.5f * high, -z), v3(0, 0, -1), 0.5f * high);
    if (lid) draw_music_lid(b, round, v3(x, high, z), hollow, wall);
}
