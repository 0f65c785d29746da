/* Draws industrial manipulators: arms of round housings with offset axes, SCARA arms, gantries, jaws on guides,
 * hands. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- arms of housings ---- */

/* Draws a drum about `axis` whose two ends lie at `half` from its middle, with lids that may stand out. */
static void draw_housing(dmg_builder* b, dmg_vec at, dmg_vec axis, float radius, float half, float lid) {
    dmg_rod(b, v3_mad(at, axis, -half), v3_mad(at, axis, half), radius);
    if (lid > 0) dmg_rod(b, v3_mad(at, axis, half), v3_mad(at, axis, half + lid), 0.85f * radius);
}

typedef struct cobot {
    float radius; /* of the housing at hand: they get smaller towards the tool */
    float taper;  /* from one joint to the next */
    float lid;    /* share of the radius that a drum's lid stands out; 0: none */
    int tube;     /* round, square, waisted */
} cobot;

static void draw_tube(dmg_builder* b, const cobot* c, dmg_vec from, dmg_vec to) {
    float r = 0.8f * c->radius;
    dmg_vec waist = v3_lerp(from, to, 0.5f);
    if (c->tube == 0) dmg_rod(b, from, to, r);
    if (c->tube == 1) dmg_beam(b, from, to, 1.7f * r, 1.7f * r);
    if (c->tube == 2) {
        dmg_cone(b, from, waist, r, 0.7f * r);
        dmg_cone(b, waist, to, 0.7f * r, 0.9f * r);
    }
}

/* Draws one tilting joint: a housing about X on the carrier's side, the moving link's own housing beside it, and a tube
 * from there upwards. Leaves the frame at the tube's end, shifted back or not. */
static uint32_t draw_tilt(dmg_builder* b, cobot* c, uint32_t carrier, float length, float side, float swing) {
    float r = c->radius, half = r * dmg_range(b, 0.6f, 1.0f), lid = c->lid * r;
    draw_housing(b, v3(0, 0, 0), v3(-side, 0, 0), r, half, lid);
    float x = side * 2.0f * half;
    uint32_t link = dmg_hinge(b, carrier, "link", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -swing, swing);
    draw_housing(b, v3(x, 0, 0), v3(side, 0, 0), r, half, lid);
    draw_tube(b, c, v3(x, 0.4f * r, 0), v3(x, length, 0));
    dmg_move(b, x, length, 0);
    c->radius *= c->taper;
    return link;
}

/* Draws a rolling joint: a collar about the direction of the tube. */
static uint32_t draw_roll(dmg_builder* b, const cobot* c, uint32_t carrier) {
    float r = c->radius, high = r * dmg_range(b, 0.8f, 2.0f);
    dmg_vec up = {0, 1, 0};
    uint32_t link = dmg_chance(b, 0.4f) ? dmg_spin(b, carrier, "roll", v3(0, 0, 0), up)
                                        : dmg_hinge(b, carrier, "roll", v3(0, 0, 0), up, -2.9f, 2.9f);
    dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), r);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.5f * high, r), v3(0.5f * r, 0.5f * high, 0.4f * r));
    dmg_move(b, 0, high + 0.9f * r, 0);
    return link;
}

/* Draws the last flange, and a tool that shows how it turns: a plate, a nozzle, a cup on a pipe. */
static void draw_tool(dmg_builder* b, const cobot* c) {
    float r = c->radius;
    int kind = dmg_int(b, 0, 3);
    dmg_rod(b, v3(0, -0.3f * r, 0), v3(0, 0.3f * r, 0), 0.8f * r);
    if (kind == 1) dmg_box(b, v3(0.3f * r, 0.8f * r, 0), v3(2.2f * r, 1.2f * r, 1.0f * r));
    if (kind == 2) dmg_cone(b, v3(0, 0.3f * r, 0), v3(0, 2.5f * r, 0), 0.5f * r, 0.1f * r);
    if (kind == 3) {
        dmg_rod(b, v3(0, 0.3f * r, 0), v3(0, 2 * r, 0), 0.2f * r);
        dmg_cone(b, v3(0, 2 * r, 0), v3(0, 2.5f * r, 0), 0.3f * r, 0.9f * r);
    }
}

