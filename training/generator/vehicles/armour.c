/* Draws gun vehicles and mounts: hulls on tracks or wheels with a turret, a gun in the hull's front or a troop bay
 * with a ramp; guns on a drum. Turrets turn, guns rise and recoil, hatches swing, swivel or slide. Ahead is +Z. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/works.h"

/* ---- hatches in a roof: at the origin, facing +Y, ahead +Z ---- */

static void draw_lid(dmg_builder* b, float r, float t, bool round) {
    if (round)
        dmg_rod(b, v3(0, 0, 0), v3(0, t, 0), r);
    else
        dmg_box_span(b, v3(-r, 0, -r), v3(r, t, r));
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, t, 0), v3(0.7f * r, 0.6f * t, 0.15f * r));
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, t, 0.3f * r), v3(0, 2.2f * t, 0.3f * r), 0.18f * r);
}

/* Draws one leaf that swings up, swivels on a pin or slides, or two that part. */
static void draw_roof_hatch(dmg_builder* b, uint32_t parent, const char* name, float r) {
    float t = r * dmg_range(b, 0.1f, 0.3f), y = r * dmg_range(b, 0.05f, 0.3f), turn = dmg_range(b, 0, 2 * DMG_PI);
    int kind = dmg_weighted(b, (const float[]){4, 2, 1, 2}, 4);
    bool round = dmg_chance(b, 0.6f), plain = dmg_chance(b, 0.5f);
    dmg_use(b, parent);
    dmg_save(b);
    if (plain) turn = 0.5f * DMG_PI * roundf(turn / (0.5f * DMG_PI));
    dmg_turn(b, v3(0, 1, 0), turn);
    if (round)
        dmg_rod(b, v3(0, -0.2f * r, 0), v3(0, y, 0), 1.08f * r);
    else
        dmg_box_span(b, v3(-1.06f * r, -0.2f * r, -1.06f * r), v3(1.06f * r, y, 1.06f * r));
    dmg_move(b, 0, y, 0);
    float swing = dmg_range(b, 1.2f, 2.8f), line = t * dmg_range(b, 0.3f, 1.0f);
    if (kind == 0) {
        dmg_hinge(b, parent, name, v3(0, line, -1.08f * r), v3(-1, 0, 0), 0.0f, swing);
        draw_lid(b, r, t, round);
        dmg_box(b, v3(0, 0.5f * t, -0.95f * r), v3(0.7f * r, 0.9f * t, 0.3f * r));
        dmg_rod(b, v3(-0.4f * r, line, -1.08f * r), v3(0.4f * r, line, -1.08f * r), 0.08f * r);
    }
    if (kind == 1) {
        float x = 1.1f * r;
        dmg_rod(b, v3(x, -0.1f * r, 0), v3(x, t, 0), 0.15f * r);
        dmg_hinge(b, parent, name, v3(x, 0, 0), v3(0, dmg_sign(b), 0), -swing, 0.0f);
        draw_lid(b, r, t, round);
        dmg_beam(b, v3(x, 1.1f * t, 0), v3(0, 1.1f * t, 0), 0.3f * r, 0.3f * t);
    }
    if (kind == 2) {
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 1.1f * r, 0.3f * t, -0.7f * r), v3(0.12f * r, 1.2f * t, 3.2f * r));
        dmg_slide(b, parent, name, v3(0, 0, -1), 0.0f, 1.6f * r);
        draw_lid(b, r, t, round);
    }
    for (int s = -1; s <= 1 && kind == 3; s += 2) {
        float side = (float)s;
        dmg_use(b, parent);
        dmg_hinge(b, parent, name, v3(side * 1.04f * r, line, 0), v3(0, 0, -side), 0.0f, swing);
        dmg_box_span(b, v3(s > 0 ? 0.01f * r : -r, 0, -r), v3(s > 0 ? r : -0.01f * r, t, r));
        dmg_rod(b, v3(side * 1.04f * r, line, -0.8f * r), v3(side * 1.04f * r, line, 0.8f * r), 0.07f * r);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* ---- guns: the trunnion at the origin ---- */

typedef struct gun {
    float length, radius;
    int mantlet, muzzle, barrels;
    bool recoils;
} gun;

static gun pick_gun(dmg_builder* b, float length) {
    gun g = {.length = length, .radius = length * dmg_range(b, 0.015f, 0.04f)};
    g.mantlet = dmg_int(b, 0, 3);
    g.muzzle = dmg_int(b, 0, 3);
    g.barrels = dmg_weighted(b, (const float[]){0, 5, 1.5f}, 3);
    g.recoils = dmg_chance(b, 0.3f);
    return g;
}

static void draw_barrel(dmg_builder* b, const gun* g, float x) {
    float r = g->radius, l = g->length;
    dmg_cone(b, v3(x, 0, 0), v3(x, 0, l), 1.2f * r, dmg_range(b, 0.7f, 1.2f) * r);
    if (g->muzzle == 1) dmg_box(b, v3(x, 0, 0.97f * l), v3(4 * r, 2.4f * r, 4 * r));
    if (g->muzzle == 2) dmg_rod(b, v3(x, 0, 0.93f * l), v3(x, 0, 1.01f * l), 1.7f * r);
    if (g->muzzle == 3) dmg_rod(b, v3(x, 0, 0.45f * l), v3(x, 0, 0.65f * l), 1.8f * r);
}

/* Rises about the line across; what follows belongs to the gun. */
static uint32_t draw_gun(dmg_builder* b, uint32_t parent, const gun* g, float low, float high) {
    float r = g->radius, wide = r * dmg_range(b, 2.0f, 5.0f), apart = g->barrels > 1 ? 2.5f * r : 0.0f;
    uint32_t mount = dmg_hinge_across(b, parent, "gun", v3(0, 0, 0), low, high);
    if (g->mantlet == 0) dmg_box(b, v3(0, 0, wide), v3(2 * (wide + apart), 1.6f * wide, 1.4f * wide));
    if (g->mantlet == 1) dmg_rod(b, v3(-wide - apart, 0, 0), v3(wide + apart, 0, 0), 1.2f * wide);
    if (g->mantlet == 2) dmg_ellipsoid(b, v3(0, 0, 0.3f * wide), v3(wide + apart, wide, 1.5f * wide));
    if (g->mantlet == 3) dmg_cone(b, v3(0, 0, 0), v3(0, 0, 3 * wide), 1.2f * wide + apart, 1.5f * r + apart);
    for (int i = 0; i < g->barrels; ++i) {
        float x = g->barrels > 1 ? (i ? apart : -apart) : 0.0f;
        dmg_use(b, mount);
        if (g->recoils) {
            dmg_rod(b, v3(x, 0, 0), v3(x, 0, 0.3f * g->length), 1.7f * r);
            dmg_slide(b, mount, "barrel", v3(0, 0, -1), 0.0f, g->length * dmg_range(b, 0.05f, 0.2f));
        }
        draw_barrel(b, g, x);
    }
    dmg_use(b, mount);
    return mount;
}

/* Draws a machine gun on a pintle that turns on what carries it, and rises. */
static void draw_pintle(dmg_builder* b, uint32_t parent, float size) {
    float y = 0.25f * size, r = 0.025f * size;
    dmg_use(b, parent);
    uint32_t post = parent;
    dmg_rod(b, v3(0, -0.1f * size, 0), v3(0, 0.1f * size, 0), 2.5f * r);
    if (dmg_chance(b, 0.7f)) post = dmg_spin(b, parent, "pintle", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.9f * y, 0), 1.5f * r);
    dmg_box(b, v3(0, y, 0), v3(5 * r, 3 * r, 3 * r));
    dmg_hinge_across(b, post, "machine_gun", v3(0, y, 0), -0.2f, dmg_range(b, 0.5f, 1.2f));
    dmg_box(b, v3(0, y + 2 * r, -0.1f * size), v3(3 * r, 4 * r, 0.5f * size));
    dmg_rod(b, v3(0, y + 2 * r, 0.1f * size), v3(0, y + 2 * r, 0.7f * size), r);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(-4 * r, y + r, 0), v3(4 * r, 5 * r, 6 * r));
    dmg_use(b, parent);
}

