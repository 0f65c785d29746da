/* Draws pressure hatches: a leaf on a coaming with its hand wheel, dogs, bolts or strongback; upright in a bulkhead,
 * flat on a deck, at the ends of a chamber. The coaming's rim lies in z = 0, the leaf before it; +Z is outside. */
#include "core/build.h"
#include "parts/hardware.h"

enum { RIM = 24 };

typedef struct hatch {
    float x, y, power;       /* half sizes of the opening, 2 an ellipse, more: nearer to a rectangle */
    float rim, deep;         /* of the coaming: its width, its depth behind z = 0 */
    float t, size;           /* of the leaf: its thickness; the smaller half size */
    float side;              /* where it is hung: -1 or 1 along x */
    int wheel, dress, hinge; /* styles */
} hatch;

static hatch pick_hatch(dmg_builder* b) {
    hatch h = {.x = dmg_scale_range(b, 0.08f, 1.0f)};
    h.side = dmg_sign(b);
    bool round = dmg_chance(b, 0.4f);
    h.y = round ? h.x : h.x * dmg_range(b, 1.0f, 2.3f);
    h.power = dmg_chance(b, 0.5f) ? 2.0f : dmg_range(b, 3.0f, 9.0f);
    h.size = h.x;
    h.rim = h.x * dmg_range(b, 0.08f, 0.25f);
    h.deep = h.x * dmg_range(b, 0.08f, 0.8f);
    h.t = h.x * dmg_range(b, 0.05f, 0.25f);
    h.wheel = dmg_int(b, 0, 4);
    h.dress = dmg_int(b, 0, 4);
    h.hinge = dmg_int(b, 0, 2);
    return h;
}

/* The opening's outline with a border outside it. */
static void outline_of(const hatch* h, float border, dmg_xy* at) {
    for (int i = 0; i < RIM; ++i) {
        float angle = 2.0f * DMG_PI * ((float)i + 0.5f) / RIM, c = cosf(angle), s = sinf(angle);
        float reach = powf(powf(fabsf(c), h->power) + powf(fabsf(s), h->power), -1.0f / h->power);
        at[i] = (dmg_xy){(h->x + border) * reach * c, (h->y + border) * reach * s};
    }
}

static void draw_ring(dmg_builder* b, const hatch* h, float inner, float outer, float low, float high) {
    dmg_xy in[RIM], out[RIM];
    outline_of(h, inner, in);
    outline_of(h, outer, out);
    dmg_ring_plate(b, out, in, RIM, low, high);
}

static void draw_slab(dmg_builder* b, const hatch* h, float border, float low, float high) {
    dmg_xy at[RIM];
    outline_of(h, border, at);
    dmg_extrude(b, at, RIM, low, high);
}

/* Draws a coaming alone, one in a plate, one at the end of a trunk with its flange. */
static void draw_coaming(dmg_builder* b, const hatch* h, int kind) {
    draw_ring(b, h, 0, h->rim, -h->deep, 0);
    float t = 0.4f * h->rim, wide = h->rim + h->size * dmg_range(b, 0.3f, 0.8f);
    if (kind == 1) draw_ring(b, h, 0, wide, -h->deep - t, -h->deep);
    if (kind == 2) {
        draw_ring(b, h, 0, 2.2f * h->rim, -h->deep, -h->deep + t);
        int bolts = dmg_int(b, 0, 12);
        dmg_xy at[RIM];
        outline_of(h, 1.6f * h->rim, at);
        for (int i = 0; i < bolts; ++i) {
            dmg_xy p = at[i * RIM / bolts];
            dmg_rod(b, v3(p.x, p.y, -h->deep), v3(p.x, p.y, -h->deep + 2 * t), 0.3f * h->rim);
        }
    }
}

/* ---- the leaf, and how it hangs ---- */

