/* Draws lorries at work: turntable ladders and lifting platforms, tankers, box bodies with shutters, lockers and
 * tail lifts. Ahead is +Z; a lorry's rear end is z = 0. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/trucks.h"

/* ---- lockers in a side: shutters that go up, look-alikes that hang from their top, flaps down, doors ---- */

typedef enum locker { LOCKER_SHUTTER, LOCKER_FLAP_UP, LOCKER_FLAP_DOWN, LOCKER_DOOR, LOCKER_KINDS } locker;

/* The leaf lies on x = 0, faces +X, and fills width along Z and height above y = 0; carries slats or is flat. */
static void draw_locker(dmg_builder* b, locker kind, float width, float high, float t, int slats) {
    bool handed = dmg_chance(b, 0.5f);
    float z = 0.5f * width;
    uint32_t part = 0;
    if (kind == LOCKER_SHUTTER) {
        for (int s = -1; s <= 1; s += 2) /* its rails */
            dmg_box_span(b, v3(0, 0, (float)s * z - 0.7f * t), v3(1.6f * t, high, (float)s * z + 0.7f * t));
        if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(0, high, -z), v3(2.5f * t, high + 2 * t, z)); /* the roll's box */
        part = dmg_slide(b, 0, "shutter", v3(0, 1, 0), 0.0f, dmg_range(b, 0.6f, 0.95f) * high);
    }
    if (kind == LOCKER_FLAP_UP)
        part = dmg_hinge(b, 0, "flap", v3(0.5f * t, high, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.2f, 2.2f));
    if (kind == LOCKER_FLAP_DOWN)
        part = dmg_hinge(b, 0, "flap", v3(0.5f * t, 0, 0), v3(0, 0, -1), 0.0f, dmg_range(b, 1.3f, 2.8f));
    if (kind == LOCKER_DOOR)
        part = dmg_hinge(b, 0, "locker_door", v3(0.5f * t, 0.5f * high, handed ? z : -z),
                         v3(0, handed ? -1.0f : 1.0f, 0), 0.0f, dmg_range(b, 1.4f, 2.6f));
    float wide = 0.96f * width;
    if (slats == 0) dmg_box_span(b, v3(0, 0.01f * high, -0.5f * wide), v3(t, 0.99f * high, 0.5f * wide));
    for (int i = 0; i < slats; ++i)
        dmg_box_span(b, v3(0, high * ((float)i + 0.02f) / (float)slats, -0.5f * wide),
                     v3(t, high * ((float)i + 0.95f) / (float)slats, 0.5f * wide));
    if (slats > 0) dmg_box_span(b, v3(0.1f * t, 0.01f * high, -0.48f * wide), v3(0.6f * t, 0.98f * high, 0.48f * wide));
    float y = kind == LOCKER_FLAP_DOWN ? 0.92f * high : 0.08f * high;
    if (kind == LOCKER_DOOR) {
        dmg_vec grip = {1.4f * t, 0.5f * high, (handed ? -0.4f : 0.4f) * wide};
        if (dmg_chance(b, 0.3f)) dmg_hinge(b, part, "handle", grip, v3(dmg_sign(b), 0, 0), -1.5f, 1.5f);
        dmg_box(b, grip, v3(0.8f * t, 0.18f * high, 0.05f * width));
    } else if (dmg_chance(b, 0.8f)) {
        dmg_box(b, v3(1.4f * t, y, 0), v3(0.8f * t, 0.04f * high, wide * dmg_range(b, 0.15f, 0.9f)));
    }
    dmg_use(b, 0);
    if (kind == LOCKER_FLAP_UP || kind == LOCKER_FLAP_DOWN)
        for (int i = -1; i <= 1 && dmg_chance(b, 0.6f); i += 2) {
            float pin = kind == LOCKER_FLAP_UP ? high : 0.0f;
            dmg_rod(b, v3(0.5f * t, pin, (float)i * 0.3f * width - 0.06f * width),
                    v3(0.5f * t, pin, (float)i * 0.3f * width + 0.06f * width), 0.8f * t);
        }
}

