/* Draws aircraft: aeroplanes with their control surfaces, helicopters, drones; windsocks; and submarines. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/wings.h"

/* Both sides alike. A whole tailplane may turn about a line across it instead. */
static void draw_pair(dmg_builder* b, const dmg_wing* w, const dmg_surface* surfaces, int count, bool all_moving) {
    for (int side = 0; side < 2; ++side) {
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        dmg_use(b, 0);
        if (all_moving) {
            dmg_vec pivot = dmg_wing_point(w, 0, 0.4f, 0);
            dmg_hinge(b, 0, "tailplane", pivot, v3(1, 0, 0), -0.4f, 0.4f);
            dmg_wing_piece_draw(b, w, 0.03f, 1, 0, 1);
        } else {
            dmg_wing_draw(b, w, 0, surfaces, count);
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- fuselages about Z, nose to +Z ---- */

enum { STATIONS = 7 };

/* Turned about Z; squeezed along X by the frame. */
static void draw_fuselage(dmg_builder* b, float radius, float nose, float tail) {
    dmg_xy profile[STATIONS] = {{0, -tail},
                                {0.12f * radius, -0.99f * tail},
                                {0.45f * radius, -0.6f * tail},
                                {radius, -0.15f * tail},
                                {radius, 0.35f * nose},
                                {0.6f * radius, 0.8f * nose},
                                {0, nose}};
    profile[4].x *= dmg_range(b, 0.9f, 1.05f);
    profile[5].x *= dmg_range(b, 0.5f, 1.2f);
    if (dmg_chance(b, 0.25f)) { /* square */
        dmg_box(b, v3(0, 0, 0.15f * nose), v3(1.8f * radius, 1.8f * radius, 1.3f * nose));
        dmg_beam(b, v3(0, 0, -0.4f * nose), v3(0, 0.3f * radius, -tail), 0.6f * radius, 0.6f * radius);
        return;
    }
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, STATIONS);
}

/* Draws a door lying on a round side at z, hung at its front or upper edge. */
static void draw_side_door(dmg_builder* b, float radius, float z) {
    float width = radius * dmg_range(b, 0.6f, 1.0f), height = radius * dmg_range(b, 0.7f, 1.2f);
    float side = dmg_sign(b), lean = dmg_range(b, 0.0f, 0.3f), t = 0.03f * radius;
    int kind = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, side * 0.98f * radius, 0.1f * radius, z);
    dmg_turn(b, v3(0, 1, 0), side * 0.5f * DMG_PI); /* its outside becomes +Z */
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * height);
    leaf.width = width;
    leaf.height = height;
    leaf.thickness = t;
    leaf.side = kind == 2 ? DMG_SIDE_TOP : (kind == 3 ? DMG_SIDE_BOTTOM : (side > 0 ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT));
    leaf.handle.length = 0.2f * width;
    leaf.handle.thickness = 0.03f * width;
    leaf.handle.standoff = 0.03f * width;
    if (kind == 1) { /* slides back along the side */
        dmg_slide(b, 0, "door", v3(side > 0 ? 1.0f : -1.0f, 0, 0), 0.0f, 0.9f * width);
        dmg_panel_draw(b, &leaf.panel, width, height, t);
    } else {
        dmg_leaf_draw(b, 0, "door", &leaf);
    }
    dmg_use(b, 0);
    dmg_restore(b);
}

/* Draws a bubble over the seat: hinged at the back, at the side, or sliding back. */
static void draw_canopy(dmg_builder* b, float radius, float z) {
    int kind = dmg_int(b, 0, 2);
    dmg_vec base = {0, 0.75f * radius, z};
    float length = radius * dmg_range(b, 1.2f, 2.5f);
    float half = 0.5f * length, wide = 0.65f * radius;
    if (kind == 0) dmg_hinge(b, 0, "canopy", v3(0, base.y, z - half), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.1f));
    if (kind == 1) dmg_hinge(b, 0, "canopy", v3(wide, base.y, z), v3(0, 0, -1), 0.0f, dmg_range(b, 0.8f, 1.7f));
    if (kind == 2) dmg_slide(b, 0, "canopy", v3(0, 0, -1), 0.0f, 0.9f * length);
    dmg_dome(b, base, v3(wide, radius * dmg_range(b, 0.5f, 0.9f), half));
    if (dmg_chance(b, 0.5f)) dmg_box(b, base, v3(2 * wide, 0.06f * radius, length));
    dmg_use(b, 0);
}

