/* Draws players of tapes, discs and cartridges: camcorders, reel machines, cassette players, video recorders, and
 * game consoles with lids, trays and flaps. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Draws a plate before z = 0 on a hinge below, above, or at a side (0 … 3); sides 0 and 1 may also fall inwards. */
static uint32_t draw_door(dmg_builder* b, const char* name, float wide, float high, float t, int side, float swing) {
    float x = side == 2 ? -0.5f * wide : 0.5f * wide, y = side == 0 ? -0.5f * high : 0.5f * high;
    bool upright = side > 1, grip = dmg_chance(b, 0.5f);
    dmg_vec axis = upright ? v3(0, side == 2 ? -1.0f : 1.0f, 0) : v3(side == 0 ? 1.0f : -1.0f, 0, 0);
    uint32_t door = dmg_hinge(b, 0, name, v3(upright ? x : 0, upright ? 0 : y, 0.6f * t), axis, 0.0f, swing);
    dmg_box(b, v3(0, 0, 0.55f * t), v3(wide, high, 0.9f * t));
    if (grip)
        dmg_box(b, v3(upright ? -0.8f * x : 0, upright ? 0 : -0.8f * y, 1.2f * t),
                upright ? v3(0.05f * wide, 0.4f * high, 0.6f * t) : v3(0.4f * wide, 0.08f * high, 0.6f * t));
    dmg_use(b, 0);
    return door;
}

static void draw_round_key(dmg_builder* b, const char* name, float r, float rise) {
    bool square = dmg_chance(b, 0.4f);
    dmg_slide(b, 0, name, v3(0, 0, -1), 0.0f, 0.7f * rise);
    if (square)
        dmg_rounded_box(b, v3(0, 0, 0.2f * rise), v3(2.4f * r, 1.4f * r, 1.6f * rise), 0.4f * rise);
    else
        dmg_rod(b, v3(0, 0, -0.5f * rise), v3(0, 0, rise), r);
    dmg_use(b, 0);
}

/* Draws a spool with three windows. */
static void draw_reel(dmg_builder* b, const char* name, float r, float t) {
    int arms = dmg_int(b, 3, 5);
    bool full = dmg_chance(b, 0.5f);
    dmg_spin(b, 0, name, v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 1.6f * t), 0.25f * r);
    dmg_wheel_draw(b, full ? 2 : 3, r, t, arms);
    dmg_use(b, 0);
}

/* ---- camcorder: the lens looks to +Z, the screen is on its left (+X) ---- */

typedef struct camcorder {
    float half, high, length; /* x: half the width; z from -length to 0 */
} camcorder;

/* Comes out about an upright line at its front edge, then turns about its own length. */
static void draw_flip_screen(dmg_builder* b, const camcorder* c) {
    float t = 0.14f * c->half, reach = c->length * dmg_range(b, 0.5f, 0.75f), y = 0.55f * c->high,
          tall = c->high * dmg_range(b, 0.5f, 0.8f), x = c->half, z = -0.15f * c->length;
    float out = dmg_range(b, 1.4f, 1.9f), rest = out * dmg_unit(b);
    bool tilts = dmg_chance(b, 0.6f), shown = dmg_chance(b, 0.5f);
    uint32_t yoke = dmg_hinge(b, 0, "screen", v3(x + 0.7f * t, y, z), v3(0, -1, 0), 0.0f, out);
    if (shown || tilts) dmg_rest(b, yoke, tilts ? out : rest); /* it can only turn over when it is out */
    if (tilts) dmg_keep_rest(b, yoke);
    dmg_rod(b, v3(x + 0.7f * t, y - 0.3f * tall, z), v3(x + 0.7f * t, y + 0.3f * tall, z), 0.6f * t);
    if (tilts) {
        dmg_rod(b, v3(x + 0.7f * t, y, z - 2 * t), v3(x + 0.7f * t, y, z), 0.4f * t);
        dmg_hinge(b, yoke, "screen_tilt", v3(x + 0.7f * t, y, z), v3(0, 0, 1), -0.3f, 3.1f);
        dmg_keep_rest(b, b->part);
    }
    dmg_box_span(b, v3(x + 0.1f * t, y - 0.5f * tall, z - reach), v3(x + 1.3f * t, y + 0.5f * tall, z - t));
    dmg_use(b, 0);
}

