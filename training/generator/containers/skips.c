/* Draws waste containers: steel ones with flapping lids and sliding side doors, skips, roll-off boxes with barred
 * doors, bottle banks that drop their floor, bins on casters under a dome. The user stands at +Z. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Under a floor at y = deck: a swivel fork with its wheel, or the wheel alone in fixed cheeks. */
static void draw_caster(dmg_builder* b, float x, float z, float deck, bool swivels) {
    float r = 0.38f * deck, trail = swivels ? 0.4f * r : 0.0f, cheek = 0.12f * r;
    uint32_t fork = 0;
    dmg_use(b, 0);
    dmg_box(b, v3(x, deck - 0.08f * r, z), v3(1.5f * r, 0.16f * r, 1.5f * r));
    if (swivels) fork = dmg_spin(b, 0, "caster", v3(x, 0, z), v3(0, 1, 0));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(x + (float)s * 0.45f * r - cheek, 0.8f * r, z - trail - 0.35f * r),
                     v3(x + (float)s * 0.45f * r + cheek, deck - 0.2f * r, z + 0.35f * r));
    dmg_box_span(b, v3(x - 0.5f * r, deck - 0.4f * r, z - trail - 0.35f * r),
                 v3(x + 0.5f * r, deck - 0.16f * r, z + 0.35f * r));
    dmg_spin(b, fork, "wheel", v3(x, r, z - trail), v3(1, 0, 0));
    dmg_rod(b, v3(x - 0.28f * r, r, z - trail), v3(x + 0.28f * r, r, z - trail), r);
    dmg_rod(b, v3(x - 0.55f * r, r, z - trail), v3(x + 0.55f * r, r, z - trail), 0.2f * r);
    dmg_use(b, 0);
}

static void draw_casters(dmg_builder* b, float width, float deep, float deck, bool all) {
    for (int i = 0; i < 4; ++i)
        draw_caster(b, i & 1 ? 0.4f * width : -0.4f * width, i & 2 ? 0.36f * deep : -0.36f * deep, deck, all || i & 2);
}

/* A trough whose section in z, y runs along x: sheets round a hollow, or a block. */
typedef struct hull {
    float width, deep, high, front; /* deep: of the mouth; heights of back and front over the floor */
    float toe, heel;                /* how far front and back lean out towards the mouth */
    float t;
    bool solid;
} hull;

static void draw_hull(dmg_builder* b, const hull* h) {
    float z = 0.5f * h->deep;
    const dmg_xy section[] = {{-z, h->high}, {h->heel - z, 0}, {z - h->toe, 0}, {z, h->front}};
    const dmg_xy cheek[] = {section[1], section[2], section[3], section[0]};
    dmg_profile_begin(b);
    if (h->solid) {
        dmg_extrude(b, cheek, 4, -0.5f * h->width, 0.5f * h->width);
    } else {
        dmg_bent_plate(b, section, 4, h->t, h->width);
        dmg_extrude(b, cheek, 4, 0.5f * h->width - h->t, 0.5f * h->width);
        dmg_extrude(b, cheek, 4, -0.5f * h->width, h->t - 0.5f * h->width);
    }
    dmg_restore(b);
}

/* Draws a lid from the line z = 0 to z = length, its underside on y = 0: a plate, a ribbed one, one with a folded rim,
 * a shallow dome. */
static void draw_lid_plate(dmg_builder* b, int kind, float width, float length, float t) {
    if (kind == 3) {
        const dmg_xy bow[] = {{0, 0.5f * t}, {0.2f * length, 2 * t}, {0.8f * length, 2 * t}, {length, 0.5f * t}};
        dmg_profile_begin(b);
        dmg_bent_plate(b, bow, 4, t, width);
        dmg_restore(b);
        return;
    }
    dmg_box_span(b, v3(-0.5f * width, 0, 0), v3(0.5f * width, t, length));
    for (int i = 0; i < 3 && kind == 1; ++i)
        dmg_box(b, v3(width * 0.28f * (float)(i - 1), 1.3f * t, 0.5f * length), v3(0.1f * width, t, 0.8f * length));
    if (kind == 2) dmg_box_span(b, v3(-0.5f * width, -2 * t, length), v3(0.5f * width, t, length + t));
}

