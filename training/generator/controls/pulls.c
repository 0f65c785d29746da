/* Draws pairs that look alike from the front and differ in rods, skirts, slots and rims: push rods beside knobs that
 * turn, and wheels sunk into consoles beside blocks that slide. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- heads that rods and knobs share: on z = 0, towards +Z ---- */

enum { HEAD_BALL, HEAD_DISC, HEAD_LOBES, HEAD_RIBS, HEAD_MUSHROOM, HEAD_PALM, HEAD_KINDS };

static void draw_ribbed(dmg_builder* b, float radius, float low, float high) {
    enum { MOST = 48 };
    dmg_xy outline[MOST];
    int points = 2 * dmg_int(b, 8, MOST / 2);
    for (int i = 0; i < points; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / (float)points, r = i & 1 ? 0.92f * radius : radius;
        outline[i] = (dmg_xy){r * cosf(angle), r * sinf(angle)};
    }
    dmg_extrude(b, outline, points, low, high);
}

static float draw_head(dmg_builder* b, int kind, float r) {
    const dmg_xy palm[] = {{0.3f * r, 0}, {r, 0.4f * r}, {0.95f * r, 0.8f * r}, {0.5f * r, 1.1f * r}, {0, 1.15f * r}};
    if (kind == HEAD_BALL) dmg_ellipsoid(b, v3(0, 0, 0.9f * r), v3(r, r, r));
    if (kind == HEAD_DISC) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * r), r);
    if (kind == HEAD_LOBES) dmg_knob_draw(b, 4, r, 0.8f * r);
    if (kind == HEAD_RIBS) draw_ribbed(b, r, 0, 0.9f * r);
    if (kind == HEAD_MUSHROOM) dmg_knob_draw(b, 3, r, r);
    if (kind == HEAD_PALM) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), palm, 5);
    const float height[HEAD_KINDS] = {1.8f, 0.6f, 0.8f, 0.9f, 1.0f, 1.1f};
    return height[kind] * r;
}

static void draw_nut(dmg_builder* b, float radius, float height) {
    dmg_xy hexagon[6];
    for (int i = 0; i < 6; ++i) {
        float angle = DMG_PI * (float)i / 3.0f;
        hexagon[i] = (dmg_xy){radius * cosf(angle), radius * sinf(angle)};
    }
    dmg_extrude(b, hexagon, 6, -0.1f * height, height);
}

/* Draws a rod out of the panel: goes in as far as it shows, or comes out as far as it reaches back. */
static uint32_t draw_rod(dmg_builder* b, float thin, float travel, float nut) {
    bool whole = dmg_chance(b, 0.6f);
    float shown = whole ? nut : nut + travel;
    if (whole && dmg_chance(b, 0.5f)) dmg_rod(b, v3(0, 0, -1.1f * travel), v3(0, 0, 0), 2.0f * thin); /* its sleeve */
    uint32_t part = dmg_slide(b, 0, "push_rod", v3(0, 0, whole ? 1 : -1), 0.0f, travel);
    dmg_rod(b, v3(0, 0, whole ? -travel : 0), v3(0, 0, shown), thin);
    if (whole) dmg_rest(b, part, travel * dmg_range(b, 0.0f, 1.0f));
    dmg_move(b, 0, 0, shown);
    return part;
}

