/* Draws mechanisms of textbooks, test benches and automata: slider-cranks, yokes, slotted levers, cams under
 * followers that slide or tip. The crank turns about +Z. */
#include "core/build.h"
#include "parts/cranks.h"
#include "parts/hardware.h"

/* ---- a board behind what moves: x from -back to front, y within half; lying, standing or on feet ---- */

static void draw_board(dmg_builder* b, float back, float front, float half, float t) {
    int kind = dmg_int(b, 0, 2);
    float gap = 0.05f * t;
    if (kind < 2) dmg_box_span(b, v3(-back, -half, -t - gap), v3(front, half, -gap));
    for (int s = -1; s <= 1 && kind == 2; s += 2) { /* a frame of bars */
        dmg_box_span(b, v3(-back, (float)s * 0.9f * half - 0.1f * half, -t - gap),
                     v3(front, (float)s * 0.9f * half + 0.1f * half, -gap));
        dmg_box_span(b, v3(s < 0 ? -back : front - 0.2f * half, -half, -t - gap),
                     v3(s < 0 ? -back + 0.2f * half : front, half, -gap));
    }
    if (kind == 2) dmg_box_span(b, v3(-back, -0.15f * half, -t - gap), v3(front, 0.15f * half, -gap));
    if (kind == 1) dmg_box_span(b, v3(-back, -half - t, -2 * t), v3(front, -half, 4 * t));
}

/* Lying or standing, so that -Y is down. */
static void lay_board(dmg_builder* b, float half) {
    dmg_move(b, 0, half, 0);
    if (dmg_chance(b, 0.4f)) dmg_face_up(b);
}

/* Draws the crank with its pin up to z = top: a web, a disc, a hand wheel; a knob to turn it by. */
static uint32_t draw_driver(dmg_builder* b, const dmg_crank* c, float top) {
    int web = dmg_int(b, 0, 3), wheel = dmg_int(b, 0, 3);
    float t = c->t;
    uint32_t crank = dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_vec pin = dmg_crank_pin(c, 0);
    dmg_rod(b, v3(0, 0, -0.3f * t), v3(0, 0, 0.9f * t), 0.6f * t);
    if (wheel == 0) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * t);
        dmg_wheel_draw(b, dmg_chance(b, 0.5f) ? 4 : 3, c->throw *1.4f, 0.5f * t, 6);
        dmg_restore(b);
    }
    dmg_web_draw(b, c, web, 0.3f * t, 0.5f * t);
    dmg_rod(b, v3(pin.x, pin.y, 0.7f * t), v3(pin.x, pin.y, top), 0.45f * t);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(pin.x, pin.y, top), v3(pin.x, pin.y, top + 2 * t), 0.7f * t);
    dmg_use(b, 0);
    return crank;
}

