/* Draws controllers held in one hand: a grip and a head with a stick or a touch pad, keys, triggers whose pivots are
 * hidden inside the shell. They point to +Z with the thumb's face up. */
#include "core/build.h"
#include "parts/hardware.h"

enum { OUTLINE = 12, ROWS = 9 };

/* The shell: an ellipse carried along Z. Half sizes and middle of a cross section, by z. */
typedef struct shell {
    float grip, head; /* how far it reaches to -Z and to +Z */
    float width, height;
    float flare; /* the head is this much wider than the grip */
    float bend;  /* the grip hangs down */
    float taper;
} shell;

typedef struct section {
    float half_width, half_height, middle;
} section;

static section section_at(const shell* s, float z) {
    float along = z < 0 ? z / s->grip : z / s->head; /* -1 … 0 … 1 */
    float head = 1.0f / (1.0f + expf(-6.0f * (along + 0.15f)));
    float end =
        fabsf(along) > 0.8f ? sqrtf(fmaxf(0.0f, 1.0f - 22.0f * (fabsf(along) - 0.8f) * (fabsf(along) - 0.8f))) : 1.0f;
    float wide = (1.0f + (s->flare - 1.0f) * head) * (z < 0 ? 1.0f + s->taper * along : 1.0f) * fmaxf(end, 0.3f);
    section out = {s->width * wide, s->height * (0.6f + 0.4f * wide), 0.0f};
    if (z < 0) out.middle = -s->bend * s->grip * along * along;
    return out;
}

static shell pick_shell(dmg_builder* b, float size) {
    shell s = {.grip = size * dmg_range(b, 0.5f, 0.8f), .head = size * dmg_range(b, 0.2f, 0.45f)};
    s.width = size * dmg_range(b, 0.1f, 0.17f);
    s.height = size * dmg_range(b, 0.09f, 0.16f);
    s.flare = dmg_range(b, 0.9f, 2.0f);
    s.bend = dmg_chance(b, 0.3f) ? 0.0f : dmg_range(b, 0.1f, 0.8f);
    s.taper = dmg_range(b, -0.15f, 0.4f);
    return s;
}

static void draw_shell(dmg_builder* b, const shell* s) {
    dmg_xy outline[OUTLINE];
    dmg_row rows[ROWS];
    bool square = dmg_chance(b, 0.2f);
    for (int i = 0; i < OUTLINE; ++i) {
        float angle = 2.0f * DMG_PI * (float)i / OUTLINE, x = cosf(angle), y = sinf(angle);
        float grow = square ? 0.85f / fmaxf(fabsf(x), fabsf(y)) : 1.0f;
        outline[i] = (dmg_xy){x * fminf(grow, 1.15f), y * fminf(grow, 1.15f)};
    }
    for (int i = 0; i < ROWS; ++i) {
        float share = (float)i / (ROWS - 1), z = -s->grip + (s->grip + s->head) * share;
        section at = section_at(s, z);
        rows[i] = (dmg_row){at.half_width, at.half_height, at.middle, z};
    }
    dmg_loft(b, outline, OUTLINE, rows, ROWS);
}

/* Draws a tracking ring about the head, or a bumper in front of it. */
static void draw_ring(dmg_builder* b, const shell* s) {
    float radius = s->width * dmg_range(b, 1.5f, 3.2f), tube = radius * dmg_range(b, 0.06f, 0.2f),
          lean = dmg_range(b, -0.6f, 1.6f);
    dmg_vec axis = {0, cosf(lean), sinf(lean)};
    float y = s->height * dmg_range(b, -0.5f, 1.2f), z = s->head * dmg_range(b, -0.2f, 1.0f);
    if (dmg_chance(b, 0.5f)) {
        dmg_torus(b, v3(0, y, z), axis, radius, tube);
        return;
    }
    const dmg_xy band[] = {{radius, -2 * tube},
                           {1.1f * radius, -2 * tube},
                           {1.15f * radius, 2 * tube},
                           {1.05f * radius, 2 * tube},
                           {radius, -2 * tube}};
    float start = dmg_chance(b, 0.5f) ? 0.0f : 0.8f, arc = dmg_chance(b, 0.6f) ? 2.0f * DMG_PI : 4.5f;
    dmg_lathe_arc(b, v3(0, y, z), axis, band, 5, start, arc);
}

