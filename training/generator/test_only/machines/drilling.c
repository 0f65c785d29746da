/* Draws drills: on a column, with a quill fed down by a capstan or a head that slides; with tables that rise, swing
 * and tilt, and belts under lids; magnetic drills on a dovetail. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/shop.h"

typedef struct drill {
    float tall, rc;           /* height, radius of the column, which stands at the origin */
    float reach;              /* from the column to the spindle */
    float head0, head1, half; /* the head's lower and upper edge, half its width */
    float way, chuck;         /* of the quill; radius of the chuck */
    uint32_t head;            /* part */
} drill;

/* ---- what turns in the quill ---- */

/* Draws a keyed or keyless chuck with its bit, its upper end at `at`. */
static void draw_chuck(dmg_builder* b, uint32_t parent, dmg_vec at, float r, bool endless) {
    int kind = dmg_int(b, 0, 2);
    float high = r * dmg_range(b, 1.8f, 3.0f), bit = r * dmg_range(b, 1.0f, 4.0f);
    bool empty = dmg_chance(b, 0.3f);
    const dmg_xy keyed[] = {{0, -high},
                            {0.35f * r, -high},
                            {0.8f * r, -0.6f * high},
                            {0.8f * r, -0.4f * high},
                            {r, -0.4f * high},
                            {r, -0.15f * high},
                            {0.8f * r, 0},
                            {0, 0}};
    const dmg_xy keyless[] = {{0, -high}, {0.5f * r, -high}, {r, -0.6f * high}, {r, 0}, {0, 0}};
    if (endless) dmg_spin(b, parent, "chuck", at, v3(0, 1, 0));
    if (kind == 0) dmg_lathe(b, at, v3(0, 1, 0), keyed, 8);
    if (kind == 1) dmg_lathe(b, at, v3(0, 1, 0), keyless, 5);
    if (kind == 2) dmg_cone(b, at, v3(at.x, at.y - high, at.z), r, 0.6f * r);
    if (!empty) dmg_rod(b, v3(at.x, at.y - 0.95f * high, at.z), v3(at.x, at.y - high - bit, at.z), 0.14f * r);
    dmg_use(b, parent);
}

/* Draws three arms with balls, a wheel, or one lever, on the shaft out of `at` along +X; a positive turn feeds. */
static void draw_capstan(dmg_builder* b, uint32_t parent, dmg_vec at, float r, float turn) {
    int arms = dmg_int(b, 1, 4), knob = dmg_int(b, 0, 2);
    float out = r * dmg_range(b, 0.15f, 0.4f), lean = dmg_range(b, 0.0f, 0.35f) * r, start = dmg_range(b, 0.0f, 6.28f),
          t = 0.05f * r;
    bool wheel = dmg_chance(b, 0.12f);
    if (arms == 1) start = dmg_range(b, -0.4f, 0.9f);
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_hinge(b, parent, "capstan", v3(0, 0, 0), v3(0, 0, 1), 0.0f, turn);
    dmg_turn(b, v3(0, 0, 1), arms == 1 && !wheel ? 1.57f - start : start);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, out + 2 * t), 3 * t);
    dmg_move(b, 0, 0, out);
    if (wheel) dmg_wheel_draw(b, 3, r, 3 * t, 3);
    for (int i = 0; i < arms && !wheel; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, arms);
        dmg_vec end = v3(r, 0, lean);
        dmg_rod(b, v3(0, 0, 0), end, t);
        if (knob == 0) dmg_ellipsoid(b, end, v3(2.5f * t, 2.5f * t, 2.5f * t));
        if (knob == 1) dmg_rod(b, v3_scale(end, 0.75f), v3_scale(end, 1.05f), 2 * t);
        if (knob == 2) dmg_capsule(b, v3_scale(end, 0.85f), end, 2.2f * t);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* ---- the head ---- */