static void draw_body(dmg_builder* b, const dmg_truck* t, float high) {
    dmg_box_span(b, v3(-t->half, t->deck, 0), v3(t->half, t->deck + high, t->length));
    locker kind = (locker)dmg_weighted(b, (const float[]){4, 2, 1, 1.5f}, LOCKER_KINDS);
    int each = dmg_int(b, 1, 4),
        slats = kind == LOCKER_SHUTTER ? dmg_int(b, 5, 14) : (dmg_chance(b, 0.3f) ? dmg_int(b, 4, 8) : 0);
    float span = 0.94f * t->length / (float)each, thick = 0.012f * t->half * dmg_range(b, 1.5f, 4.0f);
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < each; ++i) {
            dmg_save(b);
            if (s < 0) dmg_mirror(b, v3(1, 0, 0));
            dmg_move(b, t->half, t->deck + 0.06f * high, 0.03f * t->length + span * ((float)i + 0.5f));
            draw_locker(b, kind, 0.92f * span, 0.82f * high, thick, slats);
            dmg_restore(b);
        }
}

/* ---- ladders and booms: the pin at the origin, lying ahead ---- */

static void draw_ladder(dmg_builder* b, float half, float length, float t, int rungs, bool trussed) {
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_box_span(b, v3(x - 0.5f * t, 0, 0), v3(x + 0.5f * t, t, length));
        if (trussed) dmg_box_span(b, v3(x - 0.3f * t, 3 * t, 0), v3(x + 0.3f * t, 3.6f * t, length));
        for (int i = 0; i < rungs && trussed; ++i) {
            float z0 = length * (float)i / (float)rungs, z1 = length * ((float)i + 1) / (float)rungs;
            dmg_beam(b, v3(x, i % 2 ? 3.3f * t : 0.5f * t, z0), v3(x, i % 2 ? 0.5f * t : 3.3f * t, z1), 0.4f * t,
                     0.4f * t);
        }
    }
    for (int i = 0; i < rungs; ++i) {
        float z = length * ((float)i + 0.5f) / (float)rungs;
        dmg_rod(b, v3(-half, 0.5f * t, z), v3(half, 0.5f * t, z), 0.25f * t);
    }
}

/* Draws a basket on the end, kept level: its floor before the pin at the origin. */
static void draw_cage(dmg_builder* b, uint32_t carrier, float size, float level) {
    float half = size * dmg_range(b, 0.7f, 1.2f), deep = size * dmg_range(b, 0.7f, 1.2f), t = 0.05f * size;
    uint32_t cage = dmg_chance(b, 0.7f) ? dmg_hinge_across(b, carrier, "cage", v3(0, 0, 0), -0.7f, 0.7f) : carrier;
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), level);
    dmg_rod(b, v3(-0.3f * half, 0, 0), v3(0.3f * half, 0, 0), 1.5f * t);
    if (dmg_chance(b, 0.3f)) {
        cage = dmg_hinge(b, cage, "cage_turn", v3(0, 0, 2 * t), v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
        dmg_rod(b, v3(0, -2 * t, 2 * t), v3(0, 2 * t, 2 * t), 1.5f * t);
    }
    dmg_move(b, 0, -0.2f * size, 3 * t);
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * deep);
    dmg_face_up(b);
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0, 0, size);
        dmg_case_draw(b, DMG_CASE_BOARDS, 2 * half, deep, size, t);
    } else {
        dmg_box(b, v3(0, 0, 0), v3(2 * half, deep, 2 * t));
    }
    dmg_restore(b);
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.97f : -0.97f) * half, z = i & 2 ? 0.97f * deep : 0.03f * deep;
        dmg_rod(b, v3(x, 0, z), v3(x, 1.3f * size, z), 0.6f * t);
        if (i < 2) dmg_rod(b, v3(x, 1.3f * size, 0.03f * deep), v3(x, 1.3f * size, 0.97f * deep), 0.6f * t);
    }
    dmg_rod(b, v3(-half, 1.3f * size, 0.03f * deep), v3(half, 1.3f * size, 0.03f * deep), 0.6f * t);
    if (dmg_chance(b, 0.5f)) /* a bar or gate in front */
        dmg_hinge(b, cage, "gate", v3(-0.97f * half, 1.1f * size, 1.02f * deep),
                  v3(0, dmg_chance(b, 0.5f) ? -1.0f : 1.0f, 0), 0.0f, 1.4f);
    dmg_box_span(b, v3(-0.97f * half, 1.05f * size, deep), v3(0.97f * half, 1.25f * size, 1.04f * deep));
    dmg_restore(b);
}