/* ---- on the thumb's face: z = 0, +Z out of the shell ---- */

/* One part has one joint here: a real stick presses and leans about two lines, and only the drag tells which is meant.
 */
static void draw_thumbstick(dmg_builder* b, uint32_t parent, float radius) {
    float rise = radius * dmg_range(b, 0.35f, 0.9f), pivot = -radius * dmg_range(b, -0.3f, 1.0f),
          swing = dmg_range(b, 0.2f, 0.4f);
    bool collar = dmg_chance(b, 0.6f);
    if (collar) dmg_torus(b, v3(0, 0, 0), v3(0, 0, 1), 1.25f * radius, radius * dmg_range(b, 0.06f, 0.2f));
    int motion = dmg_int(b, 0, 2);
    if (motion == 0) dmg_slide(b, parent, "thumb_stick", v3(0, 0, -1), 0.0f, radius * dmg_range(b, 0.05f, 0.25f));
    if (motion == 1) dmg_hinge(b, parent, "thumb_stick", v3(0, 0, pivot), v3(1, 0, 0), -swing, swing);
    if (motion == 2) dmg_hinge(b, parent, "thumb_stick", v3(0, 0, pivot), v3(0, 1, 0), -swing, swing);
    float stem = radius * dmg_range(b, 0.35f, 0.7f);
    if (dmg_chance(b, 0.4f)) dmg_dome(b, v3(0, 0, -0.2f * radius), v3(0.9f * radius, 0.9f * radius, 0.5f * radius));
    dmg_cone(b, v3(0, 0, fminf(pivot, -0.1f * radius)), v3(0, 0, 0.8f * rise), 1.1f * stem, 0.8f * stem);
    if (dmg_chance(b, 0.5f)) {
        const dmg_xy cap[] = {{0.3f * radius, 0.7f * rise},
                              {radius, 0.8f * rise},
                              {radius, rise},
                              {0.75f * radius, 1.05f * rise},
                              {0, 0.9f * rise}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cap, 5);
    } else {
        dmg_rod(b, v3(0, 0, 0.75f * rise), v3(0, 0, rise), radius);
    }
    dmg_use(b, parent);
}

static void draw_touchpad(dmg_builder* b, uint32_t parent, float radius) {
    float rise = radius * dmg_range(b, 0.02f, 0.15f), travel = radius * dmg_range(b, 0.03f, 0.12f);
    dmg_slide(b, parent, "touchpad", v3(0, 0, -1), 0.0f, travel);
    int kind = dmg_int(b, 0, 3);
    if (kind == 0) dmg_rod(b, v3(0, 0, -0.3f * radius), v3(0, 0, rise), radius);
    if (kind == 1)
        dmg_rounded_box(b, v3(0, 0, -0.1f * radius), v3(1.8f * radius, 2.4f * radius, 2 * rise + 0.2f * radius),
                        0.1f * radius);
    if (kind == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius, 2 * rise));
    if (kind == 3) { /* a face alone */
        const dmg_xy disc[] = {{radius, 0.5f * rise}, {0.5f * radius, rise}, {0, rise}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), disc, 3);
    }
    dmg_use(b, parent);
}

