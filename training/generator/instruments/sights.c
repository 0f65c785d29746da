/* Draws instruments that measure angles by sight: theodolites on their foot screws, sextants and similar ones. */
#include "core/build.h"
#include "parts/hardware.h"

/* ---- theodolite ---- */

typedef struct station {
    float r;           /* of the alidade's plate */
    float half, trunn; /* half the room between the standards; height of the telescope's line over the plate */
    float barrel, fore, aft;
} station;

/* Draws three screws between two plates; the frame moves up to the upper plate's face. */
static void draw_tribrach(dmg_builder* b, float r) {
    float low = 0.12f * r, gap = r * dmg_range(b, 0.25f, 0.5f), knob = r * dmg_range(b, 0.16f, 0.28f);
    bool threaded = dmg_chance(b, 0.5f), round = dmg_chance(b, 0.5f);
    const dmg_xy triangle[] = {
        {1.1f * r, 0}, {-0.2f * r, 1.05f * r}, {-0.8f * r, 0.7f * r}, {-0.8f * r, -0.7f * r}, {-0.2f * r, -1.05f * r}};
    for (int plate = 0; plate < 2; ++plate) {
        float y = plate == 0 ? 0.0f : low + gap;
        dmg_save(b);
        dmg_move(b, 0, y, 0);
        dmg_turn(b, v3(1, 0, 0), -0.5f * DMG_PI); /* the outline lies flat */
        if (round)
            dmg_rod(b, v3(0, 0, 0), v3(0, 0, low), r);
        else
            dmg_extrude(b, triangle, 5, 0, low);
        dmg_restore(b);
    }
    for (int i = 0; i < 3; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 3);
        dmg_move(b, 0.72f * r, low, 0);
        if (threaded)
            dmg_screw(b, 0, "foot_screw", v3(0, 0, 0), v3(0, 1, 0), 0.01f * r, -6.0f, 6.0f);
        else
            dmg_spin(b, 0, "foot_screw", v3(0, 0, 0), v3(0, 1, 0));
        dmg_rod(b, v3(0, 0, 0), v3(0, gap, 0), 0.35f * knob);
        dmg_rod(b, v3(0, 0.25f * gap, 0), v3(0, 0.7f * gap, 0), knob);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 2 * low + gap, 0);
}

/* Legs that spread about pins below the head, their feet drawn out; the frame moves up to the head's face. */
static void draw_tripod(dmg_builder* b, float r) {
    float length = r * dmg_range(b, 6.0f, 12.0f), splay = dmg_range(b, 0.25f, 0.5f), t = 0.25f * r,
          high = length * cosf(splay);
    bool drawn = dmg_chance(b, 0.5f);
    dmg_move(b, 0, high, 0);
    dmg_rod(b, v3(0, -0.15f * r, 0), v3(0, 0.3f * r, 0), 1.1f * r);
    for (int i = 0; i < 3; ++i) {
        dmg_save(b);
        dmg_turn_to(b, v3(0, 1, 0), i, 3);
        dmg_move(b, r, -0.2f * r, 0);
        dmg_turn(b, v3(0, 0, 1), splay);
        uint32_t leg = dmg_hinge(b, 0, "leg", v3(0, 0, 0), v3(0, 0, -1), -0.3f, 0.8f * splay);
        dmg_box_span(b, v3(-0.5f * t, -0.6f * length, -t), v3(0.5f * t, 0.1f * t, t));
        if (drawn) dmg_slide(b, leg, "foot", v3(0, 1, 0), -0.1f * length, 0.2f * length);
        dmg_cone(b, v3(0, -length, 0), v3(0, -0.5f * length, 0), 0.12f * t, 0.45f * t);
        dmg_restore(b);
    }
    dmg_use(b, 0);
    dmg_move(b, 0, 0.3f * r, 0);
}