static void draw_leaf(dmg_builder* b, const hatch* h) {
    float border = 0.9f * h->rim, t = h->t;
    if (h->dress == 2) { /* a pane in a frame */
        draw_ring(b, h, -0.45f * h->size, border, 0, t);
        draw_slab(b, h, -0.42f * h->size, 0.3f * t, 0.6f * t);
        return;
    }
    draw_slab(b, h, border, 0, t);
    if (h->dress == 1) draw_slab(b, h, -0.3f * h->size, t, 1.25f * t);
    if (h->dress == 3) { /* dished */
        dmg_save(b);
        dmg_move(b, 0, 0, t);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_dome(b, v3(0, 0, 0), v3(0.85f * h->x, 0.5f * t, 0.85f * h->y));
        dmg_restore(b);
    }
    if (h->dress == 4) /* ribs across */
        for (int i = -1; i <= 1; ++i)
            dmg_box(b, v3(0, 0.5f * h->y * (float)i, 1.1f * t), v3(1.5f * h->x, 0.12f * h->size, 0.4f * t));
}

/* Arms from the leaf to a pin beside the coaming, between lugs; the line lies level with the leaf. */
static uint32_t hang_leaf(dmg_builder* b, const hatch* h, const char* name) {
    float pin = h->side * (h->x + h->rim * (h->hinge == 2 ? 1.6f : 1.15f)), r = fmaxf(0.3f * h->t, 0.08f * h->rim);
    float z = h->t * dmg_range(b, 0.3f, 0.9f), apart = h->y * dmg_range(b, 0.35f, 0.65f),
          tall = h->size * dmg_range(b, 0.06f, 0.15f), arm = h->t * dmg_range(b, 0.3f, 0.6f);
    int count = h->hinge == 1 ? 1 : 2;
    uint32_t leaf = dmg_hinge(b, 0, name, v3(pin, 0, z), v3(0, h->side, 0), 0.0f, dmg_range(b, 1.4f, 2.9f));
    draw_leaf(b, h);
    for (int i = 0; i < count; ++i) {
        float y = count == 1 ? 0.0f : (i ? apart : -apart), high = count == 1 ? 3 * tall : tall;
        float in = h->side * h->x * (h->hinge == 2 ? 0.3f : 0.8f);
        dmg_box_span(b, v3(fminf(in, pin), y - high, h->t - 0.5f * arm), v3(fmaxf(in, pin), y + high, h->t + arm));
        dmg_rod(b, v3(pin, y - high, z), v3(pin, y + high, z), 1.3f * r);
        dmg_use(b, 0);
        for (int k = -1; k <= 1; k += 2) {
            float at = y + (float)k * 1.45f * high, low = h->side * (h->x + 0.5f * h->rim), far = pin + h->side * r;
            dmg_box_span(b, v3(fminf(low, far), at - 0.4f * high, -0.6f * h->deep),
                         v3(fmaxf(low, far), at + 0.4f * high, 0));
            dmg_box_span(b, v3(pin - r, at - 0.4f * high, -0.3f * h->deep), v3(pin + r, at + 0.4f * high, z + r));
        }
        dmg_use(b, leaf);
    }
    return leaf;
}

