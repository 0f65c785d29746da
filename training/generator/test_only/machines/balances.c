/* Draws balancing systems of control theory: a pole on a cart, double pendulums, a ball on a beam, a pendulum on a
 * turning arm, a body on two wheels; of a few plain shapes. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a link from the origin along +Y that turns about Z: a rod, a bar, a capsule, with a weight at its end. */
static void draw_link(dmg_builder* b, float length, float t) {
    int kind = dmg_int(b, 0, 2), weight = dmg_int(b, 0, 2);
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, length, 0), 0.5f * t);
    if (kind == 1) dmg_box_span(b, v3(-0.5f * t, -0.5f * t, -0.4f * t), v3(0.5f * t, length, 0.4f * t));
    if (kind == 2) dmg_capsule(b, v3(0, 0, 0), v3(0, length, 0), 0.5f * t);
    if (weight == 1) dmg_ellipsoid(b, v3(0, length, 0), v3(1.6f * t, 1.6f * t, 1.6f * t));
    if (weight == 2) dmg_rod(b, v3(0, length, -0.6f * t), v3(0, length, 0.6f * t), 1.8f * t);
}

/* Up to three links, each on the end of the last, in front of each other; up from a cart or down from a stand. */
static void draw_chain(dmg_builder* b, uint32_t parent, int links, float length, float t, bool free) {
    for (int i = 0; i < links; ++i) {
        if (free)
            parent = dmg_spin(b, parent, "pole", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
        else
            parent = dmg_hinge(b, parent, "pole", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -1.5f, 1.5f);
        dmg_rod(b, v3(0, 0, -1.3f * t), v3(0, 0, 0.6f * t), 0.35f * t);
        draw_link(b, length, t);
        dmg_move(b, 0, length, 3.2f * t);
        length *= dmg_range(b, 0.6f, 1.1f);
    }
}

static void draw_cart_pole(dmg_builder* b) {
    float rail = dmg_range(b, 0.8f, 2.5f), size = rail * dmg_range(b, 0.08f, 0.18f),
          high = rail * dmg_range(b, 0.02f, 0.4f), t = size * dmg_range(b, 0.12f, 0.3f),
          length = rail * dmg_range(b, 0.2f, 0.5f), way = 0.5f * rail - 0.6f * size, r = 0.08f * size + 0.003f;
    int track = dmg_int(b, 0, 2), links = dmg_weighted(b, (const float[]){4, 2, 0.6f}, 3) + 1;
    bool wheels = track == 2 && dmg_chance(b, 0.7f), free = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * 0.5f * rail - 0.02f, 0, -0.6f * size),
                     v3((float)s * 0.5f * rail + 0.02f, high + 0.3f * size, 0.6f * size));
        if (track == 1)
            dmg_rod(b, v3(-0.5f * rail, high, (float)s * 0.3f * size), v3(0.5f * rail, high, (float)s * 0.3f * size),
                    r);
    }
    if (track == 0) dmg_rod(b, v3(-0.5f * rail, high, 0), v3(0.5f * rail, high, 0), r);
    if (track == 2) dmg_box_span(b, v3(-0.5f * rail, high - 2 * r, -0.5f * size), v3(0.5f * rail, high, 0.5f * size));
    float low = track == 2 ? high + (wheels ? 0.3f * size : 0.002f) : high - r,
          top = low + size * dmg_range(b, 0.35f, 0.7f);
    uint32_t cart = dmg_slide(b, 0, "cart", v3(dmg_sign(b), 0, 0), -way, way);
    dmg_rest(b, cart, way * dmg_range(b, -0.7f, 0.7f));
    dmg_box_span(b, v3(-0.5f * size, low, -0.4f * size), v3(0.5f * size, top, 0.4f * size));
    for (int i = 0; i < 4 && wheels; ++i) {
        float x = (i & 1 ? 0.3f : -0.3f) * size, z = (i & 2 ? 0.46f : -0.46f) * size, w = 0.05f * size;
        dmg_spin(b, cart, "wheel", v3(x, high + 0.2f * size, z), v3(0, 0, 1));
        dmg_rod(b, v3(x, high + 0.2f * size, z - w), v3(x, high + 0.2f * size, z + w), 0.198f * size);
    }
    dmg_use(b, cart);
    dmg_move(b, 0, 0.5f * (low + top), 0.4f * size + 1.2f * t);
    draw_chain(b, cart, links, length, t, free);
}

/* Links that hang from a post or stand on it. */
static void draw_pendulums(dmg_builder* b) {
    float high = dmg_range(b, 0.4f, 1.5f), t = high * dmg_range(b, 0.02f, 0.06f),
          length = high * dmg_range(b, 0.25f, 0.42f);
    dmg_box_span(b, v3(-0.25f * high, 0, -0.2f * high), v3(0.25f * high, 0.04f * high, 0.1f * high));
    dmg_box_span(b, v3(-t, 0.04f * high, -2 * t), v3(t, high, 0));
    dmg_move(b, 0, high - t, 1.2f * t);
    if (dmg_chance(b, 0.6f)) dmg_turn(b, v3(0, 0, 1), DMG_PI);
    draw_chain(b, 0, dmg_int(b, 1, 3), length, t, true);
}

