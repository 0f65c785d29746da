/* Draws displays on stands of every kind, and portable computers with unusual connections between their halves. */
#include "core/build.h"
#include "parts/hardware.h"

typedef struct screen {
    float width, height, t;
    int shape;
} screen;

/* Keys in rows on y = 0 facing up, or one sunken field. */
static void draw_key_field(dmg_builder* b, float width, float depth, float rise) {
    int rows = dmg_int(b, 0, 5), columns = dmg_int(b, 7, 13);
    if (rows < 2) dmg_box(b, v3(0, 0, 0), v3(width, rise, depth));
    for (int i = 0; i < rows * columns && rows >= 2; ++i) {
        float x = width * (((float)(i % columns) + 0.5f) / (float)columns - 0.5f),
              z = depth * (((float)(i / columns) + 0.5f) / (float)rows - 0.5f);
        dmg_box(b, v3(x, 0, z), v3(0.85f * width / (float)columns, 2 * rise, 0.8f * depth / (float)rows));
    }
}

/* Centred in x and y, front at z = 0, back at z = -t but for a swelling. */
static void draw_screen(dmg_builder* b, const screen* s) {
    float w = s->width, h = s->height, t = s->t, border = dmg_range(b, 0.02f, 0.1f) * h;
    dmg_vec centre = {0, 0, -0.5f * t}, size = {w, h, t};
    if (s->shape == 0) dmg_box(b, centre, size);
    if (s->shape == 1) dmg_rounded_plate(b, w, h, t, dmg_range(b, 0.02f, 0.15f) * h);
    if (s->shape == 2) dmg_rounded_box(b, centre, size, 0.45f * t);
    if (s->shape == 3) { /* a case, its bezel and the glass let in */
        dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_FRONT);
        dmg_frame_draw(b, w, h, 0.3f * t, border);
    }
    if (s->shape == 4) { /* a thin plate, what drives it in a box behind */
        dmg_box(b, v3(0, 0, -0.15f * t), v3(w, h, 0.3f * t));
        float at = dmg_range(b, -0.15f, 0.05f) * h, wide = w * dmg_range(b, 0.35f, 0.8f);
        dmg_box(b, v3(0, at, -0.65f * t), v3(wide, 0.6f * h, 0.7f * t));
    }
    if (s->shape >= 3 || dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, 0, s->shape == 3 ? -0.25f * t : 0.0f), v3(w - 2 * border, h - 2 * border, 0.06f * t));
    if (dmg_chance(b, 0.15f)) dmg_box(b, v3(0, 0.52f * h, -0.4f * t), v3(0.12f * h, 0.06f * h, 0.5f * t));
}

/* Draws a foot on y = 0 about the origin. */
static void draw_foot(dmg_builder* b, float width, float depth, float thick) {
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_box(b, v3(0, 0.5f * thick, 0), v3(width, thick, depth));
    if (kind == 1) dmg_cone(b, v3(0, 0, 0), v3(0, thick, 0), 0.5f * depth, 0.42f * depth);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0.5f * thick, 0), v3(width, thick, depth), 0.4f * thick);
    for (int s = -1; s <= 1 && kind == 3; s += 2) /* two legs that spread to the front */
        dmg_beam(b, v3(0, 0.5f * thick, -0.3f * depth), v3((float)s * 0.5f * width, 0.5f * thick, 0.5f * depth),
                 0.1f * width, thick);
}

/* ---- stands ---- */

/* Draws the head on its tilting line: `at` in the screen's frame. Between the two may be a plate on which it rolls. */
static void hang_screen(dmg_builder* b, const screen* s, uint32_t carrier, dmg_vec at, float fore, bool rolls) {
    float barrel = s->height * dmg_range(b, 0.01f, 0.035f), half = s->width * dmg_range(b, 0.05f, 0.25f),
          plate = s->height * dmg_range(b, 0.12f, 0.3f);
    int owner = dmg_int(b, 0, 2);
    dmg_use(b, carrier);
    if (owner == 0) dmg_rod(b, v3(-half, at.y, at.z), v3(half, at.y, at.z), barrel);
    uint32_t tilt = dmg_hinge(b, carrier, rolls ? "bracket" : "screen", at, v3(-1, 0, 0), -fore,
                              dmg_range(b, 0.25f, 0.9f)); /* its top goes back */
    if (owner == 1) dmg_rod(b, v3(-half, at.y, at.z), v3(half, at.y, at.z), barrel);
    if (rolls || (at.z < -1.1f * s->t && dmg_chance(b, 0.7f))) {
        float z = 0.5f * (at.z - s->t);
        dmg_box(b, v3(0, at.y, z), v3(plate, plate, fmaxf(-at.z - s->t, 0.15f * s->t)));
    }
    if (rolls) dmg_hinge(b, tilt, "screen", v3(0, at.y, -s->t), v3(0, 0, dmg_sign(b)), 0.0f, 0.5f * DMG_PI);
    draw_screen(b, s);
    dmg_use(b, 0);
}

