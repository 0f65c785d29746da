/* Draws bathroom fittings: cabins with hung, folding and sliding doors, screens on baths, rails with heads that
 * slide and tilt, mixers; towel arms, paper holders, soap dishes and mirrors on arms. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- on a wall whose face is z = 0 ---- */

/* Its face looks along +Z and down; `parent` bears it at the origin. */
static void draw_shower_head(dmg_builder* b, uint32_t parent, float r) {
    bool square = dmg_chance(b, 0.3f), wand = dmg_chance(b, 0.5f);
    dmg_hinge(b, parent, "head", v3(0, 0, 0), v3(1, 0, 0), -0.6f, 0.6f);
    dmg_ellipsoid(b, v3(0, 0, 0), v3(0.02f, 0.02f, 0.02f));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.7f);
    if (wand) dmg_cone(b, v3(0, -0.16f, 0), v3(0, 0.02f, 0.01f), 0.01f, 0.014f);
    float y = wand ? 0.02f + 0.8f * r : 0.0f;
    if (square)
        dmg_rounded_box(b, v3(0, y, 0.03f), v3(2 * r, 2 * r, 0.024f), 0.008f);
    else
        dmg_cone(b, v3(0, y, 0.0f), v3(0, y, 0.04f), 0.5f * r, r);
    dmg_rod(b, v3(0, y, 0.039f), v3(0, y, 0.044f), 0.85f * r);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a rod on two feet; what holds the head slides along it, and some turn on it. */
static void draw_rail(dmg_builder* b, float y, float length) {
    float z = 0.05f, r = 0.01f, low = 0.2f * length, way = 0.7f * length, rest = way * dmg_range(b, 0.3f, 1.0f),
          head = dmg_range(b, 0.035f, 0.07f);
    bool dish = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, y, z), v3(0, y + length, z), r);
    for (int i = 0; i < 2; ++i) {
        float at = i ? y + 0.96f * length : y + 0.04f * length;
        dmg_rod(b, v3(0, at, 0), v3(0, at, z), 1.3f * r);
    }
    uint32_t slider = dmg_slide(b, 0, "slider", v3(0, 1, 0), 0.0f, way);
    dmg_rest(b, slider, rest);
    dmg_box_span(b, v3(-0.018f, y + low - 0.03f, z - 0.018f), v3(0.018f, y + low + 0.03f, z + 0.025f));
    dmg_save(b);
    dmg_move(b, 0, y + low, z + 0.045f);
    draw_shower_head(b, slider, head);
    dmg_restore(b);
    dmg_hinge(b, slider, "clamp", v3(0, y + low, z), v3(1, 0, 0), -0.8f, 0.8f);
    dmg_rod(b, v3(0.0185f, y + low, z), v3(0.04f, y + low, z), 0.014f);
    dmg_use(b, 0);
    if (!dish) return;
    float at = y + 0.12f * length;
    dmg_slide(b, 0, "soap_dish", v3(0, 1, 0), -0.03f, 0.05f);
    dmg_box_span(b, v3(-0.07f, at - 0.01f, z - 0.015f), v3(0.07f, at + 0.004f, z + 0.09f));
    dmg_use(b, 0);
}

