/* Draws round instruments: a dial in a case, needles and cards that turn about its middle, knobs at the bezel's
 * corners. */
#include "core/build.h"
#include "parts/hardware.h"
#include "parts/switches.h"

/* ---- thin instruments ---- */

static void draw_needles(dmg_builder* b, float radius) {
    int count = dmg_int(b, 1, 3);
    for (int i = 0; i < count; ++i) {
        float length = radius * dmg_range(b, 0.4f, 0.85f), width = radius * dmg_range(b, 0.02f, 0.08f),
              z = 0.02f * radius * (float)(i + 1), swing = dmg_range(b, 0.6f, 2.6f);
        bool endless = dmg_chance(b, 0.5f);
        dmg_save(b);
        uint32_t needle = endless ? dmg_spin(b, 0, "needle", v3(0, 0, 0), v3(0, 0, 1))
                                  : dmg_hinge(b, 0, "needle", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
        if (endless)
            dmg_turn(b, v3(0, 0, 1), dmg_range(b, 0, 6));
        else
            dmg_rest(b, needle, dmg_range(b, -swing, swing));
        /* Some begin in the middle or out at the rim: the line they turn about does not touch them. */
        float from = dmg_chance(b, 0.6f) ? -0.2f * length : length * dmg_range(b, 0.0f, 0.7f),
              middle = 0.5f * (from + length);
        int kind = dmg_int(b, 0, 2);
        if (kind == 0) dmg_box(b, v3(0, middle, z), v3(width, length - from, 0.3f * width));
        if (kind == 1) { /* one face */
            const dmg_xy tip[] = {{-width, from}, {width, from}, {0, length}};
            dmg_extrude(b, tip, 3, z, z + 0.1f * width);
        }
        if (kind == 2)
            dmg_box_faces(b, v3(0, middle, z), v3(2 * width, length - from, 0.001f * radius), DMG_FACE_FRONT);
        if (from < 0.0f && dmg_chance(b, 0.6f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, z + 0.3f * width), 1.5f * width);
        dmg_restore(b);
        dmg_use(b, 0);
    }
}

void dmg_build_instrument(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.02f, 0.12f), depth = radius * dmg_range(b, 0.2f, 2.0f);
    int frame = dmg_int(b, 0, 2), knobs = dmg_int(b, 0, 3);
    dmg_move(b, 0, 1.3f * radius, 0);
    if (dmg_chance(b, 0.2f)) dmg_face_up(b);
    if (frame == 0) dmg_rounded_plate(b, 2.3f * radius, 2.3f * radius, 0.1f * radius, 0.3f * radius);
    if (frame == 1) dmg_box(b, v3(0, 0, -0.05f * radius), v3(2.2f * radius, 2.2f * radius, 0.1f * radius));
    if (dmg_chance(b, 0.7f) || frame == 2) dmg_rod(b, v3(0, 0, -depth), v3(0, 0, 0), 1.05f * radius);
    if (dmg_chance(b, 0.6f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), radius, 0.06f * radius);
    if (dmg_chance(b, 0.2f))
        dmg_dome(b, v3(0, 0, -1.3f * radius), v3(1.2f * radius, 1.2f * radius, 1.2f * radius)); /* a bowl behind */
    if (dmg_chance(b, 0.25f)) {                                                                 /* a card that turns */
        dmg_spin(b, 0, "card", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, 0), v3(0, 0, 0.015f * radius), 0.8f * radius);
        dmg_use(b, 0);
    }
    if (knobs == 0 || dmg_chance(b, 0.6f)) draw_needles(b, radius);
    for (int i = 0; i < knobs; ++i) {
        float angle = 0.25f * DMG_PI + 0.5f * DMG_PI * (float)(i + 2), size = radius * dmg_range(b, 0.12f, 0.25f),
              sink = depth * dmg_range(b, 0.0f, 0.3f);
        dmg_save(b);
        dmg_move(b, 1.3f * radius * cosf(angle), 1.3f * radius * sinf(angle), 0);
        dmg_rod(b, v3(0, 0, -sink - 0.1f * radius), v3(0, 0, 0), 0.8f * size);
        dmg_control_row_draw(b, dmg_chance(b, 0.4f) ? DMG_CONTROL_STACK : DMG_CONTROL_DIAL, 1, 0, size);
        dmg_restore(b);
    }
}

