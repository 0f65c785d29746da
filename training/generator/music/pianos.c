/* Draws instruments with a row of keys: uprights, grands and reed organs with their lids, fallboards, props, pedals
 * and stools; stage keyboards with wheels, faders and pads. The player sits at +Z. */
#include "core/build.h"
#include "music/manuals.h"
#include "parts/hardware.h"

/* ---- the keys ---- */

dmg_manual dmg_manual_pick(dmg_builder* b, float pitch) {
    static const int counts[] = {8, 10, 14, 15, 21, 22, 29};
    dmg_manual m = {.whites = counts[dmg_int(b, 0, 6)], .pitch = pitch};
    m.length = pitch * dmg_range(b, 4.5f, 6.5f);
    m.rise = pitch * dmg_range(b, 0.35f, 0.6f);
    m.thick = pitch * dmg_range(b, 0.5f, 1.0f);
    m.hidden = m.length * (dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, 0.5f));
    m.dip = pitch * dmg_range(b, 0.3f, 0.5f);
    m.turns = dmg_chance(b, 0.75f);
    m.fixed = dmg_chance(b, 0.12f);
    return m;
}

float dmg_manual_width(const dmg_manual* m) {
    return m->pitch * (float)m->whites;
}

static void draw_key(dmg_builder* b, const dmg_manual* m, uint32_t carrier, bool black, float x) {
    float front = black ? -0.36f * m->length : 0.0f, wide = m->pitch * (black ? 0.52f : 0.94f),
          top = black ? m->rise : 0.0f, reach = m->length + m->hidden, dip = black ? 0.7f * m->dip : m->dip;
    if (!m->fixed && m->turns)
        dmg_hinge(b, carrier, black ? "black_key" : "white_key", v3(x, -0.5f * m->thick, -reach), v3(1, 0, 0), 0.0f,
                  asinf(dip / (reach + front)));
    if (!m->fixed && !m->turns) dmg_slide(b, carrier, black ? "black_key" : "white_key", v3(0, -1, 0), 0.0f, dip);
    if (black) {
        float x0 = 0.5f * wide, y0 = top - 0.15f * m->rise;
        dmg_box_span(b, v3(x - x0, -0.3f * m->thick, -m->length), v3(x + x0, y0, front));
        dmg_box_span(b, v3(x - 0.8f * x0, y0, -m->length), v3(x + 0.8f * x0, top, front - 0.08f * m->length));
    } else {
        dmg_box_span(b, v3(x - 0.5f * wide, -m->thick, -m->length), v3(x + 0.5f * wide, top, front));
    }
    dmg_use(b, carrier);
}

void dmg_manual_draw(dmg_builder* b, const dmg_manual* m, uint32_t carrier) {
    static const bool sharp[7] = {true, true, false, true, true, true, false}; /* after C, D, F, G, A */
    float half = 0.5f * dmg_manual_width(m), bed = m->thick + 1.3f * m->dip;
    for (int i = 0; i < m->whites; ++i) {
        float x = m->pitch * ((float)i + 0.5f) - half;
        draw_key(b, m, carrier, false, x);
        if (sharp[i % 7] && i + 1 < m->whites) draw_key(b, m, carrier, true, x + 0.5f * m->pitch);
    }
    dmg_box_span(b, v3(-half, -bed - m->thick, -m->length - m->hidden), v3(half, -bed, 0));
}

/* ---- what pianos share. y = 0 at the keys' tops until they are moved to the floor ---- */

typedef struct piano {
    dmg_manual keys;
    float x, deep;     /* half the width inside the case, its depth behind the keys */
    float floor, top;  /* heights */
    float wall, cheek; /* cheeks: their height over the keys */
    float cover;       /* the fallboard's thickness */
} piano;

