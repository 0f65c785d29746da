/* Draws earthmovers: bulldozers with blade and ripper, graders, road rollers. Front is +Z. */
#include "core/build.h"
#include "parts/walls.h"
#include "parts/works.h"

/* ---- what they share ---- */

/* Draws a curved blade about x = 0 whose back is at z, on the part in use; an edge below, plates at its ends. */
static void draw_blade_sheet(dmg_builder* b, float z, float low, float high, float width, bool ends) {
    float bulge = 0.16f * (high - low), t = 0.04f * (high - low);
    const dmg_xy line[] = {{z + bulge, low},
                           {z + 0.3f * bulge, low + 0.25f * (high - low)},
                           {z, low + 0.55f * (high - low)},
                           {z + 0.7f * bulge, high}};
    dmg_side_sheet(b, line, 4, t, width);
    dmg_box(b, v3(0, low + 0.02f * (high - low), z + 1.1f * bulge), v3(width, 0.1f * (high - low), t));
    for (int k = -1; k <= 1 && ends; k += 2)
        dmg_box_span(b, v3((float)k * 0.5f * width - t, low, z),
                     v3((float)k * 0.5f * width + t, high, z + 1.3f * bulge));
}

/* Tracks as loops round wheels that turn. */
static void draw_tracks(dmg_builder* b, float half, float width, float r, float z0, float z1) {
    int rollers = dmg_int(b, 2, 6);
    bool high_drive = dmg_chance(b, 0.35f), open = dmg_chance(b, 0.6f);
    float raise = high_drive ? 1.1f * r : 0.0f, t = 0.14f * r;
    const dmg_xy loop[] = {{z0, 0},
                           {z1, 0},
                           {z1 + 0.75f * r, 0.3f * r},
                           {z1 + r, r},
                           {z1 + 0.7f * r, 1.7f * r},
                           {z1, 2 * r},
                           {z0, 2 * r + raise},
                           {z0 - 0.7f * r, 1.7f * r + raise},
                           {z0 - r, r + raise},
                           {z0 - 0.75f * r, 0.3f * r + 0.5f * raise}};
    dmg_xy inner[10];
    float zm = 0.5f * (z0 + z1), ym = r + 0.4f * raise;
    for (int i = 0; i < 10; ++i) {
        inner[i].x =
            loop[i].x + (loop[i].x > zm ? -1.0f : 1.0f) * (i == 0 || i == 1 || i == 5 || i == 6 ? 0.3f : 0.8f) * t;
        inner[i].y = loop[i].y + (loop[i].y > ym ? -1.0f : 1.0f) * (i == 3 || i == 8 ? 0.0f : 0.8f) * t;
    }
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * half;
        dmg_use(b, 0);
        dmg_wall_enter(b, v3(x, 0, 0), -0.5f * DMG_PI);
        if (open)
            dmg_ring_plate(b, loop, inner, 10, -0.5f * width, 0.5f * width);
        else
            dmg_extrude(b, loop, 10, -0.4f * width, 0.4f * width);
        dmg_restore(b);
        dmg_box_span(b, v3(x - 0.12f * width, 0.5f * r, z0), v3(x + 0.12f * width, 1.3f * r, z1));
        for (int i = 0; i < rollers + 2; ++i) {
            bool end = i < 2;
            float wheel = end ? 0.8f * r : 0.3f * r,
                  z = i == 0   ? z0
                      : i == 1 ? z1
                               : z0 + (z1 - z0) * ((float)i - 1.0f) / ((float)rollers + 1.0f),
                  y = i == 0   ? r + raise
                      : i == 1 ? r
                               : 0.48f * r;
            float in = open ? 0.14f * width : 0.42f * width, out = open ? 0.44f * width : 0.5f * width;
            if (!end && !open) continue;
            dmg_spin(b, 0, end ? "sprocket" : "roller", v3(x, y, z), v3(dmg_sign(b), 0, 0));
            dmg_rod(b, v3(x + (float)k * in, y, z), v3(x + (float)k * out, y, z), wheel);
            for (int m = 0; m < 5 && end; ++m) {
                float a = 1.2566f * (float)m;
                dmg_vec at = {x + (float)k * (out + 0.01f), y + 0.55f * wheel * cosf(a), z + 0.55f * wheel * sinf(a)};
                dmg_rod(b, at, v3_add(at, v3((float)k * 0.04f * r, 0, 0)), 0.1f * wheel);
            }
            dmg_use(b, 0);
        }
    }
}

