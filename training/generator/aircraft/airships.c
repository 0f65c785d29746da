/* Draws airships: an envelope with fins and rudders, a car with doors and a wheel, engines that tilt and turn. */
#include "core/build.h"
#include "core/skins.h"
#include "parts/hardware.h"
#include "parts/wings.h"

typedef struct airship {
    float r, half;             /* of the envelope: its radius, half its length */
    float full;                /* how blunt its ends are */
    float car, wide, high, at; /* the car: length, half width, height, its middle along Z */
    float sill;                /* height of its floor */
} airship;

/* The envelope's radius at z; the thickest part lies ahead of the middle. */
static float envelope_radius(const airship* a, float z) {
    float u = fmaxf(-1.0f, fminf(1.0f, z / a->half)), shift = u < 0.15f ? (u - 0.15f) / 1.15f : (u - 0.15f) / 0.85f;
    return a->r * powf(fmaxf(0.0f, 1.0f - shift * shift), a->full);
}

/* Draws one turned skin, its gores as ribs sometimes; a cone or a disc at its nose. */
static void draw_envelope(dmg_builder* b, const airship* a) {
    enum { ROWS = 9 };
    dmg_xy profile[ROWS];
    for (int i = 0; i < ROWS; ++i) {
        float z = a->half * -cosf(DMG_PI * (float)i / (ROWS - 1));
        profile[i] = (dmg_xy){i == 0 || i == ROWS - 1 ? 0.0f : envelope_radius(a, z), z};
    }
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), profile, ROWS);
    int rings = dmg_chance(b, 0.3f) ? dmg_int(b, 2, 6) : 0, nose = dmg_int(b, 0, 2);
    for (int i = 0; i < rings; ++i) {
        float z = a->half * (1.6f * ((float)i + 0.5f) / (float)rings - 0.8f);
        dmg_torus(b, v3(0, 0, z), v3(0, 0, 1), envelope_radius(a, z), 0.015f * a->r);
    }
    float r = envelope_radius(a, 0.96f * a->half);
    if (nose == 1) dmg_cone(b, v3(0, 0, 0.95f * a->half), v3(0, 0, 1.05f * a->half), 1.1f * r, 0.2f * r);
    if (nose == 2) dmg_rod(b, v3(0, 0, 0.9f * a->half), v3(0, 0, 1.08f * a->half), 0.2f * r);
}

/* Draws three or four fins round the tail, each with a rudder cut out of it. */
static void draw_tail(dmg_builder* b, const airship* a) {
    static const float crosses[] = {0.0f, 0.25f * DMG_PI};
    int count = dmg_chance(b, 0.3f) ? 3 : 4;
    float start = count == 3 ? 0.5f * DMG_PI : crosses[dmg_int(b, 0, 1)], z = -a->half * dmg_range(b, 0.6f, 0.75f),
          span = a->r * dmg_range(b, 0.5f, 1.1f), root = a->r * dmg_range(b, 0.6f, 1.2f),
          foot = 0.8f * envelope_radius(a, z - 0.4f * root);
    dmg_wing fin = dmg_wing_pick(b, span, root);
    fin.sweep = fmaxf(0.0f, fminf(fin.sweep, 0.6f * root));
    float swing = dmg_range(b, 0.3f, 0.6f), c = dmg_range(b, 0.55f, 0.8f), from = dmg_range(b, 0.25f, 0.5f),
          to = dmg_range(b, 0.85f, 1.0f);
    bool moves = dmg_chance(b, 0.95f), stays = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        float angle = start + 2 * DMG_PI * (float)i / (float)count;
        bool upright = fabsf(sinf(angle)) > 0.6f;
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), angle);
        dmg_move(b, foot, 0, z);
        dmg_surface surface = {.name = upright ? "rudder" : "elevator", .s0 = from, .s1 = to, .c = c, .swing = swing};
        dmg_wing_draw(b, &fin, 0, &surface, moves ? 1 : 0);
        dmg_restore(b);
        if (stays) { /* wires to the envelope */
            dmg_vec tip = dmg_skin_point(foot + 0.7f * span, angle, z),
                    root_at = dmg_skin_point(foot + 0.25f * a->r, angle + 0.5f, z + 0.3f * root);
            dmg_rod(b, tip, root_at, 0.006f * a->r);
        }
    }
}