/* Mixture, choke, primer: a bare rod, a nut that does not turn or a friction ring that does, a head. */
static void draw_plunger(dmg_builder* b, int head, float r) {
    float thin = r * dmg_range(b, 0.12f, 0.3f), travel = r * dmg_scale_range(b, 0.8f, 4.0f), nut = 0.4f * r;
    if (dmg_chance(b, 0.25f)) dmg_spin(b, 0, "friction_ring", v3(0, 0, 0), v3(0, 0, 1));
    if (b->part != 0 || dmg_chance(b, 0.3f)) {
        const dmg_xy ring[] = {{1.1f * thin, 0}, {0.7f * r, 0}, {0.7f * r, nut}, {1.1f * thin, nut}, {1.1f * thin, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    } else {
        draw_nut(b, fmaxf(2 * thin, 0.5f * r), nut);
    }
    dmg_save(b);
    uint32_t rod = draw_rod(b, thin, travel, nut);
    float top = draw_head(b, head, r);
    if (dmg_chance(b, 0.2f)) { /* the button that frees it */
        dmg_slide(b, rod, "release", v3(0, 0, -1), 0.0f, 0.15f * r);
        dmg_rod(b, v3(0, 0, 0.5f * top), v3(0, 0, top + 0.25f * r), 0.4f * r);
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws the same head with no rod to see: a skirt with a mark on it, figures round it on the panel. */
static void draw_turner(dmg_builder* b, int head, float r) {
    float skirt = r * dmg_range(b, 1.05f, 1.4f), thick = r * dmg_range(b, 0.1f, 0.4f), upper = dmg_range(b, 1.0f, 5.0f);
    int figures = dmg_chance(b, 0.5f) ? dmg_int(b, 3, 10) : 0;
    for (int i = 0; i < figures; ++i) {
        float angle = 5.0f * (float)i / (float)figures - 1.0f;
        dmg_box(b, v3(1.55f * r * cosf(angle), 1.55f * r * sinf(angle), 0), v3(0.12f * r, 0.12f * r, 0.06f * r));
    }
    uint32_t knob = dmg_chance(b, 0.3f) ? dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1))
                                        : dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, -1), 0.0f, upper);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, thick), skirt);
    dmg_box(b, v3(0, 0.8f * skirt, thick), v3(0.1f * r, 0.4f * skirt, 0.1f * r));
    dmg_save(b);
    dmg_move(b, 0, 0, 0.9f * thick);
    draw_head(b, head, r);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, knob, upper * dmg_unit(b));
    dmg_use(b, 0);
}

/* Draws a bar across a rod with notches that is pulled, or across a thick boss between stops that is turned. */
static void draw_tee(dmg_builder* b, float r) {
    float bar = r * dmg_range(b, 1.2f, 2.2f), thick = 0.35f * r, thin = r * dmg_range(b, 0.15f, 0.25f);
    bool pulls = dmg_chance(b, 0.5f), upright = dmg_chance(b, 0.3f);
    int notches = dmg_int(b, 0, 8);
    float swing = dmg_range(b, 0.6f, 1.6f), travel = r * dmg_range(b, 1.0f, 4.0f);
    dmg_save(b);
    if (pulls) {
        dmg_box(b, v3(0, 0, 0.2f * r), v3(4 * thin, 4 * thin, 0.4f * r));
        draw_rod(b, thin, travel, 0.5f * r);
        for (int i = 0; i < notches; ++i) {
            float z = -0.9f * travel * ((float)i + 0.5f) / (float)notches;
            dmg_rod(b, v3(0, 0, z - 0.2f * thin), v3(0, 0, z + 0.2f * thin), 1.2f * thin);
        }
    } else {
        for (int i = -1; i <= 1; i += 2) /* the stops */
            dmg_rod(b, v3((float)i * 0.9f * r, -0.9f * r, 0), v3((float)i * 0.9f * r, -0.9f * r, 0.3f * r), 0.12f * r);
        dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.12f * r), 1.2f * r);
        dmg_hinge(b, 0, "t_handle", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * r), 0.6f * r);
        dmg_move(b, 0, 0, 0.6f * r);
    }
    if (upright) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0, 0.5f * thick), v3(2 * bar, thick, thick), 0.4f * thick);
    else
        dmg_rod(b, v3(-bar, 0, 0.5f * thick), v3(bar, 0, 0.5f * thick), 0.55f * thick);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a pistol grip on a rod out of a tube under the panel: the umbrella brake. */