/* Draws a block on a rail or between two, driven by a rod that is the block's or the crank's. */
static void draw_slider_crank(dmg_builder* b) {
    dmg_crank c = dmg_crank_pick(b, dmg_scale_range(b, 0.02f, 0.4f));
    float t = c.t, s = t * dmg_range(b, 1.2f, 2.2f), in = c.rod - c.throw -s, out = c.rod + c.throw +s, z = 1.4f * t;
    int guide = dmg_int(b, 0, 3);
    bool crank_has = guide == 0 && dmg_chance(b, 0.5f), small = dmg_chance(b, 0.4f);
    lay_board(b, 1.5f * c.throw);
    draw_board(b, 1.5f * c.throw, out + s, 1.5f * c.throw, t);
    uint32_t crank = draw_driver(b, &c, z + 0.6f * t), slider = dmg_crank_slider(b, &c, small ? "slider" : "piston");
    float at = dmg_crank_at(&c, c.angle);
    if (guide == 3) {
        dmg_rod(b, v3(at - s, 0, z), v3(at + s, 0, z), 0.97f * s);
    } else
        dmg_box_span(b, v3(at - s, -0.6f * s, guide == 0 ? 0.42f * t : 0.05f * t), v3(at + s, 0.6f * s, z + 0.4f * t));
    dmg_rod(b, v3(at, 0, z), v3(at, 0, z + 0.8f * t), 0.4f * t);
    dmg_use(b, 0);
    if (guide == 0) dmg_box_span(b, v3(in - s, -0.4f * s, -0.1f * t), v3(out + s, 0.4f * s, 0.4f * t));
    for (int e = -1; e <= 1; e += 2) {
        if (guide == 1)
            dmg_box_span(b, v3(in, (float)e * 0.85f * s - 0.22f * s, -0.1f * t),
                         v3(out, (float)e * 0.85f * s + 0.22f * s, z));
        if (guide == 2)
            dmg_rod(b, v3(in, (float)e * 0.85f * s, 0.5f * z), v3(out, (float)e * 0.85f * s, 0.5f * z), 0.2f * s);
        if (guide == 2)
            dmg_box_span(b, v3(e < 0 ? in - t : out, -1.1f * s, -0.1f * t),
                         v3(e < 0 ? in : out + t, 1.1f * s, 0.8f * z));
    }
    if (guide == 3) {
        dmg_tube_draw(b, v3(in - 0.2f * s, 0, z), v3(1, 0, 0), out - in + 0.5f * s, s, 0.2f * s);
        for (int e = 0; e <= 1; ++e)
            dmg_box(b, v3(e ? out - s : in + s, 0, 0.5f * (z - 1.1f * s)),
                    v3(0.5f * s, s, fmaxf(0.05f * s, z - 1.1f * s)));
    }
    if (crank_has) {
        float swing = dmg_range(b, 0.3f, 1.2f);
        dmg_hinge(b, crank, "rod", dmg_crank_pin(&c, z), v3(0, 0, dmg_sign(b)), -swing, swing);
        dmg_link_draw(b, &c, v3(at, 0, z + t), dmg_crank_pin(&c, z + t));
    } else
        dmg_crank_rod(b, &c, slider, z + t);
    dmg_use(b, 0);
}

/* Draws the pin in a yoke's slot: what holds the slot slides, straight as the rod it is on. */
static void draw_scotch_yoke(dmg_builder* b) {
    dmg_crank c = dmg_crank_pick(b, dmg_scale_range(b, 0.02f, 0.4f));
    float t = c.t, r = c.throw, half = r + 1.2f * t, at = r * cosf(c.angle), z = 1.5f * t,
          reach = r * dmg_range(b, 2.2f, 3.5f), bar = 0.35f * t;
    bool both = dmg_chance(b, 0.6f);
    lay_board(b, 1.6f * r + t);
    draw_board(b, both ? reach + r : 1.6f * r + t, reach + r, 1.6f * r + t, t);
    draw_driver(b, &c, z + 0.3f * t);
    dmg_slide(b, 0, "yoke", v3(1, 0, 0), -r - at, r - at);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3(at + (float)s * 0.8f * t, 0, z), v3(0.6f * t, 2 * half, 0.7f * t));
        dmg_box(b, v3(at, (float)s * half, z), v3(2.2f * t, 0.6f * t, 0.7f * t));
        if (s > 0 || both)
            dmg_rod(b, v3(at + (float)s * 0.8f * t, 0, z), v3(at + (float)s * (reach + 0.6f * r), 0, z), bar);
    }
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(at + reach + 0.6f * r, 0, z), v3(at + reach + 0.6f * r + t, 0, z), 1.5f * t);
    dmg_use(b, 0);
    for (int s = both ? -1 : 1; s <= 1; s += 2) { /* the guides */
        float x = (float)s * (0.6f * reach + 0.6f * r);
        dmg_tube_draw(b, v3(x - 0.5f * t, 0, z), v3(1, 0, 0), t, 1.1f * bar, 0.5f * t);
        dmg_box(b, v3(x, 0, 0.5f * (z - 1.1f * bar - 0.3f * t)), v3(t, 1.2f * t, z - 1.1f * bar - 0.2f * t));
    }
}