/* Sizes in pitches of the keys; a short row has a small case. */
static piano pick_piano(dmg_builder* b, float floor, float top, float deep) {
    float k = dmg_range(b, 0.022f, 0.04f);
    piano p = {.keys = dmg_manual_pick(b, k)};
    p.x = 0.5f * dmg_manual_width(&p.keys) + p.keys.pitch * dmg_range(b, 0.1f, 1.5f);
    p.wall = p.keys.pitch * dmg_range(b, 0.6f, 1.6f);
    p.cover = p.keys.pitch * dmg_range(b, 0.3f, 0.8f);
    p.cheek = p.keys.rise + p.cover + p.keys.pitch * dmg_range(b, 0.1f, 0.6f);
    p.floor = -fminf(floor * k, 2.4f * p.x);
    p.top = fminf(top * k, 2.0f * p.x);
    p.deep = fminf(deep * k, 3.6f * p.x);
    return p;
}

/* Draws the bed, the slip before the keys, the cheeks beside them. */
static void draw_key_case(dmg_builder* b, const piano* p) {
    const dmg_manual* m = &p->keys;
    float bed = m->thick + 1.3f * m->dip, low = -bed - 2 * m->thick, slip = 0.6f * m->pitch, z = 1.15f * slip;
    dmg_manual_draw(b, m, 0);
    dmg_box_span(b, v3(-p->x, low, -m->length), v3(p->x, -bed - 0.5f * m->thick, z));
    dmg_box_span(b, v3(-p->x, low, 0.15f * slip), v3(p->x, -0.3f * m->thick, z));
    for (int s = -1; s <= 1; s += 2) {
        float in = 0.5f * dmg_manual_width(m), out = p->x + p->wall;
        dmg_box_span(b, v3(s > 0 ? in : -p->x, low, -m->length), v3(s > 0 ? p->x : -in, 0.1f * m->rise, 0));
        dmg_box_span(b, v3(s > 0 ? p->x : -out, low, -m->length), v3(s > 0 ? out : -p->x, p->cheek, z));
    }
}

/* Over the keys: a board hung on its upper rear edge, plain or with a front leaf, or one that runs back into the case.
 */
static void draw_fallboard(dmg_builder* b, const piano* p) {
    const dmg_manual* m = &p->keys;
    int way = dmg_weighted(b, (const float[]){3, 2, 1.2f, 1}, 4);
    if (way == 3) return;
    float low = m->rise + 0.08f * m->pitch, high = low + p->cover, x = 0.99f * p->x, front = 0.8f * m->pitch,
          t = p->cover, swing = dmg_range(b, 1.1f, 1.57f);
    if (way == 2) {
        float travel = m->length * dmg_range(b, 0.8f, 1.0f);
        uint32_t cover = dmg_slide(b, 0, "key_cover", v3(0, 0, -1), 0.0f, travel);
        dmg_box_span(b, v3(-x, low, -m->length), v3(x, low + 0.5f * t, front));
        dmg_rounded_box(b, v3(0, low + 0.3f * t, front), v3(0.6f * x, 0.6f * t, t), 0.2f * t);
        dmg_rest(b, cover, travel * dmg_range(b, 0.3f, 1.0f));
        dmg_use(b, 0);
        return;
    }
    uint32_t board = dmg_hinge(b, 0, "fallboard", v3(0, high, -m->length), v3(-1, 0, 0), 0.0f, swing);
    float fold = way == 1 ? -m->length * dmg_range(b, 0.15f, 0.4f) : front;
    dmg_box_span(b, v3(-x, low, -m->length), v3(x, high, fold));
    if (way == 0 && dmg_chance(b, 0.6f)) /* its lip hangs over the keys' fronts */
        dmg_box_span(b, v3(-x, 0.2f * low, front - 0.5f * t), v3(x, low, front));
    if (way == 1) {
        uint32_t leaf = dmg_hinge(b, board, "front_leaf", v3(0, high, fold), v3(-1, 0, 0), 0.0f, 3.0f);
        dmg_box_span(b, v3(-x, low, fold), v3(x, high, front));
        dmg_rest(b, leaf, dmg_range(b, 0.0f, 2.9f));
    }
    dmg_use(b, board);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(-0.9f * x, high, -m->length), v3(0.9f * x, high, -m->length), 0.15f * t);
    dmg_rest(b, board, swing * (dmg_chance(b, 0.25f) ? 0.0f : dmg_range(b, 0.5f, 1.0f)));
    dmg_use(b, 0);
}

