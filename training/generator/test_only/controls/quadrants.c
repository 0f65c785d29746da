/* Draws hand and foot controls on a hidden shaft: aircraft throttle quadrants, racing wheels with paddles and
 * pedals, foot pedals of music and machines. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

static const float UP = 0.5f * DMG_PI; /* the angle round a shell that lies across */

/* ---- levers side by side ---- */

/* On the end of an arm along +Y, at the origin; X is the shaft. */
static void draw_lever_knob(dmg_builder* b, int kind, float r) {
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(r, 0.9f * r, r));
    if (kind == 1) dmg_capsule(b, v3(-1.3f * r, 0, 0), v3(1.3f * r, 0, 0), 0.6f * r);
    if (kind == 2) dmg_rod(b, v3(-0.35f * r, 0, 0), v3(0.35f * r, 0, 0), 1.3f * r); /* a wheel: the gear */
    if (kind == 3) dmg_rounded_box(b, v3(0, 0, 0), v3(2 * r, 0.7f * r, 1.4f * r), 0.3f * r);
    if (kind == 4) dmg_cone(b, v3(0, -r, 0), v3(0, r, 0), 0.6f * r, 1.0f * r);
    if (kind == 5) { /* a grip bent over the hand's way */
        dmg_bent n = dmg_bent_between(v3(-1.4f * r, 0, 0), v3(1.4f * r, 0.2f * r, 0), v3(0, 0.3f * r, 0), v3(0, 0, 1),
                                      0.7f * r, 0.6f * r);
        n.rows = n.columns = 12;
        dmg_bent_draw(b, &n);
    }
}

/* Draws one lever about the shaft along X through the origin; from: where it leaves the housing. */
static void draw_quadrant_lever(dmg_builder* b, const char* name, int kind, float from, float length, float swing) {
    float r = length * dmg_range(b, 0.07f, 0.11f), t = r * dmg_range(b, 0.2f, 0.35f),
          crook = length * dmg_range(b, -0.12f, 0.12f), rest = dmg_range(b, -1.0f, 1.0f),
          fist = dmg_range(b, 0.8f, 1.3f);
    bool lock = dmg_chance(b, 0.25f);
    uint32_t lever = dmg_hinge(b, 0, name, v3(0, 0, 0), v3(1, 0, 0), -swing, swing);
    dmg_rest(b, lever, dmg_chance(b, 0.3f) ? swing * copysignf(1, rest) : swing * rest);
    dmg_vec knee = v3(0, from + 0.45f * (length - from), 0), tip = v3(0, length, crook);
    dmg_beam(b, v3(0, from, 0), knee, 2 * t, 2.5f * t);
    dmg_beam(b, knee, tip, 2 * t, 2.5f * t);
    dmg_save(b);
    dmg_move(b, 0, tip.y, tip.z);
    draw_lever_knob(b, kind, r * fist);
    dmg_restore(b);
    if (lock) { /* a collar that is lifted to pass a stop */
        dmg_vec way = v3_normalize(v3_sub(tip, knee));
        dmg_slide(b, lever, "lift", way, 0.0f, 0.15f * length);
        dmg_beam(b, v3_lerp(knee, tip, 0.2f), v3_lerp(knee, tip, 0.4f), 3.4f * t, 4.4f * t);
    }
    dmg_use(b, 0);
}

