/* Draws decks of ships, bow to +Z: derricks, cranes and davits, hatch covers that fold, roll or tip, windlass and
 * capstan, tight doors with their clips, a bow that lifts or parts, a ramp at the stern. */
#include "core/build.h"
#include "parts/walls.h"

typedef struct deck {
    float half, y;    /* half the beam, height of the deck */
    float stern, bow; /* where the straight sides end */
    float unit;       /* what fittings go by */
} deck;

/* ---- lifting gear ---- */

/* Draws a hook on a length of wire under the origin; it is let down. */
static void draw_hook(dmg_builder* b, uint32_t boom, dmg_vec at, float size) {
    float wire = size * dmg_range(b, 1.0f, 3.0f), way = size * dmg_range(b, 1.0f, 2.5f);
    dmg_slide(b, boom, "hook", v3(0, -1, 0), 0.0f, way);
    dmg_rod(b, v3(at.x, at.y - wire, at.z), at, 0.06f * size);
    dmg_box(b, v3(at.x, at.y - wire, at.z), v3(0.25f * size, 0.4f * size, 0.4f * size));
    const dmg_vec bend[] = {{at.x, at.y - wire - 0.2f * size, at.z},
                            {at.x, at.y - wire - 0.5f * size, at.z},
                            {at.x, at.y - wire - 0.6f * size, at.z + 0.15f * size},
                            {at.x, at.y - wire - 0.45f * size, at.z + 0.25f * size}};
    dmg_sweep(b, bend, 4, 0.06f * size, 0.06f * size, false);
}

/* Draws a boom on a gooseneck at the foot of a mast: it slews with the neck and is topped about the pin. */
static void draw_derrick(dmg_builder* b, dmg_vec foot, float reach, float turn) {
    float mast = reach * dmg_range(b, 0.8f, 1.3f), r = reach * dmg_range(b, 0.018f, 0.04f),
          neck = reach * dmg_range(b, 0.08f, 0.2f), slant = dmg_range(b, 0.25f, 1.0f);
    bool tree = dmg_chance(b, 0.4f), hook = dmg_chance(b, 0.6f);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, foot.x, foot.y, foot.z);
    dmg_turn(b, v3(0, 1, 0), turn);
    dmg_cone(b, v3(0, 0, 0), v3(0, mast, 0), 1.6f * r, r);
    if (tree) dmg_box(b, v3(0, 0.9f * mast, 0), v3(0.3f * mast, 2 * r, 3 * r));
    dmg_box_span(b, v3(-1.5f * r, neck - 2 * r, 0), v3(1.5f * r, neck - r, 4 * r));
    uint32_t slew = dmg_hinge(b, 0, "gooseneck", v3(0, neck, 3 * r), v3(0, 1, 0), -1.2f, 1.2f);
    dmg_rod(b, v3(0, neck - r, 3 * r), v3(0, neck + r, 3 * r), r);
    dmg_box_span(b, v3(-0.5f * r, neck - 0.8f * r, 3 * r), v3(0.5f * r, neck + 0.8f * r, 5.5f * r));
    uint32_t boom = dmg_hinge(b, slew, "boom", v3(0, neck, 5 * r), v3(-1, 0, 0), -slant, 1.35f - slant);
    dmg_vec pin = v3(0, neck, 5 * r), tip = v3(0, neck + reach * sinf(slant), 5 * r + reach * cosf(slant));
    dmg_vec belly = v3_lerp(pin, tip, 0.5f);
    dmg_cone(b, pin, belly, 0.6f * r, 1.1f * r);
    dmg_cone(b, belly, tip, 1.1f * r, 0.6f * r);
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * 0.8f * r, pin.y, pin.z), v3(0.5f * r, 1.4f * r, 1.4f * r));
    if (hook) draw_hook(b, boom, v3_mad(tip, v3(0, -1, 0), 0.5f * r), 0.12f * reach);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a pedestal, a house that slews, a jib that luffs. */