/* Doors at both sides of an engine, a grille at one end, an exhaust with a flap. */
static void draw_engine_house(dmg_builder* b, uint32_t parent, dmg_vec low, dmg_vec high, bool rear) {
    int doors = dmg_int(b, 1, 3);
    float y = 0.5f * (low.y + high.y), tall = high.y - low.y, each = (high.z - low.z) / (float)doors,
          x = 0.5f * (low.x + high.x);
    bool hood = dmg_chance(b, 0.4f);
    dmg_use(b, parent);
    dmg_box_span(b, low, high);
    for (int i = 0; i < 2 * doors; ++i) {
        float side = i % 2 ? -1.0f : 1.0f;
        dmg_wall_enter(b, v3(side > 0 ? high.x : low.x, y, low.z + each * ((float)(i / 2) + 0.5f)),
                       side * 0.5f * DMG_PI);
        dmg_wall_leaf_draw(b, parent, "engine_door", 0.88f * each, 0.8f * tall,
                           hood       ? DMG_SIDE_TOP
                           : side > 0 ? DMG_SIDE_LEFT
                                      : DMG_SIDE_RIGHT);
        dmg_restore(b);
    }
    dmg_wall_enter(b, v3(x, y, rear ? low.z : high.z), rear ? DMG_PI : 0.0f);
    if (dmg_chance(b, 0.5f))
        dmg_wall_leaf_draw(b, parent, "radiator_grille", 0.85f * (high.x - low.x), 0.85f * tall, DMG_SIDE_LEFT);
    else
        dmg_wall_louvres_draw(b, 0.8f * (high.x - low.x), 0.8f * tall, 8);
    dmg_restore(b);
    float r = 0.05f * tall, top = high.y + 0.6f * tall, z = low.z + 0.7f * (high.z - low.z);
    dmg_rod(b, v3(x, high.y - 0.02f, z), v3(x, top, z), r);
    dmg_hinge(b, parent, "exhaust_flap", v3(x, top + 0.2f * r, z - r), v3(-1, 0, 0), 0.0f, 1.3f);
    dmg_box(b, v3(x, top + 0.2f * r, z + 0.05f * r), v3(2.1f * r, 0.2f * r, 2.1f * r));
    dmg_use(b, parent);
}

/* Draws a ripper behind: a beam that swings down, shanks in it; some slide up and down. */
static void draw_ripper(dmg_builder* b, float half, float y, float z, float size) {
    int shanks = dmg_int(b, 1, 3);
    bool slides = dmg_chance(b, 0.4f);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.5f * half - 0.05f * size, y - 0.15f * size, z - 0.05f * size),
                     v3((float)k * 0.5f * half + 0.05f * size, y + 0.2f * size, z + 0.1f * size));
    uint32_t ripper = dmg_hinge_across(b, 0, "ripper", v3(0, y, z - 0.1f * size), -0.3f, 0.4f);
    for (int k = -1; k <= 1; k += 2)
        dmg_beam(b, v3((float)k * 0.5f * half, y, z - 0.08f * size), v3((float)k * 0.5f * half, y, z - 0.7f * size),
                 0.08f * size, 0.12f * size);
    dmg_box(b, v3(0, y, z - 0.75f * size), v3(1.6f * half, 0.18f * size, 0.2f * size));
    for (int i = 0; i < shanks; ++i) {
        float x = shanks == 1 ? 0.0f : half * (-0.65f + 1.3f * (float)i / (float)(shanks - 1));
        if (slides) dmg_slide(b, ripper, "shank", v3(0, -1, 0), -0.1f * size, 0.15f * size);
        const dmg_xy shank[] = {{z - 0.98f * size, y + 0.3f * size},
                                {z - 0.98f * size, y - 0.35f * size},
                                {z - 0.72f * size, y - 0.6f * size},
                                {z - 0.8f * size, y - 0.3f * size},
                                {z - 0.86f * size, y + 0.3f * size}};
        dmg_side_prism(b, shank, 5, x - 0.035f * size, x + 0.035f * size);
        dmg_use(b, ripper);
    }
    dmg_use(b, 0);
}

/* ---- the machines ---- */

