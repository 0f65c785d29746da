/* Draws robots for rough ground: tracks with flippers, rockers and bogies, wheels on legs and arms. They look to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- tracks ---- */

/* Round a wheel at `from` and one at `to`, both (z, y): counter-clockwise seen from -X. */
static void stadium_outline(dmg_xy from, float r0, dmg_xy to, float r1, int half, dmg_xy* out) {
    float heading = atan2f(to.y - from.y, to.x - from.x);
    for (int i = 0; i < 2 * half; ++i) {
        dmg_xy at = i < half ? to : from;
        float r = i < half ? r1 : r0, angle = heading - 0.5f * DMG_PI + DMG_PI * (float)(i % half) / (float)(half - 1) +
                                              (i < half ? 0.0f : DMG_PI);
        out[i] = (dmg_xy){at.x + r * cosf(angle), at.y + r * sinf(angle)};
    }
}

typedef struct track {
    int kind;  /* a solid, a belt with wheels in it, a belt round a plate, cleats on it */
    int wheel; /* kind of the wheels */
    bool turn; /* the wheels are parts */
} track;

static void draw_axle_wheel(dmg_builder* b, int kind, dmg_vec at, float radius, float width) {
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, kind, radius, width, 5);
    dmg_restore(b);
}

/* Draws a track about the wheels at `from` and `to`, (z, y), its middle at x = 0, `wide` across; onto `carrier`. */
static void draw_track(dmg_builder* b, const track* t, uint32_t carrier, dmg_xy from, float r0, dmg_xy to, float r1,
                       float wide) {
    enum { HALF = 5 };
    dmg_xy outer[2 * HALF], inner[2 * HALF];
    float belt = 0.15f * fminf(r0, r1);
    stadium_outline(from, r0, to, r1, HALF, outer);
    stadium_outline(from, r0 - belt, to, r1 - belt, HALF, inner);
    dmg_use(b, carrier);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    if (t->kind == 0) dmg_extrude(b, outer, 2 * HALF, -0.5f * wide, 0.5f * wide);
    if (t->kind > 0) dmg_ring_plate(b, outer, inner, 2 * HALF, -0.5f * wide, 0.5f * wide);
    if (t->kind == 2) dmg_extrude(b, inner, 2 * HALF, -0.3f * wide, 0.3f * wide);
    if (t->kind == 3)
        for (int i = 0; i < 2 * HALF; ++i) {
            dmg_vec low = {outer[i].x, outer[i].y, -0.5f * wide}, high = low;
            high.z = 0.5f * wide;
            dmg_beam(b, low, high, 1.2f * belt, 1.2f * belt);
        }
    dmg_restore(b);
    if (t->kind == 0 || t->kind == 2) {
        dmg_rod(b, v3(-0.55f * wide, from.y, from.x), v3(0.55f * wide, from.y, from.x), 0.5f * r0);
        if (dmg_chance(b, 0.5f)) dmg_rod(b, v3(-0.55f * wide, to.y, to.x), v3(0.55f * wide, to.y, to.x), 0.5f * r1);
        return;
    }
    int room = (int)(v3_length(v3(to.x - from.x, to.y - from.y, 0)) / (2.4f * fmaxf(r0, r1))),
        road = room < 3 ? room : 3;
    for (int i = 0; i <= road + 1; ++i) {
        float share = (float)i / (float)(road + 1), r = r0 + (r1 - r0) * share - 1.1f * belt;
        dmg_vec at = {0, from.y + (to.y - from.y) * share, from.x + (to.x - from.x) * share};
        if (t->turn) dmg_spin(b, carrier, "wheel", at, v3(1, 0, 0));
        draw_axle_wheel(b, t->wheel, at, r, 0.8f * wide);
        dmg_use(b, carrier);
    }
}