static void draw_crane(dmg_builder* b, dmg_vec foot, float reach, float turn) {
    float column = reach * dmg_range(b, 0.15f, 0.4f), wide = reach * dmg_range(b, 0.1f, 0.2f),
          high = wide * dmg_range(b, 1.0f, 2.2f), slant = dmg_range(b, 0.1f, 0.7f), swing = dmg_range(b, 1.5f, 3.1f);
    bool round = dmg_chance(b, 0.5f), twin = dmg_chance(b, 0.5f), full = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_move(b, foot.x, foot.y, foot.z);
    dmg_turn(b, v3(0, 1, 0), turn);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.99f * column, 0), 0.4f * wide);
    uint32_t house = full ? dmg_spin(b, 0, "crane", v3(0, column, 0), v3(0, 1, 0))
                          : dmg_hinge(b, 0, "crane", v3(0, column, 0), v3(0, 1, 0), -swing, swing);
    if (round)
        dmg_rod(b, v3(0, column, 0), v3(0, column + high, 0), 0.55f * wide);
    else
        dmg_rounded_box(b, v3(0, column + 0.5f * high, 0), v3(wide, high, wide), 0.08f * wide);
    float z = 0.62f * wide, y = column + high * dmg_range(b, 0.15f, 0.4f), t = 0.12f * wide;
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.35f * wide - 0.5f * t, y - t, 0.3f * wide),
                     v3((float)s * 0.35f * wide + 0.5f * t, y + t, z + t));
    uint32_t jib = dmg_hinge(b, house, "jib", v3(0, y, z), v3(-1, 0, 0), -slant, 1.3f - slant);
    dmg_vec tip = v3(0, y + reach * sinf(slant), z + reach * cosf(slant));
    for (int s = -1; s <= 1; s += 2) {
        if (!twin && s > 0) break;
        float x = twin ? (float)s * 0.2f * wide : 0.0f;
        dmg_beam(b, v3(x, y, z), v3(0.4f * x, tip.y, tip.z), twin ? t : 3 * t, twin ? 1.6f * t : 2 * t);
    }
    dmg_rod(b, v3(-0.28f * wide, y, z), v3(0.28f * wide, y, z), 0.6f * t);
    dmg_rod(b, v3(-0.2f * wide, tip.y, tip.z), v3(0.2f * wide, tip.y, tip.z), 0.9f * t);
    draw_hook(b, jib, v3(0, tip.y - t, tip.z), 0.15f * reach);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- boats in davits, on the starboard side ---- */

static void draw_lifeboat(dmg_builder* b, dmg_vec keel, float length, float wide, bool covered) {
    static const dmg_xy SECTION[] = {{0, 0}, {0.7f, 0.25f}, {1, 1}, {-1, 1}, {-0.7f, 0.25f}};
    float deep = 0.55f * wide, half = 0.5f * wide;
    const dmg_row rows[] = {{0.1f * half, 0.7f * deep, 0.4f * deep, -0.5f * length},
                            {0.8f * half, 0.95f * deep, 0.08f * deep, -0.3f * length},
                            {half, deep, 0, 0},
                            {0.8f * half, 0.95f * deep, 0.08f * deep, 0.3f * length},
                            {0.1f * half, 0.7f * deep, 0.4f * deep, 0.5f * length}};
    dmg_save(b);
    dmg_move(b, keel.x, keel.y, keel.z);
    dmg_loft(b, SECTION, 5, rows, 5);
    if (covered) dmg_dome(b, v3(0, 0.99f * deep, 0), v3(0.85f * half, 0.6f * deep, 0.4f * length));
    dmg_restore(b);
}

/* Arms that lean out with the boat between them, or posts that each turn about their own foot. */
static void draw_davits(dmg_builder* b, const deck* d, float z, float length) {
    float gap = 0.32f * length, high = length * dmg_range(b, 0.4f, 0.6f), r = 0.025f * length, x = 0.82f * d->half,
          wide = length * dmg_range(b, 0.25f, 0.36f);
    bool radial = dmg_chance(b, 0.35f), covered = dmg_chance(b, 0.5f);
    float in = -1.3f * wide, way = high * dmg_range(b, 0.6f, 1.2f), out = dmg_range(b, 0.6f, 1.2f);
    uint32_t frame = 0;
    dmg_save(b);
    dmg_move(b, x, d->y, z);
    if (!radial) {
        frame = dmg_hinge(b, 0, "davits", v3(0, 2 * r, 0), v3(0, 0, -1), 0.0f, out);
        dmg_rod(b, v3(0, 2 * r, -gap), v3(0, 2 * r, gap), 0.5f * r);
    }
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * gap;
        dmg_use(b, 0);
        if (radial) {
            dmg_rod(b, v3(0, 0, at), v3(0, 0.3f * high, at), 1.7f * r);
            frame = dmg_hinge(b, 0, "davit", v3(0, 0.3f * high, at), v3(0, (float)s, 0), 0.0f, 2.6f);
        } else {
            for (int e = -1; e <= 1; e += 2)
                dmg_box_span(b, v3(-2 * r, 0, at + (float)e * 2 * r - 0.5f * r),
                             v3(2 * r, 3 * r, at + (float)e * 2 * r + 0.5f * r));
            dmg_use(b, frame);
        }
        const dmg_vec arm[] = {{0, radial ? 0.31f * high : 2 * r, at},
                               {radial ? 0 : 0.1f * high, 0.8f * high, at},
                               {0.3f * in, high, at},
                               {0.8f * in, 1.05f * high, at},
                               {in, 0.95f * high, at}};
        dmg_sweep(b, arm, 5, r, r, false);
        if (radial) dmg_rod(b, v3(in, 0.6f * high, at), v3(in, 0.95f * high, at), 0.2f * r);
    }
    if (!radial) {
        float keel = fmaxf(0.9f * high - 0.75f * wide, 0.05f * high);
        dmg_slide(b, frame, "lifeboat", v3(0, -1, 0), 0.0f, 0.1f * way);
        draw_lifeboat(b, v3(in, keel, 0), length, wide, covered);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(in, keel + 0.3f * wide, (float)s * gap), v3(in, 0.94f * high, (float)s * gap), 0.3f * r);
    } else {
        dmg_use(b, 0); /* on chocks, free of its arms */
        float keel = 0.06f * high;
        draw_lifeboat(b, v3(in, keel, 0), 0.85f * length, wide, covered);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(in - 0.3f * wide, 0, (float)s * 0.5f * gap - r),
                         v3(in + 0.3f * wide, keel + 0.3f * wide, (float)s * 0.5f * gap + r));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- hatches ---- */

