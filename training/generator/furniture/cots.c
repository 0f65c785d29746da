/* Draws cots and cradles: a side that drops, folds or is a gate, a bed of adjustable height, a hood, drawers, a
 * mobile. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct cot {
    float length, width; /* between the posts' middles, along x and z */
    float high, low;     /* of the sides' upper and lower edges above the floor */
    float post, rail, bar;
    int bars, fence; /* what fills the sides */
    float open;
    uint32_t carrier; /* 0, or the part that rocks */
} cot;

static void rest_open(dmg_builder* b, const cot* c, uint32_t part, float far) {
    if (dmg_chance(b, c->open)) dmg_rest(b, part, far * (dmg_chance(b, 0.5f) ? 1.0f : dmg_range(b, 0.1f, 1.0f)));
    dmg_use(b, c->carrier);
}

/* Draws a side w x h about the origin of z = 0: rails with bars, slats, laths along it, or closed. */
static void draw_fence(dmg_builder* b, const cot* c, float w, float h) {
    float r = fminf(c->rail, 0.2f * h), t = 0.8f * c->rail;
    int count = (int)(w / c->length * (float)c->bars) + 1;
    if (c->fence == 3) {
        dmg_box(b, v3(0, 0, 0), v3(w, h, 0.6f * t));
        dmg_box(b, v3(0, 0.5f * (h - r), 0), v3(w, r, t));
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_box(b, v3(0, 0.5f * (float)s * (h - r), 0), v3(w, r, t));
        if (c->fence != 0 || h < 0.5f * w) dmg_box(b, v3(0.5f * (float)s * (w - r), 0, 0), v3(r, h - 2 * r, t));
    }
    for (int i = 0; i < count && c->fence != 2; ++i) {
        float x = (w - 2 * r) * (((float)i + 0.5f) / (float)count - 0.5f), y = 0.5f * h - r;
        if (c->fence == 0)
            dmg_rod(b, v3(x, -y, 0), v3(x, y, 0), c->bar);
        else
            dmg_box(b, v3(x, 0, 0), v3(4 * c->bar, 2 * y, 1.2f * c->bar));
    }
    for (int i = 1; i <= 3 && c->fence == 2; ++i)
        dmg_box(b, v3(0, (h - 2 * r) * (0.25f * (float)i - 0.5f), 0), v3(w - 2 * r, 0.14f * h, 0.5f * t));
}

/* Posts, both ends and the rear side; `down`: how far the posts reach. */
static void draw_cot_frame(dmg_builder* b, const cot* c, float down, bool round) {
    float x = 0.5f * c->length, z = 0.5f * c->width, h = c->high - c->low, over = dmg_range(b, 0.0f, 0.15f) * h;
    for (int i = 0; i < 4; ++i) {
        float px = i & 1 ? x : -x, pz = i & 2 ? z : -z;
        if (round)
            dmg_rod(b, v3(px, down, pz), v3(px, c->high + over, pz), 0.5f * c->post);
        else
            dmg_box_span(b, v3(px - 0.5f * c->post, down, pz - 0.5f * c->post),
                         v3(px + 0.5f * c->post, c->high + over, pz + 0.5f * c->post));
    }
    cot ends = *c;
    if (dmg_chance(b, 0.4f)) ends.fence = 3;
    for (int s = -1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * x, 0.5f * (c->high + c->low), 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        draw_fence(b, &ends, c->width - c->post, h);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (c->high + c->low), -z);
    draw_fence(b, c, c->length - c->post, h);
    dmg_restore(b);
}

/* ---- the front ---- */

