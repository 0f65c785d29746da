/* Draws hand-operated lifting gear: scissor, bottle and trolley jacks, engine hoists; winches, chain blocks,
 * windlasses, hose reels. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- jacks ---- */

/* Draws four arms in a rhombus, a screw across its waist with an eye or a crank at its end. */
static void draw_rhombus_jack(dmg_builder* b, float size) {
    float angle = dmg_range(b, 0.35f, 0.9f), arm = 0.5f * size, t = 0.03f * size,
          half = size * dmg_range(b, 0.08f, 0.13f), y0 = 2 * t, x0 = 0.06f * size, play = dmg_range(b, 0.12f, 0.25f);
    dmg_box_span(b, v3(-0.22f * size, 0, -1.6f * half), v3(0.22f * size, 0.5f * t, 1.6f * half));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.15f * size, 0, (float)s * 1.35f * half - 0.3f * t),
                     v3(0.15f * size, y0 + t, (float)s * 1.35f * half + 0.3f * t));
    float x1 = x0 + arm * cosf(angle), y1 = y0 + arm * sinf(angle), y2 = 2 * y1 - y0;
    uint32_t lower = 0, upper = 0;
    for (int s = -1; s <= 1; s += 2) { /* each upper arm hangs on the lower one below it */
        float side = (float)s;
        dmg_vec foot = v3(side * x0, y0, 0), waist = v3(side * x1, y1, 0), head = v3(side * x0, y2, 0);
        lower = dmg_hinge(b, 0, "lower_arm", foot, v3(0, 0, side), -play, play);
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3_add(foot, v3(0, 0, half * (float)k)), v3_add(waist, v3(0, 0, half * (float)k)), 0.4f * t,
                     2 * t);
        dmg_rod(b, v3_add(foot, v3(0, 0, -1.6f * half)), v3_add(foot, v3(0, 0, 1.6f * half)), 0.5f * t);
        dmg_rod(b, v3_add(waist, v3(0, 0, -1.1f * half)), v3_add(waist, v3(0, 0, 1.1f * half)), 1.2f * t);
        upper = dmg_hinge(b, lower, "upper_arm", waist, v3(0, 0, -side), -play, play);
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3_add(waist, v3(0, 0, 0.75f * half * (float)k)),
                     v3_add(head, v3(0, 0, 0.75f * half * (float)k)), 0.4f * t, 2 * t);
    }
    dmg_hinge(b, upper, "saddle", v3(x0, y2, 0), v3(0, 0, 1), -play, play);
    dmg_box_span(b, v3(-0.12f * size, y2 + 0.5f * t, -1.2f * half), v3(0.12f * size, y2 + 1.5f * t, 1.2f * half));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.1f * size, y2 - t, (float)s * half - 0.2f * t),
                     v3(0.1f * size, y2 + t, (float)s * half + 0.2f * t));
    dmg_spin(b, lower, "screw", v3(0, y1, 0), v3(1, 0, 0));
    dmg_rod(b, v3(-x1 - 2 * t, y1, 0), v3(x1 + 4 * t, y1, 0), 0.6f * t);
    if (dmg_chance(b, 0.5f))
        dmg_torus(b, v3(x1 + 5.5f * t, y1, 0), v3(0, 0, 1), 1.5f * t, 0.4f * t);
    else {
        dmg_beam(b, v3(x1 + 4 * t, y1 - 0.5f * t, 0), v3(x1 + 4 * t, y1 + 6 * t, 0), t, t);
        dmg_rod(b, v3(x1 + 4 * t, y1 + 5.5f * t, 0), v3(x1 + 10 * t, y1 + 5.5f * t, 0), 0.7f * t);
    }
    dmg_use(b, 0);
}

