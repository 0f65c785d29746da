/* Draws water gates: gates in grooves drawn up by wheels, racks and cranks, gates that turn on a sill or on arms,
 * lock gates with their paddles, flaps on pipes. Upstream is -Z; the keeper stands at +Z. */
#include "core/arcs.h"
#include "core/build.h"
#include "parts/hardware.h"

/* ---- what they share ---- */

/* Draws a hand wheel about y at the origin, on its boss: rim and spokes, a plain disc, a bar with two arms. */
static void draw_hand_wheel(dmg_builder* b, float r, int kind) {
    float t = r * dmg_range(b, 0.1f, 0.25f);
    int spokes = dmg_int(b, 2, 6), knob = dmg_int(b, 0, 2);
    dmg_rod(b, v3(0, -0.6f * t, 0), v3(0, 1.2f * t, 0), 0.16f * r);
    if (kind == 3) { /* a T-bar */
        dmg_rod(b, v3(-r, 0.6f * t, 0), v3(r, 0.6f * t, 0), 0.4f * t);
        return;
    }
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    dmg_wheel_draw(b, kind == 0 ? 3 : kind == 1 ? 6 : 3, r, t, spokes);
    dmg_restore(b);
    if (knob == 0) dmg_rod(b, v3(0.9f * r, 0, 0), v3(0.9f * r, 0.6f * r, 0), 0.07f * r);
}

/* Draws a screw's thread as rings, or a plain stem, along y. */
static void draw_stem(dmg_builder* b, float low, float high, float r, bool thread) {
    dmg_rod(b, v3(0, low, 0), v3(0, high, 0), r);
    int rings = (int)fminf(14.0f, (high - low) / (4.0f * r));
    for (int i = 0; i < rings && thread; ++i) {
        float y = low + (high - low) * ((float)i + 0.5f) / (float)rings;
        dmg_cone(b, v3(0, y - 0.5f * r, 0), v3(0, y + 0.5f * r, 0), 1.1f * r, 1.4f * r);
    }
}

/* Draws a crank on its shaft along `side` x from the origin. */
static void draw_crank(dmg_builder* b, uint32_t parent, float side, float arm, float r) {
    float out = arm * dmg_range(b, 0.15f, 0.5f), grip = arm * dmg_range(b, 0.3f, 0.6f);
    dmg_spin(b, parent, "crank", v3(0, 0, 0), v3(side, 0, 0));
    dmg_rod(b, v3(-side * 2 * r, 0, 0), v3(side * out, 0, 0), r);
    dmg_box_span(b, v3(fminf(0, side * 1.6f * r) + side * out - 0.8f * side * r, -1.5f * r, -1.2f * r),
                 v3(fmaxf(0, side * 1.6f * r) + side * out - 0.8f * side * r, arm + r, 1.2f * r));
    dmg_rod(b, v3(side * out, arm, 0), v3(side * (out + grip), arm, 0), 1.1f * r);
    dmg_use(b, parent);
}

/* ---- the leaf and its frame ---- */

typedef struct frame {
    float width, high, top; /* of the opening; the yoke's underside */
    float post, t;          /* width of the side posts; thickness of the leaf */
    float lift;
} frame;

/* Planks, a ribbed plate, a plain one, a round-headed shield: about z = 0, its foot on y = 0. */
static void draw_leaf(dmg_builder* b, const frame* f, int kind) {
    float w = 0.5f * f->width + 0.3f * f->post, t = 0.5f * f->t, h = f->high;
    int rows = dmg_int(b, 2, 6);
    if (kind == 0) {
        for (int i = 0; i < rows; ++i)
            dmg_box(b, v3(0, h * ((float)i + 0.5f) / (float)rows, 0), v3(2 * w, 0.96f * h / (float)rows, 2 * t));
        for (int s = -1; s <= 1; s += 2)
            dmg_box(b, v3((float)s * 0.3f * f->width, 0.5f * h, 1.6f * t), v3(0.08f * f->width, h, 1.6f * t));
        return;
    }
    if (kind == 3) {
        dmg_box_span(b, v3(-w, 0, -t), v3(w, 0.6f * h, t));
        dmg_rod(b, v3(0, 0.6f * h, -t), v3(0, 0.6f * h, t), fminf(w, 0.45f * h));
        return;
    }
    dmg_box_span(b, v3(-w, 0, -t), v3(w, h, t));
    for (int i = 0; i < rows && kind == 1; ++i) {
        dmg_box(b, v3(0, h * ((float)i + 0.5f) / (float)rows, 1.8f * t), v3(0.9f * f->width, 1.2f * t, 2 * t));
        dmg_box(b, v3(f->width * (((float)i + 0.5f) / (float)rows - 0.5f) * 0.9f, 0.5f * h, 1.7f * t),
                v3(1.2f * t, 0.9f * h, 1.6f * t));
    }
}