/* Down along rods or grooves in the posts. */
static void draw_drop_side(dmg_builder* b, const cot* c) {
    float x = 0.5f * c->length, h = c->high - c->low, z = 0.5f * c->width,
          far = fminf(dmg_range(b, 0.25f, 0.6f) * h, c->low - 0.02f);
    bool before = dmg_chance(b, 0.6f); /* of the posts, along rods */
    float w = before ? c->length + c->post : c->length - 1.05f * c->post,
          at = before ? z + 0.5f * c->post + c->rail : z, r = 0.2f * c->rail;
    far = fmaxf(far, 0.05f);
    for (int s = -1; s <= 1 && before; s += 2) {
        float px = (float)s * (x + 0.1f * c->post);
        dmg_rod(b, v3(px, c->low - far, at), v3(px, c->high, at), r);
        for (int i = 0; i < 2; ++i) { /* brackets to the post */
            float y = i ? c->high - 2 * r : c->low - far;
            dmg_box_span(b, v3(px - 2 * r, y, z), v3(px + 2 * r, y + 2 * r, at));
        }
    }
    uint32_t side = dmg_slide(b, c->carrier, "drop_side", v3(0, -1, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (c->high + c->low), at);
    draw_fence(b, c, w, h);
    dmg_restore(b);
    rest_open(b, c, side, far);
}

/* The upper part folds down before the lower one, or the whole comes down about its lower edge. */
static void draw_fold_side(dmg_builder* b, const cot* c) {
    float h = c->high - c->low, z = 0.5f * c->width, w = c->length - 1.05f * c->post, t = 0.8f * c->rail;
    bool whole = dmg_chance(b, 0.3f), outer = dmg_chance(b, 0.6f);
    float seam = whole ? c->low : c->low + h * dmg_range(b, 0.45f, 0.7f);
    if (!whole) {
        dmg_save(b);
        dmg_move(b, 0, 0.5f * (c->low + seam), z);
        draw_fence(b, c, w, seam - c->low - 0.004f);
        dmg_restore(b);
    }
    float far = whole ? dmg_range(b, 1.3f, 1.6f) : dmg_range(b, 1.8f, outer ? 3.1f : 2.0f);
    dmg_vec line = v3(0, seam, z + (outer ? 0.5f * t : 0.0f));
    uint32_t side = dmg_hinge(b, c->carrier, "fold_side", line, v3(1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, 0, 0.5f * (c->high + seam) + 0.002f, z);
    draw_fence(b, c, w, c->high - seam - 0.004f);
    dmg_restore(b);
    int knuckles = outer ? dmg_int(b, 0, 3) : 0;
    for (int i = 0; i < knuckles; ++i) {
        float x = 0.8f * w * (((float)i + 0.5f) / (float)knuckles - 0.5f);
        dmg_rod(b, v3(x - 0.03f, seam, line.z), v3(x + 0.03f, seam, line.z), 0.25f * t);
    }
    rest_open(b, c, side, far);
}

/* Draws a gate between fixed pieces, hung on one of them. */
static void draw_gate_side(dmg_builder* b, const cot* c) {
    float h = c->high - c->low, z = 0.5f * c->width, w = c->length - 1.05f * c->post, share = dmg_range(b, 0.3f, 0.6f),
          x = w * (0.5f - 0.5f * share) * dmg_range(b, -1.0f, 1.0f), half = 0.5f * share * w,
          far = dmg_range(b, 1.2f, 2.4f);
    const float from[] = {-0.5f * w, x + half}, to[] = {x - half, 0.5f * w};
    for (int i = 0; i < 2; ++i) {
        if (to[i] - from[i] < 3 * c->rail) continue;
        dmg_save(b);
        dmg_move(b, 0.5f * (from[i] + to[i]), 0.5f * (c->high + c->low), z);
        draw_fence(b, c, to[i] - from[i], h);
        dmg_restore(b);
    }
    dmg_save(b);
    dmg_move(b, x, 0.5f * (c->high + c->low), z);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    float through = dmg_chance(b, 0.5f) ? 0.4f * c->rail : 0.0f;
    uint32_t gate = dmg_hinge(b, c->carrier, "gate", v3(-half, 0, through), v3(0, -1, 0), 0.0f, far);
    draw_fence(b, c, 2 * half - 0.01f, 0.99f * h);
    for (int s = -1; s <= 1; s += 2) {
        float y = 0.35f * (float)s * h;
        if (through > 0.0f) dmg_rod(b, v3(-half, y - 0.04f, through), v3(-half, y + 0.04f, through), 0.3f * c->rail);
    }
    if (dmg_chance(b, 0.4f)) { /* its bolt */
        dmg_slide(b, gate, "bolt", v3(0, 1, 0), 0.0f, 0.03f);
        dmg_rod(b, v3(half - c->rail, 0.35f * h, 0.6f * c->rail), v3(half - c->rail, 0.52f * h, 0.6f * c->rail),
                0.006f);
    }
    dmg_restore(b);
    rest_open(b, c, gate, far);
}

/* ---- bed, drawers and what hangs on the frame ---- */

static void draw_bed(dmg_builder* b, const cot* c) {
    float w = c->length - 1.1f * c->post, d = c->width - 1.1f * c->post, y = c->low + dmg_range(b, 0.02f, 0.1f),
          t = 0.02f, far = dmg_range(b, 0.3f, 0.5f) * (c->high - c->low);
    uint32_t bed = 0;
    if (dmg_chance(b, 0.5f)) bed = dmg_slide(b, c->carrier, "bed", v3(0, 1, 0), 0.0f, far);
    dmg_box_span(b, v3(-0.5f * w, y, -0.5f * d), v3(0.5f * w, y + t, 0.5f * d));
    if (dmg_chance(b, 0.75f)) dmg_rounded_box(b, v3(0, y + t + 0.05f, 0), v3(0.97f * w, 0.1f, 0.96f * d), 0.03f);
    if (bed)
        rest_open(b, c, bed, far);
    else
        dmg_use(b, c->carrier);
}

static void draw_cot_drawers(dmg_builder* b, const cot* c) {
    int count = dmg_int(b, 1, 2);
    float low = 0.04f, high = c->low - 0.01f - low, w = (c->length - 1.2f * c->post) / (float)count, d = c->width;
    dmg_drawer drawer = dmg_drawer_pick(b, 0.12f);
    if (high < 0.08f) return;
    drawer.width = 0.98f * w;
    drawer.height = high;
    drawer.thickness = 0.02f;
    drawer.depth = 0.9f * d;
    drawer.travel = dmg_range(b, 0.5f, 0.85f) * d;
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_move(b, w * ((float)i + 0.5f - 0.5f * (float)count), low + 0.5f * high, 0.5f * d - 0.2f * c->post);
        uint32_t part = dmg_drawer_draw(b, c->carrier, "drawer", &drawer);
        dmg_restore(b);
        rest_open(b, c, part, drawer.travel);
    }
}

/* Figures on strings round a hub that turns, on an arm fixed to an end. */
static void draw_mobile(dmg_builder* b, const cot* c) {
    float x = 0.5f * c->length, tall = c->high + dmg_range(b, 0.35f, 0.6f),
          reach = dmg_range(b, 0.25f, 0.45f) * c->length, r = dmg_range(b, 0.1f, 0.2f);
    int count = dmg_int(b, 3, 6), figure = dmg_int(b, 0, 2);
    const dmg_vec arm[] = {{-x, c->high, 0}, {-x, 0.95f * tall, 0}, {-x + 0.1f * reach, tall, 0}, {reach - x, tall, 0}};
    dmg_sweep(b, arm, 4, 0.01f, 0.01f, false);
    dmg_box(b, v3(-x, c->high, 0), v3(0.05f, 0.08f, 0.06f));
    dmg_spin(b, c->carrier, "mobile", v3(reach - x, tall, 0), v3(0, 1, 0));
    dmg_save(b);
    dmg_move(b, reach - x, tall, 0);
    dmg_rod(b, v3(0, -0.06f, 0), v3(0, -0.012f, 0), 0.03f);
    for (int i = 0; i < count; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, count);
        float hang = dmg_range(b, 0.1f, 0.2f);
        dmg_rod(b, v3(0, -0.045f, 0), v3(0, -0.045f, r), 0.005f);
        dmg_rod(b, v3(0, -0.045f, r), v3(0, -hang, r), 0.002f);
        if (figure == 0) dmg_ellipsoid(b, v3(0, -hang, r), v3(0.03f, 0.035f, 0.03f));
        if (figure == 1) dmg_box(b, v3(0, -hang, r), v3(0.05f, 0.05f, 0.02f));
        if (figure == 2) dmg_cone(b, v3(0, -hang - 0.03f, r), v3(0, -hang + 0.03f, r), 0.035f, 0.0f);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, c->carrier);
}

