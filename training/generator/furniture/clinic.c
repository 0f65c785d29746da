/* Draws dentists' and barbers' chairs on a column with arms that swing a tray and a lamp in, and hospital beds whose
 * deck folds in sections between rails that drop. Feet towards +Z. */
#include "core/build.h"
#include "parts/hardware.h"

/* Draws a pad with soft edges or square ones, one look an object. */
static void draw_pad(dmg_builder* b, bool soft, dmg_vec low, dmg_vec high) {
    dmg_vec size = v3_sub(high, low);
    if (soft)
        dmg_rounded_box(b, v3_lerp(low, high, 0.5f), size, 0.35f * fminf(size.x, fminf(size.y, size.z)));
    else
        dmg_box_span(b, low, high);
}

/* ---- the chair ---- */

typedef struct chair {
    float width, deep, seat, t, tall;
    bool soft;
    uint32_t carrier; /* of the seat */
} chair;

/* Draws a foot, and a column that lengthens, turns or both, or an arm that lifts; the seat's underside at `seat`. */
static void draw_column(dmg_builder* b, chair* c) {
    float r = c->width * dmg_range(b, 0.1f, 0.2f), foot = c->width * dmg_range(b, 0.35f, 0.6f), thick = 0.08f * c->seat;
    int kind = dmg_int(b, 0, 3);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, 0, 0), v3(0, thick, 0), foot);
    else
        dmg_rounded_box(b, v3(0, 0.5f * thick, -0.2f * c->deep), v3(1.4f * foot, thick, 2 * foot), 0.4f * thick);
    if (kind == 3) { /* a lifting arm, pinned near the foot's rear */
        float rear = -0.6f * c->deep, low = 0.25f * c->seat;
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * r - 0.15f * r, 0.5f * thick, rear - 0.6f * r),
                         v3((float)s * r + 0.15f * r, low + 0.5f * r, rear + 0.6f * r));
        c->carrier = dmg_hinge(b, 0, "lift", v3(0, low, rear), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.2f, 0.5f));
        dmg_rod(b, v3(-1.2f * r, low, rear), v3(1.2f * r, low, rear), 0.25f * r);
        dmg_beam(b, v3(0, low, rear), v3(0, c->seat - 0.3f * r, 0), 1.6f * r, 0.8f * r);
        return;
    }
    float way = c->seat * dmg_range(b, 0.15f, 0.4f), split = thick + (c->seat - thick) * dmg_range(b, 0.4f, 0.7f);
    dmg_rod(b, v3(0, thick, 0), v3(0, split, 0), r);
    if (kind != 1) c->carrier = dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, way);
    if (kind != 1) dmg_rod(b, v3(0, split - way, 0), v3(0, c->seat, 0), 0.75f * r);
    if (kind != 0) c->carrier = dmg_spin(b, c->carrier, "swivel", v3(0, 0, 0), v3(0, 1, 0));
    if (kind == 1) dmg_rod(b, v3(0, split, 0), v3(0, c->seat, 0), 0.8f * r);
}

/* Behind the seat: a back with a rest for the head that slides up or nods. */
static void draw_chair_back(dmg_builder* b, const chair* c) {
    float rear = -0.5f * c->deep, up = c->seat + c->t * dmg_range(b, 0.0f, 1.0f),
          thin = c->t * dmg_range(b, 0.7f, 1.1f);
    float lean = dmg_range(b, 0.6f, 1.4f), top = c->seat + c->t + c->tall, head = 0.2f * c->tall;
    uint32_t back = dmg_hinge(b, c->carrier, "back", v3(0, up, rear - 0.5f * thin), v3(-1, 0, 0), 0.0f, lean);
    draw_pad(b, c->soft, v3(-0.45f * c->width, c->seat + 1.05f * c->t, rear - thin), v3(0.45f * c->width, top, rear));
    for (int s = -1; s <= 1; s += 2) /* what joins it to the pin */
        dmg_box_span(b, v3((float)s * 0.3f * c->width - 0.1f * thin, up - 0.2f * thin, rear - 0.9f * thin),
                     v3((float)s * 0.3f * c->width + 0.1f * thin, c->seat + c->t + 0.2f * c->tall, rear - 0.6f * thin));
    if (!dmg_chance(b, 0.8f)) return;
    if (dmg_chance(b, 0.5f))
        dmg_slide(b, back, "head_rest", v3(0, 1, 0), 0.0f, 0.6f * head);
    else
        dmg_hinge(b, back, "head_rest", v3(0, top + 0.1f * head, rear - 0.6f * thin), v3(-1, 0, 0), -0.6f, 0.6f);
    dmg_box_span(b, v3(-0.06f * c->width, top - 0.8f * head, rear - 1.05f * thin),
                 v3(0.06f * c->width, top + 0.6f * head, rear - 0.9f * thin));
    draw_pad(b, c->soft, v3(-0.22f * c->width, top + 0.15f * head, rear - 0.9f * thin),
             v3(0.22f * c->width, top + 1.15f * head, rear - 0.2f * thin));
}

