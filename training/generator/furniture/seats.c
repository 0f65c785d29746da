/* Draws office chairs, stools and beds on wheels: a seat may turn, rise or tilt as one piece; casters have two
 * wheels each. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- casters ---- */

typedef struct caster_style {
    float wheel, width, trail;
    int hood; /* none, half a drum, a block, a fork */
    bool split, swivels, one_roll;
} caster_style;

static caster_style pick_caster(dmg_builder* b, float wheel) {
    caster_style c = {.wheel = wheel, .hood = dmg_int(b, 0, 3)};
    c.width = wheel * dmg_range(b, 0.25f, 0.6f);
    c.trail = wheel * dmg_range(b, 0.2f, 0.9f);
    c.split = dmg_chance(b, 0.7f);    /* a wheel either side of the stem, each turning on its own */
    c.swivels = dmg_chance(b, 0.85f); /* else the wheels roll on the foot itself */
    c.one_roll = dmg_chance(b, 0.3f); /* both wheels are one part */
    return c;
}

/* Below the stem at the origin's (x, z), which ends at y = top. */
static void draw_twin_caster(dmg_builder* b, const caster_style* c, float top, float heading) {
    float r = c->wheel, apart = c->split ? 0.55f * c->width + 0.08f * r : 0.0f;
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), heading);
    uint32_t fork = c->swivels ? dmg_spin(b, 0, "caster", v3(0, 0, 0), v3(0, 1, 0)) : 0;
    dmg_rod(b, v3(0, r, 0), v3(0, top, 0), 0.18f * r);
    if (c->hood == 1) dmg_dome(b, v3(0, 1.05f * r, -c->trail), v3(apart + c->width, 1.08f * r, 1.1f * r));
    if (c->hood == 2) dmg_box(b, v3(0, 1.5f * r, -0.5f * c->trail), v3(0.16f * r, r, 1.4f * r));
    for (int s = -1; s <= 1 && c->hood == 3; s += 2)
        dmg_beam(b, v3((float)s * 0.7f * c->width, 2.1f * r, 0), v3((float)s * 0.7f * c->width, r, -c->trail), 0.1f * r,
                 0.4f * r);
    dmg_beam(b, v3(0, 1.2f * r, 0), v3(0, r, -c->trail), 0.14f * r, 0.2f * r);
    for (int k = 0; k < (c->split ? 2 : 1); ++k) {
        dmg_save(b);
        dmg_move(b, c->split ? (k ? -apart : apart) : 0.0f, r, -c->trail);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        if (k && c->one_roll)
            dmg_use(b, b->part_count);
        else
            dmg_spin(b, fork, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, c->hood == 1 ? 0 : 5, r, c->width, 4);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Arms of a star from a hub down to the casters or to feet. */
static void draw_star(dmg_builder* b, float reach, float hub, float top, bool rolling) {
    int arms = dmg_chance(b, 0.75f) ? 5 : dmg_int(b, 3, 6);
    caster_style c = pick_caster(b, reach * dmg_range(b, 0.08f, 0.15f));
    float foot = rolling ? 2.3f * c.wheel : 0.04f * reach, t = reach * dmg_range(b, 0.06f, 0.12f);
    bool one_way = dmg_chance(b, 0.3f);
    float way = dmg_range(b, 0, 6.2f);
    dmg_rod(b, v3(0, foot, 0), v3(0, top, 0), hub);
    for (int i = 0; i < arms; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + 0.25f) / (float)arms, x = reach * cosf(angle),
              z = reach * sinf(angle);
        dmg_beam(b, v3(0.5f * hub * cosf(angle), 0.8f * top, 0.5f * hub * sinf(angle)), v3(x, foot + 0.5f * t, z), t,
                 1.2f * t);
        dmg_save(b);
        dmg_move(b, x, 0, z);
        if (rolling)
            draw_twin_caster(b, &c, foot + 0.3f * t, one_way ? way : dmg_range(b, 0, 6.2f));
        else
            dmg_rod(b, v3(0, 0, 0), v3(0, foot + 0.3f * t, 0), 0.4f * t);
        dmg_restore(b);
    }
}

/* ---- seats ---- */

/* Draws a shell of one sheet bent from the front edge over the seat up the back. */
static void draw_shell(dmg_builder* b, float width, float seat, float deep, float back, float t) {
    const dmg_xy line[] = {{0.55f * deep, seat - 0.05f * deep},
                           {0.4f * deep, seat},
                           {-0.35f * deep, seat},
                           {-0.5f * deep, seat + 0.2f * back},
                           {-0.6f * deep, seat + back}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_bent_plate(b, line, 5, t, width);
    dmg_restore(b);
}

static void draw_arm_rests(dmg_builder* b, uint32_t top, float width, float seat, float deep) {
    int kind = dmg_int(b, 0, 2);
    float high = deep * dmg_range(b, 0.35f, 0.55f), t = 0.06f * deep;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (0.5f * width + t);
        uint32_t pad = top;
        dmg_use(b, top);
        dmg_beam(b, v3((float)s * 0.3f * width, seat - 0.5f * t, 0), v3(x, seat - 0.5f * t, 0), t, t);
        dmg_rod(b, v3(x, seat - t, 0), v3(x, seat + 0.75f * high, 0), 0.5f * t);
        if (kind == 1) pad = dmg_slide(b, top, "arm_rest", v3(0, 1, 0), 0.0f, 0.3f * high);
        if (kind == 2) pad = dmg_hinge(b, top, "arm_rest", v3(x, seat + 0.7f * high, 0), v3(0, 1, 0), -0.5f, 0.5f);
        dmg_use(b, pad);
        if (kind) dmg_rod(b, v3(x, seat + 0.5f * high, 0), v3(x, seat + high, 0), 0.35f * t);
        dmg_rounded_box(b, v3(x, seat + high, 0.05f * deep), v3(1.6f * t, 0.6f * t, 0.5f * deep), 0.25f * t);
    }
    dmg_use(b, top);
}

