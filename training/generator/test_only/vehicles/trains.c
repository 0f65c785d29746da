/* Draws locomotives: steam engines with the doors and flaps of boiler, cab and tender; diesels with doors, fans,
 * hatches. */
#include "core/build.h"
#include "parts/rails.h"
#include "parts/shop.h"
#include "parts/walls.h"
#include "parts/works.h"

/* ---- steam ---- */

typedef struct steamer {
    float deck, br, by; /* running board; boiler: radius, height of its middle */
    float zc, zf, cab;  /* ends of the boiler, length of the cab behind it */
    float half, roof;
} steamer;

static void draw_smokebox_door(dmg_builder* b, const steamer* s) {
    float r = s->br * dmg_range(b, 0.65f, 0.92f), t = s->br * dmg_range(b, 0.06f, 0.14f),
          swing = dmg_range(b, 1.2f, 2.4f), dish = r * dmg_range(b, 0.0f, 0.3f), dir = dmg_sign(b);
    int straps = dmg_int(b, 0, 2), dart = dmg_int(b, 0, 2);
    dmg_wall_enter(b, v3(0, s->by, s->zf), 0.0f);
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3(dir * 1.02f * r, (float)k * 0.3f * r, 0.5f * t), v3(0.06f * r, 0.1f * r, t));
    uint32_t door = dmg_hinge(b, 0, "smokebox_door", v3(dir * 1.02f * r, 0, 1.1f * t), v3(0, dir, 0), 0.0f, swing);
    const dmg_xy shell[] = {{0, 0.05f * t}, {r, 0.05f * t}, {r, t}, {0.6f * r, t + 0.7f * dish}, {0, t + dish}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), shell, 5);
    for (int k = 0; k < straps; ++k) {
        float y = (straps == 1 ? 0.0f : k ? 0.3f : -0.3f) * r;
        dmg_beam(b, v3(dir * 1.05f * r, y, 1.1f * t), v3(dir * 0.5f * r, y, 1.1f * t + 0.8f * dish), 0.25f * t,
                 0.1f * r);
    }
    dmg_move(b, 0, 0, t + 0.95f * dish);
    if (dart == 0) dmg_wall_wheel_draw(b, door, "dart_wheel", 0.22f * r);
    if (dart == 1) {
        dmg_wall_lever_draw(b, door, "dart", 0.4f * r, -1.57f, 1.5f);
        dmg_move(b, 0, 0, 0.12f * r);
        dmg_wall_lever_draw(b, door, "dart", 0.35f * r, -1.2f, 1.5f);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_backhead(dmg_builder* b, const steamer* s) {
    dmg_wall_enter(b, v3(0, s->by, s->zc), DMG_PI);
    dmg_save(b);
    dmg_move(b, 0, 0.3f * s->br, 0);
    dmg_wall_lever_draw(b, 0, "regulator", 0.6f * s->br, dmg_range(b, 0.0f, 3.1f), 0.9f);
    dmg_restore(b);
    float w = 0.25f * s->br, y = -0.45f * s->br;
    bool slides = dmg_chance(b, 0.5f);
    for (int k = -1; k <= 1 && slides; k += 2) {
        dmg_slide(b, 0, "fire_door", v3((float)k, 0, 0), 0.0f, 0.9f * w);
        dmg_box(b, v3((float)k * 0.51f * w, y, 0.03f), v3(w, 1.5f * w, 0.05f));
    }
    dmg_move(b, 0, y, 0);
    if (!slides)
        dmg_wall_leaf_draw(b, 0, "fire_door", 2 * w, 1.5f * w, dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_TOP);
    dmg_restore(b);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        dmg_handwheel_place(b, 0, "reverser", v3(-0.75f * s->half, s->deck + 0.9f, s->zc - 0.25f * s->cab), DMG_PI,
                            0.2f);
        dmg_box_span(b, v3(-0.8f * s->half, s->deck, s->zc - 0.24f * s->cab),
                     v3(-0.7f * s->half, s->deck + 0.95f, s->zc - 0.1f * s->cab));
    } else {
        dmg_roof_enter(b, v3(-0.75f * s->half, s->deck + 0.06f, s->zc - 0.4f * s->cab));
        dmg_wall_stick_draw(b, 0, "reverser", 0.9f);
        dmg_restore(b);
    }
}

