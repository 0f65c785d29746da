/* Draws photo cameras: a body with a grip, dials and levers on its deck, rings round the lens, a flash that pops up,
 * backs, screens and doors that open; twin-lens boxes with a hooded finder. The lens looks to +Z. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

static const float UP = 0.5f * DMG_PI;

typedef struct camera {
    float wide, high, deep, power; /* of the body */
    float top;                     /* of the deck */
} camera;

/* ---- the lens, along +Z from the origin ---- */

static void draw_ring(dmg_builder* b, float r, float z0, float z1, int ribs) {
    dmg_rod(b, v3(0, 0, z0), v3(0, 0, z1), r);
    for (int i = 0; i < ribs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, ribs);
        dmg_box(b, v3(r, 0, 0.5f * (z0 + z1)), v3(0.1f * r, 0.15f * r, 0.8f * (z1 - z0)));
        dmg_restore(b);
    }
}

/* Draws a barrel of rings one before the other: some turn, the front may screw out; a hood, a cap. */
static void draw_lens(dmg_builder* b, float r, float length) {
    int rings = dmg_int(b, 1, 3);
    float each = length / (float)(rings + 1), turn = dmg_range(b, 0.4f, 1.5f), z = 0.3f * each, core = 0.8f * r;
    bool screws = dmg_chance(b, 0.4f), hood = dmg_chance(b, 0.4f), cap = !hood && dmg_chance(b, 0.5f),
         hinged = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, 0, -0.2f * each), v3(0, 0, z), 1.08f * r);
    dmg_rod(b, v3(0, 0, z), v3(0, 0, length - 0.4f * each), core);
    for (int i = 0; i < rings; ++i) {
        float wide = each * dmg_range(b, 0.5f, 0.9f), fat = r * dmg_range(b, 0.88f, 1.05f);
        int ribs = dmg_chance(b, 0.5f) ? dmg_int(b, 8, 16) : 0;
        const char* name = i == 0 ? "aperture_ring" : i == 1 ? "zoom_ring" : "focus_ring";
        dmg_hinge(b, 0, name, v3(0, 0, 0), v3(0, 0, 1), -turn, turn);
        draw_ring(b, fat, z + 0.05f * each, z + wide, ribs);
        dmg_use(b, 0);
        z += each;
    }
    uint32_t front = 0;
    if (screws) front = dmg_screw(b, 0, "front_barrel", v3(0, 0, 0), v3(0, 0, 1), 0.15f * each, 0.0f, 3.0f);
    const dmg_xy glass[] = {{0.86f * r, z},
                            {0.9f * r, z + 0.6f * each},
                            {0.75f * r, z + 0.6f * each},
                            {0.6f * r, z + 0.25f * each},
                            {0, z + 0.35f * each}};
    if (screws) dmg_rod(b, v3(0, 0, z - 0.8f * each), v3(0, 0, z), 0.7f * core);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), glass, 5);
    float end = z + 0.6f * each;
    if (hood) {
        dmg_hinge(b, front, "hood", v3(0, 0, 0), v3(0, 0, 1), 0.0f, 1.0f);
        const dmg_xy petal[] = {
            {0.92f * r, end - 0.2f * each}, {1.2f * r, end + 0.6f * r}, {1.14f * r, end + 0.6f * r}, {0.9f * r, end}};
        for (int i = 0; i < 2; ++i)
            dmg_lathe_arc(b, v3(0, 0, 0), v3(0, 0, 1), petal, 4, DMG_PI * (float)i - 1.1f, 2.2f);
        dmg_torus(b, v3(0, 0, end - 0.1f * each), v3(0, 0, 1), 0.93f * r, 0.04f * r);
    }
    if (cap && hinged) dmg_hinge(b, front, "lens_cap", v3(0, r, end), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.6f));
    if (cap && !hinged) dmg_slide(b, front, "lens_cap", v3(0, 0, 1), 0.0f, 0.5f * r);
    if (cap) dmg_cone(b, v3(0, 0, end + 0.01f * r), v3(0, 0, end + 0.15f * r), 0.95f * r, 0.9f * r);
    dmg_use(b, 0);
}

/* ---- the deck ---- */

static void draw_dial(dmg_builder* b, const char* name, float r, float high, bool endless) {
    int ribs = dmg_int(b, 0, 14);
    if (endless)
        dmg_spin(b, 0, name, v3(0, 0, 0), v3(0, 0, 1));
    else
        dmg_hinge(b, 0, name, v3(0, 0, 0), v3(0, 0, 1), -2.4f, 2.4f);
    draw_ring(b, r, 0, high, ribs);
    dmg_box(b, v3(0, 0.6f * r, high), v3(0.12f * r, 0.5f * r, 0.1f * high));
    dmg_use(b, 0);
}