/* Draws a ram in a cylinder, a screw in the ram, a pump with a socket for its lever, a valve. */
static void draw_bottle_jack(dmg_builder* b, float tall) {
    float r = tall * dmg_range(b, 0.16f, 0.25f), base = 0.08f * tall, top = 0.85f * tall,
          z = r * dmg_range(b, 1.4f, 1.8f), pump = 0.22f * r, lever = tall * dmg_range(b, 0.8f, 2.2f),
          lift = dmg_range(b, 0.4f, 0.6f), turns = dmg_range(b, 12.0f, 38.0f), way = tall * dmg_range(b, 0.3f, 0.6f);
    bool screw = dmg_chance(b, 0.7f), handle = dmg_chance(b, 0.7f), toe = dmg_chance(b, 0.25f);
    dmg_box_span(b, v3(-1.4f * r, 0, -1.4f * r), v3(1.4f * r, base, z + r));
    const dmg_xy body[] = {{0, base}, {r, base}, {r, 0.93f * top}, {0.8f * r, 0.95f * top}, {0.8f * r, top}, {0, top}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 6);
    dmg_rod(b, v3(0, base, z), v3(0, 0.4f * tall, z), 0.4f * r);
    uint32_t ram = dmg_slide(b, 0, "ram", v3(0, 1, 0), 0.0f, way);
    dmg_rest(b, ram, dmg_chance(b, 0.5f) ? 0.0f : way * dmg_unit(b));
    dmg_rod(b, v3(0, top - 0.6f * way, 0), v3(0, top + 0.04f * tall, 0), 0.55f * r);
    if (toe) { /* a claw that lifts from near the floor */
        dmg_box_span(b, v3(-0.6f * r, top + 0.01f * tall, -1.5f * r), v3(0.6f * r, top + 0.06f * tall, 0.6f * r));
        dmg_box_span(b, v3(-0.6f * r, 2 * base, -1.7f * r), v3(0.6f * r, top + 0.06f * tall, -1.45f * r));
        dmg_box_span(b, v3(-0.6f * r, 1.2f * base, -2.6f * r), v3(0.6f * r, 2 * base, -1.45f * r));
    }
    if (screw) dmg_screw(b, ram, "extension", v3(0, 0, 0), v3(0, 1, 0), 0.25f * tall / turns, 0.0f, turns);
    dmg_rod(b, v3(0, top - 0.2f * tall, 0), v3(0, top + 0.1f * tall, 0), 0.3f * r);
    dmg_cone(b, v3(0, top + 0.08f * tall, 0), v3(0, top + 0.13f * tall, 0), 0.5f * r, 0.6f * r);
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.5f * r - 0.08f * r, base, z + 0.4f * r),
                     v3((float)s * 0.5f * r + 0.08f * r, 0.5f * tall, z + 0.8f * r));
    dmg_vec pin = v3(0, 0.47f * tall, z + 0.6f * r);
    uint32_t socket = dmg_hinge(b, 0, "socket", pin, v3(-1, 0, 0), -0.3f, lift);
    dmg_beam(b, v3(0, pin.y, z + 0.2f * r), v3(0, pin.y, z + 0.9f * r), 0.5f * r, 0.4f * r);
    dmg_rod(b, v3(0, pin.y, z + 0.8f * r), v3(0, pin.y + 0.15f * r, z + 2.2f * r), 0.28f * r);
    if (handle) {
        if (dmg_chance(b, 0.5f)) dmg_slide(b, socket, "lever", v3_normalize(v3(0, 0.15f, 1.4f)), 0.0f, 0.9f * r);
        dmg_vec way_out = v3(0, 0.15f * r, 1.4f * r), from = v3(0, pin.y + 0.05f * r, z + 1.27f * r);
        dmg_rod(b, from, v3_mad(from, v3_normalize(way_out), lever), 0.2f * r);
    }
    dmg_use(b, 0);
    dmg_spin(b, 0, "valve", v3(-0.9f * r, 0.6f * base, 0), v3(0, 0, 1));
    dmg_rod(b, v3(-0.9f * r, 0.6f * base, z + r), v3(-0.9f * r, 0.6f * base, z + 1.4f * r), pump);
    dmg_box(b, v3(-0.9f * r, 0.6f * base, z + 1.45f * r), v3(0.5f * r, 0.1f * r, 0.15f * r));
    dmg_use(b, 0);
}

/* Draws a wheel under a fork that swivels about the upright line through `at`, whose y is the mount. */
static void draw_castor(dmg_builder* b, uint32_t parent, dmg_vec at, float r) {
    float trail = r * dmg_range(b, 0.3f, 0.6f);
    uint32_t fork = dmg_spin(b, parent, "castor", at, v3(0, 1, 0));
    dmg_rod(b, v3(at.x, at.y - 0.3f * r, at.z), at, 0.6f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3(at.x + 0.5f * r * (float)s, at.y - 0.2f * r, at.z),
                 v3(at.x + 0.5f * r * (float)s, r, at.z - trail), 0.12f * r, 0.5f * r);
    dmg_spin(b, fork, "wheel", v3(0, r, at.z - trail), v3(1, 0, 0));
    dmg_rod(b, v3(at.x - 0.35f * r, r, at.z - trail), v3(at.x + 0.35f * r, r, at.z - trail), r);
    dmg_rod(b, v3(at.x - 0.6f * r, r, at.z - trail), v3(at.x + 0.6f * r, r, at.z - trail), 0.25f * r);
    dmg_use(b, parent);
}

