/* Draws mine carts on rails whose tub tips or whose gates swing, and pump trolleys; lift cages between guides,
 * platforms on a mast, dumb waiters. Carts run along Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- carts ---- */

typedef struct cart {
    float half, length, wheel; /* half the gauge, length of the frame, radius of the wheels */
    float deck;                /* top of the frame */
} cart;

/* Sleepers and two rails below the wheels. */
static void draw_track(dmg_builder* b, const cart* c) {
    float t = 0.12f * c->half, length = c->length * dmg_range(b, 1.1f, 1.8f);
    int sleepers = dmg_int(b, 3, 7);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * c->half, -0.6f * t, 0), v3(0.8f * t, 1.1f * t, length));
    for (int i = 0; i < sleepers; ++i)
        dmg_box(b, v3(0, -1.5f * t, length * (((float)i + 0.5f) / (float)sleepers - 0.5f)),
                v3(3.2f * c->half, 0.8f * t, 2 * t));
}

/* Single wheels, or pairs on an axle that turns as one. */
static void draw_running_gear(dmg_builder* b, const cart* c) {
    bool axles = dmg_chance(b, 0.4f), inside = dmg_chance(b, 0.5f);
    int kind = dmg_weighted(b, (const float[]){3, 0, 1, 1, 0, 1, 0}, DMG_WHEEL_KINDS), spokes = dmg_int(b, 4, 8);
    float w = 0.25f * c->wheel, base = c->length * dmg_range(b, 0.2f, 0.32f), r = c->wheel;
    for (int i = 0; i < 2; ++i) {
        float z = i ? base : -base;
        dmg_use(b, 0);
        for (int s = -1; s <= 1; s += 2) /* bearings */
            dmg_box_span(b, v3((float)s * 0.72f * c->half - w, 0.8f * r, z - 0.4f * r),
                         v3((float)s * 0.72f * c->half + w, c->deck, z + 0.4f * r));
        if (axles) dmg_spin(b, 0, "wheels", v3(0, r, z), v3(1, 0, 0));
        dmg_rod(b, v3(-c->half, r, z), v3(c->half, r, z), 0.15f * r);
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s;
            dmg_save(b);
            dmg_move(b, side * c->half, r, z);
            dmg_turn(b, v3(0, 1, 0), side * 0.5f * DMG_PI);
            if (!axles) dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
            dmg_wheel_draw(b, kind, r, w, spokes);
            float flange = inside ? -0.6f * w : 0.6f * w;
            dmg_rod(b, v3(0, 0, flange - 0.15f * w), v3(0, 0, flange + 0.15f * w), 1.15f * r);
            dmg_restore(b);
        }
    }
    dmg_use(b, 0);
}

/* Draws two beams, buffers, a hook to couple by, a brake's lever. */
static void draw_frame(dmg_builder* b, const cart* c) {
    float t = 0.14f * c->half, y = c->deck - t, end = 0.5f * c->length, side = dmg_sign(b);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3((float)s * 0.72f * c->half, y, 0), v3(t, 2 * t, c->length));
        dmg_box(b, v3(0, y, (float)s * (end - 0.5f * t)), v3(1.6f * c->half, 2 * t, t));
    }
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * end;
        if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, y, z), v3(0, y, z + (float)s * 1.5f * t), 0.8f * t);
        if (!dmg_chance(b, 0.5f)) continue;
        dmg_vec pin = {0.4f * c->half, y, z + (float)s * 0.7f * t};
        dmg_box(b, v3(pin.x, y, z + (float)s * 0.4f * t), v3(1.6f * t, t, t));
        dmg_hinge_across(b, 0, "coupling", pin, -0.9f, 0.5f);
        dmg_torus(b, v3_add(pin, v3(0, 0, (float)s * 1.5f * t)), v3(0, 1, 0), 1.2f * t, 0.3f * t);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.6f)) return;
    dmg_vec foot = {side * 1.25f * c->half, y, dmg_range(b, -0.25f, 0.25f) * c->length};
    float high = c->half * dmg_range(b, 0.8f, 1.6f), lean = dmg_range(b, -0.3f, 0.3f);
    dmg_rod(b, v3(side * 0.7f * c->half, y, foot.z), foot, 0.4f * t);
    dmg_hinge_across(b, 0, "brake", foot, -0.4f, 0.4f);
    dmg_beam(b, v3_add(foot, v3(0, -0.4f * t, 0)), v3_add(foot, v3(0, high, lean * high)), 0.5f * t, 0.7f * t);
    dmg_rod(b, v3_add(foot, v3(0, 0.85f * high, lean * 0.85f * high)), v3_add(foot, v3(0, high, lean * high)),
            0.5f * t);
    dmg_use(b, 0);
}