/* Drums side by side: every tilting axis is carried beside the one before, rolls lie between them. */
void dmg_build_cobot_arm(dmg_builder* b) {
    float reach = dmg_scale_range(b, 0.3f, 3.0f), base;
    cobot c = {.radius = reach * dmg_range(b, 0.045f, 0.1f), .taper = dmg_range(b, 0.8f, 1.0f)};
    c.lid = dmg_chance(b, 0.5f) ? dmg_range(b, 0.1f, 0.5f) : 0.0f;
    c.tube = dmg_int(b, 0, 2);
    base = c.radius * dmg_range(b, 0.5f, 2.5f);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.1f * base, 0), v3(3 * c.radius, 0.2f * base, 3 * c.radius));
    dmg_cone(b, v3(0, 0, 0), v3(0, base, 0), 1.3f * c.radius, 1.05f * c.radius);
    dmg_move(b, 0, base, 0);
    int tilts = dmg_int(b, 2, 4);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.85f))
        carrier = draw_roll(b, &c, 0);
    else
        dmg_move(b, 0, 0.9f * c.radius, 0);
    float side = dmg_sign(b), left = reach;
    bool zigzag = dmg_chance(b, 0.6f);
    for (int i = 0; i < tilts; ++i) {
        float length = fmaxf(2.5f * c.radius, left * dmg_range(b, 0.35f, 0.6f)), swing = dmg_range(b, 0.7f, 2.2f);
        left -= fminf(left, length);
        if (i) dmg_move(b, 0, 0.6f * c.radius, 0);
        carrier = draw_tilt(b, &c, carrier, length, side, swing);
        if (zigzag) side = -side;
        if (dmg_chance(b, 0.35f)) carrier = draw_roll(b, &c, carrier);
        /* The pose: the rest of the arm is turned about an axis of its own that goes on from here. */
        dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.3f, 1.4f));
    }
    dmg_move(b, 0, 0.5f * c.radius, 0);
    if (dmg_chance(b, 0.8f)) dmg_spin(b, carrier, "flange", v3(0, 0, 0), v3(0, 1, 0));
    draw_tool(b, &c);
    dmg_use(b, 0);
}

/* ---- SCARA ---- */

/* Draws an arm in plan from the origin along +X, boss to boss, `high` thick upwards from y = 0. */
static void draw_flat_arm(dmg_builder* b, int kind, float length, float wide, float high) {
    if (kind != 1) dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), 0.5f * wide);
    if (kind != 2) dmg_rod(b, v3(length, 0, 0), v3(length, high, 0), 0.42f * wide);
    if (kind == 0) dmg_box(b, v3(0.5f * length, 0.5f * high, 0), v3(length, 0.9f * high, 0.75f * wide));
    if (kind == 1) dmg_box(b, v3(0.45f * length, 0.5f * high, 0), v3(1.1f * length, high, wide));
    if (kind == 2)
        dmg_rounded_box(b, v3(0.5f * length, 0.5f * high, 0), v3(length + 0.8f * wide, high, 0.9f * wide), 0.3f * high);
}

