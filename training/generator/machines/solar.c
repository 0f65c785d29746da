/* Draws solar panels: satellite wings, cases that fold out, trackers. Chains of equal leaves, each hung on the one
 * before. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct leaf_style {
    int kind; /* plate, sheet, frame, cells, case */
    float width, height, thick;
    int columns, rows;
} leaf_style;

/* Centred at the origin, thin along Z, its cells to +Z. */
static void draw_leaf(dmg_builder* b, const leaf_style* s) {
    float w = s->width, h = s->height, t = s->thick;
    if (s->kind == 0) dmg_box(b, v3(0, 0, 0), v3(w, h, t));
    if (s->kind == 1) dmg_box_faces(b, v3(0, 0, 0), v3(w, h, t), DMG_FACE_FRONT);
    if (s->kind == 2) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.5f * t);
        dmg_frame_draw(b, w, h, t, 0.05f * fminf(w, h));
        dmg_restore(b);
        dmg_box(b, v3(0, 0, -0.1f * t), v3(0.95f * w, 0.95f * h, 0.3f * t));
    }
    if (s->kind >= 3) {
        if (s->kind == 3)
            dmg_box(b, v3(0, 0, -0.1f * t), v3(w, h, 0.8f * t));
        else
            dmg_rounded_box(b, v3(0, 0, -0.1f * t), v3(w, h, 0.8f * t), 0.35f * t);
        float cell_w = 0.96f * w / (float)s->columns, cell_h = 0.96f * h / (float)s->rows;
        for (int i = 0; i < s->columns * s->rows; ++i) {
            float x = ((float)(i % s->columns) - 0.5f * (float)(s->columns - 1)) * cell_w,
                  y = ((float)(i / s->columns) - 0.5f * (float)(s->rows - 1)) * cell_h;
            dmg_box(b, v3(x, y, 0.4f * t), v3(0.94f * cell_w, 0.94f * cell_h, 0.2f * t));
        }
    }
}

static leaf_style pick_leaf(dmg_builder* b, float width, float height, float thick) {
    leaf_style s = {.kind = dmg_int(b, 0, 4), .width = width, .height = height, .thick = thick};
    s.columns = dmg_int(b, 1, 3);
    s.rows = dmg_int(b, 1, 4);
    return s;
}

/* How a chain folds: every leaf by nearly half a turn, to and fro (a fan) or always the same way (a roll of two). */
typedef struct fold_style {
    float full, rest; /* rest: how far it is folded as shown, fraction */
    float gap;        /* between leaves, of their width */
    int place;        /* of the hinge: on the face it folds towards, in the middle of the edge */
    bool pins, by_turns;
} fold_style;

static fold_style pick_fold(dmg_builder* b) {
    fold_style f = {.full = dmg_chance(b, 0.6f) ? DMG_PI : dmg_range(b, 1.4f, 3.0f), .place = dmg_int(b, 0, 1)};
    int shown = dmg_int(b, 0, 3); /* flat, folded, a zigzag */
    f.rest = shown == 0 ? 0.0f : (shown == 1 ? 1.0f : dmg_range(b, 0.2f, 0.9f));
    f.gap = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.01f, 0.05f);
    f.pins = dmg_chance(b, 0.4f);
    f.by_turns = dmg_chance(b, 0.8f);
    if (f.place == 1) f.full = fminf(f.full, 2.9f); /* in the middle the leaves meet before they lie flat */
    return f;
}

