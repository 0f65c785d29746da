/* Draws controllers after real products: a tilted head on a handle, with or without a ring; wands; gamepads of
 * several outlines; headsets. Forward is +Z, up +Y. */
#include "core/build.h"
#include "parts/thumbs.h"

/* ---- controllers for one hand ---- */

enum { SECTION = 14, STATIONS = 9 };

typedef struct hand_set {
    float length;            /* of the handle */
    dmg_handle_section grip; /* where it is thickest */
    float waist, belly, sag;
    float droop;             /* of the handle below the horizontal */
    float head, thick, tilt; /* radius and thickness of the face, tilted to the player */
    float lean;              /* of the fingers' side, forward */
    bool wand;               /* the head grows out of the handle: no tilted disc */
} hand_set;

static hand_set pick_hand_set(dmg_builder* b) {
    hand_set h = {.length = dmg_range(b, 0.08f, 0.13f), .wand = dmg_chance(b, 0.35f)};
    h.grip.half_width = h.length * dmg_range(b, 0.12f, 0.19f);
    h.grip.half_height = h.grip.half_width * dmg_range(b, 0.85f, 1.35f);
    h.waist = dmg_range(b, 0.0f, 0.25f);
    h.belly = dmg_range(b, 0.0f, 0.2f);
    h.sag = dmg_range(b, 0.0f, 0.2f);
    h.head = h.grip.half_width * dmg_range(b, 1.1f, h.wand ? 1.7f : 2.3f);
    h.thick = h.head * dmg_range(b, 0.35f, 0.9f);
    h.tilt = h.wand ? dmg_range(b, -0.1f, 0.35f) : dmg_range(b, 0.0f, 0.9f);
    /* The handle leaves the face from below. */
    h.droop = h.tilt + dmg_range(b, 0.0f, h.wand ? 0.4f : 0.8f);
    h.lean = dmg_range(b, -0.1f, 0.7f);
    return h;
}

/* The handle's section at a share of its length, 0 at the far, rounded end; belly and waist as hands like them. */
static dmg_handle_section grip_at(const hand_set* h, float s) {
    float from_end = 1.0f - fminf(1.0f, 5.0f * s), round = sqrtf(fmaxf(0.06f, 1.0f - from_end * from_end));
    float wide = round * (1.0f - h->waist * sinf(DMG_PI * s) * s + h->belly * sinf(DMG_PI * s) * (1 - s));
    return (dmg_handle_section){h->grip.half_width * wide, h->grip.half_height * wide,
                                -h->sag * h->length * (1 - s) * (1 - s)};
}

/* Along -Z from the head at the origin. */
static void draw_grip(dmg_builder* b, const hand_set* h) {
    dmg_xy outline[SECTION];
    dmg_row rows[STATIONS];
    for (int i = 0; i < SECTION; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / SECTION;
        outline[i] = (dmg_xy){cosf(angle), sinf(angle)};
    }
    for (int i = 0; i < STATIONS; ++i) {
        float s = (float)i / (STATIONS - 1);
        dmg_handle_section at = grip_at(h, s);
        rows[i] = (dmg_row){at.half_width, at.half_height, at.middle, h->length * (s - 1.0f)};
    }
    dmg_loft(b, outline, SECTION, rows, STATIONS);
}

/* Draws the head: a thick disc, or a flattened ball, below the thumb's face z = 0. */
static void draw_head(dmg_builder* b, const hand_set* h) {
    float r = h->head, t = h->thick;
    int kind = h->wand ? 1 : dmg_int(b, 0, 2);
    const dmg_xy puck[] = {{0, -t}, {0.5f * r, -t}, {0.9f * r, -0.5f * t}, {r, -0.1f * t}, {0.94f * r, 0}, {0, 0}};
    const dmg_xy bowl[] = {{0, -1.4f * t},  {0.45f * r, -1.25f * t}, {0.8f * r, -0.8f * t},
                           {r, -0.25f * t}, {0.97f * r, -0.05f * t}, {0.85f * r, 0},
                           {0, 0}};
    if (kind == 0) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), puck, 6);
    if (kind == 1) dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), bowl, 7);
    if (kind == 2) dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(1.8f * r, 2 * r, t), 0.45f * t);
}