/* Before the seat: a pad that swings up, a step on two bars that folds or slides out. */
static void draw_leg_rest(dmg_builder* b, const chair* c) {
    float nose = 0.5f * c->deep, drop = c->seat * dmg_range(b, 0.5f, 0.75f), thin = 0.6f * c->t, foot = c->seat - drop;
    int kind = dmg_int(b, 0, 2);
    if (kind == 2)
        dmg_slide(b, c->carrier, "leg_rest", v3(0, 0, 1), 0.0f, 0.4f * c->deep);
    else
        dmg_hinge(b, c->carrier, "leg_rest", v3(0, c->seat + (kind ? 0.0f : 0.5f * c->t), nose), v3(-1, 0, 0), 0.0f,
                  dmg_range(b, 0.8f, 1.5f));
    if (kind == 0) {
        draw_pad(b, c->soft, v3(-0.42f * c->width, foot, nose + 0.02f * c->deep),
                 v3(0.42f * c->width, c->seat + 0.8f * c->t, nose + thin));
        return;
    }
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.3f * c->width;
        dmg_beam(b, v3(x, c->seat - 0.15f * c->t, kind == 2 ? 0.0f : nose),
                 v3(x, c->seat - 0.15f * c->t, nose + 0.1f * c->deep), 0.2f * thin, 0.3f * thin);
        dmg_beam(b, v3(x, c->seat, nose + 0.1f * c->deep), v3(x, foot, nose + 0.35f * c->deep), 0.2f * thin,
                 0.3f * thin);
    }
    dmg_box_span(b, v3(-0.4f * c->width, foot - 0.1f * thin, nose + 0.25f * c->deep),
                 v3(0.4f * c->width, foot + 0.2f * thin, nose + 0.5f * c->deep));
}

/* Rests for the arms: fixed, swung outwards about an upright pin behind, or up about a level one. */
static void draw_arms(dmg_builder* b, const chair* c) {
    int kind = dmg_int(b, 0, 2);
    float over = c->seat + c->t + dmg_range(b, 0.25f, 0.4f) * c->deep, rear = -0.45f * c->deep, w = 0.07f * c->width;
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * (0.5f * c->width + 1.2f * w);
        dmg_use(b, c->carrier);
        dmg_box_span(b, v3(x - 0.5f * w, c->seat + 0.1f * c->t, rear - w), v3(x + 0.5f * w, over, rear + w));
        dmg_box_span(b, v3(fminf(x, (float)s * 0.4f * c->width), c->seat + 0.1f * c->t, rear - w),
                     v3(fmaxf(x, (float)s * 0.4f * c->width), c->seat + 0.5f * c->t, rear + w));
        if (kind == 1)
            dmg_hinge(b, c->carrier, "arm_rest", v3(x, over, rear), v3(0, (float)s, 0), 0.0f, dmg_range(b, 1.0f, 1.7f));
        if (kind == 2)
            dmg_hinge(b, c->carrier, "arm_rest", v3(x, over + 0.5f * w, rear), v3(-1, 0, 0), 0.0f,
                      dmg_range(b, 1.0f, 1.6f));
        draw_pad(b, c->soft, v3(x - w, over, rear - w), v3(x + w, over + w, 0.35f * c->deep));
    }
}