static void draw_key(dmg_builder* b, uint32_t parent, const char* name, float radius) {
    float rise = radius * dmg_range(b, 0.15f, 0.9f);
    dmg_slide(b, parent, name, v3(0, 0, -1), 0.0f, rise * dmg_range(b, 0.2f, 0.9f));
    int kind = dmg_int(b, 0, 4);
    if (kind == 0) dmg_rod(b, v3(0, 0, -0.5f * radius), v3(0, 0, rise), radius);
    if (kind == 1) dmg_cone(b, v3(0, 0, -0.5f * radius), v3(0, 0, rise), radius, 0.8f * radius);
    if (kind == 2) dmg_ellipsoid(b, v3(0, 0, 0), v3(radius, radius, rise));
    if (kind == 3)
        dmg_rounded_box(b, v3(0, 0, 0), v3(1.7f * radius, dmg_range(b, 0.8f, 2.5f) * radius, 2 * rise),
                        0.3f * fminf(rise, 0.5f * radius));
    if (kind == 4) {
        const dmg_xy cap[] = {{radius, -0.3f * radius}, {radius, 0.7f * rise}, {0.8f * radius, rise}, {0, rise}};
        dmg_lathe(b, v3(0, 0, 0), v3(0, 0, 1), cap, 4);
    }
    dmg_use(b, parent);
}

/* Stick, pad or both in the middle, keys beside or below. */
static void draw_thumb_face(dmg_builder* b, uint32_t parent, float width) {
    int layout = dmg_int(b, 0, 3), keys = dmg_int(b, 0, 3);
    float radius = width * dmg_range(b, 0.2f, 0.38f), small = width * dmg_range(b, 0.09f, 0.17f), side = dmg_sign(b);
    if (layout == 0) draw_touchpad(b, parent, width * dmg_range(b, 0.4f, 0.75f));
    if (layout > 0) {
        dmg_save(b);
        dmg_move(b, layout == 1 ? 0 : side * 0.35f * width, layout == 3 ? 0.3f * width : 0, 0);
        draw_thumbstick(b, parent, radius);
        dmg_restore(b);
    }
    if (layout == 3) {
        dmg_save(b);
        dmg_move(b, 0, -0.6f * width, 0);
        draw_touchpad(b, parent, 0.4f * width);
        dmg_restore(b);
    }
    for (int i = 0; i < keys; ++i) {
        dmg_save(b);
        bool beside = layout == 2 || layout == 3;
        float turn = 0.9f * ((float)i - 0.5f * (float)(keys - 1)),
              x = beside ? -side * 0.45f * width * cosf(turn) : 0.35f * width * ((float)i - 0.5f * (float)(keys - 1));
        dmg_move(b, x, beside ? 0.55f * width * sinf(turn) : -0.9f * width, 0);
        draw_key(b, parent, i == 2 ? "menu" : "key", small);
        dmg_restore(b);
    }
}

/* ---- triggers ---- */

