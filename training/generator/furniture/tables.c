/* Draws tables of variable size or height: leaves that draw out, fall or swing on gates, tops that part, rise or
 * turn. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct table {
    float length, width, high, t; /* along x and z, to the top's upper side; the top's thickness */
    float leg, apron;
    int outline; /* of the top: rectangle, soft corners, ellipse */
    float open;
} table;

static void rest_table(dmg_builder* b, const table* k, uint32_t part, float far) {
    if (dmg_chance(b, k->open)) dmg_rest(b, part, far * (dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.15f, 1.0f)));
    dmg_use(b, 0);
}

/* Draws a piece of the top from x0 to x1, its upper side at y. Where it reaches the top's ends it follows the outline.
 */
static void draw_piece(dmg_builder* b, const table* k, float x0, float x1, float y) {
    enum { HALF = 12, MOST = 4 * HALF };
    dmg_xy outline[MOST];
    int count = 0;
    float a = 0.5f * k->length, c = 0.5f * k->width, power = k->outline == 2 ? 1.0f : 0.25f;
    if (k->outline == 0) {
        dmg_box_span(b, v3(x0, y - k->t, -c), v3(x1, y, c));
        return;
    }
    for (int side = 0; side < 2; ++side) /* there along one long edge, back along the other */
        for (int i = 0; i <= HALF; ++i) {
            float u = (float)(side ? HALF - i : i) / HALF, x = x0 + (x1 - x0) * (1.0f - cosf(DMG_PI * u)) * 0.5f;
            float share = fminf(fabsf(x) / a, 1.0f), s = acosf(powf(share, 1.0f / power));
            float z = fmaxf(c * powf(fabsf(sinf(s)), power), 0.002f * c);
            outline[count++] = (dmg_xy){x, side ? z : -z};
        }
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    dmg_extrude(b, outline, count, -y, k->t - y);
    dmg_restore(b);
}

/* Legs with rails below the top from -x to x, or a column on feet. */
static void draw_frame(dmg_builder* b, const table* k, float x, float z, bool column) {
    float top = k->high - k->t, leg = k->leg;
    int kind = dmg_int(b, 0, 2), feet = dmg_int(b, 3, 4);
    if (column) {
        dmg_cone(b, v3(0, 0.1f * top, 0), v3(0, top, 0), 1.3f * leg, 0.9f * leg);
        for (int i = 0; i < feet; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, feet);
            dmg_beam(b, v3(0, 0.2f * top, 0), v3(0, 0.03f, 0.9f * fminf(x, z)), leg, leg);
            dmg_restore(b);
        }
        dmg_box_span(b, v3(-0.5f * x, top - 0.02f, -0.5f * z), v3(0.5f * x, top, 0.5f * z));
        return;
    }
    for (int i = 0; i < 4; ++i) {
        float px = (i & 1 ? 1.0f : -1.0f) * (x - 0.5f * leg), pz = (i & 2 ? 1.0f : -1.0f) * (z - 0.5f * leg);
        if (kind == 0)
            dmg_box_span(b, v3(px - 0.5f * leg, 0, pz - 0.5f * leg), v3(px + 0.5f * leg, top, pz + 0.5f * leg));
        if (kind == 1) dmg_cone(b, v3(px, 0, pz), v3(px, top, pz), 0.3f * leg, 0.6f * leg);
        if (kind == 2) dmg_beam(b, v3(1.06f * px, 0, 1.06f * pz), v3(px, top, pz), leg, leg);
    }
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_box_span(b, v3(leg - x, top - k->apron, side * (z - 0.5f * leg) - 0.01f),
                     v3(x - leg, top, side * (z - 0.5f * leg) + 0.01f));
        dmg_box_span(b, v3(side * (x - 0.5f * leg) - 0.01f, top - k->apron, leg - z),
                     v3(side * (x - 0.5f * leg) + 0.01f, top, z - leg));
    }
}

/* ---- leaves that hang down at the ends, on gates or brackets that swing out below them ---- */

