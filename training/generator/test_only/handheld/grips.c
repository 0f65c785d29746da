/* Draws controls held in one hand, as bent shells: a tilted face on a grip with a hoop for the cameras, pebbles and
 * wands with a touch disc, aircraft sticks on a gimballed base, gun-shaped controllers. Forward is +Z. */
#include "core/build.h"
#include "core/lofts.h"
#include "parts/hardware.h"
#include "parts/thumbs.h"

static const float AHEAD = 0.5f * DMG_PI; /* the angle round an upright grip */

/* ---- what several have ---- */

/* A bowl whose face, z = 0 of the frame, is flat; +Y away from the player. */
static dmg_bent face_shell(dmg_builder* b, float r, float deep) {
    float oval = dmg_range(b, 0.75f, 1.2f), lip = dmg_range(b, 0.8f, 1.05f);
    dmg_bent n = dmg_bent_between(v3(0, 0, -deep), v3(0, 0, 0), v3(0, 0, 0), v3(-1, 0, 0), r, r * oval);
    n.wide[0] = n.deep[0] = r * dmg_range(b, 0.4f, 0.8f);
    n.wide[2] *= lip;
    n.deep[2] *= lip;
    n.power = dmg_scale_range(b, 2.0f, 4.0f);
    n.egg = dmg_range(b, -0.15f, 0.2f);
    n.round[0] = dmg_range(b, 0.3f, 0.7f);
    n.round[1] = dmg_chance(b, 0.5f) ? 0.0f : 0.1f;
    return n;
}

/* A finger's lever out of an opening of the shell; the opening is made before the shell is drawn. */
static void open_for_lever(dmg_bent* n, float s, float angle, float wide, float around) {
    dmg_bent_open(n, s, angle, 0.35f, 2 * wide / around, 0.35f * around);
}

static void place_lever(dmg_builder* b, const dmg_bent* n, uint32_t parent, const char* name, float s, float angle,
                        float wide, float length) {
    float yaw = dmg_range(b, -0.15f, 0.15f), lean = dmg_range(b, -0.15f, 0.3f);
    dmg_bent_stand(b, n, s, angle, 0);
    dmg_turn(b, v3(0, 0, 1), yaw);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_finger_lever_draw(b, parent, name, wide, length);
    dmg_restore(b);
}

static dmg_key_motion pick_squeeze(dmg_builder* b) {
    return (dmg_key_motion)dmg_weighted(b, (const float[]){1, 2, 2, 0.4f, 0.3f}, 5);
}

/* Keys round a stick, a hat or a pad on a face of radius r. */
static void draw_thumb_face(dmg_builder* b, uint32_t parent, float r, int lead) {
    float turn = dmg_range(b, 0, 2 * DMG_PI), off = r * dmg_range(b, 0.25f, 0.42f),
          small = r * dmg_range(b, 0.11f, 0.17f), step = dmg_range(b, 0.75f, 1.0f);
    int keys = dmg_int(b, 1, 3);
    dmg_save(b);
    dmg_move(b, off * cosf(turn), off * sinf(turn), 0);
    if (lead == 0) dmg_thumb_stick_draw(b, parent, 0.26f * r);
    if (lead == 1) dmg_hat_draw(b, parent, "hat", 0.3f * r);
    if (lead == 2) dmg_touch_pad_draw(b, parent, 0.38f * r);
    dmg_restore(b);
    for (int i = 0; i < keys; ++i) {
        float angle = turn + DMG_PI + step * ((float)i - 0.5f * (float)(keys - 1));
        dmg_save(b);
        dmg_move(b, 0.6f * r * cosf(angle), 0.6f * r * sinf(angle), 0);
        dmg_thumb_key_draw(b, parent, i == 2 ? "menu" : "key", small);
        dmg_restore(b);
    }
}

/* ---- a face on a grip, a hoop ---- */