/* ---- gauges with a deep dial ---- */

/* Draws a pointer along +Y on z = 0, pivot at the origin; `tail` reaches behind it, or is negative where it floats. */
static void draw_pointer(dmg_builder* b, float length, float tail, float width) {
    int kind = dmg_int(b, 0, 5);
    float thin = 0.2f * width, half = 0.5f * width, middle = 0.5f * (length - tail), whole = length + tail;
    const dmg_xy sword[] = {
        {-half, -tail}, {half, -tail}, {0.6f * half, 0.8f * length}, {0, length}, {-0.6f * half, 0.8f * length}};
    const dmg_xy kite[] = {{0, -tail}, {half, middle}, {0, length}, {-half, middle}};
    const dmg_xy wedge[] = {{-half, -tail}, {half, -tail}, {0, length}};
    if (kind == 0) dmg_extrude(b, sword, 5, 0, thin);
    if (kind == 1) dmg_extrude(b, kite, 4, 0, thin);
    if (kind == 2) dmg_extrude(b, wedge, 3, 0, thin);
    if (kind == 3) dmg_box_faces(b, v3(0, middle, 0), v3(width, whole, 0), DMG_FACE_FRONT);
    if (kind == 4) { /* a stalk with a head like a drop */
        dmg_box(b, v3(0, middle, 0.5f * thin), v3(0.3f * width, whole, thin));
        const dmg_xy head[] = {
            {0, 0.55f * length}, {1.3f * half, 0.7f * length}, {0, length}, {-1.3f * half, 0.7f * length}};
        dmg_extrude(b, head, 4, 0, 1.2f * thin);
    }
    if (kind == 5) dmg_rod(b, v3(0, -tail, half), v3(0, length, half), 0.4f * half);
    if (tail > 0.0f && dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, -tail, 0), v3(0, -tail, thin), 1.2f * half); /* a weight */
    if (tail > 0.0f && dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 0, 0), v3(0, 0, 2 * thin), 0.9f * width);    /* a hub */
}