/* Levers out of a board at z = 0 near the floor y = 0, pinned behind it; reed organs have two broad treadles. */
static void draw_pedals(dmg_builder* b, float pitch, bool treadles) {
    int count = treadles ? 2 : dmg_int(b, 1, 3);
    float long_ = pitch * (treadles ? 6.0f : dmg_range(b, 2.5f, 4.5f)), y = pitch * dmg_range(b, 1.5f, 3.0f),
          step = pitch * (treadles ? 8.0f : dmg_range(b, 2.5f, 4.0f)), wide = pitch * (treadles ? 6.0f : 1.2f),
          behind = pitch * dmg_range(b, 0.5f, 3.0f), swing = fminf(0.25f, 0.6f * y / (long_ + behind));
    bool tongue = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        float x = step * ((float)i - 0.5f * (float)(count - 1));
        if (treadles) {
            dmg_hinge(b, 0, "treadle", v3(x, 0.3f * y, long_), v3(-1, 0, 0), 0.0f, 0.35f);
            dmg_save(b);
            dmg_move(b, x, 0.3f * y, long_);
            dmg_turn(b, v3(1, 0, 0), 0.5f);
            dmg_box_span(b, v3(-0.5f * wide, -0.1f * pitch, -long_), v3(0.5f * wide, 0.1f * pitch, 0));
            dmg_restore(b);
        } else {
            dmg_hinge(b, 0, "pedal", v3(x, y, -behind), v3(1, 0, 0), 0.0f, swing);
            dmg_box_span(b, v3(x - 0.25f * wide, y - 0.2f * pitch, -behind),
                         v3(x + 0.25f * wide, y + 0.2f * pitch, 0.7f * long_));
            if (tongue)
                dmg_ellipsoid(b, v3(x, y, 0.75f * long_), v3(0.6f * wide, 0.25f * pitch, 0.3f * long_));
            else
                dmg_box(b, v3(x, y, 0.75f * long_), v3(wide, 0.4f * pitch, 0.5f * long_));
        }
        dmg_use(b, 0);
    }
}

/* Before the keys, on the floor y = 0: a bench whose seat lifts, or a stool whose seat is screwed up. */
static void draw_stool(dmg_builder* b, float pitch, float seat) {
    float w = pitch * dmg_range(b, 7.0f, 14.0f), d = pitch * dmg_range(b, 5.0f, 7.0f),
          t = pitch * dmg_range(b, 0.8f, 2.0f);
    if (dmg_chance(b, 0.5f)) {
        float box = pitch * dmg_range(b, 1.0f, 3.0f);
        for (int i = 0; i < 4; ++i) {
            float x = (i & 1 ? 0.45f : -0.45f) * w, z = (i & 2 ? 0.42f : -0.42f) * d;
            dmg_cone(b, v3(x, 0, z), v3(x, seat - t, z), 0.3f * pitch, 0.5f * pitch);
        }
        dmg_box_span(b, v3(-0.48f * w, seat - t - box, -0.48f * d), v3(0.48f * w, seat - t, 0.48f * d));
        uint32_t lid = dmg_hinge(b, 0, "seat", v3(0, seat - t, 0.48f * d), v3(1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.7f));
        dmg_rounded_box(b, v3(0, seat - 0.5f * t, 0), v3(w, t, d), 0.3f * t);
        dmg_rest(b, lid, dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.2f, 0.9f));
    } else {
        int legs = dmg_int(b, 3, 5);
        float way = 0.3f * seat, thread = pitch * dmg_range(b, 0.05f, 0.2f);
        dmg_rod(b, v3(0, 0.25f * seat, 0), v3(0, 0.6f * seat, 0), 0.9f * pitch);
        for (int i = 0; i < legs; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, legs);
            dmg_cone(b, v3(0, 0, 0.5f * d), v3(0, 0.35f * seat, 0), 0.3f * pitch, 0.4f * pitch);
            dmg_restore(b);
        }
        dmg_screw(b, 0, "seat", v3(0, seat, 0), v3(0, 1, 0), thread, 0.0f, fminf(35.0f, way / thread));
        dmg_rod(b, v3(0, 0.3f * seat, 0), v3(0, seat - t, 0), 0.5f * pitch);
        dmg_rod(b, v3(0, seat - t, 0), v3(0, seat, 0), 0.55f * d);
    }
    dmg_use(b, 0);
}