/* In the face's frame: from its far edge up and over the thumb, or round it on spokes. */
static void draw_hoop(dmg_builder* b, float r, float deep) {
    float radius = r * dmg_range(b, 1.5f, 2.4f), oval = dmg_range(b, 0.85f, 1.2f), wide = r * dmg_range(b, 0.08f, 0.2f),
          high = r * dmg_range(b, 0.1f, 0.4f), lean = dmg_range(b, -0.7f, 0.7f), swell = dmg_range(b, -0.3f, 0.3f);
    if (dmg_chance(b, 0.5f)) {
        float rise = dmg_range(b, 0.35f, 2.1f);
        dmg_vec edge = v3(0, 0.95f * r, -0.35f * deep), way = v3(0, cosf(rise), sinf(rise));
        dmg_aim(b, v3_mad(edge, way, radius), way, v3(0, -sinf(rise), cosf(rise)));
        dmg_hoop_draw(b, radius * oval, radius, wide, high, lean, swell);
        dmg_restore(b);
        return;
    }
    float low = -deep * dmg_range(b, 0.2f, 0.9f), ahead = r * dmg_range(b, 0.0f, 0.6f), tip = dmg_range(b, -0.3f, 0.3f);
    int spokes = dmg_int(b, 2, 3);
    float first = spokes == 2 ? 0.0f : -0.5f * DMG_PI;
    radius = r * dmg_range(b, 2.0f, 2.6f);
    for (int i = 0; i < spokes; ++i) {
        float angle = first + 2 * DMG_PI * (float)i / (float)spokes;
        dmg_vec rim =
            v3(radius * cosf(angle), ahead + radius * sinf(angle) * cosf(tip), low + radius * sinf(angle) * sinf(tip));
        dmg_beam(b, v3(0.7f * r * cosf(angle), 0.7f * r * sinf(angle), -0.4f * deep), rim, 0.3f * r, 0.15f * r);
    }
    dmg_aim(b, v3(0, ahead, low), v3(0, cosf(tip), sinf(tip)), v3(0, -sinf(tip), cosf(tip)));
    dmg_hoop_draw(b, radius, radius, wide, high, lean, swell);
    dmg_restore(b);
}

/* Draws the handle from its lower end up to the face at the origin. */
static void draw_grip(dmg_builder* b, float length, float r) {
    float droop = dmg_range(b, 0.1f, 0.9f), lean = dmg_range(b, -0.15f, 0.15f) * length,
          bow = length * dmg_range(b, -0.2f, 0.12f), wide = r * dmg_range(b, 0.5f, 0.8f),
          deep = wide * dmg_range(b, 0.9f, 1.4f);
    dmg_bent n = dmg_bent_between(v3(lean, -length * cosf(droop), -length * sinf(droop)), v3(0, -0.33f * r, 0),
                                  v3(0, 0, bow), v3(1, 0, 0), wide, deep);
    n.wide[1] *= dmg_range(b, 0.75f, 1.1f);
    n.deep[1] *= dmg_range(b, 0.75f, 1.2f);
    n.power = dmg_range(b, 2.0f, 3.0f);
    n.egg = dmg_range(b, -0.2f, 0.3f);
    n.twist = dmg_range(b, -0.5f, 0.5f);
    int keys = dmg_weighted(b, (const float[]){0, 3, 1}, 3);
    dmg_window w[2];
    dmg_key_motion motion = pick_squeeze(b);
    float aside = dmg_range(b, -1.0f, 1.0f), s = dmg_range(b, 0.4f, 0.62f), arc = dmg_range(b, 0.8f, 1.4f),
          long_way = dmg_range(b, 0.2f, 0.36f), well = 0.45f * wide;
    for (int i = 0; i < keys; ++i)
        w[i] = dmg_bent_open(&n, s, i ? AHEAD + DMG_PI + aside : AHEAD + aside, long_way, arc, well);
    dmg_bent_draw(b, &n);
    for (int i = 0; i < keys; ++i) dmg_bent_key_draw(b, &n, &w[i], 0, i ? "thumb_key" : "grip_key", motion);
}

void dmg_build_ring_controller(dmg_builder* b) {
    float length = dmg_range(b, 0.08f, 0.12f), r = length * dmg_range(b, 0.22f, 0.32f), tilt = dmg_range(b, 0.1f, 0.9f),
          roll = dmg_range(b, -0.3f, 0.3f), deep = r * dmg_range(b, 0.6f, 1.3f);
    bool left = dmg_chance(b, 0.5f), hoop = dmg_chance(b, 0.85f);
    int lead = dmg_weighted(b, (const float[]){3, 1, 1}, 3);
    float whole = dmg_range(b, -0.5f, 0.9f), wide = r * dmg_range(b, 0.5f, 0.9f), reach = r * dmg_range(b, 0.7f, 1.2f),
          at = dmg_range(b, 0.4f, 0.65f);
    if (left) dmg_mirror(b, v3(1, 0, 0));
    dmg_move(b, 0, 1.3f * length, 0);
    dmg_turn(b, v3(1, 0, 0), whole);
    dmg_turn(b, v3(0, 0, 1), roll);
    draw_grip(b, length, r);
    dmg_aim(b, v3(0, 0.6f * deep, 0.3f * r), v3(0, cosf(tilt), -sinf(tilt)), v3(0, 0, 1));
    dmg_bent head = face_shell(b, r, deep);
    open_for_lever(&head, at, AHEAD, wide, r);
    dmg_bent_draw(b, &head);
    place_lever(b, &head, 0, "trigger", at + 0.12f, AHEAD, wide, reach);
    draw_thumb_face(b, 0, 0.9f * r, lead);
    if (hoop) draw_hoop(b, r, deep);
    dmg_restore(b);
}