/* Draws a leg with a wheel below y = 0: fixed, steered, or folding up about an axle. */
static void draw_gear(dmg_builder* b, float x, float z, float length, float wheel, bool steered) {
    uint32_t leg = 0;
    dmg_save(b);
    dmg_move(b, x, 0, z);
    if (steered && dmg_chance(b, 0.6f))
        leg = dmg_hinge(b, 0, "nose_gear", v3(0, 0, 0), v3(0, 1, 0), -0.8f, 0.8f);
    else if (dmg_chance(b, 0.5f)) {
        dmg_vec axis = x == 0.0f || dmg_chance(b, 0.3f) ? v3(-1, 0, 0) : v3(0, 0, x > 0 ? -1.0f : 1.0f);
        leg = dmg_hinge(b, 0, "gear", v3(0, 0, 0), axis, 0.0f, 1.5f);
    }
    dmg_rod(b, v3(0, 0.1f * length, 0), v3(0, -length, 0), 0.15f * wheel);
    dmg_save(b);
    dmg_move(b, steered ? 0 : 0.4f * wheel, -length, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, -0.5f * wheel), v3(0, 0, 0.3f * wheel), 0.12f * wheel);
    dmg_spin(b, leg, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, dmg_int(b, 0, 2), wheel, 0.4f * wheel, 5);
    dmg_restore(b);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_prop(dmg_builder* b, const char* name, float radius, int blades) {
    dmg_spin(b, 0, name, v3(0, 0, 0), v3(0, 0, 1));
    float hub = radius * dmg_range(b, 0.08f, 0.2f);
    dmg_cone(b, v3(0, 0, -0.5f * hub), v3(0, 0, 1.5f * hub), hub, dmg_chance(b, 0.6f) ? 0.0f : 0.8f * hub);
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 3));
    float chord = radius * dmg_range(b, 0.1f, 0.25f), twist = dmg_range(b, 0.1f, 0.6f);
    dmg_blades_draw(b, dmg_int(b, 0, 2), radius, hub, chord, blades, twist);
    dmg_use(b, 0);
}

static void draw_tail(dmg_builder* b, float radius, float tail) {
    float span = radius * dmg_range(b, 1.5f, 3.0f), root = radius * dmg_range(b, 0.8f, 1.5f);
    dmg_wing plane = dmg_wing_pick(b, span, root);
    span = radius * dmg_range(b, 1.0f, 2.2f);
    root = radius * dmg_range(b, 0.8f, 1.8f);
    dmg_wing fin = dmg_wing_pick(b, span, root);
    dmg_surface flaps[2];
    int count = dmg_surfaces_pick(b, flaps, NULL, "elevator");
    int fins = dmg_chance(b, 0.2f) ? 2 : 1;
    bool on_fin = fins == 1 && dmg_chance(b, 0.2f);
    dmg_save(b);
    dmg_move(b, 0, on_fin ? fin.span : 0, -tail + 0.5f * plane.root - (on_fin ? fin.sweep : 0));
    draw_pair(b, &plane, flaps, count, dmg_chance(b, 0.25f));
    dmg_restore(b);
    count = dmg_surfaces_pick(b, flaps, NULL, "rudder");
    for (int i = 0; i < fins; ++i) {
        dmg_save(b);
        dmg_move(b, fins == 1 ? 0 : ((float)i - 0.5f) * 1.6f * radius, 0.1f * radius, -tail + 0.55f * fin.root);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_wing_draw(b, &fin, 0, flaps, count);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

static void draw_engines(dmg_builder* b, float radius, float nose, const dmg_wing* w) {
    int kind = dmg_int(b, 0, 3), blades = dmg_int(b, 2, 5);
    float prop = radius * dmg_range(b, 0.9f, 1.7f);
    if (kind == 0) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.98f * nose);
        draw_prop(b, "propeller", prop, blades);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1 && (kind == 1 || kind == 2); s += 2) { /* under the wings */
        float at = dmg_range(b, 0.28f, 0.32f);
        dmg_vec p = dmg_wing_point(w, at, 0.2f, 0);
        dmg_save(b);
        dmg_move(b, (float)s * p.x, p.y - 0.3f * radius, p.z);
        dmg_rod(b, v3(0, 0, -0.8f * radius), v3(0, 0, 0.8f * radius), 0.4f * radius);
        dmg_move(b, 0, 0, 0.85f * radius);
        if (kind == 1)
            draw_prop(b, "propeller", 0.8f * prop, blades);
        else
            draw_prop(b, "turbine", 0.36f * radius, 8);
        dmg_restore(b);
    }
}

