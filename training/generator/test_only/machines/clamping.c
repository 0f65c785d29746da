/* Draws clamps that close by screws, jaws, toggles and springs. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- clamps, drawn upright in x, y; the work lies between their jaws ---- */

/* Draws a spindle along Y through `nut`, its pad at the height `low`; out of the work as it turns positive. The head of
 * the spindle carries a bar that slides through it, wings, a turned grip, or a knob. */
static void draw_spindle(dmg_builder* b, uint32_t parent, dmg_vec nut, float low, float way, float r) {
    float head = nut.y + way * dmg_range(b, 0.08f, 0.3f) + 3 * r, bar = r * dmg_range(b, 4.0f, 8.0f),
          turns = dmg_range(b, 15.0f, 38.0f);
    int kind = dmg_int(b, 0, 3);
    bool pad = dmg_chance(b, 0.6f), loose = dmg_chance(b, 0.5f);
    float rest = turns * dmg_unit(b);
    uint32_t spindle = dmg_screw(b, parent, "screw", nut, v3(0, 1, 0), way / turns, 0.0f, turns);
    dmg_rest(b, spindle, rest);
    dmg_rod(b, v3(nut.x, low + r, nut.z), v3(nut.x, head, nut.z), 0.7f * r);
    if (kind == 0) {
        dmg_rod(b, v3(nut.x, head, nut.z), v3(nut.x, head + 2 * r, nut.z), 1.1f * r);
        float at = loose ? 0.5f * bar : 0.0f;
        if (loose) dmg_slide(b, spindle, "bar", v3(1, 0, 0), 0.0f, 0.9f * bar);
        dmg_vec from = v3(nut.x - at - 0.6f * bar, head + r, nut.z), to = v3(nut.x - at + 0.6f * bar, head + r, nut.z);
        dmg_rod(b, from, to, 0.35f * r);
        dmg_ellipsoid(b, from, v3(0.6f * r, 0.6f * r, 0.6f * r));
        dmg_ellipsoid(b, to, v3(0.6f * r, 0.6f * r, 0.6f * r));
    }
    if (kind == 1) dmg_rounded_box(b, v3(nut.x, head + r, nut.z), v3(6 * r, 2.4f * r, 0.8f * r), 0.3f * r);
    if (kind == 2) {
        const dmg_xy grip[] = {{0, 0},       {1.2f * r, 0}, {1.8f * r, 3 * r}, {1.5f * r, 7 * r}, {1.8f * r, 9 * r},
                               {0, 9.5f * r}};
        dmg_lathe(b, v3(nut.x, head, nut.z), v3(0, 1, 0), grip, 6);
    }
    dmg_save(b);
    dmg_move(b, nut.x, head, nut.z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (kind == 3) dmg_knob_draw(b, 4, 3 * r, 2.5f * r);
    dmg_restore(b);
    if (pad) dmg_spin(b, spindle, "pad", v3(nut.x, low, nut.z), v3(0, 1, 0));
    if (!pad) dmg_use(b, spindle);
    dmg_cone(b, v3(nut.x, low, nut.z), v3(nut.x, low + 1.3f * r, nut.z), 1.8f * r, 1.1f * r);
    dmg_use(b, parent);
}

static void draw_g_clamp(dmg_builder* b, float gap) {
    float t = gap * dmg_range(b, 0.12f, 0.22f), throat = gap * dmg_range(b, 0.35f, 0.8f),
          deep = t * dmg_range(b, 0.4f, 0.9f), bow = dmg_range(b, 0.0f, 0.25f) * gap, r = t * dmg_range(b, 0.3f, 0.45f),
          arm = 0.6f * t;
    const dmg_xy frame[] = {{throat + 0.7f * t, 0},
                            {throat + 0.7f * t, arm},
                            {0, t},
                            {-bow * 0.3f, t + 0.5f * gap},
                            {0, t + gap},
                            {throat + 0.7f * t, t + gap},
                            {throat + 0.7f * t, t + gap + arm},
                            {-0.6f * t, 2 * t + gap},
                            {-t - bow, t + 0.5f * gap},
                            {-0.6f * t, 0}};
    dmg_extrude(b, frame, 10, -0.5f * deep, 0.5f * deep);
    dmg_rod(b, v3(throat, arm * 0.7f, 0), v3(throat, t, 0), 1.5f * r);
    dmg_rod(b, v3(throat, t + 0.9f * gap, 0), v3(throat, t + gap + 1.5f * arm, 0), 1.7f * r);
    draw_spindle(b, 0, v3(throat, t + gap + 1.5f * arm, 0), t + 0.03f * gap, 0.8f * gap, r);
}

/* Draws a bar with one jaw fixed and one that slides; the latter closes by its screw or by a trigger that steps it on.
 */
static void draw_bar_clamp(dmg_builder* b, float span) {
    float t = span * dmg_range(b, 0.03f, 0.06f), reach = span * dmg_range(b, 0.15f, 0.35f), z = 0.5f * t,
          low = span * dmg_range(b, 0.25f, 0.6f), r = 0.35f * t, rest = dmg_unit(b);
    bool trigger = dmg_chance(b, 0.35f);
    dmg_box_span(b, v3(-t, 0, -0.3f * z), v3(t * 0.5f, span, 0.3f * z));
    dmg_beam(b, v3(-0.5f * t, 0.7f * t, 0), v3(reach, 0.4f * t, 0), 2 * z, 1.4f * t);
    dmg_rod(b, v3(reach - t, t, 0), v3(reach - t, 1.5f * t, 0), 0.9f * t);
    float up = span - low - 3.2f * t - (trigger ? 2 * t : 0.0f), down = low - 2.5f * t - (trigger ? 0 : 4 * t);
    uint32_t jaw = dmg_slide(b, 0, "jaw", v3(0, 1, 0), -fmaxf(down, 0.0f), up);
    dmg_rest(b, jaw, up * rest);
    dmg_box_span(b, v3(-1.6f * t, low, -z), v3(1.1f * t, low + 3 * t, z));
    dmg_beam(b, v3(0, low + 1.6f * t, 0), v3(reach, low + 1.0f * t, 0), 2 * z, 1.6f * t);
    if (!trigger) {
        draw_spindle(b, jaw, v3(reach - t, low + 1.8f * t, 0), low - 4 * t, 3.5f * t, r);
        return;
    }
    dmg_rod(b, v3(reach - t, low - 0.5f * t, 0), v3(reach - t, low + 0.8f * t, 0), 0.9f * t);
    dmg_beam(b, v3(-1.5f * t, low + 2 * t, 0), v3(-6 * t, low + 5 * t, 0), 1.6f * z, 1.6f * t);
    dmg_hinge(b, jaw, "trigger", v3(-1.6f * t, low + 0.4f * t, 0), v3(0, 0, -1), 0.0f, 0.45f);
    dmg_beam(b, v3(-1.6f * t, low + 0.4f * t, 0), v3(-5.5f * t, low + 1.2f * t, 0), 1.2f * z, t);
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, jaw, "release", v3(1.1f * t, low + 2.6f * t, 0), v3(0, 0, 1), 0.0f, 0.5f);
        dmg_beam(b, v3(1.1f * t, low + 2.7f * t, 0), v3(2.6f * t, low + 3.0f * t, 0), z, 0.5f * t);
    }
    dmg_use(b, 0);
}