/* Draws a ledge or frame for the music, on z = 0 leaning back on a board; its line is X through the origin. */
static void draw_desk(dmg_builder* b, float wide, float tall, float t) {
    uint32_t desk = dmg_hinge(b, 0, "music_desk", v3(0, 0, 0.5f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 1.2f));
    if (dmg_chance(b, 0.5f)) {
        dmg_box_span(b, v3(-0.5f * wide, 0, 0), v3(0.5f * wide, tall, t));
    } else {
        dmg_save(b);
        dmg_move(b, 0, 0.5f * tall, t);
        dmg_frame_draw(b, wide, tall, t, 0.12f * tall);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(-0.5f * wide, 0, 0), v3(0.5f * wide, 0.5f * t, 3 * t));
    dmg_rest(b, desk, dmg_range(b, 0.0f, 0.3f));
    dmg_use(b, 0);
}

/* ---- uprights ---- */

/* Draws the lid over the case: hung behind, folded in its middle, or hung at an end. */
static void draw_top_lid(dmg_builder* b, const piano* p, float front, float rear) {
    float x = p->x + 1.2f * p->wall, t = 0.8f * p->wall, y = p->top, over = 0.3f * p->wall;
    int way = dmg_weighted(b, (const float[]){3, 2, 1}, 3);
    float half = way == 1 ? 0.5f * (front + rear) : rear, swing = dmg_range(b, 0.8f, way == 1 ? 3.0f : 1.8f);
    if (way == 1) dmg_box_span(b, v3(-x, y, rear - over), v3(x, y + t, half));
    uint32_t lid;
    if (way == 2)
        lid = dmg_hinge(b, 0, "lid", v3(-x, y, 0), v3(0, 0, 1), 0.0f, fminf(swing, 1.2f));
    else
        lid = dmg_hinge(b, 0, "lid", v3(0, y + (way == 1 ? t : 0.0f), half), v3(-1, 0, 0), 0.0f, swing);
    dmg_box_span(b, v3(-x, y, half - (way == 1 ? 0 : over)), v3(x, y + t, front + over));
    dmg_rest(b, lid, dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.0f, fminf(swing, 1.2f)));
    dmg_use(b, 0);
}

