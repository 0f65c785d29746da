/* Draws tripods: legs that spread round a middle, telescoping tubes, their locks, and the head on top. */
#include "core/build.h"
#include "parts/hardware.h"

/* Lengths in metres. The shoulder's middle is the origin; legs hang from pins round it, drawn folded. */
typedef struct tripod {
    int legs, sections;
    int tube;           /* round, square, two rods side by side, a flat wooden bar */
    float hub, tall;    /* of the shoulder */
    float pin;          /* of the leg from the middle */
    float leg, radius;  /* of the leg's uppermost section */
    float spread, most; /* angles from upright: as it stands, and at the stop */
    float out;          /* how far each section is drawn out, share of the leg */
    float column;       /* radius */
    float up;           /* the column's top above the shoulder */
    int lock;           /* none, a lever, a collar to twist, a screw with a wing */
    bool braced;
} tripod;

static tripod pick_tripod(dmg_builder* b) {
    static const float tubes[] = {5, 2, 1.5f, 1.5f}, locks[] = {4, 3, 2, 1};
    float size = dmg_scale_range(b, 0.15f, 1.4f);
    tripod t = {.legs = 3};
    if (dmg_chance(b, 0.1f)) t.legs = dmg_int(b, 4, 5);
    t.sections = dmg_int(b, 1, 4);
    t.tube = dmg_weighted(b, tubes, 4);
    t.lock = dmg_weighted(b, locks, 4);
    t.leg = size * dmg_range(b, 0.3f, 0.7f);
    t.radius = t.leg * dmg_range(b, 0.02f, 0.05f);
    t.hub = t.radius * dmg_range(b, 1.5f, 3.0f);
    t.tall = t.radius * dmg_range(b, 1.5f, 4.0f);
    t.pin = t.hub + t.radius * dmg_range(b, 0.4f, 1.2f);
    t.spread = dmg_range(b, 0.25f, 0.6f);
    t.most = t.spread + dmg_range(b, 0.05f, 0.9f);
    if (dmg_chance(b, 0.2f)) t.spread = dmg_range(b, 0.0f, 0.1f); /* folded */
    t.out = dmg_chance(b, 0.35f) ? 0.0f : dmg_range(b, 0.1f, 0.85f);
    t.column = t.hub * dmg_range(b, 0.3f, 0.6f);
    t.up = t.tall + t.leg * dmg_range(b, 0.05f, 0.3f);
    t.braced = dmg_chance(b, 0.3f);
    return t;
}

/* ---- legs: along -Y through x = pin, opening outwards about Z ---- */

static void draw_section(dmg_builder* b, const tripod* t, float r, float from, float to) {
    dmg_vec top = v3(t->pin, from, 0), end = v3(t->pin, to, 0);
    if (t->tube == 0) dmg_rod(b, top, end, r);
    if (t->tube == 1) dmg_box_span(b, v3(t->pin - r, to, -r), v3(t->pin + r, from, r));
    if (t->tube == 3) dmg_box_span(b, v3(t->pin - 0.6f * r, to, -1.3f * r), v3(t->pin + 0.6f * r, from, 1.3f * r));
    if (t->tube != 2) return;
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(t->pin, from, (float)s * r), v3(t->pin, to, (float)s * r), 0.45f * r);
    dmg_box_span(b, v3(t->pin - 0.5f * r, to, -1.4f * r), v3(t->pin + 0.5f * r, to + r, 1.4f * r));
}

/* At the lower end y of a section of radius r: a sleeve, and what holds the next one. */
static void draw_lock(dmg_builder* b, const tripod* t, uint32_t carrier, float r, float y) {
    float sleeve = 1.25f * r, tall = 2.2f * r;
    dmg_use(b, carrier);
    if (t->lock == 2) {
        dmg_hinge(b, carrier, "twist_lock", v3(t->pin, y, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 0.8f, 3.0f));
        dmg_rod(b, v3(t->pin, y, 0), v3(t->pin, y + tall, 0), sleeve);
        int ribs = dmg_int(b, 4, 8);
        for (int i = 0; i < ribs; ++i) {
            float angle = 2.0f * DMG_PI * (float)i / (float)ribs, x = sleeve * cosf(angle), z = sleeve * sinf(angle);
            dmg_box(b, v3(t->pin + x, y + 0.5f * tall, z), v3(0.3f * r, 0.9f * tall, 0.3f * r));
        }
        return;
    }
    dmg_box_span(b, v3(t->pin - sleeve, y, -1.5f * sleeve), v3(t->pin + sleeve, y + tall, 1.5f * sleeve));
    if (t->lock == 1) { /* a lever on a pin at the sleeve's edge, flat on it when shut */
        bool upright = dmg_chance(b, 0.5f);
        float x = t->pin + sleeve;
        if (upright)
            dmg_hinge(b, carrier, "lever", v3(x, y, -1.3f * sleeve), v3(0, -1, 0), 0.0f, dmg_range(b, 1.2f, 2.6f));
        else
            dmg_hinge(b, carrier, "lever", v3(x, y + tall, 0), v3(0, 0, 1), 0.0f, dmg_range(b, 1.2f, 2.6f));
        float low = upright ? y + 0.2f * tall : y - tall;
        dmg_box_span(b, v3(x, low, upright ? -1.5f * sleeve : -sleeve), v3(x + 0.5f * r, y + 0.9f * tall, sleeve));
    }
    if (t->lock == 3) {
        float pitch = 0.04f * r;
        dmg_screw(b, carrier, "wing_screw", v3(t->pin, y + 0.5f * tall, 0), v3(1, 0, 0), pitch, 0.0f, 12.0f);
        dmg_rod(b, v3(t->pin, y + 0.5f * tall, 0), v3(t->pin + 2.0f * sleeve, y + 0.5f * tall, 0), 0.3f * r);
        dmg_box(b, v3(t->pin + 2.2f * sleeve, y + 0.5f * tall, 0), v3(1.2f * r, 0.4f * r, 2.6f * r));
    }
}