static void draw_lens(dmg_builder* b, const camcorder* c) {
    float r = fminf(c->half, 0.5f * c->high) * dmg_range(b, 0.6f, 0.95f),
          length = c->length * dmg_range(b, 0.15f, 0.4f), y = 0.58f * c->high;
    bool ring = dmg_chance(b, 0.6f);
    int cap = dmg_int(b, 0, 3);
    dmg_rod(b, v3(0, y, -0.1f * length), v3(0, y, length), 0.85f * r);
    if (ring) {
        float way = dmg_sign(b);
        dmg_hinge(b, 0, "zoom_ring", v3(0, y, 0), v3(0, 0, way), 0.0f, dmg_range(b, 1.5f, 4.7f));
        dmg_rod(b, v3(0, y, 0.3f * length), v3(0, y, 0.75f * length), r);
        dmg_box(b, v3(0, y + r, 0.5f * length), v3(0.15f * r, 0.2f * r, 0.35f * length));
    }
    if (cap == 1) { /* a cover on the hood's edge */
        dmg_hinge(b, 0, "lens_cover", v3(0, y + 0.9f * r, length), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.6f, 2.8f));
        dmg_rod(b, v3(0, y, length), v3(0, y, length + 0.1f * r), 0.9f * r);
    }
    if (cap == 2) { /* turned away in its plane */
        dmg_hinge(b, 0, "lens_cover", v3(0.85f * r, y + 0.4f * r, length), v3(0, 0, -1), 0.0f, 1.9f);
        dmg_rod(b, v3(0, y, length), v3(0, y, length + 0.12f * r), 0.88f * r);
    }
    dmg_use(b, 0);
}

/* Above and behind: what the eye looks into, the rocker, the red key, the battery, the strap for the hand. */
static void draw_camcorder_hardware(dmg_builder* b, const camcorder* c) {
    float rear = -c->length, t = 0.1f * c->half, r = 0.3f * c->half;
    if (dmg_chance(b, 0.6f)) { /* the finder's far end comes up */
        float y = c->high + r, reach = 0.35f * c->length;
        dmg_box_span(b, v3(-0.6f * r, c->high, rear + reach), v3(0.6f * r, y, rear + reach + 2 * r));
        uint32_t finder = dmg_hinge(b, 0, "finder", v3(0, y, rear + reach + r), v3(1, 0, 0), 0.0f, 1.4f);
        dmg_rounded_box(b, v3(0, y + 0.3f * r, rear + 0.5f * reach + r), v3(1.6f * r, 1.4f * r, reach), 0.2f * r);
        dmg_slide(b, finder, "eyepiece", v3(0, 0, -1), 0.0f, 0.9f * r);
        dmg_rod(b, v3(0, y + 0.3f * r, rear), v3(0, y + 0.3f * r, rear + 2 * r), 0.55f * r);
        dmg_use(b, 0);
    }
    dmg_hinge(b, 0, "zoom_rocker", v3(-0.3f * c->half, c->high, -0.4f * c->length), v3(1, 0, 0), -0.2f, 0.2f);
    dmg_rounded_box(b, v3(-0.3f * c->half, c->high + 0.5f * t, -0.4f * c->length), v3(3 * t, 1.2f * t, 6 * t),
                    0.4f * t);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, 0.7f * c->high, rear);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_move(b, 0.6f * c->half, 0, 0);
    draw_round_key(b, "record_key", 1.5f * t, 0.7f * t);
    dmg_restore(b);
    dmg_slide(b, 0, "battery", v3(0, dmg_chance(b, 0.5f) ? 1.0f : -1.0f, 0), 0.0f, 0.45f * c->high);
    dmg_box_span(b, v3(-0.5f * c->half, 0.06f * c->high, rear - 0.25f * c->length),
                 v3(0.5f * c->half, 0.55f * c->high, rear));
    dmg_use(b, 0);
    enum { POINTS = 7 };
    dmg_vec path[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1);
        path[i] = v3(-c->half - 0.6f * c->half * sinf(angle), 0.5f * c->high,
                     -0.5f * c->length + 0.38f * c->length * cosf(angle));
    }
    dmg_sweep(b, path, POINTS, 0.4f * t, 0.17f * c->high, false);
}

