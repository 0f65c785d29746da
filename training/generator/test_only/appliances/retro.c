/* Draws appliances in rounded and bevelled housings: fridges of the fifties, microwaves under a curved front, small
 * ovens, dishwasher drawers, tubs with lids, dryers with round doors; and toasters, presses with a lid. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

enum { CORNER = 5, ROUND = 4 * CORNER };

/* A rectangle w x h round (0, y), its corners of radius r; the lower ones of r * foot. */
static void round_outline(dmg_xy* outline, float w, float h, float y, float r, float foot) {
    for (int i = 0; i < ROUND; ++i) {
        int quarter = i / CORNER;
        float a = 0.5f * DMG_PI * ((float)quarter + (float)(i % CORNER) / (CORNER - 1)),
              own = quarter < 2 ? r : r * foot, sx = quarter == 0 || quarter == 3 ? 1.0f : -1.0f,
              sy = quarter < 2 ? 1.0f : -1.0f;
        outline[i] = (dmg_xy){sx * (0.5f * w - own) + own * cosf(a), y + sy * (0.5f * h - own) + own * sinf(a)};
    }
}

/* Draws a slab of that outline whose front edge is bevelled over its last part. */
static void draw_soft_slab(dmg_builder* b, float w, float h, float r, float foot, float low, float high, float bevel) {
    dmg_xy outline[ROUND];
    round_outline(outline, w, h, 0, r, foot);
    const dmg_row rows[] = {{1, 1, 0, low},
                            {1, 1, 0, high - bevel},
                            {1 - 0.7f * bevel / w, 1 - 0.7f * bevel / h, 0, high - 0.3f * bevel},
                            {1 - 2 * bevel / w, 1 - 2 * bevel / h, 0, high}};
    dmg_loft(b, outline, ROUND, rows, 4);
}

/* A shell open in front. */
static void draw_soft_shell(dmg_builder* b, float w, float h, float d, float r, float wall) {
    dmg_xy outer[ROUND], inner[ROUND];
    round_outline(outer, w, h, 0, r, 0.6f);
    round_outline(inner, w - 2 * wall, h - 2 * wall, 0, fmaxf(0.2f * r, r - wall), 0.6f);
    dmg_ring_plate(b, outer, inner, ROUND, -d, 0);
    dmg_extrude(b, inner, ROUND, -d, wall - d);
}

/* Draws a lever across the edge, as old fridges have, or a bar, near the free side `s`. */
static void draw_latch_handle(dmg_builder* b, uint32_t door, float s, float x, float y, float size, int kind) {
    dmg_save(b);
    dmg_move(b, x, y, 0);
    if (kind == 0) { /* pulled out about its inner end */
        dmg_hinge(b, door, "latch_handle", v3(-0.8f * s * size, 0, 0.1f * size), v3(0, -s, 0), 0.0f, 0.5f);
        dmg_box_span(b, v3(-0.5f * size - 0.4f * s * size, -0.12f * size, 0.06f * size),
                     v3(0.5f * size - 0.4f * s * size, 0.12f * size, 0.22f * size));
        dmg_use(b, door);
        dmg_box(b, v3(-0.7f * s * size, 0, 0.03f * size), v3(0.3f * size, 0.35f * size, 0.06f * size));
    } else {
        dmg_handle bar = {.kind = kind == 1 ? DMG_HANDLE_ARCH : DMG_HANDLE_BAR, .length = 2 * size};
        bar.thickness = 0.14f * size;
        bar.standoff = 0.35f * size;
        bar.post = 0.9f;
        dmg_handle_draw(b, &bar, 3 * size);
    }
    dmg_restore(b);
}

