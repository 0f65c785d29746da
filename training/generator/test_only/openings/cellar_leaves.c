/* Draws leaves of cellars, stables and saloons without a frame: pairs built of boards on ledges, of slats or of bars,
 * hung at their outer edges by straps, pins or nothing that shows. */
#include "core/build.h"

/* What a leaf is built of. */
enum { BOARDS, SLATS, BARS, PLATE, BUILDS };

typedef struct shutter {
    float w, h, t; /* of a leaf */
    float line;    /* of the hinge's axis in front of the leaf's middle plane, in thicknesses; ± 0.5: a face */
    float beyond;  /* of the axis outside the hung edge, in thicknesses */
    int build, rows;
    bool straps, rings, swings; /* swings: both ways, as a saloon's */
} shutter;

static shutter pick_shutter(dmg_builder* b) {
    shutter s = {.w = dmg_scale_range(b, 0.35f, 1.8f)};
    s.h = s.w * dmg_scale_range(b, 0.8f, 3.0f);
    s.t = s.w * dmg_scale_range(b, 0.03f, 0.14f);
    s.build = dmg_int(b, 0, BUILDS - 1);
    s.rows = dmg_int(b, 3, 8);
    s.straps = dmg_chance(b, 0.5f);
    s.rings = dmg_chance(b, 0.5f);
    s.swings = dmg_chance(b, 0.25f);
    s.line = 0.5f * (float)dmg_int(b, -1, 1);
    s.beyond = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -1.0f, 0.3f);
    return s;
}

/* Draws the leaf between x = 0, where it hangs, and x = w, about the plane z = 0. */
static void draw_build(dmg_builder* b, const shutter* s) {
    float w = s->w, h = s->h, t = s->t, ledge = 0.08f * h;
    switch (s->build) {
    case BOARDS:
        for (int i = 0; i < s->rows; ++i) {
            float wide = w / (float)s->rows, end = 0.01f * h * dmg_unit(b);
            dmg_box(b, v3(wide * ((float)i + 0.5f), end, 0), v3(0.97f * wide, h, t));
        }
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3(0.5f * w, 0.32f * h * (float)i, -0.8f * t), v3(0.94f * w, ledge, 0.6f * t));
        break;
    case SLATS:
        for (int i = 0; i < 2; ++i) dmg_box(b, v3(i ? 0.94f * w : 0.06f * w, 0, 0), v3(0.12f * w, h, t));
        for (int i = 0; i < 2 * s->rows; ++i) {
            float y = h * (((float)i + 0.5f) / (2.0f * (float)s->rows) - 0.5f);
            dmg_box(b, v3(0.5f * w, y, 0), v3(0.8f * w, 0.3f * h / (float)s->rows, 0.4f * t));
        }
        break;
    case BARS:
        for (int i = 0; i < s->rows; ++i) {
            float x = w * ((float)i + 0.5f) / (float)s->rows, top = h * dmg_range(b, 0.48f, 0.56f);
            dmg_rod(b, v3(x, -0.5f * h, 0), v3(x, top, 0), 0.45f * t);
        }
        for (int i = -1; i <= 1; ++i) dmg_box(b, v3(0.5f * w, 0.4f * h * (float)i, 0), v3(w, 0.5f * ledge, 0.9f * t));
        break;
    default:
        dmg_box(b, v3(0.5f * w, 0, 0), v3(w, h, t));
        break;
    }
}

static void draw_fittings(dmg_builder* b, const shutter* s) {
    float w = s->w, h = s->h, t = s->t;
    for (int i = -1; i <= 1 && s->straps; i += 2) {
        float y = 0.32f * h * (float)i;
        dmg_box(b, v3(0.35f * w - s->beyond * t, y, 0.6f * t), v3(0.7f * w, 0.05f * h, 0.25f * t));
        dmg_rod(b, v3(-s->beyond * t, y - 0.04f * h, s->line * t), v3(-s->beyond * t, y + 0.04f * h, s->line * t),
                0.35f * t);
    }
    if (s->rings) dmg_torus(b, v3(0.85f * w, 0, 0.7f * t), v3(0, 0, 1), 0.06f * w, 0.012f * w);
}

static void draw_hung_leaf(dmg_builder* b, const shutter* s) {
    float most = dmg_range(b, 1.3f, 2.4f);
    dmg_hinge(b, 0, "leaf", v3(-s->beyond * s->t, 0, s->line * s->t), v3(0, -1, 0), s->swings ? -most : 0.0f, most);
    draw_build(b, s);
    draw_fittings(b, s);
}

void dmg_build_cellar_leaves(dmg_builder* b) {
    shutter s = pick_shutter(b);
    float gap = dmg_chance(b, 0.5f) ? 0.0f : s.w * dmg_range(b, 0.0f, 0.03f);
    dmg_move(b, 0, 0.5f * s.h, 0);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(1, 0, 0), dmg_sign(b) * 0.5f * DMG_PI); /* over a cellar */
    for (int side = -1; side <= 1; side += 2) {
        dmg_save(b);
        if (side < 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -s.w - 0.5f * gap, 0, 0);
        draw_hung_leaf(b, &s);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