static void draw_stages(dmg_builder* b, uint32_t carrier, float length, float half, float level) {
    int sections = dmg_int(b, 1, 4), rungs = dmg_int(b, 6, 14);
    bool ladder = dmg_chance(b, 0.65f), trussed = dmg_chance(b, 0.5f);
    float t = half * dmg_range(b, 0.1f, 0.16f), out = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.4f) * length;
    for (int i = 0; i < sections; ++i) {
        if (i) {
            dmg_move(b, 0, ladder ? 0.3f * t : 0.0f, out);
            carrier = dmg_slide(b, carrier, "section", v3(0, 0, 1), -out, 0.75f * length - out);
        }
        if (ladder) draw_ladder(b, half, length, t, rungs, trussed);
        if (!ladder)
            dmg_box_span(b, v3(-0.6f * half, -0.8f * half, 0),
                         v3(0.6f * half, 0.8f * half, length + 0.05f * length * (float)i));
        half -= (ladder ? 1.2f : 1.0f) * t;
    }
    dmg_use(b, carrier);
    dmg_move(b, 0, 0, length * (ladder ? 1.0f : 1.0f + 0.05f * (float)(sections - 1)));
    if (dmg_chance(b, 0.7f)) draw_cage(b, carrier, half * dmg_range(b, 1.3f, 2.2f), level);
}

/* Draws a lower boom that goes up and back, an upper one above it that comes forward. */
static void draw_knee(dmg_builder* b, uint32_t carrier, float length, float half, float up) {
    float w = 0.5f * half;
    dmg_box_span(b, v3(-w, -w, 0), v3(w, w, length));
    dmg_move(b, 0, 0, length);
    float fold = DMG_PI - dmg_range(b, 0.05f, 0.9f);
    dmg_rod(b, v3(-2.2f * w, 0, 0), v3(2.2f * w, 0, 0), 1.4f * w);
    uint32_t upper = dmg_hinge_across(b, carrier, "upper_boom", v3(0, 0, 0), fold - 3.15f, fold - 0.2f);
    dmg_turn(b, v3(1, 0, 0), fold);
    dmg_box_span(b, v3(1.1f * w, -0.8f * w, -w), v3(2.4f * w, 0.8f * w, length * dmg_range(b, 0.8f, 1.3f)));
    dmg_move(b, 1.8f * w, 0, length);
    draw_cage(b, upper, half * dmg_range(b, 1.5f, 2.5f), up - fold);
}

static void draw_outriggers(dmg_builder* b, const dmg_truck* t) {
    float s = 0.1f * t->half, drop = 0.55f * t->deck;
    int pairs = dmg_int(b, 1, 2);
    bool swings = dmg_chance(b, 0.25f);
    for (int i = 0; i < 2 * pairs; ++i) {
        float side = i & 1 ? 1.0f : -1.0f, z = i & 2 ? 0.93f * t->length : 0.04f * t->length, x = side * t->half,
              y = 0.9f * t->deck;
        uint32_t beam = swings ? dmg_hinge(b, 0, "outrigger", v3(0.92f * x, y, z), v3(0, dmg_sign(b), 0), -1.2f, 1.2f)
                               : dmg_slide(b, 0, "outrigger", v3(side, 0, 0), 0.0f, 0.8f * t->half);
        dmg_box_span(b, v3(fminf(0.2f * x, 1.02f * x), y - s, z - s), v3(fmaxf(0.2f * x, 1.02f * x), y, z + s));
        dmg_box_span(b, v3(1.02f * x - s, y - 0.3f * t->deck, z - s), v3(1.02f * x + s, y + 0.5f * s, z + s));
        if (dmg_chance(b, 0.8f)) dmg_slide(b, beam, "jack", v3(0, -1, 0), 0.0f, drop - 0.1f * t->deck);
        dmg_rod(b, v3(1.02f * x, y - 0.35f * t->deck, z), v3(1.02f * x, y - 0.1f * t->deck, z), 0.7f * s);
        dmg_rod(b, v3(1.02f * x, y - 0.38f * t->deck, z), v3(1.02f * x, y - 0.33f * t->deck, z), 1.8f * s);
        dmg_use(b, 0);
    }
}