/* Foot, neck and head; the foot may let the neck turn, a carriage may go up and down on it. */
static void draw_neck_stand(dmg_builder* b, const screen* s) {
    float h = s->height, foot = h * dmg_range(b, 0.02f, 0.06f), reach = h * dmg_range(b, 0.02f, 0.2f),
          thick = h * dmg_range(b, 0.04f, 0.12f), wide = s->width * dmg_range(b, 0.06f, 0.3f);
    bool turns = dmg_chance(b, 0.35f), climbs = dmg_chance(b, 0.35f), rolls = dmg_chance(b, 0.25f);
    float middle = (rolls ? fmaxf(0.55f * s->width, 0.5f * h) : 0.5f * h) + foot + h * dmg_range(b, 0.08f, 0.4f),
          post = -s->t - reach - 0.5f * thick, way = climbs ? 0.6f * (middle - 0.5f * h - foot) : 0.0f;
    dmg_move(b, 0, 0, -post);
    dmg_save(b);
    dmg_move(b, 0, 0, post + h * dmg_range(b, 0.0f, 0.15f));
    float across = s->width * dmg_range(b, 0.35f, 0.7f), deep = h * dmg_range(b, 0.35f, 0.6f);
    draw_foot(b, across, deep, foot);
    dmg_restore(b);
    uint32_t carrier = 0;
    if (turns) carrier = dmg_hinge(b, 0, "swivel", v3(0, 0, post), v3(0, 1, 0), -1.2f, 1.2f);
    if (turns) dmg_rod(b, v3(0, foot, post), v3(0, 1.6f * foot, post), 1.2f * thick);
    int neck = dmg_int(b, 0, 2);
    float top = middle + 0.5f * thick + way;
    if (neck == 0)
        dmg_box_span(b, v3(-0.5f * wide, foot, post - 0.5f * thick), v3(0.5f * wide, top, post + 0.5f * thick));
    if (neck == 1) dmg_rod(b, v3(0, foot, post), v3(0, top, post), 0.5f * thick);
    for (int i = -1; i <= 1 && neck == 2; i += 2)
        dmg_rod(b, v3(0.4f * (float)i * wide, foot, post), v3(0.4f * (float)i * wide, top, post), 0.3f * thick);
    if (climbs) {
        carrier = dmg_slide(b, carrier, "carriage", v3(0, 1, 0), -way, 0.0f);
        dmg_move(b, 0, way, 0);
        float round = neck == 1 ? thick : wide;
        dmg_box(b, v3(0, middle, post), v3(1.2f * round, 2.2f * thick, 1.4f * thick));
    }
    /* The line is at the neck's front, on the screen's back or in the middle of its thickness. */
    const float lines[] = {0.5f * (post - s->t), -s->t - 0.02f * h, -s->t, -0.5f * s->t};
    int line = dmg_int(b, 0, rolls ? 1 : 3);
    float off = dmg_chance(b, 0.5f) ? 0.0f : h * dmg_range(b, -0.25f, 0.1f);
    dmg_box_span(b, v3(-0.3f * wide, middle + off - 0.4f * thick, post),
                 v3(0.3f * wide, middle + off + 0.4f * thick, fminf(lines[line], -s->t)));
    dmg_move(b, 0, middle, 0);
    float fore = asinf(fminf(0.35f, 0.8f * reach / (0.5f * h + off)));
    hang_screen(b, s, carrier, v3(0, off, lines[line]), fmaxf(0.03f, fore), rolls);
}