static void draw_cover(dmg_builder* b, float x0, float x1, float y, float t, float z0, float z1, bool ribs) {
    dmg_box_span(b, v3(x0, y, z0), v3(x1, y + t, z1));
    for (int i = 0; i < 3 && ribs; ++i) {
        float x = x0 + (x1 - x0) * (0.2f + 0.3f * (float)i);
        dmg_box_span(b, v3(x - 0.3f * t, y + 0.9f * t, z0 + 0.05f * (z1 - z0)),
                     v3(x + 0.3f * t, y + 1.3f * t, z1 - 0.05f * (z1 - z0)));
    }
}

/* Draws one end's pair of leaves: the outer folds onto the inner, both stand up at the end; `s` tells which end. */
static void draw_fold_pair(dmg_builder* b, float half, float y, float t, float end, float leaf, float s) {
    float up = dmg_range(b, 1.2f, 1.7f), over = dmg_range(b, 1.5f, 3.1f);
    uint32_t inner = dmg_hinge(b, 0, "hatch_leaf", v3(0, y + 0.5f * t, end), v3(s, 0, 0), 0.0f, up);
    float joint = end - s * leaf, last = end - 1.98f * s * leaf, gap = 0.005f * leaf;
    draw_cover(b, -half, half, y, t, fminf(end, joint) + gap, fmaxf(end, joint) - gap, false);
    dmg_hinge(b, inner, "hatch_leaf", v3(0, y + t, joint), v3(s, 0, 0), 0.0f, over);
    draw_cover(b, -half, half, y, t, fminf(last, joint) + gap, fmaxf(last, joint) - gap, false);
    dmg_use(b, 0);
}

/* Covers that roll off a hatch: to both sides, or one under or over its neighbour along the ship. */
static void draw_rolling_covers(dmg_builder* b, float half, float y, float t, float z0, float z1) {
    bool aside = dmg_chance(b, 0.6f), ribs = dmg_chance(b, 0.6f);
    float middle = 0.5f * (z0 + z1), way = aside ? 0.9f * half : 0.48f * (z1 - z0);
    for (int i = 0; i < 2; ++i) {
        float s = i ? 1.0f : -1.0f, lift = !aside && i ? 1.45f * t : 0.0f;
        uint32_t leaf = dmg_slide(b, 0, "hatch_cover", aside ? v3(s, 0, 0) : v3(0, 0, -s), 0.0f, way);
        if (dmg_chance(b, 0.3f)) dmg_rest(b, leaf, 0.7f * way);
        if (aside)
            draw_cover(b, i ? 0.01f * half : -half, i ? half : -0.01f * half, y, t, z0, z1, ribs);
        else
            draw_cover(b, -half, half, y + lift, t, i ? middle : z0, i ? z1 : middle, ribs);
        dmg_use(b, 0);
    }
}