static void draw_upright_case(dmg_builder* b, const piano* p) {
    float x = p->x, w = p->wall, front = -p->keys.length, rear = front - p->deep, low = p->floor,
          foot = p->keys.pitch * 3.4f, toe = 0.8f * p->keys.pitch, bed = -3.5f * p->keys.thick - p->keys.dip;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(s > 0 ? x : -x - w, low, rear), v3(s > 0 ? x + w : -x, p->top, front));
    dmg_box_span(b, v3(-x, low + foot, rear), v3(x, p->top, rear + 0.5f * w));
    dmg_box_span(b, v3(-x, low, rear), v3(x, low + foot, front));
    dmg_box_span(b, v3(-x, p->cheek, front - 0.5f * w), v3(x, p->top, front)); /* the upper panel */
    if (dmg_chance(b, 0.35f))                                                  /* the lower one comes out at its top */
        dmg_hinge(b, 0, "knee_board", v3(0, low + foot, front), v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 1.5f));
    dmg_box_span(b, v3(-x, low + foot, front - 0.5f * w), v3(x, bed, front - 0.1f * w));
    dmg_use(b, 0);
    int legs = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        float px = (float)s * (x + 0.5f * w);
        if (legs == 0) dmg_cone(b, v3(px, low, -0.5f * w), v3(px, bed, -0.5f * w), 0.3f * w, 0.5f * w);
        if (legs == 1) dmg_box_span(b, v3(px - 0.4f * w, low, -w), v3(px + 0.4f * w, bed, 0));
        if (legs > 0) dmg_box_span(b, v3(px - 0.5f * w, low, front), v3(px + 0.5f * w, low + toe, 0.5f * w));
    }
    if (dmg_chance(b, 0.2f)) { /* sconces for candles, swung aside */
        for (int s = -1; s <= 1; s += 2) {
            float px = (float)s * 0.8f * x, y = 0.6f * p->top + 0.4f * p->cheek, arm = 3 * p->keys.pitch, r = 0.2f * w;
            dmg_hinge(b, 0, "sconce", v3(px, y, front + r), v3(0, 1, 0), -1.2f, 1.2f);
            dmg_rod(b, v3(px, y - 2 * r, front + r), v3(px, y + 2 * r, front + r), r);
            dmg_rod(b, v3(px, y, front), v3(px, y, front + arm), 0.7f * r);
            dmg_cone(b, v3(px, y, front + arm), v3(px, y + 3 * r, front + arm), r, 2 * r);
            dmg_use(b, 0);
        }
    }
}

/* Knobs on the board over an organ's keys, drawn out for a register. */
static void draw_stops(dmg_builder* b, const piano* p) {
    int count = dmg_int(b, 4, 11);
    float r = p->keys.pitch * dmg_range(b, 0.35f, 0.6f), pitch = 1.8f * p->x / (float)count;
    for (int i = 0; i < count; ++i) {
        float x = pitch * ((float)i - 0.5f * (float)(count - 1)), z = -p->keys.length, y = p->cheek + 3 * r;
        uint32_t stop = dmg_slide(b, 0, "stop", v3(0, 0, 1), 0.0f, 3 * r);
        dmg_rod(b, v3(x, y, z - 3 * r), v3(x, y, z + r), 0.4f * r);
        dmg_rod(b, v3(x, y, z + 0.4f * r), v3(x, y, z + 1.3f * r), fminf(r, 0.45f * pitch));
        dmg_rest(b, stop, dmg_chance(b, 0.4f) ? 3 * r : 0.0f);
        dmg_use(b, 0);
    }
}

static void draw_upright(dmg_builder* b) {
    bool organ = dmg_chance(b, 0.25f);
    float floor = dmg_range(b, 16.0f, 30.0f), top = dmg_range(b, 12.0f, 30.0f), deep = dmg_range(b, 7.0f, 14.0f);
    piano p = pick_piano(b, floor, top, deep);
    dmg_move(b, 0, -p.floor, 0);
    draw_key_case(b, &p);
    draw_upright_case(b, &p);
    draw_fallboard(b, &p);
    if (organ) draw_stops(b, &p);
    draw_top_lid(b, &p, -p.keys.length, -p.keys.length - p.deep);
    dmg_save(b);
    dmg_move(b, 0, p.cheek + p.keys.pitch * 2.2f, -p.keys.length);
    float tall = fminf(0.8f * (p.top - p.cheek - 2.2f * p.keys.pitch), p.keys.pitch * dmg_range(b, 5.0f, 10.0f));
    if (!organ && tall > 0 && dmg_chance(b, 0.6f))
        draw_desk(b, p.x * dmg_range(b, 0.8f, 1.6f), tall, 0.3f * p.keys.pitch);
    dmg_restore(b);
    dmg_move(b, 0, p.floor, -p.keys.length);
    draw_pedals(b, p.keys.pitch, organ);
    if (!dmg_chance(b, 0.35f)) return;
    dmg_move(b, 0, 0, p.keys.length + p.keys.pitch * dmg_range(b, 8.0f, 14.0f));
    draw_stool(b, p.keys.pitch, -0.68f * p.floor);
}

