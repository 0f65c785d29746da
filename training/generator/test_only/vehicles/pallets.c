/* Draws pallet trucks and dock equipment: hand trucks with their drawbars, stackers with a mast, ride-on trucks with
 * a steering wheel, dock levellers with a lip, scissor tables. Forks and ramps point to +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- steering ---- */

/* Draws a bar with a grip, from its pin forward (-Z) and up; in the grip a lever, thumb wheels on it where it is
 * driven. */
static void draw_drawbar(dmg_builder* b, uint32_t parent, dmg_vec pin, float length) {
    float swing = dmg_range(b, 0.9f, 1.4f), r = length * dmg_range(b, 0.012f, 0.022f),
          wide = length * dmg_range(b, 0.12f, 0.2f);
    float loop = length * dmg_range(b, 0.14f, 0.25f), rest = swing * dmg_range(b, 0.0f, 0.7f);
    bool twin = dmg_chance(b, 0.35f), head = dmg_chance(b, 0.4f), lever = dmg_chance(b, 0.7f);
    uint32_t bar = dmg_hinge(b, parent, "drawbar", pin, v3(-1, 0, 0), 0.0f, swing);
    dmg_rest(b, bar, rest);
    float neck = pin.y + length - loop;
    dmg_rod(b, v3(pin.x - 2.5f * r, pin.y, pin.z), v3(pin.x + 2.5f * r, pin.y, pin.z), 1.8f * r);
    for (int s = twin ? -1 : 0; s <= (twin ? 1 : 0); s += 2)
        dmg_rod(b, v3((float)s * 1.2f * r, pin.y, pin.z), v3((float)s * 0.3f * wide, neck, pin.z), r);
    const dmg_vec path[] = {{0, neck, pin.z},
                            {0.8f * wide, neck + 0.1f * loop, pin.z},
                            {wide, neck + 0.3f * loop, pin.z},
                            {wide, neck + loop, pin.z},
                            {-wide, neck + loop, pin.z},
                            {-wide, neck + 0.3f * loop, pin.z},
                            {-0.8f * wide, neck + 0.1f * loop, pin.z}};
    dmg_sweep(b, path, 7, r, r, true);
    if (head) {
        dmg_box(b, v3(0, neck + 0.2f * loop, pin.z), v3(1.1f * wide, 0.5f * loop, 5 * r));
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.68f * wide, y = neck + 0.3f * loop;
            dmg_hinge(b, bar, "thumb_wheel", v3(x, y, pin.z), v3(1, 0, 0), -0.5f, 0.5f);
            dmg_rod(b, v3(x - (float)s * 0.13f * wide, y, pin.z), v3(x + (float)s * 0.05f * wide, y, pin.z),
                    0.12f * loop);
            dmg_box(b, v3(x, y + 0.13f * loop, pin.z), v3(0.1f * wide, 0.08f * loop, r));
            dmg_use(b, bar);
        }
    }
    if (lever) { /* a finger lever below the cross bar, or beside it in the loop */
        float y = neck + (head ? 0.5f : 0.15f) * loop, high = loop * dmg_range(b, 0.3f, 0.4f);
        uint32_t grip = dmg_hinge(b, bar, "release", v3(0, y, pin.z), v3(1, 0, 0), -0.3f, 0.3f);
        dmg_rod(b, v3(-0.2f * wide, y, pin.z), v3(0.2f * wide, y, pin.z), r);
        dmg_box_span(b, v3(-0.09f * wide, y, pin.z - 0.6f * r), v3(0.09f * wide, y + high, pin.z + 0.6f * r));
        dmg_use(b, grip);
    }
    dmg_use(b, parent);
}

static void draw_steer_wheels(dmg_builder* b, uint32_t parent, float r, float half, float z) {
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 3, 6);
    bool twin = half > 0;
    float width = r * dmg_range(b, 0.4f, 0.7f);
    for (int s = twin ? -1 : 1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_spin(b, parent, "steer_wheel", v3(x, r, z), v3(1, 0, 0));
        dmg_save(b);
        dmg_move(b, x, r, z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, kind, r, width, spokes);
        dmg_restore(b);
        dmg_use(b, parent);
    }
}

/* ---- forks ---- */