static void draw_aerial(dmg_builder* b, const dmg_truck* t, float high) {
    float top = t->deck + high, rise = fmaxf(0.25f * t->half, t->roof - top + 0.1f * t->half),
          z = dmg_chance(b, 0.6f) ? 0.12f * t->length : 0.75f * t->length, half = t->half * dmg_range(b, 0.3f, 0.55f);
    bool back = z > 0.5f * t->length; /* lies to the rear */
    if (dmg_chance(b, 0.8f)) draw_outriggers(b, t);
    dmg_move(b, 0, top, z);
    uint32_t ring = dmg_spin(b, 0, "turntable", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.02f * t->half, 0), v3(0, 0.1f * t->half, 0), 0.6f * t->half);
    if (back) dmg_turn(b, v3(0, 1, 0), DMG_PI);
    if (dmg_chance(b, 0.3f)) dmg_turn(b, v3(0, 1, 0), dmg_range(b, -1.5f, 1.5f));
    float pin = rise + 0.5f * half;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 1.15f * half - 0.08f * half, 0, -0.5f * half),
                     v3((float)s * 1.15f * half + 0.08f * half, pin + 0.2f * half, 0.4f * half));
    dmg_rod(b, v3(-1.2f * half, pin, 0), v3(1.2f * half, pin, 0), 0.1f * half);
    if (dmg_chance(b, 0.4f))
        dmg_box_span(b, v3(1.3f * half, 0.1f * t->half, -0.4f * half), v3(1.9f * half, rise, 0.4f * half));
    float up = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.1f, 1.1f), length = t->length * dmg_range(b, 0.8f, 1.2f);
    bool knee = dmg_chance(b, 0.3f);
    dmg_move(b, 0, pin, 0);
    uint32_t boom = dmg_hinge_across(b, ring, "boom", v3(0, 0, 0), -up, 1.3f - up);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -up);
    if (knee) draw_knee(b, boom, 0.8f * length, half, up);
    if (!knee) draw_stages(b, boom, length, half, up);
    dmg_restore(b);
    dmg_vec lug = v3_turn(v3(0, -0.1f * half, 0.25f * length), v3(1, 0, 0), -up);
    dmg_ram_draw(b, dmg_ram_pick(b), ring, boom, v3(0, 0.15f * t->half - pin, 0.35f * half), lug, 0.1f * half);
    dmg_use(b, 0);
}

/* ---- tanker ---- */

static void draw_manholes(dmg_builder* b, float y, float length, float half) {
    int lids = dmg_int(b, 1, 4);
    float r = half * dmg_range(b, 0.2f, 0.35f), h = 0.15f * half;
    for (int i = 0; i < lids; ++i) {
        float z = length * ((float)i + 0.5f) / (float)lids;
        bool up = dmg_chance(b, 0.75f);
        dmg_rod(b, v3(0, y - h, z), v3(0, y + h, z), r);
        uint32_t lid;
        if (up)
            lid = dmg_hinge_across(b, 0, "manhole", v3(0, y + h, z - 1.1f * r), 0.0f, dmg_range(b, 1.2f, 2.2f));
        else /* swung aside on a post */
            lid = dmg_hinge(b, 0, "manhole", v3(1.2f * r, y + h, z), v3(0, dmg_sign(b), 0), -2.0f, 2.0f);
        dmg_rod(b, v3(0, y + h, z), v3(0, y + 1.4f * h, z), 1.08f * r);
        dmg_box_span(b, v3(up ? -0.2f * r : 0, y + 1.1f * h, up ? z - 1.25f * r : z - 0.15f * r),
                     v3(up ? 0.2f * r : 1.3f * r, y + 1.6f * h, up ? z : z + 0.15f * r));
        if (dmg_chance(b, 0.5f)) { /* screwed down by a hand wheel */
            dmg_spin(b, lid, "hand_wheel", v3(0, y + 2 * h, z), v3(0, 1, 0));
            dmg_save(b);
            dmg_move(b, 0, y + 2.4f * h, z);
            dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
            dmg_wheel_draw(b, 3, 0.6f * r, 0.15f * r, 4);
            dmg_restore(b);
            dmg_rod(b, v3(0, y + 1.4f * h, z), v3(0, y + 2.4f * h, z), 0.08f * r);
        }
        dmg_use(b, 0);
    }
}