/* Arms on both sides hold it on pins, in the middle of its height or not. */
static void draw_yoke_stand(dmg_builder* b, const screen* s) {
    float h = s->height, foot = h * dmg_range(b, 0.03f, 0.1f), arm = h * dmg_range(b, 0.02f, 0.06f);
    float pin = dmg_chance(b, 0.5f) ? 0.0f : h * dmg_range(b, -0.3f, 0.2f), z = -s->t * dmg_range(b, 0.2f, 0.8f);
    bool free = dmg_chance(b, 0.5f);
    float far = sqrtf((0.5f * h + pin) * (0.5f * h + pin) + s->t * s->t),
          line = foot + (free ? 1.05f * far : 0.54f * h + pin), swing = free ? dmg_range(b, 0.6f, 1.5f) : 0.25f;
    uint32_t carrier = 0;
    draw_foot(b, 0.6f * s->width, fmaxf(0.4f * h, 1.5f * s->t), foot);
    if (dmg_chance(b, 0.4f)) carrier = dmg_hinge(b, 0, "swivel", v3(0, 0, 0), v3(0, 1, 0), -1.5f, 1.5f);
    float x = 0.5f * s->width + 0.8f * arm, low = carrier ? 1.02f * foot : 0.5f * foot;
    dmg_box(b, v3(0, low + 0.5f * arm, 0), v3(2 * x + arm, arm, 3 * arm));
    for (int i = -1; i <= 1; i += 2) {
        dmg_box_span(b, v3((float)i * x - 0.5f * arm, low, -1.5f * arm),
                     v3((float)i * x + 0.5f * arm, line + arm, 1.5f * arm));
        if (dmg_chance(b, 0.6f))
            dmg_rod(b, v3((float)i * (x - arm), line, 0), v3((float)i * (x + 1.5f * arm), line, 0), 0.6f * arm);
    }
    dmg_hinge(b, carrier, "screen", v3(0, line, 0), v3(-1, 0, 0), -swing, swing);
    dmg_move(b, 0, line - pin, -z);
    draw_screen(b, s);
}

/* It stands on its lower edge in a bed, and leans back or lies down; or stands in it on a short lug. */
static void draw_edge_stand(dmg_builder* b, const screen* s) {
    float h = s->height, foot = h * dmg_range(b, 0.04f, 0.25f), depth = h * dmg_range(b, 0.3f, 0.9f),
          r = fmaxf(0.4f * s->t, foot * 0.2f) * dmg_range(b, 0.5f, 1.0f), gap = r * dmg_range(b, 0.1f, 1.5f);
    static const float through[] = {0.0f, 0.5f, 0.5f, 1.0f};
    float z = -s->t * through[dmg_int(b, 0, 3)], front = depth * dmg_range(b, 0.2f, 0.9f);
    dmg_box(b, v3(0, 0.5f * foot, front - 0.5f * depth), v3(s->width * dmg_range(b, 0.4f, 1.1f), foot, depth));
    float line = foot + gap, half = s->width * dmg_range(b, 0.06f, 0.45f);
    bool twin = half < 0.2f * s->width && dmg_chance(b, 0.6f), upon = dmg_chance(b, 0.5f);
    float fore = dmg_range(b, 0.0f, 0.5f), aft = fminf(1.4f, dmg_range(b, 0.3f, 1.6f));
    uint32_t head = dmg_hinge(b, 0, "screen", v3(0, line, z), v3(-1, 0, 0), -fore, aft);
    for (int i = twin ? -1 : 1; i <= 1; i += 2) {
        float x = twin ? 0.33f * (float)i * s->width : 0.0f;
        dmg_use(b, upon ? head : 0);
        dmg_rod(b, v3(x - half, line, z), v3(x + half, line, z), r);
        dmg_use(b, head);
        if (gap > r)
            dmg_box_span(b, v3(x - 0.4f * half, line - r, z - 0.5f * r),
                         v3(x + 0.4f * half, line + 1.2f * r, z + 0.5f * r));
    }
    float lowest = dmg_chance(b, 0.5f) ? 0.0f : fminf(0.6f * r, 0.9f * gap);
    dmg_move(b, 0, line - lowest + 0.5f * h, 0);
    draw_screen(b, s);
}

