/* Draws stage and studio lights: a head that tilts in a yoke which pans below a clamp, on a stand, a base or the
 * floor; before its lens a frame that turns, with barn doors, a slide for colour or a hood. The beam goes to +Z. */
#include "core/build.h"
#include "parts/hardware.h"

typedef enum head_kind { HEAD_CAN, HEAD_BELL, HEAD_BOX, HEAD_TUBE, HEAD_PANEL, HEAD_ROBOT } head_kind;
typedef enum support { SUPPORT_CLAMP, SUPPORT_STAND, SUPPORT_BASE, SUPPORT_FLOOR } support;

typedef struct light {
    head_kind kind;
    support on;
    dmg_vec half;      /* of the head: z its reach to the front */
    float back;        /* its reach behind the pivot */
    float mouth;       /* half the width of the lens */
    float up;          /* -1: the yoke is below */
    float arm, strap;  /* of the yoke: its reach, half its width */
    float thick, play; /* of the strap, and between it and the head */
} light;

static light pick_light(dmg_builder* b) {
    light l = {.kind = (head_kind)dmg_weighted(b, (const float[]){3, 2, 2, 2, 2.5f, 2}, 6)};
    l.on = (support)dmg_weighted(b, (const float[]){3, 2.5f, 0.6f, 1.5f}, 4);
    if (l.kind == HEAD_ROBOT) l.on = SUPPORT_BASE;
    float r = dmg_scale_range(b, 0.05f, 0.25f), flat = dmg_range(b, 0.6f, 1.0f);
    bool square = l.kind == HEAD_PANEL, tube = l.kind == HEAD_TUBE;
    l.half = v3(r, square ? r * flat : r, r * dmg_range(b, 0.7f, 1.4f));
    l.back = r * dmg_range(b, 0.6f, 1.3f);
    if (square) l.half.z = r * dmg_range(b, 0.05f, 0.25f);
    if (square) l.back = r * dmg_range(b, 0.05f, 0.25f);
    if (tube) l.half.z = r * dmg_range(b, 1.6f, 3.0f);
    l.mouth = r * (square ? 0.85f : dmg_range(b, tube ? 0.5f : 0.75f, tube ? 0.75f : 0.92f));
    l.up = l.on == SUPPORT_CLAMP ? 1.0f : -1.0f;
    if (l.on == SUPPORT_BASE && dmg_chance(b, 0.3f)) l.up = 1.0f; /* hangs from the ceiling */
    l.arm = r * dmg_range(b, 1.15f, 2.2f);
    l.strap = r * dmg_range(b, 0.08f, l.kind == HEAD_ROBOT ? 0.5f : 0.25f);
    l.thick = r * dmg_range(b, 0.03f, l.kind == HEAD_ROBOT ? 0.35f : 0.1f);
    l.play = r * dmg_range(b, 0.01f, 0.08f);
    return l;
}

/* How far the head tilts before its top comes to the yoke's bar; `deep`: half of what it would run into, along Z. */
static float tilt_room(const light* l, float way, float deep) {
    float angle = 0.0f;
    for (; angle < 2.3f; angle += 0.05f) {
        for (int i = 0; i <= 8; ++i) {
            float share = (float)i / 8, z = (share * l->half.z - (1.0f - share) * l->back) * way;
            float y = z * sinf(angle) + l->half.y * cosf(angle), ahead = z * cosf(angle) - l->half.y * sinf(angle);
            if (y > l->arm - 2.0f * l->thick && fabsf(ahead) < deep) return fmaxf(angle - 0.1f, 0.08f);
        }
    }
    return angle;
}

/* ---- the head, about its pivot ---- */

static void draw_fins(dmg_builder* b, const light* l) {
    int fins = dmg_int(b, 3, 9);
    float reach = 0.9f * l->half.x, t = l->back * dmg_range(b, 0.02f, 0.05f);
    for (int i = 0; i < fins; ++i) {
        float z = -l->back * (0.3f + 0.65f * (float)i / (float)fins);
        dmg_box(b, v3(0, 0, z), v3(2 * reach, 1.5f * reach, t));
    }
}