static void draw_hatch(dmg_builder* b, const deck* d, float z0, float z1) {
    float half = d->half * dmg_range(b, 0.35f, 0.55f), high = d->unit * dmg_range(b, 0.2f, 0.6f),
          t = d->unit * dmg_range(b, 0.06f, 0.16f), w = 0.08f * half, y = d->y + high;
    int kind = dmg_int(b, 0, 2);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (half - 0.5f * w), z = s < 0 ? z0 + 0.5f * w : z1 - 0.5f * w;
        dmg_box(b, v3(x, d->y + 0.5f * high, 0.5f * (z0 + z1)), v3(w, high, z1 - z0));
        dmg_box(b, v3(0, d->y + 0.5f * high, z), v3(2 * half - 2 * w, high, w));
    }
    y += 0.02f * t;
    if (kind == 0) {
        float leaf = 0.25f * (z1 - z0);
        draw_fold_pair(b, half, y, t, z0, leaf, -1);
        draw_fold_pair(b, half, y, t, z1, leaf, 1);
    } else if (kind == 1) {
        draw_rolling_covers(b, half, y, t, z0, z1);
    } else { /* leaves hung along both sides */
        int rows = dmg_int(b, 1, 3);
        float swing = dmg_range(b, 1.3f, 2.6f);
        for (int i = 0; i < 2 * rows; ++i) {
            float s = i & 1 ? 1.0f : -1.0f, each = (z1 - z0) / (float)rows, from = z0 + each * (float)(i / 2);
            dmg_hinge(b, 0, "hatch_leaf", v3(s * half, y + 0.5f * t, 0), v3(0, 0, -s), 0.0f, swing);
            draw_cover(b, i & 1 ? 0.01f * half : -half, i & 1 ? half : -0.01f * half, y, t, from + 0.01f * each,
                       from + 0.99f * each, false);
            dmg_use(b, 0);
        }
    }
}

/* ---- ground tackle ---- */

/* Chain wheels and warping heads on a shaft across the ship, between bearings; brakes by hand wheels, clutch levers. */
static void draw_windlass(dmg_builder* b, const deck* d, float z, float size) {
    float y = size * dmg_range(b, 0.45f, 0.7f), r = 0.75f * y;
    int heads = dmg_int(b, 1, 2);
    bool one = dmg_chance(b, 0.3f), wheels = dmg_chance(b, 0.6f), levers = dmg_chance(b, 0.5f);
    const dmg_xy drum[] = {
        {0, 0},         {0.6f * r, 0}, {0.5f * r, 0.15f * r}, {0.4f * r, 0.5f * r}, {0.5f * r, 0.9f * r},
        {0.65f * r, r}, {0, r}};
    const dmg_xy gypsy[] = {{0, 0},         {r, 0},         {r, 0.12f * r}, {0.7f * r, 0.28f * r},
                            {r, 0.45f * r}, {r, 0.57f * r}, {0, 0.57f * r}};
    dmg_save(b);
    dmg_move(b, 0, d->y, z);
    dmg_box(b, v3(0, 0.04f * size, 0), v3(2.2f * size, 0.08f * size, 1.3f * size));
    dmg_rounded_box(b, v3(0, 0.5f * y + 0.15f * r, -0.2f * size), v3(0.5f * size, y + 0.3f * r, 0.8f * size),
                    0.1f * size);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s, bearing = 0.3f * size + 0.75f * r;
        dmg_use(b, 0);
        dmg_box_span(b, v3(side * bearing - 0.06f * size, 0, -0.2f * size),
                     v3(side * bearing + 0.06f * size, y + 0.25f * r, 0.2f * size));
        dmg_spin(b, 0, "chain_wheel", v3(0, y, 0), v3(side, 0, 0));
        dmg_lathe(b, v3(side * 0.29f * size, y, 0), v3(side, 0, 0), gypsy, 7);
        if (!one) dmg_spin(b, 0, "warping_head", v3(0, y, 0), v3(side, 0, 0));
        for (int i = 0; i < heads; ++i)
            dmg_lathe(b, v3(side * (bearing + 0.08f * size + 0.99f * r * (float)i), y, 0), v3(side, 0, 0), drum, 7);
        if (one) dmg_rod(b, v3(side * 0.3f * size, y, 0), v3(side * (bearing + 0.1f * size), y, 0), 0.15f * r);
        dmg_use(b, 0);
        dmg_wall_enter(b, v3(side * 0.18f * size, 0.6f * y, -0.6f * size), DMG_PI);
        if (wheels) dmg_wall_wheel_draw(b, 0, "brake", 0.14f * size);
        dmg_restore(b);
        dmg_roof_enter(b, v3(side * 0.95f * size, 0.08f * size, -0.5f * size));
        if (levers) dmg_wall_stick_draw(b, 0, "clutch", 0.5f * size);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_capstan(dmg_builder* b, dmg_vec at, float r) {
    int whelps = dmg_int(b, 0, 7);
    bool bars = dmg_chance(b, 0.3f);
    const dmg_xy body[] = {{0, 0},
                           {r, 0},
                           {r, 0.2f * r},
                           {0.6f * r, 0.6f * r},
                           {0.6f * r, 1.1f * r},
                           {0.9f * r, 1.6f * r},
                           {0.9f * r, 1.9f * r},
                           {0, 2.0f * r}};
    dmg_rod(b, at, v3(at.x, at.y + 0.12f * r, at.z), 1.2f * r);
    dmg_spin(b, 0, "capstan", at, v3(0, 1, 0));
    dmg_save(b);
    dmg_move(b, at.x, at.y + 0.13f * r, at.z);
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), body, 8);
    for (int i = 0; i < whelps; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, whelps);
        dmg_beam(b, v3(0.72f * r, 0.3f * r, 0), v3(0.65f * r, 1.5f * r, 0), 0.12f * r, 0.3f * r);
        if (bars) dmg_rod(b, v3(0.8f * r, 1.75f * r, 0), v3(2.6f * r, 1.75f * r, 0), 0.08f * r);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Rollers for the warps, ventilators trimmed to the wind, bollards, manholes. */
