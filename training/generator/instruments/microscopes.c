/* Draws microscopes: students' stands that lean on a pin, laboratory stands of one piece, stereo heads on a boom. */
#include "core/build.h"
#include "parts/hardware.h"

/* The optical axis is the Y axis, the arm stands behind it at z = -reach. */
typedef struct scope {
    float size, reach, arm; /* height of the whole; half the arm's width */
    float stage, nose, top; /* heights: stage's upper face, nosepiece, head */
    uint32_t limb;          /* what carries the optics: the body, or a part that leans */
} scope;

static void draw_objective(dmg_builder* b, float radius, float length) {
    float waist = length * dmg_range(b, 0.3f, 0.8f), tip = radius * dmg_range(b, 0.3f, 0.8f);
    dmg_rod(b, v3(0, -waist, 0), v3(0, 0, 0), radius);
    if (dmg_chance(b, 0.7f))
        dmg_cone(b, v3(0, -length, 0), v3(0, -waist, 0), tip, 0.9f * radius);
    else
        dmg_rod(b, v3(0, -length, 0), v3(0, -waist, 0), tip);
}

/* Under (0, y, 0): objectives on a cone that the optical axis is a line of, or on a disc beside that axis. */
static void draw_nosepiece(dmg_builder* b, uint32_t parent, float y, float r, float length) {
    bool cone = dmg_chance(b, 0.75f);
    float lean = cone ? dmg_range(b, 0.2f, 0.5f) : 0.0f, side = dmg_sign(b), apex = cone ? r / sinf(lean) : 0.0f;
    int places = dmg_int(b, 2, 5);
    float barrel = r * fminf(0.4f, 0.7f * sinf(DMG_PI / (float)places)), middle = -apex * cosf(lean);
    dmg_save(b);
    dmg_move(b, 0, y + apex, cone ? 0.0f : side * r);
    dmg_turn(b, v3(1, 0, 0), side * lean);
    dmg_spin(b, parent, "nosepiece", v3(0, 0, 0), v3(0, 1, 0));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(0, middle - 0.05f * r, 0), v3(0, middle + 0.25f * r, 0), 1.4f * r);
    else
        dmg_dome(b, v3(0, middle, 0), v3(1.45f * r, 0.5f * r, 1.45f * r));
    for (int i = 0; i < places; ++i) {
        if (i > 0 && dmg_chance(b, 0.15f)) continue;
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, places);
        dmg_turn(b, v3(1, 0, 0), -side * lean);
        dmg_move(b, 0, -apex, cone ? 0.0f : -side * r);
        draw_objective(b, barrel, length * dmg_range(b, 0.4f, 1.0f));
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Coarse and fine on one line across the arm, on one side or both; or apart. */
static void draw_focus(dmg_builder* b, const scope* s, uint32_t parent, float y) {
    float coarse = s->arm * dmg_range(b, 0.9f, 1.8f), fine = coarse * dmg_range(b, 0.4f, 0.8f),
          thick = coarse * dmg_range(b, 0.2f, 0.6f), root = 0.5f * s->arm;
    bool carried = dmg_chance(b, 0.2f), apart = dmg_chance(b, 0.25f) && s->nose > 0.0f;
    int kind = dmg_int(b, 0, 1), first = dmg_chance(b, 0.85f) ? -1 : 1;
    for (int side = first; side <= 1; side += 2) {
        float x = (float)side * s->arm, out = (float)side * thick;
        dmg_save(b);
        dmg_move(b, x, y, -s->reach);
        uint32_t knob = dmg_spin(b, parent, "coarse_focus", v3(0, 0, 0), v3(1, 0, 0));
        if (kind == 0) dmg_rod(b, v3(-(float)side * root, 0, 0), v3(out, 0, 0), coarse);
        if (kind == 1) {
            dmg_rod(b, v3(-(float)side * root, 0, 0), v3(0.5f * out, 0, 0), 0.4f * coarse);
            dmg_rod(b, v3(0.3f * out, 0, 0), v3(1.3f * out, 0, 0), coarse);
        }
        if (apart) dmg_move(b, -1.2f * out, (y > s->stage ? -1.1f : 1.1f) * (coarse + fine), 0);
        dmg_spin(b, carried && !apart ? knob : parent, "fine_focus", v3(0, 0, 0), v3(1, 0, 0));
        dmg_rod(b, v3(0, 0, 0), v3(2.2f * out, 0, 0), fine);
        dmg_restore(b);
    }
    dmg_use(b, parent);
}