/* Draws a leg on the back of what leans: a narrow strut, a wide flap or a bent wire, folded flat at 0. */
static void draw_back_leg(dmg_builder* b, uint32_t parent, const screen* s, float at, float open) {
    float length = 0.5f * s->height + at,
          w = s->width * (dmg_chance(b, 0.5f) ? dmg_range(b, 0.1f, 0.3f) : dmg_range(b, 0.6f, 0.98f)),
          t = s->t * dmg_range(b, 0.15f, 0.4f), z = -s->t - 0.5f * t;
    int kind = dmg_int(b, 0, 2);
    if (dmg_chance(b, 0.5f)) { /* knuckles, or a leaf of its hinge */
        dmg_use(b, parent);
        dmg_box(b, v3(0, at + 0.03f * s->height, z), v3(0.8f * w, 0.06f * s->height, t));
    }
    uint32_t leg =
        dmg_hinge(b, parent, "kickstand", v3(0, at, dmg_chance(b, 0.5f) ? z : -s->t), v3(1, 0, 0), 0.0f, 1.3f * open);
    if (kind == 0) dmg_box(b, v3(0, at - 0.49f * length, z), v3(w, 0.98f * length, t));
    if (kind == 1) { /* narrower below */
        const dmg_xy flap[] = {{-0.3f * w, at - length}, {0.3f * w, at - length}, {0.5f * w, at}, {-0.5f * w, at}};
        dmg_extrude(b, flap, 4, z - 0.5f * t, z + 0.5f * t);
    }
    if (kind == 2) {
        const dmg_vec wire[] = {
            {-0.5f * w, at, z}, {-0.5f * w, at - length, z}, {0.5f * w, at - length, z}, {0.5f * w, at, z}};
        dmg_sweep(b, wire, 4, 0.5f * t, 0.5f * t, false);
    }
    dmg_rest(b, leg, open);
    dmg_use(b, parent);
}

/* Draws a frame or a panel that leans back on a leg. */
static void draw_easel(dmg_builder* b, const screen* s) {
    float lean = dmg_range(b, 0.1f, 0.5f);
    if (dmg_chance(b, 0.7f)) dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_move(b, 0, 0.5f * s->height, 0);
    draw_screen(b, s);
    float at = s->height * dmg_range(b, -0.1f, 0.35f), open = dmg_range(b, 0.5f, 1.1f);
    draw_back_leg(b, 0, s, at, open);
}

/* Draws a deep box with a tube behind, on a bowl whose middle is somewhere inside it. */
static void draw_tube_set(dmg_builder* b, const screen* s) {
    float w = s->width, h = s->height, deep = h * dmg_range(b, 0.5f, 1.1f), foot = 0.05f * h,
          bowl = h * dmg_range(b, 0.2f, 0.4f), front = 0.3f * deep, sink = dmg_range(b, 0.3f, 0.7f) * bowl;
    bool turns = dmg_chance(b, 0.5f), nods = !turns || dmg_chance(b, 0.6f);
    float line = foot + bowl, under = line - sink; /* the case's underside */
    uint32_t ring = 0;
    dmg_cone(b, v3(0, 0, 0), v3(0, foot, 0), 1.1f * bowl, 0.8f * bowl);
    if (turns) ring = dmg_hinge(b, 0, nods ? "swivel" : "screen", v3(0, 0, 0), v3(0, 1, 0), -1.3f, 1.3f);
    if (turns && nods) dmg_cone(b, v3(0, foot, 0), v3(0, 1.5f * foot, 0), 0.8f * bowl, 0.6f * bowl);
    if (nods) dmg_hinge(b, ring, "screen", v3(0, line, 0), v3(-1, 0, 0), -0.1f, dmg_range(b, 0.2f, 0.4f));
    enum { ROWS = 5 };
    dmg_xy cup[ROWS]; /* the bowl, from its lowest ring up into the case */
    for (int i = 0; i < ROWS; ++i) {
        float angle = 0.5f + 0.7f * (float)i / (ROWS - 1);
        cup[i] = (dmg_xy){bowl * sinf(angle), line - bowl * cosf(angle)};
    }
    dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), cup, ROWS);
    dmg_move(b, 0, under + 0.5f * h, front);
    dmg_box(b, v3(0, 0, -0.2f * deep), v3(w, h, 0.4f * deep));
    const dmg_xy outline[] = {
        {-0.5f * w, -0.5f * h}, {0.5f * w, -0.5f * h}, {0.5f * w, 0.5f * h}, {-0.5f * w, 0.5f * h}};
    float last = dmg_range(b, 0.4f, 0.8f);
    const dmg_row rows[] = {{last, last, 0.0f, -deep}, {0.96f, 0.96f, 0, -0.4f * deep}};
    dmg_loft(b, outline, 4, rows, 2);
    dmg_box(b, v3(0, 0.05f * h, 0), v3(0.85f * w, 0.75f * h, 0.02f * deep));
}