/* Draws one to three pointers on one pivot, each shorter than the one before, at their own angles or aligned. */
static void draw_pointers(dmg_builder* b, float radius) {
    int count = dmg_int(b, 1, 3);
    bool aligned = dmg_chance(b, 0.4f), endless = dmg_chance(b, 0.6f);
    float length = radius * dmg_range(b, 0.6f, 0.97f), width = radius * dmg_range(b, 0.03f, 0.15f),
          angle = dmg_range(b, 0, 2.0f * DMG_PI);
    for (int i = 0; i < count; ++i) {
        float swing = dmg_range(b, 0.5f, 2.7f);
        float tail = dmg_chance(b, 0.8f) ? length * dmg_range(b, 0.0f, 0.6f) : -length * dmg_range(b, 0.1f, 0.7f);
        dmg_save(b);
        dmg_move(b, 0, 0, 0.02f * radius * (float)(i + 1));
        dmg_turn(b, v3(0, 0, 1), angle);
        if (endless)
            dmg_spin(b, 0, "needle", v3(0, 0, 0), v3(0, 0, -1));
        else
            dmg_hinge(b, 0, "needle", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
        draw_pointer(b, length, tail, width);
        dmg_restore(b);
        dmg_use(b, 0);
        length *= dmg_range(b, 0.45f, 0.9f);
        width *= dmg_range(b, 0.8f, 1.6f);
        if (!aligned) angle = dmg_range(b, 0, 2.0f * DMG_PI);
    }
}

/* Draws what turns about the dial's middle besides needles: a card, a ring of figures, a bug at the rim. */
static void draw_card(dmg_builder* b, float radius) {
    int kind = dmg_int(b, 0, 2);
    float thin = 0.01f * radius, outer = radius * dmg_range(b, 0.6f, 0.97f), inner = outer * dmg_range(b, 0.5f, 0.85f);
    float angle = dmg_range(b, 0, 2.0f * DMG_PI);
    dmg_save(b);
    dmg_turn(b, v3(0, 0, 1), angle);
    dmg_spin(b, 0, kind == 2 ? "bug" : "card", v3(0, 0, 0), v3(0, 0, -1));
    if (kind == 0) dmg_rod(b, v3(0, 0, 0), v3(0, 0, thin), outer);
    if (kind == 1) {
        const dmg_xy ring[] = {{inner, 0}, {outer, 0}, {outer, thin}, {inner, thin}, {inner, 0}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    }
    int figures = kind == 2 ? 0 : dmg_int(b, 0, 8);
    for (int i = 0; i < figures; ++i) {
        float at = 2.0f * DMG_PI * (float)i / (float)figures, r = 0.5f * (inner + outer);
        dmg_box(b, v3(r * cosf(at), r * sinf(at), 1.5f * thin), v3(0.08f * radius, 0.08f * radius, thin));
    }
    if (kind == 2) dmg_box(b, v3(0, 0.9f * outer, thin), v3(0.2f * outer, 0.12f * outer, 2 * thin));
    dmg_restore(b);
    dmg_use(b, 0);
}

/* Draws the bezel, its front at z = 0: a plate, one with its corners cut, a flange; the case behind it. Returns how far
 * out in x and y its corners offer room. */
static float draw_bezel(dmg_builder* b, float radius, float half, float depth) {
    int kind = dmg_int(b, 0, 3);
    float thin = radius * dmg_range(b, 0.02f, 0.15f), cut = half * dmg_range(b, 0.45f, 0.8f);
    if (kind == 0) dmg_holed_plate_draw(b, 2 * half, 2 * half, thin, 0.95f * radius);
    if (kind == 1) {
        const dmg_xy octagon[] = {{-cut, -half}, {cut, -half}, {half, -cut}, {half, cut},
                                  {cut, half},   {-cut, half}, {-half, cut}, {-half, -cut}};
        dmg_extrude(b, octagon, 8, -thin, 0);
    }
    if (kind == 2) dmg_box_faces(b, v3(0, 0, 0), v3(2 * half, 2 * half, 0), DMG_FACE_FRONT);
    if (kind == 3) dmg_rod(b, v3(0, 0, -thin), v3(0, 0, 0), half);
    if (dmg_chance(b, 0.7f) || kind == 0) { /* behind a hole it shows as the dial's face and fills it */
        float can = dmg_range(b, 0.8f, 1.02f);
        dmg_rod(b, v3(0, 0, -depth), v3(0, 0, -thin), radius * (kind == 0 ? fmaxf(can, 0.97f) : can));
    }
    float at = kind == 3 ? 0.66f * half : (kind == 1 ? 0.46f * (half + cut) : 0.88f * half);
    for (int i = 0; i < 4 && dmg_chance(b, 0.6f); ++i) { /* screws */
        float x = i & 1 ? at : -at, y = i & 2 ? at : -at, size = 0.07f * radius;
        dmg_rod(b, v3(x, y, -thin), v3(x, y, 0.4f * size), size);
    }
    return kind == 3 ? 0.66f * half : 0.5f * (half + (kind == 1 ? cut : half));
}

/* Knobs and pointed switches at the bezel's corners, often long, their shafts running back through the plate. */
static void draw_corner(dmg_builder* b, float radius) {
    float size = radius * dmg_range(b, 0.1f, 0.22f);
    if (dmg_chance(b, 0.25f)) {
        dmg_control_row_draw(b, dmg_chance(b, 0.5f) ? DMG_CONTROL_STACK : DMG_CONTROL_KEY, 1, 0, size);
        return;
    }
    dmg_dial dial = dmg_dial_pick(b);
    dial.height = dmg_scale_range(b, 0.3f, 2.3f);
    if (dmg_chance(b, 0.4f)) dial.sink = dmg_range(b, 0.2f, 0.75f);
    dmg_dial_draw(b, &dial, size);
}

/* Draws what watches have at their rim: a crown that turns about a line through the middle, keys that are pressed
 * inwards. */
static void draw_crown(dmg_builder* b, float radius, float depth) {
    float angle = dmg_range(b, 0, 2.0f * DMG_PI), size = fminf(0.4f * depth, radius * dmg_range(b, 0.06f, 0.16f));
    int kinds[] = {DMG_CONTROL_DIAL, DMG_CONTROL_DIAL, DMG_CONTROL_KEY, DMG_CONTROL_PLUNGER};
    dmg_save(b);
    dmg_move(b, radius * cosf(angle), radius * sinf(angle), -0.5f * depth);
    dmg_turn(b, v3(0, 0, 1), angle);
    dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI); /* outwards */
    dmg_control_row_draw(b, (dmg_control_kind)kinds[dmg_int(b, 0, 3)], 1, 0, size);
    dmg_restore(b);
}

/* Draws the ring round the glass; some turn. */
static void draw_rim(dmg_builder* b, float radius, float wall) {
    const dmg_xy ring[] = {
        {0.93f * radius, 0}, {radius, 0}, {radius, wall}, {0.93f * radius, wall}, {0.93f * radius, 0}};
    bool turns = dmg_chance(b, 0.12f);
    if (turns) dmg_spin(b, 0, "rim", v3(0, 0, 0), v3(0, 0, -1));
    dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), ring, 5);
    if (turns && dmg_chance(b, 0.6f))
        dmg_box(b, v3(0, 0.965f * radius, wall), v3(0.06f * radius, 0.05f * radius, 0.1f * wall));
    dmg_use(b, 0);
}

