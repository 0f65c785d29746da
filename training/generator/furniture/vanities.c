/* Draws dressing tables and dressers with a mirror that tilts, folds, lifts or slides; mirrors on feet and boxes in
 * them. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct vanity {
    float w, d, h; /* of the table, without the mirror */
    float t;       /* of its top and boards */
    float open;    /* chance of anything to stand open */
    bool inset;
    dmg_drawer box;
    dmg_leaf leaf;
} vanity;

/* ---- mirrors: centred, front at z = 0 ---- */

typedef struct glass {
    int shape; /* rectangle, oval, arch, soft rectangle, framed panel */
    float w, h, t, rim;
} glass;

static glass pick_glass(dmg_builder* b, float w, float h, float t) {
    glass g = {.shape = dmg_int(b, 0, 4), .w = w, .h = h, .t = t};
    g.rim = dmg_chance(b, 0.6f) ? dmg_range(b, 0.04f, 0.15f) : 0.0f;
    return g;
}

enum { OUTLINE = 24 };

/* Superellipses; an arch is a rectangle below its middle. */
static void outline_of(const glass* g, float share, dmg_xy* out) {
    for (int i = 0; i < OUTLINE; ++i) {
        float a = 2.0f * DMG_PI * ((float)i + 0.5f) / OUTLINE, c = cosf(a), s = sinf(a);
        float power = g->shape == 1 || (g->shape == 2 && s > 0.0f) ? 1.0f : (g->shape == 3 ? 0.4f : 0.15f);
        out[i] = (dmg_xy){0.5f * share * g->w * copysignf(powf(fabsf(c), power), c),
                          0.5f * share * g->h * copysignf(powf(fabsf(s), power), s)};
    }
}

static void draw_glass(dmg_builder* b, const glass* g) {
    dmg_xy outer[OUTLINE], inner[OUTLINE];
    if (g->shape == 4) {
        dmg_panel panel = {.kind = DMG_PANEL_WINDOW, .border = fmaxf(g->rim, 0.05f), .infill = 0.8f};
        dmg_panel_draw(b, &panel, g->w, g->h, g->t);
        return;
    }
    if (g->shape == 0 && g->rim == 0.0f) {
        dmg_box(b, v3(0, 0, -0.5f * g->t), v3(g->w, g->h, g->t));
        return;
    }
    outline_of(g, 1.0f, outer);
    outline_of(g, 1.0f - 2.0f * g->rim, inner);
    if (g->rim > 0.0f) dmg_ring_plate(b, outer, inner, OUTLINE, -g->t, 0);
    dmg_extrude(b, g->rim > 0.0f ? inner : outer, OUTLINE, -g->t, g->rim > 0.0f ? -0.4f * g->t : 0.0f);
}

/* Hangs on two pins between posts on y = 0, or in a fork that may turn on its foot. */
static void draw_tilting(dmg_builder* b, const vanity* v, float w, float h, float z) {
    glass g = pick_glass(b, w, h, dmg_range(b, 0.7f, 1.6f) * v->t);
    float post = v->t * dmg_range(b, 0.3f, 0.8f), high = h * dmg_range(b, 0.0f, 0.12f),
          foot = h * dmg_range(b, 0.04f, 0.15f), pin = foot + 0.5f * h + high,
          x = 0.5f * w + post * dmg_range(b, 1.6f, 3.5f), far = dmg_range(b, 0.2f, 0.7f);
    int kind = dmg_int(b, 0, 2);
    uint32_t carrier = 0;
    dmg_save(b);
    dmg_move(b, 0, 0, z);
    if (kind == 2) { /* a fork */
        if (dmg_chance(b, 0.5f)) carrier = dmg_spin(b, 0, "fork", v3(0, 0, 0), v3(0, 1, 0));
        const dmg_vec fork[] = {
            {-x, pin, 0}, {-x, 0.35f * foot, 0}, {0, 0.25f * foot, 0}, {x, 0.35f * foot, 0}, {x, pin, 0}};
        dmg_sweep(b, fork, 5, post, post, false);
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.3f * foot, 0), 2 * post);
    }
    for (int s = -1; s <= 1 && kind < 2; s += 2) {
        float at = (float)s * x, over = pin * dmg_range(b, 1.03f, 1.3f);
        if (kind == 0) dmg_box_span(b, v3(at - post, 0, -1.5f * post), v3(at + post, over, 1.5f * post));
        if (kind == 1) dmg_cone(b, v3(at, 0, 0), v3(at, over, 0), 1.4f * post, 0.9f * post);
    }
    uint32_t part = dmg_hinge(b, carrier, "mirror", v3(0, pin, 0), v3(1, 0, 0), -far, far * dmg_range(b, 0.6f, 1.2f));
    for (int s = -1; s <= 1; s += 2) {
        dmg_rod(b, v3(0.45f * (float)s * w, pin, 0), v3((float)s * x, pin, 0), 0.5f * post);
        if (dmg_chance(b, 0.3f))
            dmg_rod(b, v3((float)s * (x + 1.1f * post), pin, 0), v3((float)s * (x + 2.5f * post), pin, 0), 1.2f * post);
    }
    dmg_move(b, 0, foot + 0.5f * h, 0.5f * g.t);
    draw_glass(b, &g);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, part, dmg_range(b, -0.8f, 0.5f) * far);
    dmg_use(b, 0);
}