/* Draws a crane: an arm pinned beside the coaming, its other end over the leaf's middle, where the leaf turns on it. */
static uint32_t hang_on_crane(dmg_builder* b, const hatch* h) {
    float pin = h->side * (h->x + 2.0f * h->rim), z = h->t + 0.25f * h->size, r = 0.08f * h->size,
          tall = h->y * dmg_range(b, 0.3f, 0.8f);
    for (int k = -1; k <= 1; k += 2) {
        float x0 = h->side * (h->x + 0.5f * h->rim), x1 = pin + h->side * r, y = (float)k * (tall + 1.2f * r);
        dmg_box_span(b, v3(fminf(x0, x1), y - r, -0.7f * h->deep), v3(fmaxf(x0, x1), y + r, 0));
        dmg_box_span(b, v3(pin - r, y - r, -0.3f * h->deep), v3(pin + r, y + r, z + r));
    }
    uint32_t arm = dmg_hinge(b, 0, "arm", v3(pin, 0, z), v3(0, h->side, 0), 0.0f, dmg_range(b, 1.2f, 2.4f));
    dmg_rod(b, v3(pin, -tall, z), v3(pin, tall, z), r);
    if (dmg_chance(b, 0.5f))
        dmg_beam(b, v3(pin, 0, z), v3(0, 0, z), 2 * r, 2 * r);
    else
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3(pin, (float)k * 0.8f * tall, z), v3(0, 0, z), 1.6f * r, 1.6f * r);
    dmg_rod(b, v3(0, 0, z - 1.2f * r), v3(0, 0, z + 1.2f * r), 2 * r);
    float slew = dmg_range(b, 0.3f, 1.2f);
    uint32_t leaf = dmg_chance(b, 0.5f) ? dmg_spin(b, arm, "leaf", v3(0, 0, 0), v3(0, 0, dmg_sign(b)))
                                        : dmg_hinge(b, arm, "leaf", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, slew);
    draw_leaf(b, h);
    dmg_rod(b, v3(0, 0, h->t), v3(0, 0, z), r);
    int grips = dmg_int(b, 2, 4);
    float reach = h->size + 0.7f * h->rim;
    for (int i = 0; i < grips; ++i) { /* lugs it is turned by */
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, grips);
        dmg_rod(b, v3(0.75f * h->size, 0, h->t), v3(0.75f * h->size, 0, h->t + 0.2f * h->size), 0.05f * h->size);
        dmg_restore(b);
    }
    dmg_torus(b, v3(0, 0, h->t), v3(0, 0, 1), 0.6f * reach, 0.06f * h->size);
    return leaf;
}

/* ---- what locks it ---- */

/* At (0, y) of the leaf: spins, has a few turns, or goes along its screw. */
static void draw_hand_wheel(dmg_builder* b, const hatch* h, uint32_t leaf, dmg_vec foot) {
    float r = h->size * dmg_range(b, 0.25f, 0.7f), rise = h->size * dmg_range(b, 0.12f, 0.35f);
    int joint = dmg_weighted(b, (const float[]){3, 2, 1}, 3), spokes = dmg_int(b, 3, 6);
    dmg_use(b, leaf);
    dmg_save(b);
    dmg_move(b, foot.x, foot.y, foot.z);
    dmg_rod(b, v3(0, 0, -0.3f * h->t), v3(0, 0, 0.5f * rise), 0.18f * r);
    dmg_vec axis = {0, 0, dmg_sign(b)};
    if (joint == 0) dmg_spin(b, leaf, "hand_wheel", v3(0, 0, 0), axis);
    if (joint == 1) dmg_hinge(b, leaf, "hand_wheel", v3(0, 0, 0), axis, 0.0f, dmg_range(b, 1.5f, 6.0f));
    if (joint == 2) {
        float turns = dmg_range(b, 6.0f, 19.0f);
        dmg_screw(b, leaf, "hand_wheel", v3(0, 0, 0), v3(0, 0, 1), 0.4f * rise / turns, 0.0f, turns);
    }
    dmg_rod(b, v3(0, 0, 0.4f * rise), v3(0, 0, rise), 0.12f * r);
    dmg_move(b, 0, 0, rise);
    if (h->wheel == 0) dmg_wheel_draw(b, 3, r, 0.2f * r, spokes);
    if (h->wheel == 1) dmg_wheel_draw(b, 6, r, 0.2f * r, spokes);
    if (h->wheel == 2) { /* a capstan of rods */
        for (int i = 0; i < spokes; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 0, 1), i, spokes);
            dmg_rod(b, v3(0, 0, 0), v3(r, 0, 0), 0.05f * r);
            dmg_ellipsoid(b, v3(r, 0, 0), v3(0.1f * r, 0.1f * r, 0.1f * r));
            dmg_restore(b);
        }
        dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.1f * r), 0.25f * r);
    }
    if (h->wheel == 3) dmg_box(b, v3(0, 0, 0), v3(2 * r, 0.2f * r, 0.15f * r)); /* a bar */
    if (h->wheel == 4) {                                                        /* a crank */
        dmg_beam(b, v3(0, 0, 0), v3(r, 0, 0), 0.15f * r, 0.1f * r);
        dmg_rod(b, v3(r, 0, 0), v3(r, 0, 0.5f * r), 0.07f * r);
    }
    dmg_restore(b);
    dmg_use(b, leaf);
}

