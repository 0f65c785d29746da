/* Draws fixtures of kitchens and bathrooms: toilets and bidets with rings, lids, cisterns and levers; hobs and
 * cookers with taps, grates that lift, a lid, ovens and a drawer. */
#include "core/build.h"
#include "parts/hardware.h"

enum { OVAL = 20 };

/* An egg whose rear end at y = 0 is blunt and whose front is at y = length. */
static void egg_outline(dmg_xy* outline, float w, float length, float blunt) {
    for (int i = 0; i < OVAL; ++i) {
        float a = 2 * DMG_PI * (float)i / OVAL, s = sinf(a), c = cosf(a);
        float x = s < 0 ? copysignf(powf(fabsf(c), blunt), c) : c,
              y = s < 0 ? 0.35f * copysignf(powf(-s, blunt), s) : 0.65f * s;
        outline[i] = (dmg_xy){0.5f * w * x, length * (0.35f + y)};
    }
}

/* Turns the frame so that x, y of outlines are x and z, heights go up; it mirrors. */
static void lay_flat(dmg_builder* b) {
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_mirror(b, v3(0, 1, 0));
}

typedef struct closet {
    float w, length, rim; /* of the bowl: across, along Z from its rear 0; height of the rim */
    float wall;           /* z of what stands behind it */
    bool hung;
} closet;

static void draw_bowl(dmg_builder* b, const closet* c) {
    dmg_xy outline[OVAL], inner[OVAL];
    egg_outline(outline, c->w, c->length, 0.5f);
    egg_outline(inner, 0.68f * c->w, 0.68f * c->length, 0.7f);
    for (int i = 0; i < OVAL; ++i) inner[i].y += 0.22f * c->length;
    float deep = 0.35f * c->rim, foot = dmg_range(b, 0.5f, 0.9f), low = c->hung ? 0.3f * c->rim : 0.0f;
    const dmg_row rows[] = {
        {foot, 0.8f * foot, 0, low}, {0.9f * foot, 0.8f * foot, 0, 0.4f * c->rim}, {1, 1, 0, c->rim - deep}};
    dmg_save(b);
    lay_flat(b);
    dmg_loft(b, outline, OVAL, rows, 3);
    dmg_ring_plate(b, outline, inner, OVAL, c->rim - deep, c->rim);
    dmg_restore(b);
    if (c->wall < 0.0f && !c->hung) /* the pan goes on to the wall */
        dmg_box_span(b, v3(-0.3f * c->w, 0, c->wall), v3(0.3f * c->w, c->rim - 0.01f, 0.15f * c->length));
    if (c->hung) dmg_box_span(b, v3(-0.4f * c->w, low, c->wall - 0.02f), v3(0.4f * c->w, c->rim, 0.1f * c->length));
}

/* Ring and lid turn about the same pins, or each about its own. */
static void draw_seat(dmg_builder* b, const closet* c, bool lid) {
    float t = dmg_range(b, 0.012f, 0.03f), z = 0.08f * c->length, pin = 0.01f, up = dmg_range(b, 1.4f, 1.62f),
          apart = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.004f, 0.02f), cut = dmg_chance(b, 0.2f) ? 1.0f : 0.0f;
    dmg_xy outer[OVAL], inner[OVAL];
    egg_outline(outer, 1.02f * c->w, 0.93f * c->length, 0.5f);
    egg_outline(inner, 0.58f * c->w, 0.64f * c->length, 0.8f);
    for (int i = 0; i < OVAL; ++i) {
        outer[i].y += 0.08f * c->length;
        inner[i].y += 0.22f * c->length;
    }
    float y = c->rim + 0.003f;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3((float)s * 0.2f * c->w - 0.02f, y + pin, z), v3((float)s * 0.2f * c->w + 0.02f, y + pin, z), pin);
    dmg_hinge(b, 0, "seat", v3(0, y + pin, z), v3(-1, 0, 0), 0.0f, up);
    dmg_save(b);
    lay_flat(b);
    dmg_ring_plate(b, outer, inner, OVAL, y, y + t);
    dmg_restore(b);
    dmg_use(b, 0);
    if (!lid) return;
    dmg_hinge(b, 0, "lid", v3(0, y + pin + apart, z - apart), v3(-1, 0, 0), 0.0f, up - 0.05f);
    const dmg_row rows[] = {{1.01f, 1, 0, y + t + 0.002f},
                            {1.01f, 1, 0, y + 1.5f * t},
                            {0.9f, 0.94f, 0.03f * c->length * (1 - cut), y + 2.2f * t}};
    dmg_save(b);
    lay_flat(b);
    dmg_loft(b, outer, OVAL, rows, cut > 0.5f ? 2 : 3);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Behind the bowl: the box of water with its lid, buttons on it or a lever at the side or front; or a chain above. */