/* ---- turrets: their ring at the origin ---- */

typedef struct turret {
    float r, high;
    int shape;
} turret;

static const dmg_xy facets[] = {{0.45f, 1.1f},  {-0.45f, 1.1f}, {-1.0f, 0.4f},  {-0.95f, -0.9f},
                                {-0.6f, -1.3f}, {0.6f, -1.3f},  {0.95f, -0.9f}, {1.0f, 0.4f}};

static void draw_turret_shell(dmg_builder* b, const turret* t) {
    float r = t->r, h = t->high;
    const dmg_xy bowl[] = {{0, 0}, {r, 0}, {1.02f * r, 0.25f * h}, {0.85f * r, 0.7f * h}, {0.55f * r, h}, {0, h}};
    if (t->shape == 0) dmg_cone(b, v3(0, 0, 0), v3(0, h, 0), r, 0.85f * r);
    if (t->shape == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), bowl, 6);
    if (t->shape == 2) { /* plates */
        const dmg_row rows[] = {{0.8f * r, 0.8f * r, 0, 0}, {r, r, 0, 0.3f * h}, {0.75f * r, 0.75f * r, 0, h}};
        dmg_save(b);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* its y is behind */
        dmg_turn(b, v3(0, 0, 1), DMG_PI);
        dmg_loft(b, facets, 8, rows, 3);
        dmg_restore(b);
    }
    if (t->shape == 3) { /* a wedge with a bustle */
        const dmg_xy side[] = {{-1.5f * r, 0.3f * h}, {-0.8f * r, 0}, {0.9f * r, 0},
                               {1.1f * r, 0.35f * h}, {0.7f * r, h},  {-1.5f * r, h}};
        dmg_side_prism(b, side, 6, -0.85f * r, 0.85f * r);
    }
    if (t->shape == 4) dmg_box_span(b, v3(-0.8f * r, 0, -r), v3(0.8f * r, h, 0.9f * r));
}

