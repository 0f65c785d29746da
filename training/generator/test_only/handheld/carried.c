/* Draws binoculars that fold about their bridge, opera glasses, night-vision goggles; lanterns with globes and
 * doors, torches, head lamps. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- binoculars: they look to +Z ---- */

typedef struct glass {
    float r, eye, length, apart; /* of a barrel: objective, eyepiece, length; half the distance between their axes */
    int shape;                   /* 0 straight, 1 with a prism housing, 2 a cone */
} glass;

/* Draws one barrel about the axis through (0, 0): what is fixed, then cups, rings and caps that move. */
static void draw_barrel(dmg_builder* b, const glass* g, uint32_t parent, int cups, bool cap) {
    float back = -0.5f * g->length, front = 0.5f * g->length, cup = 0.16f * g->length, thread = 0.05f * g->eye;
    const dmg_xy straight[] = {{0, back},
                               {g->eye, back},
                               {1.1f * g->eye, 0.5f * back},
                               {0.95f * g->r, 0.1f * back},
                               {0.95f * g->r, 0.8f * front},
                               {g->r, 0.85f * front},
                               {g->r, front},
                               {0, front}};
    const dmg_xy cone[] = {
        {0, back},     {g->eye, back}, {g->eye, 0.7f * back}, {0.8f * g->eye, 0.65f * back}, {g->r, 0.7f * front},
        {g->r, front}, {0, front}};
    dmg_use(b, parent);
    if (g->shape == 2)
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cone, 7);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), straight, 8);
    if (g->shape == 1)
        dmg_rounded_box(b, v3(0, 0, 0.25f * back), v3(2.1f * g->r, 2.1f * g->r, 0.4f * g->length), 0.3f * g->r);
    if (cups == 1) dmg_screw(b, parent, "eye_cup", v3(0, 0, back), v3(0, 0, -1), thread, 0.0f, 4.7f);
    if (cups == 2) dmg_slide(b, parent, "eye_cup", v3(0, 0, -1), 0.0f, 0.5f * cup);
    const dmg_xy rim[] = {{1.02f * g->eye, back + 0.6f * cup},
                          {1.02f * g->eye, back - 0.4f * cup},
                          {1.25f * g->eye, back - 0.4f * cup},
                          {1.2f * g->eye, back + 0.6f * cup},
                          {1.02f * g->eye, back + 0.6f * cup}};
    if (cups) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), rim, 5);
    if (cap) {
        dmg_hinge(b, parent, "cap", v3(0, -1.1f * g->r, front), v3(1, 0, 0), 0.0f, 2.4f);
        dmg_rod(b, v3(0, 0, front), v3(0, 0, front + 0.06f * g->length), 1.05f * g->r);
    }
    dmg_use(b, parent);
}