/* Draws a propeller before or behind its pod, in a ring sometimes. */
static void draw_engine_screw(dmg_builder* b, uint32_t pod, float r, float length, float blade, bool pusher,
                              bool ring) {
    int count = dmg_int(b, 2, 4), kind = dmg_int(b, 0, 2);
    float twist = dmg_range(b, 0.3f, 0.8f), chord = blade * dmg_range(b, 0.12f, 0.3f),
          z = (pusher ? -0.5f : 0.5f) * length;
    if (ring) {
        dmg_skin_cone(b, (dmg_xy){1.1f * blade, z - 0.3f * blade}, (dmg_xy){1.18f * blade, z + 0.3f * blade}, 0,
                      2 * DMG_PI, 0.05f * blade);
        for (int i = 0; i < 3; ++i) {
            float angle = 2 * DMG_PI * ((float)i + 0.25f) / 3.0f, back = z + (pusher ? 0.2f : -0.2f) * blade;
            dmg_beam(b, dmg_skin_point(0.5f * r, angle, back), dmg_skin_point(1.1f * blade, angle, back), 0.05f * blade,
                     0.03f * blade);
        }
    }
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    dmg_spin(b, pod, "propeller", v3(0, 0, 0), v3(0, 0, 1));
    if (pusher) dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_cone(b, v3(0, 0, 0), v3(0, 0, 0.8f * r), 0.5f * r, 0.05f * r);
    dmg_move(b, 0, 0, 0.2f * r);
    dmg_blades_draw(b, kind, blade, 0.4f * r, chord, count, twist);
    dmg_restore(b);
    dmg_use(b, pod);
}

typedef struct engine {
    float r, length, blade, tilt;
    int shape;
    bool pusher, ring, tilts;
} engine;

static engine pick_engine(dmg_builder* b, float size) {
    engine e = {.r = size, .shape = dmg_int(b, 0, 2)};
    e.length = size * dmg_range(b, 2.5f, 5.0f);
    e.blade = size * dmg_range(b, 1.6f, 3.0f);
    e.tilt = dmg_range(b, 0.4f, 2.0f);
    e.pusher = dmg_chance(b, 0.45f);
    e.ring = dmg_chance(b, 0.35f);
    e.tilts = dmg_chance(b, 0.65f);
    return e;
}