/* Draws a fixed one in the middle, one on hinges at each of its sides. */
static void draw_winged(dmg_builder* b, const vanity* v, float w, float h, float z) {
    float t = dmg_range(b, 0.6f, 1.3f) * v->t, share = dmg_range(b, 0.4f, 0.62f), middle = share * w,
          wing = fminf(0.5f * (w - middle), 0.98f * middle), foot = dmg_range(b, 0.0f, 0.1f) * h,
          low = h * dmg_range(b, 0.75f, 1.0f), far = dmg_range(b, 1.0f, wing < 0.49f * middle ? 3.0f : 1.5f);
    glass g = pick_glass(b, middle, h, t), side = g;
    side.w = 0.98f * wing;
    side.h = low;
    bool knuckles = dmg_chance(b, 0.5f);
    dmg_save(b);
    dmg_move(b, 0, foot + 0.5f * h, z);
    draw_glass(b, &g);
    if (foot > 0.0f) dmg_box_span(b, v3(-0.3f * middle, -0.5f * h - foot, -t), v3(0.3f * middle, -0.4f * h, -0.1f * t));
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        if (s > 0) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -0.5f * middle, 0, 0);
        uint32_t part = dmg_hinge(b, 0, "wing", v3(0, 0, 0), v3(0, 1, 0), 0.0f, far);
        for (int k = -1; k <= 1 && knuckles; k += 2)
            dmg_rod(b, v3(0, 0.3f * (float)k * low - 0.04f * h, 0), v3(0, 0.3f * (float)k * low + 0.04f * h, 0),
                    0.3f * t);
        dmg_move(b, -0.5f * wing, 0.5f * (low - h), 0);
        draw_glass(b, &side);
        dmg_restore(b);
        if (dmg_chance(b, 0.6f)) dmg_rest(b, part, far * dmg_range(b, 0.1f, 0.8f));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

