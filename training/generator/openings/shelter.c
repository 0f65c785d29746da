/* Draws shelters and large halls as simulators model them: the end wall itself is the door, whatever its outline.
 * The door looks to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

enum { HALF_POINTS = 8, FULL_POINTS = 2 * HALF_POINTS };

/* The right half of an end wall, from the ground up to the ridge; width 2, height 1, scaled when drawn. */
typedef struct outline {
    dmg_xy half[HALF_POINTS];
    int count;
    float ridge; /* height over x = 0 */
} outline;

static outline pick_outline(dmg_builder* b, float width, float high) {
    outline o = {.ridge = high};
    float x = 0.5f * width, in = dmg_range(b, 0.4f, 0.85f), eave = dmg_range(b, 0.4f, 0.85f);
    int kind = dmg_int(b, 0, 4);
    o.half[o.count++] = (dmg_xy){x, 0};
    if (kind == 0) o.half[o.count++] = (dmg_xy){x, high};
    if (kind == 1) o.half[o.count++] = (dmg_xy){in * x, high}; /* sloping sides */
    if (kind == 2) {                                           /* six or more sides */
        o.half[o.count++] = (dmg_xy){x, 0.5f * eave * high};
        o.half[o.count++] = (dmg_xy){in * x, high};
    }
    if (kind == 3) o.half[o.count++] = (dmg_xy){x, eave * high}; /* a gable */
    for (int i = 1; i < HALF_POINTS - 1 && kind == 4; ++i) {     /* round */
        float angle = 0.5f * DMG_PI * (float)i / (HALF_POINTS - 1);
        o.half[o.count++] = (dmg_xy){x * cosf(angle), high * sinf(angle)};
    }
    return o;
}

/* Both halves: a polygon for extruding; shrunk by `share` towards the middle of the ground. */
static int full_outline(const outline* o, float share, dmg_xy out[FULL_POINTS + 2]) {
    int count = 0;
    for (int i = 0; i < o->count; ++i) out[count++] = (dmg_xy){share * o->half[i].x, share * o->half[i].y};
    out[count++] = (dmg_xy){0, share * o->ridge};
    for (int i = o->count; i-- > 0;) out[count++] = (dmg_xy){-share * o->half[i].x, share * o->half[i].y};
    return count;
}

static void draw_shed(dmg_builder* b, const outline* o, float depth, float wall) {
    dmg_xy outer[FULL_POINTS + 2], inner[FULL_POINTS + 2];
    int count = full_outline(o, 1.0f, outer), kind = dmg_int(b, 0, 2);
    full_outline(o, 1.0f - wall, inner);
    for (int i = 0; i < count; ++i)
        if (outer[i].y <= 0) outer[i].y = -0.02f * o->ridge;
    if (kind == 0) dmg_extrude(b, outer, count, -depth, 0); /* a block */
    if (kind > 0) dmg_ring_plate(b, outer, inner, count, -depth, 0);
    if (kind == 1) dmg_extrude(b, inner, count, -depth, -0.97f * depth);
    if (dmg_chance(b, 0.3f)) /* an apron in front */
        dmg_box(b, v3(0, -0.02f * o->ridge, 0.5f * o->half[0].x),
                v3(2.2f * o->half[0].x, 0.02f * o->ridge, o->half[0].x));
    if (dmg_chance(b, 0.25f))
        dmg_box(b, v3(0, 0.25f * o->ridge, -1.1f * depth), v3(0.5f * o->half[0].x, 0.5f * o->ridge, 0.3f * depth));
}

/* ---- doors ---- */

