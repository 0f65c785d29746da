/* Draws railway trackside equipment: semaphores, crossing gates, lever frames, points, turntables, water cranes,
 * buffer stops. */
#include "core/build.h"
#include "parts/walls.h"

/* ---- arms on a mast ---- */

/* Draws an arm with its spectacle on the near side of the mast; it rises or falls, or hangs from its middle. */
static void draw_arm(dmg_builder* b, float y, float z, float dir, float length) {
    float high = length * dmg_range(b, 0.12f, 0.22f), t = 0.02f * length, swing = dmg_range(b, 0.7f, 1.5f);
    bool rises = dmg_chance(b, 0.5f), forked = dmg_chance(b, 0.4f);
    int glasses = dmg_int(b, 1, 3);
    float r = 0.32f * high + 0.03f * length, tip = forked ? 0.9f * length : length;
    dmg_rod(b, v3(0, y, z - 3 * t), v3(0, y, z), 0.2f * high);
    dmg_hinge(b, 0, "semaphore_arm", v3(0, y, z), v3(0, 0, rises ? dir : -dir), 0.0f, swing);
    const dmg_xy blade[] = {{0.1f * length, -0.4f * high},
                            {length, -0.5f * high},
                            {tip, 0},
                            {length, 0.5f * high},
                            {0.1f * length, 0.4f * high}};
    dmg_save(b);
    if (dir < 0) dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_move(b, 0, y, dir < 0 ? -z - 0.5f * t : z + 0.5f * t);
    dmg_extrude(b, blade, 5, -0.5f * t, 0.5f * t);
    dmg_box_span(b, v3(-0.3f * high, -0.25f * high, -0.8f * t), v3(0.15f * length, 0.25f * high, 0.8f * t));
    for (int i = 0; i < glasses; ++i) {
        float angle = 3.14f + (rises ? -1.0f : 1.0f) * 0.75f * (float)i, reach = 0.3f * high + 1.6f * r;
        dmg_vec at = {reach * cosf(angle), reach * sinf(angle), 0};
        dmg_beam(b, v3(0, 0, 0), at, t, 0.3f * high);
        dmg_rod(b, v3(at.x, at.y, -t), v3(at.x, at.y, t), r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_semaphore(dmg_builder* b) {
    float high = dmg_range(b, 3.0f, 9.0f), w = dmg_range(b, 0.12f, 0.25f), length = dmg_range(b, 0.9f, 1.6f),
          dir = dmg_sign(b);
    int arms = dmg_int(b, 1, 3), post = dmg_int(b, 0, 2);
    if (post == 0) dmg_box_span(b, v3(-0.5f * w, 0, -0.5f * w), v3(0.5f * w, high, 0.5f * w));
    if (post == 1) dmg_cone(b, v3(0, 0, 0), v3(0, high, 0), 0.7f * w, 0.45f * w);
    for (int i = 0; i < 4 && post == 2; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * w, z = (i & 2 ? 0.5f : -0.5f) * w;
        dmg_beam(b, v3(1.5f * x, 0, 1.5f * z), v3(x, high, z), 0.03f, 0.03f);
    }
    for (int i = 0; i < 10 && post == 2; ++i) {
        float y = high * (float)i / 10.0f;
        for (int k = -1; k <= 1; k += 2)
            dmg_beam(b, v3((float)(i % 2 ? k : -k) * 0.6f * w, y, (float)k * 0.55f * w),
                     v3((float)(i % 2 ? -k : k) * 0.55f * w, y + 0.1f * high, (float)k * 0.55f * w), 0.015f, 0.03f);
    }
    dmg_box_span(b, v3(-0.6f * w, high - 0.02f, -0.6f * w), v3(0.6f * w, high + 0.05f, 0.6f * w));
    if (dmg_chance(b, 0.6f)) dmg_cone(b, v3(0, high, 0), v3(0, high + 3 * w, 0), 0.5f * w, 0);
    dmg_box_span(b, v3(-2 * w, 0, -2 * w), v3(2 * w, 0.1f, 2 * w));
    for (int i = 0; i < arms; ++i) {
        float y = high - 0.3f - length * 1.1f * (float)i;
        draw_arm(b, y, 0.5f * w + 0.06f * length, dir, i ? 0.85f * length : length);
        dmg_box_span(b, v3(-0.3f * w, y - 0.1f, 0.4f * w), v3(0.3f * w, y + 0.1f, 0.5f * w + 0.02f * length));
    }
    if (dmg_chance(b, 0.6f)) { /* the lever with a weight that keeps it at danger */
        dmg_wall_enter(b, v3(0, 0.15f * high, 0.5f * w), 0.0f);
        dmg_hinge(b, 0, "weight_lever", v3(0, 0, 0.06f), v3(0, 0, dmg_sign(b)), -0.4f, 0.4f);
        dmg_box(b, v3(0.1f, 0, 0.06f), v3(0.7f, 0.05f, 0.03f));
        dmg_rod(b, v3(0.4f, 0, 0.01f), v3(0.4f, 0, 0.11f), 0.12f);
        dmg_use(b, 0);
        dmg_rod(b, v3(0, 0, -0.02f), v3(0, 0, 0.04f), 0.04f);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.5f)) /* a ladder behind */
        for (int i = 0; i < 12; ++i) {
            float y = 0.9f * high * (float)i / 11.0f;
            dmg_box(b, v3(0, y + 0.03f, -0.5f * w - 0.2f), v3(0.3f, 0.02f, 0.02f));
            if (i < 2)
                dmg_box_span(b, v3(i ? 0.14f : -0.16f, 0, -0.5f * w - 0.21f),
                             v3(i ? 0.16f : -0.14f, 0.95f * high, -0.5f * w - 0.19f));
            if (i == 11) dmg_box_span(b, v3(-0.15f, y, -0.5f * w - 0.2f), v3(0.15f, y + 0.05f, 0));
        }
}

/* ---- a crossing ---- */

static void draw_boom(dmg_builder* b) {
    float y = dmg_range(b, 0.8f, 1.2f), length = dmg_range(b, 3.0f, 8.0f), t = dmg_range(b, 0.06f, 0.12f),
          dir = dmg_sign(b);
    int fringe = dmg_chance(b, 0.5f) ? dmg_int(b, 4, 10) : 0;
    float x = dir * 0.25f, low = dmg_range(b, 0.4f, 0.7f);
    dmg_box_span(b, v3(-0.25f, 0, -0.3f), v3(0.25f, y + 0.25f, 0.1f));
    dmg_wall_enter(b, v3(0, 0.5f * y, 0.1f), 0.0f);
    dmg_wall_leaf_draw(b, 0, "motor_door", 0.38f, 0.7f * y, dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
    dmg_restore(b);
    float z = 0.25f;
    dmg_rod(b, v3(0, y, 0), v3(0, y, z), 0.06f);
    uint32_t boom = dmg_hinge(b, 0, "boom", v3(0, y, z), v3(0, 0, dir), 0.0f, dmg_range(b, 1.2f, 1.55f));
    dmg_rod(b, v3(0, y, z - 0.03f), v3(0, y, z + 0.12f), 0.14f);
    dmg_beam(b, v3(-x * 3, y, z + 0.06f), v3(dir * length, y, z + 0.06f), 0.5f * t, t);
    dmg_box(b, v3(-x * 3.2f, y, z + 0.06f), v3(0.3f, 0.35f, 0.2f));
    for (int i = 0; i < fringe; ++i) { /* rods that stay hanging */
        float at = dir * length * (0.2f + 0.75f * (float)i / (float)fringe);
        dmg_use(b, boom);
        dmg_box(b, v3(at, y, z + 0.06f), v3(0.06f, 1.2f * t, 0.6f * t));
        dmg_hinge(b, boom, "fringe", v3(at, y - 0.6f * t, z + 0.06f), v3(0, 0, dir), -1.4f, 0.2f);
        dmg_box_span(b, v3(at - 0.015f, y - 0.6f * t - low, z + 0.05f), v3(at + 0.015f, y - 0.62f * t, z + 0.07f));
    }
    dmg_use(b, 0);
}

/* Gates that swing across road or rails, hung on heavy posts. */
static void draw_crossing_gates(dmg_builder* b) {
    float length = dmg_range(b, 2.5f, 5.0f), high = dmg_range(b, 1.0f, 1.4f), low = 0.2f, post = 0.15f, t = 0.05f;
    int gates = dmg_int(b, 1, 2), bars = dmg_int(b, 2, 5);
    bool disc = dmg_chance(b, 0.6f), back = dmg_chance(b, 0.5f);
    for (int g = 0; g < gates; ++g) {
        dmg_save(b);
        if (g) dmg_mirror(b, v3(1, 0, 0));
        float x = -length - 0.02f;
        dmg_box_span(b, v3(x - 2 * post, 0, -post), v3(x, 1.4f * high, post));
        uint32_t gate =
            dmg_hinge(b, 0, "crossing_gate", v3(x + 0.04f, 0, 0), v3(0, back ? 1.0f : -1.0f, 0), 0.0f, 1.57f);
        for (int i = 0; i < bars; ++i)
            dmg_box(b, v3(0.5f * x, low + (high - low) * (float)i / (float)(bars - 1), 0), v3(length - 0.1f, 0.08f, t));
        for (int i = 0; i < 3; ++i)
            dmg_box_span(b, v3(x + 0.05f + (length - 0.15f) * 0.5f * (float)i - 0.02f, low - 0.04f, -0.4f * t),
                         v3(x + 0.05f + (length - 0.15f) * 0.5f * (float)i + 0.06f, high + 0.04f, 0.4f * t));
        dmg_beam(b, v3(x + 0.1f, low, 0), v3(-0.1f, high, 0), 0.6f * t, 0.08f);
        if (disc) dmg_rod(b, v3(0.5f * x, 0.5f * (low + high), 0.4f * t), v3(0.5f * x, 0.5f * (low + high), t), 0.3f);
        if (dmg_chance(b, 0.5f)) { /* a bolt down into the road */
            dmg_slide(b, gate, "drop_bolt", v3(0, 1, 0), 0.0f, 0.2f);
            dmg_rod(b, v3(-0.12f, 0.02f, t), v3(-0.12f, 0.6f * high, t), 0.02f);
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
    if (gates == 1) dmg_box_span(b, v3(0.02f, 0, -post), v3(2 * post, high, post));
}

/* ---- levers ---- */

static void draw_lever_frame(dmg_builder* b) {
    int count = dmg_int(b, 3, 18);
    float pitch = dmg_range(b, 0.1f, 0.2f), tall = dmg_range(b, 0.9f, 1.4f), half = 0.5f * pitch * (float)count,
          r = dmg_range(b, 0.012f, 0.02f), throw_angle = dmg_range(b, 0.4f, 0.9f), base = dmg_range(b, 0.1f, 0.4f);
    bool catches = dmg_chance(b, 0.6f), shelf = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-half - 0.1f, 0, -0.3f), v3(half + 0.1f, base - 2.5f * r, 0.3f));
    for (int i = 0; i <= count; ++i) {
        float x = -half + pitch * (float)i;
        dmg_box_span(b, v3(x - 0.15f * pitch, base - 3 * r, -0.28f), v3(x + 0.15f * pitch, base + 0.05f, 0.28f));
    }
    for (int i = 0; i < count; ++i) {
        float x = -half + pitch * ((float)i + 0.5f);
        dmg_save(b);
        dmg_move(b, x, base, 0);
        uint32_t lever = dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(1, 0, 0), 0.0f, throw_angle);
        if (dmg_chance(b, 0.3f)) dmg_rest(b, lever, throw_angle);
        dmg_turn(b, v3(1, 0, 0), -0.5f * throw_angle);
        dmg_rod(b, v3(-0.3f * pitch, 0, 0), v3(0.3f * pitch, 0, 0), 1.5f * r);
        dmg_box_span(b, v3(-0.6f * r, 0, -1.4f * r), v3(0.6f * r, 0.8f * tall, 1.4f * r));
        dmg_rod(b, v3(0, 0.8f * tall, 0), v3(0, tall, 0), r);
        if (catches) {
            dmg_hinge(b, lever, "catch_handle", v3(0, 0.76f * tall, -1.6f * r), v3(1, 0, 0), 0.0f, 0.1f);
            dmg_beam(b, v3(0, 0.76f * tall, -2 * r), v3(0, 0.96f * tall, -4.5f * r), 1.2f * r, 0.6f * r);
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
    if (shelf) {
        float y = 1.35f * tall + base, z = -1.0f * tall;
        dmg_box_span(b, v3(-half, y, z - 0.15f), v3(half, y + 0.04f, z + 0.15f));
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * half - 0.03f, 0, z - 0.03f), v3((float)k * half + 0.03f, y, z + 0.03f));
    }
}

/* Draws a pair of blades that bend to one side, a bar between them, a lever with a weight, a lamp that turns. */
static void draw_points(dmg_builder* b) {
    float length = dmg_range(b, 2.5f, 5.0f), gauge = 0.7f, high = 0.16f, angle = dmg_range(b, 0.03f, 0.06f),
          way = angle * length, z = -0.5f * length;
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * (gauge + 0.06f + way) - 0.05f, 0.08f, z - 1.0f),
                     v3((float)k * (gauge + 0.06f + way) + 0.05f, 0.08f + high, -z + 0.6f));
    for (int i = 0; i < 8; ++i)
        dmg_box(b, v3(0.1f, 0.04f, z + (length + 0.6f) * (float)i / 7.0f), v3(2.6f, 0.08f, 0.22f));
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * (gauge - 0.5f * way);
        dmg_hinge(b, 0, "point_blade", v3(x, 0, z), v3(0, 1, 0), -0.45f * angle, 0.45f * angle);
        const dmg_xy blade[] = {{-0.04f, 0}, {0.04f, 0}, {0.01f, length}, {-0.01f, length}};
        dmg_save(b);
        dmg_move(b, x, 0.09f, z);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_extrude(b, blade, 4, -0.9f * high, 0);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    float stand = gauge + 0.75f, end = -z - 0.3f;
    dmg_slide(b, 0, "tie_bar", v3(1, 0, 0), -0.5f * way, 0.5f * way);
    dmg_box_span(b, v3(-gauge, 0.01f, end + 0.15f), v3(stand - 0.2f, 0.05f, end + 0.25f));
    dmg_use(b, 0);
    dmg_box_span(b, v3(stand - 0.1f, 0, end), v3(stand + 0.3f, 0.2f, end + 0.4f));
    dmg_hinge(b, 0, "point_lever", v3(stand + 0.1f, 0.25f, end + 0.44f), v3(0, 0, -1), -1.2f, 1.2f);
    dmg_box_span(b, v3(stand + 0.07f, 0.2f, end + 0.41f), v3(stand + 0.13f, 1.0f, end + 0.47f));
    dmg_rod(b, v3(stand + 0.1f, 0.8f, end + 0.38f), v3(stand + 0.1f, 0.8f, end + 0.5f), 0.13f);
    dmg_use(b, 0);
    dmg_box(b, v3(stand + 0.1f, 0.22f, end + 0.38f), v3(0.12f, 0.12f, 0.05f));
    float top = dmg_range(b, 0.7f, 1.4f);
    dmg_rod(b, v3(stand + 0.1f, 0, end + 0.15f), v3(stand + 0.1f, top, end + 0.15f), 0.03f);
    uint32_t lamp = dmg_hinge(b, 0, "point_lamp", v3(stand + 0.1f, 0, end + 0.15f), v3(0, dmg_sign(b), 0), 0.0f, 1.57f);
    dmg_box(b, v3(stand + 0.1f, top + 0.14f, end + 0.15f), v3(0.24f, 0.28f, 0.24f));
    dmg_rod(b, v3(stand - 0.06f, top + 0.15f, end + 0.15f), v3(stand + 0.26f, top + 0.15f, end + 0.15f), 0.08f);
    dmg_roof_enter(b, v3(stand + 0.1f, top + 0.28f, end + 0.15f));
    dmg_wall_leaf_draw(b, lamp, "lamp_lid", 0.22f, 0.22f, DMG_SIDE_TOP);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- the yard ---- */

static void draw_rail_turntable(dmg_builder* b) {
    float r = dmg_range(b, 3.0f, 10.0f), deep = 0.12f * r, wall = 0.05f * r, half = 0.16f * r;
    const dmg_xy pit[] = {{0, 0}, {r + wall, 0}, {r + wall, deep}, {r, deep}, {r, 0.2f * deep}, {0, 0.2f * deep}};
    bool house = dmg_chance(b, 0.4f), lever = dmg_chance(b, 0.6f);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), pit, 6);
    dmg_rod(b, v3(0, 0.2f * deep, 0), v3(0, 0.6f * deep, 0), 0.08f * r);
    uint32_t bridge = dmg_spin(b, 0, "turntable", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_box_span(b, v3(-half, 0.62f * deep, -0.97f * r), v3(half, 0.9f * deep, 0.97f * r));
    for (int k = -1; k <= 1; k += 2) {
        float s = (float)k;
        dmg_box_span(b, v3(s * 0.075f * r - 0.04f, 0.9f * deep, -0.97f * r),
                     v3(s * 0.075f * r + 0.04f, 1.05f * deep, 0.97f * r));
        dmg_box_span(b, v3(s * half - 0.02f, 1.6f * deep, -0.9f * r), v3(s * half + 0.02f, 1.65f * deep, 0.9f * r));
        for (int i = 0; i < 7; ++i)
            dmg_box_span(b, v3(s * half - 0.02f, 0.9f * deep, r * (-0.9f + 0.3f * (float)i) - 0.02f),
                         v3(s * half + 0.02f, 1.6f * deep, r * (-0.9f + 0.3f * (float)i) + 0.02f));
        for (int m = -1; m <= 1; m += 2) {
            dmg_use(b, bridge);
            dmg_vec at = {s * 0.8f * half, 0.44f * deep, (float)m * 0.85f * r};
            dmg_rod(b, v3_add(at, v3(-0.03f * r, 0, 0)), v3_add(at, v3(0.03f * r, 0, 0)), 0.05f * deep);
            dmg_box_span(b, v3_add(at, v3(-0.035f * r, 0, -0.02f * r)),
                         v3_add(at, v3(-0.025f * r, 0.2f * deep, 0.02f * r)));
            dmg_spin(b, bridge, "roller", at, v3(1, 0, 0));
            dmg_rod(b, v3_add(at, v3(-0.02f * r, 0, 0)), v3_add(at, v3(0.02f * r, 0, 0)), 0.23f * deep);
        }
        dmg_use(b, bridge);
        if (lever) {
            dmg_roof_enter(b, v3(-0.7f * half, 0.95f * deep, s * 0.85f * r));
            dmg_wall_stick_draw(b, bridge, "locking_lever", 1.0f);
            dmg_restore(b);
        } else {
            dmg_slide(b, bridge, "locking_bolt", v3(0, 0, -s), 0.0f, 0.05f * r);
            dmg_box_span(b, v3(-0.02f * r, 0.92f * deep, s * 0.91f * r - 0.05f * r),
                         v3(0.02f * r, 1.02f * deep, s * 0.91f * r + 0.05f * r));
        }
        dmg_use(b, bridge);
    }
    if (house) {
        dmg_box_span(b, v3(half, 0.9f * deep, -1.0f), v3(half + 1.4f, 0.9f * deep + 2.2f, 1.0f));
        dmg_wall_enter(b, v3(half + 1.4f, 0.9f * deep + 1.0f, 0), 0.5f * DMG_PI);
        dmg_wall_leaf_draw(b, bridge, "house_door", 0.8f, 1.9f, DMG_SIDE_LEFT);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a column whose arm swings over the tender, a leather bag at its end, a wheel on the valve. */
static void draw_water_crane(dmg_builder* b) {
    float high = dmg_range(b, 2.6f, 3.8f), r = dmg_range(b, 0.08f, 0.16f), reach = dmg_range(b, 1.5f, 3.0f),
          drop = dmg_range(b, 0.4f, 1.3f);
    bool bent = dmg_chance(b, 0.5f);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0.9f * high, 0), 1.6f * r, 1.1f * r);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.15f, 0), 3 * r);
    dmg_wall_enter(b, v3(0, 1.0f, 1.4f * r), 0.0f);
    dmg_wall_wheel_draw(b, 0, "water_valve", 0.22f);
    dmg_restore(b);
    uint32_t arm = dmg_hinge(b, 0, "swing_arm", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -1.6f, 1.6f);
    dmg_rod(b, v3(0, 0.91f * high, 0), v3(0, high + (bent ? 0.3f : 0.0f), 0), 1.2f * r);
    const dmg_vec pipe[] = {{0, high, 0},
                            {0.1f * reach, high + (bent ? 0.4f : 0.0f), 0},
                            {0.85f * reach, high + (bent ? 0.2f : 0.0f), 0},
                            {reach, high - 0.1f, 0},
                            {reach, high - 0.3f, 0}};
    dmg_sweep(b, pipe, 5, r, r, false);
    dmg_hinge(b, arm, "bag", v3(reach, high - 0.3f, 0), v3(0, 0, dmg_sign(b)), -0.6f, 0.6f);
    dmg_cone(b, v3(reach, high - 0.28f - drop, 0), v3(reach, high - 0.28f, 0), 1.4f * r, 1.05f * r);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) { /* a brazier's lid against the frost */
        dmg_rod(b, v3(0.5f, 0, 0), v3(0.5f, 0.9f, 0), 0.2f);
        dmg_roof_enter(b, v3(0.5f, 0.9f, 0));
        dmg_wall_lid_draw(b, 0, "stove_lid", 0.22f);
        dmg_restore(b);
    }
}