/* Draws a trough along Z, its floor's middle at the origin; ends may be left open (bit 1 ahead, bit 2 behind). */
static void draw_tub(dmg_builder* b, float floor, float top, float high, float length, float t, int open) {
    const dmg_xy line[] = {{top, high}, {floor, 0}, {-floor, 0}, {-top, high}};
    const dmg_xy end[] = {{floor, 0}, {top, high}, {-top, high}, {-floor, 0}};
    dmg_bent_plate(b, line, 4, t, length);
    if (!(open & 1)) dmg_extrude(b, end, 4, 0.5f * length - t, 0.5f * length);
    if (!(open & 2)) dmg_extrude(b, end, 4, -0.5f * length, t - 0.5f * length);
}

static void draw_load(dmg_builder* b, float half, float y, float length) {
    int lumps = dmg_int(b, 3, 8);
    for (int i = 0; i < lumps; ++i) {
        float r = half * dmg_range(b, 0.25f, 0.45f), x = half * dmg_range(b, -0.5f, 0.5f);
        float z = 0.36f * length * (2.0f * ((float)i + 0.5f) / (float)lumps - 1.0f);
        dmg_ellipsoid(b, v3(x, y, z), v3(r, 0.7f * r, r));
    }
}

/* Tips to the sides on trunnions between two stands, or to one side over its edge. */
static void build_side_tipper(dmg_builder* b, const cart* c) {
    float high = c->half * dmg_range(b, 1.0f, 1.6f), floor = c->half * dmg_range(b, 0.15f, 0.5f),
          top = c->half * dmg_range(b, 1.0f, 1.5f), t = 0.06f * c->half, length = 0.8f * c->length,
          stand = 0.6f * floor + 0.25f * high, y = c->deck + 0.1f * high + 0.5f * floor;
    float pin = y + stand - 0.3f * high;
    pin = fmaxf(pin, c->deck + 0.4f * c->half);
    for (int s = -1; s <= 1; s += 2)
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3((float)k * 0.7f * c->half, c->deck - t, (float)s * (0.5f * length + 1.5f * t)),
                     v3(0, pin, (float)s * (0.5f * length + 1.5f * t)), 1.5f * t, 2 * t);
    float swing = dmg_range(b, 0.6f, 1.1f);
    bool both = dmg_chance(b, 0.6f);
    uint32_t tub = dmg_hinge(b, 0, "tub", v3(0, pin, 0), v3(0, 0, dmg_sign(b)), both ? -swing : 0.0f, swing);
    dmg_rod(b, v3(0, pin, -0.5f * length - 2.5f * t), v3(0, pin, 0.5f * length + 2.5f * t), 1.3f * t);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    draw_tub(b, floor, top, high, length, t, 0);
    if (dmg_chance(b, 0.4f)) draw_load(b, 0.8f * top, 0.8f * high, length);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) { /* its catch */
        dmg_vec at = {0.5f * (floor + top), y + 0.5f * high, 0.5f * length};
        float turn = dmg_range(b, 0.7f, 1.6f);
        dmg_hinge(b, tub, "catch", at, v3(0, 0, dmg_sign(b)), 0.0f, turn);
        dmg_rod(b, at, v3_add(at, v3(0, 0, 1.5f * t)), t);
        dmg_box(b, v3_add(at, v3(0, -0.15f * high, t)), v3(1.5f * t, 0.4f * high, t));
    }
    dmg_use(b, 0);
}