/* Draws what stands at both sides of the telescope and carries its pins. */
static void draw_standards(dmg_builder* b, const station* s, uint32_t alidade) {
    int kind = dmg_int(b, 0, 3), first = kind == 3 ? 1 : -1;
    float t = s->r * dmg_range(b, 0.12f, 0.35f), deep = s->r * dmg_range(b, 0.4f, 0.9f),
          top = s->trunn + 1.2f * s->barrel;
    dmg_use(b, alidade);
    for (int i = first; i <= 1; i += 2) {
        float x = (float)i * (s->half + 0.5f * t);
        if (kind == 0) /* an A of two legs */
            for (int k = -1; k <= 1; k += 2)
                dmg_beam(b, v3(x, 0, (float)k * 0.6f * deep), v3(x, s->trunn, 0), t, 0.3f * t + 0.1f * deep);
        if (kind == 1 || kind == 3) dmg_rounded_box(b, v3(x, 0.5f * top, 0), v3(t, top, 1.5f * deep), 0.2f * t);
        if (kind == 2) {
            const dmg_xy side[] = {{-deep, 0},
                                   {deep, 0},
                                   {0.6f * deep, 0.7f * top},
                                   {0.35f * deep, top},
                                   {-0.35f * deep, top},
                                   {-0.6f * deep, 0.7f * top}};
            dmg_save(b);
            dmg_turn(b, v3(0, 1, 0), -0.5f * DMG_PI);
            dmg_extrude(b, side, 6, -x - 0.5f * t, -x + 0.5f * t);
            dmg_restore(b);
        }
        if (kind == 0) dmg_rod(b, v3(x - 0.6f * t, s->trunn, 0), v3(x + 0.6f * t, s->trunn, 0), 0.8f * s->barrel);
    }
    bool over = dmg_chance(b, 0.4f) && kind != 3; /* a handle over the yoke, clear of the turning tube */
    float high = fmaxf(top, s->trunn + 1.1f * fmaxf(s->fore, s->aft)) + 0.3f * s->r;
    if (!over) return;
    if (dmg_chance(b, 0.4f)) dmg_hinge(b, alidade, "handle", v3(0, top, 0), v3(1, 0, 0), -0.2f, 1.5f);
    const dmg_vec path[] = {{-s->half - 0.5f * t, 0.9f * top, 0},
                            {-s->half - 0.5f * t, high, 0},
                            {s->half + 0.5f * t, high, 0},
                            {s->half + 0.5f * t, 0.9f * top, 0}};
    dmg_sweep(b, path, 4, 0.12f * s->r, 0.08f * s->r, false);
    dmg_use(b, alidade);
}

/* Draws the telescope on its pins, its objective towards +Z: rings that turn, an eyepiece that draws out, the circle.
 */
static void draw_telescope(dmg_builder* b, const station* s, uint32_t alidade) {
    bool plunges = 1.05f * s->fore < s->trunn && s->aft < 0.9f * s->trunn;
    float tip = asinf(fminf(0.95f, 0.8f * s->trunn / fmaxf(s->fore, s->aft))), r = s->barrel;
    dmg_save(b);
    dmg_move(b, 0, s->trunn, 0);
    uint32_t tube = plunges ? dmg_spin(b, alidade, "telescope", v3(0, 0, 0), v3(1, 0, 0))
                            : dmg_hinge(b, alidade, "telescope", v3(0, 0, 0), v3(-1, 0, 0), -tip, tip);
    int kind = dmg_int(b, 0, 2);
    if (kind == 0) dmg_cone(b, v3(0, 0, -0.7f * s->aft), v3(0, 0, s->fore), 0.7f * r, r);
    if (kind == 1) {
        dmg_rod(b, v3(0, 0, -0.7f * s->aft), v3(0, 0, 0.8f * s->fore), 0.75f * r);
        dmg_rod(b, v3(0, 0, 0.7f * s->fore), v3(0, 0, s->fore), r);
    }
    if (kind == 2) { /* a block with the optics inside */
        dmg_rounded_box(b, v3(0, 0, 0), v3(1.6f * s->half, 2.2f * r, 0.9f * (s->fore + 0.4f * s->aft)), 0.3f * r);
        dmg_rod(b, v3(0, 0, -0.7f * s->aft), v3(0, 0, s->fore), 0.8f * r);
    }
    dmg_rod(b, v3(-1.1f * s->half, 0, 0), v3(1.1f * s->half, 0, 0), 0.45f * r);
    if (dmg_chance(b, 0.5f)) { /* the vertical circle */
        float x = 0.75f * s->half * dmg_sign(b), disc = fminf(0.85f * s->trunn, r * dmg_range(b, 1.5f, 3.5f));
        dmg_rod(b, v3(x - 0.08f * r, 0, 0), v3(x + 0.08f * r, 0, 0), disc);
    }
    if (dmg_chance(b, 0.4f)) dmg_rod(b, v3(0, 1.3f * r, -0.5f * s->aft), v3(0, 1.3f * r, 0.5f * s->fore), 0.25f * r);
    if (dmg_chance(b, 0.5f)) {
        dmg_spin(b, tube, "focus_ring", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, -0.65f * s->aft), v3(0, 0, -0.4f * s->aft), r);
    }
    float end = -s->aft;
    int eye = dmg_int(b, 0, 2);
    dmg_use(b, tube);
    if (eye == 0) dmg_slide(b, tube, "eyepiece", v3(0, 0, -1), -0.1f * s->aft, 0.1f * s->aft);
    if (eye == 1) dmg_screw(b, tube, "eyepiece", v3(0, 0, 0), v3(0, 0, -1), 0.03f * r, -3.0f, 6.0f);
    dmg_rod(b, v3(0, 0, end), v3(0, 0, -0.6f * s->aft), 0.5f * r);
    dmg_cone(b, v3(0, 0, end), v3(0, 0, 0.9f * end), 0.75f * r, 0.55f * r);
    dmg_restore(b);
    dmg_use(b, alidade);
}