static void draw_dozer(dmg_builder* b) {
    float r = dmg_range(b, 0.35f, 0.55f), z1 = dmg_range(b, 1.0f, 1.6f), z0 = -dmg_range(b, 0.9f, 1.4f),
          half = dmg_range(b, 0.75f, 1.1f), shoe = half * dmg_range(b, 0.4f, 0.65f);
    float body = half - 0.6f * shoe, deck = 2 * r + 0.15f, hood = deck + dmg_range(b, 0.7f, 1.0f),
          roof = deck + dmg_range(b, 1.5f, 1.9f), cab = dmg_range(b, 1.2f, 1.5f);
    draw_tracks(b, half, shoe, r, z0, z1);
    dmg_box_span(b, v3(-body, 0.7f * r, z0 - 0.5f * r), v3(body, deck, z1));
    dmg_rod(b, v3(-half, r, 0), v3(half, r, 0), 0.3f * r);
    draw_engine_house(b, 0, v3(-0.85f * body, deck, z0 + cab - 0.2f), v3(0.85f * body, hood, z1 + 0.4f), false);
    dmg_cab c = dmg_cab_pick(b, v3(-1.15f * body, deck, z0 - 0.2f), v3(1.15f * body, roof, z0 + cab - 0.25f));
    dmg_cab_draw(b, &c, 0);
    float width = 2 * half + shoe * dmg_range(b, 1.1f, 2.2f), high = dmg_range(b, 0.9f, 1.4f),
          z = z1 + r + dmg_range(b, 0.3f, 0.6f), x = half + 0.62f * shoe;
    dmg_rod(b, v3(-x, r, 0), v3(x, r, 0), 0.1f);
    uint32_t arms = dmg_hinge_across(b, 0, "push_arms", v3(0, r, 0), -0.15f, 0.5f);
    for (int k = -1; k <= 1; k += 2)
        dmg_beam(b, v3((float)k * (x + 0.06f), r, 0), v3((float)k * (x + 0.06f), 0.6f * r, z - 0.1f), 0.1f, 0.2f);
    dmg_box(b, v3(0, 0.7f * r, z - 0.15f), v3(2 * x + 0.2f, 0.14f, 0.14f));
    int way = dmg_int(b, 0, 3); /* fixed, tilts, angles, pitches */
    dmg_vec pin = {0, 0.7f * r, z - 0.1f};
    if (way == 1) dmg_hinge(b, arms, "blade", pin, v3(0, 0, dmg_sign(b)), -0.15f, 0.15f);
    if (way == 2) dmg_hinge(b, arms, "blade", pin, v3(0, dmg_sign(b), 0), -0.3f, 0.3f);
    if (way == 3) dmg_hinge_across(b, arms, "blade", v3(0, 0.6f * r, z), -0.2f, 0.3f);
    draw_blade_sheet(b, z, 0.02f, high, fmaxf(width, 2 * x + 0.3f), dmg_chance(b, 0.5f));
    dmg_box(b, v3(0, 0.7f * r, z - 0.02f), v3(0.5f * half, 0.25f * r, 0.12f));
    dmg_use(b, 0);
    float lift = hood - 0.2f;
    dmg_ram_kind ram = dmg_ram_pick(b);
    for (int k = -1; k <= 1; k += 2)
        dmg_ram_draw(b, ram, 0, arms, v3((float)k * 0.95f * body, lift, z1 + 0.3f),
                     v3((float)k * 0.95f * body, 0.75f * r, z - 0.15f), 0.05f);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.6f)) draw_ripper(b, body, r, z0 - 0.5f * r, 1.1f);
}