static void draw_foot(dmg_builder* b, const tripod* t, uint32_t carrier, int kind, float r, float y) {
    dmg_use(b, carrier);
    if (kind == 0) dmg_ellipsoid(b, v3(t->pin, y, 0), v3(1.5f * r, 1.5f * r, 1.5f * r));
    if (kind == 1) dmg_cone(b, v3(t->pin, y - 3.0f * r, 0), v3(t->pin, y, 0), 0.0f, 1.1f * r);
    if (kind == 2) { /* a pad that tips */
        dmg_hinge(b, carrier, "pad", v3(t->pin, y, 0), v3(0, 0, 1), -0.8f, 0.8f);
        dmg_rod(b, v3(t->pin, y - 1.3f * r, 0), v3(t->pin, y - 0.7f * r, 0), 2.2f * r);
        dmg_ellipsoid(b, v3(t->pin, y, 0), v3(1.2f * r, 1.2f * r, 1.2f * r));
    }
}

static void draw_leg(dmg_builder* b, const tripod* t, int foot, float spread) {
    float r = t->radius, y = -t->leg;
    dmg_use(b, 0);
    for (int s = -1; s <= 1; s += 2) /* the fork that holds the pin */
        dmg_box_span(b, v3(0.5f * t->hub, -0.8f * r, (float)s * 1.7f * r - 0.25f * r),
                     v3(t->pin + 0.6f * r, 0.8f * r, (float)s * 1.7f * r + 0.25f * r));
    uint32_t carrier = dmg_hinge(b, 0, "leg", v3(t->pin, 0, 0), v3(0, 0, 1), 0.0f, t->most);
    dmg_rest(b, carrier, spread);
    dmg_rod(b, v3(t->pin, 0, -1.4f * r), v3(t->pin, 0, 1.4f * r), 0.8f * r);
    draw_section(b, t, r, 0.0f, y);
    for (int i = 1; i < t->sections; ++i) {
        float inner = 0.78f * r;
        draw_lock(b, t, carrier, r, y);
        carrier = dmg_slide(b, carrier, "section", v3(0, -1, 0), 0.0f, 0.9f * t->leg);
        dmg_rest(b, carrier, fminf(0.9f, t->out) * t->leg);
        float end = y - 2.5f * r;
        draw_section(b, t, inner, -0.1f * t->leg, end);
        r = inner;
        y = end;
    }
    draw_foot(b, t, carrier, foot, r, y);
    dmg_use(b, 0);
}