/* On a wall: links about upright lines, then the head that nods. */
static void draw_wall_arm(dmg_builder* b, const screen* s) {
    float h = s->height, arm = h * dmg_range(b, 0.04f, 0.09f), plate = h * dmg_range(b, 0.2f, 0.5f), way = dmg_sign(b);
    int links = dmg_int(b, 1, 2);
    dmg_box(b, v3(0, 0, 0.25f * arm), v3(plate, 1.2f * plate, 0.5f * arm));
    dmg_vec at = {0, 0, 1.2f * arm};
    dmg_rod(b, v3(0, -1.4f * arm, at.z), v3(0, 1.4f * arm, at.z), 0.7f * arm);
    uint32_t carrier = 0;
    for (int i = 0; i < links; ++i) {
        float length = s->width * dmg_range(b, 0.3f, 0.5f), turn = dmg_range(b, 0.2f, 0.7f);
        dmg_vec end = v3_add(at, v3(way * length * cosf(turn), 0, length * sinf(turn)));
        carrier = dmg_hinge(b, carrier, "arm", at, v3(0, -way, 0), -0.8f * turn, dmg_range(b, 1.0f, 2.0f) - turn);
        dmg_beam(b, at, end, 0.8f * arm, 1.6f * arm);
        dmg_rod(b, v3(end.x, -1.5f * arm, end.z), v3(end.x, 1.5f * arm, end.z), 0.6f * arm);
        at = end;
        way = -way;
    }
    carrier = dmg_hinge(b, carrier, "head", at, v3(0, 1, 0), -0.7f, 0.7f);
    dmg_box(b, v3(at.x, 0, at.z + 1.2f * arm), v3(2 * arm, 1.2f * arm, 2.4f * arm));
    dmg_move(b, at.x, 0, at.z + 3.2f * arm + s->t);
    float fore = dmg_range(b, 0.05f, 0.2f);
    bool rolls = dmg_chance(b, 0.2f);
    hang_screen(b, s, carrier, v3(0, 0, -s->t - 0.8f * arm), fore, rolls);
}

void dmg_build_monitor(dmg_builder* b) {
    static const float weights[] = {4, 1.5f, 2, 1.2f, 1.2f, 1.2f};
    int stand = dmg_weighted(b, weights, 6);
    screen s = {.shape = dmg_int(b, 0, 4)};
    s.height = dmg_scale_range(b, 0.08f, 0.7f);
    s.width = s.height * (dmg_chance(b, 0.2f) ? dmg_range(b, 0.6f, 1.0f) : dmg_range(b, 1.2f, 2.4f));
    s.t = s.height * dmg_scale_range(b, 0.03f, 0.2f);
    if (stand == 0) draw_neck_stand(b, &s);
    if (stand == 1) draw_yoke_stand(b, &s);
    if (stand == 2) draw_edge_stand(b, &s);
    if (stand == 3) draw_easel(b, &s);
    if (stand == 4) draw_tube_set(b, &s);
    if (stand == 5) draw_wall_arm(b, &s);
}

/* ---- portable computers ---- */

/* Draws one half, lying on y = 0 … t, from z = -depth to 0. */
static void draw_half(dmg_builder* b, int shape, float width, float depth, float t) {
    dmg_save(b);
    dmg_move(b, 0, 0.5f * t, -0.5f * depth);
    if (shape == 0) dmg_box(b, v3(0, 0, 0), v3(width, t, depth));
    if (shape == 1) dmg_rounded_box(b, v3(0, 0, 0), v3(width, t, depth), 0.45f * t);
    if (shape == 2) {
        dmg_move(b, 0, 0.5f * t, 0);
        dmg_face_up(b);
        dmg_rounded_plate(b, width, depth, t, dmg_range(b, 0.03f, 0.2f) * depth);
    }
    dmg_restore(b);
}