static void draw_round_head(dmg_builder* b, const light* l) {
    float r = l->half.x, m = l->mouth, z = l->half.z, back = l->back, well = dmg_range(b, 0.05f, 0.5f) * z;
    float neck = l->kind == HEAD_BELL ? dmg_range(b, 0.35f, 0.6f) : dmg_range(b, 0.7f, 1.0f);
    float waist = l->kind == HEAD_BELL ? neck : 1.0f;
    const dmg_xy shell[] = {{0, -back},
                            {0.7f * neck * r, -back},
                            {neck * r, -0.8f * back},
                            {waist * r, 0},
                            {r, 0.5f * z},
                            {r, z},
                            {m, z},
                            {m, z - well},
                            {0.5f * m, z - 0.8f * well},
                            {0, z - 0.7f * well}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), shell, 10);
    if (l->kind == HEAD_BELL) /* the bolts reach its waist */
        dmg_rod(b, v3(-r, 0, 0), v3(r, 0, 0), 0.12f * r);
}

static void draw_box_head(dmg_builder* b, const light* l) {
    float r = l->half.x, m = l->mouth, z = l->half.z, body = l->kind == HEAD_TUBE ? 0.35f * z : 0.75f * z;
    float soft = dmg_range(b, 0.05f, 0.3f) * r, well = 0.15f * z;
    dmg_rounded_box(b, v3(0, 0, 0.5f * (body - l->back)), v3(2 * r, 2 * l->half.y, body + l->back), soft);
    const dmg_xy nose[] = {{0, 0.5f * body}, {1.08f * m, 0.5f * body}, {1.08f * m, z}, {m, z}, {m, z - well},
                           {0, z - well}};
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), nose, 6);
}

static void draw_head(dmg_builder* b, const light* l) {
    if (l->kind == HEAD_CAN || l->kind == HEAD_BELL) draw_round_head(b, l);
    if (l->kind == HEAD_BOX || l->kind == HEAD_TUBE) draw_box_head(b, l);
    if (l->kind == HEAD_ROBOT) {
        const dmg_xy egg[] = {{0, -l->back},
                              {0.5f * l->half.x, -0.95f * l->back},
                              {0.85f * l->half.x, -0.6f * l->back},
                              {l->half.x, 0},
                              {l->half.x, 0.5f * l->half.z},
                              {l->mouth, l->half.z},
                              {0.9f * l->mouth, 0.95f * l->half.z},
                              {0, 0.95f * l->half.z}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), egg, 8);
    }
    if (l->kind == HEAD_PANEL) {
        float deep = l->half.z + l->back;
        dmg_box(b, v3(0, 0, 0.5f * (l->half.z - l->back)), v3(2 * l->half.x, 2 * l->half.y, deep));
        dmg_box(b, v3(0, 0, l->half.z), v3(1.8f * l->half.x, 1.8f * l->half.y, 0.1f * deep));
        if (dmg_chance(b, 0.5f))
            dmg_rounded_box(b, v3(0, 0, -1.2f * l->back), v3(l->half.x, 0.8f * l->half.y, l->back), 0.1f * l->back);
    } else if (dmg_chance(b, 0.35f)) {
        draw_fins(b, l);
    }
}

/* ---- before the lens ---- */

/* Draws one leaf: its line is X through the origin, outwards +Y; drawn straight ahead, it folds in over the lens or
 * out. */