/* Draws what joins the barrels: arms round a tube. The wheel turns on the tube, the right barrel about it. */
static void draw_field_glass(dmg_builder* b, const glass* g) {
    float tube = 0.2f * g->apart, fold = dmg_range(b, 0.3f, 0.7f), rest = fold * dmg_range(b, -1.0f, 1.0f),
          drop = g->apart * dmg_range(b, 0.0f, 0.2f);
    int cups = dmg_int(b, 0, 2);
    bool folds = dmg_chance(b, 0.85f), caps = dmg_chance(b, 0.3f), inward = dmg_chance(b, 0.5f);
    float z0 = -0.3f * g->length, z1 = 0.25f * g->length, w = 0.1f * g->length;
    dmg_rod(b, v3(0, drop, z0 - w), v3(0, drop, z1 + w), 0.7f * tube);
    uint32_t halves[2] = {0, 0};
    if (folds) {
        halves[1] = dmg_hinge(b, 0, "half", v3(0, drop, 0), v3(0, 0, inward ? -1.0f : 1.0f), -fold, 0.35f);
        dmg_rest(b, halves[1], fmaxf(-fold, fminf(0.35f, rest)));
    }
    for (int i = 0; i < 2; ++i) { /* their knuckles take turns along the tube */
        float side = i ? 1.0f : -1.0f, reach = g->apart - (g->shape == 1 ? 0.9f : 0.5f) * g->r;
        dmg_use(b, halves[i]);
        for (int k = 0; k < 2; ++k) {
            float z = (k ? z1 : z0) + (i ? 0.5f : -0.5f) * w;
            dmg_rod(b, v3(0, drop, z - 0.48f * w), v3(0, drop, z + 0.48f * w), tube);
            dmg_beam(b, v3(side * 0.5f * tube, drop, z), v3(side * reach, 0, z), 0.9f * w, 0.9f * tube);
        }
        dmg_save(b);
        dmg_move(b, side * g->apart, 0, 0);
        draw_barrel(b, g, halves[i], cups, caps);
        if (i && dmg_chance(b, 0.5f)) {
            dmg_hinge(b, halves[i], "dioptre", v3(0, 0, 0), v3(0, 0, 1), -1.2f, 1.2f);
            dmg_rod(b, v3(0, 0, -0.38f * g->length), v3(0, 0, -0.32f * g->length), 1.35f * g->eye);
            dmg_box(b, v3(0, 1.4f * g->eye, -0.35f * g->length), v3(0.2f * g->eye, 0.2f * g->eye, 0.05f * g->length));
        }
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_spin(b, 0, "focus_wheel", v3(0, drop, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_move(b, 0, drop, 0.5f * (z0 + z1));
    dmg_wheel_draw(b, dmg_chance(b, 0.6f) ? 4 : 0, fminf(1.6f * tube, 0.9f * (g->apart - 0.95f * g->r)), 1.6f * w, 8);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws two bridges, a wheel between them that drives the eyepieces, a handle that folds under. */
static void draw_opera_glass(dmg_builder* b, const glass* g) {
    float t = 0.06f * g->length, way = 0.25f * g->length, grip = g->length * dmg_range(b, 1.2f, 2.0f);
    dmg_rod(b, v3(0, 0, -0.35f * g->length), v3(0, 0, 0.3f * g->length), 0.8f * t);
    for (int k = 0; k < 2; ++k)
        dmg_box(b, v3(0, 0, (k ? 0.3f : 0.05f) * g->length), v3(2 * g->apart, 1.2f * t, 1.5f * t));
    for (int i = -1; i <= 1; i += 2)
        dmg_cone(b, v3((float)i * g->apart, 0, -0.1f * g->length), v3((float)i * g->apart, 0, 0.5f * g->length),
                 0.75f * g->r, g->r);
    dmg_slide(b, 0, "eyepieces", v3(0, 0, -1), 0.0f, way);
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3((float)i * g->apart, 0, -0.45f * g->length), v3((float)i * g->apart, 0, 0.1f * g->length),
                0.6f * g->r);
    dmg_box(b, v3(0, 0, -0.38f * g->length), v3(2 * g->apart, t, t));
    dmg_spin(b, 0, "focus_wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, 0, -0.12f * g->length), v3(0, 0, -0.02f * g->length), fminf(3 * t, g->apart - 0.8f * g->r));
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.6f)) return;
    float x = g->apart + 0.97f * g->r, z = 0.3f * g->length;
    dmg_box(b, v3(x, 0, z), v3(2 * t, 2 * t, 2 * t));
    uint32_t handle = dmg_hinge(b, 0, "handle", v3(x + t, 0, z), v3(0, 0, 1), 0.0f, 1.57f);
    dmg_rod(b, v3(x + t, 0, z - 1.3f * t), v3(x + t, 0, z + 1.3f * t), 0.6f * t);
    dmg_slide(b, handle, "grip", v3(0, -1, 0), 0.0f, 0.4f * grip);
    dmg_rod(b, v3(x + t, -0.6f * grip, z), v3(x + t, -0.15f * grip, z), 1.1f * t);
    dmg_use(b, handle);
    dmg_rod(b, v3(x + t, 0, z), v3(x + t, -0.55f * grip, z), 0.7f * t);
    dmg_use(b, 0);
}

/* On a plate before the helmet's brow: an arm that flips up, along it a carriage, under it one tube or two. */
static void draw_night_goggles(dmg_builder* b, const glass* g) {
    float t = 0.1f * g->length, y = 1.4f * g->r, z = -0.7f * g->length;
    int tubes = dmg_int(b, 1, 2);
    dmg_rounded_box(b, v3(0, y + 2 * t, z), v3(4 * t, 6 * t, 1.2f * t), 0.4f * t);
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * 1.6f * t - 0.4f * t, y + t, z),
                     v3((float)i * 1.6f * t + 0.4f * t, y + 3 * t, z + 2.4f * t));
    uint32_t arm = dmg_hinge(b, 0, "arm", v3(0, y + 2 * t, z + 1.8f * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.3f, 2.0f));
    dmg_rod(b, v3(-2 * t, y + 2 * t, z + 1.8f * t), v3(2 * t, y + 2 * t, z + 1.8f * t), 0.5f * t);
    dmg_box_span(b, v3(-0.9f * t, y + 1.6f * t, z + 1.6f * t), v3(0.9f * t, y + 2.6f * t, 0.3f * g->length));
    uint32_t carriage = dmg_slide(b, arm, "carriage", v3(0, 0, 1), 0.0f, 0.25f * g->length);
    dmg_box_span(b, v3(-1.3f * t, y - 0.5f * t, -1.5f * t), v3(1.3f * t, y + 1.5f * t, 1.5f * t));
    for (int i = 0; i < tubes; ++i) {
        float x = tubes == 2 ? (i ? 1.0f : -1.0f) * g->apart : 0.0f;
        uint32_t pod = carriage;
        if (tubes == 2) {
            dmg_use(b, carriage);
            dmg_box_span(b, v3(fminf(0.6f * x, 0), y - 0.2f * t, -0.8f * t),
                         v3(fmaxf(0.6f * x, 0), y + 0.5f * t, 0.8f * t));
            pod = dmg_hinge(b, carriage, "pod", v3(0.6f * x, y, 0), v3(0, 0, x > 0 ? 1.0f : -1.0f), 0.0f, 1.5f);
        }
        dmg_use(b, pod);
        dmg_beam(b, v3(0.6f * x, y, 0), v3(x, 0.5f * g->r, 0), 1.4f * t, t);
        dmg_save(b);
        dmg_move(b, x, 0, 0);
        draw_barrel(b, g, pod, 0, false);
        dmg_spin(b, pod, "focus", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, 0.35f * g->length), v3(0, 0, 0.45f * g->length), 1.15f * g->r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

void dmg_build_binoculars(dmg_builder* b) {
    glass g = {.r = dmg_scale_range(b, 0.012f, 0.04f)};
    int kind = dmg_weighted(b, (const float[]){5, 2, 2.5f}, 3);
    g.eye = g.r * dmg_range(b, 0.55f, 0.9f);
    g.length = g.r * dmg_range(b, 3.5f, 6.5f);
    g.apart = g.r * dmg_range(b, 1.35f, 1.9f);
    g.shape = dmg_int(b, 0, 2);
    dmg_move(b, 0, (kind == 1 ? 4.0f : 1.3f) * g.r, 0);
    if (kind == 0) draw_field_glass(b, &g);
    if (kind == 1) draw_opera_glass(b, &g);
    if (kind == 2) draw_night_goggles(b, &g);
}

/* ---- lantern ---- */

/* Draws a bow of wire over the top: its ends turn in eyes at ±x, it drops to either side. */
static void draw_bail(dmg_builder* b, float x, float y, float reach, float wire) {
    enum { POINTS = 9 };
    dmg_vec path[POINTS];
    float drop = dmg_range(b, 1.2f, 2.0f), rest = drop * dmg_range(b, -1.0f, 1.0f);
    bool upright = dmg_chance(b, 0.5f);
    uint32_t bail = dmg_hinge(b, 0, "bail", v3(0, y, 0), v3(1, 0, 0), -drop, drop);
    dmg_rest(b, bail, upright ? 0.0f : rest);
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1);
        path[i] = v3(x * cosf(angle), y + reach * sinf(angle), 0);
    }
    dmg_sweep(b, path, POINTS, wire, wire, false);
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3((float)i * (x - 2 * wire), y, 0), v3((float)i * (x + wire), y, 0), 1.2f * wire);
    dmg_use(b, 0);
}