/* Draws a box that tips ahead on an axle at the frame's end, its gate hung from above or below. */
static void build_end_tipper(dmg_builder* b, const cart* c) {
    float high = c->half * dmg_range(b, 0.7f, 1.4f), top = c->half * dmg_range(b, 0.9f, 1.3f),
          floor = top * dmg_range(b, 0.7f, 1.0f), t = 0.07f * c->half, y = c->deck + 2.2f * t,
          length = 0.95f * c->length, end = 0.5f * length;
    uint32_t tub = 0;
    bool tips = dmg_chance(b, 0.7f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.72f * c->half, c->deck + 0.5f * t, 0.9f * end), v3(2 * t, 2 * t, 2 * t));
    if (tips) tub = dmg_hinge(b, 0, "tub", v3(0, c->deck + t, 0.9f * end), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.0f));
    dmg_rod(b, v3(-0.85f * c->half, c->deck + t, 0.9f * end), v3(0.85f * c->half, c->deck + t, 0.9f * end), 0.7f * t);
    if (!tips) dmg_box(b, v3(0, c->deck + t, 0), v3(1.3f * c->half, 2.2f * t, 0.9f * length));
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    draw_tub(b, floor, top, high, length, t, 1);
    bool above = dmg_chance(b, 0.6f);
    float reach = dmg_range(b, 0.6f, 1.5f);
    if (above)
        dmg_hinge(b, tub, "gate", v3(0, high + t, end + t), v3(-1, 0, 0), 0.0f, reach);
    else
        dmg_hinge(b, tub, "gate", v3(0, 0, end + t), v3(1, 0, 0), 0.0f, reach);
    const dmg_xy leaf[] = {{0.95f * floor, 0}, {0.97f * top, high}, {-0.97f * top, high}, {-0.95f * floor, 0}};
    dmg_extrude(b, leaf, 4, end + 0.5f * t, end + 1.5f * t);
    dmg_rod(b, v3(-top, above ? high + t : 0, end + t), v3(top, above ? high + t : 0, end + t), 0.8f * t);
    dmg_use(b, tub);
    if (above)
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * top - t, 0.7f * high, 0.85f * end),
                         v3((float)s * top + t, high + 1.8f * t, end + 1.6f * t));
    if (dmg_chance(b, 0.4f)) draw_load(b, 0.8f * top, 0.7f * high, 0.9f * length);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a box on the frame whose sides are flaps: hung above, below, or doors. */
static void build_side_gates(dmg_builder* b, const cart* c) {
    float high = c->half * dmg_range(b, 0.8f, 1.7f), x = c->half * dmg_range(b, 0.9f, 1.3f), t = 0.07f * c->half,
          y = c->deck, end = 0.48f * c->length;
    int kind = dmg_int(b, 0, 2), count = dmg_int(b, 1, 3);
    dmg_box_span(b, v3(-x, y, -end), v3(x, y + t, end));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0, y + 0.5f * high, (float)s * (end - 0.5f * t)), v3(2 * x, high, t));
    float step = 2 * end / (float)count, room = 0.5f * step - 1.5f * t;
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, at = side * (x + 0.6f * t);
        for (int i = 0; i < count; ++i) {
            float z = step * ((float)i + 0.5f) - end;
            dmg_use(b, 0);
            if (i)
                dmg_box_span(b, v3(side * x - t, y, z - 0.5f * step - t),
                             v3(side * x + t, y + high, z - 0.5f * step + t));
            if (kind == 0) dmg_hinge(b, 0, "flap", v3(at, y + high, z), v3(0, 0, side), 0.0f, dmg_range(b, 0.8f, 1.6f));
            if (kind == 1) dmg_hinge(b, 0, "flap", v3(at, y + t, z), v3(0, 0, -side), 0.0f, dmg_range(b, 1.0f, 2.6f));
            if (kind == 2)
                dmg_hinge(b, 0, "door", v3(at, y, z + room), v3(0, -side, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
            dmg_box_span(b, v3(at - 0.5f * t, y + 1.1f * t, z - room), v3(at + 0.5f * t, y + high, z + room));
            if (kind < 2)
                dmg_rod(b, v3(at, kind ? y + t : y + high, z - room), v3(at, kind ? y + t : y + high, z + room),
                        0.7f * t);
        }
    }
    dmg_use(b, 0);
    dmg_box_span(b, v3(-x, y + high, -end), v3(-0.95f * x, y + high + 0.5f * t, end));
    dmg_box_span(b, v3(0.95f * x, y + high, -end), v3(x, y + high + 0.5f * t, end));
}

