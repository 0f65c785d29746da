/* Draws tables with further parts: desks over keyboard trays, lift-up and swivelling tops, gate-leg leaves, sewing
 * cabinets, dressing tables under three mirrors, benches with vises; drawers on many kinds of pulls. */
#include "core/build.h"
#include "parts/hardware.h"

/* x and z centred; t: of the boards. */
typedef struct stand {
    float w, d, h, t;
    float row; /* height of what hangs below the top */
    int legs, pulls;
    dmg_handle handle;
    float leg; /* thickness */
} stand;

/* ---- what stands below ---- */

static void draw_stand_leg(dmg_builder* b, const stand* s, float x, float z, float top) {
    float r = 0.5f * s->leg;
    const dmg_xy turned[] = {{0, 0},
                             {0.6f * r, 0},
                             {0.5f * r, 0.1f * top},
                             {0.9f * r, 0.3f * top},
                             {0.5f * r, 0.62f * top},
                             {r, 0.8f * top},
                             {r, top},
                             {0, top}};
    if (s->legs == 0) dmg_box_span(b, v3(x - r, 0, z - r), v3(x + r, top, z + r));
    if (s->legs == 1) dmg_cone(b, v3(1.08f * x, 0, 1.08f * z), v3(0.94f * x, top, 0.94f * z), 0.4f * r, r);
    if (s->legs == 2) dmg_lathe(b, v3(x, 0, z), v3(0, 1, 0), turned, 8);
}

/* At the corners, or as slabs or hoops at both ends. */
static void draw_stand_legs(dmg_builder* b, const stand* s, float top) {
    float x = 0.5f * s->w - 0.8f * s->leg, z = 0.5f * s->d - 0.8f * s->leg, r = 0.5f * s->leg;
    for (int i = -1; i <= 1; i += 2) {
        float side = (float)i * x;
        for (int k = -1; k <= 1 && s->legs < 3; k += 2) draw_stand_leg(b, s, side, (float)k * z, top);
        if (s->legs == 3) dmg_box_span(b, v3(side - r, 0, -z - r), v3(side + r, top, z + r));
        if (s->legs == 4) {
            const dmg_vec hoop[] = {
                {side, top, -0.9f * z}, {side, 0.6f * r, -z}, {side, 0.6f * r, z}, {side, top, 0.9f * z}};
            dmg_sweep(b, hoop, 4, 0.6f * r, 0.6f * r, false);
        }
    }
}

static void draw_stand_top(dmg_builder* b, const stand* s) {
    if (dmg_chance(b, 0.4f))
        dmg_rounded_box(b, v3(0, s->h - 0.5f * s->t, 0), v3(s->w, s->t, s->d), 0.3f * s->t);
    else
        dmg_box_span(b, v3(-0.5f * s->w, s->h - s->t, -0.5f * s->d), v3(0.5f * s->w, s->h, 0.5f * s->d));
}

/* ---- drawers ---- */

/* Draws a bail or a ring that hangs from the front z = 0 and swings up in the hand. */
static void draw_hung_pull(dmg_builder* b, uint32_t drawer, float half, float drop, bool ring) {
    float r = 0.09f * drop, z = 2.5f * r;
    if (ring) half = 0.0f;
    for (int i = ring ? 0 : -1; i <= (ring ? 0 : 1); i += 2)
        dmg_rod(b, v3((float)i * half, 0, 0), v3((float)i * half, 0, z), 2.2f * r);
    if (ring) dmg_box_span(b, v3(-4 * r, -0.7f * drop, 0), v3(4 * r, 4 * r, 0.7f * r));
    dmg_hinge(b, drawer, "pull", v3(0, 0, z), v3(-1, 0, 0), 0.0f, 1.45f);
    const dmg_vec bail[] = {{-half, 0, z},           {-half, -0.5f * drop, z}, {-0.6f * half, -drop, z},
                            {0.6f * half, -drop, z}, {half, -0.5f * drop, z},  {half, 0, z}};
    if (ring)
        dmg_torus(b, v3(0, -0.5f * drop, z), v3(0, 0, 1), 0.5f * drop, r);
    else
        dmg_sweep(b, bail, 6, r, r, false);
    dmg_use(b, drawer);
}