/* ---- grands: seen from above, x and the way back from the keys' ends ---- */

enum { BEND = 14 };

/* From the right front along the bent side to the tail, then the straight spine; in by `shrink`. */
static void grand_outline(float x, float from, float reach, float tail, float shrink, dmg_xy out[BEND + 2]) {
    for (int i = 0; i < BEND; ++i) {
        float s = (float)i / (BEND - 1), back = from + (reach - from) * s;
        float share = fmaxf(0.0f, (back / reach - 0.3f) / 0.7f), bow = share * share * (3.0f - 2.0f * share);
        out[i].x = x - 2 * x * (1.0f - tail) * bow - shrink;
        out[i].y = fminf(reach - shrink, fmaxf(from + shrink, back));
    }
    out[BEND] = (dmg_xy){shrink - x, reach - shrink};
    out[BEND + 1] = (dmg_xy){shrink - x, from + shrink};
}

/* Turned up: the outline's y becomes the way back. */
static void draw_rim(dmg_builder* b, const piano* p, float tail, float low, float high) {
    dmg_xy outer[BEND + 2], inner[BEND + 2];
    float x = p->x + p->wall;
    grand_outline(x, 0, p->deep, tail, 0, outer);
    grand_outline(x, 0, p->deep, tail, 0.8f * p->wall, inner);
    dmg_ring_plate(b, outer, inner, BEND + 2, low, high);
    dmg_extrude(b, inner, BEND + 2, low + 0.1f * (high - low), low + 0.35f * (high - low));
}

/* Draws the lid on the spine, its front leaf folded back on it; the prop that holds it. */
static void draw_grand_lid(dmg_builder* b, const piano* p, float tail, float high) {
    float x = p->x + p->wall, t = 0.4f * p->wall, flap = p->deep * dmg_range(b, 0.15f, 0.3f),
          swing = dmg_range(b, 0.45f, 0.8f);
    bool open = dmg_chance(b, 0.65f), leaf = dmg_chance(b, 0.75f);
    dmg_xy plan[BEND + 2];
    grand_outline(1.02f * x, leaf ? flap : -0.3f * p->wall, p->deep, tail, 0, plan);
    float stick = 0.8f * 2 * x * sinf(swing), at = 0.3f * p->deep;
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(-x, 0, high), v3(0, -1, 0), 0.0f, swing);
    dmg_extrude(b, plan, BEND + 2, high, high + t);
    dmg_rest(b, lid, open ? swing : 0.0f);
    dmg_keep_rest(b, lid);
    if (leaf) {
        uint32_t front = dmg_hinge(b, lid, "front_lid", v3(0, flap, high + t), v3(-1, 0, 0), 0.0f, 3.1f);
        dmg_box_span(b, v3(-1.02f * x, -0.3f * p->wall, high), v3(1.02f * x, flap, high + t));
        dmg_rest(b, front, dmg_chance(b, 0.6f) ? 3.1f : dmg_range(b, 0.0f, 3.0f));
    }
    dmg_use(b, 0);
    float px = 0.8f * x, r = 0.15f * p->wall, y = high - 2 * r;
    stick = fminf(stick, 0.5f * p->deep);
    dmg_box_span(b, v3(px - 4 * r, at - 2 * r, y - 2 * r), v3(x - 0.5f * p->wall, at + 2 * r, y - r));
    uint32_t prop = dmg_hinge(b, 0, "prop", v3(px, at, y), v3(1, 0, 0), 0.0f, 1.5f);
    dmg_rod(b, v3(px, at, y), v3(px, at + stick, y), r);
    dmg_rod(b, v3(px - 2 * r, at, y), v3(px + 2 * r, at, y), 1.4f * r);
    dmg_rest(b, prop, open ? 1.4f : 0.0f);
    dmg_keep_rest(b, prop);
    dmg_use(b, 0);
}