/* At the outer end of an arm from `from`; it tilts about the arm, +X. */
static void draw_engine(dmg_builder* b, const engine* e, float out, bool truss) {
    float arm = 0.2f * e->r, high = 0.8f * e->r;
    if (truss) {
        dmg_beam(b, v3(0, 0, 0), v3(out, 0, 0), arm, arm);
        dmg_beam(b, v3(0, high, 0.5f * e->r), v3(out, 0, 0), 0.6f * arm, 0.6f * arm);
    } else {
        dmg_rod(b, v3(0, 0, 0), v3(out, 0, 0), 0.35f * e->r);
    }
    uint32_t pod = 0;
    float x = out + e->r;
    if (e->tilts) pod = dmg_hinge(b, 0, "engine", v3(out, 0, 0), v3(-1, 0, 0), -e->tilt, 0.6f * e->tilt);
    dmg_save(b);
    dmg_move(b, x, 0, 0);
    float z = 0.5f * e->length;
    if (e->shape == 0) dmg_capsule(b, v3(0, 0, -z + e->r), v3(0, 0, z - e->r), e->r);
    if (e->shape == 1)
        dmg_cone(b, v3(0, 0, -z), v3(0, 0, z), e->pusher ? e->r : 0.5f * e->r, e->pusher ? 0.5f * e->r : e->r);
    if (e->shape == 2) dmg_rounded_box(b, v3(0, 0, 0), v3(1.9f * e->r, 1.7f * e->r, 2 * z), 0.3f * e->r);
    draw_engine_screw(b, pod, e->r, e->length, e->blade, e->pusher, e->ring);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Pairs of engines on the car's sides or on the envelope's; one at the tail sometimes. */
static void draw_engines(dmg_builder* b, const airship* a, bool whole) {
    bool hull = dmg_chance(b, 0.4f) && whole, stern = dmg_chance(b, 0.2f) && whole, truss = dmg_chance(b, 0.5f);
    int pairs = hull ? dmg_int(b, 1, 2) : 1;
    engine e = pick_engine(b, a->wide * dmg_range(b, 0.25f, 0.45f));
    float out = e.blade * (e.ring ? 1.25f : 1.05f) + dmg_range(b, 0.0f, 0.5f) * e.r,
          y = a->sill + a->high * dmg_range(b, 0.4f, 0.8f), drop = dmg_range(b, 0.2f, 0.7f),
          along = dmg_range(b, -0.2f, 0.3f);
    uint64_t same = b->random_state;
    for (int i = 0; i < 2 * pairs; ++i) {
        float z = hull ? a->half * (0.4f * along + (i < 2 ? 0.3f : -0.3f)) : a->at - along * a->car;
        b->random_state = same;
        dmg_save(b);
        if (i & 1) dmg_mirror(b, v3(1, 0, 0));
        if (hull) {
            float r = envelope_radius(a, z);
            dmg_move(b, 0.97f * r * cosf(drop), -0.97f * r * sinf(drop), z);
        } else {
            dmg_move(b, 0.95f * a->wide, y, z);
        }
        draw_engine(b, &e, out, truss);
        dmg_restore(b);
    }
    if (!stern) return;
    dmg_move(b, 0, 0, -a->half);
    dmg_rod(b, v3(0, 0, -0.5f * e.r), v3(0, 0, 0.1f * a->half), 0.5f * e.r);
    uint32_t pod = dmg_hinge(b, 0, "stern_engine", v3(0, 0, -0.5f * e.r), v3(0, 1, 0), -0.6f, 0.6f);
    dmg_rod(b, v3(0, 0, -2 * e.r), v3(0, 0, -0.5f * e.r), 0.7f * e.r);
    draw_engine_screw(b, pod, e.r, 4 * e.r, e.blade, true, false);
    dmg_use(b, 0);
    dmg_move(b, 0, 0, a->half);
}

/* Draws a door in the car's side: hung at an edge, sliding outside, or let down with steps. */
static void draw_car_door(dmg_builder* b, const airship* a, float z, float side) {
    float wide = a->high * dmg_range(b, 0.35f, 0.6f), low = a->sill + 0.1f * a->high,
          top = low + a->high * dmg_range(b, 0.65f, 0.8f), t = 0.03f * a->high, x = side * a->wide,
          swing = dmg_range(b, 1.3f, 2.6f);
    int kind = dmg_int(b, 0, 2), steps = dmg_int(b, 2, 4);
    bool fore = dmg_chance(b, 0.6f);
    float edge = z + (fore ? 0.5f : -0.5f) * wide;
    uint32_t door = 0;
    if (kind == 0)
        door = dmg_hinge(b, 0, "car_door", v3(x + side * t, low, edge), v3(0, fore ? -side : side, 0), 0.0f, swing);
    if (kind == 1) door = dmg_slide(b, 0, "car_door", v3(0, 0, fore ? 1.0f : -1.0f), 0.0f, 0.9f * wide);
    if (kind == 2) door = dmg_hinge(b, 0, "stair", v3(x + side * t, low, z), v3(0, 0, -side), 0.0f, fminf(swing, 2.2f));
    dmg_box_span(b, v3(fminf(x, x + side * t), low, z - 0.5f * wide), v3(fmaxf(x, x + side * t), top, z + 0.5f * wide));
    for (int i = 0; i < steps && kind == 2; ++i)
        dmg_box(b, v3(x + side * 1.5f * t, low + (top - low) * ((float)i + 0.6f) / (float)steps, z),
                v3(t, 0.5f * t, 0.7f * wide));
    if (kind != 2 && dmg_chance(b, 0.5f)) {
        dmg_vec pin = {x + side * t, low + 0.45f * (top - low), z + (fore ? -0.35f : 0.35f) * wide};
        dmg_hinge(b, door, "handle", pin, v3(side, 0, 0), -1.2f, 0.0f);
        dmg_box(b, v3_add(pin, v3(side * t, 0, (fore ? 0.08f : -0.08f) * wide)), v3(2 * t, t, 0.22f * wide));
    }
    dmg_use(b, 0);
}

/* Draws the car: a hull of a few sections hung close under the envelope, or on struts. */
static void draw_car(dmg_builder* b, const airship* a) {
    float w = a->wide, h = a->high, nose = dmg_range(b, 0.4f, 0.9f), tail = dmg_range(b, 0.3f, 0.9f),
          round = dmg_range(b, 0.5f, 0.9f);
    const dmg_xy section[] = {{-round * w, 0}, {round * w, 0}, {w, 0.3f * h},
                              {w, 0.9f * h},   {-w, 0.9f * h}, {-w, 0.3f * h}};
    const dmg_row rows[] = {{tail, tail, (1 - tail) * h, -0.5f * a->car},
                            {1, 1, 0, -0.3f * a->car},
                            {1, 1, 0, 0.3f * a->car},
                            {nose, nose, (1 - nose) * 0.5f * h, 0.5f * a->car}};
    dmg_save(b);
    dmg_move(b, 0, a->sill, a->at);
    dmg_loft(b, section, 6, rows, 4);
    for (int i = 0; i < 4; ++i) { /* what it hangs on */
        float x = (i & 1 ? 0.6f : -0.6f) * w, z = (i < 2 ? 0.22f : -0.22f) * a->car, r = envelope_radius(a, a->at + z);
        dmg_beam(b, v3(x, 0.85f * h, z), v3(x, 0.01f * a->r - a->sill - sqrtf(r * r - x * x), z), 0.15f * w, 0.3f * w);
    }
    int panes = dmg_int(b, 0, 5);
    for (int i = 0; i < panes; ++i) {
        float z = a->car * 0.56f * (((float)i + 0.5f) / (float)panes - 0.5f);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * w, 0.65f * h, z), v3(0.02f * w, 0.3f * h, 0.4f * a->car / (float)panes * 0.56f));
    }
    dmg_restore(b);
}

