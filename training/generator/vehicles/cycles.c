/* Draws bicycles and motorcycles in detail: controls on the bars, cranks, pegs, stands, sprung forks and swing arms,
 * saddles, cases with lids. Ahead is +Z; the axle line is X. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct cycle {
    bool motor;
    float wheel, base, tube, lean, width; /* width: of the tyres */
    int wheel_kind;
    dmg_vec rear, front, crown, head, bottom, saddle, steer;
} cycle;

static cycle pick_cycle(dmg_builder* b) {
    cycle c = {.motor = dmg_chance(b, 0.5f)};
    c.wheel = c.motor ? dmg_range(b, 0.24f, 0.34f) : dmg_range(b, 0.2f, 0.36f);
    c.base = c.motor ? dmg_range(b, 1.2f, 1.7f) : dmg_range(b, 0.92f, 1.15f);
    c.tube = c.motor ? dmg_range(b, 0.016f, 0.026f) : dmg_range(b, 0.01f, 0.02f);
    c.lean = dmg_range(b, 0.25f, 0.5f);
    c.width = c.motor ? dmg_range(b, 0.1f, 0.2f) : dmg_range(b, 0.025f, 0.06f);
    c.wheel_kind = c.motor ? dmg_int(b, 1, 2) : dmg_weighted(b, (const float[]){1, 0, 1, 6}, 4);
    c.rear = v3(0, c.wheel, -0.5f * c.base);
    c.front = v3(0, c.wheel, 0.5f * c.base);
    c.steer = v3(0, cosf(c.lean), -sinf(c.lean));
    c.crown = v3_mad(c.front, c.steer, c.wheel + dmg_range(b, 0.1f, 0.22f));
    c.head = v3_mad(c.crown, c.steer, dmg_range(b, 0.14f, 0.26f));
    c.bottom = v3(0, c.motor ? 0.9f * c.wheel : fmaxf(0.27f, 0.85f * c.wheel), -0.08f * c.base);
    c.saddle = v3(0, c.motor ? dmg_range(b, 0.7f, 0.85f) : dmg_range(b, 0.8f, 1.0f), -0.24f * c.base);
    return c;
}

static void draw_cycle_wheel(dmg_builder* b, const cycle* c, uint32_t carrier, dmg_vec axle, const char* name) {
    dmg_save(b);
    dmg_move(b, axle.x, axle.y, axle.z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, carrier, name, v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, c->wheel_kind, c->wheel, c->width, c->motor ? dmg_int(b, 5, 9) : 12);
    dmg_restore(b);
    dmg_use(b, carrier);
}

static dmg_vec beside(dmg_vec at, float x) {
    return v3_add(at, v3(x, 0, 0));
}

/* ---- on the bars: the grip's end at x = reach, on the side of +X ---- */

/* Draws a lever before the grip, on a clamp; pulled towards it. */
static void draw_brake_lever(dmg_builder* b, uint32_t bars, dmg_vec grip, float reach, float tube) {
    float length = dmg_range(b, 0.1f, 0.17f), root = reach - 0.13f - 0.4f * length, out = dmg_range(b, 0.035f, 0.06f);
    dmg_vec clamp = v3(root, grip.y, grip.z), pin = v3_add(clamp, v3(0.008f, -0.006f, out));
    bool kinked = dmg_chance(b, 0.5f), drops = dmg_chance(b, 0.25f);
    dmg_use(b, bars);
    dmg_rod(b, beside(clamp, -0.012f), beside(clamp, 0.012f), 1.5f * tube);
    dmg_beam(b, clamp, v3_add(pin, v3(0, 0, 0.01f)), 0.026f, 0.022f);
    dmg_hinge(b, bars, "brake_lever", pin, drops ? v3_normalize(v3(0.3f, 1, 0)) : v3(0, 1, 0), 0.0f,
              fminf(0.6f, 0.8f * out / length) + dmg_range(b, 0.0f, 0.08f));
    dmg_vec knee = v3_add(pin, v3(0.25f * length, 0, kinked ? 0.012f : 0.0f)),
            tip = v3_add(pin, v3(length, drops ? -0.03f : 0.0f, 0.006f));
    dmg_beam(b, pin, knee, 0.012f, 0.014f);
    dmg_beam(b, knee, tip, 0.01f, 0.012f);
    if (dmg_chance(b, 0.6f)) dmg_ellipsoid(b, tip, v3(0.008f, 0.008f, 0.008f));
    dmg_use(b, bars);
}

