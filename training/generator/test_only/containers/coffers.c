/* Draws safes in floors, walls and hotels, lockers, gun safes with thick doors on outside pins; and soft luggage:
 * trolleys that open in halves, briefcases, bags under a flap. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- safes: front at z = 0, the opening centred at the origin of the frame ---- */

typedef struct strong {
    float w, h, t; /* of the door; t: its thickness */
    float side;    /* -1 hung at its left */
    bool round, outside;
} strong;

static void draw_safe_wheel(dmg_builder* b, uint32_t door, float r) {
    int spokes = dmg_int(b, 3, 5), kind = dmg_int(b, 0, 2);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * r), 0.3f * r);
    dmg_spin(b, door, "bolt_wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0.31f * r), v3(0, 0, 0.7f * r), 0.22f * r);
    for (int i = 0; i < spokes && kind < 2; ++i) {
        float a = 2 * DMG_PI * (float)i / (float)spokes;
        dmg_vec end = v3(r * cosf(a), r * sinf(a), 0.6f * r);
        dmg_rod(b, v3(0, 0, 0.55f * r), end, 0.07f * r);
        dmg_ellipsoid(b, end, v3(0.13f * r, 0.13f * r, 0.13f * r));
    }
    if (kind == 1) dmg_torus(b, v3(0, 0, 0.6f * r), v3(0, 0, 1), r, 0.08f * r);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0.4f * r, 0.6f * r), v3(0.3f * r, 1.6f * r, 0.2f * r), 0.08f * r);
    dmg_use(b, door);
}

/* Draws what unlocks it: keys in rows, a dial, a lock under a cover that swings aside. */
static void draw_lock(dmg_builder* b, uint32_t door, float r) {
    int kind = dmg_int(b, 0, 3), columns = dmg_int(b, 0, 1) ? 3 : 4;
    if (kind == 0) {
        float cell = 2.0f * r / (float)columns, rise = 0.15f * cell;
        dmg_box(b, v3(0, 0, 0.05f * r), v3(2.3f * r, 2.9f * r, 0.1f * r));
        dmg_move(b, 0, -0.3f * r, 0.1f * r);
        dmg_buttons keys = {"key", columns, 4, cell, 0.5f * r, 0.75f * cell, 0.38f * r, rise, 0.8f * rise, 0};
        keys.kind = dmg_int(b, 0, 2);
        dmg_buttons_draw(b, door, &keys);
    } else if (kind == 1) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.1f * r), 1.2f * r);
        dmg_spin(b, door, "dial", v3(0, 0, 0), v3(0, 0, 1));
        dmg_cone(b, v3(0, 0, 0.11f * r), v3(0, 0, 0.35f * r), r, 0.8f * r);
        dmg_rod(b, v3(0, 0, 0.35f * r), v3(0, 0, 0.8f * r), 0.45f * r);
    } else if (kind == 2) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.08f * r), 0.35f * r);
        dmg_hinge(b, door, "key_cover", v3(0, 0.5f * r, 0), v3(0, 0, 1), 0.0f, 1.6f);
        dmg_box(b, v3(0, 0, 0.14f * r), v3(0.7f * r, 1.4f * r, 0.1f * r));
    }
    dmg_use(b, door);
}