static void draw_cistern(dmg_builder* b, const closet* c) {
    float w = c->w * dmg_range(b, 0.9f, 1.25f), h = dmg_range(b, 0.28f, 0.42f),
          d = fminf(dmg_range(b, 0.14f, 0.22f), -0.03f - c->wall), r = 0.02f;
    bool high = dmg_chance(b, 0.12f), lifts = dmg_chance(b, 0.4f);
    int flush = high ? 3 : dmg_int(b, 0, 2);
    float y = high ? 1.7f : c->rim + 0.01f, z1 = c->wall + d, z = c->wall + 0.5f * d, side = dmg_sign(b), top = y + h;
    dmg_rounded_box(b, v3(0, y + 0.5f * h, z), v3(w, h, d), r);
    if (high) dmg_rod(b, v3(0, 0.9f * c->rim, c->wall + 0.05f), v3(0, y + 0.01f, c->wall + 0.05f), 0.02f);
    uint32_t lid = 0;
    if (lifts) lid = dmg_slide(b, 0, "cistern_lid", v3(0, 1, 0), 0.0f, dmg_range(b, 0.05f, 0.25f));
    dmg_rounded_box(b, v3(0, top + 0.017f, z), v3(1.04f * w, 0.03f, 1.08f * d), 0.008f);
    top += 0.032f;
    if (flush == 0) { /* two halves of a disc, unlike */
        float radius = dmg_range(b, 0.02f, 0.035f), split = radius * dmg_range(b, -0.3f, 0.3f);
        for (int s = -1; s <= 1; s += 2) {
            dmg_slide(b, lid, "flush_button", v3(0, -1, 0), 0.0f, 0.006f);
            dmg_box_span(b, v3(s < 0 ? -radius : split + 0.001f, top - 0.01f, z - radius),
                         v3(s < 0 ? split - 0.001f : radius, top + 0.008f, z + radius));
        }
    }
    if (flush == 1 || flush == 2) { /* a lever on the front or at the end */
        float x = flush == 1 ? side * 0.38f * w : side * 0.5f * w, ly = y + 0.82f * h, out = 0.022f;
        dmg_vec at = flush == 1 ? v3(x, ly, z1) : v3(x, ly, z + 0.2f * d),
                axis = flush == 1 ? v3(0, 0, side) : v3(side, 0, 0);
        dmg_vec pull = flush == 1 ? v3(-side * 0.09f, -0.005f, 0) : v3(0, -0.005f, 0.09f),
                end = v3_mad(at, flush == 1 ? v3(0, 0, 1) : v3(side, 0, 0), out);
        dmg_hinge(b, 0, "flush_lever", at, flush == 1 ? axis : v3(1, 0, 0), 0.0f, 0.7f);
        dmg_rod(b, at, end, 0.01f);
        dmg_capsule(b, end, v3_add(end, pull), 0.007f);
    }
    if (flush == 3) {
        dmg_slide(b, 0, "chain", v3(0, -1, 0), 0.0f, 0.12f);
        dmg_rod(b, v3(side * 0.3f * w, 1.1f, z1 - 0.02f), v3(side * 0.3f * w, y + 0.005f, z1 - 0.02f), 0.004f);
        dmg_ellipsoid(b, v3(side * 0.3f * w, 1.08f, z1 - 0.02f), v3(0.018f, 0.04f, 0.018f));
    }
    dmg_use(b, 0);
}