void dmg_build_aeroplane(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.06f, 2.0f), nose = radius * dmg_range(b, 2.0f, 6.0f),
          tail = radius * dmg_range(b, 3.5f, 9.0f), leg = radius * dmg_range(b, 0.8f, 1.5f);
    dmg_move(b, 0, 2 * radius + leg, 0);
    draw_fuselage(b, radius, nose, tail);
    float span = radius * dmg_range(b, 3.0f, 9.0f), root = radius * dmg_range(b, 1.4f, 3.0f);
    dmg_wing w = dmg_wing_pick(b, span, root);
    w.dihedral = dmg_range(b, -0.05f, 0.12f);
    float mount = radius * dmg_range(b, -0.7f, 0.9f), along = nose * dmg_range(b, -0.3f, 0.2f);
    dmg_surface flaps[2];
    bool flapped = dmg_chance(b, 0.5f), ailerons = !flapped || dmg_chance(b, 0.9f);
    int count = dmg_surfaces_pick(b, flaps, flapped ? "flap" : NULL, ailerons ? "aileron" : NULL);
    dmg_save(b);
    dmg_move(b, 0, mount, along);
    draw_pair(b, &w, flaps, count, false);
    draw_engines(b, radius, nose - along, &w);
    dmg_restore(b);
    draw_tail(b, radius, tail);
    if (dmg_chance(b, 0.4f)) draw_canopy(b, radius, nose * dmg_range(b, 0.1f, 0.4f));
    if (dmg_chance(b, 0.4f)) draw_side_door(b, radius, nose * dmg_range(b, 0.0f, 0.4f));
    if (dmg_chance(b, 0.6f)) {
        float wheel = radius * dmg_range(b, 0.2f, 0.4f), track = radius * dmg_range(b, 0.8f, 1.6f),
              z = along - 0.2f * radius;
        dmg_move(b, 0, -0.8f * radius, 0);
        draw_gear(b, -track, z, leg, wheel, false);
        draw_gear(b, track, z, leg, wheel, false);
        draw_gear(b, 0, 0.7f * nose, leg, 0.8f * wheel, true);
    }
}

/* ---- helicopter ---- */

static void draw_tail_rotor(dmg_builder* b, float radius, float tail) {
    float side = dmg_sign(b);
    dmg_save(b);
    dmg_move(b, side * 0.2f * radius, 0.5f * radius, -tail);
    dmg_turn(b, v3(0, 1, 0), side * 0.5f * DMG_PI);
    if (dmg_chance(b, 0.2f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.85f * radius, 0.08f * radius);
    dmg_rod(b, v3(0, 0, -0.15f * radius), v3(0, 0, 0.05f * radius), 0.06f * radius);
    draw_prop(b, "tail_rotor", 0.75f * radius, dmg_int(b, 2, 5));
    dmg_restore(b);
}

static void draw_main_rotor(dmg_builder* b, const char* name, float y, float z, float span) {
    dmg_save(b);
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    draw_prop(b, name, span, dmg_int(b, 2, 7));
    dmg_restore(b);
}

void dmg_build_helicopter(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.05f, 2.0f), nose = radius * dmg_range(b, 1.3f, 2.2f),
          tail = radius * dmg_range(b, 4, 8), span = radius * dmg_range(b, 4, 7),
          leg = radius * dmg_range(b, 0.3f, 0.8f);
    dmg_move(b, 0, radius + leg, 0);
    dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius, nose));
    dmg_cone(b, v3(0, 0.3f * radius, -tail), v3(0, 0.3f * radius, -0.4f * nose), 0.12f * radius, 0.4f * radius);
    dmg_rod(b, v3(0, 0.6f * radius, 0), v3(0, 1.5f * radius, 0), 0.1f * radius);
    if (dmg_chance(b, 0.6f))
        dmg_rounded_box(b, v3(0, radius, -0.2f * radius), v3(0.8f * radius, 0.5f * radius, 1.6f * radius),
                        0.1f * radius);
    draw_main_rotor(b, "rotor", 1.5f * radius, 0, span);
    if (dmg_chance(b, 0.2f)) { /* a second one above turns the other way */
        dmg_use(b, 0);
        dmg_rod(b, v3(0, 1.5f * radius, 0), v3(0, 2.1f * radius, 0), 0.07f * radius);
        draw_main_rotor(b, "upper_rotor", 2.1f * radius, 0, span);
    } else {
        draw_tail_rotor(b, radius, tail);
    }
    dmg_wing fin = dmg_wing_pick(b, 0.9f * radius, 0.8f * radius),
             plane = dmg_wing_pick(b, 0.9f * radius, 0.5f * radius);
    dmg_save(b);
    dmg_move(b, 0, 0.35f * radius, -0.97f * tail);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_use(b, 0);
    dmg_wing_piece_draw(b, &fin, 0, 1, 0, 1);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, 0.3f * radius, -0.8f * tail);
    draw_pair(b, &plane, NULL, 0, dmg_chance(b, 0.4f));
    dmg_restore(b);
    for (int i = dmg_int(b, 0, 2); i > 0; --i) draw_side_door(b, radius, nose * dmg_range(b, -0.3f, 0.4f));
    bool skids = dmg_chance(b, 0.6f);
    dmg_move(b, 0, -0.85f * radius, 0);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.8f * radius;
        if (!skids) {
            draw_gear(b, x, -0.3f * nose, leg, 0.25f * radius, false);
            continue;
        }
        dmg_rod(b, v3(x, -leg, -nose), v3(x, -leg, nose), 0.06f * radius);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(0.5f * x, 0.1f * radius, (float)k * 0.5f * nose), v3(x, -leg, (float)k * 0.5f * nose),
                    0.05f * radius);
    }
    if (!skids) draw_gear(b, 0, 0.5f * nose, leg, 0.2f * radius, true);
}

