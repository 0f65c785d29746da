/* Draws glass cases: vitrines, sliding panes, lids over a showcase. */
#include "core/build.h"
#include "parts/hardware.h"

/* A body of boards, its front at z = 0 on the floor or a plinth. */
typedef struct unit {
    float w, h, d, t;
    float base; /* height of its lower edge */
} unit;

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
