/* Draws cases of two halves with handles and latches, pails, and boxes with a lid that grips over their rim. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- hard cases ---- */

typedef struct half {
    float width, height, depth, wall;
    int kind; /* boards, a solid, rounded all over, rounded in outline, an open sheet, a bevelled shell */
} half;

/* Draws a bevelled or bowed shell: an outline that shrinks towards its back. Opening at z = 0, back at z = -depth. */
static void draw_bevelled(dmg_builder* b, const half* h) {
    float shrink = dmg_range(b, 0.6f, 0.95f), round = dmg_range(b, 0.3f, 0.9f) * h->depth, x = 0.5f * h->width,
          y = 0.5f * h->height;
    const dmg_xy outline[] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    const dmg_row rows[] = {{1, 1, 0, 0}, {1, 1, 0, h->depth - round}, {shrink, shrink, 0, h->depth}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_loft(b, outline, 4, rows, 3);
    dmg_restore(b);
}

static void draw_half(dmg_builder* b, const half* h) {
    dmg_vec centre = {0, 0, -0.5f * h->depth}, size = {h->width, h->height, h->depth};
    switch (h->kind) {
    case 0:
        dmg_case_draw(b, DMG_CASE_BOARDS, h->width, h->height, h->depth, h->wall);
        break;
    case 1:
        dmg_box(b, centre, size);
        break;
    case 2:
        dmg_rounded_box(b, centre, size, 0.4f * h->depth);
        break;
    case 3:
        dmg_rounded_plate(b, h->width, h->height, h->depth, 0.08f * h->width);
        break;
    case 4:
        dmg_box_faces(b, centre, size, DMG_FACE_ALL & ~DMG_FACE_FRONT);
        break;
    default:
        draw_bevelled(b, h);
        break;
    }
    int ribs = dmg_chance(b, 0.3f) ? dmg_int(b, 1, 5) : 0;
    for (int i = 0; i < ribs; ++i) /* straps or ridges outside */
        dmg_box(b, v3(h->width * (((float)i + 0.5f) / (float)ribs - 0.5f), 0, -h->depth),
                v3(0.04f * h->width, 0.8f * h->height, 0.06f * h->depth));
}

/* Draws what lies in an open half: a tray, straps, things. */
static void draw_contents(dmg_builder* b, const half* h) {
    int kind = dmg_int(b, 0, 3);
    float w = 0.85f * h->width, t = 0.85f * h->height;
    if (kind == 1) dmg_box(b, v3(0, 0, -0.3f * h->depth), v3(w, t, 0.05f * h->depth));
    for (int i = -1; i <= 1 && kind == 2; i += 2)
        dmg_box(b, v3((float)i * 0.25f * w, 0, -0.15f * h->depth), v3(0.06f * w, t, 0.04f * h->depth));
    for (int i = 0; i < 3 && kind == 3; ++i) {
        float y = t * (((float)i + 0.5f) / 3.0f - 0.5f);
        dmg_box(b, v3(0, y, -0.1f * h->depth), v3(0.8f * w, 0.05f * t, 0.05f * h->depth));
    }
}

/* From the seam at the hung side's outer face (y up into the case, z out of the body half) to the line. */
static dmg_xy pick_seam_line(dmg_builder* b, const half* front) {
    static const float habits[] = {3, 2, 3, 2};
    float share = dmg_range(b, 0.0f, 1.0f), side = dmg_range(b, -1.0f, 1.0f);
    switch (dmg_weighted(b, habits, 4)) {
    case 0: /* the seam, at the outer face */
        return (dmg_xy){0, 0};
    case 1: /* in knuckles outside */
        return (dmg_xy){-share * 0.12f * front->depth, 0.1f * side * front->depth};
    case 2: /* behind the wall */
        return (dmg_xy){share * 0.05f * front->height, 0};
    default: /* aside of the seam, in the wall of one half */
        return (dmg_xy){share * 0.02f * front->height, 0.15f * side * front->depth};
    }
}

/* Draws a handle between two lugs at y = 0, its line along X through the lugs' middle; upright at rest. */
static void draw_lug_handle(dmg_builder* b, float width, float depth) {
    float length = width * dmg_range(b, 0.15f, 0.45f), bar = width * dmg_range(b, 0.012f, 0.04f),
          rise = length * dmg_range(b, 0.15f, 0.45f), up = bar * dmg_range(b, 0.3f, 1.2f);
    int kind = dmg_int(b, 0, 2), lugs = dmg_int(b, 0, 2);
    float lug = bar * dmg_range(b, 0.9f, 2.0f), x = 0.5f * length;
    for (int s = -1; s <= 1 && lugs > 0; s += 2) {
        float at = (float)s * (x + (lugs == 1 ? 0.5f * (lug + bar) : 0.0f));
        if (lugs == 1) dmg_box(b, v3(at, 0.5f * lug, 0), v3(lug, 1.2f * lug, fminf(1.5f * lug, depth)));
        if (lugs == 2) dmg_rod(b, v3(at - 0.6f * lug, up, 0), v3(at + 0.6f * lug, up, 0), 0.6f * lug);
    }
    float back = dmg_range(b, 1.2f, 1.57f), ahead = dmg_chance(b, 0.5f) ? back : 0.0f;
    uint32_t part = dmg_hinge(b, 0, "handle", v3(0, up, 0), v3(1, 0, 0), -back, ahead);
    if (kind == 0) { /* three bars */
        for (int s = -1; s <= 1; s += 2)
            dmg_box_span(b, v3((float)s * x - 0.5f * bar, up - 0.4f * bar, -0.4f * bar),
                         v3((float)s * x + 0.5f * bar, up + rise, 0.4f * bar));
        dmg_box(b, v3(0, up + rise, 0), v3(length + bar, bar, 1.2f * bar));
    } else { /* one bent rod, round or flat */
        enum { POINTS = 11 };
        dmg_vec path[POINTS];
        float power = dmg_range(b, 0.25f, 1.0f);
        for (int i = 0; i < POINTS; ++i) {
            float angle = DMG_PI * (float)i / (POINTS - 1), c = cosf(angle);
            path[i] = v3(-x * copysignf(powf(fabsf(c), power), c), up + rise * powf(fabsf(sinf(angle)), power), 0);
        }
        dmg_sweep(b, path, POINTS, 0.5f * bar, kind == 1 ? 0.5f * bar : bar, false);
    }
    int rest = dmg_int(b, 0, 2);
    if (rest == 1) dmg_rest(b, part, -back);
    if (rest == 2) dmg_rest(b, part, dmg_range(b, -back, ahead));
    dmg_use(b, 0);
}

/* Draws a latch over the seam on the side that opens, hung on the body half or on the other one. */
static void draw_latch(dmg_builder* b, float x, float width, float depth, uint32_t carrier) {
    float t = width * dmg_range(b, 0.01f, 0.03f), w = width * dmg_range(b, 0.04f, 0.14f),
          d = depth * dmg_range(b, 0.25f, 0.6f), s = carrier ? 1.0f : -1.0f;
    dmg_hinge(b, carrier, "latch", v3(x, 0.5f * t, s * 0.5f * d), v3(s, 0, 0), 0.0f, dmg_range(b, 1.0f, 2.2f));
    dmg_box(b, v3(x, 0.55f * t, 0), v3(w, t, d));
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(x - 0.6f * w, 0.6f * t, s * 0.5f * d), v3(x + 0.6f * w, 0.6f * t, s * 0.5f * d), 0.6f * t);
    dmg_use(b, 0);
}

