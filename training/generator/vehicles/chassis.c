/* Draws rolling chassis as simulators and games have them: wheels that steer, spring and trail, the seat's controls;
 * and wheelchairs. Nose to +Z, standing on y = 0. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- corners: how a wheel is carried ---- */

typedef enum corner_kind {
    CORNER_FIXED,
    CORNER_STEERED,  /* the wheel itself steers, mostly about its own middle: the label of a link without a mesh */
    CORNER_KNUCKLE,  /* a block steers, the wheel turns on it */
    CORNER_SPRUNG,   /* the wheel itself goes up and down */
    CORNER_STRUT,    /* a strut goes up and down with the wheel */
    CORNER_TRAILING, /* an arm along the car swings */
    CORNER_WISHBONE, /* an arm across the car swings */
    CORNER_KINDS
} corner_kind;

typedef struct corner {
    corner_kind kind;
    int tread, spokes;
    float radius, width;
    float camber, caster; /* of the axle, of the kingpin */
    float offset;         /* of the kingpin from the wheel's middle */
    float swing, arm;
} corner;

static corner pick_corner(dmg_builder* b, float radius, corner_kind kind) {
    corner c = {.kind = kind, .radius = radius, .tread = dmg_int(b, 0, 7), .spokes = dmg_int(b, 4, 9)};
    c.width = radius * dmg_range(b, 0.25f, 1.0f);
    c.camber = dmg_chance(b, 0.2f) ? dmg_range(b, -0.1f, 0.1f) : 0.0f;
    c.caster = dmg_chance(b, 0.25f) ? dmg_range(b, 0.0f, 0.3f) : 0.0f;
    c.offset = dmg_chance(b, 0.6f) ? 0.0f : c.width * dmg_range(b, 0.2f, 1.1f);
    c.swing = dmg_chance(b, 0.7f) ? dmg_range(b, 0.2f, 0.6f) : dmg_range(b, 0.6f, 1.0f);
    c.arm = radius * dmg_range(b, 1.0f, 2.6f);
    return c;
}

/* Round about X at the origin, with lugs or as a plain ball too. */
static void draw_tread(dmg_builder* b, const corner* c) {
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    if (c->tread == 6) {
        dmg_ellipsoid(b, v3(0, 0, 0), v3(c->radius, c->radius, fmaxf(0.5f * c->width, 0.4f * c->radius)));
    } else if (c->tread == 7) { /* lugs round a drum */
        dmg_rod(b, v3(0, 0, -0.5f * c->width), v3(0, 0, 0.5f * c->width), 0.9f * c->radius);
        for (int i = 0; i < 10; ++i) {
            dmg_save(b);
            dmg_turn(b, v3(0, 0, 1), 0.2f * DMG_PI * (float)i);
            dmg_box(b, v3(0.93f * c->radius, 0, 0), v3(0.14f * c->radius, 0.12f * c->radius, c->width));
            dmg_restore(b);
        }
    } else {
        dmg_wheel_draw(b, c->tread == 4 ? 0 : c->tread, c->radius, c->width, c->spokes);
    }
    dmg_restore(b);
}

/* Draws the part that carries the wheel; 0 where the wheel itself is the part that moves so, or hangs on the body. in:
 * towards the middle of the car, -1 or 1. */