static void draw_umbrella(dmg_builder* b, float r) {
    float thin = 0.22f * r, travel = r * dmg_range(b, 1.0f, 3.0f), drop = r * dmg_range(b, 1.0f, 2.0f);
    dmg_rod(b, v3(0, 0, -travel), v3(0, 0, 0.6f * r), 1.6f * thin);
    dmg_box(b, v3(0, 0.5f * r, 0), v3(1.5f * thin, r, thin));
    dmg_save(b);
    draw_rod(b, thin, travel, 0.7f * r);
    const dmg_vec grip[] = {{0, 0, 0}, {0, 0, 0.4f * r}, {0, -0.3f * drop, 0.7f * r}, {0, -drop, 0.6f * r}};
    dmg_sweep(b, grip, 4, 1.3f * thin, 1.6f * thin, false);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a lock in its plate; the key's bow lies in the plane through the line, a ring hangs through it. */
static void draw_ignition(dmg_builder* b, float r) {
    float core = 0.55f * r, rise = r * dmg_range(b, 0.05f, 0.5f), bow = r * dmg_range(b, 0.4f, 0.8f), thin = 0.08f * r;
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.08f * r), r);
    for (int i = 0; i < 4; ++i)
        dmg_box(b, v3(1.15f * r * cosf(0.6f * (float)i + 0.6f), 1.15f * r * sinf(0.6f * (float)i + 0.6f), 0),
                v3(0.15f * r, 0.15f * r, 0.05f * r));
    const float upper = dmg_range(b, 0.6f, 2.0f), lower = -dmg_range(b, 0.0f, 0.8f);
    uint32_t key = dmg_hinge(b, 0, "ignition_key", v3(0, 0, 0), v3(0, 0, -1), lower, upper);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, rise), core);
    dmg_box(b, v3(0, 0, rise + 0.3f * bow), v3(thin, 0.5f * core, 0.8f * bow));
    float eye = rise + 1.3f * bow, ring = r * dmg_range(b, 0.4f, 0.9f);
    dmg_save(b);
    dmg_move(b, 0, 0, eye);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0, 0), v3(1.8f * thin, 1.6f * bow, 1.2f * bow), 0.7f * thin);
    else
        dmg_torus(b, v3(0, 0, 0), v3(1, 0, 0), 0.55f * bow, 0.18f * bow);
    if (dmg_chance(b, 0.4f)) {
        dmg_hinge(b, key, "key_ring", v3(0, -0.4f * bow, 0), v3(1, 0, 0), -0.7f, 0.7f);
        dmg_torus(b, v3(0, -0.4f * bow - ring, 0), v3(0, 0, 1), ring, 0.06f * ring);
        if (dmg_chance(b, 0.6f))
            dmg_box(b, v3(0, -0.4f * bow - 2.7f * ring, 0), v3(0.8f * ring, 1.5f * ring, 0.1f * ring));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a handle that points: long on one side of the line, on a round plate with its figures. */
static void draw_selector(dmg_builder* b, float r) {
    float nose = r * dmg_range(b, 1.2f, 2.0f), tail = r * dmg_range(b, 0.2f, 0.9f), wide = 0.35f * r, lift = 0.5f * r;
    float swing = dmg_range(b, 0.7f, 2.4f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.12f * r), 1.3f * r);
    if (dmg_chance(b, 0.3f))
        dmg_spin(b, 0, "selector", v3(0, 0, 0), v3(0, 0, -1));
    else
        dmg_hinge(b, 0, "selector", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0, lift), 0.4f * r);
    const dmg_xy arrow[] = {{-wide, -tail}, {wide, -tail}, {wide, 0.6f * nose}, {0, nose}, {-wide, 0.6f * nose}};
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_extrude(b, arrow, 5, 0.4f * lift, lift);
    if (kind == 1) dmg_rounded_box(b, v3(0, 0.5f * (nose - tail), lift), v3(wide, nose + tail, lift), 0.3f * wide);
    if (kind == 2) dmg_cone(b, v3(0, -tail, lift), v3(0, nose, lift), 0.8f * wide, 0.35f * wide);
    dmg_use(b, 0);
}