/* ---- pebbles, pucks, wands ---- */

/* Lying: the player behind, the top at AHEAD. */
static dmg_bent pick_pebble(dmg_builder* b, float* length) {
    int kind = dmg_int(b, 0, 2);
    float l = kind == 2 ? dmg_range(b, 0.11f, 0.18f) : dmg_range(b, 0.06f, 0.1f);
    float wide = l * (kind == 2 ? dmg_range(b, 0.1f, 0.15f) : dmg_range(b, 0.28f, 0.5f)),
          thick = kind == 2 ? wide * dmg_range(b, 0.5f, 1.0f) : l * dmg_range(b, 0.12f, 0.22f),
          bow = l * dmg_range(b, -0.08f, 0.12f);
    dmg_bent n = dmg_bent_between(v3(0, 0, -0.5f * l), v3(0, 0, 0.5f * l), v3(0, bow, 0), v3(-1, 0, 0), wide, thick);
    n.wide[0] *= dmg_range(b, 0.7f, 1.1f);
    n.wide[2] *= dmg_range(b, 0.7f, 1.2f);
    n.deep[0] *= dmg_range(b, 0.5f, 1.0f);
    n.deep[2] *= dmg_range(b, 0.6f, 1.1f);
    n.power = dmg_scale_range(b, 2.0f, 4.0f);
    n.round[0] = kind == 2 ? dmg_range(b, 0.05f, 0.15f) : dmg_range(b, 0.3f, 0.5f);
    n.round[1] = kind == 2 ? dmg_range(b, 0.05f, 0.2f) : dmg_range(b, 0.3f, 0.5f);
    n.rows = 30;
    n.columns = 28;
    *length = l;
    return n;
}

