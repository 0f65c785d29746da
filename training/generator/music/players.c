/* Draws record players: a platter, an arm that swings in over it and lifts, or runs along a rail; a dust lid; in a
 * plinth, a suitcase, a cabinet on legs, or a box with a horn and a crank. The listener is at +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef enum housing { HOUSE_PLINTH, HOUSE_CASE, HOUSE_CABINET, HOUSE_HORN, HOUSE_KINDS } housing;

/* The deck is y = 0. */
typedef struct deck {
    housing kind;
    bool bare;         /* no box: a frame */
    float r, x, z;     /* platter: radius and middle */
    float high;        /* its top */
    float wide, deep;  /* half sizes of the deck */
    float box;         /* the housing reaches this far down */
    float over;        /* the arm's height, and what a lid must clear */
    float pivot, back; /* of the arm, from the platter's middle: to the right and behind */
} deck;

static deck pick_deck(dmg_builder* b) {
    deck d = {.kind = (housing)dmg_weighted(b, (const float[]){5, 2, 1.6f, 2}, HOUSE_KINDS)};
    d.bare = d.kind == HOUSE_PLINTH && dmg_chance(b, 0.2f);
    d.r = dmg_scale_range(b, 0.07f, 0.18f);
    d.high = d.r * dmg_range(b, 0.04f, 0.2f);
    d.over = d.high + d.r * dmg_range(b, 0.1f, 0.2f);
    d.pivot = d.r * dmg_range(b, 1.08f, 1.25f);
    d.back = d.r * dmg_range(b, 0.35f, 0.8f);
    float right = d.r * dmg_range(b, 0.25f, 0.6f), left = d.r * dmg_range(b, 0.05f, 0.4f);
    d.wide = 0.5f * (d.r + left + d.pivot + right);
    d.x = left + d.r - d.wide;
    d.deep = d.r * dmg_range(b, 1.08f, 1.35f);
    d.z = dmg_range(b, -0.5f, 0.5f) * (d.deep - 1.05f * d.r);
    d.box = d.r * dmg_range(b, 0.15f, 0.6f);
    if (d.kind == HOUSE_HORN) d.box = d.r * dmg_range(b, 0.8f, 1.6f);
    if (d.kind == HOUSE_CABINET) d.box = d.r * dmg_range(b, 1.5f, 3.0f);
    return d;
}

/* ---- the platter ---- */