/* It slides up out of a slot behind the table, or along rails before shelves. */
static void draw_sliding(dmg_builder* b, const vanity* v, float w, float h, float z) {
    float t = dmg_range(b, 0.5f, 1.2f) * v->t, far = dmg_range(b, 0.6f, 0.95f);
    bool up = dmg_chance(b, 0.5f);
    glass g = pick_glass(b, up ? w : 0.5f * w, fminf(h, up ? 0.85f * v->h : h), t);
    uint32_t part;
    dmg_save(b);
    if (up) {
        float back = -0.5f * v->d - 0.3f * t;
        dmg_box_span(b, v3(-0.52f * w, -1.05f * g.h, back - 1.6f * t), v3(0.52f * w, 0, back - 1.2f * t));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3(0.53f * (float)s * w, -0.5f * g.h, back - 0.65f * t), v3(0.04f * w, 1.1f * g.h, 2 * t));
        part = dmg_slide(b, 0, "mirror", v3(0, 1, 0), 0.0f, far *= g.h);
        dmg_move(b, 0, -0.47f * g.h, back);
        draw_glass(b, &g);
    } else {
        float deep = fminf(0.4f * v->d, 0.3f * w), side = dmg_sign(b), face = z + 2.2f * t;
        dmg_move(b, 0, 0.5f * h, face - 2 * t);
        dmg_case_draw(b, DMG_CASE_BOARDS, w, h, fminf(deep, 0.5f * v->d + face - 2 * t), v->t);
        dmg_box(b, v3(dmg_range(b, -0.2f, 0.2f) * w, 0, -0.4f * deep), v3(0.7f * v->t, h, 0.7f * deep));
        for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, 0.47f * (float)s * h, 0.3f * t), v3(w, 0.03f * h, 0.6f * t));
        far *= w - g.w;
        g.h *= 0.96f;
        part = dmg_slide(b, 0, "mirror", v3(-side, 0, 0), 0.0f, far);
        dmg_move(b, side * 0.5f * (w - g.w), 0, 0.7f * t + t);
        draw_glass(b, &g);
    }
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, part, far * dmg_range(b, 0.2f, 1.0f));
    dmg_use(b, 0);
}

/* Draws a round one on an arm that turns about a post; a second joint tilts it. */
static void draw_on_arm(dmg_builder* b, const vanity* v, float w, float h) {
    float x = 0.25f * dmg_sign(b) * v->w, r = 0.5f * fminf(0.5f * w, 0.6f * h), rod = 0.25f * v->t + 0.04f * r,
          reach = dmg_range(b, 0.1f, 0.8f) * v->d, tall = r * dmg_range(b, 1.4f, 2.2f), far = dmg_range(b, 0.4f, 1.2f);
    dmg_save(b);
    dmg_move(b, x, 0, -0.35f * v->d);
    dmg_cone(b, v3(0, 0, 0), v3(0, 2 * rod, 0), 3 * rod, 1.5f * rod);
    uint32_t arm = dmg_hinge(b, 0, "arm", v3(0, 0, 0), v3(0, 1, 0), -1.2f, 1.2f);
    const dmg_vec path[] = {{0, rod, 0}, {0, tall, 0}, {0, 1.05f * tall, 0.1f * reach}, {0, 1.05f * tall, reach}};
    dmg_sweep(b, path, 4, rod, rod, false);
    dmg_rod(b, v3(-1.5f * rod, 1.05f * tall, reach), v3(1.5f * rod, 1.05f * tall, reach), 1.5f * rod);
    uint32_t mirror = dmg_hinge(b, arm, "mirror", v3(0, 1.05f * tall, reach), v3(1, 0, 0), -far, far);
    dmg_box_span(b, v3(-rod, 1.05f * tall - rod, reach), v3(rod, 1.05f * tall + rod, reach + 2.5f * rod));
    glass g = pick_glass(b, 2 * r, 2 * r, 1.5f * rod);
    if (dmg_chance(b, 0.7f)) g.shape = 1;
    dmg_move(b, 0, 1.05f * tall, reach + 3.5f * rod);
    draw_glass(b, &g);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, arm, dmg_range(b, -1.0f, 1.0f));
    if (dmg_chance(b, 0.4f)) dmg_rest(b, mirror, far * dmg_range(b, -1.0f, 1.0f));
    dmg_use(b, 0);
}

/* ---- what is below ---- */

/* Fronts z = 0, their place centred at the origin. */
static void draw_box(dmg_builder* b, const vanity* v, float w, float h, float deep) {
    dmg_drawer d = v->box;
    d.width = w - (v->inset ? 1.1f * v->t : 0.004f);
    d.height = h - (v->inset ? 1.1f * v->t : 0.004f);
    d.thickness = fminf(v->t, 0.3f * h);
    d.depth = dmg_range(b, 0.7f, 0.95f) * (deep - v->t);
    d.travel = dmg_range(b, 0.6f, 0.95f) * d.depth;
    d.handle.thickness = fminf(d.handle.thickness, 0.1f * h);
    d.handle.standoff = fminf(d.handle.standoff, 0.4f * h);
    dmg_save(b);
    dmg_move(b, 0, 0, v->inset ? 0.0f : 1.02f * d.thickness);
    uint32_t part = dmg_drawer_draw(b, 0, "drawer", &d);
    dmg_restore(b);
    if (dmg_chance(b, v->open)) dmg_rest(b, part, d.travel * dmg_range(b, 0.1f, 1.0f));
    dmg_use(b, 0);
}