/* Draws a door w x h round the origin, hung at side s; the slab is thick and round as the housing. */
static uint32_t draw_soft_door(dmg_builder* b, const char* name, float w, float h, float r, float t, float s,
                               int latch) {
    float bevel = fminf(t, r) * dmg_range(b, 0.2f, 0.8f), in = dmg_range(b, 0.0f, 0.5f) * t,
          deep = t * dmg_range(b, 0.0f, 1.0f), at = dmg_range(b, -0.1f, 0.25f) * h, swing = dmg_range(b, 1.4f, 2.0f);
    bool hardware = dmg_chance(b, 0.35f);
    if (hardware) {
        in = -0.08f * t;
        deep = 0.7f * t;
    }
    float line = s * (0.5f * w - in);
    uint32_t door = dmg_hinge(b, 0, name, v3(line, 0, t - deep), v3(0, s, 0), 0.0f, swing);
    draw_soft_slab(b, w, h, r, 0.6f, 0.002f, t, bevel);
    for (int i = -1; i <= 1 && hardware; i += 2)
        dmg_rod(b, v3(line, (float)i * 0.3f * h - 0.03f * h, t - deep),
                v3(line, (float)i * 0.3f * h + 0.03f * h, t - deep), 0.14f * t);
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    if (latch >= 0) draw_latch_handle(b, door, -s, -s * 0.42f * w, at, 0.12f * fmaxf(w, 0.5f * h), latch);
    dmg_restore(b);
    return door;
}