typedef struct fork_pair {
    float half, wide, length, y, t; /* half: from the middle to a fork's own; y: its top */
    float roll;                     /* of its load wheels; 0: none */
    bool twin, bogie;
} fork_pair;

static fork_pair pick_forks(dmg_builder* b) {
    fork_pair f = {.y = 0.085f};
    f.half = dmg_range(b, 0.17f, 0.27f);
    f.wide = dmg_range(b, 0.13f, 0.18f);
    f.length = dmg_range(b, 0.8f, 1.5f);
    f.t = dmg_range(b, 0.03f, 0.05f);
    f.roll = dmg_range(b, 0.032f, 0.038f);
    f.twin = dmg_chance(b, 0.4f);
    f.bogie = dmg_chance(b, 0.6f);
    return f;
}

/* Load wheels near the tips, on frames that swing down as the forks rise. */
static void draw_load_wheels(dmg_builder* b, const fork_pair* f, uint32_t on, float x) {
    float z = f->length * 0.84f, arm = 0.16f, r = f->roll, half = 0.28f * f->wide;
    uint32_t parent = on;
    if (f->bogie) {
        dmg_vec pin = {x, r + 0.01f, z - arm};
        parent = dmg_hinge(b, on, "wheel_frame", pin, v3(1, 0, 0), 0.0f, 0.7f);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(x + (float)s * half - 0.005f, r - 0.01f, z - arm - 0.01f),
                         v3(x + (float)s * half + 0.005f, r + 0.015f, z + (f->twin ? 0.09f : 0.015f)));
        dmg_rod(b, v3(x - half, pin.y, pin.z), v3(x + half, pin.y, pin.z), 0.01f);
    }
    for (int i = 0; i < (f->twin ? 2 : 1); ++i) {
        float at = z + (f->twin ? 0.08f * (float)i : 0.0f);
        dmg_spin(b, parent, "load_wheel", v3(x, r, at), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.85f * half, r, at), v3(x + 0.85f * half, r, at), r);
        dmg_rod(b, v3(x - half, r, at), v3(x + half, r, at), 0.35f * r);
        dmg_use(b, parent);
    }
    dmg_use(b, on);
}

/* From z = 0 forward: channels open below, with tips that taper. */
static void draw_forks(dmg_builder* b, const fork_pair* f, uint32_t on) {
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * f->half, side = 0.5f * f->wide, wall = 0.008f;
        const dmg_xy tip[] = {{0.97f * f->length, f->y - f->t},
                              {1.04f * f->length, f->y - 0.3f * f->t},
                              {1.04f * f->length, f->y},
                              {0.97f * f->length, f->y}};
        dmg_box_span(b, v3(x - side, f->y - wall, -0.02f), v3(x + side, f->y, f->length));
        for (int w = -1; w <= 1; w += 2)
            dmg_box_span(b, v3(x + (float)w * side - wall, f->y - f->t, -0.02f),
                         v3(x + (float)w * side + wall, f->y - wall, f->length));
        dmg_side_prism(b, tip, 4, x - side, x + side);
        if (f->roll > 0) draw_load_wheels(b, f, on, x);
    }
}

/* ---- the trucks ---- */

