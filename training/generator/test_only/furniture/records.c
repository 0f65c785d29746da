/* Draws filing cabinets, plan chests, card indexes, doors that recede, rolling fronts. */
#include "core/build.h"
#include "parts/hardware.h"

static dmg_vec pick_size(dmg_builder* b, float x0, float x1, float y0, float y1, float z0, float z1) {
    float x = dmg_range(b, x0, x1), y = dmg_range(b, y0, y1), z = dmg_range(b, z0, z1);
    return v3(x, y, z);
}

/* ---- filing cabinets ---- */

/* `columns` x `rows` drawers in a case whose front is z = 0, its lower edge y = 0; a card frame on each, a lock on top.
 */
static void draw_files(dmg_builder* b, dmg_vec size, int columns, int rows, float hand) {
    float wall = 0.02f * fminf(size.x, size.y) + 0.006f, gap = 0.004f, wide = (size.x - 2 * wall) / (float)columns,
          high = (size.y - 2 * wall) / (float)rows;
    dmg_drawer drawer = dmg_drawer_pick(b, hand);
    drawer.width = wide - gap;
    drawer.height = high - gap;
    drawer.depth = size.z * 0.92f;
    drawer.travel = drawer.depth * dmg_range(b, 0.6f, 0.95f);
    bool cards = dmg_chance(b, 0.5f), rod = dmg_chance(b, 0.3f), lock = dmg_chance(b, 0.5f),
         latch = dmg_chance(b, 0.25f) && rows * columns < 12;
    float card = fminf(0.3f * wide, 0.08f), opening = dmg_range(b, 0.3f, 1.0f),
          chance = dmg_chance(b, 0.4f) ? 0.3f : 0.0f;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * size.y, 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, size.x, size.y, size.z, wall);
    dmg_restore(b);
    for (int i = 0; i < columns * rows; ++i) {
        dmg_save(b);
        dmg_move(b, -0.5f * size.x + wall + wide * ((float)(i % columns) + 0.5f),
                 wall + high * ((float)(i / columns) + 0.5f), 0);
        uint32_t part = dmg_drawer_draw(b, 0, "drawer", &drawer);
        if (dmg_chance(b, chance)) dmg_rest(b, part, drawer.travel * opening);
        if (cards) {
            dmg_save(b);
            dmg_move(b, 0, 0.36f * high, 0.003f);
            dmg_frame_draw(b, card, 0.18f * high, 0.003f, 0.08f * card);
            dmg_restore(b);
        }
        if (rod) dmg_rod(b, v3(0, -0.35f * high, -0.9f * drawer.depth), v3(0, -0.35f * high, 0.008f), 0.004f);
        if (latch) { /* a thumb latch that slides aside beside the handle */
            dmg_slide(b, part, "latch", v3(1, 0, 0), 0.0f, 0.012f);
            dmg_box(b, v3(0.3f * wide, 0.2f * high, 0.006f), v3(0.02f, 0.015f, 0.01f));
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (!lock) return;
    dmg_vec at = v3(0.5f * size.x - wall - 0.03f, size.y - 0.5f * wall, 0); /* on the top rail */
    dmg_hinge(b, 0, "lock", at, v3(0, 0, -1), 0.0f, 1.57f);
    dmg_rod(b, at, v3_add(at, v3(0, 0, 0.008f)), 0.45f * wall);
    dmg_box(b, v3_add(at, v3(0, 0, 0.018f)), v3(0.2f * wall, 0.8f * wall, 0.02f));
    dmg_use(b, 0);
}

/* Fronts that lift and are then pushed in above the shelf behind them, one part on the other. */
static void draw_receding(dmg_builder* b, dmg_vec size) {
    int rows = dmg_int(b, 2, 5);
    float wall = 0.02f, each = (size.y - wall) / (float)rows, t = 0.015f;
    dmg_handle handle = dmg_handle_pick(b, 0.12f);
    bool rolls = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * size.y, 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, size.x, size.y, size.z, wall);
    dmg_restore(b);
    for (int i = 0; i < rows; ++i) {
        float y = wall + each * (float)i, top = y + each - wall - 0.5f * t;
        dmg_box_span(b, v3(-0.5f * size.x + wall, y + each - wall, -size.z + wall),
                     v3(0.5f * size.x - wall, y + each - 0.6f * wall, -2 * t));
        dmg_box(b, v3(0, y + 0.35f * each, -0.5f * size.z),
                v3(0.8f * size.x, 0.6f * each, 0.5f * size.z)); /* the files */
        uint32_t glide = dmg_slide(b, 0, "glide", v3(0, 0, -1), 0.0f, rolls ? 0.6f * size.z : 0.02f);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * (0.5f * size.x - wall - 0.5f * t), top, -1.6f * t), v3(0.8f * t, t, 1.5f * t));
        dmg_hinge(b, glide, "front", v3(0, top, -t), v3(-1, 0, 0), 0.0f, 1.5f);
        dmg_box_span(b, v3(-0.5f * size.x + wall + 0.003f, y + 0.003f, -t),
                     v3(0.5f * size.x - wall - 0.003f, top + 0.4f * t, 0));
        dmg_save(b);
        dmg_move(b, 0, y + 0.2f * each, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_handle_draw(b, &handle, 0.4f * size.x);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Slats on a cloth that run aside or down in grooves, behind a panel that closes the other half of the front. */
static void draw_tambour(dmg_builder* b, dmg_vec size) {
    float wall = 0.02f, wide = size.x - 2 * wall, high = size.y - 2 * wall, t = 0.01f,
          share = dmg_range(b, 0.45f, 0.52f);
    int slats = dmg_int(b, 10, 24), shelves = dmg_int(b, 2, 4);
    bool across = dmg_chance(b, 0.6f);
    float rest = dmg_chance(b, 0.5f) ? 0.0f : 0.9f * dmg_unit(b), run = (across ? wide : high) * share,
          x0 = -0.5f * wide;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * size.y, 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, size.x, size.y, size.z, wall);
    dmg_restore(b);
    for (int i = 1; i < shelves; ++i) {
        float y = wall + high * (float)i / (float)shelves;
        dmg_box_span(b, v3(x0, y, -size.z + wall), v3(-x0, y + 0.6f * wall, -4 * t));
    }
    dmg_box_span(b, v3(x0, wall, -t), v3(across ? -x0 - run : -x0, across ? wall + high : wall + high - run, 0));
    uint32_t front = dmg_slide(b, 0, "tambour", across ? v3(-1, 0, 0) : v3(0, -1, 0), 0.0f, 0.9f * run);
    dmg_rest(b, front, run * rest);
    float left = across ? -x0 - run : x0, low = across ? wall : wall + high - run;
    for (int i = 0; i < slats; ++i) {
        float from = run * (float)i / (float)slats, to = run * ((float)i + 0.93f) / (float)slats;
        dmg_box_span(b, v3(across ? left + from : left, across ? low : low + from, -2.5f * t),
                     v3(across ? left + to : -x0, across ? low + high : low + to, -1.5f * t));
    }
    dmg_box_span(b, v3(left, low, -2.9f * t), v3(-x0, wall + high, -2.5f * t));
    if (across)
        dmg_box(b, v3(-x0 - 0.02f, 0.5f * size.y, -1.3f * t), v3(0.02f, 0.2f * high, 0.5f * t));
    else
        dmg_box(b, v3(0, wall + high - 0.02f, -1.3f * t), v3(0.3f * wide, 0.02f, 0.5f * t));
    dmg_use(b, 0);
}

