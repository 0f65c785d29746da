/* Draws copiers with feeders, trays and doors; cash registers, card terminals, cash dispensers. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a flap on z = 0, hung below or at its side, `at` its middle. */
static void draw_flap(dmg_builder* b, const char* name, dmg_vec at, float wide, float high, float t, dmg_side side) {
    dmg_leaf leaf = dmg_leaf_pick(b, 0.06f);
    leaf.width = wide;
    leaf.height = high;
    leaf.thickness = t;
    leaf.side = side;
    if (leaf.panel.kind >= DMG_PANEL_FRAMED) leaf.panel.kind = DMG_PANEL_ROUNDED;
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    dmg_leaf_draw(b, 0, name, &leaf);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- copiers ---- */

typedef struct copier {
    float x, z, foot, deck, glass; /* half sizes; heights: below the cassettes, above them, of the glass */
} copier;

/* Draws a panel before the glass that tilts on its rear edge or on its front one. */
static void draw_copier_panel(dmg_builder* b, const copier* c) {
    float wide = 2 * c->x * dmg_range(b, 0.45f, 0.95f), deep = dmg_range(b, 0.12f, 0.2f), t = 0.03f,
          lean = dmg_range(b, 0.0f, 0.5f);
    bool tilts = dmg_chance(b, 0.65f);
    dmg_save(b);
    dmg_move(b, 0, c->glass - 0.03f, c->z);
    dmg_turn(b, v3(1, 0, 0), lean);
    uint32_t panel = tilts ? dmg_hinge(b, 0, "panel", v3(0, 0, 0), v3(1, 0, 0), -lean, 1.2f - lean) : 0;
    dmg_box_span(b, v3(-0.5f * wide, -0.5f * t, 0), v3(0.5f * wide, 0.5f * t, deep));
    dmg_box_span(b, v3(-0.4f * wide, 0.5f * t, 0.2f * deep), v3(0.05f * wide, 0.6f * t, 0.85f * deep));
    dmg_move(b, 0.25f * wide, 0.5f * t, 0.5f * deep);
    dmg_face_up(b);
    dmg_buttons keys = {.name = "key",
                        .columns = 3,
                        .rows = 4,
                        .pitch_x = 0.022f,
                        .pitch_y = 0.022f,
                        .width = 0.016f,
                        .height = 0.014f,
                        .rise = 0.004f,
                        .travel = 0.003f};
    keys.kind = dmg_int(b, 0, 3);
    keys.columns = dmg_int(b, 1, 4);
    if (dmg_chance(b, 0.7f)) dmg_buttons_draw(b, panel, &keys);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws the lid over the glass; a feeder on it has its own cover and a tray that folds up. */
static void draw_copier_lid(dmg_builder* b, const copier* c) {
    bool feeder = dmg_chance(b, 0.6f);
    float t = feeder ? dmg_range(b, 0.08f, 0.14f) : dmg_range(b, 0.02f, 0.05f), y = c->glass + 0.004f,
          box = 0.7f * c->x, swing = dmg_range(b, 0.9f, 1.5f), up = dmg_range(b, 0.5f, 1.2f);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3(0.6f * c->x * (float)s, c->glass + 0.005f, -c->z + 0.01f), v3(0.08f, 0.03f, 0.02f));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, y + 0.01f, -c->z + 0.02f), v3(-1, 0, 0), 0.0f, swing);
    dmg_box_span(b, v3(-0.98f * c->x, y, -c->z + 0.025f), v3(0.98f * c->x, y + (feeder ? 0.03f : t), 0.96f * c->z));
    if (!feeder) {
        if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, y + 0.5f * t, 0.98f * c->z), v3(0.2f, 0.4f * t, 0.06f));
        dmg_use(b, 0);
        return;
    }
    dmg_box_span(b, v3(-0.98f * c->x, y + 0.03f, -c->z + 0.03f), v3(-0.98f * c->x + box, y + 0.6f * t, 0.9f * c->z));
    dmg_hinge(b, lid, "feeder_cover", v3(-0.98f * c->x, y + 0.62f * t, 0), v3(0, 0, 1), 0.0f, 1.4f);
    dmg_box_span(b, v3(-0.98f * c->x, y + 0.62f * t, -c->z + 0.03f),
                 v3(-0.98f * c->x + box, y + 1.2f * t, 0.9f * c->z));
    dmg_vec pin = v3(-0.95f * c->x + box, y + 0.8f * t, 0);
    uint32_t tray = dmg_hinge(b, lid, "feeder_tray", pin, v3(0, 0, 1), 0.0f, up);
    dmg_beam(b, pin, v3(0.9f * c->x, y + 1.3f * t, 0), 1.2f * c->z, 0.012f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_slide(b, tray, "guide", v3(0, 0, (float)s), -0.2f * c->z, 0.1f * c->z);
        dmg_box(b, v3(0.25f * c->x, y + 1.1f * t + 0.03f, 0.4f * c->z * (float)s), v3(0.3f * c->x, 0.02f, 0.006f));
    }
    dmg_use(b, 0);
}