static uint32_t draw_leaf(dmg_builder* b, uint32_t carrier, const char* name, dmg_vec size, float taper, float rest) {
    float wide = size.x, reach = size.y, t = size.z, in = dmg_range(b, 1.0f, 1.5f), out = dmg_range(b, 0.8f, 2.2f);
    uint32_t leaf = dmg_hinge(b, carrier, name, v3(0, 0, 0), v3(-1, 0, 0), -in, out);
    dmg_rest(b, leaf, fminf(rest, out));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI);
    const dmg_xy plate[] = {{-wide, 0}, {wide, 0}, {taper * wide, reach}, {-taper * wide, reach}};
    dmg_extrude(b, plate, 4, -0.5f * t, 0.5f * t);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) dmg_rod(b, v3(-0.8f * wide, 0, 0), v3(0.8f * wide, 0, 0), 1.2f * t);
    return leaf;
}

/* Round a square of half sizes `x`, `y` on z = 0: two or four, those above and below often broader, with flaps. */
static void draw_barn_doors(dmg_builder* b, uint32_t carrier, float x, float y) {
    int count = dmg_chance(b, 0.85f) ? 4 : 2;
    float reach = dmg_range(b, 0.6f, 1.5f), taper = dmg_range(b, 0.6f, 1.35f), t = x * dmg_range(b, 0.015f, 0.05f),
          splay = dmg_range(b, -0.1f, 1.2f);
    bool flaps = dmg_chance(b, 0.2f), alike = dmg_chance(b, 0.5f);
    for (int i = 0; i < count; ++i) {
        int quarter = count == 2 ? 2 * i : i;
        bool side = quarter & 1;
        float wide = side ? y : x, at = side ? x : y;
        float rest = alike ? splay : dmg_range(b, -0.6f, 1.4f);
        dmg_use(b, carrier);
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)quarter);
        dmg_move(b, 0, at, 0);
        float own = side ? fminf(taper, 0.8f) : taper;
        uint32_t leaf = draw_leaf(b, carrier, "barn_door", v3(0.95f * wide, reach * at, t), own, rest);
        for (int s = -1; s <= 1 && flaps && !side; s += 2) { /* folded out at the leaf's own ends */
            float from = 0.5f * (1.0f + own) * 0.95f * wide, w = 0.4f * wide, z = 0.3f * reach * at;
            uint32_t flap = dmg_hinge(b, leaf, "flap", v3((float)s * from, 0, 0), v3(0, 0, (float)s), -1.5f, 1.5f);
            dmg_rest(b, flap, dmg_range(b, -0.4f, 1.2f));
            dmg_box(b, v3((float)s * (from + 0.5f * w), 0, z + 0.2f * reach * at), v3(w, t, 0.5f * reach * at));
        }
        dmg_restore(b);
    }
    dmg_use(b, carrier);
}

/* Draws a frame with a hole, on z = 0: it turns about the beam, or sits fast. Returns the part that carries the doors.
 */
static uint32_t draw_turning_frame(dmg_builder* b, uint32_t head, float x, float t, float mouth) {
    uint32_t frame = head;
    if (dmg_chance(b, 0.6f)) frame = dmg_spin(b, head, "frame", v3(0, 0, 0), v3(0, 0, 1));
    dmg_save(b);
    dmg_move(b, 0, 0, t);
    dmg_holed_plate_draw(b, 2 * x, 2 * x, t, 0.97f * mouth);
    dmg_restore(b);
    return frame;
}

/* In three channels on z = 0, open above: a filter that slides out, by a tab or by its rim. */
static void draw_colour_frame(dmg_builder* b, uint32_t head, float x, float t) {
    for (int s = -1; s <= 1; s += 2) dmg_box(b, v3((float)s * x, 0, 1.5f * t), v3(0.1f * x, 1.9f * x, 3 * t));
    dmg_box(b, v3(0, -x, 1.5f * t), v3(2.1f * x, 0.1f * x, 3 * t));
    dmg_slide(b, head, "colour_frame", v3(0, 1, 0), 0.0f, x * dmg_range(b, 0.9f, 1.9f));
    if (dmg_chance(b, 0.5f)) {
        dmg_save(b);
        dmg_move(b, 0, 0, 2 * t);
        dmg_holed_plate_draw(b, 1.85f * x, 1.85f * x, t, 0.8f * x);
        dmg_restore(b);
    } else {
        dmg_box(b, v3(0, 0, 1.5f * t), v3(1.85f * x, 1.85f * x, t));
    }
    if (dmg_chance(b, 0.6f)) dmg_box(b, v3(0, 1.05f * x, 1.5f * t), v3(0.4f * x, 0.25f * x, t));
    dmg_use(b, head);
}