/* Below the car: a wheel that castors on its leg, a turret that looks round, a hatch, a hook. */
static void draw_belly(dmg_builder* b, const airship* a) {
    float y = a->sill, r = a->wide * dmg_range(b, 0.25f, 0.4f);
    dmg_save(b);
    dmg_move(b, 0, y, a->at - 0.15f * a->car);
    if (dmg_chance(b, 0.65f)) {
        float leg = r * dmg_range(b, 1.3f, 2.5f), trail = r * dmg_range(b, 0.0f, 0.8f);
        uint32_t caster = dmg_spin(b, 0, "caster", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0.1f * r, 0), v3(0, -0.2f * leg, 0), 0.25f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_beam(b, v3((float)s * 0.35f * r, -0.15f * leg, 0), v3((float)s * 0.35f * r, -leg, -trail), 0.12f * r,
                     0.2f * r);
        dmg_box(b, v3(0, -0.15f * leg, 0), v3(0.85f * r, 0.15f * r, 0.3f * r));
        dmg_move(b, 0, -leg, -trail);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_spin(b, caster, "wheel", v3(0, 0, 0), v3(0, 0, 1));
        dmg_wheel_draw(b, dmg_int(b, 0, 2), 0.75f * fminf(r, leg * 0.95f), 0.4f * r, 5);
    }
    dmg_restore(b);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, 0, y, a->at + 0.2f * a->car);
    int kind = dmg_int(b, 0, 3);
    if (kind == 1) { /* a ball that looks about in a yoke */
        uint32_t yoke = dmg_spin(b, 0, "turret", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0, 0), v3(0, -0.2f * r, 0), 0.7f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.62f * r, -0.5f * r, 0), v3(0.12f * r, 0.8f * r, 0.3f * r));
        dmg_hinge(b, yoke, "camera", v3(0, -0.75f * r, 0), v3(1, 0, 0), -0.3f, 1.4f);
        dmg_ellipsoid(b, v3(0, -0.75f * r, 0), v3(0.52f * r, 0.52f * r, 0.52f * r));
        dmg_rod(b, v3(0, -0.75f * r, 0.4f * r), v3(0, -0.75f * r, 0.6f * r), 0.2f * r);
    }
    if (kind == 2) { /* a hatch with a ladder on it */
        float half = 0.45f * a->wide, long_ = 0.16f * a->car;
        uint32_t hatch = dmg_hinge(b, 0, "hatch", v3(0, 0, long_), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.6f));
        dmg_box_span(b, v3(-half, -0.05f * a->high, 0.1f * long_), v3(half, 0, long_));
        if (dmg_chance(b, 0.3f)) dmg_rest(b, hatch, 0.8f);
    }
    if (kind == 3) { /* a hook for the line */
        dmg_hinge(b, 0, "hook", v3(0, -0.3f * r, 0), v3(1, 0, 0), -0.9f, 0.9f);
        const dmg_vec hook[] = {
            {0, -0.2f * r, 0}, {0, -1.0f * r, 0}, {0, -1.3f * r, 0.25f * r}, {0, -1.1f * r, 0.5f * r}};
        dmg_sweep(b, hook, 4, 0.08f * r, 0.08f * r, false);
        dmg_rod(b, v3(-0.25f * r, -0.3f * r, 0), v3(0.25f * r, -0.3f * r, 0), 0.1f * r);
        dmg_use(b, 0);
        dmg_box(b, v3(0, -0.1f * r, 0), v3(0.4f * r, 0.3f * r, 0.3f * r));
    }
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws the part of the envelope over the car: all that a model of the car alone has of it. */
static void draw_belly_skin(dmg_builder* b, const airship* a) {
    dmg_xy rows[5];
    float around = dmg_range(b, 0.3f, 0.7f);
    for (int i = 0; i < 5; ++i) {
        float z = a->at + a->car * 0.7f * (0.5f * (float)i - 1.0f);
        rows[i] = (dmg_xy){envelope_radius(a, z), z};
    }
    dmg_skin skin = {.rows = rows,
                     .count = 5,
                     .from = -0.5f * DMG_PI - around,
                     .to = -0.5f * DMG_PI + around,
                     .t = 0.03f * a->r,
                     .high = 1};
    dmg_skin_draw(b, &skin);
}

