/* Draws robot models as description files hold them: bare boxes, cylinders, capsules and balls that overlap at their
 * joints or float apart. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct bare {
    int link;    /* capsule, box, cylinder, cone, board, stick with a ball */
    int pin;     /* what shows of a joint: nothing, a ball, a pin */
    float thick; /* of links */
    float taper; /* from one link to the next */
    float gap;   /* that a link leaves at both its ends, fraction of its length; negative: it reaches beyond them */
} bare;

static bare pick_bare(dmg_builder* b, float thick) {
    bare s = {.link = dmg_int(b, 0, 5), .thick = thick};
    s.pin = dmg_int(b, 0, 2);
    s.taper = dmg_range(b, 0.75f, 1.0f);
    s.gap = dmg_chance(b, 0.4f) ? dmg_range(b, 0.03f, 0.2f) : 0.0f;
    if (dmg_chance(b, 0.2f)) s.gap = -dmg_range(b, 0.02f, 0.1f);
    return s;
}

static void draw_link(dmg_builder* b, const bare* s, dmg_vec from, dmg_vec to) {
    dmg_vec start = v3_lerp(from, to, s->gap), end = v3_lerp(to, from, s->gap);
    float t = s->thick;
    if (s->link == 0) dmg_capsule(b, start, end, 0.5f * t);
    if (s->link == 1) dmg_beam(b, start, end, t, t);
    if (s->link == 2) dmg_rod(b, start, end, 0.5f * t);
    if (s->link == 3) dmg_cone(b, start, end, 0.6f * t, 0.35f * t);
    if (s->link == 4) dmg_beam(b, start, end, 1.8f * t, 0.4f * t);
    if (s->link == 5) {
        dmg_rod(b, start, end, 0.25f * t);
        dmg_ellipsoid(b, end, v3(0.8f * t, 0.8f * t, 0.8f * t));
    }
}

/* Draws a link that turns about `axis` at its beginning; no swing: without end. */
static uint32_t draw_swinging(dmg_builder* b, const bare* s, uint32_t carrier, const char* name, dmg_vec at, dmg_vec to,
                              dmg_vec axis, float swing) {
    float t = s->thick;
    axis = v3_scale(axis, dmg_sign(b));
    uint32_t link =
        swing > 0.0f ? dmg_hinge(b, carrier, name, at, axis, -swing, swing) : dmg_spin(b, carrier, name, at, axis);
    draw_link(b, s, at, to);
    if (s->pin == 1) dmg_ellipsoid(b, at, v3(0.65f * t, 0.65f * t, 0.65f * t));
    if (s->pin == 2) dmg_rod(b, v3_mad(at, axis, -0.8f * t), v3_mad(at, axis, 0.8f * t), 0.4f * t);
    return link;
}

/* Links one after another in the plane across `axis`, the first along `along`. */
static uint32_t draw_chain(dmg_builder* b, bare s, uint32_t carrier, const char* name, dmg_vec at, dmg_vec along,
                           dmg_vec axis, float length, int links, float swing) {
    for (int i = 0; i < links; ++i) {
        dmg_vec to = v3_mad(at, along, length);
        carrier = draw_swinging(b, &s, carrier, name, at, to, axis, swing);
        along = v3_turn(along, axis, dmg_range(b, -0.7f, 0.7f));
        length *= dmg_range(b, 0.6f, 1.1f);
        s.thick *= s.taper;
        at = to;
    }
    dmg_use(b, carrier);
    if (links > 0 && dmg_chance(b, 0.4f)) dmg_ellipsoid(b, at, v3(s.thick, s.thick, s.thick));
    return carrier;
}

/* ---- carts ---- */

static void draw_cart_wheels(dmg_builder* b, uint32_t cart, dmg_vec size) {
    float radius = 0.3f * size.y;
    bool turn = dmg_chance(b, 0.5f);
    for (int i = 0; i < 4; ++i) {
        float x = (i % 2 ? 0.35f : -0.35f) * size.x, z = (i / 2 ? 0.55f : -0.55f) * size.z, y = -0.5f * size.y;
        if (turn) dmg_spin(b, cart, "wheel", v3(x, y, z), v3(0, 0, 1));
        dmg_rod(b, v3(x, y, z - 0.06f * size.z), v3(x, y, z + 0.06f * size.z), radius);
        dmg_use(b, cart);
    }
}