static void draw_support(dmg_builder* b, const table* k, float side, float x, float reach, bool down) {
    float top = k->high - 1.05f * k->t, z = 0.3f * k->width * dmg_sign(b), r = 0.4f * k->leg,
          far = dmg_range(b, 1.2f, 1.6f);
    bool gate = dmg_chance(b, 0.5f);
    float low = gate ? 0.02f : top - fminf(0.5f * top, 0.8f * reach),
          length = fminf(0.85f * reach, 1.1f * k->width * 0.5f);
    /* Folded it lies along the end; it turns about an upright line. */
    float way = z > 0.0f ? -1.0f : 1.0f;
    dmg_vec pin = v3(side * (x + r), 0, z);
    uint32_t part = dmg_hinge(b, 0, gate ? "gate_leg" : "bracket", pin, v3(0, side * way, 0), 0.0f, far);
    dmg_rod(b, v3(pin.x, gate ? 0.15f * top : low, z), v3(pin.x, top, z), r);
    dmg_beam(b, v3(pin.x, top - r, z), v3(pin.x, top - r, z + way * length), 1.6f * r, 2 * r);
    if (gate) {
        dmg_beam(b, v3(pin.x, low, z + way * length), v3(pin.x, top, z + way * length), 1.8f * r, 1.8f * r);
        dmg_beam(b, v3(pin.x, 0.2f * top, z), v3(pin.x, 0.2f * top, z + way * length), 1.4f * r, 1.4f * r);
    } else {
        dmg_beam(b, v3(pin.x, low + r, z), v3(pin.x, top - r, z + 0.9f * way * length), 1.4f * r, 1.4f * r);
    }
    dmg_use(b, 0);
    dmg_box_span(b, v3(pin.x - side * r - 0.5f * r, low, z - r), v3(pin.x - side * r + 0.5f * r, top, z + r));
    if (!down) dmg_rest(b, part, far);
    if (!down) dmg_keep_rest(b, part);
}

static void draw_drop_leaves(dmg_builder* b, const table* k) {
    float middle = 0.5f * k->length * dmg_range(b, 0.2f, 0.6f),
          reach = fminf(0.5f * k->length - middle, 0.85f * k->high), t = k->t,
          inner = middle - dmg_range(b, 0.02f, 0.06f) * k->length - 0.5f * k->leg, far = dmg_range(b, 1.45f, 1.57f);
    int line = dmg_int(b, 0, 2), ends = dmg_chance(b, 0.75f) ? 2 : 1;
    table whole = *k;
    whole.length = 2 * (middle + reach);
    draw_frame(b, k, inner, 0.42f * k->width, false);
    draw_piece(b, &whole, -middle, ends == 2 ? middle : middle + reach, k->high);
    if (ends == 1) ++line;
    const float through[] = {t, 0.5f * t, t, 0.5f * t};
    float below = through[line], gap = 0.003f;
    for (int e = 0; e < ends; ++e) {
        float side = e ? 1.0f : -1.0f;
        bool down = dmg_chance(b, 0.6f);
        uint32_t leaf =
            dmg_hinge(b, 0, "leaf", v3(side * (middle + 0.5f * gap), k->high - below, 0), v3(0, 0, -side), 0.0f, far);
        draw_piece(b, &whole, side > 0 ? middle + gap : -middle - reach, side > 0 ? middle + reach : -middle - gap,
                   k->high);
        for (int i = -1; i <= 1 && below == t; i += 2)
            dmg_rod(b, v3(side * middle, k->high - t, 0.25f * (float)i * k->width - 0.03f),
                    v3(side * middle, k->high - t, 0.25f * (float)i * k->width + 0.03f), 0.2f * t);
        if (down) dmg_rest(b, leaf, far);
        dmg_use(b, 0);
        if (dmg_chance(b, 0.6f)) draw_support(b, k, side, inner, reach, down);
    }
}

/* ---- leaves that lie under the top and draw out at the ends; they look like the ones that fall ---- */

static void draw_draw_leaves(dmg_builder* b, const table* k) {
    float half = 0.5f * k->length, reach = half * dmg_range(b, 0.5f, 0.9f),
          w = 0.5f * k->width * dmg_range(b, 0.8f, 0.98f), t = k->t, y = k->high - 1.03f * t;
    table low = *k;
    low.high -= 2.1f * t;
    draw_frame(b, &low, 0.88f * half, 0.42f * k->width, false);
    draw_piece(b, k, -half, half, k->high);
    dmg_box_span(b, v3(-0.03f, low.high - t, -0.4f * k->width),
                 v3(0.03f, k->high - t, 0.4f * k->width)); /* it stands on this */
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, far = dmg_range(b, 0.7f, 0.92f) * reach, rail = 0.35f * w * dmg_range(b, 0.8f, 1.2f);
        uint32_t leaf = dmg_slide(b, 0, "leaf", v3(side, 0, 0), 0.0f, far);
        float x0 = side * (half - reach), x1 = side * half;
        dmg_box_span(b, v3(fminf(x0, x1), y - t, -w), v3(fmaxf(x0, x1), y, w));
        for (int i = -1; i <= 1; i += 2) { /* its runners */
            float z = (float)i * rail, inner = side * (0.05f * half);
            dmg_box_span(b, v3(fminf(inner, x1 - side * 0.1f * half), y - 1.9f * t, z - 0.012f),
                         v3(fmaxf(inner, x1 - side * 0.1f * half), y - 0.9f * t, z + 0.012f));
        }
        rest_table(b, k, leaf, far);
    }
}