/* Draws two posts with grooves for the leaf, a sill and a yoke across the top. */
static void draw_gate_frame(dmg_builder* b, const frame* f, bool groove) {
    float p = f->post, x = 0.5f * f->width, g = 0.6f * f->t;
    for (int s = -1; s <= 1; s += 2) {
        float in = (float)s * x, out = (float)s * (x + p), mid = (float)s * (x + 0.4f * p);
        if (groove) {
            dmg_box_span(b, v3(fminf(mid, out), 0, -p), v3(fmaxf(mid, out), f->top, p));
            dmg_box_span(b, v3(fminf(in, mid), 0, g), v3(fmaxf(in, mid), f->top, p));
            dmg_box_span(b, v3(fminf(in, mid), 0, -p), v3(fmaxf(in, mid), f->top, -g));
        } else { /* the leaf runs before the posts, under strips */
            dmg_box_span(b, v3(fminf(in, out), 0, -g - p), v3(fmaxf(in, out), f->top, -g));
            dmg_box_span(b, v3(fminf(mid, out), 0, -g), v3(fmaxf(mid, out), f->top, g + 0.3f * p));
        }
    }
    float back = groove ? -p : -g - p, front = groove ? p : g + 0.3f * p;
    dmg_box_span(b, v3(-x - p, -0.7f * p, back), v3(x + p, -0.02f * p, front));
    for (int s = -1; s <= 1; s += 2) /* a yoke of two beams, the stems between them */
        dmg_box_span(b, v3(-x - p, f->top, s < 0 ? back - f->t : 1.5f * f->t),
                     v3(x + p, f->top + 0.8f * p, s < 0 ? -1.5f * f->t : fmaxf(front, 2.3f * f->t)));
}

/* Walls of the channel at the sides, a floor and a walk, or nothing. */
static void draw_channel(dmg_builder* b, const frame* f) {
    float p = f->post, x = 0.5f * f->width + p, length = f->width * dmg_range(b, 0.5f, 1.5f),
          wall = p * dmg_range(b, 0.8f, 3.0f), high = f->high * dmg_range(b, 1.0f, 1.3f);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) return;
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * (x + 0.5f * wall), 0.5f * high - 0.7f * p, 0), v3(wall, high, length));
    dmg_box(b, v3(0, -0.9f * p, 0), v3(2 * x, 0.3f * p, length));
    if (kind == 2) dmg_box(b, v3(0, high - 0.6f * p, 0.35f * length + p), v3(2 * x, 0.2f * p, 0.3f * length - p));
}

/* ---- hoists ---- */

/* Draws a wheel on a pedestal over the stem: it turns and the stem comes up through it, or it climbs the thread itself.
 */