/* Draws a tank with the burner on it, a globe in a cradle, two side tubes up to the chimney. */
static void draw_oil_lantern(dmg_builder* b) {
    float r = dmg_range(b, 0.05f, 0.09f), tank = r * dmg_range(b, 0.5f, 0.9f), high = r * dmg_range(b, 3.0f, 4.2f),
          g = r * dmg_range(b, 0.6f, 0.8f), t = 0.06f * r, x = 1.15f * r;
    float lower = tank + 0.5f * r, top = high - 0.9f * r, lift = 0.3f * r;
    const dmg_xy body[] = {{0, 0},           {0.95f * r, 0},        {r, 0.1f * tank}, {r, 0.7f * tank},
                           {0.5f * r, tank}, {0.4f * r, lower - t}, {0, lower - t}};
    const dmg_xy globe[] = {{0.7f * g, lower},
                            {g, 0.5f * (lower + top) - 0.1f * g},
                            {0.95f * g, 0.5f * (lower + top)},
                            {0.6f * g, top - lift},
                            {0.55f * g, top - lift},
                            {0.9f * g, 0.5f * (lower + top)},
                            {0.95f * g, 0.5f * (lower + top) - 0.1f * g},
                            {0.65f * g, lower},
                            {0.7f * g, lower}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 7);
    for (int i = -1; i <= 1; i += 2) {
        float s = (float)i;
        const dmg_vec tube[] = {v3(s * 0.8f * r, 0.8f * tank, 0), v3(s * x, tank + 0.4f * r, 0), v3(s * x, top, 0),
                                v3(s * 0.7f * r, top + 0.4f * r, 0), v3(0, top + 0.4f * r, 0)};
        dmg_sweep(b, tube, 5, 1.6f * t, t, false);
    }
    dmg_slide(b, 0, "globe", v3(0, 1, 0), 0.0f, lift);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), globe, 9);
    dmg_rod(b, v3(0, lower, 0), v3(0, lower + 0.6f * t, 0), 0.75f * g);
    dmg_use(b, 0);
    dmg_cone(b, v3(0, top + 0.3f * r, 0), v3(0, top + 0.6f * r, 0), 0.6f * r, 0.35f * r);
    if (dmg_chance(b, 0.6f)) dmg_slide(b, 0, "chimney", v3(0, 1, 0), 0.0f, 0.3f * r);
    dmg_cone(b, v3(0, top + 0.62f * r, 0), v3(0, high, 0), 0.5f * r, 0.25f * r);
    dmg_use(b, 0);
    float y = 0.5f * (tank + lower), out = 0.9f * r;
    dmg_spin(b, 0, "wick_knob", v3(0, y, 0), v3(0, 0, 1));
    dmg_rod(b, v3(0, y, 0.3f * r), v3(0, y, out), 0.6f * t);
    dmg_rod(b, v3(0, y, out), v3(0, y, out + 1.2f * t), 0.15f * r);
    dmg_use(b, 0);
    dmg_hinge(b, 0, "lift_lever", v3(x + 1.2f * t, lower + 0.4f * r, 0), v3(1, 0, 0), 0.0f, 1.2f);
    dmg_box_span(b, v3(x + 0.8f * t, lower, -t), v3(x + 1.6f * t, lower + 0.6f * r, t));
    dmg_box_span(b, v3(x + 0.8f * t, lower, -t), v3(x + 4 * t, lower + t, t));
    dmg_use(b, 0);
    dmg_rod(b, v3(1.05f * x, 0.7f * tank, 0), v3(0.8f * r, 0.7f * tank, 0), 1.5f * t); /* the cap's spout */
    dmg_screw(b, 0, "filler_cap", v3(0, 0.85f * tank, 0.75f * r), v3(0, 1, 0), 0.1f * t, 0.0f, 9.0f);
    dmg_rod(b, v3(0, 0.6f * tank, 0.75f * r), v3(0, tank + t, 0.75f * r), 0.17f * r);
    dmg_use(b, 0);
    draw_bail(b, x + 0.5f * t, top, r * dmg_range(b, 1.6f, 2.2f), 0.4f * t);
}