/* Draws a flat trolley with a see-saw to pump. */
static void build_pump_trolley(dmg_builder* b, const cart* c) {
    float t = 0.08f * c->half, y = c->deck, high = c->half * dmg_range(b, 1.0f, 1.8f), reach = 0.48f * c->length,
          x = 0.5f * c->half;
    dmg_box_span(b, v3(-1.2f * c->half, y, -0.5f * c->length), v3(1.2f * c->half, y + t, 0.5f * c->length));
    for (int s = -1; s <= 1; s += 2)
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3((float)s * 2 * t, y, (float)k * 0.3f * high), v3((float)s * 2 * t, y + high, 0), t, t);
    float swing = dmg_range(b, 0.25f, 0.5f), foot = dmg_range(b, -0.2f, 0.2f) * c->length;
    dmg_hinge_across(b, 0, "pump", v3(0, y + high, 0), -swing, swing);
    dmg_rod(b, v3(-3.5f * t, y + high, 0), v3(3.5f * t, y + high, 0), t);
    dmg_beam(b, v3(0, y + high, -reach), v3(0, y + high, reach), 1.5f * t, 2 * t);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(-x, y + high, (float)s * reach), v3(x, y + high, (float)s * reach), 0.7f * t);
    dmg_use(b, 0);
    dmg_box(b, v3(0.9f * c->half, y + 1.5f * t, foot), v3(2 * t, 2 * t, 2 * t));
    dmg_hinge_across(b, 0, "pedal", v3(0.9f * c->half, y + 2 * t, foot), -0.4f, 0.1f);
    dmg_box_span(b, v3(0.9f * c->half - t, y + 2 * t, foot), v3(0.9f * c->half + t, y + 3 * t, foot + 6 * t));
    dmg_use(b, 0);
}

void dmg_build_mine_cart(dmg_builder* b) {
    cart c = {.half = dmg_scale_range(b, 0.05f, 0.9f)};
    c.length = c.half * dmg_range(b, 2.5f, 5.0f);
    c.wheel = c.half * dmg_range(b, 0.25f, 0.45f);
    c.deck = c.wheel * dmg_range(b, 1.4f, 2.2f);
    int kind = dmg_weighted(b, (const float[]){3, 3, 2, 1}, 4);
    if (dmg_chance(b, 0.6f)) draw_track(b, &c);
    draw_running_gear(b, &c);
    draw_frame(b, &c);
    if (kind == 0) build_side_tipper(b, &c);
    if (kind == 1) build_end_tipper(b, &c);
    if (kind == 2) build_side_gates(b, &c);
    if (kind == 3) build_pump_trolley(b, &c);
}

/* ---- lifts: the car's floor at y = floor, its open side ahead ---- */

typedef struct shaft {
    float x, z, high, rise; /* half sizes of the car, its height, how far it goes up */
    float t;
} shaft;