static void draw_wheel_hoist(dmg_builder* b, const frame* f, uint32_t leaf, float x) {
    float y = f->top + 0.8f * f->post, r = fminf(0.45f * f->width, f->high) * dmg_range(b, 0.35f, 0.7f),
          stem = 0.05f * r + 0.08f * f->t, rise = f->post * dmg_range(b, 0.2f, 2.5f);
    int kind = dmg_int(b, 0, 3), way = dmg_weighted(b, (const float[]){2, 1, 1}, 3);
    bool thread = dmg_chance(b, 0.5f);
    dmg_use(b, 0);
    const float foot = 3 * stem + 1.7f * f->t, bore = 1.5f * stem, low = -0.1f * f->post; /* the stem goes through it */
    const dmg_xy pedestal[] = {{bore, low}, {foot, low}, {2.2f * stem, rise}, {bore, rise}, {bore, low}};
    dmg_lathe(b, v3(x, y, 0), v3(0, 1, 0), pedestal, 5);
    dmg_use(b, leaf);
    dmg_save(b);
    dmg_move(b, x, 0, 0);
    dmg_box(b, v3(0, 0.98f * f->high, 0), v3(4 * stem, 0.06f * f->high + 2 * stem, 1.3f * f->t));
    if (way != 2)
        draw_stem(b, 0.9f * f->high, y + rise + r * dmg_range(b, 0.3f, 1.0f), stem, thread);
    else
        draw_stem(b, 0.9f * f->high, 0.98f * f->top, stem, false);
    dmg_move(b, 0, y + rise + 0.1f * r, 0);
    dmg_use(b, 0);
    if (way == 1) { /* wheel and spindle are one: the screw rises out of its nut */
        float pitch = stem * dmg_range(b, 0.15f, 0.6f);
        dmg_screw(b, 0, "screw_wheel", v3(0, 0, 0), v3(0, 1, 0), pitch, 0.0f, fminf(f->lift / pitch, 38.0f));
        draw_stem(b, -rise - 0.3f * f->post, 0, 1.5f * stem, thread);
    } else {
        dmg_spin(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 1, 0));
    }
    draw_hand_wheel(b, r, kind);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws a toothed bar on the leaf, past a box with a crank on its shaft and a pawl. */
static void draw_rack_hoist(dmg_builder* b, const frame* f, uint32_t leaf, float x) {
    float y = f->top + 0.8f * f->post, w = 0.5f * f->t + 0.02f * f->width, box = 3 * w,
          high = f->top + f->lift * dmg_range(b, 0.2f, 0.6f), side = dmg_sign(b);
    int teeth = dmg_int(b, 0, 18);
    dmg_use(b, leaf);
    dmg_box_span(b, v3(x - w, 0.5f * f->high, -0.6f * w), v3(x + w, high + box, 0.6f * w));
    for (int i = 0; i < teeth; ++i)
        dmg_box(b, v3(x + 1.2f * w, f->high + (high - f->high) * ((float)i + 0.5f) / (float)teeth, 0),
                v3(0.7f * w, 0.4f * (high - f->high) / (float)teeth, 1.2f * w));
    dmg_use(b, 0);
    for (int k = -1; k <= 1; k += 2)
        dmg_box_span(b, v3(x - 2.5f * w, y, (float)k * 1.6f * w - 0.5f * w),
                     v3(x + 3 * w, y + box, (float)k * 1.6f * w + 0.5f * w));
    dmg_save(b);
    dmg_move(b, x + side * 1.2f * w, y + 0.6f * box, 0);
    dmg_rod(b, v3(-2 * w * side, 0, 2.3f * w), v3(2 * w * side, 0, 2.3f * w), 0.7f * w);
    dmg_move(b, side * w, 0, 2.3f * w);
    draw_crank(b, 0, side, fminf(0.5f * f->high, f->width * 0.35f) * dmg_range(b, 0.5f, 1.0f), 0.35f * w);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) {
        dmg_hinge(b, 0, "pawl", v3(x - 1.5f * w, y + 1.3f * box, 2.2f * w), v3(0, 0, 1), 0.0f,
                  dmg_range(b, 0.6f, 2.5f));
        dmg_box_span(b, v3(x - 2 * w, y + 1.2f * box, 2 * w), v3(x + 2 * w, y + 1.4f * box, 2.6f * w));
        dmg_use(b, 0);
        dmg_box_span(b, v3(x - 2 * w, y + 0.9f * box, 1.2f * w), v3(x - w, y + 1.45f * box, 1.9f * w));
    }
    dmg_use(b, 0);
}