static void draw_pull(dmg_builder* b, const stand* s, uint32_t drawer, float w, float h) {
    float r = fminf(0.018f, 0.2f * h), half = fminf(0.05f, 0.18f * w), drop = fminf(0.05f, 0.4f * h);
    int count = w > 0.45f && s->pulls > 0 ? 2 : 1;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, w * (((float)i + 0.5f) / (float)count - 0.5f), 0, 0);
        if (s->pulls == 1) draw_hung_pull(b, drawer, half, drop, false);
        if (s->pulls == 2) draw_hung_pull(b, drawer, half, drop, true);
        if (s->pulls == 3) dmg_knob_draw(b, 0, r, 1.6f * r);
        if (s->pulls == 4) dmg_ellipsoid(b, v3(0, 0, 0.9f * r), v3(r, r, r));
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        if (s->pulls == 0) dmg_handle_draw(b, &s->handle, w);
        dmg_restore(b);
    }
    if (s->pulls != 3 || !dmg_chance(b, 0.3f)) return;
    dmg_rod(b, v3(0, 0.28f * h, 0), v3(0, 0.28f * h, 0.2f * r), 0.7f * r);
    dmg_hinge(b, drawer, "key", v3(0, 0.28f * h, 0), v3(0, 0, -1), 0.0f, 1.57f);
    dmg_rod(b, v3(0, 0.28f * h, 0.21f * r), v3(0, 0.28f * h, r), 0.15f * r);
    dmg_box(b, v3(0, 0.28f * h, 1.3f * r), v3(0.3f * r, 1.0f * r, 0.8f * r));
    dmg_use(b, drawer);
}

/* Its front stands before the opening or in it; some have the hand's notch cut into their upper edge. */
static void draw_stand_drawer(dmg_builder* b, const stand* s, dmg_vec at, float w, float h, float deep) {
    float t = 0.8f * s->t, travel = deep * dmg_range(b, 0.6f, 0.9f), high = h * dmg_range(b, 0.5f, 0.8f),
          notch = s->pulls == 5 ? 0.3f * h : 0.0f;
    dmg_save(b);
    dmg_move(b, at.x, at.y, at.z);
    uint32_t drawer = dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, travel);
    dmg_box_span(b, v3(-0.5f * w, -0.5f * h, -t), v3(0.5f * w, 0.5f * h - notch, 0));
    for (int i = -1; i <= 1 && notch > 0.0f; i += 2)
        dmg_box_span(b, v3(i < 0 ? -0.5f * w : 0.2f * w, 0.5f * h - notch, -t),
                     v3(i < 0 ? -0.2f * w : 0.5f * w, 0.5f * h, 0));
    draw_pull(b, s, drawer, w, h);
    dmg_move(b, 0, -0.46f * h, -t);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.92f * w, high, deep - t, 0.5f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Side boards, back and floor of a box whose front is open, drawers stacked in it. */
static void draw_drawer_stack(dmg_builder* b, const stand* s, float x, float w, float y0, float y1, int count) {
    float t = 0.7f * s->t, z = 0.5f * s->d - 0.05f * s->d, deep = 0.9f * s->d, each = (y1 - y0 - t) / (float)count;
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3(x + (float)i * 0.5f * (w - t) - 0.5f * t, y0, -z),
                     v3(x + (float)i * 0.5f * (w - t) + 0.5f * t, y1, z));
    dmg_box_span(b, v3(x - 0.5f * w + t, y0, -z), v3(x + 0.5f * w - t, y0 + t, z));
    dmg_box_span(b, v3(x - 0.5f * w + t, y0 + t, -z), v3(x + 0.5f * w - t, y1, t - z));
    for (int i = 0; i < count; ++i)
        draw_stand_drawer(b, s, v3(x, y0 + t + each * ((float)i + 0.5f), z), w - 2.3f * t, 0.95f * each, 0.88f * deep);
}