/* Draws the gate of a car or landing across z: swings, slides aside, goes up, folds in two. */
static void draw_gate(dmg_builder* b, uint32_t parent, const shaft* s, float z, float y, float high) {
    int kind = dmg_int(b, 0, 3), bars = dmg_int(b, 2, 7);
    float side = dmg_sign(b), x = 0.94f * s->x, t = 0.6f * s->t, swing = dmg_range(b, 1.0f, 1.9f);
    for (int half = 0; half < (kind == 3 ? 2 : 1); ++half) {
        float way = kind == 3 ? (half ? 1.0f : -1.0f) : side, far = kind == 3 ? 0.02f * x * way : -way * x;
        float low = fminf(far, way * x), top = fmaxf(far, way * x);
        dmg_use(b, parent);
        if (kind == 0 || kind == 3) dmg_hinge(b, parent, "gate", v3(way * x, y, z), v3(0, way, 0), 0.0f, swing);
        if (kind == 1) dmg_slide(b, parent, "gate", v3(side, 0, 0), 0.0f, 1.7f * x);
        if (kind == 2) dmg_slide(b, parent, "gate", v3(0, 1, 0), 0.0f, 0.9f * high);
        for (int i = 0; i < 2; ++i)
            dmg_box_span(b, v3(low, y + (i ? high - t : 0), z - 0.5f * t), v3(top, y + (i ? high : t), z + 0.5f * t));
        for (int i = 0; i <= bars; ++i) {
            float at = low + 0.5f * t + (top - low - t) * (float)i / (float)bars;
            dmg_box_span(b, v3(at - 0.4f * t, y, z - 0.4f * t), v3(at + 0.4f * t, y + high, z + 0.4f * t));
        }
    }
    dmg_use(b, parent);
}

/* Floor, roof and posts, some sides filled. Leaves the car in use. */
static void draw_car(dmg_builder* b, const shaft* s, uint32_t car, float y) {
    float t = s->t;
    int filled = dmg_int(b, 0, 2);
    bool roofed = dmg_chance(b, 0.75f);
    dmg_box_span(b, v3(-s->x, y, -s->z), v3(s->x, y + t, s->z));
    if (roofed) dmg_box_span(b, v3(-s->x, y + s->high - t, -s->z), v3(s->x, y + s->high, s->z));
    for (int i = -1; i <= 1; i += 2)
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(
                b, v3((float)i * (s->x - 0.5f * t) - 0.5f * t, y, (float)k * (s->z - 0.5f * t) - 0.5f * t),
                v3((float)i * (s->x - 0.5f * t) + 0.5f * t, y + s->high, (float)k * (s->z - 0.5f * t) + 0.5f * t));
    for (int i = -1; i <= 1; i += 2)
        for (int k = 1; k <= (filled == 1 ? 3 : 0); ++k)
            dmg_box(b, v3((float)i * (s->x - 0.5f * t), y + s->high * 0.25f * (float)k, 0),
                    v3(0.5f * t, 0.6f * t, 2 * s->z));
    for (int i = -1; i <= 1 && filled == 2; i += 2)
        dmg_box(b, v3((float)i * (s->x - 0.3f * t), y + 0.5f * s->high, 0), v3(0.3f * t, s->high, 2 * s->z));
    if (filled == 2) dmg_box(b, v3(0, y + 0.5f * s->high, 0.3f * t - s->z), v3(2 * s->x, s->high, 0.3f * t));
    draw_gate(b, car, s, s->z + 0.5f * t, y + 1.2f * t, s->high * dmg_range(b, 0.4f, 0.85f));
    if (dmg_chance(b, 0.5f)) { /* what it is driven by */
        dmg_vec pin = {0.8f * s->x, y + 0.45f * s->high, -0.5f * s->z};
        dmg_box_span(b, v3(pin.x - t, y, pin.z - t), v3(pin.x + t, pin.y, pin.z + t));
        dmg_hinge_across(b, car, "lever", pin, -0.6f, 0.6f);
        dmg_rod(b, pin, v3_add(pin, v3(0, 0.2f * s->high, 0)), 0.25f * t);
        dmg_ellipsoid(b, v3_add(pin, v3(0, 0.2f * s->high, 0)), v3(0.6f * t, 0.6f * t, 0.6f * t));
        dmg_use(b, car);
    }
    if (!roofed || !dmg_chance(b, 0.3f)) return;
    dmg_hinge(b, car, "roof_hatch", v3(0, y + s->high, -0.5f * s->z), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.4f));
    dmg_box_span(b, v3(-0.4f * s->x, y + s->high, -0.5f * s->z), v3(0.4f * s->x, y + s->high + 0.5f * t, 0.3f * s->z));
    dmg_use(b, car);
}