static void draw_knuckles(dmg_builder* b, const half* h, dmg_xy line, uint32_t lid) {
    float radius = h->width * dmg_range(b, 0.006f, 0.025f), length = h->width * dmg_range(b, 0.05f, 0.2f);
    for (int s = -1; s <= 1; s += 2) {
        float x = (float)s * 0.33f * h->width;
        dmg_use(b, 0);
        dmg_rod(b, v3(x - 0.5f * length, line.x - 0.5f * h->height, line.y), v3(x, line.x - 0.5f * h->height, line.y),
                radius);
        dmg_use(b, lid);
        dmg_rod(b, v3(x, line.x - 0.5f * h->height, line.y), v3(x + 0.5f * length, line.x - 0.5f * h->height, line.y),
                radius);
    }
}

void dmg_build_hard_case(dmg_builder* b) {
    half body = {.width = dmg_scale_range(b, 0.25f, 0.9f), .kind = dmg_int(b, 0, 5)};
    body.height = body.width * dmg_scale_range(b, 0.45f, 1.3f);
    float depth = body.width * dmg_range(b, 0.1f, 0.45f), share = dmg_range(b, 0.3f, 0.9f);
    body.depth = depth * share;
    body.wall = depth * dmg_range(b, 0.02f, 0.08f);
    half lid = body;
    lid.depth = depth - body.depth;
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0, body.depth, 0);
        dmg_face_up(b);
    } else {
        dmg_move(b, 0, 0.5f * body.height, 0);
    }
    draw_half(b, &body);
    if (body.kind == 0 || body.kind == 4) draw_contents(b, &body);
    dmg_xy line = pick_seam_line(b, &lid);
    float far = dmg_range(b, 1.5f, 3.0f);
    uint32_t part = dmg_hinge(b, 0, "lid", v3(0, line.x - 0.5f * body.height, line.y), v3(1, 0, 0), 0.0f, far);
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    draw_half(b, &lid);
    if (body.kind == 0 || body.kind == 4) draw_contents(b, &lid);
    dmg_restore(b);
    if (line.x <= 0.0f && dmg_chance(b, 0.7f)) draw_knuckles(b, &body, line, part);
    if (dmg_chance(b, 0.55f)) dmg_rest(b, part, fminf(dmg_range(b, 1.2f, 2.7f), far));
    dmg_use(b, 0);
    dmg_move(b, 0, 0.5f * body.height, 0);
    int latches = dmg_int(b, 0, 2);
    uint32_t carrier = dmg_chance(b, 0.5f) ? part : 0;
    for (int i = 0; i < latches; ++i)
        draw_latch(b, latches == 1 ? 0.0f : ((float)i - 0.5f) * 0.6f * body.width, body.width,
                   fminf(lid.depth, body.depth), carrier);
    dmg_move(b, 0, 0, -0.5f * fminf(body.depth, depth * dmg_range(b, 0.3f, 1.0f)));
    if (dmg_chance(b, 0.8f)) draw_lug_handle(b, body.width, body.depth);
}