/* Drawers side by side below the top. */
static void draw_apron(dmg_builder* b, const stand* s, int count, float width) {
    float each = width / (float)count;
    for (int i = 0; i < count; ++i)
        draw_drawer_stack(b, s, each * ((float)i + 0.5f) - 0.5f * width, each, s->h - s->t - s->row, s->h - s->t, 1);
}

/* ---- desks ---- */

/* Draws a board on runners between the pedestals; its mouse wing turns out from under it. */
static void draw_keyboard_tray(dmg_builder* b, const stand* s, float x, float w) {
    float y = s->h - s->t - 0.09f, deep = 0.55f * s->d, t = 0.6f * s->t, z = 0.42f * s->d,
          way = deep * dmg_range(b, 0.5f, 0.8f);
    for (int i = -1; i <= 1; i += 2) {
        float at = x + (float)i * (0.5f * w - 0.01f);
        dmg_box_span(b, v3(at - 0.006f, y, z - deep), v3(at + 0.006f, s->h - s->t, z));
    }
    uint32_t tray = dmg_slide(b, 0, "keyboard_tray", v3(0, 0, 1), 0.0f, way);
    dmg_box_span(b, v3(x - 0.5f * w + 0.02f, y, z - deep), v3(x + 0.5f * w - 0.02f, y + t, z));
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(x - 0.3f * w, y + t, z - 0.2f), v3(x + 0.3f * w, y + t + 0.02f, z - 0.05f));
    if (dmg_chance(b, 0.35f)) {
        dmg_hinge(b, tray, "mouse_board", v3(x + 0.5f * w - 0.08f, y, z - 0.08f), v3(0, -1, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(x + 0.5f * w - 0.2f, y - t, z - 0.3f), v3(x + 0.5f * w - 0.03f, y - 0.002f, z - 0.03f));
    }
    dmg_use(b, 0);
}

static void draw_desk(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.9f, 1.7f);
    s->d = dmg_range(b, 0.5f, 0.75f);
    int sides = dmg_int(b, 0, 2), rows = dmg_int(b, 2, 4);
    float wide = s->w * dmg_range(b, 0.24f, 0.32f), y0 = dmg_chance(b, 0.5f) ? 0.03f : 0.3f * s->h;
    if (s->legs > 2 && sides == 2) s->legs = 0;
    draw_stand_top(b, s);
    draw_stand_legs(b, s, s->h - s->t);
    float x = 0.5f * s->w - 1.4f * s->leg - 0.5f * wide;
    if (sides > 0) draw_drawer_stack(b, s, x, wide, y0, s->h - s->t, rows);
    if (sides > 1) draw_drawer_stack(b, s, -x, wide, y0, s->h - s->t, rows);
    float left = sides > 1 ? wide - x - 0.5f * wide : 1.4f * s->leg - 0.5f * s->w,
          right = sides > 0 ? x - 0.5f * wide : 0.5f * s->w - 1.4f * s->leg;
    const float gap = right - left;
    if (dmg_chance(b, 0.6f))
        draw_keyboard_tray(b, s, 0.5f * (left + right), fminf(gap, 0.75f));
    else
        draw_stand_drawer(b, s, v3(0.5f * (left + right), s->h - s->t - 0.045f, 0.46f * s->d), 0.95f * gap, 0.085f,
                          0.8f * s->d);
}

/* ---- coffee tables ---- */

