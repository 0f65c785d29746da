/* Draws the controls on a cycle's or motorcycle's bar: brake and clutch levers, twist grips, shifters, a bell,
 * switch pods. The rider is at -Z; each half of the bar has its own frame, +X outwards along the grip. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

typedef struct bar {
    float r, grip; /* of the tube, length of the grip */
    float droop;   /* of the levers below the level */
    bool motor;
} bar;

/* Draws a clamp with a perch ahead, the lever on a hidden pin in it, curved along the grip. */
static void draw_brake(dmg_builder* b, const bar* c, const char* name) {
    float r = c->r, x = -dmg_range(b, 1.0f, 3.0f) * r, ahead = r * dmg_range(b, 2.2f, 3.2f),
          reach = r * dmg_range(b, 3.2f, 4.6f),
          long_way = c->grip * (c->motor ? dmg_range(b, 1.0f, 1.25f) : dmg_range(b, 0.55f, 1.0f)),
          pull = dmg_range(b, 0.15f, 0.35f), curl = r * dmg_range(b, -0.6f, 1.2f);
    bool ball = c->motor || dmg_chance(b, 0.5f), reservoir = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), c->droop);
    dmg_rod(b, v3(x - r, 0, 0), v3(x + r, 0, 0), 1.5f * r);
    dmg_rounded_box(b, v3(x, 0, 0.6f * ahead), v3(2.4f * r, 1.3f * r, 1.1f * ahead), 0.4f * r);
    if (reservoir) dmg_rod(b, v3(x - 2 * r, 0, 0.5f * ahead), v3(x - 2 * r, 2.5f * r, 0.5f * ahead), 1.4f * r);
    dmg_hinge(b, 0, name, v3(x, 0, ahead), v3(0, 1, 0), 0.0f, pull);
    dmg_bent n = dmg_bent_between(v3(x - 0.3f * r, 0, ahead), v3(x + long_way, 0, reach + curl), v3(0, 0, 0),
                                  v3(0, 1, 0), 0.55f * r, 0.4f * r);
    n.control[1] = v3(x + 0.25f * long_way, 0, reach * 1.15f);
    n.control[2] = v3(x + 0.6f * long_way, 0, reach * 0.85f);
    n.wide[1] *= dmg_range(b, 0.8f, 1.3f);
    n.columns = 12;
    n.round[0] = n.round[1] = 0.06f;
    dmg_bent_draw(b, &n);
    if (ball) dmg_ellipsoid(b, n.control[3], v3(0.75f * r, 0.75f * r, 0.75f * r));
    dmg_use(b, 0);
    dmg_restore(b);
}