/* Hangs from the origin towards -Y, its face to +Z; turns about X at a pivot that is somewhere above or behind. */
static void draw_finger_trigger(dmg_builder* b, uint32_t parent, const char* name, float width, float length) {
    float far = dmg_range(b, 0.12f, 0.55f), tilt = dmg_chance(b, 0.5f) ? 0.0f : dmg_range(b, -0.25f, 0.25f);
    /* The pivot: somewhere in the shell, near the trigger's root or well away from it. */
    bool far_off = dmg_chance(b, 0.25f);
    float up = length * dmg_range(b, -0.2f, far_off ? 1.6f : 0.6f),
          back = length * dmg_range(b, -0.5f, far_off ? 1.4f : 0.4f);
    far = fminf(far, 0.5f * length / hypotf(up + 0.4f * length, back)); /* a finger pulls no farther */
    dmg_turn(b, v3(0, 0, 1), tilt);
    dmg_hinge(b, parent, name, v3(0, up, -back), v3(1, 0, 0), 0.0f, far);
    int kind = dmg_int(b, 0, 4);
    if (kind == 4) { /* a cap round the shell's front, thin and hollow */
        const dmg_xy cap[] = {{0.9f * length, -0.5f * width},
                              {length, -0.4f * width},
                              {length, 0.4f * width},
                              {0.9f * length, 0.5f * width}};
        float round = dmg_range(b, 0.7f, 1.6f);
        dmg_save(b);
        dmg_move(b, 0, 0.3f * length, -0.4f * length);
        dmg_turn(b, v3(1, 0, 0), 0.5f * DMG_PI + dmg_range(b, -0.9f, 0.1f));
        dmg_lathe_arc(b, v3(0, 0, 0), v3(1, 0, 0), cap, 4, 0.5f * DMG_PI - 0.5f * round, round);
        dmg_restore(b);
    }
    if (kind == 0) dmg_ellipsoid(b, v3(0, -0.4f * length, 0), v3(0.5f * width, 0.55f * length, 0.3f * length));
    if (kind == 1)
        dmg_rounded_box(b, v3(0, -0.4f * length, 0), v3(width, length, 0.5f * length),
                        0.2f * fminf(width, 0.5f * length));
    if (kind == 2 || kind == 3) { /* a curved blade: hooks forward at its end */
        enum { POINTS = 6 };
        dmg_xy line[2 * POINTS];
        float thick = length * dmg_range(b, 0.12f, 0.35f), hook = length * dmg_range(b, 0.1f, 0.5f);
        for (int i = 0; i < POINTS; ++i) {
            float s = (float)i / (POINTS - 1), y = 0.2f * length - 1.1f * length * s,
                  z = hook * (s - 0.5f) * (s - 0.5f) * 4.0f - 0.5f * hook;
            float t = thick * (1.0f - 0.5f * s);
            line[i] = (dmg_xy){z + t, y};
            line[2 * POINTS - 1 - i] = (dmg_xy){z - t, y};
        }
        for (int i = 0; i < POINTS; ++i) { /* counter-clockwise */
            dmg_xy swap = line[i];
            line[i] = line[2 * POINTS - 1 - i];
            line[2 * POINTS - 1 - i] = swap;
        }
        dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI); /* the outline's x becomes z */
        dmg_extrude(b, line, 2 * POINTS, -0.5f * width, 0.5f * width);
    }
    dmg_use(b, parent);
}

/* Let into the side, the front or the back of the grip. */
static void draw_squeeze(dmg_builder* b, const shell* s) {
    float z = -s->grip * dmg_range(b, 0.15f, 0.6f), length = s->grip * dmg_range(b, 0.12f, 0.35f);
    section at = section_at(s, z);
    float round = dmg_range(b, -0.6f, 0.6f), side = dmg_chance(b, 0.5f) ? 0.0f : DMG_PI;
    round += dmg_chance(b, 0.6f) ? side : -0.5f * DMG_PI;
    dmg_save(b);
    dmg_move(b, at.half_width * cosf(round), at.middle + at.half_height * sinf(round), z);
    dmg_turn(b, v3(0, 0, 1), round - 0.5f * DMG_PI);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* the shell's outside becomes +Z */
    float rise = 0.12f * at.half_width, wide = at.half_width * dmg_range(b, 0.4f, 1.0f);
    float end = dmg_sign(b);
    if (dmg_chance(b, 0.2f))
        dmg_hinge(b, 0, "squeeze", v3(0, 0.5f * end * length, -rise), v3(end, 0, 0), 0.0f, 0.12f);
    else
        dmg_slide(b, 0, "squeeze", v3(0, 0, -1), 0.0f, rise * dmg_range(b, 0.3f, 1.2f));
    if (dmg_chance(b, 0.5f))
        dmg_rounded_box(b, v3(0, 0, 0), v3(wide, length, 2 * rise), 0.4f * rise);
    else
        dmg_ellipsoid(b, v3(0, 0, 0), v3(0.5f * wide, 0.5f * length, rise));
    dmg_use(b, 0);
    dmg_restore(b);
}