/* Draws what stands on its roof and its sides. */
static void draw_turret_things(dmg_builder* b, const turret* t, uint32_t id) {
    float r = t->r, hatch = r * dmg_range(b, 0.18f, 0.28f), side = dmg_sign(b), x = side * 0.38f * r, z = -0.15f * r;
    bool cupola = dmg_chance(b, 0.4f);
    dmg_save(b);
    dmg_move(b, x, t->high, z);
    uint32_t carrier = id;
    if (cupola) {
        carrier = dmg_spin(b, id, "cupola", v3(0, 0, 0), v3(0, dmg_sign(b), 0));
        dmg_rod(b, v3(0, -0.3f * hatch, 0), v3(0, 0.5f * hatch, 0), 1.25f * hatch);
        int slits = dmg_int(b, 0, 6);
        for (int i = 0; i < slits; ++i) {
            dmg_save(b);
            dmg_turn_to(b, v3(0, 1, 0), i, slits);
            dmg_box(b, v3(1.22f * hatch, 0.3f * hatch, 0), v3(0.2f * hatch, 0.25f * hatch, 0.4f * hatch));
            dmg_restore(b);
        }
        dmg_move(b, 0, 0.5f * hatch, 0);
    }
    draw_roof_hatch(b, carrier, "hatch", hatch);
    if (dmg_chance(b, 0.35f)) {
        dmg_move(b, 0, 0, 1.35f * hatch);
        draw_pintle(b, carrier, 2.2f * hatch);
    }
    dmg_restore(b);
    dmg_use(b, id);
    if (dmg_chance(b, 0.5f)) {
        dmg_save(b);
        dmg_move(b, -x, t->high, z);
        draw_roof_hatch(b, id, "loader_hatch", 0.85f * hatch);
        dmg_restore(b);
    }
    if (dmg_chance(b, 0.4f))
        dmg_rod(b, v3(-0.4f * x, t->high, -0.5f * r), v3(-0.4f * x, t->high + 0.8f * r, -0.5f * r), 0.01f * r);
    if (!dmg_chance(b, 0.3f)) return;
    /* Boxes of missiles at its sides that rise. */
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec pin = {(float)s * 1.12f * r, 0.6f * t->high, -0.3f * r};
        dmg_use(b, id);
        dmg_rod(b, v3((float)s * 0.6f * r, pin.y, pin.z), pin, 0.08f * r);
        dmg_hinge_across(b, id, "launcher", pin, 0.0f, dmg_range(b, 0.4f, 1.2f));
        dmg_box(b, v3_add(pin, v3((float)s * 0.12f * r, 0.1f * r, 0.2f * r)), v3(0.24f * r, 0.3f * r, 1.1f * r));
    }
    dmg_use(b, id);
}