/* Knobs on rods out of a panel before the housing: mixture, propeller, carburettor heat. */
static void draw_push_pulls(dmg_builder* b, float wide, float z, float high) {
    int count = dmg_int(b, 1, 4);
    float way = high * dmg_range(b, 0.3f, 0.9f), r = high * dmg_range(b, 0.1f, 0.16f);
    for (int i = 0; i < count; ++i) {
        float x = wide * (((float)i + 0.5f) / (float)count - 0.5f), shown = way * dmg_unit(b);
        int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
        dmg_rod(b, v3(x, 0.5f * high, z), v3(x, 0.5f * high, z + 0.1f * high), 0.8f * r);
        uint32_t knob = dmg_slide(b, 0, "push_pull", v3(0, 0, 1), 0.0f, way);
        dmg_rest(b, knob, dmg_chance(b, 0.5f) ? 0.0f : shown);
        dmg_rod(b, v3(x, 0.5f * high, z + 0.1f * high - way), v3(x, 0.5f * high, z + 0.25f * high), 0.35f * r);
        dmg_save(b);
        dmg_move(b, x, 0.5f * high, z + 0.24f * high);
        dmg_knob_draw(b, kind, r, 1.5f * r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_throttle_quadrant(dmg_builder* b) {
    static const char* const names[] = {"throttle", "throttle", "propeller", "mixture", "flaps", "speed_brake"};
    float wide = dmg_scale_range(b, 0.12f, 0.34f), r = dmg_range(b, 0.05f, 0.1f), foot = r * dmg_range(b, 0.2f, 1.0f),
          swing = dmg_range(b, 0.4f, 0.75f), reach = r * dmg_range(b, 1.6f, 2.4f), deep = r * dmg_range(b, 1.0f, 1.5f),
          tilt = dmg_range(b, -0.3f, 0.4f), cover = dmg_range(b, 0.75f, 1.15f);
    int count = dmg_int(b, 2, 6), same = dmg_int(b, 0, 5), mode = dmg_int(b, 0, 2);
    bool trim = dmg_chance(b, 0.6f), rods = dmg_chance(b, 0.4f), guard = dmg_chance(b, 0.4f);
    dmg_bent n = dmg_bent_between(v3(-0.5f * wide, 0, 0), v3(0.5f * wide, 0, 0), v3(0, 0, 0), v3(0, 0, 1), deep, r);
    n.wide[0] *= cover;
    n.deep[0] *= cover;
    n.power = dmg_range(b, 2.0f, 3.0f);
    n.round[0] = n.round[1] = dmg_range(b, 0.0f, 0.12f);
    n.rows = 38;
    n.columns = 32;
    float s[6], around;
    for (int i = 0; i < count; ++i) {
        dmg_window w =
            dmg_bent_open(&n, ((float)i + 0.7f) / ((float)count + 0.4f), UP, 0.03f, 2 * swing + 0.35f, 0.35f * r);
        dmg_window_middle(&n, &w, &s[i], &around);
    }
    dmg_move(b, 0, foot + 0.5f * r, 0);
    dmg_box_span(b, v3(-0.5f * wide, -foot - 0.5f * r, -0.8f * deep), v3(0.5f * wide, -0.1f * r, 0.8f * deep));
    if (rods) {
        dmg_box_span(b, v3(-0.5f * wide, -foot - 0.5f * r, 0.7f * deep), v3(0.5f * wide, -0.1f * r, 1.3f * deep));
        dmg_save(b);
        dmg_move(b, 0, -foot - 0.5f * r, 0);
        draw_push_pulls(b, 0.9f * wide, 1.3f * deep, foot + 0.4f * r);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), rods ? 0.0f : tilt);
    dmg_bent_draw(b, &n);
    for (int i = 0; i < count; ++i) {
        int kind = mode == 0 ? same : mode == 1 ? i % 6 : dmg_int(b, 0, 5);
        dmg_save(b);
        dmg_move(b, dmg_bent_middle(&n, s[i]).x, 0, 0);
        draw_quadrant_lever(b, names[i], kind, 0.75f * r, reach, swing);
        dmg_restore(b);
    }
    dmg_restore(b);
    for (int side = -1; side <= 1; side += 2) {
        dmg_aim(b, v3((float)side * 0.505f * wide, -0.35f * r, 0), v3((float)side, 0, 0), v3(0, 0, 1));
        if (trim && side > 0) dmg_sunk_wheel_draw(b, 0, "trim_wheel", 0.5f * r, 0.15f * r);
        if (guard && side < 0) dmg_guarded_draw(b, 0, 0.25f * r);
        dmg_restore(b);
    }
}

/* ---- a wheel for racing ---- */

/* Draws the rim in the plane z = 0, its spokes, the hub with keys; paddles behind, all on `wheel`. */
static void draw_race_wheel(dmg_builder* b, uint32_t wheel, float r) {
    float rim = r * dmg_range(b, 0.07f, 0.12f), oval = dmg_range(b, 0.75f, 1.0f), hub = r * dmg_range(b, 0.25f, 0.4f),
          t = r * dmg_range(b, 0.06f, 0.12f), plane = dmg_range(b, 0.02f, 0.15f) * r;
    int spokes = dmg_int(b, 2, 4), keys = dmg_int(b, 2, 8), dials = dmg_int(b, 0, 3);
    float first = spokes == 3 ? -0.5f * DMG_PI : spokes == 4 ? 0.25f * DMG_PI : 0.0f;
    dmg_save(b);
    dmg_move(b, 0, 0, plane);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_hoop_draw(b, r, r * oval, rim, rim, 0.4f, 0.0f);
    dmg_restore(b);
    for (int i = 0; i < spokes; ++i) {
        float turn = first + 2 * DMG_PI * (float)i / (float)spokes;
        dmg_beam(b, v3(0, 0, 0), v3(r * cosf(turn), r * oval * sinf(turn), plane), 0.22f * r, 0.5f * t);
    }
    dmg_rounded_box(b, v3(0, 0, 0), v3(2.4f * hub, 1.5f * hub, 2 * t), 0.8f * t);
    for (int i = 0; i < keys + dials; ++i) {
        int column = i % 4, row = i / 4;
        dmg_save(b);
        dmg_move(b, hub * (0.55f * (float)column - 0.83f), hub * (0.45f - 0.42f * (float)row), t);
        if (i < keys)
            dmg_thumb_key_draw(b, wheel, "key", 0.12f * hub);
        else {
            dmg_spin(b, wheel, "encoder", v3(0, 0, 0), v3(0, 0, 1));
            dmg_knob_draw(b, i % DMG_KNOB_KINDS, 0.16f * hub, 0.2f * hub);
            dmg_use(b, wheel);
        }
        dmg_restore(b);
    }
    int pairs = dmg_int(b, 1, 2);
    float pull = dmg_range(b, 0.08f, 0.2f);
    bool up = dmg_chance(b, 0.2f);
    for (int i = 0; i < 2 * pairs; ++i) { /* pulled to the driver: their outer ends come forward */
        float side = i % 2 ? 1.0f : -1.0f, y = (i > 1 ? -0.35f : 0.12f) * r, z = -1.8f * t;
        dmg_hinge(b, wheel, i > 1 ? "clutch_paddle" : "shift_paddle", v3(side * 0.3f * hub, y, z), v3(0, -side, 0),
                  0.0f, pull);
        dmg_bent n = dmg_bent_between(v3(side * 0.3f * hub, y, z),
                                      v3(side * 0.78f * r, y + (up ? 0.2f : 0.05f) * r, z - 0.6f * t),
                                      v3(0, 0.05f * r, 0), v3(0, side, 0), 0.12f * r, 0.2f * t);
        n.wide[2] *= 1.4f;
        n.power = 3;
        n.rows = n.columns = 12;
        dmg_bent_draw(b, &n);
        dmg_use(b, wheel);
    }
}

/* Pedals before the heel plate at z = 0; the driver at +Z. Hung from a beam above, or standing on the floor. */
static void draw_race_pedals(dmg_builder* b, float wide) {
    int count = dmg_int(b, 2, 3);
    bool hung = dmg_chance(b, 0.5f);
    float high = wide * dmg_range(b, 0.45f, 0.65f), swing = dmg_range(b, 0.25f, 0.5f), t = 0.03f * wide,
          lean = dmg_range(b, 0.25f, 0.6f), share = dmg_range(b, 0.35f, 0.55f);
    dmg_box_span(b, v3(-0.5f * wide, 0, -0.5f * wide), v3(0.5f * wide, t, 0.25f * wide));
    if (hung) {
        dmg_rod(b, v3(-0.5f * wide, 1.15f * high, -0.2f * wide), v3(0.5f * wide, 1.15f * high, -0.2f * wide), t);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.49f * wide, 0.5f * t, -0.45f * wide),
                     v3((float)s * 0.49f * wide, 1.15f * high, -0.2f * wide), t, 2 * t);
    }
    for (int i = 0; i < count; ++i) {
        float x = wide * (((float)i + 0.5f) / (float)count - 0.5f),
              pad = wide / (float)count * share * (i == 1 ? 1.2f : 0.9f),
              long_way = (i == count - 1 ? 1.6f : 0.9f) * pad;
        const char* name = i == count - 1 ? "accelerator" : i == count - 2 ? "brake" : "clutch";
        dmg_vec pin = hung ? v3(x, 1.15f * high, -0.2f * wide) : v3(x, 2 * t, -0.1f * wide),
                end = hung ? v3(x, 0.4f * high, -0.12f * wide) : v3(x, 0.7f * high, -0.1f * wide - 0.4f * high * lean);
        dmg_hinge(b, 0, name, pin, v3(hung ? 1.0f : -1.0f, 0, 0), 0.0f, swing);
        dmg_rod(b, v3_mad(pin, v3(1, 0, 0), -1.5f * t), v3_mad(pin, v3(1, 0, 0), 1.5f * t), hung ? 1.6f * t : t);
        dmg_beam(b, pin, end, 1.2f * t, t);
        dmg_aim(b, v3_mad(end, v3(0, 0, 1), 0.6f * t), v3(0, 0.35f, 1), v3(0, 1, 0));
        dmg_rounded_plate(b, pad, long_way, 0.5f * t, 0.2f * pad);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a box with a gate at its top, out of which a stick comes; or a brake's lever. Top at y = 0. */
static void draw_side_lever(dmg_builder* b, float size, bool brake) {
    float high = size * dmg_range(b, 1.2f, 2.0f), swing = dmg_range(b, 0.2f, 0.4f);
    dmg_rounded_box(b, v3(0, -0.3f * size, 0), v3(0.6f * size, 0.6f * size, size), 0.1f * size);
    if (brake) {
        uint32_t arm = dmg_hinge(b, 0, "handbrake", v3(0, -0.15f * size, -0.2f * size), v3(1, 0, 0), 0.0f, swing);
        dmg_beam(b, v3(0, -0.1f * size, -0.2f * size), v3(0, 0.5f * high, -0.25f * size), 0.12f * size, 0.12f * size);
        dmg_capsule(b, v3(0, 0.45f * high, -0.25f * size), v3(0, high, -0.3f * size), 0.13f * size);
        dmg_slide(b, arm, "release", v3(0, -1, 0), 0.0f, 0.08f * size);
        dmg_rod(b, v3(0, high, -0.3f * size), v3(0, high + 0.22f * size, -0.3f * size), 0.06f * size);
        dmg_use(b, 0);
        return;
    }
    dmg_save(b);
    dmg_face_up(b);
    dmg_frame_draw(b, 0.55f * size, 0.8f * size, 0.05f * size, 0.1f * size);
    dmg_restore(b);
    uint32_t rail = dmg_hinge(b, 0, "shift_aside", v3(0, -0.2f * size, 0), v3(0, 0, -1), -0.5f * swing, 0.5f * swing);
    dmg_ellipsoid(b, v3(0, 0, 0), v3(0.16f * size, 0.12f * size, 0.16f * size));
    dmg_hinge(b, rail, "shifter", v3(0, -0.2f * size, 0), v3(1, 0, 0), -swing, swing);
    dmg_rod(b, v3(0, -0.1f * size, 0), v3(0, high, 0), 0.06f * size);
    dmg_save(b);
    dmg_move(b, 0, high, 0);
    draw_lever_knob(b, dmg_int(b, 0, 1) * 4, 0.2f * size);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_racing_wheel(dmg_builder* b) {
    float r = dmg_range(b, 0.12f, 0.18f), tilt = dmg_range(b, 0.0f, 0.5f), turn = dmg_range(b, 1.5f, 7.8f),
          box = r * dmg_range(b, 0.9f, 1.3f), gap = r * dmg_range(b, 0.15f, 0.4f);
    bool rig = dmg_chance(b, 0.6f), shifter = dmg_chance(b, 0.5f), brake = dmg_chance(b, 0.4f);
    float high = rig ? r * dmg_range(b, 3.5f, 5.0f) : 1.3f * r, x = 1.7f * r;
    if (rig) {
        draw_race_pedals(b, 2.8f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 1.3f * r, 0.1f * r, -1.2f * r),
                     v3((float)s * 0.4f * r, high - 0.2f * r, -0.6f * r), 0.15f * r, 0.15f * r);
    } else
        dmg_box_span(b, v3(-0.6f * r, 0, -1.6f * r), v3(0.6f * r, 0.1f * r, 0.2f * r));
    if (!rig) dmg_beam(b, v3(0, 0.05f * r, -r), v3(0, high, -0.7f * r), 0.6f * r, 0.6f * r);
    for (int i = 0; i < 2; ++i) {
        if (!(i ? brake : shifter)) continue;
        float at = i ? -x : x, y = rig ? high - 0.5f * r : 0.6f * r;
        dmg_beam(b, v3(0, y - 0.25f * r, -0.75f * r), v3(at, y - 0.25f * r, -0.75f * r), 0.15f * r, 0.15f * r);
        dmg_save(b);
        dmg_move(b, at, y, -0.6f * r);
        draw_side_lever(b, 0.5f * r, i == 1);
        dmg_restore(b);
    }
    dmg_move(b, 0, high, 0);
    dmg_turn(b, v3(1, 0, 0), -tilt);
    dmg_bent n =
        dmg_bent_between(v3(0, 0, -box - gap), v3(0, 0, -gap), v3(0, -0.05f * r, 0), v3(-1, 0, 0), 0.55f * r, 0.5f * r);
    n.power = dmg_range(b, 2.0f, 4.0f);
    n.round[1] = 0.15f;
    dmg_bent_draw(b, &n);
    uint32_t wheel = dmg_hinge(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, 1), -turn, turn);
    dmg_rod(b, v3(0, 0, -gap - 0.02f * r), v3(0, 0, 0.05f * r), 0.15f * r);
    dmg_move(b, 0, 0, 0.2f * r);
    dmg_rod(b, v3(0, 0, -0.2f * r), v3(0, 0, 0), 0.15f * r);
    draw_race_wheel(b, wheel, r);
}

/* ---- under the foot: heel at +Z, toes at -Z ---- */

static void draw_foot_board(dmg_builder* b, float wide, float l) {
    float toe = dmg_range(b, 0.7f, 1.2f), t = 0.03f * l;
    dmg_bent n = dmg_bent_between(v3(0, 0, 0), v3(0, 0, -l), v3(0, 0.02f * l, 0), v3(1, 0, 0), 0.4f * wide, t);
    n.wide[2] = 0.5f * wide * toe;
    n.power = dmg_range(b, 3.0f, 6.0f);
    n.round[0] = n.round[1] = 0.08f;
    dmg_bent_draw(b, &n);
}

/* Draws the board on a heel plate, an axle between posts, a beater on it. */
static void draw_bass_pedal(dmg_builder* b, float l) {
    float wide = 0.36f * l, rise = dmg_range(b, 0.25f, 0.4f), high = l * dmg_range(b, 0.55f, 0.75f),
          stem = l * dmg_range(b, 0.5f, 0.8f), t = 0.035f * l, z = -1.02f * l;
    int head = dmg_int(b, 0, 2), beaters = dmg_int(b, 1, 2);
    dmg_box_span(b, v3(-0.5f * wide, 0, -1.15f * l), v3(0.5f * wide, t, 0.3f * l));
    dmg_rounded_box(b, v3(0, 1.3f * t, 0.15f * l), v3(0.8f * wide, t, 0.3f * l), 0.3f * t);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.62f * wide, 0, z), v3((float)s * 0.62f * wide, high + t, z), 1.5f * t, 2 * t);
    dmg_box_span(b, v3(-0.68f * wide, 0, z - t), v3(0.68f * wide, t, z + t));
    dmg_hinge(b, 0, "footboard", v3(0, 2.5f * t, 0), v3(-1, 0, 0), 0.0f, rise * 0.7f);
    dmg_save(b);
    dmg_move(b, 0, 2.5f * t, 0);
    dmg_turn(b, v3(1, 0, 0), rise);
    draw_foot_board(b, wide, 0.92f * l);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_hinge(b, 0, "beater", v3(0, high, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.2f));
    dmg_rod(b, v3(-0.6f * wide, high, z), v3(0.6f * wide, high, z), 0.5f * t);
    dmg_rod(b, v3(0, high, z - t), v3(0, high, z + t), 1.6f * t);
    for (int i = 0; i < beaters; ++i) {
        float x = beaters == 1 ? 0.0f : wide * (0.4f * (float)i - 0.2f);
        dmg_vec tip = v3(x, high + 0.9f * stem, z + 0.35f * stem);
        dmg_rod(b, v3(x, high, z), tip, 0.3f * t);
        if (head == 0) dmg_ellipsoid(b, tip, v3(2 * t, 2 * t, 2 * t));
        if (head == 1)
            dmg_rod(b, v3_mad(tip, v3(0, 0.35f, -0.9f), 1.5f * t), v3_mad(tip, v3(0, -0.35f, 0.9f), 1.5f * t), 2 * t);
        if (head == 2) dmg_rounded_box(b, tip, v3(3 * t, 3 * t, 3.5f * t), t);
    }
    dmg_use(b, 0);
}

