/* Draws belt loaders and telescopic stairs for aircraft. Ahead is +Z, uphill. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- what they drive on ---- */

typedef struct base {
    float half, length, deck, wheel; /* the deck's middle is the origin */
    bool towed;
} base;

static void draw_towbar(dmg_builder* b, const base* c, float y, float z) {
    float reach = 0.6f * c->length, r = 0.04f * c->half, up = dmg_chance(b, 0.5f) ? dmg_range(b, 0.0f, 1.2f) : 0.0f;
    uint32_t steer = 0;
    dmg_save(b);
    if (dmg_chance(b, 0.5f)) { /* the front axle turns with it */
        steer = dmg_hinge(b, 0, "steering", v3(0, y, z), v3(0, dmg_sign(b), 0), -0.9f, 0.9f);
        dmg_rod(b, v3(0, y - 0.5f * r, z), v3(0, y + 3 * r, z), 0.3f * c->half);
        z += 0.25f * c->half;
    }
    dmg_hinge_across(b, steer, "towbar", v3(0, y, z), -0.2f - up, 1.3f - up);
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(1, 0, 0), -up);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * 0.25f * c->half, 0, 0), v3(0, 0, 0.7f * reach), 2 * r, 2 * r);
    dmg_beam(b, v3(0, 0, 0.6f * reach), v3(0, 0, reach), 2 * r, 2 * r);
    dmg_torus(b, v3(0, 0, reach + 1.5f * r), v3(0, 1, 0), 2 * r, 0.7f * r);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Legs that are let down: slid, screwed or swung. */
static void draw_legs(dmg_builder* b, const base* c) {
    int kind = dmg_int(b, 0, 2), pairs = dmg_int(b, 1, 2);
    float r = 0.05f * c->half, y = c->deck;
    for (int i = 0; i < 2 * pairs; ++i) {
        float x = (i & 1 ? 1.12f : -1.12f) * c->half, z = (i & 2 ? 0.2f : -0.2f) * c->length, low = 0.35f * y;
        dmg_box_span(b, v3(x - 1.6f * r, 0.6f * y, z - 1.6f * r), v3(x + 1.6f * r, 0.95f * y, z + 1.6f * r));
        dmg_box_span(b, v3(fminf(0.9f * x, x), 0.7f * y, z - r), v3(fmaxf(0.9f * x, x), 0.85f * y, z + r));
        if (kind == 0) dmg_slide(b, 0, "leg", v3(0, -1, 0), 0.0f, low);
        if (kind == 1) {
            float turns = 2 * DMG_PI * (float)dmg_int(b, 2, 6);
            dmg_screw(b, 0, "leg", v3(x, y, z), v3(0, -1, 0), low / turns, 0.0f, turns);
            dmg_box_span(b, v3(x - 4 * r, 1.3f * y, z - 0.6f * r), v3(x + 4 * r, 1.3f * y + r, z + 0.6f * r));
            dmg_rod(b, v3(x, 0.4f * y, z), v3(x, 1.3f * y, z), 0.7f * r);
        }
        if (kind == 2) { /* folded up along the side */
            dmg_hinge_across(b, 0, "leg", v3(x, 0.8f * y, z), z > 0 ? 0.0f : -1.57f, z > 0 ? 1.57f : 0.0f);
            dmg_box_span(
                b, v3(x + 1.7f * r * (x > 0 ? 1.0f : -1.0f) - 0.6f * r, 0.8f * y - r, z > 0 ? z - 0.75f * y : z - r),
                v3(x + 1.7f * r * (x > 0 ? 1.0f : -1.0f) + 0.6f * r, 0.8f * y + r, z > 0 ? z + r : z + 0.75f * y));
        } else {
            dmg_rod(b, v3(x, low, z), v3(x, 0.9f * y, z), r);
            dmg_rod(b, v3(x, low, z), v3(x, low + 0.5f * r, z), 2.5f * r);
        }
        dmg_use(b, 0);
    }
}