/* Draws an arm of two or three links from the deck, folded or raised, with two fingers or a camera. */
static void draw_deck_arm(dmg_builder* b, float size) {
    float t = size * dmg_range(b, 0.05f, 0.12f), lean = dmg_range(b, 0.2f, 2.6f);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.6f)) carrier = dmg_spin(b, 0, "turret", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 0, 0), v3(0, t, 0), 1.8f * t);
    dmg_vec at = {0, 1.5f * t, 0};
    for (int i = dmg_int(b, 2, 3); i > 0; --i) {
        dmg_vec to = v3_mad(at, v3(0, sinf(lean), -cosf(lean)), size * dmg_range(b, 0.35f, 0.7f));
        float open = dmg_range(b, 0.3f, 0.9f);
        carrier = dmg_hinge(b, carrier, "arm", at, v3(dmg_sign(b), 0, 0), -0.5f, open);
        dmg_rod(b, v3_add(at, v3(-t, 0, 0)), v3_add(at, v3(t, 0, 0)), 0.7f * t);
        dmg_beam(b, at, to, t, t);
        at = to;
        lean += dmg_range(b, 1.2f, 2.8f);
    }
    dmg_move(b, at.x, at.y, at.z);
    dmg_box(b, v3(0, 0, 0.3f * t), v3(2.5f * t, t, t));
    if (dmg_chance(b, 0.5f)) {
        dmg_box(b, v3(0, 0.2f * t, 1.2f * t), v3(1.6f * t, 1.4f * t, t));
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_hinge(b, carrier, "finger", v3((float)s * t, 0, 0.8f * t), v3(0, (float)s, 0), -0.3f, 0.7f);
        dmg_beam(b, v3((float)s * t, 0, 0.8f * t), v3((float)s * 0.6f * t, 0, 3.5f * t), 0.5f * t, t);
    }
}

/* Draws what is on the deck besides: a mast that folds, a scanner that spins, a lid. */
static void draw_deck(dmg_builder* b, float wide, float length) {
    if (dmg_chance(b, 0.5f)) {
        dmg_save(b);
        dmg_move(b, 0, 0, length * dmg_range(b, -0.2f, 0.25f));
        draw_deck_arm(b, length * dmg_range(b, 0.6f, 1.2f));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    float x = 0.3f * wide, z = -0.38f * length, s = 0.12f * length;
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) {
        dmg_hinge(b, 0, "mast", v3(x, 0.3f * s, z), v3(1, 0, 0), 0.0f, 1.5f);
        dmg_rod(b, v3(x, 0.3f * s, z), v3(x, 3 * s, z), 0.12f * s);
        dmg_box(b, v3(x, 3 * s, z), v3(s, 0.6f * s, 0.7f * s));
        dmg_use(b, 0);
        dmg_box(b, v3(x, 0.15f * s, z), v3(0.6f * s, 0.5f * s, 0.6f * s));
    }
    if (kind == 1) {
        dmg_rod(b, v3(0, 0, z), v3(0, 0.4f * s, z), 0.5f * s);
        dmg_spin(b, 0, "scanner", v3(0, 0, z), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.45f * s, z), v3(0, 1.2f * s, z), 0.55f * s);
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.8f * s, z + 0.5f * s), v3(0.5f * s, 0.4f * s, 0.3f * s));
    }
    if (kind == 2) {
        dmg_hinge(b, 0, "lid", v3(0, 0, z - s), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.9f));
        dmg_box(b, v3(0, 0.1f * s, z), v3(0.7f * wide, 0.2f * s, 2 * s));
    }
    dmg_use(b, 0);
}

static void draw_hull(dmg_builder* b, int kind, float wide, float high, float length) {
    if (kind == 0) dmg_box(b, v3(0, 0, 0), v3(wide, high, length));
    if (kind == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(wide, high, length), 0.3f * high);
    if (kind == 2) { /* wedges at both ends */
        const dmg_xy side[] = {{-0.42f * length, -0.5f * high}, {0.42f * length, -0.5f * high},
                               {0.52f * length, 0.1f * high},   {0.4f * length, 0.5f * high},
                               {-0.4f * length, 0.5f * high},   {-0.52f * length, 0.1f * high}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, side, 6, -0.5f * wide, 0.5f * wide);
        dmg_restore(b);
    }
}

