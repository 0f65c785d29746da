/* Draws door furniture on a piece cut out of a door: lever handles, thumb-turns, knobs, bolts, latches, hasps,
 * keyhole covers, letter flaps, knockers, chains, window handles. The door's face is z = 0. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"

/* ---- each centred at the origin, `size` about a hand's breadth; the door's free edge at -X ---- */

/* Draws a shield below: round, long, or of free outline. Returns how thick it is. */
static float draw_shield(dmg_builder* b, float size, bool high) {
    float t = size * dmg_range(b, 0.03f, 0.1f), wide = size * dmg_range(b, 0.3f, 0.42f),
          tall = high ? size * dmg_range(b, 1.2f, 2.0f) : wide;
    int kind = dmg_int(b, 0, 2);
    if (kind == 0 && !high) dmg_cone(b, v3(0, 0, 0), v3(0, 0, t), 0.6f * wide, 0.5f * wide);
    if (kind == 0 && high) dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * wide, 0.5f * tall, t));
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    if (kind == 1) dmg_rounded_plate(b, wide, tall, t, dmg_range(b, 0.05f, 0.5f) * wide);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(wide, tall, t), 0.4f * t);
    dmg_restore(b);
    return t;
}

/* Draws a bent grip on a neck; it turns down, springs back. */
static void draw_door_lever(dmg_builder* b, float size) {
    bool high = dmg_chance(b, 0.5f), turned = dmg_chance(b, 0.4f);
    float t = draw_shield(b, size, high), neck = size * dmg_range(b, 0.07f, 0.12f),
          out = size * dmg_range(b, 0.35f, 0.5f), reach = size * dmg_range(b, 0.9f, 1.3f),
          sag = size * dmg_range(b, -0.15f, 0.2f), swing = dmg_range(b, 0.4f, 1.0f),
          back = size * dmg_range(b, 0.0f, 0.15f), side = dmg_chance(b, 0.9f) ? 1.0f : -1.0f,
          thick = dmg_range(b, 0.9f, 1.4f), flat = dmg_range(b, 0.6f, 1.0f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, t + 0.06f * size), 1.6f * neck);
    dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(0, 0, -side), 0.0f, swing);
    dmg_rod(b, v3(0, 0, t + 0.06f * size), v3(0, 0, out), neck);
    dmg_bent n = dmg_bent_between(v3(-0.1f * side * size, 0, out), v3(side * reach, sag * 0.3f, out - back),
                                  v3(0, 0.3f * sag, 0), v3(0, side, 0), neck * thick, neck * flat);
    if (turned) n.control[2] = v3(side * reach, sag, out + back);
    n.wide[2] *= dmg_range(b, 0.6f, 1.4f);
    n.power = dmg_scale_range(b, 2.0f, 5.0f);
    n.twist = dmg_range(b, -0.4f, 0.4f);
    n.round[0] = n.round[1] = 0.12f;
    n.columns = 14;
    dmg_bent_draw(b, &n);
    dmg_use(b, 0);
}

static void draw_door_knob(dmg_builder* b, float size) {
    float t = draw_shield(b, size, dmg_chance(b, 0.4f)), r = size * dmg_range(b, 0.22f, 0.34f),
          out = size * dmg_range(b, 0.4f, 0.6f), turn = dmg_range(b, 0.6f, 1.6f);
    int kind = dmg_int(b, 0, 2);
    bool button = dmg_chance(b, 0.3f);
    uint32_t knob = dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, 1), -turn, turn);
    dmg_rod(b, v3(0, 0, t), v3(0, 0, out), 0.35f * r);
    if (kind == 0) dmg_ellipsoid(b, v3(0, 0, out), v3(r, r, 0.75f * r));
    if (kind == 1) dmg_ellipsoid(b, v3(0, 0, out), v3(0.75f * r, 1.1f * r, 0.7f * r));
    const dmg_xy mushroom[] = {
        {0.35f * r, t}, {0.5f * r, 0.6f * out}, {r, out}, {0.9f * r, out + 0.25f * r}, {0, out + 0.3f * r}};
    if (kind == 2) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), mushroom, 5);
    if (button) {
        float face = out + (kind == 0 ? 0.75f : kind == 1 ? 0.7f : 0.3f) * r;
        dmg_slide(b, knob, "lock_button", v3(0, 0, -1), 0.0f, 0.15f * r);
        dmg_rod(b, v3(0, 0, face - 0.2f * r), v3(0, 0, face + 0.2f * r), 0.2f * r);
    }
    dmg_use(b, 0);
}