static void draw_retro_fridge(dmg_builder* b) {
    float w = dmg_range(b, 0.45f, 0.7f), h = dmg_range(b, 0.7f, 1.8f), d = w * dmg_range(b, 0.75f, 1.05f),
          r = w * dmg_range(b, 0.08f, 0.35f), t = d * dmg_range(b, 0.08f, 0.2f), foot = 0.05f, s = dmg_sign(b);
    bool two = h > 1.2f && dmg_chance(b, 0.5f), hollow = dmg_chance(b, 0.8f);
    int latch = dmg_int(b, 0, 2), shelves = dmg_int(b, 2, 4);
    for (int i = 0; i < 4; ++i)
        dmg_rod(b, v3(i & 1 ? 0.35f * w : -0.35f * w, 0, i & 2 ? -0.1f * d : -0.8f * d),
                v3(i & 1 ? 0.35f * w : -0.35f * w, foot + 0.01f, i & 2 ? -0.1f * d : -0.8f * d), 0.02f);
    dmg_save(b);
    dmg_move(b, 0, foot + 0.5f * h, 0);
    if (hollow)
        draw_soft_shell(b, w, h, d, r, 0.06f * w);
    else
        draw_soft_slab(b, w, h, r, 0.6f, -d, 0, 0.01f);
    for (int i = 1; i <= shelves && hollow; ++i)
        dmg_box(b, v3(0, h * ((float)i / (float)(shelves + 1) - 0.5f), -0.52f * d), v3(0.86f * w, 0.008f, 0.8f * d));
    float split = two ? h * dmg_range(b, 0.55f, 0.75f) : h;
    dmg_move(b, 0, 0.5f * (split - h), 0);
    draw_soft_door(b, "door", w, split - 0.005f, two ? 0.6f * fminf(r, 0.4f * (h - split)) : r, t, s, latch);
    dmg_use(b, 0);
    if (two) {
        dmg_move(b, 0, 0.5f * h, 0);
        draw_soft_door(b, "freezer_door", w, h - split - 0.005f, 0.6f * fminf(r, 0.4f * (h - split)), t, s, latch);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a wide window that is the door, bowed out; the panel beside or below it with its buttons. */
static void draw_curved_microwave(dmg_builder* b) {
    enum { POINTS = 9 };
    float w = dmg_range(b, 0.42f, 0.78f), h = w * dmg_range(b, 0.5f, 0.65f), d = w * dmg_range(b, 0.6f, 0.85f),
          bow = d * dmg_range(b, 0.02f, 0.15f), panel = w * dmg_range(b, 0.18f, 0.3f), t = 0.05f * w;
    bool down = dmg_chance(b, 0.25f), grip = dmg_chance(b, 0.6f);
    float door_w = w - panel, s = -1.0f; /* hung at the left, the panel at the right */
    dmg_save(b);
    dmg_move(b, 0, 0.52f * h, 0);
    if (dmg_chance(b, 0.15f)) dmg_mirror(b, v3(1, 0, 0));
    draw_soft_shell(b, w, h, d, 0.05f * w, 0.035f * w);
    dmg_box_span(b, v3(0.5f * w - panel, -0.47f * h, -0.8f * d), v3(0.47f * w, 0.47f * h, 0.5f * t));
    dmg_save(b);
    dmg_move(b, 0.5f * (w - panel), 0, 0.5f * t);
    dmg_controls_draw(b, 0, 0.8f * panel, 0.9f * h);
    dmg_restore(b);
    if (dmg_chance(b, 0.7f)) { /* the plate */
        dmg_spin(b, 0, "turntable", v3(-0.5f * panel, -0.45f * h, -0.45f * d), v3(0, 1, 0));
        dmg_rod(b, v3(-0.5f * panel, -0.42f * h, -0.45f * d), v3(-0.5f * panel, -0.4f * h, -0.45f * d),
                0.42f * fminf(door_w, d));
        dmg_use(b, 0);
    }
    dmg_move(b, -0.5f * panel, 0, 0);
    uint32_t door = down ? dmg_hinge(b, 0, "door", v3(0, -0.5f * h, 0.2f * t), v3(1, 0, 0), 0.0f, 1.5f)
                         : dmg_hinge(b, 0, "door", v3(s * 0.5f * door_w, 0, 0.5f * t), v3(0, s, 0), 0.0f, 1.8f);
    dmg_xy line[2 * POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float x = door_w * ((float)i / (POINTS - 1) - 0.5f), off = 2 * x / door_w;
        line[i] = (dmg_xy){0.99f * x, -t - bow * (1 - off * off)};
        line[2 * POINTS - 1 - i] = (dmg_xy){0.99f * x, -0.004f};
    }
    dmg_save(b);
    dmg_face_up(b);
    dmg_extrude(b, line, 2 * POINTS, -0.5f * h, 0.5f * h);
    dmg_restore(b);
    if (grip) draw_latch_handle(b, door, 1, 0.42f * door_w, 0, 0.3f * h, 2);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Small oven: the door falls, knobs beside it, a grid inside, a tray for crumbs under it. */
static void draw_small_oven(dmg_builder* b) {
    float w = dmg_range(b, 0.35f, 0.55f), h = w * dmg_range(b, 0.5f, 0.75f), d = w * dmg_range(b, 0.6f, 0.9f),
          t = 0.025f, panel = w * dmg_range(b, 0.18f, 0.28f), x0 = -0.5f * w + t, x1 = 0.5f * w - panel, foot = 0.02f;
    int knobs = dmg_int(b, 1, 4), kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    bool glass = dmg_chance(b, 0.6f);
    dmg_save(b);
    dmg_move(b, 0, foot + 0.5f * h, 0);
    draw_soft_shell(b, w, h, d, 0.08f * w, t);
    dmg_box_span(b, v3(x1 + 0.002f, -0.48f * h, -0.9f * d), v3(0.48f * w, 0.48f * h, 0));
    for (int i = 0; i < knobs; ++i) {
        dmg_save(b);
        dmg_move(b, 0.5f * (x1 + 0.5f * w), 0.85f * h * (((float)i + 0.5f) / (float)knobs - 0.5f), 0);
        dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, 4.7f);
        dmg_knob_draw(b, kind, fminf(0.3f * panel, 0.35f * h / (float)knobs), 0.02f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    uint32_t rack = dmg_slide(b, 0, "rack", v3(0, 0, 1), 0.0f, 0.6f * d);
    dmg_keep_rest(b, rack);
    for (int i = 0; i < 7; ++i) {
        float x = x0 + (x1 - x0) * ((float)i + 0.5f) / 7.0f;
        dmg_rod(b, v3(x, 0, -0.95f * d + t), v3(x, 0, -0.01f), 0.003f);
    }
    for (int i = 0; i < 3; ++i)
        dmg_rod(b, v3(x0 + 0.004f, 0, -0.05f * d - 0.4f * d * (float)i),
                v3(x1 - 0.004f, 0, -0.05f * d - 0.4f * d * (float)i), 0.004f);
    float low = -0.36f * h, high = 0.46f * h, mid = 0.5f * (x0 + x1);
    float line = dmg_range(b, 0.0f, t), fall = dmg_range(b, 1.2f, 1.6f);
    dmg_hinge(b, 0, "door", v3(0, low, line), v3(1, 0, 0), 0.0f, fall);
    dmg_save(b);
    dmg_move(b, mid, 0.5f * (low + high), t);
    dmg_panel leaf = {.kind = glass ? DMG_PANEL_WINDOW : DMG_PANEL_SOFT, .border = 0.15f, .infill = 0.6f};
    dmg_panel_draw(b, &leaf, x1 - x0, high - low, t - 0.002f);
    dmg_move(b, 0, 0.4f * (high - low), 0);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle bar = {DMG_HANDLE_BAR, 0.7f * (x1 - x0), 0.014f, 0.03f, 0.85f};
    dmg_handle_draw(b, &bar, x1 - x0);
    dmg_restore(b);
    dmg_slide(b, 0, "crumb_tray", v3(0, 0, 1), 0.0f, 0.7f * d);
    dmg_box_span(b, v3(x0 + 0.005f, -0.44f * h, -0.9f * d), v3(x1 - 0.005f, -0.42f * h, 0.002f));
    dmg_box_span(b, v3(mid - 0.3f * (x1 - x0), -0.45f * h, 0.002f),
                 v3(mid + 0.3f * (x1 - x0), -0.37f * h - 0.003f, 0.015f));
    dmg_restore(b);
    dmg_use(b, 0);
}

typedef struct laundry {
    float w, h, d, t, r; /* r: of the porthole */
    float cut, rim;      /* height of the panel; radius of the edges */
} laundry;

/* Draws a round door in the front, hung on side `s`. */
static void draw_porthole(dmg_builder* b, const laundry* n, float s) {
    float r = n->r, t = n->t;
    draw_soft_slab(b, n->w, n->h, n->rim, 1, -n->d, 0, 0.3f * n->rim);
    dmg_move(b, 0, -0.5f * n->cut, 0);
    float bulge = dmg_range(b, 0.0f, 0.3f) * r, line = r * dmg_range(b, 0.98f, 1.12f);
    const dmg_xy dish[] = {{0, 0.002f},   {r, 0.002f},           {r, t},        {0.75f * r, 1.3f * t},
                           {0.7f * r, t}, {0.3f * r, t + bulge}, {0, t + bulge}};
    dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.06f * r, 0.015f);
    dmg_hinge(b, 0, "door", v3(s * line, 0, 0.6f * t), v3(0, s, 0), 0.0f, dmg_range(b, 1.6f, 2.4f));
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), dish, 7);
    if (line > r) dmg_box(b, v3(s * (line - 0.03f), 0, 0.6f * t), v3(0.07f, 0.25f * r, 0.8f * t));
    dmg_box(b, v3(-s * 0.87f * r, 0, 1.2f * t), v3(0.12f * r, 0.4f * r, 0.9f * t));
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * (n->h - n->cut) + 0.5f * n->cut - 0.5f * n->cut, 0);
    dmg_controls_draw(b, 0, 0.8f * n->w, 0.7f * n->cut);
}

