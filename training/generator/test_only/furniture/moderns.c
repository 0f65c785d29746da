/* Draws modern fronts without handles: larders that draw out with their shelves, lift-up and folding fronts, beds
 * over drawers, tippers, benches; and glass cases: vitrines, sliding panes, lids over a showcase. */
#include "core/build.h"
#include "parts/hardware.h"

/* A body of boards, its front at z = 0 on the floor or a plinth. */
typedef struct unit {
    float w, h, d, t;
    float gap;  /* between fronts */
    float base; /* height of its lower edge */
} unit;

static void draw_unit_body(dmg_builder* b, const unit* u) {
    dmg_save(b);
    dmg_move(b, 0, u->base + 0.5f * u->h, 0);
    dmg_case_draw(b, dmg_case_pick(b), u->w, u->h, u->d, u->t);
    dmg_restore(b);
    if (u->base > 0.0f && u->base < 0.2f)
        dmg_box_span(b, v3(-0.48f * u->w, 0, 0.05f * u->d - u->d), v3(0.48f * u->w, u->base, -0.1f * u->d));
}

/* Draws a slab between two heights and two sides; its upper edge may be cut for the fingers. */
static void draw_front(dmg_builder* b, const unit* u, float x0, float x1, float y0, float y1, int grip) {
    float lip = grip == 1 ? fminf(0.03f, 0.3f * (y1 - y0)) : 0.0f;
    dmg_box_span(b, v3(x0, y0, 0.05f * u->t), v3(x1, y1 - lip, u->t));
    if (grip == 1) dmg_box_span(b, v3(x0, y1 - lip, 0.5f * u->t), v3(x1, y1 - 0.3f * lip, u->t));
    if (grip == 2) /* a profile of metal hooked over the edge */
        dmg_box_span(b, v3(0.7f * x0 + 0.3f * x1, y1, 0.3f * u->t),
                     v3(0.3f * x0 + 0.7f * x1, y1 + 0.004f, 1.8f * u->t));
}

static void draw_box_behind(dmg_builder* b, const unit* u, float x0, float x1, float y0, float high, float deep) {
    dmg_save(b);
    dmg_move(b, 0.5f * (x0 + x1), y0, 0.04f * u->t);
    dmg_tray_draw(b, dmg_chance(b, 0.75f) ? DMG_TRAY_BOARDS : DMG_TRAY_WIRE, x1 - x0, high, deep, 0.6f * u->t);
    dmg_restore(b);
}

/* Draws a tall front that takes several shelves out with it, or a narrow one for bottles. */
static void draw_larder(dmg_builder* b, unit* u) {
    int columns = dmg_int(b, 1, 3), shelves = dmg_int(b, 2, 5), grip = dmg_int(b, 0, 2);
    float deep = 0.92f * u->d, way = deep * dmg_range(b, 0.7f, 0.95f), high = dmg_range(b, 0.06f, 0.14f);
    draw_unit_body(b, u);
    for (int c = 0; c < columns; ++c) {
        float each = u->w / (float)columns, x0 = each * (float)c - 0.5f * u->w + u->gap, x1 = x0 + each - 2 * u->gap;
        dmg_slide(b, 0, "larder", v3(0, 0, 1), 0.0f, way);
        draw_front(b, u, x0, x1, u->base, u->base + u->h, grip);
        float in0 = fmaxf(x0, u->t - 0.5f * u->w) + 0.01f, in1 = fminf(x1, 0.5f * u->w - u->t) - 0.01f;
        for (int i = 0; i < shelves; ++i)
            draw_box_behind(b, u, in0, in1, u->base + 1.3f * u->t + (u->h - 2 * u->t) * (float)i / (float)shelves, high,
                            deep - u->t);
        dmg_use(b, 0);
    }
}