/* Draws a leaf along +X, hung on `carrier` at the origin; sign: which face it folds towards. Returns the part. */
static uint32_t draw_chain_leaf(dmg_builder* b, uint32_t carrier, const leaf_style* s, const fold_style* f,
                                float sign) {
    float z = f->place == 0 ? sign * 0.5f * s->thick : 0.0f;
    uint32_t part = dmg_hinge(b, carrier, "panel", v3(0, 0, z), v3(0, -sign, 0), 0.0f, f->full);
    dmg_rest(b, part, f->rest * f->full);
    dmg_keep_rest(b, part);
    dmg_save(b);
    dmg_move(b, (0.5f + f->gap) * s->width, 0, 0);
    draw_leaf(b, s);
    dmg_restore(b);
    for (int k = -1; k <= 1 && f->pins; k += 2)
        dmg_rod(b, v3(0, ((float)k * 0.3f - 0.05f) * s->height, z), v3(0, ((float)k * 0.3f + 0.05f) * s->height, z),
                0.5f * s->thick);
    return part;
}

/* Leaves one after another from the origin towards +X. */
static void draw_chain(dmg_builder* b, uint32_t carrier, const leaf_style* s, const fold_style* f, int count) {
    float sign = 1.0f;
    for (int i = 0; i < count; ++i) {
        fold_style own = *f;
        if (i == 0) own.full = fminf(own.full, 1.57f); /* further it would lie in the body */
        carrier = draw_chain_leaf(b, carrier, s, &own, sign);
        dmg_move(b, (1.0f + 2.0f * f->gap) * s->width, 0, 0);
        if (f->by_turns) sign = -sign;
    }
    dmg_use(b, 0);
}

/* ---- satellite ---- */

static void draw_bus(dmg_builder* b, float size, float high) {
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_box(b, v3(0, 0, 0), v3(size, high, size));
    if (kind == 1) dmg_rod(b, v3(0, -0.5f * high, 0), v3(0, 0.5f * high, 0), 0.5f * size);
    if (kind == 2) { /* eight-sided */
        dmg_xy outline[8];
        for (int i = 0; i < 8; ++i) {
            float angle = 0.25f * DMG_PI * ((float)i + 0.5f);
            outline[i] = (dmg_xy){0.54f * size * cosf(angle), 0.54f * size * sinf(angle)};
        }
        dmg_extrude(b, outline, 8, -0.5f * high, 0.5f * high);
    }
    if (dmg_chance(b, 0.5f)) dmg_cone(b, v3(0, 0, 0.4f * size), v3(0, 0, 0.7f * size), 0.1f * size, 0.3f * size);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), 0.03f * size);
}

void dmg_build_satellite(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.1f, 3.0f), high = size * dmg_range(b, 0.6f, 2.0f),
          arm = size * dmg_range(b, 0.05f, 0.6f);
    draw_bus(b, size, high);
    float width = size * dmg_range(b, 0.4f, 1.5f), height = size * dmg_range(b, 0.5f, 1.8f);
    leaf_style s = pick_leaf(b, width, height, fminf(width, height) * dmg_range(b, 0.01f, 0.08f));
    fold_style f = pick_fold(b);
    int count = dmg_int(b, 1, 4), drive = dmg_int(b, 0, 2);
    for (int side = 0; side < 2; ++side) {
        dmg_save(b);
        if (side) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, 0.5f * size, 0, 0);
        uint32_t yoke = 0;
        if (drive == 1) yoke = dmg_spin(b, 0, "drive", v3(0, 0, 0), v3(1, 0, 0));
        if (drive == 2) yoke = dmg_hinge(b, 0, "drive", v3(0, 0, 0), v3(1, 0, 0), -1.6f, 1.6f);
        dmg_use(b, yoke);
        dmg_rod(b, v3(-0.1f * size, 0, 0), v3(arm, 0, 0), 0.04f * size);
        if (dmg_chance(b, 0.4f))
            for (int k = -1; k <= 1; k += 2)
                dmg_beam(b, v3(0.3f * arm, 0, 0), v3(arm, (float)k * 0.4f * height, 0), s.thick, s.thick);
        dmg_move(b, arm, 0, 0);
        draw_chain(b, yoke, &s, &f, count);
        dmg_restore(b);
    }
}

/* ---- a case of panels ---- */

