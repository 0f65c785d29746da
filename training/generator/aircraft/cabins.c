/* Draws an aircraft's cabin: doors of every kind in a curved side, and seats with what folds down before them. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"

/* ---- cabin door: the side faces +X, its outermost line is the origin's ---- */

typedef enum door_way { WAY_SWING, WAY_ROLL, WAY_SLIDE, WAY_STAIR, WAY_CLAM, WAY_UP, WAY_KINDS } door_way;

typedef struct doorway {
    float radius;  /* of the side */
    float a0, a1;  /* the opening's angles */
    float z0, z1;  /* and where it is along the side */
    float t, high; /* of the skin; height of the opening */
    float ease;    /* gap round the door */
    int steps;
} doorway;

static dmg_vec side_point(const doorway* d, float out, float angle, float z) {
    dmg_vec p = dmg_skin_point(d->radius + out, angle, z);
    p.x -= d->radius;
    return p;
}

/* Draws a patch of the side or of a door in it. */
static void draw_patch(dmg_builder* b, const doorway* d, float out, float a0, float a1, float z0, float z1, float t) {
    dmg_save(b);
    dmg_move(b, -d->radius, 0, 0);
    dmg_skin_cone(b, (dmg_xy){d->radius + out, z0}, (dmg_xy){d->radius + out, z1}, a0, a1, t);
    dmg_restore(b);
}

/* Draws the side round the opening, up to `above` and down to `below`. */
static void draw_side(dmg_builder* b, const doorway* d, float above, float below, float z0, float z1) {
    float low = d->a0 - below / d->radius, top = d->a1 + above / d->radius;
    draw_patch(b, d, 0, low, top, z0, d->z0, d->t);
    draw_patch(b, d, 0, low, top, d->z1, z1, d->t);
    draw_patch(b, d, 0, low, d->a0, d->z0, d->z1, d->t);
    draw_patch(b, d, 0, d->a1, top, d->z0, d->z1, d->t);
    if (dmg_chance(b, 0.5f)) { /* the floor inside */
        dmg_vec sill = side_point(d, -1.2f * d->t, d->a0, 0);
        float deep = d->high * dmg_range(b, 0.3f, 1.0f);
        dmg_box_span(b, v3(sill.x - deep, sill.y - 0.05f * d->high, z0), v3(sill.x, sill.y - 0.01f * d->high, z1));
    }
    int windows = dmg_int(b, 0, 3);
    float middle = 0.5f * (d->a0 + d->a1), half = 0.1f * d->high / d->radius, wide = 0.1f * (z1 - d->z1);
    for (int i = 0; i < windows; ++i) {
        float z = d->z1 + (z1 - d->z1) * ((float)i + 0.6f) / 3.4f;
        draw_patch(b, d, 0.01f * d->high, middle, middle + 2 * half, z, z + wide, 0.01f * d->high);
    }
}

/* Draws a handle that turns in the door, on a plate or let in; a window; a small flap that lets the pressure go. */
static void draw_door_furniture(dmg_builder* b, const doorway* d, uint32_t door, float out, bool flap) {
    float middle = d->a0 + (d->a1 - d->a0) * dmg_range(b, 0.35f, 0.55f), wide = d->z1 - d->z0, size = 0.05f * d->high;
    dmg_vec at = side_point(d, out, middle, d->z0 + wide * dmg_range(b, 0.3f, 0.7f));
    bool turns = dmg_chance(b, 0.75f), inside = dmg_chance(b, 0.3f), window = dmg_chance(b, 0.5f);
    float swing = dmg_range(b, 0.7f, 3.0f), long_ = 0.35f * wide * dmg_range(b, 0.5f, 1.0f), s = inside ? -1.0f : 1.0f;
    dmg_use(b, door);
    if (window)
        draw_patch(b, d, out + 0.006f * d->high, middle + 0.15f * d->high / d->radius,
                   middle + 0.35f * d->high / d->radius, d->z0 + 0.35f * wide, d->z1 - 0.35f * wide, 0.012f * d->high);
    if (inside) at.x -= 1.2f * d->t + 0.02f * d->high;
    if (dmg_chance(b, 0.5f)) dmg_box(b, at, v3(0.2f * size, 1.6f * size, 2.2f * size));
    if (turns) dmg_hinge(b, door, "handle", at, v3(dmg_sign(b), 0, 0), 0.0f, swing);
    dmg_rod(b, at, v3_add(at, v3(0.8f * s * size, 0, 0)), 0.25f * size);
    dmg_box(b, v3_add(at, v3(0.7f * s * size, 0, 0.4f * long_)), v3(0.3f * size, 0.5f * size, long_));
    dmg_use(b, door);
    if (!flap) return;
    float top = d->a1 - 0.06f * d->high / d->radius, low = top - 0.12f * d->high / d->radius;
    dmg_hinge(b, door, "vent_flap", side_point(d, out + 0.01f * d->high, top, 0), v3(0, 0, 1), 0.0f, 0.9f);
    draw_patch(b, d, out + 0.015f * d->high, low, top, d->z0 + 0.3f * wide, d->z1 - 0.3f * wide, 0.012f * d->high);
    dmg_use(b, door);
}