/* ---- a top in halves that part on rails; between them a leaf may unfold ---- */

static void draw_parting_top(dmg_builder* b, const table* k) {
    float half = 0.5f * k->length, far = dmg_range(b, 0.15f, 0.4f) * k->length, t = k->t;
    bool both = dmg_chance(b, 0.6f), column = dmg_chance(b, 0.3f), leaf = both && !column && dmg_chance(b, 0.6f);
    table low = *k;
    low.high -= 0.6f * t;
    draw_frame(b, &low, (column ? 0.8f : 0.5f) * half, 0.4f * k->width, column);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        uint32_t part = 0;
        if (both || s > 0) part = dmg_slide(b, 0, "half", v3(side, 0, 0), 0.0f, far);
        draw_piece(b, k, s > 0 ? 0.001f : -half, s > 0 ? half : -0.001f, k->high);
        for (int i = -1; i <= 1; i += 2) {
            float z = (0.2f + 0.04f * side) * (float)i * k->width, end = 0.8f * side * half, in = -0.2f * side * half;
            dmg_box_span(b, v3(fminf(in, end), k->high - 1.55f * t, z - 0.012f),
                         v3(fmaxf(in, end), k->high - t, z + 0.012f));
        }
        if (part)
            rest_table(b, k, part, far);
        else
            dmg_use(b, 0);
    }
    if (!leaf) return;
    float w = 0.4f * far, z = 0.3f * k->width, y = k->high - t - k->apron; /* folded below, its halves on each other */
    float turn = dmg_range(b, 2.6f, 3.1f), thin = fminf(0.5f * t, 0.3f * k->apron);
    dmg_box_span(b, v3(-w, y, -z), v3(w, y + thin, z));
    dmg_hinge(b, 0, "folded_leaf", v3(w, y + thin, 0), v3(0, 0, -1), 0.0f, turn);
    dmg_box_span(b, v3(-w, y + 1.02f * thin, -z), v3(w, y + 2 * thin, z));
    dmg_use(b, 0);
}

/* ---- tops over a chest: they rise, slide away, tip up or are a lid on one side ---- */

static void draw_chest_frame(dmg_builder* b, const table* k, float deep) {
    float foot = k->high - k->t - deep;
    dmg_feet_draw(b, dmg_chance(b, 0.5f) ? 0 : 3, 0.95f * k->length, 0.95f * k->width, foot);
    dmg_save(b);
    dmg_move(b, 0, k->high - k->t, 0);
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, 0.96f * k->length, 0.96f * k->width, deep, 0.018f);
    dmg_restore(b);
}

/* Struts that carry a lid: from the chest's side, folded into it. */
static void draw_lid_strut(dmg_builder* b, const table* k, uint32_t lid, float x, float z, float length) {
    dmg_hinge(b, lid, "strut", v3(x, k->high - 1.3f * k->t, z), v3(1, 0, 0), -1.5f, 0.3f);
    dmg_box_span(b, v3(x - 0.006f, k->high - 1.3f * k->t - 0.012f, z - length),
                 v3(x + 0.006f, k->high - 1.3f * k->t + 0.012f, z));
    dmg_rod(b, v3(x - 0.01f, k->high - 1.3f * k->t, z), v3(x + 0.01f, k->high - 1.3f * k->t, z), 0.015f);
    dmg_use(b, 0);
}

/* Straight up, on columns that stand in the chest. */
static void draw_rising_top(dmg_builder* b, const table* k, float from, float deep) {
    float half = 0.5f * k->length, middle = 0.5f * (from + half), far = 0.9f * deep;
    uint32_t top = dmg_slide(b, 0, "top", v3(0, 1, 0), 0.0f, far);
    for (int i = -1; i <= 1; i += 2) {
        float x = middle + 0.3f * (float)i * (half - from);
        dmg_rod(b, v3(x, k->high - 0.9f * deep, 0), v3(x, k->high - k->t, 0), 0.02f);
    }
    draw_piece(b, k, from, half, k->high);
    rest_table(b, k, top, far);
}