static void draw_driver(dmg_builder* b, const base* c, float x, float z) {
    float s = 0.45f * c->half, y = c->deck;
    if (dmg_chance(b, 0.35f)) {
        dmg_cab cab = dmg_cab_pick(b, v3(x - s, 0.8f * y, z - s), v3(x + s, y + 2.6f * s, z + 1.4f * s));
        cab.left = x < 0;
        cab.right = x > 0;
        dmg_cab_draw(b, &cab, 0);
        return;
    }
    dmg_rounded_box(b, v3(x, y + 0.3f * s, z - 0.5f * s), v3(1.2f * s, 0.6f * s, s), 0.1f * s);
    dmg_rounded_box(b, v3(x, y + s, z - 0.95f * s), v3(1.2f * s, 1.1f * s, 0.2f * s), 0.08f * s);
    dmg_box_span(b, v3(x - 0.8f * s, y, z + 0.8f * s), v3(x + 0.8f * s, y + 0.9f * s, z + s));
    dmg_save(b);
    dmg_move(b, x, y + 1.1f * s, z + 0.6f * s);
    dmg_turn(b, v3(1, 0, 0), -DMG_PI + dmg_range(b, 0.7f, 1.3f));
    dmg_rod(b, v3(0, 0, -0.7f * s), v3(0, 0, 0), 0.06f * s);
    dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), -3.1f, 3.1f);
    dmg_wheel_draw(b, 3, 0.45f * s, 0.1f * s, dmg_int(b, 2, 4));
    dmg_restore(b);
    dmg_use(b, 0);
}

static base draw_base(dmg_builder* b, float size) {
    base c = {.half = size * dmg_range(b, 0.25f, 0.4f)};
    c.length = size * dmg_range(b, 1.2f, 2.0f);
    c.wheel = size * dmg_range(b, 0.1f, 0.16f);
    c.towed = dmg_chance(b, 0.4f);
    c.deck = c.wheel * dmg_range(b, 1.7f, 2.4f);
    float t = 0.3f * c.deck, h = 0.5f * c.length;
    if (dmg_chance(b, 0.5f)) { /* a tub, or a frame of beams */
        dmg_box_span(b, v3(-0.7f * c.half, 0.5f * c.wheel, -h), v3(0.7f * c.half, c.deck, h));
    } else {
        for (int s = -1; s <= 1; s += 2) {
            dmg_box_span(b, v3((float)s * 0.6f * c.half - 0.3f * t, c.deck - t, -h),
                         v3((float)s * 0.6f * c.half + 0.3f * t, c.deck, h));
            dmg_box_span(b, v3(-0.6f * c.half, c.deck - t, (float)s * 0.9f * h - t),
                         v3(0.6f * c.half, c.deck, (float)s * 0.9f * h + t));
        }
        dmg_box_span(b, v3(-0.6f * c.half, c.deck - t, -t), v3(0.6f * c.half, c.deck, t));
    }
    dmg_box_span(b, v3(-c.half, c.deck - 0.3f * t, -0.45f * h), v3(c.half, c.deck, 0.45f * h));
    dmg_tyre rear = dmg_tyre_pick(b, c.wheel), front = rear;
    rear.width = fminf(rear.width, 0.4f * c.half);
    front.width = rear.width;
    front.steers = !c.towed && dmg_chance(b, 0.7f);
    front.knuckle = 2 * dmg_int(b, 0, 1);
    dmg_axle_draw(b, &rear, 0, c.half, -0.7f * h);
    dmg_axle_draw(b, &front, 0, c.half, 0.7f * h);
    if (c.towed) draw_towbar(b, &c, 0.6f * c.deck, h);
    if (dmg_chance(b, 0.5f)) draw_legs(b, &c);
    return c;
}

/* ---- belt loader: a frame from its pivot at the origin uphill along +Z ---- */

typedef struct belt {
    float half, back, length, high; /* behind the pivot, ahead of it, of the frame's sides */
    int bed;                        /* a belt, a belt with cleats, rollers that turn, an open trough */
} belt;