/* Arms or barrels on a standing line beside the opening. */
static void draw_arms(dmg_builder* b, const doorway* d, dmg_vec line, bool far_side) {
    float r = 0.015f * d->high, wide = d->z1 - d->z0, into = far_side ? -0.25f * wide : 0.25f * wide;
    int count = dmg_int(b, 0, 3);
    bool necks = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        float angle = d->a0 + (d->a1 - d->a0) * ((float)i + 0.5f) / (float)count;
        dmg_vec on = side_point(d, 0.5f * r, angle, line.z);
        dmg_rod(b, v3(line.x, on.y - 1.5f * r, line.z), v3(line.x, on.y + 1.5f * r, line.z), r);
        if (necks) dmg_beam(b, v3(line.x, on.y, line.z), v3_add(on, v3(0, 0, into)), 2 * r, 2 * r);
    }
}

/* Treads on the inside of a door that lies down, with rails or chains beside them. */
static void draw_stairs(dmg_builder* b, const doorway* d, uint32_t door, float top) {
    float wide = 0.7f * (d->z1 - d->z0), z = 0.5f * (d->z0 + d->z1), deep = d->high * dmg_range(b, 0.08f, 0.16f);
    bool fold = dmg_chance(b, 0.35f), rails = dmg_chance(b, 0.5f);
    for (int i = 0; i < d->steps; ++i) {
        float angle = d->a0 + (top - d->a0) * ((float)i + 0.7f) / ((float)d->steps + 0.5f);
        dmg_vec at = side_point(d, -d->t - 0.5f * deep, angle, z);
        dmg_box(b, at, v3(deep, 0.02f * d->high, wide));
    }
    if (fold) { /* the lowest step swings out below */
        dmg_vec line = side_point(d, -d->t - 0.02f * d->high, top - 0.05f * (top - d->a0), z);
        dmg_hinge(b, door, "step", line, v3(0, 0, 1), 0.0f, dmg_range(b, 1.2f, 2.6f));
        dmg_box_span(b, v3(line.x - 0.02f * d->high, line.y - 0.18f * d->high, z - 0.4f * wide),
                     v3(line.x, line.y, z + 0.4f * wide));
        dmg_use(b, door);
    }
    for (int s = -1; s <= 1 && rails; s += 2) {
        float at = z + (float)s * 0.55f * wide;
        dmg_vec low = side_point(d, -d->t, d->a0 + 0.1f * (top - d->a0), at);
        dmg_vec up = side_point(d, -d->t, top - 0.1f * (top - d->a0), at);
        bool turns = s > 0 && dmg_chance(b, 0.4f);
        if (turns) dmg_hinge(b, door, "rail", low, v3(0, 0, 1), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_beam(b, low, v3_add(up, v3(-0.03f * d->high, 0, 0)), 0.02f * d->high, 0.02f * d->high);
        dmg_use(b, door);
    }
}

static uint32_t draw_door(dmg_builder* b, const doorway* d, door_way way, float a0, float a1) {
    float e = d->ease, out = 0, wide = d->z1 - d->z0, t = fmaxf(d->t, 0.02f * d->high) * (d->t > 0 ? 1.0f : 0.0f);
    bool fore = dmg_chance(b, 0.5f);
    uint32_t door = 0;
    dmg_vec line = v3(0.02f * d->high, 0, fore ? d->z1 : d->z0);
    if (way == WAY_SWING)
        door = dmg_hinge(b, 0, "cabin_door", line, v3(0, fore ? -1.0f : 1.0f, 0), 0.0f, dmg_range(b, 1.4f, 2.9f));
    if (way == WAY_ROLL) { /* on tracks up along the ceiling */
        out = -1.3f * d->t - 0.02f * d->high;
        door = dmg_hinge(b, 0, "plug_door", v3(-d->radius, 0, 0), v3(0, 0, 1), 0.0f,
                         dmg_range(b, 0.6f, 0.95f) * (a1 - a0));
    }
    if (way == WAY_SLIDE) {
        bool inside = dmg_chance(b, 0.35f);
        out = inside ? -1.3f * d->t - 0.02f * d->high : t + 0.01f * d->high;
        door = dmg_slide(b, 0, "sliding_door", v3(0, 0, fore ? 1.0f : -1.0f), 0.0f, wide * dmg_range(b, 0.6f, 0.95f));
    }
    if (way == WAY_STAIR)
        door = dmg_hinge(b, 0, "airstair_door", side_point(d, 0.01f * d->high, a0, 0), v3(0, 0, -1), 0.0f,
                         dmg_range(b, 1.3f, 2.3f));
    if (way == WAY_UP)
        door = dmg_hinge(b, 0, "hatch", side_point(d, 0.01f * d->high, a1, 0), v3(0, 0, 1), 0.0f,
                         dmg_range(b, 1.0f, 2.4f));
    draw_patch(b, d, out, a0 + e / d->radius, a1 - e / d->radius, d->z0 + e, d->z1 - e, t);
    if (way == WAY_SWING) draw_arms(b, d, line, fore);
    if (way == WAY_STAIR) draw_stairs(b, d, door, a1);
    doorway own = *d;
    own.a0 = a0;
    own.a1 = a1;
    own.high = d->high * (a1 - a0) / (d->a1 - d->a0);
    if (dmg_chance(b, 0.7f)) draw_door_furniture(b, &own, door, out, way < WAY_STAIR && dmg_chance(b, 0.3f));
    dmg_use(b, 0);
    return door;
}

void dmg_build_cabin_door(dmg_builder* b) {
    doorway d = {.high = dmg_scale_range(b, 0.1f, 2.2f)};
    static const float shares[] = {3, 2, 2, 3, 2, 2};
    door_way way = (door_way)dmg_weighted(b, shares, WAY_KINDS);
    float squat = way == WAY_UP ? dmg_range(b, 0.4f, 1.2f) : dmg_range(b, 1.1f, 2.6f), wide = d.high / squat,
          mid = dmg_range(b, -0.2f, 0.25f), ahead = wide * dmg_range(b, 0.25f, 1.2f);
    d.radius = d.high * dmg_scale_range(b, 0.7f, 5.0f);
    mid *= d.high / d.radius;
    d.a0 = mid - 0.5f * d.high / d.radius;
    d.a1 = mid + 0.5f * d.high / d.radius;
    d.z0 = -0.5f * wide;
    d.z1 = 0.5f * wide;
    d.t = dmg_chance(b, 0.35f) ? 0.0f : d.high * dmg_range(b, 0.015f, 0.06f);
    d.ease = dmg_chance(b, 0.4f) ? 0.002f * d.high : dmg_range(b, 0.003f, 0.02f) * d.high;
    d.steps = dmg_int(b, 2, 6);
    float above = d.high * dmg_range(b, 0.1f, 0.5f), below = d.high * dmg_range(b, 0.1f, 0.6f),
          fore = wide * dmg_range(b, 0.3f, 1.5f);
    if (way == WAY_SLIDE) ahead = fore = fmaxf(ahead, wide);
    dmg_move(b, 0, 1.3f * d.high, 0);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the side faces the front */
    draw_side(b, &d, above, below, d.z0 - ahead, d.z1 + fore);
    bool open = dmg_chance(b, 0.3f);
    uint32_t door;
    if (way == WAY_CLAM) {
        float split = d.a0 + (d.a1 - d.a0) * dmg_range(b, 0.35f, 0.65f);
        draw_door(b, &d, WAY_UP, split, d.a1);
        door = draw_door(b, &d, WAY_STAIR, d.a0, split);
    } else {
        door = draw_door(b, &d, way, d.a0, d.a1);
    }
    float share = dmg_range(b, 0.2f, 1.0f);
    if (open) dmg_rest(b, door, share * b->parts[door - 1].joint.upper);
}

/* ---- cabin seat: faces +Z, the middle of its cushion above the origin ---- */

typedef struct seat {
    float width, deep, pan, back, t; /* pan: its height; back: of the rest; t: of the cushions */
    float lean;
    bool soft;
} seat;

static void draw_cushion(dmg_builder* b, const seat* s, dmg_vec centre, dmg_vec size) {
    if (s->soft)
        dmg_rounded_box(b, centre, size, 0.3f * fminf(size.x, fminf(size.y, size.z)));
    else
        dmg_box(b, centre, size);
}

/* Draws a table folded up against the rear of the back: it comes down on its arms, and its leaf slides or unfolds. */
static void draw_tray_table(dmg_builder* b, const seat* s, uint32_t back, float z) {
    float high = 0.4f * s->back, wide = 0.8f * s->width, t = 0.02f * s->back,
          low = s->pan + s->back * dmg_range(b, 0.2f, 0.4f);
    bool latch = dmg_chance(b, 0.4f), slides = dmg_chance(b, 0.35f), double_ = dmg_chance(b, 0.3f);
    z -= 1.5f * t;
    if (latch) {
        dmg_vec pin = {0, low + high + 2 * t, z + t};
        dmg_hinge(b, back, "latch", pin, v3(0, 0, 1), -1.57f, 0.0f);
        dmg_box(b, v3(0, pin.y - 1.2f * t, z - 0.6f * t), v3(t, 4 * t, t));
        dmg_use(b, back);
    }
    /* It lies flat behind the back once it has turned by a quarter. */
    uint32_t table = dmg_hinge(b, back, "tray_table", v3(0, low, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.45f, 1.6f));
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.5f * wide - t, low - t, z - 0.4f * t),
                     v3((float)k * 0.5f * wide + t, low + 0.7f * high, z + 0.4f * t));
    if (slides) table = dmg_slide(b, table, "leaf", v3(0, 1, 0), 0.0f, 0.35f * high);
    dmg_box_span(b, v3(-0.5f * wide + 1.2f * t, low + 0.05f * high, z - 0.5f * t),
                 v3(0.5f * wide - 1.2f * t, low + high, z + 0.5f * t));
    if (double_ && !slides) {
        dmg_hinge(b, table, "leaf", v3(0, low + high, z - 1.0f * t), v3(1, 0, 0), 0.0f, 3.1f);
        dmg_box_span(b, v3(-0.45f * wide, low + 0.1f * high, z - 1.4f * t), v3(0.45f * wide, low + high, z - 0.6f * t));
    }
    dmg_use(b, back);
}