/* ---- pails ---- */

/* How a bail meets the pail: its wire's end goes through a lug, is curled about a pin, or ends in a disc. */
static void draw_bail_end(dmg_builder* b, int kind, float x, float s, float wire) {
    if (kind == 0) dmg_rod(b, v3(x - s * 4 * wire, 0, 0), v3(x + s * wire, 0, 0), wire);
    if (kind == 1) dmg_torus(b, v3(x, 0, 0), v3(1, 0, 0), 2.5f * wire, wire);
    if (kind == 2) dmg_rod(b, v3(x - s * wire, 0, 0), v3(x + s * wire, 0, 0), 3.5f * wire);
}

static void draw_lugs(dmg_builder* b, int kind, float x, float s, float wire) {
    if (kind == 1) dmg_box(b, v3(x - s * 2 * wire, 0, 0), v3(3 * wire, 7 * wire, 7 * wire));
    if (kind == 2) dmg_rod(b, v3(x - s * 4 * wire, 0, 0), v3(x, 0, 0), 3 * wire);
    if (kind == 3) { /* a plate that stands over the rim */
        dmg_box(b, v3(x - s * wire, 2.5f * wire, 0), v3(wire, 9 * wire, 6 * wire));
        dmg_rod(b, v3(x - s * 2 * wire, 0, 0), v3(x + s * 1.5f * wire, 0, 0), 1.3f * wire);
    }
}

static float draw_pail_body(dmg_builder* b, float radius, float height, float wire) {
    float foot = radius * dmg_range(b, 0.6f, 1.0f), wall = radius * dmg_range(b, 0.01f, 0.05f);
    const dmg_xy thin[] = {{0, 0}, {foot, 0}, {radius, height}};
    const dmg_xy thick[] = {{0, 0},   {foot, 0}, {radius, height}, {radius - wall, height}, {foot - wall, wall},
                            {0, wall}};
    if (dmg_chance(b, 0.4f))
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thin, 3);
    else
        dmg_lathe(b, v3(0, 0, 0), v3(0, 1, 0), thick, 6);
    int hoops = dmg_int(b, 0, 3);
    for (int i = 0; i < hoops; ++i) {
        float at = 1.0f - 0.07f * (float)i * dmg_range(b, 0.8f, 1.5f);
        dmg_torus(b, v3(0, at * height, 0), v3(0, 1, 0), foot + (radius - foot) * at, fminf(wire, wall));
    }
    return foot;
}