/* Draws a lid over the tub; the panel stands up behind it. */
static void draw_top_loader(dmg_builder* b, const laundry* n) {
    float w = n->w, h = n->h, d = n->d, t = n->t, cut = n->cut;
    bool window = dmg_chance(b, 0.5f), front = dmg_chance(b, 0.8f);
    dmg_xy outer[ROUND], inner[ROUND];
    round_outline(outer, w, d, 0, n->rim, 1);
    round_outline(inner, 0.8f * w, 0.6f * d, -0.1f * d, 0.2f * w, 1);
    dmg_face_up(b);
    dmg_move(b, 0, 0.5f * d, 0);
    dmg_ring_plate(b, outer, inner, ROUND, -0.5f * h, 0.5f * h);
    dmg_rod(b, v3(0, -0.1f * d, -0.4f * h), v3(0, -0.1f * d, -0.38f * h), 0.4f * w);
    const dmg_xy head[] = {{-d, 0.5f * h}, {-0.78f * d, 0.5f * h}, {-0.86f * d, 0.5f * h + cut}, {-d, 0.5f * h + cut}};
    dmg_move(b, 0, -0.5f * d, 0);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_side_prism(b, head, 4, -0.5f * w, 0.5f * w);
    float z0 = -0.76f * d, z1 = -0.05f * d, x = 0.44f * w;
    dmg_vec line = front ? v3(0, 0.5f * h + 0.01f, z0) : v3(-x, 0.5f * h + 0.01f, 0);
    dmg_hinge(b, 0, "lid", line, front ? v3(-1, 0, 0) : v3(0, 0, 1), 0.0f, dmg_range(b, 1.2f, 1.7f));
    dmg_save(b);
    dmg_move(b, 0, 0.5f * h + t, 0.5f * (z0 + z1));
    dmg_face_up(b);
    dmg_panel pane = {.kind = window ? DMG_PANEL_WINDOW : DMG_PANEL_ROUNDED, .border = 0.12f, .infill = 0.5f};
    dmg_panel_draw(b, &pane, 2 * x, z1 - z0, t - 0.002f);
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * h + 0.5f * cut, -0.82f * d);
    dmg_turn(b, v3(1, 0, 0), -atanf(0.08f * d / cut));
    dmg_controls_draw(b, 0, 0.8f * w, 0.6f * cut);
}