/* Pump and drawbar steer as one below the bridge of the forks; or the forks rise past a pump that stays. */
static void draw_hand_truck(dmg_builder* b) {
    fork_pair f = pick_forks(b);
    float r = dmg_range(b, 0.08f, 0.1f), length = dmg_range(b, 0.8f, 1.1f), z = -0.16f,
          post = 2 * r + dmg_range(b, 0.12f, 0.2f);
    bool rises = dmg_chance(b, 0.45f), guard = dmg_chance(b, 0.4f);
    float half = f.half + 0.5f * f.wide, way = dmg_range(b, 0.1f, 0.14f), turn = dmg_range(b, 1.2f, 1.6f),
          gap = dmg_range(b, 0.05f, 0.08f);
    uint32_t frame = 0;
    if (rises) frame = dmg_slide(b, 0, "forks", v3(0, 1, 0), 0.0f, way);
    draw_forks(b, &f, frame);
    dmg_box_span(b, v3(-half, 0.05f, -0.03f), v3(half, f.y + 0.12f, 0));
    dmg_box_span(b, v3(-0.6f * half, f.y + 0.02f, -0.06f), v3(0.6f * half, post, -0.02f));
    dmg_rod(b, v3(0, post - 0.03f, z), v3(0, post, z), 0.06f);
    dmg_box_span(b, v3(-0.05f, post - 0.03f, z), v3(0.05f, post, -0.03f));
    if (guard) dmg_box_span(b, v3(-0.8f * half, post, -0.045f), v3(0.8f * half, post + 0.5f, -0.03f));
    uint32_t steer = 0;
    if (!rises) steer = dmg_hinge(b, 0, "steering", v3(0, 0, z), v3(0, 1, 0), -turn, turn);
    dmg_use(b, steer);
    float ram = 0.03f;
    dmg_rod(b, v3(0, 2.1f * r, z), v3(0, post - 0.031f, z), 0.9f * ram);
    dmg_box_span(b, v3(-0.03f, 2.05f * r, z - 0.07f), v3(0.03f, post - 0.05f, z + 0.04f));
    dmg_rod(b, v3(-gap, r, z), v3(gap, r, z), 0.012f);
    dmg_box_span(b, v3(-0.018f, 0.8f * r, z - 0.02f), v3(0.018f, 2.1f * r, z + 0.02f));
    draw_steer_wheels(b, steer, r, gap, z);
    dmg_vec pin = {0, post - 0.07f, z - 0.1f};
    dmg_box_span(b, v3(-0.022f, pin.y - 0.03f, pin.z - 0.02f), v3(0.022f, pin.y + 0.02f, z));
    draw_drawbar(b, steer, pin, length);
    if (!dmg_chance(b, 0.4f)) return;
    dmg_hinge(b, steer, "pedal", v3(0.05f, 2.1f * r, z - 0.06f), v3(-1, 0, 0), 0.0f, 0.35f);
    dmg_box_span(b, v3(0.03f, 2.1f * r - 0.008f, z - 0.17f), v3(0.06f, 2.1f * r + 0.008f, z - 0.05f));
}

/* Draws two posts, within them two that rise, a carriage with forks; legs beside or below the forks. */
static void draw_mast(dmg_builder* b, const fork_pair* f, float high, bool two, bool straddle) {
    float half = f->half * dmg_range(b, 0.8f, 1.2f), t = dmg_range(b, 0.05f, 0.08f), way = high - 0.45f,
          rest = dmg_unit(b) * way;
    bool side = dmg_chance(b, 0.35f), guard = dmg_chance(b, 0.4f);
    float leg = straddle ? fmaxf(half, f->half + 0.5f * f->wide) + 0.06f : f->half;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half, lx = (float)s * leg;
        dmg_box_span(b, v3(x - 0.5f * t, 0.03f, -t), v3(x + 0.5f * t, high, 0.4f * t));
        dmg_box_span(b, v3(lx - 0.04f, 0.02f, -t), v3(lx + 0.04f, 0.065f, 0.75f * f->length));
        dmg_spin(b, 0, "load_wheel", v3(lx, 0.035f, 0.77f * f->length + 0.03f), v3(1, 0, 0));
        dmg_rod(b, v3(lx - 0.03f, 0.035f, 0.77f * f->length + 0.03f), v3(lx + 0.03f, 0.035f, 0.77f * f->length + 0.03f),
                0.035f);
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-fmaxf(half, leg), 0.03f, -t), v3(fmaxf(half, leg), 0.12f, -0.6f * t));
    dmg_box_span(b, v3(-half, high - 0.05f, -t), v3(half, high, -0.6f * t));
    uint32_t stage = 0;
    if (two) {
        stage = dmg_slide(b, 0, "mast", v3(0, 1, 0), 0.0f, 0.75f * high);
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * (half - 0.95f * t);
            dmg_box_span(b, v3(x - 0.4f * t, 0.13f, -0.5f * t), v3(x + 0.4f * t, 0.98f * high, 0.3f * t));
        }
        dmg_box_span(b, v3(-half + t, 0.92f * high, -0.5f * t), v3(half - t, 0.97f * high, 0));
        dmg_rod(b, v3(0, 0.14f, -0.3f * t), v3(0, 0.95f * high, -0.3f * t), 0.02f);
    }
    uint32_t carriage = dmg_slide(b, stage, "carriage", v3(0, 1, 0), 0.0f, way);
    dmg_rest(b, carriage, rest);
    float back = 0.6f * t, edge = f->half + 0.5f * f->wide;
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(-edge, 0.1f + 0.22f * (float)i, 0.5f * t), v3(edge, 0.15f + 0.22f * (float)i, back + 0.03f));
    dmg_box_span(b, v3(-half + t * 1.6f, 0.12f, -0.2f * t), v3(half - t * 1.6f, 0.36f, back));
    if (guard)
        for (int i = 0; i < 4; ++i)
            dmg_rod(b, v3(edge * (0.6f * (float)i - 0.9f), 0.33f, back + 0.015f),
                    v3(edge * (0.6f * (float)i - 0.9f), 0.9f, back + 0.015f), 0.012f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * f->half, w = straddle ? 0.4f * f->wide : 0.5f * f->wide, z = back + 0.031f;
        if (side) dmg_slide(b, carriage, "fork", v3((float)-s, 0, 0), 0.0f, 0.45f * f->half);
        const dmg_xy fork[] = {{z, 0.085f},        {z + f->length, 0.085f}, {z + f->length, 0.1f},
                               {z + 0.05f, 0.12f}, {z + 0.04f, 0.38f},      {z, 0.38f}};
        dmg_side_prism(b, fork, 6, x - w, x + w);
        dmg_use(b, carriage);
    }
    dmg_use(b, 0);
}