/* Aside, over the fixed part's end or the long edge; strips below it run in the chest. */
static void draw_aside_top(dmg_builder* b, const table* k, float from) {
    float half = 0.5f * k->length, c = 0.5f * k->width, middle = 0.5f * (from + half), way = dmg_sign(b);
    bool along = from == -half && dmg_chance(b, 0.5f);
    float far = (along ? half : c) * dmg_range(b, 0.4f, 1.1f), y = k->high - 1.4f * k->t;
    uint32_t top = dmg_slide(b, 0, "top", along ? v3(way, 0, 0) : v3(0, 0, way), 0.0f, far);
    draw_piece(b, k, from, half, k->high);
    for (int i = -1; i <= 1; i += 2) {
        float x = middle + 0.3f * (float)i * (half - from);
        if (along)
            dmg_box(b, v3(0, y, 0.7f * (float)i * c), v3(1.4f * half, 0.6f * k->t, 0.02f));
        else
            dmg_box(b, v3(x, y, 0), v3(0.02f, 0.6f * k->t, 1.4f * c));
    }
    rest_table(b, k, top, far);
}

/* Draws a lid about its rear edge, perhaps with a strut. */
static void draw_tipping_top(dmg_builder* b, const table* k, float from) {
    float half = 0.5f * k->length, c = 0.5f * k->width, far = dmg_range(b, 0.7f, 1.6f);
    float y = k->high - (dmg_chance(b, 0.5f) ? 0.0f : k->t);
    uint32_t top = dmg_hinge(b, 0, "top", v3(0.5f * (from + half), y, -c), v3(-1, 0, 0), 0.0f, far);
    draw_piece(b, k, from, half, k->high);
    rest_table(b, k, top, far);
    if (dmg_chance(b, 0.5f))
        draw_lid_strut(b, k, top, half - 0.06f * k->length, 0.6f * c, dmg_range(b, 0.6f, 1.0f) * c);
}

/* Draws two lids that meet, each about its own end; beside a fixed part one of them is fixed too. */
static void draw_lid_pair(dmg_builder* b, const table* k, float from) {
    float half = 0.5f * k->length, mid = 0.5f * (from + half), far = dmg_range(b, 1.2f, 1.7f),
          y = k->high - k->t * dmg_range(b, 0.0f, 1.0f);
    for (int s = -1; s <= 1; s += 2) {
        float x0 = s < 0 ? from : mid + 0.001f, x1 = s < 0 ? mid - 0.001f : half;
        uint32_t lid = 0;
        if (s > 0 || from == -half)
            lid = dmg_hinge(b, 0, "lid", v3((float)s * half, y, 0), v3(0, 0, (float)-s), 0.0f, far);
        draw_piece(b, k, x0, x1, k->high);
        if (lid) rest_table(b, k, lid, far);
    }
}

static void draw_chest_table(dmg_builder* b, const table* k) {
    float deep = dmg_range(b, 0.25f, 0.6f) * k->high, half = 0.5f * k->length,
          from = dmg_chance(b, 0.5f) ? -half : half * dmg_range(b, -0.4f, 0.1f);
    int kind = dmg_int(b, 0, 3);
    draw_chest_frame(b, k, deep);
    if (from > -half) draw_piece(b, k, -half, from - 0.002f, k->high);
    if (kind == 0) draw_rising_top(b, k, from, deep);
    if (kind == 1) draw_aside_top(b, k, from);
    if (kind == 2) draw_tipping_top(b, k, from);
    if (kind == 3) draw_lid_pair(b, k, from);
}

/* ---- a top that turns on its frame and then unfolds, one that tips up on a column, one on a screw ---- */

static void draw_turning_top(dmg_builder* b, const table* k) {
    float half = 0.5f * k->length, off = dmg_range(b, 0.0f, 0.25f) * half, far = 0.5f * DMG_PI, t = 0.5f * k->t;
    table low = *k;
    low.high -= 1.02f * t; /* two boards on each other */
    low.t = t;
    draw_frame(b, &low, 0.85f * half, 0.42f * k->width, dmg_chance(b, 0.3f));
    uint32_t top = dmg_hinge(b, 0, "top", v3(off, low.high, 0), v3(0, dmg_sign(b), 0), 0.0f, far);
    dmg_box_span(b, v3(-half, low.high - t + 0.001f, -0.5f * k->width), v3(half, low.high, 0.5f * k->width));
    dmg_rod(b, v3(off, low.high - 2.5f * t, 0), v3(off, low.high - t, 0), 0.04f);
    float turn = dmg_range(b, 2.9f, 3.14f), side = dmg_sign(b);
    uint32_t leaf =
        dmg_hinge(b, top, "leaf", v3(0, low.high + 0.01f * t, side * 0.5f * k->width), v3(side, 0, 0), 0.0f, turn);
    dmg_box_span(b, v3(-half, low.high + 0.02f * t, -0.5f * k->width), v3(half, k->high, 0.5f * k->width));
    rest_table(b, k, top, far);
    rest_table(b, k, leaf, turn);
}