/* On the envelope: lids of valves that lift off their seats or swing. */
static void draw_valves(dmg_builder* b, const airship* a) {
    int count = dmg_int(b, 1, 3);
    bool lifts = dmg_chance(b, 0.5f);
    float r = a->r * dmg_range(b, 0.08f, 0.16f), angle = dmg_range(b, 0.2f, 1.2f);
    for (int i = 0; i < count; ++i) {
        float z = a->half * 0.3f * (float)(i - 1);
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), angle);
        dmg_move(b, envelope_radius(a, z), 0, z);
        dmg_torus(b, v3(0, 0, 0), v3(1, 0, 0), 1.1f * r, 0.15f * r);
        if (lifts)
            dmg_slide(b, 0, "valve", v3(1, 0, 0), 0.0f, 0.5f * r);
        else
            dmg_hinge(b, 0, "valve", v3(0.2f * r, 0, r), v3(0, -1, 0), 0.0f, 1.2f);
        dmg_rod(b, v3(0.1f * r, 0, 0), v3(0.3f * r, 0, 0), r);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_airship(dmg_builder* b) {
    airship a = {.r = dmg_scale_range(b, 0.1f, 8.0f)};
    a.half = a.r * dmg_range(b, 1.3f, 3.2f);
    a.full = dmg_range(b, 0.45f, 0.75f);
    a.car = a.half * dmg_range(b, 0.35f, 0.8f);
    a.wide = a.r * dmg_range(b, 0.18f, 0.42f);
    a.high = a.wide * dmg_range(b, 1.2f, 2.2f);
    a.at = a.half * dmg_range(b, -0.1f, 0.35f);
    float under = fminf(envelope_radius(&a, a.at - 0.4f * a.car), envelope_radius(&a, a.at + 0.4f * a.car));
    a.sill = -under - a.high * dmg_range(b, 0.75f, 1.15f);
    dmg_move(b, 0, -a.sill + a.wide * 1.5f, 0);
    bool whole = dmg_chance(b, 0.65f);
    if (whole) {
        draw_envelope(b, &a);
        draw_tail(b, &a);
    } else {
        draw_belly_skin(b, &a);
    }
    draw_car(b, &a);
    draw_engines(b, &a, whole);
    draw_car_door(b, &a, a.at + a.car * dmg_range(b, -0.12f, 0.12f), 1.0f);
    if (dmg_chance(b, 0.4f)) draw_car_door(b, &a, a.at + a.car * dmg_range(b, -0.12f, 0.12f), -1.0f);
    draw_belly(b, &a);
    if (whole && dmg_chance(b, 0.3f)) draw_valves(b, &a);
}