/* Draws a ring for the cameras: above the face, round it or under the hand, whole or a bow. */
static void draw_halo(dmg_builder* b, const hand_set* h) {
    float radius = h->head * dmg_range(b, 1.4f, 2.8f), tube = radius * dmg_range(b, 0.05f, 0.2f),
          flat = dmg_range(b, 0.4f, 3.0f), lean = dmg_range(b, -0.5f, 1.6f);
    int where = dmg_int(b, 0, 2);
    float y = where == 0 ? radius * dmg_range(b, 0.5f, 1.0f) : radius * dmg_range(b, -1.0f, 0.2f),
          z = radius * dmg_range(b, -0.2f, 0.9f);
    bool whole = dmg_chance(b, 0.65f);
    enum { BOW = 20 };
    dmg_vec path[BOW];
    float arc = whole ? 2.0f * DMG_PI * (BOW - 1) / BOW : dmg_range(b, 2.5f, 5.5f);
    for (int i = 0; i < BOW; ++i) {
        float angle = arc * ((float)i / (BOW - 1) - 0.5f) + 0.5f * DMG_PI;
        path[i] = v3(radius * cosf(angle), 0, radius * sinf(angle));
    }
    dmg_save(b);
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(1, 0, 0), -lean);
    dmg_sweep(b, path, BOW, tube, tube * flat, whole);
    dmg_restore(b);
}

/* Draws a stick or a pad, or both, keys round them; on z = 0 within radius r. */
static void draw_face(dmg_builder* b, float r) {
    int layout = dmg_int(b, 0, 4), keys = dmg_int(b, 1, 4);
    float turn = dmg_range(b, 0, 2.0f * DMG_PI), small = r * dmg_range(b, 0.12f, 0.2f),
          off = r * dmg_range(b, 0.3f, 0.5f);
    bool middle = layout == 4;
    dmg_save(b);
    if (!middle) dmg_move(b, off * cosf(turn), off * sinf(turn), 0);
    if (layout == 0 || middle)
        dmg_touch_pad_draw(b, 0, r * (middle ? dmg_range(b, 0.4f, 0.65f) : dmg_range(b, 0.25f, 0.45f)));
    else
        dmg_thumb_stick_draw(b, 0, r * dmg_range(b, 0.22f, 0.4f));
    dmg_restore(b);
    float reach = r * (middle ? 0.87f : dmg_range(b, 0.5f, 0.7f)), step = 2.5f * small / reach;
    for (int i = 0; i < keys; ++i) {
        float angle = middle ? -0.5f * DMG_PI + step * ((float)i - 0.5f * (float)(keys - 1))
                             : turn + DMG_PI + step * ((float)i - 0.5f * (float)(keys - 1));
        dmg_save(b);
        dmg_move(b, reach * cosf(angle), reach * sinf(angle), 0);
        dmg_thumb_key_draw(b, 0, i == 2 ? "menu" : "key", i == 2 ? 0.7f * small : small);
        dmg_restore(b);
    }
}

/* Draws the fingers' side: a trigger under the front of the head; before it a crescent that slides in, in some. */
static void draw_finger_side(dmg_builder* b, const hand_set* h) {
    float wide = h->head * dmg_range(b, 0.8f, 1.7f), reach = h->head * dmg_range(b, 0.6f, 1.25f);
    bool bumper = dmg_chance(b, 0.25f);
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -h->tilt);
    const float z = h->head * dmg_range(b, 0.75f, 1.0f),
                y = -h->thick * dmg_range(b, 0.25f, 0.9f); /* down from the face, at its far edge */
    dmg_move(b, 0, y, z);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, -0.2f, 0.2f));
    dmg_turn(b, v3(0, 0, 1), dmg_range(b, -0.2f, 0.2f));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -h->lean);
    dmg_trigger_shell_draw(b, 0, "trigger", wide, reach);
    dmg_restore(b);
    if (bumper) {
        enum { ARC = 8 };
        dmg_xy crescent[ARC + 1];
        float flat = dmg_range(b, 0.3f, 0.8f), high = reach * dmg_range(b, 0.15f, 0.4f);
        for (int i = 0; i <= ARC; ++i) {
            float angle = DMG_PI * (float)i / ARC;
            crescent[i] = (dmg_xy){0.45f * wide * cosf(angle), flat * wide * sinf(angle)};
        }
        dmg_move(b, 0, 0.2f * high, 0);
        const float upper = wide * dmg_scale_range(b, 0.03f, 0.2f);
        const dmg_vec direction = v3_normalize(v3(0, dmg_range(b, -0.4f, 0.4f), -1));
        dmg_slide(b, 0, "bumper", direction, 0.0f, upper);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the outline's y becomes z */
        dmg_extrude(b, crescent, ARC + 1, -high, 0);
        dmg_use(b, 0);
    }
    dmg_restore(b);
}

