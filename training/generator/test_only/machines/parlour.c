/* Draws games that are machines: table football, roulette, fruit machines, cabinets for darts, baskets, table
 * tennis. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- table football: rods that slide through the walls and turn, men on them ---- */

typedef struct pitch {
    float half, length, y, t; /* across (the rods lie along X), half the length, height of the field, of the walls */
} pitch;

/* The tube slides in the walls, the men turn with the grip. */
static void draw_rod(dmg_builder* b, const pitch* p, float z, int men, float side, float spread) {
    float r = 0.012f * p->half, y = p->y + 0.16f * p->half, way = 0.12f * p->half, out = p->half + 2.5f * way,
          rest = way * dmg_range(b, -1.0f, 1.0f);
    uint32_t tube = dmg_slide(b, 0, "rod", v3(1, 0, 0), -way, way);
    dmg_rest(b, tube, rest);
    dmg_rod(b, v3(-side * out, y, z), v3(side * out, y, z), r);
    dmg_rod(b, v3(-side * out, y, z), v3(-side * (out + 2 * r), y, z), 2 * r);
    dmg_spin(b, tube, "men", v3(0, y, z), v3(1, 0, 0));
    dmg_rod(b, v3(side * out, y, z), v3(side * (out + 0.2f * p->half), y, z), 2.2f * r);
    for (int i = 0; i < men; ++i) {
        float x = spread * p->half * (men > 1 ? (float)i / (float)(men - 1) - 0.5f : 0.0f);
        dmg_box(b, v3(x, y + 0.01f * p->half, z), v3(5 * r, 0.16f * p->half, 2.6f * r));
        dmg_box(b, v3(x, y - 0.1f * p->half, z), v3(3 * r, 0.08f * p->half, 2 * r));
        dmg_ellipsoid(b, v3(x, y + 0.12f * p->half, z), v3(2 * r, 2.2f * r, 2 * r));
    }
    dmg_use(b, 0);
}

static void draw_table_football(dmg_builder* b) {
    static const int teams[8] = {1, 2, 3, 5, 5, 3, 2, 1};
    pitch p = {.half = dmg_scale_range(b, 0.15f, 0.38f)};
    bool low = p.half < 0.22f, whole = dmg_chance(b, 0.6f);
    int rods = whole ? 8 : 4;
    p.length = p.half * dmg_range(b, 1.5f, 1.9f) * (whole ? 1.0f : 0.8f);
    p.y = low ? 0.1f * p.half : p.half * dmg_range(b, 1.7f, 2.2f);
    p.t = 0.05f * p.half;
    float wall = 0.26f * p.half, foot = 0.1f * p.half, under = low ? 0.0f : p.y - 0.4f * p.half;
    dmg_box_span(b, v3(-p.half, under, -p.length), v3(p.half, p.y, p.length));
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i;
        dmg_box_span(b, v3(s * p.half - p.t, under, -p.length), v3(s * p.half + p.t, p.y + wall, p.length));
        dmg_box_span(b, v3(-p.half, under, s * p.length - p.t), v3(p.half, p.y + wall, s * p.length + p.t));
        for (int k = -1; k <= 1 && !low; k += 2)
            dmg_box_span(b, v3(s * 0.9f * p.half - foot, 0, (float)k * 0.9f * p.length - foot),
                         v3(s * 0.9f * p.half + foot, under + foot, (float)k * 0.9f * p.length + foot));
    }
    for (int i = 0; i < rods; ++i) {
        int men = whole ? teams[i] : teams[2 * i + (i > 1)];
        float z = p.length * (((float)i + 0.5f) / (float)rods * 1.9f - 0.95f),
              side = (i / (whole ? 2 : 1)) % 2 ? 1.0f : -1.0f;
        draw_rod(b, &p, z, men, side, men > 3 ? 1.3f : 0.9f);
    }
    for (int i = 0; i < 2 && dmg_chance(b, 0.6f); ++i) { /* beads that count the goals */
        float s = i ? 1.0f : -1.0f, y = p.y + wall + 0.05f * p.half, z = s * p.length;
        dmg_rod(b, v3(-0.4f * p.half, y, z), v3(0.4f * p.half, y, z), 0.01f * p.half);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * 0.4f * p.half - p.t, y - 0.08f * p.half, z - p.t),
                         v3((float)k * 0.4f * p.half + p.t, y + 0.04f * p.half, z + p.t));
        for (int k = 0; k < 4; ++k) {
            float x = p.half * (0.32f - 0.07f * (float)k);
            dmg_slide(b, 0, "bead", v3(-1, 0, 0), 0.0f, 0.4f * p.half);
            dmg_rod(b, v3(x - 0.03f * p.half, y, z), v3(x + 0.03f * p.half, y, z), 0.04f * p.half);
            dmg_use(b, 0);
        }
    }
}