/* Low on wheels between two plates: an arm whose saddle turns, a long lever at the rear that pumps and, turned, lets
 * down. */
static void draw_trolley_jack(dmg_builder* b, float span) {
    float half = span * dmg_range(b, 0.13f, 0.2f), t = 0.02f * span, r = span * dmg_range(b, 0.06f, 0.09f),
          tall = span * dmg_range(b, 0.18f, 0.26f), z0 = -0.5f * span, z1 = 0.5f * span,
          lift = dmg_range(b, 0.5f, 0.9f), lever = span * dmg_range(b, 0.8f, 1.6f), lean = dmg_range(b, 0.3f, 1.2f);
    const dmg_xy plate[] = {{z0, 0.6f * r},           {z1, 0.6f * r},   {z1, 1.5f * r}, {0.1f * span, tall * 0.7f},
                            {z0 + 0.1f * span, tall}, {z0, 0.8f * tall}};
    for (int s = -1; s <= 1; s += 2)
        dmg_side_prism(b, plate, 6, (float)s * half - 0.5f * t, (float)s * half + 0.5f * t);
    dmg_rod(b, v3(-half, r, z1 - r), v3(half, r, z1 - r), 0.25f * r);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (half + 0.1f * span * 0.5f);
        dmg_spin(b, 0, "wheel", v3(0, r, z1 - r), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.035f * span, r, z1 - r), v3(x + 0.035f * span, r, z1 - r), r);
        dmg_use(b, 0);
        dmg_box_span(b, v3(fminf((float)s * half, x * 1.1f), 2.1f * r, z0),
                     v3(fmaxf((float)s * half, x * 1.1f), 2.1f * r + t, z0 + 2 * r));
        draw_castor(b, 0, v3(x, 2.1f * r, z0 + r), 0.8f * r);
    }
    dmg_rod(b, v3(0, 1.3f * r, z0 + 0.1f * span), v3(0, 1.5f * r, 0), 0.6f * half);
    dmg_vec pin = v3(0, tall * 0.72f, -0.05f * span), end = v3(0, 1.6f * r, z1 - 1.2f * r);
    uint32_t arm = dmg_hinge_across(b, 0, "arm", pin, 0.0f, lift);
    if (dmg_chance(b, 0.5f))
        dmg_rest(b, arm, dmg_range(b, b->parts[arm - 1].joint.lower, b->parts[arm - 1].joint.upper));
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3_add(pin, v3((float)s * 0.7f * half, 0, 0)), v3_add(end, v3((float)s * 0.5f * half, 0, 0)), t,
                 1.1f * r);
    dmg_rod(b, v3(-0.9f * half, pin.y, pin.z), v3(0.9f * half, pin.y, pin.z), 0.35f * r);
    dmg_rod(b, v3(-0.55f * half, end.y, end.z), v3(0.55f * half, end.y, end.z), 0.35f * r);
    if (dmg_chance(b, 0.6f)) arm = dmg_hinge_across(b, arm, "cradle", end, -lift, 0.1f);
    dmg_rod(b, v3(0, end.y, end.z), v3(0, end.y + 0.9f * r, end.z), 0.35f * half);
    if (dmg_chance(b, 0.7f)) dmg_spin(b, arm, "saddle", end, v3(0, 1, 0));
    dmg_cone(b, v3(0, end.y + 0.9f * r, end.z), v3(0, end.y + 1.3f * r, end.z), 0.45f * half, 0.6f * half);
    for (int i = 0; i < 4; ++i)
        dmg_box(b, v3((i & 1 ? 0.3f : -0.3f) * half, end.y + 1.4f * r, end.z + (i & 2 ? 0.3f : -0.3f) * half),
                v3(0.15f * half, 0.4f * r, 0.15f * half));
    dmg_vec yoke = v3(0, 0.7f * tall, z0 + 0.06f * span), out = v3(0, sinf(lean), -cosf(lean));
    uint32_t pump = dmg_hinge(b, 0, "lever", yoke, v3(1, 0, 0), -0.5f * lean, fmaxf(1.4f - lean, 0.3f));
    dmg_rod(b, v3(-0.9f * half, yoke.y, yoke.z), v3(0.9f * half, yoke.y, yoke.z), 0.35f * r);
    dmg_rod(b, yoke, v3_mad(yoke, out, 0.3f * lever), 0.45f * r);
    if (dmg_chance(b, 0.5f)) dmg_hinge(b, pump, "release", yoke, out, 0.0f, 1.5f);
    dmg_rod(b, v3_mad(yoke, out, 0.25f * lever), v3_mad(yoke, out, lever), 0.3f * r);
    dmg_rod(b, v3_mad(v3_mad(yoke, out, 0.93f * lever), v3(1, 0, 0), -0.5f * half),
            v3_mad(v3_mad(yoke, out, 0.93f * lever), v3(1, 0, 0), 0.5f * half), 0.3f * r);
    dmg_use(b, 0);
}