/* Draws a long nose over a ring that turns the blade; the front wheels steer and lean; the middle may bend. */
static void draw_grader(dmg_builder* b) {
    dmg_tyre tyre = dmg_tyre_pick(b, dmg_range(b, 0.5f, 0.7f));
    tyre.width = fminf(tyre.width, 0.4f);
    float half = dmg_range(b, 0.9f, 1.1f), r = tyre.radius, deck = 1.6f * r, front = dmg_range(b, 3.6f, 4.6f),
          y = deck + 0.75f;
    for (int i = 0; i < 2; ++i) dmg_axle_draw(b, &tyre, 0, half, -0.3f - 2.15f * r * (float)i);
    dmg_box_span(b, v3(-0.5f * half, 0.8f * r, -3.2f * r), v3(0.5f * half, deck, 0.5f));
    draw_engine_house(b, 0, v3(-0.55f * half, deck, -3.4f * r), v3(0.55f * half, deck + 0.8f, -0.4f), true);
    dmg_cab c = dmg_cab_pick(b, v3(-0.6f * half, deck, -0.35f), v3(0.6f * half, deck + 1.7f, 1.0f));
    dmg_cab_draw(b, &c, 0);
    bool bends = dmg_chance(b, 0.5f);
    dmg_box_span(b, v3(-0.2f, deck - 0.3f, 0.5f), v3(0.2f, deck, 1.1f));
    uint32_t nose =
        bends ? dmg_hinge(b, 0, "articulation", v3(0, deck, 1.2f), v3(0, dmg_sign(b), 0), -0.35f, 0.35f) : 0;
    dmg_use(b, nose);
    const dmg_xy beam[] = {{1.05f, deck - 0.25f}, {1.4f, deck - 0.25f},        {1.9f, y - 0.15f},
                           {front, deck - 0.25f}, {front + 0.2f, deck - 0.2f}, {front + 0.2f, deck + 0.1f},
                           {2.0f, y + 0.15f},     {1.05f, deck + 0.1f}};
    dmg_side_prism(b, beam, 8, -0.13f, 0.13f);
    dmg_box_span(b, v3(-0.2f, r, front - 0.15f), v3(0.2f, deck - 0.1f, front + 0.15f));
    tyre.steers = true;
    dmg_axle_draw(b, &tyre, nose, half, front);
    float mid = 2.3f;
    uint32_t draw = dmg_hinge_across(b, nose, "drawbar", v3(0, r, front - 0.3f), -0.1f, 0.15f);
    for (int k = -1; k <= 1; k += 2) dmg_beam(b, v3(0, r, front - 0.35f), v3((float)k * 0.5f, r, mid), 0.1f, 0.1f);
    uint32_t circle = dmg_spin(b, draw, "circle", v3(0, r, mid), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, r - 0.16f, mid), v3(0, r - 0.06f, mid), 0.6f);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.4f - 0.05f, 0.35f, mid - 0.25f),
                     v3((float)k * 0.4f + 0.05f, r - 0.1f, mid - 0.1f));
    dmg_slide(b, circle, "blade", v3(dmg_sign(b), 0, 0), -0.4f, 0.4f);
    draw_blade_sheet(b, mid - 0.08f, 0.03f, 0.6f, dmg_range(b, 2.6f, 3.4f), false);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) draw_ripper(b, 0.5f * half, r, -3.2f * r, 0.8f);
    if (dmg_chance(b, 0.4f)) { /* a small blade before the front wheels */
        dmg_use(b, nose);
        dmg_box(b, v3(0, deck - 0.2f, front + 0.3f), v3(0.3f, 0.3f, 0.3f));
        dmg_hinge_across(b, nose, "front_blade", v3(0, deck - 0.2f, front + 0.5f), -0.3f, 0.4f);
        dmg_box_span(b, v3(-0.1f, 0.4f, front + 0.46f), v3(0.1f, deck - 0.15f, front + 0.54f));
        dmg_box_span(b, v3(-0.1f, 0.4f, front + 0.5f), v3(0.1f, 0.5f, front + r + 0.5f));
        draw_blade_sheet(b, front + r + 0.4f, 0.05f, 0.8f, 2.2f, true);
        dmg_use(b, 0);
    }
}

/* Draws a drum in a yoke; fixed in the frame, or the yoke steers. */
static void draw_drum(dmg_builder* b, uint32_t parent, float half, float r, float z, bool split, bool padded) {
    dmg_use(b, parent);
    for (int k = -1; k <= 1; k += 2) {
        dmg_box_span(b, v3((float)k * (half + 0.08f) - 0.05f, 0.85f * r, z - 0.2f),
                     v3((float)k * (half + 0.08f) + 0.05f, 2.15f * r, z + 0.2f));
        dmg_rod(b, v3((float)k * 0.98f * half, r, z), v3((float)k * (half + 0.1f), r, z), 0.25f * r);
    }
    dmg_box_span(b, v3(-half - 0.13f, 2.05f * r, z - 0.25f), v3(half + 0.13f, 2.05f * r + 0.15f, z + 0.25f));
    for (int s = 0; s < (split ? 2 : 1); ++s) {
        float x0 = split && s ? 0.02f : -half, x1 = split && !s ? -0.02f : half;
        dmg_spin(b, parent, "drum", v3(0, r, z), v3(dmg_sign(b), 0, 0));
        dmg_rod(b, v3(x0, r, z), v3(x1, r, z), padded ? 0.94f * r : r);
        for (int i = 0; i < 36 && padded; ++i) {
            float a = 6.2832f * (float)(i / 3) / 12.0f, x = x0 + (x1 - x0) * ((float)(i % 3) + 0.5f) / 3.0f;
            dmg_vec out = {0, cosf(a), sinf(a)}, at = {x, r, z};
            dmg_rod(b, v3_mad(at, out, 0.9f * r), v3_mad(at, out, r), 0.08f * r);
        }
        dmg_use(b, parent);
    }
}