/* Something that slides on a rail, a slab or nothing, and poles that stand or hang on it. */
static void draw_cart_pole(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.5f, 5.0f), s = length * dmg_range(b, 0.05f, 0.2f), thin = 0.2f * s;
    float sx = s * dmg_range(b, 0.8f, 2.0f), sy = s * dmg_range(b, 0.4f, 1.2f), sz = s * dmg_range(b, 0.5f, 1.2f),
          travel = 0.5f * (length - sx), pole = length * dmg_range(b, 0.15f, 0.6f);
    int ground = dmg_int(b, 0, 3), carts = dmg_chance(b, 0.2f) ? 2 : 1, at = dmg_int(b, 0, 2);
    bool hangs = ground < 2 && at == 2 && dmg_chance(b, 0.6f);
    dmg_move(b, 0, hangs ? 1.5f * pole : 0.5f * sy + 0.3f * s, 0);
    if (ground == 0) dmg_rod(b, v3(-0.5f * length, 0, 0), v3(0.5f * length, 0, 0), 0.5f * thin);
    if (ground == 1) dmg_box(b, v3(0, 0, 0), v3(length, thin, thin));
    if (ground >= 2) dmg_box(b, v3(0, -0.5f * sy - 0.3f * s, 0), v3(1.1f * length, 0.1f * s, 2.0f * sz));
    if (ground == 3)
        for (int e = -1; e <= 1; e += 2)
            dmg_box(b, v3((float)e * 0.55f * length, 0, 0), v3(0.2f * s, sy + 0.6f * s, sz));
    bare style = pick_bare(b, s * dmg_range(b, 0.2f, 0.6f));
    for (int i = 0; i < carts; ++i) {
        dmg_save(b);
        float middle = carts == 1 ? 0.0f : ((float)i - 0.5f) * 0.5f * length, way = travel / (float)carts;
        dmg_move(b, middle, 0, 0);
        uint32_t cart = dmg_slide(b, 0, "cart", v3(dmg_sign(b), 0, 0), -0.9f * way, 0.9f * way);
        if (dmg_chance(b, 0.5f)) dmg_rest(b, cart, way * dmg_range(b, -0.8f, 0.8f));
        dmg_box(b, v3(0, 0, 0), v3(sx, sy, sz));
        if (ground >= 2 && dmg_chance(b, 0.5f)) draw_cart_wheels(b, cart, v3(sx, sy, sz));
        int poles = i == 0 || dmg_chance(b, 0.5f) ? dmg_int(b, 1, 3) : 0;
        float lean = dmg_range(b, -0.3f, 0.3f), up = hangs ? -1.0f : 1.0f;
        dmg_vec root = {0, at == 1 ? 0.5f * sy : 0, at == 2 ? 0.5f * sz + 0.6f * style.thick : 0};
        float swing = hangs && dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.8f, 1.4f);
        draw_chain(b, style, cart, "pole", root, v3(sinf(lean), up * cosf(lean), 0), v3(0, 0, 1), pole, poles, swing);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* ---- pendulums ---- */