/* Belt and pulleys under a lid: hung behind, at a side, or lifted off in front. */
static void draw_belt_lid(dmg_builder* b, const drill* d, float z0, float z1) {
    float high = d->tall * dmg_range(b, 0.04f, 0.08f), half = d->half * dmg_range(b, 0.9f, 1.25f), t = 0.06f * d->half,
          swing = dmg_range(b, 1.0f, 1.9f), y = d->head1;
    int hung = dmg_int(b, 0, 2);
    bool tapered = dmg_chance(b, 0.5f), low = dmg_chance(b, 0.4f);
    float seat = low ? 0.35f * high : t;
    dmg_box_span(b, v3(-half, y, z0), v3(half, y + 0.9f * seat, z1));
    if (hung == 0)
        dmg_hinge(b, d->head, "lid", v3(0, y + seat, z0), v3(-1, 0, 0), 0.0f, swing);
    else if (hung == 1)
        dmg_hinge(b, d->head, "lid", v3(-half, y + seat, 0), v3(0, 0, 1), 0.0f, swing);
    else
        dmg_hinge(b, d->head, "lid", v3(half, y + seat, 0), v3(0, 0, -1), 0.0f, swing);
    float near = tapered ? 0.65f * half : half;
    const dmg_xy plan[] = {{-half, -z0}, {half, -z0}, {near, -z1}, {-near, -z1}};
    const dmg_xy ahead[] = {{-near, -z1}, {near, -z1}, {half, -z0}, {-half, -z0}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* x, y of the outline lie in x, -z */
    dmg_extrude(b, -z1 < -z0 ? ahead : plan, 4, y + seat, y + seat + high);
    dmg_restore(b);
    if (dmg_chance(b, 0.4f))
        dmg_ellipsoid(b, v3(0, y + seat + 0.6f * high, z1), v3(0.1f * half, 0.1f * half, 0.1f * half));
    dmg_use(b, d->head);
}

/* Draws the motor behind, on a plate that pivots to slacken the belt or bolted on. */
static void draw_motor(dmg_builder* b, const drill* d) {
    float r = d->half * dmg_range(b, 0.5f, 0.8f), z = -d->rc - 1.4f * r, y = 0.5f * (d->head0 + d->head1);
    bool swings = dmg_chance(b, 0.4f);
    if (swings)
        dmg_hinge(b, d->head, "motor", v3(-0.8f * d->half, y, -d->rc - 0.3f * r), v3(0, 1, 0), 0.0f,
                  dmg_range(b, 0.1f, 0.4f));
    dmg_box_span(b, v3(-0.8f * d->half, y - 0.9f * r, -d->rc - 0.4f * r),
                 v3(0.8f * d->half, y + 0.9f * r, -d->rc - 0.2f * r));
    dmg_rod(b, v3(0, d->head0 - 0.5f * r, z), v3(0, d->head1 - 0.02f * d->tall, z), r);
    dmg_use(b, d->head);
}

/* Draws the shield before the chuck: it swings up about a line across, or aside about an upright one. */
static void draw_shield(dmg_builder* b, const drill* d) {
    float r = 2.2f * d->chuck, y = d->head0 - 0.4f * d->chuck, t = 0.08f * r, low = d->chuck * dmg_range(b, 2.0f, 4.0f);
    bool aside = dmg_chance(b, 0.5f);
    if (aside)
        dmg_hinge(b, d->head, "shield", v3(-r, y, d->reach), v3(0, -1, 0), 0.0f, 1.6f);
    else
        dmg_hinge(b, d->head, "shield", v3(0, y, d->reach + 0.4f * r), v3(-1, 0, 0), 0.0f, 1.4f);
    if (aside) dmg_rod(b, v3(-r, y - low, d->reach), v3(-r, d->head0, d->reach), t);
    for (int s = -1; s <= 1 && !aside; s += 2)
        dmg_box_span(b, v3((float)s * r - t, y - t, d->reach), v3((float)s * r + t, y + t, d->reach + 1.1f * r));
    dmg_box_span(b, v3(-r, y - low, d->reach + r), v3(r, y + t, d->reach + r + 0.5f * t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * r - 0.5f * t, y - low, d->reach + (aside ? 0.0f : 0.4f * r)),
                     v3((float)s * r + 0.5f * t, y + t, d->reach + r));
    dmg_use(b, d->head);
}

static void draw_quill(dmg_builder* b, const drill* d) {
    bool gauge = dmg_chance(b, 0.5f), endless = dmg_chance(b, 0.7f);
    float r = 0.75f * d->chuck, x = 0.75f * d->half;
    uint32_t quill = dmg_slide(b, d->head, "quill", v3(0, -1, 0), 0.0f, d->way);
    dmg_rod(b, v3(0, d->head0 - 0.3f * d->chuck, d->reach), v3(0, d->head0 + 1.1f * d->way, d->reach), r);
    if (gauge) { /* a depth rod on a lug goes down with it */
        dmg_box_span(b, v3(0, d->head0 - 0.28f * d->chuck, d->reach - 0.4f * r),
                     v3(x + 0.4f * r, d->head0 - 0.05f * d->chuck, d->reach + 0.4f * r));
        dmg_rod(b, v3(x, d->head0 - 0.1f * d->chuck, d->reach), v3(x, d->head1 + 0.6f * d->way, d->reach), 0.15f * r);
    }
    draw_chuck(b, quill, v3(0, d->head0 - 0.3f * d->chuck, d->reach), d->chuck, endless);
    dmg_use(b, d->head);
}

static void draw_head_body(dmg_builder* b, const drill* d, float z1) {
    float y = 0.5f * (d->head0 + d->head1), z0 = -1.3f * d->rc, high = d->head1 - d->head0;
    int kind = dmg_int(b, 0, 2);
    const dmg_xy side[] = {
        {z0, d->head0}, {0.6f * d->reach, d->head0}, {z1, d->head0 + 0.15f * high}, {z1, d->head1}, {z0, d->head1}};
    dmg_use(b, d->head);
    if (kind == 0) dmg_rounded_box(b, v3(0, y, 0.5f * (z0 + z1)), v3(2 * d->half, high, z1 - z0), 0.2f * d->half);
    if (kind == 1) dmg_box_span(b, v3(-d->half, d->head0, z0), v3(d->half, d->head1, z1));
    if (kind == 2) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, side, 5, -d->half, d->half);
        dmg_restore(b);
    }
    if (kind == 2) dmg_rod(b, v3(0, d->head0, d->reach), v3(0, y, d->reach), 1.2f * d->chuck);
    if (dmg_chance(b, 0.5f)) { /* switches in front */
        dmg_save(b);
        dmg_move(b, 0, y + 0.1f * high, z1);
        dmg_controls_draw(b, d->head, 1.2f * d->half, 0.5f * high);
        dmg_restore(b);
        dmg_use(b, d->head);
    }
}

