/* Draws things with a lid or a bail: chests, buckets. */
#include "core/build.h"
#include "parts/hardware.h"

/* Half a barrel on a chest: axis along X, open below. */
static void draw_barrel_lid(dmg_builder* b, float width, float depth, float rise, float wall) {
    enum { POINTS = 9 };
    dmg_xy line[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1);
        line[i] = (dmg_xy){0.5f * depth * cosf(angle), rise * sinf(angle)};
    }
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* the line's x becomes -z */
    dmg_bent_plate(b, line, POINTS, wall, width);
    for (int s = -1; s <= 1; s += 2) { /* the ends */
        float z = (float)s * 0.5f * (width - wall);
        dmg_extrude(b, line, POINTS, z - 0.5f * wall, z + 0.5f * wall);
    }
    dmg_restore(b);
}

static void draw_lid(dmg_builder* b, int kind, float width, float depth, float rise, float wall) {
    switch (kind) {
    case 0:
        dmg_box(b, v3(0, 0.5f * wall, 0), v3(width, wall, depth));
        break;
    case 1: /* a shallow case upside down */
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* opens downwards */
        dmg_case_draw(b, dmg_case_pick(b), width, depth, rise, wall);
        dmg_restore(b);
        break;
    case 2:
        draw_barrel_lid(b, width, depth, rise, wall);
        break;
    case 3:
        dmg_rounded_box(b, v3(0, 0.5f * rise, 0), v3(width, rise, depth), 0.3f * rise);
        break;
    default: { /* a framed panel */
        dmg_panel panel = dmg_panel_pick(b);
        dmg_save(b);
        dmg_move(b, 0, wall, 0);
        dmg_face_up(b);
        dmg_panel_draw(b, &panel, width, depth, wall);
        dmg_restore(b);
        break;
    }
    }
}

/* Bands round a chest, a lock plate, side handles: what makes it a chest. */
static void draw_chest_fittings(dmg_builder* b, float width, float height, float depth, float wall) {
    if (dmg_chance(b, 0.4f)) {
        for (int i = 0; i < 4; ++i) { /* bands */
            float x = i & 1 ? 0.32f * width : -0.32f * width, z = i & 2 ? 0.5f * depth : -0.5f * depth;
            dmg_box(b, v3(x, 0.5f * height, z), v3(0.06f * width, 0.98f * height, 0.6f * wall));
        }
    }
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, 0.88f * height, 0.5f * depth), v3(0.12f * width, 0.16f * height, wall));
    if (dmg_chance(b, 0.4f)) {
        dmg_handle handle = dmg_handle_pick_bar(b, 0.3f * depth);
        for (int s = -1; s <= 1; s += 2) {
            dmg_save(b);
            dmg_move(b, (float)s * 0.5f * width, 0.6f * height, 0);
            dmg_turn(b, v3(0, 1, 0), (float)s * 0.5f * DMG_PI);
            dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
            dmg_handle_draw(b, &handle, 0.6f * depth);
            dmg_restore(b);
        }
    }
}

/* Draws a hasp on the lid's front edge (a part of the lid that swings up), or a plain grip. */
static void draw_lid_front(dmg_builder* b, uint32_t lid, float width, float z, float wall) {
    int kind = dmg_int(b, 0, 3);
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    if (kind == 0) {
        float w = width * dmg_range(b, 0.05f, 0.12f), h = wall * dmg_range(b, 3, 7);
        dmg_hinge(b, lid, "hasp", v3(0, 0.5f * wall, 0.3f * wall), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.5f, 2.9f));
        dmg_box(b, v3(0, 0.5f * wall - 0.5f * h, 0.3f * wall), v3(w, h, 0.4f * wall));
        dmg_use(b, lid);
    }
    if (kind == 1) dmg_box(b, v3(0, 0.5f * wall, 0.4f * wall), v3(0.3f * width, wall, wall));
    if (kind == 2) {
        dmg_handle handle = dmg_handle_pick(b, 0.3f * width);
        dmg_move(b, 0, 0.6f * wall, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &handle, 0.4f * width);
    }
    dmg_restore(b);
}