static void draw_front(dmg_builder* b, const light* l, uint32_t head) {
    float t = 0.05f * l->half.x, x = l->half.x * dmg_range(b, 1.0f, 1.15f);
    int kind = dmg_weighted(b, (const float[]){5, 1.3f, 1, 1}, 4);
    dmg_save(b);
    dmg_move(b, 0, 0, l->half.z);
    if (l->kind == HEAD_PANEL) {
        if (kind < 3) draw_barn_doors(b, head, l->half.x, l->half.y);
    } else if (l->kind != HEAD_ROBOT) {
        if (kind == 0) {
            uint32_t frame = draw_turning_frame(b, head, x, t, l->mouth);
            dmg_move(b, 0, 0, t);
            draw_barn_doors(b, frame, x, x);
        }
        if (kind == 1) draw_colour_frame(b, head, 1.1f * l->mouth, t);
        if (kind == 2) { /* a hood, turned to its place or put on */
            const dmg_xy hood[] = {
                {l->mouth, 0}, {1.05f * l->mouth, 0}, {1.1f * l->mouth, x}, {l->mouth, x}, {l->mouth, 0}};
            dmg_slide(b, head, "hood", v3(0, 0, 1), 0.0f, x * dmg_range(b, 0.4f, 1.2f));
            dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), hood, 5);
        }
        if (kind == 3) { /* the lens in a door, hung at a side to change the lamp */
            float side = dmg_sign(b);
            dmg_hinge(b, head, "lens_door", v3(side * x, 0, 0.5f * t), v3(0, side, 0), 0.0f, dmg_range(b, 1.2f, 2.4f));
            dmg_rod(b, v3(0, 0, 0), v3(0, 0, t), x);
            dmg_ellipsoid(b, v3(0, 0, t), v3(0.8f * x, 0.8f * x, 0.3f * x));
            dmg_rod(b, v3(side * x, -0.2f * x, 0.5f * t), v3(side * x, 0.2f * x, 0.5f * t), 0.8f * t);
        }
    }
    dmg_restore(b);
    dmg_use(b, head);
}

/* ---- what the operator moves on the head ---- */

/* Draws a knob in a slot along the beam, below or at a side: it slides, to focus. */
static void draw_focus(dmg_builder* b, const light* l, uint32_t head) {
    float r = l->half.x, knob = r * dmg_range(b, 0.06f, 0.14f), z = l->kind == HEAD_TUBE ? 0.15f * l->half.z : 0.0f;
    float way = (l->kind == HEAD_TUBE ? 0.3f : 0.5f) * l->half.z, reach = l->kind == HEAD_BELL ? 0.6f * r : r;
    int count = l->kind == HEAD_TUBE ? dmg_int(b, 1, 2) : 1, kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* out of the underside: -Y becomes the frame's +Z */
    for (int i = 0; i < count; ++i) {
        float at = z + (float)i * 0.3f * l->half.z - 0.3f * way;
        dmg_box(b, v3(0, at, reach), v3(0.4f * knob, way + knob, 0.05f * knob));
        uint32_t part = dmg_slide(b, head, "focus", v3(0, 1, 0), -0.5f * way, 0.5f * way);
        dmg_save(b);
        dmg_move(b, 0, at, reach);
        dmg_rod(b, v3(0, 0, -0.5f * knob), v3(0, 0, 0.6f * knob), 0.3f * knob);
        dmg_move(b, 0, 0, 0.5f * knob);
        dmg_knob_draw(b, kind, knob, 1.2f * knob);
        dmg_restore(b);
        dmg_rest(b, part, way * dmg_range(b, -0.5f, 0.5f));
        dmg_use(b, head);
    }
    dmg_restore(b);
}