static void draw_grand_legs(dmg_builder* b, const piano* p, float low) {
    float x = 0.9f * p->x, r = p->keys.pitch * dmg_range(b, 0.8f, 1.8f), tall = low - p->floor;
    bool square = dmg_chance(b, 0.4f);
    for (int i = 0; i < 3; ++i) {
        float px = i == 2 ? -0.6f * x : (i ? x : -x),
              z = i == 2 ? -p->keys.length - 0.85f * p->deep : -0.7f * p->keys.length;
        if (square)
            dmg_box_span(b, v3(px - 0.8f * r, p->floor, z - 0.8f * r), v3(px + 0.8f * r, low, z + 0.8f * r));
        else
            dmg_cone(b, v3(px, p->floor + 0.08f * tall, z), v3(px, low, z), 0.6f * r, r);
        if (!square)
            dmg_rod(b, v3(px - 0.4f * r, p->floor + 0.04f * tall, z), v3(px + 0.4f * r, p->floor + 0.04f * tall, z),
                    0.04f * tall);
    }
    float box = 0.16f * tall, w = 4 * p->keys.pitch, z = -p->keys.length - 0.1f * p->deep; /* the lyre */
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.6f * w, p->floor + box, z), v3((float)s * 0.6f * w, low, z), 0.3f * r);
    dmg_box_span(b, v3(-1.5f * w, p->floor + 0.02f * tall, z - 0.3f * w), v3(1.5f * w, p->floor + box, z));
    dmg_save(b);
    dmg_move(b, 0, p->floor, z);
    draw_pedals(b, p->keys.pitch, false);
    dmg_restore(b);
}

static void draw_grand(dmg_builder* b) {
    float tail = dmg_range(b, 0.25f, 0.6f);
    float floor = dmg_range(b, 22.0f, 32.0f), deep = dmg_range(b, 25.0f, 60.0f);
    piano p = pick_piano(b, floor, 0, deep);
    float bed = 3.5f * p.keys.thick + p.keys.dip, high = p.cheek + p.keys.pitch * dmg_range(b, 0.5f, 3.0f), low = -bed;
    dmg_move(b, 0, -p.floor, 0);
    draw_key_case(b, &p);
    draw_fallboard(b, &p);
    draw_grand_legs(b, &p, low);
    dmg_save(b);
    dmg_move(b, 0, 0, -p.keys.length);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* y back, z up */
    draw_rim(b, &p, tail, low, high);
    if (dmg_chance(b, 0.85f)) draw_grand_lid(b, &p, tail, high);
    if (dmg_chance(b, 0.5f)) { /* the music's leaf, flat on the case */
        float at = 2 * p.wall, t = 0.25f * p.keys.pitch, w = 0.6f * p.x, l = p.keys.pitch * dmg_range(b, 4.0f, 8.0f);
        dmg_box_span(b, v3(-p.x, at - 2 * t, high - 3 * t), v3(p.x, at, high - 2 * t));
        uint32_t desk =
            dmg_hinge(b, 0, "music_desk", v3(0, at, high - 1.5f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.3f));
        dmg_box_span(b, v3(-w, at, high - 2 * t), v3(w, at + l, high - t));
        dmg_rest(b, desk, dmg_range(b, 0.0f, 0.9f));
        dmg_use(b, 0);
    }
    dmg_restore(b);
    if (!dmg_chance(b, 0.4f)) return;
    dmg_move(b, 0, p.floor, p.keys.pitch * dmg_range(b, 8.0f, 14.0f));
    draw_stool(b, p.keys.pitch, -0.68f * p.floor);
}

void dmg_build_piano(dmg_builder* b) {
    if (dmg_chance(b, 0.55f))
        draw_upright(b);
    else
        draw_grand(b);
}