static void draw_steam_cab(dmg_builder* b, const steamer* s) {
    float back = s->zc - s->cab, belt = s->deck + 1.0f, wall = 0.05f, share = dmg_range(b, 0.5f, 0.65f),
          post = s->zc - share * s->cab, top = s->roof;
    dmg_box_span(b, v3(-s->half, s->deck - 0.06f, back), v3(s->half, s->deck + 0.04f, s->zc));
    for (int k = -1; k <= 1; k += 2) {
        float x = (float)k * (s->half - wall);
        dmg_box(b, v3(x, 0.5f * (s->deck + belt), 0.5f * (post + s->zc)), v3(wall, belt - s->deck, s->zc - post));
        dmg_box(b, v3(x, 0.5f * (belt + top), s->zc - 0.05f), v3(wall, top - belt, 0.1f));
        dmg_box(b, v3(x, 0.5f * (belt + top), post + 0.05f), v3(wall, top - belt, 0.1f));
        dmg_box(b, v3((float)k * 0.5f * (s->half + 0.6f * s->br), 0.5f * (s->deck + top), s->zc - 0.02f),
                v3(s->half - 0.6f * s->br, top - s->deck, 0.04f));
        if (dmg_chance(b, 0.8f)) {
            dmg_wall_enter(b, v3((float)k * s->half, 0.5f * (s->deck + belt), 0.5f * (post + back)),
                           (float)k * 0.5f * DMG_PI);
            bool ahead = dmg_chance(b, 0.8f);
            dmg_wall_leaf_draw(b, 0, "cab_door", 0.9f * (post - back), 0.9f * (belt - s->deck),
                               ahead == (k > 0) ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT);
            dmg_restore(b);
        }
    }
    const dmg_xy arch[] = {{-1.04f * s->half, top},
                           {-0.6f * s->half, top + 0.16f},
                           {0, top + 0.22f},
                           {0.6f * s->half, top + 0.16f},
                           {1.04f * s->half, top}};
    dmg_save(b);
    dmg_move(b, 0, 0, 0.5f * (back + s->zc));
    dmg_bent_plate(b, arch, 5, 0.05f, 1.1f * s->cab);
    dmg_restore(b);
    dmg_roof_enter(b, v3(0, top + 0.25f, s->zc - 0.5f * s->cab));
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, 0, "roof_vent", v3(0, dmg_sign(b), 0), 0.0f, 0.2f * s->cab);
        dmg_box(b, v3(0, 0, 0.03f), v3(0.6f * s->half, 0.35f * s->cab, 0.06f));
        dmg_use(b, 0);
    } else {
        dmg_wall_leaf_draw(b, 0, "roof_vent", 0.7f * s->half, 0.35f * s->cab,
                           dmg_chance(b, 0.5f) ? DMG_SIDE_BOTTOM : DMG_SIDE_TOP);
    }
    dmg_restore(b);
}

/* Chimney, domes, tanks or running boards alone. */
static void draw_boiler_top(dmg_builder* b, const steamer* s) {
    float length = s->zf - s->zc, y = s->by + s->br, high = s->br * dmg_range(b, 0.4f, 1.3f),
          r = s->br * dmg_range(b, 0.2f, 0.35f);
    const dmg_xy stack[] = {{0, 0},           {1.3f * r, -0.2f * r}, {r, 0.3f * r},           {0.9f * r, 0.85f * high},
                            {1.2f * r, high}, {0.8f * r, high},      {0.7f * r, 0.6f * high}, {0, 0.6f * high}};
    dmg_lathe(b, v3(0, y, s->zf - 0.12f * length), v3(0, 1, 0), stack + 1, 7);
    int domes = dmg_int(b, 0, 2);
    for (int i = 0; i < domes; ++i) {
        float z = s->zc + length * (0.3f + 0.3f * (float)i);
        dmg_capsule(b, v3(0, y - 0.1f, z), v3(0, y + 0.2f * s->br, z), 0.35f * s->br);
    }
    if (dmg_chance(b, 0.35f)) { /* tanks at its sides, with fillers */
        float front = s->zc + length * dmg_range(b, 0.4f, 0.75f), top = s->by + s->br * dmg_range(b, -0.2f, 0.5f);
        for (int k = -1; k <= 1; k += 2) {
            dmg_box_span(b, v3(k < 0 ? -s->half : 0.5f * s->br, s->deck, s->zc),
                         v3(k < 0 ? -0.5f * s->br : s->half, top, front));
            dmg_roof_enter(b, v3((float)k * 0.5f * (s->half + s->br), top, front - 0.4f));
            dmg_wall_lid_draw(b, 0, "filler", fminf(0.16f, 0.3f * (s->half - 0.9f * s->br)));
            dmg_restore(b);
        }
    }
}