/* Draws an arm that turns level, the pendulum on its end turning about the arm's own line. */
static void draw_furuta(dmg_builder* b) {
    float high = dmg_range(b, 0.15f, 0.8f), r = high * dmg_range(b, 0.12f, 0.35f),
          arm = high * dmg_range(b, 0.5f, 1.1f), t = 0.06f * high;
    bool round = dmg_chance(b, 0.5f), down = dmg_chance(b, 0.4f);
    if (round)
        dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), r);
    else
        dmg_box_span(b, v3(-r, 0, -r), v3(r, high, r));
    uint32_t turn = dmg_spin(b, 0, "arm", v3(0, high, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, high, 0), v3(0, high + 2 * t, 0), 1.2f * t);
    dmg_move(b, 0, high + 1.4f * t, 0);
    dmg_rod(b, v3(0, 0, -0.3f * arm), v3(0, 0, arm), 0.4f * t);
    dmg_move(b, 0, 0, arm + 1.3f * t);
    if (down) dmg_turn(b, v3(0, 0, 1), DMG_PI);
    int links = dmg_chance(b, 0.25f) ? 2 : 1;
    float length = high * dmg_range(b, 0.6f, 0.9f);
    draw_chain(b, turn, links, length, t, true);
}

/* Draws a beam on a pivot in its middle or at an end; the ball runs along it, a crank may lift it. */
static void draw_ball_beam(dmg_builder* b) {
    float length = dmg_range(b, 0.4f, 1.4f), high = length * dmg_range(b, 0.2f, 0.5f), t = 0.04f * length,
          r = length * dmg_range(b, 0.03f, 0.06f), swing = 0.3f;
    bool middle = dmg_chance(b, 0.6f), groove = dmg_chance(b, 0.5f);
    float pin = middle ? 0.0f : -0.5f * length, way = 0.5f * length - 2 * r;
    dmg_box_span(b, v3(-0.5f * length, 0, -3 * t), v3(0.5f * length, 0.5f * t, 3 * t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(pin - t, 0.5f * t, (float)s * 2 * t - 0.4f * t),
                     v3(pin + t, high + t, (float)s * 2 * t + 0.4f * t));
    uint32_t beam = dmg_hinge(b, 0, "beam", v3(pin, high, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
    dmg_rod(b, v3(pin, high, -2 * t), v3(pin, high, 2 * t), 0.3f * t);
    dmg_box_span(b, v3(-0.5f * length, high - 0.4f * t, -t), v3(0.5f * length, high + 0.4f * t, t));
    for (int s = -1; s <= 1 && groove; s += 2)
        dmg_box_span(b, v3(-0.5f * length, high + 0.4f * t, (float)s * 0.9f * t - 0.1f * t),
                     v3(0.5f * length, high + 0.9f * t, (float)s * 0.9f * t + 0.1f * t));
    if (groove) r = fminf(r, 0.75f * t);
    uint32_t ball = dmg_slide(b, beam, "ball", v3(1, 0, 0), -way, way);
    dmg_rest(b, ball, way * dmg_range(b, -0.8f, 0.8f));
    dmg_ellipsoid(b, v3(0, high + 0.4f * t + r, 0), v3(r, r, r));
}

/* Draws a body on two wheels; it leans by them, some have a stick to steer with. */
static void draw_two_wheels(dmg_builder* b) {
    float r = dmg_range(b, 0.04f, 0.25f), half = r * dmg_range(b, 0.7f, 1.5f), high = r * dmg_range(b, 1.5f, 5.0f),
          deep = r * dmg_range(b, 0.4f, 1.2f), w = r * dmg_range(b, 0.15f, 0.4f);
    int kind = dmg_int(b, 0, 6), body = dmg_int(b, 0, 2), plates = dmg_int(b, 2, 4);
    bool stick = dmg_chance(b, 0.35f);
    float inner = half - 0.7f * w;
    if (body == 0) dmg_box_span(b, v3(-inner, 0.8f * r, -0.5f * deep), v3(inner, 0.8f * r + high, 0.5f * deep));
    for (int i = 0; i < plates && body == 1; ++i) {
        float y = 0.8f * r + high * (float)i / (float)(plates - 1);
        dmg_box_span(b, v3(-inner, y, -0.6f * deep), v3(inner, y + 0.08f * r, 0.6f * deep));
    }
    for (int i = 0; i < 4 && body == 1; ++i)
        dmg_rod(b, v3((i & 1 ? 0.8f : -0.8f) * inner, 0.8f * r, (i & 2 ? 0.4f : -0.4f) * deep),
                v3((i & 1 ? 0.8f : -0.8f) * inner, 0.8f * r + high, (i & 2 ? 0.4f : -0.4f) * deep), 0.06f * r);
    if (body == 2) dmg_capsule(b, v3(0, 1.3f * r, 0), v3(0, 1.3f * r + high, 0), 0.5f * fminf(deep, 1.8f * inner));
    dmg_box(b, v3(0, r, 0), v3(2 * inner, 0.5f * r, 0.4f * deep));
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_spin(b, 0, "wheel", v3((float)s * half, r, 0), v3(1, 0, 0));
        dmg_move(b, (float)s * half, r, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, kind, r, w, 5);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (!stick || body == 2) return;
    float top = 0.8f * r + high + (body == 1 ? 0.08f * r : 0.0f), tall = high * dmg_range(b, 0.6f, 1.4f);
    dmg_hinge(b, 0, "stick", v3(0, top, 0), v3(0, 0, dmg_sign(b)), -0.3f, 0.3f);
    dmg_rod(b, v3(0, top, 0), v3(0, top + tall, 0), 0.1f * r);
    dmg_rod(b, v3(-0.7f * inner, top + tall, 0), v3(0.7f * inner, top + tall, 0), 0.1f * r);
}

void dmg_build_cart_pole(dmg_builder* b) {
    int design = dmg_weighted(b, (const float[]){3, 1.4f, 1.3f, 1.3f, 1.6f}, 5);
    if (design == 0) draw_cart_pole(b);
    if (design == 1) draw_pendulums(b);
    if (design == 2) draw_furuta(b);
    if (design == 3) draw_ball_beam(b);
    if (design == 4) draw_two_wheels(b);
}