/* Draws a wall unit whose front swings up about its upper edge, folds in two, or goes up in front of the wall. */
static void draw_lift_front(dmg_builder* b, unit* u) {
    int rows = dmg_int(b, 1, 2), kind = dmg_int(b, 0, 2), grip = dmg_int(b, 0, 1);
    float swing = dmg_range(b, 1.2f, 1.9f), x = 0.5f * u->w - u->gap;
    u->base = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.02f, 0.1f);
    u->h = (float)rows * dmg_range(b, 0.3f, 0.45f);
    draw_unit_body(b, u);
    for (int i = 0; i < rows; ++i) {
        float each = u->h / (float)rows, y0 = u->base + each * (float)i + u->gap, y1 = y0 + each - 2 * u->gap,
              mid = 0.5f * (y0 + y1);
        bool top = i == rows - 1;
        if (kind == 1 && top) { /* straight up */
            dmg_slide(b, 0, "lift_front", v3(0, 1, 0), 0.0f, 0.9f * each);
            draw_front(b, u, -x, x, y0, y1, 0);
        } else if (kind == 2 && top) {
            uint32_t upper = dmg_hinge(b, 0, "upper_front", v3(0, y1, 0.05f * u->t), v3(-1, 0, 0), 0.0f, swing);
            draw_front(b, u, -x, x, mid + 0.5f * u->gap, y1, 0);
            dmg_hinge(b, upper, "lower_front", v3(0, mid, u->t), v3(1, 0, 0), 0.0f, fminf(2.7f, 1.8f * swing));
            draw_front(b, u, -x, x, y0, mid - 0.5f * u->gap, 0);
        } else {
            bool falls = !top || grip == 1;
            dmg_hinge(b, 0, "flap", v3(0, falls ? y0 : y1, falls ? u->t : 0.05f * u->t), v3(falls ? 1.0f : -1.0f, 0, 0),
                      0.0f, falls ? 1.5f : swing);
            draw_front(b, u, -x, x, y0, y1, falls ? 1 : 0);
        }
        dmg_use(b, 0);
    }
}

/* Drawers, tippers and doors in columns under one thin top. */
static void draw_bench(dmg_builder* b, unit* u) {
    int columns = dmg_int(b, 1, 4), grip = dmg_int(b, 0, 2), rows = u->h > 0.6f ? dmg_int(b, 2, 4) : dmg_int(b, 1, 2);
    bool tip = dmg_chance(b, 0.4f), same = dmg_chance(b, 0.5f);
    int first = dmg_int(b, 0, 2);
    draw_unit_body(b, u);
    for (int c = 0; c < columns; ++c) {
        int kind = same ? first : dmg_int(b, 0, 2), here = kind == 2 ? 1 : rows;
        float cell = u->w / (float)columns, x0 = cell * (float)c - 0.5f * u->w + u->gap, x1 = x0 + cell - 2 * u->gap,
              side = dmg_sign(b), each = u->h / (float)here;
        for (int r = 0; r < here; ++r) {
            float y0 = u->base + each * (float)r + u->gap, y1 = y0 + each - 2 * u->gap;
            if (kind == 2)
                dmg_hinge(b, 0, "door", v3(side < 0 ? x0 : x1, 0, 0.05f * u->t), v3(0, side, 0), 0.0f, 1.7f);
            else if (kind == 1 && tip)
                dmg_hinge(b, 0, "tipper", v3(0, y0, u->t), v3(1, 0, 0), 0.0f, 0.7f);
            else
                dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, 0.7f * u->d);
            draw_front(b, u, x0, x1, y0, y1, kind == 2 ? 0 : grip);
            float in0 = fmaxf(x0, u->t - 0.5f * u->w) + 0.006f, in1 = fminf(x1, 0.5f * u->w - u->t) - 0.006f;
            if (kind == 1 && tip)
                draw_box_behind(b, u, in0, in1, y0 + u->t, 0.4f * (y1 - y0), 0.35f * u->d);
            else if (kind != 2)
                draw_box_behind(b, u, in0, in1, y0 + 1.1f * u->t, 0.6f * (y1 - y0) - u->t, 0.85f * u->d);
            dmg_use(b, 0);
        }
    }
    if (dmg_chance(b, 0.6f)) { /* the top lies over the fronts */
        float out = dmg_range(b, 0.3f, 2.0f) * u->t, y = u->base + u->h;
        dmg_box_span(b, v3(-0.5f * u->w - 0.3f * out, y, -u->d), v3(0.5f * u->w + 0.3f * out, y + u->t, u->t + out));
    }
}