static void draw_camcorder(dmg_builder* b) {
    camcorder c = {.half = dmg_range(b, 0.025f, 0.05f)};
    c.high = c.half * dmg_range(b, 2.2f, 3.6f);
    c.length = c.half * dmg_range(b, 3.4f, 6.0f);
    bool soft = dmg_chance(b, 0.6f), door = dmg_chance(b, 0.7f);
    dmg_vec middle = v3(0, 0.5f * c.high, -0.5f * c.length), size = v3(2 * c.half, c.high, c.length);
    if (soft)
        dmg_rounded_box(b, middle, size, 0.3f * c.half);
    else
        dmg_box(b, middle, size);
    draw_lens(b, &c);
    draw_flip_screen(b, &c);
    draw_camcorder_hardware(b, &c);
    if (!door) return;
    dmg_save(b); /* the cassette goes in under the strap's side */
    dmg_move(b, -c.half, 0.5f * c.high, -0.5f * c.length);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    draw_door(b, "cassette_door", 0.65f * c.length, 0.75f * c.high, 0.12f * c.half, 0, dmg_range(b, 0.3f, 0.5f));
    dmg_restore(b);
}

/* ---- tape ---- */

/* Draws a short pointer that chooses how fast the tape runs, at (x, y). */
static void draw_selector(dmg_builder* b, float x, float y, float t) {
    dmg_hinge(b, 0, "selector", v3(x, y, 0), v3(0, 0, -1), -0.8f, 0.8f);
    dmg_rod(b, v3(x, y, 0), v3(x, y, t), 1.2f * t);
    dmg_box_span(b, v3(x - 0.4f * t, y, 0.4f * t), v3(x + 0.4f * t, y + 3 * t, 0.9f * t));
    dmg_use(b, 0);
}

