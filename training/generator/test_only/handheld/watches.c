/* Draws watches on straps, on bracelets and in pockets. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- a watch: the dial faces +Z at z = 0, twelve is up ---- */

typedef struct watch {
    float r, deep, t; /* of the case: radius, depth behind the dial; a unit for small things */
    bool square;
} watch;

static void draw_hands(dmg_builder* b, const watch* w) {
    static const char* const names[] = {"hour_hand", "minute_hand", "second_hand"};
    static const float lengths[] = {0.5f, 0.75f, 0.8f}, widths[] = {0.08f, 0.06f, 0.025f};
    int count = dmg_int(b, 0, 1) ? 3 : 2, kind = dmg_int(b, 0, 1);
    for (int i = 0; i < count; ++i) {
        float z = 0.12f * w->t * (float)(i + 1), length = lengths[i] * w->r, wide = widths[i] * w->r,
              turn = 2 * DMG_PI * dmg_unit(b);
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), turn);
        dmg_spin(b, 0, names[i], v3(0, 0, 0), v3(0, 0, -1));
        dmg_rod(b, v3(0, 0, z - 0.05f * w->t), v3(0, 0, z + 0.06f * w->t), 0.07f * w->r - 0.01f * w->r * (float)i);
        const dmg_xy leaf[] = {{0, -0.15f * length}, {wide, 0.3f * length}, {0, length}, {-wide, 0.3f * length}};
        if (kind)
            dmg_extrude(b, leaf, 4, z - 0.04f * w->t, z + 0.04f * w->t);
        else
            dmg_box_span(b, v3(-0.5f * wide, -0.15f * length, z - 0.04f * w->t),
                         v3(0.5f * wide, length, z + 0.04f * w->t));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_watch_case(dmg_builder* b, const watch* w) {
    float rim = 0.55f * w->t;
    bool bezel = !w->square && dmg_chance(b, 0.6f);
    if (w->square) {
        dmg_rounded_box(b, v3(0, 0, -0.5f * w->deep), v3(2 * w->r, 2 * w->r, w->deep), 0.2f * w->deep);
        dmg_frame_draw(b, 2 * w->r, 2 * w->r, -rim, 0.1f * w->r);
    } else {
        const dmg_xy profile[] = {{0, -w->deep}, {0.85f * w->r, -w->deep}, {w->r, -0.7f * w->deep}, {w->r, 0}, {0, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, 5);
    }
    for (int i = 0; i < 12; ++i) { /* the hours */
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 12);
        dmg_box(b, v3(0, 0.78f * w->r, 0), v3(0.04f * w->r, 0.1f * w->r, 0.1f * w->t));
        dmg_restore(b);
    }
    if (w->square) return;
    const dmg_xy ring[] = {{0.87f * w->r, 0.01f * w->t},
                           {1.04f * w->r, 0.01f * w->t},
                           {1.04f * w->r, 0.5f * rim},
                           {0.9f * w->r, rim},
                           {0.87f * w->r, 0.01f * w->t}};
    int teeth = bezel ? dmg_int(b, 8, 20) : 0;
    if (bezel) dmg_spin(b, 0, "bezel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    for (int i = 0; i < teeth; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, teeth);
        dmg_box(b, v3(1.03f * w->r, 0, 0.3f * rim), v3(0.05f * w->r, 0.06f * w->r, 0.35f * rim));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* On the edge at +X: a stem that pulls out, on it a head that turns; pushers beside it. */
static void draw_crown(dmg_builder* b, const watch* w, int pushers) {
    float z = -0.45f * w->deep, r = fminf(0.32f * w->deep, 0.13f * w->r), x = w->r, way = 0.5f * r;
    uint32_t stem = dmg_slide(b, 0, "crown_stem", v3(1, 0, 0), 0.0f, way);
    dmg_rod(b, v3(x - way - 0.1f * r, 0, z), v3(x + 0.5f * r, 0, z), 0.45f * r);
    dmg_spin(b, stem, "crown", v3(x, 0, z), v3(1, 0, 0));
    dmg_save(b);
    dmg_move(b, x + 0.3f * r, 0, z);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_wheel_draw(b, dmg_chance(b, 0.6f) ? 4 : 5, r, 0.6f * r, 7);
    dmg_restore(b);
    for (int i = 0; i < pushers; ++i) {
        float angle = i ? -0.55f : 0.55f;
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), angle);
        dmg_slide(b, 0, "pusher", v3(-1, 0, 0), 0.0f, 0.4f * r);
        dmg_rod(b, v3(x - 0.2f * r, 0, z), v3(x + 0.7f * r, 0, z), 0.3f * r);
        dmg_rod(b, v3(x + 0.4f * r, 0, z), v3(x + 0.9f * r, 0, z), 0.6f * r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a half of the strap from the lugs at +Y: one piece, or links that each bend; returns the last part. */
static uint32_t draw_strap(dmg_builder* b, const watch* w, int links, float length, float wide, float* end) {
    float z = -0.55f * w->deep, t = 0.5f * w->t, y = w->r + 0.9f * t, each = length / (float)links,
          bend = links > 1 ? 0.7f : 1.5f;
    for (int i = -1; i <= 1; i += 2) {
        dmg_use(b, 0);
        dmg_box_span(b, v3((float)i * 0.56f * wide - 0.05f * wide, 0.7f * w->r, z - t),
                     v3((float)i * 0.56f * wide + 0.05f * wide, y + 0.8f * t, z + t));
    }
    uint32_t last = 0;
    for (int i = 0; i < links; ++i) {
        float from = y + each * (float)i;
        last = dmg_hinge(b, last, links > 1 ? "link" : "strap", v3(0, from, z), v3(-1, 0, 0), -0.1f, bend);
        dmg_rod(b, v3(-0.49f * wide, from, z), v3(0.49f * wide, from, z), 0.5f * t);
        dmg_box_span(b, v3(-0.48f * wide, from + 0.1f * t, z - 0.4f * t),
                     v3(0.48f * wide, from + each - (links > 1 ? 0.55f * t : 0.0f), z + 0.4f * t));
        if (links > 1)
            dmg_box_span(b, v3(-0.2f * wide, from + 0.5f * each, z - 0.3f * t),
                         v3(0.2f * wide, from + each - 0.4f * t, z + 0.3f * t));
    }
    *end = y + length;
    return last;
}

/* Draws a frame and a tongue on one bar at the strap's end. */
static void draw_buckle(dmg_builder* b, const watch* w, uint32_t strap, float y, float wide) {
    float z = -0.55f * w->deep, t = 0.5f * w->t, out = 0.4f * wide;
    dmg_hinge(b, strap, "buckle", v3(0, y + 0.5f * t, z), v3(1, 0, 0), -0.6f, 1.5f);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * 0.56f * wide - 0.04f * wide, y, z - 0.4f * t),
                     v3((float)i * 0.56f * wide + 0.04f * wide, y + out, z + 0.4f * t));
    dmg_box_span(b, v3(-0.6f * wide, y + out, z - 0.4f * t), v3(0.6f * wide, y + out + t, z + 0.4f * t));
    dmg_rod(b, v3(-0.56f * wide, y + 0.5f * t, z), v3(0.56f * wide, y + 0.5f * t, z), 0.3f * t);
    dmg_hinge(b, strap, "tongue", v3(0, y + 0.5f * t, z), v3(1, 0, 0), 0.0f, 1.7f);
    dmg_box_span(b, v3(-0.05f * wide, y + 0.2f * t, z + 0.45f * t),
                 v3(0.05f * wide, y + out + 0.8f * t, z + 0.75f * t));
    dmg_rod(b, v3(-0.06f * wide, y + 0.5f * t, z), v3(0.06f * wide, y + 0.5f * t, z), 0.7f * t);
    dmg_use(b, 0);
}

/* Draws two leaves of bent sheet that fold on each other behind the bracelet's end. */
static void draw_folding_clasp(dmg_builder* b, const watch* w, uint32_t strap, float y, float wide) {
    float z = -0.55f * w->deep, t = 0.5f * w->t, reach = wide * dmg_range(b, 0.8f, 1.2f);
    uint32_t leaf = dmg_hinge(b, strap, "clasp", v3(0, y + 0.5f * t, z), v3(1, 0, 0), 0.0f, 2.8f);
    dmg_rod(b, v3(-0.45f * wide, y + 0.5f * t, z), v3(0.45f * wide, y + 0.5f * t, z), 0.4f * t);
    dmg_box_span(b, v3(-0.4f * wide, y + 0.3f * t, z - 0.25f * t), v3(0.4f * wide, y + reach, z + 0.25f * t));
    dmg_hinge(b, leaf, "clasp_leaf", v3(0, y + reach + 0.5f * t, z), v3(-1, 0, 0), 0.0f, 2.8f);
    dmg_rod(b, v3(-0.45f * wide, y + reach + 0.5f * t, z), v3(0.45f * wide, y + reach + 0.5f * t, z), 0.4f * t);
    dmg_box_span(b, v3(-0.5f * wide, y + reach + 0.8f * t, z - 0.3f * t), v3(0.5f * wide, y + 2 * reach, z + 0.3f * t));
    dmg_use(b, 0);
}

/* Lids on a hinge at the left, a bow that tips over the crown above. */
static void draw_pocket_watch(dmg_builder* b, const watch* w) {
    float r = 0.18f * w->r, swing = dmg_range(b, 1.2f, 2.2f), t = 0.4f * w->t;
    bool front = dmg_chance(b, 0.7f), back = dmg_chance(b, 0.4f);
    dmg_rod(b, v3(0, 0.9f * w->r, -0.5f * w->deep), v3(0, w->r + 1.2f * r, -0.5f * w->deep), 0.5f * r);
    dmg_spin(b, 0, "crown", v3(0, 0, -0.5f * w->deep), v3(0, 1, 0));
    dmg_rod(b, v3(0, w->r + 1.2f * r, -0.5f * w->deep), v3(0, w->r + 2.1f * r, -0.5f * w->deep), 0.9f * r);
    dmg_hinge(b, 0, "bow", v3(0, w->r + 0.6f * r, -0.5f * w->deep), v3(1, 0, 0), -1.5f, 1.5f);
    dmg_torus(b, v3(0, w->r + 2.0f * r, -0.5f * w->deep), v3(0, 0, 1), 1.7f * r, 0.25f * r);
    for (int i = 0; i < 2; ++i) {
        if (!(i ? back : front)) continue;
        float z = i ? -w->deep - 0.1f * t : 0.75f * w->t, side = i ? -1.0f : 1.0f;
        dmg_use(b, 0);
        dmg_box_span(b, v3(-1.1f * w->r, -1.5f * t, i ? z - t : -0.5f * w->deep),
                     v3(-0.97f * w->r, 1.5f * t, i ? -0.5f * w->deep : z));
        dmg_hinge(b, 0, i ? "back_lid" : "lid", v3(-1.06f * w->r, 0, z), v3(0, -side, 0), 0.0f, swing);
        dmg_cone(b, v3(0, 0, z + side * 0.1f * t), v3(0, 0, z + side * 1.6f * t), w->r, 0.8f * w->r);
        dmg_box(b, v3(-0.98f * w->r, 0, z + side * 0.3f * t), v3(0.16f * w->r, 6 * t, 0.4f * t));
    }
    dmg_use(b, 0);
}

void dmg_build_wrist_watch(dmg_builder* b) {
    watch w = {.r = dmg_range(b, 0.014f, 0.026f)};
    w.deep = w.r * dmg_range(b, 0.3f, 0.65f);
    w.t = w.r * dmg_range(b, 0.16f, 0.26f);
    int kind = dmg_weighted(b, (const float[]){4, 3, 3}, 3), pushers = dmg_int(b, 0, 2);
    w.square = kind < 2 && dmg_chance(b, 0.25f);
    bool lies = dmg_chance(b, 0.6f), steel = kind == 1;
    float length = w.r * dmg_range(b, 2.2f, 3.6f), wide = w.r * dmg_range(b, 0.9f, 1.4f), end = 0;
    int links = steel ? dmg_int(b, 3, 6) : 1;
    float below = kind == 2 ? w.r : 2 * w.r + length + 2.5f * wide;
    dmg_move(b, 0, lies ? w.deep + 2 * w.t : below, 0);
    if (lies) dmg_face_up(b);
    draw_watch_case(b, &w);
    draw_hands(b, &w);
    if (kind == 2) {
        draw_pocket_watch(b, &w);
        return;
    }
    draw_crown(b, &w, pushers);
    uint32_t upper = draw_strap(b, &w, links, length, wide, &end);
    if (steel)
        draw_folding_clasp(b, &w, upper, end, wide);
    else
        draw_buckle(b, &w, upper, end, wide);
    dmg_save(b);
    dmg_mirror(b, v3(0, 1, 0));
    draw_strap(b, &w, links, (steel ? 1.0f : 1.4f) * length, wide, &end);
    dmg_restore(b);
    dmg_use(b, 0);
}