/* ---- luck ---- */

/* Draws a bowl, in it the wheel with its pockets, on that a turret with four arms. */
static void draw_roulette(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.12f, 0.45f), deep = r * dmg_range(b, 0.2f, 0.35f), t = 0.05f * r;
    int pockets = dmg_int(b, 18, 37), arms = dmg_int(b, 3, 5);
    const dmg_xy bowl[] = {{0, 0},
                           {0.85f * r, 0},
                           {r, 0.3f * deep},
                           {r, deep},
                           {0.92f * r, deep},
                           {0.72f * r, 0.45f * deep},
                           {0.7f * r, 0.2f * deep},
                           {0, 0.2f * deep}};
    const dmg_xy rotor[] = {{0, 0.22f * deep},        {0.68f * r, 0.22f * deep}, {0.68f * r, 0.45f * deep},
                            {0.5f * r, 0.35f * deep}, {0.2f * r, 0.6f * deep},   {0, 0.62f * deep}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 8);
    uint32_t wheel = dmg_spin(b, 0, "wheel", v3(0, 0, 0), v3(0, 1, 0));
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), rotor, 6);
    for (int i = 0; i < pockets; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, pockets);
        dmg_box(b, v3(0.58f * r, 0.44f * deep, 0), v3(0.17f * r, 0.12f * deep, 0.01f * r));
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.5f)) dmg_spin(b, wheel, "turret", v3(0, 0, 0), v3(0, 1, 0));
    dmg_cone(b, v3(0, 0.6f * deep, 0), v3(0, deep + 2 * t, 0), 1.2f * t, 0.5f * t);
    dmg_ellipsoid(b, v3(0, deep + 2.4f * t, 0), v3(0.8f * t, 0.9f * t, 0.8f * t));
    for (int i = 0; i < arms; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, arms);
        dmg_rod(b, v3(0, deep + t, 0), v3(0.25f * r, deep + 0.6f * t, 0), 0.25f * t);
        dmg_ellipsoid(b, v3(0.25f * r, deep + 0.6f * t, 0), v3(0.5f * t, 0.5f * t, 0.5f * t));
        dmg_restore(b);
    }
}

/* Draws the lever at the right side, its boss at the height `pin`. */
static void draw_arm(dmg_builder* b, float half, float pin, float arm, float swing, float t) {
    dmg_rod(b, v3(half, pin, 0), v3(half + 1.5f * t, pin, 0), 3 * t);
    dmg_hinge(b, 0, "lever", v3(half + 2.5f * t, pin, 0), v3(1, 0, 0), 0.0f, swing);
    dmg_rod(b, v3(half + 1.5f * t, pin, 0), v3(half + 3.3f * t, pin, 0), 2 * t);
    dmg_rod(b, v3(half + 2.5f * t, pin, 0), v3(half + 2.5f * t, pin + arm, 0), 0.8f * t);
    dmg_ellipsoid(b, v3(half + 2.5f * t, pin + arm, 0), v3(2.2f * t, 2.2f * t, 2.2f * t));
    dmg_use(b, 0);
}