/* Clamps and tangent screws on the alidade: shafts that lie flat, round the plate or across a standard. */
static void draw_tangents(dmg_builder* b, const station* s, uint32_t alidade) {
    int count = dmg_int(b, 0, 3);
    for (int i = 0; i < count; ++i) {
        float knob = s->r * dmg_range(b, 0.08f, 0.18f), out = s->r * dmg_range(b, 0.2f, 0.5f);
        dmg_save(b);
        dmg_turn(b, v3(0, 1, 0), dmg_range(b, 0, 2.0f * DMG_PI));
        dmg_move(b, 0, -0.1f * s->r, s->r);
        if (dmg_chance(b, 0.5f)) { /* along the rim, held by a lug */
            dmg_box(b, v3(0, 0, 0.5f * knob), v3(knob, 0.18f * s->r, 2.5f * knob));
            dmg_turn(b, v3(0, 1, 0), 0.5f * DMG_PI);
            dmg_move(b, -knob, 0, 0);
        }
        dmg_spin(b, alidade, "tangent_screw", v3(0, 0, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, 0, -0.3f * out), v3(0, 0, out), 0.4f * knob);
        dmg_rod(b, v3(0, 0, 0.6f * out), v3(0, 0, out + knob), knob);
        dmg_restore(b);
        dmg_use(b, alidade);
    }
}

void dmg_build_theodolite(dmg_builder* b) {
    station s = {.r = dmg_scale_range(b, 0.04f, 0.15f)};
    s.half = s.r * dmg_range(b, 0.35f, 0.75f);
    s.barrel = s.half * dmg_range(b, 0.4f, 0.75f);
    s.trunn = s.r * dmg_range(b, 0.9f, 2.2f);
    s.fore = s.r * dmg_range(b, 0.7f, 2.2f);
    s.aft = s.fore * dmg_range(b, 0.7f, 1.2f);
    if (dmg_chance(b, 0.25f)) draw_tripod(b, s.r);
    if (dmg_chance(b, 0.75f))
        draw_tribrach(b, s.r);
    else
        dmg_rod(b, v3(0, 0, 0), v3(0, 0.2f * s.r, 0), 0.7f * s.r);
    float plate = s.r * dmg_range(b, 0.15f, 0.4f);
    dmg_rod(b, v3(0, 0, 0), v3(0, 0.5f * plate, 0), s.r * dmg_range(b, 0.5f, 1.1f)); /* the fixed circle */
    dmg_move(b, 0, 0.5f * plate, 0);
    dmg_turn(b, v3(0, 1, 0), dmg_range(b, 0, 2.0f * DMG_PI));
    uint32_t alidade = dmg_spin(b, 0, "alidade", v3(0, 0, 0), v3(0, 1, 0));
    if (dmg_chance(b, 0.6f))
        dmg_rod(b, v3(0, 0, 0), v3(0, plate, 0), s.r);
    else
        dmg_rounded_box(b, v3(0, 0.5f * plate, 0), v3(2 * s.half + 0.8f * s.r, plate, 1.5f * s.r), 0.2f * plate);
    dmg_move(b, 0, plate, 0);
    draw_standards(b, &s, alidade);
    draw_telescope(b, &s, alidade);
    draw_tangents(b, &s, alidade);
    dmg_use(b, 0);
}