/* ---- the table ---- */

static void draw_table_top(dmg_builder* b, const drill* d, float y, float t) {
    float half = d->reach * dmg_range(b, 0.6f, 1.0f);
    bool round = dmg_chance(b, 0.4f), slots = dmg_chance(b, 0.5f);
    if (round)
        dmg_rod(b, v3(0, y - t, d->reach), v3(0, y, d->reach), 0.9f * half);
    else
        dmg_box_span(b, v3(-half, y - t, d->reach - 0.8f * half), v3(half, y, d->reach + 0.8f * half));
    for (int s = -1; s <= 1 && slots; s += 2)
        dmg_box(b, v3((float)s * 0.4f * half, y + 0.05f * t, d->reach), v3(0.08f * half, 0.1f * t, 0.9f * half));
    if (dmg_chance(b, 0.8f)) return;
    uint32_t top = b->part; /* a vice whose jaw closes */
    dmg_box_span(b, v3(-0.5f * half, y, d->reach - 0.3f * half), v3(0.5f * half, y + t, d->reach + 0.3f * half));
    dmg_box_span(b, v3(-0.5f * half, y + t, d->reach - 0.3f * half),
                 v3(-0.3f * half, y + 2 * t, d->reach + 0.3f * half));
    dmg_slide(b, top, "jaw", v3(1, 0, 0), 0.0f, 0.5f * half);
    dmg_box_span(b, v3(-0.28f * half, y + t, d->reach - 0.3f * half),
                 v3(-0.05f * half, y + 2 * t, d->reach + 0.3f * half));
    dmg_rod(b, v3(-0.05f * half, y + 1.5f * t, d->reach), v3(0.8f * half, y + 1.5f * t, d->reach), 0.25f * t);
    dmg_use(b, top);
}