/* Cushion and back rest; the back may tip, the whole may rock on its plate. */
static void draw_seat(dmg_builder* b, uint32_t top, float width, float seat, float deep, float t) {
    float back = deep * dmg_range(b, 0.7f, 1.7f);
    int kind = dmg_int(b, 0, 3); /* cushions, a shell, a stool, a thin frame */
    uint32_t rest = top;
    dmg_use(b, top);
    if (kind == 1) {
        draw_shell(b, width, seat, deep, back, 0.4f * t);
        return;
    }
    if (kind == 2) {
        dmg_rod(b, v3(0, seat - t, 0), v3(0, seat, 0), 0.45f * deep);
        return;
    }
    dmg_rounded_box(b, v3(0, seat, 0), v3(width, 1.5f * t, deep), 0.6f * t);
    dmg_vec foot = {0, seat - 0.5f * t, -0.42f * deep}, up = {0, seat + 0.3f * back, -0.58f * deep};
    if (dmg_chance(b, 0.35f))
        rest = dmg_hinge(b, top, "back_rest", foot, v3(-1, 0, 0), -0.1f, dmg_range(b, 0.2f, 0.6f));
    dmg_use(b, rest);
    dmg_beam(b, foot, up, 0.15f * width, 0.5f * t);
    if (kind == 3)
        dmg_beam(b, up, v3(0, seat + back, -0.66f * deep), 0.9f * width, 0.3f * t);
    else
        dmg_rounded_box(b, v3(0, seat + 0.6f * back, -0.6f * deep), v3(0.9f * width, 0.8f * back, 1.2f * t), 0.5f * t);
    if (dmg_chance(b, 0.2f)) { /* a head rest that slides up */
        float y = seat + 1.12f * back;
        dmg_slide(b, rest, "head_rest", v3(0, 1, 0), 0.0f, 0.2f * deep);
        dmg_rod(b, v3(0, seat + 0.8f * back, -0.62f * deep), v3(0, y, -0.64f * deep), 0.2f * t);
        dmg_rounded_box(b, v3(0, y, -0.62f * deep), v3(0.5f * width, 0.25f * deep, t), 0.4f * t);
    }
    dmg_use(b, top);
    if (dmg_chance(b, 0.5f)) draw_arm_rests(b, top, width, seat, deep);
}

void dmg_build_office_chair(dmg_builder* b) {
    float seat = dmg_range(b, 0.38f, 0.8f), width = dmg_range(b, 0.36f, 0.55f), deep = dmg_range(b, 0.36f, 0.52f),
          reach = dmg_range(b, 0.22f, 0.36f), hub = dmg_range(b, 0.02f, 0.05f), t = dmg_range(b, 0.03f, 0.07f),
          base = dmg_range(b, 0.25f, 0.4f) * seat;
    if (dmg_chance(b, 0.8f))
        draw_star(b, reach, hub, base, dmg_chance(b, 0.8f));
    else { /* a plate on the ground */
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.03f, 0), 0.8f * reach);
        dmg_rod(b, v3(0, 0, 0), v3(0, base, 0), hub);
    }
    /* All above the foot turns, rises, or both in two steps; or rocks on a column that stays. */
    int kind = dmg_int(b, 0, 3);
    uint32_t top = 0;
    float stem = hub * dmg_range(b, 0.5f, 0.9f), travel = dmg_range(b, 0.06f, 0.2f);
    if (kind == 0) top = dmg_slide(b, 0, "seat", v3(0, 1, 0), 0.0f, travel);
    if (kind == 1) top = dmg_spin(b, 0, "seat", v3(0, 0, 0), v3(0, 1, 0));
    if (kind == 2) top = dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, travel);
    dmg_rod(b, v3(0, 0.5f * base, 0), v3(0, seat - 0.8f * t, 0), stem);
    if (kind == 2) top = dmg_spin(b, top, "seat", v3(0, 0, 0), v3(0, 1, 0));
    if (kind == 3) {
        const float upper = dmg_range(b, 0.15f, 0.4f);
        const dmg_vec origin = v3(0, seat - 1.2f * t, dmg_range(b, -0.1f, 0.3f) * deep);
        top = dmg_hinge(b, 0, "seat", origin, v3(-1, 0, 0), -0.05f, upper);
    }
    dmg_box(b, v3(0, seat - 1.1f * t, 0), v3(0.4f * width, 0.7f * t, 0.5f * deep));
    if (dmg_chance(b, 0.5f)) { /* what lets it down */
        float side = dmg_sign(b);
        dmg_vec root = {side * 0.15f * width, seat - 1.1f * t, 0.05f * deep};
        dmg_hinge(b, top, "lever", root, v3(0, 0, side), -0.1f, dmg_range(b, 0.15f, 0.4f));
        dmg_rod(b, root, v3_add(root, v3(side * 0.4f * width, 0, 0)), 0.007f);
        dmg_box(b, v3_add(root, v3(side * 0.4f * width, 0, 0)), v3(0.06f, 0.01f, 0.03f));
    }
    draw_seat(b, top, width, seat, deep, t);
    dmg_use(b, 0);
}
