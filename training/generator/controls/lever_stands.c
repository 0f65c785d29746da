/* Draws levers as objects of their own: in the slot of a housing, between cheeks, on the side of a post; rockers in
 * a socket. Only the slot shows whether such a handle turns or slides. */
#include "core/build.h"
#include "parts/hardware.h"

/* The end one holds, about X: a bar across, a ball, a grip along Z that thickens, or nothing more. */
static void draw_grip(dmg_builder* b, dmg_vec from, dmg_vec to, float thin) {
    int kind = dmg_int(b, 0, 4);
    float size = thin * dmg_range(b, 1.3f, 2.6f), half = thin * dmg_range(b, 2.5f, 7.0f);
    bool square = dmg_chance(b, 0.4f);
    if (square)
        dmg_beam(b, from, to, 2 * thin, dmg_chance(b, 0.5f) ? thin : 2 * thin);
    else
        dmg_rod(b, from, to, thin);
    if (kind == 0) dmg_rod(b, v3(to.x - half, to.y, to.z), v3(to.x + half, to.y, to.z), 1.2f * thin);
    if (kind == 1) dmg_ellipsoid(b, to, v3(size, size, size));
    if (kind == 2) dmg_rod(b, v3_lerp(from, to, 0.55f), v3_lerp(from, to, 1.1f), 1.5f * thin);
    if (kind == 3) dmg_beam(b, v3_lerp(from, to, 0.5f), v3_lerp(from, to, 1.1f), 3 * thin, 2.5f * thin);
}

/* Draws a housing whose front has an upright slot: two halves of a front, or a case that is open there. */
static void draw_slotted(dmg_builder* b, float width, float height, float depth, float slot, bool curved) {
    float side = 0.5f * (width - slot);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.5f * (slot + side);
        if (curved) {
            const dmg_xy rim[] = {{0, -0.5f * side}, {depth, -0.5f * side}, {depth, 0.5f * side}, {0, 0.5f * side}};
            dmg_lathe_arc(b, v3(x, 0, -depth), v3(1, 0, 0), rim, 4, 0, 2.0f * DMG_PI);
        }
        dmg_box(b, v3(x, curved ? -0.5f * height : 0, -0.5f * depth - (curved ? 0.5f * depth : 0)),
                v3(side, height, curved ? 1.9f * depth : depth));
    }
    dmg_box(b, v3(0, curved ? -0.9f * height : 0, -0.9f * depth),
            v3(width, curved ? 0.2f * height : height, 0.2f * depth));
}

/* Draws a handle out of a slot in a flat front: pressed down or pulled up. */
static void draw_sliding_handle(dmg_builder* b) {
    float height = dmg_range(b, 0.1f, 0.4f), width = height * dmg_range(b, 0.3f, 1.2f),
          depth = height * dmg_range(b, 0.3f, 1.2f), thin = width * dmg_range(b, 0.04f, 0.12f),
          slot = 2 * thin * dmg_range(b, 1.1f, 2.0f), out = height * dmg_range(b, 0.2f, 0.8f),
          travel = height * dmg_range(b, 0.2f, 0.7f), upper = 0.5f * travel;
    bool wide = dmg_chance(b, 0.3f); /* a plate instead of a grip */
    dmg_move(b, 0, 0.5f * height, 0);
    if (dmg_chance(b, 0.3f)) /* a case that is shut: the slot is not cut into it */
        dmg_box(b, v3(0, 0, -0.5f * depth), v3(width, height, depth));
    else
        draw_slotted(b, width, height, depth, slot, false);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, -0.5f * height, -0.5f * depth), v3(1.4f * width, 0.06f * height, 1.3f * depth));
    dmg_move(b, 0, upper - 0.05f * travel, 0);
    bool down = dmg_chance(b, 0.7f);
    if (!down) dmg_move(b, 0, -travel, 0);
    dmg_slide(b, 0, "handle", v3(0, 1, 0), down ? -0.9f * travel : 0.0f, down ? 0.0f : 0.9f * travel);
    if (wide)
        dmg_box(b, v3(0, 0, 0.5f * out - 0.15f * depth), v3(slot * 0.8f, 2 * thin, out + 0.3f * depth));
    else
        draw_grip(b, v3(0, 0, -0.3f * depth), v3(0, 0, out), thin);
    if (wide) dmg_box(b, v3(0, 0, out), v3(0.7f * width, 0.1f * height, 2 * thin));
    dmg_use(b, 0);
}