/* Draws the back with its headrest; leans about a line across the rear of the pan. Returns its part. */
static uint32_t draw_back(dmg_builder* b, const seat* s, uint32_t parent, bool reclines, bool table) {
    float z = -0.5f * s->deep, tall = s->back, tilt = dmg_range(b, 0.2f, 0.7f);
    uint32_t back = parent;
    if (reclines)
        back =
            dmg_hinge(b, parent, "backrest", v3(0, s->pan, z), v3(-1, 0, 0), dmg_chance(b, 0.3f) ? -1.1f : 0.0f, tilt);
    dmg_save(b);
    dmg_move(b, 0, s->pan, z);
    dmg_turn(b, v3(-1, 0, 0), s->lean);
    dmg_move(b, 0, -s->pan, -z);
    static const float kinds[] = {3, 2, 2, 1};
    int head = dmg_weighted(b, kinds, 4); /* none, on posts, wings, a net */
    float top = head == 1 ? 0.78f * tall : tall, size = 0.22f * tall;
    draw_cushion(b, s, v3(0, s->pan + 0.5f * top, z), v3(s->width, top, s->t));
    if (table) draw_tray_table(b, s, back, z - 0.5f * s->t);
    if (head == 1) {
        dmg_slide(b, back, "headrest", v3(0, 1, 0), 0.0f, 0.1f * tall);
        draw_cushion(b, s, v3(0, s->pan + 0.8f * tall + 0.5f * size, z), v3(0.6f * s->width, size, 0.8f * s->t));
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3((float)k * 0.15f * s->width, s->pan + 0.65f * tall, z),
                    v3((float)k * 0.15f * s->width, s->pan + 0.82f * tall, z), 0.012f * tall);
    }
    for (int k = -1; k <= 1 && head == 2; k += 2) { /* wings that fold forward */
        float x = (float)k * 0.28f * s->width, from = s->pan + 0.75f * tall, front = z + 0.5f * s->t;
        dmg_hinge(b, back, "headrest_wing", v3(x, from, front), v3(0, -(float)k, 0), 0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_box_span(b, v3(fminf(x, x + (float)k * 0.2f * s->width), from, front),
                     v3(fmaxf(x, x + (float)k * 0.2f * s->width), from + size, front + 0.25f * s->t));
        dmg_use(b, back);
    }
    dmg_restore(b);
    dmg_use(b, parent);
    return back;
}