/* Guides up both sides, a head with its sheave, a counterweight behind. */
static void build_cage(dmg_builder* b, const shaft* s) {
    float t = s->t, top = s->rise + s->high * dmg_range(b, 1.15f, 1.4f), x = s->x + 1.2f * t;
    bool corners = dmg_chance(b, 0.5f);
    for (int i = -1; i <= 1; i += 2)
        for (int k = -1; k <= (corners ? 1 : -1); k += 2) {
            float z = corners ? (float)k * 0.9f * s->z : 0.0f;
            dmg_box_span(b, v3((float)i * x - 0.7f * t, 0, z - t), v3((float)i * x + 0.7f * t, top, z + t));
        }
    for (int i = -1; i <= 1 && corners; i += 2)
        dmg_box(b, v3((float)i * x, top - t, 0), v3(1.4f * t, 2 * t, 1.8f * s->z));
    dmg_box_span(b, v3(-x, top, -1.5f * t), v3(x, top + 2 * t, 1.5f * t));
    float base = s->high * dmg_range(b, 0.0f, 0.05f),
          up = dmg_chance(b, 0.5f) ? 0.0f : s->rise * dmg_range(b, 0.1f, 0.6f);
    dmg_box_span(b, v3(-1.2f * x, -t, -1.2f * s->z), v3(1.2f * x, -0.01f * t, 1.2f * s->z));
    uint32_t car = dmg_slide(b, 0, "cage", v3(0, 1, 0), -up, s->rise - up);
    draw_car(b, s, car, base + up);
    for (int i = -1; i <= 1; i += 2) /* shoes */
        dmg_box(b, v3((float)i * (s->x + 0.2f * t), base + up + 0.5f * s->high, 0),
                v3(0.5f * t, 0.3f * s->high, 2 * t));
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, base + up + s->high, 0), v3(0, top, 0), 0.15f * t);
    dmg_use(b, 0);
    float r = s->x * dmg_range(b, 0.3f, 0.6f), y = top + 2.5f * t + r;
    if (dmg_chance(b, 0.75f)) {
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3((float)k * 1.2f * t, top + t, 0), v3((float)k * 1.2f * t, y + t, 0), 0.6f * t, 2 * t);
        dmg_spin(b, 0, "sheave", v3(0, y, 0), v3(dmg_sign(b), 0, 0));
        dmg_save(b);
        dmg_move(b, 0, y, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        int wheel = dmg_int(b, 0, 3), spokes = dmg_int(b, 4, 8);
        dmg_wheel_draw(b, wheel, r, 1.2f * t, spokes);
        dmg_restore(b);
        dmg_rod(b, v3(-1.6f * t, y, 0), v3(1.6f * t, y, 0), 0.4f * t);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.5f)) return;
    float z = -s->z - 2.5f * t, high = 0.4f * s->high; /* the counterweight */
    dmg_slide(b, 0, "counterweight", v3(0, -1, 0), 0.0f, fminf(s->rise, top - high));
    dmg_box_span(b, v3(-0.5f * s->x, top - high, z - t), v3(0.5f * s->x, top, z + t));
    dmg_rod(b, v3(0, top, z), v3(0, top + 0.1f * high, z), 0.2f * t);
    dmg_use(b, 0);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * 0.6f * s->x - 0.4f * t, 0, z - 0.5f * t),
                     v3((float)i * 0.6f * s->x + 0.4f * t, top, z + 0.5f * t));
}