/* Draws a gate in its grooves: lifted by a wheel or two, a rack, or a bare bar pulled by hand and pinned. */
static void draw_lift_gate(dmg_builder* b) {
    frame f = {.width = dmg_scale_range(b, 0.3f, 3.0f)};
    f.high = f.width * dmg_range(b, 0.5f, 1.6f);
    f.lift = f.high * dmg_range(b, 0.6f, 1.0f);
    f.top = f.high + f.lift + 0.05f * f.high + 0.03f * f.width;
    f.post = f.width * dmg_range(b, 0.06f, 0.18f);
    f.t = f.post * dmg_range(b, 0.2f, 0.5f);
    int hoist = dmg_weighted(b, (const float[]){3, 1.5f, 1.2f}, 3), kind = dmg_int(b, 0, 3);
    bool two = hoist < 2 && f.width > 1.2f * f.high && dmg_chance(b, 0.5f);
    draw_gate_frame(b, &f, dmg_chance(b, 0.7f));
    draw_channel(b, &f);
    uint32_t leaf = dmg_slide(b, 0, "gate", v3(0, 1, 0), 0.0f, f.lift);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, leaf, f.lift * dmg_unit(b));
    draw_leaf(b, &f, kind);
    for (int i = 0; i < (two ? 2 : 1); ++i) {
        float x = two ? (i ? 0.28f : -0.28f) * f.width : 0.0f;
        if (hoist == 0) draw_wheel_hoist(b, &f, leaf, x);
        if (hoist == 1) draw_rack_hoist(b, &f, leaf, x);
    }
    if (hoist == 2) { /* a bar with holes, and a pin that is pulled out of it */
        float w = fmaxf(0.025f * f.width, 0.3f * f.t), top = f.top + f.high * dmg_range(b, 0.2f, 0.5f);
        dmg_use(b, leaf);
        dmg_box_span(b, v3(-w, 0.3f * f.high, -0.6f * f.t), v3(w, top, 0.6f * f.t));
        dmg_rod(b, v3(-0.2f * f.width, top, 0), v3(0.2f * f.width, top, 0), 0.8f * w);
        dmg_slide(b, 0, "pin", v3(0, 0, 1), 0.0f, 4 * f.post);
        float y = f.top + 0.4f * f.post, z = fmaxf(f.post, f.t);
        dmg_rod(b, v3(0, y, 0), v3(0, y, 1.8f * z), 0.35f * w);
        dmg_torus(b, v3(0, y, 1.8f * z + w), v3(1, 0, 0), w, 0.25f * w);
        dmg_use(b, 0);
    }
}

/* ---- gates that turn ---- */

/* Draws a leaf that leans on its sill: drawn up upright by chains from the walls' drums, let down downstream. */
static void draw_tilting_weir(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.5f, 4.0f), high = width * dmg_range(b, 0.3f, 0.9f),
          t = high * dmg_range(b, 0.05f, 0.12f), wall = width * dmg_range(b, 0.06f, 0.2f), x = 0.5f * width,
          line = t * dmg_range(b, -0.5f, 0.5f), swing = dmg_range(b, 0.9f, 1.5f),
          drum = wall * dmg_range(b, 0.4f, 0.8f);
    bool bowed = dmg_chance(b, 0.35f);
    dmg_box_span(b, v3(-x - wall, -2 * t, -1.2f * high), v3(x + wall, -t, 1.3f * high));
    for (int s = -1; s <= 1; s += 2)
        dmg_box(b, v3((float)s * (x + 0.5f * wall), 0.55f * high, 0.05f * high),
                v3(wall, 1.3f * high + 2 * t, 2.5f * high));
    uint32_t leaf = dmg_hinge(b, 0, "weir", v3(0, 0, line), v3(1, 0, 0), 0.0f, swing);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, leaf, swing * dmg_unit(b));
    if (bowed) {
        const dmg_xy bow[] = {{0, 0}, {-0.12f * high, 0.35f * high}, {-0.12f * high, 0.7f * high}, {0, high}};
        dmg_profile_begin(b);
        dmg_bent_plate(b, bow, 4, 0.6f * t, 0.98f * width);
        dmg_restore(b);
    } else {
        dmg_box_span(b, v3(-0.49f * width, 0, -0.5f * t), v3(0.49f * width, high, 0.5f * t));
    }
    dmg_rod(b, v3(-x, 0, line), v3(x, 0, line), 0.6f * t);
    int ribs = dmg_int(b, 0, 4);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(width * (((float)i + 0.5f) / (float)ribs - 0.5f), 0.5f * high, t), v3(t, 0.9f * high, 1.4f * t));
    for (int s = -1; s <= 1; s += 2) { /* winches on the walls */
        float at = (float)s * (x + 0.5f * wall), y = 1.2f * high + drum;
        dmg_use(b, 0);
        for (int k = -1; k <= 1; k += 2)
            dmg_box(b, v3(at + (float)k * 0.4f * wall, y, -0.6f * high), v3(0.1f * wall, 2.2f * drum, drum));
        dmg_spin(b, 0, "drum", v3(at, y, -0.6f * high), v3(1, 0, 0));
        dmg_rod(b, v3(at - 0.5f * wall, y, -0.6f * high), v3(at + 0.5f * wall, y, -0.6f * high), 0.5f * drum);
        dmg_move(b, at + (float)s * 0.5f * wall, y, -0.6f * high);
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
        dmg_wheel_draw(b, 3, 1.4f * drum, 0.2f * drum, 4);
        dmg_restore(b);
        dmg_move(b, -at - (float)s * 0.5f * wall, -y, 0.6f * high);
    }
    dmg_use(b, 0);
}

