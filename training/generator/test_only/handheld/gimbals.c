/* Draws model makers' transmitters: sticks in gimbals let into a smooth shell, trims, switches on its shoulders, an
 * aerial that folds, a screen that tilts; or a wheel and a trigger on a grip. The face looks to +Z. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

/* ---- what is let into the face ---- */

/* Draws a cradle on pins along X, the stick in it on pins along Y; both below the face, in a well `r` wide. */
static void draw_gimbal(dmg_builder* b, float r) {
    float swing = dmg_range(b, 0.3f, 0.5f), low = -r * dmg_range(b, 0.2f, 0.5f), ball = r * dmg_range(b, 0.4f, 0.6f),
          high = r * dmg_range(b, 0.9f, 1.8f), tip = r * dmg_range(b, 0.12f, 0.22f), rest = dmg_range(b, -1.0f, 1.0f);
    bool upright = dmg_chance(b, 0.5f), springless = dmg_chance(b, 0.4f), flat = dmg_chance(b, 0.4f);
    dmg_turn(b, v3(0, 0, 1), upright ? 0.5f * DMG_PI : 0.0f);
    uint32_t cradle = dmg_hinge(b, 0, "gimbal", v3(0, 0, low), v3(1, 0, 0), -swing, swing);
    if (springless) dmg_rest(b, cradle, swing * rest);
    for (int s = -1; s <= 1; s += 2) {
        dmg_rod(b, v3((float)s * ball, 0, low), v3((float)s * 0.92f * r, 0, low), 0.1f * r);
        dmg_beam(b, v3((float)s * ball * 1.05f, -0.25f * r, low), v3((float)s * ball * 1.05f, 0.25f * r, low),
                 0.12f * r, 0.4f * r);
    }
    dmg_torus(b, v3(0, 0, low + 0.15f * r), v3(0, 0, 1), 1.15f * ball, 0.1f * r);
    dmg_hinge(b, cradle, "stick", v3(0, 0, low), v3(0, 1, 0), -swing, swing);
    dmg_ellipsoid(b, v3(0, 0, low), v3(0.9f * ball, 0.9f * ball, 0.9f * ball));
    dmg_rod(b, v3(0, 0, low), v3(0, 0, high), 0.09f * r);
    if (flat)
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1),
                  (const dmg_xy[]){
                      {0.1f * r, high - tip}, {tip, high - 0.4f * tip}, {1.3f * tip, high}, {0, high - 0.2f * tip}},
                  4);
    else
        dmg_cone(b, v3(0, 0, high - 2 * tip), v3(0, 0, high), 0.6f * tip, tip);
    dmg_use(b, 0);
}

/* Draws a slider in a short slot, along X. */
static void draw_trim(dmg_builder* b, float size) {
    float way = 0.3f * size;
    dmg_save(b);
    dmg_move(b, 0, 0, 0.04f * size);
    dmg_frame_draw(b, size, 0.28f * size, 0.08f * size, 0.05f * size);
    dmg_restore(b);
    dmg_slide(b, 0, "trim", v3(1, 0, 0), -way, way);
    dmg_box_span(b, v3(-0.07f * size, -0.1f * size, -0.02f * size), v3(0.07f * size, 0.1f * size, 0.22f * size));
    dmg_use(b, 0);
}

/* Stands at an angle round the shell: +Y up its face, +X along it. */
static void stand(dmg_builder* b, const dmg_bent* n, float s, float angle, float out) {
    dmg_bent_stand(b, n, s, angle, out);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
}

