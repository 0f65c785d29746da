/* Puts things on level surfaces: books and vases on shelves and tops, gems into chests, boxes into drawers. A thing
 * goes with what it lies on. Shares and sizes are set by hand. */
#include "asset/asset_layer.h"

/* Each draws a thing on z = 0 about the origin, at most `radius` wide and `height` high. */

static void draw_box(dmg_builder* b, float radius, float height) {
    const float x = radius * dmg_range(b, 0.6f, 1.6f), y = radius * dmg_range(b, 0.6f, 1.6f);
    const float z = height * dmg_range(b, 0.3f, 0.9f);
    dmg_box(b, v3(0, 0, 0.5f * z), v3(x, y, z));
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, 0, 1.08f * z), v3(0.7f * x, 0.8f * y, 0.16f * z));
}

/* A row of upright books. */
static void draw_books(dmg_builder* b, float radius, float height) {
    const int count = dmg_int(b, 2, 7);
    const float step = 1.8f * radius / (float)count;
    for (int i = 0; i < count; ++i) {
        const float tall = height * dmg_range(b, 0.6f, 0.95f), deep = radius * dmg_range(b, 0.8f, 1.2f);
        const float x = ((float)i + 0.5f) * step - 0.9f * radius;
        dmg_box(b, v3(x, 0, 0.5f * tall), v3(step * dmg_range(b, 0.75f, 1.0f), deep, tall));
    }
}

static void draw_vase(dmg_builder* b, float radius, float height) {
    const float belly = radius * dmg_range(b, 0.5f, 0.9f), neck = belly * dmg_range(b, 0.3f, 0.8f);
    const float tall = height * dmg_range(b, 0.5f, 0.95f);
    const dmg_xy profile[] = {{0, 0},
                              {0.6f * belly, 0},
                              {belly, 0.35f * tall},
                              {neck, 0.75f * tall},
                              {neck * 1.2f, tall},
                              {0.9f * neck, tall},
                              {0.8f * neck, 0.75f * tall},
                              {0, 0.7f * tall}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 8);
}

static void draw_can(dmg_builder* b, float radius, float height) {
    const float r = radius * dmg_range(b, 0.3f, 0.8f), tall = height * dmg_range(b, 0.3f, 0.9f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, tall), r);
    if (dmg_chance(b, 0.4f)) dmg_cone(b, v3(0, 0, tall), v3(0, 0, tall * 1.1f), 0.6f * r, 0.3f * r);
}

static void draw_ball(dmg_builder* b, float radius, float height) {
    const float r = fminf(radius * dmg_range(b, 0.4f, 0.9f), 0.5f * height);
    dmg_ellipsoid(b, v3(0, 0, r), v3(r, r, r));
}

/* Cut stones: two cones tip to tip. */
static void draw_gems(dmg_builder* b, float radius, float height) {
    const int count = dmg_int(b, 1, 4), sides = b->sides;
    for (int i = 0; i < count; ++i) {
        const float r = fminf(0.4f * radius * dmg_range(b, 0.5f, 1.0f), 0.4f * height);
        const float angle = dmg_range(b, 0, 2.0f * DMG_PI), off = i == 0 ? 0.0f : 0.6f * radius;
        const dmg_vec at = v3(off * cosf(angle), off * sinf(angle), r);
        b->sides = 6;
        dmg_cone(b, at, v3(at.x, at.y, 0), r, 0);
        dmg_cone(b, at, v3(at.x, at.y, 1.6f * r), r, 0.4f * r);
    }
    b->sides = sides;
}

static void draw_dish(dmg_builder* b, float radius, float height) {
    const float tall = fminf(0.3f * radius, 0.5f * height);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0, tall), 0.5f * radius, 0.9f * radius);
}

static void draw_thing(dmg_builder* b, float radius, float height) {
    static void (*const kinds[])(dmg_builder*, float, float) = {draw_box,  draw_books, draw_vase, draw_can,
                                                                draw_ball, draw_gems,  draw_dish};
    kinds[dmg_int(b, 0, 6)](b, radius, height);
}

/* Returns how high a thing may be: what is above lets it, also as a part goes on its way. */
static float room_above(const dmg_builder* b, const dmg_place* place, float size) {
    const float least = fminf(place->clearance * 0.9f, 0.3f * size);
    if (place->part == 0) return least;
    const dmg_bounds own = dmg_part_bounds(b, place->part);
    const float walls = own.high.y - place->frame.origin.y; /* of a drawer */
    return fminf(least, walls > 0.02f * size ? 0.9f * walls : place->clearance < 1e29f ? 0.0f : 0.05f * size);
}

static void add_thing(dmg_builder* b, bool on_body, float size) {
    dmg_place place;
    const float radius = size * dmg_scale_range(b, 0.015f, 0.12f);
    if (!dmg_find_place(b, on_body, 0.98f, 1.1f, radius, &place)) return;
    const float height = fminf(room_above(b, &place, size), radius * dmg_range(b, 0.8f, 4.0f));
    if (height < 0.2f * radius) return;
    const dmg_vec o = place.frame.origin;
    const dmg_bounds box = {v3_sub(o, v3(radius, 0, radius)), v3_add(o, v3(radius, height, radius))};
    if (dmg_is_swept(b, place.part, &box)) return;
    dmg_enter_place(b, &place);
    if (dmg_chance(b, 0.4f)) dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 2.0f * DMG_PI));
    draw_thing(b, radius, height);
    dmg_restore(b);
    dmg_use(b, 0);
}

void dmg_add_things(dmg_builder* b) {
    const dmg_bounds whole = dmg_whole_bounds(b);
    const float size = dmg_largest_side(&whole);
    const bool on_body = dmg_chance(b, 0.35f), on_parts = dmg_chance(b, 0.2f);
    for (int left = dmg_int(b, 1, 6); on_body && left > 0; --left) add_thing(b, true, size);
    for (int left = dmg_int(b, 1, 4); on_parts && left > 0; --left) add_thing(b, false, size);
}
