/* Draws objects of no category: a body of any shape with turning, sliding, flapping and pressed parts on its faces.
 * They keep a network from relying on what a category usually looks like. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- a body, and the places on it where fittings go ---- */

enum { PLACE_LIMIT = 12 };

/* A rectangle on the surface: its middle, its outward normal and its half sizes. */
typedef struct place {
    dmg_vec at, normal, up;
    float half_width, half_height;
} place;

typedef struct body {
    place places[PLACE_LIMIT];
    int count;
} body;

static void add_place(body* out, dmg_vec at, dmg_vec normal, dmg_vec up, float half_width, float half_height) {
    if (out->count < PLACE_LIMIT) out->places[out->count++] = (place){at, normal, up, half_width, half_height};
}

static void add_box_places(body* out, dmg_vec c, dmg_vec h) {
    for (int s = -1; s <= 1; s += 2) {
        float f = (float)s;
        add_place(out, v3(c.x, c.y, c.z + f * h.z), v3(0, 0, f), v3(0, 1, 0), h.x, h.y);
        add_place(out, v3(c.x + f * h.x, c.y, c.z), v3(f, 0, 0), v3(0, 1, 0), h.z, h.y);
        if (s > 0) add_place(out, v3(c.x, c.y + h.y, c.z), v3(0, 1, 0), v3(0, 0, -1), h.x, h.z);
    }
}