/* Draws an aerial on a base that turns; it folds, its end is drawn out. */
static void draw_aerial(dmg_builder* b, float size) {
    float l = size * dmg_range(b, 0.5f, 1.4f), r = size * dmg_range(b, 0.02f, 0.05f), fold = dmg_range(b, 1.2f, 1.6f);
    bool turns = dmg_chance(b, 0.5f), drawn = dmg_chance(b, 0.4f);
    uint32_t base = 0;
    if (turns) base = dmg_spin(b, 0, "aerial_base", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, -r), v3(0, 0, 2 * r), 2 * r);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 1.5f * r, 0, 3 * r), v3(0.8f * r, 2 * r, 3 * r));
    uint32_t aerial = dmg_hinge(b, base, "aerial", v3(0, 0, 3.5f * r), v3(1, 0, 0), -fold, fold);
    float folded = fold * dmg_range(b, -1.0f, 1.0f);
    dmg_rest(b, aerial, dmg_chance(b, 0.6f) ? folded : 0.0f);
    dmg_capsule(b, v3(0, 0, 3.5f * r), v3(0, 0, l), r);
    if (drawn) {
        dmg_slide(b, aerial, "aerial_end", v3(0, 0, 1), 0.0f, 0.8f * l);
        dmg_rod(b, v3(0, 0, 0.2f * l), v3(0, 0, l + 2 * r), 0.45f * r);
        dmg_ellipsoid(b, v3(0, 0, l + 2 * r), v3(0.8f * r, 0.8f * r, 0.8f * r));
    }
    dmg_use(b, 0);
}

/* ---- the transmitter with two sticks ---- */

/* On the shoulders: switches to the front or up, dials, levers behind for the fingers. */
static void draw_shoulders(dmg_builder* b, const dmg_bent* n, float size) {
    int each = dmg_int(b, 1, 3), kind = dmg_int(b, 0, 3);
    float angle = dmg_range(b, 1.0f, 1.5f);
    for (int i = 0; i < 2 * each; ++i) {
        float off = 0.1f + 0.11f * (float)(i / 2), s = i % 2 ? 1 - off : off;
        if (i / 2 > 0) kind = dmg_int(b, 0, 3);
        stand(b, n, s, angle, 0);
        if (kind < 2) dmg_bat_draw(b, 0, "switch", 0.07f * size);
        if (kind == 2) dmg_sunk_wheel_draw(b, 0, "dial", 0.07f * size, 0.05f * size);
        if (kind == 3) dmg_thumb_key_draw(b, 0, "button", 0.035f * size);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f)) {
        for (int i = 0; i < 2; ++i) {
            float turn = dmg_range(b, 0.3f, 0.6f);
            stand(b, n, i ? 0.95f : 0.05f, DMG_PI - 0.3f, 0);
            dmg_hinge(b, 0, "side_slider", v3(0, 0, -0.02f * size), v3(1, 0, 0), -turn, turn);
            dmg_rounded_box(b, v3(0, 0, 0.03f * size), v3(0.05f * size, 0.04f * size, 0.09f * size), 0.01f * size);
            dmg_use(b, 0);
            dmg_restore(b);
        }
    }
}

static void draw_middle(dmg_builder* b, const dmg_bent* n, float size) {
    bool tilts = dmg_chance(b, 0.5f);
    float w = 0.26f * size, h = 0.18f * size, t = 0.03f * size, swing = dmg_range(b, 0.5f, 1.4f);
    int keys = dmg_int(b, 0, 4);
    stand(b, n, 0.5f, -0.12f, 0);
    if (tilts) dmg_hinge(b, 0, "screen", v3(0, 0.5f * h, 0), v3(-1, 0, 0), 0.0f, swing);
    dmg_rounded_box(b, v3(0, 0, 0.4f * t), v3(w, h, t), 0.3f * t);
    dmg_use(b, 0);
    for (int i = 0; i < keys; ++i) {
        dmg_save(b);
        dmg_move(b, w * (((float)i + 0.5f) / (float)keys - 0.5f), 0.75f * h, 0);
        dmg_thumb_key_draw(b, 0, "key", 0.08f * w);
        dmg_restore(b);
    }
    dmg_restore(b);
}