/* Up the column by a rack and a crank, round the column, and tilted to the side, as far as the drill allows. */
static void draw_table(dmg_builder* b, const drill* d, float base) {
    float space = d->head0 - 5 * d->chuck - base, t = 0.025f * d->tall, high = d->tall * 0.06f,
          y = base + fmaxf(space * dmg_range(b, 0.25f, 0.55f), 2.6f * high), up = base + 0.95f * space - y,
          down = y - base - 2.5f * high;
    bool rises = dmg_chance(b, 0.8f), swings = dmg_chance(b, 0.5f), tilts = dmg_chance(b, 0.6f),
         crank = dmg_chance(b, 0.6f);
    float lock = d->rc * dmg_range(b, 1.5f, 3.0f);
    if (down < 0.0f || up < 0.0f) return;
    uint32_t carrier = 0;
    if (rises) carrier = dmg_slide(b, carrier, "table", v3(0, 1, 0), -down, up);
    if (swings && !rises) carrier = dmg_hinge(b, carrier, "table", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.5f, 1.5f);
    dmg_rod(b, v3(0, y - 2 * high, 0), v3(0, y, 0), 1.5f * d->rc);
    if (crank && rises)
        dmg_handwheel_place(b, carrier, "crank", v3(1.4f * d->rc, y - high, 0), 0.5f * DMG_PI, 1.4f * d->rc);
    if (dmg_chance(b, 0.6f))
        dmg_machine_lever_place(b, carrier, "lock", v3(-1.4f * d->rc, y - 0.8f * high, 0), -0.5f * DMG_PI, lock);
    if (swings && rises) {
        carrier = dmg_hinge(b, carrier, "arm", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.3f, 1.3f);
        dmg_rod(b, v3(0, y + 0.01f * high, 0), v3(0, y + 0.8f * high, 0), 1.5f * d->rc);
    }
    float arm = swings && rises ? y + 0.4f * high : y - 0.5f * high;
    dmg_box_span(b, v3(-0.7f * d->rc, arm - 0.4f * high, 1.1f * d->rc),
                 v3(0.7f * d->rc, arm + 0.4f * high, 0.5f * d->reach));
    if (tilts) {
        dmg_rod(b, v3(0, arm, 0.5f * d->reach), v3(0, arm, 0.56f * d->reach), 0.6f * high);
        dmg_hinge(b, carrier, "tilt", v3(0, arm, 0), v3(0, 0, dmg_sign(b)), -0.79f, 0.79f);
        dmg_rod(b, v3(0, arm, 0.565f * d->reach), v3(0, arm, d->reach), 0.5f * high);
    } else
        dmg_box_span(b, v3(-0.6f * d->rc, arm - 0.3f * high, 0.5f * d->reach),
                     v3(0.6f * d->rc, arm + 0.3f * high, d->reach));
    draw_table_top(b, d, arm + 0.5f * high + t, t + 0.1f * high);
    dmg_use(b, 0);
}