/* Draws a curved skin on arms to trunnions downstream: it turns upwards between its piers. */
static void draw_radial_gate(dmg_builder* b) {
    float r = dmg_scale_range(b, 1.0f, 6.0f), width = r * dmg_range(b, 0.7f, 1.8f), wall = 0.12f * r, t = 0.03f * r,
          x = 0.5f * width, low = -dmg_range(b, 0.15f, 0.5f), high = dmg_range(b, 0.2f, 0.5f),
          swing = dmg_range(b, 0.4f, 0.8f), foot = r * sinf(low), arm = r * dmg_range(b, 0.025f, 0.05f);
    int arms = dmg_int(b, 2, 3);
    dmg_move(b, 0, -foot, 0);
    dmg_box_span(b, v3(-x - wall, foot - 0.1f * r, -1.3f * r), v3(x + wall, foot - t, 0.3f * r));
    float top = r * sinf(high + 0.5f * swing) + 0.15f * r;
    for (int s = -1; s <= 1; s += 2) {
        dmg_box_span(b, v3((float)s * x - (s < 0 ? wall : 0), foot - t, -1.3f * r),
                     v3((float)s * x + (s < 0 ? 0 : wall), top, 0.3f * r));
        dmg_rod(b, v3((float)s * x, 0, 0), v3((float)s * (x - 0.06f * r), 0, 0), 2.5f * arm);
    }
    uint32_t gate = dmg_hinge(b, 0, "radial_gate", v3(0, 0, 0), v3(1, 0, 0), 0.0f, swing);
    if (dmg_chance(b, 0.35f)) dmg_rest(b, gate, swing * dmg_unit(b));
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI); /* the skin lies upstream */
    dmg_arc_skin(b, r, low, high, t, 0.97f * width);
    for (int s = -1; s <= 1; s += 2) {
        float at = (float)s * (x - 0.1f * r);
        dmg_rod(b, v3(at - 0.05f * r, 0, 0), v3(at + 0.05f * r, 0, 0), 2 * arm);
        for (int k = 0; k < arms; ++k) {
            float angle = low + (high - low) * ((float)k + 0.5f) / (float)arms;
            dmg_beam(b, v3(at, 0, 0), v3(at, r * sinf(angle), r * cosf(angle)), 2 * arm, 2 * arm);
        }
    }
    dmg_restore(b);
    dmg_use(b, 0);
    if (!dmg_chance(b, 0.6f)) return;
    float over = top + 0.05f * r; /* a walk over it with a hoist */
    dmg_box_span(b, v3(-x - wall, top, -0.5f * r), v3(x + wall, over, -0.1f * r));
    for (int s = -1; s <= 1; s += 2) {
        dmg_use(b, 0);
        dmg_box(b, v3((float)s * 0.3f * width, over + 0.06f * r, -0.3f * r), v3(0.1f * r, 0.24f * r, 0.05f * r));
        dmg_spin(b, 0, "hoist", v3(0, over + 0.15f * r, -0.3f * r), v3(1, 0, 0));
        float from = (float)s * 0.3f * width;
        dmg_rod(b, v3(from - 0.12f * r, over + 0.15f * r, -0.3f * r), v3(from + 0.12f * r, over + 0.15f * r, -0.3f * r),
                0.07f * r);
    }
    dmg_use(b, 0);
}