static void draw_belt_frame(dmg_builder* b, const belt* d, uint32_t frame, float z0, float z1) {
    float t = 0.12f * d->high, r = 0.4f * d->high;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * d->half - t, 0, z0), v3((float)s * d->half + t, d->high, z1));
    if (d->bed < 2 || d->bed == 3) dmg_box_span(b, v3(-d->half, 0.35f * d->high, z0), v3(d->half, 0.85f * d->high, z1));
    int cleats = d->bed == 1 ? dmg_int(b, 4, 10) : 0, rollers = d->bed == 2 ? dmg_int(b, 4, 9) : 0;
    for (int i = 0; i < cleats; ++i) {
        float z = z0 + (z1 - z0) * ((float)i + 0.5f) / (float)cleats;
        dmg_box_span(b, v3(-0.9f * d->half, 0.8f * d->high, z), v3(0.9f * d->half, 1.05f * d->high, z + t));
    }
    for (int i = 0; i < rollers; ++i) {
        float z = z0 + (z1 - z0) * ((float)i + 0.5f) / (float)rollers;
        dmg_spin(b, frame, "roller", v3(0, 0.6f * d->high, z), v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(-0.96f * d->half, 0.6f * d->high, z), v3(0.96f * d->half, 0.6f * d->high, z),
                fminf(r, 0.35f * (z1 - z0) / (float)rollers));
        dmg_use(b, frame);
    }
    for (int e = 0; e < 2; ++e) { /* drums at the ends */
        float z = e ? z1 : z0;
        if (dmg_chance(b, 0.6f)) dmg_spin(b, frame, "drum", v3(0, 0.55f * d->high, z), v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(-0.93f * d->half, 0.55f * d->high, z), v3(0.93f * d->half, 0.55f * d->high, z), r);
        dmg_use(b, frame);
    }
}

/* Beside the belt: a rail on posts that folds down about its foot, or one that is pulled up. */
static void draw_side_rails(dmg_builder* b, const belt* d, uint32_t frame) {
    int kind = dmg_int(b, 0, 2), sides = dmg_int(b, 1, 2);
    float tall = d->high * dmg_range(b, 1.5f, 3.5f), r = 0.09f * d->high, z0 = -0.6f * d->back, z1 = 0.85f * d->length;
    for (int k = 0; k < sides; ++k) {
        float side = k ? -1.0f : 1.0f, x = side * (d->half + 0.12f * d->high + r), y = 0.7f * d->high;
        if (kind == 1)
            dmg_hinge(b, frame, "rail", v3(x, y, 0.5f * (z0 + z1)), v3(0, 0, -side), 0.0f, dmg_range(b, 1.3f, 2.8f));
        if (kind == 2) dmg_slide(b, frame, "rail", v3(0, 1, 0), -0.6f * tall, 0.0f);
        for (int i = 0; i < 4; ++i) {
            float z = z0 + (z1 - z0) * (float)i / 3;
            dmg_rod(b, v3(x, kind == 2 ? y - 0.3f * tall : y, z), v3(x, d->high + tall, z), r);
        }
        dmg_rod(b, v3(x, d->high + tall, z0), v3(x, d->high + tall, z1), r);
        if (kind == 1) dmg_rod(b, v3(x, y, z0), v3(x, y, z1), 1.2f * r);
        dmg_use(b, frame);
        for (int i = 0; i < 4 && kind == 2; ++i)
            dmg_box(b, v3(x, 0.5f * d->high, z0 + (z1 - z0) * (float)i / 3), v3(3 * r, 0.6f * d->high, 3 * r));
    }
}

/* Draws two pairs of crossed bars under the frame: each turns about its foot. */
static void draw_props(dmg_builder* b, const base* c, const belt* d, float lift) {
    float z = 0.3f * c->length, x = 0.8f * d->half, t = 0.1f * d->high;
    bool moves = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * x, c->deck + t, z), v3(4 * t, 2 * t, 4 * t));
        if (moves) dmg_hinge_across(b, 0, "prop", v3((float)s * x, c->deck + t, z), -0.4f, 0.8f);
        dmg_beam(b, v3((float)s * x, c->deck + t, z), v3((float)s * x, lift, z + 0.1f * c->length), 1.5f * t, 2 * t);
        dmg_use(b, 0);
    }
}