/* Draws what turns about the bar: the whole grip, or a ring at its inner end. */
static void draw_grips(dmg_builder* b, const bar* c, bool twists) {
    float r = 1.35f * c->r, collar = r * dmg_range(b, 1.2f, 1.5f), ring = c->grip * dmg_range(b, 0.2f, 0.4f),
          turn = dmg_range(b, 0.8f, 1.8f);
    bool whole = c->motor || dmg_chance(b, 0.4f);
    int ribs = dmg_int(b, 0, 6);
    float from = twists && !whole ? ring + 0.03f * c->grip : 0.0f;
    for (int i = 0; i < 2; ++i) { /* the ring and what stays, or all in one */
        bool moves = twists && (whole ? i == 1 : i == 0);
        if ((i == 0) != (twists && !whole) && i == 0) continue;
        float low = i ? from : 0.0f, high = i ? c->grip : ring;
        if (moves) dmg_hinge(b, 0, "twist_grip", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, turn);
        dmg_bent n = dmg_bent_between(v3(low, 0, 0), v3(high, 0, 0), v3(0, 0, 0), v3(0, 0, 1), r, r);
        n.wide[0] = n.deep[0] = i ? 1.1f * r : collar;
        n.round[0] = n.round[1] = 0.06f;
        n.columns = 14;
        n.rows = 12;
        dmg_bent_draw(b, &n);
        for (int k = 0; k < ribs; ++k) {
            dmg_save(b);
            dmg_turn_to(b, v3(1, 0, 0), k, ribs);
            dmg_box(b, v3(0.5f * (low + high), r, 0), v3(0.7f * (high - low), 0.2f * r, 0.25f * r));
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
}

/* Below or above the bar: a pod with one or two paddles for the thumb. */
static void draw_shifter(dmg_builder* b, const bar* c, const char* name, bool above) {
    float r = c->r, x = -dmg_range(b, 3.0f, 4.5f) * r, push = dmg_range(b, 0.3f, 0.7f),
          around = dmg_range(b, 0.3f, 0.9f), long_way = r * dmg_range(b, 2.2f, 3.5f),
          cap = r * dmg_range(b, 1.0f, 1.6f);
    int paddles = above ? 1 : dmg_int(b, 1, 2);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), above ? -around : DMG_PI + around); /* +Y out of the bar */
    dmg_rod(b, v3(x - 0.7f * r, 0, 0), v3(x + 0.7f * r, 0, 0), 1.4f * r);
    dmg_cone(b, v3(x, r, 0), v3(x, 2.4f * r, 0), cap, 0.9f * cap);
    for (int i = 0; i < paddles; ++i) {
        float y = r * (2.55f - 0.5f * (float)i), side = i ? -0.6f : 0.3f;
        dmg_hinge(b, 0, name, v3(x, y, 0), v3(0, i ? 1.0f : -1.0f, 0), 0.0f, push);
        dmg_bent n = dmg_bent_between(v3(x, y, 0), v3(x + 0.8f * long_way, y + 0.3f * r, side * long_way), v3(0, 0, 0),
                                      v3(0, 1, 0), 0.2f * r, 0.5f * r);
        n.deep[2] *= 1.4f;
        n.rows = n.columns = 12;
        dmg_bent_draw(b, &n);
        dmg_rod(b, v3(x, y - 0.22f * r, 0), v3(x, y + 0.22f * r, 0), 0.6f * r);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Draws a dome on a clamp; struck by a little hammer, or its cap is turned. */
static void draw_bell(dmg_builder* b, const bar* c, float x) {
    float r = c->r * dmg_range(b, 1.6f, 2.6f), base = 1.5f * c->r, lean = dmg_range(b, -0.6f, 0.6f);
    bool turned = dmg_chance(b, 0.3f);
    dmg_save(b);
    dmg_move(b, x, 0, 0);
    dmg_turn(b, v3(1, 0, 0), lean);
    dmg_rod(b, v3(-0.5f * c->r, 0, 0), v3(0.5f * c->r, 0, 0), 1.3f * c->r);
    dmg_rod(b, v3(0, c->r, 0), v3(0, base + 0.1f * r, 0), 0.9f * r);
    if (turned) dmg_hinge(b, 0, "bell", v3(0, base, 0), v3(0, 1, 0), 0.0f, 1.5f);
    dmg_dome(b, v3(0, base + 0.2f * r, 0), v3(r, 0.8f * r, r));
    if (turned) dmg_box(b, v3(0, base + 0.3f * r, -1.05f * r), v3(0.3f * r, 0.2f * r, 0.3f * r));
    dmg_use(b, 0);
    if (!turned) {
        dmg_hinge(b, 0, "striker", v3(0.6f * r, base, -0.9f * r), v3(0, -1, 0), 0.0f, dmg_range(b, 0.3f, 0.8f));
        dmg_beam(b, v3(0.4f * r, base + 0.05f * r, -0.9f * r), v3(1.7f * r, base + 0.05f * r, -1.1f * r), 0.12f * r,
                 0.2f * r);
        dmg_ellipsoid(b, v3(1.7f * r, base + 0.1f * r, -1.1f * r), v3(0.25f * r, 0.2f * r, 0.2f * r));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* Draws a pod round the bar with rockers and buttons to the thumb, a choke lever below. */
static void draw_switch_pod(dmg_builder* b, const bar* c, bool right) {
    float r = c->r, from = -5.5f * r, to = -1.5f * r, fat = r * dmg_range(b, 1.8f, 2.3f);
    const float rear = DMG_PI; /* the angle to the rider */
    bool choke = !right && dmg_chance(b, 0.6f);
    dmg_bent n =
        dmg_bent_between(v3(from, 0, 0), v3(to, 0, 0), v3(0, 0, 0), v3(0, 0, 1), fat, fat * dmg_range(b, 1.0f, 1.3f));
    n.power = dmg_range(b, 2.0f, 3.5f);
    n.round[0] = n.round[1] = 0.15f;
    n.rows = n.columns = 28;
    dmg_window top = dmg_bent_open(&n, 0.5f, rear - 0.75f, 0.35f, 0.5f, 0.5f * r),
               low = dmg_bent_open(&n, 0.5f, rear + 0.65f, 0.3f, 0.5f, 0.5f * r);
    dmg_bent_draw(b, &n);
    dmg_bent_key_draw(b, &n, &top, 0, right ? "kill_switch" : "dip_switch", right ? DMG_KEY_ROCK_ASIDE : DMG_KEY_ROCK);
    dmg_bent_key_draw(b, &n, &low, 0, right ? "starter" : "horn", DMG_KEY_PRESS);
    dmg_bent_stand(b, &n, 0.5f, rear, 0);
    if (!right) dmg_bat_draw(b, 0, "indicator", 0.8f * r);
    dmg_restore(b);
    if (!choke) return;
    dmg_hinge(b, 0, "choke", v3(to, 0, 0), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
    dmg_rod(b, v3(to + 0.05f * r, 0, 0), v3(to + 0.5f * r, 0, 0), 1.5f * r);
    dmg_beam(b, v3(to + 0.28f * r, -r, 0), v3(to + 0.28f * r, -2.6f * r, -1.5f * r), 0.4f * r, 0.6f * r);
    dmg_use(b, 0);
}

/* Draws one half, drawn as the right one. */
static void draw_half(dmg_builder* b, const bar* c, bool right) {
    bool shifts = dmg_chance(b, 0.6f), above = dmg_chance(b, 0.3f);
    draw_brake(b, c, right || !c->motor ? "brake" : "clutch");
    draw_grips(b, c, c->motor ? right : !shifts && dmg_chance(b, 0.5f));
    if (c->motor)
        draw_switch_pod(b, c, right);
    else if (shifts)
        draw_shifter(b, c, right ? "shifter" : "dropper", above);
    if (c->motor && dmg_chance(b, 0.5f)) { /* a mirror on its stem's ball */
        float r = c->r;
        dmg_vec ball = v3(-r, 9 * r, 3 * r);
        dmg_rod(b, v3(-2 * r, 0, 1.5f * r), v3(-2 * r, 3 * r, 2 * r), 0.35f * r);
        dmg_rod(b, v3(-2 * r, 3 * r, 2 * r), ball, 0.35f * r);
        dmg_hinge(b, 0, "mirror", ball, v3(0, 1, 0), -0.4f, 0.4f);
        dmg_ellipsoid(b, v3(ball.x, ball.y, ball.z - 0.8f * r), v3(4 * r, 2.5f * r, 0.8f * r));
        dmg_use(b, 0);
    }
}

void dmg_build_bike_controls(dmg_builder* b) {
    bar c = {.r = dmg_range(b, 0.01f, 0.013f)};
    c.motor = dmg_chance(b, 0.4f);
    c.grip = dmg_range(b, 0.1f, 0.14f);
    c.droop = dmg_range(b, 0.1f, 0.8f);
    float wide = dmg_range(b, 0.26f, 0.36f) - c.grip, rise = dmg_range(b, 0.0f, 0.08f),
          sweep = dmg_range(b, 0.05f, 0.5f), back = wide * dmg_range(b, 0.0f, 0.3f), high = dmg_range(b, 0.1f, 0.3f),
          stem = dmg_range(b, 0.02f, 0.12f);
    bool bell = !c.motor && dmg_chance(b, 0.7f), single = dmg_chance(b, 0.2f);
    dmg_move(b, 0, high, 0);
    dmg_rod(b, v3(-2 * c.r, 0, 0), v3(2 * c.r, 0, 0), 1.7f * c.r);
    dmg_beam(b, v3(0, 0, 0), v3(0, -0.2f * high, -stem), 3 * c.r, 2.5f * c.r);
    dmg_rod(b, v3(0, -high, -stem), v3(0, 0.1f * high, -stem), 1.6f * c.r);
    for (int s = 0; s < (single ? 1 : 2); ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        dmg_vec root = v3(wide, rise, -back);
        dmg_vec out = v3(cosf(sweep), 0, -sinf(sweep));
        const dmg_vec path[] = {
            {0, 0, 0}, {0.25f * wide, 0, 0}, v3_mad(root, out, -7 * c.r), root, v3_mad(root, out, 1.02f * c.grip)};
        dmg_sweep(b, path, 5, c.r, c.r, false);
        if (bell && !s) draw_bell(b, &c, 0.2f * wide);
        dmg_move(b, root.x, root.y, root.z);
        dmg_turn(b, v3(0, 1, 0), sweep);
        draw_half(b, &c, !s);
        dmg_restore(b);
    }
}