/* Draws a long bar on feet: the head's screw pushes a shoe along it, the tail is pinned or bites where it is set. */
static void draw_sash_clamp(dmg_builder* b, float span) {
    float t = span * dmg_range(b, 0.012f, 0.025f), tall = t * dmg_range(b, 2.5f, 4.0f), y = 2 * t, x = 0.5f * span,
          r = 0.5f * t, way = 0.12f * span;
    bool pipe = dmg_chance(b, 0.4f), pin = dmg_chance(b, 0.6f) && !pipe;
    if (pipe) dmg_rod(b, v3(-x, y, 0), v3(x, y, 0), 0.8f * t);
    if (!pipe) dmg_box_span(b, v3(-x, y - t, -0.4f * t), v3(x, y + t, 0.4f * t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.85f * x - t, 0, -2 * t), v3((float)s * 0.85f * x + t, y - 0.9f * t, 2 * t));
    dmg_box_span(b, v3(x - 2 * t, y + 0.5f * t, -t), v3(x, y + tall, t));
    dmg_save(b); /* the screw lies along the bar: Y of the spindle runs along +X */
    dmg_move(b, x, y + 0.7f * tall, 0);
    dmg_turn(b, v3(0, 0, 1), -0.5f * DMG_PI);
    draw_spindle(b, 0, v3(0, 0, 0), -0.1f * span - way, way, r);
    dmg_restore(b);
    float at = -x * dmg_range(b, 0.2f, 0.8f);
    uint32_t tail = dmg_slide(b, 0, "tail", v3(-1, 0, 0), at * 0.8f, x + at - 3 * t);
    dmg_box_span(b, v3(at - 3 * t, y - 1.4f * t, -1.2f * t), v3(at, y + 1.3f * t, 1.2f * t));
    dmg_box_span(b, v3(at - 2 * t, y + 1.2f * t, -t), v3(at, y + tall, t));
    if (pin) {
        dmg_slide(b, tail, "pin", v3(0, 0, 1), 0.0f, 3 * t);
        dmg_rod(b, v3(at - 1.5f * t, y, -1.6f * t), v3(at - 1.5f * t, y, 2 * t), 0.35f * t);
        dmg_torus(b, v3(at - 1.5f * t, y - 0.5f * t, 2 * t), v3(1, 0, 0), 0.7f * t, 0.12f * t);
    } else if (pipe) {
        dmg_hinge(b, tail, "lever", v3(at - 3 * t, y + 1.3f * t, 0), v3(0, 0, -1), 0.0f, 0.5f);
        dmg_beam(b, v3(at - 3 * t, y + 1.3f * t, 0), v3(at - 6 * t, y + 2.2f * t, 0), 1.5f * t, 0.5f * t);
    }
    dmg_use(b, 0);
}