/* Draws a hook with its latch, hanging below `at`; it swivels and swings there. */
static void draw_hook(dmg_builder* b, uint32_t parent, dmg_vec at, float r, bool turns) {
    uint32_t hook = parent;
    if (turns && dmg_chance(b, 0.7f))
        hook = dmg_spin(b, parent, "hook", at, v3(0, 1, 0));
    else if (turns)
        hook = dmg_hinge(b, parent, "hook", at, v3(0, 0, 1), -0.6f, 0.6f);
    const dmg_vec bend[] = {v3_add(at, v3(0, 0.2f * r, 0)),          v3_add(at, v3(0, -0.8f * r, 0)),
                            v3_add(at, v3(-0.8f * r, -1.5f * r, 0)), v3_add(at, v3(-0.5f * r, -2.5f * r, 0)),
                            v3_add(at, v3(0.4f * r, -2.6f * r, 0)),  v3_add(at, v3(0.9f * r, -1.7f * r, 0))};
    dmg_sweep(b, bend, 6, 0.28f * r, 0.24f * r, false);
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, hook, "latch", v3_add(at, v3(0, -0.9f * r, 0)), v3(0, 0, -1), 0.0f, 0.6f);
        dmg_beam(b, v3_add(at, v3(0.1f * r, -0.9f * r, 0)), v3_add(at, v3(0.75f * r, -1.7f * r, 0)), 0.3f * r,
                 0.1f * r);
    }
    dmg_use(b, parent);
}

/* Draws a mast on two long legs, a boom with an extension and a chain, a ram below it; the legs fold up. */
static void draw_engine_hoist(dmg_builder* b) {
    float tall = dmg_range(b, 1.3f, 1.7f), t = 0.07f, r = dmg_range(b, 0.05f, 0.09f), half = dmg_range(b, 0.3f, 0.45f),
          legs = dmg_range(b, 1.1f, 1.6f), reach = dmg_range(b, 0.8f, 1.2f), lift = dmg_range(b, 0.4f, 0.8f),
          low = 2.2f * r, y = 0.95f * tall, splay = dmg_range(b, 0.0f, 0.3f);
    bool folds = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-half - t, low, -t), v3(half + t, low + t, t));
    dmg_box_span(b, v3(-0.5f * t, low + t, -0.5f * t), v3(0.5f * t, tall, 0.5f * t));
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * half, x1 = (float)s * (half + splay);
        dmg_use(b, 0);
        draw_castor(b, 0, v3(x, low, 0), r);
        dmg_beam(b, v3(0.5f * x, low + t, 0), v3(0, 0.6f * tall, 0), 0.4f * t, 0.5f * t);
        uint32_t leg = folds ? dmg_hinge_across(b, 0, "leg", v3(x, low + 0.5f * t, t), 0.0f, 1.5f) : 0;
        dmg_beam(b, v3(x, low + 0.5f * t, t), v3(x1, low + 0.5f * t, legs), t, t);
        draw_castor(b, leg, v3(x1, low, 0.95f * legs), r);
    }
    dmg_use(b, 0);
    dmg_vec pin = v3(0, y, 0), end = v3(0, y + 0.05f, reach);
    uint32_t boom = dmg_hinge_across(b, 0, "boom", pin, -0.2f, lift);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.75f * t - 0.2f * t, y - 0.6f * t, -0.7f * t),
                     v3((float)s * 0.75f * t + 0.2f * t, y + 0.9f * t, 0.25f * reach));
    dmg_beam(b, v3(0, y + 0.3f * t, 0.12f * reach), end, t, t);
    dmg_ram_kind kind = dmg_ram_pick(b);
    dmg_ram_draw(b, kind, 0, boom, v3(0, 0.5f * tall, 0.6f * t), v3(0, y - 0.3f * t, 0.22f * reach), 0.35f * t);
    dmg_use(b, boom);
    uint32_t jib = dmg_slide(b, boom, "jib", v3_normalize(v3_sub(end, pin)), 0.0f, 0.5f * reach);
    dmg_beam(b, v3_lerp(pin, end, 0.5f), v3_lerp(pin, end, 1.2f), 0.75f * t, 0.75f * t);
    dmg_vec tip = v3_lerp(pin, end, 1.17f);
    dmg_rod(b, tip, v3(0, tip.y - 0.18f, tip.z), 0.012f);
    draw_hook(b, jib, v3(0, tip.y - 0.18f, tip.z), 0.035f, true);
    dmg_use(b, 0);
    dmg_hinge(b, 0, "pump", v3(0, 0.55f * tall, -0.5f * t), v3(1, 0, 0), 0.0f, 0.9f);
    dmg_rod(b, v3(0, 0.55f * tall, -0.4f * t), v3(0, 0.62f * tall, -0.45f), 0.015f);
    dmg_use(b, 0);
}