/* Panes in a frame under a roof, one of them a door. */
static void draw_pane_lantern(dmg_builder* b) {
    float half = dmg_scale_range(b, 0.05f, 0.15f), high = half * dmg_range(b, 2.0f, 3.6f), t = 0.07f * half,
          roof = half * dmg_range(b, 0.5f, 1.1f);
    int panes = dmg_chance(b, 0.6f) ? 4 : 6;
    float r = half, apothem = r * cosf(DMG_PI / (float)panes), wide = 2 * r * sinf(DMG_PI / (float)panes);
    const dmg_xy candle[] = {{0, t}, {0.3f * half, t}, {0.3f * half, 0.55f * high}, {0, 0.6f * high}};
    dmg_rod(b, v3(0, 0, 0), v3(0, 2 * t, 0), 1.12f * r);
    dmg_cone(b, v3(0, high, 0), v3(0, high + t, 0), 1.2f * r, 1.1f * r);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), candle, 4);
    bool lifts = dmg_chance(b, 0.3f), back = dmg_chance(b, 0.4f);
    if (lifts) dmg_hinge(b, 0, "roof", v3(0, high + t, -1.1f * r), v3(-1, 0, 0), 0.0f, 1.5f);
    dmg_cone(b, v3(0, high + 1.05f * t, 0), v3(0, high + roof, 0), 1.1f * r, 0.2f * r);
    float ring = 0.3f * half;
    dmg_hinge(b, lifts ? b->part : 0, "ring", v3(0, high + roof, 0), v3(1, 0, 0), -1.4f, 1.4f);
    dmg_torus(b, v3(0, high + roof + 0.8f * ring, 0), v3(0, 0, 1), ring, 0.12f * ring);
    dmg_use(b, 0);
    for (int i = 0; i < panes; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, panes);
        dmg_beam(b, v3(0.5f * wide, t, apothem), v3(0.5f * wide, high, apothem), 1.3f * t, 1.3f * t);
        dmg_move(b, 0, 0.5f * (high + 2 * t), apothem + 0.3f * t);
        bool door = i == 0 || (back && i == panes / 2);
        if (door) {
            dmg_leaf leaf = dmg_leaf_pick(b, 0.3f * half);
            leaf.width = wide - 1.7f * t;
            leaf.height = high - 2.4f * t;
            leaf.thickness = 0.6f * t;
            leaf.panel = dmg_panel_pick_window(b);
            dmg_move(b, 0, 0, 0.6f * t);
            dmg_leaf_draw(b, 0, "door", &leaf);
        } else {
            dmg_box(b, v3(0, 0, 0), v3(wide - t, high - 2 * t, 0.2f * t));
        }
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