static void draw_small(dmg_builder* b, const deck* d, float x, float z) {
    float r = d->unit * dmg_range(b, 0.06f, 0.14f), high = d->unit * dmg_range(b, 0.3f, 0.8f);
    switch (dmg_int(b, 0, 4)) {
    case 0:
        dmg_box(b, v3(x, d->y + 0.3f * r, z), v3(3 * r, 0.6f * r, 6 * r));
        for (int i = 0; i < 2; ++i) {
            float at = z + (i ? 1.5f : -1.5f) * r;
            dmg_spin(b, 0, "roller", v3(x, d->y, at), v3(0, 1, 0));
            dmg_rod(b, v3(x, d->y + 0.62f * r, at), v3(x, d->y + 2.6f * r, at), r);
            dmg_use(b, 0);
        }
        break;
    case 1: { /* a cowl */
        dmg_rod(b, v3(x, d->y, z), v3(x, d->y + 0.5f * high, z), 1.1f * r);
        const dmg_vec bend[] = {{x, d->y + 0.51f * high, z},
                                {x, d->y + high, z},
                                {x, d->y + high + 0.8f * r, z + 0.6f * r},
                                {x, d->y + high + r, z + 1.8f * r}};
        dmg_spin(b, 0, "cowl", v3(x, 0, z), v3(0, 1, 0));
        dmg_sweep(b, bend, 4, r, r, false);
        dmg_cone(b, v3(x, d->y + high + r, z + 1.7f * r), v3(x, d->y + high + r, z + 2.4f * r), r, 1.7f * r);
        break;
    }
    case 2:
        dmg_rod(b, v3(x, d->y, z), v3(x, d->y + 0.6f * high, z), r);
        dmg_screw(b, 0, "mushroom", v3(x, d->y + 0.6f * high, z), v3(0, 1, 0), 0.03f * r, 0.0f, 9.0f);
        dmg_dome(b, v3(x, d->y + 0.62f * high, z), v3(1.9f * r, 0.9f * r, 1.9f * r));
        dmg_rod(b, v3(x, d->y + 0.62f * high + 0.8f * r, z), v3(x, d->y + 0.62f * high + 1.2f * r, z), 0.3f * r);
        break;
    case 3:
        dmg_box(b, v3(x, d->y + 0.15f * r, z), v3(3 * r, 0.3f * r, 7 * r));
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3(x, d->y, z + 2 * r * (float)s), v3(x, d->y + 3 * r, z + 2 * r * (float)s), r);
        break;
    default:
        dmg_roof_enter(b, v3(x, d->y, z));
        dmg_wall_lid_draw(b, 0, "manhole", 2.2f * r);
        dmg_restore(b);
        break;
    }
    dmg_use(b, 0);
}

/* ---- the house ---- */