/* Draws a handle out of a round housing, about the housing's own line. */
static void draw_arc_handle(dmg_builder* b) {
    float depth = dmg_range(b, 0.05f, 0.2f), height = depth * dmg_range(b, 0.3f, 2.0f),
          width = depth * dmg_range(b, 0.5f, 1.8f), thin = width * dmg_range(b, 0.04f, 0.12f),
          out = depth * dmg_range(b, 1.4f, 3.0f), rest = dmg_range(b, 0.0f, 1.4f);
    dmg_move(b, 0, height, depth);
    draw_slotted(b, width, height, depth, 3 * thin, true);
    float upper = fmaxf(rest, 1.5f) + dmg_range(b, 0.0f, 0.8f);
    uint32_t part = dmg_hinge(b, 0, "lever", v3(0, 0, -depth), v3(-1, 0, 0), 0.0f, upper);
    draw_grip(b, v3(0, 0, -depth), v3(0, 0, out - depth), thin);
    dmg_rest(b, part, rest);
    dmg_use(b, 0);
}

/* Lying between two cheeks on a block, its pivot near one end, lifted by the other. */
static void draw_cheek_lever(dmg_builder* b) {
    float length = dmg_range(b, 0.1f, 0.4f), thin = length * dmg_range(b, 0.02f, 0.07f),
          base = length * dmg_range(b, 0.4f, 0.9f), wide = length * dmg_range(b, 0.2f, 0.6f),
          high = length * dmg_range(b, 0.08f, 0.35f), cheek = base * dmg_range(b, 0.2f, 0.9f),
          pivot = thin * dmg_range(b, 0.6f, 4.0f), tail = length * dmg_range(b, 0.0f, 0.12f);
    float start = dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.0f, 1.6f);
    dmg_box(b, v3(0, 0.5f * high, 0), v3(wide, high, base));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * (1.8f * thin + 0.1f * wide), high + 0.6f * pivot, 0),
                v3(0.2f * wide, 1.2f * pivot + 2 * thin, cheek));
    dmg_move(b, 0, high + pivot, 0);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(-0.3f * wide, 0, 0), v3(0.3f * wide, 0, 0), 0.5f * thin);
    uint32_t part = dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
    draw_grip(b, v3(0, 0, -tail), v3(0, 0, length), thin);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(-thin, 0, 0), v3(thin, 0, 0), 1.5f * thin);
    dmg_rest(b, part, fminf(start, 1.1f));
    dmg_use(b, 0);
}

/* Draws a hub on the side of a post, an arm from it. */
static void draw_post_lever(dmg_builder* b) {
    float high = dmg_range(b, 0.15f, 0.6f), wide = high * dmg_range(b, 0.2f, 0.6f),
          deep = wide * dmg_range(b, 0.3f, 1.2f), hub = wide * dmg_range(b, 0.15f, 0.45f),
          thick = hub * dmg_range(b, 0.4f, 1.5f), length = high * dmg_range(b, 0.35f, 0.9f),
          thin = hub * dmg_range(b, 0.15f, 0.45f), side = dmg_sign(b), swing = dmg_range(b, 0.8f, 2.4f),
          at = high * dmg_range(b, 0.6f, 0.9f);
    bool both = dmg_chance(b, 0.3f);
    dmg_box(b, v3(0, 0.5f * high, 0), v3(deep, high, wide));
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(-0.5f * deep, high, 0), v3(0.5f * deep, high, 0), 0.5f * wide);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.03f * high, 0), v3(1.6f * deep, 0.06f * high, 1.3f * wide));
    dmg_move(b, side * 0.5f * deep, at, wide * dmg_range(b, -0.15f, 0.15f));
    dmg_rod(b, v3(0, 0, 0), v3(side * 0.5f * thick, 0, 0), 0.6f * hub);
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, -DMG_PI, DMG_PI));
    dmg_hinge(b, 0, "lever", v3(0, 0, 0), v3(-1, 0, 0), both ? -0.5f * swing : 0.0f, both ? 0.5f * swing : swing);
    dmg_rod(b, v3(side * 0.3f * thick, 0, 0), v3(side * 1.3f * thick, 0, 0), hub);
    draw_grip(b, v3(side * 0.8f * thick, 0, 0), v3(side * 0.8f * thick, 0, length), thin);
    dmg_use(b, 0);
}