/* Over its dead centre: a handle and an arm on one base, or a plunger pushed by the handle. */
static void draw_toggle_clamp(dmg_builder* b, float size) {
    float t = 0.05f * size, half = size * dmg_range(b, 0.1f, 0.16f), pin = size * dmg_range(b, 0.2f, 0.3f),
          arm = size * dmg_range(b, 0.5f, 0.8f), grip = size * dmg_range(b, 0.7f, 1.0f),
          lift = dmg_range(b, 1.0f, 1.6f);
    bool plunger = dmg_chance(b, 0.35f), upright = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-0.45f * size, 0, -2 * half), v3(0.3f * size, t, 2 * half));
    for (int s = -1; s <= 1; s += 2) {
        const dmg_xy cheek[] = {
            {-0.4f * size, t}, {0.25f * size, t}, {0.2f * size, pin + 2 * t}, {-0.3f * size, pin + 2 * t}};
        dmg_extrude(b, cheek, 4, (float)s * half - 0.4f * t, (float)s * half + 0.4f * t);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(0.25f * size * (float)k, t, 1.6f * half * (float)s),
                    v3(0.25f * size * (float)k, 1.3f * t, 1.6f * half * (float)s), 0.6f * t);
    }
    float inner = 0.6f * half;
    if (plunger) {
        dmg_box_span(b, v3(0.15f * size, t, -half), v3(0.3f * size, pin + t, half));
        dmg_slide(b, 0, "plunger", v3(1, 0, 0), 0.0f, 0.3f * size);
        dmg_rod(b, v3(-0.2f * size, pin, 0), v3(0.45f * size, pin, 0), 0.8f * t);
        dmg_rod(b, v3(0.45f * size, pin, 0), v3(0.5f * size, pin, 0), 1.4f * t);
    } else {
        dmg_vec end = v3(arm, pin, 0);
        uint32_t bar = dmg_hinge(b, 0, "arm", v3(0.1f * size, pin, 0), v3(0, 0, 1), 0.0f, lift);
        dmg_rod(b, v3(0.1f * size, pin, -1.3f * half), v3(0.1f * size, pin, 1.3f * half), 0.7f * t);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3(0, pin, (float)s * inner), v3_add(end, v3(0, 0, (float)s * inner)), 0.5f * t, 2 * t);
        if (dmg_chance(b, 0.5f))
            draw_spindle(b, bar, v3(arm - t, pin + t, 0), 0.1f * pin, 0.5f * pin, 0.6f * t);
        else
            dmg_rod(b, v3(arm - t, 0.1f * pin, 0), v3(arm - t, pin + 2 * t, 0), 0.9f * t);
    }
    dmg_vec at = v3(-0.2f * size, pin + t, 0);
    dmg_vec end = upright ? v3(at.x - 0.1f * size, at.y + grip, 0) : v3(at.x - grip, at.y + 0.25f * grip, 0);
    dmg_hinge(b, 0, "handle", at, v3(0, 0, upright ? 1.0f : -1.0f), 0.0f, upright ? 1.1f : 1.7f);
    dmg_rod(b, v3_add(at, v3(0, 0, -1.3f * half)), v3_add(at, v3(0, 0, 1.3f * half)), 0.7f * t);
    dmg_beam(b, at, v3_lerp(at, end, 0.6f), inner, 2 * t);
    dmg_capsule(b, v3_lerp(at, end, 0.5f), end, 1.6f * t);
    dmg_use(b, 0);
}