static void draw_buffer_stop(dmg_builder* b) {
    float y = 1.05f, half = dmg_range(b, 0.9f, 1.3f), way = dmg_range(b, 0.3f, 0.9f), r = dmg_range(b, 0.07f, 0.14f);
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * 0.72f;
        dmg_box_span(b, v3(x - 0.05f, 0, -2.0f), v3(x + 0.05f, 0.15f, 2.5f));
        dmg_beam(b, v3(x, 0.1f, -1.8f), v3(x, y, 0), 0.1f, 0.15f);
        dmg_box_span(b, v3(x - 0.06f, 0.15f, -0.15f), v3(x + 0.06f, y, 0));
    }
    dmg_box_span(b, v3(-half, y - 0.2f, -0.15f), v3(half, y + 0.2f, 0));
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * 0.85f * half;
        const dmg_xy barrel[] = {{r, 0.2f}, {r, 0}, {1.6f * r, 0}, {1.4f * r, 0.2f}, {r, 0.2f}};
        dmg_lathe(b, v3(x, y, 0), v3(0, 0, 1), barrel, 5);
        dmg_slide(b, 0, "buffer", v3(0, 0, -1), 0.0f, 0.9f * way);
        dmg_rod(b, v3(x, y, 0.1f), v3(x, y, 0.22f + way), 0.9f * r);
        dmg_rod(b, v3(x, y, 0.22f + way), v3(x, y, 0.28f + way), 2.2f * r);
        dmg_use(b, 0);
    }
    for (int k = -1; k <= 1; k += 2) /* blocks that flip over onto the rails */
        if (dmg_chance(b, 0.6f)) {
            float x = (float)k * 0.72f;
            dmg_box(b, v3(x + (float)k * 0.2f, 0.06f, 1.7f), v3(0.12f, 0.12f, 0.4f));
            dmg_hinge(b, 0, "wheel_stop", v3(x + (float)k * 0.14f, 0.17f, 1.7f), v3(0, 0, (float)-k), 0.0f, 2.6f);
            dmg_box(b, v3(x, 0.22f, 1.7f), v3(0.26f, 0.1f, 0.3f));
            dmg_use(b, 0);
        }
    if (dmg_chance(b, 0.6f)) {
        dmg_rod(b, v3(0, y, -0.07f), v3(0, y + 0.5f, -0.07f), 0.03f);
        dmg_box(b, v3(0, y + 0.6f, -0.07f), v3(0.25f, 0.3f, 0.2f));
        dmg_wall_enter(b, v3(0, y + 0.6f, 0.03f), 0.0f);
        dmg_wall_leaf_draw(b, 0, "lamp_door", 0.2f, 0.22f, DMG_SIDE_LEFT);
        dmg_restore(b);
    }
}

void dmg_build_rail_signal(dmg_builder* b) {
    static void (*const kinds[])(dmg_builder*) = {draw_semaphore,   draw_boom,       draw_crossing_gates,
                                                  draw_lever_frame, draw_points,     draw_rail_turntable,
                                                  draw_water_crane, draw_buffer_stop};
    kinds[dmg_weighted(b, (const float[]){4, 2, 2, 2, 1.5f, 1.5f, 1, 1.5f}, 8)](b);
}