/* Cassettes below, a door to the toner before them or above, flaps at the side, a tray that folds out, a finisher. */
static void draw_copier_body(dmg_builder* b, const copier* c) {
    int trays = dmg_int(b, 1, 4);
    float each = (c->deck - c->foot) / (float)trays, body = c->glass - 0.06f, gap = dmg_chance(b, 0.5f) ? 0.12f : 0.0f,
          door = body - gap - c->deck;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (c->foot + c->deck), c->z);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * c->x, c->deck - c->foot, 2 * c->z, 0.015f);
    dmg_restore(b);
    dmg_drawer drawer = dmg_drawer_pick(b, 0.12f);
    drawer.width = 2 * c->x - 0.034f;
    drawer.height = each - 0.006f - 0.03f / (float)trays;
    drawer.depth = 1.8f * c->z;
    drawer.travel = c->z * dmg_range(b, 0.8f, 1.5f);
    for (int i = 0; i < trays; ++i) {
        dmg_save(b);
        dmg_move(b, 0, c->foot + 0.015f + (each - 0.03f / (float)trays) * ((float)i + 0.5f), c->z);
        dmg_drawer_draw(b, 0, "cassette", &drawer);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-c->x, c->deck, -c->z), v3(c->x, body - gap, c->z));
    if (gap > 0.0f) { /* sheets come out between scanner and engine */
        dmg_box_span(b, v3(-c->x, body - gap, -c->z), v3(c->x, body, -0.7f * c->z));
        dmg_box_span(b, v3(0.75f * c->x, body - gap, -0.7f * c->z), v3(c->x, body, 0.9f * c->z));
    }
    dmg_box_span(b, v3(-c->x, body, -c->z), v3(c->x, c->glass, c->z));
    float t = 0.02f;
    draw_flap(b, "toner_door", v3(0, c->deck + 0.5f * door, c->z + t), 1.9f * c->x, 0.9f * door, t,
              dmg_chance(b, 0.7f) ? DMG_SIDE_BOTTOM : DMG_SIDE_LEFT);
    if (dmg_chance(b, 0.7f)) { /* jams are cleared at the right; a tray hangs on the same side */
        dmg_save(b);
        dmg_move(b, c->x + t, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        draw_flap(b, "side_door", v3(0, c->deck + 0.6f * door, 0), 1.5f * c->z, 0.6f * door, t,
                  dmg_chance(b, 0.6f) ? DMG_SIDE_RIGHT : DMG_SIDE_BOTTOM);
        dmg_hinge(b, 0, "bypass", v3(0, c->deck + 0.03f, 0), v3(1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.5f));
        dmg_box_span(b, v3(-0.6f * c->z, c->deck + 0.03f, -0.5f * t),
                     v3(0.6f * c->z, c->deck + 0.26f * door, 0.4f * t));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) { /* sheets land on a tray at the left that rides up and down */
        float wide = 0.6f * c->x;
        dmg_box_span(b, v3(-c->x - 0.12f, c->foot, -0.8f * c->z), v3(-c->x, body - 0.05f, 0.8f * c->z));
        dmg_slide(b, 0, "output_tray", v3(0, -1, 0), 0.0f, 0.6f * (body - c->foot));
        dmg_beam(b, v3(-c->x - 0.121f, body - 0.2f, 0), v3(-c->x - 0.12f - wide, body - 0.12f, 0), 1.3f * c->z, 0.012f);
        dmg_use(b, 0);
    }
}