/* Draws two lines, one in each half, and a bar that joins them behind. The frame: front edges at z = 0. */
static void draw_two_lines(dmg_builder* b, const screen* s, float base, int shape) {
    float rear = -s->height, t = s->t, low = 0.5f * base, high = base + 0.5f * t, r = 0.4f * fminf(base, t),
          out = rear - r * dmg_range(b, 0.0f, 1.3f), bar = s->width * dmg_range(b, 0.08f, 0.9f);
    bool twin = bar < 0.3f * s->width;
    draw_half(b, shape, s->width, s->height, base);
    dmg_save(b);
    dmg_move(b, 0, base, 0.6f * rear);
    draw_key_field(b, 0.88f * s->width, 0.45f * s->height, 0.1f * t);
    dmg_restore(b);
    uint32_t link = dmg_hinge(b, 0, "hinge", v3(0, low, out), v3(-1, 0, 0), 0.0f, 0.95f * DMG_PI);
    for (int i = twin ? -1 : 1; i <= 1; i += 2) {
        float x = twin ? 0.36f * (float)i * s->width : 0.0f;
        dmg_rod(b, v3(x - 0.5f * bar, low, out), v3(x + 0.5f * bar, low, out), r);
        dmg_rod(b, v3(x - 0.5f * bar, high, out), v3(x + 0.5f * bar, high, out), r);
        dmg_box_span(b, v3(x - 0.48f * bar, low, out - r), v3(x + 0.48f * bar, high, out));
    }
    uint32_t lid = dmg_hinge(b, link, "screen", v3(0, high, out), v3(-1, 0, 0), 0.0f, 0.95f * DMG_PI);
    dmg_move(b, 0, base + 0.01f * t, 0);
    draw_half(b, shape, s->width, s->height, t);
    if (dmg_chance(b, 0.5f)) dmg_box(b, v3(0, 0, 0.5f * rear), v3(0.9f * s->width, 0.02f * t, 0.85f * s->height));
    if (dmg_chance(b, 0.6f)) {
        dmg_rest(b, link, dmg_range(b, 0.0f, 1.2f));
        dmg_rest(b, lid, dmg_range(b, 0.6f, 1.6f));
    }
    dmg_use(b, 0);
}

/* Draws a pillar in the middle of the rear edge: it lies down with the screen, and the screen turns about on it. */
static void draw_turning_screen(dmg_builder* b, const screen* s, float base, int shape) {
    float rear = -s->height, post = s->width * dmg_range(b, 0.05f, 0.14f), r = fmaxf(0.5f * s->t, 0.25f * post),
          up = base + r, open = dmg_range(b, 1.5f, 1.9f);
    draw_half(b, shape, s->width, s->height, base);
    dmg_save(b);
    dmg_move(b, 0, base, 0.55f * rear);
    draw_key_field(b, 0.88f * s->width, 0.5f * s->height, 0.1f * s->t);
    dmg_restore(b);
    float line = rear + r;
    uint32_t neck =
        dmg_hinge(b, 0, "hinge", v3(0, up, line), v3(-1, 0, 0), 0.0f, fmaxf(open, dmg_range(b, 1.6f, 2.2f)));
    dmg_rod(b, v3(-post, up, line), v3(post, up, line), r);
    float edge = line + 1.3f * r;
    dmg_rod(b, v3(0, up, line), v3(0, up, edge), 0.7f * fmaxf(post, r));
    uint32_t lid = dmg_hinge(b, neck, "screen", v3(0, up, edge), v3(0, 0, dmg_sign(b)), 0.0f, DMG_PI);
    dmg_save(b);
    dmg_move(b, 0, up - 0.5f * s->t, 0);
    dmg_move(b, 0, 0, edge + (s->height - 2.3f * r));
    draw_half(b, shape, s->width, s->height - 2.3f * r, s->t);
    dmg_restore(b);
    dmg_rest(b, neck, open);
    dmg_rest(b, lid, dmg_chance(b, 0.6f) ? 0.0f : dmg_range(b, 0.0f, DMG_PI));
    dmg_keep_rest(b, neck);
    dmg_use(b, 0);
}