/* From a post beside the chair: one or two links, then a tray or a lamp on its own pin. */
static void draw_swing_arm(dmg_builder* b, const chair* c, float side, float high, bool lamp) {
    float x = side * c->width * dmg_range(b, 1.1f, 1.5f), r = 0.03f * c->width,
          reach = c->width * dmg_range(b, 0.5f, 0.8f), z = -0.3f * c->deep;
    uint32_t link = 0;
    dmg_use(b, 0);
    dmg_rod(b, v3(x, 0, z), v3(x, high, z), 1.8f * r);
    dmg_rod(b, v3(x, 0, z), v3(x, 0.04f * high, z), 8 * r);
    int links = dmg_int(b, 1, 2);
    float y = high;
    for (int i = 0; i < links; ++i) {
        float out = x - side * reach * (float)i * 0.2f, from = z + reach * (float)i;
        link = dmg_hinge(b, link, lamp ? "lamp_arm" : "tray_arm", v3(out, y, from), v3(0, 1, 0), -1.2f, 1.2f);
        dmg_rod(b, v3(out, y, from), v3(out, y + 3 * r, from), 1.6f * r);
        dmg_beam(b, v3(out, y + 1.5f * r, from),
                 v3(x - side * reach * 0.2f * (float)(i + 1), y + 1.5f * r, from + reach), 1.4f * r, 1.8f * r);
        y += 3 * r;
    }
    dmg_vec end = {x - side * reach * 0.2f * (float)links, y, z + reach * (float)links};
    if (lamp) {
        dmg_hinge(b, link, "lamp", v3_add(end, v3(0, -5 * r, 0)), v3(1, 0, 0), -0.7f, 0.7f);
        dmg_rod(b, v3_add(end, v3(0, -5 * r, 0)), v3_add(end, v3(0, -1.5f * r, 0)), 0.8f * r);
        dmg_rounded_box(b, v3_add(end, v3(0, -7 * r, 0)), v3(9 * r, 4 * r, 5 * r), r);
    } else {
        dmg_spin(b, link, "tray", end, v3(0, 1, 0));
        dmg_rod(b, v3_add(end, v3(0, -2 * r, 0)), v3_add(end, v3(0, 2 * r, 0)), 0.9f * r);
        dmg_box(b, v3_add(end, v3(0, 2.5f * r, 3 * r)), v3(16 * r, r, 11 * r));
    }
    dmg_use(b, 0);
}

void dmg_build_treatment_chair(dmg_builder* b) {
    chair c = {.width = dmg_range(b, 0.45f, 0.65f)};
    c.deep = dmg_range(b, 0.42f, 0.6f);
    c.seat = dmg_range(b, 0.35f, 0.55f);
    c.soft = dmg_chance(b, 0.6f);
    c.t = dmg_range(b, 0.05f, 0.14f);
    c.tall = dmg_range(b, 0.5f, 0.8f);
    draw_column(b, &c);
    dmg_use(b, c.carrier);
    draw_pad(b, c.soft, v3(-0.5f * c.width, c.seat, -0.5f * c.deep), v3(0.5f * c.width, c.seat + c.t, 0.5f * c.deep));
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.4f * c.width, c.seat - 0.3f * c.t, -0.45f * c.deep),
                     v3(0.4f * c.width, c.seat, 0.45f * c.deep));
    draw_chair_back(b, &c);
    dmg_use(b, c.carrier);
    if (dmg_chance(b, 0.85f)) draw_leg_rest(b, &c);
    if (dmg_chance(b, 0.75f)) draw_arms(b, &c);
    dmg_use(b, c.carrier);
    float side = dmg_sign(b), x = side * 0.5f * c.width;
    if (dmg_chance(b, 0.35f)) { /* a lever beside the seat, pumped */
        dmg_hinge(b, c.carrier, "lever", v3(x, c.seat - 0.2f * c.t, 0), v3(-1, 0, 0), -0.3f, 0.5f);
        dmg_rod(b, v3(0.7f * x, c.seat - 0.2f * c.t, 0), v3(1.15f * x, c.seat - 0.2f * c.t, 0), 0.02f);
        dmg_rod(b, v3(1.15f * x, c.seat - 0.2f * c.t, 0), v3(1.15f * x, c.seat - 0.1f * c.t, 0.4f * c.deep), 0.015f);
    }
    if (dmg_chance(b, 0.35f)) draw_swing_arm(b, &c, side, c.seat + dmg_range(b, 0.35f, 0.6f), false);
    if (dmg_chance(b, 0.25f)) draw_swing_arm(b, &c, -side, c.seat + dmg_range(b, 1.1f, 1.4f), true);
    dmg_use(b, 0);
}