static uint32_t draw_carrier(dmg_builder* b, const corner* c, float in) {
    float r = c->radius, x = in * (0.5f * c->width + 0.12f * r);
    if (c->kind == CORNER_KNUCKLE) {
        float pin = in * fmaxf(c->offset, 0.6f * c->width);
        uint32_t knuckle =
            dmg_hinge(b, 0, "steering", v3(pin, 0, 0), v3(0, cosf(c->caster), -sinf(c->caster)), -c->swing, c->swing);
        dmg_box(b, v3(pin, 0, 0), v3(0.25f * r, dmg_range(b, 0.4f, 1.2f) * r, 0.3f * r));
        dmg_rod(b, v3(pin, 0, 0), v3(0, 0, 0), 0.12f * r);
        return knuckle;
    }
    if (c->kind == CORNER_STRUT) {
        uint32_t strut = dmg_slide(b, 0, "suspension", v3(0, 1, 0), -0.1f * r, dmg_range(b, 0.1f, 0.5f) * r);
        dmg_rod(b, v3(x, 0, 0), v3(x, 1.4f * r, 0), 0.12f * r);
        dmg_rod(b, v3(x, 0, 0), v3(0, 0, 0), 0.12f * r);
        return strut;
    }
    if (c->kind == CORNER_TRAILING) {
        uint32_t arm =
            dmg_hinge(b, 0, "trailing_arm", v3(x, 0.2f * r, c->arm), v3(-1, 0, 0), -0.4f * c->swing, 0.4f * c->swing);
        dmg_beam(b, v3(x, 0.2f * r, c->arm), v3(x, 0, 0), 0.15f * r, 0.3f * r);
        dmg_rod(b, v3(x, 0, 0), v3(0, 0, 0), 0.12f * r);
        return arm;
    }
    uint32_t arm =
        dmg_hinge(b, 0, "wishbone", v3(x + in * c->arm, 0.1f * r, 0), v3(0, 0, -in), -0.4f * c->swing, 0.4f * c->swing);
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(x + in * c->arm, 0.1f * r, (float)s * 0.6f * r), v3(x, 0, 0), 0.1f * r);
    dmg_rod(b, v3(x, 0, 0), v3(0, 0, 0), 0.12f * r);
    return arm;
}

static void draw_corner(dmg_builder* b, const corner* c, float x, float z) {
    float in = x > 0 ? -1.0f : 1.0f;
    dmg_save(b);
    dmg_move(b, x, c->radius, z);
    if (c->kind == CORNER_STEERED)
        dmg_hinge(b, 0, "steering", v3(in * c->offset, 0, 0), v3(0, cosf(c->caster), -sinf(c->caster)), -c->swing,
                  c->swing);
    else if (c->kind == CORNER_SPRUNG)
        dmg_slide(b, 0, "suspension", v3(0, 1, 0), -0.1f * c->radius, fminf(c->swing, 0.5f) * c->radius);
    else
        dmg_spin(b, c->kind == CORNER_FIXED ? 0 : draw_carrier(b, c, in), "wheel", v3(0, 0, 0),
                 v3(cosf(c->camber), in * sinf(c->camber), 0));
    dmg_turn(b, v3(0, 0, 1), in * c->camber);
    draw_tread(b, c);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* ---- what hands and feet move; the driver's place is at the origin, looking to +Z, `size` a seat's width ---- */

static void draw_steering_wheel(dmg_builder* b, float size) {
    float lean = dmg_range(b, 0.3f, 1.2f), r = 0.4f * size, column = size * dmg_range(b, 0.4f, 1.0f);
    dmg_save(b);
    dmg_move(b, 0, 0.7f * size, 0.8f * size);
    dmg_turn(b, v3(1, 0, 0), lean - DMG_PI); /* its face looks back and up */
    dmg_rod(b, v3(0, 0, -column), v3(0, 0, -0.02f * size), 0.06f * size);
    dmg_hinge(b, 0, "steering_wheel", v3(0, 0, 0), v3(0, 0, 1), -DMG_PI, DMG_PI);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, 0, -0.5f * column), v3(0, 0, 0), 0.05f * size);
    dmg_wheel_draw(b, 3, r, 0.12f * size, dmg_int(b, 2, 4));
    dmg_use(b, 0);
    dmg_restore(b);
}