/* ---- a steel container: lids on a rod behind, doors in its sides, pockets for the forks ---- */

/* On the slope of the mouth: z runs from the back edge down to the front one. */
static void draw_lids(dmg_builder* b, const hull* h, float slope) {
    int count = dmg_weighted(b, (const float[]){2, 3, 1}, 3) + 1, kind = dmg_int(b, 0, 3), hold = dmg_int(b, 0, 2);
    float t = h->t * dmg_range(b, 0.5f, 1.5f), line = t * dmg_range(b, 0.0f, 2.5f), off = t * dmg_range(b, 0.0f, 2.5f);
    float swing = off > t && line > t ? dmg_range(b, 1.6f, 4.3f) : dmg_range(b, 1.2f, 1.9f);
    float gap = 0.01f * h->width, each = h->width / (float)count;
    bool split = count == 1 && dmg_chance(b, 0.3f), ajar = dmg_chance(b, 0.25f);
    if (dmg_chance(b, 0.6f)) { /* the rod they hang on, in lugs */
        dmg_rod(b, v3(-0.5f * h->width, line, -off), v3(0.5f * h->width, line, -off), 0.5f * t);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * 0.5f * h->width - 0.5f * t, -t, -off - t),
                         v3((float)s * 0.5f * h->width + 0.5f * t, line + t, 0));
    }
    for (int i = 0; i < count; ++i) {
        float x = each * ((float)i - 0.5f * (float)(count - 1)), rear = split ? 0.35f * slope : 0.0f;
        dmg_use(b, 0);
        if (split) dmg_box_span(b, v3(-0.5f * h->width, 0, 0), v3(0.5f * h->width, t, rear));
        uint32_t lid = dmg_hinge(b, 0, "lid", v3(x, split ? t : line, split ? rear : -off), v3(-1, 0, 0), 0.0f,
                                 split ? fminf(swing, 3.0f) : swing);
        if (ajar && dmg_chance(b, 0.6f)) dmg_rest(b, lid, fminf(swing, 2.0f) * dmg_range(b, 0.1f, 1.0f));
        dmg_save(b);
        dmg_move(b, x, 0, rear);
        draw_lid_plate(b, kind, each - gap, slope - rear, t);
        for (int s = -1; s <= 1 && !split && off > 0.5f * t; s += 2) /* straps round the rod */
            dmg_beam(b, v3((float)s * 0.3f * each, 0.5f * t, 0.02f * slope), v3((float)s * 0.3f * each, line, -off),
                     0.1f * each, t);
        dmg_move(b, 0, kind == 3 ? 2 * t : t, 0.8f * (slope - rear));
        if (hold == 1) dmg_torus(b, v3(0, 0.5f * t, 0), v3(1, 0, 0), 1.5f * t, 0.4f * t);
        if (hold == 2) dmg_box(b, v3(0, 0.5f * t, 0), v3(0.25f * each, t, 0.8f * t));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a door in one end, outside the sheet, on rails above and below; or hung at the side. */
static void draw_end_door(dmg_builder* b, const hull* h, float side) {
    float x = side * 0.5f * h->width, t = 0.7f * h->t, low = 0.3f * h->front, high = 0.85f * h->front,
          wide = 0.3f * (h->deep - h->toe - h->heel), z0 = 0.5f * (h->toe > 0 ? -h->toe : 0.0f), way = 1.05f * wide;
    bool slides = dmg_chance(b, 0.75f);
    float from = slides ? z0 - wide : z0 - 0.5f * wide;
    if (slides) {
        for (int k = 0; k < 2; ++k) {
            float y = k ? high + 0.5f * t : low - 0.5f * t;
            dmg_box_span(b, v3(x - t, y - t, from - t), v3(x + side * 2.2f * t, y + t, from + wide + way + t));
        }
        uint32_t door = dmg_slide(b, 0, "side_door", v3(0, 0, 1), 0.0f, way);
        if (dmg_chance(b, 0.3f)) dmg_rest(b, door, way * dmg_unit(b));
    } else {
        dmg_hinge(b, 0, "side_door", v3(x + side * 0.7f * t, 0, from), v3(0, side, 0), 0.0f, dmg_range(b, 1.3f, 2.8f));
    }
    dmg_box_span(b, v3(x + side * 0.1f * t, low, from), v3(x + side * 1.2f * t, high, from + wide));
    dmg_box(b, v3(x + side * 1.8f * t, 0.5f * (low + high), from + 0.85f * wide),
            v3(1.4f * t, 0.35f * (high - low), 0.08f * wide));
    dmg_use(b, 0);
}

/* Draws a bar that lies over the lids on two arms; it swings away to the front. */
static void draw_lock_bar(dmg_builder* b, const hull* h) {
    float t = h->t, x = 0.5f * h->width + 1.2f * t, z = 0.5f * h->deep - 0.12f * h->deep, y = 0.8f * h->front,
          top = h->front + 0.2f * (h->high - h->front) + 4.5f * t;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.5f * h->width, y, z), v3((float)s * (x + t), y, z), 0.7f * t);
    dmg_hinge(b, 0, "lock_bar", v3(0, y, z), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.4f));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * x - 0.4f * t, y - t, z - t), v3((float)s * x + 0.4f * t, top, z + t));
    dmg_box(b, v3(0, top, z), v3(2 * x, 1.2f * t, 1.6f * t));
    dmg_use(b, 0);
}