void dmg_build_photocopier(dmg_builder* b) {
    bool desk = dmg_chance(b, 0.3f);
    copier c = {.x = dmg_range(b, 0.24f, 0.34f)};
    c.z = c.x * dmg_range(b, 0.85f, 1.1f);
    c.foot = desk ? 0.015f : dmg_range(b, 0.04f, 0.1f);
    c.deck = c.foot + (desk ? dmg_range(b, 0.1f, 0.2f) : dmg_range(b, 0.3f, 0.5f));
    c.glass = c.deck + dmg_range(b, 0.3f, 0.5f);
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.85f : -0.85f) * c.x, z = (i & 2 ? 0.85f : -0.85f) * c.z;
        dmg_rod(b, v3(x - 0.01f, 0.5f * c.foot, z), v3(x + 0.01f, 0.5f * c.foot, z), 0.5f * c.foot);
    }
    draw_copier_body(b, &c);
    draw_copier_panel(b, &c);
    draw_copier_lid(b, &c);
}

/* ---- tills ---- */

static void draw_key_field(dmg_builder* b, uint32_t parent, int columns, int rows, float pitch) {
    dmg_buttons keys = {.name = "key",
                        .columns = columns,
                        .rows = rows,
                        .pitch_x = pitch,
                        .pitch_y = pitch,
                        .width = 0.8f * pitch,
                        .height = 0.75f * pitch,
                        .rise = 0.35f * pitch};
    keys.travel = dmg_button_way(b, keys.rise);
    keys.kind = dmg_int(b, 0, 3);
    dmg_buttons_draw(b, parent, &keys);
}