/* Standing on y = 0. */
static body draw_body(dmg_builder* b, float size) {
    body out = {.count = 0};
    float x = 0.5f * size * dmg_scale_range(b, 0.25f, 1.0f), y = 0.5f * size * dmg_scale_range(b, 0.25f, 1.0f),
          z = 0.5f * size * dmg_scale_range(b, 0.25f, 1.0f);
    int kind = dmg_int(b, 0, 5);
    dmg_vec centre = {0, y, 0}, half = {x, y, z};
    if (kind <= 1) {
        if (kind == 0)
            dmg_box(b, centre, v3_scale(half, 2));
        else
            dmg_rounded_box(b, centre, v3_scale(half, 2), 0.4f * fminf(x, fminf(y, z)));
        add_box_places(&out, centre, v3_scale(half, kind == 0 ? 1.0f : 0.999f));
    }
    if (kind == 2) { /* a prism with slanted sides */
        float lean = fminf(y, z) * dmg_range(b, 0.2f, 0.9f);
        const dmg_xy side[] = {{-z, 0}, {z, 0}, {z - lean * 0.5f, 2 * y}, {-z + lean * 0.5f, 2 * y}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
        dmg_extrude(b, side, 4, -x, x);
        dmg_restore(b);
        dmg_vec slope = v3_normalize(v3(0, lean * 0.5f, 2 * y));
        add_place(&out, v3(0, y, z - 0.25f * lean), slope, v3_normalize(v3(0, 2 * y, -lean * 0.5f)), x, y);
        add_place(&out, v3(0, 2 * y, 0), v3(0, 1, 0), v3(0, 0, -1), x, z - 0.5f * lean);
        for (int s = -1; s <= 1; s += 2)
            add_place(&out, v3((float)s * x, y, 0), v3((float)s, 0, 0), v3(0, 1, 0), 0.6f * (z - 0.5f * lean), y);
    }
    if (kind == 3) { /* a drum, upright */
        float r = fminf(x, z);
        dmg_rod(b, v3(0, 0, 0), v3(0, 2 * y, 0), r);
        add_place(&out, v3(0, 2 * y, 0), v3(0, 1, 0), v3(0, 0, -1), 0.7f * r, 0.7f * r);
        for (int i = 0; i < 3; ++i) {
            float angle = 2.1f * (float)i;
            add_place(&out, v3(0.985f * r * sinf(angle), y, 0.985f * r * cosf(angle)), v3(sinf(angle), 0, cosf(angle)),
                      v3(0, 1, 0), 0.35f * r, y);
        }
    }
    if (kind == 4) { /* a drum, lying */
        float r = fminf(y, z);
        dmg_rod(b, v3(-x, r, 0), v3(x, r, 0), r);
        for (int s = -1; s <= 1; s += 2)
            add_place(&out, v3((float)s * x, r, 0), v3((float)s, 0, 0), v3(0, 1, 0), 0.7f * r, 0.7f * r);
        add_place(&out, v3(0, 1.99f * r, 0), v3(0, 1, 0), v3(0, 0, -1), x, 0.35f * r);
    }
    if (kind == 5) { /* two blocks */
        dmg_box(b, centre, v3_scale(half, 2));
        add_box_places(&out, centre, half);
        dmg_vec second = v3_scale(half, dmg_range(b, 0.4f, 0.8f));
        second.x *= dmg_range(b, 0.5f, 1.2f);
        dmg_vec at = {(x - second.x) * dmg_sign(b), 2 * y + second.y, 0};
        out.count = dmg_chance(b, 0.5f) ? 2 : 0; /* the top is taken */
        dmg_box(b, at, v3_scale(second, 2));
        add_box_places(&out, at, second);
    }
    return out;
}

/* Frame to the place: +Z out, +Y up along it. */
static void to_place(dmg_builder* b, const place* p) {
    dmg_vec right = v3_cross(p->up, p->normal);
    dmg_frame there = {{right, p->up, p->normal}, p->at};
    dmg_frame* top = &b->frames[b->frame_depth];
    *top = dmg_frame_multiply(top, &there);
}

/* ---- fittings on z = 0 within half sizes w, h ---- */

/* Draws a lid, hatch or door over the place. */
static void fit_leaf(dmg_builder* b, float w, float h) {
    dmg_leaf leaf = dmg_leaf_pick(b, dmg_range(b, 0.3f, 1.0f) * fminf(w, h));
    leaf.width = 2 * w;
    leaf.height = 2 * h;
    leaf.thickness = fminf(w, h) * dmg_range(b, 0.03f, 0.4f);
    leaf.side = (dmg_side)dmg_int(b, 0, 3);
    bool flush = dmg_chance(b, 0.5f);
    dmg_move(b, 0, 0, leaf.thickness * (flush ? dmg_range(b, 0.02f, 0.4f) : 1.0f));
    if (flush) leaf.depth = 0.0f;
    dmg_leaf_draw(b, 0, "cover", &leaf);
}

/* Draws a plate or block that slides across the place, or a drawer out of it. */
static void fit_slide(dmg_builder* b, float w, float h) {
    bool along = w > h;
    float travel = (along ? w : h) * dmg_range(b, 0.3f, 1.2f), t = fminf(w, h) * dmg_range(b, 0.05f, 0.6f),
          share = dmg_range(b, 0.3f, 0.9f);
    dmg_vec way = along ? v3(dmg_sign(b), 0, 0) : v3(0, dmg_sign(b), 0);
    int kind = dmg_int(b, 0, 2);
    if (kind == 2)
        for (int s = -1; s <= 1; s += 2) { /* rails */
            float f = (float)s;
            if (along)
                dmg_box(b, v3(0, 0.95f * f * h, 0.5f * t), v3(2 * w, 0.1f * h, 1.2f * t));
            else
                dmg_box(b, v3(0.95f * f * w, 0, 0.5f * t), v3(0.1f * w, 2 * h, 1.2f * t));
        }
    dmg_slide(b, 0, "slide", way, 0.0f, travel);
    float fill = kind == 2 ? 0.88f : 0.95f;
    dmg_vec size = along ? v3(2 * w * share, 2 * h * fill, t) : v3(2 * w * fill, 2 * h * share, t);
    dmg_vec at = v3_scale(way, -0.5f * travel);
    if (kind == 1)
        dmg_rounded_box(b, v3(at.x, at.y, 0.5f * t), size, 0.2f * t);
    else
        dmg_box(b, v3(at.x, at.y, 0.5f * t), size);
    if (dmg_chance(b, 0.4f)) dmg_box(b, v3(at.x, at.y, 1.1f * t), v3(0.3f * size.x, 0.3f * size.y, 0.3f * t));
}

static void fit_drawer(dmg_builder* b, float w, float h) {
    dmg_drawer drawer = dmg_drawer_pick(b, dmg_range(b, 0.3f, 1.0f) * fminf(w, h));
    drawer.width = 2 * w;
    drawer.height = 2 * h;
    drawer.thickness = fminf(w, h) * dmg_range(b, 0.05f, 0.3f);
    drawer.depth = fmaxf(w, h) * dmg_range(b, 0.4f, 1.2f);
    drawer.travel = 0.85f * drawer.depth;
    drawer.wall = 0.05f * fminf(w, h);
    dmg_move(b, 0, 0, dmg_chance(b, 0.5f) ? drawer.thickness : 0);
    dmg_drawer_draw(b, 0, "tray", &drawer);
}

/* Draws a rod that comes straight out, thin or thick, with a head or none. */
static void fit_rod(dmg_builder* b, float w, float h) {
    float radius = fminf(w, h) * dmg_range(b, 0.1f, 0.7f), length = radius * dmg_range(b, 1, 8);
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.5f * radius), 1.2f * radius);
    int motion = dmg_int(b, 0, 2);
    if (motion == 0) dmg_slide(b, 0, "rod", v3(0, 0, 1), 0.0f, length * dmg_range(b, 0.3f, 0.9f));
    if (motion == 1) dmg_slide(b, 0, "plunger", v3(0, 0, -1), 0.0f, length * dmg_range(b, 0.3f, 0.8f));
    if (motion == 2) {
        float pitch = radius * dmg_range(b, 0.02f, 0.2f), turns = dmg_range(b, 0.5f, 4);
        dmg_screw(b, 0, "screw", v3(0, 0, 0), v3(0, 0, 1), pitch, 0.0f, 2 * DMG_PI * turns);
    }
    dmg_rod(b, v3(0, 0, -0.5f * length), v3(0, 0, length), 0.6f * radius);
    if (dmg_chance(b, 0.6f)) {
        dmg_move(b, 0, 0, 0.9f * length);
        dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, 0.6f * radius);
    }
}