/* Turns about upright axes, and a spindle at the end, or a lift in the column, that goes up and down. */
void dmg_build_scara(dmg_builder* b) {
    float reach = dmg_scale_range(b, 0.2f, 1.6f), wide = reach * dmg_range(b, 0.1f, 0.28f),
          high = wide * dmg_range(b, 0.3f, 0.9f), column = reach * dmg_range(b, 0.3f, 1.1f),
          first = reach * dmg_range(b, 0.35f, 0.6f), second = reach - first,
          travel = column * dmg_range(b, 0.2f, 0.45f);
    int arms = dmg_int(b, 0, 2);
    bool lifts = dmg_chance(b, 0.35f); /* the column carries the whole arm up */
    uint32_t carrier = 0;
    dmg_box(b, v3(0, 0.02f * column, 0), v3(1.6f * wide, 0.04f * column, 1.6f * wide));
    if (lifts) {
        float back = -0.5f * wide;
        dmg_box(b, v3(back - 0.2f * wide, 0.5f * (column + 3 * high), 0), v3(0.4f * wide, column + 3 * high, wide));
        dmg_move(b, 0.1f * wide, column - travel, 0);
        carrier = dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, travel);
        dmg_box(b, v3(-0.1f * wide, -0.3f * high, 0), v3(wide, 0.6f * high, 0.9f * wide));
        if (dmg_chance(b, 0.5f)) dmg_rest(b, carrier, travel * dmg_unit(b));
    } else {
        int kind = dmg_int(b, 0, 1);
        if (kind) dmg_rod(b, v3(0, 0, 0), v3(0, column, 0), 0.5f * wide);
        if (!kind) dmg_box(b, v3(-0.1f * wide, 0.5f * column, 0), v3(1.1f * wide, column, wide));
        dmg_move(b, 0, column, 0);
    }
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, -0.6f, 0.6f));
    uint32_t link = dmg_hinge(b, carrier, "shoulder", v3(0, 0, 0), v3(0, dmg_sign(b), 0), lifts ? -1.3f : -2.2f,
                              lifts ? 1.3f : 2.2f);
    draw_flat_arm(b, arms, first, wide, high);
    float bend = dmg_range(b, 0.8f, 1.5f);
    bool below = !lifts && dmg_chance(b, 0.3f);
    dmg_move(b, first, below ? -high : high, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, -1.0f, 1.0f));
    link = dmg_hinge(b, link, "elbow", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -bend, bend);
    draw_flat_arm(b, arms, second, 0.9f * wide, high);
    if (dmg_chance(b, 0.5f)) /* the drive's cover */
        dmg_rounded_box(b, v3(0.3f * second, 1.5f * high, 0), v3(0.6f * second, high, 0.7f * wide), 0.2f * high);
    float thin = wide * dmg_range(b, 0.08f, 0.2f), low = lifts ? -high : -0.25f * column;
    dmg_move(b, second, 0, 0);
    if (!lifts || dmg_chance(b, 0.5f)) {
        link = dmg_slide(b, link, "quill", v3(0, -1, 0), 0.0f, travel);
        dmg_rod(b, v3(0, low, 0), v3(0, high + 1.2f * travel, 0), thin);
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, high + travel, 0), v3(0, high + 1.2f * travel, 0), 1.8f * thin);
    }
    if (dmg_chance(b, 0.7f)) dmg_spin(b, link, "wrist", v3(0, low, 0), v3(0, 1, 0));
    if (lifts) dmg_rod(b, v3(0, low, 0), v3(0, 0.5f * high, 0), 1.2f * thin);
    dmg_box(b, v3(0, low - 0.5f * thin, 0), v3(6 * thin, thin, 2 * thin));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 2 * thin, low - 3 * thin, 0), v3(thin, 5 * thin, 2 * thin));
    dmg_use(b, 0);
}

/* ---- gantries ---- */

/* Plotters, printers and portal robots: a bridge along Z, a carriage along X on it, a tool along Y. The bridge moves,
 * or the bed does. */
