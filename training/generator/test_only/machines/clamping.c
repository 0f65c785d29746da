/* Draws clamps that close by screws, jaws, toggles and springs, and measuring tools: calipers, micrometers, dials on
 * stands, height gauges, bevels. */
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

/* ---- measuring ---- */

/* Draws a knurled screw out of z = 0. */
static void draw_lock_screw(dmg_builder* b, uint32_t parent, dmg_vec at, float r) {
    dmg_spin(b, parent, "lock_screw", at, v3(0, 0, 1));
    dmg_rod(b, at, v3_add(at, v3(0, 0, r)), 0.4f * r);
    dmg_rod(b, v3_add(at, v3(0, 0, r)), v3_add(at, v3(0, 0, 2.2f * r)), r);
    dmg_use(b, parent);
}

/* Beam along X, jaws down; the slider carries jaw, display or dial, depth rod, thumb wheel. */
static void draw_caliper(dmg_builder* b, float span) {
    float high = span * dmg_range(b, 0.06f, 0.09f), jaw = span * dmg_range(b, 0.16f, 0.28f), t = 0.25f * high,
          w = jaw * dmg_range(b, 0.25f, 0.4f), body = span * dmg_range(b, 0.22f, 0.32f), way = 0.9f * (span - body);
    int face = dmg_int(b, 0, 2);
    bool nibs = dmg_chance(b, 0.7f);
    dmg_box_span(b, v3(-w, 0, -0.5f * t), v3(span, high, 0.5f * t));
    const dmg_xy fixed[] = {{-w, 0}, {-0.2f * w, -jaw}, {-0.005f * span, -jaw}, {-0.005f * span, 0}},
                 moving[] = {{w, 0}, {0.005f * span, 0}, {0.005f * span, -jaw}, {0.2f * w, -jaw}};
    dmg_extrude(b, fixed, 4, -0.5f * t, 0.5f * t);
    const dmg_xy ear[] = {
        {0.05f * w, high}, {-0.9f * w, high}, {-0.1f * w, high + 0.45f * jaw}, {0.05f * w, high + 0.45f * jaw}};
    if (nibs) dmg_extrude(b, ear, 4, -0.5f * t, -0.05f * t);
    uint32_t slider = dmg_slide(b, 0, "jaw", v3(1, 0, 0), 0.0f, way);
    dmg_rest(b, slider, dmg_chance(b, 0.3f) ? 0.0f : way * dmg_unit(b));
    dmg_extrude(b, moving, 4, -0.5f * t, 0.5f * t);
    const dmg_xy ear2[] = {
        {0.9f * w, high}, {-0.05f * w, high}, {-0.05f * w, high + 0.45f * jaw}, {0.1f * w, high + 0.45f * jaw}};
    if (nibs) dmg_extrude(b, ear2, 4, 0.05f * t, 0.5f * t);
    dmg_box_span(b, v3(0.01f * span, -0.25f * high, -t), v3(body, 1.2f * high, -0.55f * t));
    dmg_box_span(b, v3(0.01f * span, -0.25f * high, 0.55f * t), v3(body, 1.2f * high, t));
    dmg_box_span(b, v3(0.01f * span, 1.02f * high, -t), v3(body, 1.2f * high, t));
    if (face == 1)
        dmg_rounded_box(b, v3(0.5f * body, 0.5f * high, 1.4f * t), v3(0.9f * body, 1.7f * high, t), 0.1f * t);
    if (face == 2) { /* a needle under a bezel that turns */
        float r = 0.36f * body;
        dmg_rod(b, v3(0.5f * body, 0.5f * high, t), v3(0.5f * body, 0.5f * high, 2 * t), r);
        dmg_spin(b, slider, "needle", v3(0.5f * body, 0.5f * high, 0), v3(0, 0, -1));
        dmg_box(b, v3(0.5f * body, 0.5f * high + 0.35f * r, 2.15f * t), v3(0.08f * r, 0.9f * r, 0.15f * t));
        dmg_spin(b, slider, "bezel", v3(0.5f * body, 0.5f * high, 0), v3(0, 0, 1));
        dmg_torus(b, v3(0.5f * body, 0.5f * high, 2 * t), v3(0, 0, 1), 1.02f * r, 0.09f * r);
        dmg_box(b, v3(0.5f * body, 0.5f * high + 1.1f * r, 2 * t), v3(0.2f * r, 0.1f * r, 0.5f * t));
    }
    if (dmg_chance(b, 0.6f)) {
        dmg_spin(b, slider, "thumb_wheel", v3(0.8f * body, -0.35f * high, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0.8f * body, -0.35f * high, -0.9f * t), v3(0.8f * body, -0.35f * high, 0.9f * t), 0.22f * high);
    }
    if (dmg_chance(b, 0.6f)) {
        dmg_save(b);
        dmg_move(b, 0.35f * body, 1.2f * high, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        draw_lock_screw(b, slider, v3(0, 0, 0), 0.25f * high);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a bow with an anvil; thimble and spindle screw out of the sleeve, the ratchet turns at their end. */
static void draw_micrometer(dmg_builder* b, float gap) {
    float r = gap * dmg_range(b, 0.5f, 0.7f), t = 0.35f * r, s = 0.09f * r + 0.0015f, way = gap * 0.9f,
          sleeve = way + 5 * s, turns = 38.0f;
    enum { STEPS = 9 };
    dmg_xy line[STEPS];
    for (int i = 0; i < STEPS; ++i) {
        float angle = DMG_PI * (1.0f + (float)i / (STEPS - 1));
        line[i] = (dmg_xy){(0.5f * gap + 3 * s) * cosf(angle), 1.4f * r * sinf(angle)};
    }
    dmg_bent_plate(b, line, STEPS, t, 0.3f * t);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, -1.35f * r, 0), v3(0.8f * gap, 0.9f * t, 0.45f * t)); /* the insulating plate */
    float x = 0.5f * gap;
    dmg_rod(b, v3(-x - 4 * s, 0, 0), v3(-x, 0, 0), s);
    dmg_rod(b, v3(x + 1.5f * s, 0, 0), v3(x + 4 * s, 0, 0), 2.2f * s);
    dmg_rod(b, v3(x + 3 * s, 0, 0), v3(x + 3 * s + sleeve, 0, 0), 1.6f * s);
    uint32_t thimble = dmg_screw(b, 0, "thimble", v3(0, 0, 0), v3(1, 0, 0), way / turns, 0.0f, turns);
    dmg_rest(b, thimble, turns * dmg_unit(b));
    dmg_rod(b, v3(-x + 0.02f * gap, 0, 0), v3(x + 2 * s, 0, 0), 0.9f * s);
    const dmg_xy cup[] = {{1.65f * s, 5 * s}, {2.3f * s, 6 * s}, {2.3f * s, sleeve + 6 * s}, {0, sleeve + 6 * s}};
    dmg_lathe(b, v3(x, 0, 0), v3(1, 0, 0), cup, 4);
    float end = x + sleeve + 6 * s;
    if (dmg_chance(b, 0.7f)) dmg_spin(b, thimble, "ratchet", v3(0, 0, 0), v3(1, 0, 0));
    dmg_rod(b, v3(end, 0, 0), v3(end + 4 * s, 0, 0), 1.3f * s);
    if (dmg_chance(b, 0.6f)) {
        dmg_vec at = v3(x + 2.8f * s, -0.2f * s, 2.1f * s);
        dmg_hinge(b, 0, "lock_lever", at, v3(0, 0, 1), 0.0f, 0.9f);
        dmg_rod(b, at, v3(at.x, at.y, at.z + s), 0.9f * s);
        dmg_beam(b, v3(at.x, at.y, at.z + 0.6f * s), v3(at.x - s, at.y + 2.8f * s, at.z + 0.6f * s), 0.6f * s,
                 0.9f * s);
    }
    dmg_use(b, 0);
}

/* Case, stem and plunger about Y through the origin, the face to +Z. */
static void draw_dial(dmg_builder* b, uint32_t parent, float r) {
    float t = r * dmg_range(b, 0.3f, 0.55f), stem = r * dmg_range(b, 0.4f, 0.8f), way = r * dmg_range(b, 0.2f, 0.5f);
    dmg_rod(b, v3(0, 0, -0.5f * t), v3(0, 0, 0.5f * t), r);
    dmg_rod(b, v3(0, -0.9f * r, 0), v3(0, -r - stem, 0), 0.16f * r);
    dmg_spin(b, parent, "needle", v3(0, 0, 0), v3(0, 0, -1));
    dmg_box(b, v3(0, 0.25f * r, 0.54f * t), v3(0.06f * r, 0.9f * r, 0.06f * t));
    dmg_rod(b, v3(0, 0, 0.51f * t), v3(0, 0, 0.62f * t), 0.08f * r);
    if (dmg_chance(b, 0.6f)) {
        dmg_spin(b, parent, "bezel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_torus(b, v3(0, 0, 0.5f * t), v3(0, 0, 1), 1.0f * r, 0.1f * r);
        dmg_box(b, v3(0, 1.08f * r, 0.5f * t), v3(0.15f * r, 0.08f * r, 0.2f * t));
    }
    dmg_slide(b, parent, "plunger", v3(0, 1, 0), 0.0f, way);
    dmg_rod(b, v3(0, -r - stem - way - 0.1f * r, 0), v3(0, -r - 0.9f * stem, 0), 0.07f * r);
    dmg_ellipsoid(b, v3(0, -r - stem - way - 0.1f * r, 0), v3(0.1f * r, 0.1f * r, 0.1f * r));
    dmg_use(b, parent);
}

/* Draws a dial on a magnetic foot: post, arms that turn on it and on each other, the foot's switch. */
static void draw_dial_stand(dmg_builder* b, float tall) {
    float foot = tall * dmg_range(b, 0.16f, 0.22f), r = tall * dmg_range(b, 0.09f, 0.14f), rod = 0.02f * tall,
          y = tall * dmg_range(b, 0.6f, 0.85f), reach = tall * dmg_range(b, 0.25f, 0.45f),
          turn = dmg_range(b, 0.8f, 1.5f);
    bool slides = dmg_chance(b, 0.5f), ball = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-0.45f * foot, 0, -0.5f * foot), v3(0.45f * foot, 0.9f * foot, 0.5f * foot));
    dmg_rod(b, v3(0, 0.9f * foot, 0), v3(0, tall, 0), rod);
    dmg_hinge(b, 0, "switch", v3(0, 0.4f * foot, 0), v3(0, 0, 1), 0.0f, 1.57f);
    dmg_rod(b, v3(0, 0.4f * foot, 0.5f * foot), v3(0, 0.4f * foot, 0.6f * foot), 0.25f * foot);
    dmg_box(b, v3(0, 0.4f * foot, 0.64f * foot), v3(0.1f * foot, 0.45f * foot, 0.1f * foot));
    dmg_use(b, 0);
    uint32_t arm = slides ? dmg_slide(b, 0, "clamp", v3(0, 1, 0), -0.4f * y + foot * 0.5f, 0.9f * tall - y)
                          : dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -turn, turn);
    dmg_box(b, v3(0, y, 0), v3(4 * rod, 3.5f * rod, 4 * rod));
    draw_lock_screw(b, arm, v3(0, y, 2 * rod), rod);
    if (ball) {
        arm = dmg_hinge(b, arm, "arm", v3(0, y, 0), v3(0, 0, 1), -0.6f, 0.6f);
        dmg_rod(b, v3(0, y, -3 * rod), v3(0, y, -2.05f * rod), 1.5f * rod);
    }
    float z = ball ? -2.6f * rod : 0.0f, x = ball ? 0.0f : 2 * rod;
    dmg_rod(b, v3(x, y, z), v3(reach, y, z), 0.7f * rod);
    arm = dmg_hinge(b, arm, "holder", v3(reach, y, z), v3(0, 0, dmg_sign(b)), -0.9f, 0.9f);
    dmg_rod(b, v3(reach, y, z - 1.5f * rod), v3(reach, y, z + 2.2f * rod), 1.5f * rod);
    dmg_save(b);
    dmg_move(b, reach, y - 1.3f * r, z + 2.2f * rod);
    dmg_box_span(b, v3(-0.7f * rod, 0, -rod), v3(0.7f * rod, 1.3f * r, rod));
    draw_dial(b, arm, r);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a column on a lapped foot, the slider with its scriber, a fine adjustment above. */