static void draw_pedals(dmg_builder* b, float size) {
    int count = dmg_int(b, 2, 3);
    bool slides = dmg_chance(b, 0.5f), arms = dmg_chance(b, 0.7f);
    float lean = dmg_range(b, 0.3f, 1.0f), travel = size * dmg_range(b, 0.06f, 0.2f);
    for (int i = 0; i < count; ++i) {
        float x = ((float)i - 0.5f * (float)count) * 0.3f * size, wide = dmg_range(b, 0.1f, 0.2f) * size;
        dmg_vec at = {x, -0.4f * size, 1.4f * size}, way = {0, -sinf(lean), cosf(lean)},
                top = v3_add(at, v3(0, 0.45f * size, 0.15f * size));
        if (slides)
            dmg_slide(b, 0, "pedal", way, 0.0f, travel);
        else
            dmg_hinge(b, 0, "pedal", top, v3(-1, 0, 0), 0.0f, dmg_range(b, 0.15f, 0.5f));
        dmg_beam(b, v3_mad(at, v3(0, cosf(lean), sinf(lean)), -0.1f * size),
                 v3_mad(at, v3(0, cosf(lean), sinf(lean)), 0.1f * size), wide, 0.03f * size);
        if (arms || !slides) dmg_beam(b, at, top, 0.04f * size, 0.05f * size);
        dmg_use(b, 0);
        if (!slides) dmg_rod(b, v3_add(top, v3(-0.1f * size, 0, 0)), v3_add(top, v3(0.1f * size, 0, 0)), 0.03f * size);
    }
    dmg_box(b, v3(0, -0.1f * size, 1.7f * size), v3(1.2f * size, 0.9f * size, 0.05f * size));
}

/* Draws a hand brake, a gear stick or a switch beside the seat: a thin lever, its foot hidden or not. */
static void draw_hand_lever(dmg_builder* b, float size, float x) {
    float length = size * dmg_range(b, 0.15f, 0.6f), lean = dmg_range(b, -0.3f, 1.2f);
    dmg_vec foot = {x, 0.05f * size, 0.6f * size}, along = {0, cosf(lean), sinf(lean)};
    dmg_box(b, v3_add(foot, v3(0, -0.1f * size, 0)), v3(0.15f * size, 0.2f * size, 0.3f * size));
    bool both = dmg_chance(b, 0.5f);
    dmg_hinge(b, 0, "hand_lever", foot, v3(-1, 0, 0), both ? -0.3f : 0.0f, dmg_range(b, 0.25f, 0.6f));
    dmg_beam(b, v3_mad(foot, along, -0.05f * size), v3_mad(foot, along, length), 0.05f * size, 0.06f * size);
    if (dmg_chance(b, 0.5f))
        dmg_ellipsoid(b, v3_mad(foot, along, length), v3(0.06f * size, 0.06f * size, 0.06f * size));
    dmg_use(b, 0);
}

static void draw_seat(dmg_builder* b, float size) {
    dmg_rounded_box(b, v3(0, 0.05f * size, 0), v3(0.9f * size, 0.2f * size, 0.9f * size), 0.06f * size);
    bool tips = dmg_chance(b, 0.2f);
    if (tips) dmg_hinge(b, 0, "seat_back", v3(0, 0.1f * size, -0.45f * size), v3(1, 0, 0), -0.4f, 1.2f);
    dmg_beam(b, v3(0, 0.1f * size, -0.45f * size), v3(0, 1.1f * size, -0.65f * size), 0.9f * size, 0.15f * size);
    dmg_use(b, 0);
}

/* ---- chassis ---- */

typedef struct chassis {
    float length, width, floor, high, wheel;
    int body;   /* box, boards, shell that hides the wheels, tubes, taper */
    int driver; /* seats in a row, 0 none */
} chassis;

static void draw_tubes(dmg_builder* b, const chassis* c) {
    float x = 0.45f * c->width, t = 0.012f * c->length, top = c->floor + 1.6f * c->high;
    dmg_box(b, v3(0, c->floor + 0.05f * c->high, 0), v3(0.9f * c->width, 0.1f * c->high, c->length));
    for (int s = -1; s <= 1; s += 2) {
        const dmg_vec cage[] = {{(float)s * x, c->floor, -0.4f * c->length},
                                {(float)s * x, top, -0.25f * c->length},
                                {(float)s * x, top, 0.05f * c->length},
                                {(float)s * x, c->floor + 0.6f * c->high, 0.3f * c->length},
                                {(float)s * x, c->floor, 0.45f * c->length}};
        dmg_sweep(b, cage, 5, t, t, false);
    }
    for (int i = 0; i < 3; ++i) {
        float z = c->length * (0.3f - 0.27f * (float)i), y = i == 0 ? c->floor + 0.6f * c->high : top;
        dmg_rod(b, v3(-x, y, z), v3(x, y, z), t);
    }
}