/* Draws a bidet: taps on its rear, or one lever; a plug's rod. */
static void draw_bidet_taps(dmg_builder* b, const closet* c) {
    float z = 0.1f * c->length, y = c->rim, tall = dmg_range(b, 0.05f, 0.12f);
    const dmg_vec spout[] = {{0, y, z}, {0, y + tall, z}, {0, y + tall, z + 0.05f}, {0, y + 0.7f * tall, z + 0.1f}};
    dmg_sweep(b, spout, 4, 0.012f, 0.012f, false);
    if (dmg_chance(b, 0.5f)) {
        dmg_hinge(b, 0, "tap_lever", v3(0, y + tall, z), v3(0, 1, 0), -1.0f, 1.0f);
        dmg_rod(b, v3(0, y + tall + 0.013f, z), v3(0, y + tall + 0.035f, z), 0.016f);
        dmg_capsule(b, v3(0, y + tall + 0.03f, z), v3(0, y + tall + 0.05f, z + 0.08f), 0.006f);
    } else {
        for (int s = -1; s <= 1; s += 2) {
            float x = (float)s * 0.2f * c->w;
            dmg_spin(b, 0, "tap", v3(x, y, z), v3(0, (float)s, 0));
            dmg_rod(b, v3(x, y - 0.01f, z), v3(x, y + 0.04f, z), 0.01f);
            dmg_box(b, v3(x, y + 0.045f, z), v3(0.05f, 0.012f, 0.012f));
            dmg_box(b, v3(x, y + 0.045f, z), v3(0.012f, 0.012f, 0.05f));
        }
    }
    dmg_slide(b, 0, "plug_rod", v3(0, 1, 0), 0.0f, 0.03f);
    dmg_rod(b, v3(0, y - 0.02f, z - 0.03f), v3(0, y + 0.06f, z - 0.03f), 0.004f);
    dmg_ellipsoid(b, v3(0, y + 0.065f, z - 0.03f), v3(0.009f, 0.009f, 0.009f));
    dmg_use(b, 0);
}

void dmg_build_toilet_suite(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 2, 1.2f}, 3); /* with a cistern, on the wall, a bidet */
    closet c = {.w = dmg_range(b, 0.33f, 0.42f)};
    c.length = c.w * dmg_range(b, 1.15f, 1.45f);
    c.rim = dmg_range(b, 0.36f, 0.46f);
    c.hung = kind == 1 || (kind == 2 && dmg_chance(b, 0.4f));
    c.wall = kind == 0 ? -dmg_range(b, 0.18f, 0.26f) : -0.06f;
    draw_bowl(b, &c);
    if (kind == 2) {
        draw_bidet_taps(b, &c);
        if (dmg_chance(b, 0.3f)) draw_seat(b, &c, false);
        return;
    }
    draw_seat(b, &c, dmg_chance(b, 0.85f));
    if (kind == 0) {
        draw_cistern(b, &c);
        return;
    }
    /* A wall with the plate of buttons, which sink or tip. */
    float high = c.rim + dmg_range(b, 0.45f, 0.8f), z = c.wall - 0.02f, y = high - 0.14f,
          wide = dmg_range(b, 0.06f, 0.11f), part = dmg_range(b, 0.3f, 0.7f), tall = dmg_range(b, 0.05f, 0.07f);
    bool tips = dmg_chance(b, 0.4f);
    dmg_box_span(b, v3(-0.35f, 0, z - 0.12f), v3(0.35f, high, z));
    dmg_box_span(b, v3(-1.1f * wide, y - 1.2f * tall, z), v3(1.1f * wide, y + 1.2f * tall, z + 0.008f));
    for (int i = 0; i < 2; ++i) {
        float split = wide * (2 * part - 1), x0 = i ? split + 0.002f : -wide, x1 = i ? wide : split - 0.002f;
        if (tips)
            dmg_hinge(b, 0, "flush_button", v3(0, y + tall, z + 0.012f), v3(1, 0, 0), 0.0f, 0.08f);
        else
            dmg_slide(b, 0, "flush_button", v3(0, 0, -1), 0.0f, 0.008f);
        dmg_box_span(b, v3(x0, y - tall, z + 0.009f), v3(x1, y + tall, z + 0.018f));
    }
    dmg_use(b, 0);
}

/* ---- gas ---- */

typedef struct cooker {
    float w, d, y, t; /* the plate: across, along Z about 0, its top, its thickness */
    int columns, rows;
} cooker;