void dmg_build_motion_controller(dmg_builder* b) {
    float size = dmg_range(b, 0.1f, 0.2f);
    shell s = pick_shell(b, size);
    if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(1, 0, 0), dmg_range(b, -0.9f, 0.9f));
    draw_shell(b, &s);
    if (dmg_chance(b, 0.55f)) draw_ring(b, &s);
    float z = s.head * dmg_range(b, -0.2f, 0.6f), tilt = dmg_range(b, -0.1f, 0.7f);
    section top = section_at(&s, z);
    dmg_save(b);
    dmg_move(b, 0, top.half_height, z);
    dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI - tilt * 0.5f);
    dmg_turn(b, v3(0, 0, 1), DMG_PI); /* the face's y points away from the player */
    if (dmg_chance(b, 0.3f)) {        /* a face plate */
        dmg_rod(b, v3(0, 0, -0.5f * top.half_height), v3(0, 0, 0.02f * size), 1.25f * top.half_width);
        dmg_move(b, 0, 0, 0.02f * size);
    }
    draw_thumb_face(b, 0, 1.6f * top.half_width);
    dmg_restore(b);
    float at = s.head * dmg_range(b, 0.3f, 0.9f);
    section under = section_at(&s, at);
    dmg_save(b);
    dmg_move(b, 0, under.middle - 0.5f * under.half_height, at);
    float wide = under.half_width * dmg_range(b, 0.6f, 1.4f), reach = s.height * dmg_range(b, 0.9f, 2.2f);
    draw_finger_trigger(b, 0, "trigger", wide, reach);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) draw_squeeze(b, &s);
    if (dmg_chance(b, 0.15f)) draw_squeeze(b, &s);
}

/* Pistols and spray guns: the trigger in its guard, a slide or a hammer. */
void dmg_build_pistol(dmg_builder* b) {
    float length = dmg_scale_range(b, 0.12f, 0.4f), high = length * dmg_range(b, 0.14f, 0.22f),
          wide = high * dmg_range(b, 0.5f, 1.0f), grip = length * dmg_range(b, 0.35f, 0.6f);
    dmg_move(b, 0, grip, 0);
    dmg_box(b, v3(0, 0.3f * high, 0), v3(wide, 0.6f * high, length));
    dmg_beam(b, v3(0, 0.2f * high, -0.3f * length), v3(0, -grip, -0.45f * length), 0.9f * wide, 0.2f * length);
    dmg_rod(b, v3(0, 0.8f * high, 0.3f * length), v3(0, 0.8f * high, 0.6f * length), 0.2f * high);
    float guard = grip * 0.35f;
    if (dmg_chance(b, 0.8f)) {
        const dmg_vec loop[] = {{0, 0, -0.18f * length},
                                {0, -0.8f * guard, -0.15f * length},
                                {0, -guard, -0.02f * length},
                                {0, -0.8f * guard, 0.1f * length},
                                {0, 0, 0.12f * length}};
        dmg_sweep(b, loop, 5, 0.12f * wide, 0.25f * wide, false);
    }
    dmg_save(b);
    dmg_move(b, 0, 0, -0.02f * length);
    draw_finger_trigger(b, 0, "trigger", 0.4f * wide, 0.75f * guard);
    dmg_restore(b);
    if (dmg_chance(b, 0.6f)) {
        dmg_slide(b, 0, "slide", v3(0, 0, -1), 0.0f, 0.25f * length);
        dmg_box(b, v3(0, 0.8f * high, 0), v3(1.05f * wide, 0.45f * high, 0.95f * length));
        dmg_use(b, 0);
    } else {
        dmg_box(b, v3(0, 0.8f * high, 0), v3(0.9f * wide, 0.4f * high, 0.7f * length));
        dmg_hinge(b, 0, "hammer", v3(0, 0.6f * high, -0.47f * length), v3(-1, 0, 0), 0.0f, 0.8f);
        dmg_beam(b, v3(0, 0.6f * high, -0.48f * length), v3(0, 1.3f * high, -0.55f * length), 0.25f * wide,
                 0.2f * high);
        dmg_use(b, 0);
    }
    if (dmg_chance(b, 0.4f)) { /* what holds the rounds slides out of the grip */
        dmg_vec down = v3_normalize(v3(0, -grip, -0.15f * length));
        dmg_slide(b, 0, "magazine", down, 0.0f, 0.8f * grip);
        dmg_beam(b, v3(0, -0.1f * grip, -0.33f * length), v3(0, -1.03f * grip, -0.455f * length), 0.6f * wide,
                 0.14f * length);
        dmg_use(b, 0);
    }
}