static void draw_chassis_body(dmg_builder* b, const chassis* c) {
    dmg_vec middle = {0, c->floor + 0.5f * c->high, 0};
    float w = c->width, l = c->length;
    if (c->body == 0) dmg_box(b, middle, v3(w, c->high, l));
    if (c->body == 1) {
        dmg_box(b, v3(0, c->floor + 0.1f * c->high, 0), v3(w, 0.2f * c->high, l));
        dmg_box(b, v3(0, c->floor + 0.5f * c->high, dmg_range(b, -0.2f, 0.2f) * l), v3(0.6f * w, c->high, 0.5f * l));
    }
    if (c->body == 2) { /* wider than the track */
        const dmg_xy outline[] = {{0.62f * w, 0.35f * l},  {0.4f * w, 0.5f * l},    {-0.4f * w, 0.5f * l},
                                  {-0.62f * w, 0.35f * l}, {-0.62f * w, -0.4f * l}, {-0.5f * w, -0.5f * l},
                                  {0.5f * w, -0.5f * l},   {0.62f * w, -0.4f * l}};
        const dmg_row rows[] = {{1, 1, 0, 0}, {1.05f, 1.03f, 0, 0.3f * c->high}, {0.8f, 0.8f, 0, 2.2f * c->high}};
        dmg_save(b);
        dmg_move(b, 0, c->floor, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
        dmg_loft(b, outline, 8, rows, 3);
        dmg_restore(b);
    }
    if (c->body == 3) draw_tubes(b, c);
    if (c->body == 4) {
        dmg_beam(b, v3(0, c->floor + 0.5f * c->high, -0.5f * l), v3(0, c->floor + 0.3f * c->high, 0.5f * l), 0.7f * w,
                 0.5f * c->high);
        dmg_rod(b, v3(0, c->floor + 0.5f * c->high, -0.3f * l), v3(0, c->floor + 1.5f * c->high, -0.3f * l), 0.05f * w);
    }
}

/* Draws a bed behind that tips, a bonnet, or a lid over the engine. */
static void draw_chassis_lids(dmg_builder* b, const chassis* c) {
    float top = c->floor + c->high, t = 0.02f * c->length;
    if (c->body != 0 && c->body != 3) return;
    if (c->body == 3) top = c->floor + 0.5f * c->high;
    if (dmg_chance(b, 0.4f)) {
        dmg_vec low = {-0.48f * c->width, top, -0.5f * c->length},
                high = {0.48f * c->width, top + t, -0.1f * c->length};
        dmg_hinge(b, 0, "bed", v3(0, top, low.z), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 0.9f));
        dmg_box_span(b, low, high);
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.47f * c->width, top + 3 * t, -0.3f * c->length), v3(t, 6 * t, 0.4f * c->length));
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.3f)) {
        bool at_nose = dmg_chance(b, 0.3f);
        dmg_hinge(b, 0, "bonnet", v3(0, top, (at_nose ? 0.48f : 0.25f) * c->length), v3(at_nose ? 1.0f : -1.0f, 0, 0),
                  0.0f, dmg_range(b, 0.5f, 1.2f));
        dmg_box_span(b, v3(-0.4f * c->width, top, 0.25f * c->length), v3(0.4f * c->width, top + t, 0.48f * c->length));
        dmg_use(b, 0);
    }
}

static void draw_driver(dmg_builder* b, const chassis* c) {
    float size = c->width / ((float)c->driver + 0.3f);
    dmg_save(b);
    dmg_move(b, c->driver == 2 ? 0.5f * size : 0.0f, c->floor + (c->body == 3 ? 0.4f : 1.1f) * c->high, 0);
    draw_seat(b, size);
    draw_steering_wheel(b, size);
    if (dmg_chance(b, 0.6f)) draw_pedals(b, size);
    for (int i = dmg_int(b, 0, 2); i > 0; --i) draw_hand_lever(b, size, -0.35f * size - 0.2f * size * (float)i);
    dmg_restore(b);
}