/* ---- the bed: its head at -Z ---- */

typedef struct bed {
    float width, length, high, t, mattress;
    bool soft;
    uint32_t frame;
} bed;

static void draw_caster(dmg_builder* b, float x, float z, float radius, float top) {
    dmg_use(b, 0);
    uint32_t fork = dmg_chance(b, 0.5f) ? dmg_spin(b, 0, "caster", v3(x, 0, z), v3(0, 1, 0)) : 0;
    float trail = fork ? 0.4f * radius : 0.0f;
    dmg_box_span(b, v3(x - 0.5f * radius, 2.1f * radius, z - trail - 0.4f * radius),
                 v3(x + 0.5f * radius, top, z + 0.5f * radius));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3(x + (float)s * 0.45f * radius - 0.08f * radius, 0.8f * radius, z - trail - 0.3f * radius),
                     v3(x + (float)s * 0.45f * radius + 0.08f * radius, 2.1f * radius, z - trail + 0.3f * radius));
    dmg_spin(b, fork, "wheel", v3(x, radius, z - trail), v3(1, 0, 0));
    dmg_rod(b, v3(x - 0.33f * radius, radius, z - trail), v3(x + 0.33f * radius, radius, z - trail), radius);
    dmg_use(b, 0);
}

/* Below the deck: a chassis on casters, and what lifts the frame: columns, or legs that only stand. */
static void draw_bed_base(dmg_builder* b, bed* d) {
    float wheel = d->high * dmg_range(b, 0.08f, 0.14f), low = 2.6f * wheel, x = 0.38f * d->width, z = 0.4f * d->length;
    bool lifts = dmg_chance(b, 0.6f);
    for (int i = 0; i < 4; ++i) draw_caster(b, i & 1 ? x : -x, i & 2 ? z : -z, wheel, low);
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * x - d->t, low, -z), v3((float)s * x + d->t, low + d->t, z));
        dmg_box_span(b, v3(-x, low, (float)s * z - d->t), v3(x, low + d->t, (float)s * z + d->t));
    }
    float top = d->high - d->t, mid = 0.5f * (low + top);
    int columns = dmg_int(b, 1, 2);
    for (int i = 0; i < columns && lifts; ++i) {
        float at = columns == 1 ? 0.0f : (i ? 0.6f : -0.6f) * z;
        dmg_box_span(b, v3(-x, low, at - d->t), v3(x, low + d->t, at + d->t));
        dmg_box_span(b, v3(-0.12f * d->width, low, at - 0.12f * d->width),
                     v3(0.12f * d->width, mid, at + 0.12f * d->width));
    }
    if (lifts) d->frame = dmg_slide(b, 0, "lift", v3(0, 1, 0), 0.0f, 0.7f * (mid - low));
    for (int i = 0; i < columns && lifts; ++i) {
        float at = columns == 1 ? 0.0f : (i ? 0.6f : -0.6f) * z;
        dmg_box_span(b, v3(-0.09f * d->width, low + 0.3f * (mid - low), at - 0.09f * d->width),
                     v3(0.09f * d->width, top, at + 0.09f * d->width));
    }
    for (int i = 0; i < 4 && !lifts; ++i) {
        float px = i & 1 ? x : -x, pz = i & 2 ? z : -z;
        dmg_box_span(b, v3(px - 0.7f * d->t, low, pz - 0.7f * d->t), v3(px + 0.7f * d->t, top, pz + 0.7f * d->t));
    }
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * 0.42f * d->width - d->t, top, -0.48f * d->length),
                     v3((float)s * 0.42f * d->width + d->t, d->high, 0.48f * d->length));
        dmg_box_span(b, v3(-0.42f * d->width, top, (float)s * 0.47f * d->length - d->t),
                     v3(0.42f * d->width, d->high, (float)s * 0.47f * d->length + d->t));
    }
    for (int i = -1; i <= 1 && lifts; i += 2)
        dmg_box_span(b, v3(-0.42f * d->width, top, (float)i * 0.6f * z - d->t),
                     v3(0.42f * d->width, d->high, (float)i * 0.6f * z + d->t));
    if (lifts) dmg_box_span(b, v3(-0.42f * d->width, top, -d->t), v3(0.42f * d->width, d->high, d->t));
}