static void draw_platter(dmg_builder* b, const deck* d) {
    float r = d->r, h = d->high, rim = dmg_range(b, 0.85f, 1.0f) * r, record = 0.012f * r;
    int kind = dmg_int(b, 0, 2);
    const dmg_xy plain[] = {{0, 0.1f * h}, {r, 0.1f * h}, {r, 0.6f * h}, {rim, h}, {0, h}};
    const dmg_xy dish[] = {{0, 0.2f * h},  {0.4f * r, 0.2f * h},  {r, 0.5f * h}, {r, h},
                           {0.93f * r, h}, {0.93f * r, 0.9f * h}, {0, 0.9f * h}};
    dmg_spin(b, 0, "platter", v3(d->x, 0, d->z), v3(0, dmg_sign(b), 0));
    dmg_save(b);
    dmg_move(b, d->x, 0, d->z);
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), plain, 5);
    if (kind == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), dish, 7);
    if (kind == 2) dmg_rod(b, v3(0, 0.1f * h, 0), v3(0, h, 0), r);
    if (dmg_chance(b, 0.7f)) { /* a record, its label */
        float size = dmg_chance(b, 0.75f) ? 0.98f * r : 0.6f * r;
        dmg_rod(b, v3(0, h, 0), v3(0, h + record, 0), size);
        dmg_rod(b, v3(0, h + record, 0), v3(0, h + 1.5f * record, 0), 0.33f * size);
    }
    dmg_rod(b, v3(0, 0.5f * h, 0), v3(0, h + 0.06f * r, 0), 0.025f * r);
    int dots = dmg_chance(b, 0.25f) ? 24 : 0;
    for (int i = 0; i < dots; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / 24;
        dmg_box(b, v3(r * cosf(angle), 0.35f * h, r * sinf(angle)), v3(0.03f * r, 0.1f * h, 0.03f * r));
    }
    if (dmg_chance(b, 0.12f)) { /* a weight lifted off the spindle */
        dmg_slide(b, b->part, "weight", v3(0, 1, 0), 0.0f, 0.3f * r);
        dmg_rod(b, v3(0, h + record, 0), v3(0, h + 0.15f * r, 0), 0.16f * r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- the arm, about the origin: its pivot; parked it points to +Z beside the platter, inwards is -X ---- */

typedef struct tonearm {
    float length, tail, tube, in; /* in: how far it swings */
} tonearm;

static tonearm pick_arm(dmg_builder* b, const deck* d) {
    float way = hypotf(d->pivot, d->back), r = 0.35f * d->r, at = atan2f(d->pivot, d->back);
    tonearm a = {.length = way * dmg_range(b, 0.98f, 1.06f)};
    a.tail = way * dmg_range(b, 0.1f, 0.25f);
    a.tube = d->r * dmg_range(b, 0.02f, 0.05f);
    if (d->kind == HOUSE_HORN) a.tube = d->r * dmg_range(b, 0.07f, 0.12f);
    /* By the law of cosines, to the label's edge. */
    a.in = at - acosf((way * way + a.length * a.length - r * r) / (2.0f * way * a.length));
    return a;
}

static void draw_head_shell(dmg_builder* b, const deck* d, const tonearm* a, float y) {
    float r = d->r, w = r * dmg_range(b, 0.06f, 0.13f), l = r * dmg_range(b, 0.12f, 0.25f);
    float low = d->high + 0.03f * r;
    dmg_save(b);
    dmg_move(b, 0, 0, a->length);
    dmg_turn(b, v3(0, 1, 0), -dmg_range(b, 0.0f, 0.5f));
    if (d->kind == HOUSE_HORN) { /* a sound box: an upright disc with its needle */
        float disc = 0.7f * (y - low) + 0.04f * r;
        dmg_rod(b, v3(-0.06f * r, y, 0), v3(0.06f * r, y, 0), disc);
        dmg_rod(b, v3(-0.07f * r, y, 0), v3(-0.07f * r, low, 0.3f * disc), 0.015f * r);
    } else {
        dmg_box(b, v3(0, y, 0), v3(w, 0.25f * w, l));
        dmg_box_span(b, v3(-0.35f * w, low, -0.2f * l), v3(0.35f * w, y, 0.4f * l));
        if (dmg_chance(b, 0.6f))
            dmg_beam(b, v3(0.4f * w, y, 0), v3(1.4f * w, y + 0.4f * w, 0.2f * l), 0.2f * w, 0.1f * w);
    }
    dmg_restore(b);
}

/* Straight, bent once, or an S. */
static void draw_tube(dmg_builder* b, const tonearm* a, float y) {
    enum { STEPS = 12 };
    int shape = dmg_int(b, 0, 2);
    float bow = a->length * dmg_range(b, 0.04f, 0.12f);
    dmg_vec path[STEPS + 1];
    for (int i = 0; i <= STEPS; ++i) {
        float s = (float)i / STEPS;
        float off = shape == 1 ? sinf(DMG_PI * s) : (shape == 2 ? 0.6f * sinf(2.0f * DMG_PI * s) : 0.0f);
        path[i] = v3(bow * off, y, s * a->length);
    }
    if (shape == 0)
        dmg_cone(b, path[0], path[STEPS], 1.2f * a->tube, a->tube);
    else
        dmg_sweep(b, path, STEPS + 1, a->tube, a->tube, false);
}

/* Draws the weight behind, in some screwed along its tail. */
static void draw_counterweight(dmg_builder* b, const deck* d, const tonearm* a, uint32_t arm, float y) {
    float r = d->r * dmg_range(b, 0.07f, 0.13f), l = a->tail * dmg_range(b, 0.4f, 0.7f);
    dmg_rod(b, v3(0, y, -a->tail), v3(0, y, 0), 0.8f * a->tube);
    if (dmg_chance(b, 0.3f)) {
        dmg_screw(b, arm, "counterweight", v3(0, y, 0), v3(0, 0, 1), 0.01f * d->r, -4.0f, 4.0f);
        dmg_rod(b, v3(0, y, -a->tail), v3(0, y, l - a->tail), r);
        dmg_use(b, arm);
    } else {
        dmg_rod(b, v3(0, y, -a->tail), v3(0, y, l - a->tail), r);
    }
}

static void draw_swinging_arm(dmg_builder* b, const deck* d) {
    tonearm a = pick_arm(b, d);
    float y = d->over, r = d->r, base = r * dmg_range(b, 0.09f, 0.16f), out = dmg_range(b, 0.0f, 0.15f);
    dmg_save(b);
    dmg_move(b, d->x + d->pivot, 0, d->z - d->back);
    dmg_rod(b, v3(0, 0, 0), v3(0, y - 1.5f * a.tube, 0), base);
    if (dmg_chance(b, 0.7f)) { /* the rest it is clipped to */
        float z = dmg_range(b, 0.35f, 0.75f) * a.length;
        dmg_rod(b, v3(0, 0, z), v3(0, y - 1.5f * a.tube, z), 0.03f * r);
        dmg_box(b, v3(0, y - 1.5f * a.tube, z), v3(0.12f * r, a.tube, 0.05f * r));
    }
    uint32_t arm = dmg_hinge(b, 0, "tonearm", v3(0, 0, 0), v3(0, -1, 0), -out, a.in);
    dmg_rest(b, arm, dmg_chance(b, 0.5f) ? 0.0f : a.in * dmg_range(b, 0.3f, 1.0f));
    dmg_keep_rest(b, arm);
    int gimbal = dmg_int(b, 0, 2);
    if (gimbal == 0) dmg_rod(b, v3(0, y - 1.5f * a.tube, 0), v3(0, y + 2.5f * a.tube, 0), 0.8f * base);
    if (gimbal == 1)
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.8f * base, y, 0), v3(0.25f * base, 4 * a.tube + 0.3f * base, 0.5f * base));
    if (gimbal != 1) dmg_rod(b, v3(0, y - 1.5f * a.tube, 0), v3(0, y, 0), 0.9f * base);
    if (dmg_chance(b, 0.55f)) /* the tube lifts by itself */
        arm = dmg_hinge(b, arm, "arm_lift", v3(0, y, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.1f, 0.5f));
    draw_tube(b, &a, y);
    if (gimbal == 1) dmg_rod(b, v3(-0.9f * base, y, 0), v3(0.9f * base, y, 0), 0.7f * a.tube);
    draw_head_shell(b, d, &a, y);
    if (d->kind != HOUSE_HORN) draw_counterweight(b, d, &a, arm, y);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Its look-alike: a short arm that runs straight in along a rail behind the platter. */
static void draw_rail_arm(dmg_builder* b, const deck* d) {
    float r = d->r, y = d->over, z = d->z - 1.02f * r, from = d->x + r * dmg_range(b, 0.9f, 1.15f);
    for (int i = 0; i < 2; ++i)
        dmg_rod(b, v3(d->x, y, z + 0.07f * r * (float)i), v3(from + 0.15f * r, y, z + 0.07f * r * (float)i), 0.02f * r);
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(i ? from + 0.15f * r : d->x - 0.05f * r, 0, z - 0.06f * r),
                     v3(i ? from + 0.25f * r : d->x + 0.05f * r, y + 0.05f * r, z + 0.13f * r));
    uint32_t arm = dmg_slide(b, 0, "tonearm", v3(-1, 0, 0), 0.0f, from - d->x - 0.3f * r);
    dmg_box(b, v3(from, y, z + 0.035f * r), v3(0.16f * r, 0.09f * r, 0.2f * r));
    if (dmg_chance(b, 0.4f)) dmg_hinge(b, arm, "arm_lift", v3(0, y, z + 0.1f * r), v3(-1, 0, 0), 0.0f, 0.3f);
    dmg_rod(b, v3(from, y, z), v3(from, y, d->z), 0.03f * r);
    dmg_box_span(b, v3(from - 0.05f * r, d->high + 0.03f * r, d->z - 0.1f * r),
                 v3(from + 0.05f * r, y + 0.02f * r, d->z + 0.1f * r));
    dmg_rest(b, arm, (from - d->x - 0.3f * r) * dmg_unit(b));
    dmg_use(b, 0);
}