void dmg_build_push_pull_panel(dmg_builder* b) {
    static const float weights[] = {5, 3, 1, 0.7f, 1, 1};
    int count = dmg_int(b, 1, 6), head = dmg_int(b, 0, HEAD_KINDS - 1), shape = dmg_int(b, 0, 2);
    bool alike = dmg_chance(b, 0.7f), column = dmg_chance(b, 0.2f);
    float cell = dmg_scale_range(b, 0.03f, 0.1f), across = cell * dmg_range(b, 0.9f, 1.6f),
          long_ = cell * ((float)count + dmg_range(b, 0.1f, 1.0f)), thin = cell * dmg_scale_range(b, 0.05f, 1.5f),
          size = cell * dmg_range(b, 0.25f, 0.42f);
    float width = column ? across : long_, height = column ? long_ : across;
    dmg_move(b, 0, 0.5f * height + 1.5f * cell, 0);
    if (dmg_chance(b, 0.4f)) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.2f, 1.5f));
    if (shape == 0) dmg_box(b, v3(0, 0, -0.5f * thin), v3(width, height, thin));
    if (shape == 1) dmg_rounded_plate(b, width, height, thin, 0.3f * cell);
    if (shape == 2) { /* the lower edge of a dashboard: a face, a lip that runs back */
        dmg_box(b, v3(0, 0, -0.1f * cell), v3(width, height, 0.2f * cell));
        dmg_box(b, v3(0, 0.5f * height, -0.6f * cell), v3(1.1f * width, 0.2f * cell, 1.4f * cell));
    }
    for (int i = 0; i < count; ++i) {
        float at = cell * ((float)i - 0.5f * (float)(count - 1)), off = 0.15f * across * (i & 1 ? 1.0f : -1.0f);
        float r = size * (alike ? 1.0f : dmg_range(b, 0.6f, 1.2f));
        if (!alike) head = dmg_int(b, 0, HEAD_KINDS - 1);
        int kind = dmg_weighted(b, weights, 6);
        dmg_save(b);
        dmg_move(b, column ? off : at, column ? at : off, 0);
        if (kind == 0) draw_plunger(b, head, r);
        if (kind == 1) draw_turner(b, head, r);
        if (kind == 2) draw_tee(b, 0.8f * r);
        if (kind == 3) draw_umbrella(b, r);
        if (kind == 4) draw_ignition(b, r);
        if (kind == 5) draw_selector(b, 0.8f * r);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- wheels half sunk ---- */

/* Draws what shows of a wheel on z = 0, its line along X below the surface: a rim with ribs, or the cap above alone. */
static void draw_rim(dmg_builder* b, float radius, float width, float sink, int kind) {
    enum { STEPS = 9 };
    dmg_save(b);
    dmg_move(b, 0, 0, -sink);
    if (kind == 0) dmg_rod(b, v3(-0.5f * width, 0, 0), v3(0.5f * width, 0, 0), radius);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* the line becomes the frame's z, out of the surface its -x */
    if (kind == 1) draw_ribbed(b, radius, -0.5f * width, 0.5f * width);
    if (kind == 2) {
        dmg_xy cap[STEPS];
        float half = 0.98f * acosf(fminf(0.95f, sink / radius));
        for (int i = 0; i < STEPS; ++i) {
            float angle = DMG_PI + half * (2.0f * (float)i / (STEPS - 1) - 1.0f);
            cap[i] = (dmg_xy){radius * cosf(angle), radius * sinf(angle)};
        }
        dmg_extrude(b, cap, STEPS, -0.5f * width, 0.5f * width);
    }
    if (kind == 3) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius - 0.5f * width, 0.5f * width);
    dmg_restore(b);
}

/* The place of one control on a console: open ones have a top of thin plates round each slot, others are solid. */
typedef struct place {
    float wide, deep, high, thick; /* thick: of the top, 0 where the console is solid */
} place;

static void draw_top(dmg_builder* b, const place* p, float slot_wide, float slot_long) {
    float side = 0.5f * (p->wide - slot_wide), end = 0.5f * (p->deep - slot_long), z = -0.5f * p->thick;
    for (int i = -1; i <= 1; i += 2) {
        dmg_box(b, v3((float)i * 0.5f * (slot_wide + side), 0, z), v3(side, p->deep, p->thick));
        dmg_box(b, v3(0, (float)i * 0.5f * (slot_long + end), z), v3(slot_wide, end, p->thick));
    }
}