/* Draws an armrest on a pin at its rear end; its front goes up between the backs. */
static void draw_armrest(dmg_builder* b, const seat* s, uint32_t parent, float x, bool lifts) {
    float y = s->pan + s->back * 0.3f, z = -0.5f * s->deep, long_ = s->deep * dmg_range(b, 0.7f, 0.95f),
          wide = 0.1f * s->width, t = 0.06f * s->back;
    bool cap = dmg_chance(b, 0.25f), post = !lifts || dmg_chance(b, 0.2f);
    uint32_t arm = parent;
    if (lifts) arm = dmg_hinge(b, parent, "armrest", v3(x, y, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.3f, 1.9f));
    draw_cushion(b, s, v3(x, y, z + 0.5f * long_), v3(wide, t, long_ + t));
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(x - 0.6f * wide, y, z), v3(x + 0.6f * wide, y, z), 0.6f * t);
    if (cap) { /* a lid on it, over the table or an ashtray */
        dmg_hinge(b, arm, "armrest_lid", v3(x, y + 0.55f * t, z + 0.35f * long_), v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 1.0f, 2.0f));
        dmg_box_span(b, v3(x - 0.45f * wide, y + 0.52f * t, z + 0.35f * long_),
                     v3(x + 0.45f * wide, y + 0.75f * t, z + 0.75f * long_));
    }
    dmg_use(b, parent);
    if (post && !lifts)
        dmg_box_span(b, v3(x - 0.4f * wide, s->pan - 0.5f * s->t, z),
                     v3(x + 0.4f * wide, y - 0.3f * t, z + 0.6f * long_));
}