/* Flippers at one end of the tracks or at both, outside them or between track and hull, single or on one axle. */
static void draw_flippers(dmg_builder* b, const track* style, float x, float wide, float half, float r, bool both) {
    float reach = half * dmg_range(b, 0.6f, 1.3f), tip = r * dmg_range(b, 0.3f, 0.7f),
          root = r * dmg_range(b, 0.6f, 0.98f), lean = dmg_range(b, -0.5f, 1.4f), swing = dmg_range(b, 0.6f, 1.5f);
    bool joined = dmg_chance(b, 0.25f), endless = dmg_chance(b, 0.5f);
    for (int e = 1; e >= (both ? -1 : 1); e -= 2) {
        float end = (float)e;
        dmg_xy hub = {end * half, r}, toe = {end * (half + reach * cosf(lean)), r + reach * sinf(lean)};
        uint32_t flipper = 0;
        for (int s = -1; s <= 1; s += 2) {
            if (s < 0 || !joined) {
                dmg_vec axle = {0, hub.y, hub.x};
                flipper = endless ? dmg_spin(b, 0, "flipper", axle, v3(dmg_sign(b), 0, 0))
                                  : dmg_hinge(b, 0, "flipper", axle, v3(dmg_sign(b), 0, 0), -swing, swing);
            }
            dmg_use(b, flipper);
            if (joined && s < 0) dmg_rod(b, v3(-x, hub.y, hub.x), v3(x, hub.y, hub.x), 0.2f * r);
            dmg_save(b);
            dmg_move(b, (float)s * x, 0, 0);
            draw_track(b, style, flipper, hub, root, toe, tip, wide);
            dmg_restore(b);
        }
        dmg_use(b, 0);
    }
}

void dmg_build_flipper_robot(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.2f, 2.5f), half = 0.5f * length, r = length * dmg_range(b, 0.09f, 0.22f),
          wide = length * dmg_range(b, 0.08f, 0.22f), hull = length * dmg_range(b, 0.25f, 0.6f),
          high = r * dmg_range(b, 0.8f, 1.7f), lift = dmg_chance(b, 0.3f) ? r * dmg_range(b, 0.3f, 1.0f) : 0.0f;
    track main = {dmg_int(b, 0, 3), 0, false}, small = main;
    main.wheel = small.wheel = dmg_int(b, 0, 2);
    main.turn = dmg_chance(b, 0.7f);
    if (dmg_chance(b, 0.5f)) small.kind = dmg_int(b, 0, 2);
    small.turn = main.turn && dmg_chance(b, 0.5f);
    bool inside = dmg_chance(b, 0.2f), wheels = dmg_chance(b, 0.2f);
    float thin = wide * dmg_range(b, 0.3f, 0.8f), near = 0.5f * hull + 0.55f * wide + (inside ? 1.2f * thin : 0.0f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * near, 0, 0);
        if (!wheels) draw_track(b, &main, 0, (dmg_xy){-half, r}, r, (dmg_xy){half, r + lift}, r, wide);
        for (int e = -1; e <= 1 && wheels; ++e) { /* three wheels a side instead */
            dmg_vec at = {0, r, (float)e * half};
            dmg_spin(b, 0, "wheel", at, v3(1, 0, 0));
            draw_axle_wheel(b, main.wheel, at, fminf(r, 0.48f * half), wide);
            dmg_use(b, 0);
        }
        dmg_restore(b);
    }
    if (wheels) lift = 0.0f;
    dmg_save(b);
    dmg_move(b, 0, r + 0.5f * lift, 0);
    float long_hull = length * dmg_range(b, 0.8f, 1.1f);
    draw_hull(b, dmg_int(b, 0, 2), hull, high, long_hull);
    if (inside || dmg_chance(b, 0.5f)) dmg_rod(b, v3(-near, 0, -0.5f * half), v3(near, 0, -0.5f * half), 0.3f * r);
    dmg_restore(b);
    float x = near + (inside ? -1.0f : 1.0f) * (0.56f * wide + 0.52f * thin);
    draw_flippers(b, &small, x, thin, half, r, lift == 0.0f && dmg_chance(b, 0.5f));
    dmg_move(b, 0, r + 0.5f * lift + 0.5f * high, 0);
    draw_deck(b, hull, long_hull);
}

/* ---- rovers ---- */

typedef struct rover {
    float half, radius, width, bar; /* half the wheelbase; of the wheels; thickness of bars */
    int wheel, link;
    bool steers;
} rover;