static void draw_height_gauge(dmg_builder* b, float tall) {
    float foot = tall * dmg_range(b, 0.1f, 0.15f), w = tall * dmg_range(b, 0.025f, 0.045f), low = foot + 0.02f * tall,
          t = 0.5f * w, body = tall * 0.16f;
    bool twin = dmg_chance(b, 0.3f), fine = dmg_chance(b, 0.6f), dial = dmg_chance(b, 0.4f);
    float up = tall - low - body * (fine ? 1.8f : 1.05f);
    dmg_box_span(b, v3(-1.5f * foot, 0, -foot), v3(foot, foot, foot));
    for (int s = twin ? -1 : 1; s <= 1; s += 2) {
        float x = twin ? (float)s * 1.2f * w : 0.0f;
        if (twin) dmg_rod(b, v3(x, foot, 0), v3(x, tall, 0), 0.4f * w);
        if (!twin) dmg_box_span(b, v3(-w, foot, -t), v3(w, tall, t));
    }
    if (twin) dmg_box_span(b, v3(-2 * w, tall, -w), v3(2 * w, tall + w, w));
    uint32_t slider = dmg_slide(b, 0, "slider", v3(0, 1, 0), 0.0f, up);
    dmg_rest(b, slider, up * dmg_unit(b));
    dmg_box_span(b, v3(-2 * w, low, t), v3(2 * w, low + body, 2.5f * t));
    dmg_box_span(b, v3(1.4f * w * (twin ? 1.3f : 1.0f), low, -2 * t), v3(2 * w, low + body, t));
    dmg_box_span(b, v3(1.6f * w, low, -t), v3(1.6f * w + 3 * foot * 0.6f, low + 0.2f * body, t));
    dmg_box_span(b, v3(2.5f * w, low + 0.2f * body, -1.2f * t), v3(3.5f * w, low + 0.4f * body, 1.2f * t));
    if (dial) {
        dmg_save(b);
        dmg_move(b, 0, low + 0.6f * body, 2.5f * t + 0.2f * body);
        dmg_rod(b, v3(0, 0, -0.2f * body), v3(0, 0, 0), 0.42f * body);
        dmg_spin(b, slider, "needle", v3(0, 0, 0), v3(0, 0, -1));
        dmg_box(b, v3(0, 0.15f * body, 0.01f * body), v3(0.03f * body, 0.4f * body, 0.015f * body));
        dmg_restore(b);
    }
    draw_lock_screw(b, slider, v3(-1.2f * w, low + 0.1f * body, 2.5f * t), 0.5f * w);
    if (fine) {
        dmg_use(b, slider);
        dmg_box_span(b, v3(-2 * w, low + 1.4f * body, t), v3(2 * w, low + 1.75f * body, 2.5f * t));
        dmg_rod(b, v3(1.5f * w, low + body, 1.7f * t), v3(1.5f * w, low + 1.4f * body, 1.7f * t), 0.25f * w);
        dmg_spin(b, slider, "fine_wheel", v3(1.5f * w, 0, 1.7f * t), v3(0, 1, 0));
        dmg_rod(b, v3(1.5f * w, low + 1.1f * body, 1.7f * t), v3(1.5f * w, low + 1.3f * body, 1.7f * t), 0.9f * w);
    }
    dmg_use(b, 0);
}