static void draw_sunk_wheel(dmg_builder* b, const place* p, float radius, float width) {
    float sink = radius * dmg_range(b, 0.2f, 0.55f), border = 0.25f * width;
    if (p->thick > 0.0f) sink = fminf(sink, 0.95f * p->high - radius);
    int kind = dmg_int(b, 0, 3);
    if (kind == 2) sink = fminf(sink, 0.5f * radius); /* there is nothing else to see of it */
    float shows = 2.0f * sqrtf(radius * radius - sink * sink), turn = 0.2f * acosf(sink / radius);
    if (p->thick > 0.0f) draw_top(b, p, 1.15f * width, fminf(shows + 0.3f * border, 0.97f * p->deep));
    if (dmg_chance(b, p->thick > 0.0f ? 0.2f : 0.6f)) {
        dmg_save(b);
        dmg_move(b, 0, 0, 0.2f * border);
        dmg_frame_draw(b, 1.3f * width + 2 * border, shows + 4 * border, 0.4f * border, border);
        dmg_restore(b);
    }
    for (int i = -1; i <= 1 && dmg_chance(b, 0.25f); i += 2) /* cheeks beside it */
        dmg_box(b, v3((float)i * 0.8f * width, 0, 0), v3(0.3f * width, 0.8f * shows, 0.9f * (radius - sink)));
    if (kind == 2)
        dmg_hinge(b, 0, "trim_wheel", v3(0, 0, -sink), v3(1, 0, 0), -turn, turn);
    else
        dmg_spin(b, 0, "trim_wheel", v3(0, 0, -sink), v3(1, 0, 0));
    draw_rim(b, radius, width, sink, kind);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.3f)) { /* the pointer beside it */
        float way = 0.35f * shows;
        dmg_box(b, v3(width, 0, 0), v3(0.08f * width, 2.6f * way, 0.05f * width));
        uint32_t pointer = dmg_slide(b, 0, "pointer", v3(0, 1, 0), -way, way);
        dmg_box(b, v3(width, 0, 0.1f * width), v3(0.3f * width, 0.15f * width, 0.2f * width));
        dmg_rest(b, pointer, way * dmg_range(b, -0.9f, 0.9f));
        dmg_use(b, 0);
    }
}

/* As curved and ribbed as a wheel's top, but on a foot in a straight slot: it slides. */
static void draw_sliding_block(dmg_builder* b, float radius, float width) {
    float long_ = radius * dmg_range(b, 0.4f, 0.8f), way = radius * dmg_range(b, 0.3f, 0.6f), foot = 0.12f * width;
    int ribs = dmg_int(b, 0, 6);
    const dmg_xy top[] = {{-0.5f * long_, foot},           {0.5f * long_, foot},
                          {0.4f * long_, 0.3f * long_},    {0.15f * long_, 0.42f * long_},
                          {-0.15f * long_, 0.42f * long_}, {-0.4f * long_, 0.3f * long_}};
    for (int i = -1; i <= 1; i += 2) /* rails */
        dmg_box(b, v3((float)i * 0.8f * width, 0, foot), v3(0.2f * width, 2 * way + 1.4f * long_, 2 * foot));
    uint32_t block = dmg_slide(b, 0, "slider", v3(0, 1, 0), -way, way);
    dmg_box(b, v3(0, 0, 0.5f * foot), v3(1.3f * width, 1.2f * long_, foot));
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the outline stands up along the slot */
    dmg_extrude(b, top, 6, -0.45f * width, 0.45f * width);
    dmg_restore(b);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(0, 0.3f * long_ * (2.0f * ((float)i + 0.5f) / (float)ribs - 1.0f), 0.42f * long_),
                v3(0.9f * width, 0.04f * long_, 0.1f * long_));
    if (dmg_chance(b, 0.7f)) dmg_rest(b, block, way * dmg_range(b, -1.0f, 1.0f));
    dmg_use(b, 0);
}