/* Draws a tube: head, switch and tail all move; the head may lie across, or tilt. */
static void draw_torch(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.011f, 0.03f), length = r * dmg_range(b, 5.0f, 11.0f),
          bell = r * dmg_range(b, 1.0f, 2.0f), deep = bell * dmg_range(b, 0.8f, 1.8f), t = 0.15f * r;
    bool tilts = dmg_chance(b, 0.3f), screws = dmg_chance(b, 0.5f), stands = dmg_chance(b, 0.3f);
    dmg_move(b, 0, stands ? length : 1.1f * fmaxf(bell, r), 0);
    if (stands) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_rod(b, v3(0, 0, -0.9f * length), v3(0, 0, tilts ? -0.8f * r : 0), r);
    const dmg_xy head[] = {{0, 0},       {1.04f * r, 0},       {1.04f * r, 0.2f * deep}, {bell, 0.7f * deep},
                           {bell, deep}, {0.85f * bell, deep}, {0, 0.8f * deep}};
    if (tilts) { /* between two cheeks */
        for (int i = -1; i <= 1; i += 2)
            dmg_box_span(b, v3((float)i * 0.85f * r - t, -0.5f * r, -r),
                         v3((float)i * 0.85f * r + t, 0.5f * r, 0.6f * r));
        uint32_t neck = dmg_hinge(b, 0, "head", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, 1.6f);
        dmg_rod(b, v3(-0.68f * r, 0, 0), v3(0.68f * r, 0, 0), 0.5f * r);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.75f * r), 0.5f * r);
        dmg_move(b, 0, 0, 0.7f * r);
        if (screws) dmg_spin(b, neck, "focus_ring", v3(0, 0, 0), v3(0, 0, 1));
    } else if (screws) {
        dmg_screw(b, 0, "head", v3(0, 0, 0), v3(0, 0, 1), 0.03f * r, 0.0f, 12.0f);
    } else {
        dmg_slide(b, 0, "head", v3(0, 0, 1), 0.0f, 0.4f * deep);
    }
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), head, 7);
    for (int i = 0; i < 6; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 0, 1), i, 6);
        dmg_box(b, v3(1.03f * r, 0, 0.1f * deep), v3(0.1f * r, 0.3f * r, 0.16f * deep));
        dmg_restore(b);
    }
    dmg_use(b, 0);
    if (dmg_chance(b, 0.7f)) {
        dmg_slide(b, 0, "switch", v3(0, 0, 1), 0.0f, 0.5f * r);
        dmg_rounded_box(b, v3(0, r, -0.4f * length), v3(0.7f * r, 0.6f * r, 1.1f * r), 0.15f * r);
        dmg_use(b, 0);
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * 0.5f * r, 0.9f * r, -0.4f * length + 0.2f * r), v3(0.2f * r, 0.5f * r, 2.4f * r));
    }
    uint32_t tail = dmg_screw(b, 0, "tail_cap", v3(0, 0, 0), v3(0, 0, -1), 0.03f * r, 0.0f, 15.0f);
    dmg_rod(b, v3(0, 0, -length), v3(0, 0, -0.9f * length), 1.06f * r);
    if (dmg_chance(b, 0.5f)) {
        dmg_slide(b, tail, "tail_key", v3(0, 0, 1), 0.0f, 0.2f * r);
        dmg_rod(b, v3(0, 0, -length - 0.3f * r), v3(0, 0, -length), 0.5f * r);
    }
}