/* ---- on the deck ---- */

static void draw_pitch_fader(dmg_builder* b, dmg_vec at, float way, float size) {
    dmg_box(b, at, v3(0.3f * size, 0.1f * size, way + size));
    uint32_t fader = dmg_slide(b, 0, "pitch", v3(0, 0, 1), -0.5f * way, 0.5f * way);
    dmg_box(b, v3_add(at, v3(0, 0.3f * size, 0)), v3(size, 0.6f * size, 0.5f * size));
    dmg_rest(b, fader, way * dmg_range(b, -0.4f, 0.4f));
    dmg_use(b, 0);
}

/* At the listener's edge: keys or knobs; to the right a fader and a lever that lowers the arm. */
static void draw_deck_controls(dmg_builder* b, const deck* d) {
    float r = d->r, s = r * dmg_range(b, 0.06f, 0.13f), z = d->deep - 1.2f * s, x = d->x - 0.85f * r;
    int start = dmg_int(b, 0, 2);
    dmg_save(b);
    dmg_move(b, x, 0, z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* up is the frame's +Z */
    dmg_buttons keys = {.name = "start", .columns = dmg_int(b, 1, 3), .rows = 1};
    keys.kind = dmg_int(b, 0, 3);
    keys.pitch_x = 2.2f * s;
    keys.width = 1.8f * s;
    keys.height = 1.6f * s;
    keys.rise = s * dmg_range(b, 0.15f, 0.6f);
    keys.travel = dmg_button_way(b, keys.rise);
    if (start == 0) dmg_buttons_draw(b, 0, &keys);
    if (start == 1) dmg_knobs_draw(b, 0, dmg_int(b, 1, 2), 2.5f * s, 0, s);
    dmg_restore(b);
    float edge = d->x + d->pivot, front = d->z + 0.95f * r;
    if (dmg_chance(b, 0.4f)) draw_pitch_fader(b, v3(edge + 0.1f * r, 0, front - 0.15f * r), 0.35f * r, 0.6f * s);
    if (dmg_chance(b, 0.45f)) { /* about a pin in two ears, swung over to lower the arm */
        float l = r * dmg_range(b, 0.12f, 0.25f), px = edge + 0.19f * r, pz = d->z - 0.1f * r, pin = 0.04f * r;
        dmg_box_span(b, v3(px - pin, 0, pz - pin), v3(px + pin, 1.5f * pin, pz + pin));
        dmg_hinge(b, 0, "cue_lever", v3(px, 1.5f * pin, pz), v3(1, 0, 0), -0.9f, 0.9f);
        dmg_rod(b, v3(px - 1.5f * pin, 1.5f * pin, pz), v3(px + 1.5f * pin, 1.5f * pin, pz), 0.6f * pin);
        dmg_rod(b, v3(px, 1.5f * pin, pz), v3(px, 1.5f * pin + l, pz), 0.4f * pin);
        dmg_ellipsoid(b, v3(px, 1.5f * pin + l, pz), v3(pin, pin, pin));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.15f)) { /* a lamp that pops up */
        dmg_slide(b, 0, "lamp", v3(0, 1, 0), 0.0f, 0.15f * r);
        dmg_rod(b, v3(d->x + 0.8f * r, -0.2f * r, front - 0.05f * r), v3(d->x + 0.8f * r, 0.05f * r, front - 0.05f * r),
                0.05f * r);
        dmg_use(b, 0);
    }
}

