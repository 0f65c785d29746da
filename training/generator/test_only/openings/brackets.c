/* Draws jointed wall arms with a screen, a mirror or a lamp, and scissor arms; wire pet crates and carriers with
 * doors and latches. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- wall arm ---- */

/* Draws what the arm holds, at the origin of its tilting head, facing +Z: a screen, a round mirror, a lamp, a tray. */
static void draw_held(dmg_builder* b, int kind, float size) {
    float t = 0.06f * size, high = size * dmg_range(b, 0.5f, 0.7f);
    bool portrait = dmg_chance(b, 0.1f);
    dmg_rod(b, v3(0, 0, -0.05f * size), v3(0, 0, 0.06f * size), 0.1f * size);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.06f * size + t);
    if (portrait) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (kind == 0) {
        dmg_box(b, v3(0, 0, -t), v3(0.5f * size, 0.4f * high, t));
        dmg_rounded_plate(b, 1.6f * size, 1.6f * high, t, 0.03f * size);
    } else if (kind == 1) {
        dmg_rod(b, v3(0, 0, -t), v3(0, 0, 0), 0.6f * size);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.6f * size, 0.5f * t);
    } else if (kind == 2) {
        const dmg_xy shade[] = {{0.1f * size, -t},    {0.2f * size, 0},  {0.5f * size, high},
                                {0.46f * size, high}, {0.15f * size, 0}, {0.1f * size, -t}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), shade, 6);
        dmg_ellipsoid(b, v3(0, 0, 0.3f * high), v3(0.16f * size, 0.16f * size, 0.3f * high));
    } else {
        dmg_box(b, v3(0, 0, 0), v3(0.4f * size, 0.3f * size, 2 * t));
        dmg_box_span(b, v3(-0.7f * size, -0.15f * size - t, -t), v3(0.7f * size, -0.15f * size, size));
    }
    dmg_restore(b);
}

/* Draws a head at the end: it may swivel, then tilt, then turn in its plane. */
static void draw_arm_head(dmg_builder* b, uint32_t arm, dmg_vec at, int held, float size) {
    float swivel = dmg_range(b, 0.5f, 1.5f), tilt = dmg_range(b, 0.2f, 1.0f), t = 0.05f * size;
    bool swivels = dmg_chance(b, 0.6f), rolls = dmg_chance(b, 0.25f), fork = dmg_chance(b, 0.3f);
    uint32_t part = arm;
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    if (swivels) part = dmg_hinge(b, part, "swivel", v3(0, 0, 0), v3(0, 1, 0), -swivel, swivel);
    dmg_rod(b, v3(0, -2.5f * t, 0), v3(0, 2.5f * t, 0), 1.1f * t);
    dmg_box_span(b, v3(-0.6f * t, -t, 0), v3(0.6f * t, t, 3 * t));
    dmg_move(b, 0, 0, 3.2f * t);
    if (fork)
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(1.8f * (float)s * t, 0, 0), v3(0.5f * t, 2 * t, 2.4f * t));
    if (fork) dmg_box(b, v3(0, 0, -t), v3(4 * t, 2 * t, 0.4f * t));
    part = dmg_hinge(b, part, "tilt", v3(0, 0, 0), v3(1, 0, 0), -tilt, tilt);
    dmg_rod(b, v3(-2.4f * t, 0, 0), v3(2.4f * t, 0, 0), 0.8f * t);
    dmg_box(b, v3(0, 0, 0.8f * t), v3(t, t, 1.6f * t));
    dmg_move(b, 0, 0, 1.2f * t + 0.05f * size);
    if (rolls) dmg_spin(b, part, "roll", v3(0, 0, 0), v3(0, 0, 1));
    draw_held(b, held, size);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws two or three links that swing about upright pins; the last may lift as a parallelogram's arm does. */