static void draw_pillar_drill(dmg_builder* b, bool head_slides) {
    drill d = {.tall = dmg_scale_range(b, head_slides ? 0.35f : 0.6f, head_slides ? 0.8f : 1.9f)};
    float unit = fminf(d.tall, 0.7f + 0.3f * d.tall);
    d.rc = unit * dmg_range(b, 0.03f, 0.05f);
    d.reach = unit * dmg_range(b, 0.16f, 0.28f);
    d.half = d.reach * dmg_range(b, 0.35f, 0.55f);
    d.chuck = d.half * dmg_range(b, 0.2f, 0.35f);
    d.head0 = d.tall - unit * dmg_range(b, 0.3f, 0.4f);
    d.head1 = d.head0 + unit * dmg_range(b, 0.16f, 0.24f);
    d.way = unit * dmg_range(b, 0.08f, 0.12f);
    float base = d.tall * dmg_range(b, 0.02f, 0.05f), half = d.reach * dmg_range(b, 0.7f, 1.0f),
          z1 = d.reach + 1.6f * d.chuck, turn = dmg_range(b, 2.0f, 5.0f), r = unit * dmg_range(b, 0.1f, 0.17f);
    dmg_box_span(b, v3(-half, 0, -0.6f * half), v3(half, base, d.reach + 0.8f * half));
    dmg_rod(b, v3(0, base, 0), v3(0, base + 2 * d.rc, 0), 1.8f * d.rc);
    dmg_rod(b, v3(0, base, 0), v3(0, head_slides ? d.tall * 1.1f : d.head0 + 0.2f * (d.head1 - d.head0), 0), d.rc);
    if (head_slides) {
        d.head = dmg_slide(b, 0, "head", v3(0, -1, 0), 0.0f, d.head0 - base - 7 * d.chuck);
        if (dmg_chance(b, 0.4f)) dmg_rest(b, d.head, b->parts[d.head - 1].joint.upper * dmg_unit(b));
    }
    draw_head_body(b, &d, z1);
    if (head_slides)
        draw_chuck(b, d.head, v3(0, d.head0, d.reach), d.chuck, true);
    else
        draw_quill(b, &d);
    draw_capstan(b, d.head, v3(d.half, 0.6f * d.head0 + 0.4f * d.head1, 0.6f * d.reach), r, turn);
    bool motor = dmg_chance(b, 0.8f) && !head_slides, lid = dmg_chance(b, 0.75f) && !head_slides,
         shield = dmg_chance(b, 0.35f);
    if (motor) draw_motor(b, &d);
    if (lid) draw_belt_lid(b, &d, motor ? -d.rc - 2.6f * d.half : -1.2f * d.rc, z1);
    if (shield) draw_shield(b, &d);
    dmg_use(b, 0);
    if (!head_slides && dmg_chance(b, 0.9f)) draw_table(b, &d, base);
}

/* Draws a block that clings to steel, a dovetail before it on which the motor goes down, the feed at its side. */
static void draw_magnet_drill(dmg_builder* b) {
    float tall = dmg_scale_range(b, 0.3f, 0.6f), half = tall * dmg_range(b, 0.11f, 0.16f),
          deep = tall * dmg_range(b, 0.4f, 0.55f), magnet = tall * dmg_range(b, 0.1f, 0.16f),
          way = tall * dmg_range(b, 0.2f, 0.3f), t = 0.03f * tall;
    float front = 0.15f * deep, r = half * dmg_range(b, 0.6f, 0.85f), turn = dmg_range(b, 3.0f, 6.0f);
    dmg_box_span(b, v3(-half, 0, -0.5f * deep), v3(half, magnet, 0.3f * deep));
    dmg_box_span(b, v3(-0.9f * half, magnet, -0.5f * deep), v3(0.9f * half, 0.85f * tall, front));
    dmg_box_span(b, v3(-0.4f * half, magnet + t, front), v3(0.4f * half, 0.85f * tall, front + 0.9f * t));
    if (dmg_chance(b, 0.6f)) /* the grip on top */
        dmg_bent_plate(b,
                       (const dmg_xy[]){{-0.7f * half, 0.84f * tall},
                                        {-0.6f * half, 0.95f * tall},
                                        {0.6f * half, 0.95f * tall},
                                        {0.7f * half, 0.84f * tall}},
                       4, t, 1.5f * t);
    draw_capstan(b, 0, v3(0.9f * half, 0.65f * tall, -0.15f * deep), tall * dmg_range(b, 0.25f, 0.4f), turn);
    uint32_t head = dmg_slide(b, 0, "head", v3(0, -1, 0), 0.0f, way);
    float z = front + 2 * t + r, low = magnet + way + 0.12f * tall;
    dmg_box_span(b, v3(-0.8f * half, low + 0.1f * tall, front + t), v3(0.8f * half, low + 0.45f * tall, z));
    dmg_rod(b, v3(0, low + 0.05f * tall, z), v3(0, low + 0.6f * tall, z), r);
    dmg_cone(b, v3(0, low + 0.6f * tall, z), v3(0, low + 0.68f * tall, z), r, 0.7f * r);
    draw_chuck(b, head, v3(0, low + 0.05f * tall, z), 0.5f * r, true);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, -0.9f * half, 0.45f * tall, -0.2f * deep);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_controls_draw(b, 0, 0.4f * deep, 0.25f * tall);
    dmg_restore(b);
}