static uint32_t draw_strong_door(dmg_builder* b, const strong* s, uint32_t parent) {
    float r = 0.5f * s->w, line = s->side * (s->outside ? r + 0.35f * s->t : r - 0.1f * s->t),
          back = s->outside ? 0.0f : -0.6f * s->t, lever = 0.13f * fminf(s->w, s->h),
          at = dmg_range(b, -0.15f, 0.15f) * s->h, swing = dmg_range(b, 1.5f, 2.3f);
    bool wheel = dmg_chance(b, 0.6f), ring = dmg_chance(b, 0.5f);
    uint32_t door = dmg_hinge(b, parent, "door", v3(line, 0, back + (s->outside ? 0.6f : 1.0f) * s->t),
                              v3(0, s->side, 0), 0.0f, swing);
    if (s->round) {
        dmg_rod(b, v3(0, 0, back + 0.002f), v3(0, 0, back + s->t), r);
        if (ring) dmg_torus(b, v3(0, 0, back + s->t), v3(0, 0, 1), 0.85f * r, 0.04f * r);
    } else {
        dmg_box_span(b, v3(-r, -0.5f * s->h, back + 0.002f), v3(r, 0.5f * s->h, back + s->t));
        if (ring)
            dmg_box_span(b, v3(-0.85f * r, -0.43f * s->h, back + s->t),
                         v3(0.85f * r, 0.43f * s->h, back + 1.15f * s->t));
    }
    float pin = 0.3f * s->t, span = s->round ? 0.35f * s->h : 0.36f * s->h;
    for (int i = -1; i <= 1 && s->outside; i += 2) { /* knuckles: the upper half the door's, the lower the body's */
        float y = (float)i * span;
        dmg_use(b, door);
        dmg_rod(b, v3(line, y, 0.6f * s->t), v3(line, y + 1.2f * s->t, 0.6f * s->t), pin);
        dmg_box_span(b, v3(fminf(line, s->side * 0.6f * r), y + 0.1f * s->t, 0.4f * s->t),
                     v3(fmaxf(line, s->side * 0.6f * r), y + 1.1f * s->t, 0.8f * s->t));
        dmg_use(b, parent);
        dmg_rod(b, v3(line, y - 1.2f * s->t, 0.6f * s->t), v3(line, y - 0.02f * s->t, 0.6f * s->t), pin);
        dmg_box_span(b, v3(line - 0.2f * s->t, y - 1.1f * s->t, -0.01f),
                     v3(line + 0.2f * s->t, y - 0.1f * s->t, 0.6f * s->t));
    }
    dmg_use(b, door);
    dmg_save(b);
    dmg_move(b, s->w > 0.6f * s->h ? -s->side * 0.22f * s->w : 0, at, back + 1.14f * s->t);
    if (wheel)
        draw_safe_wheel(b, door, lever);
    else {
        dmg_hinge(b, door, "lever", v3(0, 0, 0), v3(0, 0, s->side), 0.0f, 1.3f);
        dmg_rod(b, v3(0, 0, -0.1f * lever), v3(0, 0, 0.5f * lever), 0.25f * lever);
        dmg_box(b, v3(-0.6f * s->side * lever, 0, 0.45f * lever), v3(1.7f * lever, 0.3f * lever, 0.2f * lever));
        dmg_use(b, door);
    }
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, s->w > 0.6f * s->h ? s->side * 0.18f * s->w : 0, s->w > 0.6f * s->h ? at : at + 0.28f * s->h,
             back + 1.14f * s->t);
    draw_lock(b, door, 0.09f * fminf(s->w, 1.2f * s->h));
    dmg_restore(b);
    return door;
}

/* Shelves, a drawer below them, or nothing behind the door. */
static void draw_inside(dmg_builder* b, float w, float h, float d, float z) {
    int kind = dmg_int(b, 0, 2), shelves = dmg_int(b, 1, 3);
    for (int i = 1; i <= shelves && kind < 2; ++i)
        dmg_box(b, v3(0, h * ((float)i / (float)(shelves + 1) - 0.5f), -0.55f * d + z), v3(w, 0.012f, 0.8f * d));
    if (kind != 1) return;
    float y = h * (1.0f / (float)(shelves + 1) - 0.5f), high = 0.6f * h / (float)(shelves + 1);
    uint32_t drawer = dmg_slide(b, 0, "inner_drawer", v3(0, 0, 1), 0.0f, 0.6f * d);
    dmg_keep_rest(b, drawer);
    dmg_box_span(b, v3(-0.48f * w, y - high, -0.8f * d + z), v3(0.48f * w, y - 0.012f, -0.1f * d + z));
    dmg_use(b, 0);
}