/* ---- sextant ---- */

/* The frame stands in the plane z = 0, apex at the origin, limb below between -half and half from straight down. */
typedef struct sextant {
    float radius, half, t;
} sextant;

static dmg_xy on_limb(float radius, float angle) {
    return (dmg_xy){radius * sinf(angle), -radius * cosf(angle)};
}

static void draw_frame(dmg_builder* b, const sextant* s) {
    enum { STEPS = 10 };
    float r = s->radius, wide = r * dmg_range(b, 0.06f, 0.16f);
    dmg_xy outer[2 * STEPS];
    for (int i = 0; i < STEPS; ++i) {
        float angle = s->half * (2.0f * (float)i / (STEPS - 1) - 1.0f);
        outer[i] = on_limb(r, angle);
        outer[2 * STEPS - 1 - i] = on_limb(r - wide, angle);
    }
    int kind = dmg_int(b, 0, 2);
    if (kind == 2) { /* a plate cut as a sector */
        outer[STEPS] = (dmg_xy){0.12f * r, 0.1f * r};
        outer[STEPS + 1] = (dmg_xy){-0.12f * r, 0.1f * r};
        dmg_extrude(b, outer, STEPS + 2, -0.5f * s->t, 0.5f * s->t);
        return;
    }
    dmg_extrude(b, outer, 2 * STEPS, -0.5f * s->t, 0.5f * s->t);
    float bar = kind == 0 ? 0.6f * wide : 0.4f * wide;
    for (int i = -1; i <= 1; i += 2) {
        dmg_xy end = on_limb(r - 0.5f * wide, (float)i * 0.95f * s->half);
        dmg_beam(b, v3(0, 0, 0), v3(end.x, end.y, 0), kind == 0 ? s->t : 0.8f * s->t, bar);
    }
    dmg_rod(b, v3(0, 0, -0.5f * s->t), v3(0, 0, 0.5f * s->t), 0.12f * r);
    float at = dmg_range(b, 0.35f, 0.65f) * r;
    dmg_xy left = on_limb(at, -0.92f * s->half), right = on_limb(at, 0.92f * s->half);
    dmg_beam(b, v3(left.x, left.y, 0), v3(right.x, right.y, 0), 0.8f * s->t, bar);
    if (kind == 1) { /* a bridge of rings */
        dmg_xy low = on_limb(0.72f * r, 0);
        dmg_torus(b, v3(low.x, low.y, 0), v3(0, 0, 1), 0.16f * r, 0.35f * s->t);
    }
}