/* Stock and blade on one pin, or a rule in a slotted head with a protractor that turns. */
static void draw_bevel(dmg_builder* b, float span) {
    float w = span * dmg_range(b, 0.08f, 0.13f), t = 0.03f * span, blade = span * dmg_range(b, 0.8f, 1.4f),
          stock = span * dmg_range(b, 0.5f, 0.8f), angle = dmg_range(b, 0.0f, 1.2f);
    bool disc = dmg_chance(b, 0.5f);
    uint32_t head = 0;
    if (disc) { /* round body on a straight foot */
        dmg_box_span(b, v3(-stock, -2.2f * w, -t), v3(stock, -1.6f * w, t));
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0.2f * t), 1.9f * w);
        head = dmg_hinge(b, 0, "turret", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -0.8f, 0.8f);
        dmg_rod(b, v3(0, 0, 0.21f * t), v3(0, 0, 0.9f * t), 1.5f * w);
        uint32_t rule = dmg_slide(b, head, "rule", v3(1, 0, 0), -0.3f * blade, 0.3f * blade);
        dmg_rest(b, rule, 0.2f * blade * (dmg_unit(b) - 0.5f));
        dmg_box_span(b, v3(-0.6f * blade, -0.3f * w, 0.92f * t), v3(0.6f * blade, 0.3f * w, 1.15f * t));
        draw_lock_screw(b, head, v3(0, 0.8f * w, 0.9f * t), 0.35f * w);
        dmg_use(b, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-stock, -0.5f * w, (float)s * 0.8f * t - 0.6f * t),
                     v3(0.5f * w, 0.5f * w, (float)s * 0.8f * t + 0.6f * t));
    dmg_box_span(b, v3(-stock, -0.5f * w, -0.3f * t), v3(-0.9f * stock, 0.5f * w, 0.3f * t));
    head = dmg_hinge(b, 0, "blade", v3(0, 0, 0), v3(0, 0, 1), 0.0f, 3.0f);
    dmg_rest(b, head, angle);
    const dmg_xy outline[] = {{-0.85f * fminf(blade, stock), -0.4f * w},
                              {0.3f * w, -0.4f * w},
                              {0.4f * w, 0.4f * w},
                              {-0.7f * fminf(blade, stock), 0.4f * w}};
    dmg_extrude(b, outline, 4, -0.15f * t, 0.15f * t);
    draw_lock_screw(b, 0, v3(0, 0, 1.4f * t), 0.3f * w);
    dmg_use(b, 0);
}

void dmg_build_measuring_tool(dmg_builder* b) {
    float span = dmg_scale_range(b, 0.12f, 0.45f);
    int kind = dmg_int(b, 0, 4);
    bool flat = kind < 2 || kind == 4;
    if (flat && dmg_chance(b, 0.6f)) { /* lying on a bench */
        dmg_move(b, 0, 0.03f * span, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    } else if (flat)
        dmg_move(b, 0, 0.4f * span, 0);
    switch (kind) {
    case 0:
        draw_caliper(b, span);
        break;
    case 1:
        draw_micrometer(b, 0.2f * span);
        break;
    case 2:
        draw_dial_stand(b, span);
        break;
    case 3:
        draw_height_gauge(b, 1.4f * span);
        break;
    default:
        draw_bevel(b, 0.7f * span);
        break;
    }
}