/* From a post, a gallows, a block in the air or a motor: plain, double, on a turning arm, with a wheel at its end. */
static void draw_pendulum(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.1f, 1.5f), thick = length * dmg_range(b, 0.03f, 0.15f), off = 1.3f * thick,
          high = 2.4f * length;
    int stand = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 2);
    bare style = pick_bare(b, thick);
    if (kind == 1) high = length * dmg_range(b, 1.2f, 2.0f);
    if (stand != 2) dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), 0.6f * thick);
    if (stand == 0) dmg_box(b, v3(0, 0.3f * thick, 0), v3(0.8f * length, 0.6f * thick, 0.8f * length));
    if (stand == 1 && kind != 1) dmg_box(b, v3(0, high, 0), v3(2 * thick, 2 * thick, 1.2f * thick));
    if (stand == 2) dmg_box(b, v3(0, high - 0.6f * thick, 0), v3(2 * thick, 1.2f * thick, 1.2f * thick));
    if (stand == 3) dmg_cone(b, v3(0, 0, 0), v3(0, 0.6f * length, 0), 0.4f * length, 0.1f * length);
    dmg_move(b, 0, high, 0);
    float lean = dmg_range(b, -1.0f, 1.0f), swing = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.8f, 2.6f);
    if (kind == 1) { /* the arm goes round the post, the pendulum about the arm */
        dmg_vec end = {0, 0.5f * thick, 0.7f * length};
        uint32_t arm = dmg_chance(b, 0.6f) ? dmg_spin(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0))
                                           : dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0), -1.8f, 1.8f);
        bare bar = style;
        bar.gap = fminf(bar.gap, 0.0f);
        draw_link(b, &bar, v3(0, 0.5f * thick, 0), end);
        end.z += 0.7f * thick;
        draw_chain(b, style, arm, "pendulum", end, v3(sinf(lean), -cosf(lean), 0), v3(0, 0, 1), 0.8f * length,
                   dmg_int(b, 1, 2), swing);
        dmg_use(b, 0);
        return;
    }
    uint32_t last = draw_chain(b, style, 0, "link", v3(0, 0, off), v3(sinf(lean), -cosf(lean), 0), v3(0, 0, 1),
                               (kind == 0 ? 0.7f : 1.2f) * length, kind == 0 ? dmg_int(b, 2, 3) : 1, swing);
    if (kind == 2) { /* a wheel that pushes it */
        dmg_vec hub = {1.2f * length * sinf(lean), -1.2f * length * cosf(lean), off + 0.6f * thick};
        dmg_spin(b, last, "reaction_wheel", hub, v3(0, 0, 1));
        dmg_save(b);
        dmg_move(b, hub.x, hub.y, hub.z + 0.4f * thick);
        int wheel = dmg_int(b, 0, 3);
        dmg_wheel_draw(b, wheel, length * dmg_range(b, 0.15f, 0.4f), 0.8f * thick, 4);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- what balances ---- */

/* Draws a ball on a beam or a plate that tips one way or both; the ball is a part that rolls along it, or belongs to
 * it. */
static void draw_balancer(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 1.2f), t = size * dmg_range(b, 0.02f, 0.08f),
          wide = size * dmg_range(b, 0.1f, 1.0f), high = size * dmg_range(b, 0.2f, 0.7f),
          r = size * dmg_range(b, 0.03f, 0.09f), swing = fminf(0.5f, 0.7f * high / size) * dmg_range(b, 0.4f, 1.0f);
    bool round = wide > 0.5f * size && dmg_chance(b, 0.5f), end = !round && dmg_chance(b, 0.25f);
    float x = end ? 0.5f * size : 0.0f;
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.5f * t, 0), v3(0.8f * size, t, 0.6f * size));
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(-x, 0, 0), v3(-x, high - 0.6f * t, 0), 0.7f * t);
    else
        dmg_cone(b, v3(-x, 0, 0), v3(-x, high - 0.6f * t, 0), 0.2f * size, 0.3f * t);
    dmg_move(b, 0, high, 0);
    uint32_t carrier = dmg_hinge(b, 0, "tip", v3(-x, 0, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
    if (!end && dmg_chance(b, 0.5f)) { /* the cross of a universal joint */
        dmg_rod(b, v3(0, 0, -2 * t), v3(0, 0, 2 * t), 0.5f * t);
        dmg_move(b, 0, t, 0);
        carrier = dmg_hinge(b, carrier, "tilt", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -swing, swing);
    }
    if (round) dmg_rod(b, v3(0, -0.5f * t, 0), v3(0, 0.5f * t, 0), 0.5f * size);
    if (!round) dmg_box(b, v3(0, 0, 0), v3(size, t, wide));
    if (!round && dmg_chance(b, 0.5f)) /* borders */
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, t, (float)s * 0.5f * wide), v3(size, 2 * t, 0.6f * t));
    float way = 0.45f * size - r;
    if (dmg_chance(b, 0.7f)) dmg_slide(b, carrier, "ball", v3(1, 0, 0), -way, way);
    if (dmg_chance(b, 0.7f))
        dmg_ellipsoid(b, v3(0, 0.5f * t + r, 0), v3(r, r, r));
    else
        dmg_box(b, v3(0, 0.5f * t + r, 0), v3(2 * r, 2 * r, 2 * r));
    dmg_use(b, 0);
}