/* Draws a box whose lid rises at the side, in two halves, or slides open over drawers. */
static void draw_lift_table(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.7f, 1.3f);
    s->d = dmg_range(b, 0.45f, 0.8f);
    s->h = dmg_range(b, 0.35f, 0.55f);
    int kind = dmg_int(b, 0, 2), drawers = dmg_int(b, 0, 3);
    float y = s->h - s->t, well = s->row, swing = dmg_range(b, 0.8f, 1.5f), z = 0.5f * s->d, x = 0.5f * s->w;
    draw_stand_legs(b, s, y - 2 * well);
    dmg_save(b);
    dmg_move(b, 0, y - 0.5f * well, 0);
    dmg_face_up(b);
    dmg_move(b, 0, 0, 0.499f * well);
    dmg_case_draw(b, DMG_CASE_BOARDS, 0.94f * s->w, 0.94f * s->d, well, 0.7f * s->t);
    dmg_restore(b);
    stand low = *s;
    low.h = y - well + s->t;
    low.d = 0.94f * s->d;
    draw_apron(b, &low, drawers ? drawers : 1, 0.94f * s->w);
    int lids = kind == 1 ? 2 : 1;
    for (int i = 0; i < lids; ++i) {
        float x0 = lids > 1 && i ? 0.002f : -x, x1 = lids > 1 && !i ? -0.002f : x;
        if (kind == 0) dmg_hinge(b, 0, "top", v3(0, y, -0.45f * s->d), v3(-1, 0, 0), 0.0f, swing);
        if (kind == 1)
            dmg_hinge(b, 0, "top", v3(i ? 0.46f * s->w : -0.46f * s->w, y, 0), v3(0, 0, i ? -1.0f : 1.0f), 0.0f, swing);
        if (kind == 2) {
            const float upper = 0.5f * s->w * dmg_range(b, 0.5f, 0.9f);
            const dmg_vec direction = v3(dmg_sign(b), 0, 0);
            dmg_slide(b, 0, "top", direction, 0.0f, upper);
        }
        dmg_box_span(b, v3(x0, y + 0.001f, -z), v3(x1, s->h, z));
        dmg_use(b, 0);
    }
}

/* ---- tops that fold ---- */

/* Leaves on a narrow middle, held by gates that swing out from the frame. */
static void draw_gate_leg(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.2f, 0.45f);
    s->d = dmg_range(b, 0.7f, 1.1f);
    s->legs = dmg_int(b, 0, 2);
    float leaf = fminf(s->h - 0.12f, s->d * dmg_range(b, 0.4f, 0.7f)), y = s->h - s->t, x = 0.5f * s->w,
          r = 0.4f * s->leg, reach = fminf(0.36f * s->d, 0.85f * leaf);
    bool rounded = dmg_chance(b, 0.4f), gates = dmg_chance(b, 0.8f);
    draw_stand_top(b, s);
    stand inner = *s;
    inner.w = s->w - 4 * r;
    draw_stand_legs(b, &inner, y);
    dmg_box_span(b, v3(0.5f * s->leg - 0.5f * inner.w, y - s->row, -0.42f * s->d),
                 v3(0.5f * inner.w - 0.5f * s->leg, y, 0.42f * s->d));
    for (int i = -1; i <= 1; i += 2) {
        float side = (float)i;
        uint32_t flap = dmg_hinge(b, 0, "leaf", v3(side * x, y, 0), v3(0, 0, side), 0.0f, 0.5f * DMG_PI);
        dmg_rest(b, flap, 0.5f * DMG_PI);
        dmg_keep_rest(b, flap);
        const dmg_xy outline[] = {{-0.5f * s->d, y},       {-0.5f * s->d, y - 0.55f * leaf}, {-0.3f * s->d, y - leaf},
                                  {0.3f * s->d, y - leaf}, {0.5f * s->d, y - 0.55f * leaf},  {0.5f * s->d, y}};
        const dmg_xy square[] = {
            {-0.5f * s->d, y}, {-0.5f * s->d, y - leaf}, {0.5f * s->d, y - leaf}, {0.5f * s->d, y}};
        dmg_save(b);
        dmg_move(b, side * (x + 0.5f * s->t), 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_extrude(b, rounded ? outline : square, rounded ? 6 : 4, -0.5f * s->t, 0.5f * s->t);
        dmg_restore(b);
        dmg_use(b, 0);
        if (!gates) continue;
        float gx = side * (x - 2.2f * r), gz = side * 0.02f, end = gz + side * reach;
        uint32_t gate = dmg_hinge(b, 0, "gate", v3(gx, 0, gz), v3(0, 1, 0), 0.0f, 1.5f);
        dmg_keep_rest(b, gate);
        dmg_box_span(b, v3(gx - r, 0.08f, gz - r), v3(gx + r, y - 0.01f, gz + r));
        dmg_box_span(b, v3(gx - r, 0, end - r), v3(gx + r, y - 0.004f, end + r));
        for (int k = 0; k < 2; ++k) {
            float level = k ? y - 0.06f : 0.12f;
            dmg_box_span(b, v3(gx - 0.6f * r, level - r, fminf(gz, end)), v3(gx + 0.6f * r, level + r, fmaxf(gz, end)));
        }
        dmg_use(b, 0);
    }
}