/* Struts from a collar on the stem to the legs as they stand; the collar slides. */
static void draw_braces(dmg_builder* b, const tripod* t) {
    float at = t->leg * dmg_range(b, 0.4f, 0.7f), x = t->pin + at * sinf(t->spread) - t->radius,
          y = -at * cosf(t->spread);
    float stem = 0.55f * t->hub, foot = y + at * dmg_range(b, -0.25f, 0.25f), thick = 0.5f * t->radius;
    dmg_rod(b, v3(0, -0.9f * t->leg * cosf(t->spread), 0), v3(0, 0, 0), stem);
    uint32_t collar = dmg_slide(b, 0, "collar", v3(0, 1, 0), -0.1f * t->leg, 0.25f * t->leg);
    dmg_rod(b, v3(0, foot - 2 * thick, 0), v3(0, foot + 2 * thick, 0), 1.6f * stem);
    for (int i = 0; i < t->legs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, t->legs);
        dmg_use(b, collar);
        dmg_box(b, v3(1.8f * stem, foot, 0), v3(stem, 2 * thick, 3 * thick));
        dmg_hinge(b, collar, "strut", v3(2.2f * stem, foot, 0), v3(0, 0, 1), -0.4f, 0.6f);
        dmg_beam(b, v3(2.2f * stem, foot, 0), v3(x, y, 0), 1.5f * thick, thick);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* ---- the column and what it carries: `carrier`'s top is at y = 0, its radius r ---- */

static void draw_plate(dmg_builder* b, uint32_t carrier, float w, float y) {
    float t = 0.15f * w;
    int kind = dmg_int(b, 0, 3);
    dmg_use(b, carrier);
    dmg_box(b, v3(0, y + 0.5f * t, 0), v3(w, t, 1.2f * w));
    if (kind == 1) { /* a camera's plate in its rail, and the lever that holds it */
        dmg_slide(b, carrier, "plate", v3(0, 0, 1), 0.0f, w * dmg_range(b, 0.4f, 1.0f));
        dmg_box(b, v3(0, y + 1.4f * t, 0), v3(0.7f * w, 0.8f * t, 1.1f * w));
        dmg_hinge(b, carrier, "plate_lever", v3(0.5f * w + t, y, 0.4f * w), v3(0, -1, 0), 0.0f,
                  dmg_range(b, 0.8f, 2.0f));
        dmg_box_span(b, v3(0.5f * w, y, -0.3f * w), v3(0.5f * w + 1.2f * t, y + t, 0.5f * w));
    }
    if (kind == 2) { /* a clamp for a telephone */
        float open = w * dmg_range(b, 0.6f, 1.5f);
        dmg_box_span(b, v3(-0.4f * w, y + t, -1.2f * t), v3(0.4f * w, y + 1.6f * w, -0.2f * t));
        dmg_box_span(b, v3(-0.4f * w, y + t, -t), v3(0.4f * w, y + 2 * t, 2.5f * t));
        dmg_slide(b, carrier, "jaw", v3(0, 1, 0), 0.0f, open);
        dmg_box_span(b, v3(-0.3f * w, y + 0.6f * w, -0.2f * t), v3(0.3f * w, y + 1.65f * w, 0.5f * t));
        dmg_box_span(b, v3(-0.4f * w, y + 1.65f * w, -1.2f * t), v3(0.4f * w, y + 1.65f * w + t, 2.5f * t));
    }
    if (kind == 3) dmg_rounded_box(b, v3(0, y + t + 0.5f * w, 0), v3(1.6f * w, w, 0.8f * w), 0.1f * w);
}

static void draw_handle(dmg_builder* b, dmg_vec from, dmg_vec way, float length, float r) {
    dmg_rod(b, from, v3_mad(from, way, length), 0.5f * r);
    dmg_rod(b, v3_mad(from, way, 0.6f * length), v3_mad(from, way, length), r);
}

static void draw_head(dmg_builder* b, uint32_t carrier, float r) {
    float w = r * dmg_range(b, 2.5f, 5.0f), y = 0.35f * w, tip = dmg_range(b, 0.5f, 1.5f),
          reach = w * dmg_range(b, 1.5f, 4.0f);
    int kind = dmg_int(b, 0, 3);
    if (kind == 3) { /* a bare plate, as surveyors' and painters' stands have */
        dmg_use(b, carrier);
        draw_plate(b, carrier, 1.5f * w, 0.0f);
        return;
    }
    uint32_t pan = dmg_chance(b, 0.7f) ? dmg_spin(b, carrier, "pan", v3(0, 0, 0), v3(0, 1, 0))
                                       : dmg_hinge(b, carrier, "pan", v3(0, 0, 0), v3(0, 1, 0), -2.5f, 2.5f);
    dmg_rod(b, v3(0, 0, 0), v3(0, y, 0), 0.5f * w);
    for (int s = -1; s <= 1 && kind != 2; s += 2)
        dmg_box_span(b, v3((float)s * 0.4f * w - 0.07f * w, y, -0.25f * w),
                     v3((float)s * 0.4f * w + 0.07f * w, y + 0.7f * w, 0.25f * w));
    if (kind == 2) dmg_cone(b, v3(0, y, 0), v3(0, y + 0.35f * w, 0), 0.5f * w, 0.4f * w);
    float line = y + 0.5f * w;
    uint32_t tilt = dmg_hinge(b, pan, "tilt", v3(0, line, 0), v3(1, 0, 0), -tip, dmg_range(b, 0.4f, 1.3f));
    if (kind == 2) { /* a ball in its cup */
        dmg_ellipsoid(b, v3(0, line, 0), v3(0.36f * w, 0.36f * w, 0.36f * w));
        dmg_rod(b, v3(0, line, 0), v3(0, line + 0.6f * w, 0), 0.15f * w);
    } else {
        dmg_rod(b, v3(-0.5f * w, line, 0), v3(0.5f * w, line, 0), 0.18f * w);
        dmg_box_span(b, v3(-0.3f * w, line - 0.2f * w, -0.25f * w), v3(0.3f * w, line + 0.6f * w, 0.25f * w));
        if (dmg_chance(b, 0.7f))
            draw_handle(b, v3(0.2f * w, line, -0.2f * w), v3_normalize(v3(0.2f, -0.4f, -1)), reach, 0.12f * w);
    }
    uint32_t top = tilt;
    if (kind == 1) { /* a third line, with a handle of its own */
        top = dmg_hinge(b, tilt, "side_tilt", v3(0, line + 0.75f * w, 0), v3(0, 0, 1), -0.3f, dmg_range(b, 0.8f, 1.5f));
        dmg_rod(b, v3(0, line + 0.75f * w, -0.4f * w), v3(0, line + 0.75f * w, 0.4f * w), 0.18f * w);
        draw_handle(b, v3(0.1f * w, line + 0.75f * w, 0.2f * w), v3_normalize(v3(1, -0.4f, 0.2f)), 0.8f * reach,
                    0.12f * w);
        line += 0.3f * w;
    }
    draw_plate(b, top, w, line + 0.6f * w);
}

/* Draws a tube through the shoulder, raised by hand or by a crank. */
static uint32_t draw_column(dmg_builder* b, const tripod* t) {
    float below = t->leg * dmg_range(b, 0.2f, 0.6f);
    uint32_t column = 0;
    if (dmg_chance(b, 0.75f)) {
        column = dmg_slide(b, 0, "column", v3(0, 1, 0), 0.0f, 0.9f * below);
        dmg_rest(b, column, dmg_chance(b, 0.5f) ? 0.0f : 0.6f * below);
        dmg_rod(b, v3(0, -below, 0), v3(0, t->up, 0), t->column);
        if (dmg_chance(b, 0.4f))
            dmg_torus(b, v3(0, -below - 0.8f * t->column, 0), v3(0, 0, 1), 0.8f * t->column, 0.2f * t->column);
    } else {
        dmg_rod(b, v3(0, 0, 0), v3(0, t->up, 0), t->column);
    }
    dmg_use(b, 0);
    float y = t->tall + 0.6f * t->radius, side = DMG_PI / (float)t->legs;
    dmg_rod(b, v3(0, 0, 0), v3(0, y + 0.6f * t->radius, 0), 1.3f * t->column);
    dmg_vec out = v3(cosf(side), 0, -sinf(side)), from = v3(0, y, 0);
    dmg_vec root = v3_mad(from, out, t->column), end = v3_mad(from, out, t->hub + t->radius);
    int kind = dmg_int(b, 0, 2);
    if (kind == 1) {
        dmg_spin(b, 0, "crank", from, out);
        dmg_rod(b, root, end, 0.3f * t->radius);
        dmg_vec arm = v3_mad(end, v3(0, 1, 0), 2.5f * t->radius);
        dmg_beam(b, end, arm, 0.6f * t->radius, 0.6f * t->radius);
        dmg_rod(b, arm, v3_mad(arm, out, 2.0f * t->radius), 0.4f * t->radius);
    }
    if (kind == 2) {
        dmg_screw(b, 0, "column_screw", from, out, -0.03f * t->radius, 0.0f, dmg_range(b, 3.0f, 15.0f));
        dmg_rod(b, root, end, 0.3f * t->radius);
        dmg_box(b, v3_mad(from, out, t->hub + 1.3f * t->radius),
                v3(0.9f * t->radius, 1.8f * t->radius, 0.9f * t->radius));
    }
    return column;
}

void dmg_build_tripod(dmg_builder* b) {
    tripod t = pick_tripod(b);
    int foot = dmg_int(b, 0, 2);
    float reach = t.leg * (1.0f + (float)(t.sections - 1) * t.out);
    dmg_move(b, 0, reach * cosf(t.spread) + 4.0f * t.radius, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, 0, 2));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, -0.8f * t.radius, 0), v3(0, t.tall, 0), t.hub);
    else
        dmg_cone(b, v3(0, -0.8f * t.radius, 0), v3(0, t.tall, 0), t.hub, 0.6f * t.hub);
    for (int i = 0; i < t.legs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, t.legs);
        draw_leg(b, &t, foot, t.spread);
        dmg_restore(b);
    }
    if (t.braced && t.spread > 0.2f) draw_braces(b, &t);
    uint32_t column = draw_column(b, &t);
    dmg_move(b, 0, t.up, 0);
    draw_head(b, column, t.column);
}