static void draw_legs(dmg_builder* b, const seat* s, float half, uint32_t parent) {
    int kind = dmg_int(b, 0, 2);
    dmg_use(b, parent);
    float low = s->pan - s->t, r = 0.03f * s->width;
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * 0.7f * half;
        if (kind == 0) {
            dmg_beam(b, v3(x, 0, 0.4f * s->deep), v3(x, low, 0.1f * s->deep), 2 * r, 2 * r);
            dmg_beam(b, v3(x, 0, -0.4f * s->deep), v3(x, low, -0.1f * s->deep), 2 * r, 2 * r);
        }
        if (kind == 1) dmg_box_span(b, v3(x - r, 0, -0.4f * s->deep), v3(x + r, low, 0.4f * s->deep));
    }
    if (kind == 2) dmg_box_span(b, v3(-0.35f * half, 0, -0.3f * s->deep), v3(0.35f * half, low, 0.3f * s->deep));
    dmg_beam(b, v3(-half, low, 0), v3(half, low, 0), 0.5f * s->deep, 2 * r);
}

/* Passengers' seats side by side; arms between them go up, tables hang behind. */
static void draw_row(dmg_builder* b, const seat* s) {
    int count = dmg_int(b, 1, 3);
    float pitch = 1.14f * s->width, half = 0.5f * pitch * (float)count;
    bool reclines = dmg_chance(b, 0.75f), table = dmg_chance(b, 0.6f), foot = dmg_chance(b, 0.3f),
         ends = dmg_chance(b, 0.6f), lifts = dmg_chance(b, 0.85f);
    lifts = lifts || !reclines; /* something moves */
    draw_legs(b, s, half, 0);
    uint64_t same = b->random_state;
    for (int i = 0; i < count; ++i) {
        b->random_state = same;
        dmg_save(b);
        dmg_move(b, pitch * ((float)i - 0.5f * (float)(count - 1)), 0, 0);
        draw_cushion(b, s, v3(0, s->pan - 0.5f * s->t, 0.03f * s->deep), v3(s->width, s->t, s->deep));
        draw_back(b, s, 0, reclines, table);
        if (foot) {
            float y = s->pan - 1.05f * s->t, z = 0.5f * s->deep, long_ = dmg_range(b, 0.5f, 0.9f) * s->pan;
            dmg_hinge(b, 0, "footrest", v3(0, y, z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.6f));
            dmg_box_span(b, v3(-0.42f * s->width, y - 0.8f * long_, z), v3(0.42f * s->width, y, z + 0.3f * s->t));
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
    for (int i = 0; i <= count; ++i)
        draw_armrest(b, s, 0, pitch * ((float)i - 0.5f * (float)count),
                     lifts && (ends || (i > 0 && i < count) || count == 1));
}

/* Draws a pilot's seat: it rides on rails and rises on its column. */
static void draw_pilot_seat(dmg_builder* b, const seat* s) {
    float rail = 0.05f * s->width, way = s->deep * dmg_range(b, 0.2f, 0.5f),
          rise = 0.3f * s->pan * dmg_range(b, 0.5f, 1.0f);
    bool lifts = dmg_chance(b, 0.5f), lever = dmg_chance(b, 0.5f), turns = !lifts && dmg_chance(b, 0.3f);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.4f * s->width - rail, 0, -0.7f * s->deep),
                     v3((float)k * 0.4f * s->width + rail, 1.5f * rail, 0.9f * s->deep));
    uint32_t base = dmg_slide(b, 0, "seat_base", v3(0, 0, 1), -0.4f * way, 0.6f * way);
    dmg_box_span(b, v3(-0.48f * s->width, 1.5f * rail, -0.4f * s->deep),
                 v3(0.48f * s->width, 3.5f * rail, 0.4f * s->deep));
    dmg_box_span(b, v3(-0.2f * s->width, 3 * rail, -0.25f * s->deep),
                 v3(0.2f * s->width, s->pan - 1.1f * s->t - (lifts ? 0.02f * s->pan : 0.0f), 0.25f * s->deep));
    if (lever) {
        float x = 0.5f * s->width + rail;
        dmg_hinge(b, base, "seat_lever", v3(x, 2.5f * rail, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.9f));
        dmg_beam(b, v3(x, 2.5f * rail, 0), v3(x, 3.0f * rail, 0.45f * s->deep), 0.5f * rail, rail);
        dmg_use(b, base);
    }
    uint32_t top = base;
    if (lifts) top = dmg_slide(b, base, "seat", v3(0, 1, 0), 0.0f, rise);
    if (turns) top = dmg_hinge(b, base, "seat", v3(0, 0, 0), v3(0, 1, 0), -1.6f, 1.6f);
    draw_cushion(b, s, v3(0, s->pan - 0.5f * s->t, 0.03f * s->deep), v3(s->width, s->t, s->deep));
    uint32_t back = draw_back(b, s, top, dmg_chance(b, 0.6f), false);
    for (int k = -1; k <= 1; k += 2) {
        bool leans = dmg_chance(b, 0.7f), lifts_up = dmg_chance(b, 0.85f);
        draw_armrest(b, s, leans ? back : top, (float)k * 0.57f * s->width, lifts_up);
    }
}