/* Draws a card table: the top turns a quarter on its frame and opens like a book. */
static void draw_card_table(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.75f, 1.0f);
    s->d = 0.5f * s->w;
    float y = s->h - s->t, gap = 0.002f, x = 0.5f * s->w, z = 0.5f * s->d, at = 0.25f * s->d;
    draw_stand_legs(b, s, y - s->t);
    dmg_box_span(b, v3(-0.9f * x, y - s->t - s->row, -0.88f * z), v3(0.9f * x, y - s->t, 0.88f * z));
    if (dmg_chance(b, 0.5f))
        draw_stand_drawer(b, s, v3(0, y - s->t - 0.5f * s->row, 0.9f * z), 0.6f * s->w, 0.7f * s->row, 0.03f);
    uint32_t top = dmg_hinge(b, 0, "top", v3(-at, 0, 0), v3(0, 1, 0), 0.0f, 0.5f * DMG_PI);
    dmg_box_span(b, v3(-x, y - s->t + gap, -z), v3(x, y, z));
    dmg_hinge(b, top, "leaf", v3(0, y + 0.5f * gap, -z), v3(-1, 0, 0), 0.0f, DMG_PI);
    dmg_box_span(b, v3(-x, y + gap, -z), v3(x, s->h, z));
    dmg_use(b, 0);
}

/* ---- cabinets and dressing tables ---- */