/* Draws the pin in a slotted lever that turns about its own pin below and pushes a ram above: a shaper's drive. */
static void draw_quick_return(dmg_builder* b) {
    dmg_crank c = dmg_crank_pick(b, dmg_scale_range(b, 0.02f, 0.4f));
    float t = c.t, r = c.throw, below = r * dmg_range(b, 1.6f, 2.4f), top = r * dmg_range(b, 1.6f, 2.2f), z = 1.5f * t,
          most = asinf(r / below), now = atan2f(-r * sinf(c.angle), below + r * cosf(c.angle)), length = below + top;
    bool ram = dmg_chance(b, 0.7f);
    dmg_move(b, 0, below + 2 * t, 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI); /* +X is up */
    dmg_box_span(b, v3(-below - 2 * t, -1.4f * r - t, -t), v3(top + 2.5f * t, 1.4f * r + t, -0.05f * t));
    dmg_box_span(b, v3(-below - 2 * t, -1.4f * r - t, -3 * t), v3(-below - 1.5f * t, 1.4f * r + t, 4 * t));
    dmg_rod(b, v3(-below, 0, -t), v3(-below, 0, z), 0.5f * t);
    draw_driver(b, &c, z + 0.3f * t);
    dmg_hinge(b, 0, "lever", v3(-below, 0, 0), v3(0, 0, -1), -most - now, most - now);
    dmg_save(b);
    dmg_move(b, -below, 0, z);
    dmg_turn(b, v3(0, 0, 1), -now);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0.5f * length, (float)s * 0.8f * t, 0), v3(length, 0.5f * t, 0.7f * t));
    dmg_rod(b, v3(0, 0, -0.35f * t), v3(0, 0, 0.35f * t), 1.1f * t);
    dmg_box(b, v3(length, 0, 0), v3(0.6f * t, 2.1f * t, 0.7f * t));
    dmg_restore(b);
    dmg_use(b, 0);
    if (!ram) return;
    float x = top + 1.2f * t, way = length * sinf(most);
    dmg_box_span(b, v3(x - 0.5f * t, -1.4f * r, -0.1f * t), v3(x + 0.5f * t, 1.4f * r, 0.5f * t));
    dmg_slide(b, 0, "ram", v3(0, -1, 0), -way - length * sinf(now), way - length * sinf(now));
    float y = -length * sinf(now), wide = r * dmg_range(b, 1.5f, 2.5f);
    dmg_box_span(b, v3(x - 0.7f * t, y - wide, 0.55f * t), v3(x + 0.7f * t, y + wide, z - 0.45f * t));
    dmg_box_span(b, v3(x - 2 * t, y - wide - 0.8f * t, 0.55f * t), v3(x + 0.7f * t, y - wide, z));
    dmg_use(b, 0);
}

/* ---- cams ---- */

enum { CAM_POINTS = 48 };

typedef struct cam {
    dmg_xy at[CAM_POINTS];
} cam;

static cam pick_cam(dmg_builder* b, float base, float lift) {
    cam c;
    int kind = dmg_int(b, 0, 4), lobes = dmg_int(b, 2, 4);
    float turn = dmg_range(b, 0.0f, 2.0f * DMG_PI), power = dmg_range(b, 1.0f, 3.0f);
    for (int i = 0; i < CAM_POINTS; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / CAM_POINTS, rise = 0;
        if (kind == 0) rise = 0.5f + 0.5f * cosf(angle);
        if (kind == 1) rise = powf(fmaxf(0.0f, cosf(angle)), power);
        if (kind == 2) rise = 0.5f + 0.5f * cosf((float)lobes * angle);
        if (kind == 3) rise = angle / (2.0f * DMG_PI);
        if (kind == 4) rise = fabsf(angle - DMG_PI) / DMG_PI;
        c.at[i] = (dmg_xy){(base + lift * rise) * cosf(angle + turn), (base + lift * rise) * sinf(angle + turn)};
    }
    return c;
}