/* Cylinders outside the frames, the rods that slide out of them; a still coupling rod. */
static void draw_motion(dmg_builder* b, const dmg_running* n, const steamer* s, float first, float last) {
    float x = n->gauge + 0.32f, r = 0.3f * fmaxf(n->r, 0.7f), z = fmaxf(last + 1.2f * n->r, s->zf - 0.9f),
          way = 0.35f * n->r;
    bool rod = dmg_chance(b, 0.6f) && first < last;
    for (int k = -1; k <= 1; k += 2) {
        float at = (float)k * x;
        dmg_rod(b, v3(at, n->r, z - 0.35f), v3(at, n->r, z + 0.35f), r);
        dmg_box_span(b, v3(at - 0.7f * r, n->r, z - 0.33f), v3(at + 0.7f * r, s->deck, z + 0.33f));
        dmg_slide(b, 0, "crosshead", v3(0, 0, dmg_sign(b)), -0.5f * way, 0.5f * way);
        dmg_rod(b, v3(at, n->r, z - 0.35f - 1.2f * way), v3(at, n->r, z - 0.3f), 0.04f);
        dmg_box(b, v3(at, n->r, z - 0.35f - 1.2f * way), v3(0.12f, 0.22f, 0.2f));
        dmg_use(b, 0);
        if (rod) dmg_box_span(b, v3(at - 0.06f, 0.6f * n->r, first - 0.1f), v3(at - 0.02f, 0.75f * n->r, last + 0.1f));
    }
}

/* Coal and water behind the engine, on its own wheels; it follows round bends. */
static void draw_tender(dmg_builder* b, const dmg_running* n, const steamer* s) {
    float front = s->zc - s->cab - 0.15f, length = dmg_range(b, 2.5f, 5.0f), back = front - length,
          top = s->deck + dmg_range(b, 0.9f, 1.5f), half = 0.95f * s->half;
    uint32_t tender = dmg_hinge(b, 0, "tender", v3(0, s->deck, front + 0.07f), v3(0, dmg_sign(b), 0), -0.12f, 0.12f);
    dmg_box(b, v3(0, s->deck - 0.1f, front + 0.07f), v3(0.3f, 0.08f, 0.3f));
    dmg_box_span(b, v3(-half, s->deck - 0.2f, back), v3(half, s->deck + 0.3f, front));
    dmg_box_span(b, v3(-half, s->deck + 0.3f, back), v3(half, top, back + 0.35f * length));
    for (int k = -1; k <= 1; k += 2)
        dmg_box(b, v3((float)k * (half - 0.03f), 0.5f * (s->deck + 0.3f + top), front - 0.33f * length),
                v3(0.06f, top - s->deck - 0.3f, 0.64f * length));
    dmg_running small = *n;
    small.r = fminf(0.55f, 0.45f * s->deck);
    int axles = dmg_int(b, 2, 4);
    for (int i = 0; i < axles; ++i)
        dmg_wheelset_draw(b, &small, tender, back + length * ((float)i + 0.5f) / (float)axles);
    for (int k = -1; k <= 1; k += 2) {
        dmg_use(b, tender);
        dmg_box(b, v3((float)k * 0.5f * n->gauge, 0.5f * (small.r + s->deck - 0.1f), 0.5f * (front + back)),
                v3(0.06f, s->deck - 0.1f - 0.7f * small.r, 0.9f * length));
    }
    dmg_roof_enter(b, v3(0, top, back + 0.17f * length));
    dmg_wall_lid_draw(b, tender, "water_lid", 0.3f);
    dmg_restore(b);
    dmg_slide(b, tender, "coal_gate", v3(0, 1, 0), 0.0f, 0.4f);
    dmg_box_span(b, v3(-0.4f, s->deck + 0.32f, front - 0.08f), v3(0.4f, top - 0.1f, front - 0.02f));
    dmg_use(b, 0);
    dmg_buffing_draw(b, tender, s->deck - 0.1f, back, -1);
}

