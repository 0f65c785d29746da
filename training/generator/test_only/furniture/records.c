/* Draws filing cabinets, plan chests, card indexes, doors that recede, rolling fronts; computer cases and server
 * racks. */
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

/* ---- computers ---- */

/* Draws what shows once the side is off: board, cards, supply, a cooler whose fan turns. */
static void draw_innards(dmg_builder* b, dmg_vec size) {
    float x = -0.45f * size.x, y = size.y, z = size.z;
    int cards = dmg_int(b, 1, 4);
    dmg_box(b, v3(x, 0.58f * y, -0.55f * z), v3(0.02f * size.x, 0.6f * y, 0.5f * z));
    dmg_box_span(b, v3(-0.44f * size.x, 0.04f * y, -0.97f * z), v3(0.4f * size.x, 0.22f * y, -0.6f * z));
    for (int i = 0; i < cards; ++i)
        dmg_box(b, v3(-0.1f * size.x, (0.5f - 0.06f * (float)i) * y, -0.7f * z),
                v3(0.6f * size.x, 0.02f * y, 0.45f * z));
    dmg_box(b, v3(-0.2f * size.x, 0.7f * y, -0.6f * z), v3(0.4f * size.x, 0.16f * y, 0.16f * y));
    dmg_save(b);
    dmg_move(b, 0.03f * size.x, 0.7f * y, -0.6f * z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, 0, "fan", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.06f * size.x), 0.025f * y);
    dmg_blades_draw(b, 0, 0.075f * y, 0.02f * y, 0.03f * y, 7, 0.5f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws the side panel: hung behind or in front like a door, below like a flap, or pulled back off its rails. */
static void draw_side_panel(dmg_builder* b, dmg_vec size, float t) {
    float x = 0.5f * size.x + t, z = size.z, y = size.y;
    dmg_panel panel = dmg_chance(b, 0.5f) ? dmg_panel_pick_window(b) : dmg_panel_pick(b);
    if (panel.kind == DMG_PANEL_SHEET || panel.kind == DMG_PANEL_HOLLOW) panel.kind = DMG_PANEL_FLAT;
    uint32_t part = 0;
    switch (dmg_int(b, 0, 3)) {
    case 0:
        part = dmg_hinge(b, 0, "side_panel", v3(x, 0, -z), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
        break;
    case 1:
        part = dmg_hinge(b, 0, "side_panel", v3(x, 0, 0), v3(0, -1, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
        break;
    case 2:
        part = dmg_hinge(b, 0, "side_panel", v3(x, 0, 0), v3(0, 0, -1), 0.0f, 1.3f);
        break;
    default:
        part = dmg_slide(b, 0, "side_panel", v3(0, 0, -1), 0.0f, 0.5f * z);
        break;
    }
    if (dmg_chance(b, 0.3f)) dmg_rest(b, part, b->parts[part - 1].joint.upper * dmg_unit(b));
    dmg_save(b);
    dmg_move(b, x, 0.5f * y, -0.5f * z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_panel_draw(b, &panel, 0.99f * z, 0.97f * y, t);
    dmg_move(b, dmg_sign(b) * 0.4f * z, 0, 0);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(0, 0, 0.01f), v3(0.02f, 0.2f * y, 0.02f));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* In front: a tray for discs, sleds or blanks, buttons, a cover over the ports, a door over all of it or a grille. */
static void draw_tower_front(dmg_builder* b, dmg_vec size) {
    float w = 0.86f * size.x, y = size.y, bay = 0.085f * y;
    int bays = dmg_int(b, 0, 3), sleds = dmg_chance(b, 0.35f) ? dmg_int(b, 2, 5) : 0;
    bool door = dmg_chance(b, 0.35f), flap = dmg_chance(b, 0.3f);
    float at = 0.94f * y;
    for (int i = 0; i < bays; ++i, at -= 1.1f * bay) {
        dmg_slide(b, 0, "disc_tray", v3(0, 0, 1), 0.0f, 0.14f);
        dmg_box_span(b, v3(-0.45f * w, at - 0.55f * bay, 0), v3(0.45f * w, at - 0.1f * bay, 0.003f));
        dmg_box_span(b, v3(-0.42f * w, at - 0.5f * bay, -0.15f), v3(0.42f * w, at - 0.35f * bay, 0));
        dmg_slide(b, 0, "eject", v3(0, 0, -1), 0.0f, 0.002f);
        dmg_box(b, v3(0.38f * w, at - 0.8f * bay, 0.002f), v3(0.1f * w, 0.15f * bay, 0.004f));
        dmg_use(b, 0);
    }
    for (int i = 0; i < sleds; ++i, at -= 1.05f * bay) { /* a drive with a lever that lets it go */
        uint32_t sled = dmg_slide(b, 0, "drive", v3(0, 0, 1), 0.0f, 0.16f);
        dmg_box_span(b, v3(-0.45f * w, at - bay, -0.17f), v3(0.45f * w, at, 0.004f));
        dmg_hinge(b, sled, "drive_lever", v3(-0.4f * w, 0, 0.006f), v3(0, -1, 0), 0.0f, 1.0f);
        dmg_box_span(b, v3(-0.4f * w, at - 0.7f * bay, 0.006f), v3(0.38f * w, at - 0.3f * bay, 0.012f));
        dmg_use(b, 0);
    }
    for (int i = 0; i < 2; ++i) {
        float r = (i ? 0.025f : 0.045f) * size.x + 0.002f, x = i ? 0.25f * w : 0.0f;
        dmg_slide(b, 0, i ? "reset" : "power", v3(0, 0, -1), 0.0f, 0.003f);
        if (i) dmg_box(b, v3(x, at - 0.5f * bay, 0.002f), v3(2 * r, r, 0.005f));
        if (!i) dmg_rod(b, v3(x, at - 0.5f * bay, -0.002f), v3(x, at - 0.5f * bay, 0.005f), r);
        dmg_use(b, 0);
    }
    if (flap) {
        dmg_hinge(b, 0, "port_cover", v3(0, 0.1f * y, 0.004f), v3(1, 0, 0), 0.0f, 1.8f);
        dmg_box_span(b, v3(-0.4f * w, 0.1f * y, 0.001f), v3(0.4f * w, 0.18f * y, 0.007f));
        dmg_use(b, 0);
    }
    dmg_leaf leaf = dmg_leaf_pick(b, 0.06f);
    leaf.width = size.x;
    leaf.height = 0.99f * y;
    leaf.thickness = 0.02f;
    leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * y, 0.035f);
    if (door) dmg_leaf_draw(b, 0, "front_door", &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_tower(dmg_builder* b) {
    dmg_vec size = pick_size(b, 0.15f, 0.25f, 0.33f, 0.6f, 0.35f, 0.6f);
    float t = 0.006f, foot = dmg_range(b, 0.008f, 0.03f);
    bool lies = dmg_chance(b, 0.15f), top = dmg_chance(b, 0.25f);
    if (lies) { /* a desktop */
        dmg_move(b, 0, 0.5f * size.x + foot, 0);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        dmg_move(b, 0, -0.5f * size.y, 0);
    } else {
        dmg_move(b, 0, foot, 0);
        for (int i = 0; i < 4; ++i)
            dmg_box(b, v3((i & 1 ? 0.35f : -0.35f) * size.x, -0.5f * foot, (i & 2 ? -0.1f : -0.9f) * size.z),
                    v3(0.05f, foot, 0.05f));
    }
    dmg_box_span(b, v3(-0.5f * size.x - t, 0, -size.z), v3(-0.5f * size.x, size.y, 0));
    dmg_box_span(b, v3(-0.5f * size.x, 0, -size.z), v3(0.5f * size.x, t, 0));
    dmg_box_span(b, v3(-0.5f * size.x, size.y - t, -size.z), v3(0.5f * size.x, size.y, 0));
    dmg_box_span(b, v3(-0.5f * size.x, t, -size.z), v3(0.5f * size.x, size.y - t, -size.z + t));
    dmg_box_span(b, v3(-0.5f * size.x, t, -t), v3(0.5f * size.x, size.y - t, 0));
    draw_innards(b, size);
    draw_side_panel(b, size, t);
    draw_tower_front(b, size);
    if (!top || lies) return;
    dmg_hinge(b, 0, "top_cover", v3(0, size.y, -0.3f * size.z), v3(-1, 0, 0), 0.0f, 1.6f); /* over ports on the top */
    dmg_box_span(b, v3(-0.4f * size.x, size.y, -0.29f * size.z), v3(0.4f * size.x, size.y + t, -0.08f * size.z));
}

/* Draws one before, one or two behind. */
static void draw_rack_doors(dmg_builder* b, float wide, float high, float deep) {
    bool door = dmg_chance(b, 0.7f), rear = dmg_chance(b, 0.4f), split = dmg_chance(b, 0.3f);
    dmg_leaf leaf = dmg_leaf_pick(b, 0.15f);
    if (dmg_chance(b, 0.5f)) leaf.panel.kind = DMG_PANEL_BARS;
    leaf.height = high - 0.01f;
    leaf.thickness = 0.025f;
    leaf.side = dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
    for (int i = 0; i < 2; ++i) {
        if (!(i ? rear : door)) continue;
        bool two = i ? split : false;
        leaf.width = two ? 0.5f * wide - 0.003f : wide;
        for (int k = two ? -1 : 1; k <= 1; k += 2) {
            if (two) leaf.side = k < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
            dmg_save(b);
            if (i) {
                dmg_move(b, 0, 0, -deep);
                dmg_turn(b, v3(0, 1, 0), DMG_PI);
            }
            dmg_move(b, two ? 0.25f * wide * (float)k : 0.0f, 0.5f * high, 0.055f);
            dmg_leaf_draw(b, 0, i ? "rear_door" : "door", &leaf);
            dmg_restore(b);
            dmg_use(b, 0);
        }
    }
}

/* Posts with servers that come out on rails, doors of mesh before and behind, side panels, a shelf with a keyboard. */
static void draw_rack(dmg_builder* b) {
    float unit = 0.0445f, wide = 0.6f, deep = dmg_range(b, 0.6f, 1.0f), foot = dmg_range(b, 0.03f, 0.1f);
    int units = dmg_int(b, 8, 42), used = 0, parts = 0;
    float high = unit * (float)units + 0.08f;
    bool skin = dmg_chance(b, 0.6f);
    dmg_move(b, 0, foot, 0.5f * deep);
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.27f : -0.27f), z = i & 2 ? -0.04f : -deep + 0.04f;
        dmg_box_span(b, v3(x - 0.025f, 0, z - 0.025f), v3(x + 0.025f, high, z + 0.025f));
        dmg_rod(b, v3(x, -foot, z), v3(x, 0, z), 0.02f);
    }
    dmg_box_span(b, v3(-0.5f * wide, -0.002f, -deep), v3(0.5f * wide, 0.04f, 0));
    dmg_box_span(b, v3(-0.5f * wide, high - 0.04f, -deep), v3(0.5f * wide, high, 0));
    for (int s = -1; s <= 1 && skin; s += 2)
        dmg_box_span(b, v3((float)s * 0.298f - 0.002f, 0.04f, -deep), v3((float)s * 0.298f + 0.002f, high - 0.04f, 0));
    while (used < units && parts < 24) {
        int own = dmg_weighted(b, (const float[]){5, 5, 1, 2}, 4) + 1;
        float y = 0.04f + unit * (float)used, top = y + unit * (float)own - 0.002f,
              way = deep * dmg_range(b, 0.5f, 0.85f);
        used += own;
        if (used > units || dmg_chance(b, 0.15f)) continue;
        uint32_t server = dmg_slide(b, 0, "server", v3(0, 0, 1), 0.0f, way);
        dmg_box_span(b, v3(-0.225f, y, -0.9f * deep), v3(0.225f, top, -0.02f));
        dmg_box_span(b, v3(-0.24f, y, -0.014f), v3(0.24f, top, -0.008f));
        dmg_box_span(b, v3(-0.2f, y + 0.2f * unit, -0.02f), v3(0.2f, top - 0.2f * unit, -0.004f));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0.22f * (float)s, 0.5f * (y + top), 0.004f), v3(0.012f, 0.7f * (top - y), 0.02f));
        ++parts;
        if (own == 1 && dmg_chance(b, 0.15f)) { /* a console: its screen folds up */
            dmg_hinge(b, server, "screen", v3(0, top, -0.35f), v3(-1, 0, 0), 0.0f, 1.6f);
            dmg_box_span(b, v3(-0.2f, top + 0.0002f, -0.35f), v3(0.2f, top + 0.001f, -0.06f));
        }
        dmg_use(b, 0);
    }
    draw_rack_doors(b, wide, high, deep);
}

void dmg_build_computer_tower(dmg_builder* b) {
    if (dmg_chance(b, 0.65f))
        draw_tower(b);
    else
        draw_rack(b);
}