/* Draws two reels on a deck that lies or stands, heads under a cover between them. */
static void draw_reel_machine(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.12f, 0.28f), high = half * dmg_range(b, 1.8f, 2.4f),
          deep = half * dmg_range(b, 0.4f, 0.8f), r = half * dmg_range(b, 0.36f, 0.46f), t = 0.06f * half;
    bool lies = dmg_chance(b, 0.5f), lid = dmg_chance(b, 0.35f);
    int keys = dmg_int(b, 3, 6), side = dmg_int(b, 0, 1);
    dmg_save(b);
    if (lies) {
        dmg_move(b, 0, 0, 0.5f * high);
        dmg_face_up(b);
        dmg_move(b, 0, 0, deep);
    } else {
        dmg_move(b, 0, 0, 0.5f * deep);
    }
    dmg_box_span(b, v3(-half, 0, -deep), v3(half, high, 0));
    for (int i = -1; i <= 1; i += 2) {
        dmg_save(b);
        dmg_move(b, (float)i * 0.5f * half, high - 1.15f * r, 0.9f * t);
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, -0.3f * t), 0.2f * r);
        draw_reel(b, "reel", r, 0.5f * t);
        dmg_restore(b);
    }
    float y = high - 2.6f * r;
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    if (dmg_chance(b, 0.7f)) draw_door(b, "head_cover", 0.7f * half, 0.3f * r, 2 * t, side, dmg_range(b, 0.7f, 1.6f));
    dmg_restore(b);
    draw_selector(b, 0.75f * half, y, t);
    for (int i = 0; i < keys; ++i) {
        dmg_save(b);
        dmg_move(b, half * (0.24f * (float)i - 0.8f), 0.1f * high, 0);
        draw_round_key(b, "tape_key", 0.07f * half, 0.4f * t);
        dmg_restore(b);
    }
    if (lid && lies) { /* hung behind; the case opens like a trunk */
        dmg_hinge(b, 0, "lid", v3(0, high, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.0f));
        dmg_save(b);
        dmg_move(b, 0, 0.5f * high, 3.5f * t);
        dmg_case_draw(b, DMG_CASE_BOARDS, 2 * half, high, 0.1f * t, 0.05f * t);
        dmg_restore(b);
        dmg_box_span(b, v3(-half, high - t, 0), v3(half, high, 3.5f * t));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Worn on a belt: the whole front opens, the keys are along an edge. */
static void draw_cassette_player(dmg_builder* b) {
    float half = dmg_range(b, 0.038f, 0.06f), high = half * dmg_range(b, 1.9f, 3.0f),
          deep = half * dmg_range(b, 0.4f, 0.7f), t = 0.18f * deep;
    int keys = dmg_int(b, 3, 5), side = dmg_weighted(b, (const float[]){3, 0.5f, 1, 1}, 4);
    bool solid = dmg_chance(b, 0.4f), clip = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * high, 0);
    dmg_case_draw(b, solid ? DMG_CASE_SOLID : DMG_CASE_BOARDS, 2 * half, high, deep, t);
    draw_door(b, "cassette_door", 1.96f * half, 0.97f * high, 1.2f * t, side, dmg_range(b, 0.4f, 1.3f));
    dmg_restore(b);
    for (int i = 0; i < keys; ++i) {
        dmg_save(b);
        dmg_move(b, half * (0.3f * (float)i - 0.15f * (float)(keys - 1)), high, -0.5f * deep);
        dmg_face_up(b);
        draw_round_key(b, "tape_key", 0.11f * half, 0.35f * t);
        dmg_restore(b);
    }
    float r = 0.14f * half;
    dmg_spin(b, 0, "volume", v3(half - 0.3f * r, 0.7f * high, -0.5f * deep), v3(0, 1, 0));
    dmg_rod(b, v3(half - 0.3f * r, 0.67f * high, -0.5f * deep), v3(half - 0.3f * r, 0.73f * high, -0.5f * deep), r);
    dmg_use(b, 0);
    if (!clip) return;
    dmg_box_span(b, v3(-r, 0.8f * high, -deep - t), v3(r, 0.86f * high, -deep));
    dmg_hinge(b, 0, "clip", v3(0, 0.83f * high, -deep - t), v3(1, 0, 0), 0.0f, 0.3f);
    dmg_box_span(b, v3(-1.5f * r, 0.35f * high, -deep - 1.6f * t), v3(1.5f * r, 0.9f * high, -deep - t));
}

/* Draws a flat box: a flap that the cassette pushes in, a panel that comes down over the small keys, a wheel to search.
 */
static void draw_video_recorder(dmg_builder* b) {
    float half = dmg_range(b, 0.15f, 0.24f), high = half * dmg_range(b, 0.35f, 0.6f),
          deep = half * dmg_range(b, 0.7f, 0.9f), t = 0.05f * high, at = dmg_sign(b) * 0.45f * half,
          slot = dmg_range(b, 0.24f, 0.32f) * high;
    bool top = dmg_chance(b, 0.3f), wheel = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-half, 0.08f * high, -deep), v3(half, top ? 0.9f * high : high, 0));
    for (int i = 0; i < 4; ++i)
        dmg_rod(b, v3((i & 1 ? 0.8f : -0.8f) * half, 0, i & 2 ? -0.1f * deep : -0.9f * deep),
                v3((i & 1 ? 0.8f : -0.8f) * half, 0.09f * high, i & 2 ? -0.1f * deep : -0.9f * deep), t);
    if (top) { /* the carrier comes up out of the top */
        dmg_slide(b, 0, "carrier", v3(0, 1, 0), 0.0f, 0.45f * high);
        dmg_box_span(b, v3(at - 0.42f * half, 0.5f * high, -0.6f * deep), v3(at + 0.42f * half, high, -0.06f * deep));
        dmg_use(b, 0);
    }
    dmg_save(b);
    dmg_move(b, at, 0.74f * high, 0);
    if (!top) draw_door(b, "cassette_flap", 0.84f * half, slot, t, 1, dmg_range(b, 0.8f, 1.5f));
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, at, 0.28f * high, 0);
    draw_door(b, "panel", 0.9f * half, 0.32f * high, t, 0, dmg_range(b, 1.2f, 1.57f));
    dmg_move(b, -2 * at, 0, 0);
    if (wheel) {
        dmg_spin(b, 0, "search_wheel", v3(0, 0.2f * high, 0), v3(0, 0, -1));
        dmg_rod(b, v3(0, 0.2f * high, 0), v3(0, 0.2f * high, 2 * t), 0.22f * high);
        dmg_rod(b, v3(0, 0.33f * high, 2 * t), v3(0, 0.33f * high, 2.5f * t), 0.05f * high);
        dmg_use(b, 0);
    } else {
        dmg_controls_draw(b, 0, 0.8f * half, 0.4f * high);
    }
    dmg_restore(b);
}