/* Draws a large rocker in a frame, what it works hidden behind it: lugs and terminals. */
static void draw_rocker_switch(dmg_builder* b) {
    float high = dmg_range(b, 0.02f, 0.1f), wide = high * dmg_range(b, 0.3f, 1.2f),
          rise = high * dmg_range(b, 0.05f, 0.25f), deep = high * dmg_range(b, 0.15f, 0.6f),
          pivot = -deep * dmg_range(b, 0.0f, 0.9f), tilt = dmg_range(b, 0.1f, 0.6f),
          wall = wide * dmg_range(b, 0.05f, 0.3f), half = 0.5f * high;
    dmg_move(b, 0, half + 2 * wall, 0);
    dmg_frame_draw(b, 1.04f * wide + 2 * wall, 1.1f * high + 2 * wall, 0.5f * rise, wall);
    float swept = 1.1f * deep + 0.7f * half * sinf(tilt); /* what the rocker's back needs */
    dmg_box(b, v3(0, 0, -swept - 0.4f * deep), v3(wide, high, 0.8f * deep));
    for (int i = 0; i < 4 && dmg_chance(b, 0.7f); ++i)
        dmg_box(b, v3(0, high * (0.25f * (float)i - 0.375f), -swept - 1.1f * deep),
                v3(0.3f * wide, 0.05f * high, 0.8f * deep));
    const dmg_xy hollow[] = {{-half, 1.2f * rise},        {-0.7f * half, -deep},      {0.7f * half, -deep},
                             {half, 1.2f * rise},         {0.6f * half, 0.6f * rise}, {0.2f * half, 0.3f * rise},
                             {-0.2f * half, 0.3f * rise}, {-0.6f * half, 0.6f * rise}};
    const dmg_xy vee[] = {{-half, rise}, {-half, -0.3f * deep}, {half, -0.3f * deep}, {half, rise}, {0, 0.4f * rise}};
    bool curved = dmg_chance(b, 0.6f), both = dmg_chance(b, 0.5f);
    uint32_t part =
        dmg_hinge(b, 0, "rocker", v3(0, 0, pivot), v3(-1, 0, 0), both ? -0.5f * tilt : 0.0f, both ? 0.5f * tilt : tilt);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI); /* the outline's x becomes y, */
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* its y becomes z */
    if (curved) dmg_extrude(b, hollow, 8, -0.5f * wide, 0.5f * wide);
    if (!curved) dmg_extrude(b, vee, 5, -0.5f * wide, 0.5f * wide);
    dmg_restore(b);
    if (both) dmg_rest(b, part, dmg_sign(b) * 0.5f * tilt);
    dmg_use(b, 0);
}

void dmg_build_lever_stand(dmg_builder* b) {
    switch (dmg_int(b, 0, 4)) {
    case 0:
        draw_sliding_handle(b);
        break;
    case 1:
        draw_arc_handle(b);
        break;
    case 2:
        draw_cheek_lever(b);
        break;
    case 3:
        draw_post_lever(b);
        break;
    default:
        draw_rocker_switch(b);
        break;
    }
}