/* Draws one lever on a plate, a bar with a handle at either end, or two cross handles; a spout below some. */
static void draw_mixer(dmg_builder* b, float y) {
    int kind = dmg_int(b, 0, 2);
    float r = dmg_range(b, 0.018f, 0.03f), wide = dmg_range(b, 0.1f, 0.16f), z = 0.06f;
    if (kind == 0) { /* tilts for the flow on a cap that turns for the heat */
        dmg_rod(b, v3(0, y, 0), v3(0, y, 0.012f), 2.4f * r);
        uint32_t cap = dmg_hinge(b, 0, "heat", v3(0, y, 0), v3(0, 0, 1), -0.8f, 0.8f);
        dmg_rod(b, v3(0, y, 0.0125f), v3(0, y, z), 1.3f * r);
        dmg_hinge(b, cap, "lever", v3(0, y, z), v3(-1, 0, 0), 0.0f, 0.45f);
        dmg_box_span(b, v3(-0.4f * r, y - 0.1f, z + 0.001f), v3(0.4f * r, y + r, z + 0.012f));
    }
    if (kind == 1) {
        dmg_rod(b, v3(-wide, y, z), v3(wide, y, z), r);
        for (int i = -1; i <= 1; i += 2) {
            float side = (float)i;
            dmg_use(b, 0);
            dmg_rod(b, v3(0.6f * side * wide, y, 0), v3(0.6f * side * wide, y, z), 0.7f * r);
            dmg_hinge(b, 0, i < 0 ? "flow" : "heat", v3(0, y, z), v3(1, 0, 0), -1.5f, 1.5f);
            dmg_rod(b, v3(side * (wide + 0.001f), y, z), v3(side * (wide + 2 * r), y, z), 1.1f * r);
            dmg_box(b, v3(side * (wide + 1.2f * r), y, z + 1.15f * r), v3(r, 0.4f * r, 0.5f * r));
        }
    }
    for (int i = -1; i <= 1 && kind == 2; i += 2) {
        float x = 0.6f * (float)i * wide;
        dmg_use(b, 0);
        dmg_rod(b, v3(x, y, 0), v3(x, y, z), 0.8f * r);
        dmg_spin(b, 0, "tap", v3(x, y, 0), v3(0, 0, (float)i));
        for (int k = 0; k < 2; ++k) {
            dmg_vec arm = k ? v3(1.8f * r, 0, 0) : v3(0, 1.8f * r, 0), at = v3(x, y, z + 0.4f * r + 0.001f);
            dmg_rod(b, v3_sub(at, arm), v3_add(at, arm), 0.4f * r);
        }
    }
    dmg_use(b, 0);
}

/* Draws an arm out of the wall with a wide head on a ball. */
static void draw_fixed_head(dmg_builder* b, float y) {
    float reach = dmg_range(b, 0.15f, 0.4f), r = dmg_range(b, 0.07f, 0.15f);
    bool turns = dmg_chance(b, 0.5f);
    uint32_t arm = turns ? dmg_hinge(b, 0, "arm", v3(0, 0, 0.02f), v3(0, 1, 0), -0.8f, 0.8f) : 0;
    const dmg_vec pipe[] = {
        {0, y, 0.001f}, {0, y + 0.03f, 0.5f * reach}, {0, y + 0.01f, 0.9f * reach}, {0, y - 0.04f, reach}};
    dmg_sweep(b, pipe, 4, 0.011f, 0.011f, false);
    dmg_hinge(b, arm, "head", v3(0, y - 0.05f, reach), v3(1, 0, 0), -0.35f, 0.35f);
    dmg_ellipsoid(b, v3(0, y - 0.05f, reach), v3(0.02f, 0.02f, 0.02f));
    dmg_cone(b, v3(0, y - 0.085f, reach), v3(0, y - 0.06f, reach), r, 0.3f * r);
    dmg_use(b, 0);
}

static void draw_wash_set(dmg_builder* b, float y) {
    int kind = dmg_int(b, 0, 2);
    draw_mixer(b, y);
    if (kind != 1) draw_rail(b, y + 0.12f, dmg_range(b, 0.55f, 0.8f));
    dmg_save(b);
    if (kind == 2) dmg_move(b, 0.16f, 0, 0);
    if (kind > 0) draw_fixed_head(b, y + dmg_range(b, 0.95f, 1.05f));
    dmg_restore(b);
}

/* ---- glass ---- */

/* Draws a pane between two x on the plane z = 0, hung at x0: alone, or with a second one folding on it. */
static void draw_hung_pane(dmg_builder* b, float x0, float x1, float y0, float y1, bool folds) {
    float t = 0.008f, way = x1 > x0 ? 1.0f : -1.0f, end = folds ? 0.5f * (x0 + x1) : x1, pin = x0,
          swing = dmg_range(b, 1.2f, 1.9f);
    if (!folds && dmg_chance(b, 0.3f)) pin = x0 + 0.15f * (x1 - x0); /* on pivots within its width */
    uint32_t door = dmg_hinge(b, 0, "door", v3(pin, 0, 0), v3(0, -way, 0), 0.0f, swing);
    dmg_box_span(b, v3(fminf(x0, end), y0, -0.5f * t), v3(fmaxf(x0, end), y1, 0.5f * t));
    for (int i = 0; i < 2; ++i) {
        float y = y0 + (y1 - y0) * (i ? 0.88f : 0.12f);
        dmg_box(b, v3(x0 + 0.03f * way, y, 0), v3(0.05f, 0.07f, 4 * t));
    }
    if (folds) {
        dmg_hinge(b, door, "fold", v3(end, 0, -0.5f * t), v3(0, way, 0), 0.0f, 2.8f);
        dmg_box_span(b, v3(fminf(end + 0.004f * way, x1), y0, -0.5f * t),
                     v3(fmaxf(end + 0.004f * way, x1), y1, 0.5f * t));
    }
    float gx = x1 - 0.06f * way, gy = 0.5f * (y0 + y1);
    dmg_rod(b, v3(gx, gy - 0.12f, 0.05f), v3(gx, gy + 0.12f, 0.05f), 0.009f);
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3(gx, gy + 0.09f * (float)i, 0), v3(gx, gy + 0.09f * (float)i, 0.05f), 0.007f);
    dmg_use(b, 0);
}