/* One more row of a sheet's points, joined to the row that began at `previous`; where this one begins. */
static uint32_t draw_cloth_row(dmg_builder* b, const dmg_vec* row, int count, uint32_t previous, bool join) {
    uint32_t first = b->vertex_count;
    if (!join) dmg_piece_begin(b);
    for (int i = 0; i < count; ++i) dmg_vertex(b, row[i]);
    for (uint32_t i = 0; join && i + 1 < (uint32_t)count; ++i)
        dmg_quad(b, previous + i, previous + i + 1, first + i + 1, first + i);
    return first;
}

/* Bows about one line across the end, with or without cloth: it folds towards the end. */
static void draw_hood(dmg_builder* b, const cot* c) {
    enum { POINTS = 11 };
    float z = 0.5f * c->width + 0.6f * c->post, x = 0.5f * c->length, at = -x + dmg_range(b, 0.1f, 0.3f) * c->length,
          r = dmg_range(b, 0.55f, 0.8f) * c->width, far = dmg_range(b, 0.6f, 1.1f);
    int bows = dmg_int(b, 2, 4);
    dmg_vec pin = v3(at, c->high, 0);
    uint32_t hood = dmg_hinge(b, c->carrier, "hood", pin, v3(0, 0, 1), 0.0f, far);
    bool cloth = dmg_chance(b, 0.5f);
    uint32_t previous = 0;
    for (int i = 0; i < bows; ++i) {
        float lean = -0.3f + 0.75f * (float)i / (float)(bows - 1); /* from the upright, towards the end */
        dmg_vec path[POINTS];
        for (int k = 0; k < POINTS; ++k) {
            float a = DMG_PI * (float)k / (POINTS - 1), out = r * powf(fabsf(sinf(a)), 0.6f);
            path[k] = v3(pin.x - out * sinf(lean), pin.y + out * cosf(lean),
                         z * copysignf(powf(fabsf(cosf(a)), 0.6f), cosf(a)));
        }
        if (!cloth) dmg_sweep(b, path, POINTS, 0.008f, 0.008f, false);
        if (cloth) previous = draw_cloth_row(b, path, POINTS, previous, i > 0);
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_rod(b, v3(pin.x, pin.y, (float)s * (z - 0.6f * c->post)), v3(pin.x, pin.y, (float)s * (z + 0.02f)), 0.015f);
    rest_open(b, c, hood, far);
}

/* Draws a tray across the sides, which is pushed along them, or is hung on the rear one and lifts. */
static void draw_changer(dmg_builder* b, const cot* c) {
    float w = c->length * dmg_range(b, 0.35f, 0.5f), x = 0.5f * c->length - 0.5f * w - 0.1f * c->length,
          z = 0.5f * c->width + 0.7f * c->post;
    bool slides = dmg_chance(b, 0.6f);
    float far = slides ? 2 * x : dmg_range(b, 1.2f, 1.7f);
    const float y = c->high + 0.005f;
    uint32_t tray;
    if (slides)
        tray = dmg_slide(b, c->carrier, "changer", v3(-1, 0, 0), 0.0f, far);
    else
        tray = dmg_hinge(b, c->carrier, "changer", v3(x, y, -z), v3(-1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_move(b, x, y, z);
    dmg_tray_draw(b, DMG_TRAY_BOARDS, w, dmg_range(b, 0.06f, 0.14f), 2 * z, 0.012f);
    dmg_restore(b);
    if (slides) /* lips over the rails */
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(x - 0.5f * w, y - 0.04f, (float)s * (z + 0.003f) - 0.004f),
                         v3(x + 0.5f * w, y + 0.02f, (float)s * (z + 0.003f) + 0.004f));
    rest_open(b, c, tray, far);
}

/* ---- what it stands on ---- */

/* Curved runners below both ends. */
static void draw_runners(dmg_builder* b, const cot* c, float up) {
    enum { POINTS = 9 };
    float half = 0.5f * c->width * dmg_range(b, 1.1f, 1.5f);
    dmg_vec path[POINTS];
    for (int s = -1; s <= 1; s += 2) {
        for (int i = 0; i < POINTS; ++i) {
            float u = 2.0f * (float)i / (POINTS - 1) - 1.0f;
            path[i] = v3(0.5f * (float)s * c->length, 0.02f + up * u * u, half * u);
        }
        dmg_sweep(b, path, POINTS, 0.02f, 0.02f, false);
    }
}

static void draw_cot_castors(dmg_builder* b, const cot* c, float r) {
    for (int i = 0; i < 4; ++i) {
        float x = (i & 1 ? 0.5f : -0.5f) * c->length, z = (i & 2 ? 0.5f : -0.5f) * c->width;
        uint32_t fork = 0;
        dmg_use(b, 0);
        if (i & 1) fork = dmg_spin(b, 0, "castor", v3(x, 0, z), v3(0, 1, 0));
        dmg_rod(b, v3(x, 1.9f * r, z), v3(x, 2.4f * r, z), 0.3f * r);
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3(x + 0.45f * (float)s * r - 0.06f * r, 0.7f * r, z - 0.5f * r),
                         v3(x + 0.45f * (float)s * r + 0.06f * r, 2 * r, z + 0.3f * r));
        dmg_box_span(b, v3(x - 0.5f * r, 1.9f * r, z - 0.5f * r), v3(x + 0.5f * r, 2.1f * r, z + 0.3f * r));
        float behind = i & 1 ? 0.4f * r : 0.0f;
        dmg_spin(b, fork, "wheel", v3(x, r, z - behind), v3(1, 0, 0));
        dmg_rod(b, v3(x - 0.35f * r, r, z - behind), v3(x + 0.35f * r, r, z - behind), 0.85f * r);
    }
    dmg_use(b, 0);
}

/* Draws two uprights with the pins that a cradle hangs on. */
static void draw_stand(dmg_builder* b, cot* c, float pin) {
    float x = 0.5f * c->length + 1.6f * c->post, z = 0.5f * c->width * dmg_range(b, 0.8f, 1.2f),
          far = dmg_range(b, 0.15f, 0.4f);
    bool splayed = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * x;
        if (splayed) {
            dmg_beam(b, v3(at, 0, z), v3(at, pin, 0), c->post, c->post);
            dmg_beam(b, v3(at, 0, -z), v3(at, pin, 0), c->post, c->post);
        } else {
            dmg_beam(b, v3(at, 0.02f, 0), v3(at, pin + c->post, 0), c->post, 1.4f * c->post);
        }
        dmg_box_span(b, v3(at - 0.6f * c->post, 0, -z), v3(at + 0.6f * c->post, 0.04f, z));
    }
    dmg_box_span(b, v3(-x, 0.04f, -0.5f * c->post), v3(x, 0.04f + c->post, 0.5f * c->post));
    c->carrier = dmg_hinge(b, 0, "cradle", v3(0, pin, 0), v3(1, 0, 0), -far, far);
    for (int s = -1; s <= 1; s += 2) {
        dmg_rod(b, v3((float)s * 0.5f * c->length, pin, 0), v3((float)s * (x + 0.7f * c->post), pin, 0),
                0.25f * c->post);
        if (pin > c->high - 0.02f) /* arms up to the pins */
            dmg_box_span(b, v3((float)s * 0.5f * c->length - 0.4f * c->post, c->high - 0.05f, -0.5f * c->post),
                         v3((float)s * 0.5f * c->length + 0.4f * c->post, pin + 0.3f * c->post, 0.5f * c->post));
    }
    if (dmg_chance(b, 0.3f)) dmg_rest(b, c->carrier, far * dmg_range(b, -0.9f, 0.9f));
}