/* ---- lids: a shell open below, its rim at y = `at` ---- */

static uint32_t draw_shell_lid(dmg_builder* b, const deck* d, float at, float tall, float grow) {
    float x = d->wide + grow, z = d->deep + grow, wall = d->r * dmg_range(b, 0.015f, 0.05f);
    float off = dmg_range(b, 0.0f, 0.06f) * d->r, swing = dmg_range(b, 0.9f, 1.8f);
    dmg_case_kind kind = (dmg_case_kind)dmg_int(b, DMG_CASE_BOARDS, DMG_CASE_DOUBLE);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, at, -z - off), v3(-1, 0, 0), 0.0f, swing);
    dmg_save(b);
    dmg_move(b, 0, at, 0);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the case's opening down */
    dmg_case_draw(b, kind, 2 * x, 2 * z, tall, wall);
    dmg_restore(b);
    dmg_rest(b, lid, dmg_chance(b, 0.3f) ? 0.0f : swing * dmg_range(b, 0.4f, 1.0f));
    if (off > 0.01f * d->r) {
        for (int s = -1; s <= 1; s += 2) {
            float px = (float)s * 0.7f * x, w = 0.08f * d->r;
            dmg_use(b, lid);
            dmg_rod(b, v3(px - w, at, -z - off), v3(px + w, at, -z - off), 0.5f * off + 0.01f * d->r);
            dmg_use(b, 0);
            dmg_box_span(b, v3(px - 0.6f * w, at - 0.2f * d->r, -z - 2 * off),
                         v3(px + 0.6f * w, at, -z + 0.02f * d->r));
        }
    }
    dmg_use(b, 0);
    return lid;
}