/* Draws the holder that two slides carry, clips that turn about their screws, an iris' lever, a condenser. */
static void draw_stage(dmg_builder* b, const scope* s, uint32_t parent) {
    float wide = s->size * dmg_range(b, 0.12f, 0.2f), deep = fminf(0.8f * s->reach, wide), t = 0.025f * s->size,
          lift = 0.25f * (s->nose - s->stage);
    bool round = dmg_chance(b, 0.2f), crossed = dmg_chance(b, 0.5f);
    uint32_t stage = parent;
    if (dmg_chance(b, 0.6f)) stage = dmg_slide(b, parent, "stage", v3(0, 1, 0), -lift, 0.3f * lift);
    dmg_save(b);
    dmg_move(b, 0, s->stage, 0);
    if (round)
        dmg_rod(b, v3(0, -t, 0), v3(0, 0, 0), deep);
    else
        dmg_box(b, v3(0, -0.5f * t, 0), v3(2 * wide, t, 2 * deep));
    dmg_box_span(b, v3(-0.6f * s->arm, -3 * t, -s->reach + 0.5f * s->arm), v3(0.6f * s->arm, -0.5f * t, 0));
    if (crossed && !round) {
        float way = 0.3f * deep;
        uint32_t across = dmg_slide(b, stage, "stage_y", v3(0, 0, 1), -way, way);
        dmg_box(b, v3(0, 0.3f * t, 0), v3(1.7f * wide, 0.6f * t, 1.2f * deep));
        dmg_slide(b, across, "slide_holder", v3(1, 0, 0), -0.3f * wide, 0.3f * wide);
        dmg_box(b, v3(0, 0.9f * t, -0.45f * deep), v3(1.2f * wide, 0.6f * t, 0.15f * deep));
        for (int i = -1; i <= 1; i += 2)
            dmg_box(b, v3((float)i * 0.5f * wide, 0.9f * t, -0.1f * deep), v3(0.1f * wide, 0.5f * t, 0.6f * deep));
        dmg_use(b, stage);
        dmg_save(b); /* the two knobs below it, one on the other */
        dmg_move(b, dmg_sign(b) * 0.85f * wide, -t, 0.3f * deep);
        for (int i = 0; i < 2; ++i) {
            float r = t * (i == 0 ? 1.0f : 0.7f), y = -2.2f * t * (float)i;
            dmg_spin(b, stage, i == 0 ? "x_knob" : "y_knob", v3(0, 0, 0), v3(0, 1, 0));
            dmg_rod(b, v3(0, y - 2.0f * t, 0), v3(0, y, 0), r);
        }
        dmg_restore(b);
    }
    for (int i = -1; i <= 1 && !crossed; i += 2) { /* spring clips */
        float x = (float)i * 0.55f * deep, long_ = 0.8f * deep;
        dmg_hinge(b, stage, "clip", v3(x, 0, -0.5f * deep), v3(0, (float)i, 0), -0.3f, 1.2f);
        dmg_rod(b, v3(x, 0, -0.5f * deep), v3(x, 0.8f * t, -0.5f * deep), 0.4f * t);
        dmg_beam(b, v3(x, 0.3f * t, -0.5f * deep), v3(0.6f * x, 0.25f * t, -0.5f * deep + long_), 0.4f * t, 0.15f * t);
    }
    dmg_use(b, stage);
    if (dmg_chance(b, 0.6f)) {
        float r = 0.35f * deep, low = -t - 1.2f * r;
        uint32_t under = stage;
        if (dmg_chance(b, 0.6f)) under = dmg_slide(b, stage, "condenser", v3(0, -1, 0), 0.0f, 0.6f * r);
        dmg_rod(b, v3(0, low, 0), v3(0, -t, 0), r);
        dmg_hinge(b, under, "iris", v3(0, 0.6f * low, 0), v3(0, 1, 0), -0.7f, 0.7f);
        dmg_rod(b, v3(0, 0.6f * low, 0.8f * r), v3(0, 0.6f * low, 1.9f * r), 0.08f * r);
        if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0.57f * low, 0), v3(0, 0.63f * low, 0), 1.1f * r);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* Draws one eyepiece tube along +Y from the origin; what is at its end pulls out, turns, or is a part of it. */