void dmg_build_drill_press(dmg_builder* b) {
    static const float weights[] = {5, 2, 2};
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    switch (dmg_weighted(b, weights, 3)) {
    case 0:
        draw_pillar_drill(b, false);
        break;
    case 1:
        draw_pillar_drill(b, true);
        break;
    default:
        draw_magnet_drill(b);
        break;
    }
}

/* ---- driven by hand ---- */

/* A turned grip between two points. */
static void draw_grip(dmg_builder* b, dmg_vec from, dmg_vec to, float r) {
    float span = v3_length(v3_sub(to, from));
    const dmg_xy pear[] = {{0, 0},           {0.6f * r, 0}, {0.7f * r, 0.3f * span}, {r, 0.75f * span},
                           {0.7f * r, span}, {0, span}};
    if (dmg_chance(b, 0.4f))
        dmg_rod(b, from, to, 0.8f * r);
    else
        dmg_lathe(b, from, v3_sub(to, from), pear, 6);
}

/* A bevel wheel with a crank at the side drives a pinion over the chuck; a side grip unscrews. */
static void draw_eggbeater(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.04f, 0.06f), gear = tall * dmg_range(b, 0.13f, 0.2f),
          y = tall * dmg_range(b, 0.42f, 0.5f), t = 0.25f * r, side = dmg_sign(b),
          arm = gear * dmg_range(b, 0.8f, 1.3f), out = r * dmg_range(b, 1.6f, 2.2f);
    int pinions = dmg_int(b, 1, 2), kind = dmg_chance(b, 0.5f) ? 3 : 6;
    bool plate = dmg_chance(b, 0.3f);
    float low = y - gear - 0.6f * r;
    dmg_box_span(b, v3(-0.35f * r, low, -0.5f * r), v3(0.35f * r, 0.75f * tall, 0.5f * r));
    dmg_rod(b, v3(0, low - 0.5f * r, 0), v3(0, low, 0), 0.6f * r);
    draw_grip(b, v3(0, 0.75f * tall, 0), v3(0, tall, 0), r);
    if (plate) dmg_rounded_box(b, v3(0, tall, 0), v3(5 * r, 0.8f * r, 2.5f * r), 0.3f * r);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * side);
    uint32_t wheel = dmg_spin(b, 0, "crank", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0.2f * r), v3(0, 0, out + t), 0.3f * r);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.8f * r);
    dmg_wheel_draw(b, kind, gear, 0.4f * r, 5);
    dmg_restore(b);
    dmg_beam(b, v3(0, 0, out), v3(0, arm, out), 0.7f * r, t);
    dmg_spin(b, wheel, "knob", v3(0, arm, 0), v3(0, 0, 1));
    draw_grip(b, v3(0, arm, out + t), v3(0, arm, out + 3.5f * r), 0.7f * r);
    dmg_restore(b);
    for (int i = 0; i < pinions; ++i) {
        float at = i ? y + gear : y - gear;
        dmg_spin(b, 0, "pinion", v3(0, at, 0), v3(0, 1, 0));
        dmg_cone(b, v3(0, at - 0.3f * r, 0), v3(0, at + 0.3f * r, 0), 0.75f * r, 0.6f * r);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) {
        dmg_rod(b, v3(0, 0.62f * tall, 0), v3(-side * 1.2f * r, 0.62f * tall, 0), 0.3f * r);
        draw_grip(b, v3(-side * 1.2f * r, 0.62f * tall, 0), v3(-side * 4.5f * r, 0.62f * tall, 0), 0.7f * r);
    }
    draw_chuck(b, 0, v3(0, low - 0.5f * r, 0), 0.75f * r, true);
}

/* Draws a bow turned about the line through its head and its chuck; the sleeve on it spins, the ratchet's ring turns.
 */