/* Draws the lower or the upper of two drawers for dishes. */
static void draw_dish_drawer(dmg_builder* b, const laundry* n, bool upper) {
    float high = 0.46f * n->h, y = upper ? 0.02f * n->h : -0.47f * n->h;
    dmg_slide(b, 0, "dish_drawer", v3(0, 0, 1), 0.0f, 0.8f * n->d);
    dmg_save(b);
    dmg_move(b, 0, y + 0.5f * high, 0.002f);
    draw_soft_slab(b, 0.98f * n->w, high, 0.1f * n->rim + 0.004f, 1, 0, n->t, 0.3f * n->t);
    dmg_save(b);
    dmg_move(b, 0, -0.4f * high, 0.1f * n->t);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, 0.86f * n->w, 0.7f * high, 0.9f * n->d, 0.012f);
    dmg_restore(b);
    dmg_move(b, 0, 0.4f * high, n->t);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_handle bar = {n->r > 0.34f * n->w ? DMG_HANDLE_BAR : DMG_HANDLE_RECESSED, 0.6f * n->w, 0.018f, 0.04f, 0.9f};
    dmg_handle_draw(b, &bar, n->w);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a dryer's or washer's body: a round door in its front, or a lid on its top, or drawers for dishes. */
static void draw_laundry(dmg_builder* b, int kind) {
    laundry n = {.w = dmg_range(b, 0.5f, 0.7f), .t = 0.03f};
    n.h = n.w * (kind == 2 ? dmg_range(b, 1.2f, 1.5f) : dmg_range(b, 1.3f, 1.7f));
    n.d = n.w * dmg_range(b, 0.85f, 1.05f);
    n.r = n.w * dmg_range(b, 0.28f, 0.4f);
    float side = dmg_sign(b);
    n.cut = n.h * dmg_range(b, 0.1f, 0.18f);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * n.h, 0);
    n.rim = dmg_range(b, 0.02f, 0.1f) * n.w;
    if (kind == 0) draw_porthole(b, &n, side);
    if (kind == 1) draw_top_loader(b, &n);
    if (kind == 2) {
        draw_soft_shell(b, n.w, n.h, n.d, n.rim, 0.02f);
        draw_dish_drawer(b, &n, false);
        draw_dish_drawer(b, &n, true);
    }
    dmg_restore(b);
}