/* Draws a small grip in a slot that slides along the shell. */
static void draw_slide_switch(dmg_builder* b, const dmg_bent* n, float s, float angle, float size) {
    dmg_bent_stand(b, n, s, angle, 0);
    dmg_frame_draw(b, 0.8f * size, 2 * size, 0.2f * size, 0.08f * size);
    dmg_slide(b, 0, "slide_switch", v3(0, 1, 0), 0.0f, 0.7f * size);
    dmg_rounded_box(b, v3(0, -0.4f * size, 0.1f * size), v3(0.55f * size, 0.8f * size, 0.5f * size), 0.1f * size);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_loop(dmg_builder* b, const dmg_bent* n, float size) {
    dmg_bent_stand(b, n, 0.0f, 0, 0);
    dmg_restore(b);
    dmg_torus(b, v3_add(n->control[0], v3(0, 0, -0.2f * size)), v3(1, 0, 0), 0.5f * size, 0.12f * size);
}

void dmg_build_puck_controller(dmg_builder* b) {
    float length, pitch = dmg_range(b, -0.9f, 0.9f), roll = dmg_range(b, -0.6f, 0.6f);
    dmg_move(b, 0, 0.1f, 0);
    dmg_turn(b, v3(1, 0, 0), pitch);
    dmg_turn(b, v3(0, 0, 1), roll);
    dmg_bent n = pick_pebble(b, &length);
    float thick = n.deep[1], wide = n.wide[1], far = dmg_range(b, 0.64f, 0.74f), near = dmg_range(b, 0.3f, 0.46f),
          pull = wide * dmg_range(b, 0.5f, 0.9f), reach = fminf(0.3f * length, thick * dmg_range(b, 1.0f, 2.2f));
    int rockers = dmg_int(b, 0, 2), lead = dmg_int(b, 0, 2);
    bool trigger = dmg_chance(b, 0.75f), flank = dmg_chance(b, 0.4f), slide = dmg_chance(b, 0.3f),
         loop = dmg_chance(b, 0.4f);
    dmg_window keys[2] = {0}, side = {0}, disc = {0};
    dmg_key_motion tips = dmg_chance(b, 0.5f) ? DMG_KEY_ROCK : DMG_KEY_ROCK_ASIDE,
                   press = dmg_chance(b, 0.5f) ? DMG_KEY_ROCK : DMG_KEY_LAST;
    if (lead == 0) disc = dmg_bent_open(&n, far, AHEAD, fminf(0.25f, 1.5f * wide / length), 1.5f, 0.4f * thick);
    for (int i = 0; i < rockers; ++i)
        keys[i] = dmg_bent_open(&n, near, rockers == 1 ? AHEAD : AHEAD + (i ? 0.45f : -0.45f), 0.22f,
                                rockers == 1 ? 1.0f : 0.7f, 0.4f * thick);
    if (flank) side = dmg_bent_open(&n, 0.55f, 0, 0.2f, 0.6f, 0.3f * thick);
    if (trigger) open_for_lever(&n, 0.6f, AHEAD + DMG_PI, 0.8f * pull, 1.3f * thick);
    dmg_bent_draw(b, &n);
    if (lead == 0) dmg_bent_key_draw(b, &n, &disc, 0, "touch_disc", tips);
    if (lead > 0) {
        dmg_bent_stand(b, &n, far, AHEAD, 0);
        if (lead == 1) dmg_touch_pad_draw(b, 0, 0.55f * wide);
        if (lead == 2) dmg_hat_draw(b, 0, "hat", 0.45f * wide);
        dmg_restore(b);
    }
    for (int i = 0; i < rockers; ++i) dmg_bent_key_draw(b, &n, &keys[i], 0, "rocker", press);
    if (flank) dmg_bent_key_draw(b, &n, &side, 0, "volume", DMG_KEY_ROCK);
    if (trigger) place_lever(b, &n, 0, "trigger", 0.66f, AHEAD + DMG_PI, pull, reach);
    if (slide) draw_slide_switch(b, &n, 0.5f, DMG_PI, 0.35f * thick);
    if (loop) draw_loop(b, &n, 0.4f * thick);
}

/* ---- a stick for flying ---- */

/* Draws the base, and on it what does not belong to the stick; returns its height. */
static float draw_stick_base(dmg_builder* b, float size) {
    float r = size * dmg_range(b, 0.4f, 0.6f), high = size * dmg_range(b, 0.15f, 0.4f),
          slope = dmg_range(b, 0.6f, 0.95f);
    int kind = dmg_int(b, 0, 2), buttons = dmg_int(b, 0, 4);
    bool lever = dmg_chance(b, 0.6f);
    if (kind == 0) dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), r, slope * r);
    if (kind == 1) dmg_rounded_box(b, v3(0, 0.5f * high, 0), v3(1.8f * r, high, 2 * r), 0.25f * high);
    if (kind == 2) {
        dmg_bent n = dmg_bent_between(v3(0, 0, 0), v3(0, high, 0), v3(0, 0, 0), v3(1, 0, 0), 1.1f * r, 1.2f * r);
        n.wide[2] = n.deep[2] = 0.8f * r;
        n.power = 3;
        n.round[0] = 0;
        n.round[1] = 0.15f;
        dmg_bent_draw(b, &n);
    }
    for (int i = 0; i < buttons; ++i) {
        float turn = 0.25f * DMG_PI + 0.5f * DMG_PI * (float)i;
        dmg_aim(b, v3(0.68f * slope * r * cosf(turn), high, 0.68f * slope * r * sinf(turn)), v3(0, 1, 0), v3(0, 0, 1));
        dmg_thumb_key_draw(b, 0, "base_button", 0.1f * r);
        dmg_restore(b);
    }
    if (lever) { /* a throttle at the rear, its shaft in the base */
        dmg_aim(b, v3(0, 0.9f * high, -0.72f * r), v3(0, 1, 0), v3(1, 0, 0));
        dmg_hinge(b, 0, "throttle", v3(0, 0, -0.4f * high), v3(1, 0, 0), -0.5f, 0.5f);
        dmg_box_span(b, v3(-0.08f * r, -0.06f * r, -0.1f * high), v3(0.08f * r, 0.06f * r, 0.3f * r));
        dmg_ellipsoid(b, v3(0, 0, 0.32f * r), v3(0.2f * r, 0.1f * r, 0.08f * r));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    return high;
}