/* Rows of unequal height, from the bottom; the upper ones cut into more. The case's opening is centred at z = 0. */
static void draw_rows(dmg_builder* b, const vanity* v, float w, float h, float deep, int rows) {
    float grow = dmg_range(b, 0.65f, 1.05f), unit = 0.0f, y = -0.5f * h;
    int columns = 1, most = w > 1.2f * h ? 4 : 2;
    bool boards = dmg_chance(b, 0.5f);
    for (int i = 0; i < rows; ++i) unit += powf(grow, (float)i);
    dmg_case_draw(b, DMG_CASE_BOARDS, w, h, deep, v->t);
    for (int i = 0; i < rows; ++i) {
        float high = h * powf(grow, (float)i) / unit;
        if (columns < most && dmg_chance(b, 0.4f)) ++columns;
        for (int k = 0; k < columns; ++k) {
            dmg_save(b);
            dmg_move(b, w * (((float)k + 0.5f) / (float)columns - 0.5f), y + 0.5f * high, 0);
            draw_box(b, v, w / (float)columns, high, deep);
            dmg_restore(b);
        }
        y += high;
        if (boards && i + 1 < rows) dmg_box(b, v3(0, y, -0.5f * deep), v3(w - 2 * v->t, 0.5f * v->t, 0.96f * deep));
    }
}

/* Boxes over each other on one post through their corner: they look like drawers, and turn. */
static void draw_pivot_stack(dmg_builder* b, const vanity* v, float w, float h, float deep) {
    int rows = dmg_int(b, 2, 5);
    float step = (h - 2 * v->t) / (float)rows, e = dmg_range(b, 0.8f, 1.6f) * v->t, rod = 0.3f * v->t,
          far = dmg_range(b, 1.2f, 2.6f);
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3(0, 0.5f * (float)s * (h - v->t), -0.5f * deep), v3(w, v->t, deep));
    dmg_vec pin = v3(-0.5f * w + e, 0, -e);
    dmg_rod(b, v3(pin.x, -0.5f * h, pin.z), v3(pin.x, 0.5f * h, pin.z), rod);
    for (int i = 0; i < rows; ++i) {
        float y = v->t - 0.5f * h + step * (float)i, t = 0.5f * v->t;
        uint32_t part = dmg_hinge(b, 0, "swing_tray", pin, v3(0, -1, 0), 0.0f, far);
        dmg_save(b);
        dmg_move(b, 0, y + 0.04f * step, 0);
        dmg_box_span(b, v3(-0.5f * w, 0, -t), v3(0.5f * w, 0.92f * step, 0));
        dmg_move(b, 0, 0, -t);
        dmg_tray_draw(b, DMG_TRAY_BOARDS, w, dmg_range(b, 0.5f, 0.92f) * step, 0.95f * deep - t, t);
        dmg_rod(b, v3(pin.x, 0.01f * step, pin.z + t), v3(pin.x, 0.9f * step, pin.z + t), 1.6f * rod);
        dmg_restore(b);
        if (dmg_chance(b, fmaxf(v->open, 0.3f))) dmg_rest(b, part, far * dmg_range(b, 0.1f, 1.0f));
        dmg_use(b, 0);
    }
}