static cot pick_cot(dmg_builder* b) {
    cot c = {.length = dmg_range(b, 0.8f, 1.5f)};
    c.width = c.length * dmg_range(b, 0.42f, 0.62f);
    c.low = dmg_range(b, 0.2f, 0.45f);
    c.high = c.low + dmg_range(b, 0.35f, 0.65f);
    c.post = dmg_range(b, 0.03f, 0.07f);
    c.rail = dmg_range(b, 0.02f, 0.05f);
    c.bar = dmg_range(b, 0.005f, 0.012f);
    c.bars = dmg_int(b, 7, 16);
    c.fence = dmg_int(b, 0, 3);
    c.open = dmg_chance(b, 0.45f) ? 0.0f : dmg_range(b, 0.2f, 0.8f);
    return c;
}

void dmg_build_cot(dmg_builder* b) {
    cot c = pick_cot(b);
    static const float bases[] = {3, 1, 1.5f, 2.5f};
    int base = dmg_weighted(b, bases, 4), front = dmg_int(b, 0, 3); /* posts, runners, castors, a stand */
    float wheel = dmg_range(b, 0.025f, 0.045f), up = dmg_range(b, 0.05f, 0.1f);
    const float down[] = {0.0f, 0.02f + up * 0.5f, 2.3f * wheel, c.low};
    if (base == 1) draw_runners(b, &c, up);
    if (base == 2) draw_cot_castors(b, &c, wheel);
    if (base == 3)
        draw_stand(b, &c, dmg_chance(b, 0.5f) ? c.high + dmg_range(b, 0.03f, 0.2f) : dmg_range(b, 0.6f, 1.0f) * c.high);
    draw_cot_frame(b, &c, down[base], dmg_chance(b, 0.4f));
    draw_bed(b, &c);
    if (front == 0) draw_drop_side(b, &c);
    if (front == 1) draw_fold_side(b, &c);
    if (front == 2) draw_gate_side(b, &c);
    if (front == 3) { /* like the rear */
        dmg_save(b);
        dmg_move(b, 0, 0.5f * (c.high + c.low), 0.5f * c.width);
        draw_fence(b, &c, c.length - c.post, c.high - c.low);
        dmg_restore(b);
    }
    if ((base == 0 || base == 2) && dmg_chance(b, 0.4f)) {
        dmg_save(b);
        if (base == 2) dmg_move(b, 0, 1.5f * wheel, 0);
        cot lifted = c;
        if (base == 2) lifted.low -= 1.5f * wheel;
        draw_cot_drawers(b, &lifted);
        dmg_restore(b);
    }
    int extra = dmg_int(b, 0, front == 3 ? 2 : 4); /* a cot that opens nowhere has something to move */
    if (extra == 0) draw_hood(b, &c);
    if (extra == 1) draw_mobile(b, &c);
    if (extra == 2) draw_changer(b, &c);
    dmg_use(b, 0);
}