/* Links that turn over a board; a wall round it, a ball to reach for. */
static void draw_reacher(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.1f, 1.0f), thick = length * dmg_range(b, 0.05f, 0.2f), half = 2.2f * length,
          t = 0.4f * thick;
    bare style = pick_bare(b, thick);
    bool wall = dmg_chance(b, 0.5f);
    dmg_box(b, v3(0, 0.5f * t, 0), v3(2 * half, t, 2 * half));
    for (int i = 0; i < 4 && wall; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 4);
        dmg_rod(b, v3(-half, thick, half), v3(half, thick, half), 0.5f * thick);
        dmg_restore(b);
    }
    float x = length * dmg_range(b, -1.5f, 1.5f);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3(x, t + 2.5f * thick, -1.5f * length), v3(0.5f * thick, 0.5f * thick, 0.5f * thick));
    dmg_rod(b, v3(0, t, 0), v3(0, t + 0.5f * thick, 0), 0.7f * thick);
    float turn = dmg_range(b, 0.0f, 2.0f * DMG_PI), swing = dmg_chance(b, 0.5f) ? 0.0f : 2.5f;
    draw_chain(b, style, 0, "arm", v3(0, t + 1.3f * thick, 0), v3(cosf(turn), 0, sinf(turn)), v3(0, 1, 0), length,
               dmg_int(b, 1, 3), swing);
    dmg_use(b, 0);
}

/* ---- creatures of capsules ---- */

static void draw_crawler_leg(dmg_builder* b, bare s, float length) {
    bool ball = dmg_chance(b, 0.5f);
    dmg_vec knee = {0.5f * length, 0, 0}, foot = {length, ball ? -0.2f * length : -0.6f * length, 0};
    uint32_t hip = draw_swinging(b, &s, 0, "hip", v3(0, 0, 0), knee, v3(0, 1, 0), 0.7f);
    s.thick *= s.taper;
    draw_swinging(b, &s, hip, "ankle", knee, foot, v3(0, 0, 1), dmg_range(b, 0.4f, 1.0f));
    dmg_use(b, 0);
}

/* Hoppers, cheetahs, swimmers and ants: a torso and chains in one plane, or legs all round. */
static void draw_creature(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.2f, 1.5f), swing = dmg_range(b, 0.5f, 1.2f);
    bare s = pick_bare(b, size * dmg_range(b, 0.1f, 0.25f));
    if (dmg_chance(b, 0.6f)) s.link = 0;
    int kind = dmg_int(b, 0, 3), links = dmg_int(b, 2, 5);
    dmg_move(b, 0, 2.5f * size, 0);
    if (kind == 0) { /* one leg under an upright torso, or two in step */
        int legs = dmg_int(b, 1, 2);
        draw_link(b, &s, v3(0, 0, 0), v3(0, size, 0));
        for (int i = 0; i < legs; ++i) {
            float z = legs == 1 ? 0.0f : ((float)i - 0.5f) * 1.2f * s.thick;
            draw_chain(b, s, 0, "leg", v3(0, 0, z), v3(0, -1, 0), v3(0, 0, 1), 0.8f * size, dmg_int(b, 2, 3), swing);
            dmg_use(b, 0);
        }
    }
    if (kind == 1) { /* a long torso on a leg at each end, a head */
        draw_link(b, &s, v3(-0.6f * size, 0, 0), v3(0.6f * size, 0, 0));
        draw_link(b, &s, v3(0.6f * size, 0, 0), v3(0.85f * size, 0.3f * size, 0));
        for (int e = -1; e <= 1; e += 2) {
            float x = (float)e * 0.6f * size, bend = dmg_range(b, -0.6f, 0.6f);
            draw_chain(b, s, 0, e < 0 ? "back_leg" : "front_leg", v3(x, 0, 0), v3(sinf(bend), -cosf(bend), 0),
                       v3(0, 0, 1), 0.45f * size, 3, swing);
            dmg_use(b, 0);
        }
    }
    if (kind == 2) { /* a chain that lies flat */
        draw_link(b, &s, v3(0, 0, 0), v3(-0.7f * size, 0, 0));
        dmg_vec axis = dmg_chance(b, 0.7f) ? v3(0, 1, 0) : v3(0, 0, 1);
        draw_chain(b, s, 0, "segment", v3(0, 0, 0), v3(1, 0, 0), axis, 0.7f * size, links, swing);
        dmg_use(b, 0);
    }
    for (int i = 0; i < links && kind == 3; ++i) {
        float r = 0.35f * size;
        if (i == 0) dmg_ellipsoid(b, v3(0, 0, 0), v3(r, 0.8f * r, r));
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, links);
        if (s.gap <= 0.0f || dmg_chance(b, 0.5f)) draw_link(b, &s, v3(0.5f * r, 0, 0), v3(1.3f * r, 0, 0));
        dmg_move(b, 1.3f * r, 0, 0);
        draw_crawler_leg(b, s, size);
        dmg_restore(b);
    }
}