static void draw_tank(dmg_builder* b, const dmg_truck* t) {
    enum { CORNERS = 16 };
    dmg_xy ring[CORNERS];
    float half = 0.97f * t->half, high = t->half * dmg_range(b, 0.7f, 1.0f), power = dmg_range(b, 2.0f, 4.0f),
          y = t->deck + high;
    for (int i = 0; i < CORNERS; ++i) {
        float a = 2 * DMG_PI * (float)i / CORNERS, c = cosf(a), s = sinf(a),
              r = powf(powf(fabsf(c), power) + powf(fabsf(s), power), -1.0f / power);
        ring[i] = (dmg_xy){half * r * c, high * r * s};
    }
    const dmg_row rows[] = {
        {0.7f, 0.7f, 0, 0}, {1, 1, 0, 0.04f * t->length}, {1, 1, 0, 0.96f * t->length}, {0.7f, 0.7f, 0, t->length}};
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_loft(b, ring, CORNERS, rows, 4);
    dmg_restore(b);
    draw_manholes(b, y + high, t->length, half);
    if (dmg_chance(b, 0.5f)) { /* a rail along the top that folds down */
        float x = 0.45f * half, tall = 0.5f * half, r = 0.02f * half, z0 = 0.05f * t->length, z1 = 0.95f * t->length;
        dmg_hinge(b, 0, "rail", v3(x, y + 0.93f * high, 0.5f * t->length), v3(0, 0, dmg_sign(b)), -1.3f, 1.3f);
        for (int i = 0; i < 4; ++i)
            dmg_rod(b, v3(x, y + 0.93f * high, z0 + (z1 - z0) * (float)i / 3),
                    v3(x, y + high + tall, z0 + (z1 - z0) * (float)i / 3), r);
        dmg_rod(b, v3(x, y + high + tall, z0), v3(x, y + high + tall, z1), r);
        dmg_use(b, 0);
    }
    int valves = dmg_int(b, 0, 3);
    for (int i = 0; i < valves; ++i) { /* at the rear: hand wheels or quarter-turn levers */
        float x = 0.4f * half * ((float)i - 0.5f * (float)(valves - 1)), r = 0.12f * half, z = -0.1f * half,
              v = t->deck + 0.35f * high;
        dmg_rod(b, v3(x, v, 0.05f * t->length), v3(x, v, z), 0.35f * r);
        if (dmg_chance(b, 0.5f)) {
            dmg_spin(b, 0, "valve", v3(x, v, z), v3(0, 0, 1));
            dmg_save(b);
            dmg_move(b, x, v, z);
            dmg_wheel_draw(b, 3, r, 0.3f * r, 4);
            dmg_restore(b);
        } else {
            dmg_hinge(b, 0, "valve", v3(x, v, z), v3(0, 0, dmg_sign(b)), -0.1f, 1.57f);
            dmg_box_span(b, v3(x - 0.2f * r, v - 0.3f * r, z - 0.3f * r), v3(x + 0.2f * r, v + 1.8f * r, z));
        }
        dmg_use(b, 0);
    }
}

/* ---- a box body: doors or a roller door behind, a platform that is lowered and tipped up ---- */