void dmg_build_curved_appliance(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 3, 2, 1.3f, 1, 0.8f}, 6);
    if (kind == 0) draw_retro_fridge(b);
    if (kind == 1) draw_curved_microwave(b);
    if (kind == 2) draw_small_oven(b);
    if (kind > 2) draw_laundry(b, kind - 3);
}

/* ---- toasters and presses ---- */

/* Slots in a rounded block: a lever at the end or the front goes down in its groove. */
static void draw_slots(dmg_builder* b) {
    int slots = dmg_int(b, 1, 4), levers = slots > 2 ? 2 : 1;
    bool longways = dmg_chance(b, 0.6f);
    float slot = dmg_range(b, 0.025f, 0.038f), wide = (float)slots * slot * 1.7f + 0.04f,
          along = dmg_range(b, 0.22f, 0.36f), h = dmg_range(b, 0.15f, 0.22f), w = longways ? along : wide,
          d = longways ? wide : along, t = 0.006f, r = dmg_range(b, 0.1f, 0.45f) * wide * 0.5f;
    dmg_save(b);
    dmg_move(b, 0, 0.55f * h, 0);
    dmg_save(b);
    if (longways) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* from here z runs along the slots */
    draw_soft_slab(b, wide, 0.9f * h, fminf(r, 0.4f * h), 0.2f, -0.5f * along, 0.5f * along, 0.02f);
    for (int i = 0; i < slots; ++i) { /* rims of the slots, and what lies in them */
        float x = 1.7f * slot * ((float)i - 0.5f * (float)(slots - 1));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(x + 0.5f * (float)s * slot, 0.45f * h, 0), v3(t, 2 * t, 0.75f * along));
    }
    for (int i = 0; i < levers; ++i) {
        float x = levers == 1 ? 0.0f : 0.5f * wide * ((float)i - 0.5f), z = 0.5f * along, top = 0.25f * h,
              way = 0.4f * h;
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(x + 0.007f * (float)s, top - 0.5f * way, z), v3(0.003f, way + 0.03f, 0.004f));
        dmg_slide(b, 0, "lever", v3(0, -1, 0), 0.0f, way);
        dmg_box(b, v3(x, top, z + 0.008f), v3(0.008f, 0.01f, 0.024f));
        if (longways)
            dmg_rounded_box(b, v3(x, top, z + 0.025f), v3(0.04f, 0.016f, 0.022f), 0.005f);
        else
            dmg_rod(b, v3(x - 0.02f, top, z + 0.025f), v3(x + 0.02f, top, z + 0.025f), 0.009f);
        dmg_use(b, 0);
    }
    dmg_restore(b);
    dmg_save(b);
    bool end = longways && dmg_chance(b, 0.5f);
    if (end) dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    float z = end ? 0.5f * along : 0.5f * d, room = end || !longways ? 0.34f * wide : 0.0f;
    dmg_move(b, room, -0.28f * h, z);
    float turn = dmg_range(b, 2.0f, 5.0f);
    dmg_hinge(b, 0, "browning_knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, turn);
    dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.016f, 0.014f);
    dmg_use(b, 0);
    dmg_move(b, room > 0 ? -2 * room : 0.3f * w, 0, 0);
    dmg_buttons keys = {"button", 1, dmg_int(b, 1, 3), 0.02f, 0.022f, 0.016f, 0.012f, 0.005f, 0.003f, 1};
    dmg_buttons_draw(b, 0, &keys);
    dmg_restore(b);
    dmg_restore(b);
    float way = 0.8f * along;
    dmg_slide(b, 0, "crumb_tray", longways ? v3(-1, 0, 0) : v3(0, 0, -1), 0.0f, way);
    dmg_box(b, v3(0, 0.05f * h, 0), longways ? v3(along, 0.04f * h, 0.8f * wide) : v3(0.8f * wide, 0.04f * h, along));
    dmg_use(b, 0);
    for (int i = 0; i < 4; ++i)
        dmg_box_span(b, v3((i & 1 ? 0.45f : -0.48f) * w, 0, (i & 2 ? 0.45f : -0.48f) * d),
                     v3((i & 1 ? 0.48f : -0.45f) * w, 0.11f * h, (i & 2 ? 0.48f : -0.45f) * d));
}