/* Draws what fingers find on the grip `n`, which is on `part`; r: of the head, whose frame is in use. */
static void draw_stick_head(dmg_builder* b, uint32_t part, float r) {
    dmg_save(b);
    dmg_move(b, 0, 0.35f * r, 0);
    if (dmg_chance(b, 0.8f)) dmg_hat_draw(b, part, "hat", 0.28f * r);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * 0.5f * r, -0.25f * r, 0);
        int kind = dmg_int(b, 0, 3);
        if (kind == 0) dmg_guarded_draw(b, part, 0.3f * r);
        if (kind == 1) dmg_thumb_key_draw(b, part, "button", 0.2f * r);
        if (kind == 2) dmg_sunk_wheel_draw(b, part, "thumb_wheel", 0.25f * r, 0.2f * r);
        if (kind == 3) dmg_hat_draw(b, part, "hat", 0.2f * r);
        dmg_restore(b);
    }
}

static void draw_stick_grip(dmg_builder* b, uint32_t part, float length) {
    float wide = length * dmg_range(b, 0.11f, 0.15f), deep = wide * dmg_range(b, 1.1f, 1.5f),
          bow = length * dmg_range(b, -0.15f, 0.1f), ahead = length * dmg_range(b, 0.0f, 0.25f),
          aside = length * dmg_range(b, -0.08f, 0.08f);
    dmg_bent n = dmg_bent_between(v3(0, 0, 0), v3(aside, length, ahead), v3(0, 0, bow), v3(1, 0, 0), wide, deep);
    n.wide[1] *= dmg_range(b, 0.75f, 1.0f);
    n.deep[1] *= dmg_range(b, 0.75f, 1.1f);
    n.egg = dmg_range(b, 0.0f, 0.3f);
    n.twist = dmg_range(b, -0.3f, 0.3f);
    n.rows = 26;
    bool pinkie = dmg_chance(b, 0.6f), thumb = dmg_chance(b, 0.4f), second = dmg_chance(b, 0.4f);
    float pull = wide * dmg_range(b, 0.7f, 1.0f), at = dmg_range(b, 0.74f, 0.8f), r = wide * dmg_range(b, 1.3f, 1.7f),
          tilt = dmg_range(b, 0.5f, 1.1f), low = dmg_range(b, 0.28f, 0.36f);
    dmg_window side = {0};
    open_for_lever(&n, at - 0.08f, AHEAD, 0.7f * pull, 1.3f * wide);
    if (pinkie) open_for_lever(&n, low, AHEAD, 0.5f * pull, 1.3f * wide);
    if (thumb) side = dmg_bent_open(&n, 0.72f, DMG_PI, 0.12f, 0.8f, 0.3f * wide);
    dmg_bent_draw(b, &n);
    dmg_save(b); /* the head, its face to the pilot */
    dmg_aim(b, v3(aside, length, ahead - 0.4f * r), v3(0, cosf(tilt), -sinf(tilt)), v3(0, 1, 0));
    dmg_bent head = face_shell(b, r, 1.2f * r);
    dmg_bent_draw(b, &head);
    draw_stick_head(b, part, r);
    dmg_restore(b);
    dmg_restore(b);
    place_lever(b, &n, part, "trigger", at, AHEAD, pull, 0.17f * length);
    if (second) place_lever(b, &n, part, "second_trigger", at - 0.19f, AHEAD, 0.8f * pull, 0.12f * length);
    if (pinkie) place_lever(b, &n, part, "pinkie_lever", low, AHEAD, pull, 0.2f * length);
    if (thumb) dmg_bent_key_draw(b, &n, &side, part, "thumb_key", DMG_KEY_ROCK);
}