/* Draws a drawer under a sloped housing: keys, printer lid, displays for clerk and customer, a lock. */
static void draw_register(dmg_builder* b) {
    float x = dmg_range(b, 0.16f, 0.24f), z = x * dmg_range(b, 0.9f, 1.15f), low = dmg_range(b, 0.08f, 0.13f),
          front = low + dmg_range(b, 0.04f, 0.08f), high = front + dmg_range(b, 0.08f, 0.16f),
          travel = z * dmg_range(b, 0.8f, 1.5f), lean = atanf((high - front) / (1.1f * z)),
          turn = dmg_range(b, 0.8f, 3.0f);
    bool crank = dmg_chance(b, 0.15f), pole = dmg_chance(b, 0.6f);
    int columns = dmg_int(b, 4, 8), rows = dmg_int(b, 3, 5);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * low, z);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * x, low, 2 * z, 0.006f);
    dmg_restore(b);
    dmg_drawer drawer = dmg_drawer_pick(b, 0.08f);
    drawer.width = 2 * x - 0.016f;
    drawer.height = low - 0.018f;
    drawer.depth = 1.85f * z;
    drawer.travel = travel;
    dmg_save(b);
    dmg_move(b, 0, 0.5f * low, z);
    dmg_drawer_draw(b, 0, "drawer", &drawer);
    dmg_restore(b);
    dmg_use(b, 0);
    const dmg_xy side[] = {{-z, low}, {0.9f * z, low}, {0.9f * z, front}, {-0.2f * z, high}, {-z, high}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_extrude(b, side, 5, -0.95f * x, 0.95f * x);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, -0.2f * x, 0.5f * (front + high), 0.35f * z);
    dmg_turn(b, v3(1, 0, 0), lean - 0.5f * DMG_PI);
    draw_key_field(b, 0, columns, rows, fminf(1.3f * x / (float)columns, 0.9f * z / (float)rows));
    dmg_restore(b);
    dmg_hinge(b, 0, "printer_lid", v3(0.5f * x, high + 0.004f, -0.9f * z), v3(-1, 0, 0), 0.0f,
              1.5f); /* over the paper roll */
    dmg_box_span(b, v3(0.2f * x, high + 0.001f, -0.9f * z), v3(0.85f * x, high + 0.03f, -0.25f * z));
    dmg_use(b, 0);
    float top = high + (pole ? dmg_range(b, 0.05f, 0.2f) : 0.01f), at = -0.4f * x;
    dmg_rod(b, v3(at, high, -0.6f * z), v3(at, top, -0.6f * z), 0.012f);
    uint32_t display = dmg_hinge(b, 0, "display", v3(at, top, -0.6f * z), v3(0, 1, 0), -turn, turn);
    dmg_rod(b, v3(at, top, -0.6f * z), v3(at, top + 0.01f, -0.6f * z), 0.02f);
    if (dmg_chance(b, 0.6f)) dmg_hinge(b, display, "screen", v3(at, top + 0.02f, -0.6f * z), v3(1, 0, 0), -0.7f, 0.3f);
    dmg_box_span(b, v3(at - 0.45f * x, top + 0.012f, -0.6f * z - 0.012f),
                 v3(at + 0.45f * x, top + 0.35f * x, -0.6f * z + 0.012f));
    dmg_use(b, 0);
    dmg_vec lock = v3(0.7f * x, front + 0.3f * (high - front), 0.9f * z - 0.28f * 1.1f * z);
    if (crank) { /* pulled to ring up */
        dmg_hinge(b, 0, "crank", v3(0.95f * x, low + 0.04f, 0), v3(1, 0, 0), 0.0f, 1.6f);
        dmg_rod(b, v3(0.95f * x, low + 0.04f, 0), v3(1.08f * x, low + 0.04f, 0), 0.015f);
        dmg_beam(b, v3(1.06f * x, low + 0.04f, 0), v3(1.06f * x, low + 0.15f, 0), 0.012f, 0.02f);
        dmg_rod(b, v3(1.06f * x, low + 0.15f, 0), v3(1.35f * x, low + 0.15f, 0), 0.012f);
    } else {
        dmg_hinge(b, 0, "mode_key", lock, v3(0, cosf(lean), sinf(lean)), -1.0f, 1.0f);
        dmg_rod(b, lock, v3_mad(lock, v3(0, cosf(lean), sinf(lean)), 0.008f), 0.012f);
        dmg_box(b, v3_mad(lock, v3(0, cosf(lean), sinf(lean)), 0.016f), v3(0.004f, 0.02f, 0.014f));
    }
    dmg_use(b, 0);
}

/* Draws a terminal in the hand or in a cradle that turns and tilts: keys, a paper lid, a card that is pushed in. */
static void draw_card_terminal(dmg_builder* b) {
    float x = dmg_range(b, 0.035f, 0.05f), z = x * dmg_range(b, 2.0f, 2.6f), t = dmg_range(b, 0.025f, 0.05f),
          tilt = dmg_range(b, 0.3f, 0.8f);
    uint32_t body = 0;
    if (dmg_chance(b, 0.5f)) {
        float post = dmg_range(b, 0.06f, 0.2f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.01f, 0), 1.4f * x);
        dmg_rod(b, v3(0, 0.01f, 0), v3(0, post, 0), 0.25f * x);
        body = dmg_hinge(b, 0, "stand", v3(0, 0, 0), v3(0, 1, 0), -2.5f, 2.5f);
        dmg_box_span(b, v3(-0.4f * x, post, -0.3f * x), v3(0.4f * x, post + 0.8f * x, 0.3f * x));
        dmg_move(b, 0, post + 0.9f * x, 0);
        body = dmg_hinge(b, body, "cradle", v3(0, -0.2f * x, 0), v3(1, 0, 0), -0.3f, tilt);
        dmg_box_span(b, v3(-1.08f * x, -0.05f * x, -0.7f * z), v3(1.08f * x, 0.0f, 0.7f * z));
    }
    dmg_rounded_box(b, v3(0, 0.5f * t, 0), v3(2 * x, t, 2 * z), 0.25f * t);
    dmg_box_span(b, v3(-0.75f * x, t, -0.35f * z), v3(0.75f * x, 1.04f * t, 0.1f * z));
    dmg_save(b);
    dmg_move(b, 0, t, 0.5f * z);
    dmg_face_up(b);
    draw_key_field(b, body, dmg_int(b, 3, 4), 4, 0.42f * x);
    dmg_restore(b);
    dmg_hinge(b, body, "paper_lid", v3(0, t, -0.9f * z), v3(-1, 0, 0), 0.0f, 1.6f);
    dmg_box_span(b, v3(-0.8f * x, 1.002f * t, -0.95f * z), v3(0.8f * x, 1.35f * t, -0.45f * z));
    dmg_slide(b, body, "card", v3(0, 0, -1), 0.0f, 0.35f * z);
    dmg_box_span(b, v3(-0.7f * x, 0.3f * t, 0.8f * z), v3(0.7f * x, 0.33f * t, 1.7f * z));
    dmg_use(b, 0);
}