static void draw_steam_engine(dmg_builder* b) {
    dmg_running n = dmg_running_pick(b, dmg_range(b, 0.45f, 1.0f));
    if (dmg_chance(b, 0.7f)) n.wheel = dmg_int(b, 8, 14);
    int axles = dmg_int(b, 2, 5);
    float pitch = n.r * dmg_range(b, 2.15f, 2.6f), base = pitch * (float)(axles - 1);
    steamer s = {.deck = 2.1f * n.r + 0.05f, .zf = 0.5f * base + 1.2f * n.r};
    bool lead = dmg_chance(b, 0.5f), tender = dmg_chance(b, 0.55f);
    if (lead) s.zf += 1.5f;
    s.br = dmg_range(b, 0.5f, 0.85f);
    s.by = s.deck + s.br * dmg_range(b, 0.75f, 1.1f);
    s.zc = -0.5f * base - n.r * dmg_range(b, -0.5f, 0.6f);
    s.zc = fminf(s.zc, s.zf - 2.5f);
    s.cab = dmg_range(b, 1.3f, 2.2f);
    s.half = fmaxf(n.gauge + 0.45f, s.br + 0.35f);
    s.roof = fmaxf(s.by + s.br + 0.15f, s.deck + 1.9f);
    float back = s.zc - s.cab;
    dmg_rod(b, v3(0, s.by, s.zc), v3(0, s.by, s.zf), s.br);
    dmg_box_span(b, v3(-0.5f * n.gauge, s.deck - 0.1f, s.zc), v3(0.5f * n.gauge, s.by, s.zf - 0.2f));
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3((float)k * 0.6f * n.gauge - 0.03f, 0.8f * n.r, back),
                     v3((float)k * 0.6f * n.gauge + 0.03f, s.deck, s.zf));
    dmg_box_span(b, v3(-s.half, s.deck - 0.06f, s.zc), v3(s.half, s.deck, s.zf));
    for (int i = 0; i < axles; ++i) dmg_wheelset_draw(b, &n, 0, -0.5f * base + pitch * (float)i);
    dmg_running small = n;
    small.r = 0.45f * fmaxf(n.r, 0.7f);
    if (lead) dmg_bogie_draw(b, &small, s.zf - 0.75f, s.deck, dmg_int(b, 1, 2));
    if (dmg_chance(b, 0.7f)) draw_motion(b, &n, &s, -0.5f * base, 0.5f * base);
    draw_smokebox_door(b, &s);
    draw_boiler_top(b, &s);
    draw_steam_cab(b, &s);
    draw_backhead(b, &s);
    dmg_buffing_draw(b, 0, s.deck - 0.15f, s.zf + 0.15f, 1);
    dmg_box_span(b, v3(-s.half, s.deck - 0.06f, s.zf - 0.01f), v3(s.half, s.deck, s.zf + 0.1f));
    if (tender)
        draw_tender(b, &n, &s);
    else
        dmg_buffing_draw(b, 0, s.deck - 0.15f, back, -1);
}

/* ---- diesel ---- */

/* Draws a row of doors along both sides of a hood. */
static void draw_hood_doors(dmg_builder* b, float half, float low, float high, float z0, float z1) {
    int count = dmg_int(b, 2, 6);
    float each = (z1 - z0) / (float)count, fill = dmg_range(b, 0.7f, 0.95f);
    bool pairs = dmg_chance(b, 0.4f), grilles = dmg_chance(b, 0.4f);
    dmg_side hung = dmg_chance(b, 0.25f) ? DMG_SIDE_TOP : DMG_SIDE_LEFT;
    for (int i = 0; i < 2 * count; ++i) {
        float side = i % 2 ? -1.0f : 1.0f, z = z0 + each * ((float)(i / 2) + 0.5f);
        dmg_wall_enter(b, v3(side * half, 0.5f * (low + high), z), side * 0.5f * DMG_PI);
        if (grilles && (i / 2) % 3 == 1)
            dmg_wall_louvres_draw(b, fill * each, 0.7f * (high - low), 6);
        else
            dmg_wall_leaf_draw(b, 0, "engine_door", fill * each, 0.85f * (high - low),
                               hung == DMG_SIDE_LEFT && pairs && (i / 2) % 2 ? DMG_SIDE_RIGHT : hung);
        dmg_restore(b);
    }
}