/* A bucket whose bail hangs down, stands up or leans, on lugs below, at or above its rim. */
void dmg_build_pail(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.06f, 0.22f), height = radius * dmg_scale_range(b, 0.9f, 2.8f),
          wire = radius * dmg_scale_range(b, 0.012f, 0.05f);
    float foot = draw_pail_body(b, radius, height, wire),
          level = dmg_chance(b, 0.4f) ? dmg_range(b, 0.97f, 1.04f) : dmg_range(b, 0.75f, 0.97f);
    float y = level * height, x = foot + (radius - foot) * fminf(level, 1.0f) + 2.5f * wire;
    int lugs = dmg_int(b, 0, 3), end = dmg_int(b, 0, 2);
    dmg_move(b, 0, y, 0);
    for (int s = -1; s <= 1; s += 2) draw_lugs(b, lugs, (float)s * x, (float)s, wire);
    /* Where it hangs down it rests on the pail's side: as wide as the wire's way over the rim needs. */
    float rise = x * dmg_range(b, 0.85f, 1.5f), wide = x * dmg_range(b, 1.0f, 1.12f);
    float far = y > rise + 0.05f * height && rise > radius ? dmg_range(b, 2.0f, 2.6f) : dmg_range(b, 1.4f, 1.8f);
    uint32_t bail = dmg_hinge(b, 0, "handle", v3(0, 0, 0), v3(1, 0, 0), -far, far);
    enum { POINTS = 15 };
    dmg_vec path[POINTS];
    float power = dmg_range(b, 0.4f, 1.0f);
    for (int i = 0; i < POINTS; ++i) {
        float angle = DMG_PI * (float)i / (POINTS - 1), c = cosf(angle), s = fabsf(sinf(angle));
        float bulge = x + (wide - x) * sinf(fminf(2.0f * angle, DMG_PI));
        path[i] = v3(-bulge * copysignf(powf(fabsf(c), power), c), rise * powf(s, power), 0);
    }
    dmg_sweep(b, path, POINTS, wire, wire, false);
    for (int s = -1; s <= 1; s += 2) draw_bail_end(b, end, (float)s * x, (float)s, wire);
    if (dmg_chance(b, 0.5f))
        dmg_rod(b, v3(-0.25f * x, rise, 0), v3(0.25f * x, rise, 0), dmg_range(b, 1.5f, 4.0f) * wire);
    if (dmg_chance(b, 0.8f)) dmg_rest(b, bail, dmg_sign(b) * dmg_range(b, 0.6f, 1.0f) * far);
    dmg_use(b, 0);
}

/* ---- bins and tubs with a lid over their rim ---- */

/* A lid whose edge goes down over the box by `skirt`, its hinge at the skirt's rear lower corner, at its middle height,
 * at the box's own rim or in a lug behind. */