/* `drop`: how far below its line the gun may point. */
static void draw_turret(dmg_builder* b, float r, float reach, float drop) {
    turret t = {.r = r, .high = r * dmg_range(b, 0.4f, 0.8f)};
    t.shape = dmg_int(b, 0, 4);
    float arc = dmg_range(b, 1.0f, 3.1f), rise = dmg_range(b, 0.3f, 0.9f), line = 0.5f * t.high;
    dmg_rod(b, v3(0, -0.1f * r, 0), v3(0, 0.04f * r, 0), 0.85f * r);
    dmg_vec axis = {0, dmg_sign(b), 0};
    uint32_t id = dmg_chance(b, 0.6f) ? dmg_spin(b, 0, "turret", v3(0, 0, 0), axis)
                                      : dmg_hinge(b, 0, "turret", v3(0, 0, 0), axis, -arc, arc);
    dmg_move(b, 0, 0.05f * r, 0);
    draw_turret_shell(b, &t);
    gun g = pick_gun(b, reach);
    dmg_save(b);
    dmg_move(b, 0, line, 0.85f * r);
    uint32_t mount = draw_gun(b, id, &g, -fminf(drop, (line + 0.05f * r) / reach), rise);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(4 * g.radius, 0, 0), v3(4 * g.radius, 0, 0.3f * reach), 0.4f * g.radius);
    dmg_use(b, mount);
    dmg_restore(b);
    dmg_use(b, id);
    draw_turret_things(b, &t, id);
    dmg_use(b, 0);
}

/* ---- running gear ---- */

typedef struct hull {
    float length, half, deck, low;  /* half width, heights of the deck and of the sponsons' underside */
    float front, rear, nose, stern; /* ends of the deck, ends of the hull, along z */
    float track, high;              /* width and height of a track */
} hull;