void dmg_build_chassis(dmg_builder* b) {
    chassis c = {.length = dmg_scale_range(b, 0.2f, 4.0f), .body = dmg_int(b, 0, 4)};
    c.width = c.length * dmg_range(b, 0.35f, 0.8f);
    c.wheel = c.length * dmg_range(b, 0.05f, 0.17f);
    c.floor = c.wheel * dmg_range(b, 0.5f, 1.5f);
    c.high = c.length * dmg_range(b, 0.1f, 0.4f);
    if (c.body == 2) c.floor = fmaxf(c.floor, 1.1f * c.wheel); /* or it would swallow its wheels */
    static const float front[CORNER_KINDS] = {2, 5, 3, 1.5f, 1, 1, 1},
                       back[CORNER_KINDS] = {6, 0.5f, 0.3f, 2, 1, 1.5f, 1};
    corner fore = pick_corner(b, c.wheel, (corner_kind)dmg_weighted(b, front, CORNER_KINDS)), aft = fore;
    aft.kind = (corner_kind)dmg_weighted(b, back, CORNER_KINDS);
    if (dmg_chance(b, 0.2f)) aft.width *= dmg_range(b, 1.0f, 1.8f);
    draw_chassis_body(b, &c);
    float x = 0.5f * c.width + fore.width * dmg_range(b, 0.3f, 0.8f), base = dmg_range(b, 0.3f, 0.42f) * c.length;
    if (c.body == 4) x = fmaxf(x, 0.35f * c.width + fore.width);
    if (dmg_chance(b, 0.12f)) {
        draw_corner(b, &fore, 0, base + c.wheel + 0.1f * c.length);
    } else {
        for (int s = -1; s <= 1; s += 2) draw_corner(b, &fore, (float)s * x, base);
    }
    for (int s = -1; s <= 1; s += 2) {
        draw_corner(b, &aft, (float)s * x, -base);
        if (base > 2.2f * c.wheel && c.driver == 0 && c.body == 1) draw_corner(b, &aft, (float)s * x, 0);
    }
    draw_chassis_lids(b, &c);
    c.driver = c.body == 0 || c.body == 3 ? dmg_int(b, 0, 2) : 0;
    if (c.driver) draw_driver(b, &c);
}

/* ---- wheelchair ---- */

static void draw_small_caster(dmg_builder* b, float x, float z, float wheel, float high) {
    float trail = wheel * dmg_range(b, 0.2f, 0.8f), half = 0.35f * wheel;
    dmg_save(b);
    dmg_move(b, x, 0, z);
    uint32_t fork = dmg_spin(b, 0, "caster", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, 2.0f * wheel, 0), v3(0, high, 0), 0.15f * wheel);
    for (int s = -1; s <= 1; s += 2)
        dmg_beam(b, v3((float)s * half, 2.1f * wheel, -0.2f * trail), v3((float)s * half, 0.9f * wheel, -trail),
                 0.1f * wheel, 0.3f * wheel);
    dmg_box(b, v3(0, 2.15f * wheel, 0), v3(2.4f * half, 0.15f * wheel, 0.7f * wheel));
    dmg_move(b, 0, wheel, -trail);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, fork, "wheel", v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, dmg_int(b, 0, 2), wheel, 1.2f * half, 5);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a leg rest in front of the seat that swings aside or up, its plate folding up at the foot. */