static void draw_roof_fans(dmg_builder* b, float y, float z0, float z1, float r) {
    int count = dmg_int(b, 1, 3), blades = dmg_int(b, 3, 7), kind = dmg_int(b, 0, 1);
    bool bars = dmg_chance(b, 0.4f);
    for (int i = 0; i < count; ++i) {
        dmg_roof_enter(b, v3(0, y, z0 + (z1 - z0) * ((float)i + 0.5f) / (float)count));
        dmg_torus(b, v3(0, 0, 0.1f), v3(0, 0, 1), 1.05f * r, 0.1f);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.05f), 0.1f * r);
        for (int k = -1; k <= 1 && bars; ++k) dmg_box(b, v3(0, (float)k * 0.4f * r, 0.25f), v3(2 * r, 0.04f, 0.03f));
        dmg_spin(b, 0, "fan", v3(0, 0, 0.12f), v3(0, 0, 1));
        dmg_move(b, 0, 0, 0.12f);
        dmg_rod(b, v3(0, 0, -0.06f), v3(0, 0, 0.05f), 0.2f * r);
        dmg_blades_draw(b, kind, 0.9f * r, 0.2f * r, 0.25f * r, blades, 0.5f);
        dmg_use(b, 0);
        dmg_restore(b);
    }
}

static void draw_diesel(dmg_builder* b) {
    dmg_running n = dmg_running_pick(b, dmg_range(b, 0.4f, 0.55f));
    float length = dmg_range(b, 7.0f, 18.0f), deck = 2.5f * n.r, roof = deck + dmg_range(b, 2.3f, 2.9f),
          wide = dmg_range(b, 1.3f, 1.55f), end = 0.5f * length, cab = dmg_range(b, 1.8f, 2.6f);
    bool hood = dmg_chance(b, 0.6f), nose = dmg_chance(b, 0.7f);
    float half = hood ? 0.62f * wide : wide, top = hood ? roof - dmg_range(b, 0.2f, 0.9f) : roof,
          snout = nose ? dmg_range(b, 0.8f, 2.0f) : 0.1f, zc = end - 0.3f - snout;
    float low = hood || dmg_chance(b, 0.5f) ? deck + dmg_range(b, 1.1f, 1.6f) : roof;
    dmg_box_span(b, v3(-wide, deck - 0.3f, -end), v3(wide, deck, end));
    dmg_box_span(b, v3(-half, deck, -end + 0.4f), v3(half, top, zc - cab));
    if (nose) dmg_box_span(b, v3(-0.7f * wide, deck, zc), v3(0.7f * wide, low, end - 0.3f));
    dmg_cab c = dmg_cab_pick(b, v3(-wide, deck, zc - cab), v3(wide, roof, zc));
    c.slope *= 0.4f;
    dmg_cab_draw(b, &c, 0);
    draw_hood_doors(b, half, deck + 0.1f, top - 0.1f, -end + 0.6f, zc - cab - 0.2f);
    draw_roof_fans(b, top, -end + 1.0f, 0.0f, fminf(0.8f * half, 0.7f));
    if (nose) {
        dmg_wall_enter(b, v3(0, 0.5f * (deck + low), end - 0.3f), 0.0f);
        dmg_wall_leaf_draw(b, 0, "nose_door", 0.7f * wide, 0.85f * (low - deck),
                           dmg_chance(b, 0.5f) ? DMG_SIDE_LEFT : DMG_SIDE_RIGHT);
        dmg_restore(b);
    }
    dmg_roof_enter(b, v3(0, top, 0.5f * (zc - cab)));
    dmg_wall_leaf_draw(b, 0, "roof_hatch", 1.2f * half, 0.5f * (zc - cab), (dmg_side)dmg_int(b, 0, 3));
    dmg_restore(b);
    dmg_box_span(b, v3(-0.8f * wide, 0.6f * n.r, -0.12f * length),
                 v3(0.8f * wide, deck - 0.3f, 0.12f * length)); /* fuel */
    int axles = length > 11.0f ? dmg_int(b, 2, 3) : 2;
    for (int k = -1; k <= 1; k += 2)
        dmg_bogie_draw(b, &n, (float)k * (0.5f * length - 1.9f * n.r * (float)axles), deck - 0.3f, axles);
    for (int k = -1; k <= 1; k += 2) dmg_buffing_draw(b, 0, deck - 0.2f, (float)k * (end + 0.12f), (float)k);
}

void dmg_build_locomotive(dmg_builder* b) {
    dmg_grow(b, dmg_chance(b, 0.3f) ? dmg_scale_range(b, 0.01f, 0.3f) : 1.0f);
    if (dmg_chance(b, 0.55f))
        draw_steam_engine(b);
    else
        draw_diesel(b);
}