/* Draws one side of a kneehole: drawers, a door or trays on a post. Its top's middle is at the origin of z = 0. */
static void draw_pedestal(dmg_builder* b, const vanity* v, float w, float h, float deep, bool right) {
    int kind = dmg_int(b, 0, 3), rows = dmg_int(b, 1, 4);
    dmg_save(b);
    dmg_move(b, 0, -0.5f * h, 0);
    if (kind < 2) draw_rows(b, v, w, h, deep, rows);
    if (kind == 2) {
        if (right) dmg_mirror(b, v3(1, 0, 0));
        draw_pivot_stack(b, v, w, h, deep);
    }
    if (kind == 3) {
        dmg_leaf leaf = v->leaf;
        leaf.width = 0.98f * w;
        leaf.height = 0.98f * h;
        leaf.side = right ? DMG_SIDE_RIGHT : DMG_SIDE_LEFT;
        dmg_case_draw(b, DMG_CASE_BOARDS, w, h, deep, v->t);
        dmg_move(b, 0, 0, 1.02f * leaf.thickness);
        uint32_t part = dmg_leaf_draw(b, 0, "door", &leaf);
        if (dmg_chance(b, v->open)) dmg_rest(b, part, leaf.swing * dmg_range(b, 0.1f, 1.0f));
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

static void draw_legs(dmg_builder* b, float w, float d, float h, float leg) {
    bool round = dmg_chance(b, 0.5f);
    for (int i = 0; i < 4; ++i) {
        dmg_vec top = {(i & 1 ? 0.5f : -0.5f) * (w - 1.2f * leg), h, (i & 2 ? 0.5f : -0.5f) * (d - 1.2f * leg)};
        if (round)
            dmg_cone(b, v3(1.02f * top.x, 0, 1.02f * top.z), top, 0.3f * leg, 0.6f * leg);
        else
            dmg_beam(b, v3(top.x, 0, top.z), top, leg, leg);
    }
}

/* The middle of the top is a lid over a well, a glass on its underside; the rest of the top lies beside it. */
static void draw_lidded_top(dmg_builder* b, const vanity* v) {
    float lid = v->w * dmg_range(b, 0.35f, 0.8f), d = v->d, t = v->t, high = dmg_range(b, 0.1f, 0.25f) * v->d,
          far = dmg_range(b, 1.3f, 1.9f), x = dmg_chance(b, 0.6f) ? 0.0f : dmg_sign(b) * 0.5f * (v->w - lid),
          rear = dmg_range(b, 0.0f, 0.2f) * d - 0.5f * d;
    if (x - 0.5f * lid > -0.49f * v->w)
        dmg_box_span(b, v3(-0.5f * v->w, -t, -0.5f * d), v3(x - 0.5f * lid, 0, 0.5f * d));
    if (x + 0.5f * lid < 0.49f * v->w) dmg_box_span(b, v3(x + 0.5f * lid, -t, -0.5f * d), v3(0.5f * v->w, 0, 0.5f * d));
    if (rear > -0.5f * d + t) dmg_box_span(b, v3(x - 0.5f * lid, -t, -0.5f * d), v3(x + 0.5f * lid, 0, rear));
    dmg_save(b);
    dmg_move(b, x, -1.02f * t, 0.5f * (0.5f * d + rear));
    dmg_face_up(b);
    dmg_case_draw(b, DMG_CASE_BOARDS, lid, 0.5f * d - rear, high, 0.6f * t);
    dmg_restore(b);
    float up = dmg_chance(b, 0.5f) ? 0.0f : -t * dmg_range(b, 0.0f, 1.0f);
    if (rear > -0.5f * d + t) up = 0.0f; /* it would turn into what is behind it */
    uint32_t part = dmg_hinge(b, 0, "lid", v3(x, up, rear), v3(-1, 0, 0), 0.0f, far);
    dmg_box_span(b, v3(x - 0.495f * lid, -t, rear + 0.01f * d), v3(x + 0.495f * lid, 0, 0.5f * d));
    dmg_box_span(b, v3(x - 0.4f * lid, -1.2f * t, rear + 0.12f * d), v3(x + 0.4f * lid, -t, 0.42f * d));
    if (dmg_chance(b, 0.4f))
        dmg_box_span(b, v3(x - 0.04f * lid, -0.9f * t, 0.5f * d), v3(x + 0.04f * lid, -0.4f * t, 0.5f * d + t));
    if (dmg_chance(b, 0.5f)) dmg_rest(b, part, far * dmg_range(b, 0.3f, 1.0f));
    dmg_use(b, 0);
}

static void draw_table_part(dmg_builder* b, const vanity* v, bool lidded) {
    int kind = lidded ? dmg_int(b, 0, 1) : dmg_int(b, 0, 2);
    float apron = dmg_range(b, 0.12f, 0.25f) * v->h, leg = dmg_range(b, 0.04f, 0.08f) * v->d,
          foot = dmg_range(b, 0.0f, 0.2f) * v->h;
    float side = dmg_range(b, 0.18f, 0.34f) * v->w, under = v->h - v->t, front = 0.46f * v->d;
    if (lidded) side = fminf(side, 0.09f * v->w + 0.1f);
    dmg_save(b);
    dmg_move(b, 0, under, front);
    if (kind == 0 && !lidded) { /* a row of drawers on legs */
        dmg_move(b, 0, -0.5f * apron, 0);
        draw_rows(b, v, 0.97f * v->w, apron, 0.92f * v->d, 1);
    }
    for (int s = -1; s <= 1 && kind == 1; s += 2) {
        dmg_save(b);
        dmg_move(b, 0.5f * (float)s * (0.97f * v->w - side), 0, 0);
        if (!lidded) draw_pedestal(b, v, side, under - foot, 0.92f * v->d, s > 0);
        if (lidded) dmg_box_span(b, v3(-0.3f * v->t, -under, -0.9f * v->d), v3(0.3f * v->t, 0, 0));
        dmg_restore(b);
    }
    if (kind == 1 && !lidded && dmg_chance(b, 0.6f)) { /* one over the knees */
        dmg_move(b, 0, -0.5f * apron, 0);
        draw_rows(b, v, 0.97f * v->w - 2.05f * side, apron, 0.8f * v->d, 1);
    }
    if (kind == 2) {
        dmg_move(b, 0, -0.5f * (under - foot), 0);
        draw_rows(b, v, 0.97f * v->w, under - foot, 0.92f * v->d, dmg_int(b, 2, 5));
    }
    dmg_restore(b);
    if (kind == 0) draw_legs(b, v->w, v->d, under, leg);
    if (kind > 0 && !lidded && foot > 0.0f) draw_legs(b, 0.95f * v->w, 0.9f * v->d, foot, leg);
}

/* Small drawers on both ends of the top. */
static void draw_jewel_boxes(dmg_builder* b, const vanity* v) {
    float w = v->w * dmg_range(b, 0.12f, 0.2f), h = w * dmg_range(b, 0.4f, 1.1f),
          deep = v->d * dmg_range(b, 0.3f, 0.6f);
    int rows = dmg_int(b, 1, 2);
    vanity small = *v;
    small.t = 0.4f * v->t;
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * 0.5f * (v->w - w), 0.5f * h, deep - 0.48f * v->d);
        draw_rows(b, &small, w, h, deep, rows);
        dmg_restore(b);
    }
}