void dmg_build_scissor_jack(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.25f, 0.6f);
    switch (dmg_int(b, 0, 3)) {
    case 0:
        draw_rhombus_jack(b, size);
        break;
    case 1:
        draw_bottle_jack(b, 0.6f * size);
        break;
    case 2:
        draw_trolley_jack(b, 1.2f * size);
        break;
    default:
        draw_engine_hoist(b);
        break;
    }
}

/* ---- winches ---- */

/* Flanges and windings about X, `half` long to both sides. */
static void draw_drum(dmg_builder* b, dmg_vec at, float r, float half, bool rope) {
    float t = 0.08f * half + 0.05f * r;
    const dmg_xy spool[] = {{0, -half},           {r, -half},    {r, -half + t}, {0.5f * r, -half + t},
                            {0.5f * r, half - t}, {r, half - t}, {r, half},      {0, half}};
    dmg_lathe(b, at, v3(1, 0, 0), spool, 8);
    int turns = dmg_int(b, 4, 8);
    for (int i = 0; i < turns && rope; ++i) {
        float x = (half - 1.2f * t) * (((float)i + 0.5f) * 2 / (float)turns - 1),
              tube = (half - t) / (float)turns * 0.9f;
        dmg_torus(b, v3(at.x + x, at.y, at.z), v3(1, 0, 0), 0.5f * r + 0.5f * tube, fminf(tube, 0.25f * r));
    }
}

/* Draws a crank on a shaft out along +X from `at`: its grip turns, or it folds. */
static void draw_winch_crank(dmg_builder* b, uint32_t parent, dmg_vec at, float arm, float t) {
    float start = dmg_range(b, 0.0f, 6.28f);
    bool loose = dmg_chance(b, 0.5f), alone = parent == 0;
    uint32_t crank = parent;
    if (alone) crank = dmg_spin(b, 0, "crank", at, v3(dmg_sign(b), 0, 0));
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_turn(b, v3(1, 0, 0), start);
    dmg_rod(b, v3(0, 0, 0), v3(3 * t, 0, 0), 0.8f * t);
    dmg_beam(b, v3(2.6f * t, -t, 0), v3(2.6f * t, arm, 0), 1.6f * t, 0.6f * t);
    if (loose) dmg_spin(b, crank, "grip", v3(0, 0.93f * arm, 0), v3(1, 0, 0));
    dmg_rod(b, v3(3 * t, 0.93f * arm, 0), v3(3 * t + 0.5f * arm, 0.93f * arm, 0), t);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Drum between cheeks, a pinion with the crank beside its gear, a pawl; rope with a hook. */
static void draw_hand_winch(dmg_builder* b, float size) {
    float half = size * dmg_range(b, 0.25f, 0.5f), r = size * dmg_range(b, 0.28f, 0.4f), t = 0.03f * size,
          y = r * 1.25f + t, up = y + 0.35f * size, z = 0.3f * size;
    bool geared = dmg_chance(b, 0.6f), rope = dmg_chance(b, 0.7f), motor = dmg_chance(b, 0.25f);
    const dmg_xy cheek[] = {
        {-0.5f * size, 0}, {0.5f * size, 0}, {0.45f * size, up}, {0.1f * size, up + 2 * t}, {-0.3f * size, y + 2 * t}};
    dmg_box_span(b, v3(-half - 2 * t, 0, -0.5f * size), v3(half + 2 * t, t, 0.5f * size));
    for (int s = -1; s <= 1; s += 2)
        dmg_side_prism(b, cheek, 5, (float)s * (half + 1.5f * t) - 0.5f * t, (float)s * (half + 1.5f * t) + 0.5f * t);
    uint32_t drum = dmg_spin(b, 0, "drum", v3(0, y, 0), v3(dmg_sign(b), 0, 0));
    draw_drum(b, v3(0, y, 0), r, half, rope);
    dmg_rod(b, v3(-half - 3 * t, y, 0), v3(half + 3 * t, y, 0), 1.2f * t);
    if (geared) {
        dmg_save(b);
        dmg_move(b, half + 3.5f * t, y, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, 4, 0.75f * r, t, 8);
        dmg_restore(b);
    }
    float arm = size * dmg_range(b, 0.6f, 1.1f);
    dmg_use(b, 0);
    if (motor) {
        dmg_rod(b, v3(-half - 2 * t, y, 0), v3(-half - 0.9f * size, y, 0), 0.7f * r);
        dmg_box_span(b, v3(-half, up, -0.2f * size), v3(half, up + 0.3f * size, 0.3f * size));
    } else if (geared)
        draw_winch_crank(b, 0, v3(half + 2 * t, up - 2 * t, z), arm, 1.2f * t);
    else
        draw_winch_crank(b, drum, v3(half + 3 * t, y, 0), arm, 1.2f * t);
    dmg_hinge(b, 0, motor ? "clutch" : "pawl", v3(0, up - t, -0.1f * size), v3(1, 0, 0), -0.4f, 0.4f);
    dmg_rod(b, v3(half + 0.9f * t, up - 2 * t, -0.05f * size), v3(half + 6 * t, up - 2 * t, -0.05f * size), 0.6f * t);
    dmg_beam(b, v3(half + 5.5f * t, up - 2 * t, -0.05f * size), v3(half + 5.5f * t, up + 2 * t, -0.22f * size),
             1.2f * t, t);
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.5f)) return;
    dmg_slide(b, 0, "rope", v3(0, 0, 1), 0.0f, size * dmg_range(b, 0.5f, 2.0f)); /* pulled off the drum */
    dmg_rod(b, v3(0.2f * half, y + 0.75f * r, 0), v3(0.2f * half, y + 0.75f * r, 0.8f * size), 0.02f * size);
    dmg_torus(b, v3(0.2f * half, y + 0.75f * r, 0.86f * size), v3(1, 0, 0), 0.06f * size, 0.02f * size);
    dmg_use(b, 0);
}