/* Draws two plates on a rear hinge: sandwich presses, round irons, egg cookers under a dome. */
static void draw_press(dmg_builder* b) {
    int shape = dmg_int(b, 0, 2);
    float w = dmg_range(b, 0.2f, 0.34f), d = shape == 0 ? w * dmg_range(b, 0.7f, 1.1f) : w,
          low = dmg_range(b, 0.04f, 0.09f), high = dmg_range(b, 0.03f, 0.07f), swing = dmg_range(b, 1.2f, 1.9f),
          r = 0.5f * w, back = -0.5f * d - 0.012f, reach = dmg_range(b, 0.03f, 0.1f);
    dmg_save(b);
    dmg_save(b);
    dmg_face_up(b);
    if (shape == 0) draw_soft_slab(b, w, d, 0.12f * w, 1, 0, low, 0.1f * low);
    if (shape != 0) dmg_cone(b, v3(0, 0, 0), v3(0, 0, low), 0.85f * r, r);
    dmg_restore(b);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.3f * w, low - 0.005f, back + 0.005f), v3(0.1f * w, 0.03f, 0.035f));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, low + 0.006f, back), v3(-1, 0, 0), 0.0f, swing);
    dmg_box(b, v3(0, low + 0.016f, 0.5f * (back - 0.3f * d)), v3(0.45f * w, 0.012f, 0.3f * d));
    dmg_rod(b, v3(-0.24f * w, low + 0.008f, back), v3(0.24f * w, low + 0.008f, back), 0.008f);
    dmg_save(b);
    dmg_move(b, 0, low + 0.002f, 0);
    if (shape == 2) dmg_dome(b, v3(0, 0, 0), v3(r, 0.7f * r, r));
    dmg_face_up(b);
    if (shape == 0) draw_soft_slab(b, w, d, 0.12f * w, 1, 0, high, 0.6f * high);
    if (shape == 1) dmg_cone(b, v3(0, 0, 0), v3(0, 0, high), r, 0.9f * r);
    dmg_restore(b);
    if (shape == 2)
        dmg_ellipsoid(b, v3(0, low + 0.71f * r, 0), v3(0.1f * r, 0.08f * r, 0.1f * r));
    else {
        float y = low + 0.4f * high + 0.002f;
        dmg_rounded_box(b, v3(0, y, 0.5f * d + 0.4f * reach),
                        v3(dmg_chance(b, 0.5f) ? 0.15f * w : 0.6f * w, 0.5f * high, reach), 0.1f * high);
        if (dmg_chance(b, 0.5f)) { /* a clip that locks the handles */
            dmg_hinge(b, lid, "clip", v3(0, y, 0.5f * d + 0.9f * reach), v3(-1, 0, 0), 0.0f, 1.2f);
            dmg_box(b, v3(0, y - 0.3f * high, 0.5f * d + 0.9f * reach + 0.007f), v3(0.08f * w, 0.9f * high, 0.006f));
        }
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0.25f * w, 0.5f * low, shape == 0 ? 0.5f * d : 0.78f * r);
        dmg_knobs_draw(b, 0, 1, 0, 0, 0.35f * low);
    }
    dmg_restore(b);
}

void dmg_build_slot_toaster(dmg_builder* b) {
    if (dmg_chance(b, 0.6f))
        draw_slots(b);
    else
        draw_press(b);
}