static void draw_grip_levers(dmg_builder* b, const hand_set* h) {
    int count = dmg_weighted(b, (const float[]){0.25f, 0.6f, 0.15f}, 3);
    float side = dmg_chance(b, 0.5f) ? 0.0f : DMG_PI;
    for (int i = 0; i < count; ++i) {
        /* Under the middle finger, at the side or round the front corner. */
        float angle = side + (side > 0 ? 1.0f : -1.0f) * dmg_range(b, -0.2f, 1.5f),
              z = -h->length * dmg_range(b, 0.25f, 0.6f);
        dmg_handle_section here = grip_at(h, 1.0f + z / h->length);
        dmg_squeeze_draw(b, &here, angle, z, h->length * dmg_range(b, 0.15f, 0.35f));
        side = side > 0 ? 0.0f : DMG_PI;
    }
}

void dmg_build_vr_controller(dmg_builder* b) {
    hand_set h = pick_hand_set(b);
    if (dmg_chance(b, 0.5f)) dmg_mirror(b, v3(1, 0, 0));
    dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.7f, 0.4f));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -h.droop);
    draw_grip(b, &h);
    draw_grip_levers(b, &h);
    dmg_restore(b);
    if (dmg_chance(b, 0.5f)) draw_halo(b, &h);
    dmg_save(b);
    float over = h.grip.half_height * dmg_range(b, 1.1f, 1.3f), ahead = h.head * dmg_range(b, -0.1f, 0.4f);
    dmg_move(b, 0, over * cosf(h.tilt), ahead - over * sinf(h.tilt));
    dmg_save(b);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI - h.tilt);
    dmg_turn(b, v3(0, 0, 1), DMG_PI); /* the face's y points away from the player */
    draw_head(b, &h);
    draw_face(b, 0.9f * h.head);
    dmg_restore(b);
    draw_finger_side(b, &h);
    dmg_restore(b);
}

/* ---- gamepads: drawn facing +Z, the player below ---- */

typedef struct pad_set {
    float width, height, thick;
} pad_set;

/* Draws a plate, a lens, a dumb-bell; horns of any splay. Returns where its far edge is, behind the index fingers. */
static float draw_pad_body(dmg_builder* b, const pad_set* p) {
    int shape = dmg_int(b, 0, 3);
    float w = p->width, h = p->height, t = p->thick;
    if (shape == 0) dmg_rounded_box(b, v3(0, 0, -0.5f * t), v3(w, h, t), 0.4f * t);
    if (shape == 1) dmg_rounded_plate(b, w, h, t, dmg_range(b, 0.05f, 0.48f) * h);
    if (shape == 2) {
        dmg_rounded_plate(b, 0.7f * w, 0.8f * h, t, 0.2f * h);
        for (int s = -1; s <= 1; s += 2)
            dmg_rod(b, v3((float)s * 0.33f * w, 0, -t), v3((float)s * 0.33f * w, 0, 0), 0.5f * h);
    }
    if (shape == 3) dmg_ellipsoid(b, v3(0, 0, -0.5f * t), v3(0.6f * w, 0.75f * h, 0.5f * t));
    float edge = shape == 3 ? 0.63f * h : 0.5f * h;
    if (dmg_chance(b, 0.3f)) return edge;
    float splay = w * dmg_range(b, -0.02f, 0.1f), reach = h * dmg_range(b, 0.5f, 1.1f),
          thick = t * dmg_range(b, 0.3f, 0.48f), deep = t * dmg_range(b, 0.5f, 1.2f);
    for (int s = -1; s <= 1; s += 2) {
        dmg_vec from = {(float)s * 0.38f * w, 0, -0.55f * t}, to = {(float)s * (0.38f * w + splay), -reach, -deep};
        dmg_cone(b, from, to, 1.1f * thick, 0.8f * thick);
        dmg_ellipsoid(b, to, v3(0.85f * thick, 0.9f * thick, 0.85f * thick));
        if (dmg_chance(b, 0.7f)) dmg_ellipsoid(b, from, v3(1.5f * thick, 0.55f * h, 0.49f * t));
    }
    return fmaxf(edge, 0.54f * h);
}