static void draw_sliding_panes(dmg_builder* b, float w, float y0, float y1) {
    int leaves = dmg_int(b, 1, 2);
    float t = 0.008f, x = 0.5f * w, mid = leaves > 1 ? 0.25f * w : 0.0f;
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(-x, i ? y1 : y0 - 0.03f, -0.03f), v3(x, i ? y1 + 0.04f : y0 - 0.001f, 0.03f));
    dmg_box_span(b, v3(-x, y0, -0.02f), v3(-mid, y1, -0.02f + t));
    if (leaves > 1) dmg_box_span(b, v3(mid, y0, -0.02f), v3(x, y1, -0.02f + t));
    for (int i = 0; i < leaves; ++i) {
        float x0 = leaves == 1 || i ? 0.002f : -mid - 0.02f,
              x1 = leaves == 1 ? x
                   : i         ? mid + 0.02f
                               : -0.002f,
              way = leaves == 1 || !i ? -1.0f : 1.0f,
              grip = way < 0.0f && leaves == 1 ? x1 - 0.05f
                     : i                       ? x0 + 0.05f
                                               : x1 - 0.05f;
        dmg_slide(b, 0, "sliding_door", v3(way, 0, 0), 0.0f, leaves == 1 ? 0.44f * w : 0.2f * w);
        dmg_box_span(b, v3(x0, y0 + 0.002f, 0.005f), v3(x1, y1 - 0.002f, 0.005f + t));
        dmg_box_span(b, v3(grip - 0.012f, 0.4f * (y0 + y1), 0.005f + t), v3(grip + 0.012f, 0.6f * (y0 + y1), 0.04f));
        dmg_use(b, 0);
    }
}

static void draw_cabin(dmg_builder* b) {
    float w = dmg_range(b, 0.8f, 1.4f), d = dmg_range(b, 0.75f, 1.0f), tray = dmg_range(b, 0.04f, 0.18f), t = 0.02f,
          h = tray + dmg_range(b, 1.8f, 2.05f), x = 0.5f * w, still = w > 1.0f ? w * dmg_range(b, 0.3f, 0.5f) : 0.02f;
    int doors = dmg_int(b, 0, 3);
    dmg_box_span(b, v3(-x, 0, -d), v3(x, tray, 0.03f));
    dmg_box_span(b, v3(-x, tray, -d), v3(x, h, t - d));
    for (int i = -1; i <= 1; i += 2) /* glass or tiles beside it */
        dmg_box_span(b, v3((float)i * (x - 0.5f * t) - 0.5f * t, tray, t - d),
                     v3((float)i * (x - 0.5f * t) + 0.5f * t, h, -0.04f));
    dmg_save(b);
    dmg_move(b, 0, 0, t - d);
    draw_wash_set(b, 1.0f + tray);
    dmg_restore(b);
    dmg_move(b, 0, 0, -0.03f);
    if (doors == 3) {
        draw_sliding_panes(b, w, tray + 0.04f, h - 0.04f);
        return;
    }
    if (doors == 2) { /* a pair that meets in the middle */
        draw_hung_pane(b, 0.02f - x, -0.003f, tray + 0.015f, h, false);
        draw_hung_pane(b, x - 0.02f, 0.003f, tray + 0.015f, h, false);
        return;
    }
    float side = dmg_sign(b);
    if (still > 0.1f)
        dmg_box_span(b, v3(fminf(side * x, side * (x - still)), tray, -0.004f),
                     v3(fmaxf(side * x, side * (x - still)), h, 0.004f));
    draw_hung_pane(b, -side * (x - 0.02f), side * (x - still - 0.004f), tray + 0.015f, h, doors == 1);
}