static void fit_knob(dmg_builder* b, float w, float h) {
    float radius = fminf(w, h) * dmg_range(b, 0.25f, 0.95f), upper = dmg_range(b, 0.8f, 5.5f),
          height = radius * dmg_scale_range(b, 0.2f, 2.0f);
    if (dmg_chance(b, 0.5f))
        dmg_spin(b, 0, "knob", v3(0, 0, 0), v3(0, 0, 1));
    else
        dmg_hinge(b, 0, "knob", v3(0, 0, 0), v3(0, 0, dmg_sign(b)), 0.0f, upper);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), radius, height);
    if (kind == 1) {
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * radius), 0.3f * radius);
        dmg_move(b, 0, 0, 0.6f * radius);
        dmg_wheel_draw(b, dmg_int(b, 0, DMG_WHEEL_KINDS - 1), radius, 0.3f * radius, 4);
    }
    if (kind == 2) { /* a crank */
        float grip = radius * dmg_range(b, 0.3f, 0.8f);
        dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 6));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.5f * radius), 0.15f * radius);
        dmg_beam(b, v3(-0.1f * radius, 0, 0.5f * radius), v3(radius, 0, 0.5f * radius), 0.1f * radius, 0.2f * radius);
        dmg_rod(b, v3(0.9f * radius, 0, 0.5f * radius), v3(0.9f * radius, 0, 0.5f * radius + grip), 0.12f * radius);
    }
}

