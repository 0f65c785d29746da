/* Draws controls held in one hand, as bent shells: pebbles and wands with a touch disc, gun-shaped controllers. Forward
 * is +Z. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

static const float AHEAD = 0.5f * DMG_PI; /* the angle round an upright grip */

/* ---- what several have ---- */

/* A finger's lever out of an opening of the shell; the opening is made before the shell is drawn. */
static void open_for_lever(dmg_bent* n, float s, float angle, float wide, float around) {
    dmg_bent_open(n, s, angle, 0.35f, 2 * wide / around, 0.35f * around);
}

static void place_lever(dmg_builder* b, const dmg_bent* n, uint32_t parent, const char* name, float s, float angle,
                        float wide, float length) {
    float yaw = dmg_range(b, -0.15f, 0.15f), lean = dmg_range(b, -0.15f, 0.3f);
    dmg_bent_stand(b, n, s, angle, 0);
    dmg_turn(b, v3(0, 0, 1), yaw);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_finger_lever_draw(b, parent, name, wide, length);
    dmg_restore(b);
}

/* ---- pebbles, pucks, wands ---- */

/* Lying: the player behind, the top at AHEAD. */
static dmg_bent pick_pebble(dmg_builder* b, float* length) {
    int kind = dmg_int(b, 0, 2);
    float l = kind == 2 ? dmg_range(b, 0.11f, 0.18f) : dmg_range(b, 0.06f, 0.1f);
    float wide = l * (kind == 2 ? dmg_range(b, 0.1f, 0.15f) : dmg_range(b, 0.28f, 0.5f)),
          thick = kind == 2 ? wide * dmg_range(b, 0.5f, 1.0f) : l * dmg_range(b, 0.12f, 0.22f),
          bow = l * dmg_range(b, -0.08f, 0.12f);
    dmg_bent n = dmg_bent_between(v3(0, 0, -0.5f * l), v3(0, 0, 0.5f * l), v3(0, bow, 0), v3(-1, 0, 0), wide, thick);
    n.wide[0] *= dmg_range(b, 0.7f, 1.1f);
    n.wide[2] *= dmg_range(b, 0.7f, 1.2f);
    n.deep[0] *= dmg_range(b, 0.5f, 1.0f);
    n.deep[2] *= dmg_range(b, 0.6f, 1.1f);
    n.power = dmg_scale_range(b, 2.0f, 4.0f);
    n.round[0] = kind == 2 ? dmg_range(b, 0.05f, 0.15f) : dmg_range(b, 0.3f, 0.5f);
    n.round[1] = kind == 2 ? dmg_range(b, 0.05f, 0.2f) : dmg_range(b, 0.3f, 0.5f);
    n.rows = 30;
    n.columns = 28;
    *length = l;
    return n;
}

