/* Draws parallel robots, whose plate is moved by several legs at once: deltas, hexapods, five-bars. Each leg is a
 * tree of its own, as robot description files cut the loops. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct parallel {
    float base, plate, high, t; /* radii, distance, thickness */
    int legs, rod;
} parallel;

static void draw_plate(dmg_builder* b, int kind, float radius, float t, int corners) {
    dmg_xy outline[6];
    int count = corners < 3 ? 4 : corners;
    for (int i = 0; i < count; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)count + 0.5f * DMG_PI;
        outline[i] = (dmg_xy){1.25f * radius * cosf(angle), 1.25f * radius * sinf(angle)};
    }
    if (kind == 0) dmg_rod(b, v3(0, -0.5f * t, 0), v3(0, 0.5f * t, 0), radius);
    if (kind == 1) dmg_torus(b, v3(0, 0, 0), v3(0, 1, 0), radius, 0.6f * t);
    if (kind == 2) {
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_extrude(b, outline, count, -0.5f * t, 0.5f * t);
        dmg_restore(b);
    }
}

static void draw_ball_rod(dmg_builder* b, int kind, dmg_vec from, dmg_vec to, float t) {
    dmg_rod(b, from, to, 0.25f * t);
    for (int i = 0; i < 2 && kind; ++i) {
        float r = (kind == 1 ? 0.5f : 0.35f) * t;
        dmg_ellipsoid(b, i ? to : from, v3(r, r, r));
    }
}

/* Arms that turn at the base above and carry two rods each; or carriages on pillars. The plate below goes up and down.
 */
static void draw_delta(dmg_builder* b, const parallel* p) {
    bool pillars = dmg_chance(b, 0.35f), carried = dmg_chance(b, 0.5f);
    float arm = p->base * dmg_range(b, 0.5f, 1.1f), lean = dmg_range(b, -0.6f, 0.8f), top = 1.4f * p->high,
          half = 0.5f * p->plate, reach = p->base + (pillars ? 0.0f : arm * cosf(lean)),
          elbow_y = top - (pillars ? 0.3f * p->high : arm * sinf(lean)),
          low = elbow_y - p->high * dmg_range(b, 0.6f, 0.9f), swing = dmg_range(b, 0.4f, 1.0f);
    int kind = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, 0, pillars ? 1.15f * top : top + 0.5f * p->t, 0);
    draw_plate(b, kind, p->base, 1.5f * p->t, p->legs);
    dmg_restore(b);
    if (pillars) dmg_rod(b, v3(0, 0, 0), v3(0, p->t, 0), p->base);
    for (int i = 0; i < p->legs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, p->legs);
        uint32_t carrier = 0;
        if (pillars) {
            dmg_box(b, v3(p->base, 0.58f * top, 0), v3(p->t, 1.16f * top, 1.5f * p->t));
            carrier = dmg_slide(b, 0, "carriage", v3(0, 1, 0), -0.2f * p->high, 0.35f * p->high);
            dmg_box(b, v3(p->base - 0.8f * p->t, elbow_y, 0), v3(p->t, 2 * p->t, p->plate));
            reach = p->base - 1.3f * p->t;
        } else {
            dmg_rod(b, v3(p->base, top, -p->t), v3(p->base, top, p->t), 0.9f * p->t);
            carrier = dmg_hinge(b, 0, "arm", v3(p->base, top, 0), v3(0, 0, dmg_sign(b)), -swing, swing);
            dmg_beam(b, v3(p->base, top, 0), v3(reach, elbow_y, 0), 1.2f * p->t, 0.9f * p->t);
            dmg_rod(b, v3(reach, elbow_y, -half), v3(reach, elbow_y, half), 0.3f * p->t);
        }
        for (int s = -1; s <= 1; s += 2) {
            dmg_vec from = {reach, elbow_y, (float)s * half}, to = {p->plate, low, (float)s * half};
            if (carried && s < 0)
                dmg_hinge(b, carrier, "rod", v3(reach, elbow_y, 0), v3(0, 0, dmg_sign(b)), -0.3f, 0.5f);
            draw_ball_rod(b, p->rod, from, to, p->t);
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
    dmg_move(b, 0, low, 0);
    uint32_t plate = dmg_slide(b, 0, "effector", v3(0, dmg_sign(b), 0), -0.2f * p->high, 0.2f * p->high);
    draw_plate(b, kind, 1.1f * p->plate, 0.6f * p->t, p->legs);
    if (dmg_chance(b, 0.6f)) dmg_spin(b, plate, "tool", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -2 * p->t, 0), v3(0, 0, 0), 0.7f * p->t);
    dmg_box(b, v3(0.4f * p->t, -2.3f * p->t, 0), v3(1.6f * p->t, 0.8f * p->t, 0.8f * p->t));
    dmg_use(b, 0);
}