/* Draws two jaws on one pin with a spring round it, pads on their tips. */
static void draw_spring_clamp(dmg_builder* b, float size) {
    float t = size * dmg_range(b, 0.05f, 0.09f), wide = size * dmg_range(b, 0.12f, 0.25f),
          open = dmg_range(b, 0.3f, 0.7f), tip = size * dmg_range(b, 0.35f, 0.55f);
    bool pads = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0.5f * wide, 0);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* it lies on its side */
    uint32_t jaw = 0;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, own = s > 0 ? 0.8f * wide : wide;
        if (s > 0) jaw = dmg_hinge(b, 0, "jaw", v3(0, 0, 0), v3(0, 0, 1), 0.0f, open);
        const dmg_xy arm[] = {{-0.6f * size, 0.42f * size * side},
                              {-0.3f * size, 0.24f * size * side},
                              {0, 1.6f * t * side},
                              {0.5f * tip, 2.6f * t * side},
                              {tip, 0.8f * t * side}};
        dmg_bent_plate(b, arm, 5, t, own);
        for (int k = -1; k <= 1; k += 2)
            dmg_box(b, v3(0, 0.8f * t * side, 0.5f * (s > 0 ? 0.72f : 0.94f) * wide * (float)k),
                    v3(2.5f * t, 2.4f * t, 0.06f * wide));
        if (pads) {
            dmg_hinge(b, s > 0 ? jaw : 0, "pad", v3(tip, 0.8f * t * side, 0), v3(0, 0, side), -0.3f, 0.3f);
            dmg_rounded_box(b, v3(tip, 0.45f * t * side, 0), v3(0.18f * size, 0.8f * t, 0.9f * wide), 0.1f * t);
        } else
            dmg_rounded_box(b, v3(tip, 0.5f * t * side, 0), v3(2 * t, 0.9f * t, 0.9f * own), 0.1f * t);
        dmg_use(b, 0);
    }
    dmg_rod(b, v3(0, 0, -0.52f * wide), v3(0, 0, 0.52f * wide), 0.5f * t);
}

void dmg_build_clamp(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.06f, 0.3f);
    int kind = dmg_int(b, 0, 4);
    if (kind < 2 && dmg_chance(b, 0.5f)) { /* lying down */
        dmg_move(b, 0, 0.1f * size, 0);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    }
    switch (kind) {
    case 0:
        draw_g_clamp(b, size);
        break;
    case 1:
        draw_bar_clamp(b, 2.5f * size);
        break;
    case 2:
        draw_sash_clamp(b, 5 * size);
        break;
    case 3:
        draw_toggle_clamp(b, size);
        break;
    default:
        draw_spring_clamp(b, size);
        break;
    }
}