void dmg_build_lidded_bin(dmg_builder* b) {
    float width = dmg_scale_range(b, 0.2f, 0.8f), depth = width * dmg_range(b, 0.6f, 1.3f),
          height = width * dmg_scale_range(b, 0.5f, 2.2f), over = width * dmg_range(b, 0.0f, 0.08f),
          t = width * dmg_scale_range(b, 0.012f, 0.12f);
    float rise = dmg_chance(b, 0.5f) ? 0.0f : t * dmg_range(b, 0.3f, 2.0f),
          taper = dmg_chance(b, 0.5f) ? dmg_range(b, 0.75f, 0.98f) : 1.0f;
    const dmg_xy outline[] = {{-0.5f * width, -0.5f * depth},
                              {0.5f * width, -0.5f * depth},
                              {0.5f * width, 0.5f * depth},
                              {-0.5f * width, 0.5f * depth}};
    const dmg_row rows[] = {{taper, taper, 0, 0}, {1, 1, 0, height}};
    dmg_save(b);
    dmg_face_up(b);
    dmg_loft(b, outline, 4, rows, 2);
    dmg_restore(b);
    float back = -0.5f * depth - over, share = dmg_range(b, 0.0f, 1.0f);
    static const float habits[] = {3, 2, 2, 2};
    dmg_xy line = {back, height};
    int habit = dmg_weighted(b, habits, 4);
    if (habit == 1) line.y += 0.5f * t;
    if (habit == 2) line.x = -0.5f * depth;
    if (habit == 3) line = (dmg_xy){back - share * 0.04f * depth, height + (share - 0.5f) * t};
    if (habit == 3) dmg_box(b, v3(0, line.y - 0.5f * t, line.x), v3(0.4f * width, t, 0.05f * depth));
    uint32_t lid = dmg_hinge(b, 0, "lid", v3(0, line.y, line.x), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
    float w = width + 2 * over, d = depth + 2 * over;
    const dmg_xy profile[] = {{-0.5f * d, 0}, {0.5f * d, 0}, {0.5f * d, t + rise}, {-0.5f * d, t}};
    dmg_save(b);
    dmg_move(b, 0, height + 0.0005f, 0);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* the profile's x runs to the back */
    if (dmg_chance(b, 0.5f))
        dmg_extrude(b, profile, 4, -0.5f * w, 0.5f * w);
    else
        dmg_box(b, v3(0, 0.5f * t, 0), v3(d, t, w));
    dmg_restore(b);
    if (dmg_chance(b, 0.3f)) dmg_box(b, v3(0, height + t, 0.5f * d), v3(0.3f * w, 0.4f * t, 0.06f * d));
    dmg_use(b, 0);
    if (dmg_chance(b, 0.3f)) dmg_rest(b, lid, dmg_range(b, 0.2f, 1.2f));
    if (!dmg_chance(b, 0.5f)) return; /* a pedal or a drawer's mouth at the foot of the front */
    float out = depth * dmg_range(b, 0.05f, 0.15f);
    dmg_hinge(b, 0, "pedal", v3(0, 0.06f * height, 0.5f * taper * depth), v3(1, 0, 0), 0.0f, 0.3f);
    dmg_box(b, v3(0, 0.06f * height, 0.5f * taper * depth + 0.5f * out), v3(0.25f * width, 0.02f * height, out));
    dmg_use(b, 0);
}

/* ---- a flag on the side of a box or post ---- */

/* Draws an arm with a plate at its end, flat in the plane x = 0, its pivot near the arm's root at the origin. */
static void draw_flag(dmg_builder* b, float length, float wide, float t) {
    float root = wide * (dmg_chance(b, 0.6f) ? 0.5f : dmg_range(b, 0.0f, 1.5f)),
          plate = length * dmg_range(b, 0.15f, 0.5f), drop = wide * dmg_range(b, 0.0f, 3.0f), end = length - root;
    const dmg_xy outline[] = {
        {-root, -0.5f * wide},      {end - plate, -0.5f * wide}, {end - plate, -0.5f * wide - drop},
        {end, -0.5f * wide - drop}, {end, 0.5f * wide},          {-root, 0.5f * wide}};
    bool round = dmg_chance(b, 0.3f), straight = drop < 0.2f * wide;
    const dmg_xy bar[] = {{-root, -0.5f * wide}, {end, -0.5f * wide}, {end, 0.5f * wide}, {-root, 0.5f * wide}};
    dmg_save(b);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x along Z, the thickness along -X */
    dmg_extrude(b, straight ? bar : outline, straight ? 4 : 6, -0.5f * t, 0.5f * t);
    dmg_restore(b);
    if (round) dmg_rod(b, v3(-0.5f * t, 0, 0), v3(0.5f * t, 0, 0), 0.6f * wide);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(-1.2f * t, 0, 0), v3(1.2f * t, 0, 0), 0.2f * wide);
}

void dmg_build_flag_box(dmg_builder* b) {
    float height = dmg_scale_range(b, 0.15f, 0.6f), width = height * dmg_scale_range(b, 0.2f, 1.5f),
          depth = height * dmg_scale_range(b, 0.2f, 1.8f),
          post = dmg_chance(b, 0.4f) ? dmg_range(b, 0.3f, 2.0f) * height : 0.0f;
    float length = fmaxf(height, depth) * dmg_range(b, 0.3f, 0.9f), wide = length * dmg_range(b, 0.05f, 0.25f),
          t = length * dmg_scale_range(b, 0.015f, 0.12f),
          gap = dmg_chance(b, 0.6f) ? 0.02f * t : dmg_range(b, 0.0f, 0.08f) * width;
    if (post > 0.0f) dmg_box(b, v3(0, 0.5f * post, 0), v3(0.3f * width, post, 0.3f * width));
    dmg_box(b, v3(0, post + 0.5f * height, 0), v3(width, height, depth));
    if (dmg_chance(b, 0.5f))
        dmg_box(b, v3(0, post + height, 0.04f * depth), v3(1.1f * width, 0.06f * height, 1.1f * depth));
    const float z = dmg_range(b, -0.4f, 0.1f) * depth, y = post + dmg_range(b, 0.3f, 0.9f) * height;
    dmg_move(b, 0.5f * width + gap + 0.5f * t, y, z);
    if (gap > 0.5f * t) dmg_rod(b, v3(-gap - 0.5f * t, 0, 0), v3(-0.5f * t, 0, 0), 0.3f * wide);
    uint32_t flag = dmg_hinge(b, 0, "flag", v3(0, 0, 0), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.0f, 1.7f));
    draw_flag(b, length, wide, t);
    if (dmg_chance(b, 0.5f)) dmg_rest(b, flag, b->parts[flag - 1].joint.upper);
    dmg_use(b, 0);
}