/* On the wall z = 0: a leaf on lugs in a raised frame, held by clips round it or by one wheel. */
static void draw_tight_door(dmg_builder* b, float wide, float high) {
    float t = 0.07f * wide, side = dmg_sign(b), swing = dmg_range(b, 1.4f, 2.4f), rim = 0.1f * wide;
    int clips = dmg_int(b, 0, 3);
    bool on_leaf = dmg_chance(b, 0.4f), pane = dmg_chance(b, 0.4f);
    dmg_save(b);
    if (side < 0.0f) dmg_mirror(b, v3(1, 0, 0));
    dmg_move(b, 0, 0, 0.6f * t);
    dmg_frame_draw(b, wide + 2.1f * rim, high + 2.1f * rim, 0.6f * t, rim);
    float pin = -0.5f * wide - 0.25f * rim;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(pin, 0.3f * high * (float)s - 0.1f * wide, 0.5f * t),
                v3(pin, 0.3f * high * (float)s + 0.1f * wide, 0.5f * t), 0.4f * t);
    uint32_t door = dmg_hinge(b, 0, "door", v3(pin, 0, 0.5f * t), v3(0, -1, 0), 0.0f, swing);
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(pin, 0.3f * high * (float)s - 0.09f * wide, 0.9f * t),
                     v3(pin + 0.4f * wide, 0.3f * high * (float)s + 0.09f * wide, 1.2f * t));
    dmg_move(b, 0, 0, t);
    dmg_rounded_plate(b, wide, high, t, 0.2f * wide);
    if (pane) dmg_torus(b, v3(0, 0.25f * high, 0), v3(0, 0, 1), 0.18f * wide, 0.04f * wide);
    dmg_move(b, 0, 0, 0.3f * t);
    for (int i = 0; i < clips; ++i) { /* along the free side */
        float y = high * 0.8f * (((float)i + 0.5f) / (float)clips - 0.5f),
              x = on_leaf ? 0.4f * wide : 0.5f * wide + 0.7f * rim, l = 0.28f * wide;
        dmg_use(b, on_leaf ? door : 0);
        dmg_rod(b, v3(x, y, on_leaf ? -0.4f * t : -1.9f * t), v3(x, y, 0.4f * t), 0.25f * t);
        dmg_hinge(b, on_leaf ? door : 0, "clip", v3(x, y, 0), v3(0, 0, 1), -1.57f, 1.57f);
        dmg_rod(b, v3(x, y, 0.1f * t), v3(x, y, t), 0.5f * t);
        dmg_box_span(b, v3(on_leaf ? x : x - l, y - 0.3f * t, 0.2f * t),
                     v3(on_leaf ? x + l : x, y + 0.3f * t, 0.8f * t));
    }
    dmg_move(b, 0, 0, -0.3f * t);
    dmg_use(b, door);
    if (clips == 0) dmg_wall_wheel_draw(b, door, "door_wheel", 0.22f * wide);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a block across the deck from z0 to z1, doors in the wall that faces along `s`, another block on top at times.
 */
static void draw_house(dmg_builder* b, const deck* d, float z0, float z1, float s) {
    float half = d->half * dmg_range(b, 0.5f, 0.85f), door = d->unit * dmg_range(b, 0.3f, 0.4f),
          high = door * dmg_range(b, 2.3f, 2.9f), deep = z1 - z0;
    int doors = dmg_int(b, 1, 2), ports = dmg_int(b, 0, 3);
    bool bridge = dmg_chance(b, 0.6f);
    dmg_box_span(b, v3(-half, d->y, z0), v3(half, d->y + high, z1));
    if (bridge) {
        dmg_box_span(b, v3(-1.05f * half, d->y + high, z0 + 0.1f * deep), v3(1.05f * half, d->y + 1.04f * high, z1));
        dmg_box_span(b, v3(-0.7f * half, d->y + high, z0 + 0.2f * deep),
                     v3(0.7f * half, d->y + 1.8f * high, z1 - 0.15f * deep));
    }
    dmg_wall_enter(b, v3(0, d->y, s > 0.0f ? z1 : z0), s > 0.0f ? 0.0f : DMG_PI);
    for (int i = 0; i < doors; ++i) {
        dmg_save(b);
        dmg_move(b, doors > 1 ? (i ? 0.6f : -0.6f) * half : 0, 0.5f * high, 0);
        draw_tight_door(b, door, 1.8f * door);
        dmg_restore(b);
    }
    dmg_restore(b);
    for (int i = 0; i < ports; ++i) { /* dead lights on the side, hung on top */
        float r = 0.25f * door, z = z0 + deep * ((float)i + 0.5f) / (float)ports;
        dmg_wall_enter(b, v3(half, d->y + 0.6f * high, z), 0.5f * DMG_PI);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), r, 0.15f * r);
        dmg_hinge(b, 0, "port_lid", v3(0, 1.1f * r, 0.25f * r), v3(-1, 0, 0), 0.0f, 1.6f);
        dmg_rod(b, v3(0, 0, 0.17f * r), v3(0, 0, 0.35f * r), 0.95f * r);
        dmg_box_span(b, v3(-0.2f * r, 0.8f * r, 0.17f * r), v3(0.2f * r, 1.2f * r, 0.33f * r));
        dmg_use(b, 0);
        dmg_restore(b);
    }
    float lamp = 0.12f * high, top = d->y + high * (bridge ? 1.8f : 1.0f), z = 0.5f * (z0 + z1);
    if (!dmg_chance(b, 0.5f)) return;
    dmg_rod(b, v3(0, top, z), v3(0, top + lamp, z), 0.3f * lamp);
    uint32_t pan = dmg_spin(b, 0, "lamp_yoke", v3(0, 0, z), v3(0, 1, 0));
    dmg_box(b, v3(0, top + 1.15f * lamp, z), v3(1.9f * lamp, 0.25f * lamp, 0.5f * lamp));
    for (int e = -1; e <= 1; e += 2)
        dmg_box(b, v3((float)e * 0.9f * lamp, top + 1.7f * lamp, z), v3(0.14f * lamp, 1.3f * lamp, 0.5f * lamp));
    dmg_hinge(b, pan, "searchlight", v3(0, top + 2.1f * lamp, z), v3(-1, 0, 0), -0.4f, 0.8f);
    dmg_rod(b, v3(0, top + 2.1f * lamp, z - 0.5f * lamp), v3(0, top + 2.1f * lamp, z + 0.6f * lamp), 0.75f * lamp);
    dmg_use(b, 0);
}