/* Draws an arm on a pin between lugs, or from a hole: lies along the place or stands off it. */
static void fit_arm(dmg_builder* b, float w, float h) {
    float length = fmaxf(w, h) * dmg_range(b, 0.4f, 1.8f), t = fminf(w, h) * dmg_range(b, 0.05f, 0.2f),
          off = t * dmg_range(b, 0.0f, 2.0f), rest = dmg_range(b, 0.0f, 1.5f);
    int pin = dmg_int(b, 0, 2);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)dmg_int(b, 0, 3));
    dmg_move(b, 0, -0.6f * h, 0);
    for (int s = -1; s <= 1 && pin == 0; s += 2)
        dmg_box(b, v3((float)s * 1.1f * t, 0, 0.5f * off), v3(0.6f * t, 1.6f * t, off + 1.6f * t));
    dmg_hinge(b, 0, "arm", v3(0, 0, off), v3(1, 0, 0), -rest, 1.5f - 0.3f * rest);
    if (pin <= 1) dmg_rod(b, v3(-1.6f * t, 0, off), v3(1.6f * t, 0, off), 0.4f * t);
    dmg_vec end = {0, length * cosf(rest), off + length * sinf(rest)};
    int shape = dmg_int(b, 0, 3);
    if (shape == 0) dmg_beam(b, v3(0, 0, off), end, 1.4f * t, t);
    if (shape == 1) dmg_rod(b, v3(0, 0, off), end, 0.6f * t);
    if (shape == 2) dmg_cone(b, v3(0, 0, off), end, 0.5f * t, 1.2f * t);
    if (shape == 3) {
        const dmg_vec path[] = {{0, 0, off}, {0, 0.4f * end.y, off + 0.2f * length + 0.3f * (end.z - off)}, end};
        dmg_sweep(b, path, 3, 0.6f * t, 0.8f * t, false);
    }
    if (dmg_chance(b, 0.4f)) dmg_ellipsoid(b, end, v3(1.5f * t, 1.5f * t, 1.5f * t));
}

/* Draws a bail: both ends on the place, folds about the line between them. */
static void fit_bail(dmg_builder* b, float w, float h) {
    enum { POINTS = 7 };
    dmg_vec path[POINTS];
    float half = w * dmg_range(b, 0.3f, 0.9f), reach = fminf(h, w) * dmg_range(b, 0.5f, 1.5f),
          t = half * dmg_range(b, 0.04f, 0.15f), off = t * dmg_range(b, 0.5f, 2.0f);
    bool square = dmg_chance(b, 0.4f);
    for (int s = -1; s <= 1 && dmg_chance(b, 0.7f); s += 2)
        dmg_box(b, v3((float)s * half, 0, 0.5f * off), v3(3 * t, 3 * t, off + 2 * t));
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1);
        path[i] = v3(-half * cosf(angle), reach * sinf(angle), off);
        if (square)
            path[i] = v3(half * fmaxf(-1, fminf(1, -1.6f * cosf(angle))), reach * fminf(1, 1.8f * sinf(angle)), off);
    }
    dmg_hinge(b, 0, "bail", v3(0, 0, off), v3(1, 0, 0), 0.0f, DMG_PI * dmg_range(b, 0.4f, 0.98f));
    dmg_sweep(b, path, POINTS, t, t, false);
}

static void fit_buttons(dmg_builder* b, float w, float h) {
    int columns = dmg_int(b, 1, 3), rows = dmg_int(b, 1, 3);
    float px = 1.8f * w / (float)columns, py = 1.8f * h / (float)rows, fill = dmg_range(b, 0.3f, 0.9f),
          rise = fminf(px, py) * dmg_range(b, 0.05f, 0.5f);
    dmg_buttons set = {"button", columns, rows, px, py, px * fill, py * fill, rise, 0.6f * rise, dmg_int(b, 0, 3)};
    dmg_buttons_draw(b, 0, &set);
}

/* Draws a disc standing half out of the place. */
static void fit_roller(dmg_builder* b, float w, float h) {
    float radius = fminf(w, h) * dmg_range(b, 0.3f, 0.9f), wide = radius * dmg_range(b, 0.1f, 1.0f),
          up = radius * dmg_range(b, -0.3f, 1.2f);
    bool fork = up > 0.3f * radius;
    for (int s = -1; s <= 1 && fork; s += 2)
        dmg_box(b, v3((float)s * 0.65f * wide, 0, 0.5f * up), v3(0.15f * wide, 0.4f * radius, up + 0.3f * radius));
    dmg_move(b, 0, 0, up);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
    dmg_spin(b, 0, "roller", v3(0, 0, 0), v3(0, 0, 1));
    dmg_wheel_draw(b, dmg_int(b, 0, DMG_WHEEL_KINDS - 1), radius, wide, 5);
}