static void draw_links(dmg_builder* b, int held, float size) {
    int count = dmg_int(b, 1, 3), shape = dmg_int(b, 0, 2);
    float reach = size * dmg_range(b, 0.8f, 1.8f), t = size * dmg_range(b, 0.03f, 0.06f),
          plate = size * dmg_range(b, 0.2f, 0.4f), z = 2.2f * t;
    dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(plate, 1.4f * plate, t), 0.4f * t);
    dmg_box_span(b, v3(-t, -3 * t, -0.2f * t), v3(t, -1.5f * t, z + t));
    dmg_box_span(b, v3(-t, 1.5f * t, -0.2f * t), v3(t, 3 * t, z + t));
    uint32_t part = 0;
    dmg_vec at = v3(0, 0, z);
    for (int i = 0; i < count; ++i) { /* folded to and fro before the wall, each stretched out by its rest */
        float swing = i ? dmg_range(b, 2.0f, 2.9f) : dmg_range(b, 1.2f, 1.5f), side = i & 1 ? -1.0f : 1.0f,
              rest = swing * dmg_unit(b);
        dmg_vec end = v3(at.x + side * reach, 0, at.z + (i ? 0.25f * t : 0.0f));
        part = dmg_hinge(b, part, "link", at, v3(0, -side, 0), 0.0f, swing);
        dmg_rest(b, part, rest);
        float y = i & 1 ? 2.6f * t : 0.0f;
        dmg_rod(b, v3(at.x, -1.45f * t, at.z), v3(at.x, y + 1.45f * t, at.z), t);
        for (int k = shape == 1 ? -1 : 1; k <= 1; k += 2) {
            float lift = y + (shape == 1 ? 0.8f * (float)k * t : 0.0f);
            if (shape == 2)
                dmg_rod(b, v3(at.x, lift, at.z), v3(end.x, lift, end.z), 0.7f * t);
            else
                dmg_beam(b, v3(at.x, lift, at.z), v3(end.x, lift, end.z), 1.2f * t, (shape == 1 ? 0.7f : 2.0f) * t);
        }
        dmg_rod(b, v3(end.x, fminf(y, 0.0f) - 1.4f * t, end.z), v3(end.x, y + 1.4f * t, end.z), 1.1f * t);
        at = end;
    }
    float lift = count & 1 ? 0.0f : 2.6f * t;
    draw_arm_head(b, part, v3(at.x, lift, at.z + 1.5f * t), held, size);
}

/* Crossed laths that stretch: each cross turns about the pin of the one before it. */
static void draw_scissors(dmg_builder* b, int held, float size) {
    int crosses = dmg_int(b, 2, 4);
    float half = size * dmg_range(b, 0.2f, 0.35f), open = dmg_range(b, 0.35f, 0.9f), t = 0.1f * half;
    float deep = 2 * half * sinf(open), high = 2 * half * cosf(open);
    dmg_box_span(b, v3(-2.5f * t, -0.7f * high, -2 * t), v3(2.5f * t, 0.7f * high, -t)); /* the plate on the wall */
    dmg_rod(b, v3(0, -0.62f * high, 0), v3(0, 0.62f * high, 0), 0.6f * t);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-t, 0.6f * (float)s * high - t, -1.5f * t), v3(t, 0.6f * (float)s * high + t, t));
    uint32_t whole = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0), -1.3f, 1.3f), part = whole;
    dmg_rod(b, v3(0, 0.5f * high - 1.5f * t, 0), v3(0, 0.5f * high + 1.2f * t, 0), 1.3f * t);
    float z = 0;
    for (int i = 0; i < crosses; ++i) { /* the stretch of each cross carries all those before it */
        part = dmg_slide(b, part, "cross", v3(0, 0, -1), 0.0f, 0.7f * deep);
        for (int s = -1; s <= 1; s += 2) {
            float x = 0.7f * (float)s * t, y = 0.5f * (float)s * high;
            dmg_beam(b, v3(x, -y, z), v3(x, y, z + deep), t, 1.8f * t);
            dmg_rod(b, v3(-1.6f * t, y, z + deep), v3(1.6f * t, y, z + deep), 0.6f * t);
        }
        dmg_rod(b, v3(-1.6f * t, 0, z + 0.5f * deep), v3(1.6f * t, 0, z + 0.5f * deep), 0.6f * t);
        z += deep;
    }
    dmg_rod(b, v3(0, -0.5f * high, z), v3(0, 0.5f * high, z), t);
    draw_arm_head(b, part, v3(0, 0, z + 1.2f * t), held, size);
}