static void draw_road_roller(dmg_builder* b) {
    float r = dmg_range(b, 0.45f, 0.75f), half = dmg_range(b, 0.6f, 1.05f), front = r + dmg_range(b, 0.9f, 1.4f),
          deck = 2.05f * r, roof = deck + dmg_range(b, 1.6f, 1.9f);
    bool tandem = dmg_chance(b, 0.5f), yoke = dmg_chance(b, 0.4f), split = dmg_chance(b, 0.3f),
         padded = dmg_chance(b, 0.3f);
    float back = -front, joint = 0.1f;
    uint32_t fore;
    if (yoke) { /* the drum turns under the nose */
        dmg_box_span(b, v3(-0.5f * half, deck + 0.25f, 0), v3(0.5f * half, deck + 0.55f, front + 0.2f));
        fore = dmg_hinge(b, 0, "yoke", v3(0, deck, front), v3(0, dmg_sign(b), 0), -0.5f, 0.5f);
        dmg_rod(b, v3(0, deck, front), v3(0, deck + 0.25f, front), 0.15f);
    } else { /* the whole front half swings about a pin in the middle */
        dmg_box_span(b, v3(-0.2f, 0.8f * r, back + 1.2f * r), v3(0.2f, deck, joint - 0.15f));
        dmg_rod(b, v3(0, 0.7f * r, joint), v3(0, 1.05f * deck, joint), 0.1f);
        fore = dmg_hinge(b, 0, "articulation", v3(0, r, joint), v3(0, dmg_sign(b), 0), -0.6f, 0.6f);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3(-0.15f, r + (float)k * 0.25f * r - 0.08f, joint - 0.1f),
                         v3(0.15f, r + (float)k * 0.25f * r + 0.08f, front - 1.1f * r));
        dmg_box_span(b, v3(-half - 0.13f, 0.6f * r, front - 1.3f * r), v3(half + 0.13f, 1.4f * r, front - 1.1f * r));
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * (half + 0.08f) - 0.05f, 0.8f * r, front - 1.2f * r),
                         v3((float)k * (half + 0.08f) + 0.05f, 1.2f * r, front));
    }
    draw_drum(b, fore, half, r, front, split, padded);
    dmg_use(b, 0);
    if (tandem) {
        draw_drum(b, 0, half, r, back, split, padded);
    } else {
        dmg_tyre tyre = dmg_tyre_pick(b, r);
        tyre.width = fminf(tyre.width, 0.6f * half);
        dmg_axle_draw(b, &tyre, 0, half - 0.5f * tyre.width, back);
    }
    dmg_box_span(b, v3(-0.8f * half, deck, back - 0.9f * r), v3(0.8f * half, deck + 0.25f, 0.0f));
    draw_engine_house(b, 0, v3(-0.7f * half, deck + 0.25f, back - 0.9f * r),
                      v3(0.7f * half, deck + 0.85f, back + 0.5f * (0.0f - back) - 0.1f), true);
    dmg_cab c = dmg_cab_pick(b, v3(-0.75f * half, deck + 0.2f, 0.5f * back), v3(0.75f * half, roof, 0.0f));
    dmg_cab_draw(b, &c, 0);
}

void dmg_build_bulldozer(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.05f, 0.4f) : 1.0f);
    int kind = dmg_weighted(b, (const float[]){5, 3, 3}, 3);
    if (kind == 0) draw_dozer(b);
    if (kind == 1) draw_grader(b);
    if (kind == 2) draw_road_roller(b);
}