/* Hung by its upper hook from a beam: hand wheel and chains, or motor and pendant; the block below goes down. */
static void draw_chain_block(dmg_builder* b, float size) {
    float y = 4 * size, r = 0.3f * size, half = 0.22f * size, drop = size * dmg_range(b, 1.0f, 2.2f),
          link = 0.03f * size;
    bool motor = dmg_chance(b, 0.4f), trolley = dmg_chance(b, 0.4f), lever = dmg_chance(b, 0.4f) && !motor;
    float beam = y + 1.35f * size;
    dmg_box_span(b, v3(-1.6f * size, beam, -0.05f * size), v3(1.6f * size, beam + 0.4f * size, 0.05f * size));
    dmg_box_span(b, v3(-1.6f * size, beam, -0.25f * size), v3(1.6f * size, beam + 0.06f * size, 0.25f * size));
    uint32_t body = trolley ? dmg_slide(b, 0, "trolley", v3(1, 0, 0), -size, size) : 0;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(-0.25f * size, beam - 0.5f * size, 0.3f * size * (float)s - 0.03f * size),
                     v3(0.25f * size, beam + 0.3f * size, 0.3f * size * (float)s + 0.03f * size));
    dmg_box_span(b, v3(-0.06f * size, beam - 0.5f * size, -0.33f * size),
                 v3(0.06f * size, beam - 0.4f * size, 0.33f * size));
    if (dmg_chance(b, 0.5f))
        body = dmg_hinge(b, body, "block", v3(0, beam - 0.45f * size, 0), v3(0, 0, 1), -0.4f, 0.4f);
    dmg_box_span(b, v3(-0.07f * size, y + 0.25f * size, -0.07f * size),
                 v3(0.07f * size, beam - 0.47f * size, 0.07f * size));
    if (motor) {
        dmg_rod(b, v3(-0.6f * size, y, 0), v3(0.7f * size, y, 0), r);
        dmg_box(b, v3(0, y + 0.1f * size, 0), v3(0.5f * size, 0.7f * size, 0.7f * size));
    } else
        dmg_rod(b, v3(0, y, -half), v3(0, y, half), 1.2f * r);
    if (!motor && !lever) {
        dmg_spin(b, body, "hand_wheel", v3(0, y, 0), v3(0, 0, 1));
        dmg_torus(b, v3(0, y, 1.3f * half), v3(0, 0, 1), 0.9f * r, 0.15f * r);
        dmg_rod(b, v3(0, y, 1.05f * half), v3(0, y, 1.4f * half), 0.85f * r);
        dmg_use(b, body);
    }
    if (lever) {
        dmg_hinge(b, body, "lever", v3(0, y, 0), v3(0, 0, dmg_sign(b)), -1.2f, 1.2f);
        dmg_rod(b, v3(0, y, 1.05f * half), v3(0, y, 1.5f * half), 0.6f * r);
        dmg_beam(b, v3(0, y, 1.35f * half), v3(0.3f * size, y - size, 1.35f * half), 0.1f * size, 0.08f * size);
        dmg_use(b, body);
    }
    float low = y - 0.3f * size - drop;
    bool twin = dmg_chance(b, 0.5f);
    for (int s = twin ? -1 : 1; s <= 1; s += 2) /* the chain stays: the block climbs it */
        dmg_rod(b, v3(2 * link * (float)s, low, 0), v3(2 * link * (float)s, y - 0.8f * r, 0), link);
    uint32_t load = dmg_slide(b, body, "load", v3(0, 1, 0), 0.0f, 0.6f * drop);
    dmg_rounded_box(b, v3(0, low - 0.1f * size, 0), v3(0.3f * size, 0.35f * size, 0.2f * size), 0.04f * size);
    draw_hook(b, load, v3(0, low - 0.28f * size, 0), 0.15f * size, true);
    dmg_use(b, 0);
}