/* A machine comes up from under a lid that lies out to the side; a door with reels, drawers, a knee lever. */
static void draw_sewing_cabinet(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.7f, 1.0f);
    s->d = dmg_range(b, 0.4f, 0.55f);
    float x = 0.5f * s->w, z = 0.5f * s->d, y = s->h - s->t, t = s->t, y0 = 0.12f, mid = 0.3f * x, rise = 0.24f;
    bool knee = dmg_chance(b, 0.5f), reels = dmg_chance(b, 0.6f);
    for (int i = 0; i < 4; ++i) {
        float lx = i & 1 ? x - t : t - x, lz = i & 2 ? 0.85f * z : -0.85f * z;
        dmg_box_span(b, v3(lx - t, 0, lz - t), v3(lx + t, y0, lz + t));
    }
    for (int i = 0; i < 3; ++i) {
        float at = i == 0 ? 0.5f * t - x : i == 1 ? mid : x - 0.5f * t;
        dmg_box_span(b, v3(at - 0.5f * t, y0, -0.95f * z), v3(at + 0.5f * t, y - 0.002f, 0.95f * z));
    }
    dmg_box_span(b, v3(-x + t, y0, -0.95f * z), v3(x - t, y0 + t, 0.95f * z));
    dmg_box_span(b, v3(-x + t, y0 + t, -0.95f * z), v3(x - t, y - 0.002f, t - 0.95f * z));
    dmg_box_span(b, v3(mid + 0.5f * t, y - t, t - 0.95f * z), v3(x - t, y - 0.002f, 0.95f * z));
    draw_drawer_stack(b, s, 0.5f * (mid + x), x - mid - 2 * t, y0 + t, y - t, dmg_int(b, 2, 4));
    dmg_slide(b, 0, "machine", v3(0, 1, 0), 0.0f, rise);
    dmg_box_span(b, v3(1.6f * t - x, y - rise - 0.06f, -0.6f * z), v3(mid - t, y - rise - 0.03f, 0.6f * z));
    dmg_rounded_box(b, v3(mid - 0.09f, y - 0.5f * rise - 0.025f, 0), v3(0.07f, rise - 0.02f, 0.1f), 0.015f);
    dmg_rounded_box(b, v3(0.5f * (mid - x), y - 0.05f, 0), v3(mid + x - 0.16f, 0.07f, 0.09f), 0.015f);
    dmg_box_span(b, v3(0.1f - x, y - 0.16f, -0.03f), v3(0.14f - x, y - 0.05f, 0.03f));
    dmg_use(b, 0);
    dmg_hinge(b, 0, "lid", v3(-x, s->h, 0), v3(0, 0, 1), 0.0f, DMG_PI);
    dmg_box_span(b, v3(-x, y, -z), v3(x, s->h, z));
    uint32_t door = dmg_hinge(b, 0, "door", v3(-x, 0, 0.96f * z), v3(0, -1, 0), 0.0f, 1.9f);
    dmg_box_span(b, v3(-x, y0, 0.96f * z), v3(mid - 0.6f * t, y - 0.006f, 0.96f * z + t));
    dmg_save(b);
    dmg_move(b, 0.7f * mid - 0.02f, 0.5f * (y + y0), 0.96f * z + t);
    dmg_knob_draw(b, 0, 0.014f, 0.02f);
    dmg_restore(b);
    for (int i = 0; i < 3 && reels; ++i) {
        float rx = 0.5f * (mid - x) + 0.07f * (float)(i - 1), ry = y0 + 0.14f;
        dmg_spin(b, door, "reel", v3(rx, ry, 0), v3(0, 0, 1));
        dmg_rod(b, v3(rx, ry, 0.96f * z - 0.03f), v3(rx, ry, 0.96f * z - 0.001f), 0.018f);
    }
    dmg_use(b, 0);
    if (!knee) return;
    dmg_hinge(b, 0, "knee_lever", v3(mid - 0.15f, y0 + t, 0.5f * z), v3(0, 0, -1), 0.0f, 0.4f);
    dmg_box_span(b, v3(mid - 0.16f, y0 + t + 0.001f, 0.5f * z), v3(mid - 0.14f, y0 + 0.2f, 0.55f * z));
    dmg_use(b, 0);
}