/* Draws a bed: drawers in its frame, the slatted base rising on its hinges at the head. */
static void draw_bed(dmg_builder* b, unit* u) {
    float wide = dmg_range(b, 0.8f, 1.8f), length = dmg_range(b, 1.9f, 2.1f), high = dmg_range(b, 0.25f, 0.4f),
          t = 0.02f, head = high + dmg_range(b, 0.2f, 0.8f), thick = dmg_range(b, 0.12f, 0.25f);
    bool lifts = dmg_chance(b, 0.6f);
    int drawers = dmg_int(b, lifts ? 0 : 1, 3);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), dmg_chance(b, 0.5f) ? 0.0f : 0.5f * DMG_PI);
    float z = 0.5f * wide, x = 0.5f * length;
    dmg_box_span(b, v3(-x, 0, -z), v3(x, high, t - z));
    dmg_box_span(b, v3(x - t, 0, t - z), v3(x, high, z));
    dmg_box_span(b, v3(-x - 3 * t, 0, -z), v3(-x, head, z));
    dmg_box_span(b, v3(-x, high - 2 * t, z - t), v3(x - t, high, z));
    dmg_box_span(b, v3(-x, 0, -z), v3(x - t, t, z - t));
    if (!drawers) dmg_box_span(b, v3(-x, 0, z - t), v3(x - t, high - 2.2f * t, z));
    for (int i = 0; i < drawers; ++i) {
        float each = (2 * x - t) / (float)drawers, x0 = each * (float)i - x + 0.004f, x1 = x0 + each - 0.008f;
        dmg_slide(b, 0, "bed_drawer", v3(0, 0, 1), 0.0f, 0.35f * wide);
        dmg_box_span(b, v3(x0, 0.01f, z + 0.001f), v3(x1, high - 2.3f * t, z + t));
        dmg_save(b);
        dmg_move(b, 0, 0, z);
        draw_box_behind(b, u, x0 + t, x1 - t, 1.2f * t, 0.55f * high - t, 0.45f * wide);
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (lifts) dmg_hinge(b, 0, "bed_base", v3(-x, high, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 0.5f, 1.0f));
    dmg_box_span(b, v3(-0.99f * x, high + 0.002f, -0.98f * z), v3(0.98f * x, high + t, 0.98f * z));
    dmg_rounded_box(b, v3(0, high + t + 0.5f * thick, 0), v3(1.94f * x, thick, 1.94f * z), 0.3f * thick);
    dmg_restore(b);
}

void dmg_build_modern_unit(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){2, 2, 3, 1}, 4);
    unit u = {.w = dmg_scale_range(b, 0.4f, 1.8f)};
    u.d = dmg_range(b, 0.3f, 0.6f);
    u.t = dmg_range(b, 0.016f, 0.025f);
    u.h = kind == 0 ? dmg_range(b, 0.7f, 2.1f) : dmg_range(b, 0.3f, 1.1f);
    u.gap = dmg_range(b, 0.001f, 0.006f);
    u.base = dmg_chance(b, 0.3f) ? 0.0f : dmg_range(b, 0.04f, 0.15f);
    if (kind == 0) u.w = fminf(u.w, 0.9f);
    if (kind == 0) draw_larder(b, &u);
    if (kind == 1) draw_lift_front(b, &u);
    if (kind == 2) draw_bench(b, &u);
    if (kind == 3) draw_bed(b, &u);
}

/* ---- cases of glass ---- */

/* Draws a leaf of bare glass on pins near its corners: side -1 is hung at its left. The frame is at its lower middle.
 */
static void draw_glass_leaf(dmg_builder* b, float w, float h, float t, float side, int hold) {
    float x = 0.5f * w, pin = fminf(0.03f, 0.08f * w), tall = fminf(0.03f, 0.05f * h);
    dmg_save(b);
    if (side > 0) dmg_mirror(b, v3(1, 0, 0));
    dmg_hinge(b, 0, "glass_door", v3(pin - x, 0, -0.5f * t), v3(0, -1, 0), 0.0f, 1.7f);
    dmg_box_span(b, v3(-x, 0, -t), v3(x, h, 0));
    if (hold == 0) /* shoes clamped on the corners */
        for (int i = 0; i < 2; ++i) {
            float y = i ? h - tall : 0.0f;
            dmg_box_span(b, v3(-x, y, -1.5f * t), v3(2 * pin - x, y + tall, 0.5f * t));
        }
    if (hold == 1) dmg_rod(b, v3(0.85f * x, 0.5f * h, 0), v3(0.85f * x, 0.5f * h, 3 * t), 1.5f * t);
    if (hold == 2) { /* a bar and a rail below */
        dmg_rod(b, v3(0.88f * x, 0.35f * h, 3 * t), v3(0.88f * x, 0.65f * h, 3 * t), t);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(0.88f * x, (0.5f + 0.12f * (float)s) * h, 0),
                    v3(0.88f * x, (0.5f + 0.12f * (float)s) * h, 3 * t), 0.6f * t);
    }
    if (hold == 3) dmg_box_span(b, v3(x - pin, 0.45f * h, 0), v3(x, 0.52f * h, 0.6f * t));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Posts, floor, ceiling, panes and shelves of an upright case; its front stays open for doors. */