static void draw_column_top(dmg_builder* b, const table* k) {
    float r = 0.5f * fminf(k->length, k->width), top = k->high - k->t, leg = 0.7f * k->leg, far;
    int kind = dmg_int(b, 0, 2), feet = dmg_int(b, 3, 5);
    dmg_cone(b, v3(0, 0.08f * top, 0), v3(0, 0.75f * top, 0), 1.5f * leg, leg);
    for (int i = 0; i < feet; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, feet);
        dmg_beam(b, v3(0, 0.15f * top, 0), v3(0, 0.02f, 0.75f * r), leg, leg);
        dmg_restore(b);
    }
    uint32_t part;
    if (kind == 0) { /* tips up about pins in a block on the column */
        dmg_cone(b, v3(0, 0.75f * top, 0), v3(0, top - 0.06f, 0), leg, leg);
        dmg_box_span(b, v3(-2 * leg, top - 0.07f, -2 * leg), v3(2 * leg, top - 0.03f, 2 * leg));
        float z = -2 * leg * dmg_range(b, 0.2f, 1.0f);
        part =
            dmg_hinge(b, 0, "top", v3(0, top - 0.03f + 0.01f, z), v3(-1, 0, 0), 0.0f, far = dmg_range(b, 1.2f, 1.57f));
        for (int i = -1; i <= 1; i += 2)
            dmg_box_span(b, v3(2.6f * (float)i * leg - 0.01f, top - 0.03f, -0.6f * r),
                         v3(2.6f * (float)i * leg + 0.01f, top, 0.6f * r));
        dmg_rod(b, v3(-3 * leg, top - 0.02f, z), v3(3 * leg, top - 0.02f, z), 0.008f);
    } else { /* rises on a screw, or on a stem that slides */
        float pitch = dmg_range(b, 0.004f, 0.012f);
        far = kind == 1 ? fminf(0.4f * top / pitch, 38.0f) : 0.4f * top;
        if (kind == 1)
            part = dmg_screw(b, 0, "top", v3(0, top, 0), v3(0, 1, 0), pitch, 0.0f, far);
        else
            part = dmg_slide(b, 0, "top", v3(0, 1, 0), 0.0f, far);
        dmg_rod(b, v3(0, 0.3f * top, 0), v3(0, top, 0), 0.6f * leg);
        for (int i = 0; i < 8 && kind == 1; ++i)
            dmg_torus(b, v3(0, top * (0.77f + 0.025f * (float)i), 0), v3(0, 1, 0), 0.6f * leg, 0.1f * leg);
        dmg_rod(b, v3(0, top - 0.02f, 0), v3(0, top, 0), 3 * leg);
    }
    draw_piece(b, k, -0.5f * k->length, 0.5f * k->length, k->high);
    rest_table(b, k, part, far);
    if (kind != 2) return;
    dmg_screw(b, 0, "clamp", v3(1.2f * leg, 0.7f * top, 0), v3(-1, 0, 0), 0.001f, 0.0f, 9.0f); /* holds the stem */
    dmg_rod(b, v3(0.8f * leg, 0.7f * top, 0), v3(2.2f * leg, 0.7f * top, 0), 0.25f * leg);
    dmg_box(b, v3(2.3f * leg, 0.7f * top, 0), v3(0.4f * leg, 1.6f * leg, 0.5f * leg));
    dmg_use(b, 0);
}

void dmg_build_extending_table(dmg_builder* b) {
    table k = {.length = dmg_scale_range(b, 0.6f, 2.0f)};
    k.width = fminf(k.length * dmg_range(b, 0.5f, 1.0f), 1.1f);
    k.high = dmg_range(b, 0.35f, 0.9f);
    k.t = dmg_range(b, 0.015f, 0.045f);
    k.leg = dmg_range(b, 0.03f, 0.08f);
    k.apron = dmg_range(b, 0.06f, 0.14f);
    k.outline = dmg_int(b, 0, 2);
    k.open = dmg_chance(b, 0.4f) ? 0.0f : dmg_range(b, 0.2f, 0.8f);
    switch (dmg_int(b, 0, 6)) {
    case 0:
    case 1:
        draw_drop_leaves(b, &k);
        break;
    case 2:
        k.outline = 0;
        draw_draw_leaves(b, &k);
        break;
    case 3:
        draw_parting_top(b, &k);
        break;
    case 4:
        k.outline = 0;
        draw_chest_table(b, &k);
        break;
    case 5:
        draw_turning_top(b, &k);
        break;
    default:
        draw_column_top(b, &k);
        break;
    }
}