/* Draws a dial let into a dish: a rim round it, finger holes or a bar on it. */
static void draw_dished_dial(dmg_builder* b, float r) {
    const dmg_xy dish[] = {{1.1f * r, -0.1f * r},
                           {1.3f * r, -0.1f * r},
                           {1.3f * r, 0.1f * r},
                           {1.1f * r, 0.1f * r},
                           {1.1f * r, -0.1f * r}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), dish, 5);
    dmg_spin(b, 0, "dial", v3(0, 0, 0), v3(0, 0, -1));
    dmg_rod(b, v3(0, 0, -0.1f * r), v3(0, 0, 0.06f * r), r);
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, 0.15f * r), v3(0.2f * r, 1.8f * r, 0.25f * r));
    else
        dmg_rod(b, v3(0.6f * r, 0, 0), v3(0.6f * r, 0, 0.5f * r), 0.2f * r);
    dmg_use(b, 0);
}

static void draw_console(dmg_builder* b, const place* p, float whole) {
    dmg_vec middle = {0, 0, -0.5f * p->high}, size = {whole, p->deep, p->high};
    if (p->thick > 0.0f) {
        float edge = 0.5f * (whole - p->wide * floorf(whole / p->wide));
        dmg_save(b);
        dmg_move(b, 0, 0, -p->thick);
        dmg_case_draw(b, DMG_CASE_BOARDS, whole, p->deep, p->high, 0.8f * p->thick);
        dmg_restore(b);
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * 0.5f * (whole - edge), 0, -0.5f * p->thick), v3(edge, p->deep, p->thick));
    } else if (dmg_chance(b, 0.6f)) {
        dmg_box(b, middle, size);
    } else {
        dmg_rounded_box(b, middle, size, 0.15f * p->wide);
    }
}

void dmg_build_sunk_wheels(dmg_builder* b) {
    int count = dmg_int(b, 1, 4), face = dmg_int(b, 0, 2);
    float cell = dmg_scale_range(b, 0.03f, 0.15f), width = cell * (float)count, deep = cell * dmg_range(b, 0.9f, 2.2f),
          high = cell * dmg_range(b, 0.5f, 1.6f);
    bool across = dmg_chance(b, 0.25f), alike = dmg_chance(b, 0.5f);
    int kind = dmg_int(b, 0, 3);
    if (face == 0) { /* on top */
        dmg_move(b, 0, high, 0);
        dmg_face_up(b);
    }
    if (face == 1) dmg_move(b, 0, 0.5f * deep, 0); /* in the front */
    if (face == 2) {                               /* on a slope */
        dmg_move(b, 0, high + 0.4f * deep, 0);
        dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.5f, 1.2f));
    }
    float whole = width + 0.4f * cell;
    place p = {.wide = cell, .deep = deep, .high = high};
    if (!across && dmg_chance(b, 0.5f)) p.thick = 0.05f * cell;
    draw_console(b, &p, whole);
    for (int i = 0; i < count; ++i) {
        float radius = fminf(across ? 0.46f * cell : 0.42f * deep, 0.8f * high) * dmg_range(b, 0.75f, 1.0f),
              wide = cell * dmg_range(b, 0.15f, 0.5f);
        if (!alike) kind = dmg_int(b, 0, 3);
        dmg_save(b);
        dmg_move(b, cell * ((float)i - 0.5f * (float)(count - 1)), p.thick > 0.0f ? 0.0f : 0.08f * deep * dmg_sign(b),
                 0);
        if (across) dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
        if (kind >= 2 && p.thick > 0.0f) dmg_box(b, v3(0, 0, -0.5f * p.thick), v3(cell, deep, p.thick));
        if (kind < 2) draw_sunk_wheel(b, &p, radius, wide);
        if (kind == 2) draw_sliding_block(b, radius, wide);
        if (kind == 3) draw_dished_dial(b, fminf(0.38f * cell, radius));
        dmg_restore(b);
    }
    dmg_use(b, 0);
}