/* Draws a small grip in a slot that slides along the shell. */
static void draw_slide_switch(dmg_builder* b, const dmg_bent* n, float s, float angle, float size) {
    dmg_bent_stand(b, n, s, angle, 0);
    dmg_frame_draw(b, 0.8f * size, 2 * size, 0.2f * size, 0.08f * size);
    dmg_slide(b, 0, "slide_switch", v3(0, 1, 0), 0.0f, 0.7f * size);
    dmg_rounded_box(b, v3(0, -0.4f * size, 0.1f * size), v3(0.55f * size, 0.8f * size, 0.5f * size), 0.1f * size);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_loop(dmg_builder* b, const dmg_bent* n, float size) {
    dmg_bent_stand(b, n, 0.0f, 0, 0);
    dmg_restore(b);
    dmg_torus(b, v3_add(n->control[0], v3(0, 0, -0.2f * size)), v3(1, 0, 0), 0.5f * size, 0.12f * size);
}

void dmg_build_puck_controller(dmg_builder* b) {
    float length, pitch = dmg_range(b, -0.9f, 0.9f), roll = dmg_range(b, -0.6f, 0.6f);
    dmg_move(b, 0, 0.1f, 0);
    dmg_turn(b, v3(1, 0, 0), pitch);
    dmg_turn(b, v3(0, 0, 1), roll);
    dmg_bent n = pick_pebble(b, &length);
    float thick = n.deep[1], wide = n.wide[1], far = dmg_range(b, 0.64f, 0.74f), near = dmg_range(b, 0.3f, 0.46f),
          pull = wide * dmg_range(b, 0.5f, 0.9f), reach = fminf(0.3f * length, thick * dmg_range(b, 1.0f, 2.2f));
    int rockers = dmg_int(b, 0, 2), lead = dmg_int(b, 0, 2);
    bool trigger = dmg_chance(b, 0.75f), flank = dmg_chance(b, 0.4f), slide = dmg_chance(b, 0.3f),
         loop = dmg_chance(b, 0.4f);
    dmg_window keys[2] = {0}, side = {0}, disc = {0};
    dmg_key_motion tips = dmg_chance(b, 0.5f) ? DMG_KEY_ROCK : DMG_KEY_ROCK_ASIDE,
                   press = dmg_chance(b, 0.5f) ? DMG_KEY_ROCK : DMG_KEY_LAST;
    if (lead == 0) disc = dmg_bent_open(&n, far, AHEAD, fminf(0.25f, 1.5f * wide / length), 1.5f, 0.4f * thick);
    for (int i = 0; i < rockers; ++i)
        keys[i] = dmg_bent_open(&n, near, rockers == 1 ? AHEAD : AHEAD + (i ? 0.45f : -0.45f), 0.22f,
                                rockers == 1 ? 1.0f : 0.7f, 0.4f * thick);
    if (flank) side = dmg_bent_open(&n, 0.55f, 0, 0.2f, 0.6f, 0.3f * thick);
    if (trigger) open_for_lever(&n, 0.6f, AHEAD + DMG_PI, 0.8f * pull, 1.3f * thick);
    dmg_bent_draw(b, &n);
    if (lead == 0) dmg_bent_key_draw(b, &n, &disc, 0, "touch_disc", tips);
    if (lead > 0) {
        dmg_bent_stand(b, &n, far, AHEAD, 0);
        if (lead == 1) dmg_touch_pad_draw(b, 0, 0.55f * wide);
        if (lead == 2) dmg_hat_draw(b, 0, "hat", 0.45f * wide);
        dmg_restore(b);
    }
    for (int i = 0; i < rockers; ++i) dmg_bent_key_draw(b, &n, &keys[i], 0, "rocker", press);
    if (flank) dmg_bent_key_draw(b, &n, &side, 0, "volume", DMG_KEY_ROCK);
    if (trigger) place_lever(b, &n, 0, "trigger", 0.66f, AHEAD + DMG_PI, pull, reach);
    if (slide) draw_slide_switch(b, &n, 0.5f, DMG_PI, 0.35f * thick);
    if (loop) draw_loop(b, &n, 0.4f * thick);
}

/* ---- a gun ---- */

/* The slide over the frame, the hammer behind it; top: where the frame's upper side is. */
static void draw_gun_top(dmg_builder* b, float length, float half, float top, bool hammer) {
    float high = half * dmg_range(b, 0.6f, 1.2f), way = length * dmg_range(b, 0.1f, 0.25f), front = 0.5f * length;
    bool slides = dmg_chance(b, 0.7f);
    dmg_bent n = dmg_bent_between(v3(0, top + high, -0.42f * length), v3(0, top + high, front), v3(0, 0, 0),
                                  v3(-1, 0, 0), 0.85f * half, high);
    n.power = dmg_range(b, 2.5f, 6.0f);
    n.deep[2] *= dmg_range(b, 0.6f, 1.0f);
    n.round[0] = n.round[1] = 0.05f;
    if (slides) dmg_slide(b, 0, "slide", v3(0, 0, -1), 0.0f, way);
    uint32_t part = b->part;
    int keys = dmg_int(b, 0, 3);
    dmg_bent_draw(b, &n);
    for (int i = 0; i < keys; ++i) {
        dmg_bent_stand(b, &n, 0.35f + 0.2f * (float)i, AHEAD, 0);
        dmg_thumb_key_draw(b, part, "rail_button", 0.3f * half);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (!hammer) return;
    dmg_hinge(b, 0, "hammer", v3(0, top, -0.44f * length), v3(-1, 0, 0), 0.0f,
              slides ? 0.5f : dmg_range(b, 0.4f, 1.0f));
    dmg_beam(b, v3(0, top - 0.2f * high, -0.44f * length), v3(0, top + 1.5f * high, -0.46f * length), 0.4f * half,
             0.4f * half);
    dmg_rod(b, v3(-0.3f * half, top + 1.5f * high, -0.48f * length),
            v3(0.3f * half, top + 1.5f * high, -0.48f * length), 0.3f * half);
    dmg_use(b, 0);
}

/* Draws the grip down from the frame: a release, a safety, a magazine drawn out of its foot. */
static void draw_gun_grip(dmg_builder* b, float length, float half, float lean) {
    float down = length * dmg_range(b, 0.5f, 0.7f), deep = half * dmg_range(b, 1.4f, 2.0f), z = -0.3f * length;
    dmg_vec foot = v3(0, -down * cosf(lean), z - down * sinf(lean));
    bool magazine = dmg_chance(b, 0.6f), squeeze = dmg_chance(b, 0.3f);
    dmg_bent n = dmg_bent_between(foot, v3(0, 0.3f * half, z), v3(0, 0, 0), v3(1, 0, 0), 0.8f * half, deep);
    n.egg = dmg_range(b, -0.1f, 0.3f);
    n.power = dmg_range(b, 2.0f, 3.5f);
    n.wide[1] *= dmg_range(b, 0.9f, 1.15f);
    n.round[0] = n.round[1] = 0;
    dmg_window back = {0};
    if (squeeze) back = dmg_bent_open(&n, 0.6f, AHEAD + DMG_PI, 0.4f, 0.8f, 0.35f * half);
    dmg_bent_draw(b, &n);
    if (squeeze) dmg_bent_key_draw(b, &n, &back, 0, "grip_safety", DMG_KEY_LAST);
    dmg_bent_stand(b, &n, 0.72f, 0.35f, 0);
    dmg_thumb_key_draw(b, 0, "release", 0.18f * half);
    dmg_restore(b);
    if (!magazine) return;
    dmg_vec line = v3_normalize(v3_sub(n.control[3], foot));
    dmg_slide(b, 0, "magazine", v3_scale(line, -1), 0.0f, down * dmg_range(b, 0.3f, 0.8f));
    dmg_beam(b, v3_mad(foot, line, -0.2f * half), foot, 1.5f * half, 1.9f * deep);
    dmg_beam(b, foot, v3_mad(foot, line, 0.8f * down), 0.9f * half, 1.3f * deep);
    dmg_use(b, 0);
}

void dmg_build_pistol_controller(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.14f, 0.28f), half = length * dmg_range(b, 0.07f, 0.1f),
          deep = half * dmg_range(b, 0.8f, 1.2f), lean = dmg_range(b, 0.15f, 0.45f),
          pull = half * dmg_range(b, 0.6f, 1.1f), reach = length * dmg_range(b, 0.13f, 0.19f), z = -0.08f * length,
          whole = dmg_range(b, -0.4f, 0.4f);
    bool hammer = dmg_chance(b, 0.5f), guard = dmg_chance(b, 0.8f), stick = !hammer && dmg_chance(b, 0.6f),
         safety = dmg_chance(b, 0.6f);
    dmg_move(b, 0, length, 0);
    dmg_turn(b, v3(1, 0, 0), whole);
    dmg_bent n =
        dmg_bent_between(v3(0, 0, -0.5f * length), v3(0, 0, 0.5f * length), v3(0, 0, 0), v3(-1, 0, 0), half, deep);
    n.power = dmg_range(b, 2.5f, 5.0f);
    n.wide[2] *= dmg_range(b, 0.6f, 1.1f);
    n.round[0] = dmg_range(b, 0.05f, 0.2f);
    n.round[1] = dmg_range(b, 0.03f, 0.2f);
    n.rows = 26;
    dmg_bent_open(&n, 0.43f, AHEAD + DMG_PI, 0.12f, 0.8f, 0.5f * deep);
    dmg_bent_draw(b, &n);
    dmg_save(b);
    dmg_move(b, 0, -0.85f * deep, z);
    dmg_finger_lever_draw(b, 0, "trigger", pull, reach);
    dmg_restore(b);
    if (guard) {
        const dmg_vec bow[] = {{0, -0.7f * deep, z + 1.2f * reach},
                               {0, -deep - 0.8f * reach, z + 1.1f * reach},
                               {0, -deep - 1.35f * reach, z + 0.5f * reach},
                               {0, -deep - 1.35f * reach, z - 0.4f * reach},
                               {0, -deep - 1.1f * reach, z - 1.4f * reach}};
        dmg_sweep(b, bow, 5, 0.06f * reach, 0.4f * half, false);
    }
    draw_gun_grip(b, length, half, lean);
    draw_gun_top(b, length, half, 0.9f * deep, hammer);
    if (stick) {
        dmg_aim(b, v3(0, 0.2f * deep, -0.49f * length), v3(0, 0.5f, -1), v3(0, 1, 0));
        dmg_hat_draw(b, 0, "thumb_stick", 0.7f * half);
        dmg_restore(b);
    }
    if (!safety) return;
    dmg_hinge(b, 0, "safety", v3(half, 0.2f * deep, -0.35f * length), v3(1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.2f));
    dmg_rod(b, v3(0.9f * half, 0.2f * deep, -0.35f * length), v3(1.2f * half, 0.2f * deep, -0.35f * length),
            0.25f * deep);
    dmg_box_span(b, v3(1.02f * half, 0.1f * deep, -0.35f * length), v3(1.2f * half, 0.35f * deep, -0.22f * length));
}