/* One glass stands in the middle or tilts; those beside it turn on its edges. */
static void draw_three_mirrors(dmg_builder* b, const stand* s) {
    float wide = s->w * dmg_range(b, 0.3f, 0.46f), high = dmg_range(b, 0.5f, 0.85f), wing = 0.5f * wide, t = 0.02f,
          z = 0.05f - 0.5f * s->d, y = s->h + 0.03f, less = high * dmg_range(b, 0.75f, 1.0f),
          rest = dmg_range(b, 0.0f, 0.7f);
    bool arched = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-0.45f * wide, s->h, z - t), v3(0.45f * wide, y, z + t));
    dmg_box_span(b, v3(-0.5f * wide, y, z - 0.5f * t), v3(0.5f * wide, y + high, z + 0.5f * t));
    dmg_box_span(b, v3(-0.44f * wide, y + 0.05f * high, z + 0.5f * t),
                 v3(0.44f * wide, y + 0.95f * high, z + 0.7f * t));
    if (arched) {
        dmg_xy crown[9];
        for (int i = 0; i < 9; ++i) {
            float a = DMG_PI * (float)i / 8.0f;
            crown[i] = (dmg_xy){0.5f * wide * cosf(a), y + high + 0.15f * high * sinf(a)};
        }
        dmg_extrude(b, crown, 9, z - 0.5f * t, z + 0.5f * t);
    }
    for (int i = -1; i <= 1; i += 2) {
        float side = (float)i, x = side * (0.5f * wide + 0.003f), end = x + side * wing;
        uint32_t mirror = dmg_hinge(b, 0, "mirror", v3(x, 0, z + 0.5f * t), v3(0, side, 0), -0.3f, 1.5f);
        dmg_rest(b, mirror, rest);
        dmg_box_span(b, v3(fminf(x, end), y, z - 0.5f * t), v3(fmaxf(x, end), y + less, z + 0.5f * t));
        dmg_box_span(b, v3(fminf(x, end) + 0.02f, y + 0.02f, z + 0.5f * t),
                     v3(fmaxf(x, end) - 0.02f, y + less - 0.02f, z + 0.7f * t));
        dmg_use(b, 0);
    }
}

static void draw_dressing_table(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 0.8f, 1.3f);
    s->d = dmg_range(b, 0.38f, 0.5f);
    s->legs = dmg_int(b, 0, 3);
    bool sides = dmg_chance(b, 0.5f), flap = dmg_chance(b, 0.3f);
    float wide = 0.28f * s->w, x = 0.5f * (s->w - wide) - 1.4f * s->leg;
    draw_stand_top(b, s);
    draw_stand_legs(b, s, s->h - s->t);
    for (int i = -1; i <= 1 && sides; i += 2) {
        int rows = dmg_int(b, 2, 3);
        draw_drawer_stack(b, s, (float)i * x, wide, 0.45f * s->h, s->h - s->t, rows);
    }
    if (!sides) draw_apron(b, s, dmg_int(b, 1, 3), s->w - 2.8f * s->leg);
    draw_three_mirrors(b, s);
    if (!flap) return;
    float y = s->h, hx = 0.4f * s->w; /* a jewel box on the top */
    dmg_box_span(b, v3(hx - 0.07f, y, -0.05f), v3(hx + 0.07f, y + 0.06f, 0.07f));
    dmg_hinge(b, 0, "box_lid", v3(hx, y + 0.061f, -0.05f), v3(-1, 0, 0), 0.0f, 1.7f);
    dmg_box_span(b, v3(hx - 0.072f, y + 0.061f, -0.05f), v3(hx + 0.072f, y + 0.075f, 0.075f));
    dmg_use(b, 0);
}

/* ---- benches ---- */

/* Draws a jaw on a screw in front of z = 0, below the top at y = 0; its bar slides through the screw's head. */
static void draw_bench_vise(dmg_builder* b, float wide, float tall, float t, float way) {
    float r = 0.12f * tall, y = -0.55f * tall, z = t;
    bool turns = dmg_chance(b, 0.7f);
    uint32_t jaw = dmg_slide(b, 0, "vise_jaw", v3(0, 0, 1), 0.0f, way);
    dmg_box_span(b, v3(-0.5f * wide, -tall, 0.002f), v3(0.5f * wide, 0, z));
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3(0.3f * (float)i * wide, y, -1.2f * way), v3(0.3f * (float)i * wide, y, 0.5f * z), 0.5f * r);
    uint32_t screw = jaw;
    if (turns) screw = dmg_spin(b, jaw, "vise_screw", v3(0, y, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, y, z), v3(0, y, z + 4 * r), r);
    dmg_slide(b, screw, "vise_bar", v3(1, 0, 0), -0.25f * wide, 0.25f * wide);
    dmg_rod(b, v3(-0.4f * wide, y, z + 2.5f * r), v3(0.4f * wide, y, z + 2.5f * r), 0.35f * r);
    for (int i = -1; i <= 1; i += 2) dmg_ellipsoid(b, v3(0.4f * (float)i * wide, y, z + 2.5f * r), v3(r, r, r));
    dmg_use(b, 0);
}