static void draw_bar(dmg_builder* b, int kind, dmg_vec from, dmg_vec to, float t) {
    if (kind == 0) dmg_rod(b, from, to, 0.5f * t);
    if (kind == 1) dmg_beam(b, from, to, t, t);
    if (kind == 2) dmg_beam(b, from, to, 0.4f * t, 1.8f * t);
    if (kind == 3) dmg_cone(b, from, to, 0.7f * t, 0.4f * t);
}

/* Draws a wheel below or beside `at` on a carrier; when it steers, on an upright with a fork's one leg. */
static void draw_rover_wheel(dmg_builder* b, const rover* r, uint32_t carrier, dmg_vec at, bool steers) {
    float t = r->bar, x = 0.5f * r->width + 0.8f * t;
    dmg_vec hub = v3_add(at, v3(x, 0, 0));
    if (steers) {
        float up = r->radius + 0.5f * t;
        carrier = dmg_hinge(b, carrier, "steering", v3_add(at, v3(x, up, 0)), v3(0, dmg_sign(b), 0), -0.8f, 0.8f);
        dmg_rod(b, v3_add(at, v3(x, up - 0.4f * t, 0)), v3_add(at, v3(x, up + 1.5f * t, 0)), 0.6f * t);
        dmg_beam(b, v3_add(at, v3(x, up, 0)), v3_add(at, v3(0, up, 0)), 0.7f * t, 0.7f * t);
        dmg_beam(b, v3_add(at, v3(0, up, 0)), at, 0.7f * t, 0.5f * t);
    }
    dmg_spin(b, carrier, "wheel", hub, v3(1, 0, 0));
    dmg_rod(b, at, hub, 0.3f * t);
    draw_axle_wheel(b, r->wheel, hub, r->radius, r->width);
    dmg_use(b, 0);
}

/* Draws one side of a rocker-bogie: the rocker turns at the body, the bogie at the rocker's end. Out is +X. */
static void draw_rocker_bogie(dmg_builder* b, const rover* r, float pivot) {
    float t = r->bar, side = dmg_sign(b), axle = r->radius - pivot, up = r->steers ? r->radius + 1.5f * t : 0.0f;
    dmg_vec front = {0.5f * t, axle + up, side * r->half}, joint = {0.5f * t, 0.45f * axle, -side * 0.45f * r->half};
    uint32_t rocker = dmg_hinge(b, 0, "rocker", v3(0, 0, 0), v3(dmg_sign(b), 0, 0), -0.35f, 0.35f);
    dmg_rod(b, v3(-0.5f * t, 0, 0), v3(1.2f * t, 0, 0), t);
    dmg_vec knee = {0.5f * t, 0.0f, side * 0.6f * r->half};
    draw_bar(b, r->link, v3(0.5f * t, 0, 0), knee, t);
    draw_bar(b, r->link, knee, front, t);
    draw_bar(b, r->link, v3(0.5f * t, 0, 0), joint, t);
    draw_rover_wheel(b, r, rocker, v3(0.5f * t, axle, front.z), r->steers);
    uint32_t bogie = dmg_hinge(b, rocker, "bogie", joint, v3(dmg_sign(b), 0, 0), -0.4f, 0.4f);
    dmg_rod(b, v3_add(joint, v3(-t, 0, 0)), v3_add(joint, v3(t, 0, 0)), 0.7f * t);
    const float ends[] = {0.0f, -side * r->half};
    for (int i = 0; i < 2; ++i) {
        bool steers = i == 1 && r->steers;
        dmg_use(b, bogie);
        draw_bar(b, r->link, joint, v3(0.5f * t, axle + (steers ? up : 0), ends[i]), 0.9f * t);
        draw_rover_wheel(b, r, bogie, v3(0.5f * t, axle, ends[i]), steers);
    }
}