static void draw_eyepiece(dmg_builder* b, uint32_t parent, float radius, float length) {
    dmg_rod(b, v3(0, -0.5f * radius, 0), v3(0, length, 0), radius);
    int way = dmg_int(b, 0, 2);
    float out = radius * dmg_range(b, 0.8f, 1.8f);
    if (way == 0) dmg_slide(b, parent, "eyepiece", v3(0, 1, 0), 0.0f, 0.8f * out);
    if (way == 1) dmg_spin(b, parent, "dioptre", v3(0, 0, 0), v3(0, 1, 0));
    float thin = way == 0 ? 0.85f * radius : 1.15f * radius, from = way == 0 ? length - out : 0.8f * length;
    dmg_rod(b, v3(0, from, 0), v3(0, length + out, 0), thin);
    dmg_cone(b, v3(0, length + out, 0), v3(0, length + 1.3f * out, 0), 1.1f * thin, 1.3f * thin);
    dmg_use(b, parent);
}

/* Draws a head that turns about the optical axis, its eyepieces leaning towards `side`. */
static void draw_head(dmg_builder* b, const scope* s, uint32_t parent, float side) {
    float r = s->size * dmg_range(b, 0.05f, 0.08f), lean = dmg_range(b, 0.5f, 1.0f), tube = 0.45f * r,
          length = r * dmg_range(b, 1.5f, 3.0f);
    int tubes = dmg_int(b, 1, 2);
    dmg_save(b);
    dmg_move(b, 0, s->top, 0);
    uint32_t head = parent;
    if (dmg_chance(b, 0.75f)) head = dmg_spin(b, parent, "head", v3(0, 0, 0), v3(0, 1, 0));
    dmg_rod(b, v3(0, -0.1f * r, 0), v3(0, 0.4f * r, 0), 0.9f * r);
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 1.1f * r, 0), v3(2.2f * r, 1.5f * r, 2.2f * r), 0.3f * r);
    else
        dmg_box(b, v3(0, 1.1f * r, 0), v3(2.0f * r, 1.5f * r, 2.0f * r));
    if (dmg_chance(b, 0.25f)) dmg_rod(b, v3(0, 1.5f * r, 0), v3(0, 3.5f * r, 0), 0.6f * r); /* for a camera */
    dmg_move(b, 0, 1.2f * r, side * 0.8f * r);
    dmg_turn(b, v3(1, 0, 0), side * lean);
    if (tubes == 1) draw_eyepiece(b, head, tube, length);
    bool spread = tubes == 2 && dmg_chance(b, 0.5f); /* the tubes swing apart about the line midway */
    for (int i = -1; i <= 1 && tubes == 2; i += 2) {
        uint32_t carrier = head;
        dmg_save(b);
        if (spread) {
            carrier = dmg_hinge(b, head, "tube", v3(0, 0, 0), v3(0, -(float)i * side, 0), 0.0f, 0.35f);
            dmg_rod(b, v3((float)i * 0.7f * r, 0.1f * r, 0), v3((float)i * 0.7f * r, 0.6f * r, 0), 0.65f * r);
        }
        dmg_move(b, (float)i * 0.7f * r, spread ? 0.4f * r : 0.0f, 0);
        draw_eyepiece(b, carrier, tube, length);
        dmg_restore(b);
    }
    dmg_restore(b);
    dmg_use(b, parent);
}

/* ---- stands ---- */