/* ---- housings ---- */

static void draw_plinth(dmg_builder* b, const deck* d) {
    int kind = d->bare ? 3 : dmg_int(b, 0, 2);
    float w = 2 * d->wide, l = 2 * d->deep, h = d->box, t = 0.35f * h, r = d->r;
    if (kind == 0) dmg_box_span(b, v3(-d->wide, -h, -d->deep), v3(d->wide, 0, d->deep));
    if (kind == 1) dmg_rounded_box(b, v3(0, -0.5f * h, 0), v3(w, h, l), 0.2f * h);
    if (kind == 2) { /* two slabs on posts */
        dmg_box_span(b, v3(-d->wide, -t, -d->deep), v3(d->wide, 0, d->deep));
        dmg_box_span(b, v3(-d->wide, -h, -d->deep), v3(d->wide, t - h, d->deep));
        for (int i = 0; i < 4; ++i)
            dmg_rod(b, v3((i & 1 ? 0.85f : -0.85f) * d->wide, -h + 0.5f * t, (i & 2 ? 0.85f : -0.85f) * d->deep),
                    v3((i & 1 ? 0.85f : -0.85f) * d->wide, -0.5f * t, (i & 2 ? 0.85f : -0.85f) * d->deep), 0.1f * r);
    }
    if (kind == 3) { /* a bare frame: a disc under the platter, a beam to the arm */
        dmg_rod(b, v3(d->x, -t, d->z), v3(d->x, 0, d->z), 0.8f * r);
        dmg_box_span(b, v3(d->x, -t, d->z - 0.8f * r), v3(d->wide, 0, d->z + 0.2f * r));
        dmg_box_span(b, v3(-d->wide, -t, 0.8f * d->deep), v3(d->wide, 0, d->deep));
        dmg_box_span(b, v3(-0.1f * r, -t, d->z), v3(0.1f * r, -0.01f * r, d->deep));
    }
    float foot = r * dmg_range(b, 0.05f, 0.15f), drop = foot * dmg_range(b, 0.5f, 1.5f), low = kind == 3 ? -t : -h;
    bool screwed = dmg_chance(b, 0.2f);
    for (int i = 0; i < 4; ++i) {
        dmg_vec at = {(i & 1 ? 0.85f : -0.85f) * d->wide, low, 0.9f * d->deep * (i & 2 ? 1.0f : -1.0f)};
        if (kind == 3 && !(i & 2)) at = v3(i & 1 ? 0.85f * d->wide : d->x, low, d->z - 0.6f * r);
        if (screwed) dmg_screw(b, 0, "foot", at, v3(0, -1, 0), 0.02f * foot, 0.0f, 12.0f);
        dmg_cone(b, v3(at.x, at.y - drop, at.z), at, 0.8f * foot, foot);
        dmg_use(b, 0);
    }
    if (kind != 3 && dmg_chance(b, 0.7f)) draw_shell_lid(b, d, 0.0f, d->over + r * dmg_range(b, 0.1f, 0.3f), 0.0f);
}