/* ---- one shape beside another ---- */

/* Draws a flap beside a board: turns about the edge, or slides away from it. */
static void draw_flap(dmg_builder* b, float size, float wide, float t, float gap) {
    float edge = 0.25f * wide + 0.5f * gap;
    if (dmg_chance(b, 0.7f))
        dmg_hinge(b, 0, "flap", v3(edge, 0, dmg_chance(b, 0.5f) ? -gap : -gap - 0.5f * t), v3(0, -1, 0), 0.0f, 1.6f);
    else
        dmg_slide(b, 0, "flap", v3(1, 0, 0), 0.0f, 0.6f * size);
    dmg_box(b, v3(edge + 0.5f * gap + 0.5f * size, 0, -gap - 0.5f * t), v3(size, wide * dmg_range(b, 0.5f, 1.0f), t));
}

/* Draws a plunger out of a block, or a shaft with a fin that turns. */
static void draw_plunger(dmg_builder* b, float size, float across) {
    if (dmg_chance(b, 0.5f))
        dmg_slide(b, 0, "plunger", v3(0, 0, 1), 0.0f, dmg_range(b, 0.2f, 0.8f) * size);
    else {
        dmg_spin(b, 0, "shaft", v3(0, 0, 0), v3(0, 0, 1));
        dmg_box(b, v3(0.4f * across, 0, 0.3f * size), v3(0.8f * across, 0.2f * across, 0.3f * size));
    }
    bare rod = pick_bare(b, 0.5f * across);
    draw_link(b, &rod, v3(0, 0, 0), v3(0, 0, 0.6f * size));
}