static vanity pick_vanity(dmg_builder* b) {
    vanity v = {.w = dmg_range(b, 0.7f, 1.5f)};
    v.d = dmg_range(b, 0.35f, 0.55f);
    v.h = dmg_range(b, 0.6f, 0.95f);
    v.t = dmg_range(b, 0.012f, 0.035f);
    v.open = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.1f, 0.6f);
    v.inset = dmg_chance(b, 0.4f);
    v.box = dmg_drawer_pick(b, 0.12f);
    v.leaf = dmg_leaf_pick(b, 0.12f);
    v.leaf.thickness = v.t;
    v.leaf.inset = fminf(v.leaf.inset, 0.6f);
    if (v.box.panel.kind == DMG_PANEL_BOWED) v.box.panel.kind = DMG_PANEL_FLAT;
    return v;
}

/* ---- a tall mirror on feet; it may be the door of a shallow case that tilts with it ---- */

static void draw_cheval(dmg_builder* b) {
    float h = dmg_range(b, 1.1f, 1.7f), w = h * dmg_range(b, 0.25f, 0.4f), t = dmg_range(b, 0.02f, 0.04f),
          post = dmg_range(b, 0.012f, 0.025f), low = dmg_range(b, 0.08f, 0.2f),
          deep = dmg_chance(b, 0.5f) ? w * dmg_range(b, 0.2f, 0.4f) : 0.0f, pin = low + h * dmg_range(b, 0.5f, 0.6f),
          x = 0.5f * w + 2.5f * post, far = dmg_range(b, 0.15f, 0.35f);
    float foot = deep + dmg_range(b, 0.15f, 0.25f) * h;
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * x;
        dmg_beam(b, v3(at, 0.5f * low, 0), v3(at, pin + 4 * post, 0), 2 * post, 2 * post);
        dmg_beam(b, v3(at, 0.4f * low, 0), v3(at, 0, foot), 2 * post, 2 * post);
        dmg_beam(b, v3(at, 0.4f * low, 0), v3(at, 0, -foot), 2 * post, 2 * post);
    }
    dmg_rod(b, v3(-x, 0.45f * low, 0), v3(x, 0.45f * low, 0), post);
    uint32_t carrier = dmg_hinge(b, 0, deep > 0.0f ? "case" : "mirror", v3(0, pin, 0), v3(1, 0, 0), -far, far);
    dmg_rod(b, v3(-x - 1.5f * post, pin, 0), v3(-0.48f * w, pin, 0), 0.6f * post);
    dmg_rod(b, v3(0.48f * w, pin, 0), v3(x + 1.5f * post, pin, 0), 0.6f * post);
    glass g = pick_glass(b, w, h, t);
    dmg_save(b);
    dmg_move(b, 0, low + 0.5f * h, 0.5f * deep);
    if (deep > 0.0f) { /* shelves and a little drawer behind the glass */
        int shelves = dmg_int(b, 2, 5);
        bool right = dmg_chance(b, 0.5f);
        if (g.shape == 1 || g.shape == 2) g.shape = 3;
        dmg_case_draw(b, DMG_CASE_BOARDS, w, h, deep, 0.6f * t);
        for (int i = 1; i < shelves; ++i)
            dmg_box(b, v3(0, h * ((float)i / (float)shelves - 0.5f), -0.5f * deep), v3(w - t, 0.4f * t, 0.85f * deep));
        if (right) dmg_mirror(b, v3(1, 0, 0));
        float line = dmg_chance(b, 0.5f) ? 1.02f * t : 0.0f, wide = dmg_range(b, 1.4f, 2.4f);
        uint32_t door = dmg_hinge(b, carrier, "mirror_door", v3(-0.5f * w, 0, line), v3(0, -1, 0), 0.0f, wide);
        dmg_move(b, 0, 0, 1.03f * t);
        draw_glass(b, &g);
        if (dmg_chance(b, 0.4f)) dmg_rest(b, door, dmg_range(b, 0.2f, 1.4f));
    } else {
        dmg_move(b, 0, 0, 0.5f * t);
        draw_glass(b, &g);
    }
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, carrier, far * dmg_range(b, -0.9f, 0.9f));
    dmg_use(b, 0);
}