/* Draws a cross that rocks about its ball, or four arrows pressed by themselves. */
static void draw_cross(dmg_builder* b, float size) {
    float arm = size * dmg_range(b, 0.25f, 0.38f), rise = size * dmg_range(b, 0.05f, 0.2f),
          swing = dmg_range(b, 0.05f, 0.2f), deep = size * dmg_range(b, 0.0f, 0.3f);
    if (dmg_chance(b, 0.3f)) {
        for (int i = 0; i < 4; ++i) {
            dmg_save(b);
            dmg_turn(b, v3(0, 0, 1), 0.5f * DMG_PI * (float)i);
            dmg_move(b, 0.34f * size, 0, 0);
            dmg_slide(b, 0, "arrow", v3(0, 0, -1), 0.0f, fminf(0.6f * rise, (rise + deep) * dmg_range(b, 0.08f, 0.3f)));
            dmg_rounded_box(b, v3(0, 0, 0.5f * (rise - deep)), v3(0.32f * size, arm, rise + deep), 0.1f * arm);
            dmg_restore(b);
        }
        dmg_use(b, 0);
        return;
    }
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0, -0.1f * size), v3(0, 0, 0.1f * rise), 0.65f * size);
    float angle = dmg_chance(b, 0.2f) ? 0.25f * DMG_PI : 0.5f * DMG_PI * (float)dmg_int(b, 0, 1);
    dmg_hinge(b, 0, "cross", v3(0, 0, -deep), v3(cosf(angle), sinf(angle), 0), -swing, swing);
    const float a = 0.5f * arm, l = 0.5f * size;
    const dmg_xy cross[] = {{l, -a}, {l, a},   {a, a},   {a, l},   {-a, l}, {-a, a},
                            {-l, a}, {-l, -a}, {-a, -a}, {-a, -l}, {a, -l}, {a, -a}};
    dmg_extrude(b, cross, 12, -deep, rise);
    if (dmg_chance(b, 0.3f)) dmg_dome(b, v3(0, 0, rise), v3(0.3f * arm, 0.05f * arm, 0.3f * arm));
    dmg_use(b, 0);
}

/* Behind the far edge, which is the origin, fingers beyond it: keys that rock about their inner end, and triggers under
 * them that turn about their root. */
static void draw_shoulder(dmg_builder* b, const pad_set* p, float side) {
    float w = p->width * dmg_range(b, 0.16f, 0.26f), t = p->thick * dmg_range(b, 0.2f, 0.4f),
          d = w * dmg_range(b, 0.2f, 0.4f);
    int keys = dmg_int(b, 0, 2);
    if (keys > 0) {
        dmg_save(b);
        dmg_move(b, 0, 0, -0.25f * p->thick);
        if (dmg_chance(b, 0.5f)) { /* the pin is towards the middle of the pad */
            float in = w * dmg_range(b, 0.45f, 0.7f), back = d * dmg_range(b, 0.0f, 0.8f);
            dmg_hinge(b, 0, "shoulder", v3(-side * in, -back, 0), v3(0, 0, -side), 0.0f, dmg_range(b, 0.05f, 0.2f));
        } else {
            dmg_slide(b, 0, "shoulder", v3(0, -1, 0), 0.0f, d * dmg_range(b, 0.04f, 0.3f));
        }
        dmg_rounded_box(b, v3(0, 0, 0), v3(w, d, t), 0.3f * fminf(d, t));
        dmg_restore(b);
        dmg_use(b, 0);
    }
    if (keys == 1) return;
    dmg_save(b);
    dmg_move(b, 0, 0, -0.25f * p->thick - 0.6f * t);
    dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI); /* the trigger's -Y hangs to -Z, its face +Z to the far side +Y */
    dmg_turn(b, v3(0, 1, 0), DMG_PI);
    dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.0f, 0.7f));
    dmg_trigger_shell_draw(b, 0, "trigger", 0.85f * w, p->thick * dmg_range(b, 0.5f, 1.0f));
    dmg_restore(b);
}