/* Draws a cash dispenser: keys, screen, a shutter over the notes, the door of the safe below, a hood that lifts. */
static void draw_cash_dispenser(dmg_builder* b) {
    float x = dmg_range(b, 0.24f, 0.4f), z = x * dmg_range(b, 1.0f, 1.4f), shelf = dmg_range(b, 0.8f, 0.95f),
          high = dmg_range(b, 1.35f, 1.7f), deep = dmg_range(b, 0.1f, 0.2f), t = 0.02f;
    bool hood = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-x, 0, -z), v3(x, shelf, z));
    dmg_box_span(b, v3(-x, shelf, -z), v3(x, high, z - deep));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * (x - 0.5f * t) - 0.5f * t, shelf, z - deep),
                     v3((float)s * (x - 0.5f * t) + 0.5f * t, high, z));
    dmg_box_span(b, v3(-0.7f * x, shelf + 0.2f, z - deep), v3(0.3f * x, shelf + 0.2f + 0.7f * x, z - deep + 0.01f));
    dmg_save(b);
    dmg_move(b, -0.2f * x, shelf, z - 0.45f * deep);
    dmg_face_up(b);
    draw_key_field(b, 0, 4, 4, 0.2f * deep);
    dmg_restore(b);
    dmg_slide(b, 0, "shutter", dmg_chance(b, 0.5f) ? v3(0, 1, 0) : v3(1, 0, 0), 0.0f, 0.03f);
    dmg_box_span(b, v3(-0.4f * x, shelf + 0.06f, z - deep + 0.001f), v3(0.2f * x, shelf + 0.09f, z - deep + 0.008f));
    dmg_use(b, 0);
    for (int i = 0; i < 4; ++i) {
        dmg_slide(b, 0, "side_key", v3(0, 0, -1), 0.0f, 0.006f);
        dmg_box(b, v3(0.42f * x, shelf + 0.25f + 0.12f * x * (float)i, z - deep + 0.005f),
                v3(0.06f * x, 0.05f * x, 0.012f));
        dmg_use(b, 0);
    }
    dmg_slide(b, 0, "card", v3(0, 0, -1), 0.0f, 0.05f);
    dmg_box(b, v3(0.7f * x, shelf + 0.3f, z - deep + 0.03f), v3(0.054f, 0.003f, 0.08f));
    dmg_use(b, 0);
    draw_flap(b, "safe_door", v3(0, 0.5f * shelf, z + t), 1.9f * x, 0.92f * shelf, t,
              dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
    if (!hood) return;
    dmg_hinge(b, 0, "hood", v3(0, high, -z), v3(-1, 0, 0), 0.0f, 0.9f);
    dmg_box_span(b, v3(-x, high + 0.002f, -z), v3(x, high + 0.08f, z));
    dmg_use(b, 0);
}

void dmg_build_cash_register(dmg_builder* b) {
    switch (dmg_weighted(b, (const float[]){3, 1, 1}, 3)) {
    case 0:
        draw_register(b);
        break;
    case 1:
        draw_card_terminal(b);
        break;
    default:
        draw_cash_dispenser(b);
        break;
    }
}