void dmg_build_filing_cabinet(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 3, 3, 3, 2, 2}, 6), feet = dmg_int(b, 0, DMG_FEET_KINDS - 1);
    dmg_vec size = pick_size(b, 0.36f, 0.5f, 0.6f, 1.4f, 0.45f, 0.7f);
    int columns = 1, rows = dmg_int(b, 2, 5);
    if (kind == 1) /* lateral */
        size.x = dmg_range(b, 0.75f, 1.1f);
    if (kind == 2) { /* plans lie flat */
        size = pick_size(b, 0.9f, 1.5f, 0.4f, 1.1f, 0.65f, 1.0f);
        rows = 4 + (int)(size.y / 0.12f);
    }
    if (kind == 3) { /* cards */
        size = pick_size(b, 0.4f, 1.0f, 0.3f, 1.3f, 0.35f, 0.5f);
        columns = 1 + (int)(size.x / 0.18f);
        rows = 1 + (int)(size.y / 0.15f);
        while (columns * rows > 24) --rows;
    }
    if (kind > 3) size = pick_size(b, 0.7f, 1.2f, 0.8f, 2.0f, 0.4f, 0.5f);
    float foot = feet == 0 ? 0.0f : dmg_range(b, 0.04f, kind == 3 || kind == 2 ? 0.4f : 0.12f),
          hand = kind == 3 ? 0.05f : 0.12f;
    if (foot > 0.0f) {
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * size.z);
        dmg_feet_draw(b, feet, size.x, size.z, foot);
        dmg_restore(b);
    }
    dmg_move(b, 0, foot, 0);
    if (kind < 4) draw_files(b, size, columns, rows, hand);
    if (kind == 4) draw_receding(b, size);
    if (kind == 5) draw_tambour(b, size);
}