static void draw_thumb_turn(dmg_builder* b, float size) {
    float t = draw_shield(b, 0.8f * size, false), turn = dmg_range(b, 1.2f, 1.6f), w = size * dmg_range(b, 0.1f, 0.22f),
          out = size * dmg_range(b, 0.15f, 0.3f), aside = dmg_chance(b, 0.5f) ? 0.0f : 1.57f;
    bool tear = dmg_chance(b, 0.5f);
    dmg_turn(b, v3(0, 0, 1), aside);
    dmg_hinge(b, 0, "thumb_turn", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, turn);
    dmg_rod(b, v3(0, 0, t), v3(0, 0, t + 0.3f * out), 0.5f * w);
    dmg_bent n = dmg_bent_between(v3(0, -w, t + 0.8f * out), v3(0, (tear ? 1.8f : 1.0f) * w, t + 0.8f * out),
                                  v3(0, 0, 0), v3(1, 0, 0), 0.25f * w, 0.6f * out);
    if (tear) n.deep[2] *= 0.4f;
    n.rows = n.columns = 12;
    dmg_bent_draw(b, &n);
    dmg_use(b, 0);
}

/* Draws a rod in its loops, shot past the edge; its knob may have to be turned out of a notch first. */
static void draw_bolt(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.06f, 0.1f), l = size * dmg_range(b, 0.8f, 1.5f), way = l * dmg_range(b, 0.2f, 0.4f),
          t = 0.05f * size, y = 1.3f * r + t;
    bool upright = dmg_chance(b, 0.3f), turns = dmg_chance(b, 0.5f), flat = !turns && dmg_chance(b, 0.5f);
    dmg_turn(b, v3(0, 0, 1), upright ? -0.5f * DMG_PI : 0.0f);
    dmg_box_span(b, v3(-0.5f * l, -2.2f * r, 0), v3(0.5f * l, 2.2f * r, t));
    for (int i = 0; i < 3; ++i) {
        float x = l * (0.42f * (float)(i - 1));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(x, (float)s * 1.5f * r, 0.5f * (y + 1.4f * r)), v3(0.08f * l, 0.8f * r, y + 1.4f * r));
        dmg_box(b, v3(x, 0, y + 1.5f * r), v3(0.08f * l, 3.8f * r, 0.8f * r));
    }
    uint32_t bolt = dmg_slide(b, 0, "bolt", v3(-1, 0, 0), 0.0f, way);
    if (turns) { /* the sleeve slides, the rod with its knob turns in it */
        dmg_rod(b, v3(0.02f * l, 0, y), v3(0.3f * l, 0, y), 1.08f * r);
        dmg_hinge(b, bolt, "bolt_rod", v3(0, 0, y), v3(1, 0, 0), 0.0f, 1.4f);
    }
    if (flat)
        dmg_box_span(b, v3(-0.48f * l, -r, y - r), v3(0.46f * l, r, y + 0.9f * r));
    else
        dmg_rod(b, v3(-0.48f * l, 0, y), v3(0.46f * l, 0, y), r);
    dmg_rod(b, v3(0.2f * l, 0, y), v3(0.2f * l, turns ? -2.5f * r : 0.0f, y + 3.5f * r), 0.6f * r);
    dmg_ellipsoid(b, v3(0.2f * l, turns ? -2.5f * r : 0.0f, y + 4 * r), v3(r, r, r));
    dmg_use(b, 0);
}

/* Draws a bar that drops into a catch on the frame. */
static void draw_bar_latch(dmg_builder* b, float size) {
    float l = size * dmg_range(b, 0.9f, 1.5f), t = 0.06f * size, lift = dmg_range(b, 0.3f, 0.7f);
    bool curl = dmg_chance(b, 0.5f);
    dmg_rounded_box(b, v3(0.4f * l, 0, 0.5f * t), v3(4 * t, 6 * t, t), 0.3f * t);
    dmg_box_span(b, v3(-0.2f * l, -2 * t, 0), v3(-0.2f * l + t, 2.5f * t, 3.5f * t));
    dmg_hinge(b, 0, "latch", v3(0.4f * l, 0, 0), v3(0, 0, -1), 0.0f, lift);
    dmg_rod(b, v3(0.4f * l, 0, t), v3(0.4f * l, 0, 3.2f * t), 1.2f * t);
    dmg_box_span(b, v3(-0.55f * l, -0.8f * t, 1.6f * t), v3(0.4f * l, 0.8f * t, 2.6f * t));
    if (curl) dmg_torus(b, v3(0.02f * l, 2.3f * t, 2.1f * t), v3(0, 0, 1), 1.5f * t, 0.4f * t);
    if (!curl) dmg_rod(b, v3(0.02f * l, 0, 2 * t), v3(0.02f * l, 0, 6 * t), 0.7f * t);
    dmg_use(b, 0);
}