/* Draws the arm from the apex down to the limb, before the frame; a drum, a clamp or a lens on its end. */
static void draw_index_arm(dmg_builder* b, const sextant* s) {
    float r = s->radius, z = 0.55f * s->t, thin = 0.5f * s->t, wide = r * dmg_range(b, 0.05f, 0.1f),
          reach = r * dmg_range(b, 1.0f, 1.12f), play = 0.85f * s->half;
    uint32_t arm = dmg_hinge(b, 0, "index_arm", v3(0, 0, 0), v3(0, 0, 1), -play, play);
    dmg_rod(b, v3(0, 0, z), v3(0, 0, z + thin), 1.3f * wide);
    const dmg_xy outline[] = {{-0.5f * wide, 0},     {-0.8f * wide, -0.85f * r}, {-1.4f * wide, -reach},
                              {1.4f * wide, -reach}, {0.8f * wide, -0.85f * r},  {0.5f * wide, 0}};
    dmg_extrude(b, outline, 6, z, z + thin);
    float mirror = r * dmg_range(b, 0.08f, 0.14f), turn = dmg_range(b, -0.6f, 0.6f);
    dmg_save(b); /* the index glass over the pin */
    dmg_turn(b, v3(0, 0, 1), turn);
    dmg_box(b, v3(0, 0, z + thin + 0.5f * mirror), v3(2 * mirror, 0.15f * mirror, 1.2f * mirror));
    dmg_restore(b);
    int end = dmg_int(b, 0, 2);
    if (end == 0) { /* the micrometer's drum, its shaft along the limb */
        float drum = r * dmg_range(b, 0.05f, 0.09f), y = -reach - 0.3f * drum, x = dmg_sign(b);
        dmg_box(b, v3(0, y, z), v3(2.2f * wide, drum, 1.2f * drum));
        dmg_spin(b, arm, "drum", v3(0, y, z), v3(1, 0, 0));
        dmg_rod(b, v3(x * wide, y, z), v3(x * 2.4f * wide, y, z), drum);
    }
    if (end == 1) { /* a clamp's screw over the limb */
        dmg_spin(b, arm, "clamp", v3(0, -0.93f * reach, 0), v3(0, 0, 1));
        dmg_rod(b, v3(0, -0.93f * reach, z + thin), v3(0, -0.93f * reach, z + 2 * thin), 0.4f * wide);
        dmg_rod(b, v3(0, -0.93f * reach, z + 2 * thin), v3(0, -0.93f * reach, z + 4 * thin), 0.9f * wide);
    }
    if (end == 2 || dmg_chance(b, 0.3f)) { /* the reading lens on an arm of its own */
        float y = -0.6f * r;
        dmg_hinge(b, arm, "magnifier", v3(0, y, 0), v3(0, 0, 1), -0.6f, 0.6f);
        dmg_rod(b, v3(0, y, z + thin), v3(0, y, z + 2.5f * thin), 0.5f * wide);
        dmg_beam(b, v3(0, y, z + 2 * thin), v3(0, -0.85f * r, z + 2.5f * thin), 0.3f * wide, 0.5f * thin);
        dmg_torus(b, v3(0, -0.9f * r, z + 2.5f * thin), v3(0, 0, 1), 0.05f * r, 0.012f * r);
    }
    dmg_use(b, 0);
}

/* Coloured glasses, a fan of plates side by side on one pin along the line of sight, some swung aside. */
static void draw_shades(dmg_builder* b, const sextant* s, dmg_vec at, dmg_vec sight) {
    int count = dmg_int(b, 1, 4), round = dmg_int(b, 0, 1);
    float size = s->radius * dmg_range(b, 0.05f, 0.08f), t = 0.2f * size, gap = 1.6f * t;
    bool swung = dmg_chance(b, 0.5f);
    dmg_vec pin = v3_mad(at, v3(0, 0, 1), -0.3f * s->t), across = v3_normalize(v3_cross(v3(0, 0, 1), sight));
    dmg_vec first = v3_mad(pin, sight, -0.5f * gap * (float)count),
            last = v3_mad(pin, sight, 0.5f * gap * (float)count);
    dmg_rod(b, first, last, 0.25f * size);
    for (int i = 0; i < count; ++i) {
        dmg_vec here = v3_mad(first, sight, gap * ((float)i + 0.5f));
        dmg_vec glass = v3_mad(here, v3(0, 0, 1), 1.3f * size + 0.5f * s->t), thick = v3_scale(sight, 0.5f * t);
        uint32_t shade = dmg_hinge(b, 0, "shade", here, sight, -1.7f, 0.0f);
        dmg_rod(b, v3_sub(here, thick), v3_add(here, thick), 0.4f * size);
        dmg_beam(b, here, v3_mad(glass, v3(0, 0, 1), -0.8f * size), 0.4f * size, t);
        if (round)
            dmg_rod(b, v3_sub(glass, thick), v3_add(glass, thick), size);
        else
            dmg_beam(b, v3_mad(glass, across, -size), v3_mad(glass, across, size), t, 1.9f * size);
        if (swung && dmg_chance(b, 0.5f)) dmg_rest(b, shade, dmg_range(b, -1.6f, 0.0f));
        dmg_use(b, 0);
    }
}