/* An arm from the base's rear holds the screen at the middle of its back; it stands, leans forward or lies. */
static void draw_held_screen(dmg_builder* b, const screen* s, float base, int shape) {
    float rear = -s->height, at = rear * dmg_range(b, 0.4f, 0.65f), arm = fmaxf(0.25f * s->t, 0.002f),
          up = base + s->t + arm,
          wide = s->width * (dmg_chance(b, 0.5f) ? dmg_range(b, 0.7f, 1.0f) : dmg_range(b, 0.15f, 0.4f));
    draw_half(b, shape, s->width, s->height, base);
    dmg_save(b);
    dmg_move(b, 0, base, 0.6f * rear);
    draw_key_field(b, 0.88f * s->width, 0.45f * s->height, 0.1f * s->t);
    dmg_restore(b);
    dmg_vec low = {0, base + 0.5f * s->t, rear - arm};
    float lean = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, 0.1f, 0.4f); /* with it the arm can't go down whole */
    uint32_t holder = dmg_hinge(b, 0, "arm", low, v3(-1, 0, 0), lean, dmg_range(b, 1.5f, 2.2f));
    dmg_rod(b, v3(-0.5f * wide, low.y, low.z), v3(0.5f * wide, low.y, low.z), fmaxf(arm, 0.3f * s->t));
    dmg_box_span(b, v3(-0.5f * wide, low.y, low.z - arm), v3(0.5f * wide, up, low.z));
    dmg_box_span(b, v3(-0.5f * wide, up - arm, low.z - arm), v3(0.5f * wide, up + 0.5f * arm, at));
    uint32_t lid = dmg_hinge(b, holder, "screen", v3(0, up - arm, at), v3(1, 0, 0), 0.0f, dmg_range(b, 0.6f, 2.6f));
    dmg_save(b);
    dmg_move(b, 0, base + 0.02f * s->t, 0);
    draw_half(b, shape, s->width, s->height, 0.96f * s->t);
    dmg_restore(b);
    dmg_rest(b, holder, dmg_range(b, 1.2f, 1.5f));
    dmg_rest(b, lid, lean);
    dmg_keep_rest(b, holder);
    dmg_use(b, 0);
}

/* Draws a tablet that leans on its leg, and a thin cover with keys that hangs on its lower edge. */
static void draw_tablet(dmg_builder* b, const screen* s) {
    float lean = dmg_range(b, 0.15f, 0.7f), thin = s->t * dmg_range(b, 0.3f, 0.9f),
          depth = s->height * dmg_range(b, 0.7f, 1.0f);
    screen slab = *s;
    slab.shape = dmg_int(b, 0, 2);
    dmg_move(b, 0, thin, 0);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_move(b, 0, 0.5f * s->height, 0);
    draw_screen(b, &slab);
    float at = s->height * dmg_range(b, -0.1f, 0.15f), open = dmg_range(b, 0.6f, 1.1f);
    draw_back_leg(b, 0, &slab, at, open);
    dmg_restore(b);
    float shut = 0.5f * DMG_PI + lean - 0.02f, line = dmg_range(b, -1.0f, 0.0f) * thin;
    uint32_t cover =
        dmg_hinge(b, 0, "keyboard", v3(0, line, dmg_range(b, -0.2f, 0.6f) * thin), v3(-1, 0, 0), 0.0f, shut);
    dmg_save(b);
    dmg_move(b, 0, -thin, depth + 0.3f * thin);
    draw_half(b, dmg_int(b, 0, 2), s->width, depth, thin);
    dmg_move(b, 0, thin, -0.6f * depth);
    draw_key_field(b, 0.9f * s->width, 0.6f * depth, 0.1f * thin);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f))
        dmg_box_span(b, v3(-0.48f * s->width, -thin, -0.5f * thin), v3(0.48f * s->width, -0.6f * thin, 0.6f * thin));
    dmg_keep_rest(b, cover);
    dmg_use(b, 0);
}