/* Draws the release, in a collar that switches; the wind lever that swings out to the rear; the rewind crank that
 * folds. */
static void draw_deck(dmg_builder* b, const camera* c) {
    float r = 0.1f * c->high * dmg_range(b, 0.9f, 1.3f), x = -0.38f * c->wide, lean = dmg_range(b, 0.0f, 0.35f);
    bool collar = dmg_chance(b, 0.5f), wind = dmg_chance(b, 0.5f), crank = dmg_chance(b, 0.5f);
    int dials = dmg_int(b, 1, 2);
    dmg_aim(b, v3(x, c->top, 0.12f * c->deep), v3(0, 1, lean), v3(0, 0, -1));
    if (collar) {
        dmg_hinge(b, 0, "power_collar", v3(0, 0, 0), v3(0, 0, 1), 0.0f, 0.8f);
        dmg_rod(b, v3(0, 0, -0.3f * r), v3(0, 0, 0.35f * r), 1.1f * r);
        dmg_box(b, v3(0, -1.2f * r, 0.2f * r), v3(0.4f * r, 0.5f * r, 0.25f * r));
        dmg_use(b, 0);
    } else
        dmg_rod(b, v3(0, 0, -0.3f * r), v3(0, 0, 0.3f * r), 1.1f * r);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.35f * r);
    dmg_thumb_key_draw(b, 0, "shutter", 0.6f * r);
    dmg_restore(b);
    dmg_restore(b);
    for (int i = 0; i < dials; ++i) {
        dmg_aim(b, v3(c->wide * (i ? 0.27f : -0.23f), c->top, -0.1f * c->deep), v3(0, 1, 0), v3(0, 0, -1));
        bool endless = dmg_chance(b, 0.5f);
        draw_dial(b, i ? "speed_dial" : "mode_dial", 1.2f * r, 0.7f * r, endless);
        dmg_restore(b);
    }
    if (wind) {
        dmg_hinge(b, 0, "wind_lever", v3(x, c->top, -0.22f * c->deep), v3(0, 1, 0), 0.0f, dmg_range(b, 1.0f, 2.2f));
        dmg_rod(b, v3(x, c->top, -0.22f * c->deep), v3(x, c->top + 0.35f * r, -0.22f * c->deep), r);
        dmg_beam(b, v3(x, c->top + 0.2f * r, -0.22f * c->deep),
                 v3(x - 0.1f * c->wide, c->top + 0.2f * r, -0.45f * c->deep), 0.6f * r, 0.25f * r);
        dmg_use(b, 0);
    }
    if (crank) {
        dmg_vec at = v3(0.4f * c->wide, c->top, 0);
        uint32_t knob = dmg_spin(b, 0, "rewind_knob", at, v3(0, 1, 0));
        dmg_rod(b, at, v3(at.x, at.y + 0.5f * r, at.z), r);
        dmg_hinge(b, knob, "rewind_crank", v3(at.x - 0.7f * r, at.y + 0.6f * r, at.z), v3(0, 0, 1), 0.0f, 2.6f);
        dmg_box_span(b, v3(at.x - 0.8f * r, at.y + 0.52f * r, at.z - 0.2f * r),
                     v3(at.x + 0.8f * r, at.y + 0.7f * r, at.z + 0.2f * r));
        dmg_use(b, 0);
    }
}