static void draw_upright_safe(dmg_builder* b) {
    float w = dmg_scale_range(b, 0.22f, 0.9f), h = w * dmg_scale_range(b, 0.6f, 2.4f), d = w * dmg_range(b, 0.6f, 1.1f),
          wall = w * dmg_range(b, 0.05f, 0.14f), foot = dmg_chance(b, 0.4f) ? 0.05f * w : 0.0f;
    int doors = h > 1.3f * w && dmg_chance(b, 0.35f) ? dmg_int(b, 2, 3) : 1;
    strong s = {.t = w * dmg_range(b, 0.08f, 0.18f)};
    s.side = dmg_chance(b, 0.7f) ? 1.0f : -1.0f;
    s.outside = dmg_chance(b, 0.55f);
    s.round = doors == 1 && w > 0.8f * h && dmg_chance(b, 0.5f);
    float each = h / (float)doors;
    for (int i = 0; i < 4 && foot > 0.0f; ++i)
        dmg_rod(b, v3((i & 1 ? 0.4f : -0.4f) * w, 0, (i & 2 ? -0.1f : -0.9f) * d),
                v3((i & 1 ? 0.4f : -0.4f) * w, foot, (i & 2 ? -0.1f : -0.9f) * d), 0.05f * w);
    dmg_move(b, 0, foot, 0);
    for (int i = 0; i < doors; ++i) {
        dmg_save(b);
        dmg_move(b, 0, each * ((float)i + 0.5f), 0);
        float open_w = w - 2 * wall, open_h = each - 2 * wall;
        if (s.round) {
            float r = 0.5f * fminf(open_w, open_h);
            dmg_holed_plate_draw(b, w, each, d - wall, r * 1.01f);
            dmg_box_span(b, v3(-0.5f * w, -0.5f * each, -d), v3(0.5f * w, 0.5f * each, wall - d));
            s.w = s.h = s.outside ? 2.1f * r : 1.99f * r;
        } else {
            dmg_case_draw(b, DMG_CASE_BOARDS, w, each, d, wall);
            s.w = s.outside ? 0.5f * (w + open_w) : open_w - 0.004f;
            s.h = s.outside ? 0.5f * (each + open_h) : open_h - 0.004f;
            if (s.outside) s.w -= 0.4f * s.t;
            draw_inside(b, open_w - 0.002f, open_h, d - wall, -0.8f * s.t);
        }
        draw_strong_door(b, &s, 0);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* Draws a depository: a hopper or a drawer above its door. */
static void draw_deposit_safe(dmg_builder* b) {
    float w = dmg_range(b, 0.35f, 0.6f), h = w * dmg_range(b, 1.2f, 1.9f), d = w * dmg_range(b, 0.8f, 1.0f),
          wall = 0.07f * w, top = h * dmg_range(b, 0.25f, 0.4f);
    strong s = {.w = 0.94f * w, .h = 0.94f * (h - top), .t = 0.1f * w, .side = dmg_sign(b), .outside = true};
    s.w -= 0.35f * s.t;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (h - top), 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, h - top, d, wall);
    draw_strong_door(b, &s, 0);
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * h, 0);
    bool drawer = dmg_chance(b, 0.4f);
    float high = 0.7f * top, x = 0.42f * w;
    if (drawer) { /* drawn out, filled, pushed home */
        dmg_case_draw(b, DMG_CASE_BOARDS, w, top, d, wall);
        dmg_slide(b, 0, "hopper", v3(0, 0, 1), 0.0f, 0.5f * d);
        dmg_box_span(b, v3(-x, -0.5f * high, -0.7f * d), v3(x, 0.4f * high, 0));
    } else {
        dmg_box_span(b, v3(-0.5f * w, -0.5f * top, -d), v3(0.5f * w, 0.5f * top, -0.001f));
        dmg_hinge(b, 0, "hopper", v3(0, -0.5f * high, 0.01f), v3(1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.0f));
    }
    dmg_box_span(b, v3(-1.08f * x, -0.5f * high, 0), v3(1.08f * x, 0.55f * high, 0.03f));
    dmg_save(b);
    dmg_move(b, 0, 0.25f * high, 0.03f);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle bar = {DMG_HANDLE_ARCH, x, 0.02f, 0.05f, 0.8f};
    dmg_handle_draw(b, &bar, 2 * x);
    dmg_restore(b);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_build_vault_safe(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){5, 1.5f, 1.5f}, 3);
    if (kind == 0) draw_upright_safe(b);
    if (kind == 1) draw_deposit_safe(b);
    if (kind != 2) return;
    /* Sunk into a floor: the door lies flat in its collar. */
    float w = dmg_range(b, 0.25f, 0.5f), deep = w * dmg_range(b, 0.6f, 1.2f), rim = w * dmg_range(b, 0.7f, 1.0f);
    strong s = {.w = w, .h = w, .t = 0.14f * w, .side = dmg_sign(b), .outside = true};
    s.round = dmg_chance(b, 0.7f);
    dmg_move(b, 0, deep, 0);
    dmg_face_up(b);
    if (s.round)
        dmg_holed_plate_draw(b, 2 * rim, 2 * rim, deep, 0.46f * w);
    else
        dmg_frame_draw(b, 2 * rim, 2 * rim, deep, rim - 0.46f * w);
    dmg_box_span(b, v3(-0.5f * w, -0.5f * w, -0.99f * deep), v3(0.5f * w, 0.5f * w, -0.95f * deep));
    draw_strong_door(b, &s, 0);
}