static void draw_box_body(dmg_builder* b, const dmg_truck* t, float high) {
    float h = t->half, d = t->deck, thick = 0.03f * h;
    dmg_box_span(b, v3(-h, d, 0.01f * t->length), v3(h, d + high, t->length));
    int rear = dmg_int(b, 0, 2);
    bool lift = dmg_chance(b, 0.6f);
    if (rear == 0)
        for (int s = -1; s <= 1; s += 2) {
            float side = (float)s, x = side * h;
            uint32_t door = dmg_hinge(b, 0, "rear_door", v3(x, d + 0.5f * high, 0), v3(0, -side, 0), 0.0f,
                                      dmg_range(b, 1.6f, 4.2f));
            dmg_box_span(b, v3(fminf(x, 0.01f * x), d, -thick), v3(fmaxf(x, 0.01f * x), d + high, 0));
            if (dmg_chance(b, 0.6f)) {
                float at = 0.2f * x;
                dmg_hinge(b, door, "bolt", v3(at, d + 0.5f * high, -1.6f * thick), v3(0, dmg_sign(b), 0), -1.4f, 1.4f);
                dmg_rod(b, v3(at, d, -1.6f * thick), v3(at, d + high, -1.6f * thick), 0.5f * thick);
                dmg_box_span(b, v3(fminf(at, 2.2f * at), d + 0.38f * high, -2.6f * thick),
                             v3(fmaxf(at, 2.2f * at), d + 0.42f * high, -1.6f * thick));
            }
            dmg_use(b, 0);
        }
    if (rear > 0) {
        dmg_save(b);
        dmg_move(b, 0, d, 0.01f * t->length);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* faces the rear */
        draw_locker(b, rear == 1 ? LOCKER_SHUTTER : LOCKER_FLAP_UP, 1.9f * h, 0.97f * high, thick, dmg_int(b, 6, 14));
        dmg_restore(b);
    }
    if (lift) {
        float deep = h * dmg_range(b, 0.7f, 1.3f), y = d - thick, back = -8 * thick;
        bool folded = dmg_chance(b, 0.4f) && rear > 0, slides = dmg_chance(b, 0.75f);
        uint32_t carrier = 0;
        if (slides) carrier = dmg_slide(b, 0, "tail_lift", v3(0, -1, 0), 0.0f, 0.75f * d);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.8f * h - thick, y - thick, back),
                         v3((float)s * 0.8f * h + thick, y + 4 * thick, back + 4 * thick));
        dmg_hinge_across(b, carrier, "platform", v3(0, y, back), folded ? 0.0f : -1.5f, folded ? 1.5f : 0.0f);
        dmg_save(b);
        dmg_move(b, 0, y, back);
        if (folded) dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_box_span(b, v3(-0.95f * h, -0.7f * thick, -deep), v3(0.95f * h, 0.7f * thick, 0));
        dmg_restore(b);
        dmg_use(b, 0);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.8f * h - 1.5f * thick, 0.4f * d, back + 4 * thick),
                         v3((float)s * 0.8f * h + 1.5f * thick, d, 0.02f * t->length));
    }
    if (dmg_chance(b, 0.4f)) { /* a door in the side: slides, or swings */
        float width = 0.3f * t->length, z = 0.7f * t->length;
        if (dmg_chance(b, 0.5f))
            dmg_slide(b, 0, "side_door", v3(0, 0, -1), 0.0f, 0.9f * width);
        else
            dmg_hinge(b, 0, "side_door", v3(h + 0.5f * thick, d + 0.5f * high, z + 0.5f * width), v3(0, -1, 0), 0.0f,
                      1.8f);
        dmg_box_span(b, v3(h, d + 0.04f * high, z - 0.5f * width), v3(h + thick, d + 0.92f * high, z + 0.5f * width));
        dmg_box_span(b, v3(h + thick, d + 0.4f * high, z - 0.45f * width),
                     v3(h + 2 * thick, d + 0.55f * high, z - 0.4f * width));
        dmg_use(b, 0);
    }
}

void dmg_build_service_truck(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.06f, 2.5f), high = size * dmg_range(b, 0.45f, 0.8f);
    int kind = dmg_weighted(b, (const float[]){5, 2, 3, 1.5f}, 4);
    dmg_truck t = dmg_truck_pick(b, size);
    dmg_truck_draw(b, &t);
    if (kind == 0 || kind == 3) draw_body(b, &t, high);
    if (kind == 0) draw_aerial(b, &t, high);
    if (kind == 1) draw_tank(b, &t);
    if (kind == 2) draw_box_body(b, &t, high * dmg_range(b, 1.2f, 2.0f));
    dmg_use(b, 0);
}