/* Returns how high the grates stand. */
static float draw_burners(dmg_builder* b, const cooker* c, bool lifts) {
    int grates = dmg_chance(b, 0.5f) ? c->columns : c->columns * c->rows;
    float cell_w = c->w / (float)c->columns, cell_d = 0.78f * c->d / (float)c->rows,
          high = dmg_range(b, 0.025f, 0.045f), bar = 0.006f;
    for (int i = 0; i < c->columns * c->rows; ++i) {
        float x = cell_w * ((float)(i % c->columns) + 0.5f) - 0.5f * c->w,
              z = cell_d * ((float)(i / c->columns) + 0.5f) - 0.48f * c->d,
              r = fminf(cell_w, cell_d) * dmg_range(b, 0.12f, 0.28f);
        dmg_rod(b, v3(x, c->y, z), v3(x, c->y + 0.3f * high, z), r);
        dmg_rod(b, v3(x, c->y + 0.3f * high, z), v3(x, c->y + 0.5f * high, z), 0.75f * r);
    }
    int rows = grates / c->columns;
    float deep = rows == 1 ? cell_d * (float)c->rows : cell_d;
    for (int i = 0; i < grates; ++i) {
        float x = cell_w * ((float)(i % c->columns) + 0.5f) - 0.5f * c->w,
              z = deep * ((float)(i / c->columns) + 0.5f) - 0.48f * c->d, hx = 0.46f * cell_w, hz = 0.46f * deep,
              y = c->y + high;
        if (lifts) dmg_slide(b, 0, "grate", v3(0, 1, 0), 0.0f, 0.1f);
        for (int s = -1; s <= 1; s += 2) {
            dmg_box(b, v3(x, y, z + (float)s * hz), v3(2 * hx, 2 * bar, bar));
            dmg_box(b, v3(x + (float)s * hx, y, z), v3(bar, 2 * bar, 2 * hz));
            dmg_box(b, v3(x + (float)s * hx, 0.5f * (y + c->y) + 0.001f, z + hz), v3(bar, y - c->y, bar));
            dmg_box(b, v3(x + (float)s * hx, 0.5f * (y + c->y) + 0.001f, z - hz), v3(bar, y - c->y, bar));
        }
        for (int k = -1; k <= 1; ++k) dmg_box(b, v3(x + (float)k * 0.5f * hx, y, z), v3(bar, 2 * bar, 2 * hz));
        dmg_use(b, 0);
    }
    return c->y + high + bar;
}