static void draw_workbench(dmg_builder* b, stand* s) {
    s->w = dmg_range(b, 1.1f, 2.0f);
    s->d = dmg_range(b, 0.5f, 0.75f);
    s->h = dmg_range(b, 0.8f, 0.95f);
    s->t = dmg_range(b, 0.05f, 0.1f);
    s->leg = dmg_range(b, 0.07f, 0.1f);
    s->legs = dmg_chance(b, 0.7f) ? 0 : 3;
    int dogs = dmg_int(b, 0, 5), rows = dmg_int(b, 0, 3);
    bool tail = dmg_chance(b, 0.5f), back = dmg_chance(b, 0.3f);
    float tall = dmg_range(b, 0.12f, 0.2f), wide = dmg_range(b, 0.2f, 0.4f), way = 0.3f * s->d,
          high = dmg_range(b, 0.3f, 0.6f), x = 0.5f * s->w;
    draw_stand_top(b, s);
    draw_stand_legs(b, s, s->h - s->t);
    if (rows > 0)
        draw_drawer_stack(b, s, 0.2f * s->w, 0.4f * s->w, 0.25f * s->h, s->h - s->t, rows);
    else
        dmg_box_span(b, v3(s->leg - x, 0.15f, -0.4f * s->d), v3(x - s->leg, 0.17f, 0.4f * s->d));
    if (back) dmg_box_span(b, v3(-x, s->h, -0.5f * s->d), v3(x, s->h + high, 0.03f - 0.5f * s->d));
    dmg_save(b);
    dmg_move(b, 0.55f * wide - x, s->h, 0.5f * s->d);
    draw_bench_vise(b, wide, tall, 0.4f * tall, way);
    dmg_restore(b);
    if (tail) {
        dmg_save(b);
        dmg_move(b, x, s->h, 0.2f * s->d);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        draw_bench_vise(b, 0.5f * s->d, tall, 0.5f * tall, 0.7f * way);
        dmg_restore(b);
    }
    for (int i = 0; i < dogs; ++i) {
        float at = 0.7f * s->w * ((float)i + 0.5f) / (float)dogs - 0.25f * s->w;
        dmg_slide(b, 0, "dog", v3(0, 1, 0), 0.0f, 0.04f);
        dmg_rod(b, v3(at, s->h - 0.6f * s->t, 0.36f * s->d), v3(at, s->h + 0.006f, 0.36f * s->d), 0.011f);
        dmg_use(b, 0);
    }
}

void dmg_build_drawer_table(dmg_builder* b) {
    stand s = {.h = dmg_range(b, 0.68f, 0.8f)};
    s.t = dmg_range(b, 0.016f, 0.035f);
    s.row = dmg_range(b, 0.09f, 0.16f);
    s.leg = dmg_range(b, 0.03f, 0.07f);
    s.legs = dmg_int(b, 0, 4);
    s.pulls = dmg_int(b, 0, 5);
    s.handle = dmg_handle_pick(b, 0.12f);
    switch (dmg_weighted(b, (const float[]){4, 3, 2, 1.5f, 1.5f, 2, 2.5f}, 7)) {
    case 0:
        draw_desk(b, &s);
        break;
    case 1:
        draw_lift_table(b, &s);
        break;
    case 2:
        draw_gate_leg(b, &s);
        break;
    case 3:
        draw_card_table(b, &s);
        break;
    case 4:
        draw_sewing_cabinet(b, &s);
        break;
    case 5:
        draw_dressing_table(b, &s);
        break;
    default:
        draw_workbench(b, &s);
        break;
    }
}