static void draw_vitrine(dmg_builder* b, const unit* u, float post, int shelves, bool solid_back) {
    float x = 0.5f * u->w, y1 = u->base + u->h, t = 0.3f * u->t;
    dmg_box_span(b, v3(-x, u->base, -u->d), v3(x, u->base + u->t, 0));
    dmg_box_span(b, v3(-x, y1 - u->t, -u->d), v3(x, y1, 0));
    for (int i = 0; i < 4 && post > 0.0f; ++i) {
        float px = i & 1 ? x - 0.5f * post : 0.5f * post - x, pz = i & 2 ? -0.5f * post : 0.5f * post - u->d;
        dmg_box(b, v3(px, u->base + 0.5f * u->h, pz), v3(post, u->h - 2 * u->t, post));
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * (x - 0.5f * t), u->base + 0.5f * u->h, -0.5f * u->d),
                v3(t, u->h - 2 * u->t, u->d - 2 * post));
    dmg_box_span(b, v3(post - x, u->base + u->t, -u->d), v3(x - post, y1 - u->t, (solid_back ? u->t : t) - u->d));
    for (int i = 1; i <= shelves; ++i) {
        float y = u->base + u->h * (float)i / (float)(shelves + 1);
        dmg_box_span(b, v3(1.1f * t - x, y, u->t - u->d), v3(x - 1.1f * t, y + t, -0.12f * u->d));
    }
}

static void draw_upright_case(dmg_builder* b, unit* u, bool slides) {
    float post = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.015f, 0.04f), glass = dmg_range(b, 0.004f, 0.008f);
    int shelves = dmg_int(b, 1, 5), hold = dmg_int(b, 0, 3), leaves = u->w > 0.7f || slides ? 2 : 1;
    bool back = dmg_chance(b, 0.4f), between = dmg_chance(b, 0.6f), drawer = u->base > 0.15f;
    float side = dmg_sign(b), low = u->base + (between ? u->t : 0.0f) + 0.002f,
          h = u->h - (between ? 2 * u->t : 0.0f) - 0.004f, wide = u->w - 2 * post - 0.004f, each = wide / (float)leaves;
    draw_vitrine(b, u, post, shelves, back);
    for (int i = 0; i < leaves; ++i) {
        dmg_save(b);
        dmg_move(b, each * ((float)i + 0.5f) - 0.5f * wide, low, between ? -0.001f : glass + 0.001f);
        if (slides) {
            dmg_move(b, (i ? -0.02f : 0.02f) * each, 0, between ? (float)i * -2.5f * glass : (float)i * 1.5f * glass);
            dmg_slide(b, 0, "sliding_pane", v3(i ? -1.0f : 1.0f, 0, 0), 0.0f, 0.85f * each);
            dmg_box_span(b, v3(-0.52f * each, 0, -glass), v3(0.52f * each, h, 0));
            dmg_rod(b, v3(i ? 0.4f * each : -0.4f * each, 0.5f * h, -0.2f * glass),
                    v3(i ? 0.4f * each : -0.4f * each, 0.5f * h, 0.4f * glass), 0.02f);
            dmg_use(b, 0);
        } else
            draw_glass_leaf(b, each - 0.003f, h, glass, leaves == 1 ? side : (i ? 1.0f : -1.0f), hold);
        dmg_restore(b);
    }
    float x = 0.5f * u->w;
    if (!drawer) return;
    dmg_box_span(b, v3(-x, 0, -u->d), v3(x, u->base, -0.003f));
    dmg_slide(b, 0, "drawer", v3(0, 0, 1), 0.0f, 0.6f * u->d);
    dmg_box_span(b, v3(0.03f - x, 0.2f * u->base, -0.8f * u->d), v3(x - 0.03f, 0.8f * u->base, 0));
    dmg_box_span(b, v3(0.01f - x, 0.1f * u->base, 0), v3(x - 0.01f, 0.97f * u->base, u->t));
    dmg_use(b, 0);
}