/* Draws a bail over the top, folded back about its ends. */
static void draw_bail(dmg_builder* b, float size, float high, float deep) {
    float w = 0.3f * size, t = 0.02f * size, rise = high * dmg_range(b, 0.2f, 0.4f);
    const dmg_vec path[] = {{-w, 0.4f * high, -deep - t},        {-w, high + 0.7f * rise, -deep - t},
                            {-0.8f * w, high + rise, -deep - t}, {0.8f * w, high + rise, -deep - t},
                            {w, high + 0.7f * rise, -deep - t},  {w, 0.4f * high, -deep - t}};
    dmg_hinge(b, 0, "bail", v3(0, 0.4f * high, -deep - t), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.5f));
    dmg_sweep(b, path, 6, t, t, false);
    dmg_use(b, 0);
}

static void draw_two_sticks(dmg_builder* b) {
    float size = dmg_range(b, 0.14f, 0.22f), high = size * dmg_range(b, 0.27f, 0.36f),
          deep = size * dmg_range(b, 0.13f, 0.2f), bow = size * dmg_range(b, -0.2f, 0.1f),
          at = dmg_range(b, 0.24f, 0.3f), lean = dmg_range(b, -0.9f, 0.1f);
    bool aerial = dmg_chance(b, 0.8f), bail = dmg_chance(b, 0.4f), horns = dmg_chance(b, 0.3f);
    dmg_move(b, 0, high, 0);
    dmg_turn(b, v3(1, 0, 0), lean);
    dmg_bent n =
        dmg_bent_between(v3(-0.5f * size, 0, 0), v3(0.5f * size, 0, 0), v3(0, bow, 0), v3(0, 0, 1), deep, high);
    n.deep[1] *= dmg_range(b, 0.8f, 1.1f);
    n.power = dmg_range(b, 3.0f, 5.0f);
    n.round[0] = n.round[1] = dmg_range(b, 0.08f, 0.25f);
    n.rows = 36;
    n.columns = 32;
    dmg_window w[2];
    float s[2], angle = 0;
    for (int i = 0; i < 2; ++i) {
        w[i] = dmg_bent_open(&n, i ? 1 - at : at, 0, 0.24f, 0.35f, 0.75f * deep);
        dmg_window_middle(&n, &w[i], &s[i], &angle);
    }
    dmg_bent_draw(b, &n);
    for (int i = 0; i < 2; ++i) {
        float r = 0.1f * size;
        stand(b, &n, s[i], angle, 0);
        draw_gimbal(b, r);
        dmg_restore(b);
        stand(b, &n, s[i], angle - 0.42f, 0);
        draw_trim(b, 1.5f * r);
        dmg_restore(b);
        stand(b, &n, i ? s[i] - 0.17f : s[i] + 0.17f, angle + 0.05f, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        draw_trim(b, 1.5f * r);
        dmg_restore(b);
        if (horns) {
            float x = (float)(2 * i - 1) * 0.42f * size;
            dmg_bent g = dmg_bent_between(v3(x, 0.2f * high, -0.4f * deep), v3(1.1f * x, -1.1f * high, -0.9f * deep),
                                          v3(0, 0, -0.3f * deep), v3(1, 0, 0), 0.55f * deep, 0.6f * deep);
            dmg_bent_draw(b, &g);
        }
    }
    draw_shoulders(b, &n, size);
    draw_middle(b, &n, size);
    if (bail) draw_bail(b, size, high, deep);
    if (aerial) {
        stand(b, &n, 0.5f, 0.5f * DMG_PI, 0);
        draw_aerial(b, size);
        dmg_restore(b);
    }
}

/* ---- the one with a wheel: a grip on a foot, a trigger that goes both ways ---- */

static void draw_wheel_and_trigger(dmg_builder* b) {
    float high = dmg_range(b, 0.14f, 0.2f), wide = high * dmg_range(b, 0.12f, 0.16f),
          foot = high * dmg_range(b, 0.35f, 0.55f), head = high * dmg_range(b, 0.3f, 0.42f),
          r = high * dmg_range(b, 0.16f, 0.24f), lean = high * dmg_range(b, -0.1f, 0.2f);
    bool aerial = dmg_chance(b, 0.7f), left = dmg_chance(b, 0.3f), screen = dmg_chance(b, 0.6f);
    if (left) dmg_mirror(b, v3(1, 0, 0));
    dmg_rounded_box(b, v3(0, 0.07f * high, 0), v3(1.1f * foot, 0.14f * high, 1.4f * foot), 0.05f * high);
    dmg_bent grip = dmg_bent_between(v3(0, 0.1f * high, 0), v3(0, high, lean), v3(0, 0, -0.05f * high), v3(1, 0, 0),
                                     wide, 1.2f * wide);
    grip.rows = 26;
    dmg_bent_open(&grip, 0.72f, 0.5f * DMG_PI, 0.25f, 0.9f, 0.5f * wide);
    dmg_bent_draw(b, &grip);
    dmg_bent top = dmg_bent_between(v3(0, high, lean - head), v3(0, high, lean + head), v3(0, 0.1f * head, 0),
                                    v3(-1, 0, 0), 1.4f * wide, 0.35f * head);
    top.power = dmg_range(b, 2.0f, 4.0f);
    dmg_bent_draw(b, &top);
    dmg_bent_stand(b, &grip, 0.74f, 0.5f * DMG_PI, 0);
    dmg_hinge(b, 0, "throttle", v3(0, 0.1f * high, -0.3f * wide), v3(1, 0, 0), -0.35f, 0.35f);
    dmg_bent lever = dmg_bent_between(v3(0, 0.1f * high, 0), v3(0, -0.12f * high, 0.9f * wide), v3(0, 0, 0.2f * wide),
                                      v3(-1, 0, 0), 0.4f * wide, 0.14f * wide);
    lever.rows = lever.columns = 12;
    dmg_bent_draw(b, &lever);
    if (dmg_chance(b, 0.6f)) { /* the finger's other side: a loop */
        dmg_torus(b, v3(0, -0.02f * high, 0.9f * wide), v3(1, 0, 0), 0.07f * high, 0.1f * wide);
        dmg_rod(b, v3(0, 0, 0.2f * wide), v3(0, 0, 0.5f * wide), 0.2f * wide);
    }
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_aim(b, v3(1.2f * wide, high, lean + 0.3f * head), v3(1, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0, -0.5f * wide), v3(0, 0, 0.8f * wide), 0.3f * r);
    dmg_hinge(b, 0, "steering", v3(0, 0, 0), v3(0, 0, 1), -0.7f, 0.7f);
    float width = r * dmg_range(b, 0.5f, 1.0f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 3, 7);
    dmg_move(b, 0, 0, 0.85f * wide + 0.5f * width);
    dmg_wheel_draw(b, kind, r, width, spokes);
    dmg_use(b, 0);
    dmg_restore(b);
    dmg_bent_stand(b, &top, 0.25f, 0.5f * DMG_PI, 0);
    if (screen) {
        dmg_hinge(b, 0, "screen", v3(0, 0.3f * head, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.3f));
        dmg_rounded_box(b, v3(0, 0, 0.04f * head), v3(2 * wide, 0.6f * head, 0.12f * head), 0.03f * head);
        dmg_use(b, 0);
    }
    dmg_restore(b);
    dmg_bent_stand(b, &top, 0.7f, 0.5f * DMG_PI, 0);
    if (aerial) draw_aerial(b, high);
    dmg_restore(b);
    dmg_bent_stand(b, &top, 0.35f, DMG_PI, 0);
    draw_trim(b, 0.3f * head);
    dmg_restore(b);
}

void dmg_build_stick_box(dmg_builder* b) {
    if (dmg_chance(b, 0.7f))
        draw_two_sticks(b);
    else
        draw_wheel_and_trigger(b);
}