void dmg_build_wall_arm(dmg_builder* b) {
    int held = dmg_int(b, 0, 3);
    float size = held == 0 ? dmg_scale_range(b, 0.2f, 0.6f) : dmg_range(b, 0.12f, 0.22f);
    dmg_move(b, 0, 2 * size, 0);
    if (dmg_chance(b, 0.75f))
        draw_links(b, held, size);
    else
        draw_scissors(b, held, size);
}

/* ---- pet crate ---- */

typedef struct crate {
    float half, high, deep, bar; /* deep: half of the depth */
    float pitch;
} crate;

/* Draws a grid of wires in x, y about the origin. */
static void draw_grid(dmg_builder* b, const crate* c, float w, float h) {
    int columns = (int)(w / c->pitch) + 2, rows = (int)(h / (3 * c->pitch)) + 2;
    for (int i = 0; i < columns; ++i) {
        float x = w * ((float)i / (float)(columns - 1) - 0.5f);
        dmg_box(b, v3(x, 0, 0), v3(c->bar, h, c->bar));
    }
    for (int i = 0; i < rows; ++i) {
        float y = h * ((float)i / (float)(rows - 1) - 0.5f);
        dmg_box(b, v3(0, y, c->bar), v3(w + c->bar, c->bar, c->bar));
    }
}

/* Draws a door in a front w x h about the origin of z = 0, a bolt with its handle on it; the rest of the front stays.
 */
static void draw_wire_door(dmg_builder* b, const crate* c, float w, float h) {
    float half = w * dmg_range(b, 0.25f, 0.4f), high = h * dmg_range(b, 0.6f, 0.85f), swing = dmg_range(b, 1.4f, 2.8f),
          x = (0.45f * w - half) * dmg_range(b, -1.0f, 1.0f), y = (0.46f * h - 0.5f * high) * dmg_range(b, -1.0f, 0.5f);
    int bolts = dmg_int(b, 0, 2);
    bool up = dmg_chance(b, 0.2f);
    for (int s = -1; s <= 1; s += 2) { /* beside the door, above it and below */
        float edge = 0.5f * (float)s * w, to = x + (float)s * half, top = 0.5f * (float)s * h,
              door = y + 0.5f * (float)s * high;
        dmg_save(b);
        dmg_move(b, 0.5f * (edge + to), 0, 0);
        draw_grid(b, c, fabsf(edge - to), h);
        dmg_restore(b);
        dmg_save(b);
        dmg_move(b, x, 0.5f * (top + door), 0);
        draw_grid(b, c, 2 * half, fabsf(top - door));
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, x, y, 2.6f * c->bar);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    uint32_t door = up ? dmg_hinge(b, 0, "door", v3(0, 0.5f * high, 0), v3(-1, 0, 0), 0.0f, swing)
                       : dmg_hinge(b, 0, "door", v3(-half, 0, 0), v3(0, -1, 0), 0.0f, swing);
    draw_grid(b, c, 2 * half, high);
    for (int i = 0; i < bolts; ++i) {
        float at = bolts == 1 ? 0.0f : high * (0.3f - 0.6f * (float)i), r = c->bar, z = 2.6f * r;
        dmg_slide(b, door, "bolt", v3(-1, 0, 0), 0.0f, 0.1f * half + 0.01f);
        dmg_rod(b, v3(0.6f * half, at, z), v3(half + 4 * r, at, z), r);
        dmg_box_span(b, v3(0.7f * half, at - 8 * r, z - 0.8f * r), v3(0.7f * half + 2 * r, at, z + 0.8f * r));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Wire all round, a tray drawn out below, doors in front, at the side or on top. */
static void draw_wire_crate(dmg_builder* b, const crate* c) {
    float h = c->high, t = 0.03f * h;
    bool side_door = dmg_chance(b, 0.35f), top_door = dmg_chance(b, 0.35f), tray = dmg_chance(b, 0.6f);
    for (int i = 0; i < 5; ++i) { /* front, right, back, left, top */
        bool across = i == 1 || i == 3;
        float out = across ? c->half : c->deep, w = across ? 2 * c->deep : 2 * c->half;
        dmg_save(b);
        dmg_move(b, 0, t + (i == 4 ? h : 0.5f * h), 0);
        if (i == 4) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        if (i < 4) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)i);
        if (i < 4) dmg_move(b, 0, 0, out);
        float high = i == 4 ? 2 * c->deep : h;
        if (i == 0 || (i == 1 && side_door) || (i == 4 && top_door))
            draw_wire_door(b, c, w, high);
        else
            draw_grid(b, c, w, high);
        dmg_restore(b);
    }
    if (tray) dmg_slide(b, 0, "tray", v3(0, 0, 1), 0.0f, 1.4f * c->deep);
    dmg_box_span(b, v3(-0.98f * c->half, 0, -0.98f * c->deep), v3(0.98f * c->half, 0.8f * t, 1.02f * c->deep));
    dmg_use(b, 0);
}