void dmg_build_recorder(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 3, 2.5f, 2}, 4);
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    if (kind == 0) draw_camcorder(b);
    if (kind == 1) draw_reel_machine(b);
    if (kind == 2) draw_cassette_player(b);
    if (kind == 3) draw_video_recorder(b);
}

/* ---- game console ---- */

typedef struct game_box {
    float half, high, deep, t;
} game_box;

/* Draws a lid over the disc, round or square, hung behind; the disc lies under it on its spindle. */
static void draw_disc_lid(dmg_builder* b, const game_box* g) {
    float r = fminf(0.62f * g->deep, 0.8f * g->half) * dmg_range(b, 0.8f, 1.0f), t = g->t,
          x = (g->half - r) * dmg_range(b, -0.8f, 0.8f), z = 0.15f * g->deep, swing = dmg_range(b, 0.6f, 1.4f),
          thick = dmg_range(b, 0.3f, 1.0f) * t;
    bool round = dmg_chance(b, 0.6f);
    float y = g->high;
    dmg_spin(b, 0, "disc", v3(x, 0, z), v3(0, 1, 0));
    dmg_rod(b, v3(x, y, z), v3(x, y + 0.15f * t, z), 0.85f * r);
    dmg_rod(b, v3(x, y, z), v3(x, y + 0.35f * t, z), 0.15f * r);
    dmg_use(b, 0);
    dmg_box_span(b, v3(x - 0.4f * r, y, z - 1.02f * r - t), v3(x + 0.4f * r, y + 0.5f * t, z - 1.02f * r));
    uint32_t lid = dmg_hinge(b, 0, "disc_lid", v3(x, y + 0.4f * t, z - 1.02f * r), v3(-1, 0, 0), 0.0f, swing);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, lid, swing);
    dmg_box_span(b, v3(x - 0.38f * r, y + 0.45f * t, z - 1.02f * r),
                 v3(x + 0.38f * r, y + 0.45f * t + thick, z - 0.7f * r));
    if (round)
        dmg_cone(b, v3(x, y + 0.45f * t, z), v3(x, y + 0.45f * t + thick, z), r, 0.94f * r);
    else
        dmg_box_span(b, v3(x - r, y + 0.45f * t, z - r), v3(x + r, y + 0.45f * t + thick, z + r));
    dmg_use(b, 0);
}

/* Draws two flaps that a cartridge pushes in, or one that lifts off its slot. */
static void draw_cartridge_slot(dmg_builder* b, const game_box* g) {
    float wide = 0.7f * g->half, deep = 0.16f * g->deep, y = g->high, t = 0.5f * g->t, z = -0.1f * g->deep;
    bool pair = dmg_chance(b, 0.5f);
    for (int i = -1; i <= 1; i += 2) /* the slot's banks */
        dmg_box_span(b, v3(-1.15f * wide, y, z + (float)i * (deep + 2 * t) - 2 * t),
                     v3(1.15f * wide, y + 3 * t, z + (float)i * (deep + 2 * t) + 2 * t));
    for (int i = -1; i <= 1; i += 2) {
        float side = (float)i;
        if (!pair && i > 0) break;
        dmg_hinge(b, 0, "slot_flap", v3(0, y + 2.6f * t, z + side * deep), v3(side * (pair ? -1.0f : 1.0f), 0, 0), 0.0f,
                  pair ? 0.4f : 1.6f);
        dmg_box_span(b, v3(-wide, y + 2 * t, fminf(z + side * deep, pair ? z : z - side * deep)),
                     v3(wide, y + 3 * t, fmaxf(z + side * deep, pair ? z : z - side * deep)));
        dmg_use(b, 0);
    }
}