/* Draws one section from z0 to z1: a plate, and a mattress on it. */
static void draw_section(dmg_builder* b, const bed* d, float z0, float z1) {
    float x = 0.46f * d->width;
    dmg_box_span(b, v3(-x, d->high + 0.1f * d->t, z0), v3(x, d->high + 0.5f * d->t, z1));
    if (d->mattress > 0.0f)
        draw_pad(b, d->soft, v3(-x, d->high + 0.5f * d->t, z0), v3(x, d->high + 0.5f * d->t + d->mattress, z1));
}

static void draw_deck(dmg_builder* b, const bed* d) {
    float head = -0.47f * d->length, foot = 0.47f * d->length, hip = d->length * dmg_range(b, -0.15f, 0.02f),
          seat = hip + d->length * dmg_range(b, 0.08f, 0.15f), knee = seat + 0.45f * (foot - seat),
          y = d->high + 0.3f * d->t;
    float gap = 0.004f * d->length;
    int legs = dmg_int(b, 0, 2);
    dmg_use(b, d->frame);
    draw_section(b, d, hip + gap, legs ? seat - gap : foot);
    dmg_hinge(b, d->frame, "back", v3(0, y, hip), v3(1, 0, 0), 0.0f, dmg_range(b, 0.8f, 1.3f));
    draw_section(b, d, head, hip);
    if (dmg_chance(b, 0.4f)) /* a pillow */
        dmg_ellipsoid(b, v3(0, y + d->mattress + 0.05f, head + 0.2f), v3(0.3f * d->width, 0.06f, 0.16f));
    if (legs == 0) return;
    if (legs == 1) { /* the legs in one piece, pinned at the seat or at the foot's end */
        dmg_hinge(b, d->frame, "legs", v3(0, y, seat), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.7f));
        draw_section(b, d, seat, foot);
        return;
    }
    uint32_t thigh = dmg_hinge(b, d->frame, "thigh", v3(0, y, seat), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.3f, 0.6f));
    draw_section(b, d, seat, knee - gap);
    dmg_hinge(b, thigh, "calf", v3(0, y, knee), v3(1, 0, 0), -0.3f, 0.3f);
    draw_section(b, d, knee, foot);
}

/* Rails on one long side, one or two: drop straight down, swing out and down, or stay. */
static void draw_rails(dmg_builder* b, const bed* d, float side, int kind, int count) {
    float x = side * (0.5f * d->width + d->t), rise = d->mattress + dmg_range(b, 0.18f, 0.3f),
          base = d->high - 0.5f * d->t, r = dmg_range(b, 0.01f, 0.02f);
    int bars = dmg_int(b, 2, 6);
    bool plate = dmg_chance(b, 0.3f);
    for (int i = 0; i < count; ++i) {
        float from = -0.42f * d->length + 0.45f * d->length * (float)i,
              to = count == 1 ? 0.3f * d->length : from + 0.36f * d->length;
        dmg_use(b, d->frame);
        for (int k = 0; k < 2; ++k) {
            float z = from + (to - from) * (k ? 0.8f : 0.2f), in = side * 0.4f * d->width,
                  out = kind == 0 ? x - side * 2.2f * r : x;
            dmg_box_span(b, v3(fminf(in, out), base - 2 * r, z - 2 * r), v3(fmaxf(in, out), base, z + 2 * r));
            if (kind == 0) dmg_box_span(b, v3(out - r, base - 4 * r, z - 2 * r), v3(out + r, base + 4 * r, z + 2 * r));
        }
        if (kind == 0) dmg_slide(b, d->frame, "rail", v3(0, -1, 0), 0.0f, 0.8f * rise);
        if (kind == 1)
            dmg_hinge(b, d->frame, "rail", v3(x + side * r, base, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 2.2f, 3.0f));
        if (plate) {
            dmg_box_span(b, v3(x - r, base, from), v3(x + r, base + rise, to));
            continue;
        }
        for (int k = 0; k < 2; ++k)
            dmg_rod(b, v3(x, base + (k ? rise : 0.0f), from), v3(x, base + (k ? rise : 0.0f), to), r);
        for (int k = 0; k <= bars; ++k) {
            float z = from + (to - from) * (float)k / (float)bars;
            dmg_rod(b, v3(x, base, z), v3(x, base + rise, z), 0.8f * r);
        }
    }
    dmg_use(b, d->frame);
}