void dmg_build_flight_stick(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.15f, 0.25f), high = draw_stick_base(b, size),
          length = size * dmg_range(b, 0.75f, 1.1f), ball = size * dmg_range(b, 0.12f, 0.18f),
          neck = size * dmg_range(b, 0.08f, 0.2f), swing = dmg_range(b, 0.15f, 0.35f), lean = dmg_range(b, -0.2f, 0.2f);
    bool twists = dmg_chance(b, 0.5f), boot = dmg_chance(b, 0.5f);
    dmg_vec pivot = v3(0, high + 0.1f * ball, 0);
    const dmg_xy collar[] = {{1.6f * ball, 0}, {1.5f * ball, 0.25f * ball}, {1.2f * ball, 0.3f * ball}};
    dmg_lathe(b, v3(0, high, 0), v3(0, 1, 0), collar, 3);
    uint32_t ring = dmg_hinge(b, 0, "pitch_ring", pivot, v3(1, 0, 0), -swing, swing);
    dmg_torus(b, v3(0, high + 0.35f * ball, 0), v3(0, 1, 0), 1.0f * ball, 0.12f * ball);
    dmg_rod(b, v3(-ball, pivot.y, 0), v3(ball, pivot.y, 0), 0.1f * ball);
    uint32_t stick = dmg_hinge(b, ring, "stick", pivot, v3(0, 0, 1), -swing, swing);
    dmg_ellipsoid(b, pivot, v3(0.8f * ball, 0.8f * ball, 0.8f * ball));
    dmg_move(b, 0, pivot.y, 0);
    dmg_turn(b, v3(1, 0, 0), lean);
    dmg_rod(b, v3(0, 0, 0), v3(0, ball + neck, 0), 0.35f * ball);
    if (boot)
        for (int i = 0; i < 3; ++i)
            dmg_torus(b, v3(0, ball * (0.75f + 0.25f * (float)i), 0), v3(0, 1, 0), ball * (0.6f - 0.1f * (float)i),
                      0.13f * ball);
    dmg_move(b, 0, 0.7f * ball + neck, 0);
    uint32_t grip = twists ? dmg_hinge(b, stick, "grip", v3(0, 0, 0), v3(0, 1, 0), -0.4f, 0.4f) : stick;
    draw_stick_grip(b, grip, length);
}

/* ---- a gun ---- */