/* Half of a pair of lock gates, drawn from its heel at the origin along +x: beam above, paddle with its rack within. */
static void draw_lock_leaf(dmg_builder* b, float wide, float high, float t, float tail, bool paddle) {
    int boards = dmg_int(b, 3, 7);
    uint32_t leaf = dmg_hinge(b, 0, "lock_gate", v3(0, 0, 0), v3(0, 1, 0), 0.0f, dmg_range(b, 0.8f, 1.3f));
    for (int i = 0; i < boards; ++i)
        dmg_box(b, v3(wide * ((float)i + 0.5f) / (float)boards, 0.5f * high, 0),
                v3(0.97f * wide / (float)boards, 0.98f * high, t));
    dmg_rod(b, v3(0, 0, 0), v3(0, 1.02f * high, 0), 0.9f * t);
    for (int k = 0; k < 3; ++k)
        dmg_box(b, v3(0.5f * wide, high * (0.1f + 0.4f * (float)k), 0.9f * t), v3(0.98f * wide, t, t));
    dmg_box(b, v3(0.5f * (wide - tail), 1.02f * high + t, 0), v3(wide + tail, 2 * t, 2 * t)); /* to push it by */
    if (!paddle) return;
    float x = 0.55f * wide, w = 0.15f * wide, side = dmg_sign(b), lift = 0.25f * high;
    dmg_box(b, v3(x, 1.02f * high + 3.5f * t, 1.2f * t), v3(3 * t, 3 * t, 1.4f * t));
    dmg_slide(b, leaf, "paddle", v3(0, 1, 0), 0.0f, lift);
    dmg_box_span(b, v3(x - w, 0.12f * high, 0.5f * t), v3(x + w, 0.35f * high, 0.75f * t));
    dmg_rod(b, v3(x, 0.3f * high, 2.2f * t), v3(x, 1.1f * high + 5 * t, 2.2f * t), 0.3f * t);
    dmg_box_span(b, v3(x - 0.3f * t, 0.3f * high, 0.7f * t), v3(x + 0.3f * t, 0.3f * high + 0.6f * t, 2.2f * t));
    dmg_save(b);
    dmg_move(b, x + side * 1.5f * t, 1.02f * high + 3.5f * t, 1.4f * t);
    draw_crank(b, leaf, side, 2.5f * t, 0.3f * t);
    dmg_restore(b);
    dmg_use(b, 0);
}

static void draw_lock_gates(dmg_builder* b) {
    float width = dmg_scale_range(b, 2.0f, 6.0f), high = width * dmg_range(b, 0.5f, 1.0f),
          t = width * dmg_range(b, 0.02f, 0.04f), mitre = dmg_range(b, 0.15f, 0.35f),
          wall = width * dmg_range(b, 0.15f, 0.4f), tail = width * dmg_range(b, 0.2f, 0.6f),
          depth = width * dmg_range(b, 0.6f, 1.0f), ground = high * dmg_range(b, 0.85f, 1.0f);
    int leaves = dmg_chance(b, 0.75f) ? 2 : 1;
    bool paddle = dmg_chance(b, 0.7f), bare = dmg_chance(b, 0.25f);
    if (leaves == 1) mitre = 0;
    for (int s = -1; s <= 1 && !bare; s += 2) /* quays, hollowed round the heels by their distance */
        dmg_box(b, v3((float)s * (0.5f * width + 0.5f * wall + 1.2f * t), 0.5f * ground, -0.2f * depth),
                v3(wall, ground, depth));
    dmg_box(b, v3(0, -0.5f * t, -0.2f * depth), v3(width + 2 * wall, 0.8f * t, depth));
    float wide = (leaves == 2 ? 0.5f : 1.0f) * width / cosf(mitre) - 0.6f * t;
    for (int s = 0; s < leaves; ++s) {
        dmg_save(b);
        if (s) dmg_mirror(b, v3(1, 0, 0));
        dmg_move(b, -0.5f * width, 0, 0);
        dmg_turn(b, v3(0, 1, 0), mitre); /* towards -Z: against the water */
        draw_lock_leaf(b, wide, high, t, tail, paddle);
        dmg_restore(b);
    }
    dmg_use(b, 0);
}

/* Draws a flap over the end of a pipe or culvert: hung above its mouth, with links or lugs; a valve before it
 * sometimes. */