/* Draws a deck windlass: an upright capstan with its bars, or a level drum with warping ends, band brakes and dog
 * clutches. */
static void draw_windlass(dmg_builder* b, float size) {
    bool upright = dmg_chance(b, 0.45f), gypsy = dmg_chance(b, 0.6f);
    float r = 0.3f * size, y = 0.55f * size, half = 0.35f * size, t = 0.05f * size;
    dmg_box_span(b, v3(-0.7f * size, 0, -0.5f * size), v3(0.7f * size, t, 0.5f * size));
    if (upright) {
        int bars = dmg_int(b, 0, 6);
        float top = size * dmg_range(b, 0.8f, 1.1f), arm = size * dmg_range(b, 0.8f, 1.4f);
        const dmg_xy waist[] = {{0, 2 * t},
                                {1.3f * r, 2 * t},
                                {1.2f * r, 4 * t},
                                {0.8f * r, 0.5f * top},
                                {1.05f * r, 0.8f * top},
                                {1.4f * r, 0.82f * top},
                                {1.3f * r, top},
                                {0, top}};
        dmg_rod(b, v3(0, t, 0), v3(0, 1.95f * t, 0), 1.5f * r);
        uint32_t barrel = dmg_spin(b, 0, "capstan", v3(0, 0, 0), v3(0, 1, 0));
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), waist, 8);
        for (int i = 0; i < bars; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, bars);
            dmg_slide(b, barrel, "bar", v3(1, 0, 0), 0.0f, 0.45f * r);
            dmg_rod(b, v3(0.8f * r, 0.91f * top, 0), v3(arm, 0.91f * top, 0), 0.09f * r);
            dmg_restore(b);
        }
        dmg_use(b, 0);
        dmg_hinge(b, 0, "pawl", v3(1.9f * r, t, 0), v3(0, 1, 0), 0.0f, 0.7f);
        dmg_rod(b, v3(1.9f * r, t, 0), v3(1.9f * r, 3.5f * t, 0), 0.6f * t);
        dmg_beam(b, v3(1.9f * r, 2.7f * t, 0), v3(1.45f * r, 2.7f * t, -0.7f * r), t, t);
        dmg_use(b, 0);
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_box_span(b, v3(side * (half + t) - 0.6f * t, t, -0.3f * size),
                     v3(side * (half + t) + 0.6f * t, y + 2 * t, 0.3f * size));
        const dmg_xy head[] = {
            {0, 0}, {0.8f * r, 0}, {0.5f * r, 0.4f * r}, {0.5f * r, 0.8f * r}, {0.85f * r, 1.2f * r}, {0, 1.25f * r}};
        dmg_spin(b, 0, "warping_head", v3(0, y, 0), v3(1, 0, 0));
        dmg_lathe(b, v3(side * (half + 2 * t), y, 0), v3(side, 0, 0), head, 6);
        dmg_use(b, 0);
        dmg_vec foot = v3(side * (half - 2 * t), t, 0.42f * size);
        dmg_hinge(b, 0, "brake_lever", foot, v3(1, 0, 0), -0.5f, 0.5f);
        dmg_rod(b, foot, v3(foot.x, size, foot.z), 0.4f * t);
        dmg_ellipsoid(b, v3(foot.x, size, foot.z), v3(0.8f * t, 0.8f * t, 0.8f * t));
        dmg_use(b, 0);
    }
    dmg_spin(b, 0, "drum", v3(0, y, 0), v3(1, 0, 0));
    draw_drum(b, v3(0, y, 0), gypsy ? 1.1f * r : r, half, !gypsy);
    dmg_use(b, 0);
}