void dmg_build_gantry(dmg_builder* b) {
    float wide = dmg_scale_range(b, 0.25f, 6.0f), deep = wide * dmg_range(b, 0.5f, 1.8f),
          high = wide * dmg_range(b, 0.25f, 1.0f), t = wide * dmg_range(b, 0.02f, 0.07f),
          bed_y = t * dmg_range(b, 1, 3), car = t * dmg_range(b, 1.6f, 3.5f);
    bool bed_moves = dmg_chance(b, 0.35f), legs = dmg_chance(b, 0.6f), round = dmg_chance(b, 0.4f);
    float along = 0.5f * deep - 1.2f * t, bed_half = bed_moves ? 0.3f * deep : 0.5f * deep, beam_y = bed_y + high,
          room = 0.5f * wide - 2 * t - 0.5f * car;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * wide;
        dmg_box(b, v3(bed_moves ? 0.4f * x : x, 0.5f * bed_y, 0), v3(t, bed_y, deep));
        for (int e = -1; e <= 1 && !legs && !bed_moves; e += 2)
            dmg_box(b, v3(x, 0.5f * beam_y, (float)e * 0.48f * deep), v3(t, beam_y, t));
        if (!legs && !bed_moves) dmg_box(b, v3(x, beam_y - 0.5f * t, 0), v3(t, t, deep));
        if (!legs && !bed_moves) continue;
        dmg_box(b, v3(0, 0.3f * bed_y, (float)s * 0.47f * deep), v3(wide, 0.6f * bed_y, t));
    }
    uint32_t bridge = 0;
    if (bed_moves) {
        dmg_slide(b, 0, "bed", v3(0, 0, dmg_sign(b)), -0.5f * deep + bed_half, 0.5f * deep - bed_half);
        dmg_box(b, v3(0, bed_y + 0.3f * t, 0), v3(wide - 3 * t, 0.6f * t, 2 * bed_half));
        dmg_use(b, 0);
        dmg_box(b, v3(0, 0.4f * bed_y, 0), v3(wide, 0.5f * bed_y, 2 * t));
    } else {
        if (dmg_chance(b, 0.7f)) dmg_box(b, v3(0, 0.25f * bed_y, 0), v3(wide - 2 * t, 0.5f * bed_y, 0.9f * deep));
        bridge = dmg_slide(b, 0, "bridge", v3(0, 0, 1), -along, along);
        dmg_rest(b, bridge, along * dmg_range(b, -1, 1));
    }
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (0.5f * wide - (bed_moves || legs ? 0 : 0.2f * t)), low = bed_moves ? 0.0f : bed_y;
        if (bed_moves || legs)
            dmg_box(b, v3(x, 0.5f * (low + beam_y + 2 * t), 0), v3(t, beam_y + 2 * t - low, 1.8f * t));
        if (!bed_moves && !legs) dmg_box(b, v3(x, beam_y + t, 0), v3(2 * t, 2 * t, 3 * t));
    }
    for (int i = 0; i < (round ? 2 : 1); ++i) {
        float y = beam_y + (round ? (0.4f + 1.2f * (float)i) * t : t);
        if (round) dmg_rod(b, v3(-0.5f * wide, y, 0), v3(0.5f * wide, y, 0), 0.25f * t);
        if (!round) dmg_box(b, v3(0, y, 0), v3(wide, 2 * t, t));
    }
    uint32_t carriage = dmg_slide(b, bridge, "carriage", v3(dmg_sign(b), 0, 0), -room, room);
    dmg_rest(b, carriage, room * dmg_range(b, -1, 1));
    dmg_box(b, v3(0, beam_y + t, t), v3(car, 1.3f * car, round ? 2.5f * t : t));
    if (dmg_chance(b, 0.8f)) {
        float down = 0.7f * (high - t);
        dmg_slide(b, carriage, "tool", v3(0, -1, 0), 0.0f, down);
        dmg_box(b, v3(0, beam_y + 0.5f * t + 0.4f * down, 1.8f * t), v3(0.5f * car, 1.2f * down + car, 0.6f * t));
    }
    if (dmg_chance(b, 0.7f)) { /* a spindle, a nozzle, or a gripper's head */
        float foot = beam_y - 0.5f * car;
        dmg_rod(b, v3(0, foot, 2.4f * t), v3(0, foot + 1.4f * car, 2.4f * t), 0.35f * car);
        dmg_cone(b, v3(0, foot - 0.3f * car, 2.4f * t), v3(0, foot, 2.4f * t), 0.06f * car, 0.25f * car);
    }
    dmg_use(b, 0);
}

/* ---- jaws on guides ---- */