/* ---- drone ---- */

/* Draws what looks down from under a body: yaw, then pitch, each perhaps missing. */
static void draw_camera_ball(dmg_builder* b, float size) {
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.6f)) {
        carrier = dmg_spin(b, 0, "pan", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, -0.2f * size, 0), v3(0, 0, 0), 0.4f * size);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.6f * size, -0.6f * size, 0), v3(0.12f * size, size, 0.3f * size));
        dmg_box(b, v3(0, -0.15f * size, 0), v3(1.3f * size, 0.12f * size, 0.3f * size));
    }
    dmg_hinge(b, carrier, "tilt", v3(0, -0.9f * size, 0), v3(1, 0, 0), -1.5f, 0.5f);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(0, -0.9f * size, 0), v3(0.5f * size, 0.5f * size, 0.5f * size));
    else
        dmg_box(b, v3(0, -0.9f * size, 0), v3(0.8f * size, 0.6f * size, 0.7f * size));
    dmg_rod(b, v3(0, -0.9f * size, 0.3f * size), v3(0, -0.9f * size, 0.65f * size), 0.2f * size);
    dmg_use(b, 0);
}

/* Draws an arm along +X that may fold about Y or twist about itself, a motor at its end, a propeller on top. */
static void draw_drone_arm(dmg_builder* b, int motion, float root, float arm, float thick, float prop, int blades) {
    uint32_t carrier = 0;
    if (motion == 1) carrier = dmg_hinge(b, 0, "arm", v3(root, 0, 0), v3(0, 1, 0), 0.0f, 1.4f);
    if (motion == 2) carrier = dmg_hinge(b, 0, "arm", v3(root, 0, 0), v3(1, 0, 0), -1.5f, 1.5f);
    if (motion == 3) carrier = dmg_hinge(b, 0, "arm", v3(root, 0, 0), v3(0, 0, -1), 0.0f, 1.6f);
    if (dmg_chance(b, 0.5f))
        dmg_beam(b, v3(root, 0, 0), v3(arm, 0, 0), thick, thick);
    else
        dmg_rod(b, v3(root, 0, 0), v3(arm, 0, 0), 0.5f * thick);
    dmg_rod(b, v3(arm, -0.6f * thick, 0), v3(arm, 1.2f * thick, 0), 0.9f * thick);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(arm, -3 * thick, 0), v3(arm, 0, 0), 0.3f * thick);
    dmg_spin(b, carrier, "propeller", v3(arm, 0, 0), v3(0, 1, 0));
    dmg_move(b, arm, 1.5f * thick, 0);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, -0.3f * thick), v3(0, 0, 0.3f * thick), 0.4f * thick);
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 3));
    dmg_blades_draw(b, dmg_int(b, 0, 2), prop, 0.4f * thick, 0.2f * prop, blades, 0.2f);
    dmg_use(b, 0);
}