static void draw_case_handle(dmg_builder* b, float width, float top, float t) {
    const dmg_vec path[] = {{-0.2f * width, top, 0},
                            {-0.18f * width, top + 0.12f * width, 0},
                            {0.18f * width, top + 0.12f * width, 0},
                            {0.2f * width, top, 0}};
    dmg_sweep(b, path, 4, 0.4f * t, 0.4f * t, false);
}

/* Draws a second leaf, as big as the first or half of it, lies on the first one's front and folds over an edge of it.
 */
static uint32_t draw_folded_leaf(dmg_builder* b, uint32_t carrier, const leaf_style* s, int edge, float layer) {
    float t = s->thick, x = 0.5f * s->width, y = 0.5f * s->height, z = (layer + 0.5f) * t;
    const dmg_vec at[4] = {{x, 0, z}, {-x, 0, z}, {0, y, z}, {0, -y, z}},
                  axis[4] = {{0, 1, 0}, {0, -1, 0}, {-1, 0, 0}, {1, 0, 0}};
    uint32_t part = dmg_hinge(b, carrier, "panel", at[edge], axis[edge], 0.0f,
                              dmg_chance(b, 0.6f) ? DMG_PI : dmg_range(b, 1.4f, 3.1f));
    if (dmg_chance(b, 0.3f)) dmg_rest(b, part, dmg_range(b, 0, 1) * b->parts[part - 1].joint.upper);
    dmg_save(b);
    dmg_move(b, 0, 0, (layer + 1.0f) * t);
    draw_leaf(b, s);
    dmg_restore(b);
    return part;
}

/* Two stacks back to back on a foot, each falling open about its lower edge; leaves folded on their fronts. */
void dmg_build_solar_case(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.15f, 1.2f), height = width * dmg_range(b, 0.6f, 1.8f),
          t = width * dmg_range(b, 0.02f, 0.25f);
    leaf_style s = pick_leaf(b, width, height, t);
    if (s.kind == 1) s.kind = 4;
    int stacks = dmg_int(b, 1, 2), layers = dmg_int(b, 1, 2), edge = dmg_int(b, 0, 3);
    bool foot = dmg_chance(b, 0.6f), spread = dmg_chance(b, 0.4f);
    float low = 0.5f * t;
    if (foot) dmg_box(b, v3(0, 0.25f * low, 0), v3(0.9f * width, 0.5f * low, 2.2f * t));
    for (int side = 0; side < stacks; ++side) {
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), side ? DMG_PI : 0.0f);
        dmg_move(b, 0, low + 0.5f * height, 0.5f * t + 0.01f * t);
        uint32_t stack = 0;
        if (foot || side) {
            float z = foot ? 0.5f * t : -0.51f * t;
            stack = dmg_hinge(b, 0, "stack", v3(0, -0.5f * height, z), v3(1, 0, 0), 0.0f, dmg_range(b, 1.2f, 1.57f));
            if (spread) dmg_rest(b, stack, 1.2f);
        }
        dmg_use(b, stack);
        draw_leaf(b, &s);
        if (dmg_chance(b, 0.5f)) draw_case_handle(b, width, 0.5f * height, t);
        uint32_t carrier = stack;
        for (int i = 0; i < layers; ++i) {
            carrier = draw_folded_leaf(b, carrier, &s, (edge + (i % 2 ? 1 - 2 * (edge % 2) : 0)) % 4, (float)i);
            if (i > 0 || !dmg_chance(b, 0.2f)) continue;
            dmg_slide(b, stack, "button", v3(0, -1, 0), 0.0f, 0.05f * t);
            dmg_box(b, v3(0.3f * width, 0.5f * height + 0.07f * t, 0), v3(0.08f * width, 0.2f * t, 0.3f * t));
        }
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

/* ---- tables that follow the sun ---- */