/* Draws a deck with rails that goes up a mast behind it. */
static void build_platform(dmg_builder* b, const shaft* s) {
    float t = s->t, top = s->rise + 0.8f * s->high, back = -s->z - 2.2f * t, rail = 0.35f * s->high,
          wide = s->x * dmg_range(b, 0.2f, 0.6f);
    bool twin = dmg_chance(b, 0.5f);
    for (int i = -1; i <= (twin ? 1 : -1); i += 2) {
        float x = twin ? (float)i * wide : 0.0f;
        dmg_box_span(b, v3(x - 1.2f * t, 0, back - 1.2f * t), v3(x + 1.2f * t, top, back + 1.2f * t));
    }
    dmg_box_span(b, v3(-s->x, -t, back - 3 * t), v3(s->x, -0.01f * t, 0.3f * s->z));
    float y = 0.06f * s->high;
    uint32_t deck = dmg_slide(b, 0, "platform", v3(0, 1, 0), 0.0f, s->rise);
    dmg_box_span(b, v3(-s->x, y, -s->z), v3(s->x, y + t, s->z));
    dmg_box_span(b, v3(-wide - 1.5f * t, y - t, back + 1.4f * t), v3(wide + 1.5f * t, y + rail, -s->z + 0.5f * t));
    for (int i = -1; i <= 1; i += 2) {
        float x = (float)i * (s->x - 0.3f * t);
        for (int k = 0; k < 2; ++k)
            dmg_rod(b, v3(x, y + rail * (k ? 1.0f : 0.5f), -s->z), v3(x, y + rail * (k ? 1.0f : 0.5f), s->z),
                    0.25f * t);
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3(x, y, (float)k * (s->z - 0.3f * t)), v3(x, y + rail, (float)k * (s->z - 0.3f * t)), 0.3f * t);
    }
    int entry = dmg_int(b, 0, 2);
    if (entry == 0) draw_gate(b, deck, s, s->z - 0.3f * t, y + t, rail - t);
    if (entry == 1) { /* a plate let down to the ground */
        dmg_hinge(b, deck, "flap", v3(0, y + 0.5f * t, s->z + 0.3f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 1.3f, 1.6f));
        dmg_box_span(b, v3(-0.9f * s->x, y + 0.5f * t, s->z + 0.1f * t),
                     v3(0.9f * s->x, y + 0.5f * t + 0.7f * rail, s->z + 0.6f * t));
    }
    if (entry == 2) { /* a bar across */
        dmg_vec pin = {s->x - 0.3f * t, y + rail, s->z - 0.3f * t};
        dmg_hinge(b, deck, "bar", pin, v3(0, 0, -1), 0.0f, dmg_range(b, 1.1f, 1.6f));
        dmg_rod(b, pin, v3_add(pin, v3(0.6f * t - 2 * s->x, 0, 0)), 0.3f * t);
    }
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.5f)) return;
    dmg_vec hub = {0, 0.4f * s->high, back - 1.3f * t}; /* a winch */
    float r = 0.25f * s->x;
    if (twin) dmg_box(b, hub, v3(2 * wide, 2 * t, t));
    dmg_spin(b, 0, "winch", hub, v3(0, 0, dmg_sign(b)));
    dmg_rod(b, hub, v3_add(hub, v3(0, 0, -2 * t)), 0.7f * t);
    dmg_beam(b, v3_add(hub, v3(0, 0, -1.7f * t)), v3_add(hub, v3(r, 0, -1.7f * t)), 0.6f * t, 0.5f * t);
    dmg_rod(b, v3_add(hub, v3(r, 0, -1.7f * t)), v3_add(hub, v3(r, 0, -5 * t)), 0.3f * t);
    dmg_use(b, 0);
}