/* The strap swings off its staple; the staple's eye turns, or a lock hangs in it. */
static void draw_hasp(dmg_builder* b, float size) {
    float l = 0.7f * size, w = size * dmg_range(b, 0.25f, 0.4f), t = 0.05f * size;
    bool eye = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(0.1f * l, -0.5f * w, 0), v3(0.7f * l, 0.5f * w, t));
    dmg_rounded_box(b, v3(-0.65f * l, 0, 0.4f * t), v3(0.55f * l, 1.1f * w, 0.8f * t), 0.3f * t);
    dmg_rod(b, v3(0.08f * l, -0.5f * w, t), v3(0.08f * l, -0.18f * w, t), 0.9f * t);
    dmg_rod(b, v3(0.08f * l, 0.18f * w, t), v3(0.08f * l, 0.5f * w, t), 0.9f * t);
    if (eye) dmg_hinge(b, 0, "staple", v3(-0.65f * l, 0, 0), v3(0, 0, 1), 0.0f, 1.57f);
    dmg_torus(b, v3(-0.65f * l, 0, 2.5f * t), v3(0, 1, 0), 1.8f * t, 0.5f * t);
    dmg_use(b, 0);
    dmg_hinge(b, 0, "hasp", v3(0.08f * l, 0, t), v3(0, 1, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
    dmg_rod(b, v3(0.08f * l, -0.16f * w, t), v3(0.08f * l, 0.16f * w, t), 0.9f * t);
    dmg_box_span(b, v3(-0.45f * l, -0.4f * w, 1.3f * t), v3(0.08f * l, 0.4f * w, 1.9f * t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.95f * l, (float)s * 0.3f * w - 0.1f * w, 1.3f * t),
                     v3(-0.44f * l, (float)s * 0.3f * w + 0.1f * w, 1.9f * t));
    dmg_box_span(b, v3(-1.05f * l, -0.4f * w, 1.3f * t), v3(-0.94f * l, 0.4f * w, 1.9f * t));
    dmg_use(b, 0);
}

/* A drop over the hole, hung on a pin at its top. */
static void draw_key_cover(dmg_builder* b, float size) {
    float t = draw_shield(b, 0.7f * size, dmg_chance(b, 0.3f)), drop = size * dmg_range(b, 0.2f, 0.4f),
          swing = dmg_range(b, 0.6f, 2.5f), top = 0.12f * size;
    dmg_rod(b, v3(0, -0.02f * size, 0), v3(0, -0.02f * size, t + 0.005f * size), 0.05f * size);
    dmg_hinge(b, 0, "cover", v3(0, top, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
    dmg_rod(b, v3(0, top, t), v3(0, top, t + 0.1f * size), 0.05f * size);
    dmg_bent n = dmg_bent_between(v3(0, top + 0.04f * size, t + 0.05f * size), v3(0, top - drop, t + 0.05f * size),
                                  v3(0, 0, 0), v3(1, 0, 0), 0.05f * size, 0.025f * size);
    n.wide[1] = size * dmg_range(b, 0.06f, 0.1f);
    n.wide[2] = size * dmg_range(b, 0.06f, 0.12f);
    n.round[1] = 0.4f;
    n.rows = n.columns = 14;
    dmg_bent_draw(b, &n);
    dmg_use(b, 0);
}

/* Draws a slot behind a flap hung at its top, inside a frame or over it. */
static void draw_letter_flap(dmg_builder* b, float size) {
    float w = size * dmg_range(b, 1.4f, 2.0f), h = size * dmg_range(b, 0.35f, 0.55f), t = 0.05f * size,
          swing = dmg_range(b, 0.7f, 1.5f);
    bool knocks = dmg_chance(b, 0.3f);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_frame_draw(b, w, h, t, 0.14f * h);
    dmg_restore(b);
    uint32_t flap = dmg_hinge(b, 0, "letter_flap", v3(0, 0.34f * h, 0.7f * t), v3(-1, 0, 0), 0.0f, swing);
    dmg_rounded_box(b, v3(0, 0, t), v3(w - 0.3f * h, 0.7f * h, 0.6f * t), 0.2f * t);
    if (knocks) {
        dmg_hinge(b, flap, "knocker", v3(0, 0.2f * h, 1.9f * t), v3(-1, 0, 0), 0.0f, 0.8f);
        const dmg_vec bail[] = {{-0.2f * w, 0.2f * h, 1.9f * t},
                                {-0.18f * w, -0.15f * h, 2.2f * t},
                                {0.18f * w, -0.15f * h, 2.2f * t},
                                {0.2f * w, 0.2f * h, 1.9f * t}};
        dmg_sweep(b, bail, 4, 0.5f * t, 0.5f * t, false);
    }
    dmg_use(b, 0);
}

/* Draws a ring, a stirrup or a drop from a boss; it strikes a stud. */
static void draw_knocker(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.3f, 0.5f), tube = size * dmg_range(b, 0.04f, 0.07f),
          out = size * dmg_range(b, 0.1f, 0.18f);
    int kind = dmg_int(b, 0, 2);
    dmg_ellipsoid(b, v3(0, 0.1f * size, 0), v3(0.28f * size, 0.35f * size, 0.8f * out));
    dmg_rod(b, v3(0, -2 * r, 0), v3(0, -2 * r, out - tube), 0.1f * size);
    dmg_hinge(b, 0, "knocker", v3(0, 0, out), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.6f, 1.4f));
    dmg_rod(b, v3(-0.2f * r, 0, out), v3(0.2f * r, 0, out), 1.4f * tube);
    if (kind == 0) dmg_torus(b, v3(0, -r, out + 0.3f * tube), v3(0, 0, 1), r, tube);
    const dmg_vec stirrup[] = {{0, 0, out},
                               {-0.6f * r, -0.5f * r, out},
                               {-0.7f * r, -1.6f * r, out + tube},
                               {0, -2 * r, out + tube},
                               {0.7f * r, -1.6f * r, out + tube},
                               {0.6f * r, -0.5f * r, out},
                               {0, 0, out}};
    if (kind == 1) dmg_sweep(b, stirrup, 7, tube, tube, false);
    if (kind == 2) {
        dmg_bent n =
            dmg_bent_between(v3(0, 0, out), v3(0, -2 * r, out + tube), v3(0, 0, 0.2f * r), v3(1, 0, 0), tube, tube);
        n.wide[1] = n.wide[2] = 2.2f * tube;
        n.deep[2] = 1.8f * tube;
        dmg_bent_draw(b, &n);
    }
    dmg_use(b, 0);
}

/* Draws a slider in a track, links on it that hang. */
static void draw_chain(dmg_builder* b, float size) {
    float l = size * dmg_range(b, 0.8f, 1.2f), t = 0.05f * size, way = 0.75f * l;
    int links = dmg_int(b, 3, 6);
    dmg_box_span(b, v3(-0.55f * l, -2 * t, 0), v3(0.55f * l, 2 * t, t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.55f * l, (float)s * 1.5f * t - 0.6f * t, 0),
                     v3(0.55f * l, (float)s * 1.5f * t + 0.6f * t, 2.4f * t));
    uint32_t last = dmg_slide(b, 0, "chain_stud", v3(1, 0, 0), 0.0f, way);
    dmg_rod(b, v3(-0.4f * l, 0, 1.1f * t), v3(-0.4f * l, 0, 4 * t), 0.7f * t);
    dmg_rod(b, v3(-0.4f * l, 0, 3.4f * t), v3(-0.4f * l, 0, 4.2f * t), 1.3f * t);
    for (int i = 0; i < links; ++i) {
        float y = -(float)i * 3.4f * t, z = 3.2f * t;
        last = dmg_hinge(b, last, "link", v3(-0.4f * l, y, z), v3(0, 0, 1), -0.25f, 0.25f);
        dmg_torus(b, v3(-0.4f * l, y - 1.7f * t, z), i % 2 ? v3(1, 0, 0) : v3(0, 0, 1), 1.9f * t, 0.35f * t);
    }
    dmg_use(b, 0);
}

/* Down when shut, level to open, up to tilt; a button that frees it in some. */
static void draw_window_handle(dmg_builder* b, float size) {
    float w = size * dmg_range(b, 0.22f, 0.3f), h = size * dmg_range(b, 0.5f, 0.7f),
          t = size * dmg_range(b, 0.06f, 0.12f), reach = size * dmg_range(b, 0.8f, 1.2f),
          out = size * dmg_range(b, 0.28f, 0.4f), side = dmg_sign(b);
    bool tilts = dmg_chance(b, 0.5f), button = dmg_chance(b, 0.4f);
    dmg_rounded_box(b, v3(0, 0, 0.5f * t), v3(w, h, t), 0.4f * t);
    uint32_t handle = dmg_hinge(b, 0, "window_handle", v3(0, 0, 0), v3(0, 0, side), 0.0f, tilts ? DMG_PI : 1.57f);
    dmg_rod(b, v3(0, 0, t), v3(0, 0, out), 0.32f * w);
    dmg_bent n = dmg_bent_between(v3(0, 0.1f * size, out), v3(0, -reach, out + 0.05f * size), v3(0, 0, 0.06f * size),
                                  v3(1, 0, 0), 0.32f * w, 0.25f * w);
    n.wide[1] *= dmg_range(b, 0.7f, 1.1f);
    n.wide[2] *= dmg_range(b, 0.7f, 1.3f);
    n.power = dmg_range(b, 2.0f, 4.0f);
    n.round[0] = n.round[1] = 0.15f;
    dmg_window w_key = {0};
    if (button) w_key = dmg_bent_open(&n, 0.25f, 0.5f * DMG_PI + DMG_PI, 0.14f, 1.2f, 0.1f * w);
    dmg_bent_draw(b, &n);
    if (button) dmg_bent_key_draw(b, &n, &w_key, handle, "lock_button", DMG_KEY_PRESS);
    dmg_use(b, 0);
}

/* ---- the piece of a door ---- */

typedef void draw_furniture(dmg_builder* b, float size);

void dmg_build_door_furniture(dmg_builder* b) {
    static draw_furniture* const kinds[] = {draw_door_lever, draw_door_knob, draw_thumb_turn,   draw_bolt,
                                            draw_bar_latch,  draw_hasp,      draw_key_cover,    draw_letter_flap,
                                            draw_knocker,    draw_chain,     draw_window_handle};
    /* How far each reaches above and below its middle, in hands. */
    static const float reach[] = {1.0f, 0.9f, 0.4f, 0.7f, 0.4f, 0.4f, 0.6f, 0.45f, 1.2f, 1.4f, 1.3f};
    enum { KINDS = 11 };
    int count = dmg_int(b, 1, 4), kind[4];
    float size = dmg_range(b, 0.09f, 0.13f), high = 0, t = size * dmg_range(b, 0.25f, 0.5f),
          wide = size * dmg_range(b, 2.1f, 2.8f), lean = dmg_range(b, -0.3f, 0.3f);
    for (int i = 0; i < count; ++i) {
        kind[i] = dmg_int(b, 0, KINDS - 1);
        high += 2 * reach[kind[i]] * size;
    }
    bool tongue = dmg_chance(b, 0.4f);
    if (dmg_chance(b, 0.2f)) dmg_turn(b, v3(1, 0, 0), lean);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    dmg_move(b, 0, 0.5f * high, 0);
    dmg_rounded_plate(b, wide, high, t, dmg_range(b, 0.0f, 0.3f) * size);
    float y = 0.5f * high;
    for (int i = 0; i < count; ++i) {
        y -= reach[kind[i]] * size;
        float down = kind[i] >= 8 ? 0.6f * size : 0.0f, aside = kind[i] == 7 ? 0.0f : -0.15f * wide;
        dmg_save(b);
        dmg_move(b, aside, y + down, 0);
        kinds[kind[i]](b, size);
        dmg_restore(b);
        y -= reach[kind[i]] * size;
    }
    if (!tongue) return;
    dmg_slide(b, 0, "tongue", v3(1, 0, 0), 0.0f, 0.1f * size);
    dmg_box_span(b, v3(-0.5f * wide - 0.12f * size, -0.15f * size, -0.7f * t),
                 v3(-0.5f * wide + 0.1f * size, 0.15f * size, -0.3f * t));
}