static void draw_flap_valve(dmg_builder* b) {
    float r = dmg_scale_range(b, 0.1f, 0.9f), t = r * dmg_range(b, 0.06f, 0.15f), length = r * dmg_range(b, 0.8f, 3.0f),
          lean = dmg_range(b, 0.0f, 0.25f), swing = dmg_range(b, 0.7f, 1.6f), up = r * dmg_range(b, 1.1f, 1.35f);
    bool square = dmg_chance(b, 0.4f), wall = dmg_chance(b, 0.5f);
    int ribs = dmg_int(b, 0, 3);
    dmg_move(b, 0, 2 * r, 0);
    const dmg_xy pipe[] = {{0.9f * r, -length}, {r, -length},       {r, -t}, {1.2f * r, -t}, {1.2f * r, 0},
                           {0.9f * r, 0},       {0.9f * r, -length}};
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -lean);
    if (square) {
        dmg_case_draw(b, DMG_CASE_BOARDS, 2.2f * r, 2.2f * r, length, 0.15f * r);
    } else {
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), pipe, 7);
    }
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.45f * r - 0.5f * t, 0.95f * r, -t),
                     v3((float)s * 0.45f * r + 0.5f * t, up + t, 2.5f * t));
    dmg_rod(b, v3(-0.6f * r, up, 1.2f * t), v3(0.6f * r, up, 1.2f * t), 0.4f * t);
    uint32_t flap = dmg_hinge(b, 0, "flap", v3(0, up, 1.2f * t), v3(-1, 0, 0), 0.0f, swing);
    if (dmg_chance(b, 0.4f)) dmg_rest(b, flap, swing * dmg_unit(b));
    if (square)
        dmg_box_span(b, v3(-1.1f * r, -1.1f * r, 0.1f * t), v3(1.1f * r, 1.05f * r, t));
    else
        dmg_rod(b, v3(0, 0, 0.1f * t), v3(0, 0, t), 1.15f * r);
    for (int i = 0; i < ribs; ++i)
        dmg_box(b, v3(0, r * (0.5f - 0.5f * (float)i), 1.3f * t), v3(1.4f * r, 0.15f * r, 0.8f * t));
    for (int s = -1; s <= 1; s += 2)
        dmg_box_span(b, v3((float)s * 0.3f * r - 0.5f * t, 0.5f * r, 0.8f * t),
                     v3((float)s * 0.3f * r + 0.5f * t, up + 0.5f * t, 1.7f * t));
    if (dmg_chance(b, 0.5f)) dmg_torus(b, v3(0, -0.7f * r, 1.5f * t), v3(1, 0, 0), 0.12f * r, 0.03f * r);
    dmg_restore(b);
    dmg_use(b, 0);
    if (wall) dmg_box_span(b, v3(-2 * r, -2 * r, -length - 0.4f * r), v3(2 * r, 1.8f * r, -length));
    if (!square && length > 1.5f * r && dmg_chance(b, 0.7f)) { /* a slide valve's wheel on the pipe */
        float z = -0.5f * length, y = r * dmg_range(b, 1.5f, 2.2f);
        dmg_box_span(b, v3(-0.5f * r, 0.5f * r - lean * z, z - 0.2f * r), v3(0.5f * r, y, z + 0.2f * r));
        dmg_move(b, 0, y + 0.15f * r, z);
        dmg_spin(b, 0, "hand_wheel", v3(0, 0, 0), v3(0, 1, 0));
        draw_hand_wheel(b, 0.6f * r, dmg_int(b, 0, 3));
        dmg_rod(b, v3(0, -0.2f * r, 0), v3(0, 0, 0), 0.08f * r);
    }
    dmg_use(b, 0);
}

void dmg_build_sluice_gate(dmg_builder* b) {
    int kind = dmg_weighted(b, (const float[]){4, 1, 1, 1.5f, 1.2f}, 5);
    if (kind == 0) draw_lift_gate(b);
    if (kind == 1) draw_tilting_weir(b);
    if (kind == 2) draw_radial_gate(b);
    if (kind == 3) draw_lock_gates(b);
    if (kind == 4) draw_flap_valve(b);
    dmg_use(b, 0);
}