/* Draws a low case or a tank on legs or a cupboard; the top is a lid of glass, whole or in two, or a hood. */
static void draw_top_case(dmg_builder* b, unit* u) {
    float high = dmg_range(b, 0.12f, 0.5f), y = dmg_range(b, 0.5f, 0.9f), x = 0.5f * u->w, t = 0.012f,
          slope = dmg_chance(b, 0.4f) ? dmg_range(b, 0.1f, 0.35f) : 0.0f;
    bool cupboard = dmg_chance(b, 0.5f), hood = slope == 0.0f && dmg_chance(b, 0.4f);
    float front = high - u->d * tanf(slope), swing = dmg_range(b, 0.7f, 1.4f);
    if (front < 0.04f) slope = 0.0f, front = high;
    dmg_box_span(b, v3(-x, y - 0.02f, -u->d), v3(x, y, 0));
    dmg_box_span(b, v3(-x, y, -u->d), v3(x, y + high, t - u->d));
    dmg_box_span(b, v3(-x, y, -t), v3(x, y + front, 0));
    for (int s = -1; s <= 1; s += 2) {
        const dmg_xy pane[] = {{0, y}, {u->d, y}, {u->d, y + high}, {0, y + front}}; /* x runs backwards */
        dmg_save(b);
        dmg_move(b, (float)s * (x - 0.5f * t), 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_extrude(b, pane, 4, -0.5f * t, 0.5f * t);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, y + high + 0.001f, -u->d);
    dmg_turn(b, v3(1, 0, 0), slope);
    float long_way = u->d / cosf(slope);
    dmg_hinge(b, 0, hood ? "hood" : "lid", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, swing);
    dmg_box_span(b, v3(-x, 0, 0), v3(x, t, long_way));
    if (hood) dmg_box_span(b, v3(-x, t, 0.02f), v3(x, 0.08f, long_way - 0.01f));
    if (!hood) dmg_box_span(b, v3(-0.2f * x, t, 0.9f * long_way), v3(0.2f * x, 2 * t, 0.95f * long_way));
    dmg_restore(b);
    dmg_use(b, 0);
    if (!cupboard) {
        dmg_save(b);
        dmg_move(b, 0, 0, -0.5f * u->d);
        dmg_feet_draw(b, dmg_chance(b, 0.5f) ? 0 : 3, u->w, u->d, y - 0.02f);
        dmg_restore(b);
        return;
    }
    dmg_box_span(b, v3(-x, 0, -u->d), v3(x, y - 0.02f, -0.002f));
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_hinge(b, 0, "door", v3(side * 0.98f * x, 0, 0), v3(0, side, 0), 0.0f, 1.6f);
        dmg_box_span(b, v3(fminf(side * 0.98f * x, side * 0.01f * x), 0.05f, 0),
                     v3(fmaxf(side * 0.98f * x, side * 0.01f * x), y - 0.03f, u->t));
        dmg_use(b, 0);
    }
}

void dmg_build_glass_case(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 1.2f, 2}, 3);
    unit u = {.w = dmg_scale_range(b, 0.35f, 1.3f)};
    u.d = dmg_range(b, 0.25f, 0.5f);
    u.t = dmg_range(b, 0.015f, 0.04f);
    u.h = dmg_scale_range(b, 0.4f, 1.8f);
    u.base = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.08f, 0.3f);
    if (kind == 2) {
        draw_top_case(b, &u);
        return;
    }
    if (u.base > 0.0f && u.base <= 0.15f)
        dmg_box_span(b, v3(-0.46f * u.w, 0, 0.04f * u.d - u.d), v3(0.46f * u.w, u.base, -0.06f * u.d));
    draw_upright_case(b, &u, kind == 1);
}