static void draw_brace(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.025f, 0.035f), sweep = tall * dmg_range(b, 0.28f, 0.42f), y0 = 0.28f * tall,
          y1 = 0.85f * tall;
    bool ratchet = dmg_chance(b, 0.5f), sharp = dmg_chance(b, 0.5f);
    float run = sharp ? 0.02f * tall : 0.12f * tall;
    const dmg_xy head[] = {{0, 0},       {1.5f * r, 0}, {1.3f * r, 1.5f * r}, {4 * r, 2.5f * r}, {3.4f * r, 4 * r},
                           {0, 4.6f * r}};
    dmg_lathe(b, v3(0, y1 + 0.05f * tall, 0), v3(0, 1, 0), head, 6);
    uint32_t bow = dmg_spin(b, 0, "bow", v3(0, 0, 0), v3(0, 1, 0));
    dmg_vec low = v3(sweep, y0 + 0.14f * tall + run, 0), high = v3(sweep, y1 - 0.14f * tall - run, 0);
    const dmg_vec path[] = {v3(0, y0 - 0.02f * tall, 0), v3(0, y0 + 0.08f * tall, 0), low, high,
                            v3(0, y1 - 0.08f * tall, 0), v3(0, y1 + 0.045f * tall, 0)};
    dmg_sweep(b, path, 6, 0.6f * r, 0.6f * r, false);
    dmg_spin(b, bow, "sleeve", low, v3(0, 1, 0));
    dmg_vec from = v3_lerp(low, high, 0.12f), to = v3_lerp(low, high, 0.88f);
    draw_grip(b, from, to, 1.8f * r);
    if (ratchet) {
        dmg_hinge(b, bow, "ratchet", v3(0, y0, 0), v3(0, 1, 0), -0.5f, 0.5f);
        dmg_rod(b, v3(0, y0 - 0.02f * tall, 0), v3(0, y0 + 0.03f * tall, 0), 1.6f * r);
    }
    draw_chuck(b, bow, v3(0, y0 - 0.025f * tall, 0), 1.4f * r, dmg_chance(b, 0.5f));
    dmg_use(b, 0);
}

/* Draws a handle with a slider on a spiral shaft, or a plain screwdriver whose cap or shank turns. */
static void draw_pump_driver(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.045f, 0.075f), grip = tall * dmg_range(b, 0.35f, 0.5f), way = 0.3f * tall;
    bool pumps = dmg_chance(b, 0.5f), cap = dmg_chance(b, 0.5f), ring = dmg_chance(b, 0.6f);
    const dmg_xy body[] = {
        {0, tall - grip},        {0.7f * r, tall - grip},  {r, tall - 0.8f * grip}, {0.8f * r, tall - 0.55f * grip},
        {r, tall - 0.2f * grip}, {0.9f * r, 0.99f * tall}, {0, 0.99f * tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 7);
    if (cap) {
        dmg_spin(b, 0, "cap", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.99f * tall, 0), v3(0, 1.04f * tall, 0), 0.85f * r);
    }
    if (ring) { /* turned to reverse the ratchet */
        dmg_hinge(b, 0, "selector", v3(0, 0, 0), v3(0, 1, 0), -0.45f, 0.45f);
        dmg_rod(b, v3(0, tall - grip - 0.8f * r, 0), v3(0, tall - 1.002f * grip, 0), 0.8f * r);
        dmg_box_span(b, v3(-0.15f * r, tall - grip - 0.7f * r, 0.7f * r),
                     v3(0.15f * r, tall - grip - 0.1f * r, 1.1f * r));
    }
    uint32_t shaft = pumps ? dmg_slide(b, 0, "shaft", v3(0, 1, 0), 0.0f, fminf(way, 0.7f * (tall - grip))) : 0;
    if (pumps) dmg_rod(b, v3(0, 0.3f * tall, 0), v3(0, tall - grip, 0), 0.4f * r);
    dmg_spin(b, shaft, "shank", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0.08f * tall, 0), v3(0, pumps ? 0.3f * tall : tall - grip, 0), 0.28f * r);
    dmg_cone(b, v3(0, 0.02f * tall, 0), v3(0, 0.08f * tall, 0), 0.12f * r, 0.28f * r);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0.07f * tall, 0), v3(0, 0.2f * tall, 0), 0.55f * r);
    dmg_box_span(b, v3(-0.3f * r, 0, -0.06f * r), v3(0.3f * r, 0.04f * tall, 0.06f * r));
    dmg_use(b, 0);
}