/* Draws a tub against the wall with one to three panes in a row on its rim. */
static void draw_bath(dmg_builder* b) {
    float w = dmg_range(b, 1.4f, 1.8f), d = dmg_range(b, 0.65f, 0.8f), h = dmg_range(b, 0.5f, 0.62f), x = 0.5f * w,
          rim = 0.06f, t = 0.006f, tall = dmg_range(b, 1.2f, 1.5f), each;
    int panes = dmg_int(b, 1, 3);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * h + 0.05f, -0.5f * d);
    dmg_face_up(b);
    dmg_move(b, 0, 0, 0.5f * h - 0.05f);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, d, h - 0.05f, rim);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.97f * x, 0, -0.97f * d), v3(0.97f * x, 0.06f, -0.03f * d));
    dmg_box_span(b, v3(-x - 0.03f, 0, -d), v3(-x, h + tall + 0.1f, 0)); /* the wall at its head */
    dmg_save(b);
    dmg_move(b, -x, 0, -0.5f * d);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    draw_wash_set(b, h + 0.2f);
    dmg_restore(b);
    each = dmg_range(b, 0.7f, 1.0f) / (float)panes;
    uint32_t parent = 0;
    for (int i = 0; i < panes; ++i) {
        float x0 = 0.002f - x + each * (float)i, fold = i & 1 ? 1.0f : -1.0f;
        parent =
            dmg_hinge(b, parent, "screen", v3(x0, 0, -0.5f * rim), v3(0, fold, 0), i ? 0.0f : -1.4f, i ? 2.9f : 1.5f);
        dmg_box_span(b, v3(x0, h + 0.01f, -0.5f * rim - t), v3(x0 + each - 0.004f, h + tall, -0.5f * rim));
        dmg_rod(b, v3(x0, h + 0.005f, -0.5f * rim), v3(x0, h + tall, -0.5f * rim), 0.5f * t);
    }
    dmg_use(b, 0);
    dmg_hinge(b, 0, "plug", v3(0.3f * x, 0.1f + rim, -0.5f * d), v3(0, 1, 0), 0.0f, 3.0f);
    dmg_rod(b, v3(0.3f * x, 0.055f + rim, -0.5f * d), v3(0.3f * x, 0.075f + rim, -0.5f * d), 0.03f);
    dmg_box(b, v3(0.3f * x, 0.08f + rim, -0.5f * d), v3(0.05f, 0.012f, 0.008f));
    dmg_use(b, 0);
}

/* ---- on the wall beside ---- */

/* Arms one over the other on one pin, each with its own height. */
static void draw_towel_arms(dmg_builder* b) {
    int arms = dmg_int(b, 2, 4);
    float z = 0.05f, length = dmg_range(b, 0.3f, 0.5f), pitch = dmg_range(b, 0.025f, 0.05f), r = 0.007f,
          high = pitch * (float)arms;
    dmg_box_span(b, v3(-0.025f, 0, 0), v3(0.025f, high + 0.04f, 0.008f));
    for (int i = 0; i < 2; ++i)
        dmg_box_span(b, v3(-0.012f, i ? high + 0.021f : 0.005f, 0.008f),
                     v3(0.012f, i ? high + 0.035f : 0.019f, z + 0.012f));
    dmg_rod(b, v3(0, 0.01f, z), v3(0, high + 0.03f, z), 0.6f * r);
    for (int i = 0; i < arms; ++i) {
        float y = 0.02f + pitch * ((float)i + 0.5f), rest = dmg_range(b, -1.2f, 1.2f);
        uint32_t arm = dmg_hinge(b, 0, "towel_arm", v3(0, y, z), v3(0, 1, 0), -1.4f, 1.4f);
        dmg_rest(b, arm, rest);
        dmg_rod(b, v3(0, y - 0.45f * pitch, z), v3(0, y + 0.45f * pitch, z), 1.5f * r);
        dmg_capsule(b, v3(0, y, z), v3(0, y, z + length), r);
        dmg_use(b, 0);
    }
}