/* Boards at both ends, of which some lift off; a crank or two below the foot's, a pole that lengthens. */
static void draw_bed_ends(dmg_builder* b, const bed* d) {
    bool lift_off = dmg_chance(b, 0.3f), tubes = dmg_chance(b, 0.3f);
    for (int s = -1; s <= 1; s += 2) {
        float z = (float)s * (0.485f * d->length + d->t), rise = d->mattress + dmg_range(b, 0.1f, 0.45f);
        dmg_use(b, d->frame);
        if (lift_off) dmg_slide(b, d->frame, "board", v3(0, 1, 0), 0.0f, 0.6f * rise);
        dmg_save(b);
        dmg_move(b, 0, d->high + 0.5f * (rise - 2 * d->t), z);
        if (tubes)
            dmg_frame_draw(b, d->width, rise + 2 * d->t, d->t, d->t);
        else
            dmg_rounded_plate(b, d->width, rise + 2 * d->t, d->t, dmg_range(b, 0.02f, 0.3f) * rise);
        dmg_restore(b);
    }
    int cranks = dmg_chance(b, 0.4f) ? dmg_int(b, 1, 3) : 0;
    for (int i = 0; i < cranks; ++i) {
        float x = 0.25f * d->width * ((float)i - 0.5f * (float)(cranks - 1)), z = 0.485f * d->length + d->t,
              y = d->high - 0.7f * d->t, r = 0.012f;
        dmg_use(b, d->frame);
        dmg_spin(b, d->frame, "crank", v3(x, y, z), v3(0, 0, 1));
        dmg_rod(b, v3(x, y, z - 4 * d->t), v3(x, y, z + 5 * r), r);
        dmg_box_span(b, v3(x - r, y - 0.13f, z + 3 * r), v3(x + r, y + r, z + 5 * r));
        dmg_rod(b, v3(x, y - 0.12f, z + 3 * r), v3(x, y - 0.12f, z + 0.12f), 1.2f * r);
    }
    dmg_use(b, d->frame);
    if (!dmg_chance(b, 0.35f)) return;
    float x = 0.44f * d->width * dmg_sign(b), z = -0.53f * d->length, top = d->high + 0.8f;
    dmg_rod(b, v3(x, d->high - 0.2f, z), v3(x, top, z), 0.016f);
    dmg_box_span(b, v3(x - 0.03f, d->high - 0.8f * d->t, z - 0.03f), v3(x + 0.03f, d->high, -0.45f * d->length));
    dmg_slide(b, d->frame, "pole", v3(0, 1, 0), -0.3f, 0.3f);
    dmg_rod(b, v3(x, d->high + 0.3f, z), v3(x, top + 0.4f, z), 0.01f);
    dmg_rod(b, v3(x - 0.1f, top + 0.4f, z), v3(x + 0.1f, top + 0.4f, z), 0.008f);
    dmg_use(b, d->frame);
}

void dmg_build_hospital_bed(dmg_builder* b) {
    bed d = {.width = dmg_range(b, 0.7f, 1.1f)};
    d.length = dmg_range(b, 1.8f, 2.2f);
    d.high = dmg_range(b, 0.4f, 0.8f);
    d.t = dmg_range(b, 0.02f, 0.045f);
    d.mattress = dmg_chance(b, 0.75f) ? dmg_range(b, 0.06f, 0.18f) : 0.0f;
    d.soft = dmg_chance(b, 0.5f);
    draw_bed_base(b, &d);
    draw_deck(b, &d);
    int rails = dmg_int(b, 0, 3), kind = dmg_int(b, 0, 1), count = dmg_int(b, 1, 2);
    for (int s = -1; s <= 1 && rails > 0; s += 2) draw_rails(b, &d, (float)s, kind, count);
    draw_bed_ends(b, &d);
    dmg_use(b, 0);
}