/* Reels behind a window, a lever at the side, keys below; the belly opens, so does the drop for the coins. */
static void draw_fruit_machine(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.12f, 0.3f), high = half * dmg_range(b, 2.4f, 5.0f),
          deep = half * dmg_range(b, 0.7f, 1.0f), t = 0.05f * half;
    int reels = dmg_int(b, 3, 5), keys = dmg_int(b, 2, 5);
    float r = 0.42f * half, y = high - 0.95f * half, each = 1.5f * half / (float)reels,
          swing = dmg_range(b, 0.8f, 1.5f);
    dmg_box_span(b, v3(-half, 0, -deep), v3(half, high, 0.35f * deep));
    dmg_box_span(b, v3(-half, 0, 0.35f * deep), v3(half, y - 0.55f * half, deep));
    dmg_box_span(b, v3(-half, y + 0.5f * half, 0.35f * deep), v3(half, high, 0.8f * deep));
    for (int i = 0; i <= reels; ++i) {
        float x = each * ((float)i - 0.5f * (float)reels);
        dmg_box_span(b, v3(x - 0.4f * t, y - 0.56f * half, 0.3f * deep),
                     v3(x + 0.4f * t, y + 0.51f * half, 0.35f * deep + 0.7f * r));
    }
    for (int i = 0; i < reels; ++i) {
        float x = each * ((float)i + 0.5f - 0.5f * (float)reels);
        dmg_spin(b, 0, "reel", v3(x, y, 0.35f * deep + 0.1f * r), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.5f * each + 0.8f * t, y, 0.35f * deep + 0.1f * r),
                v3(x + 0.5f * each - 0.8f * t, y, 0.35f * deep + 0.1f * r), r);
        dmg_use(b, 0);
    }
    float pin = y - 0.3f * half, arm = half * dmg_range(b, 0.7f, 1.1f);
    draw_arm(b, half, pin, arm, swing, t);
    dmg_buttons row = {.name = "button", .columns = keys, .rows = 1, .rise = 0.6f * t, .kind = dmg_int(b, 0, 3)};
    row.pitch_x = 1.6f * half / (float)keys;
    row.width = 0.7f * row.pitch_x;
    row.height = 0.15f * half;
    row.travel = dmg_button_way(b, row.rise);
    dmg_save(b);
    dmg_move(b, 0, y - 0.55f * half, 0.85f * deep);
    dmg_face_up(b);
    dmg_buttons_draw(b, 0, &row);
    dmg_restore(b);
    float top = y - 0.75f * half;
    if (dmg_chance(b, 0.7f)) {
        dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * half);
        leaf.width = 1.7f * half;
        leaf.height = top - 0.25f * half;
        leaf.thickness = t;
        dmg_move(b, 0, 0.5f * (top + 0.25f * half), deep + t);
        if (leaf.height > 0.4f * half) dmg_leaf_draw(b, 0, "belly_door", &leaf);
    }
}

/* ---- on walls and poles ---- */

/* Doors with slates, the board between them turned now and then. */
static void draw_dart_cabinet(dmg_builder* b) {
    float half = dmg_range(b, 0.26f, 0.34f), high = half * dmg_range(b, 2.0f, 2.5f),
          deep = half * dmg_range(b, 0.2f, 0.35f), t = 0.05f * half, r = 0.82f * half;
    dmg_move(b, 0, 0.5f * high, 0);
    dmg_case_draw(b, DMG_CASE_BOARDS, 2 * half, high, deep, t);
    dmg_spin(b, 0, "board", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, -deep + 1.01f * t), v3(0, 0, -deep + 2.5f * t), r);
    for (int i = 0; i < 20; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 20);
        dmg_box(b, v3(0.45f * r, 0, -deep + 2.5f * t), v3(0.75f * r, 0.01f * r, 0.1f * t));
        dmg_restore(b);
    }
    dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * half);
    leaf.width = 0.99f * half;
    leaf.height = high;
    leaf.thickness = 1.5f * t;
    leaf.swing = dmg_range(b, 1.6f, 2.9f);
    for (int i = -1; i <= 1; i += 2) {
        dmg_save(b);
        dmg_move(b, (float)i * 0.5f * half, 0, 1.6f * t);
        leaf.side = i < 0 ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT;
        dmg_leaf_draw(b, 0, "door", &leaf);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* On a base that rolls: two bars hold the board at any height; the rim gives way under a hand. */
static void draw_basket(dmg_builder* b) {
    float scale = dmg_scale_range(b, 0.4f, 1.0f), pole = 2.3f, t = 0.05f, up = dmg_range(b, 0.3f, 0.6f);
    dmg_grow(b, scale);
    dmg_box_span(b, v3(-0.4f, 0.05f, -1.1f), v3(0.4f, 0.25f, -0.2f));
    for (int i = -1; i <= 1; i += 2) {
        dmg_spin(b, 0, "wheel", v3((float)i * 0.43f, 0.1f, -0.3f), v3(1, 0, 0));
        dmg_rod(b, v3((float)i * 0.405f, 0.1f, -0.3f), v3((float)i * 0.46f, 0.1f, -0.3f), 0.1f);
        dmg_use(b, 0);
    }
    dmg_box_span(b, v3(-t, 0.2f, -0.65f), v3(t, pole, -0.55f));
    float reach = 0.7f, y = pole - 0.1f, z = -0.6f;
    for (int i = 0; i < 2; ++i) { /* the upper bar carries the board, turned back on its end */
        float level = y - 0.35f * (float)(1 - i);
        uint32_t bar = dmg_hinge(b, 0, "bar", v3(0, level, z), v3(-1, 0, 0), -0.4f, up);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 1.6f * t, level, z - (i ? 0.0f : 0.3f)),
                     v3((float)s * 1.6f * t, level, z + reach), 0.5f * t, t);
        dmg_rod(b, v3(-1.9f * t, level, z), v3(1.9f * t, level, z), 0.4f * t);
        if (!i) continue;
        uint32_t board = dmg_hinge(b, bar, "backboard", v3(0, level, z + reach), v3(1, 0, 0), -0.4f, up);
        dmg_rod(b, v3(-2.4f * t, level, z + reach), v3(2.4f * t, level, z + reach), 0.4f * t);
        dmg_box_span(b, v3(-2.6f * t, level - 0.1f, z + reach), v3(-2.1f * t, level + 0.05f, z + reach + 0.06f));
        dmg_box_span(b, v3(2.1f * t, level - 0.1f, z + reach), v3(2.6f * t, level + 0.05f, z + reach + 0.06f));
        dmg_box_span(b, v3(-0.6f, level - 0.4f, z + reach + 0.05f), v3(0.6f, level + 0.4f, z + reach + 0.09f));
        float front = z + reach + 0.09f;
        dmg_hinge(b, board, "rim", v3(0, level - 0.25f, front + 0.02f), v3(1, 0, 0), 0.0f, 0.5f);
        dmg_box_span(b, v3(-0.06f, level - 0.28f, front), v3(0.06f, level - 0.23f, front + 0.14f));
        dmg_torus(b, v3(0, level - 0.25f, front + 0.36f), v3(0, 1, 0), 0.225f, 0.012f);
    }
    dmg_use(b, 0);
}

