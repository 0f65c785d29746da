/* Draws racing wheels with paddles, levers and pedals. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

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