/* Draws a cupboard over two floors with a box on a rope, doors at both, a wheel to pull it by. */
static void build_dumb_waiter(dmg_builder* b, const shaft* s) {
    float t = s->t, high = 2 * s->x * dmg_range(b, 0.8f, 1.2f), top = 2.6f * high, x = s->x + 1.5f * t,
          z = s->z + 1.5f * t;
    int doors = dmg_int(b, 0, 2);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * x - 0.5f * t, 0, -z), v3((float)i * x + 0.5f * t, top, z));
    dmg_box_span(b, v3(-x, 0, -z - t), v3(x, top, -z));
    dmg_box_span(b, v3(-x, top, -z - t), v3(x, top + t, z));
    dmg_box_span(b, v3(-x, -t, -z - t), v3(x, 0, z));
    float still = top - 1.4f * high - 1.2f * t;
    dmg_slide(b, 0, "box", v3(0, 1, 0), 0.0f, fmaxf(0.5f * high, still));
    dmg_save(b);
    dmg_move(b, 0, 0.1f * high + 0.5f * high, s->z);
    dmg_case_draw(b, dmg_case_pick(b), 2 * s->x, high, 2 * s->z, 0.5f * t);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.6f * high, s->z - 0.5f * t), v3(2 * s->x, 0.5f * t, t));
    dmg_use(b, 0);
    for (int i = 0; i < 2; ++i) { /* one at either floor */
        float y = i ? top - 1.1f * high : 0.05f * high, side = dmg_sign(b), front = z + 0.5f * t;
        if (doors == 0) dmg_hinge(b, 0, "door", v3(side * x, y, front), v3(0, side, 0), 0.0f, dmg_range(b, 1.3f, 2.6f));
        if (doors == 1)
            dmg_slide(b, 0, "door", v3(0, i ? -1 : 1, 0), 0.0f, fminf(high, 0.5f * (top - 2.2f * high)) + 0.2f * high);
        if (doors == 2) dmg_hinge(b, 0, "door", v3(0, y, front), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.7f));
        dmg_box_span(b, v3(-0.98f * x, y, z + 0.1f * t), v3(0.98f * x, y + high, z + 0.9f * t));
        dmg_box(b, v3(-0.7f * side * x, y + 0.5f * high, z + 1.2f * t), v3(0.6f * t, 0.25f * high, 0.6f * t));
        dmg_use(b, 0);
    }
    float r = s->x * dmg_range(b, 0.3f, 0.6f), side = dmg_sign(b);
    dmg_save(b);
    dmg_move(b, side * (x + 0.5f * t), top * dmg_range(b, 0.4f, 0.8f), 0);
    dmg_turn(b, v3(0, 1, 0), side * 0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, t), 0.25f * r);
    dmg_spin(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_move(b, 0, 0, 1.5f * t);
    int wheel = dmg_int(b, 2, 3), spokes = dmg_int(b, 4, 6);
    dmg_wheel_draw(b, wheel, r, t, spokes);
    if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(0.85f * r, 0, 0), v3(0.85f * r, 0, 4 * t), 0.4f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_lift_cage(dmg_builder* b) {
    shaft s = {.x = dmg_scale_range(b, 0.08f, 1.5f)};
    s.z = s.x * dmg_range(b, 0.6f, 1.4f);
    s.high = s.x * dmg_range(b, 1.8f, 3.0f);
    s.rise = s.high * dmg_range(b, 0.6f, 2.0f);
    s.t = s.x * dmg_range(b, 0.05f, 0.12f);
    int kind = dmg_weighted(b, (const float[]){3, 2, 1.5f}, 3);
    if (kind == 0) build_cage(b, &s);
    if (kind == 1) build_platform(b, &s);
    if (kind == 2) build_dumb_waiter(b, &s);
    dmg_use(b, 0);
}