/* ---- luggage ---- */

/* Draws a trolley standing on its wheels: the front half, its pocket, two stages of handle. */
static void draw_trolley_case(dmg_builder* b) {
    float w = dmg_range(b, 0.32f, 0.55f), h = w * dmg_range(b, 1.3f, 1.7f), d = w * dmg_range(b, 0.45f, 0.7f),
          r = dmg_range(b, 0.02f, 0.035f), low = 2.6f * r,
          share = dmg_chance(b, 0.5f) ? 0.5f : dmg_range(b, 0.12f, 0.4f), front = d * share,
          soft = dmg_range(b, 0.1f, 0.35f) * front;
    bool pocket = dmg_chance(b, 0.5f), four = dmg_chance(b, 0.6f), below = dmg_chance(b, 0.2f);
    float side = dmg_sign(b), swing = dmg_range(b, 1.4f, 3.0f), mid = low + 0.5f * h;
    dmg_rounded_box(b, v3(0, mid, -0.5f * (d - front) - 0.001f), v3(w, h, d - front), fminf(soft, 0.3f * (d - front)));
    uint32_t half = below ? dmg_hinge(b, 0, "shell", v3(0, low, 0), v3(1, 0, 0), 0.0f, 1.5f)
                          : dmg_hinge(b, 0, "shell", v3(side * 0.5f * w, 0, 0), v3(0, side, 0), 0.0f, swing);
    dmg_rounded_box(b, v3(0, mid, 0.5f * front), v3(w, h, front - 0.002f), soft);
    for (int i = 0; i < 4 && dmg_chance(b, 0.6f); ++i) /* ribs */
        dmg_box(b, v3(w * (0.2f * (float)i - 0.3f), mid, front), v3(0.04f * w, 0.8f * h, 0.012f));
    if (pocket) {
        dmg_hinge(b, half, "pocket", v3(0, low + 0.12f * h, front), v3(1, 0, 0), 0.0f, 0.9f);
        dmg_rounded_box(b, v3(0, low + 0.38f * h, front + 0.05f * d), v3(0.8f * w, 0.5f * h, 0.08f * d), 0.02f * d);
    }
    float x = 0.28f * w, back = front - d + 0.02f, reach = dmg_range(b, 0.25f, 0.4f), t = 0.009f;
    uint32_t tube = dmg_slide(b, 0, "outer_tube", v3(0, 1, 0), 0.0f, reach);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * x, mid - 0.2f * h, back), v3((float)s * x, low + h + 0.005f, back), t);
    dmg_slide(b, tube, "handle", v3(0, 1, 0), 0.0f, 0.9f * reach);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * x, mid - 0.2f * h, back), v3((float)s * x, low + h + 0.02f, back), 0.7f * t);
    dmg_rounded_box(b, v3(0, low + h + 0.03f, back), v3(2.4f * x, 0.024f, 0.03f), 0.008f);
    dmg_use(b, 0);
    for (int i = 0; i < 4; ++i) {
        float px = (i & 1 ? 0.4f : -0.4f) * w, pz = i & 2 ? -0.04f * d : front - d + 1.4f * r;
        bool swivel = four, fixed_foot = !four && (i & 2);
        if (fixed_foot) {
            dmg_box_span(b, v3(px - 0.01f, 0, pz - 0.03f), v3(px + 0.01f, low + 0.03f * h, pz));
            continue;
        }
        uint32_t fork = swivel ? dmg_spin(b, 0, "caster", v3(px, 0, pz - r), v3(0, 1, 0)) : 0;
        dmg_box_span(b, v3(px - 0.008f - 0.6f * r, r, pz - 1.3f * r), v3(px - 0.6f * r, low - 0.001f, pz - 0.3f * r));
        dmg_box_span(b, v3(px - 0.6f * r, 2.1f * r, pz - 1.3f * r), v3(px + 0.6f * r, low - 0.001f, pz - 0.3f * r));
        float at = swivel ? pz - 1.3f * r : pz - r;
        dmg_spin(b, fork, "wheel", v3(px, r, at), v3(1, 0, 0));
        dmg_rod(b, v3(px - 0.5f * r, r, at), v3(px + 0.5f * r, r, at), r);
        dmg_use(b, 0);
    }
}