/* Draws the whole end wall, hung on the ground, at the ridge or at one side. */
static void draw_whole_door(dmg_builder* b, const outline* o, float share, float t) {
    dmg_xy polygon[FULL_POINTS + 2];
    int count = full_outline(o, share, polygon), side = dmg_int(b, 0, 3);
    float top = share * o->ridge, x = share * o->half[0].x;
    if (side <= 1) {
        const float upper = dmg_range(b, 0.8f, 1.57f);
        const dmg_vec origin = v3(0, 0, dmg_chance(b, 0.5f) ? t : 0.0f);
        dmg_hinge(b, 0, "door", origin, v3(1, 0, 0), 0.0f, upper);
    }
    if (side == 2) dmg_hinge(b, 0, "door", v3(0, top, t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
    if (side == 3) dmg_hinge(b, 0, "door", v3(x, 0, t), v3(0, 1, 0), 0.0f, dmg_range(b, 1.0f, 2.0f));
    dmg_extrude(b, polygon, count, 0.0f, t);
    dmg_use(b, 0);
}

/* Draws two halves that part in the middle: sliding aside, perhaps as deep as a box, or swinging. */
static void draw_halves(dmg_builder* b, const outline* o, float share, float t) {
    dmg_xy polygon[HALF_POINTS + 2];
    int count = 0, kind = dmg_int(b, 0, 2);
    polygon[count++] = (dmg_xy){0, 0};
    for (int i = 0; i < o->count; ++i) polygon[count++] = (dmg_xy){share * o->half[i].x, share * o->half[i].y};
    polygon[count++] = (dmg_xy){0, share * o->ridge};
    float x = share * o->half[0].x, deep = kind == 1 ? t * dmg_range(b, 2.0f, 8.0f) : t,
          travel = dmg_range(b, 0.6f, 1.0f) * x, swing = dmg_range(b, 1.2f, 2.0f);
    bool sheet = dmg_chance(b, 0.2f);
    for (int s = 0; s < 2; ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        if (kind < 2)
            dmg_slide(b, 0, "door", v3(1, 0, 0), 0.0f, travel);
        else
            dmg_hinge(b, 0, "door", v3(x, 0, deep), v3(0, 1, 0), 0.0f, swing);
        dmg_extrude(b, polygon, count, sheet ? deep - 0.02f * t : 0.02f * t, deep);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Thin leaves in a row in front of the wall, on one track or each on its own, all to one side or half to each. */
static void draw_row(dmg_builder* b, float width, float high, float t) {
    int leaves = dmg_int(b, 2, 10), split = dmg_chance(b, 0.5f) ? leaves / 2 : dmg_chance(b, 0.5f) ? leaves : 0;
    float each = width / (float)leaves, step = dmg_chance(b, 0.6f) ? 1.1f * t : 0.0f, reach = dmg_range(b, 0.3f, 1.0f);
    dmg_panel panel = dmg_panel_pick(b);
    bool plain = dmg_chance(b, 0.6f);
    if (panel.kind == DMG_PANEL_BOWED) panel.kind = DMG_PANEL_FLAT;
    for (int i = 0; i < leaves; ++i) {
        bool left = i < split;
        int order = left ? i : leaves - 1 - i; /* 0 is outermost */
        float x = ((float)i + 0.5f) * each - 0.5f * width,
              travel = step > 0 ? ((float)order + 1.0f) * each * reach : each * reach;
        dmg_slide(b, 0, "door", v3(left ? -1.0f : 1.0f, 0, 0), 0.0f, travel);
        dmg_save(b);
        dmg_move(b, x, 0.5f * high, t + step * (float)((left ? split - 1 : leaves - 1 - split) - order));
        if (plain)
            dmg_box(b, v3(0, 0, -0.5f * t), v3(0.99f * each, high, t));
        else
            dmg_panel_draw(b, &panel, 0.99f * each, high, t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws two leaves above each other that fold outwards, or leaves side by side that fold like a screen. */
static void draw_folding(dmg_builder* b, float width, float high, float t) {
    bool upward = dmg_chance(b, 0.4f);
    int leaves = upward ? 2 : 2 * dmg_int(b, 1, 2);
    float each = (upward ? high : width) / (float)leaves, full = dmg_range(b, 1.1f, 1.5f),
          rest = dmg_range(b, 0.0f, 0.5f);
    uint32_t carrier = 0;
    dmg_save(b);
    dmg_move(b, upward ? 0.0f : -0.5f * width, upward ? high : 0.0f, t);
    if (upward) dmg_turn(b, v3(0, 0, 1), -0.5f * DMG_PI); /* +X goes down */
    float across = upward ? width : high, middle = upward ? 0.0f : 0.5f * high;
    for (int i = 0; i < leaves; ++i) {
        float sign = i % 2 ? -1.0f : 1.0f;
        uint32_t part = dmg_hinge(b, carrier, "door", v3(0, 0, sign > 0 ? 0.0f : -t), v3(0, -sign, 0), 0.0f,
                                  i ? 2.0f * full : full);
        dmg_rest(b, part, rest * (i ? 2.0f * full : full));
        dmg_box(b, v3(0.5f * each, middle, -0.5f * t), v3(0.99f * each, across, t));
        dmg_move(b, each, 0, 0);
        carrier = part;
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a wide front with one opening: the leaf goes up, or aside, and is small beside the house. */
static void draw_front(dmg_builder* b, const outline* o, float t) {
    float width = o->half[0].x * dmg_range(b, 0.3f, 1.4f), high = o->ridge * dmg_range(b, 0.3f, 0.6f);
    int kind = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, (o->half[0].x - 0.5f * width) * dmg_range(b, -0.7f, 0.7f), 0, 0);
    if (kind == 0) draw_row(b, width, high, t);
    if (kind == 1) draw_folding(b, width, high, t);
    if (kind == 2) {
        dmg_slide(b, 0, "door", v3(0, 1, 0), 0.0f, high * dmg_range(b, 0.6f, 0.95f));
        dmg_box(b, v3(0, 0.5f * high, 0.5f * t), v3(width, high, t));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

void dmg_build_shelter(dmg_builder* b) {
    float width = dmg_scale_range(b, 2, 40), high = width * dmg_range(b, 0.2f, 0.7f),
          depth = width * dmg_range(b, 0.4f, 2.2f), t = width * dmg_range(b, 0.004f, 0.03f);
    outline o = pick_outline(b, width, high);
    draw_shed(b, &o, depth, dmg_range(b, 0.02f, 0.15f));
    static const float weights[] = {3, 3, 2, 2};
    int kind = dmg_weighted(b, weights, 4);
    float share = dmg_range(b, 0.85f, 1.02f);
    if (kind == 0) draw_whole_door(b, &o, share, t);
    if (kind == 1) draw_halves(b, &o, share, t);
    if (kind == 2) {
        const float tall = high * dmg_range(b, 0.3f, 0.8f), wide = width * dmg_range(b, 0.5f, 1.0f);
        draw_row(b, wide, tall, t);
    }
    if (kind == 3) draw_front(b, &o, t);
}