/* Draws a grip that twists, or is still; a small lever or twist for the gears; a mirror; a bell's lever. */
static void draw_bar_end(dmg_builder* b, const cycle* c, uint32_t bars, dmg_vec at, float reach) {
    float tube = 0.8f * c->tube;
    dmg_vec from = v3(reach - 0.12f, at.y, at.z), end = v3(reach, at.y, at.z);
    if (dmg_chance(b, c->motor ? 0.7f : 0.25f))
        dmg_hinge(b, bars, "twist_grip", at, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.6f));
    dmg_rod(b, from, end, 1.5f * tube);
    for (int i = 0; i < 3 && dmg_chance(b, 0.7f); ++i)
        dmg_rod(b, beside(from, 0.01f + 0.04f * (float)i), beside(from, 0.02f + 0.04f * (float)i), 1.75f * tube);
    dmg_use(b, bars);
    if (dmg_chance(b, 0.85f)) draw_brake_lever(b, bars, at, reach, tube);
    if (!c->motor && dmg_chance(b, 0.5f)) { /* a thumb's shifter */
        dmg_vec pin = v3(reach - 0.23f, at.y + 1.3f * tube, at.z);
        dmg_rod(b, v3_add(pin, v3(0, -0.02f, 0)), v3_add(pin, v3(0, 0.012f, 0)), 0.018f);
        dmg_hinge(b, bars, "shifter", pin, v3(0, dmg_sign(b), 0), -0.5f, 0.5f);
        dmg_beam(b, v3_add(pin, v3(0, 0.018f, 0)), v3_add(pin, v3(0.02f, 0.02f, -0.05f)), 0.012f, 0.006f);
        dmg_use(b, bars);
    }
    if (dmg_chance(b, c->motor ? 0.7f : 0.15f)) {
        dmg_vec foot = v3(reach - 0.2f, at.y + tube, at.z),
                top = v3_add(foot, v3(0.06f, dmg_range(b, 0.1f, 0.18f), 0.02f));
        dmg_rod(b, foot, top, 0.005f);
        dmg_hinge(b, bars, "mirror", top, dmg_chance(b, 0.5f) ? v3(0, 1, 0) : v3(1, 0, 0), -0.4f, 0.4f);
        if (dmg_chance(b, 0.5f))
            dmg_rod(b, v3_add(top, v3(0.02f, 0.02f, 0.012f)), v3_add(top, v3(0.02f, 0.02f, -0.008f)), 0.05f);
        else
            dmg_rounded_box(b, v3_add(top, v3(0.03f, 0.02f, 0)), v3(0.12f, 0.07f, 0.024f), 0.01f);
        dmg_use(b, bars);
    }
}