void dmg_build_gauge(dmg_builder* b) {
    float radius = dmg_scale_range(b, 0.02f, 0.15f), half = radius * dmg_range(b, 1.02f, 1.25f),
          depth = radius * dmg_scale_range(b, 0.1f, 2.0f), wall = radius * dmg_range(b, 0.02f, 0.4f);
    dmg_move(b, 0, half, 0);
    if (dmg_chance(b, 0.2f)) dmg_face_up(b);
    float corner = draw_bezel(b, radius, half, depth);
    if (dmg_chance(b, 0.7f)) draw_rim(b, radius, wall);
    if (dmg_chance(b, 0.12f)) draw_crown(b, 0.97f * radius, depth);
    int marks = dmg_chance(b, 0.4f) ? dmg_int(b, 4, 12) : 0;
    for (int i = 0; i < marks; ++i) {
        float at = 2.0f * DMG_PI * (float)i / (float)marks, r = 0.85f * radius;
        dmg_box(b, v3(r * cosf(at), r * sinf(at), 0), v3(0.05f * radius, 0.05f * radius, 0.02f * radius));
    }
    if (dmg_chance(b, 0.35f)) draw_card(b, 0.9f * radius);
    if (dmg_chance(b, 0.75f)) draw_pointers(b, 0.9f * radius);
    if (dmg_chance(b, 0.25f)) { /* a small dial inside the large one */
        float angle = dmg_range(b, 0, 2.0f * DMG_PI), at = radius * dmg_range(b, 0.3f, 0.5f);
        dmg_save(b);
        dmg_move(b, at * cosf(angle), at * sinf(angle), 0);
        dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.3f * radius, 0.01f * radius);
        draw_pointers(b, 0.3f * radius);
        dmg_restore(b);
    }
    for (int i = 0; i < 4; ++i) {
        if (!dmg_chance(b, 0.4f) && (b->part_count > 0 || i < 3)) continue;
        float reach = corner * dmg_range(b, 0.82f, 0.98f);
        dmg_save(b);
        dmg_move(b, i & 1 ? reach : -reach, i & 2 ? reach : -reach, 0);
        draw_corner(b, radius);
        dmg_restore(b);
    }
}