/* Draws a whole block on a pivot: turns about the place's normal, like a head on a neck. */
static void fit_head(dmg_builder* b, float w, float h) {
    float size = fminf(w, h) * dmg_range(b, 0.6f, 1.8f), neck = size * dmg_range(b, 0.0f, 0.5f),
          x = size * dmg_range(b, 0.4f, 1.5f), y = size * dmg_range(b, 0.4f, 1.5f), z = size * dmg_range(b, 0.3f, 1.0f),
          off = dmg_chance(b, 0.5f) ? 0.0f : 0.5f * y * dmg_range(b, -1, 1);
    if (dmg_chance(b, 0.4f))
        dmg_hinge(b, 0, "head", v3(0, 0, 0), v3(0, 0, 1), -1.5f, 1.5f);
    else
        dmg_spin(b, 0, "head", v3(0, 0, 0), v3(0, 0, 1));
    if (neck > 0.0f) dmg_rod(b, v3(0, 0, 0), v3(0, 0, neck), 0.2f * size);
    int shape = dmg_int(b, 0, 3);
    if (shape == 0) dmg_box(b, v3(0, off, neck + 0.5f * z), v3(x, y, z));
    if (shape == 1) dmg_rounded_box(b, v3(0, off, neck + 0.5f * z), v3(x, y, z), 0.3f * fminf(z, fminf(x, y)));
    if (shape == 2) dmg_ellipsoid(b, v3(0, off, neck + 0.5f * z), v3(0.5f * x, 0.5f * y, 0.5f * z));
    if (shape == 3) {
        dmg_beam(b, v3(0, 0, neck), v3(0, 1.5f * y, neck + 0.3f * z), 0.3f * size, 0.3f * size);
        dmg_box(b, v3(0, 1.5f * y, neck + 0.5f * z), v3(0.8f * x, 0.5f * y, z));
    }
}

/* Something that does not move, so that not everything that sticks out does. */
static void fit_nothing(dmg_builder* b, float w, float h) {
    float size = fminf(w, h);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_knob_draw(b, dmg_int(b, 0, DMG_KNOB_KINDS - 1), 0.5f * size, 0.4f * size);
    if (kind == 1) dmg_box(b, v3(0, 0, 0.1f * size), v3(1.5f * w, 1.5f * h, 0.3f * size));
    if (kind == 2) dmg_frame_draw(b, 1.8f * w, 1.8f * h, 0.1f * size, 0.1f * size);
    if (kind == 3) dmg_rod(b, v3(0, 0, 0), v3(0, 0, size), 0.2f * size);
}

static void draw_fitting(dmg_builder* b, const place* p, bool must_move) {
    static void (*const fittings[])(dmg_builder*, float, float) = {fit_leaf,   fit_slide, fit_drawer, fit_rod,
                                                                   fit_knob,   fit_arm,   fit_bail,   fit_buttons,
                                                                   fit_roller, fit_head,  fit_nothing};
    static const float weights[] = {3, 1.5f, 1.5f, 1, 1.5f, 1.5f, 1, 1, 1, 1, 2};
    float fill = dmg_chance(b, 0.3f) ? 0.999f : dmg_range(b, 0.3f, 0.95f), even = dmg_range(b, 0.6f, 1.0f);
    float w = p->half_width * fill, h = p->half_height * fill * even;
    dmg_save(b);
    to_place(b, p);
    dmg_move(b, (p->half_width - w) * dmg_range(b, -0.9f, 0.9f), 0, 0);
    dmg_use(b, 0);
    fittings[dmg_weighted(b, weights, must_move ? 10 : 11)](b, w, h);
    dmg_use(b, 0);
    dmg_restore(b);
}

void dmg_build_gadget(dmg_builder* b) {
    body made = draw_body(b, dmg_scale_range(b, 0.05f, 2.0f));
    float share = dmg_range(b, 0.3f, 0.9f);
    int must = dmg_int(b, 0, made.count - 1);
    for (int i = 0; i < made.count; ++i) {
        bool here = dmg_chance(b, share) || i == must;
        if (here) draw_fitting(b, &made.places[i], i == must);
    }
}