static void draw_crank_winch(dmg_builder* b, float y, float z) {
    float arm = dmg_range(b, 0.15f, 0.28f);
    dmg_box_span(b, v3(-0.08f, y - 0.09f, z), v3(0.08f, y + 0.09f, z + 0.16f));
    uint32_t crank = dmg_spin(b, 0, "crank", v3(0.09f, y, z + 0.05f), v3(1, 0, 0));
    dmg_rod(b, v3(0.07f, y, z + 0.05f), v3(0.12f, y, z + 0.05f), 0.018f);
    dmg_box_span(b, v3(0.1f, y - 0.015f, z + 0.035f), v3(0.115f, y + arm, z + 0.065f));
    dmg_spin(b, crank, "grip", v3(0.12f, y + arm - 0.02f, z + 0.05f), v3(1, 0, 0));
    dmg_rod(b, v3(0.117f, y + arm - 0.02f, z + 0.05f), v3(0.24f, y + arm - 0.02f, z + 0.05f), 0.015f);
    dmg_use(b, 0);
}

static void draw_stacker(dmg_builder* b) {
    fork_pair f = pick_forks(b);
    float high = dmg_range(b, 1.3f, 2.2f), deep = dmg_range(b, 0.25f, 0.5f), half = f.half + 0.1f,
          r = dmg_range(b, 0.08f, 0.11f);
    bool two = dmg_chance(b, 0.4f), straddle = dmg_chance(b, 0.4f), manual = dmg_chance(b, 0.4f);
    float z = -0.1f, body = dmg_range(b, 0.6f, 0.9f), turn = dmg_range(b, 1.2f, 1.57f);
    draw_mast(b, &f, high, two, straddle);
    if (manual) { /* castors behind, a winch and a push bar at the mast */
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * half;
            dmg_box_span(b, v3(x - 0.03f, 2 * r, z - deep), v3(x + 0.03f, 2 * r + 0.05f, 0));
            uint32_t fork = dmg_spin(b, 0, "caster", v3(x, 2 * r, z - deep + 0.05f), v3(0, 1, 0));
            dmg_rod(b, v3(x, 2 * r - 0.02f, z - deep + 0.05f), v3(x, 2 * r, z - deep + 0.05f), 0.03f);
            for (int w = -1; w <= 1; w += 2)
                dmg_beam(b, v3(x + (float)w * 0.035f, 2 * r - 0.01f, z - deep + 0.05f),
                         v3(x + (float)w * 0.035f, 0.7f * r, z - deep), 0.006f, 0.04f);
            dmg_spin(b, fork, "wheel", v3(x, 0.85f * r, z - deep), v3(1, 0, 0));
            dmg_rod(b, v3(x - 0.028f, 0.85f * r, z - deep), v3(x + 0.028f, 0.85f * r, z - deep), 0.85f * r);
            dmg_rod(b, v3(x - 0.033f, 0.85f * r, z - deep), v3(x + 0.033f, 0.85f * r, z - deep), 0.2f * r);
            dmg_use(b, 0);
        }
        dmg_box_span(b, v3(-half - 0.03f, 2 * r, z), v3(half + 0.03f, 2 * r + 0.05f, -0.02f));
        dmg_box_span(b, v3(-half, 0.95f, z - 0.02f), v3(half, 1.0f, -0.03f));
        draw_crank_winch(b, 0.85f, z - 0.16f);
        return;
    }
    dmg_box_span(b, v3(-half, 2.15f * r, z - deep), v3(half, body, z));
    dmg_box_span(b, v3(-half, 0.1f, z), v3(half, 0.6f * body, -0.02f));
    uint32_t steer = dmg_hinge(b, 0, "steering", v3(0, 0, z - 0.5f * deep), v3(0, 1, 0), -turn, turn);
    dmg_rod(b, v3(0, body, z - 0.5f * deep), v3(0, body + 0.04f, z - 0.5f * deep), 0.06f);
    dmg_box_span(b, v3(-0.05f, body + 0.03f, z - 0.5f * deep - 0.08f),
                 v3(0.05f, body + 0.09f, z - 0.5f * deep + 0.05f));
    draw_drawbar(b, steer, v3(0, body + 0.06f, z - 0.5f * deep - 0.1f), dmg_range(b, 0.5f, 0.8f));
    dmg_use(b, 0);
    uint32_t drive = dmg_hinge(b, 0, "drive", v3(0, 2.15f * r, z - 0.5f * deep), v3(0, 1, 0), -turn, turn);
    dmg_rod(b, v3(0, 2.05f * r, z - 0.5f * deep), v3(0, 2.15f * r, z - 0.5f * deep), 0.8f * r);
    dmg_box_span(b, v3(0.45f * r, 0.8f * r, z - 0.5f * deep - 0.02f), v3(0.6f * r, 2.1f * r, z - 0.5f * deep + 0.02f));
    dmg_rod(b, v3(0.3f * r, r, z - 0.5f * deep), v3(0.5f * r, r, z - 0.5f * deep), 0.2f * r);
    draw_steer_wheels(b, drive, r, 0, z - 0.5f * deep);
}