/* Lying flat: a briefcase or a case for an instrument, its lid on the rear edge, latches and a handle in front. */
static void draw_attache(dmg_builder* b) {
    float w = dmg_range(b, 0.35f, 1.1f), d = dmg_range(b, 0.26f, 0.4f), h = dmg_range(b, 0.07f, 0.16f),
          part = h * dmg_range(b, 0.4f, 0.75f), t = 0.006f, waist = w > 0.75f ? dmg_range(b, 0.5f, 0.75f) : 1.0f;
    enum { POINTS = 10 };
    dmg_xy outer[POINTS], inner[POINTS];
    const float at[] = {-0.5f, 0.1f, 0.2f, 0.35f, 0.5f};
    for (int i = 0; i < 5; ++i) {
        float half = 0.5f * d * (i == 0 ? 1.0f : (i == 1 ? 1.0f : waist));
        outer[i] = (dmg_xy){at[i] * w, 0.0f};
        outer[POINTS - 1 - i] = (dmg_xy){at[i] * w, half + 0.5f * d};
        inner[i] = (dmg_xy){at[i] * w * 0.97f, 0.02f * d};
        inner[POINTS - 1 - i] = (dmg_xy){at[i] * w * 0.97f, 0.96f * (half + 0.5f * d)};
    }
    int latches = dmg_int(b, 1, 3);
    float swing = dmg_range(b, 1.3f, 2.0f);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* the straight side is hung; it is behind */
    dmg_move(b, 0, 0, -0.5f * d);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_mirror(b, v3(0, 1, 0));
    dmg_extrude(b, inner, POINTS, 0, t);
    dmg_ring_plate(b, outer, inner, POINTS, 0, part);
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, 0, part), v3(1, 0, 0), 0.0f, swing);
    dmg_ring_plate(b, outer, inner, POINTS, part + 0.001f, h);
    dmg_extrude(b, inner, POINTS, h - t, h);
    dmg_restore(b);
    for (int i = 0; i < latches; ++i) {
        float x = latches == 1 ? -0.3f * w : w * (0.6f * (float)i / (float)(latches - 1) - 0.5f) * 0.9f;
        dmg_hinge(b, lid, "latch", v3(x, part + 0.25f * (h - part), 0.5f * d + 0.003f), v3(-1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(x - 0.015f, 0.6f * part, 0.5f * d + 0.001f),
                     v3(x + 0.015f, part + 0.3f * (h - part), 0.5f * d + 0.008f));
    }
    dmg_use(b, 0);
    float x = -0.15f * w, hand = 0.06f;
    dmg_hinge(b, 0, "handle", v3(0, 0.5f * part, 0.5f * d + 0.006f), v3(1, 0, 0), -1.2f, 0.4f);
    const dmg_vec grip[] = {{x - hand, 0.5f * part, 0.5f * d + 0.006f},
                            {x - hand, 0.5f * part, 0.5f * d + 0.045f},
                            {x + hand, 0.5f * part, 0.5f * d + 0.045f},
                            {x + hand, 0.5f * part, 0.5f * d + 0.006f}};
    dmg_sweep(b, grip, 4, 0.006f, 0.006f, false);
    dmg_use(b, 0);
}