/* Draws two halves that come up about lines beside the net; legs that fold under them. */
static void draw_table_tennis(dmg_builder* b) {
    float scale = dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.3f, 0.8f), t = 0.025f, y = 0.76f, half = 0.76f,
          length = 1.37f;
    dmg_grow(b, scale);
    dmg_beam(b, v3(-0.5f * half, 0.1f, 0), v3(0.5f * half, 0.1f, 0), 0.05f, 0.05f);
    for (int i = -1; i <= 1; i += 2) {
        float x = (float)i * 0.5f * half;
        dmg_box_span(b, v3(x - t, 0.08f, -t), v3(x + t, y - 0.03f, t));
        dmg_box_span(b, v3(x - t, 0.08f, -0.3f), v3(x + t, 0.12f, 0.3f));
        for (int k = -1; k <= 1; k += 2) {
            dmg_spin(b, 0, "castor", v3(x, 0.05f, (float)k * 0.28f), v3(1, 0, 0));
            dmg_rod(b, v3(x - 0.6f * t, 0.05f, (float)k * 0.28f), v3(x + 0.6f * t, 0.05f, (float)k * 0.28f), 0.05f);
            dmg_use(b, 0);
        }
    }
    dmg_box_span(b, v3(-half, y - 0.03f, -t), v3(half, y - 0.005f, t));
    dmg_box_span(b, v3(-half - 0.1f, y, -0.003f), v3(half + 0.1f, y + 0.15f, 0.003f));
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i, z0 = s * 0.03f, z1 = s * length;
        uint32_t leaf = dmg_hinge(b, 0, "half", v3(0, y - 0.01f, z0), v3(-s, 0, 0), 0.0f, 1.4f);
        dmg_box_span(b, v3(-half, y - 0.02f, fminf(z0, z1)), v3(half, y, fmaxf(z0, z1)));
        dmg_hinge(b, leaf, "leg", v3(0, y - 0.04f, s * 1.2f), v3(s, 0, 0), 0.0f, 1.5f);
        for (int k = -1; k <= 1; k += 2)
            dmg_box_span(b, v3((float)k * 0.6f - t, 0, s * 1.2f - t),
                         v3((float)k * 0.6f + t, y - 0.022f, s * 1.2f + t));
        dmg_rod(b, v3(-0.6f, 0.2f, s * 1.2f), v3(0.6f, 0.2f, s * 1.2f), 0.6f * t);
    }
    dmg_use(b, 0);
}

void dmg_build_ball_game(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 3, 2, 2, 1.5f}, 6);
    if (kind == 0) draw_table_football(b);
    if (kind == 1) draw_roulette(b);
    if (kind == 2) draw_fruit_machine(b);
    if (kind == 3) draw_dart_cabinet(b);
    if (kind == 4) draw_basket(b);
    if (kind == 5) draw_table_tennis(b);
}