/* Draws a lower half with the deck let in, the lid its other half; a handle and latches in front. */
static void draw_suitcase(dmg_builder* b, const deck* d) {
    float w = 2 * d->wide, l = 2 * d->deep, h = d->box + d->over, r = d->r, rim = d->over * dmg_range(b, 0.0f, 0.9f);
    float wall = 0.05f * r, grip = r * dmg_range(b, 0.5f, 0.9f), y = rim - 0.25f * h, z = d->deep + wall;
    dmg_save(b);
    dmg_move(b, 0, rim, 0);
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, w + 2 * wall, l + 2 * wall, h, wall);
    dmg_restore(b);
    dmg_box_span(b, v3(-d->wide, -0.1f * r, -d->deep), v3(d->wide, 0, d->deep));
    uint32_t lid = draw_shell_lid(b, d, rim, d->over - rim + r * dmg_range(b, 0.15f, 0.5f), wall);
    bool bow = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * 0.5f * grip, y, z), v3(0.08f * r, 0.12f * r, 0.12f * r));
    dmg_hinge(b, 0, "handle", v3(0, y, z + 0.05f * r), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.6f));
    const dmg_vec path[] = {
        v3(-0.5f * grip, y, z + 0.05f * r), v3((bow ? -0.4f : -0.5f) * grip, y - 0.3f * r, z + 0.06f * r),
        v3((bow ? 0.4f : 0.5f) * grip, y - 0.3f * r, z + 0.06f * r), v3(0.5f * grip, y, z + 0.05f * r)};
    dmg_sweep(b, path, 4, 0.04f * r, 0.04f * r, false);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) { /* latches: plates that swing up off the rim */
        float x = (float)s * 0.75f * d->wide, t = 0.04f * r;
        dmg_use(b, lid);
        dmg_box_span(b, v3(x - 0.05f * r, rim + 0.01f * r, z), v3(x + 0.05f * r, rim + 0.08f * r, z + t));
        dmg_use(b, 0);
        dmg_hinge(b, 0, "latch", v3(x, rim - 0.16f * r, z + 0.5f * t), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 2.4f));
        dmg_box_span(b, v3(x - 0.07f * r, rim - 0.16f * r, z), v3(x + 0.07f * r, rim - 0.02f * r, z + 0.8f * t));
        dmg_use(b, 0);
    }
}