static void draw_container(dmg_builder* b) {
    hull h = {.width = dmg_range(b, 1.2f, 2.2f), .t = dmg_range(b, 0.015f, 0.035f)};
    h.deep = h.width * dmg_range(b, 0.45f, 0.85f);
    h.high = dmg_range(b, 0.8f, 1.6f);
    h.front = h.high * dmg_range(b, 0.6f, 1.0f);
    h.toe = dmg_chance(b, 0.5f) ? h.deep * dmg_range(b, 0.05f, 0.25f) : 0.0f;
    h.heel = dmg_chance(b, 0.2f) ? h.deep * dmg_range(b, 0.03f, 0.12f) : 0.0f;
    h.solid = dmg_chance(b, 0.25f);
    float deck = dmg_chance(b, 0.5f) ? dmg_range(b, 0.12f, 0.25f) : 0.0f, fall = atan2f(h.high - h.front, h.deep);
    if (deck > 0) draw_casters(b, h.width, h.deep - 2 * h.toe, deck, dmg_chance(b, 0.4f));
    dmg_move(b, 0, deck, 0);
    draw_hull(b, &h);
    int pockets = dmg_int(b, 0, 2), doors = dmg_int(b, 0, 2), ribs = dmg_int(b, 0, 4);
    for (int s = -1; s <= 1 && pockets; s += 2)
        dmg_box(b, v3((float)s * (0.5f * h.width + 0.05f), (pockets == 1 ? 0.12f : 0.93f) * h.front, 0),
                v3(0.1f, 0.1f, 0.7f * (h.deep - 2 * h.toe)));
    for (int i = 0; i < ribs; ++i) /* on the back, upright only where it stands upright */
        if (h.heel == 0.0f)
            dmg_box(b, v3(h.width * (((float)i + 0.5f) / (float)ribs - 0.5f), 0.5f * h.high, -0.5f * h.deep - h.t),
                    v3(0.05f, 0.9f * h.high, h.t));
    for (int i = 0; i < doors; ++i) draw_end_door(b, &h, i ? -1.0f : 1.0f);
    if (dmg_chance(b, 0.3f)) draw_lock_bar(b, &h);
    dmg_save(b);
    dmg_move(b, 0, h.high + 0.6f * h.t, -0.5f * h.deep);
    dmg_turn(b, v3(1, 0, 0), fall);
    draw_lids(b, &h, h.deep / cosf(fall));
    dmg_restore(b);
}

/* ---- a skip: ends that lean out, open or under wings along a ridge, an end that drops ---- */