/* Draws the finder's hump; in it a flash that rises about its rear edge, or a shoe on it. */
static void draw_hump(dmg_builder* b, const camera* c) {
    float w = c->wide * dmg_range(b, 0.12f, 0.18f), h = c->high * dmg_range(b, 0.15f, 0.3f), y = c->top;
    bool flash = dmg_chance(b, 0.5f);
    dmg_bent n = dmg_bent_between(v3(0, y - 0.1f * h, 0), v3(0, y + h, -0.05f * c->deep), v3(0, 0, 0), v3(1, 0, 0),
                                  1.2f * w, 0.5f * c->deep);
    n.wide[2] = 0.8f * w;
    n.power = dmg_range(b, 2.5f, 5.0f);
    n.round[0] = 0;
    n.round[1] = 0.1f;
    dmg_bent_draw(b, &n);
    if (flash) {
        dmg_hinge(b, 0, "flash", v3(0, y + 1.1f * h, -0.4f * c->deep), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_rounded_box(b, v3(0, y + 1.15f * h, 0.06f * c->deep), v3(1.7f * w, 0.22f * h, 0.95f * c->deep), 0.06f * h);
        dmg_use(b, 0);
    } else
        dmg_box_span(b, v3(-0.35f * w, y + 0.9f * h, -0.3f * c->deep), v3(0.35f * w, y + 1.05f * h, 0.1f * c->deep));
}

/* Behind: the whole back on its hinge, or a screen that swings out and turns over; below: the batteries. */
static void draw_back(dmg_builder* b, const camera* c) {
    float z = -0.5f * c->deep, t = 0.06f * c->deep, swing = dmg_range(b, 1.2f, 2.6f), w = 0.36f * c->wide,
          h = 0.3f * c->high;
    int kind = dmg_int(b, 0, 2);
    float mid = 0.5f * c->top;
    if (kind == 0) { /* about the edge at the right hand's other side */
        dmg_hinge(b, 0, "back", v3(0.47f * c->wide, 0, z - 0.5f * t), v3(0, -1, 0), 0.0f, swing);
        dmg_rounded_box(b, v3(0, mid, z - 0.8f * t), v3(0.92f * c->wide, 0.85f * c->top, 3 * t), 0.5f * t);
        dmg_rod(b, v3(0.47f * c->wide, mid - 0.4f * c->top, z - 0.5f * t),
                v3(0.47f * c->wide, mid + 0.4f * c->top, z - 0.5f * t), 0.7f * t);
    }
    if (kind == 1) {
        uint32_t arm = dmg_hinge(b, 0, "screen_arm", v3(w, mid, z - t), v3(0, -1, 0), 0.0f, swing);
        dmg_rod(b, v3(w, mid - 0.6f * h, z - t), v3(w, mid + 0.6f * h, z - t), t);
        dmg_hinge(b, arm, "screen", v3(w, mid, z - t), v3(1, 0, 0), -1.5f, 1.5f);
        dmg_rounded_box(b, v3(-0.1f * w, mid, z - t), v3(1.8f * w, 2 * h, 1.2f * t), 0.4f * t);
    }
    if (kind == 2) {
        dmg_hinge(b, 0, "screen", v3(-0.1f * w, mid + h, z - t), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.6f));
        dmg_rounded_box(b, v3(-0.1f * w, mid, z - t), v3(2 * w, 2 * h, 1.6f * t), 0.4f * t);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        float x = -0.2f * c->wide;
        dmg_hinge(b, 0, "battery_door", v3(x - 0.09f * c->wide, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 1.0f, 1.7f));
        dmg_box_span(b, v3(x - 0.09f * c->wide, -t, -0.3f * c->deep), v3(x + 0.09f * c->wide, 0, 0.3f * c->deep));
        dmg_use(b, 0);
    }
}

/* Draws a plate below with the lever that clamps it. */
static void draw_mount(dmg_builder* b, const camera* c) {
    float s = 0.5f * c->deep, t = 0.15f * s;
    dmg_rounded_box(b, v3(0, -1.2f * t, 0), v3(1.8f * s, 1.6f * t, 1.8f * s), 0.4f * t);
    dmg_box_span(b, v3(-s, -4 * t, -s), v3(s, -2.2f * t, s));
    dmg_hinge(b, 0, "plate_lever", v3(1.1f * s, -3 * t, 0.6f * s), v3(0, 1, 0), 0.0f, 1.6f);
    dmg_rod(b, v3(1.1f * s, -4 * t, 0.6f * s), v3(1.1f * s, -1.8f * t, 0.6f * s), 1.2f * t);
    dmg_beam(b, v3(1.1f * s, -3 * t, 0.6f * s), v3(1.15f * s, -3 * t, -0.9f * s), 0.8f * t, 1.4f * t);
    dmg_use(b, 0);
}

static void draw_still_camera(dmg_builder* b, camera* c) {
    float slope = dmg_range(b, 0.1f, 0.3f), lens = c->high * dmg_range(b, 0.28f, 0.42f),
          length = lens * dmg_range(b, 0.6f, 2.8f);
    bool grip = dmg_chance(b, 0.6f), mount = dmg_chance(b, 0.25f), hump = dmg_chance(b, 0.65f);
    dmg_bent n = dmg_bent_between(v3(-0.5f * c->wide, 0.5f * c->high, 0), v3(0.5f * c->wide, 0.5f * c->high, 0),
                                  v3(0, 0, 0), v3(0, 0, 1), 0.5f * c->deep, 0.5f * c->high);
    n.power = c->power;
    n.round[0] = n.round[1] = slope;
    dmg_bent_draw(b, &n);
    c->top = 0.97f * c->high;
    if (grip) {
        float deep = c->deep * dmg_range(b, 0.4f, 0.8f);
        dmg_bent g = dmg_bent_between(v3(-0.4f * c->wide, 0.02f * c->high, 0.45f * c->deep),
                                      v3(-0.39f * c->wide, 0.96f * c->high, 0.3f * c->deep), v3(0, 0, 0.1f * deep),
                                      v3(1, 0, 0), 0.11f * c->wide, 0.6f * deep);
        g.power = dmg_range(b, 2.0f, 3.0f);
        g.twist = dmg_range(b, -0.4f, 0.4f);
        bool key = dmg_chance(b, 0.4f);
        dmg_window w = {0};
        if (key) w = dmg_bent_open(&g, 0.72f, UP, 0.16f, 0.8f, 0.25f * deep);
        dmg_bent_draw(b, &g);
        if (key) dmg_bent_key_draw(b, &g, &w, 0, "front_key", DMG_KEY_ROCK);
    }
    dmg_save(b);
    dmg_move(b, 0.06f * c->wide, 0.48f * c->high, 0.5f * c->deep);
    draw_lens(b, lens, length);
    dmg_move(b, -1.25f * lens, -0.4f * lens, 0);
    dmg_thumb_key_draw(b, 0, "lens_release", 0.15f * lens);
    dmg_restore(b);
    draw_deck(b, c);
    if (hump) draw_hump(b, c);
    draw_back(b, c);
    if (mount) draw_mount(b, c);
}