static void draw_torque_tube(dmg_builder* b, float size, float high) {
    int tables = dmg_int(b, 1, 5);
    float width = size, height = size * dmg_range(b, 0.8f, 2.0f), pitch = 1.05f * width, length = pitch * (float)tables,
          swing = dmg_range(b, 0.4f, 1.1f), tube = size * dmg_range(b, 0.03f, 0.08f);
    leaf_style s = pick_leaf(b, width, height, size * dmg_range(b, 0.02f, 0.06f));
    float tilt = dmg_range(b, -0.5f, 0.5f), rise = tube * dmg_range(b, 0.5f, 2.0f);
    for (int i = 0; i <= tables; ++i)
        dmg_box(b, v3(((float)i / (float)tables - 0.5f) * length, 0.5f * high, 0), v3(tube, high, tube));
    dmg_move(b, 0, high, 0);
    uint32_t table = dmg_hinge(b, 0, "table", v3(0, 0, 0), v3(1, 0, 0), -swing, swing);
    if (dmg_chance(b, 0.8f)) dmg_rod(b, v3(-0.5f * length, 0, 0), v3(0.5f * length, 0, 0), 0.5f * tube);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI + tilt);
    for (int i = 0; i < tables; ++i) {
        dmg_save(b);
        dmg_move(b, ((float)i + 0.5f) * pitch - 0.5f * length, 0, rise + 0.5f * s.thick);
        draw_leaf(b, &s);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f)) dmg_beam(b, v3(0, 0, 0), v3(0, 0, -0.4f * high), tube, tube); /* the drive's lever */
    dmg_rest(b, table, 0.0f);
    dmg_use(b, 0);
}

void dmg_build_solar_tracker(dmg_builder* b) {
    float size = dmg_scale_range(b, 0.2f, 4.0f), high = size * dmg_range(b, 0.7f, 1.6f),
          post = size * dmg_range(b, 0.03f, 0.1f);
    if (dmg_chance(b, 0.35f)) {
        draw_torque_tube(b, size, high);
        return;
    }
    dmg_rod(b, v3(0, 0, 0), v3(0, high, 0), post);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0.03f * size, 0), v3(0.6f * size, 0.06f * size, 0.6f * size));
    dmg_move(b, 0, high, 0);
    uint32_t head = 0;
    if (dmg_chance(b, 0.75f)) {
        head = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "azimuth", v3(0, 0, 0), v3(0, 1, 0))
                                   : dmg_hinge(b, 0, "azimuth", v3(0, 0, 0), v3(0, 1, 0), -2.0f, 2.0f);
        dmg_rod(b, v3(0, -0.5f * post, 0), v3(0, 2 * post, 0), 1.3f * post);
    }
    int columns = dmg_int(b, 1, 4), rows = dmg_int(b, 1, 2);
    const float height = size * dmg_range(b, 0.5f, 1.0f), width = size * dmg_range(b, 0.5f, 1.0f);
    leaf_style s = pick_leaf(b, width, height, 0.04f * size);
    float back = post * dmg_range(b, 0.8f, 3.0f), tilt = dmg_range(b, 0.2f, 1.3f);
    dmg_move(b, 0, 2 * post, 0);
    if (head == 0 || dmg_chance(b, 0.85f)) {
        const float upper = fminf(1.5f - tilt, dmg_range(b, 0.2f, 1.2f)) + 0.1f,
                    lower = -fminf(tilt, dmg_range(b, 0.2f, 1.2f));
        dmg_hinge(b, head, "tilt", v3(0, 0, 0), v3(-1, 0, 0), lower, upper);
    }
    dmg_turn(b, v3(1, 0, 0), -tilt);
    dmg_beam(b, v3(-0.4f * s.width * (float)columns, 0, 0.5f * back),
             v3(0.4f * s.width * (float)columns, 0, 0.5f * back), back, 0.6f * back);
    for (int i = 0; i < columns * rows; ++i) {
        dmg_save(b);
        dmg_move(b, ((float)(i % columns) - 0.5f * (float)(columns - 1)) * 1.03f * s.width,
                 ((float)(i / columns) - 0.5f * (float)(rows - 1)) * 1.03f * s.height, back + 0.5f * s.thick);
        draw_leaf(b, &s);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