/* Draws four blades that are pushed in across the beam, each by its handle. */
static void draw_shutters(dmg_builder* b, const light* l, uint32_t head) {
    float r = l->half.x, z = l->kind == HEAD_TUBE ? 0.3f * l->half.z : 0.5f * l->half.z, t = 0.03f * r,
          way = r * dmg_range(b, 0.25f, 0.5f), out = r * dmg_range(b, 0.3f, 0.5f), wide = r * dmg_range(b, 0.2f, 0.5f);
    for (int i = 0; i < 4; ++i) {
        dmg_save(b);
        dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)i + 0.25f * DMG_PI * (l->kind == HEAD_CAN));
        uint32_t part = dmg_slide(b, head, "shutter", v3(0, -1, 0), 0.0f, way);
        dmg_box_span(b, v3(-wide, 0.5f * r, z), v3(wide, r + 0.4f * out, z + t));
        dmg_box(b, v3(0, r + 0.7f * out, z + 0.5f * t), v3(0.6f * wide, 0.6f * out, 3 * t));
        dmg_rest(b, part, way * dmg_range(b, 0.0f, 0.6f));
        dmg_restore(b);
        dmg_use(b, head);
    }
}

/* Knobs on the back, or a lid there for the lamp. */
static void draw_rear(dmg_builder* b, const light* l, uint32_t head) {
    float r = l->half.x, t = 0.06f * r;
    dmg_save(b);
    dmg_move(b, 0, 0, l->kind == HEAD_PANEL ? -1.7f * l->back : -l->back);
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    if (l->kind == HEAD_PANEL) {
        int knobs = dmg_int(b, 1, 3);
        dmg_knobs_draw(b, head, knobs, 0.3f * r, 0, r * dmg_range(b, 0.07f, 0.13f));
    } else {
        float w = r * dmg_range(b, 0.4f, 0.6f);
        dmg_hinge(b, head, "lamp_lid", v3(0, w, 0.5f * t), v3(-1, 0, 0), 0.0f, dmg_range(b, 1.2f, 2.2f));
        dmg_box_span(b, v3(-w, -w, 0), v3(w, w, t));
        dmg_rod(b, v3(-0.5f * w, w, 0.5f * t), v3(0.5f * w, w, 0.5f * t), 0.6f * t);
        dmg_rod(b, v3(0, -0.7f * w, t), v3(0, -0.7f * w, 3 * t), t);
    }
    dmg_restore(b);
    dmg_use(b, head);
}

/* ---- the yoke ---- */

static void draw_yoke(dmg_builder* b, const light* l) {
    float x = l->half.x + l->play, t = l->thick, over = l->up * l->arm, s = l->strap;
    int kind = l->kind == HEAD_ROBOT ? 3 : dmg_int(b, 0, 2);
    if (kind == 0) { /* a strap bent twice, in the plane across the beam */
        const dmg_xy line[] = {{-x - t, -0.6f * s}, {-x - t, l->arm - t}, {-x, l->arm},
                               {x, l->arm},         {x + t, l->arm - t},  {x + t, -0.6f * s}};
        dmg_save(b);
        if (l->up < 0) dmg_turn(b, v3(0, 0, 1), DMG_PI);
        dmg_bent_plate(b, line, 6, t, 2 * s);
        dmg_restore(b);
    } else if (kind == 1) { /* tube */
        const dmg_vec path[] = {v3(-x - 1.5f * t, 0, 0), v3(-x - 1.5f * t, 0.75f * over, 0), v3(-0.75f * x, over, 0),
                                v3(0.75f * x, over, 0),  v3(x + 1.5f * t, 0.75f * over, 0),  v3(x + 1.5f * t, 0, 0)};
        dmg_sweep(b, path, 6, t, t, false);
    } else { /* arms and a bar, thick ones on robots */
        for (int i = -1; i <= 1; i += 2) {
            dmg_vec centre = v3((float)i * (x + 0.5f * t), 0.5f * (over - l->up * s), 0);
            dmg_rounded_box(b, centre, v3(t, l->arm + s, 2 * s), kind == 3 ? 0.3f * t : 0.05f * t);
        }
        dmg_box(b, v3(0, over, 0), v3(2 * x + 2 * t, t, 2 * s));
    }
    for (int i = -1; i <= 1; i += 2)
        dmg_rod(b, v3((float)i * (x - l->play), 0, 0), v3((float)i * (x + 2.2f * t), 0, 0), 0.5f * fminf(s, l->half.y));
}

