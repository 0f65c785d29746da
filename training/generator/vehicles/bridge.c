/* Draws airport passenger bridges: a fixed walk, a drum that turns, tunnels that tip and telescope on a wheeled
 * frame, a cab that turns on its own drum, a hood that meets the aircraft. They reach to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct bridge {
    float width, high, floor, length;
    int tunnels, skin;
    float overlap; /* how much of a tunnel the next one covers as shown, fraction */
    bool outwards; /* each next tunnel is the wider one */
    uint32_t carrier;
} bridge;

/* Draws a tunnel's part about the current origin, from z0 to z1. */
static void draw_tube(dmg_builder* b, int skin, float width, float high, float z0, float z1) {
    dmg_vec middle = {0, 0, 0.5f * (z0 + z1)}, size = {width, high, z1 - z0};
    if (skin == 0) dmg_box(b, middle, size);
    if (skin == 1) dmg_box_faces(b, middle, size, DMG_FACE_ALL & ~(DMG_FACE_FRONT | DMG_FACE_BACK));
    if (skin == 2) dmg_rounded_box(b, middle, size, 0.15f * width);
    if (skin == 3) { /* ribs round a box */
        dmg_box(b, middle, size);
        for (int i = 0; i < 5; ++i)
            dmg_box(b, v3(0, 0, z0 + (z1 - z0) * (0.1f + 0.2f * (float)i)),
                    v3(1.06f * width, 1.06f * high, 0.04f * width));
    }
}

/* Draws the frame with wheels under a tunnel: legs, a crossbeam, a bogie that steers or legs that lengthen. */
static void draw_undercarriage(dmg_builder* b, const bridge* s, float z, float drop) {
    float x = 0.62f * s->width, t = 0.1f * s->width, wheel = s->width * dmg_range(b, 0.12f, 0.25f);
    int kind = dmg_int(b, 0, 2);
    float split = kind == 1 ? 0.5f : 1.0f;
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3((float)k * x, 0.5f * s->high - 0.5f * split * (drop + s->high), z),
                v3(t, split * (drop + s->high), t));
    if (dmg_chance(b, 0.5f)) dmg_beam(b, v3(-x, 0.5f * s->high, z), v3(x, 0.5f * s->high, z), t, t);
    uint32_t carrier = s->carrier;
    float y = -0.5f * s->high - drop + wheel;
    if (kind == 1) carrier = dmg_slide(b, carrier, "lift", v3(0, 1, 0), -0.1f * drop, 0.3f * drop);
    if (kind == 2) carrier = dmg_hinge(b, carrier, "bogie", v3(0, y, z), v3(0, 1, 0), -1.5f, 1.5f);
    dmg_use(b, carrier);
    if (kind == 1)
        for (int k = -1; k <= 1; k += 2)
            dmg_box(b, v3((float)k * x, 0.5f * (y - 0.1f * drop), z), v3(0.7f * t, -y + 0.1f * drop, 0.7f * t));
    dmg_beam(b, v3(-x, y + 0.2f * wheel, z), v3(x, y + 0.2f * wheel, z), t, t);
    for (int k = -1; k <= 1; k += 2)
        dmg_rod(b, v3((float)k * x - 0.3f * wheel, y, z), v3((float)k * x + 0.3f * wheel, y, z), wheel);
    dmg_use(b, s->carrier);
}

/* Draws what never moves: the terminal's wall, a walk on columns. */
static void draw_fixed_walk(dmg_builder* b, const bridge* s) {
    float length = s->width * dmg_range(b, 0.5f, 8.0f), mid = s->floor + 0.5f * s->high;
    dmg_use(b, 0);
    dmg_rod(b, v3(0, 0, 0), v3(0, s->floor, 0), s->width * dmg_range(b, 0.15f, 0.5f));
    if (dmg_chance(b, 0.7f)) {
        dmg_box(b, v3(0, mid, -0.6f * s->width - 0.5f * length), v3(s->width, s->high, length));
        if (length > 3 * s->width)
            dmg_box(b, v3(0, 0.5f * s->floor, -length), v3(0.3f * s->width, s->floor, 0.3f * s->width));
    }
    if (dmg_chance(b, 0.3f))
        dmg_box(b, v3(0, 0.9f * s->floor, -length - 1.6f * s->width),
                v3(8 * s->width, 1.8f * s->floor + s->high, 2 * s->width));
}

static void draw_stairs(dmg_builder* b, const bridge* s, float z, float drop) {
    float side = dmg_sign(b) * 0.75f * s->width, out = 0.9f * drop;
    dmg_beam(b, v3(side, -0.5f * s->high, z), v3(side, -0.5f * s->high - 0.97f * drop, z - out), 0.3f * s->width,
             0.08f * s->width);
    dmg_box(b, v3(side, -0.5f * s->high, z + 0.2f * s->width), v3(0.4f * s->width, 0.06f * s->width, 0.4f * s->width));
}