/* Straight, raised or swept back; on a stem from the head. */
static void draw_bars(dmg_builder* b, const cycle* c, uint32_t fork) {
    float half = dmg_range(b, 0.25f, 0.4f), rise = dmg_range(b, 0.0f, 0.16f), sweep = dmg_range(b, -0.02f, 0.12f),
          tube = 0.8f * c->tube;
    dmg_vec stem = v3_add(v3_mad(c->head, c->steer, 0.04f), v3(0, 0, dmg_range(b, -0.02f, 0.08f)));
    dmg_rod(b, c->head, v3_mad(c->head, c->steer, 0.04f), 1.1f * c->tube);
    dmg_beam(b, v3_mad(c->head, c->steer, 0.035f), stem, 2.4f * tube, 2.4f * tube);
    dmg_vec grip = v3_add(stem, v3(0, rise, -sweep));
    dmg_rod(b, beside(stem, -0.07f), beside(stem, 0.07f), tube);
    for (int k = 0; k < 2; ++k) {
        dmg_save(b);
        if (k) dmg_mirror(b, v3(1, 0, 0));
        dmg_vec bend = v3(half - 0.26f, grip.y, grip.z);
        if (bend.x < 0.075f) bend.x = 0.075f;
        dmg_rod(b, beside(stem, 0.065f), bend, tube);
        dmg_rod(b, bend, v3(half, grip.y, grip.z), tube);
        draw_bar_end(b, c, fork, grip, half);
        dmg_restore(b);
    }
    if (!c->motor && dmg_chance(b, 0.5f)) {
        dmg_vec bell = v3(0.05f, stem.y + tube, stem.z);
        dmg_dome(b, v3_add(bell, v3(0, 0.004f, 0)), v3(0.026f, 0.02f, 0.026f));
        dmg_hinge(b, fork, "bell_lever", v3_add(bell, v3(0, 0, -0.02f)), v3(0, 1, 0), 0.0f, 0.6f);
        dmg_beam(b, v3_add(bell, v3(0.0f, 0.004f, -0.02f)), v3_add(bell, v3(0.0f, 0.004f, -0.065f)), 0.01f, 0.005f);
        dmg_use(b, fork);
    }
    if (dmg_chance(b, 0.5f)) dmg_ellipsoid(b, v3_add(stem, v3(0, -0.07f, 0.1f)), v3(0.07f, 0.07f, 0.06f));
}

/* Turns in the head; its legs stiff or telescopes, or the wheel is led by short links. */
static void draw_fork(dmg_builder* b, const cycle* c) {
    float half = 0.5f * c->width + 1.6f * c->tube + 0.02f, leg = v3_length(v3_sub(c->crown, c->front)),
          way = dmg_range(b, 0.05f, 0.12f);
    bool sprung = dmg_chance(b, c->motor ? 0.7f : 0.4f);
    uint32_t fork =
        dmg_chance(b, 0.9f) ? dmg_hinge(b, 0, "fork", c->crown, v3_scale(c->steer, dmg_sign(b)), -0.7f, 0.7f) : 0;
    dmg_beam(b, beside(c->crown, -half), beside(c->crown, half), 2.4f * c->tube, 2.2f * c->tube);
    dmg_rod(b, c->crown, v3_mad(c->head, c->steer, 0.01f), 0.9f * c->tube);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_rod(b, beside(c->crown, x), beside(sprung ? v3_mad(c->front, c->steer, 0.45f * leg) : c->front, x),
                (sprung ? 0.75f : 1.0f) * c->tube);
        if (c->motor) dmg_rod(b, beside(c->crown, x), beside(c->head, x), 0.9f * c->tube);
    }
    if (c->motor) dmg_beam(b, beside(c->head, -half), beside(c->head, half), 2.4f * c->tube, 2.0f * c->tube);
    draw_bars(b, c, fork);
    uint32_t legs = fork;
    if (sprung) legs = dmg_slide(b, fork, "fork_legs", c->steer, -0.3f * way, way);
    for (int s = -1; s <= 1 && sprung; s += 2)
        dmg_rod(b, beside(c->front, (float)s * half), beside(v3_mad(c->front, c->steer, 0.6f * leg), (float)s * half),
                1.25f * c->tube);
    dmg_rod(b, beside(c->front, -half), beside(c->front, half), 0.6f * c->tube);
    draw_cycle_wheel(b, c, legs, c->front, "front_wheel");
    if (!c->motor && dmg_chance(b, 0.5f)) { /* the lever that clamps its axle */
        dmg_vec end = beside(c->front, half + 1.3f * c->tube);
        dmg_hinge(b, legs, "axle_lever", end, v3(0, 0, 1), 0.0f, dmg_range(b, 1.5f, 3.1f));
        dmg_beam(b, end, v3_add(end, v3(0.004f, 0.06f, 0)), 0.012f, 0.008f);
        dmg_rod(b, end, beside(end, 0.01f), 0.01f);
    }
    dmg_use(b, 0);
}