/* Draws two or three shapes that show a joint and nothing else, a gap between them or none. */
static void draw_pair(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.05f, 1.5f), t = size * dmg_range(b, 0.04f, 0.2f),
          wide = size * dmg_range(b, 0.3f, 1.0f), gap = dmg_chance(b, 0.5f) ? 0.0f : size * dmg_range(b, 0.005f, 0.05f),
          across = size * dmg_range(b, 0.08f, 0.5f);
    int kind = dmg_int(b, 0, 5);
    dmg_move(b, 0, 1.6f * size, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)dmg_int(b, -1, 1));
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI * (float)dmg_int(b, 1, 3));
    bool ball = dmg_chance(b, 0.3f);
    if (ball && kind != 0)
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0), 0.5f * wide);
    else
        dmg_box(b, v3(0, 0, -0.5f * t), v3(kind == 0 ? 0.5f * wide : size, wide, t));
    dmg_move(b, 0, 0, gap);
    if (kind == 0) draw_flap(b, size, wide, t, gap);
    if (kind == 1) { /* a bar on a board, about a point of its own */
        float at = dmg_range(b, 0.0f, 0.5f) * size;
        float back = dmg_range(b, 0.5f, 1.5f);
        if (dmg_chance(b, 0.5f))
            dmg_hinge(b, 0, "bar", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -back, 1.5f);
        else
            dmg_spin(b, 0, "bar", v3(0, 0, 0), v3(0, 0, 1));
        dmg_box(b, v3(at, 0, 0.5f * t), v3(size, 0.5f * across, t));
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, -gap), v3(0, 0, 1.3f * t), 0.2f * across);
    }
    if (kind == 2) { /* a block on a board, along it */
        float way = 0.5f * (size - across);
        dmg_slide(b, 0, "block", v3(1, 0, 0), -way, way);
        dmg_box(b, v3(0, 0, 0.5f * t), v3(across, 0.7f * wide, t));
        if (dmg_chance(b, 0.4f)) {
            dmg_slide(b, 1, "upper_block", v3(0, 1, 0), -0.25f * wide, 0.25f * wide);
            dmg_box(b, v3(0, 0, 1.5f * t + gap), v3(0.7f * across, 0.3f * wide, t));
        }
    }
    if (kind == 3) draw_plunger(b, size, across);
    if (kind == 4) { /* a disc with a peg */
        float r = 0.45f * wide;
        dmg_spin(b, 0, "disc", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, t), r);
        if (dmg_chance(b, 0.8f)) dmg_rod(b, v3(0.7f * r, 0, t), v3(0.7f * r, 0, 3 * t), 0.15f * r);
    }
    if (kind == 5) { /* a stick that tips */
        bare stick = pick_bare(b, 0.4f * across);
        draw_swinging(b, &stick, 0, "stick", v3(0, 0, 0.5f * stick.thick), v3(0, 0, size), v3(1, 0, 0),
                      dmg_range(b, 0.3f, 1.2f));
    }
    dmg_use(b, 0);
}

/* Masses in a row on a line between walls, thin springs between them drawn as bars of the body or not at all. */
static void draw_masses(dmg_builder* b) {
    float s = dmg_scale_range(b, 0.02f, 0.5f), pitch = s * dmg_range(b, 2.0f, 4.0f);
    int count = dmg_int(b, 1, 4), shape = dmg_int(b, 0, 2);
    float half = 0.5f * pitch * (float)(count + 1), y = s * dmg_range(b, 0.6f, 3.0f);
    bool upright = dmg_chance(b, 0.3f);
    dmg_move(b, 0, upright ? half + s : y, 0);
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    for (int e = -1; e <= 1; e += 2) dmg_box(b, v3((float)e * half, 0, 0), v3(0.2f * s, 1.6f * s, 1.6f * s));
    if (dmg_chance(b, 0.7f)) dmg_rod(b, v3(-half, 0, 0), v3(half, 0, 0), 0.06f * s);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, -0.75f * s, 0), v3(2 * half, 0.1f * s, 1.6f * s));
    for (int i = 0; i < count; ++i) {
        float x = -half + pitch * (float)(i + 1), way = 0.45f * (pitch - s);
        dmg_slide(b, 0, "mass", v3(dmg_sign(b), 0, 0), -way, way);
        if (shape == 0) dmg_box(b, v3(x, 0, 0), v3(s, s, s));
        if (shape == 1) dmg_ellipsoid(b, v3(x, 0, 0), v3(0.5f * s, 0.5f * s, 0.5f * s));
        if (shape == 2) dmg_rod(b, v3(x - 0.5f * s, 0, 0), v3(x + 0.5f * s, 0, 0), 0.5f * s);
        dmg_use(b, 0);
    }
}

void dmg_build_bare_model(dmg_builder* b) {
    static void (*const kinds[])(dmg_builder*) = {draw_cart_pole, draw_pendulum, draw_balancer, draw_reacher,
                                                  draw_creature,  draw_pair,     draw_masses};
    static const float weights[] = {3, 2.5f, 1.5f, 1.5f, 2.5f, 3, 1};
    kinds[dmg_weighted(b, weights, 7)](b);
}