/* Wings over the mouth at y = 0: hung along the middle, or along the long sides. */
static void draw_wings(dmg_builder* b, float length, float width, float t) {
    int each = dmg_int(b, 1, 2), kind = dmg_int(b, 0, 2);
    bool ridge = dmg_chance(b, 0.5f);
    float half = 0.5f * width, beam = 2 * t, long_ = length / (float)each,
          swing = dmg_range(b, 1.2f, ridge ? 1.5f : 2.6f);
    float inner = ridge ? beam : 0.0f;
    if (ridge) dmg_box_span(b, v3(-0.5f * length, -beam, -beam), v3(0.5f * length, t, beam));
    for (int i = 0; i < 2 * each; ++i) {
        float x = long_ * ((float)(i / 2) - 0.5f * (float)(each - 1));
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        if (i & 1) dmg_turn(b, v3(0, 1, 0), DMG_PI);
        if (!ridge) { /* from the long side inwards */
            dmg_move(b, 0, 0, -half);
        } else {
            dmg_move(b, 0, 0, inner);
        }
        float line = t * dmg_range(b, 0.5f, 1.5f);
        uint32_t wing = dmg_hinge(b, 0, "wing", v3(0, line, 0), v3(-1, 0, 0), 0.0f, swing);
        if (dmg_chance(b, 0.2f)) dmg_rest(b, wing, swing * dmg_unit(b));
        draw_lid_plate(b, kind, 0.99f * long_, half - inner - 0.005f * width, t);
        dmg_torus(b, v3(0, t, 0.85f * (half - inner)), v3(1, 0, 0), 1.6f * t, 0.35f * t);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws the upright end at x = 0, facing +X, hinged at its foot; hooks at its sides hold it. */
static void draw_drop_end(dmg_builder* b, float width, float high, float t) {
    float line = t * dmg_range(b, 0.0f, 2.0f), swing = dmg_range(b, 1.2f, 2.9f);
    uint32_t end = dmg_hinge(b, 0, "drop_end", v3(line, t, 0), v3(0, 0, -1), 0.0f, swing);
    dmg_box_span(b, v3(-0.5f * t, t, -0.5f * width), v3(0.5f * t, high, 0.5f * width));
    int ribs = dmg_int(b, 0, 3);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(t, high * ((float)i + 1.0f) / ((float)ribs + 1.0f), 0), v3(t, 1.5f * t, 0.9f * width));
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * (0.5f * width + t), y = high * 0.82f;
        dmg_use(b, end);
        dmg_rod(b, v3(0, y, (float)s * 0.45f * width), v3(0, y, z + (float)s * 0.6f * t), 0.6f * t);
        dmg_use(b, 0);
        dmg_rod(b, v3(-6 * t, y, (float)s * 0.45f * width), v3(-6 * t, y, z + (float)s * t), 0.5f * t);
        dmg_hinge(b, 0, "hook", v3(-6 * t, y, z), v3(0, 0, 1), 0.0f, dmg_range(b, 0.8f, 2.2f));
        dmg_box_span(b, v3(-10 * t, y - 0.7f * t, z - 0.4f * t), v3(1.4f * t, y + 0.9f * t, z + 0.4f * t));
        dmg_box_span(b, v3(0.8f * t, y - 2 * t, z - 0.4f * t), v3(1.8f * t, y + 0.9f * t, z + 0.4f * t));
        dmg_use(b, 0);
    }
}

static void draw_skip(dmg_builder* b) {
    float length = dmg_range(b, 2.2f, 4.0f), high = length * dmg_range(b, 0.28f, 0.45f),
          t = dmg_range(b, 0.02f, 0.045f), width = length * dmg_range(b, 0.4f, 0.55f),
          lean = length * dmg_range(b, 0.12f, 0.26f), x = 0.5f * length;
    bool drops = dmg_chance(b, 0.6f), solid = !drops && dmg_chance(b, 0.2f), wings = !drops || dmg_chance(b, 0.55f);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    float right = drops ? 0.0f : lean;
    const dmg_xy section[] = {{-x, high}, {lean - x, 0.5f * t}, {x - right, 0.5f * t}, {x, high}};
    const dmg_xy cheek[] = {{lean - x, 0}, {x - right, 0}, {x, high}, {-x, high}};
    if (solid) {
        dmg_extrude(b, cheek, 4, -0.5f * width, 0.5f * width);
    } else {
        dmg_bent_plate(b, section, drops ? 3 : 4, t, width);
        for (int s = -1; s <= 1; s += 2) {
            float z = (float)s * 0.5f * (width - t);
            dmg_extrude(b, cheek, 4, z - 0.5f * t, z + 0.5f * t);
        }
    }
    for (int s = -1; s <= 1; s += 2) { /* a rim and the lugs that the chains take */
        float z = (float)s * 0.5f * width, at = (float)s * (0.5f * width + 0.06f);
        dmg_box(b, v3(0, high - t, z), v3(0.98f * length, 2 * t, 2 * t));
        for (int k = -1; k <= 1; k += 2)
            dmg_rod(b, v3((float)k * 0.25f * length, 0.75f * high, z), v3((float)k * 0.25f * length, 0.75f * high, at),
                    1.2f * t);
    }
    if (drops) {
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        draw_drop_end(b, width - 3 * t, high - (wings ? 2 * t : 0), t);
        dmg_restore(b);
    }
    dmg_move(b, 0, high + 0.1f * t, 0);
    if (wings) draw_wings(b, 0.98f * length, width, t);
}