/* ---- frame and rear ---- */

static void draw_frame(dmg_builder* b, const cycle* c) {
    dmg_vec low = v3_mad(c->crown, c->steer, 0.03f), seat = v3_add(c->saddle, v3(0, c->motor ? -0.06f : -0.14f, 0.02f));
    bool step = !c->motor && dmg_chance(b, 0.4f);
    dmg_rod(b, low, v3_mad(c->head, c->steer, -0.01f), 1.6f * c->tube);
    dmg_rod(b, c->bottom, low, 1.2f * c->tube);
    dmg_rod(b, c->bottom, seat, 1.1f * c->tube);
    if (!step) dmg_rod(b, v3_mad(c->head, c->steer, -0.05f), v3_lerp(c->bottom, seat, 0.9f), c->tube);
    dmg_rod(b, beside(c->bottom, -0.035f), beside(c->bottom, 0.035f), 1.8f * c->tube);
    if (!c->motor) return;
    dmg_rounded_box(b, v3_add(c->bottom, v3(0, 0.1f, 0.08f)), v3(0.24f, 0.28f, 0.36f), 0.05f);
    dmg_cone(b, v3_add(c->bottom, v3(0, 0.22f, 0.1f)), v3_add(c->bottom, v3(0, 0.36f, 0.16f)), 0.09f, 0.07f);
    dmg_ellipsoid(b, v3_add(v3_lerp(c->head, c->saddle, 0.45f), v3(0, 0.0f, 0)), v3(0.13f, 0.11f, 0.24f));
    dmg_rod(b, v3(0.16f, c->bottom.y, c->bottom.z + 0.1f), v3(0.18f, c->wheel, c->rear.z - 0.1f), 0.035f);
}

/* Stays fixed to the frame, or an arm on a pin that swings with the wheel. */
static void draw_rear(dmg_builder* b, const cycle* c) {
    float half = 0.5f * c->width + 1.4f * c->tube + 0.015f;
    dmg_vec pin = v3_add(c->bottom, v3(0, c->motor ? 0.06f : 0.05f, c->motor ? -0.12f : -0.03f));
    uint32_t arm = 0;
    if (dmg_chance(b, c->motor ? 0.65f : 0.25f)) {
        dmg_rod(b, beside(pin, -0.8f * half), beside(pin, 0.8f * half), 0.8f * c->tube);
        dmg_beam(b, c->bottom, pin, 0.04f, 0.05f);
        arm = dmg_hinge(b, 0, "swing_arm", pin, v3(dmg_sign(b), 0, 0), -0.12f, 0.12f);
    }
    dmg_vec seat = v3_add(c->saddle, v3(0, -0.2f, 0.03f));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half;
        dmg_beam(b, beside(pin, x), beside(c->rear, x), 1.2f * c->tube, (c->motor ? 2.4f : 1.4f) * c->tube);
        if (!arm) dmg_rod(b, beside(c->rear, x), beside(seat, 0.4f * x), 0.7f * c->tube);
    }
    dmg_rod(b, beside(pin, -half), beside(pin, half), 0.9f * c->tube);
    dmg_rod(b, beside(c->rear, -half), beside(c->rear, half), 0.6f * c->tube);
    draw_cycle_wheel(b, c, arm, c->rear, "rear_wheel");
    dmg_use(b, 0);
}

/* ---- feet ---- */