/* Six cylinders between two plates; each rod slides in its cylinder, each cylinder turns at the base. */
static void draw_hexapod(dmg_builder* b, const parallel* p) {
    float twist = dmg_range(b, 0.3f, 0.8f), y = 0.5f * p->t, top = p->high + y, share = dmg_range(b, 0.45f, 0.65f);
    int kind = dmg_int(b, 0, 2), legs = p->legs == 3 ? 6 : p->legs;
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    draw_plate(b, kind, 1.15f * p->base, p->t, legs);
    dmg_restore(b);
    for (int i = 0; i < legs; ++i) {
        float pair = i % 2 ? 1.0f : -1.0f, angle = 2.0f * DMG_PI * (float)(i / 2) / (0.5f * (float)legs),
              a = angle + 0.3f * pair, c = angle + (0.3f + twist) * pair;
        dmg_vec foot = {p->base * cosf(a), 1.5f * p->t, p->base * sinf(a)},
                head = {p->plate * cosf(c), top, p->plate * sinf(c)};
        dmg_vec mid = v3_lerp(foot, head, share), along = v3_normalize(v3_sub(head, foot));
        float length = v3_length(v3_sub(head, foot));
        dmg_box(b, v3_add(foot, v3(0, -0.6f * p->t, 0)), v3(1.3f * p->t, p->t, 1.3f * p->t));
        uint32_t leg = 0;
        if (dmg_chance(b, 0.6f))
            leg = dmg_hinge(b, 0, "leg", foot, v3_normalize(v3_cross(along, v3(0, 1, 0.1f))), -0.25f, 0.25f);
        else
            dmg_use(b, 0);
        dmg_rod(b, foot, mid, 0.6f * p->t);
        if (p->rod) dmg_ellipsoid(b, foot, v3(0.7f * p->t, 0.7f * p->t, 0.7f * p->t));
        dmg_slide(b, leg, "rod", along, -0.3f * share * length, 0.4f * share * length);
        dmg_rod(b, v3_mad(mid, along, -0.5f * share * length), head, 0.3f * p->t);
        if (p->rod) dmg_ellipsoid(b, head, v3(0.6f * p->t, 0.6f * p->t, 0.6f * p->t));
        dmg_use(b, 0);
    }
    dmg_move(b, 0, top + 0.5f * p->t, 0);
    int moves = dmg_int(b, 0, 2);
    if (moves == 0) dmg_slide(b, 0, "platform", v3(0, 1, 0), -0.2f * p->high, 0.25f * p->high);
    if (moves == 1) dmg_hinge(b, 0, "platform", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -0.35f, 0.35f);
    if (moves == 2) dmg_hinge(b, 0, "platform", v3(0, 0, 0), v3(0, 1, 0), -0.5f, 0.5f);
    draw_plate(b, kind, 1.15f * p->plate, p->t, legs);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, 0.6f * p->plate, 0), v3(p->plate, p->plate, p->plate));
    dmg_use(b, 0);
}

/* Draws two motors on a bar, two arms, two forearms that meet; lying or upright. */
static void draw_five_bar(dmg_builder* b, const parallel* p) {
    float arm = p->base * dmg_range(b, 0.7f, 1.1f), gap = 0.5f * p->base, t = p->t, out = dmg_range(b, 0.3f, 1.1f);
    bool upright = dmg_chance(b, 0.4f);
    dmg_move(b, 0, upright ? 3 * p->base : 0, 0);
    if (upright) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_box(b, v3(0, 0.5f * t, 0), v3(2 * gap + 4 * t, t, 3 * t));
    dmg_vec meet = {0, 2.6f * t, arm * cosf(out) + 1.2f * p->base};
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_vec motor = {side * gap, 1.5f * t, 0}, elbow = {side * (gap + arm * sinf(out)), 1.5f * t, arm * cosf(out)};
        dmg_rod(b, v3(motor.x, t, 0), v3(motor.x, 1.2f * t, 0), t);
        uint32_t upper = dmg_hinge(b, 0, "arm", motor, v3(0, dmg_sign(b), 0), -0.7f, 0.7f);
        dmg_rod(b, v3_add(motor, v3(0, -0.3f * t, 0)), v3_add(motor, v3(0, 0.5f * t, 0)), 0.8f * t);
        dmg_beam(b, motor, elbow, 1.2f * t, 0.5f * t);
        uint32_t fore = dmg_hinge(b, upper, "forearm", elbow, v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
        dmg_rod(b, v3_add(elbow, v3(0, -0.4f * t, 0)), v3_add(elbow, v3(0, 1.2f * t, 0)), 0.5f * t);
        float layer = s > 0 ? 0.0f : 0.5f * t;
        dmg_beam(b, v3(elbow.x, 2.2f * t + layer, elbow.z), v3(meet.x, 2.2f * t + layer, meet.z), t, 0.4f * t);
        if (s > 0) {
            if (dmg_chance(b, 0.6f)) dmg_slide(b, fore, "pen", v3(0, -1, 0), 0.0f, t);
            dmg_rod(b, v3(meet.x, 0.8f * t, meet.z), v3(meet.x, 5 * t, meet.z), 0.35f * t);
        }
        dmg_use(b, 0);
    }
}

void dmg_build_parallel_robot(dmg_builder* b) {
    parallel p = {.base = dmg_scale_range(b, 0.05f, 1.0f)};
    p.legs = dmg_chance(b, 0.7f) ? 3 : 4;
    p.rod = dmg_int(b, 0, 2);
    p.plate = p.base * dmg_range(b, 0.25f, 0.7f);
    p.high = p.base * dmg_range(b, 0.9f, 2.5f);
    p.t = p.base * dmg_range(b, 0.06f, 0.16f);
    int kind = dmg_int(b, 0, 4);
    if (kind < 2) draw_delta(b, &p);
    if (kind == 2 || kind == 3) {
        p.plate = p.base * dmg_range(b, 0.5f, 0.9f);
        draw_hexapod(b, &p);
    }
    if (kind == 4) draw_five_bar(b, &p);
}