/* At the end of the last tunnel, the origin: a drum that stays, a box before it that turns about the drum. */
static void draw_cab(dmg_builder* b, bridge* s, float width, float high) {
    bool own_drum = dmg_chance(b, 0.5f), round = dmg_chance(b, 0.6f);
    float r = width * dmg_range(b, 0.5f, 0.7f), out = r * dmg_range(b, 0.7f, 1.0f),
          deep = width * dmg_range(b, 0.15f, 1.0f), turn = dmg_range(b, 0.4f, 1.6f);
    uint32_t tunnel = s->carrier;
    dmg_move(b, 0, 0, 0.5f * r);
    if (dmg_chance(b, 0.85f))
        s->carrier = dmg_hinge(b, tunnel, "cab", v3(0, 0, 0), v3(0, 1, 0), -turn, turn * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, own_drum ? s->carrier : tunnel);
    if (round)
        dmg_rod(b, v3(0, -0.52f * high, 0), v3(0, 0.52f * high, 0), r);
    else
        dmg_box(b, v3(0, 0, 0), v3(1.6f * r, 1.04f * high, 1.6f * r));
    dmg_use(b, s->carrier);
    float wide = width * dmg_range(b, 0.9f, 1.5f), tall = high * dmg_range(b, 0.9f, 1.3f);
    dmg_box(b, v3(dmg_chance(b, 0.3f) ? 0.2f * width : 0.0f, 0, out + 0.5f * deep), v3(wide, tall, deep));
    if (!dmg_chance(b, 0.5f)) return;
    /* The hood: a frame that leans, rolls or reaches out. */
    int way = dmg_int(b, 0, 2);
    float z = out + deep, bellows = width * dmg_range(b, 0.1f, 0.5f), lean = dmg_range(b, 0.1f, 0.4f);
    if (way == 0) dmg_hinge(b, s->carrier, "hood", v3(0, 0.5f * tall, z), v3(-1, 0, 0), 0.0f, lean);
    if (way == 1) dmg_hinge(b, s->carrier, "hood", v3(0, 0, z), v3(0, 0, 1), -lean, lean);
    if (way == 2) dmg_slide(b, s->carrier, "hood", v3(0, 0, 1), 0.0f, 0.7f * bellows);
    dmg_save(b);
    dmg_move(b, 0, 0, z + bellows);
    dmg_frame_draw(b, 1.02f * wide, 1.02f * tall, bellows, 0.12f * wide);
    dmg_restore(b);
}

/* Draws one tunnel after another from the drum on; leaves the frame at the end of the last. */
static void draw_tunnels(dmg_builder* b, bridge* s, float* width, float* high) {
    float at = 0.0f, drop = s->floor, grow = s->outwards ? 1.0f / 0.9f : 0.9f;
    for (int i = 0; i < s->tunnels; ++i) {
        float length = s->length * dmg_range(b, 0.85f, 1.1f);
        if (i > 0) {
            float room = (1.0f - s->overlap) * s->length;
            s->carrier = dmg_slide(b, s->carrier, "tunnel", v3(0, 0, 1), -0.7f * room, 0.7f * s->overlap * s->length);
            *width *= grow;
            *high *= grow;
        }
        dmg_use(b, s->carrier);
        draw_tube(b, s->skin, *width, *high, at, at + length);
        if (i == s->tunnels - 1) {
            if (dmg_chance(b, 0.75f)) draw_undercarriage(b, s, at + length * dmg_range(b, 0.4f, 0.8f), drop);
            if (dmg_chance(b, 0.5f)) draw_stairs(b, s, at + 0.9f * length, drop);
        }
        at += i + 1 < s->tunnels ? (1.0f - s->overlap) * length : length;
    }
    dmg_move(b, 0, 0, at);
}

void dmg_build_passenger_bridge(dmg_builder* b) {
    bridge s = {.width = dmg_range(b, 1.8f, 3.5f), .tunnels = dmg_int(b, 1, 3), .skin = dmg_int(b, 0, 3)};
    s.high = s.width * dmg_range(b, 0.8f, 1.2f);
    s.floor = s.width * dmg_range(b, 0.8f, 2.2f);
    s.length = s.width * dmg_range(b, 2.5f, 8.0f);
    s.overlap = dmg_range(b, 0.1f, 0.9f);
    s.outwards = dmg_chance(b, 0.5f);
    draw_fixed_walk(b, &s);
    float mid = s.floor + 0.5f * s.high, r = s.width * dmg_range(b, 0.55f, 0.8f), turn = dmg_range(b, 0.4f, 1.5f);
    bool drum_turns = dmg_chance(b, 0.5f);
    s.carrier = dmg_hinge(b, 0, "rotunda", v3(0, 0, 0), v3(0, 1, 0), -turn, turn);
    dmg_use(b, drum_turns ? s.carrier : 0);
    dmg_rod(b, v3(0, s.floor - 0.08f * s.high, 0), v3(0, s.floor + 1.12f * s.high, 0), r);
    dmg_use(b, s.carrier);
    dmg_move(b, 0, mid, 0);
    if (drum_turns && dmg_chance(b, 0.7f)) { /* the tunnels tip about a line in the drum or at its edge */
        float y = s.high * dmg_range(b, -0.5f, 0.5f), z = dmg_chance(b, 0.5f) ? 0.0f : r * dmg_range(b, 0.5f, 1.0f);
        s.carrier = dmg_hinge_either_way(b, s.carrier, "slope", v3(0, y, z), v3(-1, 0, 0), 0.03f, 0.2f);
    }
    float width = s.width, high = s.high;
    dmg_move(b, 0, 0, 0.8f * r);
    draw_tunnels(b, &s, &width, &high);
    draw_cab(b, &s, width, high);
    dmg_use(b, 0);
}