/* Draws a spinning tool held like a pen: collet with a disc or burr, lock button, switch that slides, hanging ring. */
static void draw_rotary(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.09f, 0.13f), neck = tall * 0.3f, disc = r * dmg_range(b, 0.4f, 1.3f);
    bool bail = dmg_chance(b, 0.5f), slides = dmg_chance(b, 0.5f), wheel = dmg_chance(b, 0.5f);
    const dmg_xy body[] = {{0, neck - 0.1f * tall},
                           {0.45f * r, neck - 0.1f * tall},
                           {0.6f * r, neck},
                           {r, neck + 0.15f * tall},
                           {r, 0.9f * tall},
                           {0.75f * r, tall},
                           {0, tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 7);
    dmg_spin(b, 0, "collet", v3(0, 0, 0), v3(0, 1, 0));
    dmg_cone(b, v3(0, neck - 0.18f * tall, 0), v3(0, neck - 0.1f * tall, 0), 0.25f * r, 0.4f * r);
    dmg_rod(b, v3(0, neck - 0.28f * tall, 0), v3(0, neck - 0.15f * tall, 0), 0.08f * r);
    if (wheel) dmg_rod(b, v3(0, neck - 0.29f * tall, 0), v3(0, neck - 0.275f * tall, 0), disc);
    if (!wheel) dmg_ellipsoid(b, v3(0, neck - 0.28f * tall, 0), v3(0.2f * r, 0.4f * r, 0.2f * r));
    dmg_use(b, 0);
    dmg_slide(b, 0, "lock", v3(0, 0, -1), 0.0f, 0.15f * r);
    dmg_rod(b, v3(0, neck + 0.05f * tall, 0.6f * r), v3(0, neck + 0.05f * tall, 1.0f * r), 0.2f * r);
    if (slides) {
        dmg_slide(b, 0, "switch", v3(0, 1, 0), 0.0f, 0.1f * tall);
        dmg_rounded_box(b, v3(0, 0.65f * tall, 1.02f * r), v3(0.5f * r, 0.06f * tall, 0.2f * r), 0.05f * r);
    } else { /* a ring at the end sets the speed */
        dmg_hinge(b, 0, "speed", v3(0, 0, 0), v3(0, 1, 0), 0.0f, 4.5f);
        dmg_rod(b, v3(0, 0.8f * tall, 0), v3(0, 0.87f * tall, 0), 1.05f * r);
        dmg_box(b, v3(0, 0.835f * tall, 1.05f * r), v3(0.1f * r, 0.05f * tall, 0.1f * r));
    }
    if (bail) {
        dmg_hinge(b, 0, "bail", v3(0, 0.95f * tall, 0), v3(1, 0, 0), -1.4f, 1.4f);
        const dmg_vec bow[] = {v3(-r, 0.95f * tall, 0), v3(-r, tall + 0.3f * r, 0), v3(0, tall + 0.9f * r, 0),
                               v3(r, tall + 0.3f * r, 0), v3(r, 0.95f * tall, 0)};
        dmg_sweep(b, bow, 5, 0.07f * r, 0.07f * r, false);
    }
    dmg_use(b, 0);
}

void dmg_build_hand_drill(dmg_builder* b) {
    float tall = dmg_scale_range(b, 0.18f, 0.45f);
    if (dmg_chance(b, 0.5f)) { /* lying down */
        dmg_move(b, 0, 0.1f * tall, -0.5f * tall);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    }
    switch (dmg_int(b, 0, 3)) {
    case 0:
        draw_eggbeater(b, tall);
        break;
    case 1:
        draw_brace(b, tall);
        break;
    case 2:
        draw_pump_driver(b, tall);
        break;
    default:
        draw_rotary(b, tall);
        break;
    }
}