/* Draws the telescope in its collar on one radius, the half silvered glass on the other: the line of sight between. */
static void draw_optics(dmg_builder* b, const sextant* s) {
    float r = s->radius, height = r * dmg_range(b, 0.08f, 0.14f), tube = r * dmg_range(b, 0.035f, 0.07f),
          length = r * dmg_range(b, 0.25f, 0.6f), side = dmg_sign(b);
    dmg_xy near_end = on_limb(0.45f * r, side * s->half), far_end = on_limb(0.5f * r, -side * s->half);
    dmg_vec eye = {near_end.x, near_end.y, 0}, glass = {far_end.x, far_end.y, 0},
            line = v3_normalize(v3_sub(glass, eye));
    dmg_vec up = {0, 0, 0.5f * s->t + height}, centre = v3_add(eye, up);
    dmg_box(b, v3_mad(eye, v3(0, 0, 1), 0.5f * height), v3(tube, tube, height + s->t));
    const dmg_xy collar[] = {{1.05f * tube, -0.6f * tube},
                             {1.5f * tube, -0.6f * tube},
                             {1.5f * tube, 0.6f * tube},
                             {1.05f * tube, 0.6f * tube},
                             {1.05f * tube, -0.6f * tube}};
    dmg_lathe(b, centre, line, collar, 5);
    int way = dmg_int(b, 0, 3);
    if (way == 0) dmg_slide(b, 0, "telescope", line, -0.2f * length, 0.2f * length);
    if (way == 1) dmg_spin(b, 0, "telescope", centre, line);
    uint32_t tube_part = b->part;
    dmg_cone(b, v3_mad(centre, line, -0.6f * length), v3_mad(centre, line, 0.4f * length), 0.8f * tube, tube);
    if (way == 3) dmg_slide(b, tube_part, "eyepiece", v3_scale(line, -1), 0.0f, 0.2f * length);
    dmg_rod(b, v3_mad(centre, line, -0.8f * length), v3_mad(centre, line, -0.5f * length), 0.7f * tube);
    dmg_use(b, 0);
    dmg_save(b);
    dmg_move(b, glass.x, glass.y, 0.5f * s->t);
    dmg_turn(b, v3(0, 0, 1), atan2f(line.y, line.x) + 0.5f * side);
    dmg_box(b, v3(0, 0, 0.6f * height), v3(0.12f * height, 1.2f * height, 1.2f * height));
    dmg_restore(b);
    draw_shades(b, s, v3_mad(glass, line, 0.12f * r), line);
    if (dmg_chance(b, 0.5f)) draw_shades(b, s, v3_scale(glass, 0.55f), v3_normalize(glass));
}

/* A sextant or octant, its frame upright or laid on its feet; the arm's line is at the far end of what it sweeps. */
void dmg_build_sextant(dmg_builder* b) {
    sextant s = {.radius = dmg_scale_range(b, 0.08f, 0.4f), .half = dmg_range(b, 0.45f, 0.8f)};
    float r = s.radius;
    s.t = r * dmg_range(b, 0.04f, 0.09f);
    if (dmg_chance(b, 0.5f)) {
        dmg_move(b, 0, 1.2f * r, 0);
        if (dmg_chance(b, 0.5f)) dmg_turn(b, v3(0, 0, 1), dmg_range(b, -1.0f, 1.0f));
    } else {
        dmg_move(b, 0, 0.3f * r, 0);
        dmg_face_up(b);
        for (int i = -1; i <= 1; ++i) { /* its feet */
            dmg_xy foot = on_limb(i == 0 ? 0.0f : 0.9f * r, (float)i * 0.9f * s.half);
            dmg_rod(b, v3(foot.x, foot.y, -0.3f * r), v3(foot.x, foot.y, 0), 0.35f * s.t);
        }
    }
    draw_frame(b, &s);
    draw_index_arm(b, &s);
    draw_optics(b, &s);
    if (dmg_chance(b, 0.7f)) { /* the handle behind */
        const dmg_vec path[] = {{0.1f * r, -0.3f * r, 0},
                                {0.1f * r, -0.33f * r, -0.22f * r},
                                {0.1f * r, -0.67f * r, -0.22f * r},
                                {0.1f * r, -0.7f * r, 0}};
        dmg_sweep(b, path, 4, 0.05f * r, 0.04f * r, false);
    }
    dmg_use(b, 0);
}