/* A stand's tube with a rod in it, three legs that fold, the board at its foot. */
static void draw_hat_pedal(dmg_builder* b, float l) {
    float high = l * dmg_range(b, 1.8f, 2.8f), t = 0.03f * l, rise = dmg_range(b, 0.2f, 0.4f), z = -0.98f * l,
          way = 0.1f * l, spread = l * dmg_range(b, 0.7f, 1.1f);
    dmg_rod(b, v3(0, 0.12f * l, z - 0.12f * l), v3(0, high, z - 0.12f * l), t);
    dmg_box_span(b, v3(-0.2f * l, 0, z - 0.18f * l), v3(0.2f * l, 0.13f * l, z - 0.06f * l));
    dmg_box_span(b, v3(-0.12f * l, 0, z - 0.1f * l), v3(0.12f * l, 0.7f * t, 0.25f * l));
    for (int i = 0; i < 3; ++i) { /* about a collar on the tube, up along it */
        dmg_save(b);
        dmg_move(b, 0, 0, z - 0.12f * l);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI + 2 * DMG_PI * ((float)i + 0.5f) / 3 - DMG_PI / 3);
        dmg_box(b, v3(1.4f * t, 0.75f * l, 0), v3(2 * t, 2 * t, 1.5f * t));
        dmg_hinge(b, 0, "leg", v3(2 * t, 0.75f * l, 0), v3(0, 0, -1), 0.0f, 0.5f * atanf(spread / (0.75f * l)));
        dmg_beam(b, v3(2 * t, 0.75f * l, 0), v3(spread, t, 0), t, t);
        dmg_ellipsoid(b, v3(spread, t, 0), v3(1.3f * t, t, 1.3f * t));
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_hinge(b, 0, "footboard", v3(0, 2.5f * t, 0), v3(-1, 0, 0), 0.0f, 0.6f * rise);
    dmg_save(b);
    dmg_move(b, 0, 2.5f * t, 0);
    dmg_turn(b, v3(1, 0, 0), rise);
    draw_foot_board(b, 0.3f * l, 0.85f * l);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_slide(b, 0, "pull_rod", v3(0, -1, 0), 0.0f, way);
    dmg_rod(b, v3(0, high - 0.2f * l, z - 0.12f * l), v3(0, high + 0.5f * l, z - 0.12f * l), 0.4f * t);
    dmg_lathe(b, v3(0, high + 0.35f * l, z - 0.12f * l), v3(0, 1, 0),
              (const dmg_xy[]){{0.65f * l, 0}, {0.3f * l, 0.05f * l}, {0.1f * l, 0.1f * l}, {0, 0.1f * l}}, 4);
    dmg_use(b, 0);
}