void dmg_build_drone(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 0.5f), arm = size * dmg_range(b, 1.2f, 2.2f),
          thick = size * dmg_range(b, 0.06f, 0.16f), high = size * dmg_range(b, 0.2f, 0.6f);
    int arms = 2 * dmg_int(b, 2, 4), blades = dmg_int(b, 2, 3);
    static const float weights[] = {5, 2, 1.5f, 1};
    int motion = dmg_weighted(b, weights, 4), body = dmg_int(b, 0, 2);
    dmg_move(b, 0, 1.5f * size, 0);
    if (body == 0) dmg_rounded_box(b, v3(0, 0, 0), v3(size, high, 1.3f * size), 0.3f * high);
    if (body == 1) dmg_box(b, v3(0, 0, 0), v3(size, high, size));
    if (body == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.6f * size, 0.6f * high, 0.7f * size));
    float prop = fminf(0.9f * arm * sinf(DMG_PI / (float)arms), 0.9f * (arm - 0.4f * size));
    for (int i = 0; i < arms; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 2.0f * DMG_PI * ((float)i + 0.5f) / (float)arms);
        draw_drone_arm(b, motion, 0.45f * size, arm, thick, prop, blades);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.6f)) {
        dmg_save(b);
        dmg_move(b, 0, -0.5f * high, 0.4f * size);
        draw_camera_ball(b, 0.35f * size);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * size;
        dmg_rod(b, v3(x, -1.4f * size, -0.6f * size), v3(x, -1.4f * size, 0.6f * size), 0.4f * thick);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(0.6f * x, -0.3f * high, (float)k * 0.3f * size), v3(x, -1.4f * size, (float)k * 0.35f * size),
                    0.35f * thick);
    }
}

/* ---- windsock ---- */

void dmg_build_windsock(dmg_builder* b) {
    float high = dmg_scale_range(b, 1, 8), length = high * dmg_range(b, 0.2f, 0.6f),
          radius = length * dmg_range(b, 0.08f, 0.2f), pole = high * dmg_range(b, 0.006f, 0.02f);
    int pieces = dmg_int(b, 1, 6);
    dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 1.5f * pole, pole);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, 0.02f * high, 0), v3(0.15f * high, 0.04f * high, 0.15f * high));
    uint32_t carrier = dmg_spin(b, 0, "windsock", v3(0, high, 0), v3(0, 1, 0));
    float arm = radius * dmg_range(b, 0.3f, 1.5f), top = 0.85f * radius, z = arm;
    dmg_rod(b, v3(0, high - 2 * radius, 0), v3(0, high + radius, 0), 1.3f * pole);
    dmg_move(b, 0, high - 0.5f * radius, 0);
    dmg_torus(b, v3(0, 0, arm), v3(0, 0, 1), radius, 0.05f * radius);
    for (int s = -1; s <= 1; s += 2) dmg_rod(b, v3(0, (float)s * top, 0), v3(0, (float)s * top, arm), 0.05f * radius);
    for (int i = 0; i < pieces; ++i) { /* each piece of cloth hangs from the one before */
        float far = length / (float)pieces, s0 = (float)i / (float)pieces, s1 = (float)(i + 1) / (float)pieces;
        float r0 = radius * (1.0f - 0.5f * s0), r1 = radius * (1.0f - 0.5f * s1);
        float swing = dmg_range(b, 0.1f, 1.3f) / (float)pieces, rest = dmg_chance(b, 0.5f) ? dmg_range(b, 0, 1) : 0.0f;
        uint32_t cloth = dmg_hinge(b, carrier, "cloth", v3(0, r0, z), v3(1, 0, 0), 0.0f, swing);
        const dmg_xy tube[] = {{r0, 0}, {r1, far}};
        dmg_lathe(b, v3(0, 0, z), v3(0, 0, 1), tube, 2);
        dmg_rest(b, cloth, rest * swing);
        carrier = cloth;
        z += far;
    }
    dmg_use(b, 0);
}

/* ---- submarine ---- */