/* Hose on a drum: in a frame on a wall bracket that swings out, on a cart, or in a stand. */
static void draw_hose_reel(dmg_builder* b, float size) {
    int kind = dmg_int(b, 0, 2);
    float half = size * dmg_range(b, 0.2f, 0.4f), r = 0.45f * size, t = 0.03f * size,
          y = kind == 0 ? size : 0.75f * size, x = half + 2 * t, swing = dmg_range(b, 0.6f, 1.5f);
    uint32_t frame = 0;
    if (kind == 0) {
        dmg_box_span(b, v3(-0.3f * size, y - 0.5f * size, -0.75f * size),
                     v3(0.3f * size, y + 0.5f * size, -0.72f * size));
        dmg_rod(b, v3(0, y - 0.3f * size, -0.66f * size), v3(0, y + 0.3f * size, -0.66f * size), 1.2f * t);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(-t, y + 0.33f * size * (float)s - t, -0.73f * size),
                         v3(t, y + 0.33f * size * (float)s + t, -0.63f * size));
        frame = dmg_hinge(b, 0, "bracket", v3(0, y, -0.66f * size), v3(0, dmg_sign(b), 0), -swing, swing);
        dmg_box_span(b, v3(-x - t, y - 0.2f * size, -0.62f * size), v3(x + t, y + 0.2f * size, -0.58f * size));
    }
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * (x + 0.5f * t);
        if (kind == 0)
            dmg_box_span(b, v3(at - 0.4f * t, y - 0.06f * size, -0.6f * size),
                         v3(at + 0.4f * t, y + 0.06f * size, 0.06f * size));
        for (int k = -1; k <= 1 && kind > 0; k += 2)
            dmg_beam(b, v3(at, y, 0), v3(at, kind == 1 ? 0.1f * size : 0.0f, 0.45f * size * (float)k), t, 1.5f * t);
        if (kind > 0) dmg_beam(b, v3(at, 0.12f * size, -0.45f * size), v3(at, 0.12f * size, 0.45f * size), t, 1.5f * t);
    }
    for (int k = -1; k <= 1 && kind > 0; k += 2)
        dmg_rod(b, v3(-x - t, 0.12f * size, 0.43f * size * (float)k), v3(x + t, 0.12f * size, 0.43f * size * (float)k),
                0.7f * t);
    if (kind == 1) { /* a cart: wheels behind, a bow to push it, which folds */
        for (int s = -1; s <= 1; s += 2) {
            float at = (float)s * (x + 3.5f * t);
            dmg_spin(b, 0, "wheel", v3(0, 0.16f * size, -0.43f * size), v3(1, 0, 0));
            dmg_rod(b, v3(at - t, 0.16f * size, -0.43f * size), v3(at + t, 0.16f * size, -0.43f * size), 0.16f * size);
            dmg_use(b, 0);
        }
        dmg_hinge(b, 0, "push_bar", v3(0, y + 1.5f * t, 0), v3(1, 0, 0), -0.2f, 1.2f);
        const dmg_vec bow[] = {v3(-x - 1.6f * t, y, 0), v3(-x - 1.6f * t, 1.4f * size, -0.5f * size),
                               v3(x + 1.6f * t, 1.4f * size, -0.5f * size), v3(x + 1.6f * t, y, 0)};
        dmg_sweep(b, bow, 4, 0.5f * t, 0.5f * t, false);
    }
    uint32_t drum = dmg_spin(b, frame, "reel", v3(0, y, 0), v3(dmg_sign(b), 0, 0));
    draw_drum(b, v3(0, y, 0), r, half, dmg_chance(b, 0.8f));
    dmg_rod(b, v3(-x, y, 0), v3(x + 2.5f * t, y, 0), t);
    if (dmg_chance(b, 0.8f)) draw_winch_crank(b, drum, v3(x + 2.2f * t, y, 0), 0.35f * size, 0.8f * t);
    dmg_use(b, 0);
}

void dmg_build_winch(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.15f, 0.6f);
    if (dmg_chance(b, 0.2f)) dmg_mirror(b, v3(1, 0, 0));
    switch (dmg_int(b, 0, 3)) {
    case 0:
        draw_hand_winch(b, size);
        break;
    case 1:
        draw_chain_block(b, size);
        break;
    case 2:
        draw_windlass(b, 1.5f * size);
        break;
    default:
        draw_hose_reel(b, size + 0.15f);
        break;
    }
}