static void draw_cranks(dmg_builder* b, const cycle* c) {
    float arm = dmg_range(b, 0.14f, 0.18f), x = 0.06f, angle = dmg_range(b, 0.0f, 6.2f),
          ring = dmg_range(b, 0.05f, 0.09f);
    uint32_t crank = dmg_spin(b, 0, "crank", c->bottom, v3(1, 0, 0));
    dmg_rod(b, beside(c->bottom, -x), beside(c->bottom, x), 0.7f * c->tube);
    dmg_rod(b, beside(c->bottom, 0.04f), beside(c->bottom, 0.045f), ring);
    int pedal = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec root = beside(c->bottom, (float)s * x),
                end = v3_add(root, v3((float)s * 0.008f, (float)s * arm * sinf(angle), (float)s * arm * cosf(angle)));
        dmg_use(b, crank);
        dmg_beam(b, root, end, 0.012f, 0.022f);
        dmg_spin(b, crank, "pedal", end, v3(1, 0, 0));
        dmg_rod(b, end, beside(end, (float)s * 0.09f), 0.007f);
        if (pedal == 0) dmg_box(b, beside(end, (float)s * 0.055f), v3(0.08f, 0.022f, 0.07f));
        for (int k = -1; k <= 1 && pedal > 0; k += 2)
            dmg_box(b, v3_add(end, v3((float)s * 0.055f, 0, (float)k * 0.032f)),
                    v3(0.08f, 0.022f, pedal == 1 ? 0.012f : 0.03f));
        for (int k = 0; k < 2 && pedal == 1; ++k)
            dmg_box(b, beside(end, (float)s * (k ? 0.092f : 0.018f)), v3(0.008f, 0.018f, 0.076f));
    }
    dmg_use(b, 0);
}

/* Pegs that fold up, a lever for the gears before one, one for the brake before the other, a kick starter. */
static void draw_pegs(dmg_builder* b, const cycle* c) {
    float y = c->bottom.y - 0.02f, z = c->bottom.z - 0.1f;
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec root = {(float)s * 0.13f, y, z}, toe = {(float)s * 0.15f, y + 0.02f, z + 0.12f};
        dmg_box_span(b, v3(fminf(0, root.x), y - 0.015f, z - 0.02f), v3(fmaxf(0, root.x), y + 0.015f, z + 0.02f));
        dmg_hinge(b, 0, "foot_peg", root, v3(0, 0, (float)s), 0.0f, dmg_range(b, 0.7f, 1.4f));
        dmg_rod(b, root, beside(root, (float)s * 0.09f), 0.014f);
        dmg_use(b, 0);
        if (dmg_chance(b, 0.25f)) continue;
        dmg_rod(b, v3((float)s * 0.1f, toe.y, toe.z + 0.02f), v3((float)s * 0.13f, toe.y, toe.z + 0.02f), 0.012f);
        dmg_hinge(b, 0, s > 0 ? "brake_pedal" : "gear_pedal", v3(0, toe.y, toe.z + 0.02f), v3(1, 0, 0),
                  s > 0 ? 0.0f : -0.2f, 0.25f);
        dmg_rod(b, v3((float)s * 0.13f, toe.y, toe.z + 0.02f), v3((float)s * 0.142f, toe.y, toe.z + 0.02f), 0.018f);
        dmg_beam(b, v3((float)s * 0.136f, toe.y, toe.z + 0.02f), v3((float)s * 0.136f, toe.y + 0.01f, toe.z + 0.15f),
                 0.01f, 0.014f);
        dmg_rod(b, v3((float)s * 0.136f, toe.y + 0.01f, toe.z + 0.15f),
                v3((float)s * 0.19f, toe.y + 0.01f, toe.z + 0.15f), 0.009f);
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.5f)) return;
    dmg_vec pin = {0.12f, c->bottom.y + 0.1f, c->bottom.z};
    dmg_hinge(b, 0, "kick_starter", pin, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.6f));
    dmg_rod(b, beside(pin, -0.01f), beside(pin, 0.02f), 0.02f);
    dmg_beam(b, beside(pin, 0.015f), v3_add(pin, v3(0.03f, 0.18f, -0.04f)), 0.014f, 0.022f);
    dmg_rod(b, v3_add(pin, v3(0.025f, 0.18f, -0.04f)), v3_add(pin, v3(0.11f, 0.18f, -0.04f)), 0.011f);
    dmg_use(b, 0);
}