/* ---- a roll-off box: rear doors with their bars, rollers under its rails ---- */

/* Draws an upright bar on a door's outside at z = 0, turned by its handle, with a cam at each end. */
static void draw_door_bar(dmg_builder* b, uint32_t door, float x, float high, float reach, float r) {
    dmg_use(b, door);
    for (int k = 0; k < 3; ++k) dmg_box(b, v3(x, high * (0.2f + 0.3f * (float)k), r), v3(5 * r, 2 * r, 1.2f * r));
    uint32_t bar = dmg_hinge(b, door, "door_bar", v3(x, 0, 2 * r), v3(0, reach > 0 ? -1.0f : 1.0f, 0), 0.0f,
                             dmg_range(b, 1.2f, 2.0f));
    dmg_rod(b, v3(x, 0.02f * high, 2 * r), v3(x, 0.98f * high, 2 * r), r);
    dmg_box_span(b, v3(fminf(x, x + reach), 0.42f * high, 2 * r),
                 v3(fmaxf(x, x + reach), 0.42f * high + 1.5f * r, 3 * r));
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3(x, high * (0.5f + 0.47f * (float)k), 2 * r), v3(3 * r, 2 * r, 3 * r));
    if (dmg_chance(b, 0.2f)) dmg_rest(b, bar, 1.0f);
}

/* Draws two leaves, one, or a flap hung at the top, in the mouth at z = 0. */
static void draw_rear(dmg_builder* b, float width, float high, float t) {
    int kind = dmg_weighted(b, (const float[]){3, 1, 1.3f}, 3), leaves = kind == 0 ? 2 : 1, ribs = dmg_int(b, 0, 4);
    float r = dmg_range(b, 0.015f, 0.03f), swing = kind == 2 ? dmg_range(b, 0.9f, 1.6f) : dmg_range(b, 1.4f, 4.2f);
    float line = kind == 2 ? t : t * dmg_range(b, 0.8f, 1.5f);
    for (int i = 0; i < leaves; ++i) {
        float side = i ? 1.0f : -1.0f, wide = width / (float)leaves, x = leaves == 2 ? side * 0.25f * width : 0.0f;
        dmg_use(b, 0);
        uint32_t door =
            kind == 2 ? dmg_hinge(b, 0, "rear_flap", v3(0, high, line), v3(-1, 0, 0), 0.0f, swing)
                      : dmg_hinge(b, 0, "rear_door", v3(side * 0.5f * width, 0, line), v3(0, side, 0), 0.0f, swing);
        if (dmg_chance(b, 0.2f)) dmg_rest(b, door, fminf(swing, 1.5f) * dmg_unit(b));
        dmg_box_span(b, v3(x - 0.495f * wide, 0.01f * high, 0), v3(x + 0.495f * wide, 0.99f * high, t));
        for (int k = 0; k < ribs; ++k)
            dmg_box(b, v3(x, high * ((float)k + 0.5f) / (float)ribs, t), v3(0.9f * wide, 2 * r, 1.5f * r));
        dmg_save(b);
        dmg_move(b, 0, 0, ribs ? t + 0.75f * r : t);
        if (kind != 2) draw_door_bar(b, door, x - side * 0.2f * wide, high, side * 0.3f * wide, r);
        dmg_restore(b);
        for (int k = -1; k <= 1 && kind == 2; k += 2) { /* catches at its foot */
            float at = (float)k * 0.4f * width;
            dmg_use(b, 0);
            dmg_box_span(b, v3(at - 3 * r, -3 * r, -t), v3(at + 3 * r, -r, t + 3 * r));
            dmg_hinge(b, 0, "catch", v3(at, -2 * r, t + 2 * r), v3(1, 0, 0), 0.0f, dmg_range(b, 0.8f, 2.0f));
            dmg_box_span(b, v3(at - r, -3 * r, t + r), v3(at + r, 0.15f * high, t + 3 * r));
        }
    }
    dmg_use(b, 0);
}