/* Draws two shells of plastic, a grid in front, a handle and a hatch on top, latches on the seam. */
static void draw_carrier(dmg_builder* b, const crate* c) {
    float h = c->high, t = 0.03f * c->half, seam = h * dmg_range(b, 0.4f, 0.6f), r = 0.1f * c->half;
    int latches = dmg_int(b, 0, 2);
    bool hatch = dmg_chance(b, 0.35f);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * h, c->deep);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * c->half, h, 2 * c->deep, t);
    draw_wire_door(b, c, 2 * c->half - 2 * t, h - 2 * t);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (c->half + 0.5f * t);
        dmg_box(b, v3(x, seam, 0), v3(2 * t, 2 * t, 2 * c->deep));
        for (int i = 0; i < latches; ++i) {
            float z = c->deep * (latches == 1 ? 0.0f : (float)i - 0.5f), out = x + 1.5f * (float)s * t;
            dmg_hinge(b, 0, "latch", v3(out, seam - r, z), v3(0, 0, -(float)s), 0.0f, dmg_range(b, 1.2f, 2.6f));
            dmg_box(b, v3(out, seam, z), v3(t, 2 * r, 1.6f * r));
            dmg_use(b, 0);
        }
    }
    if (hatch) { /* with the handle on it */
        dmg_hinge(b, 0, "top_door", v3(-0.6f * c->half, h + t, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.4f, 2.6f));
        dmg_box_span(b, v3(-0.6f * c->half, h + 0.1f * t, -0.6f * c->deep), v3(0.6f * c->half, h + t, 0.6f * c->deep));
    } else if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, 0, "handle", v3(0, h + 0.5f * t, 0), v3(0, 0, 1), -1.4f, 1.4f);
    }
    const dmg_vec bow[] = {v3(0, h + 0.5f * t, -0.4f * c->deep), v3(0, h + 2.2f * r, -0.35f * c->deep),
                           v3(0, h + 2.6f * r, 0), v3(0, h + 2.2f * r, 0.35f * c->deep),
                           v3(0, h + 0.5f * t, 0.4f * c->deep)};
    dmg_sweep(b, bow, 5, 0.6f * t, t, false);
    dmg_use(b, 0);
}

void dmg_build_pet_crate(dmg_builder* b) {
    crate c = {.half = dmg_scale_range(b, 0.16f, 0.4f)};
    c.high = c.half * dmg_range(b, 1.6f, 2.3f);
    c.deep = c.half * dmg_range(b, 1.0f, 1.7f);
    c.bar = c.half * dmg_range(b, 0.012f, 0.022f);
    c.pitch = c.half * dmg_range(b, 0.1f, 0.2f);
    if (dmg_chance(b, 0.6f))
        draw_wire_crate(b, &c);
    else
        draw_carrier(b, &c);
}