void dmg_build_vanity(dmg_builder* b) {
    if (dmg_chance(b, 0.15f)) {
        draw_cheval(b);
        return;
    }
    vanity v = pick_vanity(b);
    int mirror = dmg_int(b, 0, 6);
    bool lidded = mirror == 6, boxes = !lidded && dmg_chance(b, 0.35f);
    draw_table_part(b, &v, lidded);
    dmg_move(b, 0, v.h, 0);
    if (lidded) {
        draw_lidded_top(b, &v);
        return;
    }
    dmg_box_span(b, v3(-0.5f * v.w, -v.t, -0.5f * v.d), v3(0.5f * v.w, 0, 0.5f * v.d));
    if (boxes) draw_jewel_boxes(b, &v);
    float w = v.w * (boxes ? dmg_range(b, 0.4f, 0.56f) : dmg_range(b, 0.4f, 0.9f)), h = dmg_range(b, 0.4f, 0.9f),
          z = dmg_range(b, -0.4f, -0.25f) * v.d;
    if (mirror < 2) draw_tilting(b, &v, w, h, z);
    if (mirror == 2 || mirror == 3) draw_winged(b, &v, w, h, z);
    if (mirror == 4) draw_sliding(b, &v, w, h, z);
    if (mirror == 5) draw_on_arm(b, &v, w, h);
}