void dmg_build_belt_loader(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 3.0f);
    base c = draw_base(b, size);
    belt d = {.half = c.half * dmg_range(b, 0.4f, 0.65f)};
    d.high = size * dmg_range(b, 0.06f, 0.11f);
    d.bed = dmg_int(b, 0, 3);
    bool middle = dmg_chance(b, 0.4f); /* rocks about its middle, or is hung at the rear */
    float back = (middle ? 0.0f : -0.42f) * c.length, up = dmg_chance(b, 0.3f) ? 0.0f : dmg_range(b, 0.05f, 0.5f),
          pin = c.deck + d.high * (middle ? 2.5f : 1.2f);
    d.back = middle ? c.length * dmg_range(b, 0.4f, 0.7f) : 0.15f * c.length;
    d.length = c.length * dmg_range(b, 0.9f, 1.3f) - (middle ? 0.4f * c.length : 0.0f);
    float most = middle ? fminf(0.6f, (pin - 0.3f * c.wheel) / d.back) : dmg_range(b, 0.5f, 0.8f);
    up = fminf(up, 0.8f * most);
    if (dmg_chance(b, 0.7f) && !c.towed) draw_driver(b, &c, -0.6f * c.half - 0.5f * d.half, -0.25f * c.length);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(
            b, v3((float)s * (d.half + 0.4f * d.high) - 0.2f * d.high, 0.9f * c.deck, back - 0.6f * d.high),
            v3((float)s * (d.half + 0.4f * d.high) + 0.2f * d.high, pin + 0.3f * d.high, back + 0.6f * d.high));
    uint32_t frame = dmg_hinge_across(b, 0, "belt", v3(0, pin, back), middle ? -0.3f * most - up : -up, most - up);
    dmg_rod(b, v3(-d.half - 0.7f * d.high, pin, back), v3(d.half + 0.7f * d.high, pin, back), 0.25f * d.high);
    dmg_save(b);
    dmg_move(b, 0, pin, back);
    dmg_turn(b, v3(1, 0, 0), -up);
    draw_belt_frame(b, &d, frame, -d.back, d.length);
    if (dmg_chance(b, 0.6f)) draw_side_rails(b, &d, frame);
    if (dmg_chance(b, 0.4f)) { /* its nose bends */
        float nose = 0.3f * d.length, tip = d.length + 0.9f * d.high;
        belt n = d;
        n.bed = d.bed == 2 ? 0 : d.bed;
        dmg_save(b);
        dmg_move(b, 0, 0, tip);
        uint32_t part = dmg_hinge_across(b, frame, "nose", v3(0, 0.55f * d.high, 0), -0.5f, 0.5f);
        draw_belt_frame(b, &n, part, 0.4f * d.high, nose);
        dmg_restore(b);
        dmg_use(b, frame);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.2f * d.half - 0.1f * d.high, 0.2f * d.high, d.length - d.high),
                         v3((float)s * 1.2f * d.half + 0.1f * d.high, 0.9f * d.high, tip + 0.3f * d.high));
    } else if (dmg_chance(b, 0.5f)) { /* a bumper at the tip is pushed in */
        dmg_slide(b, frame, "bumper", v3(0, 0, 1), -0.8f * d.high, 0.0f);
        dmg_rod(b, v3(-1.3f * d.half, 0.3f * d.high, d.length + 1.8f * d.high),
                v3(1.3f * d.half, 0.3f * d.high, d.length + 1.8f * d.high), 0.4f * d.high);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 1.25f * d.half - 0.1f * d.high, 0.2f * d.high, d.length - d.high),
                         v3((float)s * 1.25f * d.half + 0.1f * d.high, 0.4f * d.high, d.length + 1.8f * d.high));
    }
    dmg_restore(b);
    dmg_use(b, 0);
    float z = 0.4f * c.length;
    dmg_vec lug = v3_add(v3(0, pin, back), v3_turn(v3(0, 0, z - back), v3(1, 0, 0), -up));
    if (dmg_chance(b, 0.5f) && !middle && up > 0.15f)
        draw_props(b, &c, &d, lug.y);
    else if (!middle)
        dmg_ram_draw(b, dmg_ram_pick(b), 0, frame, v3(0, 0.8f * c.deck, 0.15f * c.length), lug, 0.3f * d.high);
    dmg_use(b, 0);
}

/* ---- stairs: flights along +Z, `rise` over `run`, foot at the origin ---- */

typedef struct flight {
    float half, run, rise, t;
    int steps, rail; /* rails: none, a bar on posts, panes */
} flight;