void dmg_build_chest(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.1f, 1.4f), depth = width * dmg_range(b, 0.35f, 1.1f),
          height = width * dmg_scale_range(b, 0.2f, 1.0f);
    float wall = width * dmg_range(b, 0.01f, 0.04f), rise = height * dmg_range(b, 0.1f, 0.6f),
          over = dmg_chance(b, 0.4f) ? wall * dmg_range(b, 0, 2) : 0.0f;
    int kind = dmg_int(b, 0, 4);
    float top = kind == 0 || kind == 4 ? 0.5f * wall : rise;
    dmg_save(b);
    dmg_move(b, 0, height, 0);
    dmg_face_up(b);
    dmg_case_draw(b, dmg_case_pick(b), width, depth, height, wall);
    dmg_restore(b);
    draw_chest_fittings(b, width, height, depth, wall);
    /* The hinge: at the back edge of the rim, a little outside or inside, or half way up the lid's edge. */
    float back = -0.5f * depth - dmg_range(b, -1.0f, 1.0f) * wall,
          up = dmg_chance(b, 0.6f) ? 0.0f : 0.3f * fminf(top, wall) * dmg_range(b, -1, 1);
    bool twin = width > 1.5f * depth && dmg_chance(b, 0.2f);
    float lid_width = (twin ? 0.5f : 1.0f) * (width + 2 * over);
    dmg_hinge_style hardware = dmg_hinge_pick(b, 0.5f * wall);
    dmg_move(b, 0, height, 0);
    for (int i = 0; i < (twin ? 2 : 1); ++i) {
        dmg_save(b);
        if (twin) dmg_move(b, ((float)i - 0.5f) * lid_width, 0, 0);
        uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, up, back), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.3f, 2.4f));
        draw_lid(b, kind, lid_width, depth + 2 * over, rise, wall);
        draw_lid_front(b, lid, lid_width, 0.5f * depth + over, wall);
        dmg_move(b, 0, up, back);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_turn(b, v3(0, 0, 1), -0.5f * DMG_PI); /* the axis along X */
        dmg_hinge_draw(b, &hardware, lid_width, depth, lid, 0);
        dmg_restore(b);
        if (dmg_chance(b, 0.35f)) dmg_rest(b, lid, dmg_range(b, 0, 1.3f));
    }
    dmg_use(b, 0);
}

/* ---- vessels ---- */

/* Draws a round or box-shaped vessel, y = 0 … height, open above; returns its half width at the rim along X. */
static float draw_vessel(dmg_builder* b, float radius, float height) {
    float taper = dmg_range(b, 0.65f, 1.05f), wall = radius * dmg_range(b, 0.015f, 0.06f);
    if (dmg_chance(b, 0.2f)) {
        dmg_move(b, 0, height, 0);
        dmg_face_up(b);
        float depth = 2 * radius * dmg_range(b, 0.6f, 1.3f);
        dmg_case_draw(b, dmg_case_pick(b), 2 * radius, depth, height, wall);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
        dmg_move(b, 0, -height, 0);
        return radius;
    }
    float r = radius * taper;
    const dmg_xy thick[] = {{0, 0}, {r, 0}, {radius, height}, {radius - wall, height}, {r - wall, wall}, {0, wall}};
    const dmg_xy thin[] = {{0, 0}, {r, 0}, {0.5f * (r + radius) * 1.02f, 0.5f * height}, {radius, height}};
    if (dmg_chance(b, 0.7f))
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thick, 6);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thin, 4);
    if (dmg_chance(b, 0.5f)) dmg_torus(b, v3(0, height, 0), v3(0, 1, 0), radius, wall);
    if (dmg_chance(b, 0.25f)) dmg_torus(b, v3(0, 0.6f * height, 0), v3(0, 1, 0), 0.4f * r + 0.6f * radius, wall);
    return radius;
}

/* Draws a bail over the vessel, ends at (+-half, 0, 0), lying along +Y. */
static void draw_bail(dmg_builder* b, float half, float rise, float tube) {
    enum { POINTS = 13 };
    dmg_vec path[POINTS];
    float power = dmg_range(b, 0.25f, 1.0f);
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1), c = cosf(angle);
        path[i] = v3(-half * copysignf(powf(fabsf(c), power), c), rise * powf(fabsf(sinf(angle)), power), 0);
    }
    bool strap = dmg_chance(b, 0.25f);
    dmg_sweep(b, path, POINTS, strap ? 0.5f * tube : tube, strap ? 2.5f * tube : tube, false);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(-0.25f * half, rise, 0), v3(0.25f * half, rise, 0), 2.2f * tube);
}

void dmg_build_bucket(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.08f, 0.25f), height = radius * dmg_scale_range(b, 0.8f, 2.6f),
          tube = radius * dmg_range(b, 0.015f, 0.05f);
    float half = draw_vessel(b, radius, height), y = height * dmg_range(b, 0.82f, 1.02f);
    half *= dmg_range(b, 0.98f, 1.06f);
    float ear = tube * dmg_range(b, 2, 5);
    bool ears = dmg_chance(b, 0.6f);
    for (int s = -1; s <= 1 && ears; s += 2)
        dmg_box(b, v3((float)s * half, y, 0), v3(1.2f * tube, 1.6f * ear, 1.4f * ear));
    uint32_t bail = dmg_hinge(b, 0, "handle", v3(0, y, 0), v3(1, 0, 0), -1.75f, 1.75f);
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    if (dmg_chance(b, 0.4f)) {
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * half * 0.97f, 0, 0), v3((float)s * (half + 2 * tube), 0, 0), 2 * tube);
    }
    draw_bail(b, half + tube, half * dmg_range(b, 0.7f, 1.7f), tube);
    dmg_restore(b);
    int at = dmg_int(b, 0, 3);
    if (at == 0) dmg_rest(b, bail, 1.75f);
    if (at == 1) dmg_rest(b, bail, -1.75f);
    if (at == 2) dmg_rest(b, bail, dmg_range(b, -1.7f, 1.7f));
    dmg_use(b, 0);
}