/* One stands behind a console: a wheel to steer, a lever, a step that folds up, gates at both sides. */
static void draw_rider(dmg_builder* b) {
    fork_pair f = pick_forks(b);
    float half = f.half + 0.12f, deep = dmg_range(b, 0.35f, 0.6f), body = dmg_range(b, 0.8f, 1.15f),
          r = dmg_range(b, 0.1f, 0.18f);
    float tip = dmg_range(b, 0.3f, 1.0f), step = dmg_range(b, 0.35f, 0.5f), way = dmg_range(b, 0.1f, 0.16f);
    bool gates = dmg_chance(b, 0.5f), lever = dmg_chance(b, 0.7f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1), spokes = dmg_int(b, 2, 4);
    uint32_t lift = dmg_slide(b, 0, "forks", v3(0, 1, 0), 0.0f, way);
    draw_forks(b, &f, lift);
    dmg_box_span(b, v3(-half, 0.05f, -0.03f), v3(half, 0.4f, 0));
    dmg_use(b, 0);
    dmg_box_span(b, v3(-half, 0.04f, -0.035f - deep), v3(half, body, -0.035f));
    dmg_save(b);
    dmg_move(b, -0.3f * half, body, -0.035f - 0.5f * deep);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI - 0.3f * tip); /* its shaft up and towards whoever stands behind */
    dmg_rod(b, v3(0, 0, -0.05f), v3(0, 0, 0.07f), 0.025f);
    uint32_t wheel = dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0.07f), v3(0, 0, 1), -2 * DMG_PI, 2 * DMG_PI);
    dmg_rod(b, v3(0, 0, 0.06f), v3(0, 0, 0.1f), 0.2f * r);
    dmg_move(b, 0, 0, 0.09f);
    dmg_wheel_draw(b, kind, r, 0.025f, spokes);
    if (dmg_chance(b, 0.5f)) {
        dmg_spin(b, wheel, "spinner_knob", v3(0.8f * r, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0.8f * r, 0, 0.01f), v3(0.8f * r, 0, 0.06f), 0.018f);
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (lever) {
        dmg_hinge(b, 0, "lever", v3(0.5f * half, body, -0.035f - 0.5f * deep), v3(1, 0, 0), -0.4f, 0.4f);
        dmg_rod(b, v3(0.5f * half, body - 0.01f, -0.035f - 0.5f * deep),
                v3(0.5f * half, body + 0.16f, -0.035f - 0.5f * deep), 0.01f);
        dmg_ellipsoid(b, v3(0.5f * half, body + 0.17f, -0.035f - 0.5f * deep), v3(0.022f, 0.022f, 0.022f));
        dmg_use(b, 0);
    }
    float back = -0.036f - deep;
    uint32_t board = dmg_hinge(b, 0, "step", v3(0, 0.13f, back - 0.02f), v3(1, 0, 0), 0.0f, 1.5f);
    dmg_box_span(b, v3(-0.9f * half, 0.11f, back - step), v3(0.9f * half, 0.14f, back));
    dmg_rest(b, board, dmg_chance(b, 0.3f) ? 1.4f : 0.0f);
    dmg_use(b, 0);
    for (int s = -1; s <= 1 && gates; s += 2) {
        float x = (float)s * (half + 0.021f), y = fminf(0.85f * body, 0.8f);
        dmg_hinge(b, 0, "gate", v3(x, y, back + 0.04f), v3(1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(x - 0.02f, y - 0.025f, back - step), v3(x + 0.02f, y + 0.025f, back + 0.06f));
        dmg_use(b, 0);
    }
}

/* ---- docks and tables ---- */

/* Draws a share of the way up, whichever sign the axis has. */
static void rest_across(dmg_builder* b, uint32_t part, float share) {
    const dmg_joint* joint = &b->parts[part - 1].joint;
    dmg_rest(b, part, share * (joint->lower + joint->upper)); /* one of them is 0 */
}

/* Draws a deck hung at the rear of its pit, its lip hanging at the front, or pushed out of it. */
static void draw_leveller(dmg_builder* b) {
    float half = dmg_range(b, 0.8f, 1.1f), deep = dmg_range(b, 1.6f, 3.0f), y = dmg_range(b, 0.5f, 1.2f),
          t = dmg_range(b, 0.04f, 0.1f);
    float lip = dmg_range(b, 0.35f, 0.5f), way = dmg_range(b, 0.15f, 0.3f), hang = dmg_range(b, 0.1f, 0.3f);
    bool slides = dmg_chance(b, 0.35f), skirts = dmg_chance(b, 0.5f), pit = dmg_chance(b, 0.7f),
         bumpers = dmg_chance(b, 0.6f);
    float wall = pit ? dmg_range(b, 0.15f, 0.6f) : 0.05f, open = dmg_range(b, 0.0f, 1.0f),
          front = dmg_range(b, 0.8f, 1.0f) * deep;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (half + 0.02f + 0.5f * wall);
        dmg_box_span(b, v3(x - 0.5f * wall, 0, -deep), v3(x + 0.5f * wall, y, 0));
        if (bumpers) dmg_box_span(b, v3(x - 0.4f * wall, 0.3f * y, 0), v3(x + 0.4f * wall, 0.95f * y, 0.1f));
    }
    dmg_box_span(b, v3(-half - 0.02f - wall, 0, -deep - wall), v3(half + 0.02f + wall, y, -deep));
    dmg_box_span(b, v3(-half - 0.02f, 0, -deep), v3(half + 0.02f, 0.05f, 0));
    uint32_t deck = dmg_hinge_across(b, 0, "deck", v3(0, y - 0.5f * t, -deep + 0.02f), 0.0f, way);
    rest_across(b, deck, open);
    dmg_box_span(b, v3(-half, y - t, -deep + 0.01f), v3(half, y, 0));
    for (int i = 0; i < 4; ++i) {
        float x = half * (0.5f * (float)i - 0.75f);
        dmg_box_span(b, v3(x - 0.02f, y - t - 0.1f, -0.9f * front), v3(x + 0.02f, y - t, -0.1f));
    }
    for (int s = -1; s <= 1 && skirts; s += 2)
        dmg_box_span(b, v3((float)s * (half - 0.01f) - 0.006f, y - 0.35f, -0.7f * deep),
                     v3((float)s * (half - 0.01f) + 0.006f, y - t, -0.05f));
    if (slides) {
        uint32_t tongue = dmg_slide(b, deck, "lip", v3(0, 0, 1), 0.0f, 0.85f * lip);
        dmg_box_span(b, v3(-0.93f * half, y - t - 0.09f, -lip), v3(0.93f * half, y - t - 0.06f, 0.03f));
        dmg_box_span(b, v3(-0.93f * half, y - t - 0.09f, 0.005f), v3(0.93f * half, y, 0.03f));
        dmg_rest(b, tongue, lip * 0.5f * open);
    } else { /* it hangs nearly upright and turns up until it lies level */
        dmg_vec pin = {0, y - 0.02f, 0.02f};
        uint32_t flap = dmg_hinge_across(b, deck, "lip", pin, 0.0f, 0.5f * DMG_PI - hang);
        float s = sinf(hang), c = cosf(hang);
        const dmg_xy plate[] = {{0.02f, y - 0.04f},
                                {0.02f + lip * s, y - 0.04f - lip * c},
                                {0.045f + lip * s, y - 0.03f - lip * c},
                                {0.05f, y - 0.01f}};
        dmg_side_prism(b, plate, 4, -half, half);
        dmg_rod(b, v3(-0.98f * half, pin.y, pin.z), v3(0.98f * half, pin.y, pin.z), 0.019f);
        rest_across(b, flap, open);
    }
    dmg_use(b, 0);
}