static void draw_rails(dmg_builder* b, const flight* f, float x, dmg_vec from, dmg_vec to, float tall) {
    int posts = 4;
    float r = 0.4f * f->t;
    for (int s = -1; s <= 1; s += 2) {
        float px = (float)s * x;
        dmg_vec a = v3(px, from.y + tall, from.z), e = v3(px, to.y + tall, to.z);
        if (f->rail) dmg_rod(b, a, e, r);
        for (int i = 0; i < posts && f->rail == 1; ++i) {
            dmg_vec top = v3_lerp(a, e, (float)i / (float)(posts - 1));
            dmg_rod(b, v3_add(top, v3(0, -tall, 0)), top, 0.8f * r);
        }
        if (f->rail == 2) {
            const dmg_xy pane[] = {{a.z, a.y - tall}, {e.z, e.y - tall}, {e.z, e.y}, {a.z, a.y}};
            dmg_side_prism(b, pane, 4, px - 0.3f * r, px + 0.3f * r);
        }
    }
}

static void draw_flight(dmg_builder* b, const flight* f, float x) {
    for (int i = 0; i < f->steps; ++i) {
        float share = ((float)i + 0.5f) / (float)f->steps, deep = f->run / (float)f->steps;
        dmg_box(b, v3(0, f->rise * ((float)i + 1) / (float)f->steps, f->run * share),
                v3(2 * x, 0.5f * f->t, 1.1f * deep));
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * x, 0, 0), v3((float)s * x, f->rise, f->run), 0.6f * f->t, 2 * f->t);
}

/* Draws a landing at the head, from z = 0 ahead: sides that are pushed forward, a flap in front, a gate. */
static void draw_landing(dmg_builder* b, const flight* f, uint32_t carrier, float deep, float tall, bool canopy) {
    float x = f->half, t = f->t;
    dmg_use(b, carrier);
    dmg_box_span(b, v3(-x, -t, 0), v3(x, 0, deep));
    draw_rails(b, f, 0.97f * x, v3(0, 0, 0), v3(0, 0, deep), tall);
    if (dmg_chance(b, 0.4f)) dmg_hinge_across(b, carrier, "flap", v3(0, -0.5f * t, deep), -0.3f, 1.4f);
    dmg_box_span(b, v3(-0.9f * x, -0.8f * t, deep), v3(0.9f * x, -0.2f * t, deep + 0.3f * deep));
    dmg_use(b, carrier);
    bool sides = dmg_chance(b, 0.5f), gate = dmg_chance(b, 0.4f);
    for (int s = -1; s <= 1 && sides; s += 2) {
        dmg_slide(b, carrier, "side", v3(0, 0, 1), 0.0f, 0.5f * deep);
        dmg_box_span(b, v3((float)s * 1.06f * x - 0.3f * t, 0, 0.2f * deep),
                     v3((float)s * 1.06f * x + 0.3f * t, 0.9f * tall, 0.98f * deep));
        dmg_use(b, carrier);
    }
    if (gate) {
        dmg_hinge(b, carrier, "gate", v3(-0.9f * x, 0.7f * tall, 0.95f * deep), v3(0, 1, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(-0.9f * x, 0.55f * tall, 0.93f * deep), v3(0.9f * x, 0.95f * tall, 0.97f * deep));
        dmg_use(b, carrier);
    }
    if (!canopy) return;
    float roof = 2.2f * tall;
    for (int i = 0; i < 4; ++i) {
        float px = (i & 1 ? 0.95f : -0.95f) * x, z = i & 2 ? 0.9f * deep : 0.1f * deep;
        dmg_rod(b, v3(px, 0, z), v3(px, roof, z), 0.4f * t);
    }
    bool forward = dmg_chance(b, 0.5f);
    if (forward) dmg_slide(b, carrier, "canopy", v3(0, 0, 1), 0.0f, 0.7f * deep);
    const dmg_xy bow[] = {{1.05f * x, roof},
                          {0.7f * x, roof + 0.35f * x},
                          {0, roof + 0.5f * x},
                          {-0.7f * x, roof + 0.35f * x},
                          {-1.05f * x, roof}};
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * deep);
    dmg_bent_plate(b, bow, 5, 0.4f * t, 1.05f * deep);
    dmg_restore(b);
    dmg_use(b, carrier);
}