/* At the bolts, outside the straps: knobs that clamp the tilt. */
static void draw_locks(dmg_builder* b, const light* l, uint32_t yoke) {
    float r = l->half.x * dmg_range(b, 0.08f, 0.2f), x = l->half.x + l->play + 2.2f * l->thick;
    int kind = dmg_int(b, 0, DMG_KNOB_KINDS - 1);
    bool both = dmg_chance(b, 0.5f), lever = dmg_chance(b, 0.3f), screw = dmg_chance(b, 0.4f);
    for (int s = both ? -1 : 1; s <= 1; s += 2) {
        dmg_save(b);
        dmg_move(b, (float)s * x, 0, 0);
        dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI * (float)s);
        if (screw)
            dmg_screw(b, yoke, "tilt_lock", v3(0, 0, 0), v3(0, 0, -1), -0.03f * r, 0.0f, 6.0f);
        else
            dmg_spin(b, yoke, "tilt_lock", v3(0, 0, 0), v3(0, 0, 1));
        if (lever) {
            dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.6f * r), 0.6f * r);
            dmg_beam(b, v3(0, 0, 0.4f * r), v3(0, 2.5f * r, 0.9f * r), 0.5f * r, 0.4f * r);
        } else {
            dmg_knob_draw(b, kind, r, r);
        }
        dmg_restore(b);
        dmg_use(b, yoke);
    }
}

/* ---- what it stands on or hangs from; the yoke's bar is at y = `bar` ---- */

/* Draws a hook or a half coupler over a pipe along X, its wing screw below or before. */
static void draw_clamp(dmg_builder* b, const light* l, float bar) {
    float r = l->half.x, pipe = r * dmg_range(b, 0.14f, 0.3f), wide = pipe * dmg_range(b, 0.6f, 1.6f),
          y = bar + l->thick + pipe * dmg_range(b, 1.8f, 3.0f), reach = r * dmg_range(b, 1.5f, 4.0f);
    enum { ARC = 9 };
    if (dmg_chance(b, 0.8f)) dmg_rod(b, v3(-reach, y, 0), v3(reach, y, 0), pipe);
    dmg_xy hook[ARC];
    for (int i = 0; i < ARC; ++i) { /* in (z, y): from before the pipe over it to behind */
        float angle = 1.25f * DMG_PI * (float)i / (ARC - 1) - 0.1f * DMG_PI;
        hook[i] = (dmg_xy){1.3f * pipe * cosf(angle), 1.3f * pipe * sinf(angle)};
    }
    dmg_save(b);
    dmg_move(b, 0, y, 0);
    dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
    dmg_bent_plate(b, hook, ARC, 0.4f * pipe, wide);
    dmg_restore(b);
    dmg_box_span(b, v3(-0.5f * wide, bar + 0.5f * l->thick, -1.5f * pipe), v3(0.5f * wide, y - pipe, -0.6f * pipe));
    dmg_box_span(b, v3(-0.5f * wide, bar + 0.5f * l->thick, -1.5f * pipe),
                 v3(0.5f * wide, bar + 0.5f * l->thick + 0.5f * pipe, 0.6f * pipe));
    float screw = pipe * dmg_range(b, 0.15f, 0.3f), long_ = pipe * dmg_range(b, 1.0f, 2.0f), z = 1.3f * pipe;
    dmg_screw(b, 0, "clamp_screw", v3(0, y, z), v3(0, 0, 1), 0.1f * screw, 0.0f, dmg_range(b, 6.0f, 25.0f));
    dmg_rod(b, v3(0, y, z - 0.3f * pipe), v3(0, y, z + long_), screw);
    dmg_box(b, v3(0, y, z + long_), v3(6 * screw, 2 * screw, screw));
    dmg_use(b, 0);
}