/* Draws a finger on a carriage of its own: straight, stepped in, cranked out, or with a pad. Root on z = 0. */
static void draw_jaw(dmg_builder* b, int kind, float x, float length, float thick, float wide) {
    dmg_box(b, v3(x, 0, 0.5f * thick), v3(2 * thick, wide, thick));
    if (kind == 0) dmg_box(b, v3(x, 0, 0.5f * length), v3(thick, 0.8f * wide, length));
    if (kind == 1) {
        dmg_box(b, v3(x + 0.5f * thick, 0, 0.3f * length), v3(0.8f * thick, 0.8f * wide, 0.6f * length));
        dmg_box(b, v3(x, 0, 0.6f * length), v3(1.8f * thick, 0.8f * wide, 0.6f * thick));
        dmg_box(b, v3(x - 0.5f * thick, 0, 0.8f * length), v3(0.8f * thick, 0.8f * wide, 0.4f * length));
    }
    if (kind == 2) {
        dmg_beam(b, v3(x, 0, thick), v3(x, 0, length), 0.7f * wide, 0.6f * thick);
        dmg_rounded_box(b, v3(x - 0.4f * thick, 0, 0.85f * length), v3(0.7f * thick, wide, 0.3f * length),
                        0.2f * thick);
    }
    if (kind == 3) {
        dmg_rod(b, v3(x, 0, 0), v3(x, 0, length), 0.45f * thick);
        dmg_ellipsoid(b, v3(x, 0, length), v3(0.6f * thick, 0.6f * thick, 0.6f * thick));
    }
}

/* Parallel grippers as arms carry them: a body, a guide across it, jaws that slide; alone or on a wrist, opened or shut
 * as they were modelled. */
void dmg_build_jaw_gripper(dmg_builder* b) {
    float wide = dmg_scale_range(b, 0.04f, 0.6f), body = wide * dmg_range(b, 0.3f, 1.4f),
          deep = wide * dmg_range(b, 0.15f, 0.6f), length = wide * dmg_range(b, 0.25f, 1.2f),
          thick = wide * dmg_range(b, 0.05f, 0.14f);
    int shell = dmg_int(b, 0, 3), jaw = dmg_int(b, 0, 3), hang = dmg_int(b, 0, 2), jaws = dmg_chance(b, 0.8f) ? 2 : 3;
    dmg_move(b, 0, hang == 1 ? length + 0.1f * wide : (hang ? 1.3f * body : 0.6f * wide), 0);
    if (hang) dmg_turn(b, v3(1, 0, 0), (hang == 1 ? 0.5f : -0.5f) * DMG_PI);
    uint32_t wrist = 0;
    if (dmg_chance(b, 0.4f)) {
        dmg_rod(b, v3(0, 0, -1.4f * body), v3(0, 0, -body), 0.35f * wide);
        wrist = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "wrist", v3(0, 0, -body), v3(0, 0, 1))
                                    : dmg_hinge(b, 0, "wrist", v3(0, 0, -body), v3(0, 0, 1), -2.5f, 2.5f);
    }
    if (shell == 0) dmg_box(b, v3(0, 0, -0.5f * body), v3(wide, deep, body));
    if (shell == 1) dmg_rod(b, v3(0, 0, -body), v3(0, 0, 0), 0.5f * wide);
    if (shell == 2) dmg_rounded_box(b, v3(0, 0, -0.5f * body), v3(wide, deep, body), 0.3f * deep);
    if (shell == 3) { /* a neck that widens to the guide */
        dmg_rod(b, v3(0, 0, -body), v3(0, 0, -0.3f * body), 0.25f * wide);
        dmg_box(b, v3(0, 0, -0.2f * body), v3(wide, deep, 0.4f * body));
    }
    float open = 0.5f * wide - thick, shut = dmg_range(b, 0.4f, 1.2f) * thick, tooth = fminf(deep, 2.5f * thick);
    int drawn = dmg_int(b, 0, 2); /* with the jaws open, shut, or between */
    float at = drawn == 0 ? open : (drawn == 1 ? shut + thick : 0.5f * (open + shut));
    for (int i = 0; i < jaws; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, jaws);
        float in = at - thick * 0.6f - 0.02f * wide, out = drawn == 0 ? 0.0f : fmaxf(0.05f * wide, open - at);
        if (dmg_chance(b, 0.7f))
            dmg_slide(b, wrist, "jaw", v3(1, 0, 0), -in, out);
        else
            dmg_slide(b, wrist, "jaw", v3(-1, 0, 0), -out, in);
        draw_jaw(b, jaw, at, length, thick, tooth);
        dmg_restore(b);
        dmg_use(b, wrist);
    }
    dmg_use(b, 0);
}