/* Keys in a diamond, a row or an arc. */
static void draw_key_group(dmg_builder* b, float size) {
    int count = dmg_int(b, 2, 6), pattern = dmg_int(b, 0, 2);
    float radius = size * dmg_range(b, 0.16f, 0.22f), lean = dmg_range(b, -0.3f, 0.6f);
    if (pattern == 0) count = 4;
    for (int i = 0; i < count; ++i) {
        float along = (float)i - 0.5f * (float)(count - 1), angle = 0.5f * DMG_PI * (float)i;
        dmg_save(b);
        if (pattern == 0) dmg_move(b, 0.36f * size * cosf(angle), 0.36f * size * sinf(angle), 0);
        if (pattern == 1) dmg_move(b, 0.44f * size * along * cosf(lean), 0.44f * size * along * sinf(lean), 0);
        if (pattern == 2)
            dmg_move(b, 0.44f * size * ((float)(i % 3) - 1.0f), 0.44f * size * ((float)(i / 3) - 0.5f), 0);
        dmg_thumb_key_draw(b, 0, "button", radius);
        dmg_restore(b);
    }
}

static void draw_pad_face(dmg_builder* b, const pad_set* p) {
    float size = 0.5f * p->height, x = 0.34f * p->width, high = 0.12f * p->height, low = -0.22f * p->height;
    bool sticks = dmg_chance(b, 0.8f), level = dmg_chance(b, 0.5f);
    for (int s = -1; s <= 1; s += 2) {
        float side = (float)s;
        dmg_save(b);
        dmg_move(b, side * x, high, 0);
        if (s > 0)
            draw_key_group(b, 0.8f * size);
        else if (level || !sticks)
            draw_cross(b, 0.65f * size);
        else
            dmg_thumb_stick_draw(b, 0, 0.27f * size);
        dmg_restore(b);
        if (!sticks) continue;
        dmg_save(b);
        dmg_move(b, side * 0.45f * x, low, 0);
        if (s < 0 && !level)
            draw_cross(b, 0.5f * size);
        else
            dmg_thumb_stick_draw(b, 0, 0.27f * size);
        dmg_restore(b);
    }
    int extra = dmg_int(b, 0, 3);
    for (int i = 0; i < extra; ++i) {
        dmg_save(b);
        dmg_move(b, 0.09f * p->width * ((float)i - 0.5f * (float)(extra - 1)), 0.25f * p->height, 0);
        dmg_thumb_key_draw(b, 0, "menu", 0.07f * size);
        dmg_restore(b);
    }
}

void dmg_build_gamepad(dmg_builder* b) {
    pad_set p = {.width = dmg_range(b, 0.1f, 0.18f)};
    p.height = p.width * dmg_range(b, 0.4f, 0.65f);
    p.thick = p.width * dmg_range(b, 0.1f, 0.28f);
    dmg_move(b, 0, p.thick + 0.3f * p.height, 0);
    if (dmg_chance(b, 0.7f)) dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI);
    float edge = draw_pad_body(b, &p);
    for (int s = -1; s <= 1; s += 2) { /* one side is the other's mirror image or nearly */
        dmg_save(b);
        dmg_move(b, (float)s * 0.33f * p.width, edge, 0);
        draw_shoulder(b, &p, (float)s);
        dmg_restore(b);
    }
    draw_pad_face(b, &p);
}