/* Draws two that follow and two that steer, under a table at y. */
static void draw_table_wheels(dmg_builder* b, float half, float deep, float r, float y, int kind) {
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.85f : -0.85f) * half, z = i & 2 ? 0.85f * deep : -0.85f * deep;
        uint32_t on = 0;
        if (!(i & 2)) {
            on = dmg_spin(b, 0, "caster", v3(x, y, z + 0.03f), v3(0, 1, 0));
            dmg_rod(b, v3(x, y - 0.01f, z + 0.03f), v3(x, y, z + 0.03f), 0.035f);
        }
        dmg_box_span(b, v3(x - 0.03f, 0.8f * r, z - 0.02f), v3(x - 0.024f, y - 0.005f + (on ? 0 : 0.01f), z + 0.04f));
        dmg_rod(b, v3(x - 0.024f, 0.95f * r, z), v3(x - 0.02f, 0.95f * r, z), 0.01f);
        dmg_spin(b, on, "wheel", v3(x, 0.95f * r, z), v3(1, 0, 0));
        dmg_save(b);
        dmg_move(b, x, 0.95f * r, z);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, kind, 0.95f * r, 0.04f, 4);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Crossed arms at both sides that raise the table by `way` from `rise` above their feet. */
static void draw_scissors(dmg_builder* b, float half, float deep, float y, float rise, float way) {
    float reach = 1.7f * deep;
    float turn = asinf((way + rise) / reach) - asinf(rise / reach); /* as far as the table goes up */
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.85f * half, foot = y + 0.06f;
        dmg_box_span(b, v3(x + (float)s * 0.03f - 0.01f, y + 0.03f, -0.9f * deep),
                     v3(x + (float)s * 0.03f + 0.01f, foot + 0.03f, -0.8f * deep));
        uint32_t outer = dmg_hinge_across(b, 0, "arm", v3(x, foot, -0.85f * deep), 0.0f, turn);
        dmg_beam(b, v3(x, foot, -0.85f * deep), v3(x, foot + rise - 0.01f, 0.85f * deep), 0.018f, 0.035f);
        dmg_rod(b, v3(x - 0.014f, foot, -0.85f * deep), v3(x + (float)s * 0.02f, foot, -0.85f * deep), 0.012f);
        float in = x - (float)s * 0.02f;
        dmg_hinge(b, outer, "cross_arm", v3(in, foot + 0.5f * rise, 0), v3(1, 0, 0), 0.0f, 2 * turn);
        dmg_beam(b, v3(in, foot, 0.5f * reach), v3(in, foot + rise - 0.01f, -0.5f * reach), 0.018f, 0.035f);
        dmg_rod(b, v3(in - (float)s * 0.02f, foot + 0.5f * rise, 0), v3(x + (float)s * 0.012f, foot + 0.5f * rise, 0),
                0.01f);
        dmg_use(b, 0);
    }
}