/* Taps along the front face of the cooker, on its sloped edge, or on the plate at the front. */
static void draw_taps(dmg_builder* b, const cooker* c, int where, float face) {
    int count = c->columns * c->rows + dmg_int(b, 0, 2), kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    float r = fminf(dmg_range(b, 0.014f, 0.024f), 0.4f * c->w / (float)count), upper = dmg_range(b, 1.6f, 4.7f),
          room = c->w * dmg_range(b, 0.5f, 0.9f);
    bool pushed = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, room * (((float)i + 0.5f) / (float)count - 0.5f), where == 0 ? c->y - 0.5f * face : c->y,
                 where == 0 ? 0.5f * c->d : 0.42f * c->d);
        if (where == 1) dmg_face_up(b);
        uint32_t tap = 0;
        if (pushed) tap = dmg_slide(b, 0, "tap_push", v3(0, 0, -1), 0.0f, 0.2f * r);
        if (pushed) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.3f * r), 1.1f * r);
        dmg_hinge(b, tap, "tap", v3(0, 0, 0), v3(0, 0, 1), 0.0f, upper); /* gas: to the left */
        dmg_move(b, 0, 0, 0.32f * r);
        dmg_knob_draw(b, kind, r, 1.1f * r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Below the plate: an oven or two, a grill over it, a drawer for trays. */
static void draw_range_body(dmg_builder* b, const cooker* c, float face) {
    float low = 0.04f, top = c->y - face, t = 0.03f, drawer = dmg_chance(b, 0.6f) ? dmg_range(b, 0.1f, 0.2f) : 0.0f,
          x = 0.5f * c->w, z = 0.5f * c->d - t;
    bool grill = dmg_chance(b, 0.3f), side = dmg_chance(b, 0.2f);
    int ovens = c->w > 0.8f ? 2 : 1;
    dmg_box_span(b, v3(-x, top, -0.5f * c->d), v3(x, c->y - c->t, z + t));
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (low + top), z);
    dmg_case_draw(b, DMG_CASE_DOUBLE, c->w, top - low, c->d - t, 0.035f);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.45f * c->w, 0, -0.45f * c->d), v3(0.45f * c->w, low, 0.9f * z));
    if (drawer > 0.0f) {
        dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, 0.6f * c->d);
        dmg_box_span(b, v3(0.003f - x, low, z + 0.002f), v3(x - 0.003f, low + drawer - 0.004f, z + t));
        dmg_save(b);
        dmg_move(b, 0, low + 0.038f, z);
        dmg_tray_draw(b, DMG_TRAY_SHEET, 0.84f * c->w, 0.5f * drawer, 0.85f * c->d, 0.01f);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    dmg_leaf leaf = dmg_leaf_pick_appliance(b, c->w, top - low, t);
    float y0 = low + drawer, split = grill ? 0.7f * top + 0.3f * y0 : top;
    for (int i = 0; i < ovens + (grill ? 1 : 0); ++i) {
        bool upper = i == ovens;
        leaf.width = (upper ? c->w : c->w / (float)ovens) - 0.004f;
        leaf.height = (upper ? top - split : split - y0) - 0.004f;
        leaf.side = side && !upper ? (i ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT) : DMG_SIDE_BOTTOM;
        leaf.thickness = t - 0.002f;
        leaf.swing = 1.5f;
        leaf.inset = fminf(leaf.inset, 0.3f);
        leaf.handle.length = 0.7f * c->w / (float)ovens;
        dmg_save(b);
        dmg_move(b, upper || ovens == 1 ? 0 : c->w * (i ? 0.25f : -0.25f),
                 upper ? 0.5f * (top + split) : 0.5f * (y0 + split), z + t);
        dmg_leaf_draw(b, 0, upper ? "grill_door" : "door", &leaf);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_gas_hob(dmg_builder* b) {
    bool range = dmg_chance(b, 0.5f), griddle = dmg_chance(b, 0.25f), lifts = dmg_chance(b, 0.6f);
    cooker c = {.columns = dmg_int(b, 1, 3)};
    c.rows = dmg_int(b, 1, 2);
    if (range && c.columns == 1) c.columns = 2;
    c.w = (float)c.columns * dmg_range(b, 0.26f, 0.33f);
    c.d = c.rows == 1 && !range ? 0.36f : dmg_range(b, 0.5f, 0.62f);
    c.t = dmg_range(b, 0.008f, 0.03f);
    float face = dmg_range(b, 0.06f, 0.11f), foot = range ? 0.0f : face;
    c.y = range ? dmg_range(b, 0.82f, 0.95f) : c.t + foot;
    int where = range ? (dmg_chance(b, 0.7f) ? 0 : 1) : dmg_int(b, 0, 1);
    dmg_box_span(b, v3(-0.5f * c.w, c.y - c.t, -0.5f * c.d), v3(0.5f * c.w, c.y, 0.5f * c.d));
    if (range)
        draw_range_body(b, &c, face);
    else
        dmg_box_span(b, v3(-0.48f * c.w, 0, -0.48f * c.d),
                     v3(0.48f * c.w, foot, where == 0 ? 0.5f * c.d : 0.48f * c.d));
    float over = draw_burners(b, &c, lifts && !griddle) + 0.001f;
    draw_taps(b, &c, where, face);
    if (griddle) { /* a plate over one column */
        float cell = c.w / (float)c.columns, x = 0.5f * cell - 0.5f * c.w, y = over;
        dmg_slide(b, 0, "griddle", v3(0, 1, 0), 0.0f, 0.12f);
        dmg_box(b, v3(x, y + 0.005f, -0.1f * c.d), v3(0.8f * cell, 0.01f, 0.68f * c.d));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(x, y + 0.016f, -0.1f * c.d + 0.33f * (float)s * c.d), v3(0.3f * cell, 0.012f, 0.012f));
        dmg_use(b, 0);
    }
    if (!dmg_chance(b, 0.45f)) return;
    /* A lid, glass or enamel, shown up or down; its line is at the rear, above what lies on the plate. */
    float y = over + (griddle ? 0.03f : 0.008f), z = 0.01f - 0.5f * c.d, up = dmg_range(b, 1.45f, 1.7f),
          reach = where == 1 ? 0.85f * c.d : 0.97f * c.d;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.4f * c.w - 0.02f, c.y, z - 0.01f),
                     v3((float)s * 0.4f * c.w + 0.02f, y - 0.001f, z + 0.004f));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, y, z), v3(-1, 0, 0), 0.0f, up);
    bool open = dmg_chance(b, 0.6f);
    dmg_rest(b, lid, open ? up : 0.0f);
    dmg_box_span(b, v3(-0.5f * c.w, y, z), v3(0.5f * c.w, y + 0.006f, z + reach));
    dmg_use(b, 0);
}