/* ---- clusters ---- */

/* Draws a window with a needle whose pivot lies at its lower edge or below it. */
static void draw_meter(dmg_builder* b, float radius) {
    float width = radius * dmg_range(b, 1.2f, 1.9f), height = radius * dmg_range(b, 0.8f, 1.6f),
          below = height * dmg_range(b, -0.1f, 0.3f), swing = dmg_range(b, 0.4f, 0.9f), thin = 0.03f * radius,
          length = (height + below) * dmg_range(b, 0.7f, 0.95f), start = fmaxf(0.0f, below * dmg_range(b, 0.0f, 1.2f));
    bool idle = dmg_chance(b, 0.4f);
    dmg_frame_draw(b, width, height, 2 * thin, 2 * thin);
    dmg_move(b, 0, -0.5f * height - below, thin);
    uint32_t needle = dmg_hinge(b, 0, "needle", v3(0, 0, 0), v3(0, 0, -1), -swing, swing);
    draw_pointer(b, length, -start, radius * dmg_range(b, 0.03f, 0.1f));
    dmg_rest(b, needle, idle ? -swing : swing * dmg_range(b, -1.0f, 1.0f));
    dmg_use(b, 0);
}

static void draw_dial_of_cluster(dmg_builder* b, float radius) {
    if (dmg_chance(b, 0.7f)) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 0.96f * radius, 0.04f * radius);
    if (dmg_chance(b, 0.3f)) dmg_rod(b, v3(0, 0, -0.2f * radius), v3(0, 0, 0.005f * radius), 0.95f * radius);
    if (dmg_chance(b, 0.15f)) draw_card(b, 0.9f * radius);
    draw_pointers(b, 0.9f * radius);
}

/* Dials of several sizes in one panel: what a needle turns about is its own dial's middle, not the object's. */
void dmg_build_dashboard(dmg_builder* b) {
    int columns = dmg_int(b, 2, 4), rows = dmg_chance(b, 0.3f) ? 2 : 1;
    float cell = dmg_scale_range(b, 0.05f, 0.15f), thin = cell * dmg_scale_range(b, 0.05f, 1.0f);
    float width = cell * (float)columns, height = cell * (float)rows;
    dmg_move(b, 0, 0.5f * height, 0);
    if (dmg_chance(b, 0.4f)) dmg_turn(b, v3(1, 0, 0), -dmg_range(b, 0.1f, 0.8f));
    if (dmg_chance(b, 0.7f))
        dmg_box(b, v3(0, 0, -0.5f * thin), v3(1.05f * width, 1.05f * height, thin));
    else
        dmg_rounded_plate(b, 1.05f * width, 1.05f * height, thin, 0.2f * height);
    for (int i = 0; i < columns * rows; ++i) {
        float room = 0.5f * cell * dmg_range(b, 0.55f, 0.97f);
        int kind = b->part_count == 0 ? 0 : dmg_int(b, 0, 5);
        dmg_save(b);
        dmg_move(b, cell * ((float)(i % columns) - 0.5f * (float)(columns - 1)),
                 cell * (0.5f * (float)(rows - 1) - (float)(i / columns)), 0);
        if (kind <= 3) draw_dial_of_cluster(b, room);
        if (kind == 4) draw_meter(b, 0.9f * room);
        if (kind == 5) draw_corner(b, 2.5f * room);
        dmg_restore(b);
    }
}