/* On a band round the head: a lamp that tips down, a knob on it, a box for the batteries behind. */
static void draw_head_lamp(dmg_builder* b) {
    enum { POINTS = 20 };
    float r = dmg_range(b, 0.075f, 0.095f), lamp = r * dmg_range(b, 0.25f, 0.4f), t = 0.06f * r, y = 1.3f * r;
    dmg_vec band[POINTS];
    for (int i = 0; i < POINTS; ++i) {
        float angle = 2 * DMG_PI * (float)i / POINTS;
        band[i] = v3(r * sinf(angle), y, 1.2f * r * cosf(angle));
    }
    dmg_sweep(b, band, POINTS, 0.02f * r, 0.12f * r, true);
    float z = 1.2f * r, pin = z + 0.8f * lamp;
    dmg_box_span(b, v3(-1.1f * lamp, y - 0.7f * lamp, z - t), v3(1.1f * lamp, y + 0.7f * lamp, z + 0.5f * t));
    for (int i = -1; i <= 1; i += 2)
        dmg_box_span(b, v3((float)i * 1.2f * lamp - 0.1f * lamp, y - 0.4f * lamp, z - t),
                     v3((float)i * 1.2f * lamp + 0.1f * lamp, y + 0.3f * lamp, pin + 0.3f * lamp));
    uint32_t head = dmg_hinge(b, 0, "lamp", v3(0, y, pin), v3(1, 0, 0), 0.0f, dmg_range(b, 0.7f, 1.5f));
    dmg_rod(b, v3(-1.2f * lamp, y, pin), v3(1.2f * lamp, y, pin), 0.15f * lamp);
    if (dmg_chance(b, 0.5f))
        dmg_cone(b, v3(0, y, pin - 0.4f * lamp), v3(0, y, pin + 0.9f * lamp), 0.5f * lamp, 0.95f * lamp);
    else
        dmg_rounded_box(b, v3(0, y, pin + 0.2f * lamp), v3(2 * lamp, 1.2f * lamp, 1.2f * lamp), 0.2f * lamp);
    dmg_slide(b, head, "key", v3(0, -1, 0), 0.0f, 0.06f * lamp);
    dmg_box(b, v3(0, y + 0.65f * lamp, pin), v3(0.7f * lamp, 0.25f * lamp, 0.4f * lamp));
    dmg_use(b, 0);
    dmg_box_span(b, v3(-lamp, y - lamp, -1.2f * r - 0.6f * lamp), v3(lamp, y + lamp, -1.2f * r));
    dmg_hinge(b, 0, "battery_door", v3(0, y - lamp, -1.2f * r - 0.6f * lamp - 0.5f * t), v3(-1, 0, 0), 0.0f, 1.7f);
    dmg_box_span(b, v3(-lamp, y - lamp, -1.2f * r - 0.6f * lamp - t), v3(lamp, y + lamp, -1.2f * r - 0.6f * lamp));
    dmg_use(b, 0);
}

void dmg_build_lantern(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){3, 3, 4, 2}, 4);
    if (kind == 0) draw_oil_lantern(b);
    if (kind == 1) draw_pane_lantern(b);
    if (kind == 2) draw_torch(b);
    if (kind == 3) draw_head_lamp(b);
}