/* Draws a tripod or a round foot, and in some a tube drawn out of another. Returns the part that carries the yoke. */
static uint32_t draw_stand(dmg_builder* b, const light* l, float bar) {
    float r = l->half.x, tall = r * dmg_range(b, 2.5f, 9.0f), tube = r * dmg_range(b, 0.05f, 0.14f), foot = bar - tall;
    int legs = dmg_chance(b, 0.75f) ? dmg_int(b, 3, 4) : 0;
    float collar = foot + tall * dmg_range(b, 0.2f, 0.4f), spread = tall * dmg_range(b, 0.3f, 0.5f);
    if (legs == 0) dmg_cone(b, v3(0, foot, 0), v3(0, foot + 0.5f * tube, 0), r, 0.9f * r);
    bool fold = legs > 0 && dmg_chance(b, 0.5f);
    float mid = foot + tall * dmg_range(b, 0.55f, 0.75f);
    dmg_rod(b, v3(0, legs ? foot + 0.1f * tall : foot, 0), v3(0, mid, 0), tube);
    dmg_rod(b, v3(0, mid - 2 * tube, 0), v3(0, mid + tube, 0), 1.5f * tube);
    if (legs) dmg_rod(b, v3(0, collar - 2 * tube, 0), v3(0, collar + tube, 0), 1.8f * tube);
    for (int i = 0; i < legs; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, legs);
        dmg_vec from = v3(0, collar, 1.8f * tube), to = v3(0, foot, spread);
        if (fold) /* up and in against the tube's lower end */
            dmg_hinge(b, 0, "leg", from, v3(1, 0, 0), 0.0f, 0.85f * atan2f(spread - 1.8f * tube, collar - foot));
        dmg_rod(b, from, to, 0.7f * tube);
        dmg_ellipsoid(b, to, v3(tube, tube, tube));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    uint32_t pole = 0;
    float way = 0.6f * (mid - foot);
    if (dmg_chance(b, 0.6f)) pole = dmg_slide(b, 0, "pole", v3(0, 1, 0), 0.0f, way);
    dmg_rod(b, v3(0, pole ? mid - way - 0.1f * tall : mid, 0), v3(0, bar - 0.4f * l->thick, 0), 0.8f * tube);
    dmg_use(b, 0);
    if (dmg_chance(b, 0.5f)) {
        dmg_spin(b, 0, "pole_lock", v3(0, mid, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, mid - 0.5f * tube, tube), v3(0, mid - 0.5f * tube, 3 * tube), 0.5f * tube);
        dmg_box(b, v3(0, mid - 0.5f * tube, 3.2f * tube), v3(3 * tube, tube, 0.6f * tube));
        dmg_use(b, 0);
    }
    return pole;
}

static void draw_base(dmg_builder* b, const light* l, float bar) {
    float w = l->half.x * dmg_range(b, 1.0f, 1.7f), d = w * dmg_range(b, 0.8f, 1.1f),
          h = l->half.x * dmg_range(b, 0.4f, 1.0f), y = bar + l->up * (0.55f * l->thick + 0.5f * h);
    if (dmg_chance(b, 0.7f))
        dmg_rounded_box(b, v3(0, y, 0), v3(2 * w, h, 2 * d), 0.15f * h);
    else
        dmg_rod(b, v3(0, y - 0.5f * h, 0), v3(0, y + 0.5f * h, 0), w);
    dmg_rod(b, v3(0, bar, 0), v3(0, y, 0), 0.5f * w);
    if (!dmg_chance(b, 0.6f)) return;
    for (int s = -1; s <= 1; s += 2) { /* carrying handles, folded up or fixed */
        float x = (float)s * w * 1.03f;
        if (dmg_chance(b, 0.6f))
            dmg_hinge(b, 0, "handle", v3(x, y, 0), v3(0, 0, (float)s), 0.0f, dmg_range(b, 0.8f, 1.4f));
        const dmg_vec bow[] = {v3(x, y, -0.5f * d), v3(x, y - 0.35f * h, -0.4f * d), v3(x, y - 0.35f * h, 0.4f * d),
                               v3(x, y, 0.5f * d)};
        dmg_sweep(b, bow, 4, 0.04f * w, 0.04f * w, false);
        dmg_use(b, 0);
    }
}