/* Draws a loop of track round wheels that turn; drawn for one side. */
static void draw_track(dmg_builder* b, const hull* h, float side) {
    float a = 0.5f * h->length, t = 0.06f * h->high + 0.004f * h->length, mid = 0.5f * h->high,
          up = dmg_range(b, 0.75f, 0.9f), x = side * (h->half - 0.5f * h->track);
    const dmg_xy outer[] = {{-up * a, 0},        {up * a, 0},          {a, 0.45f * h->high},  {a, 0.75f * h->high},
                            {0.9f * a, h->high}, {-0.9f * a, h->high}, {-a, 0.75f * h->high}, {-a, 0.45f * h->high}};
    dmg_xy inner[8];
    for (int i = 0; i < 8; ++i)
        inner[i] = (dmg_xy){outer[i].x * (a - t) / a, mid + (outer[i].y - mid) * (mid - t) / mid};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_ring_plate(b, outer, inner, 8, -x - 0.5f * h->track, -x + 0.5f * h->track);
    dmg_restore(b);
    int count = dmg_int(b, 3, 7), kind = dmg_int(b, 0, 2), spokes = dmg_int(b, 5, 8);
    float span = 2 * up * a - 0.3f * h->high, r = fminf(0.42f * h->high, 0.48f * span / (float)count),
          end = 0.2f * h->high;
    for (int i = 0; i < count + 2; ++i) {
        bool ends = i >= count;
        float z = ends ? (i > count ? 1.0f : -1.0f) * (a - t - 1.15f * end)
                       : span * (((float)i + 0.5f) / (float)count - 0.5f);
        float y = ends ? 0.62f * h->high : t + r;
        if (ends) z = (z > 0 ? 1.0f : -1.0f) * (a - t - 1.25f * end);
        dmg_use(b, 0);
        dmg_rod(b, v3(side * (h->half - h->track - 0.02f * h->half), y, z), v3(x, y, z), 0.25f * end);
        dmg_save(b);
        dmg_move(b, x, y, z);
        dmg_turn(b, v3(0, 1, 0), side * 0.5f * DMG_PI);
        dmg_spin(b, 0, ends ? "sprocket" : "road_wheel", v3(0, 0, 0), v3(0, 0, dmg_sign(b)));
        if (ends)
            dmg_wheel_draw(b, i == count ? 4 : kind, end, 0.7f * h->track, 7);
        else
            dmg_wheel_draw(b, kind, r, 0.8f * h->track, spokes);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

static void draw_wheels(dmg_builder* b, const hull* h) {
    int axles = dmg_int(b, 2, 4);
    dmg_tyre tyre = dmg_tyre_pick(b, fminf(0.55f * h->high, 0.45f * h->length / (float)axles));
    tyre.width = 0.75f * h->track;
    for (int i = 0; i < axles; ++i) {
        float z = h->length * 0.86f * (((float)i + 0.5f) / (float)axles - 0.5f);
        tyre.steers = i == axles - 1 && dmg_chance(b, 0.4f);
        tyre.knuckle = 0;
        dmg_axle_draw(b, &tyre, 0, h->half - 0.4f * h->track, z);
    }
}

/* Plates over the tracks that swing up on their upper edge. */
static void draw_skirts(dmg_builder* b, const hull* h) {
    int count = dmg_int(b, 2, 4);
    float t = 0.02f * h->half, y = h->low, length = 0.8f * h->length / (float)count, drop = 0.6f * h->low;
    for (int s = -1; s <= 1; s += 2)
        for (int i = 0; i < count; ++i) {
            float side = (float)s, z = length * ((float)i - 0.5f * (float)(count - 1)), x = side * (h->half + 1.5f * t);
            dmg_hinge(b, 0, "skirt", v3(x, y, z), v3(0, 0, side), 0.0f, dmg_range(b, 1.0f, 1.6f));
            dmg_box_span(b, v3(x - t, y - drop, z - 0.49f * length), v3(x + t, y, z + 0.49f * length));
            dmg_rod(b, v3(x, y, z - 0.3f * length), v3(x, y, z + 0.3f * length), 1.6f * t);
            dmg_use(b, 0);
        }
}

/* ---- hull ---- */

static hull pick_hull(dmg_builder* b) {
    hull h = {.length = dmg_scale_range(b, 0.1f, 8.0f)};
    h.half = h.length * dmg_range(b, 0.2f, 0.3f);
    h.track = h.half * dmg_range(b, 0.25f, 0.4f);
    h.high = h.length * dmg_range(b, 0.12f, 0.2f);
    h.low = h.high * dmg_range(b, 1.02f, 1.1f);
    h.deck = h.low + h.length * dmg_range(b, 0.05f, 0.14f);
    h.nose = 0.5f * h.length * dmg_range(b, 0.9f, 1.1f);
    h.stern = -0.5f * h.length * dmg_range(b, 0.9f, 1.05f);
    h.front = h.nose - h.length * dmg_range(b, 0.03f, 0.3f);
    h.rear = h.stern + h.length * dmg_range(b, 0.0f, 0.08f);
    return h;
}

static void draw_hull(dmg_builder* b, const hull* h) {
    float belly = 0.35f * h->high, in = h->half - 1.04f * h->track, mid = 0.5f * (h->low + h->deck);
    const dmg_xy upper[] = {{h->stern, h->low},
                            {0.95f * h->nose, h->low},
                            {h->nose, 0.7f * h->low + 0.3f * mid},
                            {h->front, h->deck},
                            {h->rear, h->deck}};
    const dmg_xy lower[] = {
        {0.85f * h->stern, belly}, {0.8f * h->nose, belly}, {0.95f * h->nose, h->low}, {0.95f * h->stern, h->low}};
    dmg_side_prism(b, lower, 4, -in, in);
    dmg_side_prism(b, upper, 5, -h->half, h->half);
}

/* At the stern: a ramp, two doors, or flaps over the engine on the deck. */
static void draw_stern(dmg_builder* b, const hull* h) {
    float t = 0.02f * h->length, in = 0.9f * (h->half - h->track), z = h->stern - 0.3f * t, y0 = 0.5f * h->high,
          y1 = 0.97f * h->deck;
    int kind = dmg_int(b, 0, 3);
    dmg_box_span(b, v3(-1.1f * in, y0 - 0.5f * t, 0.8f * h->stern), v3(1.1f * in, h->deck, h->stern));
    if (kind == 0) {
        uint32_t ramp = dmg_hinge(b, 0, "ramp", v3(0, y0, z - 0.5f * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.4f, 1.9f));
        dmg_box_span(b, v3(-in, y0, z - t), v3(in, y1, z));
        dmg_rod(b, v3(-in, y0, z - 0.5f * t), v3(in, y0, z - 0.5f * t), 0.7f * t);
        if (dmg_chance(b, 0.4f)) { /* a door within it */
            dmg_hinge(b, ramp, "ramp_door", v3(0.6f * in, 0, z - t), v3(0, 1, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
            dmg_box_span(b, v3(-0.1f * in, y0 + 0.15f * (y1 - y0), z - 1.6f * t),
                         v3(0.6f * in, y1 - 0.1f * (y1 - y0), z - t));
        }
    }
    for (int s = -1; s <= 1 && kind == 1; s += 2) {
        float side = (float)s;
        uint32_t door =
            dmg_hinge(b, 0, "door", v3(side * in, 0, z - 0.7f * t), v3(0, side, 0), 0.0f, dmg_range(b, 1.2f, 1.75f));
        dmg_box_span(b, v3(s > 0 ? 0.02f * in : -in, y0, z - t), v3(s > 0 ? in : -0.02f * in, y1, z));
        dmg_vec pin = {side * 0.2f * in, 0.5f * (y0 + y1), z - t};
        dmg_hinge(b, door, "handle", pin, v3(0, 0, side), 0.0f, dmg_range(b, 0.7f, 1.6f));
        dmg_box(b, v3_add(pin, v3(0, 0.08f * (y1 - y0), -0.4f * t)), v3(0.08f * in, 0.25f * (y1 - y0), 0.6f * t));
        dmg_use(b, 0);
    }
    for (int s = -1; s <= 1 && kind == 2; s += 2) { /* over the engine */
        float side = (float)s, at = h->rear + 0.1f * h->length;
        dmg_hinge(b, 0, "engine_cover", v3(side * 0.9f * h->half, h->deck + 0.5f * t, at), v3(0, 0, -side), 0.0f,
                  dmg_range(b, 1.0f, 1.9f));
        dmg_box_span(b, v3(s > 0 ? 0.03f * in : -0.9f * h->half, h->deck, h->rear),
                     v3(s > 0 ? 0.9f * h->half : -0.03f * in, h->deck + 0.7f * t, at + 0.08f * h->length));
        dmg_use(b, 0);
    }
    dmg_use(b, 0);
}

/* Draws a shield of earth movers before the nose, on arms. */
static void draw_blade(dmg_builder* b, const hull* h) {
    float y = 0.55f * h->high, pin = 0.35f * h->nose, out = h->nose + 0.16f * h->length, x = h->half + 0.04f * h->half,
          t = 0.05f * h->half;
    dmg_hinge_across(b, 0, "dozer_blade", v3(0, y, pin), -0.05f, dmg_range(b, 0.15f, 0.4f));
    for (int s = -1; s <= 1; s += 2) dmg_beam(b, v3((float)s * x, y, pin), v3((float)s * x, y, out), t, 1.5f * t);
    dmg_box(b, v3(0, y + 0.05f * h->high, out), v3(2.15f * x, 0.8f * h->high, t));
    dmg_use(b, 0);
    dmg_rod(b, v3(-x - t, y, pin), v3(x + t, y, pin), 0.8f * t);
}

static void build_vehicle(dmg_builder* b) {
    hull h = pick_hull(b);
    int arms = dmg_weighted(b, (const float[]){5, 2, 1.5f}, 3); /* turret, gun in the hull, none */
    draw_hull(b, &h);
    if (dmg_chance(b, 0.7f)) {
        draw_track(b, &h, -1);
        draw_track(b, &h, 1);
        if (dmg_chance(b, 0.3f)) draw_skirts(b, &h);
    } else {
        draw_wheels(b, &h);
    }
    draw_stern(b, &h);
    if (dmg_chance(b, 0.15f)) draw_blade(b, &h);
    float room = h.front - h.rear, r = fminf(0.85f * h.half, 0.3f * room), reach = h.length * dmg_range(b, 0.35f, 0.7f);
    dmg_save(b);
    dmg_move(b, dmg_sign(b) * 0.5f * h.half, h.deck, h.front - 0.2f * r);
    draw_roof_hatch(b, 0, "driver_hatch", r * dmg_range(b, 0.15f, 0.22f));
    dmg_restore(b);
    if (arms == 0) {
        dmg_move(b, 0, h.deck, h.front - r * dmg_range(b, 1.5f, 1.9f));
        draw_turret(b, r, reach, 0.12f);
        return;
    }
    /* A fighting room on the deck, the gun in its face or a pintle on its roof. */
    float high = h.length * dmg_range(b, 0.06f, 0.12f), back = h.rear + 0.25f * room, face = h.front - 0.5f * r;
    const dmg_xy side[] = {
        {back, h.deck}, {face, h.deck}, {face - 0.3f * high, h.deck + high}, {back + 0.2f * high, h.deck + high}};
    dmg_side_prism(b, side, 4, -0.85f * h.half, 0.85f * h.half);
    dmg_save(b);
    dmg_move(b, -0.35f * h.half, h.deck + high, back + 0.4f * (face - back));
    draw_roof_hatch(b, 0, "hatch", 0.2f * h.half);
    dmg_move(b, 0.7f * h.half, 0, 0);
    if (arms == 2 || dmg_chance(b, 0.4f)) draw_pintle(b, 0, 0.6f * h.half);
    dmg_restore(b);
    if (arms == 2) return;
    gun g = pick_gun(b, reach);
    dmg_move(b, dmg_range(b, -0.3f, 0.3f) * h.half, h.deck + 0.55f * high, face);
    uint32_t carrier = 0;
    if (dmg_chance(b, 0.5f)) {
        carrier = dmg_hinge(b, 0, "gun_mount", v3(0, 0, 0), v3(0, dmg_sign(b), 0), -0.2f, 0.2f);
        dmg_ellipsoid(b, v3(0, 0, 0), v3(5 * g.radius, 0.4f * high, 4 * g.radius));
    }
    draw_gun(b, carrier, &g, -0.06f, 0.25f);
    dmg_use(b, 0);
}

/* ---- a mount that stands: a drum or a pedestal, a housing or a shield, one to four guns ---- */

static void build_mount(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.08f, 3.0f), base = r * dmg_range(b, 0.2f, 1.2f),
          reach = r * dmg_range(b, 1.3f, 3.0f);
    int guns = dmg_int(b, 1, 4), door = dmg_int(b, 0, 2);
    float wide = 0.9f * r, high = r * dmg_range(b, 0.6f, 1.0f), lean = r * dmg_range(b, 0.0f, 0.5f),
          rise = dmg_range(b, 0.5f, 1.3f), t = 0.06f * r;
    bool open = dmg_chance(b, 0.35f), together = dmg_chance(b, 0.4f);
    dmg_cone(b, v3(0, 0, 0), v3(0, base, 0), r * dmg_range(b, 0.9f, 1.5f), 0.9f * r);
    dmg_vec axis = {0, dmg_sign(b), 0};
    uint32_t house = dmg_spin(b, 0, "mount", v3(0, 0, 0), axis);
    dmg_move(b, 0, base, 0);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.12f * r, 0), 0.95f * r);
    const dmg_xy side[] = {
        {-r, 0.1f * r}, {0.6f * r, 0.1f * r}, {0.6f * r, 0.5f * high}, {0.6f * r - lean, high}, {-r, high}};
    if (!open) dmg_side_prism(b, side, 5, -wide, wide);
    for (int s = -1; s <= 1 && open; s += 2)
        dmg_box_span(b, v3((float)s * wide - t, 0.1f * r, -0.4f * r), v3((float)s * wide + t, 0.7f * high, 0.6f * r));
    gun g = pick_gun(b, reach);
    g.barrels = 1;
    g.radius = fminf(g.radius, 0.2f * wide / (float)guns);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * high, open ? 0.1f * r : 0.62f * r);
    if (together) {
        dmg_hinge_across(b, house, "cradle", v3(0, 0, 0), -0.1f, rise);
        dmg_rod(b, v3(-wide, 0, 0), v3(wide, 0, 0), 0.12f * r);
        for (int i = 0; i < guns; ++i) draw_barrel(b, &g, 1.6f * wide * (((float)i + 0.5f) / (float)guns - 0.5f));
    }
    for (int i = 0; i < guns && !together; ++i) {
        dmg_save(b);
        dmg_move(b, 1.6f * wide * (((float)i + 0.5f) / (float)guns - 0.5f), 0, 0);
        dmg_use(b, house);
        draw_gun(b, house, &g, -0.1f, rise);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, house);
    if (open) return;
    if (door) { /* into the housing */
        dmg_hinge(b, house, "door", v3(0.35f * wide, 0, -r - t), v3(0, door == 1 ? 1 : -1, 0), door == 1 ? 0.0f : -2.0f,
                  door == 1 ? 2.0f : 0.0f);
        dmg_box_span(b, v3(-0.35f * wide, 0.2f * r, -r - t), v3(0.35f * wide, 0.2f * r + 0.65f * high, -r));
        dmg_use(b, house);
    }
    dmg_move(b, 0.4f * wide, high, -0.4f * r);
    draw_roof_hatch(b, house, "hatch", 0.25f * wide);
}

void dmg_build_gun_vehicle(dmg_builder* b) {
    if (dmg_chance(b, 0.75f))
        build_vehicle(b);
    else
        build_mount(b);
    dmg_use(b, 0);
}