/* Draws a propeller in a duct, blowing along +Z. */
static void draw_thruster(dmg_builder* b, float radius) {
    float wall = 0.1f * radius, half = radius * dmg_range(b, 0.3f, 0.7f);
    const dmg_xy duct[] = {{1.08f * radius, -half},
                           {1.08f * radius + wall, -half},
                           {1.08f * radius + wall, half},
                           {1.08f * radius, half},
                           {1.08f * radius, -half}};
    dmg_use(b, 0);
    if (dmg_chance(b, 0.8f)) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), duct, 5);
    dmg_rod(b, v3(0, 0, -1.5f * half), v3(0, 0, -0.2f * half), 0.3f * radius);
    for (int i = 0; i < 3; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / 3.0f;
        dmg_beam(b, v3(0, 0, -0.8f * half), v3(1.1f * radius * cosf(angle), 1.1f * radius * sinf(angle), -0.8f * half),
                 wall, wall);
    }
    draw_prop(b, "thruster", radius, dmg_int(b, 2, 5));
}

void dmg_build_submarine(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.2f, 4.0f), width = size * dmg_range(b, 0.3f, 0.8f),
          high = size * dmg_range(b, 0.25f, 0.6f), prop = size * dmg_range(b, 0.05f, 0.1f);
    dmg_move(b, 0, high, 0);
    if (dmg_chance(b, 0.5f)) { /* an open frame with floats on top */
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.5f * width, -0.1f * high, 0), v3(0.03f * size, high, size));
        for (int s = -1; s <= 1; s += 2)
            dmg_rounded_box(b, v3((float)s * 0.22f * width, 0.4f * high, 0),
                            v3(0.4f * width, 0.35f * high, 0.9f * size), 0.1f * high);
        dmg_rod(b, v3(0, 0, -0.35f * size), v3(0, 0, 0.35f * size), 0.15f * width);
        int pairs = dmg_int(b, 1, 2);
        float toe = dmg_chance(b, 0.5f) ? 0.25f * DMG_PI : dmg_range(b, -0.8f, 0.8f);
        for (int i = 0; i < 4 * pairs; ++i) {
            float x = (i & 1 ? 1.0f : -1.0f), z = (i & 2 ? 1.0f : -1.0f);
            dmg_save(b);
            dmg_move(b, x * 0.36f * width, i < 4 ? -0.3f * high : 0.1f * high, z * 0.36f * size);
            if (i < 4)
                dmg_turn(b, v3(0, 1, 0), -x * z * toe);
            else
                dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
            draw_thruster(b, prop);
            dmg_restore(b);
        }
    } else { /* a hull with fins and a screw */
        float radius = 0.5f * fminf(width, high);
        draw_fuselage(b, radius, 0.5f * size, 0.6f * size);
        dmg_save(b);
        dmg_move(b, 0, 0, -0.6f * size);
        dmg_turn(b, v3(0, 1, 0), DMG_PI);
        draw_thruster(b, fminf(0.6f * radius, 2 * prop));
        dmg_restore(b);
        for (int i = 0; i < 4; ++i) { /* rudders and planes at the stern */
            dmg_wing fin = dmg_wing_pick(b, radius, 0.6f * radius);
            dmg_save(b);
            dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)i);
            dmg_move(b, 0.2f * radius, 0, -0.45f * size);
            dmg_use(b, 0);
            if (dmg_chance(b, 0.5f)) {
                dmg_surface flap = {"rudder", 0.1f, 0.98f, dmg_range(b, 0.4f, 0.75f), 0.6f, false};
                dmg_wing_draw(b, &fin, 0, &flap, 1);
            } else {
                dmg_hinge(b, 0, "plane", dmg_wing_point(&fin, 0, 0.4f, 0), v3(1, 0, 0), -0.5f, 0.5f);
                dmg_wing_piece_draw(b, &fin, 0.05f, 1, 0, 1);
            }
            dmg_restore(b);
        }
        dmg_use(b, 0);
        dmg_box(b, v3(0, 0.9f * radius, 0.05f * size), v3(0.5f * radius, 0.9f * radius, 0.25f * size));
        dmg_hinge(b, 0, "hatch", v3(0, 1.35f * radius, -0.05f * size), v3(-1, 0, 0), 0.0f, 1.5f);
        dmg_box(b, v3(0, 1.38f * radius, 0.03f * size), v3(0.4f * radius, 0.06f * radius, 0.15f * size));
    }
    dmg_use(b, 0);
}