/* How far the cam, turned by `angle`, reaches along +X. */
static float cam_reach(const cam* c, float angle) {
    float best = 0;
    for (int i = 0; i < CAM_POINTS; ++i) best = fmaxf(best, c->at[i].x * cosf(angle) - c->at[i].y * sinf(angle));
    return best;
}

static void cam_span(const cam* c, float* low, float* high) {
    *low = *high = cam_reach(c, 0);
    for (int i = 1; i < CAM_POINTS; ++i) {
        float reach = cam_reach(c, 2.0f * DMG_PI * (float)i / CAM_POINTS);
        *low = fminf(*low, reach);
        *high = fmaxf(*high, reach);
    }
}

/* Draws what a follower carries up through the deck: a knob, a block, a puppet, a bird, nothing. */
static void draw_figure_top(dmg_builder* b, float x, float s) {
    int kind = dmg_int(b, 0, 4);
    if (kind == 1) dmg_rod(b, v3(x, 0, 0), v3(x + 0.6f * s, 0, 0), 0.6f * s);
    if (kind == 2) dmg_box(b, v3(x + 0.5f * s, 0, 0), v3(s, s, s));
    if (kind == 3) {
        dmg_cone(b, v3(x, 0, 0), v3(x + 1.4f * s, 0, 0), 0.6f * s, 0.25f * s);
        dmg_ellipsoid(b, v3(x + 1.7f * s, 0, 0), v3(0.4f * s, 0.4f * s, 0.4f * s));
        dmg_box(b, v3(x + 1.1f * s, 0, 0), v3(0.2f * s, 1.8f * s, 0.2f * s));
    }
    if (kind == 4) {
        dmg_ellipsoid(b, v3(x + 0.5f * s, 0, 0), v3(0.5f * s, 0.9f * s, 0.45f * s));
        dmg_cone(b, v3(x + 0.9f * s, 0.8f * s, 0), v3(x + 1.0f * s, 1.4f * s, 0), 0.25f * s, 0.03f * s);
    }
}