/* Draws a satchel or rucksack: its flap comes over the front from the rear edge of the top; a pocket and a bail. */
static void draw_bag(dmg_builder* b) {
    float w = dmg_range(b, 0.22f, 0.42f), h = w * dmg_range(b, 0.7f, 1.4f), d = w * dmg_range(b, 0.3f, 0.5f),
          over = h * dmg_range(b, 0.3f, 0.8f), t = 0.006f;
    bool pocket = dmg_chance(b, 0.6f);
    dmg_rounded_box(b, v3(0, 0.5f * h, 0), v3(w, h, d), 0.2f * d);
    uint32_t flap =
        dmg_hinge(b, 0, "flap", v3(0, h + 0.003f, -0.45f * d), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 3.0f));
    dmg_box_span(b, v3(-0.5f * w, h + 0.001f, -0.45f * d), v3(0.5f * w, h + t, 0.5f * d + 0.045f));
    dmg_box_span(b, v3(-0.5f * w, h - over, 0.5f * d + 0.045f - t), v3(0.5f * w, h + 0.001f, 0.5f * d + 0.045f));
    if (dmg_chance(b, 0.5f)) { /* a tongue with a buckle */
        dmg_hinge(b, flap, "tongue", v3(0, h - over, 0.5f * d + 0.045f), v3(-1, 0, 0), 0.0f, 1.2f);
        dmg_box_span(b, v3(-0.02f, h - over - 0.12f * h, 0.5f * d + 0.046f),
                     v3(0.02f, h - over + 0.01f, 0.5f * d + 0.05f));
    }
    dmg_use(b, 0);
    if (pocket) dmg_rounded_box(b, v3(0, 0.25f * h, 0.5f * d + 0.01f), v3(0.7f * w, 0.35f * h, 0.05f), 0.01f);
    float x = 0.2f * w, lift = dmg_range(b, 0.05f, 0.15f), z = -0.5f * d;
    dmg_hinge(b, 0, "handle", v3(0, 0.96f * h, z), v3(-1, 0, 0), 0.0f, 1.6f);
    const dmg_vec bail[] = {{-x, 0.95f * h, z - 0.006f},
                            {-0.9f * x, h + 0.8f * lift, z - 0.006f},
                            {0, h + lift, z - 0.006f},
                            {0.9f * x, h + 0.8f * lift, z - 0.006f},
                            {x, 0.95f * h, z - 0.006f}};
    dmg_sweep(b, bail, 5, 0.006f, 0.006f, false);
    dmg_use(b, 0);
}

void dmg_build_soft_luggage(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 2}, 3);
    if (kind == 0) draw_trolley_case(b);
    if (kind == 1) draw_attache(b);
    if (kind == 2) draw_bag(b);
}