/* The slide over the frame, the hammer behind it; top: where the frame's upper side is. */
static void draw_gun_top(dmg_builder* b, float length, float half, float top, bool hammer) {
    float high = half * dmg_range(b, 0.6f, 1.2f), way = length * dmg_range(b, 0.1f, 0.25f), front = 0.5f * length;
    bool slides = dmg_chance(b, 0.7f);
    dmg_bent n = dmg_bent_between(v3(0, top + high, -0.42f * length), v3(0, top + high, front), v3(0, 0, 0),
                                  v3(-1, 0, 0), 0.85f * half, high);
    n.power = dmg_range(b, 2.5f, 6.0f);
    n.deep[2] *= dmg_range(b, 0.6f, 1.0f);
    n.round[0] = n.round[1] = 0.05f;
    if (slides) dmg_slide(b, 0, "slide", v3(0, 0, -1), 0.0f, way);
    uint32_t part = b->part;
    int keys = dmg_int(b, 0, 3);
    dmg_bent_draw(b, &n);
    for (int i = 0; i < keys; ++i) {
        dmg_bent_stand(b, &n, 0.35f + 0.2f * (float)i, AHEAD, 0);
        dmg_thumb_key_draw(b, part, "rail_button", 0.3f * half);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (!hammer) return;
    dmg_hinge(b, 0, "hammer", v3(0, top, -0.44f * length), v3(-1, 0, 0), 0.0f,
              slides ? 0.5f : dmg_range(b, 0.4f, 1.0f));
    dmg_beam(b, v3(0, top - 0.2f * high, -0.44f * length), v3(0, top + 1.5f * high, -0.46f * length), 0.4f * half,
             0.4f * half);
    dmg_rod(b, v3(-0.3f * half, top + 1.5f * high, -0.48f * length),
            v3(0.3f * half, top + 1.5f * high, -0.48f * length), 0.3f * half);
    dmg_use(b, 0);
}

/* Draws the grip down from the frame: a release, a safety, a magazine drawn out of its foot. */
static void draw_gun_grip(dmg_builder* b, float length, float half, float lean) {
    float down = length * dmg_range(b, 0.5f, 0.7f), deep = half * dmg_range(b, 1.4f, 2.0f), z = -0.3f * length;
    dmg_vec foot = v3(0, -down * cosf(lean), z - down * sinf(lean));
    bool magazine = dmg_chance(b, 0.6f), squeeze = dmg_chance(b, 0.3f);
    dmg_bent n = dmg_bent_between(foot, v3(0, 0.3f * half, z), v3(0, 0, 0), v3(1, 0, 0), 0.8f * half, deep);
    n.egg = dmg_range(b, -0.1f, 0.3f);
    n.power = dmg_range(b, 2.0f, 3.5f);
    n.wide[1] *= dmg_range(b, 0.9f, 1.15f);
    n.round[0] = n.round[1] = 0;
    dmg_window back = {0};
    if (squeeze) back = dmg_bent_open(&n, 0.6f, AHEAD + DMG_PI, 0.4f, 0.8f, 0.35f * half);
    dmg_bent_draw(b, &n);
    if (squeeze) dmg_bent_key_draw(b, &n, &back, 0, "grip_safety", DMG_KEY_LAST);
    dmg_bent_stand(b, &n, 0.72f, 0.35f, 0);
    dmg_thumb_key_draw(b, 0, "release", 0.18f * half);
    dmg_restore(b);
    if (!magazine) return;
    dmg_vec line = v3_normalize(v3_sub(n.control[3], foot));
    dmg_slide(b, 0, "magazine", v3_scale(line, -1), 0.0f, down * dmg_range(b, 0.3f, 0.8f));
    dmg_beam(b, v3_mad(foot, line, -0.2f * half), foot, 1.5f * half, 1.9f * deep);
    dmg_beam(b, foot, v3_mad(foot, line, 0.8f * down), 0.9f * half, 1.3f * deep);
    dmg_use(b, 0);
}

void dmg_build_pistol_controller(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.14f, 0.28f), half = length * dmg_range(b, 0.07f, 0.1f),
          deep = half * dmg_range(b, 0.8f, 1.2f), lean = dmg_range(b, 0.15f, 0.45f),
          pull = half * dmg_range(b, 0.6f, 1.1f), reach = length * dmg_range(b, 0.13f, 0.19f), z = -0.08f * length,
          whole = dmg_range(b, -0.4f, 0.4f);
    bool hammer = dmg_chance(b, 0.5f), guard = dmg_chance(b, 0.8f), stick = !hammer && dmg_chance(b, 0.6f),
         safety = dmg_chance(b, 0.6f);
    dmg_move(b, 0, length, 0);
    dmg_turn(b, v3(1, 0, 0), whole);
    dmg_bent n =
        dmg_bent_between(v3(0, 0, -0.5f * length), v3(0, 0, 0.5f * length), v3(0, 0, 0), v3(-1, 0, 0), half, deep);
    n.power = dmg_range(b, 2.5f, 5.0f);
    n.wide[2] *= dmg_range(b, 0.6f, 1.1f);
    n.round[0] = dmg_range(b, 0.05f, 0.2f);
    n.round[1] = dmg_range(b, 0.03f, 0.2f);
    n.rows = 26;
    dmg_bent_open(&n, 0.43f, AHEAD + DMG_PI, 0.12f, 0.8f, 0.5f * deep);
    dmg_bent_draw(b, &n);
    dmg_save(b);
    dmg_move(b, 0, -0.85f * deep, z);
    dmg_finger_lever_draw(b, 0, "trigger", pull, reach);
    dmg_restore(b);
    if (guard) {
        const dmg_vec bow[] = {{0, -0.7f * deep, z + 1.2f * reach},
                               {0, -deep - 0.8f * reach, z + 1.1f * reach},
                               {0, -deep - 1.35f * reach, z + 0.5f * reach},
                               {0, -deep - 1.35f * reach, z - 0.4f * reach},
                               {0, -deep - 1.1f * reach, z - 1.4f * reach}};
        dmg_sweep(b, bow, 5, 0.06f * reach, 0.4f * half, false);
    }
    draw_gun_grip(b, length, half, lean);
    draw_gun_top(b, length, half, 0.9f * deep, hammer);
    if (stick) {
        dmg_aim(b, v3(0, 0.2f * deep, -0.49f * length), v3(0, 0.5f, -1), v3(0, 1, 0));
        dmg_hat_draw(b, 0, "thumb_stick", 0.7f * half);
        dmg_restore(b);
    }
    if (!safety) return;
    dmg_hinge(b, 0, "safety", v3(half, 0.2f * deep, -0.35f * length), v3(1, 0, 0), 0.0f, dmg_range(b, 0.4f, 1.2f));
    dmg_rod(b, v3(0.9f * half, 0.2f * deep, -0.35f * length), v3(1.2f * half, 0.2f * deep, -0.35f * length),
            0.25f * deep);
    dmg_box_span(b, v3(1.02f * half, 0.1f * deep, -0.35f * length), v3(1.2f * half, 0.35f * deep, -0.22f * length));
}