/* Draws a treadle on a wedge: it tips about a line below its middle; or about its heel, against a spring. */
static void draw_treadle(dmg_builder* b, float l) {
    float wide = l * dmg_range(b, 0.35f, 0.8f), high = l * dmg_range(b, 0.15f, 0.3f),
          swing = dmg_range(b, 0.12f, 0.25f), at = dmg_range(b, 0.35f, 0.6f), lean = dmg_range(b, 0.0f, 0.25f);
    int kind = dmg_int(b, 0, 1);
    bool middle = dmg_chance(b, 0.6f), knob = dmg_chance(b, 0.5f), hook = dmg_chance(b, 0.3f);
    float low = high * 0.55f;
    if (kind == 0) dmg_rounded_box(b, v3(0, 0.5f * low, -0.5f * l), v3(wide, low, l), 0.2f * low);
    if (kind == 1) {
        dmg_bent n = dmg_bent_between(v3(0, 0.5f * low, 0), v3(0, 0.5f * low, -l), v3(0, 0, 0), v3(1, 0, 0),
                                      0.5f * wide, 0.5f * low);
        n.wide[0] *= dmg_range(b, 0.6f, 1.0f);
        n.power = dmg_range(b, 2.5f, 5.0f);
        dmg_bent_draw(b, &n);
    }
    if (middle)
        dmg_box_span(b, v3(-0.3f * wide, 0.5f * low, -(at + 0.06f) * l), v3(0.3f * wide, high, -(at - 0.06f) * l));
    dmg_hinge(b, 0, "treadle", v3(0, middle ? high : 1.1f * low, middle ? -at * l : -0.06f * l),
              v3(middle ? 1.0f : -1.0f, 0, 0), middle ? -swing : 0.0f, middle ? swing : 0.8f * fmaxf(lean, 0.1f));
    dmg_save(b);
    dmg_move(b, 0, middle ? high + 0.03f * l : low + 0.05f * l, -0.02f * l);
    if (!middle) dmg_turn(b, v3(1, 0, 0), fmaxf(lean, 0.1f));
    draw_foot_board(b, 0.95f * wide, 0.95f * l);
    if (hook) dmg_rounded_box(b, v3(0, 0.06f * l, -0.88f * l), v3(0.8f * wide, 0.1f * l, 0.06f * l), 0.02f * l);
    dmg_restore(b);
    dmg_use(b, 0);
    if (!knob) return;
    dmg_aim(b, v3(0.49f * wide, 0.5f * low, -0.5f * l), v3(1, 0, 0), v3(0, 1, 0));
    dmg_knobs_draw(b, 0, 1, 0, 0, 0.35f * low);
    dmg_restore(b);
}