void dmg_build_airstairs(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 2.5f), slope = dmg_range(b, 0.5f, 0.85f),
          tall = size * dmg_range(b, 0.35f, 0.5f);
    base c = draw_base(b, size);
    flight f = {.half = c.half * dmg_range(b, 0.6f, 0.9f)};
    f.steps = dmg_int(b, 5, 10);
    f.rail = dmg_int(b, 0, 2);
    f.t = size * dmg_range(b, 0.03f, 0.06f);
    float length = c.length * dmg_range(b, 0.7f, 1.0f);
    f.run = length * cosf(slope);
    f.rise = length * sinf(slope);
    dmg_vec way = {0, sinf(slope), cosf(slope)}, foot = {0, c.deck * dmg_range(b, 0.4f, 1.0f), -0.5f * c.length};
    if (!c.towed && dmg_chance(b, 0.6f)) draw_driver(b, &c, -0.55f * c.half, 0.3f * c.length);
    uint32_t lower = 0;
    bool lifts = dmg_chance(b, 0.4f), extends = dmg_chance(b, 0.7f) || !lifts;
    if (lifts) lower = dmg_hinge_across(b, 0, "stairs", foot, -0.2f, dmg_range(b, 0.15f, 0.4f));
    dmg_save(b);
    dmg_move(b, foot.x, foot.y, foot.z);
    draw_flight(b, &f, f.half);
    dmg_vec end = {0, f.rise, f.run};
    draw_rails(b, &f, 0.98f * f.half, v3(0, 0, 0), end, tall);
    if (dmg_chance(b, 0.4f)) { /* the lowest steps fold up */
        float r = 0.15f * length;
        dmg_hinge_across(b, lower, "step", v3(0, 0, -0.02f * length), -2.4f, 0.0f);
        dmg_box_span(b, v3(-0.95f * f.half, -0.5f * f.t, -0.02f * length - r),
                     v3(0.95f * f.half, 0.5f * f.t, -0.02f * length));
        dmg_use(b, lower);
    }
    uint32_t upper = lower;
    flight g = f;
    if (extends) { /* the upper flight runs in the lower one, above its steps */
        float out = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.0f, 0.5f), over = 2.2f * f.t;
        g.half = f.half - 1.2f * f.t;
        dmg_move(b, 0, over + out * f.rise, out * f.run);
        upper = dmg_slide(b, lower, "upper_flight", way, -out * length, (0.75f - out) * length);
        draw_flight(b, &g, g.half);
        if (g.rail == 2) g.rail = 1;
        draw_rails(b, &g, 0.9f * g.half, v3(0, 0, 0), end, 0.9f * tall);
    }
    dmg_move(b, 0, f.rise, f.run);
    if (dmg_chance(b, 0.4f)) { /* the landing is kept level */
        uint32_t landing = dmg_hinge_across(b, upper, "landing", v3(0, -0.5f * f.t, 0), -0.4f, 0.4f);
        dmg_rod(b, v3(-g.half, -0.5f * f.t, 0), v3(g.half, -0.5f * f.t, 0), 0.8f * f.t);
        upper = landing;
    }
    bool canopy = dmg_chance(b, 0.3f);
    draw_landing(b, &g, upper, size * dmg_range(b, 0.35f, 0.6f), tall, canopy);
    dmg_restore(b);
    dmg_use(b, 0);
    if (!lifts)
        for (int s = -1; s <= 1; s += 2) { /* what holds the lower flight up */
            dmg_vec at = v3_mad(foot, way, 0.75f * length);
            dmg_beam(b, v3((float)s * 0.8f * f.half, 0.9f * c.deck, fminf(at.z + 0.05f * length, 0.48f * c.length)),
                     v3((float)s * 0.8f * f.half, at.y - f.t, at.z), 1.2f * f.t, 1.2f * f.t);
        }
    else
        dmg_ram_draw(b, dmg_ram_pick(b), 0, lower, v3(0, 0.9f * c.deck, 0.2f * c.length),
                     v3_add(v3_mad(foot, way, 0.7f * length), v3(0, -f.t, 0)), 1.2f * f.t);
    dmg_use(b, 0);
}