/* Over the cam at z: a rod with a foot or roller that slides, or a lever that rests on it and tips. */
static void draw_follower(dmg_builder* b, const cam* c, float deck, float t, float thick) {
    float low, high, at = cam_reach(c, 0), foot = thick * dmg_range(b, 0.3f, 0.6f), length = high = low = 0;
    cam_span(c, &low, &high);
    int kind = dmg_weighted(b, (const float[]){0.4f, 0.3f, 0.3f}, 3);
    if (kind == 2) {
        length = high * dmg_range(b, 1.5f, 2.5f);
        float side = dmg_sign(b), beyond = dmg_range(b, 0.2f, 1.0f) * high;
        dmg_vec pin = {at + foot, side * length, 0};
        dmg_hinge(b, 0, "follower", pin, v3(0, 0, side), (low - at) / length, (high - at) / length);
        if (side > 0) {
            dmg_joint* joint = &b->parts[b->part_count - 1].joint; /* the tip rises with a turn from +Y to +X */
            joint->axis[0] = -joint->axis[0];
            joint->axis[1] = -joint->axis[1];
            joint->axis[2] = -joint->axis[2];
        }
        dmg_beam(b, pin, v3(pin.x, -side * beyond, 0), thick * 0.7f, 2 * foot);
        dmg_rod(b, v3_add(pin, v3(0, 0, -0.5f * thick)), v3_add(pin, v3(0, 0, 0.5f * thick)), 1.2f * foot);
        dmg_use(b, 0);
        return;
    }
    uint32_t rod = dmg_slide(b, 0, "follower", v3(1, 0, 0), low - at, high - at);
    float from = at, top = deck + (at - low) + t * dmg_range(b, 0.5f, 3.0f);
    if (kind == 1) {
        float r = 0.7f * thick;
        from = at + r;
        if (dmg_chance(b, 0.6f)) dmg_spin(b, rod, "roller", v3(from, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(from, 0, -0.5f * thick), v3(from, 0, 0.5f * thick), r);
        dmg_use(b, rod);
    } else {
        dmg_rod(b, v3(from, 0, 0), v3(from + foot, 0, 0), 0.9f * thick);
    }
    dmg_rod(b, v3(from, 0, 0), v3(top, 0, 0), 0.3f * t);
    draw_figure_top(b, top, 1.5f * t);
    dmg_use(b, 0);
}

/* A shaft with cams in a box open in front or between two posts, a handle at its end; followers through the deck. */
static void draw_cams(dmg_builder* b) {
    float base = dmg_scale_range(b, 0.01f, 0.15f), lift = base * dmg_range(b, 0.3f, 1.2f),
          thick = base * dmg_range(b, 0.3f, 0.8f), t = 0.35f * base, reach = base + lift,
          pitch = fmaxf(2.2f * thick, 1.6f * t) * dmg_range(b, 1.2f, 2.5f);
    int count = dmg_int(b, 1, 5), handle = dmg_int(b, 0, 2);
    float half = 0.5f * pitch * (float)count + t, deck = reach + base * dmg_range(b, 0.8f, 1.6f), deep = 1.15f * reach;
    bool box = dmg_chance(b, 0.5f);
    dmg_move(b, 0, deep + t, 0);
    if (dmg_chance(b, 0.6f)) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    float wide = box ? deep : dmg_range(b, 0.3f, 1.0f) * deep;
    dmg_box_span(b, v3(-deep - t, -1.2f * deep, -half - t), v3(-deep, 1.2f * deep, half + t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-deep, -wide, (float)s * (half + 0.5f * t) - 0.5f * t),
                     v3(deck, wide, (float)s * (half + 0.5f * t) + 0.5f * t));
    if (box) dmg_box_span(b, v3(-deep, deep, -half - t), v3(deck, deep + 0.3f * t, half + t));
    dmg_box_span(b, v3(deck, -wide, -half - t), v3(deck + 0.2f * t, wide, half + t));
    cam cams[5];
    dmg_spin(b, 0, "camshaft", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_rod(b, v3(0, 0, -half - 1.5f * t), v3(0, 0, half + 2.5f * t), 0.35f * t);
    if (handle == 0) dmg_beam(b, v3(0, 0, half + 2 * t), v3(0.9f * deep, 0, half + 2 * t), 0.5f * t, 0.5f * t);
    if (handle == 0) dmg_rod(b, v3(0.9f * deep, 0, half + 2 * t), v3(0.9f * deep, 0, half + 4 * t), 0.4f * t);
    dmg_save(b);
    dmg_move(b, 0, 0, half + 2 * t);
    if (handle == 1) dmg_wheel_draw(b, 3, 0.8f * deep, 0.6f * t, 5);
    dmg_restore(b);
    for (int i = 0; i < count; ++i) {
        cams[i] = pick_cam(b, base, lift);
        float z = ((float)i - 0.5f * (float)(count - 1)) * pitch;
        dmg_extrude(b, cams[i].at, CAM_POINTS, z - 0.5f * thick, z + 0.5f * thick);
    }
    dmg_use(b, 0);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, 0, 0, ((float)i - 0.5f * (float)(count - 1)) * pitch);
        draw_follower(b, &cams[i], deck, t, thick);
        dmg_restore(b);
    }
}

void dmg_build_crank_bench(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){0.3f, 0.15f, 0.15f, 0.4f}, 4);
    if (kind == 0) draw_slider_crank(b);
    if (kind == 1) draw_scotch_yoke(b);
    if (kind == 2) draw_quick_return(b);
    if (kind == 3) draw_cams(b);
}