static void draw_roll_off(dmg_builder* b) {
    float length = dmg_range(b, 3.5f, 6.5f), width = length * dmg_range(b, 0.3f, 0.45f), t = 0.05f,
          high = width * dmg_range(b, 0.5f, 1.1f), roller = dmg_range(b, 0.07f, 0.12f), z = 0.5f * length;
    int ribs = dmg_int(b, 0, 7);
    bool block = dmg_chance(b, 0.15f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.32f * width;
        dmg_box_span(b, v3(x - 0.05f, roller, -z), v3(x + 0.05f, 2.2f * roller, z));
        for (int k = -1; k <= 1; k += 2) {
            float at = x + (float)s * 0.13f;
            dmg_use(b, 0);
            dmg_rod(b, v3(x, roller, (float)k * 0.85f * z), v3(at + (float)s * 0.08f, roller, (float)k * 0.85f * z),
                    0.3f * roller);
            dmg_spin(b, 0, "roller", v3(at, roller, (float)k * 0.85f * z), v3(1, 0, 0));
            dmg_rod(b, v3(at - 0.06f, roller, (float)k * 0.85f * z), v3(at + 0.06f, roller, (float)k * 0.85f * z),
                    roller);
            dmg_use(b, 0);
        }
    }
    dmg_move(b, 0, 2.2f * roller, 0);
    if (block) {
        dmg_box_span(b, v3(-0.5f * width, 0, -z), v3(0.5f * width, high, z));
    } else {
        dmg_box_span(b, v3(-0.5f * width, 0, -z), v3(0.5f * width, t, z));
        dmg_box_span(b, v3(-0.5f * width, t, -z), v3(0.5f * width, high, t - z));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.5f * (width - t), 0.5f * (high + t), 0.5f * t), v3(t, high - t, length - t));
    }
    for (int i = 0; i < 2 * ribs; ++i)
        dmg_box(b,
                v3((i & 1 ? 0.5f : -0.5f) * (width + 0.06f), 0.5f * high,
                   length * (((float)(i / 2) + 0.5f) / (float)ribs - 0.5f)),
                v3(0.06f, 0.96f * high, 0.08f));
    dmg_rod(b, v3(-0.15f, 0.8f * high, -z - 0.12f), v3(0.15f, 0.8f * high, -z - 0.12f), 0.03f); /* for the hook */
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 0.15f, 0.78f * high, -z - 0.07f), v3(0.04f, 0.3f, 0.16f));
    dmg_save(b);
    dmg_move(b, 0, 0, z + 0.002f);
    draw_rear(b, width, high, t);
    dmg_restore(b);
    if (!dmg_chance(b, 0.35f)) return;
    dmg_move(b, 0, high + 0.005f, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    draw_wings(b, 0.98f * length, width, 0.04f);
}

/* ---- a bottle bank: flaps before its holes, a rod on top that lets its floor fall ---- */

/* Draws a ring about z at the origin with a round flap hung at its top: in its mouth, opening inwards, or outside it.
 */
static void draw_port(dmg_builder* b, float r) {
    bool outward = dmg_chance(b, 0.35f);
    float swing = dmg_range(b, 0.6f, 1.4f),
          deep = r * (outward ? dmg_range(b, 0.15f, 0.5f) : dmg_range(b, 0.95f, 1.3f));
    const dmg_xy ring[] = {
        {0.85f * r, -0.5f * r}, {1.15f * r, -0.5f * r}, {r, deep}, {0.85f * r, deep}, {0.85f * r, -0.5f * r}};
    float z = outward ? deep + 0.07f * r : deep - 0.1f * r, top = outward ? 1.05f * r : 0.75f * r;
    if (!outward) swing = fminf(swing, asinf(z / (1.55f * r))); /* it has no more room than its ring is deep */
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    dmg_hinge(b, 0, "flap", v3(0, top, z), v3(outward ? -1.0f : 1.0f, 0, 0), 0.0f, swing);
    dmg_rod(b, v3(0, 0, z - 0.04f * r), v3(0, 0, z + 0.04f * r), outward ? 1.05f * r : 0.8f * r);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(-0.4f * r, top, z), v3(0.4f * r, top, z), 0.07f * r);
    dmg_use(b, 0);
}