/* On the front: a tray, or a flap over the bay; doors over the sockets; the keys. */
static void draw_console_front(dmg_builder* b, const game_box* g, bool front_loads) {
    float y = 0.62f * g->high, wide = 0.5f * g->half, t = 0.5f * g->t;
    int ports = dmg_int(b, 0, 2), side = dmg_int(b, 0, 1);
    bool tray = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, -0.25f * g->half, 0.5f * g->high, g->deep);
    if (front_loads && tray) {
        dmg_slide(b, 0, "disc_tray", v3(0, 0, 1), 0.0f, fminf(1.1f * g->deep, 1.6f * g->half));
        dmg_box(b, v3(0, 0.3f * g->high, 0.3f * t), v3(2.1f * wide, 0.2f * g->high, t));
        dmg_box_span(b, v3(-wide, 0.22f * g->high, -1.4f * g->deep), v3(wide, 0.26f * g->high, 0));
        dmg_use(b, 0);
    } else if (front_loads) {
        dmg_save(b);
        dmg_move(b, 0, 0.22f * g->high, 0);
        draw_door(b, "bay_flap", 2.2f * wide, 0.4f * g->high, t, 1, dmg_range(b, 1.2f, 1.9f));
        dmg_restore(b);
    }
    dmg_restore(b);
    for (int i = 0; i < ports; ++i) { /* each over two sockets */
        dmg_save(b);
        dmg_move(b, g->half * (0.6f * (float)i - 0.55f), 0.2f * g->high, g->deep);
        draw_door(b, "port_flap", 0.5f * g->half, 0.24f * g->high, t, side, dmg_range(b, 1.2f, 1.8f));
        dmg_restore(b);
    }
    for (int i = 0; i < 2; ++i) {
        dmg_save(b);
        dmg_move(b, 0.68f * g->half + 0.2f * g->half * (float)i, y, g->deep);
        draw_round_key(b, i ? "eject" : "power", fminf(0.07f * g->half, 0.15f * g->high), t);
        dmg_restore(b);
    }
}

void dmg_build_game_console(dmg_builder* b) {
    game_box g = {.half = dmg_scale_range(b, 0.08f, 0.2f)};
    g.high = g.half * dmg_range(b, 0.25f, 0.6f);
    g.deep = g.half * dmg_range(b, 0.6f, 1.2f);
    g.t = g.half * dmg_range(b, 0.04f, 0.08f);
    int load = dmg_weighted(b, (const float[]){4, 2.5f, 3}, 3);
    bool stands = load == 2 && dmg_chance(b, 0.4f), sliding = dmg_chance(b, 0.3f), soft = dmg_chance(b, 0.3f);
    dmg_save(b);
    if (stands) { /* on its side, on a foot that turns */
        float r = dmg_range(b, 0.4f, 0.8f) * g.deep, foot = 0.5f * g.t;
        uint32_t plate = dmg_hinge(b, 0, "foot", v3(0, foot, 0), v3(0, 1, 0), -0.8f, 0.8f);
        dmg_rod(b, v3(0, 0, 0), v3(0, foot, 0), fmaxf(r, 0.7f * g.high));
        dmg_use(b, 0);
        dmg_keep_rest(b, plate);
        dmg_move(b, 0.5f * g.high, foot + g.half, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    }
    if (soft)
        dmg_rounded_box(b, v3(0, 0.5f * g.high, 0), v3(2 * g.half, g.high, 2 * g.deep), 0.2f * g.high);
    else
        dmg_box(b, v3(0, 0.5f * g.high, 0), v3(2 * g.half, g.high, 2 * g.deep));
    if (load == 0) draw_disc_lid(b, &g);
    if (load == 1) draw_cartridge_slot(b, &g);
    draw_console_front(b, &g, load == 2);
    if (load == 1 && sliding) { /* the switch on top beside the slot */
        dmg_slide(b, 0, "power_switch", v3(0, 0, -1), 0.0f, 0.15f * g.deep);
        dmg_box(b, v3(-0.8f * g.half, g.high + 0.2f * g.t, 0.6f * g.deep),
                v3(0.15f * g.half, 0.6f * g.t, 0.15f * g.deep));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}