/* Draws an attendant's seat on a bulkhead: the pan folds down, held up by a spring. */
static void draw_jump_seat(dmg_builder* b, const seat* s) {
    float wall = 0.08f * s->width, z = -0.5f * s->deep, tall = s->pan + s->back * 1.25f;
    int count = dmg_int(b, 1, 2);
    bool box = dmg_chance(b, 0.5f), head = dmg_chance(b, 0.6f), locker = dmg_chance(b, 0.4f);
    float pitch = 1.15f * s->width, half = 0.62f * pitch * (float)count, up = dmg_range(b, 1.3f, 1.5f);
    dmg_box_span(b, v3(-half, 0, z - wall), v3(half, tall, z));
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1));
        draw_cushion(b, s, v3(x, s->pan + 0.58f * s->back, z + 0.4f * s->t), v3(s->width, 0.8f * s->back, 0.8f * s->t));
        for (int k = -1; k <= 1; k += 2) { /* ears that carry its pin */
            float ear = x + (float)k * 0.53f * s->width;
            dmg_box_span(b, v3(ear - 0.02f * s->width, s->pan - s->t, z),
                         v3(ear + 0.02f * s->width, s->pan, z + 1.5f * s->t));
        }
        uint32_t pan =
            dmg_hinge(b, 0, "jump_seat", v3(x, s->pan - 0.5f * s->t, z + 1.1f * s->t), v3(-1, 0, 0), 0.0f, up);
        if (dmg_chance(b, 0.7f)) dmg_rest(b, pan, up);
        draw_cushion(b, s, v3(x, s->pan - 0.5f * s->t, z + 1.1f * s->t + 0.42f * s->deep),
                     v3(s->width, s->t, 0.84f * s->deep));
        if (box)
            dmg_box_span(b, v3(x - 0.4f * s->width, s->pan - 1.6f * s->t, z + 1.2f * s->t),
                         v3(x + 0.4f * s->width, s->pan - s->t, z + 0.8f * s->deep));
        dmg_use(b, 0);
        if (head) {
            dmg_slide(b, 0, "headrest", v3(0, 1, 0), 0.0f, 0.12f * s->back);
            draw_cushion(b, s, v3(x, s->pan + 1.08f * s->back, z + 0.4f * s->t),
                         v3(0.6f * s->width, 0.16f * s->back, 0.6f * s->t));
            dmg_use(b, 0);
        }
    }
    if (!locker) return;
    dmg_leaf leaf = dmg_leaf_pick(b, 0.1f * half);
    leaf.width = 1.5f * half;
    leaf.height = 0.6f * (s->pan - 2 * s->t);
    leaf.thickness = 0.3f * wall;
    leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT;
    dmg_move(b, 0, 0.1f * s->pan + 0.5f * leaf.height, z + 1.01f * leaf.thickness);
    dmg_leaf_draw(b, 0, "locker", &leaf);
    dmg_use(b, 0);
}

void dmg_build_cabin_seat(dmg_builder* b) {
    seat s = {.width = dmg_scale_range(b, 0.08f, 0.8f)};
    s.deep = s.width * dmg_range(b, 0.8f, 1.1f);
    s.pan = s.width * dmg_range(b, 0.7f, 1.0f);
    s.back = s.width * dmg_range(b, 1.1f, 1.9f);
    s.t = s.width * dmg_range(b, 0.12f, 0.28f);
    s.lean = dmg_range(b, 0.0f, 0.25f);
    s.soft = dmg_chance(b, 0.5f);
    static const float weights[] = {4, 3, 2};
    int kind = dmg_weighted(b, weights, 3);
    if (kind == 0) draw_row(b, &s);
    if (kind == 1) draw_pilot_seat(b, &s);
    if (kind == 2) draw_jump_seat(b, &s);
}