static void draw_bank(dmg_builder* b) {
    float r = dmg_range(b, 0.5f, 0.85f), high = r * dmg_range(b, 1.6f, 2.6f), foot = 0.08f * high,
          bulge = dmg_range(b, 0.4f, 0.7f), port = r * dmg_range(b, 0.14f, 0.24f), drop = dmg_range(b, 0.5f, 1.4f);
    int shape = dmg_int(b, 0, 2), ports = dmg_int(b, 1, 4), grips = dmg_int(b, 0, 1);
    float top = (shape == 0 ? 0.35f : 0.75f) * r;
    const dmg_xy bell[] = {{0.85f * r, foot},        {r, 0.15f * high},  {r, bulge * high},
                           {0.8f * r, 0.85f * high}, {top * 0.8f, high}, {0, high}};
    const dmg_xy square[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    const dmg_row rows[] = {{0.9f, 0.9f, 0, foot}, {1, 1, 0, bulge * high}, {top / r, top / r, 0, high}};
    float flat = shape == 2 ? r * 0.95f : r; /* where the ports sit, at height mid */
    float mid = shape == 2 ? foot + (bulge * high - foot) * 0.75f : 0.15f * high + (bulge - 0.15f) * 0.7f * high;
    dmg_save(b);
    if (shape == 2) {
        dmg_face_up(b);
        dmg_loft(b, square, 4, rows, 3);
    } else {
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bell, 6);
    }
    dmg_restore(b);
    for (int i = 0; i < ports; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, ports == 3 ? 4 : ports);
        dmg_move(b, 0, mid, flat + 0.1f * port);
        draw_port(b, port);
        dmg_restore(b);
    }
    for (int s = -1; s <= 1; s += 2) { /* halves of the floor, hung at their outer edges */
        dmg_hinge(b, 0, "floor", v3((float)s * 0.62f * r, 0.75f * foot, 0), v3(0, 0, (float)s), 0.0f, drop);
        dmg_box_span(b, v3(s < 0 ? -0.62f * r : 0.005f * r, 0.55f * foot, -0.6f * r),
                     v3(s < 0 ? -0.005f * r : 0.62f * r, 0.95f * foot, 0.6f * r));
        dmg_use(b, 0);
    }
    dmg_rod(b, v3(0, high, 0), v3(0, high + 0.06f * r, 0), 0.14f * r);
    dmg_slide(b, 0, "lift_rod", v3(0, 1, 0), 0.0f, high * dmg_range(b, 0.05f, 0.15f));
    dmg_rod(b, v3(0, 0.8f * high, 0), v3(0, high + 0.25f * r, 0), 0.05f * r);
    if (grips)
        dmg_torus(b, v3(0, high + 0.37f * r, 0), v3(0, 0, 1), 0.12f * r, 0.03f * r);
    else
        dmg_ellipsoid(b, v3(0, high + 0.25f * r, 0), v3(0.13f * r, 0.07f * r, 0.13f * r));
    dmg_use(b, 0);
}

/* ---- a bin on casters under a dome that slips back over it, or a flat lid with a smaller one in it ---- */