/* Levers pinned in the coaming that turn over the leaf's edge, or in the leaf and turn over the coaming. */
static void draw_dogs(dmg_builder* b, const hatch* h, uint32_t leaf) {
    int count = dmg_int(b, 2, 4);
    bool on_leaf = dmg_chance(b, 0.4f);
    uint32_t carrier = on_leaf ? leaf : 0;
    float r = fmaxf(0.13f * h->rim, h->size * dmg_range(b, 0.02f, 0.045f)), reach = h->size * dmg_range(b, 0.2f, 0.5f),
          swing = dmg_range(b, 0.9f, 2.2f), top = h->t * 1.1f + r;
    if (dmg_chance(b, 0.5f)) swing = -swing;
    for (int i = 0; i < count; ++i) {
        /* along the free side, so that the hinge's is left alone */
        float y = h->y * 0.75f * (2.0f * ((float)i + 0.5f) / (float)count - 1.0f), n = fabsf(y / h->y);
        float edge = powf(1.0f - powf(n, h->power), 1.0f / h->power);
        float x = edge * (h->x + h->rim) + (on_leaf ? -0.8f * h->rim : 0.6f * r), way = on_leaf ? 1.0f : -1.0f;
        dmg_save(b);
        dmg_move(b, -h->side * x, y, 0);
        if (h->side > 0) dmg_turn(b, v3(0, 0, 1), DMG_PI);
        dmg_use(b, carrier);
        dmg_rod(b, v3(0, 0, on_leaf ? 0.5f * h->t : -0.4f * h->deep), v3(0, 0, top), 1.2f * r);
        dmg_hinge(b, carrier, "dog", v3(0, 0, 0), v3(0, 0, 1), fminf(0, swing), fmaxf(0, swing));
        dmg_rod(b, v3(0, 0, top), v3(0, 0, top + 1.6f * r), 1.6f * r);
        dmg_beam(b, v3(0, 0, top + 0.6f * r), v3(way * 0.6f * reach, 0, top + 0.6f * r), 1.6f * r, r);
        dmg_rod(b, v3(0, 0, top + r), v3(-way * reach, 0, top + reach * 0.5f), 0.7f * r);
        dmg_restore(b);
    }
    dmg_use(b, leaf);
}

/* Bolts that go out of the leaf over the coaming, in two guides each; those next to the hinge are left out. */
static void draw_bolts(dmg_builder* b, const hatch* h, uint32_t leaf, dmg_vec foot) {
    int count = dmg_int(b, 3, 8);
    float r = h->size * dmg_range(b, 0.03f, 0.08f), z = h->t * 1.1f + 1.3f * r;
    dmg_xy edge[RIM];
    outline_of(h, 0.8f * h->rim, edge);
    for (int i = 0; i < count; ++i) {
        dmg_xy p = edge[(i * RIM / count + RIM / 2) % RIM];
        if (p.x * h->side > 0.5f * h->x) continue;
        dmg_vec end = {p.x, p.y, z}, way = v3_normalize(v3(p.x - foot.x, p.y - foot.y, 0));
        float length = 0.55f * v3_length(v3(p.x - foot.x, p.y - foot.y, 0));
        dmg_use(b, leaf);
        for (int k = 0; k < 2; ++k) {
            dmg_vec at = v3_mad(end, way, -length * (k ? 0.25f : 0.6f));
            dmg_box_span(b, v3(at.x - 2 * r, at.y - 2 * r, 0.8f * h->t), v3(at.x + 2 * r, at.y + 2 * r, z + 1.5f * r));
        }
        dmg_slide(b, leaf, "bolt", v3_scale(way, -1), 0.0f, length * dmg_range(b, 0.2f, 0.35f));
        dmg_rod(b, v3_mad(end, way, -length), end, r);
    }
    dmg_use(b, leaf);
}