/* Draws a laboratory's: foot, column and arm of one piece, as boxes, as one outline, or round. */
static void draw_stand(dmg_builder* b, const scope* s) {
    float a = s->arm, foot = 0.4f * s->stage, front = 0.7f * s->reach, back = -s->reach - a, t = 0.5f * a;
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) {
        dmg_box_span(b, v3(-1.7f * a, 0, back), v3(1.7f * a, foot, front));
        dmg_box_span(b, v3(-a, 0.5f * foot, back), v3(a, s->top, back + 2 * a));
        dmg_box_span(b, v3(-a, s->nose + t, back), v3(a, s->top, 1.2f * a));
    }
    if (kind == 1) {
        float high = s->top, under = s->nose + t, in = -s->reach + 0.6f * a;
        const dmg_xy side[] = {{back, 0},         {front, 0},          {front, 0.6f * foot}, {0.8f * front, foot},
                               {in, 1.1f * foot}, {in, 0.75f * under}, {0.6f * in, under},   {a, under},
                               {a, high},         {back + a, high},    {back, 0.8f * high}};
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes z */
        dmg_extrude(b, side, 11, -a, a);
        dmg_restore(b);
        if (dmg_chance(b, 0.5f)) dmg_box_span(b, v3(-1.8f * a, 0, back), v3(1.8f * a, 0.4f * foot, front));
    }
    if (kind == 2) {
        dmg_rounded_box(b, v3(0, 0.5f * foot, 0.5f * (front + back)), v3(3.2f * a, foot, front - back), 0.2f * foot);
        dmg_rounded_box(b, v3(0, 0.5f * s->top, back + a), v3(2 * a, s->top, 2 * a), 0.4f * a);
        dmg_rounded_box(b, v3(0, 0.5f * (s->nose + t + s->top), 0.5f * (back + a)),
                        v3(2 * a, s->top - s->nose - t, a - back), 0.2f * a);
    }
    dmg_rod(b, v3(0, s->nose - 0.1f * t, 0), v3(0, s->nose + 1.5f * t, 0), 0.6f * a);
    dmg_rod(b, v3(0, foot, 0), v3(0, 1.15f * foot, 0), 0.8f * a); /* the lamp */
}