/* Draws two lenses one above the other; the finder's four-winged hood on top, a crank at the side. */
static void draw_twin_lens(dmg_builder* b, const camera* c) {
    float w = 0.4f * c->wide, h = 1.5f * c->high, d = 0.42f * c->wide, t = 0.03f * w, r = 0.5f * w,
          swing = dmg_range(b, 1.0f, 1.7f);
    dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(2 * w, h, 2 * d), 0.1f * w);
    dmg_slide(b, 0, "lens_board", v3(0, 0, 1), 0.0f, 0.4f * d);
    uint32_t board = b->part;
    dmg_rounded_box(b, v3(0, 0.5f * h, d + 0.1f * w), v3(1.5f * w, 0.9f * h, 0.2f * w), 0.05f * w);
    dmg_box_span(b, v3(-0.6f * w, 0.12f * h, 0.5f * d), v3(0.6f * w, 0.88f * h, d));
    for (int i = 0; i < 2; ++i) {
        dmg_vec at = v3(0, h * (i ? 0.72f : 0.32f), d + 0.2f * w);
        dmg_rod(b, at, v3_add(at, v3(0, 0, 0.35f * w)), 0.85f * r);
        dmg_hinge(b, board, i ? "view_ring" : "shutter_ring", at, v3(0, 0, 1), -0.8f, 0.8f);
        dmg_rod(b, v3_add(at, v3(0, 0, 0.02f * w)), v3_add(at, v3(0, 0, 0.2f * w)), r);
        dmg_use(b, board);
    }
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) { /* the side wings lie under the lid */
        dmg_hinge(b, 0, "hood_wing", v3((float)s * w, h + 0.5f * t, 0), v3(0, 0, (float)-s), 0.0f, 1.5f);
        dmg_box_span(b, v3(s > 0 ? 0.05f * w : -w, h, -0.9f * d), v3(s > 0 ? w : -0.05f * w, h + t, 0.9f * d));
        dmg_use(b, 0);
    }
    dmg_hinge(b, 0, "hood_lid", v3(0, h + 1.6f * t, -d), v3(-1, 0, 0), 0.0f, swing);
    dmg_box_span(b, v3(-w, h + 1.2f * t, -d), v3(w, h + 2.4f * t, d));
    dmg_use(b, 0);
    uint32_t hub = dmg_spin(b, 0, "crank", v3(-w, 0.6f * h, 0), v3(-1, 0, 0));
    dmg_rod(b, v3(-w, 0.6f * h, 0), v3(-1.15f * w, 0.6f * h, 0), 0.25f * w);
    dmg_box_span(b, v3(-1.2f * w, 0.55f * h, -0.1f * w), v3(-1.12f * w, 0.6f * h + 0.7f * w, 0.1f * w));
    dmg_spin(b, hub, "crank_knob", v3(0, 0.6f * h + 0.6f * w, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-1.2f * w, 0.6f * h + 0.6f * w, 0), v3(-1.5f * w, 0.6f * h + 0.6f * w, 0), 0.12f * w);
    dmg_use(b, 0);
    dmg_spin(b, 0, "focus_knob", v3(w, 0.35f * h, 0.3f * d), v3(1, 0, 0));
    dmg_rod(b, v3(w, 0.35f * h, 0.3f * d), v3(1.25f * w, 0.35f * h, 0.3f * d), 0.35f * w);
    dmg_use(b, 0);
}

void dmg_build_camera_body(dmg_builder* b) {
    camera c = {.wide = dmg_range(b, 0.1f, 0.16f)};
    c.high = c.wide * dmg_range(b, 0.5f, 0.72f);
    c.deep = c.wide * dmg_range(b, 0.2f, 0.38f);
    c.power = dmg_scale_range(b, 3.5f, 9.0f);
    float whole = dmg_range(b, -0.5f, 0.5f);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(1, 0, 0), whole);
    if (dmg_chance(b, 0.8f))
        draw_still_camera(b, &c);
    else
        draw_twin_lens(b, &c);
}