/* Draws a bar to push by and the pedal that pumps. */
static void draw_push_handle(dmg_builder* b, float half, float deep, float y, float bar) {
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.8f * half, y + 0.02f, -deep - 0.05f),
                v3((float)s * 0.8f * half, y + bar, -deep - 0.15f), 0.015f);
    dmg_rod(b, v3(-0.8f * half, y + bar, -deep - 0.15f), v3(0.8f * half, y + bar, -deep - 0.15f), 0.015f);
    dmg_box_span(b, v3(-0.85f * half, y, -deep - 0.07f), v3(0.85f * half, y + 0.04f, -deep));
    dmg_hinge(b, 0, "pedal", v3(0.2f * half, y + 0.02f, -deep - 0.07f), v3(-1, 0, 0), 0.0f, 0.4f);
    dmg_box_span(b, v3(0.15f * half, y + 0.01f, -deep - 0.25f), v3(0.15f * half + 0.06f, y + 0.03f, -deep - 0.071f));
}

/* Draws a table over its scissors: the arms turn on the pins of the base, the inner ones on the outer; or a skirt hides
 * them. On wheels with a push bar and a pedal, or bolted down. */
static void draw_lift_table(dmg_builder* b) {
    float half = dmg_range(b, 0.25f, 0.7f), deep = half * dmg_range(b, 1.2f, 2.6f), r = dmg_range(b, 0.05f, 0.09f),
          t = dmg_range(b, 0.03f, 0.08f);
    bool wheels = dmg_chance(b, 0.6f), arms = dmg_chance(b, 0.6f), flaps = dmg_chance(b, 0.35f);
    float y = wheels ? 2 * r : 0.0f, low = dmg_range(b, 0.12f, 0.2f), bar = dmg_range(b, 0.7f, 1.0f),
          way = deep * dmg_range(b, 0.25f, 0.5f);
    int kind = dmg_int(b, 0, DMG_WHEEL_KINDS - 1);
    dmg_box_span(b, v3(-half, y, -deep), v3(half, y + 0.04f, deep));
    if (wheels) draw_table_wheels(b, half, deep, r, y, kind);
    float top = y + 0.04f + low, rise = low - 0.05f;
    if (arms) draw_scissors(b, half, deep, y, rise, way);
    if (!arms)
        dmg_box_span(b, v3(-0.85f * half, y + 0.02f, -0.85f * deep), v3(0.85f * half, top - 0.01f, 0.85f * deep));
    uint32_t table = dmg_slide(b, 0, "platform", v3(0, 1, 0), 0.0f, arms ? way : 0.85f * low);
    if (!arms) {
        dmg_save(b);
        dmg_move(b, 0, y + 0.05f, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_move(b, 0, 0, low - 0.011f);
        dmg_frame_draw(b, 1.8f * half, 1.8f * deep, low - 0.012f, 0.045f * half);
        dmg_restore(b);
    }
    dmg_box_span(b, v3(-half, top, -deep), v3(half, top + t, deep));
    for (int s = -1; s <= 1 && flaps; s += 2) {
        float z = (float)s * (deep + 0.002f), high = dmg_range(b, 0.15f, 0.4f);
        uint32_t flap = dmg_hinge(b, table, "loading_flap", v3(0, top + t - 0.012f, z), v3((float)s, 0, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(-0.95f * half, top + t - 0.012f, fminf(z, z + (float)s * 0.02f)),
                     v3(0.95f * half, top + t + high, fmaxf(z, z + (float)s * 0.02f)));
        dmg_use(b, flap);
    }
    dmg_use(b, 0);
    if (wheels) draw_push_handle(b, half, deep, y, bar);
}

void dmg_build_pallet_truck(dmg_builder* b) {
    void (*const draw[])(dmg_builder*) = {draw_hand_truck, draw_stacker, draw_rider, draw_leveller, draw_lift_table};
    draw[dmg_weighted(b, (const float[]){4, 4, 2, 2, 3}, 5)](b);
}