/* Draws one leg at the side, or two under the middle; down, they turn back and up. */
static void draw_stand(dmg_builder* b, const cycle* c) {
    bool both = dmg_chance(b, 0.35f);
    float x = 0.06f + (c->motor ? 0.09f : 0.0f), z = c->bottom.z - (c->motor ? 0.02f : 0.1f),
          spread = both ? 0.04f : 0.1f;
    dmg_vec pin = {-x, c->bottom.y - 0.06f, z};
    dmg_beam(b, v3_add(c->bottom, v3(0, -0.01f, 0)), v3(0, pin.y, z), 0.03f, 0.03f);
    dmg_rod(b, v3(both ? x : 0, pin.y, z), pin, 0.9f * c->tube);
    dmg_hinge(b, 0, "stand", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.6f));
    for (float s = -1.0f; s <= (both ? 1.0f : -1.0f); s += 2) {
        dmg_vec top = v3(s * x, pin.y, z), foot = v3(s * (x + spread), 0.01f, z + 0.04f);
        dmg_rod(b, beside(top, -0.018f), beside(top, 0.018f), 1.3f * c->tube);
        dmg_rod(b, top, foot, 0.75f * c->tube);
        dmg_box(b, foot, v3(0.05f, 0.016f, 0.07f));
    }
    if (both)
        dmg_rod(b, v3_lerp(v3(-x, pin.y, z), v3(-x - spread, 0.01f, z + 0.04f), 0.3f),
                v3_lerp(v3(x, pin.y, z), v3(x + spread, 0.01f, z + 0.04f), 0.3f), 0.7f * c->tube);
    dmg_use(b, 0);
}

/* ---- saddle and load ---- */

static void draw_bicycle_saddle(dmg_builder* b, const cycle* c) {
    dmg_vec seat = v3_add(c->saddle, v3(0, -0.14f, 0.02f)), way = v3_normalize(v3_sub(seat, c->bottom));
    if (dmg_chance(b, 0.5f)) { /* the clamp's lever */
        dmg_vec pin = v3_mad(seat, way, -0.02f);
        dmg_hinge(b, 0, "saddle_clamp", v3_add(pin, v3(1.4f * c->tube, 0, 0)), v3(0, 1, 0), 0.0f,
                  dmg_range(b, 1.2f, 2.6f));
        dmg_beam(b, v3_add(pin, v3(1.5f * c->tube, 0, 0)), v3_add(pin, v3(1.5f * c->tube, 0, -0.06f)), 0.008f, 0.014f);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.8f)) dmg_slide(b, 0, "saddle", way, -0.03f, dmg_range(b, 0.04f, 0.12f));
    dmg_rod(b, v3_mad(seat, way, -0.15f), v3_mad(seat, way, 0.12f), 0.75f * c->tube);
    dmg_vec top = v3_mad(seat, way, 0.14f);
    dmg_ellipsoid(b, v3_add(top, v3(0, 0, -0.06f)), v3(0.08f, 0.03f, 0.08f));
    dmg_ellipsoid(b, v3_add(top, v3(0, 0.005f, 0.05f)), v3(0.035f, 0.025f, 0.11f));
    dmg_use(b, 0);
}

static void draw_motor_saddle(dmg_builder* b, const cycle* c) {
    float length = dmg_range(b, 0.4f, 0.65f), wide = dmg_range(b, 0.2f, 0.3f), t = dmg_range(b, 0.06f, 0.1f);
    float z1 = c->saddle.z + 0.3f * length, z0 = z1 - length, y = c->saddle.y;
    int kind = dmg_int(b, 0, 3);
    dmg_box_span(b, v3(-0.4f * wide, y - 0.07f, z0), v3(0.4f * wide, y, z1));
    if (kind == 0) dmg_hinge(b, 0, "saddle", v3(0, y, z1), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.3f));
    if (kind == 1) dmg_hinge(b, 0, "saddle", v3(-0.45f * wide, y, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.7f, 1.4f));
    if (kind == 2) dmg_hinge(b, 0, "saddle", v3(0, y, z0), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.0f));
    dmg_rounded_box(b, v3(0, y + 0.5f * t, 0.5f * (z0 + z1)), v3(wide, t, length), 0.3f * t);
    dmg_use(b, 0);
    dmg_vec cap = v3_add(v3_lerp(c->head, c->saddle, 0.45f), v3(0, 0.108f, 0.02f));
    if (dmg_chance(b, 0.5f))
        dmg_hinge(b, 0, "tank_cap", v3_add(cap, v3(0, 0.004f, 0.035f)), v3(1, 0, 0), 0.0f, dmg_range(b, 0.9f, 1.7f));
    else
        dmg_spin(b, 0, "tank_cap", cap, v3(0, 1, 0));
    dmg_rod(b, v3_add(cap, v3(0, -0.005f, 0)), v3_add(cap, v3(0, 0.014f, 0)), 0.03f);
    dmg_box(b, v3_add(cap, v3(0, 0.018f, 0)), v3(0.012f, 0.012f, 0.04f));
    dmg_use(b, 0);
}