/* Draws a student's: a horseshoe and a pillar, a limb that leans about the pillar's pin, a tube that runs along it. */
static void draw_leaning(dmg_builder* b, scope* s) {
    float a = s->arm, foot = 0.05f * s->size, pin = s->stage * dmg_range(b, 0.75f, 0.95f), tube = 0.05f * s->size;
    for (int i = -1; i <= 1; i += 2) {
        dmg_beam(b, v3((float)i * 1.2f * a, 0.5f * foot, -s->reach),
                 v3((float)i * 2.2f * a, 0.5f * foot, 0.7f * s->reach), a, foot);
        if (dmg_chance(b, 0.7f))
            dmg_box_span(b, v3((float)i * 1.05f * a - 0.2f * a, 0, -s->reach - 0.6f * a),
                         v3((float)i * 1.05f * a + 0.2f * a, pin + 0.5f * a, -s->reach + 0.6f * a));
    }
    dmg_box(b, v3(0, 0.5f * foot, -s->reach), v3(3.4f * a, foot, 2 * a));
    dmg_rod(b, v3(-1.4f * a, pin, -s->reach), v3(1.4f * a, pin, -s->reach), 0.3f * a);
    s->limb = dmg_hinge(b, 0, "limb", v3(0, pin, -s->reach), v3(-1, 0, 0), 0.0f, dmg_range(b, 0.5f, 1.4f));
    float bow = 0.6f * a, low = 0.45f * pin;
    const dmg_vec arm[] = {{0, pin - a, -s->reach},
                           {0, 0.5f * (pin + s->nose), -s->reach - 0.6f * a},
                           {0, s->nose, -s->reach},
                           {0, s->nose + 0.5f * a, -1.2f * tube}};
    dmg_sweep(b, arm, 4, bow, 0.8f * a, false);
    dmg_beam(b, v3(0, pin, -s->reach), v3(0, low, -0.2f * s->reach), 0.6f * a, 0.5f * a);
    draw_stage(b, s, s->limb);
    draw_focus(b, s, s->limb, 0.85f * s->nose);
    if (dmg_chance(b, 0.7f)) { /* the mirror in its fork */
        float r = 0.05f * s->size;
        dmg_spin(b, s->limb, "mirror", v3(0, low - r, 0), v3(1, 0, 0));
        dmg_rod(b, v3(0, low - 1.1f * r, 0), v3(0, low - 0.9f * r, 0), 0.9f * r);
        dmg_use(b, s->limb);
        for (int i = -1; i <= 1; i += 2)
            dmg_beam(b, v3(0, low, -0.2f * s->reach), v3((float)i * r, low - r, 0), 0.15f * r, 0.3f * r);
    }
    float way = 0.15f * (s->nose - s->stage), length = s->top - s->nose;
    uint32_t body = dmg_slide(b, s->limb, "body_tube", v3(0, 1, 0), -way, 2 * way);
    dmg_rod(b, v3(0, s->nose, 0), v3(0, s->nose + length, 0), tube);
    draw_nosepiece(b, body, s->nose, 0.9f * tube, 0.7f * (s->nose - s->stage));
    dmg_save(b);
    dmg_move(b, 0, s->top, 0);
    draw_eyepiece(b, body, 0.85f * tube, 0.15f * length);
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws two eyepieces over a work piece: a boom that slides and turns on a post, a head that tips and a block that
 * runs. */
static void draw_stereo(dmg_builder* b, const scope* s) {
    float a = 1.6f * s->arm, post = 0.3f * a, high = s->size * dmg_range(b, 0.75f, 1.0f), reach = s->reach * 1.8f,
          y = s->nose;
    if (dmg_chance(b, 0.6f))
        dmg_box_span(b, v3(-2.5f * a, 0, -reach - 2 * a), v3(2.5f * a, 0.4f * a, 0.6f * reach));
    else
        dmg_rod(b, v3(0, 0, -reach), v3(0, 0.4f * a, -reach), 3.0f * a);
    dmg_rod(b, v3(0, 0, -reach), v3(0, high, -reach), post);
    uint32_t boom = dmg_chance(b, 0.5f) ? dmg_hinge(b, 0, "boom", v3(0, y, -reach), v3(0, 1, 0), -1.5f, 1.5f)
                                        : dmg_slide(b, 0, "boom", v3(0, 1, 0), -0.2f * y, 0.8f * (high - y - a));
    const dmg_xy collar[] = {
        {1.05f * post, -a}, {2.2f * post, -a}, {2.2f * post, a}, {1.05f * post, a}, {1.05f * post, -a}};
    dmg_lathe(b, v3(0, y, -reach), v3(0, 1, 0), collar, 5);
    if (dmg_chance(b, 0.7f))
        dmg_rod(b, v3(0, y, 2 * post - reach), v3(0, y, -1.2f * a), 0.4f * a);
    else
        dmg_beam(b, v3(0, y, 1.8f * post - reach), v3(0, y, -1.2f * a), 0.8f * a, 1.2f * a);
    uint32_t block = dmg_slide(b, boom, "focus_block", v3(0, 1, 0), -0.8f * a, 0.8f * a);
    dmg_box_span(b, v3(-0.7f * a, y - 1.5f * a, -1.3f * a), v3(0.7f * a, y + 1.5f * a, -0.5f * a));
    draw_focus(b, &(scope){.arm = 0.7f * a, .reach = 0.9f * a}, block, y);
    uint32_t head =
        dmg_chance(b, 0.5f) ? dmg_hinge(b, block, "head", v3(0, y, -0.5f * a), v3(1, 0, 0), -0.4f, 0.8f) : block;
    dmg_cone(b, v3(0, y - 1.8f * a, 0.4f * a), v3(0, y + 0.8f * a, 0.4f * a), 0.8f * a, 1.1f * a);
    for (int i = -1; i <= 1; i += 2) { /* the zoom's knob shows on both sides */
        dmg_spin(b, head, "zoom", v3(0, y, 0.4f * a), v3(1, 0, 0));
        dmg_rod(b, v3((float)i * 0.7f * a, y, 0.4f * a), v3((float)i * 1.7f * a, y, 0.4f * a), 0.5f * a);
    }
    dmg_use(b, head);
    dmg_move(b, 0, y + 0.7f * a, 0.4f * a);
    draw_head(b, &(scope){.size = 12 * a, .top = 0}, head, 1.0f);
    dmg_use(b, 0);
}

void dmg_build_microscope(dmg_builder* b) {
    scope s = {.size = dmg_scale_range(b, 0.15f, 0.6f)};
    int kind = dmg_int(b, 0, 3);
    s.reach = s.size * dmg_range(b, 0.18f, 0.3f);
    s.arm = s.size * dmg_range(b, 0.05f, 0.08f);
    s.stage = s.size * dmg_range(b, 0.28f, 0.4f);
    s.nose = s.stage + s.size * dmg_range(b, 0.15f, 0.22f);
    s.top = s.nose + s.size * dmg_range(b, 0.12f, 0.25f);
    if (kind == 2) {
        draw_leaning(b, &s);
        return;
    }
    if (kind == 3) {
        draw_stereo(b, &s);
        return;
    }
    draw_stand(b, &s);
    draw_stage(b, &s, 0);
    draw_nosepiece(b, 0, s.nose, s.arm * dmg_range(b, 0.7f, 1.0f), 0.7f * (s.nose - s.stage));
    draw_focus(b, &s, 0, s.stage * dmg_range(b, 0.5f, 0.7f));
    draw_head(b, &s, 0, kind == 0 ? 1.0f : -1.0f);
    dmg_use(b, 0);
}