/* Draws a beam across the leaf, pinned on the coaming, whose screw in the middle presses the leaf shut. */
static void draw_strongback(dmg_builder* b, const hatch* h, uint32_t leaf) {
    float z = h->t + 0.2f * h->size, r = 0.07f * h->size, pin = h->y + 1.5f * h->rim, end = -h->y - 1.2f * h->rim;
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2) {
        dmg_box_span(b, v3((float)k * 2.4f * r - r, pin - 2 * r, -0.8f * h->deep),
                     v3((float)k * 2.4f * r + r, pin + r, z + r));
        dmg_box_span(b, v3((float)k * 2.4f * r - r, h->y + 0.5f * h->rim, -0.8f * h->deep),
                     v3((float)k * 2.4f * r + r, pin, 0));
        dmg_box_span(b, v3((float)k * 2.4f * r - r, end, -0.8f * h->deep), v3((float)k * 2.4f * r + r, end + r, z + r));
        dmg_box_span(b, v3((float)k * 2.4f * r - r, end, -0.8f * h->deep),
                     v3((float)k * 2.4f * r + r, -h->y - 0.5f * h->rim, 0));
    }
    uint32_t bar = dmg_hinge(b, 0, "strongback", v3(0, pin, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
    dmg_box_span(b, v3(-r, end - r, z - r), v3(r, pin, z + r));
    dmg_rod(b, v3(-1.2f * r, pin, z), v3(1.2f * r, pin, z), 1.2f * r);
    dmg_rod(b, v3(0, 0, z - 1.2f * r), v3(0, 0, z + 1.6f * r), 2 * r);
    draw_hand_wheel(b, h, bar, v3(0, 0, z + r));
    dmg_use(b, leaf);
}

/* Draws a lever on a shaft through the leaf, or a grab rail. */
static void draw_leaf_lever(dmg_builder* b, const hatch* h, uint32_t leaf, float y) {
    float x = -0.4f * h->side * h->x, length = h->size * dmg_range(b, 0.3f, 0.6f), r = 0.04f * h->size;
    dmg_use(b, leaf);
    dmg_vec pin = {x, y, h->t};
    dmg_rod(b, pin, v3_add(pin, v3(0, 0, 2.5f * r)), 2 * r);
    float swing = dmg_range(b, 0.7f, 1.8f);
    dmg_hinge(b, leaf, "lever", pin, v3(0, 0, dmg_sign(b)), 0.0f, swing);
    dmg_vec start = v3_add(pin, v3(0, 0, 3 * r)), end = v3_add(start, v3(h->side * length, 0, 0.5f * r));
    dmg_rod(b, v3_add(pin, v3(0, 0, 2.5f * r)), v3_add(pin, v3(0, 0, 4 * r)), 2 * r);
    dmg_beam(b, start, end, 1.5f * r, r);
    dmg_rod(b, v3_lerp(start, end, 0.5f), end, r);
    dmg_use(b, leaf);
}

/* Draws a small cover over a glass that turns aside or up. */
static void draw_deadlight(dmg_builder* b, const hatch* h, uint32_t leaf, float y) {
    float r = 0.22f * h->size, z = 1.3f * h->t;
    dmg_use(b, leaf);
    const dmg_xy rim[] = {{0.8f * r, h->t}, {1.1f * r, h->t}, {1.1f * r, z}, {0.8f * r, z}, {0.8f * r, h->t}};
    dmg_lathe(b, v3(0, y, 0), v3(0, 0, 1), rim, 5);
    bool aside = dmg_chance(b, 0.5f);
    float swing = dmg_range(b, 1.0f, 2.6f);
    if (aside)
        dmg_hinge(b, leaf, "deadlight", v3(0, y + 1.2f * r, 0), v3(0, 0, dmg_sign(b)), 0.0f, swing);
    else
        dmg_hinge(b, leaf, "deadlight", v3(0, y + 1.2f * r, z), v3(-1, 0, 0), 0.0f, 1.1f * swing);
    dmg_rod(b, v3(0, y, z + 0.02f * r), v3(0, y, z + 0.2f * r), r);
    dmg_box(b, v3(0, y + 1.1f * r, z + 0.1f * r), v3(0.3f * r, 0.5f * r, 0.16f * r));
    dmg_use(b, leaf);
}

static void draw_hatch(dmg_builder* b, hatch* h, int coaming, bool flat) {
    int lock = dmg_weighted(b, (const float[]){2.5f, 3, 2.5f, 1.5f, 1.5f}, 5); /* wheel, dogs, bolts, back, crane */
    if (lock == 4 && h->y > 1.2f * h->x) lock = 0;
    draw_coaming(b, h, coaming);
    if (lock == 4) {
        hang_on_crane(b, h);
        dmg_use(b, 0);
        return;
    }
    bool tall = h->y > 1.5f * h->x, free = lock != 3;
    uint32_t leaf = hang_leaf(b, h, flat ? "lid" : "hatch");
    float y = tall && free ? h->y * dmg_range(b, -0.2f, 0.2f) : 0.0f, top = h->dress == 2 ? 0.6f * h->t : 1.2f * h->t;
    dmg_vec foot = {0, y, top};
    if (lock == 1) draw_dogs(b, h, leaf);
    if (lock == 2) draw_bolts(b, h, leaf, foot);
    if (lock == 3) draw_strongback(b, h, leaf);
    bool wheel = lock == 0 || (lock == 2 && dmg_chance(b, 0.7f)) || (lock == 1 && dmg_chance(b, 0.3f));
    if (wheel) draw_hand_wheel(b, h, leaf, foot);
    if (!wheel && free && h->dress < 2) draw_leaf_lever(b, h, leaf, 0);
    if (tall && free && h->dress == 0 && dmg_chance(b, 0.6f)) draw_deadlight(b, h, leaf, 0.7f * h->y);
    dmg_use(b, 0);
}

/* ---- where it is ---- */

/* Draws a tank or chamber along -Z behind the hatch, lying on saddles. */
static void draw_chamber(dmg_builder* b, const hatch* h, float length) {
    float wall = 0.6f * h->rim;
    draw_ring(b, h, 0.2f * h->rim, 0.2f * h->rim + wall, -h->deep - length, -h->deep);
    int hoops = dmg_int(b, 0, 4);
    for (int i = 0; i < hoops; ++i) {
        float z = -h->deep - length * ((float)i + 0.5f) / (float)hoops;
        draw_ring(b, h, 0.2f * h->rim + wall, 0.8f * h->rim + wall, z - wall, z + wall);
    }
    for (int k = 0; k < 2; ++k)
        dmg_box(b, v3(0, -h->y - 1.5f * h->rim, -h->deep - length * (k ? 0.8f : 0.2f)),
                v3(1.2f * h->x, 2.2f * h->rim, 0.1f * length));
}

void dmg_build_pressure_hatch(dmg_builder* b) {
    hatch h = pick_hatch(b);
    int place = dmg_weighted(b, (const float[]){4, 3, 2}, 3); /* bulkhead, deck, chamber */
    float length = h.size * dmg_range(b, 1.5f, 5.0f);
    dmg_move(b, 0, 1.5f * h.y + 2 * h.rim, 0);
    if (place == 1) {
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)dmg_int(b, 0, 3));
    }
    draw_hatch(b, &h, place == 2 ? 0 : dmg_int(b, 0, 2), place == 1);
    if (place < 2) return;
    draw_chamber(b, &h, length);
    if (dmg_chance(b, 0.5f)) {
        draw_slab(b, &h, h.rim, -h.deep - length - h.rim, -h.deep - length);
        return;
    }
    hatch far = pick_hatch(b); /* the other end's: the same opening */
    far.x = h.x;
    far.y = h.y;
    far.power = h.power;
    far.size = h.size;
    far.rim = h.rim;
    far.deep = h.deep;
    far.t = h.t;
    dmg_move(b, 0, 0, -2 * h.deep - length);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    draw_hatch(b, &far, 0, false);
}