static void draw_leg_rest(dmg_builder* b, float x, float z, float seat, float t) {
    float side = x < 0 ? -1.0f : 1.0f, foot = seat * dmg_range(b, 0.2f, 0.35f), wide = fabsf(x) * 0.75f;
    bool aside = dmg_chance(b, 0.5f);
    dmg_vec top = {x, seat, z}, low = {x, foot, z + 0.3f * seat};
    uint32_t rest = dmg_chance(b, 0.7f) ? dmg_hinge(b, 0, "leg_rest", top, aside ? v3(0, side, 0) : v3(-1, 0, 0), 0.0f,
                                                    aside ? 1.5f : 1.1f)
                                        : 0;
    dmg_rod(b, top, low, t);
    dmg_hinge(b, rest, "foot_plate", low, v3(0, 0, side), 0.0f, dmg_range(b, 1.2f, 1.57f));
    dmg_box(b, v3_add(low, v3(-side * 0.5f * wide, 0, 0.04f * seat)), v3(wide, 0.03f * seat, 0.3f * seat));
    dmg_use(b, 0);
}

void dmg_build_wheelchair(dmg_builder* b) {
    float wheel = dmg_range(b, 0.2f, 0.34f), seat = wheel * dmg_range(b, 1.5f, 2.1f),
          width = dmg_range(b, 0.36f, 0.55f), deep = dmg_range(b, 0.36f, 0.5f), t = dmg_range(b, 0.01f, 0.018f),
          back = seat + dmg_range(b, 0.35f, 0.55f), camber = dmg_chance(b, 0.4f) ? dmg_range(b, 0.02f, 0.15f) : 0.0f,
          x = 0.5f * width;
    corner big = {.kind = CORNER_FIXED,
                  .tread = dmg_chance(b, 0.8f) ? 3 : 2,
                  .spokes = dmg_int(b, 5, 12),
                  .radius = wheel,
                  .width = wheel * dmg_range(b, 0.06f, 0.16f),
                  .camber = camber};
    dmg_box(b, v3(0, seat, 0), v3(width, dmg_range(b, 0.01f, 0.06f), deep));
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s * x;
        dmg_rod(b, v3(side, wheel, -0.4f * deep), v3(side, back, -0.5f * deep), t);
        dmg_rod(b, v3(side, 0.5f * seat, -0.45f * deep), v3(side, 0.5f * seat, 0.5f * deep), t);
        dmg_rod(b, v3(side, 0.3f * seat, 0.5f * deep), v3(side, seat, 0.5f * deep), t);
        dmg_rod(b, v3(side, seat, -0.5f * deep), v3(side, seat, 0.5f * deep), t);
        dmg_rod(b, v3(side, back, -0.5f * deep), v3(side, back, -0.5f * deep - 0.12f), 1.3f * t);
        draw_corner(b, &big, side + (float)s * (0.6f * big.width + 2 * t), -0.35f * deep);
        draw_small_caster(b, side, 0.5f * deep, 0.12f * seat + 0.02f, 0.32f * seat);
        draw_leg_rest(b, side * 0.9f, 0.5f * deep + 1.5f * t, seat, t);
        if (dmg_chance(b, 0.7f)) { /* an arm rest, swinging back or fixed */
            float y = seat + dmg_range(b, 0.18f, 0.26f);
            if (dmg_chance(b, 0.6f)) dmg_hinge(b, 0, "arm_rest", v3(side, y, -0.48f * deep), v3(-1, 0, 0), 0.0f, 1.5f);
            dmg_box(b, v3(side, y, 0), v3(0.05f, 0.03f, 0.9f * deep));
            dmg_use(b, 0);
        }
        if (dmg_chance(b, 0.5f)) { /* a brake against the wheel */
            dmg_vec pin = {side + (float)s * 1.5f * t, 0.8f * seat, 0.35f * deep};
            dmg_hinge(b, 0, "brake", pin, v3(1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.7f));
            dmg_rod(b, v3_add(pin, v3(0, -0.03f, 0)), v3_add(pin, v3(0, 0.16f, 0.03f)), 0.7f * t);
            dmg_use(b, 0);
        }
    }
    if (dmg_chance(b, 0.3f)) dmg_hinge(b, 0, "back_rest", v3(0, seat, -0.5f * deep), v3(1, 0, 0), -0.5f, 1.3f);
    dmg_beam(b, v3(0, seat + 0.02f, -0.47f * deep), v3(0, back, -0.5f * deep), width - 2.5f * t, 0.03f);
    dmg_use(b, 0);
}