/* Draws a box to carry: its front is the keyboard, which comes down about its lower edge; a grip on top. */
static void draw_portable(dmg_builder* b, const screen* s) {
    float w = s->width, h = s->height, deep = h * dmg_range(b, 0.25f, 1.2f), t = h * dmg_range(b, 0.06f, 0.2f),
          in = dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.1f, 0.9f);
    dmg_move(b, 0, 0.5f * h + 0.02f * h, 0);
    dmg_case_draw(b, dmg_chance(b, 0.5f) ? DMG_CASE_SOLID : DMG_CASE_BOARDS, w, h, deep, 0.04f * h);
    dmg_box(b, v3(-0.18f * w, 0.05f * h, -0.02f * h), v3(0.5f * w, 0.7f * h, 0.04f * h));
    for (int i = 0; i < 2; ++i)
        dmg_box(b, v3(0.28f * w, h * (0.25f * (float)i - 0.05f), -0.02f * h), v3(0.3f * w, 0.16f * h, 0.05f * h));
    dmg_hinge_style style = dmg_hinge_pick(b, 0.12f * t);
    float far = dmg_chance(b, 0.6f) ? 0.5f * DMG_PI : dmg_range(b, 1.2f, 2.2f);
    uint32_t keys = dmg_hinge(b, 0, "keyboard", v3(0, -0.5f * h, in), v3(1, 0, 0), 0.0f, far);
    dmg_box(b, v3(0, 0, 0.01f * t + 0.5f * t), v3(w, h, t));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* its keys look at the screen while it is shut */
    draw_key_field(b, 0.85f * w, 0.6f * h, 0.004f * h);
    dmg_restore(b);
    dmg_save(b);
    dmg_move(b, 0, -0.5f * h, in);
    dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI);
    if (dmg_chance(b, 0.6f) && style.kind != DMG_HINGE_STRAP) dmg_hinge_draw(b, &style, 0.9f * w, h, keys, 0);
    dmg_restore(b);
    if (dmg_chance(b, 0.7f)) dmg_rest(b, keys, fminf(far, 0.5f * DMG_PI) * dmg_range(b, 0.7f, 0.95f));
    dmg_use(b, 0);
    float span = w * dmg_range(b, 0.15f, 0.35f), wire = 0.03f * h, reach = h * dmg_range(b, 0.12f, 0.25f);
    if (dmg_chance(b, 0.7f)) dmg_hinge(b, 0, "handle", v3(0, 0.5f * h, -0.5f * deep), v3(1, 0, 0), -1.3f, 1.3f);
    const dmg_vec bail[] = {{-span, 0.5f * h + 0.5f * wire, -0.5f * deep},
                            {-span, 0.5f * h + reach, -0.5f * deep},
                            {span, 0.5f * h + reach, -0.5f * deep},
                            {span, 0.5f * h + 0.5f * wire, -0.5f * deep}};
    dmg_sweep(b, bail, 4, 0.5f * wire, wire, false);
    dmg_use(b, 0);
}

/* Draws two slabs on rails: the upper one slides off the keys, away from the player or to a side. */
static void draw_sliding_screen(dmg_builder* b, const screen* s, float base, int shape) {
    float rail = 0.25f * s->t, way = s->height * dmg_range(b, 0.35f, 0.6f);
    bool aside = dmg_chance(b, 0.3f);
    draw_half(b, shape, s->width, s->height, base);
    dmg_save(b);
    dmg_move(b, 0, base, -0.3f * s->height);
    draw_key_field(b, 0.85f * s->width, 0.4f * s->height, 0.5f * rail);
    dmg_restore(b);
    for (int i = -1; i <= 1; i += 2) {
        if (!aside)
            dmg_box(b, v3((float)i * 0.46f * s->width, base, -0.5f * s->height),
                    v3(0.02f * s->width, 2 * rail, 0.9f * s->height));
        if (aside)
            dmg_box(b, v3(0, base, s->height * (0.46f * (float)i - 0.5f)),
                    v3(0.9f * s->width, 2 * rail, 0.02f * s->height));
    }
    uint32_t top = dmg_slide(b, 0, "screen", aside ? v3(dmg_sign(b), 0, 0) : v3(0, 0, -1), 0.0f, way);
    dmg_move(b, 0, base + 1.05f * rail, 0);
    draw_half(b, shape, s->width, s->height, s->t);
    dmg_box(b, v3(0, s->t, -0.5f * s->height), v3(0.88f * s->width, 0.03f * s->t, 0.86f * s->height));
    if (dmg_chance(b, 0.4f)) dmg_rest(b, top, dmg_range(b, 0.0f, way));
    dmg_use(b, 0);
}

void dmg_build_convertible(dmg_builder* b) {
    static const float weights[] = {2, 1.5f, 1.5f, 1.5f, 1.5f, 1};
    int kind = dmg_weighted(b, weights, 6), shape = dmg_int(b, 0, 2);
    screen s = {.width = dmg_scale_range(b, 0.09f, 0.4f)};
    s.height = s.width * dmg_range(b, 0.5f, 0.85f);
    s.t = s.width * dmg_scale_range(b, 0.02f, 0.07f);
    float base = s.width * dmg_scale_range(b, 0.025f, 0.1f);
    if (kind < 3 || kind == 5) dmg_move(b, 0, 0, 0.5f * s.height);
    if (kind == 0) draw_two_lines(b, &s, base, shape);
    if (kind == 1) draw_turning_screen(b, &s, base, shape);
    if (kind == 2) draw_held_screen(b, &s, base, shape);
    if (kind == 3) draw_tablet(b, &s);
    if (kind == 4) draw_portable(b, &s);
    if (kind == 5) draw_sliding_screen(b, &s, base, shape);
}