static void draw_dome_lid(dmg_builder* b, float width, float deep, float t) {
    float r = 0.5f * deep + 1.5f * t, from = dmg_range(b, 0.03f, 0.12f), to = DMG_PI - dmg_range(b, 0.3f, 0.9f);
    float half = 0.5f * width + 1.5f * t, open = fminf(dmg_range(b, 1.0f, 1.7f), DMG_PI + 0.6f - to);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.45f * width, 0, 0), v3((float)s * (half + 1.5f * t), 0, 0), 1.5f * t);
    uint32_t lid = dmg_hinge(b, 0, "dome_lid", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, open);
    if (dmg_chance(b, 0.3f)) dmg_rest(b, lid, open * dmg_unit(b));
    dmg_arc_skin(b, r, from, to, t, 2 * half);
    for (int s = -1; s <= 1; s += 2) dmg_arc_cheek(b, r, from, to, (float)s * half, t, true);
    dmg_save(b);
    dmg_move(b, 0, (r + t) * sinf(from + 0.25f), (r + t) * cosf(from + 0.25f));
    dmg_box(b, v3(0, 0, 0), v3(0.4f * width, 1.5f * t, 3 * t));
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_flat_lid(dmg_builder* b, float width, float deep, float t) {
    float line = t * dmg_range(b, 0.0f, 2.0f), swing = dmg_range(b, 1.5f, 4.2f), z = -0.5f * deep - 2 * t;
    uint32_t lid =
        dmg_hinge(b, 0, "lid", v3(0, line, z - t), v3(-1, 0, 0), 0.0f, line > t ? swing : fminf(swing, 2.4f));
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    draw_lid_plate(b, dmg_int(b, 1, 3), width + 3 * t, deep + 4 * t, t);
    dmg_restore(b);
    dmg_rod(b, v3(-0.3f * width, line, z - t), v3(0.3f * width, line, z - t), 0.7f * t);
    if (dmg_chance(b, 0.5f)) { /* for a bag alone */
        float small = 0.4f * deep, from = 0.05f * deep;
        dmg_hinge(b, lid, "small_lid", v3(0, 2.6f * t, from), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
        dmg_box_span(b, v3(-0.3f * width, 2.6f * t, from), v3(0.3f * width, 3.4f * t, from + small));
        dmg_box(b, v3(0, 3.6f * t, from + small), v3(0.15f * width, t, 1.5f * t));
    }
    dmg_use(b, 0);
}

static void draw_wheeled_bin(dmg_builder* b) {
    float width = dmg_range(b, 0.9f, 1.4f), deep = width * dmg_range(b, 0.55f, 0.85f), high = dmg_range(b, 0.6f, 1.1f),
          deck = dmg_range(b, 0.14f, 0.22f), taper = dmg_range(b, 0.75f, 0.95f), t = dmg_range(b, 0.012f, 0.022f);
    float x = 0.5f * width, z = 0.5f * deep, c = dmg_range(b, 0.05f, 0.25f) * deep;
    const dmg_xy outline[] = {{c - x, -z}, {x - c, -z}, {x, c - z},  {x, z - c},
                              {x - c, z},  {c - x, z},  {-x, z - c}, {-x, c - z}};
    const dmg_row rows[] = {
        {taper, taper, 0, 0}, {1, 1, 0, high}, {0.94f, 0.94f, 0, high}, {taper * 0.95f, taper * 0.95f, 0, 0.05f}};
    draw_casters(b, taper * width, taper * deep, deck, dmg_chance(b, 0.6f));
    dmg_move(b, 0, deck, 0);
    dmg_save(b);
    dmg_face_up(b);
    dmg_loft(b, outline, 8, rows, dmg_chance(b, 0.7f) ? 4 : 2);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) /* trunnions to be lifted by */
        dmg_rod(b, v3((float)s * 0.97f * x, 0.8f * high, 0), v3((float)s * (x + 0.06f), 0.8f * high, 0), 0.022f);
    if (dmg_chance(b, 0.5f)) { /* what lets the water out */
        float r = dmg_range(b, 0.02f, 0.04f), at = 0.35f * taper * width, face = z * taper + 0.05f * z * (1 - taper);
        dmg_screw(b, 0, "plug", v3(at, 0.06f, face), v3(0, 0, 1), 0.1f * r, 0.0f, 2 * DMG_PI * (float)dmg_int(b, 1, 3));
        dmg_rod(b, v3(at, 0.06f, face - r), v3(at, 0.06f, face + 0.7f * r), r);
        dmg_box(b, v3(at, 0.06f, face + r), v3(0.4f * r, 1.7f * r, r));
        dmg_use(b, 0);
    }
    dmg_move(b, 0, high + t, 0);
    if (dmg_chance(b, 0.55f))
        draw_dome_lid(b, width, deep, t);
    else
        draw_flat_lid(b, width, deep, t);
}

void dmg_build_dumpster(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 1.6f, 1.6f, 1.2f, 1.6f}, 5);
    if (kind == 0) draw_container(b);
    if (kind == 1) draw_skip(b);
    if (kind == 2) draw_roll_off(b);
    if (kind == 3) draw_bank(b);
    if (kind == 4) draw_wheeled_bin(b);
    dmg_use(b, 0);
}