/* Draws an arm with a wheel at its end, straight or with a knee; the wheel may be a star of legs. Out is +X. */
static void draw_wheel_arm(dmg_builder* b, const rover* r, float pivot, float lean, bool knee, float swing) {
    float t = r->bar, drop = pivot - r->radius, first = knee ? 0.6f : 1.0f;
    dmg_vec hip = {0.7f * t, 0, 0}, foot = {0.7f * t, -drop, drop * tanf(lean)},
            elbow = {0.7f * t, -first * drop, first * foot.z - (knee ? 0.5f * drop : 0.0f)};
    uint32_t arm = dmg_hinge(b, 0, knee ? "thigh" : "arm", hip, v3(dmg_sign(b), 0, 0), -swing, swing);
    dmg_rod(b, v3(0, 0, 0), v3(1.4f * t, 0, 0), 1.1f * t);
    draw_bar(b, r->link, hip, knee ? elbow : foot, t);
    if (knee) {
        arm = dmg_hinge(b, arm, "shank", elbow, v3(dmg_sign(b), 0, 0), -0.6f, 0.6f);
        dmg_rod(b, v3_add(elbow, v3(-0.6f * t, 0, 0)), v3_add(elbow, v3(0.8f * t, 0, 0)), 0.8f * t);
        draw_bar(b, r->link, elbow, foot, 0.9f * t);
    }
    draw_rover_wheel(b, r, arm, foot, false);
}

/* Draws three to six bent legs instead of a wheel. */
static void draw_wheg(dmg_builder* b, const rover* r) {
    int legs = dmg_int(b, 1, 5);
    float t = r->bar;
    dmg_spin(b, 0, "leg", v3(0, 0, 0), v3(1, 0, 0));
    dmg_rod(b, v3(0, 0, 0), v3(2 * t, 0, 0), 1.2f * t);
    for (int i = 0; i < legs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(1, 0, 0), i, legs);
        dmg_vec knee = {1.5f * t, -0.6f * r->radius, 0}, foot = {1.5f * t, -0.97f * r->radius, 0.3f * r->radius};
        dmg_beam(b, v3(1.5f * t, 0, 0), knee, t, 0.8f * t);
        dmg_beam(b, knee, foot, t, 0.8f * t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_rover(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.2f, 2.5f), hull = length * dmg_range(b, 0.3f, 0.6f),
          high = length * dmg_range(b, 0.08f, 0.3f);
    rover r = {.half = 0.5f * length, .radius = length * dmg_range(b, 0.09f, 0.18f)};
    r.wheel = dmg_int(b, 0, DMG_WHEEL_KINDS - 2);
    r.width = r.radius * dmg_range(b, 0.3f, 1.0f);
    r.bar = length * dmg_range(b, 0.025f, 0.06f);
    r.link = dmg_int(b, 0, 3);
    r.steers = dmg_chance(b, 0.5f);
    int kind = dmg_int(b, 0, 3), pairs = kind == 1 || kind == 3 ? dmg_int(b, 2, 3) : dmg_int(b, 1, 2);
    bool knee = kind == 2;
    float pivot = r.radius * (knee ? dmg_range(b, 2.5f, 5.0f) : dmg_range(b, 1.7f, 3.2f)),
          lean = dmg_range(b, -0.7f, 0.7f), swing = dmg_range(b, 0.3f, 0.9f);
    if (kind == 1) lean = lean < 0 ? -dmg_range(b, 0.3f, 0.9f) : dmg_range(b, 0.3f, 0.9f);
    if (kind == 3) pivot = r.radius *= 1.4f;
    dmg_save(b);
    dmg_move(b, 0, pivot + 0.3f * high, 0);
    float long_hull = length * dmg_range(b, 0.6f, 1.1f);
    draw_hull(b, dmg_int(b, 0, 2), hull, high, long_hull);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < (kind == 0 ? 1 : pairs); ++i) {
            float z = kind == 0 || pairs == 1 ? 0.0f : 0.8f * r.half * (2.0f * (float)i / (float)(pairs - 1) - 1.0f);
            dmg_save(b);
            if (s < 0) dmg_mirror(b, v3(1, 0, 0));
            dmg_move(b, 0.5f * hull, pivot, z);
            if (kind == 0) draw_rocker_bogie(b, &r, pivot);
            if (kind == 1 || kind == 2) draw_wheel_arm(b, &r, pivot, z > 0 ? -lean : lean, knee, swing);
            if (kind == 3) draw_wheg(b, &r);
            dmg_restore(b);
        }
    dmg_move(b, 0, pivot + 0.8f * high, 0);
    draw_deck(b, hull, long_hull);
}