/* Draws a box on the rack behind the saddle, or one on each side of the wheel; lids on one edge. */
static void draw_boxes(dmg_builder* b, const cycle* c) {
    bool sides = dmg_chance(b, 0.5f);
    float high = dmg_range(b, 0.15f, 0.3f), deep = dmg_range(b, 0.22f, 0.36f),
          wide = sides ? dmg_range(b, 0.12f, 0.2f) : dmg_range(b, 0.26f, 0.42f);
    float rack = fmaxf(2 * c->wheel + 0.07f, c->saddle.y - 0.22f), z = c->rear.z - 0.02f, t = 0.02f;
    int edge = dmg_int(b, 0, 2);
    dmg_box_span(b, v3(-0.06f, rack - 0.02f, z - 0.18f), v3(0.06f, rack, c->saddle.z + 0.1f));
    dmg_beam(b, v3(0, rack - 0.01f, c->saddle.z + 0.08f), v3_lerp(c->bottom, c->saddle, 0.6f), 0.03f, 0.03f);
    for (int k = sides ? -1 : 0; k <= 1; k += 2) {
        float x = (float)k * (0.5f * wide + 0.5f * c->width + 0.06f), y = sides ? rack - high : rack;
        if (!sides && k) break;
        dmg_save(b);
        dmg_move(b, x, y + high, z);
        dmg_face_up(b);
        dmg_case_draw(b, dmg_chance(b, 0.6f) ? DMG_CASE_BOARDS : DMG_CASE_SOLID, wide, deep, high, 0.012f);
        dmg_restore(b);
        float top = y + high, out = x < 0 ? -1.0f : 1.0f;
        if (edge == 0)
            dmg_hinge(b, 0, "case_lid", v3(x, top + 0.003f, z + 0.5f * deep), v3(1, 0, 0), 0.0f,
                      dmg_range(b, 0.8f, 1.5f));
        if (edge == 1)
            dmg_hinge(b, 0, "case_lid", v3(x, top + 0.003f, z - 0.5f * deep), v3(-1, 0, 0), 0.0f,
                      dmg_range(b, 0.8f, 1.9f));
        if (edge == 2)
            dmg_hinge(b, 0, "case_lid", v3(x - out * 0.5f * wide, top + 0.003f, z), v3(0, 0, out), 0.0f,
                      dmg_range(b, 0.8f, 1.5f));
        dmg_rounded_box(b, v3(x, top + 0.5f * t + 0.002f, z), v3(wide + 0.006f, t, deep + 0.006f), 0.3f * t);
        dmg_use(b, 0);
    }
}

void dmg_build_cycle(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.75f) ? 1.0f : dmg_scale_range(b, 0.1f, 0.7f));
    cycle c = pick_cycle(b);
    draw_frame(b, &c);
    draw_rear(b, &c);
    draw_fork(b, &c);
    if (c.motor) draw_pegs(b, &c);
    if (!c.motor) draw_cranks(b, &c);
    if (dmg_chance(b, 0.8f)) draw_stand(b, &c);
    if (c.motor) draw_motor_saddle(b, &c);
    if (!c.motor) draw_bicycle_saddle(b, &c);
    if (dmg_chance(b, 0.4f)) draw_boxes(b, &c);
}