/* Draws a sloped box with foot switches, knobs at its far end; a long plate to tread on in some. */
static void draw_stomp_box(dmg_builder* b, float l) {
    float wide = l * dmg_range(b, 0.55f, 1.6f), high = l * dmg_range(b, 0.3f, 0.45f),
          low = high * dmg_range(b, 0.5f, 0.95f), slope = atanf((high - low) / l);
    int switches = wide > l ? dmg_int(b, 2, 3) : 1, knobs = dmg_int(b, 1, 4);
    bool plate = switches == 1 && dmg_chance(b, 0.4f);
    const dmg_xy side[] = {{0, 0}, {0, low}, {-l, high}, {-l, 0}};
    dmg_aim(b, v3(0, 0, 0), v3(-1, 0, 0), v3(0, 1, 0));
    dmg_extrude(b, side, 4, -0.5f * wide, 0.5f * wide);
    dmg_restore(b);
    dmg_aim(b, v3(0, low + 0.22f * (high - low), -0.22f * l), v3(0, cosf(slope), sinf(slope)), v3(0, 0, -1));
    for (int i = 0; i < switches && !plate; ++i) {
        float x = wide * (((float)i + 0.5f) / (float)switches - 0.5f), r = 0.05f * l;
        dmg_rod(b, v3(x, 0, 0), v3(x, 0, 0.5f * r), 1.5f * r);
        dmg_slide(b, 0, "foot_switch", v3(0, 0, -1), 0.0f, dmg_range(b, 0.4f, 1.0f) * r);
        dmg_rod(b, v3(x, 0, -r), v3(x, 0, 1.7f * r), r);
        dmg_use(b, 0);
    }
    if (plate) { /* hung at its far edge, under the knobs; the switch or the battery is below */
        dmg_hinge(b, 0, "tread", v3(0, 0.36f * l, 0.03f * l), v3(1, 0, 0), -0.06f, dmg_range(b, 0.0f, 0.05f));
        dmg_rounded_box(b, v3(0, 0.08f * l, 0.06f * l), v3(0.9f * wide, 0.56f * l, 0.05f * l), 0.015f * l);
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, 0, 0.6f * l, 0);
    dmg_knobs_draw(b, 0, knobs, 0.85f * wide / (float)knobs, 0, fminf(0.09f * l, 0.3f * wide / (float)knobs));
    dmg_restore(b);
    dmg_restore(b);
}

void dmg_build_drum_pedal(dmg_builder* b) {
    float l = dmg_range(b, 0.22f, 0.32f);
    int kind = dmg_int(b, 0, 4);
    float skew = dmg_range(b, -0.3f, 0.3f);
    dmg_turn(b, v3(0, 1, 0), skew);
    dmg_move(b, 0, 0, 0.5f * l);
    if (kind == 0) draw_bass_pedal(b, l);
    if (kind == 1) draw_hat_pedal(b, l);
    if (kind == 2 || kind == 3) draw_treadle(b, l * dmg_range(b, 0.55f, 1.0f));
    if (kind == 4) draw_stomp_box(b, l * dmg_range(b, 0.4f, 0.7f));
}