/* Draws a second strap about the same bolts: the two spread on the floor. */
static void draw_second_strap(dmg_builder* b, const light* l) {
    light outer = *l;
    outer.play = l->play + 2.5f * l->thick;
    outer.arm = l->arm * 1.02f;
    dmg_hinge(b, 0, "strap", v3(0, 0, 0), v3(-1, 0, 0), -0.2f, 1.2f);
    dmg_rest(b, b->part, dmg_range(b, 0.0f, 1.0f));
    draw_yoke(b, &outer);
    dmg_use(b, 0);
}

/* Draws the yoke and what it turns on. Returns its part. */
static uint32_t draw_carrier(dmg_builder* b, const light* l) {
    float bar = l->up * l->arm, sweep = dmg_range(b, 1.2f, 4.7f);
    uint32_t yoke = 0;
    if (l->on == SUPPORT_CLAMP) draw_clamp(b, l, bar);
    if (l->on == SUPPORT_STAND) yoke = draw_stand(b, l, bar);
    if (l->on == SUPPORT_BASE) draw_base(b, l, bar);
    if (l->on == SUPPORT_FLOOR) {
        if (dmg_chance(b, 0.4f)) draw_second_strap(b, l);
    } else if (dmg_chance(b, 0.8f)) {
        if (dmg_chance(b, 0.5f))
            yoke = dmg_spin(b, yoke, "yoke", v3(0, 0, 0), v3(0, 1, 0));
        else
            yoke = dmg_hinge(b, yoke, "yoke", v3(0, 0, 0), v3(0, 1, 0), -0.5f * sweep, 0.5f * sweep);
    }
    dmg_use(b, yoke);
    draw_yoke(b, l);
    return yoke;
}

void dmg_build_stage_light(dmg_builder* b) {
    light l = pick_light(b);
    dmg_move(b, 0, l.on == SUPPORT_STAND ? 5.0f * l.half.x : l.arm, 0);
    uint32_t yoke = draw_carrier(b, &l);
    if (l.kind != HEAD_ROBOT && dmg_chance(b, 0.6f)) draw_locks(b, &l, yoke);
    float deep = l.on == SUPPORT_BASE ? 2.0f * l.half.x : 1.2f * l.strap + l.thick;
    /* Its front goes up for a positive angle about -X. */
    float up = tilt_room(&l, l.up, deep), down = tilt_room(&l, -l.up, deep);
    uint32_t head = dmg_hinge(b, yoke, "head", v3(0, 0, 0), v3(-1, 0, 0), -down, up);
    dmg_rest(b, head, fmaxf(-down, fminf(up, dmg_range(b, -1.0f, 0.6f))));
    draw_head(b, &l);
    draw_front(b, &l, head);
    if (l.kind == HEAD_TUBE ? dmg_chance(b, 0.8f) : l.kind < HEAD_PANEL && dmg_chance(b, 0.4f)) draw_focus(b, &l, head);
    if (l.kind == HEAD_TUBE && dmg_chance(b, 0.6f)) draw_shutters(b, &l, head);
    if (l.kind != HEAD_ROBOT && dmg_chance(b, 0.5f)) draw_rear(b, &l, head);
    dmg_use(b, 0);
}