/* ---- hull and its ends ---- */

/* Draws the plan of the bow beyond its shoulder, as outlines (x, -z). */
static void draw_bow(dmg_builder* b, const deck* d, float length, float wall) {
    float h = d->half, z = d->bow, low = 0.35f * d->y, swing = dmg_range(b, 0.6f, 1.2f);
    int kind = dmg_int(b, 0, 3); /* fixed twice, a visor, doors that part */
    const dmg_xy whole[] = {
        {h, -z}, {-h, -z}, {-0.75f * h, -z - 0.5f * length}, {0, -z - length}, {0.75f * h, -z - 0.5f * length}};
    const dmg_xy right[] = {{0.01f * h, -z}, {0.01f * h, -z - length}, {0.75f * h, -z - 0.5f * length}, {h, -z}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    if (kind < 2) {
        dmg_extrude(b, whole, 5, 0, d->y);
    } else if (kind == 2) {
        dmg_extrude(b, whole, 5, 0, 0.99f * low);
        dmg_hinge(b, 0, "bow_visor", v3(0, -z, d->y + wall), v3(-1, 0, 0), 0.0f, swing);
        dmg_extrude(b, whole, 5, low, d->y + wall);
    } else {
        dmg_extrude(b, whole, 5, 0, 0.99f * low);
        for (int s = 0; s < 2; ++s) {
            if (s) dmg_mirror(b, v3(1, 0, 0));
            dmg_hinge(b, 0, "bow_door", v3(h, -z, 0), v3(0, 0, -1), 0.0f, 1.4f * swing);
            dmg_extrude(b, right, 4, low, d->y + wall);
            dmg_use(b, 0);
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (kind < 2) return;
    float inner = 0.5f * h; /* the ramp behind it, upright against the hull */
    dmg_hinge(b, 0, "bow_ramp", v3(0, d->y + 0.02f * h, z - 0.1f * h), v3(1, 0, 0), 0.0f, 1.5f);
    dmg_box_span(b, v3(-inner, d->y + 0.03f * h, z - 0.12f * h), v3(inner, d->y + 1.2f * h, z - 0.06f * h));
    dmg_use(b, 0);
}

/* Side walls aft with a ramp between them that is let down, a flap at its end. */
static void draw_stern_ramp(dmg_builder* b, const deck* d, float deep) {
    float half = 0.8f * d->half, high = d->half * dmg_range(b, 0.8f, 1.5f), t = 0.06f * d->half, z = d->stern;
    bool flap = dmg_chance(b, 0.6f);
    float way = dmg_range(b, 1.4f, 1.9f), part = flap ? 0.75f : 1.0f;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.9f * d->half;
        dmg_box_span(b, v3(x - 0.09f * d->half, d->y, z), v3(x + 0.09f * d->half, d->y + high, z + deep));
        dmg_box_span(b, v3((float)s * 0.45f * half - 2 * t, d->y - t, z - t),
                     v3((float)s * 0.45f * half + 2 * t, d->y, z));
    }
    uint32_t ramp = dmg_hinge(b, 0, "stern_ramp", v3(0, d->y + 0.3f * t, z), v3(-1, 0, 0), 0.0f, way);
    dmg_box_span(b, v3(-half, d->y + 0.1f * t, z), v3(half, d->y + part * high, z + t));
    for (int i = -1; i <= 1; ++i)
        dmg_box_span(b, v3(0.6f * half * (float)i - t, d->y + 0.5f * t, z - t),
                     v3(0.6f * half * (float)i + t, d->y + part * high, z + 0.5f * t));
    if (flap) {
        dmg_hinge(b, ramp, "ramp_flap", v3(0, d->y + 0.755f * high, z + 0.5f * t), v3(-1, 0, 0), 0.0f, 0.6f);
        dmg_box_span(b, v3(-half, d->y + 0.76f * high, z + 0.2f * t), v3(half, d->y + high, z + 0.8f * t));
    }
    dmg_use(b, 0);
}

/* Draws the deck between two places along the ship. */
static void draw_hold(dmg_builder* b, const deck* d, float z0, float z1, int kind) {
    float length = z1 - z0, edge = 0.14f * length;
    if (kind < 4) draw_hatch(b, d, z0 + edge, z1 - edge);
    float reach = length * dmg_range(b, 0.7f, 0.95f), x = 0.75f * d->half;
    dmg_vec end = v3(0, d->y, z0 + 0.4f * edge);
    if (kind == 1) draw_crane(b, v3(x, d->y, z0 + 0.5f * edge), reach, 0.0f);
    if (kind == 2) draw_derrick(b, end, reach, 0.0f);
    for (int s = -1; s <= 1 && kind == 3; s += 2)
        draw_derrick(b, v3((float)s * 0.5f * d->half, d->y, end.z), reach, 0.0f);
    if (kind == 4) draw_davits(b, d, 0.5f * (z0 + z1), fminf(0.8f * length, 1.1f * d->half));
    if (kind == 5) draw_crane(b, v3(0, d->y, 0.5f * (z0 + z1)), 0.8f * reach, DMG_PI * dmg_unit(b));
    if (kind < 4) return;
    dmg_mirror(b, v3(1, 0, 0));
    if (dmg_chance(b, 0.5f)) draw_davits(b, d, 0.5f * (z0 + z1), fminf(0.8f * length, 1.1f * d->half));
    dmg_mirror(b, v3(1, 0, 0));
}

void dmg_build_ship_deck(dmg_builder* b) {
    deck d = {.half = dmg_scale_range(b, 1.0f, 9.0f)};
    d.y = d.half * dmg_range(b, 0.3f, 0.9f);
    d.unit = 0.5f * d.half;
    int holds = dmg_int(b, 1, 3), last = -1;
    float each = d.half * dmg_range(b, 1.8f, 2.6f), fore = d.half * dmg_range(b, 1.0f, 1.6f),
          aft = d.half * dmg_range(b, 1.0f, 1.5f), bow = d.half * dmg_range(b, 0.9f, 1.8f);
    bool ramp = dmg_chance(b, 0.35f), amid = dmg_chance(b, 0.3f), tackle = dmg_chance(b, 0.7f);
    float length = each * (float)holds + fore + 2 * aft;
    d.stern = -0.5f * length;
    d.bow = 0.5f * length;
    dmg_box_span(b, v3(-d.half, 0, d.stern), v3(d.half, d.y, d.bow));
    draw_bow(b, &d, bow, 0.12f * d.half);
    if (ramp) draw_stern_ramp(b, &d, 0.8f * aft);
    float z = d.stern + aft;
    bool housed = dmg_chance(b, 0.8f);
    if (housed && !amid) draw_house(b, &d, z, z + 0.9f * aft, 1);
    if (!amid) z += aft;
    for (int i = 0; i < holds; ++i) {
        int kind = dmg_int(b, 0, 5);
        if (kind == last) kind = (kind + 1) % 6;
        draw_hold(b, &d, z, z + each, kind);
        last = kind;
        z += each;
        if (amid && i == 0) {
            if (housed) draw_house(b, &d, z, z + 0.9f * aft, -1);
            z += aft;
        }
    }
    float size = d.half * dmg_range(b, 0.28f, 0.4f);
    if (tackle)
        draw_windlass(b, &d, z + 0.45f * fore, size);
    else
        draw_capstan(b, v3(0, d.y, z + 0.4f * fore), 0.4f * size);
    for (int s = -1; s <= 1; s += 2) {
        draw_small(b, &d, (float)s * 0.88f * d.half, z + 0.3f * fore);
        if (!ramp) draw_small(b, &d, (float)s * 0.75f * d.half, d.stern + 0.5f * aft);
    }
    if (!ramp && dmg_chance(b, 0.5f)) draw_capstan(b, v3(0, d.y, d.stern + 0.4f * aft), 0.4f * size);
}