/* Draws a piece of furniture: the deck sunk below its top's lid, on its front knobs, flaps or doors. */
static void draw_cabinet(dmg_builder* b, const deck* d) {
    float r = d->r, wall = 0.08f * r, rim = d->over + 0.08f * r, x = d->wide + wall, z = d->deep + wall, h = d->box,
          legs = r * dmg_range(b, 0.3f, 1.5f), side = dmg_chance(b, 0.5f) ? r * dmg_range(b, 0.8f, 2.5f) : 0.0f;
    dmg_box_span(b, v3(-x, -h, -z), v3(x + side, 0, z));
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * x - (s > 0) * wall, 0, -z), v3((float)s * x + (s < 0) * wall, rim, z));
        dmg_box_span(b, v3(-x, 0, (float)s * z - (s > 0) * wall), v3(x, rim, (float)s * z + (s < 0) * wall));
    }
    if (side > 0) dmg_box_span(b, v3(x, 0, -z), v3(x + side, rim, z));
    for (int i = 0; i < 4; ++i) {
        float px = i & 1 ? x + side - 0.15f * r : 0.15f * r - x, pz = (i & 2 ? 1.0f : -1.0f) * (z - 0.15f * r);
        dmg_cone(b, v3(px * 1.05f, -h - legs, pz * 1.05f), v3(px, -h, pz), 0.05f * r, 0.1f * r);
    }
    float swing = dmg_range(b, 0.9f, 1.7f), over = dmg_range(b, 0.0f, 0.1f) * r;
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, rim, -z), v3(-1, 0, 0), 0.0f, swing);
    dmg_box_span(b, v3(-x - over * (side == 0), rim, -z), v3(x + over * (side == 0), rim + wall, z + over));
    dmg_rest(b, lid, swing * dmg_range(b, 0.0f, 1.0f));
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0.5f * side, -0.25f * h, z);
    if (dmg_chance(b, 0.7f)) dmg_controls_draw(b, 0, 1.6f * x, 0.3f * h);
    dmg_move(b, 0, -0.45f * h, 0);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.8f * r);
    leaf.width = 1.5f * x;
    leaf.height = 0.5f * h;
    leaf.thickness = fminf(leaf.thickness, wall);
    leaf.side = (dmg_side)dmg_int(b, 0, 3);
    dmg_move(b, 0, 0, leaf.thickness);
    dmg_leaf_draw(b, 0, "flap", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a flower of tin on an elbow behind: it turns in its bracket. */
static void draw_horn(dmg_builder* b, const deck* d) {
    float r = d->r, tall = r * dmg_range(b, 0.5f, 1.2f), mouth = r * dmg_range(b, 0.6f, 1.3f),
          long_ = r * dmg_range(b, 1.2f, 2.4f), lift = dmg_range(b, 0.2f, 0.9f), neck = 0.1f * r, z = -d->deep - neck,
          turn = dmg_range(b, 0.4f, 1.6f);
    dmg_vec elbow = {d->x + d->pivot, d->over + tall, z};
    dmg_box_span(b, v3(elbow.x - neck, -0.4f * r, z - neck), v3(elbow.x + neck, -0.1f * r, -d->deep));
    dmg_rod(b, v3(elbow.x, -0.4f * r, z), v3(elbow.x, d->over, z), 1.15f * neck);
    if (dmg_chance(b, 0.5f))
        dmg_spin(b, 0, "horn", elbow, v3(0, 1, 0));
    else
        dmg_hinge(b, 0, "horn", elbow, v3(0, 1, 0), -turn, turn);
    dmg_rod(b, v3(elbow.x, d->over - 0.1f * r, z), elbow, 0.9f * neck);
    dmg_ellipsoid(b, elbow, v3(neck, neck, neck));
    dmg_vec way = v3_normalize(v3(-0.3f, sinf(lift), cosf(lift)));
    float lip = mouth * dmg_range(b, 0.02f, 0.06f);
    const dmg_xy flower[] = {{0.6f * neck, 0},
                             {0.9f * neck, 0},
                             {0.25f * mouth + neck, 0.5f * long_},
                             {0.6f * mouth, 0.85f * long_},
                             {mouth, long_},
                             {mouth - lip, long_ + 0.2f * lip},
                             {0.55f * mouth, 0.87f * long_},
                             {0.2f * mouth + neck, 0.52f * long_},
                             {0.6f * neck, 0}};
    dmg_lathe(b, elbow, way, flower, 9);
    dmg_use(b, 0);
}

static void draw_horn_box(dmg_builder* b, const deck* d) {
    float r = d->r, x = d->wide, z = d->deep, h = d->box, lip = r * dmg_range(b, 0.03f, 0.12f), t = 0.1f * r;
    dmg_box_span(b, v3(-x, -h, -z), v3(x, 0, z));
    dmg_box_span(b, v3(-x - lip, -h - t, -z - lip), v3(x + lip, -h, z + lip));
    bool horn = dmg_chance(b, 0.7f);
    if (horn) draw_horn(b, d);
    float y = -h * dmg_range(b, 0.3f, 0.6f), rod = 0.05f * r, reach = r * dmg_range(b, 0.3f, 0.6f), side = dmg_sign(b);
    dmg_spin(b, 0, "crank", v3(side * x, y, 0), v3(side, 0, 0));
    dmg_rod(b, v3(side * (x - 2 * rod), y, 0), v3(side * (x + 4 * rod), y, 0), rod);
    dmg_beam(b, v3(side * (x + 3.5f * rod), y, 0), v3(side * (x + 3.5f * rod), y, reach), 1.5f * rod, 2 * rod);
    dmg_rod(b, v3(side * (x + 3 * rod), y, reach), v3(side * (x + 0.3f * r), y, reach), 1.3f * rod);
    dmg_use(b, 0);
    if (horn) return;
    draw_shell_lid(b, d, 0.0f, d->over + r * dmg_range(b, 0.15f, 0.5f), 0.0f);
    dmg_save(b);
    dmg_move(b, 0, -0.5f * h, z);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * r);
    leaf.width = 0.75f * x;
    leaf.height = 0.7f * h;
    leaf.thickness = fminf(leaf.thickness, 0.1f * r);
    for (int s = -1; s <= 1; s += 2) { /* doors before the sound */
        dmg_save(b);
        dmg_move(b, (float)s * 0.5f * leaf.width, 0, leaf.thickness);
        leaf.side = s < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_record_player(dmg_builder* b) {
    deck d = pick_deck(b);
    dmg_move(b, 0, d.box + 0.1f * d.r, 0);
    if (d.kind == HOUSE_PLINTH) draw_plinth(b, &d);
    if (d.kind == HOUSE_CASE) draw_suitcase(b, &d);
    if (d.kind == HOUSE_CABINET) draw_cabinet(b, &d);
    if (d.kind == HOUSE_HORN) draw_horn_box(b, &d);
    draw_platter(b, &d);
    if (d.kind != HOUSE_HORN && dmg_chance(b, 0.15f))
        draw_rail_arm(b, &d);
    else
        draw_swinging_arm(b, &d);
    if (!d.bare && dmg_chance(b, 0.85f)) draw_deck_controls(b, &d);
}