/* Draws a roll on its bar below a flap, or on a pin that lies open at one end. */
static void draw_paper_holder(dmg_builder* b) {
    float r = dmg_range(b, 0.045f, 0.07f), half = 0.05f, y = r + 0.01f, z = r + 0.015f, t = 0.004f;
    bool flap = dmg_chance(b, 0.65f);
    dmg_box_span(b, v3(-half - 0.02f, 0, 0), v3(half + 0.02f, y + r + 0.04f, 0.008f));
    for (int i = -1; i <= 1; i += 2)
        if (i < 0 || flap)
            dmg_box_span(b, v3((float)i * (half + 0.01f) - t, y - 0.012f, 0.008f),
                         v3((float)i * (half + 0.01f) + t, y + 0.012f, z + 0.012f));
    dmg_rod(b, v3(-half - 0.012f, y, z), v3(half + 0.012f, y, z), 0.007f);
    dmg_spin(b, 0, "roll", v3(0, y, z), v3(1, 0, 0));
    dmg_rod(b, v3(-half, y, z), v3(half, y, z), 0.9f * r);
    dmg_box_span(b, v3(-half, y - 1.5f * r, z + 0.87f * r), v3(half, y, z + 0.91f * r)); /* the loose end */
    dmg_use(b, 0);
    if (!flap) return;
    float top = y + r + 0.02f;
    dmg_hinge(b, 0, "flap", v3(0, top, 0.012f), v3(-1, 0, 0), 0.0f, 1.5f);
    const dmg_xy line[] = {{0.009f, top}, {z, top - 0.2f * r}, {z + 0.95f * r, y + 0.6f * r}, {z + 1.1f * r, y}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_bent_plate(b, line, 4, t, 2 * half + 0.03f);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Scissors or two links carry a round glass that tilts. */
static void draw_shaving_mirror(dmg_builder* b) {
    float z = 0.03f, link = dmg_range(b, 0.15f, 0.25f), r = dmg_range(b, 0.07f, 0.12f), t = 0.01f, y = r;
    int links = dmg_int(b, 1, 2);
    dmg_box_span(b, v3(-0.02f, y - 0.05f, 0), v3(0.02f, y + 0.05f, 0.01f));
    dmg_rod(b, v3(0, y - 0.025f, z), v3(0, y + 0.025f, z), 0.4f * t);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3(-t, y + 0.025f * (float)i - 0.004f, 0.01f), v3(t, y + 0.025f * (float)i + 0.004f, z + t));
    uint32_t last = 0;
    for (int i = 0; i < links; ++i) {
        last = dmg_hinge(b, last, "link", v3(0, y, z), v3(0, 1, 0), i ? -2.4f : -1.2f, i ? 2.4f : 1.2f);
        dmg_rod(b, v3(0, y - 0.018f, z), v3(0, y + 0.018f, z), t);
        dmg_rod(b, v3(0, y, z), v3(0, y, z + link - 1.2f * t), 0.6f * t);
        z += link;
    }
    last = dmg_hinge(b, last, "swivel", v3(0, y, z), v3(0, 1, 0), -1.5f, 1.5f);
    dmg_rod(b, v3(0, y - 0.02f, z), v3(0, y + 0.02f, z), 1.1f * t);
    dmg_hinge(b, last, "mirror", v3(0, y, z + 2 * t), v3(1, 0, 0), -0.7f, 0.7f);
    dmg_rod(b, v3(0, y, z + 1.2f * t), v3(0, y, z + 3 * t), r);
    dmg_torus(b, v3(0, y, z + 2.1f * t), v3(0, 0, 1), r, 0.8f * t);
    dmg_use(b, 0);
}

void dmg_build_shower(dmg_builder* b) {
    switch (dmg_weighted(b, (const float[]){4, 2, 2, 1, 1, 1}, 6)) {
    case 0:
        draw_cabin(b);
        break;
    case 1:
        draw_bath(b);
        break;
    case 2:
        dmg_box_span(b, v3(-0.3f, 0, -0.02f), v3(0.3f, 1.4f, 0));
        draw_wash_set(b, 0.15f);
        break;
    case 3:
        draw_towel_arms(b);
        break;
    case 4:
        draw_paper_holder(b);
        break;
    default:
        draw_shaving_mirror(b);
        break;
    }
}
